//! mipidsi 0.10, a driver by other hands, draws on the panel model; the picture comes back pixel for pixel.

use std::cell::RefCell;
use std::convert::Infallible;
use std::rc::Rc;

use bench::chips::panel::{BACKLIGHT_FULL, COLUMNS, Config, HEIGHT, PAGES, Panel, Violation, WIDTH};
use bench::time::Nanos;
use embedded_graphics_core::pixelcolor::Rgb565;
use embedded_graphics_core::pixelcolor::raw::RawU16;
use embedded_graphics_core::prelude::*;
use embedded_graphics_core::primitives::Rectangle;
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::{ErrorType as PinErrorType, OutputPin};
use embedded_hal::spi::{ErrorType, Operation, SpiDevice};
use mipidsi::interface::SpiInterface;
use mipidsi::models::{ILI9341Rgb565, Model, ST7789};
use mipidsi::options::{ColorInversion, ColorOrder, Orientation, Rotation};
use mipidsi::{Builder, Display};

struct Rig {
    panel: Panel,
    now: Nanos,
}

#[derive(Clone)]
struct Shared(Rc<RefCell<Rig>>);

impl ErrorType for Shared {
    type Error = Infallible;
}

impl SpiDevice for Shared {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        let rig = &mut *self.0.borrow_mut();
        rig.panel.select(rig.now, true);
        for operation in operations {
            let Operation::Write(bytes) = operation else { panic!("mipidsi only writes") };
            for &byte in *bytes {
                rig.now += Nanos(128); // 62.5 MHz
                rig.panel.exchange(rig.now, u16::from(byte), 8);
            }
        }
        rig.panel.select(rig.now, false);
        Ok(())
    }
}

impl DelayNs for Shared {
    fn delay_ns(&mut self, ns: u32) {
        self.0.borrow_mut().now += Nanos(u64::from(ns));
    }
}

/// Pins of the panel.
enum Pin {
    DataCommand(Shared),
    Reset(Shared),
}

impl PinErrorType for Pin {
    type Error = Infallible;
}

impl Pin {
    fn set(&mut self, high: bool) {
        match self {
            Self::DataCommand(shared) => {
                let rig = &mut *shared.0.borrow_mut();
                rig.panel.data_command(rig.now, high);
            }
            Self::Reset(shared) => {
                let rig = &mut *shared.0.borrow_mut();
                rig.panel.reset(rig.now, high);
            }
        }
    }
}

impl OutputPin for Pin {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.set(false);
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.set(true);
        Ok(())
    }
}

type Driver<M> = Display<SpiInterface<'static, Shared, Pin>, M, Pin>;

fn driver<M: Model<ColorFormat = Rgb565>>(
    model: M,
    config: Config,
    orientation: Orientation,
    colours: (ColorOrder, ColorInversion),
) -> (Driver<M>, Shared) {
    let mut panel = Panel::new(config, Nanos::ZERO);
    panel.set_backlight(BACKLIGHT_FULL);
    let shared = Shared(Rc::new(RefCell::new(Rig { panel, now: Nanos::from_millis(10) })));
    let buffer = Vec::leak(vec![0; 512]);
    let interface = SpiInterface::new(shared.clone(), Pin::DataCommand(shared.clone()), buffer);
    let display = Builder::new(model, interface)
        .reset_pin(Pin::Reset(shared.clone()))
        .orientation(orientation)
        .color_order(colours.0)
        .invert_colors(colours.1)
        .init(&mut shared.clone())
        .unwrap();
    (display, shared)
}

/// A picture in which no two rotations or mirror images are alike.
fn test_colour(x: u32, y: u32) -> u16 {
    (x.wrapping_mul(2_654_435_761) ^ y.wrapping_mul(40_503)) as u16
}

fn draw<M: Model<ColorFormat = Rgb565>>(display: &mut Driver<M>) -> Size {
    let size = display.size();
    let colours = (0..size.height)
        .flat_map(|y| (0..size.width).map(move |x| Rgb565::from(RawU16::new(test_colour(x, y)))));
    display.fill_contiguous(&Rectangle::new(Point::zero(), size), colours).unwrap();
    size
}

const ILI9341_COLOURS: (ColorOrder, ColorInversion) = (ColorOrder::Bgr, ColorInversion::Normal);
const ST7789_COLOURS: (ColorOrder, ColorInversion) = (ColorOrder::Rgb, ColorInversion::Inverted);

