//! The results of a fit of traces.

use crate::statistics::count;
use std::f64::consts::PI;

use super::{Autocorrelation, DampingKind, DampingModel};
use crate::fit::quality;
use crate::fit::quality::Quality;
use crate::fit::uncertain::Uncertain;

/// A kind of parameter of a fit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ParameterKind {
    /// ω0, the angular frequency of small swings without damping.
    #[default]
    NaturalFrequency,
    /// A coefficient of damping.
    Damping(DampingKind),
    /// Measured radians per radian.
    Scale,
    /// The reading at the equilibrium.
    Offset,
    /// The angle at the first row.
    FirstAngle,
    /// The angular velocity at the first row.
    FirstVelocity,
}

impl ParameterKind {
    /// `omega0`, `dry`, `linear`, `quadratic`, `scale`, `offset`, `theta0`, `velocity0`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::NaturalFrequency => "omega0",
            Self::Damping(term) => term.name(),
            Self::Scale => "scale",
            Self::Offset => "offset",
            Self::FirstAngle => "theta0",
            Self::FirstVelocity => "velocity0",
        }
    }
}

/// A fitted number with its uncertainty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parameter {
    /// The kind; each trace has a separate offset, initial angle and initial velocity.
    pub kind: ParameterKind,
    /// Unit: `rad/s`, `rad/s^2`, `1/s`, `rad`; `1` for none.
    pub unit: &'static str,
    /// Index of the only trace with this parameter, counted from zero; `None` if all share it.
    pub trace: Option<usize>,
    /// The value with its standard uncertainty: the formal one, times the inflation by the correlation of residuals,
    /// with the contributions of the clock and of a fitted pivot.
    pub estimate: Uncertain,
    /// The standard uncertainty if the residuals were independent.
    pub formal_uncertainty: f64,
    /// Degrees of freedom of Student's t for the intervals; fewer than rows less parameters where the noise is correlated.
    pub degrees_of_freedom: f64,
    /// Intervals that contain the true value with 68.3 % and 95 %: by the profile likelihood for the shared parameters if it is requested,
    /// otherwise by the linear approximation.
    pub intervals: [[f64; 2]; 2],
}

/// The fit of one trace.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedTrace {
    /// Time of its first row, in the clock of the trace, in s.
    pub start_time: f64,
    /// Values of the fit, in the unit of the trace, row by row.
    pub fitted: Vec<f64>,
    /// Measured values minus those of the fit.
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

/// The best motion of a model for the traces.
#[derive(Clone, Debug, PartialEq)]
pub struct TraceFit {
    /// The kinds of damping of the model.
    pub damping: DampingModel,
    /// Parameters that all traces share, then those of each trace. A scale that was not free is not among them.
    pub parameters: Vec<Parameter>,
    /// Correlations of the parameters, in their order.
    pub correlations: Vec<Vec<f64>>,
    /// Fits of the traces, in their order.
    pub traces: Vec<FittedTrace>,
    /// Rows less parameters.
    pub degrees_of_freedom: usize,
    /// Number of rows with independent errors that would determine ω0 and the damping as well; at most the number of rows.
    pub independent_rows: f64,
    /// The weighted sum of squares over its degrees of freedom; `None` without uncertainties of the rows.
    pub chi2_per_dof: Option<f64>,
    /// Root mean square of the residuals, in the unit of the traces.
    pub rms: f64,
    /// The sum of squares of the residuals over that of the data about their means.
    pub unexplained: f64,
    /// Autocorrelation of the residuals.
    pub autocorrelation: Autocorrelation,
    /// The number of rows in a block of the bootstrap, if it was needed.
    pub bootstrap_block: Option<usize>,
    /// `true` if the search ended at a minimum.
    pub converged: bool,
    /// Residuals in units of the stated uncertainties, outliers at their full size.
    #[doc(hidden)]
    pub standard_residuals: Vec<f64>,
}

impl TraceFit {
    /// The first parameter of a kind.
    #[must_use]
    pub fn parameter(&self, kind: ParameterKind) -> Option<&Parameter> {
        self.parameters.iter().find(|parameter| parameter.kind == kind)
    }

    /// The coefficient of a kind of damping; `None` if the model lacks it.
    #[must_use]
    pub fn damping_coefficient(&self, term: DampingKind) -> Option<&Parameter> {
        self.parameter(ParameterKind::Damping(term))
    }

    /// 2π/ω0, the period of the smallest swings, in s.
    #[must_use]
    pub fn small_angle_period(&self) -> Uncertain {
        let omega0 = &self.parameters[0];
        let period = 2.0 * PI / omega0.estimate.value;
        Uncertain { value: period, uncertainty: period * omega0.estimate.uncertainty / omega0.estimate.value }
    }

