//! The oracle's cases: every ARMv6-M encoding on edge operands and fixed random ones.
//!
//! Each family walks the opcode space by its upper ten bits, so that the coverage check can be exact. What ARMv6-M
//! leaves UNPREDICTABLE is not asked: two witnesses may differ there and both be right.

use super::assembler::*;
use super::layout::{CASE_STACK, SNIPPET, STUB, TAIL, WINDOW, WINDOW_PADS, WINDOW_WORDS};

const EDGES: [u32; 10] = [0, 1, 2, 31, 32, 33, 0x7FFF_FFFF, 0x8000_0000, 0x8000_0001, u32::MAX];
/// Smaller set, for families with many encodings.
const SHORT_EDGES: [u32; 5] = [0, 1, 0x7FFF_FFFF, 0x8000_0000, u32::MAX];
/// An address that neither machine maps.
const UNMAPPED: u32 = 0x3000_0000;
const BYTE: u32 = 1;
const HALF: u32 = 2;
const WORD: u32 = 4;

/// Fixed pseudo-random numbers (SplitMix64).
pub(crate) struct Numbers(u64);

impl Numbers {
    pub(crate) const fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn word(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ z >> 31) >> 32) as u32
    }

    /// Less than `limit`.
    pub(crate) fn below(&mut self, limit: u32) -> u32 {
        self.word() % limit
    }

    /// An edge operand or a random word.
    fn operand(&mut self) -> u32 {
        match self.below(3) {
            0 => self.word(),
            _ => EDGES[self.below(EDGES.len() as u32) as usize],
        }
    }

    fn flags(&mut self) -> u32 {
        self.word() & 0xF000_0000
    }
}

/// A snippet and the registers it starts from.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) code: Vec<u16>,
    /// r0 to r7.
    pub(crate) low: [u32; 8],
    /// r8, r9, r12, LR.
    pub(crate) high: [u32; 4],
    pub(crate) sp: u32,
    pub(crate) apsr: u32,
}

impl Case {
    /// The snippet, filled up with NOPs.
    pub(crate) fn halfwords(&self) -> [u16; SNIPPET] {
        assert!(self.code.len() <= SNIPPET, "{}: the snippet is too long", self.name);
        std::array::from_fn(|at| self.code.get(at).copied().unwrap_or(NOP))
    }

    /// In the order in which the harness loads them.
    pub(crate) fn start_state(&self) -> Vec<u32> {
        let mut words = self.high.to_vec();
        words.extend([self.sp, self.apsr]);
        words.extend(self.low);
        words
    }

    /// First halfwords of the snippet's instructions.
    pub(crate) fn opcodes(&self) -> Vec<u16> {
        let mut opcodes = Vec::new();
        let mut rest = self.code.iter();
        while let Some(&opcode) = rest.next() {
            opcodes.push(opcode);
            if opcode >> 11 >= 0b11101 {
                rest.next();
            }
        }
        opcodes
    }
}

/// Collects cases; each starts from fresh random registers.
struct Collection {
    cases: Vec<Case>,
    numbers: Numbers,
}

impl Collection {
    fn push(&mut self, name: &str, code: &[u16], adjust: impl FnOnce(&mut Case)) {
        let numbers = &mut self.numbers;
        let mut case = Case {
            name: format!("{name} {code:04x?}"),
            code: code.to_vec(),
            low: std::array::from_fn(|_| numbers.operand()),
            high: std::array::from_fn(|_| numbers.operand()),
            sp: CASE_STACK + 4 * numbers.below(2),
            apsr: numbers.flags(),
        };
        adjust(&mut case);
        self.cases.push(case);
    }

    /// A case whose snippet branches into the landing pads: all low registers lead to the tail.
    fn push_branch(&mut self, name: &str, code: &[u16], adjust: impl FnOnce(&mut Case)) {
        self.push(name, code, |case| {
            case.low = [TAIL | 1; 8];
            adjust(case);
        });
    }

    fn below(&mut self, limit: u32) -> u16 {
        self.numbers.below(limit) as u16
    }

    fn low(&mut self) -> u16 {
        self.below(8)
    }
}

/// All cases, always the same.
pub(crate) fn all() -> Vec<Case> {
    let mut c = Collection { cases: Vec::new(), numbers: Numbers::new(0x5EED) };
    shifts_and_sums(&mut c);
    data_processing(&mut c);
    high_registers(&mut c);
    addresses(&mut c);
    loads_and_stores(&mut c);
    extends_and_reverses(&mut c);
    register_lists(&mut c);
    branches(&mut c);
    system(&mut c);
    faults(&mut c);
    interrupts(&mut c);
    c.cases
}

