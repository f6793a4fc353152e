//! The roots of polynomials with rational coefficients, with square roots if possible.

use super::equilibrium::simplest;
use libration_numbers::algebra::{Complex, Rational, Rationals, Ring, Surd};
use libration_numbers::internals::algebra::univariate::{divided_exactly, square_free_factors, trimmed};
use libration_numbers::roots::polynomial_roots;

/// A root.
#[derive(Clone, Debug, PartialEq)]
pub enum Root {
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

/// All roots, each with its multiplicity; `None` if their approximate values cannot be computed. Known approximate values with multiplicities
/// are passed as `digits`, because rounded coefficients of a polynomial of high degree do not determine them.
///
/// Approximate roots suggest factors of first and second degree, which must then divide the polynomial.
pub fn roots(polynomial: &[Rational], digits: &[(Complex, usize)]) -> Option<Vec<(Root, usize)>> {
    let mut list = vec![];
    for (factor, multiplicity) in square_free_factors(polynomial) {
        let of_multiplicity =
            digits.iter().filter(|(_, times)| *times == multiplicity).map(|(root, _)| *root);
        let approximate: Vec<Complex> = of_multiplicity.collect();
        let near = if approximate.len() + 1 == factor.len() { approximate } else { numeric_roots(&factor)? };
        let roots = simple_roots(factor, near)?;
        list.extend(roots.into_iter().map(|root| (root, multiplicity)));
    }
    Some(list)
}

/// The roots of a square-free polynomial near approximate values; exact if a rational root or a quadratic factor is found.
fn simple_roots(polynomial: Vec<Rational>, near: Vec<Complex>) -> Option<Vec<Root>> {
    let (mut exact, mut rest) = (vec![], polynomial);
    let mut left = vec![];
    // A root at zero is known up to the rounding of the largest one.
    let zero = 1e-12 * near.iter().map(|root| root.abs()).fold(0.0, f64::max);
    for near in near {
        let candidates = [
            (near.abs() <= zero).then(|| Rational::from(0)),
            is_real(near).then(|| simplest(near.re, near.re.abs())).flatten(),
        ];
        let divided =
            |root: Rational| Some((divided_exactly(&rest, &[-root.clone(), Rational::from(1)])?, root));
        match candidates.into_iter().flatten().find_map(divided) {
            Some((quotient, root)) => {
                rest = quotient;
                exact.push(Root::Exact(Surd::from(root)));
            }
            None => left.push(near),
        }
    }
    while let Some((quotient, pair, indices)) = quadratic_factor(&rest, &left)? {
        rest = quotient;
        exact.extend(pair.map(Root::Exact));
        left = left.into_iter().enumerate().filter(|(i, _)| !indices.contains(i)).map(|(_, z)| z).collect();
    }
    exact.extend(left.into_iter().map(Root::Number));
    Some(exact)
}

fn is_real(near: Complex) -> bool {
    // Approximate roots have nine digits (`numeric_roots`); only what divides the polynomial exactly is taken from them.
    near.im.abs() <= 1e-9 * near.abs()
}

/// The quotient after division by a quadratic factor, its two roots, and their indices among the approximate values.
type Quadratic = (Vec<Rational>, [Surd; 2], [usize; 2]);

/// Finds a factor x² − px + q with real roots and divides by it.
fn quadratic_factor(polynomial: &[Rational], near: &[Complex]) -> Option<Option<Quadratic>> {
    let real: Vec<(usize, f64)> =
        near.iter().enumerate().filter(|(_, z)| is_real(**z)).map(|(i, z)| (i, z.re)).collect();
    for (k, (i, a)) in real.iter().enumerate() {
        for (j, b) in &real[k + 1..] {
            let Some((p, q)) = simplest(a + b, a.abs() + b.abs()).zip(simplest(a * b, (a * b).abs())) else {
                continue;
            };
            let factor = [q.clone(), -p.clone(), Rational::from(1)];
            if let Some(quotient) = divided_exactly(polynomial, &factor) {
                return Some(Some((quotient, quadratic_roots(&p, &q)?, [*i, *j])));
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

/// Approximate roots; coefficients beyond `f64` are scaled by the leading one. `None` if the rounded
/// coefficients do not determine nine digits of the roots, as for degrees of twelve and more.
fn numeric_roots(polynomial: &[Rational]) -> Option<Vec<Complex>> {
    let polynomial = trimmed(polynomial.to_vec());
    let Some(leading) = polynomial.last() else { return Some(vec![]) };
    let ratio = |c: &Rational| c.checked_div(leading).map_or(f64::NAN, |c| c.to_f64());
    roots_in_digits(&polynomial.iter().map(ratio).collect::<Vec<f64>>(), 1e-9)
}

/// The roots of c₀ + c₁x + …; `None` if the error of one may exceed this fraction of the largest root.
pub(super) fn roots_in_digits(coefficients: &[f64], part: f64) -> Option<Vec<Complex>> {
    let roots = polynomial_roots(coefficients)?;
    let largest = roots.iter().map(|root| root.value.abs()).fold(0.0, f64::max);
    let is_known = |error: f64| error <= part * largest;
    roots.into_iter().map(|root| is_known(root.error).then_some(root.value)).collect()
}
