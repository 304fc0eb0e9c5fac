//! The pages but the dial: which cells each has, where they stand and what is in them.
//!
//! Owns a table of places for each kind of page and the step from a view to its cells. Beside them every page keeps the
//! lamps, the stripe, the message line and the proof of life; every page but the main one has gear and speed in its
//! head.
//! Source: BUS-R033, R038, R060, R067, R120, R124, R126, R143.

use crate::{
    cell::{Cell, Content, Short, Slot, ink_of},
    fonts,
    layout::{Align, Area},
    picture::said,
    theme::Ink,
    words,
};
use cluster::{
    Page, Telltale, Trip, View,
    page::{Count, Part},
    view::{Charging, Journey, Language, List, Listed, Range, Sheet, Text},
};
use protocol_core::model::{Gear, Shown, Unit, Value};
use protocol_core::states::{Confinement, Contactor, Flag};

/// Pages with the same places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// The dial, and one cell for the range.
    Main,
    /// Six large numbers.
    Grid,
    /// Four rows of two lines.
    List,
    /// Two columns of labels and values.
    Table,
    /// Four values and where they are.
    Extremes,
}

impl Kind {
    pub(crate) const fn of(page: &Page) -> Self {
        match page {
            Page::Main => Self::Main,
            Page::Trip(_) | Page::Energy => Self::Grid,
            Page::Faults(_) | Page::History(_) => Self::List,
            Page::Technic(Sheet { part: Part::Extremes, .. }) => Self::Extremes,
            Page::Technic(_) => Self::Table,
        }
    }

    /// Returns the places of its cells.
    pub(crate) const fn slots(self) -> &'static [Slot] {
        match self {
            Self::Main => &MAIN,
            Self::Grid => &GRID,
            Self::List => &LIST,
            Self::Table => &TABLE,
            Self::Extremes => &EXTREMES,
        }
    }
}

/// Most cells of a page.
pub(crate) const MOST_CELLS: usize = TABLE.len();

/// Margins of the pages: the proof of life stands to the right.
const LEFT: u16 = 10;
const RIGHT: u16 = 304;
/// First column of the right half of a table.
const MIDDLE: u16 = 170;

/// Cells of the head: title, part, gear, speed, bar.
const HEAD: usize = 5;
const BAR: Area = Area::new(LEFT, 53, RIGHT - LEFT, 3);

const BLANK: Slot = Slot::new(Area::new(0, 0, 0, 0), 0, &fonts::LABEL, Align::Left);

/// Returns places of which the first are the head's.
const fn headed<const COUNT: usize>() -> [Slot; COUNT] {
    let mut slots = [const { BLANK }; COUNT];
    slots[0] = Slot::new(Area::new(LEFT, 30, 150, 22), 35, &fonts::MESSAGE, Align::Left);
    slots[1] = Slot::new(Area::new(160, 35, 32, 14), 38, &fonts::LABEL, Align::Right);
    slots[2] = Slot::new(Area::new(202, 26, 20, 24), 26, &fonts::GEAR, Align::Centre);
    slots[3] = Slot::new(Area::new(228, 26, RIGHT - 228, 25), 27, &fonts::FIGURE, Align::Right);
    slots[4] = Slot::new(BAR, 0, &fonts::LABEL, Align::Left);
    slots
}

/// Its figures end where those of voltage and current do.
const RANGE: Area = Area::new(6, 64, 62, 16);
static MAIN: [Slot; 1] = [Slot::new(RANGE, 65, &fonts::VALUE, Align::Right)];

/// Large numbers with a label each, row by row.
const TILES: usize = 6;
const TILE: u16 = 144;
static GRID: [Slot; HEAD + 2 * TILES] = {
    let mut slots = headed();
    let mut tile = 0;
    while tile < TILES {
        let x = if tile % 2 == 0 { LEFT } else { RIGHT - TILE };
        let y = 59 + 43 * (tile / 2) as u16;
        slots[HEAD + 2 * tile] = Slot::new(Area::new(x, y, TILE, 16), y + 4, &fonts::LABEL, Align::Left);
        let number = Area::new(x, y + 17, TILE, 25);
        slots[HEAD + 2 * tile + 1] = Slot::new(number, y + 18, &fonts::FIGURE, Align::Left);
        tile += 1;
    }
    slots
};

