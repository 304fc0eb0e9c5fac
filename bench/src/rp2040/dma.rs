//! DMA: registers, triggers, chaining, pacing and the sniffer of twelve channels.
//!
//! Owns the state of each channel and says which transfer comes next; the engine moves the data. A channel that a
//! peripheral paces moves as soon as the peripheral asks; an unpaced channel moves one item per cycle of clk_sys; a
//! pacing timer grants X items per Y cycles.
//!
//! Source: RP2040 datasheet 2.5.
//!
//! Not modelled: arbitration between channels (each has the bus to itself), contention with the CPU, latency of the
//! address and data FIFOs, priorities, bus errors (an access to nothing stops the run instead of setting AHB_ERROR).

const NEVER: u64 = u64::MAX;
/// Number of channels.
pub(super) const CHANNELS: usize = 12;
/// TREQ of an unpaced transfer.
pub(super) const TREQ_PERMANENT: u32 = 0x3f;
/// TREQ of pacing timer 0; three more follow.
pub(super) const TREQ_TIMER: u32 = 0x3b;

const CTRL_ENABLE: u32 = 1 << 0;
const CTRL_QUIET: u32 = 1 << 21;
const CTRL_BSWAP: u32 = 1 << 22;
const CTRL_SNIFF: u32 = 1 << 23;
const CTRL_BUSY: u32 = 1 << 24;
const CTRL_WRITABLE: u32 = 0x00ff_ffff;

#[derive(Clone, Copy, Debug)]
pub(super) struct Channel {
    pub(super) read: u32,
    pub(super) write: u32,
    pub(super) count: u32,
    reload: u32,
    ctrl: u32,
    pub(super) busy: bool,
}

impl Channel {
    fn new(index: u32) -> Self {
        Self { read: 0, write: 0, count: 0, reload: 0, ctrl: index << 11, busy: false }
    }

    /// The request that paces this channel.
    #[inline]
    pub(super) fn treq(&self) -> u32 {
        self.ctrl >> 15 & 0x3f
    }

    /// Bytes per item: 1, 2 or 4.
    #[inline]
    pub(super) fn size(&self) -> u32 {
        1 << (self.ctrl >> 2 & 3).min(2)
    }

    /// Whether items go from plain memory to one address with nothing done to them.
    #[inline]
    pub(super) fn is_plain_stream(&self) -> bool {
        // INCR_READ set; INCR_WRITE, RING_SIZE, BSWAP and SNIFF_EN clear
        self.ctrl & (1 << 4 | 1 << 5 | 0xf << 6 | CTRL_BSWAP | CTRL_SNIFF) == 1 << 4
    }

    /// Moves on by one item.
    #[inline]
    pub(super) fn step(&mut self) {
        let size = self.size();
        let ring = self.ctrl >> 6 & 0xf;
        let ring_on_write = self.ctrl & 1 << 10 != 0;
        let advance = |address: u32, wraps: bool| {
            let next = address.wrapping_add(size);
            if ring == 0 || !wraps {
                return next;
            }
            let mask = (1u32 << ring) - 1;
            address & !mask | next & mask
        };
        if self.ctrl & 1 << 4 != 0 {
            self.read = advance(self.read, !ring_on_write);
        }
        if self.ctrl & 1 << 5 != 0 {
            self.write = advance(self.write, ring_on_write);
        }
        self.count -= 1;
    }
}

#[derive(Clone, Debug)]
pub(super) struct Dma {
    pub(super) channels: [Channel; CHANNELS],
    /// Bit n = channel n is busy.
    pub(super) active: u32,
    raw: u32,
    enable: [u32; 2],
    force: [u32; 2],
    timers: [u32; 4],
    timer_bases: [(u64, u64); 4],
    sniff_ctrl: u32,
    sniff_data: u32,
    /// Cycle up to which unpaced channels have moved.
    pub(super) unpaced_at: u64,
    pub(super) next_event: u64,
}

impl Dma {
    pub(super) fn new() -> Self {
        Self {
            channels: [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11].map(Channel::new),
            active: 0,
            raw: 0,
            enable: [0; 2],
            force: [0; 2],
            timers: [0; 4],
            timer_bases: [(0, 0); 4],
            sniff_ctrl: 0,
            sniff_data: 0,
            unpaced_at: 0,
            next_event: NEVER,
        }
    }

    /// Levels of DMA_IRQ_0 and DMA_IRQ_1.
    #[inline]
    pub(super) fn irqs(&self) -> u32 {
        let line = |i: usize| u32::from(self.raw & self.enable[i] | self.force[i] != 0);
        line(0) | line(1) << 1
    }

