//! The firmware's tasks, as their attributes say.
//!
//! Reads `#[rtic::app]` and what is in it as tokens; RTIC checks the same attributes when the firmware is compiled.
//! Refuses to guess: what wakes a task is the interrupt that it binds, the period in its own file, the signals among
//! its locals, or whoever spawns it.

use crate::tokens::{is_mark, is_word};
use anyhow::{Context, Result, anyhow, bail};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use std::collections::BTreeMap;
use std::path::Path;
use std::str::FromStr;

/// The constant of a task's file that says how often it runs.
const PERIOD: &str = "PERIOD_MS";
/// The type of a local on which a task waits.
const SIGNAL: &str = "SignalReader";

/// What kind of task it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Runs once, interrupts masked.
    Init,
    /// Runs in an interrupt that it binds, or in a dispatcher.
    Task,
    /// Runs when nothing else does.
    Idle,
}

/// One task.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Task {
    /// Name of its function.
    pub name: String,
    /// Whether it is init, idle, a hardware or a software task.
    pub kind: Kind,
    /// The interrupt that it binds; without one it runs in the dispatcher of its priority.
    pub binds: Option<String>,
    /// What wakes it.
    pub trigger: String,
    /// RTIC's priority, the greater the more urgent.
    pub priority: u8,
    /// Its local resources.
    pub locals: Vec<String>,
    /// Its shared resources; `&` = only read.
    pub shared: Vec<String>,
}

/// The application.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct App {
    /// Interrupts in which software tasks run.
    pub dispatchers: Vec<String>,
    /// Tasks in the order of the source.
    pub tasks: Vec<Task>,
}

impl App {
    /// Reads `main.rs` and the files of the tasks in `tasks/` beside it.
    ///
    /// # Errors
    /// If a file cannot be read, is not Rust, or holds an attribute that is not understood.
    pub fn read(main: &Path) -> Result<Self> {
        let text =
            std::fs::read_to_string(main).with_context(|| format!("cannot read {}", main.display()))?;
        let folder = main.with_file_name("tasks");
        let file = |name: &str| std::fs::read_to_string(folder.join(format!("{name}.rs"))).ok();
        Self::parse(&text, file).with_context(|| format!("the tasks of {}", main.display()))
    }

    /// Takes the tasks out of the text of `main.rs`; `file` gives the text of a task's own file.
    pub fn parse(text: &str, file: impl Fn(&str) -> Option<String>) -> Result<Self> {
        let tokens = tokens_of(text)?;
        let (app, body) = application(&tokens).context("there is no `#[rtic::app(...)] mod`")?;
        let dispatchers = names(app.get("dispatchers").map_or(&[], Vec::as_slice));
        let body: Vec<TokenTree> = body.stream().into_iter().collect();
        let mut tasks = Vec::new();
        collect(&body, &mut tasks)?;
        if tasks.is_empty() {
            bail!("there is no `#[task]`");
        }
        let signals = signals(&body);
        for task in &mut tasks {
            task.trigger = trigger(task, &signals, &file)?;
        }
        Ok(Self { dispatchers, tasks })
    }
}

fn tokens_of(text: &str) -> Result<Vec<TokenTree>> {
    let stream = TokenStream::from_str(text).map_err(|error| anyhow!("this is not Rust: {error}"))?;
    Ok(stream.into_iter().collect())
}

/// The arguments of an attribute by name: the tokens behind `=`.
type Arguments = BTreeMap<String, Vec<TokenTree>>;

/// Returns the arguments of `#[rtic::app(...)]` and the module behind it.
fn application(tokens: &[TokenTree]) -> Option<(Arguments, &Group)> {
    let place = (0..tokens.len()).find(|&place| attribute(&tokens[place..], "app").is_some())?;
    let arguments = attribute(&tokens[place..], "app")?;
    let body = tokens[place..].iter().find_map(|token| braced(Some(token)));
    body.map(|body| (arguments, body))
}

/// Returns the arguments of the attribute that begins here if its path ends in `name`.
fn attribute(tokens: &[TokenTree], name: &str) -> Option<Arguments> {
    let TokenTree::Group(group) = tokens.get(1)? else { return None };
    if !is_mark(tokens.first(), '#') || group.delimiter() != Delimiter::Bracket {
        return None;
    }
    let inner: Vec<TokenTree> = group.stream().into_iter().collect();
    let path =
        inner.iter().take_while(|token| matches!(token, TokenTree::Ident(_)) || is_mark(Some(token), ':'));
    if !is_word(path.last(), name) {
        return None;
    }
    let arguments = match inner.last() {
        Some(TokenTree::Group(arguments)) => arguments.stream().into_iter().collect(),
        _ => Vec::new(),
    };
    let named = split(&arguments).into_iter().filter_map(|argument| {
        let TokenTree::Ident(name) = argument.first()? else { return None };
        is_mark(argument.get(1), '=').then(|| (name.to_string(), argument[2..].to_vec()))
    });
    Some(named.collect())
}

