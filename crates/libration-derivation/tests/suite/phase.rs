//! Integrals invert derivatives, and products agree with those of the waves.

use libration::algebra::Rational;
use libration_derivation::internals::build::tenths;
use libration_derivation::internals::phase::{PhaseFunction, PiNumber, Wave, number, series};
use libration_derivation::internals::{DIGITS, Values, evaluate};
use libration_derivation::{Formula, Name, formula_latex};

fn mixed() -> PhaseFunction {
    let term = |power, k, wave, value: i64| PhaseFunction::term(power, k, wave, Rational::from(value).into());
    [
        term(0, 0, Wave::Cosine, 3),
        term(1, 0, Wave::Cosine, -2),
        term(2, 1, Wave::Sine, 5),
        term(3, 2, Wave::Cosine, 7),
        term(0, 3, Wave::Sine, 4),
    ]
    .iter()
    .fold(PhaseFunction::default(), |sum, part| sum.plus(part))
}

/// The value of a formula at a phase.
fn value(formula: &Formula, phase: &Formula) -> f64 {
    let mut values = Values::default();
    let at = evaluate(phase, &DIGITS, &values).unwrap();
    values.set(&Name::new("ψ"), at);
    evaluate(formula, &DIGITS, &values).unwrap().to_f64()
}

#[test]
fn the_slope_of_an_integral_is_what_was_integrated() {
    let integral = mixed().integral();
    assert_eq!(integral.slope(), mixed());
    assert!(integral.at_start().is_zero());
}

#[test]
fn products_and_values_are_those_of_the_functions() {
    let (a, b) = (mixed(), mixed().slope());
    let near = |value: f64, expected: f64| (value - expected).abs() < 1e-12 * expected.abs().max(1.0);
    for phase in [3, 19, -22].map(tenths) {
        let [product, left, right] =
            [&a.times(&b), &a, &b].map(|function| value(&series(function, "ψ"), &phase));
        assert!(near(product, left * right), "{phase:?}");
    }
    for (half_turns, phase) in [(1, Formula::Pi), (2, 2 * Formula::Pi)] {
        let end = value(&number(&a.at_half_turns(half_turns)), &phase);
        assert!(near(end, value(&series(&a, "ψ"), &phase)), "{half_turns}");
    }
}

#[test]
fn numbers_with_pi_below_the_line_stand_on_one_fraction_line() {
    let latex = |over, under, power| {
        let value = PiNumber::from(Rational::new(over, under).unwrap()).times_power_of_pi(power);
        let function = PhaseFunction::term(1, 1, Wave::Cosine, value.clone());
        [number(&value), series(&function, "ψ")].map(|formula| formula_latex(&formula))
    };
    assert_eq!(latex(-4, 3, -1), [r"-\frac{4}{3\pi }", r"-\frac{4\psi \,\cos \psi }{3\pi }"]);
    assert_eq!(latex(1, 1, -2)[0], r"\frac{1}{\pi ^{2}}");
    assert_eq!(latex(-1, 2, 0)[0], r"-\frac{1}{2}");
    assert_eq!(latex(-3, 1, 1)[0], r"-3\pi");
}
