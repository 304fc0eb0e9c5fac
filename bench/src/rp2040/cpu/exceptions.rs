//! Exceptions: which are pending, enabled and active, and who preempts whom.
//!
//! Owns the NVIC's state for all 48 exceptions as bit sets by exception number, and the priority rules. It moves no
//! registers: stacking and vectors are the core's business.
//!
//! Source: ARMv6-M Architecture Reference Manual, B1.5.4 (priorities) and B3.4 (NVIC). Two priority bits; all 32
//! external interrupts exist, of which RP2040 wires 0 to 25 and leaves 26 to 31 to software.

/// Exception numbers.
pub(super) const NMI: u32 = 2;
pub(super) const HARD_FAULT: u32 = 3;
pub(super) const SV_CALL: u32 = 11;
pub(super) const PEND_SV: u32 = 14;
pub(super) const SYS_TICK: u32 = 15;
/// Exception number of external interrupt 0.
pub(super) const EXTERNAL: u32 = 16;

const EXCEPTIONS: usize = 48;
const ALWAYS_ENABLED: u64 = 1 << NMI | 1 << HARD_FAULT | 1 << SV_CALL | 1 << PEND_SV | 1 << SYS_TICK;
/// Priority of thread mode: below every exception.
const THREAD_PRIORITY: i8 = 4;

/// Pending, enabled and active sets with their priorities.
#[derive(Clone, Debug)]
pub(super) struct Exceptions {
    pending: u64,
    enabled: u64,
    active: u64,
    /// Handlers started since reset, wrapping.
    started: u32,
    priority: [i8; EXCEPTIONS],
    /// Priority of what runs now, PRIMASK not counted.
    running: i8,
    /// Level of the external lines.
    lines: u32,
}

impl Exceptions {
    /// After reset; external lines that are already high pend at once.
    pub(super) fn new(lines: u32) -> Self {
        let mut priority = [0; EXCEPTIONS];
        priority[NMI as usize] = -2;
        priority[HARD_FAULT as usize] = -1;
        Self {
            pending: u64::from(lines) << EXTERNAL,
            enabled: ALWAYS_ENABLED,
            active: 0,
            started: 0,
            priority,
            running: THREAD_PRIORITY,
            lines,
        }
    }

    /// The most urgent exception that is pending and enabled: lowest priority value, then lowest number.
    pub(super) fn most_urgent(&self) -> Option<(u32, i8)> {
        let mut candidates = self.pending & self.enabled;
        let mut best = None;
        while candidates != 0 {
            let number = candidates.trailing_zeros();
            candidates &= candidates - 1;
            let priority = self.priority[number as usize];
            if best.is_none_or(|(_, urgent)| priority < urgent) {
                best = Some((number, priority));
            }
        }
        best
    }

    /// The exception that would preempt what runs now if PRIMASK were clear.
    pub(super) fn preempting(&self) -> Option<(u32, i8)> {
        self.most_urgent().filter(|&(_, priority)| priority < self.running)
    }

    /// The exception that is to be taken now. PRIMASK masks all but NMI and HardFault.
    pub(super) fn to_take(&self, primask: bool) -> Option<u32> {
        self.preempting().filter(|&(_, priority)| !primask || priority < 0).map(|(number, _)| number)
    }

    /// Whether SVC would be taken at once rather than become a HardFault.
    pub(super) fn allows_supervisor_call(&self, primask: bool) -> bool {
        !primask && self.priority[SV_CALL as usize] < self.running
    }

    /// Whether a fault can still become a HardFault.
    pub(super) const fn allows_hard_fault(&self) -> bool {
        self.running > -1
    }

    /// Pends a set of exceptions; `true` if one of them was not pending before.
    pub(super) fn pend(&mut self, set: u64) -> bool {
        let newly = set & !self.pending;
        self.pending |= set;
        newly != 0
    }

    pub(super) fn unpend(&mut self, number: u32) {
        self.pending &= !(1 << number);
    }

    /// Clears pending external interrupts. One whose line is still high stays pending.
    pub(super) fn unpend_external(&mut self, set: u32) {
        self.pending &= !(u64::from(set & !self.lines) << EXTERNAL);
    }

    /// Follows the lines: a rise latches pending. `true` if an interrupt became pending.
    pub(super) fn set_lines(&mut self, lines: u32) -> bool {
        let rising = lines & !self.lines;
        self.lines = lines;
        self.pend(u64::from(rising) << EXTERNAL)
    }

    pub(super) const fn lines(&self) -> u32 {
        self.lines
    }

    /// Starts an exception's handler.
    pub(super) fn activate(&mut self, number: u32) {
        self.pending &= !(1 << number);
        self.active |= 1 << number;
        self.started = self.started.wrapping_add(1);
        self.update_running();
    }

    /// Ends an exception's handler. A level that is still high pends again: `true` if it did.
    pub(super) fn deactivate(&mut self, number: u32) -> bool {
        self.active &= !(1 << number);
        self.update_running();
        self.pend((u64::from(self.lines) << EXTERNAL) & 1 << number)
    }

    /// How many handlers are nested.
    pub(super) const fn nesting(&self) -> u32 {
        self.active.count_ones()
    }

    pub(super) const fn active(&self) -> u64 {
        self.active
    }

    pub(super) const fn started(&self) -> u32 {
        self.started
    }

    pub(super) const fn is_active(&self, number: u32) -> bool {
        self.active >> number & 1 != 0
    }

    pub(super) const fn is_pending(&self, number: u32) -> bool {
        self.pending >> number & 1 != 0
    }

    #[expect(clippy::cast_possible_truncation, reason = "32 external interrupts")]
    pub(super) const fn pending_external(&self) -> u32 {
        (self.pending >> EXTERNAL) as u32
    }

    #[expect(clippy::cast_possible_truncation, reason = "32 external interrupts")]
    pub(super) const fn enabled_external(&self) -> u32 {
        (self.enabled >> EXTERNAL) as u32
    }

    pub(super) fn set_enabled_external(&mut self, set: u32) {
        self.enabled = ALWAYS_ENABLED | u64::from(set) << EXTERNAL;
    }

    /// Priority byte of an exception as registers show it: bits 7:6.
    pub(super) fn priority_byte(&self, number: u32) -> u32 {
        u32::from(self.priority[number as usize].cast_unsigned() & 3) << 6
    }

    pub(super) fn set_priority_byte(&mut self, number: u32, byte: u32) {
        self.priority[number as usize] = match byte >> 6 & 3 {
            0 => 0,
            1 => 1,
            2 => 2,
            _ => 3,
        };
        self.update_running();
    }

    fn update_running(&mut self) {
        let mut active = self.active;
        let mut running = THREAD_PRIORITY;
        while active != 0 {
            running = running.min(self.priority[active.trailing_zeros() as usize]);
            active &= active - 1;
        }
        self.running = running;
    }
}
