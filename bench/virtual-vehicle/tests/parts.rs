//! Rules of the parts on the link: pumps, converter, air conditioning, insulation monitor.

mod ride;

use protocol_core::generated::citybus;
use ride::Ride;
use virtual_vehicle::Kind;

fn pump(ride: &Ride) -> citybus::SteeringPump {
    citybus::SteeringPump(ride.frame(citybus::id::STEERING_PUMP))
}

fn converter(ride: &Ride) -> citybus::Dcdc {
    citybus::Dcdc(ride.frame(citybus::id::DCDC))
}

fn compressor(ride: &Ride) -> citybus::AirPump {
    citybus::AirPump(ride.frame(citybus::id::AIR_PUMP))
}

fn hvac(ride: &Ride) -> citybus::Hvac {
    citybus::Hvac(ride.frame(citybus::id::HVAC))
}

/// A bus with the air conditioning on, in a cabin of so many degrees, with so much charge.
fn conditioned(cabin: &str, soc: &str) -> Ride {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.set("battery.soc", soc).set("hvac.cabin", cabin).set("driver.air_conditioning", "on").seconds(10);
    ride
}

#[test]
fn bus_r040_the_steering_pump_obeys_after_start_and_0_means_its_default() {
    let mut ride = Ride::new(Kind::Citybus);
    ride.seconds(3);
    assert_eq!((pump(&ride).status_raw(), pump(&ride).motor_speed_raw()), (0, 0), "no start command");
    ride.set("driver.key", "start").seconds(5);
    assert_eq!(citybus::Vcu4(ride.frame(citybus::id::VCU4)).frequency_raw(), 0);
    assert_eq!((pump(&ride).status_raw(), ride.read("steering.speed")), (1, 1_500.0));
    ride.set("driver.target", "40").seconds(30);
    let hertz = f64::from(citybus::Vcu4(ride.frame(citybus::id::VCU4)).frequency_raw());
    assert!(hertz > 0.0);
    assert_eq!(ride.read("steering.speed"), 30.0 * hertz, "two pole pairs");
}

#[test]
fn bus_r118_the_pump_is_under_external_control_only_while_that_is_valid() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.seconds(3);
    assert_eq!(pump(&ride).external_control_raw(), 0, "power-up default");
    ride.set("driver.target", "40").seconds(30);
    assert_eq!(pump(&ride).external_control_raw(), 1);
    ride.set("lost.VCU4", "on").seconds(3);
    assert_eq!((pump(&ride).external_control_raw(), pump(&ride).status_raw()), (0, 1));
    assert_eq!(
        ride.read("steering.speed"),
        1_500.0,
        "rated speed: nobody loses his steering over a lost frame"
    );
    ride.set("lost.VCU4", "off").seconds(3);
    assert_eq!(pump(&ride).external_control_raw(), 1);
}

#[test]
fn bus_r118_a_pump_that_hears_nothing_goes_on_as_it_was() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.seconds(3).set("lost.VCU4", "on").seconds(2);
    // The plug ends READY, and with it the command; the link stays live for the converter.
    ride.set("charge.plug", "on").seconds(3);
    assert_eq!((ride.world().vcu.steering.0, pump(&ride).status_raw()), (false, 1));
    ride.set("lost.VCU4", "off").seconds(3);
    assert_eq!(pump(&ride).status_raw(), 0, "hears it now");
}

#[test]
fn a_part_with_a_fault_stands_and_says_so() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.set("air.mpa", "0.5").seconds(5);
    assert_eq!(
        [pump(&ride).status_raw(), converter(&ride).status_raw(), compressor(&ride).status_raw()],
        [1, 1, 1]
    );
    for part in ["steering", "dcdc", "compressor"] {
        ride.set(&format!("{part}.fault_code"), "3");
    }
    ride.seconds(5);
    assert_eq!(
        [pump(&ride).status_raw(), converter(&ride).status_raw(), compressor(&ride).status_raw()],
        [2, 2, 2]
    );
    assert_eq!(ride.world().accessory_watts(), 0.0);
}

#[test]
fn bus_r042_the_air_conditioning_does_not_start_below_25_volts() {
    let starts = |volts: &str| {
        let mut ride = Ride::ready(Kind::Citybus);
        ride.set("supply.volts", volts)
            .set("hvac.cabin", "30")
            .set("driver.air_conditioning", "on")
            .seconds(10);
        ride.world().hvac.on
    };
    assert_eq!([starts("24.4"), starts("24.6"), starts("25"), starts("27")], [false, true, true, true]);
}

#[test]
fn bus_r042_what_runs_already_is_not_stopped_by_it() {
    let mut ride = conditioned("30", "80");
    ride.set("supply.volts", "24").seconds(2);
    assert!(ride.world().hvac.on);
}

#[test]
fn bus_r043_bus_r141_below_20_percent_nothing_of_it_runs() {
    let mut ride = conditioned("35", "80");
    assert!(hvac(&ride).fan_low_raw() == 1 && hvac(&ride).cooling_1_raw() == 1);
    ride.set("battery.soc", "19.7").seconds(3);
    assert_eq!((hvac(&ride).fan_low_raw(), hvac(&ride).cooling_1_raw()), (0, 0));
    assert_eq!(ride.world().hvac.watts, 0.0);
}

