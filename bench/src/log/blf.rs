//! Vector BLF: objects in containers that are packed with zlib, read one container at a time.
//!
//! Read are the messages of classic CAN in each of their four forms; frames of CAN FD and errors are counted, all else is
//! no matter of CAN. Source: python-can's reader and Technica's vector_blf. Not supported: packing other than zlib.

use super::line::{Event, Line, What};
use super::token::{Evidence, Problem, Read, data_length};
use crate::can::{Frame, Id};
use flate2::read::ZlibDecoder;
use std::io::{self, Read as _};

/// First bytes of such a file.
pub(super) const START: &[u8] = b"LOGG";
/// First bytes of each object.
const OBJECT: &[u8] = b"LOBJ";
/// Bytes before what an object itself says: start, two lengths, version, type.
const BASE: usize = 16;
/// Bytes in front of a container's content.
const CONTAINER: usize = 16;
/// Largest container and object; Vector's own containers hold 128 KiB.
const SIZE_MAX: usize = 1 << 26;
/// Objects begin at most so many bytes behind the one before.
const PADDING_MAX: usize = 8;
/// Bit of an identifier that has 29 bits.
const EXTENDED: u32 = 1 << 31;
/// Bit of a message's flags: a remote request.
const REMOTE: u8 = 0x80;
/// Bit of an FD message's flags: it really is one of CAN FD.
const FD: u32 = 0x1;
/// Bits of the same in the newer form.
const FD_64: u32 = 0x1000;
const REMOTE_64: u32 = 0x10;
/// Flag of a header: times count in steps of 10 us, not of 1 ns.
const TEN_MICROS: u32 = 1;

const CONTAINERS: u32 = 10;

/// Reads what an object says behind its head: channel and event; `None` if it is too short.
type ReadBody = fn(&[u8]) -> Option<(String, What)>;

/// Types of the objects that are read, and how.
const MESSAGES: &[(u32, ReadBody)] =
    &[(1, message), (86, message), (2, bus_error), (73, bus_error), (100, fd_message), (101, fd_message_64)];

/// The objects of one file.
pub(super) struct Blf {
    bytes: Box<dyn io::Read + Send>,
    /// Unpacked objects, and how many bytes of them are read.
    objects: Vec<u8>,
    at: usize,
    is_begun: bool,
    /// The file ends inside of an object.
    pub(super) is_cut_off: bool,
}

impl Blf {
    pub(super) fn new(bytes: Box<dyn io::Read + Send>) -> Self {
        Self { bytes, objects: Vec::new(), at: 0, is_begun: false, is_cut_off: false }
    }

    /// Reads the next object; `None` at the end.
    pub(super) fn read(&mut self) -> Read<Option<Line>> {
        if !self.is_begun {
            self.is_begun = true;
            let head = self.take(8)?.ok_or("the head is cut off")?;
            let length = number(&head, 4, 4).ok_or("the head is cut off")? as usize;
            let rest =
                length.checked_sub(8).filter(|rest| *rest <= SIZE_MAX).ok_or("the head has no length")?;
            self.take(rest)?.ok_or("the head is cut off")?;
        }
        loop {
            if let Some(object) = self.object()? {
                return object_line(&object).map(Some);
            }
            self.objects.drain(..self.at);
            self.at = 0;
            if !self.unpack()? {
                self.is_cut_off |= self.objects.windows(OBJECT.len()).any(|bytes| bytes == OBJECT);
                return Ok(None);
            }
        }
    }

    /// Returns the next object that is unpacked and whole.
    fn object(&mut self) -> Read<Option<Vec<u8>>> {
        let rest = &self.objects[self.at..];
        if rest.len() < BASE {
            return Ok(None);
        }
        let window = &rest[..rest.len().min(PADDING_MAX + OBJECT.len())];
        let start = window.windows(OBJECT.len()).position(|bytes| bytes == OBJECT);
        let start = start.ok_or("no object where one has to begin")?;
        let Some(length) = number(rest, start + 8, 4) else { return Ok(None) };
        let length = length as usize;
        if !(BASE..=SIZE_MAX).contains(&length) {
            return Err(Problem::from(format!("an object of {length} bytes")));
        }
        let Some(object) = rest.get(start..start + length) else { return Ok(None) };
        let object = object.to_vec();
        self.at += start + length;
        Ok(Some(object))
    }

