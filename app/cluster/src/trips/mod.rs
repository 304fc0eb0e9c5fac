//! Trips, energy and range: what the driver plans with, in whole numbers.
//!
//! Distance is summed as speed counts times milliseconds, energy as 10 mW times milliseconds, so nothing is lost between
//! two ticks and any division of a time into ticks gives the same. Time without a known value adds nothing, and
//! distance without a known power does not dilute the average. Energy that comes out of a plug is not regained energy.
//! Not supported: auxiliary consumption on its own, temperature, gradients.
//! Source: BUS-118 (1/256 km/h), BUS-R063 and JL-R018 and C5-R003 (positive = out of the battery).

pub(crate) mod charge;
pub(crate) mod odometer;

use crate::kept::parts::{self, Bytes};
use crate::view::page::Trip;
use crate::view::{Charging, Journey, Plug, Range};
use odometer::{LONGEST_STEP_MS, PER_KM};
use protocol_core::Millis;
use protocol_core::model::{Shown, Value};
use protocol_core::states::Charge;

/// 10 mW times milliseconds in one watt-hour.
const PER_WH: u64 = 360_000_000;
/// Speed below which energy for each kilometre says nothing, in 1/256 km/h.
const SLOW: i32 = 5 * 256;
/// Distance from which an average is shown, and from which one is good enough for a range.
const SHORTEST: u64 = PER_KM / 10;
const SHORTEST_FOR_RANGE: u64 = PER_KM;

/// Sums over a distance.
#[derive(Clone, Copy)]
struct Meter {
    way: u64,
    /// The part of `way` on which the power was known.
    metered: u64,
    used: u64,
    regained: u64,
}

impl Meter {
    const ZERO: Self = Self { way: 0, metered: 0, used: 0, regained: 0 };

    /// Returns the consumption in Wh/km, regained energy taken off.
    fn average_whkm(&self, shortest: u64) -> Option<i32> {
        let net = i64::try_from(self.used).ok()? - i64::try_from(self.regained).ok()?;
        let metered = i64::try_from(self.metered).ok().filter(|_| self.metered >= shortest)?;
        // 1 km is 256 x 3.6e6 counts, 1 Wh 3.6e8: Wh/km = net / metered x 64 / 25.
        i32::try_from(net.checked_mul(64)? / metered.checked_mul(25)?).ok()
    }

    fn journey(&self) -> Journey {
        let watthours = |energy: u64| u32::try_from(energy / PER_WH).unwrap_or(u32::MAX);
        Journey {
            hectometres: u32::try_from(self.way / (PER_KM / 10)).unwrap_or(u32::MAX),
            average_whkm: self.average_whkm(SHORTEST),
            used_watthours: watthours(self.used),
            regained_watthours: watthours(self.regained),
        }
    }
}

/// Both trips and the drive since power-on.
#[derive(Clone)]
pub(crate) struct Trips {
    a: Meter,
    b: Meter,
    since_start: Meter,
    last: Option<Millis>,
}

impl Trips {
    pub(crate) const fn new() -> Self {
        Self { a: Meter::ZERO, b: Meter::ZERO, since_start: Meter::ZERO, last: None }
    }

    /// Adds what has happened since the last call.
    ///
    /// `speed` is in 1/256 km/h, `power` in 10 mW, positive = out of the battery; `None` = not known.
    pub(crate) fn drive(&mut self, speed: Option<i32>, power: Option<i64>, is_charging: bool, now: Millis) {
        let step_ms = self.last.map_or(0, |last| now.since(last)).min(LONGEST_STEP_MS);
        self.last = self.last.max(Some(now));
        let way = speed.and_then(|speed| u64::try_from(speed).ok()).unwrap_or(0).saturating_mul(step_ms);
        let (metered, power) = power.map_or((0, 0), |power| (way, power));
        let energy = power.unsigned_abs().saturating_mul(step_ms);
        for meter in [&mut self.a, &mut self.b, &mut self.since_start] {
            meter.way = meter.way.saturating_add(way);
            meter.metered = meter.metered.saturating_add(metered);
            match power {
                0.. => meter.used = meter.used.saturating_add(energy),
                _ if is_charging => {}
                _ => meter.regained = meter.regained.saturating_add(energy),
            }
        }
    }

    /// Returns what is to be kept of trip A and trip B: eight numbers of eight bytes.
    pub(crate) fn kept(&self) -> Bytes {
        let meters = [&self.a, &self.b].into_iter();
        meters
            .flat_map(|meter| [meter.way, meter.metered, meter.used, meter.regained])
            .flat_map(u64::to_le_bytes)
            .collect()
    }

    /// Goes on from what was kept, with what was driven since the start on top; missing numbers are zero.
    pub(crate) fn resume(&mut self, bytes: &[u8]) {
        let mut numbers = parts::numbers(bytes);
        for meter in [&mut self.a, &mut self.b] {
            for number in [&mut meter.way, &mut meter.metered, &mut meter.used, &mut meter.regained] {
                *number = number.saturating_add(numbers.next().unwrap_or(0));
            }
        }
    }

    /// Sets a trip to zero.
    pub(crate) fn reset(&mut self, trip: Trip) {
        match trip {
            Trip::A => self.a = Meter::ZERO,
            Trip::B => self.b = Meter::ZERO,
        }
    }

    /// Returns trip A and trip B.
    pub(crate) fn journeys(&self) -> [Journey; 2] {
        [self.a.journey(), self.b.journey()]
    }

