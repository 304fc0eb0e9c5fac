//! From reset to picture: the plan of steps that the caller walks.
//!
//! The models of `mipidsi` wait 265 ms (ILI9341) and 300 ms (ST7789), for the worst history a panel can have. The plan
//! keeps their commands and their short waits, and replaces the long ones by the two rules of the datasheets: after a
//! reset, commands from 5 ms on, sleep-out from 5 ms on if the panel was asleep and from 120 ms on if it was awake;
//! after sleep-out, commands from 5 ms on, a steady picture from 120 ms on. Memory can be written meanwhile, so the
//! first picture is painted during the last wait and the display switched on when both are done.
//!
//! Source: ILI9341 datasheet V1.11 sections 8.2.12 (sleep out), 15.4 (reset timing); ST7789VW datasheet V1.0 sections
//! 7.4.5 (reset timing), 9.1.12 (sleep out).

use crate::script::{Command, Line, Script};

/// What the panel did before its reset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// Its supply has just come up: it sleeps.
    Cold,
    /// It may have been awake: only the firmware has been started anew.
    Warm,
}

/// One step of the plan, to be done before the next one is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Drive the reset pin to this level.
    Reset(bool),
    /// Send a command.
    Send(Command),
    /// Wait, in microseconds from the end of the last command or wait.
    Wait(u32),
    /// Paint the whole picture, and wait until this much time has passed since the end of the wait before.
    Paint {
        /// In microseconds.
        at_least_us: u32,
    },
}

/// Reset pulse; 10 us are enough, shorter than 5 us is taken for a spike.
const RESET_PULSE_US: u32 = 20;
/// From the end of the reset, or from sleep-out, to the next command.
const SETTLE_US: u32 = 5_000;
/// From the end of the reset of a panel that was awake to sleep-out, and from sleep-out to a steady picture.
const WAKE_US: u32 = 120_000;
/// Waits of the models up to here are theirs to know; longer ones are the two waits that the rules replace.
const MODEL_WAIT_LIMIT_US: u32 = 10_000;

const SLEEP_OUT: u8 = 0x11;
const DISPLAY_ON: u8 = 0x29;

/// Walks a [`Script`]; ends after the display is on.
#[derive(Clone, Debug)]
pub struct StartUp {
    script: Script,
    line: usize,
    start: Start,
    stage: Stage,
    /// Waited since the last event that a rule counts from.
    waited_us: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    Begin,
    Pulse,
    Release,
    Settle,
    Asleep,
    Awake,
    Painted,
    Over,
}

impl StartUp {
    /// Returns the plan of a script. The reset pin must be high or the supply have come up just now.
    pub const fn new(script: Script, start: Start) -> Self {
        Self { script, line: 0, start, stage: Stage::Begin, waited_us: 0 }
    }

    fn wait(&mut self, us: u32) -> Option<Step> {
        self.waited_us += us;
        Some(Step::Wait(us))
    }
}

impl Iterator for StartUp {
    type Item = Step;

