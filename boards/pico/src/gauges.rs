//! The analogue inputs: supply voltage and two air sensors, each over a divider.
//!
//! Owns the ADC and the step from its numbers to the cluster's units. An input without a divider floats: a pull-up shows
//! that at start, and it is not read again. No pull stays on, as one of 50 to 80 k beside a divider would falsify it
//! by a tenth. Refuses to smooth over time: the sum of [`SAMPLES`] conversions takes the noise off.
//! Source: RP2040 datasheet 4.9 (ADC), 5.5.3.4 (pull resistors); the dividers are in [`facts`](crate::facts).
//! Not supported: erratum RP2040-E11 (steps of up to 0.9 % at four places of the scale).

use rp2040_hal::adc::{Adc, AdcPin};
use rp2040_hal::gpio::bank0::{Gpio26, Gpio27, Gpio28};
use rp2040_hal::gpio::{FunctionNull, Pin, PinId, PullDown, PullNone, PullUp, ValidFunction};

use crate::facts::{
    ADC_MILLIVOLTS, ADC_MOST, ADC_OPEN, AIR_DIVIDER, AIR_MOST_CENTIMPA, AIR_SPAN_MV, AIR_WHOLE_MV,
    SUPPLY_DIVIDER, SUPPLY_LEAST_MV, SYS_HZ,
};

/// Conversions of one measurement, 2 us each.
const SAMPLES: u32 = 8;
/// A pull-up of 80 k lifts a pin of 20 pF within 10 us.
const SETTLE_CYCLES: u32 = SYS_HZ / 100_000;

/// A pin as it comes out of reset.
pub(crate) type Reset<I> = Pin<I, FunctionNull, PullDown>;

/// One analogue input; `None` = no divider is fitted.
struct Input<I: PinId>(Option<AdcPin<Pin<I, FunctionNull, PullNone>>>);

impl<I: PinId + ValidFunction<FunctionNull>> Input<I> {
    /// Looks whether a divider is fitted, and leaves the pin without a pull.
    fn new(adc: &mut Adc, pin: Reset<I>) -> Self {
        let Ok(mut lifted) = AdcPin::new(pin.into_pull_type::<PullUp>()) else { return Self(None) };
        cortex_m::asm::delay(SETTLE_CYCLES);
        let is_fitted = adc.read(&mut lifted).is_ok_and(|number| number < ADC_OPEN);
        let pin = lifted.release().into_pull_type::<PullNone>();
        Self(AdcPin::new(pin).ok().filter(|_| is_fitted))
    }

    /// Returns the voltage at the pin in millivolts.
    fn millivolts(&mut self, adc: &mut Adc) -> Option<u32> {
        let pin = self.0.as_mut()?;
        let mut sum = 0;
        for _ in 0..SAMPLES {
            sum += u32::from(adc.read(pin).ok()?);
        }
        Some(sum * ADC_MILLIVOLTS / (SAMPLES * ADC_MOST))
    }
}

/// What the gauges say; `None` = no sensor, or one that is broken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Measured {
    /// Low-voltage supply in 0.1 V.
    pub supply_decivolts: Option<u16>,
    /// Front brake air reservoir in 0.01 MPa.
    pub air_front_centimpa: Option<u16>,
    /// Rear brake air reservoir in 0.01 MPa.
    pub air_rear_centimpa: Option<u16>,
}

/// The analogue inputs.
pub struct Gauges {
    adc: Adc,
    supply: Input<Gpio26>,
    air_front: Input<Gpio27>,
    air_rear: Input<Gpio28>,
}

impl Gauges {
    pub(crate) fn new(
        mut adc: Adc,
        supply: Reset<Gpio26>,
        air_front: Reset<Gpio27>,
        air_rear: Reset<Gpio28>,
    ) -> Self {
        let supply = Input::new(&mut adc, supply);
        let air_front = Input::new(&mut adc, air_front);
        let air_rear = Input::new(&mut adc, air_rear);
        Self { adc, supply, air_front, air_rear }
    }

    /// Measures all inputs, which takes about 60 us.
    pub fn measure(&mut self) -> Measured {
        let adc = &mut self.adc;
        Measured {
            supply_decivolts: self.supply.millivolts(adc).and_then(supply_decivolts),
            air_front_centimpa: self.air_front.millivolts(adc).and_then(air_centimpa),
            air_rear_centimpa: self.air_rear.millivolts(adc).and_then(air_centimpa),
        }
    }
}

const fn before((times, by): (u32, u32), millivolts: u32) -> u32 {
    millivolts * times / by
}

/// Returns the supply in 0.1 V of the millivolts behind its divider.
const fn supply_decivolts(millivolts: u32) -> Option<u16> {
    let supply = before(SUPPLY_DIVIDER, millivolts);
    if supply < SUPPLY_LEAST_MV { None } else { Some(((supply + 50) / 100) as u16) }
}

/// Returns the pressure in 0.01 MPa of the millivolts behind a sensor's divider.
const fn air_centimpa(millivolts: u32) -> Option<u16> {
    let ((least, most), (from, to)) = (AIR_WHOLE_MV, AIR_SPAN_MV);
    let sensor = before(AIR_DIVIDER, millivolts);
    if sensor < least || sensor > most {
        return None;
    }
    let span = to - from;
    let above = if sensor > to { span } else { sensor.saturating_sub(from) };
    Some(((above * AIR_MOST_CENTIMPA + span / 2) / span) as u16)
}

// The board has no host to be tested on: the compiler does it.
const _: () = {
    assert!(supply_decivolts(0).is_none() && supply_decivolts(272).is_none());
    assert!(matches!(supply_decivolts(2_491), Some(274)), "27.4 V");
    assert!(matches!(supply_decivolts(3_300), Some(363)), "full scale");
    assert!(air_centimpa(0).is_none() && air_centimpa(166).is_none(), "no sensor");
    assert!(air_centimpa(3_168).is_none(), "a broken one");
    assert!(matches!(air_centimpa(167), Some(0)) && matches!(air_centimpa(334), Some(0)));
    assert!(matches!(air_centimpa(1_667), Some(60)) && matches!(air_centimpa(3_000), Some(120)));
    assert!(matches!(air_centimpa(3_166), Some(120)), "above its span");
};
