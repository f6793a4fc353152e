//! The motion of one coordinate from rest to rest in floats of many bits, for cases that double precision cannot resolve.
//!
//! Next to a separatrix the energy decides how long a motion lingers, and between two saddles of the same height a distance δ from them is a
//! difference δ² in energy. The precision of all numbers is therefore high enough to leave sufficient significant bits.
//!
//! Coefficients do not show everything: at x = 3 all of those of e^(−20000(x − 2)²) are below the last bit of a motion that is about to pass x =
//! 2. Each step is therefore compared with an integration in double precision, which detects such forces, and is shortened until both agree. An
//! effect on a step below [`UNSEEN`] is not detected, nor a force that begins where double precision has no values.

use crate::periodic::{precise_series, precise_step, precise_sum};
use crate::taylor::{Effort, Moment, OwnedStep, StateLayout, System, integrate};
use libration_numbers::algebra::{BigFloat, Doubles, Floats, Ring};
use libration_numbers::internals::expression::{Jet, Tape};
use libration_numbers::internals::progress::Watch;
use libration_numbers::roots::{Tolerance, bisect};
use std::slice;

/// Position and velocity.
#[derive(Clone, Debug)]
struct PreciseState {
    x: BigFloat,
    velocity: BigFloat,
}

/// Position and velocity as power series in time.
struct Series {
    x: Vec<BigFloat>,
    velocity: Vec<BigFloat>,
}

/// A motion from rest to the next rest.
#[derive(Debug)]
pub struct HalfPeriod {
    pub(super) steps: Vec<OwnedStep>,
    pub duration: BigFloat,
    /// The position at the end.
    pub end: BigFloat,
}

/// The reason why the motion to the next rest cannot be computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HalfPeriodError {
    /// The motion comes so near an equilibrium that these bits do not determine its continuation.
    Undecided,
    /// The motion does not come to rest up to a time, and is then far away, or at a position where the equation has no value.
    Lost(f64),
    /// The series terminate without showing their range of convergence, there are too many steps, or the call is cancelled.
    Unable,
}

/// An acceleration as a function of position and velocity.
#[derive(Debug)]
pub struct Motion<'a> {
    system: &'a System,
    tape: &'a Tape,
    ring: Floats,
    order: u32,
    watch: &'a Watch<'a>,
}

/// Maximum number of steps of a half period; only motions without end take more.
const MOST_STEPS: usize = 600;
/// Difference of positions, relative to their size, up to which the same step in double precision may end: rounding errors of the start, about
/// 1e-16, grow at most as e^T from an unstable equilibrium. Steps so long that this exceeds the limit are halved without need.
const UNSEEN: f64 = 1e-12;
/// Number of halvings after which the disagreement of two integrations cannot be due to the length of the step.
const MOST_HALVINGS: u32 = 60;

impl<'a> Motion<'a> {
    pub fn new(system: &'a System, tape: &'a Tape, precision: usize, watch: &'a Watch<'a>) -> Self {
        // With p/3 terms a step is an eighth of the radius of convergence, close to the optimum for products of series.
        let order = u32::try_from(precision / 3).unwrap_or(u32::MAX);
        Self { system, tape, ring: Floats { precision }, order, watch }
    }

