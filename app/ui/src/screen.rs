//! What the panel shows, what has to be sent, and how a tile is painted.
//!
//! A tile is put together row by row in one buffer and given away once: no pixel is cleared first. A widget paints
//! inside its place only; one that does not meet the tile costs one comparison per tile.

use crate::{
    HEIGHT, WIDTH,
    layout::{Area, LABELS, WIDGETS},
    pages::{Kind, MOST_ELEMENTS},
    picture::{Picture, label_area},
    regions::Regions,
    scanline::{Scanline, fill},
    tile::rectangle,
};
use cluster::View;
use embedded_graphics_core::{
    draw_target::DrawTarget,
    pixelcolor::{Rgb565, raw::RawU16},
    primitives::Rectangle,
};

/// A whole picture is sent in this order: what the driver must not miss goes first.
const SWEEP: [Area; 4] = [
    Area::new(0, 213, WIDTH, 27),
    Area::new(0, 0, WIDTH, 26),
    Area::new(0, 189, WIDTH, 24),
    crate::layout::PAGE,
];

/// Place in [`SWEEP`] of what changes with the page.
const PAGE: u8 = 3;

/// The picture on the panel and the parts of it that have to be sent.
///
/// A new screen has nothing on the panel: the first tiles are the whole picture.
#[derive(Clone, Debug)]
pub struct Screen {
    picture: Picture,
    regions: Regions,
    /// Next area of [`SWEEP`] that has to be sent whole.
    sweep: u8,
    /// Rest of an area of which tiles were handed out.
    rest: Option<Area>,
    /// Places of the labels in the language of the picture.
    labels: [Area; LABELS.len()],
    /// Whether there has been a view.
    is_set: bool,
}

impl Default for Screen {
    fn default() -> Self {
        Self::new()
    }
}

impl Screen {
    /// Returns a screen of which nothing is on the panel yet.
    pub const fn new() -> Self {
        Self {
            picture: Picture::EMPTY,
            regions: Regions::CLEAN,
            sweep: 0,
            rest: None,
            labels: [Area::new(0, 0, 0, 0); LABELS.len()],
            is_set: false,
        }
    }

    /// Takes over `view` and marks what differs from the picture on the panel.
    pub fn update(&mut self, view: &View) {
        let picture = Picture::of(view);
        if self.is_set && (picture.theme, picture.language) == (self.picture.theme, self.picture.language) {
            if picture.kind == self.picture.kind {
                self.regions.mark_changes(&self.picture, &picture);
            } else {
                // Another page: everything between the lamps.
                self.regions.forget_page();
                self.regions.mark_frame(&self.picture, &picture);
                self.sweep = self.sweep.min(PAGE);
            }
        } else {
            for (place, label) in self.labels.iter_mut().zip(&LABELS) {
                *place = label_area(label, picture.language);
            }
            self.is_set = true;
            self.mark_all();
        }
        self.picture = picture;
    }

    /// Marks the whole picture, for example after the panel was reset.
    pub fn mark_all(&mut self) {
        self.regions = Regions::CLEAN;
        self.sweep = 0;
        self.rest = None;
    }

    /// Returns whether everything has been handed out.
    pub fn is_clean(&self) -> bool {
        self.rest.is_none() && usize::from(self.sweep) == SWEEP.len() && self.regions.is_clean()
    }

    /// Hands out the next part to send, at most `max_pixels` large; `None` = the panel shows the last view.
    ///
    /// Parts are one row high at least: `max_pixels` below [`WIDTH`] is taken as [`WIDTH`].
    ///
    /// The part counts as sent: paint and send it before the next [`update`](Self::update) is shown.
    pub fn next_tile(&mut self, max_pixels: usize) -> Option<Rectangle> {
        let area = self.rest.take().or_else(|| self.next_area())?;
        let rows = u16::try_from(max_pixels / usize::from(area.width)).unwrap_or(u16::MAX);
        let height = area.height.min(rows.max(1));
        if height < area.height {
            self.rest = Some(Area::new(area.x, area.y + height, area.width, area.height - height));
        }
        Some(rectangle(area.x, area.y, area.width, height))
    }

    fn next_area(&mut self) -> Option<Area> {
        if let Some(&area) = SWEEP.get(usize::from(self.sweep)) {
            if self.sweep == PAGE
                && let Some(urgent) = self.regions.take_urgent(self.picture.kind)
            {
                return Some(urgent);
            }
            self.sweep += 1;
            return Some(area);
        }
        self.regions.take(self.picture.kind)
    }

