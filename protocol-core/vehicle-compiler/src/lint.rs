//! What a good DBC file has beyond being readable: units, comments, cycle times, reachable ranges.
//!
//! Owns the findings of `cargo xtask dbc` and the comments that the generated references print. What the generator
//! needs (syntax, overlaps, names, bits within the frame) is checked where the file is read; both are reported together.
//! Not supported: judging whether a comment is true.

use crate::diagnostics::{Diagnostics, Report, did_you_mean};
use crate::gate;
use crate::network::{Network, Signal};
use crate::places::{At, MessagePlace, Places};
use crate::ratio::Ratio;
use crate::syntax::{parse, placed, without_mark};
use can_dbc::{Comment, Dbc};
use std::collections::{BTreeMap, BTreeSet};

/// Returns everything that is wrong with a DBC text or missing in it, in grades; empty = nothing. `file` stands in the
/// findings.
pub fn lint(file: &str, text: &str) -> Diagnostics {
    let found = match gate::read(file, text) {
        Ok(found) => found,
        // A text that is no DBC has its syntax error already; the rest would be noise.
        Err(mut wrong) => {
            wrong.sort();
            return wrong;
        }
    };
    let mut findings = found.findings;
    if let Ok(dbc) = Dbc::try_from(without_mark(text)) {
        let mut report = Report::new(file, text);
        let places = Places::find(without_mark(text));
        if found.network.bitrate.is_none() {
            let advice = "BusSpeed is not set: vehicle.toml must say the bit rate";
            report.note(At { line: 1, column: 0 }, advice);
        }
        check_messages(&dbc, &places, &mut report);
        check_ranges(&found.network, &places, &mut report);
        findings.0.extend(report.finish().0);
    }
    findings.sort();
    findings
}

/// Returns the comments of a DBC text by packed identifier and signal; the message's own stands under `""`.
///
/// # Errors
/// If the text is not a DBC.
pub fn comments(file: &str, text: &str) -> Result<BTreeMap<(u32, String), String>, Diagnostics> {
    let mut comments = BTreeMap::new();
    for comment in parse(file, text)?.comments {
        match comment {
            Comment::Message { id, comment } => comments.insert((id.raw(), String::new()), comment),
            Comment::Signal { message_id, name, comment } => {
                comments.insert((message_id.raw(), name), comment)
            }
            _ => None,
        };
    }
    Ok(comments)
}

fn check_messages(dbc: &Dbc, places: &Places<'_>, report: &mut Report<'_>) {
    let nodes: BTreeSet<&str> = dbc.nodes.iter().map(|node| node.0.as_str()).collect();
    let mut noted = BTreeSet::new();
    let defaults: BTreeSet<&str> = dbc.attribute_defaults.iter().map(|row| row.name.as_str()).collect();
    let cycle_is_default = defaults.contains("GenMsgCycleTime");
    for (message, place) in placed(dbc, places) {
        let MessagePlace { id, name, at, .. } = *place;
        if places.comment(id, "").is_none_or(|comment| comment.trim().is_empty()) {
            report.note(at, format!("message `{name}` has no comment (CM_ BO_ {id})"));
        }
        if !cycle_is_default && places.attribute("GenMsgCycleTime", id, "").is_none() {
            let advice = "write GenMsgCycleTime, 0 if it is sent on events";
            report.note(at, format!("message `{name}` has no cycle time; {advice}"));
        }
        if message.transmitter.is_none() {
            report.note(at, format!("message `{name}` has no sender"));
        }
        for (signal, place) in message.signals.iter().zip(&place.signals) {
            let at = place.at;
            let words = places.words(id, place.name).map_or([].as_slice(), |words| words.rows.as_slice());
            if places.comment(id, place.name).is_none_or(|comment| comment.trim().is_empty()) {
                report.note(at, format!("signal `{}` has no comment (CM_ SG_ {id})", signal.name));
            }
            // Numbers, codes and flags have none.
            if signal.unit.is_empty() && signal.factor != 1.0 && words.is_empty() {
                report.note(
                    at,
                    format!("signal `{}` is scaled by {} and has no unit", signal.name, signal.factor),
                );
            }
            for receiver in signal.receivers.iter().filter(|receiver| !nodes.contains(receiver.as_str())) {
                if receiver != "Vector__XXX" && noted.insert((id, receiver.as_str())) {
                    let near = did_you_mean(receiver, nodes.iter().copied());
                    report.note(at, format!("receiver `{receiver}` is not in the list of nodes (BU_){near}"));
                }
            }
            let mut seen = BTreeMap::new();
            for (raw, word) in words {
                if let Some(first) = seen.insert(word, raw) {
                    let text = format!("values {first} and {raw} of `{}` are both \"{word}\"", signal.name);
                    report.note(at, text);
                }
            }
        }
    }
}

