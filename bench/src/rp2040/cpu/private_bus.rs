//! The private peripheral bus: SysTick, NVIC, SCB and MPU registers from 0xE000_E000.
//!
//! Owns the register map, one line per register, and the System Control Block's own state. A register that is not in
//! the table stops the run loudly.
//!
//! Source: ARMv6-M Architecture Reference Manual, B3.2 to B3.5; RP2040 datasheet 2.4.8 for the values that the
//! implementer chose. Not supported: the MPU protects nothing, its registers are storage (RP2040 has 8 regions).

use super::exceptions::{EXTERNAL, HARD_FAULT, NMI, PEND_SV, SV_CALL, SYS_TICK};
use super::{Cpu, Escape, FaultCause};
use crate::rp2040::bus::Width;

/// First address that the core does not pass to the bus.
pub(super) const PRIVATE_BASE: u32 = 0xE000_0000;

const ACTLR: u32 = 0xE000_E008;
const SYST_CSR: u32 = 0xE000_E010;
const SYST_RVR: u32 = 0xE000_E014;
const SYST_CVR: u32 = 0xE000_E018;
const SYST_CALIB: u32 = 0xE000_E01C;
const NVIC_ISER: u32 = 0xE000_E100;
const NVIC_ICER: u32 = 0xE000_E180;
const NVIC_ISPR: u32 = 0xE000_E200;
const NVIC_ICPR: u32 = 0xE000_E280;
const NVIC_IPR0: u32 = 0xE000_E400;
const NVIC_IPR7: u32 = 0xE000_E41C;
const CPUID: u32 = 0xE000_ED00;
const ICSR: u32 = 0xE000_ED04;
const VTOR: u32 = 0xE000_ED08;
const AIRCR: u32 = 0xE000_ED0C;
const SCR: u32 = 0xE000_ED10;
const CCR: u32 = 0xE000_ED14;
const SHPR2: u32 = 0xE000_ED1C;
const SHPR3: u32 = 0xE000_ED20;
const SHCSR: u32 = 0xE000_ED24;
const DFSR: u32 = 0xE000_ED30;
const MPU_TYPE: u32 = 0xE000_ED90;
const MPU_CTRL: u32 = 0xE000_ED94;
const MPU_RNR: u32 = 0xE000_ED98;
const MPU_RBAR: u32 = 0xE000_ED9C;
const MPU_RASR: u32 = 0xE000_EDA0;
const DHCSR: u32 = 0xE000_EDF0;

/// Cortex-M0+ r0p1.
const CPUID_M0PLUS_R0P1: u32 = 0x410C_C601;
/// Eight unified regions.
const MPU_EIGHT_REGIONS: u32 = 8 << 8;
/// STKALIGN and UNALIGN_TRP: both always on in ARMv6-M.
const CCR_FIXED: u32 = 1 << 9 | 1 << 3;
const VECTOR_KEY: u32 = 0x05FA;
/// What VECTKEY reads as.
const VECTOR_KEY_STATUS: u32 = 0xFA05 << 16;
const SYSRESETREQ: u32 = 1 << 2;

const ICSR_NMIPENDSET: u32 = 1 << 31;
const ICSR_PENDSVSET: u32 = 1 << 28;
const ICSR_PENDSVCLR: u32 = 1 << 27;
const ICSR_PENDSTSET: u32 = 1 << 26;
const ICSR_PENDSTCLR: u32 = 1 << 25;
const ICSR_ISRPENDING: u32 = 1 << 22;
const SHCSR_SVCALLPENDED: u32 = 1 << 15;

/// Sleep when the last handler returns.
pub(super) const SCR_SLEEPONEXIT: u32 = 1 << 1;
const SCR_SLEEPDEEP: u32 = 1 << 2;
/// An interrupt that becomes pending is a WFE event even when disabled.
pub(super) const SCR_SEVONPEND: u32 = 1 << 4;

/// System Control Block and MPU storage.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct SystemControl {
    pub(super) vector_table: u32,
    pub(super) scr: u32,
    mpu_control: u32,
    mpu_region: u32,
    mpu_regions: [(u32, u32); 8],
}

impl SystemControl {
    fn region(&mut self) -> &mut (u32, u32) {
        &mut self.mpu_regions[(self.mpu_region & 7) as usize]
    }
}

