//! Machine code of a line.

use crate::{Aligned, StraightLine};
#[cfg(all(target_arch = "x86_64", unix))]
use crate::{assembly::assembled, call::Code, instruction_set::InstructionSet, written_out::written_out};

/// A [`StraightLine`] as machine code.
#[derive(Debug)]
pub struct Compiled {
    #[cfg(all(target_arch = "x86_64", unix))]
    code: Code,
    #[cfg(not(all(target_arch = "x86_64", unix)))]
    none: std::convert::Infallible,
}

#[cfg(all(target_arch = "x86_64", unix))]
impl Compiled {
    /// Compiles the line for `lanes` lanes; `None` if there is no code for this processor or number of lanes, or if the system grants no memory
    /// for it.
    #[must_use]
    pub fn new(line: &StraightLine, lanes: usize) -> Option<Self> {
        Self::in_set(line, lanes, InstructionSet::for_lanes(lanes).next()?)
    }

    fn in_set(line: &StraightLine, lanes: usize, set: &'static InstructionSet) -> Option<Self> {
        let assembled = match set.lanes {
            1 => assembled(line, set, lanes)?,
            _ => assembled(&written_out(line).ok()?, set, lanes)?,
        };
        Some(Self { code: Code::new(line, assembled, set.lanes, lanes)? })
    }

    /// Runs the line as [`StraightLine::interpret`] does, in the lanes it was compiled for.
    ///
    /// # Panics
    /// If there are fewer numbers than slots or arguments times lanes.
    pub fn run(&self, places: &mut [f64], arguments: &[f64], scratch: &mut Aligned) {
        self.code.run(places, arguments, scratch);
    }
}

#[cfg(not(all(target_arch = "x86_64", unix)))]
impl Compiled {
    /// `None`: there is no code for this processor or system.
    #[must_use]
    pub fn new(_: &StraightLine, _: usize) -> Option<Self> {
        None
    }

    /// Never called.
    pub fn run(&self, _: &mut [f64], _: &[f64], _: &mut Aligned) {
        match self.none {}
    }
}

#[cfg(all(test, target_arch = "x86_64", unix))]
mod tests {
    use super::*;
    use crate::Arithmetic;

    /// A line with more values at a time than the smallest set of registers holds, and with inner products of five rows.
    fn line() -> StraightLine {
        let places = (0..40).map(Arithmetic::Place);
        let products = (0..5).map(|row| Arithmetic::InnerProduct { a: 8 * row, b: 32 - 8 * row, count: 8 });
        let sums = (0..39).map(|k| Arithmetic::Add(k, if k == 0 { 40 } else { 44 + k }));
        let rest = (0..5).map(|k| Arithmetic::MultiplyAdd(40 + k, 83, 83 - k));
        let keep = (0..5).map(|k| Arithmetic::Keep { value: 84 + k, slot: 40 + k });
        StraightLine::new(places.chain(products).chain(sums).chain(rest).chain(keep).collect(), 45, 0)
            .expect("places of its own")
    }

    #[test]
    fn all_sets_of_instructions_give_the_same_bits() {
        for lanes in [1, 4, 8] {
            let start: Vec<f64> =
                (0_u32..).map(|k| 1.0 / (3.0 + f64::from(k % 11))).take(45 * lanes).collect();
            let mut expected = start.clone();
            line().interpret(&mut expected, &[], lanes);
            for set in InstructionSet::for_lanes(lanes) {
                let mut results = start.clone();
                let code = Compiled::in_set(&line(), lanes, set).expect("registers for this line");
                code.run(&mut results, &[], &mut Aligned::default());
                assert_eq!(results, expected, "{set:?}");
            }
        }
    }
}
