//! Mends in a DBC text what is mechanical: nothing here guesses what was meant.
//!
//! Bit 31 of an identifier that has more than 11 bits, wherever the identifier stands; a range beyond what the bits hold;
//! nodes that send and are not in the list. A file in another encoding is written as UTF-8 by whoever writes the text.

use crate::diagnostics::Diagnostics;
use crate::gate;
use crate::network::Network;
use crate::places::Places;
use crate::syntax::without_mark;
use std::collections::{BTreeMap, BTreeSet};

/// Returns the mended text, and what was mended, one line each.
///
/// # Errors
/// If the text is no DBC.
pub fn fix(file: &str, text: &str) -> Result<(String, Vec<String>), Diagnostics> {
    let text = without_mark(text);
    let network = gate::read(file, text)?.network;
    let places = Places::find(text);
    let mut edits: BTreeMap<usize, (usize, String)> = BTreeMap::new();
    let mut done = identifiers(&places, &mut edits);
    done.extend(ranges(text, &network, &places, &mut edits));
    done.extend(senders(&places, &network, &mut edits));
    let (mut mended, mut from) = (String::with_capacity(text.len()), 0);
    for (start, (end, new)) in edits {
        mended.push_str(&text[from..start]);
        mended.push_str(&new);
        from = end;
    }
    mended.push_str(&text[from..]);
    Ok((mended, done))
}

type Edits = BTreeMap<usize, (usize, String)>;

/// Sets bit 31 of identifiers of 12 to 29 bits.
fn identifiers(places: &Places<'_>, edits: &mut Edits) -> Vec<String> {
    const BIT_31: u64 = 1 << 31;
    let taken: BTreeSet<u64> = places.messages.iter().map(|message| message.id).collect();
    let is_short = |id: &u64| (0x800..=0x1FFF_FFFF).contains(id) && !taken.contains(&(id + BIT_31));
    let wrong: BTreeSet<u64> = taken.iter().copied().filter(is_short).collect();
    for (start, number) in &places.identifiers {
        if let Some(id) = number.parse().ok().filter(|id| wrong.contains(id)) {
            edits.insert(*start, (start + number.len(), (id + BIT_31).to_string()));
        }
    }
    let of = |id: &u64| places.message(*id).map_or("", |message| message.name);
    wrong
        .iter()
        .map(|id| format!("identifier {id} of `{}` is {} with bit 31 set", of(id), id + BIT_31))
        .collect()
}

/// Limits ranges to what the bits hold.
fn ranges(text: &str, network: &Network, places: &Places<'_>, edits: &mut Edits) -> Vec<String> {
    let signals = network.messages.iter().flat_map(|message| &message.signals);
    let by_place: BTreeMap<_, _> = signals.map(|signal| (signal.at, signal)).collect();
    let mut done = Vec::new();
    for place in places.messages.iter().flat_map(|message| &message.signals) {
        let Some(signal) = by_place.get(&place.at).filter(|signal| signal.is_limited) else { continue };
        let start = place.numbers.as_ptr() as usize - text.as_ptr() as usize;
        let (Some(open), Some(close)) = (place.numbers.find('['), place.numbers.find(']')) else { continue };
        let (low, high) = signal.range;
        let (low, high) = if signal.is_falling() { (high, low) } else { (low, high) };
        let new = format!("[{}|{}]", signal.value(low), signal.value(high));
        done.push(format!("range of `{}` is {new}, was {}", signal.name, &place.numbers[open..=close]));
        edits.insert(start + open, (start + close + 1, new));
    }
    done
}

/// Adds nodes that send to the list of nodes.
fn senders(places: &Places<'_>, network: &Network, edits: &mut Edits) -> Vec<String> {
    let Some(end) = places.nodes_end else { return Vec::new() };
    let added = &network.nodes[network.listed_nodes..];
    if added.is_empty() {
        return Vec::new();
    }
    edits.insert(end, (end, format!(" {}", added.join(" "))));
    vec![format!("nodes added to BU_: {}", added.join(", "))]
}

#[cfg(test)]
mod tests {
    use super::*;

    const WRONG: &str = "VERSION \"\"\n\nNS_ :\n\nBS_:\n\nBU_: A\n\n\
        BO_ 218042932 Pack: 8 B\n SG_ t : 0|10@1- (0.5,0) [-300|300] \"x\" A\n SG_ n : 16|8@1+ (-1,0) [-300|0] \"\" A\n\n\
        CM_ BO_ 218042932 \"218042932\";\nBA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 9;\nBA_ \"GenMsgCycleTime\" BO_ 218042932 5;\n\
        VAL_ 218042932 t 218042932 \"x\" ;\n";

    #[test]
    fn what_is_mechanical_is_mended_and_nothing_else() {
        let (mended, done) = fix("x.dbc", WRONG).expect("a DBC");
        let by_hand = WRONG
            .replace("BO_ 218042932", "BO_ 2365526580")
            .replace("VAL_ 218042932", "VAL_ 2365526580")
            .replace("[-300|300]", "[-256|255.5]")
            .replace("[-300|0]", "[-255|0]")
            .replace("BU_: A", "BU_: A B");
        assert_eq!(mended, by_hand);
        assert_eq!(done.len(), 4, "{done:?}");
        assert_eq!(fix("x.dbc", &mended).map(|(text, done)| (text, done.len())), Ok((mended, 0)));
    }
}
