//! State components that reach zero in a finite time and stay there, as x′ =
//! −√|x|·sign(x) does: the height of water over a hole, by Torricelli's law.
//!
//! Before this time steps become shorter and shorter, in proportion to the remaining time. If that is below the resolution of times, the
//! component is set to zero, and the motion is continued by the equations with zero in its place.

use super::stepper::SHORTEST;
use crate::taylor::program::moduli::where_zero;
use crate::taylor::program::passage::Passage;
use crate::taylor::{Cause, Moment, System};
use libration_numbers::expression::{Equation, Expression};

/// The outcome of a motion for which no step is possible.
#[derive(Debug)]
pub(in crate::taylor) enum Rest {
    /// A state component has reached zero: the equations that hold from here on, and the state.
    In(Box<System>, Moment),
    /// The component is zero, and may leave zero at any time or not at all.
    Undecided,
}

/// The outcome for a motion that has come to rest in one state component, forward or backward in time; `None` if it has not.
pub(in crate::taylor) fn rest(
    system: &System,
    moment: &Moment,
    parameters: &[f64],
    backward: bool,
) -> Option<Rest> {
    let passage = system.passage()?;
    let in_moduli = passage.roots().iter().filter_map(|&modulus| system.driven_in_modulus(modulus));
    let numbers = in_moduli.chain(passage.bases().iter().copied());
    let mut all = numbers.filter_map(|number| {
        let equation = at_zero(system, number)?;
        let side = ZeroVicinity { passage, system, moment, parameters, number };
        match side.leads_to_zero(backward)? {
            true => {
                let mut state = moment.state.clone();
                state[number] = 0.0;
                let system = Box::new(system.at_rest(equation, number)?);
                Some(Rest::In(system, Moment { time: moment.time, state }))
            }
            false => Some(Rest::Undecided),
        }
    });
    all.next()
}

impl Rest {
    /// Returns `true` for causes that may be due to a component at rest.
    pub(in crate::taylor) fn may_explain(cause: Cause) -> bool {
        matches!(cause, Cause::StepUnderflow | Cause::Singularity | Cause::NoWayOn)
    }
}

/// The equations with a state component replaced by zero, if its rate of change vanishes with it.
fn at_zero(system: &System, number: usize) -> Option<Equation> {
    let equation = system.equation();
    let coordinate = system.layout().driving(number)?;
    let symbol = &system.layout().symbols(equation.variables())[number];
    let derivatives: Vec<Expression> =
        equation.derivatives().iter().map(|formula| where_zero(formula, symbol)).collect();
    let has_values = derivatives.iter().all(|formula| formula.without_value().is_none());
    let rests = derivatives[coordinate].vanishes() && has_values;
    let (variables, orders) = (equation.variables().to_vec(), equation.orders().to_vec());
    rests.then(|| Equation::of_derivatives(variables, orders, derivatives))
}

/// The vicinity of zero in one state component.
struct ZeroVicinity<'a> {
    passage: &'a Passage,
    system: &'a System,
    moment: &'a Moment,
    parameters: &'a [f64],
    number: usize,
}

impl ZeroVicinity<'_> {
    /// The rate of change of the component at this value.
    fn rate(&self, value: f64) -> Option<f64> {
        let Self { passage, system, moment, parameters, number } = self;
        let mut state = moment.state.clone();
        state[*number] = value;
        Some(passage.at(moment.time, &state, parameters)?.rates(system.layout(), &state)[*number])
    }

    /// Returns `true` if both sides lead to zero; `None` if zero is farther away than the resolution of times.
    fn leads_to_zero(&self, backward: bool) -> Option<bool> {
        /// Number of shortest steps within which times are not distinguished.
        const STEPS: f64 = 64.0;
        /// Distance of the test points from zero for a component that is zero.
        const NEAR: f64 = 1e-60;
        let here = self.moment.state[self.number];
        let left = STEPS * SHORTEST * self.moment.time.abs();
        if here != 0.0 && (here / self.rate(here)?).abs() > left {
            return None;
        }
        let distance = if here == 0.0 { NEAR } else { here.abs() };
        // A side on which the rate has no value does not lead to zero.
        let sides = [distance, -distance].map(|value| Some(self.rate(value)? * value.signum()));
        let mut rates = sides.into_iter().flatten().peekable();
        rates.peek()?;
        Some(rates.all(|rate| if backward { rate > 0.0 } else { rate < 0.0 }))
    }
}
