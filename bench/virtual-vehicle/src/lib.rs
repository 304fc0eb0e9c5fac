//! The vehicle around the cluster: physics, the rules of all other nodes, their frames.
//!
//! A closed loop in virtual time: a driver's settings go in, every frame of every other node comes out at its cycle,
//! frames of others go back in. Each node knows of the others what it has heard of them ([`inbox`]) and what is physics.
//! Deterministic: the same settings at the same steps give the same frames. Knows no bench, no socket and no clock;
//! [`world`] is what is true, [`control`] what a person may change, the folder of each vehicle what its document makes of
//! it.

#![forbid(unsafe_code)]

pub mod control;
pub mod inbox;
pub mod told;
pub mod world;

mod bms;
mod bus;
mod drive;
mod driver;
mod fault;
mod hearing;
mod parts;
mod spec;
mod vcu;
mod vehicle;

// One folder per vehicle; its row is in `vehicles!` below.
mod c5ev;
mod citybus;
mod jiulong;

pub use control::{Control, ControlError, Group, Setting, Takes, Word};
pub use world::World;

use bus::Wire;
use protocol_core::CanFrame;
use protocol_core::states::{self, State};
use protocol_core::vehicle::Node;
use vehicle::Definition;

/// Virtual time of one step, in milliseconds.
pub const STEP_MS: u64 = 10;
/// The same in seconds, for the physics.
pub(crate) const STEP_S: f64 = STEP_MS as f64 / 1_000.0;

/// Makes [`Kind`] out of one row per vehicle: its name here and its folder.
macro_rules! vehicles {
    ($($(#[$doc:meta])* $kind:ident => $folder:ident,)+) => {
        /// Which vehicle.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Kind {
            $($(#[$doc])* $kind,)+
        }

        impl Kind {
            /// Every vehicle.
            pub const ALL: [Self; [$(Self::$kind),+].len()] = [$(Self::$kind),+];

            /// What its folder gives.
            pub(crate) const fn definition(self) -> &'static Definition {
                match self {
                    $(Self::$kind => &$folder::VEHICLE,)+
                }
            }
        }
    };
}

vehicles! {
    /// The city bus.
    Citybus => citybus,
    /// The E66/E7/E8/E10 vans and buses.
    Jiulong => jiulong,
    /// The car.
    C5ev => c5ev,
}

impl Kind {
    /// Returns the name of its folder in `vehicles/`.
    pub const fn name(self) -> &'static str {
        self.definition().name
    }

    /// What a person may change in it, in the order of the page.
    pub fn controls(self) -> impl Iterator<Item = &'static Control> {
        let own = self.definition().controls.own.iter().copied();
        let has = move |control: &Control| self.definition().controls.has.contains(&control.path);
        let common = [driver::CONTROLS, vcu::CONTROLS, drive::CONTROLS, bms::CONTROLS, parts::CONTROLS];
        let common = common.into_iter().flatten().filter(move |control| !control.optional || has(control));
        common.chain(own.flatten())
    }

    /// Finds a control by its path.
    fn control(self, path: &str) -> Result<&'static Control, ControlError> {
        self.controls().find(|control| control.path == path).ok_or_else(|| {
            let last = |path: &str| path.rsplit('.').next().unwrap_or_default().to_owned();
            let nearest =
                self.controls().find(|control| last(control.path) == last(path)).map(|control| control.path);
            ControlError::Unknown { path: path.to_owned(), vehicle: self.name(), nearest }
        })
    }

    /// Returns the vehicle of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}

/// Which of two printed cycles the nodes keep, where the documents print two (BUS-18).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cycles {
    /// The cycle on the page of the message.
    #[default]
    Page,
    /// The cycle in the overview of all messages.
    Overview,
    /// The slower one of the two.
    Slow,
}

/// What is chosen when the vehicle is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Which printed cycles the nodes keep.
    pub cycles: Cycles,
    /// Cells in series; 0 = as many as this vehicle usually has.
    pub cells: u16,
    /// Temperature probes; 0 = as many as this vehicle usually has.
    pub probes: u16,
    /// Largest lateness of a frame against its cycle, in microseconds; the mean is half of it.
    pub jitter_us: u32,
    /// Seed of phases, jitter and the spread between cells.
    pub seed: u64,
    /// Sends the messages that a vehicle may be built without, too.
    pub optional: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { cycles: Cycles::Page, cells: 0, probes: 0, jitter_us: 500, seed: 1, optional: false }
    }
}

