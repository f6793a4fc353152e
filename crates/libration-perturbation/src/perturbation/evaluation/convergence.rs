//! The radius of convergence of a series, and where its nearest singularity is, estimated from its coefficients.

use super::stride::stride;
use libration_kernels::elementary::count;
use libration_numbers::algebra::{BigFloat, Rational};

/// The radius of convergence of a power series Σ cₙxⁿ, estimated from its coefficients: no finite number of
/// coefficients decides it.
///
/// Ratios of coefficients of one sign, or of alternating signs, go to 1/ρ linearly in 1/n (Domb and Sykes); where the
/// signs follow another pattern, four successive coefficients tell the distance and the angle of a pair of
/// singularities (Mercer and Roberts); where neither fits, there are the roots |cₙ|^(1/n).
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::perturbation::{Convergence, Singularity};
/// // 1/(1 − x/2)² = Σ (n + 1)(x/2)ⁿ.
/// let series: Vec<_> =
///     (0..20).map(|n| format!("{}/{}", n + 1, 1_u64 << n).parse().unwrap()).collect();
/// let estimate = Convergence::estimate(&series).unwrap();
/// assert!((estimate.radius - 2.0).abs() < 1e-9);
/// assert_eq!(estimate.singularity, Singularity::Positive);
/// ```
///
/// # References
/// C. Domb and M. F. Sykes, Proc. R. Soc. A **240**, 214 (1957); G. N. Mercer and A. J. Roberts, SIAM J. Appl. Math.
/// **50**, 1547 (1990), appendix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Convergence {
    /// The distance of the nearest singularity in x.
    pub radius: f64,
    /// The lower end of the range in which the estimates lie.
    pub at_least: f64,
    /// The upper end, infinite if the estimates do not exclude that the series converges everywhere.
    pub at_most: f64,
    /// The series has only each stride-th power.
    pub stride: usize,
    /// Position of the nearest singularity, in the plane of x^stride.
    pub singularity: Singularity,
}

/// The direction of the singularity that limits convergence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Singularity {
    /// A singularity at a positive value: all later coefficients have one sign.
    Positive,
    /// A singularity at a negative value: the signs alternate.
    Negative,
    /// A pair of conjugate values.
    Pair {
        /// The angle in radians, between 0 and π, of one of them from the positive real axis.
        angle: f64,
    },
    /// The coefficients do not tell.
    Unclear,
}

impl Convergence {
    /// The least number of coefficients that are not zero.
    pub const LEAST_COEFFICIENTS: usize = 8;

    /// The estimate from c₀, c₁, …; `None` when fewer than
    /// [`LEAST_COEFFICIENTS`](Self::LEAST_COEFFICIENTS) of them are not zero.
    #[must_use]
    pub fn estimate(coefficients: &[Rational]) -> Option<Self> {
        let present: Vec<usize> = (0..coefficients.len()).filter(|n| !coefficients[*n].is_zero()).collect();
        let first = *present.first()?;
        if present.len() < Self::LEAST_COEFFICIENTS {
            return None;
        }
        let stride = stride(present);
        let spread: Vec<Rational> = coefficients[first..].iter().step_by(stride).cloned().collect();
        let estimate = one_singularity(&spread).or_else(|| pair_of_singularities(&spread));
        let (inverse, singularity) = estimate.unwrap_or_else(|| (by_roots(&spread), Singularity::Unclear));
        Some(inverse.to_convergence(stride, singularity))
    }
}

/// 1/ρ and its uncertainty.
#[derive(Clone, Copy, Debug)]
struct Inverse {
    value: f64,
    uncertainty: f64,
}

impl Inverse {
    fn to_convergence(self, stride: usize, singularity: Singularity) -> Convergence {
        let root = |inverse: f64| libm::pow(inverse, -1.0 / count(stride));
        Convergence {
            radius: root(self.value),
            at_least: root(self.value + self.uncertainty),
            at_most: root(f64::max(self.value - self.uncertainty, 0.0)),
            stride,
            singularity,
        }
    }

    fn is_useful(self) -> bool {
        self.value > 0.0 && self.uncertainty < 0.5 * self.value
    }
}

