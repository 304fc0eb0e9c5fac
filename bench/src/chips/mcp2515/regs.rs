//! MCP2515 register map: addresses, bits, reset values, who may write what.
//!
//! Source: Microchip DS20001801J, chapter 11 (map, bit-modifiable registers) and the register descriptions named below.

/// Number of registers; the address has seven bits.
pub(super) const COUNT: usize = 128;

/// Register 4-3: pin function of RX0BF and RX1BF. BFPCTRL
pub(super) const BFPCTRL: u8 = 0x0C;
/// Register 3-2: pin function of TXnRTS. TXRTSCTRL
pub(super) const TXRTSCTRL: u8 = 0x0D;
/// Register 10-2: operating mode and pending interrupt, at every xE. CANSTAT
pub(super) const CANSTAT: u8 = 0x0E;
/// Register 10-1: mode request, abort all, one-shot, clock out, at every xF. CANCTRL
pub(super) const CANCTRL: u8 = 0x0F;
/// Register 6-1: transmit error counter. TEC
pub(super) const TEC: u8 = 0x1C;
/// Register 6-2: receive error counter. REC
pub(super) const REC: u8 = 0x1D;
/// Register 5-3: phase segment 2. CNF3
pub(super) const CNF3: u8 = 0x28;
/// Register 5-2: phase segment 1, propagation segment. CNF2
pub(super) const CNF2: u8 = 0x29;
/// Register 5-1: prescaler, jump width. CNF1
pub(super) const CNF1: u8 = 0x2A;
/// Register 7-1: interrupt enables. CANINTE
pub(super) const CANINTE: u8 = 0x2B;
/// Register 7-2: interrupt flags. CANINTF
pub(super) const CANINTF: u8 = 0x2C;
/// Register 6-3: error flags. EFLG
pub(super) const EFLG: u8 = 0x2D;
/// First mask register; the second mask follows four bytes later. RXM0SIDH
pub(super) const RXM0SIDH: u8 = 0x20;
/// Register 3-1: control registers of the three transmit buffers; the frame starts one byte behind. TXBnCTRL
pub(super) const TXBCTRL: [u8; 3] = [0x30, 0x40, 0x50];
/// Registers 4-1 and 4-2: control registers of the two receive buffers; the frame starts one byte behind. RXBnCTRL
pub(super) const RXBCTRL: [u8; 2] = [0x60, 0x70];
/// First bytes of the six filters. RXFnSIDH
pub(super) const RXFSIDH: [u8; 6] = [0x00, 0x04, 0x08, 0x10, 0x14, 0x18];

/// CANCTRL.ABAT: abort all pending transmissions.
pub(super) const ABAT: u8 = 1 << 4;
/// CANCTRL.OSM: one-shot mode.
pub(super) const OSM: u8 = 1 << 3;
/// CANCTRL after reset: configuration mode, clock out enabled at a divisor of eight.
pub(super) const CANCTRL_RESET: u8 = 0x87;

/// CANINTF/CANINTE.MERR.
pub(super) const MERR: u8 = 1 << 7;
/// CANINTF/CANINTE.ERR.
pub(super) const ERR: u8 = 1 << 5;
/// CANINTF/CANINTE.TX0; TX1 and TX2 are the next bits up.
pub(super) const TX0: u8 = 1 << 2;
/// CANINTF/CANINTE.RX0; RX1 is the next bit up.
pub(super) const RX0: u8 = 1 << 0;

/// TXBnCTRL.ABTF: aborted.
pub(super) const ABTF: u8 = 1 << 6;
/// TXBnCTRL.MLOA: lost arbitration.
pub(super) const MLOA: u8 = 1 << 5;
/// TXBnCTRL.TXERR: met a bus error.
pub(super) const TXERR: u8 = 1 << 4;
/// TXBnCTRL.TXREQ: pending.
pub(super) const TXREQ: u8 = 1 << 3;
/// TXBnCTRL.TXP: priority.
pub(super) const TXP: u8 = 0b11;

/// RXB0CTRL.BUKT: rollover into RXB1.
pub(super) const BUKT: u8 = 1 << 2;
/// RXB0CTRL.BUKT1: read-only copy of BUKT.
pub(super) const BUKT1: u8 = 1 << 1;
/// RXBnCTRL.RXRTR: the buffer holds a remote frame.
pub(super) const RXRTR: u8 = 1 << 3;

