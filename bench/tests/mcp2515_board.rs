//! The wired board: pins and SPI frames in, INT and MISO out.

use bench::can::{EventKind, Frame, Id, LoadGenerator, Tag};
use bench::chips::bench_board::{BenchBoard, CanWiring, PanelWiring, Wiring};
use bench::chips::{mcp2515, panel};
use bench::pins::{Board, InputPins};
use bench::time::Nanos;

const CAN_CS: u8 = 17;
const CAN_INT: u8 = 20;
const TFT_CS: u8 = 13;
const TFT_DC: u8 = 14;
const TFT_RESET: u8 = 15;
const BACKLIGHT: u8 = 12;
const BUZZER: u8 = 22;

fn wiring() -> Wiring {
    Wiring {
        can: CanWiring { spi: 0, cs: CAN_CS, int: CAN_INT },
        panel: PanelWiring {
            spi: 1,
            cs: TFT_CS,
            dc: TFT_DC,
            reset: Some(TFT_RESET),
            backlight: Some(BACKLIGHT),
        },
        buzzer: Some(BUZZER),
        buttons: vec![6, 7],
        uart: 0,
    }
}

struct Rig {
    board: BenchBoard,
    inputs: InputPins,
    now: Nanos,
}

impl Rig {
    fn new() -> Self {
        let board = BenchBoard::new(wiring(), 250_000, mcp2515::Config::default(), panel::Config::ILI9341);
        let mut rig = Self { board, inputs: InputPins::default(), now: Nanos::ZERO };
        for pin in [CAN_CS, TFT_CS, TFT_RESET] {
            rig.pin(pin, true);
        }
        rig.wait(Nanos::from_millis(6));
        rig
    }

    fn pin(&mut self, pin: u8, level: bool) {
        self.board.pin_out(self.now, pin, level, &mut self.inputs);
    }

    fn level(&self, pin: u8) -> bool {
        assert!(self.inputs.driven() >> pin & 1 == 1, "pin {pin} is driven");
        self.inputs.levels() >> pin & 1 == 1
    }

    fn wait(&mut self, span: Nanos) {
        self.now += span;
        self.board.advance(self.now, &mut self.inputs);
    }

    fn can(&mut self, bytes: &[u8]) -> Vec<u8> {
        self.wait(Nanos(100));
        self.pin(CAN_CS, false);
        let replies = bytes.iter().map(|&byte| self.spi(0, u16::from(byte), 8) as u8).collect();
        self.pin(CAN_CS, true);
        replies
    }

    fn spi(&mut self, port: u8, word: u16, bits: u8) -> u16 {
        self.now += Nanos(u64::from(bits) * 112); // 125 MHz / 14
        self.board.spi_frame(self.now, port, word, bits, &mut self.inputs)
    }

    fn start_can(&mut self) {
        self.can(&[0x02, 0x28, 0x01, 0xBC, 0x01, 0x03]); // CNF3..1, RX0IE and RX1IE
        self.can(&[0x02, 0x60, 0x64]);
        self.can(&[0x02, 0x0F, 0x07]);
        self.wait(Nanos::from_millis(1));
    }

    fn tft(&mut self, command: u8, parameters: &[u8]) {
        self.pin(TFT_CS, false);
        self.pin(TFT_DC, false);
        self.spi(1, u16::from(command), 8);
        self.pin(TFT_DC, true);
        for &byte in parameters {
            self.spi(1, u16::from(byte), 8);
        }
        self.pin(TFT_CS, true);
    }
}

fn frame(n: u8) -> Frame {
    Frame::new(Id::extended(0x18FE_F100).unwrap(), &[n; 8]).unwrap()
}

#[test]
fn a_frame_from_a_peer_pulls_the_int_pin_at_its_receive_point() {
    let mut rig = Rig::new();
    rig.start_can();
    assert!(rig.level(CAN_INT));
    let peer = rig.board.bus_mut().attach("peer");
    let start = rig.now;
    rig.board.bus_mut().request(peer, start, frame(7), Tag(0));
    rig.wait(Nanos::from_millis(1));
    assert!(!rig.level(CAN_INT));
    let received = bench::can::bits::FrameBits::of(&frame(7)).received();
    assert_eq!(rig.board.int_edges().last(), Some(&(start + rig.board.bus().span(received), false)));
    let bytes = rig.can(&[0x90, 0, 0, 0, 0, 0, 0]);
    assert_eq!(bytes[5..], [8, 7]);
    assert!(rig.level(CAN_INT));
    assert!(rig.board.mcp2515().violations().is_empty(), "{}", rig.board.mcp2515().violations());
}

