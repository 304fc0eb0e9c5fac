//! Back-light, buzzer, buttons, body wires and the LED: the small parts with few pins.

use embedded_hal::digital::{InputPin, OutputPin};
use embedded_hal::pwm::SetDutyCycle;
use protocol_core::Value;
use rp2040_hal::gpio::bank0::{Gpio2, Gpio3, Gpio25};
use rp2040_hal::gpio::{DynPinId, FunctionSio, Pin, PullNone, PullUp, SioInput, SioOutput};
use rp2040_hal::pwm::{FreeRunning, Pwm6, Pwm7, Slice};

use crate::facts::{BACKLIGHT_HZ, SYS_HZ};

/// The panel's back-light, dark at first.
pub struct Backlight(Slice<Pwm6, FreeRunning>);

impl Backlight {
    const TOP: u16 = (SYS_HZ / BACKLIGHT_HZ - 1) as u16;

    pub(crate) fn new(mut slice: Slice<Pwm6, FreeRunning>) -> Self {
        slice.default_config();
        slice.set_top(Self::TOP);
        slice.enable();
        Self(slice)
    }

    /// Sets the brightness in 0.1 %.
    pub fn set(&mut self, permille: u16) {
        let Ok(()) = self.0.channel_b.set_duty_cycle_fraction(permille.min(1_000), 1_000);
    }
}

/// The buzzer, silent at first. A passive one: it needs a tone.
pub struct Buzzer {
    slice: Slice<Pwm7, FreeRunning>,
    tone_hz: Option<u16>,
}

impl Buzzer {
    /// The counter runs at 1 MHz.
    const COUNT_HZ: u32 = 1_000_000;

    pub(crate) fn new(mut slice: Slice<Pwm7, FreeRunning>) -> Self {
        slice.default_config();
        slice.set_div_int((SYS_HZ / Self::COUNT_HZ) as u8);
        slice.enable();
        Self { slice, tone_hz: None }
    }

    /// Sounds a tone, 16 Hz to 20 kHz, or is silent.
    pub fn sound(&mut self, tone_hz: Option<u16>) {
        // Setting the same pitch again would restart its period and click.
        if tone_hz == self.tone_hz {
            return;
        }
        self.tone_hz = tone_hz;
        let period = tone_hz.map_or(0, |hz| Self::COUNT_HZ / u32::from(hz.clamp(16, 20_000)));
        if period != 0 {
            self.slice.set_top((period - 1) as u16);
        }
        let Ok(()) = self.slice.channel_b.set_duty_cycle((period / 2) as u16);
    }
}

/// The two buttons, wired to ground. Bouncing is the cluster's business.
pub struct Buttons {
    pub(crate) first: Pin<Gpio2, FunctionSio<SioInput>, PullUp>,
    pub(crate) second: Pin<Gpio3, FunctionSio<SioInput>, PullUp>,
}

impl Buttons {
    /// Returns which of the two is held down.
    pub fn held(&mut self) -> [bool; 2] {
        let (Ok(first), Ok(second)) = (self.first.is_low(), self.second.is_low());
        [first, second]
    }
}

/// A contact's wire, with the model value that it says when it is closed.
type Contact = (Value, Pin<DynPinId, FunctionSio<SioInput>, PullUp>);

/// The contacts of the body, each to ground. Bouncing is the application's business.
pub struct BodyWires(pub(crate) [Contact; crate::CONTACTS]);

impl BodyWires {
    /// Returns the values of the contacts that have a pin.
    pub fn wired(&self) -> impl Iterator<Item = Value> {
        self.0.iter().map(|(value, _)| *value)
    }

    /// Returns the values of the contacts that are closed now.
    pub fn closed(&mut self) -> impl Iterator<Item = Value> {
        self.0.iter_mut().filter_map(|(value, pin)| pin.is_low().is_ok_and(|low| low).then_some(*value))
    }
}

/// The LED on the Pico.
pub struct Led(pub(crate) Pin<Gpio25, FunctionSio<SioOutput>, PullNone>);

impl Led {
    /// Lights or darkens the LED.
    pub fn set(&mut self, lit: bool) {
        let Ok(()) = self.0.set_state(lit.into());
    }
}
