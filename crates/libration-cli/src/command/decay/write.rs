//! A decay as table, JSON and CSV.

use super::report::{Report, Row, Turn, in_cycles};
use crate::arguments::PendulumOptions;
use crate::failure::Failure;
use crate::output::json::{self, Record};
use crate::output::number::{exact, rounded, seconds, short};
use crate::output::table::{Column, Table, sheet};
use crate::output::{Form, csv};
use libration::decay::{DampingTerm, Decay, Ending};
use serde_json::Value;
use std::io::{self, Write};

/// A decay with what was asked.
pub(super) struct Answer<'a> {
    /// Length and gravity, if the pendulum was given by them.
    pub(super) given: Option<PendulumOptions>,
    pub(super) decay: &'a Decay,
    pub(super) report: &'a Report,
    /// Whether the table lists the cycles; a picture shows them better.
    pub(super) listed: bool,
}

impl Answer<'_> {
    pub(super) fn write(&self, out: &mut dyn Write, form: Form) -> Result<(), Failure> {
        match form {
            Form::Json => json::document_with_list(out, self.head(), "turning_points", self.records())?,
            Form::Csv => self.write_csv(out)?,
            Form::Table => self.write_table(out)?,
        }
        Ok(())
    }

    fn head(&self) -> Record {
        let terms: Vec<Value> =
            self.decay.damping().terms().iter().map(|term| term_record(term).into()).collect();
        let ending = self.report.ending.map(|ending| match ending {
            Ending::Sticks => "sticks",
            Ending::Vanishes => "vanishes",
            _ => "creeps",
        });
        self.given
            .map_or_else(Record::new, PendulumOptions::record)
            .number("omega0_rad_per_s", self.decay.pendulum().angular_frequency())
            .with("damping", terms)
            .number("sticking_amplitude_rad", self.decay.sticking_amplitude())
            .with("ending", ending)
            .number("largest_error_averaged_rad", self.report.largest_error(|turn| turn.averaged).0)
            .number("largest_error_small_amplitude_rad", self.report.largest_error(|turn| turn.small).0)
    }

    fn records(&self) -> impl Iterator<Item = Record> {
        self.report.rows(self.decay).map(|row| {
            let record = Record::new()
                .with("cycle", row.cycle)
                .number("time_s", row.turn.point.time)
                .number("amplitude_rad", row.turn.point.amplitude.radians())
                .number("averaged_rad", row.turn.averaged)
                .number("small_amplitude_rad", row.turn.small)
                .number("loss_in_a_cycle", self.decay.loss_in_a_cycle(&row.turn.point.amplitude));
            match row.whole {
                Some(cycle) => record
                    .number("duration_of_the_cycle_s", cycle.duration)
                    .number("exact_period_s", cycle.exact_period),
                None => record,
            }
        })
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let names =
            ["cycle", "time_s", "amplitude_rad", "averaged_rad", "small_amplitude_rad", "loss_in_a_cycle"];
        csv::line(out, &[&names[..], &["duration_of_the_cycle_s", "exact_period_s"]].concat())?;
        for row in self.report.rows(self.decay) {
            let Turn { point, averaged, small } = row.turn;
            let loss = self.decay.loss_in_a_cycle(&point.amplitude);
            let numbers = [row.cycle, point.time, point.amplitude.radians(), *averaged, *small, loss];
            let whole = row.whole.map(|cycle| [cycle.duration, cycle.exact_period].map(exact));
            csv::line(out, &[numbers.map(exact).to_vec(), whole.unwrap_or_default().to_vec()].concat())?;
        }
        Ok(())
    }

    /// Whole cycles, and what is left of one at the end.
    fn write_table(&self, out: &mut dyn Write) -> io::Result<()> {
        sheet(out, &self.lines())?;
        if !self.listed {
            return Ok(());
        }
        writeln!(out)?;
        let titles = [
            "cycle",
            "t / s",
            "amplitude / °",
            "averaged / °",
            "small amplitudes / °",
            "time of the cycle / s",
            "exact T / s",
        ];
        let mut table = Table::new(titles.map(Column::numbers).to_vec());
        let last = self.report.turns.len() - 1;
        for (number, row) in self.report.rows(self.decay).enumerate() {
            if number.is_multiple_of(2) || number == last {
                table.row(out, cells(&row))?;
            }
        }
        table.finish(out)
    }

    fn lines(&self) -> Vec<(&'static str, String)> {
        let mut lines = self.given.map_or_else(Vec::new, |given| given.lines().to_vec());
        let pendulum = self.decay.pendulum();
        lines.push(("ω0", format!("{} rad/s", rounded(pendulum.angular_frequency(), 13))));
        lines.push(("equation", self.equation()));
        lines.push(("energy lost", self.losses()));
        let errors = [
            ("averaging", self.report.largest_error(|turn| turn.averaged)),
            ("small amplitudes", self.report.largest_error(|turn| turn.small)),
        ];
        lines.extend(errors.map(|(law, error)| (law, self.error(error))));
        lines.push(("end", self.ending()));
        lines
    }

    fn equation(&self) -> String {
        let terms = self.decay.damping().terms().iter().map(|term| {
            let c = short(term.coefficient, 12);
            match term.exponent {
                0.0 => format!(" + {c}·sign θ′"),
                1.0 => format!(" + {c} θ′"),
                2.0 => format!(" + {c} θ′|θ′|"),
                3.0 => format!(" + {c} θ′³"),
                n => format!(" + {c} θ′|θ′|^{}", short(n - 1.0, 12)),
            }
        });
        format!("θ″{} + ω0² sin θ = 0", terms.collect::<String>())
    }

    fn losses(&self) -> String {
        let loss = |turn: &Turn| {
            let part = self.decay.loss_in_a_cycle(&turn.point.amplitude);
            if part < 1.0 { format!("{} %", short(100.0 * part, 3)) } else { "all of it".to_owned() }
        };
        let ends = [self.report.turns.first(), self.report.turns.last()];
        let [first, last] = ends.map(|turn| turn.map_or_else(String::new, loss));
        format!(
            "in a cycle {first} at the first amplitude, {last} at the last; averaging is for small losses, not next to the top"
        )
    }

    fn error(&self, (error, number): (f64, usize)) -> String {
        let amplitude = self.report.turns[number].point.amplitude.radians();
        let part = short(100.0 * error / amplitude, 2);
        let degrees = short(error.to_degrees(), 2);
        format!("errs by at most {degrees}°, {part} % of the amplitude then, at cycle {}", in_cycles(number))
    }

    fn ending(&self) -> String {
        let time = seconds(self.report.turns.last().map_or(f64::NAN, |turn| turn.point.time), 8);
        let sticking = short(self.decay.sticking_amplitude().to_degrees(), 6);
        match self.report.ending {
            None => "none yet: the pendulum swings on".to_owned(),
            Some(Ending::Sticks) => {
                format!("held by dry friction from {time} on, as at every amplitude up to {sticking}°")
            }
            Some(Ending::Vanishes) => format!("after {time} the amplitude is below 1e-100 rad"),
            Some(_) => format!(
                "after {time} the damping is too strong for a swing: the pendulum creeps to the bottom"
            ),
        }
    }
}

fn term_record(term: &DampingTerm) -> Record {
    Record::new().number("exponent", term.exponent).number("coefficient", term.coefficient)
}

fn cells(row: &Row<'_>) -> Vec<String> {
    let Turn { point, averaged, small } = row.turn;
    let angles = [point.amplitude.radians(), *averaged, *small].map(|angle| rounded(angle.to_degrees(), 8));
    let whole = row.whole.map(|cycle| [cycle.duration, cycle.exact_period].map(|time| rounded(time, 8)));
    let time = [short(row.cycle, 12), rounded(point.time, 9)];
    [time.to_vec(), angles.to_vec(), whole.unwrap_or_default().to_vec()].concat()
}
