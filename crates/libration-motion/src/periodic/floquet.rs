//! The Floquet multipliers of a periodic orbit, with their errors, and its stability.
//!
//! # Method
//! The error of a multiplier is the change of the matrix between two tolerances, times the adjugate
//! divided by the distances from the other multipliers (`linear::eigenvalue_errors`). An orbit is called
//! stable or unstable only if the moduli of the multipliers differ from one by more than their errors.

use super::norm::norm;
use libration_numbers::algebra::Complex;
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::internals::linear::{eigenvalue_errors, eigenvalues};

/// The Floquet multipliers of a periodic orbit: the eigenvalues of its monodromy matrix, which maps a deviation to the deviation one period
/// later.
#[derive(Clone, Debug, PartialEq)]
pub struct Floquet {
    /// The multipliers by descending magnitude.
    pub multipliers: Vec<Complex>,
    /// The error of each multiplier, in the same order, estimated from the error of the flow;
    /// that of a multiplier of multiplicity k is about the k-th root of the error of the flow.
    pub errors: Vec<f64>,
    /// The stability that the multipliers establish within their errors.
    pub stability: Stability,
    /// The logarithm of the other multiplier of a cycle of one coordinate, which may be too small for a floating-point number.
    pub logarithm: Option<f64>,
}

/// The behaviour of small deviations. A shift along an autonomous orbit persists, and is not counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// All deviations decay.
    Attracting,
    /// No deviation grows exponentially and some persist, as in conservative systems: the volume of deviations is conserved.
    Neutral,
    /// Some deviations grow exponentially.
    Unstable,
    /// The errors of the multipliers leave the decision open.
    Undetermined,
}

impl Stability {
    /// The stability of multipliers with their errors: attracting if all are inside the unit circle by more than
    /// their errors, unstable if one is outside by more than its error. Otherwise neutral if the product of all,
    /// which is the factor of the volume of deviations, is 1 within its error, and undetermined if it is not.
    #[must_use]
    pub fn of(multipliers: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let all: Vec<(f64, f64)> = multipliers.into_iter().collect();
        if all.iter().any(|(size, error)| size - error > 1.0) {
            return Self::Unstable;
        }
        // Comparisons with an error that is NaN are false, so that such an error establishes nothing.
        if all.iter().all(|(size, error)| size + error < 1.0) {
            return Self::Attracting;
        }
        let volume: f64 = all.iter().map(|(size, _)| size).product();
        let largest: f64 = all.iter().map(|(size, error)| size + error).product();
        if (volume - 1.0).abs() <= largest - volume { Self::Neutral } else { Self::Undetermined }
    }

    /// Returns `true` unless a deviation is known to grow exponentially: `false` for [`Stability::Unstable`] alone.
    #[must_use]
    pub fn may_last(self) -> bool {
        self != Self::Unstable
    }

    /// The word for the stability in files: `attracting`, `neutral`, `unstable` or `undetermined`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Attracting => "attracting",
            Self::Neutral => "neutral",
            Self::Unstable => "unstable",
            Self::Undetermined => "undetermined",
        }
    }
}

impl Floquet {
    /// The multiplier of a cycle of one coordinate, given its logarithm with an error (Liouville's theorem); 0 if it underflows.
    pub(crate) fn of_cycle(logarithm: f64, error: f64) -> Self {
        let multiplier = libm::exp(logarithm);
        let mut both = vec![(Complex::from(1.0), 0.0), (Complex::from(multiplier), multiplier * error)];
        both.put_in_order(|a, b| b.0.abs().total_cmp(&a.0.abs()));
        let (multipliers, errors) = both.into_iter().unzip();
        let stability = Stability::of([(multiplier, multiplier * error)]);
        Self { multipliers, errors, stability, logarithm: Some(logarithm) }
    }

    /// The multipliers of an orbit that belongs to a family in a plane of states: both are 1, since the neighbouring orbits close too.
    pub(crate) fn in_a_family_of_a_plane(self) -> Self {
        let multipliers = vec![Complex::from(1.0); 2];
        Self { multipliers, errors: vec![0.0; 2], stability: Stability::Neutral, ..self }
    }

    /// The multipliers of a monodromy matrix whose entries are known to an error, in
    /// units of the components of the state; `None` if the eigenvalues are not computed.
    pub(crate) fn new(monodromy: &[Vec<f64>], units: &[f64], change: f64, autonomous: bool) -> Option<Self> {
        let multipliers = eigenvalues(monodromy)?;
        let errors = multiplier_errors(monodromy, units, &multipliers, change);
        let one = Complex::from(1.0);
        let distance = |&k: &usize| (multipliers[k] - one).abs();
        let indices = || 0..multipliers.len();
        let trivial = indices().min_by(|a, b| distance(a).total_cmp(&distance(b))).filter(|_| autonomous);
        let counted = indices().filter(|k| Some(*k) != trivial).map(|k| (multipliers[k].abs(), errors[k]));
        let stability = Stability::of(counted);
        Some(Self { multipliers, errors, stability, logarithm: None })
    }
}

/// The errors of the eigenvalues of a monodromy matrix whose entries are known to a fraction of its
/// norm, the components of the state being measured in scaled units; including the errors by rounding.
pub fn multiplier_errors(
    monodromy: &[Vec<f64>],
    units: &[f64],
    multipliers: &[Complex],
    part: f64,
) -> Vec<f64> {
    /// Rounding errors of the QR algorithm for each row.
    const ROUNDINGS: f64 = 4.0;
    let row = |(row, own_unit): (&Vec<f64>, &f64)| {
        row.iter().zip(units).map(|(x, unit)| x * unit / own_unit).collect()
    };
    let scaled: Vec<Vec<f64>> = monodromy.iter().zip(units).map(row).collect();
    let norm = norm(&scaled.concat());
    let rows = scaled.iter().fold(0.0, |count, _| count + 1.0);
    eigenvalue_errors(&scaled, multipliers, norm * (part + ROUNDINGS * rows * f64::EPSILON))
}
