//! The harmonics: their sum is the motion, and they satisfy the laws of the closed form.

use core::f64::consts::PI;
use libration::pendulum::{FourierSeries, Motion, Pendulum, Regime};
use libration::quantity::Angle;
use libration_testing::random::Random;

fn unit_pendulum() -> Pendulum {
    Pendulum::from_angular_frequency(1.0).unwrap()
}

fn libration(amplitude: f64) -> Motion {
    unit_pendulum().released_from(Angle::from_radians(amplitude).unwrap()).unwrap()
}

fn rotation(velocity: f64) -> Motion {
    unit_pendulum().launched(Angle::from_radians(0.0).unwrap(), velocity).unwrap()
}

/// The sum of the harmonics at `time`, counted from the positive turning point (cos) or from the bottom (sin).
fn sum(harmonics: &FourierSeries, time: f64, periodic: fn(f64) -> f64) -> f64 {
    let term = |n: usize| f64::from(u32::try_from(n).unwrap()) * harmonics.fundamental * time;
    let terms = harmonics.terms.iter().map(|harmonic| harmonic.angle * periodic(term(harmonic.n)));
    harmonics.mean_velocity * time + terms.sum::<f64>()
}

#[test]
fn harmonics_of_a_libration_sum_to_its_motion() {
    let mut random = Random::seeded(1);
    for _ in 0..300 {
        let (amplitude, time) = (random.between(0.001, 3.1), random.between(0.0, 20.0));
        let harmonics = libration(amplitude).harmonics(1e-17, 1000);
        let expected = libration(amplitude).state_at(time).angle;
        assert!((sum(&harmonics, time, libm::cos) - expected).abs() <= 1e-13, "{amplitude} {time}");
    }
}

#[test]
fn harmonics_of_a_rotation_sum_to_its_motion() {
    let mut random = Random::seeded(2);
    for _ in 0..300 {
        let (velocity, time) = (random.between(2.001, 20.0), random.between(0.0, 20.0));
        let harmonics = rotation(velocity).harmonics(1e-17, 1000);
        let expected = rotation(velocity).state_at(time).angle;
        assert!((sum(&harmonics, time, libm::sin) - expected).abs() <= 1e-12, "{velocity} {time}");
    }
}

#[test]
fn harmonics_of_any_motion_sum_to_it_from_their_epoch() {
    let mut random = Random::seeded(3);
    for _ in 0..300 {
        let (angle, velocity, time) =
            (random.between(-3.0, 3.0), random.between(-1.5, 1.5), random.between(-20.0, 20.0));
        let motion = unit_pendulum().launched(Angle::from_radians(angle).unwrap(), velocity).unwrap();
        if motion.regime() == Regime::Libration && motion.energy_ratio() < 0.999 {
            let harmonics = motion.harmonics(1e-17, 1000);
            let computed = sum(&harmonics, time - harmonics.epoch, libm::cos);
            assert!((computed - motion.state_at(time).angle).abs() <= 1e-12, "{angle} {velocity} {time}");
        }
    }
}

#[test]
fn harmonics_of_a_libration_are_odd_alternate_and_fall() {
    for amplitude in [1e-6, 0.1, 1.0, 2.0, 3.0, 3.14] {
        let terms = libration(amplitude).harmonics(1e-15, 1000).terms;
        for pair in terms.windows(2) {
            assert_eq!(pair[1].n, pair[0].n + 2, "{amplitude}");
            assert!(
                pair[0].angle * pair[1].angle < 0.0 && pair[1].angle.abs() < pair[0].angle.abs(),
                "{amplitude}"
            );
        }
        assert_eq!(terms[0].n, 1);
    }
}

#[test]
fn a_velocity_harmonic_is_its_angle_harmonic_times_its_frequency() {
    for amplitude in [1e-6, 0.1, 1.0, 2.0, 3.0, 3.14] {
        let harmonics = libration(amplitude).harmonics(1e-15, 1000);
        for term in &harmonics.terms {
            let expected = f64::from(u32::try_from(term.n).unwrap()) * harmonics.fundamental * term.angle;
            assert!(
                (term.velocity.abs() / expected.abs() - 1.0).abs() <= 8.0 * f64::EPSILON,
                "{amplitude} {}",
                term.n
            );
        }
    }
}

#[test]
fn harmonics_next_to_the_top_approach_four_over_n() {
    // cosh(nπK′/2K) → 1 as K → ∞: a_n → 4(−1)^((n−1)/2)/n.
    let motion = unit_pendulum().released_from(Angle::from_complement(1e-300).unwrap()).unwrap();
    for term in motion.harmonics(1e-12, 5).terms {
        let n = f64::from(u32::try_from(term.n).unwrap());
        assert!((term.angle.abs() * n / 4.0 - 1.0).abs() <= 1e-5 * n * n, "{n}");
    }
}

#[test]
fn harmonics_keep_to_their_tolerance_and_their_limit() {
    let motion = libration(3.0);
    assert_eq!(motion.harmonics(1e-15, 7).terms.len(), 7);
    assert!(motion.harmonics(1e-6, 1000).terms.iter().all(|term| term.angle.abs() >= 1e-6));
    let more = motion.harmonics(1e-9, 1000).terms.len();
    assert!(more > motion.harmonics(1e-6, 1000).terms.len());
}

#[test]
fn the_fundamental_is_the_frequency_of_the_motion() {
    for motion in [libration(0.5), libration(3.0), rotation(2.5), rotation(-7.0)] {
        let fundamental = motion.harmonics(1e-12, 100).fundamental;
        assert!((fundamental * motion.period() / (2.0 * PI) - 1.0).abs() <= 4.0 * f64::EPSILON);
    }
}

/// The amplitude in (low, high) at which an increasing function of the harmonics equals one.
fn where_one(low: f64, high: f64, of: impl Fn(&FourierSeries) -> f64) -> f64 {
    let (mut low, mut high) = (low, high);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let passed = of(&libration(middle).harmonics(0.0, 2)) > 1.0;
        (low, high) = if passed { (low, middle) } else { (middle, high) };
    }
    0.5 * (low + high)
}

/// The reference values come from the same 50-digit root finding as the other claims of `tests/data/formulas_claims.csv`.
#[test]
fn the_third_harmonic_is_not_small_next_to_the_top() {
    let tenth = where_one(2.0, 3.0, |series| series.terms[1].angle.abs() / 0.1);
    assert!((tenth - 2.31510063692584016183797860615).abs() < 1e-12, "{tenth}");
    let product = where_one(2.0, 3.1, |series| (series.terms[0].angle * series.terms[1].angle).abs());
    assert!((product - 2.89776545350273670491012503848).abs() < 1e-12, "{product}");
}

/// Terms below 1e-308 continue to fall as e^(−x) among the subnormal numbers down to zero; no term follows after that.
#[test]
fn harmonics_end_where_numbers_do() {
    for amplitude in [1.0, 2.5, 3.1, 3.141_592] {
        let terms = libration(amplitude).harmonics(0.0, 100_000).terms;
        let last = terms.last().unwrap();
        assert!(
            terms.len() < 100_000 && last.angle.abs() < 1e-300,
            "{amplitude}: {} to {last:?}",
            terms.len()
        );
        assert!(terms.windows(2).all(|two| two[1].angle.abs() <= two[0].angle.abs()), "{amplitude}");
    }
}