/// Shift by immediate, three-operand ADD and SUB, eight-bit immediates: opcodes below 0x4000.
fn shifts_and_sums(c: &mut Collection) {
    for bucket in 0..0x100u16 {
        for edge in EDGES {
            let (n, d) = (c.low(), c.low());
            let code = bucket << 6 | n << 3 | d;
            // Immediate forms name one register in bits 10:8.
            let source = if bucket < 0x80 { n } else { bucket >> 2 & 7 };
            c.push("shift/sum", &[code], |case| case.low[source as usize] = edge);
        }
    }
    for opcode in [0x1800u16, 0x1A00] {
        for a in EDGES {
            for b in EDGES {
                c.push("adds/subs", &[opcode | 2 << 6 | 1 << 3], |case| {
                    case.low[1..3].copy_from_slice(&[a, b]);
                });
            }
        }
    }
}

/// The sixteen two-operand instructions: all pairs of edges, carry clear and set.
fn data_processing(c: &mut Collection) {
    for operation in 0..16u16 {
        for a in EDGES {
            for b in EDGES {
                for carry in [0, 1 << 29] {
                    let (d, m) = (c.low(), c.low());
                    c.push("data", &[0x4000 | operation << 6 | m << 3 | d], |case| {
                        case.low[m as usize] = b;
                        case.low[d as usize] = a;
                        case.apsr = case.apsr & !(1 << 29) | carry;
                    });
                }
            }
        }
        // Shift counts come from the low byte only.
        for count in [0, 1, 7, 31, 32, 33, 63, 64, 127, 128, 224, 255, 256, 257, 288, 0xFFFF_FF00] {
            c.push("data", &[0x4000 | operation << 6 | 3 << 3 | 4], |case| case.low[3] = count);
        }
    }
}

/// ADD, CMP, MOV with high registers; BX and BLX.
fn high_registers(c: &mut Collection) {
    const NAMED: [u16; 14] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 12, SP, LR, PC];
    let encode = |opcode: u16, d: u16, m: u16| opcode | (d & 8) << 4 | m << 3 | d & 7;
    for m in NAMED {
        for d in NAMED {
            if d == PC || m == PC && d == SP {
                continue;
            }
            c.push("add", &[encode(0x4400, d, m)], |_| {});
            c.push("mov", &[encode(0x4600, d, m)], |_| {});
            if d >= 8 || m >= 8 && m != PC {
                for edge in SHORT_EDGES {
                    c.push("cmp", &[encode(0x4500, d, m)], |case| {
                        case.low[(m & 7) as usize] = edge;
                        case.high[2] = edge.wrapping_add(1);
                    });
                }
            }
        }
    }
    // Branches by register: into the field, and to a later halfword of the snippet, which keeps LR.
    for (target, m) in
        [(STUB + 8, 0), (STUB + 10, 5), (STUB + 0x300, 3), (STUB - 0x222, 7), (STUB + 0x700, 1)]
    {
        for opcode in [encode(0x4600, PC, m), bx(m), blx(m)] {
            c.push_branch("branch", &[opcode, 0x3001, 0x3002, 0x3004, 0x3008, 0x3010], |case| {
                case.low[m as usize] = target | 1;
            });
        }
    }
    for (m, slot) in [(8, 0), (9, 1), (12, 2), (LR, 3)] {
        for opcode in [encode(0x4600, PC, m), bx(m), blx(m)] {
            c.push_branch("branch", &[opcode], |case| case.high[slot] = (STUB + 0x500) | 1);
        }
    }
    for distance in [2u32, 4, 0x100, 0x0u32.wrapping_sub(0x44)] {
        c.push_branch("add pc", &[encode(0x4400, PC, 0), 0x3001, 0x3002], |case| case.low[0] = distance);
    }
    // Even targets of BX and BLX: ARM state, which is a HardFault at the target.
    for opcode in [bx(2), blx(2)] {
        for target in [STUB + 0x80, STUB + 0x82, STUB + 4] {
            c.push("arm state", &[opcode], |case| case.low[2] = target);
        }
    }
}

