//! Periodic orbits compared with elliptic functions and closed forms, which are independent of integration.

use crate::typed::equation;
use libration::elliptic::Modulus;
use libration::expression::Equation;
use libration::orbit::{Lost, Orbit, OrbitError, OrbitGuess, OrbitKind, OrbitSearch, Stability};
use libration::pendulum::{Motion, Pendulum};
use libration::progress::{Quiet, Status};
use libration::quantity::Angle;
use libration_testing::sweep;
use std::cell::Cell;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::ops::ControlFlow;

fn released(text: &str, position: f64) -> Orbit {
    Orbit::released(&equation(text), position, &Quiet).unwrap()
}

fn assert_within(value: f64, expected: f64, tolerance: f64, what: &str) {
    let error = (value - expected).abs();
    assert!(error <= tolerance, "{what}: {value} is not {expected} but {error:e} off, allowed {tolerance:e}");
}

fn pendulum(amplitude: f64) -> Motion {
    let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
    pendulum.released_from(Angle::from_radians(amplitude).unwrap()).unwrap()
}

const PENDULUM: &str = "theta'' + sin(theta) = 0";

#[test]
fn periods_of_the_pendulum_are_exact_within_their_uncertainty_in_a_sweep() {
    for step in sweep::part_and(1..315, 6, |step| *step > 306) {
        let amplitude = 0.01 * f64::from(step);
        let orbit = released(PENDULUM, amplitude);
        let exact = pendulum(amplitude).period();
        assert_within(orbit.period(), exact, orbit.period_uncertainty(), &format!("from {amplitude}"));
        // Near the top the rounding error of an angle is larger relative to the distance from the top.
        let allowed = 4e-14 * exact * (1.0 + 4e-3 / ((PI - amplitude) * (PI - amplitude)));
        assert!(orbit.period_uncertainty() < allowed, "{amplitude}: {:e}", orbit.period_uncertainty());
    }
}

#[test]
fn harmonics_of_the_pendulum_are_exact() {
    for amplitude in [0.1, 1.0, 2.0, 3.0, 3.14] {
        let exact = pendulum(amplitude).harmonics(1e-17, 2000);
        let computed = released(PENDULUM, amplitude).harmonics(0);
        // The last amplitude is 0.0016 below the top; rounding to 4e-16 changes this distance by 2e-13 of itself at each turn.
        let off = if amplitude > 3.1 { 1e-10 } else { 1e-14 };
        for term in &exact.terms {
            let harmonic = computed.terms.get(term.n).copied().unwrap_or_default();
            assert_within(harmonic.cosine, term.angle, off, &format!("a{} from {amplitude}", term.n));
            assert_within(harmonic.sine, 0.0, off, &format!("b{} from {amplitude}", term.n));
        }
        let even = computed.terms.iter().step_by(2);
        assert!(even.clone().all(|term| term.amplitude() < off), "{amplitude}");
        assert!(computed.remainder < 1e-14, "{amplitude}: {:e}", computed.remainder);
    }
}

#[test]
fn duffing_oscillators_have_their_closed_form() {
    for amplitude in [0.01, 0.3, 1.0, 7.0, 1e3] {
        let square = amplitude * amplitude;
        let modulus = Modulus::from_parameter(0.5 * square / (1.0 + square)).unwrap();
        let period = 4.0 * modulus.first() / (1.0 + square).sqrt();
        let orbit = released("x'' + x + x^3 = 0", amplitude);
        assert_within(orbit.period(), period, orbit.period_uncertainty(), "hard");
        assert!(orbit.period_uncertainty() < 1e-14 * period);
    }
}

#[test]
fn the_purely_cubic_oscillator_has_a_period_in_proportion_to_one_over_the_amplitude() {
    // Γ(1/4)²/√π.
    let constant = 7.416_298_709_205_487_7;
    for amplitude in [1e-6, 0.5, 3.0, 1e8] {
        let period = released("x'' + x^3 = 0", amplitude).period();
        assert_within(period * amplitude, constant, 1e-14 * constant, "T·A");
    }
}

#[test]
fn amplitudes_whose_squares_have_all_digits_have_the_right_orbit_and_smaller_ones_none() {
    for exponent in (0..=323).step_by(3).chain([145, 146, 147, 154, 161, 162]) {
        let amplitude: f64 = format!("1e-{exponent}").parse().unwrap();
        match Orbit::released(&"x'' = -4*x".parse().unwrap(), amplitude, &Quiet) {
            Ok(orbit) => {
                assert_within(orbit.period(), PI, orbit.period_uncertainty(), &format!("1e-{exponent}"));
                assert!(orbit.period_uncertainty() < 1e-13, "1e-{exponent}");
            }
            Err(error) => {
                assert_eq!(error, OrbitError::TooSmall(amplitude));
                assert!(exponent > 145, "1e-{exponent}");
            }
        }
    }
}

#[test]
fn an_asymmetric_well_has_two_turning_points_and_one_period() {
    let well = "x'' + x + x^2 = 0";
    let above = released(well, 0.1);
    let half = above.state_at(0.5 * above.period());
    // x'² = ⅔(A − x)(x − b)(x − c) vanishes at b.
    let (p, amplitude) = (3.2_f64, 0.1);
    let b = (-p + (p * (p - 8.0 * amplitude)).sqrt()) / 4.0;
    assert_within(half[0], b, 1e-15, "the other turning point");
    let below = released(well, b);
    assert_within(below.period(), above.period(), 4e-15, "from the other side");
    assert_within(below.state_at(0.5 * below.period())[0], 0.1, 1e-15, "back");
}

fn van_der_pol(strength: &str) -> Equation {
    equation("x'' = mu*(1 - x^2)*x' - x").with(&[("mu", strength.parse().unwrap())]).unwrap()
}

/// Reference periods by a Taylor method of order 55 with 260 bits.
#[test]
fn van_der_pols_cycle_is_found_when_it_is_far_from_a_circle() {
    for (strength, period) in
        [("0.5", 6.380_675_801_773_586), ("1", 6.663_286_859_323_13), ("2", 7.629_874_479_674_842)]
    {
        let orbit = Orbit::limit_cycle(&van_der_pol(strength), &[0.01, 0.0], &Quiet).unwrap();
        let allowed = orbit.period_uncertainty();
        assert_within(orbit.period(), period, allowed, strength);
        assert!(allowed < 1e-13, "{allowed:e}");
        assert_eq!(orbit.floquet().unwrap().stability, Stability::Attracting);
    }
}

/// Dorodnicyn: T = (3 − 2 ln 2)μ + 3αμ^(−1/3) − (2 ln μ)/(3μ) − 1.3246/μ + O(μ^(−5/3)), where −α is the first zero of Airy's function, and the
/// largest displacement 2 + αμ^(−4/3)/3 − (16 ln μ)/(27μ²) + O(μ⁻²); attributed to A. A. Dorodnicyn, Prikl. Mat. Mekh. 11, 313 (1947), with the
/// corrections of later authors (P. Amore, arXiv:2111.12198). The digits were computed by SciPy's `Radau` with a relative tolerance of 1e-11.
#[test]
fn van_der_pols_cycle_is_found_when_it_relaxes_in_a_sweep() {
    const ALPHA: f64 = 2.338_107_410_459_767;
    // The last takes most of the time.
    let cycles = [
        ("10", 19.078_369_57, 2.014_285_36),
        ("100", 162.837_071_09, 2.001_318_68),
        ("1000", 1_614.401_125_81, 2.000_072_97),
    ];
    for (strength, period, amplitude) in cycles.into_iter().take(sweep::number(2, 3)) {
        let mu: f64 = strength.parse().unwrap();
        let orbit = Orbit::limit_cycle(&van_der_pol(strength), &[1.0, 0.0], &Quiet).unwrap();
        // To the printed digits, and SciPy's tolerance.
        assert_within(orbit.period(), period, 5e-9 + 2e-11 * period, strength);
        assert_within(orbit.start()[0], amplitude, 1e-8, strength);
        let (log, root) = (libm::log(mu), libm::cbrt(mu));
        let leading = (3.0 - 2.0 * libm::log(2.0)) * mu + 3.0 * ALPHA / root;
        let asymptotic = leading - 2.0 * log / (3.0 * mu) - 1.3246 / mu;
        assert_within(orbit.period(), asymptotic, 2.0 / (mu * root * root), "period");
        let largest = 2.0 + ALPHA / (3.0 * mu * root) - 16.0 * log / (27.0 * mu * mu);
        assert_within(orbit.start()[0], largest, 1.0 / (mu * mu), "amplitude");
        assert!(orbit.period_uncertainty() < 1e-12 * period, "{:e}", orbit.period_uncertainty());
        // On the slow branches ∮ μ(1 − x²) dt = −(3/2 + 2 ln 2)μ²; the multiplier itself underflows for 20 and more.
        let floquet = orbit.floquet().unwrap();
        let part = floquet.logarithm.unwrap() / (mu * mu) / -(1.5 + 2.0 * libm::log(2.0));
        assert!((part - 1.0).abs() < 4.0 / (root * mu), "{strength}: {part}");
        assert_eq!(floquet.stability, Stability::Attracting);
        assert!(floquet.multipliers[1].re == 0.0 || mu < 20.0);
    }
}

