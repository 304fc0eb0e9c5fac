//! An element: a short text, a number with its unit or a mark, at a fixed place of a page.
//!
//! Owns what may stand in an element and how one row of it is painted; which elements a page has is in `pages`. An element is
//! sent anew when it differs from the one before, and only then.

use crate::{
    fonts::{self, CLOCK, CROSS, DASH, Font},
    layout::{Align, Area, BAR_PART, rounded},
    scanline::Scanline,
    theme::{Ink, Palette, Ramp},
};
use protocol_core::model::{Severity, Shown};

/// Most characters of a [`Short`]: when a fault came, in hours of 136 years, and how often.
const MOST_CHARACTERS: usize = 22;
/// Space between a number and its unit, and between a text and its code, pixels.
const GAP: u16 = 4;

/// A few characters of Latin-1 and the fonts' marks for missing numbers, put together when a view comes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Short {
    codes: [u8; MOST_CHARACTERS],
    length: u8,
}

impl Short {
    pub(crate) const EMPTY: Self = Self { codes: [0; MOST_CHARACTERS], length: 0 };

    /// Returns a number of `decimals` figures behind the point, or the marks of a missing one.
    pub(crate) fn shown(shown: Shown<i32>, decimals: u32) -> Self {
        let marks: &[u8] = match shown {
            Shown::Value(value) => return Self::EMPTY.decimal(value, decimals),
            Shown::Never => &[DASH, DASH],
            Shown::Stale => &[CLOCK, DASH, DASH],
            Shown::Invalid => &[CROSS, DASH, DASH],
        };
        marks.iter().fold(Self::EMPTY, |short, &mark| short.code(mark))
    }

    /// Appends one character; what does not fit is left out.
    pub(crate) fn code(mut self, code: u8) -> Self {
        if let Some(room) = self.codes.get_mut(usize::from(self.length)) {
            *room = code;
            self.length += 1;
        }
        self
    }

    /// Appends a whole number with at least `least` figures.
    pub(crate) fn number(self, number: u32, least: u32) -> Self {
        let figures = number.checked_ilog10().map_or(1, |log| log + 1).max(least);
        let figure = |place: u32| number.checked_div(10_u32.pow(place)).unwrap_or(0) % 10;
        (0..figures).rev().fold(self, |short, place| short.code(b'0' + figure(place) as u8))
    }

    /// Appends a number of which the last `decimals` figures stand behind the point.
    pub(crate) fn decimal(self, value: i32, decimals: u32) -> Self {
        let one = 10_u32.pow(decimals);
        let signed = if value < 0 { self.code(b'-') } else { self };
        let whole = signed.number(value.unsigned_abs() / one, 1);
        if decimals == 0 { whole } else { whole.code(b'.').number(value.unsigned_abs() % one, decimals) }
    }

    fn characters(&self) -> impl Iterator<Item = char> + Clone {
        self.codes.iter().take(usize::from(self.length)).map(|&code| char::from(code))
    }
}