/// LDR literal, ADR, ADD from SP, ADD and SUB to SP.
fn addresses(c: &mut Collection) {
    for bucket in (0x120..0x140).chain(0x280..0x2C0).chain(0x2C0..0x2C4u16) {
        for _ in 0..6 {
            let opcode = bucket << 6 | c.below(64);
            c.push("address", &[opcode], |_| {});
            c.push("address", &[NOP, opcode], |_| {});
        }
    }
}

fn loads_and_stores(c: &mut Collection) {
    let sizes = [WORD, HALF, BYTE, BYTE, WORD, HALF, BYTE, HALF];
    for bucket in 0x140..0x180u16 {
        let size = sizes[usize::from(bucket >> 3 & 7)];
        let m = bucket & 7;
        for _ in 0..5 {
            let (n, t) = (c.low(), c.low());
            let at = WINDOW + c.numbers.below(4 * WINDOW_WORDS as u32) / size * size;
            let offset = c.numbers.word();
            c.push("register offset", &[bucket << 6 | n << 3 | t], |case| {
                // One register for both halves of the address reaches the window doubled only when even.
                case.low[m as usize] = offset;
                case.low[n as usize] = if n == m { at / 2 } else { at.wrapping_sub(offset) };
            });
        }
    }
    for bucket in 0x180..0x240u16 {
        let size = [WORD, BYTE, HALF][usize::from((bucket - 0x180) >> 6)];
        let offset = u32::from(bucket & 31) * size;
        for _ in 0..5 {
            let (n, t) = (c.low(), c.low());
            let at = WINDOW + c.numbers.below(4 * WINDOW_WORDS as u32) / size * size;
            c.push("immediate offset", &[bucket << 6 | n << 3 | t], |case| {
                case.low[n as usize] = at.wrapping_sub(offset);
            });
        }
    }
    for bucket in 0x240..0x280u16 {
        for _ in 0..4 {
            let opcode = bucket << 6 | c.below(64);
            let at = WINDOW + 4 * c.numbers.below(WINDOW_WORDS as u32);
            c.push("stack offset", &[opcode], |case| case.sp = at - 4 * u32::from(opcode & 0xFF));
        }
    }
}

fn extends_and_reverses(c: &mut Collection) {
    for bucket in [0x2C8, 0x2C9, 0x2CA, 0x2CB, 0x2E8, 0x2E9, 0x2EBu16] {
        for value in [
            0,
            0x7F,
            0x80,
            0xFF,
            0x7FFF,
            0x8000,
            0xFFFF,
            0x1234_5678,
            0x89AB_CDEF,
            0x80,
            0x0080_FF7F,
            u32::MAX,
        ] {
            let (m, d) = (c.low(), c.low());
            c.push("extend/reverse", &[bucket << 6 | m << 3 | d], |case| case.low[m as usize] = value);
        }
    }
}

fn register_lists(c: &mut Collection) {
    let window_word = |word: u32| WINDOW + 4 * word;
    for list in 1..0x200u16 {
        c.push("push", &[0xB400 | list], |_| {});
        let pops_pc = list & 0x100 != 0;
        let count = (list & 0xFF).count_ones();
        let name = if pops_pc { "pop pc" } else { "pop" };
        let pad_word = WINDOW_PADS as u32 + c.numbers.below(8);
        c.push_branch(name, &[0xBC00 | list], |case| {
            case.sp = window_word(if pops_pc { pad_word - count } else { 4 });
        });
    }
    for opcode in [0xC000u16, 0xC800] {
        for n in 0..8u16 {
            for list in 1..0x100u16 {
                let base_in_list = list >> n & 1 != 0;
                let base_is_lowest = list.trailing_zeros() == u32::from(n);
                // A stored base that is not the lowest is UNKNOWN. A third of the other lists is plenty.
                let unknown = opcode == 0xC000 && base_in_list && !base_is_lowest;
                if unknown || !base_is_lowest && !(list + n).is_multiple_of(3) {
                    continue;
                }
                let word = c.numbers.below(24);
                c.push("ldm/stm", &[opcode | n << 8 | list], |case| case.low[n as usize] = window_word(word));
            }
        }
    }
}