#[test]
fn the_board_names_the_next_bus_event_and_participants_keep_the_bus_busy() {
    let mut rig = Rig::new();
    rig.start_can();
    assert_eq!(rig.board.next_event(), None, "an idle bus has nothing to do");
    let load = rig.board.bus_mut().attach("load");
    rig.board.join(LoadGenerator::sequenced(load, Id::extended(0x1555_5555).unwrap()).limited_to(100));
    let mut calls = 0;
    while let Some(next) = rig.board.next_event() {
        assert!(next >= rig.now);
        rig.now = next;
        rig.board.advance(next, &mut rig.inputs);
        calls += 1;
        assert!(calls < 1_000, "time does not stand still");
    }
    assert_eq!(rig.board.mcp2515().counters().frames_seen, 100);
    assert_eq!(rig.board.bus().stats().frames, 100);
}

#[test]
fn sixteen_bit_spi_words_reach_the_can_controller_high_byte_first() {
    let mut rig = Rig::new();
    rig.wait(Nanos(100));
    rig.pin(CAN_CS, false);
    rig.spi(0, 0x030F, 16);
    let reply = rig.spi(0, 0, 16);
    rig.pin(CAN_CS, true);
    assert_eq!(reply >> 8, 0x87, "CANCTRL");
    assert!(rig.board.mcp2515().violations().is_empty(), "{}", rig.board.mcp2515().violations());
}

#[test]
fn the_panel_is_drawn_through_its_pins() {
    let mut rig = Rig::new();
    rig.tft(0x11, &[]);
    rig.wait(Nanos::from_millis(120));
    rig.tft(0x3A, &[0x55]);
    rig.tft(0x36, &[0x28]);
    rig.tft(0x29, &[]);
    rig.tft(0x2A, &[0, 0, 0, 0]);
    rig.tft(0x2B, &[0, 0, 0, 0]);
    rig.tft(0x2C, &[0x07, 0xE0]);
    assert_eq!(rig.board.panel().visible(rig.now), None, "no back-light yet");
    rig.board.pwm(rig.now, BACKLIGHT, 1_000, 32_768);
    let picture = rig.board.panel().visible(rig.now).expect("lit");
    assert_eq!(picture.pixel(0, 0), Some([0, 255, 0]));
    assert!(rig.board.panel().violations().is_empty(), "{}", rig.board.panel().violations());
    rig.pin(TFT_RESET, false);
    assert_eq!(rig.board.panel().visible(rig.now), None);
}

#[test]
fn buttons_pull_their_pins_low_when_their_time_comes() {
    let mut rig = Rig::new();
    assert!(rig.level(6) && rig.level(7));
    let press = rig.now + Nanos::from_millis(10);
    rig.board.press(press, 1, true);
    rig.board.press(press + Nanos::from_millis(50), 1, false);
    assert_eq!(rig.board.next_event(), Some(press));
    rig.wait(Nanos::from_millis(10));
    assert!(rig.level(6) && !rig.level(7));
    rig.wait(Nanos::from_millis(50));
    assert!(rig.level(7));
}

#[test]
fn uart_bytes_and_pwm_changes_are_logged_with_their_times() {
    let mut rig = Rig::new();
    rig.board.uart_byte(Nanos(7_000_000), 0, b'A');
    rig.board.uart_byte(Nanos(7_100_000), 1, b'B');
    assert_eq!(rig.board.uart(), [(Nanos(7_000_000), b'A')], "only the wired port");
    rig.board.pwm(rig.now, BUZZER, 2_400, 32_768);
    rig.board.pwm(rig.now, BUZZER, 2_400, 0);
    rig.board.pwm(rig.now, 3, 1, 1);
    let duties: Vec<u32> = rig.board.buzzer().iter().map(|change| change.duty).collect();
    assert_eq!(duties, [32_768, 0]);
}

#[test]
fn a_frame_goes_out_from_the_pins_to_a_peer() {
    let mut rig = Rig::new();
    rig.start_can();
    let peer = rig.board.bus_mut().attach("peer");
    let heard = std::sync::Arc::new(std::sync::Mutex::new(Vec::new()));
    struct Ear(bench::can::NodeId, std::sync::Arc<std::sync::Mutex<Vec<Frame>>>);
    impl bench::can::Participant for Ear {
        fn start(&mut self, _now: Nanos, _bus: &mut bench::can::Bus) {}
        fn on_event(&mut self, event: &bench::can::Event, _bus: &mut bench::can::Bus) {
            if let (true, EventKind::Received { frame }) = (event.node == self.0, event.kind) {
                self.1.lock().unwrap().push(frame);
            }
        }
    }
    rig.board.join(Ear(peer, heard.clone()));
    rig.can(&[0x40, 0x24, 0x60, 0, 0, 2, 0xDE, 0xAD]);
    rig.can(&[0x81]);
    rig.wait(Nanos::from_millis(1));
    assert_eq!(*heard.lock().unwrap(), [Frame::new(Id::standard(0x123).unwrap(), &[0xDE, 0xAD]).unwrap()]);
}
