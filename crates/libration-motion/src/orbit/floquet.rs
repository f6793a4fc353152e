//! What becomes of small deviations from a periodic orbit in one period.

use super::path::Path;
use libration_numbers::algebra::{Complex, Doubles};
use libration_numbers::internals::linear::eigenvalues;
use libration_numbers::{
    expression::{Equation, Symbol},
    internals::expression::{Jet, Tape},
};

/// The Floquet multipliers of a periodic orbit: the eigenvalues of the matrix that maps a deviation to what it is one
/// period later.
#[derive(Clone, Debug, PartialEq)]
pub struct Floquet {
    /// By descending magnitude.
    ///
    /// # Accuracy
    /// A multiplier of 1 that occurs twice, as for every orbit of a conservative system, is right to half the digits only.
    pub multipliers: Vec<Complex>,
    /// What they say.
    pub stability: Stability,
    /// Of a cycle of one coordinate, whose other multiplier is 1: the logarithm of its multiplier, which may be below all numbers.
    pub logarithm: Option<f64>,
}

/// How fast deviations of one coordinate that no force beats time for shrink or grow together: ∂F/∂x′.
#[derive(Debug)]
pub(super) struct Divergence {
    of_state: Tape,
}

impl Divergence {
    /// `None` for several coordinates, or a derivative without values.
    pub(super) fn new(equation: &Equation) -> Option<Self> {
        let [variable] = equation.variables() else { return None };
        equation.refuse_first_order().ok()?;
        let x = Symbol::plain(variable);
        let velocity = x.with_primes(1);
        let slope = equation.accelerations()[0].derivative(&velocity).simplified();
        Some(Self { of_state: Tape::new(&[&slope], &[x, velocity]).ok()? })
    }

    /// Its integral along a motion.
    pub(super) fn along(&self, path: &Path) -> f64 {
        path.integral(|state| {
            Jet::new(&Doubles, &self.of_state, state).map_or(f64::NAN, |jet| jet.result(0)[0])
        })
    }
}

/// What small deviations do. A shift along an orbit that no force beats time for stays, and does not count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    /// Of a cycle of one coordinate, by Liouville's theorem; a multiplier below all numbers is 0.
    pub(super) fn of_cycle(logarithm: f64) -> Self {
        let mut multipliers = vec![Complex::from(1.0), Complex::from(libm::exp(logarithm))];
        multipliers.sort_by(|a, b| b.abs().total_cmp(&a.abs()));
        Self { multipliers, stability: stability(libm::exp(logarithm)), logarithm: Some(logarithm) }
    }

    /// Of an orbit among others in a plane of states.
    pub(super) fn in_a_family_of_a_plane(self) -> Self {
        Self { multipliers: vec![Complex::from(1.0); 2], stability: Stability::Neutral, ..self }
    }

    /// `None` when the eigenvalues are not found.
    pub(super) fn new(monodromy: &[Vec<f64>], autonomous: bool) -> Option<Self> {
        let multipliers = eigenvalues(monodromy)?;
        let one = Complex::from(1.0);
        let distance = |&k: &usize| (multipliers[k] - one).abs();
        let places = || 0..multipliers.len();
        let trivial = places().min_by(|a, b| distance(a).total_cmp(&distance(b))).filter(|_| autonomous);
        let largest = places().filter(|k| Some(*k) != trivial).map(|k| multipliers[k].abs());
        let largest = largest.fold(0.0, f64::max);
        Some(Self { multipliers, stability: stability(largest), logarithm: None })
    }
}

/// What the largest multiplier says that counts.
fn stability(largest: f64) -> Stability {
    match largest {
        size if size > 1.0 + ON_THE_CIRCLE => Stability::Unstable,
        size if size < 1.0 - ON_THE_CIRCLE => Stability::Attracting,
        _ => Stability::Neutral,
    }
}
