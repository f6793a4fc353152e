//! The parts that all expansions of a system to an order share, made once.

use std::sync::{Arc, Mutex, PoisonError};

use super::block::Row;
use super::boundary::Boundary;
use super::machine_code::MachineCode;
use super::program::Program;
use super::steep::Steep;

/// The plans for all orders and numbers of lanes in which a system was expanded.
#[derive(Debug, Default)]
pub(super) struct Plans {
    known: Mutex<Vec<Arc<Plan>>>,
}

impl Plans {
    pub(super) fn find(&self, order: usize, lanes: usize, new: impl FnOnce() -> Plan) -> Arc<Plan> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = known.iter().find(|it| it.order == order && it.lanes == lanes) {
            return Arc::clone(found);
        }
        let new = Arc::new(new());
        known.push(Arc::clone(&new));
        new
    }
}

/// The plan for one order and number of lanes.
#[derive(Debug)]
pub struct Plan {
    pub(super) order: usize,
    pub(super) lanes: usize,
    pub program: Program,
    /// Boundaries of the accelerations and of the arguments of each |…|.
    pub(super) boundaries: Vec<Boundary<Row>>,
    /// Values of which the accelerations are steep functions.
    pub(super) steep: Vec<Steep<Row>>,
    /// Code for the zeroth coefficients of all but functions, and of all that these need.
    pub(super) beginning: MachineCode,
    /// Code for the coefficients of higher order.
    pub expansion: MachineCode,
}
