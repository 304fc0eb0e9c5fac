//! Every signal's place against `layout.csv`, which was read from the documents in a second pass.
//!
//! The forms of a position are described in `vehicles/README.md`.

use protocol_core::codec::{MessageInfo, SignalInfo};
use protocol_core::generated::MESSAGES;
use std::collections::BTreeSet;

/// Returns byte and bit of each raw bit, lowest first, found by writing it.
fn places(signal: &SignalInfo) -> Vec<(usize, u32)> {
    let place = |bit: u8| {
        let mut data = [0; 8];
        signal.set_raw(&mut data, 1 << bit);
        let byte = data.iter().position(|byte| *byte != 0).expect("one bit is set");
        (byte, data[byte].trailing_zeros())
    };
    (0..signal.length).map(place).collect()
}

/// Returns byte and bit of each raw bit, lowest first, as the document prints them.
fn printed(position: &str, first_byte: usize) -> Option<Vec<(usize, u32)>> {
    let words: Vec<&str> = position.split_whitespace().collect();
    let byte = |word: &str| word.strip_prefix("BYTE")?.parse::<usize>().ok()?.checked_sub(first_byte);
    let span = |text: &str| match text.split_once("..") {
        Some((a, b)) => Some((a.parse::<u32>().ok()?, b.parse::<u32>().ok()?)),
        None => text.parse().ok().map(|bit: u32| (bit, bit)),
    };
    let bits = |byte: usize, (a, b): (u32, u32)| -> Vec<_> {
        (a.min(b)..=a.max(b)).map(|bit| (byte, bit)).collect()
    };
    match words.as_slice() {
        [start, length] if start.starts_with("start") => {
            let start: u32 = start.strip_prefix("start")?.parse().ok()?;
            let length: u32 = length.strip_prefix("len")?.parse().ok()?;
            Some((start..start + length).map(|bit| ((bit / 8) as usize, bit % 8)).collect())
        }
        [at, bit] if bit.starts_with("bit") => Some(bits(byte(at)?, span(bit.strip_prefix("bit")?)?)),
        [at, pos] if pos.starts_with("pos") => {
            let (a, b) = span(pos.strip_prefix("pos")?)?;
            Some(bits(byte(at)?, (a.checked_sub(1)?, b.checked_sub(1)?)))
        }
        parts => {
            // Whole bytes and parts of bytes, least significant first.
            let mut places = Vec::new();
            for (index, word) in parts.iter().enumerate().filter(|(_, word)| word.starts_with("BYTE")) {
                let part = parts.get(index + 1).and_then(|next| next.strip_prefix("bit"));
                places.extend(bits(byte(word)?, part.map_or(Some((0, 7)), span)?));
            }
            (!places.is_empty()).then_some(places)
        }
    }
}

fn compare(vehicle: &str, messages: &[MessageInfo]) {
    let path = surroundings::root().join(format!("vehicles/{vehicle}/layout.csv"));
    let text = std::fs::read_to_string(&path).expect("layout.csv is there");
    let mut met = BTreeSet::new();
    for (index, line) in text.lines().enumerate().skip(1) {
        let here = format!("vehicles/{vehicle}/layout.csv:{}", index + 1);
        let fields: Vec<&str> = line.split(',').collect();
        let [message, signal, first_byte, position] = fields[..] else {
            panic!("{here}: four fields are needed")
        };
        let info = messages.iter().find(|info| info.name == message);
        let info = info.and_then(|info| info.signal(signal));
        let info = info.unwrap_or_else(|| panic!("{here}: the DBC has no {message}.{signal}"));
        let first_byte = first_byte.parse().expect("0 or 1");
        let printed =
            printed(position, first_byte).unwrap_or_else(|| panic!("{here}: `{position}` is no position"));
        assert_eq!(places(info), printed, "{here}: {message}.{signal} is printed at `{position}`");
        assert!(met.insert((message, signal)), "{here}: {message}.{signal} is there twice");
    }
    for message in messages {
        for signal in message.signals {
            assert!(
                met.contains(&(message.name, signal.name)),
                "{vehicle}: {}.{} has no row",
                message.name,
                signal.name
            );
        }
    }
}

#[test]
fn every_vehicle_has_every_signal_where_its_document_prints_it() {
    for (vehicle, messages) in MESSAGES {
        compare(vehicle, messages);
    }
}