/// Rows of a severity's mark, a text with its code, and when it came.
const ROWS: usize = cluster::page::ROWS;
static LIST: [Slot; HEAD + 3 * ROWS] = {
    let mut slots = headed();
    let mut row = 0;
    while row < ROWS {
        let y = 59 + 32 * row as u16;
        let (x, width) = (LEFT + 11, RIGHT - LEFT - 11);
        let place = HEAD + 3 * row;
        slots[place] = Slot::new(Area::new(LEFT, y + 1, 4, 29), 0, &fonts::LABEL, Align::Left);
        slots[place + 1] = Slot::new(Area::new(x, y, width, 19), y + 3, &fonts::MESSAGE, Align::Left);
        slots[place + 2] = Slot::new(Area::new(x, y + 19, width, 12), y + 21, &fonts::LABEL, Align::Left);
        row += 1;
    }
    slots
};

/// Labels and values, column by column.
const LINES: usize = 5;
const LABEL_WIDTH: u16 = 66;
const VALUE_WIDTH: u16 = RIGHT - MIDDLE - LABEL_WIDTH;
static TABLE: [Slot; HEAD + 4 * LINES] = {
    let mut slots = headed();
    let mut line = 0;
    while line < 2 * LINES {
        let x = if line < LINES { LEFT } else { MIDDLE };
        let y = 59 + 25 * (line % LINES) as u16;
        slots[HEAD + 2 * line] =
            Slot::new(Area::new(x, y + 5, LABEL_WIDTH, 17), y + 9, &fonts::LABEL, Align::Left);
        let value = Area::new(x + LABEL_WIDTH, y + 2, VALUE_WIDTH, 21);
        slots[HEAD + 2 * line + 1] = Slot::new(value, y + 6, &fonts::MESSAGE, Align::Right);
        line += 1;
    }
    slots
};

/// Label, value and place of the highest and the lowest.
const ENDS: usize = 4;
static EXTREMES: [Slot; HEAD + 3 * ENDS] = {
    let mut slots = headed();
    let mut end = 0;
    while end < ENDS {
        let y = 61 + 31 * end as u16;
        let place = HEAD + 3 * end;
        slots[place] = Slot::new(Area::new(LEFT, y + 8, 90, 17), y + 13, &fonts::LABEL, Align::Left);
        let value = Area::new(100, y + 1, 116, 25);
        slots[place + 1] = Slot::new(value, y + 2, &fonts::FIGURE, Align::Right);
        let at = Area::new(218, y + 4, RIGHT - 218, 20);
        slots[place + 2] = Slot::new(at, y + 10, &fonts::MESSAGE, Align::Right);
        end += 1;
    }
    slots
};

const fn words(text: Text, language: Language, ink: Ink) -> Cell {
    Cell { content: Content::Words(said(text, language)), ink }
}

fn measure(shown: Shown<i32>, decimals: u32, unit: Text, language: Language) -> Cell {
    let number = Short::shown(shown, decimals);
    Cell { content: Content::Measure(number, said(unit, language)), ink: ink_of(shown) }
}

/// Returns the remaining range; an estimate is marked.
fn range_of(range: Shown<Range>) -> Cell {
    let start = match range {
        Shown::Value(Range { is_estimated: true, .. }) => Short::EMPTY.code(b'~'),
        _ => Short::EMPTY,
    };
    let number = match range {
        Shown::Value(Range { km, .. }) => start.number(km.into(), 1),
        missing => Short::shown(missing.map(|_| 0), 0),
    };
    Cell { content: Content::Measure(number, words::KM.en), ink: ink_of(range) }
}

