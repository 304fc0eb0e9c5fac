//! Liveness per node, on the real tables: which loss is loss of a node, whose word counts, who else speaks.

use cluster::{Cluster, FaultId, Inputs};
use protocol_core::generated::{SHIPPED_VEHICLES, citybus, jiulong};
use protocol_core::vehicle::{RxMessage, Vehicle};
use protocol_core::{CanFrame, CanId, Millis, Shown, Value};
use std::collections::BTreeMap;

/// What comes instead of a vehicle's usual frames.
#[derive(Clone, Copy, Default)]
struct Trouble {
    lost: &'static [CanId],
    frozen: &'static [CanId],
}

struct Run {
    vehicle: &'static Vehicle,
    cluster: Cluster,
    counts: BTreeMap<CanId, u8>,
    now: u64,
}

impl Run {
    fn of(vehicle: &'static Vehicle) -> Self {
        Self { vehicle, cluster: Cluster::new(vehicle), counts: BTreeMap::new(), now: 0 }
    }

    fn frame(message: &RxMessage, count: u8) -> CanFrame {
        let mut data = [0; 8];
        if let Some(life) = message.life {
            let byte = &mut data[usize::from(life.byte)];
            *byte = *byte & !life.mask | count << life.mask.trailing_zeros() & life.mask;
        }
        CanFrame::full(message.id, data)
    }

    /// Lets every message come at its cycle for a while.
    fn drive(&mut self, trouble: Trouble, ms: u64, mut look: impl FnMut(&mut Self)) {
        for _ in 0..ms / 10 {
            let cycle = |message: &RxMessage| u64::from(message.cycle_ms.max(10));
            let is_due = |message: &&RxMessage, now: u64| now.is_multiple_of(cycle(message));
            for message in self.vehicle.rx.iter().filter(|message| is_due(message, self.now)) {
                if trouble.lost.contains(&message.id) {
                    continue;
                }
                let count = self.counts.entry(message.id).or_default();
                *count = count.wrapping_add(u8::from(!trouble.frozen.contains(&message.id)));
                self.cluster.receive(&Self::frame(message, *count), Millis(self.now));
            }
            self.cluster.tick(&Inputs::default(), Millis(self.now));
            look(self);
            self.now += 10;
        }
    }

    fn shown(&self, value: Value) -> Shown<i32> {
        self.cluster.shown(value, Millis(self.now))
    }

    fn line(&self) -> Option<FaultId> {
        self.cluster.view(Millis(self.now)).line.map(|line| line.named.fault)
    }

    /// Returns whether a line says this within the next 5 s.
    fn says(&mut self, trouble: Trouble, fault: FaultId) -> bool {
        let mut said = false;
        self.drive(trouble, 5_000, |run| said |= run.line() == Some(fault));
        said
    }
}

#[test]
fn bus_r080_without_its_vital_messages_the_battery_is_lost_whatever_its_nameplate_says() {
    const BATTERY: &[CanId] = &[citybus::id::BMS1, citybus::id::BMS2, citybus::id::BMS4, citybus::id::BMS5];
    for lost in [BATTERY, &BATTERY[..1], &BATTERY[3..]] {
        let mut run = Run::of(&citybus::VEHICLE);
        run.drive(Trouble::default(), 10_000, |run| {
            assert!(run.cluster.view(Millis(run.now)).limp.is_none());
        });
        let trouble = Trouble { lost, ..Trouble::default() };
        let mut limps_from = None;
        let start = run.now;
        run.drive(trouble, 20_000, |run| {
            let limps = run.cluster.view(Millis(run.now)).limp.is_some();
            limps_from = limps_from.or(limps.then_some(run.now - start));
        });
        let from = limps_from.unwrap_or(u64::MAX);
        assert!((3_900..=5_010).contains(&from), "{lost:?}: limp after {from} ms");
        run.drive(Trouble::default(), 2_000, |_| {});
        assert!(run.cluster.view(Millis(run.now)).limp.is_none(), "it is back");
    }
}

#[test]
fn bus_r021_a_counter_that_stands_still_discredits_what_its_node_says_of_health() {
    let mut run = Run::of(&citybus::VEHICLE);
    run.drive(Trouble::default(), 10_000, |_| {});
    assert!(matches!(run.shown(Value::BatterySoc), Shown::Value(_)));
    let frozen = Trouble { frozen: &[citybus::id::BMS5], ..Trouble::default() };
    run.drive(frozen, 6_000, |_| {});
    for value in [Value::BatterySoc, Value::BatteryVoltage, Value::BatteryCellMax, Value::ContactorMain] {
        assert_eq!(run.shown(value), Shown::Stale, "{value:?}");
    }
    assert!(run.cluster.view(Millis(run.now)).limp.is_some(), "its word counts for nothing");
    // A new STOP of a node that is not believed in anything else is said all the same.
    let mut stop = *Run::frame(&citybus::VEHICLE.rx[0], 0).padded();
    stop[6] = 1;
    run.cluster.receive(&CanFrame::full(citybus::id::BMS1, stop), Millis(run.now));
    run.cluster.tick(&Inputs::default(), Millis(run.now));
    assert_eq!(run.shown(Value::BatteryFaultLevel), Shown::Value(3));
    run.drive(Trouble::default(), 2_000, |_| {});
    assert!(matches!(run.shown(Value::BatterySoc), Shown::Value(_)), "it counts again");
}

