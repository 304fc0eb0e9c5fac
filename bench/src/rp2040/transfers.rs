//! What moves by itself: DMA items, and SPI frames in batches.
//!
//! Owns the meeting of DMA requests with the peripherals that raise them, and the rule by which frames may be served
//! late ([`Chip::plan_stream`]).
//!
//! Source: RP2040 datasheet 2.5.3 (data requests), 2.5.3.1 (table of DREQs).
//!
//! Not modelled: see `dma`.

use super::bus::{BusError, Width};
use super::chip::{Chip, NEVER, RAM_BASE, RAM_BYTES};
use super::dma::{CHANNELS, TREQ_PERMANENT, TREQ_TIMER};

/// Items that an unpaced channel moves per event; each takes one cycle.
const UNPACED_CHUNK: u64 = 32;
/// Frames of a stream that are served at once.
const STREAM_BATCH: u32 = 32;
const TREQ_SPI0_TX: u32 = 16;
const TREQ_UART0_TX: u32 = 20;
const TREQ_UART1_RX: u32 = 23;
const TREQ_PWM0: u32 = 24;
const TREQ_PWM7: u32 = 31;
const TREQ_ADC: u32 = 36;
const SPI_DATA: [u32; 2] = [0x4003_c008, 0x4004_0008];

impl Chip {
    /// Moves everything that may move by now.
    pub(super) fn serve_dma(&mut self) {
        if self.dma.active == 0 {
            self.dma.next_event = NEVER;
            return;
        }
        self.serve_unpaced();
        self.serve_timers();
        // A completed channel may chain to one that can start at once; more than a lap each is a loop of empty channels.
        for _ in 0..CHANNELS {
            let before = self.dma.active;
            let mut left = before;
            while left != 0 {
                let index = left.trailing_zeros() as usize;
                left &= left - 1;
                let treq = self.dma.channels[index].treq();
                if treq < TREQ_TIMER {
                    self.feed(treq);
                }
            }
            if self.dma.active == before {
                break;
            }
        }
        self.plan_dma();
    }

    fn plan_dma(&mut self) {
        let mut next = NEVER;
        let mut slices = 0;
        let mut left = self.dma.active;
        while left != 0 {
            let channel = &self.dma.channels[left.trailing_zeros() as usize];
            left &= left - 1;
            let treq = channel.treq();
            match treq {
                TREQ_PERMANENT => {
                    next = next.min(self.dma.unpaced_at + u64::from(channel.count).min(UNPACED_CHUNK));
                }
                TREQ_TIMER.. => {
                    next = next.min(self.dma.timer_grants((treq - TREQ_TIMER) as usize, self.now).1);
                }
                TREQ_PWM0..=TREQ_PWM7 => slices |= 1 << (treq - TREQ_PWM0),
                TREQ_SPI0_TX..=TREQ_UART1_RX | TREQ_ADC => {}
                _ => {
                    self.stop_for(format!("DMA waits for request {treq}, whose peripheral is not modelled"));
                    return;
                }
            }
        }
        self.dma.next_event = next;
        if self.pwm.wanted != slices {
            self.pwm.wanted = slices;
            self.pwm.requests &= slices;
            self.pwm.schedule();
        }
    }

    fn serve_unpaced(&mut self) {
        let mut items = self.now.saturating_sub(self.dma.unpaced_at);
        let channels = self.dma.unpaced_channels();
        self.dma.unpaced_at = self.now;
        if channels == 0 {
            return;
        }
        items = items.min(u64::from(u32::MAX));
        for index in (0..CHANNELS).filter(|index| channels & 1 << index != 0) {
            for _ in 0..items {
                if self.dma.active & 1 << index == 0 || !self.move_item(index) {
                    break;
                }
            }
        }
    }

    fn serve_timers(&mut self) {
        for timer in 0..4 {
            let channels = self.dma.with_treq(TREQ_TIMER + timer);
            if channels == 0 {
                continue;
            }
            let (grants, _) = self.dma.timer_grants(timer as usize, self.now);
            for _ in 0..grants {
                let channels = self.dma.with_treq(TREQ_TIMER + timer);
                if channels == 0 || !self.move_item(channels.trailing_zeros() as usize) {
                    break;
                }
            }
            self.dma.use_grants(timer as usize, grants);
        }
    }

    fn requests(&self, treq: u32) -> u32 {
        match treq {
            16 => self.spi[0].tx_requests(),
            17 => self.spi[0].rx_requests(),
            18 => self.spi[1].tx_requests(),
            19 => self.spi[1].rx_requests(),
            20 => self.uart[0].tx_requests(),
            21 => self.uart[0].rx_requests(),
            22 => self.uart[1].tx_requests(),
            23 => self.uart[1].rx_requests(),
            TREQ_PWM0..=TREQ_PWM7 => self.pwm.requests >> (treq - TREQ_PWM0) & 1,
            TREQ_ADC => self.adc.requests(),
            _ => 0,
        }
    }

    /// Moves items for as long as request `treq` stands.
    fn feed(&mut self, treq: u32) {
        let channels = self.dma.with_treq(treq);
        if channels == 0 {
            return;
        }
        let index = channels.trailing_zeros() as usize;
        while self.requests(treq) != 0 && self.dma.active & 1 << index != 0 {
            if (TREQ_PWM0..=TREQ_PWM7).contains(&treq) {
                self.pwm.requests &= !(1 << (treq - TREQ_PWM0));
            }
            if !self.move_item(index) {
                return;
            }
        }
    }

