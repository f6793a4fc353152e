//! Sums of cosines of multiples of one phase, as polynomials in c = cos(Ωt), and their projections.

use libration::algebra::{Polynomial, Rational, Variable};

/// The name of cos(Ωt) in the polynomials.
const COSINE: &str = "c";

/// cos(n·Ωt), the Chebyshev polynomial of cos(Ωt) (DLMF 18.5.1).
pub fn cosine(n: u32) -> Polynomial {
    let c = Polynomial::variable(COSINE);
    let (mut before, mut now) = (c.clone(), Polynomial::constant(Rational::from(1)));
    for _ in 0..n {
        let next = c.scaled(&Rational::from(2)) * now.clone() - before;
        (before, now) = (now, next);
    }
    now
}

/// The meanings of c1, c3, c5, c7 in printed formulas.
pub(super) fn cosines() -> [(&'static str, Polynomial); 4] {
    [("c1", cosine(1)), ("c3", cosine(3)), ("c5", cosine(5)), ("c7", cosine(7))]
}

/// The second derivative with respect to Ωt: f″(c)(1 − c²) − f′(c)·c.
pub fn second_derivative(sum: &Polynomial) -> Polynomial {
    let c = Polynomial::variable(COSINE);
    let first = sum.derivative(&Variable::from(COSINE));
    let second = first.derivative(&Variable::from(COSINE));
    second.clone() - second * c.pow(2) - first * c
}

/// The integral over a period of the sum times cos(n·Ωt), divided by π: the coefficient of cos(n·Ωt), n ≥ 1.
pub fn projection(sum: &Polynomial, n: u32) -> Polynomial {
    let c = Variable::from(COSINE);
    let powers = (n..=sum.degree_in(&c)).step_by(2);
    powers.fold(Polynomial::zero(), |projected, power| {
        let weight = weight_of_power(power, (power - n) / 2);
        projected + sum.coefficient(&c, power).scaled(&weight)
    })
}

/// The coefficient of cos(n·x) in cosᵏx: 2^(1−k)·binomial(k, (k − n)/2).
fn weight_of_power(k: u32, chosen: u32) -> Rational {
    let ratio =
        |i: u32| Rational::new(i64::from(k - i), i64::from(i + 1)).unwrap_or_else(|| Rational::from(0));
    let binomial = (0..chosen).fold(Rational::from(2), |product, i| product * ratio(i));
    let half = Rational::from(1).divided_by_power_of_two(1);
    (0..k).fold(binomial, |product, _| product * half.clone())
}
