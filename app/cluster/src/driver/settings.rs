//! What the driver may choose: language and colours.

use crate::view::{Language, Theme};

/// The choices.
#[derive(Clone, Copy)]
pub(crate) struct Settings {
    pub(crate) language: Language,
    pub(crate) theme: Theme,
}

impl Settings {
    pub(crate) const fn new() -> Self {
        Self { language: Language::Chinese, theme: Theme::Night }
    }

    /// Turns to the next of the four combinations: the language changes with every step, the colours with every other.
    pub(crate) fn advance(&mut self) {
        (self.language, self.theme) = match (self.language, self.theme) {
            (Language::Chinese, theme) => (Language::English, theme),
            (Language::English, Theme::Night) => (Language::Chinese, Theme::Day),
            (Language::English, Theme::Day) => (Language::Chinese, Theme::Night),
        };
    }
}
