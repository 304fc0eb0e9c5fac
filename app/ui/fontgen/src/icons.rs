//! The telltale symbols, drawn after the ideas of ISO 2575 on a grid of 22 x 22 pixels.
//!
//! Own drawings as code, each under the key of its telltale; READY is written, not drawn.

use crate::shapes::{P, Shape};
use std::collections::BTreeMap;

/// Width and height of an icon in pixels.
pub(crate) const SIZE: usize = 22;

const LINE: f32 = 2.0;

fn stroke(points: &[P]) -> Shape {
    Shape::Stroke(LINE, points.to_vec())
}

fn fill(points: &[P]) -> Shape {
    Shape::Fill(points.to_vec())
}

fn boxed(left: f32, top: f32, right: f32, bottom: f32) -> Shape {
    Shape::outline(LINE, &[(left, top), (right, top), (right, bottom), (left, bottom)])
}

fn mirrored(shapes: Vec<Shape>) -> Vec<Shape> {
    let flip = |(x, y): P| (SIZE as f32 - x, y);
    shapes
        .into_iter()
        .map(|shape| match shape {
            Shape::Stroke(width, points) => Shape::Stroke(width, points.into_iter().map(flip).collect()),
            Shape::Fill(points) => Shape::Fill(points.into_iter().map(flip).collect()),
            Shape::Disc(centre, radius) => Shape::Disc(flip(centre), radius),
            Shape::Arc(centre, radius, width, from, to) => {
                Shape::Arc(flip(centre), radius, width, 180.0 - to, 180.0 - from)
            }
            Shape::Erase(shape) => mirrored(vec![*shape]).remove(0).erase(),
        })
        .collect()
}

/// An exclamation mark two pixels wide.
fn bang(x: f32, top: f32, bottom: f32) -> Vec<Shape> {
    let bar = |from: f32, to: f32| fill(&[(x - 1.0, from), (x + 1.0, from), (x + 1.0, to), (x - 1.0, to)]);
    vec![bar(top, bottom - 3.0), bar(bottom - 2.0, bottom)]
}

/// A lightning bolt in the box around (`x`, `y`) of half width `w` and half height `h`.
fn bolt(x: f32, y: f32, w: f32, h: f32) -> Shape {
    fill(&[
        (x + 0.35 * w, y - h),
        (x - w, y + 0.18 * h),
        (x - 0.08 * w, y + 0.18 * h),
        (x - 0.35 * w, y + h),
        (x + w, y - 0.18 * h),
        (x + 0.08 * w, y - 0.18 * h),
    ])
}

/// The traction battery: a case with two terminals.
fn battery() -> Vec<Shape> {
    vec![
        boxed(2.0, 7.0, 20.0, 19.0),
        fill(&[(5.0, 3.0), (9.0, 3.0), (9.0, 6.0), (5.0, 6.0)]),
        fill(&[(13.0, 3.0), (17.0, 3.0), (17.0, 6.0), (13.0, 6.0)]),
    ]
}

/// A lamp seen from the side, its light falls to the left.
fn lamp() -> Vec<Shape> {
    let curve: Vec<P> = (0..=12)
        .map(|step| {
            let angle = (-90.0 + 15.0 * step as f32).to_radians();
            (12.4 + 7.0 * angle.cos(), 11.0 + 6.8 * angle.sin())
        })
        .collect();
    vec![Shape::outline(LINE, &curve)]
}

fn beams(rows: &[f32], fall: f32) -> Vec<Shape> {
    rows.iter().map(|&y| Shape::Stroke(1.8, vec![(9.2, y), (2.0, y + fall)])).collect()
}

fn wave() -> Vec<Shape> {
    let line: Vec<P> = (0..=24)
        .map(|step| {
            let y = 4.0 + step as f32 * 14.5 / 24.0;
            (5.4 + 1.1 * ((y - 4.0) * 0.87).sin(), y)
        })
        .collect();
    vec![Shape::Stroke(3.6, line.clone()).erase(), Shape::Stroke(1.5, line)]
}

