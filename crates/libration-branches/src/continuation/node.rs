//! A point on a branch, with its direction and test functions.

use super::corrector::{Corrected, Corrector};
use super::family::Image;
use super::point::BranchPoint;
use super::units::{difference, in_units, largest_swing};
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
    /// Errors of the last three test functions from those of the multipliers.
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
        place: &[f64],
        [across, along]: [&[f64]; 2],
        width: f64,
    ) -> Option<Self> {
        let mut sizes = vec![1.0; place.len()];
        *sizes.last_mut()? = width;
        let mut node: Option<Self> = None;
        for _ in 0..2 {
            let corrected = corrector.corrected(place, &in_units(across, &sizes), &sizes)?;
            let found = Self::new(corrector, corrected, along, &sizes)?;
            sizes = corrector.family.units(&found.point, largest_swing(&found.point), width);
            node = Some(found);
        }
        node
    }

    pub(super) fn place(&self) -> &[f64] {
        &self.corrected.place
    }
}

impl Tests {
    /// The tests of a map whose multipliers are taken as exact.
    pub(super) fn new(image: &Image, fold: f64) -> Option<Self> {
        let own = eigenvalues(image.return_map())?;
        Some(Self::of(&own.into_iter().map(|it| (it, 0.0)).collect::<Vec<_>>(), fold))
    }

    /// The tests of multipliers with their errors, by descending magnitude.
    fn of(own: &[(Complex, f64)], fold: f64) -> Self {
        let one = Complex::from(1.0);
        // The product of a large multiplier and its inverse has an error like that of the square of the large one.
        let largest = own.first().map_or(1.0, |(it, _)| it.abs().max(1.0));
        let rounding = largest * largest;
        let shifted = |by: f64| own.iter().map(move |(it, error)| (*it + Complex::from(by), *error));
        let pairs = (0..own.len()).flat_map(|i| (0..i).map(move |j| (own[i], own[j])));
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
            noise: [branching.1, flip.1, torus.1],
        }
    }
}

/// The real part of a product, and its error from the errors of the factors.
fn product(factors: impl Iterator<Item = (Complex, f64)>) -> (f64, f64) {
    let one = (Complex::from(1.0), 0.0);
    let (product, error) = factors.fold(one, |(product, error), (factor, own)| {
        (product * factor, error * (factor.abs() + own) + own * product.abs())
    });
    (product.re, error)
}

/// Hermite's cubic through two points with their directions, s from 0 to 1.
pub(super) fn between(a: &Node, b: &Node, units: &[f64], s: f64) -> Vec<f64> {
    let distance = norm(&difference(b.place(), a.place(), units));
    let slope = |node: &Node| {
        let size = norm(&node.direction.iter().zip(units).map(|(x, unit)| x / unit).collect::<Vec<_>>());
        node.direction.iter().map(|x| x * distance / size).collect::<Vec<_>>()
    };
    let (from, to) = (slope(a), slope(b));
    let (one, other) = (s * s * (3.0 - 2.0 * s), s * (1.0 - s));
    (0..from.len())
        .map(|j| {
            let [x, y] = [a.place()[j], b.place()[j]];
            x + one * (y - x) + other * ((1.0 - s) * from[j] - s * to[j])
        })
        .collect()
}
