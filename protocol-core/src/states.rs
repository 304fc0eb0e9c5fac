//! Every state that a value can be in: one row with its number, its word and its texts.
//!
//! The word is the public name: `vehicle.toml`, scenarios, recordings, JSON and the page have it. The Chinese and English
//! texts are for people. `docs/reference/states.md` is made of these rows. Refuses to know which value is in which state,
//! and the raw values of any vehicle: those are in its DBC. The firmware pays only for the faces that it uses.

use serde::Serialize;

/// One state, with all its faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct State {
    /// Number in the model and in the PC link's records.
    pub number: i32,
    /// Public name, unique in its kind.
    pub word: &'static str,
    /// Text in simplified Chinese.
    pub zh: &'static str,
    /// Text in English.
    pub en: &'static str,
    /// Other spellings that a person may know; never read, only answered with [`State::word`].
    #[serde(skip)]
    pub other: &'static [&'static str],
}

/// One kind of state: all that a value of it can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kind {
    /// Public name, for example `contactor`.
    pub name: &'static str,
    /// Its states, in the order of their numbers.
    pub states: &'static [State],
}

impl Kind {
    /// Returns the state of this number.
    pub fn of_number(&self, number: i32) -> Option<&'static State> {
        self.states.iter().find(|state| state.number == number)
    }

    /// Returns the state of this word, and of no other spelling.
    pub fn of_word(&self, word: &str) -> Option<&'static State> {
        self.states.iter().find(|state| state.word == word)
    }

    /// Returns the state that a former or foreign spelling means, to name the right word in an error.
    ///
    /// Known elsewhere are the word in other letters, the texts, former words and the number.
    pub fn meant_by(&self, text: &str) -> Option<&'static State> {
        let number = text.parse().ok();
        let is_meant = |state: &&State| {
            [state.word, state.zh, state.en]
                .iter()
                .chain(state.other)
                .any(|face| face.eq_ignore_ascii_case(text))
                || number == Some(state.number)
        };
        self.states.iter().find(is_meant)
    }
}

