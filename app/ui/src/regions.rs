//! What has to be sent: the parts of the screen that can change on their own.
//!
//! A part's number is also its turn: the message line and the lamps go first, then figures, then bars and the dial.

use crate::{
    fonts,
    layout::{self, Area, FIELDS, MOST_FIGURES},
    pages::{Kind, MOST_ELEMENTS},
    picture::{Picture, turned},
};
use cluster::Telltale;

const TELLTALES: usize = 2;
const LIMITED: usize = TELLTALES + Telltale::ALL.len();
const GEAR: usize = LIMITED + 1;
const SPEED: usize = GEAR + 1;
const SPEED_PARTS: usize = 6;
const FIGURES: usize = SPEED + SPEED_PARTS;
const ELEMENTS: usize = FIGURES + FIELDS.len() * MOST_FIGURES;
const CHARGE: usize = ELEMENTS + MOST_ELEMENTS;
const CHARGE_PARTS: usize = layout::CHARGE_BAR.width.div_ceil(layout::BAR_PART) as usize;
const POWER: usize = CHARGE + CHARGE_PARTS;
const POWER_PARTS: usize = layout::POWER_BAR.width.div_ceil(layout::BAR_PART) as usize;
const HEARTBEAT: usize = POWER + POWER_PARTS;
const DIAL: usize = HEARTBEAT + 1;
const DIAL_PARTS: usize = fonts::DIAL_PARTS[0].len();
const PARTS: usize = DIAL + 2 * DIAL_PARTS;

const BAND: usize = 0;
const STRIPE: usize = 1;

/// Angle steps of one part of a ring.
const PART_STEPS: u16 = fonts::DIAL_STEPS / DIAL_PARTS as u16;

const WORDS: usize = PARTS.div_ceil(32);

/// The set of parts that have to be sent.
#[derive(Clone, Debug)]
pub(crate) struct Regions {
    marks: [u32; WORDS],
}

impl Regions {
    pub(crate) const CLEAN: Self = Self { marks: [0; WORDS] };

    pub(crate) fn is_clean(&self) -> bool {
        self.marks.iter().all(|&word| word == 0)
    }

    fn mark(&mut self, part: usize) {
        self.marks[part / 32] |= 1 << (part % 32);
    }

    fn is_marked(&self, part: usize) -> bool {
        part < PARTS && self.marks[part / 32] >> (part % 32) & 1 != 0
    }

    fn clear(&mut self, part: usize) {
        self.marks[part / 32] &= !(1 << (part % 32));
    }

    /// Takes the next place to send out of the set: one part, and its followers as long as one window around them all
    /// is no larger than their own windows together.
    pub(crate) fn take(&mut self, kind: Kind) -> Option<Area> {
        let word = self.marks.iter().position(|&word| word != 0)?;
        let mut part = word * 32 + self.marks[word].trailing_zeros() as usize;
        self.clear(part);
        let mut place = area(part, kind);
        while self.is_marked(part + 1) {
            let (next, together) = (area(part + 1, kind), place.around(area(part + 1, kind)));
            if together.pixels() > place.pixels() + next.pixels() {
                break;
            }
            part += 1;
            self.clear(part);
            place = together;
        }
        Some(place)
    }

    /// Takes the message line or a lamp out of the set, if one is in it.
    pub(crate) fn take_urgent(&mut self, kind: Kind) -> Option<Area> {
        (BAND..LIMITED).any(|part| self.is_marked(part)).then(|| self.take(kind)).flatten()
    }

    /// Forgets everything between the rows of lamps: it is sent as a whole.
    pub(crate) fn forget_page(&mut self) {
        (LIMITED..PARTS).for_each(|part| self.clear(part));
    }

    /// Marks what looks different in `new`; theme, language and kind of page are the same in both.
    pub(crate) fn mark_changes(&mut self, old: &Picture, new: &Picture) {
        self.mark_frame(old, new);
        for (element, _) in
            old.elements.iter().zip(&new.elements).enumerate().filter(|(_, (old, new))| old != new)
        {
            self.mark(ELEMENTS + element);
        }
        if new.kind == Kind::Main {
            self.mark_dial(old, new);
        }
        if old.heartbeat != new.heartbeat {
            self.mark(HEARTBEAT);
        }
    }

    /// Marks what looks different around the page.
    pub(crate) fn mark_frame(&mut self, old: &Picture, new: &Picture) {
        if old.message != new.message {
            self.mark(BAND);
        }
        if old.severity != new.severity {
            self.mark(STRIPE);
        }
        let switched = old.telltales.bits() ^ new.telltales.bits();
        for place in (0..Telltale::ALL.len()).filter(|place| switched >> place & 1 != 0) {
            self.mark(TELLTALES + place);
        }
    }

