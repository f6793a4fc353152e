//! Lines in the instructions of x86-64: AVX2 with fused multiply-add, or AVX-512.
//!
//! Values stay in registers until the registers are needed for other values. A value kept in a slot is stored at once, and can be loaded from
//! there.

mod packing;

use std::collections::HashMap;

use iced_x86::{Code, Encoder, IcedError, Instruction, MemoryOperand, Register};

use self::packing::Packs;
use crate::groups::{WIDEST, groups};
use crate::instruction_set::{InstructionSet, PackedSet};
use crate::registers::Registers;
use crate::uses::Uses;
use crate::windows::Windows;
use crate::{Arithmetic, StraightLine};

/// Machine code, and the constants that it reads.
#[derive(Debug)]
pub(crate) struct Assembled {
    pub(crate) code: Vec<u8>,
    pub(crate) numbers: Vec<f64>,
    /// Number of values that the code stores in the scratch memory.
    pub(crate) scratch: usize,
}

/// The machine code of a line in one instruction set, for `lanes` lanes side by side in memory; `None` if more values are needed at the same
/// time than there are registers.
pub(crate) fn assembled(
    line: &StraightLine,
    set: &'static InstructionSet,
    lanes: usize,
) -> Option<Assembled> {
    let mut assembler = Assembler::new(line, set, lanes)?;
    for instruction in assembler.windows.openings() {
        assembler.encode(instruction).ok()?;
    }
    let groups = groups(line, set.packed.as_ref().map_or(WIDEST, PackedSet::widest));
    for (number, step) in line.steps().iter().enumerate() {
        if let Some(group) = groups.get(&number) {
            assembler.inner_products(group).ok()?;
        }
        assembler.write(number, step).ok()?;
        assembler.release(number, &[number]);
    }
    assembler.encode(Ok(Instruction::with(set.leave))).ok()?;
    assembler.encode(Ok(Instruction::with(Code::Retnq))).ok()?;
    let (code, scratch) = (assembler.encoder.take_buffer(), assembler.packs.numbers());
    Some(Assembled { code, numbers: assembler.numbers, scratch })
}

/// The location from which a value can be loaded again.
#[derive(Clone, Copy, Debug)]
enum Home {
    Place(usize),
    Argument(usize),
    Number(usize),
    Scratch(usize),
}

/// The reason why there is no code.
#[derive(Debug)]
enum NoCode {
    /// Every register holds a value that is still needed and is stored nowhere else.
    Registers,
    /// An instruction that cannot be encoded, such as one with an address beyond 2³¹.
    Instruction,
}

impl From<IcedError> for NoCode {
    fn from(_: IcedError) -> Self {
        Self::Instruction
    }
}

struct Assembler<'a> {
    set: &'static InstructionSet,
    line: &'a StraightLine,
    encoder: Encoder,
    registers: Registers,
    /// The location of each value, by the number of its step.
    homes: Vec<Option<Home>>,
    uses: Uses,
    /// The step for which code is written.
    now: usize,
    numbers: Vec<f64>,
    places_of_numbers: HashMap<u64, usize>,
    /// Bytes from one slot to the next.
    stride: usize,
    windows: Windows,
    packs: Packs,
    /// The value kept in each slot.
    kept: Vec<Option<usize>>,
}

impl<'a> Assembler<'a> {
    fn new(line: &'a StraightLine, set: &'static InstructionSet, lanes: usize) -> Option<Self> {
        Some(Self {
            set,
            line,
            encoder: Encoder::new(64),
            registers: Registers::new(set.registers),
            homes: vec![None; line.steps().len()],
            uses: Uses::of(line)?,
            now: 0,
            numbers: vec![],
            places_of_numbers: HashMap::new(),
            stride: lanes * size_of::<f64>(),
            windows: Windows::new(set),
            packs: Packs::default(),
            kept: vec![None; line.places()],
        })
    }

    fn encode(&mut self, instruction: Result<Instruction, IcedError>) -> Result<(), NoCode> {
        self.encoder.encode(&instruction?, 0)?;
        Ok(())
    }

    fn write(&mut self, number: usize, step: &Arithmetic) -> Result<(), NoCode> {
        let set = self.set;
        self.now = number;
        match *step {
            Arithmetic::Place(slot) => self.homes[number] = Some(Home::Place(slot)),
            Arithmetic::Argument(argument) => self.homes[number] = Some(Home::Argument(argument)),
            Arithmetic::Number(value) => self.homes[number] = Some(self.number(value)),
            Arithmetic::Negate(a) => self.negate(number, a)?,
            Arithmetic::Add(a, b) => {
                let terms = self.memory_last([a, b]);
                self.combine(set.add, number, terms)?;
            }
            Arithmetic::Multiply(a, b) => {
                let factors = self.memory_last([a, b]);
                self.combine(set.multiply, number, factors)?;
            }
            Arithmetic::Subtract(a, b) => self.combine(set.subtract, number, [a, b])?,
            Arithmetic::Divide(a, b) => self.combine(set.divide, number, [a, b])?,
            Arithmetic::MultiplyAdd(a, b, c) => self.multiply_add(number, [a, b], c)?,
            Arithmetic::Keep { value, slot } => {
                let (register, home) = (self.in_register(value, &[value])?, Home::Place(slot));
                let address = self.address(home)?;
                self.encode(Instruction::with2(set.store, address, register))?;
                self.homes[value] = Some(home);
                self.kept[slot] = Some(value);
                self.release(number, &[value]);
            }
            // Written with the first inner product of its group.
            Arithmetic::InnerProduct { .. } => {}
        }
        Ok(())
    }
}

/// The last operand of an instruction.
#[derive(Clone, Copy)]
enum Operand {
    Register(Register),
    Memory(MemoryOperand),
}

