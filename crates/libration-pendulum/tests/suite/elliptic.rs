//! Identities of the elliptic functions, which need no reference values.

use core::f64::consts::FRAC_PI_2;
use libration::elliptic::Modulus;
use libration::pendulum::Amplitude;
use libration::quantity::Angle;
use libration_testing::random::Random;
use libration_testing::ulp::ulp;

/// Moduli of every kind: of middle size, near 0, and near 1 down to k′ = 1e-300.
fn moduli(random: &mut Random) -> [Modulus; 5] {
    [
        Modulus::from_parameter(random.between(0.0, 1.0)).unwrap(),
        Modulus::from_parameter(random.log_between(-300.0, 0.0)).unwrap(),
        Modulus::from_complementary_parameter(random.log_between(-300.0, 0.0)).unwrap(),
        Modulus::from_complementary_modulus(random.log_between(-300.0, 0.0)).unwrap(),
        Modulus::from_modulus(random.between(0.0, 1.0)).unwrap(),
    ]
}

/// Arguments of every kind: within a few quarter periods, tiny, and up to 1e6 quarter periods.
fn arguments(random: &mut Random, quarter: f64) -> [f64; 3] {
    let size = quarter * random.log_between(0.0, 6.0);
    [quarter * random.between(-4.0, 4.0), random.log_between(-300.0, 0.0), -size]
}

fn sweep(seed: u64, mut check: impl FnMut(Modulus, f64)) {
    let mut random = Random::seeded(seed);
    for _ in 0..2000 {
        for modulus in moduli(&mut random) {
            arguments(&mut random, modulus.first()).into_iter().for_each(|u| check(modulus, u));
        }
    }
}

#[test]
fn squares_of_sn_and_cn_sum_to_one() {
    // Four ulp in each factor are at most 8·2⁻⁵² of the sum; the rounding of the sum adds one.
    sweep(1, |modulus, u| {
        let j = modulus.jacobi(u);
        assert!((j.sn * j.sn + j.cn * j.cn - 1.0).abs() <= 9.0 * f64::EPSILON, "{modulus:?} {u}: {j:?}");
    });
}

#[test]
fn dn_follows_from_sn_and_from_cn() {
    sweep(2, |modulus, u| {
        let j = modulus.jacobi(u);
        let (m, mc) = (modulus.parameter(), modulus.complementary_parameter());
        assert!((j.dn * j.dn + m * j.sn * j.sn - 1.0).abs() <= 10.0 * f64::EPSILON, "{modulus:?} {u}: {j:?}");
        let other = mc + m * j.cn * j.cn;
        assert!(
            (j.dn * j.dn - other).abs() <= 20.0 * f64::EPSILON * other + 1e-29 * u.abs(),
            "{modulus:?} {u}: {j:?}"
        );
    });
}

#[test]
fn jacobi_functions_stay_within_their_ranges() {
    sweep(3, |modulus, u| {
        let j = modulus.jacobi(u);
        assert!(j.sn.abs() <= 1.0 && j.cn.abs() <= 1.0, "{modulus:?} {u}: {j:?}");
        assert!(j.dn <= 1.0 && j.dn >= 0.0 && j.am.is_finite(), "{modulus:?} {u}: {j:?}");
    });
}

#[test]
fn jacobi_functions_are_numbers_until_their_bound_exceeds_their_range() {
    for m in [0.0, 5e-324, 1e-300, 0.5, 1.0 - f64::EPSILON / 2.0] {
        let modulus = Modulus::from_parameter(m).unwrap();
        // 2⁹⁹ K, up to the rounding of K.
        let limit = libm::exp2(99.0) * modulus.first();
        for u in [0.0, -0.0, 5e-324, 1e-308, 1e20, 6e27, limit * (1.0 - 1e-15)] {
            let j = modulus.jacobi(u);
            assert!(j.sn.abs() <= 1.0 && j.cn.abs() <= 1.0 && j.dn.abs() <= 1.0, "{m} {u}: {j:?}");
        }
        for u in [limit * (1.0 + 1e-15), -2.0 * limit, 1e100, 1e300, f64::MAX, -f64::MAX] {
            let j = modulus.jacobi(u);
            assert!(j.sn.is_nan() && j.cn.is_nan() && j.dn.is_nan(), "{m} {u}: {j:?}");
            let expected = FRAC_PI_2 * (u / modulus.first());
            assert!((j.am / expected - 1.0).abs() <= 4.0 * f64::EPSILON, "{m} {u}: {j:?}");
        }
        for u in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
            let j = modulus.jacobi(u);
            assert!(j.sn.is_nan() && j.cn.is_nan() && j.dn.is_nan() && j.am.is_nan(), "{m} {u}: {j:?}");
        }
    }
}

