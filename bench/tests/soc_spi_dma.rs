//! SPI, UART and DMA: times to the cycle, FIFOs, requests, chains.

mod soc_support;

use bench::rp2040::Stop;
use bench::time::Nanos;
use soc_support::*;

const CR0: u32 = 0x00;
const CR1: u32 = 0x04;
const DR: u32 = 0x08;
const SR: u32 = 0x0c;
const CPSR: u32 = 0x10;
const RIS: u32 = 0x18;
const ICR: u32 = 0x20;
const DMACR: u32 = 0x24;
const BUSY: u32 = 1 << 4;
const MODE_0: u32 = 0;
const MODE_3: u32 = 3 << 6;

const TREQ_SPI0_TX: u32 = 16;
const TREQ_SPI0_RX: u32 = 17;
const TREQ_SPI1_TX: u32 = 18;
const TREQ_ADC: u32 = 36;
const TREQ_TIMER0: u32 = 0x3b;
const TREQ_ALWAYS: u32 = 0x3f;

/// 8-bit frames at 125 MHz / `divisor`, SPI enabled, all its DMA requests on, its pins routed.
fn set_up_spi(machine: &mut Machine, spi: u32, mode: u32, divisor: u32, bits: u32) {
    let first = if spi == SPI0 { 16 } else { 8 };
    for pin in [first, first + 2, first + 3] {
        set_function(machine, pin, 1);
    }
    poke(machine, spi + CR0, mode | (bits - 1));
    poke(machine, spi + CPSR, divisor);
    poke(machine, spi + DMACR, 3);
    poke(machine, spi + CR1, 2);
}

struct Transfer {
    read: u32,
    write: u32,
    count: u32,
    treq: u32,
    /// log2 of the item's bytes
    size: u32,
    increment: (bool, bool),
    chain: Option<u32>,
    extra: u32,
}

fn start(machine: &mut Machine, channel: u32, transfer: &Transfer) {
    let registers = DMA + 0x40 * channel;
    poke(machine, registers, transfer.read);
    poke(machine, registers + 4, transfer.write);
    poke(machine, registers + 8, transfer.count);
    poke(machine, registers + 0xc, control(channel, transfer) | 1);
}

fn control(channel: u32, transfer: &Transfer) -> u32 {
    transfer.size << 2
        | u32::from(transfer.increment.0) << 4
        | u32::from(transfer.increment.1) << 5
        | transfer.chain.unwrap_or(channel) << 11
        | transfer.treq << 15
        | transfer.extra
}

fn is_busy(machine: &mut Machine, channel: u32) -> bool {
    peek(machine, DMA + 0x40 * channel + 0xc) & 1 << 24 != 0
}

fn to_spi1(count: u32) -> Transfer {
    Transfer {
        read: RAM,
        write: SPI1 + DR,
        count,
        treq: TREQ_SPI1_TX,
        size: 0,
        increment: (true, false),
        chain: None,
        extra: 0,
    }
}

/// A whole 320 x 240 picture over SPI by DMA; returns the time from the first frame's start to the last one's end.
fn picture_time(mode: u32, divisor: u32, bits: u32) -> Nanos {
    let mut machine = awake_chip();
    set_up_spi(&mut machine, SPI1, mode, divisor, bits);
    let size = if bits == 16 { 1 } else { 0 };
    let items = 153_600 >> size;
    let begin = machine.now();
    start(&mut machine, 0, &Transfer { size, ..to_spi1(items) });
    run(&mut machine, Nanos::from_millis(120));
    let times = spi_times(&machine, 1);
    assert_eq!(times.len(), items as usize);
    assert_eq!(peek(&mut machine, DMA + 0x400), 1, "completed");
    times.last().unwrap().since(begin)
}

#[test]
fn a_picture_in_mode_3_takes_eight_clocks_per_byte() {
    // 153,600 * 8 bits * 2 cycles * 8 ns
    assert_eq!(picture_time(MODE_3, 2, 8), Nanos(153_600 * 8 * 2 * 8));
    assert_eq!(picture_time(MODE_3, 4, 8), Nanos(153_600 * 8 * 4 * 8));
}

