//! A tile of the picture in memory, in the order in which the panel wants its bytes.
//!
//! Owns the step from colours to panel words; [`Screen::draw`](crate::Screen::draw) is its usual customer. Refuses to
//! know buses and DMA: the board sends [`Tile::pixels`] however it likes.
//! Source: ILI9341 and ST7789 datasheets, 65K colour mode: 16 bits per pixel, most significant byte first.

use core::convert::Infallible;
use embedded_graphics_core::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    pixelcolor::{IntoStorage, Rgb565},
    primitives::Rectangle,
};

/// One pixel as it lies in a send buffer.
pub trait PanelPixel: Copy {
    /// Returns the pixel of a 5-6-5 colour word.
    fn from_word(word: u16) -> Self;
    /// Returns the 5-6-5 colour word of the pixel.
    fn word(self) -> u16;
}

/// For 16-bit SPI frames: the bus sends the most significant bit first, so a word lies in memory as it is.
impl PanelPixel for u16 {
    #[inline(always)]
    fn from_word(word: u16) -> Self {
        word
    }

    #[inline(always)]
    fn word(self) -> u16 {
        self
    }
}

/// For 8-bit SPI frames: most significant byte first; `as_flattened()` of the pixels gives the bytes.
impl PanelPixel for [u8; 2] {
    #[inline(always)]
    fn from_word(word: u16) -> Self {
        word.to_be_bytes()
    }

    #[inline(always)]
    fn word(self) -> u16 {
        u16::from_be_bytes(self)
    }
}

/// A rectangle of the screen with its pixels, row by row, in a borrowed buffer.
///
/// Pixels outside the rectangle are dropped, as every [`DrawTarget`] does.
#[derive(Debug)]
pub struct Tile<'a, P> {
    area: Rectangle,
    pixels: &'a mut [P],
}

impl<'a, P: PanelPixel> Tile<'a, P> {
    /// Lays the tile of `area` over the start of `buffer`; `None` if the buffer is too small.
    pub fn new(buffer: &'a mut [P], area: Rectangle) -> Option<Self> {
        let length = area.size.width as usize * area.size.height as usize;
        Some(Self { area, pixels: buffer.get_mut(..length)? })
    }

    /// Returns the pixels to send, row by row.
    pub fn pixels(&self) -> &[P] {
        self.pixels
    }

    /// Returns the index of a point that is known to lie inside.
    #[inline(always)]
    fn index(&self, point: Point) -> usize {
        let (column, row) = (point.x - self.area.top_left.x, point.y - self.area.top_left.y);
        row as usize * self.area.size.width as usize + column as usize
    }

    fn is_whole_rows(&self, part: &Rectangle) -> bool {
        part.top_left.x == self.area.top_left.x && part.size.width == self.area.size.width
    }
}

impl<P> Dimensions for Tile<'_, P> {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl<P: PanelPixel> DrawTarget for Tile<'_, P> {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, colour) in pixels {
            if self.area.contains(point) {
                let index = self.index(point);
                self.pixels[index] = P::from_word(colour.into_storage());
            }
        }
        Ok(())
    }

    #[inline]
    fn fill_contiguous<I>(&mut self, area: &Rectangle, colours: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Rgb565>,
    {
        let part = area.intersection(&self.area);
        if part == *area && (area.size.height == 1 || self.is_whole_rows(area)) {
            let start = self.index(area.top_left);
            let length = area.size.width as usize * area.size.height as usize;
            for (pixel, colour) in self.pixels[start..start + length].iter_mut().zip(colours) {
                *pixel = P::from_word(colour.into_storage());
            }
            return Ok(());
        }
        let width = area.size.width.max(1) as i32;
        let (mut column, mut row) = (0, 0);
        self.draw_iter(colours.into_iter().take(area.size.width as usize * area.size.height as usize).map(
            |colour| {
                let point = area.top_left + Point::new(column, row);
                column += 1;
                if column == width {
                    (column, row) = (0, row + 1);
                }
                Pixel(point, colour)
            },
        ))
    }

    #[inline]
    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Infallible> {
        let part = area.intersection(&self.area);
        if part.is_zero_sized() {
            return Ok(());
        }
        let (pixel, width) = (P::from_word(colour.into_storage()), part.size.width as usize);
        let start = self.index(part.top_left);
        if self.is_whole_rows(&part) {
            self.pixels[start..start + width * part.size.height as usize].fill(pixel);
        } else {
            let stride = self.area.size.width as usize;
            for row in self.pixels[start..].chunks_mut(stride).take(part.size.height as usize) {
                row[..width].fill(pixel);
            }
        }
        Ok(())
    }
}

/// Returns the rectangle of `width` times `height` pixels at (`x`, `y`).
pub(crate) const fn rectangle(x: u16, y: u16, width: u16, height: u16) -> Rectangle {
    Rectangle { top_left: Point::new(x as i32, y as i32), size: Size::new(width as u32, height as u32) }
}
