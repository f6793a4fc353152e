//! Conditions of the advice on swings.

use super::{Advice, EndOfTrace, FittedPendulum, SwingsFit};
use crate::fit::trace::ParameterKind;
use crate::measurement::{Faults, Observable, Trace};

/// The advice, the most helpful first.
pub(super) fn advice(analysis: &SwingsFit, traces: &[Trace], angle_scale: Option<f64>) -> Vec<Advice> {
    let faults: Vec<Faults> =
        traces.iter().map(|trace| Faults::detect(trace.times(), trace.values(), None)).collect();
    let observable = traces.first().map_or(Observable::Angle, Trace::observable);
    let mut advice: Vec<Advice> = length(&analysis.pendulum).into_iter().collect();
    advice.extend(scale(analysis, observable));
    advice.extend(unstated_scale(analysis).filter(|_| angle_scale.is_none()));
    advice.extend(damping(analysis));
    advice.extend((!analysis.fit.autocorrelation.is_noise()).then_some(Advice::LookAtResiduals));
    advice.extend(outliers(analysis, traces));
    advice.extend(faults.iter().find_map(|faults| times(analysis, faults)));
    advice.extend(zero(analysis, observable));
    advice.extend(rows(analysis, &faults));
    advice
}

fn length(pendulum: &FittedPendulum) -> Option<Advice> {
    /// Share of the length in the uncertainty of gravity above which it is worth measuring better: about √½, so that it has half of the variance.
    const MOST_OF_IT: f64 = 0.7;
    let (budget, length) = match pendulum {
        FittedPendulum::Length(_) => return Some(Advice::GiveLength),
        FittedPendulum::Gravity { budget, length } => (budget, length),
    };
    let Some(of_length) = length.uncertainty else { return Some(Advice::GiveLengthUncertainty) };
    let (relative_uncertainty, of_gravity) = (of_length / length.value, budget.uncertainty / budget.g);
    let part = relative_uncertainty / of_gravity;
    (part > MOST_OF_IT).then_some(Advice::MeasureLengthBetter { relative_uncertainty, share: part * part })
}

fn scale(analysis: &SwingsFit, observable: Observable) -> Option<Advice> {
    analysis.doubtful_beta()?.scale_error().map(|_| Advice::CheckScale { observable })
}

/// Advises on a scale that is taken as exact, although neither T0 nor β confirm it.
fn unstated_scale(analysis: &SwingsFit) -> Option<Advice> {
    /// A usual error of a scale, of a camera or a protractor.
    const USUAL: f64 = 0.01;
    let beta =
        analysis.beta.as_ref().ok().filter(|beta| !beta.differs_from_one() && !analysis.scale_is_fitted())?;
    // R − 1 goes with the square of the amplitude.
    let (mut excess, mut cycles) = (0.0, 0.0);
    analysis
        .all_cycles()
        .for_each(|(_, cycle)| (excess, cycles) = (excess + cycle.period_ratio - 1.0, cycles + 1.0));
    let (slope, of_beta) = (2.0 * excess / cycles, beta.factor.uncertainty);
    let is_open = 0.5 * of_beta > USUAL && USUAL * slope > analysis.small_angle_period().relative();
    is_open.then_some(Advice::StateScale { slope, of_beta })
}

fn damping(analysis: &SwingsFit) -> Option<Advice> {
    let amplitudes = analysis.amplitudes().filter(|_| !analysis.rivals().is_empty())?;
    Some(Advice::RecordLonger { amplitudes })
}

/// Advises on rows at an end that do not follow the motion, or otherwise on single rows.
fn outliers(analysis: &SwingsFit, traces: &[Trace]) -> Option<Advice> {
    let fitted = traces.iter().zip(&analysis.fit.traces);
    let ends: Vec<EndOfTrace> =
        fitted.flat_map(|(trace, fitted)| strange_ends(trace, &fitted.outliers)).collect();
    let some = analysis.fit.traces.iter().any(|trace| !trace.outliers.is_empty());
    match ends.is_empty() {
        true => some.then_some(Advice::CorrectOutliers),
        false => Some(Advice::LeaveOutEnds { ends }),
    }
}

/// Ends of a trace with consecutive outliers.
fn strange_ends(trace: &Trace, outliers: &[usize]) -> Vec<EndOfTrace> {
    /// Least number of consecutive outliers. Where one row in a hundred is an outlier, three are at an end by chance in one trace of 500 000.
    const FEWEST: usize = 3;
    let (times, last) = (trace.times(), trace.len() - 1);
    let at_beginning = outliers.iter().enumerate().take_while(|(index, row)| index == *row).count();
    let at_end =
        outliers.iter().rev().enumerate().take_while(|(distance, row)| last - *row == *distance).count();
    let name = || trace.name().to_owned();
    let is_end = |rows: usize| rows >= FEWEST && rows < trace.len();
    let before =
        is_end(at_beginning).then(|| EndOfTrace::Before { trace: name(), time: times[at_beginning] });
    let after = is_end(at_end).then(|| EndOfTrace::After { trace: name(), time: times[last - at_end] });
    before.into_iter().chain(after).collect()
}

/// Advises on rounded times, if they matter compared with the other errors.
fn times(analysis: &SwingsFit, faults: &Faults) -> Option<Advice> {
    /// Fraction of the scatter above which rounding is reported: a sixteenth of the square.
    const WORTH_A_WORD: f64 = 0.25;
    let (noise, clock) = (faults.rounding_noise?, faults.clock.as_ref()?);
    let (resolution, _) = (clock.resolution?, clock.grid.as_ref()?);
    let part = (noise / analysis.fit.rms).min(1.0);
    (part > WORTH_A_WORD).then_some(Advice::WriteMoreDigitsOfTimes { resolution, part })
}

/// Advises on the zero of the angle, if the motion is that of a pendulum.
fn zero(analysis: &SwingsFit, observable: Observable) -> Option<Advice> {
    /// Smallest error of the zero that is reported, in radians: half a degree, the resolution of a protractor.
    const WORTH_A_WORD: f64 = 0.01;
    let offsets = analysis.fit.parameters.iter().filter(|parameter| parameter.kind == ParameterKind::Offset);
    let offset =
        offsets.map(|offset| offset.estimate.value).max_by(|a: &f64, b: &f64| a.abs().total_cmp(&b.abs()))?;
    let is_told = observable == Observable::Angle && !analysis.is_poor();
    (is_told && offset.abs() > WORTH_A_WORD).then_some(Advice::SetZero { offset })
}

fn rows(analysis: &SwingsFit, faults: &[Faults]) -> Option<Advice> {
    /// Rows in a period; nearly twice the number that the cycles need.
    const FEW: f64 = 15.0;
    let period = analysis.fit.small_angle_period().value;
    let rows = faults.iter().filter_map(|faults| faults.clock.as_ref().map(|clock| period / clock.interval));
    let rows_per_period = rows.reduce(f64::min)?;
    (rows_per_period < FEW).then_some(Advice::SampleFaster { rows_per_period })
}
