//! A point on a branch, with its direction and test functions.

use super::corrector::{Corrected, Corrector};
use super::family::Image;
use super::point::BranchPoint;
use super::units::{difference, in_units};
use libration_motion::internals::periodic::norm;
use libration_numbers::algebra::Complex;
use libration_numbers::internals::linear::eigenvalues;

/// A point on a branch.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) corrected: Corrected,
    /// The direction along the branch, not in scaled units.
    pub(super) direction: Vec<f64>,
    pub(super) point: BranchPoint,
    pub(super) tests: Tests,
}

/// Test functions, each of which changes its sign at one kind of singular point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tests {
    /// Component of the unit tangent along the parameter; zero at a fold.
    pub(super) fold: f64,
    /// Real part of Π(λ − 1) over the multipliers λ of the map; zero if one of them is +1.
    pub(super) branching: f64,
    /// Real part of Π(λ + 1); zero if a multiplier is −1.
    pub(super) flip: f64,
    /// Real part of Π(λμ − 1) over the pairs of multipliers λ and μ, each factor in units of the square of the largest multiplier.
    pub(super) torus: f64,
    /// The discriminant of the sums λ + 1/λ, in units of the largest multiplier, if the multipliers are pairs λ and 1/λ as
    /// without damping; zero if two pairs meet.
    pub(super) collision: f64,
    /// `true` if the multipliers are pairs λ and 1/λ up to rounding.
    pub(super) is_reciprocal: bool,
    /// Errors of the branching, flip and torus functions from those of the multipliers.
    pub(super) noise: [f64; 3],
}

impl Node {
    /// A node whose direction agrees with another one.
    pub(super) fn new(
        corrector: &Corrector<'_>,
        corrected: Corrected,
        along: &[f64],
        units: &[f64],
    ) -> Option<Self> {
        let along = in_units(along, units);
        // At a crossing of branches the direction is not unique.
        let tangent = corrector.tangent(&corrected.image, &along, units).unwrap_or(along);
        let (point, multipliers) = corrector.point(&corrected, &tangent, units)?;
        let tests = Tests::of(&multipliers, tangent.last().copied()?);
        let direction = tangent.iter().zip(units).map(|(t, unit)| t * unit).collect();
        Some(Self { corrected, direction, point, tests })
    }

    /// The node nearest to a point, perpendicular to one direction and oriented along another, for a parameter range of this width. It is
    /// computed twice: first to learn the sizes of its motion, then with these sizes as units.
    pub(super) fn near(
        corrector: &Corrector<'_>,
        position: &[f64],
        [across, along]: [&[f64]; 2],
        width: f64,
    ) -> Option<Self> {
        let mut sizes = corrector.family.first_units(position, width);
        let mut node: Option<Self> = None;
        for _ in 0..2 {
            let corrected = corrector.corrected(position, &in_units(across, &sizes), &sizes)?;
            let next = Self::new(corrector, corrected, along, &sizes)?;
            sizes = corrector.family.units(&next.point, corrector.family.largest_swing(&next.point), width);
            node = Some(next);
        }
        node
    }

    pub(super) fn position(&self) -> &[f64] {
        &self.corrected.position
    }
}

impl Tests {
    /// The tests of a map whose multipliers are taken as exact.
    pub(super) fn new(image: &Image, fold: f64) -> Option<Self> {
        let multipliers = eigenvalues(image.return_map())?;
        Some(Self::of(&multipliers.into_iter().map(|multiplier| (multiplier, 0.0)).collect::<Vec<_>>(), fold))
    }

    /// The tests of multipliers with their errors, by descending magnitude.
    pub(super) fn of(multipliers: &[(Complex, f64)], fold: f64) -> Self {
        let one = Complex::from(1.0);
        // The product of a large multiplier and its inverse has an error like that of the square of the large one.
        let largest = multipliers.first().map_or(1.0, |(multiplier, _)| multiplier.abs().max(1.0));
        let rounding = largest * largest;
        let shifted = |by: f64| {
            multipliers.iter().map(move |(multiplier, error)| (*multiplier + Complex::from(by), *error))
        };
        let pairs =
            (0..multipliers.len()).flat_map(|i| (0..i).map(move |j| (multipliers[i], multipliers[j])));
        let products = pairs.map(|((a, e), (b, f))| {
            let error = e * b.abs() + f * a.abs() + e * f;
            ((a * b - one).scaled(1.0 / rounding), error / rounding)
        });
        let [branching, flip, torus] = [product(shifted(-1.0)), product(shifted(1.0)), product(products)];
        Self {
            fold,
            branching: branching.0,
            flip: flip.0,
            torus: torus.0,
            collision: collision(multipliers, largest),
            is_reciprocal: is_reciprocal(multipliers, largest),
            noise: [branching.1, flip.1, torus.1],
        }
    }
}

