//! The table as it stands in `main.rs`: rows from the attributes, bounds from what was measured.
//!
//! A bound is what was measured and a quarter, rounded up to two figures and marked with `<`: a change elsewhere moves
//! code in the flash cache, which is worth a tenth to a short task. What is compared is everything but the bounds, and
//! that nothing measured is above its bound. Times are a task's own: with what preempts it, they would be a matter of
//! which interrupts happened to meet.

use super::measure::{Measured, RUN};
use super::source::{App, Kind, Task};
use anyhow::{Context, Result, bail, ensure};
use bench::rp2040::Handler;
use bench::time::Nanos;
use std::fmt::Write;

/// Begins the table; whoever stands before it is told how to refresh it.
pub const BEGIN: &str = "//! <!-- tasks: cargo xtask tasks -->\n";
/// Ends it.
pub const END: &str = "//! <!-- /tasks -->\n";

/// Widest list in one line of a cell: of resources, of what wakes a task.
const LIST_WIDTH: usize = 20;
const TRIGGER_WIDTH: usize = 13;
/// Hardware priorities of the core: RTIC's 1 is the last of them.
const PRIORITIES: u32 = 4;

/// Something measured that has a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Figure {
    /// A span of virtual time.
    Time(Nanos),
    /// Bytes.
    Bytes(u64),
}

impl Figure {
    /// Returns the bound: a quarter more, rounded up to two figures.
    fn bound(self) -> Self {
        match self {
            Self::Time(time) => Self::Time(Nanos(round_up(time.0 + time.0 / 4, 100))),
            Self::Bytes(bytes) => Self::Bytes(round_up(bytes + bytes / 4, 1)),
        }
    }

    fn amount(self) -> u64 {
        match self {
            Self::Time(time) => time.0,
            Self::Bytes(bytes) => bytes,
        }
    }
}

impl std::fmt::Display for Figure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Time(Nanos(nanos)) if *nanos < 1_000_000 => write!(f, "{} us", *nanos as f64 / 1e3),
            Self::Time(Nanos(nanos)) => write!(f, "{} ms", *nanos as f64 / 1e6),
            Self::Bytes(bytes) => write!(f, "{bytes} bytes"),
        }
    }
}

/// Rounds up to two figures, at least to a multiple of `least`.
fn round_up(number: u64, least: u64) -> u64 {
    let mut step = least;
    while number.div_ceil(step) > 99 {
        step *= 10;
    }
    number.div_ceil(step) * step
}

/// Cells of a row.
type Row = [String; COLUMNS];
const COLUMNS: usize = 7;

/// The table and what stands behind its bounds, in their order: what it is of, and how much.
pub struct Table {
    text: String,
    figures: Vec<(String, Figure)>,
}

impl Table {
    /// Makes the table.
    ///
    /// # Errors
    /// If a task names an interrupt that the chip does not have, or no dispatcher runs at its priority.
    pub fn new(app: &App, measured: &Measured, stack: u64, compiler: &str) -> Result<Self> {
        let mut table = Self { text: String::new(), figures: Vec::new() };
        let mut rows: Vec<Row> =
            vec![["task", "trigger", "priority", "at start", "later", "locals", "shared"].map(str::to_owned)];
        let mut tasks: Vec<&Task> = app.tasks.iter().collect();
        tasks.sort_by_key(|task| (task.kind, std::cmp::Reverse(task.priority)));
        for task in &tasks {
            if task.kind == Kind::Idle {
                rows.extend(table.others(app, measured));
            }
            rows.extend(table.rows(app, task, measured)?);
        }
        table.lay_out(&rows);
        table.tell(app, measured, stack, compiler)?;
        Ok(table)
    }

    /// Writes a measured figure as its bound.
    fn bound(&mut self, of: String, figure: Figure) -> String {
        self.figures.push((of, figure));
        format!("< {}", figure.bound())
    }

    fn times(&mut self, of: &str, start: Handler, later: Handler) -> [String; 2] {
        [("at start", start.own), ("later", later.own)].map(|(column, time)| match time {
            Nanos::ZERO => "-".into(),
            time => self.bound(format!("{of}, {column}"), Figure::Time(time)),
        })
    }

