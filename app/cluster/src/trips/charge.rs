//! The charge of the battery: its own word, else the vehicle controller's copy of it.
//!
//! A silent battery has no charge to copy: the vehicle controller would repeat its last one.
//! Source: BUS-R064, BUS-115; reading JL-23.

use protocol_core::model::Shown;

/// A battery of which nothing has been heard for this long does not vouch for anybody's copy, in milliseconds.
const HEARD_MS: u64 = 1_000;

/// Returns the charge in 0.1 % from the battery's own value and the copy; `silent_ms` is the time since the battery's
/// last sign of life, `None` = there was none.
pub(crate) fn of(own: Shown<i32>, copy: Shown<i32>, silent_ms: Option<u64>) -> Shown<i32> {
    let is_heard = silent_ms.is_some_and(|silent_ms| silent_ms < HEARD_MS);
    match (own, copy) {
        (Shown::Never | Shown::Stale | Shown::Invalid, Shown::Value(_)) if is_heard => copy,
        _ => own,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Shown::{Invalid, Never, Stale, Value};

    #[test]
    fn jl_23_a_copy_counts_only_for_a_battery_that_is_heard_and_does_not_say_itself() {
        for own in [Never, Stale, Invalid, Value(500)] {
            for copy in [Never, Stale, Invalid, Value(510)] {
                for silent_ms in [None, Some(0), Some(999), Some(1_000), Some(u64::MAX)] {
                    let vouches = silent_ms == Some(0) || silent_ms == Some(999);
                    let copies = own != Value(500) && copy == Value(510) && vouches;
                    let stated = if copies { Value(510) } else { own };
                    assert_eq!(of(own, copy, silent_ms), stated, "{own:?} {copy:?} {silent_ms:?}");
                }
            }
        }
    }
}
