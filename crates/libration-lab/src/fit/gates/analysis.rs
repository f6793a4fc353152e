//! Analysis of the passages of a gate: periods and T0.

use std::f64::consts::PI;

use super::amplitudes::Amplitudes;
use super::directions::{Sorted, sorted};
use super::passages::{Passages, passages};
use super::swings::OrderedPassages;
use super::trend::at_the_beginning;
use super::{GateCycle, GateOptions, GatesError, GatesFit, T0Source, warning};
use crate::fit::beta::Beta;
use crate::fit::contradiction::Contradiction;
use crate::fit::contradiction::Estimate;
use crate::fit::law::Law;
use crate::fit::uncertain::Uncertain;
use crate::statistics::count;
use libration::internals::progress::Watch;
use libration::progress::{Interrupted, Progress};
use libration::quantity::Quantity;

/// Fits periods and T0 to the times of a gate; the states of the gate, blocked or not, are given where they are known.
///
/// # Errors
/// See [`GatesError`]: too few passages, or none of a pendulum.
/// [`GatesError::Interrupted`] if the call is cancelled.
///
/// # Examples
/// ```
/// use libration::progress::Quiet;
/// use libration_lab::fit::gates::{GateOptions, fit_gates};
/// // A period of 2 s, and a gate off the centre.
/// let times: Vec<f64> = (0..10).flat_map(|k| [2.0 * f64::from(k), 2.0 * f64::from(k) + 1.2]).collect();
/// let fit = fit_gates(&times, None, &GateOptions::default(), &Quiet)?;
/// assert!((fit.mean_period.value - 2.0).abs() < 1e-12 && (fit.part_between - 0.6).abs() < 1e-12);
/// # Ok::<(), libration_lab::fit::gates::GatesError>(())
/// ```
pub fn fit_gates(
    times: &[f64],
    blocked: Option<&[bool]>,
    options: &GateOptions,
    progress: &dyn Progress,
) -> Result<GatesFit, GatesError> {
    let watch = &Watch::new(progress);
    options.check()?;
    let passages = passages(times, blocked, options.signals)?;
    let seen = passages.passages.len();
    let sides = sorted(&passages.passages).ok_or(GatesError::TooFew { passages: seen })?;
    let swings = OrderedPassages::new(sides.placed.clone());
    // Of a pendulum nearly every passage begins a whole period; of random passages hardly any does.
    if 2 * sides.placed.len() < seen
        || (swings.cycles.len() >= 2 && 4 * swings.cycles.len() < sides.placed.len())
    {
        return Err(GatesError::Irregular { passages: seen, accepted: swings.cycles.len() });
    }
    if swings.cycles.len() < 2 {
        return Err(GatesError::TooFew { passages: sides.placed.len() });
    }
    let fit = swings.fit(&passages, &sides, options, watch);
    if watch.is_stopped() { Err(Interrupted.into()) } else { Ok(fit) }
}

impl GateOptions {
    fn check(&self) -> Result<(), GatesError> {
        for (name, quantity, limit, below) in [
            ("angular width of the bob", self.width, PI, " and below pi"),
            ("amplitude", self.amplitude, PI, " and below pi"),
        ] {
            if let Some(quantity) =
                quantity.filter(|quantity| !(quantity.value > 0.0 && quantity.value < limit))
            {
                return Err(GatesError::NotUsable { name, value: quantity.value, below });
            }
        }
        Ok(())
    }
}

