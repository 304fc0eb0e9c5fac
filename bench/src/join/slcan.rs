//! SLCAN, the text protocol of serial CAN adapters: commands, answers, lines.
//!
//! Pure: bytes to commands and answers and back, both sides of the wire. Each line ends with CR; BEL says that a command
//! was refused. A line that is too long is thrown away whole and the next one is read again. Refuses to know what
//! is open: that is [`super::terminal`] for the adapter's side and [`super::adapter`] for the other.
//!
//! As a client it takes what adapters really say: what stands behind the data of a frame is no matter of ours (time
//! stamps of four or eight digits, error states), as Linux's slcan driver and python-can have it.
//!
//! Source: LAWICEL CAN232 manual, command set of version 3; python-can's `slcan` and SavvyCAN's LAWICEL driver for
//! what clients really send (an empty line, an open channel opened again, bit 31 set in 29-bit identifiers).
//! Not supported: CAN FD (`d D b B`), polling (`P A X`), the UART's speed (`U`), autostart (`Q`): refused with BEL.

use crate::can::{Frame, Id};
use crate::time::Nanos;

/// Ends a line.
const CR: u8 = b'\r';
/// Some terminals send it after CR; skipped.
const LF: u8 = b'\n';
/// The answer to a command that is refused; it has no CR.
const BELL: u8 = 0x07;
/// Longest line of a client, CR not counted: `T`, 8 digits, length, 16 digits of data, 4 of the time stamp, and some air.
pub const LINE_MAX: usize = 32;
/// Longest line of an adapter: a frame of CAN FD has 138 digits, and a version is a whole sentence in some.
const ANSWER_MAX: usize = 256;
/// Time stamps count milliseconds and start again after a minute.
const STAMP_WRAP_MS: u64 = 60_000;
/// Data bytes of a classic frame; the length is one decimal digit.
const LENGTH_MAX: u8 = 8;
/// Set by SavvyCAN in the identifier of 29-bit frames that it sends.
const EXTENDED_FLAG: u32 = 1 << 31;
/// Clock of the SJA1000 that the `s` command speaks of, in Hz.
const SJA1000_CLOCK_HZ: u32 = 8_000_000;

/// Bit rates of `S0` to `S9`, in bit/s. python-can calls `S7` 750 kbit/s; `S9` is not in the manual, but in python-can.
const BITRATES: [u32; 10] =
    [10_000, 20_000, 50_000, 100_000, 125_000, 250_000, 500_000, 800_000, 1_000_000, 83_300];

/// What a client asks of an adapter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// An empty line.
    Nothing,
    /// `S0` to `S9`: one of the bit rates.
    Setup(u8),
    /// `sxxyy`: the SJA1000's bus timing registers 0 and 1.
    Timing(u8, u8),
    /// `O`: takes part.
    Open,
    /// `L`: hears and is never heard.
    Listen,
    /// `C`: leaves.
    Close,
    /// `t T r R`: sends a frame.
    Send(Frame),
    /// `V`: hardware and software version.
    Version,
    /// `v`: software version.
    Software,
    /// `N`: serial number.
    Serial,
    /// `F`: status flags, which are cleared.
    Status,
    /// `Z0`, `Z1`: time stamps behind received frames.
    Stamps(bool),
    /// `M`: acceptance code of the SJA1000.
    AcceptanceCode(u32),
    /// `m`: acceptance mask of the SJA1000.
    AcceptanceMask(u32),
}

impl Command {
    /// Reads a line without its CR; `None` is for what must be refused.
    pub fn parse(line: &[u8]) -> Option<Self> {
        let Some((&letter, rest)) = line.split_first() else { return Some(Self::Nothing) };
        match (letter, rest) {
            (b'S', [digit @ b'0'..=b'9']) => Some(Self::Setup(digit - b'0')),
            (b's', rest) => {
                let [.., timing0, timing1] = hex(rest, 4)?.to_be_bytes();
                Some(Self::Timing(timing0, timing1))
            }
            (b'O', []) => Some(Self::Open),
            (b'L', []) => Some(Self::Listen),
            (b'C', []) => Some(Self::Close),
            (b't' | b'T' | b'r' | b'R', rest) => match frame(letter, rest)? {
                (frame, []) => Some(Self::Send(frame)),
                _ => None,
            },
            (b'V', []) => Some(Self::Version),
            (b'v', []) => Some(Self::Software),
            (b'N', []) => Some(Self::Serial),
            (b'F', []) => Some(Self::Status),
            (b'Z', [switch @ (b'0' | b'1')]) => Some(Self::Stamps(*switch == b'1')),
            (b'M', rest) => Some(Self::AcceptanceCode(hex(rest, 8)?)),
            (b'm', rest) => Some(Self::AcceptanceMask(hex(rest, 8)?)),
            _ => None,
        }
    }