/// What stands in an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Content {
    Blank,
    Words(&'static str),
    Short(Short),
    /// A number and its unit.
    Measure(Short, &'static str),
    /// A text and, at the other end, its code.
    Coded(&'static str, Option<u16>),
    /// Pixels of a bar that are lit.
    Bar(Option<u16>),
    /// A field in the colour of a severity.
    Mark(Severity),
}

/// An element of a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Element {
    pub(crate) content: Content,
    pub(crate) ink: Ink,
}

impl Element {
    pub(crate) const BLANK: Self = Self { content: Content::Blank, ink: Ink::Primary };
}

/// Returns the ink of a number: missing ones stand back.
pub(crate) fn ink_of<T>(shown: Shown<T>) -> Ink {
    match shown {
        Shown::Value(_) => Ink::Primary,
        Shown::Never => Ink::Faint,
        Shown::Stale | Shown::Invalid => Ink::Secondary,
    }
}

/// Where an element stands.
#[derive(Debug)]
pub(crate) struct Place {
    pub(crate) area: Area,
    /// Top of the capitals.
    pub(crate) top: u16,
    pub(crate) font: &'static Font,
    pub(crate) align: Align,
}

impl Place {
    pub(crate) const fn new(area: Area, top: u16, font: &'static Font, align: Align) -> Self {
        Self { area, top, font, align }
    }

    /// Returns the column at which something of `width` begins.
    fn left(&self, width: u16) -> i16 {
        let (x, room) = (self.area.x as i16, self.area.width as i16);
        match self.align {
            Align::Left => x,
            Align::Centre => x + (room - width as i16) / 2,
            Align::Right => x + room - width as i16,
        }
    }

    /// Returns how far a number moves to the left so that its sign begins where a figure would.
    fn lean(&self, content: &Content) -> i16 {
        let (Content::Short(short) | Content::Measure(short, _), Align::Left) = (content, self.align) else {
            return 0;
        };
        let sign = short.characters().next().filter(|&first| first == '-');
        let glyph = sign.and_then(|sign| self.font.glyph(self.font.find(sign)?));
        glyph.map_or(0, |glyph| i16::from(glyph.left))
    }

    /// Returns the width of what stands in an element here, pixels.
    pub(crate) fn width(&self, content: &Content) -> u16 {
        match content {
            Content::Blank => 0,
            Content::Words(text) => self.font.width(text),
            Content::Short(short) => width(self.font, short.characters()),
            Content::Measure(short, unit) => {
                width(self.font, short.characters()) + GAP + fonts::LABEL.width(unit) + overhang(unit)
            }
            Content::Coded(text, code) => {
                let code = code.map_or(0, |code| GAP + width(self.font, number(code).characters()));
                self.font.width(text) + code
            }
            Content::Bar(_) | Content::Mark(_) => self.area.width,
        }
    }

    /// Returns whether something has room here; some glyphs reach one pixel over their width.
    pub(crate) fn has_room_for(&self, content: &Content) -> bool {
        self.width(content) < self.area.width
    }

    /// Returns the content that `with` makes of a number of which the last `decimals` figures stand behind the point.
    ///
    /// What has no room loses decimals first, rounded; a number that has no room even so becomes the nearest that does.
    pub(crate) fn fit(&self, value: i32, decimals: u32, with: impl Fn(i32, u32) -> Content) -> Content {
        let shorter = (0..=decimals).map(|lost| (rounded(value, 10_i32.pow(lost)), decimals - lost));
        let nearest = (0..10).rev().map(|figures| ((10_i32.pow(figures) - 1) * value.signum(), 0));
        let mut contents = shorter.chain(nearest).map(|(value, decimals)| with(value, decimals));
        contents.find(|content| self.has_room_for(content)).unwrap_or(Content::Blank)
    }

    /// Paints an element's part of a row that is ground so far.
    pub(crate) fn paint(&self, element: &Element, row: &mut Scanline, palette: &Palette) {
        let ramp = palette.ramp(element.ink);
        let left = self.left(self.width(&element.content)) - self.lean(&element.content);
        match &element.content {
            Content::Blank => {}
            Content::Words(text) => {
                paint(row, self.font, text.chars(), left, self.top, ramp);
            }
            Content::Short(short) => {
                paint(row, self.font, short.characters(), left, self.top, ramp);
            }
            Content::Measure(short, unit) => {
                let end = paint(row, self.font, short.characters(), left, self.top, ramp);
                // Both stand on one base line.
                let top = self.top + u16::from(self.font.cap) - u16::from(fonts::LABEL.cap);
                let ramp =
                    palette.ramp(if element.ink == Ink::OnStop { Ink::OnStop } else { Ink::Secondary });
                paint(row, &fonts::LABEL, unit.chars(), end + GAP as i16, top, ramp);
            }
            Content::Coded(text, code) => {
                paint(row, self.font, text.chars(), self.area.x as i16, self.top, ramp);
                if let Some(code) = code.map(number) {
                    let left = self.area.right() - width(self.font, code.characters());
                    paint(row, self.font, code.characters(), left as i16, self.top, ramp);
                }
            }
            Content::Bar(lit) => {
                let Area { x, width, .. } = self.area;
                match lit {
                    Some(lit) => {
                        row.fill(x, *lit, palette.colour(element.ink));
                        row.fill(x + lit, width - lit, palette.track);
                    }
                    None => {
                        for dot in (x..x + width).step_by(usize::from(BAR_PART)) {
                            row.fill(dot, BAR_PART / 2, palette.track);
                        }
                    }
                }
            }
            Content::Mark(severity) => {
                row.fill(self.area.x, self.area.width, palette.stripes[*severity as usize]);
            }
        }
    }
}

/// Returns how far the last letter of a unit reaches over its width, pixels.
fn overhang(unit: &str) -> u16 {
    let last = unit.chars().next_back().and_then(|one| fonts::LABEL.glyph(fonts::LABEL.find(one)?));
    let reach =
        last.map_or(0, |glyph| i16::from(glyph.left) + i16::from(glyph.width) - i16::from(glyph.advance));
    reach.max(0) as u16
}

fn number(code: u16) -> Short {
    Short::EMPTY.number(code.into(), 1)
}

fn width(font: &Font, characters: impl Iterator<Item = char>) -> u16 {
    characters.filter_map(|one| font.glyph(font.find(one)?)).map(|glyph| u16::from(glyph.advance)).sum()
}

/// Paints characters from column `x` on; returns the column behind them.
fn paint(
    row: &mut Scanline,
    font: &Font,
    characters: impl Iterator<Item = char>,
    x: i16,
    top: u16,
    ramp: &Ramp,
) -> i16 {
    let mut pen = x;
    for glyph in characters.filter_map(|one| font.glyph(font.find(one)?)) {
        if let Some(coverage) = font.coverage(glyph, pen, top as i16, row.y as i16) {
            row.cover(&coverage, ramp);
        }
        pen += i16::from(glyph.advance);
    }
    pen
}

#[cfg(test)]
mod tests {
    use super::*;
    extern crate std;
    use std::string::String;

    fn read(short: Short) -> String {
        short.characters().collect()
    }

    #[test]
    fn numbers_have_their_sign_their_point_and_every_decimal() {
        for (value, decimals, expected) in [
            (0, 0, "0"),
            (7, 0, "7"),
            (-120, 0, "-120"),
            (0, 1, "0.0"),
            (5, 1, "0.5"),
            (-5, 1, "-0.5"),
            (1_234, 1, "123.4"),
            (3_005, 3, "3.005"),
            (i32::MAX, 0, "2147483647"),
            (i32::MIN, 1, "-214748364.8"),
        ] {
            assert_eq!(read(Short::shown(Shown::Value(value), decimals)), expected);
        }
    }

    #[test]
    fn missing_numbers_have_marks_of_their_own_and_no_figure() {
        let marks = [Shown::Never, Shown::Stale, Shown::Invalid].map(|shown| Short::shown(shown, 1).codes);
        assert_eq!([marks[0][..3].to_vec(), marks[1][..3].to_vec()], [[DASH, DASH, 0], [CLOCK, DASH, DASH]]);
        assert_eq!(marks[2][0], CROSS);
    }

    #[test]
    fn a_number_without_room_loses_its_decimals_and_then_its_last_figures() {
        // Six figures of eight pixels.
        let place = Place::new(Area::new(0, 0, 49, 14), 0, &fonts::VALUE, Align::Left);
        let of = |value, decimals| match place
            .fit(value, decimals, |value, decimals| Content::Short(Short::EMPTY.decimal(value, decimals)))
        {
            Content::Short(short) => read(short),
            other => std::format!("{other:?}"),
        };
        for (value, decimals, expected) in [
            (0, 2, "0.00"),
            (-131, 1, "-13.1"),
            (99_949, 1, "9994.9"),
            (123_456, 1, "12346"),
            (-123_444, 1, "-12344"),
            (-99_999, 2, "-1000"),
            (123_456_789, 3, "123457"),
            (i32::MAX, 0, "999999"),
            (i32::MIN, 0, "-99999"),
            (i32::MAX, 3, "999999"),
        ] {
            assert_eq!(of(value, decimals), expected, "{value} with {decimals} decimals");
        }
    }

    #[test]
    fn what_does_not_fit_is_left_out() {
        let long = (0..40).fold(Short::EMPTY, |short, _| short.code(b'8'));
        assert_eq!(read(long), "8".repeat(MOST_CHARACTERS));
    }

    #[test]
    fn a_number_with_leading_zeros_keeps_them() {
        assert_eq!(read(Short::EMPTY.number(7, 2)), "07");
        assert_eq!(read(Short::EMPTY.number(0, 2)), "00");
        assert_eq!(read(Short::EMPTY.number(123, 2)), "123");
    }
}
