//! The message line in a scenario: a fault by its key, never by what the driver reads.
//!
//! Owns how it is written, how it is compared, and what somebody is told who writes a text instead.

use super::vehicle;
use cluster::faults::ROWS;
use cluster::{FaultId, Named};
use protocol_core::link::ScreenLine;
use protocol_core::model::Severity;
use protocol_core::vehicle::Vehicle;
use std::fmt;
use toml::{Table, Value};
use virtual_vehicle::Kind;

/// A message line as it was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FoundLine {
    /// Which fault; of a number that no row has the number.
    pub named: Result<Named, u8>,
    /// Its English text, for whoever reads a trace.
    pub text: &'static str,
    /// How bad it is.
    pub severity: Severity,
    /// Which of the lines that take turns.
    pub position: u8,
    /// How many take turns.
    pub count: u8,
}

/// What is wanted of a message line; what is `None` does not matter.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct WantedLine {
    /// One of these faults; empty = any.
    pub faults: Vec<FaultId>,
    /// Its stage.
    pub stage: Option<&'static str>,
    /// Code, of an alarm bit its number; `Some(None)` = there must be none.
    pub code: Option<Option<u16>>,
    /// How bad.
    pub severity: Option<Severity>,
    /// How many lines take turns.
    pub count: Option<u8>,
}

impl FoundLine {
    /// Returns the line of a record.
    pub(super) fn of_record(line: ScreenLine, vehicle: &Vehicle) -> Self {
        let ScreenLine { fault, stage, code, severity, position, count } = line;
        let named = Named::of_record(fault, stage, code).ok_or(fault);
        let text = named.map_or("", |named| named.text(vehicle).en);
        Self { named, text, severity: Severity::from_model(severity.into()), position, count }
    }

    /// Returns the line of a view.
    pub(super) fn of_view(line: cluster::view::Line) -> Self {
        let cluster::view::Line { named, severity, text, position, count, .. } = line;
        Self { named: Ok(named), text: text.en, severity, position, count }
    }
}

impl WantedLine {
    /// Returns the line of one of these faults.
    fn of(faults: Vec<FaultId>) -> Self {
        Self { faults, ..Self::default() }
    }

    /// Reads one key, a list of keys, or a table; `None` = it is none of these.
    pub(super) fn read(value: &Value, kind: Kind) -> Option<Result<Self, String>> {
        match value {
            Value::Table(table) => Some(Self::of_table(table, kind)),
            Value::String(_) | Value::Array(_) => Some(faults(value, kind)?.map(Self::of)),
            _ => None,
        }
    }

    fn of_table(table: &Table, kind: Kind) -> Result<Self, String> {
        let mut line = Self::default();
        let small = |value: &Value| value.as_integer().and_then(|number| u16::try_from(number).ok());
        for (key, value) in table {
            match (&key[..], value) {
                ("fault", Value::String(_) | Value::Array(_)) => {
                    line.faults = faults(value, kind).ok_or("`fault` is a key or a list of keys")??;
                }
                ("stage", Value::String(_)) => {}
                ("code", Value::String(none)) if none == "none" => line.code = Some(None),
                ("code", value) if small(value).is_some() => line.code = Some(small(value)),
                ("severity", Value::String(word)) => {
                    let words = || Severity::ALL.iter().map(|severity| severity.word()).collect::<Vec<_>>();
                    let severity = Severity::from_word(word);
                    let wrong = || format!("the severity of a line is one of {}", words().join(", "));
                    line.severity = Some(severity.ok_or_else(wrong)?);
                }
                ("count", value) if small(value).is_some_and(|count| count < 256) => {
                    line.count = small(value).map(|count| count as u8);
                }
                ("text", Value::String(text)) => return Err(instead_of(text, kind)),
                _ => {
                    return Err(
                        "a line has `fault`, `stage`, `code` (or \"none\"), `severity` and `count`".into()
                    );
                }
            }
        }
        if let Some(stage) = table.get("stage").and_then(Value::as_str) {
            line.stage = Some(stage_of(&line.faults, stage)?);
        }
        Ok(line)
    }

