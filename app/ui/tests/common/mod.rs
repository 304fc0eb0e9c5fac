//! A panel for tests: keeps what was sent and is stricter than the real one.

#![allow(dead_code, unreachable_pub, reason = "each test file uses its part")]

use cluster::{
    FaultId, Named, Page, Telltale, Telltales, View,
    page::Chapter,
    view::{Charging, Journey, Language, Line, List, Listed, Plug, Range, Sheet, Text, Theme},
};
use embedded_graphics_core::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    pixelcolor::{IntoStorage, Rgb565},
    primitives::Rectangle,
};
use protocol_core::model::{Gear, Severity, Shown};
use std::convert::Infallible;
use ui::{HEIGHT, Screen, WIDTH};

/// A picture of the whole screen, 5-6-5 words.
#[derive(Clone, PartialEq, Eq)]
pub struct Panel {
    pub pixels: Vec<u16>,
    /// Tiles received.
    pub windows: usize,
    /// Pixels received.
    pub sent: usize,
}

impl Panel {
    /// Returns a panel full of noise, as after power-on.
    pub fn garbage() -> Self {
        let mut state = 0x1234_5678_u32;
        let noise = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 16) as u16
        };
        Self {
            pixels: std::iter::repeat_with(noise).take(usize::from(WIDTH) * usize::from(HEIGHT)).collect(),
            windows: 0,
            sent: 0,
        }
    }

    /// Receives everything that the screen has to send, in tiles of at most `max_pixels`.
    pub fn receive(&mut self, screen: &mut Screen, max_pixels: usize) {
        (self.windows, self.sent) = (0, 0);
        while let Some(area) = screen.next_tile(max_pixels) {
            assert!(
                area.size.width as usize * area.size.height as usize <= max_pixels.max(usize::from(WIDTH))
            );
            self.receive_tile(screen, area);
        }
        assert!(screen.is_clean());
    }

    /// Receives one tile; every pixel of it must be painted exactly once.
    pub fn receive_tile(&mut self, screen: &Screen, area: Rectangle) {
        let mut tile = StrictTile { area, pixels: vec![None; (area.size.width * area.size.height) as usize] };
        screen.draw(&area, &mut tile).unwrap();
        for (index, pixel) in tile.pixels.into_iter().enumerate() {
            let (x, y) = (index as i32 % area.size.width as i32, index as i32 / area.size.width as i32);
            let place = (area.top_left.y + y) * i32::from(WIDTH) + area.top_left.x + x;
            self.pixels[place as usize] =
                pixel.unwrap_or_else(|| panic!("({x}, {y}) of {area:?} was not painted"));
            self.sent += 1;
        }
        self.windows += 1;
    }

    /// Returns the full picture of a view, painted at once.
    pub fn of(view: &View) -> Self {
        let mut screen = Screen::new();
        screen.update(view);
        let mut panel = Self::garbage();
        panel.receive(&mut screen, ui::TILE_PIXELS);
        panel
    }

    /// Returns where the first difference to another picture is.
    pub fn difference(&self, other: &Self) -> Option<(usize, usize)> {
        let place = self.pixels.iter().zip(&other.pixels).position(|(a, b)| a != b)?;
        Some((place % usize::from(WIDTH), place / usize::from(WIDTH)))
    }
}

/// A tile that panics when a pixel is painted twice or outside.
struct StrictTile {
    area: Rectangle,
    pixels: Vec<Option<u16>>,
}

impl Dimensions for StrictTile {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl DrawTarget for StrictTile {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, colour) in pixels {
            assert!(self.area.contains(point), "{point:?} is outside {:?}", self.area);
            let (x, y) = (point.x - self.area.top_left.x, point.y - self.area.top_left.y);
            let pixel = &mut self.pixels[(y * self.area.size.width as i32 + x) as usize];
            assert!(pixel.is_none(), "{point:?} was painted twice");
            *pixel = Some(colour.into_storage());
        }
        Ok(())
    }
}

pub fn rectangle(x: i32, y: i32, width: u32, height: u32) -> Rectangle {
    Rectangle::new(Point::new(x, y), Size::new(width, height))
}

pub fn lamps(lit: &[Telltale]) -> Telltales {
    let mut lamps = Telltales::NONE;
    lit.iter().for_each(|&lamp| lamps.set(lamp, true));
    lamps
}

/// Driving along with everything in order.
pub fn driving() -> View {
    View {
        speed_kmh: Shown::Value(62),
        gear: Some(Gear::D),
        soc_percent: Shown::Value(78),
        pack_decivolts: Shown::Value(5372),
        pack_deciamps: Shown::Value(634),
        power_hectowatts: Shown::Value(341),
        motor_rpm: Shown::Value(4870),
        motor_celsius: Shown::Value(74),
        inverter_celsius: Shown::Value(58),
        cell_millivolts: (Shown::Value(3360), Shown::Value(3310)),
        cell_celsius: (Shown::Value(34), Shown::Value(29)),
        odometer_hectometres: 481_237,
        telltales: lamps(&[Telltale::Ready, Telltale::LowBeam]),
        heartbeat: true,
        ..View::default()
    }
}

pub fn line(
    severity: Severity,
    zh: &'static str,
    en: &'static str,
    code: u16,
    position: u8,
    count: u8,
) -> Line {
    let named = Named { code: Some(code), ..Named::of(FaultId::VehicleCode) };
    Line { named, severity, text: Text { zh, en }, code: Some(code), position, count }
}

/// The same in English.
pub fn english(view: View) -> View {
    View { language: Language::English, ..view }
}

/// The same for direct sun.
pub fn day(view: View) -> View {
    View { theme: Theme::Day, ..view }
}

