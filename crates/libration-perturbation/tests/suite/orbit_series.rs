//! Perturbation series compared with periodic orbits, which are computed without series.

use libration::expression::Equation;
use libration::orbit::Orbit;
use libration::oscillator::{Kind, NamedOscillator, catalogue};
use libration::perturbation::{Gauge, SeriesEvaluation, expand};
use libration::progress::Quiet;

fn assert_within(value: f64, expected: f64, tolerance: f64, what: &str) {
    let error = (value - expected).abs();
    assert!(error <= tolerance, "{what}: {value} is not {expected} but {error:e} off, allowed {tolerance:e}");
}

/// Series up to A¹⁵ at amplitudes where the next term is below the last digit.
#[test]
fn the_catalogue_agrees_with_perturbation_theory() {
    let mut compared = 0;
    for named in catalogue() {
        let Ok(oscillator) = named.oscillator(&[]) else { continue };
        if matches!(oscillator.kind(), Kind::LimitCycle { .. }) {
            continue;
        }
        let expansion = expand(&oscillator, 16, &Gauge::Fundamental, &Quiet).unwrap();
        let series = &expansion.of_amplitude.as_ref().unwrap().frequency_ratio;
        let amplitude = 0.02;
        let ratio = SeriesEvaluation::new(series, amplitude).value();
        let omega0 = oscillator.omega0_squared().to_f64().sqrt();
        let position = oscillator.equilibrium().to_f64() + amplitude;
        let orbit = Orbit::released(oscillator.equation(), position, &Quiet).unwrap();
        let allowed = orbit.period_uncertainty() / orbit.period() + 1e-14;
        assert_within(orbit.frequency() / omega0, ratio, allowed * ratio, named.key);
        compared += 1;
    }
    assert!(compared >= 15, "{compared}");
}

#[test]
fn van_der_pols_cycle_agrees_with_its_series() {
    let oscillator = NamedOscillator::by_key("van_der_pol").unwrap().oscillator(&[]).unwrap();
    let series = expand(&oscillator, 24, &Gauge::Fundamental, &Quiet).unwrap().frequency_ratio;
    for strength in ["0.01", "0.1", "0.2"] {
        let strength_value: f64 = strength.parse().unwrap();
        let orbit = Orbit::limit_cycle(&van_der_pol(strength), &[1.0, 0.0], &Quiet).unwrap();
        let ratio = SeriesEvaluation::new(&series, strength_value).value();
        assert_within(orbit.frequency(), ratio, 3e-14, strength);
    }
}

fn van_der_pol(strength: &str) -> Equation {
    let equation: Equation = "x'' = mu*(1 - x^2)*x' - x".parse().unwrap();
    equation.with(&[("mu", strength.parse().unwrap())]).unwrap()
}