    /// The motion after release from rest at a position; `start` is the time from which its steps count.
    pub fn half_period(&self, position: &BigFloat, start: f64) -> Result<HalfPeriod, HalfPeriodError> {
        let size = position.exponent().unwrap_or(0);
        let mut state = PreciseState { x: position.clone(), velocity: self.ring.zero() };
        let (mut steps, mut duration) = (vec![], self.ring.zero());
        let mut nearness = Nearness::default();
        for _ in 0..MOST_STEPS {
            self.watch.go_on().map_err(|_| HalfPeriodError::Unable)?;
            let lost = HalfPeriodError::Lost(duration.to_f64());
            if is_far(&state.x, size) {
                return Err(lost);
            }
            // Exponentials of large numbers, which take too long here, have values in double precision.
            let no_series = || if self.has_value_nearby(&state) { HalfPeriodError::Unable } else { lost };
            let series = self.series(&state).ok_or_else(no_series)?;
            nearness.watch(&state.velocity, &series.velocity[1], self.ring.precision)?;
            let size = size.max(state.x.exponent().unwrap_or(size));
            let longest = precise_step(self.ring.precision, slice::from_ref(&series.x), size);
            let length = self.tried(&state, &series, longest.ok_or(HalfPeriodError::Unable)?, size)?;
            let begin = start + duration.to_f64();
            if let Some(rest) = self.rest_within(&series, length) {
                duration = duration + rest.clone();
                let end = precise_sum(&series.x, &rest);
                nearness.conclude(self.ring.precision)?;
                steps.push(owned_step(&series, begin, start + duration.to_f64(), length));
                return Ok(HalfPeriod { steps, duration, end });
            }
            let elapsed = BigFloat::from_f64(length, self.ring.precision).ok_or(HalfPeriodError::Unable)?;
            duration = duration + elapsed.clone();
            steps.push(owned_step(&series, begin, start + duration.to_f64(), length));
            state = PreciseState {
                x: precise_sum(&series.x, &elapsed),
                velocity: precise_sum(&series.velocity, &elapsed),
            };
        }
        Err(HalfPeriodError::Unable)
    }

    fn has_value_nearby(&self, state: &PreciseState) -> bool {
        let state = [state.x.to_f64(), state.velocity.to_f64()];
        Jet::new(&Doubles, self.tape, &state).is_ok_and(|jet| jet.result(0)[0].is_finite())
    }

    /// The series at a state; `None` if the acceleration has no value.
    fn series(&self, state: &PreciseState) -> Option<Series> {
        let motion = (&StateLayout::one_coordinate(), self.tape);
        let state = [state.x.clone(), state.velocity.clone()];
        let series = precise_series(self.ring, motion, self.order, &state, &[])?;
        let [x, velocity] = series.try_into().ok()?;
        Some(Series { x, velocity })
    }

    /// The length of a step, shortened until double precision agrees.
    fn tried(
        &self,
        state: &PreciseState,
        series: &Series,
        length: f64,
        size: isize,
    ) -> Result<f64, HalfPeriodError> {
        let lengths = (0..MOST_HALVINGS).map(|halvings| libm::ldexp(length, -halvings.cast_signed()));
        let unseen = UNSEEN * libm::ldexp(1.0, i32::try_from(size).unwrap_or(i32::MAX));
        let agrees = |length: &f64| {
            let [position, velocity] = self.misfit(state, series, *length).unwrap_or_default();
            position <= unseen && velocity * length <= unseen
        };
        lengths.into_iter().find(agrees).ok_or(HalfPeriodError::Unable)
    }

    /// The difference between the end of a step in double precision and the sums of the series; `None` if double precision has no values.
    fn misfit(&self, state: &PreciseState, series: &Series, length: f64) -> Option<[f64; 2]> {
        const MOST_STEPS: usize = 10_000;
        let start = Moment { time: 0.0, state: vec![state.x.to_f64(), state.velocity.to_f64()] };
        let effort = Effort { most_steps: MOST_STEPS, ..Effort::to_tolerance(1e-16) };
        let solution = integrate(self.system, &start, &[length], &effort, &self.watch.part());
        let solution = solution.ok()?;
        let elapsed = BigFloat::from_f64(length, self.ring.precision)?;
        let ends = [&series.x, &series.velocity].map(|series| precise_sum(series, &elapsed).to_f64());
        let misfits =
            ends.iter().zip(&solution.end.state).map(|(by_series, other)| (by_series - other).abs());
        misfits.collect::<Vec<_>>().try_into().ok()
    }

    /// The time at which the velocity vanishes in a step, to the last bit; `None` if the velocity has no zero.
    fn rest_within(&self, series: &Series, length: f64) -> Option<BigFloat> {
        let near = sign_change(&scaled(&series.velocity, length))? * length;
        let mut time = BigFloat::from_f64(near, self.ring.precision)?;
        let slope: Vec<BigFloat> =
            (1_i64..).zip(&series.velocity[1..]).map(|(n, c)| self.ring.times_integer(c, n)).collect();
        for _ in 0..self.ring.precision.ilog2() {
            let step = precise_sum(&series.velocity, &time) / precise_sum(&slope, &time);
            time = time - step;
        }
        Some(time)
    }
}