    /// Returns the line with its CR.
    pub fn line(&self) -> Vec<u8> {
        let mut text = match self {
            Self::Nothing => String::new(),
            Self::Setup(code) => format!("S{code}"),
            Self::Timing(timing0, timing1) => format!("s{timing0:02X}{timing1:02X}"),
            Self::Open => "O".into(),
            Self::Listen => "L".into(),
            Self::Close => "C".into(),
            Self::Send(frame) => frame_text(frame),
            Self::Version => "V".into(),
            Self::Software => "v".into(),
            Self::Serial => "N".into(),
            Self::Status => "F".into(),
            Self::Stamps(on) => format!("Z{}", u8::from(*on)),
            Self::AcceptanceCode(code) => format!("M{code:08X}"),
            Self::AcceptanceMask(mask) => format!("m{mask:08X}"),
        };
        text.push(char::from(CR));
        text.into_bytes()
    }

    /// Returns the command that sets a bit rate in bit/s, if the protocol has one for it.
    pub fn setup(bitrate: u32) -> Option<Self> {
        let code = BITRATES.iter().position(|known| *known == bitrate)?;
        u8::try_from(code).ok().map(Self::Setup)
    }

    /// Returns the bit rate in bit/s that this command sets; `None` if it sets none.
    pub fn bitrate(&self) -> Option<u32> {
        match *self {
            Self::Setup(code) => BITRATES.get(usize::from(code)).copied(),
            Self::Timing(timing0, timing1) => {
                let prescaler = u32::from(timing0 & 0x3F) + 1;
                let quanta = 1 + (u32::from(timing1 & 0x0F) + 1) + (u32::from(timing1 >> 4 & 0x07) + 1);
                Some(SJA1000_CLOCK_HZ / (prescaler * quanta))
            }
            _ => None,
        }
    }
}

/// Bit rates that the protocol can name, in bit/s.
pub fn bitrates() -> impl Iterator<Item = u32> {
    BITRATES.into_iter()
}

/// Something that `F` reports, as the mask of its bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Flag {
    /// The queue of received frames was full.
    ReceiveFull = 0x01,
    /// The queue of frames to be sent was full.
    TransmitFull = 0x02,
    /// An error counter stands at 96 or more.
    Warning = 0x04,
    /// Received frames were lost.
    Overrun = 0x08,
    /// The node is error-passive, or bus-off.
    Passive = 0x20,
    /// Arbitration was lost.
    ArbitrationLost = 0x40,
    /// There was an error on the bus.
    BusError = 0x80,
}

/// What an adapter says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// CR: done.
    Done,
    /// `z`, `Z`: the frame waits to be sent.
    Queued {
        /// It has 29 bits.
        extended: bool,
    },
    /// BEL: refused.
    Refused,
    /// `Vhhss`: versions as four decimal digits.
    Version([u8; 4]),
    /// `vssss`: software version as four decimal digits.
    Software([u8; 4]),
    /// `Nxxxx`: serial number, four letters or digits.
    Serial([u8; 4]),
    /// `Fxx`: [`Flag`]s since the last question.
    Status(u8),
    /// A frame from the bus.
    Received {
        /// What was received.
        frame: Frame,
        /// Milliseconds of the minute, if time stamps are on.
        stamp: Option<u16>,
    },
}

