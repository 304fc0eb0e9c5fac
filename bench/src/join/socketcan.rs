//! Linux's own CAN interfaces: `can0` of an adapter, `vcan0` between programs.
//!
//! Raw frames over SocketCAN; bit rate and state of the interface are set with `ip link` and not from here. Error frames
//! are skipped. Source: Linux, Documentation/networking/can.rst. Not supported: CAN FD frames.

use super::adapter::Adapter;
use crate::can::{Frame, Id};
use socketcan::{CanFrame, CanSocket, EmbeddedFrame, Frame as _, Socket};
use std::io;
use std::path::Path;

/// errno of a socket family that the kernel does not have.
const EAFNOSUPPORT: i32 = 97;
/// errno of an interface that is down.
const ENETDOWN: i32 = 100;
/// errno of a transmit queue that is full.
const ENOBUFS: i32 = 105;
/// Error frames that are skipped before the next look.
const SKIP_MAX: usize = 64;

/// An open SocketCAN interface.
pub struct SocketCan {
    socket: CanSocket,
    interface: String,
}

impl SocketCan {
    /// Opens an interface that is there and up.
    ///
    /// # Errors
    /// If there is no such interface or the kernel has no CAN; the error says what to type.
    pub fn open(interface: &str) -> io::Result<Self> {
        let named = !interface.is_empty() && !interface.contains('/');
        if !named || !Path::new("/sys/class/net").join(interface).exists() {
            return Err(io::Error::new(io::ErrorKind::NotFound, missing(interface)));
        }
        let socket = CanSocket::open(interface).map_err(|error| explained(interface, error))?;
        socket.set_nonblocking(true)?;
        Ok(Self { socket, interface: interface.to_owned() })
    }
}

fn missing(interface: &str) -> String {
    format!(
        "no interface `{interface}`. A virtual one: `sudo modprobe vcan; sudo ip link add dev {interface} type vcan; \
         sudo ip link set {interface} up`. An adapter: `sudo ip link set {interface} up type can bitrate 250000`"
    )
}

fn explained(interface: &str, error: io::Error) -> io::Error {
    let problem = match error.raw_os_error() {
        Some(EAFNOSUPPORT) => {
            "this kernel has no CAN: `sudo modprobe can-raw`, or a kernel with CONFIG_CAN and CONFIG_CAN_RAW"
                .into()
        }
        Some(ENETDOWN) => format!("{interface} is down: `sudo ip link set {interface} up`"),
        _ => format!("{interface}: {error}"),
    };
    io::Error::new(error.kind(), problem)
}

impl Adapter for SocketCan {
    fn send(&mut self, frame: &Frame) -> io::Result<bool> {
        let Some(frame) = to_kernel(frame) else { return Ok(true) };
        match self.socket.write_frame(&frame) {
            Ok(()) => Ok(true),
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => Ok(false),
            Err(error) if error.raw_os_error() == Some(ENOBUFS) => Ok(false),
            Err(error) => Err(explained(&self.interface, error)),
        }
    }

    fn receive(&mut self) -> io::Result<Option<Frame>> {
        for _ in 0..SKIP_MAX {
            match self.socket.read_frame() {
                Ok(frame) => {
                    if let Some(frame) = from_kernel(&frame) {
                        return Ok(Some(frame));
                    }
                }
                Err(error) if error.kind() == io::ErrorKind::WouldBlock => return Ok(None),
                Err(error) => return Err(explained(&self.interface, error)),
            }
        }
        Ok(None)
    }
}

fn to_kernel(frame: &Frame) -> Option<CanFrame> {
    let id: socketcan::Id = match frame.id {
        Id::Standard(id) => socketcan::StandardId::new(id.raw())?.into(),
        Id::Extended(id) => socketcan::ExtendedId::new(id.raw())?.into(),
    };
    if frame.remote {
        CanFrame::new_remote(id, usize::from(frame.dlc.min(8)))
    } else {
        CanFrame::new(id, frame.payload())
    }
}

fn from_kernel(frame: &CanFrame) -> Option<Frame> {
    if matches!(frame, CanFrame::Error(_)) {
        return None;
    }
    let id = if frame.is_extended() {
        Id::extended(frame.raw_id())
    } else {
        Id::standard(u16::try_from(frame.raw_id()).ok()?)
    }?;
    if frame.is_remote_frame() {
        return Some(Frame::new_remote(id, u8::try_from(frame.dlc()).ok()?));
    }
    Frame::new(id, frame.data())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_come_back_from_the_kernels_form() {
        let frames = [
            Frame::new(Id::standard(0x7FF).unwrap(), &[]).unwrap(),
            Frame::new(Id::standard(0).unwrap(), &[1, 2, 3]).unwrap(),
            Frame::new(Id::extended(0x1FFF_FFFF).unwrap(), &[8; 8]).unwrap(),
            Frame::new(Id::extended(0x12).unwrap(), &[9]).unwrap(),
            Frame::new_remote(Id::extended(0x18FE_F100).unwrap(), 8),
            Frame::new_remote(Id::standard(5).unwrap(), 0),
        ];
        for frame in frames {
            assert_eq!(from_kernel(&to_kernel(&frame).unwrap()), Some(frame));
        }
    }

    #[test]
    fn an_interface_that_is_missing_is_named_with_what_to_type() {
        for interface in ["nocan77", "", "../eth0"] {
            let Err(error) = SocketCan::open(interface) else { panic!("{interface} was opened") };
            assert!(error.to_string().contains("ip link add dev"), "{error}");
        }
    }

    #[test]
    fn frames_cross_a_virtual_interface() {
        let (Ok(mut here), Ok(mut there)) = (SocketCan::open("vcan0"), SocketCan::open("vcan0")) else {
            return surroundings::need::VCAN.skip("frames over a virtual interface");
        };
        let frame = Frame::new(Id::extended(0x18FE_F1F0).unwrap(), &[1, 2, 3]).unwrap();
        assert!(here.send(&frame).unwrap());
        assert!((0..1_000).any(|_| there.receive().unwrap() == Some(frame)), "vcan0 is there but mute");
        assert_eq!(here.receive().unwrap(), None, "own frames are not heard");
    }
}
