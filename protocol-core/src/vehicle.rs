//! What a receiver knows of one vehicle: its messages as rows, its decoder as one function.
//!
//! The rows are generated from `vehicles/<name>/`; the engine that walks them is in the cluster. So are the messages
//! that the cluster sends and the texts of the vehicle's fault codes.

use crate::checksum::Checksum;
use crate::frame::CanId;
use crate::model::{Readings, Severity};
use crate::stream::Stream;

/// The network node that sends a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Node {
    /// Vehicle controller.
    Vcu,
    /// Motor controller.
    Inverter,
    /// Battery management system.
    Bms,
    /// DC/DC converter.
    Dcdc,
    /// Steering pump.
    Steering,
    /// Air compressor.
    Compressor,
    /// Air conditioning.
    Hvac,
    /// Insulation monitor.
    Insulation,
    /// On-board charger.
    Charger,
    /// Contactor box (4-in-1 power electronics unit).
    Contactors,
    /// The cluster itself.
    Cluster,
}

impl Node {
    /// Returns the public name.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Vcu => "vcu",
            Self::Inverter => "inverter",
            Self::Bms => "bms",
            Self::Dcdc => "dcdc",
            Self::Steering => "steering",
            Self::Compressor => "compressor",
            Self::Hvac => "hvac",
            Self::Insulation => "insulation",
            Self::Charger => "charger",
            Self::Contactors => "contactors",
            Self::Cluster => "cluster",
        }
    }
}

/// A life counter: a field that changes with every frame of a living sender.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Life {
    /// Byte that holds the counter, 0 to 7.
    pub byte: u8,
    /// Bits of the counter in that byte, for example 0xFF or 0xF0.
    pub mask: u8,
}

/// One message that the cluster receives.
#[derive(Clone, Copy, Debug)]
pub struct RxMessage {
    /// Identifier; all bits must match (BUS-11). One that is its own [`CanId::group`] stands for its whole J1939 group.
    pub id: CanId,
    /// Name in the DBC.
    pub name: &'static str,
    /// Who sends it.
    pub node: Node,
    /// Bytes that a frame must have; a shorter one is counted and dropped.
    pub len: u8,
    /// Shortest time from one frame to the next, in milliseconds; 0 = the DBC does not say.
    pub cycle_ms: u32,
    /// Silence after which its values are stale, in milliseconds.
    pub timeout_ms: u32,
    /// Life counter; one that stops counts as silence.
    pub life: Option<Life>,
    /// Check byte; a frame in which it is wrong is counted and dropped.
    pub checksum: Option<Checksum>,
    /// Whether its absence is worth telling the driver ("no communication").
    pub expected: bool,
    /// By its document it speaks for its whole node: without it the node is lost, and a life counter that stands still
    /// in it discredits every message of the node.
    pub vital: bool,
}

/// One message that the cluster sends.
#[derive(Clone, Copy, Debug)]
pub struct TxMessage {
    /// Identifier.
    pub id: CanId,
    /// Name in the DBC.
    pub name: &'static str,
    /// Time from one frame to the next, in milliseconds.
    pub cycle_ms: u32,
    /// Life counter that the sender must count up with every frame; [`Vehicle::encode`] leaves its bits 0.
    pub life: Option<Life>,
    /// Check byte that the sender must write last.
    pub checksum: Option<Checksum>,
}

/// What one fault code of one source means; the same number means something else elsewhere (BUS-106).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FaultText {
    /// Who reports the code.
    pub source: Node,
    /// Number of the fault, never 0.
    pub code: u16,
    /// Severity, if the code alone decides it.
    pub severity: Option<Severity>,
    /// The battery burns: the fault takes over everything and stands until power-off.
    pub fire: bool,
    /// Battery and vehicle controller have lost each other: the vehicle limps (BUS-R115).
    pub limps: bool,
    /// Text in simplified Chinese.
    pub zh: &'static str,
    /// Text in English.
    pub en: &'static str,
}

/// What a node is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NodeName {
    /// Node by the DBC's transmitter.
    pub node: Node,
    /// Name in simplified Chinese.
    pub zh: &'static str,
    /// Name in English.
    pub en: &'static str,
}

/// Times of a battery's request to open the high-voltage circuit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HvOffRule {
    /// The vehicle has this long to open it, in milliseconds.
    pub vehicle_ms: u32,
    /// The battery opens it by itself after this long, in milliseconds.
    pub battery_ms: u32,
}

