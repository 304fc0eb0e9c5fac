//! The type faces of the screens: which font, which size, which characters.
//!
//! All are Noto Sans (SIL Open Font License 1.1, see `app/ui/fonts/OFL.txt`), from the Debian packages fonts-noto-extra
//! and fonts-noto-cjk-extra. Sizes are chosen so that capitals end on a pixel row.

use crate::shapes::{Shape, rasterise};
use anyhow::{Context, Result, bail};
use fontdue::{Font, FontSettings};
use std::{collections::BTreeSet, fmt::Write, fs, path::Path};

/// Codes of the drawn marks that stand in for missing numbers.
const DASH: u16 = 1;
const CLOCK: u16 = 2;
const CROSS: u16 = 3;
/// Codes of the drawn arrows before highest and lowest.
const UP: u16 = 4;
const DOWN: u16 = 5;

/// Which Chinese characters a face has.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Chinese {
    None,
    /// Those of the fixed labels (`app/ui/src/words.rs`).
    Labels,
    /// Those of every text.
    All,
}

struct Face {
    name: &'static str,
    doc: &'static str,
    latin: &'static str,
    /// Height of a capital in whole pixels.
    cap: u16,
    characters: &'static str,
    marks: bool,
    chinese: Chinese,
    /// Chinese font, em size and how far it is lowered against the Latin base line, pixels.
    han: (&'static str, f32, i32),
}

const ASCII: &str = " !\"#$%&'()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`abcdefghijklmnopqrstuvwxyz{|}~°…Ω·–—±×µ²³";

const NO_HAN: (&str, f32, i32) = ("", 0.0, 0);

const FACES: &[Face] = &[
    Face {
        name: "SPEED",
        doc: "Road speed.",
        latin: "NotoSans-ExtraCondensedSemiBold.ttf",
        cap: 78,
        characters: "0123456789",
        marks: true,
        chinese: Chinese::None,
        han: NO_HAN,
    },
    Face {
        name: "GEAR",
        doc: "Gear letter.",
        latin: "NotoSans-SemiCondensedSemiBold.ttf",
        cap: 22,
        characters: "DRNP0123456789",
        marks: false,
        chinese: Chinese::None,
        han: NO_HAN,
    },
    Face {
        name: "FIGURE",
        doc: "State of charge and power.",
        latin: "NotoSans-CondensedSemiBold.ttf",
        cap: 20,
        characters: "0123456789-+.:~",
        marks: true,
        chinese: Chinese::None,
        han: NO_HAN,
    },
    Face {
        name: "VALUE",
        doc: "Voltages, currents, temperatures.",
        latin: "NotoSans-CondensedMedium.ttf",
        cap: 12,
        characters: "0123456789-+.~ ABCDEFGHIJKLMNOPQRSTUVWXYZ",
        marks: true,
        chinese: Chinese::None,
        han: NO_HAN,
    },
    Face {
        name: "SMALL",
        doc: "Cells and total distance.",
        latin: "NotoSans-CondensedMedium.ttf",
        cap: 10,
        characters: "0123456789-+.",
        marks: true,
        chinese: Chinese::None,
        han: NO_HAN,
    },
    Face {
        name: "LABEL",
        doc: "Units and labels.",
        latin: "NotoSans-SemiCondensedMedium.ttf",
        cap: 9,
        characters: ASCII,
        marks: true,
        chinese: Chinese::Labels,
        han: ("NotoSansCJK-Medium.ttc", 13.0, 1),
    },
    Face {
        name: "MESSAGE",
        doc: "The message line.",
        latin: "NotoSans-SemiCondensedSemiBold.ttf",
        cap: 12,
        characters: ASCII,
        marks: true,
        chinese: Chinese::All,
        han: ("NotoSansCJK-Medium.ttc", 17.0, 1),
    },
    Face {
        name: "ALARM",
        doc: "What takes the main page over.",
        latin: "NotoSans-SemiCondensedSemiBold.ttf",
        cap: 17,
        characters: " ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789:,.-/()",
        marks: false,
        chinese: Chinese::All,
        han: ("NotoSansCJK-Medium.ttc", 24.0, 2),
    },
];

/// A face as Rust source and its packed bitmaps.
pub(crate) struct Packed {
    /// Name of the bitmap file.
    pub(crate) file: String,
    /// Rust source of the table.
    pub(crate) source: String,
    /// Bitmaps: 4 bits per pixel, the left pixel in the high half, rows start on a byte.
    pub(crate) bits: Vec<u8>,
}

/// Packs coverage rows into 4 bits per pixel.
pub(crate) fn pack(levels: &[u8], width: usize, bits: &mut Vec<u8>) {
    if width == 0 {
        return;
    }
    for row in levels.chunks(width) {
        bits.extend(row.chunks(2).map(|pair| pair[0] << 4 | pair.get(1).copied().unwrap_or(0)));
    }
}

/// Finds `name` below `folder`.
fn find(folder: &Path, name: &str) -> Option<std::path::PathBuf> {
    let mut entries: Vec<_> = fs::read_dir(folder).ok()?.flatten().map(|entry| entry.path()).collect();
    entries.sort();
    entries.into_iter().find_map(|path| match path.is_dir() {
        true => find(&path, name),
        false => (path.file_name()? == name).then_some(path),
    })
}

fn load(folder: &Path, name: &str, collection_index: u32, scale: f32) -> Result<Font> {
    let path = find(folder, name).with_context(|| {
        format!(
            "{name} is not below {}: apt-get install fonts-noto-extra fonts-noto-cjk-extra",
            folder.display()
        )
    })?;
    let settings = FontSettings { collection_index, scale, ..FontSettings::default() };
    Font::from_bytes(fs::read(path)?, settings).map_err(|reason| anyhow::anyhow!("{name}: {reason}"))
}

/// Index of Simplified Chinese in the Noto Sans CJK collections.
const SIMPLIFIED_CHINESE: u32 = 2;

/// Returns the first row with ink and the rows up to the last one.
fn inked_rows(levels: &[u8], width: usize) -> (usize, usize) {
    let inked = |row: &&[u8]| row.iter().any(|&level| level > 0);
    let above = levels.chunks(width).take_while(|row| !inked(row)).count();
    let below = levels.chunks(width).rev().take_while(|row| !inked(row)).count();
    (above, (levels.len() / width).saturating_sub(above + below))
}

/// Draws the marks for missing numbers in a digit's cell.
fn marks(cell: f32, cap: f32) -> Vec<(u16, Vec<Shape>)> {
    let centre = (cell / 2.0, cap / 2.0);
    let line = (cap * 0.11).max(1.3);
    let reach = (cell * 0.5 - line * 0.5 - (cap * 0.06).max(0.6)).min(cap * 0.24);
    let dash = cell * 0.5 - line * 0.5 - (cell * 0.09).max(0.5);
    let fine = (cap * 0.07).max(1.0);
    vec![
        (DASH, vec![Shape::Stroke(line, vec![(centre.0 - dash, centre.1), (centre.0 + dash, centre.1)])]),
        (
            CLOCK,
            vec![
                Shape::ring(centre, reach, fine),
                Shape::Stroke(
                    fine,
                    vec![
                        (centre.0, centre.1 - reach * 0.62),
                        centre,
                        (centre.0 + reach * 0.5, centre.1 + reach * 0.1),
                    ],
                ),
            ],
        ),
        (
            CROSS,
            vec![
                Shape::Stroke(
                    line,
                    vec![(centre.0 - reach, centre.1 - reach), (centre.0 + reach, centre.1 + reach)],
                ),
                Shape::Stroke(
                    line,
                    vec![(centre.0 - reach, centre.1 + reach), (centre.0 + reach, centre.1 - reach)],
                ),
            ],
        ),
        (
            UP,
            vec![Shape::Fill(vec![
                (centre.0 - 3.0, cap * 0.72),
                (centre.0, cap * 0.22),
                (centre.0 + 3.0, cap * 0.72),
            ])],
        ),
        (
            DOWN,
            vec![Shape::Fill(vec![
                (centre.0 - 3.0, cap * 0.28),
                (centre.0, cap * 0.78),
                (centre.0 + 3.0, cap * 0.28),
            ])],
        ),
    ]
}

fn face(folder: &Path, face: &Face, chinese: &BTreeSet<char>) -> Result<Packed> {
    // Capital height of Noto Sans: 714 of 1000 units.
    let px = f32::from(face.cap) / 0.714;
    let latin = load(folder, face.latin, 0, px)?;
    let (han, han_px, lowered) = face.han;
    let han = if chinese.is_empty() { None } else { Some(load(folder, han, SIMPLIFIED_CHINESE, han_px)?) };
    let digit = ('0'..='9').map(|figure| latin.metrics(figure, px).advance_width).fold(0.0, f32::max);
    let digit = digit.round().max(1.0) as u16;
    let point = latin.metrics('.', px).advance_width.round() as u16;

    let mut bits = Vec::new();
    let mut glyphs: Vec<(u16, String)> = Vec::new();
    let mut push =
        |code: u16, left: i32, top: i32, width: usize, height: usize, advance: u16, levels: &[u8]| {
            let start = bits.len();
            pack(levels, width, &mut bits);
            glyphs.push((
                code,
                format!(
                    "    Glyph::new({code:#06x}, {left}, {top}, {width}, {height}, {advance}, {start}),\n"
                ),
            ));
        };
    let drawn: BTreeSet<char> = face.characters.chars().chain(chinese.iter().copied()).collect();
    for character in drawn {
        let is_latin = face.characters.contains(character);
        let (font, size, lowered) = match &han {
            Some(han) if !is_latin => (han, han_px, lowered),
            _ => (&latin, px, 0),
        };
        if font.lookup_glyph_index(character) == 0 {
            bail!("{}: no glyph for {character:?} (U+{:04X}) in {}", face.name, character as u32, face.latin);
        }
        let (metrics, coverage) = font.rasterize(character, size);
        let levels: Vec<u8> =
            coverage.iter().map(|&level| ((u16::from(level) * 15 + 127) / 255) as u8).collect();
        let code = u16::try_from(character as u32).context("only the basic plane")?;
        let mut left = metrics.xmin;
        let mut advance = metrics.advance_width.round() as u16;
        if character.is_ascii_digit() || "+-".contains(character) {
            // Figures sit in cells of one width, so that numbers do not jitter.
            left += ((f32::from(digit) - metrics.advance_width) / 2.0).round() as i32;
            advance = digit;
        }
        let top = i32::from(face.cap) - metrics.ymin - metrics.height as i32 + lowered;
        push(code, left, top, metrics.width, metrics.height, advance, &levels);
    }
    if face.marks {
        for (code, shapes) in marks(f32::from(digit), f32::from(face.cap)) {
            let (width, height) = (usize::from(digit), usize::from(face.cap));
            let levels = rasterise(&shapes, width, height);
            let (from, rows) = inked_rows(&levels, width);
            push(code, 0, from as i32, width, rows, digit, &levels[from * width..(from + rows) * width]);
        }
    }
    glyphs.sort();

    let file = format!("{}.bin", face.name.to_lowercase());
    let mut source = String::new();
    write!(
        source,
        "/// {}\npub(crate) static {}: Font = Font {{\n    cap: {},\n    digit: {digit},\n    point: {point},\n    glyphs: &{}_GLYPHS,\n    \
         bits: include_bytes!(\"{file}\"),\n}};\n\nstatic {}_GLYPHS: [Glyph; {}] = [\n",
        face.doc,
        face.name,
        face.cap,
        face.name,
        face.name,
        glyphs.len()
    )?;
    source.extend(glyphs.into_iter().map(|(_, line)| line));
    source.push_str("];\n");
    Ok(Packed { file, source, bits })
}

/// Draws every face; `labels` and `texts` are the Chinese characters of the labels and of all texts.
pub(crate) fn all(folder: &Path, labels: &BTreeSet<char>, texts: &BTreeSet<char>) -> Result<Vec<Packed>> {
    let none = BTreeSet::new();
    FACES
        .iter()
        .map(|row| {
            face(
                folder,
                row,
                match row.chinese {
                    Chinese::None => &none,
                    Chinese::Labels => labels,
                    Chinese::All => texts,
                },
            )
        })
        .collect()
}
