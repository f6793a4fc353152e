//! The shape of a swing without damping, which a measured one has locally: the angle, or the angular velocity, between
//! two of its zeros.

use std::f64::consts::{FRAC_PI_2, PI};

use libration_lab::internals::fit::cycles::even::Even;
use libration_lab::internals::fit::cycles::shape::{Shape, amplitude_of_velocity, often, slope_of_amplitude};
use libration_lab::measurement::Observable;

#[test]
fn the_way_back_from_the_shape_is_where_it_came_from() {
    for observable in [Observable::Angle, Observable::AngularVelocity] {
        for amplitude in [0.01, 1.0, 2.5, 3.1] {
            let shape = Shape::new(observable, amplitude);
            for part in [-0.9, -0.3, 0.0, 0.2, 0.6] {
                let value = shape.near_extreme(part);
                // Distances from a zero and from the extreme add up to a quarter.
                let back = 1.0 - shape.time_since_zero(value);
                assert!((back - f64::abs(part)).abs() < 1e-9, "{observable:?} {amplitude} {part}: {back}");
            }
        }
    }
}

/// Fewer evaluations than make a sum worthwhile, and as many, for all amplitudes, including those without a sum.
#[test]
fn what_is_asked_for_often_is_the_same() {
    for observable in [Observable::Angle, Observable::AngularVelocity] {
        for amplitude in [1e-3, 0.5, 2.5, 3.1, 3.13] {
            let shape = Shape::new(observable, amplitude);
            for times in [1, Even::WORTH - 1, Even::WORTH, 10_000] {
                let near_extreme = shape.near_extreme_for(times, 0.75);
                let time_since_zero = shape.time_since_zero_for(times);
                let slope = shape.slope_near_zero_for(times, 0.1);
                for part in [-1.2, -0.95, -0.9, -0.5, -0.01, 0.01, 0.3, 0.75, 0.89, 0.91, 1.0] {
                    let exact = shape.slope_of_time(shape.near_extreme((1.0 - f64::abs(part)).max(0.1)));
                    for (computed, exact) in [
                        (near_extreme(part), shape.near_extreme(part)),
                        (time_since_zero(part), shape.time_since_zero(part)),
                        (slope(part), exact),
                    ] {
                        assert!(
                            (computed - exact).abs() < 1e-11 * (1.0 + exact.abs()),
                            "{amplitude} {times} {part}: {computed} {exact}"
                        );
                    }
                }
            }
        }
    }
    assert!(often(Even::WORTH, 0.75, |part| Shape::new(Observable::Angle, 2.5).near_extreme(part)).is_some());
}

#[test]
fn slopes_and_curvatures_are_derivatives() {
    for observable in [Observable::Angle, Observable::AngularVelocity] {
        let shape = Shape::new(observable, 2.0);
        let step = 1e-4;
        let slope = (shape.time_since_zero(0.5 + step) - shape.time_since_zero(0.5 - step)) / (2.0 * step);
        assert!((slope / shape.slope_of_time(0.5) - 1.0).abs() < 1e-6, "{observable:?}");
        let curvature = 2.0 * (1.0 - shape.near_extreme(step)) / (step * step);
        assert!((curvature / shape.curvature() - 1.0).abs() < 1e-5, "{observable:?}");
    }
}

#[test]
fn the_fastest_velocity_tells_the_amplitude() {
    let omega0 = 3.0;
    let amplitude = amplitude_of_velocity(2.0 * omega0 * libm::sin(0.7), omega0).unwrap();
    assert!((amplitude - 1.4).abs() < 1e-14);
    assert_eq!(amplitude_of_velocity(2.0 * omega0, omega0), None);
    assert!((slope_of_amplitude(FRAC_PI_2, omega0) - 1.0 / (omega0 * libm::cos(PI / 4.0))).abs() < 1e-15);
}