/// Hours and minutes.
fn duration_of(minutes: Option<u16>) -> Cell {
    let shown = minutes.map_or(Shown::Never, Shown::Value);
    let number = match minutes {
        Some(minutes) => {
            Short::EMPTY.number(u32::from(minutes / 60), 1).code(b':').number(u32::from(minutes % 60), 2)
        }
        None => Short::shown(Shown::Never, 0),
    };
    Cell { content: Content::Measure(number, words::HOURS.en), ink: ink_of(shown) }
}

/// A value with the label over it.
type Tile = (Text, Cell);

fn trip_tiles(view: &View, trip: Trip) -> [Tile; TILES] {
    let Journey { hectometres, average_whkm, used_watthours, regained_watthours } =
        view.journeys[trip as usize];
    let tenths = |number: u32| Shown::Value(i32::try_from(number).unwrap_or(i32::MAX));
    let of = |shown, unit| measure(shown, 1, unit, view.language);
    // 1 Wh/km is 0.1 kWh/100 km.
    let average = average_whkm.map_or(Shown::Never, Shown::Value);
    [
        (words::DISTANCE, of(tenths(hectometres), words::KM)),
        (words::AVERAGE, of(average, words::KWH_100KM)),
        (words::USED, of(tenths(used_watthours / 100), words::KWH)),
        (words::REGAINED, of(tenths(regained_watthours / 100), words::KWH)),
        (words::RANGE, range_of(view.range)),
        (words::HOLD_TO_RESET, Cell::BLANK),
    ]
}

