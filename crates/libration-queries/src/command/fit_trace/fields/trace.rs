//! A trace by itself, and its rows.

use super::super::answer::FitTraceResult;
use super::super::units::in_unit;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::{rounded, with_uncertainty};
use libration_lab::fit::Beta;
use libration_lab::fit::cycles::Cycles;

/// A trace of a result.
pub(in super::super) struct TraceOf<'a> {
    answer: &'a FitTraceResult<'a>,
    index: usize,
}

pub(in super::super) fn traces<'a>(answer: &'a FitTraceResult<'a>) -> Vec<TraceOf<'a>> {
    (0..answer.measured.traces.len()).map(|index| TraceOf { answer, index }).collect()
}

/// A row of a trace: time, observed value, fitted value, difference.
pub(in super::super) struct RecordedPoint<'a> {
    trace: &'a str,
    numbers: [f64; 4],
}

pub(in super::super) fn rows<'a>(answer: &'a FitTraceResult<'_>) -> Vec<RecordedPoint<'a>> {
    let traces = answer.measured.traces.iter().zip(&answer.swings.fit.traces);
    let rows = traces.flat_map(|(trace, fitted)| {
        (0..trace.len()).map(move |row| RecordedPoint {
            trace: trace.name(),
            numbers: [trace.times()[row], trace.values()[row], fitted.fitted[row], fitted.residuals[row]],
        })
    });
    rows.collect()
}

pub(in super::super) fn of_row<'a>() -> Fields<RecordedPoint<'a>> {
    type Of<'a> = Field<RecordedPoint<'a>>;
    Fields::from([
        Of::value("trace", "", "name of the run", |point| point.trace.into()),
        Of::number("time_s", "s", "time of the row", |point| point.numbers[0]),
        Of::number("value", "", "measured value, in rad or rad/s", |point| point.numbers[1]),
        Of::number("fitted", "", "value of the fitted motion", |point| point.numbers[2]),
        Of::number("residual", "", "measured minus fitted", |point| point.numbers[3]),
    ])
}

pub(in super::super) fn of_trace<'a>() -> Fields<TraceOf<'a>> {
    type Of<'a> = Field<TraceOf<'a>>;
    Fields::from([
        Of::value("name", "", "name of the run", |trace| trace.name().into())
            .words("trace", |trace| trace.name().to_owned()),
        Of::value("rows", "1", "its rows", |trace| trace.times().len().into())
            .numeral("rows", |trace| trace.times().len().to_string()),
        Of::number("first_s", "s", "time of its first row", |trace| trace.times()[0]),
        Of::number("last_s", "s", "time of its last row", |trace| trace.times()[trace.times().len() - 1]),
        Of::number("rms_residual", "", "root mean square of its residuals, in rad or rad/s", TraceOf::rms)
            .numeral("rms residual", |trace| in_unit(trace.answer, trace.rms(), 3)),
        Of::value(
            "outlier_rows[]",
            "1",
            "rows beyond five robust standard deviations, numbered from 0",
            |trace| json::list(trace.answer.swings.fit.traces[trace.index].outliers.clone()),
        ),
        Of::unnamed().numeral("cycles", |trace| {
            trace.cycles().map_or("–".to_owned(), |cycles| cycles.cycles.len().to_string())
        }),
        Of::unnamed().numeral("largest", |trace| trace.amplitude(f64::max)),
        Of::unnamed().numeral("smallest", |trace| trace.amplitude(f64::min)),
        Of::known("t0_by_cycles_s", "s", "T₀ by the periods of its cycles, or null", |trace| {
            trace.cycles().map(|cycles| cycles.t0.value)
        })
        .numeral("T₀ by cycles / s", |trace| {
            let t0 =
                trace.cycles().map(|cycles| with_uncertainty(cycles.t0.value, cycles.t0.uncertainty, ""));
            t0.unwrap_or("–".to_owned())
        }),
        Of::known("t0_by_cycles_uncertainty_s", "s", "standard uncertainty of that, or null", |trace| {
            trace.cycles().map(|cycles| cycles.t0.uncertainty)
        }),
        Of::known("beta", "1", "β of this trace, or null", |trace| {
            trace.beta().map(|beta| beta.factor.value)
        })
        .numeral("β", |trace| trace.beta().map_or("–".to_owned(), |beta| beta.factor.to_string())),
        Of::known("beta_uncertainty", "1", "standard uncertainty of that, or null", |trace| {
            trace.beta().map(|beta| beta.factor.uncertainty)
        }),
    ])
}

impl TraceOf<'_> {
    fn name(&self) -> &str {
        self.answer.measured.traces[self.index].name()
    }

    fn times(&self) -> &[f64] {
        self.answer.measured.traces[self.index].times()
    }

    fn rms(&self) -> f64 {
        self.answer.swings.fit.traces[self.index].rms()
    }

    fn cycles(&self) -> Result<&Cycles, String> {
        self.answer.swings.cycles[self.index].as_ref().map_err(ToString::to_string)
    }

    fn beta(&self) -> Result<&Beta, String> {
        let beta = self.cycles().ok().and_then(|cycles| cycles.beta.as_ref().ok());
        beta.ok_or_else(|| "its cycles do not determine beta".to_owned())
    }

    /// The largest or the smallest of its cycles.
    fn amplitude(&self, extreme: fn(f64, f64) -> f64) -> String {
        let amplitudes = self.cycles().into_iter().flat_map(|cycles| &cycles.cycles);
        let amplitude = amplitudes.map(|cycle| cycle.amplitude.value.to_degrees()).reduce(extreme);
        amplitude.map_or("–".to_owned(), |amplitude| format!("{}°", rounded(amplitude, 3)))
    }
}
