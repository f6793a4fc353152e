//! The equation of motion for a sum of few harmonics under a truncated force: the algebraic system that is left,
//! and all its solutions.
//!
//! # Method
//! Projections of the truncated force are exact sums over a few phases. All solutions, complex ones included, are followed from those of a system
//! of the same shape whose solutions are roots of unity (`tracking.rs`); no path goes to infinity, and their number 1 + d + d² + … is known
//! beforehand and checked. The small-angle branch is followed by itself from amplitude zero; the solution at its end is the accepted one.

mod collocation;
mod error;
mod newton;
mod tracking;
mod verdict;

use super::cosines::{COSINES, Cosines, cosines};
use super::open_gauge::over_linear_term;
use collocation::Collocation;
pub use error::TruncatedSystemError;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;
use libration_numbers::{
    algebra::{Complex, Polynomial, Rational, Ring, Variable},
    internals::algebra::PhaseRing,
};
pub use verdict::SolutionVerdict;

/// The system of equations for x = a₁ cos Ωt + a₃ cos 3Ωt + … with few harmonics, under an odd force cut off
/// after a power: the projections of Δ²x″ + g(x)/ω0² = 0 on those harmonics, with Δ = Ω/ω0, together with
/// a₁ + a₃ + … = amplitude.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::perturbation::{TruncatedSystem, SolutionVerdict};
/// use libration::progress::Quiet;
/// let sine = ["1", "0", "-1/6"].map(|text| text.parse().unwrap());
/// let system = TruncatedSystem::new(&sine, 2, 3)?;
/// let [first, third] = &system.conditions()[..] else { panic!() };
/// assert_eq!(first.to_string(), "-8 + a1^2 + a1*a3 + 2*a3^2 + 8*Delta^2");
/// assert_eq!(third.to_string(), "-24*a3 + a1^3 + 6*a1^2*a3 + 3*a3^3 + 216*a3*Delta^2");
///
/// let solutions = system.solutions(1.0, &Quiet)?;
/// assert_eq!(solutions.len(), 4);
/// assert_eq!(solutions[0].verdict, SolutionVerdict::Accepted);
/// assert!((solutions[0].frequency_ratio_squared.re - 0.87425).abs() < 1e-5);
/// # Ok::<(), libration::perturbation::TruncatedSystemError>(())
/// ```
///
/// # References
/// B. Black and V. Vel, Am. J. Phys. **91**, 776 (2023), equations (18)–(24).
#[derive(Clone, Debug)]
pub struct TruncatedSystem {
    /// g₁, g₂, … over g₁, all that is known of the force.
    force: Vec<Rational>,
    harmonics: u32,
    /// The last power of x kept, odd, its coefficient not zero.
    degree: usize,
}

/// One solution of a truncated system.
#[derive(Clone, Debug, PartialEq)]
pub struct TruncatedSolution {
    /// a₁, a₃, a₅, ….
    pub amplitudes: Vec<Complex>,
    /// Δ² = (Ω/ω0)².
    pub frequency_ratio_squared: Complex,
    /// Residual of the equation of motion with the whole force that was given: the root
    /// of the mean of |Δ²x″ + g(x)/ω0²|² over a period, in the units of x.
    pub residual: f64,
    /// Verdict: accepted as the motion sought, or the reason for its rejection.
    pub verdict: SolutionVerdict,
}

impl TruncatedSystem {
    /// The largest number of solutions for a search.
    pub const MAX_SOLUTIONS: u64 = 2000;

    /// The system of a number of harmonics under the restoring force g(x) = g₁x + g₃x³ + …, given by g₁, g₂ = 0,
    /// g₃, …, and cut off after x^degree. What is given beyond the degree serves for the residual only.
    ///
    /// # Errors
    /// When g₁ is not positive, an even coefficient is not zero, there is no harmonic, nothing beyond the linear
    /// term is kept, or there are more than [`MAX_SOLUTIONS`](Self::MAX_SOLUTIONS) solutions.
    pub fn new(
        restoring_force: &[Rational],
        harmonics: u32,
        degree: usize,
    ) -> Result<Self, TruncatedSystemError> {
        let force = over_linear_term(restoring_force).ok_or(TruncatedSystemError::NotRestoring)?;
        let mut powers = (1..=force.len()).filter(|power| !force[power - 1].is_zero());
        if let Some(power) = powers.clone().find(|power| power.is_multiple_of(2)) {
            return Err(TruncatedSystemError::EvenTerm { power });
        }
        let last = powers.rfind(|power| (3..=degree).contains(power));
        let degree = last.ok_or(TruncatedSystemError::Linear { degree })?;
        match number_of_solutions(harmonics, degree) {
            Some(1..=Self::MAX_SOLUTIONS) => Ok(Self { force, harmonics, degree }),
            _ => Err(TruncatedSystemError::Size { harmonics, degree }),
        }
    }

