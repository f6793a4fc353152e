//! All roots of a polynomial at once, each with an error bound.

use crate::algebra::in_order::InOrder;
use std::f64::consts::TAU;

use crate::algebra::Complex;
use libration_kernels::elementary::count;

/// A root of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolynomialRoot {
    /// Position of the root.
    pub value: Complex,
    /// Distance from the value within which there are [`multiplicity`](Self::multiplicity) roots.
    pub error: f64,
    /// Number of roots, itself included, with which the root may coincide: more than one if error discs overlap.
    pub multiplicity: usize,
}

/// The roots of Σ cₙzⁿ, given c₀, c₁, …, by ascending magnitude. There are as many as the degree: roots that coincide, or may coincide, are
/// listed individually. A constant has none.
///
/// # Domain
/// Finite coefficients that are not all zero. Highest coefficients that are zero are ignored; lowest ones are exact roots at zero. With z in
/// units of the mean magnitude of the roots, no intermediate coefficient may be more than 1e290 times as large as the first or the last one.
/// `None` otherwise.
///
/// # Accuracy
/// [`PolynomialRoot::error`] is a bound for exactly these coefficients: a few rounding errors times the condition number of a simple root, and
/// for k coincident roots the k-th root of that. The bound is Smith's, including the rounding errors of Horner's scheme in the value of the
/// polynomial.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::roots::polynomial_roots;
/// // (z − 1)²(z + 3).
/// let roots = polynomial_roots(&[3.0, -5.0, 1.0, 1.0]).ok_or("out of range")?;
/// assert_eq!(roots.iter().map(|root| root.multiplicity).collect::<Vec<_>>(), [2, 2, 1]);
/// assert!((roots[2].value.re + 3.0).abs() <= roots[2].error && roots[2].error < 1e-13);
/// assert!((roots[0].value.re - 1.0).abs() <= roots[0].error && roots[0].error < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # References
/// O. Aberth, Math. Comp. 27, 339 (1973), doi:10.1090/S0025-5718-1973-0329236-7; initial positions: D. A. Bini, Numer. Algorithms 13, 179
/// (1996), doi:10.1007/BF02207694; bounds: B. T. Smith, J. ACM 17, 661 (1970), doi:10.1145/321607.321615.
#[must_use]
pub fn polynomial_roots(coefficients: &[f64]) -> Option<Vec<PolynomialRoot>> {
    let last = coefficients.iter().rposition(|c| *c != 0.0)?;
    let first = coefficients.iter().position(|c| *c != 0.0)?;
    if !coefficients.iter().all(|c| c.is_finite()) {
        return None;
    }
    let zero = PolynomialRoot { value: Complex::default(), error: 0.0, multiplicity: first };
    let mut roots = vec![zero; first];
    let balanced = Balanced::new(&coefficients[first..=last])?;
    let mut approximations = balanced.first_places();
    balanced.refine(&mut approximations);
    approximations.put_in_order(|a, b| a.abs().total_cmp(&b.abs()).then(a.im.total_cmp(&b.im)));
    roots.extend(balanced.with_errors(&approximations));
    Some(roots)
}

/// A polynomial in units in which the geometric mean of its roots and its largest coefficient are about one.
struct Balanced {
    coefficients: Vec<f64>,
    /// The unit of the roots, a power of two.
    log2_unit: i32,
}

impl Balanced {
    /// The scaled polynomial; `None` if its first or last coefficient is negligible compared with the others.
    fn new(coefficients: &[f64]) -> Option<Self> {
        let degree = coefficients.len() - 1;
        let logs: Vec<f64> = coefficients.iter().map(|c| libm::log2(c.abs())).collect();
        #[expect(clippy::cast_possible_truncation, reason = "logarithms of f64s are below 1100")]
        let log2_unit =
            if degree == 0 { 0 } else { libm::round((logs[0] - logs[degree]) / count(degree)) as i32 };
        let shifted = |k: usize| logs[k] + count(k) * f64::from(log2_unit);
        let largest = (0..=degree).map(shifted).fold(f64::NEG_INFINITY, f64::max);
        let coefficients: Vec<f64> = coefficients
            .iter()
            .enumerate()
            .map(|(k, c)| scaled_by_power(*c, count(k) * f64::from(log2_unit) - libm::floor(largest)))
            .collect();
        // Products with rounding errors of 1e-16 must not underflow.
        let smallest = coefficients[0].abs().min(coefficients[degree].abs());
        (smallest > 1e-290).then_some(Self { coefficients, log2_unit })
    }

    fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// Initial positions without symmetry, on circles whose radii follow from the upper convex hull of the logarithms of the coefficients.
    fn first_places(&self) -> Vec<Complex> {
        let logs = self.coefficients.iter().enumerate().map(|(k, c)| (count(k), libm::log2(c.abs())));
        let mut hull: Vec<(f64, f64)> = vec![];
        for point in logs.filter(|(_, log)| log.is_finite()) {
            while let [.., a, b] = hull[..]
                && (b.1 - a.1) * (point.0 - a.0) <= (point.1 - a.1) * (b.0 - a.0)
            {
                hull.pop();
            }
            hull.push(point);
        }
        let circles = hull.windows(2).flat_map(|edge| {
            let [(k, from), (l, to)] = [edge[0], edge[1]];
            let radius = libm::exp2((from - to) / (l - k));
            let number = std::iter::successors(Some(0.0), |j| Some(j + 1.0)).take_while(move |j| *j < l - k);
            number.map(move |j| Complex::unit(TAU * (j + 0.3) / (l - k) + k).scaled(radius))
        });
        circles.collect()
    }

    /// Moves all positions until the polynomial is zero there within rounding errors, for at most a fixed number of rounds.
    fn refine(&self, approximations: &mut [Complex]) {
        /// About ten rounds are usual; for k coincident roots each round covers 1/k of the remaining distance.
        const ENOUGH: usize = 200;
        let mut settled = vec![false; approximations.len()];
        for _ in 0..ENOUGH {
            for (k, settled) in settled.iter_mut().enumerate() {
                *settled = *settled || self.improve(approximations, k);
            }
            if settled.iter().all(|settled| *settled) {
                break;
            }
        }
    }

    /// One step for a root, Newton's method for the polynomial divided by the other roots' factors; returns `true` if it was the last one.
    fn improve(&self, approximations: &mut [Complex], k: usize) -> bool {
        let z = approximations[k];
        let Local { value, rounding, newton } = self.at(z);
        if value.abs() <= rounding {
            return true;
        }
        let others = approximations.iter().enumerate().filter(|(j, _)| *j != k);
        let repulsion: Complex = others.map(|(_, other)| ONE / (z - *other)).sum();
        let step = newton / (ONE - newton * repulsion);
        if !step.is_finite() {
            return false;
        }
        approximations[k] = z - step;
        step.abs() < f64::EPSILON * approximations[k].abs()
    }

    /// The values at z; outside the unit circle from the reversed polynomial, which does not overflow: p(z) = zⁿ·r(1/z).
    fn at(&self, z: Complex) -> Local {
        /// Rounding errors of a complex product (√5 units of 2⁻⁵³) and a sum, in each of n steps, with a margin as large again.
        const ROUNDINGS: f64 = 4.0;
        let n = count(self.degree());
        let inside = z.abs() <= 1.0;
        let w = if inside { z } else { ONE / z };
        let ((value, slope), size) = if inside {
            (value_and_slope(self.coefficients.iter().rev(), w), size_at(self.coefficients.iter().rev(), w))
        } else {
            (value_and_slope(self.coefficients.iter(), w), size_at(self.coefficients.iter(), w))
        };
        let newton = if inside { value / slope } else { z / (Complex::from(n) - w * slope / value) };
        Local { value, rounding: ROUNDINGS * (n + 1.0) * f64::EPSILON * size, newton }
    }

