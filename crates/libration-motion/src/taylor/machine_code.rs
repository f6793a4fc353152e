//! Machine code for expansions that are done often.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use libration_jit::{Compiled, StraightLine};

/// That for one order and number of lanes, once it pays.
#[derive(Debug)]
pub struct MachineCode {
    lanes: usize,
    /// How many are still done without it.
    without: AtomicUsize,
    compiled: OnceLock<Option<Compiled>>,
}

impl MachineCode {
    /// For so many expansions that it pays from the first on, or for nobody knows how many.
    pub(super) fn new(lanes: usize, for_many: bool) -> Self {
        /// Compiling takes as long as so many expansions without, for chains of 2 to 720 springs, at orders 20 and 33, as 40 to 750, and
        /// most often as 250; after it they take a tenth to a half.
        const FIRST: usize = 500;
        let without = AtomicUsize::new(if for_many { 0 } else { FIRST });
        Self { lanes, without, compiled: OnceLock::new() }
    }

    /// The code, with the unit of time as argument, given what it does; the same bits come out without it.
    pub fn compiled(&self, line: impl FnOnce() -> Option<StraightLine>) -> Option<&Compiled> {
        if let Some(known) = self.compiled.get() {
            return known.as_ref();
        }
        let one_fewer = |left: usize| left.checked_sub(1);
        if self.without.fetch_update(Ordering::Relaxed, Ordering::Relaxed, one_fewer).is_ok() {
            return None;
        }
        let compile = || Compiled::new(&line()?, self.lanes);
        self.compiled.get_or_init(compile).as_ref()
    }
}
