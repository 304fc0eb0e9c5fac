//! The PC link's records: what the firmware tells a computer, and how it is framed.
//!
//! Owns the record types, their bytes and the resynchronising [`Decoder`]; the same bytes go over a UART and over USB.
//! Refuses to know ports, rates and when a record is due. One frame on the wire, before COBS:
//!
//! | bytes  | what                                                     |
//! |--------|----------------------------------------------------------|
//! | 1      | [`VERSION`]                                              |
//! | 1 to n | one [`Record`], postcard                                 |
//! | 2      | CRC-16/IBM-3740 over all bytes before it, low byte first |
//!
//! COBS removes the zero bytes, a zero ends the frame. A zero may also stand before a frame: empty frames are silent.
//! Source: postcard 1.0 wire format; Cheshire and Baker, "Consistent Overhead Byte Stuffing", 1999.

use crate::model::Shown;
use crate::states::Confinement;
pub use crate::states::ResetReason;
use core::fmt;
use serde::de::{Error, SeqAccess, Visitor};
use serde::ser::SerializeSeq;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Version of the records; raised with every change of [`Record`] that an older decoder would misread.
pub const VERSION: u8 = 4;

/// Bytes of the longest record.
const MAX_RECORD: usize = 144;
/// Version, record and CRC.
const MAX_PAYLOAD: usize = 1 + MAX_RECORD + 2;
/// Bytes of the longest frame with its terminator; an output buffer of this size is always enough.
// COBS adds one byte to anything up to 254 bytes.
pub const MAX_FRAME: usize = MAX_PAYLOAD + 2;
/// Values in one [`Record::Values`].
pub const CHUNK: usize = 16;

const CRC: crc::Crc<u16> = crc::Crc::<u16>::new(&crc::CRC_16_IBM_3740);

/// One record of the PC link.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Record {
    /// Program, version and vehicle of the sender; sent at start and every few seconds.
    Hello {
        /// Version of the firmware, for example `0.1.0`.
        version: Excerpt<16>,
        /// Name of the vehicle's folder; empty while no vehicle has been recognised.
        vehicle: Excerpt<16>,
        /// First 32 bits of the build's identity, 0 = unknown.
        build: u32,
    },
    /// Load, worst cases and counters of the firmware since power-on.
    Health(Health),
    /// A chunk of the model's values in the order of `Value::ALL`.
    Values {
        /// Index of the first value.
        first: u8,
        /// The values from `first` on.
        items: Chunk,
    },
    /// What the screen shows now.
    Shown(Screen),
    /// The panic that ended the previous run.
    Panic {
        /// Source line.
        line: u32,
        /// File and message, cut off where there is no more room.
        text: Excerpt<64>,
    },
    /// Trips, consumption and range.
    Trips(Trips),
    /// One active fault, in turn; each new one at once.
    Active {
        /// How many are active.
        count: u8,
        /// One of them; `None` = none is active.
        fault: Option<Fault>,
    },
    /// One fault since power-on, in turn; each new one at once.
    Remembered {
        /// How many are remembered.
        count: u8,
        /// One of them.
        fault: Fault,
        /// When it came last, in milliseconds since power-on.
        last_ms: u64,
    },
}

/// Trips, consumption and range.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Trips {
    /// Trip A and trip B.
    pub trips: [Trip; 2],
    /// Present consumption in Wh/km, negative = regained.
    pub consumption_whkm: Sample,
    /// Remaining range in km.
    pub range_km: Sample,
    /// The range is the cluster's own estimate.
    pub range_is_estimated: bool,
}

/// A trip of the driver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Trip {
    /// Distance in 0.1 km.
    pub hectometres: u32,
    /// Average consumption in Wh/km; `None` = too short to say.
    pub average_whkm: Option<i32>,
    /// Energy out of the battery in Wh.
    pub used_watthours: u32,
    /// Energy back into the battery by driving in Wh.
    pub regained_watthours: u32,
}

