//! Remarks on the harmonics of a swing.

use std::fmt;

use super::Harmonic;
use crate::fit::uncertain::Uncertain;
use crate::measurement::Observable;
use crate::statistics::count;
use crate::statistics::student::quantile;

/// A remark on a spectrum.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SpectrumRemark {
    /// The swings are not centred on zero.
    Offset {
        /// Centre in rad or rad/s.
        value: Uncertain,
        /// The measured quantity.
        observable: Observable,
    },
    /// An even harmonic, which no pendulum has.
    Even {
        /// The order of the harmonic.
        n: usize,
        /// The amplitude of the harmonic relative to the first.
        part: Uncertain,
    },
    /// More or less of an odd harmonic in phase than the pendulum has.
    Odd {
        /// The order of the harmonic.
        n: usize,
        /// Ratio of the measured harmonic to that of theory.
        ratio: Uncertain,
        /// Factor of the angles with which both would be the same; `None` where no factor achieves this.
        scale: Option<f64>,
    },
    /// An odd harmonic that is a quarter of its period off.
    Quadrature {
        /// The order of the harmonic.
        n: usize,
        /// Quadrature relative to the first harmonic.
        part: Uncertain,
    },
    /// Harmonics for which the rows are too far apart.
    NotSampled {
        /// The highest harmonic that the sampling rate allows.
        highest: usize,
        /// The highest harmonic of the request.
        asked: usize,
    },
    /// Windows without a result.
    WindowsLeftOut {
        /// Number of windows that are left out.
        windows: usize,
        /// Number of all windows.
        of: usize,
    },
    /// Rows far from all harmonics.
    Outliers {
        /// Number of rows.
        rows: usize,
    },
}

/// Probability of chance for the usual number of harmonics, that of three standard deviations of a normal error; proportionally lower for more
/// harmonics.
const BY_CHANCE: f64 = 2.7e-3;
const USUALLY: f64 = 7.0;

/// Errors in windows of amplitudes that fall by a third to each side: relative to a harmonic itself, and to the first one.
const INEXACT: [f64; 2] = [1e-3, 1e-5];

/// Returns `true` if a difference of this many uncertainties is more than chance, where these have this many degrees of freedom.
fn is_significant(deviation: Option<f64>, degrees_of_freedom: usize, harmonics: usize) -> bool {
    let chance = BY_CHANCE * (USUALLY / count(harmonics)).min(1.0);
    let limit = quantile(chance, count(degrees_of_freedom));
    deviation.is_some_and(|deviation| deviation.abs() > limit)
}

/// Properties of the swing to which a harmonic belongs.
#[derive(Clone, Copy, Debug)]
pub(super) struct MeasuredSwing {
    pub(super) observable: Observable,
    /// The first harmonic.
    pub(super) first: f64,
    /// The rate at which the amplitude falls (rad/s) over the frequency (rad/s).
    pub(super) decay: f64,
    /// Number of harmonics that are tested.
    pub(super) harmonics: usize,
}

