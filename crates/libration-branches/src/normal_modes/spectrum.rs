//! The exponents of small motions.

use super::error::ModesError;
use super::linearisation::{Linear, Linearisation};
use super::roots::{Root, roots};
use libration_kernels::elementary::count;
use libration_numbers::algebra::{Complex, Doubles, Rational, Rationals, Ring, Surd};
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::internals::linear::{
    characteristic_polynomial, eigenvalue_errors, eigenvalues, solve_complex,
};
use libration_numbers::roots::polynomial_roots;

/// One exponent, or several equal ones.
#[derive(Clone, Debug)]
pub(super) struct Exponent {
    pub(super) value: Complex,
    /// −s², if it is known exactly.
    pub(super) exact: Option<Surd>,
    pub(super) multiplicity: usize,
}

/// An approximate number with its error, within which others are equal to it: in stiff systems it is far below the small numbers, though these are
/// far below the large ones.
type Known = (Complex, f64);

/// The exponents with nonnegative imaginary parts. For a conservative system, where −s is an exponent together with s, one of the two is kept.
pub(super) fn spectrum(linear: &Linear) -> Result<Vec<Exponent>, ModesError> {
    let exact = linear.exact.as_ref().and_then(|exact| polynomial(&Rationals, exact));
    let is_odd = exact.as_ref().is_some_and(|exact| !is_even(exact));
    let in_fractions = exact.and_then(|exact| match exact.as_slice() {
        [c, b, _] if is_odd => Some(of_quadratic(c, b)),
        _ if is_odd => None,
        even => from_fractions(even, &linear.numbers),
    });
    let outcome = in_fractions.or_else(|| from_numbers(&linear.numbers, is_odd));
    let mut exponents = outcome.ok_or(ModesError::NoEigenvalues)?;
    exponents.put_in_order(|a, b| a.value.im.total_cmp(&b.value.im).then(a.value.re.total_cmp(&b.value.re)));
    Ok(exponents)
}

fn polynomial<R: Ring>(ring: &R, linear: &Linearisation<R::Element>) -> Option<Vec<R::Element>> {
    characteristic_polynomial(ring, &first_order(ring, linear)?)
}

/// Returns `true` if −s is a zero together with s.
fn is_even(polynomial: &[Rational]) -> bool {
    polynomial.iter().skip(1).step_by(2).all(Rational::is_zero)
}

/// The exponents with s² + bs + c = 0, which have all digits however near they are to each other or to the imaginary axis.
fn of_quadratic(c: &Rational, b: &Rational) -> Vec<Exponent> {
    let exponent = |re: f64, im: f64, multiplicity: usize| Exponent {
        value: Complex::new(re, im),
        exact: None,
        multiplicity,
    };
    let half = b.divided_by_power_of_two(1);
    let square = Rationals.subtract(&Rationals.multiply(&half, &half), c);
    let (half, root) = (half.to_f64(), square.to_f64().abs().sqrt());
    match () {
        () if square.is_zero() => vec![exponent(-half, 0.0, 2)],
        () if square.is_negative() => vec![exponent(-half, root, 1)],
        () => {
            let larger = -half - root.copysign(half);
            vec![exponent(larger, 0.0, 1), exponent(c.to_f64() / larger + 0.0, 0.0, 1)]
        }
    }
}

/// The exponents of a system with an even characteristic polynomial.
fn from_fractions(polynomial: &[Rational], numbers: &Linearisation<f64>) -> Option<Vec<Exponent>> {
    let squares = in_squares(&Rationals, polynomial);
    let digits =
        if has_velocities(numbers) { vec![] } else { in_groups(&known_eigenvalues(&numbers.stiffness)?) };
    Some(
        roots(&squares, &digits)?
            .into_iter()
            .map(|(root, multiplicity)| of_square(&root, multiplicity))
            .collect(),
    )
}

/// The exponents in numbers; `is_odd` if −s is not an exponent together with s.
fn from_numbers(linear: &Linearisation<f64>, is_odd: bool) -> Option<Vec<Exponent>> {
    let squares = match has_velocities(linear) {
        _ if is_odd => None,
        true => squares_of_gyroscopic(linear),
        false => known_eigenvalues(&linear.stiffness),
    };
    match squares {
        Some(squares) => Some(
            gathered(&squares)
                .into_iter()
                .map(|(value, multiplicity)| of_square(&Root::Number(value), multiplicity))
                .collect(),
        ),
        None => {
            let upper = gathered(&known_eigenvalues(&in_units(linear)?)?);
            let upper = upper.into_iter().filter(|(value, _)| value.im >= 0.0);
            Some(upper.map(|(value, multiplicity)| Exponent { value, exact: None, multiplicity }).collect())
        }
    }
}

fn has_velocities(linear: &Linearisation<f64>) -> bool {
    linear.velocity.iter().flatten().any(|x| *x != 0.0)
}

