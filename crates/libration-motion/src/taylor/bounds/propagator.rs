//! Propagation of small deviations of a motion inside a step, by Magnus's series.
//!
//! Reference: S. Blanes, F. Casas, J. A. Oteo, J. Ros, Phys. Rep. 470, 151 (2009), doi:10.1016/j.physrep.2008.11.001, equation (253).

use super::exponential::Exponential;
use super::matrix::Matrix;
use crate::taylor::drivers::stepper::Stepper;
use crate::taylor::program::linearised::Linearised;
use crate::taylor::step::larger::larger_or_nan;
use crate::taylor::{Step, System};

/// The linearised equations of motion along the steps of one motion.
#[derive(Debug)]
pub(in crate::taylor) struct Propagator {
    forces: Linearised,
    inputs: Vec<f64>,
    /// Rounding errors of the accelerations and rates of change at the last evaluation.
    pub(in crate::taylor) lost: Vec<f64>,
    rates: [Matrix; 3],
    /// Coefficients of the quadratic polynomial of the rates of change, multiplied by the time, and their commutators.
    slope: Matrix,
    bend: Matrix,
    commutators: [Matrix; 2],
    product: Matrix,
    exponent: Matrix,
    exponential: Exponential,
}

impl Propagator {
    pub(in crate::taylor) fn new(system: &System) -> Self {
        let (coordinates, numbers) = (system.coordinates(), system.layout().numbers());
        let empty = || Matrix::zero(numbers);
        Self {
            forces: Linearised::new(system.tape(), 0..coordinates, numbers),
            inputs: vec![],
            lost: vec![0.0; coordinates],
            rates: [empty(), empty(), empty()],
            slope: empty(),
            bend: empty(),
            commutators: [empty(), empty()],
            product: empty(),
            exponent: empty(),
            exponential: Exponential::new(numbers),
        }
    }

    /// The derivatives of the state at one time of a step by that at another, to the sixth order
    /// in the time between; the rounding errors of the forces at the evaluation are stored.
    pub(in crate::taylor) fn between(
        &mut self,
        stepper: &Stepper<'_, 1>,
        step: &Step<'_>,
        times: [f64; 2],
        flow: &mut Matrix,
    ) {
        self.lost.fill(0.0);
        self.go(stepper, step, times, flow, 0);
    }

    /// Propagates over an interval, which is halved if forces change much in it.
    fn go(
        &mut self,
        stepper: &Stepper<'_, 1>,
        step: &Step<'_>,
        times: [f64; 2],
        flow: &mut Matrix,
        halvings: usize,
    ) {
        const MOST_HALVINGS: usize = 5;
        /// Largest norm of the rates of change, multiplied by the time: Magnus's series converges below π.
        const LARGEST: f64 = 2.0;
        let length = times[1] - times[0];
        let middle = times[0] + 0.5 * length;
        let apart = 0.1 * SQRT_15 * length;
        self.linearise(stepper, step, [middle - apart, middle, middle + apart]);
        let Self { rates: [first, second, third], exponent, .. } = self;
        exponent.set_product(third, first);
        let size = exponent.largest_row_sum().sqrt() * length.abs();
        if size > LARGEST
            && halvings < MOST_HALVINGS
            && (changes_much(first, second) || changes_much(second, third))
        {
            let mut half = Matrix::zero(flow.size);
            self.go(stepper, step, [times[0], middle], &mut half, halvings + 1);
            let mut other = Matrix::zero(flow.size);
            self.go(stepper, step, [middle, times[1]], &mut other, halvings + 1);
            flow.set_product(&other, &half);
            return;
        }
        for (n, (a, (b, c))) in
            first.entries.iter().zip(second.entries.iter().zip(&third.entries)).enumerate()
        {
            self.slope.entries[n] = SQRT_15 / 3.0 * length * (c - a);
            self.bend.entries[n] = 10.0 / 3.0 * length * (c - 2.0 * b + a);
        }
        second.entries.iter_mut().for_each(|entry| *entry *= length);
        self.set_exponent();
        self.exponential.of(&mut self.exponent, flow);
    }

