//! What is sent after a change: enough, and not much more.

mod common;

use cluster::{
    Page, Telltale, Telltales, Trip, View,
    view::{Charging, Journey, Language, Limp, List, Listed, Plug, Range, Sheet, Theme},
};
use common::{
    Panel, driving, english, lamps, line, list, missing, on, plugged, rectangle, sheets, travelled,
};
use embedded_graphics_core::primitives::PointsIter;
use protocol_core::model::{Gear, Severity, Shown};
use ui::{HEIGHT, Screen, TILE_PIXELS, WIDTH};

/// A small generator of random views; the sequence is the same in every run.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: u32) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as u32 % bound
    }

    fn one_in(&mut self, chance: u32) -> bool {
        self.below(chance) == 0
    }

    fn shown<T>(&mut self, low: i32, high: i32, convert: impl Fn(i32) -> T) -> Shown<T> {
        match self.below(10) {
            0 => Shown::Never,
            1 => Shown::Stale,
            2 => Shown::Invalid,
            _ => Shown::Value(convert(low + self.below((high - low + 1) as u32) as i32)),
        }
    }

    /// Changes some of the view, or all of it.
    fn change(&mut self, view: &mut View) {
        let chance = [1, 3, 12][self.below(3) as usize];
        self.change_one_in(chance, view);
    }

    /// Changes one or two fields, or none.
    fn nudge(&mut self, view: &mut View) {
        self.change_one_in(40, view);
    }

    fn change_one_in(&mut self, chance: u32, view: &mut View) {
        macro_rules! maybe {
            ($field:expr, $value:expr) => {
                if self.one_in(chance) {
                    $field = $value;
                }
            };
        }
        maybe!(view.speed_kmh, self.shown(0, 220, |v| v as u16));
        maybe!(view.soc_percent, self.shown(0, 100, |v| v as u8));
        maybe!(view.pack_decivolts, self.shown(-20, 12_000, |v| v));
        maybe!(view.pack_deciamps, self.shown(-12_000, 12_000, |v| v));
        maybe!(view.power_hectowatts, self.shown(-4_000, 4_000, |v| v));
        maybe!(view.motor_rpm, self.shown(-16_000, 16_000, |v| v));
        maybe!(view.motor_celsius, self.shown(-60, 240, |v| v));
        maybe!(view.inverter_celsius, self.shown(-60, 240, |v| v));
        maybe!(view.cell_millivolts.0, self.shown(0, 65_535, |v| v));
        maybe!(view.cell_millivolts.1, self.shown(0, 65_535, |v| v));
        maybe!(view.cell_celsius.0, self.shown(-60, 240, |v| v));
        maybe!(view.cell_celsius.1, self.shown(-60, 240, |v| v));
        maybe!(view.odometer_hectometres, self.below(20_000_000));
        maybe!(view.heartbeat, self.one_in(2));
        let gears = [None, Some(Gear::D), Some(Gear::R), Some(Gear::N), Some(Gear::P), Some(Gear::D3)];
        maybe!(view.gear, gears[self.below(6) as usize]);
        let severities = [Severity::None, Severity::Warn, Severity::Derate, Severity::Stop];
        maybe!(view.severity, severities[self.below(4) as usize]);
        for &lamp in Telltale::ALL {
            if self.one_in(chance * 2) {
                view.telltales.set(lamp, self.one_in(2));
            }
        }
        maybe!(view.is_power_limited, self.one_in(2));
        maybe!(view.is_charge_low, self.one_in(2));
        let texts = [
            ("绝缘故障", "Insulation fault"),
            ("电机过热 功率受限", "Motor too hot: power is limited"),
            ("门开", "Door"),
        ];
        let (zh, en) = texts[self.below(3) as usize];
        let severity = severities[self.below(4) as usize];
        let new = line(
            severity,
            zh,
            en,
            self.below(65_536) as u16,
            1 + self.below(12) as u8,
            1 + self.below(12) as u8,
        );
        maybe!(view.line, (new.code != Some(0)).then_some(new));
        self.change_pages(chance, view);
        if self.one_in(20) {
            view.theme = if self.one_in(2) { Theme::Day } else { Theme::Night };
        }
        if self.one_in(20) {
            view.language = if self.one_in(2) { Language::English } else { Language::Chinese };
        }
    }
}

