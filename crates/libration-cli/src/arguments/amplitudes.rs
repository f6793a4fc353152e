//! The amplitudes a question is about: angles, lists and ranges of angles, or a file of them.

use super::{bare, lines};
use crate::query_error::{QueryError, argument};
use libration::pendulum::Amplitude;
use libration::quantity::{Angle, AngleRange, BareRadians, RangeError, angles};
use std::path::{Path, PathBuf};

/// The options that say which amplitudes.
#[derive(Clone, Debug, clap::Args)]
#[group(required = true, multiple = false)]
pub(crate) struct AmplitudeOptions {
    /// Angles such as 60deg, 1.2rad or pi-1e-6, or ranges such as 1deg:179deg:1deg
    #[arg(value_name = "AMPLITUDE", value_parser = angle_set)]
    amplitudes: Vec<AngleSet>,
    /// Read the amplitudes from a file, one per line; - for standard input
    #[arg(long, value_name = "FILE")]
    from_file: Option<PathBuf>,
}

/// The angles one argument means.
#[derive(Clone, Debug)]
enum AngleSet {
    List(Vec<Angle>),
    Range(AngleRange),
}

/// Amplitudes, all of them known to be below π.
#[derive(Debug)]
pub(crate) struct Amplitudes(Vec<AngleSet>);

impl AmplitudeOptions {
    pub(crate) fn read(&self) -> Result<Amplitudes, QueryError> {
        let sets = match &self.from_file {
            Some(path) => vec![AngleSet::List(angles_in_file(path)?)],
            None => self.amplitudes.clone(),
        };
        let is_amplitude = |angle| Amplitude::new(angle).map(|_| ());
        let checked = sets.iter().flat_map(AngleSet::widest).try_for_each(is_amplitude);
        checked.map_err(|error| QueryError::no_result(argument("AMPLITUDE"), error))?;
        Ok(Amplitudes(sets))
    }
}

impl Amplitudes {
    pub(crate) fn iter(&self) -> impl Iterator<Item = Amplitude> + '_ {
        (0..self.len()).filter_map(|place| self.get(place))
    }

    /// The amplitude at a place, from zero.
    pub(crate) fn get(&self, mut place: usize) -> Option<Amplitude> {
        for set in &self.0 {
            if place < set.len() {
                let below_pi = "an angle no larger than an amplitude is an amplitude";
                return set.get(place).map(|angle| Amplitude::new(angle).expect(below_pi));
            }
            place -= set.len();
        }
        None
    }

    /// Number of amplitudes.
    pub(crate) fn len(&self) -> usize {
        self.0.iter().map(AngleSet::len).sum()
    }

    /// The amplitude, if there is exactly one.
    pub(crate) fn single(&self) -> Option<Amplitude> {
        let mut amplitudes = self.iter();
        amplitudes.next().filter(|_| amplitudes.next().is_none())
    }
}

impl AngleSet {
    fn get(&self, place: usize) -> Option<Angle> {
        match self {
            Self::List(angles) => angles.get(place).copied(),
            Self::Range(range) => range.get(place),
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
        (0..=last).step_by(step).filter_map(|place| self.get(place))
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

/// Reads the angles of a file, and says of the first one that may have been meant in degrees how it is taken.
fn angles_in_file(path: &Path) -> Result<Vec<Angle>, QueryError> {
    let text = lines::text(path)?;
    let read = |line: &str| line.parse().map(|angle: Angle| (angle, BareRadians::in_text(line).is_some()));
    let angles = lines::values(path, &text, read)?;
    let doubtful = angles.iter().position(|(_, is_doubtful)| *is_doubtful);
    if let Some((_, line)) = doubtful.and_then(|place| lines::numbered(&text).nth(place)) {
        bare::say(line);
    }
    Ok(angles.into_iter().map(|(angle, _)| angle).collect())
}
