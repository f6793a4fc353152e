//! The normal form of coupled oscillators, over any field.
//!
//! In complex amplitudes x = Re Σ aⱼφⱼ + …, with aⱼ′ = iωⱼaⱼ + Nⱼ(a, ā). Order by order, each monomial a^p ā^q of the
//! motion, with frequency Λ = Σ ωⱼ(pⱼ − qⱼ), is a forced oscillation. If the divisor Λ − ωⱼ is not small, the monomial
//! is divided by it and becomes part of the motion; otherwise it stays in Nⱼ and changes the amplitude slowly.

use super::polynomials::{AmplitudePolynomials, Polynomial, Powers};
use libration_numbers::internals::expression::{Jet, SeriesError, Tape};
use libration_numbers::internals::linear::solve;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Interrupted;
use libration_numbers::{
    algebra::Ring,
    internals::algebra::{Quadratic, QuadraticField},
};

/// Complex numbers over a field.
pub(super) type Complexes<N> = QuadraticField<N>;
pub(super) type ComplexOf<N> = Quadratic<<N as Ring>::Element>;
type PolynomialOf<N> = Polynomial<ComplexOf<N>>;

/// The linear motion: frequencies and shapes; the largest component of each shape is 1.
pub(super) struct LinearMotion<N: Ring> {
    pub(super) numbers: Complexes<N>,
    pub(super) frequencies: Vec<N::Element>,
    pub(super) shapes: Vec<Vec<ComplexOf<N>>>,
    pub(super) rest: Vec<N::Element>,
}

/// A divisor with its mode and its monomial: Λ − ωⱼ.
#[derive(Clone, Debug)]
pub(super) struct DivisorOf<E> {
    pub(super) mode: usize,
    pub(super) powers: Powers,
    pub(super) divisor: E,
}

/// Expansion of a normal form: for each mode the slow terms, and the modal coordinates without the linear amplitudes.
pub(super) struct Expansion<N: Ring> {
    pub(super) slow: Vec<PolynomialOf<N>>,
    pub(super) transform: Vec<PolynomialOf<N>>,
    pub(super) divisors: Vec<DivisorOf<N::Element>>,
}

/// Reason why the expansion stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NormalFormObstacle {
    /// A value or a coefficient outside the field.
    NoSeries,
    Interrupted(Interrupted),
}

impl From<SeriesError> for NormalFormObstacle {
    fn from(_: SeriesError) -> Self {
        Self::NoSeries
    }
}

impl From<Interrupted> for NormalFormObstacle {
    fn from(interrupted: Interrupted) -> Self {
        Self::Interrupted(interrupted)
    }
}

/// Rules by which numbers are compared.
pub(super) struct DivisorRules<'a, E> {
    pub(super) number: &'a dyn Fn(&E) -> f64,
    /// Largest divisor that counts as a resonance.
    pub(super) smallest: f64,
}

/// Expands to an order in the amplitudes.
pub(super) fn expand<N: Ring + Clone>(
    linear: &LinearMotion<N>,
    judge: &DivisorRules<'_, N::Element>,
    tape: &Tape,
    order: usize,
    watch: &Watch<'_>,
) -> Result<Expansion<N>, NormalFormObstacle> {
    let n = linear.frequencies.len();
    let ring = AmplitudePolynomials { numbers: linear.numbers.clone(), generators: 2 * n };
    let still = linear.rest.iter().map(|x| ring.constant(linear.numbers.plain(x.clone())));
    let still: Vec<_> = still.chain((0..n).map(|_| ring.zero())).collect();
    let mut jet = Jet::new(&ring, tape, &still)?;
    let one = linear.numbers.rational(&1.into()).ok_or(NormalFormObstacle::NoSeries)?;
    let first: Vec<_> = (0..n).map(|s| ring.generator(s, one.clone())).collect();
    let basis = Basis::new(linear, judge)?;
    jet.extend(&basis.state(&ring, &first))?;
    let mut orders = vec![Order { transform: first, slow: vec![ring.zero(); n] }];
    let mut divisors = vec![];
    for k in 2..=order {
        watch.reached(k)?;
        jet.extend(&vec![ring.zero(); 2 * n])?;
        let forces = (0..n).map(|i| jet.result(i).last().cloned().ok_or(NormalFormObstacle::NoSeries));
        let forces = forces.collect::<Result<Vec<_>, _>>()?;
        jet.shorten();
        let transport = transport(&ring, &orders, k);
        let parts = (0..n).map(|s| {
            let rest = ring.subtract(&basis.projected(&ring, &forces, s), &transport[s]);
            solved(&ring, linear, judge, s, &rest, &mut divisors)
        });
        let (transform, slow): (Vec<_>, Vec<_>) = parts.collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
        jet.extend(&basis.state(&ring, &transform))?;
        orders.push(Order { transform, slow });
    }
    let sum = |parts: &dyn Fn(&Order<N>) -> PolynomialOf<N>| {
        orders[1..].iter().fold(ring.zero(), |sum, order| ring.add(&sum, &parts(order)))
    };
    Ok(Expansion {
        slow: (0..n).map(|s| sum(&|order| order.slow[s].clone())).collect(),
        transform: (0..n).map(|s| sum(&|order| order.transform[s].clone())).collect(),
        divisors,
    })
}

