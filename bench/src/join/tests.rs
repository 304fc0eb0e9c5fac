//! Tools on a small bus: what a client sees of it, byte by byte.

use super::adapter::{Adapter, Bridge, Said, SlcanAdapter};
use super::recorder::Recorder;
use super::slcan::Flag;
use super::terminal::Terminal;
use super::wire::Wire;
use super::wire::tests::Memory;
use super::*;
use crate::can::{EventKind, Id};
use crate::chips::bench_board::{CanWiring, PanelWiring, Wiring};
use crate::chips::{mcp2515, panel};
use crate::pins::{Board, InputPins};

const BITRATE: u32 = 250_000;

/// A bus with a tool on it and one more node that acknowledges.
struct World<T> {
    bus: Bus,
    other: NodeId,
    node: NodeId,
    tool: T,
    now: Nanos,
    /// What the other node heard.
    heard: Vec<Frame>,
}

impl<T: Tool> World<T> {
    fn new(mut tool: T) -> Self {
        let mut bus = Bus::new(BITRATE);
        let other = bus.attach("other");
        let node = bus.attach_off(&tool.name());
        tool.sit(&mut Port { bus: &mut bus, node, now: Nanos::ZERO, missed: 0 });
        Self { bus, other, node, tool, now: Nanos::ZERO, heard: Vec::new() }
    }

    /// One slice of time, then the tool's turn.
    fn turn(&mut self) {
        self.now += TURN;
        while let Some(event) = self.bus.poll(self.now) {
            match event.kind {
                EventKind::Received { frame } if event.node == self.other => self.heard.push(frame),
                _ if event.node == self.node => self.tool.hear(&event),
                _ => {}
            }
        }
        let mut port = Port { bus: &mut self.bus, node: self.node, now: self.now, missed: 0 };
        self.tool.act(&mut port).unwrap();
    }

    fn send_from_other(&mut self, frame: Frame) {
        self.bus.request(self.other, self.now, frame, Tag(9));
    }
}

/// A terminal over a wire in memory that the test holds the other end of.
type Line = Arc<Mutex<Memory>>;

impl Wire for Line {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        locked(self).read(into)
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        locked(self).write(bytes)
    }

    fn is_connected(&mut self) -> io::Result<bool> {
        locked(self).is_connected()
    }
}

fn terminal() -> (World<Terminal<Line>>, Line) {
    let line = Line::default();
    locked(&line).room = usize::MAX;
    (World::new(Terminal::new("slcan", Arc::clone(&line))), line)
}

/// Says something and returns what comes back in one turn.
fn ask(world: &mut World<Terminal<Line>>, line: &Line, text: &str) -> String {
    locked(line).incoming.extend(text.bytes());
    world.turn();
    answers(line)
}

fn answers(line: &Line) -> String {
    String::from_utf8(std::mem::take(&mut locked(line).outgoing)).unwrap()
}

fn extended(id: u32, payload: &[u8]) -> Frame {
    Frame::new(Id::extended(id).unwrap(), payload).unwrap()
}

fn status(text: &str) -> u8 {
    let digits =
        text.trim_end_matches('\r').strip_prefix('F').unwrap_or_else(|| panic!("no status: {text:?}"));
    u8::from_str_radix(digits, 16).unwrap()
}

#[test]
fn python_cans_way_of_opening_is_answered_line_by_line() {
    let (mut world, line) = terminal();
    // C, S5, an empty line for the data bit rate of CAN FD, O, and O again.
    assert_eq!(ask(&mut world, &line, "C\rS5\r\rO\rO\r"), "\r\r\r\r\r");
    assert_eq!(ask(&mut world, &line, "V\rN\rv\r"), "V0101\rNBNCH\rv0101\r");
}

#[test]
fn a_closed_channel_is_deaf_and_mute() {
    let (mut world, line) = terminal();
    world.send_from_other(extended(0x123, &[1]));
    assert_eq!(ask(&mut world, &line, "t1230\rF\r"), "\x07\x07");
    assert_eq!(ask(&mut world, &line, ""), "");
    assert_eq!(world.heard, []);
}

