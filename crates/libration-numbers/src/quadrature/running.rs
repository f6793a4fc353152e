//! Integrals up to each node of Gauss's rule.

use super::gauss::{LEGENDRE, NODES};
use libration_kernels::elementary::count;

/// Number of nodes.
pub const POINTS: usize = 2 * NODES.len();

/// The nodes of Gauss's rule on (0, 1), in ascending order.
pub fn points() -> [f64; POINTS] {
    std::array::from_fn(|point| 0.5 + 0.5 * signed(point).0)
}

/// A node on (−1, 1), its weight, and Legendre's polynomials at the node.
fn signed(point: usize) -> (f64, f64, [f64; POINTS]) {
    let half = NODES.len();
    match point.checked_sub(half) {
        Some(index) => (NODES[index].0, NODES[index].1, LEGENDRE[index]),
        None => {
            let index = half - 1 - point;
            let mirrored =
                |degree: usize| LEGENDRE[index][degree] * if degree.is_multiple_of(2) { 1.0 } else { -1.0 };
            (-NODES[index].0, NODES[index].1, std::array::from_fn(mirrored))
        }
    }
}

/// The integrals from zero to each of [`points`], and to one, of the polynomial with these values at the nodes.
pub fn running_integrals(values: &[f64; POINTS]) -> ([f64; POINTS], f64) {
    let mut coefficients = [0.0; POINTS];
    for (point, value) in values.iter().enumerate() {
        let (_, weight, legendre) = signed(point);
        for (coefficient, legendre) in coefficients.iter_mut().zip(legendre) {
            *coefficient += weight * legendre * value;
        }
    }
    // The n-th coefficient is (2n + 1)/2 times this sum, and the integral of Pₙ from −1 is (Pₙ₊₁ − Pₙ₋₁)/(2n + 1).
    let upto = |point: usize| {
        let (x, _, legendre) = signed(point);
        let last = count(POINTS - 1);
        let beyond =
            ((2.0 * last + 1.0) * x * legendre[POINTS - 1] - last * legendre[POINTS - 2]) / (last + 1.0);
        let next = |n: usize| legendre.get(n + 1).copied().unwrap_or(beyond);
        let before = |n: usize| if n == 0 { -1.0 } else { legendre[n - 1] };
        let terms = coefficients.iter().enumerate();
        terms.map(|(n, coefficient)| 0.25 * coefficient * (next(n) - before(n))).sum()
    };
    (std::array::from_fn(upto), 0.5 * coefficients[0])
}
