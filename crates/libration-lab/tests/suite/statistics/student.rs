//! The probability of a coefficient as far from zero as this by chance, and its quantiles.

use libration_lab::internals::statistics::student::{probability_beyond, quantile};

/// mpmath: the root of `betainc(dof/2, 1/2, 0, dof/(dof + t²), regularized=True) = 0.05`.
#[test]
fn quantiles_are_those_of_the_tables() {
    for (dof, expected) in [
        (1.0, 12.7062047361747),
        (2.0, 4.302652729749464),
        (3.9, 3.18244630528371),
        (10.0, 2.228138851986275),
        (10.0 - 1e-12, 2.228138851986275),
        (100.0, 1.983971518523552),
        (1000.0, 1.962339080826408),
        (20000.0, 1.960082605158135),
        (f64::INFINITY, 1.959963984540054),
        (0.5, 12.7062047361747),
    ] {
        let computed = quantile(0.05, dof);
        assert!((computed / expected - 1.0).abs() < 1e-8, "{dof}: {computed}");
    }
}

/// SciPy 1.17: `2*scipy.stats.t.sf(t, dof)`.
#[test]
fn the_tails_are_those_of_the_tables() {
    for (t, dof, expected) in [
        (1.0, 1, 0.5),
        (2.0, 2, 0.18350341907227397),
        (2.5, 3, 0.08770664700806556),
        (-3.0, 10, 0.01334365502256957),
        (4.0, 55, 0.00019078887405470378),
    ] {
        let computed = probability_beyond(t, dof);
        assert!((computed - expected).abs() < 1e-14, "{t} {dof}: {computed}");
    }
}