/// The derivative of Rayleigh's equation x″ = μ(1 − x′²/3)x′ − x is van der Pol's for x′.
#[test]
fn rayleighs_cycle_has_van_der_pols_period() {
    for strength in ["3", "30"] {
        let rayleigh = equation("x'' = mu*(1 - x'^2/3)*x' - x").with(&[("mu", strength.parse().unwrap())]);
        let one = Orbit::limit_cycle(&rayleigh.unwrap(), &[1.0, 0.0], &Quiet).unwrap();
        let other = Orbit::limit_cycle(&van_der_pol(strength), &[1.0, 0.0], &Quiet).unwrap();
        let allowed = one.period_uncertainty() + other.period_uncertainty();
        assert_within(one.period(), other.period(), allowed, strength);
        assert!(allowed < 1e-11);
        let logarithms = [&one, &other].map(|orbit| orbit.floquet().unwrap().logarithm.unwrap());
        assert!((logarithms[0] / logarithms[1] - 1.0).abs() < 1e-9, "{logarithms:?}");
    }
}

/// Two methods for a cycle agree when both are certain: Newton's method, and a single turn after which the start has no influence.
#[test]
fn the_two_ways_to_a_cycle_meet() {
    // The logarithms are −35 and −47 there: on either side of −40.
    for strength in ["3.2", "3.6"] {
        let cycle = Orbit::limit_cycle(&van_der_pol(strength), &[1.0, 0.0], &Quiet).unwrap();
        let guess = OrbitGuess { state: cycle.start(), period: cycle.period() };
        let by_newton = Orbit::near(&van_der_pol(strength), &guess, &[1], &Quiet).unwrap();
        let allowed = cycle.period_uncertainty() + by_newton.period_uncertainty();
        assert_within(cycle.period(), by_newton.period(), allowed, strength);
    }
    let by_newton = Orbit::limit_cycle(&van_der_pol("1"), &[1.0, 0.0], &Quiet).unwrap();
    let floquet = by_newton.floquet().unwrap();
    assert_within(libm::exp(floquet.logarithm.unwrap()), floquet.multipliers[1].re, 1e-11, "Liouville");
}

/// Liouville: the product of the multipliers is the exponential of the integral of the divergence μ(1 − x²).
#[test]
fn multipliers_have_the_product_that_the_divergence_tells() {
    let orbit = Orbit::limit_cycle(&van_der_pol("1"), &[1.0, 0.0], &Quiet).unwrap();
    let spectrum = orbit.harmonics(0);
    let squares: f64 = spectrum.terms.iter().map(|term| 0.5 * term.amplitude() * term.amplitude()).sum();
    let divergence = orbit.period() * (1.0 - squares);
    let [one, other] = orbit.floquet().unwrap().multipliers[..] else { panic!("two multipliers") };
    assert_within(one.re, 1.0, 1e-11, "the shift along the orbit");
    assert_within(other.re, libm::exp(divergence), 1e-11, "the other one");
}

#[test]
fn repelling_cycles_are_found_from_a_guess() {
    let guess = OrbitGuess { state: vec![1.9, 0.0], period: 6.5 };
    let orbit = Orbit::near(&van_der_pol("-1"), &guess, &[1], &Quiet).unwrap();
    assert_within(orbit.period(), 6.663_286_859_323_13, 1e-12, "the same cycle backwards");
    assert_eq!(orbit.floquet().unwrap().stability, Stability::Unstable);
}

#[test]
fn absolute_values_have_their_deviations() {
    let orbit = Orbit::near(
        &equation("x'' = -2*x*abs(x)"),
        &OrbitGuess { state: vec![1.0, 0.0], period: 5.0 },
        &[0, 1],
        &Quiet,
    )
    .unwrap();
    let released = released("x'' = -2*x*abs(x)", 1.0);
    assert_within(orbit.period(), released.period(), 1e-13, "by two roads");
    // x′² = (4/3)(1 − |x|³): T = 4·√(3/4)·∫₀¹ dx/√(1 − x³) = 4·√(3/4)·(1/3)·B(1/3, 1/2).
    assert_within(
        orbit.period(),
        4.0 * 0.75_f64.sqrt() * 4.206_546_315_976_36 / 3.0,
        1e-13,
        "by an integral",
    );
}

/// x = Re(e^{iνt}/(1 − ν² + iγν)), and deviations decay by e^{−γT/2}.
#[test]
fn a_driven_linear_oscillator_answers_as_it_must() {
    let driven = equation("x'' = -x - x'/5 + cos(3*t/2)");
    let period = TAU / 1.5;
    let orbit = Orbit::driven(&driven, &[3.0, 0.0], period, &Quiet).unwrap();
    let (real, imaginary) = (1.0 - 2.25, 0.2 * 1.5);
    let size = real * real + imaginary * imaginary;
    let terms = orbit.harmonics(0).terms;
    assert_within(terms[1].cosine, real / size, 2e-15, "in phase");
    assert_within(terms[1].sine, imaginary / size, 2e-15, "a quarter behind");
    for multiplier in &orbit.floquet().unwrap().multipliers {
        assert_within(multiplier.abs(), libm::exp(-0.1 * period), 1e-13, "decay");
    }
    assert_eq!(orbit.floquet().unwrap().stability, Stability::Attracting);
}

/// Deviations grow by e^{aT} in a period, 8e10 and 1.6e12, too much for a single integration: x = −cos t/(1 + a²).
#[test]
fn strongly_unstable_orbits_close_piece_by_piece() {
    for stiffness in [16.0, 20.0] {
        let driven = equation(&format!("x'' = {stiffness}*x + cos(t)"));
        let start = -1.0 / (1.0 + stiffness);
        let orbit = Orbit::driven(&driven, &[start, 0.0], TAU, &Quiet).unwrap();
        assert_within(orbit.start()[0], start, orbit.start_errors()[0], &format!("{stiffness}"));
        let growth = libm::exp(TAU * libm::sqrt(stiffness));
        let largest = orbit.floquet().unwrap().multipliers[0].re;
        assert_within(largest / growth, 1.0, 1e-2, "growth");
    }
}

/// y loses 2e-5 of its amplitude in a period, which is less than the effect of rounding x on the end: no orbit.
#[test]
fn damped_motion_next_to_a_strongly_unstable_one_does_not_close() {
    for (damping, is_orbit) in [("0", true), ("1/200000", false)] {
        let equation = equation(&format!("y'' = -y - {damping}*y'; x'' = 20*x + y"));
        let guess = OrbitGuess { state: vec![1.0, -1.0 / 21.0, 0.0, 0.0], period: TAU };
        let orbit = Orbit::near(&equation, &guess, &[0, 2], &Quiet);
        assert_eq!(
            orbit.is_ok(),
            is_orbit,
            "{damping}: {:?}",
            orbit.map(|orbit| orbit.start_errors().to_vec())
        );
    }
}