    pub(super) fn fits(&self, line: &FoundLine) -> bool {
        let Ok(named) = line.named else { return *self == Self::default() };
        (self.faults.is_empty() || self.faults.contains(&named.fault))
            && self.stage.is_none_or(|stage| named.stage_key() == Some(stage))
            && self.code.is_none_or(|code| code == named.code)
            && self.severity.is_none_or(|severity| severity == line.severity)
            && self.count.is_none_or(|count| count == line.count)
    }
}

/// Reads a key or a list of keys; `None` = it is neither.
fn faults(value: &Value, kind: Kind) -> Option<Result<Vec<FaultId>, String>> {
    let one = |value: &Value| Some(fault(value.as_str()?, kind));
    match value {
        Value::Array(items) if !items.is_empty() => items.iter().map(one).collect(),
        value => one(value).map(|fault| fault.map(|fault| vec![fault])),
    }
}

/// Reads a key; the error says how it is written, or what there is.
fn fault(key: &str, kind: Kind) -> Result<FaultId, String> {
    FaultId::from_key(key).ok_or_else(|| instead_of(key, kind))
}

/// Reads a stage of one of the faults.
fn stage_of(faults: &[FaultId], stage: &str) -> Result<&'static str, String> {
    let all: Vec<&str> = faults.iter().flat_map(|fault| fault.row().words.stages()).copied().collect();
    let found = all.iter().copied().find(|one| *one == stage);
    found.ok_or_else(|| match all[..] {
        [] => "a `stage` belongs to a fault that has stages: write `fault` beside it".into(),
        _ => format!("no stage `{stage}`; there are {}", all.join(", ")),
    })
}

/// Says which keys to write instead of a text.
fn instead_of(text: &str, kind: Kind) -> String {
    let mut ways = Vec::new();
    for row in ROWS {
        let key = row.fault.key();
        let stages = row.words.stages();
        for (place, said) in row.words.texts().iter().enumerate() {
            if [said.en, said.zh].contains(&text) {
                ways.push(match stages.get(place) {
                    Some(stage) => format!("{{ fault = \"{key}\", stage = \"{stage}\" }}"),
                    None => format!("\"{key}\""),
                });
            }
        }
        for said in vehicle(kind).into_iter().flat_map(|vehicle| vehicle.faults) {
            if row.codes.contains(&said.source) && [said.en, said.zh].contains(&text) {
                ways.push(format!("{{ fault = \"{key}\", code = {} }}", said.code));
            }
        }
    }
    if ways.is_empty() {
        let keys: Vec<&str> = FaultId::ALL.iter().map(|fault| fault.key()).collect();
        return format!("no fault `{text}`; there are {}", keys.join(", "));
    }
    format!("a fault is named by its key: \"{text}\" is written {}", ways.join(" or "))
}

impl fmt::Display for FoundLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ", self.severity.word())?;
        match self.named {
            Ok(named) => {
                write!(f, "{}", named.fault.key())?;
                let stage = named.stage_key().map(str::to_owned);
                for part in [stage, named.code.map(|code| code.to_string())].into_iter().flatten() {
                    write!(f, " {part}")?;
                }
            }
            Err(number) => write!(f, "fault {number}")?,
        }
        write!(f, " \"{}\"", self.text)?;
        if self.count > 1 { write!(f, " ({} of {})", self.position, self.count) } else { Ok(()) }
    }
}

