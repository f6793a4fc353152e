//! Limit cycles over exact orbits, compared with integrations of the whole equation with a small parameter, and closed forms.

use libration::comparison::{LeadingLimitCycle, LeadingLimitCycles, LeadingLimitCyclesError};
use libration::orbit::Orbit;
use libration::progress::{Quiet, Status};
use std::f64::consts::PI;

fn leading(text: &str) -> LeadingLimitCycles {
    LeadingLimitCycles::new(&text.parse().unwrap(), Some("e"), &Quiet).unwrap()
}

/// Amplitude, period and exponent over ε of the limit cycle of the whole equation, each at ε = 0 by those at two values: of an equation in
/// which the time may be turned round with the sign of ε they are even in it.
fn by_integration(text: &str, sign: f64, start: f64) -> [f64; 3] {
    let at = |strength: f64| {
        let equation = text.parse::<libration::expression::Equation>().unwrap();
        let value = format!("{}", sign * strength).parse().unwrap();
        let equation = equation.with(&[("e", value)]).unwrap();
        let orbit = Orbit::limit_cycle(&equation, &[start, 0.0], &Quiet).unwrap();
        // One multiplier is 1, the other that of a distance from the cycle.
        let multipliers = &orbit.floquet().unwrap().multipliers;
        let distance = multipliers.iter().map(|multiplier| multiplier.re).fold(f64::INFINITY, f64::min);
        [orbit.start()[0], orbit.period(), libm::log(distance) / (orbit.period() * sign * strength)]
    };
    let [coarse, fine] = [at(0.04), at(0.02)];
    [0, 1, 2].map(|of| (4.0 * fine[of] - coarse[of]) / 3.0)
}

/// The remainder of the even powers is ε⁴ = 3e-6 of 0.04 with a factor of order one, as halving both strengths shows.
fn agrees(text: &str, cycle: &LeadingLimitCycle, sign: f64) {
    let [amplitude, period, exponent] = by_integration(text, sign, cycle.amplitude);
    assert!((amplitude / cycle.amplitude - 1.0).abs() < 1e-5, "{text}: {amplitude} {cycle:?}");
    assert!((period / cycle.period - 1.0).abs() < 1e-5, "{text}: {period} {cycle:?}");
    assert!((exponent / cycle.exponent - 1.0).abs() < 1e-4, "{text}: {exponent} {cycle:?}");
    assert!(cycle.amplitude_uncertainty < 1e-11 * cycle.amplitude, "{cycle:?}");
}

#[test]
fn van_der_pol_with_a_finite_cubic_term_settles_at_1_9351() {
    let text = "x'' + x + x^3 = e*(1 - x^2)*x'";
    let [cycle] = &leading(text).cycles[..] else { panic!("one cycle") };
    assert!((cycle.amplitude - 1.9351).abs() < 5e-5, "{cycle:?}");
    assert!((cycle.other_side + cycle.amplitude).abs() < 1e-12);
    agrees(text, cycle, 1.0);
}

#[test]
fn rayleigh_with_a_cubic_term_and_the_pendulum_with_van_der_pol_s_excitation_as_well() {
    for text in ["x'' + x + x^3 = e*(1 - x'^2/3)*x'", "x'' + sin(x) = e*(1 - 2*x^2)*x'"] {
        let [cycle] = &leading(text).cycles[..] else { panic!("one cycle") };
        agrees(text, cycle, 1.0);
    }
}

#[test]
fn of_two_cycles_each_attracts_for_one_sign() {
    let text = "x'' + x + x^3 = -e*(1 - 4*x^2 + 3/2*x^4)*x'";
    let [inner, outer] = &leading(text).cycles[..] else { panic!("two cycles") };
    assert!(inner.exponent > 0.0 && outer.exponent < 0.0);
    agrees(text, inner, -1.0);
    agrees(text, outer, 1.0);
}

