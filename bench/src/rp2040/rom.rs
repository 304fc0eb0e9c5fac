//! Stand-in boot ROM: tables, lookup routine and services of our own, no code of the real one.
//!
//! The image has what firmware looks for: the magic, version 2, the function and data tables and a lookup routine in
//! Thumb code. Each function is a BKPT that the engine serves, then a return; erase and program poll in a loop, so
//! interrupts are taken in between, as in the real ROM. Cycles per call are estimates ([`Service::cycles`]).
//!
//! Source: RP2040 datasheet 2.8 (boot ROM; 2.8.3 for the tables).
//!
//! Not modelled: USB boot (the run stops), the vectored boot through the watchdog's scratch registers (the run stops),
//! core 1's wait loop. Float and double results are correctly rounded where IEEE 754 asks for it, with denormals, which
//! the real ROM flushes; trigonometry is the host's.

/// Length of the boot ROM, 16 KiB from address 0.
pub(super) const ROM_BYTES: u32 = 0x4000;
/// Where the ROM puts the second stage, which is the top of SRAM bank 5.
pub(super) const BOOT2_RAM: u32 = 0x2004_1f00;
/// Length of the second stage with its checksum.
pub(super) const BOOT2_BYTES: usize = 256;
/// ROM cycles until the second stage runs, after power-on or reset: flash out of XIP, 256 bytes over serial SPI, a
/// bitwise CRC over them (an estimate).
pub(super) const BOOT_CYCLES: i32 = 30_000;

/// What a BKPT in the ROM asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Service {
    Boot,
    Poll,
    Popcount,
    Reverse,
    LeadingZeros,
    TrailingZeros,
    Memset,
    Memcpy,
    UsbBoot,
    WaitForVector,
    ConnectFlash,
    ExitXip,
    RangeErase,
    RangeProgram,
    FlushCache,
    EnterCommandXip,
    Nothing,
    Float(u8),
    Double(u8),
}

/// Function table codes and what they do.
const FUNCTIONS: [([u8; 2], Service); 20] = [
    (*b"P3", Service::Popcount),
    (*b"R3", Service::Reverse),
    (*b"L3", Service::LeadingZeros),
    (*b"T3", Service::TrailingZeros),
    (*b"MS", Service::Memset),
    (*b"S4", Service::Memset),
    (*b"MC", Service::Memcpy),
    (*b"C4", Service::Memcpy),
    (*b"UB", Service::UsbBoot),
    (*b"WV", Service::WaitForVector),
    (*b"IF", Service::ConnectFlash),
    (*b"EX", Service::ExitXip),
    (*b"RE", Service::RangeErase),
    (*b"RP", Service::RangeProgram),
    (*b"FC", Service::FlushCache),
    (*b"CX", Service::EnterCommandXip),
    (*b"DT", Service::Nothing),
    (*b"DE", Service::Nothing),
    (*b"HX", Service::Nothing),
    (*b"NO", Service::Nothing),
];
const FIRST_FUNCTION: u8 = 2;
const FIRST_FLOAT: u8 = 64;
const FIRST_DOUBLE: u8 = 128;
/// Entries in each floating point table of a version 2 ROM.
const TABLE_ENTRIES: u8 = 32;

impl Service {
    /// The service behind BKPT `code`.
    pub(super) fn from_code(code: u8) -> Option<Self> {
        match code {
            0 => Some(Self::Boot),
            1 => Some(Self::Poll),
            FIRST_DOUBLE.. if code < FIRST_DOUBLE + TABLE_ENTRIES => Some(Self::Double(code - FIRST_DOUBLE)),
            FIRST_FLOAT.. if code < FIRST_FLOAT + TABLE_ENTRIES => Some(Self::Float(code - FIRST_FLOAT)),
            _ => FUNCTIONS.get(usize::from(code - FIRST_FUNCTION)).map(|(_, service)| *service),
        }
    }

    /// Cycles inside the function, without data. Estimates from the length of such code on a Cortex-M0+.
    pub(super) fn cycles(self) -> i32 {
        match self {
            Self::Popcount | Self::Reverse => 18,
            Self::LeadingZeros | Self::TrailingZeros => 16,
            Self::Memset | Self::Memcpy => 20,
            Self::ConnectFlash | Self::FlushCache | Self::EnterCommandXip => 60,
            Self::ExitXip => 4_000,
            Self::Float(entry) => FLOAT_CYCLES[usize::from(entry)],
            Self::Double(entry) => DOUBLE_CYCLES[usize::from(entry)],
            _ => 0,
        }
    }
}

