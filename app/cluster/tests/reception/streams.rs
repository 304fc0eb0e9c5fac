//! Jiulong's cell and temperature frames in the whole cluster: who has precedence, and what becomes of them in silence.

use cluster::{Cluster, Inputs, Received};
use protocol_core::generated::{VEHICLES, jiulong};
use protocol_core::model::{Shown, Value};
use protocol_core::{CanFrame, CanId, Millis};

fn cells(index: u8, voltages: [u8; 4]) -> CanFrame {
    let [a, b, c, d] = voltages;
    let number = |place: u8| (4 * index + place).wrapping_add(1);
    let id = CanId::extended(0x18E6_28F3 - (u32::from(index) << 16));
    CanFrame::full(id, [number(0), a, number(1), b, number(2), c, number(3), d])
}

/// The pack's own summary: 3.70 V and 3.60 V, high byte first, 30 and 20 degrees.
fn extremes() -> CanFrame {
    CanFrame::full(jiulong::id::BMS_EXTREMES, [0, 185, 0, 180, 70, 60, 0, 0])
}

fn shown(cluster: &Cluster, path: &str, now: u64) -> Shown<i32> {
    cluster.shown(Value::from_path(path).expect("a model value"), Millis(now))
}

#[test]
fn jl_r020_cells_fill_in_for_extremes_that_do_not_come() {
    let mut cluster = Cluster::new(&jiulong::VEHICLE);
    assert_eq!(cluster.receive(&cells(1, [180, 181, 179, 180]), Millis(0)), Received::Stored);
    assert_eq!(shown(&cluster, "battery.cell.max", 0), Shown::Never, "the first frame is the sign of life");
    cluster.receive(&cells(0, [185, 180, 180, 180]), Millis(10));
    assert_eq!(shown(&cluster, "battery.cell.max", 10), Shown::Value(3_700));
    assert_eq!(shown(&cluster, "battery.cell.min", 10), Shown::Value(3_580));
    assert_eq!(shown(&cluster, "battery.cell.max_number", 10), Shown::Value(1));
    assert_eq!(shown(&cluster, "battery.cell.min_number", 10), Shown::Value(7));
    assert_eq!(shown(&cluster, "battery.cell.count", 10), Shown::Value(8));
}

#[test]
fn cells_that_change_change_their_extremes_at_once() {
    let mut cluster = Cluster::new(&jiulong::VEHICLE);
    for (now, voltage, millivolts) in
        [(0, 180, 3_600), (500, 181, 3_620), (1_000, 170, 3_400), (1_000, 190, 3_800)]
    {
        cluster.receive(&cells(0, [voltage; 4]), Millis(now));
        assert_eq!(shown(&cluster, "battery.cell.max", now), Shown::Value(millivolts), "at {now}");
        assert_eq!(shown(&cluster, "battery.cell.min", now), Shown::Value(millivolts), "at {now}");
    }
}

#[test]
fn the_packs_own_extremes_have_precedence_while_they_are_fresh() {
    let mut cluster = Cluster::new(&jiulong::VEHICLE);
    cluster.receive(&cells(0, [100, 101, 102, 103]), Millis(0));
    cluster.receive(&extremes(), Millis(10));
    for now in (500..3_000).step_by(500) {
        cluster.receive(&cells(0, [100, 101, 102, 103]), Millis(now));
        let expected = if now < 2_510 { 3_700 } else { 2_060 };
        assert_eq!(shown(&cluster, "battery.cell.max", now), Shown::Value(expected), "at {now}");
        assert_eq!(shown(&cluster, "battery.cell.max_number", now), Shown::Value(4));
    }
    cluster.receive(&cells(0, [100, 101, 102, 103]), Millis(3_000));
    assert_eq!(shown(&cluster, "battery.cell.max", 3_000), Shown::Value(2_060), "they are stale now");
    cluster.receive(&extremes(), Millis(3_010));
    assert_eq!(shown(&cluster, "battery.cell.max", 3_010), Shown::Value(3_700), "and are back");
}

#[test]
fn a_stream_that_stops_turns_stale_and_nobody_misses_it() {
    let mut cluster = Cluster::new(&jiulong::VEHICLE);
    cluster.receive(&cells(0, [180; 4]), Millis(0));
    assert_eq!(shown(&cluster, "battery.cell.max", 2_499), Shown::Value(3_600));
    assert_eq!(shown(&cluster, "battery.cell.max", 2_500), Shown::Stale);
    assert_eq!(shown(&cluster, "battery.cell.count", 2_500), Shown::Stale);
    let streams = jiulong::VEHICLE.streams.iter();
    assert!(streams.clone().count() > 0);
    assert!(streams.into_iter().all(|stream| !jiulong::VEHICLE.rx[usize::from(stream.row)].expected));
}

#[test]
fn a_short_frame_of_a_stream_is_counted_and_dropped() {
    let mut cluster = Cluster::new(&jiulong::VEHICLE);
    for index in [0, 1, 63] {
        let whole = cells(index, [180; 4]);
        let short = CanFrame::from_slice(whole.id, &whole.bytes()[..7]).expect("seven bytes");
        assert_eq!(cluster.receive(&short, Millis(0)), Received::TooShort);
    }
    assert_eq!(cluster.counters().too_short, 3);
    assert_eq!(shown(&cluster, "battery.cell.count", 0), Shown::Never);
}

#[test]
fn a_cluster_becomes_that_of_a_vehicle_and_forgets_what_it_heard() {
    let mut cluster = Cluster::new(&protocol_core::vehicle::NO_VEHICLE);
    cluster.restore(800);
    for now in (0..60_000).step_by(10) {
        cluster.receive(&extremes(), Millis(now));
        cluster.tick(&Inputs::default(), Millis(now));
        assert_eq!(cluster.transmit(Millis(now)), None);
    }
    assert!(Value::ALL.iter().all(|value| cluster.shown(*value, Millis(60_000)) != Shown::Stale));
    for vehicle in VEHICLES {
        let mut cluster = cluster.clone();
        cluster.recognise(vehicle);
        assert_eq!((cluster.vehicle().name, cluster.odometer_km8()), (vehicle.name, 800));
        assert_eq!(cluster.counters().unknown, 0);
        for now in (60_000..65_000).step_by(10) {
            cluster.tick(&Inputs::default(), Millis(now));
            let line = cluster.view(Millis(now)).line;
            assert!(line.is_none(), "{}: nodes have their time to boot: {line:?} at {now}", vehicle.name);
        }
    }
}
