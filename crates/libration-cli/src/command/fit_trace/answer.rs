//! What is found in measured swings.

use super::input::Measured;
use super::model::Model;
use super::{advice, warnings};
use crate::arguments::ApparatusOptions;
use crate::failure::Failure;
use crate::interrupt;
use crate::output::progress::Progress;
use libration::pendulum::Amplitude;
use libration::quantity::Quantity;
use libration_lab::fit::cycles::{self, Cycle, Cycles, CyclesError};
use libration_lab::fit::trace::{Comparison, TraceFit, TraceFitError, TraceOptions, compare, fit_traces};
use libration_lab::fit::{
    self, Budget, Law, MeasuredPeriod, PeriodDamping, PeriodTable, Uncertainties, excess_scale,
};
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// The standard acceleration of free fall, in m/s².
pub(super) const STANDARD_GRAVITY: f64 = 9.80665;

/// Everything that is said about measured swings.
#[derive(Debug)]
pub(super) struct Answer<'a> {
    pub(super) measured: &'a Measured,
    /// Of the model that was asked for, or that the data prefer.
    pub(super) fit: TraceFit,
    /// With the other models, where they were compared.
    pub(super) comparison: Option<Comparison>,
    /// Of each trace.
    pub(super) cycles: Vec<Result<Cycles, CyclesError>>,
    /// The test of the exact law over all cycles, or why there is none.
    pub(super) beta: Result<Beta, String>,
    pub(super) pendulum: Pendulum,
    pub(super) warnings: Vec<String>,
    /// What each warning is about, in a word that stays.
    pub(super) warning_kinds: Vec<&'static str>,
    pub(super) advice: Vec<String>,
}

/// The factor β in T = T0·[1 + β(R − 1)], 1 for the exact law, and the T0 (s) that goes with it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beta {
    pub(super) value: f64,
    pub(super) uncertainty: f64,
    pub(super) t0: f64,
}

/// What ω0 says with the length, or without one.
#[derive(Clone, Debug)]
pub(super) enum Pendulum {
    /// Gravity with the budget of its uncertainty, from this length (m).
    Gravity { budget: Budget, length: Quantity },
    /// The length (m) of a simple pendulum where gravity is the standard one.
    Length { value: f64, uncertainty: f64 },
}

impl<'a> Answer<'a> {
    pub(super) fn new(
        measured: &'a Measured,
        model: Model,
        options: TraceOptions,
        apparatus: &ApparatusOptions,
    ) -> Result<Self, Failure> {
        let (fit, comparison) = fitted(measured, model, options)?;
        let cycles: Vec<_> =
            measured.traces.iter().map(|trace| cycles::cycles(trace, &cycles::Options::default())).collect();
        let beta = Beta::of(&cycles);
        let period = small_angle_period(&fit, comparison.as_ref());
        let pendulum = Pendulum::of(&fit, period, &cycles, apparatus)?;
        let mut answer = Self {
            measured,
            fit,
            comparison,
            cycles,
            beta,
            pendulum,
            warnings: vec![],
            warning_kinds: vec![],
            advice: vec![],
        };
        let warnings = warnings::of(&answer);
        (answer.warning_kinds, answer.warnings) =
            warnings.into_iter().map(|warning| (warning.kind, warning.text)).unzip();
        answer.advice = advice::of(&answer);
        Ok(answer)
    }

    /// All cycles that were measured, with the number of their trace.
    pub(super) fn all_cycles(&self) -> impl Iterator<Item = (usize, &Cycle)> {
        let measured =
            self.cycles.iter().enumerate().filter_map(|(trace, found)| Some((trace, found.as_ref().ok()?)));
        measured.flat_map(|(trace, found)| found.cycles.iter().map(move |cycle| (trace, cycle)))
    }

    /// T0 with its standard uncertainty, in s: averaged over the models that the data leave.
    pub(super) fn small_angle_period(&self) -> (f64, f64) {
        small_angle_period(&self.fit, self.comparison.as_ref())
    }

    /// The models that the data leave and that contradict the preferred one.
    pub(super) fn rivals(&self) -> Vec<String> {
        let rivals = self.comparison.iter().flat_map(Comparison::contradicting);
        rivals.map(|rival| rival.to_string()).collect()
    }

    /// By which part the amplitude falls in a cycle, where T/T0 differs most from 1: the mean with the weights R − 1.
    pub(super) fn fall_in_a_cycle(&self) -> Option<f64> {
        let all = self.cycles.iter().flatten().map(|found| &found.cycles);
        // Cycles overlap by half.
        let pairs = all.flat_map(|cycles| cycles.windows(3).map(|three| (three[0], three[2])));
        let (weights, sum) = pairs.fold((0.0, 0.0), |(weights, sum), (earlier, later)| {
            let weight = earlier.period_ratio - 1.0;
            let cycles = (later.time - earlier.time) / earlier.period;
            (weights + weight, sum + weight * (1.0 - later.amplitude / earlier.amplitude) / cycles)
        });
        (weights > 0.0).then(|| sum / weights)
    }

    /// Whether the scale of the angles was fitted.
    pub(super) fn scale_is_fitted(&self) -> bool {
        self.fit.parameters.iter().any(|parameter| parameter.name == "scale")
    }

    /// The largest and the smallest amplitude of a cycle, in radians.
    pub(super) fn amplitudes(&self) -> Option<(f64, f64)> {
        let sizes = || self.all_cycles().map(|(_, cycle)| cycle.amplitude);
        sizes().reduce(f64::max).zip(sizes().reduce(f64::min))
    }
}

