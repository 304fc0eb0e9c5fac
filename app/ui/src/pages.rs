//! The pages but the dial: which elements each has, where they stand and what is in them.
//!
//! Owns a table of places for each kind of page and the step from a view to its elements. Beside them every page keeps the
//! lamps, the stripe, the message line and the proof of life; every page but the main one has gear and speed in its
//! head.
//! Source: BUS-R033, R038, R060, R067, R120, R124, R126, R143.

use crate::{
    element::{Content, Element, Place, Short, ink_of},
    fonts,
    layout::{Align, Area},
    picture::said,
    theme::Ink,
    words,
};
use cluster::{
    Page, Trip, View,
    page::{Chapter, Count, Item},
    view::{Charging, Journey, Language, Line, List, Listed, Range, Sheet, Text},
};
use protocol_core::model::{Gear, Shown};
use protocol_core::states::Confinement;

/// Pages with the same places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// The dial, and one element for the range.
    Main,
    /// Six large numbers.
    Grid,
    /// Four rows of two lines.
    List,
    /// Two columns of labels and values.
    Table,
    /// Four values and where they are.
    Extremes,
    /// What a STOP is, what to do, and how long there is.
    Alarm,
}

impl Kind {
    pub(crate) const fn of(view: &View) -> Self {
        match &view.page {
            _ if view.alarm.is_some() => Self::Alarm,
            Page::Main => Self::Main,
            Page::Trip(_) | Page::Energy => Self::Grid,
            Page::Faults(_) | Page::History(_) => Self::List,
            Page::Technic(Sheet { chapter: Chapter::Extremes, .. }) => Self::Extremes,
            Page::Technic(_) => Self::Table,
        }
    }

    /// Returns the places of its elements.
    pub(crate) const fn places(self) -> &'static [Place] {
        match self {
            Self::Main => &MAIN,
            Self::Grid => &GRID,
            Self::List => &LIST,
            Self::Table => &TABLE,
            Self::Extremes => &EXTREMES,
            Self::Alarm => &ALARM,
        }
    }
}

/// Most elements of a page.
pub(crate) const MOST_ELEMENTS: usize = TABLE.len();

/// Margins of the pages: the proof of life stands to the right.
const LEFT: u16 = 10;
const RIGHT: u16 = 304;
/// First column of the right half of a table.
const MIDDLE: u16 = 170;

/// Elements of the head: title, part, gear, speed, bar.
const HEAD: usize = 5;
const BAR: Area = Area::new(LEFT, 53, RIGHT - LEFT, 3);

const BLANK: Place = Place::new(Area::new(0, 0, 0, 0), 0, &fonts::LABEL, Align::Left);

/// Returns places of which the first are the head's.
const fn headed<const COUNT: usize>() -> [Place; COUNT] {
    let mut places = [const { BLANK }; COUNT];
    places[0] = Place::new(Area::new(LEFT, 30, 144, 22), 35, &fonts::MESSAGE, Align::Left);
    places[1] = Place::new(Area::new(154, 35, 38, 14), 38, &fonts::LABEL, Align::Right);
    places[2] = Place::new(Area::new(202, 26, 20, 24), 26, &fonts::GEAR, Align::Centre);
    places[3] = Place::new(Area::new(228, 26, RIGHT - 228, 25), 27, &fonts::FIGURE, Align::Right);
    places[4] = Place::new(BAR, 0, &fonts::LABEL, Align::Left);
    places
}

/// Its figures end where those of voltage and current do.
const RANGE: Area = Area::new(6, 64, 62, 16);
static MAIN: [Place; 1] = [Place::new(RANGE, 65, &fonts::VALUE, Align::Right)];

/// Large numbers with a label each, row by row.
const FIGURES: usize = 6;
const FIGURE_WIDTH: u16 = 144;
static GRID: [Place; HEAD + 2 * FIGURES] = {
    let mut places = headed();
    let mut figure = 0;
    while figure < FIGURES {
        let x = if figure % 2 == 0 { LEFT } else { RIGHT - FIGURE_WIDTH };
        let y = 59 + 43 * (figure / 2) as u16;
        places[HEAD + 2 * figure] =
            Place::new(Area::new(x, y, FIGURE_WIDTH, 16), y + 4, &fonts::LABEL, Align::Left);
        let number = Area::new(x, y + 17, FIGURE_WIDTH, 25);
        places[HEAD + 2 * figure + 1] = Place::new(number, y + 18, &fonts::FIGURE, Align::Left);
        figure += 1;
    }
    places
};

/// Where the numbers of the figures stand: each has the same room.
const NUMBER: &Place = &GRID[HEAD + 1];