/// Deviations grow by e^{aT}, 2e13 and 3e16, of which the last digit of the start makes 0.5 % and seven times the swing: x = −cos t/(1 + a²).
/// The second begins at a guess that is wrong by 4 %, from where Newton's method left the range of numbers.
#[test]
fn orbits_too_unstable_for_double_precision_are_refused_for_that_reason() {
    for (stiffness, guess) in [(24.0, -0.04), (25.0, -0.04), (37.0, -1.0 / 38.0)] {
        let driven = equation(&format!("x'' = {stiffness}*x + cos(t)"));
        let error = Orbit::driven(&driven, &[guess, 0.0], TAU, &Quiet).unwrap_err();
        let OrbitError::TooUnstable { growth } = error else { panic!("{stiffness}: {error}") };
        assert_within(growth / libm::exp(TAU * libm::sqrt(stiffness)), 1.0, 5.0, "growth");
    }
}

/// The inverted pendulum on a pivot that oscillates fast enough is stable: a²Ω² > 2gl.
#[test]
fn a_shaken_pendulum_stands_upside_down() {
    let stability = |amplitude: &str| {
        let text = "theta'' + (1 - 900*a*cos(30*t))*sin(theta) = 0";
        let equation = equation(text).with(&[("a", amplitude.parse().unwrap())]).unwrap();
        let orbit = Orbit::driven(&equation, &[PI, 0.0], TAU / 30.0, &Quiet).unwrap();
        orbit.floquet().unwrap().stability
    };
    assert_eq!(stability("0.03"), Stability::Unstable);
    assert_eq!(stability("0.06"), Stability::Neutral);
}

#[test]
fn a_search_finds_the_orbit_of_each_kind() {
    let search = |start: &[f64], period: Option<f64>, conserves_energy: bool| OrbitSearch {
        start: start.to_vec(),
        period,
        conserves_energy,
        held: None,
    };
    let searched = |text: &str, search: &OrbitSearch| Orbit::search(&equation(text), search, &Quiet);
    let (kind, orbit) = searched("x'' = -x^3", &search(&[2.0, 0.0], None, true)).unwrap();
    assert_eq!(kind, OrbitKind::Released);
    // Γ(1/4)²/√π over the amplitude.
    assert!((orbit.period() - 7.416298709205487 / 2.0).abs() < 1e-14);
    let (kind, orbit) =
        searched("x'' = -x + cos(2t/3)", &search(&[0.0, 0.0], Some(3.0 * PI), false)).unwrap();
    assert_eq!((kind, orbit.closing_error().len()), (OrbitKind::Driven, 2));
    assert!(
        (orbit.start()[0] - 1.8).abs() < 1e-14 && orbit.closing_error().iter().all(|error| *error < 1e-14)
    );
    let (kind, _) = searched("x'' = (1 - x^2)*x' - x", &search(&[0.5, 0.0], None, false)).unwrap();
    assert_eq!(kind, OrbitKind::LimitCycle);
    let pair = "x'' = y - 2*x - (x - y)^3; y'' = x - 2*y + (x - y)^3";
    let (kind, orbit) = searched(pair, &search(&[0.1, -0.1, 0.0, 0.0], Some(3.6), true)).unwrap();
    assert_eq!((kind, orbit.start()), (OrbitKind::Family, vec![0.1, -0.1, 0.0, 0.0]));
    assert!((orbit.period() - released("x'' = -3*x - 8*x^3", 0.1).period()).abs() < 1e-14);
    // A start close to this one is not on an orbit of the family: the largest coordinate is held.
    let (kind, orbit) = searched(pair, &search(&[0.1, -0.097, 0.0, 0.0], Some(3.6), true)).unwrap();
    assert_eq!((kind, orbit.start()[0]), (OrbitKind::Near, 0.1));
    assert!((orbit.start()[1] + 0.1).abs() < 1e-12, "{:?}", orbit.start());
    // Without a known energy the orbits of prey and predators are a family too: at the start both components are held.
    let (kind, orbit) =
        searched("x' = x - x*y; y' = x*y - y", &search(&[1.0, 2.0], Some(6.5), false)).unwrap();
    assert_eq!((kind, orbit.start()), (OrbitKind::Family, vec![1.0, 2.0]));
    assert!(orbit.period_uncertainty() < 1e-13, "{:e}", orbit.period_uncertainty());
}

/// The way to chaos of Rössler's equations, compared with DOP853 of SciPy 1.17 with variations and Newton's method. Where the multiplier is negative a
/// motion returns more closely after two turns, and next to a doubled period (c = 2.832445) a pair of turns closes almost everywhere; past
/// c = 3.84 the motion passes the cycle of two turns first.
#[test]
fn a_cycle_has_its_least_period_and_attracts() {
    for (c, period, multiplier) in [
        ("2", 5.709_855_915_127_704, -0.383_585_052),
        ("2.5", 5.748_991_183_278_002, -0.769_693_642),
        ("2.832", 5.769_794_137_891_18, -0.999_704_34),
        ("3", 11.531_074_139_878_83, 0.586_297_820),
        ("3.9", 23.157_203_979_731_865, 0.582_232_366),
    ] {
        let roessler = equation(&format!("x' = -y - z; y' = x + 0.2*y; z' = 0.2 + z*(x - {c})"));
        let search =
            OrbitSearch { start: vec![1.0, 1.0, 0.0], period: None, conserves_energy: false, held: None };
        let (kind, orbit) = Orbit::search(&roessler, &search, &Quiet).unwrap();
        let floquet = orbit.floquet().unwrap();
        assert_eq!((kind, floquet.stability), (OrbitKind::LimitCycle, Stability::Attracting), "{c}");
        assert_within(orbit.period(), period, 1e-12 * period, c);
        let other = floquet.multipliers.iter().find(|multiplier| (multiplier.re - 1.0).abs() > 1e-7).unwrap();
        assert_within(other.re, multiplier, 2e-8, c);
        // A multiple of the period as a guess leads to the same.
        let search = OrbitSearch { start: orbit.start(), period: Some(11.0 * orbit.period()), ..search };
        let (_, again) = Orbit::search(&roessler, &search, &Quiet).unwrap();
        assert_within(again.period(), period, 1e-12 * period, c);
    }
}

#[test]
fn a_period_that_is_none_of_the_drive_is_refused() {
    let driven = |text: &str, period: f64| Orbit::driven(&equation(text), &[1.0, 0.0], period, &Quiet);
    for text in ["x'' = -x - x^3 - 0.1*x' + cos(t)", "x'' = -x - x^3 - 0.1*x' + sign(cos(t))"] {
        assert_eq!(driven(text, 10.0).unwrap_err(), OrbitError::NotOfDrive(10.0), "{text}");
        assert!(driven(text, TAU).is_ok() && driven(text, 2.0 * TAU).is_ok(), "{text}");
    }
    let almost = 0.999_999 * TAU;
    let refused = driven("x'' = -x - x^3 - 0.1*x' + cos(t)", almost);
    assert_eq!(refused.unwrap_err(), OrbitError::NotOfDrive(almost));
    // A force without a period has no response at all, and one that rises in a thousandth of the period has the right one.
    assert!(driven("x'' = -x - 0.1*x' + cos(t) + cos(sqrt(2)*t)", TAU).is_err());
    assert!(driven("x'' = -x - x^3 - 0.1*x' + tanh(1000*cos(t))", TAU).is_ok());
}

