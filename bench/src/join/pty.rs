//! Serial lines: the pseudo-terminal that other programs open, and the port of a real adapter.
//!
//! Raw bytes, nothing waits. A pseudo-terminal outlives its clients: one may close it and the next one open the same
//! path and find it empty and raw. Source: Linux pty(7): the master of a terminal that nobody has open reports a
//! hang-up, which ends with the next open.
//! Not supported: hardware flow control; a pseudo-terminal has none, and USB adapters do without.

use super::wire::Wire;
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::{Mode, OFlags, fcntl_getfl, fcntl_setfl};
use rustix::io::{Errno, FdFlags, fcntl_setfd};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{ControlModes, OptionalActions, QueueSelector, tcflush, tcgetattr, tcsetattr};
use std::ffi::OsString;
use std::io;
use std::os::fd::{AsFd, OwnedFd};
use std::os::unix::ffi::OsStringExt as _;
use std::path::{Path, PathBuf};

/// A pseudo-terminal whose other end is a path for other programs.
pub struct Pty {
    master: OwnedFd,
    path: PathBuf,
    /// A client has been seen: the next one must not find what was meant for this one.
    used: bool,
}

impl Pty {
    /// Makes a pseudo-terminal in raw mode.
    ///
    /// # Errors
    /// If the system has none left or no `/dev/pts`.
    pub fn open() -> io::Result<Self> {
        let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY)?;
        // A program that is started from here must not hold the terminal open.
        fcntl_setfd(&master, FdFlags::CLOEXEC)?;
        grantpt(&master)?;
        unlockpt(&master)?;
        fcntl_setfl(&master, fcntl_getfl(&master)? | OFlags::NONBLOCK)?;
        let path = OsString::from_vec(ptsname(&master, Vec::new())?.into_bytes()).into();
        let pty = Self { master, path, used: false };
        pty.clean()?;
        Ok(pty)
    }

    /// The path that other programs open, `/dev/pts/N`.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Makes the terminal raw and throws away what nobody has read. Opening and closing it here also makes the master
    /// report a hang-up until a client comes.
    fn clean(&self) -> io::Result<()> {
        make_raw(&open_terminal(&self.path)?, None)
    }
}

impl Wire for Pty {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        match rustix::io::read(&self.master, into) {
            Ok(count) => Ok(count),
            // EIO is the hang-up: everything that was written before it has been read.
            Err(Errno::AGAIN | Errno::INTR | Errno::IO) => Ok(0),
            Err(error) => Err(error.into()),
        }
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        written(rustix::io::write(&self.master, bytes))
    }

    fn is_connected(&mut self) -> io::Result<bool> {
        let mut polled = [PollFd::new(&self.master, PollFlags::empty())];
        poll(&mut polled, Some(&Timespec { tv_sec: 0, tv_nsec: 0 }))?;
        let connected = !polled[0].revents().contains(PollFlags::HUP);
        if !connected && self.used {
            self.clean()?;
        }
        self.used = connected;
        Ok(connected)
    }
}

/// The serial port of a real adapter.
pub struct SerialPort {
    port: OwnedFd,
    path: PathBuf,
}

impl SerialPort {
    /// Opens a serial port raw, with `speed` baud; adapters on USB ignore the speed.
    ///
    /// # Errors
    /// If it is missing, not a serial port, or another user's; the error names the path.
    pub fn open(path: &Path, speed: u32) -> io::Result<Self> {
        let named = |error: io::Error| {
            let hint = match error.kind() {
                _ if error.raw_os_error() == Some(Errno::NOTTY.raw_os_error()) => "; it is not a serial port",
                io::ErrorKind::NotFound => "; is the adapter plugged in? `ls /dev/ttyACM* /dev/ttyUSB*`",
                io::ErrorKind::PermissionDenied => {
                    "; add yourself to the port's group: `sudo usermod -aG dialout $USER`"
                }
                _ => "",
            };
            io::Error::new(error.kind(), format!("cannot open {}: {error}{hint}", path.display()))
        };
        let port = open_terminal(path).map_err(named)?;
        make_raw(&port, Some(speed)).map_err(named)?;
        Ok(Self { port, path: path.to_owned() })
    }

    fn gone(&self, error: &str) -> io::Error {
        io::Error::new(io::ErrorKind::NotConnected, format!("{} is gone: {error}", self.path.display()))
    }
}

impl Wire for SerialPort {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        match rustix::io::read(&self.port, into) {
            Ok(0) => Err(self.gone("hung up")),
            Ok(count) => Ok(count),
            Err(Errno::AGAIN | Errno::INTR) => Ok(0),
            Err(error) => Err(self.gone(&error.to_string())),
        }
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        written(rustix::io::write(&self.port, bytes)).map_err(|error| self.gone(&error.to_string()))
    }

    fn is_connected(&mut self) -> io::Result<bool> {
        Ok(true)
    }
}

fn written(result: Result<usize, Errno>) -> io::Result<usize> {
    match result {
        Ok(count) => Ok(count),
        Err(Errno::AGAIN | Errno::INTR) => Ok(0),
        Err(error) => Err(error.into()),
    }
}

pub(super) fn open_terminal(path: &Path) -> io::Result<OwnedFd> {
    let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::NONBLOCK | OFlags::CLOEXEC;
    Ok(rustix::fs::open(path, flags, Mode::empty())?)
}

/// Raw mode, no modem lines, both queues empty.
fn make_raw(terminal: impl AsFd, speed: Option<u32>) -> io::Result<()> {
    let mut settings = tcgetattr(&terminal)?;
    settings.make_raw();
    settings.control_modes |= ControlModes::CLOCAL | ControlModes::CREAD;
    settings.control_modes -= ControlModes::CRTSCTS;
    if let Some(speed) = speed {
        settings.set_speed(speed)?;
    }
    tcsetattr(&terminal, OptionalActions::Now, &settings)?;
    tcflush(&terminal, QueueSelector::IOFlush)?;
    Ok(())
}