    /// The lines of one task: a long list of resources takes more than one.
    fn rows(&mut self, app: &App, task: &Task, measured: &Measured) -> Result<Vec<Row>> {
        let name = format!("`{}`", task.name);
        let times = match (task.kind, interrupt(app, task, measured)?) {
            (_, Some(interrupt)) => {
                let seen = |watched: &bench::rp2040::Watched| {
                    watched.handler(interrupt).map(|(_, handler)| handler).unwrap_or_default()
                };
                let (start, later) = (seen(&measured.start), seen(&measured.later));
                ensure!(start.runs + later.runs > 0, "`{}`: {interrupt} did not come in the run", task.name);
                self.times(&name, start, later)
            }
            (Kind::Init, _) => {
                let first = measured.start.first.context("no interrupt came")?;
                [self.bound(name.clone(), Figure::Time(first)), String::new()]
            }
            _ => Default::default(),
        };
        let trigger = wrapped(&task.trigger, TRIGGER_WIDTH);
        let [locals, shared] =
            [&task.locals, &task.shared].map(|names| wrapped(&names.join(", "), LIST_WIDTH));
        let priority = if task.kind == Kind::Init { String::new() } else { task.priority.to_string() };
        let [start, later] = times.map(|time| vec![time]);
        let cells = [vec![name], trigger, vec![priority], start, later, locals, shared];
        let lines = cells.iter().map(Vec::len).max().unwrap_or_default();
        let line = |line: usize| cells.each_ref().map(|cell| cell.get(line).cloned().unwrap_or_default());
        Ok((0..lines).map(line).collect())
    }

    /// Interrupts that ran and are no task's: the HAL's and RTIC's own.
    fn others(&mut self, app: &App, measured: &Measured) -> Vec<Row> {
        let is_known = |name: &str| {
            app.dispatchers.iter().any(|known| known == name)
                || app.tasks.iter().any(|task| task.binds.as_deref() == Some(name))
        };
        let mut rows = Vec::new();
        for (irq, name) in interrupts(measured) {
            if !is_known(name) {
                let [start, later] =
                    [&measured.start, &measured.later].map(|seen| seen.handlers[irq as usize]);
                let [start, later] = self.times(name, start, later);
                let priority = (PRIORITIES - measured.priorities[irq as usize]).to_string();
                let empty = String::new;
                rows.push(["(no task)".into(), name.into(), priority, start, later, empty(), empty()]);
            }
        }
        rows
    }

    /// Writes the rows as Markdown in a module's documentation.
    fn lay_out(&mut self, rows: &[Row]) {
        let width = |column: usize| rows.iter().map(|row| row[column].len()).max().unwrap_or_default();
        let widths: [usize; COLUMNS] = std::array::from_fn(width);
        for (number, row) in rows.iter().enumerate() {
            let cells: Vec<String> =
                row.iter().zip(widths).map(|(cell, width)| format!(" {cell:width$} ")).collect();
            let _ = writeln!(self.text, "//! |{}|", cells.join("|"));
            if number == 0 {
                let line: Vec<String> = widths.iter().map(|width| "-".repeat(width + 2)).collect();
                let _ = writeln!(self.text, "//! |{}|", line.join("|"));
            }
        }
    }

    /// Writes what the figures are.
    fn tell(&mut self, app: &App, measured: &Measured, stack: u64, compiler: &str) -> Result<()> {
        let masked = self.bound(
            "interrupts masked".into(),
            Figure::Time(measured.start.masked.max(measured.later.masked)),
        );
        let stack = self.bound("stack".into(), Figure::Bytes(stack));
        let mut lines = vec![
            format!("Longest times on the bench, {compiler}: {RUN}."),
            "At start: in the first 500 ms; `init` from power-on. Times are to a task's end or its next `await`, without \
             what interrupts it."
                .to_owned(),
        ];
        for dispatcher in &app.dispatchers {
            let mut inside = Vec::new();
            for task in &app.tasks {
                if task.binds.is_none() && interrupt(app, task, measured)? == Some(dispatcher) {
                    inside.push(format!("`{}`", task.name));
                }
            }
            if let [_, _, ..] = &inside[..] {
                lines.push(format!("{} run in one interrupt, whose times they have.", inside.join(" and ")));
            }
        }
        lines.push(format!("Interrupts masked: {masked}; stack: {stack}."));
        self.text.push_str("//!\n");
        for line in wrapped(&lines.join(" "), 114) {
            let _ = writeln!(self.text, "//! {line}");
        }
        Ok(())
    }