/// Finds ranges that say nothing and limits that no raw value reaches.
fn check_ranges(network: &Network, places: &Places<'_>, report: &mut Report<'_>) {
    let written: BTreeMap<At, &str> = places
        .messages
        .iter()
        .flat_map(|message| message.signals.iter().map(|signal| (signal.at, signal.numbers)))
        .collect();
    let signals = network.messages.iter().flat_map(|message| &message.signals);
    for signal in signals.filter(|signal| !signal.number.is_float()) {
        let Some([factor, offset, minimum, maximum]) =
            written.get(&signal.at).and_then(|text| gate::numbers(text))
        else {
            continue;
        };
        let (Some(low), Some(high)) = (Ratio::parse(minimum), Ratio::parse(maximum)) else { continue };
        if low == Ratio::ZERO && high == Ratio::ZERO {
            report
                .note(signal.at, format!("signal `{}` has the range [0|0]: say what is valid", signal.name));
            continue;
        }
        let limits = [(low, minimum), (high, maximum)];
        for (_, written) in limits.into_iter().filter(|(limit, _)| !is_on_grid(signal, *limit)) {
            let text = format!(
                "limit {written} of `{}` cannot be reached with factor {factor} and offset {offset}",
                signal.name
            );
            report.note(signal.at, text);
        }
    }
}

fn is_on_grid(signal: &Signal, limit: Ratio) -> bool {
    let steps = limit.checked_sub(signal.offset).and_then(|above| above.checked_div(signal.factor));
    steps.is_some_and(|steps| steps.den == 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLEAN: &str = "VERSION \"\"\n\nNS_ :\n\nBS_:\n\nBU_: A B\n\n\
        BO_ 291 Speed: 8 A\n SG_ speed : 0|16@1+ (0.5,0) [0|100] \"km/h\" B\n\n\
        CM_ BO_ 291 \"Speed\";\nCM_ SG_ 291 speed \"Speed\";\n\
        BA_DEF_ \"BusSpeed\" INT 0 1000000;\nBA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;\n\
        BA_DEF_DEF_ \"BusSpeed\" 250000;\nBA_ \"GenMsgCycleTime\" BO_ 291 100;\n";

    fn findings(from: &str, to: &str) -> Vec<String> {
        assert!(CLEAN.contains(from), "{from}");
        lint("x.dbc", &CLEAN.replace(from, to)).0.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn a_clean_file_has_no_findings() {
        assert_eq!(lint("x.dbc", CLEAN).to_string(), "");
    }

    #[test]
    fn each_finding_names_the_line_it_is_about() {
        let cases = [
            ("CM_ BO_ 291 \"Speed\";\n", "", "x.dbc:9:1: note: message `Speed` has no comment (CM_ BO_ 291)"),
            (
                "CM_ SG_ 291 speed \"Speed\";\n",
                "",
                "x.dbc:10:2: note: signal `speed` has no comment (CM_ SG_ 291)",
            ),
            ("\"km/h\"", "\"\"", "x.dbc:10:2: note: signal `speed` is scaled by 0.5 and has no unit"),
            ("[0|100]", "[0|0]", "x.dbc:10:2: note: signal `speed` has the range [0|0]: say what is valid"),
            (
                "[0|100]",
                "[0|99.7]",
                "x.dbc:10:2: note: limit 99.7 of `speed` cannot be reached with factor 0.5 and offset 0",
            ),
            (
                "\"km/h\" B",
                "\"km/h\" b1",
                "x.dbc:10:2: note: receiver `b1` is not in the list of nodes (BU_); did you mean `B`?",
            ),
            (
                "BA_ \"GenMsgCycleTime\" BO_ 291 100;\n",
                "",
                "x.dbc:9:1: note: message `Speed` has no cycle time; write GenMsgCycleTime, 0 if it is sent on events",
            ),
            (
                "BA_DEF_ \"BusSpeed\"",
                "VAL_ 291 speed 0 \"still\" 1 \"still\" ;\nBA_DEF_ \"BusSpeed\"",
                "x.dbc:10:2: note: values 0 and 1 of `speed` are both \"still\"",
            ),
        ];
        for (from, to, finding) in cases {
            assert_eq!(findings(from, to), [finding]);
        }
    }

    #[test]
    fn what_the_generator_refuses_is_found_too() {
        assert_eq!(
            findings("0|16@1+", "56|16@1+"),
            ["x.dbc:10:2: warning: `speed` reaches beyond the 8 bytes of the message"]
        );
    }
}
