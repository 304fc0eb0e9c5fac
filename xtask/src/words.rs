//! The words in which the tools speak of what a cluster shows.
//!
//! Owns no word: they are those of the cluster's tables.

/// Returns what a page's number stands for.
pub fn page(number: u8) -> String {
    cluster::page::key_of(number).map_or(number.to_string(), str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_of_a_newer_firmware_is_its_number() {
        assert_eq!([1, 3, 9].map(page), ["trip_a", "energy", "codes"]);
        assert_eq!(page(200), "200");
    }
}
