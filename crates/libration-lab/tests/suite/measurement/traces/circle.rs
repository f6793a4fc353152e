//! The circle of a pendulum's bob: pivot and length from positions.

use libration_lab::internals::measurement::traces::circle::{Circle, distances};
use nalgebra::DVector;

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
    let (circle, step) = (DVector::from_row_slice(&[10.0, 5.0, 2.0]), 1e-5);
    let jacobian = distances(&points, &circle).jacobian;
    for parameter in 0..3 {
        let mut change = DVector::zeros(3);
        change[parameter] = step;
        let residuals = |circle: DVector<f64>| distances(&points, &circle).residuals;
        let difference = residuals(&circle + &change) - residuals(&circle - &change);
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
            let differences = [moved(step, 0.0) - moved(-step, 0.0), moved(0.0, step) - moved(0.0, -step)];
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