#[test]
fn the_limit_of_modulus_one_has_no_period_to_lose() {
    let line = Modulus::from_parameter(1.0).unwrap();
    for u in [1e28, 1e100, f64::MAX] {
        let j = line.jacobi(-u);
        assert_eq!((j.sn, j.cn, j.dn), (-1.0, 0.0, 0.0), "{u}");
    }
}

#[test]
fn jacobi_functions_of_zero_keep_its_sign() {
    for m in [0.0, 0.3, 0.5, 0.7, 1.0] {
        for zero in [0.0, -0.0_f64] {
            let j = Modulus::from_parameter(m).unwrap().jacobi(zero);
            assert_eq!([j.sn, j.am].map(f64::to_bits), [zero.to_bits(); 2], "{m} {zero}");
            assert_eq!((j.cn, j.dn), (1.0, 1.0), "{m} {zero}");
        }
    }
}

/// 1 − m = 16q′ for small q′, and ln q·ln q′ = π²: 1 − m is 2⁻⁵⁴ at q = exp(−π²/58 ln 2) = 0.78233….
#[test]
fn a_parameter_rounds_to_one_only_where_its_nome_is_above_0_7824() {
    let m = |nome| Modulus::from_nome(nome).unwrap().parameter();
    assert!(m(0.7823) < 1.0);
    assert_eq!(m(0.7824), 1.0);
}

#[test]
fn sn_and_am_are_odd_and_cn_and_dn_even_bit_for_bit() {
    sweep(4, |modulus, u| {
        let (here, there) = (modulus.jacobi(u), modulus.jacobi(-u));
        let mirrored = [-there.sn, there.cn, there.dn, -there.am];
        assert_eq!(
            [here.sn, here.cn, here.dn, here.am].map(f64::to_bits),
            mirrored.map(f64::to_bits),
            "{modulus:?} {u}"
        );
    });
}

#[test]
fn am_has_the_sine_sn_and_the_cosine_cn() {
    sweep(5, |modulus, u| {
        let j = modulus.jacobi(u);
        let slack = 4.0 * ulp(j.am) + 4.0 * f64::EPSILON;
        assert!((libm::sin(j.am) - j.sn).abs() <= slack, "{modulus:?} {u}: {j:?}");
        assert!((libm::cos(j.am) - j.cn).abs() <= slack, "{modulus:?} {u}: {j:?}");
    });
}

#[test]
fn incomplete_first_inverts_am() {
    sweep(6, |modulus, u| {
        let j = modulus.jacobi(u);
        // An ulp of am corresponds to 1/dn ulp of u; where dn is below an ulp, a rounded am does not determine u.
        let slack = 4.0 * ulp(u) + 8.0 * ulp(j.am) / j.dn;
        let back = modulus.incomplete_first(j.am);
        assert!(j.dn < 1e-9 || (back - u).abs() <= slack, "{modulus:?} {u}: {back}");
    });
}

#[test]
fn incomplete_integrals_are_odd_bit_for_bit_and_grow_by_two_quarters_in_half_a_turn() {
    let mut random = Random::seeded(12);
    for _ in 0..500 {
        for modulus in moduli(&mut random) {
            let phi = random.between(0.0, 40.0);
            for of in [Modulus::incomplete_first, Modulus::incomplete_second] {
                assert_eq!(of(&modulus, -phi).to_bits(), (-of(&modulus, phi)).to_bits(), "{phi}");
            }
            let (first, second) = (modulus.incomplete_first(FRAC_PI_2), modulus.incomplete_second(FRAC_PI_2));
            assert!(first <= modulus.first() && second <= modulus.second(), "{modulus:?}");
            // π/2 is rounded down by 6.2e-17; over this distance the integrands are at most 1/√(k′² + δ²) and 1.
            let missing = libm::asinh(6.2e-17 / modulus.complementary_modulus());
            assert!(modulus.first() - first <= ulp(modulus.first()) + 1.01 * missing, "{modulus:?}");
            assert!(modulus.second() - second <= ulp(second) + 6.2e-17, "{modulus:?}");
        }
    }
}

