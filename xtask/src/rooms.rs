//! Guards the arrows inside a crate: files that name each other in a circle cannot be understood one at a time.
//!
//! A room is a file of a crate. An arrow runs from a file to each file whose items it names by a path that begins with
//! `crate`, `super` or `self`, in a `use` or anywhere else; a name that a file re-exports leads on to where it is
//! defined. A module and what lies inside it may name each other: they are one room seen from outside. What is compiled
//! for tests or documentation only is left out. Refuses to know types and macros: it reads tokens.

use crate::tokens::{is_mark, is_word};
use anyhow::{Context, Result};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::str::FromStr;

/// The path of a module inside its crate: empty for the root.
pub type Module = Vec<String>;

/// What one file names.
#[derive(Default)]
struct File {
    /// Paths that it names, each resolved to the crate's root.
    paths: Vec<Module>,
    /// Names that it passes on: `pub use` of something of this crate, by the name under which it is known here.
    exports: BTreeMap<String, Module>,
}

/// The files of one crate and the arrows between them.
pub struct Rooms {
    arrows: BTreeMap<Module, BTreeSet<Module>>,
}

impl Rooms {
    /// Reads the source files below `folder`, the crate's `src`.
    ///
    /// # Errors
    /// If a file cannot be read or is not Rust.
    pub fn read(folder: &Path) -> Result<Self> {
        let mut files = BTreeMap::new();
        let mut folders = vec![folder.to_path_buf()];
        while let Some(inner) = folders.pop() {
            for entry in inner.read_dir().with_context(|| format!("cannot read {}", inner.display()))? {
                let path = entry?.path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|extension| extension == "rs") {
                    let module = module_of(path.strip_prefix(folder)?);
                    let text = std::fs::read_to_string(&path)?;
                    let file = File::read(&module, &text)
                        .with_context(|| format!("{} is not Rust", path.display()))?;
                    files.insert(module, file);
                }
            }
        }
        Ok(Self::of(&files))
    }

    fn of(files: &BTreeMap<Module, File>) -> Self {
        let arrows = files
            .iter()
            .map(|(module, file)| {
                let ends = file.paths.iter().filter_map(|path| resolve(files, path));
                (
                    module.clone(),
                    ends.filter(|end| !is_inside(module, end) && !is_inside(end, module)).collect(),
                )
            })
            .collect();
        Self { arrows }
    }

    /// Returns how many arrows there are.
    pub fn arrow_count(&self) -> usize {
        self.arrows.values().map(BTreeSet::len).sum()
    }

    /// Returns every circle: files of which each can be reached from each, sorted.
    pub fn circles(&self) -> Vec<Vec<String>> {
        let reach: BTreeMap<&Module, BTreeSet<&Module>> =
            self.arrows.keys().map(|module| (module, self.reachable(module))).collect();
        let mut circles = BTreeSet::new();
        for (module, ends) in &reach {
            if ends.contains(module) {
                let members =
                    ends.iter().filter(|end| reach.get(*end).is_some_and(|back| back.contains(module)));
                circles.insert(members.map(|member| member.join("::")).collect::<Vec<_>>());
            }
        }
        circles.into_iter().collect()
    }

    fn reachable<'a>(&'a self, from: &'a Module) -> BTreeSet<&'a Module> {
        let mut found = BTreeSet::new();
        let mut open = vec![from];
        while let Some(module) = open.pop() {
            for end in self.arrows.get(module).into_iter().flatten() {
                if found.insert(end) {
                    open.push(end);
                }
            }
        }
        found
    }
}

/// Returns the module of a file: `can/mod.rs` and `can.rs` are `can`, `lib.rs` and `main.rs` the root.
fn module_of(file: &Path) -> Module {
    let mut module: Module =
        file.with_extension("").iter().map(|part| part.to_string_lossy().into_owned()).collect();
    let is_root = module.len() == 1 && ["lib", "main"].contains(&module[0].as_str());
    if is_root || module.last().is_some_and(|last| last == "mod") {
        module.pop();
    }
    module
}

/// Returns whether `inner` is `outer` or lies inside it.
fn is_inside(inner: &Module, outer: &Module) -> bool {
    inner.starts_with(outer)
}

