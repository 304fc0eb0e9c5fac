//! The picture: a view turned into what is painted, and the painting of one row.
//!
//! Owns the step from numbers to characters, angles and lengths. Pixels are a function of the picture only, and the
//! picture is a function of the view only. Missing values: never seen = faint dashes, stale = a clock and dashes, not
//! valid = a cross and dashes; none of them looks like zero, and a dial or bar without a value has no pointer.

use crate::{
    element::Element,
    fonts::{self, CLOCK, CROSS, DASH, DialPixel, Font},
    layout::{self, Align, Area, FIELDS, Field, Label, MOST_FIGURES, Widget},
    pages::{self, Kind, MOST_ELEMENTS},
    scanline::Scanline,
    theme::{Ink, Palette, Ramp, mix},
    words,
};
use cluster::{
    FaultId, Named, Telltale, TelltaleColour, Telltales, View,
    view::{Language, Limp, Line, Text, Theme},
};
use protocol_core::model::{Severity, Shown};

/// Returns the text in a language.
pub(crate) const fn said(text: Text, language: Language) -> &'static str {
    match language {
        Language::Chinese => text.zh,
        Language::English => text.en,
    }
}

const BLANK: u8 = b' ';

/// The characters of a number, from the right, and their ink.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Figures<const COUNT: usize> {
    pub(crate) codes: [u8; COUNT],
    pub(crate) ink: Ink,
}

impl<const COUNT: usize> Figures<COUNT> {
    const EMPTY: Self = Self { codes: [BLANK; COUNT], ink: Ink::Primary };

    /// Writes a number into `count` characters of which the last `decimals` stand behind the point; what does not fit
    /// becomes the largest number that does.
    fn of(shown: Shown<i32>, count: usize, decimals: usize) -> Self {
        let count = count.min(COUNT);
        let mark = match shown {
            Shown::Value(value) => return Self::number(value, count, decimals),
            Shown::Never => None,
            Shown::Stale => Some(CLOCK),
            Shown::Invalid => Some(CROSS),
        };
        let mut figures = Self::EMPTY;
        figures.ink = if mark.is_some() { Ink::Secondary } else { Ink::Faint };
        // The point's place stays empty.
        let places = (0..count).filter(|&figure| decimals == 0 || figure != decimals);
        for (figure, code) in places.zip([DASH, DASH, mark.unwrap_or(BLANK)]) {
            figures.codes[figure] = code;
        }
        figures
    }

    fn number(value: i32, count: usize, decimals: usize) -> Self {
        let mut figures = Self::EMPTY;
        let places = count - usize::from(decimals > 0);
        let limit = |places: usize| 10_u32.saturating_pow(places as u32) - 1;
        let (mut rest, negative) = match value < 0 {
            true => (value.unsigned_abs().min(limit(places.saturating_sub(1))), true),
            false => (value.unsigned_abs().min(limit(places)), false),
        };
        let negative = negative && rest != 0;
        for figure in 0..count {
            if decimals > 0 && figure == decimals {
                figures.codes[figure] = b'.';
                continue;
            }
            figures.codes[figure] = b'0' + (rest % 10) as u8;
            rest /= 10;
            if rest == 0 && figure >= decimals + usize::from(decimals > 0) {
                if negative && figure + 1 < count {
                    figures.codes[figure + 1] = b'-';
                }
                break;
            }
        }
        figures
    }

    /// Returns how many characters there are.
    pub(crate) fn length(&self) -> usize {
        COUNT - self.codes.iter().rev().take_while(|&&code| code == BLANK).count()
    }
}

/// Most glyphs of the message's text.
const TEXT_GLYPHS: usize = 40;
/// Most glyphs of the message's code and number.
const TAIL_GLYPHS: usize = 16;
/// Most glyphs of the chip in the message line.
const CHIP_GLYPHS: usize = 8;
/// Space to the left and to the right of the chip's text, pixels.
const CHIP_MARGIN: u16 = 7;
/// Space between the message's text and its code, pixels.
const TAIL_GAP: u16 = 10;

/// A row of glyphs with its pen at a fixed place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Glyphs<const MOST: usize> {
    places: [u16; MOST],
    length: u8,
    width: u16,
}

impl<const MOST: usize> Glyphs<MOST> {
    const EMPTY: Self = Self { places: [0; MOST], length: 0, width: 0 };