/// −s² for every pair of exponents ±s; `None` if the exponents do not form such pairs.
fn squares_of_gyroscopic(linear: &Linearisation<f64>) -> Option<Vec<Known>> {
    /// Rounding errors of a term, for the cube of the number of coordinates, and their largest sum.
    const ROUNDINGS: f64 = 16.0 * f64::EPSILON;
    const MOST: f64 = 1e-12;
    let polynomial = polynomial(&Doubles, linear)?;
    let rows = count(linear.stiffness.len());
    let rounding = MOST.min(ROUNDINGS * rows * rows * rows);
    let is_even = |exponent: Complex| {
        let size = exponent.abs();
        let terms = polynomial.iter().rev().fold((vec![], 1.0), |(mut terms, power), c| {
            terms.push((c * power).abs());
            (terms, power / size)
        });
        let largest = terms.0.iter().copied().fold(0.0, f64::max);
        terms.0.iter().skip(1).step_by(2).all(|term| *term <= rounding * largest)
    };
    if !eigenvalues(&in_units(linear)?)?.into_iter().filter(|eigenvalue| eigenvalue.abs() > 0.0).all(is_even)
    {
        return None;
    }
    /// Relative difference of equal exponents, which have half the digits.
    const DIGITS: f64 = 1e-6;
    let roots = polynomial_roots(&in_squares(&Doubles, &polynomial))?;
    let largest = roots.iter().map(|root| root.value.abs()).fold(0.0, f64::max);
    let is_certain = |error: f64| error <= DIGITS * largest;
    roots.into_iter().map(|root| is_certain(root.error).then_some((root.value, root.error))).collect()
}

/// The matrix of the first-order equations, each velocity in the unit in which the largest stiffness of its coordinate is about 1.
fn in_units(linear: &Linearisation<f64>) -> Option<Vec<Vec<f64>>> {
    let unit = |row: &Vec<f64>| {
        let largest = row.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        if largest > 0.0 { libm::exp2(libm::round(0.5 * libm::log2(largest))) } else { 1.0 }
    };
    let ones = linear.stiffness.iter().map(|_| 1.0);
    let units: Vec<f64> = ones.chain(linear.stiffness.iter().map(unit)).collect();
    let mut matrix = first_order(&Doubles, linear)?;
    for (row, unit_of_row) in matrix.iter_mut().zip(&units) {
        row.iter_mut().zip(&units).for_each(|(x, unit)| *x *= unit / unit_of_row);
    }
    Some(matrix)
}

/// The eigenvalues with bounds on the errors of the QR algorithm, which small ones do not have any more after Newton's corrections.
fn known_eigenvalues(matrix: &[Vec<f64>]) -> Option<Vec<Known>> {
    /// Rounding errors of an entry and of the QR algorithm for each row.
    const ROUNDINGS: f64 = 16.0;
    let values = eigenvalues(matrix)?;
    let norm = matrix.iter().flatten().fold(0.0, |norm, x| libm::hypot(norm, *x));
    let errors = eigenvalue_errors(matrix, &values, ROUNDINGS * count(matrix.len()) * f64::EPSILON * norm);
    Some(
        values
            .into_iter()
            .zip(errors)
            .map(|(value, error)| (corrected(matrix, value, error), error))
            .collect(),
    )
}

/// An eigenvalue after two of Newton's corrections, as long as they are within its error.
fn corrected(matrix: &[Vec<f64>], value: Complex, error: f64) -> Complex {
    /// Largest number of rows: the effort is that of their fourth power.
    const MOST: usize = 32;
    /// Number of corrections, the second of which is a rounding error.
    const CORRECTIONS: u32 = 2;
    let next = |value: Complex| correction(matrix, value).filter(|by| by.abs() <= error).map(|by| value + by);
    let most = if matrix.len() <= MOST { CORRECTIONS } else { 0 };
    (0..most).try_fold(value, |value, _| next(value).ok_or(value)).unwrap_or_else(|value| value)
}

/// The distance to an eigenvalue: c·G·b/c·G²·b with G = (A − λ)⁻¹ and any vectors b and c. `None` if A − λ is singular.
fn correction(matrix: &[Vec<f64>], near: Complex) -> Option<Complex> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let rows = 0..matrix.len();
    let entry =
        |i: usize, j: usize| Complex::from(matrix[i][j]) - if i == j { near } else { Complex::default() };
    let any: Vec<Complex> = rows.clone().map(|i| Complex::from(1.0 + (GOLDEN * count(i)).fract())).collect();
    let solved = |transposed: bool| {
        let row = |i: usize| {
            let entries = rows.clone().map(|j| if transposed { entry(j, i) } else { entry(i, j) });
            entries.collect::<Vec<_>>()
        };
        solve_complex(&rows.clone().map(row).collect::<Vec<_>>(), &any)
    };
    let (right, left) = (solved(false)?, solved(true)?);
    let product =
        |other: &[Complex]| left.iter().zip(other).fold(Complex::default(), |sum, (a, b)| sum + *a * *b);
    Some(product(&any) / product(&right))
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
fn gathered(values: &[Known]) -> Vec<(Complex, usize)> {
    let without = |(z, error): &Known| (Complex::new(cleaned(z.re, *error), z.im), *error);
    in_groups(&values.iter().map(without).collect::<Vec<_>>())
}

/// The number, or zero if that is within its error.
fn cleaned(x: f64, error: f64) -> f64 {
    if x.abs() <= error { 0.0 } else { x }
}

/// Equal numbers with their multiplicities; real numbers and conjugates of others are made exactly so.
fn in_groups(values: &[Known]) -> Vec<(Complex, usize)> {
    let mut groups: Vec<(Known, usize)> = vec![];
    let is_same = |(a, e): Known, (b, f): Known| (a - b).abs() <= e + f;
    for (z, error) in values {
        let value = Complex::new(z.re, cleaned(z.im, *error));
        let conjugate = |z: Complex| Complex::new(z.re, -z.im);
        let partner = groups.iter().find(|(other, _)| is_same(*other, (conjugate(value), *error)));
        let value = partner.map_or(value, |((other, _), _)| conjugate(*other));
        match groups.iter_mut().find(|(other, _)| is_same(*other, (value, *error))) {
            Some((_, count)) => *count += 1,
            None => groups.push(((value, *error), 1)),
        }
    }
    groups.into_iter().map(|((value, _), count)| (value, count)).collect()
}
