//! Slow flows with symbolic parameters, several small terms and a drive.
//!
//! # Method
//! With the drive's phase W·t = p·s and W = (p/q)·ω0 + εσ the displacement is sought as x = z·e^{iqs} + z̄·e^{−iqs} + Σ εⁿ·xₙ(s, z, z̄) with
//! z = A·e^{iφ}/2 and z′ = Σ εⁿ·zₙ(z, z̄): multiple scales, with all slow scales in one rate. The time derivative is D = (ω0/q + εσ/p)·∂ₛ + z′·∂_z +
//! z̄′·∂_z̄, and what D²x + ω0²·x = f leaves over at εⁿ, with xₙ and zₙ left out, determines them: its waves e^{±iqs} are 2iω0·zₙ·e^{iqs} with the
//! conjugate, the others are divided by ω0²·(1 − k²/q²). No wave e^{iqs} is added to xₙ, so that A is the whole amplitude of the displacement's
//! component of the frequency (q/p)·W at every order. A drive of order zero is part of x₀. All sums are Laurent polynomials in the symbols, z, z̄,
//! e^{is}, i and π (`letters.rs`).
//!
//! Of several coordinates each has its zⱼ, and the frequencies of all are whole multiples of that of one wave; the detunings of natural frequencies are
//! small linear terms (`coupled.rs`).
//!
//! Forces with |x|, |x′| and their signs contribute exact integrals over half waves, to the order at which their harmonics would act back.
//!
//! Terms without a small parameter whose degree in x and x′ is d are small with the amplitude, of order d − 1; the degrees of all terms count then.

mod coupled;
mod criteria;
mod elimination;
mod equations;
mod error;
mod evaluation;
mod force;
mod half_wave;
mod left_out;
mod letters;
mod notes;
mod phase_sums;
mod result;
mod scales;
mod second_order;
mod setting;
mod small_terms;
mod states;
mod steady;
mod steady_state;
mod steps;
mod turned;

use equations::Found;
use force::DriveFrequency;
use letters::Column;
use libration_numbers::expression::{Equation, Expression};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;
use scales::{Forced, Solved};
use setting::Setting;
use steady::Obstacle;

pub use coupled::{CoordinateFlow, CoupledSlowFlow, coupled_slow_flow};
pub use error::{MAX_SYMBOLIC_SLOW_ORDER, SymbolicSlowFlowError};
pub use evaluation::{SlowFlowAt, SteadySolution};
pub use result::SymbolicSlowFlow;
pub use second_order::{EarlierOrder, RateProducts};
pub use small_terms::SmallTerm;
pub use states::{JudgedState, LeftOutReason, StateLeftOut, SteadyStates};
pub use steady_state::SteadyState;
pub use steps::{AmplitudeInTime, PhaseInTime, ResponseSteps, SlowFlowSteps};

/// Small parameters, resonance and order of a slow flow.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SymbolicSlowFlowOptions {
    /// Small parameters with their orders; if empty, `eps`, or small amplitudes only.
    pub small: Vec<(String, usize)>,
    /// p and q of the resonance W = (p/q)·ω0, drive over natural frequency, that of the first coordinate where there are several.
    pub resonance: Option<(u32, u32)>,
    /// The natural frequencies of several coordinates as whole numbers to which they are near, such as 1 and 2; empty if they follow from the
    /// equations.
    pub ratios: Vec<u32>,
    /// The equilibrium of one coordinate, from which the displacement is counted, such as √(a/b); none for 0.
    pub about: Option<Expression>,
    /// The highest order. By default the largest order that small parameters give a term, and one at which every term without small parameter acts
    /// on amplitude or phase, and the relation of steady states contains drive and damping, as far as forces with abs and sign allow it.
    pub order: Option<usize>,
}

/// The symbol of the drive frequency in an equation with a drive cos(W·t) or sin(W·t); `None` where there is none.
#[must_use]
pub fn drive_symbol(equation: &Equation) -> Option<String> {
    match DriveFrequency::of(equation.accelerations()) {
        Ok(Some(DriveFrequency::Symbol(name))) => Some(name),
        _ => None,
    }
}

/// The slow flow of an oscillator with symbolic parameters, free or driven, and its steady states.
///
/// # Errors
/// An equation that is not one oscillator with small terms, an order out of range, cancellation.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::perturbation::{SymbolicSlowFlowOptions, slow_flow_symbolically};
/// use libration::progress::Quiet;
/// let equation = "x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)".parse()?;
/// let options = SymbolicSlowFlowOptions { resonance: Some((1, 1)), ..Default::default() };
/// let flow = slow_flow_symbolically(&equation, &options, &Quiet)?;
/// assert_eq!(flow.amplitude_rate, "-eps*mu*A - eps*F/(2*w0)*sin(phi)");
/// assert_eq!(flow.steady_state.peak_amplitude.as_deref(), Some("F/(2*mu*w0)"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn slow_flow_symbolically(
    equation: &Equation,
    options: &SymbolicSlowFlowOptions,
    progress: &dyn Progress,
) -> Result<SymbolicSlowFlow, SymbolicSlowFlowError> {
    if equation.variables().len() != 1 {
        return Err(SymbolicSlowFlowError::SeveralEquations(equation.variables().len()));
    }
    let flow = answered(equation, options, progress, result::collected)?;
    if options.order.is_some() {
        return Ok(flow);
    }
    let needed = match flow.sums.steady.obstacle {
        Some(Obstacle::Order(needed)) => needed,
        _ => 0,
    };
    // Either order may be out of reach.
    for order in [flow.sums.steady.complete, needed] {
        let order = usize::try_from(order).ok().filter(|order| *order > flow.order);
        let higher = order.map(|order| SymbolicSlowFlowOptions { order: Some(order), ..options.clone() });
        match higher.map(|options| answered(equation, &options, progress, result::collected)) {
            Some(Ok(better)) if better.steady_state.relation.is_some() => return Ok(better),
            Some(Err(SymbolicSlowFlowError::Interrupted)) => return Err(SymbolicSlowFlowError::Interrupted),
            _ => {}
        }
    }
    Ok(flow)
}