impl Assembler<'_> {
    fn number(&mut self, value: f64) -> Home {
        let Self { numbers, places_of_numbers, .. } = self;
        Home::Number(*places_of_numbers.entry(value.to_bits()).or_insert_with(|| {
            numbers.push(value);
            numbers.len() - 1
        }))
    }

    fn is_nothing(&self, value: usize) -> bool {
        matches!(self.homes[value], Some(Home::Number(number)) if self.numbers[number].to_bits() == 0)
    }

    fn address(&self, home: Home) -> Result<MemoryOperand, NoCode> {
        let (base, offset) = match home {
            Home::Place(slot) => self.windows.around(slot * self.stride),
            Home::Argument(argument) => (Register::RSI, i64::try_from(argument * self.stride).ok()),
            Home::Number(number) => (Register::RDX, i64::try_from(number * self.set.bytes()).ok()),
            Home::Scratch(number) => self.windows.in_scratch(number * size_of::<f64>()),
        };
        let displacement = offset.and_then(|offset| i32::try_from(offset).ok()).ok_or(NoCode::Instruction)?;
        Ok(MemoryOperand::with_base_displ(base, i64::from(displacement)))
    }

    /// A register for a value; no register of an operand is taken.
    fn take(&mut self, value: usize, operands: &[usize]) -> Result<Register, NoCode> {
        let next_use = |held: usize| {
            let can_be_had_again =
                self.homes.get(held).is_some_and(Option::is_some) && !operands.contains(&held);
            can_be_had_again.then(|| self.uses.after(self.now, held).unwrap_or(usize::MAX))
        };
        let register = self.registers.take(next_use).ok_or(NoCode::Registers)?;
        self.registers.hold(register, value);
        Ok(self.set.register(register))
    }

    fn in_register(&mut self, value: usize, operands: &[usize]) -> Result<Register, NoCode> {
        if let Some(register) = self.registers.find(value) {
            return Ok(self.set.register(register));
        }
        let home = self.homes[value].ok_or(NoCode::Registers)?;
        let (register, address) = (self.take(value, operands)?, self.address(home)?);
        self.encode(Instruction::with2(self.set.load, register, address))?;
        Ok(register)
    }

    fn operand(&mut self, value: usize) -> Result<Operand, NoCode> {
        if let Some(register) = self.registers.find(value) {
            return Ok(Operand::Register(self.set.register(register)));
        }
        let home = self.homes[value].ok_or(NoCode::Registers)?;
        Ok(Operand::Memory(self.address(home)?))
    }

    /// The two operands of a product or sum, in the order in which the last one may be read from memory: last stands the one that is in no
    /// register, or, of two such, the one whose next use is later.
    fn memory_last(&self, [a, b]: [usize; 2]) -> [usize; 2] {
        let next = |value: usize| self.uses.after(self.now, value).unwrap_or(usize::MAX);
        let swaps = match [a, b].map(|value| self.registers.find(value).is_some()) {
            [false, true] => true,
            [false, false] => next(b) < next(a),
            _ => false,
        };
        if swaps { [b, a] } else { [a, b] }
    }

    fn three(&mut self, code: Code, to: Register, first: Register, last: Operand) -> Result<(), NoCode> {
        self.encode(match last {
            Operand::Register(last) => Instruction::with3(code, to, first, last),
            Operand::Memory(last) => Instruction::with3(code, to, first, last),
        })
    }

    /// A value from two others; its register may be that of an operand that is not needed any more.
    fn combine(&mut self, code: Code, value: usize, [a, b]: [usize; 2]) -> Result<(), NoCode> {
        let (first, last) = (self.in_register(a, &[a, b])?, self.operand(b)?);
        self.release(value, &[a, b]);
        let to = self.take(value, &[])?;
        self.three(code, to, first, last)
    }

    fn negate(&mut self, value: usize, a: usize) -> Result<(), NoCode> {
        let signs = self.number(-0.0);
        let (first, last) = (self.in_register(a, &[a])?, Operand::Memory(self.address(signs)?));
        self.release(value, &[a]);
        let to = self.take(value, &[])?;
        self.three(self.set.exclusive_or, to, first, last)
    }

    /// Adds a product to an addend in a register, which holds the sum afterwards.
    fn multiply_add(&mut self, value: usize, factors: [usize; 2], addend: usize) -> Result<(), NoCode> {
        let [a, b] = self.memory_last(factors);
        let operands = [a, b, addend];
        let first = self.in_register(a, &operands)?;
        let to = self.addend(value, addend, &operands)?;
        let last = self.operand(b)?;
        self.three(self.set.multiply_add, to, first, last)?;
        self.release(value, &[a, b]);
        Ok(())
    }

    /// The register of a sum, loaded with the addend.
    fn addend(&mut self, value: usize, addend: usize, operands: &[usize; 3]) -> Result<Register, NoCode> {
        if self.is_nothing(addend) {
            let to = self.take(value, operands)?;
            self.encode(Instruction::with3(self.set.exclusive_or, to, to, to))?;
            return Ok(to);
        }
        let from = self.in_register(addend, operands)?;
        if self.uses.after(value, addend).is_none() && !operands[..2].contains(&addend) {
            self.registers.rename(addend, value);
            return Ok(from);
        }
        let to = self.take(value, operands)?;
        self.encode(Instruction::with2(self.set.copy, to, from))?;
        Ok(to)
    }

    /// Frees the registers of the operands that are not needed after this step.
    fn release(&mut self, step: usize, operands: &[usize]) {
        for operand in operands {
            if self.uses.after(step, *operand).is_none() {
                self.registers.free(*operand);
            }
        }
    }
}