    /// Starts channel `index` if it is enabled.
    fn trigger(&mut self, index: usize, now: u64) {
        let channel = &mut self.channels[index];
        if channel.ctrl & CTRL_ENABLE == 0 || channel.busy {
            return;
        }
        channel.busy = true;
        channel.count = channel.reload;
        let treq = channel.treq();
        let empty = channel.count == 0;
        self.active |= 1 << index;
        if empty {
            self.complete(index, now);
            return;
        }
        if treq == TREQ_PERMANENT && self.unpaced_channels() == 1 << index {
            self.unpaced_at = now;
        }
        if (TREQ_TIMER..TREQ_PERMANENT).contains(&treq) {
            self.timer_bases[(treq - TREQ_TIMER) as usize] = (now, 0);
        }
    }

    /// Channels in flight that nothing paces.
    pub(super) fn unpaced_channels(&self) -> u32 {
        self.with_treq(TREQ_PERMANENT)
    }

    /// Channels in flight on request `treq`.
    #[inline]
    pub(super) fn with_treq(&self, treq: u32) -> u32 {
        let (mut left, mut found) = (self.active, 0);
        while left != 0 {
            let index = left.trailing_zeros();
            left &= left - 1;
            if self.channels[index as usize].treq() == treq {
                found |= 1 << index;
            }
        }
        found
    }

    /// The last item of `index` has been moved: interrupt and chain.
    pub(super) fn complete(&mut self, index: usize, now: u64) {
        let mut index = index;
        // A ring of chained empty channels would spin for ever; one lap is enough to raise every flag.
        for _ in 0..CHANNELS {
            let channel = &mut self.channels[index];
            channel.busy = false;
            self.active &= !(1 << index);
            let ctrl = channel.ctrl;
            if ctrl & CTRL_QUIET == 0 {
                self.raw |= 1 << index;
            }
            let next = (ctrl >> 11 & 0xf) as usize;
            if next == index || next >= CHANNELS {
                return;
            }
            let chained = &self.channels[next];
            if chained.ctrl & CTRL_ENABLE == 0 || chained.busy {
                return;
            }
            if chained.reload != 0 {
                self.trigger(next, now);
                return;
            }
            index = next;
        }
    }

    /// Items that pacing timer `timer` has granted since its channel started, and the cycle of the next grant.
    pub(super) fn timer_grants(&self, timer: usize, now: u64) -> (u64, u64) {
        let (x, y) = (u64::from(self.timers[timer] >> 16), u64::from(self.timers[timer] & 0xffff));
        if x == 0 || y == 0 {
            return (0, NEVER);
        }
        let (base, used) = self.timer_bases[timer];
        let granted = (now - base) * x / y;
        (granted.saturating_sub(used), base + ((granted + 1) * y).div_ceil(x))
    }

    /// Counts `items` grants of pacing timer `timer` as used.
    pub(super) fn use_grants(&mut self, timer: usize, items: u64) {
        self.timer_bases[timer].1 += items;
    }

    /// Applies byte swap and sniffer of channel `index` to an item.
    pub(super) fn transform(&mut self, index: usize, value: u32) -> u32 {
        let channel = &self.channels[index];
        let value = match (channel.ctrl & CTRL_BSWAP != 0, channel.size()) {
            (true, 2) => u32::from((value & 0xffff) as u16).swap_bytes() >> 16,
            (true, 4) => value.swap_bytes(),
            _ => value,
        };
        if channel.ctrl & CTRL_SNIFF != 0
            && self.sniff_ctrl & 1 != 0
            && self.sniff_ctrl >> 1 & 0xf == index as u32
        {
            let size = channel.size();
            self.sniff(value, size);
        }
        value
    }

    fn sniff(&mut self, value: u32, size: u32) {
        let value = match (self.sniff_ctrl & 1 << 9 != 0, size) {
            (true, 2) => value.swap_bytes() >> 16,
            (true, 4) => value.swap_bytes(),
            _ => value,
        };
        let bits = 8 * size;
        self.sniff_data = match self.sniff_ctrl >> 5 & 0xf {
            0x0 | 0x1 => {
                let reversed = self.sniff_ctrl >> 5 & 1 != 0;
                let mut crc = self.sniff_data;
                for byte in value.to_le_bytes().into_iter().take(size as usize) {
                    let byte = if reversed { byte.reverse_bits() } else { byte };
                    crc ^= u32::from(byte) << 24;
                    for _ in 0..8 {
                        crc = crc << 1 ^ if crc >> 31 != 0 { 0x04c1_1db7 } else { 0 };
                    }
                }
                crc
            }
            0x2 | 0x3 => {
                let reversed = self.sniff_ctrl >> 5 & 1 != 0;
                let mut crc = (self.sniff_data & 0xffff) as u16;
                for byte in value.to_le_bytes().into_iter().take(size as usize) {
                    let byte = if reversed { byte.reverse_bits() } else { byte };
                    crc ^= u16::from(byte) << 8;
                    for _ in 0..8 {
                        crc = crc << 1 ^ if crc >> 15 != 0 { 0x1021 } else { 0 };
                    }
                }
                u32::from(crc)
            }
            0xe => self.sniff_data ^ (value & mask(bits)).count_ones() & 1,
            0xf => self.sniff_data.wrapping_add(value & mask(bits)),
            _ => self.sniff_data,
        };
    }

