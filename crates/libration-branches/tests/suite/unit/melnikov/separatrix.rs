use libration::internals::melnikov::{power, sech_power};

#[test]
fn powers_of_the_secant_are_integrated_as_a_sum_of_values_is() {
    for n in 1..8 {
        for w in [0.0, 0.3, 2.0] {
            let of = |t: f64| power(1.0 / libm::cosh(t), n) * libm::cos(w * t);
            let sum: f64 = (-800..=800).map(|j| 0.05 * of(0.05 * f64::from(j))).sum();
            assert!((sum - sech_power(n, w)).abs() < 1e-14, "{n} {w}: {sum}");
        }
    }
}