    /// Returns the table as it is to stand in the source.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Compares with a table that stands in the source; returns whether the bounds were compared too: those of another
    /// compiler's image are not.
    ///
    /// # Errors
    /// If anything but the bounds is different, or something measured is above its bound; the error names it.
    pub fn check(&self, standing: &str, compiler: &str) -> Result<bool> {
        let (own, own_bounds) = skeleton(&self.text);
        let (other, bounds) = skeleton(standing);
        if own != other {
            let differs = own.iter().zip(&other).find(|(own, other)| own != other);
            let (own, other) = differs.map_or(("another length", ""), |(own, other)| (own, other));
            bail!("the table is not what the attributes and the run say: `{own}` for `{other}`");
        }
        ensure!(
            own_bounds.len() == self.figures.len() && bounds.len() == own_bounds.len(),
            "bounds are missing"
        );
        if !standing.contains(compiler) {
            return Ok(false);
        }
        for ((of, figure), bound) in self.figures.iter().zip(&bounds) {
            ensure!(figure.amount() <= *bound, "{of}: measured {figure}, which is above the table's bound");
        }
        Ok(true)
    }
}

/// Returns the interrupt in which a task runs.
fn interrupt<'a>(app: &'a App, task: &'a Task, measured: &Measured) -> Result<Option<&'a str>> {
    if task.kind != Kind::Task {
        return Ok(None);
    }
    let number = |name: &str| {
        let known = measured.later.handler(name);
        known.map(|(irq, _)| irq as usize).with_context(|| format!("the RP2040 has no interrupt {name}"))
    };
    let hardware = PRIORITIES - u32::from(task.priority);
    if let Some(name) = &task.binds {
        let runs_at = measured.priorities[number(name)?];
        ensure!(runs_at == hardware, "`{}`: {name} has priority {runs_at} on the chip", task.name);
        return Ok(Some(name));
    }
    for name in &app.dispatchers {
        if measured.priorities[number(name)?] == hardware {
            return Ok(Some(name));
        }
    }
    bail!("`{}`: no dispatcher has priority {} on the chip", task.name, task.priority)
}

/// Returns every interrupt that came in the run.
fn interrupts(measured: &Measured) -> Vec<(u32, &'static str)> {
    let mut found: Vec<_> = measured.start.ran().chain(measured.later.ran()).collect();
    found.sort_by_key(|(irq, ..)| *irq);
    found.dedup_by_key(|(irq, ..)| *irq);
    found.into_iter().map(|(irq, name, _)| (irq, name)).collect()
}

/// Returns a text in lines of at most `width`, if its words are not longer.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ').filter(|word| !word.is_empty()) {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Returns the words of a table without its bounds and without lines between cells, and the bounds, in nanoseconds or
/// bytes.
fn skeleton(text: &str) -> (Vec<String>, Vec<u64>) {
    let text = text.replace("//!", " ");
    let is_line = |word: &&str| word.chars().all(|letter| letter == '-' || letter == '|') && word.len() > 1;
    let is_version =
        |word: &str| word.starts_with(|letter: char| letter.is_ascii_digit()) && word.ends_with(':');
    let words: Vec<&str> = text.split_whitespace().filter(|word| !is_line(word)).collect();
    let (mut kept, mut bounds, mut place) = (Vec::new(), Vec::new(), 0);
    while let Some(word) = words.get(place) {
        let unit = |word: &str| match word.trim_end_matches(['.', ';']) {
            "us" => Some(1e3),
            "ms" => Some(1e6),
            "bytes" => Some(1.0),
            _ => None,
        };
        let number = words.get(place + 1).and_then(|number| number.parse::<f64>().ok());
        match (*word, number, words.get(place + 2).and_then(|word| unit(word))) {
            ("<", Some(number), Some(unit)) => {
                bounds.push((number * unit).round() as u64);
                kept.push("<".to_owned());
                place += 3;
            }
            (word, ..) => {
                // The compiler's version: `rustc 1.95.0:`.
                kept.push(if is_version(word) { "version:".into() } else { word.to_owned() });
                place += 1;
            }
        }
    }
    (kept, bounds)
}

#[cfg(test)]
mod tests {
    use super::*;
    use bench::rp2040::Watched;

    const US: u64 = 1_000;

    fn watched(handlers: &[(usize, u64, u64)]) -> Watched {
        let mut seen = Watched {
            handlers: Default::default(),
            first: Some(Nanos(5)),
            masked: Nanos(7),
            lowest_stack: 0,
        };
        for (irq, own, whole) in handlers {
            seen.handlers[*irq] = Handler { runs: 1, own: Nanos(*own), whole: Nanos(*whole) };
        }
        seen
    }