/// A frame that a node sends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sent {
    /// When it is ready to be sent, in microseconds since the vehicle's start.
    pub at_us: u64,
    /// Who sends it.
    pub node: Node,
    /// The frame.
    pub frame: CanFrame,
}

/// Something true in the vehicle, for people and tests to read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readout {
    /// Public name, like the model's: `battery.soc`.
    pub path: &'static str,
    /// What it is called in simplified Chinese.
    pub zh: &'static str,
    /// What it is called in English.
    pub en: &'static str,
    /// The value in `unit`, or the number of the state.
    pub value: f64,
    /// Unit, for example `km/h`.
    pub unit: &'static str,
    /// Digits after the point that mean something.
    pub digits: u8,
    /// What kind of state it is; `None` = a number.
    pub kind: Option<states::Kind>,
}

impl Readout {
    /// Returns the state that is true; `None` for a number, and while the vehicle itself does not know.
    pub fn state(&self) -> Option<&'static State> {
        self.kind?.of_number(self.value as i32)
    }
}

/// A whole vehicle but for its cluster.
pub struct VirtualVehicle {
    world: World,
    wire: Wire,
}

impl VirtualVehicle {
    /// Builds a vehicle that stands, keyed on, with a charged battery.
    pub fn new(kind: Kind, options: Options) -> Self {
        let world = World::new(kind, options);
        Self { wire: Wire::new(kind.definition(), options), world }
    }

    /// Which vehicle it is.
    pub fn kind(&self) -> Kind {
        self.world.kind
    }

    /// What is true in the vehicle.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// Nodes that send on this bus.
    pub fn nodes(&self) -> &[Node] {
        self.wire.nodes()
    }

    /// Time since the vehicle's start, in milliseconds.
    pub fn now_ms(&self) -> u64 {
        self.world.now_ms
    }

    /// What a person may change in this vehicle.
    pub fn controls(&self) -> impl Iterator<Item = &'static Control> {
        self.world.kind.controls()
    }

    /// Changes one thing; it acts from the next step on.
    ///
    /// # Errors
    /// If there is no such control in this vehicle or the setting is out of its range; the error says what there is.
    pub fn set(&mut self, path: &str, setting: Setting) -> Result<(), ControlError> {
        let control = self.world.kind.control(path)?;
        control.check(setting)?;
        (control.set)(&mut self.world, setting);
        Ok(())
    }

    /// Returns what is set now; `None` if there is no such control.
    pub fn setting(&self, path: &str) -> Option<Setting> {
        self.world.kind.control(path).ok().map(|control| (control.get)(&self.world))
    }

    /// Returns what is true, in the order in which a person would read it.
    pub fn readouts(&self) -> Vec<Readout> {
        drive::readouts(&self.world)
    }

    /// Returns one truth by its name.
    pub fn readout(&self, path: &str) -> Option<Readout> {
        self.readouts().into_iter().find(|readout| readout.path == path)
    }

    /// Lets one step of [`STEP_MS`] pass: what each node has heard, what it makes of it, physics, then their frames.
    pub fn advance(&mut self) {
        let world = &mut self.world;
        let vehicle = world.kind.definition();
        driver::step(world);
        hearing::step(world, vehicle);
        vcu::step(world);
        bms::step(world);
        parts::step(world);
        drive::step(world);
        self.wire.step(world, vehicle);
        World::count(&mut world.meter.silent_ms);
        world.now_ms += STEP_MS;
    }

    /// From now on the nodes hear one another over a bus: what they send on it reaches them when [`Self::receive`] brings
    /// it back, and not before. Without, they hear one another at once.
    pub fn over_a_bus(&mut self) {
        self.wire.over_a_bus();
    }

    /// Takes the frames that became ready in the last step, earliest first.
    pub fn take_frames(&mut self) -> Vec<Sent> {
        self.wire.take()
    }

    /// Brings a frame that is on the bus, the cluster's or anybody's, to every node that listens to it; what it says acts
    /// from the next step on.
    pub fn receive(&mut self, frame: &CanFrame) {
        if !self.world.links.cut[Node::Cluster as usize] {
            let vehicle = self.world.kind.definition();
            hearing::deliver(&mut self.world, vehicle, frame);
        }
    }
}

impl World {
    /// A vehicle that stands, keyed on, in mild weather.
    pub fn new(kind: Kind, options: Options) -> Self {
        let vehicle = kind.definition();
        let mut world = Self::bare(kind, vehicle.spec, options);
        bms::build(&mut world);
        parts::build(&mut world);
        vcu::build(&mut world);
        hearing::build(&mut world, vehicle);
        world
    }
}

#[cfg(test)]
mod apart;