    /// The equations besides a₁ + a₃ + … = amplitude: polynomials in a1, a3, … and Delta that must vanish, with
    /// integer coefficients. If the first has a1 in every term, as with two harmonics and a cubic force, it is
    /// divided by it, which removes the solutions with a₁ = 0.
    #[must_use]
    pub fn conditions(&self) -> Vec<Polynomial> {
        let force = self.force_of_harmonics();
        let projection = |n: u32| {
            let square = Rational::from(i64::from(n) * i64::from(n));
            let inertia = (Polynomial::variable("Delta").pow(2) * amplitude(n)).scaled(&square);
            let left = inertia - COSINES.harmonic(&force, n as usize).cosine;
            left.divide_exactly(&Polynomial::variable("a1")).unwrap_or(left).primitive()
        };
        self.numbers().map(projection).collect()
    }

    /// Number of solutions, including complex ones and those with a₁ = 0, counted with their multiplicity:
    /// 1 + d + d² + … with as many terms as harmonics, where d is the degree of the force.
    ///
    /// This is the number of isolated solutions of the condition that two vectors be parallel, here (a₁, 9a₃, 25a₅, …) and the
    /// projections of the force.
    #[must_use]
    pub fn number_of_solutions(&self) -> u64 {
        number_of_solutions(self.harmonics, self.degree).unwrap_or(u64::MAX)
    }

    /// All solutions for an amplitude: the accepted one first, then by verdict, and by residual.
    ///
    /// # Accuracy About 1e-12 of their size if they are well separated, half the digits if two nearly
    /// coincide.
    ///
    /// # Errors
    /// When the amplitude is not positive and finite, or solutions are missing after all attempts, as happens
    /// where some coincide.
    /// [`TruncatedSystemError::Interrupted`] if the call is cancelled.
    pub fn solutions(
        &self,
        amplitude: f64,
        progress: &dyn Progress,
    ) -> Result<Vec<TruncatedSolution>, TruncatedSystemError> {
        if !(amplitude > 0.0 && amplitude < f64::INFINITY) {
            return Err(TruncatedSystemError::Amplitude { amplitude });
        }
        let equations = Collocation::new(self.harmonics, &self.force[..self.degree]);
        let expected = usize::try_from(self.number_of_solutions()).unwrap_or(usize::MAX);
        let roots = tracking::all_roots(&equations, amplitude, expected, &Watch::new(progress))?;
        if roots.len() < expected {
            return Err(TruncatedSystemError::Missing { found: roots.len(), expected });
        }
        let whole = Collocation::for_residuals(self.harmonics, &self.force);
        Ok(verdict::judged(&equations, &whole, amplitude, roots))
    }

    /// g(x)/ω0² of the sum of harmonics, cut off, as a sum of harmonics.
    fn force_of_harmonics(&self) -> Cosines {
        let x = cosines(self.numbers().map(|n| (n, amplitude(n))));
        // Horner's scheme.
        self.force[..self.degree].iter().rev().fold(COSINES.zero(), |sum, factor| {
            let factor = cosines([(0, Polynomial::constant(factor.clone()))]);
            COSINES.multiply(&COSINES.add(&sum, &factor), &x)
        })
    }

    /// 1, 3, 5, ….
    fn numbers(&self) -> impl Iterator<Item = u32> {
        (1..).step_by(2).take(self.harmonics as usize)
    }
}

fn number_of_solutions(harmonics: u32, degree: usize) -> Option<u64> {
    let degree = u64::try_from(degree).ok()?;
    // Beyond 64 terms it is None anyhow.
    (0..harmonics.min(65)).try_fold(0_u64, |sum, _| sum.checked_mul(degree)?.checked_add(1))
}

/// a₁, a₃, ….
fn amplitude(harmonic: u32) -> Polynomial {
    Polynomial::variable(Variable::indexed("a", harmonic))
}
