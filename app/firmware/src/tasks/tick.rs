//! Every 10 ms: frames and inputs to the instrument, frames, sounds and views out of it.
//!
//! A view goes out as soon as it looks different from the last one. What is to be kept goes into flash, one program a
//! tick. Feeds the watchdog.

use cluster::View;
use pico::{Buzzer, Led, now_us};
use protocol_core::{CanFrame, Millis};
use rtic::mutex_prelude::*;
use rtic_monotonics::Timebase;
use rtic_monotonics::fugit::ExtU64;

use crate::app::{Mono, tick::Context};
use crate::can_node::Care;
use crate::queue::{FrameReader, Stamped};
use crate::tasks::draw;
use crate::telemetry;

/// Period of the tick in milliseconds.
const PERIOD_MS: u64 = 10;
/// Ticks between two views that go out without a change: `draw` answers each, and so keeps the watchdog fed.
const LOOK_TICKS: u32 = 5;
/// Ticks between two looks at the CAN controller.
const SUPERVISE_TICKS: u32 = 10;
/// Ticks that `draw` may take for one picture before the watchdog is no longer fed: 500 ms, twice the longest.
const DRAW_LIMIT_TICKS: u32 = 50;
/// Frames taken out of the queue in one tick: what it holds.
const FRAMES_PER_TICK: usize = 128;

/// Feeds the watchdog as long as `draw` makes progress.
pub struct Watch {
    watchdog: pico::Watchdog,
    drawn: u32,
    idle_ticks: u32,
}

impl Watch {
    /// Takes the running watchdog.
    pub const fn new(watchdog: pico::Watchdog) -> Self {
        Self { watchdog, drawn: 0, idle_ticks: 0 }
    }

    fn tick(&mut self) {
        let drawn = draw::progress();
        self.idle_ticks = if drawn == self.drawn { self.idle_ticks.saturating_add(1) } else { 0 };
        self.drawn = drawn;
        if self.idle_ticks <= DRAW_LIMIT_TICKS {
            self.watchdog.feed();
        }
    }
}

/// Runs the instrument, for ever.
pub async fn tick(cx: Context<'_>) {
    let local = cx.local;
    let (mut can, mut instrument) = (cx.shared.can, cx.shared.instrument);
    instrument.lock(|instrument| instrument.restarted(telemetry::restart(cx.shared.boot)));
    let mut next = Mono::now();
    let mut ticks: u32 = 0;
    // The view that went out last.
    let mut last = View::default();
    loop {
        let now = Millis(now_us() / 1_000);
        let inputs = local.wires.sample();
        instrument.lock(|instrument| {
            receive(local.frames_out, |frame, at| {
                instrument.hear(frame, at);
            });
            instrument.tick(&inputs, now);
            sound(local.buzzer, instrument.chime(now));
        });

        // The second tick is the first of these: by then the panel has been woken and no longer waits for the CPU.
        let supervise = ticks % SUPERVISE_TICKS == 1;
        let care = (&mut can, &mut instrument).lock(|can, instrument| {
            can.arm();
            instrument.offer(|frame| can.transmit(frame, now.0));
            if supervise { can.supervise(now.0) } else { Care::Nothing }
        });
        match care {
            Care::Nothing => {}
            Care::Poll => rtic::pend(pico::pac::Interrupt::IO_IRQ_BANK0),
            Care::Attempt(attempt) => {
                let outcome = attempt.run();
                can.lock(|can| can.finish(outcome));
            }
        }
        let care = (&mut can, &mut instrument).lock(|can, instrument| {
            let access = instrument.look(|| can.take_message_error(), now);
            can.follow(access)
        });
        if let Care::Attempt(attempt) = care {
            let outcome = attempt.run();
            can.lock(|can| can.finish(outcome));
        }

        let is_due = ticks.is_multiple_of(LOOK_TICKS);
        if is_due {
            local.wires.look(telemetry::controller(can.lock(|can| can.status())));
        }
        let view = instrument.lock(|instrument| instrument.view(now));
        if is_due || !ui::looks_same(&last, &view) {
            show_life(local.led, view.heartbeat);
            local.views_in.write(view);
            last = view;
        }
        local.keeping.tick(&mut instrument, now);
        local.watch.tick();
        ticks = ticks.wrapping_add(1);
        next += PERIOD_MS.millis();
        Mono::delay_until(next).await;
    }
}

/// Hands over what is in the queue, with the time at which each frame was received.
fn receive(queue: &mut FrameReader, mut sink: impl FnMut(&CanFrame, Millis)) {
    for _ in 0..FRAMES_PER_TICK {
        let Some(Stamped { frame, at_us }) = queue.dequeue() else { return };
        // The stamp has 32 bits; its age tells the rest.
        let now = now_us();
        let age = (now as u32).wrapping_sub(at_us);
        sink(&frame, Millis((now - u64::from(age)) / 1_000));
    }
}

fn sound(buzzer: &mut Buzzer, chime: Option<cluster::Chime>) {
    buzzer.sound(chime.filter(|chime| chime.is_on).map(|chime| chime.frequency_hz));
}

fn show_life(led: &mut Led, lit: bool) {
    led.set(lit);
}
