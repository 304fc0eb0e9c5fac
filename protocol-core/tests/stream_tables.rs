//! Jiulong's streams of cell voltages and module temperatures, frame by frame.
//!
//! The frames are built here from the words of the document (PF counting down from 0xE6, pairs of number and voltage,
//! zeros behind the last), not by the generated codec.

use proptest::prelude::*;
use protocol_core::CanId;
use protocol_core::generated::{VEHICLES, jiulong};
use protocol_core::stream::{Extreme, KEPT, ROOM, Stream, Streams, Summary};

const VEHICLE: &protocol_core::Vehicle = &jiulong::VEHICLE;

/// Frame `index` (from 0) of the cell voltages: PF = 0xE6 - index (JL-R020).
fn cell_id(index: u32) -> CanId {
    CanId::extended(0x1800_28F3 | (0xE6 - index) << 16)
}

/// Frame of module `number` (from 1): PF = 3 + number (JL-28).
fn module_id(number: u32) -> CanId {
    CanId::extended(0x1800_28F3 | (3 + number) << 16)
}

/// The frames of one cycle of a pack whose cells are numbered from `first`.
fn cycle(first: u16, voltages: &[u8]) -> Vec<(CanId, [u8; 8])> {
    let frames = voltages.chunks(4).enumerate().map(|(index, four)| {
        let mut data = [0; 8];
        for (place, voltage) in four.iter().enumerate() {
            data[2 * place] = (first + 4 * index as u16 + place as u16) as u8;
            data[2 * place + 1] = *voltage;
        }
        (cell_id(index as u32), data)
    });
    frames.collect()
}

fn stream(name: &str) -> &'static Stream {
    VEHICLE.streams.iter().find(|stream| stream.name == name).expect("a stream of the vehicle")
}

#[derive(Clone)]
struct Pack(Streams);

impl Pack {
    fn new() -> Self {
        Self(Streams::new())
    }

    fn hear(&mut self, frames: &[(CanId, [u8; 8])]) {
        for (id, data) in frames {
            if let Some((stream, index)) = VEHICLE.stream_of(*id) {
                self.0.store(stream, index, data);
            }
        }
    }

    fn cells(&self) -> Vec<(u16, u8)> {
        self.0.cells(stream("cells")).collect()
    }

    fn summary(&self) -> Summary {
        self.0.summary(stream("cells"))
    }
}

#[test]
fn jl_r020_jl_27_only_pf_e6_down_to_a7_are_cell_voltages() {
    let of = |id| VEHICLE.stream_of(id).map(|(stream, index)| (stream.name, index));
    for index in 0..64 {
        assert_eq!(of(cell_id(index)), Some(("cells", index as u8)));
    }
    for pf in (0..=0xA6).chain(0xE7..=0xFF) {
        let name = of(CanId::extended(0x1800_28F3 | pf << 16)).map(|(name, _)| name);
        assert_eq!(name, (4..=26).contains(&pf).then_some("modules"), "PF {pf}");
    }
    assert_eq!(of(CanId::extended(0x18E6_28F4)), None);
    assert_eq!(of(CanId::extended(0x1CE6_28F3)), None, "another priority is another identifier");
    assert_eq!(of(CanId::standard(0x0F3)), None);
}

#[test]
fn jl_r022_jl_28_module_temperatures_end_before_the_fault_frame() {
    let of = |number| VEHICLE.stream_of(module_id(number)).map(|(stream, index)| (stream.name, index));
    assert_eq!((of(1), of(23), of(24), of(0)), (Some(("modules", 0)), Some(("modules", 22)), None, None));
    assert_eq!(module_id(24), jiulong::id::BMS_FAULTS);
}

#[test]
fn jl_r021_jl_25_every_size_of_pack_has_all_its_cells_and_no_padding() {
    for size in 1..=256usize {
        for first in [0, 1] {
            if first + size > 256 {
                continue;
            }
            let voltages: Vec<u8> = (0..size).map(|cell| 160 + (cell * 7 % 40) as u8).collect();
            let mut pack = Pack::new();
            pack.hear(&cycle(first as u16, &voltages));
            let expected: Vec<(u16, u8)> = (first as u16..).zip(voltages.iter().copied()).collect();
            assert_eq!(pack.cells(), expected, "{size} cells from {first}");
            assert_eq!(usize::from(pack.summary().count), size);
        }
    }
}

#[test]
fn jl_25_zeros_are_a_cell_only_as_the_first_pair_of_the_first_frame() {
    let mut pack = Pack::new();
    pack.hear(&[(cell_id(0), [0; 8])]);
    assert_eq!(pack.cells(), [(0, 0)]);
    let mut pack = Pack::new();
    pack.hear(&[(cell_id(1), [0; 8])]);
    assert_eq!(pack.cells(), []);
    pack.hear(&[(cell_id(0), [1, 180, 0, 0, 2, 181, 0, 0])]);
    assert_eq!(pack.cells(), [(1, 180), (2, 181)]);
    pack.hear(&[(cell_id(1), [0, 175, 3, 0, 0, 0, 0, 0])]);
    assert_eq!(pack.cells(), [(0, 175), (1, 180), (2, 181), (3, 0)], "a number or a voltage makes a cell");
}

