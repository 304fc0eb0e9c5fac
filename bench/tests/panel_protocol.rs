//! The panel model against sentences of the ILI9341 and ST7789 datasheets.

use bench::chips::panel::{BACKLIGHT_FULL, COLUMNS, Config, HEIGHT, PAGES, Panel, Violation, WIDTH};
use bench::time::Nanos;
use proptest::prelude::*;

const MV: u8 = 0x20;
const MX: u8 = 0x40;
const MY: u8 = 0x80;
const BGR: u8 = 0x08;

struct Rig {
    panel: Panel,
    now: Nanos,
}

impl Rig {
    fn new(config: Config) -> Self {
        let mut panel = Panel::new(config, Nanos::ZERO);
        panel.select(Nanos::ZERO, true);
        panel.set_backlight(BACKLIGHT_FULL);
        Self { panel, now: Nanos::from_millis(5) }
    }

    /// Awake, 16-bit colour, display on, `madctl`.
    fn running(config: Config, madctl: u8) -> Self {
        let mut rig = Self::new(config);
        rig.command(0x11, &[]);
        rig.wait_ms(120);
        rig.command(0x3A, &[0x55]);
        rig.command(0x36, &[madctl]);
        rig.command(0x29, &[]);
        rig
    }

    fn word(&mut self, data: bool, word: u16, bits: u8) -> u16 {
        self.now += Nanos(u64::from(bits) * 16);
        self.panel.data_command(self.now, data);
        self.panel.exchange(self.now, word, bits)
    }

    fn command(&mut self, code: u8, parameters: &[u8]) {
        self.word(false, u16::from(code), 8);
        for &byte in parameters {
            self.word(true, u16::from(byte), 8);
        }
    }

    fn window(&mut self, columns: (u16, u16), pages: (u16, u16)) {
        for (code, (start, end)) in [(0x2A, columns), (0x2B, pages)] {
            self.command(code, &[start.to_be_bytes(), end.to_be_bytes()].concat());
        }
    }

    fn pixels(&mut self, colours: impl IntoIterator<Item = u16>) {
        self.command(0x2C, &[]);
        for colour in colours {
            self.word(true, colour, 16);
        }
    }

    fn wait_ms(&mut self, ms: u64) {
        self.now += Nanos::from_millis(ms);
    }

    fn violations(&self) -> Vec<Violation> {
        self.panel.violations().first().iter().map(|&(_, violation)| violation).collect()
    }
}

#[test]
fn the_memory_powers_up_as_noise_and_the_glass_is_dark() {
    let panel = Panel::new(Config::ILI9341, Nanos::ZERO);
    assert_eq!(panel.visible(Nanos::from_secs(1)), None);
    assert_eq!(panel.undrawn_pixels(), 76_800);
    let colours: std::collections::HashSet<u16> =
        (0..COLUMNS).map(|column| panel.memory(column, 7)).collect();
    assert!(colours.len() > 200, "noise, not a flat colour");
    let again = Panel::new(Config::ILI9341, Nanos::ZERO);
    assert_eq!(panel.glass(), again.glass(), "the same noise in every run");
}

#[test]
fn a_picture_needs_sleep_out_display_on_and_light() {
    let mut rig = Rig::new(Config::ILI9341);
    rig.command(0x11, &[]);
    let awake = rig.now;
    rig.wait_ms(10);
    rig.command(0x29, &[]);
    assert_eq!(rig.panel.visible(awake + Nanos::from_millis(119)), None, "not steady before 120 ms");
    let later = awake + Nanos::from_millis(120);
    assert!(rig.panel.visible(later).is_some());
    rig.panel.set_backlight(0);
    assert_eq!(rig.panel.visible(later), None);
    rig.panel.set_backlight(1);
    assert!(rig.panel.visible(later).is_some());
    rig.command(0x28, &[]);
    assert_eq!(rig.panel.visible(later), None);
}

#[test]
fn commands_within_five_milliseconds_of_reset_and_sleep_changes_are_reported() {
    let mut rig = Rig::new(Config::ILI9341);
    rig.now = Nanos::from_millis(1);
    rig.command(0x00, &[]);
    assert!(matches!(rig.violations()[..], [Violation::TooSoon { command: 0x00, .. }]));
    rig.panel.violations_mut().clear();
    rig.wait_ms(5);
    rig.command(0x11, &[]);
    rig.wait_ms(4);
    rig.command(0x29, &[]);
    assert!(matches!(rig.violations()[..], [Violation::TooSoon { command: 0x29, .. }]));
}