#[test]
fn incomplete_integrals_increase_through_every_odd_quarter() {
    for kc in [1e-300, 1e-20, 1e-8, 0.03, 0.7, 1.0] {
        let modulus = Modulus::from_complementary_modulus(kc).unwrap();
        for n in [1.0, 3.0, 5.0, 7.0, 11.0, 101.0, 100_001.0] {
            let mut phi = n * FRAC_PI_2;
            for _ in 0..6 {
                phi = phi.next_down();
            }
            for _ in 0..12 {
                let (here, next) = (modulus.incomplete_first(phi), modulus.incomplete_first(phi.next_up()));
                assert!(here <= next, "F at {phi}, k′ = {kc}: {here} {next}");
                let (here, next) = (modulus.incomplete_second(phi), modulus.incomplete_second(phi.next_up()));
                assert!(here <= next, "E at {phi}, k′ = {kc}: {here} {next}");
                phi = phi.next_up();
            }
        }
    }
}

#[test]
fn incomplete_integrals_of_the_limits_are_elementary() {
    let (circle, line) = (Modulus::from_parameter(0.0).unwrap(), Modulus::from_parameter(1.0).unwrap());
    for phi in [5e-324, 1e-310, 1e-8, 0.5, 1.5, 4.0, 1e5, 1e16, 1e18, 1e22, 1e300, f64::MAX] {
        assert_eq!((circle.incomplete_first(phi), circle.incomplete_second(phi)), (phi, phi), "{phi}");
        let expected = if phi > FRAC_PI_2 { f64::INFINITY } else { libm::atanh(libm::sin(phi)) };
        let got = line.incomplete_first(phi);
        assert!(got == expected || (got - expected).abs() <= 8.0 * ulp(expected), "{phi}: {got} {expected}");
    }
    // Two for every half turn, plus the sine of the rest.
    for (phi, expected) in [(0.5, libm::sin(0.5)), (3.0, 2.0 - libm::sin(3.0)), (-7.0, -4.0 - libm::sin(7.0))]
    {
        assert!((line.incomplete_second(phi) - expected).abs() <= 2.0 * ulp(expected), "{phi}");
    }
    let steep = Modulus::from_complementary_modulus(1e-300).unwrap();
    assert_eq!(steep.incomplete_first(f64::MAX), f64::INFINITY);
    for modulus in [circle, line, steep] {
        for phi in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(
                modulus.incomplete_first(phi).is_nan() && modulus.incomplete_second(phi).is_nan(),
                "{phi}"
            );
        }
        assert!(modulus.incomplete_first(-0.0).is_sign_negative());
    }
}

#[test]
fn moduli_and_parameters_are_the_sides_of_a_right_triangle() {
    let mut random = Random::seeded(13);
    for _ in 0..500 {
        for modulus in moduli(&mut random) {
            let (k, kc) = (modulus.modulus(), modulus.complementary_modulus());
            // Each side and each square is rounded once.
            assert!((k * k + kc * kc - 1.0).abs() <= 2.0 * f64::EPSILON, "{modulus:?}");
            assert!((modulus.parameter() - k * k).abs() <= 2.0 * ulp(k * k), "{modulus:?}");
            assert!((modulus.complementary_parameter() - kc * kc).abs() <= 2.0 * ulp(kc * kc), "{modulus:?}");
        }
        let m = random.log_between(-323.0, 0.0);
        assert_eq!(Modulus::from_parameter(m).unwrap().parameter(), m);
        assert_eq!(Modulus::from_complementary_parameter(m).unwrap().complementary_parameter(), m);
    }
}

#[test]
fn complete_integrals_satisfy_legendres_relation() {
    let mut random = Random::seeded(7);
    for _ in 0..5000 {
        let m = random.between(0.0, 1.0);
        let (one, other) =
            (Modulus::from_parameter(m).unwrap(), Modulus::from_complementary_parameter(m).unwrap());
        let terms =
            [one.second() * other.first(), other.second() * one.first(), -one.first() * other.first()];
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        let residual = terms.iter().sum::<f64>() - FRAC_PI_2;
        assert!(residual.abs() <= 5.0 * f64::EPSILON * size, "{m}: {residual}");
    }
}

