//! The way to the minimum from no guess: from the first swings on, taking more and more of the traces.

use libration::watch::Watch;
use std::f64::consts::TAU;

use super::layout::Layout;
use super::minimum::{Minimum, Start, deeper, minimum};
use super::problem::{PATIENCE, Problem};
use super::weights::Weights;
use super::{TraceFitError, weak_form};
use crate::statistics::median;

/// How more and more of the traces is taken, in small periods.
///
/// The numbers were varied over 24 recordings with linear and quadratic damping: twelve measured ones by an encoder, released at up to
/// 180°, and by videos, and twelve synthetic ones, of which three were released within 10° of the top, one began over it and two
/// were angular velocities from 140° and 175°. What is said of a number is which of them ended in another minimum.
struct Growth {
    /// With 0.75 to 3 cycles at first all ended alike but one near the top, lost with 0.75; with 6 six were lost.
    first: f64,
    /// With 1.5 all ended alike; with 4 two were lost, the release at 180° and the one that begins over the top.
    factor: f64,
    /// Below it damping is not looked for: with damping from the first cycle on one near the top was lost, from 5.9 on the one
    /// that begins over the top, and one more where damping is looked for in the whole trace only.
    damped_from: f64,
}

/// Quick, and careful: near the top a little damping decides whether the pendulum goes over it. Without the careful one the release
/// at 179.5° was lost; with 0.4 to 1.5 cycles, factors of 1.15 to 1.7 and damping from 2.9 on it ended alike.
const QUICK: Growth = Growth { first: 1.5, factor: 2.0, damped_from: 2.9 };
const CAREFUL: Growth = Growth { first: 0.75, factor: 1.3, damped_from: 0.0 };
/// Evaluations for each parameter on the way, as MINPACK counts them: 4 and 20 ended alike.
const PATIENCE_GROWING: usize = 10;
/// Cycles from which on all kinds of damping are looked for at once: 5.9, 23.9 and 1000 ended alike; with all from the first cycle
/// on the two angular velocities were lost.
const CYCLES_OF_ALL_DAMPING: f64 = 11.9;
/// A search that has followed the data for so long is not lost where it fails later on: it is the model that fails. With 10⁶ all
/// ended alike; a model that is wrong is then tried twice.
const CYCLES_OF_SEARCH: f64 = 5.0;
/// Of the scatter of the data, the part that a fit leaves if it has not failed: 0.0005 and 0.05 ended alike. A right model leaves
/// more where noise is above a twentieth of the signal, and is then tried twice.
const GOOD: f64 = 0.0025;
/// The part beyond which it has: 0.2 and 0.8 ended alike. The motion of another pendulum leaves about one, or two if out of phase.
pub(super) const HOPELESS: f64 = 0.5;

/// A minimum, and the number of cycles after which the model could no longer follow the data on the way to it.
struct Followed {
    minimum: Minimum,
    until: Option<f64>,
}

/// The minimum, from the first swings on.
pub(super) fn from_scratch(problem: &Problem<'_>, watch: &Watch<'_>) -> Result<Minimum, TraceFitError> {
    let beginning = beginning(problem)?;
    let quick = grown(problem, beginning.clone(), &QUICK, watch);
    match quick {
        Err(TraceFitError::Interrupted) => Err(TraceFitError::Interrupted),
        Ok(found) if !is_lost(problem, &found) => Ok(found.minimum),
        quick => {
            let careful = grown(problem, beginning, &CAREFUL, watch);
            deeper(quick.map(|found| found.minimum), careful.map(|found| found.minimum))
        }
    }
}

/// Whether the search failed, and not the model, as where it describes the beginning and fails later on.
fn is_lost(problem: &Problem<'_>, found: &Followed) -> bool {
    problem.unexplained(&found.minimum) > GOOD && found.until.is_none_or(|cycles| cycles <= CYCLES_OF_SEARCH)
}

/// The minimum by growing parts of the traces.
fn grown(
    problem: &Problem<'_>,
    mut parameters: Vec<f64>,
    growth: &Growth,
    watch: &Watch<'_>,
) -> Result<Followed, TraceFitError> {
    let (data, model) = (problem.data, &problem.model);
    let period = TAU / parameters[Layout::OMEGA0];
    let stated = Weights::stated(data.traces);
    let mut cycles = growth.first;
    while cycles * period < data.span() {
        let rows = data.rows_within(cycles * period, model.layout.len() + 2);
        let free = free_within(model.layout, cycles, growth);
        let start = Start { parameters, free, rows: rows.clone(), patience: PATIENCE_GROWING };
        let found = minimum(data, model, stated.clone(), start, watch)?;
        let hopeless = found.sum_of_squares() > HOPELESS * data.scatter(&rows, &stated);
        parameters = found.parameters;
        if hopeless {
            let minimum = problem.minimum_near(parameters, PATIENCE_GROWING, watch)?;
            return Ok(Followed { minimum, until: Some(cycles) });
        }
        cycles *= growth.factor;
    }
    let minimum = problem.minimum_near(parameters, PATIENCE, watch)?;
    Ok(Followed { minimum, until: None })
}

/// The parameters that so many cycles determine: in few of them one kind of damping is as good as another.
fn free_within(layout: Layout, cycles: f64, growth: &Growth) -> Vec<usize> {
    let damping = layout.coefficients();
    let is_free = |place: &usize| match damping.contains(place) {
        true if cycles >= CYCLES_OF_ALL_DAMPING => true,
        true => *place == damping.start && cycles >= growth.damped_from,
        false => *place != layout.scale(),
    };
    (0..layout.len()).filter(is_free).collect()
}

/// The parameters at which the search begins, without damping.
fn beginning(problem: &Problem<'_>) -> Result<Vec<f64>, TraceFitError> {
    let layout = problem.model.layout;
    let mut parameters = vec![0.0; layout.len()];
    parameters[layout.scale()] = 1.0;
    let mut omega0 = vec![];
    for (number, trace) in problem.data.traces.iter().enumerate() {
        let no_pendulum = || TraceFitError::NoPendulum { name: trace.name().to_owned() };
        let begin = weak_form::beginning(trace).ok_or_else(no_pendulum)?;
        omega0.push(begin.omega0);
        parameters[layout.offset(number)] = begin.offset;
        for (place, value) in layout.first_state(number).into_iter().zip(begin.state) {
            parameters[place] = value;
        }
    }
    parameters[Layout::OMEGA0] = median(omega0).ok_or(TraceFitError::NoTrace)?;
    Ok(parameters)
}