    fn sniff_result(&self) -> u32 {
        let data =
            if self.sniff_ctrl & 1 << 10 != 0 { self.sniff_data.reverse_bits() } else { self.sniff_data };
        if self.sniff_ctrl & 1 << 11 != 0 { !data } else { data }
    }

    pub(super) fn read(&self, offset: u32) -> Option<u32> {
        if offset < 0x300 {
            let channel = &self.channels[offset as usize / 0x40];
            return Some(match field(offset % 0x40) {
                Field::Read => channel.read,
                Field::Write => channel.write,
                Field::Count => channel.count,
                Field::Ctrl => channel.ctrl | if channel.busy { CTRL_BUSY } else { 0 },
            });
        }
        let status = |i: usize| self.raw & self.enable[i] | self.force[i];
        Some(match offset {
            0x400 => self.raw,
            0x404 => self.enable[0],
            0x408 => self.force[0],
            0x40c => status(0),
            0x414 => self.enable[1],
            0x418 => self.force[1],
            0x41c => status(1),
            0x420..=0x42c => self.timers[(offset as usize - 0x420) / 4],
            0x430 | 0x440 | 0x444 => 0,
            0x434 => self.sniff_ctrl,
            0x438 => self.sniff_result(),
            0x448 => CHANNELS as u32,
            0x800..=0xac4 => match offset % 0x40 {
                0 => 0,
                4 => self.channels[(offset as usize - 0x800) / 0x40].reload,
                _ => return None,
            },
            _ => return None,
        })
    }

    pub(super) fn write(&mut self, offset: u32, value: u32, now: u64) -> Option<()> {
        if offset < 0x300 {
            let index = offset as usize / 0x40;
            let channel = &mut self.channels[index];
            match field(offset % 0x40) {
                Field::Read => channel.read = value,
                Field::Write => channel.write = value,
                Field::Count => channel.reload = value,
                Field::Ctrl => channel.ctrl = value & CTRL_WRITABLE,
            }
            // The last register of each alias triggers, unless what is written is zero (a null trigger).
            if offset % 0x10 == 0xc {
                if value != 0 {
                    self.trigger(index, now);
                } else if channel.ctrl & CTRL_QUIET != 0 {
                    self.raw |= 1 << index;
                }
            }
            return Some(());
        }
        match offset {
            0x400 | 0x40c | 0x41c => self.raw &= !value,
            0x404 => self.enable[0] = value & 0xffff,
            0x408 => self.force[0] = value & 0xffff,
            0x414 => self.enable[1] = value & 0xffff,
            0x418 => self.force[1] = value & 0xffff,
            0x420..=0x42c => self.timers[(offset as usize - 0x420) / 4] = value,
            0x430 => {
                for index in 0..CHANNELS {
                    if value & 1 << index != 0 {
                        self.trigger(index, now);
                    }
                }
            }
            0x434 => self.sniff_ctrl = value & 0xfff,
            0x438 => self.sniff_data = value,
            0x444 => {
                for index in 0..CHANNELS {
                    if value & 1 << index != 0 {
                        self.channels[index].busy = false;
                        self.active &= !(1 << index);
                    }
                }
            }
            0x440 | 0x448 => {}
            0x800..=0xac4 if offset.is_multiple_of(0x40) => {}
            _ => return None,
        }
        Some(())
    }
}

#[derive(Clone, Copy)]
enum Field {
    Read,
    Write,
    Count,
    Ctrl,
}

/// Which field a channel offset addresses: the four aliases order them differently.
fn field(offset: u32) -> Field {
    use Field::{Count, Ctrl, Read, Write};
    const LAYOUT: [[Field; 4]; 4] = [
        [Read, Write, Count, Ctrl],
        [Ctrl, Read, Write, Count],
        [Ctrl, Count, Read, Write],
        [Ctrl, Write, Count, Read],
    ];
    LAYOUT[offset as usize / 0x10][offset as usize / 4 % 4]
}

fn mask(bits: u32) -> u32 {
    if bits >= 32 { u32::MAX } else { (1 << bits) - 1 }
}