#[test]
fn a_chaotic_motion_passes_unstable_cycles_and_settles_to_none() {
    let lorenz = equation("x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z");
    let start = vec![1.0, 1.0, 20.0];
    let search = OrbitSearch { start, period: None, conserves_energy: false, held: None };
    let (kind, orbit) = Orbit::search(&lorenz, &search, &Quiet).unwrap();
    assert_eq!((kind, orbit.floquet().unwrap().stability), (OrbitKind::Passed, Stability::Unstable));
}

/// Periods of prey and predators by quadrature over their invariant x − ln x + y − ln y, in 40 digits.
#[test]
fn an_orbit_of_a_family_goes_through_the_start_and_has_a_period_of_its_own() {
    let prey = "x' = x - x*y; y' = x*y - y";
    for (text, start, period) in [
        (prey, [2.0, 1.0], 6.608_482_671_235_056),
        (prey, [20.0, 1.0], 24.401_264_932_623_52),
        ("x' = y; y' = -x", [1.0, 0.0], TAU),
    ] {
        let search = OrbitSearch { start: start.to_vec(), period: None, conserves_energy: false, held: None };
        let (kind, orbit) = Orbit::search(&equation(text), &search, &Quiet).unwrap();
        assert_eq!((kind, orbit.start()), (OrbitKind::Family, start.to_vec()), "{text}");
        let (off, stated) = ((orbit.period() - period).abs(), orbit.period_uncertainty());
        assert!(off <= stated && stated < 1e-12, "{text} {start:?}: {off:e} {stated:e}");
        assert_eq!(orbit.floquet().unwrap().stability, Stability::Neutral);
    }
    // In the Kepler problem all orbits with the same energy have the same period, so that two components do not distinguish one from another.
    let kepler = "x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2)";
    let start = vec![0.5, 0.0, 0.0, 3_f64.sqrt()];
    let search = OrbitSearch { start: start.clone(), period: Some(6.28), conserves_energy: true, held: None };
    let (kind, orbit) = Orbit::search(&equation(kepler), &search, &Quiet).unwrap();
    assert_eq!((kind, orbit.start()), (OrbitKind::Family, start));
    let (off, stated) = ((orbit.period() - TAU).abs(), orbit.period_uncertainty());
    assert!(off <= stated && stated < 1e-12, "{off:e} {stated:e}");
}

/// The end misses the start by 6e-6 of the distance to neighbouring starts, and the cycle is isolated all the same.
#[test]
fn a_weak_limit_cycle_is_no_family() {
    let search = OrbitSearch { start: vec![0.0, 2.0], period: None, conserves_energy: false, held: None };
    let (kind, orbit) = Orbit::search(&equation("x'' = 1e-6*(1 - x^2)*x' - x"), &search, &Quiet).unwrap();
    assert_eq!(kind, OrbitKind::LimitCycle);
    assert!((orbit.period() - TAU).abs() < 1e-11, "{}", orbit.period());
}

#[test]
fn a_search_without_a_period_says_what_is_missing() {
    let search = |start: &[f64], conserves_energy: bool| OrbitSearch {
        start: start.to_vec(),
        period: None,
        conserves_energy,
        held: None,
    };
    let refused =
        |text: &str, search: &OrbitSearch| Orbit::search(&equation(text), search, &Quiet).unwrap_err();
    assert_eq!(refused("x'' = -x + cos(t)", &search(&[0.0, 0.0], false)), OrbitError::NoPeriod);
    assert_eq!(refused("x'' = -x; y'' = -2*y", &search(&[1.0, 1.0, 0.0, 0.0], true)), OrbitError::NoPeriod);
    assert!(matches!(refused("x'' = -x", &search(&[0.0], true)), OrbitError::Start { wanted: 2, .. }));
    assert!(matches!(refused("x'' = -x", &search(&[0.0, 0.0], true)), OrbitError::AtRest(_)));
}

#[test]
fn motions_without_a_period_are_refused_for_a_reason() {
    let refusal = |text: &str, position: f64| Orbit::released(&equation(text), position, &Quiet).unwrap_err();
    assert!(matches!(refusal("x'' = -x - x'/10", 1.0), OrbitError::NotClosed { start: 1.0, .. }));
    assert!(matches!(refusal("x'' = -x - 3*x'", 1.0), OrbitError::NoReturn { why: Lost::Rest, .. }));
    assert!(matches!(refusal("x'' = -x + x^2", 2.0), OrbitError::NoReturn { why: Lost::Stopped(_), .. }));
    assert!(matches!(refusal("x'' = -1", 2.0), OrbitError::NoReturn { why: Lost::OneWay(_), .. }));
    assert!(matches!(refusal("x'' = x", 2.0), OrbitError::NoReturn { .. }));
    // x = 1/2 is on the separatrix: its motion approaches −1 in infinite time.
    assert_eq!(refusal("x'' = -x - x^2", 0.5), OrbitError::Separatrix(0.5));
    assert_eq!(refusal("x'' = x - x^3", 1.0), OrbitError::AtRest(vec![1.0]));
    assert_eq!(refusal("x'' = -x + cos(t)", 1.0), OrbitError::DependsOnTime);
    assert_eq!(refusal("x'' = -y; y'' = -x", 1.0), OrbitError::SeveralCoordinates(2));
    assert!(matches!(refusal("x'' = -k*x", 1.0), OrbitError::WithoutValue(_)));
    assert!(matches!(refusal("x'' = -x", f64::NAN), OrbitError::Start { .. }));
    let cycle = |text: &str, start: &[f64]| Orbit::limit_cycle(&equation(text), start, &Quiet).unwrap_err();
    assert!(matches!(cycle("x'' = -x - 3*x'", &[1.0, 0.0]), OrbitError::NoCycle(_)));
    assert!(matches!(
        cycle("x'' = -x - x'/10", &[1.0, 0.0]),
        OrbitError::NoCycle(_) | OrbitError::NoConvergence { .. }
    ));
    assert!(matches!(cycle("x'' = -x + cos(t)", &[1.0, 0.0]), OrbitError::DependsOnTime));
    assert!(Orbit::driven(&equation("x'' = -x"), &[1.0, 0.0], 1.0, &Quiet).is_err());
    assert!(Orbit::driven(&equation("x'' = -x + cos(t)"), &[1.0, 0.0], TAU, &Quiet).is_err());
}

/// The `f64` next to π is 1.2e-16 below the top.
#[test]
fn the_last_amplitude_below_the_top_has_its_period() {
    let orbit = released(PENDULUM, PI);
    assert_within(
        orbit.period(),
        pendulum(PI).period(),
        orbit.period_uncertainty(),
        "from the f64 next to pi",
    );
    assert!(orbit.period_uncertainty() < 1e-13);
    let (start, late) = (orbit.start(), orbit.state_at(0.75 * orbit.period()));
    assert_within(start[0], PI, 0.0, "the start");
    assert_within(late[0], 0.0, 1e-12, "a quarter before the end");
    assert_within(late[1], 2.0, 1e-12, "upwards");
}

/// For x > −3 the equation is x″ = −x − x²; but a force with an absolute value is
/// integrated in double precision only, and next to the separatrix there is no answer.
#[test]
fn next_to_a_separatrix_a_force_with_a_kink_has_no_sure_period() {
    let kinked = "x'' = -x - x*(abs(x + 3) - 3)";
    for (position, period) in [(0.49, 9.207_998_623_393_865), (0.4999, 13.775_357_879_043_217)] {
        let orbit = released(kinked, position);
        // The position is the f64 next to the decimal: there half a unit in the last place is 1e-16/(0.5 - 0.4999) of a tenth of the period.
        let rounded = 1e-12 * period;
        assert_within(orbit.period(), period, orbit.period_uncertainty() + rounded, "beside the closed form");
        assert!(orbit.period_uncertainty() < 1e-9 * period, "{:e}", orbit.period_uncertainty());
    }
    let refusal = Orbit::released(&equation(kinked), 0.5 - 1e-10, &Quiet).unwrap_err();
    let OrbitError::Unsure { start, period, uncertainty } = refusal else { panic!("{refusal}") };
    assert!(start == 0.5 - 1e-10 && period > 25.0 && uncertainty > 1e-4 * period, "{period} {uncertainty}");
}