/// `true` if the power sums of the multipliers are those of their inverses, and their product is 1.
fn is_reciprocal(multipliers: &[(Complex, f64)], largest: f64) -> bool {
    /// A damping that changes a multiplier by less than this part moves boundaries by its square.
    const ROUNDING: f64 = 1e-10;
    let one = Complex::from(1.0);
    let (mut powers, mut inverses) = (vec![one; multipliers.len()], vec![one; multipliers.len()]);
    let product = multipliers.iter().fold(one, |product, (multiplier, _)| product * *multiplier);
    let mut scale = 1.0;
    (product - one).abs() <= ROUNDING * largest
        && (0..multipliers.len() / 2).all(|_| {
            scale *= largest;
            powers
                .iter_mut()
                .zip(multipliers)
                .for_each(|(power, (multiplier, _))| *power = *power * *multiplier);
            inverses
                .iter_mut()
                .zip(multipliers)
                .for_each(|(inverse, (multiplier, _))| *inverse = *inverse / *multiplier);
            let sums = powers.iter().zip(&inverses).map(|(a, b)| (*a - *b).re);
            sums.sum::<f64>().abs() <= ROUNDING * scale
        })
}

/// The discriminant of the numbers a = λ + 1/λ over pairs of multipliers, relative to the largest multiplier: the determinant
/// of their power sums Σaᵏ, which follow from Σλᵐ. Zero without two pairs.
fn collision(multipliers: &[(Complex, f64)], largest: f64) -> f64 {
    let pairs = multipliers.len() / 2;
    if pairs < 2 || multipliers.len() % 2 == 1 {
        return 0.0;
    }
    let mut powers = vec![Complex::from(1.0); multipliers.len()];
    let mut traces = vec![];
    for _ in 0..2 * pairs - 1 {
        traces.push(powers.iter().map(|power| power.re).sum::<f64>());
        powers.iter_mut().zip(multipliers).for_each(|(power, (multiplier, _))| *power = *power * *multiplier);
    }
    // Σaᵏ = ½ Σ C(k, j) Σλ^(k−2j), since a pair contributes λᵐ + λ⁻ᵐ.
    let (mut row, mut sums, mut scale) = (vec![1.0], vec![], 1.0);
    for k in 0..traces.len() {
        let terms = row.iter().enumerate().map(|(j, binomial)| binomial * traces[k.abs_diff(2 * j)]);
        sums.push(0.5 * terms.sum::<f64>() / scale);
        let inner = row.windows(2).map(|pair| pair[0] + pair[1]);
        row = [1.0].into_iter().chain(inner).chain([1.0]).collect();
        scale *= largest;
    }
    let matrix: Vec<Vec<f64>> = (0..pairs).map(|i| sums[i..i + pairs].to_vec()).collect();
    eigenvalues(&matrix)
        .map_or(f64::NAN, |values| values.into_iter().fold(Complex::from(1.0), |a, b| a * b).re)
}

/// The real part of a product, and its error from the errors of the factors.
fn product(factors: impl Iterator<Item = (Complex, f64)>) -> (f64, f64) {
    let one = (Complex::from(1.0), 0.0);
    let (product, error) = factors.fold(one, |(product, error), (factor, factor_error)| {
        (product * factor, error * (factor.abs() + factor_error) + factor_error * product.abs())
    });
    (product.re, error)
}

/// Hermite's cubic through two points with their directions, s from 0 to 1.
pub(super) fn between(a: &Node, b: &Node, units: &[f64], s: f64) -> Vec<f64> {
    let distance = norm(&difference(b.position(), a.position(), units));
    let slope = |node: &Node| {
        let size = norm(&node.direction.iter().zip(units).map(|(x, unit)| x / unit).collect::<Vec<_>>());
        node.direction.iter().map(|x| x * distance / size).collect::<Vec<_>>()
    };
    let (from, to) = (slope(a), slope(b));
    let (one, other) = (s * s * (3.0 - 2.0 * s), s * (1.0 - s));
    (0..from.len())
        .map(|j| {
            let [x, y] = [a.position()[j], b.position()[j]];
            x + one * (y - x) + other * ((1.0 - s) * from[j] - s * to[j])
        })
        .collect()
}
