//! What is found in measured swings.

use super::input::Measured;
use super::model::DampingChoice;
use super::options;
use crate::arguments::ApparatusOptions;
use crate::failure::Failure;
use crate::interrupt;
use crate::output::progress::ProgressLine;
use libration::watch::Watch;
use libration_lab::fit::swings::{SwingsError, SwingsFit, SwingsOptions, swings};
use libration_lab::fit::trace::{TraceFitError, TraceOptions};
use std::cell::{Cell, RefCell};

/// Everything that is said about measured swings.
#[derive(Debug)]
pub(super) struct Answer<'a> {
    pub(super) measured: &'a Measured,
    pub(super) swings: SwingsFit,
}

impl<'a> Answer<'a> {
    pub(super) fn new(
        measured: &'a Measured,
        model: DampingChoice,
        options: TraceOptions,
        apparatus: &ApparatusOptions,
    ) -> Result<Self, Failure> {
        interrupt::listen()?;
        let (line, motions) = (RefCell::new(ProgressLine::new()), Cell::new(0_u64));
        let ask = |_| {
            motions.set(motions.get() + 1);
            line.borrow_mut().show(|| format!("fitting: {} motions integrated", motions.get()));
            interrupt::go_on()
        };
        let options = SwingsOptions {
            damping: match model {
                DampingChoice::Given(damping) => Some(damping),
                DampingChoice::Auto => None,
            },
            trace: TraceOptions { profile: true, ..options },
            apparatus: apparatus.apparatus(),
            angle_scale: apparatus.angle_scale(),
            clock: apparatus.clock(),
            correlations: apparatus.correlations(),
        };
        let swings = swings(&measured.traces, &options, &Watch::new(&ask));
        Ok(Self { measured, swings: swings.map_err(|error| failure(measured, error))? })
    }

    /// With the options that help.
    pub(super) fn warnings(&self) -> Vec<String> {
        self.swings.warnings.iter().map(options::warning).collect()
    }

    /// With the options that follow it.
    pub(super) fn advice(&self) -> Vec<String> {
        self.swings.advice.iter().map(options::advice).collect()
    }
}

fn failure(measured: &Measured, error: SwingsError) -> Failure {
    match error {
        SwingsError::Motion(TraceFitError::Interrupted) => {
            Failure::Interrupted("interrupted: nothing is written".to_owned())
        }
        SwingsError::Gravity(error) => Failure::no_answer("gravity", error),
        error => Failure::no_answer(&measured.names(), error),
    }
}
