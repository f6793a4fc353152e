//! The circle of a pendulum's bob: pivot and length from positions.
//!
//! An algebraic circle through the points is where a geometric fit begins, which makes the distances from the circle least in the
//! mean square. A short arc says little about its centre, so the uncertainty of the centre comes with it.
//!
//! # References
//! I. Kåsa, IEEE Trans. Instrum. Meas. 25, 8–14 (1976), for the algebraic circle.

use crate::statistics::count;
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::storage::Owned;
use nalgebra::{Dyn, Matrix3, OMatrix, OVector, U3, Vector3};

/// A circle fitted to points, in their unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Circle {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) radius: f64,
    /// Root mean square of the distances of the points from the circle.
    pub(super) scatter: f64,
    /// One standard deviation of the radius, if the distances are independent.
    pub(super) radius_uncertainty: f64,
    /// Of the centre, likewise.
    pub(super) covariance: [[f64; 2]; 2],
}

impl Circle {
    /// The circle that fits these points best; none for fewer than three points, or points on a line.
    pub(super) fn fit(points: &[(f64, f64)]) -> Option<Self> {
        let (centre, size) = centre_and_size(points)?;
        // In units of their own size, about their own middle, nothing overflows or cancels.
        let scaled: Vec<_> =
            points.iter().map(|(x, y)| ((x - centre.0) / size, (y - centre.1) / size)).collect();
        let start = algebraic(&scaled)?;
        let (problem, report) =
            LevenbergMarquardt::new().minimize(Distances { points: &scaled, circle: start });
        let fitted = report.termination.was_successful().then_some(problem)?;
        let freedom = (points.len().checked_sub(3)?).max(1);
        let variance = 2.0 * report.objective_function / count(freedom);
        let jacobian = fitted.jacobian()?;
        let covariance = (jacobian.transpose() * jacobian).try_inverse()? * variance;
        let [x, y, radius] = fitted.circle.into();
        let circle = Self {
            x: centre.0 + size * x,
            y: centre.1 + size * y,
            radius: size * radius.abs(),
            scatter: size * (2.0 * report.objective_function / count(points.len())).sqrt(),
            radius_uncertainty: size * covariance[(2, 2)].sqrt(),
            covariance: [0, 1].map(|i| [0, 1].map(|j| size * size * covariance[(i, j)])),
        };
        [circle.x, circle.y, circle.radius, circle.radius_uncertainty]
            .iter()
            .all(|it| it.is_finite())
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

    /// Whether larger y is further down: the bob is fastest at the bottom.
    pub(super) fn y_is_down(&self, points: &[(f64, f64)]) -> bool {
        let weighted = points.windows(2).map(|pair| {
            let (dx, dy) = (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1);
            (dx * dx + dy * dy) * (0.5 * (pair[0].1 + pair[1].1) - self.y)
        });
        weighted.sum::<f64>() > 0.0
    }

    /// The angle of a point from the downward vertical, growing with x.
    pub(super) fn angle_at(&self, (x, y): (f64, f64), y_is_down: bool) -> f64 {
        let below = if y_is_down { y - self.y } else { self.y - y };
        libm::atan2(x - self.x, below)
    }

    /// What that angle changes by with the centre.
    pub(super) fn derivatives_at(&self, (x, y): (f64, f64), y_is_down: bool) -> [f64; 2] {
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

/// x² + y² = 2ax + 2by + c in the least-squares sense.
fn algebraic(points: &[(f64, f64)]) -> Option<Vector3<f64>> {
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for &(x, y) in points {
        let row = Vector3::new(2.0 * x, 2.0 * y, 1.0);
        matrix += row * row.transpose();
        right += row * (x * x + y * y);
    }
    let solution = matrix.try_inverse()? * right;
    let (x, y) = (solution[0], solution[1]);
    let radius = (solution[2] + x * x + y * y).sqrt();
    radius.is_finite().then(|| Vector3::new(x, y, radius))
}

/// The distances of points from a circle.
struct Distances<'a> {
    points: &'a [(f64, f64)],
    /// x, y, radius
    circle: Vector3<f64>,
}

impl Distances<'_> {
    fn each(&self) -> impl Iterator<Item = (f64, f64, f64)> {
        let (x, y) = (self.circle[0], self.circle[1]);
        self.points.iter().map(move |point| (point.0 - x, point.1 - y, libm::hypot(point.0 - x, point.1 - y)))
    }
}

impl LeastSquaresProblem<f64, Dyn, U3> for Distances<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, U3>;
    type ParameterStorage = Owned<f64, U3>;

