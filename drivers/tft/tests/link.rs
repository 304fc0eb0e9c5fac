//! Windows and commands as they appear on the wires.

use core::cell::RefCell;
use core::convert::Infallible;
use embedded_graphics_core::{prelude::*, primitives::Rectangle};
use embedded_hal::digital::{ErrorType as PinErrorType, OutputPin};
use embedded_hal::spi::{ErrorType, SpiBus};
use std::rc::Rc;
use tft::{Link, Window};

/// What the wires do, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Event {
    Select(bool),
    Command(u8),
    Data(u8),
}

#[derive(Clone, Default)]
struct Wires {
    events: Rc<RefCell<Vec<Event>>>,
    data_mode: Rc<RefCell<bool>>,
    unflushed: Rc<RefCell<bool>>,
}

struct Bus(Wires);
struct ChipSelect(Wires);
struct DataCommand(Wires);

impl ErrorType for Bus {
    type Error = Infallible;
}

impl SpiBus for Bus {
    fn read(&mut self, _: &mut [u8]) -> Result<(), Infallible> {
        panic!("the panel is never read")
    }
    fn write(&mut self, words: &[u8]) -> Result<(), Infallible> {
        let data = *self.0.data_mode.borrow();
        let event = |&byte: &u8| if data { Event::Data(byte) } else { Event::Command(byte) };
        self.0.events.borrow_mut().extend(words.iter().map(event));
        self.0.unflushed.replace(true);
        Ok(())
    }
    fn transfer(&mut self, _: &mut [u8], _: &[u8]) -> Result<(), Infallible> {
        panic!("the panel is never read")
    }
    fn transfer_in_place(&mut self, _: &mut [u8]) -> Result<(), Infallible> {
        panic!("the panel is never read")
    }
    fn flush(&mut self) -> Result<(), Infallible> {
        self.0.unflushed.replace(false);
        Ok(())
    }
}

impl PinErrorType for ChipSelect {
    type Error = Infallible;
}

impl OutputPin for ChipSelect {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.events.borrow_mut().push(Event::Select(true));
        Ok(())
    }
    fn set_high(&mut self) -> Result<(), Infallible> {
        assert!(!*self.0.unflushed.borrow(), "deselected while bytes are on their way");
        self.0.events.borrow_mut().push(Event::Select(false));
        Ok(())
    }
}

impl PinErrorType for DataCommand {
    type Error = Infallible;
}

impl OutputPin for DataCommand {
    fn set_low(&mut self) -> Result<(), Infallible> {
        assert!(!*self.0.unflushed.borrow(), "DC changed while bytes are on their way");
        self.0.data_mode.replace(false);
        Ok(())
    }
    fn set_high(&mut self) -> Result<(), Infallible> {
        assert!(!*self.0.unflushed.borrow(), "DC changed while bytes are on their way");
        self.0.data_mode.replace(true);
        Ok(())
    }
}

fn link() -> (Wires, Link<Bus, ChipSelect, DataCommand>) {
    let wires = Wires::default();
    let link = Link::new(Bus(wires.clone()), ChipSelect(wires.clone()), DataCommand(wires.clone())).unwrap();
    wires.events.borrow_mut().clear();
    (wires, link)
}

#[test]
fn a_window_is_three_commands_and_leaves_the_panel_selected_in_data_mode() {
    use Event::{Command, Data, Select};
    let (wires, mut link) = link();
    link.open(Window::new(16, 200, 300, 40).unwrap()).unwrap();
    link.bus().write(&[0xF8, 0x00]).unwrap();
    link.bus().flush().unwrap();
    link.close().unwrap();
    assert_eq!(
        *wires.events.borrow(),
        [
            Select(true),
            Command(0x2A),
            Data(0),
            Data(16),
            Data(1),
            Data(59),
            Command(0x2B),
            Data(0),
            Data(200),
            Data(0),
            Data(239),
            Command(0x2C),
            Data(0xF8),
            Data(0x00),
            Select(false),
        ]
    );
}

#[test]
fn a_command_has_a_chip_select_of_its_own() {
    use Event::{Command, Data, Select};
    let (wires, mut link) = link();
    link.command(0x36, &[0x28]).unwrap();
    link.command(0x11, &[]).unwrap();
    assert_eq!(
        *wires.events.borrow(),
        [Select(true), Command(0x36), Data(0x28), Select(false), Select(true), Command(0x11), Select(false)]
    );
}

#[test]
fn windows_outside_the_picture_do_not_exist() {
    for (x, y, width, height) in
        [(0, 0, 321, 1), (319, 0, 2, 1), (0, 239, 1, 2), (0, 0, 0, 5), (65_535, 0, 2, 1)]
    {
        assert_eq!(Window::new(x, y, width, height), None);
    }
    assert_eq!(Window::new(319, 239, 1, 1).map(Window::pixels), Some(1));
    let area =
        |x, y, width, height| Window::try_from(Rectangle::new(Point::new(x, y), Size::new(width, height)));
    assert!(area(0, 0, 320, 240).is_ok());
    assert!(area(-1, 0, 10, 10).is_err());
    assert!(area(0, 0, 70_000, 1).is_err());
}
