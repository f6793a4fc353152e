//! The open gauge and the expansion agree for any oscillator and any gauge: the first keeps symbols, the second computes modulo primes.

use libration::algebra::{Polynomial, Rational, Variable};
use libration::oscillator::Oscillator;
use libration::perturbation::{
    EpsilonPowers, Expansion, Gauge, OpenGauge, OpenGaugeError, RestoringTerm, expand, restoring_force,
};
use libration::progress::Quiet;

const ORDER: u32 = 8;

/// A₁, A₂, A₃, ….
fn gauge() -> Vec<Rational> {
    ["2", "-1/3", "3/7", "0", "5", "-1/2", "1", "-4/9"].map(|text| text.parse().unwrap()).into()
}

fn coefficients(expansion: &Expansion, harmonic: u32, order: u32) -> Rational {
    let series = expansion.harmonic(harmonic as usize).map(|term| term.cos.clone()).unwrap_or_default();
    series.get(order as usize).cloned().unwrap_or_else(|| Rational::from(0))
}

#[test]
fn both_roads_agree_for_any_oscillator() {
    for equation in [
        "x'' = -sin(x)",
        "x'' + x + x^3 = 0",
        "x'' = -9*x + 2*x^3 - x^5/7",
        "x'' + x + x^2 = 0",
        "x'' = -(exp(x) - 1)*(1 + x/3)",
        "x'' = -x/sqrt(1 + x^2) + cos(x) - 1",
    ] {
        let oscillator = Oscillator::new(&equation.parse().unwrap()).unwrap();
        let force = restoring_force(&oscillator, ORDER as usize).unwrap();
        let open = OpenGauge::new(&force, ORDER, EpsilonPowers::All, &Quiet)
            .unwrap()
            .in_gauge(|n| gauge()[n as usize - 1].clone());
        let expansion = expand(&oscillator, ORDER as usize, &Gauge::Coefficients(gauge()), &Quiet).unwrap();
        for (variable, value) in &open {
            let order = variable.index().unwrap();
            let expected = if variable.letters() == "d" {
                expansion.frequency_ratio[order as usize].clone()
            } else {
                let named = |k: &u32| OpenGauge::coefficient_name(*k, order) == *variable;
                coefficients(&expansion, (0..=ORDER).find(named).unwrap(), order)
            };
            assert_eq!(*value, expected, "{equation}: {variable}");
        }
        assert!(open.contains_key(&Variable::from("d7")) && open.contains_key(&Variable::from("B8")));
    }
}

#[test]
fn forces_without_rational_coefficients_are_refused() {
    for equation in ["x'' = -x - x'^2", "x'' = -x*sqrt(2 + x)"] {
        let oscillator = Oscillator::new(&equation.parse().unwrap()).unwrap();
        assert_eq!(restoring_force(&oscillator, 5), None, "{equation}");
    }
}

/// Even powers of the velocity, with a symbol before one of them: at each value of the symbol the open gauge is the expansion.
#[test]
fn both_agree_with_velocities_and_symbols() {
    let term = |factor: Polynomial, position, velocity| RestoringTerm { factor, position, velocity };
    let number = |text: &str| Polynomial::constant(text.parse().unwrap());
    let terms = [
        term(number("1/3"), 0, 2),
        term(Polynomial::variable("b"), 1, 2),
        term(number("-2/5"), 2, 0),
        term(number("1/7"), 0, 4),
    ];
    let open = OpenGauge::of_terms(&terms, 6, EpsilonPowers::All, &Quiet).unwrap();
    for value in ["2/3", "-3"] {
        let equation = format!("x'' + x + x'^2/3 + ({value})*x*x'^2 - 2*x^2/5 + x'^4/7 = 0");
        let oscillator = Oscillator::new(&equation.parse().unwrap()).unwrap();
        let expansion = expand(&oscillator, 6, &Gauge::Coefficients(gauge()), &Quiet).unwrap();
        let value: Rational = value.parse().unwrap();
        let mut compared = 0;
        for (variable, polynomial) in open.solution() {
            let order = variable.index().unwrap();
            let at = |variable: &Variable| match variable.letters() {
                "b" => Some(value.clone()),
                _ => gauge().get(variable.index()? as usize - 1).cloned(),
            };
            let expected = if variable.letters() == "d" {
                expansion.frequency_ratio[order as usize].clone()
            } else {
                let named = |k: &u32| OpenGauge::coefficient_name(*k, order) == *variable;
                coefficients(&expansion, (0..=6).find(named).unwrap(), order)
            };
            assert_eq!(polynomial.value(at).unwrap(), expected, "{equation}: {variable}");
            compared += 1;
        }
        assert_eq!(compared, 6 * 6 + 5);
    }
}

#[test]
fn odd_powers_of_the_velocity_are_refused() {
    let term = RestoringTerm { factor: Polynomial::variable("c"), position: 0, velocity: 3 };
    let refused = OpenGauge::of_terms(&[term], 3, EpsilonPowers::All, &Quiet).unwrap_err();
    assert_eq!(refused, OpenGaugeError::OddVelocity);
}