/// Without the cubic term the cycles are at A² = (b ± √(b² − 8ac))/c.
#[test]
fn two_cycles_that_are_close_are_both_found() {
    let root = 0.04_f64;
    let b = (8.0 + root * root).sqrt();
    let text = format!("x'' + x = -e*(1 - {b}*x^2 + x^4)*x'");
    let cycles = leading(&text).cycles;
    let expected = [b - root, b + root].map(f64::sqrt);
    assert_eq!(cycles.len(), 2);
    for (cycle, expected) in cycles.iter().zip(expected) {
        assert!((cycle.amplitude - expected).abs() <= cycle.amplitude_uncertainty, "{cycle:?} {expected}");
    }
}

/// The orbits end at the separatrix through the equilibrium at −1, whose other turning point is 1/2.
#[test]
fn an_asymmetric_force_has_its_cycle_too() {
    let text = "x'' + x + x^2 = e*(1/25 - x^2)*x'";
    let whole = leading(text);
    let [cycle] = &whole.cycles[..] else { panic!("one cycle: {whole:?}") };
    assert!(whole.family_ends && (whole.searched[1] - 0.5).abs() < 1e-3);
    agrees(text, cycle, 1.0);
}

#[test]
fn closed_forms_are_met_within_what_is_stated() {
    // x″ + x: A = 2 with the exponent −1; dry friction against negative damping: W = πA² − 2A, so A = 2/π and exponent 1/2.
    for (text, amplitude, exponent) in
        [("x'' + x = e*(1 - x^2)*x'", 2.0, -1.0), ("x'' + x = e*(x' - sign(x')/2)", 2.0 / PI, 0.5)]
    {
        let [cycle] = &leading(text).cycles[..] else { panic!("{text}") };
        assert!((cycle.amplitude - amplitude).abs() <= cycle.amplitude_uncertainty, "{cycle:?}");
        assert!((cycle.exponent - exponent).abs() <= cycle.exponent_uncertainty, "{cycle:?}");
        assert!((cycle.period - 2.0 * PI).abs() <= cycle.period_uncertainty, "{cycle:?}");
        assert!(cycle.amplitude_uncertainty < 1e-12 && cycle.exponent_uncertainty < 1e-11, "{cycle:?}");
    }
}

#[test]
fn a_force_that_only_takes_has_none_and_says_so() {
    let damped = leading("x'' + e*x'*abs(x') + sin(x) = 0");
    assert!(damped.cycles.is_empty() && damped.family_ends && !damped.is_without_work());
    assert!((damped.searched[1] - PI).abs() < 5e-3 && damped.signs.iter().all(|sign| *sign < 0.0));
    let driven = leading("x'' + x + x^3 = e*x'");
    assert!(driven.cycles.is_empty() && !driven.family_ends && driven.signs.iter().all(|sign| *sign > 0.0));
    // A force of the place alone, and one that gives on one half of the way what it takes on the other.
    for text in ["x'' + sin(x) = e*x^2", "x'' + x = e*x'^2"] {
        assert!(leading(text).is_without_work(), "{text}: {:?}", leading(text));
    }
}

#[test]
fn what_has_no_orbits_is_refused() {
    let refused = |text: &str| LeadingLimitCycles::new(&text.parse().unwrap(), None, &Quiet).unwrap_err();
    assert!(matches!(refused("x'' + x*x' + x = e*x'"), LeadingLimitCyclesError::VelocityDependent { .. }));
    assert!(matches!(refused("x'' - x = e*x'"), LeadingLimitCyclesError::SlowFlow(_)));
    assert!(matches!(refused("x'' + x = x'"), LeadingLimitCyclesError::SlowFlow(_)));
    let equation = "x'' + x = e*(1 - x^2)*x'".parse().unwrap();
    let stopped = LeadingLimitCycles::new(&equation, None, &|_: Status| std::ops::ControlFlow::Break(()));
    assert_eq!(stopped, Err(LeadingLimitCyclesError::Interrupted));
}
