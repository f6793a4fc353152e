//! All results of recordings of swings.

use super::{Advice, FittedPendulum, Warning};
use crate::fit::beta::Beta;
use crate::fit::contradiction::{Contradiction, Estimate};
use crate::fit::cycles::{Cycle, Cycles, CyclesError};
use crate::fit::damping_model::DampingModel;
use crate::fit::quality::Quality;
use crate::fit::significance::{SIGNIFICANT, limit_of_chance};
use crate::fit::trace::{Comparison, ParameterKind, TraceFit};
use crate::fit::uncertain::Uncertain;
use crate::measurement::Trace;
use crate::statistics::count;

/// All results of recordings of swings.
#[derive(Clone, Debug, PartialEq)]
pub struct SwingsFit {
    /// Fit of the given model, or of the one that the data prefer.
    pub fit: TraceFit,
    /// Comparison with the other models, where they were compared.
    pub comparison: Option<Comparison>,
    /// Cycles of each trace.
    pub cycles: Vec<Result<Cycles, CyclesError>>,
    /// The test of the exact law over all cycles, or the reason why there is none.
    pub beta: Result<Beta, CyclesError>,
    /// Fits that contradict each other, whose difference is a part of the uncertainty of T0.
    pub contradiction: Option<Contradiction>,
    /// Gravity or the length.
    pub pendulum: FittedPendulum,
    /// Warnings, the gravest first.
    pub warnings: Vec<Warning>,
    /// Advice for a better measurement, the most helpful first.
    pub advice: Vec<Advice>,
}

impl SwingsFit {
    /// T0, in s: averaged over the models that are not ruled out, with the contributions of runs and contradicting fits to its uncertainty. The
    /// error of a scale of the angles that is wrong by a few per cent is detected, and part of the uncertainty, if swings begin at 0.5 rad or more;
    /// for smaller ones the uncertainty of the scale has to be [stated](super::SwingsOptions::angle_scale).
    #[must_use]
    pub fn small_angle_period(&self) -> Uncertain {
        let model = self.contradiction.as_ref().map_or(0.0, Contradiction::uncertainty);
        self.period_of_runs().with_error(model)
    }

    /// Q of the fitted model: ω0/c for linear damping, 2πE/ΔE at the largest amplitude of a cycle for any other. Its uncertainty includes the
    /// difference to models that are not ruled out. `None` without damping, and without a cycle where the amplitude matters.
    #[must_use]
    pub fn quality(&self) -> Option<Quality> {
        let amplitude = self.amplitudes().map(|[largest, _]| largest);
        let quality = self.fit.quality(amplitude.unwrap_or(f64::NAN))?;
        let spread = self.comparison.as_ref().zip(amplitude);
        let spread =
            spread.map_or(0.0, |(comparison, amplitude)| comparison.spread_of_quality(&self.fit, amplitude));
        let is_known = quality.factor.value.is_finite();
        is_known.then(|| Quality { factor: quality.factor.with_error(spread), ..quality })
    }

    /// T0, in s, with its uncertainty enlarged if runs scatter by more than theirs: by √(χ²/ν) of the T0 by their cycles.
    pub(super) fn period_of_runs(&self) -> Uncertain {
        let period = small_angle_period(&self.fit, self.comparison.as_ref());
        let runs: Vec<Uncertain> = self.cycles.iter().flatten().map(|cycles| cycles.t0).collect();
        Uncertain { uncertainty: period.uncertainty * scatter_of_runs(&runs), ..period }
    }

    /// The largest contradiction between the whole motion, the cycles with β = 1 and with β free, and single runs. Cycles are not used
    /// where the amplitude falls fast, nor where a scale of the angles is fitted.
    pub(super) fn contradicting(&self, traces: &[Trace]) -> Option<Contradiction> {
        if self.scale_is_fitted() || self.strong_damping().is_some() {
            return None;
        }
        let estimate =
            |name: &str, t0, degrees_of_freedom| Estimate { name: name.to_owned(), t0, degrees_of_freedom };
        let by_cycles = |t0: Uncertain| t0.with_error(ERROR_OF_CYCLES * t0.value);
        let whole = small_angle_period(&self.fit, self.comparison.as_ref());
        let whole = estimate("the whole motion", whole, f64::INFINITY);
        let runs: Vec<Estimate> = traces
            .iter()
            .zip(&self.cycles)
            .filter_map(|(trace, cycles)| {
                let name = if traces.len() > 1 {
                    format!("the cycles of {}", trace.name())
                } else {
                    "cycles".to_owned()
                };
                let cycles = cycles.as_ref().ok()?;
                Some(estimate(&name, by_cycles(cycles.t0), cycles.t0_degrees_of_freedom))
            })
            .collect();
        let free = self
            .beta
            .as_ref()
            .ok()
            .map(|beta| (beta, estimate("β free", by_cycles(beta.t0), beta.degrees_of_freedom)));
        let of_beta = free.iter().filter(|(beta, _)| self.is_contradicted_by(beta));
        let of_beta = of_beta.filter_map(|(beta, free)| {
            Contradiction::of([&whole, free], beta.deviation(), beta.degrees_of_freedom)
        });
        let with_whole = runs.iter().filter_map(|run| Contradiction::of_independent([&whole, run]));
        let pairs = runs
            .iter()
            .enumerate()
            .flat_map(|(index, run)| runs[..index].iter().map(move |other| [other, run]));
        Contradiction::largest(
            of_beta.chain(with_whole).chain(pairs.filter_map(Contradiction::of_independent)),
        )
    }

