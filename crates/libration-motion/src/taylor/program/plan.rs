//! The data common to all expansions of a system to an order, computed once.

use std::sync::{Arc, Mutex, PoisonError};

use super::machine_code::MachineCode;
use crate::taylor::events::boundary::Boundary;
use crate::taylor::events::steep::Steep;
use crate::taylor::program::Program;
use crate::taylor::step::block::Row;

/// The plans for all orders and numbers of lanes in which a system was expanded.
#[derive(Debug, Default)]
pub(in crate::taylor) struct Plans {
    plans: Mutex<Vec<Arc<Plan>>>,
}

impl Plans {
    pub(in crate::taylor) fn find(
        &self,
        order: usize,
        lanes: usize,
        new: impl FnOnce() -> Plan,
    ) -> Arc<Plan> {
        let mut plans = self.plans.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(plan) = plans.iter().find(|plan| plan.order == order && plan.lanes == lanes) {
            return Arc::clone(plan);
        }
        let new = Arc::new(new());
        plans.push(Arc::clone(&new));
        new
    }
}

/// The plan for one order and number of lanes.
#[derive(Debug)]
pub struct Plan {
    pub(in crate::taylor) order: usize,
    pub(in crate::taylor) lanes: usize,
    pub program: Program,
    /// Boundaries of the accelerations and of the arguments of each |…|.
    pub(in crate::taylor) boundaries: Vec<Boundary<Row>>,
    /// Values of which the accelerations are steep functions.
    pub(in crate::taylor) steep: Vec<Steep<Row>>,
    /// The arguments of |…| that are not linear in the state. Truncated after the same step, their series have larger errors than those of the
    /// state, so that a change of sign may be missed: a force with sign(x³ − 1/8) was wrong after the first one.
    pub(in crate::taylor) curved: Vec<Row>,
    /// Code for the zeroth coefficients of all rows except functions and their operands.
    pub(in crate::taylor) beginning: MachineCode,
    /// Code for the coefficients of higher order.
    pub expansion: MachineCode,
}
