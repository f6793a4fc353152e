//! Comparison of steps with the equations of motion.
//!
//! The last coefficients determine the length of a step if the terms already decrease. Those of eˣ grow up to the order by which x changes, and
//! far on the side where eˣ vanishes they begin below the last bit: a step would pass through the potential wall ahead. So before a step is
//! taken the accelerations at its end are compared with those of its polynomials.
//!
//! # Method
//! Each step is compared with the equations of motion. If the accelerations at its end differ from those of its polynomials the step is halved,
//! until they agree or until the difference is a rounding error, measured in states a few ulp away. Coefficients do not show terms that begin
//! below the last bit: those of e^x, or of a power such as x¹⁰¹ next to zero.

use super::stepper::{SHORTEST, StepEnds, Stepper, unit_for};
use crate::taylor::Cause;
use crate::taylor::step::allowance::ROUNDING;
use crate::taylor::step::higher;
use crate::taylor::step::larger::{larger, larger_or_nan};
use libration_kernels::dispatch::{Kernel, dispatch_lanes};
use libration_kernels::fused::FusedMultiplyAdd;
use libration_numbers::internals::algebra::{any, lanes};

/// Allowed error in tolerances: for missing terms, 14 tolerances if a radius was estimated too large by a fourth, and rounding errors.
const TOLERANCES: f64 = 100.0;

/// The errors of the accelerations at a time, one per coordinate.
struct Trial {
    end: f64,
    /// The largest error, as a change of a velocity in the step relative to its size.
    misfit: f64,
    errors: Vec<f64>,
}

