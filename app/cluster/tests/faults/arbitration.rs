//! Properties of the message line over long random drives.

use crate::support::toy::*;
use crate::support::*;
use proptest::prelude::*;
use protocol_core::Severity;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// While the faults stay as they are, every line of the shown severity gets its turn, in order, none twice.
    #[test]
    fn every_line_of_the_shown_severity_gets_its_turn(
        level in 0u8..=3,
        code in prop_oneof![Just(0u16), Just(3), 100u16..400],
        battery in 0u8..=3,
        parts in prop::array::uniform3(1u8..=2),
        limits in 0u8..4,
        before in 0u64..50,
    ) {
        let mut drive = healthy();
        drive.run(before * TICK);
        drive.report(level, code);
        drive.battery_report(battery, 4);
        drive.repeat(PARTS, [parts[0], 1, parts[1], 2, parts[2], 3, 0, 0]);
        drive.repeat(DRIVE, [1, 0, 0, limits << 2, 0, 0, 0, 0]);
        drive.run(2 * CYCLE);
        let Some(first) = drive.view().line else {
            prop_assert_eq!(drive.view().severity, Severity::None);
            return Ok(());
        };
        let lines = drive.turns(2 * u64::from(first.count) + 1);
        for round in lines.windows(usize::from(first.count)) {
            let mut distinct = round.to_vec();
            distinct.sort();
            distinct.dedup();
            prop_assert_eq!(distinct.len(), usize::from(first.count), "{:?}", lines);
        }
        prop_assert!(lines.len() >= usize::from(first.count));
    }
}
