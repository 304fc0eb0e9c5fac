//! What outlives a reset: why it happened, how often, and the last words of a panic.
//!
//! Lives in RAM that start-up does not clear; a check sum tells words of the last run from power-on noise. A panic or a
//! hard fault writes its note and resets the chip at once through the watchdog.
//! The boot ROM starts a new image through the watchdog too; a mark in its scratch register tells that from a firmware
//! that stood still.
//! Source: RP2040 datasheet 2.12.3 (CHIP_RESET), 4.7.4 (watchdog scratch and REASON); pico-sdk
//! `watchdog_enable_caused_reboot` (scratch register 4 and its mark).

use core::cell::UnsafeCell;
use core::fmt::Write;
use core::mem::MaybeUninit;
use core::panic::PanicInfo;
use rp2040_hal::pac;
use rp2040_hal::watchdog::{ScratchRegister, Watchdog};

/// Mark in scratch register 4 while the firmware's own watchdog runs; the boot ROM overwrites it.
const ARMED: u32 = 0x6AB7_3121;

/// Why the chip started.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reset {
    /// Supply or brown-out.
    Power,
    /// RUN pin, debugger, or the boot ROM after an image was dropped on its drive.
    Pin,
    /// The watchdog ran out.
    Watchdog,
    /// A panic or a hard fault.
    Panic,
}

/// Bytes of a panic's text that are kept.
pub const NOTE_LEN: usize = 64;

/// The last words of the previous run.
#[derive(Clone, Copy, Debug)]
pub struct Note {
    /// Source line; 0 for a hard fault.
    pub line: u32,
    len: u32,
    text: [u8; NOTE_LEN],
}

impl Note {
    const EMPTY: Self = Self { line: 0, len: 0, text: [0; NOTE_LEN] };

    /// Returns file and message, cut off where there was no more room.
    pub fn text(&self) -> &str {
        let bytes = self.text.get(..self.len as usize).unwrap_or_default();
        match core::str::from_utf8(bytes) {
            Ok(text) => text,
            Err(error) => core::str::from_utf8(&bytes[..error.valid_up_to()]).unwrap_or_default(),
        }
    }
}

impl Write for Note {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        for byte in text.bytes() {
            let room = self.text.get_mut(self.len as usize).ok_or(core::fmt::Error)?;
            *room = byte;
            self.len += 1;
        }
        Ok(())
    }
}

/// How this run began.
#[derive(Clone, Copy, Debug)]
pub struct Boot {
    /// Why the chip started.
    pub reset: Reset,
    /// Resets since the supply came up.
    pub resets: u16,
    /// The last words of the previous run, if it ended in a panic or a hard fault.
    pub note: Option<Note>,
}

#[derive(Clone, Copy)]
#[repr(C)]
struct Kept {
    resets: u32,
    has_note: u32,
    note: Note,
    check: u32,
}

impl Kept {
    const EMPTY: Self = Self { resets: 0, has_note: 0, note: Note::EMPTY, check: 0 };

    fn checksum(&self) -> u32 {
        let words = [self.resets, self.has_note, self.note.line, self.note.len];
        let text = self.note.text.iter().map(|&byte| u32::from(byte));
        words.into_iter().chain(text).fold(0xC1A5_7E12, |sum: u32, word| sum.rotate_left(5) ^ word)
    }

    fn sealed(mut self) -> Self {
        self.check = self.checksum();
        self
    }
}

struct Cell(UnsafeCell<MaybeUninit<Kept>>);

// SAFETY: one core; `take` runs before interrupts are on, `leave` runs with interrupts off and never returns.
unsafe impl Sync for Cell {}

#[unsafe(link_section = ".uninit.retained")]
static KEPT: Cell = Cell(UnsafeCell::new(MaybeUninit::uninit()));

fn load() -> Option<Kept> {
    // SAFETY: every bit pattern is a valid `Kept` (integers only) and the cell is RAM; the read is volatile because no
    // code of this run has written it.
    let kept = unsafe { KEPT.0.get().cast::<Kept>().read_volatile() };
    (kept.check == kept.checksum()).then_some(kept)
}

fn store(kept: Kept) {
    // SAFETY: see `Cell`: no one else looks at this time.
    unsafe { KEPT.0.get().cast::<Kept>().write_volatile(kept.sealed()) };
}

/// Marks that the firmware's own watchdog runs from now on.
pub(crate) fn mark_armed(watchdog: &mut Watchdog) {
    watchdog.write_scratch(ScratchRegister::Scratch4, ARMED);
}

/// Tells how this run began, and forgets the note and the mark.
pub(crate) fn take(watchdog: &pac::WATCHDOG, chip: &pac::VREG_AND_CHIP_RESET) -> Boot {
    let reason = watchdog.reason().read();
    let by_watchdog = reason.timer().bit_is_set() || reason.force().bit_is_set();
    let kept = load().filter(|_| by_watchdog || chip.chip_reset().read().had_por().bit_is_clear());
    let was_armed = watchdog.scratch4().read().bits() == ARMED;
    // SAFETY: a scratch register takes any value.
    watchdog.scratch4().write(|w| unsafe { w.bits(0) });
    let note = kept.filter(|kept| kept.has_note != 0).map(|kept| kept.note);
    let reset = match (by_watchdog, note) {
        (true, Some(_)) => Reset::Panic,
        (true, None) if was_armed => Reset::Watchdog,
        (false, _) if chip.chip_reset().read().had_por().bit_is_set() => Reset::Power,
        _ => Reset::Pin,
    };
    let resets = kept.map_or(0, |kept| kept.resets.saturating_add(1));
    store(Kept { resets, ..Kept::EMPTY });
    Boot { reset, resets: resets.min(u32::from(u16::MAX)) as u16, note }
}

/// Keeps the words of a panic and resets the chip.
pub fn leave_panic(info: &PanicInfo) -> ! {
    let mut note = Note::EMPTY;
    // What does not fit is cut off; the error says only that.
    let _ = match info.location() {
        Some(place) => {
            note.line = place.line();
            write!(note, "{}: {}", short(place.file()), info.message())
        }
        None => write!(note, "{}", info.message()),
    };
    leave(note)
}

/// Keeps where a hard fault happened and resets the chip.
pub fn leave_fault(pc: u32) -> ! {
    let mut note = Note::EMPTY;
    let _ = write!(note, "hard fault at {pc:#010x}");
    leave(note)
}

fn leave(note: Note) -> ! {
    cortex_m::interrupt::disable();
    let resets = load().map_or(0, |kept| kept.resets);
    store(Kept { resets, has_note: 1, note, check: 0 });
    rp2040_hal::reset()
}

/// The last part of a path: 64 bytes are few.
fn short(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}