macro_rules! states {
    ($(
        $(#[$about:meta])*
        $kind:ident $name:literal {
            $($(#[$mark:meta])* $state:ident $number:literal $word:literal $zh:literal $en:literal $(, also $($other:literal)+)?;)+
        }
    )+) => {
        $(
            $(#[$about])*
            #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
            #[repr(u8)]
            pub enum $kind {
                $(
                    #[doc = concat!("`", $word, "`: ", $zh, ", ", $en, ".")]
                    $(#[$mark])*
                    $state = $number,
                )+
            }

            impl $kind {
                /// Every state, in the order of their numbers.
                pub const ALL: &'static [Self] = &[$(Self::$state),+];
                /// The rows.
                pub const KIND: Kind = Kind {
                    name: $name,
                    states: &[$(State {
                        number: $number,
                        word: $word,
                        zh: $zh,
                        en: $en,
                        other: &[$($($other),+)?],
                    }),+],
                };

                /// Returns the state of this number; `None` if no row has it.
                pub const fn from_number(number: i32) -> Option<Self> {
                    match number {
                        $($number => Some(Self::$state),)+
                        _ => None,
                    }
                }

                /// Returns the state of this word, and of no other spelling.
                pub fn from_word(word: &str) -> Option<Self> {
                    match word {
                        $($word => Some(Self::$state),)+
                        _ => None,
                    }
                }

                /// Returns the number in the model and in the PC link's records.
                pub const fn number(self) -> i32 {
                    self as i32
                }

                /// Returns the public name.
                pub const fn word(self) -> &'static str {
                    match self { $(Self::$state => $word),+ }
                }

                /// Returns the text in simplified Chinese.
                pub const fn zh(self) -> &'static str {
                    match self { $(Self::$state => $zh),+ }
                }

                /// Returns the text in English.
                pub const fn en(self) -> &'static str {
                    match self { $(Self::$state => $en),+ }
                }
            }
        )+

        /// Every kind of state.
        pub const KINDS: &[Kind] = &[$($kind::KIND),+];
    };
}

states! {
    /// Yes or no.
    Flag "flag" {
        No 0 "no" "否" "No", also "off" "false";
        Yes 1 "yes" "是" "Yes", also "on" "true";
    }

    /// How bad a fault is: one scale for every source (the raw level fields run in opposite directions).
    #[derive(Default)]
    Severity "severity" {
        #[default]
        None 0 "none" "无" "None", also "no fault" "information";
        Warn 1 "warn" "报警" "Warn";
        Derate 2 "derate" "降额" "Derate";
        Stop 3 "stop" "停车" "Stop";
    }

    /// A gear; its letter is its text in every language.
    #[derive(Default)]
    Gear "gear" {
        D 1 "D" "D" "D", also "drive";
        R 2 "R" "R" "R", also "reverse";
        #[default]
        N 3 "N" "N" "N", also "neutral";
        P 4 "P" "P" "P", also "park";
        D1 11 "D1" "D1" "D1";
        D2 12 "D2" "D2" "D2";
        D3 13 "D3" "D3" "D3";
        D4 14 "D4" "D4" "D4";
        D5 15 "D5" "D5" "D5";
        D6 16 "D6" "D6" "D6";
    }

    /// What a contactor's contacts do.
    Contactor "contactor" {
        Open 0 "open" "断开" "Open";
        Closed 1 "closed" "闭合" "Closed";
        Welded 2 "welded" "粘连" "Welded", also "stuck";
        Fault 3 "fault" "故障" "Fault", also "faulty";
    }

    /// What a pump or a converter does.
    Run "run" {
        Stopped 0 "stopped" "停止" "Stopped", also "off";
        Running 1 "running" "运行" "Running", also "on";
        Fault 2 "fault" "故障" "Fault", also "faulty";
    }

    /// What charging does.
    #[derive(Default)]
    Charge "charge" {
        #[default]
        Idle 0 "idle" "未充电" "Not charging", also "not_charging";
        Charging 1 "charging" "充电中" "Charging";
        Complete 2 "complete" "充满" "Complete", also "full";
        Fault 3 "fault" "故障" "Fault", also "faulty";
    }

    /// Position of the key.
    #[derive(Default)]
    Key "key" {
        #[default]
        Lock 0 "lock" "锁止" "Lock", also "off" "locked";
        Accessory 1 "acc" "附件" "Accessory";
        On 2 "on" "接通" "On";
        Start 3 "start" "起动" "Start";
    }

    /// Speed of a fan that is on.
    Fan "fan" {
        Low 0 "low" "低" "Low";
        Medium 1 "medium" "中" "Medium";
        High 2 "high" "高" "High";
    }

    /// How the vehicle controller drives.
    Mode "mode" {
        None 0 "none" "无" "None";
        Park 1 "park" "驻车" "Park";
        Drive 2 "drive" "行驶" "Drive";
        Climb 3 "climb" "爬坡" "Climb";
        Snow 4 "snow" "雪地" "Snow";
        Limp 5 "limp" "跛行" "Limp";
    }

    /// How far the battery's check of itself has come.
    Check "check" {
        Unknown 0 "unknown" "未知" "Unknown";
        Precharging 1 "precharging" "预充中" "Precharging";
        Precharged 2 "precharged" "预充完成" "Precharged";
        Calibration 3 "calibration" "校准" "Calibration";
        Fault 4 "fault" "故障" "Fault", also "faulty";
    }

    /// What an inserted plug does.
    Plug "plug" {
        Inserted 0 "inserted" "充电枪已插入" "Plugged in";
        Charging 1 "charging" "正在充电" "Charging";
        Complete 2 "complete" "充电完成" "Charging complete";
        Fault 3 "fault" "充电故障" "Charging failed";
    }

    /// Fault confinement of a CAN controller (ISO 11898-1). Number 0 in a record is a controller that does not answer.
    Confinement "confinement" {
        ErrorActive 1 "error_active" "错误主动" "Error active", also "active";
        Warning 2 "warning" "错误警告" "Error warning";
        ErrorPassive 3 "error_passive" "错误被动" "Error passive", also "passive";
        BusOff 4 "bus_off" "总线关闭" "Bus off", also "off" "bus-off";
    }

    /// Why the firmware started.
    #[derive(Default)]
    ResetReason "reset" {
        #[default]
        Unknown 0 "unknown" "不明" "The chip does not say";
        Power 1 "power" "上电" "Supply or brown-out";
        Pin 2 "pin" "复位引脚" "RUN pin or debugger";
        Watchdog 3 "watchdog" "看门狗" "Watchdog";
        Panic 4 "panic" "程序故障" "Fault of the program";
    }

    /// How a value is missing; see `model::Shown`.
    Missing "missing" {
        Never 0 "never" "从未收到" "Never seen";
        Stale 1 "stale" "中断" "Stale";
        Invalid 2 "invalid" "无效" "Invalid";
    }
}

impl Severity {
    /// Returns the severity of a model value of unit `Unit::Severity`; what no row has is no fault.
    pub const fn from_model(value: i32) -> Self {
        match Self::from_number(value) {
            Some(severity) => severity,
            None => Self::None,
        }
    }
}

impl Gear {
    /// Returns whether the vehicle moves in this gear.
    pub const fn drives(self) -> bool {
        !matches!(self, Self::N | Self::P)
    }
}

impl Confinement {
    /// Word of a controller that does not answer: it is in no state.
    pub const OFFLINE: &str = "offline";
}
