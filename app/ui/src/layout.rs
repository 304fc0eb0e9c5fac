//! Where everything is: widgets as rows of tables on a grid of 320 x 240.
//!
//! Owns positions and what each field shows; refuses to know colours of the theme and how a pixel is made. From top to
//! bottom: lamps, the dial with the side columns, lamps, the stripe of the worst severity, the message line.
//! Source: BUS-R015, R020, R057, R058, R071; telltales in fixed places by ISO 2575.

use crate::{
    fonts::{self, Font, ICON_SIZE},
    theme::Ink,
    words,
};
use cluster::{Place, Telltale, View, view::Text};
use protocol_core::model::Shown;

/// A rectangle in whole pixels of the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Area {
    pub(crate) x: u16,
    pub(crate) y: u16,
    pub(crate) width: u16,
    pub(crate) height: u16,
}

impl Area {
    pub(crate) const fn new(x: u16, y: u16, width: u16, height: u16) -> Self {
        Self { x, y, width, height }
    }

    pub(crate) const fn pixels(self) -> u32 {
        self.width as u32 * self.height as u32
    }

    pub(crate) const fn right(self) -> u16 {
        self.x + self.width
    }

    pub(crate) const fn bottom(self) -> u16 {
        self.y + self.height
    }

    #[inline]
    pub(crate) const fn meets(self, other: Self) -> bool {
        self.y < other.bottom() && other.y < self.bottom() && self.x < other.right() && other.x < self.right()
    }

    /// Returns what both cover.
    #[cfg(test)]
    pub(crate) fn common(self, other: Self) -> Option<Self> {
        let (x, y) = (self.x.max(other.x), self.y.max(other.y));
        let (right, bottom) = (self.right().min(other.right()), self.bottom().min(other.bottom()));
        (x < right && y < bottom).then(|| Self::new(x, y, right - x, bottom - y))
    }

    /// Returns the smallest rectangle around both.
    pub(crate) fn around(self, other: Self) -> Self {
        let (x, y) = (self.x.min(other.x), self.y.min(other.y));
        let (right, bottom) = (self.right().max(other.right()), self.bottom().max(other.bottom()));
        Self::new(x, y, right - x, bottom - y)
    }
}

/// The message line.
pub(crate) const BAND: Area = Area::new(0, 216, crate::WIDTH, 24);
/// First column of the message's text.
pub(crate) const BAND_LEFT: u16 = 8;
/// Column behind the message's code and number.
pub(crate) const BAND_RIGHT: u16 = 312;
/// Top of the message's capitals.
pub(crate) const BAND_TEXT_TOP: u16 = 222;
/// Stripe in the colour of the worst severity.
pub(crate) const STRIPE: Area = Area::new(0, 213, crate::WIDTH, 3);

/// What changes with the page: all between the two rows of telltales.
pub(crate) const PAGE: Area = Area::new(0, 26, crate::WIDTH, 163);

/// Telltales stand in two rows of twelve places; READY takes two.
const TELLTALE_CELL: u16 = 26;
const TELLTALE_LEFT: u16 = 4;
const TELLTALE_ROWS: [u16; 2] = [2, 189];

/// Returns the place of a telltale.
pub(crate) const fn telltale(telltale: Telltale) -> Area {
    let (row, column) = match telltale.place() {
        Place::Cell(row, column) => (row, column),
        Place::With(host) => match host.place() {
            Place::Cell(row, column) => (row, column),
            Place::With(_) => panic!("a cell is shared with a telltale that has one of its own"),
        },
    };
    let (x, y) = (TELLTALE_LEFT + column as u16 * TELLTALE_CELL, TELLTALE_ROWS[row as usize]);
    match telltale {
        Telltale::Ready => Area::new(x, y, 2 * TELLTALE_CELL, ICON_SIZE),
        _ => Area::new(x + 2, y, ICON_SIZE, ICON_SIZE),
    }
}

/// The two rings; their pixels are generated.
pub(crate) const DIAL: Area = Area::new(
    fonts::DIAL_CENTRE - fonts::DIAL_RADIUS,
    fonts::DIAL_TOP,
    2 * fonts::DIAL_RADIUS,
    fonts::DIAL_ROWS.len() as u16,
);

/// Full scale of the dial's outer ring, km/h: 9 parts of 20.
pub(crate) const DIAL_KMH: u32 = 180;
/// Full scale of the dial's inner ring, rpm: 6 parts of 2000.
pub(crate) const DIAL_RPM: u32 = 12_000;

/// Top of the gear letter.
pub(crate) const GEAR_TOP: u16 = 46;
/// Place of the gear letter.
pub(crate) const GEAR: Area = Area::new(146, GEAR_TOP - 1, 28, 24);

