//! Instruction codes and flag bits of the MCP2515.
//!
//! Addresses come from the `mcp2515` crate; here are only the instructions and the bits that this driver uses.
//! Source: DS20001801, table 12-1 (instructions) and the register named in each line.

pub use mcp2515::regs::Register;

/// Resets the chip and enters configuration mode (RESET, table 12-1).
pub const RESET: u8 = 0xC0;
/// Reads registers from an address on (READ, table 12-1).
pub const READ: u8 = 0x03;
/// Writes registers from an address on (WRITE, table 12-1).
pub const WRITE: u8 = 0x02;
/// Changes single bits of some registers (BIT MODIFY, table 12-1).
pub const BIT_MODIFY: u8 = 0x05;
/// Loads transmit buffer 0 from TXB0SIDH on (LOAD TX BUFFER, abc = 000, figure 12-5).
pub const LOAD_TX0: u8 = 0x40;
/// Requests transmission of buffer 0 (RTS, table 12-1).
pub const RTS_TX0: u8 = 0x81;
/// Reads receive buffer 0 from RXB0SIDH on and clears RX0IF (READ RX BUFFER, nm = 00, figure 12-3).
pub const READ_RX0: u8 = 0x90;
/// Reads receive buffer 1 from RXB1SIDH on and clears RX1IF (READ RX BUFFER, nm = 10, figure 12-3).
pub const READ_RX1: u8 = 0x94;
/// Reads receive and transmit flags (READ STATUS, figure 12-8).
pub const READ_STATUS: u8 = 0xA0;
/// Reads which receive buffers are full (RX STATUS, figure 12-9).
pub const RX_STATUS: u8 = 0xB0;

/// Receive buffer 0 full, in the answer to RX STATUS (figure 12-9).
pub const RX_STATUS_RX0: u8 = 1 << 6;
/// Receive buffer 1 full, in the answer to RX STATUS (figure 12-9).
pub const RX_STATUS_RX1: u8 = 1 << 7;
/// Transmit buffer 0 still waits or sends, in the answer to READ STATUS (TXREQ, figure 12-8).
pub const READ_STATUS_TX0REQ: u8 = 1 << 2;

/// Receive buffer 0 full (CANINTF.RX0IF, CANINTE.RX0IE, register 7-2).
pub const RX0IF: u8 = 1 << 0;
/// Receive buffer 1 full (CANINTF.RX1IF, CANINTE.RX1IE, register 7-2).
pub const RX1IF: u8 = 1 << 1;
/// EFLG has something to say (CANINTF.ERRIF, CANINTE.ERRIE, register 7-2).
pub const ERRIF: u8 = 1 << 5;
/// A frame with an error was on the bus (CANINTF.MERRF, register 7-2).
pub const MERRF: u8 = 1 << 7;

/// Receive error counter >= 96 or transmit error counter >= 96 (EFLG.EWARN, register 6-3).
pub const EWARN: u8 = 1 << 0;
/// Receive error counter >= 128 (EFLG.RXEP, register 6-3).
pub const RXEP: u8 = 1 << 3;
/// Transmit error counter >= 128 (EFLG.TXEP, register 6-3).
pub const TXEP: u8 = 1 << 4;
/// Transmit error counter has passed 255 (EFLG.TXBO, register 6-3).
pub const TXBO: u8 = 1 << 5;
/// A frame for receive buffer 0 was lost (EFLG.RX0OVR, register 6-3).
pub const RX0OVR: u8 = 1 << 6;
/// A frame for receive buffer 1 was lost (EFLG.RX1OVR, register 6-3).
pub const RX1OVR: u8 = 1 << 7;

/// Extended identifier (RXBnSIDL.IDE and TXBnSIDL.EXIDE, registers 4-5 and 3-4).
pub const IDE: u8 = 1 << 3;
/// Remote frame with an 11-bit identifier (RXBnSIDL.SRR, register 4-5).
pub const SRR: u8 = 1 << 4;
/// Remote frame with a 29-bit identifier (RXBnDLC.RTR, register 4-8).
pub const RTR: u8 = 1 << 6;
/// Data length code (RXBnDLC.DLC, register 4-8).
pub const DLC: u8 = 0x0F;

/// Transmission requested (TXBnCTRL.TXREQ, register 3-1).
pub const TXREQ: u8 = 1 << 3;

/// Receive buffer operating mode: 00 = masks and filters (RXBnCTRL.RXM, registers 4-1 and 4-2).
pub const RXM: u8 = 0b11 << 5;
/// A frame for a full RXB0 goes into RXB1 (RXB0CTRL.BUKT, register 4-1).
pub const BUKT: u8 = 1 << 2;

/// Requested operation mode (CANCTRL.REQOP, register 10-1).
pub const REQOP: u8 = 0b111 << 5;
/// CLKOUT divisor, as after a reset; without CLKEN of no effect (CANCTRL.CLKPRE, register 10-1). Not zero, so that a
/// MISO line that is stuck low cannot be taken for a chip in normal mode.
pub const CLKPRE: u8 = 0b11;
/// Operation mode (CANSTAT.OPMOD, register 10-2).
pub const OPMOD: u8 = 0xE0;
/// Bits of CANCTRL whose value after a reset is known: no abort or one-shot pending, CLKOUT on (register 10-1).
pub const CANCTRL_PROBE: u8 = 0x17;
/// Value of the [`CANCTRL_PROBE`] bits after a reset.
pub const CANCTRL_AFTER_RESET: u8 = 0x07;
/// Configuration mode as CANSTAT shows it (OPMOD = 100).
pub const OPMOD_CONFIGURATION: u8 = 0x80;
/// Normal mode as CANSTAT shows it (OPMOD = 000).
pub const OPMOD_NORMAL: u8 = 0x00;
/// Loopback mode as CANSTAT shows it (OPMOD = 010).
pub const OPMOD_LOOPBACK: u8 = 0x40;
/// Listen-only mode as CANSTAT shows it (OPMOD = 011).
pub const OPMOD_LISTEN_ONLY: u8 = 0x60;
