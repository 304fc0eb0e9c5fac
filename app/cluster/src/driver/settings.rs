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

    /// Returns what is to be kept: language, theme.
    pub(crate) fn kept(self) -> [u8; 2] {
        let place = |is_second| u8::from(is_second);
        [place(self.language == Language::English), place(self.theme == Theme::Day)]
    }

    /// Takes what was kept; what is missing or unknown stays.
    pub(crate) fn resume(&mut self, bytes: &[u8]) {
        let mut bytes = bytes.iter();
        self.language = match bytes.next() {
            Some(0) => Language::Chinese,
            Some(1) => Language::English,
            _ => self.language,
        };
        self.theme = match bytes.next() {
            Some(0) => Theme::Night,
            Some(1) => Theme::Day,
            _ => self.theme,
        };
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