/// Rows of a severity's mark, a text with its code, and when it came.
const ROWS: usize = cluster::page::ROWS;
static LIST: [Place; HEAD + 3 * ROWS] = {
    let mut places = headed();
    let mut row = 0;
    while row < ROWS {
        let y = 59 + 32 * row as u16;
        let (x, width) = (LEFT + 11, RIGHT - LEFT - 11);
        let place = HEAD + 3 * row;
        places[place] = Place::new(Area::new(LEFT, y + 1, 4, 29), 0, &fonts::LABEL, Align::Left);
        places[place + 1] = Place::new(Area::new(x, y, width, 19), y + 3, &fonts::MESSAGE, Align::Left);
        places[place + 2] = Place::new(Area::new(x, y + 19, width, 12), y + 21, &fonts::LABEL, Align::Left);
        row += 1;
    }
    places
};

/// Labels and values, column by column.
const LINES: usize = 5;
const LABEL_WIDTH: u16 = 66;
const VALUE_WIDTH: u16 = RIGHT - MIDDLE - LABEL_WIDTH;
static TABLE: [Place; HEAD + 4 * LINES] = {
    let mut places = headed();
    let mut line = 0;
    while line < 2 * LINES {
        let x = if line < LINES { LEFT } else { MIDDLE };
        let y = 59 + 25 * (line % LINES) as u16;
        places[HEAD + 2 * line] =
            Place::new(Area::new(x, y + 5, LABEL_WIDTH, 17), y + 9, &fonts::LABEL, Align::Left);
        let value = Area::new(x + LABEL_WIDTH, y + 2, VALUE_WIDTH, 21);
        places[HEAD + 2 * line + 1] = Place::new(value, y + 6, &fonts::MESSAGE, Align::Right);
        line += 1;
    }
    places
};

/// Label, value and place of the highest and the lowest.
const ENDS: usize = 4;
static EXTREMES: [Place; HEAD + 3 * ENDS] = {
    let mut places = headed();
    let mut end = 0;
    while end < ENDS {
        let y = 61 + 31 * end as u16;
        let place = HEAD + 3 * end;
        places[place] = Place::new(Area::new(LEFT, y + 8, 90, 17), y + 13, &fonts::LABEL, Align::Left);
        let value = Area::new(100, y + 1, 116, 25);
        places[place + 1] = Place::new(value, y + 2, &fonts::FIGURE, Align::Right);
        let at = Area::new(218, y + 4, RIGHT - 218, 20);
        places[place + 2] = Place::new(at, y + 10, &fonts::MESSAGE, Align::Right);
        end += 1;
    }
    places
};

/// Two lines of what, what to do, its code, how long there is.
static ALARM: [Place; HEAD + 6] = {
    const WIDTH: u16 = RIGHT - LEFT;
    let mut places = headed();
    // Lower than on other pages: the ground begins where the telltales end.
    places[0] = Place::new(Area::new(LEFT, 30, 180, 28), 36, &fonts::ALARM, Align::Left);
    places[2] = Place::new(Area::new(196, 31, 24, 25), 32, &fonts::GEAR, Align::Centre);
    places[3] = Place::new(Area::new(228, 31, RIGHT - 228, 25), 33, &fonts::FIGURE, Align::Right);
    places[4] = Place::new(Area::new(LEFT, 58, WIDTH, 1), 0, &fonts::LABEL, Align::Left);
    places[1] = Place::new(Area::new(192, 36, 2, 14), 38, &fonts::LABEL, Align::Right);
    places[HEAD] = Place::new(Area::new(LEFT, 60, WIDTH, 28), 66, &fonts::ALARM, Align::Left);
    places[HEAD + 1] = Place::new(Area::new(LEFT, 88, WIDTH, 28), 94, &fonts::ALARM, Align::Left);
    places[HEAD + 2] = Place::new(Area::new(LEFT, 119, WIDTH, 19), 122, &fonts::MESSAGE, Align::Left);
    places[HEAD + 3] = Place::new(Area::new(LEFT, 142, 96, 19), 145, &fonts::MESSAGE, Align::Left);
    places[HEAD + 4] = Place::new(Area::new(150, 164, 84, 19), 169, &fonts::LABEL, Align::Right);
    places[HEAD + 5] = Place::new(Area::new(236, 161, RIGHT - 236, 25), 162, &fonts::FIGURE, Align::Right);
    places
};

const fn words(text: Text, language: Language, ink: Ink) -> Element {
    Element { content: Content::Words(said(text, language)), ink }
}

