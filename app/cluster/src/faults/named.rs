//! A fault as records, scenarios and tools name it: its row, its stage and its code.
//!
//! Three numbers from which every word is found again. Refuses to know when a fault is active.

use super::table::{FaultId, When, Words};
use crate::text::Text;
use protocol_core::model::Severity;
use protocol_core::vehicle::{FaultText, Vehicle};

/// Which fault, how far it has come, by which code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Named {
    /// The row.
    pub fault: FaultId,
    /// Place among the row's texts, from 0: see [`Words`].
    pub stage: u8,
    /// Its code; of an alarm bit its number, from 1.
    pub code: Option<u16>,
}

impl Named {
    /// Returns the fault in its first stage and without a code.
    pub const fn of(fault: FaultId) -> Self {
        Self { fault, stage: 0, code: None }
    }

    /// Returns the fault of the numbers of a record; `None` = no row has this number.
    pub fn of_record(fault: u8, stage: u8, code: Option<u16>) -> Option<Self> {
        Some(Self { fault: FaultId::from_number(fault)?, stage, code })
    }

    /// Returns the fault with this code, in the stage of its severity if it has stages for levels.
    ///
    /// The driver reads the number that the vehicle's own documents use.
    pub fn graded(fault: FaultId, code: Option<u16>, severity: Severity, vehicle: &Vehicle) -> Self {
        let from_mildest = match severity {
            Severity::None | Severity::Warn => 0,
            Severity::Derate => 1,
            Severity::Stop => 2,
        };
        let stage = match fault.row().words {
            Words::Levels(_) if vehicle.worst_level == 1 => 2 - from_mildest,
            Words::Levels(_) => from_mildest,
            _ => 0,
        };
        Self { fault, stage, code }
    }

    /// Returns what the driver reads.
    pub fn text(self, vehicle: &Vehicle) -> Text {
        if let Some(&FaultText { zh, en, .. }) = self.explained(vehicle) {
            return Text { zh, en };
        }
        let texts = self.fault.row().words.texts();
        let text = texts.get(usize::from(self.stage)).or(texts.first());
        text.copied().unwrap_or(Text { zh: vehicle.zh, en: vehicle.en })
    }

    /// Returns what the vehicle's documents say of the code.
    pub fn explained(self, vehicle: &Vehicle) -> Option<&'static FaultText> {
        let code = self.code?;
        self.fault.row().codes.iter().find_map(|&node| vehicle.fault(node, code))
    }

    /// Returns the code as the driver reads it: the number of a bit is nothing that a document prints.
    pub fn printed_code(self) -> Option<u16> {
        let is_bit = self.fault.row().routes.iter().any(|route| matches!(route.when, When::Bits(_)));
        self.code.filter(|_| !is_bit)
    }

    /// Returns the public name of the stage; `None` = there is only one.
    pub fn stage_key(self) -> Option<&'static str> {
        self.fault.row().words.stages().get(usize::from(self.stage)).copied()
    }
}