#[test]
fn frames_of_the_bus_come_with_the_virtual_millisecond_if_asked_for() {
    let (mut world, line) = terminal();
    assert_eq!(ask(&mut world, &line, "Z1\rO\r"), "\r\r");
    world.turn();
    world.send_from_other(extended(0x18FE_F100, &[0xAB, 0xCD]));
    // The frame is on the bus at 20 ms; 82 bits or so later it is heard, in the 21st millisecond at most.
    assert_eq!(ask(&mut world, &line, ""), "T18FEF1002ABCD0014\r");
    assert_eq!(ask(&mut world, &line, "Z0\r"), "\x07", "not while the channel is open");
    assert_eq!(ask(&mut world, &line, "C\rZ0\rO\r"), "\r\r\r");
    world.turn();
    world.send_from_other(Frame::new(Id::standard(0x7F).unwrap(), &[]).unwrap());
    assert_eq!(ask(&mut world, &line, ""), "t07F0\r");
}

#[test]
fn frames_of_the_client_are_on_the_bus_in_the_order_of_their_identifiers() {
    let (mut world, line) = terminal();
    ask(&mut world, &line, "O\r");
    let (ours, theirs) = (extended(0x18F0_0001, &[1]), extended(0x0CF0_0002, &[2]));
    assert_eq!(ask(&mut world, &line, "T18F00001101\r"), "Z\r");
    world.send_from_other(theirs);
    // Both wait at the same instant: the lower identifier wins, the client hears it and its own goes next.
    assert_eq!(ask(&mut world, &line, ""), "T0CF00002102\r");
    assert_eq!(world.heard, [ours]);
    assert_eq!(status(&ask(&mut world, &line, "F\r")), Flag::ArbitrationLost as u8);
    assert_eq!(status(&ask(&mut world, &line, "F\r")), 0, "reading clears the flags");
}

#[test]
fn what_was_asked_for_before_closing_is_still_sent() {
    let (mut world, line) = terminal();
    assert_eq!(ask(&mut world, &line, "O\rt1230\rr0018\rC\r"), "\rz\rz\r\r");
    world.turn();
    assert_eq!(world.heard.len(), 2);
    world.turn();
    assert_eq!(world.bus.pending(world.node), 0);
}

#[test]
fn a_client_that_leaves_without_a_word_closes_the_channel() {
    let (mut world, line) = terminal();
    world.bus.attach("acknowledges");
    ask(&mut world, &line, "S5\rZ1\rO\rt12");
    locked(&line).gone = true;
    world.turn();
    world.turn();
    world.send_from_other(extended(1, &[]));
    world.turn();
    locked(&line).gone = false;
    // Neither the half line nor the frame nor the settings of the one before.
    assert_eq!(ask(&mut world, &line, "F\r"), "\x07");
    assert_eq!(ask(&mut world, &line, "O\r"), "\r");
    world.turn();
    world.send_from_other(extended(1, &[]));
    assert_eq!(ask(&mut world, &line, ""), "T000000010\r");
}

#[test]
fn a_client_that_does_not_read_loses_the_oldest_frames_and_is_told() {
    let (mut world, line) = terminal();
    ask(&mut world, &line, "O\r");
    locked(&line).room = 0;
    let count = 6_000;
    for number in 0..count {
        world.send_from_other(extended(number, &[]));
    }
    for _ in 0..400 {
        world.turn();
    }
    locked(&line).room = usize::MAX;
    let text = ask(&mut world, &line, "F\r");
    let lines: Vec<&str> = text.split_terminator('\r').collect();
    let (flags, frames) = lines.split_last().unwrap();
    assert_eq!(status(flags), Flag::ReceiveFull as u8 | Flag::Overrun as u8);
    assert_eq!(frames.last(), Some(&format!("T{:08X}0", count - 1).as_str()), "the newest one is there");
    let numbers: Vec<u32> =
        frames.iter().map(|frame| u32::from_str_radix(&frame[1..9], 16).unwrap()).collect();
    assert!(numbers.windows(2).all(|pair| pair[0] + 1 == pair[1]), "what is left is whole and in order");
    assert!((4_000..5_000).contains(&numbers.len()), "{} frames are kept", numbers.len());
}

