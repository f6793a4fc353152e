//! The amplitudes a question is about: angles, lists and ranges of angles, or a file of them.

use super::{bare, lines};
use crate::failure::Failure;
use libration::pendulum::Amplitude;
use libration::quantity::{Angle, AngleRange, BareRadians, QuantityError, RangeError, angles};
use std::cell::Cell;
use std::path::PathBuf;

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
    pub(crate) fn read(&self) -> Result<Amplitudes, Failure> {
        let sets = match &self.from_file {
            Some(path) => {
                let said = Cell::new(false);
                vec![AngleSet::List(lines::read(path, |text| angle_in_file(&said, text))?)]
            }
            None => self.amplitudes.clone(),
        };
        for angle in sets.iter().flat_map(AngleSet::widest) {
            Amplitude::new(angle).map_err(|error| Failure::no_answer("AMPLITUDE", error))?;
        }
        Ok(Amplitudes(sets))
    }
}

impl Amplitudes {
    pub(crate) fn iter(&self) -> impl Iterator<Item = Amplitude> + '_ {
        let below_pi = "an angle no larger than an amplitude is an amplitude";
        self.0.iter().flat_map(AngleSet::iter).map(|angle| Amplitude::new(angle).expect(below_pi))
    }

    /// How many there are.
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
    fn iter(&self) -> Box<dyn Iterator<Item = Angle> + '_> {
        match self {
            Self::List(angles) => Box::new(angles.iter().copied()),
            Self::Range(range) => Box::new(range.iter()),
        }
    }

    fn len(&self) -> usize {
        match self {
            Self::List(angles) => angles.len(),
            Self::Range(range) => range.len(),
        }
    }

    /// Angles among which is the largest of the set.
    fn widest(&self) -> Vec<Angle> {
        match self {
            Self::List(angles) => angles.clone(),
            Self::Range(range) => [range.get(0), range.get(range.len() - 1)].into_iter().flatten().collect(),
        }
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

/// Reads an angle from a file, and says of the first one that may have been meant in degrees how it is taken.
fn angle_in_file(said: &Cell<bool>, text: &str) -> Result<Angle, QuantityError> {
    let angle: Angle = text.parse()?;
    if !said.get() && BareRadians::in_text(text).is_some() {
        said.set(true);
        bare::say(text);
    }
    Ok(angle)
}
