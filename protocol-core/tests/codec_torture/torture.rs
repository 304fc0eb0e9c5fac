//! Vehicle `torture`: Torture (折磨).
//!
//! Generated from `torture.dbc` and `vehicle.toml`; refresh with `cargo xtask codegen`.

use crate::checksum::{Checksum, ChecksumKind};
use crate::codec::{self, Got, LifeKind, MessageInfo, Mux, Order, Scale, SignalInfo};
use crate::frame::CanId;
use crate::model::{INVALID, Readings, Severity, Value};
use crate::stream::{Bound, Cell, Stream};
use crate::vehicle::{FaultText, HvOffRule, Life, LimpRule, Node, NodeName, Rules, RxMessage, TxMessage, Vehicle};

/// Identifiers.
pub mod id {
    use crate::frame::CanId;

    /// Plain.
    pub const PLAIN: CanId = CanId::standard(0x064);
    /// Wide.
    pub const WIDE: CanId = CanId::extended(0x18FEC9FF);
    /// Short.
    pub const SHORT: CanId = CanId::standard(0x065);
    /// Muxed.
    pub const MUXED: CanId = CanId::standard(0x066);
    /// Empty.
    pub const EMPTY: CanId = CanId::standard(0x067);
    /// Full.
    pub const FULL: CanId = CanId::standard(0x068);
    /// Out.
    pub const OUT: CanId = CanId::standard(0x069);
}

/// Plain (064) from Engine, every 40 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plain(pub [u8; 8]);

impl Default for Plain {
    fn default() -> Self { Self::new() }
}

impl Plain {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `crooked` as sent: 12 bits from bit 4.
    #[inline(always)]
    pub const fn crooked_raw(self) -> u16 { (self.0[0] >> 4) as u16 | (self.0[1] as u16) << 4 }
    /// Returns the value in 1/4 km/h, -40 to 4000; `None` if not valid.
    #[inline(always)]
    pub const fn crooked(self) -> Option<i32> {
        let raw = self.crooked_raw();
        if raw <= 4040 && raw != 77 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `crooked` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_crooked_raw(mut self, raw: u16) -> Self {
        self.0[0] = self.0[0] & 0x0F | ((raw as u8) & 0x0F) << 4;
        self.0[1] = (raw >> 4) as u8;
        self
    }

    /// Returns `falling` as sent: 12 bits from bit 16.
    #[inline(always)]
    pub const fn falling_raw(self) -> i16 { (((self.0[2] as u16 | ((self.0[3] & 0x0F) as u16) << 8) << 4) as i16) >> 4 }
    /// Returns the value in 1/2 A, 2055 to -2040; `None` if not valid.
    #[inline(always)]
    pub const fn falling(self) -> Option<i32> {
        let raw = self.falling_raw();
        Some((raw as i32) * -1 + 7)
    }
    /// Returns the frame with `falling` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_falling_raw(mut self, raw: i16) -> Self {
        self.0[2] = raw as u8;
        self.0[3] = self.0[3] & 0xF0 | (((raw as u16) >> 8) as u8) & 0x0F;
        self
    }