/// x″ + 3x·x′ + x³ + x = 0 is an isochronous centre, although the force differs for the opposite velocity.
#[test]
fn a_centre_whose_force_depends_on_the_sign_of_the_velocity_has_its_period() {
    for position in [0.1, 0.5, 1.0, 3.0] {
        let orbit = released("x'' + 3*x*x' + x^3 + x = 0", position);
        assert_within(orbit.period(), TAU, orbit.period_uncertainty(), &format!("from {position}"));
        assert!(orbit.period_uncertainty() < 1e-11, "{position}: {:e}", orbit.period_uncertainty());
    }
}

/// The antisymmetric solution of x″ + k·sign(x) = a·sin(t + φ) that passes zero upwards at t = π − φ, from x = −a·sin s − kπs/2 + ks²/2 for
/// s = t + φ from 0 to π: it has the largest deviation −a − kπ²/8 at s = π/2. At φ = 0 the start and every step end at the jump.
#[test]
fn an_orbit_that_begins_on_a_jump_of_the_force_is_found() {
    for (a, k, phase) in
        [(3.0, 1.0, 0.0), (3.0, 1.0, 1e-12), (3.0, 1.0, 0.3), (2.0, 0.25, 0.0), (5e-7, 1e-7, 0.0)]
    {
        let equation = format!("x'' + {k:?}*sign(x) = {a:?}*sin(t + {phase:?})").parse().unwrap();
        let position = |s: f64| -a * libm::sin(s) - 0.5 * k * PI * s + 0.5 * k * s * s;
        let start = [position(phase), -a * libm::cos(phase) - 0.5 * k * PI + k * phase];
        let orbit = Orbit::driven(&equation, &start, TAU, &Quiet).unwrap();
        let off = orbit.state_at(0.5 * PI - phase)[0] + a + 0.125 * k * PI * PI;
        assert!(off.abs() < 1e-13 * a, "a = {a}, k = {k}, phase {phase}: {off:e}");
        let multipliers = &orbit.floquet().unwrap().multipliers;
        // By the jump of the velocity of deviations, 2k/|x′|, and free flight over half a period, twice.
        let half = 1.0 - k * PI / (a + 0.5 * k * PI);
        let real = 2.0 * half * half - 1.0;
        assert!(
            multipliers.iter().all(|multiplier| (multiplier.re - real).abs() < 1e-9),
            "{multipliers:?} {real}"
        );
    }
}

/// x″ = −sign(x) falls for √(2A) in each of four quarters.
#[test]
fn a_force_of_one_size_has_the_period_of_free_fall() {
    for position in [1e-20, 0.5, 1.0, 2.0, 1e10] {
        let period = 4.0 * (2.0_f64 * position).sqrt();
        let orbit = released("x'' = -sign(x)", position);
        assert_within(orbit.period(), period, orbit.period_uncertainty(), &format!("from {position}"));
        assert!(orbit.period_uncertainty() < 1e-13 * period, "{position}");
        assert_within(orbit.state_at(0.5 * orbit.period())[0], -position, 1e-14 * position, "the other side");
    }
}

/// A jump of the force between two steps does not make the acceleration uncertain: −sign(x − c) is the same motion for every c.
#[test]
fn a_jump_at_the_end_of_a_step_makes_no_period_unsure() {
    let period = 4.0 * 2.0_f64.sqrt() * 0.5_f64.sqrt();
    for (centre, start) in
        [("1", 1.5), ("2", 2.5), ("(-3)", -2.5), ("1/3", 0.8333333333333334), ("1000", 1000.5)]
    {
        let orbit = released(&format!("x'' = -sign(x - {centre})"), start);
        assert_within(orbit.period(), period, orbit.period_uncertainty(), centre);
        // The relative uncertainty due to rounding of the position is proportional to 1000/0.5.
        assert!(orbit.period_uncertainty() < 1e-10, "{centre}: {:e}", orbit.period_uncertainty());
    }
    // −sign(x − 2)·e^|x − 2|: v² = 2·(e^A − e^y), and the quarter period is √2·e^(−A/2)·artanh √(1 − e^(−A)).
    let orbit = released("x'' = -sign(x - 2)*exp(abs(x - 2))", 2.5);
    let quarter = 2.0_f64.sqrt() * libm::exp(-0.25) * libm::atanh(libm::sqrt(-libm::expm1(-0.5)));
    assert_within(orbit.period(), 4.0 * quarter, orbit.period_uncertainty(), "with a force that grows");
}

/// (1 − c·cos x)·sin x with c = 1 − 2⁻²⁰ loses twenty bits next to the bottom: its period by the energy integral in 60 digits.
#[test]
fn a_force_that_cancels_has_its_period() {
    let orbit = released("x'' = -(1 - (1 - 2^(-20))*cos(x))*sin(x)", 1e-4);
    let period = 6_421.371_283_740_447;
    assert_within(orbit.period(), period, orbit.period_uncertainty(), "beside the energy integral");
    assert!(orbit.period_uncertainty() < 1e-12 * period, "{:e}", orbit.period_uncertainty());
}

/// Reference by mpmath, from the potential −cos x − 5·√(π/20000)/2·erf(√20000·(x − 2)): so near the
/// separatrix many bits are necessary, and no coefficient of a step that passes x = 2 shows the force there.
#[test]
fn a_narrow_force_on_the_way_from_a_separatrix_is_felt() {
    let equation = "x'' = -sin(x) + 5*exp(-20000*(x - 2)^2)".parse().unwrap();
    let orbit = Orbit::released(&equation, 3.1415926, &Quiet).unwrap();
    let error = (orbit.period() - 43.979_586_543_068_46).abs();
    assert!(error <= orbit.period_uncertainty(), "{error:e} beside {:e}", orbit.period_uncertainty());
    assert!(orbit.period_uncertainty() < 1e-13 * orbit.period());
    let other_side = orbit.state_at(0.5 * orbit.period())[0];
    assert!((other_side + 2.785_695_567_633_276_6).abs() < 1e-12, "{other_side}");
}

/// With frequencies of 2:1 swing and spring are coupled at any amplitude: r and the angle have their extrema at the same times.
#[test]
fn coupled_modes_of_a_spring_in_resonance_with_its_swing_are_found_at_an_angle() {
    // Computed by collocation in cosines and by Taylor shooting in 130-bit floats: 30 digits; the trace of the other pair of multipliers to 9.
    let spring =
        equation("r'' = r*theta'^2 + cos(theta) - 3*(r - 1); theta'' = -(2*r'*theta' + sin(theta))/r");
    let modes: [(f64, [f64; 2], f64, f64, f64); 4] = [
        (5.0, [7.09, 1.38], 7.087437530345269647307881, 1.376323498061977629228198, 1.75407913),
        (20.0, [6.58, 1.53], 6.583763427779130885809781, 1.531637815096400611312269, -0.774764844),
        (5.0, [7.42, 1.29], 7.423279872261442783198011, 1.293919892111355174413307, 1.74938487),
        (20.0, [7.93, 1.19], 7.931476467877885520678306, 1.194011222526851579063659, -0.91920993),
    ];
    for (degrees, [guess, length], period, start, trace) in modes {
        let angle = f64::to_radians(degrees);
        let search = OrbitSearch {
            start: vec![length, angle, 0.0, 0.0],
            period: Some(guess),
            conserves_energy: true,
            held: Some(1),
        };
        let (_, orbit) = Orbit::search(&spring, &search, &Quiet).unwrap();
        assert_eq!(orbit.start()[1], angle);
        let off = (orbit.period() / period - 1.0).abs().max((orbit.start()[0] / start - 1.0).abs());
        assert!(off < 1e-12, "{off:e} at {degrees}");
        // Two multipliers are 1, of deviations along the motion and along the family.
        let sum: f64 = orbit.floquet().unwrap().multipliers.iter().map(|multiplier| multiplier.re).sum();
        assert!((sum - 2.0 - trace).abs() < 1e-6, "{sum}");
        // The component farthest from zero is r; holding it would choose another orbit of the family.
        let other = Orbit::search(&spring, &OrbitSearch { held: None, ..search }, &Quiet).unwrap().1;
        assert!((other.start()[0] - length).abs() < 1e-15 && other.start()[1] != angle);
    }
}