    /// Appends a character unless it leads beyond `limit` pixels.
    fn push(&mut self, font: &Font, character: char, limit: u16) -> bool {
        let Some(place) = font.find(character).or_else(|| font.find('?')) else { return false };
        let advance = font.glyph(place).map_or(0, |glyph| u16::from(glyph.advance));
        let fits = usize::from(self.length) < MOST && self.width + advance <= limit;
        if fits {
            self.places[usize::from(self.length)] = place;
            self.length += 1;
            self.width += advance;
        }
        fits
    }

    /// Appends as much of `text` as fits.
    fn push_text(&mut self, font: &Font, text: &str, limit: u16) {
        let whole = font.width(text) + self.width <= limit;
        let room = if whole { limit } else { limit.saturating_sub(font.width("…")) };
        let cut = !text.chars().all(|character| self.push(font, character, room));
        if cut {
            self.push(font, '…', limit);
        }
    }

    /// Appends a number.
    fn push_number(&mut self, font: &Font, number: u16) {
        let figures = Figures::<5>::of(Shown::Value(i32::from(number)), 5, 0);
        for &code in figures.codes[..figures.length()].iter().rev() {
            self.push(font, char::from(code), u16::MAX);
        }
    }

    fn paint(&self, row: &mut Scanline, font: &Font, x: u16, top: u16, ramp: &Ramp) {
        let mut pen = x as i16;
        for &place in &self.places[..usize::from(self.length)] {
            let Some(glyph) = font.glyph(place) else { continue };
            if let Some(coverage) = font.coverage(glyph, pen, top as i16, row.y as i16) {
                row.cover(&coverage, ramp);
            }
            pen += i16::from(glyph.advance);
        }
    }
}

/// The message line, ready to paint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Message {
    severity: Severity,
    text: Glyphs<TEXT_GLYPHS>,
    tail: Glyphs<TAIL_GLYPHS>,
    /// What stands at the line's end whichever line has its turn.
    chip: Glyphs<CHIP_GLYPHS>,
}

impl Message {
    /// Returns what stands in the place of the line: a fault that is over looks like information, after a word for that.
    /// Below a STOP that has taken the page over stands what is milder.
    fn of_view(view: &View) -> Option<Self> {
        let below = view.below.filter(|_| view.alarm.is_some() || view.says_below);
        let unseen = view.unseen.filter(|_| view.says_unseen);
        let (line, before) = match (below, unseen) {
            (Some(below), _) => (below, ""),
            (None, Some(unseen)) => {
                (Line { severity: Severity::None, ..unseen }, said(words::WAS, view.language))
            }
            (None, None) => (view.line?, ""),
        };
        Some(Self::of(&line, before, chip(view), view.language))
    }

    fn of(line: &Line, before: &'static str, chip: Glyphs<CHIP_GLYPHS>, language: Language) -> Self {
        let font = &fonts::MESSAGE;
        let mut code = Glyphs::EMPTY;
        if let Some(number) = line.code {
            code.push_number(font, number);
        }
        let mut tail = code;
        if line.count > 1 {
            tail.push_text(font, if line.code.is_some() { "   " } else { "" }, u16::MAX);
            tail.push_number(font, u16::from(line.position));
            tail.push(font, '/', u16::MAX);
            tail.push_number(font, u16::from(line.count));
        }
        let words = said(line.text, language);
        let room = |tail: &Glyphs<TAIL_GLYPHS>| {
            let gap = if tail.length == 0 { 0 } else { TAIL_GAP };
            band_right(chip.width) - layout::BAND_LEFT - tail.width - gap
        };
        // A text that is not cut comes before the count of turns.
        let width = font.width(before) + font.width(words);
        if (room(&tail) + 1..=room(&code)).contains(&width) {
            tail = code;
        }
        let mut text = Glyphs::EMPTY;
        text.push_text(font, before, room(&tail));
        text.push_text(font, words, room(&tail));
        Self { severity: line.severity, text, tail, chip }
    }
}

/// Returns the chip of the message line: seconds until the battery opens the high-voltage circuit (BUS-68), or the
/// largest current in limp mode (BUS-R081).
fn chip(view: &View) -> Glyphs<CHIP_GLYPHS> {
    let font = &fonts::MESSAGE;
    let mut chip = Glyphs::EMPTY;
    let (start, number, unit) = match (view.hv_off_s, view.limp) {
        (Some(seconds), _) => ("HV ", u16::from(seconds), " s"),
        (None, Some(Limp { limit_deciamps: Some(limit) })) => {
            ("≤", u16::try_from(limit / 10).unwrap_or(u16::MAX), " A")
        }
        _ => return chip,
    };
    chip.push_text(font, start, u16::MAX);
    chip.push_number(font, number);
    chip.push_text(font, unit, u16::MAX);
    chip
}

