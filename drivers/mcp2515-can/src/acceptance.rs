//! Acceptance filters: from identifiers to the mask and filter registers.
//!
//! Pure. A mask of zero lets every identifier through, but the kind of identifier still counts: to take both, one
//! filter of RXB0 is for 11 bits and one for 29; RXB1 takes what rolls over from RXB0.
//! Source: DS20001801 section 4.5 and registers 4-10 to 4-17.

use crate::frame;
use crate::regs::IDE;
use embedded_can::Id;

/// Identifiers that the hardware lets through. A frame passes if, under its mask, it equals one of the filters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Acceptance {
    /// Mask 0 serves filters 0 and 1 (RXB0), mask 1 serves filters 2 to 5 (RXB1).
    pub masks: [Id; 2],
    /// RXF0 to RXF5; the first two belong to RXB0.
    pub filters: [Id; 6],
}

/// SIDH, SIDL, EID8 and EID0 of each mask and filter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Registers {
    /// RXM0 and RXM1.
    pub masks: [[u8; 4]; 2],
    /// RXF0 to RXF5.
    pub filters: [[u8; 4]; 6],
}

impl Registers {
    /// Every data frame of either kind passes.
    pub const EVERYTHING: Self = {
        let mut filters = [[0; 4]; 6];
        filters[1] = [0, IDE, 0, 0];
        Self { masks: [[0; 4]; 2], filters }
    };

    /// Returns the registers for `acceptance`.
    pub fn of(acceptance: &Acceptance) -> Self {
        let mask = |id| {
            let [sidh, sidl, eid8, eid0] = frame::id_registers(id);
            // A mask has no kind: the bit is unimplemented and reads as zero.
            [sidh, sidl & !IDE, eid8, eid0]
        };
        Self { masks: acceptance.masks.map(mask), filters: acceptance.filters.map(frame::id_registers) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_can::{ExtendedId, StandardId};
    use mcp2515::filter::{RxFilterReg, RxMaskReg};
    use proptest::prelude::*;

    fn id() -> impl Strategy<Value = Id> {
        prop_oneof![
            (0..=StandardId::MAX.as_raw()).prop_map(|raw| StandardId::new(raw).unwrap().into()),
            (0..=ExtendedId::MAX.as_raw()).prop_map(|raw| ExtendedId::new(raw).unwrap().into()),
        ]
    }

    /// The `mcp2515` crate gives them from EID0 to SIDH.
    fn reversed(mut bytes: [u8; 4]) -> [u8; 4] {
        bytes.reverse();
        bytes
    }

    proptest! {
        // A second reading of the datasheet: that of the `mcp2515` crate.
        #[test]
        fn masks_and_filters_are_those_of_the_mcp2515_crate(
            masks in prop::array::uniform2(id()),
            filters in prop::array::uniform6(id()),
        ) {
            let registers = Registers::of(&Acceptance { masks, filters });
            prop_assert_eq!(registers.masks, masks.map(|id| reversed(RxMaskReg::from_id(id).into_bytes())));
            prop_assert_eq!(
                registers.filters,
                filters.map(|id| reversed(RxFilterReg::from_id(id).into_bytes()))
            );
        }
    }

    #[test]
    fn without_filters_one_of_rxb0_takes_11_bits_and_the_other_29() {
        let any = |id: Id| RxFilterReg::from_id(id).into_bytes();
        let [first, second, ..] = Registers::EVERYTHING.filters;
        assert_eq!(reversed(first), any(StandardId::ZERO.into()));
        assert_eq!(reversed(second), any(ExtendedId::ZERO.into()));
        assert_eq!(Registers::EVERYTHING.masks, [[0; 4]; 2]);
    }
}