    /// Ω = α₁ + α₃/12 + [−20α₁ − α₃ + C₁, α₂ + C₂]/240 with C₁ = [α₁, α₂] and C₂ = −[α₁, 2α₃ + C₁]/60.
    fn set_exponent(&mut self) {
        let Self {
            rates: [left, mean, right], slope, bend, commutators: [one, two], product, exponent, ..
        } = self;
        commutator(mean, slope, one, product);
        right.entries.clone_from(&one.entries);
        right.add(2.0, bend);
        commutator(mean, right, two, product);
        let sums = left.entries.iter_mut().zip(&mut right.entries);
        for (n, (left, right)) in sums.enumerate() {
            *left = one.entries[n] - 20.0 * mean.entries[n] - bend.entries[n];
            *right = slope.entries[n] - two.entries[n] / 60.0;
        }
        commutator(left, right, exponent, product);
        for (n, exponent) in exponent.entries.iter_mut().enumerate() {
            *exponent = *exponent / 240.0 + mean.entries[n] + bend.entries[n] / 12.0;
        }
    }

    /// The derivatives of the rates of change of the state by the state, at three times.
    fn linearise(&mut self, stepper: &Stepper<'_, 1>, step: &Step<'_>, times: [f64; 3]) {
        let Self { forces, inputs, lost, rates, .. } = self;
        for (time, rates) in times.into_iter().zip(rates) {
            set_inputs(stepper, step, time, inputs);
            forces.evaluate(inputs);
            for (coordinate, lost) in lost.iter_mut().enumerate() {
                let driven = step.layout.driven(coordinate);
                rates.row_mut(driven).copy_from_slice(forces.slopes(coordinate));
                if driven != coordinate {
                    rates.row_mut(coordinate).fill(0.0);
                    rates.row_mut(coordinate)[driven] = 1.0;
                }
                *lost = larger_or_nan(*lost, forces.error(coordinate));
            }
            // Friction keeps the argument of a |…| at zero: its sign is then between −1 and 1.
            for (modulus, _) in stepper.signs(0).iter().enumerate().filter(|(_, sign)| sign.abs() < 1.0) {
                if let Some(number) = stepper.expander.system.driven_in_modulus(modulus) {
                    rates.row_mut(number).fill(0.0);
                }
            }
        }
    }
}

/// √15: Gauss's three points are at 1/2 and 1/2 ± √15/10 of a step.
const SQRT_15: f64 = 3.872983346207417;

/// Returns `true` if the sum of the changes of all entries exceeds a fraction of the sum of their sizes.
fn changes_much(before: &Matrix, after: &Matrix) -> bool {
    const PART: f64 = 0.25;
    let pairs = || before.entries.iter().zip(&after.entries);
    let change: f64 = pairs().map(|(a, b)| (b - a).abs()).sum();
    change > PART * pairs().map(|(a, b)| a.abs().max(b.abs())).sum::<f64>()
}

/// a·b − b·a.
fn commutator(a: &Matrix, b: &Matrix, commutator: &mut Matrix, product: &mut Matrix) {
    commutator.set_product(a, b);
    product.set_product(b, a);
    commutator.add(-1.0, product);
}

/// Sets the inputs of a system's tape at a time of a step.
fn set_inputs(stepper: &Stepper<'_, 1>, step: &Step<'_>, time: f64, inputs: &mut Vec<f64>) {
    let h = (time - step.start) / step.unit;
    let value = |number: usize| {
        let terms = (0..step.terms).rev();
        terms.fold(0.0, |sum, n| sum * h + step.coefficient(number, n))
    };
    inputs.clear();
    inputs.extend((0..step.numbers()).map(value));
    inputs.push(time);
    inputs.extend(stepper.surroundings.parameters.iter().map(|value| value[0]));
    inputs.extend(stepper.signs(0));
}
