//! The words in which the tools speak of what a cluster shows.
//!
//! Owns no row: a variant's name is its word, and a page's number is the cluster's own.

/// Returns what a page's number stands for.
pub fn page(number: u8) -> String {
    cluster::page::key_of(number).map_or(number.to_string(), str::to_owned)
}

/// Returns the name of a variant as words: `LowCharge` -> `low charge`.
pub fn word(variant: impl std::fmt::Debug) -> String {
    let mut words = String::new();
    for letter in format!("{variant:?}").chars() {
        if letter.is_ascii_uppercase() && !words.is_empty() {
            words.push(' ');
        }
        words.push(letter.to_ascii_lowercase());
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use cluster::Sound;

    #[test]
    fn variants_read_as_words() {
        assert_eq!(word(Sound::Stop), "stop");
    }

    #[test]
    fn a_page_of_a_newer_firmware_is_its_number() {
        assert_eq!(page(9), "codes");
        assert_eq!(page(200), "200");
    }
}
