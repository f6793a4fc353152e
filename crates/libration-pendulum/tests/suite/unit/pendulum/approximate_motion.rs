use libm::{cos, fabs, pow, sin};
use libration::internals::pendulum::{FREQUENCY, HARMONICS};
use libration::pendulum::{ApproximateMotion, ApproximateMotionError};

/// The largest |θ″ + ω0²·sin θ| over a period, at ω0 = 1.
fn residual(motion: ApproximateMotion, amplitude: f64) -> f64 {
    let frequency = motion.frequency_ratio(amplitude);
    let coefficients = motion.coefficients(amplitude);
    let at = |k: i32| {
        let phase = f64::from(k) * 0.01;
        let multiples = [1.0, 3.0, 5.0, 7.0];
        let acceleration: f64 = coefficients
            .iter()
            .zip(multiples)
            .map(|(a, n)| -a * n * n * frequency * frequency * cos(n * frequency * phase))
            .sum();
        fabs(acceleration + sin(motion.angle(amplitude, phase)))
    };
    (0..628).map(at).fold(0.0, f64::max)
}

#[test]
fn each_motion_satisfies_the_equation_of_motion_to_its_order() {
    for (motion, order) in ApproximateMotion::CATALOGUE.into_iter().zip([3.0, 5.0, 7.0, 9.0]) {
        let ratio = residual(motion, 0.4) / residual(motion, 0.2);
        let expected = pow(2.0, order);
        assert!(fabs(ratio / expected - 1.0) < 0.1, "{}: {ratio} for {expected}", motion.key());
    }
}

#[test]
fn each_motion_starts_at_the_amplitude_to_its_order() {
    for motion in ApproximateMotion::CATALOGUE {
        let start: f64 = motion.coefficients(0.5).iter().sum();
        assert!(fabs(start - 0.5) < 1e-15, "{}: {start}", motion.key());
    }
}

/// Coefficients of θ0⁷ in the exact harmonics and of θ0⁶ in the exact frequency, computed with FLINT from the nome and from the Legendre
/// function.
#[test]
fn the_highest_coefficients_are_those_of_the_exact_harmonics() {
    let exact = [(1487.0, 82575360.0), (-133.0, 5898240.0), (1.0, 196608.0), (-1.0, 1835008.0)];
    assert_eq!(HARMONICS.map(|harmonic| harmonic[3]), exact);
    assert_eq!(FREQUENCY[3], (-23.0, 737280.0));
}

#[test]
fn an_unknown_key_is_refused() {
    assert!(ApproximateMotion::by_key("fourier-4").is_err());
}

#[test]
fn only_a_release_from_rest_below_the_top_has_an_amplitude() {
    let of = |angle: &str, velocity| ApproximateMotion::amplitude_of(&angle.parse().unwrap(), velocity);
    assert_eq!(of("-1.25", 0.0), Ok(-1.25));
    assert_eq!(of("1.25", 1e-300), Err(ApproximateMotionError::NotFromRest(1e-300)));
    assert!(matches!(of("180deg", 0.0), Err(ApproximateMotionError::BeyondUpright(_))));
    assert!(matches!(of("370deg", 0.0), Err(ApproximateMotionError::BeyondUpright(_))));
}
