//! When a signal is in the frame: multiplexers, their ranges (`SG_MUL_VAL_`), multiplexers behind multiplexers.

use crate::network::{Condition, Doubt, Signal};
use crate::places::{MessagePlace, MuxValues};
use std::collections::BTreeMap;

/// What stands behind the name of a signal: ``, `M`, `m3`, `m3M`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Mark<'a> {
    pub(crate) is_selector: bool,
    /// The digits of `m3`; empty for an `m` without any.
    at: Option<&'a str>,
}

impl<'a> Mark<'a> {
    pub(crate) fn read(text: &'a str) -> Self {
        let (rest, is_selector) = text.strip_suffix('M').map_or((text, false), |rest| (rest, true));
        Self { is_selector, at: rest.strip_prefix('m') }
    }
}

/// Fills in when each signal is in the frame. Returns the indices of those of which it cannot be told, and why.
///
/// `marks` are those of `signals`; `ranges` are the `SG_MUL_VAL_` of this message by signal.
pub(crate) fn find_conditions(
    signals: &mut [Signal],
    marks: &[Mark<'_>],
    ranges: &BTreeMap<&str, &MuxValues<'_>>,
    message: &MessagePlace<'_>,
) -> Vec<(usize, Doubt)> {
    let roots: Vec<usize> = (0..marks.len()).filter(|&at| marks[at] == Mark::read("M")).collect();
    let mut wrong = Vec::new();
    let mut own: Vec<Option<Condition>> = vec![None; signals.len()];
    for (index, mark) in marks.iter().enumerate() {
        let Some(digits) = mark.at else { continue };
        match own_condition(
            signals,
            index,
            digits,
            &roots,
            ranges.get(signals[index].short.as_str()).copied(),
        ) {
            Ok(condition) => own[index] = Some(condition),
            Err(text) => wrong.push((index, Doubt { at: signals[index].at, text })),
        }
    }
    for index in 0..signals.len() {
        let (mut when, mut next) = (Vec::new(), own[index].clone());
        while let Some(condition) = next {
            next = own[condition.selector].clone();
            when.push(condition);
            // Each multiplexer once: more are a circle.
            if when.len() > signals.len() {
                let text = format!(
                    "the multiplexers of `{}` in {} form a circle",
                    signals[index].name, message.name
                );
                wrong.push((index, Doubt { at: signals[index].at, text }));
                when.clear();
                break;
            }
        }
        when.reverse();
        signals[index].when = when;
    }
    // What depends on a multiplexer that cannot be had cannot be had either.
    loop {
        let lost = |selector: usize| wrong.iter().any(|(index, _)| *index == selector);
        let found = signals.iter().enumerate().find_map(|(index, signal)| {
            let selector = signal.when.iter().map(|condition| condition.selector).find(|&at| lost(at))?;
            (!lost(index)).then_some((index, selector))
        });
        let Some((index, selector)) = found else { break };
        let (name, of) = (&signals[index].name, &signals[selector].name);
        wrong.push((
            index,
            Doubt {
                at: signals[index].at,
                text: format!("`{name}` depends on `{of}`, which cannot be read"),
            },
        ));
    }
    wrong
}

/// Returns the condition that one signal names itself.
fn own_condition(
    signals: &[Signal],
    index: usize,
    digits: &str,
    roots: &[usize],
    values: Option<&MuxValues<'_>>,
) -> Result<Condition, String> {
    let name = &signals[index].name;
    let (selector, ranges): (usize, Vec<(i128, i128)>) = match values {
        Some(values) => {
            let named =
                signals.iter().position(|signal| signal.short == values.selector && signal.is_selector);
            let selector = named.ok_or_else(|| {
                format!("`{name}` depends on `{}`, which is no multiplexer of the message", values.selector)
            })?;
            (
                selector,
                values.ranges.iter().map(|(first, last)| (i128::from(*first), i128::from(*last))).collect(),
            )
        }
        None => {
            let when: i128 = digits
                .parse()
                .map_err(|_| format!("`{name}` is multiplexed (`m`) but does not say at which value"))?;
            match roots {
                [one] => (*one, vec![(when, when)]),
                _ => {
                    let found = roots.len();
                    return Err(format!(
                        "`{name}` is multiplexed, and its message has {found} multiplexers: SG_MUL_VAL_ must say which"
                    ));
                }
            }
        }
    };
    let (lowest, highest) = signals[selector].span();
    if ranges.iter().all(|(first, last)| *last < lowest || *first > highest) {
        let (at, bits) = (ranges.first().map_or(0, |range| range.0), signals[selector].length);
        return Err(format!(
            "`{name}` is sent at {at}, which the {bits} bits of `{}` never hold",
            signals[selector].name
        ));
    }
    Ok(Condition { selector, ranges })
}