/// Returns the file that a path leads to, through whatever passes the name on.
fn resolve(files: &BTreeMap<Module, File>, path: &[String]) -> Option<Module> {
    let mut path = path.to_vec();
    // A chain of re-exports is as long as there are files, at most.
    for _ in 0..files.len() {
        let length = (0..=path.len()).rev().find(|&length| files.contains_key(&path[..length]))?;
        let (module, rest) = path.split_at(length);
        let next = rest.first().and_then(|name| files.get(module)?.exports.get(name));
        match next {
            Some(next) => path = next.iter().chain(&rest[1..]).cloned().collect(),
            None => return Some(module.to_vec()),
        }
    }
    None
}

impl File {
    fn read(module: &Module, text: &str) -> Result<Self> {
        let tokens = TokenStream::from_str(text).map_err(|error| anyhow::anyhow!("{error}"))?;
        let mut file = Self::default();
        file.scan(module, &tokens.into_iter().collect::<Vec<_>>());
        Ok(file)
    }

    /// Takes the paths out of the tokens of a file or a block.
    fn scan(&mut self, module: &Module, tokens: &[TokenTree]) {
        let mut place = 0;
        while place < tokens.len() {
            if let Some(behind) = left_out(&tokens[place..]) {
                place += behind;
                continue;
            }
            if is_word(tokens.get(place), "use") {
                let is_export =
                    place > 0 && (is_word(tokens.get(place - 1), "pub") || is_visibility(tokens, place));
                let end =
                    (place..tokens.len()).find(|&at| is_mark(tokens.get(at), ';')).unwrap_or(tokens.len());
                self.import(module, &tokens[place + 1..end], is_export);
                place = end;
            } else if let Some((path, length)) = path_at(module, &tokens[place..]) {
                self.paths.push(path);
                place += length;
            } else {
                if let TokenTree::Group(group) = &tokens[place] {
                    self.scan(module, &group.stream().into_iter().collect::<Vec<_>>());
                }
                place += 1;
            }
        }
    }

    /// Takes a `use`.
    fn import(&mut self, module: &Module, tree: &[TokenTree], is_export: bool) {
        for (path, name) in leaves(&[], tree) {
            let Some(path) = absolute(module, &path) else { continue };
            if is_export {
                self.exports.insert(name, path.clone());
            }
            self.paths.push(path);
        }
    }
}

/// Returns every path of a `use` tree with the name under which it is known.
fn leaves(before: &[String], tree: &[TokenTree]) -> Vec<(Module, String)> {
    let mut path = before.to_vec();
    let mut name = None;
    let mut place = 0;
    while place < tree.len() {
        match &tree[place] {
            TokenTree::Ident(word) if word == "as" => {
                name = tree.get(place + 1).map(ToString::to_string);
                place += 1;
            }
            TokenTree::Ident(word) if word == "self" && !path.is_empty() => {}
            TokenTree::Ident(word) => path.push(word.to_string()),
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                return inner
                    .split(|token| is_mark(Some(token), ','))
                    .filter(|branch| !branch.is_empty())
                    .flat_map(|branch| leaves(&path, branch))
                    .collect();
            }
            _ => {}
        }
        place += 1;
    }
    let name = name.or_else(|| path.last().cloned()).unwrap_or_default();
    vec![(path, name)]
}

/// Returns the path that begins here with `crate`, `super` or `self`, from the crate's root, and its length in tokens.
fn path_at(module: &Module, tokens: &[TokenTree]) -> Option<(Module, usize)> {
    if !["crate", "super", "self"].iter().any(|word| is_word(tokens.first(), word)) {
        return None;
    }
    let mut path = Vec::new();
    let mut place = 0;
    while let Some(TokenTree::Ident(word)) = tokens.get(place) {
        path.push(word.to_string());
        if !(is_mark(tokens.get(place + 1), ':') && is_mark(tokens.get(place + 2), ':')) {
            place += 1;
            break;
        }
        place += 3;
    }
    // `self` alone is a value.
    (path.len() > 1).then(|| absolute(module, &path)).flatten().map(|path| (path, place))
}