fn branches(c: &mut Collection) {
    /// Whether a target is a landing pad, or a halfword of the snippet behind the branch.
    fn lands(offset: i32) -> bool {
        offset <= -2 || (2..16).contains(&offset) || (18..2056).contains(&offset)
    }
    let steps = [0x3001, 0x3002, 0x3004, 0x3008, 0x3010, 0x3020u16];
    let with_steps = |code: &[u16]| [code, &steps].concat();

    for bucket in 0x340..0x378u16 {
        for flags in 0..16 {
            let opcode = bucket << 6 | c.below(64);
            let offset = 4 + 2 * i32::from(opcode.to_le_bytes()[0].cast_signed());
            if lands(offset) {
                c.push_branch("b<cond>", &with_steps(&[opcode]), |case| case.apsr = flags << 28);
            }
        }
    }
    for condition in 0..14 {
        for flags in 0..16 {
            c.push_branch("b<cond>", &with_steps(&[branch_if(condition, 8)]), |case| case.apsr = flags << 28);
        }
    }
    for bucket in 0x380..0x3A0u16 {
        for _ in 0..8 {
            let opcode = bucket << 6 | c.below(64);
            let offset = 4 + ((i32::from(opcode) << 21) >> 20);
            if lands(offset) {
                c.push_branch("b", &with_steps(&[opcode]), |_| {});
            }
        }
    }
    for offset in [4, 6, 8, 10, 12, 18, 0x124, 0x7FE, -2, -0x66, -0x400, -2040] {
        assert!(lands(offset), "{offset} is no landing pad");
        c.push_branch("bl", &with_steps(&bl(offset)), |_| {});
    }
}

/// Special registers, barriers, hints, SVC.
fn system(c: &mut Collection) {
    for special in [0, 1, 2, 3, 5, 6, 7, MSP, PSP, PRIMASK, CONTROL] {
        for d in [0, 3, 7, 8, 12, LR] {
            c.push("mrs", &mrs(d, special), |_| {});
        }
    }
    for special in 0..4 {
        for flags in 0..16 {
            // Bit 27 is reserved in ARMv6-M; QEMU keeps it as the Q flag of ARMv7-M.
            c.push("msr apsr", &msr(special, 2), |case| case.low[2] = flags << 28 | 0x07BC_DEF0);
        }
    }
    for special in [5, 6, 7] {
        c.push("msr ignored", &msr(special, 1), |case| case.low[1] = u32::MAX);
    }
    let stack = WINDOW + 0x40;
    for value in [stack, stack + 1, stack + 3, stack + 4] {
        c.push("msr msp", &msr(MSP, 4), |case| case.low[4] = value);
        c.push("msr psp", &msr(PSP, 4), |case| case.low[4] = value);
    }
    for value in [0, 1, 2, u32::MAX] {
        c.push("msr primask", &msr(PRIMASK, 0), |case| case.low[0] = value);
    }
    for opcode in [CPSIE, CPSID] {
        c.push("cps", &[opcode], |_| {});
    }
    let [psp, control] = [msr(PSP, 1), msr(CONTROL, 2)];
    let to_process_stack = [psp, control, [0xF3BF, 0x8F6F]].concat();
    for tail in [[0xB405, NOP], [0xDF07, NOP], [0xBC18, NOP], [0xDE00, NOP]] {
        c.push("process stack", &[&to_process_stack[..], &tail].concat(), |case| {
            case.low[1..3].copy_from_slice(&[stack, 2]);
        });
    }
    for barrier in [0x8F4F, 0x8F5F, 0x8F6F] {
        c.push("barrier", &[0xF3BF, barrier], |_| {});
    }
    // NOP, YIELD, the unnamed hints; SEV arms WFE, which then falls through.
    for hint in [0, 1, 5, 8, 15] {
        c.push("hint", &[0xBF00 | hint << 4], |_| {});
    }
    c.push("sev wfe", &[0xBF40, 0xBF20], |_| {});
    // Not SVC under PRIMASK: it becomes HardFault, for which QEMU stacks the next address and the manual (B1.5.6) its own.
    for bucket in 0x37C..0x380u16 {
        for offset in [0, 4] {
            let opcode = bucket << 6 | c.below(64);
            c.push("svc", &[opcode], |case| case.sp = CASE_STACK + offset);
        }
    }
}

