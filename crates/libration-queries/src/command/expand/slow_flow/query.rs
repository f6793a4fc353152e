//! The slow flow as the result of `libration expand`.

use super::{DAMPING_ORDER, SlowFlowResult, write};
use crate::arguments::Asked;
use crate::call;
use crate::command::expand::{Expand, LISTED};
use crate::query_error::{QueryError, option};
use libration::oscillator::Remedy;
use libration::perturbation::Gauge;
use std::io::Write;

impl Expand {
    /// Writes the slow flow, with a note, if an open parameter is the strength of a force that has no expansion as a limit cycle, but has a slow
    /// flow.
    pub(in crate::command::expand) fn slow_flow_or(
        &self,
        out: &mut dyn Write,
        refused: QueryError,
    ) -> Result<(), QueryError> {
        if self.evaluate.is_some() {
            return self.symbolic_flow_or(out, refused);
        }
        let mut answer = vec![];
        match self.oscillator.asked().and_then(|asked| self.answer_slow_flow(&mut answer, asked)) {
            Ok(()) => {}
            Err(interrupted) if interrupted.is_cancelled() => return Err(interrupted),
            // A hint to the slow flow would be false.
            Err(_) => return self.symbolic_flow_or(out, refused.with_remedies(&[Remedy::Simulation])),
        }
        call::current().note(
            "there is no expansion as a limit cycle; this is the slow flow (<--damping-order>), with the rate of the amplitude",
        );
        Ok(out.write_all(&answer)?)
    }

    /// The equation whose slow flow is requested, by an option or by a key in the catalogue of damped systems only.
    pub(in crate::command::expand) fn slow_flow(&self) -> Result<Option<Asked>, QueryError> {
        match self.oscillator.asked_of_system(self.small.as_deref()) {
            Some(asked) => asked.map(Some),
            None if self.damping_order.is_some() || self.small.is_some() => self.oscillator.asked().map(Some),
            None => Ok(None),
        }
    }

    pub(in crate::command::expand) fn answer_slow_flow(
        &self,
        out: &mut dyn Write,
        asked: Asked,
    ) -> Result<(), QueryError> {
        if self.evaluate.is_some() {
            let reason =
                "the slow flow is not a series at one amplitude: simulate the motion by <libration simulate>";
            return Err(QueryError::usage(option("evaluate"), reason));
        }
        let order = self.order.unwrap_or(LISTED);
        let gauge = self.gauge.clone().unwrap_or(Gauge::XMax);
        let orders = [order, self.damping_order.unwrap_or(DAMPING_ORDER)];
        let answer = SlowFlowResult::new(asked, self.small.as_deref(), orders, &gauge)?;
        write(out, self.form.form(), self.formats.format(), &answer)?;
        Ok(out.flush()?)
    }
}