/// A car from the side.
fn car() -> Vec<Shape> {
    vec![
        Shape::outline(
            1.7,
            &[
                (1.6, 15.2),
                (1.6, 11.2),
                (4.6, 10.0),
                (7.4, 5.4),
                (14.6, 5.4),
                (17.6, 10.0),
                (20.4, 11.2),
                (20.4, 15.2),
            ],
        ),
        Shape::Disc((6.0, 15.6), 3.4).erase(),
        Shape::Disc((16.0, 15.6), 3.4).erase(),
        Shape::ring((6.0, 15.6), 1.8, 1.6),
        Shape::ring((16.0, 15.6), 1.8, 1.6),
    ]
}

/// An electric motor: ribbed case, shaft and feet.
fn motor() -> Vec<Shape> {
    vec![
        boxed(5.0, 4.0, 17.0, 16.0),
        stroke(&[(18.0, 10.0), (21.0, 10.0)]),
        stroke(&[(21.0, 7.0), (21.0, 13.0)]),
        stroke(&[(1.0, 7.0), (1.0, 13.0)]),
        stroke(&[(1.0, 10.0), (4.0, 10.0)]),
        stroke(&[(5.0, 19.0), (17.0, 19.0)]),
        stroke(&[(8.0, 17.0), (8.0, 19.0)]),
        stroke(&[(14.0, 17.0), (14.0, 19.0)]),
    ]
}

fn join(parts: impl IntoIterator<Item = Vec<Shape>>) -> Vec<Shape> {
    parts.into_iter().flatten().collect()
}

/// A letter in a box of 3.8 by 7.4, as strokes of points.
type Letter = &'static [&'static [P]];

const A: Letter = &[&[(0.0, 7.4), (1.9, 0.0), (3.8, 7.4)], &[(0.7, 4.9), (3.1, 4.9)]];
const B: Letter = &[
    &[(0.0, 0.0), (0.0, 7.4), (2.6, 7.4), (3.8, 6.4), (3.8, 4.6), (2.6, 3.6), (0.0, 3.6)],
    &[(0.0, 0.0), (2.4, 0.0), (3.4, 0.9), (3.4, 2.7), (2.6, 3.6)],
];
const D: Letter = &[&[(0.0, 0.0), (0.0, 7.4), (2.2, 7.4), (3.8, 5.8), (3.8, 1.6), (2.2, 0.0), (0.0, 0.0)]];
const E: Letter = &[&[(3.8, 0.0), (0.0, 0.0), (0.0, 7.4), (3.8, 7.4)], &[(0.0, 3.7), (3.0, 3.7)]];
const S: Letter = &[&[
    (3.7, 1.2),
    (2.7, 0.0),
    (1.1, 0.0),
    (0.1, 1.0),
    (0.1, 2.6),
    (1.1, 3.6),
    (2.8, 3.8),
    (3.8, 4.8),
    (3.8, 6.4),
    (2.8, 7.4),
    (1.0, 7.4),
    (0.0, 6.2),
]];

/// Three letters beside each other in the middle of the symbol.
fn letters(word: [Letter; 3]) -> Vec<Shape> {
    let placed = |(place, letter): (usize, Letter)| {
        let (x, y) = (3.6 + 5.5 * place as f32, 7.3);
        letter
            .iter()
            .map(move |points| Shape::Stroke(1.3, points.iter().map(|(dx, dy)| (x + dx, y + dy)).collect()))
    };
    word.into_iter().enumerate().flat_map(placed).collect()
}

/// The two arcs that ISO 2575 puts around what concerns the brakes.
fn brake_brackets() -> Vec<Shape> {
    vec![Shape::Arc((11.0, 11.0), 10.0, 1.6, 125.0, 235.0), Shape::Arc((11.0, 11.0), 10.0, 1.6, -55.0, 55.0)]
}