#[test]
fn every_orientation_of_mipidsi_lands_where_its_rotation_says() {
    for rotation in [Rotation::Deg0, Rotation::Deg90, Rotation::Deg180, Rotation::Deg270] {
        for mirrored in [false, true] {
            let mut orientation = Orientation::new().rotate(rotation);
            if mirrored {
                orientation = orientation.flip_horizontal();
            }
            let (mut display, shared) = driver(ILI9341Rgb565, Config::ILI9341, orientation, ILI9341_COLOURS);
            let size = draw(&mut display);
            let rig = shared.0.borrow();
            for column in (0..COLUMNS).step_by(7) {
                for page in (0..PAGES).step_by(7) {
                    // The memory as a portrait picture; the drawn one turned clockwise lies on it.
                    let (c, p) = (u32::from(column), u32::from(page));
                    let (x, y) = match rotation {
                        Rotation::Deg0 => (c, p),
                        Rotation::Deg90 => (p, 239 - c),
                        Rotation::Deg180 => (239 - c, 319 - p),
                        Rotation::Deg270 => (319 - p, c),
                    };
                    let x = if mirrored { size.width - 1 - x } else { x };
                    assert_eq!(
                        rig.panel.memory(column, page),
                        test_colour(x, y),
                        "{rotation:?} mirrored {mirrored} at column {column}, page {page}"
                    );
                }
            }
            assert_eq!(rig.panel.undrawn_pixels(), 0);
            assert!(rig.panel.violations().is_empty(), "{}", rig.panel.violations());
        }
    }
}

/// RGB565 spread to eight bits per colour, rounded.
fn rgb888(colour: u16) -> [u8; 3] {
    let wide = |value: u16, most: f64| (f64::from(value) * 255.0 / most).round() as u8;
    [wide(colour >> 11, 31.0), wide(colour >> 5 & 0x3F, 63.0), wide(colour & 0x1F, 31.0)]
}

fn assert_upright(shared: &Shared) {
    let rig = shared.0.borrow();
    let picture = rig.panel.visible(rig.now).expect("lit after init");
    assert_eq!((picture.width, picture.height), (u32::from(WIDTH), u32::from(HEIGHT)));
    for y in 0..picture.height {
        for x in 0..picture.width {
            assert_eq!(picture.pixel(x, y), Some(rgb888(test_colour(x, y))), "at {x}, {y}");
        }
    }
}

#[test]
fn an_ili9341_module_shows_the_landscape_picture_upright_in_true_colours() {
    // The glass is wired from right to left: landscape is a mirrored quarter turn, MADCTL 0x28.
    let orientation = Orientation::new().rotate(Rotation::Deg90).flip_vertical();
    let (mut display, shared) = driver(ILI9341Rgb565, Config::ILI9341, orientation, ILI9341_COLOURS);
    draw(&mut display);
    assert_upright(&shared);
}

#[test]
fn an_st7789_module_shows_the_landscape_picture_upright_in_true_colours() {
    let orientation = Orientation::new().rotate(Rotation::Deg90);
    let (mut display, shared) = driver(ST7789, Config::ST7789, orientation, ST7789_COLOURS);
    draw(&mut display);
    assert_upright(&shared);
}

#[test]
fn mipidsis_start_up_keeps_the_waits_of_the_ili9341_sheet() {
    let orientation = Orientation::new().rotate(Rotation::Deg90);
    let (_, shared) = driver(ILI9341Rgb565, Config::ILI9341, orientation, ILI9341_COLOURS);
    let rig = shared.0.borrow();
    assert!(rig.panel.violations().is_empty(), "{}", rig.panel.violations());
    assert!(rig.panel.is_awake() && rig.panel.is_display_on());
    // 5 + 120 + 140 ms of waits behind the reset.
    assert!((Nanos::from_millis(275)..Nanos::from_millis(276)).contains(&rig.now), "{}", rig.now);
}

#[test]
fn a_second_start_up_without_waiting_is_reported() {
    let (display, shared) =
        driver(ST7789, Config::ST7789, Orientation::new().rotate(Rotation::Deg90), ST7789_COLOURS);
    drop(display);
    let rig = &mut *shared.0.borrow_mut();
    rig.panel.reset(rig.now, false);
    rig.now += Nanos::from_micros(10);
    rig.panel.reset(rig.now, true);
    rig.now += Nanos::from_millis(10);
    rig.panel.select(rig.now, true);
    rig.panel.data_command(rig.now, false);
    rig.panel.exchange(rig.now, 0x11, 8);
    let (_, violation) = rig.panel.violations().first()[0];
    assert!(
        matches!(violation, Violation::TooSoon { command: 0x11, early } if early > Nanos::from_millis(100))
    );
}

#[test]
fn clearing_the_screen_takes_the_known_bytes_and_commands() {
    // 3 commands, 8 window bytes, 153 600 pixel bytes: measured behind mipidsi's own interface trait as well.
    let (mut display, shared) =
        driver(ILI9341Rgb565, Config::ILI9341, Orientation::new().rotate(Rotation::Deg90), ILI9341_COLOURS);
    let before = shared.0.borrow().panel.counters();
    display.clear(Rgb565::BLACK).unwrap();
    let after = shared.0.borrow().panel.counters();
    assert_eq!(after.bytes - before.bytes, 153_611);
    assert_eq!(after.commands - before.commands, 3);
    assert_eq!(after.pixels - before.pixels, 76_800);
    assert_eq!(after.wraps, 0);
}
