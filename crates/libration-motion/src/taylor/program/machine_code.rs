//! Machine code for expansions that are computed often.
//!
//! # Method
//! An expansion does the same arithmetic in every step. After 500 expansions, which cost as much as the compilation,
//! it is recorded once by a ring that notes each operation instead of computing it (`straight_line.rs`). The order
//! of all operations is therefore that of the lanes, and a test compares the bits of both. Systems that announce
//! thousands of steps, as in continuation in a parameter, are compiled at once. `plan.rs` stores the record and the
//! other data common to all expansions to an order, so that a short motion of a known system begins without delay.
//!
//! The zeroth coefficients of a single motion have separate code, except those of functions and their arguments,
//! which are computed before: they are needed once when a step is tried, and are the start of the next step. On other
//! processors, on wasm32, and on systems that provide no memory for code, expansions are computed by `program.rs`.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use libration_jit::{Compiled, StraightLine};

/// Machine code for one order and number of lanes, compiled once the expected gain in time exceeds its cost.
#[derive(Debug)]
pub struct MachineCode {
    lanes: usize,
    /// Number of further expansions that are computed without machine code.
    without: AtomicUsize,
    compiled: OnceLock<Option<Compiled>>,
}

impl MachineCode {
    /// The code for many expansions, compiled at the first one, or for an unknown number.
    pub(in crate::taylor) fn new(lanes: usize, for_many: bool) -> Self {
        /// Number of expansions before the code is compiled. For chains of 2 to 720 springs at orders 20 and 33, compiling takes as long as 40 to
        /// 750 expansions without code, most often 250; with code they take a tenth to a half of the time.
        const FIRST: usize = 500;
        let without = AtomicUsize::new(if for_many { 0 } else { FIRST });
        Self { lanes, without, compiled: OnceLock::new() }
    }

    /// The compiled code, whose argument is the unit of time, given the operations
    /// to be compiled; the results without it are the same bit for bit.
    pub fn compiled(&self, line: impl FnOnce() -> Option<StraightLine>) -> Option<&Compiled> {
        if let Some(code) = self.compiled.get() {
            return code.as_ref();
        }
        let one_fewer = |left: usize| left.checked_sub(1);
        if self.without.fetch_update(Ordering::Relaxed, Ordering::Relaxed, one_fewer).is_ok() {
            return None;
        }
        let compile = || Compiled::new(&line()?, self.lanes);
        self.compiled.get_or_init(compile).as_ref()
    }
}
