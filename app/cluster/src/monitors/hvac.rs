//! The air conditioning has lost its link while it ran: behind a switch, off by default.
//!
//! The air conditioning goes on as it was, so this is information. It ends with its next word. A function of what is
//! known now; what it last said of itself counts, however old.
//! Source: BUS-R133, BUS-R134; reading BUS-23 (not parsed by default, a text behind a configuration switch).

/// Returns whether the loss of a running air conditioning is to be told; `rule_ms` = silence that is told, if it is.
pub(crate) fn is_lost(rule_ms: Option<u32>, was_running: bool, silent_ms: u64) -> bool {
    was_running && rule_ms.is_some_and(|rule_ms| silent_ms >= u64::from(rule_ms))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bus_r133_bus_23_only_a_running_air_conditioning_is_missed_and_only_if_wanted() {
        for is_wanted in [false, true] {
            for was_running in [false, true] {
                for (silent_ms, long) in [(0, false), (9_999, false), (10_000, true), (u64::MAX, true)] {
                    let told = is_lost(is_wanted.then_some(10_000), was_running, silent_ms);
                    assert_eq!(told, [is_wanted, was_running, long] == [true; 3], "{silent_ms} ms");
                }
            }
        }
    }
}
