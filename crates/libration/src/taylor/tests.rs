//! The order of the steps.

use super::System;
use super::expander::Expander;
use super::step::Step;
use crate::double_double::DoubleDouble;
use crate::pendulum::Pendulum;
use crate::quantity::Angle;

/// The error of the angle after one step of some length.
fn error_of_step(order: u32, length: f64) -> f64 {
    let system = System::new(&"theta'' + sin(theta) = 0".parse().unwrap()).unwrap();
    let mut step = Step::new(2);
    step.begin(0.0, &[DoubleDouble::from(1.0), DoubleDouble::from(0.5)]);
    Expander::new(&system, order).expand(0.0, &[], &mut step.series).unwrap();
    let start = Angle::from_radians(1.0).unwrap();
    let exact = Pendulum::from_angular_frequency(1.0).unwrap().launched(start, 0.5).unwrap();
    (step.state_at(length)[0] - exact.state_at(length).angle).abs()
}

#[test]
fn the_measured_order_is_the_nominal_one() {
    for order in [6_u32, 8, 10, 12] {
        let (long, short) = (0.5, 0.4);
        let slope =
            libm::log(error_of_step(order, long) / error_of_step(order, short)) / libm::log(long / short);
        assert!((slope - f64::from(order + 1)).abs() < 0.5, "order {order}: the error grows as h^{slope}");
    }
}
