//! The exponents of small motions.

use super::error::ModesError;
use super::linearisation::{Linear, Linearisation};
use super::roots::{Root, roots, roots_in_digits};
use libration_numbers::algebra::{Complex, Doubles, Rational, Rationals, Ring, Surd};
use libration_numbers::internals::linear::{characteristic_polynomial, eigenvalues};

/// One exponent, or several equal ones.
#[derive(Clone, Debug)]
pub(super) struct Exponent {
    pub(super) value: Complex,
    /// −s², if it is known exactly.
    pub(super) exact: Option<Surd>,
    pub(super) multiplicity: usize,
}

/// Difference, relative to the largest, below which approximate numbers are equal.
const SAME: f64 = 1e-9;

/// The exponents with nonnegative imaginary parts. For a conservative system, where −s is an exponent together with s, one of the two is kept.
pub(super) fn spectrum(linear: &Linear) -> Result<Vec<Exponent>, ModesError> {
    let found = match &linear.exact {
        Some(exact) => from_fractions(exact, &linear.numbers).or_else(|| from_numbers(&linear.numbers)),
        None => from_numbers(&linear.numbers),
    };
    let mut found = found.ok_or(ModesError::NoEigenvalues)?;
    found.sort_by(|a, b| a.value.im.total_cmp(&b.value.im).then(a.value.re.total_cmp(&b.value.re)));
    Ok(found)
}

fn from_fractions(linear: &Linearisation<Rational>, numbers: &Linearisation<f64>) -> Option<Vec<Exponent>> {
    let polynomial = characteristic_polynomial(&Rationals, &first_order(&Rationals, linear)?)?;
    if !polynomial.iter().skip(1).step_by(2).all(Rational::is_zero) {
        return None;
    }
    let squares = in_squares(&Rationals, &polynomial);
    let digits = if has_velocities(numbers) { vec![] } else { in_groups(&eigenvalues(&numbers.stiffness)?) };
    Some(
        roots(&squares, &digits)?
            .into_iter()
            .map(|(root, multiplicity)| of_square(&root, multiplicity))
            .collect(),
    )
}

fn from_numbers(linear: &Linearisation<f64>) -> Option<Vec<Exponent>> {
    let squares =
        if has_velocities(linear) { squares_of_gyroscopic(linear) } else { eigenvalues(&linear.stiffness) };
    match squares {
        Some(squares) => Some(
            gathered(&squares)
                .into_iter()
                .map(|(value, multiplicity)| of_square(&Root::Number(value), multiplicity))
                .collect(),
        ),
        None => {
            let upper = gathered(&eigenvalues(&first_order(&Doubles, linear)?)?);
            let upper = upper.into_iter().filter(|(value, _)| value.im >= 0.0);
            Some(upper.map(|(value, multiplicity)| Exponent { value, exact: None, multiplicity }).collect())
        }
    }
}

fn has_velocities(linear: &Linearisation<f64>) -> bool {
    linear.velocity.iter().flatten().any(|x| *x != 0.0)
}

/// −s² for every pair of exponents ±s; `None` if the exponents do not form such pairs.
fn squares_of_gyroscopic(linear: &Linearisation<f64>) -> Option<Vec<Complex>> {
    let polynomial = characteristic_polynomial(&Doubles, &first_order(&Doubles, linear)?)?;
    let largest = polynomial.iter().fold(0.0, |most: f64, c| most.max(c.abs()));
    if polynomial.iter().skip(1).step_by(2).any(|c| c.abs() > 1e-12 * largest) {
        return None;
    }
    /// Relative difference of equal exponents, which have half the digits.
    const DIGITS: f64 = 1e-6;
    roots_in_digits(&in_squares(&Doubles, &polynomial), DIGITS)
}

/// The matrix of x′ = v, v′ = −A·x + G·v.
fn first_order<R: Ring>(ring: &R, linear: &Linearisation<R::Element>) -> Option<Vec<Vec<R::Element>>> {
    let n = linear.stiffness.len();
    let one = ring.rational(&1.into())?;
    let upper =
        (0..n).map(|i| (0..2 * n).map(|j| if j == i + n { one.clone() } else { ring.zero() }).collect());
    let rows = linear.stiffness.iter().zip(&linear.velocity);
    let lower = rows.map(|(a, g)| a.iter().map(|x| ring.negate(x)).chain(g.iter().cloned()).collect());
    Some(upper.chain(lower).collect())
}

/// Σ c₂ₖs^{2k} as a polynomial in −s².
fn in_squares<R: Ring>(ring: &R, polynomial: &[R::Element]) -> Vec<R::Element> {
    let even = polynomial.iter().step_by(2).enumerate();
    even.map(|(k, c)| if k % 2 == 0 { c.clone() } else { ring.negate(c) }).collect()
}

/// The exponent with a given −s².
fn of_square(root: &Root, multiplicity: usize) -> Exponent {
    let square = root.to_complex();
    let real = square.im == 0.0;
    let value = match square.re {
        re if real && re >= 0.0 => Complex::new(0.0, re.sqrt()),
        re if real => Complex::new((-re).sqrt(), 0.0),
        _ => upper_square_root(-square),
    };
    Exponent { value, exact: root.exact().cloned(), multiplicity }
}

fn upper_square_root(z: Complex) -> Complex {
    let size = z.abs();
    let (re, im) = ((0.5 * (size + z.re)).max(0.0).sqrt(), (0.5 * (size - z.re)).max(0.0).sqrt());
    Complex::new(re.copysign(z.im), im)
}

/// Equal numbers with their multiplicities; rounding errors of real or zero values are removed.
fn gathered(values: &[Complex]) -> Vec<(Complex, usize)> {
    let clean = cleaned(values);
    in_groups(&values.iter().map(|z| Complex::new(clean(z.re), z.im)).collect::<Vec<_>>())
}

/// Returns a function that replaces numbers by zero if they are rounding errors compared with the largest of some values.
fn cleaned(values: &[Complex]) -> impl Fn(f64) -> f64 {
    let largest = values.iter().map(|z| z.abs()).fold(0.0, f64::max);
    move |x: f64| if x.abs() <= SAME * largest { 0.0 } else { x }
}

/// Equal numbers with their multiplicities; real numbers and conjugates of others are made exactly so.
fn in_groups(values: &[Complex]) -> Vec<(Complex, usize)> {
    let largest = values.iter().map(|z| z.abs()).fold(0.0, f64::max);
    let clean = cleaned(values);
    let mut groups: Vec<(Complex, usize)> = vec![];
    let is_same = |a: Complex, b: Complex| (a - b).abs() <= SAME * largest;
    for value in values.iter().map(|z| Complex::new(z.re, clean(z.im))) {
        let conjugate = Complex::new(value.re, -value.im);
        let partner = groups.iter().find(|(other, _)| is_same(*other, conjugate));
        let value = partner.map_or(value, |(other, _)| Complex::new(other.re, -other.im));
        match groups.iter_mut().find(|(other, _)| is_same(*other, value)) {
            Some((_, count)) => *count += 1,
            None => groups.push((value, 1)),
        }
    }
    groups
}