impl<const N: usize> Stepper<'_, N> {
    /// Shortens the steps until they agree with the equations of motion.
    pub(in crate::taylor) fn confirm(&mut self, outcomes: &mut [Result<(), Cause>; N]) {
        let Trials { misfits, is_seen } = dispatch_lanes::<N, _>(StepTrials { stepper: self });
        // The next steps begin with these values, unless another state is evaluated in the same buffer.
        self.ends_known = self.expander.system.moduli() == 0;
        if is_seen && !any(&misfits, |misfit| !self.is_confirmed(misfit)) {
            return;
        }
        let mut shortened = false;
        for lane in 0..N {
            let (start, end) = (self.block.start[lane], self.block.end[lane]);
            let moves = (end - start).abs() > 0.0 && outcomes[lane].is_ok() && !self.sticks(lane);
            if !moves || (self.is_confirmed(misfits[lane]) && !self.hides(lane, end)) {
                continue;
            }
            self.ends_known = false;
            let confirmed = self.confirmed_end(lane, end);
            outcomes[lane] = confirmed.map(|_| ());
            let confirmed = confirmed.unwrap_or(start);
            if (confirmed - end).abs() > 0.0 {
                shortened = true;
                self.block.end[lane] = confirmed;
                self.unit[lane] = unit_for((confirmed - start).abs());
            }
        }
        if shortened {
            dispatch_lanes::<N, _>(StepEnds { stepper: self });
        }
    }

    fn is_confirmed(&self, misfit: f64) -> bool {
        misfit <= self.bound()
    }

    fn bound(&self) -> f64 {
        TOLERANCES * self.effort.relative.max(ROUNDING)
    }

    /// Returns `true` if a force may act inside the step without an effect at its ends.
    fn hides(&self, lane: usize, end: f64) -> bool {
        let length = (end - self.block.start[lane]) / self.block.unit[lane];
        self.expander.plan.steep.iter().any(|steep| steep.is_unseen(&self.block, lane, length))
    }

    /// The end itself, or an earlier time, up to which the accelerations are those of the polynomials.
    pub(in crate::taylor) fn confirmed_end(&mut self, lane: usize, end: f64) -> Result<f64, Cause> {
        /// More halvings than `f64` has powers of two, 2098: any end comes as close to the start as numbers allow.
        const HALVINGS: usize = 2200;
        let start = self.block.start[lane];
        let mut end = end;
        let mut trials = vec![];
        for _ in 0..HALVINGS {
            if (end - start).abs() <= SHORTEST * start.abs() {
                break;
            }
            let hides = self.hides(lane, end);
            end = self.turn_before(lane, end);
            let trial = if hides { self.trial_inside(lane, end) } else { self.trial_at(lane, end, end) };
            if self.is_confirmed(trial.misfit) {
                return Ok(end);
            }
            trials.push(trial);
            end = start + 0.5 * (end - start);
        }
        end_in_noise(&trials).ok_or(Cause::StepUnderflow)
    }

    /// The end, or the turn of a steep argument before it.
    fn turn_before(&self, lane: usize, end: f64) -> f64 {
        /// Fraction of a step beyond which a turn counts as its end.
        const INSIDE: f64 = 0.999;
        let start = self.block.start[lane];
        let length = (end - start) / self.block.unit[lane];
        let unseen =
            self.expander.plan.steep.iter().filter(|steep| steep.is_unseen(&self.block, lane, length));
        let turns = unseen.filter_map(|steep| steep.first_turn(&self.block, lane, length));
        match turns.reduce(f64::min) {
            Some(part) if part < INSIDE => start + part * (end - start),
            _ => end,
        }
    }

    /// The errors at the end of a step and inside it.
    fn trial_inside(&mut self, lane: usize, end: f64) -> Trial {
        let mut trial = self.trial_at(lane, end, end);
        let start = self.block.start[lane];
        for part in looks() {
            let inside = self.trial_at(lane, start + (end - start) * part, end);
            trial.misfit = larger_or_nan(trial.misfit, inside.misfit);
            for (error, inside) in trial.errors.iter_mut().zip(inside.errors) {
                *error = larger_or_nan(*error, inside);
            }
        }
        trial
    }

    /// The errors at a time in a step to an end, without those due to the rounding of the state.
    fn trial_at(&mut self, lane: usize, time: f64, end: f64) -> Trial {
        let step = self.block.step(lane);
        let state = step.state_at(time);
        let length = (end - self.block.start[lane]).abs();
        let units = length / self.block.unit[lane];
        let layout = self.block.layout();
        let slopes: Vec<f64> =
            (0..layout.coordinates()).map(|i| step.slope_at(layout.driven(i), time)).collect();
        let absolute = self.effort.absolute;
        let sizes: Vec<f64> = (0..layout.coordinates())
            .map(|i| {
                let driven = layout.driven(i);
                let [zeroth, first, second] = [0, 1, 2].map(|n| step.coefficient(driven, n).abs());
                let held = if layout.is_velocity(driven) { zeroth } else { 0.0 };
                let floor = absolute / self.allowances[i].relative;
                size_of([held, first, second], (slopes[i] * length).abs(), units, floor)
            })
            .collect();
        let exact = self.accelerations(lane, time, &state);
        let mut errors: Vec<f64> =
            exact.iter().zip(&slopes).map(|(exact, slope)| (exact - slope).abs()).collect();
        let weights: Vec<f64> = self.allowances.iter().map(|allowance| allowance.weight).collect();
        let misfit = |errors: &[f64]| {
            let parts = errors.iter().zip(&sizes).zip(&weights);
            let parts = parts.map(|((error, size), weight)| part_of(error * length, *size) * weight);
            parts.fold(0.0, larger_or_nan)
        };
        if misfit(&errors).is_finite() && misfit(&errors) > self.bound() {
            for (error, noise) in errors.iter_mut().zip(self.noise(lane, time, &state, &exact)) {
                *error = if *error <= noise { 0.0 } else { *error };
            }
        }
        Trial { end, misfit: misfit(&errors), errors }
    }

    /// The effect of rounding the state on the accelerations.
    fn noise(&mut self, lane: usize, time: f64, state: &[f64], exact: &[f64]) -> Vec<f64> {
        /// Factor for the rounding errors of the formulas, which are similar to those measured.
        const MARGIN: f64 = 8.0;
        // With signs of one kind alone, formulas such as b·x − x²·y hide their noise where both terms are equal.
        const SIGNS: [f64; 2] = [-1.0, 1.0];
        let mut noise = vec![0.0; exact.len()];
        for (ulps, odd) in
            [1.0, -2.0, 3.0, -4.0].into_iter().flat_map(|ulps| SIGNS.map(|sign| (ulps, sign * ulps)))
        {
            let rounded = |(j, value): (usize, &f64)| {
                value * (1.0 + if j % 2 == 0 { ulps } else { odd } * f64::EPSILON)
            };
            let state: Vec<f64> = state.iter().enumerate().map(rounded).collect();
            let beside = self.accelerations(lane, time * (1.0 + ulps * f64::EPSILON), &state);
            for ((noise, beside), exact) in noise.iter_mut().zip(beside).zip(exact) {
                *noise = f64::max(*noise, MARGIN * (beside - exact).abs());
            }
        }
        noise
    }

    /// The accelerations of a lane in another state.
    fn accelerations(&mut self, lane: usize, time: f64, state: &[f64]) -> Vec<f64> {
        let Self { expander, scratch, surroundings, .. } = self;
        expander.accelerations(scratch, time, state, surroundings).map(|lanes| lanes[lane]).collect()
    }
}

