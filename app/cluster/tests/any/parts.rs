//! The parts of the technical page: what each of them lists.

use cluster::page::{CELLS, Count, Part};
use std::collections::BTreeSet;

#[test]
fn a_part_lists_values_or_counters_that_fit_and_no_value_stands_on_two() {
    let mut listed = BTreeSet::new();
    for &part in Part::ALL {
        let values = part.values();
        assert_eq!(values.is_empty(), part == Part::Bus, "{part:?}: only the bus has counters");
        assert!(values.len() <= CELLS, "{part:?}");
        for value in values {
            assert!(listed.insert(value), "{} stands on two parts", value.path());
        }
    }
    assert!(Count::ALL.len() <= CELLS);
}