    /// Paints exactly the pixels of `tile`, each once, row by row.
    ///
    /// For a buffer in memory [`render`](Self::render) does the same without a copy.
    ///
    /// # Errors
    ///
    /// What the target returns.
    pub fn draw<D: DrawTarget<Color = Rgb565>>(
        &self,
        tile: &Rectangle,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let Some(area) = on_screen(tile) else { return Ok(()) };
        let met = self.met(area);
        let mut pixels = [0_u16; WIDTH as usize];
        let pixels = &mut pixels[..usize::from(area.width)];
        for y in area.y..area.bottom() {
            self.paint_row(&met, area, y, pixels);
            let colours = pixels.iter().map(|&word| Rgb565::from(RawU16::new(word)));
            target.fill_contiguous(&rectangle(area.x, y, area.width, 1), colours)?;
        }
        Ok(())
    }

    /// Paints `tile` straight into the start of `buffer` and returns what to send, row by row, for 16-bit SPI frames.
    ///
    /// Returns `None` if the tile is not on the screen or the buffer is too small.
    pub fn render<'a>(&self, tile: &Rectangle, buffer: &'a mut [u16]) -> Option<&'a [u16]> {
        let area = on_screen(tile)?;
        let pixels = buffer.get_mut(..area.pixels() as usize)?;
        let met = self.met(area);
        for (y, pixels) in (area.y..).zip(pixels.chunks_exact_mut(usize::from(area.width))) {
            self.paint_row(&met, area, y, pixels);
        }
        Some(pixels)
    }

    /// Returns where something is that [`Self::met`] has found.
    fn place(&self, index: usize) -> Area {
        match index {
            ..FIRST_LABEL => WIDGETS[index].1,
            FIRST_LABEL..FIRST_ELEMENT => self.labels[index - FIRST_LABEL],
            FIRST_ELEMENT.. => self.picture.kind.places()[index - FIRST_ELEMENT].area,
        }
    }

    /// Finds what meets an area.
    fn met(&self, area: Area) -> Met {
        let mut met = Met { places: [0; MOST_MET], count: 0 };
        let mut note = |index: usize, place: &Area| {
            if place.meets(area) {
                met.places[met.count] = index as u8;
                met.count += 1;
            }
        };
        let is_main = self.picture.kind == Kind::Main;
        for (index, (widget, place)) in WIDGETS.iter().enumerate() {
            if is_main || widget.is_on_every_page() {
                note(index, place);
            }
        }
        if is_main {
            self.labels.iter().enumerate().for_each(|(index, place)| note(FIRST_LABEL + index, place));
        }
        let places = self.picture.kind.places().iter().enumerate();
        places.for_each(|(index, place)| note(FIRST_ELEMENT + index, &place.area));
        met
    }

    fn paint_row(&self, met: &Met, area: Area, y: u16, pixels: &mut [u16]) {
        fill(pixels, self.picture.ground(y));
        for &index in &met.places[..met.count] {
            let index = usize::from(index);
            let place = self.place(index);
            if y < place.y || y >= place.bottom() {
                continue;
            }
            // Widgets keep to their places, whatever they paint.
            let (left, right) = (place.x.max(area.x), place.right().min(area.right()));
            let columns = usize::from(left - area.x)..usize::from(right - area.x);
            let mut row = Scanline { y, left, pixels: &mut pixels[columns] };
            match index {
                ..FIRST_LABEL => self.picture.paint(WIDGETS[index].0, &mut row),
                FIRST_LABEL..FIRST_ELEMENT => {
                    self.picture.paint_label(&LABELS[index - FIRST_LABEL], &mut row);
                }
                FIRST_ELEMENT.. => self.picture.paint_element(index - FIRST_ELEMENT, &mut row),
            }
        }
    }
}

const FIRST_LABEL: usize = WIDGETS.len();
const FIRST_ELEMENT: usize = FIRST_LABEL + LABELS.len();
const MOST_MET: usize = FIRST_ELEMENT + MOST_ELEMENTS;

/// What meets a tile: places in [`WIDGETS`], then in [`LABELS`], then among the elements of the page.
struct Met {
    places: [u8; MOST_MET],
    count: usize,
}

/// Returns the part of a tile that is on the screen.
fn on_screen(tile: &Rectangle) -> Option<Area> {
    let tile = tile.intersection(&rectangle(0, 0, WIDTH, HEIGHT));
    let area = Area::new(
        tile.top_left.x as u16,
        tile.top_left.y as u16,
        tile.size.width as u16,
        tile.size.height as u16,
    );
    (area.pixels() > 0).then_some(area)
}