/// Adds the functions with an attribute of RTIC, those of an `extern` block too.
fn collect(tokens: &[TokenTree], tasks: &mut Vec<Task>) -> Result<()> {
    let kinds = [("init", Kind::Init), ("task", Kind::Task), ("idle", Kind::Idle)];
    for (place, token) in tokens.iter().enumerate() {
        if let Some(block) = braced(Some(token)) {
            let is_extern = place >= 2 && is_word(tokens.get(place - 2), "extern");
            if is_extern {
                collect(&block.stream().into_iter().collect::<Vec<_>>(), tasks)?;
            }
            continue;
        }
        for (word, kind) in kinds {
            if let Some(arguments) = attribute(&tokens[place..], word) {
                tasks.push(task(kind, &arguments, &tokens[place..])?);
            }
        }
    }
    Ok(())
}

fn task(kind: Kind, arguments: &Arguments, tokens: &[TokenTree]) -> Result<Task> {
    let name = tokens.iter().position(|token| is_word(Some(token), "fn")).and_then(|at| tokens.get(at + 1));
    let name = name.context("an attribute of RTIC without a function")?.to_string();
    let list = |key: &str| names(arguments.get(key).map_or(&[], Vec::as_slice));
    // RTIC gives a task the lowest priority unless it says another.
    let priority = match arguments.get("priority").and_then(|tokens| tokens.first()) {
        Some(number) => {
            let number = number.to_string();
            number.parse().with_context(|| format!("`{name}` has a priority that is no number: {number}"))?
        }
        None => u8::from(kind == Kind::Task),
    };
    Ok(Task {
        kind,
        binds: arguments.get("binds").and_then(|tokens| tokens.first()).map(ToString::to_string),
        trigger: String::new(),
        priority,
        locals: list("local"),
        shared: list("shared"),
        name,
    })
}

/// Returns the names of a list in brackets: `[a, &b, c: T = value]`.
fn names(tokens: &[TokenTree]) -> Vec<String> {
    let Some(TokenTree::Group(list)) = tokens.first() else { return Vec::new() };
    let list: Vec<TokenTree> = list.stream().into_iter().collect();
    split(&list).iter().filter_map(|entry| name(entry)).collect()
}

/// Returns the name at the beginning of an entry or a field, behind its attributes and `pub`.
fn name(entry: &[TokenTree]) -> Option<String> {
    match entry {
        [first, TokenTree::Group(_), rest @ ..] if is_mark(Some(first), '#') => name(rest),
        [first, TokenTree::Ident(word), ..] if is_mark(Some(first), '&') => Some(format!("&{word}")),
        [first, rest @ ..] if is_word(Some(first), "pub") => name(rest),
        [TokenTree::Ident(word), ..] => Some(word.to_string()),
        _ => None,
    }
}

/// Splits at the commas, but for those between angle brackets.
fn split(tokens: &[TokenTree]) -> Vec<&[TokenTree]> {
    let (mut parts, mut start, mut depth) = (Vec::new(), 0, 0_i32);
    for (place, token) in tokens.iter().enumerate() {
        let is_arrow = place > 0 && is_mark(tokens.get(place - 1), '-');
        match token {
            TokenTree::Punct(mark) if mark.as_char() == '<' => depth += 1,
            TokenTree::Punct(mark) if mark.as_char() == '>' && !is_arrow => depth -= 1,
            TokenTree::Punct(mark) if mark.as_char() == ',' && depth == 0 => {
                parts.push(&tokens[start..place]);
                start = place + 1;
            }
            _ => {}
        }
    }
    parts.push(&tokens[start..]);
    parts.retain(|part| !part.is_empty());
    parts
}

fn braced(token: Option<&TokenTree>) -> Option<&Group> {
    match token {
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => Some(group),
        _ => None,
    }
}

/// Returns the fields of `struct Local` that a task can wait on.
fn signals(body: &[TokenTree]) -> Vec<String> {
    let place =
        body.windows(2).position(|pair| is_word(pair.first(), "struct") && is_word(pair.get(1), "Local"));
    let fields = place.and_then(|place| braced(body.get(place + 2)));
    let Some(fields) = fields else { return Vec::new() };
    let fields: Vec<TokenTree> = fields.stream().into_iter().collect();
    let is_signal = |field: &&[TokenTree]| field.iter().any(|token| is_word(Some(token), SIGNAL));
    split(&fields).into_iter().filter(is_signal).filter_map(name).collect()
}