/// Returns a path from the crate's root; `None` for one of another crate.
fn absolute(module: &Module, path: &[String]) -> Option<Module> {
    let mut base = match path.first()?.as_str() {
        "crate" => Vec::new(),
        "self" | "super" => module.clone(),
        // A path of an inner module, or of another crate: then no file is found behind this one.
        _ => return Some(module.iter().chain(path).cloned().collect()),
    };
    let mut rest = path;
    while let Some((word, behind)) = rest.split_first() {
        match word.as_str() {
            "crate" | "self" => {}
            "super" => {
                base.pop()?;
            }
            _ => break,
        }
        rest = behind;
    }
    base.extend(rest.iter().cloned());
    Some(base)
}

/// Returns how many tokens an item takes, attribute included, that is compiled for tests or documentation only.
fn left_out(tokens: &[TokenTree]) -> Option<usize> {
    let TokenTree::Group(attribute) = tokens.get(1)? else { return None };
    let condition: String = attribute.stream().to_string().split_whitespace().collect();
    if !is_mark(tokens.first(), '#') || !["cfg(test)", "cfg(doc)"].contains(&condition.as_str()) {
        return None;
    }
    // Up to the body of the item, or its end.
    let end = tokens.iter().position(|token| {
        is_mark(Some(token), ';')
            || matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace)
    });
    end.map(|end| end + 1)
}

/// Returns whether `pub(...)` stands before `use`.
fn is_visibility(tokens: &[TokenTree], place: usize) -> bool {
    place >= 2
        && is_word(tokens.get(place - 2), "pub")
        && matches!(tokens.get(place - 1), Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rooms(files: &[(&str, &str)]) -> Rooms {
        let files = files.iter().map(|(path, text)| {
            let module = module_of(Path::new(path));
            let file = File::read(&module, text).unwrap();
            (module, file)
        });
        Rooms::of(&files.collect())
    }

    #[test]
    fn two_files_that_name_each_other_are_a_circle() {
        let rooms = rooms(&[
            ("lib.rs", "mod a; mod b; mod c;"),
            ("a.rs", "use crate::b::B;"),
            ("b.rs", "fn f() { super::a::g(); }"),
            ("c.rs", "use super::{a, b};"),
        ]);
        assert_eq!(rooms.circles(), [["a", "b"]]);
        assert_eq!(rooms.arrow_count(), 4);
    }

    #[test]
    fn a_circle_may_run_through_names_that_are_passed_on() {
        let rooms = rooms(&[
            ("lib.rs", "mod a; mod b; pub use a::A; pub(crate) use crate::b::Long as B;"),
            ("a.rs", "use crate::B;"),
            ("b.rs", "use crate::A;"),
        ]);
        assert_eq!(rooms.circles(), [["a", "b"]]);
    }

    #[test]
    fn a_circle_may_run_through_a_macro_and_over_three_files() {
        let rooms = rooms(&[
            ("lib.rs", "mod a; mod b; mod c;"),
            ("a.rs", "rows! { x: crate::b::X }"),
            ("b.rs", "use crate::c::{self, Y as Z};"),
            ("c.rs", "const A: u8 = crate::a::A;"),
        ]);
        assert_eq!(rooms.circles(), [["a", "b", "c"]]);
    }

    #[test]
    fn a_module_and_its_inner_ones_are_one_room_and_tests_are_no_arrow() {
        let rooms = rooms(&[
            ("lib.rs", "mod a; mod b;"),
            ("a/mod.rs", "mod inner; use inner::X; pub struct A;"),
            ("a/inner.rs", "use super::A; use crate::b::B;"),
            ("b.rs", "#[cfg(test)] mod tests { use crate::a::A; } #[cfg(doc)] use crate::a::A;"),
        ]);
        assert_eq!(rooms.circles(), Vec::<Vec<String>>::new());
        assert_eq!(rooms.arrow_count(), 1);
    }

    #[test]
    fn neighbours_inside_a_room_can_be_a_circle_too() {
        let rooms = rooms(&[
            ("main.rs", "mod a;"),
            ("a/mod.rs", "mod one; mod two;"),
            ("a/one.rs", "use super::two::T;"),
            ("a/two.rs", "use crate::a::one;"),
        ]);
        assert_eq!(rooms.circles(), [["a::one", "a::two"]]);
    }
}
