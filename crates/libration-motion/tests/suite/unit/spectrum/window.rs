use libration::internals::spectrum::bessel_i0;

/// Reference values by mpmath 1.3, `besseli(0, x)`.
#[test]
fn the_bessel_function_is_that_of_the_tables() {
    for (x, exact) in [(0.0, 1.0), (1.0, I0_OF_1), (8.0, I0_OF_8), (20.0, I0_OF_20)] {
        assert!((bessel_i0(x) / exact - 1.0).abs() < 1e-15, "{x}");
    }
}

const I0_OF_1: f64 = 1.2660658777520084;
const I0_OF_8: f64 = 427.5641157218048;
const I0_OF_20: f64 = 43558282.559553533;
