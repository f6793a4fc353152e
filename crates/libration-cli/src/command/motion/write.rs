//! The samples of a motion as table, JSON and CSV.

use super::Comparison;
use crate::arguments::PendulumOptions;
use crate::failure::Failure;
use crate::output::json::{self, Record};
use crate::output::table::{Column, Table, sheet};
use crate::output::{Form, csv, number};
use libration::pendulum::{Motion, Regime};
use serde_json::Value;
use std::io::{self, Write};

/// A motion with what its answer says beside the samples.
pub(super) struct Answer<'a> {
    pub(super) pendulum: PendulumOptions,
    pub(super) motion: &'a Motion,
    pub(super) comparison: &'a Comparison,
    /// Whether the table lists the samples; a picture shows them better.
    pub(super) listed: bool,
}

impl Answer<'_> {
    pub(super) fn write(
        &self,
        out: &mut dyn Write,
        form: Form,
        times: impl Iterator<Item = f64>,
    ) -> Result<(), Failure> {
        match form {
            Form::Json => {
                let samples = times.map(|time| self.sample(time));
                json::document_with_list(out, self.head(), "samples", samples)?;
            }
            Form::Csv => self.write_csv(out, times)?,
            Form::Table => self.write_table(out, times)?,
        }
        Ok(())
    }

    fn head(&self) -> Record {
        let amplitude = self.motion.amplitude();
        let why_none = "only a libration has an amplitude";
        self.pendulum
            .record()
            .with("regime", self.motion.regime().to_string())
            .number("period_s", self.motion.period())
            .number("energy_ratio", self.motion.energy_ratio())
            .number_or("amplitude_rad", amplitude.map(|a| a.radians()), why_none)
            .number("action_rad2_per_s", self.motion.action())
    }

    fn sample(&self, time: f64) -> Record {
        let state = self.motion.state_at(time);
        let record = Record::new()
            .number("time_s", time)
            .number("angle_rad", state.angle)
            .with("turns", state.turns)
            .number("angle_in_turn_rad", state.angle_in_turn)
            .number("complement_rad", state.complement)
            .number("velocity_rad_per_s", state.velocity);
        if self.comparison.approximations.is_empty() {
            return record;
        }
        record.with("approximations", self.approximations(time, state.angle))
    }

    fn approximations(&self, time: f64, exact: f64) -> Vec<Value> {
        let keys = self.comparison.approximations.iter().map(|motion| motion.key());
        let record = |(key, angle): (&str, f64)| {
            Record::new()
                .with("key", key)
                .number("angle_rad", angle)
                .number("error_rad", angle - exact)
                .into()
        };
        keys.zip(self.comparison.angles_at(time)).map(record).collect()
    }

    fn write_csv(&self, out: &mut dyn Write, times: impl Iterator<Item = f64>) -> io::Result<()> {
        let names =
            ["time_s", "angle_rad", "turns", "angle_in_turn_rad", "complement_rad", "velocity_rad_per_s"];
        let keys = self.comparison.approximations.iter().map(|motion| motion.key());
        let more = keys.flat_map(|key| [format!("{key}_angle_rad"), format!("{key}_error_rad")]);
        csv::line(out, &names.iter().map(ToString::to_string).chain(more).collect::<Vec<_>>())?;
        for time in times {
            let state = self.motion.state_at(time);
            let after = [state.angle_in_turn, state.complement, state.velocity];
            let more = self.comparison.angles_at(time).flat_map(|angle| [angle, angle - state.angle]);
            let mut fields = vec![number::exact(time), number::exact(state.angle), state.turns.to_string()];
            fields.extend(after.into_iter().chain(more).map(number::exact));
            csv::line(out, &fields)?;
        }
        Ok(())
    }

    fn write_table(&self, out: &mut dyn Write, times: impl Iterator<Item = f64>) -> io::Result<()> {
        sheet(out, &self.lines())?;
        if !self.listed {
            return Ok(());
        }
        writeln!(out)?;
        let mut table = Table::new(self.columns());
        for time in times {
            table.row(out, self.cells(time))?;
        }
        table.finish(out)
    }

    fn lines(&self) -> Vec<(&'static str, String)> {
        let [length, gravity] = self.pendulum.lines();
        let period = match self.motion.regime() {
            Regime::Rotation => "time of a turn",
            _ => "period",
        };
        let mut lines = vec![
            length,
            gravity,
            ("regime", self.motion.regime().to_string()),
            (period, number::seconds(self.motion.period(), 13)),
            (
                "energy / 2mgl",
                format!("{} (1 on the separatrix)", number::rounded(self.motion.energy_ratio(), 13)),
            ),
        ];
        if let Some(amplitude) = self.motion.amplitude() {
            let degrees = number::short(amplitude.angle().degrees(), 12);
            lines.push((
                "amplitude",
                format!("{} rad = {degrees}°", number::rounded(amplitude.radians(), 13)),
            ));
        }
        lines
    }

    fn columns(&self) -> Vec<Column> {
        let fixed = ["t / s", "θ / rad", "θ / °", "turns", "π − |θ| / rad", "θ′ / (rad/s)"];
        let names = self.comparison.approximations.iter();
        let compared = names.flat_map(|motion| {
            [format!("{} / rad", motion.key()), format!("error of {} / rad", motion.key())]
        });
        fixed.iter().map(ToString::to_string).chain(compared).map(Column::numbers).collect()
    }

    fn cells(&self, time: f64) -> Vec<String> {
        let state = self.motion.state_at(time);
        let mut cells = vec![
            number::short(time, 12),
            number::rounded(state.angle, 10),
            number::rounded(state.angle.to_degrees(), 10),
            state.turns.to_string(),
            number::rounded(state.complement, 6),
            number::rounded(state.velocity, 10),
        ];
        for angle in self.comparison.angles_at(time) {
            cells.extend([number::rounded(angle, 10), number::rounded(angle - state.angle, 3)]);
        }
        cells
    }
}
