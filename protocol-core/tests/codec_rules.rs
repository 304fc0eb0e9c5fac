//! Coding rules and decisions of the documents, each with numbers worked out by hand.
//!
//! Names carry the rule (`bus_r006`, `jl_r010`, `c5_r003`) or the decision on a doubtful place (`bus_16`, `jl_02`).

use protocol_core::generated::{c5ev, citybus, jiulong};
use protocol_core::model::{Gear, Reading, Readings, Severity, Value};
use protocol_core::vehicle::{Life, Node, Vehicle};

/// Returns what a vehicle's cluster reads in one frame.
fn decoded(vehicle: &Vehicle, message: &str, data: [u8; 8]) -> Readings {
    let index = vehicle.rx.iter().position(|row| row.name == message).expect("a received message");
    let mut readings = Readings::new();
    (vehicle.decode)(index as u8, &data, &mut readings);
    readings
}

/// Returns one value of a frame; `None` = invalid.
fn value(vehicle: &Vehicle, message: &str, data: [u8; 8], value: Value) -> Option<i32> {
    match decoded(vehicle, message, data).get(value).expect("the frame carries the value").0 {
        Reading::Valid(number) => Some(number),
        Reading::Invalid => None,
    }
}

fn severity(vehicle: &Vehicle, message: &str, data: [u8; 8], level: Value) -> Option<Severity> {
    value(vehicle, message, data, level).map(Severity::from_model)
}

fn sent(vehicle: &Vehicle, message: &str, inputs: &[(Value, i32)]) -> [u8; 8] {
    let index = vehicle.tx.iter().position(|row| row.name == message).expect("a sent message");
    let mut values = Readings::new();
    for (value, number) in inputs {
        values.set(Readings::LOCAL, *value, Reading::Valid(*number));
    }
    (vehicle.encode)(index as u8, &values)
}

const BUS: &Vehicle = &citybus::VEHICLE;
const JIULONG: &Vehicle = &jiulong::VEHICLE;
const C5EV: &Vehicle = &c5ev::VEHICLE;

#[test]
fn bus_r001_jl_r001_c5_33_the_bit_rate_is_250_kbit_per_second() {
    assert_eq!([BUS.bitrate, JIULONG.bitrate, C5EV.bitrate], [250_000; 3]);
}

#[test]
fn bus_r005_the_low_byte_comes_first() {
    // 0x0300 / 256 = 3 km/h, in bytes 3 and 4.
    let data = [0, 0, 0x00, 0x03, 0, 0, 0, 0];
    assert_eq!(citybus::Vcu1(data).vehicle_speed(), Some(0x300));
    assert_eq!(value(BUS, "VCU1", data, Value::VehicleSpeed), Some(3 * 256));
}

#[test]
fn bus_r006_the_soc_in_vcu5_has_its_high_byte_first() {
    // BYTE6 = 0x00, BYTE7 = 0x7D: 125 * 0.4 = 50 %.
    let data = [0, 0, 0, 0, 0, 0x00, 0x7D, 0];
    assert_eq!(citybus::Vcu5(data).soc_raw(), 125);
    assert_eq!(citybus::Vcu5(data).soc(), Some(250), "250 fifths are 50 %");
    assert_eq!(citybus::Vcu5([0, 0, 0, 0, 0, 0x7D, 0x00, 0]).soc(), None, "the other order is out of range");
    assert_eq!(citybus::Vcu5::new().with_soc_raw(125).0[5..7], [0x00, 0x7D]);
}

#[test]
fn bus_r008_reserved_bytes_are_filled_and_reserved_bits_are_zero() {
    assert_eq!(citybus::Vcu7::new().0, [0x00, 0, 0, 0xFF, 0x00, 0xFF, 0xFF, 0xFF]);
    assert_eq!(
        sent(BUS, "Meter2", &[(Value::ClusterOdometer, 0x0102_0304)]),
        [4, 3, 2, 1, 0xFF, 0xFF, 0xFF, 0xFF]
    );
}