    /// Returns `motorola` as sent: 10 bits down from bit 34.
    #[inline(always)]
    pub const fn motorola_raw(self) -> u16 { (self.0[5] >> 1) as u16 | ((self.0[4] & 0x07) as u16) << 7 }
    /// Returns the value in 1/10 V, 0 to 1023; `None` if not valid.
    #[inline(always)]
    pub const fn motorola(self) -> Option<i32> {
        let raw = self.motorola_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `motorola` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_motorola_raw(mut self, raw: u16) -> Self {
        self.0[5] = self.0[5] & 0x01 | ((raw as u8) & 0x7F) << 1;
        self.0[4] = self.0[4] & 0xF8 | ((raw >> 7) as u8) & 0x07;
        self
    }

    /// Returns `signed_nibble` as sent: 4 bits down from bit 51.
    #[inline(always)]
    pub const fn signed_nibble_raw(self) -> i8 { (((self.0[6] & 0x0F) << 4) as i8) >> 4 }
    /// Returns the value in °C, -8 to 7; `None` if not valid.
    #[inline(always)]
    pub const fn signed_nibble(self) -> Option<i32> {
        let raw = self.signed_nibble_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `signed_nibble` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_signed_nibble_raw(mut self, raw: i8) -> Self {
        self.0[6] = self.0[6] & 0xF0 | (raw as u8) & 0x0F;
        self
    }

    /// Returns `life` as sent: 4 bits from bit 56.
    #[inline(always)]
    pub const fn life_raw(self) -> u8 { self.0[7] & 0x0F }
    /// Returns the value, 0 to 15; `None` if not valid.
    #[inline(always)]
    pub const fn life(self) -> Option<i32> {
        let raw = self.life_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `life` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_life_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0xF0 | raw & 0x0F;
        self
    }

    /// Returns `state` as sent: 3 bits from bit 60.
    #[inline(always)]
    pub const fn state_raw(self) -> u8 { self.0[7] >> 4 & 0x07 }
    /// Returns the value, 0 to 4; `None` if not valid.
    #[inline(always)]
    pub const fn state(self) -> Option<i32> {
        let raw = self.state_raw();
        if raw <= 4 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `state` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_state_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0x8F | (raw & 0x07) << 4;
        self
    }

    /// Returns `flag` as sent: 1 bit from bit 63.
    #[inline(always)]
    pub const fn flag_raw(self) -> u8 { self.0[7] >> 7 }
    /// Returns the value, 0 to 1; `None` if not valid.
    #[inline(always)]
    pub const fn flag(self) -> Option<i32> {
        let raw = self.flag_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `flag` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_flag_raw(mut self, raw: u8) -> Self {
        self.0[7] = self.0[7] & 0x7F | (raw & 0x01) << 7;
        self
    }
}

/// Wide (18FEC9FF) from Engine, every 40 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wide(pub [u8; 8]);

impl Default for Wide {
    fn default() -> Self { Self::new() }
}

impl Wide {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `five_bytes` as sent: 32 bits from bit 3.
    #[inline(always)]
    pub const fn five_bytes_raw(self) -> u32 { (self.0[0] >> 3) as u32 | (self.0[1] as u32) << 5 | (self.0[2] as u32) << 13 | (self.0[3] as u32) << 21 | ((self.0[4] & 0x07) as u32) << 29 }
    /// Returns the value, 0 to 4294967295; `None` if not valid.
    #[inline(always)]
    pub const fn five_bytes(self) -> Option<i64> {
        let raw = self.five_bytes_raw();
        Some(raw as i64)
    }
    /// Returns the frame with `five_bytes` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_five_bytes_raw(mut self, raw: u32) -> Self {
        self.0[0] = self.0[0] & 0x07 | ((raw as u8) & 0x1F) << 3;
        self.0[1] = (raw >> 5) as u8;
        self.0[2] = (raw >> 13) as u8;
        self.0[3] = (raw >> 21) as u8;
        self.0[4] = self.0[4] & 0xF8 | ((raw >> 29) as u8) & 0x07;
        self
    }

    /// Returns `twenty` as sent: 20 bits down from bit 43.
    #[inline(always)]
    pub const fn twenty_raw(self) -> i32 { (((self.0[7] as u32 | (self.0[6] as u32) << 8 | ((self.0[5] & 0x0F) as u32) << 16) << 12) as i32) >> 12 }
    /// Returns the value in 1/1000 V, -524288 to 524287; `None` if not valid.
    #[inline(always)]
    pub const fn twenty(self) -> Option<i32> {
        let raw = self.twenty_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `twenty` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_twenty_raw(mut self, raw: i32) -> Self {
        self.0[7] = raw as u8;
        self.0[6] = ((raw as u32) >> 8) as u8;
        self.0[5] = self.0[5] & 0xF0 | (((raw as u32) >> 16) as u8) & 0x0F;
        self
    }
}

/// Short (065) from Engine, every 40 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Short(pub [u8; 8]);

impl Default for Short {
    fn default() -> Self { Self::new() }
}

impl Short {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `all` as sent: 24 bits down from bit 7.
    #[inline(always)]
    pub const fn all_raw(self) -> i32 { (((self.0[2] as u32 | (self.0[1] as u32) << 8 | (self.0[0] as u32) << 16) << 8) as i32) >> 8 }
    /// Returns the value, -8388608 to 8388607; `None` if not valid.
    #[inline(always)]
    pub const fn all(self) -> Option<i32> {
        let raw = self.all_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `all` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_all_raw(mut self, raw: i32) -> Self {
        self.0[2] = raw as u8;
        self.0[1] = ((raw as u32) >> 8) as u8;
        self.0[0] = ((raw as u32) >> 16) as u8;
        self
    }
}

/// Muxed (066) from Engine, every 40 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Muxed(pub [u8; 8]);

impl Default for Muxed {
    fn default() -> Self { Self::new() }
}

impl Muxed {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0xA5, 0x00, 0x00, 0x00]) }

    /// Returns `page` as sent: 3 bits from bit 0.
    #[inline(always)]
    pub const fn page_raw(self) -> u8 { self.0[0] & 0x07 }
    /// Returns the value, 0 to 7; `None` if not valid.
    #[inline(always)]
    pub const fn page(self) -> Option<i32> {
        let raw = self.page_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `page` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_page_raw(mut self, raw: u8) -> Self {
        self.0[0] = self.0[0] & 0xF8 | raw & 0x07;
        self
    }

    /// Returns `low` as sent: 16 bits from bit 8, only while `page` is 0.
    #[inline(always)]
    pub const fn low_raw(self) -> u16 { u16::from_le_bytes([self.0[1], self.0[2]]) }
    /// Returns the value, 0 to 65535; `None` if not valid.
    #[inline(always)]
    pub const fn low(self) -> Option<i32> {
        let raw = self.low_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `low` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_low_raw(mut self, raw: u16) -> Self {
        self.0[1] = raw as u8;
        self.0[2] = (raw >> 8) as u8;
        self
    }

    /// Returns `high` as sent: 16 bits down from bit 15, only while `page` is 5.
    #[inline(always)]
    pub const fn high_raw(self) -> i16 { (u16::from_be_bytes([self.0[1], self.0[2]])) as i16 }
    /// Returns the value, -32768 to 32767; `None` if not valid.
    #[inline(always)]
    pub const fn high(self) -> Option<i32> {
        let raw = self.high_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `high` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_high_raw(mut self, raw: i16) -> Self {
        self.0[2] = raw as u8;
        self.0[1] = ((raw as u16) >> 8) as u8;
        self
    }

    /// Returns `tail` as sent: 8 bits from bit 24, only while `page` is 5.
    #[inline(always)]
    pub const fn tail_raw(self) -> u8 { self.0[3] }
    /// Returns the value, 1 to 511; `None` if not valid.
    #[inline(always)]
    pub const fn tail(self) -> Option<i32> {
        let raw = self.tail_raw();
        Some((raw as i32) * 2 + 1)
    }
    /// Returns the frame with `tail` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_tail_raw(mut self, raw: u8) -> Self {
        self.0[3] = raw;
        self
    }

    /// Returns `always` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn always_raw(self) -> i8 { (self.0[5]) as i8 }
    /// Returns the value, -128 to 127; `None` if not valid.
    #[inline(always)]
    pub const fn always(self) -> Option<i32> {
        let raw = self.always_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `always` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_always_raw(mut self, raw: i8) -> Self {
        self.0[5] = raw as u8;
        self
    }
}

/// Empty (067) from Engine, every 40 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Empty(pub [u8; 8]);

impl Default for Empty {
    fn default() -> Self { Self::new() }
}

impl Empty {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }
}

/// Full (068) from Engine, every 40 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Full(pub [u8; 8]);

impl Default for Full {
    fn default() -> Self { Self::new() }
}

impl Full {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00]) }

