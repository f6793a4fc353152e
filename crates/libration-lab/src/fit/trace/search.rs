//! Search for the minimum without a guess: from the first swings on, with growing parts of the traces.

use libration::internals::progress::Watch;
use std::f64::consts::TAU;

use super::TraceFitError;
use super::layout::Layout;
use super::minimum::{Care, Descent, Start, deeper};
use super::problem::{PATIENCE, Problem};

/// Growth of the part of the traces that is fitted, in periods of small swings.
///
/// The numbers were varied over 24 recordings with linear and quadratic damping: twelve measured ones by an encoder, released at up to
/// 180°, and by videos, and twelve synthetic ones, of which three were released within 10° of the top, one began over it and two
/// were angular velocities from 140° and 175°. The comment on a number states which of them ended in another minimum.
struct WindowGrowth {
    /// First number of cycles. With 0.75 to 3 all ended alike but one near the top, lost with 0.75; with 6 six were lost.
    first: f64,
    /// Ratio of successive lengths. With 1.5 all gave the same results; with 4 two were lost, the release at 180° and the one that begins over the
    /// top.
    factor: f64,
    /// Number of cycles above which damping is fitted: with damping from the first cycle on one near the top was lost, from 5.9 on the one that
    /// begins over the top, and one more if damping is fitted to the whole trace only.
    damped_from: f64,
}

/// A quick search, and a careful one: near the top a small damping decides whether the pendulum goes over it. Without the careful one the release
/// at 179.5° was lost; with 0.4 to 1.5 cycles, factors of 1.15 to 1.7 and damping from 2.9 on the results were the same.
const QUICK: WindowGrowth = WindowGrowth { first: 1.5, factor: 2.0, damped_from: 2.9 };
const CAREFUL: WindowGrowth = WindowGrowth { first: 0.75, factor: 1.3, damped_from: 0.0 };
/// Evaluations for each parameter during the growth, as MINPACK counts them: 4 and 20 ended alike.
const PATIENCE_GROWING: usize = 10;
/// Cycles above which all kinds of damping are fitted at once: 5.9, 23.9 and 1000 gave the same results; with all from the
/// first cycle on the two angular velocities were lost.
const CYCLES_OF_ALL_DAMPING: f64 = 11.9;
/// Number of cycles after which a failure is one of the model and not of the search. With 10⁶ the results were the same; a wrong model is then
/// tried twice.
const CYCLES_OF_SEARCH: f64 = 5.0;
/// Largest unexplained fraction of the scatter after a successful fit: 0.0005 and 0.05 gave the same results. A right model
/// leaves more if noise is above a twentieth of the signal, and is then tried twice.
const GOOD: f64 = 0.0025;

/// Largest ratio of a trace to the part in which the motion loses it, for a descent over the whole: farther on they are out of phase, and a sum of
/// squares over hundreds of cycles has a minimum for each cycle that is lost.
const FAR: f64 = 16.0;

/// Least correlation, the cosine of the phase between motion and data, in all parts of a trace: with a difference below an eighth of a turn no
/// cycle is lost.
const IN_PHASE: f64 = 0.7;
/// Relative difference of sums of squares below which two searches have led to the same minimum.
const ALIKE: f64 = 1e-3;

/// The end of a search, and the number of cycles after which the model no longer followed the data.
struct Followed {
    end: Descent,
    until: Option<f64>,
}

/// Finds the approximate minimum, from the first swings on; `deepest` is the deepest known so far.
pub fn from_scratch(
    problem: &Problem<'_>,
    deepest: Option<&Descent>,
    watch: &Watch<'_>,
) -> Result<Descent, TraceFitError> {
    let beginning = beginning(problem);
    let quick = grown(problem, beginning.clone(), &QUICK, watch);
    match quick {
        Err(TraceFitError::Interrupted) => Err(TraceFitError::Interrupted),
        Ok(followed) if !is_lost(&followed, deepest) => Ok(followed.end),
        quick => {
            let careful = grown(problem, beginning, &CAREFUL, watch);
            deeper(quick.map(|followed| followed.end), careful.map(|followed| followed.end))
        }
    }
}

/// Returns `true` if the search failed. It is the model that failed if it describes the beginning and fails later on; the search succeeded if the
/// motion is in phase with all parts of the data, or if another search leads to the same end.
fn is_lost(followed: &Followed, deepest: Option<&Descent>) -> bool {
    followed.end.unexplained > GOOD
        && followed.end.least_correlation < IN_PHASE
        && followed.until.is_none_or(|cycles| cycles <= CYCLES_OF_SEARCH)
        && !deepest.is_some_and(|other| are_alike(other, &followed.end))
}

/// Returns `true` if two searches have led to the same minimum, in which the motion is in phase.
pub(super) fn are_alike(one: &Descent, other: &Descent) -> bool {
    !one.is_lost() && (one.sum_of_squares / other.sum_of_squares - 1.0).abs() < ALIKE
}

/// Evaluations for each parameter of the last descent: few if the search has lost the data, and none if it has not converged either.
pub(super) fn patience(end: &Descent) -> usize {
    match end.is_lost() {
        true if !end.converged => 1,
        true => PATIENCE_GROWING,
        false => PATIENCE,
    }
}

/// Finds the minimum by growing parts of the traces.
fn grown(
    problem: &Problem<'_>,
    mut parameters: Vec<f64>,
    growth: &WindowGrowth,
    watch: &Watch<'_>,
) -> Result<Followed, TraceFitError> {
    let mut cycles = growth.first;
    while cycles < problem.cycles {
        let free = free_within(problem.model.layout, cycles, growth);
        // In the first swings an error is cheaply avoided and hard to correct: next to the top everything depends on them.
        let care = if cycles < CYCLES_OF_ALL_DAMPING { Care::FIRST_SWINGS } else { Care::GROWTH };
        let start = Start { parameters, free, patience: PATIENCE_GROWING, care };
        let descent = problem.descent_over(cycles, start, watch)?;
        let is_lost = descent.is_lost();
        parameters = descent.parameters;
        if is_lost {
            let end = if problem.cycles > FAR * cycles {
                problem.without_descent(parameters, watch)?
            } else {
                problem.approach(parameters, PATIENCE_GROWING, watch)?
            };
            return Ok(Followed { end, until: Some(cycles) });
        }
        cycles *= growth.factor;
    }
    let end = problem.approach(parameters, PATIENCE, watch)?;
    Ok(Followed { end, until: None })
}

/// The parameters that this number of cycles determines: in few of them the kinds of damping cannot be distinguished.
fn free_within(layout: Layout, cycles: f64, growth: &WindowGrowth) -> Vec<usize> {
    let damping = layout.coefficients();
    let is_free = |index: &usize| match damping.contains(index) {
        true if cycles >= CYCLES_OF_ALL_DAMPING => true,
        true => *index == damping.start && cycles >= growth.damped_from,
        false => *index != layout.scale(),
    };
    (0..layout.len()).filter(is_free).collect()
}

/// The starting parameters of the search, without damping.
fn beginning(problem: &Problem<'_>) -> Vec<f64> {
    let layout = problem.model.layout;
    let mut parameters = vec![0.0; layout.len()];
    parameters[layout.scale()] = 1.0;
    parameters[Layout::OMEGA0] = TAU * problem.cycles / problem.data.span();
    for (number, begin) in problem.beginnings.iter().enumerate() {
        parameters[layout.offset(number)] = begin.offset;
        for (index, value) in layout.first_state(number).into_iter().zip(begin.state) {
            parameters[index] = value;
        }
    }
    parameters
}
