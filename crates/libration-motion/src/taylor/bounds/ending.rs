//! The uncertainty of the end of an integration that an event ends.
//!
//! # Method
//! The uncertainty of an end that an event determines has two parts. The truncation error comes from a second integration to a thousandth of the
//! tolerance. The roundings, which both integrations share, are bounded step by step (`roundings_of_steps.rs`), those of the forces from each
//! operation (`linearised.rs`), and carried from the last step back to the first (`gathered.rs`) by differences of neighbouring motions
//! (`growth.rs`), so that forces may jump, at times that are rounded too. Of long motions 4096 steps are kept at a time (`survey.rs`). An event
//! that ends the motion turns the deviation of the state into one of the time (`crossing.rs`, `outcome.rs`).

use super::gathered::gathered_roundings;
use crate::taylor::{Effort, IntegrationError, Moment, System, integrate};
use libration_numbers::progress::Quiet;

/// The uncertainty of time and state at the end of an integration, each component in its unit.
///
/// Where an event ends the motion, its time is as uncertain as the motion is there over how fast its formula changes: this tells both.
///
/// # Accuracy
/// Two errors are added up. What the steps leave out of their series is seen by another integration, to a thousandth of the tolerance: what
/// that has otherwise, and half as much again. What the steps lose by rounding is bounded step by step, from the terms of their series and
/// from each operation of the forces, and followed to the end by how small deviations of this motion grow, which motions next to it tell. All
/// these are added as if they had the same sign: where roundings are all there is, a pendulum's error is stated some ten to a hundred times
/// too large. Where a motion next to it stops, as next to the end of a formula, where deviations grow beyond all numbers, as in long chaotic
/// motions, or where the steps times the square of how many numbers the state has are above a million, the difference of the two
/// integrations is taken ten times instead.
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
    /// Factor for the error of the finer steps, a thousandth, and for changes of order, which are a matter of chance.
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

/// The end by steps to a thousandth of all tolerances.
fn finer(system: &System, start: &Moment, last: f64, effort: &Effort) -> Result<Moment, IntegrationError> {
    let relative = (effort.relative / 1000.0).max(Effort::TOLERANCES[0]);
    let finer = Effort { relative, absolute: effort.absolute / 1000.0, ..*effort };
    Ok(integrate(&system.with_part_of_tolerances(0.001), start, &[last], &finer, &Quiet)?.end)
}