/// Returns what wakes a task.
fn trigger(task: &Task, signals: &[String], file: impl Fn(&str) -> Option<String>) -> Result<String> {
    let awaited: Vec<&str> =
        task.locals.iter().filter(|local| signals.contains(local)).map(String::as_str).collect();
    Ok(match (task.kind, &task.binds) {
        (Kind::Init, _) => "power-on".into(),
        (Kind::Idle, _) => "nothing else".into(),
        (Kind::Task, Some(interrupt)) => interrupt.clone(),
        (Kind::Task, None) => match file(&task.name).map(|text| period(&text)).transpose()?.flatten() {
            Some(period) => format!("every {period} ms"),
            None if awaited.is_empty() => "spawned".into(),
            None => awaited.join(", "),
        },
    })
}

/// Returns the value of `const PERIOD_MS`.
fn period(text: &str) -> Result<Option<String>> {
    let tokens = tokens_of(text)?;
    let at =
        tokens.windows(2).position(|pair| is_word(pair.first(), "const") && is_word(pair.get(1), PERIOD));
    let Some(at) = at else { return Ok(None) };
    let equals = tokens[at..].iter().position(|token| is_mark(Some(token), '='));
    Ok(equals.and_then(|equals| tokens.get(at + equals + 1)).map(ToString::to_string))
}

#[cfg(test)]
mod tests {
    use super::*;

    const MAIN: &str = r#"
        #[rtic::app(device = pico::pac, dispatchers = [SW0_IRQ, SW1_IRQ])]
        mod app {
            #[local]
            struct Local {
                /// What comes, one by one.
                views_out: SignalReader<'static, Map<u8, View>>,
                views_in: SignalWriter<'static, View>,
                wires: Wires,
            }
            #[init(local = [
                #[unsafe(link_section = ".uninit")]
                tile: Cell<[u16; 7], u8> = Cell::uninit(),
                queue: Queue = Queue::new(),
            ])]
            fn init(cx: init::Context) -> (Shared, Local) { let x = vec![idle; 3]; }
            #[task(binds = IO_IRQ_BANK0, priority = 4, local = [frames_in], shared = [can])]
            #[unsafe(link_section = ".data")]
            fn can_service(cx: can_service::Context) {}
            extern "Rust" {
                #[task(priority = 2, local = [wires, views_in], shared = [can, &boot])]
                async fn tick(cx: tick::Context);
                #[task(local = [views_out])]
                async fn draw(cx: draw::Context);
                #[task]
                async fn once(cx: once::Context);
                #[idle]
                fn idle(cx: idle::Context) -> !;
            }
        }
    "#;

    fn app(main: &str) -> Result<App> {
        let files =
            |name: &str| (name == "tick").then(|| "const X: u8 = 1; const PERIOD_MS: u64 = 10;".into());
        App::parse(main, files)
    }

    #[test]
    fn every_task_is_read_with_what_its_attribute_says() {
        let app = app(MAIN).unwrap();
        assert_eq!(app.dispatchers, ["SW0_IRQ", "SW1_IRQ"]);
        let rows: Vec<_> = app
            .tasks
            .iter()
            .map(|task| {
                (&*task.name, &*task.trigger, task.priority, task.locals.join(" "), task.shared.join(" "))
            })
            .collect();
        let none = String::new;
        let expected = [
            ("init", "power-on", 0, "tile queue".into(), none()),
            ("can_service", "IO_IRQ_BANK0", 4, "frames_in".into(), "can".into()),
            ("tick", "every 10 ms", 2, "wires views_in".into(), "can &boot".into()),
            ("draw", "views_out", 1, "views_out".into(), none()),
            ("once", "spawned", 1, none(), none()),
            ("idle", "nothing else", 0, none(), none()),
        ];
        assert_eq!(rows, expected);
        assert_eq!(app.tasks[1].binds.as_deref(), Some("IO_IRQ_BANK0"));
    }

    #[test]
    fn a_file_without_tasks_and_a_priority_without_a_number_are_errors() {
        let said = |main: &str| format!("{:#}", app(main).unwrap_err());
        assert!(said("mod app {}").contains("no `#[rtic::app(...)] mod`"));
        assert!(said("#[rtic::app(device = pac)] mod app {}").contains("no `#[task]`"));
        assert!(said(&MAIN.replace("priority = 2", "priority = HIGH")).contains("no number: HIGH"));
        assert!(said("mod app {").contains("not Rust"));
    }
}