#[test]
fn a_picture_in_mode_0_pays_two_clocks_of_gap_per_frame() {
    // The last frame has no gap behind it.
    assert_eq!(picture_time(MODE_0, 2, 8), Nanos((153_600 * 10 - 2) * 2 * 8));
    assert_eq!(picture_time(MODE_0, 2, 16), Nanos((76_800 * 18 - 2) * 2 * 8));
}

#[test]
fn each_frame_reaches_the_board_at_the_end_of_its_last_bit() {
    let mut machine = awake_chip();
    set_up_spi(&mut machine, SPI1, MODE_3, 4, 8);
    let begin = machine.now();
    for word in [0x11, 0x22, 0x33] {
        poke(&mut machine, SPI1 + DR, word);
    }
    assert_eq!(peek(&mut machine, SPI1 + SR) & BUSY, BUSY);
    run(&mut machine, Nanos::from_micros(2));
    let frame = Nanos(8 * 4 * 8);
    let expected: Vec<Call> = (1..=3)
        .map(|i| Call::Spi { at: begin + Nanos(frame.0 * i), port: 1, word: 0x11 * i as u16, bits: 8 })
        .collect();
    assert_eq!(machine.board.calls, expected);
    assert_eq!(peek(&mut machine, SPI1 + SR) & BUSY, 0);
    let received: Vec<u32> = (0..3).map(|_| peek(&mut machine, SPI1 + DR)).collect();
    assert_eq!(received, [0xee, 0xdd, 0xcc], "what the board answers, cut to the frame");
}

#[test]
fn a_slower_peripheral_clock_slows_the_frames() {
    let mut machine = awake_chip();
    poke(&mut machine, CLOCKS + 0x48, 1 << 11 | 4 << 5); // clk_peri = crystal
    set_up_spi(&mut machine, SPI1, MODE_3, 2, 8);
    let begin = machine.now();
    poke(&mut machine, SPI1 + DR, 0);
    run(&mut machine, Nanos::from_micros(5));
    let time = spi_times(&machine, 1)[0].since(begin);
    assert!(time >= Nanos(1333) && time <= Nanos(1344), "{time}: 8 bits at 6 MHz");
}

#[test]
fn an_spi_whose_pins_are_not_given_to_it_reaches_nobody() {
    let mut machine = awake_chip();
    set_up_spi(&mut machine, SPI1, MODE_3, 2, 8);
    set_function(&mut machine, 10, 31);
    poke(&mut machine, SPI1 + DR, 0x55);
    run(&mut machine, Nanos::from_micros(5));
    assert!(machine.board.calls.is_empty());
    assert_eq!(machine.stats().spi_unrouted, [0, 1]);
    assert_eq!(peek(&mut machine, SPI1 + DR), 0, "and MISO reads 0");
}

#[test]
fn a_disabled_spi_keeps_its_fifo_until_it_is_enabled() {
    let mut machine = awake_chip();
    set_up_spi(&mut machine, SPI1, MODE_3, 2, 8);
    poke(&mut machine, SPI1 + CR1, 0);
    poke(&mut machine, SPI1 + DR, 1);
    run(&mut machine, Nanos::from_micros(5));
    assert!(machine.board.calls.is_empty());
    poke(&mut machine, SPI1 + CR1, 2);
    run(&mut machine, Nanos::from_micros(5));
    assert_eq!(spi_times(&machine, 1).len(), 1);
}

