//! The shapes of the modes.

use super::linearisation::{Linear, Linearisation};
use super::spectrum::Exponent;
use libration_numbers::internals::linear::null_space;
use libration_numbers::{
    algebra::{Complex, Doubles, Rational, Rationals, Ring, Surd},
    internals::algebra::{Quadratic, QuadraticField},
};

/// The components of a mode, the largest being 1.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    pub(super) parts: Vec<Complex>,
    pub(super) exact: Option<Vec<Surd>>,
}

/// Largest remainder that counts as zero, relative to the terms, for exponents with at least half of their digits.
const ROUNDING: f64 = 1e-6;

/// Shapes of the modes with this exponent, as many as its multiplicity.
pub(super) fn shapes(linear: &Linear, exponent: &Exponent) -> Vec<Shape> {
    let without_velocities = linear.numbers.velocity.iter().flatten().all(|x| *x == 0.0);
    let exact = linear.exact.as_ref().zip(exponent.exact.as_ref()).filter(|_| without_velocities);
    if let Some(shapes) = exact.and_then(|(linear, square)| exactly(linear, square, exponent.multiplicity)) {
        return shapes;
    }
    let square = -(exponent.value * exponent.value);
    let vectors = if without_velocities && square.im == 0.0 {
        let matrix = shifted(&Doubles, &linear.numbers.stiffness, &square.re);
        let scale = square.re.abs() + largest(&linear.numbers.stiffness);
        let vectors = null_vectors(&Doubles, |x| x.abs(), ROUNDING * scale, &matrix, exponent.multiplicity);
        vectors.iter().map(|vector| vector.iter().map(|x| Complex::from(*x)).collect()).collect()
    } else {
        complex_vectors(&linear.numbers, exponent)
    };
    vectors.iter().map(|parts| Shape { parts: scaled(parts), exact: None }).collect()
}

fn exactly(linear: &Linearisation<Rational>, square: &Surd, multiplicity: usize) -> Option<Vec<Shape>> {
    let field = QuadraticField { base: Rationals, square: square.radicand().clone() };
    let element = |x: &Rational| field.plain(x.clone());
    let matrix: Vec<Vec<_>> = linear.stiffness.iter().map(|row| row.iter().map(element).collect()).collect();
    let square = Quadratic { plain: square.plain().clone(), root: square.root().clone() };
    let surd = |x: &Quadratic<Rational>| Surd::new(x.plain.clone(), x.root.clone(), field.square.clone());
    let size = |x: &Quadratic<Rational>| surd(x).to_f64().abs();
    let vectors = null_vectors(&field, size, 0.0, &shifted(&field, &matrix, &square), multiplicity);
    let shape = |vector: &Vec<Quadratic<Rational>>| {
        let leading = leading(vector.iter().map(size));
        let parts = vector.iter().map(|x| field.divide(x, &vector[leading]).as_ref().map(surd));
        let exact = parts.collect::<Option<Vec<Surd>>>()?;
        Some(Shape { parts: exact.iter().map(|x| Complex::from(x.to_f64())).collect(), exact: Some(exact) })
    };
    vectors.iter().map(shape).collect::<Option<Vec<_>>>().filter(|shapes| !shapes.is_empty())
}

/// A − λ.
fn shifted<R: Ring>(ring: &R, matrix: &[Vec<R::Element>], by: &R::Element) -> Vec<Vec<R::Element>> {
    let mut shifted = matrix.to_vec();
    for (i, row) in shifted.iter_mut().enumerate() {
        row[i] = ring.subtract(&row[i], by);
    }
    shifted
}

/// Independent vectors that the matrix maps to zero within a rounding error, at most `most` of them.
fn null_vectors<R: Ring>(
    ring: &R,
    size: impl Fn(&R::Element) -> f64 + Copy,
    rounding: f64,
    matrix: &[Vec<R::Element>],
    most: usize,
) -> Vec<Vec<R::Element>> {
    let vanishes = |vector: &Vec<R::Element>| {
        let longest = vector.iter().map(size).fold(1.0, f64::max);
        matrix.iter().all(|row| {
            let terms = row.iter().zip(vector);
            let product = terms.fold(ring.zero(), |sum, (a, x)| ring.add(&sum, &ring.multiply(a, x)));
            ring.is_zero(&product) || size(&product) < rounding * longest
        })
    };
    let attempts = (1..=most).rev().filter_map(|dimension| null_space(ring, size, matrix, dimension));
    attempts.into_iter().find(|vectors| vectors.iter().all(vanishes)).unwrap_or_default()
}

fn largest(matrix: &[Vec<f64>]) -> f64 {
    matrix.iter().flatten().fold(0.0, |most, x| most.max(x.abs()))
}

/// The null vectors of s² − s·G + A as complex vectors, from the real equations for both parts.
fn complex_vectors(linear: &Linearisation<f64>, exponent: &Exponent) -> Vec<Vec<Complex>> {
    let n = linear.stiffness.len();
    let (s, square) = (exponent.value, exponent.value * exponent.value);
    let entry = |i: usize, j: usize| {
        let diagonal = if i == j { square } else { Complex::default() };
        diagonal - s.scaled(linear.velocity[i][j]) + Complex::from(linear.stiffness[i][j])
    };
    let real = |i: usize, j: usize| match (i < n, j < n) {
        (true, true) | (false, false) => entry(i % n, j % n).re,
        (true, false) => -entry(i, j - n).im,
        (false, true) => entry(i - n, j).im,
    };
    let matrix: Vec<Vec<f64>> = (0..2 * n).map(|i| (0..2 * n).map(|j| real(i, j)).collect()).collect();
    let scale = square.abs() + s.abs() * largest(&linear.velocity) + largest(&linear.stiffness);
    let vectors = null_vectors(&Doubles, |x| x.abs(), ROUNDING * scale, &matrix, 2 * exponent.multiplicity);
    let mut shapes: Vec<Vec<Complex>> = vec![];
    for vector in vectors {
        let shape = scaled(&(0..n).map(|i| Complex::new(vector[i], vector[i + n])).collect::<Vec<_>>());
        // Shapes have a largest part of one; those of a multiple exponent lose half of the digits.
        let same = |other: &Vec<Complex>| other.iter().zip(&shape).all(|(a, b)| (*a - *b).abs() < 1e-6);
        if !shapes.iter().any(same) && shapes.len() < exponent.multiplicity {
            shapes.push(shape);
        }
    }
    shapes
}

fn scaled(vector: &[Complex]) -> Vec<Complex> {
    let leading = leading(vector.iter().map(|z| z.abs()));
    vector
        .iter()
        .enumerate()
        .map(|(i, z)| if i == leading { Complex::from(1.0) } else { *z / vector[leading] })
        .collect()
}

/// The first index whose size is the largest up to rounding errors.
fn leading(sizes: impl Iterator<Item = f64> + Clone) -> usize {
    let largest = sizes.clone().fold(0.0, f64::max);
    sizes.into_iter().position(|size| size >= (1.0 - 1e-9) * largest).unwrap_or(0)
}