/// Returns each symbol with the key of its telltale; `ready` has no shapes.
pub(crate) fn all() -> BTreeMap<&'static str, Vec<Shape>> {
    let arrow = vec![fill(&[
        (1.4, 11.0),
        (10.4, 2.6),
        (10.4, 7.4),
        (20.4, 7.4),
        (20.4, 14.6),
        (10.4, 14.6),
        (10.4, 19.4),
    ])];
    let fog = || join([lamp(), beams(&[5.2, 9.4, 13.6], 2.4), wave()]);
    let rear_fog = || join([lamp(), beams(&[6.2, 11.0, 15.8], 0.0), wave()]);
    let slash = vec![
        Shape::Stroke(4.6, vec![(3.6, 20.0), (18.4, 2.0)]).erase(),
        Shape::Stroke(2.0, vec![(3.6, 20.0), (18.4, 2.0)]),
    ];
    BTreeMap::from([
        ("turn_left", arrow.clone()),
        ("turn_right", mirrored(arrow)),
        ("low_beam", join([lamp(), beams(&[4.4, 8.0, 11.6, 15.2], 2.4)])),
        ("high_beam", join([lamp(), beams(&[4.0, 9.0, 13.0, 18.0], 0.0)])),
        ("front_fog", fog()),
        ("rear_fog", mirrored(rear_fog())),
        ("ready", vec![]),
        ("system_fault", join([car(), bang(11.0, 7.0, 14.0)])),
        ("battery_fault", join([battery(), bang(11.0, 9.0, 17.0)])),
        ("motor_fault", join([motor(), bang(11.0, 6.0, 14.0)])),
        (
            "insulation",
            vec![
                bolt(11.0, 6.4, 4.4, 6.2),
                stroke(&[(3.0, 14.0), (19.0, 14.0)]),
                stroke(&[(6.0, 17.0), (16.0, 17.0)]),
                stroke(&[(9.0, 20.0), (13.0, 20.0)]),
            ],
        ),
        (
            "power_limited",
            vec![
                Shape::Disc((9.0, 13.5), 7.0),
                fill(&[(0.0, 13.0), (22.0, 13.0), (22.0, 22.0), (0.0, 22.0)]).erase(),
                Shape::Stroke(1.1, vec![(4.6, 13.2), (6.8, 9.4), (11.2, 9.4), (13.4, 13.2)]).erase(),
                Shape::Stroke(1.1, vec![(6.8, 9.4), (5.6, 7.4)]).erase(),
                Shape::Stroke(1.1, vec![(11.2, 9.4), (12.4, 7.4)]).erase(),
                Shape::Stroke(2.0, vec![(2.0, 15.0), (16.0, 15.0), (18.8, 11.6)]),
                Shape::Disc((19.0, 10.8), 2.3),
                Shape::Stroke(2.6, vec![(5.4, 16.0), (3.8, 18.4)]),
                Shape::Stroke(2.6, vec![(12.4, 16.0), (14.0, 18.4)]),
            ],
        ),
        (
            "low_charge",
            join([
                battery(),
                vec![
                    fill(&[(5.0, 10.0), (8.0, 10.0), (8.0, 16.0), (5.0, 16.0)]),
                    Shape::Stroke(2.0, vec![(14.0, 10.4), (14.0, 15.4)]),
                    Shape::Stroke(1.8, vec![(11.6, 13.2), (14.0, 15.6), (16.4, 13.2)]),
                ],
            ]),
        ),
        ("battery_cut", join([battery(), slash])),
        (
            "charge_plug",
            vec![
                fill(&[(5.6, 7.6), (16.4, 7.6), (16.4, 10.4), (13.4, 14.4), (8.6, 14.4), (5.6, 10.4)]),
                Shape::Stroke(2.0, vec![(8.0, 3.0), (8.0, 8.0)]),
                Shape::Stroke(2.0, vec![(14.0, 3.0), (14.0, 8.0)]),
                Shape::Stroke(2.0, vec![(11.0, 14.0), (11.0, 17.4), (12.4, 19.2), (16.4, 19.2)]),
            ],
        ),
        ("charging", join([battery(), vec![bolt(11.0, 13.0, 3.4, 5.2)]])),
        (
            "low_voltage",
            join([
                battery(),
                vec![
                    stroke(&[(6.0, 13.0), (9.0, 13.0)]),
                    stroke(&[(13.0, 13.0), (17.0, 13.0)]),
                    stroke(&[(15.0, 11.0), (15.0, 15.0)]),
                ],
            ]),
        ),
        (
            "steering",
            join([
                vec![
                    Shape::ring((9.4, 11.0), 7.6, LINE),
                    Shape::Disc((9.4, 11.4), 2.3),
                    stroke(&[(2.4, 10.2), (16.4, 10.2)]),
                    stroke(&[(9.4, 11.0), (9.4, 18.0)]),
                ],
                bang(20.0, 4.0, 18.0),
            ]),
        ),
        (
            "compressor",
            vec![
                Shape::ring((11.0, 11.0), 8.6, LINE),
                stroke(&[(11.0, 3.2), (5.2, 16.4)]),
                stroke(&[(11.0, 3.2), (16.8, 16.4)]),
                Shape::Disc((11.0, 12.6), 1.7),
            ],
        ),
        (
            "parking_brake",
            vec![
                Shape::ring((11.0, 11.0), 6.6, LINE),
                Shape::Arc((11.0, 11.0), 9.7, 1.7, 140.0, 220.0),
                Shape::Arc((11.0, 11.0), 9.7, 1.7, -40.0, 40.0),
                stroke(&[(9.6, 14.6), (9.6, 7.6), (11.4, 7.6)]),
                Shape::Arc((11.4, 9.5), 1.9, LINE, -90.0, 90.0),
                stroke(&[(9.6, 11.4), (11.4, 11.4)]),
            ],
        ),
        (
            "door",
            vec![
                Shape::outline(
                    1.7,
                    &[
                        (8.2, 2.4),
                        (13.8, 2.4),
                        (15.0, 5.0),
                        (15.0, 17.6),
                        (13.8, 19.6),
                        (8.2, 19.6),
                        (7.0, 17.6),
                        (7.0, 5.0),
                    ],
                ),
                Shape::Stroke(1.5, vec![(8.6, 7.0), (13.4, 7.0)]),
                Shape::Stroke(1.5, vec![(8.6, 16.0), (13.4, 16.0)]),
                Shape::Stroke(1.8, vec![(6.2, 8.0), (1.6, 13.4), (6.2, 12.6)]),
                Shape::Stroke(1.8, vec![(15.8, 8.0), (20.4, 13.4), (15.8, 12.6)]),
            ],
        ),
        (
            "air_pressure",
            vec![
                Shape::Arc((11.0, 12.2), 8.4, LINE, 150.0, 390.0),
                Shape::Stroke(2.0, vec![(11.0, 12.2), (6.2, 9.0)]),
                Shape::Disc((11.0, 12.2), 1.9),
                Shape::Stroke(1.5, vec![(15.6, 9.6), (17.0, 8.8)]),
                Shape::Stroke(1.5, vec![(11.0, 5.4), (11.0, 6.6)]),
                Shape::Stroke(1.9, vec![(8.4, 16.6), (11.0, 19.4), (13.6, 16.6)]),
            ],
        ),
        (
            "no_communication",
            vec![
                boxed(2.0, 8.0, 7.0, 14.0),
                boxed(15.0, 8.0, 20.0, 14.0),
                Shape::Stroke(1.8, vec![(9.0, 9.0), (13.0, 13.0)]),
                Shape::Stroke(1.8, vec![(13.0, 9.0), (9.0, 13.0)]),
                stroke(&[(4.5, 15.0), (4.5, 18.0), (17.5, 18.0), (17.5, 15.0)]),
                Shape::Stroke(4.0, vec![(9.6, 18.0), (12.4, 18.0)]).erase(),
                stroke(&[(4.5, 7.0), (4.5, 4.0), (17.5, 4.0), (17.5, 7.0)]),
                Shape::Stroke(4.0, vec![(9.6, 4.0), (12.4, 4.0)]).erase(),
            ],
        ),
        ("anti_lock", join([brake_brackets(), letters([A, B, S])])),
        ("brake_force", join([brake_brackets(), letters([E, B, D])])),
    ])
}
