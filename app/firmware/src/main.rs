//! The instrument cluster on a Raspberry Pi Pico: wiring only.
//!
//! <!-- tasks: cargo xtask tasks -->
//! | task          | trigger       | priority | at start | later    | locals              | shared             |
//! |---------------|---------------|----------|----------|----------|---------------------|--------------------|
//! | `init`        | power-on      |          | < 20 ms  |          | memory, queue,      |                    |
//! |               |               |          |          |          | tile_a, tile_b      |                    |
//! | `can_service` | IO_IRQ_BANK0  | 4        | -        | < 49 us  | frames_in           | can                |
//! | `panel_done`  | DMA_IRQ_0     | 3        | < 16 us  | < 24 us  | tile_done_in        |                    |
//! | `link_done`   | DMA_IRQ_1     | 3        | < 16 us  | < 16 us  |                     | link               |
//! | `tick`        | every 10 ms   | 2        | < 13 ms  | < 7.4 ms | frames_out,         | can, instrument,   |
//! |               |               |          |          |          | views_in, wires,    | &boot              |
//! |               |               |          |          |          | buzzer, led, watch, |                    |
//! |               |               |          |          |          | keeping             |                    |
//! | `draw`        | views_out,    | 1        | < 2 ms   | < 18 ms  | panel, tiles,       | shown, &boot       |
//! |               | tile_done_out |          |          |          | backlight,          |                    |
//! |               |               |          |          |          | views_out,          |                    |
//! |               |               |          |          |          | tile_done_out       |                    |
//! | `report`      | every 200 ms  | 1        | < 2 ms   | < 18 ms  |                     | can, instrument,   |
//! |               |               |          |          |          |                     | shown, link, &boot |
//! | (no task)     | TIMER_IRQ_0   | 3        | < 29 us  | < 30 us  |                     |                    |
//! | `idle`        | nothing else  | 0        |          |          |                     |                    |
//!
//! Longest times on the bench, rustc 1.95.0: power-on, the 60 s city drive while pages turn, its frames back to back
//! for 5 s, the bus shorted for 1 s. At start: in the first 500 ms; `init` from power-on. Times are to a task's end
//! or its next `await`, without what interrupts it. `draw` and `report` run in one interrupt, whose times they have.
//! Interrupts masked: < 120 us; stack: < 22000 bytes.
//! <!-- /tasks -->
//!
//! Reception outranks everything and is never masked for longer than one lock of `can`: a frame of 47 bits at
//! 250 kbit/s leaves 376 us. `draw` and `report` give way to each other at every `await`, to all else at once.
//! `tick` feeds the watchdog, and only while `draw` makes progress: a cluster whose picture stands still is reset.
//!
//! The node only listens until the instrument is certain of the vehicle, at the bit rate at which frames are heard
//! (`cluster::instrument`).
//!
//! Words of a panic or hard fault are kept over the reset, reported, and shown.

#![no_std]
#![no_main]
#![allow(
    unreachable_pub,
    reason = "nothing is reachable in a binary, and RTIC wants the types of its tasks public"
)]

mod can_node;
mod config;
mod keeping;
mod queue;
mod tasks;
mod telemetry;
mod wires;

use core::panic::PanicInfo;

use portable_atomic as _;

#[rtic::app(device = pico::pac, dispatchers = [SW0_IRQ, SW1_IRQ])]
mod app {
    use core::mem::MaybeUninit;

    use cluster::{Instrument, View};
    use pico::{Backlight, Boot, Buzzer, Led, LinkPort, Memory, PanelPort};
    use rtic_monotonics::rp2040::prelude::*;
    use rtic_sync::make_signal;
    use rtic_sync::signal::{SignalReader, SignalWriter};

    use crate::can_node::CanNode;
    use crate::config;
    use crate::keeping::Keeping;
    use crate::queue::{FrameQueue, FrameReader, FrameWriter};
    use crate::tasks::{TileBuffer, Watch, draw, idle, link_done, panel_done, report, tick};
    use crate::wires::Wires;

    rp2040_timer_monotonic!(Mono);

    #[shared]
    struct Shared {
        can: CanNode,
        instrument: Instrument,
        /// What the panel shows.
        shown: View,
        link: LinkPort,
        boot: Boot,
    }

