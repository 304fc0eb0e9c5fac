//! The motor and its controller: torque, electrical power, heat, protections.
//!
//! Electrical power is mechanical power and three losses: a share of it, the copper's, and the controller's own. All
//! of it comes out of the link, whose voltage the battery's module owns: nothing flows while the contactors are open.
//! Protections from temperature and speed are this module's; the others are set by a person.

use crate::control::{Setting, Word};
use crate::spec::Spec;
use crate::world::World;
use crate::{Kind, STEP_S};
use protocol_core::model::Severity;

/// Time from no torque to the largest, in s.
const FULL_TORQUE_S: f64 = 0.3;
/// Share of the heat that the windings take; the rest is the controller's.
const WINDING_SHARE: f64 = 0.6;
/// Thermal mass of winding and controller in J/K per W of the motor's rating.
const THERMAL_MASS: (f64, f64) = (0.5, 0.12);
/// Cooling of winding and controller in W/K per W of rating.
const COOLING: (f64, f64) = (4.0e-4, 6.0e-4);
/// Winding and controller temperature above which the protection bits are set.
pub(crate) const TOO_HOT: (f64, f64) = (150.0, 90.0);

/// Gives the torque that is wanted, as far and as fast as the motor can.
pub(super) fn torque(world: &mut World, spec: &Spec) {
    let can = world.hv_connected() && world.motor.fault_code == 0 && world.motor.protections_set == 0;
    world.motor.running = can && world.vcu.ready;
    world.motor.peak_nm = if world.motor.running {
        spec.driving_nm(spec.max_watts, spec.omega(world.motion.metres_per_s).abs())
    } else {
        0.0
    };
    if !world.motor.running {
        world.motor.nm = 0.0;
        return;
    }
    let most = spec.max_nm * STEP_S / FULL_TORQUE_S;
    let motor = &mut world.motor;
    // Less torque comes at once: a limit that falls is kept in the same step.
    let falls = motor.wanted_nm * motor.nm >= 0.0 && motor.wanted_nm.abs() < motor.nm.abs();
    motor.nm =
        if falls { motor.wanted_nm } else { motor.nm + (motor.wanted_nm - motor.nm).clamp(-most, most) };
}

/// Takes the power from the link that torque and speed need.
pub(super) fn power(world: &mut World, spec: &Spec, omega: f64) {
    let nm = world.motor.nm;
    let mechanical = nm * omega;
    let loss = if world.motor.running {
        spec.idle_watts + Spec::LOSS * mechanical.abs() + spec.copper_watts(nm)
    } else {
        0.0
    };
    let motor = &mut world.motor;
    motor.watts = mechanical + loss;
    let share = nm.abs() / spec.max_nm;
    motor.phase_amps =
        share * spec.max_watts / (0.6 * spec.link_volts) * if motor.watts < 0.0 { -1.0 } else { 1.0 };
    motor.phase_volts =
        0.4 * motor.link_volts * (motor.rpm.abs() / spec.overspeed_rpm() + 0.1 * share).min(1.0);
    world.energy.motor += motor.watts * STEP_S;
    world.energy.motor_heat += loss * STEP_S;
    world.energy.accessories += world.accessory_watts() * STEP_S;
    heat_up(world, spec, loss);
}

fn heat_up(world: &mut World, spec: &Spec, loss: f64) {
    let ambient = world.road.celsius;
    let cooler = if world.vcu.coolant_pump { 1.0 } else { 0.3 } + 0.5 * f64::from(world.vcu.coolant_fan);
    let warm = |celsius: f64, watts: f64, mass: f64, cooling: f64| {
        let out = cooling * spec.max_watts * cooler * (celsius - ambient);
        celsius + (watts - out) / (mass * spec.max_watts) * STEP_S
    };
    let motor = &mut world.motor;
    motor.celsius = warm(motor.celsius, WINDING_SHARE * loss, THERMAL_MASS.0, COOLING.0);
    motor.inverter_celsius =
        warm(motor.inverter_celsius, (1.0 - WINDING_SHARE) * loss, THERMAL_MASS.1, COOLING.1);
}