/// A fault, active or remembered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fault {
    /// Its number in the list, from 0.
    pub place: u8,
    /// Number of its row in the cluster's table of faults.
    pub fault: u8,
    /// Place among the row's texts, from 0.
    pub stage: u8,
    /// Code; of an alarm bit its number, from 1.
    pub code: Option<u16>,
    /// How bad, in the model's numbers (`Unit::Severity`); 0 = information.
    pub severity: u8,
    /// When it came first, in milliseconds since power-on.
    pub first_ms: u64,
    /// How often it has come.
    pub times: u16,
}

/// How the firmware is; counters since power-on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Health {
    /// Milliseconds since power-on.
    pub uptime_ms: u64,
    /// Frames taken out of the CAN controller.
    pub frames_received: u32,
    /// Frames dropped because they had too few bytes.
    pub frames_dropped_short: u32,
    /// Frames dropped because their checksum was wrong.
    pub frames_damaged: u32,
    /// Frames with an identifier that the vehicle's table does not have.
    pub frames_unknown: u32,
    /// Times that the CAN controller had no room for a frame.
    pub overruns: u32,
    /// Frames lost because the queue between interrupt and tick was full.
    pub ring_overflows: u32,
    /// Fault confinement of the CAN controller; `None` = not started, or not answering.
    #[serde(with = "confinement")]
    pub can_state: Option<Confinement>,
    /// Transmit error counter.
    pub tec: u8,
    /// Receive error counter.
    pub rec: u8,
    /// Frames sent and acknowledged.
    pub frames_sent: u32,
    /// Failed or nonsensical SPI transactions.
    pub spi_errors: u32,
    /// Screens drawn.
    pub draws: u32,
    /// Longest draw, in microseconds.
    pub max_draw_us: u32,
    /// Share of the last second that the CPU slept, in 0.1 %.
    pub idle_permille: u16,
    /// Resets since the supply came up.
    pub resets: u16,
    /// Why the firmware started last.
    #[serde(with = "reset_reason")]
    pub last_reset: ResetReason,
}

/// Writes fault confinement as its number, 0 = the controller does not answer; as its word where a person reads it.
mod confinement {
    use crate::states::Confinement;
    use serde::de::{Error, Unexpected};
    use serde::{Deserialize, Deserializer, Serializer};

    pub(super) fn serialize<S: Serializer>(state: &Option<Confinement>, to: S) -> Result<S::Ok, S::Error> {
        if to.is_human_readable() {
            return to.serialize_str(state.map_or(Confinement::OFFLINE, Confinement::word));
        }
        to.serialize_u8(state.map_or(0, |state| state as u8))
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Confinement>, D::Error> {
        let number = u8::deserialize(from)?;
        match Confinement::from_number(number.into()) {
            None if number != 0 => Err(D::Error::invalid_value(
                Unexpected::Unsigned(number.into()),
                &"a state of fault confinement",
            )),
            state => Ok(state),
        }
    }
}

/// Writes why the firmware started as its number; as its word where a person reads it.
mod reset_reason {
    use crate::states::ResetReason;
    use serde::de::{Error, Unexpected};
    use serde::{Deserialize, Deserializer, Serializer};