#[test]
fn bus_16_offsets_are_physical() {
    // (30000 - 3000 / 0.1) * 0.1 = 0 Nm; raw 0 is -3000 Nm, raw 60000 is 3000 Nm.
    let torque = |raw: u16| citybus::Ipu2::new().with_motor_torque_raw(raw).motor_torque();
    assert_eq!(
        [torque(0), torque(30_000), torque(60_000), torque(60_001)],
        [Some(-30_000), Some(0), Some(30_000), None]
    );
    let current = |raw: u16| citybus::Bms1::new().with_pack_current_raw(raw).0;
    assert_eq!(value(BUS, "BMS1", current(9_876), Value::BatteryCurrent), Some(-124), "-12.4 A: charging");
    assert_eq!(value(BUS, "BMS1", current(10_500), Value::BatteryCurrent), Some(500), "50 A: discharging");
}

#[test]
fn bus_34_raw_levels_run_in_opposite_directions() {
    let vcu7 = |raw| {
        severity(BUS, "VCU7", citybus::Vcu7::new().with_fault_level_raw(raw).0, Value::VehicleFaultLevel)
    };
    let bms1 = |raw| {
        severity(BUS, "BMS1", citybus::Bms1::new().with_fault_level_raw(raw).0, Value::BatteryFaultLevel)
    };
    use Severity::{Derate, None as NoFault, Stop, Warn};
    assert_eq!([0, 1, 2, 3].map(vcu7), [NoFault, Warn, Derate, Stop].map(Some));
    assert_eq!([0, 1, 2, 3].map(bms1), [NoFault, Stop, Derate, Warn].map(Some));
    assert_eq!([4, 5, 6, 7].map(vcu7), [None; 4]);
    assert_eq!([4, 5, 6, 7].map(bms1), [None; 4]);
}

#[test]
fn bus_100_the_insulation_level_is_the_worse_of_level_and_alarm_bits() {
    let frame = |level, first, second| {
        citybus::Insulation::new()
            .with_leakage_level_raw(level)
            .with_level_1_alarm_raw(first)
            .with_level_2_alarm_raw(second)
            .0
    };
    let level = |level, first, second| {
        severity(BUS, "Insulation", frame(level, first, second), Value::InsulationLevel)
    };
    assert_eq!(level(0, 0, 0), Some(Severity::None));
    assert_eq!(level(1, 0, 0), Some(Severity::Warn));
    assert_eq!(level(2, 1, 0), Some(Severity::Stop));
    assert_eq!(level(0, 1, 0), Some(Severity::Warn));
    assert_eq!(level(1, 0, 1), Some(Severity::Stop));
}

#[test]
fn bus_36_unknown_gears_are_invalid_and_the_others_are_what_is_printed() {
    let gear = |raw| {
        let model = value(BUS, "VCU1", citybus::Vcu1::new().with_gear_raw(raw).0, Value::VehicleGear);
        model.map(|model| Gear::from_number(model).expect("a gear"))
    };
    for (raw, expected) in [
        (0, None),
        (0b0001, Some(Gear::D)),
        (0b0010, Some(Gear::R)),
        (0b0011, Some(Gear::D1)),
        (0b0100, Some(Gear::N)),
        (0b0101, Some(Gear::D2)),
        (0b0110, Some(Gear::D3)),
        (0b0111, None),
        (0b1000, Some(Gear::P)),
        (0b1001, Some(Gear::D4)),
        (0b1010, Some(Gear::D5)),
        (0b1011, Some(Gear::D6)),
        (0b1100, None),
        (0b1111, None),
    ] {
        assert_eq!(gear(raw), expected, "raw {raw:04b}");
    }
}

#[test]
fn bus_48_the_soc_is_two_bytes_of_0_4_percent_and_invalid_above_250() {
    let soc = |raw: u16| value(BUS, "BMS1", citybus::Bms1::new().with_soc_raw(raw).0, Value::BatterySoc);
    assert_eq!([soc(0), soc(1), soc(250)], [Some(0), Some(4), Some(1000)]);
    assert_eq!([soc(251), soc(0x0100), soc(0xFFFF)], [None; 3]);
}

