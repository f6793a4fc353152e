use libration::algebra::BigFloat;

/// Arguments for both methods: the series, and the reduction to a quadrant.
#[test]
fn sine_and_cosine_are_those_of_the_functions() {
    for (bits, slack) in [(144, 4), (208, 4), (1216, 5)] {
        for x in [1.0, 0.999, 0.78, -0.5, 0.03125, 1e-5, -1e-30, 1e-300, 0.0] {
            let x = BigFloat::from_f64(x, bits).unwrap();
            let (sine, cosine) = x.sin_cos();
            let wide = x.rounded_to(bits + 64);
            for (computed, exact) in [(sine, wide.sin()), (cosine, wide.cos())] {
                let off = (computed - exact.clone()).exponent();
                let allowed = exact.exponent().map(|e| e + slack - isize::try_from(bits).unwrap());
                assert!(off.is_none() || off <= allowed, "{x:?} {bits}: {off:?} {allowed:?}");
            }
        }
    }
    let beyond = BigFloat::from_f64(2.5, 144).unwrap();
    assert_eq!(beyond.sin_cos(), (beyond.sin(), beyond.cos()));
}
