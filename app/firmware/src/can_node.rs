//! The CAN node: an MCP2515 that works, or one that does not answer and is tried again.
//!
//! The screen comes up without it; a module that is plugged in later is found within a second.

use cluster::Access;
use mcp2515_can::driver::Verdict;
use mcp2515_can::{Config, Health, Mcp2515, Mode, Refusals, Refused, TransmitError};
use pico::can_port::SpiStuck;
use pico::{CanInt, CanSpi, Delay};
use protocol_core::CanFrame;

use crate::config;

const fn mode(access: Access) -> Mode {
    if access.may_send && !config::LISTEN_ONLY { Mode::Normal } else { Mode::ListenOnly }
}

const fn settings(access: Access) -> Config {
    Config {
        oscillator: pico::facts::CAN_OSCILLATOR,
        bitrate: access.bitrate,
        mode: mode(access),
        // Every frame comes in: the bus of one vehicle is a few per cent of what the service manages.
        acceptance: None,
    }
}

/// Time between two attempts to start the controller, in milliseconds.
const RETRY_MS: u64 = 1_000;

type Driver = Mcp2515<CanSpi, CanInt>;

enum Chip {
    Running(Driver),
    /// Not tried yet, or refused.
    Down(CanSpi, CanInt),
    /// An [`Attempt`] has the parts.
    Away,
}

/// The parts of the controller on their way through a start, which takes up to 5 ms: long enough to be done without
/// the lock that keeps the interrupt out.
pub enum Attempt {
    /// Start a controller that has not answered yet.
    Start(CanSpi, CanInt, Access),
    /// Start one anew that has gone astray, or that is to listen at another bit rate.
    Restart(Driver, Access),
}

impl Attempt {
    /// Starts the controller.
    pub fn run(self) -> Outcome {
        let started = match self {
            Self::Start(spi, int, access) => Mcp2515::new(spi, int, settings(access), &mut Delay),
            Self::Restart(mut driver, access) => match driver.reconfigure(settings(access), &mut Delay) {
                Ok(()) => Ok(driver),
                Err(error) => {
                    let (spi, int) = driver.free();
                    Err(Refused { error, spi, int })
                }
            },
        };
        Outcome(started)
    }
}

/// What became of an [`Attempt`].
pub struct Outcome(Result<Driver, Refused<CanSpi, CanInt>>);

/// What a look at the controller asks for.
pub enum Care {
    /// Nothing to do now.
    Nothing,
    /// A frame waits although INT is high: serve the interrupt by hand.
    Poll,
    /// Run this and hand its outcome to [`CanNode::finish`].
    Attempt(Attempt),
}

/// Fault confinement, counters and last error of the CAN node.
#[derive(Clone, Copy, Debug)]
pub struct Status {
    /// The controller's counters, `None` while it does not answer.
    pub controller: Option<Health>,
    /// Frames lost because the queue to the tick was full.
    pub queue_overflows: u32,
    /// SPI transactions that failed while the controller ran.
    pub spi_errors: u32,
    /// Start-ups that were refused, by reason.
    pub refusals: Refusals,
}

/// The CAN node of the cluster.
pub struct CanNode {
    chip: Chip,
    access: Access,
    /// Next attempt to start or restart the controller, in milliseconds since start.
    retry_ms: u64,
    queue_overflows: u32,
    spi_errors: u32,
    refusals: Refusals,
}

impl CanNode {
    /// Returns a node whose controller is started by the first [`Self::supervise`], to take part like this.
    pub const fn new(spi: CanSpi, int: CanInt, access: Access) -> Self {
        Self {
            chip: Chip::Down(spi, int),
            access,
            retry_ms: 0,
            queue_overflows: 0,
            spi_errors: 0,
            refusals: Refusals::NONE,
        }
    }