#[test]
fn jl_r009_where_no_document_says_more_a_counter_speaks_for_its_message() {
    let mut run = Run::of(&jiulong::VEHICLE);
    run.drive(Trouble::default(), 10_000, |_| {});
    run.drive(Trouble { frozen: &[jiulong::id::VCU1], ..Trouble::default() }, 6_000, |_| {});
    assert_eq!(run.shown(Value::VehicleReady), Shown::Stale);
    assert!(matches!(run.shown(Value::VehicleSpeed), Shown::Value(_)), "VCU3 has no counter (JL-42)");
}

#[test]
fn two_senders_of_one_message_are_said_by_its_counter() {
    for vehicle in SHIPPED_VEHICLES.iter().copied() {
        for message in vehicle.rx.iter().filter(|message| message.cycle_ms > 0 && message.life.is_some()) {
            for offset in [100, 7] {
                let mut run = Run::of(vehicle);
                run.drive(Trouble::default(), 2_000, |run| {
                    assert_ne!(run.line(), Some(FaultId::TwoSenders));
                });
                let mut said = false;
                let span = 25 * u64::from(message.cycle_ms);
                run.drive(Trouble::default(), span.max(5_000), |run| {
                    // The second one, half a cycle later.
                    if run.now % u64::from(message.cycle_ms) == u64::from(message.cycle_ms) / 20 * 10 {
                        let count = run.counts.get(&message.id).copied().unwrap_or(0).wrapping_add(offset);
                        run.cluster.receive(&Run::frame(message, count), Millis(run.now));
                    }
                    said |= run.line() == Some(FaultId::TwoSenders);
                });
                assert!(said, "{} {}: offset {offset}", vehicle.name, message.name);
                let mut run_on = false;
                // Until two counts of five cycles have ended, and 5 s.
                run.drive(Trouble::default(), 10 * u64::from(message.cycle_ms) + 6_000, |_| {});
                run.drive(Trouble::default(), 4_000, |run| {
                    run_on |= run.line() == Some(FaultId::TwoSenders);
                });
                assert!(!run_on, "{} {}: one again, offset {offset}", vehicle.name, message.name);
            }
        }
    }
}

#[test]
fn a_healthy_vehicle_is_never_accused_of_two_senders() {
    for vehicle in SHIPPED_VEHICLES.iter().copied() {
        let mut run = Run::of(vehicle);
        // Twenty minutes.
        run.drive(Trouble::default(), 20 * 60_000, |run| assert_ne!(run.line(), Some(FaultId::TwoSenders)));
    }
}

#[test]
fn a_random_counter_is_a_living_one_and_no_second_sender() {
    // BUS-87: any change is life.
    let mut run = Run::of(&citybus::VEHICLE);
    let mut seed = 1_u64;
    let vcu1 =
        citybus::VEHICLE.rx.iter().find(|message| message.id == citybus::id::VCU1).expect("it has one");
    for _ in 0..60_000 {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        run.cluster.receive(&Run::frame(vcu1, (seed >> 40) as u8), Millis(run.now));
        run.cluster.tick(&Inputs::default(), Millis(run.now));
        assert_ne!(run.line(), Some(FaultId::TwoSenders));
        run.now += 20;
    }
}

#[test]
fn when_everything_stops_the_wires_are_named_and_not_one_node_after_another() {
    for vehicle in SHIPPED_VEHICLES.iter().copied() {
        let mut run = Run::of(vehicle);
        run.drive(Trouble::default(), 10_000, |_| {});
        let all: Vec<CanId> = vehicle.rx.iter().map(|message| message.id).collect();
        let trouble = Trouble { lost: all.leak(), ..Trouble::default() };
        run.drive(trouble, 3_000, |_| {});
        for _ in 0..4 {
            assert!(run.says(trouble, FaultId::NoTraffic), "{}", vehicle.name);
        }
        run.drive(Trouble::default(), 3_000, |_| {});
        assert!(!run.says(Trouble::default(), FaultId::NoTraffic), "{}", vehicle.name);
    }
}
