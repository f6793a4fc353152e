//! What becomes of small deviations from a periodic orbit in one period.

use crate::algebra::Complex;
use crate::linear::eigenvalues;

/// The Floquet multipliers of a periodic orbit: the eigenvalues of the matrix that maps a deviation to what it is one
/// period later.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Floquet {
    /// By descending magnitude.
    ///
    /// # Accuracy
    /// A multiplier of 1 that occurs twice, as for every orbit of a conservative system, is right to half the digits only.
    pub multipliers: Vec<Complex>,
    /// What they say.
    pub stability: Stability,
}

/// What small deviations do. A shift along an orbit that no force beats time for stays, and does not count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum Stability {
    /// All die out.
    Attracting,
    /// None grows exponentially, some stay, as in conservative systems.
    Neutral,
    /// Some grow exponentially.
    Unstable,
}

/// Multipliers nearer to the unit circle than this are taken to be on it: a pair at 1, as conservative systems have, is found to the root
/// of the errors of the integration, 1e-12 at worst.
const ON_THE_CIRCLE: f64 = 1e-5;

impl Floquet {
    /// `None` when the eigenvalues are not found.
    pub(super) fn new(monodromy: &[Vec<f64>], autonomous: bool) -> Option<Self> {
        let multipliers = eigenvalues(monodromy)?;
        let one = Complex::from(1.0);
        let distance = |&k: &usize| (multipliers[k] - one).abs();
        let places = || 0..multipliers.len();
        let trivial = places().min_by(|a, b| distance(a).total_cmp(&distance(b))).filter(|_| autonomous);
        let largest = places().filter(|k| Some(*k) != trivial).map(|k| multipliers[k].abs());
        let largest = largest.fold(0.0, f64::max);
        let stability = match largest {
            size if size > 1.0 + ON_THE_CIRCLE => Stability::Unstable,
            size if size < 1.0 - ON_THE_CIRCLE => Stability::Attracting,
            _ => Stability::Neutral,
        };
        Some(Self { multipliers, stability })
    }
}