/// Returns a number with its unit, as it has room in `place`.
fn measure(place: &Place, shown: Shown<i32>, decimals: u32, unit: Text, language: Language) -> Element {
    let unit = said(unit, language);
    let of = |value, decimals| Content::Measure(Short::EMPTY.decimal(value, decimals), unit);
    let content = match shown {
        Shown::Value(value) => place.fit(value, decimals, of),
        missing => Content::Measure(Short::shown(missing, decimals), unit),
    };
    Element { content, ink: ink_of(shown) }
}

/// Returns the remaining range, as it has room in `place`; an estimate is marked.
fn range_of(place: &Place, range: Shown<Range>) -> Element {
    let content = match range {
        Shown::Value(Range { km, is_estimated }) => {
            let start = if is_estimated { Short::EMPTY.code(b'~') } else { Short::EMPTY };
            place.fit(km.into(), 0, |km, _| Content::Measure(start.decimal(km, 0), words::KM.en))
        }
        missing => Content::Measure(Short::shown(missing.map(|_| 0), 0), words::KM.en),
    };
    Element { content, ink: ink_of(range) }
}

/// Hours and minutes.
fn duration_of(minutes: Option<u16>) -> Element {
    let shown = minutes.map_or(Shown::Never, Shown::Value);
    let number = match minutes {
        Some(minutes) => {
            Short::EMPTY.number(u32::from(minutes / 60), 1).code(b':').number(u32::from(minutes % 60), 2)
        }
        None => Short::shown(Shown::Never, 0),
    };
    Element { content: Content::Measure(number, words::HOURS.en), ink: ink_of(shown) }
}

/// A value with the label over it.
type Labelled = (Text, Element);

fn trip_figures(view: &View, trip: Trip) -> [Labelled; FIGURES] {
    let Journey { hectometres, average_whkm, used_watthours, regained_watthours } =
        view.journeys[trip as usize];
    let tenths = |number: u32| Shown::Value(i32::try_from(number).unwrap_or(i32::MAX));
    let of = |shown, unit| measure(NUMBER, shown, 1, unit, view.language);
    // 1 Wh/km is 0.1 kWh/100 km.
    let average = average_whkm.map_or(Shown::Never, Shown::Value);
    [
        (words::DISTANCE, of(tenths(hectometres), words::KM)),
        (words::AVERAGE, of(average, words::KWH_100KM)),
        (words::USED, of(tenths(used_watthours / 100), words::KWH)),
        (words::REGAINED, of(tenths(regained_watthours / 100), words::KWH)),
        (words::RANGE, range_of(NUMBER, view.range)),
        (words::HOLD_TO_RESET, Element::BLANK),
    ]
}

fn energy_figures(view: &View) -> [Labelled; FIGURES] {
    let of = |shown, decimals, unit| measure(NUMBER, shown, decimals, unit, view.language);
    let soc = (words::CHARGE, of(view.soc_percent.map(i32::from), 0, words::PERCENT));
    let range = (words::RANGE, range_of(NUMBER, view.range));
    let Some(Charging { decivolts, deciamps, hectowatts, minutes_left, .. }) = view.charging else {
        return [
            soc,
            range,
            (words::POWER, of(view.power_hectowatts, 1, words::KW)),
            (words::CONSUMPTION, of(view.consumption_whkm, 1, words::KWH_100KM)),
            (words::VOLTAGE, of(view.pack_decivolts, 1, words::VOLT)),
            (words::CURRENT, of(view.pack_deciamps, 1, words::AMP)),
        ];
    };
    [
        soc,
        (words::TIME_LEFT, duration_of(minutes_left)),
        (words::CHARGE_POWER, of(hectowatts, 1, words::KW)),
        (words::CURRENT, of(deciamps, 1, words::AMP)),
        (words::VOLTAGE, of(decivolts, 1, words::VOLT)),
        range,
    ]
}

/// How often a fault came, and hours, minutes and seconds since power-on.
fn detail(row: &Listed) -> Short {
    let [hours, minutes, seconds] = [row.at_s / 3_600, row.at_s / 60 % 60, row.at_s % 60];
    let time = Short::EMPTY.code(b'+').number(hours, 1).code(b':').number(minutes, 2).code(b':');
    let time = time.number(seconds, 2);
    if row.count < 2 {
        return time;
    }
    // Latin-1 has a multiplication sign.
    time.code(b' ').code(b' ').code(0xD7).number(row.count.into(), 1)
}