/// Returns the column behind the message's code and number, beside a chip with a text of this width.
const fn band_right(chip: u16) -> u16 {
    if chip == 0 { layout::BAND_RIGHT } else { layout::BAND_RIGHT - chip - 2 * CHIP_MARGIN }
}

/// Returns the pixels that a text takes in the message line, and the pixels that are there beside `code` and a number
/// of two figures: texts that are wider are cut and end with "…".
///
/// Vehicles' tests hold their texts against this.
pub fn message_room(text: &str, code: Option<u16>) -> (u16, u16) {
    let named = Named { code, ..Named::of(FaultId::VehicleCode) };
    let line = Line { named, severity: Severity::Stop, text: Text::default(), code, position: 1, count: 9 };
    let tail = Message::of(&line, "", Glyphs::EMPTY, Language::Chinese).tail.width;
    (fonts::MESSAGE.width(text), layout::BAND_RIGHT - layout::BAND_LEFT - tail - TAIL_GAP)
}

/// Returns whether the message line has a glyph for a character.
pub fn has_glyph(character: char) -> bool {
    fonts::MESSAGE.find(character).is_some()
}

/// Half the width of a dial's pointer in angle steps.
const POINTER: i32 = 5;

/// A pointer of the dial: its angle step, if there is a value.
pub(crate) type Angle = Option<u16>;

fn angle(value: Option<u32>, full_scale: u32) -> Angle {
    let room = u32::from(fonts::DIAL_STEPS) - 1 - 2 * POINTER as u32;
    value.map(|value| (POINTER as u32 + value.min(full_scale) * room / full_scale) as u16)
}

/// Returns the first and the last angle step that look different under another pointer.
pub(crate) fn turned(from: Angle, to: Angle) -> Option<(u16, u16)> {
    if from == to {
        return None;
    }
    // Two steps more than the pointer is wide, for its soft edge.
    let reach = POINTER as u16 + 2;
    let (from, to) = (from.unwrap_or(0), to.unwrap_or(0));
    let last = from.max(to).saturating_add(reach).min(fonts::DIAL_STEPS - 1);
    Some((from.min(to).saturating_sub(reach), last))
}

/// Returns the square root, rounded down.
fn root(value: u32) -> u32 {
    let (mut low, mut bit) = (0_u32, 1 << 15);
    while bit != 0 {
        if (low + bit) * (low + bit) <= value {
            low += bit;
        }
        bit >>= 1;
    }
    low
}

/// Everything that is painted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Picture {
    pub(crate) theme: Theme,
    pub(crate) language: Language,
    pub(crate) message: Option<Message>,
    pub(crate) severity: Severity,
    /// Those that are seen: of two in one place the one whose turn it is.
    pub(crate) telltales: Telltales,
    pub(crate) is_power_limited: bool,
    pub(crate) gear: u8,
    pub(crate) speed: Figures<3>,
    pub(crate) fields: [Figures<MOST_FIGURES>; FIELDS.len()],
    /// Pixels of the bar that are lit.
    pub(crate) charge: Option<u16>,
    pub(crate) is_charge_low: bool,
    /// Pixels of the bar that are lit, negative = to the left of zero.
    pub(crate) power: Option<i16>,
    pub(crate) heartbeat: bool,
    pub(crate) rings: [Angle; 2],
    pub(crate) kind: Kind,
    pub(crate) elements: [Element; MOST_ELEMENTS],
}

impl Picture {
    /// The picture of a view in which everything is missing.
    pub(crate) const EMPTY: Self = Self {
        theme: Theme::Night,
        language: Language::Chinese,
        message: None,
        severity: Severity::None,
        telltales: Telltales::NONE,
        is_power_limited: false,
        gear: BLANK,
        speed: Figures::EMPTY,
        fields: [Figures::EMPTY; FIELDS.len()],
        charge: None,
        is_charge_low: false,
        power: None,
        heartbeat: false,
        rings: [None; 2],
        kind: Kind::Main,
        elements: [Element::BLANK; MOST_ELEMENTS],
    };

    /// Works out what is painted for a view.
    pub(crate) fn of(view: &View) -> Self {
        let every = Self {
            theme: view.theme,
            language: view.language,
            message: Message::of_view(view),
            severity: view.severity,
            telltales: view.telltales.in_turn(view.heartbeat),
            heartbeat: view.heartbeat,
            kind: Kind::of(view),
            elements: pages::elements(view),
            ..Self::EMPTY
        };
        // What a page does not show must not be sent when it changes.
        if every.kind == Kind::Main { every.with_dial(view) } else { every }
    }