fn small_angle_period(fit: &TraceFit, comparison: Option<&Comparison>) -> (f64, f64) {
    comparison.map_or_else(
        || fit.small_angle_period(),
        |comparison| {
            let averaged = comparison.small_angle_period();
            (averaged.value, averaged.uncertainty)
        },
    )
}

/// The fit of the model, with profile intervals, and the comparison it was chosen in.
fn fitted(
    measured: &Measured,
    model: Model,
    options: TraceOptions,
) -> Result<(TraceFit, Option<Comparison>), Failure> {
    interrupt::listen()?;
    let mut progress = Progress::new();
    let mut motions: u64 = 0;
    let mut watch = || -> ControlFlow<()> {
        motions += 1;
        progress.show(|| format!("fitting: {motions} motions integrated"));
        interrupt::go_on()
    };
    let options = TraceOptions { profile: true, ..options };
    let found = match model {
        Model::Given(damping) => {
            fit_traces(&measured.traces, damping, &options, &mut watch).map(|fit| (fit, None))
        }
        Model::Auto => compare(&measured.traces, &options, &mut watch)
            .map(|comparison| (comparison.best().clone(), Some(comparison))),
    };
    found.map_err(|error| failure(measured, error))
}

fn failure(measured: &Measured, error: TraceFitError) -> Failure {
    match error {
        TraceFitError::Interrupted => Failure::Interrupted("interrupted: nothing is written".to_owned()),
        error => Failure::no_answer(&measured.names(), error),
    }
}

impl Beta {
    /// That of the cycles of the only trace, or through the cycles of all.
    fn of(cycles: &[Result<Cycles, CyclesError>]) -> Result<Self, String> {
        if let [only] = cycles {
            let found = only.as_ref().map_err(ToString::to_string)?;
            let beta = found.beta.as_ref().map_err(ToString::to_string)?;
            return Ok(Self { value: beta.beta, uncertainty: beta.uncertainty, t0: beta.t0 });
        }
        Self::of_several(cycles)
    }

    /// Cycles overlap by half: every second one of each trace counts.
    fn of_several(cycles: &[Result<Cycles, CyclesError>]) -> Result<Self, String> {
        let counted = cycles.iter().flatten().flat_map(|found| found.cycles.iter().step_by(2));
        let counted: Vec<&Cycle> = counted.filter(|cycle| !cycle.outlier).collect();
        let column = |of: fn(&Cycle) -> f64| counted.iter().map(|cycle| of(cycle)).collect::<Vec<f64>>();
        cycles::cycles_tell_beta(counted.iter().copied()).map_err(|error| error.to_string())?;
        let of_amplitudes = column(|cycle| cycle.amplitude_uncertainty);
        let of_periods = column(|cycle| cycle.period_uncertainty);
        let uncertainties = Uncertainties { amplitudes: Some(&of_amplitudes), periods: Some(&of_periods) };
        let table =
            PeriodTable::new(&column(|cycle| cycle.amplitude), &column(|cycle| cycle.period), uncertainties)
                .map_err(|error| error.to_string())?;
        let fit = excess_scale(&table, &Law::exact()).map_err(|error| error.to_string())?;
        Ok(Self { value: fit.beta, uncertainty: fit.beta_uncertainty, t0: fit.t0 })
    }

    /// By which part the angles are too small, if a wrong scale of them can be why β is not 1.
    pub(super) fn scale_error(&self) -> Option<f64> {
        const MOST: f64 = 0.2;
        // R − 1 goes with the square of the amplitude.
        Some(0.5 * (self.value - 1.0)).filter(|part| part.abs() < MOST)
    }

    /// By how many of its uncertainties it differs from the exact law.
    pub(super) fn deviation(&self) -> f64 {
        (self.value - 1.0).abs() / self.uncertainty
    }
}

impl Pendulum {
    fn of(
        motion: &TraceFit,
        (value, uncertainty): (f64, f64),
        cycles: &[Result<Cycles, CyclesError>],
        options: &ApparatusOptions,
    ) -> Result<Self, Failure> {
        let Some(apparatus) = options.apparatus() else {
            let length = STANDARD_GRAVITY * (value / TAU) * (value / TAU);
            return Ok(Self::Length { value: length, uncertainty: 2.0 * length * uncertainty / value });
        };
        let period = MeasuredPeriod {
            t0: Quantity { value, uncertainty: Some(uncertainty) },
            amplitude: middle_amplitude(cycles),
            // What a fitted scale is worth is part of T0 already.
            angle_scale: motion.parameter("scale").map_or(options.angle_scale(), |_| Some(0.0)),
            clock: options.clock(),
            degrees_of_freedom: motion.parameters[0].degrees_of_freedom,
            damping: damping(motion),
        };
        let budget = fit::budget(&apparatus, &period, options.correlations())
            .map_err(|error| Failure::no_answer("gravity", error))?;
        Ok(Self::Gravity { budget, length: apparatus.length })
    }
}

/// A damped motion was fitted, whose T0 is that without damping; an undamped one leaves the damping in it.
fn damping(fit: &TraceFit) -> PeriodDamping {
    match fit.damping.count() {
        0 => PeriodDamping::Unknown,
        _ => PeriodDamping::Fitted(fit.parameter("linear").map_or(0.0, |linear| linear.value)),
    }
}

/// The amplitude whose T/T0 is the mean of those of the cycles.
fn middle_amplitude(cycles: &[Result<Cycles, CyclesError>]) -> Option<f64> {
    let ratios =
        cycles.iter().flatten().flat_map(|found| found.cycles.iter().map(|cycle| cycle.period_ratio));
    let (count, sum) = ratios.fold((0.0, 0.0), |(count, sum), ratio| (count + 1.0, sum + ratio));
    Amplitude::from_period_ratio(sum / count).ok().map(|amplitude| amplitude.radians())
}
