//! Lindstedt's expansion of a normal mode to third order, over any field.
//!
//! With τ = Ωt and Ω = ω(1 + wε²), x = xₑ + εx₁ + ε²x₂ + ε³x₃. At order n, for the harmonics c·cos kτ + s·sin kτ:
//!
//! ```text
//! (A − k²ω²)·c − kωG·s = Rc,    (A − k²ω²)·s + kωG·c = Rs,
//! ```
//!
//! Here R is the coefficient of the accelerations without xₙ. For n = 3 and k = 1 the matrix is singular; w·(2ω² + iωG)·φ is added on the right,
//! with the shape φ of the mode, and −g times the same term shifted by a quarter of a turn. The equations then determine w, the change of
//! frequency, and g, the growth, which must vanish. The first harmonic of the leading coordinate is exactly ε·cos τ.
//!
//! Reference: A. H. Nayfeh, D. T. Mook, *Nonlinear Oscillations*, Wiley 1979, chapter 6.

use libration_numbers::internals::expression::{Jet, SeriesError, Tape};
use libration_numbers::internals::linear::{null_space, solve};
use libration_numbers::{
    algebra::Ring,
    internals::algebra::{HarmonicPair, HarmonicSums, PhaseRing},
};

/// A mode over a field: ε·(cosine·cos τ + sine·sin τ); these are 1 and 0 for the leading coordinate.
pub(super) struct Fundamental<E> {
    pub(super) frequency: E,
    pub(super) cosine: Vec<E>,
    pub(super) sine: Vec<E>,
    pub(super) leading: usize,
}

/// Results of the third order.
pub(super) struct Third<E> {
    /// w.
    pub(super) frequency: E,
    /// g, with which the amplitude ε grows at the rate gωε³.
    pub(super) growth: E,
}

/// Reason why the expansion does not exist.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ModeObstacle {
    /// A value or a coefficient that is outside the field or not finite.
    NoSeries,
    /// The force contains this harmonic, which is the frequency of a free oscillation.
    Resonance(usize),
}

impl From<SeriesError> for ModeObstacle {
    fn from(_: SeriesError) -> Self {
        Self::NoSeries
    }
}

/// Rules by which numbers of a field are compared.
pub(super) struct ZeroRules<'a, E> {
    pub(super) size: &'a dyn Fn(&E) -> f64,
    /// Fraction of the largest number that counts as zero.
    pub(super) rounding: f64,
    /// Harmonics that are frequencies of free oscillations.
    pub(super) resonant: Vec<usize>,
}

/// One harmonic of all coordinates: k, the coefficients of cos kτ and those of sin kτ.
type Term<E> = (usize, Vec<E>, Vec<E>);

/// Frequency change and growth of the mode about an equilibrium. The inputs of the tape are coordinates and then velocities.
pub(super) fn third_order<N: Ring + Clone>(
    numbers: &N,
    judge: &ZeroRules<'_, N::Element>,
    tape: &Tape,
    rest: &[N::Element],
    mode: &Fundamental<N::Element>,
) -> Result<Third<N::Element>, ModeObstacle> {
    let (third, has_second) = with_free(numbers, judge, tape, rest, mode, None)?;
    // A mode with twice the frequency, across which others are driven, may move by itself at the second order, which must not matter.
    let has_free = has_second && judge.resonant.contains(&2);
    for free in (0..NULL_VECTORS).filter(|_| has_free) {
        let (other, _) = with_free(numbers, judge, tape, rest, mode, Some(free))?;
        let pairs = [(&third.frequency, &other.frequency), (&third.growth, &other.growth)];
        let differ = |(a, b): (&N::Element, &N::Element)| {
            let difference = numbers.subtract(a, b);
            !numbers.is_zero(&difference)
                && (judge.size)(&difference) > judge.rounding * (judge.size)(a).max(LEAST)
        };
        if pairs.into_iter().any(differ) {
            return Err(ModeObstacle::Resonance(2));
        }
    }
    Ok(third)
}

/// Independent vectors that the matrix of a harmonic maps to zero where it is the frequency of one free oscillation: both phases.
const NULL_VECTORS: usize = 2;
/// A change of the frequency below which differences of digits are not relative to it.
const LEAST: f64 = 1e-3;

