//! All words of the cluster, Chinese and English side by side.
//!
//! Texts of fault codes belong to a vehicle and are generated from its folder; they are not kept here. The Chinese of
//! the fault lines is the documents' own: BUS-R050, BUS-R059, BUS-R119, BUS-R123, BUS-R125, BUS-109.

use crate::view::Text;
use protocol_core::vehicle::Node;

macro_rules! texts {
    ($($(#[$doc:meta])* $name:ident $zh:literal $en:literal;)*) => {
        $($(#[$doc])* pub const $name: Text = Text { zh: $zh, en: $en };)*

        /// Every text, for whoever must know all characters that can appear.
        pub const ALL: &[Text] = &[$($name),*];
    };
}

texts! {
    /// The vehicle controller reports level 1 (BUS-R050).
    SYSTEM_1 "系统一级故障" "System fault level 1";
    /// The vehicle controller reports level 2.
    SYSTEM_2 "系统二级故障" "System fault level 2";
    /// The vehicle controller reports level 3.
    SYSTEM_3 "系统三级故障" "System fault level 3";
    /// A fault code of the vehicle controller that has no text of its own.
    VEHICLE_CODE "整车故障代码" "Vehicle fault code";
    /// The vehicle has not taken the gear that was asked for.
    SHIFT_FAILED "挂档失败" "Gear not engaged";
    /// The battery reports level 1.
    BATTERY_1 "动力电池一级故障" "Battery fault level 1";
    /// The battery reports level 2.
    BATTERY_2 "动力电池二级故障" "Battery fault level 2";
    /// The battery reports level 3.
    BATTERY_3 "动力电池三级故障" "Battery fault level 3";
    /// The motor system reports a fault of some level.
    MOTOR "电机系统故障" "Motor system fault";
    /// A vehicle without levels reports a system fault.
    SYSTEM "系统故障" "System fault";
    /// The vehicle controller itself is faulty (JL-56).
    CONTROLLER "整车控制器故障" "Vehicle controller fault";
    /// A vehicle without levels reports a battery fault; an alarm of the battery without a text.
    BATTERY "动力电池故障" "Battery fault";
    /// A smoke detector in the battery gives alarm (JL-24).
    BATTERY_SMOKE "动力电池烟雾报警" "Smoke in the battery";
    /// The insulation monitor or its wiring is faulty.
    INSULATION_DEVICE "绝缘监测故障" "Insulation monitor fault";
    /// The charger reports a fault.
    CHARGER "充电机故障" "Charger fault";
    /// The charger has fallen silent while it is plugged in (C5-R005).
    CHARGER_LOST "充电机通信中断 充电断开" "Charger lost: charging ends";
    /// The air conditioning reports a fault.
    HVAC "空调系统故障" "Air conditioning fault";
    /// A running air conditioning has lost its link (BUS-R133).
    HVAC_LOST "空调通信故障" "Air conditioning link lost";
    /// The anti-lock brake is faulty.
    BRAKE_ABS "ABS 故障" "ABS fault";
    /// The brake force distribution is faulty.
    BRAKE_EBD "EBD 故障" "EBD fault";
    /// The brake vacuum is faulty.
    BRAKE_VACUUM "制动负压故障" "Brake vacuum fault";
    /// Water pump or fan is faulty.
    COOLING "散热系统故障" "Cooling fault";
    /// The low-voltage supply is under its limit (JL-23).
    SUPPLY_LOW "低压电源欠压" "Low-voltage supply low";
    /// The air compressor is too hot.
    COMPRESSOR_HOT "空压机过温" "Air compressor hot";
    /// The vehicle limps without word from the battery (BUS-R080).
    LIMP "电池通信中断 限功率 无回馈" "Limp: power limited, no regen";
    /// The insulation monitor gives alarm.
    INSULATION "绝缘故障" "Insulation fault";
    /// Fire, by either route (BUS-116).
    FIRE "火灾报警 立即停车疏散" "FIRE: stop, get everyone out";
    /// The cluster's smoke detector gives alarm.
    SMOKE "烟雾报警" "Smoke alarm";
    /// The battery asks for high voltage off: the vehicle has 5 s (BUS-68).
    HV_OFF_ASKED "电池请求断开高压 请停车" "Battery asks for HV off: stop";
    /// The vehicle has let its 5 s pass.
    HV_OFF_OVERDUE "高压未断开 电池将自行断开" "HV still on: battery will cut it";
    /// The battery's 35 s are over.
    HV_OFF_NOW "电池正在断开高压" "Battery cuts HV now";
    /// High voltage is off, as asked for.
    HV_OFF_DONE "动力电池高压断开" "High voltage is off";
    /// IPU3 status 5 (BUS-R059).
    MOTOR_CONTROLLER "电机控制器系统故障" "Motor controller fault";
    /// Steering pump status 10 (BUS-R119).
    STEERING "助力系统故障" "Steering assistance fault";
    /// DC/DC converter status 10 (BUS-R123).
    DCDC "DCDC 系统故障" "DC/DC converter fault";
    /// Air compressor status 10 (BUS-R125).
    COMPRESSOR "空压机系统故障" "Air compressor fault";
    /// Drive power is limited (BUS-R024).
    POWER_LIMITED "限功率" "Power limited";
    /// Drive torque is limited (BUS-R025).
    TORQUE_LIMITED "限转矩" "Torque limited";
    /// The vehicle controller has stopped sending.
    SILENT_VCU "整车控制器通信中断" "No communication: VCU";
    /// The motor controller has stopped sending.
    SILENT_INVERTER "电机控制器通信中断" "No communication: motor";
    /// The battery has stopped sending.
    SILENT_BMS "电池管理系统通信中断" "No communication: BMS";
    /// The DC/DC converter has stopped sending.
    SILENT_DCDC "DCDC 通信中断" "No communication: DC/DC";
    /// The steering pump has stopped sending.
    SILENT_STEERING "助力系统通信中断" "No communication: steering";
    /// The air compressor has stopped sending.
    SILENT_COMPRESSOR "空压机通信中断" "No communication: compressor";
    /// The air conditioning has stopped sending.
    SILENT_HVAC "空调通信中断" "No communication: HVAC";
    /// The insulation monitor has stopped sending.
    SILENT_INSULATION "绝缘监测通信中断" "No communication: insulation";
    /// The on-board charger has stopped sending.
    SILENT_CHARGER "充电机通信中断" "No communication: charger";
    /// The contactor box has stopped sending.
    SILENT_CONTACTORS "高压控制盒通信中断" "No communication: contactors";
    /// The CAN controller does not answer.
    NO_CONTROLLER "CAN 控制器通信中断" "No CAN controller: check wiring";
    /// The cluster has been reset by a fault of its own; the code is the source line.
    RESTARTED "仪表故障后重启" "Cluster restarted after a fault";
    /// What was kept over power-off cannot be read or written.
    MEMORY "仪表存储故障" "Stored data lost: odometer unknown";
    /// No vehicle has been recognised yet.
    LISTENING "总线监测中" "Listening for a vehicle";
    /// As much speaks for another vehicle as for the one recognised.
    DOUBT "总线与车不匹配" "Another vehicle on this bus";
}

/// Returns the text of a node that has stopped sending.
pub(crate) const fn silent(node: Node) -> Text {
    match node {
        // The cluster does not receive from itself: no row asks for it.
        Node::Vcu | Node::Cluster => SILENT_VCU,
        Node::Inverter => SILENT_INVERTER,
        Node::Bms => SILENT_BMS,
        Node::Dcdc => SILENT_DCDC,
        Node::Steering => SILENT_STEERING,
        Node::Compressor => SILENT_COMPRESSOR,
        Node::Hvac => SILENT_HVAC,
        Node::Insulation => SILENT_INSULATION,
        Node::Charger => SILENT_CHARGER,
        Node::Contactors => SILENT_CONTACTORS,
    }
}
