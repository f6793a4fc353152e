//! The probability of a sum of squares as large as this by chance.

use libration_lab::internals::statistics::chi_squared::probability_beyond;

/// mpmath: `gammainc(dof/2, chi2/2, regularized=True)`; the first two are erfc(1) and e^-1.
#[test]
fn the_tails_are_those_of_the_tables() {
    for (chi2, dof, expected) in [
        (2.0, 1, 0.157299207050285131),
        (2.0, 2, 0.367879441171442322),
        (7.815, 3, 0.049993902974883887),
        (199.0, 10, 2.60863567141581646e-37),
        (42.380483, 39, 0.327336247259022537),
        (60.0, 99, 0.999319997049848576),
        (1000.0, 1000, 0.494052853829239642),
        (3000.0, 1000, 1.64368458435695434e-198),
        (1e-3, 5, 0.999999998318512281),
    ] {
        let computed = probability_beyond(chi2, dof);
        assert!((computed - expected).abs() < 1e-12, "{chi2} {dof}: {computed}");
    }
    assert!(probability_beyond(0.0, 3) >= 1.0);
}
