//! The frame of the page "Add your vehicle in an hour", decoded by what its blocks generate.
//!
//! `compiler/tests/how_to.rs` keeps `how_to/van.rs` equal to the page.

// The generated file names these as parts of its own crate.
use protocol_core::{CanFrame, CanId, Reading, Readings, Value};
use protocol_core::{checksum, codec, frame, model, stream, vehicle};

#[path = "how_to/van.rs"]
#[rustfmt::skip]
#[allow(clippy::all, clippy::cast_lossless, dead_code, missing_docs, unreachable_pub, unused_imports)]
mod van;

/// Returns the text of the page's block of this kind.
fn block(kind: &str) -> String {
    let path = surroundings::root().join("docs/add-your-vehicle.md");
    let page = std::fs::read_to_string(path).expect("the page is there");
    let (_, rest) = page.split_once(&format!("```{kind}\n")).expect("the block is there");
    rest.split("```").next().expect("its end").trim().into()
}

/// Reads `(time) interface id#data`.
fn frame_of(line: &str) -> CanFrame {
    let (id, data) = line.split(' ').nth(2).and_then(|word| word.split_once('#')).expect("id#data");
    let bytes: Vec<u8> = (0..data.len())
        .step_by(2)
        .map(|at| u8::from_str_radix(&data[at..at + 2], 16).expect("hexadecimal"))
        .collect();
    let id = CanId::standard(u16::from_str_radix(id, 16).expect("hexadecimal"));
    CanFrame::from_slice(id, &bytes).expect("at most 8 bytes")
}

#[test]
fn the_frame_of_the_page_gives_the_values_of_the_page() {
    let frame = frame_of(&block("candump"));
    let index = van::VEHICLE.index_of(frame.id).expect("the van's message");
    let row = &van::VEHICLE.rx[usize::from(index)];
    assert!(
        row.checksum.expect("it has one").holds(frame.padded()),
        "the page's frame has a wrong check byte"
    );
    let mut readings = Readings::new();
    (van::VEHICLE.decode)(index, frame.padded(), &mut readings);
    let shown: Vec<String> = Value::ALL
        .iter()
        .filter_map(|value| match readings.get(*value)? {
            (Reading::Valid(number), _) => Some(format!("{} = {number}", value.path())),
            (Reading::Invalid, _) => Some(format!("{} = invalid", value.path())),
        })
        .collect();
    let mut printed: Vec<String> = block("values").lines().map(Into::into).collect();
    let mut shown = shown;
    printed.sort();
    shown.sort();
    assert_eq!(shown, printed);
    assert_eq!(van::VEHICLE.bitrate, 500_000);
}
