//! The eigenvalues of a general matrix.

use crate::algebra::Complex;
use crate::algebra::in_order::InOrder;
use libration_kernels::elementary::count;

/// All eigenvalues by descending magnitude, real ones and pairs of conjugate ones, from the QR algorithm with Wilkinson's shifts on a balanced Hessenberg matrix; `None` if it does not
/// converge or an entry is not finite.
///
/// # Accuracy
/// The results are eigenvalues of a matrix that differs by rounding errors: simple ones are accurate to their condition number, those of a
/// defective pair to half the digits.
pub fn eigenvalues(matrix: &[Vec<f64>]) -> Option<Vec<Complex>> {
    /// Step limit for each eigenvalue; three steps are usual.
    const MOST_STEPS: usize = 60;
    let mut h: Vec<Vec<Complex>> = hessenberg(balanced(matrix))
        .into_iter()
        .map(|row| row.into_iter().map(Complex::from).collect())
        .collect();
    let mut eigenvalues = vec![];
    let mut steps = 0;
    while let Some(last) = h.len().checked_sub(1) {
        let first = start_of_block(&h, last);
        if first == last {
            eigenvalues.push(h[last][last]);
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
    pair(&mut eigenvalues);
    eigenvalues.put_in_order(|a, b| b.abs().total_cmp(&a.abs()).then(b.im.total_cmp(&a.im)));
    eigenvalues.iter().all(|value| value.is_finite()).then_some(eigenvalues)
}

/// Makes eigenvalues of a real matrix real or conjugate in pairs, which those of complex steps are but for rounding: an eigenvalue is real if it is
/// nearer to its own conjugate than to that of any other.
fn pair(eigenvalues: &mut [Complex]) {
    let mut open: Vec<usize> = (0..eigenvalues.len()).filter(|i| eigenvalues[*i].im != 0.0).collect();
    open.put_in_order(|i, j| eigenvalues[*i].im.abs().total_cmp(&eigenvalues[*j].im.abs()));
    while let Some(i) = open.pop() {
        let value = eigenvalues[i];
        let apart = |j: usize| (eigenvalues[j] - conjugate(value)).abs();
        let other = (0..open.len()).min_by(|a, b| apart(open[*a]).total_cmp(&apart(open[*b])));
        match other.filter(|other| apart(open[*other]) < 2.0 * value.im.abs()) {
            None => eigenvalues[i].im = 0.0,
            Some(other) => {
                let j = open.remove(other);
                let mean = (value + conjugate(eigenvalues[j])).scaled(0.5);
                (eigenvalues[i], eigenvalues[j]) = (mean, conjugate(mean));
            }
        }
    }
}

/// Bounds for the change of each eigenvalue, to first order, when the matrix changes by a matrix of norm `change`.
///
/// # Method
/// A changed eigenvalue z solves Π(z − λⱼ) = −tr(adj(z − M)·δM) + …. It is therefore within the radius r about λᵢ for which r·Π max(r, |λᵢ −
/// λⱼ|) = ‖adj(λᵢ − M)‖·‖δM‖. For a simple eigenvalue r is the condition number times ‖δM‖, for a k-fold one about the k-th root of that. The
/// bound is never less than ‖δM‖.
///
/// # References
/// J. H. Wilkinson, *The Algebraic Eigenvalue Problem*, Oxford 1965, chapter 2.
pub fn eigenvalue_errors(matrix: &[Vec<f64>], eigenvalues: &[Complex], change: f64) -> Vec<f64> {
    let powers = adjugate_powers(matrix);
    let radius = |index: usize| {
        let mut distances: Vec<f64> = (0..eigenvalues.len())
            .filter(|other| *other != index)
            .map(|other| (eigenvalues[index] - eigenvalues[other]).abs())
            .collect();
        distances.sort_by(f64::total_cmp);
        let right = change * adjugate_norm(&powers, eigenvalues[index]);
        // The smallest cluster of nearest neighbours whose radius does not reach the next neighbour.
        let of_cluster = |neighbours: usize| {
            let beyond: f64 = distances[neighbours..].iter().product();
            libm::pow(right / beyond, 1.0 / count(neighbours + 1))
        };
        let fits = |neighbours: &usize| {
            distances.get(*neighbours).is_none_or(|next| of_cluster(*neighbours) <= *next)
        };
        let neighbours = (0..distances.len()).find(fits).unwrap_or(distances.len());
        of_cluster(neighbours).max(change)
    };
    (0..eigenvalues.len()).map(radius).collect()
}

/// The matrices B₀, …, Bₙ₋₁ with adj(λ − M) = Σ λᵏ·Bₖ, by Faddeev's and Le Verrier's recurrence.
fn adjugate_powers(matrix: &[Vec<f64>]) -> Vec<Vec<Vec<f64>>> {
    let n = matrix.len();
    let diagonal = |value: f64| -> Vec<Vec<f64>> {
        (0..n).map(|i| (0..n).map(|j| if i == j { value } else { 0.0 }).collect()).collect()
    };
    let mut powers = vec![diagonal(1.0)];
    for k in 1..n {
        let last = &powers[k - 1];
        let entry = |i: usize, j: usize| -> f64 { (0..n).map(|m| matrix[i][m] * last[m][j]).sum() };
        let mut next: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        let trace: f64 = (0..n).map(|i| next[i][i]).sum();
        (0..n).for_each(|i| next[i][i] -= trace / count(k));
        powers.push(next);
    }
    powers.reverse();
    powers
}

fn adjugate_norm(powers: &[Vec<Vec<f64>>], at: Complex) -> f64 {
    let entry = |i: usize, j: usize| {
        powers.iter().rev().fold(Complex::default(), |sum, power| sum * at + Complex::from(power[i][j]))
    };
    let n = powers.len();
    let entries = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    entries.fold(0.0, |norm, (i, j)| libm::hypot(norm, entry(i, j).abs()))
}

/// A similar matrix whose rows and columns have norms of the same magnitude: the results do not depend on the units of the components.
fn balanced(matrix: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let units = balancing(matrix);
    let row =
        |(row, unit): (&Vec<f64>, &f64)| row.iter().zip(&units).map(|(x, other)| x * other / unit).collect();
    matrix.iter().zip(&units).map(row).collect()
}

/// Units of the components, powers of two, which round nothing, in which the rows and columns of a matrix have norms of the same magnitude. A
/// component that is affected by no other, or affects none, keeps its unit.
///
/// # References
/// B. N. Parlett and C. Reinsch, Numerische Mathematik 13 (1969) 293–304.
pub fn balancing(matrix: &[Vec<f64>]) -> Vec<f64> {
    /// Sweeps that units differing by all powers of two of `f64` may need.
    const SWEEPS: u32 = 64;
    let (mut a, n) = (matrix.to_vec(), matrix.len());
    let mut units = vec![1.0; n];
    for _ in 0..SWEEPS {
        let mut is_balanced = true;
        for i in 0..n {
            let others = || (0..n).filter(|j| *j != i);
            let column = others().fold(0.0, |sum, j| libm::hypot(sum, a[j][i]));
            let row = others().fold(0.0, |sum, j| libm::hypot(sum, a[i][j]));
            let power = libm::round(0.5 * libm::log2(row / column));
            if !power.is_finite() || power == 0.0 {
                continue;
            }
            is_balanced = false;
            let (factor, inverse) = (libm::exp2(power), libm::exp2(-power));
            units[i] *= factor;
            a.iter_mut().for_each(|row| row[i] *= factor);
            a[i].iter_mut().for_each(|entry| *entry *= inverse);
        }
        if is_balanced {
            break;
        }
    }
    units
}

/// A similar matrix with zeros below the subdiagonal, by elimination with pivoting.
fn hessenberg(mut a: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let n = a.len();
    for m in 1..n.saturating_sub(1) {
        let pivot = (m..n).max_by(|&i, &j| a[i][m - 1].abs().total_cmp(&a[j][m - 1].abs())).unwrap_or(m);
        a.swap(m, pivot);
        a.iter_mut().for_each(|row| row.swap(m, pivot));
        if a[m][m - 1] == 0.0 {
            continue;
        }
        for i in m + 1..n {
            // The pivot row after the previous step, which changes its diagonal entry.
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

/// The first row of the last block that cannot be split further.
fn start_of_block(h: &[Vec<Complex>], last: usize) -> usize {
    let separate = |&k: &usize| {
        let size = h[k - 1][k - 1].abs() + h[k][k].abs();
        h[k][k - 1].abs() <= f64::EPSILON * if size > 0.0 { size } else { 1.0 }
    };
    (1..=last).rev().find(separate).unwrap_or(0)
}

/// The eigenvalue of the last two rows that is nearer to the last diagonal entry.
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

/// One QR step on the rows from `first` on: H − shift = QR, then RQ + shift, by rotations of neighbouring rows.
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
    /// The rotation that makes the second component vanish.
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

    /// The adjoint rotation, applied from the right.
    fn apply_from_the_right(&self, x: Complex, y: Complex) -> (Complex, Complex) {
        (x * self.c + y * self.s, y * conjugate(self.c) - x * conjugate(self.s))
    }
}

fn conjugate(z: Complex) -> Complex {
    Complex::new(z.re, -z.im)
}
