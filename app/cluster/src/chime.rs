//! The sounds of the cluster: which one, how it goes, which one wins.
//!
//! Owns the table of sounds and since when the present one plays. What calls for a sound is decided by faults and
//! gear; the buzzer is the firmware's.
//! Source: BUS-R050 and BUS-112 (fault levels), BUS-R017 (reversing), BUS-R079 (fire), C5-R013
//! (buzzer).

use protocol_core::Millis;

/// A sound of the cluster, the most urgent first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Sound {
    /// Fire in the traction battery; acknowledged, it comes again.
    Fire,
    /// A fault that means stop.
    Stop,
    /// R is engaged.
    Reverse,
    /// The vehicle controller asks for the buzzer (C5-R013).
    Buzzer,
    /// A fault that limits the power.
    Derate,
    /// A fault to know of.
    Warn,
}

/// A sound that plays now.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chime {
    /// Its pattern of tones.
    pub sound: Sound,
    /// Pitch in Hz.
    pub frequency_hz: u16,
    /// Length of each tone in milliseconds.
    pub on_ms: u16,
    /// Pause after each tone in milliseconds.
    pub off_ms: u16,
    /// The buzzer is to sound now; otherwise it is in a pause.
    pub is_on: bool,
}

/// How a sound goes.
struct Pattern {
    frequency_hz: u16,
    on_ms: u16,
    off_ms: u16,
}

impl Sound {
    /// Every sound, the most urgent first.
    pub const ALL: &'static [Self] =
        &[Self::Fire, Self::Stop, Self::Reverse, Self::Buzzer, Self::Derate, Self::Warn];

    /// Returns the public name.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Fire => "fire",
            Self::Stop => "stop",
            Self::Reverse => "reverse",
            Self::Buzzer => "buzzer",
            Self::Derate => "derate",
            Self::Warn => "warn",
        }
    }

    /// The table of sounds.
    const fn pattern(self) -> Pattern {
        let (frequency_hz, on_ms, off_ms) = match self {
            Self::Fire => (2_400, 100, 100),
            Self::Stop => (2_000, 300, 200),
            Self::Reverse => (1_000, 500, 500),
            Self::Buzzer => (1_400, 250, 250),
            Self::Derate => (1_600, 200, 800),
            Self::Warn => (1_200, 150, 1_850),
        };
        Pattern { frequency_hz, on_ms, off_ms }
    }
}

/// Which sound plays, and since when.
#[derive(Clone, Copy)]
pub(crate) struct Player {
    playing: Option<(Sound, Millis)>,
}

impl Player {
    pub(crate) const fn new() -> Self {
        Self { playing: None }
    }

    /// Plays the most urgent of the `wanted` sounds; one that plays already goes on in its rhythm.
    pub(crate) fn play(&mut self, wanted: impl IntoIterator<Item = Option<Sound>>, now: Millis) {
        let sound = wanted.into_iter().flatten().min();
        if self.playing.map(|(playing, _)| playing) != sound {
            self.playing = sound.map(|sound| (sound, now));
        }
    }

    /// Returns the sound that plays and where it is in its pattern.
    pub(crate) fn chime(&self, now: Millis) -> Option<Chime> {
        self.playing.map(|(sound, since)| {
            let Pattern { frequency_hz, on_ms, off_ms } = sound.pattern();
            let period_ms = u64::from(on_ms) + u64::from(off_ms);
            let is_on = now.since(since) % period_ms.max(1) < u64::from(on_ms);
            Chime { sound, frequency_hz, on_ms, off_ms, is_on }
        })
    }
}
