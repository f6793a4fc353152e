//! A cycle of a trace.

use super::super::answer::FitTraceResult;
use crate::output::field::{Field, Fields};
use crate::output::number::{short, with_uncertainty};
use libration_lab::fit::cycles::Cycle;

/// A cycle with its number, from 1 over all traces.
pub(in super::super) struct NumberedCycle<'a> {
    answer: &'a FitTraceResult<'a>,
    number: usize,
    trace: usize,
    cycle: &'a Cycle,
}

pub(in super::super) fn cycles<'a>(answer: &'a FitTraceResult<'a>) -> Vec<NumberedCycle<'a>> {
    let cycles = answer.swings.all_cycles().zip(1..);
    cycles.map(|((trace, cycle), number)| NumberedCycle { answer, number, trace, cycle }).collect()
}

/// The columns for one trace; for several, [`TRACE`] is the last.
pub(in super::super) const COLUMNS: [&str; 7] =
    ["cycle", "start / s", "period / s", "± / s", "amplitude / °", "± / °", TRACE];
pub(in super::super) const TRACE: &str = "trace";

pub(in super::super) fn of_cycle<'a>() -> Fields<NumberedCycle<'a>> {
    type Of<'a> = Field<NumberedCycle<'a>>;
    Fields::from([
        Of::unnamed().numeral(COLUMNS[0], |cycle| {
            let mark = if cycle.cycle.outlier { "*" } else { "" };
            format!("{}{mark}", cycle.number)
        }),
        Of::number("time_s", "s", "time of the middle of the cycle", |cycle| cycle.cycle.time)
            .numeral(COLUMNS[1], |cycle| short(cycle.cycle.time - 0.5 * cycle.cycle.period.value, 6)),
        Of::number("period_s", "s", "period of the cycle", |cycle| cycle.cycle.period.value)
            .numeral(COLUMNS[2], |cycle| cycle.period()[0].clone()),
        Of::unnamed().numeral(COLUMNS[3], |cycle| cycle.period()[1].clone()),
        Of::number("amplitude_rad", "rad", "amplitude in its middle", |cycle| cycle.cycle.amplitude.value)
            .numeral(COLUMNS[4], |cycle| cycle.amplitude()[0].clone()),
        Of::unnamed().numeral(COLUMNS[5], |cycle| cycle.amplitude()[1].clone()),
        Of::number("period_uncertainty_s", "s", "standard uncertainty of the period", |cycle| {
            cycle.cycle.period.uncertainty
        }),
        Of::number("amplitude_uncertainty_rad", "rad", "standard uncertainty of the amplitude", |cycle| {
            cycle.cycle.amplitude.uncertainty
        }),
        Of::value("outlier", "", "true if the period is far from the law", |cycle| {
            cycle.cycle.outlier.into()
        }),
        Of::present_value("trace", "1", "number of the trace, from 0, if there are several", |cycle| {
            (cycle.answer.measured.traces.len() > 1).then(|| cycle.trace.into())
        })
        .words(COLUMNS[6], |cycle| cycle.answer.measured.traces[cycle.trace].name().to_owned()),
    ])
}

impl NumberedCycle<'_> {
    fn period(&self) -> [String; 2] {
        parts(self.cycle.period.value, self.cycle.period.uncertainty)
    }

    fn amplitude(&self) -> [String; 2] {
        parts(self.cycle.amplitude.value.to_degrees(), self.cycle.amplitude.uncertainty.to_degrees())
    }
}

/// A value to the last digit of its uncertainty, and this.
fn parts(value: f64, uncertainty: f64) -> [String; 2] {
    let text = with_uncertainty(value, uncertainty, "");
    let (value, uncertainty) = text.split_once(" ± ").unwrap_or((&text, "–"));
    [value.to_owned(), uncertainty.to_owned()]
}