#[test]
fn unread_frames_overrun_after_eight_and_time_out_after_32_bits() {
    let mut machine = awake_chip();
    set_up_spi(&mut machine, SPI1, MODE_3, 4, 8);
    assert_eq!(peek(&mut machine, SPI1 + RIS), 8, "an empty TX FIFO asks for data");
    poke(&mut machine, SPI1 + DR, 0);
    run(&mut machine, Nanos((8 + 31) * 32));
    assert_eq!(peek(&mut machine, SPI1 + RIS) & 2, 0);
    run(&mut machine, Nanos(2 * 32));
    assert_eq!(peek(&mut machine, SPI1 + RIS) & 2, 2, "receive timeout");
    poke(&mut machine, SPI1 + ICR, 2);
    for _ in 0..8 {
        poke(&mut machine, SPI1 + DR, 0);
    }
    run(&mut machine, Nanos::from_micros(5));
    assert_eq!(peek(&mut machine, SPI1 + RIS) & 1, 1, "nine frames for eight entries");
    poke(&mut machine, SPI1 + ICR, 1);
    assert_eq!(peek(&mut machine, SPI1 + RIS) & 1, 0);
}

#[test]
fn dma_waits_for_dmacr() {
    let mut machine = awake_chip();
    set_up_spi(&mut machine, SPI1, MODE_3, 2, 8);
    poke(&mut machine, SPI1 + DMACR, 0);
    start(&mut machine, 0, &to_spi1(4));
    run(&mut machine, Nanos::from_micros(10));
    assert!(machine.board.calls.is_empty());
    poke(&mut machine, SPI1 + DMACR, 2);
    run(&mut machine, Nanos::from_micros(10));
    assert_eq!(spi_times(&machine, 1).len(), 4);
}

#[test]
fn paired_dma_receives_as_much_as_it_sends() {
    let mut machine = awake_chip();
    set_up_spi(&mut machine, SPI0, MODE_0, 12, 8);
    for i in 0..48 {
        poke(&mut machine, RAM + 4 * i, 0x0101_0101 * i);
    }
    let receive = Transfer {
        read: SPI0 + DR,
        write: RAM + 0x1000,
        treq: TREQ_SPI0_RX,
        increment: (false, true),
        ..to_spi1(192)
    };
    start(&mut machine, 1, &receive);
    start(&mut machine, 0, &Transfer { write: SPI0 + DR, treq: TREQ_SPI0_TX, ..to_spi1(192) });
    run(&mut machine, Nanos::from_millis(1));
    assert!(!is_busy(&mut machine, 0) && !is_busy(&mut machine, 1));
    let expected: Vec<u8> = machine.read_ram(RAM, 192).iter().map(|byte| !byte).collect();
    assert_eq!(machine.read_ram(RAM + 0x1000, 192), expected);
    assert_eq!(peek(&mut machine, SPI0 + RIS) & 1, 0, "no overrun");
}

#[test]
fn two_ports_stream_at_once_in_order_of_time() {
    let mut machine = awake_chip();
    set_up_spi(&mut machine, SPI0, MODE_0, 14, 8);
    set_up_spi(&mut machine, SPI1, MODE_3, 2, 8);
    start(&mut machine, 1, &Transfer { write: SPI0 + DR, treq: TREQ_SPI0_TX, ..to_spi1(100) });
    start(&mut machine, 0, &to_spi1(900));
    run(&mut machine, Nanos::from_millis(1));
    assert_eq!((spi_times(&machine, 0).len(), spi_times(&machine, 1).len()), (100, 900));
    assert!(machine.board.calls.windows(2).all(|pair| pair[0].at() <= pair[1].at()));
}

#[test]
fn an_unpaced_transfer_moves_one_item_per_cycle() {
    let mut machine = awake_chip();
    poke(&mut machine, RAM, 0xfeed_beef);
    let copy = Transfer {
        read: RAM,
        write: RAM + 0x8000,
        count: 5000,
        treq: TREQ_ALWAYS,
        size: 2,
        increment: (true, true),
        chain: None,
        extra: 0,
    };
    start(&mut machine, 0, &copy);
    run(&mut machine, Nanos(2500 * 8));
    assert!(is_busy(&mut machine, 0));
    let left = peek(&mut machine, DMA + 8);
    assert!((2450..=2550).contains(&left), "{left} of 5000 left");
    run(&mut machine, Nanos(2510 * 8));
    assert!(!is_busy(&mut machine, 0));
    assert_eq!(machine.read_ram(RAM, 20_000).to_vec(), machine.read_ram(RAM + 0x8000, 20_000));
}

