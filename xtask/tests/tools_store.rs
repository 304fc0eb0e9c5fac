//! `cargo xtask store`: what is kept, and the odometer as a workshop sets it.

mod program;

use bench::flash::{Cells, Region};
use bench::rig::STORE;
use cluster::Part;
use cluster::kept::Distance;
use program::xtask;
use std::path::Path;
use store::Store;

/// Writes the image of a flash that has kept something.
fn image(path: &Path) {
    let cells = Cells::new(vec![0xff; STORE.end]);
    let mut kept = Store::mount(Region::new(cells, STORE.start, STORE.len())).unwrap();
    kept.save(Part::Distance.number(), &Distance::of_metres(12_345_600).to_bytes()).unwrap();
    kept.save(Part::Settings.number(), &[1, 0]).unwrap();
    kept.save(200, b"later").unwrap();
    std::fs::write(path, kept.free().cells.bytes()).unwrap();
}

fn told(path: &Path, arguments: &[&str]) -> (bool, String) {
    let output = xtask().arg("store").arg(path).args(arguments).output().unwrap();
    let text = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap()).concat();
    (output.status.success(), text)
}

#[test]
fn everything_that_is_kept_is_told_and_nothing_is_changed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("board.bin");
    image(&path);
    let before = std::fs::read(&path).unwrap();
    let (ended, text) = told(&path, &[]);
    assert!(ended, "{text}");
    for line in
        ["distance 12345.6 km", "settings language English, theme night", "part 200 of another firmware"]
    {
        assert!(text.contains(line), "{line} is not in {text}");
    }
    assert_eq!(std::fs::read(&path).unwrap(), before);
    // The top of the flash alone says the same.
    std::fs::write(&path, &before[STORE]).unwrap();
    assert_eq!(told(&path, &[]), (true, text));
}

#[test]
fn a_workshop_sets_the_odometer_and_the_record_of_it_stays() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("board.bin");
    image(&path);
    assert!(!told(&path, &["--set-km", "100"]).0, "nobody does it anonymously");
    assert!(!told(&path, &["--set-km", "-1", "--by", "x"]).0);
    assert!(told(&path, &["--set-km", "20000.5", "--by", "Smith"]).0);
    let (_, text) = told(&path, &["--set-km", "100", "--by", "order 4711"]);
    assert!(text.contains("distance 100.0 km"), "{text}");
    assert!(text.contains("set 2 times, last from 20000.5 km to 100.0 km by order 4711"), "{text}");
    assert_eq!(told(&path, &[]).1, text, "it was written back");
}

#[test]
fn a_file_that_is_no_flash_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("other.bin");
    std::fs::write(&path, [0; 100]).unwrap();
    let (ended, text) = told(&path, &[]);
    assert!(!ended && text.contains("other.bin has 100 bytes"), "{text}");
}
