//! Rotation: θ = ±2 am(u, κ) and θ′ = ±2ω0√e dn(u, κ), with u = √e ω0t + u0 and κ² = 1/e.

use super::orbit::{Orbit, Quotients};
use super::start::Start;
use super::state::{DoubledArctangent, State, unwrapped, whole_turns};
use libration_kernels::double_double::{DoubleDouble, magnitude, pick};
use libration_kernels::fused::FusedMultiplyAdd;
use libration_kernels::{
    elliptic::Modulus,
    internals::elliptic::{
        Expansion, Phase, PhaseClock, Side, ThetaSeries, ThetaValues, ThetaZero, quotient, scaled_by,
    },
};

/// A rotation, prepared for evaluation at any time.
#[derive(Clone, Copy, Debug)]
pub struct Rotation {
    /// √e·ω0.
    speed: DoubleDouble,
    /// e − 1.
    excess: DoubleDouble,
    modulus: Modulus,
    orbit: Orbit<TurnQuotients>,
}

/// Factors of tan(θ/2), counted from the nearest quarter, and of the velocity, first next to an even quarter, then next to an odd one; and the
/// turn at t = 0.
#[derive(Clone, Copy, Debug)]
struct TurnQuotients {
    tangent: [DoubleDouble; 2],
    velocity: [DoubleDouble; 2],
    direction: f64,
    turns: i64,
    base: DoubleDouble,
}

impl Rotation {
    /// The rotation through this state, given √(e − 1).
    pub(super) fn through(angular_frequency: DoubleDouble, start: &Start, root: DoubleDouble) -> Self {
        let excess = root.square();
        let root_energy = (excess + 1.0).sqrt();
        let modulus = Modulus::from_words(root_energy.recip(), root / root_energy);
        let speed = root_energy * angular_frequency;
        let direction = if start.velocity.hi < 0.0 { -1.0 } else { 1.0 };
        let first = modulus.first_words();
        let point = [start.sine.scaled(direction), start.cosine, start.velocity.abs() / root_energy];
        let complementary = modulus.complementary_words();
        let clock = PhaseClock::through(point, complementary, first, speed / first.scaled(4.0));
        Self { speed, excess, modulus, orbit: orbit(speed, &modulus, clock, direction, start) }
    }

    /// The time of a turn in seconds.
    #[must_use]
    pub fn period(&self) -> f64 {
        (self.modulus.first_words().scaled(2.0) / self.speed).to_f64()
    }

    /// The modulus κ = 1/√e.
    #[must_use]
    pub fn modulus(&self) -> Modulus {
        self.modulus
    }

    /// 1 for increasing angles, −1 for decreasing.
    #[must_use]
    pub fn direction(&self) -> f64 {
        self.orbit.quotients.direction
    }

    pub(super) fn energy_ratio(&self) -> f64 {
        (self.excess + 1.0).to_f64()
    }

    pub(super) fn energy_excess(&self) -> f64 {
        self.excess.to_f64()
    }

    /// 2ω0²e.
    pub(super) fn specific_energy(&self) -> f64 {
        2.0 * self.speed.square_to_f64()
    }

    /// (4ω0√e/π)·E.
    pub(super) fn action(&self) -> f64 {
        (self.modulus.second_words() * self.speed.scaled(4.0) / DoubleDouble::PI).to_f64()
    }

    /// The phase in turns of 4K, which are two turns of the pendulum, since a passage of the bottom.
    pub(super) fn clock(&self) -> PhaseClock {
        self.orbit.clock
    }

    /// √e·ω0.
    pub(super) fn speed(&self) -> DoubleDouble {
        self.speed
    }

    /// The turn of the initial angle, and the angle at its bottom.
    pub(super) fn start_of_turn(&self) -> (i64, DoubleDouble) {
        (self.orbit.quotients.turns, self.orbit.quotients.base)
    }

    pub(super) fn state_at(&self, time: f64) -> State {
        self.orbit.state_at(time)
    }

    pub(super) fn states_at(&self, times: &[f64], angles: &mut [f64], velocities: &mut [f64]) {
        self.orbit.states_at(times, angles, velocities);
    }
}