impl Answer {
    /// Reads a line without its end; `None` if it is not understood. What stands behind the data of a frame is ignored,
    /// but for a time stamp of four digits.
    pub fn parse(line: &[u8]) -> Option<Self> {
        let Some((&letter, rest)) = line.split_first() else { return Some(Self::Done) };
        let four = || <[u8; 4]>::try_from(rest).ok();
        match (letter, rest) {
            (b'z' | b'Z', []) => Some(Self::Queued { extended: letter == b'Z' }),
            (b'V', _) => four().filter(|text| text.iter().all(u8::is_ascii_digit)).map(Self::Version),
            (b'v', _) => four().filter(|text| text.iter().all(u8::is_ascii_digit)).map(Self::Software),
            (b'N', _) => four().filter(|text| text.iter().all(u8::is_ascii_alphanumeric)).map(Self::Serial),
            (b'F', _) => u8::try_from(hex(rest, 2)?).ok().map(Self::Status),
            (b't' | b'T' | b'r' | b'R' | b'x', _) => {
                // CANdapter has `x` for `T`.
                let letter = if letter == b'x' { b'T' } else { letter };
                let (frame, rest) = frame(letter, rest)?;
                let stamp = hex(rest, 4).and_then(|stamp| u16::try_from(stamp).ok());
                Some(Self::Received { frame, stamp })
            }
            _ => None,
        }
    }

    /// Returns the bytes with their end: CR, or the lone BEL.
    pub fn line(&self) -> Vec<u8> {
        let mut line = match self {
            Self::Refused => return vec![BELL],
            Self::Done => Vec::new(),
            Self::Queued { extended } => vec![if *extended { b'Z' } else { b'z' }],
            Self::Version(text) => with_letter(b'V', text),
            Self::Software(text) => with_letter(b'v', text),
            Self::Serial(text) => with_letter(b'N', text),
            Self::Status(flags) => format!("F{flags:02X}").into_bytes(),
            Self::Received { frame, stamp } => {
                let mut text = frame_text(frame);
                if let Some(stamp) = stamp {
                    text += &format!("{stamp:04X}");
                }
                text.into_bytes()
            }
        };
        line.push(CR);
        line
    }
}

fn with_letter(letter: u8, text: &[u8]) -> Vec<u8> {
    [&[letter], text].concat()
}

/// Returns the time stamp of a frame: milliseconds of the minute.
pub fn stamp(at: Nanos) -> u16 {
    // Below 60 000.
    (at.0 / 1_000_000 % STAMP_WRAP_MS) as u16
}

/// Reads exactly `digits` hexadecimal digits, at most 8.
fn hex(text: &[u8], digits: usize) -> Option<u32> {
    if text.len() != digits {
        return None;
    }
    text.iter().try_fold(0, |number, byte| Some(number << 4 | char::from(*byte).to_digit(16)?))
}

/// Reads what follows the letter of a frame; also returns what stands behind it.
fn frame(letter: u8, text: &[u8]) -> Option<(Frame, &[u8])> {
    let extended = letter.is_ascii_uppercase();
    let (id, text) = text.split_at_checked(if extended { 8 } else { 3 })?;
    let id = hex(id, id.len())?;
    let id =
        if extended { Id::extended(id & !EXTENDED_FLAG) } else { Id::standard(u16::try_from(id).ok()?) }?;
    let (&length, mut text) = text.split_first()?;
    let length = length.checked_sub(b'0').filter(|length| *length <= LENGTH_MAX)?;
    if letter.eq_ignore_ascii_case(&b'r') {
        return Some((Frame::new_remote(id, length), text));
    }
    let mut payload = [0; LENGTH_MAX as usize];
    for byte in &mut payload[..usize::from(length)] {
        let (digits, rest) = text.split_at_checked(2)?;
        *byte = u8::try_from(hex(digits, 2)?).ok()?;
        text = rest;
    }
    Some((Frame::new(id, &payload[..usize::from(length)])?, text))
}

/// Returns a frame as both sides write it. A length code above 8 is written as 8: the protocol has one digit for it.
fn frame_text(frame: &Frame) -> String {
    let letter = match (frame.id.is_extended(), frame.remote) {
        (true, false) => 'T',
        (true, true) => 'R',
        (false, false) => 't',
        (false, true) => 'r',
    };
    let digits = if frame.id.is_extended() { 8 } else { 3 };
    let head = format!("{letter}{:0digits$X}{}", frame.id.raw(), frame.dlc.min(LENGTH_MAX));
    frame.payload().iter().fold(head, |text, byte| text + &format!("{byte:02X}"))
}