/// The third order with a free oscillation of this number at the second order, and whether the second order has twice the frequency.
fn with_free<N: Ring + Clone>(
    numbers: &N,
    judge: &ZeroRules<'_, N::Element>,
    tape: &Tape,
    rest: &[N::Element],
    mode: &Fundamental<N::Element>,
    free: Option<usize>,
) -> Result<(Third<N::Element>, bool), ModeObstacle> {
    let ring = HarmonicSums { numbers: numbers.clone() };
    let none = vec![numbers.zero(); rest.len()];
    let still = state(&ring, &numbers.zero(), &[(0, rest.to_vec(), none)], rest.len());
    let jet = Jet::new(&ring, tape, &still)?;
    let linear = LinearEquations::new(&ring, &jet, tape, rest.len())?;
    let mut expansion = LindstedtExpansion { ring: &ring, jet, judge, mode, linear };
    expansion.extend(&[(1, mode.cosine.clone(), mode.sine.clone())])?;
    let mut second = expansion.forced(&[0, 2])?;
    if let Some(free) = free {
        let mut added =
            expansion.null_vectors(&expansion.matrix(2)).ok_or(ModeObstacle::Resonance(2))?.swap_remove(free);
        let sines = added.split_off(rest.len());
        second.push((2, added, sines));
    }
    expansion.extend(&second)?;
    let is_second = |(k, cosine, sine): &Term<N::Element>| {
        *k == 2 && cosine.iter().chain(sine).any(|x| !numbers.is_zero(x))
    };
    let has_second = second.iter().any(is_second);
    Ok((expansion.solvability()?, has_second))
}

/// x″ = −A·x + G·x′.
struct LinearEquations<E> {
    stiffness: Vec<Vec<E>>,
    velocity: Vec<Vec<E>>,
}

impl<E: Clone> LinearEquations<E> {
    fn new<N: Ring<Element = E>>(
        ring: &HarmonicSums<N>,
        jet: &Jet<'_, HarmonicSums<N>>,
        tape: &Tape,
        coordinates: usize,
    ) -> Result<Self, ModeObstacle> {
        let column = |input: usize| -> Result<Vec<E>, SeriesError> {
            let gains = jet.gains(input)?;
            Ok(tape.results().iter().map(|&slot| ring.harmonic(&gains[slot], 0).cosine).collect())
        };
        let columns = (0..2 * coordinates).map(column).collect::<Result<Vec<_>, _>>()?;
        let rows = |columns: &[Vec<E>], entry: &dyn Fn(&E) -> E| {
            (0..coordinates).map(|i| columns.iter().map(|column| entry(&column[i])).collect()).collect()
        };
        let (positions, velocities) = columns.split_at(coordinates);
        let stiffness = rows(positions, &|x| ring.numbers().negate(x));
        Ok(Self { stiffness, velocity: rows(velocities, &E::clone) })
    }
}

/// Coordinates and velocities with these harmonics at the frequency ω.
fn state<N: Ring>(
    ring: &HarmonicSums<N>,
    frequency: &N::Element,
    terms: &[Term<N::Element>],
    coordinates: usize,
) -> Vec<<HarmonicSums<N> as Ring>::Element> {
    let numbers = ring.numbers();
    let rate = |k: usize, x: &N::Element| {
        numbers.times_integer(&numbers.multiply(x, frequency), i64::try_from(k).unwrap_or(i64::MAX))
    };
    let position = |i: usize| {
        let harmonics = terms
            .iter()
            .map(|(k, cosine, sine)| (*k, HarmonicPair { cosine: cosine[i].clone(), sine: sine[i].clone() }));
        ring.sum_of_harmonics(&harmonics.collect::<Vec<_>>())
    };
    // (c·cos kτ + s·sin kτ)′ = kω·(s·cos kτ − c·sin kτ).
    let velocity = |i: usize| {
        let harmonics = terms.iter().map(|(k, cosine, sine)| {
            (*k, HarmonicPair { cosine: rate(*k, &sine[i]), sine: numbers.negate(&rate(*k, &cosine[i])) })
        });
        ring.sum_of_harmonics(&harmonics.collect::<Vec<_>>())
    };
    (0..coordinates).map(position).chain((0..coordinates).map(velocity)).collect()
}

struct LindstedtExpansion<'a, N: Ring> {
    ring: &'a HarmonicSums<N>,
    jet: Jet<'a, HarmonicSums<N>>,
    judge: &'a ZeroRules<'a, N::Element>,
    mode: &'a Fundamental<N::Element>,
    linear: LinearEquations<N::Element>,
}