/// Top of the speed's figures.
pub(crate) const SPEED_TOP: u16 = 74;
/// Half the width of a figure of the speed: figures are centred, so they move in steps of this.
pub(crate) const SPEED_HALF: u16 = 25;
/// Place of the speed: round figures reach two pixels over the capitals, on either side.
pub(crate) const SPEED: Area = Area::new(160 - 3 * SPEED_HALF, SPEED_TOP - 2, 6 * SPEED_HALF, 82);

/// Bar of the state of charge.
pub(crate) const CHARGE_BAR: Area = Area::new(6, 55, 68, 6);
/// Bar of the power: regeneration to the left of [`POWER_ZERO`], drive to the right.
pub(crate) const POWER_BAR: Area = Area::new(246, 55, 68, 6);
/// Column of zero power.
pub(crate) const POWER_ZERO: u16 = 268;
/// Width of the power bar's drive side; the square root of the power is drawn, full at [`POWER_FULL`].
pub(crate) const POWER_REACH: u32 = 46;
/// Power at the end of the drive side, in 0.1 kW.
pub(crate) const POWER_FULL: u32 = 2_000;
/// A bar is sent in parts of this width.
pub(crate) const BAR_PART: u16 = 8;

/// Proof of life.
pub(crate) const HEARTBEAT: Area = Area::new(309, 163, 5, 5);

/// Place of the words that say that power is limited.
pub(crate) const LIMITED: Area = Area::new(250, 62, 64, 15);

/// A number with a fixed place for each figure.
pub(crate) struct Field {
    /// Column behind the last figure.
    pub(crate) right: u16,
    /// Top of the figures.
    pub(crate) top: u16,
    pub(crate) font: &'static Font,
    /// Characters, sign and decimal point included; at most [`MOST_FIGURES`].
    pub(crate) figures: u8,
    /// Figures behind the decimal point.
    pub(crate) decimals: u8,
    /// Takes the number out of the view, in units of the last figure.
    pub(crate) number: fn(&View) -> Shown<i32>,
}

/// Most characters of a field.
pub(crate) const MOST_FIGURES: usize = 8;

impl Field {
    /// Returns the place of the character `figure`, counted from the right.
    pub(crate) const fn area_of(&self, figure: u16) -> Area {
        let (digit, decimals) = (self.font.digit as u16, self.decimals as u16);
        let point = self.font.point as u16;
        let (from_right, width) = if decimals == 0 || figure < decimals {
            ((figure + 1) * digit, digit)
        } else if figure == decimals {
            (figure * digit + point, point)
        } else {
            (figure * digit + point, digit)
        };
        Area::new(self.right - from_right, self.top - 1, width, self.font.cap as u16 + 2)
    }

    /// Returns the place of the whole field.
    pub(crate) const fn area(&self) -> Area {
        let first = self.area_of(self.figures as u16 - 1);
        Area::new(first.x, first.y, self.right - first.x, first.height)
    }
}

/// Returns the nearest whole number, halves away from zero.
pub(crate) const fn rounded(value: i32, divisor: i32) -> i32 {
    let half = divisor / 2;
    value.saturating_add(if value < 0 { -half } else { half }) / divisor
}

/// Every number but the speed.
pub(crate) static FIELDS: [Field; 12] = [
    Field {
        right: 60,
        top: 30,
        font: &fonts::FIGURE,
        figures: 3,
        decimals: 0,
        number: |view| view.soc_percent.map(i32::from),
    },
    Field {
        right: 294,
        top: 30,
        font: &fonts::FIGURE,
        figures: 4,
        decimals: 0,
        number: |view| view.power_hectowatts.map(|power| rounded(power, 10)),
    },
    Field {
        right: 48,
        top: 86,
        font: &fonts::VALUE,
        figures: 5,
        decimals: 1,
        number: |view| view.pack_decivolts,
    },
    Field {
        right: 48,
        top: 110,
        font: &fonts::VALUE,
        figures: 6,
        decimals: 1,
        number: |view| view.pack_deciamps,
    },
    Field {
        right: 300,
        top: 95,
        font: &fonts::VALUE,
        figures: 3,
        decimals: 0,
        number: |view| view.motor_celsius,
    },
    Field {
        right: 300,
        top: 131,
        font: &fonts::VALUE,
        figures: 3,
        decimals: 0,
        number: |view| view.inverter_celsius,
    },
    Field {
        right: 172,
        top: 173,
        font: &fonts::VALUE,
        figures: 6,
        decimals: 0,
        number: |view| view.motor_rpm,
    },
    Field {
        right: 38,
        top: 162,
        font: &fonts::SMALL,
        figures: 4,
        decimals: 2,
        number: |view| view.cell_millivolts.0.map(|value| rounded(value, 10)),
    },
    Field {
        right: 38,
        top: 176,
        font: &fonts::SMALL,
        figures: 4,
        decimals: 2,
        number: |view| view.cell_millivolts.1.map(|value| rounded(value, 10)),
    },
    Field {
        right: 61,
        top: 162,
        font: &fonts::SMALL,
        figures: 3,
        decimals: 0,
        number: |view| view.cell_celsius.0,
    },
    Field {
        right: 61,
        top: 176,
        font: &fonts::SMALL,
        figures: 3,
        decimals: 0,
        number: |view| view.cell_celsius.1,
    },
    Field {
        right: 295,
        top: 176,
        font: &fonts::SMALL,
        figures: 8,
        decimals: 1,
        number: |view| Shown::Value(view.odometer_hectometres.min(i32::MAX as u32) as i32),
    },
];

