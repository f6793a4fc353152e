//! Choice of the times if those of the file are rounded: as written, or the equally spaced ones of which they are roundings.

use super::super::choices::{Choice, Finding, TimeStamps};
use super::super::faults::Clock;
use super::super::{Faults, MeasurementError};

/// Equally spaced times in place of those in the file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ReplacedTimes {
    pub(super) times: Vec<f64>,
    /// The relative uncertainty common to all times.
    pub(super) relative_uncertainty: f64,
}

/// The equally spaced times, if they are requested, or if the rounding is so coarse that rows share times or its steps grow with
/// the times, and nothing contradicts them.
pub(super) fn even(
    times: &[f64],
    values: &[f64],
    asked: Option<TimeStamps>,
    run: &str,
    tell: &mut impl FnMut(Finding),
) -> Result<Option<ReplacedTimes>, MeasurementError> {
    if asked == Some(TimeStamps::AsWritten) {
        return Ok(None);
    }
    let clock = Faults::detect(times, values, None).clock;
    let is_asked = asked == Some(TimeStamps::Even);
    let (clock, grid) = match clock {
        Some(Clock { grid: Some(ref grid), .. }) if is_in_order(&grid.numbers) => (clock.as_ref(), grid),
        _ if is_asked => return Err(MeasurementError::NotEven { run: run.to_owned() }),
        Some(Clock { significant_digits: Some(digits), .. }) => {
            return Err(MeasurementError::CoarseTimes { run: run.to_owned(), digits });
        }
        _ => return Ok(None),
    };
    let (shares, digits) =
        clock.map_or((false, None), |clock| (clock.shares_times, clock.significant_digits));
    if !is_asked && !shares && digits.is_none() {
        return Ok(None);
    }
    let relative_uncertainty = grid.interval_uncertainty / grid.interval;
    let why = match digits {
        Some(digits) => format!(", since those written are these with {digits} significant digits"),
        None if is_asked => String::new(),
        None => ", since those written are so coarse that rows share them".to_owned(),
    };
    let text = format!(
        "{run}the times are taken to be even with an interval of {} s, known to {relative_uncertainty:.1e} of it{why}",
        format!("{:.7}", grid.interval).trim_end_matches('0')
    );
    tell(Finding::new(text, Choice::TimesAsWritten));
    Ok(Some(ReplacedTimes { times: grid.times(), relative_uncertainty }))
}

fn is_in_order(indices: &[usize]) -> bool {
    indices.windows(2).all(|pair| pair[0] < pair[1])
}
