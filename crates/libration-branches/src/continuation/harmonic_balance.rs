//! Estimates of driven motions by harmonic balance, with which Newton's method begins.
//!
//! # Method
//! Each coordinate is a mean and a few harmonics. The projections of the equations of motion on the same functions are solved by Newton's method
//! from motions of one harmonic, with amplitudes over six decades (of angles up to half a turn) and four phases, and from constants.

use super::family::Family;
use libration_motion::internals::periodic::norm;
use libration_motion::taylor::StateLayout;
use libration_numbers::algebra::Doubles;
use libration_numbers::internals::expression::Jet;
use libration_numbers::internals::linear::solve;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The equations of harmonic balance at one value of the parameter. A motion is given by the coefficients of its functions, coordinate by coordinate.
pub(super) struct HarmonicBalance<'f> {
    layout: &'f StateLayout,
    jet: Jet<'f, Doubles>,
    parameter: f64,
    frequency: f64,
    samples: Vec<Sample>,
}

/// The mean and the harmonics, with their first and second derivatives, at one time.
struct Sample {
    time: f64,
    functions: [Vec<f64>; 3],
}

/// The highest derivatives of the coordinates at a sample, and their slopes by components of the state.
struct Rates {
    own: Vec<f64>,
    slopes: Vec<Vec<f64>>,
}

/// A motion by estimate.
pub(super) struct Estimate {
    /// The state at time zero.
    pub(super) state: Vec<f64>,
    motion: Vec<f64>,
    coordinates: usize,
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
        let passes = |(own, centre): (&[f64], &f64)| (own[0] - centre).abs() <= norm(&own[1..]);
        !self.motion.chunks(self.functions()).zip(centre).all(passes)
    }
}

impl Sample {
    fn new(time: f64, frequency: f64, harmonics: u32) -> Self {
        let functions = [0.0, 1.0, 2.0].map(|derivatives: f64| {
            let mean = if derivatives > 0.0 { 0.0 } else { 1.0 };
            let pair = |k: u32| {
                let rate = frequency * f64::from(k);
                let (angle, size) = (rate * time + FRAC_PI_2 * derivatives, libm::pow(rate, derivatives));
                [size * libm::cos(angle), size * libm::sin(angle)]
            };
            std::iter::once(mean).chain((1..=harmonics).flat_map(pair)).collect()
        });
        Self { time, functions }
    }
}

impl<'f> HarmonicBalance<'f> {
    /// The balance of motions with a period of some periods of the drive, up to a multiple of its frequency.
    pub(super) fn new(
        family: &'f Family<'_>,
        parameter: f64,
        drive_periods: u32,
        multiple: u32,
    ) -> Option<Self> {
        /// Number of samples of each harmonic: the cube of the first harmonic is still distinguished from it.
        const SAMPLES: u32 = 8;
        let period = f64::from(drive_periods) * family.drive_period(&[parameter])?;
        let frequency = TAU / period;
        let harmonics = drive_periods * multiple;
        let number = SAMPLES * harmonics;
        let time = |k: u32| period * f64::from(k) / f64::from(number);
        let samples = (0..number).map(|k| Sample::new(time(k), frequency, harmonics)).collect();
        let jet = Jet::new(&Doubles, family.rates(), &vec![0.5; family.layout.numbers() + 2]).ok()?;
        Some(Self { layout: &family.layout, jet, parameter, frequency, samples })
    }

    /// Number of functions of each coordinate.
    fn functions(&self) -> usize {
        self.samples[0].functions[0].len()
    }

