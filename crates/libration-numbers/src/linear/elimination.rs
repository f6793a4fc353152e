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