#[test]
fn complementary_moduli_share_their_quarter_periods() {
    let mut random = Random::seeded(8);
    for _ in 0..5000 {
        let kc = random.log_between(-300.0, 0.0);
        let (one, other) =
            (Modulus::from_complementary_modulus(kc).unwrap(), Modulus::from_modulus(kc).unwrap());
        assert!((one.first() - other.complementary_first()).abs() <= 2.0 * ulp(one.first()), "{kc}");
        assert!((one.complementary_first() - other.first()).abs() <= 2.0 * ulp(other.first()), "{kc}");
    }
}

#[test]
fn nome_survives_the_round_trip() {
    let mut random = Random::seeded(9);
    for _ in 0..5000 {
        for q in [random.between(0.0, 0.9), random.log_between(-323.3, -0.1)] {
            // The moduli in between have two words.
            let back = Modulus::from_nome(q).unwrap().nome();
            assert!((back - q).abs() <= ulp(q), "{q}: {back}");
        }
    }
}

#[test]
fn nome_gives_the_quarter_periods_by_theta_series() {
    // K = (π/2) θ₃(q)², K′/K = −ln q/π (DLMF 20.9.2, 22.2.1).
    let mut random = Random::seeded(10);
    for _ in 0..2000 {
        let q = random.between(1e-9, 0.6);
        let theta_3 = 1.0 + 2.0 * (1..20).map(|n| libm::pow(q, f64::from(n * n))).sum::<f64>();
        let modulus = Modulus::from_nome(q).unwrap();
        let expected = FRAC_PI_2 * theta_3 * theta_3;
        assert!((modulus.first() - expected).abs() <= 16.0 * ulp(expected), "{q}");
        let ratio = modulus.complementary_first() / modulus.first();
        let from_nome = -libm::log(q) / core::f64::consts::PI;
        assert!((ratio - from_nome).abs() <= 16.0 * ulp(from_nome), "{q}");
    }
}

#[test]
fn limits_are_circular_and_hyperbolic() {
    let (circle, line) = (Modulus::from_parameter(0.0).unwrap(), Modulus::from_parameter(1.0).unwrap());
    assert_eq!(circle.first(), FRAC_PI_2);
    assert_eq!(circle.second(), FRAC_PI_2);
    assert_eq!(line.first(), f64::INFINITY);
    assert_eq!(line.second(), 1.0);
    assert_eq!((circle.nome(), line.nome()), (0.0, 1.0));
    let mut random = Random::seeded(11);
    for _ in 0..2000 {
        let u = random.between(-30.0, 30.0);
        let (trigonometric, hyperbolic) = (circle.jacobi(u), line.jacobi(u));
        assert!((trigonometric.sn - libm::sin(u)).abs() <= 6.0 * ulp(libm::sin(u)), "{u}");
        assert_eq!(trigonometric.dn, 1.0);
        assert!((hyperbolic.sn - libm::tanh(u)).abs() <= 6.0 * ulp(libm::tanh(u)), "{u}");
        assert!((hyperbolic.cn - 1.0 / libm::cosh(u)).abs() <= 6.0 * ulp(hyperbolic.cn), "{u}");
    }
}

#[test]
fn what_is_no_modulus_is_refused() {
    for bad in [f64::NAN, f64::INFINITY, -0.1, 1.0 + f64::EPSILON] {
        assert!(Modulus::from_parameter(bad).is_err(), "{bad}");
        assert!(Modulus::from_complementary_parameter(bad).is_err(), "{bad}");
        assert!(Modulus::from_modulus(bad).is_err(), "{bad}");
        assert!(Modulus::from_complementary_modulus(bad).is_err(), "{bad}");
        assert!(Modulus::from_nome(bad).is_err(), "{bad}");
    }
}

/// Nomes close to the middle between two `f64`, where a sum with an error of 2⁻⁵⁷ was rounded to the wrong one. The values by mpmath with 25
/// digits are 0.04424913562595738160167671 and 0.1599059317606499746002681.
#[test]
fn nomes_of_swings_beyond_a_right_angle_are_rounded_from_two_words() {
    let nome = |radians| Amplitude::new(Angle::from_radians(radians).unwrap()).unwrap().nome();
    assert_eq!(nome(1.5873491223508147), 0.04424913562595738);
    assert_eq!(nome(2.6029067065030853), 0.15990593176064996);
}