/// One line of a stream.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line<'a> {
    /// What stood before the CR.
    Text(&'a [u8]),
    /// More bytes than any line has stood before the CR; they are gone.
    TooLong,
    /// A BEL where answers are read. What stood before it is gone: no answer is cut by one.
    Bell,
}

/// Cuts a stream of bytes into lines.
#[derive(Clone, Debug)]
pub struct Lines {
    line: [u8; ANSWER_MAX],
    length: usize,
    /// Longest line that is taken.
    limit: usize,
    too_long: bool,
    bells: bool,
}

impl Lines {
    /// Of a client: BEL is a byte like any other.
    pub fn of_commands() -> Self {
        Self { line: [0; ANSWER_MAX], length: 0, limit: LINE_MAX, too_long: false, bells: false }
    }

    /// Of an adapter: BEL is an answer.
    pub fn of_answers() -> Self {
        Self { bells: true, limit: ANSWER_MAX, ..Self::of_commands() }
    }

    /// Takes one byte; returns the line that it ends.
    pub fn push(&mut self, byte: u8) -> Option<Line<'_>> {
        match byte {
            CR => {
                let (length, too_long) = (self.length, self.too_long);
                self.clear();
                Some(if too_long { Line::TooLong } else { Line::Text(&self.line[..length]) })
            }
            BELL if self.bells => {
                self.clear();
                Some(Line::Bell)
            }
            LF => None,
            byte => {
                match self.line[..self.limit].get_mut(self.length) {
                    Some(place) => (*place, self.length) = (byte, self.length + 1),
                    None => self.too_long = true,
                }
                None
            }
        }
    }

    /// Forgets the line that has begun: the other side is another one now.
    pub fn clear(&mut self) {
        (self.length, self.too_long) = (0, false);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn extended(id: u32, payload: &[u8]) -> Frame {
        Frame::new(Id::extended(id).unwrap(), payload).unwrap()
    }

    fn standard(id: u16, payload: &[u8]) -> Frame {
        Frame::new(Id::standard(id).unwrap(), payload).unwrap()
    }

    #[test]
    fn commands_are_read_to_the_byte() {
        let rows: &[(&[u8], Command)] = &[
            (b"", Command::Nothing),
            (b"S5", Command::Setup(5)),
            (b"s031C", Command::Timing(0x03, 0x1C)),
            (b"O", Command::Open),
            (b"L", Command::Listen),
            (b"C", Command::Close),
            (b"t1233DEADBE", Command::Send(standard(0x123, &[0xDE, 0xAD, 0xBE]))),
            (b"t7ff0", Command::Send(standard(0x7FF, &[]))),
            (b"T18FEF10080102030405060708", Command::Send(extended(0x18FE_F100, &[1, 2, 3, 4, 5, 6, 7, 8]))),
            (b"T98FEF100155", Command::Send(extended(0x18FE_F100, &[0x55]))),
            (b"r1238", Command::Send(Frame::new_remote(Id::standard(0x123).unwrap(), 8))),
            (b"R000000010", Command::Send(Frame::new_remote(Id::extended(1).unwrap(), 0))),
            (b"V", Command::Version),
            (b"v", Command::Software),
            (b"N", Command::Serial),
            (b"F", Command::Status),
            (b"Z0", Command::Stamps(false)),
            (b"Z1", Command::Stamps(true)),
            (b"M00000000", Command::AcceptanceCode(0)),
            (b"mFFFFFFFF", Command::AcceptanceMask(u32::MAX)),
        ];
        for (line, command) in rows {
            assert_eq!(Command::parse(line), Some(*command), "{}", String::from_utf8_lossy(line));
        }
    }

    #[test]
    fn what_is_not_a_command_is_refused() {
        let wrong: &[&[u8]] = &[
            b"t1239",
            b"t123",
            b"t12",
            b"t",
            b"t8000",
            b"t1232AA",
            b"t1231AABB",
            b"t1231A",
            b"t1231GG",
            b"T18FEF1009",
            b"T3FFFFFFF0",
            b"T123",
            b"r12380",
            b"S",
            b"S10",
            b"SA",
            b"s12",
            b"s12345",
            b"O ",
            b"OO",
            b"Z",
            b"Z2",
            b"M0",
            b"m123456789",
            b"d12380011223344556677",
            b"X1",
            b"U0",
            b"?",
            b"\x07",
            b"\xFF\xFF",
            b" ",
            b"C1",
            b"F0",
        ];
        for line in wrong {
            assert_eq!(Command::parse(line), None, "{}", String::from_utf8_lossy(line));
        }
    }

    #[test]
    fn answers_are_written_to_the_byte() {
        let frame = extended(0x0CF0_0400, &[0xAB, 0x01]);
        let rows: &[(Answer, &[u8])] = &[
            (Answer::Done, b"\r"),
            (Answer::Refused, b"\x07"),
            (Answer::Queued { extended: false }, b"z\r"),
            (Answer::Queued { extended: true }, b"Z\r"),
            (Answer::Version(*b"0101"), b"V0101\r"),
            (Answer::Serial(*b"BNCH"), b"NBNCH\r"),
            (Answer::Status(0x08), b"F08\r"),
            (Answer::Received { frame, stamp: None }, b"T0CF004002AB01\r"),
            (Answer::Received { frame, stamp: Some(0x1A2B) }, b"T0CF004002AB011A2B\r"),
            (Answer::Received { frame: standard(0x12, &[]), stamp: Some(0) }, b"t01200000\r"),
            (
                Answer::Received { frame: Frame::new_remote(Id::standard(0x7FF).unwrap(), 15), stamp: None },
                b"r7FF8\r",
            ),
        ];
        for (answer, line) in rows {
            assert_eq!(answer.line(), *line, "{answer:?}");
        }
    }

    #[test]
    fn bit_rates_have_their_codes_and_timings() {
        let codes: Vec<_> = bitrates().map(Command::setup).collect();
        assert_eq!(codes, (0..10).map(|code| Some(Command::Setup(code))).collect::<Vec<_>>());
        assert_eq!(Command::setup(251_000), None);
        // LAWICEL's own examples of BTR0 and BTR1: 125, 250 and 500 kbit/s.
        for (timing, bitrate) in [((0x03, 0x1C), 125_000), ((0x01, 0x1C), 250_000), ((0x00, 0x1C), 500_000)] {
            assert_eq!(Command::Timing(timing.0, timing.1).bitrate(), Some(bitrate));
        }
    }

    #[test]
    fn stamps_are_milliseconds_of_the_minute() {
        for (millis, expected) in [(0, 0), (59_999, 59_999), (60_000, 0), (120_001, 1)] {
            assert_eq!(stamp(Nanos::from_millis(millis)), expected);
        }
    }

    #[test]
    fn a_line_that_is_too_long_is_thrown_away_and_the_next_one_is_read() {
        let mut lines = Lines::of_commands();
        for _ in 0..1_000 {
            assert_eq!(lines.push(b't'), None);
        }
        assert_eq!(lines.push(CR), Some(Line::TooLong));
        assert_eq!(lines.push(b'O'), None);
        assert_eq!(lines.push(LF), None);
        assert_eq!(lines.push(CR), Some(Line::Text(b"O")));
        assert_eq!(lines.push(CR), Some(Line::Text(b"")));
    }

    #[test]
    fn a_line_of_the_longest_length_is_still_a_line() {
        let mut lines = Lines::of_commands();
        for _ in 0..LINE_MAX {
            lines.push(b'x');
        }
        assert_eq!(lines.push(CR), Some(Line::Text(&[b'x'; LINE_MAX])));
    }

    #[test]
    fn a_bell_is_an_answer_to_a_client_and_a_byte_to_an_adapter() {
        let mut answers = Lines::of_answers();
        answers.push(b't');
        assert_eq!(answers.push(BELL), Some(Line::Bell));
        assert_eq!(answers.push(CR), Some(Line::Text(b"")));
        let mut commands = Lines::of_commands();
        assert_eq!(commands.push(BELL), None);
        assert_eq!(commands.push(CR), Some(Line::Text(&[BELL])));
    }

    fn any_frame() -> impl Strategy<Value = Frame> {
        let id = prop_oneof![
            (0_u16..=0x7FF).prop_map(|id| Id::standard(id).unwrap()),
            (0_u32..=0x1FFF_FFFF).prop_map(|id| Id::extended(id).unwrap()),
        ];
        (id, any::<bool>(), proptest::collection::vec(any::<u8>(), 0..=8)).prop_map(
            |(id, remote, payload)| {
                if remote {
                    Frame::new_remote(id, payload.len() as u8)
                } else {
                    Frame::new(id, &payload).unwrap()
                }
            },
        )
    }

    fn any_command() -> impl Strategy<Value = Command> {
        prop_oneof![
            Just(Command::Nothing),
            (0_u8..=9).prop_map(Command::Setup),
            any::<(u8, u8)>().prop_map(|(timing0, timing1)| Command::Timing(timing0, timing1)),
            Just(Command::Open),
            Just(Command::Listen),
            Just(Command::Close),
            any_frame().prop_map(Command::Send),
            Just(Command::Version),
            Just(Command::Software),
            Just(Command::Serial),
            Just(Command::Status),
            any::<bool>().prop_map(Command::Stamps),
            any::<u32>().prop_map(Command::AcceptanceCode),
            any::<u32>().prop_map(Command::AcceptanceMask),
        ]
    }

    fn any_answer() -> impl Strategy<Value = Answer> {
        prop_oneof![
            Just(Answer::Done),
            Just(Answer::Refused),
            any::<bool>().prop_map(|extended| Answer::Queued { extended }),
            (0_u16..10_000).prop_map(|n| Answer::Version(format!("{n:04}").into_bytes().try_into().unwrap())),
            (0_u16..10_000)
                .prop_map(|n| Answer::Software(format!("{n:04}").into_bytes().try_into().unwrap())),
            "[A-Za-z0-9]{4}".prop_map(|text| Answer::Serial(text.into_bytes().try_into().unwrap())),
            any::<u8>().prop_map(Answer::Status),
            (any_frame(), proptest::option::of(0_u16..60_000))
                .prop_map(|(frame, stamp)| Answer::Received { frame, stamp }),
        ]
    }

    proptest! {
        #[test]
        fn commands_come_back_from_their_lines(commands in proptest::collection::vec(any_command(), 0..20)) {
            let mut lines = Lines::of_commands();
            let mut read = Vec::new();
            for byte in commands.iter().flat_map(Command::line) {
                if let Some(Line::Text(line)) = lines.push(byte) {
                    read.push(Command::parse(line));
                }
            }
            prop_assert_eq!(read, commands.into_iter().map(Some).collect::<Vec<_>>());
        }

        #[test]
        fn answers_come_back_from_their_lines(answers in proptest::collection::vec(any_answer(), 0..20)) {
            let mut lines = Lines::of_answers();
            let mut read = Vec::new();
            for byte in answers.iter().flat_map(Answer::line) {
                match lines.push(byte) {
                    Some(Line::Text(line)) => read.push(Answer::parse(line)),
                    Some(Line::Bell) => read.push(Some(Answer::Refused)),
                    Some(Line::TooLong) => read.push(None),
                    None => {}
                }
            }
            prop_assert_eq!(read, answers.into_iter().map(Some).collect::<Vec<_>>());
        }

        #[test]
        fn no_bytes_stop_the_reader(noise in proptest::collection::vec(any::<u8>(), 0..200)) {
            let (mut commands, mut answers) = (Lines::of_commands(), Lines::of_answers());
            for byte in noise {
                if let Some(Line::Text(line)) = commands.push(byte) {
                    let _ = Command::parse(line);
                }
                if let Some(Line::Text(line)) = answers.push(byte) {
                    let _ = Answer::parse(line);
                }
            }
            commands.push(CR);
            for byte in Command::Open.line() {
                if let Some(line) = commands.push(byte) {
                    prop_assert_eq!(line, Line::Text(b"O"));
                }
            }
        }
    }
}
