//! Raspberry Pi Pico with an MCP2515 module and a 320x240 TFT.
//!
//! The only crate that names a pin. [`init`] turns the chip's peripherals into owned parts that have names of their
//! own; the application knows the parts and the interrupts, nothing below them.
//!
//! | part         | pins                                                        | peripheral    | interrupt      |
//! |--------------|-------------------------------------------------------------|---------------|----------------|
//! | MCP2515      | 16 MISO, 17 CS, 18 SCK, 19 MOSI, 20 INT (pull-up)           | SPI0          | `IO_IRQ_BANK0` |
//! | panel        | 8 DC, 9 CS, 10 SCK, 11 MOSI, 12 RST                         | SPI1, DMA 0   | `DMA_IRQ_0`    |
//! | back-light   | 13                                                          | PWM 6 B       |                |
//! | buzzer       | 15                                                          | PWM 7 B       |                |
//! | buttons      | 2, 3 (pull-up, to ground)                                   |               |                |
//! | body         | 4, 5, 6, 7, 14, 21, 22 (pull-up, to ground)                 |               |                |
//! | gauges       | 26 supply, 27 and 28 air                                    | ADC 0 to 2    |                |
//! | PC link      | 0 TX, 1 RX, 115 200 baud                                    | UART0, DMA 1  | `DMA_IRQ_1`    |
//! | records      | top 32 KiB of the flash                                     | SSI           |                |
//! | LED          | 25                                                          |               |                |
//!
//! Constants are in [`facts`]. Source: Raspberry Pi Pico datasheet, RP2040 datasheet.

#![no_std]

#[cfg(all(feature = "ili9341", feature = "st7789"))]
compile_error!("one panel only: for the ST7789 build with --no-default-features --features st7789");
#[cfg(not(any(feature = "ili9341", feature = "st7789")))]
compile_error!("no panel: build with --features ili9341 or --features st7789");

pub mod can_port;
pub mod clock;
pub mod facts;
pub mod flash_port;
pub mod gauges;
pub mod link_port;
pub mod panel_port;
pub mod retained;
pub mod small_parts;

pub use can_port::{CanInt, CanSpi};
pub use clock::{Delay, now_us, stamp_us};
pub use flash_port::FlashPort;
pub use gauges::{Gauges, Measured};
pub use link_port::LinkPort;
pub use panel_port::PanelPort;
pub use retained::{Boot, Reset};
pub use rp2040_hal::Watchdog;
pub use rp2040_hal::pac;
pub use small_parts::{Backlight, BodyWires, Buttons, Buzzer, Led};

use embedded_hal::spi::{MODE_0, MODE_3};
use facts::LINK_RING;
use protocol_core::Value;
use rp2040_hal as hal;
use rp2040_hal::clocks::ClocksManager;
use rp2040_hal::dma::DMAExt;
use rp2040_hal::fugit::{MicrosDurationU32, RateExtU32};
use rp2040_hal::gpio::{FunctionUart, PinState, Pins};
use rp2040_hal::pll::common_configs::{PLL_SYS_125MHZ, PLL_USB_48MHZ};
use rp2040_hal::pll::setup_pll_blocking;
use rp2040_hal::uart::{DataBits, StopBits, UartConfig, UartPeripheral};
use rp2040_hal::vector_table::VectorTable;
use rp2040_hal::xosc::setup_xosc_blocking_custom_delay;
use rp2040_hal::{Clock as _, Sio, Spi};

/// Second stage of the boot: quad reads with continuous mode, without which every cache miss costs thrice the time.
#[unsafe(link_section = ".boot2")]
#[unsafe(no_mangle)]
#[used]
pub static BOOT2_FIRMWARE: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// Memory that the board needs for ever.
pub struct Memory {
    vectors: VectorTable,
    link_ring: [u8; LINK_RING],
}

impl Memory {
    /// Returns cleared memory.
    #[expect(clippy::new_without_default, reason = "a static needs a const constructor")]
    pub const fn new() -> Self {
        Self { vectors: VectorTable::new(), link_ring: [0; LINK_RING] }
    }
}