    /// Q: ω0/c for linear damping, 2πE/ΔE of the undamped cycle at this amplitude, in radians, for any other; `None` where the damping takes no
    /// energy.
    #[must_use]
    pub fn quality(&self, amplitude: f64) -> Option<Quality> {
        let is_linear = self.damping == DampingModel::only(DampingKind::Linear);
        let omega0 = self.parameters[0].estimate.value;
        // ΔE/(2πE) by each coefficient, and its derivatives with respect to the parameters.
        let (mut loss, mut slopes) = (0.0, vec![0.0; self.parameters.len()]);
        for (index, term) in (1..).zip(self.damping.iter()) {
            let (of_one, coefficient) = (
                if is_linear { 1.0 } else { quality::loss(term, amplitude) },
                self.parameters[index].estimate.value,
            );
            slopes[index] = of_one * libm::pow(omega0, term.exponent() - 2.0);
            loss += coefficient * slopes[index];
            slopes[0] += (term.exponent() - 2.0) * coefficient * slopes[index] / omega0;
        }
        let value = 1.0 / loss;
        let factor = Uncertain { value, uncertainty: value * value * self.deviation_of(&slopes) };
        (loss > 0.0).then_some(Quality { factor, amplitude: (!is_linear).then_some(amplitude) })
    }

    /// Standard uncertainty of a sum of the parameters with these factors.
    fn deviation_of(&self, factors: &[f64]) -> f64 {
        let parts = self.parameters.iter().zip(factors);
        let parts: Vec<f64> =
            parts.map(|(parameter, factor)| parameter.estimate.uncertainty * factor).collect();
        let rows = self.correlations.iter().zip(&parts);
        let sum =
            |row: &[f64]| row.iter().zip(&parts).map(|(correlation, part)| correlation * part).sum::<f64>();
        rows.map(|(row, part)| part * sum(row)).sum::<f64>().max(0.0).sqrt()
    }

    /// Returns `true` if the damping takes energy at all speeds that the pendulum had, within two standard uncertainties. A single
    /// coefficient may be negative: the friction of a bearing can become less at higher speed.
    #[must_use]
    pub fn dissipates(&self) -> bool {
        /// Number of speeds tested: between two of them a parabola dips by at most the 256th part of its quadratic term at the greatest speed. With
        /// 3 nothing changed in 21 fits; with 50 one that was excluded already was found to supply energy.
        const SPEEDS: usize = 9;
        let fastest = (0..self.traces.len()).map(|trace| self.greatest_speed(trace)).fold(0.0, f64::max);
        (0..SPEEDS).all(|n| {
            let (force, uncertainty) = self.damping_at(fastest * count(n) / count(SPEEDS - 1));
            force >= -2.0 * uncertainty
        })
    }

    /// Returns `true` if no coefficient of damping is negative by more than two standard uncertainties.
    #[must_use]
    pub fn dissipates_by_each_term(&self) -> bool {
        self.negative_terms().is_empty()
    }

    /// The kinds of damping with a coefficient negative by more than two standard uncertainties.
    #[must_use]
    pub fn negative_terms(&self) -> Vec<DampingKind> {
        let negative = |term: &DampingKind| {
            self.damping_coefficient(*term).is_some_and(|coefficient| {
                coefficient.estimate.value < -2.0 * coefficient.estimate.uncertainty
            })
        };
        self.damping.iter().filter(negative).collect()
    }

    /// d + b·v + c·v² at a speed, in rad/s², with its standard uncertainty.
    fn damping_at(&self, speed: f64) -> (f64, f64) {
        let power = |parameter: &Parameter| match parameter.kind {
            ParameterKind::Damping(term) => libm::pow(speed, term.exponent()),
            _ => 0.0,
        };
        let powers: Vec<f64> = self.parameters.iter().map(power).collect();
        let force = self
            .parameters
            .iter()
            .zip(&powers)
            .map(|(parameter, power)| parameter.estimate.value * power)
            .sum();
        (force, self.deviation_of(&powers))
    }

    /// The speed at the bottom by the energy at the beginning of a trace.
    fn greatest_speed(&self, trace: usize) -> f64 {
        let parameter_of = |kind| {
            self.parameters.iter().find(|parameter| parameter.trace == Some(trace) && parameter.kind == kind)
        };
        let value = |kind| parameter_of(kind).map_or(0.0, |parameter| parameter.estimate.value);
        let height = 2.0 * libm::sin(0.5 * value(ParameterKind::FirstAngle));
        libm::hypot(value(ParameterKind::FirstVelocity), self.parameters[0].estimate.value * height)
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.traces.iter().map(|trace| trace.residuals.len()).sum()
    }
}