impl Cpu {
    /// Loads from the private peripheral bus.
    #[cold]
    pub(super) fn load_private(&mut self, address: u32, width: Width) -> Result<u32, Escape> {
        if !self.is_privileged() {
            return Err(Escape::Fault(FaultCause::Load { address }));
        }
        // Only words: ARMv6-M leaves narrower accesses UNPREDICTABLE (B3.1.1).
        if width != Width::Word {
            return Err(Escape::Unmodelled { address });
        }
        Ok(match address {
            SYST_CSR => self.systick.read_control(),
            SYST_RVR => self.systick.reload(),
            SYST_CVR => self.systick.current(),
            NVIC_ISER | NVIC_ICER => self.exceptions.enabled_external(),
            NVIC_ISPR | NVIC_ICPR => self.exceptions.pending_external(),
            NVIC_IPR0..=NVIC_IPR7 => self.external_priorities(address - NVIC_IPR0),
            CPUID => CPUID_M0PLUS_R0P1,
            ICSR => self.interrupt_state(),
            VTOR => self.system.vector_table,
            AIRCR => VECTOR_KEY_STATUS,
            SCR => self.system.scr,
            CCR => CCR_FIXED,
            SHPR2 => self.exceptions.priority_byte(SV_CALL) << 24,
            SHPR3 => {
                self.exceptions.priority_byte(PEND_SV) << 16 | self.exceptions.priority_byte(SYS_TICK) << 24
            }
            SHCSR if self.exceptions.is_pending(SV_CALL) => SHCSR_SVCALLPENDED,
            // No auxiliary controls, no calibration value, no debugger.
            ACTLR | SYST_CALIB | SHCSR | DFSR | DHCSR => 0,
            MPU_TYPE => MPU_EIGHT_REGIONS,
            MPU_CTRL => self.system.mpu_control,
            MPU_RNR => self.system.mpu_region,
            MPU_RBAR => self.system.region().0 | self.system.mpu_region,
            MPU_RASR => self.system.region().1,
            _ => return Err(Escape::Unmodelled { address }),
        })
    }

    /// Stores to the private peripheral bus.
    #[cold]
    pub(super) fn store_private(&mut self, address: u32, width: Width, value: u32) -> Result<(), Escape> {
        if !self.is_privileged() {
            return Err(Escape::Fault(FaultCause::Store { address }));
        }
        if width != Width::Word {
            return Err(Escape::Unmodelled { address });
        }
        let enabled = self.exceptions.enabled_external();
        match address {
            SYST_CSR => {
                if !self.systick.write_control(value) {
                    return Err(Escape::Unmodelled { address });
                }
            }
            SYST_RVR => self.systick.write_reload(value),
            SYST_CVR => self.systick.clear_current(),
            NVIC_ISER => self.exceptions.set_enabled_external(enabled | value),
            NVIC_ICER => self.exceptions.set_enabled_external(enabled & !value),
            NVIC_ISPR => self.pend(u64::from(value) << EXTERNAL),
            NVIC_ICPR => self.exceptions.unpend_external(value),
            NVIC_IPR0..=NVIC_IPR7 => {
                for (number, byte) in (EXTERNAL + (address - NVIC_IPR0)..).zip(value.to_le_bytes()) {
                    self.exceptions.set_priority_byte(number, u32::from(byte));
                }
            }
            ICSR => self.write_interrupt_state(value),
            VTOR => self.system.vector_table = value & !0xFF,
            AIRCR => self.reset_request |= value >> 16 == VECTOR_KEY && value & SYSRESETREQ != 0,
            SCR => self.system.scr = value & (SCR_SLEEPONEXIT | SCR_SLEEPDEEP | SCR_SEVONPEND),
            SHPR2 => self.exceptions.set_priority_byte(SV_CALL, value >> 24),
            SHPR3 => {
                self.exceptions.set_priority_byte(PEND_SV, value >> 16 & 0xFF);
                self.exceptions.set_priority_byte(SYS_TICK, value >> 24);
            }
            MPU_CTRL => self.system.mpu_control = value & 7,
            MPU_RNR => self.system.mpu_region = value & 7,
            MPU_RBAR => {
                // VALID selects the region in the same write.
                if value & 1 << 4 != 0 {
                    self.system.mpu_region = value & 7;
                }
                self.system.region().0 = value & !0xFF;
            }
            MPU_RASR => self.system.region().1 = value & 0x1707_FF3F,
            // Read-only or without effect on this chip.
            CPUID | CCR | SYST_CALIB | ACTLR | SHCSR | DFSR | MPU_TYPE => {}
            _ => return Err(Escape::Unmodelled { address }),
        }
        self.refresh();
        Ok(())
    }

    /// Four external interrupts' priority bytes, the lowest number in the low byte.
    fn external_priorities(&self, first: u32) -> u32 {
        (0..4).map(|lane| self.exceptions.priority_byte(EXTERNAL + first + lane) << (8 * lane)).sum()
    }

    fn interrupt_state(&self) -> u32 {
        let pending = [(NMI, ICSR_NMIPENDSET), (PEND_SV, ICSR_PENDSVSET), (SYS_TICK, ICSR_PENDSTSET)];
        let mut value = self.ipsr;
        for (number, bit) in pending {
            if self.exceptions.is_pending(number) {
                value |= bit;
            }
        }
        if self.exceptions.pending_external() != 0 {
            value |= ICSR_ISRPENDING;
        }
        debug_assert!(!self.exceptions.is_pending(HARD_FAULT), "HardFault is always taken at once");
        value | self.exceptions.most_urgent().map_or(0, |(number, _)| number << 12)
    }

    fn write_interrupt_state(&mut self, value: u32) {
        if value & ICSR_PENDSVCLR != 0 {
            self.exceptions.unpend(PEND_SV);
        }
        if value & ICSR_PENDSTCLR != 0 {
            self.exceptions.unpend(SYS_TICK);
        }
        for (number, bit) in [(NMI, ICSR_NMIPENDSET), (PEND_SV, ICSR_PENDSVSET), (SYS_TICK, ICSR_PENDSTSET)] {
            if value & bit != 0 {
                self.pend(1 << number);
            }
        }
    }
}