impl<N: Ring> LindstedtExpansion<'_, N> {
    fn coordinates(&self) -> usize {
        self.mode.cosine.len()
    }

    /// Appends the next order of the coordinates.
    fn extend(&mut self, terms: &[Term<N::Element>]) -> Result<(), ModeObstacle> {
        let inputs = state(self.ring, &self.mode.frequency, terms, self.coordinates());
        Ok(self.jet.extend(&inputs)?)
    }

    /// R of the next order by harmonics, cosines first.
    fn rest(&mut self, harmonics: &[usize]) -> Result<Vec<Vec<N::Element>>, ModeObstacle> {
        self.extend(&[])?;
        let last = |i: usize| self.jet.result(i).last().cloned().ok_or(ModeObstacle::NoSeries);
        let sums = (0..self.coordinates()).map(last).collect::<Result<Vec<_>, _>>()?;
        self.jet.shorten();
        let ring = self.ring;
        let parts = |k: usize| {
            let harmonics = sums.iter().map(move |sum| ring.harmonic(sum, k));
            harmonics.clone().map(|pair| pair.cosine).chain(harmonics.map(|pair| pair.sine)).collect()
        };
        Ok(harmonics.iter().map(|&k| parts(k)).collect())
    }

    /// The harmonics, other than the first, that the lower orders force.
    fn forced(&mut self, harmonics: &[usize]) -> Result<Vec<Term<N::Element>>, ModeObstacle> {
        let forcing = self.rest(harmonics)?;
        let largest = forcing.iter().flatten().map(self.judge.size).fold(0.0, f64::max);
        let n = self.coordinates();
        let term = |(&k, right): (&usize, &Vec<N::Element>)| {
            let mut parts = self.response(k, right, largest)?;
            let sines = parts.split_off(n);
            Ok((k, parts, sines))
        };
        harmonics.iter().zip(&forcing).map(term).collect()
    }

    fn response(
        &self,
        k: usize,
        right: &[N::Element],
        largest: f64,
    ) -> Result<Vec<N::Element>, ModeObstacle> {
        let numbers = self.ring.numbers();
        let small =
            |x: &N::Element| numbers.is_zero(x) || (self.judge.size)(x) < self.judge.rounding * largest;
        if right.iter().all(small) {
            return Ok(vec![numbers.zero(); right.len()]);
        }
        let singular = ModeObstacle::Resonance(k);
        let matrix = self.matrix(k);
        if k > 0 && self.judge.resonant.contains(&k) {
            return self.not_driving(&matrix, right, largest).ok_or(singular);
        }
        if self.judge.resonant.contains(&k) {
            return Err(singular);
        }
        let n = self.coordinates();
        if k > 0 {
            return solve(numbers, self.judge.size, &matrix, right).ok_or(singular);
        }
        let mean: Vec<Vec<N::Element>> = matrix[..n].iter().map(|row| row[..n].to_vec()).collect();
        let mean = solve(numbers, self.judge.size, &mean, &right[..n]).ok_or(singular)?;
        Ok(mean.into_iter().chain((0..n).map(|_| numbers.zero())).collect())
    }

    /// A solution of singular equations whose right side does not drive the free oscillation: it is orthogonal to what the transposed matrix maps to
    /// zero. `None` where it drives it, or several modes have the frequency.
    fn not_driving(
        &self,
        matrix: &[Vec<N::Element>],
        right: &[N::Element],
        largest: f64,
    ) -> Option<Vec<N::Element>> {
        let numbers = self.ring.numbers();
        let indices = 0..matrix.len();
        let transposed: Vec<Vec<N::Element>> =
            indices.clone().map(|i| matrix.iter().map(|row| row[i].clone()).collect()).collect();
        let [left, free] = [self.null_vectors(&transposed)?, self.null_vectors(matrix)?];
        // The bordered equations: the multiples of the left vectors that are left over vanish where the right side is orthogonal to them.
        let bordered = indices.clone().map(|i| {
            let of_left = left.iter().map(|vector| vector[i].clone());
            matrix[i].iter().cloned().chain(of_left).collect::<Vec<_>>()
        });
        let zeros = || (0..NULL_VECTORS).map(|_| numbers.zero());
        let conditions = free.into_iter().map(|vector| vector.into_iter().chain(zeros()).collect::<Vec<_>>());
        let rows: Vec<Vec<N::Element>> = bordered.chain(conditions).collect();
        let right: Vec<N::Element> = right.iter().cloned().chain(zeros()).collect();
        let mut solution = solve(numbers, self.judge.size, &rows, &right)?;
        let left_over = solution.split_off(matrix.len());
        let vanishes =
            |x: &N::Element| numbers.is_zero(x) || (self.judge.size)(x) < self.judge.rounding * largest;
        left_over.iter().all(vanishes).then_some(solution)
    }

    fn null_vectors(&self, matrix: &[Vec<N::Element>]) -> Option<Vec<Vec<N::Element>>> {
        null_space(self.ring.numbers(), self.judge.size, matrix, NULL_VECTORS)
    }

    /// The matrix of harmonic k on cosines and sines.
    fn matrix(&self, k: usize) -> Vec<Vec<N::Element>> {
        let (numbers, n) = (self.ring.numbers(), self.coordinates());
        let k = i64::try_from(k).unwrap_or(i64::MAX);
        let omega = numbers.times_integer(&self.mode.frequency, k);
        let square = numbers.multiply(&omega, &omega);
        let entry = |i: usize, j: usize| {
            if i / n != j / n {
                let coupling = numbers.multiply(&omega, &self.linear.velocity[i % n][j % n]);
                return if i < n { numbers.negate(&coupling) } else { coupling };
            }
            let stiffness = &self.linear.stiffness[i % n][j % n];
            if i == j { numbers.subtract(stiffness, &square) } else { stiffness.clone() }
        };
        (0..2 * n).map(|i| (0..2 * n).map(|j| entry(i, j)).collect()).collect()
    }

    /// w and g from the first harmonic of the third order.
    fn solvability(mut self) -> Result<Third<N::Element>, ModeObstacle> {
        let forcing = self.rest(&[1, 3])?;
        let largest = forcing.iter().flatten().map(self.judge.size).fold(0.0, f64::max);
        self.response(3, &forcing[1], largest)?;
        let (numbers, n) = (self.ring.numbers(), self.coordinates());
        let columns = [
            self.detuning(&self.mode.cosine, &self.mode.sine),
            self.detuning(
                &self.mode.sine,
                &self.mode.cosine.iter().map(|x| numbers.negate(x)).collect::<Vec<_>>(),
            ),
        ];
        let mut matrix = self.matrix(1);
        for (i, row) in matrix.iter_mut().enumerate() {
            row.extend(columns.iter().map(|column| numbers.negate(&column[i])));
        }
        let one = numbers.rational(&1.into()).ok_or(ModeObstacle::NoSeries)?;
        for fixed in [self.mode.leading, self.mode.leading + n] {
            matrix.push(
                (0..2 * n + 2).map(|j| if j == fixed { one.clone() } else { numbers.zero() }).collect(),
            );
        }
        let right: Vec<N::Element> =
            forcing[0].iter().cloned().chain([numbers.zero(), numbers.zero()]).collect();
        let mut solution =
            solve(numbers, self.judge.size, &matrix, &right).ok_or(ModeObstacle::Resonance(1))?;
        let growth = numbers.negate(&solution.pop().ok_or(ModeObstacle::NoSeries)?);
        let frequency = solution.pop().ok_or(ModeObstacle::NoSeries)?;
        Ok(Third { frequency, growth })
    }

    /// Terms that a change of the frequency, by itself, adds to the accelerations of c·cos τ + s·sin τ: (2ω² + iωG)·φ.
    fn detuning(&self, cosine: &[N::Element], sine: &[N::Element]) -> Vec<N::Element> {
        let (numbers, omega) = (self.ring.numbers(), &self.mode.frequency);
        let twice = numbers.times_integer(&numbers.multiply(omega, omega), 2);
        let coupled = |i: usize, vector: &[N::Element]| {
            let terms = self.linear.velocity[i].iter().zip(vector);
            let sum = terms.fold(numbers.zero(), |sum, (g, x)| numbers.add(&sum, &numbers.multiply(g, x)));
            numbers.multiply(omega, &sum)
        };
        let stretched = |x: &N::Element| numbers.multiply(&twice, x);
        let upper = cosine.iter().enumerate().map(|(i, c)| numbers.add(&stretched(c), &coupled(i, sine)));
        let lower =
            sine.iter().enumerate().map(|(i, s)| numbers.subtract(&stretched(s), &coupled(i, cosine)));
        upper.chain(lower).collect()
    }
}