/// Terms that one order adds.
struct Order<N: Ring> {
    transform: Vec<PolynomialOf<N>>,
    slow: Vec<PolynomialOf<N>>,
}

/// The conjugate of a polynomial: amplitudes and their conjugates are exchanged.
fn conjugate<N: Ring>(ring: &AmplitudePolynomials<Complexes<N>>, a: &PolynomialOf<N>) -> PolynomialOf<N> {
    let n = ring.generators / 2;
    let base = &ring.numbers.base;
    let term = |(powers, value): (&Powers, &ComplexOf<N>)| {
        let powers = [&powers[n..], &powers[..n]].concat();
        (powers, Quadratic { plain: value.plain.clone(), root: base.negate(&value.root) })
    };
    a.iter().map(term).collect()
}

/// Terms from the transport by the slow terms of lower orders: Σ Nₜ·∂Z/∂aₜ.
fn transport<N: Ring>(
    ring: &AmplitudePolynomials<Complexes<N>>,
    orders: &[Order<N>],
    k: usize,
) -> Vec<PolynomialOf<N>> {
    let n = ring.generators / 2;
    let mut sums = vec![ring.zero(); n];
    for l in 2..k {
        let (slow, carried) = (&orders[l - 1].slow, &orders[k - l].transform);
        for (t, rate) in slow.iter().enumerate().filter(|(_, rate)| !ring.is_zero(rate)) {
            let rates = [(t, rate.clone()), (n + t, conjugate(ring, rate))];
            for (generator, rate) in &rates {
                for (sum, series) in sums.iter_mut().zip(carried) {
                    let slope = ring.derivative(series, *generator);
                    *sum = ring.add(sum, &ring.multiply(rate, &slope));
                }
            }
        }
    }
    sums
}

type Parts<N> = (PolynomialOf<N>, PolynomialOf<N>);

/// Solves (iΛ − iω)·Z + N = R, monomial by monomial.
fn solved<N: Ring>(
    ring: &AmplitudePolynomials<Complexes<N>>,
    linear: &LinearMotion<N>,
    judge: &DivisorRules<'_, N::Element>,
    mode: usize,
    rest: &PolynomialOf<N>,
    divisors: &mut Vec<DivisorOf<N::Element>>,
) -> Result<Parts<N>, NormalFormObstacle> {
    let base = &linear.numbers.base;
    let (mut transform, mut slow) = (ring.zero(), ring.zero());
    for (powers, value) in rest {
        let divisor = divisor(linear, mode, powers);
        if base.is_zero(&divisor) || (judge.number)(&divisor).abs() <= judge.smallest {
            slow.insert(powers.clone(), value.clone());
            divisors.push(DivisorOf { mode, powers: powers.clone(), divisor });
            continue;
        }
        let below = Quadratic { plain: base.zero(), root: divisor.clone() };
        let part = linear.numbers.divide(value, &below).ok_or(NormalFormObstacle::NoSeries)?;
        transform.insert(powers.clone(), part);
        divisors.push(DivisorOf { mode, powers: powers.clone(), divisor });
    }
    Ok((transform, slow))
}

