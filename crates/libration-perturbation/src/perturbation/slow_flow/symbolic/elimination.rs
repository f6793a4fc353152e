//! The elimination of the phase by a resultant, if several harmonics of it occur at the lowest order.

use super::letters::{Column, Letters, Sum};
use libration_numbers::algebra::Rational;

/// The largest degree in e^{iφ} for which the determinant is expanded.
const LARGEST_DEGREE: i64 = 3;

/// The resultant of Σ cₖ·e^{ikφ} and its conjugate as polynomials in e^{iφ}, real: zero if both vanish for the same φ. The powers of e^{iφ} stand
/// in the column of waves. `None` for degrees above three, or terms beyond the limit.
pub(super) fn resultant(letters: &Letters, sum: &Sum) -> Option<Sum> {
    let exponents = letters.exponents(sum, Column::Wave);
    let (first, last) = (*exponents.first()?, *exponents.last()?);
    let degree = last - first;
    if !(1..=LARGEST_DEGREE).contains(&degree) {
        return None;
    }
    let coefficients: Vec<Sum> = (first..=last).map(|k| letters.coefficient(sum, Column::Wave, k)).collect();
    // The conjugate has the conjugate coefficients in the opposite order.
    let opposite: Vec<Sum> =
        coefficients.iter().rev().map(|coefficient| letters.conjugate(coefficient)).collect();
    let size = usize::try_from(2 * degree).ok()?;
    let rows: Vec<Vec<Sum>> = [&coefficients, &opposite]
        .into_iter()
        .flat_map(|list| (0..size / 2).map(move |shift| (list, shift)))
        .map(|(list, shift)| {
            let entry = |column: usize| column.checked_sub(shift).and_then(|index| list.get(index));
            (0..size).map(|column| entry(column).cloned().unwrap_or_else(|| letters.zero())).collect()
        })
        .collect();
    let determinant = determinant(letters, &rows);
    let imaginary = letters.coefficient(&determinant, Column::Imaginary, 1);
    let real = letters.coefficient(&determinant, Column::Imaginary, 0);
    match (real.is_zero(), imaginary.is_zero()) {
        _ if determinant.is_beyond_limit() => None,
        (false, true) => Some(real),
        (true, false) => Some(imaginary),
        _ => None,
    }
}

/// The determinant by its first row.
fn determinant(letters: &Letters, rows: &[Vec<Sum>]) -> Sum {
    let Some((first, rest)) = rows.split_first() else { return letters.number(Rational::from(1)) };
    let mut sum = letters.zero();
    for (column, factor) in first.iter().enumerate().filter(|(_, factor)| !factor.is_zero()) {
        let minor: Vec<Vec<Sum>> = rest
            .iter()
            .map(|row| {
                row.iter()
                    .enumerate()
                    .filter(|(index, _)| *index != column)
                    .map(|(_, entry)| entry.clone())
                    .collect()
            })
            .collect();
        let sign = Rational::from(if column % 2 == 0 { 1 } else { -1 });
        let term = letters.times(factor, &determinant(letters, &minor));
        sum = letters.add(&sum, &letters.scaled(&term, &sign));
    }
    sum
}