#[test]
fn a_client_that_sends_more_than_a_bus_carries_is_refused() {
    let (mut world, line) = terminal();
    ask(&mut world, &line, "O\r");
    let text = ask(&mut world, &line, &"t1230\r".repeat(600));
    assert_eq!(text, "z\r".repeat(SEND_MAX) + &"\x07".repeat(600 - SEND_MAX));
    assert_eq!(status(&ask(&mut world, &line, "F\r")) & Flag::TransmitFull as u8, Flag::TransmitFull as u8);
}

#[test]
fn a_listening_client_hears_and_is_never_heard() {
    let (mut world, line) = terminal();
    assert_eq!(ask(&mut world, &line, "L\rt1230\rO\r"), "\r\x07\x07");
    world.turn();
    world.send_from_other(extended(7, &[7]));
    world.turn();
    // Nobody acknowledges: the frame is repeated until its sender is too tired to say so, and the errors are seen.
    assert_eq!((world.heard.len(), world.bus.stats().frames), (0, 0));
    let text = ask(&mut world, &line, "F\r");
    assert_ne!(status(text.split_terminator('\r').next_back().unwrap()) & Flag::BusError as u8, 0);
}

#[test]
fn a_client_with_the_wrong_bit_rate_disturbs_as_on_a_desk() {
    let (mut world, line) = terminal();
    assert_eq!(ask(&mut world, &line, "S6\rO\r"), "\r\r");
    world.turn();
    world.send_from_other(extended(7, &[7]));
    world.turn();
    assert!(world.bus.stats().error_frames > 0);
    assert_ne!(status(&ask(&mut world, &line, "F\r")) & Flag::BusError as u8, 0);
}

#[test]
fn lines_that_are_too_long_are_refused_and_the_next_one_is_obeyed() {
    let (mut world, line) = terminal();
    assert_eq!(ask(&mut world, &line, &format!("{}\rO\r", "t".repeat(500))), "\x07\r");
}

/// What a recorder writes on, with the test reading over its shoulder.
#[derive(Clone, Default)]
struct Paper(Arc<Mutex<Vec<u8>>>);

