//! What the programs share: the shape of a decoder, and that a panic ends nowhere.
//!
//! A program is a table of decoders and what they need; `cargo xtask codecs` calls each of them on the emulated core
//! with random frames and counts. The decoders are written by the build script from the DBC and `vehicle.toml`, in the
//! way that each generator's own documentation shows. They must agree on every value.

#![no_std]

/// Most values that one message gives.
pub const MOST_VALUES: usize = 24;

/// The bound values of one message, in counts of `1 / den` of the DBC's unit: `raw * mul + add`.
pub type Values = [i32; MOST_VALUES];

/// Reads the bound signals of one message.
pub type Decoder = extern "C" fn(&[u8; 8], &mut Values);

/// In place of a value that is not valid, for the program that judges.
pub const INVALID: i32 = i32::MIN;

/// A physical value of dbc-codegen: an integer, or a float that must be rounded.
pub trait Physical {
    /// Returns the value in counts of `1 / den`.
    fn counts(self, den: i32) -> i32;
}

impl Physical for f32 {
    #[inline(always)]
    fn counts(self, den: i32) -> i32 {
        let counts = if den == 1 { self } else { self * den as f32 };
        (if counts < 0.0 { counts - 0.5 } else { counts + 0.5 }) as i32
    }
}

macro_rules! whole {
    ($($kind:ty)*) => {$(
        impl Physical for $kind {
            #[inline(always)]
            fn counts(self, den: i32) -> i32 {
                i32::from(self) * den
            }
        }
    )*};
}
whole!(bool u8 i8 u16 i16 i32);

#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}

include!(concat!(env!("OUT_DIR"), "/mix.rs"));

/// Puts the decoders where the bench finds them.
#[macro_export]
macro_rules! table {
    ($decoders:expr) => {
        #[used]
        #[unsafe(no_mangle)]
        #[unsafe(link_section = ".table")]
        static TABLE: [$crate::Decoder; $crate::MESSAGES] = $decoders;
    };
}
