//! Exact coefficients of the period's power series, to any order and without a table.

use dashu_int::{IBig, UBig};

use libration_numbers::algebra::{Rational, Rationals};
use libration_numbers::internals::linear::solve;
use libration_numbers::internals::series::{even_reciprocal, exponential};

/// The coefficients `t₀ … t_N` of T/T0 = Σ tₙθ0²ⁿ (equation (14) of Black and Vel): 1, 1/16, 11/3072, ….
///
/// 16ⁿ(2n)!·tₙ are the integer coefficients of exp(Σ |E₂ⱼ|4ʲxʲ/(2j)). The Euler numbers E₂ⱼ are those of 1/cos. Both series use fast
/// multiplication, and fractions are reduced at the end.
///
/// # References
/// J. W. Meijer, OEIS A223067 and A223068.
#[must_use]
pub fn period_in_amplitude(corrections: usize) -> Vec<Rational> {
    over_weights(period_integers(corrections + 1))
}

/// The coefficients `d₀ … d_N` of Ω/ω0 = T0/T = Σ dₙθ0²ⁿ (equation (51) of Black and Vel): 1, −1/16, 1/3072, ….
#[must_use]
pub fn frequency_in_amplitude(corrections: usize) -> Vec<Rational> {
    over_weights(even_reciprocal(&period_integers(corrections + 1), corrections + 1))
}

/// The coefficients `c₀ … c_N` of T/T0 = Σ cₙ sin²ⁿ(θ0/2): the squares of (2n over n)/4ⁿ, which are 1, 1/2, 3/8, ….
#[must_use]
pub fn period_in_sine_squared(corrections: usize) -> Vec<Rational> {
    let mut binomial = IBig::ONE;
    (0..=corrections)
        .map(|n| {
            let coefficient = Rational::from_parts(binomial.sqr().into(), UBig::ONE << (4 * n));
            binomial = &binomial * (2 * (2 * n + 1)) / (n + 1);
            coefficient
        })
        .collect()
}

/// eₙ = 16ⁿ(2n)!·tₙ.
fn period_integers(length: usize) -> Vec<IBig> {
    let cosine: Vec<IBig> = (0..length).map(|n| if n % 2 == 0 { IBig::ONE } else { IBig::NEG_ONE }).collect();
    let euler = even_reciprocal(&cosine, length);
    // |E₂ⱼ|·4ʲ/2; the index 0 is not used.
    let derivative: Vec<IBig> = euler.into_iter().enumerate().map(|(j, e)| (e << (2 * j)) >> 1).collect();
    exponential(&derivative, length)
}

/// The integers divided by 16ⁿ(2n)!.
fn over_weights(integers: Vec<IBig>) -> Vec<Rational> {
    let mut factorial = UBig::ONE;
    let mut coefficients = Vec::with_capacity(integers.len());
    for (n, integer) in integers.into_iter().enumerate() {
        if n > 0 {
            factorial *= (2 * n - 1) * 2 * n;
        }
        coefficients.push(Rational::from_parts(integer, &factorial << (4 * n)));
    }
    coefficients
}

/// Numerator and denominator of the quotient of polynomials of this degree that agrees with a series to twice the degree, and the first coefficient
/// of denominator·series − numerator; `None` where there is no such quotient.
pub(super) fn pade(series: &[Rational], degree: usize) -> Option<([Vec<Rational>; 2], Rational)> {
    let zero = || Rational::from(0);
    let at =
        |n: usize, back: usize| n.checked_sub(back).and_then(|k| series.get(k).cloned()).unwrap_or_else(zero);
    let rows = degree + 1..=2 * degree;
    let matrix: Vec<Vec<Rational>> =
        rows.clone().map(|n| (1..=degree).map(|back| at(n, back)).collect()).collect();
    let right: Vec<Rational> = rows.map(|n| -at(n, 0)).collect();
    let solution = solve(&Rationals, |number| number.to_f64().abs(), &matrix, &right)?;
    let denominator: Vec<Rational> = std::iter::once(Rational::from(1)).chain(solution).collect();
    let product = |n: usize| {
        denominator.iter().enumerate().fold(zero(), |sum, (back, q)| sum + q.clone() * at(n, back))
    };
    Some(([(0..=degree).map(product).collect(), denominator.clone()], product(2 * degree + 1)))
}
