//! Estimates of driven motions by harmonic balance, with which Newton's method begins.
//!
//! # Method
//! Each coordinate is a mean and a few harmonics. The projections of the equations of motion on the same functions are solved by Newton's method
//! from motions of one harmonic, with four phases and amplitudes over three decades on both sides of 1, and farther with known motions of another
//! size, whatever the unit of length (of angles up to half a turn), and from constants. Near a fold the balance of one harmonic may have no solution
//! where one of more harmonics has: a start whose changes stay small begins the latter too.

use super::family::Family;
use super::turns::Turns;
use libration_motion::internals::periodic::norm;
use libration_numbers::algebra::Doubles;
use libration_numbers::internals::algebra::Lanes;
use libration_numbers::internals::expression::Jet;
use libration_numbers::internals::linear::solve;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The equations of harmonic balance at one value of the parameter. A motion is given by the coefficients of its functions, coordinate by coordinate.
pub(super) struct HarmonicBalance<'f> {
    family: &'f Family<'f>,
    jet: Jet<'f, Lanes<SAMPLES>>,
    parameter: f64,
    frequency: f64,
    samples: Vec<Samples>,
}

/// Number of samples of each harmonic, which are computed together: the cube of the first harmonic is still distinguished from it.
const SAMPLES: usize = 8;

type Values = [f64; SAMPLES];

/// The mean and the harmonics, with their first and second derivatives, at some times.
struct Samples {
    times: Values,
    functions: [Vec<Values>; 3],
}

/// The highest derivatives of the coordinates at samples, and their slopes by components of the state.
struct SampledRates {
    values: Vec<Values>,
    slopes: Vec<Vec<Values>>,
}

/// A motion by estimate.
pub(super) struct Estimate {
    /// The state at time zero.
    pub(super) state: Vec<f64>,
    motion: Vec<f64>,
    coordinates: usize,
    /// `false` if it still changes, as near a fold of the equations with few harmonics, where motions with more of them may exist.
    settled: bool,
}

impl Estimate {
    fn functions(&self) -> usize {
        self.motion.len() / self.coordinates
    }

    /// The means of the coordinates.
    pub(super) fn means(&self) -> Vec<f64> {
        self.motion.iter().copied().step_by(self.functions()).collect()
    }

    /// Returns `true` unless each coordinate passes a centre.
    pub(super) fn is_about_another(&self, centre: &[f64]) -> bool {
        let passes = |(motion, centre): (&[f64], &f64)| (motion[0] - centre).abs() <= norm(&motion[1..]);
        !self.motion.chunks(self.functions()).zip(centre).all(passes)
    }
}

impl Samples {
    fn new(times: Values, frequency: f64, harmonics: u32) -> Self {
        let functions = [0.0, 1.0, 2.0].map(|derivatives: f64| {
            let mean = if derivatives > 0.0 { 0.0 } else { 1.0 };
            let pair = |k: u32| {
                let rate = frequency * f64::from(k);
                let (turned, size) = (FRAC_PI_2 * derivatives, libm::pow(rate, derivatives));
                [libm::cos, libm::sin].map(|f| times.map(|time| size * f(rate * time + turned)))
            };
            std::iter::once([mean; SAMPLES]).chain((1..=harmonics).flat_map(pair)).collect()
        });
        Self { times, functions }
    }

    /// A derivative of a coordinate with these coefficients.
    fn value(&self, coefficients: &[f64], derivatives: usize) -> Values {
        let functions = &self.functions[derivatives];
        std::array::from_fn(|k| coefficients.iter().zip(functions).map(|(a, b)| a * b[k]).sum())
    }
}

