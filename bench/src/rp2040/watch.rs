//! Watches the core: how long each interrupt's handler took, how long interrupts were masked, how deep the stack was.
//!
//! Looks after each instruction and changes nothing: a watched run is equal to one that is not, to the cycle. A handler
//! begins with its entry and ends behind its return, the stacking included; between two that are chained the time of
//! the change belongs to the first.

use super::cpu::Cpu;
use super::names;
use crate::time::Nanos;

/// Exception number of external interrupt 0.
const EXTERNAL: u32 = 16;
const SP: usize = 13;

/// What was seen of one external interrupt's handler.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Handler {
    /// Times that it ran to its end.
    pub runs: u64,
    /// Longest time of its own, without the handlers that preempted it.
    pub own: Nanos,
    /// Longest time from its entry to its end, with those.
    pub whole: Nanos,
}

/// What was seen since the watch began.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Watched {
    /// By number of the external interrupt.
    pub handlers: [Handler; 32],
    /// Entry of the first handler; `None` = there was none.
    pub first: Option<Nanos>,
    /// Longest time that PRIMASK was set, once a handler has run; the core was awake meanwhile.
    pub masked: Nanos,
    /// Lowest stack pointer.
    pub lowest_stack: u32,
}

impl Watched {
    /// The handler of the interrupt that the datasheet calls `name`, and the interrupt's number.
    pub fn handler(&self, name: &str) -> Option<(u32, Handler)> {
        (0..)
            .zip(names::IRQS)
            .find(|(_, irq)| *irq == name)
            .map(|(irq, _)| (irq, self.handlers[irq as usize]))
    }

    /// Every interrupt whose handler ran: its number, its name, what was seen.
    pub fn ran(&self) -> impl Iterator<Item = (u32, &'static str, Handler)> {
        let all = (0..).zip(names::IRQS).zip(self.handlers);
        all.map(|((irq, name), handler)| (irq, name, handler)).filter(|(.., handler)| handler.runs > 0)
    }
}

/// A handler that has begun.
#[derive(Clone, Copy, Debug)]
struct Open {
    exception: u32,
    since: Nanos,
    own: Nanos,
}

/// The watch itself.
#[derive(Clone, Debug)]
pub(super) struct Watch {
    seen: Watched,
    /// Handlers that have begun, the running one last.
    open: Vec<Open>,
    /// Since when the last of them runs.
    running_since: Nanos,
    /// What the core said last.
    active: u64,
    started: u32,
    masked_since: Option<Nanos>,
}

impl Watch {
    /// A watch that begins now; of handlers that have begun already nothing is counted.
    pub(super) fn new(cpu: &Cpu) -> Self {
        let seen = Watched {
            handlers: [Handler::default(); 32],
            first: None,
            masked: Nanos::ZERO,
            lowest_stack: u32::MAX,
        };
        Self {
            seen,
            open: Vec::new(),
            running_since: Nanos::ZERO,
            active: cpu.active_exceptions(),
            started: cpu.handlers_started(),
            masked_since: None,
        }
    }

    /// What was seen so far.
    pub(super) fn into_seen(self) -> Watched {
        self.seen
    }

    /// The core was reset: nothing that has begun will end.
    pub(super) fn restart(&mut self, cpu: &Cpu) {
        *self = Self { seen: self.seen.clone(), ..Self::new(cpu) };
    }

    /// Looks at the core behind an instruction; `time` gives its beginning and its end.
    #[inline]
    pub(super) fn look(&mut self, cpu: &Cpu, time: impl Fn() -> (Nanos, Nanos)) {
        self.seen.lowest_stack = self.seen.lowest_stack.min(cpu.registers[SP]);
        if (cpu.active_exceptions(), cpu.handlers_started()) != (self.active, self.started) {
            self.change(cpu, time());
        }
        let is_masked = cpu.interrupts_masked() && !cpu.is_sleeping();
        if is_masked != self.masked_since.is_some() {
            self.mask(is_masked, time().1);
        }
    }

    #[cold]
    fn change(&mut self, cpu: &Cpu, (from, to): (Nanos, Nanos)) {
        let (active, started) = (cpu.active_exceptions(), cpu.handlers_started());
        let has_begun = started != self.started;
        let has_ended = self.active & !active != 0 || has_begun && active == self.active;
        (self.active, self.started) = (active, started);
        if has_ended {
            self.end(to);
        }
        if has_begun {
            let at = if has_ended { to } else { from };
            if let Some(preempted) = self.open.last_mut() {
                preempted.own += at.since(self.running_since);
            }
            self.open.push(Open { exception: cpu.active_exception(), since: at, own: Nanos::ZERO });
            self.running_since = at;
            self.seen.first.get_or_insert(at);
        }
    }

    fn end(&mut self, at: Nanos) {
        // Whatever began before the watch is not here.
        let Some(ended) = self.open.pop() else { return };
        let own = ended.own + at.since(self.running_since);
        self.running_since = at;
        let irq = ended.exception.checked_sub(EXTERNAL).map(|irq| irq as usize);
        if let Some(handler) = irq.and_then(|irq| self.seen.handlers.get_mut(irq)) {
            handler.runs += 1;
            handler.own = handler.own.max(own);
            handler.whole = handler.whole.max(at.since(ended.since));
        }
    }

    #[cold]
    fn mask(&mut self, is_masked: bool, at: Nanos) {
        let since = self.masked_since.take();
        if is_masked {
            self.masked_since = Some(at);
        } else if let Some(since) = since.filter(|_| self.started > 0) {
            self.seen.masked = self.seen.masked.max(at.since(since));
        }
    }
}