impl OrderedPassages {
    fn fit(&self, passages: &Passages, sides: &Sorted, options: &GateOptions, watch: &Watch<'_>) -> GatesFit {
        let periods: Vec<f64> = self.cycles.iter().map(|&cycle| self.period(cycle)).collect();
        let mean = periods.iter().sum::<f64>() / count(periods.len());
        let scatter = periods.iter().map(|period| (period - mean) * (period - mean)).sum::<f64>();
        let spread = (scatter / count(periods.len() - 1) / count(periods.len())).sqrt();
        let amplitudes = options.width.map(|width| self.amplitudes(width.value, watch));
        let by_speeds =
            options.width.zip(amplitudes.as_ref()).and_then(|(width, a)| self.by_speeds(width, a, watch));
        let (times, both_sides) = self.mean_periods();
        let first_period = at_the_beginning(&times, &both_sides, self.time(0) - 0.25 * mean);
        let by_amplitude =
            first_period.zip(options.amplitude).map(|(period, a)| by_first_amplitude(period, a));
        let by_amplitude = by_amplitude.map(|t0| {
            let dry = options.amplitude.map_or(0.0, |a| dry_friction(t0.value, a.value, &both_sides));
            t0.with_error(dry * t0.value)
        });
        let (t0, t0_source) = match (&by_speeds, by_amplitude) {
            (Some(speeds), _) => (Some(speeds.t0), Some(T0Source::Speeds)),
            (None, Some(t0)) => (Some(t0), Some(T0Source::FirstAmplitude)),
            (None, None) => (None, None),
        };
        let contradiction =
            by_speeds.as_ref().and_then(|speeds| contradicting(speeds.t0, speeds.beta.as_ref()?));
        let model = contradiction.as_ref().map_or(0.0, Contradiction::uncertainty);
        let amplitude_of = |cycle: usize| amplitudes.as_ref().and_then(|a| a.of_cycle(cycle));
        let cycle = |&cycle: &usize| GateCycle {
            time: 0.5 * (self.time(cycle) + self.time(cycle + 2)),
            period: self.period(cycle),
            side: self.placed[cycle].side,
            amplitude: amplitude_of(cycle),
        };
        let mut fit = GatesFit {
            passages: passages.passages.len(),
            edges: passages.edges,
            unpaired: passages.unpaired,
            double_triggers: sides.spurious,
            missed: sides.missed,
            cycles: self.cycles.iter().map(cycle).collect(),
            part_between: self.part_between(),
            timing: self.timing(),
            mean_period: Uncertain { value: mean, uncertainty: spread },
            first_period,
            t0: t0.map(|t0| t0.with_error(model)),
            contradiction,
            t0_by_times: t0,
            t0_source,
            t0_by_width: by_speeds.as_ref().map(|speeds| speeds.t0_by_width),
            // Neighbouring periods share their passages.
            t0_degrees_of_freedom: by_speeds
                .as_ref()
                .map_or(count(periods.len() / 2).max(2.0) - 1.0, |speeds| speeds.degrees_of_freedom),
            amplitude: by_speeds
                .as_ref()
                .map_or(options.amplitude.map(|a| a.value), |speeds| speeds.amplitude),
            drag: amplitudes.as_ref().map(Amplitudes::typical_drag).filter(|drag| *drag > 0.0),
            beta: by_speeds.and_then(|speeds| speeds.beta),
            warnings: vec![],
        };
        fit.warnings = warning::warnings(&fit, both_sides.last().copied(), options.width.is_some());
        fit
    }
}

/// Compares T0 under the exact law with that of a free β, if β differs from 1.
fn contradicting(t0: Uncertain, beta: &Beta) -> Option<Contradiction> {
    /// The relative error of T0 by amplitudes from the speeds of single passages.
    const LEAST: f64 = 4e-5;
    let degrees_of_freedom = beta.degrees_of_freedom;
    let estimate = |(name, t0): (&str, _)| Estimate { name: name.to_owned(), t0, degrees_of_freedom };
    let pair = [("β = 1", t0), ("β free", beta.t0)].map(estimate);
    Contradiction::of(pair.each_ref(), beta.deviation(), degrees_of_freedom)
        .filter(|contradiction| contradiction.half_width() > LEAST * t0.value)
}

/// Relative standard uncertainty of T0 by dry friction, which lengthens the first period by p²/8π if it takes the part p of the first amplitude in each
/// period (linear damping by p²/8π², which is part of T0). The kind of damping is not known: the error is anywhere between zero and this.
fn dry_friction(t0: f64, first_amplitude: f64, periods: &[f64]) -> f64 {
    let excess = Law::exact().ratio_at(first_amplitude) - 1.0;
    // Later periods are longer again where friction stops the pendulum. R − 1 is nearly proportional to A².
    let falls = periods.iter().enumerate().skip(periods.len() / 4).map(|(half_swing, period)| {
        let left = libm::sqrt(((period / t0 - 1.0) / excess).clamp(0.0, 1.0));
        (1.0 - left) / (1.0 + 0.5 * count(half_swing))
    });
    let part = falls.fold(0.0, f64::max);
    part * part / (8.0 * PI * libm::sqrt(3.0))
}

/// T0 from the first period and its amplitude.
fn by_first_amplitude(period: Uncertain, amplitude: Quantity) -> Uncertain {
    let ratio = Law::exact().ratio_at(amplitude.value);
    let slope = Law::exact().slope_at(amplitude.value);
    let relative = libm::hypot(period.relative(), slope * amplitude.uncertainty.unwrap_or(0.0) / ratio);
    let value = period.value / ratio;
    Uncertain { value, uncertainty: value * relative }
}
