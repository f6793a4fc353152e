//! How well the end of an integration is known that an event sets.

use super::{Effort, IntegrationError, Moment, System, integrate};

/// By how much time and state of the end of an integration may be wrong, each number in its unit: what another integration, to a
/// thousandth of the tolerance, has otherwise, half as much again, and some roundings.
///
/// Where an event ends the motion, its time is as uncertain as the motion is there over how fast its formula changes: this tells both.
///
/// # Errors
/// As [`integrate()`].
///
/// # Examples
/// ```
/// use libration::taylor::{Effort, Event, System, ending_error, integrate};
/// let bottom = Event { ends_at: Some(3), ..Event::zero_of("x".parse()?) };
/// let system = System::new(&"x'' = -x".parse()?)?.with_events(&[bottom])?;
/// let (start, effort) = (system.start(&[("x", 1.0)])?, Effort::to_tolerance(1e-9));
/// let end = integrate(&system, &start, &[100.0], &effort)?.end;
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
    /// What the finer steps err by as well, a thousandth, and what changes of order leave to chance.
    const MARGIN: f64 = 1.5;
    const ROUNDINGS: f64 = 8.0 * f64::EPSILON;
    let relative = (effort.relative / 1000.0).max(Effort::TOLERANCES[0]);
    let finer = Effort { relative, absolute: effort.absolute / 1000.0, ..*effort };
    let other = integrate(&system.with_part_of_tolerances(0.001), start, &[last], &finer)?.end;
    let size = start.state.iter().chain(&end.state).map(|value| value.abs()).fold(0.0, f64::max);
    let error = |a: f64, b: f64, size: f64| MARGIN * (a - b).abs() + ROUNDINGS * size;
    let pairs = end.state.iter().zip(&other.state);
    Ok(Moment {
        time: error(end.time, other.time, end.time.abs()),
        state: pairs.map(|(a, b)| error(*a, *b, size)).collect(),
    })
}