    /// Returns `first` as sent: 32 bits down from bit 7.
    #[inline(always)]
    pub const fn first_raw(self) -> i32 { (u32::from_be_bytes([self.0[0], self.0[1], self.0[2], self.0[3]])) as i32 }
    /// Returns the value, -2147483648 to 2147483647; `None` if not valid.
    #[inline(always)]
    pub const fn first(self) -> Option<i32> {
        let raw = self.first_raw();
        Some(raw as i32)
    }
    /// Returns the frame with `first` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_first_raw(mut self, raw: i32) -> Self {
        self.0[3] = raw as u8;
        self.0[2] = ((raw as u32) >> 8) as u8;
        self.0[1] = ((raw as u32) >> 16) as u8;
        self.0[0] = ((raw as u32) >> 24) as u8;
        self
    }

    /// Returns `second` as sent: 32 bits down from bit 39.
    #[inline(always)]
    pub const fn second_raw(self) -> u32 { u32::from_be_bytes([self.0[4], self.0[5], self.0[6], self.0[7]]) }
    /// Returns the value in 1/8 km, 0 to 4294967295; `None` if not valid.
    #[inline(always)]
    pub const fn second(self) -> Option<i64> {
        let raw = self.second_raw();
        Some(raw as i64)
    }
    /// Returns the frame with `second` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_second_raw(mut self, raw: u32) -> Self {
        self.0[7] = raw as u8;
        self.0[6] = (raw >> 8) as u8;
        self.0[5] = (raw >> 16) as u8;
        self.0[4] = (raw >> 24) as u8;
        self
    }
}