/// The period is 2π(1 + μ²/16) to second order.
#[test]
fn weak_limit_cycles_are_found_from_a_start_that_drifts_to_them() {
    for strength in [1e-3, 1e-4, 1e-5] {
        let text = format!("x'' = {strength}*(1 - x^2)*x' - x");
        let cycle = Orbit::limit_cycle(&equation(&text), &[0.5, 0.0], &Quiet).unwrap();
        let off = cycle.period() - TAU * (1.0 + strength * strength / 16.0);
        assert!(off.abs() < 1e-10, "{strength}: {off:e}");
        assert!((cycle.start()[0] - 2.0).abs() < 1e-5, "{strength}: {:?}", cycle.start());
    }
}

#[test]
fn rest_is_only_told_of_motions_that_come_to_it() {
    let lost =
        |text: &str, start: &[f64]| match Orbit::limit_cycle(&equation(text), start, &Quiet).unwrap_err() {
            OrbitError::NoCycle(why) => why,
            other => panic!("{other}"),
        };
    assert!(matches!(lost("x'' = -x - x'/10", &[1.0, 0.0]), Lost::Rest));
    assert!(matches!(lost("x'' = 1 - x - 3*x'", &[0.5, 0.0]), Lost::Rest));
    // The slow part of a turn takes 1.6e6 times as long as the motion is integrated.
    let slow = lost("x'' = 1e6*(1 - x^2)*x' - x", &[0.5, 0.0]);
    assert!(matches!(slow, Lost::Slow { .. }), "{slow}");
    assert!(matches!(lost("x'' = 0", &[0.5, 1.0]), Lost::OneWay(_)));
    // Two equal oscillators that are not coupled have cycles with any difference of phase.
    let pair = equation("x'' = (1 - x^2)*x' - x; y'' = (1 - y^2)*y' - y");
    let family = Orbit::limit_cycle(&pair, &[2.0, 2.0, 0.0, 0.0], &Quiet).unwrap_err();
    assert!(matches!(family, OrbitError::Undetermined(_)), "{family}");
    // The cycle x − ln x + y − ln y = 400 passes the saddle at the origin with x = e⁻³⁹³: below a part 1e-16 of its size it is not determined.
    let cycle = lost("x' = x - x*y; y' = x*y - y", &[400.0, 1.0]);
    assert!(matches!(cycle, Lost::Saddle), "{cycle}");
    assert!(matches!(lost("x' = x - x^3; y' = -y", &[0.0, 1.0]), Lost::Saddle));
    assert!(matches!(lost("x' = x - x^3; y' = -y", &[0.5, 1.0]), Lost::Rest));
}