/// Per entry: add, sub, mul, div, -, -, sqrt, to int, to fix, to uint, to ufix, from int, from fix, from uint, from ufix,
/// cos, sin, tan, -, exp, ln, cmp, atan2, from i64, from fix64, from u64, from ufix64, to i64, to fix64, to u64,
/// to ufix64, to the other width.
const FLOAT_CYCLES: [i32; 32] = [
    68, 70, 60, 72, 20, 20, 60, 24, 30, 24, 30, 40, 44, 40, 44, 580, 590, 660, 20, 540, 600, 24, 640, 60, 64,
    58, 62, 50, 56, 48, 54, 18,
];
const DOUBLE_CYCLES: [i32; 32] = [
    90, 92, 145, 200, 20, 20, 165, 30, 36, 30, 36, 40, 44, 40, 44, 1600, 1600, 1800, 20, 1500, 1700, 38,
    1700, 66, 70, 62, 66, 60, 66, 58, 64, 24,
];

/// Builds the ROM image.
pub(super) fn image() -> Vec<u8> {
    let mut rom = Builder { bytes: vec![0; ROM_BYTES as usize], end: 0x40 };
    let boot = rom.code(&[bkpt(0), 0x4720]); // bx r4
    rom.word_at(0x00, BOOT2_RAM);
    rom.word_at(0x04, boot);
    let trap = rom.code(&[0xe7fe]); // b .
    for vector in [0x08, 0x0c] {
        rom.word_at(vector, trap);
    }
    rom.bytes[0x10..0x14].copy_from_slice(&[b'M', b'u', 1, 2]);

    let entries: Vec<([u8; 2], u32)> = (FIRST_FUNCTION..)
        .zip(FUNCTIONS)
        .map(|(code, (name, service))| {
            let address = match service {
                // Start, then poll until r3 is zero.
                Service::RangeErase | Service::RangeProgram => {
                    rom.code(&[bkpt(code), bkpt(1), 0x2b00, 0xd1fc, 0x4770])
                }
                _ => rom.code(&[bkpt(code), 0x4770]), // bx lr
            };
            (name, address)
        })
        .collect();
    let functions = rom.table(&entries);
    let floats = rom.pointers(FIRST_FLOAT);
    let doubles = rom.pointers(FIRST_DOUBLE);
    let copyright = rom.data(b"stand-in boot ROM of the virtual bench\0");
    let revision = rom.data(&[0; 4]);
    let data = rom.table(&[
        (*b"CR", copyright),
        (*b"GR", revision),
        (*b"FS", floats),
        (*b"FE", copyright),
        (*b"SF", floats),
        (*b"SD", doubles),
    ]);
    // r0 = table, r1 = code: entries of (code, pointer) end with code 0.
    let lookup = rom.code(&[
        0x8802, // 0: ldrh r2, [r0, #0]
        0x8843, //    ldrh r3, [r0, #2]
        0x3004, //    adds r0, #4
        0x2a00, //    cmp  r2, #0
        0xd003, //    beq  1f
        0x428a, //    cmp  r2, r1
        0xd1f8, //    bne  0b
        0x0018, //    movs r0, r3
        0x4770, //    bx   lr
        0x2000, // 1: movs r0, #0
        0x4770, //    bx   lr
    ]);
    rom.half_at(0x14, functions);
    rom.half_at(0x16, data);
    rom.half_at(0x18, lookup);
    rom.bytes
}

fn bkpt(code: u8) -> u16 {
    0xbe00 | u16::from(code)
}

struct Builder {
    bytes: Vec<u8>,
    end: usize,
}

impl Builder {
    fn word_at(&mut self, at: usize, word: u32) {
        self.bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
    }

    fn half_at(&mut self, at: usize, address: u32) {
        self.bytes[at..at + 2].copy_from_slice(&address.to_le_bytes()[..2]);
    }

    /// Appends data, word aligned; returns its address.
    fn data(&mut self, bytes: &[u8]) -> u32 {
        let at = self.end.next_multiple_of(4);
        self.bytes[at..at + bytes.len()].copy_from_slice(bytes);
        self.end = at + bytes.len();
        u32::try_from(at).unwrap_or(0)
    }

    /// Appends code; returns its address with the Thumb bit.
    fn code(&mut self, halfwords: &[u16]) -> u32 {
        let bytes: Vec<u8> = halfwords.iter().flat_map(|half| half.to_le_bytes()).collect();
        self.data(&bytes) | 1
    }

    fn table(&mut self, entries: &[([u8; 2], u32)]) -> u32 {
        let mut bytes = Vec::new();
        for (name, address) in entries {
            bytes.extend(name);
            bytes.extend(&address.to_le_bytes()[..2]);
        }
        bytes.extend([0; 4]);
        self.data(&bytes)
    }

    /// One stub per floating point entry, and the table of their addresses.
    fn pointers(&mut self, first: u8) -> u32 {
        let stubs: Vec<u8> = (first..first + TABLE_ENTRIES)
            .map(|code| self.code(&[bkpt(code), 0x4770]))
            .flat_map(u32::to_le_bytes)
            .collect();
        self.data(&stubs)
    }
}

