//! Units of the columns: given, written, or inferred from the numbers where only one is possible.

use std::f64::consts::{PI, TAU};

use super::super::choices::{Choice, Choices, Finding, Suggestion};
use super::super::heading::Measures;
use super::super::sheet::Sheet;
use super::super::{MeasurementError, Observable, Unit};
use super::columns::what_it_holds;

/// Conversion of a number of the file into seconds, radians or radians per second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::measurement) enum Scale {
    Unit(Unit),
    /// Counts in a turn.
    Counts(f64),
    /// Frames in a second.
    Frames(f64),
}

/// Beginnings of the names of columns that count the frames of a video.
const FRAMES: [&str; 9] =
    ["frame", "bild", "image", "fotogram", "cuadro", "quadro", "klatka", "snímek", "beeld"];

impl Scale {
    pub(in crate::measurement) fn to_si(self, value: f64) -> f64 {
        match self {
            Self::Unit(unit) => unit.to_si(value),
            Self::Counts(in_a_turn) => value * TAU / in_a_turn,
            Self::Frames(in_a_second) => value / in_a_second,
        }
    }
}

/// The scale of times: the given one, the one in the header, or seconds if the steps can be seconds.
pub(in crate::measurement) fn of_times(
    times: &[f64],
    sheet: &Sheet,
    column: usize,
    choices: &Choices,
    tell: &mut impl FnMut(Finding),
) -> Result<Scale, MeasurementError> {
    if let Some(rate) = choices.frame_rate {
        return Ok(Scale::Frames(rate));
    }
    let heading = &sheet.channels[column].heading;
    let unit = match (choices.time_unit, heading.unit, &heading.unit_text) {
        (Some(unit), ..) => unit,
        (None, Some(unit), _) if unit.measures() == Measures::Time => {
            tell(Finding::new(format!("times are in {unit}, as the header says"), Choice::TimeUnit));
            unit
        }
        (None, None, None) if can_be_seconds(times) => {
            tell(Finding::new("times are taken as seconds, since no unit is given", Choice::TimeUnit));
            Unit::Second
        }
        (None, None, None) if counts_frames(sheet, column) => return Err(which_rate(sheet, column)),
        (_, _, text) => {
            let question = match text {
                Some(text) => format!("`{text}` is not a known unit of time"),
                None => format!(
                    "the unit of time of {} is not given, and steps of {} s are not likely",
                    sheet.describe(column),
                    median_step(times)
                ),
            };
            let choices =
                ["s", "ms", "us", "min"].map(|unit| Suggestion::new(Choice::TimeUnit, unit)).to_vec();
            return Err(MeasurementError::Undecided { question, choices });
        }
    };
    if unit.measures() != Measures::Time {
        return Err(MeasurementError::WrongUnit { unit, of: "time", examples: "s, ms, us, min" });
    }
    Ok(Scale::Unit(unit))
}

/// Returns `true` if the name of a column says numbers of frames.
pub(in crate::measurement) fn counts_frames(sheet: &Sheet, column: usize) -> bool {
    let name = sheet.channels[column].heading.text.to_lowercase();
    FRAMES.iter().any(|frame| name.trim().starts_with(frame))
}

pub(in crate::measurement) fn which_rate(sheet: &Sheet, column: usize) -> MeasurementError {
    let question = format!(
        "{} counts the frames of a video, whose number per second is not given",
        sheet.describe(column)
    );
    MeasurementError::Undecided { question, choices: vec![Suggestion::new(Choice::FrameRate, "30")] }
}

/// A pendulum is sampled between once in half a second and a hundred thousand times a second.
fn can_be_seconds(times: &[f64]) -> bool {
    times.len() < 2 || (1e-5..=0.5).contains(&median_step(times))
}

/// Median of the steps forward: others are not steps of a clock.
fn median_step(times: &[f64]) -> f64 {
    let steps = times.windows(2).map(|pair| pair[1] - pair[0]);
    let mut steps: Vec<f64> = steps.filter(|step| *step > 0.0).collect();
    steps.sort_unstable_by(f64::total_cmp);
    steps.get(steps.len() / 2).copied().unwrap_or(0.0)
}

