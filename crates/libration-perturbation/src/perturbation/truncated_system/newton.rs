//! Newton's method for the truncated system: unknowns a₁, a₃, … and Δ².

use super::collocation::{Collocation, harmonic_squared};
use libration_numbers::algebra::Complex;
use libration_numbers::internals::linear::solve_complex;

/// The root near a point, by Newton's method on the equations themselves.
pub(super) fn refine(equations: &Collocation, amplitude: f64, near: Vec<Complex>) -> Option<Vec<Complex>> {
    let end = |z: &[Complex]| target(equations, amplitude, z);
    (0..3).try_fold(near, |z, _| newton(&end(&z), z).map(|(next, _)| next))
}

/// Values of the equations at a point, and their derivatives.
pub(super) struct Linearization {
    pub(super) values: Vec<Complex>,
    /// A row for each value.
    pub(super) derivatives: Vec<Vec<Complex>>,
}

/// The equations to be solved: −n²Δ²aₙ + gₙ = 0 and Σ aₙ = amplitude.
pub(super) fn target(equations: &Collocation, amplitude: f64, z: &[Complex]) -> Linearization {
    let k = equations.harmonics();
    let force = equations.projections(&z[..k]);
    let mut derivatives = force.derivatives;
    let mut values = force.values;
    for i in 0..k {
        let square = harmonic_squared(i);
        values[i] = values[i] - (z[k] * z[i]).scaled(square);
        derivatives[i][i] = derivatives[i][i] - z[k].scaled(square);
        derivatives[i].push(-z[i].scaled(square));
    }
    values.push(z[..k].iter().copied().sum::<Complex>() - Complex::from(amplitude));
    derivatives.push((0..=k).map(|j| Complex::from(f64::from(u8::from(j < k)))).collect());
    Linearization { values, derivatives }
}

/// One Newton step, and its length relative to the size of the point; `None` where the equations are singular.
pub(super) fn newton(at: &Linearization, z: Vec<Complex>) -> Option<(Vec<Complex>, f64)> {
    let step = solve_complex(&at.derivatives, &at.values)?;
    let length = norm(&step) / norm(&z);
    Some((z.iter().zip(&step).map(|(a, b)| *a - *b).collect(), length))
        .filter(|(_, length)| length.is_finite())
}

fn norm(z: &[Complex]) -> f64 {
    z.iter().map(|a| a.abs()).fold(0.0, f64::max)
}
