//! The open gauge and the expansion agree for any oscillator and any gauge: the first keeps symbols, the second computes modulo primes.

use libration::algebra::{Rational, Variable};
use libration::oscillator::Oscillator;
use libration::perturbation::{EpsilonPowers, Expansion, Gauge, OpenGauge, expand, restoring_force};
use libration::progress::Quiet;

const ORDER: u32 = 8;

/// A₁, A₂, A₃, ….
fn gauge() -> Vec<Rational> {
    ["2", "-1/3", "3/7", "0", "5", "-1/2", "1", "-4/9"].map(|text| text.parse().unwrap()).into()
}

fn coefficients(expansion: &Expansion, harmonic: u32, order: u32) -> Rational {
    let series = expansion.harmonic(harmonic as usize).map(|it| it.cos.clone()).unwrap_or_default();
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