    /// Returns the ground of a row: that of a STOP where one has taken the page over.
    pub(crate) fn ground(&self, y: u16) -> u16 {
        let palette = Palette::of(self.theme);
        let is_page = layout::PAGE.y <= y && y < layout::PAGE.bottom();
        if self.kind == Kind::Alarm && is_page {
            palette.bands[Severity::Stop as usize]
        } else {
            palette.ground
        }
    }

    /// Adds what only the main page has.
    fn with_dial(self, view: &View) -> Self {
        let bar = u32::from(layout::CHARGE_BAR.width);
        let mut fields = [Figures::EMPTY; FIELDS.len()];
        for (figures, field) in fields.iter_mut().zip(&FIELDS) {
            *figures =
                Figures::of((field.number)(view), usize::from(field.figures), usize::from(field.decimals));
        }
        Self {
            is_power_limited: view.is_power_limited,
            gear: view.gear.map_or(BLANK, pages::letter),
            speed: Figures::of(view.speed_kmh.map(i32::from), 3, 0),
            fields,
            charge: view.soc_percent.value().map(|percent| (u32::from(percent.min(100)) * bar / 100) as u16),
            is_charge_low: view.is_charge_low,
            power: view.power_hectowatts.value().map(power_reach),
            rings: [
                angle(view.speed_kmh.value().map(u32::from), layout::DIAL_KMH),
                angle(view.motor_rpm.value().map(i32::unsigned_abs), layout::DIAL_RPM),
            ],
            ..self
        }
    }

    /// Returns the place of the speed's character `figure`, counted from the right.
    pub(crate) fn speed_figure(&self, figure: usize) -> Area {
        speed_figure(self.speed.length(), figure)
    }

    /// Paints a widget's part of a row that is ground so far.
    pub(crate) fn paint(&self, widget: Widget, row: &mut Scanline) {
        let palette = Palette::of(self.theme);
        match widget {
            Widget::Band => self.paint_band(row, palette),
            Widget::Stripe => {
                row.fill(0, crate::WIDTH, palette.stripes[self.severity as usize]);
            }
            Widget::Telltale(telltale) => self.paint_telltale(telltale, row, palette),
            Widget::Limited => {
                if self.is_power_limited {
                    let place = layout::LIMITED;
                    let font = &fonts::LABEL;
                    let text = said(words::LIMITED, self.language);
                    paint_text(
                        row,
                        font,
                        text,
                        place.right(),
                        place.y + 3,
                        Align::Right,
                        palette.ramp(Ink::Yellow),
                    );
                }
            }
            Widget::Gear => {
                let font = &fonts::GEAR;
                let area = layout::GEAR;
                paint_character(
                    row,
                    font,
                    self.gear,
                    area.x + area.width / 2,
                    layout::GEAR_TOP,
                    palette.ramp(Ink::Accent),
                );
            }
            Widget::Speed => {
                for figure in 0..self.speed.length() {
                    let area = self.speed_figure(figure);
                    if !row.meets(area.x, area.width) {
                        continue;
                    }
                    let middle = area.x + area.width / 2;
                    let ramp = palette.ramp(self.speed.ink);
                    paint_character(
                        row,
                        &fonts::SPEED,
                        self.speed.codes[figure],
                        middle,
                        layout::SPEED_TOP,
                        ramp,
                    );
                }
            }
            Widget::Field(place) => {
                let (field, figures) = (&FIELDS[place], &self.fields[place]);
                paint_field(row, field, figures, palette.ramp(figures.ink));
            }
            Widget::Charge => self.paint_charge(row, palette),
            Widget::Power => self.paint_power(row, palette),
            Widget::Heartbeat => {
                let Area { x, y, width, height } = layout::HEARTBEAT;
                // A disc without its corners.
                let corner = u16::from(row.y == y || row.y + 1 == y + height);
                let ink = if self.heartbeat { palette.colour(Ink::Accent) } else { palette.track };
                row.fill(x + corner, width - 2 * corner, ink);
            }
            Widget::Dial => self.paint_dial(row, palette),
        }
    }

    /// Paints a label's part of a row that is ground so far.
    pub(crate) fn paint_label(&self, label: &Label, row: &mut Scanline) {
        let Label { x, top, align, text, font, ink } = *label;
        let ramp = Palette::of(self.theme).ramp(ink);
        paint_text(row, font, said(text, self.language), x, top, align, ramp);
    }