#[test]
fn bus_52_the_plug_is_in_at_55_and_out_at_aa() {
    let plug = |raw| value(BUS, "BMS5", citybus::Bms5::new().with_plug_state_raw(raw).0, Value::ChargePlug);
    assert_eq!([plug(0x55), plug(0xAA), plug(0xFF), plug(0)], [Some(1), Some(0), None, None]);
}

#[test]
fn bus_54_the_fault_code_of_the_vehicle_is_two_bytes() {
    let data = [0, 0x34, 0x12, 0xFF, 0, 0xFF, 0xFF, 0xFF];
    assert_eq!(value(BUS, "VCU7", data, Value::VehicleFaultCode), Some(0x1234));
}

#[test]
fn bus_59_closed_is_01_in_bms1_and_10_in_the_contactor_box() {
    let main =
        |raw| value(BUS, "BMS1", citybus::Bms1::new().with_main_relay_raw(raw).0, Value::ContactorMain);
    assert_eq!([0b00, 0b01, 0b10, 0b11].map(main), [Some(0), Some(1), None, Some(2)]);
    assert!(BUS.rx.iter().all(|row| row.name != "PEU"), "the box is heard only by configuration (BUS-60)");
}

#[test]
fn bus_63_the_life_counter_of_ipu1_is_the_high_nibble_of_byte_8() {
    let row = BUS.rx.iter().find(|row| row.name == "IPU1").expect("IPU1 is received");
    assert_eq!(row.life, Some(Life { byte: 7, mask: 0xF0 }));
    assert_eq!(citybus::Ipu1([0, 0, 0, 0, 0, 0, 0, 0xA5]).life_raw(), 0xA);
}

#[test]
fn bus_67_only_11_asks_to_open_the_high_voltage_circuit_and_only_10_does_not() {
    let asks = |raw| {
        value(BUS, "BMS1", citybus::Bms1::new().with_hv_open_request_raw(raw).0, Value::BatteryHvOffRequest)
    };
    assert_eq!([0b00, 0b01, 0b10, 0b11].map(asks), [None, None, Some(0), Some(1)]);
}

#[test]
fn bus_72_cell_voltages_count_10_mv_and_ffff_is_invalid() {
    let cell = |raw: u16| {
        value(BUS, "BMS2", citybus::Bms2::new().with_max_cell_voltage_raw(raw).0, Value::BatteryCellMax)
    };
    assert_eq!([cell(365), cell(0xFFFF)], [Some(3650), None]);
}

#[test]
fn bus_73_the_charge_limit_is_a_magnitude_whatever_its_sign() {
    let limit = |raw: u16| {
        value(BUS, "BMS4", citybus::Bms4::new().with_max_charge_current_raw(raw).0, Value::BatteryChargeLimit)
    };
    assert_eq!([limit(10_800), limit(9_200)], [Some(800), Some(800)]);
}

#[test]
fn bus_86_the_year_of_production_counts_from_1985() {
    assert_eq!(citybus::Bms12::new().with_production_year_raw(32).production_year(), Some(2017));
}

#[test]
fn bus_98_the_low_fan_bit_switches_the_air_conditioning() {
    let on = |data| value(BUS, "HVAC", data, Value::HvacOn);
    assert_eq!(on([0, 0b1100_0000, 0, 0, 0, 0, 0, 0]), Some(0), "high and mid without low is off");
    assert_eq!(on([0, 0b0010_0000, 0, 0, 0, 0, 0, 0]), Some(1));
}

#[test]
fn bus_106_the_same_code_means_something_else_elsewhere() {
    let en = |node, code| BUS.fault(node, code).map(|fault| fault.en);
    assert_eq!(en(Node::Bms, 4), Some("Cell undervoltage"));
    assert_eq!(
        en(Node::Vcu, 4),
        en(Node::Bms, 4),
        "the vehicle controller forwards the battery's codes (BUS-77)"
    );
    assert_eq!(en(Node::Steering, 4), Some("Overload"));
    assert_eq!(en(Node::Dcdc, 4), Some("Input overvoltage"));
    assert_eq!(en(Node::Inverter, 4), None, "no table of the motor controller is printed (BUS-08)");
}

