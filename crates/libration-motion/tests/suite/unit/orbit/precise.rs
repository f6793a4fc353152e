use libration::algebra::BigFloat;
use libration::internals::orbit::{Acceleration, Motion};
use libration::progress::Quiet;
use libration::taylor::System;
use libration_numbers::internals::progress::Watch;

/// The duration of a motion from rest to rest, and the position of the end.
fn half_period(equation: &str, position: &BigFloat) -> [BigFloat; 2] {
    let equation = equation.parse().unwrap();
    let (system, acceleration) = (System::new(&equation).unwrap(), Acceleration::new(&equation).unwrap());
    let half = Motion::new(&system, &acceleration.tape, 128, &Watch::new(&Quiet))
        .half_period(position, 0.0)
        .unwrap();
    [half.duration, half.end]
}

/// At the other end, −147.4, e^x is below the last of 128 bits, and the coefficients of a step that begins there are tiny.
#[test]
fn a_force_below_the_last_bit_where_a_step_begins_is_felt_where_it_grows() {
    let equation = "x'' = 1 - exp(x)";
    let [there, end] = half_period(equation, &BigFloat::from_integer(5, 128));
    let [back, start] = half_period(equation, &end);
    assert!((there.clone() - back).to_f64().abs() < 1e-30, "{there:?}");
    assert!((start.to_f64() - 5.0).abs() < 1e-15, "{start:?}");
    // The energy, e^x − x, is the same at both ends.
    let energy = libm::exp(5.0) - 5.0;
    assert!((libm::exp(end.to_f64()) - end.to_f64() - energy).abs() < 1e-12);
}

/// On the way to −2973 e^x falls to 1e-1291: the terms of the series are tiny, but grow up to the order by which x changes, which alone limits
/// the steps. With steps in proportion to 1/x the limit of 600 would be reached at −2000.
#[test]
fn steps_far_from_a_wall_are_as_long_as_near_it() {
    let [duration, end] = half_period("x'' = 1 - exp(x)", &BigFloat::from_integer(8, 128));
    let [half, energy] = [0.5 * 154.462_811_649_999_126, libm::exp(8.0) - 8.0];
    assert!((duration.to_f64() - half).abs() < 1e-13, "{duration:?}");
    assert!((end.to_f64() + energy).abs() < 1e-12, "{end:?}");
}