#[test]
fn sleep_in_and_sleep_out_need_120_milliseconds_between_them() {
    for (wait, fine) in [(119, false), (121, true)] {
        let mut rig = Rig::new(Config::ILI9341);
        rig.command(0x11, &[]);
        rig.wait_ms(wait);
        rig.command(0x10, &[]);
        assert_eq!(rig.panel.violations().is_empty(), fine);
        rig.panel.violations_mut().clear();
        rig.wait_ms(wait);
        rig.command(0x11, &[]);
        assert_eq!(rig.panel.violations().is_empty(), fine);
    }
}

#[test]
fn a_reset_out_of_sleep_out_needs_120_milliseconds_a_reset_in_sleep_only_five() {
    for (awake_first, wait, fine) in
        [(true, 20, false), (true, 121, true), (false, 6, true), (false, 4, false)]
    {
        let mut rig = Rig::new(Config::ILI9341);
        if awake_first {
            rig.command(0x11, &[]);
            rig.wait_ms(200);
        }
        rig.command(0x01, &[]);
        assert!(!rig.panel.is_awake());
        rig.wait_ms(wait);
        rig.command(0x11, &[]);
        assert_eq!(rig.panel.violations().is_empty(), fine, "awake {awake_first}, {wait} ms");
    }
}

#[test]
fn the_reset_pin_wants_ten_microseconds_and_silence() {
    let mut rig = Rig::running(Config::ILI9341, MV);
    rig.panel.reset(rig.now, false);
    rig.command(0x00, &[]);
    rig.panel.reset(rig.now + Nanos(9_000), true);
    assert!(rig.panel.is_awake(), "too short, ignored");
    assert!(matches!(rig.violations()[..], [Violation::InReset, Violation::ResetTooShort(_)]));
    rig.panel.reset(rig.now + Nanos(20_000), false);
    rig.panel.reset(rig.now + Nanos(30_000), true);
    assert!(!rig.panel.is_awake());
}

#[test]
fn a_window_fills_row_by_row_and_wraps_to_its_start() {
    let mut rig = Rig::running(Config::ILI9341, MV | BGR);
    rig.window((10, 12), (20, 21));
    rig.pixels(1..=7);
    let row = |y: u16| [10, 11, 12].map(|x| rig.panel.colour_at(x, y));
    assert_eq!((row(20), row(21)), ([7, 2, 3], [4, 5, 6]));
    let counters = rig.panel.counters();
    assert_eq!((counters.windows, counters.pixels, counters.wraps), (1, 7, 1));
    assert_eq!(rig.panel.undrawn_pixels(), 76_800 - 6);
    assert_eq!(rig.panel.written_at(10, 20), Some(rig.now));
    assert_eq!(rig.panel.last_change(), Some(rig.now));
    assert!(rig.panel.violations().is_empty(), "{}", rig.panel.violations());
}

#[test]
fn ramwr_starts_over_and_ramwrc_goes_on() {
    let mut rig = Rig::running(Config::ILI9341, MV);
    rig.window((0, 2), (0, 0));
    rig.pixels([1]);
    rig.command(0x3C, &[0, 2]);
    rig.pixels([9]);
    assert_eq!([0, 1].map(|x| rig.panel.colour_at(x, 0)), [9, 2]);
}

#[test]
fn eight_and_sixteen_bit_words_draw_the_same_and_may_mix() {
    let mut rig = Rig::running(Config::ILI9341, MV);
    rig.window((0, 3), (0, 0));
    rig.command(0x2C, &[0x12, 0x34, 0x56]);
    rig.word(true, 0x789A, 16);
    rig.word(true, 0xBC, 8);
    rig.word(true, 0xDEF0, 16);
    assert_eq!([0, 1, 2, 3].map(|x| rig.panel.colour_at(x, 0)), [0x1234, 0x5678, 0x9ABC, 0xDEF0]);
}

#[test]
fn cs_pauses_do_not_end_a_memory_write() {
    let mut rig = Rig::running(Config::ILI9341, MV);
    rig.window((0, 1), (0, 0));
    rig.command(0x2C, &[]);
    for colour in [0x1111, 0x2222] {
        rig.panel.select(rig.now, false);
        rig.panel.select(rig.now, true);
        rig.word(true, colour, 16);
    }
    assert_eq!([0, 1].map(|x| rig.panel.colour_at(x, 0)), [0x1111, 0x2222]);
}

