//! The roots of polynomials with fractions for coefficients, with square roots where that is possible.

use super::equilibrium::simplest;
use crate::algebra::univariate::{divided_exactly, square_free_factors, trimmed};
use crate::algebra::{Complex, Rational, Rationals, Ring, Surd};
use crate::roots::polynomial_roots;

/// A root.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Root {
    Exact(Surd),
    Number(Complex),
}

impl Root {
    pub(super) fn to_complex(&self) -> Complex {
        match self {
            Self::Exact(surd) => Complex::from(surd.to_f64()),
            Self::Number(value) => *value,
        }
    }

    pub(super) fn exact(&self) -> Option<&Surd> {
        if let Self::Exact(surd) = self { Some(surd) } else { None }
    }
}

/// All roots, each with its multiplicity; `None` when digits of them are not found.
///
/// Roots in digits suggest factors of the first and second degree, which must then divide the polynomial.
pub(super) fn roots(polynomial: &[Rational]) -> Option<Vec<(Root, usize)>> {
    let mut found = vec![];
    for (factor, multiplicity) in square_free_factors(polynomial) {
        let roots = simple_roots(factor)?;
        found.extend(roots.into_iter().map(|root| (root, multiplicity)));
    }
    Some(found)
}

fn simple_roots(polynomial: Vec<Rational>) -> Option<Vec<Root>> {
    let (mut exact, mut rest) = (vec![], polynomial);
    for near in numeric_roots(&rest)? {
        let candidate = (near.im.abs() <= 1e-9 * near.abs()).then(|| simplest(near.re)).flatten();
        let factor = candidate.map(|root| (vec![-root.clone(), Rational::from(1)], root));
        if let Some((quotient, root)) =
            factor.and_then(|(by, root)| Some((divided_exactly(&rest, &by)?, root)))
        {
            rest = quotient;
            exact.push(Root::Exact(Surd::from(root)));
        }
    }
    while let Some((quotient, pair)) = quadratic_factor(&rest)? {
        rest = quotient;
        exact.extend(pair.map(Root::Exact));
    }
    exact.extend(numeric_roots(&rest)?.into_iter().map(Root::Number));
    Some(exact)
}

/// A factor x² − px + q with real roots, found and divided out.
fn quadratic_factor(polynomial: &[Rational]) -> Option<Option<(Vec<Rational>, [Surd; 2])>> {
    let near = numeric_roots(polynomial)?;
    let real: Vec<f64> = near.iter().filter(|z| z.im.abs() <= 1e-9 * z.abs()).map(|z| z.re).collect();
    for (i, a) in real.iter().enumerate() {
        for b in &real[i + 1..] {
            let Some((p, q)) = simplest(a + b).zip(simplest(a * b)) else { continue };
            let factor = [q.clone(), -p.clone(), Rational::from(1)];
            if let Some(quotient) = divided_exactly(polynomial, &factor) {
                return Some(Some((quotient, quadratic_roots(&p, &q)?)));
            }
        }
    }
    Some(None)
}

/// p/2 ± √(p²/4 − q).
fn quadratic_roots(p: &Rational, q: &Rational) -> Option<[Surd; 2]> {
    let half = Rationals.over_integer(p, 2)?;
    let square = Rationals.subtract(&Rationals.multiply(&half, &half), q);
    Some([-1, 1].map(|sign| Surd::new(half.clone(), Rational::from(sign), square.clone())))
}

/// Coefficients beyond `f64` are measured in the leading one.
fn numeric_roots(polynomial: &[Rational]) -> Option<Vec<Complex>> {
    let polynomial = trimmed(polynomial.to_vec());
    let Some(leading) = polynomial.last() else { return Some(vec![]) };
    let ratio = |c: &Rational| c.checked_div(leading).map_or(f64::NAN, |c| c.to_f64());
    roots_in_digits(&polynomial.iter().map(ratio).collect::<Vec<f64>>())
}

/// The roots of c₀ + c₁x + ….
pub(super) fn roots_in_digits(coefficients: &[f64]) -> Option<Vec<Complex>> {
    Some(polynomial_roots(coefficients)?.into_iter().map(|root| root.value).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(coefficients: &[i64]) -> Vec<String> {
        let polynomial: Vec<Rational> = coefficients.iter().copied().map(Rational::from).collect();
        let mut texts: Vec<String> = roots(&polynomial)
            .unwrap()
            .iter()
            .map(|(root, times)| match root {
                Root::Exact(surd) => format!("{surd} ×{times}"),
                Root::Number(_) => format!("digits ×{times}"),
            })
            .collect();
        texts.sort();
        texts
    }

    #[test]
    fn roots_are_exact_where_square_roots_suffice() {
        assert_eq!(found(&[2, -4, 1]), ["2 + sqrt(2) ×1", "2 - sqrt(2) ×1"]);
        // (2x − 1)²(x² − 3).
        assert_eq!(found(&[-3, 12, -11, -4, 4]), ["-sqrt(3) ×1", "1/2 ×2", "sqrt(3) ×1"]);
        // The chain of four masses: x⁴ − 8x³ + 21x² − 20x + 5 = (x² − 3x + 1)(x² − 5x + 5).
        let chain =
            ["3/2 + 1/2*sqrt(5) ×1", "3/2 - 1/2*sqrt(5) ×1", "5/2 + 1/2*sqrt(5) ×1", "5/2 - 1/2*sqrt(5) ×1"];
        assert_eq!(found(&[5, -20, 21, -8, 1]), chain);
        assert_eq!(found(&[-2, 0, 0, 1]), ["digits ×1"; 3]);
        assert_eq!(found(&[0, 0, 1]), ["0 ×2"]);
    }
}