#[test]
fn bus_r139_bus_r140_bus_r141_charge_decides_on_fan_and_start_of_cooling() {
    let runs = |soc: &str| {
        let ride = conditioned("35", soc);
        (ride.world().hvac.fan > 0, ride.world().hvac.cooling)
    };
    // Counts of 0.4 %: 75 is 30.0 and 50 is 20.0, whatever the cells really have.
    assert_eq!(runs("30.3"), (true, true), "76");
    assert_eq!(runs("30.15"), (true, false), "75");
    assert_eq!(runs("20.2"), (true, false), "50 or 51");
    assert_eq!(runs("19.9"), (true, false), "50");
    assert_eq!(runs("19.7"), (false, false), "49");
}

#[test]
fn bus_r140_a_running_compressor_goes_on_between_20_and_30_percent_at_half_power() {
    let mut ride = conditioned("40", "80");
    let full = ride.world().hvac.watts;
    ride.set("battery.soc", "25").seconds(2);
    assert!(ride.world().hvac.cooling, "only the start is forbidden (BUS-49)");
    assert!(ride.world().hvac.watts < 0.6 * full, "BUS-R046");
}

#[test]
fn bus_r044_cooling_waits_for_permit_and_precharge() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.set("hvac.cabin", "35").set("driver.air_conditioning", "on");
    let fan = ride.until("fan", 10, |ride| ride.world().hvac.fan > 0);
    let cold = fan + ride.until("cooling", 10, |ride| ride.world().hvac.cooling);
    assert!(fan >= 3_000 && cold >= fan + 1_900, "{fan} {cold}");
}

#[test]
fn bus_r045_a_fault_that_the_reset_clears_is_forgotten_and_one_that_stays_stops_it() {
    let mut ride = conditioned("35", "80");
    ride.set("hvac.fault", "pressure_fault").ms(1_200);
    assert_eq!(citybus::Vcu5(ride.frame(citybus::id::VCU5)).reset_raw(), 1);
    assert!(ride.world().hvac.on);
    ride.set("hvac.fault", "none").seconds(6);
    assert!(ride.world().hvac.on && ride.world().hvac.cooling);
    ride.set("hvac.fault", "inverter_fault").seconds(6);
    assert!(!ride.world().hvac.on);
    assert_eq!(citybus::Vcu5(ride.frame(citybus::id::VCU5)).reset_raw(), 0, "tried once");
    assert_eq!(hvac(&ride).inverter_fault_raw(), 1);
}

#[test]
fn bus_r047_a_threshold_of_0_leaves_the_converter_to_its_own() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.seconds(3);
    let said = citybus::Vcu6(ride.frame(citybus::id::VCU6));
    assert_eq!((said.input_voltage_limit_raw(), said.start_battery_voltage_raw()), (0, 0));
    assert!(ride.world().dcdc.running);
    ride.set("vcu.dcdc_input_limit", "900").seconds(3);
    assert!(!ride.world().dcdc.running, "a link of 560 V is below that");
    ride.set("vcu.dcdc_input_limit", "500").set("vcu.dcdc_start_volts", "20").seconds(3);
    assert!(!ride.world().dcdc.running, "a battery of 25 V needs no start below 20");
    ride.set("vcu.dcdc_start_volts", "26").seconds(3);
    assert!(ride.world().dcdc.running);
}

#[test]
fn bus_r048_aa_starts_the_converter_and_55_lets_it_stand_by() {
    let mut ride = Ride::new(Kind::Citybus);
    ride.seconds(2);
    assert_eq!(citybus::Vcu6(ride.frame(citybus::id::VCU6)).command_raw(), 0x55);
    assert_eq!(converter(&ride).status_raw(), 0);
    ride.set("driver.key", "start").seconds(4);
    assert_eq!(citybus::Vcu6(ride.frame(citybus::id::VCU6)).command_raw(), 0xAA);
    assert_eq!(converter(&ride).status_raw(), 1);
    assert!((27.0..28.0).contains(&ride.read("supply.volts")));
}

#[test]
fn without_the_converter_the_auxiliary_battery_runs_down() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.set("dcdc.fault_code", "1").seconds(2);
    let before = ride.read("supply.volts");
    ride.seconds(1_800);
    let after = ride.read("supply.volts");
    assert!(before < 26.0 && after < before - 0.1, "{before} {after}");
}

#[test]
fn bus_r052_the_compressor_fills_the_reservoirs_at_its_default_frequency() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.set("air.mpa", "0.6").seconds(3);
    // VCU8 has the layout of VCU4.
    let said = citybus::Vcu4(ride.frame(citybus::id::VCU8));
    assert_eq!((said.run_raw(), said.frequency_raw()), (1, 0));
    assert_eq!(ride.read("compressor.speed"), 1_500.0);
    ride.set("air.mpa", "auto").seconds(60);
    assert!((0.80..0.85).contains(&ride.read("air.front")));
    assert_eq!((compressor(&ride).status_raw(), ride.read("compressor.speed")), (0, 0.0));
}

