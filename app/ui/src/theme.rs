//! Colours: two palettes, and for each ink its sixteen steps over the ground it stands on.
//!
//! Everything is computed at compile time: painting looks colours up and never blends text. Red, yellow, green and blue
//! carry their ISO 2575 meaning only; the one accent is neither.

use cluster::view::Theme;

type Rgb = (u8, u8, u8);

/// The sixteen steps from the ground to an ink, 5-6-5.
pub(crate) type Ramp = [u16; 16];

/// A colour of text, icons and bars on its ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(crate) enum Ink {
    /// What the driver reads first.
    Primary,
    /// Units, labels and marks.
    Secondary,
    /// Marks of values that were never seen.
    Faint,
    /// The one accent.
    Accent,
    /// Danger.
    Red,
    /// Caution.
    Yellow,
    /// In operation; energy goes back to the battery.
    Green,
    /// Main beam.
    Blue,
    /// On the information line.
    OnInformation,
    /// On the line of a warning.
    OnWarn,
    /// On the line of a power limit.
    OnDerate,
    /// On the line of a stop.
    OnStop,
    /// On the chip in the information line.
    ChipInformation,
    /// On the chip in the line of a warning.
    ChipWarn,
    /// On the chip in the line of a power limit.
    ChipDerate,
    /// On the chip in the line of a stop.
    ChipStop,
}

const INKS: usize = Ink::ChipStop as usize + 1;

/// Steps of the colour along a ring of the dial.
const SHADES: usize = 32;

/// A theme, ready to paint with.
pub(crate) struct Palette {
    /// Ground of the screen.
    pub(crate) ground: u16,
    /// Unlit part of dial and bars.
    pub(crate) track: u16,
    /// Colours along the lit part of the two rings.
    pub(crate) rings: [[u16; SHADES]; 2],
    /// The dial's pointers and the bars' zero mark.
    pub(crate) pointer: u16,
    /// Ground of the message line by severity.
    pub(crate) bands: [u16; 4],
    /// Stripe of the worst severity.
    pub(crate) stripes: [u16; 4],
    ramps: [Ramp; INKS],
}

impl Palette {
    /// Returns the palette of a theme.
    pub(crate) const fn of(theme: Theme) -> &'static Self {
        match theme {
            Theme::Night => &NIGHT,
            Theme::Day => &DAY,
        }
    }

    /// Returns the steps of an ink.
    pub(crate) const fn ramp(&self, ink: Ink) -> &Ramp {
        &self.ramps[ink as usize]
    }

    /// Returns the full colour of an ink.
    pub(crate) const fn colour(&self, ink: Ink) -> u16 {
        self.ramps[ink as usize][15]
    }
}

struct Colours {
    ground: Rgb,
    track: Rgb,
    pointer: Rgb,
    primary: Rgb,
    secondary: Rgb,
    faint: Rgb,
    accent: Rgb,
    red: Rgb,
    yellow: Rgb,
    green: Rgb,
    blue: Rgb,
    rings: [(Rgb, Rgb); 2],
    /// Ground and ink of the message line by severity.
    bands: [(Rgb, Rgb); 4],
}

const fn word((red, green, blue): Rgb) -> u16 {
    (red as u16 >> 3) << 11 | (green as u16 >> 2) << 5 | blue as u16 >> 3
}

/// Returns the colour `step` of `steps` on the way.
const fn step(from: Rgb, to: Rgb, step: u16, steps: u16) -> Rgb {
    const fn between(from: u8, to: u8, step: u16, steps: u16) -> u8 {
        ((from as u16 * (steps - step) + to as u16 * step + steps / 2) / steps) as u8
    }
    (
        between(from.0, to.0, step, steps),
        between(from.1, to.1, step, steps),
        between(from.2, to.2, step, steps),
    )
}

const fn ramp(ground: Rgb, ink: Rgb) -> Ramp {
    let mut ramp = [0; 16];
    let mut level = 0;
    while level < 16 {
        ramp[level] = word(step(ground, ink, level as u16, 15));
        level += 1;
    }
    ramp
}

const fn shades((from, to): (Rgb, Rgb)) -> [u16; SHADES] {
    let mut shades = [0; SHADES];
    let mut place = 0;
    while place < SHADES {
        shades[place] = word(step(from, to, place as u16, SHADES as u16 - 1));
        place += 1;
    }
    shades
}

