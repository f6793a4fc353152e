//! The Jacobian if a shift of the phase only rotates the coupling: the equations themselves replace cos mφ and sin mφ.

use super::letters::{Column, Letters, Sum};
use libration_numbers::algebra::Rational;

/// Coefficients of cos mφ and sin mφ in A′ and A·φ′.
pub(super) type Coupling = [[Sum; 2]; 2];

/// Trace and determinant of the Jacobian of A′ and φ′ at steady states, for A′ = r + Aᵏ·Re(f·e^{∓imφ}) and A·φ′ = s + Aᵏ·Im(f·e^{∓imφ}) with a
/// constant f; `None` for another coupling.
pub(super) fn turned_jacobian(
    letters: &Letters,
    m: i64,
    rates: &[Sum; 2],
    matrix: &Coupling,
) -> Option<[Sum; 2]> {
    let [[a, b], [c, d]] = matrix;
    let by = |sum: &Sum, factor: i64| letters.scaled(sum, &Rational::from(factor));
    let direction = [1, -1].into_iter().find(|&sign| *b == by(c, sign) && *a == by(d, -sign))?;
    let mut powers: Vec<i64> =
        matrix.iter().flatten().flat_map(|entry| letters.exponents(entry, Column::Amplitude)).collect();
    powers.dedup();
    let &[k] = powers.as_slice() else { return None };
    let columns = [Column::Cosine, Column::Sine].map(|column| letters.index(column));
    let still = |rate| letters.part(rate, |powers| columns.iter().all(|&column| powers[column] == 0));
    let [growth, turning] = rates.each_ref().map(still);
    let per_amplitude = letters.power(Column::Amplitude, -1);
    let over = |sum: &Sum, factor: i64| by(&letters.times(sum, &per_amplitude), factor);
    let slope = |sum: &Sum| letters.add(&letters.derivative(sum, Column::Amplitude), &over(sum, -k));
    let turn = m * direction;
    let (upper, lower) = (slope(&growth), over(&growth, turn));
    let across = letters.times(&turning, &over(&slope(&turning), turn));
    let determinant = letters.add(&letters.times(&upper, &lower), &across);
    Some([letters.add(&upper, &lower), determinant])
}