    pub(super) fn serialize<S: Serializer>(reason: &ResetReason, to: S) -> Result<S::Ok, S::Error> {
        if to.is_human_readable() {
            return to.serialize_str(reason.word());
        }
        to.serialize_u8(*reason as u8)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<ResetReason, D::Error> {
        let number = u8::deserialize(from)?;
        let unknown = || D::Error::invalid_value(Unexpected::Unsigned(number.into()), &"a reason of a start");
        ResetReason::from_number(number.into()).ok_or_else(unknown)
    }
}

/// One value of the model as the cluster would show it: [`Shown`] on the wire.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Sample {
    /// Never received.
    #[default]
    Never,
    /// Its message has stopped arriving.
    Stale,
    /// Marked as not valid by the sender.
    Invalid,
    /// Fresh and valid, in the value's unit.
    Value(i32),
}

impl From<Shown<i32>> for Sample {
    fn from(shown: Shown<i32>) -> Self {
        match shown {
            Shown::Never => Self::Never,
            Shown::Stale => Self::Stale,
            Shown::Invalid => Self::Invalid,
            Shown::Value(value) => Self::Value(value),
        }
    }
}

impl From<Sample> for Shown<i32> {
    fn from(sample: Sample) -> Self {
        match sample {
            Sample::Never => Self::Never,
            Sample::Stale => Self::Stale,
            Sample::Invalid => Self::Invalid,
            Sample::Value(value) => Self::Value(value),
        }
    }
}

/// What the screen shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Screen {
    /// Milliseconds since power-on.
    pub time_ms: u64,
    /// Road speed, whole km/h.
    pub speed_kmh: Sample,
    /// Gear in the model's numbers (`Unit::Gear`), 0 = none shown.
    pub gear: u8,
    /// State of charge, whole percent.
    pub soc_percent: Sample,
    /// Pack voltage in 0.1 V.
    pub pack_decivolts: Sample,
    /// Pack current in 0.1 A, positive = out of the battery.
    pub pack_deciamps: Sample,
    /// Motor speed in rpm, negative = backwards.
    pub motor_rpm: Sample,
    /// Motor temperature in degrees Celsius.
    pub motor_celsius: Sample,
    /// Motor controller temperature in degrees Celsius.
    pub inverter_celsius: Sample,
    /// Total distance in 0.1 km.
    pub odometer_hectometres: u32,
    /// Number of the page: 0 main, 1 and 2 trips, 3 energy, 4 faults, 5 history, 6 and more technical.
    pub page: u8,
    /// Seconds until the battery opens the high-voltage circuit, while it asks for that.
    pub hv_off_s: Option<u8>,
    /// The vehicle limps.
    pub limps: bool,
    /// Largest current in limp mode in 0.1 A, if it is known.
    pub limp_deciamps: Option<i32>,
    /// What an inserted plug does, in the numbers of [`Plug`](crate::states::Plug).
    pub plug: Option<u8>,
    /// Lit lamps, bit n = n-th lamp of the cluster's list.
    pub telltales: u32,
    /// The message line, if one is shown.
    pub line: Option<ScreenLine>,
    /// A fault that came and went, until it is acknowledged.
    pub unseen: Option<ScreenLine>,
    /// A fault that is milder than the STOP on the line.
    pub below: Option<ScreenLine>,
}

/// The message line of the screen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ScreenLine {
    /// Number of the row in the cluster's table of faults.
    pub fault: u8,
    /// Place among the row's texts, from 0.
    pub stage: u8,
    /// Code; of an alarm bit its number, from 1, which is not shown.
    pub code: Option<u16>,
    /// How bad, in the model's numbers (`Unit::Severity`); 0 = information.
    pub severity: u8,
    /// This line's number among those that take turns, from 1.
    pub position: u8,
    /// How many lines take turns.
    pub count: u8,
}

/// Up to [`CHUNK`] values.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub struct Chunk {
    len: u8,
    items: [Sample; CHUNK],
}

impl Chunk {
    /// Returns an empty chunk.
    pub const fn new() -> Self {
        Self { len: 0, items: [Sample::Never; CHUNK] }
    }

    /// Adds a value; `false` = the chunk is full and unchanged.
    pub fn push(&mut self, sample: Sample) -> bool {
        match self.items.get_mut(usize::from(self.len)) {
            Some(item) => {
                *item = sample;
                self.len += 1;
                true
            }
            None => false,
        }
    }

    /// Returns the values.
    pub fn as_slice(&self) -> &[Sample] {
        self.items.get(..usize::from(self.len)).unwrap_or(&self.items)
    }
}