/// Returns label and value of an item of a chapter, `None` for what the vehicle does not have.
fn item_line(item: &Item, shown: Shown<i32>, language: Language) -> Option<Labelled> {
    let unit = item.value.unit();
    let state = shown.value().and_then(|number| words::state(unit, number, item.warns));
    let element = match (state, shown) {
        (_, Shown::Never) => return None,
        (Some((word, ink)), _) => words(word, language, ink),
        (None, _) if unit.symbol().is_empty() => count_of(shown),
        (None, _) => {
            let decimals = unit.decimal(0).1;
            let of = |number| i32::try_from(unit.decimal(number).0).unwrap_or(i32::MAX);
            measure(&TABLE[HEAD + 1], shown.map(of), decimals, words::same(unit.symbol()), language)
        }
    };
    Some((item.label, element))
}

/// Returns a count or a code, in millions if there is no room for all of it; 0 stands back.
fn count_of(shown: Shown<i32>) -> Element {
    let whole = Content::Short(Short::shown(shown, 0));
    let content = match shown {
        Shown::Value(number) if !TABLE[HEAD + 1].has_room_for(&whole) => {
            Content::Short(Short::EMPTY.decimal(number / 1_000_000, 0).code(b'M'))
        }
        _ => whole,
    };
    let ink = if shown == Shown::Value(0) { Ink::Secondary } else { ink_of(shown) };
    Element { content, ink }
}

fn bus_line(count: Count, shown: Shown<i32>, language: Language) -> Option<Labelled> {
    let element = match (count, shown) {
        (_, Shown::Never) => return None,
        (Count::State, Shown::Value(number)) => {
            let (text, ink) = words::confinement(Confinement::from_number(number));
            words(text, language, ink)
        }
        _ => count_of(shown),
    };
    Some((words::count(count), element))
}

/// The four values of [`Chapter::Extremes`]: unit, decimals, and how many places follow each.
const ENDS_OF: [(Text, Text, u32, usize); ENDS] = [
    (words::CELL_MAX, words::VOLT, 3, 3),
    (words::CELL_MIN, words::VOLT, 3, 3),
    (words::TEMPERATURE_MAX, words::CELSIUS, 0, 2),
    (words::TEMPERATURE_MIN, words::CELSIUS, 0, 2),
];

/// Returns where an element is: box and number in it, or a number through the whole pack.
fn place_of(places: &[Shown<i32>]) -> Option<Short> {
    let number = |place: usize| places.get(place).and_then(|shown| shown.value());
    let hash = Short::EMPTY.code(b'#');
    match (number(0), number(1), number(2)) {
        (Some(of_box), Some(cell), _) => Some(hash.decimal(of_box, 0).code(b'-').decimal(cell, 0)),
        (Some(one), None, None) | (_, _, Some(one)) | (None, Some(one), _) => Some(hash.decimal(one, 0)),
        (None, None, None) => None,
    }
}

/// Returns a text as two lines of at most `width` pixels, broken between words where there are some.
fn wrapped(text: &'static str, font: &fonts::Font, width: u16) -> [&'static str; 2] {
    if font.width(text) <= width {
        return [text, ""];
    }
    let fits = |&(at, _): &(usize, char)| text.get(..at).is_some_and(|start| font.width(start) <= width);
    let breaks = text.char_indices().take_while(fits);
    let between_words = breaks.clone().filter(|(_, character)| *character == ' ').last();
    let (at, _) = between_words.or_else(|| breaks.last()).unwrap_or((0, ' '));
    [text.get(..at).unwrap_or_default(), text.get(at..).unwrap_or_default().trim_start()]
}

/// What a STOP is, what to do, how long there is; gear and speed stay in the head.
fn alarm(view: &View, line: &Line, elements: &mut [Element]) {
    head(view, elements);
    let on_stop = |content| Element { content, ink: Ink::OnStop };
    let say = |text| on_stop(Content::Words(said(text, view.language)));
    let Place { font, area, .. } = &ALARM[HEAD];
    let [first, second] = wrapped(said(line.text, view.language), font, area.width);
    let code = match line.code {
        Some(code) => Content::Coded(said(words::CODE, view.language), Some(code)),
        None => Content::Blank,
    };
    let seconds = view.hv_off_s.map(|seconds| Short::EMPTY.number(seconds.into(), 1));
    let countdown = seconds.map_or(Content::Blank, |short| Content::Measure(short, words::SECONDS.en));
    let body = [
        on_stop(Content::Words(first)),
        on_stop(Content::Words(second)),
        say(line.advice().unwrap_or(words::STOP_SAFELY)),
        on_stop(code),
        if view.hv_off_s.is_some() { say(words::HV_OFF_IN) } else { Element::BLANK },
        on_stop(countdown),
    ];
    elements.iter_mut().skip(HEAD).zip(body).for_each(|(element, new)| *element = new);
    // All of it stands on the ground of a STOP; a bar has nothing to say.
    elements.iter_mut().take(HEAD).for_each(|element| element.ink = Ink::OnStop);
    if let Some(bar) = elements.get_mut(HEAD - 1) {
        *bar = Element::BLANK;
    }
}

