//! Tiles in memory against the strict panel, and the order of their bytes.

mod common;

use cluster::{Page, Telltales, Trip, View};
use common::{Panel, day, english, list, missing, on, rectangle, sheets, travelled};
use embedded_graphics_core::{
    Pixel,
    draw_target::DrawTarget,
    geometry::Point,
    pixelcolor::{Rgb565, raw::RawU16},
};
use ui::{HEIGHT, Screen, TILE_PIXELS, Tile, WIDTH};

fn colour(word: u16) -> Rgb565 {
    Rgb565::from(RawU16::new(word))
}

/// Paints everything that a view needs in every way and holds the ways against each other; returns the pixels seen.
fn paint_in_every_way(view: &View) -> usize {
    let expected = Panel::of(view);
    let mut screen = Screen::new();
    screen.update(view);
    let (mut words, mut bytes, mut rendered) =
        ([0_u16; TILE_PIXELS], [[0_u8; 2]; TILE_PIXELS], [0_u16; TILE_PIXELS]);
    let mut seen = 0;
    while let Some(area) = screen.next_tile(TILE_PIXELS) {
        let mut tile = Tile::new(&mut words, area).unwrap();
        screen.draw(&area, &mut tile).unwrap();
        let mut byte_tile = Tile::new(&mut bytes, area).unwrap();
        screen.draw(&area, &mut byte_tile).unwrap();
        let straight = screen.render(&area, &mut rendered).unwrap();
        assert_eq!(tile.pixels(), straight);
        let sent = byte_tile.pixels().as_flattened();
        for (index, &word) in straight.iter().enumerate() {
            let (x, y) = (index % area.size.width as usize, index / area.size.width as usize);
            let place = (area.top_left.y as usize + y) * usize::from(WIDTH) + area.top_left.x as usize + x;
            assert_eq!(word, expected.pixels[place]);
            assert_eq!(
                sent[2 * index..2 * index + 2],
                [(word >> 8) as u8, word as u8],
                "most significant byte first"
            );
            seen += 1;
        }
    }
    seen
}

#[test]
fn memory_and_a_draw_target_get_the_same_pixels_on_every_page() {
    let pages = [Page::Main, Page::Trip(Trip::B), Page::Energy, Page::Faults(list())];
    for page in pages.into_iter().chain(sheets().map(Page::Technic)) {
        let lit = View { telltales: Telltales::ALL, is_power_limited: true, ..on(page, travelled()) };
        for view in [lit, day(english(lit)), missing::<true>(lit)] {
            assert_eq!(paint_in_every_way(&view), usize::from(WIDTH) * usize::from(HEIGHT), "{page:?}");
        }
    }
}

/// The parts of an update are small and have any width, odd ones too.
#[test]
fn memory_and_a_draw_target_get_the_same_parts() {
    let mut screen = Screen::new();
    screen.update(&View::default());
    while screen.next_tile(TILE_PIXELS).is_some() {}
    screen.update(&travelled());
    let (mut words, mut rendered) = ([0_u16; TILE_PIXELS], [0_u16; TILE_PIXELS]);
    let mut parts = 0;
    while let Some(area) = screen.next_tile(TILE_PIXELS) {
        let mut tile = Tile::new(&mut words, area).unwrap();
        screen.draw(&area, &mut tile).unwrap();
        assert_eq!(Some(tile.pixels()), screen.render(&area, &mut rendered), "{area:?}");
        parts += 1;
    }
    assert!(parts > 20, "{parts}");
}

#[test]
fn a_buffer_that_is_too_small_is_refused() {
    let mut buffer = [0_u16; 99];
    assert!(Tile::new(&mut buffer, rectangle(0, 0, 10, 10)).is_none());
    assert!(Screen::new().render(&rectangle(0, 0, 10, 10), &mut buffer).is_none());
    assert!(Tile::new(&mut buffer, rectangle(0, 0, 11, 9)).is_some());
}

#[test]
fn what_lies_off_the_screen_is_not_painted() {
    let mut screen = Screen::new();
    screen.update(&View::default());
    let mut buffer = [0xAAAA_u16; 64];
    assert_eq!(screen.render(&rectangle(318, 238, 8, 8), &mut buffer).map(<[u16]>::len), Some(4));
    assert!(screen.render(&rectangle(320, 0, 8, 8), &mut buffer).is_none());
    assert!(screen.render(&rectangle(-9, -9, 8, 8), &mut buffer).is_none());
}

#[test]
fn a_tile_drops_what_lies_outside_in_every_fill() {
    let mut buffer = [0_u16; 12];
    let mut tile = Tile::new(&mut buffer, rectangle(10, 20, 4, 3)).unwrap();
    tile.fill_solid(&rectangle(8, 19, 4, 3), colour(1)).unwrap();
    tile.fill_contiguous(&rectangle(12, 22, 4, 4), (2..).map(colour)).unwrap();
    tile.draw_iter([Pixel(Point::new(13, 20), colour(9)), Pixel(Point::new(14, 20), colour(9))]).unwrap();
    assert_eq!(tile.pixels(), [1, 1, 0, 9, 1, 1, 0, 0, 0, 0, 2, 3]);
}

#[test]
fn fills_of_whole_rows_and_parts_meet_their_pixels() {
    let mut buffer = [0_u16; 12];
    let mut tile = Tile::new(&mut buffer, rectangle(0, 0, 4, 3)).unwrap();
    tile.fill_contiguous(&rectangle(0, 1, 4, 2), (1..).map(colour)).unwrap();
    tile.fill_contiguous(&rectangle(1, 0, 2, 1), (20..).map(colour)).unwrap();
    tile.fill_solid(&rectangle(0, 2, 4, 1), colour(7)).unwrap();
    assert_eq!(tile.pixels(), [0, 20, 21, 0, 1, 2, 3, 4, 7, 7, 7, 7]);
}
