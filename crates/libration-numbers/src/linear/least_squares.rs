//! Least-squares solution of linear equations.

/// The vector that minimises the sum of squares of M·x − b, by Householder reflections; `None` if the columns are dependent up to rounding
/// errors.
pub fn least_squares(matrix: &[Vec<f64>], right: &[f64]) -> Option<Vec<f64>> {
    let columns = matrix.first()?.len();
    let mut rows: Vec<Vec<f64>> =
        matrix.iter().zip(right).map(|(row, b)| row.iter().chain([b]).copied().collect()).collect();
    if rows.len() < columns {
        return None;
    }
    let sizes: Vec<f64> = (0..columns).map(|column| norm(&rows, column, 0)).collect();
    for (step, size) in sizes.iter().enumerate() {
        let length = norm(&rows, step, step);
        // The remainder of a dependent column consists of rounding errors.
        if length <= 64.0 * f64::EPSILON * size || !length.is_finite() {
            return None;
        }
        reflect(&mut rows, step, length);
    }
    let mut solution = vec![0.0; columns];
    for i in (0..columns).rev() {
        let sum: f64 = (i + 1..columns).map(|j| rows[i][j] * solution[j]).sum();
        solution[i] = (rows[i][columns] - sum) / rows[i][i];
    }
    solution.iter().all(|x| x.is_finite()).then_some(solution)
}

/// The norm of a column from row `from` on.
fn norm(rows: &[Vec<f64>], column: usize, from: usize) -> f64 {
    rows[from..].iter().fold(0.0, |length, row| libm::hypot(length, row[column]))
}

/// Reflects the rows so that a column vanishes below the diagonal.
fn reflect(rows: &mut [Vec<f64>], step: usize, length: f64) {
    let length = -length.copysign(rows[step][step]);
    let mut mirror: Vec<f64> = rows[step..].iter().map(|row| row[step]).collect();
    mirror[0] -= length;
    let square: f64 = mirror.iter().map(|x| x * x).sum();
    for column in step..rows[step].len() {
        let product: f64 = mirror.iter().zip(&rows[step..]).map(|(x, row)| x * row[column]).sum();
        let factor = 2.0 * product / square;
        for (x, row) in mirror.iter().zip(&mut rows[step..]) {
            row[column] -= factor * x;
        }
    }
}