    fn set_params(&mut self, circle: &Vector3<f64>) {
        self.circle = *circle;
    }

    fn params(&self) -> Vector3<f64> {
        self.circle
    }

    fn residuals(&self) -> Option<OVector<f64, Dyn>> {
        let radius = self.circle[2];
        Some(OVector::<f64, Dyn>::from_iterator(
            self.points.len(),
            self.each().map(|(_, _, distance)| distance - radius),
        ))
    }

    fn jacobian(&self) -> Option<OMatrix<f64, Dyn, U3>> {
        let mut jacobian = OMatrix::<f64, Dyn, U3>::zeros(self.points.len());
        for (mut row, (dx, dy, distance)) in jacobian.row_iter_mut().zip(self.each()) {
            let distance = distance.max(f64::MIN_POSITIVE);
            (row[0], row[1], row[2]) = (-dx / distance, -dy / distance, -1.0);
        }
        Some(jacobian)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An arc of a circle of radius 2 about (10, 5), with a ripple across it.
    fn arc(half: f64, ripple: f64) -> Vec<(f64, f64)> {
        let point = |n: i32| {
            let angle = half * f64::from(n) / 50.0;
            let radius = 2.0 + ripple * libm::sin(37.0 * f64::from(n));
            (10.0 + radius * libm::sin(angle), 5.0 - radius * libm::cos(angle))
        };
        (-50..=50).map(point).collect()
    }

    #[test]
    fn a_circle_is_found_from_an_arc_of_it() {
        for half in [0.1, 1.0, 3.0] {
            let circle = Circle::fit(&arc(half, 0.0)).unwrap();
            let error = (circle.x - 10.0).abs().max((circle.y - 5.0).abs()).max((circle.radius - 2.0).abs());
            assert!(error < 1e-9, "{half}: {circle:?}");
        }
    }

    #[test]
    fn the_uncertainty_of_the_radius_covers_its_error_and_grows_as_the_arc_shrinks() {
        let mut before = 0.0;
        for half in [1.5, 0.7, 0.3] {
            let circle = Circle::fit(&arc(half, 0.01)).unwrap();
            assert!((circle.radius - 2.0).abs() < 3.0 * circle.radius_uncertainty, "{half}: {circle:?}");
            assert!((circle.scatter / 0.00707 - 1.0).abs() < 0.1, "{circle:?}");
            assert!(circle.radius_uncertainty > before);
            before = circle.radius_uncertainty;
        }
    }

    #[test]
    fn the_derivatives_of_the_distances_are_the_limit_of_differences() {
        let points = [(12.5, 5.5), (9.0, 2.5), (10.0, 8.0)];
        let at = |circle: Vector3<f64>| Distances { points: &points, circle };
        let (circle, step) = (Vector3::new(10.0, 5.0, 2.0), 1e-5);
        let jacobian = at(circle).jacobian().unwrap();
        for parameter in 0..3 {
            let mut change = Vector3::zeros();
            change[parameter] = step;
            let difference =
                at(circle + change).residuals().unwrap() - at(circle - change).residuals().unwrap();
            for row in 0..points.len() {
                assert!((jacobian[(row, parameter)] - difference[row] / (2.0 * step)).abs() < 1e-8);
            }
        }
    }

    #[test]
    fn derivatives_by_the_centre_are_the_limit_of_differences() {
        let circle = Circle::fit(&arc(1.0, 0.0)).unwrap();
        for y_is_down in [false, true] {
            for point in [(10.3, 3.1), (8.5, 4.0), (11.9, 5.5)] {
                let step = 1e-5;
                let moved = |x: f64, y: f64| {
                    Circle { x: circle.x + x, y: circle.y + y, ..circle }.angle_at(point, y_is_down)
                };
                let differences =
                    [moved(step, 0.0) - moved(-step, 0.0), moved(0.0, step) - moved(0.0, -step)];
                for (difference, derivative) in
                    differences.into_iter().zip(circle.derivatives_at(point, y_is_down))
                {
                    assert!((difference / (2.0 * step) - derivative).abs() < 1e-8, "{point:?} {y_is_down}");
                }
            }
        }
    }

    #[test]
    fn points_on_a_line_have_no_circle() {
        let line: Vec<_> = (0..10).map(|n| (f64::from(n), 1.0)).collect();
        assert_eq!(Circle::fit(&line), None);
        assert_eq!(Circle::fit(&[(0.0, 0.0), (1.0, 0.0)]), None);
        assert_eq!(Circle::fit(&[(1.0, 1.0); 5]), None);
    }
}