#[test]
fn bus_r052_without_a_start_command_the_compressor_stands() {
    let mut ride = Ride::new(Kind::Citybus);
    ride.set("air.mpa", "0.3").seconds(5);
    assert_eq!((compressor(&ride).status_raw(), ride.read("compressor.speed")), (0, 0.0));
}

#[test]
fn braking_uses_air_and_holding_the_pedal_does_not() {
    let mut ride = Ride::new(Kind::Citybus);
    let rest = ride.read("air.front");
    ride.set("driver.brake", "100").seconds(1);
    let pressed = ride.read("air.front");
    assert!(pressed < rest - 0.02);
    ride.seconds(20);
    assert!(ride.read("air.front") > pressed - 0.001);
}

#[test]
fn bus_r133_after_10_s_without_vcu5_there_is_an_alarm_and_the_cooling_goes_on() {
    let mut ride = conditioned("40", "80");
    ride.set("lost.VCU5", "on");
    let silence = |ride: &Ride| {
        ride.world().links.inbox(protocol_core::vehicle::Node::Hvac).silence_ms(citybus::id::VCU5)
    };
    ride.until("alarm", 11, |ride| ride.world().hvac.communication_alarm);
    assert_eq!(silence(&ride), 10_000);
    assert!(ride.world().hvac.cooling);
    ride.set("battery.soc", "15").seconds(5);
    assert!(ride.world().hvac.cooling, "it keeps on as it was");
    assert_eq!(hvac(&ride).communication_alarm_raw(), 1);
    ride.set("driver.key", "lock").seconds(1);
    assert!(!ride.world().hvac.on, "until it is powered down");
}

#[test]
fn bus_r133_one_that_is_off_raises_no_alarm() {
    let mut ride = Ride::ready(Kind::Citybus);
    ride.set("lost.VCU5", "on").seconds(15);
    assert!(!ride.world().hvac.communication_alarm);
}

#[test]
fn bus_r135_bus_r136_the_low_bit_is_on_and_off_and_the_others_are_the_speed() {
    let bits = |ride: &Ride| (hvac(ride).fan_low_raw(), hvac(ride).fan_mid_raw(), hvac(ride).fan_high_raw());
    assert_eq!(bits(&conditioned("40", "80")), (1, 0, 1), "far from the setpoint: high");
    let mut ride = conditioned("27.6", "25");
    assert_eq!(bits(&ride), (1, 1, 0), "nearer: medium");
    ride.set("hvac.cabin", "24").seconds(2);
    assert_eq!(bits(&ride), (1, 0, 0), "there: low");
    ride.set("driver.air_conditioning", "off").seconds(2);
    assert_eq!(bits(&ride), (0, 0, 0));
}

#[test]
fn bus_r137_bus_r138_cooling_heating_and_ventilation() {
    let bits =
        |ride: &Ride| (hvac(ride).cooling_1_raw() | hvac(ride).cooling_2_raw(), hvac(ride).heating_raw());
    assert_eq!(bits(&conditioned("35", "80")), (1, 0));
    assert_eq!(bits(&conditioned("10", "80")), (0, 1));
    assert_eq!(bits(&conditioned("24", "80")), (0, 0), "ventilation");
}

#[test]
fn bus_r142_cooling_ends_at_22_and_heating_at_32_degrees() {
    let mut ride = conditioned("26", "80");
    ride.set("road.celsius", "35").set("hvac.setpoint", "16").seconds(600);
    let cabin = ride.read("cabin.temperature");
    assert!((21.4..23.5).contains(&cabin), "{cabin}");
    let mut ride = conditioned("28", "80");
    ride.set("road.celsius", "20").set("hvac.setpoint", "36").seconds(900);
    let cabin = ride.read("cabin.temperature");
    assert!((30.5..32.6).contains(&cabin), "{cabin}");
}

#[test]
fn bus_r144_the_monitor_in_the_battery_box_sends_the_insulation_frame() {
    let mut ride = Ride::ready(Kind::Citybus);
    let said = |ride: &Ride| citybus::Insulation(ride.frame(citybus::id::INSULATION));
    ride.seconds(4);
    assert_eq!((said(&ride).leakage_level_raw(), said(&ride).positive_resistance_raw()), (0, 5_000));
    // At 560 V 500 ohm per volt are 280 kohm, 100 are 56; at 400 V 200 and 40.
    let both = [("560", "280", 0), ("560", "279", 1), ("560", "56", 1), ("560", "55", 2)];
    let low = [("400", "200", 0), ("400", "199", 1), ("400", "40", 1), ("400", "39", 2)];
    for (volts, kiloohm, level) in both.into_iter().chain(low) {
        ride.set("battery.volts", volts);
        ride.set("insulation.kiloohm", kiloohm).seconds(4);
        assert_eq!(said(&ride).leakage_level_raw(), level, "{kiloohm} kohm");
    }
    assert_eq!(
        citybus::Vcu1(ride.frame(citybus::id::VCU1)).system_fault_raw(),
        1,
        "leakage is a system fault (BUS-R023)"
    );
}