#[test]
fn a_pacing_timer_grants_x_items_per_y_cycles() {
    let mut machine = awake_chip();
    poke(&mut machine, DMA + 0x420, 1 << 16 | 125); // one per microsecond
    let transfer = Transfer { write: RAM + 0x100, count: 100, treq: TREQ_TIMER0, size: 2, ..to_spi1(0) };
    start(&mut machine, 3, &transfer);
    run(&mut machine, Nanos::from_micros(99));
    assert!(is_busy(&mut machine, 3));
    run(&mut machine, Nanos::from_micros(2));
    assert!(!is_busy(&mut machine, 3));
}

#[test]
fn rings_wrap_and_the_adc_paces() {
    let mut machine = awake_chip();
    for channel in 0..4 {
        machine.set_analog(channel, 806 * (channel as u32 + 1));
    }
    let ring = Transfer {
        read: ADC + 0xc,
        write: RAM + 0x200,
        count: 11,
        treq: TREQ_ADC,
        size: 1,
        increment: (false, true),
        chain: None,
        extra: 3 << 6 | 1 << 10, // 8-byte ring on the write side
    };
    start(&mut machine, 0, &ring);
    poke(&mut machine, ADC + 8, 1 | 8 | 1 << 24);
    poke(&mut machine, ADC, 1 | 8 | 0xf << 16);
    run(&mut machine, Nanos::from_micros(40));
    assert!(!is_busy(&mut machine, 0));
    let samples: Vec<u16> = machine
        .read_ram(RAM + 0x200, 8)
        .chunks(2)
        .map(|pair| u16::from_le_bytes([pair[0], pair[1]]))
        .collect();
    assert_eq!(samples, [1000, 2000, 3001, 4001]);
    assert_eq!(machine.read_ram(RAM + 0x208, 1), [0xa5], "nothing behind the ring");
}

#[test]
fn a_chain_starts_the_next_channel_and_quiet_channels_raise_nothing() {
    let mut machine = awake_chip();
    set_up_spi(&mut machine, SPI1, MODE_3, 2, 8);
    let second = to_spi1(5);
    poke(&mut machine, DMA + 0x40, RAM);
    poke(&mut machine, DMA + 0x44, SPI1 + DR);
    poke(&mut machine, DMA + 0x48, 5);
    poke(&mut machine, DMA + 0x50, control(1, &second) | 1); // AL1_CTRL does not trigger
    assert!(!is_busy(&mut machine, 1));
    start(&mut machine, 0, &Transfer { chain: Some(1), extra: 1 << 21, ..to_spi1(3) });
    run(&mut machine, Nanos::from_micros(10));
    assert_eq!(spi_times(&machine, 1).len(), 8);
    assert_eq!(peek(&mut machine, DMA + 0x400), 2, "channel 0 is quiet");
}

#[test]
fn completion_raises_the_enabled_line_until_written() {
    let mut machine = awake_chip();
    set_up_spi(&mut machine, SPI1, MODE_3, 2, 8);
    poke(&mut machine, DMA + 0x414, 1); // INTE1
    start(&mut machine, 0, &to_spi1(3));
    run(&mut machine, Nanos::from_micros(10));
    assert_eq!((peek(&mut machine, DMA + 0x40c), peek(&mut machine, DMA + 0x41c)), (0, 1));
    assert_eq!((machine.stats().irqs[11], machine.stats().irqs[12]), (0, 1));
    poke(&mut machine, DMA + 0x41c, 1);
    assert_eq!(peek(&mut machine, DMA + 0x400), 0);
}

#[test]
fn abort_ends_a_channel_and_reads_back_zero() {
    let mut machine = awake_chip();
    set_up_spi(&mut machine, SPI1, MODE_3, 2, 8);
    start(&mut machine, 0, &to_spi1(1000));
    run(&mut machine, Nanos::from_micros(10));
    poke(&mut machine, DMA + 0x444, 1);
    assert_eq!(peek(&mut machine, DMA + 0x444), 0);
    assert!(!is_busy(&mut machine, 0));
    run(&mut machine, Nanos::from_micros(10));
    let sent = spi_times(&machine, 1).len();
    run(&mut machine, Nanos::from_micros(100));
    assert_eq!(spi_times(&machine, 1).len(), sent);
}

