//! The circle of a pendulum's bob: pivot and length from positions.
//!
//! A geometric fit, which minimises the mean square distance from the circle, begins at an algebraic circle through the points. A short arc
//! determines its centre poorly, so the uncertainty of the centre is part of the result.
//!
//! # References
//! I. Kåsa, IEEE Trans. Instrum. Meas. 25, 8–14 (1976), for the algebraic circle.

use crate::statistics::levenberg_marquardt::{Effort, Linearised, minimum};
use crate::statistics::{Design, ROUNDING, count, least_squares};
use nalgebra::{DMatrix, DVector};

/// A circle fitted to points, in their unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Horizontal position of the centre.
    pub x: f64,
    /// Vertical position of the centre.
    pub y: f64,
    /// The length of the pendulum.
    pub radius: f64,
    /// Root mean square of the distances of the points from the circle.
    pub scatter: f64,
    /// One standard deviation of the radius, if the distances are independent.
    pub radius_uncertainty: f64,
    /// Covariance of the centre, with the same scale.
    pub covariance: [[f64; 2]; 2],
}

/// Distances are exact to their rounding errors.
const EFFORT: Effort = Effort { tolerance: 1e-14, patience: 100 };

impl Circle {
    /// The circle of the best fit to these points; `None` for fewer than three points, or points on a line.
    pub fn fit(points: &[(f64, f64)]) -> Option<Self> {
        let (centre, size) = centre_and_size(points)?;
        // In units of their own size, about their own middle, nothing overflows or cancels.
        let scaled: Vec<_> =
            points.iter().map(|(x, y)| ((x - centre.0) / size, (y - centre.1) / size)).collect();
        let start = algebraic(&scaled)?;
        let solution = minimum(start, EFFORT, |circle| Ok(distances(&scaled, circle))).ok()?;
        let Linearised { residuals, jacobian } = solution.converged.then_some(solution.linearised)?;
        let (squares, freedom) = (residuals.norm_squared(), points.len().checked_sub(3)?.max(1));
        let covariance = Design::new(&jacobian, ROUNDING).ok()?.covariance() * (squares / count(freedom));
        let [x, y, radius] = [solution.parameters[0], solution.parameters[1], solution.parameters[2]];
        let circle = Self {
            x: centre.0 + size * x,
            y: centre.1 + size * y,
            radius: size * radius.abs(),
            scatter: size * (squares / count(points.len())).sqrt(),
            radius_uncertainty: size * covariance[(2, 2)].sqrt(),
            covariance: [0, 1].map(|i| [0, 1].map(|j| size * size * covariance[(i, j)])),
        };
        [circle.x, circle.y, circle.radius, circle.radius_uncertainty]
            .iter()
            .all(|value| value.is_finite())
            .then_some(circle)
    }

    /// The circle about a known pivot.
    pub(super) fn about((x, y): (f64, f64), points: &[(f64, f64)]) -> Self {
        let distances: Vec<f64> = points.iter().map(|point| libm::hypot(point.0 - x, point.1 - y)).collect();
        let radius = distances.iter().sum::<f64>() / count(points.len());
        let square = distances.iter().map(|distance| (distance - radius) * (distance - radius)).sum::<f64>();
        let scatter = (square / count(points.len())).sqrt();
        Self { x, y, radius, scatter, radius_uncertainty: 0.0, covariance: [[0.0; 2]; 2] }
    }

    /// Returns `true` if larger y is further down: the bob is fastest at the bottom.
    pub(super) fn y_is_down(&self, points: &[(f64, f64)]) -> bool {
        let weighted = points.windows(2).map(|pair| {
            let (dx, dy) = (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1);
            (dx * dx + dy * dy) * (0.5 * (pair[0].1 + pair[1].1) - self.y)
        });
        weighted.sum::<f64>() > 0.0
    }

    /// The angle of a point from the downward vertical, growing with x.
    pub fn angle_at(&self, (x, y): (f64, f64), y_is_down: bool) -> f64 {
        let below = if y_is_down { y - self.y } else { self.y - y };
        libm::atan2(x - self.x, below)
    }

    /// Derivatives of that angle with respect to the centre.
    pub fn derivatives_at(&self, (x, y): (f64, f64), y_is_down: bool) -> [f64; 2] {
        let (dx, dy) = (x - self.x, y - self.y);
        let square = (dx * dx + dy * dy).max(f64::MIN_POSITIVE);
        if y_is_down { [-dy / square, dx / square] } else { [dy / square, -dx / square] }
    }
}

fn centre_and_size(points: &[(f64, f64)]) -> Option<((f64, f64), f64)> {
    let n = count(points.len());
    let (x, y) = points.iter().fold((0.0, 0.0), |sum, point| (sum.0 + point.0 / n, sum.1 + point.1 / n));
    let size = points.iter().map(|point| libm::hypot(point.0 - x, point.1 - y)).fold(0.0, f64::max);
    (points.len() >= 3 && size > 0.0 && size.is_finite()).then_some(((x, y), size))
}

/// x² + y² = 2ax + 2by + c in the least-squares sense: x, y and radius.
fn algebraic(points: &[(f64, f64)]) -> Option<DVector<f64>> {
    let entry = |i: usize, k: usize| [2.0 * points[i].0, 2.0 * points[i].1, 1.0][k];
    let matrix = DMatrix::from_fn(points.len(), 3, entry);
    let squares =
        DVector::from_fn(points.len(), |i, _| points[i].0 * points[i].0 + points[i].1 * points[i].1);
    let mut circle = least_squares(&matrix, &squares).ok()?.coefficients;
    circle[2] = (circle[2] + circle[0] * circle[0] + circle[1] * circle[1]).sqrt();
    circle[2].is_finite().then_some(circle)
}

/// The distances of points from a circle.
pub fn distances(points: &[(f64, f64)], circle: &DVector<f64>) -> Linearised {
    let from_centre = |i: usize| {
        let (dx, dy) = (points[i].0 - circle[0], points[i].1 - circle[1]);
        (dx, dy, libm::hypot(dx, dy))
    };
    let derivative = |i: usize, k: usize| {
        let (dx, dy, distance) = from_centre(i);
        let distance = distance.max(f64::MIN_POSITIVE);
        [-dx / distance, -dy / distance, -1.0][k]
    };
    Linearised {
        residuals: DVector::from_fn(points.len(), |i, _| from_centre(i).2 - circle[2]),
        jacobian: DMatrix::from_fn(points.len(), 3, derivative),
    }
}