/// Takes the first [`CHUNK`] values of an iterator.
impl FromIterator<Sample> for Chunk {
    fn from_iter<I: IntoIterator<Item = Sample>>(samples: I) -> Self {
        let mut chunk = Self::new();
        for sample in samples.into_iter().take(CHUNK) {
            chunk.push(sample);
        }
        chunk
    }
}

impl fmt::Debug for Chunk {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.as_slice()).finish()
    }
}

impl Serialize for Chunk {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut seq = serializer.serialize_seq(Some(usize::from(self.len)))?;
        for sample in self.as_slice() {
            seq.serialize_element(sample)?;
        }
        seq.end()
    }
}

impl<'de> Deserialize<'de> for Chunk {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Items;

        impl<'de> Visitor<'de> for Items {
            type Value = Chunk;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "at most {CHUNK} values")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Chunk, A::Error> {
                let mut chunk = Chunk::new();
                while let Some(sample) = seq.next_element()? {
                    if !chunk.push(sample) {
                        return Err(A::Error::custom("more values than a chunk holds"));
                    }
                }
                Ok(chunk)
            }
        }

        deserializer.deserialize_seq(Items)
    }
}

/// Up to `N` bytes of text; what does not fit is cut off between two characters.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Excerpt<const N: usize> {
    len: u8,
    bytes: [u8; N],
}

impl<const N: usize> Excerpt<N> {
    /// Returns an empty text.
    pub const fn new() -> Self {
        const { assert!(N <= u8::MAX as usize) };
        Self { len: 0, bytes: [0; N] }
    }

    /// Returns the text.
    pub fn as_str(&self) -> &str {
        let bytes = self.bytes.get(..usize::from(self.len)).unwrap_or_default();
        core::str::from_utf8(bytes).unwrap_or_default()
    }

    /// Appends as many whole characters of `text` as fit; `false` = something was cut off.
    pub fn push_str(&mut self, text: &str) -> bool {
        let start = usize::from(self.len);
        let mut keep = text.len().min(N - start.min(N));
        while !text.is_char_boundary(keep) {
            keep -= 1;
        }
        match (self.bytes.get_mut(start..start + keep), text.as_bytes().get(..keep)) {
            (Some(room), Some(kept)) => {
                room.copy_from_slice(kept);
                self.len += keep as u8;
                keep == text.len()
            }
            _ => false,
        }
    }
}

impl<const N: usize> Default for Excerpt<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize> From<&str> for Excerpt<N> {
    fn from(text: &str) -> Self {
        let mut excerpt = Self::new();
        excerpt.push_str(text);
        excerpt
    }
}

/// Writes what fits and cuts the rest off: a panic message that is too long is still worth its first words.
impl<const N: usize> fmt::Write for Excerpt<N> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        if self.push_str(text) { Ok(()) } else { Err(fmt::Error) }
    }
}

impl<const N: usize> fmt::Debug for Excerpt<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self.as_str(), f)
    }
}

impl<const N: usize> Serialize for Excerpt<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.as_str())
    }
}

impl<'de, const N: usize> Deserialize<'de> for Excerpt<N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Words<const N: usize>;

        impl<const N: usize> Visitor<'_> for Words<N> {
            type Value = Excerpt<N>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "a text of at most {N} bytes")
            }

            fn visit_str<E: Error>(self, text: &str) -> Result<Excerpt<N>, E> {
                let mut excerpt = Excerpt::new();
                if excerpt.push_str(text) { Ok(excerpt) } else { Err(E::custom("text is too long")) }
            }
        }

        deserializer.deserialize_str(Words)
    }
}