/// HardFaults: the handler shows the stacked PC and xPSR.
fn faults(c: &mut Collection) {
    // Undefined 16-bit encodings: UDF, HLT and holes.
    let undefined = (0x378..0x37Cu16)
        .chain([0x2D8, 0x2DA, 0x2DB, 0x2DC, 0x2DD, 0x2DE, 0x2DF])
        .chain([0x2E0, 0x2E1, 0x2E2, 0x2E3, 0x2EA]);
    for bucket in undefined {
        for _ in 0..2 {
            let opcode = bucket << 6 | c.below(64);
            c.push("undefined", &[opcode], |_| {});
            c.push("undefined", &[NOP, opcode], |_| {});
        }
    }
    // 32-bit encodings that ARMv6-M does not have.
    for bucket in (0x3A0..0x3C0).chain(0x3E0..0x400u16) {
        let wide = [bucket << 6 | c.below(64), 0x8000 | c.below(0x1000)];
        c.push("undefined wide", &wide, |_| {});
    }
    for wide in [[0xF7F0, 0xA000], [0xF7F1, 0xA123], [0xF000, 0x8000], [0xF200, 0x0000], [0xF04F, 0x0001]] {
        c.push("undefined wide", &wide, |_| {});
    }
    for bucket in 0x2F8..0x2FCu16 {
        // Semihosting's 0xAB lies in the third bucket.
        c.push("bkpt", &[bucket << 6 | 1], |_| {});
    }
    for bucket in [0x140, 0x148, 0x160, 0x168, 0x178u16] {
        c.push("unaligned", &[bucket << 6 | 1 << 3 | 2], |case| case.low[..2].copy_from_slice(&[1, WINDOW]));
        c.push("unmapped", &[bucket << 6 | 1 << 3 | 2], |case| case.low[..2].copy_from_slice(&[4, UNMAPPED]));
    }
    for opcode in [0xC106, 0xC906] {
        for base in [WINDOW + 2, UNMAPPED] {
            c.push("list fault", &[opcode], |case| case.low[1] = base);
        }
    }
    c.push("call into nothing", &[blx(1)], |case| case.low[1] = UNMAPPED | 1);
}

/// Software-pended interrupts and PendSV with random priorities: the handler shows which one came last.
fn interrupts(c: &mut Collection) {
    const ISER: u32 = 0xE000_E100;
    const ISPR: u32 = 0xE000_E200;
    const IPR0: u32 = 0xE000_E400;
    const ICSR: u32 = 0xE000_ED04;
    // Bit 11 of ICSR is reserved in ARMv6-M; QEMU shows ARMv7-M's RETTOBASE there.
    let upper = |d: u16, m: u16| lsrs_imm(d, m, 12);
    let lower = |d: u16, m: u16| lsls_imm(d, m, 32 - 9);
    for _ in 0..80 {
        let lane = 4 * c.numbers.below(8);
        let [enable, pend, priorities] = [c.numbers.word(), c.numbers.word(), c.numbers.word()];
        let code = [CPSID, str(1, 0, 0), str(3, 2, 0), str(5, 4, 0), CPSIE, NOP, NOP];
        c.push("nvic", &code, |case| {
            case.low[..6].copy_from_slice(&[IPR0 + lane, priorities, ISER, enable, ISPR, pend]);
        });
        let code =
            [CPSID, str(1, 0, 0), str(3, 2, 0), str(5, 4, 0), ldr(0, 0, 0), ldr(3, 2, 0), ldr(5, 4, 0)];
        c.push("nvic registers", &code, |case| {
            case.low[..6].copy_from_slice(&[IPR0 + lane, priorities, ISER, enable, ISPR, pend]);
        });
        let code = [CPSID, str(1, 0, 0), str(3, 2, 0), str(5, 4, 0), ldr(6, 6, 0), upper(7, 6), lower(6, 6)];
        c.push("icsr", &code, |case| {
            case.low[..7].copy_from_slice(&[IPR0 + lane, priorities, ISER, enable, ISPR, pend, ICSR]);
        });
    }
    // Not NMI: QEMU takes it at the end of its translation block, some instructions later.
    for bits in [1 << 28, 1 << 26, 1 << 28 | 1 << 26, 1 << 28 | 1 << 27] {
        c.push("icsr", &[CPSID, str(1, 0, 0), ldr(2, 0, 0), upper(3, 2), lower(2, 2), CPSIE, NOP], |case| {
            case.low[..2].copy_from_slice(&[ICSR, bits]);
        });
    }
    // The low byte of SHPR3 is reserved in ARMv6-M; QEMU has DebugMonitor there.
    for (offset, value) in [(0x18, u32::MAX), (0x1C, 0xFFFF_FF00), (0x18, 0x1234_5678), (0x1C, 0x89AB_CD00)] {
        c.push("shpr", &[str(1, 0, offset), ldr(2, 0, offset)], |case| {
            case.low[..2].copy_from_slice(&[ICSR, value]);
        });
    }
}