#[test]
fn a_transfer_of_nothing_completes_at_once() {
    let mut machine = awake_chip();
    start(&mut machine, 0, &to_spi1(0));
    assert!(!is_busy(&mut machine, 0));
    assert_eq!(peek(&mut machine, DMA + 0x400), 1);
}

#[test]
fn the_sniffer_sums_and_computes_crc32() {
    let mut machine = awake_chip();
    for (i, byte) in b"123456789".iter().enumerate() {
        use bench::rp2040::bus::{Bus, Width};
        machine.store(RAM + i as u32, Width::Byte, u32::from(*byte)).unwrap();
    }
    let bytes = Transfer { write: RAM + 0x100, count: 9, treq: TREQ_ALWAYS, extra: 1 << 23, ..to_spi1(0) };
    for (mode, seed, expected) in
        [(0x0, u32::MAX, 0x0376_e6e7), (0xf, 0, b"123456789".iter().map(|byte| u32::from(*byte)).sum())]
    {
        poke(&mut machine, DMA + 0x434, 1 | mode << 5);
        poke(&mut machine, DMA + 0x438, seed);
        start(&mut machine, 0, &bytes);
        run(&mut machine, Nanos::from_micros(1));
        assert_eq!(
            peek(&mut machine, DMA + 0x438),
            expected,
            "CRC-32/MPEG-2 check value, then the plain sum"
        );
    }
    // Bit-reversed in and out, inverted: the CRC-32 of zip files.
    poke(&mut machine, DMA + 0x434, 1 | 1 << 5 | 1 << 10 | 1 << 11);
    poke(&mut machine, DMA + 0x438, u32::MAX);
    start(&mut machine, 0, &bytes);
    run(&mut machine, Nanos::from_micros(1));
    assert_eq!(peek(&mut machine, DMA + 0x438), 0xcbf4_3926);
}

#[test]
fn a_dma_into_nowhere_stops_the_run() {
    let mut machine = awake_chip();
    start(&mut machine, 0, &Transfer { read: 0x3000_0000, treq: TREQ_ALWAYS, ..to_spi1(4) });
    let stop = run_to_stop(&mut machine, Nanos::from_micros(10));
    assert!(matches!(&stop, Stop::Chip { what, .. } if what.contains("channel 0")), "{stop}");
}

#[test]
fn a_uart_byte_takes_ten_bits_and_busy_lasts_that_long() {
    let mut machine = awake_chip();
    set_function(&mut machine, 0, 2);
    poke(&mut machine, UART0 + 0x24, 67); // 125 MHz / (16 * 67.8125) = 115,207 baud
    poke(&mut machine, UART0 + 0x28, 52);
    poke(&mut machine, UART0 + 0x2c, 0x70);
    poke(&mut machine, UART0 + 0x30, 0x301);
    let begin = machine.now();
    poke(&mut machine, UART0, 0x41);
    poke(&mut machine, UART0, 0x42);
    run(&mut machine, Nanos::from_micros(200));
    let byte = Nanos(10 * 16 * 8 * 67 + 10 * 16 * 8 * 52 / 64); // 86,800 ns
    let (first, second) = (begin + byte, begin + Nanos(2 * byte.0));
    let expected =
        [Call::Uart { at: first, port: 0, byte: 0x41 }, Call::Uart { at: second, port: 0, byte: 0x42 }];
    assert_eq!(machine.board.calls, expected);
    assert_eq!(peek(&mut machine, UART0 + 0x18), 0x90);
}

