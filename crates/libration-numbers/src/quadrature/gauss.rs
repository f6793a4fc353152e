//! Gauss's rule, for functions that are analytic well beyond the ends.

use super::Integral;

/// The positive nodes of Gauss's rule of 16 points on (−1, 1) with their weights, computed by mpmath.
pub(super) const NODES: [(f64, f64); 8] = [
    (0.095012509837637440185, 0.18945061045506849629),
    (0.28160355077925891323, 0.18260341504492358887),
    (0.45801677765722738634, 0.16915651939500253819),
    (0.61787624440264374845, 0.14959598881657673208),
    (0.7554044083550030339, 0.12462897125553387205),
    (0.86563120238783174388, 0.09515851168249278481),
    (0.94457502307323257608, 0.062253523938647892863),
    (0.9894009349916499326, 0.027152459411754094852),
];

/// Degrees of the Legendre coefficients that are compared with the last ones to measure how fast the coefficients fall: several neighbouring
/// degrees, because some coefficients vanish by chance or symmetry.
const EARLY: [usize; 4] = [4, 5, 6, 7];
const LATE: [usize; 4] = [12, 13, 14, 15];

/// Largest ratio of the late coefficients to the early ones at which 16 points resolve the function; next to a jump the ratio is larger.
const RESOLVED: f64 = 0.25;

/// Legendre's polynomials up to degree 15 at the nodes.
pub(super) const LEGENDRE: [[f64; 16]; 8] = {
    let mut values = [[1.0; 16]; 8];
    let mut node = 0;
    while node < 8 {
        values[node] = legendre(NODES[node].0);
        node += 1;
    }
    values
};

const fn legendre(x: f64) -> [f64; 16] {
    let mut values = [1.0; 16];
    values[1] = x;
    let (mut degree, mut n) = (2, 1.0);
    while degree < 16 {
        values[degree] = ((2.0 * n + 1.0) * x * values[degree - 1] - n * values[degree - 2]) / (n + 1.0);
        degree += 1;
        n += 1.0;
    }
    values
}

/// ∫₀¹ f(x) dx of a function that is analytic well beyond the ends, by Gauss's rule of 16 points, which is exact for polynomials up to degree
/// 31.
///
/// # Accuracy
/// `error` is estimated from the same values. The Legendre coefficients fall by some factor from degrees 4–7 to degrees 12–15; they fall by at
/// least this factor again up to degree 32, which the rule does not see. If they hardly fall, the error is unknown and `error` is ∫|f|. A peak
/// between two nodes is not detected.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quadrature::gauss;
/// let smooth = gauss(|x| x.exp());
/// assert!((smooth.value - (1.0_f64.exp() - 1.0)).abs() < 1e-15 && smooth.error < 1e-15);
/// let kinked = gauss(|x| (x - 0.3).abs());
/// assert!((kinked.value - 0.29).abs() < kinked.error);
/// ```
pub fn gauss(mut f: impl FnMut(f64) -> f64) -> Integral {
    let (mut sum, mut size) = (0.0, 0.0);
    let mut coefficients = [[0.0_f64; 4]; 2];
    for ((node, weight), legendre) in NODES.iter().zip(&LEGENDRE) {
        let (left, right) = (f(0.5 - 0.5 * node), f(0.5 + 0.5 * node));
        sum += weight * (left + right);
        size += weight * (left.abs() + right.abs());
        for (sums, degrees) in coefficients.iter_mut().zip([EARLY, LATE]) {
            for (sum, degree) in sums.iter_mut().zip(degrees) {
                let mirrored = if degree % 2 == 0 { right + left } else { right - left };
                *sum += weight * legendre[degree] * mirrored;
            }
        }
    }
    let [early, late] = coefficients.map(|sums| sums.iter().fold(0.0, |most: f64, sum| most.max(sum.abs())));
    // Coefficient 15 is 31/2 times its sum. The error from a kink is up to twice as large, wherever the kink is.
    let error = if late <= RESOLVED * early { 64.0 * late * (late / early) } else { 0.5 * size };
    Integral { value: 0.5 * sum, error: if late == 0.0 { 0.0 } else { error } }
}