impl<'f> HarmonicBalance<'f> {
    /// The balance of motions with a period of some periods of the drive, up to a multiple of its frequency.
    pub(super) fn new(
        family: &'f Family<'f>,
        parameter: f64,
        drive_periods: u32,
        multiple: u32,
    ) -> Option<Self> {
        let period = f64::from(drive_periods) * family.drive_period(&[parameter])?;
        let frequency = TAU / period;
        let harmonics = drive_periods * multiple;
        let between = period / f64::from(harmonics);
        let samples = |first: u32| {
            let times = [0, 1, 2, 3, 4, 5, 6, 7]
                .map(|eighth| between * (f64::from(first) + 0.125 * f64::from(eighth)));
            Samples::new(times, frequency, harmonics)
        };
        let inputs = vec![[0.5; SAMPLES]; family.layout.numbers() + 2];
        let jet = Jet::new(&Lanes, family.rates(), &inputs).ok()?;
        let samples = (0..harmonics).map(samples).collect();
        Some(Self { family, jet, parameter, frequency, samples })
    }

    /// Number of functions of each coordinate.
    fn functions(&self) -> usize {
        self.samples[0].functions[0].len()
    }

    /// The different motions that are found about some centre, or from there with whole turns of angles, beside known ones of this size.
    pub(super) fn motions(&mut self, centre: &[f64], turns: &Turns, known: f64) -> Vec<Estimate> {
        /// Largest difference of two results for one motion, relative to its size, if both have settled and if not.
        const SAME: [f64; 2] = [1e-2, 0.1];
        let mut estimates: Vec<Estimate> = vec![];
        for start in self.starts(centre, turns, known) {
            if self.family.watch.is_stopped() {
                break;
            }
            let Some((mut motion, settled)) = self.solved(start) else { continue };
            let mut means: Vec<f64> = motion.iter().copied().step_by(self.functions()).collect();
            let centre = means.clone();
            turns.subtract(&mut means, |coordinate| centre[coordinate]);
            motion.iter_mut().step_by(self.functions()).zip(means).for_each(|(entry, mean)| *entry = mean);
            let is_same = |other: &Estimate| {
                let apart: Vec<f64> = other.motion.iter().zip(&motion).map(|(a, b)| a - b).collect();
                let same = SAME[usize::from(!(other.settled && settled))];
                norm(&apart) <= same * norm(&motion)
            };
            if !estimates.iter().any(is_same) {
                estimates.push(self.estimate(motion, settled));
            }
        }
        estimates
    }

    /// The motion near an estimate by fewer harmonics; if there is none, the estimate as far as it has settled.
    pub(super) fn refined(&mut self, coarse: Estimate) -> Option<Estimate> {
        let each = self.functions();
        let resized = coarse.motion.chunks(coarse.functions()).flat_map(|coefficients| {
            let zeros = std::iter::repeat_n(0.0, each - coefficients.len());
            coefficients.iter().copied().chain(zeros)
        });
        match self.solved(resized.collect()) {
            Some((motion, true)) => Some(self.estimate(motion, true)),
            _ => Some(coarse).filter(|estimate| estimate.settled),
        }
    }

    fn estimate(&self, motion: Vec<f64>, settled: bool) -> Estimate {
        let state = self.states(&motion, &self.samples[0]).iter().map(|state| state[0]).collect();
        Estimate { state, motion, coordinates: self.family.layout.coordinates(), settled }
    }