    /// Paints an element's part of a row that is ground so far.
    pub(crate) fn paint_element(&self, place: usize, row: &mut Scanline) {
        if let (Some(at), Some(element)) = (self.kind.places().get(place), self.elements.get(place)) {
            at.paint(element, row, Palette::of(self.theme));
        }
    }

    fn paint_band(&self, row: &mut Scanline, palette: &Palette) {
        let Some(message) = &self.message else { return };
        let place = message.severity as usize;
        let ramp = palette.ramp([Ink::OnInformation, Ink::OnWarn, Ink::OnDerate, Ink::OnStop][place]);
        row.fill(layout::BAND.x, layout::BAND.width, palette.bands[place]);
        message.text.paint(row, &fonts::MESSAGE, layout::BAND_LEFT, layout::BAND_TEXT_TOP, ramp);
        let tail = band_right(message.chip.width) - message.tail.width;
        message.tail.paint(row, &fonts::MESSAGE, tail, layout::BAND_TEXT_TOP, ramp);
        if message.chip.width != 0 {
            let left = layout::BAND.right() - message.chip.width - 2 * CHIP_MARGIN;
            row.fill(left, layout::BAND.right() - left, ramp[15]);
            let ramp =
                palette.ramp([Ink::ChipInformation, Ink::ChipWarn, Ink::ChipDerate, Ink::ChipStop][place]);
            message.chip.paint(row, &fonts::MESSAGE, left + CHIP_MARGIN, layout::BAND_TEXT_TOP, ramp);
        }
    }

    fn paint_telltale(&self, telltale: Telltale, row: &mut Scanline, palette: &Palette) {
        if !self.telltales.is_lit(telltale) {
            return;
        }
        let ramp = palette.ramp(match telltale.colour() {
            TelltaleColour::Red => Ink::Red,
            TelltaleColour::Yellow => Ink::Yellow,
            TelltaleColour::Green => Ink::Green,
            TelltaleColour::Blue => Ink::Blue,
        });
        let area = layout::telltale(telltale);
        if matches!(telltale, Telltale::Ready) {
            let middle = area.x + area.width / 2;
            let text = said(words::READY, self.language);
            paint_text(row, &fonts::MESSAGE, text, middle, area.y + 5, Align::Centre, ramp);
        } else if let Some(coverage) = fonts::icon_coverage(telltale as usize, area.x as i16, row.y - area.y)
        {
            row.cover(&coverage, ramp);
        }
    }

    fn paint_charge(&self, row: &mut Scanline, palette: &Palette) {
        let Area { x, width, .. } = layout::CHARGE_BAR;
        let Some(lit) = self.charge else { return dotted(row, x, width, palette.track) };
        let ink = if self.is_charge_low { Ink::Yellow } else { Ink::Accent };
        row.fill(x, lit, palette.colour(ink));
        row.fill(x + lit, width - lit, palette.track);
    }

    fn paint_power(&self, row: &mut Scanline, palette: &Palette) {
        let (Area { x, width, .. }, zero) = (layout::POWER_BAR, layout::POWER_ZERO);
        let Some(power) = self.power else { return dotted(row, x, width, palette.track) };
        row.fill(x, width, palette.track);
        let lit = power.unsigned_abs();
        if power < 0 {
            row.fill(zero - lit, lit, palette.colour(Ink::Green));
        } else {
            row.fill(zero, lit, palette.colour(Ink::Accent));
        }
        row.fill(zero - 1, 2, palette.pointer);
    }

    fn paint_dial(&self, row: &mut Scanline, palette: &Palette) {
        let Some(line) = fonts::DIAL_ROWS.get(usize::from(row.y.wrapping_sub(fonts::DIAL_TOP))) else {
            return;
        };
        let start = usize::from(line.start);
        let Some(run) = fonts::DIAL_PIXELS.get(start..start + usize::from(line.length)) else { return };
        let (pixels, skipped) = row.cut(line.first as i16, line.length);
        for (pixel, &word) in pixels.iter_mut().zip(run.iter().skip(skipped)) {
            let at = DialPixel(word);
            self.paint_dial_pixel(pixel, at, at.angle(), palette);
        }
        let mirrored = 2 * fonts::DIAL_CENTRE - line.first - line.length;
        let (pixels, skipped) = row.cut(mirrored as i16, line.length);
        for (pixel, &word) in pixels.iter_mut().zip(run.iter().rev().skip(skipped)) {
            let at = DialPixel(word);
            self.paint_dial_pixel(pixel, at, fonts::DIAL_STEPS - 1 - at.angle(), palette);
        }
    }