impl Random {
    /// Turns the page or changes what stands on one.
    fn change_pages(&mut self, chance: u32, view: &mut View) {
        if self.one_in(chance * 4) {
            view.page = match self.below(7) {
                0 | 1 => Page::Main,
                2 => Page::Trip(if self.one_in(2) { Trip::A } else { Trip::B }),
                3 => Page::Energy,
                4 => Page::Faults(list()),
                5 => Page::History(List { position: 1, count: 1, ..List::default() }),
                _ => Page::Technic(sheets()[self.below(6) as usize]),
            };
        }
        match &mut view.page {
            Page::Faults(list) | Page::History(list) => {
                let row = self.below(4) as usize;
                list.rows[row] = (!self.one_in(4)).then(|| Listed {
                    code: (!self.one_in(3)).then(|| self.below(65_536) as u16),
                    count: self.below(3) as u16,
                    at_s: self.below(400_000),
                    ..common::list().rows[self.below(4) as usize].expect("a full list")
                });
                // Rows stand without gaps.
                list.rows.sort_by_key(Option::is_none);
                list.count = 1 + self.below(9) as u8;
            }
            Page::Technic(Sheet { values, .. }) => {
                let place = self.below(values.len() as u32) as usize;
                let high = [4, 5_000, i32::MAX - 1][self.below(3) as usize];
                values[place] = self.shown(0, high, |v| v);
            }
            Page::Main | Page::Trip(_) | Page::Energy => {}
        }
        let journey = |random: &mut Self| Journey {
            hectometres: random.below(2_000_000),
            average_whkm: (!random.one_in(3)).then(|| random.below(4_000) as i32 - 900),
            used_watthours: random.below(3_000_000),
            regained_watthours: random.below(3_000_000),
        };
        if self.one_in(chance) {
            view.journeys = [journey(self), journey(self)];
            view.consumption_whkm = self.shown(-900, 4_000, |v| v);
        }
        if self.one_in(chance) {
            let is_estimated = self.one_in(2);
            view.range = self.shown(0, 999, |km| Range { km: km as u16, is_estimated });
        }
        if self.one_in(chance) {
            let plugs = [Plug::Inserted, Plug::Charging, Plug::Complete, Plug::Fault];
            let plug = plugs[self.below(4) as usize];
            view.charging = (!self.one_in(3)).then(|| plugged(plug).charging).flatten();
            view.hv_off_s = self.one_in(3).then(|| self.below(36) as u8);
            let limit = self.below(601) as i32;
            view.limp = self.one_in(3).then(|| Limp { limit_deciamps: (limit > 9).then_some(limit) });
        }
    }
}

#[test]
fn updated_parts_and_a_full_redraw_give_the_same_picture() {
    let (mut random, mut view, mut screen) = (Random(1), View::default(), Screen::new());
    let mut panel = Panel::garbage();
    for round in 0..600 {
        random.change(&mut view);
        screen.update(&view);
        panel.receive(&mut screen, 320 * (1 + random.below(20) as usize));
        if let Some((x, y)) = panel.difference(&Panel::of(&view)) {
            panic!("round {round}: pixel ({x}, {y}) was not sent anew; view: {view:?}");
        }
    }
}

#[test]
fn updates_between_tiles_do_not_get_lost() {
    let (mut random, mut view, mut screen) = (Random(7), driving(), Screen::new());
    let mut panel = Panel::garbage();
    screen.update(&view);
    for round in 0..300 {
        random.change(&mut view);
        screen.update(&view);
        // Time for three tiles only, then the next values come.
        for _ in 0..3 {
            if let Some(area) = screen.next_tile(TILE_PIXELS) {
                panel.receive_tile(&screen, area);
            }
        }
        if round % 10 == 9 {
            panel.receive(&mut screen, TILE_PIXELS);
            assert_eq!(panel.difference(&Panel::of(&view)), None, "round {round}: {view:?}");
        }
    }
}

#[test]
fn any_region_can_be_painted_over_garbage() {
    let (mut random, view) = (Random(3), View { telltales: Telltales::ALL, ..driving() });
    let whole = Panel::of(&view);
    let mut screen = Screen::new();
    screen.update(&view);
    for _ in 0..400 {
        let (x, y) = (random.below(u32::from(WIDTH)), random.below(u32::from(HEIGHT)));
        let (width, height) =
            (1 + random.below(u32::from(WIDTH) - x), 1 + random.below((u32::from(HEIGHT) - y).min(40)));
        let area = rectangle(x as i32, y as i32, width, height);
        let mut panel = whole.clone();
        for point in area.points() {
            panel.pixels[point.y as usize * usize::from(WIDTH) + point.x as usize] ^= 0xA5A5;
        }
        panel.receive_tile(&screen, area);
        assert_eq!(panel.difference(&whole), None, "{area:?}");
    }
}

