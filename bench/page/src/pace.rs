//! How virtual time follows the wall clock.
//!
//! Owns pause, single steps and the factor, and says when the next slice is due. Pure: the wall clock is an argument. A
//! machine that cannot keep up loses wall time instead of rushing after it later.

use bench::time::Nanos;
use std::time::Duration;

/// Virtual time that passes between two looks at the page's commands.
pub(crate) const SLICE: Nanos = Nanos::from_millis(10);
/// Largest factor that may be asked for; above it only "as fast as possible" makes sense.
const FACTOR_MAX: f64 = 100.0;
/// Virtual seconds by which the engine may be behind before the rest is given up.
const DEBT_MAX: f64 = 0.1;
/// Longest sleep between two looks at the clock.
const NAP_MAX: Duration = Duration::from_millis(5);
/// Engine time after which older work counts half.
const FADE_SECONDS: f64 = 1.0;

/// Virtual time against the wall clock.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace {
    paused: bool,
    /// Slices that may pass while paused.
    steps: u32,
    /// Virtual seconds per second; 0 = as fast as the machine can.
    factor: f64,
    /// Virtual and wall time at the last change of pace.
    since: (Nanos, Duration),
    /// Virtual and engine seconds of late.
    spent: (f64, f64),
    /// Virtual and wall time at the last [`Pace::measure`].
    measured: (Nanos, Duration),
    /// Virtual seconds per second between the last two of them.
    speed: f64,
}

impl Pace {
    /// Real time from now on.
    pub(crate) fn new(now: Nanos, wall: Duration) -> Self {
        Self {
            paused: false,
            steps: 0,
            factor: 1.0,
            since: (now, wall),
            spent: (0.0, 0.0),
            measured: (now, wall),
            speed: 0.0,
        }
    }

    /// The same pace for a bench whose time starts again.
    pub(crate) fn restart(&mut self, now: Nanos, wall: Duration) {
        (self.since, self.measured, self.spent) = ((now, wall), (now, wall), (0.0, 0.0));
    }

    pub(crate) fn pause(&mut self, on: bool, now: Nanos, wall: Duration) {
        (self.paused, self.steps, self.since) = (on, 0, (now, wall));
    }

    /// Lets `slices` slices pass, then stands still.
    pub(crate) fn step(&mut self, slices: u32) {
        (self.paused, self.steps) = (true, slices);
    }

    /// Virtual seconds per second, 0 = as fast as possible; what is not a number changes nothing.
    pub(crate) fn set_factor(&mut self, factor: f64, now: Nanos, wall: Duration) {
        if factor.is_finite() {
            (self.factor, self.since) = (factor.clamp(0.0, FACTOR_MAX), (now, wall));
        }
    }

    pub(crate) fn is_paused(&self) -> bool {
        self.paused
    }

    pub(crate) fn factor(&self) -> f64 {
        self.factor
    }

    /// Returns whether a slice may pass now.
    pub(crate) fn is_due(&mut self, now: Nanos, wall: Duration) -> bool {
        if self.paused {
            return self.steps > 0;
        }
        if self.factor == 0.0 {
            return true;
        }
        let behind = self.behind(now, wall);
        if behind > DEBT_MAX * self.factor.max(1.0) {
            self.since = (now, wall);
            return true;
        }
        behind > 0.0
    }

    /// Returns how long there is nothing to do.
    pub(crate) fn nap(&self, now: Nanos, wall: Duration) -> Duration {
        if self.paused || self.factor == 0.0 {
            return NAP_MAX;
        }
        let early = -self.behind(now, wall) / self.factor;
        Duration::from_secs_f64(early.clamp(0.0, NAP_MAX.as_secs_f64())).max(Duration::from_micros(200))
    }

    /// A slice has passed in `engine` time.
    pub(crate) fn passed(&mut self, engine: Duration) {
        self.steps = self.steps.saturating_sub(1);
        self.spent.0 += SLICE.as_secs_f64();
        self.spent.1 += engine.as_secs_f64();
        if self.spent.1 > FADE_SECONDS {
            self.spent = (self.spent.0 / 2.0, self.spent.1 / 2.0);
        }
    }

    /// Virtual seconds that the engine makes of one second of its thread, of late.
    pub(crate) fn capability(&self) -> f64 {
        self.spent.0 / self.spent.1.max(1e-9)
    }

    /// Virtual seconds that passed in one second, smoothed.
    pub(crate) fn measure(&mut self, now: Nanos, wall: Duration) -> f64 {
        let seconds = wall.saturating_sub(self.measured.1).as_secs_f64();
        if seconds > 0.0 {
            let speed = now.since(self.measured.0).as_secs_f64() / seconds;
            self.speed += (speed - self.speed) * (seconds * 2.0).min(1.0);
            self.measured = (now, wall);
        }
        self.speed
    }

    fn behind(&self, now: Nanos, wall: Duration) -> f64 {
        let wanted = wall.saturating_sub(self.since.1).as_secs_f64() * self.factor;
        wanted - now.since(self.since.0).as_secs_f64()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn ms(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    /// Virtual milliseconds that pass in `wall_ms` of a machine whose slices cost `cost_ms`.
    fn driven(pace: &mut Pace, wall_ms: u64, cost_ms: u64) -> u64 {
        let (mut now, mut wall) = (Nanos::ZERO, 0);
        while wall < wall_ms {
            if pace.is_due(now, ms(wall)) {
                now += SLICE;
                pace.passed(ms(cost_ms));
                wall += cost_ms;
            } else {
                wall += 1;
            }
        }
        now.0 / 1_000_000
    }

    fn fresh() -> Pace {
        Pace::new(Nanos::ZERO, Duration::ZERO)
    }

    #[test]
    fn real_time_is_kept_to_a_slice() {
        assert!(driven(&mut fresh(), 1_000, 1).abs_diff(1_000) <= 10);
    }

    #[test]
    fn slower_and_faster_follow_the_factor() {
        for (factor, wanted) in [(0.1, 100), (0.5, 500), (4.0, 4_000)] {
            let mut pace = fresh();
            pace.set_factor(factor, Nanos::ZERO, Duration::ZERO);
            assert!(driven(&mut pace, 1_000, 1).abs_diff(wanted) <= 50, "factor {factor}");
        }
    }

    #[test]
    fn a_slow_machine_does_not_rush_after_lost_time() {
        let mut pace = fresh();
        assert!(pace.is_due(Nanos::ZERO, ms(60_000)), "a minute of sleep");
        assert!(!pace.is_due(SLICE, ms(60_000)));
        assert!(!pace.is_due(SLICE, ms(60_009)));
        assert!(pace.is_due(SLICE, ms(60_011)));
    }

    #[test]
    fn paused_time_moves_by_steps_only() {
        let mut pace = fresh();
        pace.pause(true, Nanos::ZERO, Duration::ZERO);
        assert_eq!(driven(&mut pace, 1_000, 1), 0);
        pace.step(3);
        assert_eq!(driven(&mut pace, 1_000, 1), 30);
        pace.pause(false, Nanos::ZERO, ms(0));
        assert!(driven(&mut pace, 100, 1) >= 90);
    }

    #[test]
    fn a_factor_that_is_no_number_is_ignored() {
        let mut pace = fresh();
        pace.set_factor(f64::NAN, Nanos::ZERO, Duration::ZERO);
        assert_eq!(pace.factor(), 1.0);
        pace.set_factor(1e9, Nanos::ZERO, Duration::ZERO);
        assert_eq!(pace.factor(), FACTOR_MAX);
    }
}