const fn palette(colours: &Colours) -> Palette {
    let Colours { ground, bands, rings, .. } = *colours;
    Palette {
        ground: word(ground),
        track: word(colours.track),
        rings: [shades(rings[0]), shades(rings[1])],
        pointer: word(colours.pointer),
        bands: [word(bands[0].0), word(bands[1].0), word(bands[2].0), word(bands[3].0)],
        stripes: [word(colours.track), word(bands[1].0), word(bands[2].0), word(bands[3].0)],
        ramps: [
            ramp(ground, colours.primary),
            ramp(ground, colours.secondary),
            ramp(ground, colours.faint),
            ramp(ground, colours.accent),
            ramp(ground, colours.red),
            ramp(ground, colours.yellow),
            ramp(ground, colours.green),
            ramp(ground, colours.blue),
            ramp(bands[0].0, bands[0].1),
            ramp(bands[1].0, bands[1].1),
            ramp(bands[2].0, bands[2].1),
            ramp(bands[3].0, bands[3].1),
            // A chip is the line the other way round.
            ramp(bands[0].1, bands[0].0),
            ramp(bands[1].1, bands[1].0),
            ramp(bands[2].1, bands[2].0),
            ramp(bands[3].1, bands[3].0),
        ],
    }
}

static NIGHT: Palette = palette(&Colours {
    ground: (8, 12, 18),
    track: (36, 46, 58),
    pointer: (255, 255, 255),
    primary: (255, 255, 255),
    secondary: (138, 154, 172),
    faint: (66, 80, 96),
    accent: (84, 214, 224),
    red: (255, 56, 48),
    yellow: (255, 200, 0),
    green: (40, 214, 92),
    blue: (48, 120, 255),
    rings: [((22, 92, 112), (84, 222, 230)), ((96, 110, 126), (198, 210, 222))],
    bands: [
        ((40, 50, 62), (255, 255, 255)),
        ((255, 216, 24), (0, 0, 0)),
        ((255, 150, 16), (0, 0, 0)),
        ((200, 8, 16), (255, 255, 255)),
    ],
});

static DAY: Palette = palette(&Colours {
    ground: (236, 240, 244),
    track: (202, 210, 218),
    pointer: (8, 12, 18),
    primary: (8, 12, 18),
    secondary: (82, 94, 108),
    faint: (164, 174, 184),
    accent: (0, 124, 140),
    red: (214, 0, 16),
    yellow: (190, 118, 0),
    green: (0, 138, 48),
    blue: (0, 72, 224),
    rings: [((116, 190, 200), (0, 128, 146)), ((168, 178, 188), (70, 82, 96))],
    bands: [
        ((206, 214, 222), (8, 12, 18)),
        ((255, 216, 24), (0, 0, 0)),
        ((255, 150, 16), (0, 0, 0)),
        ((200, 8, 16), (255, 255, 255)),
    ],
});

/// Mixes two colours: `level` 0 = `ground`, 15 = `ink`.
#[inline]
pub(crate) const fn mix(ground: u16, ink: u16, level: u16) -> u16 {
    // All three channels in one multiplication: green in the upper half, red and blue in the lower, 5 bits spare.
    const SPREAD: u32 = 0x07E0_F81F;
    let alpha = (level as u32 * 34 + 8) >> 4;
    let (ground, ink) =
        ((ground as u32 | (ground as u32) << 16) & SPREAD, (ink as u32 | (ink as u32) << 16) & SPREAD);
    let mixed = (ground * (32 - alpha) + ink * alpha) >> 5 & SPREAD;
    (mixed | mixed >> 16) as u16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mixing_ends_at_both_colours() {
        for colour in [0x0000, 0xFFFF, 0x1234, 0xF81F, 0x07E0] {
            assert_eq!(mix(colour, 0x5A5A, 0), colour);
            assert_eq!(mix(0x5A5A, colour, 15), colour);
        }
    }

    #[test]
    fn mixing_stays_between_the_two_channels() {
        for level in 0..16 {
            let mixed = mix(word((8, 12, 18)), word((255, 255, 255)), level);
            assert!((1..=31).contains(&(mixed >> 11)), "red {} at level {level}", mixed >> 11);
            assert!((3..=63).contains(&(mixed >> 5 & 63)), "green at level {level}");
        }
    }

    /// The ratio of the relative luminances of WCAG 2, which glanceable text wants at 4.5 or more.
    fn contrast(a: u16, b: u16) -> f32 {
        let light = |word: u16| {
            let linear = |part: u16, full: f32| (f32::from(part) / full).powf(2.2);
            0.2126 * linear(word >> 11, 31.0)
                + 0.7152 * linear(word >> 5 & 63, 63.0)
                + 0.0722 * linear(word & 31, 31.0)
        };
        let (a, b) = (light(a) + 0.05, light(b) + 0.05);
        a.max(b) / a.min(b)
    }

    #[test]
    fn what_the_driver_reads_stands_out_from_its_ground_in_both_themes() {
        for palette in [&NIGHT, &DAY] {
            assert!(contrast(palette.colour(Ink::Primary), palette.ground) > 12.0);
            assert!(contrast(palette.colour(Ink::Secondary), palette.ground) > 4.5);
            for (band, ink) in
                palette.bands.iter().zip([Ink::OnInformation, Ink::OnWarn, Ink::OnDerate, Ink::OnStop])
            {
                let ratio = contrast(*band, palette.colour(ink));
                assert!(ratio > 4.5, "{ink:?}: {ratio}");
            }
        }
    }
}