    #[local]
    struct Local {
        frames_in: FrameWriter,
        frames_out: FrameReader,
        views_in: SignalWriter<'static, View>,
        views_out: SignalReader<'static, View>,
        tile_done_in: SignalWriter<'static, ()>,
        tile_done_out: SignalReader<'static, ()>,
        panel: PanelPort,
        tiles: [TileBuffer; 2],
        backlight: Backlight,
        wires: Wires,
        buzzer: Buzzer,
        led: Led,
        watch: Watch,
        keeping: Keeping,
    }

    #[init(local = [
        memory: Memory = Memory::new(),
        queue: FrameQueue = FrameQueue::new(),
        #[unsafe(link_section = ".uninit.tiles")]
        tile_a: MaybeUninit<[u16; ui::TILE_PIXELS]> = MaybeUninit::uninit(),
        #[unsafe(link_section = ".uninit.tiles")]
        tile_b: MaybeUninit<[u16; ui::TILE_PIXELS]> = MaybeUninit::uninit(),
    ])]
    fn init(cx: init::Context) -> (Shared, Local) {
        let mut board = pico::init(cx.device, cx.local.memory);
        Mono::start(board.timer, &board.resets, Priority::rtic_default());
        pico::start_watchdog(&mut board.watchdog);

        let can = CanNode::new(board.can_spi, board.can_int, config::FIRST_ACCESS);
        let (frames_in, frames_out) = cx.local.queue.split();
        let (views_in, views_out) = make_signal!(View);
        let (tile_done_in, tile_done_out) = make_signal!(());

        // Each is spawned once and never ends: there is always room.
        let _ = (tick::spawn(), draw::spawn(), report::spawn());
        (
            // Built where it stays: the stack has no room for a copy.
            Shared {
                can,
                instrument: config::instrument(),
                shown: View::default(),
                link: board.link,
                boot: board.boot,
            },
            Local {
                frames_in,
                frames_out,
                views_in,
                views_out,
                tile_done_in,
                tile_done_out,
                panel: board.panel,
                // Cleared here and not by start-up code, which runs at 6 MHz: the first picture comes sooner.
                tiles: [
                    cx.local.tile_a.write([0; ui::TILE_PIXELS]),
                    cx.local.tile_b.write([0; ui::TILE_PIXELS]),
                ],
                backlight: board.backlight,
                wires: Wires::new(board.buttons, board.body, board.gauges),
                buzzer: board.buzzer,
                led: board.led,
                watch: Watch::new(board.watchdog),
                keeping: Keeping::new(board.flash),
            },
        )
    }

    // Not `extern` like the others: those take no attribute, and this one's entry lives in RAM.
    #[task(binds = IO_IRQ_BANK0, priority = 4, local = [frames_in], shared = [can])]
    #[unsafe(link_section = ".data.ram.can_interrupt")]
    fn can_service(cx: can_service::Context) {
        crate::tasks::can_service(cx);
    }

    extern "Rust" {
        #[task(binds = DMA_IRQ_0, priority = 3, local = [tile_done_in])]
        fn panel_done(cx: panel_done::Context);

        #[task(binds = DMA_IRQ_1, priority = 3, shared = [link])]
        fn link_done(cx: link_done::Context);

        #[task(
            priority = 2,
            local = [frames_out, views_in, wires, buzzer, led, watch, keeping],
            shared = [can, instrument, &boot],
        )]
        async fn tick(cx: tick::Context);

        #[task(
            priority = 1,
            local = [panel, tiles, backlight, views_out, tile_done_out],
            shared = [shown, &boot],
        )]
        async fn draw(cx: draw::Context);

        #[task(priority = 1, shared = [can, instrument, shown, link, &boot])]
        async fn report(cx: report::Context);

        #[idle]
        fn idle(cx: idle::Context) -> !;
    }
}

/// The one place that decides what becomes of a panic: its words are kept, the chip starts anew and shows them.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    pico::retained::leave_panic(info)
}

/// A hard fault is treated like a panic; its words are the address of the instruction.
#[cortex_m_rt::exception]
unsafe fn HardFault(frame: &cortex_m_rt::ExceptionFrame) -> ! {
    pico::retained::leave_fault(frame.pc())
}