    #[inline(always)]
    fn paint_dial_pixel(&self, pixel: &mut u16, at: DialPixel, angle: u16, palette: &Palette) {
        let coverage = at.coverage();
        if coverage == 0 {
            return;
        }
        let ring = at.ring();
        let mut colour = palette.track;
        if let Some(pointer) = self.rings[ring] {
            let ahead = i32::from(angle) - i32::from(pointer);
            if ahead < 0 {
                colour = palette.rings[ring][usize::from(angle >> 5 & 31)];
            }
            // One pixel is about two and a half angle steps wide.
            let tip = (POINTER - ahead.abs()) * 6 + 8;
            if tip > 0 {
                colour = mix(colour, palette.pointer, tip.min(15) as u16);
            }
        }
        *pixel = if coverage == 15 { colour } else { mix(*pixel, colour, coverage) };
    }
}

/// Returns the place of character `figure`, from the right, of a speed of `length` characters.
pub(crate) fn speed_figure(length: usize, figure: usize) -> Area {
    let right = fonts::DIAL_CENTRE + length as u16 * layout::SPEED_HALF;
    let x = right - (figure as u16 + 1) * 2 * layout::SPEED_HALF;
    Area::new(x, layout::SPEED.y, 2 * layout::SPEED_HALF, layout::SPEED.height)
}

/// Returns the lit pixels of the power bar for a power in 0.1 kW.
///
/// The square root is drawn: manoeuvring a car and climbing with a bus both move the bar visibly.
fn power_reach(power: i32) -> i16 {
    let scaled = |limit: u32| {
        let square = u64::from(power.unsigned_abs()) * u64::from(layout::POWER_REACH * layout::POWER_REACH);
        root((square / u64::from(layout::POWER_FULL)).min(u64::from(limit * limit)) as u32)
    };
    if power < 0 {
        -(scaled(u32::from(layout::POWER_ZERO - layout::POWER_BAR.x)) as i16)
    } else {
        scaled(layout::POWER_REACH) as i16
    }
}

/// Paints the track of a bar that has no value.
fn dotted(row: &mut Scanline, x: u16, width: u16, ink: u16) {
    for dot in (x..x + width).step_by(4) {
        row.fill(dot, 2.min(x + width - dot), ink);
    }
}

fn paint_field(row: &mut Scanline, field: &Field, figures: &Figures<MOST_FIGURES>, ramp: &Ramp) {
    for (figure, &code) in figures.codes.iter().enumerate().take(usize::from(field.figures)) {
        let area = field.area_of(figure as u16);
        if code == BLANK || !row.meets(area.x, area.width) {
            continue;
        }
        let glyph = field.font.find(char::from(code)).and_then(|place| field.font.glyph(place));
        let coverage =
            glyph.and_then(|glyph| field.font.coverage(glyph, area.x as i16, field.top as i16, row.y as i16));
        if let Some(coverage) = coverage {
            row.cover(&coverage, ramp);
        }
    }
}

/// Paints one character around a middle column.
fn paint_character(row: &mut Scanline, font: &Font, code: u8, middle: u16, top: u16, ramp: &Ramp) {
    let Some(glyph) = font.find(char::from(code)).and_then(|place| font.glyph(place)) else { return };
    let x = middle as i16 - i16::from(glyph.advance) / 2;
    if let Some(coverage) = font.coverage(glyph, x, top as i16, row.y as i16) {
        row.cover(&coverage, ramp);
    }
}

fn paint_text(row: &mut Scanline, font: &Font, text: &str, x: u16, top: u16, align: Align, ramp: &Ramp) {
    let mut pen = x as i16
        - match align {
            Align::Left => 0,
            Align::Centre => font.width(text) as i16 / 2,
            Align::Right => font.width(text) as i16,
        };
    for glyph in text.chars().filter_map(|character| font.glyph(font.find(character)?)) {
        if let Some(coverage) = font.coverage(glyph, pen, top as i16, row.y as i16) {
            row.cover(&coverage, ramp);
        }
        pen += i16::from(glyph.advance);
    }
}

