//! Common parts of the periodic motions: a phase clock, theta series, and quotients of their values.
//!
//! # Method
//! tan(θ/2) and θ′ are quotients of theta functions of the smaller of the two nomes, q ≤ e^−π, for which four terms suffice. For k ≤ k′ these
//! are series in sines and cosines; for `k > k′` Jacobi's imaginary transformation gives the same polynomials with hyperbolic sines and cosines:
//! one `ThetaSeries`, and two `Side`s that select the pair of functions and the quotients. The argument is first reduced to within an eighth of
//! a turn of the nearest quarter period. Odd quarters exchange the functions, so that no quotient is evaluated where it cancels.
//!
//! The angle is twice an arctangent, and the complement is computed from the same arctangent. Phase, theta values, factors and arctangent are in
//! two words; angle and velocity are each rounded once. On the separatrix the same quotients are hyperbolic functions in closed form.

use std::marker::PhantomData;

use super::state::State;
use libration_kernels::dispatch::{Kernel, dispatch, dispatch_slices};
use libration_kernels::double_double::DoubleDouble;
use libration_kernels::double_double::block::{BLOCK, Words};
use libration_kernels::internals::elliptic::{
    CircularSide, Expansion, HyperbolicSide, Phase, PhaseClock, Side, ThetaSeries, ThetaValues,
};

/// A periodic motion as quotients of theta values.
pub(super) trait Quotients: Copy {
    /// The unwrapped angle and the velocity; `#[inline(always)]`.
    fn angle_and_velocity<S: Side>(&self, phase: &Phase, values: &ThetaValues) -> (f64, f64);
    /// The whole state, with the same angle and velocity; `#[inline(always)]`.
    fn state<S: Side>(&self, phase: &Phase, values: &ThetaValues) -> State;
}

/// A periodic motion, prepared for evaluation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Orbit<Q> {
    pub(super) expansion: Expansion,
    pub(super) clock: PhaseClock,
    /// z of the theta functions for one turn of 4K.
    pub(super) scale: DoubleDouble,
    pub(super) series: ThetaSeries,
    pub(super) quotients: Q,
}

impl<Q: Quotients> Orbit<Q> {
    pub(super) fn state_at(&self, time: f64) -> State {
        match self.expansion {
            Expansion::Circular => dispatch(One { orbit: self, side: PhantomData::<CircularSide>, time }),
            Expansion::Hyperbolic => dispatch(One { orbit: self, side: PhantomData::<HyperbolicSide>, time }),
        }
    }

    /// Computes the states at many times; the slices have equal lengths.
    pub(super) fn states_at(&self, times: &[f64], angles: &mut [f64], velocities: &mut [f64]) {
        match self.expansion {
            Expansion::Circular => {
                dispatch_slices(Each {
                    orbit: self,
                    side: PhantomData::<CircularSide>,
                    times,
                    angles,
                    velocities,
                });
            }
            Expansion::Hyperbolic => {
                dispatch_slices(Each {
                    orbit: self,
                    side: PhantomData::<HyperbolicSide>,
                    times,
                    angles,
                    velocities,
                });
            }
        }
    }
}

struct One<'a, Q, S> {
    orbit: &'a Orbit<Q>,
    side: PhantomData<S>,
    time: f64,
}

impl<Q: Quotients, S: Side> Kernel for One<'_, Q, S> {
    type Output = State;
    #[inline(always)]
    fn run(self) -> State {
        let phase = self.orbit.clock.phase(self.time);
        let values = S::values(&self.orbit.series, phase.rest, self.orbit.scale);
        self.orbit.quotients.state::<S>(&phase, &values)
    }
}

struct Each<'a, Q, S> {
    orbit: &'a Orbit<Q>,
    side: PhantomData<S>,
    times: &'a [f64],
    angles: &'a mut [f64],
    velocities: &'a mut [f64],
}

impl<Q: Quotients, S: Side> Kernel for Each<'_, Q, S> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        // A copy, so that the compiler knows that writing the results cannot change the orbit.
        let orbit = *self.orbit;
        let (times, rest) = self.times.as_chunks::<BLOCK>();
        let (angles, rest_angles) = self.angles.as_chunks_mut::<BLOCK>();
        let (velocities, rest_velocities) = self.velocities.as_chunks_mut::<BLOCK>();
        for ((times, angles), velocities) in times.iter().zip(angles).zip(velocities) {
            orbit.block::<S>(times, angles, velocities);
        }
        for ((time, angle), velocity) in rest.iter().zip(rest_angles).zip(rest_velocities) {
            let phase = orbit.clock.phase(*time);
            let values = S::values(&orbit.series, phase.rest, orbit.scale);
            (*angle, *velocity) = orbit.quotients.angle_and_velocity::<S>(&phase, &values);
        }
    }
}

/// The phases of a block.
#[repr(align(64))]
struct Phases {
    turns: [f64; BLOCK],
    quarter: [f64; BLOCK],
    rest: Words,
}

impl<Q: Quotients> Orbit<Q> {
    #[inline(always)]
    fn block<S: Side>(&self, times: &[f64; BLOCK], angles: &mut [f64; BLOCK], velocities: &mut [f64; BLOCK]) {
        let mut phases = Phases { turns: [0.0; BLOCK], quarter: [0.0; BLOCK], rest: Words::ZERO };
        for (i, time) in times.iter().enumerate() {
            let phase = self.clock.phase(*time);
            (phases.turns[i], phases.quarter[i]) = (phase.turns, phase.quarter);
            phases.rest.set(i, phase.rest);
        }
        let (mut first, mut second) = (Words::ZERO, Words::ZERO);
        let (mut third, mut fourth) = (Words::ZERO, Words::ZERO);
        for i in 0..BLOCK {
            let values = S::values(&self.series, phases.rest.get(i), self.scale);
            first.set(i, values.first);
            second.set(i, values.second);
            third.set(i, values.third);
            fourth.set(i, values.fourth);
        }
        for i in 0..BLOCK {
            let phase =
                Phase { turns: phases.turns[i], quarter: phases.quarter[i], rest: phases.rest.get(i) };
            let values = ThetaValues {
                first: first.get(i),
                second: second.get(i),
                third: third.get(i),
                fourth: fourth.get(i),
            };
            (angles[i], velocities[i]) = self.quotients.angle_and_velocity::<S>(&phase, &values);
        }
    }
}
