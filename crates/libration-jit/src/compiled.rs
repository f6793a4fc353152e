//! Machine code of a line.

use crate::{Scratch, StraightLine};
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
    /// Code for so many lanes; `None` if there is none for this processor or this number of lanes, or the system grants no memory
    /// for it.
    #[must_use]
    pub fn new(line: &StraightLine, lanes: usize) -> Option<Self> {
        let set = InstructionSet::for_lanes(lanes)?;
        let assembled = match set.lanes {
            1 => assembled(line, set, lanes)?,
            _ => assembled(&written_out(line).ok()?, set, lanes)?,
        };
        Some(Self { code: Code::new(line, assembled, set.lanes, lanes)? })
    }

    /// Runs the line as [`StraightLine::interpret`] does, in the lanes it was compiled for.
    ///
    /// # Panics
    /// If there are fewer numbers than places or arguments times lanes.
    pub fn run(&self, places: &mut [f64], arguments: &[f64], scratch: &mut Scratch) {
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
    pub fn run(&self, _: &mut [f64], _: &[f64], _: &mut Scratch) {
        match self.none {}
    }
}
