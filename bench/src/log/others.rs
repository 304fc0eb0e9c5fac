//! Formats that are told apart and not read: the refusal names the format and what helps.

/// A format that is recognised by a line of it.
struct Other {
    /// What it is called.
    name: &'static str,
    /// What turns it into a format that is read.
    remedy: &'static str,
    looks_like: fn(&str) -> bool,
}

const TABLE: &str = "save it as candump, Vector ASC or GVRET CSV";

const OTHERS: &[Other] = &[
    Other {
        name: "a PCAN trace",
        remedy: "convert it: `python3 -m can.logconvert IN.trc OUT.log`",
        looks_like: |line| line.to_ascii_uppercase().starts_with(";$FILEVERSION"),
    },
    Other {
        name: "a table of python-can's CSV writer",
        remedy: "convert it: `python3 -m can.logconvert IN.csv OUT.log`",
        looks_like: |line| line.starts_with("timestamp,arbitration_id,"),
    },
    Other {
        name: "a BUSMASTER log",
        remedy: "BUSMASTER's format converters write it as ASC",
        looks_like: |line| line.starts_with("***BUSMASTER"),
    },
    Other { name: "a CarBus Analyzer trace", remedy: TABLE, looks_like: |line| line.starts_with("@ TEXT @") },
    Other {
        name: "a log of OVMS (CRTD)",
        remedy: "SavvyCAN opens it and saves it as GVRET",
        looks_like: |line| line.split_whitespace().nth(1).is_some_and(is_crtd_record),
    },
    Other {
        name: "a table with the columns ParserFlags, Ch, Counter",
        remedy: TABLE,
        looks_like: |line| line.starts_with("ParserFlags\t"),
    },
    Other {
        name: "a table of a USB-CAN adapter's program (NO, Direction, Time Scale)",
        remedy: TABLE,
        looks_like: |line| line.split_whitespace().take(4).eq(["NO", "Direction", "Time", "Scale"]),
    },
    Other {
        name: "a serial log of Battery-Emulator (RX0, TX0)",
        remedy: "save its log as candump or GVRET",
        looks_like: is_battery_emulator,
    },
];

/// Returns what to say of a line that shows a format that is not read.
pub(super) fn refusal(line: &str) -> Option<String> {
    let other = OTHERS.iter().find(|other| (other.looks_like)(line))?;
    Some(format!("{}, which is not read here; {}", other.name, other.remedy))
}

/// `1R29`, `R11`, `CXX`: the kind of a record, behind the number of the bus.
fn is_crtd_record(word: &str) -> bool {
    let kind = word.trim_start_matches(|sign: char| sign.is_ascii_digit());
    word.len() - kind.len() <= 1 && matches!(kind, "CXX" | "CVR" | "R11" | "R29" | "T11" | "T29")
}

/// `(683.70) RX0 7E0 [8] ...`: hundredths of a second, and a direction where candump has the interface.
fn is_battery_emulator(line: &str) -> bool {
    let Some((time, rest)) = line.strip_prefix('(').and_then(|line| line.split_once(')')) else {
        return false;
    };
    let hundredths = time.split_once('.').is_some_and(|(_, fraction)| fraction.len() == 2);
    let word = rest.split_whitespace().next().unwrap_or("");
    let number = word.strip_prefix("RX").or_else(|| word.strip_prefix("TX"));
    hundredths && number.is_some_and(super::token::is_digits)
}