/// The slow flow of the lowest higher order with further terms, for error estimates: for forces with a parity some orders have none. `None` if such
/// an order is not known.
pub fn next_slow_flow(
    equation: &Equation,
    options: &SymbolicSlowFlowOptions,
    flow: &SymbolicSlowFlow,
    progress: &dyn Progress,
) -> Option<SymbolicSlowFlow> {
    // A small term of the highest order acts back on itself at twice that order at the latest.
    for order in flow.order + 1..=2 * flow.order + 1 {
        let options = SymbolicSlowFlowOptions { order: Some(order), ..options.clone() };
        let next = slow_flow_symbolically(equation, &options, progress).ok()?;
        if next.sums.rates != flow.sums.rates {
            return Some(next);
        }
    }
    None
}

/// The steps to the slow flow of the lowest order that is not zero, or of the requested one if it is higher, or of the highest of the small
/// parameters; `None` if these steps take more than products of two terms of one order.
///
/// # Errors
/// Those of [`slow_flow_symbolically`].
pub fn slow_flow_steps(
    equation: &Equation,
    options: &SymbolicSlowFlowOptions,
    progress: &dyn Progress,
) -> Result<Option<SlowFlowSteps>, SymbolicSlowFlowError> {
    if equation.variables().len() != 1 {
        return Err(SymbolicSlowFlowError::SeveralEquations(equation.variables().len()));
    }
    let at = |order: usize| SymbolicSlowFlowOptions { order: Some(order), ..options.clone() };
    for lowest in 1..=MAX_SYMBOLIC_SLOW_ORDER {
        let all = |setting: &Setting, forced: &Forced<'_>, properties: &_, solved: &Solved, order| {
            let of = i64::try_from(lowest).unwrap_or(0);
            steps::steps(setting, forced, properties, solved, (equation, [of, order]))
        };
        // The steps, or the higher order that is wanted; `None` if this one does not act.
        let begun = |setting: &Setting, forced: &Forced<'_>, properties: &_, solved: &Solved, order| {
            let letters = forced.letters;
            let detuning = letters.index(Column::Detuning);
            if letters.part(&solved.rates[0], |powers| powers[detuning] == 0).is_zero() {
                return None;
            }
            let stated = setting.highest_order().and_then(|order| usize::try_from(order).ok());
            let wanted = options.order.or(stated).filter(|wanted| *wanted > lowest);
            Some(wanted.map_or_else(|| Ok(all(setting, forced, properties, solved, order)), Err))
        };
        match answered(equation, &at(lowest), progress, begun)? {
            None => {}
            Some(Ok(steps)) => return Ok(steps),
            Some(Err(order)) => return answered(equation, &at(order), progress, all),
        }
    }
    Ok(None)
}

impl Setting {
    /// The default order: that of the small parameters, and one at which terms without them act.
    fn default_order(&self, equation: &Equation, watch: &Watch<'_>) -> Result<i64, SymbolicSlowFlowError> {
        let stated = self.highest_order();
        let first = stated.unwrap_or(0).max(2);
        let (forced, properties) = self.forced(equation, first, watch)?;
        let order = stated
            .into_iter()
            .chain(properties.acting_order)
            .chain(properties.stated_order)
            .max()
            .unwrap_or(first);
        let most = i64::try_from(MAX_SYMBOLIC_SLOW_ORDER).unwrap_or(order);
        Ok(forced.highest_order().unwrap_or(order).min(order).min(most))
    }
}

/// The result that `collected` makes of the slow flow of an equation.
fn answered<R>(
    equation: &Equation,
    options: &SymbolicSlowFlowOptions,
    progress: &dyn Progress,
    collected: impl FnOnce(&Setting, &Forced<'_>, &Found, &Solved, i64) -> R,
) -> Result<R, SymbolicSlowFlowError> {
    let watch = Watch::new(progress);
    let setting = Setting::new(equation, options)?;
    let order = match options.order {
        Some(order) => i64::try_from(order).unwrap_or(0),
        None => setting.default_order(equation, &watch)?,
    };
    let asked = usize::try_from(order).unwrap_or(0);
    if !(1..=MAX_SYMBOLIC_SLOW_ORDER).contains(&asked) {
        return Err(SymbolicSlowFlowError::Order(asked));
    }
    let (forced, properties) = setting.forced(equation, order, &watch)?;
    let solved = forced.solve(order, &watch)?;
    Ok(collected(&setting, &forced, &properties, &solved, order))
}