#[test]
fn views_that_look_the_same_have_the_same_picture() {
    let (mut random, mut view) = (Random(11), View::default());
    let (mut same, mut other) = (0, 0);
    for round in 0..20_000 {
        let before = view;
        // Few fields at a time, on any page.
        random.nudge(&mut view);
        if ui::looks_same(&before, &view) {
            same += 1;
            let mut screen = Screen::new();
            screen.update(&before);
            while screen.next_tile(TILE_PIXELS).is_some() {}
            screen.update(&view);
            assert_eq!(screen.next_tile(TILE_PIXELS), None, "round {round}: {before:?} and {view:?}");
        } else {
            other += 1;
        }
        if random.one_in(50) {
            random.change(&mut view);
        }
    }
    assert!(same > 2_000 && other > 2_000, "{same} and {other}");
}

#[test]
fn what_a_page_does_not_show_makes_no_view_look_different() {
    let driven = View {
        journeys: [Journey { used_watthours: 1, ..Journey::default() }; 2],
        consumption_whkm: Shown::Value(999),
        ..travelled()
    };
    assert!(ui::looks_same(&travelled(), &driven));
    let pages = [Page::Main, Page::Trip(Trip::A), Page::Energy, Page::Faults(list())];
    let differ = pages.map(|page| !ui::looks_same(&on(page, travelled()), &on(page, driven)));
    assert_eq!(differ, [false, true, true, false]);
    let faster = View { motor_rpm: Shown::Value(9_000), ..travelled() };
    let differ = pages.map(|page| !ui::looks_same(&on(page, travelled()), &on(page, faster)));
    assert_eq!(differ, [true, false, false, false]);
    for page in pages {
        let faster = View { speed_kmh: Shown::Value(99), ..travelled() };
        assert!(!ui::looks_same(&on(page, travelled()), &on(page, faster)), "{page:?}");
    }
}

#[test]
fn the_same_view_sends_nothing() {
    let mut screen = Screen::new();
    screen.update(&driving());
    Panel::garbage().receive(&mut screen, TILE_PIXELS);
    screen.update(&driving());
    assert_eq!(screen.next_tile(TILE_PIXELS), None);
}

#[test]
fn a_page_sends_nothing_of_what_it_does_not_show() {
    for page in [Page::Trip(Trip::A), Page::Faults(list()), Page::Technic(sheets()[0])] {
        let mut screen = Screen::new();
        screen.update(&on(page, driving()));
        Panel::garbage().receive(&mut screen, TILE_PIXELS);
        let other = View {
            motor_rpm: Shown::Value(9_000),
            soc_percent: Shown::Value(3),
            pack_deciamps: Shown::Value(1),
            power_hectowatts: Shown::Value(1_000),
            motor_celsius: Shown::Value(99),
            odometer_hectometres: 1,
            consumption_whkm: Shown::Value(999),
            ..driving()
        };
        screen.update(&on(page, other));
        assert_eq!(screen.next_tile(TILE_PIXELS), None, "{page:?}");
    }
}

#[test]
fn a_turned_page_sends_the_middle_of_the_screen_and_nothing_else() {
    let mut screen = Screen::new();
    screen.update(&travelled());
    let mut panel = Panel::garbage();
    panel.receive(&mut screen, TILE_PIXELS);
    for page in [Page::Trip(Trip::A), Page::Faults(list()), Page::Technic(sheets()[4]), Page::Main] {
        screen.update(&on(page, travelled()));
        let tiles: Vec<_> = std::iter::from_fn(|| screen.next_tile(TILE_PIXELS)).collect();
        let rows: u32 = tiles.iter().map(|tile| tile.size.height).sum();
        assert_eq!((tiles[0].top_left.y, rows), (26, 163), "{page:?}");
        assert!(tiles.iter().all(|tile| tile.size.width == u32::from(WIDTH)));
    }
}

