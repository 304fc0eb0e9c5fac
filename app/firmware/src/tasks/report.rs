//! Every 200 ms: records for a PC, as far as the link takes them.
//!
//! One round is about 600 bytes, 3 kB a second of the 11.5 that the line takes. Which faults are
//! reported in one round is `cluster::instrument::rota`'s business.

use cluster::instrument::rota::Rota;
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
    let (mut active, mut remembered) = (Rota::new(), Rota::new());
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
        if !active.round(now, of, &mut send) {
            send(&telemetry::ALL_CLEAR);
        }
        let of = |place| cx.shared.instrument.lock(|it| telemetry::remembered(it.cluster(), place));
        remembered.round(now, of, &mut send);

        round = round.wrapping_add(1);
        next += PERIOD_MS.millis();
        Mono::delay_until(next).await;
    }
}
