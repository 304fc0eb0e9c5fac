//! The parts of pages that hold more than a screen: what each of them lists, and that each has its turn.

use crate::support::probe::*;
use crate::support::*;
use cluster::Button;
use cluster::page::{CELLS, Count, Page, Part};
use protocol_core::model::Value;
use protocol_core::vehicle::Node;
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

#[test]
fn turning_goes_through_every_part_of_the_history_once() {
    let mut drive = healthy();
    // Nine faults that come and go: three parts of at most four rows.
    drive.keep(Node::Dcdc, Value::DcdcState, 2);
    for code in 1..=9 {
        drive.keep(Node::Dcdc, Value::DcdcFaultCode, code);
        drive.run(CYCLE);
    }
    drive.keep(Node::Dcdc, Value::DcdcState, 1);
    drive.run(CYCLE);
    let mut turned = Vec::new();
    for _ in 0..20 {
        let now = drive.last();
        drive.cluster.press(Button::Next, now);
        match drive.view().page {
            Page::Main => break,
            Page::History(list) => {
                turned.push((list.position, list.count, list.rows.into_iter().flatten().count()));
            }
            _ => {}
        }
    }
    assert_eq!(turned, [(1, 3, 4), (2, 3, 4), (3, 3, 1)]);
}
