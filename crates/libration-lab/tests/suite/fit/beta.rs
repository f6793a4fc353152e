//! The one-parameter test of a law: T = T0·[1 + β(R(A) − 1)], where β = 1 is the law itself.

use libration_lab::fit::{Beta, Uncertain};
use nalgebra::{DMatrix, DVector};

fn beta(value: f64, uncertainty: f64) -> Beta {
    let t0 = Uncertain { value: 2.0, uncertainty: 3e-4 };
    Beta {
        factor: Uncertain { value, uncertainty },
        t0,
        correlation: -0.5,
        degrees_of_freedom: f64::INFINITY,
    }
}

#[test]
fn three_uncertainties_from_one_are_no_chance() {
    assert!(!beta(1.0299, 0.01).differs_from_one() && beta(1.0301, 0.01).differs_from_one());
    assert!(!beta(0.9701, 0.01).differs_from_one() && beta(0.9699, 0.01).differs_from_one());
}

/// Limits by `scipy.stats.t.isf(scipy.stats.norm.sf(3), dof)`: 235.80 with one degree of freedom, 19.2067 with two, 4.52997 with seven.
#[test]
fn few_degrees_of_freedom_need_a_larger_difference() {
    for (dof, limit) in [(1.0, 235.80), (2.0, 19.2067), (7.0, 4.52997)] {
        let beta = |deviations: f64| Beta { degrees_of_freedom: dof, ..beta(1.0 + 0.01 * deviations, 0.01) };
        assert!(!beta(0.999 * limit).differs_from_one() && beta(1.001 * limit).differs_from_one(), "{dof}");
    }
}

#[test]
fn a_scale_is_suspected_up_to_a_fifth() {
    assert!((beta(1.2, 0.01).scale_error().unwrap() - 0.1).abs() < 1e-15);
    assert!(beta(1.399, 0.01).scale_error().is_some() && beta(0.601, 0.01).scale_error().is_some());
    assert_eq!([1.401, 0.599].map(|value| beta(value, 0.01).scale_error()), [None, None]);
}

/// T0 and T0β without a correlation: β = 1.5 varies by both.
#[test]
fn the_quotient_has_the_covariance_of_the_line() {
    let beta = Beta::from_line(
        &DVector::from_row_slice(&[2.0, 3.0]),
        &DMatrix::from_row_slice(2, 2, &[4e-6, 0.0, 0.0, 9e-6]),
        f64::INFINITY,
    );
    let variance: f64 = (9e-6 + 2.25 * 4e-6) / 4.0;
    assert!((beta.factor.value - 1.5).abs() < 1e-15);
    assert!((beta.factor.uncertainty - variance.sqrt()).abs() < 1e-15);
    let correlation = -1.5 * 4e-6 / 2.0 / (2e-3 * variance.sqrt());
    assert!((beta.correlation - correlation).abs() < 1e-12, "{beta:?}");
}

/// Correlated errors of 4e-4 s and 0.04: (−0.5·3e-4·0.03 + 4e-4·0.04)/(5e-4·0.05).
#[test]
fn an_error_of_both_correlates_them() {
    let before = beta(1.0, 0.03);
    let mut moved = before;
    (moved.t0.value, moved.factor.value) = (2.0004, 1.04);
    let after = before.with_error(&moved);
    assert!((after.t0.uncertainty - 5e-4).abs() < 1e-15 && (after.factor.uncertainty - 0.05).abs() < 1e-15);
    assert!((after.correlation - 0.46).abs() < 1e-9, "{after:?}");
}
