//! The messages that a cluster receives on the bus, and the signals of each that it binds.

use protocol_core::codec::{MessageInfo, SignalInfo};
use protocol_core::generated::citybus;
use toml::Value;

/// One message and its bound signals, in the order of the DBC.
pub struct Message {
    pub info: &'static MessageInfo,
    pub signals: Vec<&'static SignalInfo>,
}

/// Returns the messages in the order of the receive table.
pub fn read(toml: &str) -> Vec<Message> {
    let bindings: toml::Table = toml.parse().expect("vehicle.toml is TOML");
    let message = |name: &str| {
        let info =
            citybus::MESSAGES.iter().find(|info| info.name == name).expect("a received message is in the DBC");
        let bound = names(&bindings["rx"][name]);
        let signals = info.signals.iter().filter(|signal| bound.contains(&signal.name)).collect();
        Message { info, signals }
    };
    citybus::VEHICLE.rx.iter().map(|row| message(row.name)).collect()
}

/// Returns every text in a binding that may name a signal.
fn names(binding: &Value) -> Vec<&str> {
    match binding {
        Value::String(name) => vec![name],
        Value::Array(terms) => terms.iter().flat_map(names).collect(),
        Value::Table(table) => match table.get("signal") {
            Some(signal) => names(signal),
            None => table.values().flat_map(names).collect(),
        },
        _ => vec![],
    }
}
