//! Motions with their derivatives with respect to the start, in floats of many bits.
//!
//! Series, step sizes and sums are those of `periodic`. The loop over the steps is separate from that of `orbit`, which ends at equilibria,
//! monitors the distance from them and compares each step with double precision.

use super::drive_law::DriveLaw;
use super::error::BranchError;
use super::mirror::Mirror;
use super::space::Space;
use libration_motion::internals::periodic::{precise_series, precise_step, precise_sum};
use libration_motion::taylor::{StateLayout, with_sensitivities};
use libration_numbers::algebra::{BigFloat, Floats, Ring};
use libration_numbers::internals::progress::Watch;
use libration_numbers::{
    expression::{Equation, Symbol},
    internals::expression::Tape,
};

/// Maximum number of steps of one motion.
const MOST_STEPS: usize = 5000;

/// A driven system over one parameter, whose motions are power series in time.
pub(super) struct PreciseFlow<'w> {
    layout: StateLayout,
    all: StateLayout,
    /// The rates of the motion and of its derivatives, as functions of the state, the time and the parameter.
    tape: Tape,
    law: DriveLaw,
    /// The mirror image about zero.
    mirror: &'w Mirror,
    watch: &'w Watch<'w>,
}

/// Image of a state after the time of its space; mirrored if the space has a mirror.
pub(super) struct PreciseImage {
    /// Image minus start.
    pub(super) defect: Vec<BigFloat>,
    /// Derivative of the image with respect to the start, by rows.
    pub(super) map: Vec<Vec<BigFloat>>,
}

impl<'w> PreciseFlow<'w> {
    pub(super) fn new(
        equation: &Equation,
        parameter: &str,
        mirror: &'w Mirror,
        watch: &'w Watch<'w>,
    ) -> Result<Self, BranchError> {
        let layout = StateLayout::new(equation);
        let with_derivatives = with_sensitivities(equation, &[], layout.numbers());
        let all = StateLayout::new(&with_derivatives);
        let mut inputs = all.symbols(with_derivatives.variables());
        inputs.extend([Symbol::plain("t"), Symbol::plain(parameter)]);
        let tape = Tape::new(&with_derivatives.derivatives().iter().collect::<Vec<_>>(), &inputs)?;
        Ok(Self { layout, all, tape, law: DriveLaw::new(equation, &[parameter])?, mirror, watch })
    }

    /// The image of a state, by series to an order; `None` if the motion cannot be integrated.
    pub(super) fn image(
        &self,
        ring: Floats,
        order: u32,
        space: Space,
        [state, parameter]: [&[BigFloat]; 2],
    ) -> Option<PreciseImage> {
        let parameter = parameter.first()?;
        let numbers = self.layout.numbers();
        let address = |number: usize, copy: usize| self.layout.place_in_copy(number, copy, numbers);
        let mut now = vec![ring.zero(); self.all.numbers()];
        for (number, value) in state.iter().enumerate() {
            now[address(number, 0)] = value.clone();
            now[address(number, 1 + number)] = BigFloat::from_integer(1, ring.precision);
        }
        let halves = i64::from(space.half_periods);
        let duration = ring.times_integer(&self.law.precise_period(ring, parameter)?, halves).halved();
        let end = self.end(ring, order, now, [&duration, parameter])?;
        let signed = |number: usize, copy: usize| match space.mirrored && self.mirror.sign(number) < 0.0 {
            true => ring.negate(&end[address(number, copy)]),
            false => end[address(number, copy)].clone(),
        };
        let row = |number: usize| (0..numbers).map(|start| signed(number, 1 + start)).collect();
        let turn = ring.times_integer(&BigFloat::pi(ring.precision), 2);
        let missed = |(number, start): (usize, &BigFloat)| {
            let turned = ring.times_integer(&turn, space.turns_missed(number).into());
            ring.subtract(&ring.subtract(&signed(number, 0), start), &turned)
        };
        Some(PreciseImage {
            defect: state.iter().enumerate().map(missed).collect(),
            map: (0..numbers).map(row).collect(),
        })
    }

    fn end(
        &self,
        ring: Floats,
        order: u32,
        mut now: Vec<BigFloat>,
        [duration, parameter]: [&BigFloat; 2],
    ) -> Option<Vec<BigFloat>> {
        let mut time = ring.zero();
        for _ in 0..MOST_STEPS {
            self.watch.go_on().ok()?;
            let motion = (&self.all, &self.tape);
            let series = precise_series(ring, motion, order, &now, &[(&time, 1), (parameter, 0)])?;
            let left = ring.subtract(duration, &time);
            let size = now.iter().filter_map(BigFloat::exponent).max().unwrap_or(0);
            let length = precise_step(ring.precision, &series, size)?;
            let length = BigFloat::from_f64(length, ring.precision)?;
            let is_last = length >= left;
            let step = if is_last { left } else { length };
            now = series.iter().map(|one| precise_sum(one, &step)).collect();
            if is_last {
                return Some(now);
            }
            time = ring.add(&time, &step);
        }
        None
    }
}
