//! Energy balance: the free oscillations that a weak drive maintains against the damping, and their phases.

use super::order::ResonanceOrder;
use super::undriven::undriven;
use libration_motion::orbit::Orbit;
use libration_numbers::algebra::Doubles;
use libration_numbers::progress::Quiet;
use libration_numbers::roots::{Tolerance, zero_between};
use libration_numbers::{
    expression::{Equation, Expression, Order, Symbol},
    internals::expression::{Jet, Tape},
};
use std::f64::consts::{PI, TAU};

/// An oscillator, and its free equation without the drive and the velocity.
pub(super) struct EnergyBalance {
    pub(super) equation: Equation,
    pub(super) free: Equation,
    /// Acceleration of the full equation minus that of the free one.
    rest: Tape,
    is_odd: bool,
    is_periodic: bool,
    /// The size of motions under the drive.
    scale: f64,
}

/// Release points with the frequencies of their free oscillations, in ascending order, for each side of the bottom.
pub(super) type Frequencies = Vec<Vec<(f64, f64)>>;

/// Work of drive and damping on a free oscillation over a whole number of periods of both.
pub(super) enum Work {
    /// Work that does not depend on the phase.
    WithoutPhase,
    /// The drive supplies less energy than the damping removes at every phase: at most this fraction.
    TooWeak(f64),
    /// The drive supplies what the damping removes at these states, which belong to phase zero of the drive.
    Balanced(Vec<Vec<f64>>),
}

impl EnergyBalance {
    /// Returns the balance of an equation of second order with one coordinate and without open parameters, for motions of a scale; `None` for
    /// other equations.
    pub(super) fn new(equation: Equation, scale: f64) -> Option<Self> {
        let free = undriven(&equation)?;
        let coordinate = Symbol::plain(&equation.variables()[0]);
        let inputs = [coordinate.clone(), coordinate.with_primes(1), Symbol::plain("t")];
        let difference = Expression::Subtract(
            Box::new(equation.derivatives()[0].clone()),
            Box::new(free.derivatives()[0].clone()),
        );
        let rest = Tape::new(&[&difference], &inputs).ok()?;
        let force = Tape::new(&[&free.derivatives()[0]], &inputs).ok()?;
        let at = |displacement: f64| value(&force, [displacement, 0.0, 0.0]);
        // Rounding errors of formulas of some hundred operations.
        let same = |a: f64, b: f64| (a - b).abs() <= 1e-12 * (a.abs() + b.abs()).max(1e-300);
        let is_odd_at = |displacement: f64| same(at(displacement), -at(-displacement));
        let displacements = [0.31, 0.83, 1.7, 2.9];
        Some(Self {
            is_odd: [1.0, scale]
                .iter()
                .all(|scale| displacements.iter().all(|displacement| is_odd_at(scale * displacement))),
            is_periodic: displacements
                .iter()
                .all(|displacement| same(at(*displacement), at(displacement + TAU))),
            scale,
            equation,
            free,
            rest,
        })
    }

    /// The frequencies of free oscillations of all sizes; on one side only if left and right are symmetric.
    pub(super) fn frequencies(&self) -> Frequencies {
        let amplitudes = self.places();
        let of = |sign: f64| {
            amplitudes
                .iter()
                .map(|displacement| (sign * displacement, self.frequency(sign * displacement)))
                .collect()
        };
        if self.is_odd { vec![of(1.0)] } else { vec![of(1.0), of(-1.0)] }
    }

    fn frequency(&self, displacement: f64) -> f64 {
        Orbit::released(&self.free, displacement, &Quiet).map_or(f64::NAN, |orbit| orbit.frequency())
    }

    /// The free oscillations with a given frequency, each released from rest.
    pub(super) fn oscillations(&self, frequencies: &Frequencies, frequency: f64) -> Vec<Orbit> {
        /// Relative tolerance of the release point, sufficient for an initial guess.
        const CLOSE: f64 = 1e-4;
        let pairs = frequencies.iter().flat_map(|side| side.windows(2));
        let amplitudes = pairs.filter_map(|pair| {
            let ends = [pair[0], pair[1]]
                .map(|(amplitude, natural_frequency)| (amplitude, natural_frequency - frequency));
            zero_between(ends, Tolerance::relative(CLOSE), |amplitude| self.frequency(amplitude) - frequency)
        });
        amplitudes.filter_map(|amplitude| Orbit::released(&self.free, amplitude, &Quiet).ok()).collect()
    }

