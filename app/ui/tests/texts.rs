//! Every character that a source or a vehicle can show has a glyph.

use cluster::faults::ROWS;
use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

/// Collects the characters above ASCII that stand in string literals of files with this ending.
fn collect(folder: &Path, ending: &str, found: &mut BTreeMap<char, PathBuf>) {
    for entry in fs::read_dir(folder).unwrap().flatten() {
        let path = entry.path();
        if path.is_dir() {
            collect(&path, ending, found);
        } else if path.to_str().unwrap().ends_with(ending) {
            let text = fs::read_to_string(&path).unwrap();
            // Comments may hold what is never shown.
            let shown = text.lines().filter(|line| !line.trim_start().starts_with(['/', '#']));
            for literal in shown.flat_map(|line| line.split('"').skip(1).step_by(2)) {
                found.extend(literal.chars().filter(|c| !c.is_ascii()).map(|c| (c, path.clone())));
            }
        }
    }
}

#[test]
fn every_character_of_every_text_has_a_glyph() {
    let root = surroundings::root();
    let mut found = BTreeMap::new();
    for text in ROWS.iter().flat_map(|row| row.words.texts()) {
        let characters = [text.zh, text.en].into_iter().flat_map(str::chars);
        found.extend(
            characters.filter(|c| !c.is_ascii()).map(|c| (c, PathBuf::from("cluster::faults::ROWS"))),
        );
    }
    collect(&root.join("app/ui/src"), "words.rs", &mut found);
    collect(&root.join("vehicles"), ".toml", &mut found);
    let missing: Vec<_> = found.iter().filter(|(character, _)| !ui::has_glyph(**character)).collect();
    assert!(
        missing.is_empty(),
        "no glyphs for {missing:?}: run `cargo xtask fonts` and commit what it wrote"
    );
    let chinese = found.keys().filter(|character| ('\u{4e00}'..='\u{9fff}').contains(*character)).count();
    println!("{chinese} Chinese characters in the texts");
    assert!(chinese > 10, "the texts were not found");
}

/// Returns the string behind `key = ` in a line of TOML.
fn quoted<'a>(line: &'a str, key: &str) -> Option<&'a str> {
    let (_, rest) = line.split_once(&format!("{key} = \""))?;
    rest.split_once('"').map(|(text, _)| text)
}

#[test]
fn every_fault_text_fits_the_message_line_beside_its_code() {
    let vehicles = surroundings::root().join("vehicles");
    let (mut checked, mut wide) = (0, Vec::new());
    for path in fs::read_dir(vehicles).unwrap().flatten().map(|entry| entry.path().join("vehicle.toml")) {
        for line in fs::read_to_string(&path).unwrap_or_default().lines() {
            let digits = |rest: &str| rest.chars().take_while(char::is_ascii_digit).collect::<String>();
            let Some(code) = line.split_once("code = ").and_then(|(_, rest)| digits(rest).parse().ok())
            else {
                continue;
            };
            for text in ["zh", "en"].into_iter().filter_map(|key| quoted(line, key)) {
                checked += 1;
                let (width, room) = ui::message_room(text, Some(code));
                if width > room {
                    wide.push(format!("{}: {text:?} takes {width} of {room} pixels", path.display()));
                }
            }
        }
    }
    assert!(wide.is_empty(), "shorten these texts:\n{}", wide.join("\n"));
    assert!(checked > 20, "the faults were not found");
}

#[test]
fn every_text_of_the_cluster_fits_and_has_glyphs() {
    for text in ROWS.iter().flat_map(|row| row.words.texts()).flat_map(|text| [text.zh, text.en]) {
        let (width, room) = ui::message_room(text, None);
        assert!(width <= room, "{text:?} takes {width} of {room} pixels: shorten it");
        assert!(text.chars().all(ui::has_glyph), "{text:?}: run `cargo xtask fonts`");
    }
}

#[test]
fn all_of_ascii_has_glyphs() {
    for character in ' '..='~' {
        assert!(ui::has_glyph(character), "{character:?}");
    }
}

#[test]
fn a_character_without_glyph_is_noticed() {
    assert!(!ui::has_glyph('\u{2FA1}'), "a radical that no text uses");
}

#[test]
fn the_bitmaps_leave_room_in_flash() {
    let fonts = fs::read_dir(surroundings::root().join("app/ui/src/fonts")).unwrap().flatten();
    let bitmaps = fonts.filter(|entry| entry.path().extension().is_some_and(|ending| ending == "bin"));
    let bytes: u64 = bitmaps.map(|entry| entry.metadata().unwrap().len()).sum();
    println!("bitmaps: {bytes} bytes");
    // 210 KB for all tables; a glyph's row of numbers takes 12 bytes more. What takes the main page over has a face of 24
    // pixels of its own, 76 KB: it is read from further away than anything else.
    assert!(bytes < 190_000, "{bytes} bytes of bitmaps: fewer texts, or smaller type");
}
