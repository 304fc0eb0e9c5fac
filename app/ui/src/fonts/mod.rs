//! Glyphs, icons and dial tables: the shapes that are drawn, as coverage in 16 levels.
//!
//! The tables are generated (`cargo xtask fonts`); this module owns how they are read.

#[rustfmt::skip]
mod generated;

pub(crate) use generated::*;

/// Stands for a digit that is missing.
pub(crate) const DASH: u8 = 1;
/// Says that the value has stopped arriving.
pub(crate) const CLOCK: u8 = 2;
/// Says that the sender marks the value as not valid.
pub(crate) const CROSS: u8 = 3;

/// One character: its box and where its coverage starts.
#[derive(Debug)]
pub(crate) struct Glyph {
    code: u16,
    /// From the pen to the box, pixels.
    pub(crate) left: i8,
    /// From the top of the capitals to the box, pixels, down.
    top: i8,
    pub(crate) width: u8,
    height: u8,
    /// From this pen to the next, pixels.
    pub(crate) advance: u8,
    start: u32,
}

impl Glyph {
    const fn new(code: u16, left: i8, top: i8, width: u8, height: u8, advance: u8, start: u32) -> Self {
        Self { code, left, top, width, height, advance, start }
    }
}

/// One row of a glyph or icon: where it starts on the screen and its packed coverage.
pub(crate) struct Coverage {
    pub(crate) x: i16,
    pub(crate) width: u16,
    /// 4 bits per pixel, the left pixel in the high half.
    pub(crate) bits: &'static [u8],
}

/// A type face in one size.
#[derive(Debug)]
pub(crate) struct Font {
    /// Height of a capital and of a figure, pixels.
    pub(crate) cap: u8,
    /// Width of the cell of a figure, pixels.
    pub(crate) digit: u8,
    /// Width of the cell of a decimal point, pixels.
    pub(crate) point: u8,
    glyphs: &'static [Glyph],
    bits: &'static [u8],
}

impl Font {
    /// Returns the place of a character in the face.
    pub(crate) fn find(&self, character: char) -> Option<u16> {
        let code = u16::try_from(u32::from(character)).ok()?;
        self.glyphs.binary_search_by_key(&code, |glyph| glyph.code).ok().map(|place| place as u16)
    }

    /// Returns the glyph at a place that [`find`](Self::find) returned.
    pub(crate) fn glyph(&self, place: u16) -> Option<&'static Glyph> {
        self.glyphs.get(usize::from(place))
    }

    /// Returns the coverage of screen row `y` of a glyph with its pen at `x` and its capitals' top at `top`.
    #[inline]
    pub(crate) fn coverage(&self, glyph: &Glyph, x: i16, top: i16, y: i16) -> Option<Coverage> {
        let row = y - top - i16::from(glyph.top);
        if row < 0 || row >= i16::from(glyph.height) {
            return None;
        }
        let stride = usize::from((glyph.width >> 1) + (glyph.width & 1));
        let start = glyph.start as usize + row as usize * stride;
        Some(Coverage {
            x: x + i16::from(glyph.left),
            width: u16::from(glyph.width),
            bits: self.bits.get(start..start + stride)?,
        })
    }

    /// Returns the rows that a text inks: the first from the top of the capitals, and how many.
    pub(crate) fn inked_rows(&self, text: &str) -> (i16, u16) {
        let glyphs = text.chars().filter_map(|character| self.glyph(self.find(character)?));
        let (top, bottom) =
            glyphs.filter(|glyph| glyph.height > 0).fold((i16::MAX, 0), |(top, bottom), glyph| {
                let first = i16::from(glyph.top);
                (top.min(first), bottom.max(first + i16::from(glyph.height)))
            });
        (top, bottom.saturating_sub(top).max(0) as u16)
    }

    /// Returns the width of a text, pixels; characters that the face lacks count as nothing.
    pub(crate) fn width(&self, text: &str) -> u16 {
        let glyphs = text.chars().filter_map(|character| self.glyph(self.find(character)?));
        glyphs.map(|glyph| u16::from(glyph.advance)).sum()
    }
}

/// One row of the dial's left half.
#[derive(Debug)]
pub(crate) struct DialRow {
    /// First column.
    pub(crate) first: u16,
    /// Columns.
    pub(crate) length: u16,
    /// Place of the first column's pixel in [`DIAL_PIXELS`].
    pub(crate) start: u16,
}

/// One pixel of the dial's left half.
#[derive(Clone, Copy)]
pub(crate) struct DialPixel(pub(crate) u16);

impl DialPixel {
    /// Returns the angle step on the left half.
    #[inline]
    pub(crate) const fn angle(self) -> u16 {
        self.0 & 0x3FF
    }

    /// Returns how much of the pixel is inked, 0 to 15.
    #[inline]
    pub(crate) const fn coverage(self) -> u16 {
        self.0 >> 10 & 15
    }

    /// Returns 0 for the outer ring, 1 for the inner.
    #[inline]
    pub(crate) const fn ring(self) -> usize {
        (self.0 >> 14 & 1) as usize
    }
}

/// Returns the words of a table of little-endian bytes.
const fn words<const WORDS: usize>(bytes: &[u8]) -> [u16; WORDS] {
    assert!(bytes.len() == 2 * WORDS, "the table and its length belong together: run `cargo xtask fonts`");
    let mut words = [0; WORDS];
    let mut place = 0;
    while place < WORDS {
        words[place] = u16::from_le_bytes([bytes[2 * place], bytes[2 * place + 1]]);
        place += 1;
    }
    words
}

/// Returns the coverage of row `row` of the icon at `place`, drawn at `x`.
#[inline]
pub(crate) fn icon_coverage(place: usize, x: i16, row: u16) -> Option<Coverage> {
    let stride = usize::from(ICON_SIZE).div_ceil(2);
    let start = (place * usize::from(ICON_SIZE) + usize::from(row)) * stride;
    Some(Coverage { x, width: ICON_SIZE, bits: ICON_BITS.get(start..start + stride)? })
}
