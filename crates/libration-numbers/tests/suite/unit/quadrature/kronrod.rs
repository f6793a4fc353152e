use libration::internals::quadrature::Rules;
use libration::quadrature::{Integral, gauss_kronrod};

#[test]
fn the_rules_integrate_the_powers_they_should() {
    for n in 0..=22_u32 {
        let rules = Rules::over(&mut |x| libm::pow(x, f64::from(n)), 0.0, 1.0);
        let exact = 1.0 / f64::from(n + 1);
        assert!((rules.kronrod - exact).abs() < 4e-16, "{n}: {}", rules.kronrod);
        assert!(n > 13 || (rules.gauss - exact).abs() < 4e-16, "{n}: {}", rules.gauss);
    }
}

/// The integral and the number of evaluations.
fn counted(f: impl Fn(f64) -> f64) -> (Integral, usize) {
    let mut count = 0;
    let integral = gauss_kronrod(|x| {
        count += 1;
        f(x)
    });
    (integral, count)
}

#[test]
fn hard_integrands_are_refined_and_endless_ones_given_up() {
    // ∫ dx/(1e-4 + x²) from 0 to 1.
    let exact = 100.0 * libm::atan(100.0);
    let (hard, _) = counted(|x| 1.0 / (1e-4 + x * x));
    assert!((hard.value / exact - 1.0).abs() < 1e-14 && hard.error == 0.0, "{hard:?}");
    assert!(counted(|x| 1.0 / (x - 1.0 / 3.0)).0.value.is_nan());
    assert!(counted(|x| libm::log(x - 0.5)).0.value.is_nan());
}

#[test]
fn kinks_roots_and_jumps_are_halved_down_to() {
    let (kink, _) = counted(|x| (x - 1.0 / 3.0).abs());
    assert!((kink.value - 5.0 / 18.0).abs() < 1e-15, "{kink:?}");
    let (root, _) = counted(f64::sqrt);
    assert!((root.value - 2.0 / 3.0).abs() < 1e-14, "{root:?}");
    let (jump, _) = counted(|x| if x < 1.0 / 3.0 { 0.0 } else { 1.0 });
    assert!((jump.value - 2.0 / 3.0).abs() <= jump.error.max(4e-16), "{jump:?}");
}

#[test]
fn noise_costs_little_and_is_told() {
    // Noise from the digits of x² after the tenth.
    let noise = |x: f64| 1e-10 * (libm::fmod(1e10 * x * x, 1.0) - 0.5);
    let (noisy, count) = counted(|x| 1.0 + noise(x));
    // Three halvings of every interval without gain, and those that gain by chance.
    assert!(count <= 15 * 60, "{count}");
    assert!((noisy.value - 1.0).abs() < 1e-10 && noisy.error > 1e-13 && noisy.error < 1e-8, "{noisy:?}");
}

#[test]
fn differences_count_against_the_size_of_the_function_not_of_its_integral() {
    // The integral of a whole wave about zero is zero, so no difference is small relative to it.
    let (wave, count) = counted(|x| libm::sin(std::f64::consts::TAU * (x + 0.1)));
    assert!(wave.value.abs() < 1e-15 && wave.error == 0.0, "{wave:?}");
    assert!(count <= 15 * 7, "{count}");
}
