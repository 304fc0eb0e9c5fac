//! A few vector shapes and their coverage on a pixel grid.
//!
//! Owns the drawing primitives of icons and marks: strokes, polygons, discs, rings, and erasing with any of them.
//! Coverage is counted on 16 x 16 points per pixel and kept in 16 levels.

/// A point in pixels, y downwards.
pub(crate) type P = (f32, f32);

/// One shape; lengths in pixels.
#[derive(Clone, Debug)]
pub(crate) enum Shape {
    /// A line through the points with round joints and ends: width, points.
    Stroke(f32, Vec<P>),
    /// A filled polygon.
    Fill(Vec<P>),
    /// A filled circle: centre, radius.
    Disc(P, f32),
    /// A part of a circle line: centre, radius, width, from and to in degrees clockwise from the right.
    Arc(P, f32, f32, f32, f32),
    /// Takes away what the shape covers.
    Erase(Box<Shape>),
}

impl Shape {
    /// Returns the closed stroke through `points`.
    pub(crate) fn outline(width: f32, points: &[P]) -> Self {
        Self::Stroke(width, points.iter().chain(points.first()).copied().collect())
    }

    /// Returns the circle line.
    pub(crate) fn ring(centre: P, radius: f32, width: f32) -> Self {
        Self::Arc(centre, radius, width, 0.0, 360.0)
    }

    /// Returns the shape as an eraser.
    pub(crate) fn erase(self) -> Self {
        Self::Erase(Box::new(self))
    }

    fn covers(&self, (x, y): P) -> bool {
        match self {
            Self::Stroke(width, points) => {
                points.windows(2).any(|ends| distance((x, y), ends[0], ends[1]) <= width / 2.0)
            }
            Self::Fill(points) => inside((x, y), points),
            Self::Disc((cx, cy), radius) => (x - cx).hypot(y - cy) <= *radius,
            Self::Arc((cx, cy), radius, width, from, to) => {
                let angle = (y - cy).atan2(x - cx).to_degrees();
                let turned = (angle - from).rem_euclid(360.0);
                ((x - cx).hypot(y - cy) - radius).abs() <= width / 2.0 && turned <= to - from
            }
            Self::Erase(shape) => shape.covers((x, y)),
        }
    }
}

fn distance((x, y): P, (ax, ay): P, (bx, by): P) -> f32 {
    let (dx, dy) = (bx - ax, by - ay);
    let length = (dx * dx + dy * dy).max(1e-9);
    let along = (((x - ax) * dx + (y - ay) * dy) / length).clamp(0.0, 1.0);
    (x - ax - along * dx).hypot(y - ay - along * dy)
}

fn inside((x, y): P, points: &[P]) -> bool {
    let mut odd = false;
    for (index, &(ax, ay)) in points.iter().enumerate() {
        let (bx, by) = points[(index + 1) % points.len()];
        if (ay > y) != (by > y) && x < (bx - ax) * (y - ay) / (by - ay) + ax {
            odd = !odd;
        }
    }
    odd
}

const STEPS: u32 = 16;

/// Returns the coverage of each pixel, 0..=15, row by row; later shapes lie over earlier ones.
pub(crate) fn rasterise(shapes: &[Shape], width: usize, height: usize) -> Vec<u8> {
    let mut levels = Vec::with_capacity(width * height);
    for row in 0..height {
        for column in 0..width {
            let mut hits = 0;
            for step in 0..STEPS * STEPS {
                let (u, v) = ((step % STEPS) as f32 + 0.5, (step / STEPS) as f32 + 0.5);
                let point = (column as f32 + u / STEPS as f32, row as f32 + v / STEPS as f32);
                let top = shapes.iter().rev().find(|shape| shape.covers(point));
                hits += u32::from(top.is_some_and(|shape| !matches!(shape, Shape::Erase(_))));
            }
            levels.push(((hits * 15 + 128) / 256) as u8);
        }
    }
    levels
}
