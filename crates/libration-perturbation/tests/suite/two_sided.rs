//! Forces with one power series above the equilibrium and another below, compared with the integral of the energy and with orbits.

use crate::typed::oscillator;
use libration::algebra::{LaurentPolynomial, Rational};
use libration::comparison::{ExactMotion, SeriesQuantity};
use libration::perturbation::{Certificate, Expansion, Gauge, Precision, expand, expand_with_pi};
use libration::progress::Quiet;
use libration::quadrature::double_exponential;
use libration::quantity::Displacement;
use libration_testing::sweep;
use std::f64::consts::PI;

fn with_pi(text: &str, order: usize, gauge: &Gauge) -> Expansion<LaurentPolynomial> {
    expand_with_pi(&oscillator(text), order, gauge, &Quiet).unwrap().unwrap_or_else(|| panic!("{text}"))
}

fn number(coefficient: &LaurentPolynomial) -> f64 {
    let term = |(factor, powers): (&Rational, Vec<_>)| {
        let power =
            powers.first().map_or(0.0, |power: &libration::algebra::LetterPower<'_>| power.exponent.to_f64());
        factor.to_f64() * libm::pow(PI, power)
    };
    coefficient.terms().map(term).sum()
}

fn value(series: &[f64], at: f64) -> f64 {
    series.iter().rev().fold(0.0, |sum, c| sum * at + c)
}

fn numbers(series: &[LaurentPolynomial]) -> Vec<f64> {
    series.iter().map(number).collect()
}

/// A quarter of the period of x″ = −V′(x) from a turning point at A > 0, by x = A(1 − y²): ∫ dx/√(2(V(A) − V(x))), where the work on the way
/// back is a formula without cancellation.
fn quarter(amplitude: f64, work: impl Fn(f64) -> f64) -> f64 {
    double_exponential(|y| 2.0 * amplitude * y / (2.0 * work(amplitude * y * y)).sqrt()).value
}

/// For x + x|x|: the work from A − d to A.
fn work_of_quadratic(a: f64, d: f64) -> f64 {
    d * (a - 0.5 * d) + d * (a * a - a * d + d * d / 3.0)
}

#[test]
fn the_first_coefficients_are_those_of_the_half_swing() {
    let expansion = with_pi("x'' + x + x*abs(x) = 0", 4, &Gauge::XMax);
    assert_eq!(expansion.frequency_ratio[1].to_string(), "4/(3*pi)");
    assert_eq!(expansion.certificate, Certificate::Quadrature);
    // T/T0 by the amplitude has no other power of π than 1/π.
    let period = with_pi("x'' + x + x*abs(x) = 0", 9, &Gauge::XMax).of_amplitude.unwrap().period_ratio;
    let powers = |polynomial: &LaurentPolynomial| -> Vec<f64> {
        polynomial
            .terms()
            .map(|(_, powers)| powers.first().map_or(0.0, |power| power.exponent.to_f64()))
            .collect()
    };
    assert!(period.iter().flat_map(powers).all(|power| power == 0.0 || power == -1.0));
    assert!(!expansion.has_all_harmonics);
}

/// The error of order N falls as the power N of the amplitude.
#[test]
fn the_period_is_the_integral_of_the_energy() {
    for order in [3_usize, 5, 7] {
        let of = with_pi("x'' + x + x*abs(x) = 0", order, &Gauge::Fundamental).of_amplitude.unwrap();
        let error = |a: f64| {
            let exact = 4.0 * quarter(a, |d| work_of_quadratic(a, d)) / (2.0 * PI);
            (value(&numbers(&of.period_ratio), a) - exact).abs()
        };
        let at = 0.1;
        let power = libm::log2(error(at) / error(0.5 * at));
        let expected = f64::from(u32::try_from(order).unwrap());
        assert!((power - expected).abs() < 0.15, "order {order}: {power}");
    }
}

/// x″ + x + |x|³: half the periods of x ± x³, between turning points of one energy.
#[test]
fn an_asymmetric_force_has_half_the_period_of_either_side() {
    let expansion = with_pi("x'' + x + abs(x)^3 = 0", 9, &Gauge::Energy);
    let of = expansion.of_amplitude.as_ref().unwrap();
    let work = |a: f64, d: f64, sign: f64| {
        let rest = a - d;
        d * (a - 0.5 * d) * (1.0 + sign * 0.5 * (a * a + rest * rest))
    };
    let exact = |a: f64| {
        // ½A² + ¼A⁴ = ½b² − ¼b⁴.
        let b = (1.0 - (1.0 - 2.0 * a * a - a * a * a * a).sqrt()).sqrt();
        (quarter(a, |d| work(a, d, 1.0)) + quarter(b, |d| work(b, d, -1.0))) / PI
    };
    for a in [0.05, 0.1] {
        let error = (value(&numbers(&of.period_ratio), a) - exact(a)).abs();
        // The next power is the tenth.
        assert!(error < 3.0 * libm::pow(a, 10.0) + 2e-15, "{a}: {error:e}");
    }
    let (x_max, x_min) = (numbers(&expansion.x_max), numbers(&expansion.x_min));
    let rho = 0.1;
    for (x, sign) in [(value(&x_max, rho), 1.0), (-value(&x_min, rho), -1.0)] {
        assert!((x * x + sign * 0.5 * x * x * x * x - rho * rho).abs() < 1e-11);
    }
}

/// Frequency, mean and harmonics of order N beside orbits, and the same series in digits.
#[test]
fn harmonics_are_those_of_orbits_in_a_sweep() {
    let cases = [
        ("x'' + x + x*abs(x) = 0", 0.02),
        ("x'' + 2*x + abs(x)^3/2 - x^2/3 = 0", 0.05),
        ("x'' = -(x - 1) - (x - 1)*abs(1 - x)/3", 0.05),
        ("x'' + sin(x) + x^2*sign(x)/5 = 0", 0.05),
    ];
    for (text, amplitude) in sweep::part(cases, 3) {
        let oscillator = oscillator(text);
        let exact = expand_with_pi(&oscillator, 8, &Gauge::Fundamental, &Quiet).unwrap().unwrap();
        let digits = expand(&oscillator, 8, &Gauge::Fundamental, &Quiet).unwrap();
        assert_eq!(
            (digits.precision, digits.certificate),
            (Precision::Digits(40), Certificate::TwoPrecisions)
        );
        let (exact, in_digits) = (exact.of_amplitude.unwrap(), digits.of_amplitude.clone().unwrap());
        assert_eq!(exact.harmonics.len(), in_digits.harmonics.len());
        let orbit =
            ExactMotion::new(&oscillator, &digits, &Displacement::from_f64(amplitude).unwrap(), &Quiet)
                .unwrap();
        for ((k, series), (_, other)) in exact.harmonics.iter().zip(&in_digits.harmonics) {
            for (a, b) in series.iter().zip(other) {
                // Powers of π with opposite signs cancel up to three digits.
                assert!((number(a) - b.to_f64()).abs() < 1e-12, "{text} a{k}");
            }
            let motion = orbit.value(SeriesQuantity::Cosine(*k)).unwrap();
            let error = (value(&numbers(series), amplitude) - motion.value).abs();
            assert!(error < 20.0 * libm::pow(amplitude, 9.0) + motion.uncertainty, "{text} a{k}: {error:e}");
            assert!(motion.uncertainty < 1e-12);
        }
        let motion = orbit.value(SeriesQuantity::Frequency).unwrap();
        let error = (value(&numbers(&exact.frequency_ratio), amplitude) - motion.value).abs();
        assert!(error < 20.0 * libm::pow(amplitude, 8.0) + motion.uncertainty, "{text}: {error:e}");
    }
}

#[test]
fn every_gauge_gives_the_same_of_the_amplitude_in_a_sweep() {
    let gauges = [Gauge::XMax, Gauge::HalfSwing, Gauge::Energy, "A1=2,A2=1/3".parse().unwrap()];
    for (force_number, text) in ["x'' + x + x*abs(x) = 0", "x'' + x + abs(x)^3 + x^2 = 0"].iter().enumerate()
    {
        let natural = with_pi(text, 4, &Gauge::Fundamental);
        // By default one gauge: the first of one force, the last of the other.
        let run = |(number, _): &(usize, &Gauge)| sweep::is_full() || *number == 3 * force_number;
        for (_, gauge) in gauges.iter().enumerate().filter(run) {
            let other = with_pi(text, 4, gauge);
            let (a, b) = (natural.of_amplitude.clone().unwrap(), other.of_amplitude.clone().unwrap());
            assert_eq!((a.period_ratio, a.harmonics), (b.period_ratio, b.harmonics), "{text} {gauge}");
            let half = |expansion: &Expansion<LaurentPolynomial>| {
                expansion.of_half_swing.clone().map(|of| of.frequency_ratio)
            };
            assert_eq!(half(&natural), half(&other), "{text} {gauge}");
        }
        assert!(expand_with_pi(&oscillator(text), 4, &Gauge::Nome, &Quiet).is_err());
    }
}

#[test]
fn what_is_no_series_with_pi_is_given_in_digits_or_not_at_all() {
    let gauge = Gauge::Fundamental;
    assert_eq!(expand_with_pi(&oscillator("x'' + x + x^3 = 0"), 4, &gauge, &Quiet).unwrap(), None);
    let two_sided = oscillator("x'' + x + x*abs(x) = 0");
    assert_eq!(expand_with_pi(&two_sided, 16, &gauge, &Quiet).unwrap(), None);
    assert!(expand_with_pi(&two_sided, 0, &gauge, &Quiet).is_err());
    let irrational = oscillator("x'' + x + sqrt(2)*x*abs(x) = 0");
    assert_eq!(expand_with_pi(&irrational, 3, &gauge, &Quiet).unwrap(), None);
    let computed = expand(&irrational, 2, &gauge, &Quiet).unwrap().frequency_ratio[1].to_f64();
    assert!((computed - 4.0 * 2.0_f64.sqrt() / (3.0 * PI)).abs() < 1e-15);
}