/// Which end of a label stands fast.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Align {
    Left,
    Centre,
    Right,
}

/// Fixed words.
pub(crate) struct Label {
    pub(crate) x: u16,
    /// Top of the capitals.
    pub(crate) top: u16,
    pub(crate) align: Align,
    pub(crate) text: Text,
    pub(crate) font: &'static Font,
    pub(crate) ink: Ink,
}

const fn label(x: u16, top: u16, align: Align, text: Text) -> Label {
    Label { x, top, align, text, font: &fonts::LABEL, ink: Ink::Secondary }
}

/// The words that are always there.
pub(crate) static LABELS: [Label; 15] = [
    label(63, 41, Align::Left, words::PERCENT),
    label(314, 41, Align::Right, words::KW),
    label(314, 81, Align::Right, words::MOTOR),
    label(314, 117, Align::Right, words::INVERTER),
    label(51, 89, Align::Left, words::VOLT),
    label(51, 113, Align::Left, words::AMP),
    label(314, 98, Align::Right, words::CELSIUS),
    label(314, 134, Align::Right, words::CELSIUS),
    label(160, 158, Align::Centre, words::KMH),
    label(176, 176, Align::Left, words::RPM),
    label(6, 148, Align::Left, words::CELLS),
    label(5, 163, Align::Left, words::HIGHEST),
    label(5, 177, Align::Left, words::LOWEST),
    label(305, 162, Align::Right, words::ODOMETER),
    label(314, 177, Align::Right, words::KM),
];

/// What is painted, beside the elements of a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Widget {
    Band,
    Stripe,
    Telltale(Telltale),
    Limited,
    Gear,
    Speed,
    Field(usize),
    Charge,
    Power,
    Heartbeat,
    Dial,
}

impl Widget {
    /// Returns whether every page has it; the rest is the main page's.
    pub(crate) const fn is_on_every_page(self) -> bool {
        matches!(self, Self::Band | Self::Stripe | Self::Telltale(_) | Self::Heartbeat)
    }
}

const fn place(widget: Widget) -> Area {
    match widget {
        Widget::Band => BAND,
        Widget::Stripe => STRIPE,
        Widget::Telltale(it) => telltale(it),
        Widget::Limited => LIMITED,
        Widget::Gear => GEAR,
        Widget::Speed => SPEED,
        Widget::Field(place) => FIELDS[place].area(),
        Widget::Charge => CHARGE_BAR,
        Widget::Power => POWER_BAR,
        Widget::Heartbeat => HEARTBEAT,
        Widget::Dial => DIAL,
    }
}

const SINGLE: [Widget; 9] = [
    Widget::Dial,
    Widget::Band,
    Widget::Stripe,
    Widget::Limited,
    Widget::Gear,
    Widget::Speed,
    Widget::Charge,
    Widget::Power,
    Widget::Heartbeat,
];

const WIDGET_COUNT: usize = SINGLE.len() + Telltale::ALL.len() + FIELDS.len();