#[test]
fn madctl_maps_the_window_as_the_write_direction_table_says() {
    // Address (1, 2) lands here (column, page) in a memory of 240 x 320.
    let table = [
        (0, (1, 2)),
        (MY, (1, 317)),
        (MX, (238, 2)),
        (MX | MY, (238, 317)),
        (MV, (2, 1)),
        (MV | MY, (2, 318)),
        (MV | MX, (237, 1)),
        (MV | MX | MY, (237, 318)),
    ];
    for (madctl, (column, page)) in table {
        let mut rig = Rig::running(Config::ILI9341, madctl);
        rig.window((1, 1), (2, 2));
        rig.pixels([0xABCD]);
        assert_eq!(rig.panel.memory(column, page), 0xABCD, "MADCTL {madctl:#04x}");
    }
}

#[test]
fn colours_are_true_when_order_and_inversion_fit_the_glass() {
    for (config, madctl, invert, red_shows_as) in [
        (Config::ILI9341, MV | BGR, false, [255, 0, 0]),
        (Config::ILI9341, MV, false, [0, 0, 255]),
        (Config::ILI9341, MV | BGR, true, [0, 255, 255]),
        (Config::ST7789, MV | MX, true, [255, 0, 0]),
        (Config::ST7789, MV | MX | BGR, true, [0, 0, 255]),
        (Config::ST7789, MV | MX, false, [0, 255, 255]),
    ] {
        let mut rig = Rig::running(config, madctl);
        rig.command(if invert { 0x21 } else { 0x20 }, &[]);
        rig.window((0, 0), (0, 0));
        rig.pixels([0xF800]);
        let picture = rig.panel.visible(rig.now).expect("lit");
        assert_eq!(picture.pixel(0, 0), Some(red_shows_as), "{:?} {madctl:#04x} {invert}", config.controller);
    }
}

#[test]
fn a_window_outside_the_memory_is_reported_and_ignored() {
    let mut rig = Rig::running(Config::ILI9341, MV);
    rig.window((0, 1), (0, 1));
    rig.window((0, 320), (5, 4));
    assert_eq!(
        rig.violations(),
        [
            Violation::Window { command: 0x2A, start: 0, end: 320 },
            Violation::Window { command: 0x2B, start: 5, end: 4 }
        ]
    );
    rig.pixels([1, 2, 3]);
    assert_eq!(rig.panel.colour_at(0, 1), 3, "the old window stands");
}

#[test]
fn pixels_before_colmod_and_in_18_bit_are_reported_once_per_write() {
    for format in [None, Some(0x66), Some(0x53)] {
        let mut rig = Rig::new(Config::ST7789);
        if let Some(format) = format {
            rig.command(0x3A, &[format]);
        }
        rig.window((0, 1), (0, 1));
        rig.pixels([1, 2, 3, 4]);
        assert_eq!(rig.violations(), [Violation::PixelFormat(format.unwrap_or(0x66))]);
        assert_eq!(rig.panel.undrawn_pixels(), 76_800);
    }
}

#[test]
fn manufacturers_commands_are_recorded_and_unknown_ones_reported() {
    let mut rig = Rig::new(Config::ILI9341);
    rig.command(0xCF, &[0x00, 0xC1, 0x30]);
    rig.command(0xE0, &[0x0F; 15]);
    rig.command(0x26, &[0x01]);
    assert!(rig.panel.violations().is_empty());
    let recorded: Vec<(u8, usize)> = rig.panel.recorded().map(|(code, bytes)| (code, bytes.len())).collect();
    assert_eq!(recorded, [(0xCF, 3), (0xE0, 15), (0x26, 1)]);
    rig.command(0x99, &[1]);
    rig.command(0x33, &[0; 6]);
    rig.command(0xB6, &[0x08, 0xA2, 0x27]);
    rig.command(0x13, &[1]);
    assert_eq!(
        rig.violations(),
        [
            Violation::UnknownCommand(0x99),
            Violation::NotModelled(0x33),
            Violation::ParameterNotModelled { command: 0xB6, value: 0xA2 },
            Violation::UnexpectedData { command: 0x13 },
        ]
    );
}