    /// Serves SPI `port`'s requests after its FIFOs have changed.
    #[inline]
    pub(super) fn feed_spi(&mut self, port: usize) {
        let before = self.dma.active;
        if before == 0 {
            return;
        }
        self.feed(TREQ_SPI0_TX + 2 * port as u32 + 1);
        self.feed(TREQ_SPI0_TX + 2 * port as u32);
        if self.dma.active != before {
            self.serve_dma();
        }
    }

    /// Decides whether `port`'s frames may be served in batches: one plain channel feeds it from SRAM, nothing else
    /// moves by DMA and no SPI interrupt is enabled. Who could see the difference makes the engine catch up first: an
    /// access to a peripheral, a store to what is still to be sent, any call to the board.
    pub(super) fn plan_stream(&mut self, port: usize) {
        let channels = self.dma.with_treq(TREQ_SPI0_TX + 2 * port as u32);
        let lag = self.stream_lag(port, channels);
        self.spi[port].set_lag(lag);
        let bit = 1 << port;
        self.streams = if lag == 0 { self.streams & !bit } else { self.streams | bit };
        if self.streams == 0 {
            self.stream_source = (0, 0);
            return;
        }
        let (mut first, mut end) = (usize::MAX, 0);
        let mut left = self.dma.active;
        while left != 0 {
            let channel = &self.dma.channels[left.trailing_zeros() as usize];
            left &= left - 1;
            let start = channel.read.wrapping_sub(RAM_BASE) as usize;
            first = first.min(start);
            end = end.max(start + (channel.count * channel.size()) as usize);
        }
        self.stream_source = (first, end.saturating_sub(first));
    }

    fn stream_lag(&self, port: usize, channels: u32) -> u32 {
        if !channels.is_power_of_two() || !self.spi[port].is_unwatched() || !self.spi_out[port] {
            return 0;
        }
        let mut left = self.dma.active;
        while left != 0 {
            let channel = &self.dma.channels[left.trailing_zeros() as usize];
            left &= left - 1;
            let end =
                u64::from(channel.read.wrapping_sub(RAM_BASE)) + u64::from(channel.count * channel.size());
            if !SPI_DATA.contains(&channel.write) || !channel.is_plain_stream() || end > RAM_BYTES as u64 {
                return 0;
            }
        }
        // The DMA is done when the last item enters the FIFO, which is `count` frames ahead.
        self.dma.channels[channels.trailing_zeros() as usize].count.min(STREAM_BATCH) - 1
    }

    /// From now on each frame of each port is served at its end.
    pub(super) fn end_streams(&mut self) {
        self.streams = 0;
        self.stream_source = (0, 0);
        for spi in &mut self.spi {
            spi.set_lag(0);
        }
    }

    pub(super) fn feed_uart(&mut self, port: usize) {
        self.feed_then_serve(TREQ_UART0_TX + 2 * port as u32);
        self.feed_then_serve(TREQ_UART0_TX + 2 * port as u32 + 1);
    }

    pub(super) fn feed_pwm(&mut self) {
        for slice in 0..8 {
            self.feed_then_serve(TREQ_PWM0 + slice);
        }
    }

    pub(super) fn feed_adc(&mut self) {
        self.feed_then_serve(TREQ_ADC);
    }

    fn feed_then_serve(&mut self, treq: u32) {
        let before = self.dma.active;
        if before != 0 {
            self.feed(treq);
            if self.dma.active != before {
                self.serve_dma();
            }
        }
    }

    /// Moves one item of channel `index`; `false` if the run stops over it.
    #[inline]
    fn move_item(&mut self, index: usize) -> bool {
        let channel = &mut self.dma.channels[index];
        // The store of the last item may itself ask for one more, before the channel is complete.
        if channel.count == 0 {
            return false;
        }
        let (read, write, size) = (channel.read, channel.write, channel.size());
        let offset = read.wrapping_sub(RAM_BASE) as usize;
        if channel.is_plain_stream() && offset < RAM_BYTES && (write == SPI_DATA[0] || write == SPI_DATA[1]) {
            channel.step();
            let left = channel.count;
            let word =
                if size == 1 { u32::from(self.ram[offset]) } else { self.ram_load(offset, Width::Half) };
            self.spi[usize::from(write == SPI_DATA[1])].write_data((word & 0xffff) as u16, self.now);
            if left == 0 {
                self.dma.complete(index, self.now);
            }
            return true;
        }
        self.move_any_item(index, read, write, size)
    }

    #[inline(never)]
    fn move_any_item(&mut self, index: usize, read: u32, write: u32, size: u32) -> bool {
        let width = match size {
            1 => Width::Byte,
            2 => Width::Half,
            _ => Width::Word,
        };
        // The core pays nothing for what the DMA does, and may not reach SIO by it.
        let extra = self.extra;
        let loaded = if read >> 28 == 0xd { Err(BusError) } else { self.load(read, width) };
        let moved = loaded.map_err(|_| read).and_then(|value| {
            let value = self.dma.transform(index, value);
            self.dma.channels[index].step();
            let stored = match write >> 28 {
                0xd => Err(BusError),
                _ => self.store(write, width, value),
            };
            stored.map_err(|_| write)
        });
        self.extra = extra;
        if let Err(address) = moved {
            self.stop_for(format!("DMA channel {index} accesses {address:#010x}, where nothing answers"));
            return false;
        }
        if self.dma.channels[index].count == 0 && self.dma.channels[index].busy {
            self.dma.complete(index, self.now);
        }
        true
    }
}
