//! What tests and tools find around them on a PC.
//!
//! Owns three answers that every crate must give alike: where the checkout is, whether this is CI, and what becomes of
//! a test whose tool is not here. Refuses to install anything: that is xtask's.

pub mod need;

mod checkout;

pub use checkout::{check, root, scratch, target};

/// Returns whether this is CI: there a missing tool is an error, not a skip.
///
/// The variable `CI` is set, and not to nothing, `0` or `false`.
#[must_use]
pub fn is_ci() -> bool {
    std::env::var_os("CI").is_some_and(|value| says_yes(&value.to_string_lossy()))
}

fn says_yes(value: &str) -> bool {
    !(value.is_empty() || value == "0" || value.eq_ignore_ascii_case("false"))
}

#[cfg(test)]
mod tests {
    use super::says_yes;

    #[test]
    fn ci_is_any_value_but_nothing_zero_and_false() {
        for value in ["true", "1", "TRUE", "yes", "github"] {
            assert!(says_yes(value), "{value}");
        }
        for value in ["", "0", "false", "False"] {
            assert!(!says_yes(value), "{value}");
        }
    }
}