    /// Returns the remaining range: as the vehicle sends it, otherwise estimated from charge and consumption.
    pub(crate) fn range(
        &self,
        shown: impl Fn(Value) -> Shown<i32>,
        known: impl Fn(Value) -> Option<i32>,
    ) -> Shown<Range> {
        let sent = shown(Value::VehicleRange);
        if let Shown::Value(km8) = sent {
            return Shown::Value(Range { km: kilometres(i64::from(km8) / 8), is_estimated: false });
        }
        let charge = shown(Value::BatterySoc);
        let estimate = charge.value().and_then(|charge| self.estimate_km(charge, known));
        match (estimate, sent, charge) {
            (Some(km), ..) => Shown::Value(Range { km, is_estimated: true }),
            (None, Shown::Stale, _) | (None, Shown::Never, Shown::Stale) => Shown::Stale,
            (None, Shown::Invalid, _) | (None, Shown::Never, Shown::Invalid) => Shown::Invalid,
            _ => Shown::Never,
        }
    }

    /// Returns how far the charge (0.1 %) above the battery's lower limit takes the vehicle at its average consumption.
    fn estimate_km(&self, charge: i32, known: impl Fn(Value) -> Option<i32>) -> Option<u16> {
        let meters = [&self.a, &self.b, &self.since_start];
        let longest = meters.into_iter().max_by_key(|meter| meter.metered)?;
        let average = longest.average_whkm(SHORTEST_FOR_RANGE).filter(|&average| average > 0)?;
        let capacity_ah = known(Value::BatteryCapacity)?;
        let decivolts = known(Value::BatteryRatedVoltage).or_else(|| known(Value::BatteryVoltage))?;
        let usable = (charge - known(Value::BatterySocLower).unwrap_or(0)).max(0);
        let watthours = i64::from(capacity_ah) * i64::from(decivolts) / 10 * i64::from(usable) / 1_000;
        Some(kilometres(watthours / i64::from(average)))
    }
}

fn kilometres(km: i64) -> u16 {
    km.clamp(0, u16::MAX.into()) as u16
}

/// Returns the power in 10 mW of 0.1 V and 0.1 A; missing as the first of the two that is.
pub(crate) fn power(voltage: Shown<i32>, current: Shown<i32>) -> Shown<i64> {
    match (voltage, current) {
        (Shown::Value(volts), current) => current.map(|amps| i64::from(volts) * i64::from(amps)),
        (Shown::Never, _) => Shown::Never,
        (Shown::Stale, _) => Shown::Stale,
        (Shown::Invalid, _) => Shown::Invalid,
    }
}

/// Returns the present consumption in Wh/km; `Never` below 5 km/h, where it says nothing.
pub(crate) fn consumption_whkm(speed: Shown<i32>, power: Shown<i64>) -> Shown<i32> {
    match speed {
        Shown::Value(speed) if speed >= SLOW => {
            power.map(|power| (power.saturating_mul(256) / (100 * i64::from(speed))) as i32)
        }
        Shown::Stale => Shown::Stale,
        Shown::Invalid => Shown::Invalid,
        Shown::Never | Shown::Value(_) => Shown::Never,
    }
}

/// Returns `second` only if it is known and `first` is not.
fn first_known(first: Shown<i32>, second: Shown<i32>) -> Shown<i32> {
    if first.value().is_none() && second.value().is_some() { second } else { first }
}

/// Returns whether energy that flows into the battery comes out of a plug.
pub(crate) fn is_charging(shown: impl Fn(Value) -> Shown<i32>) -> bool {
    shown(Value::ChargePlug) == Shown::Value(1)
        || shown(Value::ChargeState) == Shown::Value(Charge::Charging.number())
}

/// Returns what there is to tell while a plug is inserted; `None` = none is.
pub(crate) fn charging(shown: impl Fn(Value) -> Shown<i32>, capacity_ah: Option<i32>) -> Option<Charging> {
    let state = shown(Value::ChargeState).value().and_then(Charge::from_number);
    let plug = match (state, shown(Value::ChargePlug)) {
        (Some(Charge::Charging), _) => Plug::Charging,
        (Some(Charge::Complete), _) => Plug::Complete,
        (Some(Charge::Fault), _) => Plug::Fault,
        (None | Some(Charge::Idle), Shown::Value(1)) => Plug::Inserted,
        _ => return None,
    };
    // Into the battery is positive here; the charger's own figures where the battery's are not heard.
    let current = shown(Value::BatteryCurrent).map(i32::saturating_neg);
    let current = first_known(current, shown(Value::ChargerCurrent));
    let voltage = first_known(shown(Value::BatteryVoltage), shown(Value::ChargerVoltage));
    let hectowatts = power(voltage, current).map(|power| (power / 10_000) as i32);
    let minutes_left = match (plug, shown(Value::BatterySoc).value(), current.value(), capacity_ah) {
        (Plug::Charging, Some(charge), Some(amps), Some(capacity)) if amps > 0 && charge <= 1_000 => {
            // Ah to go = capacity x (1000 - charge) / 1000; minutes = Ah x 60 / (0.1 A x 10).
            let minutes = i64::from(capacity) * i64::from(1_000 - charge) * 3 / (5 * i64::from(amps));
            u16::try_from(minutes).ok()
        }
        _ => None,
    };
    Some(Charging { plug, decivolts: voltage, deciamps: current, hectowatts, minutes_left })
}