/// Every value missing in the same way.
pub fn missing<const STALE: bool>(view: View) -> View {
    fn kind<T, const STALE: bool>() -> Shown<T> {
        if STALE { Shown::Stale } else { Shown::Invalid }
    }
    View {
        speed_kmh: kind::<_, STALE>(),
        soc_percent: kind::<_, STALE>(),
        pack_decivolts: kind::<_, STALE>(),
        pack_deciamps: kind::<_, STALE>(),
        power_hectowatts: kind::<_, STALE>(),
        motor_rpm: kind::<_, STALE>(),
        motor_celsius: kind::<_, STALE>(),
        inverter_celsius: kind::<_, STALE>(),
        cell_millivolts: (kind::<_, STALE>(), kind::<_, STALE>()),
        cell_celsius: (kind::<_, STALE>(), kind::<_, STALE>()),
        ..view
    }
}

/// The same on another page.
pub fn on(page: Page, view: View) -> View {
    View { page, ..view }
}

/// Two trips, consumption and an estimated range.
pub fn travelled() -> View {
    View {
        journeys: [
            Journey {
                hectometres: 1_846,
                average_whkm: Some(214),
                used_watthours: 45_120,
                regained_watthours: 5_610,
            },
            Journey {
                hectometres: 12_873,
                average_whkm: Some(1_038),
                used_watthours: 1_402_000,
                regained_watthours: 66_200,
            },
        ],
        consumption_whkm: Shown::Value(189),
        range: Shown::Value(Range { km: 182, is_estimated: true }),
        ..driving()
    }
}

/// Standing with a plug inserted.
pub fn plugged(plug: Plug) -> View {
    let flows = plug == Plug::Charging;
    View {
        page: Page::Energy,
        speed_kmh: Shown::Value(0),
        gear: Some(Gear::P),
        soc_percent: Shown::Value(64),
        motor_rpm: Shown::Value(0),
        charging: Some(Charging {
            plug,
            decivolts: Shown::Value(5_398),
            deciamps: Shown::Value(if flows { 1_204 } else { 0 }),
            hectowatts: Shown::Value(if flows { 649 } else { 0 }),
            minutes_left: flows.then_some(83),
        }),
        telltales: lamps(if flows {
            &[Telltale::ChargePlug, Telltale::Charging, Telltale::ParkingBrake]
        } else {
            &[Telltale::ChargePlug, Telltale::ParkingBrake]
        }),
        ..travelled()
    }
}

fn listed(
    severity: Severity,
    zh: &'static str,
    en: &'static str,
    code: u16,
    at_s: u32,
    count: u16,
) -> Listed {
    Listed { severity, text: Text { zh, en }, code: (code != 0).then_some(code), count, at_s }
}

/// A full part of a list.
pub fn list() -> List {
    List {
        rows: [
            Some(listed(Severity::Stop, "绝缘故障", "Insulation fault", 11, 4_503, 1)),
            Some(listed(Severity::Derate, "单体过压", "Cell overvoltage", 4, 1_212, 12)),
            Some(listed(Severity::Warn, "空压机通信中断", "No communication: compressor", 0, 754, 2)),
            Some(listed(Severity::None, "限转矩", "Torque limited", 0, 36_061, 1)),
        ],
        position: 1,
        count: 3,
    }
}

/// A chapter with these values.
pub fn sheet(chapter: Chapter, values: &[Option<i32>]) -> Sheet {
    let shown = |place: usize| values.get(place).copied().flatten().map_or(Shown::Never, Shown::Value);
    let values = std::array::from_fn(shown);
    Sheet { chapter, values, position: chapter as u8 + 1, count: Chapter::ALL.len() as u8 }
}

/// Every chapter with believable values, in the order of [`Chapter::ALL`].
pub fn sheets() -> [Sheet; 13] {
    let all = |values: &[i32]| values.iter().map(|&value| Some(value)).collect::<Vec<_>>();
    [
        sheet(Chapter::Controls, &all(&[3, 1, 0, 425, 0, 0, 1, 62, 1])),
        sheet(Chapter::Drive, &all(&[1, 2_105, 1_830, 5_374, 962])),
        sheet(Chapter::Battery, &all(&[2, 968, 4_000, 1_250, 1, 8_200, 7_950, 5_402, 310, 3])),
        sheet(Chapter::Nameplate, &all(&[300, 5_376, 65, -20, 100, 168, 84])),
        sheet(Chapter::Supply, &all(&[1, 5_371, 276, 845, 47, 274])),
        sheet(Chapter::Pumps, &all(&[2, 0, 71, 82, 79, 1, 2_850, 64, 0])),
        sheet(Chapter::Climate, &all(&[1, 1, 0, 0, 2, 1, 0, 24, 33])),
        sheet(Chapter::Relays, &all(&[1, 1, 0, 1, 0, 0, 0, 0])),
        sheet(Chapter::Contactors, &[Some(1), None, Some(0), Some(2), Some(3)]),
        sheet(Chapter::Box, &all(&[1, 1, 0, 1, 0, 0, 1, 0, 0])),
        sheet(Chapter::Codes, &all(&[0, 4, 0, 0, 17, 0, 0, 0])),
        sheet(
            Chapter::Extremes,
            &[
                Some(3_360),
                Some(3),
                Some(12),
                None,
                Some(3_308),
                Some(1),
                Some(27),
                None,
                Some(34),
                Some(3),
                None,
                Some(-4),
                None,
                Some(9),
            ],
        ),
        sheet(Chapter::Bus, &all(&[1, 0, 3, 48_210, 6_102_334, 21, 0, 0, 2])),
    ]
}