#[test]
fn words_to_nobody_and_words_of_odd_size_are_reported() {
    let mut rig = Rig::new(Config::ILI9341);
    rig.word(false, 0, 12);
    rig.panel.select(rig.now, false);
    rig.word(false, 0, 8);
    assert_eq!(rig.violations(), [Violation::WordSize(12), Violation::NotSelected]);
}

#[test]
fn power_mode_madctl_and_colmod_read_back() {
    let mut rig = Rig::running(Config::ILI9341, MV | BGR);
    for (command, value) in [(0x0A, 0x9C), (0x0B, MV | BGR), (0x0C, 0x55)] {
        rig.word(false, command, 8);
        assert_eq!(rig.word(true, 0, 8) as u8, value);
    }
    assert!(rig.panel.violations().is_empty());
}

#[test]
fn clear_then_draw_in_one_picture_is_flicker_and_what_moves_from_picture_to_picture_is_not() {
    let mut rig = Rig::running(Config::ILI9341, MV);
    // Paints ten by ten pixels in each of the colours, one after the other, as one picture.
    let mut picture = |colours: &[u16]| {
        rig.panel.select(rig.now, false);
        rig.panel.select(rig.now, true);
        for &colour in colours {
            rig.window((0, 9), (0, 9));
            rig.pixels([colour; 100]);
        }
        rig.panel.flickered_pixels()
    };
    assert_eq!(picture(&[0xFFFF]), 0, "the first");
    assert_eq!(picture(&[0xFFFF]), 0, "the same again");
    assert_eq!(picture(&[0x0000]), 0, "another");
    assert_eq!(picture(&[0xFFFF]), 0, "the first again, however soon: a lamp blinks, a figure changes");
    assert_eq!(picture(&[0x0000, 0xFFFF]), 100, "cleared, then drawn: the eye saw the ground");
    assert_eq!(picture(&[0x0000, 0x1111, 0xFFFF]), 200, "by way of two colours");
    assert_eq!(picture(&[0xFFFF, 0xFFFF]), 200, "written twice and never changed: waste, not flicker");
    assert_eq!(picture(&[0x1111, 0x2222]), 200, "the picture before had another colour");
    assert_eq!(picture(&[0x1111, 0x2222, 0x1111, 0x2222]), 400, "twice in one picture");
}

#[test]
fn a_part_of_a_picture_that_is_painted_again_flickers_where_it_changed() {
    let mut rig = Rig::running(Config::ILI9341, MV);
    rig.window((0, 9), (0, 9));
    rig.pixels([0x1111; 100]);
    rig.panel.select(rig.now, false);
    rig.panel.select(rig.now, true);
    // The page, with the old figure in it; then the new figure, which has the old page's colour in some pixels.
    rig.pixels([0x2222; 100]);
    rig.window((2, 4), (2, 4));
    rig.pixels([0x1111, 0x1111, 0x3333, 0x1111, 0x3333, 0x3333, 0x2222, 0x2222, 0x2222]);
    assert_eq!(rig.panel.flickered_pixels(), 3);
    assert_eq!(rig.panel.changed_pixels(), 100 + 100 + 6);
}

#[test]
fn a_picture_becomes_a_png_of_the_same_pixels() {
    let rig = Rig::running(Config::ILI9341, MV);
    let picture = rig.panel.glass();
    let file = picture.png().unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    assert_eq!(pixels, picture.rgb);
    assert_eq!((picture.width, picture.height), (u32::from(WIDTH), u32::from(HEIGHT)));
}

proptest! {
    #[test]
    fn no_stream_of_words_makes_the_model_panic(
        words in prop::collection::vec((any::<bool>(), any::<u16>(), prop_oneof![Just(8u8), Just(16)]), 0..400),
    ) {
        let mut rig = Rig::new(Config::ST7789);
        for (data, word, bits) in words {
            rig.word(data, word, bits);
        }
        rig.panel.visible(rig.now);
    }

    #[test]
    fn every_memory_cell_is_reached_under_every_orientation(madctl in (0..8u8).prop_map(|bits| bits << 5)) {
        let mut rig = Rig::running(Config::ILI9341, madctl);
        let (columns, pages) = if madctl & MV != 0 { (PAGES, COLUMNS) } else { (COLUMNS, PAGES) };
        rig.window((0, columns - 1), (0, pages - 1));
        rig.pixels(std::iter::repeat_n(0x1234, 76_800));
        prop_assert_eq!(rig.panel.undrawn_pixels(), 0);
        prop_assert_eq!(rig.panel.counters().wraps, 0);
    }
}