    /// Returns `true` if T0 with β free differs from that of the whole motion by more than the two methods may differ.
    fn is_contradicted_by(&self, beta: &Beta) -> bool {
        let period = self.fit.small_angle_period().value;
        (beta.t0.value - period).abs() > LEAST_CONTRADICTION * period
    }

    /// The models that are not ruled out and that contradict the preferred one.
    #[must_use]
    pub fn rivals(&self) -> Vec<DampingModel> {
        self.comparison.as_ref().map(Comparison::contradicting).unwrap_or_default()
    }

    /// All cycles that were measured, with the index of their trace.
    pub fn all_cycles(&self) -> impl Iterator<Item = (usize, &Cycle)> {
        let measured =
            self.cycles.iter().enumerate().filter_map(|(trace, cycles)| Some((trace, cycles.as_ref().ok()?)));
        measured.flat_map(|(trace, cycles)| cycles.cycles.iter().map(move |cycle| (trace, cycle)))
    }

    /// The largest and the smallest amplitude of a cycle, in radians.
    #[must_use]
    pub fn amplitudes(&self) -> Option<[f64; 2]> {
        let sizes = || self.all_cycles().map(|(_, cycle)| cycle.amplitude.value);
        Some([sizes().reduce(f64::max)?, sizes().reduce(f64::min)?])
    }

    /// Returns `true` if the scale of the angles was fitted.
    #[must_use]
    pub fn scale_is_fitted(&self) -> bool {
        self.fit.parameter(ParameterKind::Scale).is_some()
    }

    /// Relative fall of the amplitude in a cycle, where T/T0 differs most from 1: the mean with the weights R − 1.
    #[must_use]
    pub fn fall_in_a_cycle(&self) -> Option<f64> {
        let all = self.cycles.iter().flatten().map(|cycles| &cycles.cycles);
        // Cycles overlap by half.
        let pairs = all.flat_map(|cycles| cycles.windows(3).map(|three| (three[0], three[2])));
        let (weights, sum) = pairs.fold((0.0, 0.0), |(weights, sum), (earlier, later)| {
            let weight = earlier.period_ratio - 1.0;
            let cycles = (later.time - earlier.time) / earlier.period.value;
            let fall = 1.0 - later.amplitude.value / earlier.amplitude.value;
            (weights + weight, sum + weight * fall / cycles)
        });
        (weights > 0.0).then(|| sum / weights)
    }

    /// T0 by the cycles of a single trace, where it is not that of the whole motion, and its distance from it in uncertainties.
    pub(super) fn other_period(&self) -> Option<(f64, f64)> {
        /// Relative difference below which the two methods may differ: the local fits alone are off by up to 5e-5 without any noise, and the
        /// damping adds as much (`without_noise_every_cycle_obeys_the_exact_law`).
        const WORTH_A_WORD: f64 = 1e-4;
        let [Ok(cycles)] = &self.cycles[..] else { return None };
        let period = self.fit.small_angle_period();
        let difference = (cycles.t0.value - period.value).abs();
        let deviation = period.with_error(cycles.t0.uncertainty).deviation_from(cycles.t0.value);
        let limit = limit_of_chance(SIGNIFICANT, cycles.t0_degrees_of_freedom);
        (deviation > limit && difference > WORTH_A_WORD * period.value)
            .then_some((cycles.t0.value, deviation))
    }
}

/// T0 of a fit, or averaged over the models that are not ruled out.
pub(super) fn small_angle_period(fit: &TraceFit, comparison: Option<&Comparison>) -> Uncertain {
    comparison.map_or_else(|| fit.small_angle_period(), |comparison| comparison.small_angle_period().mean)
}

/// Relative error of T0 by cycles: local fits are off by up to this without any noise, and the damping adds as much.
const ERROR_OF_CYCLES: f64 = 5e-5;
/// Largest negligible relative difference of T0 with β free.
const LEAST_CONTRADICTION: f64 = 1e-5;

/// √(χ²/ν) of values about their weighted mean, or one where that is less.
fn scatter_of_runs(runs: &[Uncertain]) -> f64 {
    if runs.len() < 2 {
        return 1.0;
    }
    let weight = |run: &Uncertain| 1.0 / (run.uncertainty * run.uncertainty);
    let total: f64 = runs.iter().map(weight).sum();
    let mean = runs.iter().map(|run| weight(run) * run.value).sum::<f64>() / total;
    let chi2: f64 = runs.iter().map(|run| weight(run) * (run.value - mean) * (run.value - mean)).sum();
    (chi2 / count(runs.len() - 1)).sqrt().max(1.0)
}