#[test]
fn uart_input_arrives_at_the_baud_rate_and_overruns_after_32() {
    let mut machine = awake_chip();
    poke(&mut machine, UART0 + 0x24, 8); // about 1 Mbaud
    poke(&mut machine, UART0 + 0x2c, 0x70);
    poke(&mut machine, UART0 + 0x38, 0x50); // RX and RT
    poke(&mut machine, UART0 + 0x30, 0x301);
    machine.uart_input(0, &[7; 40]);
    let byte = Nanos(10 * 16 * 8 * 8);
    run(&mut machine, Nanos(3 * byte.0 + 100));
    assert_eq!(peek(&mut machine, UART0 + 0x3c), 0);
    run(&mut machine, Nanos(30 * byte.0));
    assert_eq!(peek(&mut machine, UART0 + 0x18) & 0x40, 0x40, "full");
    run(&mut machine, Nanos(20 * byte.0));
    assert_eq!(peek(&mut machine, UART0 + 0x3c) & 0x450, 0x450, "RX level, timeout and overrun");
    for _ in 0..32 {
        assert_eq!(peek(&mut machine, UART0), 7);
    }
    assert_eq!(peek(&mut machine, UART0 + 0x18) & 0x10, 0x10, "empty: the other eight are lost");
}

/// A board like the recorder that asks to be called soon after each frame, so no frame may be served late.
#[derive(Default)]
struct Fidgety {
    frames: Vec<(Nanos, u16)>,
    pins: Vec<(Nanos, bool)>,
    wants: Option<Nanos>,
}

impl bench::pins::Board for Fidgety {
    fn pin_out(&mut self, at: Nanos, _: u8, level: bool, _: &mut bench::pins::InputPins) {
        self.pins.push((at, level));
    }
    fn spi_frame(&mut self, at: Nanos, _: u8, word: u16, _: u8, _: &mut bench::pins::InputPins) -> u16 {
        self.frames.push((at, word));
        self.wants = Some(at + Nanos(50));
        0
    }
    fn uart_byte(&mut self, _: Nanos, _: u8, _: u8) {}
    fn pwm(&mut self, _: Nanos, _: u8, _: u32, _: u32) {}
    fn next_event(&self) -> Option<Nanos> {
        self.wants
    }
    fn advance(&mut self, now: Nanos, inputs: &mut bench::pins::InputPins) {
        self.wants = self.wants.filter(|at| *at > now);
        inputs.drive(20, now.0.is_multiple_of(2));
    }
}

/// Streams a buffer that a running program rewrites meanwhile, word by word, on any board.
fn streamed<B: bench::pins::Board>(board: B) -> bench::rp2040::Rp2040<B> {
    let mut program = Program::new();
    program.poke(RESETS, 0);
    for pin in [10u32, 11] {
        program.poke(IO_BANK0 + 8 * pin + 4, 1);
    }
    program.poke(CLOCKS + 0x48, 1 << 11);
    program.poke(SPI1 + CR0, MODE_0 | 7);
    program.poke(SPI1 + CPSR, 2);
    program.poke(SPI1 + DMACR, 2);
    program.poke(SPI1 + CR1, 2);
    program.poke(IO_BANK0 + 8 * 25 + 4, 5);
    program.poke(SIO + 0x24, 1 << 25);
    program.poke(NVIC_ISER, 1 << 11);
    program.poke(DMA + 0x404, 1);
    program.poke(DMA, RAM + 0x4000);
    program.poke(DMA + 4, SPI1 + DR);
    program.poke(DMA + 8, 4000);
    program.poke(DMA + 0xc, control(0, &to_spi1(0)) | 1);
    // Slower than the DMA at first sight of a word, faster at the end: some words are sent old, some new.
    program.load(0, RAM + 0x4000 + 4000);
    program.load(2, 1000);
    let again = program.here();
    program.subs(0, 4);
    program.str(2, 0, 0);
    program.subs(2, 1);
    program.branch_not_equal(again);
    program.sleep();
    program.handler(16 + 11);
    program.poke(DMA + 0x40c, 1);
    program.poke(SIO + 0x14, 1 << 25);
    program.bx_lr();
    let mut machine = bench::rp2040::Rp2040::new(image(&program), board);
    machine.run_until(Nanos::from_millis(60)).expect("the run goes on");
    machine
}