    /// The different motions that are found about some centre, or from there with whole turns of angles.
    pub(super) fn motions(&mut self, centre: &[f64], angles: &[bool]) -> Vec<Estimate> {
        /// Largest difference of two results for one motion, relative to its size.
        const SAME: f64 = 1e-2;
        let mut found: Vec<Vec<f64>> = vec![];
        for start in self.starts(centre, angles) {
            let Some(mut motion) = self.solved(start) else { continue };
            let means = motion.iter_mut().step_by(self.functions()).zip(angles);
            means.filter(|(_, angle)| **angle).for_each(|(mean, _)| *mean -= TAU * libm::rint(*mean / TAU));
            let is_same = |other: &Vec<f64>| {
                let apart: Vec<f64> = other.iter().zip(&motion).map(|(a, b)| a - b).collect();
                norm(&apart) <= SAME * norm(&motion)
            };
            if !found.iter().any(is_same) {
                found.push(motion);
            }
        }
        found.into_iter().map(|motion| self.estimate(motion)).collect()
    }

    /// The motion near an estimate by fewer harmonics, or the estimate if there is none.
    pub(super) fn refined(&mut self, coarse: Estimate) -> Estimate {
        let each = self.functions();
        let resized = coarse.motion.chunks(coarse.functions()).flat_map(|own| {
            let zeros = std::iter::repeat_n(0.0, each - own.len());
            own.iter().copied().chain(zeros)
        });
        let resized = resized.collect();
        self.solved(resized).map_or(coarse, |motion| self.estimate(motion))
    }

    fn estimate(&self, motion: Vec<f64>) -> Estimate {
        Estimate {
            state: self.state(&motion, &self.samples[0]),
            motion,
            coordinates: self.layout.coordinates(),
        }
    }

    /// The motions with which Newton's method begins: constants, and motions of the first harmonic.
    fn starts(&self, centre: &[f64], angles: &[bool]) -> Vec<Vec<f64>> {
        /// Amplitudes of angles, in turns.
        const TURNS: [f64; 7] = [0.03, 0.1, 0.18, 0.26, 0.34, 0.42, 0.48];
        let decades = (-6..=6).map(|half| libm::exp10(0.5 * f64::from(half)));
        let mut starts = vec![];
        for shape in shapes(self.layout.coordinates()) {
            let is_angle = shape.iter().zip(angles).any(|(part, angle)| *angle && *part != 0.0);
            let amplitudes: Vec<f64> =
                if is_angle { TURNS.map(|it| it * TAU).to_vec() } else { decades.clone().collect() };
            for size in amplitudes.into_iter().flat_map(|it| [it, -it]) {
                // The mean, the cosine and the sine.
                starts.extend((0..3).map(|function| self.moved(centre, &shape, function, size)));
            }
        }
        starts
    }

    /// The constant motion with one function added to it.
    fn moved(&self, centre: &[f64], shape: &[f64], function: usize, size: f64) -> Vec<f64> {
        let mut motion = self.constant(centre);
        let own = motion.iter_mut().skip(function).step_by(self.functions());
        own.zip(shape).for_each(|(coefficient, part)| *coefficient += size * part);
        motion
    }

    fn constant(&self, centre: &[f64]) -> Vec<f64> {
        let each = self.functions();
        (0..self.layout.coordinates() * each)
            .map(|i| if i % each == 0 { centre[i / each] } else { 0.0 })
            .collect()
    }

    /// The motion to which Newton's method leads; `None` if it does not converge.
    fn solved(&mut self, mut motion: Vec<f64>) -> Option<Vec<f64>> {
        const MOST_ROUNDS: usize = 8;
        /// Round from which the changes have to be small.
        const SETTLED: usize = 4;
        /// Largest change in a round, relative to the size of the motion.
        const LARGEST_CHANGE: f64 = 1.0;
        /// Relative change after which the next one is about as large as the differences to further harmonics or smaller.
        const CLOSE: f64 = 1e-3;
        for round in 0..MOST_ROUNDS {
            let size = norm(&motion).max(f64::MIN_POSITIVE);
            let (missed, matrix) = self.equations(&motion, size)?;
            let change = solve(&Doubles, |x| x.abs(), &matrix, &missed)?;
            let relative = norm(&change) / size;
            if !relative.is_finite() || (round >= SETTLED && relative > 0.5) {
                return None;
            }
            let part = if relative > LARGEST_CHANGE { LARGEST_CHANGE / relative } else { 1.0 };
            motion.iter_mut().zip(&change).for_each(|(x, change)| *x -= part * change);
            if relative <= CLOSE {
                return Some(motion);
            }
        }
        None
    }

