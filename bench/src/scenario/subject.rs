//! What a scenario runs against.

use super::{Action, Answer, Name, Place};
use anyhow::Result;

/// A vehicle with its cluster: things are done to it, time passes, it is looked at.
pub trait Subject {
    /// Which of the two it is.
    fn place(&self) -> Place;

    /// Lets virtual time pass up to `ms` since the start.
    ///
    /// # Errors
    /// If it cannot go on: the firmware does what the bench does not model.
    fn advance_to(&mut self, ms: u64) -> Result<()>;

    /// Does one thing, now.
    ///
    /// # Errors
    /// If the vehicle has no such control or it does not take this setting.
    fn act(&mut self, action: &Action) -> Result<()>;

    /// Returns what is to be seen under `name` now; `None` = it is not to be seen here.
    fn look(&mut self, name: &Name) -> Option<Answer>;

    /// Compares the panel with a golden picture: the answer is its name, or how it differs; `None` = there is no panel.
    fn picture(&mut self, _file: &str) -> Option<Answer> {
        None
    }

    /// Returns the sound that played at `ms`, once time has gone on for [`Self::hindsight_ms`].
    fn sound_at(&self, ms: u64) -> Answer;

    /// How long after a moment it is known what sounded then, in milliseconds.
    fn hindsight_ms(&self) -> u64;
}
