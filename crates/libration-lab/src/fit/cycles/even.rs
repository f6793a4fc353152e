//! An even function as a sum of Chebyshev polynomials of its square, for functions with more evaluations than the construction of the sum takes.

use crate::statistics::count;
use std::f64::consts::PI;

/// Number of polynomials: enough for the shapes of swings up to 2.5 rad; nearer to the top a sum may not do.
const TERMS: usize = 48;
/// Largest size of the last terms, relative to the largest one, with which the sum is accepted.
const LAST: f64 = 1e-12;

/// The sum, for arguments up to a largest one.
#[derive(Clone, Debug)]
pub struct Even {
    coefficients: Vec<f64>,
    largest: f64,
}

impl Even {
    /// Number of arguments above which the sum is worthwhile, since its construction evaluates the function 48 times.
    pub const WORTH: usize = 4 * TERMS;

    /// Expands the function up to the largest argument; `None` where it is not smooth enough.
    pub fn new(largest: f64, function: impl Fn(f64) -> f64) -> Option<Self> {
        // Cosines of all multiples of half the angle between nodes, over whole turns.
        let turn = 4 * TERMS;
        let cosines: Vec<f64> = (0..turn).map(|n| libm::cos(2.0 * PI * count(n) / count(turn))).collect();
        let node = |n: usize| function(largest * (0.5 * (1.0 + cosines[2 * n + 1])).sqrt());
        let values: Vec<f64> = (0..TERMS).map(node).collect();
        let coefficient = |k: usize| {
            let terms = values.iter().enumerate().map(|(n, value)| value * cosines[k * (2 * n + 1) % turn]);
            terms.sum::<f64>() * if k == 0 { 1.0 } else { 2.0 } / count(TERMS)
        };
        let coefficients: Vec<f64> = (0..TERMS).map(coefficient).collect();
        let size = coefficients.iter().fold(0.0, |size: f64, c| size.max(c.abs()));
        let is_small = |c: &f64| c.abs() <= LAST * size;
        coefficients[TERMS - 4..].iter().all(is_small).then_some(Self { coefficients, largest })
    }

    /// The value at `x`; `None` beyond the largest argument.
    pub fn at(&self, x: f64) -> Option<f64> {
        if x.abs() > self.largest {
            return None;
        }
        let part = x / self.largest;
        let t = 2.0 * part * part - 1.0;
        let step = |(a, b): (f64, f64), c: &f64| (c + 2.0 * t * a - b, a);
        let (a, b) = self.coefficients[1..].iter().rev().fold((0.0, 0.0), step);
        Some(self.coefficients[0] + t * a - b)
    }
}