/// The parts of the board.
pub struct Board {
    /// SPI device of the MCP2515.
    pub can_spi: CanSpi,
    /// INT pin of the MCP2515, not armed yet.
    pub can_int: CanInt,
    /// The panel, held in reset.
    pub panel: PanelPort,
    /// Back-light, dark.
    pub backlight: Backlight,
    /// Buzzer, silent.
    pub buzzer: Buzzer,
    /// Pins of the two buttons, low = pressed.
    pub buttons: Buttons,
    /// Wires of the body.
    pub body: BodyWires,
    /// Analogue inputs.
    pub gauges: Gauges,
    /// LED, dark.
    pub led: Led,
    /// PC link.
    pub link: LinkPort,
    /// The region of the flash in which records are kept.
    pub flash: FlashPort,
    /// Watchdog, not started yet: see [`start_watchdog`].
    pub watchdog: Watchdog,
    /// Microsecond timer, running: for the application's monotonic.
    pub timer: pac::TIMER,
    /// Reset controller, which the monotonic asks for.
    pub resets: pac::RESETS,
    /// How this run began.
    pub boot: Boot,
}

/// Contacts of the body that have a pin.
const CONTACTS: usize = 8;

/// Brings the board up: clocks at 125 MHz, the timer running, the vector table in RAM, every part idle.
///
/// A clock that does not start resets the chip: without clocks there is nobody to tell.
pub fn init(mut pac: pac::Peripherals, memory: &'static mut Memory) -> Board {
    // A reset through the core leaves the HAL's spin-locks as they were; one that is held would hang the first
    // critical section.
    // SAFETY: interrupts are off and the second core sleeps: nobody holds a lock.
    unsafe { hal::sio::spinlock_reset() };
    let boot = retained::take(&pac.WATCHDOG, &pac.VREG_AND_CHIP_RESET);

    // Interrupts find their entry without a flash access, which may miss the cache or, while flash is written, fail.
    memory.vectors.init(&mut pac.PPB);
    // SAFETY: the table is 'static and has just been filled from the present one.
    unsafe { memory.vectors.activate(&mut pac.PPB) };

    let mut watchdog = Watchdog::new(pac.WATCHDOG);
    let Some(clocks) =
        start_clocks((pac.XOSC, pac.CLOCKS, pac.PLL_SYS, pac.PLL_USB), &mut pac.RESETS, &mut watchdog)
    else {
        hal::reset()
    };
    let peripheral_clock = clocks.peripheral_clock.freq();
    pac.RESETS.reset().modify(|_, w| w.timer().clear_bit());

    let sio = Sio::new(pac.SIO);
    let pins = Pins::new(pac.IO_BANK0, pac.PADS_BANK0, sio.gpio_bank0, &mut pac.RESETS);
    let dma = pac.DMA.split(&mut pac.RESETS);
    let pwm = hal::pwm::Slices::new(pac.PWM, &mut pac.RESETS);

    let can_pins = (
        pins.gpio19.reconfigure(),
        pins.gpio16.reconfigure::<_, hal::gpio::PullUp>(),
        pins.gpio18.reconfigure(),
    );
    let can_select = pins.gpio17.into_push_pull_output_in_state(PinState::High).into_pull_type();
    let can_limit = facts::CAN_SPI_LIMIT_HZ.Hz();
    let can_bus = Spi::new(pac.SPI0, can_pins).init(&mut pac.RESETS, peripheral_clock, can_limit, MODE_0);

    let panel_pins = (pins.gpio11.reconfigure(), pins.gpio10.reconfigure());
    let panel_hz = facts::PANEL_SPI_HZ.Hz();
    let panel_bus = Spi::new(pac.SPI1, panel_pins).init(&mut pac.RESETS, peripheral_clock, panel_hz, MODE_3);
    let panel = PanelPort::new(
        panel_bus,
        pins.gpio9.into_push_pull_output_in_state(PinState::High).into_pull_type(),
        pins.gpio8.into_push_pull_output_in_state(PinState::High).into_pull_type(),
        pins.gpio12.into_push_pull_output_in_state(PinState::Low).into_pull_type(),
        dma.ch0,
    );

    let adc = hal::Adc::new(pac.ADC, &mut pac.RESETS);
    let gauges = Gauges::new(adc, pins.gpio26, pins.gpio27, pins.gpio28);

    let mut backlight_slice = pwm.pwm6;
    let backlight_pin = pins.gpio13;
    let mut buzzer_slice = pwm.pwm7;
    let buzzer_pin = pins.gpio15;
    backlight_slice.default_config();
    buzzer_slice.default_config();
    backlight_slice.channel_b.output_to(backlight_pin);
    buzzer_slice.channel_b.output_to(buzzer_pin);

    // Nothing is received: the other pin of the UART is a contact.
    let link_pins =
        hal::uart::Pins::default().tx(pins.gpio0.reconfigure::<FunctionUart, hal::gpio::PullNone>());
    let link_config = UartConfig::new(facts::LINK_BAUD.Hz(), DataBits::Eight, None, StopBits::One);
    let uart = UartPeripheral::new(pac.UART0, link_pins, &mut pac.RESETS);
    let Ok(uart) = uart.enable(link_config, peripheral_clock) else { hal::reset() };

    Board {
        can_spi: CanSpi::new(can_bus, can_select),
        can_int: CanInt::new(pins.gpio20.into_pull_up_input()),
        panel,
        backlight: Backlight::new(backlight_slice),
        buzzer: Buzzer::new(buzzer_slice),
        buttons: Buttons { first: pins.gpio2.into_pull_up_input(), second: pins.gpio3.into_pull_up_input() },
        body: BodyWires([
            (Value::BodyDoorFront, pins.gpio4.into_pull_up_input().into_dyn_pin()),
            (Value::BodyDoorRear, pins.gpio5.into_pull_up_input().into_dyn_pin()),
            (Value::BodySeatEmpty, pins.gpio6.into_pull_up_input().into_dyn_pin()),
            (Value::BodyParkingBrake, pins.gpio7.into_pull_up_input().into_dyn_pin()),
            (Value::BodySmoke, pins.gpio14.into_pull_up_input().into_dyn_pin()),
            (Value::BodyTurnLeft, pins.gpio21.into_pull_up_input().into_dyn_pin()),
            (Value::BodyTurnRight, pins.gpio22.into_pull_up_input().into_dyn_pin()),
            (Value::BodyHazard, pins.gpio1.into_pull_up_input().into_dyn_pin()),
        ]),
        gauges,
        led: Led(pins.gpio25.into_push_pull_output_in_state(PinState::Low).into_pull_type()),
        link: LinkPort::new(uart, dma.ch1, &mut memory.link_ring),
        flash: FlashPort::new(),
        watchdog,
        timer: pac.TIMER,
        resets: pac.RESETS,
        boot,
    }
}

