//! A decay as table, JSON and CSV.

use super::fields::{self, Found, Turning};
use super::report::{Report, Turn, in_cycles};
use super::slow_flow::{self, Compared};
use crate::arguments::PendulumOptions;
use crate::output::json::{self, Record};
use crate::output::number::{seconds, short};
use crate::output::table::{Table, sheet};
use crate::output::{Form, csv};
use crate::query_error::QueryError;
use libration::comparison::SlowDecay;
use libration::decay::{Decay, DecayEnding};
use std::io::{self, Write};

/// A decay with the query.
pub(super) struct DecayResult<'a> {
    /// Length and gravity, if the pendulum was given by them.
    pub(super) given: Option<PendulumOptions>,
    pub(super) decay: &'a Decay,
    /// The slow flow, if requested.
    pub(super) slow: Option<&'a SlowDecay>,
    pub(super) report: &'a Report,
    /// `true` if the table lists the cycles; a picture shows them better.
    pub(super) listed: bool,
}

impl DecayResult<'_> {
    pub(super) fn write(&self, out: &mut dyn Write, form: Form) -> Result<(), QueryError> {
        match form {
            Form::Json => json::document_with_list(out, self.head(), "turning_points", self.records())?,
            Form::Csv => self.write_csv(out)?,
            Form::Table => self.write_table(out)?,
        }
        Ok(())
    }

    fn head(&self) -> Record {
        let terms = fields::of_term().records(self.decay.damping().terms());
        let given = self.given.map_or_else(Record::new, PendulumOptions::record);
        let record = fields::of_pendulum().added_to(given, self.decay).with("damping", terms);
        let record = fields::of_decay().added_to(record, &Found { decay: self.decay, report: self.report });
        match self.compared() {
            Some(compared) => slow_flow::of_all().added_to(record, &compared),
            None => record,
        }
    }

    fn compared(&self) -> Option<Compared<'_>> {
        let amplitude = self.report.largest_slow_error(|slow| slow.amplitude_error);
        let phase = self.report.largest_slow_error(|slow| slow.phase_error);
        Some(Compared { slow: self.slow?, largest_errors: [amplitude, phase] })
    }

    fn turnings(&self) -> impl Iterator<Item = Turning<'_>> {
        self.report.rows(self.decay).map(|row| Turning { decay: self.decay, row })
    }

    fn records(&self) -> impl Iterator<Item = Record> {
        let (of_turning, of_cycle) = (fields::of_turning(), fields::of_cycle());
        let (of_slow_turn, of_slow_cycle) = (slow_flow::of_turn(), slow_flow::of_cycle());
        self.turnings().map(move |turning| {
            let mut record = of_turning.record(&turning);
            if let Some(slow) = &turning.row.turn.slow {
                record = of_slow_turn.added_to(record, slow);
            }
            let Some(cycle) = &turning.row.whole else { return record };
            let record = of_cycle.added_to(record, cycle);
            match &cycle.slow {
                Some(slow) => of_slow_cycle.added_to(record, slow),
                None => record,
            }
        })
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let (of_turning, of_cycle) = (fields::of_turning(), fields::of_cycle());
        let (of_slow_turn, of_slow_cycle) = (slow_flow::of_turn(), slow_flow::of_cycle());
        let slow_names = [of_slow_turn.csv_names(), of_slow_cycle.csv_names()].concat();
        let slow_names = if self.slow.is_some() { slow_names } else { vec![] };
        csv::line(out, &[of_turning.csv_names(), of_cycle.csv_names(), slow_names].concat())?;
        for turning in self.turnings() {
            let whole = turning.row.whole.as_ref();
            let mut cells = [of_turning.csv_cells(&turning), of_cycle.csv_cells_or_blanks(whole)].concat();
            if let Some(slow) = &turning.row.turn.slow {
                cells.extend(of_slow_turn.csv_cells(slow));
                cells.extend(of_slow_cycle.csv_cells_or_blanks(whole.and_then(|cycle| cycle.slow.as_ref())));
            }
            csv::line(out, &cells)?;
        }
        Ok(())
    }

    /// Whole cycles, and the fraction of one at the end.
    fn write_table(&self, out: &mut dyn Write) -> io::Result<()> {
        sheet(out, &self.lines())?;
        if !self.listed {
            return Ok(());
        }
        writeln!(out)?;
        let (of_turning, of_cycle) = (fields::of_turning(), fields::of_cycle());
        let (of_slow_turn, of_slow_cycle) = (slow_flow::of_turn(), slow_flow::of_cycle());
        let slow = [of_slow_turn.columns(), of_slow_cycle.columns()].concat();
        let slow = if self.slow.is_some() { slow } else { vec![] };
        let mut table = Table::new([of_turning.columns(), of_cycle.columns(), slow].concat());
        let last = self.report.turns.len() - 1;
        for (number, turning) in self.turnings().enumerate() {
            if number.is_multiple_of(2) || number == last {
                let whole = turning.row.whole.as_ref();
                let mut cells = [of_turning.cells(&turning), of_cycle.cells_or_blanks(whole)].concat();
                if let Some(slow) = &turning.row.turn.slow {
                    cells.extend(of_slow_turn.cells(slow));
                    cells.extend(of_slow_cycle.cells_or_blanks(whole.and_then(|cycle| cycle.slow.as_ref())));
                }
                table.row(out, cells)?;
            }
        }
        table.finish(out)
    }

    fn lines(&self) -> Vec<(&'static str, String)> {
        let mut lines = self.given.map_or_else(Vec::new, PendulumOptions::lines);
        lines.extend(fields::of_pendulum().lines(self.decay));
        lines.push(("equation", self.equation()));
        lines.push(("energy lost", self.losses()));
        lines.push(("Q", self.quality()));
        let errors = [
            ("averaging", self.report.largest_error(|turn| turn.averaged)),
            ("small amplitudes", self.report.largest_error(|turn| turn.small)),
        ];
        lines.extend(errors.map(|(law, error)| (law, self.error(error))));
        lines.extend(self.compared().map(|compared| ("slow flow", slow_flow::line(&compared))));
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

    /// Q of linear damping, or at the first and the last amplitude.
    fn quality(&self) -> String {
        let decay = Found { decay: self.decay, report: self.report };
        let first = short(decay.quality(), 4);
        if let [only] = self.decay.damping().terms()
            && only.exponent.total_cmp(&1.0).is_eq()
        {
            return format!("{first}  (ω0/c, at every amplitude)");
        }
        let last = self.report.turns.last().map_or(f64::NAN, |turn| {
            std::f64::consts::TAU / self.decay.loss_in_a_cycle(&turn.point.amplitude)
        });
        format!("{first}  (2πE/ΔE at the first amplitude; {} at the last)", short(last, 4))
    }

    fn losses(&self) -> String {
        let loss = |turn: &Turn| {
            let part = self.decay.loss_in_a_cycle(&turn.point.amplitude);
            if part < 1.0 { format!("{} %", short(100.0 * part, 3)) } else { "all of it".to_owned() }
        };
        let ends = [self.report.turns.first(), self.report.turns.last()];
        let [first, last] = ends.map(|turn| turn.map_or_else(String::new, loss));
        format!(
            "{first} in an undamped cycle at the first amplitude, {last} at the last; averaging is valid for small losses, away from the top"
        )
    }

    fn error(&self, (error, number): (f64, usize)) -> String {
        let amplitude = self.report.turns[number].point.amplitude.radians();
        let part = short(100.0 * error / amplitude, 2);
        let degrees = short(error.to_degrees(), 2);
        format!("error at most {degrees}° ({part} % of the amplitude), at cycle {}", in_cycles(number))
    }

    fn ending(&self) -> String {
        let time = seconds(self.report.turns.last().map_or(f64::NAN, |turn| turn.point.time), 8);
        let sticking = short(self.decay.sticking_amplitude().to_degrees(), 6);
        match self.report.ending {
            None => "none yet: the pendulum is still swinging".to_owned(),
            Some(DecayEnding::Sticks) => {
                format!("stopped by dry friction after {time}, as at every amplitude up to {sticking}°")
            }
            Some(DecayEnding::StopsOnTheWay { time, angle }) => format!(
                "stopped by dry friction on its way down, after {} at {}° from the bottom",
                seconds(time, 8),
                short(angle.to_degrees(), 6)
            ),
            Some(DecayEnding::Vanishes) => format!("after {time} the amplitude is below 1e-100 rad"),
            Some(_) => format!(
                "after {time} the damping is too strong for a swing: the pendulum creeps to the bottom"
            ),
        }
    }
}