/// Returns the place of a label in a language.
pub(crate) fn label_area(label: &Label, language: Language) -> Area {
    let text = said(label.text, language);
    let (width, (first, rows)) = (label.font.width(text), label.font.inked_rows(text));
    let x = match label.align {
        Align::Left => label.x,
        Align::Centre => label.x - width / 2,
        Align::Right => label.x - width,
    };
    Area::new(x, label.top.saturating_add_signed(first), width, rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use protocol_core::model::Gear;
    use protocol_core::vehicle::NO_VEHICLE;
    extern crate std;
    use std::string::String;

    /// Returns the characters from left to right.
    fn read<const COUNT: usize>(figures: Figures<COUNT>) -> String {
        figures.codes.iter().rev().map(|&code| char::from(code)).collect::<String>().trim_start().into()
    }

    fn number(value: i32, count: usize, decimals: usize) -> String {
        read(Figures::<8>::of(Shown::Value(value), count, decimals))
    }

    /// A line that says it is time to stop.
    fn line(named: Named) -> Line {
        Line::of(named, Severity::Stop, &NO_VEHICLE)
    }

    #[test]
    fn numbers_have_their_decimals_and_no_leading_zeros() {
        for (value, count, decimals, expected) in [
            (0, 3, 0, "0"),
            (7, 3, 0, "7"),
            (100, 3, 0, "100"),
            (-9, 3, 0, "-9"),
            (0, 5, 1, "0.0"),
            (4, 5, 1, "0.4"),
            (-4, 6, 1, "-0.4"),
            (5372, 5, 1, "537.2"),
            (-12_000, 6, 1, "-999.9"),
            (331, 4, 2, "3.31"),
            (9, 4, 2, "0.09"),
            (481_237, 8, 1, "48123.7"),
        ] {
            assert_eq!(number(value, count, decimals), expected, "{value} in {count} count");
        }
    }

    #[test]
    fn numbers_beyond_their_cells_become_the_largest_that_fits() {
        assert_eq!(number(1000, 3, 0), "999");
        assert_eq!(number(-100, 3, 0), "-99");
        assert_eq!(number(i32::MIN, 6, 0), "-99999");
        assert_eq!(number(i32::MAX, 8, 1), "999999.9");
    }

    #[test]
    fn each_kind_of_missing_has_its_own_marks_and_no_digit() {
        let of = |shown| Figures::<8>::of(shown, 4, 2);
        assert_eq!(read(of(Shown::Never)).as_bytes(), [DASH, DASH]);
        // The point's cell stays empty, between mark and dashes.
        assert_eq!(read(of(Shown::Stale)).as_bytes(), [CLOCK, b' ', DASH, DASH]);
        assert_eq!(read(of(Shown::Invalid)).as_bytes(), [CROSS, b' ', DASH, DASH]);
        assert_ne!(of(Shown::Never).ink, of(Shown::Stale).ink);
    }

    /// A colour that nothing is painted in.
    const UNPAINTED: u16 = 1;

    /// Returns whether a widget paints outside its place when nothing cuts it: beside it, or also above and below.
    fn leaves_its_place(picture: &Picture, widget: Widget, place: Area) -> bool {
        // These fill the rows they are asked for.
        let fills = matches!(
            widget,
            Widget::Band
                | Widget::Stripe
                | Widget::Telltale(_)
                | Widget::Charge
                | Widget::Power
                | Widget::Heartbeat
                | Widget::Dial
        );
        let rows = if fills { place.y..place.bottom() } else { 0..crate::HEIGHT };
        rows.into_iter().any(|y| {
            let mut pixels = [UNPAINTED; crate::WIDTH as usize];
            picture.paint(widget, &mut Scanline { y, left: 0, pixels: &mut pixels });
            let is_inside =
                |x| (place.x..place.right()).contains(&x) && (place.y..place.bottom()).contains(&y);
            (0_u16..).zip(pixels).any(|(x, pixel)| pixel != UNPAINTED && !is_inside(x))
        })
    }

    #[test]
    fn every_widget_has_room_for_the_ends_of_its_value() {
        let powers = (0..10).flat_map(|figures| [10_i32.pow(figures) - 1, 10_i32.pow(figures)]);
        let values = powers.flat_map(|value| [value, -value]).chain([i32::MIN, i32::MAX]).map(Shown::Value);
        let gears = Gear::ALL.iter().copied();
        let mut gears = gears.cycle();
        for shown in values.chain([Shown::Never, Shown::Stale, Shown::Invalid]) {
            let small = |most: i32| shown.map(|value| value.clamp(0, most));
            for language in [Language::Chinese, Language::English] {
                let view = View {
                    language,
                    speed_kmh: small(0xFFFF).map(|value| value as u16),
                    gear: gears.next(),
                    soc_percent: small(255).map(|value| value as u8),
                    pack_decivolts: shown,
                    pack_deciamps: shown,
                    power_hectowatts: shown,
                    motor_rpm: shown,
                    motor_celsius: shown,
                    inverter_celsius: shown,
                    cell_millivolts: (shown, shown),
                    cell_celsius: (shown, shown),
                    odometer_hectometres: small(i32::MAX).value().map_or(u32::MAX, |value| value as u32),
                    telltales: Telltales::ALL,
                    is_power_limited: true,
                    limp: Some(Limp { limit_deciamps: shown.value() }),
                    line: Some(Line {
                        code: Some(u16::MAX),
                        position: 99,
                        count: 99,
                        ..line(Named::of(FaultId::Limp))
                    }),
                    ..View::default()
                };
                let picture = Picture::of(&view);
                for &(widget, place) in &layout::WIDGETS {
                    assert!(
                        !leaves_its_place(&picture, widget, place),
                        "{widget:?} with {shown:?}, {language:?}: part of it is cut"
                    );
                }
            }
        }
    }

    #[test]
    fn bus_r020_the_speed_pointer_moves_with_every_kilometre_per_hour() {
        let angles: std::vec::Vec<_> =
            (0..=layout::DIAL_KMH).map(|kmh| angle(Some(kmh), layout::DIAL_KMH)).collect();
        assert!(angles.windows(2).all(|pair| pair[0] < pair[1]));
        assert_eq!(angle(Some(400), layout::DIAL_KMH), angles[180]);
        assert_eq!(angle(None, layout::DIAL_KMH), None);
    }

    #[test]
    fn the_root_is_the_largest_whole_number_whose_square_fits() {
        for value in (0..70_000).chain([u32::MAX, u32::MAX - 1, 0xFFFE_0001, 0xFFFE_0000]) {
            let root = u64::from(root(value));
            assert!(root * root <= value.into() && (root + 1) * (root + 1) > value.into(), "{value}: {root}");
        }
    }

    #[test]
    fn the_power_bar_ends_inside_its_track_and_regeneration_goes_left() {
        for power in [0, 1, 9, 400, 2_000, 5_000, i32::MAX] {
            assert!((0..=layout::POWER_REACH as i16).contains(&power_reach(power)), "{power}");
            let regeneration = -power_reach(-power);
            assert!(
                (0..=(layout::POWER_ZERO - layout::POWER_BAR.x) as i16).contains(&regeneration),
                "-{power}"
            );
        }
        assert!(power_reach(-100) < 0);
        assert_eq!(power_reach(i32::MIN), -22);
    }

    #[test]
    fn a_text_that_is_too_long_ends_with_dots_and_leaves_the_code_alone() {
        let long = "W".repeat(60);
        let text: &'static str = std::boxed::Box::leak(long.into_boxed_str());
        let line = Line {
            text: Text { zh: text, en: text },
            code: Some(65_535),
            position: 12,
            count: 12,
            ..line(Named::of(FaultId::VehicleCode))
        };
        let message = Message::of(&line, "", Glyphs::EMPTY, Language::English);
        let last = message.text.places[usize::from(message.text.length) - 1];
        assert_eq!(Some(last), fonts::MESSAGE.find('…'));
        let room = layout::BAND_RIGHT - layout::BAND_LEFT;
        assert!(message.text.width + TAIL_GAP + message.tail.width <= room);
    }

    #[test]
    fn what_the_chip_belongs_to_is_whole_beside_it() {
        let counting = View { hv_off_s: Some(35), ..View::default() };
        let limping = View { limp: Some(Limp { limit_deciamps: Some(600) }), ..View::default() };
        let lines = [
            (counting, Named::of(FaultId::HvOff)),
            (counting, Named { stage: 1, ..Named::of(FaultId::HvOff) }),
            (limping, Named::of(FaultId::Limp)),
        ];
        for (view, named) in lines {
            for language in [Language::Chinese, Language::English] {
                let line = Line { position: 3, count: 12, ..line(named) };
                let message = Message::of(&line, "", chip(&view), language);
                assert!(message.chip.width > 0);
                let length = said(line.text, language).chars().count();
                assert_eq!(usize::from(message.text.length), length, "{:?} is cut", line.text);
            }
        }
    }

    #[test]
    fn the_chip_counts_seconds_before_it_names_a_limit() {
        let limp = Some(Limp { limit_deciamps: Some(547) });
        let glyphs = |text: &str| {
            let mut glyphs = Glyphs::EMPTY;
            glyphs.push_text(&fonts::MESSAGE, text, u16::MAX);
            glyphs
        };
        assert_eq!(chip(&View { limp, ..View::default() }), glyphs("≤54 A"));
        assert_eq!(chip(&View { limp, hv_off_s: Some(9), ..View::default() }), glyphs("HV 9 s"));
        let unknown = Some(Limp { limit_deciamps: None });
        assert_eq!(chip(&View { limp: unknown, ..View::default() }).length, 0);
    }
}