#[test]
fn bus_79_the_level_of_a_code_is_the_printed_one_not_its_hundred() {
    let level = |code| BUS.fault(Node::Bms, code).and_then(|fault| fault.severity);
    assert_eq!([level(74), level(23)], [Some(Severity::Warn), Some(Severity::Derate)]);
    assert_eq!(
        [level(24), level(72), level(100)],
        [Some(Severity::Stop), Some(Severity::Derate), Some(Severity::Warn)]
    );
}

#[test]
fn bus_94_the_key_is_sent_as_lock_on_acc_start() {
    let key = |model| sent(BUS, "Meter1", &[(Value::BodyKey, model)])[1] >> 6;
    assert_eq!([0, 1, 2, 3].map(key), [0b00, 0b10, 0b01, 0b11], "model: lock, acc, on, start");
}

#[test]
fn bus_96_voltage_and_air_pressure_saturate_at_254() {
    let data =
        sent(BUS, "Meter1", &[(Value::SupplyVoltage, 243), (Value::AirFront, 85), (Value::AirRear, 9_999)]);
    assert_eq!([data[0], data[2], data[3]], [122, 85, 254], "24.3 V is 121.5 steps");
    assert_eq!(sent(BUS, "Meter1", &[])[0], 255, "unknown");
    assert_eq!(sent(BUS, "Meter1", &[(Value::SupplyVoltage, -5)])[0], 0);
}

#[test]
fn bus_18_bus_108_timeouts_come_from_the_slower_cycle() {
    let timeout = |name| BUS.rx.iter().find(|row| row.name == name).map(|row| row.timeout_ms);
    assert_eq!(timeout("VCU1"), Some(500), "5 x 20 ms is under the least");
    assert_eq!(timeout("VCU7"), Some(5_000));
    assert_eq!([timeout("BMS12"), timeout("Insulation")], [Some(15_000); 2]);
}

#[test]
fn bus_06_the_loss_of_ipu1_is_nobodys_alarm() {
    let expected = |name| BUS.rx.iter().find(|row| row.name == name).map(|row| row.expected);
    assert_eq!([expected("IPU1"), expected("IPU2"), expected("VCU1")], [Some(false), Some(true), Some(true)]);
}

#[test]
fn bus_10_vcu7_has_its_own_source_address() {
    assert_eq!(citybus::id::VCU7.bits(), 0x0CF1_064A);
    assert_eq!(citybus::id::VCU1.bits(), 0x0CF1_01A7);
}

#[test]
fn jl_02_printed_offsets_are_raw_counts() {
    // (30000 - 30000) * 0.1 = 0 Nm; printed offset -30000 counts.
    let torque =
        |raw| value(JIULONG, "VCU1", jiulong::Vcu1::new().with_torque_raw(raw).0, Value::MotorTorque);
    assert_eq!(
        [torque(0), torque(30_000), torque(60_000), torque(60_001)],
        [Some(-30_000), Some(0), Some(30_000), None]
    );
    let speed =
        |raw| value(JIULONG, "VCU3", jiulong::Vcu3::new().with_motor_speed_raw(raw).0, Value::MotorSpeed);
    assert_eq!([speed(0), speed(15_000), speed(30_000)], [Some(-15_000), Some(0), Some(15_000)]);
}

#[test]
fn jl_03_the_high_byte_comes_first_except_in_the_capacity() {
    assert_eq!(
        value(JIULONG, "BMSStatus", [0x0D, 0xAC, 0, 0, 0, 0, 0, 0], Value::BatteryVoltage),
        Some(3_500)
    );
    assert_eq!(
        value(JIULONG, "BMSFaults", [0, 0, 0, 0xB4, 0x00, 0, 0, 0], Value::BatteryCapacity),
        Some(180)
    );
    assert_eq!(value(JIULONG, "BMSFaults", [0, 0, 0, 0x00, 0xB4, 0, 0, 0], Value::BatteryCapacity), None);
}