/// Puts a person's temperatures in place and sets the protections that follow from what is.
pub(super) fn heat(world: &mut World, spec: &Spec) {
    let motor = &mut world.motor;
    motor.celsius = motor.celsius_override.unwrap_or(motor.celsius);
    motor.inverter_celsius = motor.inverter_celsius_override.unwrap_or(motor.inverter_celsius);
    let bits = match world.kind {
        Kind::Citybus => [4, 5, 6],
        Kind::Jiulong => [4, 16, 17],
        Kind::C5ev => [0, 1, 2],
    };
    let seen = [
        motor.celsius > TOO_HOT.0,
        motor.inverter_celsius > TOO_HOT.1,
        motor.rpm.abs() > spec.overspeed_rpm(),
    ];
    let own = bits.iter().zip(seen).fold(0, |bits, (bit, is)| bits | u32::from(is) << bit);
    motor.protections = motor.protections_set | own;
}

/// How bad what the motor controller finds is: it stops for its own fault and for a protection that has tripped, drives
/// on with less when too hot or too fast, and gives alarm while heat takes torque (JL-R010).
pub(crate) fn severity(world: &World) -> Severity {
    let motor = &world.motor;
    match (motor.fault_code != 0 || motor.protections_set != 0, motor.protections != 0) {
        (true, _) => Severity::Stop,
        (false, true) => Severity::Derate,
        (false, false) if crate::vcu::is_warm(world) => Severity::Warn,
        (false, false) => Severity::None,
    }
}

pub(super) fn get_protection(world: &World) -> Setting {
    Some(match world.motor.protections_set {
        0 => 0.0,
        bits => f64::from(bits.trailing_zeros() + 1),
    })
}

pub(super) fn set_protection(world: &mut World, setting: Setting) {
    world.motor.protections_set = match setting.unwrap_or_default() as u32 {
        0 => 0,
        word => 1 << (word - 1),
    };
}

const fn word(word: &'static str, zh: &'static str, en: &'static str) -> Word {
    Word { word, zh, en }
}

const NONE: Word = word("none", "无", "None");

/// Protections of the bus's IPU1, in its order.
pub(super) const BUS_PROTECTIONS: &[Word] = &[
    NONE,
    word("bus_overcurrent", "母线过流", "Link current too high"),
    word("position_sensor_fault", "位置传感器故障", "Position sensor"),
    word("bus_overvoltage", "母线过压", "Link voltage too high"),
    word("bus_undervoltage", "母线欠压", "Link voltage too low"),
    word("motor_over_temperature", "电机过温", "Motor too hot"),
    word("inverter_over_temperature", "控制器过温", "Controller too hot"),
    word("overspeed", "超速", "Motor too fast"),
];

/// Protections of the jiulong's VCU3, in its order.
pub(super) const JIULONG_PROTECTIONS: &[Word] = &[
    NONE,
    word("igbt_protection", "IGBT 保护", "IGBT"),
    word("drive_supply_undervoltage", "驱动电源欠压", "Gate supply too low"),
    word("bridge_shoot_through", "桥臂直通", "Bridge shoot-through"),
    word("igbt_over_temperature", "IGBT 过温", "IGBT too hot"),
    word("motor_over_temperature", "电机过温", "Motor too hot"),
    word("bus_overcurrent", "母线过流", "Link current too high"),
    word("phase_overcurrent", "相电流过流", "Phase current too high"),
    word("control_undervoltage", "控制电源欠压", "Control supply too low"),
    word("control_reversed", "控制电源反接", "Control supply reversed"),
    word("control_overvoltage", "控制电源过压", "Control supply too high"),
    word("dq_overcurrent", "DQ 电流过流", "DQ current too high"),
    word("bus_undervoltage", "母线欠压", "Link voltage too low"),
    word("bus_overvoltage", "母线过压", "Link voltage too high"),
    word("over_torque", "过转矩", "Torque too high"),
    word("overload", "过载", "Overload"),
    word("stall", "堵转", "Stalled"),
    word("driver_over_temperature", "控制器过温", "Controller too hot"),
    word("overspeed", "超速", "Motor too fast"),
    word("can_fault", "CAN 故障", "CAN"),
    word("back_emf", "反电动势", "Back EMF"),
    word("phase_loss", "缺相", "Phase lost"),
    word("resolver_fault", "旋变故障", "Resolver"),
    word("hardware_shutdown", "硬件封锁", "Hardware shutdown"),
];