/// Out (069) from Cluster, every 40 ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Out(pub [u8; 8]);

impl Default for Out {
    fn default() -> Self { Self::new() }
}

impl Out {
    /// Returns a frame with no signal set: reserved bytes at their fill value.
    pub const fn new() -> Self { Self([0x00, 0x00, 0x00, 0xA5, 0xA5, 0x00, 0xA5, 0xA5]) }

    /// Returns `speed` as sent: 13 bits down from bit 3.
    #[inline(always)]
    pub const fn speed_raw(self) -> u16 { (self.0[2] >> 7) as u16 | (self.0[1] as u16) << 1 | ((self.0[0] & 0x0F) as u16) << 9 }
    /// Returns the value in 1/4 km/h, -40 to 4000; `None` if not valid.
    #[inline(always)]
    pub const fn speed(self) -> Option<i32> {
        let raw = self.speed_raw();
        if raw <= 4040 { Some(raw as i32 - 40) } else { None }
    }
    /// Returns the frame with `speed` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_speed_raw(mut self, raw: u16) -> Self {
        self.0[2] = self.0[2] & 0x7F | ((raw as u8) & 0x01) << 7;
        self.0[1] = (raw >> 1) as u8;
        self.0[0] = self.0[0] & 0xF0 | ((raw >> 9) as u8) & 0x0F;
        self
    }

    /// Returns `mode` as sent: 3 bits from bit 20.
    #[inline(always)]
    pub const fn mode_raw(self) -> u8 { self.0[2] >> 4 & 0x07 }
    /// Returns the value, 0 to 5; `None` if not valid.
    #[inline(always)]
    pub const fn mode(self) -> Option<i32> {
        let raw = self.mode_raw();
        if raw <= 5 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `mode` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_mode_raw(mut self, raw: u8) -> Self {
        self.0[2] = self.0[2] & 0x8F | (raw & 0x07) << 4;
        self
    }

    /// Returns `count` as sent: 8 bits from bit 40.
    #[inline(always)]
    pub const fn count_raw(self) -> u8 { self.0[5] }
    /// Returns the value, 1 to 255; `None` if not valid.
    #[inline(always)]
    pub const fn count(self) -> Option<i32> {
        let raw = self.count_raw();
        if raw >= 1 { Some(raw as i32) } else { None }
    }
    /// Returns the frame with `count` set to the low bits of `raw`.
    #[inline(always)]
    pub const fn with_count_raw(mut self, raw: u8) -> Self {
        self.0[5] = raw;
        self
    }
}