#[test]
fn a_stop_that_turns_the_page_goes_out_before_the_page() {
    let mut screen = Screen::new();
    screen.update(&on(Page::Trip(Trip::A), driving()));
    Panel::garbage().receive(&mut screen, TILE_PIXELS);
    screen.update(&View {
        telltales: lamps(&[Telltale::Insulation]),
        severity: Severity::Stop,
        line: Some(line(Severity::Stop, "绝缘故障", "Insulation fault", 11, 1, 1)),
        ..driving()
    });
    let tiles: Vec<_> = std::iter::from_fn(|| screen.next_tile(TILE_PIXELS)).collect();
    let page = tiles.iter().position(|tile| tile.top_left.y == 26).expect("the page");
    let lamp = tiles.iter().position(|tile| (187..213).contains(&tile.top_left.y)).expect("the lamp");
    let band = tiles.iter().position(|tile| tile.top_left.y >= 213).expect("the line");
    assert!(band < lamp && lamp < page, "band {band}, lamp {lamp}, page {page}");
}

#[test]
fn a_page_turned_twice_before_it_is_sent_is_whole_in_the_end() {
    let (mut screen, mut panel) = (Screen::new(), Panel::garbage());
    screen.update(&driving());
    panel.receive(&mut screen, TILE_PIXELS);
    let pages = [Page::Trip(Trip::A), Page::Faults(list()), Page::Energy, Page::Main];
    for page in pages {
        screen.update(&on(page, travelled()));
        // The upper half only, then the next push comes.
        for _ in 0..5 {
            let area = screen.next_tile(TILE_PIXELS).expect("there is more");
            panel.receive_tile(&screen, area);
        }
    }
    panel.receive(&mut screen, TILE_PIXELS);
    assert_eq!(panel.difference(&Panel::of(&travelled())), None);
}

#[test]
fn a_reset_panel_gets_the_whole_picture_again() {
    let mut screen = Screen::new();
    screen.update(&driving());
    Panel::garbage().receive(&mut screen, TILE_PIXELS);
    screen.mark_all();
    let mut panel = Panel::garbage();
    panel.receive(&mut screen, TILE_PIXELS);
    assert_eq!(panel.difference(&Panel::of(&driving())), None);
}

#[test]
fn a_fault_goes_out_before_the_speed() {
    let mut screen = Screen::new();
    screen.update(&driving());
    Panel::garbage().receive(&mut screen, TILE_PIXELS);
    screen.update(&View {
        speed_kmh: Shown::Value(99),
        motor_rpm: Shown::Value(9000),
        telltales: lamps(&[Telltale::Insulation]),
        severity: Severity::Stop,
        line: Some(line(Severity::Stop, "绝缘故障", "Insulation fault", 11, 1, 1)),
        ..driving()
    });
    let tiles: Vec<_> = std::iter::from_fn(|| screen.next_tile(TILE_PIXELS)).collect();
    let band = tiles.iter().rposition(|tile| tile.top_left.y >= 213).unwrap();
    let lamp = tiles.iter().position(|tile| (187..213).contains(&tile.top_left.y)).unwrap();
    let speed = tiles.iter().position(|tile| tile.top_left.y == 73).unwrap();
    assert!(band < lamp && lamp < speed, "band {band}, lamp {lamp}, speed {speed}");
}

/// Zero, never seen, stale and not valid must be four different pictures wherever a number stands.
#[test]
fn bus_missing_values_differ_from_zero_and_from_each_other() {
    let zero = View {
        speed_kmh: Shown::Value(0),
        soc_percent: Shown::Value(0),
        pack_decivolts: Shown::Value(0),
        pack_deciamps: Shown::Value(0),
        power_hectowatts: Shown::Value(0),
        motor_rpm: Shown::Value(0),
        motor_celsius: Shown::Value(0),
        inverter_celsius: Shown::Value(0),
        cell_millivolts: (Shown::Value(0), Shown::Value(0)),
        cell_celsius: (Shown::Value(0), Shown::Value(0)),
        ..View::default()
    };
    let kinds =
        [zero, View::default(), missing::<true>(zero), missing::<false>(zero)].map(|view| Panel::of(&view));
    // One window around the figures of each number: speed, charge, power, voltage, current, two temperatures, motor
    // speed, cells.
    let windows = [
        (85, 74, 150, 78),
        (18, 29, 42, 22),
        (238, 29, 56, 22),
        (6, 85, 42, 14),
        (6, 109, 42, 14),
        (276, 94, 24, 14),
        (276, 130, 24, 14),
        (124, 172, 48, 14),
        (14, 161, 24, 12),
        (14, 175, 24, 12),
        (40, 161, 21, 12),
        (40, 175, 21, 12),
    ];
    for (x, y, width, height) in windows {
        let cut = |panel: &Panel| -> Vec<u16> {
            (y..y + height)
                .flat_map(|y| (x..x + width).map(move |x| y * usize::from(WIDTH) + x))
                .map(|at| panel.pixels[at])
                .collect()
        };
        for (first, a) in kinds.iter().enumerate() {
            for (second, b) in kinds.iter().enumerate().skip(first + 1) {
                let differing = cut(a).iter().zip(cut(b)).filter(|(a, b)| **a != *b).count();
                assert!(
                    differing >= 8,
                    "window ({x}, {y}): kinds {first} and {second} differ in {differing} pixels only"
                );
            }
        }
    }
}

