//! Registers that point into the places, so that most addresses take one byte: a third less code, of which long lines have more than
//! the first cache for instructions holds.

use iced_x86::{Code, IcedError, Instruction, MemoryOperand, Register};

use crate::instruction_set::InstructionSet;

/// Which a function may change; the first one points to the places.
const BASES: [Register; 7] =
    [Register::RDI, Register::RAX, Register::RCX, Register::R8, Register::R9, Register::R10, Register::R11];

/// As many bytes of the places for each register, one behind the other.
#[derive(Debug)]
pub(crate) struct Windows {
    /// Half of the bytes that are near a register; zero where there is only the first one, at the first byte.
    half: usize,
}

impl Windows {
    pub(crate) fn new(set: &InstructionSet) -> Self {
        const LEAST: usize = 128;
        Self { half: if set.has_short_distances() { LEAST * set.bytes() } else { 0 } }
    }

    /// What has to be done before: the first register is changed last, from which the others are made.
    pub(crate) fn openings(&self) -> impl Iterator<Item = Result<Instruction, IcedError>> + use<> {
        let half = self.half;
        let count = if half == 0 { 0 } else { BASES.len() };
        (0..count).rev().map(move |window| {
            let middle = i64::try_from((2 * window + 1) * half).unwrap_or(i64::MAX);
            let address = MemoryOperand::with_base_displ(Register::RDI, middle);
            Instruction::with2(Code::Lea_r64_m, BASES[window], address)
        })
    }

    /// A register and how far from it a byte of the places is.
    pub(crate) fn around(&self, byte: usize) -> (Register, Option<i64>) {
        let window =
            byte.checked_div(2 * self.half).map_or(0, |window| if window < BASES.len() { window } else { 0 });
        let middle = (2 * window + 1) * self.half;
        (BASES[window], byte.checked_signed_diff(middle).and_then(|distance| i64::try_from(distance).ok()))
    }
}
