//! The times at which a motion is evaluated.

use super::{lines, text};
use crate::call;
use crate::query_error::QueryError;
use libration::pendulum::{Motion, Pendulum};
use libration::quantity::{Dimension, NumberRange, QuantityError, RangeError, parse};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Number of steps in a period where no times are given.
const STEPS: u32 = 24;

/// Options for the times.
#[derive(Clone, Debug, clap::Args)]
#[group(multiple = false)]
pub(crate) struct TimeOptions {
    /// Times START:STOP:STEP or t1,t2,…, in seconds or with a unit [default: one period in 24 steps]
    #[arg(long, value_parser = times)]
    times: Option<Times>,
    /// Read the times from a file, one per line; - for standard input
    #[arg(long, value_name = "FILE")]
    times_from: Option<PathBuf>,
}

/// Times in seconds; at least one.
#[derive(Clone, Debug)]
pub(crate) enum Times {
    List(Vec<f64>),
    Range(NumberRange),
}

impl TimeOptions {
    pub(crate) fn read(&self, pendulum: &Pendulum, motion: &Motion) -> Result<Times, QueryError> {
        match (&self.times, &self.times_from) {
            (Some(times), _) => Ok(times.clone()),
            (None, Some(path)) => of_lines(path).map(Times::List),
            (None, None) => Ok(Times::one_period(pendulum, motion)),
        }
    }
}

impl Times {
    /// One period of the motion, or of small swings if it has none.
    fn one_period(pendulum: &Pendulum, motion: &Motion) -> Self {
        let swing_period = Some(motion.period()).filter(|period| period.is_finite());
        let period = swing_period.unwrap_or(pendulum.small_angle_period());
        Self::List((0..=STEPS).map(|step| period * f64::from(step) / f64::from(STEPS)).collect())
    }

    pub(crate) fn iter(&self) -> Box<dyn Iterator<Item = f64> + '_> {
        match self {
            Self::List(times) => Box::new(times.iter().copied()),
            Self::Range(range) => Box::new(range.iter()),
        }
    }

    /// Number of times.
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::List(times) => times.len(),
            Self::Range(range) => range.len(),
        }
    }

    /// The last time as given.
    pub(crate) fn last(&self) -> f64 {
        match self {
            Self::List(times) => times.last().copied().unwrap_or(0.0),
            Self::Range(range) => range.get(range.len() - 1).unwrap_or(0.0),
        }
    }

    /// The earliest and the latest.
    pub(crate) fn ends(&self) -> (f64, f64) {
        self.iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), time| (low.min(time), high.max(time)))
    }
}

/// Reads a range or a list of times.
pub(crate) fn times(text: &str) -> Result<Times, RangeError> {
    if text.contains(':') {
        let range = NumberRange::parse(text, Dimension::Time)?;
        text.split(':').try_for_each(|part| text::finite_time(part).map(|_| ()))?;
        return Ok(Times::Range(range));
    }
    let uncertain = Uncertain::default();
    let times = text.split(',').map(|part| uncertain.time(part));
    let times = times.collect::<Result<Vec<f64>, QuantityError>>()?;
    uncertain.say(times.len());
    Ok(Times::List(times))
}

/// Reads a file with one time per line.
fn of_lines(path: &Path) -> Result<Vec<f64>, QueryError> {
    let uncertain = Uncertain::default();
    let times = lines::read(path, |line| uncertain.time(line))?;
    uncertain.say(times.len());
    Ok(times)
}

/// Number of times that were given with an uncertainty, which is not used.
#[derive(Debug, Default)]
struct Uncertain(AtomicUsize);

impl Uncertain {
    fn time(&self, text: &str) -> Result<f64, QuantityError> {
        let time = parse(text, Dimension::Time)?;
        self.0.fetch_add(usize::from(time.uncertainty.is_some()), Ordering::Relaxed);
        Ok(time.value)
    }

    /// Writes one note on the number of times that have an uncertainty.
    fn say(&self, all: usize) {
        let sentence = match self.0.load(Ordering::Relaxed) {
            0 => return,
            1 => format!("the uncertainty of 1 of {all} times is not used here, only its value"),
            some => {
                format!("the uncertainties of {some} of {all} times are not used here, only their values")
            }
        };
        call::current().note(&sentence);
    }
}