/// Writes `record` as one frame with its terminator into `out` and returns its length.
///
/// `None` = `out` is too small; [`MAX_FRAME`] bytes are always enough.
pub fn encode(record: &Record, out: &mut [u8]) -> Option<usize> {
    let mut payload = [0; MAX_PAYLOAD];
    let (version, body) = payload.split_first_mut()?;
    *version = VERSION;
    let end = 1 + postcard::to_slice(record, body.get_mut(..MAX_RECORD)?).ok()?.len();
    let crc = CRC.checksum(payload.get(..end)?);
    payload.get_mut(end..end + 2)?.copy_from_slice(&crc.to_le_bytes());

    let payload = payload.get(..end + 2)?;
    // One byte of overhead up to 254 bytes, one for the terminator.
    let frame = out.get_mut(..payload.len() + 2)?;
    let len = cobs::try_encode(payload, frame).ok()?;
    *frame.get_mut(len)? = 0;
    Some(len + 1)
}

/// Why a stretch of bytes between two zeros is not a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkError {
    /// More bytes than any frame has: noise, or the wrong bit rate.
    TooLong,
    /// Not a COBS frame, or too few bytes for version and CRC: cut off.
    Malformed,
    /// The CRC does not match: damaged on the way.
    Crc,
    /// Another version of the records; holds the sender's. Use the tools of the same release as the firmware.
    Version(u8),
    /// The frame is intact but is none of this version's records.
    Unknown,
}

impl fmt::Display for LinkError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLong => write!(f, "more than {MAX_FRAME} bytes without a frame end: check the bit rate"),
            Self::Malformed => write!(f, "cut off or no COBS frame"),
            Self::Crc => write!(f, "CRC does not match: damaged on the way"),
            Self::Version(theirs) => {
                write!(
                    f,
                    "record version {theirs}, this tool reads {VERSION}: use the tool of the firmware's release"
                )
            }
            Self::Unknown => write!(f, "intact frame, but no record of version {VERSION}"),
        }
    }
}

impl core::error::Error for LinkError {}

/// Finds records in a stream of bytes; picks up again at the next zero after noise.
#[derive(Clone)]
pub struct Decoder {
    buffer: [u8; MAX_FRAME],
    len: usize,
    too_long: bool,
}

impl Default for Decoder {
    fn default() -> Self {
        Self::new()
    }
}

impl Decoder {
    /// Returns a decoder that waits for its first frame.
    pub const fn new() -> Self {
        Self { buffer: [0; MAX_FRAME], len: 0, too_long: false }
    }

    /// Takes one byte; returns a record or an error when the byte ends a frame.
    ///
    /// # Errors
    ///
    /// The stretch that the byte ends is not a record; the next frame is not affected.
    pub fn push(&mut self, byte: u8) -> Option<Result<Record, LinkError>> {
        if byte != 0 {
            match self.buffer.get_mut(self.len) {
                Some(room) => {
                    *room = byte;
                    self.len += 1;
                }
                None => self.too_long = true,
            }
            return None;
        }
        let len = core::mem::take(&mut self.len);
        if core::mem::take(&mut self.too_long) {
            return Some(Err(LinkError::TooLong));
        }
        if len == 0 {
            return None;
        }
        Some(self.buffer.get_mut(..len).ok_or(LinkError::TooLong).and_then(decode))
    }
}

/// Decodes the bytes of one frame, without its terminator, in place.
fn decode(frame: &mut [u8]) -> Result<Record, LinkError> {
    let len = cobs::decode_in_place(frame).map_err(|_| LinkError::Malformed)?;
    let (body, crc) = frame.get(..len).and_then(<[u8]>::split_last_chunk).ok_or(LinkError::Malformed)?;
    if CRC.checksum(body) != u16::from_le_bytes(*crc) {
        return Err(LinkError::Crc);
    }
    let (&version, record) = body.split_first().ok_or(LinkError::Malformed)?;
    if version != VERSION {
        return Err(LinkError::Version(version));
    }
    match postcard::take_from_bytes(record) {
        Ok((record, [])) => Ok(record),
        _ => Err(LinkError::Unknown),
    }
}
