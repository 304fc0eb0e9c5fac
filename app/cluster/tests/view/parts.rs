//! Pages that hold more than a screen: what each of them lists, and that each has its turn.

use crate::support::probe::*;
use crate::support::*;
use cluster::Button;
use cluster::page::{Chapter, Count, Page, VALUES};
use protocol_core::model::Value;
use protocol_core::vehicle::Node;
use std::collections::BTreeSet;

#[test]
fn a_chapter_lists_values_or_counters_that_fit_and_no_value_stands_in_two() {
    let mut listed = BTreeSet::new();
    for &chapter in Chapter::ALL {
        let items = chapter.items();
        assert_eq!(items.is_empty(), chapter == Chapter::Bus, "{chapter:?}: only the bus has counters");
        assert!(items.len() <= VALUES, "{chapter:?}");
        for item in items {
            assert!(listed.insert(item.value), "{} stands in two chapters", item.value.path());
        }
    }
    assert!(Count::ALL.len() <= VALUES);
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
