//! What a fit of traces has found.

use crate::statistics::count;
use std::f64::consts::PI;

use super::{Autocorrelation, DampingKind, DampingModel};
use crate::fit::Uncertain;

/// A fitted number with its uncertainty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parameter {
    /// `omega0`, `dry`, `linear`, `quadratic`, `scale`, or of one trace `offset`, `theta0`, `velocity0`.
    pub name: &'static str,
    /// `rad/s`, `rad/s^2`, `1/s`, `rad`; `1` where there is none.
    pub unit: &'static str,
    /// The trace that alone has it, counted from zero; none if all share it.
    pub trace: Option<usize>,
    /// The value with its standard uncertainty: the formal one, times what the likeness of residuals from row to row makes of it,
    /// with what the clock and a fitted pivot leave open.
    pub estimate: Uncertain,
    /// The standard uncertainty if the residuals were independent.
    pub formal_uncertainty: f64,
    /// Of Student's t, by which the intervals are found; fewer than rows less parameters where the noise remembers.
    pub degrees_of_freedom: f64,
    /// That hold the truth with 68.3 % and 95 %: by the profile likelihood for the shared parameters when asked for, else as if
    /// the model were linear.
    pub intervals: [[f64; 2]; 2],
}

/// What the model says of one trace.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedTrace {
    /// When its first row was, in the clock of the trace, in s.
    pub start_time: f64,
    /// What should have been seen, in the unit of the trace, row by row.
    pub fitted: Vec<f64>,
    /// What was seen less that.
    pub residuals: Vec<f64>,
    /// Rows whose residuals are beyond five robust standard deviations, counted from zero.
    pub outliers: Vec<usize>,
}

impl FittedTrace {
    /// Root mean square of its residuals, in the unit of the trace.
    #[must_use]
    pub fn rms(&self) -> f64 {
        let squares: f64 = self.residuals.iter().map(|residual| residual * residual).sum();
        (squares / count(self.residuals.len())).sqrt()
    }
}

/// The best motion of a model through traces.
#[derive(Clone, Debug, PartialEq)]
pub struct TraceFit {
    /// The kinds of damping of the model.
    pub damping: DampingModel,
    /// Those that all traces share, then those of each trace. A scale that was not free is not among them.
    pub parameters: Vec<Parameter>,
    /// Of the parameters, in their order.
    pub correlations: Vec<Vec<f64>>,
    /// Trace by trace.
    pub traces: Vec<FittedTrace>,
    /// Rows less parameters.
    pub degrees_of_freedom: usize,
    /// How many rows with independent errors would tell ω0 and the damping as well; at most the number of rows.
    pub independent_rows: f64,
    /// The weighted sum of squares over its degrees of freedom; none without uncertainties of the rows.
    pub chi2_per_dof: Option<f64>,
    /// Root mean square of the residuals, in the unit of the traces.
    pub rms: f64,
    /// The part of the scatter of the data about their means that the motion leaves, as squares.
    pub unexplained: f64,
    /// Whether the residuals are noise.
    pub autocorrelation: Autocorrelation,
    /// The number of rows that one block of the bootstrap has, where it was called for.
    pub bootstrap_block: Option<usize>,
    /// Whether the search ended at a minimum.
    pub converged: bool,
    /// In units of the stated uncertainties, outliers at their full size.
    #[doc(hidden)]
    pub standard_residuals: Vec<f64>,
}

impl TraceFit {
    /// The first parameter of that name.
    #[must_use]
    pub fn parameter(&self, name: &str) -> Option<&Parameter> {
        self.parameters.iter().find(|parameter| parameter.name == name)
    }

    /// 2π/ω0, the period of the smallest swings, in s.
    #[must_use]
    pub fn small_angle_period(&self) -> Uncertain {
        let omega0 = &self.parameters[0];
        let period = 2.0 * PI / omega0.estimate.value;
        Uncertain { value: period, uncertainty: period * omega0.estimate.uncertainty / omega0.estimate.value }
    }

    /// Whether the damping takes energy at all speeds that the pendulum had, within two standard uncertainties. A single
    /// coefficient may be negative: the friction of a bearing can become less at higher speed.
    #[must_use]
    pub fn dissipates(&self) -> bool {
        /// Between two of them a parabola dips by at most the 256th part of its quadratic term at the greatest speed. With 3 nothing
        /// changed in 21 fits, with 50 one that was excluded already was found to give energy.
        const SPEEDS: usize = 9;
        let fastest = (0..self.traces.len()).map(|trace| self.greatest_speed(trace)).fold(0.0, f64::max);
        (0..SPEEDS).all(|n| {
            let (force, uncertainty) = self.damping_at(fastest * count(n) / count(SPEEDS - 1));
            force >= -2.0 * uncertainty
        })
    }

    /// Whether no coefficient of damping is negative by more than two standard uncertainties.
    #[must_use]
    pub fn dissipates_by_each_term(&self) -> bool {
        self.negative_terms().is_empty()
    }

    /// The kinds of damping whose coefficient is negative by more than two standard uncertainties.
    #[must_use]
    pub fn negative_terms(&self) -> Vec<DampingKind> {
        let negative = |term: &DampingKind| {
            self.parameter(term.name()).is_some_and(|it| it.estimate.value < -2.0 * it.estimate.uncertainty)
        };
        self.damping.iter().filter(negative).collect()
    }

    /// d + b·v + c·v² at a speed, in rad/s², with its standard uncertainty.
    fn damping_at(&self, speed: f64) -> (f64, f64) {
        let power = |parameter: &Parameter| match parameter.name {
            "dry" => 1.0,
            "linear" => speed,
            "quadratic" => speed * speed,
            _ => 0.0,
        };
        let powers: Vec<f64> = self.parameters.iter().map(power).collect();
        let force = self
            .parameters
            .iter()
            .zip(&powers)
            .map(|(parameter, power)| parameter.estimate.value * power)
            .sum();
        let parts = self
            .parameters
            .iter()
            .zip(&powers)
            .map(|(parameter, power)| parameter.estimate.uncertainty * power);
        let parts: Vec<f64> = parts.collect();
        let rows = self.correlations.iter().zip(&parts);
        let variance =
            |row: &[f64]| row.iter().zip(&parts).map(|(correlation, part)| correlation * part).sum::<f64>();
        let variance: f64 = rows.map(|(row, part)| part * variance(row)).sum();
        (force, variance.max(0.0).sqrt())
    }

    /// The speed at the bottom by the energy at the beginning of a trace.
    fn greatest_speed(&self, trace: usize) -> f64 {
        let own = |name| self.parameters.iter().find(|it| it.trace == Some(trace) && it.name == name);
        let value = |name| own(name).map_or(0.0, |parameter| parameter.estimate.value);
        let height = 2.0 * libm::sin(0.5 * value("theta0"));
        libm::hypot(value("velocity0"), self.parameters[0].estimate.value * height)
    }

    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.traces.iter().map(|trace| trace.residuals.len()).sum()
    }
}
