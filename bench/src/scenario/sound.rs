//! From the buzzer's tones back to the sound that they are part of.
//!
//! A pause does not tell whether its sound has ended: that is known by the next tone, and of the last pause never. The
//! table of sounds is written down here a second time on purpose: firmware that plays another tone or another rhythm is found out.
//! Source: BUS-R017, BUS-R050, BUS-R079, C5-R013; the patterns are the cluster's own.

use super::Answer;
use crate::chips::bench_board::PwmChange;
use crate::time::Nanos;

/// Name, pitch in Hz, length of a tone and of a pause in milliseconds.
type Row = (&'static str, u32, u64, u64);

const ROWS: [Row; 6] = [
    ("fire", 2_400, 100, 100),
    ("stop", 2_000, 300, 200),
    ("reverse", 1_000, 500, 500),
    ("buzzer", 1_400, 250, 250),
    ("derate", 1_600, 200, 800),
    ("warn", 1_200, 150, 1_850),
];

/// Words of the sounds; silence is `none`.
pub(super) fn words() -> impl Iterator<Item = &'static str> {
    ["none"].into_iter().chain(ROWS.iter().map(|row| row.0))
}

/// After this long a pause has shown whether its sound goes on, in milliseconds.
pub(super) const LONGEST_PAUSE_MS: u64 = 1_850 + SLACK_MS + 50;
/// Ticks that fall late, in milliseconds.
const SLACK_MS: u64 = 25;
/// PWM dividers round the pitch: this far off is the same, in thousandths.
const PITCH_TOLERANCE: u32 = 10;

/// Returns the sound that plays at `at`: a word of the table, `none`, or a tone that is not in the table, as `950 Hz`.
pub(super) fn sound_at(changes: &[PwmChange], at: Nanos) -> Answer {
    let is_tone = |change: &PwmChange| change.duty > 0;
    let Some(now) = changes.iter().rposition(|change| change.at <= at) else { return Answer::word("none") };
    if is_tone(&changes[now]) {
        return Answer::Word(name(changes[now].frequency_hz));
    }
    let Some(before) = changes[..now].iter().rposition(is_tone) else { return Answer::word("none") };
    let Some(&(sound, hz, tone_ms, pause_ms)) = row(changes[before].frequency_hz) else {
        return Answer::word("none");
    };
    let millis = |from: Nanos, to: Nanos| to.since(from).as_micros() / 1_000;
    let ended = changes[before + 1].at;
    if millis(changes[before].at, ended) + SLACK_MS < tone_ms {
        // Cut off in its tone: it has ended.
        return Answer::word("none");
    }
    let behind = changes[now..].iter().find(|change| is_tone(change));
    let is_next = |behind: &&PwmChange| {
        row(behind.frequency_hz).is_some_and(|row| row.1 == hz)
            && millis(ended, behind.at).abs_diff(pause_ms) <= SLACK_MS
    };
    if behind.is_some_and(|behind| is_next(&behind)) {
        Answer::word(sound)
    } else if millis(ended, at) < pause_ms {
        Answer::Pause(sound.into())
    } else {
        Answer::word("none")
    }
}

fn row(frequency_hz: u32) -> Option<&'static Row> {
    ROWS.iter().find(|(_, hz, _, _)| hz.abs_diff(frequency_hz) * 1_000 <= hz * PITCH_TOLERANCE)
}

fn name(frequency_hz: u32) -> String {
    row(frequency_hz).map_or_else(|| format!("{frequency_hz} Hz"), |row| row.0.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn change(ms: u64, frequency_hz: u32) -> PwmChange {
        let duty = if frequency_hz > 0 { 32_768 } else { 0 };
        PwmChange { at: Nanos::from_millis(ms), frequency_hz, duty }
    }

    fn heard(changes: &[PwmChange], ms: u64) -> Answer {
        sound_at(changes, Nanos::from_millis(ms))
    }

    fn pause(sound: &str) -> Answer {
        Answer::Pause(sound.into())
    }

    #[test]
    fn a_sound_goes_on_through_its_own_pauses_and_may_have_ended_in_the_last() {
        let changes = [change(100, 1_000), change(600, 0), change(1_100, 998), change(1_600, 0)];
        let at = |ms| heard(&changes, ms);
        assert_eq!(at(99), Answer::word("none"));
        assert_eq!(at(100), Answer::word("reverse"));
        assert_eq!(at(900), Answer::word("reverse"));
        assert_eq!(at(1_599), Answer::word("reverse"));
        assert_eq!(at(1_600), pause("reverse"));
        assert_eq!(at(2_099), pause("reverse"));
        assert_eq!(at(2_100), Answer::word("none"));
    }

    #[test]
    fn a_sound_that_is_cut_off_in_its_tone_has_ended() {
        assert_eq!(heard(&[change(0, 1_000), change(300, 0)], 310), Answer::word("none"));
    }

    #[test]
    fn a_pause_of_the_wrong_length_ends_the_sound() {
        let changes = [change(0, 1_000), change(500, 0), change(1_300, 1_000), change(1_800, 0)];
        assert_eq!(heard(&changes, 700), pause("reverse"));
        assert_eq!(heard(&changes, 1_100), Answer::word("none"));
    }

    #[test]
    fn another_sound_behind_the_pause_ends_the_first() {
        let changes = [change(0, 1_000), change(500, 0), change(1_000, 2_000), change(1_300, 0)];
        assert_eq!(heard(&changes, 700), pause("reverse"));
        assert_eq!(heard(&changes, 1_100), Answer::word("stop"));
    }

    #[test]
    fn a_tone_that_is_in_no_table_is_told_by_its_pitch() {
        assert_eq!(heard(&[change(0, 950)], 1), Answer::word("950 Hz"));
    }

    #[test]
    fn the_table_is_the_cluster_s() {
        let words: Vec<&str> = cluster::Sound::ALL.iter().map(|sound| sound.key()).collect();
        assert_eq!(ROWS.map(|row| row.0).to_vec(), words);
    }
}
