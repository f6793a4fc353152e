//! The harmonics of a pendulum whose first harmonic is known.

use libration_lab::internals::fit::spectrum::theory::{Growth, Theory};
use libration_lab::internals::statistics::count;
use libration_lab::measurement::Observable;

/// Amplitude, frequency for ω0 = 1 and coefficients 1, 3, 5, 7 by mpmath, as `reference/fourier.py` computes them.
const EXACT: [(f64, f64, [f64; 4]); 3] = [
    (
        2.094_395_102_393_195_5,
        0.728_395_515_523_453_5,
        [
            2.158_115_591_616_902_9,
            -0.066_971_971_806_469_6,
            0.003_449_706_882_651_65,
            -0.000_211_408_213_424_002_55,
        ],
    ),
    (
        3.0,
        0.388_918_324_690_310_8,
        [
            3.352_945_372_371_093_9,
            -0.415_048_468_592_396_14,
            0.074_975_886_902_993_77,
            -0.015_789_589_202_077_41,
        ],
    ),
    (
        3.124_139_361_069_85,
        0.256_340_245_262_722_29,
        [
            3.696_272_576_237_617_6,
            -0.731_480_924_816_066_4,
            0.209_925_426_712_089_64,
            -0.067_970_156_879_745_2,
        ],
    ),
];

#[test]
fn the_swing_with_a_first_harmonic_has_the_exact_others() {
    for (amplitude, frequency, exact) in EXACT {
        let angle = Theory::new(exact[0], frequency, Observable::Angle, 8).unwrap();
        let velocity = Theory::new(exact[0] * frequency, frequency, Observable::AngularVelocity, 8).unwrap();
        for theory in [&angle, &velocity] {
            assert!((theory.amplitude - amplitude).abs() < 1e-11, "{}", theory.amplitude);
            assert!(theory.coefficients.iter().step_by(2).all(|even| even.abs() < f64::MIN_POSITIVE));
        }
        for (k, exact) in exact.into_iter().enumerate() {
            let n = 2 * k + 1;
            assert!((angle.coefficients[n] - exact).abs() < 1e-10, "{n}: {}", angle.coefficients[n]);
            let speed = count(n) * frequency * exact.abs();
            assert!((velocity.coefficients[n] - speed).abs() < 1e-10, "{n}: {}", velocity.coefficients[n]);
        }
    }
}

/// a₃ = −A³/192 and a₁ = A + A³/192 for small A (here to 1e-4 of themselves).
#[test]
fn the_third_harmonic_of_small_swings_grows_as_the_third_power() {
    let theory = Theory::new(0.02, 1.0, Observable::Angle, 4).unwrap();
    assert!((theory.growth(3).power - 3.0).abs() < 1e-3 && theory.growth(2) == Growth::by_number(2));
    assert!((theory.slopes[3] / (-0.02 * 0.02 / 64.0) - 1.0).abs() < 1e-3, "{}", theory.slopes[3]);
    assert!((theory.amplitude_slope - 1.0).abs() < 1e-4);
}

#[test]
fn harmonics_of_larger_swings_are_those_of_the_parabola() {
    let [here, more] = [1.0, 1.2].map(|first| Theory::new(first, 1.0, Observable::Angle, 5).unwrap());
    for n in [3, 5] {
        let exact = more.coefficients[n] / here.coefficients[n];
        assert!((here.growth(n).size(1.2) / exact - 1.0).abs() < 1e-3, "{n}: {exact}");
    }
}

#[test]
fn no_swing_has_a_first_harmonic_of_four() {
    for first in [4.0, 3.99, 1e300, 0.0, -1.0, f64::NAN] {
        assert!(Theory::new(first, 1.0, Observable::Angle, 3).is_none(), "{first}");
    }
}
