//! Small blocks around the core: SYSINFO, SYSCFG, TBMAN, VREG, BUSCTRL and the QSPI pins.
//!
//! Plain registers with their reset values and the few bits that firmware reads back.
//!
//! Source: RP2040 datasheet 2.20 (SYSINFO), 2.21 (SYSCFG), 2.22 (TBMAN), 2.10 (VREG), 2.1.5 (BUSCTRL), 2.19 (QSPI).
//!
//! Not modelled: NMI masks, memory power-down, brown-out, bus performance counters (they read 0), QSPI interrupts.

/// RP2040 B2.
const CHIP_ID: u32 = 0x2000_2927;
const PLATFORM_ASIC: u32 = 1 << 1;
const GITREF: u32 = 0xe0c9_12e8;
const VREG_ROK: u32 = 1 << 12;
const HAD_POR: u32 = 1 << 8;
/// Offset of IO_QSPI's CTRL register of the chip-select pin.
const QSPI_SS_CTRL: u32 = 0x0c;

#[derive(Clone, Debug)]
pub(super) struct System {
    syscfg: [u32; 7],
    vreg: u32,
    brown_out: u32,
    bus_priority: u32,
    performance_selects: [u32; 4],
    qspi_ctrl: [u32; 6],
    qspi_interrupts: [u32; 10],
    qspi_pads: [u32; 7],
}

const SYSCFG_RESET: [u32; 7] = [0, 0, 0x1000_0000, 0, 0, 0x66, 0];
const QSPI_PADS_RESET: [u32; 7] = [0, 0x56, 0x52, 0x52, 0x52, 0x52, 0x5a];

impl System {
    pub(super) fn new() -> Self {
        Self {
            syscfg: SYSCFG_RESET,
            vreg: 0xb1,
            brown_out: 0x91,
            bus_priority: 0,
            performance_selects: [0x1f; 4],
            qspi_ctrl: [0x1f; 6],
            qspi_interrupts: [0; 10],
            qspi_pads: QSPI_PADS_RESET,
        }
    }

    pub(super) fn reset_syscfg(&mut self) {
        self.syscfg = SYSCFG_RESET;
    }

    pub(super) fn reset_busctrl(&mut self) {
        self.bus_priority = 0;
        self.performance_selects = [0x1f; 4];
    }

    pub(super) fn reset_qspi_bank(&mut self) {
        self.qspi_ctrl = [0x1f; 6];
        self.qspi_interrupts = [0; 10];
    }

    pub(super) fn reset_qspi_pads(&mut self) {
        self.qspi_pads = QSPI_PADS_RESET;
    }

    pub(super) fn read_sysinfo(offset: u32) -> Option<u32> {
        Some(match offset {
            0x00 => CHIP_ID,
            0x04 => PLATFORM_ASIC,
            0x40 => GITREF,
            _ => return None,
        })
    }

    pub(super) fn read_tbman(offset: u32) -> Option<u32> {
        (offset == 0).then_some(5)
    }

    pub(super) fn read_syscfg(&self, offset: u32) -> Option<u32> {
        self.syscfg.get(offset as usize / 4).copied()
    }

    pub(super) fn write_syscfg(&mut self, offset: u32, value: u32) -> Option<()> {
        match (offset, value) {
            (0x00, 0) | (0x04 | 0x08 | 0x0c | 0x10 | 0x14, _) | (0x18, 0) => {
                self.syscfg[offset as usize / 4] = value;
                Some(())
            }
            _ => None, // NMI sources and memory power-down would change behaviour
        }
    }

    pub(super) fn read_vreg(&self, offset: u32) -> Option<u32> {
        Some(match offset {
            0x0 => self.vreg | VREG_ROK,
            0x4 => self.brown_out,
            0x8 => HAD_POR,
            _ => return None,
        })
    }

    pub(super) fn write_vreg(&mut self, offset: u32, value: u32) -> Option<()> {
        match offset {
            0x0 => self.vreg = value & 0xf3,
            0x4 => self.brown_out = value & 0xf1,
            0x8 => {}
            _ => return None,
        }
        Some(())
    }

    pub(super) fn read_busctrl(&self, offset: u32) -> Option<u32> {
        Some(match offset {
            0x00 => self.bus_priority,
            0x04 => 1,
            0x08 | 0x10 | 0x18 | 0x20 => 0,
            0x0c | 0x14 | 0x1c | 0x24 => self.performance_selects[(offset as usize - 0x0c) / 8],
            _ => return None,
        })
    }

    pub(super) fn write_busctrl(&mut self, offset: u32, value: u32) -> Option<()> {
        match offset {
            0x00 => self.bus_priority = value & 0x1111,
            0x04 | 0x08 | 0x10 | 0x18 | 0x20 => {}
            0x0c | 0x14 | 0x1c | 0x24 => {
                self.performance_selects[(offset as usize - 0x0c) / 8] = value & 0x1f;
            }
            _ => return None,
        }
        Some(())
    }

    pub(super) fn read_qspi_bank(&self, offset: u32) -> Option<u32> {
        Some(match offset {
            0x00..=0x2c if offset & 4 == 0 => 0,
            0x00..=0x2c => self.qspi_ctrl[offset as usize / 8],
            0x30..=0x54 => self.qspi_interrupts[(offset as usize - 0x30) / 4],
            _ => return None,
        })
    }

    /// Writes IO_QSPI; `Some(Some(_))` when chip select is forced anew: see `Xip::force_select`.
    pub(super) fn write_qspi_bank(&mut self, offset: u32, value: u32) -> Option<Option<Option<bool>>> {
        match offset {
            0x00..=0x2c if offset & 4 == 0 => {}
            0x00..=0x2c => {
                self.qspi_ctrl[offset as usize / 8] = value & 0x3003_331f;
                if offset == QSPI_SS_CTRL {
                    return Some(Some(match value >> 8 & 3 {
                        2 => Some(false),
                        3 => Some(true),
                        _ => None,
                    }));
                }
            }
            0x30..=0x54 => self.qspi_interrupts[(offset as usize - 0x30) / 4] = value,
            _ => return None,
        }
        Some(None)
    }

    pub(super) fn read_qspi_pads(&self, offset: u32) -> Option<u32> {
        self.qspi_pads.get(offset as usize / 4).copied()
    }

    pub(super) fn write_qspi_pads(&mut self, offset: u32, value: u32) -> Option<()> {
        *self.qspi_pads.get_mut(offset as usize / 4)? = value & 0xff;
        Some(())
    }
}