/// Where lamps are: two rows from side to side.
const LAMP_ROWS: [(i32, i32, u32, u32); 2] = [(0, 2, 320, 22), (0, 189, 320, 22)];

#[test]
fn the_lamps_check_lights_lamps_and_changes_no_word_and_no_bar() {
    let page = |page| View { telltales: Telltales::NONE, ..on(page, driving()) };
    for dark in [page(Page::Main), page(Page::Energy), page(Page::Trip(Trip::A))] {
        for dark in [dark, english(dark)] {
            let lit = View { telltales: Telltales::ALL, ..dark };
            let (dark, lit) = (Panel::of(&dark), Panel::of(&lit));
            for (at, _) in dark.pixels.iter().zip(&lit.pixels).enumerate().filter(|(_, (a, b))| a != b) {
                let (x, y) = ((at % usize::from(WIDTH)) as i32, (at / usize::from(WIDTH)) as i32);
                let is_lamp = LAMP_ROWS.iter().any(|&(left, top, width, height)| {
                    rectangle(left, top, width, height)
                        .contains(embedded_graphics_core::geometry::Point::new(x, y))
                });
                assert!(is_lamp, "({x}, {y}) is no lamp and changes with the check");
            }
        }
    }
}

#[test]
fn bus_r024_and_bus_r025_a_limit_has_its_words_without_its_lamp() {
    let windows = [(250, 62, 64, 15), (240, 90, 80, 60)];
    let limited = View { is_power_limited: true, ..driving() };
    assert_eq!(changed(&driving(), &limited, &windows), [true, false]);
}

#[test]
fn a_low_charge_is_yellow_in_the_bar_of_the_main_page_and_of_the_charge() {
    let low = |view| View { is_charge_low: true, ..view };
    assert_eq!(changed(&driving(), &low(driving()), &[(6, 55, 68, 6), (6, 64, 68, 120)]), [true, false]);
    let energy = on(Page::Energy, driving());
    assert_eq!(changed(&energy, &low(energy), &[(10, 53, 294, 3), (10, 59, 294, 120)]), [true, false]);
}

#[test]
fn bus_r015_without_gear_there_is_no_gear_letter() {
    let panel = Panel::of(&View { gear: None, ..driving() });
    let ground = panel.pixels[0];
    for y in 46..68 {
        for x in 146..174 {
            assert_eq!(panel.pixels[y * usize::from(WIDTH) + x], ground, "({x}, {y})");
        }
    }
}

/// Returns the windows among `windows` in which two views look different.
fn changed(from: &View, to: &View, windows: &[(i32, i32, u32, u32)]) -> Vec<bool> {
    let (from, to) = (Panel::of(from), Panel::of(to));
    let differs = |&(x, y, width, height): &(i32, i32, u32, u32)| {
        rectangle(x, y, width, height).points().any(|point| {
            let at = point.y as usize * usize::from(WIDTH) + point.x as usize;
            from.pixels[at] != to.pixels[at]
        })
    };
    windows.iter().map(differs).collect()
}

/// The speed's figures, its ring, the motor speed's figures and its ring, left of the centre.
const DIAL: [(i32, i32, u32, u32); 4] =
    [(105, 80, 110, 60), (63, 118, 8, 14), (124, 172, 48, 14), (75, 118, 3, 14)];

#[test]
fn bus_r020_the_speed_moves_its_figures_and_its_pointer() {
    let slow = View { speed_kmh: Shown::Value(20), ..driving() };
    assert_eq!(changed(&slow, &driving(), &DIAL), [true, true, false, false]);
}

#[test]
fn bus_r057_the_motor_speed_moves_its_figures_and_its_pointer() {
    let slow = View { motor_rpm: Shown::Value(900), ..driving() };
    assert_eq!(changed(&slow, &driving(), &DIAL), [false, false, true, true]);
}

#[test]
fn bus_r058_motor_and_controller_temperature_stand_on_the_main_screen() {
    let windows = [(276, 94, 24, 14), (276, 130, 24, 14)];
    let motor = View { motor_celsius: Shown::Value(75), ..driving() };
    let inverter = View { inverter_celsius: Shown::Value(59), ..driving() };
    assert_eq!(changed(&motor, &driving(), &windows), [true, false]);
    assert_eq!(changed(&inverter, &driving(), &windows), [false, true]);
}

