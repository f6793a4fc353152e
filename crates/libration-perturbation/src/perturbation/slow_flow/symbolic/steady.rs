//! Steady states: the elimination of the phase, and its results.
//!
//! The lowest order of the two equations in which cos mφ and sin mφ occur is solved for them, and the higher orders are put in. The sum of
//! their squares is one: that is the relation between amplitude and detuning.

use super::elimination::resultant;
use super::letters::{Column, Letters, Sum};
use super::phase_sums::PhaseSum;
use super::turned::{Coupling, turned_jacobian};
use libration_numbers::algebra::Rational;

/// A′ and A·φ′ as sums in A and the phase, to an order.
pub(super) struct SteadyEquations<'a> {
    pub(super) letters: &'a Letters,
    /// A′ and A·φ′.
    pub(super) rates: [PhaseSum; 2],
    pub(super) order: i64,
    /// The lowest order of the slow flow.
    pub(super) lowest: i64,
    pub(super) is_driven: bool,
}

/// The criteria of steady states without the phase.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Steady {
    /// Zero for steady amplitudes.
    pub(super) relation: Option<Sum>,
    /// cos mφ and sin mφ, with m.
    pub(super) phase: Option<(i64, [Sum; 2])>,
    /// The common divisor of both, if it is a sum.
    pub(super) denominator: Option<Sum>,
    /// Trace and determinant of the Jacobian of A′ and φ′; without phase that of A′ only.
    pub(super) trace: Option<Sum>,
    pub(super) determinant: Option<Sum>,
    pub(super) order: i64,
    /// The lowest order of the slow flow.
    pub(super) lowest: i64,
    /// The lowest order in which the phase occurs.
    pub(super) coupling: i64,
    /// The lowest order at which the relation contains drive and damping.
    pub(super) complete: i64,
    /// The reason why the relation or the phase is not known.
    pub(super) obstacle: Option<Obstacle>,
}

/// The reason why the phase is not eliminated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Obstacle {
    /// The phase does not occur.
    Absent,
    /// The relation needs this order.
    Order(i64),
    /// Several harmonics of the phase occur at the lowest order in which it does.
    Harmonics,
    /// The determinant of the coefficients of cos mφ and sin mφ is a sum.
    Sums,
    /// The lowest order in which the phase occurs does not determine both cos mφ and sin mφ.
    Undetermined,
}

