//! The uncertainty of the end of an integration that is ended by an event.
//!
//! # Method
//! The uncertainty of an end that is determined by an event has two parts. The truncation error comes from a second integration to a thousandth
//! of the tolerance. The rounding errors, which are the same in both integrations, are bounded step by step (`roundings_of_steps.rs`), those of
//! the forces from each operation (`linearised.rs`), and carried from the last step back to the first (`gathered.rs`) by differences of
//! neighbouring motions (`growth.rs`), so that forces may jump, at times that are rounded too. Of long motions 4096 steps are stored at a time
//! (`survey.rs`). An event that ends the motion turns the deviation of the state into one of the time (`crossing.rs`, `outcome.rs`).

use super::gathered::gathered_roundings;
use crate::taylor::{Effort, IntegrationError, Moment, System, integrate};
use libration_numbers::progress::Quiet;

/// The uncertainty of time and state at the end of an integration, each component in its unit.
///
/// If an event ends the motion, the uncertainty of the time of the event is that of the event's
/// formula divided by the rate of change of the formula; the result contains both uncertainties.
///
/// # Accuracy
/// Two errors are added up. The truncation error of the steps is the difference from another integration, to a thousandth of the tolerance, and
/// half as much again. The rounding errors of the steps are bounded step by step, from the terms of their series and from each operation of the
/// forces, and multiplied by the growth of small deviations until the end, which is computed from neighbouring motions. All these are added as
/// if they had the same sign: if the error consists of roundings only, a pendulum's error is stated some ten to a hundred times too large. If a
/// neighbouring motion stops, as next to the end of a formula, if deviations overflow, as in long chaotic motions, or if the number of steps
/// times the square of the number of state components is above a million, ten times the difference of the two integrations is used instead.
///
/// # Errors
/// As [`integrate()`].
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::progress::Quiet;
/// use libration::taylor::{Effort, Event, System, ending_error, integrate};
/// let bottom = Event { ends_at: Some(3), ..Event::zero_of("x".parse()?) };
/// let system = System::new(&"x'' = -x".parse()?)?.with_events(&[bottom])?;
/// let (start, effort) = (system.start(&[("x", 1.0)])?, Effort::to_tolerance(1e-9));
/// let end = integrate(&system, &start, &[100.0], &effort, &Quiet)?.end;
/// let error = ending_error(&system, &start, 100.0, &effort, &end)?;
/// assert!((end.time - 2.5 * std::f64::consts::PI).abs() <= error.time && error.time < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn ending_error(
    system: &System,
    start: &Moment,
    last: f64,
    effort: &Effort,
    end: &Moment,
) -> Result<Moment, IntegrationError> {
    /// Factor for the error of the finer steps, a thousandth, and for random changes of order.
    const MARGIN: f64 = 1.5;
    const MARGIN_ALONE: f64 = 10.0;
    let other = finer(system, start, last, effort)?;
    let size = start.state.iter().chain(&end.state).map(|value| value.abs()).fold(0.0, f64::max);
    let alone = || Moment {
        time: 8.0 * f64::EPSILON * end.time.abs(),
        state: vec![8.0 * f64::EPSILON * size; end.state.len()],
    };
    let (margin, roundings) = match gathered_roundings(system, start, last, effort)? {
        Some(roundings) => (MARGIN, roundings),
        None => (MARGIN_ALONE, alone()),
    };
    let error = |a: f64, b: f64, rounding: f64| margin * (a - b).abs() + rounding;
    let pairs = end.state.iter().zip(&other.state).zip(&roundings.state);
    Ok(Moment {
        time: error(end.time, other.time, roundings.time),
        state: pairs.map(|((a, b), rounding)| error(*a, *b, *rounding)).collect(),
    })
}

/// The end, computed by steps to a thousandth of all tolerances.
fn finer(system: &System, start: &Moment, last: f64, effort: &Effort) -> Result<Moment, IntegrationError> {
    let relative = (effort.relative / 1000.0).max(Effort::TOLERANCES[0]);
    let finer = Effort { relative, absolute: effort.absolute / 1000.0, ..*effort };
    Ok(integrate(&system.with_part_of_tolerances(0.001), start, &[last], &finer, &Quiet)?.end)
}
