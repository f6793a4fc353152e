//! Centres whose force keeps odd powers of the velocity: (x, t) → (−x, −t) makes their motions periodic. Compared with closed forms, with
//! a quadrature of the first integral, and with orbits.

use crate::typed::oscillator;
use libration::algebra::Rational;
use libration::comparison::{SeriesComparison, SeriesQuantity};
use libration::expression::Equation;
use libration::oscillator::{Kind, Oscillator};
use libration::perturbation::{Certificate, Expansion, Gauge, PhaseOrigin, Precision, expand};
use libration::progress::Quiet;
use libration::quadrature::double_exponential;
use std::f64::consts::PI;

const ISOCHRONOUS: &str = "x'' + 3*x*x' + x^3 + x = 0";
const LINEAR_DRAG: &str = "x'' + x*x' + x = 0";

fn expansion(text: &str, order: usize) -> Expansion {
    expand(&oscillator(text), order, &Gauge::Fundamental, &Quiet).unwrap()
}

fn value(series: &[Rational], at: f64) -> f64 {
    series.iter().rev().fold(0.0, |sum, c| sum * at + c.to_f64())
}

/// x = u′/u makes u‴ + u′ = 0, so that x = 2q·sin τ/(1 − 2q·cos τ + q²), which is 2·Σ qᵏ sin kτ, with the period 2π.
#[test]
fn the_isochronous_centre_has_its_closed_form_to_any_order() {
    let order = 24;
    let expansion = expansion(ISOCHRONOUS, order);
    assert_eq!(expansion.phase_origin, PhaseOrigin::Passage);
    let whole = |power: usize| Rational::from(i64::from(power == 0));
    assert_eq!(expansion.frequency_ratio, (0..order).map(whole).collect::<Vec<_>>());
    for k in 1..=order {
        let harmonic = expansion.harmonic(k).unwrap();
        assert!(harmonic.cos.iter().all(Rational::is_zero));
        for (power, coefficient) in harmonic.sin.iter().enumerate() {
            let expected =
                if power == k { Rational::from(1).divided_by_power_of_two(k - 1) } else { 0.into() };
            assert_eq!(*coefficient, expected, "b{k} at {power}");
        }
    }
    // The largest displacement is 2q/(1 − q²), where cos τ = 2q/(1 + q²).
    let q = 0.05;
    assert!((value(&expansion.x_max, 2.0 * q) - 2.0 * q / (1.0 - q * q)).abs() < 1e-16);
    assert_eq!(expansion.certificate, Certificate::FirstIntegral);
}

/// T of x″ + x·x′ + x = 0 from v − ln(1 + v) + x²/2 = A²/2: T = 2·∫ dv/((1 + v)·x).
fn period_by_first_integral(amplitude: f64) -> f64 {
    let energy = 0.5 * amplitude * amplitude;
    let gap = |v: f64| energy - (v - libm::log1p(v));
    let end = |inside: f64, outside: f64| {
        let (mut inside, mut outside) = (inside, outside);
        for _ in 0..200 {
            let middle = 0.5 * (inside + outside);
            if gap(middle) > 0.0 { inside = middle } else { outside = middle }
        }
        inside
    };
    let half = |end: f64| {
        // With v = v₁(1 − y²) the root at the end is gone; E − V(v) is a difference from the end.
        let part = |y: f64| {
            let v = end * (1.0 - y * y);
            let fallen = -end * y * y;
            let below = libm::log1p(fallen / (1.0 + end)) - fallen;
            2.0 * end.abs() * y / ((1.0 + v) * (2.0 * below).sqrt())
        };
        double_exponential(part).value
    };
    2.0 * (half(end(0.0, 10.0)) + half(end(0.0, -1.0 + 1e-15)))
}

/// The error of order N falls as the power N + 1 of the amplitude; odd powers vanish, so that it is N + 2 for an even N.
#[test]
fn the_period_is_that_of_the_first_integral() {
    let of = |order: usize| expansion(LINEAR_DRAG, order).of_amplitude.unwrap().period_ratio;
    let error = |series: &[Rational], amplitude: f64| {
        (value(series, amplitude) - period_by_first_integral(amplitude) / (2.0 * PI)).abs()
    };
    for (order, at) in [(3, 0.2), (5, 0.6), (7, 0.7)] {
        let series = of(order);
        let power = libm::log2(error(&series, at) / error(&series, 0.5 * at));
        let expected = f64::from(u32::try_from(order).unwrap()) + 1.0;
        assert!((power - expected).abs() < 0.3, "order {order}: {power}");
    }
    assert!(error(&of(31), 0.7) < 1e-14);
}