#[test]
fn bus_r071_highest_and_lowest_cell_stand_on_the_main_screen() {
    let windows = [(14, 161, 24, 12), (14, 175, 24, 12), (40, 161, 21, 12), (40, 175, 21, 12)];
    let view = driving();
    let changes = [
        View { cell_millivolts: (Shown::Value(3400), view.cell_millivolts.1), ..view },
        View { cell_millivolts: (view.cell_millivolts.0, Shown::Value(3200)), ..view },
        View { cell_celsius: (Shown::Value(40), view.cell_celsius.1), ..view },
        View { cell_celsius: (view.cell_celsius.0, Shown::Value(20)), ..view },
    ];
    for (place, change) in changes.iter().enumerate() {
        let expected: Vec<bool> = (0..windows.len()).map(|window| window == place).collect();
        assert_eq!(changed(change, &view, &windows), expected, "window {place}");
    }
}

fn countdown(seconds: u8) -> View {
    View {
        hv_off_s: Some(seconds),
        line: Some(line(Severity::Stop, "断高压", "Battery asks for HV off", 1, 1, 1)),
        ..driving()
    }
}

/// Prints what a change costs on the bus, and holds it to a budget in pixels.
#[test]
fn small_changes_send_few_pixels() {
    let speed = |kmh| View { speed_kmh: Shown::Value(kmh), ..driving() };
    let rows: &[(&str, View, View, usize)] = &[
        ("heartbeat", driving(), View { heartbeat: false, ..driving() }, 25),
        ("speed 62 -> 63", speed(62), speed(63), 5_000),
        ("speed 59 -> 60", speed(59), speed(60), 9_500),
        ("speed 9 -> 10", speed(9), speed(10), 13_500),
        ("speed 99 -> 100", speed(99), speed(100), 13_500),
        ("motor speed +10 rpm", driving(), View { motor_rpm: Shown::Value(4880), ..driving() }, 700),
        ("power +1 kW", driving(), View { power_hectowatts: Shown::Value(351), ..driving() }, 500),
        ("one lamp", driving(), View { telltales: lamps(&[Telltale::Ready]), ..driving() }, 484),
        (
            "message",
            driving(),
            View { line: Some(line(Severity::Stop, "门开", "Door", 1, 1, 1)), ..driving() },
            7_680,
        ),
        ("language", driving(), english(driving()), 76_800),
        ("page", driving(), on(Page::Trip(Trip::A), driving()), 52_160),
        (
            "range -1 km",
            travelled(),
            View { range: Shown::Value(Range { km: 181, is_estimated: true }), ..travelled() },
            992,
        ),
        (
            "trip +0.1 km",
            on(Page::Trip(Trip::A), driving()),
            on(
                Page::Trip(Trip::A),
                View { journeys: [Journey { hectometres: 1, ..Journey::default() }; 2], ..driving() },
            ),
            3_600,
        ),
        (
            "charge power",
            plugged(Plug::Charging),
            View {
                charging: plugged(Plug::Charging)
                    .charging
                    .map(|charging| Charging { hectowatts: Shown::Value(650), ..charging }),
                ..plugged(Plug::Charging)
            },
            3_600,
        ),
        ("countdown", countdown(28), countdown(27), 7_680),
    ];
    println!("{:<22}{:>8}{:>9}{:>12}", "change", "windows", "pixels", "ms at 62.5");
    for (name, from, to, budget) in rows {
        let (mut screen, mut panel) = (Screen::new(), Panel::garbage());
        screen.update(from);
        panel.receive(&mut screen, TILE_PIXELS);
        screen.update(to);
        panel.receive(&mut screen, TILE_PIXELS);
        // 16 bits per pixel and 11 bytes of window commands at 62.5 Mbit/s.
        let bits = panel.sent * 16 + panel.windows * 88;
        println!("{name:<22}{:>8}{:>9}{:>12.2}", panel.windows, panel.sent, bits as f64 / 62_500.0);
        assert!(panel.sent <= *budget, "{name}: {} pixels, budget {budget}", panel.sent);
    }
}

#[test]
fn a_screen_takes_less_than_four_kilobytes() {
    let size = size_of::<Screen>();
    println!("Screen: {size} bytes");
    assert!(size < 4096, "{size}");
}
