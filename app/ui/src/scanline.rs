//! One row of pixels that is being put together before it is sent.

use crate::{fonts::Coverage, theme::Ramp};

/// A part of a screen row: widgets paint into it, nothing outside it is touched.
pub(crate) struct Scanline<'a> {
    /// Scanline of the screen.
    pub(crate) y: u16,
    /// Column of the first pixel.
    pub(crate) left: u16,
    /// Colours.
    pub(crate) pixels: &'a mut [u16],
}

impl Scanline<'_> {
    /// Cuts the columns `x..x + width` to this row: pixels to paint and how many were cut on the left.
    #[inline]
    pub(crate) fn cut(&mut self, x: i16, width: u16) -> (&mut [u16], usize) {
        let from = (x - self.left as i16).max(0) as usize;
        let to = (x + width as i16 - self.left as i16).max(0) as usize;
        let to = to.min(self.pixels.len());
        let skipped = (self.left as i16 - x).max(0) as usize;
        (self.pixels.get_mut(from..to).unwrap_or_default(), skipped)
    }

    /// Returns whether a cell has columns in this row.
    #[inline]
    pub(crate) fn meets(&self, x: u16, width: u16) -> bool {
        x < self.left + self.pixels.len() as u16 && self.left < x + width
    }

    /// Paints columns in one colour.
    #[inline]
    pub(crate) fn fill(&mut self, x: u16, width: u16, colour: u16) {
        fill(self.cut(x as i16, width).0, colour);
    }

    /// Paints a row of a glyph or icon.
    #[inline]
    pub(crate) fn cover(&mut self, coverage: &Coverage, ramp: &Ramp) {
        let (pixels, skipped) = self.cut(coverage.x, coverage.width);
        let mut bits = coverage.bits.iter().skip(skipped / 2);
        let mut pixels = pixels;
        if skipped & 1 != 0
            && let (Some((first, rest)), Some(byte)) =
                (core::mem::take(&mut pixels).split_first_mut(), bits.next())
        {
            blend(first, byte & 15, ramp);
            pixels = rest;
        }
        // Two pixels share a byte; most bytes are empty or full.
        let mut pairs = pixels.chunks_exact_mut(2);
        for (pair, &byte) in pairs.by_ref().zip(bits.by_ref()) {
            match byte {
                0 => {}
                0xFF => pair.fill(ramp[15]),
                _ => {
                    if let [left, right] = pair {
                        blend(left, byte >> 4, ramp);
                        blend(right, byte & 15, ramp);
                    }
                }
            }
        }
        if let ([last], Some(byte)) = (pairs.into_remainder(), bits.next()) {
            blend(last, byte >> 4, ramp);
        }
    }
}

#[inline(always)]
fn blend(pixel: &mut u16, level: u8, ramp: &Ramp) {
    if level != 0 {
        *pixel = ramp[usize::from(level & 15)];
    }
}

/// Fills with one colour, eight pixels per turn of the loop.
#[inline]
pub(crate) fn fill(pixels: &mut [u16], colour: u16) {
    let (blocks, rest) = pixels.as_chunks_mut::<8>();
    for block in blocks {
        *block = [colour; 8];
    }
    rest.fill(colour);
}

#[cfg(test)]
mod tests {
    use super::*;

    const RAMP: Ramp = [100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115];
    /// Levels 1, 0, 15, 15, 7 of a glyph of five pixels.
    const BITS: &[u8] = &[0x10, 0xFF, 0x70];

    #[test]
    fn a_glyph_cut_at_either_side_keeps_its_columns() {
        let whole = [9, 9, 101, 9, 115, 115, 107, 9, 9];
        for left in 0..9_u16 {
            for end in left..=9 {
                let mut pixels = [9; 9];
                let part = &mut pixels[usize::from(left)..usize::from(end)];
                Scanline { y: 0, left, pixels: part }.cover(&Coverage { x: 2, width: 5, bits: BITS }, &RAMP);
                assert_eq!(
                    pixels[usize::from(left)..usize::from(end)],
                    whole[usize::from(left)..usize::from(end)],
                    "{left}..{end}"
                );
            }
        }
    }

    #[test]
    fn filling_reaches_exactly_the_columns() {
        let mut pixels = [0; 40];
        Scanline { y: 0, left: 10, pixels: &mut pixels }.fill(13, 21, 7);
        for (column, pixel) in (10..).zip(pixels) {
            assert_eq!(pixel == 7, (13..34).contains(&column), "{column}");
        }
    }
}
