//! Machine code for expansions that are done often.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use libration_jit::{Compiled, StraightLine};

/// That for all orders and numbers of lanes in which a system was expanded.
#[derive(Debug, Default)]
pub(super) struct MachineCodes {
    known: Mutex<Vec<Arc<MachineCode>>>,
}

impl MachineCodes {
    pub(super) fn find(&self, order: usize, lanes: usize) -> Arc<MachineCode> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = known.iter().find(|it| it.order == order && it.lanes == lanes) {
            return Arc::clone(found);
        }
        let new = Arc::new(MachineCode {
            order,
            lanes,
            expansions: AtomicUsize::new(0),
            compiled: OnceLock::new(),
        });
        known.push(Arc::clone(&new));
        new
    }
}

/// That for one order and number of lanes, once it pays.
#[derive(Debug)]
pub(super) struct MachineCode {
    order: usize,
    lanes: usize,
    /// How many were done without it.
    expansions: AtomicUsize,
    compiled: OnceLock<Option<Compiled>>,
}

impl MachineCode {
    /// The code of an expansion that starts from the zeroth coefficients, with the unit of time as argument, given what it does; the same
    /// bits come out without it.
    pub(super) fn expansion(&self, line: impl FnOnce() -> Option<StraightLine>) -> Option<&Compiled> {
        /// Compiling takes as long as so many expansions without, for chains of 2 to 720 springs, at orders 20 and 33, as 40 to 750, and
        /// most often as 250; after it they take a tenth to a half.
        const FIRST: usize = 500;
        if let Some(known) = self.compiled.get() {
            return known.as_ref();
        }
        if self.expansions.fetch_add(1, Ordering::Relaxed) < FIRST {
            return None;
        }
        let compile = || Compiled::new(&line()?, self.lanes);
        self.compiled.get_or_init(compile).as_ref()
    }
}