/// Λ − ωⱼ.
fn divisor<N: Ring>(linear: &LinearMotion<N>, mode: usize, powers: &Powers) -> N::Element {
    let base = &linear.numbers.base;
    let (plain, conjugates) = powers.split_at(powers.len() / 2);
    let terms = linear.frequencies.iter().zip(plain.iter().zip(conjugates));
    let sum = terms.fold(base.zero(), |sum, (frequency, (p, q))| {
        base.add(&sum, &base.times_integer(frequency, i64::from(*p) - i64::from(*q)))
    });
    base.subtract(&sum, &linear.frequencies[mode])
}

/// Modal coordinates: x = Re Σ zⱼφⱼ and v = Re Σ iωⱼzⱼφⱼ for motions of the linear system.
struct Basis<N: Ring> {
    /// φ/2 and iωφ/2, a row for each mode.
    columns: Vec<Vec<ComplexOf<N>>>,
    /// Projection of an acceleration of each coordinate onto the modes: a row for each mode.
    projection: Vec<Vec<ComplexOf<N>>>,
}

impl<N: Ring + Clone> Basis<N> {
    fn new(
        linear: &LinearMotion<N>,
        judge: &DivisorRules<'_, N::Element>,
    ) -> Result<Self, NormalFormObstacle> {
        let (numbers, n) = (&linear.numbers, linear.frequencies.len());
        let halved = |z: &ComplexOf<N>| numbers.over_integer(z, 2).ok_or(NormalFormObstacle::NoSeries);
        let column = |(shape, frequency): (&Vec<ComplexOf<N>>, &N::Element)| {
            let turned = Quadratic { plain: numbers.base.zero(), root: frequency.clone() };
            let displacements = shape.iter().map(&halved).collect::<Result<Vec<_>, _>>()?;
            let velocities: Vec<_> = displacements.iter().map(|z| numbers.multiply(z, &turned)).collect();
            Ok([displacements, velocities].concat())
        };
        let columns = linear.shapes.iter().zip(&linear.frequencies).map(column);
        let columns = columns.collect::<Result<Vec<_>, NormalFormObstacle>>()?;
        let bar = |z: &ComplexOf<N>| Quadratic { plain: z.plain.clone(), root: numbers.base.negate(&z.root) };
        let matrix: Vec<Vec<ComplexOf<N>>> = (0..2 * n)
            .map(|i| {
                (0..2 * n)
                    .map(|j| if j < n { columns[j][i].clone() } else { bar(&columns[j - n][i]) })
                    .collect()
            })
            .collect();
        let size = |z: &ComplexOf<N>| libm::hypot((judge.number)(&z.plain), (judge.number)(&z.root));
        let one = numbers.rational(&1.into()).ok_or(NormalFormObstacle::NoSeries)?;
        let solution = |i: usize| {
            let right: Vec<_> =
                (0..2 * n).map(|j| if j == n + i { one.clone() } else { numbers.zero() }).collect();
            solve(numbers, size, &matrix, &right).ok_or(NormalFormObstacle::NoSeries)
        };
        let solutions = (0..n).map(solution).collect::<Result<Vec<_>, _>>()?;
        let projection = (0..n).map(|s| solutions.iter().map(|column| column[s].clone()).collect()).collect();
        Ok(Self { columns, projection })
    }

    /// Coordinates, then velocities, from modal coordinates.
    fn state(
        &self,
        ring: &AmplitudePolynomials<Complexes<N>>,
        modal: &[PolynomialOf<N>],
    ) -> Vec<PolynomialOf<N>> {
        let n = self.columns.len();
        let component = |i: usize| {
            let half = modal
                .iter()
                .zip(&self.columns)
                .fold(ring.zero(), |sum, (z, column)| ring.add(&sum, &ring.scaled(z, &column[i])));
            ring.add(&half, &conjugate(ring, &half))
        };
        (0..2 * n).map(component).collect()
    }

    fn projected(
        &self,
        ring: &AmplitudePolynomials<Complexes<N>>,
        forces: &[PolynomialOf<N>],
        mode: usize,
    ) -> PolynomialOf<N> {
        let terms = forces.iter().zip(&self.projection[mode]);
        terms.fold(ring.zero(), |sum, (force, part)| ring.add(&sum, &ring.scaled(force, part)))
    }
}