/// Every widget but the labels, with its place, in the order of painting.
pub(crate) static WIDGETS: [(Widget, Area); WIDGET_COUNT] = {
    let mut widgets = [(Widget::Dial, DIAL); WIDGET_COUNT];
    let mut index = 0;
    while index < WIDGET_COUNT {
        let widget = if index < SINGLE.len() {
            SINGLE[index]
        } else if index < SINGLE.len() + Telltale::ALL.len() {
            Widget::Telltale(Telltale::ALL[index - SINGLE.len()])
        } else {
            Widget::Field(index - SINGLE.len() - Telltale::ALL.len())
        };
        widgets[index] = (widget, place(widget));
        index += 1;
    }
    widgets
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::label_area;
    use cluster::view::Language;
    extern crate std;

    #[test]
    fn a_cell_belongs_to_one_telltale_and_is_shared_with_at_most_one() {
        let cells = || Telltale::ALL.iter().filter(|it| matches!(it.place(), Place::Cell(..)));
        for host in cells() {
            assert_eq!(cells().filter(|other| other.place() == host.place()).count(), 1, "{host:?}");
            let guests = Telltale::ALL.iter().filter(|it| it.place() == Place::With(*host));
            assert!(guests.count() <= 1, "three take turns in the place of {host:?}");
        }
    }

    #[test]
    fn no_widget_lies_on_another_or_beyond_the_screen() {
        for language in [Language::Chinese, Language::English] {
            let mut places: std::vec::Vec<_> =
                WIDGETS.iter().map(|&(widget, place)| (Some(widget), place)).collect();
            places.extend(LABELS.iter().map(|label| (None, label_area(label, language))));
            places.extend(crate::pages::Kind::Main.places().iter().map(|place| (None, place.area)));
            for (index, (widget, place)) in places.iter().enumerate() {
                assert!(
                    place.right() <= crate::WIDTH && place.bottom() <= crate::HEIGHT,
                    "{widget:?} {place:?}"
                );
                for (other, there) in &places[index + 1..] {
                    // The dial is a ring: its own test is below. Two telltales may share a place: they take turns.
                    let take_turns = match (widget, other) {
                        (Some(Widget::Telltale(one)), Some(Widget::Telltale(two))) => {
                            two.place() == Place::With(*one) || one.place() == Place::With(*two)
                        }
                        _ => false,
                    };
                    if *widget != Some(Widget::Dial) && !take_turns {
                        assert_eq!(place.common(*there), None, "{widget:?} and {other:?}, {language:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn words_fit_their_places() {
        for text in [words::LIMITED.zh, words::LIMITED.en] {
            assert!(fonts::LABEL.width(text) <= LIMITED.width, "{text}");
        }
        assert!(fonts::MESSAGE.width(words::READY.zh) <= telltale(Telltale::Ready).width);
    }

    #[test]
    fn words_keep_clear_of_the_rings() {
        for language in [Language::Chinese, Language::English] {
            for label in &LABELS {
                let place = label_area(label, language);
                let middle = (f32::from(fonts::DIAL_CENTRE), f32::from(fonts::DIAL_TOP + fonts::DIAL_RADIUS));
                let (right, bottom) = (place.right(), place.bottom());
                for (x, y) in [(place.x, place.y), (right, place.y), (place.x, bottom), (right, bottom)] {
                    let distance = (f32::from(x) - middle.0).hypot(f32::from(y) - middle.1);
                    let below = f32::from(y) > middle.1 + 50.0;
                    assert!(below || !(82.0..98.0).contains(&distance), "{:?} at ({x}, {y})", label.text);
                }
            }
        }
    }

    #[test]
    fn every_word_has_its_glyphs() {
        for label in &LABELS {
            for character in label.text.zh.chars().chain(label.text.en.chars()) {
                assert!(label.font.find(character).is_some(), "{character:?}: run `cargo xtask fonts`");
            }
        }
        for character in words::LIMITED.zh.chars() {
            assert!(fonts::LABEL.find(character).is_some(), "{character:?}: run `cargo xtask fonts`");
        }
    }

    #[test]
    fn the_dials_parts_cover_every_pixel_of_their_angles() {
        let steps = fonts::DIAL_STEPS as usize / fonts::DIAL_PARTS[0].len();
        for (y, row) in (fonts::DIAL_TOP..).zip(&fonts::DIAL_ROWS) {
            let words = &fonts::DIAL_PIXELS[usize::from(row.start)..][..usize::from(row.length)];
            for (x, pixel) in (row.first..).zip(words).map(|(x, &word)| (x, fonts::DialPixel(word))) {
                if pixel.coverage() == 0 {
                    continue;
                }
                let mirror = (2 * fonts::DIAL_CENTRE - 1 - x, fonts::DIAL_STEPS - 1 - pixel.angle());
                for (x, angle) in [(x, pixel.angle()), mirror] {
                    let (left, top, width, height) =
                        fonts::DIAL_PARTS[pixel.ring()][usize::from(angle) / steps];
                    let part = Area::new(left, top, width, height);
                    assert!(part.meets(Area::new(x, y, 1, 1)), "({x}, {y}) at {angle} is outside {part:?}");
                }
            }
        }
    }

    #[test]
    fn the_speeds_figures_are_as_wide_as_two_of_its_parts() {
        assert_eq!(u16::from(fonts::SPEED.digit), 2 * SPEED_HALF);
        assert!(u16::from(fonts::SPEED.cap) + 2 <= SPEED.height);
    }
}
