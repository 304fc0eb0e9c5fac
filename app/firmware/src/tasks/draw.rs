//! Starts the panel and keeps the picture equal to the latest view.
//!
//! Two tiles take turns: one is painted while the DMA sends the other.

use core::sync::atomic::{AtomicU32, Ordering};

use cluster::View;
use pico::{PanelPort, Reset, now_us};
use rtic::Mutex;
use rtic_monotonics::Timebase;
use rtic_monotonics::fugit::ExtU64;
use rtic_sync::signal::SignalReader;
use tft::{Start, StartUp, Step, Window};
use ui::Screen;

use crate::app::{Mono, draw::Context};

/// Memory for the pixels of one tile, as the panel wants them.
pub type TileBuffer = &'static mut [u16];

/// Views of which the panel shows everything, and the longest time that one took. Only `draw` writes them.
static PICTURES: AtomicU32 = AtomicU32::new(0);
static LONGEST_US: AtomicU32 = AtomicU32::new(0);

/// Returns a number that changes with every view that the panel has come to show.
pub fn progress() -> u32 {
    PICTURES.load(Ordering::Relaxed)
}

/// Returns the views shown since start and the longest time that one took, in microseconds.
pub fn measured() -> (u32, u32) {
    (PICTURES.load(Ordering::Relaxed), LONGEST_US.load(Ordering::Relaxed))
}

/// The panel with what it takes to send tiles to it.
struct Brush<'a> {
    panel: &'a mut PanelPort,
    done: &'a mut SignalReader<'static, ()>,
    /// A tile that is neither painted nor on its way.
    spare: [Option<TileBuffer>; 2],
}

impl Brush<'_> {
    /// Brings the panel to `view`: one picture, during which the panel stays selected.
    async fn paint(&mut self, screen: &mut Screen, view: &View) {
        let start = now_us();
        screen.update(view);
        while let Some(area) = screen.next_tile(ui::TILE_PIXELS) {
            let Some(tile) = self.free_tile().await else { break };
            let is_painted = screen.render(&area, tile).is_some();
            self.settle().await;
            let returned = match Window::try_from(area) {
                Ok(window) if is_painted => self.panel.start(window, tile).err(),
                _ => Some(tile),
            };
            self.keep(returned);
        }
        self.settle().await;
        self.panel.close();
        let took = u32::try_from(now_us() - start).unwrap_or(u32::MAX);
        LONGEST_US.store(LONGEST_US.load(Ordering::Relaxed).max(took), Ordering::Relaxed);
        self.confirm();
    }

    /// Says that the panel shows the latest view.
    fn confirm(&self) {
        PICTURES.store(PICTURES.load(Ordering::Relaxed).wrapping_add(1), Ordering::Relaxed);
    }

    async fn free_tile(&mut self) -> Option<TileBuffer> {
        if self.spare.iter().all(Option::is_none) {
            self.settle().await;
        }
        self.spare.iter_mut().find_map(Option::take)
    }

    /// Waits for the tile that is on its way, if there is one. The watchdog is fed only while the DMA completes.
    async fn settle(&mut self) {
        while self.panel.is_open() {
            match self.panel.finish() {
                Some(tile) => self.keep(Some(tile)),
                None => self.done.wait().await,
            }
        }
    }

    fn keep(&mut self, tile: Option<TileBuffer>) {
        if let Some(place) = self.spare.iter_mut().find(|place| place.is_none()) {
            *place = tile;
        }
    }
}

/// Starts the panel, then draws every view, for ever.
pub async fn draw(cx: Context<'_>) {
    let local = cx.local;
    let mut shown = cx.shared.shown;
    let [first, second] = core::mem::take(local.tiles);
    let mut brush =
        Brush { panel: local.panel, done: local.tile_done_out, spare: [Some(first), Some(second)] };
    let mut screen = Screen::new();
    let mut view = View::default();

    let start = if cx.shared.boot.reset == Reset::Power { Start::Cold } else { Start::Warm };
    // The models' scripts are constants of the crate; its tests record both.
    let script = pico::facts::PANEL.script();
    // Waits count from the end of the command before them, however late this task gets to them.
    let mut due = Mono::now();
    for step in script.into_iter().flat_map(|script| StartUp::new(script, start)) {
        match step {
            Step::Reset(high) => {
                brush.panel.reset(high);
                due = Mono::now();
            }
            Step::Send(command) => {
                brush.panel.command(&command);
                due = Mono::now();
            }
            Step::Wait(us) => {
                due += u64::from(us).micros();
                Mono::delay_until(due).await;
            }
            Step::Paint { at_least_us } => {
                due += u64::from(at_least_us).micros();
                view = local.views_out.wait().await;
                brush.paint(&mut screen, &view).await;
                Mono::delay_until(due).await;
            }
        }
    }
    local.backlight.set(1_000);

    loop {
        shown.lock(|shown| *shown = view);
        let before = core::mem::replace(&mut view, local.views_out.wait().await);
        if ui::looks_same(&before, &view) {
            brush.confirm();
        } else {
            brush.paint(&mut screen, &view).await;
        }
    }
}