fn get_plain(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Plain(data);
    Some(match index {
        0 => (frame.crooked_raw() as i64, frame.crooked().map(|value| value as i64)),
        1 => (frame.falling_raw() as i64, frame.falling().map(|value| value as i64)),
        2 => (frame.motorola_raw() as i64, frame.motorola().map(|value| value as i64)),
        3 => (frame.signed_nibble_raw() as i64, frame.signed_nibble().map(|value| value as i64)),
        4 => (frame.life_raw() as i64, frame.life().map(|value| value as i64)),
        5 => (frame.state_raw() as i64, frame.state().map(|value| value as i64)),
        6 => (frame.flag_raw() as i64, frame.flag().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_plain(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Plain(data);
    match index {
        0 => frame.with_crooked_raw(raw as u16).0,
        1 => frame.with_falling_raw(raw as i16).0,
        2 => frame.with_motorola_raw(raw as u16).0,
        3 => frame.with_signed_nibble_raw(raw as i8).0,
        4 => frame.with_life_raw(raw as u8).0,
        5 => frame.with_state_raw(raw as u8).0,
        6 => frame.with_flag_raw(raw as u8).0,
        _ => data,
    }
}

fn get_wide(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Wide(data);
    Some(match index {
        0 => (frame.five_bytes_raw() as i64, frame.five_bytes().map(|value| value as i64)),
        1 => (frame.twenty_raw() as i64, frame.twenty().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_wide(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Wide(data);
    match index {
        0 => frame.with_five_bytes_raw(raw as u32).0,
        1 => frame.with_twenty_raw(raw as i32).0,
        _ => data,
    }
}

fn get_short(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Short(data);
    Some(match index {
        0 => (frame.all_raw() as i64, frame.all().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_short(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Short(data);
    match index {
        0 => frame.with_all_raw(raw as i32).0,
        _ => data,
    }
}

fn get_muxed(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Muxed(data);
    Some(match index {
        0 => (frame.page_raw() as i64, frame.page().map(|value| value as i64)),
        1 => (frame.low_raw() as i64, frame.low().map(|value| value as i64)),
        2 => (frame.high_raw() as i64, frame.high().map(|value| value as i64)),
        3 => (frame.tail_raw() as i64, frame.tail().map(|value| value as i64)),
        4 => (frame.always_raw() as i64, frame.always().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_muxed(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Muxed(data);
    match index {
        0 => frame.with_page_raw(raw as u8).0,
        1 => frame.with_low_raw(raw as u16).0,
        2 => frame.with_high_raw(raw as i16).0,
        3 => frame.with_tail_raw(raw as u8).0,
        4 => frame.with_always_raw(raw as i8).0,
        _ => data,
    }
}

fn get_empty(_index: usize, _data: [u8; 8]) -> Option<Got> { None }

fn set_empty(_index: usize, data: [u8; 8], _raw: i64) -> [u8; 8] { data }

fn get_full(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Full(data);
    Some(match index {
        0 => (frame.first_raw() as i64, frame.first().map(|value| value as i64)),
        1 => (frame.second_raw() as i64, frame.second().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_full(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Full(data);
    match index {
        0 => frame.with_first_raw(raw as i32).0,
        1 => frame.with_second_raw(raw as u32).0,
        _ => data,
    }
}

fn get_out(index: usize, data: [u8; 8]) -> Option<Got> {
    let frame = Out(data);
    Some(match index {
        0 => (frame.speed_raw() as i64, frame.speed().map(|value| value as i64)),
        1 => (frame.mode_raw() as i64, frame.mode().map(|value| value as i64)),
        2 => (frame.count_raw() as i64, frame.count().map(|value| value as i64)),
        _ => return None,
    })
}

fn set_out(index: usize, data: [u8; 8], raw: i64) -> [u8; 8] {
    let frame = Out(data);
    match index {
        0 => frame.with_speed_raw(raw as u16).0,
        1 => frame.with_mode_raw(raw as u8).0,
        2 => frame.with_count_raw(raw as u8).0,
        _ => data,
    }
}

static PLAIN_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "crooked", start: 4, length: 12, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: -40, den: 4 }, unit: "km/h", range: (0, 4040), start_raw: 0, invalid_raw: Some(77), mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "falling", start: 16, length: 12, order: Order::Intel, signed: true, scale: Scale { mul: -1, add: 7, den: 2 }, unit: "A", range: (-2048, 2047), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "motorola", start: 34, length: 10, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 10 }, unit: "V", range: (0, 1023), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "signed_nibble", start: 51, length: 4, order: Order::Motorola, signed: true, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "°C", range: (-8, 7), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "life", start: 56, length: 4, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 15), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::Nibble), values: &[] },
    SignalInfo { name: "state", start: 60, length: 3, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 4), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "none"), (1, "warn"), (2, "limp"), (4, "broken")] },
    SignalInfo { name: "flag", start: 63, length: 1, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 1), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static WIDE_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "five_bytes", start: 3, length: 32, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 4294967295), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "twenty", start: 43, length: 20, order: Order::Motorola, signed: true, scale: Scale { mul: 1, add: 0, den: 1000 }, unit: "V", range: (-524288, 524287), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static SHORT_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "all", start: 7, length: 24, order: Order::Motorola, signed: true, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (-8388608, 8388607), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static MUXED_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "page", start: 0, length: 3, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 7), start_raw: 0, invalid_raw: None, mux: Mux::Selector, life: None, values: &[] },
    SignalInfo { name: "low", start: 8, length: 16, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 65535), start_raw: 0, invalid_raw: None, mux: Mux::When(0), life: None, values: &[] },
    SignalInfo { name: "high", start: 15, length: 16, order: Order::Motorola, signed: true, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (-32768, 32767), start_raw: 0, invalid_raw: None, mux: Mux::When(5), life: None, values: &[] },
    SignalInfo { name: "tail", start: 24, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 2, add: 1, den: 1 }, unit: "", range: (0, 255), start_raw: 0, invalid_raw: None, mux: Mux::When(5), life: None, values: &[] },
    SignalInfo { name: "always", start: 40, length: 8, order: Order::Intel, signed: true, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (-128, 127), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static EMPTY_SIGNALS: &[SignalInfo] = &[
];

static FULL_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "first", start: 7, length: 32, order: Order::Motorola, signed: true, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (-2147483648, 2147483647), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "second", start: 39, length: 32, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: 0, den: 8 }, unit: "km", range: (0, 4294967295), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
];

static OUT_SIGNALS: &[SignalInfo] = &[
    SignalInfo { name: "speed", start: 3, length: 13, order: Order::Motorola, signed: false, scale: Scale { mul: 1, add: -40, den: 4 }, unit: "km/h", range: (0, 4040), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: None, values: &[] },
    SignalInfo { name: "mode", start: 20, length: 3, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (0, 5), start_raw: 3, invalid_raw: None, mux: Mux::Always, life: None, values: &[(0, "lock"), (1, "acc"), (2, "on"), (5, "start")] },
    SignalInfo { name: "count", start: 40, length: 8, order: Order::Intel, signed: false, scale: Scale { mul: 1, add: 0, den: 1 }, unit: "", range: (1, 255), start_raw: 0, invalid_raw: None, mux: Mux::Always, life: Some(LifeKind::From1To255), values: &[] },
];

/// Every message of the vehicle, in the order of the DBC: for tools.
pub static MESSAGES: &[MessageInfo] = &[
    MessageInfo { id: CanId::standard(0x064), name: "Plain", sender: "Engine", len: 8, cycle_ms: 40, slow_cycle_ms: 40, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_plain, set: set_plain, signals: PLAIN_SIGNALS },
    MessageInfo { id: CanId::extended(0x18FEC9FF), name: "Wide", sender: "Engine", len: 8, cycle_ms: 40, slow_cycle_ms: 40, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_wide, set: set_wide, signals: WIDE_SIGNALS },
    MessageInfo { id: CanId::standard(0x065), name: "Short", sender: "Engine", len: 3, cycle_ms: 40, slow_cycle_ms: 40, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_short, set: set_short, signals: SHORT_SIGNALS },
    MessageInfo { id: CanId::standard(0x066), name: "Muxed", sender: "Engine", len: 6, cycle_ms: 40, slow_cycle_ms: 40, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0xA5, 0x00, 0x00, 0x00], get: get_muxed, set: set_muxed, signals: MUXED_SIGNALS },
    MessageInfo { id: CanId::standard(0x067), name: "Empty", sender: "Engine", len: 0, cycle_ms: 40, slow_cycle_ms: 40, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_empty, set: set_empty, signals: EMPTY_SIGNALS },
    MessageInfo { id: CanId::standard(0x068), name: "Full", sender: "Engine", len: 8, cycle_ms: 40, slow_cycle_ms: 40, optional: false, fill: [0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00], get: get_full, set: set_full, signals: FULL_SIGNALS },
    MessageInfo { id: CanId::standard(0x069), name: "Out", sender: "Cluster", len: 8, cycle_ms: 40, slow_cycle_ms: 40, optional: false, fill: [0x00, 0x00, 0x00, 0xA5, 0xA5, 0x00, 0xA5, 0xA5], get: get_out, set: set_out, signals: OUT_SIGNALS },
];

static RX: &[RxMessage] = &[
    RxMessage { id: CanId::standard(0x064), name: "Plain", node: Node::Vcu, len: 8, cycle_ms: 40, timeout_ms: 500, life: Some(Life { byte: 7, mask: 0x0F }), checksum: None, expected: true, vital: false },
    RxMessage { id: CanId::extended(0x18FEC9FF), name: "Wide", node: Node::Vcu, len: 8, cycle_ms: 40, timeout_ms: 1234, life: None, checksum: None, expected: false, vital: false },
];

static TX: &[TxMessage] = &[
    TxMessage { id: CanId::standard(0x069), name: "Out", cycle_ms: 70, life: Some(Life { byte: 5, mask: 0xFF }), checksum: None },
];

/// Texts of the fault codes, sorted by source and code.
pub static FAULTS: &[FaultText] = &[
];

static NODES: &[NodeName] = &[
    NodeName { node: Node::Vcu, zh: "发动机", en: "Engine" },
    NodeName { node: Node::Cluster, zh: "仪表", en: "Cluster" },
];

static STREAMS: &[Stream] = &[
];

static IDS: &[CanId] = &[
    CanId::standard(0x064),
    CanId::standard(0x065),
    CanId::standard(0x066),
    CanId::standard(0x067),
    CanId::standard(0x068),
    CanId::extended(0x18FEC9FF),
];

fn decode_plain(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Plain(*data);
    let raw = frame.crooked_raw();
    readings.put(source, Value::VehicleSpeed, (raw as i32) * 64 - 2560, raw <= 4040 && raw != 77);
    let raw = frame.flag_raw();
    readings.put(source, Value::VehicleFault, raw as i32, true);
    let worst = STATES_0[(frame.state_raw() & 7) as usize];
    let worst = i32::max(worst, STATES_1[(frame.flag_raw() & 1) as usize]);
    readings.put(source, Value::VehicleFaultLevel, worst, worst != INVALID);
    let raw = frame.falling_raw();
    readings.put(source, Value::BatteryCurrent, (raw as i32) * -5 + 35, true);
    let raw = frame.signed_nibble_raw();
    readings.put(source, Value::MotorTemperature, raw as i32, true);
    let state = STATES_2[(frame.state_raw() & 7) as usize];
    readings.put(source, Value::MotorFaultCode, state, state != INVALID);
    let raw = frame.motorola_raw();
    readings.put(source, Value::DcdcOutput, raw as i32, true);
}

fn decode_wide(source: u8, data: &[u8; 8], readings: &mut Readings) {
    let frame = Wide(*data);
    let raw = frame.twenty_raw();
    readings.put(source, Value::BatteryVoltage, codec::floor_div(raw as i32, 100), true);
    let raw = frame.twenty_raw();
    readings.put(source, Value::BatteryCellMax, (raw as i32).abs(), true);
}

static STATES_0: [i32; 8] = [0, 1, 2, INVALID, 3, INVALID, INVALID, INVALID];

static STATES_1: [i32; 2] = [0, 3];

static STATES_2: [i32; 8] = [7, INVALID, 5, 6, 5, 6, 6, 6];

static DECODERS: [fn(u8, &[u8; 8], &mut Readings); 2] = [
    decode_plain,
    decode_wide,
];

fn decode(index: u8, data: &[u8; 8], readings: &mut Readings) {
    if let Some(decode) = DECODERS.get(index as usize) {
        decode(index, data, readings);
    }
}

fn encode_out(values: &Readings) -> [u8; 8] {
    let frame = Out::new();
    let frame = frame.with_speed_raw(codec::known(values, Value::VehicleSpeed).map_or(0, |number| codec::scaled(number, 1, 2592, 64, 0, 4040) as u16));
    let frame = frame.with_mode_raw(match codec::known(values, Value::BodyKey) { Some(0) => 0, Some(1) => 1, Some(2) => 2, Some(3) => 5, _ => 3 });
    frame.0
}

fn encode(index: u8, values: &Readings) -> [u8; 8] {
    match index {
        0 => encode_out(values),
        _ => [0; 8],
    }
}

/// Torture (折磨).
pub static VEHICLE: Vehicle = Vehicle {
    name: "torture",
    zh: "折磨",
    en: "Torture",
    bitrate: 500000,
    worst_level: 3,
    rules: Rules::NONE,
    rx: RX,
    decode,
    streams: STREAMS,
    ids: IDS,
    tx: TX,
    encode,
    faults: FAULTS,
    nodes: NODES,
};