impl SteadyEquations<'_> {
    pub(super) fn solve(&self) -> Steady {
        let ks = self.rates.iter().flat_map(|rate| rate.harmonics.keys().copied());
        let m = ks.fold(0, greatest_common_divisor);
        let steady = match m {
            0 if self.is_driven => Steady { obstacle: Some(Obstacle::Absent), ..Steady::default() },
            0 => self.without_phase(),
            _ => self.with_phase(m).unwrap_or_default(),
        };
        Steady { order: self.order, lowest: self.lowest, ..steady }
    }

    /// A′ = 0 alone.
    fn without_phase(&self) -> Steady {
        let letters = self.letters;
        let rate = self.rates[0].in_cosine_and_sine(letters, 1);
        let trace = letters.derivative(&rate, Column::Amplitude);
        Steady {
            relation: (!rate.is_zero()).then(|| self.normalised(&rate, self.order - self.lowest)),
            trace: Some(trace),
            ..Steady::default()
        }
    }

    fn with_phase(&self, m: i64) -> Option<Steady> {
        let letters = self.letters;
        let rates = self.rates.each_ref().map(|rate| rate.in_cosine_and_sine(letters, m));
        let coupling = self.coupling(&rates)?;
        let matrix = self.matrix(&rates, coupling);
        let Some(phase) = self.phase(&rates, &matrix, coupling) else {
            return Some(self.without_inverse(m, &rates, &matrix, coupling));
        };
        let [trace, determinant] = self.jacobian(m, &rates, &phase);
        // The sum of squares begins at twice the difference of the two orders, which is not above zero, and has to reach the one.
        let shift = self.lowest - coupling;
        let needed = coupling - shift;
        let complete = coupling.max(self.growth(&rates).unwrap_or(0)) * 2 - self.lowest;
        if self.order < needed {
            let (phase, obstacle) = (Some((m, phase)), Some(Obstacle::Order(needed)));
            return Some(Steady {
                phase,
                trace: Some(trace),
                coupling,
                complete,
                obstacle,
                ..Steady::default()
            });
        }
        let square = |a: &Sum| letters.times(a, a);
        let one = letters.number(Rational::from(1));
        let relation = letters.subtract(&letters.add(&square(&phase[0]), &square(&phase[1])), &one);
        let relation = letters.to_order(&relation, 2 * shift + self.order - self.lowest);
        let relation = self.normalised(&relation, self.order - self.lowest);
        Some(Steady {
            relation: Some(relation),
            phase: Some((m, phase)),
            trace: Some(trace),
            determinant: Some(determinant),
            coupling,
            complete,
            ..Steady::default()
        })
    }

    /// The formulas that remain where the lowest order is not solved for cos mφ and sin mφ.
    fn without_inverse(&self, m: i64, rates: &[Sum; 2], matrix: &Coupling, coupling: i64) -> Steady {
        let letters = self.letters;
        let columns = [Column::Cosine, Column::Sine].map(|column| letters.index(column));
        let is_linear = |powers: &[i64]| columns.iter().map(|&column| powers[column]).sum::<i64>() <= 2;
        let leading = rates.each_ref().map(|rate| letters.of_order(rate, coupling));
        let obstacle = match () {
            () if !leading.iter().all(|rate| rate.half_powers().all(|(powers, _)| is_linear(powers))) => {
                Obstacle::Harmonics
            }
            () if self.determinant(matrix).is_zero() => Obstacle::Undetermined,
            () => Obstacle::Sums,
        };
        let is_turned = obstacle == Obstacle::Sums && self.order == self.lowest;
        let jacobian = is_turned.then(|| turned_jacobian(letters, m, rates, matrix)).flatten();
        let [trace, determinant] = jacobian.map_or([None, None], |parts| parts.map(Some));
        let relation = self.by_resultant();
        let quotients = trace.is_some().then(|| self.quotients(rates, matrix));
        let (phase, denominator) =
            quotients.map(|[cosine, sine, below]| ((m, [cosine, sine]), below)).unzip();
        let obstacle = Some(obstacle);
        Steady { relation, phase, denominator, trace, determinant, coupling, obstacle, ..Steady::default() }
    }

    /// Numerators of cos mφ and sin mφ with their denominator, without order, where the lowest order is the only one.
    fn quotients(&self, rates: &[Sum; 2], matrix: &Coupling) -> [Sum; 3] {
        let letters = self.letters;
        let columns = [Column::Cosine, Column::Sine].map(|column| letters.index(column));
        let [p, q] = rates
            .each_ref()
            .map(|rate| letters.part(rate, |powers| columns.iter().all(|&column| powers[column] == 0)));
        let [[a, b], [c, d]] = matrix;
        let minor =
            |x: &Sum, u: &Sum, y: &Sum, v: &Sum| letters.subtract(&letters.times(x, u), &letters.times(y, v));
        let all = [minor(b, &q, d, &p), minor(c, &p, a, &q), self.determinant(matrix)];
        let least = |column: usize| {
            let powers = all.iter().flat_map(Sum::half_powers).map(|(powers, _)| powers[column]);
            powers.min().unwrap_or(0)
        };
        let least: Vec<i64> = (0..letters.ring.letters().len()).map(least).collect();
        all.each_ref().map(|sum| {
            letters.changed(sum, |powers, factor| {
                powers.iter_mut().zip(&least).for_each(|(power, least)| *power -= least);
                powers[letters.index(Column::Order)] = 0;
                factor.clone()
            })
        })
    }

    /// The relation where several harmonics of the phase occur at the lowest order, which is the only one.
    fn by_resultant(&self) -> Option<Sum> {
        let letters = self.letters;
        if self.order > self.lowest {
            return None;
        }
        let relation = resultant(letters, &PhaseSum::joined(letters, &self.rates))?;
        (!relation.is_zero()).then(|| without_common_powers(letters, &relation))
    }

    /// The lowest order in which the amplitude changes without the phase.
    fn growth(&self, rates: &[Sum; 2]) -> Option<i64> {
        let letters = self.letters;
        let columns = [Column::Cosine, Column::Sine].map(|column| letters.index(column));
        let still = letters.part(&rates[0], |powers| columns.iter().all(|&column| powers[column] == 0));
        letters.lowest_order(&still)
    }

    /// The lowest order in which the phase occurs.
    fn coupling(&self, rates: &[Sum; 2]) -> Option<i64> {
        let letters = self.letters;
        let columns = [Column::Cosine, Column::Sine].map(|column| letters.index(column));
        let coupled = |rate| letters.part(rate, |powers| columns.iter().any(|&column| powers[column] != 0));
        rates.iter().filter_map(|rate| letters.lowest_order(&coupled(rate))).min()
    }

    /// The coefficients of cos mφ and sin mφ at the lowest order in which they occur.
    fn matrix(&self, rates: &[Sum; 2], coupling: i64) -> Coupling {
        let letters = self.letters;
        let columns = [Column::Cosine, Column::Sine].map(|column| letters.index(column));
        let leading = |rate: &Sum, powers: [i64; 2]| {
            let such = letters.part(&letters.of_order(rate, coupling), |exponents| {
                columns.iter().zip(powers).all(|(&column, power)| exponents[column] == 2 * power)
            });
            let [cosine, sine] = [Column::Cosine, Column::Sine];
            let such = letters.coefficient(&such, cosine, powers[0]);
            letters.coefficient(&such, sine, powers[1])
        };
        rates.each_ref().map(|rate| [leading(rate, [1, 0]), leading(rate, [0, 1])])
    }

    fn determinant(&self, [[a, b], [c, d]]: &Coupling) -> Sum {
        let letters = self.letters;
        letters.subtract(&letters.times(a, d), &letters.times(b, c))
    }

    /// cos mφ and sin mφ of steady states; `None` if the lowest order does not determine them.
    fn phase(&self, rates: &[Sum; 2], matrix: &Coupling, coupling: i64) -> Option<[Sum; 2]> {
        let letters = self.letters;
        let [[a, b], [c, d]] = matrix;
        let rest = [0, 1].map(|row: usize| {
            let [by_cosine, by_sine] = &matrix[row];
            let cosine = letters.times(by_cosine, &letters.power(Column::Cosine, 1));
            let sine = letters.times(by_sine, &letters.power(Column::Sine, 1));
            letters.subtract(&rates[row], &letters.add(&cosine, &sine))
        });
        let inverse = letters.inverse(&letters.scaled(&self.determinant(matrix), &Rational::from(-1)))?;
        let highest = self.order - coupling;
        let minor =
            |x: &Sum, u: &Sum, y: &Sum, v: &Sum| letters.subtract(&letters.times(x, u), &letters.times(y, v));
        let mut phase = [letters.zero(), letters.zero()];
        for _ in 0..=self.order - self.lowest + 1 {
            let residuals = rest.each_ref().map(|rest| self.at_phase(rest, &phase, self.order));
            let next = [minor(d, &residuals[0], b, &residuals[1]), minor(a, &residuals[1], c, &residuals[0])];
            let next = next.map(|component| letters.to_order(&letters.times(&component, &inverse), highest));
            if next == phase {
                return Some(phase);
            }
            phase = next;
        }
        None
    }

    /// A sum at the phase of steady states.
    fn at_phase(&self, sum: &Sum, [cosine, sine]: &[Sum; 2], order: i64) -> Sum {
        let letters = self.letters;
        // The orders of the phase may be negative: what they lower is kept.
        let spare = self.order;
        let sum = letters.substituted(sum, Column::Cosine, cosine, order + spare);
        letters.to_order(&letters.substituted(&sum, Column::Sine, sine, order + spare), order)
    }

    /// Trace and determinant of the Jacobian of A′ and φ′ at steady states.
    fn jacobian(&self, m: i64, rates: &[Sum; 2], phase: &[Sum; 2]) -> [Sum; 2] {
        let letters = self.letters;
        let by_amplitude = |rate: &Sum| letters.derivative(rate, Column::Amplitude);
        let by_phase = |rate: &Sum| {
            let down =
                letters.times(&letters.derivative(rate, Column::Cosine), &letters.power(Column::Sine, 1));
            let up =
                letters.times(&letters.derivative(rate, Column::Sine), &letters.power(Column::Cosine, 1));
            letters.scaled(&letters.subtract(&up, &down), &Rational::from(m))
        };
        let at = |sum: &Sum| self.at_phase(sum, phase, self.order);
        let per_amplitude = letters.power(Column::Amplitude, -1);
        let upper = [at(&by_amplitude(&rates[0])), at(&by_phase(&rates[0]))];
        let lower = [by_amplitude(&rates[1]), by_phase(&rates[1])];
        let lower = lower.map(|lower| letters.times(&at(&lower), &per_amplitude));
        let trace = letters.add(&upper[0], &lower[1]);
        let determinant =
            letters.subtract(&letters.times(&upper[0], &lower[1]), &letters.times(&upper[1], &lower[0]));
        [trace, letters.to_order(&determinant, self.order + self.lowest)]
    }

    /// A sum without common powers of symbols, to an order relative to its lowest.
    fn normalised(&self, sum: &Sum, order: i64) -> Sum {
        let reduced = without_common_powers(self.letters, sum);
        self.letters.to_order(&reduced, order)
    }
}

/// The sum divided by the powers that all its terms have; only π keeps those that are negative.
pub(super) fn without_common_powers(letters: &Letters, sum: &Sum) -> Sum {
    let pi = letters.index(Column::Pi);
    let mut least: Option<Vec<i64>> = None;
    for (powers, _) in sum.half_powers() {
        let least = least.get_or_insert_with(|| powers.to_vec());
        for (least, power) in least.iter_mut().zip(powers.iter()) {
            *least = (*least).min(*power);
        }
    }
    let Some(mut least) = least else { return sum.clone() };
    least[pi] = least[pi].max(0);
    letters.changed(sum, |powers, factor| {
        for (power, least) in powers.iter_mut().zip(&least) {
            *power -= least;
        }
        factor.clone()
    })
}

pub(super) fn greatest_common_divisor(a: i64, b: i64) -> i64 {
    if b == 0 { a.abs() } else { greatest_common_divisor(b, a % b) }
}
