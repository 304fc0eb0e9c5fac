//! UART0 to a PC: frames go into a ring, DMA channel 1 empties it.
//!
//! A frame goes in whole or not at all; nobody ever waits. `DMA_IRQ_1` starts the next stretch ([`LinkPort::on_irq`]).
//! Source: RP2040 datasheet 4.2 (PL011) and 2.5 (DMA).

use core::sync::atomic::{Ordering, compiler_fence};
use rp2040_hal::dma::{CH1, Channel, SingleChannel};
use rp2040_hal::gpio::bank0::Gpio0;
use rp2040_hal::gpio::{FunctionUart, Pin, PullNone};
use rp2040_hal::pac;
use rp2040_hal::typelevel::{OptionTNone, OptionTSome};
use rp2040_hal::uart::{Enabled, Pins, UartPeripheral};

use crate::facts::{LINK_DMA, LINK_RING};

type Tx = OptionTSome<Pin<Gpio0, FunctionUart, PullNone>>;
type TxOnly = Pins<Tx, OptionTNone, OptionTNone, OptionTNone>;
pub(crate) type Uart = UartPeripheral<Enabled, pac::UART0, TxOnly>;

/// The sending side of the PC link.
pub struct LinkPort {
    _uart: Uart,
    channel: Channel<CH1>,
    ring: &'static mut [u8; LINK_RING],
    /// First byte that waits, or that the DMA reads now.
    head: usize,
    /// Bytes in the ring.
    used: usize,
    /// Bytes from `head` on that the DMA reads now.
    sending: usize,
    /// Frames that found no room.
    dropped: u32,
}

impl LinkPort {
    pub(crate) fn new(uart: Uart, mut channel: Channel<CH1>, ring: &'static mut [u8; LINK_RING]) -> Self {
        channel.enable_irq1();
        // SAFETY: `uart` owns UART0.
        unsafe { &*pac::UART0::PTR }.uartdmacr().write(|w| w.txdmae().set_bit());
        Self { _uart: uart, channel, ring, head: 0, used: 0, sending: 0, dropped: 0 }
    }

    /// Queues `frame`; `false` = no room, nothing is sent, and it is counted.
    pub fn send(&mut self, frame: &[u8]) -> bool {
        if frame.len() > LINK_RING - self.used {
            self.dropped = self.dropped.saturating_add(1);
            return false;
        }
        let tail = (self.head + self.used) % LINK_RING;
        let (first, rest) = frame.split_at(frame.len().min(LINK_RING - tail));
        self.ring[tail..tail + first.len()].copy_from_slice(first);
        self.ring[..rest.len()].copy_from_slice(rest);
        self.used += frame.len();
        self.start();
        true
    }

    /// Returns the frames that found no room.
    pub const fn dropped(&self) -> u32 {
        self.dropped
    }

    /// Takes note of a finished stretch and starts the next; for the `DMA_IRQ_1` task.
    pub fn on_irq(&mut self) {
        // SAFETY: writing a one clears the flag of this channel only.
        unsafe { &*pac::DMA::PTR }.ints1().write(|w| unsafe { w.bits(1 << LINK_DMA.0) });
        if self.channel.ch().ch_ctrl_trig().read().busy().bit_is_set() {
            return;
        }
        self.head = (self.head + self.sending) % LINK_RING;
        self.used -= self.sending;
        self.sending = 0;
        self.start();
    }

    /// Sends the longest stretch without a wrap, unless one is on its way.
    fn start(&mut self) {
        if self.sending != 0 || self.used == 0 {
            return;
        }
        self.sending = self.used.min(LINK_RING - self.head);
        let stretch = &self.ring[self.head..self.head + self.sending];
        let channel = self.channel.ch();
        // SAFETY: `send` never writes the bytes from `head` to `head + sending`; the ring is 'static; the write address
        // is UARTDR, which `_uart` owns.
        unsafe {
            let data = (*pac::UART0::PTR).uartdr().as_ptr();
            channel.ch_read_addr().write(|w| w.bits(stretch.as_ptr() as u32));
            channel.ch_write_addr().write(|w| w.bits(data as u32));
            channel.ch_trans_count().write(|w| w.bits(stretch.len() as u32));
            compiler_fence(Ordering::SeqCst);
            channel.ch_ctrl_trig().write(|w| {
                w.data_size().size_byte().incr_read().set_bit();
                w.treq_sel().bits(LINK_DMA.1).chain_to().bits(LINK_DMA.0 as u8);
                w.en().set_bit()
            });
        }
    }
}