    /// Marks what looks different on the main page.
    fn mark_dial(&mut self, old: &Picture, new: &Picture) {
        if old.is_power_limited != new.is_power_limited {
            self.mark(LIMITED);
        }
        if old.gear != new.gear {
            self.mark(GEAR);
        }
        self.mark_speed(old, new);
        for (place, (old, new)) in old.fields.iter().zip(&new.fields).enumerate() {
            for figure in (0..MOST_FIGURES)
                .filter(|&figure| old.codes[figure] != new.codes[figure] || old.ink != new.ink)
            {
                // From left to right, so that neighbours go in one window.
                let count = usize::from(FIELDS[place].figures);
                if figure < count {
                    self.mark(FIGURES + place * MOST_FIGURES + count - 1 - figure);
                }
            }
        }
        self.mark_bars(old, new);
        for ring in 0..2 {
            if let Some((first, last)) = turned(old.rings[ring], new.rings[ring]) {
                for part in first / PART_STEPS..=last / PART_STEPS {
                    self.mark(DIAL + ring * DIAL_PARTS + usize::from(part));
                }
            }
        }
    }

    fn mark_speed(&mut self, old: &Picture, new: &Picture) {
        let moved = old.speed.length() != new.speed.length() || old.speed.ink != new.speed.ink;
        for figure in 0..old.speed.codes.len() {
            if !moved && old.speed.codes[figure] == new.speed.codes[figure] {
                continue;
            }
            for picture in [old, new] {
                if figure < picture.speed.length() {
                    let first =
                        usize::from((picture.speed_figure(figure).x - layout::SPEED.x) / layout::SPEED_HALF);
                    self.mark(SPEED + first);
                    self.mark(SPEED + first + 1);
                }
            }
        }
    }

    fn mark_bars(&mut self, old: &Picture, new: &Picture) {
        let recoloured = old.is_charge_low != new.is_charge_low;
        let bar = layout::CHARGE_BAR;
        let changed = match (old.charge, new.charge) {
            (Some(old), Some(new)) if recoloured => Some((0, old.max(new))),
            (Some(old), Some(new)) => (old != new).then(|| (old.min(new), old.max(new))),
            (old, new) => (old != new).then_some((0, bar.width)),
        };
        self.mark_columns(CHARGE, changed);
        let zero = (layout::POWER_ZERO - layout::POWER_BAR.x) as i16;
        let changed = match (old.power, new.power) {
            (Some(old), Some(new)) => {
                (old != new).then(|| ((zero + old.min(new)) as u16, (zero + old.max(new)) as u16))
            }
            (old, new) => (old != new).then_some((0, layout::POWER_BAR.width)),
        };
        self.mark_columns(POWER, changed);
    }

    /// Marks the parts of a bar with the columns from the first to before the second.
    fn mark_columns(&mut self, bar: usize, columns: Option<(u16, u16)>) {
        if let Some((from, to)) = columns {
            for part in from / layout::BAR_PART..to.div_ceil(layout::BAR_PART) {
                self.mark(bar + usize::from(part));
            }
        }
    }
}

fn bar_part(bar: Area, part: usize) -> Area {
    let x = bar.x + part as u16 * layout::BAR_PART;
    Area::new(x, bar.y, layout::BAR_PART.min(bar.right() - x), bar.height)
}

/// Returns the place of a part on a page of this kind.
fn area(part: usize, kind: Kind) -> Area {
    match part {
        BAND => layout::BAND,
        STRIPE => layout::STRIPE,
        TELLTALES..LIMITED => layout::telltale(Telltale::ALL[part - TELLTALES]),
        LIMITED => layout::LIMITED,
        GEAR => layout::GEAR,
        SPEED..FIGURES => {
            let x = layout::SPEED.x + (part - SPEED) as u16 * layout::SPEED_HALF;
            Area::new(x, layout::SPEED.y, layout::SPEED_HALF, layout::SPEED.height)
        }
        ELEMENTS..CHARGE => {
            kind.places().get(part - ELEMENTS).map_or(Area::new(0, 0, 0, 0), |place| place.area)
        }
        FIGURES..ELEMENTS => {
            let (field, place) = ((part - FIGURES) / MOST_FIGURES, (part - FIGURES) % MOST_FIGURES);
            let field = &FIELDS[field];
            field.area_of(u16::from(field.figures) - 1 - place as u16)
        }
        CHARGE..POWER => bar_part(layout::CHARGE_BAR, part - CHARGE),
        POWER..HEARTBEAT => bar_part(layout::POWER_BAR, part - POWER),
        HEARTBEAT => layout::HEARTBEAT,
        _ => {
            let (ring, place) = ((part - DIAL) / DIAL_PARTS, (part - DIAL) % DIAL_PARTS);
            let (x, y, width, height) = fonts::DIAL_PARTS[ring][place];
            Area::new(x, y, width, height)
        }
    }
}