/// EFLG.RX0OVR; RX1OVR is the next bit up.
pub(super) const RX0OVR: u8 = 1 << 6;
/// EFLG.TXBO, TXEP, RXEP, TXWAR, RXWAR, EWARN.
pub(super) const TXBO: u8 = 1 << 5;
pub(super) const TXEP: u8 = 1 << 4;
pub(super) const RXEP: u8 = 1 << 3;
pub(super) const TXWAR: u8 = 1 << 2;
pub(super) const RXWAR: u8 = 1 << 1;
pub(super) const EWARN: u8 = 1 << 0;
/// The bits of EFLG that follow the error counters.
pub(super) const EFLG_STATE: u8 = 0x3F;

/// What a write to a register may do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Access {
    /// The bits of the mask, at any time.
    Write(u8),
    /// The bits of the mask, in configuration mode only.
    Configuration(u8),
    /// The bits of the mask, while transmit buffer n has no request pending.
    Transmit(usize, u8),
    /// Nothing.
    ReadOnly,
}

/// The one register behind the copies at xE and xF.
pub(super) const fn canonical(address: u8) -> u8 {
    match address & 0x7F {
        low if low & 0x0F >= 0x0E => low & 0x0F,
        low => low,
    }
}

/// What a write to `address` (canonical) may do.
pub(super) const fn access(address: u8) -> Access {
    match (address >> 4, address & 0x0F) {
        (0, 0x0C) => Access::Write(0x3F),                           // BFPCTRL
        (0, 0x0D) => Access::Configuration(0x07),                   // TXRTSCTRL
        (0, 0x0F) => Access::Write(0xFF),                           // CANCTRL
        (0, 0x0E) | (1, 0x0C | 0x0D) => Access::ReadOnly,           // CANSTAT, TEC, REC
        (0 | 1, 0x01 | 0x05 | 0x09) => Access::Configuration(0xEB), // RXFnSIDL
        (0 | 1, _) => Access::Configuration(0xFF),                  // RXFn
        (2, 0x01 | 0x05) => Access::Configuration(0xE3),            // RXMnSIDL
        (2, 0x00..=0x07) => Access::Configuration(0xFF),            // RXMn
        (2, 0x08) => Access::Configuration(0xC7),                   // CNF3
        (2, 0x09 | 0x0A) => Access::Configuration(0xFF),            // CNF2, CNF1
        (2, 0x0B | 0x0C) => Access::Write(0xFF),                    // CANINTE, CANINTF
        (2, _) => Access::Write(0xC0),                              // EFLG
        (3..=5, 0x00) => Access::Write(TXREQ | TXP),
        (bank @ 3..=5, 0x02) => Access::Transmit(bank as usize - 3, 0xEB), // TXBnSIDL
        (bank @ 3..=5, 0x05) => Access::Transmit(bank as usize - 3, 0x4F), // TXBnDLC
        (bank @ 3..=5, _) => Access::Transmit(bank as usize - 3, 0xFF),
        (6, 0x00) => Access::Write(0x64), // RXB0CTRL: RXM, BUKT
        (7, 0x00) => Access::Write(0x60), // RXB1CTRL: RXM
        _ => Access::ReadOnly,            // RXBn
    }
}

/// Whether BIT MODIFY heeds its mask at `address` (canonical); elsewhere the mask becomes FFh.
pub(super) const fn is_bit_modifiable(address: u8) -> bool {
    matches!(address, BFPCTRL | TXRTSCTRL | CANCTRL | CNF3..=EFLG | 0x30 | 0x40 | 0x50 | 0x60 | 0x70)
}

/// Whether `address` (canonical) is a mask or filter, which read as zero outside configuration mode.
pub(super) const fn is_acceptance(address: u8) -> bool {
    matches!(address, 0x00..=0x0B | 0x10..=0x1B | 0x20..=0x27)
}

/// Register contents after reset. What the datasheet calls unknown is noise, the same in every run.
pub(super) fn reset_values() -> [u8; COUNT] {
    let mut values = [0; COUNT];
    let mut noise = 0x2515_CA7F_u32;
    for (address, value) in (0u8..).zip(values.iter_mut()) {
        noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let mask = match access(canonical(address)) {
            Access::Transmit(_, mask) => mask,
            Access::Configuration(mask) if is_acceptance(address) && address < RXM0SIDH => mask,
            Access::ReadOnly if address > 0x60 => 0xFF,
            _ => 0,
        };
        *value = (noise >> 24) as u8 & mask;
    }
    values[usize::from(CANCTRL)] = CANCTRL_RESET;
    values
}
