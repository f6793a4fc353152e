//! The order of the method.

use super::System;
use super::expander::Expander;
use super::step::Step;
use crate::double_double::DoubleDouble;
use crate::pendulum::Pendulum;
use crate::quantity::Angle;

/// The larger error of angle and velocity after three seconds in so many equal steps.
fn error_of(steps: u32, order: u32) -> f64 {
    let system = System::new(&"theta'' + sin(theta) = 0".parse().unwrap()).unwrap();
    let mut expander = Expander::new(&system, order);
    let (mut step, mut state) = (Step::new(2), vec![DoubleDouble::from(1.0), DoubleDouble::from(0.5)]);
    for n in 0..steps {
        let time_of = |n: u32| 3.0 * f64::from(n) / f64::from(steps);
        step.begin(time_of(n), &state);
        expander.expand(time_of(n), &[], &mut step.series).unwrap();
        state = step.two_word_state_at(time_of(n + 1)).collect();
    }
    let start = Angle::from_radians(1.0).unwrap();
    let exact = Pendulum::from_angular_frequency(1.0).unwrap().launched(start, 0.5).unwrap().state_at(3.0);
    (state[0] - exact.angle).to_f64().abs().max((state[1] - exact.velocity).to_f64().abs())
}

#[test]
fn the_measured_order_is_the_nominal_one() {
    for order in [4, 6, 8, 10] {
        let slope = libm::log2(error_of(12, order) / error_of(24, order));
        assert!((slope - f64::from(order)).abs() < 0.3, "order {order}: the error grows as h^{slope}");
    }
}