    /// The motions with which Newton's method begins: constants, and motions of the first harmonic.
    fn starts(&self, centre: &[f64], turns: &Turns, known: f64) -> Vec<Vec<f64>> {
        /// Amplitudes of angles, in turns.
        const TURNS: [f64; 7] = [0.03, 0.1, 0.18, 0.26, 0.34, 0.42, 0.48];
        /// Whole turns between coordinates of a group, one of which turned first.
        const TURNS_APART: [f64; 3] = [0.5, 1.0, 2.0];
        /// Half decades on either side of 1; and one decade above known motions, beyond which those of angles in degrees repeat themselves.
        const HALF_DECADES: f64 = 6.0;
        const ABOVE: f64 = 2.0;
        let size = if known.is_normal() { libm::round(2.0 * libm::log10(known)) } else { 0.0 };
        let [least, most] = [size.min(0.0) - HALF_DECADES, HALF_DECADES.max(size + ABOVE)];
        let halves = std::iter::successors(Some(least), |half| Some(half + 1.0));
        let decades = halves.take_while(|half| *half <= most).map(|half| libm::exp10(0.5 * half));
        let mut starts = vec![];
        for shape in shapes(self.family.layout.coordinates()) {
            let any = |is: &dyn Fn(usize) -> bool| {
                (0..).zip(&shape).any(|(number, part)| *part != 0.0 && is(number))
            };
            let amplitudes: Vec<f64> = if any(&|coordinate| turns.is_angle(coordinate)) {
                TURNS.map(|turns| turns * TAU).to_vec()
            } else if any(&|coordinate| turns.is_coupled(coordinate)) {
                decades.clone().chain(TURNS_APART.map(|turns| turns * TAU)).collect()
            } else {
                decades.clone().collect()
            };
            for size in amplitudes.into_iter().flat_map(|amplitude| [amplitude, -amplitude]) {
                // The mean, the cosine and the sine.
                starts.extend((0..3).map(|function| self.moved(centre, &shape, function, size)));
            }
        }
        starts
    }

    /// The constant motion with one function added to it.
    fn moved(&self, centre: &[f64], shape: &[f64], function: usize, size: f64) -> Vec<f64> {
        let mut motion = self.constant(centre);
        let coefficients = motion.iter_mut().skip(function).step_by(self.functions());
        coefficients.zip(shape).for_each(|(coefficient, part)| *coefficient += size * part);
        motion
    }

    fn constant(&self, centre: &[f64]) -> Vec<f64> {
        let each = self.functions();
        (0..self.family.layout.coordinates() * each)
            .map(|i| if i % each == 0 { centre[i / each] } else { 0.0 })
            .collect()
    }

    /// The motion to which Newton's method leads, and `true` if it has settled; `None` if its changes stay large.
    fn solved(&mut self, mut motion: Vec<f64>) -> Option<(Vec<f64>, bool)> {
        const MOST_ROUNDS: [usize; 2] = [8, 12];
        /// Round from which the changes have to be small. From a start far above all motions of a cubic spring a round takes away only a third of the
        /// amplitude: such a start is given up, for those at smaller amplitudes. In first order velocities are coordinates, which the start does not
        /// know: with 3 rounds a double well of first order has none of the motions in its wells.
        const FROM_ROUND: [usize; 2] = [3, 5];
        const SMALL: f64 = 0.3;
        /// Largest change in a round, relative to the size of the motion.
        const LARGEST_CHANGE: f64 = 1.0;
        /// Relative change after which the next one is about as large as the differences to further harmonics or smaller.
        const CLOSE: f64 = 1e-3;
        let layout = &self.family.layout;
        let has_first_order =
            (0..layout.coordinates()).any(|coordinate| layout.velocity(coordinate).is_none());
        let [most_rounds, from_round] =
            [MOST_ROUNDS, FROM_ROUND].map(|rounds| rounds[usize::from(has_first_order)]);
        let mut settled = false;
        for round in 0..most_rounds {
            let size = norm(&motion).max(f64::MIN_POSITIVE);
            let (missed, matrix) = self.equations(&motion, size)?;
            let change = solve(&Doubles, |x| x.abs(), &matrix, &missed)?;
            let relative = norm(&change) / size;
            if !relative.is_finite() || (round >= from_round && relative > SMALL) {
                return None;
            }
            let part = if relative > LARGEST_CHANGE { LARGEST_CHANGE / relative } else { 1.0 };
            motion.iter_mut().zip(&change).for_each(|(x, change)| *x -= part * change);
            settled = relative <= CLOSE;
            if settled {
                break;
            }
        }
        Some((motion, settled))
    }