impl io::Write for Paper {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        locked(&self.0).write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_recorder_writes_what_is_on_the_bus_and_acknowledges_nothing() {
    let written = Paper::default();
    let mut world = World::new(Recorder::new(written.clone()));
    let third = world.bus.attach("third");
    world.turn();
    world.send_from_other(extended(0x18FE_F100, &[1, 2]));
    world.bus.request(third, world.now, Frame::new(Id::standard(0x12).unwrap(), &[]).unwrap(), Tag(9));
    world.turn();
    let text = String::from_utf8(locked(&written.0).clone()).unwrap();
    let lines: Vec<(&str, &str)> = text.lines().map(|line| line.split_once(" can0 ").unwrap()).collect();
    assert_eq!(lines.iter().map(|(_, frame)| *frame).collect::<Vec<_>>(), ["012#", "18FEF100#0102"]);
    let log = crate::log::Log::parse("recorded", &text).unwrap();
    assert_eq!(log.entries.len(), 2);
}

/// A board with a bus on which nobody has a seat yet.
fn board() -> BenchBoard {
    let wiring = Wiring {
        can: CanWiring { spi: 0, cs: 17, int: 20 },
        panel: PanelWiring { spi: 1, cs: 9, dc: 8, reset: None, backlight: None },
        buzzer: None,
        buttons: Vec::new(),
        uart: 0,
    };
    BenchBoard::new(wiring, BITRATE, mcp2515::Config::default(), panel::Config::ILI9341)
}

/// A disk with room for so many bytes.
struct Disk {
    paper: Paper,
    room: usize,
}

impl io::Write for Disk {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let fits = bytes.len().min(self.room);
        if fits == 0 && !bytes.is_empty() {
            return Err(io::ErrorKind::StorageFull.into());
        }
        self.room -= fits;
        self.paper.write(&bytes[..fits])
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_full_disk_is_told_with_the_frames_that_are_whole_in_the_log() {
    let paper = Paper::default();
    let recorder = Recorder::new(Disk { paper: paper.clone(), room: 100 });
    let receipt = recorder.receipt();
    let (members, mut board) = (Members::default(), board());
    members.add(recorder);
    members.attach(&mut board);
    let other = board.bus_mut().attach("other");
    board.bus_mut().attach("third");
    for byte in 0..5 {
        board.bus_mut().request(other, Nanos::ZERO, extended(0x18FE_F100, &[byte]), Tag(9));
    }
    board.advance(TURN, &mut InputPins::default());
    members.poll(&mut board);
    let written = receipt.written();
    let text = String::from_utf8(locked(&paper.0).clone()).unwrap();
    assert_eq!((text.len(), written.frames), (100, 3), "{text}");
    assert!(
        text[..written.bytes as usize].ends_with('\n') && text[written.bytes as usize..].starts_with('(')
    );
    assert!(written.failure.is_some() && members.is_empty());
    // What the disk took can be read as it is.
    let log = crate::log::Log::parse("recorded", &text).unwrap();
    assert_eq!((log.entries.len(), log.notes.len()), (3, 1));
}

#[test]
fn a_recording_goes_on_over_a_bench_that_is_started_again() {
    let (paper, members) = (Paper::default(), Members::default());
    members.add(Recorder::new(paper.clone()));
    for byte in 0..2 {
        let mut board = board();
        members.attach(&mut board);
        let other = board.bus_mut().attach("other");
        board.bus_mut().attach("third");
        board.bus_mut().request(other, Nanos::from_millis(5), extended(0x18FE_F100, &[byte]), Tag(9));
        // The bench is gone before the tools have a turn.
        board.advance(TURN, &mut InputPins::default());
    }
    members.attach(&mut board());
    members.poll(&mut board());
    let log = crate::log::Log::parse("recorded", std::str::from_utf8(&locked(&paper.0)).unwrap()).unwrap();
    let first_bytes: Vec<u8> = log.entries.iter().map(|entry| entry.frame.data[0]).collect();
    assert_eq!(first_bytes, [0, 1]);
    assert!(log.duration() > Nanos::from_millis(5) && log.notes.is_empty(), "{log:?}");
}

/// An adapter in memory: what it was given, what it has to give, how much it takes.
#[derive(Default)]
struct Desk {
    sent: Vec<Frame>,
    to_hear: VecDeque<Frame>,
    busy: bool,
}

impl Adapter for Arc<Mutex<Desk>> {
    fn send(&mut self, frame: &Frame) -> io::Result<bool> {
        let mut desk = locked(self);
        if !desk.busy {
            desk.sent.push(*frame);
        }
        Ok(!desk.busy)
    }