/// Fractions of a step: evenly spaced, and closer and closer to its end, since a force may vanish where the argument of a steep function turns.
fn looks() -> impl Iterator<Item = f64> {
    const EVEN: u32 = 16;
    /// Halvings of the distance from the end: the last look is 2⁻³⁹ of the step before it.
    const NEARER: i32 = 40;
    let even = (1..EVEN).map(|look| f64::from(look) / f64::from(EVEN));
    even.chain((2..NEARER).map(|halvings| 1.0 - libm::ldexp(1.0, -halvings)))
}

/// The longest step whose errors no shorter step reduces, as in formulas with cancellation; `None` if there is none.
///
/// Errors of a polynomial of order 6 decrease at least by 2⁵ when the step is halved.
fn end_in_noise(trials: &[Trial]) -> Option<f64> {
    /// Number of halvings after which the errors have decreased by 2³⁰, below any noise that is not constant.
    const SHORT: usize = 6;
    const MARGIN: f64 = 8.0;
    /// Upper limit for the rounding errors of a meaningful formula.
    const LARGEST: f64 = 1e-3;
    let short = &trials[trials.len().checked_sub(SHORT)?..];
    let coordinates = short.first()?.errors.len();
    let noise: Vec<f64> = (0..coordinates)
        .map(|i| MARGIN * short.iter().map(|trial| trial.errors[i]).fold(0.0, larger_or_nan))
        .collect();
    let is_noise = |trial: &Trial| {
        trial.misfit <= LARGEST && trial.errors.iter().zip(&noise).all(|(error, noise)| error <= noise)
    };
    let first = trials.iter().position(is_noise)?;
    (trials.len() - first >= 2 * SHORT).then(|| trials[first].end)
}

/// The size of a velocity in a step, from its first coefficients and its gain if the final
/// acceleration lasted; with zero as the zeroth coefficient, the distance that a coordinate covers.
#[inline(always)]
fn size_of([zeroth, first, second]: [f64; 3], gain: f64, units: f64, floor: f64) -> f64 {
    let change = larger((first + second * units) * units, gain);
    larger(larger(zeroth, change), floor)
}

/// The ratio of a change to a size; zero for no change, even of no size.
#[inline(always)]
fn part_of(change: f64, size: f64) -> f64 {
    if change == 0.0 { 0.0 } else { change / size }
}

/// The results at the ends of the steps of all lanes.
struct Trials<const N: usize> {
    misfits: [f64; N],
    /// `true` if all forces inside the steps have an effect at their ends.
    is_seen: bool,
}

/// Computes the states at the ends of the steps, and the errors there.
struct StepTrials<'f, 'a, const N: usize> {
    stepper: &'f mut Stepper<'a, N>,
}

impl<const N: usize> Kernel for StepTrials<'_, '_, N> {
    type Output = Trials<N>;

    #[inline(always)]
    fn run(self) -> Trials<N> {
        StepEnds { stepper: &mut *self.stepper }.run();
        let Stepper { expander, block, scratch, surroundings, next, effort, allowances, .. } = self.stepper;
        scratch.start = block.end;
        for (number, ends) in next.iter().enumerate() {
            let row = scratch.row(number);
            scratch[row][0] = ends.high;
        }
        expander.begin(scratch, surroundings);
        let mut misfits = [0.0; N];
        let layout = expander.system.layout();
        let length: [f64; N] = lanes(|lane| (block.end[lane] - block.start[lane]).abs());
        let units: [f64; N] = lanes(|lane| (block.end[lane] - block.start[lane]) / block.unit[lane]);
        for i in 0..layout.coordinates() {
            let driven = layout.driven(i);
            let is_velocity = layout.is_velocity(driven);
            let series = block.series(driven);
            let slope = sum(&block[expander.acceleration(i)][..expander.plan.order], &units);
            let exact = &scratch[expander.acceleration(i)][0];
            let floor = effort.absolute / allowances[i].relative;
            misfits = lanes(|lane| {
                let held = if is_velocity { series[0][lane].abs() } else { 0.0 };
                let first = [held, series[1][lane].abs(), series[2][lane].abs()];
                let size = size_of(first, (slope[lane] * length[lane]).abs(), units[lane].abs(), floor);
                let error = (exact[lane] - slope[lane]).abs();
                larger_or_nan(misfits[lane], part_of(error * length[lane], size) * allowances[i].weight)
            });
        }
        let mut is_seen = true;
        for steep in &expander.plan.steep {
            is_seen &= steep.is_seen(block, &units);
        }
        Trials { misfits, is_seen }
    }
}

/// The sums of series after these times, in units of the block.
#[inline(always)]
fn sum<const N: usize>(series: &[[f64; N]], units: &[f64; N]) -> [f64; N] {
    let higher = higher(series.len(), |n| series[n], units);
    lanes(|lane| (series[1][lane] + higher[lane]).fma(units[lane], series[0][lane]))
}
