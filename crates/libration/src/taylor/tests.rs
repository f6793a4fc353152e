//! The order of the method.

use super::System;
use super::expander::{Expander, Surroundings};
use crate::pendulum::Pendulum;
use crate::quantity::Angle;

/// The larger error of angle and velocity after three seconds in so many equal steps.
fn error_of(steps: u32, order: usize) -> f64 {
    let system = System::new(&"theta'' + sin(theta) = 0".parse().unwrap()).unwrap();
    let expander = Expander::new(&system, order);
    let mut block = expander.block::<1>();
    block.start(0, 0.0, &[1.0, 0.5]);
    let surroundings = Surroundings { parameters: vec![], signs: vec![], sticks: vec![] };
    for n in 1..=steps {
        expander.expand(&mut block, &surroundings);
        block.end = [3.0 * f64::from(n) / f64::from(steps)];
        let ends: Vec<_> = (0..2).map(|number| block.ends(number)).collect();
        block.begin_at_end(&ends, &[1.0]);
    }
    let state = block.step(0).state_at(3.0);
    let start = Angle::from_radians(1.0).unwrap();
    let exact = Pendulum::from_angular_frequency(1.0).unwrap().launched(start, 0.5).unwrap().state_at(3.0);
    (state[0] - exact.angle).abs().max((state[1] - exact.velocity).abs())
}

#[test]
fn the_measured_order_is_the_nominal_one() {
    for (order, nominal) in [(4, 4.0), (6, 6.0), (8, 8.0), (10, 10.0)] {
        let slope = libm::log2(error_of(12, order) / error_of(24, order));
        assert!((slope - nominal).abs() < 0.3, "order {order}: the error grows as h^{slope}");
    }
}