/// What follows when vehicle controller and battery have lost each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LimpRule {
    /// Silence of the battery after which the vehicle limps, in milliseconds.
    pub silence_ms: u32,
    /// Largest current then, in 0.1 A.
    pub most_deciamps: i32,
    /// Largest current for each Ah of rated capacity, in 0.1 A; the smaller one holds.
    pub deciamps_per_ah: i32,
}

/// Behaviour that one vehicle's documents print and others' do not; `None` = not done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rules {
    /// Times of the request to open the high-voltage circuit; without them nothing is said of who is late.
    pub hv_off: Option<HvOffRule>,
    /// Limp mode that is concluded from a silent battery.
    pub limp: Option<LimpRule>,
    /// Silence of a plugged charger that is told, in milliseconds.
    pub charger_loss_ms: Option<u32>,
    /// Silence of a running air conditioning that may be told, in milliseconds.
    pub hvac_loss_ms: Option<u32>,
    /// Longest sound of the buzzer without a break, in milliseconds.
    pub buzzer_ms: Option<u32>,
}

impl Rules {
    /// No document prints anything.
    pub const NONE: Self =
        Self { hv_off: None, limp: None, charger_loss_ms: None, hvac_loss_ms: None, buzzer_ms: None };
}

/// One vehicle: what the cluster receives and how to read it, what it sends and how to write it.
#[derive(Clone, Copy)]
pub struct Vehicle {
    /// Name of its folder.
    pub name: &'static str,
    /// What it is called in simplified Chinese.
    pub zh: &'static str,
    /// What it is called in English.
    pub en: &'static str,
    /// Bit rate of its bus, bits per second.
    pub bitrate: u32,
    /// Messages received, sorted by identifier.
    pub rx: &'static [RxMessage],
    /// Decodes the 8 bytes of message `index` into the readings; an index beyond the table changes nothing.
    pub decode: fn(index: u8, data: &[u8; 8], readings: &mut Readings),
    /// Tables that come in many frames.
    pub streams: &'static [Stream],
    /// Identifiers of all messages that other nodes send, received or not, sorted: what the vehicle is recognised by.
    pub ids: &'static [CanId],
    /// Messages sent.
    pub tx: &'static [TxMessage],
    /// Encodes message `index` of [`Self::tx`] from what the cluster knows; what it does not know is sent as the
    /// message's own "not available". An index beyond the table gives zeros.
    pub encode: fn(index: u8, values: &Readings) -> [u8; 8],
    /// Number by which the vehicle's documents call the worst fault level: 3, or 1 where they count down.
    pub worst_level: u8,
    /// Behaviour that its documents print.
    pub rules: Rules,
    /// Texts of fault codes, sorted by source and code.
    pub faults: &'static [FaultText],
    /// Names of the nodes that the cluster receives from.
    pub nodes: &'static [NodeName],
}

/// No vehicle: receives nothing, sends nothing. What a cluster is for until it knows better.
pub static NO_VEHICLE: Vehicle = Vehicle {
    name: "",
    zh: "",
    en: "",
    bitrate: 0,
    rx: &[],
    decode: |_, _, _| {},
    streams: &[],
    ids: &[],
    tx: &[],
    encode: |_, _| [0; 8],
    worst_level: 3,
    rules: Rules::NONE,
    faults: &[],
    nodes: &[],
};

impl Vehicle {
    /// Returns the index of the message with `id`, or of its J1939 group.
    pub fn index_of(&self, id: CanId) -> Option<u8> {
        let find = |id: CanId| self.rx.binary_search_by_key(&id, |message| message.id).ok();
        find(id).or_else(|| find(id.group()?)).map(|index| index as u8)
    }

    /// Returns the stream that the frame with `id` is part of, and the frame's index in it.
    pub fn stream_of(&self, id: CanId) -> Option<(&'static Stream, u8)> {
        self.streams.iter().find_map(|stream| Some((stream, stream.frame_of(id)?)))
    }

    /// Returns whether a node of the vehicle, other than the cluster, sends `id`.
    pub fn has_id(&self, id: CanId) -> bool {
        let has = |id: CanId| self.ids.binary_search(&id).is_ok();
        has(id) || id.group().is_some_and(has)
    }

    /// Returns the text of fault `code` of `source`, if the vehicle's documents print one.
    pub fn fault(&self, source: Node, code: u16) -> Option<&'static FaultText> {
        let key = |fault: &FaultText| (fault.source, fault.code);
        self.faults.binary_search_by_key(&(source, code), key).ok().map(|index| &self.faults[index])
    }

    /// Returns what `node` is called.
    pub fn node(&self, node: Node) -> Option<&'static NodeName> {
        self.nodes.iter().find(|name| name.node == node)
    }
}