#[test]
fn jl_04_the_odometer_is_sent_middle_low_high() {
    // 0x123456 km in 1/8 km, and a part of a kilometre that is dropped.
    let data = sent(JIULONG, "Meter1", &[(Value::ClusterOdometer, 0x12_3456 * 8 + 7)]);
    assert_eq!(data[3..6], [0x34, 0x56, 0x12]);
}

#[test]
fn jl_r010_jl_14_level_1_is_the_worst() {
    let level = |raw| {
        severity(
            JIULONG,
            "VCU2",
            jiulong::Vcu2::new().with_vcu_fault_level_raw(raw).0,
            Value::VehicleFaultLevel,
        )
    };
    use Severity::{Derate, None as NoFault, Stop, Warn};
    assert_eq!([0, 1, 2, 3].map(level), [NoFault, Stop, Derate, Warn].map(Some));
}

#[test]
fn jl_15_gear_3_is_invalid_and_0_is_neutral() {
    let gear = |raw| value(JIULONG, "VCU2", jiulong::Vcu2::new().with_gear_raw(raw).0, Value::VehicleGear);
    assert_eq!([0, 1, 2, 3].map(gear), [Some(3), Some(1), Some(2), None]);
}

#[test]
fn jl_r011_a_pedal_of_ff_is_a_fault() {
    let pedal = |raw| {
        value(
            JIULONG,
            "VCU1",
            jiulong::Vcu1::new().with_accelerator_pedal_raw(raw).0,
            Value::VehicleAccelerator,
        )
    };
    assert_eq!([pedal(250), pedal(251), pedal(255)], [Some(1_000), None, None]);
}

#[test]
fn jl_r014_jl_r016_vacuum_and_pressure_of_ff_are_invalid() {
    let vacuum =
        |raw| value(JIULONG, "VCU2", jiulong::Vcu2::new().with_vacuum_raw(raw).0, Value::BrakeVacuum);
    assert_eq!([vacuum(200), vacuum(255)], [Some(200), None], "0.01 bar is 1 kPa");
    let air =
        |raw| value(JIULONG, "VCU4", jiulong::Vcu4::new().with_air_pressure_1_raw(raw).0, Value::AirFront);
    assert_eq!([air(85), air(254), air(255)], [Some(85), Some(254), None], "0.1 bar is 0.01 MPa");
}

#[test]
fn jl_22_255_km_per_hour_is_a_speed() {
    assert_eq!(value(JIULONG, "VCU3", [255, 0, 0, 0, 0, 0, 0, 0], Value::VehicleSpeed), Some(255 * 256));
}

#[test]
fn jl_r023_jl_r024_smoke_is_level_1_and_a_broken_detector_level_2() {
    let alarms =
        |data| value(JIULONG, "BMSFaults", data, Value::BatteryAlarms).expect("bits are always valid");
    let levels = |data: [u8; 8]| {
        let codes = (0..31).filter(move |bit| alarms(data) >> bit & 1 == 1).map(|bit| bit + 1);
        codes
            .filter_map(|code| JIULONG.fault(Node::Bms, code))
            .map(|fault| fault.severity)
            .collect::<Vec<_>>()
    };
    assert_eq!(levels([0, 0, 0, 0, 0, 0b10_0000, 0, 0]), [Some(Severity::Derate)]);
    assert_eq!(levels([0, 0, 0, 0, 0, 0, 0b00_0001, 0]), [Some(Severity::Stop)]);
    assert_eq!(
        alarms([0xFF, 0xFF, 0, 0, 0, 0x3F, 0x3F, 0x01]),
        (1 << 29) - 1,
        "29 bits in the order of the document"
    );
    assert_eq!(alarms([0, 0, 0xFF, 0xFF, 0xFF, 0xC0, 0xC0, 0xFE]), 0, "reserved bits are no alarm");
    assert_eq!(alarms([0x08, 0, 0, 0, 0, 0, 0, 0]), 1 << 3, "main negative cut is code 4");
}

