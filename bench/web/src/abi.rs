//! The calls by which a Worker reaches the module.
//!
//! Each call takes its argument from the inbox and leaves its answer in the outbox: byte strings whose address the module
//! tells, so that no memory is handed over and none has to be freed. One module = one desk. Calls before [`open`] do
//! nothing. A panic ends the module; `complain` tells its words first.

#![allow(
    unsafe_code,
    reason = "names that the host finds are attributes that count as unsafe; there is no unsafe block"
)]

use crate::{Desk, Out, drive, judge_scenario};
use std::cell::RefCell;
use std::time::Duration;

#[link(wasm_import_module = "host")]
unsafe extern "C" {
    /// Milliseconds since any fixed moment.
    safe fn now() -> f64;
    /// Tells why the module ends: UTF-8 text at this address of its memory.
    safe fn complain(text: *const u8, bytes: usize);
}

#[derive(Default)]
struct Module {
    inbox: Vec<u8>,
    outbox: Vec<u8>,
    desk: Option<Desk>,
    /// Image of the flash, of the last call that brought one.
    flash: Vec<u8>,
    /// Recording that the desk begins with: its name and its bytes.
    log: Option<(String, Vec<u8>)>,
    /// Number and size of what [`next`] returned last.
    number: u64,
    size: (u32, u32),
}

thread_local! {
    static MODULE: RefCell<Module> = RefCell::default();
}

fn with<T>(what: impl FnOnce(&mut Module) -> T) -> T {
    MODULE.with_borrow_mut(what)
}

impl Module {
    fn text(&self) -> String {
        String::from_utf8_lossy(&self.inbox).into_owned()
    }

    /// Puts an answer into the outbox; 1 = as asked, 0 = a text that says why not.
    fn answer(&mut self, answer: Result<Vec<u8>, String>) -> u32 {
        let (bytes, is_ok) = answer.map_or_else(|why| (why.into_bytes(), 0), |bytes| (bytes, 1));
        self.outbox = bytes;
        is_ok
    }
}

fn clock() -> Duration {
    Duration::from_secs_f64(now().max(0.0) / 1e3)
}

/// Makes room for so many bytes of argument and returns their address.
#[unsafe(no_mangle)]
pub extern "C" fn inbox(bytes: usize) -> *mut u8 {
    with(|module| {
        module.inbox.clear();
        module.inbox.resize(bytes, 0);
        module.inbox.as_mut_ptr()
    })
}

/// Returns the address of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn outbox() -> *const u8 {
    with(|module| module.outbox.as_ptr())
}

/// Returns its length in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn outbox_len() -> usize {
    with(|module| module.outbox.len())
}

/// Takes the image of the flash, and tells of panics from now on.
#[unsafe(no_mangle)]
pub extern "C" fn take_flash() {
    std::panic::set_hook(Box::new(|panic| {
        let text = panic.to_string();
        complain(text.as_ptr(), text.len());
    }));
    with(|module| module.flash = std::mem::take(&mut module.inbox));
}

/// Takes the recording that the desk begins with: its name, a zero, its bytes.
#[unsafe(no_mangle)]
pub extern "C" fn take_log() {
    with(|module| module.log = named(&module.inbox).map(|(name, bytes)| (name, bytes.to_vec())));
}

fn named(inbox: &[u8]) -> Option<(String, &[u8])> {
    let end = inbox.iter().position(|byte| *byte == 0)?;
    Some((String::from_utf8_lossy(&inbox[..end]).into_owned(), &inbox[end + 1..]))
}

/// Puts a bench on the desk; 1 = it is there.
#[unsafe(no_mangle)]
pub extern "C" fn open() -> u32 {
    with(|module| {
        let log = module.log.as_ref().map(|(name, bytes)| (name.as_str(), bytes.as_slice()));
        let desk = Desk::new(module.flash.clone(), log, Box::new(clock));
        let answer = desk.map(|desk| module.desk = Some(desk)).map_err(|error| format!("{error:#}"));
        module.answer(answer.map(|()| Vec::new()))
    })
}

