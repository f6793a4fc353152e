use libration::algebra::Complex;
use libration::roots::{PolynomialRoot, polynomial_roots};
use libration_kernels::elementary::count;
use std::f64::consts::TAU;

/// Asserts that each true root is within the error bound of the root listed for it.
fn assert_encloses(coefficients: &[f64], truth: &[f64], most: f64) {
    let roots = polynomial_roots(coefficients).unwrap();
    assert_eq!(roots.len(), truth.len(), "{coefficients:?}");
    for (root, truth) in roots.iter().zip(truth) {
        let off = (root.value - Complex::from(*truth)).abs();
        assert!(off <= root.error && root.error <= most * truth.abs(), "{truth}: {off:e} {root:?}");
    }
}

fn from_roots(roots: &[f64]) -> Vec<f64> {
    roots.iter().fold(vec![1.0], |product, root| {
        let shifted = std::iter::once(0.0).chain(product.iter().copied());
        shifted.zip(product.iter().chain([&0.0])).map(|(above, below)| above - root * below).collect()
    })
}

#[test]
fn roots_of_unity_are_found() {
    let mut coefficients = vec![0.0; 13];
    (coefficients[0], coefficients[12]) = (-1.0, 1.0);
    let roots = polynomial_roots(&coefficients).unwrap();
    for k in 0..12 {
        let root = Complex::unit(TAU * count(k) / 12.0);
        let near = roots.iter().find(|zero| (zero.value - root).abs() <= zero.error + 1e-16);
        assert!(near.is_some_and(|near| near.multiplicity == 1 && near.error < 1e-13), "{roots:?}");
    }
    assert_eq!(roots.iter().filter(|zero| zero.value.im == 0.0).count(), 2);
}

#[test]
fn errors_hold_for_roots_of_very_different_size() {
    // Coefficients that are exact in `f64`.
    for roots in [vec![1.0 / 1024.0, -2.0, 4096.0], vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]] {
        assert_encloses(&from_roots(&roots), &roots, 1e-9);
    }
    // z² ± 10³⁰⁰z + 1 has the roots 10⁻³⁰⁰ and 10³⁰⁰, except for rounding.
    assert_encloses(&[1.0, -1e200, 1.0], &[1e-200, 1e200], 1e-13);
    assert_encloses(&[1e-300, -2.0, 1e300], &[1e-300, 1e-300], 1e-5);
    assert_encloses(&[-3e-310, 1e-308], &[0.03], 1e-12);
    assert_encloses(&[f64::MAX, f64::MAX], &[-1.0], 1e-14);
    assert_eq!(polynomial_roots(&[1e-300, 1e300, 1e-300]), None);
}

#[test]
fn roots_that_coincide_say_so_and_lie_within_their_error() {
    // (z − 1)²(z + 3), (z − 2)³ and (z² + 1)².
    assert_encloses(&[3.0, -5.0, 1.0, 1.0], &[1.0, 1.0, -3.0], 1e-5);
    assert_encloses(&[-8.0, 12.0, -6.0, 1.0], &[2.0, 2.0, 2.0], 1e-2);
    let pairs = polynomial_roots(&[1.0, 0.0, 2.0, 0.0, 1.0]).unwrap();
    assert!(pairs.iter().all(|pair| pair.multiplicity == 2), "{pairs:?}");
    for root in pairs {
        let off = (root.value - Complex::new(0.0, 1.0_f64.copysign(root.value.im))).abs();
        assert!(off <= root.error && root.error < 1e-5, "{root:?}");
    }
    // Two roots that differ by 10⁻³ are resolved.
    assert_encloses(&from_roots(&[1.0, 1.0009765625]), &[1.0, 1.0009765625], 1e-10);
}

#[test]
fn constants_and_zeros_at_either_end_are_what_they_are() {
    assert_eq!(polynomial_roots(&[3.0]), Some(vec![]));
    assert_eq!(polynomial_roots(&[3.0, 0.0, 0.0]), Some(vec![]));
    for nothing in [&[][..], &[0.0], &[0.0, 0.0], &[1.0, f64::NAN], &[f64::INFINITY, 1.0]] {
        assert_eq!(polynomial_roots(nothing), None);
    }
    assert_encloses(&[-6.0, 2.0, 0.0], &[3.0], 1e-14);
    let roots = polynomial_roots(&[0.0, 0.0, -6.0, 2.0, 0.0]).unwrap();
    assert_eq!(roots[..2], [PolynomialRoot { value: Complex::default(), error: 0.0, multiplicity: 2 }; 2]);
    assert_eq!((roots.len(), roots[2].value.re), (3, 3.0));
    assert_encloses(&[0.0, 5.0], &[0.0], 0.0);
}
