//! What holds for every row of the table of states.

use protocol_core::Value;
use protocol_core::link::{Health, Sample};
use protocol_core::model::{Shown, Unit};
use protocol_core::states::*;
use std::collections::BTreeSet;

fn is_chinese(text: &str) -> bool {
    text.chars().any(|character| ('\u{4e00}'..='\u{9fff}').contains(&character))
}

#[test]
fn every_state_has_a_number_a_word_and_both_texts_of_its_own_in_its_kind() {
    let names: BTreeSet<&str> = KINDS.iter().map(|kind| kind.name).collect();
    assert_eq!(names.len(), KINDS.len());
    for kind in KINDS {
        let faces: [fn(&State) -> &str; 3] = [|state| state.word, |state| state.zh, |state| state.en];
        for face in faces {
            let all: BTreeSet<&str> = kind.states.iter().map(face).collect();
            assert!(all.len() == kind.states.len() && !all.contains(""), "{}", kind.name);
        }
        assert!(kind.states.is_sorted_by(|one, next| one.number < next.number), "{}", kind.name);
        for state in kind.states {
            let is_word = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
            assert!(state.word.chars().all(is_word), "`{}` needs quoting", state.word);
            // A gear is its letter in every language.
            assert!(is_chinese(state.zh) || kind.name == "gear", "{} {}", kind.name, state.word);
            assert!(
                state.en.is_ascii() && state.en.starts_with(|c: char| c.is_ascii_uppercase()),
                "{}",
                state.en
            );
        }
    }
}

#[test]
fn every_number_and_every_word_leads_back_to_its_row() {
    for kind in KINDS {
        for state in kind.states {
            assert_eq!(kind.of_number(state.number), Some(state));
            assert_eq!(kind.of_word(state.word), Some(state));
            assert_eq!(kind.meant_by(state.word), Some(state));
        }
        assert_eq!((kind.of_number(-1), kind.of_word("")), (None, None));
    }
}

#[test]
fn a_former_word_is_never_read_and_always_means_one_state() {
    for kind in KINDS {
        for state in kind.states {
            for face in state.other.iter().chain([&state.zh, &state.en]).filter(|face| **face != state.word) {
                assert_eq!(kind.of_word(face), None, "{} {face}", kind.name);
                assert_eq!(kind.meant_by(face), Some(state), "{} {face}", kind.name);
            }
        }
    }
    assert_eq!(Charge::KIND.meant_by("Not charging").map(|state| state.word), Some("idle"));
    assert_eq!(Mode::KIND.meant_by("5").map(|state| state.word), Some("limp"));
    assert_eq!(Charge::KIND.meant_by("chargeing"), None);
}

/// The faces of an enumeration are those of its rows.
macro_rules! same_faces {
    ($($kind:ident)+) => { $(
        assert_eq!($kind::ALL.len(), $kind::KIND.states.len());
        for (state, row) in $kind::ALL.iter().zip($kind::KIND.states) {
            assert_eq!((state.number(), state.word(), state.zh(), state.en()), (row.number, row.word, row.zh, row.en));
            assert_eq!(($kind::from_number(row.number), $kind::from_word(row.word)), (Some(*state), Some(*state)));
        }
        assert_eq!(($kind::from_number(-1), $kind::from_number(99), $kind::from_word("?")), (None, None, None));
    )+ };
}

#[test]
fn every_state_of_every_enumeration_round_trips() {
    same_faces! { Flag Severity Gear Contactor Run Charge Key Fan Mode Check Plug Confinement ResetReason Missing }
    assert_eq!(KINDS.len(), 14, "a new kind belongs in the line above");
}

#[test]
fn a_value_that_is_a_state_prints_its_word() {
    for value in Value::ALL {
        for state in value.unit().kind().map(|kind| kind.states).unwrap_or_default() {
            assert_eq!(value.unit().show(state.number).to_string(), state.word, "{}", value.path());
            assert_eq!(value.unit().symbol(), "");
        }
    }
    assert_eq!((Unit::Count.kind(), Unit::Bits.kind(), Unit::Kmh256.kind()), (None, None, None));
}

#[test]
fn every_kind_of_missing_has_its_word() {
    let all = [Shown::Never, Shown::Stale, Shown::Invalid];
    for (shown, missing) in all.into_iter().zip(Missing::ALL) {
        assert_eq!(shown.missing(), Some(*missing));
        assert_eq!(Sample::from(shown).show(Unit::Count).to_string(), missing.word());
    }
    assert_eq!(Shown::Value(0).missing(), None);
}

#[test]
fn fault_confinement_is_one_byte_of_the_health_record() {
    let bytes = |can_state| {
        let mut out = [0; 64];
        postcard::to_slice(&Health { can_state, ..Health::default() }, &mut out).expect("room").to_vec()
    };
    let offline = bytes(None);
    let place = 7;
    assert_eq!(offline[place], 0, "a controller that does not answer");
    for state in Confinement::ALL {
        let mut expected = offline.clone();
        expected[place] = state.number() as u8;
        assert_eq!(bytes(Some(*state)), expected);
        let health: Health = postcard::from_bytes(&expected).expect("a record");
        assert_eq!(health.can_state, Some(*state));
    }
    let mut undefined = offline;
    undefined[place] = 5;
    assert!(postcard::from_bytes::<Health>(&undefined).is_err());
}

#[test]
fn fault_confinement_is_a_word_where_a_person_reads_it() {
    let word = |can_state| {
        let record = serde_json::to_value(Health { can_state, ..Health::default() }).expect("JSON");
        record["can_state"].as_str().map(str::to_owned)
    };
    assert_eq!(word(None).as_deref(), Some(Confinement::OFFLINE));
    for state in Confinement::ALL {
        assert_eq!(word(Some(*state)).as_deref(), Some(state.word()));
    }
}