    fn receive(&mut self) -> io::Result<Option<Frame>> {
        Ok(locked(self).to_hear.pop_front())
    }
}

#[test]
fn a_bridge_carries_each_sides_frames_to_the_other_and_none_back() {
    let desk = Arc::new(Mutex::new(Desk::default()));
    let mut world = World::new(Bridge::new("vcan0", Arc::clone(&desk)));
    world.turn();
    locked(&desk).busy = true;
    let (ours, theirs) = (extended(1, &[1]), extended(2, &[2]));
    world.send_from_other(ours);
    locked(&desk).to_hear.push_back(theirs);
    world.turn();
    assert_eq!(locked(&desk).sent, [], "a busy adapter is asked again");
    locked(&desk).busy = false;
    world.turn();
    assert_eq!((locked(&desk).sent.clone(), world.heard.clone()), (vec![ours], vec![theirs]));
}

#[test]
fn an_adapters_client_opens_sends_hears_and_closes() {
    let line = Line::default();
    locked(&line).room = usize::MAX;
    let mut adapter = SlcanAdapter::open(Arc::clone(&line), 250_000).unwrap();
    assert_eq!(answers(&line), "\rC\rS5\rO\r");
    assert!(adapter.send(&extended(0x18F1_0027, &[1, 2])).unwrap());
    assert_eq!(answers(&line), "T18F1002720102\r");
    locked(&line).incoming.extend(b"\r\x07\r\rZ\rt12310500FF\rV0101\r\x07T000000020\r");
    let heard: Vec<Frame> = std::iter::from_fn(|| adapter.receive().unwrap()).collect();
    assert_eq!(heard, [Frame::new(Id::standard(0x123).unwrap(), &[5]).unwrap(), extended(2, &[])]);
    assert_eq!(adapter.refused(), 2);
    drop(adapter);
    assert_eq!(answers(&line), "\rC\r");
    let Err(error) = SlcanAdapter::open(line, 333_000) else { panic!("there is no such code") };
    assert!(error.to_string().contains("333000"), "{error}");
}

/// Whose script it is, its bytes, the frames heard of it, counts of what is understood, of CAN FD and of lines that are not
/// understood, and the first of these.
type Script = (&'static str, &'static [u8], &'static [&'static str], (u64, u64, u64), &'static str);

/// What adapters of several makers say.
const SCRIPTS: &[Script] = &[
    (
        "LAWICEL CAN232: answers, time stamps, a refusal",
        b"\r\r\x07V1013\rNA123\rF00\rz\rZ\rt1232DEAD1A2B\rT18FEF10010500FF\r",
        &["123#DEAD", "18FEF100#05"],
        (9, 0, 0),
        "",
    ),
    (
        "USBtin: versions, serial number, lower case, remote requests",
        b"\x07\rV0100\rv0107\rNFFFF\r\rt7ff101\rr1230\rR000000018\r",
        &["7FF#01", "123#R0", "00000001#R8"],
        (8, 0, 0),
        "",
    ),
    (
        "CANable: a version of words, no answers, stamps of eight digits, an error state behind the data",
        b"VL2K1-0c8b7ab github.com/normaldotcom/canable2.git\rt1232DEAD0001E240\rt1231AA0\r",
        &["123#DEAD", "123#AA"],
        (3, 0, 0),
        "",
    ),
    (
        "CANdapter: `x` for 29 bits, and a line feed behind each line",
        b"\r\nx18FEF100105\r\nt1230\r\n",
        &["18FEF100#05", "123#"],
        (3, 0, 0),
        "",
    ),
    ("an adapter on CAN FD", b"d1239000102030405060708090A0B\rb12310\rt1230\r", &["123#"], (1, 2, 0), ""),
    (
        "another program on the port",
        b"Booting\x1b[2J...\rt12\rt1232DE\rt1239\rE1\rt1231FF\r",
        &["123#FF"],
        (1, 0, 5),
        "Booting\\u{1b}[2J...",
    ),
];

#[test]
fn what_real_adapters_say_is_heard_or_counted() {
    for (name, script, frames, (understood, fd_frames, unknown), first_unknown) in SCRIPTS {
        // Whole, and byte by byte as from a slow port.
        for size in [script.len(), 1] {
            let line = Line::default();
            locked(&line).room = usize::MAX;
            let mut adapter = SlcanAdapter::open(Arc::clone(&line), 250_000).unwrap();
            let mut heard = Vec::new();
            for part in script.chunks(size) {
                locked(&line).incoming.extend(part);
                heard
                    .extend(std::iter::from_fn(|| adapter.receive().unwrap()).map(|frame| frame.to_string()));
            }
            assert_eq!(heard, *frames, "{name}");
            let first_unknown = (*first_unknown).to_owned();
            let (understood, fd_frames, unknown) = (*understood, *fd_frames, *unknown);
            assert_eq!(adapter.said(), Said { understood, fd_frames, unknown, first_unknown }, "{name}");
        }
    }
}

#[test]
fn a_line_without_end_is_counted_and_the_next_one_heard() {
    let line = Line::default();
    locked(&line).room = usize::MAX;
    let mut adapter = SlcanAdapter::open(Arc::clone(&line), 250_000).unwrap();
    locked(&line).incoming.extend([b'~'; 10_000].iter().chain(b"\rt1230\r"));
    // It reads some thousand bytes at a time.
    let heard = (0..10).filter_map(|_| adapter.receive().unwrap()).count();
    assert_eq!((heard, adapter.said().unknown), (1, 1));
}

#[cfg(unix)]
mod serial {
    use super::*;
    use crate::join::pty::{Pty, SerialPort, open_terminal};

