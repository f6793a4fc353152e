//! The eigenvalues of a general matrix.

use crate::algebra::Complex;

/// All eigenvalues, by the QR algorithm with Wilkinson's shifts on a Hessenberg matrix, by descending magnitude; `None` when
/// it does not converge or an entry is not finite.
///
/// # Accuracy
/// Those of a matrix that differs by rounding errors: simple ones to their condition, of a defective pair only half the digits.
pub fn eigenvalues(matrix: &[Vec<f64>]) -> Option<Vec<Complex>> {
    /// Steps for each eigenvalue; three are usual.
    const MOST_STEPS: usize = 60;
    let mut h: Vec<Vec<Complex>> =
        hessenberg(matrix).into_iter().map(|row| row.into_iter().map(Complex::from).collect()).collect();
    let mut found = vec![];
    let mut steps = 0;
    while let Some(last) = h.len().checked_sub(1) {
        let first = start_of_block(&h, last);
        if first == last {
            found.push(h[last][last]);
            h.pop();
            h.iter_mut().for_each(|row| row.truncate(last));
            steps = 0;
            continue;
        }
        steps += 1;
        if steps > MOST_STEPS || !h[last][last].is_finite() {
            return None;
        }
        let shift = if steps % 11 == 10 { exceptional_shift(&h, last) } else { wilkinson_shift(&h, last) };
        qr_step(&mut h, first, shift);
    }
    found.sort_by(|a, b| b.abs().total_cmp(&a.abs()).then(b.im.total_cmp(&a.im)));
    found.iter().all(|value| value.is_finite()).then_some(found)
}

/// A similar matrix with zeros below the subdiagonal, by elimination with pivots.
fn hessenberg(matrix: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let (mut a, n) = (matrix.to_vec(), matrix.len());
    for m in 1..n.saturating_sub(1) {
        let pivot = (m..n).max_by(|&i, &j| a[i][m - 1].abs().total_cmp(&a[j][m - 1].abs())).unwrap_or(m);
        a.swap(m, pivot);
        a.iter_mut().for_each(|row| row.swap(m, pivot));
        if a[m][m - 1] == 0.0 {
            continue;
        }
        for i in m + 1..n {
            // As the step before has left it: its own diagonal entry changes.
            let pivot_row = a[m].clone();
            let factor = a[i][m - 1] / pivot_row[m - 1];
            for (entry, of_pivot) in a[i].iter_mut().zip(&pivot_row).skip(m - 1) {
                *entry -= factor * of_pivot;
            }
            for row in &mut a {
                row[m] += factor * row[i];
            }
        }
    }
    a
}

/// The first row of the last block that does not fall apart.
fn start_of_block(h: &[Vec<Complex>], last: usize) -> usize {
    let separate = |&k: &usize| {
        let size = h[k - 1][k - 1].abs() + h[k][k].abs();
        h[k][k - 1].abs() <= f64::EPSILON * if size > 0.0 { size } else { 1.0 }
    };
    (1..=last).rev().find(separate).unwrap_or(0)
}

/// The eigenvalue of the last two rows that is nearer to the last entry.
fn wilkinson_shift(h: &[Vec<Complex>], last: usize) -> Complex {
    let (a, b, c, d) = (h[last - 1][last - 1], h[last - 1][last], h[last][last - 1], h[last][last]);
    let half = (a - d).scaled(0.5);
    let root = square_root(half * half + b * c);
    let far = if (half + root).abs() > (half - root).abs() { half + root } else { half - root };
    if far.abs() > 0.0 { d - b * c / far } else { d }
}

/// A shift that breaks a cycle.
fn exceptional_shift(h: &[Vec<Complex>], last: usize) -> Complex {
    h[last][last] + Complex::from(h[last][last - 1].abs())
}

fn square_root(z: Complex) -> Complex {
    let size = z.abs();
    let (re, im) = (f64::sqrt(0.5 * (size + z.re).max(0.0)), f64::sqrt(0.5 * (size - z.re).max(0.0)));
    Complex::new(re, im.copysign(z.im))
}

/// One step on the rows from the first on: H − shift = QR, then RQ + shift, by rotations of neighbouring rows.
fn qr_step(h: &mut [Vec<Complex>], first: usize, shift: Complex) {
    let n = h.len();
    for (i, row) in h.iter_mut().enumerate().skip(first) {
        row[i] = row[i] - shift;
    }
    let mut rotations = vec![];
    for k in first..n - 1 {
        let rotation = Rotation::clearing(h[k][k], h[k + 1][k]);
        let (above, below) = h.split_at_mut(k + 1);
        for (x, y) in above[k].iter_mut().zip(&mut below[0]).skip(k) {
            (*x, *y) = rotation.apply(*x, *y);
        }
        rotations.push(rotation);
    }
    for (k, rotation) in (first..).zip(rotations) {
        for row in &mut h[first..=(k + 1).min(n - 1)] {
            (row[k], row[k + 1]) = rotation.apply_from_the_right(row[k], row[k + 1]);
        }
    }
    for (i, row) in h.iter_mut().enumerate().skip(first) {
        row[i] = row[i] + shift;
    }
}

/// (x, y) ↦ (c̄·x + s̄·y, −s·x + c·y) with |c|² + |s|² = 1.
struct Rotation {
    c: Complex,
    s: Complex,
}

impl Rotation {
    /// The one that makes the second component vanish.
    fn clearing(x: Complex, y: Complex) -> Self {
        let size = libm::hypot(x.abs(), y.abs());
        if size == 0.0 {
            return Self { c: Complex::from(1.0), s: Complex::default() };
        }
        Self { c: x.scaled(1.0 / size), s: y.scaled(1.0 / size) }
    }

    fn apply(&self, x: Complex, y: Complex) -> (Complex, Complex) {
        (conjugate(self.c) * x + conjugate(self.s) * y, self.c * y - self.s * x)
    }

    /// The same from the right by the adjoint.
    fn apply_from_the_right(&self, x: Complex, y: Complex) -> (Complex, Complex) {
        (x * self.c + y * self.s, y * conjugate(self.c) - x * conjugate(self.s))
    }
}

fn conjugate(z: Complex) -> Complex {
    Complex::new(z.re, -z.im)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(found: &[Complex], expected: &[(f64, f64)], tolerance: f64) {
        assert_eq!(found.len(), expected.len());
        for (re, im) in expected {
            let nearest =
                found.iter().map(|z| (*z - Complex::new(*re, *im)).abs()).fold(f64::INFINITY, f64::min);
            assert!(nearest < tolerance, "{re} + {im}i: {nearest:e} in {found:?}");
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

    #[test]
    fn rotations_and_permutations_have_the_roots_of_unity() {
        let cycle: Vec<Vec<f64>> =
            (0..6).map(|i| (0..6).map(|j| f64::from(u8::from(i == (j + 1) % 6))).collect()).collect();
        let found = eigenvalues(&cycle).unwrap();
        for k in 0..6 {
            let root = Complex::unit(std::f64::consts::TAU * f64::from(k) / 6.0);
            assert!(found.iter().any(|z| (*z - root).abs() < 1e-14), "{found:?}");
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
}
