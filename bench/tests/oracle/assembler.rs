//! Opcodes by name: just enough of an assembler for the oracle's own code and cases.
//!
//! Source: ARMv6-M Architecture Reference Manual, A5.2. Shares nothing with the core's decoder.

/// Registers with names.
pub(crate) const SP: u16 = 13;
pub(crate) const LR: u16 = 14;
pub(crate) const PC: u16 = 15;

/// MRS and MSR numbers.
pub(crate) const APSR: u16 = 0;
pub(crate) const XPSR: u16 = 3;
pub(crate) const IPSR: u16 = 5;
pub(crate) const MSP: u16 = 8;
pub(crate) const PSP: u16 = 9;
pub(crate) const PRIMASK: u16 = 16;
pub(crate) const CONTROL: u16 = 20;

pub(crate) const NOP: u16 = 0xBF00;
pub(crate) const CPSIE: u16 = 0xB662;
pub(crate) const CPSID: u16 = 0xB672;
pub(crate) const SEMIHOSTING: u16 = 0xBEAB;

pub(crate) const fn movs_imm(d: u16, imm8: u16) -> u16 {
    0x2000 | d << 8 | imm8
}
pub(crate) const fn adds_imm(d: u16, imm8: u16) -> u16 {
    0x3000 | d << 8 | imm8
}
pub(crate) const fn subs_imm(d: u16, imm8: u16) -> u16 {
    0x3800 | d << 8 | imm8
}
pub(crate) const fn lsls_imm(d: u16, m: u16, imm5: u16) -> u16 {
    imm5 << 6 | m << 3 | d
}
pub(crate) const fn lsrs_imm(d: u16, m: u16, imm5: u16) -> u16 {
    0x0800 | imm5 << 6 | m << 3 | d
}
pub(crate) const fn tst(n: u16, m: u16) -> u16 {
    0x4200 | m << 3 | n
}
pub(crate) const fn orrs(d: u16, m: u16) -> u16 {
    0x4300 | m << 3 | d
}
pub(crate) const fn mov(d: u16, m: u16) -> u16 {
    0x4600 | (d & 8) << 4 | m << 3 | d & 7
}
pub(crate) const fn bx(m: u16) -> u16 {
    0x4700 | m << 3
}
pub(crate) const fn blx(m: u16) -> u16 {
    0x4780 | m << 3
}
pub(crate) const fn ldr(t: u16, n: u16, offset: u16) -> u16 {
    0x6800 | (offset / 4) << 6 | n << 3 | t
}
pub(crate) const fn str(t: u16, n: u16, offset: u16) -> u16 {
    0x6000 | (offset / 4) << 6 | n << 3 | t
}
pub(crate) const fn str_sp(t: u16, offset: u16) -> u16 {
    0x9000 | t << 8 | (offset / 4)
}
pub(crate) const fn ldm(n: u16, list: u16) -> u16 {
    0xC800 | n << 8 | list
}
pub(crate) const fn stm(n: u16, list: u16) -> u16 {
    0xC000 | n << 8 | list
}
/// `offset` counts from the instruction's own address.
pub(crate) const fn branch(offset: i32) -> u16 {
    0xE000 | (((offset - 4) >> 1) & 0x7FF) as u16
}
/// `offset` counts from the instruction's own address.
pub(crate) const fn branch_if(condition: u16, offset: i32) -> u16 {
    0xD000 | condition << 8 | (((offset - 4) >> 1) & 0xFF) as u16
}
pub(crate) const EQ: u16 = 0;

/// `offset` counts from the instruction's own address.
pub(crate) const fn bl(offset: i32) -> [u16; 2] {
    let offset = (offset - 4) as u32;
    let sign = offset >> 24 & 1;
    let j1 = !(offset >> 23 ^ sign) & 1;
    let j2 = !(offset >> 22 ^ sign) & 1;
    let first = 0xF000 | sign << 10 | offset >> 12 & 0x3FF;
    let second = 0xD000 | j1 << 13 | j2 << 11 | offset >> 1 & 0x7FF;
    [first as u16, second as u16]
}
pub(crate) const fn mrs(d: u16, special: u16) -> [u16; 2] {
    [0xF3EF, 0x8000 | d << 8 | special]
}
pub(crate) const fn msr(special: u16, n: u16) -> [u16; 2] {
    [0xF380 | n, 0x8800 | special]
}

/// Code at an address, with constants collected behind it.
pub(crate) struct Program {
    base: u32,
    halfwords: Vec<u16>,
    constants: Vec<(usize, u16, u32)>,
}

impl Program {
    pub(crate) fn at(base: u32) -> Self {
        Self { base, halfwords: Vec::new(), constants: Vec::new() }
    }

    pub(crate) fn emit(&mut self, code: &[u16]) -> &mut Self {
        self.halfwords.extend_from_slice(code);
        self
    }

    /// Loads a constant from the pool behind the code.
    pub(crate) fn constant(&mut self, t: u16, value: u32) -> &mut Self {
        self.constants.push((self.halfwords.len(), t, value));
        self.emit(&[0])
    }

    pub(crate) fn here(&self) -> u32 {
        self.base + 2 * self.halfwords.len() as u32
    }

    pub(crate) fn finish(mut self) -> Vec<u16> {
        if !self.here().is_multiple_of(4) {
            self.halfwords.push(NOP);
        }
        for (at, t, value) in std::mem::take(&mut self.constants) {
            let pc = (self.base + 2 * at as u32 + 4) & !3;
            let offset = (self.here() - pc) / 4;
            assert!(offset < 256, "the constant pool is out of reach");
            self.halfwords[at] = 0x4800 | t << 8 | offset as u16;
            self.emit(&[value as u16, (value >> 16) as u16]);
        }
        self.halfwords
    }
}