    /// Smith's discs with radius n·|p(z)|/|cₙ·Π(z − other)|: a group of k touching discs contains k roots.
    fn with_errors(&self, approximations: &[Complex]) -> Vec<PolynomialRoot> {
        let radii: Vec<f64> = (0..approximations.len()).map(|k| self.radius(approximations, k)).collect();
        let clusters = clusters(approximations, &radii);
        let root = |k: usize| {
            let cluster: Vec<usize> =
                (0..approximations.len()).filter(|j| clusters[*j] == clusters[k]).collect();
            let reach = cluster
                .iter()
                .map(|&j| (approximations[k] - approximations[j]).abs() + radii[j])
                .fold(0.0, f64::max);
            let value = if cluster.len() == 1 {
                real_if_it_must_be(approximations, &radii, k)
            } else {
                approximations[k]
            };
            // A disc about the real position to which the root was moved must contain the original disc.
            let error = reach + (value - approximations[k]).abs();
            PolynomialRoot {
                value: self.in_units(value),
                error: self.in_units(error.into()).re,
                multiplicity: cluster.len(),
            }
        };
        (0..approximations.len()).map(root).collect()
    }

    fn radius(&self, approximations: &[Complex], k: usize) -> f64 {
        let (z, n) = (approximations[k], count(self.degree()));
        let Local { value, rounding, .. } = self.at(z);
        let others = approximations.iter().enumerate().filter(|(j, _)| *j != k);
        // Positions that coincide count as being one last bit apart.
        let apart = others.map(|(_, other)| (z - *other).abs().max(f64::EPSILON * z.abs()));
        let product: f64 = apart.map(libm::log2).sum();
        let power = if z.abs() > 1.0 { n * libm::log2(z.abs()) } else { 0.0 };
        let leading = libm::log2(self.coefficients[self.degree()].abs());
        let log = libm::log2(n * (value.abs() + rounding)) + power - leading - product;
        // Rounding errors of logarithms up to 1e5 and of the differences.
        1.0001 * libm::exp2(log) + f64::EPSILON * z.abs()
    }

    fn in_units(&self, z: Complex) -> Complex {
        Complex::new(libm::ldexp(z.re, self.log2_unit), libm::ldexp(z.im, self.log2_unit))
    }
}

/// Values of a polynomial at a point.
struct Local {
    value: Complex,
    /// The rounding error of the value.
    rounding: f64,
    /// p/p′.
    newton: Complex,
}

const ONE: Complex = Complex::new(1.0, 0.0);

/// c·2ᵉ for exponents beyond those of `f64`.
fn scaled_by_power(c: f64, exponent: f64) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "beyond 5000 the result is zero")]
    let exponent = exponent.clamp(-5000.0, 5000.0) as i32;
    libm::ldexp(c, exponent)
}

/// The real part of a position whose disc reaches the real axis and is isolated in three times its radius: otherwise the conjugate would be a
/// second root there.
fn real_if_it_must_be(approximations: &[Complex], radii: &[f64], k: usize) -> Complex {
    let z = approximations[k];
    let apart = |j: usize| (z - approximations[j]).abs() > 3.0 * radii[k] + radii[j];
    let alone = (0..approximations.len()).all(|j| j == k || apart(j));
    if alone && z.im.abs() <= radii[k] { Complex::from(z.re) } else { z }
}

/// The cluster to which each disc belongs.
fn clusters(approximations: &[Complex], radii: &[f64]) -> Vec<usize> {
    let mut cluster: Vec<usize> = (0..approximations.len()).collect();
    for j in 0..approximations.len() {
        for k in 0..j {
            let touch =
                (approximations[j] - approximations[k]).abs() <= radii[j] + radii[k] || radii[j].is_nan();
            if touch && cluster[j] != cluster[k] {
                let (old, new) = (cluster[j], cluster[k]);
                cluster.iter_mut().filter(|label| **label == old).for_each(|label| *label = new);
            }
        }
    }
    cluster
}

/// Horner's scheme; the coefficient of the highest power comes first.
pub fn value_and_slope<'a>(coefficients: impl Iterator<Item = &'a f64>, z: Complex) -> (Complex, Complex) {
    let start = (Complex::default(), Complex::default());
    coefficients.fold(start, |(value, slope), coefficient| {
        (value * z + Complex::from(*coefficient), slope * z + value)
    })
}

/// The sum of the magnitudes of all terms.
fn size_at<'a>(coefficients: impl Iterator<Item = &'a f64>, z: Complex) -> f64 {
    coefficients.fold(0.0, |sum, coefficient| sum * z.abs() + coefficient.abs())
}