    /// The residuals of the equations and, by rows, their derivatives with respect to the coefficients.
    fn equations(&mut self, motion: &[f64], size: f64) -> Option<(Vec<f64>, Vec<Vec<f64>>)> {
        let (count, each) = (motion.len(), self.functions());
        let (mut missed, mut matrix) = (vec![0.0; count], vec![vec![0.0; count]; count]);
        for number in 0..self.samples.len() {
            let rates = self.rates(motion, number, size)?;
            let (samples, layout) = (&self.samples[number], &self.family.layout);
            let [displacements, velocities, _] = &samples.functions;
            for coordinate in 0..layout.coordinates() {
                let order = if layout.velocity(coordinate).is_some() { 2 } else { 1 };
                let highest = samples.value(&motion[coordinate * each..], order);
                let project = |values: Values, row: usize| inner(&values, &displacements[row]);
                let residual = std::array::from_fn(|k| highest[k] - rates.values[coordinate][k]);
                let rows = &mut missed[coordinate * each..][..each];
                rows.iter_mut().enumerate().for_each(|(row, missed)| *missed += project(residual, row));
                let rows = &mut matrix[coordinate * each..][..each];
                for column in 0..count {
                    let (other, function) = (column / each, column % each);
                    let by_place = &rates.slopes[other][coordinate];
                    let by_velocity =
                        layout.velocity(other).map(|velocity| &rates.slopes[velocity][coordinate]);
                    let slope = std::array::from_fn(|k| {
                        let velocity = by_velocity.map_or(0.0, |slopes| slopes[k] * velocities[function][k]);
                        let highest =
                            if other == coordinate { samples.functions[order][function][k] } else { 0.0 };
                        highest - by_place[k] * displacements[function][k] - velocity
                    });
                    rows.iter_mut()
                        .enumerate()
                        .for_each(|(row, entries)| entries[column] += project(slope, row));
                }
            }
        }
        Some((missed, matrix))
    }

    fn states(&self, motion: &[f64], samples: &Samples) -> Vec<Values> {
        let each = self.functions();
        let value = |coordinate: usize, order| samples.value(&motion[coordinate * each..], order);
        self.family.layout.arrange(
            (0..self.family.layout.coordinates()).map(|coordinate| value(coordinate, 0)),
            |coordinate| value(coordinate, 1),
        )
    }

    fn rates(&mut self, motion: &[f64], number: usize, size: f64) -> Option<SampledRates> {
        /// Change of a component, relative to the size of the motion, for a difference with half of the digits.
        const ASIDE: f64 = 1e-7;
        let samples = &self.samples[number];
        let mut inputs = self.states(motion, samples);
        let components = inputs.len();
        inputs.extend([samples.times, [self.parameter; SAMPLES]]);
        let values = self.highest(&inputs)?;
        let mut slopes = vec![];
        for component in 0..components {
            let is_velocity = component >= self.family.layout.coordinates();
            let aside = ASIDE * size * if is_velocity { self.frequency } else { 1.0 };
            let before = inputs[component];
            inputs[component] = before.map(|before| before + aside);
            let there = self.highest(&inputs)?;
            let slope =
                |(there, here): (&Values, &Values)| std::array::from_fn(|k| (there[k] - here[k]) / aside);
            slopes.push(there.iter().zip(&values).map(slope).collect());
            inputs[component] = before;
        }
        Some(SampledRates { values, slopes })
    }

    fn highest(&mut self, inputs: &[Values]) -> Option<Vec<Values>> {
        self.jet.restart(inputs).ok()?;
        Some((0..self.family.layout.coordinates()).map(|coordinate| self.jet.result(coordinate)[0]).collect())
    }
}

fn inner(a: &Values, b: &Values) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Proportions of the coordinates: each alone, all together, and neighbours in opposition.
fn shapes(coordinates: usize) -> Vec<Vec<f64>> {
    let each = |part: &dyn Fn(usize) -> f64| (0..coordinates).map(part).collect();
    let alone = (0..coordinates).map(|moving| each(&|number| f64::from(number == moving)));
    let together = [1.0, -1.0].map(|sign| each(&|number| if number % 2 == 0 { 1.0 } else { sign }));
    alone.chain(together.into_iter().filter(|_| coordinates > 1)).collect()
}