    fn app() -> App {
        let task = |name: &str, kind, binds: Option<&str>, priority| Task {
            name: name.into(),
            kind,
            binds: binds.map(str::to_owned),
            trigger: "something".into(),
            priority,
            locals: vec!["left".into(), "right".into()],
            shared: Vec::new(),
        };
        App {
            dispatchers: vec!["SW0_IRQ".into(), "SW1_IRQ".into()],
            tasks: vec![
                task("init", Kind::Init, None, 0),
                task("draw", Kind::Task, None, 1),
                task("report", Kind::Task, None, 1),
                task("service", Kind::Task, Some("IO_IRQ_BANK0"), 4),
                task("idle", Kind::Idle, None, 0),
            ],
        }
    }

    fn measured(service: u64) -> Measured {
        let mut priorities = [3; 32];
        (priorities[13], priorities[26], priorities[0]) = (0, 2, 1);
        Measured {
            start: watched(&[(13, 30 * US, 30 * US), (27, 900 * US, 1_234 * US)]),
            later: watched(&[(13, service, service), (27, 44_000 * US, 51_000 * US), (0, 9 * US, 9 * US)]),
            priorities,
        }
    }

    fn table(app: &App, service: u64) -> Result<Table> {
        Table::new(app, &measured(service), 11_000, "rustc 1.95.0")
    }

    #[test]
    fn bounds_are_a_quarter_above_and_round() {
        let bound = |nanos| Figure::Time(Nanos(nanos)).bound().to_string();
        assert_eq!(bound(35_200), "44 us");
        assert_eq!(bound(1_580_000), "2 ms");
        assert_eq!(bound(44_000_000), "55 ms");
        assert_eq!(bound(1_640), "2.1 us");
        assert_eq!(bound(780_000), "980 us");
        assert_eq!(bound(900_000), "1.2 ms");
        assert_eq!(Figure::Bytes(11_040).bound().to_string(), "14000 bytes");
    }

    #[test]
    fn rows_come_by_priority_and_tasks_of_one_dispatcher_have_its_times() {
        let table = table(&app(), 35 * US).unwrap();
        let rows: Vec<String> = table
            .text()
            .lines()
            .filter(|line| line.contains('|'))
            .map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "))
            .collect();
        let expected = [
            "//! | `init` | something | | < 0.1 us | | left, right | |",
            "//! | `service` | something | 4 | < 38 us | < 44 us | left, right | |",
            "//! | `draw` | something | 1 | < 1.2 ms | < 55 ms | left, right | |",
            "//! | `report` | something | 1 | < 1.2 ms | < 55 ms | left, right | |",
            "//! | (no task) | TIMER_IRQ_0 | 3 | - | < 12 us | | |",
            "//! | `idle` | something | 0 | | | left, right | |",
        ];
        assert_eq!(rows[2..], expected);
        assert!(table.text().contains("`draw` and `report` run in one interrupt"));
    }

    #[test]
    fn a_smaller_figure_is_no_difference_and_a_greater_one_is() {
        let standing = table(&app(), 35 * US).unwrap();
        for (service, is_kept) in [(20 * US, true), (44 * US, true), (45 * US, false)] {
            let now = table(&app(), service).unwrap();
            assert_eq!(now.check(standing.text(), "rustc 1.95.0").is_ok(), is_kept, "{service}");
            assert!(!now.check(standing.text(), "rustc 1.96.0").unwrap(), "another compiler's");
        }
    }

    #[test]
    fn another_attribute_is_a_difference_whatever_the_compiler() {
        let standing = table(&app(), 35 * US).unwrap();
        let mut changed = app();
        changed.tasks[1].locals.push("more".into());
        let said = table(&changed, 35 * US).unwrap().check(standing.text(), "rustc 1.96.0").unwrap_err();
        assert!(said.to_string().contains("not what the attributes"), "{said}");
    }

    #[test]
    fn an_interrupt_that_is_not_the_chips_or_has_another_priority_is_an_error() {
        let said = |change: fn(&mut App)| {
            let mut app = app();
            change(&mut app);
            table(&app, US).err().map(|error| error.to_string()).unwrap_or_default()
        };
        assert!(said(|app| app.tasks[3].binds = Some("NO_IRQ".into())).contains("no interrupt NO_IRQ"));
        assert!(said(|app| app.tasks[3].priority = 2).contains("has priority 0 on the chip"));
        assert!(said(|app| app.tasks[1].priority = 3).contains("no dispatcher"));
    }
}
