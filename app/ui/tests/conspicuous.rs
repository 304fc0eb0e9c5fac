//! Whether a STOP is what one sees first: with each kind of colour vision, without sharp sight, in both themes.
//!
//! Colour vision by the matrices of Machado, Oliveira and Fernandes (2009) for its full loss, in linear light. A squint is
//! the mean over squares of 16 pixels: what is left of a picture at some metres. Conspicuous is what stands out from the
//! ground of the theme; contrast of text as WCAG 2 counts it.

mod common;

use cluster::view::Line;
use cluster::view::{Theme, View};
use cluster::{FaultId, Named};
use common::{Panel, day};
use protocol_core::model::Severity;
use protocol_core::vehicle::NO_VEHICLE;
use ui::{HEIGHT, Screen, WIDTH};

type Linear = [f64; 3];
type Matrix = [Linear; 3];

const EYES: [(&str, Matrix); 4] = [
    ("normal", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
    (
        "protan",
        [
            [0.152_286, 1.052_583, -0.204_868],
            [0.114_503, 0.786_281, 0.099_216],
            [-0.003_882, -0.048_116, 1.051_998],
        ],
    ),
    (
        "deutan",
        [
            [0.367_322, 0.860_646, -0.227_968],
            [0.280_085, 0.672_501, 0.047_413],
            [-0.011_820, 0.042_940, 0.968_881],
        ],
    ),
    (
        "tritan",
        [
            [1.255_528, -0.076_749, -0.178_779],
            [-0.078_411, 0.930_809, 0.147_602],
            [0.004_733, 0.691_367, 0.303_900],
        ],
    ),
];

fn linear(word: u16) -> Linear {
    let parts = [(word >> 11, 31.0), (word >> 5 & 63, 63.0), (word & 31, 31.0)];
    parts.map(|(part, full)| {
        let part = f64::from(part) / full;
        if part <= 0.040_45 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) }
    })
}

fn seen(eye: &Matrix, colour: Linear) -> Linear {
    eye.map(|row| row.iter().zip(colour).map(|(weight, part)| weight * part).sum::<f64>().clamp(0.0, 1.0))
}

fn luminance([red, green, blue]: Linear) -> f64 {
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

fn contrast(one: Linear, other: Linear) -> f64 {
    let (one, other) = (luminance(one) + 0.05, luminance(other) + 0.05);
    one.max(other) / one.min(other)
}

fn pixels(view: &View) -> Vec<u16> {
    let (mut screen, mut panel) = (Screen::new(), Panel::garbage());
    screen.update(view);
    panel.receive(&mut screen, usize::from(WIDTH) * 8);
    panel.pixels
}

/// Side of a square of a squint, in pixels.
const BLUR: usize = 16;

/// From this contrast on with the ground a square stands out.
const STANDS_OUT: f64 = 1.5;

/// Part of the screen that stands out of the ground for this eye, without sharp sight.
fn stands_out(eye: &Matrix, pixels: &[u16]) -> f64 {
    let (width, height) = (usize::from(WIDTH), usize::from(HEIGHT));
    // No telltale stands in the corner.
    let ground = seen(eye, linear(pixels[0]));
    let squares = (width / BLUR) * (height / BLUR);
    let out = (0..squares).filter(|square| {
        let (left, top) = (square % (width / BLUR) * BLUR, square / (width / BLUR) * BLUR);
        let mut mean = [0.0; 3];
        for y in top..top + BLUR {
            for &word in &pixels[y * width + left..][..BLUR] {
                let colour = linear(word);
                mean.iter_mut().zip(colour).for_each(|(mean, part)| *mean += part / (BLUR * BLUR) as f64);
            }
        }
        contrast(seen(eye, mean), ground) >= STANDS_OUT
    });
    out.count() as f64 / squares as f64
}

fn with_line(fault: FaultId, severity: Severity, takes_over: bool) -> View {
    let line = Line::of(Named::of(fault), severity, &NO_VEHICLE);
    let alarm = takes_over.then_some(line);
    View { line: Some(line), severity, alarm, ..common::driving() }
}

#[test]
fn a_stop_stands_out_more_than_anything_else_for_every_eye_in_both_themes() {
    for theme in [Theme::Night, Theme::Day] {
        let shown = |view: View| pixels(&if theme == Theme::Day { day(view) } else { view });
        let stop = shown(with_line(FaultId::Insulation, Severity::Stop, true));
        let others = [
            ("a calm drive", shown(common::driving())),
            ("a warning", shown(with_line(FaultId::Insulation, Severity::Warn, false))),
            ("a power limit", shown(with_line(FaultId::Limp, Severity::Derate, false))),
            ("an acknowledged STOP", shown(with_line(FaultId::Insulation, Severity::Stop, false))),
        ];
        for (eye, matrix) in &EYES {
            let most = stands_out(matrix, &stop);
            for (what, other) in &others {
                let other = stands_out(matrix, other);
                assert!(most > 1.5 * other, "{eye} {theme:?}: STOP {most:.2}, {what} {other:.2}");
            }
        }
    }
}

#[test]
fn its_text_has_contrast_on_its_ground_for_every_eye() {
    for theme in [Theme::Night, Theme::Day] {
        let view = with_line(FaultId::Insulation, Severity::Stop, true);
        let pixels = pixels(&if theme == Theme::Day { day(view) } else { view });
        let ground = linear(pixels[60 * usize::from(WIDTH) + 2]);
        for (eye, matrix) in &EYES {
            let text = seen(matrix, [1.0; 3]);
            let found = contrast(text, seen(matrix, ground));
            assert!(found >= 4.5, "{eye} {theme:?}: {found:.1}");
        }
    }
}
