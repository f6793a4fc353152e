use libration::algebra::{Complex, Doubles, Rational, Rationals};
use libration::internals::linear::{determinant, null_space, solve, solve_complex};

#[test]
fn equations_are_solved_exactly() {
    // Hilbert's matrix times (1, 2, 3).
    let entry = |i: i64, j: i64| Rational::new(1, i + j + 1).unwrap();
    let matrix: Vec<Vec<Rational>> = (0..3).map(|i| (0..3).map(|j| entry(i, j)).collect()).collect();
    let sum = |i: i64| (0..3).fold(Rational::from(0), |sum, j| sum + entry(i, j) * Rational::from(j + 1));
    let right: Vec<Rational> = (0..3).map(sum).collect();
    let computed = solve(&Rationals, Rational::to_f64, &matrix, &right).unwrap();
    assert_eq!(computed, [1, 2, 3].map(Rational::from));
    let singular = vec![vec![Rational::from(1); 2]; 2];
    assert_eq!(solve(&Rationals, Rational::to_f64, &singular, &[1, 2].map(Rational::from)), None);
}

#[test]
fn null_spaces_of_every_dimension_are_found() {
    // x ↦ x − a(b·x) with a·b = 1 has the null space spanned by a; the null space of the complementary projection is the plane perpendicular to
    // b.
    let (a, b) = ([0.5, -1.0, 2.0], [2.0, 2.0, 1.0]);
    let projector: Vec<Vec<f64>> = (0..3).map(|i| (0..3).map(|j| a[i] * b[j]).collect()).collect();
    let complement: Vec<Vec<f64>> =
        (0..3).map(|i| (0..3).map(|j| f64::from(u8::from(i == j)) - projector[i][j]).collect()).collect();
    let size = |x: &f64| x.abs();
    let line = null_space(&Doubles, size, &complement, 1).unwrap();
    for i in 0..3 {
        assert!((line[0][i] / line[0][2] - a[i] / a[2]).abs() < 1e-15);
    }
    let plane = null_space(&Doubles, size, &projector, 2).unwrap();
    for vector in plane {
        let product: f64 = vector.iter().zip(b).map(|(x, y)| x * y).sum();
        assert!(product.abs() < 1e-15);
    }
}

#[test]
fn determinants_are_exact() {
    // Hilbert's matrix of order 3: 1/2160. A zero pivot with an exchange of rows. Linearly dependent rows.
    let hilbert: Vec<Vec<Rational>> =
        (0..3).map(|i| (0..3).map(|j| Rational::new(1, i + j + 1).unwrap()).collect()).collect();
    let of = |matrix: &[Vec<Rational>]| determinant(&Rationals, Rational::to_f64, matrix).unwrap();
    assert_eq!(of(&hilbert), Rational::new(1, 2160).unwrap());
    let whole = |rows: [[i64; 2]; 2]| rows.map(|row| row.map(Rational::from).to_vec());
    assert_eq!(of(&whole([[0, 2], [3, 5]])), Rational::from(-6));
    assert_eq!(of(&whole([[1, 2], [2, 4]])), Rational::from(0));
    assert_eq!(of(&[]), Rational::from(1));
}

#[test]
fn complex_equations_are_solved() {
    let z = Complex::new;
    let matrix = [vec![z(0.0, 1.0), z(2.0, -1.0)], vec![z(1.0, 1.0), z(0.0, 3.0)]];
    let solution = [z(1.0, -2.0), z(0.5, 4.0)];
    let right: Vec<Complex> =
        matrix.iter().map(|row| row.iter().zip(&solution).map(|(a, b)| *a * *b).sum()).collect();
    let computed = solve_complex(&matrix, &right).unwrap();
    assert!(computed.iter().zip(&solution).all(|(a, b)| (*a - *b).abs() < 1e-14), "{computed:?}");
    assert_eq!(solve_complex(&vec![vec![z(1.0, 1.0); 2]; 2], &[z(1.0, 0.0); 2]), None);
}
