//! Linear equations and null spaces by elimination, over any field.

use crate::algebra::Ring;

/// The solution of linear equations; `None` where the matrix is singular. `size` tells how large an element is: of those that are
/// not zero the largest is the pivot.
pub fn solve<R: Ring>(
    ring: &R,
    size: impl Fn(&R::Element) -> f64,
    matrix: &[Vec<R::Element>],
    right: &[R::Element],
) -> Option<Vec<R::Element>> {
    let n = matrix.len();
    let rows = matrix.iter().zip(right);
    let mut rows: Vec<Vec<R::Element>> =
        rows.map(|(row, right)| row.iter().chain([right]).cloned().collect()).collect();
    for column in 0..n {
        let candidates = (column..n).filter(|&row| !ring.is_zero(&rows[row][column]));
        let pivot = candidates.max_by(|&a, &b| size(&rows[a][column]).total_cmp(&size(&rows[b][column])))?;
        rows.swap(column, pivot);
        clear(ring, &mut rows, column, column)?;
    }
    (0..n).map(|i| ring.divide(&rows[i][n], &rows[i][i])).collect()
}

/// So many independent vectors that a matrix maps to zero, by elimination with the largest pivot of all that is left. The
/// matrix must have at least so many; of a matrix of `f64`s what is left in the end is taken to be rounding errors.
pub fn null_space<R: Ring>(
    ring: &R,
    size: impl Fn(&R::Element) -> f64,
    matrix: &[Vec<R::Element>],
    dimension: usize,
) -> Option<Vec<Vec<R::Element>>> {
    let n = matrix.len();
    let rank = n.checked_sub(dimension)?;
    let mut rows = matrix.to_vec();
    let mut order: Vec<usize> = (0..n).collect();
    for step in 0..rank {
        let places = (step..n).flat_map(|row| (step..n).map(move |at| (row, at)));
        let present = places.filter(|&(row, at)| !ring.is_zero(&rows[row][order[at]]));
        let largest = |a: &(usize, usize), b: &(usize, usize)| {
            size(&rows[a.0][order[a.1]]).total_cmp(&size(&rows[b.0][order[b.1]]))
        };
        let (row, at) = present.max_by(largest)?;
        rows.swap(step, row);
        order.swap(step, at);
        clear(ring, &mut rows, step, order[step])?;
    }
    (rank..n).map(|free| null_vector(ring, &rows, &order[..rank], order[free])).collect()
}

/// Takes the multiple of one row from all others that makes their entries in its pivot's column vanish.
fn clear<R: Ring>(ring: &R, rows: &mut [Vec<R::Element>], pivot: usize, column: usize) -> Option<()> {
    let pivot_row = rows[pivot].clone();
    for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != pivot) {
        if ring.is_zero(&row[column]) {
            continue;
        }
        let factor = ring.divide(&row[column], &pivot_row[column])?;
        for (entry, of_pivot) in row.iter_mut().zip(&pivot_row) {
            *entry = ring.subtract(entry, &ring.multiply(&factor, of_pivot));
        }
        row[column] = ring.zero();
    }
    Some(())
}

/// The vector with one for a free component, zero for the others, and what follows for those with pivots.
fn null_vector<R: Ring>(
    ring: &R,
    rows: &[Vec<R::Element>],
    pivots: &[usize],
    free: usize,
) -> Option<Vec<R::Element>> {
    let mut vector = vec![ring.zero(); rows.len()];
    vector[free] = ring.rational(&1.into())?;
    for (row, &column) in rows.iter().zip(pivots) {
        vector[column] = ring.negate(&ring.divide(&row[free], &row[column])?);
    }
    Some(vector)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{Doubles, Rational, Rationals};

    #[test]
    fn equations_are_solved_exactly() {
        // Hilbert's matrix times (1, 2, 3).
        let entry = |i: i64, j: i64| Rational::new(1, i + j + 1).unwrap();
        let matrix: Vec<Vec<Rational>> = (0..3).map(|i| (0..3).map(|j| entry(i, j)).collect()).collect();
        let sum = |i: i64| (0..3).fold(Rational::from(0), |sum, j| sum + entry(i, j) * Rational::from(j + 1));
        let right: Vec<Rational> = (0..3).map(sum).collect();
        let found = solve(&Rationals, Rational::to_f64, &matrix, &right).unwrap();
        assert_eq!(found, [1, 2, 3].map(Rational::from));
        let singular = vec![vec![Rational::from(1); 2]; 2];
        assert_eq!(solve(&Rationals, Rational::to_f64, &singular, &[1, 2].map(Rational::from)), None);
    }

    #[test]
    fn null_spaces_of_every_dimension_are_found() {
        // x ↦ x − a(b·x) with a·b = 1 has the null space of a; its complement has the plane across b.
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
}