fn title(view: &View) -> Text {
    match view.page {
        _ if view.alarm.is_some() => words::STOP,
        Page::Main => words::same(""),
        Page::Trip(Trip::A) => words::TRIP_A,
        Page::Trip(Trip::B) => words::TRIP_B,
        Page::Energy => match view.charging.map(|charging| charging.plug) {
            None => words::ENERGY,
            Some(plug) => words::plug(plug),
        },
        Page::Faults(_) => words::FAULTS,
        Page::History(_) => words::HISTORY,
        Page::Technic(sheet) => sheet.chapter.title(),
    }
}

fn head(view: &View, elements: &mut [Element]) {
    let part = match view.page {
        Page::Faults(List { position, count, .. }) | Page::History(List { position, count, .. }) => {
            (position, count)
        }
        Page::Technic(Sheet { position, count, .. }) => (position, count),
        _ => (1, 1),
    };
    let of = |(position, count): (u8, u8)| {
        Content::Short(Short::EMPTY.number(position.into(), 1).code(b'/').number(count.into(), 1))
    };
    let gear = match view.gear {
        None => Content::Blank,
        Some(gear) => Content::Short(Short::EMPTY.code(letter(gear))),
    };
    let is_charge = matches!(view.page, Page::Energy);
    let lit = match view.soc_percent.value() {
        _ if !is_charge => Some(0),
        Some(percent) => Some((u32::from(percent.min(100)) * u32::from(BAR.width) / 100) as u16),
        None => None,
    };
    let head = [
        words(title(view), view.language, Ink::Primary),
        Element { content: if part.1 > 1 { of(part) } else { Content::Blank }, ink: Ink::Secondary },
        Element { content: gear, ink: Ink::Accent },
        measure(&GRID[3], view.speed_kmh.map(i32::from), 0, words::KMH, view.language),
        Element {
            content: Content::Bar(lit),
            ink: if is_charge && view.is_charge_low { Ink::Yellow } else { Ink::Accent },
        },
    ];
    elements.iter_mut().zip(head).for_each(|(element, new)| *element = new);
}

/// Returns the letter of a gear.
pub(crate) const fn letter(gear: Gear) -> u8 {
    match gear {
        Gear::D => b'D',
        Gear::R => b'R',
        Gear::N => b'N',
        Gear::P => b'P',
        Gear::D1 => b'1',
        Gear::D2 => b'2',
        Gear::D3 => b'3',
        Gear::D4 => b'4',
        Gear::D5 => b'5',
        Gear::D6 => b'6',
    }
}

/// Returns whether two views look the same: they may differ in what their page does not show.
///
/// Consumption and energy change with nearly every frame and stand on pages of their own: whoever asks this first need not
/// work a picture out to find that nothing is to be sent.
pub fn looks_same(view: &View, other: &View) -> bool {
    let (is_main, is_trip, is_energy) = match view.page {
        Page::Main => (true, false, false),
        Page::Trip(_) => (false, true, false),
        Page::Energy => (false, false, true),
        Page::Faults(_) | Page::History(_) | Page::Technic(_) => (false, false, false),
    };
    let mut seen = *other;
    if !is_main {
        seen.motor_rpm = view.motor_rpm;
        seen.motor_celsius = view.motor_celsius;
        seen.inverter_celsius = view.inverter_celsius;
        seen.cell_millivolts = view.cell_millivolts;
        seen.cell_celsius = view.cell_celsius;
        seen.odometer_hectometres = view.odometer_hectometres;
        seen.is_power_limited = view.is_power_limited;
    }
    if !is_main && !is_energy {
        seen.soc_percent = view.soc_percent;
        seen.is_charge_low = view.is_charge_low;
        seen.pack_decivolts = view.pack_decivolts;
        seen.pack_deciamps = view.pack_deciamps;
        seen.power_hectowatts = view.power_hectowatts;
    }
    if !is_main && !is_trip && !is_energy {
        seen.range = view.range;
    }
    if !is_trip {
        seen.journeys = view.journeys;
    }
    if !is_energy {
        seen.consumption_whkm = view.consumption_whkm;
        seen.charging = view.charging;
    }
    *view == seen
}

