//! What vehicles/FORMAT.md says of states is what the compiler takes.

use protocol_core::Value;
use protocol_core::states::{KINDS, Kind};

const FORMAT: &str = include_str!("../../../vehicles/FORMAT.md");

fn can_be_bound(kind: &Kind) -> bool {
    Value::ALL.iter().any(|value| value.unit().kind() == Some(*kind))
}

#[test]
fn the_table_of_words_has_every_state_that_a_value_can_be_in() {
    let row = |kind: &Kind| {
        let words: Vec<String> = kind.states.iter().map(|state| format!("`{}`", state.word)).collect();
        format!("| {} | {} |\n", kind.name, words.join(", "))
    };
    let rows: String = KINDS.iter().filter(|kind| can_be_bound(kind)).map(row).collect();
    let table = format!("| Kind | Words |\n|---|---|\n{rows}\n");
    assert!(
        FORMAT.contains(&table),
        "vehicles/FORMAT.md, \"States and maps\", must have this table:\n\n{table}"
    );
}