/// Obeys the command in the inbox.
#[unsafe(no_mangle)]
pub extern "C" fn command() {
    with(|module| {
        let text = module.text();
        if let Some(desk) = &mut module.desk {
            desk.command(&text);
        }
    });
}

/// Lets time pass; returns for how many milliseconds there is nothing to do.
#[unsafe(no_mangle)]
pub extern "C" fn turn() -> f64 {
    with(|module| module.desk.as_mut().map_or(0.0, |desk| desk.turn().as_secs_f64() * 1e3))
}

/// Puts what is to be told next into the outbox: 0 = nothing, 1 = JSON for the page, 2 = the panel as RGBA, see [`width`],
/// 3 = the name of a scenario to judge, see [`number`].
#[unsafe(no_mangle)]
pub extern "C" fn next() -> u32 {
    with(|module| match module.desk.as_mut().and_then(Desk::next_out) {
        None => 0,
        Some(Out::Text(text)) => {
            module.outbox = text.as_bytes().to_vec();
            1
        }
        Some(Out::Picture(picture)) => {
            module.size = (picture.width, picture.height);
            let opaque = |rgb: &[u8]| [rgb[0], rgb[1], rgb[2], u8::MAX];
            module.outbox = picture.rgb.chunks_exact(3).flat_map(opaque).collect();
            2
        }
        Some(Out::Judge(number, name)) => {
            module.number = number;
            module.outbox = name.into_bytes();
            3
        }
    })
}

/// Width of the picture in the outbox, in pixels.
#[unsafe(no_mangle)]
pub extern "C" fn width() -> u32 {
    with(|module| module.size.0)
}

/// Number of the scenario in the outbox.
#[unsafe(no_mangle)]
pub extern "C" fn number() -> f64 {
    with(|module| module.number as f64)
}

/// Answers what the page asks for by the name in the inbox; 1 = bytes, 0 = a text that says why not.
#[unsafe(no_mangle)]
pub extern "C" fn ask() -> u32 {
    with(|module| {
        let path = module.text();
        let nothing = || Err("there is no bench".to_owned());
        let answer = module.desk.as_ref().map_or_else(nothing, |desk| desk.ask(&path));
        module.answer(answer)
    })
}

/// Takes a dropped file: its name, a zero, its bytes; the outbox says what it is, as JSON.
#[unsafe(no_mangle)]
pub extern "C" fn drop_file() -> u32 {
    with(|module| {
        let inbox = std::mem::take(&mut module.inbox);
        let told =
            named(&inbox).and_then(|(name, bytes)| Some(module.desk.as_mut()?.drop_file(&name, bytes)));
        module.answer(told.map(String::into_bytes).ok_or_else(|| "there is no bench".to_owned()))
    })
}

/// Judges the scenario in the inbox; the outbox has what [`judged`] takes.
#[unsafe(no_mangle)]
pub extern "C" fn judge() {
    with(|module| module.outbox = judge_scenario(&module.flash, &module.text()).into_bytes());
}

/// Takes the answer of the Worker that has judged scenario `number`.
#[unsafe(no_mangle)]
pub extern "C" fn judged(number: f64) {
    with(|module| {
        let text = module.text();
        if let Some(desk) = &mut module.desk {
            desk.judged(number as u64, &text);
        }
    });
}

/// Puts the image of the flash into the outbox, for another Worker.
#[unsafe(no_mangle)]
pub extern "C" fn flash() {
    with(|module| module.outbox = module.desk.as_ref().map_or_else(|| module.flash.clone(), Desk::flash));
}

/// Drives the vehicle in the inbox for so many seconds; the outbox has the numbers of the run.
#[unsafe(no_mangle)]
pub extern "C" fn measure(seconds: f64) -> u32 {
    with(|module| {
        let driven = drive(&module.flash, &module.text(), seconds as u64);
        module.answer(driven.map(String::into_bytes))
    })
}