#[test]
fn a_motion_that_never_begins_is_a_rest_at_once() {
    /// Consultations in the steps of the integration: without an end the search takes half a million.
    const MOST: u32 = 1000;
    for text in ["x'' = -sin(x) - x'/10", "x'' = sin(x)", "x' = x - x^3; y' = -y"] {
        let steps = Cell::new(0);
        let few = |_: Status| {
            steps.set(steps.get() + 1);
            if steps.get() > MOST { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let lost = Orbit::limit_cycle(&equation(text), &[0.0, 0.0], &few).unwrap_err();
        assert_eq!(lost, OrbitError::NoCycle(Lost::Rest), "{text}");
    }
}

/// The hanging equilibrium of a pendulum whose pivot moves at twice its frequency is unstable.
#[test]
fn a_driven_orbit_about_an_unstable_rest_is_found_from_afar() {
    let kapitza = equation("theta'' + 0.05*theta' + (1 - 0.4*cos(2*t))*sin(theta) = 0");
    let from = |start: [f64; 2]| Orbit::driven(&kapitza, &start, TAU, &Quiet).unwrap();
    let [far, near] = [[1.0, 0.0], [1.0, 0.1]].map(from);
    let sizes = [&far, &near].map(|orbit| orbit.range(0).1);
    assert!(sizes[0] > 0.1 && (sizes[0] - sizes[1]).abs() < 1e-3 * sizes[0], "{sizes:?}");
}

/// A motion whose energy changes little in a turn is neither an orbit of a family nor the limit cycle far away from it.
#[test]
fn a_motion_with_weak_damping_is_not_periodic() {
    for text in [
        "x'' = -x - 1e-6*x'",
        "x'' = -x - 1e-10*x'",
        "x'' = -sin(x) - 1e-7*x'",
        "x'' = -x - 1e-12*x'*abs(x')",
    ] {
        let refusal = Orbit::released(&equation(text), 2.0, &Quiet).unwrap_err();
        assert!(matches!(refusal, OrbitError::NotClosed { .. }), "{text}: {refusal}");
        let search = OrbitSearch { start: vec![2.0, 0.0], period: None, conserves_energy: false, held: None };
        let outcome =
            Orbit::search(&equation(text), &search, &Quiet).map(|(kind, orbit)| (kind, orbit.start()));
        assert!(outcome.is_err(), "{text}: {outcome:?}");
    }
    // The motion closes with a relative error of 3e-16: an orbit within the stated errors.
    assert!(Orbit::released(&equation("x'' = -x - 1e-17*x'"), 2.0, &Quiet).is_ok());
    // Van der Pol's cycle has the amplitude 2 + μ²/96 for small μ; the start is far inside it.
    let search = OrbitSearch { start: vec![0.5, 0.0], period: None, conserves_energy: false, held: None };
    let (kind, cycle) = Orbit::search(&equation("x'' = -x - 1e-7*x'*(x^2 - 1)"), &search, &Quiet).unwrap();
    assert_eq!(kind, OrbitKind::LimitCycle);
    assert!((cycle.start()[0] - 2.0).abs() <= cycle.start_errors()[0], "{:?}", cycle.start());
    assert!(cycle.start_errors()[0] < 1e-7, "{:?}", cycle.start_errors());
}

/// Exact: x = Re(e^{iνt}/(1 − ν² + iγν)) with the multipliers of the free oscillation.
#[test]
fn errors_of_a_driven_orbit_hold_and_are_not_absurd() {
    for (damping, frequency) in [(0.2, 1.5), (1e-3, 0.999), (1e-6, 1.01), (0.5, 0.1)] {
        let text = format!("x'' = -x - {damping:?}*x' + cos({frequency:?}*t)");
        let period = TAU / frequency;
        let orbit = Orbit::driven(&equation(&text), &[0.1, 0.0], period, &Quiet).unwrap();
        let (real, imaginary) = (1.0 - frequency * frequency, damping * frequency);
        let size = real * real + imaginary * imaginary;
        let start = [real / size, frequency * imaginary / size];
        let amplitude = 1.0 / size.sqrt();
        for (component, exact) in start.into_iter().enumerate() {
            let (off, error) = ((orbit.start()[component] - exact).abs(), orbit.start_errors()[component]);
            // The closed form is rounded too.
            let rounding = 4.0 * f64::EPSILON * amplitude * (1.0 + (frequency / real).abs());
            assert!(off <= error + rounding, "{text}: {off:e} {error:e}");
            assert!(error < 1e-11 * amplitude / damping.max(1e-3), "{text}: {error:e}");
        }
        let (low, high) = orbit.range(0);
        assert!(
            (high - amplitude).abs() <= orbit.state_errors()[0] + 8.0 * f64::EPSILON * amplitude,
            "{text}"
        );
        assert!((low + high).abs() <= 2.0 * orbit.state_errors()[0], "{text}");
        let harmonics = orbit.harmonics(0);
        assert!(
            (harmonics.terms[1].cosine - start[0]).abs() <= harmonics.error + 4e-16 * amplitude,
            "{text}"
        );
        let floquet = orbit.floquet().unwrap();
        let free = (1.0 - damping * damping / 4.0).sqrt();
        let exact = libm::exp(-0.5 * damping * period);
        for (multiplier, error) in floquet.multipliers.iter().zip(&floquet.errors) {
            let off = (multiplier.re - exact * libm::cos(free * period)).abs();
            assert!(off <= *error && *error < 1e-9, "{text}: {off:e} {error:e}");
        }
        assert_eq!(floquet.stability, Stability::Attracting, "{text}");
    }
}

/// Reference by harmonic balance to the relative order 1e-24: with a = F/(1 − ν²), x(0) = a − a³ + a³/5. Free oscillations of twice the drive's
/// frequency hardly decay, so that because of rounding the start is uncertain in the seventh digit, as the stated error shows.
#[test]
fn a_weakly_damped_orbit_of_small_size_has_its_start() {
    let text = "x'' + 1e-9*x' + x + x^3 = 1e-6*cos(0.5*t)";
    let orbit = Orbit::driven(&equation(text), &[0.0, 0.0], 4.0 * PI, &Quiet).unwrap();
    let a = 4e-6 / 3.0;
    let exact = [a - 0.8 * a * a * a, 0.5 * a * (0.5e-9 / 0.75)];
    for ((start, error), exact) in orbit.start().iter().zip(orbit.start_errors()).zip(exact) {
        assert!((start - exact).abs() <= *error && *error < 2e-12, "{start:e} for {exact:e} to {error:e}");
    }
}

/// The amplitude of van der Pol's cycle for μ = 1 to 20 digits is that of M. Turbiner
/// and others; it is the value at the turning point of the first coordinate.
#[test]
fn extrema_are_those_of_the_motion() {
    let cycle = Orbit::limit_cycle(&equation("x'' = (1 - x^2)*x' - x"), &[0.5, 0.0], &Quiet).unwrap();
    let (low, high) = cycle.range(0);
    assert!((high - 2.008_619_860_874_843_1).abs() <= cycle.state_errors()[0], "{high:?}");
    assert!((low + high).abs() <= 2.0 * cycle.state_errors()[0] && cycle.state_errors()[0] < 1e-13);
    // The largest velocity is not at the end of a step: by quadrature of the exact pendulum it is 2·sin(θ0/2).
    let swing = released(PENDULUM, 1.0);
    let (slow, fast) = swing.range(1);
    assert!((fast - 2.0 * libm::sin(0.5)).abs() <= swing.state_errors()[1], "{fast:?}");
    assert_within(-slow, fast, 1e-15, "both ways");
}

/// A mass on a belt, whose friction decreases with the sliding speed so that
/// the equilibrium is unstable, sticks to the belt without coming to rest.
#[test]
fn a_mass_that_sticks_to_a_belt_does_not_come_to_rest() {
    let belt = |start: &[f64]| {
        let text = "x'' = -x + sign(0.5 - x')*(0.4 + 0.6*exp(-4*abs(0.5 - x')))";
        Orbit::limit_cycle(&equation(text), start, &Quiet).unwrap_err()
    };
    for start in [[1.0, 0.0], [0.41, 0.0], [0.0, 0.5]] {
        let error = belt(&start);
        eprintln!("{error}");
        assert!(!error.to_string().contains("comes to rest"), "{start:?}: {error}");
    }
}

/// The cases at each boundary: all multipliers inside the circle by more than their errors, one on it within its error in a contraction and in a
/// map that conserves volumes, one outside by less and by more than its error.
#[test]
fn stability_is_what_multipliers_establish_within_their_errors() {
    let of = |multipliers: &[(f64, f64)]| Stability::of(multipliers.iter().copied());
    let [inside, outside] = [1.0_f64.next_down(), 1.0_f64.next_up()];
    assert_eq!(of(&[]), Stability::Attracting);
    assert_eq!(of(&[(inside, 0.0), (0.5, 0.0)]), Stability::Attracting);
    assert_eq!(of(&[(outside, 0.0), (0.5, 0.0)]), Stability::Unstable);
    assert_eq!(of(&[(0.9, 0.1), (0.5, 1e-9)]), Stability::Undetermined);
    assert_eq!(of(&[(1.0, 1e-12), (1e-300, 1e-16)]), Stability::Undetermined);
    assert_eq!(of(&[(1.0, 1e-12), (0.0, 1e-16)]), Stability::Undetermined);
    assert_eq!(of(&[(1.0, 1e-12), (1.0, 1e-12)]), Stability::Neutral);
    assert_eq!(of(&[(1.0 + 5e-13, 1e-12), (1.0 - 6e-13, 1e-12)]), Stability::Neutral);
    assert_eq!(of(&[(1.0 + 2e-12, 1e-12), (1.0 - 2e-12, 1e-12)]), Stability::Unstable);
    assert_eq!(of(&[(0.5, f64::NAN), (0.5, 0.0)]), Stability::Undetermined);
    assert_eq!(of(&[(2.0, 0.1), (0.5, f64::NAN)]), Stability::Unstable);
}

/// The motion passes |x − 0.04|^1.5 twice in each period.
#[test]
fn a_driven_orbit_over_a_kink_with_a_power_is_found_soon() {
    let equation = "x'' + 0.2*x' + x + 2*max(x - 0.04, 0)^1.5 = 0.5*cos(1.26*t)".parse().unwrap();
    let orbit = Orbit::driven(&equation, &[1.4, 1.0], TAU / 1.26, &Quiet).unwrap();
    // By SciPy's DOP853 after 150 periods.
    let off = [orbit.start()[0] + 0.54277919, orbit.start()[1] - 2.38324195];
    assert!(off.iter().all(|off| off.abs() < 1e-6), "{off:?}");
}

/// Van der Pol's cycle together with a motion that comes to rest, in either order.
#[test]
fn a_coordinate_at_rest_hides_no_cycle() {
    for (resting, start) in
        [("x' = -x", vec![1.0, 0.5, 0.0]), ("x'' = -x - 0.5*x'", vec![1.0, 0.5, 0.0, 0.0])]
    {
        for text in
            [format!("{resting}; y'' = (1 - y^2)*y' - y"), format!("y'' = (1 - y^2)*y' - y; {resting}")]
        {
            let cycle = Orbit::limit_cycle(&equation(&text), &start, &Quiet).unwrap();
            assert_within(cycle.period(), 6.663_286_859_323_13, 1e-13, &text);
            assert_eq!(cycle.floquet().unwrap().stability, Stability::Attracting, "{text}");
        }
    }
    let at_rest = equation("x' = -x; y'' = -y - 0.5*y'");
    let outcome = Orbit::limit_cycle(&at_rest, &[1.0, 0.5, 0.0], &Quiet);
    assert_eq!(outcome.unwrap_err(), OrbitError::NoCycle(Lost::Rest));
}

/// Next to the saddle of a double well, where a start and its opposite are almost as close as the errors, which rounding on the way makes. From
/// x = 0 with the velocity v the period is 4 (1 + 2v²)^(−1/4) K(m), 1 − m = v²/(s² + s) with s² = 1 + 2v². One rounding on the way, 1e-16 of the
/// energy v²/2, changes it by 8e-16/v².
#[test]
fn an_orbit_past_a_saddle_has_its_whole_period_or_none() {
    let searched = |start: [f64; 2], period: Option<f64>| {
        let search = OrbitSearch { start: start.to_vec(), period, conserves_energy: true, held: None };
        Orbit::search(&equation("x'' = x - x^3"), &search, &Quiet)
    };
    for step in 0..60 {
        let velocity = 0.05 * libm::exp(-f64::from(step) / 7.0);
        let root = (1.0 + 2.0 * velocity * velocity).sqrt();
        let modulus = Modulus::from_complementary_parameter(velocity * velocity / (root * (1.0 + root)));
        let period = 4.0 / root.sqrt() * modulus.unwrap().first();
        for guess in [Some(period + 1.0), None] {
            let (_, orbit) = searched([0.0, velocity], guess).unwrap();
            let (off, stated) = ((orbit.period() - period).abs(), orbit.period_uncertainty());
            assert!(
                off <= stated && stated < 1e-13 / (velocity * velocity),
                "{velocity}: {off:e} {stated:e}"
            );
        }
    }
    // The energy is that of a velocity 7e-7 to 7e-11, which the digits of this start do not determine.
    for displacement in [1e-3, 1e-4, 1e-5] {
        assert!(searched([displacement, displacement], Some(50.0)).is_err(), "{displacement}");
    }
    // With the period between its turning points the first is known to its error (mpmath).
    let (_, orbit) = searched([1e-3, 1e-3], None).unwrap();
    assert!((orbit.period() - 63.579_808_398_57).abs() < orbit.period_uncertainty());
    for displacement in [1e-4, 1e-5] {
        assert!(searched([displacement, displacement], None).is_err(), "{displacement}");
    }
}

/// Below the kink the motion takes one step, in which the first component, the velocity, has a minimum and a maximum. Its period is exact:
/// half a turn with the frequency 1, from −a to a, plus the part above the kink.
#[test]
fn maxima_that_follow_a_minimum_in_the_same_step_are_seen() {
    for order in ["v' = -x - 3*max(x - b, 0); x' = v", "x' = v; v' = -x - 3*max(x - b, 0)"] {
        for kink in ["0.02", "0.1", "0.3"] {
            let placed = equation(order).with(&[("b", kink.parse().unwrap())]).unwrap();
            // The second component is at −1 where the velocity vanishes: below the kink the energy is 1/2.
            let start = if order.starts_with('v') { vec![0.0, -1.0] } else { vec![-1.0, 0.0] };
            let search = OrbitSearch { start, period: None, conserves_energy: false, held: None };
            let (kind, orbit) = Orbit::search(&placed, &search, &Quiet).unwrap();
            let b: f64 = kink.parse().unwrap();
            // Above it x = c + r cos(2t) with c = 3b/4 and 4r² = 1 + 4c² − 3b².
            let centre = 0.75 * b;
            let radius = (0.25 + centre * centre - centre * b).sqrt();
            let period = 2.0 * (PI - libm::acos(b)) + libm::acos((b - centre) / radius);
            assert_eq!(kind, OrbitKind::Family, "{order} {kink}");
            let off = (orbit.period() - period).abs();
            assert!(off <= orbit.period_uncertainty().max(1e-15), "{order} {kink}: {off:e}");
        }
    }
}

/// The period of a pendulum that passes the bottom with the velocity v is 4K(m) with m = v²/4; between two springs a distance 2a apart, where
/// no force acts, it is 4a/v + 2π/ω.
#[test]
fn a_start_that_moves_is_on_an_orbit_between_its_turning_points() {
    let searched = |text: &str, start: [f64; 2]| {
        let search = OrbitSearch { start: start.to_vec(), period: None, conserves_energy: true, held: None };
        Orbit::search(&equation(text), &search, &Quiet)
    };
    let is_exact = |text: &str, start: [f64; 2], period: f64| {
        let (kind, orbit) = searched(text, start).unwrap();
        assert_eq!((kind, orbit.start()), (OrbitKind::Family, start.to_vec()));
        let (off, stated) = ((orbit.period() - period).abs(), orbit.period_uncertainty());
        assert!(off <= stated && stated < 1e-11 * period, "{text} {start:?}: {off:e} {stated:e}");
    };
    for velocity in [1e-6, 0.1, -1.0, 1.9, -1.999] {
        let modulus = Modulus::from_parameter(0.25 * velocity * velocity).unwrap();
        is_exact("x'' = -sin(x)", [0.0, velocity], 4.0 * modulus.first());
        is_exact("x'' = -1e-12*sin(x)", [0.0, 1e-6 * velocity], 4e6 * modulus.first());
    }
    for [unit, velocity] in [[1.0, 1.0], [1.0, -1e-3], [1.0, 1e3], [1e-6, 1e-6], [1e6, -1e6]] {
        let text = format!("x'' = -16*max(x - {unit:?}, 0) - 16*min(x + {unit:?}, 0)");
        for start in [0.0, -0.25 * unit] {
            is_exact(&text, [start, velocity], 4.0 * unit / velocity.abs() + FRAC_PI_2);
        }
    }
    // Excited until it goes over the top.
    let search = OrbitSearch { start: vec![0.1, 0.0], period: None, conserves_energy: false, held: None };
    let refused = Orbit::search(&equation("x'' = x'/5 - x'^3/100 - sin(x)"), &search, &Quiet).unwrap_err();
    assert!(matches!(refused, OrbitError::NoCycle(Lost::GoesRound(time)) if time < 100.0), "{refused}");
    for start in [[0.0, 2.1], [3.0, -0.5]] {
        let refused = searched("x'' = -sin(x)", start).unwrap_err();
        assert!(matches!(refused, OrbitError::NoReturn { why: Lost::OneWay(_), .. }), "{refused}");
    }
    let refused = searched("x'' = x^3", [-1.0, 2.0]).unwrap_err();
    assert!(matches!(refused, OrbitError::NoReturn { why: Lost::Stopped(_), .. }), "{refused}");
}

/// 4e-4 rad/s above the drive frequency at which the upper response ends (1.27356), where the motion stays for dozens of periods. The values are
/// those of DOP853 and fsolve (SciPy 1.17.1).
#[test]
fn a_response_is_reached_past_the_end_of_another() {
    let text = "x'' + 0.141*x'*abs(x') + x + 0.879*x*abs(x) = 0.116*cos(1.274*t)";
    let orbit = Orbit::driven(&equation(text), &[-1.386, 0.0], TAU / 1.274, &Quiet);
    let start = orbit.unwrap().start();
    let off = libm::hypot(start[0] + 0.2745424178995959, start[1] - 0.044868219669804886);
    assert!(off < 1e-13, "{off:e}");
}

/// A component that never moves, before or after the others, with the equation z' = −z, z″ = −z − z'/10 or c' = 0, has no effect on the cycle.
#[test]
fn components_that_never_move_do_not_change_a_cycle() {
    let cycle = |text: &str, start: &[f64]| Orbit::limit_cycle(&equation(text), start, &Quiet).unwrap();
    let alone = cycle("x'' = (1 - x^2)*x' - x", &[0.5, 0.0]);
    for (text, start) in [
        ("x'' = (1 - x^2)*x' - x; z'' = -z - z'/10", vec![0.5, 0.0, 0.0, 0.0]),
        ("z'' = -z - z'/10; x'' = (1 - x^2)*x' - x", vec![0.0, 0.5, 0.0, 0.0]),
        ("z' = -z; x'' = (1 - x^2)*x' - x", vec![0.0, 0.5, 0.0]),
        ("x'' = (1 - x^2)*x' - x; c' = 0", vec![0.5, 1.0, 0.0]),
        ("c' = 0; x'' = (1 - x^2)*x' - x", vec![0.0, 0.5, 0.0]),
    ] {
        let beside = cycle(text, &start);
        assert_within(
            beside.period(),
            alone.period(),
            beside.period_uncertainty() + alone.period_uncertainty(),
            text,
        );
    }
    let rest = Orbit::limit_cycle(&equation("x'' = -x - x'; c' = 0"), &[0.0, 1.0, 0.0], &Quiet).unwrap_err();
    assert!(matches!(rest, OrbitError::NoCycle(Lost::Rest)), "{rest}");
}