    /// Takes all frames out of the controller; masks INT if it stays low.
    #[inline(always)]
    pub fn service(&mut self, mut sink: impl FnMut(CanFrame) -> bool) {
        let Chip::Running(chip) = &mut self.chip else { return };
        let mut overflows = 0;
        let serviced = chip.service(|frame| overflows += u32::from(!sink(frame)));
        self.queue_overflows = self.queue_overflows.saturating_add(overflows);
        match serviced {
            Ok(serviced) if serviced.drained => {}
            Ok(_) => chip.int().mask(),
            Err(SpiStuck) => {
                self.spi_errors = self.spi_errors.saturating_add(1);
                chip.int().mask();
            }
        }
    }

    /// Lets INT interrupt again, in case a service has masked it; for every tick.
    pub fn arm(&mut self) {
        if let Chip::Running(chip) = &mut self.chip {
            chip.int().arm();
        }
    }

    /// Takes a frame for transmission; `false` = try again at the next tick.
    pub fn transmit(&mut self, frame: &CanFrame, now_ms: u64) -> bool {
        match &mut self.chip {
            // What may not go out now, as after bus-off, would be stale when it may.
            Chip::Running(chip) => !matches!(chip.transmit(frame, now_ms), Err(TransmitError::Busy)),
            // Nobody would hear it, now or later.
            Chip::Down(..) | Chip::Away => true,
        }
    }

    /// Looks after the controller; for every 100 ms.
    pub fn supervise(&mut self, now_ms: u64) -> Care {
        let astray = match &mut self.chip {
            Chip::Running(chip) => match chip.supervise(now_ms) {
                Ok(Verdict::Well) => return Care::Nothing,
                Ok(Verdict::FrameWaiting) => return Care::Poll,
                Ok(Verdict::Restart) => true,
                Err(SpiStuck) => {
                    self.spi_errors = self.spi_errors.saturating_add(1);
                    true
                }
            },
            Chip::Down(..) => true,
            Chip::Away => false,
        };
        if !astray || now_ms < self.retry_ms {
            return Care::Nothing;
        }
        self.retry_ms = now_ms + RETRY_MS;
        self.start_anew()
    }

    fn start_anew(&mut self) -> Care {
        match core::mem::replace(&mut self.chip, Chip::Away) {
            Chip::Running(mut chip) => {
                // Nobody would answer a low level while the parts are away.
                chip.int().mask();
                Care::Attempt(Attempt::Restart(chip, self.access))
            }
            Chip::Down(spi, int) => Care::Attempt(Attempt::Start(spi, int, self.access)),
            Chip::Away => Care::Nothing,
        }
    }

    /// Takes part in the bus like this from now on; not right before [`Self::supervise`].
    pub fn follow(&mut self, access: Access) -> Care {
        let before = core::mem::replace(&mut self.access, access);
        let Chip::Running(chip) = &mut self.chip else { return Care::Nothing };
        if before.bitrate != access.bitrate {
            return self.start_anew();
        }
        if before.may_send != access.may_send && chip.change_mode(mode(access)).is_err() {
            self.spi_errors = self.spi_errors.saturating_add(1);
        }
        Care::Nothing
    }

    /// Returns whether a frame with an error was on the bus since the last call.
    pub fn take_message_error(&mut self) -> bool {
        let Chip::Running(chip) = &mut self.chip else { return false };
        chip.take_message_error().unwrap_or_else(|SpiStuck| {
            self.spi_errors = self.spi_errors.saturating_add(1);
            false
        })
    }

    /// Takes the outcome of an attempt.
    pub fn finish(&mut self, Outcome(outcome): Outcome) {
        self.chip = match outcome {
            Ok(mut chip) => {
                chip.int().arm();
                Chip::Running(chip)
            }
            Err(refused) => {
                self.refusals.note(&refused.error);
                Chip::Down(refused.spi, refused.int)
            }
        };
    }

    /// Returns how the node is.
    pub fn status(&self) -> Status {
        let controller = match &self.chip {
            Chip::Running(chip) => Some(chip.health()),
            Chip::Down(..) | Chip::Away => None,
        };
        let Self { queue_overflows, spi_errors, refusals, .. } = *self;
        Status { controller, queue_overflows, spi_errors, refusals }
    }
}
