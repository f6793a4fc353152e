//! The amplitudes of a query: angles, lists and ranges of angles, a file of them, or those with given periods.

use super::{bare, lines, text};
use crate::query_error::{QueryError, argument, option};
use libration::pendulum::{Amplitude, InferredAmplitude, Pendulum, PendulumError};
use libration::quantity::{Angle, AngleRange, BareRadians, Quantity, RangeError, angles};
use std::path::{Path, PathBuf};

/// Options for the amplitudes.
#[derive(Clone, Debug, clap::Args)]
#[group(required = true, multiple = false)]
pub(crate) struct AmplitudeOptions {
    /// Angles such as 60deg, 1.2rad or pi-1e-6, or ranges such as 1deg:179deg:1deg
    #[arg(value_name = "AMPLITUDE", value_parser = angle_set)]
    amplitudes: Vec<AngleSet>,
    /// Read the amplitudes from a file, one per line; - for standard input
    #[arg(long, value_name = "FILE")]
    from_file: Option<PathBuf>,
    /// The amplitude with this period, such as 2.1s or 2.10(1)s; an uncertainty of the period gives one of the amplitude
    #[arg(long, value_name = "PERIOD", value_parser = text::period_with_uncertainty)]
    period: Vec<Quantity>,
    /// The amplitude with this ratio of its period to that of small swings, T/T₀
    #[arg(long, value_name = "T/T0", value_parser = text::number_with_uncertainty)]
    ratio: Vec<Quantity>,
    /// The amplitude whose period exceeds that of small swings by this fraction, T/T₀ − 1; keeps all digits of small amplitudes
    #[arg(long, value_name = "EXCESS", value_parser = text::number_with_uncertainty)]
    excess: Vec<Quantity>,
}

/// The angles one argument means.
#[derive(Clone, Debug)]
pub(crate) enum AngleSet {
    List(Vec<Angle>),
    Range(AngleRange),
}

/// Amplitudes, all of them below π.
#[derive(Debug)]
pub(crate) struct Amplitudes {
    sets: Vec<AngleSet>,
    /// The uncertainties of amplitudes inferred from periods, one for each; otherwise empty.
    uncertainties: Vec<f64>,
}

impl AmplitudeOptions {
    /// Reads the amplitudes, or infers them from periods of a pendulum whose period of small swings has a relative uncertainty.
    pub(crate) fn read(&self, pendulum: &Pendulum, of_small_swings: f64) -> Result<Amplitudes, QueryError> {
        if self.are_of_periods() {
            return self.of_periods(pendulum, of_small_swings);
        }
        let sets = match &self.from_file {
            Some(path) => vec![AngleSet::List(angles_in_file(path)?)],
            None => self.amplitudes.clone(),
        };
        let is_amplitude = |angle| Amplitude::new(angle).map(|_| ());
        let checked = sets.iter().flat_map(AngleSet::widest).try_for_each(is_amplitude);
        checked.map_err(|error| QueryError::no_result(argument("AMPLITUDE"), error))?;
        Ok(Amplitudes { sets, uncertainties: vec![] })
    }

    /// `true` if the amplitudes follow from periods.
    pub(crate) fn are_of_periods(&self) -> bool {
        [&self.period, &self.ratio, &self.excess].into_iter().any(|given| !given.is_empty())
    }

    /// Returns `true` if the amplitudes depend on the pendulum.
    pub(crate) fn depend_on_the_pendulum(&self) -> bool {
        !self.period.is_empty()
    }

    fn of_periods(&self, pendulum: &Pendulum, of_small_swings: f64) -> Result<Amplitudes, QueryError> {
        type Inferred = Result<InferredAmplitude, PendulumError>;
        let with_period =
            |period: &Quantity| InferredAmplitude::from_period(period, pendulum, of_small_swings);
        let of = |given: &[Quantity], name, inferred: &dyn Fn(&Quantity) -> Inferred| {
            let inferred = given.iter().map(inferred).collect::<Result<Vec<InferredAmplitude>, _>>();
            inferred.map_err(|error| QueryError::no_result(option(name), error))
        };
        let inferred = [
            of(&self.period, "period", &with_period)?,
            of(&self.ratio, "ratio", &InferredAmplitude::from_ratio)?,
            of(&self.excess, "excess", &InferredAmplitude::from_excess)?,
        ];
        let both = |amplitude: InferredAmplitude| (amplitude.amplitude.angle(), amplitude.uncertainty);
        let (angles, uncertainties) = inferred.concat().into_iter().map(both).unzip();
        Ok(Amplitudes { sets: vec![AngleSet::List(angles)], uncertainties })
    }
}

impl Amplitudes {
    pub(crate) fn iter(&self) -> impl Iterator<Item = (Amplitude, Option<f64>)> + '_ {
        (0..self.len()).filter_map(|index| self.get(index))
    }

    /// The amplitude at an index, and its uncertainty if it is inferred from a period.
    pub(crate) fn get(&self, index: usize) -> Option<(Amplitude, Option<f64>)> {
        let mut in_set = index;
        for set in &self.sets {
            if in_set < set.len() {
                let below_pi = "an angle no larger than an amplitude is an amplitude";
                let amplitude = set.get(in_set).map(|angle| Amplitude::new(angle).expect(below_pi))?;
                return Some((amplitude, self.uncertainties.get(index).copied()));
            }
            in_set -= set.len();
        }
        None
    }

    /// Number of amplitudes.
    pub(crate) fn len(&self) -> usize {
        self.sets.iter().map(AngleSet::len).sum()
    }

    /// The amplitude, if there is exactly one.
    pub(crate) fn single(&self) -> Option<(Amplitude, Option<f64>)> {
        if self.len() == 1 { self.get(0) } else { None }
    }
}

impl AngleSet {
    fn get(&self, index: usize) -> Option<Angle> {
        match self {
            Self::List(angles) => angles.get(index).copied(),
            Self::Range(range) => range.get(index),
        }
    }

    fn len(&self) -> usize {
        match self {
            Self::List(angles) => angles.len(),
            Self::Range(range) => range.len(),
        }
    }

    /// Angles among which is the largest of the set.
    fn widest(&self) -> impl Iterator<Item = Angle> + '_ {
        let last = self.len().saturating_sub(1);
        let step = if let Self::Range(_) = self { last.max(1) } else { 1 };
        (0..=last).step_by(step).filter_map(|index| self.get(index))
    }
}

fn angle_set(text: &str) -> Result<AngleSet, RangeError> {
    let set = match text.contains(':') {
        true => AngleRange::parse(text).map(AngleSet::Range)?,
        false => angles(text).map(AngleSet::List)?,
    };
    bare::say(text);
    Ok(set)
}

/// Reads the angles of a file, with a note on the unit of the first one that may have been meant in degrees.
fn angles_in_file(path: &Path) -> Result<Vec<Angle>, QueryError> {
    let text = lines::text(path)?;
    let read = |line: &str| line.parse().map(|angle: Angle| (angle, BareRadians::in_text(line).is_some()));
    let angles = lines::values(path, &text, read)?;
    let doubtful = angles.iter().position(|(_, is_doubtful)| *is_doubtful);
    if let Some((_, line)) = doubtful.and_then(|index| lines::numbered(&text).nth(index)) {
        bare::say(line);
    }
    Ok(angles.into_iter().map(|(angle, _)| angle).collect())
}