    /// The other side of the terminal may be late: asks until `done`, or says what is missing.
    fn until<T: Tool>(world: &mut World<T>, what: &str, mut done: impl FnMut(&mut World<T>) -> bool) {
        for _ in 0..10_000 {
            world.turn();
            if done(world) {
                return;
            }
            std::thread::yield_now();
        }
        panic!("never: {what}");
    }

    #[test]
    fn a_pseudo_terminal_joins_two_programs_and_outlives_its_clients() {
        let pty = Pty::open().unwrap();
        let path = pty.path().to_owned();
        let mut world = World::new(Terminal::new("slcan", pty));
        world.turn();
        for client in 0..3 {
            let port = SerialPort::open(&path, 115_200).unwrap();
            let mut adapter = SlcanAdapter::open(port, BITRATE).unwrap();
            let frame = extended(0x100 + client, &[0x0D, 0x0A, 0x00, 0x11, 0x13, 0x03, 0x04, 0x7F]);
            adapter.send(&frame).unwrap();
            until(&mut world, "the client's frame is on the bus", |world| world.heard.pop() == Some(frame));
            let reply = extended(0x200 + client, &[]);
            world.send_from_other(reply);
            let mut heard = Vec::new();
            until(&mut world, "the client hears the bus", |_| {
                heard.extend(adapter.receive().unwrap());
                !heard.is_empty()
            });
            assert_eq!(heard, [reply], "and nothing of what was meant for the one before");
            assert_eq!(adapter.refused(), 0);
            // The next client must not find this one.
            world.send_from_other(extended(0x300, &[]));
            world.turn();
            drop(adapter);
            world.turn();
            world.turn();
        }
    }

    #[test]
    fn a_client_does_not_read_what_was_meant_for_the_one_before() {
        let pty = Pty::open().unwrap();
        let path = pty.path().to_owned();
        let mut world = World::new(Terminal::new("slcan", pty));
        world.turn();
        // Clients that set nothing and throw nothing away, as a shell's redirection.
        let client = open_terminal(&path).unwrap();
        rustix::io::write(&client, b"O\r").unwrap();
        until(&mut world, "the channel is open", |world| world.tool.is_open());
        world.send_from_other(extended(1, &[]));
        world.turn();
        drop(client);
        world.turn();
        let client = open_terminal(&path).unwrap();
        rustix::io::write(&client, b"V\r").unwrap();
        let mut bytes = [0; 64];
        let mut count = 0;
        until(&mut world, "the answer comes", |_| {
            count = rustix::io::read(&client, &mut bytes).unwrap_or(0);
            count > 0
        });
        assert_eq!(String::from_utf8_lossy(&bytes[..count]), "V0101\r");
    }

    #[test]
    fn a_client_that_writes_and_is_gone_is_still_heard() {
        let pty = Pty::open().unwrap();
        let path = pty.path().to_owned();
        let mut world = World::new(Terminal::new("slcan", pty));
        world.turn();
        std::fs::write(&path, "O\rt1232BEEF\r").unwrap();
        let frame = Frame::new(Id::standard(0x123).unwrap(), &[0xBE, 0xEF]).unwrap();
        until(&mut world, "the frame is on the bus", |world| world.heard.contains(&frame));
    }

    #[test]
    fn a_serial_port_that_is_none_is_named() {
        for (path, hint) in [("/dev/ttyNONE9", "plugged in"), ("/dev/null", "not a serial port")] {
            let Err(error) = SerialPort::open(std::path::Path::new(path), 115_200) else {
                panic!("{path} was opened")
            };
            assert!(error.to_string().contains(hint), "{error}");
        }
    }
}
