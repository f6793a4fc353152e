//! Inner products of plain numbers, up to eight side by side in a register.
//!
//! The factors stand row by row in memory. So that one load fills a register, numbers of several rows are put next to each other in the scratch
//! memory when an inner product first reads them. Most inner products read one number more of each row than the inner products before.

use std::collections::BTreeMap;

use iced_x86::{Code, Instruction, Register};

use super::{Assembler, Home, NoCode, Operand};
use crate::groups::{Group, WIDEST};
use crate::instruction_set::{Packed, PackedSet};
use crate::written_out::inner_product_steps;
use crate::{Arithmetic, StraightLine};

/// One slot for each lane.
type Places = [usize; WIDEST];

/// The content of the scratch memory.
#[derive(Debug, Default)]
pub(super) struct Packs {
    /// Index of the first packed value, by the width of the register and the slots that were packed.
    at: BTreeMap<(usize, Places), usize>,
    numbers: usize,
}

impl Packs {
    /// The number of values in the scratch memory.
    pub(super) fn numbers(&self) -> usize {
        self.numbers
    }

    /// Reserves room for one more register of `lanes` numbers, at a multiple of its size.
    fn room(&mut self, lanes: usize) -> usize {
        let first = self.numbers.next_multiple_of(lanes);
        self.numbers = first + lanes;
        first
    }
}

/// The rows that a group reads, and its registers.
struct Rows {
    /// The first slot of each lane's row, for either factor.
    first: [Places; 2],
    count: usize,
    lanes: usize,
    packed: &'static Packed,
    set: &'static PackedSet,
}

impl Rows {
    fn new(line: &StraightLine, group: &Group, set: &'static PackedSet) -> Self {
        let last = group.members.len() - 1;
        let rows: [[usize; 2]; WIDEST] =
            std::array::from_fn(|lane| match line.steps()[group.members[lane.min(last)]] {
                Arithmetic::InnerProduct { a, b, .. } => [a, b],
                _ => [0; 2],
            });
        let first = [rows.map(|[a, _]| a), rows.map(|[_, b]| b)];
        let (lanes, packed) = match (group.members.len(), &set.eight) {
            (1, _) => (1, &set.one),
            (2, _) => (2, &set.two),
            (5.., Some(eight)) => (8, &eight.packed),
            _ => (4, &set.four),
        };
        Self { first, count: group.count, lanes, packed, set }
    }

    /// The slots of a factor in all lanes. Factors below `count` are in the first row of each lane, the others in the second.
    fn places(&self, factor: usize) -> Places {
        self.first[factor / self.count].map(|first| first + factor % self.count)
    }
}

/// Values that stand for the upper quarter or half of a register before these are inserted.
const UPPER: [usize; 2] = [usize::MAX / 2, usize::MAX / 2 - 1];

/// A number for a sum or factor inside a group, which is the value of no step of the line.
fn temporary(line: &StraightLine, number: usize) -> usize {
    line.steps().len() + number
}

