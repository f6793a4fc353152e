//! Floquet multipliers of orbits on which a force jumps.
//!
//! References: central differences, with a distance of 1e-6, of the map of one period, integrated from jump to jump with SciPy's DOP853 to 1e-13
//! and polished by Newton's method; their error is about 1e-8.

use crate::typed::equation;
use libration::algebra::Complex;
use libration::orbit::{Orbit, OrbitGuess, Stability};
use libration::progress::Quiet;
use std::f64::consts::TAU;

/// Error of the references.
const REFERENCE: f64 = 5e-8;

fn assert_multipliers(orbit: &Orbit, expected: &[(f64, f64)], allowed: f64, what: &str) {
    let multipliers = &orbit.floquet().unwrap().multipliers;
    for &(re, im) in expected {
        let expected = Complex { re, im };
        let nearest =
            multipliers.iter().map(|multiplier| (*multiplier - expected).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest <= allowed, "{what}: {multipliers:?} are {nearest:e} from {expected:?}");
    }
}

#[test]
fn driven_oscillators_have_the_multipliers_of_their_period_map() {
    let cases = [
        ("x'' = -0.05*x' - x + 0.05*sign(x') + 0.3*cos(1.5*t)", 1.5, [-0.2, -0.05], (-0.5358619, 0.94683501)),
        ("x'' = -x - 0.1*sign(x') + 0.3*cos(1.5*t)", 1.5, [-0.18, 0.13], (-0.31039143, 0.5724654)),
        ("x'' = -0.1*x' - x - 0.1*sign(x') + 0.3*cos(1.5*t)", 1.5, [-0.16, 0.14], (-0.25483318, 0.4435345)),
        ("x'' = -0.1*x' - x - 0.1*sign(x') + 0.3*cos(0.8*t)", 0.8, [0.55, 0.34], (0.03830974, 0.42106657)),
        ("x'' = -0.1*x' - x - 0.3*sign(x) + 0.9*cos(3*t)", 3.0, [-0.15, 0.02], (-0.90045207, 0.01499193)),
        ("x'' = -0.02*x' - x - 0.5*sign(x) + 0.3*cos(1.4*t)", 1.4, [-0.95, 0.11], (0.55399415, 0.77925684)),
    ];
    for (text, frequency, start, (re, im)) in cases {
        let orbit = Orbit::driven(&equation(text), &start, TAU / frequency, &Quiet).unwrap();
        assert_multipliers(&orbit, &[(re, im), (re, -im)], REFERENCE, text);
        let expected = if re * re + im * im > 1.0 { Stability::Unstable } else { Stability::Attracting };
        let floquet = orbit.floquet().unwrap();
        assert_eq!(floquet.stability, expected, "{text}");
        assert!(floquet.errors.iter().all(|error| *error < 1e-11), "{text}: {:?}", floquet.errors);
    }
}

/// Friction holds the mass for 9.6 s of a period. A one-sided difference with a distance of 1e-5 gives 0.338486.
#[test]
fn a_sticking_phase_makes_one_multiplier_zero() {
    let stuck = equation("x'' = -0.1*x' - x - 0.1*sign(x') + 0.3*cos(0.3*t)");
    let orbit = Orbit::driven(&stuck, &[0.1, 0.0], TAU / 0.3, &Quiet).unwrap();
    assert_multipliers(&orbit, &[(0.338_486, 0.0)], 1e-5, "from rest");
    assert_multipliers(&orbit, &[(0.0, 0.0)], 1e-300, "from rest");
    assert_eq!(orbit.floquet().unwrap().stability, Stability::Attracting);
}

/// Each half of the cycle is a free swing about 1/2 or −1/2, with γ = 0.1 and ω = √(1 − γ²), in which the distance of a
/// maximum from the centre shrinks by e^(−γπ/ω), whatever the maximum.
#[test]
fn an_autonomous_cycle_has_the_multiplier_one() {
    let rubbed = equation("x'' = -0.2*x' - x + 0.5*sign(x')");
    let omega = (1.0_f64 - 0.01).sqrt();
    let other = libm::exp(-0.1 * TAU / omega);
    for guess in [[3.0, 0.0], [0.3, -3.0]] {
        let guess = OrbitGuess { state: guess.to_vec(), period: TAU };
        let held = if guess.state[1] == 0.0 { 1 } else { 0 };
        let orbit = Orbit::near(&rubbed, &guess, &[held], &Quiet).unwrap();
        assert!((orbit.period() - TAU / omega).abs() < 1e-12);
        assert_multipliers(&orbit, &[(1.0, 0.0), (other, 0.0)], 1e-12, &format!("{guess:?}"));
        let floquet = orbit.floquet().unwrap();
        assert_eq!((floquet.stability, floquet.logarithm), (Stability::Attracting, None));
    }
}