/// Returns the elements of a view's page, in the order of its places.
pub(crate) fn elements(view: &View) -> [Element; MOST_ELEMENTS] {
    let mut elements = [Element::BLANK; MOST_ELEMENTS];
    if let Some(line) = &view.alarm {
        alarm(view, line, &mut elements);
        return elements;
    }
    if matches!(view.page, Page::Main) {
        if view.range != Shown::Never {
            elements[0] = range_of(&MAIN[0], view.range);
        }
        return elements;
    }
    head(view, &mut elements);
    let body = &mut elements[HEAD..];
    let language = view.language;
    match &view.page {
        Page::Main => {}
        Page::Trip(_) | Page::Energy => {
            let figures = match view.page {
                Page::Trip(trip) => trip_figures(view, trip),
                _ => energy_figures(view),
            };
            for (pair, (text, value)) in body.chunks_exact_mut(2).zip(figures) {
                pair.copy_from_slice(&[words(text, language, Ink::Secondary), value]);
            }
        }
        Page::Faults(list) | Page::History(list) => {
            for (row, listed) in body.chunks_exact_mut(3).zip(list.rows.iter().flatten()) {
                let text = Content::Coded(said(listed.text, language), listed.code);
                row.copy_from_slice(&[
                    Element { content: Content::Mark(listed.severity), ink: Ink::Primary },
                    Element { content: text, ink: Ink::Primary },
                    Element { content: Content::Short(detail(listed)), ink: Ink::Secondary },
                ]);
            }
            if list.rows[0].is_none() {
                body[1] = words(words::NO_FAULTS, language, Ink::Secondary);
            }
        }
        Page::Technic(sheet) if sheet.chapter == Chapter::Extremes => {
            let mut values = sheet.values.as_slice();
            for (row, (text, unit, decimals, places)) in body.chunks_exact_mut(3).zip(ENDS_OF) {
                let Some((&value, rest)) = values.split_first() else { break };
                let (at, rest) = rest.split_at(places.min(rest.len()));
                values = rest;
                let at = place_of(at).map_or(Content::Blank, Content::Short);
                // Half a number would be another cell.
                let at = if EXTREMES[HEAD + 2].has_room_for(&at) { at } else { Content::Blank };
                row.copy_from_slice(&[
                    words(text, language, Ink::Secondary),
                    measure(&EXTREMES[HEAD + 1], value, decimals, unit, language),
                    Element { content: at, ink: Ink::Primary },
                ]);
            }
        }
        Page::Technic(sheet) => {
            let items = sheet.chapter.items().iter().zip(&sheet.values);
            let items = items.filter_map(|(item, &shown)| item_line(item, shown, language));
            let is_bus = sheet.chapter == Chapter::Bus;
            let counts = Count::ALL.iter().zip(&sheet.values).filter(|_| is_bus);
            let lines = items.chain(counts.filter_map(|(&count, &shown)| bus_line(count, shown, language)));
            for (pair, (text, value)) in body.chunks_exact_mut(2).zip(lines) {
                pair.copy_from_slice(&[words(text, language, Ink::Secondary), value]);
            }
        }
    }
    elements
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{scanline::Scanline, theme::Palette};
    use cluster::view::Theme;
    extern crate std;
    use protocol_core::model::Severity;
    use protocol_core::states::Plug;
    use std::{format, string::String, vec::Vec};

    const KINDS: [Kind; 6] = [Kind::Main, Kind::Grid, Kind::List, Kind::Table, Kind::Extremes, Kind::Alarm];

    #[test]
    fn no_cell_lies_on_another_or_on_what_every_page_has() {
        for kind in KINDS {
            let places = kind.places();
            assert!(places.len() <= MOST_ELEMENTS);
            for (index, place) in places.iter().enumerate() {
                let Area { y, .. } = place.area;
                assert!(
                    y >= 26 && place.area.bottom() <= 189 && place.area.right() <= crate::WIDTH,
                    "{place:?}"
                );
                assert!(!place.area.meets(crate::layout::HEARTBEAT), "{kind:?} {place:?}");
                for other in &places[index + 1..] {
                    assert_eq!(place.area.common(other.area), None, "{kind:?}");
                }
            }
        }
    }

    /// A colour that nothing is painted in.
    const UNPAINTED: u16 = 1;

    /// Returns what an element inks when nothing cuts it, `None` = nothing.
    fn inked(place: &Place, element: &Element) -> Option<Area> {
        let mut all: Option<Area> = None;
        for y in 0..crate::HEIGHT {
            let mut pixels = [UNPAINTED; crate::WIDTH as usize];
            place.paint(
                element,
                &mut Scanline { y, left: 0, pixels: &mut pixels },
                Palette::of(Theme::Night),
            );
            let mut columns = (0_u16..).zip(pixels).filter(|(_, pixel)| *pixel != UNPAINTED).map(|(x, _)| x);
            let Some(first) = columns.next() else { continue };
            let row = Area::new(first, y, columns.last().unwrap_or(first) + 1 - first, 1);
            all = Some(all.map_or(row, |all| all.around(row)));
        }
        all
    }

    /// Returns what is wrong with the elements of a view's page.
    fn misfits(view: &View) -> Vec<String> {
        let mut misfits = Vec::new();
        let kind = Kind::of(view);
        for (number, (place, element)) in kind.places().iter().zip(elements(view)).enumerate() {
            // A bar and a mark fill their rows.
            if matches!(element.content, Content::Bar(_) | Content::Mark(_)) {
                continue;
            }
            let (width, area) = (place.width(&element.content), place.area);
            let ink = inked(place, &element);
            if width > area.width || ink.is_some_and(|ink| ink.around(area) != area) {
                misfits.push(format!(
                    "{kind:?} {number}, {:?}: {:?} takes {width} pixels of {}, {ink:?} of {area:?}",
                    view.language, element.content, area.width
                ));
            }
        }
        misfits
    }

    /// Every kind of missing, the ends of the type, and what stands on either side of a figure more.
    fn ends() -> impl Iterator<Item = Shown<i32>> {
        let powers = (0..10).flat_map(|figures| [10_i32.pow(figures) - 1, 10_i32.pow(figures)]);
        let values = powers.flat_map(|value| [value, -value]).chain([i32::MIN, i32::MAX]);
        values.map(Shown::Value).chain([Shown::Never, Shown::Stale, Shown::Invalid])
    }

    /// Returns views whose every number is `shown`, as far as its type goes.
    fn pages(shown: Shown<i32>) -> Vec<View> {
        let clamped = |most: i32| shown.map(|value| value.clamp(0, most));
        let (natural, small) =
            (clamped(i32::MAX).value().unwrap_or(0) as u32, clamped(0xFFFF).map(|v| v as u16));
        let count = small.value().unwrap_or(0);
        let journey = Journey {
            // An unsigned number has twice the room.
            hectometres: if shown == Shown::Value(i32::MAX) { u32::MAX } else { natural },
            average_whkm: shown.value(),
            used_watthours: if shown == Shown::Value(i32::MAX) { u32::MAX } else { natural },
            regained_watthours: natural,
        };
        let list = |severity| List {
            rows: [Some(Listed { severity, text: words::NO_FAULTS, code: Some(count), count, at_s: natural });
                ROWS],
            // A list of 99 parts has 396 faults.
            position: 99,
            count: 99,
        };
        let sheet = |&chapter: &Chapter| {
            Page::Technic(Sheet { chapter, values: [shown; cluster::page::VALUES], position: 99, count: 99 })
        };
        let trips = [Page::Main, Page::Trip(Trip::A), Page::Trip(Trip::B), Page::Energy];
        let lists = [Page::Faults(list(Severity::Stop)), Page::History(list(Severity::Warn))];
        let charging = [Plug::Inserted, Plug::Charging, Plug::Complete, Plug::Fault].map(|plug| {
            Some(Charging {
                plug,
                decivolts: shown,
                deciamps: shown,
                hectowatts: shown,
                minutes_left: small.value(),
            })
        });
        let pages = trips.into_iter().chain(lists).chain(Chapter::ALL.iter().map(sheet));
        let mut views = Vec::new();
        for page in pages {
            for language in [Language::Chinese, Language::English] {
                for is_estimated in [false, true] {
                    for charging in charging.into_iter().chain([None]) {
                        views.push(View {
                            page,
                            language,
                            charging,
                            speed_kmh: small,
                            gear: Some(Gear::D),
                            soc_percent: clamped(255).map(|value| value as u8),
                            pack_decivolts: shown,
                            pack_deciamps: shown,
                            power_hectowatts: shown,
                            consumption_whkm: shown,
                            range: small.map(|km| Range { km, is_estimated }),
                            journeys: [journey; 2],
                            ..View::default()
                        });
                        if page != Page::Energy {
                            break;
                        }
                    }
                }
            }
        }
        views
    }

    #[test]
    fn every_cell_of_every_page_has_room_for_the_ends_of_its_value() {
        let misfits: Vec<_> = ends().flat_map(pages).flat_map(|view| misfits(&view)).collect();
        assert!(misfits.is_empty(), "{} elements are cut:\n{}", misfits.len(), misfits.join("\n"));
    }

    #[test]
    fn every_fault_has_room_in_a_list_beside_its_code() {
        let place = &LIST[HEAD + 1];
        let texts = cluster::faults::ROWS.iter().flat_map(|row| row.words.texts());
        let own = texts.map(|text| (text.zh, text.en, None));
        let faults = protocol_core::generated::VEHICLES.iter().flat_map(|vehicle| vehicle.faults);
        for (zh, en, code) in own.chain(faults.map(|fault| (fault.zh, fault.en, Some(fault.code)))) {
            for text in [zh, en] {
                let content = Content::Coded(text, code);
                assert!(
                    place.has_room_for(&content),
                    "{text} {code:?} takes {} of {} pixels: shorten it",
                    place.width(&content),
                    place.area.width
                );
            }
        }
    }

    #[test]
    fn every_value_of_a_chapter_has_a_label_that_fits() {
        let place = &TABLE[HEAD];
        for chapter in Chapter::ALL.iter().filter(|&&chapter| chapter != Chapter::Extremes) {
            assert!(chapter.items().len() <= 2 * LINES, "{chapter:?} has more lines than its page");
            for Item { value, label, .. } in chapter.items() {
                for said in [label.zh, label.en] {
                    assert!(!said.is_empty(), "{} has no label", value.path());
                    let width = place.font.width(said);
                    assert!(width <= place.area.width, "{said}: {width} of {}", place.area.width);
                    assert!(
                        said.chars().all(|one| place.font.find(one).is_some()),
                        "{said}: cargo xtask fonts"
                    );
                }
            }
        }
        for &count in Count::ALL {
            let text = words::count(count);
            assert!(
                [text.zh, text.en].iter().all(|said| place.font.width(said) <= place.area.width),
                "{text:?}"
            );
        }
    }

    #[test]
    fn every_state_in_a_table_has_a_word_that_fits() {
        let place = &TABLE[HEAD + 1];
        let items = Chapter::ALL.iter().flat_map(|chapter| chapter.items());
        let states = items.flat_map(|item| {
            let unit = item.value.unit();
            let numbers = unit.kind().into_iter().flat_map(|kind| kind.states).map(|state| state.number);
            numbers.filter_map(move |number| words::state(unit, number, item.warns))
        });
        let answers = Confinement::ALL.iter().copied().map(Some);
        let controllers = answers.chain([None]).map(words::confinement);
        for (text, _) in states.chain(controllers) {
            for said in [text.zh, text.en] {
                assert!(!said.is_empty() && place.font.width(said) <= place.area.width, "{said}");
            }
        }
    }

    #[test]
    fn a_state_reads_on_the_panel_as_in_its_row() {
        for &state in Plug::ALL {
            assert_eq!(words::plug(state), Text { zh: state.zh(), en: state.en() });
        }
        for &state in Gear::ALL {
            // The panel has one character for a gear: a forward gear of a gearbox is its figure.
            assert!(state.word().ends_with(char::from(letter(state))), "{state:?}");
        }
    }

    #[test]
    fn a_cell_s_place_is_its_box_and_number_or_its_number_alone() {
        let of = |places: [Option<i32>; 3]| {
            place_of(&places.map(|place| place.map_or(Shown::Never, Shown::Value)))
        };
        let text = |text: &str| Some(text.bytes().fold(Short::EMPTY, Short::code));
        assert_eq!(of([Some(3), Some(12), None]), text("#3-12"));
        assert_eq!(of([None, None, Some(47)]), text("#47"));
        assert_eq!(of([Some(3), None, None]), text("#3"));
        assert_eq!(of([None, Some(4), None]), text("#4"));
        assert_eq!(of([None; 3]), None);
    }

    #[test]
    fn times_are_hours_minutes_and_seconds() {
        let row = |at_s, count| {
            let listed = Listed { severity: Severity::Warn, text: words::NO_FAULTS, code: None, count, at_s };
            detail(&listed)
        };
        let text = |text: &str| {
            text.chars().fold(Short::EMPTY, |short, one| short.code(u8::try_from(one).expect("Latin-1")))
        };
        assert_eq!(row(0, 1), text("+0:00:00"));
        assert_eq!(row(3_725, 1), text("+1:02:05"));
        assert_eq!(row(3_725, 12), text("+1:02:05  ×12"));
        let longest = row(u32::MAX, u16::MAX);
        assert_eq!(longest, text("+1193046:28:15  ×65535"));
        let place = &LIST[HEAD + 2];
        assert!(place.width(&Content::Short(longest)) <= place.area.width);
    }
}
