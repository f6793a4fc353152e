//! Integrals over half waves: the first harmonic of forces with kinks, exactly.

use super::letters::{Column, Letters, Sum};
use libration_numbers::algebra::Rational;

/// The first harmonic of xᵃ·x′ᵇ·sign(x)ᶜ·sign(x′)ᵈ for x = A·cos ψ and x′ = −ω0·A·sin ψ, the coefficient of e^{iψ}, divided by Aᵃ⁺ᵇ.
pub(super) fn first_harmonic(letters: &Letters, omega0: &Sum, [a, b]: [usize; 2], signs: [bool; 2]) -> Sum {
    let opposite = (b + usize::from(signs[1])) % 2 == 1;
    let real = mean(letters, [a + 1, b], signs);
    let imaginary = letters.times(&mean(letters, [a, b + 1], signs), &letters.power(Column::Imaginary, 1));
    let wave = letters.subtract(&real, &imaginary);
    let speed = letters.raised(omega0, b, i64::from(i16::MAX));
    letters.scaled(&letters.times(&wave, &speed), &Rational::from(if opposite { -1 } else { 1 }))
}

/// The mean of cosᵐ ψ·sinⁿ ψ, with their signs as factors.
fn mean(letters: &Letters, [m, n]: [usize; 2], signs: [bool; 2]) -> Sum {
    if (m + usize::from(signs[0])) % 2 == 1 || (n + usize::from(signs[1])) % 2 == 1 {
        return letters.zero();
    }
    // The mean is 2/π times the integral over a quarter of the period.
    let factor = quarter(m, n);
    if m % 2 == 0 && n % 2 == 0 {
        return letters.number(factor);
    }
    letters.scaled(&letters.power(Column::Pi, -1), &(factor * Rational::from(2)))
}

/// ∫ cosᵐ ψ·sinⁿ ψ dψ over a quarter of the period, in units of π/2 where m and n are even.
fn quarter(m: usize, n: usize) -> Rational {
    let fraction = |above: usize, below: usize| {
        let [above, below] = [above, below].map(|number| i64::try_from(number).unwrap_or(1));
        Rational::new(above, below).unwrap_or_else(|| Rational::from(0))
    };
    match (m, n) {
        (0, 0) | (1, 0) | (0, 1) => Rational::from(1),
        (1, 1) => fraction(1, 2),
        (m, n) if m >= 2 => fraction(m - 1, m + n) * quarter(m - 2, n),
        (m, n) => fraction(n - 1, m + n) * quarter(m, n - 2),
    }
}