    /// Unpacks what comes next in the file; `false` at its end.
    fn unpack(&mut self) -> Read<bool> {
        let Some(head) = self.take(BASE)? else { return Ok(false) };
        if !head.starts_with(OBJECT) {
            return Err("no object where one has to begin".into());
        }
        let (length, kind) = (number(&head, 8, 4).unwrap_or(0) as usize, number(&head, 12, 4).unwrap_or(0));
        let rest = length.checked_sub(BASE).filter(|rest| *rest <= SIZE_MAX);
        let rest = rest.ok_or_else(|| format!("an object of {length} bytes"))?;
        let Some(body) = self.take(rest)? else { return Ok(false) };
        self.take(length % 4)?;
        if kind != u64::from(CONTAINERS) {
            self.objects.extend(head);
            self.objects.extend(body);
            return Ok(true);
        }
        let content = body.get(CONTAINER..).ok_or("a container without content")?;
        match number(&body, 0, 2) {
            Some(0) => self.objects.extend(content),
            Some(2) => {
                let mut unpacked = ZlibDecoder::new(content).take(SIZE_MAX as u64);
                unpacked.read_to_end(&mut self.objects).map_err(|error| format!("a container: {error}"))?;
            }
            method => return Err(format!("a container packed by method {}", method.unwrap_or(0)).into()),
        }
        Ok(true)
    }

    /// Takes so many bytes of the file; `None` if it ends before.
    fn take(&mut self, count: usize) -> Read<Option<Vec<u8>>> {
        let mut bytes = Vec::new();
        let read = self.bytes.by_ref().take(count as u64).read_to_end(&mut bytes);
        read.map_err(|error| format!("cannot read the log: {error}"))?;
        self.is_cut_off |= !bytes.is_empty() && bytes.len() < count;
        Ok((bytes.len() == count).then_some(bytes))
    }
}

/// Reads a number of so many bytes, the lowest first.
fn number(bytes: &[u8], at: usize, length: usize) -> Option<u64> {
    let bytes = bytes.get(at..at + length)?;
    Some(bytes.iter().rev().fold(0, |number, byte| number << 8 | u64::from(*byte)))
}

fn number32(bytes: &[u8], at: usize) -> Option<u32> {
    number(bytes, at, 4)?.try_into().ok()
}

fn object_line(object: &[u8]) -> Read<Line> {
    let kind = number32(object, 12).unwrap_or(0);
    let Some((_, read)) = MESSAGES.iter().find(|(known, _)| *known == kind) else { return Ok(Line::Blank) };
    let short = || format!("an object of type {kind} is too short");
    let head = number(object, 4, 2).ok_or_else(short)? as usize;
    let flags = number32(object, 16).ok_or_else(short)?;
    let stamp = number(object, 24, 8).ok_or_else(short)?;
    let scale = if flags == TEN_MICROS { 10_000 } else { 1 };
    let nanos = stamp.checked_mul(scale).and_then(|nanos| i64::try_from(nanos).ok());
    let nanos = nanos.ok_or("a time of more than 292 years")?;
    let (channel, what) = object.get(head..).and_then(read).ok_or_else(short)?;
    Ok(Event::at(nanos, Evidence::Absolute, &channel, what))
}

/// Makes a classic frame of what its object says.
fn frame(id: u32, remote: bool, code: u8, data: &[u8]) -> Option<What> {
    let raw = id & !EXTENDED;
    let id = if id & EXTENDED != 0 { Id::extended(raw) } else { Id::standard(raw.try_into().ok()?) }?;
    let code = code.min(15);
    if remote {
        return Some(What::Frame(Frame::new_remote(id, code)));
    }
    Some(What::Frame(Frame { dlc: code, ..Frame::new(id, data.get(..data_length(code))?)? }))
}

/// Channel, flags, length code, identifier, data.
fn message(body: &[u8]) -> Option<(String, What)> {
    let channel = number(body, 0, 2)?.to_string();
    let (flags, code) = (*body.get(2)?, *body.get(3)?);
    Some((channel, frame(number32(body, 4)?, flags & REMOTE != 0, code, body.get(8..16)?)?))
}

fn bus_error(body: &[u8]) -> Option<(String, What)> {
    Some((number(body, 0, 2)?.to_string(), What::BusError))
}

/// Channel, flags, length code, identifier, length, bits, FD flags, bytes, 5 of padding, data.
fn fd_message(body: &[u8]) -> Option<(String, What)> {
    let channel = number(body, 0, 2)?.to_string();
    let (flags, code) = (*body.get(2)?, *body.get(3)?);
    if u32::from(*body.get(13)?) & FD != 0 {
        return Some((channel, What::FdFrame));
    }
    Some((channel, frame(number32(body, 4)?, flags & REMOTE != 0, code, body.get(20..)?)?))
}

/// Channel, length code, bytes, count of tries, identifier, length, flags; data from byte 40 on.
fn fd_message_64(body: &[u8]) -> Option<(String, What)> {
    let (channel, code) = (body.first()?.to_string(), *body.get(1)?);
    let flags = number32(body, 12)?;
    if flags & FD_64 != 0 {
        return Some((channel, What::FdFrame));
    }
    Some((channel, frame(number32(body, 4)?, flags & REMOTE_64 != 0, code, body.get(40..)?)?))
}
