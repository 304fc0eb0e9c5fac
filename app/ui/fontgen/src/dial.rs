//! The two rings of the dial: coverage and angle of each pixel.
//!
//! The outer ring is road speed, the inner one motor speed. Both sweep 240 degrees, open at the bottom, so that the left
//! half mirrors the right one and only the left half is stored.

use std::fmt::Write;

/// Distance of the rings' common centre from the left edge of the screen; the centre lies between two pixels.
pub(crate) const CENTRE_X: u16 = 160;
/// Distance of the centre from the top edge.
pub(crate) const CENTRE_Y: u16 = 125;
/// Steps of the angle from the lower left end to the lower right end.
pub(crate) const STEPS: u16 = 1024;
/// Parts of a ring that are sent on their own.
const PARTS: u16 = 64;
/// Sweep to each side of straight up, degrees.
const HALF_SWEEP: f64 = 120.0;

struct Ring {
    inner: f64,
    outer: f64,
    /// Equal parts with a notch between them.
    parts: u32,
    notch: f64,
}

const RINGS: [Ring; 2] = [
    Ring { inner: 88.0, outer: 98.0, parts: 9, notch: 1.6 },
    Ring { inner: 82.0, outer: 85.0, parts: 6, notch: 1.6 },
];

/// What the generator hands to the UI.
pub(crate) struct Dial {
    /// Rust source of the row and part tables.
    pub(crate) source: String,
    /// Pixels of the left half, little endian: bits 0..=9 angle, 10..=13 coverage, 14 = inner ring.
    pub(crate) pixels: Vec<u8>,
}

/// Returns which ring covers a point, and its angle as a fraction of the sweep.
fn ring_at(x: f64, y: f64) -> Option<(usize, f64)> {
    let (dx, dy) = (x - f64::from(CENTRE_X), f64::from(CENTRE_Y) - y);
    let (radius, degrees) = (dx.hypot(dy), dx.atan2(dy).to_degrees());
    let ring = RINGS.iter().position(|ring| (ring.inner..ring.outer).contains(&radius))?;
    let along = (degrees + HALF_SWEEP) / (2.0 * HALF_SWEEP);
    let part = along * f64::from(RINGS[ring].parts);
    let from_notch =
        (part - part.round()) / f64::from(RINGS[ring].parts) * (2.0 * HALF_SWEEP).to_radians() * radius;
    let at_end = part.round() == 0.0 || part.round() == f64::from(RINGS[ring].parts);
    let notched = !at_end && from_notch.abs() < RINGS[ring].notch / 2.0;
    ((0.0..=1.0).contains(&along) && !notched).then_some((ring, along))
}

/// Computes the tables.
pub(crate) fn generate() -> Dial {
    let radius = RINGS[0].outer as u16;
    let (top, rows) = (CENTRE_Y - radius, radius + radius / 2 + 2);
    let mut pixels = Vec::new();
    let mut row_lines = String::new();
    // First column, first row, last column, last row of each part of each ring.
    let mut boxes = [[(u16::MAX, u16::MAX, 0_u16, 0_u16); PARTS as usize]; 2];
    for y in top..top + rows {
        let mut run: Vec<(u16, u16)> = Vec::new();
        for x in 0..CENTRE_X {
            let (mut hits, mut sum, mut ring) = (0_u32, 0.0, 0);
            for step in 0..256 {
                let (u, v) = (f64::from(step % 16) + 0.5, f64::from(step / 16) + 0.5);
                if let Some((at, along)) = ring_at(f64::from(x) + u / 16.0, f64::from(y) + v / 16.0) {
                    (hits, sum, ring) = (hits + 1, sum + along, at);
                }
            }
            let coverage = (hits * 15 + 128) / 256;
            if coverage > 0 {
                let angle = ((sum / f64::from(hits)) * f64::from(STEPS)) as u16;
                run.push((x, angle | (coverage as u16) << 10 | (ring as u16) << 14));
                for (angle, x) in [(angle, x), (STEPS - 1 - angle, 2 * CENTRE_X - 1 - x)] {
                    let part = &mut boxes[ring][usize::from(angle / (STEPS / PARTS))];
                    *part = (part.0.min(x), part.1.min(y), part.2.max(x), part.3.max(y));
                }
            }
        }
        let first = run.first().map_or(0, |&(x, _)| x);
        let length = run.last().map_or(0, |&(x, _)| x + 1 - first);
        writeln!(
            row_lines,
            "    DialRow {{ first: {first}, length: {length}, start: {} }},",
            pixels.len() / 2
        )
        .unwrap();
        for x in first..first + length {
            let word = run.iter().find(|&&(at, _)| at == x).map_or(0, |&(_, word)| word);
            pixels.extend(word.to_le_bytes());
        }
    }
    let mut source = format!(
        "/// First row of the dial.\npub(crate) const DIAL_TOP: u16 = {top};\n\
         /// The dial's left half mirrors at this column.\npub(crate) const DIAL_CENTRE: u16 = {CENTRE_X};\n\
         /// Outer radius of the dial.\npub(crate) const DIAL_RADIUS: u16 = {radius};\n\
         /// Angle steps of the sweep.\npub(crate) const DIAL_STEPS: u16 = {STEPS};\n\
         /// Rows of the dial's left half.\npub(crate) static DIAL_ROWS: [DialRow; {rows}] = [\n{row_lines}];\n\
         /// Coverage and angle of the dial's left half.\n\
         pub(crate) static DIAL_PIXELS: [u16; {}] = words(include_bytes!(\"dial.bin\"));\n\
         /// The box around each part of the two rings: x, y, width, height.\n\
         pub(crate) static DIAL_PARTS: [[(u16, u16, u16, u16); {PARTS}]; 2] = [\n",
        pixels.len() / 2
    );
    for ring in boxes {
        source.push_str("    [\n");
        for (left, top, right, bottom) in ring {
            writeln!(source, "        ({left}, {top}, {}, {}),", right + 1 - left, bottom + 1 - top).unwrap();
        }
        source.push_str("    ],\n");
    }
    source.push_str("];\n");
    Dial { source, pixels }
}
