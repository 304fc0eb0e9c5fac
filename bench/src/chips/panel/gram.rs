//! The panel's picture memory: 240 x 320 pixels, when each was written, which of them flickered.
//!
//! Owns the way from a window address to a memory cell (MADCTL's mirroring and exchange) and nothing of the protocol.
//! Source: ILI9341 V1.11, 8.2.29 and 9.3 (MCU to memory write direction); ST7789V, 8.12 gives the same table.

use crate::time::Nanos;

/// Columns of the memory.
pub const COLUMNS: u16 = 240;
/// Pages (rows) of the memory.
pub const PAGES: u16 = 320;

/// MADCTL.MY: the page address is mirrored.
pub(super) const MY: u8 = 1 << 7;
/// MADCTL.MX: the column address is mirrored.
pub(super) const MX: u8 = 1 << 6;
/// MADCTL.MV: column and page are exchanged.
pub(super) const MV: u8 = 1 << 5;

/// One pixel and its past.
#[derive(Clone, Copy, Debug)]
struct Cell {
    colour: u16,
    /// The last picture that changed it, and the colour it had before that picture.
    changed_in: u64,
    before: u16,
    changed_at: Nanos,
    written_at: Option<Nanos>,
}

/// Where a window address lies in memory: `origin + column * per_column + page * per_page`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    origin: i32,
    per_column: i32,
    per_page: i32,
    /// First invalid column and page address.
    columns: u16,
    pages: u16,
}

impl Layout {
    /// The layout under the MY, MX and MV bits of `madctl`.
    pub(super) fn of(madctl: u8) -> Self {
        let (columns, pages) = (i32::from(COLUMNS), i32::from(PAGES));
        let (column_start, column_step) = if madctl & MX != 0 { (columns - 1, -1) } else { (0, 1) };
        let (page_start, page_step) = if madctl & MY != 0 { (pages - 1, -1) } else { (0, 1) };
        let origin = column_start + page_start * columns;
        let (along_column, along_page) = (column_step, page_step * columns);
        if madctl & MV != 0 {
            Self { origin, per_column: along_page, per_page: along_column, columns: PAGES, pages: COLUMNS }
        } else {
            Self { origin, per_column: along_column, per_page: along_page, columns: COLUMNS, pages: PAGES }
        }
    }

    /// Number of column and of page addresses.
    pub(super) fn size(&self) -> (u16, u16) {
        (self.columns, self.pages)
    }

    #[inline]
    fn index(&self, column: u16, page: u16) -> usize {
        // A window that was set under another MADCTL may reach outside.
        if column >= self.columns || page >= self.pages {
            return usize::MAX;
        }
        let index = self.origin + i32::from(column) * self.per_column + i32::from(page) * self.per_page;
        usize::try_from(index).unwrap_or(usize::MAX)
    }
}

/// The memory.
#[derive(Clone, Debug)]
pub(super) struct Gram {
    cells: Vec<Cell>,
    /// Number of the picture that is being written.
    picture: u64,
    changed: u64,
    flickered: u64,
}

impl Gram {
    /// A memory full of noise, the same in every run: pixels that nobody has drawn must show.
    pub(super) fn new() -> Self {
        let mut noise = 0x0009_3417_u32;
        let cells = (0..usize::from(COLUMNS) * usize::from(PAGES))
            .map(|_| {
                noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let colour = (noise >> 16) as u16;
                Cell { colour, changed_in: 0, before: colour, changed_at: Nanos::ZERO, written_at: None }
            })
            .collect();
        Self { cells, picture: 0, changed: 0, flickered: 0 }
    }

    /// What is written from now on belongs to another picture.
    pub(super) fn begin_picture(&mut self) {
        self.picture += 1;
    }

    /// Writes one pixel; addresses outside the memory are ignored.
    #[inline]
    pub(super) fn write(&mut self, now: Nanos, layout: &Layout, column: u16, page: u16, colour: u16) {
        let Some(cell) = self.cells.get_mut(layout.index(column, page)) else { return };
        if cell.colour != colour {
            if cell.changed_in != self.picture {
                (cell.changed_in, cell.before) = (self.picture, cell.colour);
            } else if cell.before == colour {
                // A -> X -> A: neither the picture before nor this one has X, and the eye saw it.
                self.flickered += 1;
            }
            self.changed += 1;
            cell.colour = colour;
            cell.changed_at = now;
        }
        cell.written_at = Some(now);
    }

    /// RGB565 of a pixel.
    pub(super) fn colour(&self, layout: &Layout, column: u16, page: u16) -> u16 {
        self.cells.get(layout.index(column, page)).map_or(0, |cell| cell.colour)
    }

    /// When a pixel was last written.
    pub(super) fn written_at(&self, layout: &Layout, column: u16, page: u16) -> Option<Nanos> {
        self.cells.get(layout.index(column, page)).and_then(|cell| cell.written_at)
    }

    /// The last write to any pixel of the memory.
    pub(super) fn last_write(&self) -> Option<Nanos> {
        self.cells.iter().filter_map(|cell| cell.written_at).max()
    }

    /// The last write that changed a pixel.
    pub(super) fn last_change(&self) -> Option<Nanos> {
        self.cells.iter().filter(|cell| cell.written_at.is_some()).map(|cell| cell.changed_at).max()
    }

    /// Pixels that nobody has written.
    pub(super) fn undrawn(&self) -> usize {
        self.cells.iter().filter(|cell| cell.written_at.is_none()).count()
    }

    /// When a pixel was last changed; `None` if it was never written.
    pub(super) fn changed_at(&self, layout: &Layout, column: u16, page: u16) -> Option<Nanos> {
        let cell = self.cells.get(layout.index(column, page))?;
        cell.written_at.map(|_| cell.changed_at)
    }

    /// Writes that gave a pixel another colour.
    pub(super) fn changed(&self) -> u64 {
        self.changed
    }

    /// Pixels that left their colour and came back to it within one picture.
    pub(super) fn flickered(&self) -> u64 {
        self.flickered
    }
}