/// Whether the second stage carries its checksum (CRC-32/MPEG-2 over 252 bytes).
pub(super) fn is_boot2_valid(boot2: &[u8]) -> bool {
    let Some((code, sum)) = boot2.split_at_checked(BOOT2_BYTES - 4) else { return false };
    let crc = code.iter().fold(u32::MAX, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte) << 24, |crc, _| {
            crc << 1 ^ if crc >> 31 != 0 { 0x04c1_1db7 } else { 0 }
        })
    });
    sum.get(..4) == Some(&crc.to_le_bytes())
}

/// Serves entry `entry` of the single precision table on r0 to r3.
pub(super) fn float(entry: u8, r: &mut [u32; 16]) {
    let (a, b) = (f32::from_bits(r[0]), f32::from_bits(r[1]));
    let fraction = r[1].cast_signed();
    let long = u64::from(r[1]) << 32 | u64::from(r[0]);
    let long_fraction = r[2].cast_signed();
    let wide = f64::from(a);
    let result = match entry {
        0 => a + b,
        1 => a - b,
        2 => a * b,
        3 => a / b,
        6 => {
            if a < 0.0 {
                f32::NEG_INFINITY
            } else {
                a.sqrt()
            }
        }
        11 => r[0].cast_signed() as f32,
        12 => scaled(f64::from(r[0].cast_signed()), -fraction) as f32,
        13 => r[0] as f32,
        14 => scaled(f64::from(r[0]), -fraction) as f32,
        15 => wide.cos() as f32,
        16 => wide.sin() as f32,
        17 => wide.tan() as f32,
        19 => wide.exp() as f32,
        20 => {
            if a <= 0.0 {
                f32::NEG_INFINITY
            } else {
                wide.ln() as f32
            }
        }
        22 => wide.atan2(f64::from(b)) as f32,
        23 => long.cast_signed() as f32,
        24 => long.cast_signed() as f32 * scaled(1.0, -long_fraction) as f32,
        25 => long as f32,
        26 => long as f32 * scaled(1.0, -long_fraction) as f32,
        _ => return float_to_other(entry, wide, f64::from(b), fraction, r),
    };
    r[0] = result.to_bits();
}

/// Serves entry `entry` of the double precision table on r0 to r3.
pub(super) fn double(entry: u8, r: &mut [u32; 16]) {
    let pair = |low: u32, high: u32| u64::from(high) << 32 | u64::from(low);
    let long = pair(r[0], r[1]);
    let (a, b) = (f64::from_bits(long), f64::from_bits(pair(r[2], r[3])));
    // Integer arguments are one register wide, so the position follows in r1; after a 64-bit one it follows in r2.
    let (int_fraction, fraction) = (r[1].cast_signed(), r[2].cast_signed());
    let result = match entry {
        0 => a + b,
        1 => a - b,
        2 => a * b,
        3 => a / b,
        6 => {
            if a < 0.0 {
                f64::NEG_INFINITY
            } else {
                a.sqrt()
            }
        }
        11 => f64::from(r[0].cast_signed()),
        12 => scaled(f64::from(r[0].cast_signed()), -int_fraction),
        13 => f64::from(r[0]),
        14 => scaled(f64::from(r[0]), -int_fraction),
        15 => a.cos(),
        16 => a.sin(),
        17 => a.tan(),
        19 => a.exp(),
        20 => {
            if a <= 0.0 {
                f64::NEG_INFINITY
            } else {
                a.ln()
            }
        }
        22 => a.atan2(b),
        23 => long.cast_signed() as f64,
        24 => scaled(long.cast_signed() as f64, -fraction),
        25 => long as f64,
        26 => scaled(long as f64, -fraction),
        31 => {
            r[0] = (a as f32).to_bits();
            return;
        }
        _ => return float_to_other(entry, a, b, fraction, r),
    };
    write_pair(r, result.to_bits());
}

/// Conversions out of floating point and the comparison, alike for both widths.
fn float_to_other(entry: u8, a: f64, b: f64, fraction: i32, r: &mut [u32; 16]) {
    // The ROM rounds towards minus infinity.
    let fixed = scaled(a, fraction).floor();
    match entry {
        7 => r[0] = (a.floor() as i32).cast_unsigned(),
        8 => r[0] = (fixed as i32).cast_unsigned(),
        9 => r[0] = a.floor() as u32,
        10 => r[0] = fixed as u32,
        21 => r[0] = (if a < b { -1i32 } else { i32::from(a > b) }).cast_unsigned(),
        27 => write_pair(r, (a.floor() as i64).cast_unsigned()),
        28 => write_pair(r, (fixed as i64).cast_unsigned()),
        29 => write_pair(r, a.floor() as u64),
        30 => write_pair(r, fixed as u64),
        31 => write_pair(r, a.to_bits()),
        _ => {}
    }
}

fn scaled(value: f64, exponent: i32) -> f64 {
    value * f64::from(exponent.clamp(-1000, 1000)).exp2()
}

fn write_pair(r: &mut [u32; 16], value: u64) {
    r[0] = value as u32;
    r[1] = (value >> 32) as u32;
}