/// A single singularity, from the signs of the later half of the coefficients and the ratios extrapolated to 1/n = 0, linearly and quadratically.
/// The uncertainty comes from the differences between these and from the preceding ones.
fn one_singularity(coefficients: &[Rational]) -> Option<(Inverse, Singularity)> {
    let end = coefficients.len() - 1;
    let ratio = |n: usize| Some(coefficients[n].checked_div(&coefficients[n - 1])?.to_f64());
    let later = (end / 2..=end).map(ratio).collect::<Option<Vec<f64>>>()?;
    let singularity = match later.iter().filter(|ratio| **ratio > 0.0).count() {
        0 => Singularity::Negative,
        positive if positive == later.len() => Singularity::Positive,
        _ => return None,
    };
    let weighted = |n: usize, power: f64| Some(libm::pow(count(n), power) * ratio(n)?.abs());
    let line = |n: usize| Some(weighted(n, 1.0)? - weighted(n - 1, 1.0)?);
    let parabola =
        |n: usize| Some(0.5 * (weighted(n, 2.0)? - 2.0 * weighted(n - 1, 2.0)? + weighted(n - 2, 2.0)?));
    let (curved, straight) = (parabola(end)?, line(end)?);
    let (curved_change, straight_change) =
        ((curved - parabola(end - 1)?).abs(), (straight - line(end - 1)?).abs());
    // Logarithms, and singularities next to the nearest one, spoil the parabola before the line.
    let (value, change) =
        if curved_change < straight_change { (curved, curved_change) } else { (straight, straight_change) };
    let uncertainty = 2.0 * f64::max((curved - straight).abs(), change);
    (value > 0.0).then_some((Inverse { value, uncertainty }, singularity))
}

/// A pair of singularities: the radius from cₙ₊₁cₙ₋₁ − cₙ² and the like, which then tend to powers of 1/ρ², and the angle from three
/// successive coefficients.
fn pair_of_singularities(coefficients: &[Rational]) -> Option<(Inverse, Singularity)> {
    let end = coefficients.len() - 1;
    let c = |n: usize| coefficients[n].clone();
    let determinant = |n: usize| c(n + 1) * c(n - 1) - c(n) * c(n);
    let estimate = |n: usize| {
        let square = determinant(n).checked_div(&determinant(n - 1))?.to_f64();
        let inverse = libm::sqrt(square);
        let before = c(n - 1).checked_div(&c(n))?.to_f64() * inverse;
        let after = c(n + 1).checked_div(&c(n))?.to_f64() / inverse;
        Some((1.0 / count(n), inverse, 0.5 * (before + after))).filter(|_| square > 0.0)
    };
    let estimates: Vec<(f64, f64, f64)> = (end / 2..end).filter_map(estimate).collect();
    // Where one pair decides, a determinant has the wrong sign at most now and then.
    if 4 * estimates.len() < 3 * (end - end / 2) {
        return None;
    }
    let inverses: Vec<(f64, f64)> = estimates.iter().map(|(x, inverse, _)| (*x, *inverse)).collect();
    let cosines: Vec<(f64, f64)> = estimates.iter().map(|(x, _, cosine)| (x * x, *cosine)).collect();
    let inverse = intercept(&inverses).filter(|inverse| inverse.is_useful())?;
    let cosine = intercept(&cosines)?.value;
    let angle = libm::acos(cosine.clamp(-1.0, 1.0));
    Some((inverse, Singularity::Pair { angle }))
}

/// The intercept at x = 0 of a straight line through points, by least squares; its uncertainty is that of a few standard
/// deviations, and of leaving out the half of the points farther off.
fn intercept(points: &[(f64, f64)]) -> Option<Inverse> {
    const LEAST: usize = 3;
    let (value, deviation) = line_at_zero(points).filter(|_| points.len() >= LEAST)?;
    let (nearer, _) = line_at_zero(&points[points.len() / 3..])?;
    Some(Inverse { value: nearer, uncertainty: 3.0 * deviation + (value - nearer).abs() })
}

/// The value at zero of the line of least squares, and the root mean square distance of the points from it.
fn line_at_zero(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / count(points.len());
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    let slope = mean(&|p| (p.0 - x) * (p.1 - y)) / mean(&|p| (p.0 - x) * (p.0 - x));
    let value = y - slope * x;
    let square = |p: &(f64, f64)| (p.1 - value - slope * p.0) * (p.1 - value - slope * p.0);
    Some((value, libm::sqrt(mean(&square)))).filter(|(value, deviation)| (value + deviation).is_finite())
}

/// The radius from |cₙ|^(1/n), whose upper limit is 1/ρ: the largest of the later third, and the spread.
fn by_roots(coefficients: &[Rational]) -> Inverse {
    let end = coefficients.len() - 1;
    let root = |n: usize| {
        let coefficient = BigFloat::from_rational(&coefficients[n], 64);
        libm::exp(coefficient.ln_magnitude() / count(n))
    };
    let largest = |from: usize, to: usize| (from..=to).map(root).fold(0.0, f64::max);
    let (earlier, later) = (largest(end / 3, 2 * end / 3), largest(2 * end / 3 + 1, end));
    Inverse { value: later, uncertainty: (later - earlier).abs() + 0.25 * later }
}
