//! Verdicts on the solutions of a truncated system: the motion sought, or the reason for a rejection.

use libration_numbers::internals::algebra::InOrder;
use std::fmt;

use super::TruncatedSolution;
use super::collocation::Collocation;
use super::newton::{newton, refine, target};
use super::tracking::Root;
use libration_numbers::algebra::Complex;

/// The verdict on a solution of a truncated system.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SolutionVerdict {
    /// The solution grows out of small oscillations: continued to amplitude 0 it has a₁ = amplitude and Δ = 1.
    Accepted,
    /// Real with a₁ = 0: a motion such as x = a₃ cos 3Ωt, whose frequency is not Ω but 3Ω.
    Overtone,
    /// Real, but not connected with small oscillations.
    OtherBranch,
    /// Real with Δ² ≤ 0: no oscillation.
    NoOscillation,
    /// Complex amplitudes or frequency.
    Complex,
}

/// Writes the verdict: `rejected: Δ² is not positive, so nothing oscillates`.
impl fmt::Display for SolutionVerdict {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Accepted => "accepted: grows out of small oscillations",
            Self::Overtone => "rejected: has no fundamental, so its frequency is a multiple of Ω",
            Self::OtherBranch => "rejected: not connected with small oscillations",
            Self::NoOscillation => "rejected: Δ² is not positive, so nothing oscillates",
            Self::Complex => "rejected: complex",
        })
    }
}

/// The solutions with their residuals and verdicts, sorted by verdict, then by residual.
pub(super) fn judged(
    equations: &Collocation,
    whole: &Collocation,
    amplitude: f64,
    roots: Vec<Root>,
) -> Vec<TruncatedSolution> {
    let sought = small_oscillation(equations, amplitude);
    let mut solutions: Vec<TruncatedSolution> = roots
        .into_iter()
        .map(|Root { amplitudes, frequency_ratio_squared }| TruncatedSolution {
            residual: whole.residual(&amplitudes, frequency_ratio_squared),
            verdict: verdict(&amplitudes, frequency_ratio_squared, sought.as_ref()),
            amplitudes,
            frequency_ratio_squared,
        })
        .collect();
    solutions.put_in_order(|a, b| a.verdict.cmp(&b.verdict).then(a.residual.total_cmp(&b.residual)));
    solutions
}

fn verdict(
    amplitudes: &[Complex],
    frequency_ratio_squared: Complex,
    sought: Option<&Root>,
) -> SolutionVerdict {
    let size = amplitudes.iter().map(|a| a.abs()).fold(0.0, f64::max);
    // Newton's method ends with rounding errors, enlarged near double solutions.
    let real = |z: Complex, size: f64| z.im.abs() <= 1e-9 * size;
    if !(amplitudes.iter().all(|a| real(*a, size))
        && real(frequency_ratio_squared, frequency_ratio_squared.abs()))
    {
        return SolutionVerdict::Complex;
    }
    if frequency_ratio_squared.re <= 0.0 {
        return SolutionVerdict::NoOscillation;
    }
    let near = |root: &Root| {
        let gap = amplitudes.iter().zip(&root.amplitudes).map(|(a, b)| (*a - *b).abs()).fold(0.0, f64::max);
        // Two results of Newton's method for one solution; solutions nearer to one another meet at a fold of the amplitude.
        gap <= 1e-8 * size
    };
    match amplitudes.first() {
        _ if sought.is_some_and(near) => SolutionVerdict::Accepted,
        Some(first) if first.abs() <= 1e-9 * size => SolutionVerdict::Overtone,
        _ => SolutionVerdict::OtherBranch,
    }
}

/// The solution with a₁ = amplitude, Δ = 1 at small amplitudes, followed up to this one; `None` if it ends before.
fn small_oscillation(equations: &Collocation, amplitude: f64) -> Option<Root> {
    /// Part of the amplitude: shorter steps are needed only where the solution ends.
    const SMALLEST_STEP: f64 = 1e-9;
    let mut z = vec![Complex::default(); equations.harmonics() + 1];
    (z[0], z[equations.harmonics()]) = (Complex::from(1.0), Complex::from(1.0));
    let (mut reached, mut step) = (0.0, 1.0 / 16.0);
    while reached < 1.0 {
        let next = f64::min(reached + step, 1.0);
        match corrected(&equations.in_units_of(next * amplitude), &z) {
            Some(arrived) => (reached, z, step) = (next, arrived, 1.5 * step),
            None => step *= 0.5,
        }
        if step < SMALLEST_STEP {
            return None;
        }
    }
    let k = equations.harmonics();
    let scaled = (0..=k).map(|i| if i < k { z[i].scaled(amplitude) } else { z[i] });
    Root::from_point(refine(equations, amplitude, scaled.collect())?)
}

/// The solution for amplitude 1 near the one before, if Newton's method gets there in short and shrinking steps.
fn corrected(equations: &Collocation, z: &[Complex]) -> Option<Vec<Complex>> {
    let (z, first) = newton(&target(equations, 1.0, z), z.to_vec())?;
    let (z, second) = newton(&target(equations, 1.0, &z), z)?;
    let (z, third) = newton(&target(equations, 1.0, &z), z)?;
    // Corrections shrink quadratically: by ten in the first round, or down to rounding.
    (first < 0.02 && second < 0.1 * first + 1e-12 && third < 1e-6).then_some(z)
}