fn energy_tiles(view: &View) -> [Tile; TILES] {
    let of = |shown, decimals, unit| measure(shown, decimals, unit, view.language);
    let soc = (words::CHARGE, of(view.soc_percent.map(i32::from), 0, words::PERCENT));
    let range = (words::RANGE, range_of(view.range));
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

/// Returns the label and the value of a line of a table, `None` for what the vehicle does not have.
fn line_of(text: Text, unit: Option<Unit>, shown: Shown<i32>, language: Language) -> Option<(Text, Cell)> {
    let state = match (unit, shown.value()) {
        (Some(Unit::Contactor), Some(number)) => Contactor::from_number(number).map(words::contactor),
        (Some(Unit::Flag), Some(number)) => Flag::from_number(number).map(words::flag),
        _ => None,
    };
    let cell = match (state, shown) {
        (_, Shown::Never) => return None,
        (Some((word, ink)), _) => words(word, language, ink),
        (_, Shown::Value(0)) => Cell { content: Content::Short(Short::shown(shown, 0)), ink: Ink::Secondary },
        // Seven figures have room.
        (_, Shown::Value(number @ 10_000_000..)) => {
            let millions = Short::EMPTY.decimal(number / 1_000_000, 0).code(b'M');
            Cell { content: Content::Short(millions), ink: Ink::Primary }
        }
        _ => Cell { content: Content::Short(Short::shown(shown, 0)), ink: ink_of(shown) },
    };
    Some((text, cell))
}

fn bus_line(count: Count, shown: Shown<i32>, language: Language) -> Option<(Text, Cell)> {
    let (text, cell) = line_of(words::count(count), None, shown, language)?;
    let state = shown.value().filter(|_| count == Count::State).map(Confinement::from_number);
    Some((text, state.map(words::confinement).map_or(cell, |(text, ink)| words(text, language, ink))))
}

/// The four values of [`Part::Extremes`]: unit, decimals, and how many places follow each.
const ENDS_OF: [(Text, Text, u32, usize); ENDS] = [
    (words::CELL_MAX, words::VOLT, 3, 3),
    (words::CELL_MIN, words::VOLT, 3, 3),
    (words::TEMPERATURE_MAX, words::CELSIUS, 0, 2),
    (words::TEMPERATURE_MIN, words::CELSIUS, 0, 2),
];

/// Returns where a cell is: box and number in it, or a number through the whole pack.
fn place_of(places: &[Shown<i32>]) -> Option<Short> {
    let number = |place: usize| places.get(place).and_then(|shown| shown.value());
    let hash = Short::EMPTY.code(b'#');
    match (number(0), number(1), number(2)) {
        (Some(of_box), Some(cell), _) => Some(hash.decimal(of_box, 0).code(b'-').decimal(cell, 0)),
        (Some(one), None, None) | (_, _, Some(one)) | (None, Some(one), _) => Some(hash.decimal(one, 0)),
        (None, None, None) => None,
    }
}

fn title(view: &View) -> Text {
    match view.page {
        Page::Main => words::same(""),
        Page::Trip(Trip::A) => words::TRIP_A,
        Page::Trip(Trip::B) => words::TRIP_B,
        Page::Energy => match view.charging.map(|charging| charging.plug) {
            None => words::ENERGY,
            Some(plug) => words::plug(plug),
        },
        Page::Faults(_) => words::FAULTS,
        Page::History(_) => words::HISTORY,
        Page::Technic(sheet) => words::part(sheet.part),
    }
}

fn head(view: &View, cells: &mut [Cell]) {
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
    let low = view.telltales.is_lit(Telltale::LowCharge);
    let head = [
        words(title(view), view.language, Ink::Primary),
        Cell { content: if part.1 > 1 { of(part) } else { Content::Blank }, ink: Ink::Secondary },
        Cell { content: gear, ink: Ink::Accent },
        measure(view.speed_kmh.map(i32::from), 0, words::KMH, view.language),
        Cell { content: Content::Bar(lit), ink: if is_charge && low { Ink::Yellow } else { Ink::Accent } },
    ];
    cells.iter_mut().zip(head).for_each(|(cell, new)| *cell = new);
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

/// Returns the cells of a view's page, in the order of its places.
pub(crate) fn cells(view: &View) -> [Cell; MOST_CELLS] {
    let mut cells = [Cell::BLANK; MOST_CELLS];
    if matches!(view.page, Page::Main) {
        if view.range != Shown::Never {
            cells[0] = range_of(view.range);
        }
        return cells;
    }
    head(view, &mut cells);
    let body = &mut cells[HEAD..];
    let language = view.language;
    match &view.page {
        Page::Main => {}
        Page::Trip(_) | Page::Energy => {
            let tiles = match view.page {
                Page::Trip(trip) => trip_tiles(view, trip),
                _ => energy_tiles(view),
            };
            for (pair, (text, value)) in body.chunks_exact_mut(2).zip(tiles) {
                pair.copy_from_slice(&[words(text, language, Ink::Secondary), value]);
            }
        }
        Page::Faults(list) | Page::History(list) => {
            for (row, listed) in body.chunks_exact_mut(3).zip(list.rows.iter().flatten()) {
                let text = Content::Coded(said(listed.text, language), listed.code);
                row.copy_from_slice(&[
                    Cell { content: Content::Mark(listed.severity), ink: Ink::Primary },
                    Cell { content: text, ink: Ink::Primary },
                    Cell { content: Content::Short(detail(listed)), ink: Ink::Secondary },
                ]);
            }
            if list.rows[0].is_none() {
                body[1] = words(words::NO_FAULTS, language, Ink::Secondary);
            }
        }
        Page::Technic(sheet) if sheet.part == Part::Extremes => {
            let mut values = sheet.cells.as_slice();
            for (row, (text, unit, decimals, places)) in body.chunks_exact_mut(3).zip(ENDS_OF) {
                let Some((&value, rest)) = values.split_first() else { break };
                let (at, rest) = rest.split_at(places.min(rest.len()));
                values = rest;
                let at = place_of(at).map_or(Content::Blank, Content::Short);
                row.copy_from_slice(&[
                    words(text, language, Ink::Secondary),
                    measure(value, decimals, unit, language),
                    Cell { content: at, ink: Ink::Primary },
                ]);
            }
        }
        Page::Technic(sheet) => {
            let line = |(value, shown): (&Value, &Shown<i32>)| {
                line_of(words::value(*value), Some(value.unit()), *shown, language)
            };
            let values = sheet.part.values().iter().zip(&sheet.cells).filter_map(line);
            let is_bus = sheet.part == Part::Bus;
            let counts = Count::ALL.iter().zip(&sheet.cells).filter(|_| is_bus);
            let lines = values.chain(counts.filter_map(|(&count, &shown)| bus_line(count, shown, language)));
            for (pair, (text, value)) in body.chunks_exact_mut(2).zip(lines) {
                pair.copy_from_slice(&[words(text, language, Ink::Secondary), value]);
            }
        }
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;
    use protocol_core::states::Plug;
    extern crate std;

    const KINDS: [Kind; 5] = [Kind::Main, Kind::Grid, Kind::List, Kind::Table, Kind::Extremes];

    #[test]
    fn no_cell_lies_on_another_or_on_what_every_page_has() {
        for kind in KINDS {
            let slots = kind.slots();
            assert!(slots.len() <= MOST_CELLS);
            for (index, slot) in slots.iter().enumerate() {
                let Area { y, .. } = slot.area;
                assert!(
                    y >= 26 && slot.area.bottom() <= 189 && slot.area.right() <= crate::WIDTH,
                    "{slot:?}"
                );
                assert!(!slot.area.meets(crate::layout::HEARTBEAT), "{kind:?} {slot:?}");
                for other in &slots[index + 1..] {
                    assert_eq!(slot.area.common(other.area), None, "{kind:?}");
                }
            }
        }
    }

    #[test]
    fn every_value_of_the_technical_parts_has_a_label_that_fits() {
        let slot = &TABLE[HEAD];
        for part in Part::ALL.iter().filter(|&&part| part != Part::Extremes) {
            for &value in part.values() {
                let text = words::value(value);
                for said in [text.zh, text.en] {
                    assert!(!said.is_empty(), "{} has no label", value.path());
                    let width = slot.font.width(said);
                    assert!(width <= slot.area.width, "{said}: {width} of {}", slot.area.width);
                    assert!(
                        said.chars().all(|one| slot.font.find(one).is_some()),
                        "{said}: cargo xtask fonts"
                    );
                }
            }
        }
        for &count in Count::ALL {
            let text = words::count(count);
            assert!(
                [text.zh, text.en].iter().all(|said| slot.font.width(said) <= slot.area.width),
                "{text:?}"
            );
        }
    }

    #[test]
    fn every_state_in_a_table_has_a_word_that_fits() {
        let slot = &TABLE[HEAD + 1];
        let contactors = Contactor::ALL.iter().map(|&state| words::contactor(state));
        let flags = Flag::ALL.iter().map(|&state| words::flag(state));
        let answers = Confinement::ALL.iter().copied().map(Some);
        let controllers = answers.chain([None]).map(words::confinement);
        for (text, _) in contactors.chain(flags).chain(controllers) {
            for said in [text.zh, text.en] {
                assert!(!said.is_empty() && slot.font.width(said) <= slot.area.width, "{said}");
            }
        }
    }

    #[test]
    fn a_state_reads_on_the_panel_as_in_its_row() {
        for &state in Contactor::ALL {
            assert_eq!(words::contactor(state).0, Text { zh: state.zh(), en: state.en() });
        }
        for &state in Flag::ALL {
            assert_eq!(words::flag(state).0, Text { zh: state.zh(), en: state.en() });
        }
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
            let listed = Listed {
                severity: protocol_core::Severity::Warn,
                text: words::NO_FAULTS,
                code: None,
                count,
                at_s,
            };
            detail(&listed)
        };
        let text = |text: &str| {
            text.chars().fold(Short::EMPTY, |short, one| short.code(u8::try_from(one).expect("Latin-1")))
        };
        assert_eq!(row(0, 1), text("+0:00:00"));
        assert_eq!(row(3_725, 1), text("+1:02:05"));
        assert_eq!(row(3_725, 12), text("+1:02:05  ×12"));
        let longest = row(u32::MAX, u16::MAX);
        let slot = &LIST[HEAD + 2];
        assert!(slot.width(&Content::Short(longest)) <= slot.area.width);
    }
}
