//! Every 200 ms: records for a PC, as far as the link takes them.
//!
//! One round is about 600 bytes, 3 kB a second of the 11.5 that the line takes. Faults are told when they come; beside that
//! one active and one remembered fault of each list is told in turn, for a PC that came later.

use pico::now_us;
use protocol_core::link::{CHUNK, MAX_FRAME, Record, encode};
use protocol_core::{Millis, Value};
use rtic::Mutex;
use rtic_monotonics::Timebase;
use rtic_monotonics::fugit::ExtU64;

use crate::app::{Mono, report::Context};
use crate::tasks::{draw, idle};
use crate::telemetry::{self, Measured};

/// Time between two rounds in milliseconds.
const PERIOD_MS: u64 = 200;
/// Rounds between two reports of health.
const HEALTH_ROUNDS: u32 = 5;
/// Rounds between two greetings, for a PC that came later.
const HELLO_ROUNDS: u32 = 25;

/// Faults that are told at once in one round, of each list: what comes in one burst beyond them waits for its turn.
const AT_ONCE: usize = 4;

/// Which faults of a list have been told.
struct Told {
    /// The next one whose turn it is.
    turn: usize,
    /// All that came before this have been told.
    until: Millis,
}

impl Told {
    const NONE: Self = Self { turn: 0, until: Millis(0) };

    /// Tells the new ones of a list and the one whose turn it is; returns whether the list has any.
    fn tell(
        &mut self,
        now: Millis,
        mut fault: impl FnMut(usize) -> Option<(Record, Millis)>,
        mut send: impl FnMut(&Record),
    ) -> bool {
        let (mut length, mut at_once) = (0, 0);
        while let Some((record, came)) = fault(length) {
            let is_new = came >= self.until && at_once < AT_ONCE;
            if is_new || length == self.turn {
                at_once += usize::from(is_new);
                send(&record);
            }
            length += 1;
        }
        self.turn = if self.turn + 1 < length { self.turn + 1 } else { 0 };
        self.until = now;
        length > 0
    }
}

/// How much the CPU slept since the last look.
struct Sleep {
    since_us: u64,
    slept_us: u32,
}

impl Sleep {
    fn permille(&mut self) -> u16 {
        let (now, slept) = (now_us(), idle::slept_us());
        let span = (now - self.since_us).max(1);
        let share = u64::from(slept.wrapping_sub(self.slept_us)) * 1_000 / span;
        *self = Self { since_us: now, slept_us: slept };
        share.min(1_000) as u16
    }
}

/// Reports, for ever.
pub async fn report(mut cx: Context<'_>) {
    let boot = *cx.shared.boot;
    let mut sleep = Sleep { since_us: now_us(), slept_us: idle::slept_us() };
    let mut next = Mono::now();
    let mut round: u32 = 0;
    // The vehicle of the last greeting: a new one is told at once.
    let mut greeted = None;
    let (mut active, mut remembered) = (Told::NONE, Told::NONE);
    loop {
        let mut send = |record: &Record| {
            let mut frame = [0; MAX_FRAME];
            if let Some(frame) = encode(record, &mut frame).and_then(|len| frame.get(..len)) {
                cx.shared.link.lock(|link| link.send(frame));
            }
        };
        let vehicle = cx.shared.instrument.lock(|instrument| instrument.cluster().vehicle());
        if round.is_multiple_of(HELLO_ROUNDS) || greeted != Some(vehicle.name) {
            greeted = Some(vehicle.name);
            send(&telemetry::hello(vehicle));
        }
        if round == 0
            && let Some(record) = telemetry::last_words(&boot)
        {
            send(&record);
        }
        if round % HEALTH_ROUNDS == HEALTH_ROUNDS - 1 {
            let (draws, max_draw_us) = draw::measured();
            let measured = Measured { draws, max_draw_us, idle_permille: sleep.permille() };
            let now_ms = now_us() / 1_000;
            let can = cx.shared.can.lock(|can| can.status());
            let counters = cx.shared.instrument.lock(|instrument| instrument.cluster().counters());
            send(&telemetry::health(can, counters, &boot, measured, now_ms));
        }
        for first in (0..Value::COUNT).step_by(CHUNK) {
            let now = Millis(now_us() / 1_000);
            let record = cx.shared.instrument.lock(|it| telemetry::values(it.cluster(), first, now));
            send(&record);
        }
        let record = cx.shared.shown.lock(|view| telemetry::screen(view, now_us() / 1_000));
        send(&record);
        if round.is_multiple_of(HEALTH_ROUNDS) {
            send(&cx.shared.shown.lock(|view| telemetry::trips(view)));
        }
        let now = Millis(now_us() / 1_000);
        let of = |place| cx.shared.instrument.lock(|it| telemetry::active(it.cluster(), place, now));
        if !active.tell(now, of, &mut send) {
            send(&telemetry::ALL_CLEAR);
        }
        let of = |place| cx.shared.instrument.lock(|it| telemetry::remembered(it.cluster(), place));
        remembered.tell(now, of, &mut send);

        round = round.wrapping_add(1);
        next += PERIOD_MS.millis();
        Mono::delay_until(next).await;
    }
}
