//! Base registers that point into the slots, so that most addresses take one byte. The code becomes a third shorter, which matters because long
//! lines exceed the first-level instruction cache.

use iced_x86::{Code, IcedError, Instruction, MemoryOperand, Register};

use crate::instruction_set::InstructionSet;

/// Registers that a function may change; the first one points to the slots.
const BASES: [Register; 6] =
    [Register::RDI, Register::RAX, Register::R8, Register::R9, Register::R10, Register::R11];

/// The register in which the address of the scratch memory is passed.
const SCRATCH: Register = Register::RCX;

/// Largest distance from a base register, on either side, that is encoded in one byte, in widths of a vector register.
const LEAST: usize = 128;

/// Consecutive windows of equal size onto the slots, one for each base register.
#[derive(Debug)]
pub(crate) struct Windows {
    /// Half of the bytes that one base register reaches; zero if there is only the first register, which points to the first byte.
    half: usize,
}

impl Windows {
    pub(crate) fn new(set: &InstructionSet) -> Self {
        Self { half: if set.has_short_distances() { LEAST * set.bytes() } else { 0 } }
    }

    /// The distance from the first byte of the scratch memory to the address that its base register holds.
    fn middle_of_scratch(&self) -> usize {
        const LONGEST_PACK: usize = 64;
        if self.half == 0 { 0 } else { LEAST * LONGEST_PACK }
    }

    /// The instructions that set the base registers: the first register is changed last, since the others are computed from it.
    pub(crate) fn openings(&self) -> impl Iterator<Item = Result<Instruction, IcedError>> + use<> {
        let half = self.half;
        let count = if half == 0 { 0 } else { BASES.len() };
        let moved = |to: Register, from: Register, by: usize| {
            let by = i64::try_from(by).unwrap_or(i64::MAX);
            Instruction::with2(Code::Lea_r64_m, to, MemoryOperand::with_base_displ(from, by))
        };
        let scratch = (half > 0).then(|| moved(SCRATCH, SCRATCH, self.middle_of_scratch()));
        let places =
            (0..count).rev().map(move |window| moved(BASES[window], Register::RDI, (2 * window + 1) * half));
        scratch.into_iter().chain(places)
    }

    /// The base register of the scratch memory and the distance from it to a byte there.
    pub(crate) fn in_scratch(&self, byte: usize) -> (Register, Option<i64>) {
        let distance = byte.checked_signed_diff(self.middle_of_scratch());
        (SCRATCH, distance.and_then(|distance| i64::try_from(distance).ok()))
    }

    /// A base register and the distance from it to a byte of the slots.
    pub(crate) fn around(&self, byte: usize) -> (Register, Option<i64>) {
        let window =
            byte.checked_div(2 * self.half).map_or(0, |window| if window < BASES.len() { window } else { 0 });
        let middle = (2 * window + 1) * self.half;
        (BASES[window], byte.checked_signed_diff(middle).and_then(|distance| i64::try_from(distance).ok()))
    }
}
