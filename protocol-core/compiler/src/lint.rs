//! What a good DBC file has beyond being readable: units, comments, cycle times, reachable ranges.
//!
//! Owns the findings of `cargo xtask dbc` and the comments that the generated references print. What the generator
//! needs (syntax, overlaps, names, bits within the frame) is checked where the file is read; both are reported together.
//! Not supported: judging whether a comment is true.

use crate::diagnostics::{Diagnostics, Report, did_you_mean};
use crate::network::{self, Network, Signal};
use crate::places::{MessagePlace, Places};
use crate::ratio::Ratio;
use can_dbc::{Comment, Dbc};
use std::collections::{BTreeMap, BTreeSet};

/// Returns everything that is wrong with a DBC text or missing in it; empty = nothing. `file` stands in the findings.
pub fn lint(file: &str, text: &str) -> Diagnostics {
    let (network, mut found) = match network::read(file, text) {
        Ok(network) => (Some(network), Diagnostics::default()),
        Err(wrong) => (None, wrong),
    };
    // A text that is no DBC has its syntax error already; the rest would be noise.
    if let Ok(dbc) = Dbc::try_from(network::without_mark(text)) {
        let mut report = Report::new(file, text);
        let places = Places::find(network::without_mark(text));
        check_messages(&dbc, &places, &mut report);
        if let Some(network) = &network {
            check_ranges(&dbc, network, &places, &mut report);
        }
        found.0.extend(report.finish().0);
    }
    found.or(()).err().unwrap_or_default()
}

/// Returns the comments of a DBC text by packed identifier and signal; the message's own stands under `""`.
///
/// # Errors
/// If the text is not a DBC.
pub fn comments(file: &str, text: &str) -> Result<BTreeMap<(u32, String), String>, Diagnostics> {
    let mut comments = BTreeMap::new();
    for comment in network::parse(file, text)?.comments {
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
    for (message, place) in network::placed(dbc, places) {
        let MessagePlace { id, name, line, .. } = *place;
        if dbc.message_comment(message.id).is_none_or(|comment| comment.trim().is_empty()) {
            report.line(line, format!("message `{name}` has no comment (CM_ BO_ {id})"));
        }
        if dbc.resolved_message_attribute(message.id, "GenMsgCycleTime").is_none() {
            let advice = "write GenMsgCycleTime, 0 if it is sent on events";
            report.line(line, format!("message `{name}` has no cycle time; {advice}"));
        }
        if message.transmitter.is_none() {
            report.line(line, format!("message `{name}` has no sender"));
        }
        for (signal, place) in message.signals.iter().zip(&place.signals) {
            let line = place.line;
            let words = dbc.value_descriptions_for_signal(message.id, &signal.name).unwrap_or_default();
            if dbc.signal_comment(message.id, &signal.name).is_none_or(|comment| comment.trim().is_empty()) {
                report.line(line, format!("signal `{}` has no comment (CM_ SG_ {id})", signal.name));
            }
            // Numbers, codes and flags have none.
            if signal.unit.is_empty() && signal.factor != 1.0 && words.is_empty() {
                report.line(
                    line,
                    format!("signal `{}` is scaled by {} and has no unit", signal.name, signal.factor),
                );
            }
            for receiver in signal.receivers.iter().filter(|receiver| !nodes.contains(receiver.as_str())) {
                if receiver != "Vector__XXX" && noted.insert((id, receiver.as_str())) {
                    let near = did_you_mean(receiver, nodes.iter().copied());
                    report
                        .line(line, format!("receiver `{receiver}` is not in the list of nodes (BU_){near}"));
                }
            }
            let mut seen = BTreeMap::new();
            for word in words {
                if let Some(first) = seen.insert(word.description.as_str(), word.id) {
                    let both = format!("{first} and {}", word.id);
                    report.line(
                        line,
                        format!("values {both} of `{}` are both \"{}\"", signal.name, word.description),
                    );
                }
            }
        }
    }
}

/// Finds ranges that say nothing and limits that no raw value reaches.
fn check_ranges(dbc: &Dbc, network: &Network, places: &Places<'_>, report: &mut Report<'_>) {
    // Every signal of a network without errors is one of the text.
    for (message, (source, place)) in network.messages.iter().zip(network::placed(dbc, places)) {
        for ((signal, written), place) in message.signals.iter().zip(&source.signals).zip(&place.signals) {
            let line = place.line;
            let [low, high] = [&written.min, &written.max].map(|limit| Ratio::parse(&limit.to_string()));
            let (Some(low), Some(high)) = (low, high) else { continue };
            if low == Ratio::ZERO && high == Ratio::ZERO {
                report.line(line, format!("signal `{}` has the range [0|0]: say what is valid", signal.name));
                continue;
            }
            for limit in [low, high].into_iter().filter(|limit| !is_on_grid(signal, *limit)) {
                let grid = format!("factor {} and offset {}", written.factor, written.offset);
                let shown = limit.num as f64 / limit.den as f64;
                report
                    .line(line, format!("limit {shown} of `{}` cannot be reached with {grid}", signal.name));
            }
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
            ("CM_ BO_ 291 \"Speed\";\n", "", "x.dbc:9: message `Speed` has no comment (CM_ BO_ 291)"),
            ("CM_ SG_ 291 speed \"Speed\";\n", "", "x.dbc:10: signal `speed` has no comment (CM_ SG_ 291)"),
            ("\"km/h\"", "\"\"", "x.dbc:10: signal `speed` is scaled by 0.5 and has no unit"),
            ("[0|100]", "[0|0]", "x.dbc:10: signal `speed` has the range [0|0]: say what is valid"),
            (
                "[0|100]",
                "[0|99.7]",
                "x.dbc:10: limit 99.7 of `speed` cannot be reached with factor 0.5 and offset 0",
            ),
            (
                "\"km/h\" B",
                "\"km/h\" b1",
                "x.dbc:10: receiver `b1` is not in the list of nodes (BU_); did you mean `B`?",
            ),
            (
                "BA_ \"GenMsgCycleTime\" BO_ 291 100;\n",
                "",
                "x.dbc:9: message `Speed` has no cycle time; write GenMsgCycleTime, 0 if it is sent on events",
            ),
            (
                "BA_DEF_ \"BusSpeed\"",
                "VAL_ 291 speed 0 \"still\" 1 \"still\" ;\nBA_DEF_ \"BusSpeed\"",
                "x.dbc:10: values 0 and 1 of `speed` are both \"still\"",
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
            ["x.dbc:10: `speed` reaches beyond the 8 bytes of the message"]
        );
    }
}