    /// The residuals of the equations and, by rows, their derivatives with respect to the coefficients.
    fn equations(&mut self, motion: &[f64], size: f64) -> Option<(Vec<f64>, Vec<Vec<f64>>)> {
        let (count, each) = (motion.len(), self.functions());
        let (mut missed, mut matrix) = (vec![0.0; count], vec![vec![0.0; count]; count]);
        for number in 0..self.samples.len() {
            let rates = self.rates(motion, number, size)?;
            let functions = &self.samples[number].functions;
            for coordinate in 0..self.layout.coordinates() {
                let order = if self.layout.velocity(coordinate).is_some() { 2 } else { 1 };
                let highest = sum(&motion[coordinate * each..], &functions[order]);
                let slopes: Vec<f64> = (0..count)
                    .map(|j| {
                        let (other, function) = (j / each, j % each);
                        let place = rates.slopes[other][coordinate] * functions[0][function];
                        let velocity = self
                            .layout
                            .velocity(other)
                            .map_or(0.0, |it| rates.slopes[it][coordinate] * functions[1][function]);
                        let own = if other == coordinate { functions[order][function] } else { 0.0 };
                        own - place - velocity
                    })
                    .collect();
                for (i, weight) in functions[0].iter().enumerate() {
                    let i = coordinate * each + i;
                    missed[i] += weight * (highest - rates.own[coordinate]);
                    matrix[i].iter_mut().zip(&slopes).for_each(|(entry, slope)| *entry += weight * slope);
                }
            }
        }
        Some((missed, matrix))
    }

    fn state(&self, motion: &[f64], sample: &Sample) -> Vec<f64> {
        let each = self.functions();
        let value = |coordinate: usize, derivatives: usize| {
            sum(&motion[coordinate * each..], &sample.functions[derivatives])
        };
        self.layout.arrange((0..self.layout.coordinates()).map(|it| value(it, 0)), |it| value(it, 1))
    }

    fn rates(&mut self, motion: &[f64], number: usize, size: f64) -> Option<Rates> {
        /// Change of a component, relative to the size of the motion, for a difference with half of the digits.
        const ASIDE: f64 = 1e-7;
        let mut state = self.state(motion, &self.samples[number]);
        let time = self.samples[number].time;
        let own = self.highest(&state, time)?;
        let mut slopes = vec![];
        for component in 0..state.len() {
            let is_velocity = component >= self.layout.coordinates();
            let aside = ASIDE * size * if is_velocity { self.frequency } else { 1.0 };
            let before = state[component];
            state[component] += aside;
            let there = self.highest(&state, time)?;
            slopes.push(there.iter().zip(&own).map(|(there, here)| (there - here) / aside).collect());
            state[component] = before;
        }
        Some(Rates { own, slopes })
    }

    fn highest(&mut self, state: &[f64], time: f64) -> Option<Vec<f64>> {
        let inputs: Vec<f64> = state.iter().copied().chain([time, self.parameter]).collect();
        self.jet.restart(&inputs).ok()?;
        Some((0..self.layout.coordinates()).map(|coordinate| self.jet.result(coordinate)[0]).collect())
    }
}

fn sum(coefficients: &[f64], functions: &[f64]) -> f64 {
    coefficients.iter().zip(functions).map(|(a, b)| a * b).sum()
}

/// Proportions of the coordinates: each alone, all together, and neighbours in opposition.
fn shapes(coordinates: usize) -> Vec<Vec<f64>> {
    let each = |part: &dyn Fn(usize) -> f64| (0..coordinates).map(part).collect();
    let alone = (0..coordinates).map(|own| each(&|it| f64::from(it == own)));
    let together = [1.0, -1.0].map(|sign| each(&|it| if it % 2 == 0 { 1.0 } else { sign }));
    alone.chain(together.into_iter().filter(|_| coordinates > 1)).collect()
}