impl fmt::Display for WantedLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let severity = self.severity.map(|severity| severity.word().to_owned());
        let keys: Vec<&str> = self.faults.iter().map(|fault| fault.key()).collect();
        let keys = (!keys.is_empty()).then(|| keys.join(" or "));
        let stage = self.stage.map(str::to_owned);
        let code = self.code.map(|code| code.map_or("no code".into(), |code| code.to_string()));
        let count = self.count.map(|count| format!("(1 of {count})"));
        let parts: Vec<String> = [severity, keys, stage, code, count].into_iter().flatten().collect();
        f.write_str(&parts.join(" "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<WantedLine, String> {
        let table: Table = toml::from_str(text).expect("TOML");
        WantedLine::read(&table["line"], Kind::Citybus).expect("a line")
    }

    #[test]
    fn a_line_is_a_key_a_list_of_keys_or_a_table() {
        let wanted = |faults: &[FaultId]| WantedLine::of(faults.to_vec());
        assert_eq!(read("line = \"silent_bms\""), Ok(wanted(&[FaultId::SilentBms])));
        let both = wanted(&[FaultId::VehicleCode, FaultId::Battery]);
        assert_eq!(read("line = [\"vehicle_code\", \"battery_code\"]"), Ok(both.clone()));
        let table = "line = { fault = [\"vehicle_code\", \"battery_code\"], code = 24, severity = \"stop\", count = 2 }";
        let full =
            WantedLine { code: Some(Some(24)), severity: Some(Severity::Stop), count: Some(2), ..both };
        assert_eq!(read(table), Ok(full));
        let stage = WantedLine { stage: Some("overdue"), ..wanted(&[FaultId::HvOff]) };
        assert_eq!(read("line = { stage = \"overdue\", fault = \"hv_off\" }"), Ok(stage));
        assert_eq!(WantedLine::read(&Value::Integer(7), Kind::Citybus), None);
        assert_eq!(WantedLine::read(&Value::Array(vec![Value::Integer(7)]), Kind::Citybus), None);
    }

    #[test]
    fn a_text_is_told_with_the_key_to_write() {
        let error = |text: &str| read(text).expect_err("a text");
        let written = |text: &str| error(&format!("line = {{ text = \"{text}\" }}"));
        let instead = "a fault is named by its key: \"No communication: BMS\" is written \"silent_bms\"";
        assert_eq!(written("No communication: BMS"), instead);
        assert_eq!(error("line = \"No communication: BMS\""), instead);
        assert!(
            written("HV still on: battery will cut it")
                .ends_with("{ fault = \"hv_off\", stage = \"overdue\" }")
        );
        let code = written("Battery link fault");
        assert!(code.contains("{ fault = \"vehicle_code\", code = 63 }"), "{code}");
        assert!(
            error("line = \"silent_bsm\"").starts_with("no fault `silent_bsm`; there are vehicle_level, ")
        );
        assert!(
            error("line = { fault = \"hv_off\", stage = \"level_1\" }")
                .ends_with("asked, overdue, now, done")
        );
        assert!(error("line = { stage = \"asked\" }").contains("write `fault`"));
        assert!(error("line = { colour = \"red\" }").starts_with("a line has `fault`"));
    }

    #[test]
    fn a_line_fits_by_fault_stage_code_severity_and_count_and_says_all_of_it() {
        let named = Named { fault: FaultId::Battery, stage: 1, code: Some(24) };
        let found = FoundLine {
            named: Ok(named),
            text: "Battery fault level 2",
            severity: Severity::Derate,
            position: 1,
            count: 2,
        };
        assert_eq!(found.to_string(), "derate battery_code level_2 24 \"Battery fault level 2\" (1 of 2)");
        let fits = |text: &str| read(&format!("line = {text}")).expect("a line").fits(&found);
        for is in ["\"battery_code\"", "[\"limp\", \"battery_code\"]", "{ code = 24 }", "{ count = 2 }"] {
            assert!(fits(is), "{is}");
        }
        assert!(
            fits("{ fault = \"battery_code\", stage = \"level_2\" }") && fits("{ severity = \"derate\" }")
        );
        for is_not in
            ["\"limp\"", "{ code = \"none\" }", "{ code = 25 }", "{ severity = \"warn\" }", "{ count = 1 }"]
        {
            assert!(!fits(is_not), "{is_not}");
        }
        assert!(!fits("{ fault = \"battery_code\", stage = \"level_1\" }"));
        let unknown = FoundLine { named: Err(200), ..found };
        assert!(!WantedLine::of(vec![FaultId::Battery]).fits(&unknown));
        assert_eq!(unknown.to_string(), "derate fault 200 \"Battery fault level 2\" (1 of 2)");
    }
}