    fn next(&mut self) -> Option<Step> {
        match self.stage {
            Stage::Begin => {
                self.stage = Stage::Pulse;
                return Some(Step::Reset(false));
            }
            Stage::Pulse => {
                self.stage = Stage::Release;
                return Some(Step::Wait(RESET_PULSE_US));
            }
            Stage::Release => {
                self.stage = Stage::Settle;
                return Some(Step::Reset(true));
            }
            Stage::Settle => {
                self.stage = Stage::Asleep;
                return self.wait(SETTLE_US);
            }
            Stage::Over => return None,
            Stage::Asleep | Stage::Awake | Stage::Painted => {}
        }
        // One line of the script at most; a wait that a rule replaces is skipped.
        while let Some(&line) = self.script.lines().get(self.line) {
            match line {
                Line::Wait(us) if us > MODEL_WAIT_LIMIT_US || self.line == 0 => self.line += 1,
                Line::Wait(us) => {
                    self.line += 1;
                    return self.wait(us);
                }
                Line::Send(command) if command.code() == SLEEP_OUT => {
                    let needed_us = if self.start == Start::Warm { WAKE_US } else { SETTLE_US };
                    if self.waited_us < needed_us {
                        return self.wait(needed_us - self.waited_us);
                    }
                    self.line += 1;
                    self.stage = Stage::Awake;
                    self.waited_us = 0;
                    return Some(Step::Send(command));
                }
                Line::Send(_) if self.stage == Stage::Awake && self.waited_us < SETTLE_US => {
                    return self.wait(SETTLE_US - self.waited_us);
                }
                Line::Send(command) if command.code() == DISPLAY_ON && self.stage == Stage::Awake => {
                    self.stage = Stage::Painted;
                    return Some(Step::Paint { at_least_us: WAKE_US.saturating_sub(self.waited_us) });
                }
                Line::Send(command) => {
                    self.line += 1;
                    // What a model waits after switching on is for drawing that has already been done here.
                    if command.code() == DISPLAY_ON {
                        self.stage = Stage::Over;
                    }
                    return Some(Step::Send(command));
                }
            }
        }
        self.stage = Stage::Over;
        None
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use crate::Panel;
    use std::vec::Vec;

    fn plan(panel: Panel, start: Start) -> Vec<Step> {
        StartUp::new(panel.script().unwrap(), start).collect()
    }

    fn send(code: u8, params: &[u8]) -> Step {
        Step::Send(Command::new(code, params).unwrap())
    }

    #[test]
    fn a_cold_ili9341_paints_5_ms_after_sleep_out_and_shows_after_120() {
        assert_eq!(
            plan(Panel::Ili9341, Start::Cold),
            [
                Step::Reset(false),
                Step::Wait(20),
                Step::Reset(true),
                Step::Wait(5_000),
                send(0x36, &[0x28]),
                send(0xB4, &[0x00]),
                send(0x20, &[]),
                send(0x3A, &[0x55]),
                send(0x13, &[]),
                send(0x11, &[]),
                Step::Wait(5_000),
                Step::Paint { at_least_us: 115_000 },
                send(0x29, &[]),
            ]
        );
    }

    #[test]
    fn a_cold_st7789_is_landscape_rgb_and_inverted() {
        let plan = plan(Panel::St7789, Start::Cold);
        for step in [send(0x36, &[0x60]), send(0x21, &[]), send(0x3A, &[0x55])] {
            assert!(plan.contains(&step), "{step:?} is not in {plan:?}");
        }
    }

    fn time_of(plan: &[Step], wanted: Step) -> u32 {
        let end = plan.iter().position(|step| *step == wanted).unwrap();
        plan[..end]
            .iter()
            .map(|step| match step {
                Step::Wait(us) | Step::Paint { at_least_us: us } => *us,
                _ => 0,
            })
            .sum()
    }

    // The limits as the datasheets print them, in microseconds.
    #[test]
    fn every_panel_keeps_the_datasheets_waits_after_either_start() {
        for panel in [Panel::Ili9341, Panel::St7789] {
            for (start, reset_to_sleep_out) in [(Start::Cold, 5_000), (Start::Warm, 120_000)] {
                let plan = plan(panel, start);
                let released = time_of(&plan, Step::Reset(true));
                let sleep_out = time_of(&plan, send(0x11, &[]));
                let display_on = time_of(&plan, send(0x29, &[]));
                assert!(released >= 10);
                assert!(sleep_out - released >= reset_to_sleep_out, "{panel:?} {start:?}");
                assert!(display_on - sleep_out >= 120_000, "{panel:?} {start:?}");
                let after = plan.iter().position(|step| *step == send(0x11, &[])).unwrap() + 1;
                assert!(matches!(plan[after], Step::Wait(us) if us >= 5_000), "{panel:?} {start:?}");
                assert_eq!(plan.last(), Some(&send(0x29, &[])));
                assert_eq!(plan.iter().filter(|step| matches!(step, Step::Paint { .. })).count(), 1);
            }
        }
    }

    #[test]
    fn a_cold_start_shows_a_picture_within_the_target_of_150_ms() {
        for panel in [Panel::Ili9341, Panel::St7789] {
            assert!(time_of(&plan(panel, Start::Cold), send(0x29, &[])) <= 130_000);
        }
    }
}
