//! Draws the glyphs, icons and dial tables of the screens.
//!
//! Owns everything in `app/ui/src/fonts/` but `mod.rs`. The Chinese characters are those of the cluster's texts, of the
//! sources in `app/ui` and of the vehicles' files: add a text, run `cargo xtask fonts`, commit what changed. `--check`
//! writes nothing and fails if a file would change.
//! Not supported: fonts other than Noto Sans, right-to-left scripts, kerning.

mod dial;
mod faces;
mod icons;
mod shapes;

use anyhow::{Context, Result, bail};
use cluster::faults::ROWS;
use cluster::{FaultId, Telltale};
use std::{
    collections::BTreeSet,
    fmt::Write,
    fs,
    path::{Path, PathBuf},
};

/// Where the Debian font packages install to; `FONTS` in the environment overrides it.
const SYSTEM_FONTS: &str = "/usr/share/fonts";

/// Returns whether a character needs a Chinese font.
fn is_chinese(character: char) -> bool {
    matches!(character, '\u{2e80}'..='\u{9fff}' | '\u{f900}'..='\u{faff}' | '\u{ff00}'..='\u{ffef}' | '℃' | '≤')
}

/// Collects the Chinese characters of every file below `folder` whose name ends with `extension`.
fn collect(folder: &Path, extension: &str, found: &mut BTreeSet<char>) -> Result<()> {
    for entry in fs::read_dir(folder).with_context(|| format!("cannot list {}", folder.display()))? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, extension, found)?;
        } else if path.extension().is_some_and(|end| end == extension) {
            let text = fs::read_to_string(&path)?;
            // Comments are never shown, and must not change the glyphs.
            let code = text.lines().filter(|line| !line.trim_start().starts_with(['/', '#']));
            found.extend(code.flat_map(str::chars).filter(|&character| is_chinese(character)));
        }
    }
    Ok(())
}

/// Writes the icon table, in the order of the telltales.
fn icon_source(bits: &mut Vec<u8>) -> Result<String> {
    let mut source = format!(
        "/// Width and height of an icon.\npub(crate) const ICON_SIZE: u16 = {};\n\
         /// Icons in the order of the telltales; READY is empty.\n\
         pub(crate) static ICON_BITS: &[u8] = include_bytes!(\"icons.bin\");\n",
        icons::SIZE
    );
    let mut icons = icons::all();
    for (place, key) in Telltale::ALL.iter().map(|telltale| telltale.key()).enumerate() {
        let shapes = icons.remove(key).with_context(|| format!("no symbol is drawn for `{key}`"))?;
        writeln!(source, "// {place}: {key}").expect("writing to a string");
        faces::pack(&shapes::rasterise(&shapes, icons::SIZE, icons::SIZE), icons::SIZE, bits);
    }
    if let Some(key) = icons.keys().next() {
        bail!("no telltale has the symbol `{key}`");
    }
    Ok(source)
}

fn main() -> Result<()> {
    let check = std::env::args().any(|argument| argument == "--check");
    let root = surroundings::root();
    let target = root.join("app/ui/src/fonts");
    let fonts = PathBuf::from(std::env::var_os("FONTS").unwrap_or_else(|| SYSTEM_FONTS.into()));

    let mut labels = BTreeSet::new();
    labels.extend(fs::read_to_string(root.join("app/ui/src/words.rs"))?.chars().filter(|&c| is_chinese(c)));
    let chapters = cluster::page::Chapter::ALL;
    let items = chapters.iter().flat_map(|chapter| chapter.items());
    labels.extend(items.flat_map(|item| item.label.zh.chars()).filter(|&c| is_chinese(c)));
    let mut texts = BTreeSet::new();
    texts.extend(chapters.iter().flat_map(|chapter| chapter.title().zh.chars()).filter(|&c| is_chinese(c)));
    let items = chapters.iter().flat_map(|chapter| chapter.items());
    let states = items.filter_map(|item| item.value.unit().kind()).flat_map(|kind| kind.states);
    texts.extend(states.flat_map(|state| state.zh.chars()).filter(|&c| is_chinese(c)));
    let advice = FaultId::ALL.iter().filter_map(|fault| fault.advice());
    let said = ROWS.iter().flat_map(|row| row.words.texts()).copied().chain(advice);
    texts.extend(said.flat_map(|text| text.zh.chars()).filter(|&c| is_chinese(c)));
    collect(&root.join("app/ui"), "rs", &mut texts)?;
    collect(&root.join("vehicles"), "toml", &mut texts)?;

    let mut source = String::from(
        "//! Glyphs, icons and dial tables, drawn by `cargo xtask fonts`: change the generator, not this file.\n\n\
         use super::{DialRow, Font, Glyph, words};\n\n",
    );
    let mut files: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    for packed in faces::all(&fonts, &labels, &texts)? {
        source.push_str(&packed.source);
        source.push('\n');
        files.push((target.join(packed.file), packed.bits));
    }
    let mut icon_bits = Vec::new();
    source.push_str(&icon_source(&mut icon_bits)?);
    files.push((target.join("icons.bin"), icon_bits));
    let dial = dial::generate();
    source.push('\n');
    source.push_str(&dial.source);
    files.push((target.join("dial.bin"), dial.pixels));
    files.push((target.join("generated.rs"), source.into_bytes()));

    let mut changed = 0;
    for (path, bytes) in &files {
        if fs::read(path).ok().as_ref() != Some(bytes) {
            changed += 1;
            println!("{} {}", if check { "differs:" } else { "wrote" }, path.display());
            if !check {
                fs::write(path, bytes)?;
            }
        }
    }
    let bits: usize = files
        .iter()
        .filter(|(path, _)| path.extension().is_some_and(|end| end == "bin"))
        .map(|(_, bytes)| bytes.len())
        .sum();
    println!(
        "{} Chinese characters, {bits} bytes of bitmaps, {changed} of {} files changed",
        texts.len(),
        files.len()
    );
    if check && changed > 0 {
        bail!("the committed glyphs are not those of the sources: run `cargo xtask fonts`");
    }
    Ok(())
}