impl Assembler<'_> {
    /// Writes the code for all inner products of a group.
    pub(super) fn inner_products(&mut self, group: &Group) -> Result<(), NoCode> {
        let rows = Rows::new(self.line, group, self.set.packed.as_ref().ok_or(NoCode::Instruction)?);
        self.now = group.members[0];
        let (steps, result) = inner_product_steps(group.count);
        for (number, step) in steps.iter().enumerate() {
            match *step {
                Arithmetic::Multiply(a, b) => {
                    let to = self.take_packed(&rows, number)?;
                    self.product(&rows, rows.packed.multiply, [a, b], to)?;
                }
                Arithmetic::MultiplyAdd(a, b, onto) => {
                    let onto = self.sum(&rows, onto, number)?;
                    self.product(&rows, rows.packed.multiply_add, [a, b], onto)?;
                }
                Arithmetic::Add(a, b) => {
                    let (to, other) = (self.sum(&rows, a, number)?, self.sum(&rows, b, steps.len())?);
                    self.three(rows.packed.add, to, to, Operand::Register(other))?;
                    self.registers.free(temporary(self.line, steps.len()));
                }
                _ => {}
            }
        }
        self.give(&rows, group, result)
    }

    fn take_packed(&mut self, rows: &Rows, number: usize) -> Result<Register, NoCode> {
        let value = temporary(self.line, number);
        self.take(value, &[])?;
        self.packed_register(rows.packed, value)
    }

    fn packed_register(&self, packed: &Packed, value: usize) -> Result<Register, NoCode> {
        self.registers.find(value).map(|number| packed.register(number)).ok_or(NoCode::Registers)
    }

    /// The register of a partial sum, renamed in place, because each partial sum is needed only once.
    fn sum(&mut self, rows: &Rows, sum: usize, new: usize) -> Result<Register, NoCode> {
        let new = temporary(self.line, new);
        self.registers.rename(temporary(self.line, sum), new);
        self.packed_register(rows.packed, new)
    }

    /// Forms a product, alone or added to the content of the register.
    fn product(&mut self, rows: &Rows, code: Code, [a, b]: [usize; 2], to: Register) -> Result<(), NoCode> {
        // A factor that is packed in memory is read from there and needs no load.
        let [a, b] = if self.packed_home(rows, a).is_some() { [b, a] } else { [a, b] };
        let first = self.factor(rows, a)?;
        let last = match self.packed_home(rows, b) {
            Some(home) => Operand::Memory(self.address(home)?),
            None => Operand::Register(self.factor(rows, b)?),
        };
        self.three(code, to, first, last)?;
        for factor in [a, b] {
            self.registers.free(temporary(self.line, factor));
        }
        Ok(())
    }

    /// The location at which the numbers of a factor are packed.
    fn packed_home(&self, rows: &Rows, factor: usize) -> Option<Home> {
        let places = rows.places(factor);
        match rows.lanes {
            1 => Some(Home::Place(places[0])),
            lanes => self.packs.at.get(&(lanes, places)).map(|first| Home::Scratch(*first)),
        }
    }

    /// A register loaded with the packed numbers of a factor.
    fn factor(&mut self, rows: &Rows, factor: usize) -> Result<Register, NoCode> {
        let (home, to, places) =
            (self.packed_home(rows, factor), self.take_packed(rows, factor)?, rows.places(factor));
        if let Some(home) = home {
            let address = self.address(home)?;
            self.encode(Instruction::with2(rows.packed.load, to, address))?;
        } else if places.iter().all(|slot| *slot == places[0]) {
            let address = self.address(Home::Place(places[0]))?;
            self.encode(Instruction::with2(rows.packed.broadcast, to, address))?;
        } else {
            self.pack(rows, factor, to)?;
        }
        Ok(to)
    }

    /// Puts the numbers of a factor next to each other, in a register and in the scratch.
    fn pack(&mut self, rows: &Rows, factor: usize, to: Register) -> Result<(), NoCode> {
        let places = rows.places(factor);
        let (low, upper) = places.split_at(4);
        self.beside(rows.set, &low[..rows.lanes.min(4)], temporary(self.line, factor))?;
        if let Some(eight) = rows.set.eight.as_ref().filter(|_| rows.lanes > 4) {
            let half = temporary(self.line, UPPER[1]);
            self.take(half, &[])?;
            self.beside(rows.set, upper, half)?;
            let high = self.packed_register(&rows.set.four, half)?;
            self.encode(Instruction::with4(eight.insert, to, to, high, 1))?;
            self.registers.free(half);
        }
        let first = self.packs.room(rows.lanes);
        self.packs.at.insert((rows.lanes, places), first);
        let address = self.address(Home::Scratch(first))?;
        self.encode(Instruction::with2(rows.packed.store, address, to))
    }

    /// Puts two or four numbers next to each other in the register of a value.
    fn beside(&mut self, set: &PackedSet, places: &[usize], value: usize) -> Result<(), NoCode> {
        let low = self.packed_register(&set.two, value)?;
        self.pair(set, [places[0], places[1]], low)?;
        if let [_, _, third, fourth] = *places {
            let upper = temporary(self.line, UPPER[0]);
            self.take(upper, &[])?;
            let (to, high) =
                (self.packed_register(&set.four, value)?, self.packed_register(&set.two, upper)?);
            self.pair(set, [third, fourth], high)?;
            self.encode(Instruction::with4(set.insert, to, to, high, 1))?;
            self.registers.free(upper);
        }
        Ok(())
    }

    fn pair(&mut self, set: &PackedSet, [a, b]: [usize; 2], to: Register) -> Result<(), NoCode> {
        let first = match self.at_place(a)? {
            Operand::Register(register) => register,
            Operand::Memory(address) => {
                self.encode(Instruction::with2(set.one.load, to, address))?;
                to
            }
        };
        match self.at_place(b)? {
            Operand::Register(second) => self.encode(Instruction::with3(set.unpack_low, to, first, second)),
            Operand::Memory(address) => self.encode(Instruction::with3(set.load_high, to, first, address)),
        }
    }

    /// A number as an operand: the register that still holds it, or its slot in memory.
    fn at_place(&self, slot: usize) -> Result<Operand, NoCode> {
        match self.kept[slot].and_then(|value| self.registers.find(value)) {
            Some(register) => Ok(Operand::Register(self.set.register(register))),
            None => Ok(Operand::Memory(self.address(Home::Place(slot))?)),
        }
    }

    /// Assigns the lanes of a sum to the steps of the group.
    fn give(&mut self, rows: &Rows, group: &Group, result: usize) -> Result<(), NoCode> {
        let result = temporary(self.line, result);
        if let [only] = group.members[..] {
            self.registers.rename(result, only);
            return Ok(());
        }
        let first = self.packs.room(rows.lanes);
        let (address, from) =
            (self.address(Home::Scratch(first))?, self.packed_register(rows.packed, result)?);
        self.encode(Instruction::with2(rows.packed.store, address, from))?;
        for (lane, member) in group.members.iter().enumerate() {
            self.homes[*member] = Some(Home::Scratch(first + lane));
        }
        self.registers.rename(result, group.members[0]);
        if let [first, second] = group.members[..] {
            self.take(second, &[first])?;
            let (low, high) =
                (self.packed_register(&rows.set.two, first)?, self.packed_register(&rows.set.two, second)?);
            self.three(rows.set.unpack_high, high, low, Operand::Register(low))?;
        }
        Ok(())
    }
}