#[test]
fn a_stream_served_in_batches_equals_one_served_frame_by_frame() {
    let batched = streamed(Recorder::default());
    let single = streamed(Fidgety::default());
    let of_batched: Vec<(Nanos, u16)> = batched
        .board
        .calls
        .iter()
        .filter_map(|call| match call {
            Call::Spi { at, word, .. } => Some((*at, *word)),
            _ => None,
        })
        .collect();
    assert_eq!(of_batched.len(), 4000);
    assert!(
        of_batched.iter().any(|(_, word)| *word == 0xa5) && of_batched.iter().any(|(_, word)| *word != 0xa5)
    );
    assert_eq!(of_batched, single.board.frames);
    assert_eq!(single.board.pins.len(), 2, "low, then high when the DMA is done");
    assert_eq!(pin_levels(&batched, 25), single.board.pins);
    assert_eq!(batched.stats().instructions, single.stats().instructions);
}

#[test]
fn the_uart_transmit_interrupt_marks_the_level_falling_through_its_trigger() {
    let mut machine = awake_chip();
    poke(&mut machine, UART0 + 0x24, 8);
    poke(&mut machine, UART0 + 0x2c, 0x70);
    poke(&mut machine, UART0 + 0x34, 0); // one eighth: 4 of 32
    poke(&mut machine, UART0 + 0x38, 0x20);
    poke(&mut machine, UART0 + 0x30, 0x301);
    assert_eq!(peek(&mut machine, UART0 + 0x40), 0, "an empty FIFO alone raises nothing");
    for _ in 0..8 {
        poke(&mut machine, UART0, 0);
    }
    let byte = Nanos(10 * 16 * 8 * 8);
    run(&mut machine, Nanos(byte.0 * 3 - 100)); // 5 left
    assert_eq!(peek(&mut machine, UART0 + 0x40), 0);
    run(&mut machine, byte);
    assert_eq!(peek(&mut machine, UART0 + 0x40), 0x20);
    poke(&mut machine, UART0 + 0x44, 0x20);
    assert_eq!(peek(&mut machine, UART0 + 0x40), 0);
}

#[test]
fn dma_feeds_a_uart_at_its_baud_rate() {
    let mut machine = awake_chip();
    set_function(&mut machine, 0, 2);
    poke(&mut machine, UART0 + 0x24, 8);
    poke(&mut machine, UART0 + 0x2c, 0x70);
    poke(&mut machine, UART0 + 0x48, 2);
    poke(&mut machine, UART0 + 0x30, 0x301);
    start(&mut machine, 2, &Transfer { write: UART0, treq: 20, ..to_spi1(100) });
    let byte = Nanos(10 * 16 * 8 * 8);
    run(&mut machine, Nanos(byte.0 * 50));
    assert!(is_busy(&mut machine, 2));
    run(&mut machine, Nanos(byte.0 * 51));
    assert!(!is_busy(&mut machine, 2));
    assert_eq!(machine.board.calls.len(), 100);
}

#[test]
fn a_pin_change_and_the_frames_before_it_reach_the_board_in_order() {
    let mut program = Program::new();
    program.load(2, SIO + 0x1c);
    program.load(3, 1 << 25);
    let again = program.here();
    program.str(3, 2, 0);
    program.branch(again);
    let mut machine = boot(&program);
    run(&mut machine, Nanos::from_millis(10));
    bring_up(&mut machine);
    set_up_spi(&mut machine, SPI1, MODE_3, 2, 8);
    set_function(&mut machine, 25, 5);
    poke(&mut machine, SIO + 0x24, 1 << 25);
    start(&mut machine, 0, &to_spi1(2000));
    run(&mut machine, Nanos::from_micros(200));
    assert!(spi_times(&machine, 1).len() > 1000 && pin_levels(&machine, 25).len() > 1000);
    assert!(machine.board.calls.windows(2).all(|pair| pair[0].at() <= pair[1].at()));
    let frame = Nanos(8 * 2 * 8);
    assert!(spi_times(&machine, 1).windows(2).all(|pair| pair[1].since(pair[0]) == frame));
}
