//! Decode: from the ten upper bits of an opcode to the instruction's name.
//!
//! Owns the encoding table. Ten bits tell all 16-bit instructions apart; operands are the executor's business. A table
//! and not a match on ranges: the executor then jumps once instead of comparing its way down.
//!
//! Source: ARMv6-M Architecture Reference Manual, A5.2 and A5.3.

/// Every instruction of ARMv6-M in one of its encodings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Instruction {
    LslImmediate,
    LsrImmediate,
    AsrImmediate,
    AddRegister,
    SubRegister,
    AddImmediate3,
    SubImmediate3,
    MovImmediate,
    CmpImmediate,
    AddImmediate8,
    SubImmediate8,
    And,
    Eor,
    LslRegister,
    LsrRegister,
    AsrRegister,
    Adc,
    Sbc,
    RorRegister,
    Tst,
    Rsb,
    CmpRegister,
    Cmn,
    Orr,
    Mul,
    Bic,
    Mvn,
    AddHigh,
    CmpHigh,
    MovHigh,
    Bx,
    Blx,
    LdrLiteral,
    StrRegister,
    StrhRegister,
    StrbRegister,
    LdrsbRegister,
    LdrRegister,
    LdrhRegister,
    LdrbRegister,
    LdrshRegister,
    StrImmediate,
    LdrImmediate,
    StrbImmediate,
    LdrbImmediate,
    StrhImmediate,
    LdrhImmediate,
    StrStack,
    LdrStack,
    Adr,
    AddFromStack,
    AddToStack,
    SubFromStack,
    Sxth,
    Sxtb,
    Uxth,
    Uxtb,
    Push,
    Cps,
    Rev,
    Rev16,
    Revsh,
    Pop,
    Bkpt,
    Hint,
    Stm,
    Ldm,
    Beq,
    Bne,
    Bcs,
    Bcc,
    Bmi,
    Bpl,
    Bvs,
    Bvc,
    Bhi,
    Bls,
    Bge,
    Blt,
    Bgt,
    Ble,
    Svc,
    B,
    /// BL, MSR, MRS and the barriers, told apart by the second halfword.
    Wide,
    Undefined,
}

use Instruction::*;

/// First and last value of the opcode's ten upper bits. What is not listed is undefined: 0x378 is UDF, 0x3A0 and 0x3E0
/// start 32-bit instructions that ARMv6-M does not have.
const ENCODINGS: [(usize, usize, Instruction); 84] = [
    (0x000, 0x01F, LslImmediate),
    (0x020, 0x03F, LsrImmediate),
    (0x040, 0x05F, AsrImmediate),
    (0x060, 0x067, AddRegister),
    (0x068, 0x06F, SubRegister),
    (0x070, 0x077, AddImmediate3),
    (0x078, 0x07F, SubImmediate3),
    (0x080, 0x09F, MovImmediate),
    (0x0A0, 0x0BF, CmpImmediate),
    (0x0C0, 0x0DF, AddImmediate8),
    (0x0E0, 0x0FF, SubImmediate8),
    (0x100, 0x100, And),
    (0x101, 0x101, Eor),
    (0x102, 0x102, LslRegister),
    (0x103, 0x103, LsrRegister),
    (0x104, 0x104, AsrRegister),
    (0x105, 0x105, Adc),
    (0x106, 0x106, Sbc),
    (0x107, 0x107, RorRegister),
    (0x108, 0x108, Tst),
    (0x109, 0x109, Rsb),
    (0x10A, 0x10A, CmpRegister),
    (0x10B, 0x10B, Cmn),
    (0x10C, 0x10C, Orr),
    (0x10D, 0x10D, Mul),
    (0x10E, 0x10E, Bic),
    (0x10F, 0x10F, Mvn),
    (0x110, 0x113, AddHigh),
    (0x114, 0x117, CmpHigh),
    (0x118, 0x11B, MovHigh),
    (0x11C, 0x11D, Bx),
    (0x11E, 0x11F, Blx),
    (0x120, 0x13F, LdrLiteral),
    (0x140, 0x147, StrRegister),
    (0x148, 0x14F, StrhRegister),
    (0x150, 0x157, StrbRegister),
    (0x158, 0x15F, LdrsbRegister),
    (0x160, 0x167, LdrRegister),
    (0x168, 0x16F, LdrhRegister),
    (0x170, 0x177, LdrbRegister),
    (0x178, 0x17F, LdrshRegister),
    (0x180, 0x19F, StrImmediate),
    (0x1A0, 0x1BF, LdrImmediate),
    (0x1C0, 0x1DF, StrbImmediate),
    (0x1E0, 0x1FF, LdrbImmediate),
    (0x200, 0x21F, StrhImmediate),
    (0x220, 0x23F, LdrhImmediate),
    (0x240, 0x25F, StrStack),
    (0x260, 0x27F, LdrStack),
    (0x280, 0x29F, Adr),
    (0x2A0, 0x2BF, AddFromStack),
    (0x2C0, 0x2C1, AddToStack),
    (0x2C2, 0x2C3, SubFromStack),
    (0x2C8, 0x2C8, Sxth),
    (0x2C9, 0x2C9, Sxtb),
    (0x2CA, 0x2CA, Uxth),
    (0x2CB, 0x2CB, Uxtb),
    (0x2D0, 0x2D7, Push),
    (0x2D9, 0x2D9, Cps),
    (0x2E8, 0x2E8, Rev),
    (0x2E9, 0x2E9, Rev16),
    (0x2EB, 0x2EB, Revsh),
    (0x2F0, 0x2F7, Pop),
    (0x2F8, 0x2FB, Bkpt),
    (0x2FC, 0x2FF, Hint),
    (0x300, 0x31F, Stm),
    (0x320, 0x33F, Ldm),
    (0x340, 0x343, Beq),
    (0x344, 0x347, Bne),
    (0x348, 0x34B, Bcs),
    (0x34C, 0x34F, Bcc),
    (0x350, 0x353, Bmi),
    (0x354, 0x357, Bpl),
    (0x358, 0x35B, Bvs),
    (0x35C, 0x35F, Bvc),
    (0x360, 0x363, Bhi),
    (0x364, 0x367, Bls),
    (0x368, 0x36B, Bge),
    (0x36C, 0x36F, Blt),
    (0x370, 0x373, Bgt),
    (0x374, 0x377, Ble),
    (0x37C, 0x37F, Svc),
    (0x380, 0x39F, B),
    (0x3C0, 0x3DF, Wide),
];

static TABLE: [Instruction; 1024] = table();

const fn table() -> [Instruction; 1024] {
    let mut table = [Undefined; 1024];
    let mut row = 0;
    while row < ENCODINGS.len() {
        let (first, last, instruction) = ENCODINGS[row];
        let mut bits = first;
        while bits <= last {
            assert!(matches!(table[bits], Undefined), "two rows claim the same opcode");
            table[bits] = instruction;
            bits += 1;
        }
        row += 1;
    }
    table
}

/// Name of the instruction that a halfword is or starts.
#[inline(always)]
pub(super) fn decode(opcode: u16) -> Instruction {
    TABLE[usize::from(opcode >> 6)]
}
