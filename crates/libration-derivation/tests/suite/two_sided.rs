//! Odd forces with another power series on either side.
//!
//! The periods are by mpmath: 4∫₀^A dx/√(2(V(A) − V(x))) by Gauss's rule at ten amplitudes with 50 digits, and the polynomial through them.

use libration::algebra::{BigFloat, Rational};
use libration::comparison::{ExactMotion, SeriesQuantity};
use libration::internals::progress::Watch;
use libration::oscillator::Oscillator;
use libration::perturbation::{Gauge, expand};
use libration::progress::Quiet;
use libration::quantity::Displacement;
use libration_derivation::internals::phase::{PhaseFunction, Wave};
use libration_derivation::internals::two_sided::Quarter;
use libration_derivation::internals::{DIGITS, Values, evaluate};
use libration_derivation::{
    Block, Derivation, DerivationError, Formula, Name, Released, perturbation, to_latex, to_markdown,
};

fn oscillator(equation: &str) -> Oscillator {
    Oscillator::new(&equation.parse().unwrap()).unwrap()
}

fn derived(equation: &str, order: usize) -> Result<Derivation, DerivationError> {
    perturbation(&oscillator(equation), order, &Gauge::Fundamental, None, &Quiet)
}

/// Equation, order, printed frequency, T/T0 by powers of the amplitude, and the first power beyond.
const ROWS: [(&str, usize, &str, &[f64], f64); 5] = [
    (
        "x'' + x + x*abs(x) = 0",
        4,
        r"1+\frac{4A}{3\pi }+\left(\frac{16}{9\pi ^{2}}+\frac{4}{9\pi }-\frac{5}{12}\right)A^{2}",
        &[1.0, -0.424_413_181_578, 0.275_195_606_140_5, -0.201_651_927_3],
        4.0,
    ),
    (
        "x'' + 2*x + x*abs(x) = 0",
        3,
        r"1+\frac{2A}{3\pi }",
        &[1.0, -0.212_206_590_789, 0.068_798_901_535],
        3.0,
    ),
    ("x'' + x + x^3*abs(x) = 0", 5, r"1+\frac{16A^{3}}{15\pi }", &[1.0, 0.0, 0.0, -0.339_530_545_262], 6.0),
    (
        "x'' + x + x^2*sign(x) + x^3 = 0",
        3,
        r"1+\frac{4A}{3\pi }",
        &[1.0, -0.424_413_181_578, -0.099_804_393_859],
        3.0,
    ),
    (
        "x'' + sin(x) + x*abs(x)/2 = 0",
        3,
        r"1+\frac{2A}{3\pi }",
        &[1.0, -0.212_206_590_789, 0.131_298_901_535],
        3.0,
    ),
];

/// T/T0 at an amplitude, from the printed formula without what is left out.
fn printed_period(derivation: &Derivation, amplitude: f64) -> f64 {
    let step = derivation.steps.iter().find(|step| step.id == "period").unwrap();
    let equations = step.blocks.iter().filter_map(|block| match block {
        Block::Equation { equation, .. } => Some(equation.statement()),
        _ => None,
    });
    let Some((_, Formula::Sum(terms))) =
        equations.into_iter().nth(1).and_then(|equation| equation.rest.last().cloned())
    else {
        panic!("the period is a sum")
    };
    let kept = terms.into_iter().filter(|term| !matches!(term, Formula::Order(_)));
    let mut values = Values::default();
    values.set(&Name::new("A"), BigFloat::from_f64(amplitude, 256).unwrap());
    evaluate(&Formula::Sum(kept.collect()), &DIGITS, &values).unwrap().to_f64()
}

#[test]
fn periods_agree_with_quadrature_and_integration_to_the_power_that_is_left_out() {
    for (equation, order, printed, period, next) in ROWS {
        let derivation = derived(equation, order).unwrap();
        let page = to_markdown(&derivation);
        assert!(page.contains(printed), "{equation}: {page}");
        let expected = period.iter().rev().fold(0.0, |sum, c| sum * 0.5 + c);
        let computed = printed_period(&derivation, 0.5);
        assert!((computed - expected).abs() < 1e-9, "{equation}: {computed} is not {expected}");
        let oscillator = oscillator(equation);
        let expansion = expand(&oscillator, 2, &Gauge::XMax, &Quiet).unwrap();
        let error = |amplitude: f64| {
            let at = Displacement::from_f64(amplitude).unwrap();
            let motion = ExactMotion::new(&oscillator, &expansion, &at, &Watch::new(&Quiet)).unwrap();
            let exact = motion.value(SeriesQuantity::Period).unwrap().value;
            (printed_period(&derivation, amplitude) / exact - 1.0).abs()
        };
        let power = libm::log2(error(0.08) / error(0.04));
        assert!((power - next).abs() < 0.3, "{equation}: {power}");
    }
}

/// A motion with another coefficient, or another frequency, does not satisfy the equation or its conditions.
#[test]
fn a_changed_quarter_swing_is_found() {
    let force = ["1", "1", "0", "1/3"].map(|text| text.parse::<Rational>().unwrap());
    let right = Quarter::new(&force, 4);
    assert!(right.check().is_ok());
    let millionth = Rational::new(1, 1_000_000).unwrap();
    for n in 2..=4 {
        let mut wrong = right.clone();
        let off = PhaseFunction::term(0, 3, Wave::Cosine, millionth.clone().into());
        wrong.motion[n] = wrong.motion[n].plus(&off);
        assert!(wrong.check().is_err(), "{n}");
        let mut wrong = right.clone();
        wrong.ratio[n - 1] = wrong.ratio[n - 1].scaled(&(Rational::from(1) + millionth.clone()));
        assert!(wrong.check().is_err() || right.ratio[n - 1].is_zero(), "{n}");
        // A further free motion satisfies the equation, and is not zero at the beginning or the end.
        let mut wrong = right.clone();
        let free = PhaseFunction::term(
            0,
            1,
            if n == 2 { Wave::Sine } else { Wave::Cosine },
            millionth.clone().into(),
        );
        wrong.motion[n] = wrong.motion[n].plus(&free);
        assert!(wrong.check().is_err(), "{n}");
    }
}

#[test]
fn numbers_are_shown_at_an_amplitude_and_other_forces_are_refused() {
    let at = |amplitude: f64| Released {
        amplitude: Displacement::from_f64(amplitude).unwrap(),
        angular_frequency: None,
    };
    let odd = oscillator("x'' + x + x*abs(x) = 0");
    let of = |gauge: &str, released: Option<&Released>| {
        perturbation(&odd, 4, &gauge.parse().unwrap(), released, &Quiet)
    };
    // T/T0 at A = 0.1 by mpmath.
    assert!(to_markdown(&of("x_max", Some(&at(0.1))).unwrap()).contains("0.9601"));
    assert!(matches!(of("energy", None), Err(DerivationError::GaugeOfTwoSided)));
    assert!(matches!(of("x_max", Some(&at(0.0))), Err(DerivationError::NotAnAmplitude(_))));
    assert!(matches!(derived("x'' + x + max(x, 0)^2 = 0", 3), Err(DerivationError::TwoSided)));
    assert!(matches!(derived("x'' + x + x*abs(x) = 0", 10), Err(DerivationError::Order { order: 10 })));
    let latex = to_latex(&derived("x'' + x + x*abs(x) = 0", 5).unwrap().exercises());
    assert_eq!(latex.matches('{').count(), latex.matches('}').count());
}