/// Frequency and harmonics beside orbits, where (amplitude/radius)³¹ is below the last digits.
#[test]
fn frequency_and_harmonics_are_those_of_orbits() {
    let cases = [
        (ISOCHRONOUS, 0.3),
        (LINEAR_DRAG, 0.5),
        ("x'' + x*(1 + x')^2 + x^3 = 0", 0.15),
        ("x'' + x*x' + 2*x = 0", 0.4),
        ("x'' = -(x - 2)*(1 + x'^3)", 0.3),
        ("x'' + sin(x)*exp(x'/2) = 0", 0.3),
    ];
    for (text, amplitude) in cases {
        let oscillator = oscillator(text);
        let expansion = expand(&oscillator, 31, &Gauge::Fundamental, &Quiet).unwrap();
        for quantity in [SeriesQuantity::Period, SeriesQuantity::Frequency]
            .into_iter()
            .chain((1..6).map(SeriesQuantity::Cosine))
        {
            let relation = SeriesComparison::new(&oscillator, &expansion, quantity);
            let exact = relation.exact_at(amplitude, &Quiet).unwrap();
            let error = (relation.evaluation_at(amplitude).value() - exact.value).abs();
            assert!(error < exact.uncertainty + 1e-13, "{text} {quantity}: {error:e}");
            assert!(exact.uncertainty < 2e-12, "{text} {quantity}: {:e}", exact.uncertainty);
        }
    }
}

/// sin kτ has the factor ω0 where k is even, so that a root of 2 stands in some coefficients, though not in the frequency.
#[test]
fn an_irrational_frequency_has_harmonics_in_digits() {
    let expansion = expansion("x'' + x*x' + 2*x = 0", 5);
    assert_eq!(expansion.precision, Precision::Digits(40));
    // By the time in units of 1/√2 the drag is 1/√2 of that of x″ + x·x′ + x = 0: b₂ = ε²/(6√2), Ω/ω0 = 1 − ε²/48.
    let b2 = expansion.harmonic(2).unwrap().sin[2].to_f64();
    assert!((b2 - 1.0 / (6.0 * 2.0_f64.sqrt())).abs() < 1e-16);
    assert!((expansion.frequency_ratio[2].to_f64() + 1.0 / 48.0).abs() < 1e-17);
}

#[test]
fn the_turning_points_are_opposite_in_every_gauge() {
    let oscillator = oscillator(LINEAR_DRAG);
    assert_eq!(*oscillator.kind(), Kind::Mirrored);
    let natural = expand(&oscillator, 7, &Gauge::Fundamental, &Quiet).unwrap();
    let x_max = expand(&oscillator, 7, &Gauge::XMax, &Quiet).unwrap();
    let listed = expand(&oscillator, 7, &"A1=2,A2=1/3".parse().unwrap(), &Quiet).unwrap();
    for series in [&natural, &x_max, &listed] {
        let opposite: Vec<Rational> = series.x_min.iter().map(|c| -c.clone()).collect();
        assert_eq!(series.x_max, opposite);
        assert_eq!(series.of_half_swing, None);
        assert_eq!(series.certificate, Certificate::PlainRationals);
        let of = |expansion: &Expansion| expansion.of_amplitude.clone().unwrap();
        assert_eq!(of(series).harmonics, of(&natural).harmonics);
        assert_eq!(of(series).period_ratio, of(&natural).period_ratio);
    }
    assert_eq!(x_max.x_max[1..], [1, 0, 0, 0, 0, 0, 0].map(Rational::from));
    assert_eq!(x_max.frequency_ratio, natural.of_amplitude.unwrap().frequency_ratio);
    let half_swing = expand(&oscillator, 7, &Gauge::HalfSwing, &Quiet).unwrap();
    assert_eq!(half_swing.harmonics, x_max.harmonics);
    assert!(expand(&oscillator, 7, &Gauge::Energy, &Quiet).is_err());
}

/// Equations near the symmetry, but without it: their motions decay or grow.
#[test]
fn what_is_nearly_mirrored_is_refused() {
    for text in [
        "x'' + x*x' + x + 1e-30*x^2 = 0",
        "x'' + x*x' + x^2*x' + x = 0",
        "x'' + (x - 1e-30)*x' + x = 0",
        "x'' + x*x' + x + x'^3 = 0",
    ] {
        let error = Oscillator::new(&text.parse::<Equation>().unwrap()).unwrap_err().to_string();
        let expected = ["neither the same for the opposite velocity", "small motions grow"];
        assert!(expected.iter().any(|part| error.contains(part)), "{text}: {error}");
    }
    assert_eq!(*oscillator("x'' + x*x'^2 + x = 0").kind(), Kind::Reversible);
    assert_eq!(*oscillator("x'' + (x - 2)*(x' + 1) = 0").kind(), Kind::Mirrored);
}

/// Up to order 15 in fractions with the root of ω0², above that by the orbit in the plane of states, asymmetric or not.
#[test]
fn forces_with_the_velocity_are_proven_where_the_frequency_is_no_fraction() {
    for (text, below) in [
        ("x'' = -2*x*(1 + x'^2)", Certificate::PlainRationals),
        ("x'' = -3*x - x^2 + x*x'^2", Certificate::PlainRationals),
        ("x'' - mu*(1 - 3*x^2)*x' + x = 0", Certificate::PlainRationals),
    ] {
        assert_eq!(expansion(text, 9).certificate, below, "{text}");
    }
    for text in ["x'' = -2*x*(1 + x'^2)", "x'' = -3*x - x^2 + x*x'^2", LINEAR_DRAG] {
        assert_eq!(expansion(text, 17).certificate, Certificate::FirstIntegral, "{text}");
    }
}
