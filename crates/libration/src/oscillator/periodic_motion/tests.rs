//! Periodic motions beside closed forms and quadratures of many digits.

use super::*;
use crate::oscillator::NamedOscillator;

fn named(key: &str) -> Oscillator {
    NamedOscillator::by_key(key).unwrap().oscillator(&[]).unwrap()
}

fn assert_close(value: f64, expected: f64, relative: f64, what: &str) {
    let error = (value / expected - 1.0).abs();
    assert!(error <= relative, "{what}: {value} is not {expected} but {error:e} off");
}

/// Quadratures of the energy integral by mpmath with 60 digits: key, largest displacement, period.
const PERIODS: [(&str, f64, f64); 16] = [
    ("pendulum", 0.5, 6.382_789_697_677_741),
    ("pendulum", 2.0, 8.349_752_926_918_494),
    ("pendulum", 3.0, 16.155_539_372_393_38),
    ("duffing", 0.1, 6.259_762_302_133_396),
    ("duffing", 1.0, 4.768_022_029_102_461),
    ("duffing", 10.0, 0.736_288_960_821_622_4),
    ("cubic_quintic", 0.5, 5.678_204_877_431_071),
    ("cubic_quintic", 10.0, 0.083_578_113_293_987_04),
    ("x_over_sqrt", 1.0, 7.202_659_250_423_907),
    ("x_over_sqrt", 10.0, 17.997_440_233_949_108),
    ("sinh", 1.0, 5.911_611_295_076_775),
    ("sinh", 5.0, 2.096_895_928_725_085_6),
    ("duffing_soft", 0.5, 6.978_326_992_083_981),
    ("quadratic", 0.05, 6.289_976_634_221_316),
    ("quadratic", 0.1, 6.311_599_097_216_832),
    ("mathews_lakshmanan", 1.0, 8.885_765_876_316_732),
];

#[test]
fn periods_are_those_of_the_energy_integral() {
    for (key, x_max, period) in PERIODS {
        let motion = PeriodicMotion::from_turning_point(&named(key), x_max).unwrap();
        assert_close(motion.period(), period, 1e-13, &format!("{key} from {x_max}"));
    }
}

/// x'² = ⅔(A − x)(x − b)(x − c) of the quadratic oscillator gives T = √6·π/agm(√(A − c), √(b − c)).
fn quadratic_period(x_max: f64) -> f64 {
    let p = 3.0 + 2.0 * x_max;
    let root = (p * (p - 8.0 * x_max)).sqrt();
    let (b, c) = ((root - p) / 4.0, (-root - p) / 4.0);
    let (mut greater, mut lesser) = ((x_max - c).sqrt(), (b - c).sqrt());
    for _ in 0..8 {
        (greater, lesser) = (0.5 * (greater + lesser), (greater * lesser).sqrt());
    }
    6.0_f64.sqrt() * std::f64::consts::PI / greater
}

#[test]
fn no_amplitude_is_left_out() {
    for step in 1..1200 {
        let x_max = 0.4 * f64::from(step) / 1200.0;
        let motion = PeriodicMotion::from_turning_point(&named("quadratic"), x_max).unwrap();
        assert_close(motion.period(), quadratic_period(x_max), 2e-14, &format!("from {x_max}"));
    }
}

#[test]
fn the_other_turning_point_of_an_asymmetric_well_is_found() {
    let motion = PeriodicMotion::from_turning_point(&named("quadratic"), 0.1).unwrap();
    assert_close(motion.x_min().unwrap(), -0.107_179_676_972_449_08, 1e-13, "x_min");
    assert_close(motion.x_max(), 0.1, 1e-15, "x_max");
}

/// By a Taylor method of order 55 with 260 bits: strength, period.
const VAN_DER_POL: [(f64, f64); 6] = [
    (0.01, 6.283_224_576_985_483),
    (0.1, 6.287_111_272_288_727),
    (-0.1, 6.287_111_272_288_727),
    (0.5, 6.380_675_801_773_586),
    (1.0, 6.663_286_859_323_13),
    (2.0, 7.629_874_479_674_842),
];

#[test]
fn limit_cycles_are_found() {
    for (mu, period) in VAN_DER_POL {
        let motion = PeriodicMotion::limit_cycle(&named("van_der_pol"), mu, 2.0).unwrap();
        assert_close(motion.period(), period, 1e-12, &format!("mu = {mu}"));
    }
}

/// a₃ = −4/(3·cosh(3πK′/2K)) for the pendulum at 2 rad, by mpmath.
#[test]
fn harmonics_are_those_of_the_pendulum() {
    use crate::pendulum::Pendulum;
    let angle = crate::quantity::Angle::from_radians(2.0).unwrap();
    let exact = Pendulum::from_angular_frequency(1.0).unwrap().released_from(angle).unwrap();
    let motion = PeriodicMotion::from_turning_point(&named("pendulum"), 2.0).unwrap();
    for term in exact.harmonics(1e-9, 20).terms {
        assert!((motion.cosine(term.n) - term.angle).abs() < 2e-14, "{}", term.n);
        assert!(motion.cosine(term.n + 1).abs() < 2e-14);
    }
}

#[test]
fn motions_that_do_not_return_are_refused() {
    let from = |key, x| PeriodicMotion::from_turning_point(&named(key), x).unwrap_err();
    assert_eq!(from("quadratic", 0.6), NoPeriodicMotion::NoReturn(0.6));
    assert_eq!(from("duffing_soft", 1.5), NoPeriodicMotion::NotRestoring(1.5));
    assert!(matches!(from("duffing", f64::NAN), NoPeriodicMotion::Amplitude(_)));
    assert_eq!(from("van_der_pol", 1.0), NoPeriodicMotion::OtherKind);
    assert!(PeriodicMotion::limit_cycle(&named("van_der_pol"), 0.0, 2.0).is_err());
    assert!(PeriodicMotion::limit_cycle(&named("duffing"), 1.0, 2.0).is_err());
}

#[test]
fn displacements_count_from_the_equilibrium() {
    let motion = |equation: &str, from: f64| {
        let oscillator = Oscillator::new(&equation.parse().unwrap()).unwrap();
        PeriodicMotion::from_turning_point(&oscillator, from).unwrap()
    };
    let harmonic = motion("x'' = -4*(x - 3)", 0.5);
    for time in [0.0, 0.3, 1.0, 1.5, 2.0, 3.0, 3.14] {
        let exact = 0.5 * libm::cos(2.0 * time);
        assert!((harmonic.displacement_at(time) - exact).abs() < 1e-13, "{time}");
    }
    let swing = motion("x'' = -x - x^2", 0.3);
    let half = swing.displacement_at(0.5 * swing.period());
    assert!((half - swing.x_min().unwrap()).abs() < 1e-15 && half < -0.3);
}
