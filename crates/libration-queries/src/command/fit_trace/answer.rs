//! Results for measured swings.

use super::input::ReadRecordings;
use super::model::DampingChoice;
use super::options;
use crate::arguments::ApparatusOptions;
use crate::interrupt;
use crate::output::normal_gravity::NormalGravity;
use crate::output::progress::ProgressLine;
use crate::query_error::QueryError;
use libration::progress::Status;
use libration_lab::fit::swings::{FittedPendulum, SwingsError, SwingsFit, SwingsOptions, fit_swings};
use libration_lab::fit::trace::{TraceFitError, TraceOptions};
use std::cell::{Cell, RefCell};

/// All results of measured swings.
#[derive(Debug)]
pub(super) struct FitTraceResult<'a> {
    pub(super) measured: &'a ReadRecordings,
    pub(super) swings: SwingsFit,
    /// Normal gravity at the place, compared with the measured one.
    pub(super) normal: Option<NormalGravity>,
}

impl<'a> FitTraceResult<'a> {
    pub(super) fn new(
        measured: &'a ReadRecordings,
        model: DampingChoice,
        options: TraceOptions,
        apparatus: &ApparatusOptions,
    ) -> Result<Self, QueryError> {
        interrupt::listen()?;
        let (line, motions) = (RefCell::new(ProgressLine::new()), Cell::new(0_u64));
        let progress = |_: Status| {
            motions.set(motions.get() + 1);
            line.borrow_mut().show(|| format!("fitting: {} motions integrated", motions.get()));
            interrupt::check()
        };
        let options = SwingsOptions {
            damping: match model {
                DampingChoice::Given(damping) => Some(damping),
                DampingChoice::Auto => None,
            },
            trace: TraceOptions { profile: true, ..options },
            apparatus: apparatus.apparatus()?,
            angle_scale: apparatus.angle_scale(),
            clock: apparatus.clock(),
            correlations: apparatus.correlations(),
        };
        let normal = apparatus.normal_gravity()?;
        let swings = fit_swings(&measured.traces, &options, &progress);
        let swings = swings.map_err(|error| failure(measured, error))?;
        let measured_gravity = match &swings.pendulum {
            FittedPendulum::Gravity { budget, .. } => Some(budget.gravity()),
            FittedPendulum::Length(_) => None,
        };
        let normal =
            measured_gravity.zip(normal).map(|(measured, normal)| NormalGravity { measured, normal });
        Ok(Self { measured, swings, normal })
    }

    /// The warnings with the options that help.
    pub(super) fn warnings(&self) -> Vec<String> {
        self.swings.warnings.iter().map(options::warning).collect()
    }

    /// The advice with the options that follow it.
    pub(super) fn advice(&self) -> Vec<String> {
        self.swings.advice.iter().map(options::advice).collect()
    }
}

fn failure(measured: &ReadRecordings, error: SwingsError) -> QueryError {
    match error {
        SwingsError::Motion(TraceFitError::Interrupted) => {
            QueryError::cancelled("interrupted: nothing is written")
        }
        SwingsError::Gravity(error) => QueryError::no_result("gravity", error),
        error => QueryError::no_result(&measured.names(), error),
    }
}
