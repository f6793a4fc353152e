//! Linear equations and null spaces by elimination, over any field.

use crate::algebra::{Complex, Doubles, Ring};

/// The solution of linear equations; `None` if the matrix is singular. `size` measures an element: the largest nonzero one is the pivot.
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

/// The solution of complex linear equations, by the real equations for both parts; `None` if the matrix is singular.
pub fn solve_complex(matrix: &[Vec<Complex>], right: &[Complex]) -> Option<Vec<Complex>> {
    let parts = |row: &Vec<Complex>| {
        let (re, im) = (row.iter().map(|z| z.re), row.iter().map(|z| z.im));
        [re.clone().chain(im.clone().map(|x| -x)).collect(), im.chain(re).collect()]
    };
    let both: Vec<Vec<f64>> = matrix.iter().flat_map(parts).collect();
    let right: Vec<f64> = right.iter().flat_map(|z| [z.re, z.im]).collect();
    let solution = solve(&Doubles, |x| x.abs(), &both, &right)?;
    let (re, im) = solution.split_at(matrix.len());
    let parts = re.iter().zip(im).map(|(re, im)| Complex::new(*re, *im));
    Some(parts.collect()).filter(|solution: &Vec<Complex>| solution.iter().all(|z| z.is_finite()))
}

/// The determinant, with pivots chosen as in [`solve`]; `None` if an element has no inverse.
pub fn determinant<R: Ring>(
    ring: &R,
    size: impl Fn(&R::Element) -> f64,
    matrix: &[Vec<R::Element>],
) -> Option<R::Element> {
    let mut rows = matrix.to_vec();
    let mut product = ring.rational(&1.into())?;
    for column in 0..rows.len() {
        let candidates = (column..rows.len()).filter(|&row| !ring.is_zero(&rows[row][column]));
        let largest = candidates.max_by(|&a, &b| size(&rows[a][column]).total_cmp(&size(&rows[b][column])));
        let Some(pivot) = largest else { return Some(ring.zero()) };
        if pivot != column {
            rows.swap(column, pivot);
            product = ring.negate(&product);
        }
        product = ring.multiply(&product, &rows[column][column]);
        clear(ring, &mut rows[column..], 0, column)?;
    }
    Some(product)
}

/// Independent vectors that a matrix maps to zero, `dimension` of them, by elimination with the largest remaining pivot. The null space must
/// have at least this dimension; for a matrix of `f64`s the remainder at the end is assumed to be rounding errors.
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
        let entries = (step..n).flat_map(|row| (step..n).map(move |at| (row, at)));
        let present = entries.filter(|&(row, at)| !ring.is_zero(&rows[row][order[at]]));
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

/// Subtracts multiples of one row from all others, so that their entries in the pivot's column vanish.
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

/// The null vector with one for a free component and zero for the other free ones; those with pivots follow.
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