/// The scale of angles or angular velocities.
pub(super) fn of_value(
    values: &[f64],
    sheet: &Sheet,
    column: usize,
    observable: Observable,
    choices: &Choices,
    tell: &mut impl FnMut(Finding),
) -> Result<Scale, MeasurementError> {
    if let Some(counts) = choices.counts_per_turn.filter(|_| observable == Observable::Angle) {
        return Ok(Scale::Counts(counts));
    }
    let heading = &sheet.channels[column].heading;
    let written = heading.unit.filter(|_| choices.unit.is_none());
    if let Some(unit) = choices.unit.or(written) {
        if written.is_some() {
            tell(Finding::new(
                format!("{} is in {unit}, as the header says", sheet.describe(column)),
                Choice::Unit,
            ));
            doubt(values, sheet, column, unit).into_iter().for_each(tell);
        }
        return in_unit(unit, sheet, column, observable);
    }
    if heading.unit_text.is_none() && observable == Observable::Angle && only_degrees_fit(values) {
        let text = format!(
            "{} is in degrees, since it swings by more than a turn of radians",
            sheet.describe(column)
        );
        tell(Finding::new(text, Choice::Unit));
        return Ok(Scale::Unit(Unit::Degree));
    }
    let question = match &heading.unit_text {
        Some(text) => format!("`{text}` is not a known unit of {}", name(observable)),
        None => format!("the unit of {} is not given", sheet.describe(column)),
    };
    let fits = |suggestion: &Suggestion| {
        suggestion.value.ends_with("/s") == (observable == Observable::AngularVelocity)
    };
    Err(MeasurementError::Undecided { question, choices: what_it_holds().into_iter().filter(fits).collect() })
}

/// Finding about an angle in radians by its header that swings as only degrees can.
fn doubt(values: &[f64], sheet: &Sheet, column: usize, unit: Unit) -> Option<Finding> {
    (unit == Unit::Radian && only_degrees_fit(values)).then(|| {
        let ends = |end: fn(f64, f64) -> f64| values.iter().copied().reduce(end).unwrap_or(f64::NAN);
        let half = 0.5 * (ends(f64::max) - ends(f64::min));
        let text = format!(
            "{} swings by {half:.0} to either side, which no pendulum does in radians: its header is doubtful, these are degrees",
            sheet.describe(column)
        );
        Finding::new(text, Choice::Unit)
    })
}

/// The unit of uncertainties: that of their values, unless their header names another.
pub(super) fn of_uncertainty(sheet: &Sheet, column: usize, of_values: Scale, choices: &Choices) -> Scale {
    let stated = sheet.channels[column].heading.unit.filter(|unit| *unit != Unit::Count);
    match (stated, of_values) {
        (Some(own_unit), Scale::Unit(unit))
            if choices.unit.is_none() && own_unit.measures() == unit.measures() =>
        {
            Scale::Unit(own_unit)
        }
        _ => of_values,
    }
}

fn in_unit(
    unit: Unit,
    sheet: &Sheet,
    column: usize,
    observable: Observable,
) -> Result<Scale, MeasurementError> {
    match (unit.measures(), observable) {
        (Measures::Angle, Observable::Angle) if unit == Unit::Count => {
            let question = format!(
                "{} is in counts, and the number of counts per turn is not given",
                sheet.describe(column)
            );
            Err(MeasurementError::Undecided {
                question,
                choices: vec![Suggestion::new(Choice::CountsPerTurn, "4000")],
            })
        }
        (Measures::Angle, Observable::Angle) | (Measures::AngularVelocity, Observable::AngularVelocity) => {
            Ok(Scale::Unit(unit))
        }
        _ => {
            let examples = if observable == Observable::Angle { "rad, deg" } else { "rad/s, deg/s" };
            Err(MeasurementError::WrongUnit { unit, of: name(observable), examples })
        }
    }
}

fn name(observable: Observable) -> &'static str {
    match observable {
        Observable::Angle => "an angle",
        Observable::AngularVelocity => "an angular velocity",
    }
}

/// Returns `true` for swings by more than π to both sides, which are not radians of a pendulum, since it would
/// rotate; whole numbers may be counts of an encoder.
fn only_degrees_fit(values: &[f64]) -> bool {
    const BEYOND: f64 = 1.1 * PI;
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let middle = 0.5 * (low + high);
    let mut sides: Vec<f64> = values
        .iter()
        .filter(|&value| (value - middle).abs() > BEYOND)
        .map(|value| (value - middle).signum())
        .collect();
    sides.dedup();
    sides.len() > 3 && high - low < 400.0 && values.iter().any(|value| value.fract() != 0.0)
}