#[test]
fn jl_31_the_fault_frame_may_take_500_ms() {
    let row = JIULONG.rx.iter().find(|row| row.name == "BMSFaults").expect("it is received");
    assert_eq!((row.timeout_ms, row.life), (2_500, None));
}

#[test]
fn jl_36_an_unknown_state_forbids_the_remote_upgrade() {
    for message in ["Meter2", "Meter3"] {
        assert_eq!(sent(JIULONG, message, &[])[1], 1);
        assert_eq!(sent(JIULONG, message, &[(Value::ClusterUpgradeForbidden, 0)])[1], 0);
    }
}

#[test]
fn jl_46_temperatures_above_raw_250_are_invalid() {
    let hot = |raw| {
        value(
            JIULONG,
            "VCU1",
            jiulong::Vcu1::new().with_motor_temperature_raw(raw).0,
            Value::MotorTemperature,
        )
    };
    assert_eq!([hot(0), hot(250), hot(251)], [Some(-40), Some(210), None]);
}

#[test]
fn jl_52_ready_is_only_001() {
    let ready =
        |raw| value(JIULONG, "VCU1", jiulong::Vcu1::new().with_work_state_raw(raw).0, Value::VehicleReady);
    assert_eq!([0, 1, 2, 7].map(ready), [Some(0), Some(1), Some(0), Some(0)]);
}

#[test]
fn c5_05_the_byte_order_changes_from_frame_to_frame() {
    // BMSA: low byte first, raw 0x1388 = 5000 = 0 A. BMSB: high byte first, 0x0E42 = 3650 mV.
    let current = [0, 0, 0x88, 0x13, 0, 0, 0, 0];
    assert_eq!(value(C5EV, "BMSA", current, Value::BatteryCurrent), Some(0));
    assert_eq!(value(C5EV, "BMSB", [0, 0, 0x0E, 0x42, 0, 0, 0, 0], Value::BatteryCellMax), Some(3_650));
}

#[test]
fn c5_06_c5_07_charging_is_byte_6_bit_7_and_battery_low_is_byte_7_bit_5() {
    let byte6 = [0, 0, 0, 0, 0, 0, 0x80, 0];
    let byte7 = [0, 0, 0, 0, 0, 0, 0, 0x20];
    let read = |data, what| value(C5EV, "VCUToCluster", data, what);
    assert_eq!((read(byte6, Value::ChargeState), read(byte6, Value::BatteryLow)), (Some(1), Some(0)));
    assert_eq!((read(byte7, Value::ChargeState), read(byte7, Value::BatteryLow)), (Some(0), Some(1)));
}

#[test]
fn c5_12_the_soc_for_the_cluster_counts_half_percents() {
    let soc = |raw| value(C5EV, "VCUToCluster", [raw, 0, 0, 0, 0, 0, 0, 0], Value::BatterySoc);
    assert_eq!([soc(0), soc(1), soc(200), soc(201)], [Some(0), Some(5), Some(1_000), None]);
    assert_eq!(c5ev::Bmsa([250, 0, 0, 0, 0, 0, 0, 0]).soc(), Some(500), "0.4 % in the battery's own frame");
}

#[test]
fn c5_13_the_charge_limit_of_raw_0_is_500_a() {
    assert_eq!(value(C5EV, "BMSA", [0; 8], Value::BatteryChargeLimit), Some(5_000));
}

#[test]
fn c5_19_gear_3_is_park() {
    let gear = |raw| value(C5EV, "VCUToCluster", [0, 0, 0, 0, 0, 0, raw, 0], Value::VehicleGear);
    assert_eq!(
        [0, 1, 2, 3].map(|raw| gear(raw).and_then(Gear::from_number)),
        [Gear::N, Gear::D, Gear::R, Gear::P].map(Some)
    );
}

