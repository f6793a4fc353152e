//! The samples of a motion as table, JSON and CSV.

use super::Comparison;
use super::fields::{self, ApproximateAngle, StateAtTime};
use crate::arguments::PendulumOptions;
use crate::output::field::Fields;
use crate::output::json::{self, Record};
use crate::output::table::{Table, sheet};
use crate::output::{Form, csv};
use crate::query_error::QueryError;
use libration::pendulum::{Motion, Regime};
use std::io::{self, Write};

/// The reason why a state is not a number.
const UNKNOWN_PHASE: &str = "the phase is not known from 2⁹⁷ periods (1.6e29) on";

/// A motion with the parts of its result apart from the samples.
pub(super) struct MotionResult<'a> {
    pub(super) pendulum: PendulumOptions,
    pub(super) motion: &'a Motion,
    pub(super) comparison: &'a Comparison,
    /// `true` if the table lists the samples; a picture shows them better.
    pub(super) listed: bool,
}

impl MotionResult<'_> {
    pub(super) fn write(
        &self,
        out: &mut dyn Write,
        form: Form,
        times: impl Iterator<Item = f64>,
    ) -> Result<(), QueryError> {
        match form {
            Form::Json => {
                let head = fields::of_motion().added_to(self.pendulum.record(), self.motion);
                let (of_sample, of_approximation) = (fields::of_sample(), fields::of_approximation());
                let samples = times.map(|time| self.record(time, &of_sample, &of_approximation));
                json::document_with_list(out, head, "samples", samples)?;
            }
            Form::Csv => self.write_csv(out, times)?,
            Form::Table => self.write_table(out, times)?,
        }
        Ok(())
    }

    fn sample(&self, time: f64) -> StateAtTime {
        StateAtTime { time, state: self.motion.state_at(time) }
    }

    fn approximations(&self, sample: StateAtTime) -> impl Iterator<Item = ApproximateAngle<'_>> {
        self.comparison.approximations.iter().map(move |motion| ApproximateAngle {
            motion,
            angle: self.comparison.angle_at(motion, sample.time),
            exact: sample.state.angle,
        })
    }

    fn record<'a>(
        &'a self,
        time: f64,
        of_sample: &Fields<StateAtTime>,
        of_approximation: &Fields<ApproximateAngle<'a>>,
    ) -> Record {
        let sample = self.sample(time);
        let record = of_sample.record(&sample);
        let record = if sample.state.velocity.is_nan() { record.note(UNKNOWN_PHASE) } else { record };
        if self.comparison.approximations.is_empty() {
            return record;
        }
        let approximations: Vec<ApproximateAngle<'_>> = self.approximations(sample).collect();
        record.with("approximations", of_approximation.records(&approximations))
    }

    fn write_csv(&self, out: &mut dyn Write, times: impl Iterator<Item = f64>) -> io::Result<()> {
        let (of_sample, of_approximation) = (fields::of_sample(), fields::of_approximation());
        let compared = self.comparison.approximations.iter();
        let more = compared.flat_map(|motion| of_approximation.csv_names_for(motion.key()));
        csv::line(out, &of_sample.csv_names().into_iter().chain(more).collect::<Vec<_>>())?;
        for time in times {
            let sample = self.sample(time);
            let more = self
                .approximations(sample)
                .flat_map(|approximation| of_approximation.csv_cells(&approximation));
            csv::line(out, &of_sample.csv_cells(&sample).into_iter().chain(more).collect::<Vec<_>>())?;
        }
        Ok(())
    }

    fn write_table(&self, out: &mut dyn Write, times: impl Iterator<Item = f64>) -> io::Result<()> {
        sheet(out, &self.lines())?;
        if !self.listed {
            return Ok(());
        }
        writeln!(out)?;
        let (of_sample, of_approximation) = (fields::of_sample(), fields::of_approximation());
        let compared = self.comparison.approximations.iter();
        let more = compared.flat_map(|motion| of_approximation.columns_for(motion.key()));
        let mut is_known = true;
        let mut table = Table::new(of_sample.columns().into_iter().chain(more).collect());
        for time in times {
            let sample = self.sample(time);
            is_known &= !sample.state.velocity.is_nan();
            let more =
                self.approximations(sample).flat_map(|approximation| of_approximation.cells(&approximation));
            table.row(out, of_sample.cells(&sample).into_iter().chain(more).collect())?;
        }
        table.finish(out)?;
        if is_known { Ok(()) } else { writeln!(out, "\nnote: {UNKNOWN_PHASE}") }
    }

    /// The lines of the sheet: the period of a rotation has another name, and only a libration has an amplitude.
    fn lines(&self) -> Vec<(&'static str, String)> {
        let mut lines = [self.pendulum.lines(), fields::of_motion().lines(self.motion)].concat();
        lines.retain(|(_, text)| !text.is_empty());
        let turns = self.motion.regime() == Regime::Rotation;
        for (name, _) in lines.iter_mut().filter(|(name, _)| turns && *name == "period") {
            *name = "time of a turn";
        }
        lines
    }
}