/// Remarks on a harmonic that grows with this power of the first.
pub(super) fn of_harmonic(harmonic: &Harmonic, growth: f64, swing: &MeasuredSwing) -> Vec<SpectrumRemark> {
    let MeasuredSwing { observable, first, decay, .. } = *swing;
    let Harmonic { n, in_phase, theory, .. } = *harmonic;
    let is_known = |value: f64| value.abs() > INEXACT[0] * theory.abs() + INEXACT[1] * first;
    let differs = harmonic.difference.is_some_and(|difference| is_known(difference.value))
        && is_significant(harmonic.deviation(), harmonic.degrees_of_freedom, swing.harmonics);
    let lags = harmonic.quadrature.is_some_and(|quadrature| is_known(quadrature.value))
        && is_significant(harmonic.quadrature_deviation(), harmonic.degrees_of_freedom, swing.harmonics);
    let part = |quantity: Uncertain| Uncertain {
        value: quantity.value.abs() / first,
        uncertainty: quantity.uncertainty / first,
    };
    if n == 0 {
        return if differs { vec![SpectrumRemark::Offset { value: in_phase, observable }] } else { vec![] };
    }
    if n % 2 == 0 {
        let is_there = differs || lags;
        return if is_there {
            vec![SpectrumRemark::Even { n, part: part(harmonic.amplitude()) }]
        } else {
            vec![]
        };
    }
    let mut remarks = vec![];
    if let (true, Some(difference)) = (differs, harmonic.difference) {
        let ratio = Uncertain {
            value: in_phase.value / theory,
            uncertainty: (difference.uncertainty / theory).abs(),
        };
        let scale = libm::pow(ratio.value, 1.0 / (growth - 1.0));
        remarks.push(SpectrumRemark::Odd { n, ratio, scale: scale.is_finite().then_some(scale) });
    }
    // Linear damping turns the third harmonic by 3/2 of the decay over the frequency, others by about n/2.
    let of_damping = count(n) * decay * theory.abs();
    if let (true, Some(quadrature)) = (lags, harmonic.quadrature)
        && quadrature.value.abs() > of_damping
    {
        remarks.push(SpectrumRemark::Quadrature { n, part: part(quadrature) });
    }
    remarks
}

impl SpectrumRemark {
    /// A stable name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Offset { .. } => "offset",
            Self::Even { .. } => "even_harmonic",
            Self::Odd { .. } => "odd_harmonic",
            Self::Quadrature { .. } => "quadrature",
            Self::NotSampled { .. } => "not_sampled",
            Self::WindowsLeftOut { .. } => "windows_left_out",
            Self::Outliers { .. } => "outliers",
        }
    }
}

impl fmt::Display for SpectrumRemark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = |quantity: &Uncertain| Uncertain {
            value: 100.0 * quantity.value,
            uncertainty: 100.0 * quantity.uncertainty,
        };
        match self {
            Self::Offset { value, observable: Observable::Angle } => {
                let degrees = Uncertain {
                    value: value.value.to_degrees(),
                    uncertainty: value.uncertainty.to_degrees(),
                };
                write!(
                    f,
                    "the swings are centred at {degrees} degrees: the zero of the angle is not the position at rest"
                )
            }
            Self::Offset { value, .. } => {
                write!(f, "the velocities are centred at {value} rad/s: the zero of the gyroscope is wrong")
            }
            Self::Even { n, part } => write!(
                f,
                "harmonic {n} is {} % of the first, where a pendulum has none: the two sides differ, as with a nonlinear \
                 scale of the angle (a camera at a slant), a centre other than the pivot, or a torque that differs between the sides",
                percent(part)
            ),
            Self::Odd { n, ratio, scale } => {
                write!(
                    f,
                    "harmonic {n} is {ratio} times that of a pendulum of this amplitude: the restoring torque is not that of \
                     gravity alone, or the scale of the angle is wrong"
                )?;
                match scale {
                    Some(scale) => write!(f, " (by the factor {scale:.3}, if that is all)"),
                    None => Ok(()),
                }
            }
            Self::Quadrature { n, part } => write!(
                f,
                "harmonic {n} has {} % of the first in quadrature, which no torque that depends on the angle \
                 alone causes: nonlinear damping, such as dry friction or air drag, or a delay of the instrument",
                percent(part)
            ),
            Self::NotSampled { highest, asked } => write!(
                f,
                "harmonics above {highest} are not determined, though {asked} were requested: the rows are too far \
                 apart, and these harmonics appear among the lower ones"
            ),
            Self::WindowsLeftOut { windows, of } => write!(
                f,
                "{windows} of {of} windows of swings are left out: rows are missing, the pendulum goes over the top, or the \
                 swing is lost in noise"
            ),
            Self::Outliers { rows } => {
                let plural = if *rows == 1 { " is" } else { "s are" };
                write!(
                    f,
                    "{rows} row{plural} left out, more than five standard deviations from all harmonics"
                )
            }
        }
    }
}