    /// Release points from three decades below the scale, or 1, to three decades above, or from the bottom to a hundredth of a radian below the top.
    fn places(&self) -> Vec<f64> {
        /// Five in a decade.
        const RATIO: f64 = 1.584_893_192_461_113_6;
        let between = |low: f64, high: f64| {
            std::iter::successors(Some(low), |amplitude| Some(amplitude * RATIO))
                .take_while(move |amplitude| *amplitude < high)
        };
        if !self.is_periodic {
            return between(1e-3 * self.scale.min(1.0), 1.1e3 * self.scale.max(1.0)).collect();
        }
        let mut above: Vec<f64> = between(1e-2, 0.5 * PI).map(|amplitude| PI - amplitude).collect();
        above.reverse();
        between(1e-3, 0.5 * PI).chain(above).collect()
    }

    /// The work of drive and damping on a free oscillation in resonance of the given order, as a function of its phase.
    pub(super) fn work(&self, orbit: &Orbit, order: ResonanceOrder, drive_period: f64) -> Work {
        const PHASES: u32 = 48;
        /// Smallest variation with the phase, relative to the sum of the magnitudes; it exceeds the error of the sums.
        const NONE: f64 = 1e-7;
        let phase = |j: u32| drive_period * f64::from(j) / f64::from(PHASES);
        let values: Vec<[f64; 2]> =
            (0..=PHASES).map(|j| self.work_at(orbit, order, drive_period, phase(j))).collect();
        let works = || values.iter().map(|[work, _]| *work);
        let (low, high) = works().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        let size = values.iter().map(|[_, size]| *size).fold(0.0, f64::max);
        if high - low <= NONE * size {
            return Work::WithoutPhase;
        }
        if low > 0.0 || high < 0.0 {
            return Work::TooWeak((high - low) / (high + low).abs());
        }
        let at = |shift: f64| self.work_at(orbit, order, drive_period, shift)[0];
        let stretches = (0..PHASES).zip(values.windows(2));
        let zeros = stretches.filter_map(|(j, pair)| {
            let ends = [(phase(j), pair[0][0]), (phase(j + 1), pair[1][0])];
            // The start of Newton's method, which needs a few digits.
            zero_between(ends, Tolerance::relative(1e-9), at)
        });
        Work::Balanced(zeros.map(|shift| orbit.state_at(shift)).collect())
    }

    /// The work on the oscillation that is `ahead` seconds ahead at phase zero of the drive, and the sum of the magnitudes of its terms.
    fn work_at(&self, orbit: &Orbit, order: ResonanceOrder, drive_period: f64, ahead: f64) -> [f64; 2] {
        const STEPS: u32 = 48;
        let steps = STEPS * (order.oscillations() + order.drive_periods());
        let whole = drive_period * f64::from(order.drive_periods());
        // The frequency of the oscillation is only nearly the resonant one.
        let whole_of_orbit = orbit.period() * f64::from(order.oscillations());
        (0..steps).fold([0.0, 0.0], |[work, size], j| {
            let part = f64::from(j) / f64::from(steps);
            let state = orbit.state_at(part * whole_of_orbit + ahead);
            let power = state[1] * value(&self.rest, [state[0], state[1], part * whole]);
            [work + power, size + power.abs()]
        })
    }

    /// The free oscillator with a multiple of drive and damping, and the name of this multiple, a new parameter.
    pub(super) fn with_part_of_rest(&self) -> (Equation, String) {
        let full = &self.equation.derivatives()[0];
        let taken: Vec<String> = full.symbols().into_iter().map(|symbol| symbol.name).collect();
        let mut name = "strength".to_owned();
        while taken.contains(&name) {
            name.push('_');
        }
        let free = &self.free.derivatives()[0];
        let rest = Expression::Subtract(Box::new(full.clone()), Box::new(free.clone()));
        let part = Expression::Multiply(Box::new(Expression::Symbol(Symbol::plain(&name))), Box::new(rest));
        let sum = Expression::Add(Box::new(free.clone()), Box::new(part));
        let variables = self.equation.variables().to_vec();
        (Equation::of_derivatives(variables, vec![Order::Second], vec![sum]), name)
    }
}

fn value(tape: &Tape, inputs: [f64; 3]) -> f64 {
    Jet::new(&Doubles, tape, &inputs).map_or(f64::NAN, |jet| jet.result(0)[0])
}