fn orbit(
    speed: DoubleDouble,
    modulus: &Modulus,
    clock: PhaseClock,
    direction: f64,
    start: &Start,
) -> Orbit<TurnQuotients> {
    let root = modulus.root_of_smaller_nome();
    let ThetaZero { second, third, fourth } = ThetaZero::in_two_words(root.square());
    let twice = speed.scaled(2.0 * direction);
    let (tangent, velocity) = match modulus.expansion() {
        Expansion::Circular => ([third / fourth, fourth / third], [twice * fourth / third; 2]),
        Expansion::Hyperbolic => {
            let (ratio, small) = (second / third, root.scaled(4.0));
            ([ratio.recip(), small * ratio], [twice * ratio, twice * small * ratio])
        }
    };
    Orbit {
        expansion: modulus.expansion(),
        clock,
        scale: modulus.turn_scale(),
        series: ThetaSeries::new(root.square().to_f64()),
        quotients: TurnQuotients {
            tangent,
            velocity,
            direction,
            turns: start.angle.turns(),
            base: start.base(),
        },
    }
}

/// Half turns to the nearest quarter of 4K, the angle from there as a doubled arctangent with its sign, and θ′.
struct Turn {
    half_turns: f64,
    half: DoubledArctangent,
    sign: f64,
    velocity: f64,
}

impl TurnQuotients {
    /// The turn from the theta values a, b, c, d for θ₁ … θ₄ at the nearest quarter. The tangent of half the angle from that quarter is
    /// proportional to a/b in the circular expansion and to a/d in the hyperbolic one; θ′ is proportional to c/d or c/b next to an even quarter,
    /// to d/c or b/c next to an odd one.
    #[inline(always)]
    fn turn<S: Side>(&self, phase: &Phase, values: &ThetaValues) -> Turn {
        let (beside, other) = S::beside(values);
        let ThetaValues { first, third, .. } = *values;
        let odd = phase.is_odd();
        let tangent = scaled_by(pick(odd, self.tangent[1], self.tangent[0]), first);
        let speed = pick(odd, self.velocity[1], self.velocity[0]);
        Turn {
            half_turns: phase.turns.fma(4.0, phase.quarter),
            half: DoubledArctangent::from_quotient(magnitude(tangent), beside),
            sign: 1f64.copysign(tangent.hi),
            velocity: quotient(speed, pick(odd, other, third), pick(odd, third, other)),
        }
    }

    /// The unwrapped angle.
    #[inline(always)]
    fn angle(&self, turn: &Turn) -> f64 {
        let half_turns = turn.half_turns * self.direction;
        let whole = DoubleDouble::PI * half_turns;
        // If the position in the turn is not known, the whole turns are the angle to its last bit.
        let in_turn = pick(turn.half.angle.hi.is_nan(), DoubleDouble::ZERO, turn.half.angle);
        let angle = unwrapped(whole + self.base, turn.sign * self.direction, in_turn);
        // Infinite beyond the range of numbers, where the words would cancel to NaN.
        let rough = DoubleDouble::PI.hi * half_turns;
        if rough.is_infinite() { rough } else { angle }
    }
}

impl Quotients for TurnQuotients {
    #[inline(always)]
    fn angle_and_velocity<S: Side>(&self, phase: &Phase, values: &ThetaValues) -> (f64, f64) {
        let turn = self.turn::<S>(phase, values);
        (self.angle(&turn), turn.velocity)
    }

    #[inline(always)]
    fn state<S: Side>(&self, phase: &Phase, values: &ThetaValues) -> State {
        let turn = self.turn::<S>(phase, values);
        let half = turn.half;
        // Next to the top, the side on which the pendulum is decides the turn.
        let (turns, in_turn, complement) = if phase.is_odd() {
            (0.5 * (turn.half_turns + turn.sign), -turn.sign * half.complement.to_f64(), half.angle)
        } else {
            (0.5 * turn.half_turns, turn.sign * half.angle.to_f64(), half.complement)
        };
        State {
            turns: self.turns.saturating_add(whole_turns(turns * self.direction)),
            angle_in_turn: self.direction * in_turn,
            complement: complement.to_f64(),
            angle: self.angle(&turn),
            velocity: turn.velocity,
        }
    }
}