#[test]
fn a_shorter_pack_later_leaves_no_old_cells() {
    let mut pack = Pack::new();
    pack.hear(&cycle(1, &[200; 100]));
    assert_eq!(pack.summary().highest, Some(Extreme { value: 4_000, number: 1 }));
    for missed in 0..KEPT {
        assert_eq!(pack.cells().len(), 100, "after {missed} cycles of the shorter pack");
        pack.hear(&cycle(1, &[170; 10]));
    }
    assert_eq!(pack.cells(), (1..=10).map(|cell| (cell, 170)).collect::<Vec<_>>());
    assert_eq!(pack.summary().highest, Some(Extreme { value: 3_400, number: 1 }));
}

#[test]
fn a_frame_that_is_lost_twice_in_the_middle_changes_nothing() {
    let voltages: Vec<u8> = (0..40).map(|cell| 160 + cell).collect();
    let mut pack = Pack::new();
    pack.hear(&cycle(1, &voltages));
    let whole = pack.cells();
    for _ in 0..2 {
        let mut holed = cycle(1, &voltages);
        holed.remove(5);
        pack.hear(&holed);
        assert_eq!(pack.cells(), whole);
    }
    pack.hear(&cycle(1, &voltages));
    let mut holed = cycle(1, &voltages);
    holed.remove(5);
    (0..2).for_each(|_| pack.hear(&holed));
    assert_eq!(pack.cells(), whole, "a frame that comes now and then keeps its cells");
    pack.hear(&holed);
    assert_eq!(pack.cells().len(), 36, "the third loss in a row drops its four cells");
}

#[test]
fn extremes_are_in_the_models_counts_with_their_numbers() {
    let mut pack = Pack::new();
    pack.hear(&cycle(1, &[182, 183, 190, 181, 182, 190, 181]));
    let summary = pack.summary();
    assert_eq!(
        summary.highest,
        Some(Extreme { value: 3_800, number: 3 }),
        "0.02 V a bit, the first of equals"
    );
    assert_eq!(summary.lowest, Some(Extreme { value: 3_620, number: 4 }));

    let modules = stream("modules");
    pack.hear(&[(module_id(1), [65, 66, 64, 0, 0, 0, 0, 0]), (module_id(9), [70, 63, 255, 0, 0, 0, 0, 0])]);
    let summary = pack.0.summary(modules);
    assert_eq!(summary.highest, Some(Extreme { value: 30, number: 9 }), "jl_46: 255 is no temperature");
    assert_eq!(summary.lowest, Some(Extreme { value: 23, number: 9 }));
    assert_eq!(summary.count, 6);
}

#[test]
fn the_tables_take_less_than_a_kibibyte_and_hold_every_vehicle() {
    assert!(size_of::<Streams>() < 1_024);
    for vehicle in VEHICLES {
        let end = vehicle.streams.iter().map(|stream| usize::from(stream.start + stream.size)).max();
        assert!(end.unwrap_or(0) <= ROOM);
        for stream in vehicle.streams {
            assert_eq!(vehicle.index_of(stream.first), Some(stream.row), "{}", stream.name);
        }
    }
}

proptest! {
    #[test]
    fn the_order_of_the_frames_of_a_cycle_does_not_matter(
        voltages in proptest::collection::vec(1u8..=255, 1..=255),
        seed in any::<proptest::sample::Index>(),
    ) {
        let mut straight = Pack::new();
        let mut crooked = Pack::new();
        let frames = cycle(1, &voltages);
        let mut turned = frames.clone();
        turned.rotate_left(seed.index(frames.len()));
        turned.reverse();
        for _ in 0..4 {
            straight.hear(&frames);
            crooked.hear(&turned);
        }
        prop_assert_eq!(straight.cells(), crooked.cells());
        prop_assert_eq!(straight.summary(), crooked.summary());
    }

    #[test]
    fn no_bytes_panic_and_numbers_stay_in_the_table(
        frames in proptest::collection::vec((any::<u8>(), any::<[u8; 8]>()), 0..200),
    ) {
        let mut pack = Pack::new();
        for (pf, data) in frames {
            pack.hear(&[(CanId::extended(0x1800_28F3 | u32::from(pf) << 16), data)]);
        }
        prop_assert!(pack.cells().iter().all(|(number, _)| *number < 256));
        prop_assert!(pack.0.cells(stream("modules")).all(|(place, _)| place < 69));
    }
}

#[test]
fn a_stream_without_room_in_the_tables_stores_nothing_and_shows_nothing() {
    let cells = stream("cells");
    for beyond in
        [Stream { start: ROOM as u16, size: 1, ..*cells }, Stream { size: ROOM as u16 + 1, ..*cells }]
    {
        let mut streams = Streams::default();
        streams.store(&beyond, 0, &[0, 33, 1, 33, 2, 33, 3, 33]);
        assert_eq!((streams.cells(&beyond).count(), streams.cells(cells).count()), (0, 0));
        assert_eq!(streams.summary(&beyond), Summary::default());
    }
}
