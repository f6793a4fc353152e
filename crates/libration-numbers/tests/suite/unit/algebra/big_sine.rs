use dashu_base::BitTest;
use dashu_float::{FBig, round::mode::HalfEven};
use dashu_int::IBig;
use libration::algebra::BigFloat;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

type Float = FBig<HalfEven, 2>;

/// The same number in the library that computes the references.
fn float(x: &BigFloat, bits: usize) -> Float {
    let fraction = x.to_rational().to_string();
    let (numerator, denominator) = fraction.split_once('/').unwrap_or((&fraction, "1"));
    let whole = |text: &str| Float::from(text.parse::<IBig>().unwrap()).with_precision(bits).value();
    whole(numerator) / whole(denominator)
}

/// Small angles, angles in all quadrants and next to multiples of π/2, and angles beyond the reduction.
#[test]
fn sine_and_cosine_have_all_digits() {
    let small = [1.0, 0.999, 0.78, -0.5, 0.03125, 1e-5, -1e-30, 1e-300, 0.0];
    let beside = [FRAC_PI_2, PI, TAU, 355.0, -1.5 * PI, 1.0_f64.next_up(), 1e6 * PI];
    let others = [1.3, -2.5, 4.0, 5.6, -100.0, 1e9, -1e18, 18_446_744_073_709_551_616.0, 1e22, -1e40];
    let eighths = (-40..40).map(|n| f64::from(n) * 0.25 * FRAC_PI_2);
    for (bits, slack) in [(64, 4), (144, 4), (208, 4), (1216, 5)] {
        let drawn = small.into_iter().chain(beside).chain(others).chain(eighths.clone());
        let drawn = drawn.map(|x| BigFloat::from_f64(x, bits).unwrap());
        // All bits of π, and all but some.
        let pi = [bits, bits - 20, bits - 40].map(|kept| BigFloat::pi(kept).rounded_to(bits));
        let turns = pi.clone().map(|pi| pi.clone() + pi.halved());
        for x in drawn.chain(pi).chain(turns) {
            assert_eq!(x.sin_cos(), (x.sin(), x.cos()));
            let wide = float(&x, bits + 300);
            for (computed, exact) in [(x.sin(), wide.sin()), (x.cos(), wide.cos())] {
                assert_eq!(computed.precision(), bits);
                let size = |value: &Float| {
                    value.repr().exponent() + value.repr().significand().bit_len().cast_signed()
                };
                let off = float(&computed, bits + 300) - exact.clone();
                let allowed = size(&exact) + slack - bits.cast_signed();
                let is_exact = off.repr().significand().is_zero();
                assert!(is_exact || size(&off) <= allowed, "{x:?} {bits}: {} {allowed}", size(&off));
            }
        }
    }
}
