//! The characteristic polynomial of a matrix over any field.

use crate::algebra::Ring;

/// The coefficients of det(λ − M), constant term first, by Faddeev's and Le Verrier's recurrence; `None` if an integer has no inverse in the
/// field.
pub fn characteristic_polynomial<R: Ring>(ring: &R, matrix: &[Vec<R::Element>]) -> Option<Vec<R::Element>> {
    let n = matrix.len();
    let one = ring.rational(&1.into())?;
    let mut coefficients = vec![one];
    let mut power = vec![vec![ring.zero(); n]; n];
    for k in 1..=n {
        let last = coefficients.last()?.clone();
        for (i, row) in power.iter_mut().enumerate() {
            row[i] = ring.add(&row[i], &last);
        }
        power = product(ring, matrix, &power);
        let trace = (0..n).fold(ring.zero(), |sum, i| ring.add(&sum, &power[i][i]));
        coefficients.push(ring.negate(&ring.over_integer(&trace, u64::try_from(k).ok()?)?));
    }
    coefficients.reverse();
    Some(coefficients)
}

fn product<R: Ring>(ring: &R, a: &[Vec<R::Element>], b: &[Vec<R::Element>]) -> Vec<Vec<R::Element>> {
    let entry = |row: &[R::Element], column: usize| {
        let terms = row.iter().zip(b).filter(|(x, _)| !ring.is_zero(x));
        terms.fold(ring.zero(), |sum, (x, other)| ring.add(&sum, &ring.multiply(x, &other[column])))
    };
    a.iter().map(|row| (0..b.len()).map(|column| entry(row, column)).collect()).collect()
}
