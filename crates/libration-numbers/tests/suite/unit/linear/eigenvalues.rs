use libration::algebra::Complex;
use libration::internals::linear::{eigenvalue_errors, eigenvalues};
use libration_testing::random::Random;

fn close(computed: &[Complex], expected: &[(f64, f64)], tolerance: f64) {
    assert_eq!(computed.len(), expected.len());
    for (re, im) in expected {
        let nearest =
            computed.iter().map(|z| (*z - Complex::new(*re, *im)).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < tolerance, "{re} + {im}i: {nearest:e} in {computed:?}");
    }
}

#[test]
fn eigenvalues_of_a_companion_are_the_roots() {
    // (z − 1)(z − 2)(z + 3)(z² + 4): z⁵ − 3z³ + 6z² − 28z + 24.
    let coefficients = [24.0, -28.0, 6.0, -3.0, 0.0];
    let entry = |i: usize, j: usize| match j {
        4 => -coefficients[i],
        _ => f64::from(u8::from(i == j + 1)),
    };
    let companion: Vec<Vec<f64>> = (0..5).map(|i| (0..5).map(|j| entry(i, j)).collect()).collect();
    let roots = [(1.0, 0.0), (2.0, 0.0), (-3.0, 0.0), (0.0, 2.0), (0.0, -2.0)];
    close(&eigenvalues(&companion).unwrap(), &roots, 1e-13);
}

#[test]
fn eigenvalues_of_a_full_matrix_are_those_of_its_diagonal_form() {
    // S·diag(16, 32, 48, −64)·S⁻¹ with S = ((1, 2, 0, 1), (0, 1, 3, 1), (1, 2, 1, 0), (2, 0, 1, 1)), whose determinant is 16.
    let full = [
        [-31.0, -20.0, 73.0, -13.0],
        [-81.0, 20.0, 87.0, -3.0],
        [-2.0, 8.0, 30.0, -6.0],
        [-65.0, -12.0, 71.0, 13.0],
    ];
    let expected = [(16.0, 0.0), (32.0, 0.0), (48.0, 0.0), (-64.0, 0.0)];
    close(&eigenvalues(&full.map(Vec::from)).unwrap(), &expected, 1e-12);
}

/// An imaginary part of rounding alone would make a real multiplier one of a pair.
#[test]
fn eigenvalues_of_real_matrices_are_real_or_conjugate() {
    let mut random = Random::seeded(11);
    let mut complex = 0;
    for round in 0..3000 {
        let n = 2 + round % 6;
        let mut row = || (0..n).map(|_| random.between(-1.0, 1.0)).collect::<Vec<f64>>();
        let full: Vec<Vec<f64>> = (0..n).map(|_| row()).collect();
        let found = eigenvalues(&full).unwrap();
        for value in &found {
            let others = found.iter().filter(|other| **other == Complex::new(value.re, -value.im));
            assert!(value.im == 0.0 || others.count() == 1, "{found:?}");
        }
        complex += found.iter().filter(|value| value.im != 0.0).count();
        // Symmetric ones have real eigenvalues.
        let symmetric: Vec<Vec<f64>> =
            (0..n).map(|i| (0..n).map(|j| full[i][j] + full[j][i]).collect()).collect();
        assert!(eigenvalues(&symmetric).unwrap().iter().all(|value| value.im == 0.0), "{symmetric:?}");
    }
    assert!(complex > 1000);
}

#[test]
fn rotations_and_permutations_have_the_roots_of_unity() {
    let cycle: Vec<Vec<f64>> =
        (0..6).map(|i| (0..6).map(|j| f64::from(u8::from(i == (j + 1) % 6))).collect()).collect();
    let roots = eigenvalues(&cycle).unwrap();
    for k in 0..6 {
        let root = Complex::unit(std::f64::consts::TAU * f64::from(k) / 6.0);
        assert!(roots.iter().any(|z| (*z - root).abs() < 1e-14), "{roots:?}");
    }
    close(&eigenvalues(&[vec![0.0, 1.0], vec![-1.0, 0.0]]).unwrap(), &[(0.0, 1.0), (0.0, -1.0)], 1e-15);
}

#[test]
fn triangular_and_zero_matrices_show_their_diagonal() {
    close(&eigenvalues(&[vec![3.0, 7.0], vec![0.0, -1.0]]).unwrap(), &[(3.0, 0.0), (-1.0, 0.0)], 1e-15);
    close(&eigenvalues(&vec![vec![0.0; 3]; 3]).unwrap(), &[(0.0, 0.0); 3], 1e-300);
    assert_eq!(eigenvalues(&[]), Some(vec![]));
    assert_eq!(eigenvalues(&[vec![f64::NAN]]), None);
}

/// Matrices with simple eigenvalues, with a pair that has one eigenvector, and a multiple of the identity.
#[test]
fn changed_matrices_have_their_eigenvalues_within_the_errors() {
    let mut random = Random::seeded(6);
    let simple = vec![vec![1.0, 3.0, -2.0], vec![0.0, 0.5, 1.0], vec![0.3, 0.0, -0.8]];
    let defective = vec![vec![1.0, 5.0, 0.0], vec![0.0, 1.0, 0.0], vec![0.0, 0.0, 0.2]];
    let identity = vec![vec![1.0, 0.0, 0.0], vec![0.0, 1.0, 0.0], vec![0.0, 0.0, 1.0]];
    for (matrix, most) in [(simple, 10.0), (defective, 1e6), (identity, 4.0)] {
        let original = eigenvalues(&matrix).unwrap();
        let change = 1e-9;
        let errors = eigenvalue_errors(&matrix, &original, change);
        assert!(errors.iter().all(|error| *error <= most * change), "{errors:?}");
        for _ in 0..200 {
            // The norm of such a matrix is below three times its entries.
            let mut moved = matrix.clone();
            moved.iter_mut().flatten().for_each(|x| *x += random.between(-1.0, 1.0) * change / 3.0);
            for value in eigenvalues(&moved).unwrap() {
                let fits =
                    |(eigenvalue, error): (&Complex, &f64)| (value - *eigenvalue).abs() <= 1.01 * error;
                assert!(original.iter().zip(&errors).any(fits), "{value:?} {original:?} {errors:?}");
            }
        }
    }
}

/// A rotation by 2 rad and one by 5 rad, coupled weakly, with velocities in units of 10⁹ and 10⁻⁹: all moduli are 1.
#[test]
fn eigenvalues_do_not_depend_on_the_units_of_the_components() {
    let [(s, c), (t, d)] = [2.0, 5.0].map(libm::sincos);
    for unit in [1e9, 1e-9] {
        let matrix = vec![
            vec![c, 0.0, s / unit, 0.0],
            vec![0.0, d, 0.0, t / unit],
            vec![-s * unit, 0.0, c, 0.0],
            vec![1e-3 * unit, -t * unit, 0.0, d],
        ];
        close(&eigenvalues(&matrix).unwrap(), &[(c, s), (c, -s), (d, t), (d, -t)], 1e-14);
    }
}