/// Starts crystal and PLLs: 12 MHz, 125 MHz, 48 MHz, and the tick of TIMER and watchdog.
///
/// The HAL's own start waits 63 ms for the slowest crystals there are, almost half of the time to the first picture;
/// the Pico's is stable after 1 ms (ABM8-272-T3; the C SDK waits no longer on this board).
fn start_clocks(
    (xosc, clocks, pll_sys, pll_usb): (pac::XOSC, pac::CLOCKS, pac::PLL_SYS, pac::PLL_USB),
    resets: &mut pac::RESETS,
    watchdog: &mut Watchdog,
) -> Option<ClocksManager> {
    let xosc = setup_xosc_blocking_custom_delay(xosc, facts::XTAL_HZ.Hz(), facts::XTAL_START_FACTOR).ok()?;
    watchdog.enable_tick_generation((facts::XTAL_HZ / 1_000_000) as u8);
    let mut clocks = ClocksManager::new(clocks);
    let crystal = xosc.operating_frequency();
    let pll_sys = setup_pll_blocking(pll_sys, crystal, PLL_SYS_125MHZ, &mut clocks, resets).ok()?;
    let pll_usb = setup_pll_blocking(pll_usb, crystal, PLL_USB_48MHZ, &mut clocks, resets).ok()?;
    clocks.init_default(&xosc, &pll_sys, &pll_usb).ok()?;
    Some(clocks)
}

/// Starts the watchdog; from now on it must be fed within [`facts::WATCHDOG_US`].
pub fn start_watchdog(watchdog: &mut Watchdog) {
    retained::mark_armed(watchdog);
    watchdog.pause_on_debug(true);
    watchdog.start(MicrosDurationU32::micros(facts::WATCHDOG_US));
}