/// The proximity of a motion to equilibria, where velocity and acceleration are both small.
#[derive(Default)]
struct Nearness {
    /// The first acceleration, the largest one, and the largest velocity, as powers of two.
    first: Option<isize>,
    acceleration: Option<isize>,
    velocity: Option<isize>,
}

impl Nearness {
    fn watch(
        &mut self,
        velocity: &BigFloat,
        acceleration: &BigFloat,
        precision: usize,
    ) -> Result<(), HalfPeriodError> {
        let (v, a) = (velocity.exponent(), acceleration.exponent());
        self.first = self.first.or(a);
        self.velocity = self.velocity.max(v);
        self.acceleration = self.acceleration.max(a);
        let below = |binary_exponent: Option<isize>, largest: Option<isize>| {
            largest
                .is_some_and(|largest| binary_exponent.is_none_or(|size| size - largest < -limit(precision)))
        };
        let near = below(v, self.velocity) && below(a, self.acceleration);
        if near { Err(HalfPeriodError::Undecided) } else { Ok(()) }
    }

    /// Concludes the check at the end, where the size of the first acceleration is known.
    fn conclude(&self, precision: usize) -> Result<(), HalfPeriodError> {
        let parts = self.first.zip(self.acceleration);
        let near = parts.is_none_or(|(first, largest)| first - largest < -limit(precision));
        if near { Err(HalfPeriodError::Undecided) } else { Ok(()) }
    }
}

/// The exponent below which the motion is undecided, 2^(−3p/8): a motion on the separatrix
/// to p bits comes within 2^(−p/2) of the equilibrium, where its energy is lost in rounding.
fn limit(precision: usize) -> isize {
    isize::try_from(3 * precision / 8).unwrap_or(isize::MAX)
}

/// Returns `true` if a position is so far from the first one that a motion does not return from there after passing an equilibrium slowly.
fn is_far(position: &BigFloat, size: isize) -> bool {
    const FAR: isize = 40;
    position.exponent().is_some_and(|exponent| exponent > size.max(0) + FAR)
}

/// The coefficients in powers of the fraction of a step, which neither overflow nor underflow.
fn scaled(series: &[BigFloat], length: f64) -> Vec<f64> {
    /// Precision in bits of the intermediate results, which are rounded to 53 bits at the end.
    const ENOUGH: usize = 64;
    let Some(length) = BigFloat::from_f64(length, ENOUGH) else { return vec![] };
    let powers = std::iter::successors(Some(BigFloat::from_integer(1, ENOUGH)), |power| {
        Some(power.clone() * length.clone())
    });
    series.iter().zip(powers).map(|(c, power)| (c.rounded_to(ENOUGH) * power).to_f64()).collect()
}

/// The first sign change of a polynomial on [0, 1]; for a polynomial that begins at zero, the sign shortly afterwards counts.
fn sign_change(polynomial: &[f64]) -> Option<f64> {
    const LOOKS: u32 = 16;
    /// Earlier than the first of the looks, later than what rounding makes of a zero.
    const SOON: f64 = 1e-3;
    let value = |part: f64| polynomial.iter().rev().fold(0.0, |sum, c| sum * part + c);
    let sign = value(if polynomial[0] == 0.0 { SOON } else { 0.0 });
    let turned = |part: f64| value(part) * sign <= 0.0;
    let after = (1..=LOOKS).map(|look| f64::from(look) / f64::from(LOOKS)).find(|part| turned(*part))?;
    let before = (after - 1.0 / f64::from(LOOKS)).max(SOON);
    let [before, after] = bisect([before, after], Tolerance::LAST_BIT, |part| !turned(part));
    Some(f64::midpoint(before, after))
}

/// The step in double precision, with length one in a suitable unit.
fn owned_step(series: &Series, start: f64, end: f64, unit: f64) -> OwnedStep {
    OwnedStep::new(start, end, unit, [scaled(&series.x, unit), scaled(&series.velocity, unit)])
}