#[test]
fn c5_26_motor_power_counts_from_minus_50_kw() {
    let power = |raw| value(C5EV, "VCUToCluster", [0, 0, raw, 0, 0, 0, 0, 0], Value::MotorPower);
    assert_eq!([power(0), power(50), power(130), power(131)], [Some(-50_000), Some(0), Some(80_000), None]);
}

#[test]
fn c5_27_temperatures_count_from_minus_50() {
    let hot = |raw| value(C5EV, "BMSC", [0, raw, 0, 0, 0, 0, 0, 0], Value::BatteryTemperatureMax);
    assert_eq!([hot(0), hot(200), hot(201)], [Some(-50), Some(150), None]);
}

#[test]
fn c5_29_the_motor_command_is_torque_or_speed_by_control_mode() {
    let torque = [0b0000_0100, 0x2C, 0x01, 0, 0, 0, 0, 0];
    let speed = [0b0000_1000, 0x98, 0x3A, 0, 0, 0, 0, 0];
    let message =
        c5ev::MESSAGES.iter().find(|message| message.name == "VCUToMCU").expect("the motor command");
    let carried = |data: &[u8; 8]| {
        let names =
            message.signals.iter().filter(|signal| message.carries(signal, data)).map(|signal| signal.name);
        names.collect::<Vec<_>>()
    };
    assert!(carried(&torque).contains(&"torque") && !carried(&torque).contains(&"speed"));
    assert!(carried(&speed).contains(&"speed") && !carried(&speed).contains(&"torque"));
    assert_eq!(c5ev::VcuToMcu(torque).torque(), Some(300));
    assert_eq!(c5ev::VcuToMcu(speed).speed(), Some(15_000));
}

#[test]
fn c5_40_the_frame_for_the_cluster_is_missed_after_one_second() {
    let row = C5EV.rx.iter().find(|row| row.name == "VCUToCluster").expect("it is received");
    assert_eq!((row.timeout_ms, row.life, row.expected), (1_000, None, true));
}

#[test]
fn c5_43_the_insulation_counts_tenths_of_a_kiloohm_and_is_rounded_down() {
    let positive = |raw: u16| {
        let [high, low] = raw.to_be_bytes();
        value(C5EV, "BMSD", [0, 0, 0, 0, high, low, 0, 0], Value::InsulationPositive)
    };
    assert_eq!([positive(0), positive(19), positive(0xFFFF)], [Some(0), Some(1), Some(6_553)]);
}

#[test]
fn c5_r003_jl_r018_bus_r063_discharge_is_positive_everywhere() {
    let bus = citybus::Bms1::new().with_pack_current_raw(10_001).0;
    let jiulong = jiulong::BmsStatus::new().with_pack_current_raw(5_001).0;
    let c5ev = c5ev::Bmsa::new().with_pack_current_raw(5_001).0;
    assert_eq!(value(BUS, "BMS1", bus, Value::BatteryCurrent), Some(1));
    assert_eq!(value(JIULONG, "BMSStatus", jiulong, Value::BatteryCurrent), Some(1));
    assert_eq!(value(C5EV, "BMSA", c5ev, Value::BatteryCurrent), Some(1));
}

#[test]
fn x_08_d_and_r_have_the_same_raw_values_in_all_three() {
    let gears = |raw| {
        [
            value(BUS, "VCU1", citybus::Vcu1::new().with_gear_raw(raw).0, Value::VehicleGear),
            value(JIULONG, "VCU2", jiulong::Vcu2::new().with_gear_raw(raw).0, Value::VehicleGear),
            value(C5EV, "VCUToCluster", [0, 0, 0, 0, 0, 0, raw, 0], Value::VehicleGear),
        ]
    };
    assert_eq!(gears(1), [Some(1); 3]);
    assert_eq!(gears(2), [Some(2); 3]);
    assert_eq!(gears(0), [None, Some(3), Some(3)], "0 is blank in the bus, neutral in the others");
}
