//! Quadrature rules compared with known integrals.

mod kronrod;
mod running;

use libration::quadrature::{Integral, double_exponential, gauss, gauss_kronrod};

/// A function and its integral from 0 to 1.
type Case = (Box<dyn Fn(f64) -> f64>, f64);

/// Analytic functions with singularities at several distances.
fn analytic() -> Vec<Case> {
    let mut cases: Vec<Case> = vec![];
    for distance in [0.1, 0.3, 1.0, 3.0_f64] {
        cases.push((Box::new(move |x| 1.0 / (x + distance)), libm::log((1.0 + distance) / distance)));
        let square = distance * distance;
        let peak = 2.0 * libm::atan(0.5 / distance) / distance;
        cases.push((Box::new(move |x| 1.0 / ((x - 0.5) * (x - 0.5) + square)), peak));
    }
    for rate in [0.1, 1.0, 5.0, 20.0, 40.0_f64] {
        cases.push((Box::new(move |x| libm::exp(-rate * x)), -libm::expm1(-rate) / rate));
        cases.push((
            Box::new(move |x| libm::sin(rate * x + 0.3)),
            (libm::cos(0.3) - libm::cos(rate + 0.3)) / rate,
        ));
    }
    cases
}

fn kinked() -> Vec<Case> {
    let mut cases: Vec<Case> = vec![];
    for position in [0.1, 0.31, 0.5, 0.77_f64] {
        let kink = 0.5 * (position * position + (1.0 - position) * (1.0 - position));
        cases.push((Box::new(move |x| (x - position).abs()), kink));
        cases.push((Box::new(move |x| if x < position { 0.0 } else { 1.0 }), 1.0 - position));
    }
    for power in [-0.3, 0.3, 0.5, 1.5, 2.5_f64] {
        cases.push((Box::new(move |x| libm::pow(x, power)), 1.0 / (1.0 + power)));
    }
    cases
}

/// Asserts that the error is at most the estimate plus rounding; an integral without a value must have a large estimate.
fn assert_told(integral: Integral, exact: f64, case: usize) {
    if integral.value.is_nan() {
        return assert!(integral.error > 0.01 * exact.abs(), "{case}: {integral:?}");
    }
    let error = (integral.value - exact).abs();
    let rounding = 16.0 * f64::EPSILON * exact.abs().max(1.0);
    assert!(error <= integral.error + rounding, "{case}: {error:e} beside {integral:?}");
}

#[test]
fn every_rule_tells_what_it_misses() {
    for (case, (f, exact)) in analytic().into_iter().chain(kinked()).enumerate() {
        assert_told(gauss(&f), exact, case);
        assert_told(gauss_kronrod(&f), exact, case);
    }
    for (case, (f, exact)) in analytic().into_iter().enumerate() {
        assert_told(double_exponential(&f), exact, case);
    }
}

#[test]
fn what_is_smooth_is_known_to_be() {
    let smooth = |x: f64| libm::exp(-x);
    let exact = -libm::expm1(-1.0);
    for integral in [gauss(smooth), gauss_kronrod(smooth), double_exponential(smooth)] {
        assert!((integral.value - exact).abs() < 4e-16 && integral.error < 4e-16, "{integral:?}");
    }
}

/// Polynomials up to degree 31, for which Gauss's rule of 16 points is exact.
#[test]
fn polynomials_up_to_its_degree_are_exact() {
    for power in 0..=31 {
        let exact = 1.0 / f64::from(power + 1);
        let error = gauss(|x| libm::pow(x, f64::from(power))).value - exact;
        assert!(error.abs() < 3e-16, "{power}: {error:e}");
    }
    let next = gauss(|x| libm::pow(2.0 * x - 1.0, 32.0)).value;
    assert!((next - 1.0 / 33.0).abs() > 1e-10, "{next}");
}

#[test]
fn powers_at_an_end_are_analytic_to_the_double_exponential_rule() {
    for power in [-0.5, -0.2, 0.3, 0.5, 1.7] {
        let integral = double_exponential(|x| libm::pow(x, power));
        assert_told(integral, 1.0 / (1.0 + power), 0);
        assert!(power < 0.0 || integral.error < 1e-15, "{power}: {integral:?}");
    }
}
