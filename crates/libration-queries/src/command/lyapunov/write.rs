//! The exponent as a sheet with its convergence, JSON and CSV.

use super::LyapunovResult;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::table::{paragraph, sheet};
use crate::output::{Form, number};
use libration::chaos::LyapunovExponent;
use std::io::{self, Write};

/// Width at which sentences are broken, in columns.
const COLUMNS: usize = 100;

impl LyapunovResult<'_> {
    /// Writes the result in the given form; the table lists the points only if requested.
    pub(super) fn write(&self, out: &mut dyn Write, form: Form, listed: bool) -> io::Result<()> {
        match form {
            Form::Json => self.write_json(out),
            Form::Csv => self.write_csv(out),
            Form::Table => self.write_sheet(out, listed),
        }
    }

    fn write_json(&self, out: &mut dyn Write) -> io::Result<()> {
        let fields = of_point();
        let records = self.exponent.convergence.iter().map(|point| fields.record(point));
        json::document_with_list(out, of_answer().record(self), "convergence", records)
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        of_point().write_csv(out, &self.exponent.convergence)
    }

    fn write_sheet(&self, out: &mut dyn Write, listed: bool) -> io::Result<()> {
        sheet(out, &of_answer().lines(self))?;
        let exponent = &self.exponent;
        let verdict = format!("{}: {}", exponent.verdict, exponent.verdict.reason());
        writeln!(out, "{}", paragraph("verdict                    ", &verdict, COLUMNS))?;
        if !listed {
            return Ok(());
        }
        writeln!(out)?;
        of_point().write_table(out, self.exponent.convergence.iter().rev().step_by(4).rev())
    }
}

fn of_answer<'a>() -> Fields<LyapunovResult<'a>> {
    type Of<'a> = Field<LyapunovResult<'a>>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |result| {
            result.model.key().into()
        })
        .line_of("system", |result| result.model.title().to_owned()),
        Of::value("equation", "", "equations of motion as they were read", |result| {
            result.model.equation().to_string().into()
        })
        .line_of("equation", |result| result.model.equation().to_string()),
        Of::value("state[]", "", "names of the state variables", |result| {
            json::list(result.model.state_names())
        }),
        Of::value("initial[]", "", "state at the start, in the order of those names", |result| {
            json::numbers(&result.initial)
        }),
        Of::number("transient_s", "s", "time that passed before measuring", |result| {
            result.schedule.transient
        }),
        Of::number("interval_s", "s", "time between two measurements of the deviation", |result| {
            result.schedule.interval
        }),
        Of::number("exponent_per_s", "1/s", "largest Lyapunov exponent", |result| result.exponent.exponent)
            .line_of("largest Lyapunov exponent", |result| {
                let LyapunovExponent { exponent, uncertainty, .. } = result.exponent;
                match uncertainty.is_finite() {
                    true => number::with_uncertainty(exponent, uncertainty, "1/s"),
                    false => {
                        let exponent = number::rounded(exponent, 5);
                        format!("{exponent} 1/s  (uncertainty not known: too few intervals)")
                    }
                }
            }),
        Of::number(
            "exponent_uncertainty_per_s",
            "1/s",
            "largest of the standard error of the exponent from ten blocks of the time, the change in the second half, and the exponent itself if a power of the time explains the growth",
            |result| result.exponent.uncertainty,
        ),
        Of::value("verdict", "", "regular, chaotic or undecided", |result| {
            result.exponent.verdict.to_string().into()
        }),
        Of::value("reason", "", "evidence for the verdict, or the evidence that is missing", |result| {
            result.exponent.verdict.reason().into()
        }),
    ])
}

/// The time measured, and the exponent until then.
fn of_point() -> Fields<(f64, f64)> {
    type Of = Field<(f64, f64)>;
    Fields::from([
        Of::number("time_s", "s", "time measured so far", |(time, _)| *time).short("measured / s", 8),
        Of::number("exponent_per_s", "1/s", "estimate of the exponent up to then", |(_, exponent)| *exponent)
            .rounded("exponent / (1/s)", 6),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [of_answer().described(""), of_point().described("convergence[].")].concat();
    vec![Answers { command: "lyapunov", option: "", json, csv: of_point().described_in_csv() }]
}
