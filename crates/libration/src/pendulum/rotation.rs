//! Rotation: θ = ±2 am(u, κ) and θ′ = ±2ω0√e dn(u, κ), with u = √e ω0t + u0 and κ² = 1/e.

use super::motion::Start;
use super::state::{DoubledArctangent, State, unwrapped, whole_turns};
use crate::dispatch::{Kernel, dispatch};
use crate::double_double::DoubleDouble;
use crate::elliptic::{Expansion, Modulus, Phase, PhaseClock, ThetaSeries, ThetaValues, ThetaZero, first_of_point};

/// A rotation, prepared for evaluation at any time.
#[derive(Clone, Copy, Debug)]
pub struct Rotation {
    /// √e·ω0.
    speed: DoubleDouble,
    /// e − 1.
    excess: DoubleDouble,
    modulus: Modulus,
    orbit: Orbit,
}

/// What the evaluation at a time needs.
#[derive(Clone, Copy, Debug)]
struct Orbit {
    expansion: Expansion,
    clock: PhaseClock,
    /// z of the theta functions per turn of 4K.
    scale: DoubleDouble,
    series: ThetaSeries,
    /// Factors of tan(θ/2 from the quarter) and of the velocity next to an even quarter, then an odd one.
    tangent: [f64; 2],
    velocity: [f64; 2],
    direction: f64,
    turns: i64,
    base: DoubleDouble,
}

impl Rotation {
    /// The rotation through this state, with e − 1 given.
    pub(super) fn through(angular_frequency: DoubleDouble, start: &Start, excess: DoubleDouble) -> Self {
        let root_energy = (excess + 1.0).sqrt();
        let modulus = Modulus::from_words(root_energy.recip(), excess.sqrt() / root_energy);
        let speed = root_energy * angular_frequency;
        let direction = if start.velocity.hi < 0.0 { -1.0 } else { 1.0 };
        let ahead = if (start.sine.hi < 0.0) == (start.velocity.hi < 0.0) { 1.0 } else { -1.0 };
        let delta = start.velocity.abs() / root_energy;
        let gone = first_of_point(start.sine.abs(), start.cosine, delta) / modulus.first_words().scaled(4.0);
        let clock =
            PhaseClock { frequency: speed / modulus.first_words().scaled(4.0), offset: gone.scaled(ahead) };
        Self { speed, excess, modulus, orbit: Orbit::new(speed, &modulus, clock, direction, start) }
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
        self.orbit.direction
    }

    pub(super) fn energy_ratio(&self) -> f64 {
        (self.excess + 1.0).to_f64()
    }

    pub(super) fn energy_excess(&self) -> f64 {
        self.excess.to_f64()
    }

    /// (4ω0√e/π)·E.
    pub(super) fn action(&self) -> f64 {
        (self.modulus.second_words() * self.speed.scaled(4.0) / DoubleDouble::PI).to_f64()
    }

    /// √e·ω0 and the turns of 4K (two turns of the pendulum) gone at t = 0 since the passage of the bottom.
    pub(super) fn speed_and_clock(&self) -> (DoubleDouble, PhaseClock) {
        (self.speed, self.orbit.clock)
    }

    pub(super) fn state_at(&self, time: f64) -> State {
        dispatch(One(&self.orbit, time))
    }

    pub(super) fn states_at(&self, times: &[f64], angles: &mut [f64], velocities: &mut [f64]) {
        dispatch(Each { orbit: &self.orbit, times, angles, velocities });
    }
}

impl Orbit {
    fn new(
        speed: DoubleDouble,
        modulus: &Modulus,
        clock: PhaseClock,
        direction: f64,
        start: &Start,
    ) -> Self {
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
        Self {
            expansion: modulus.expansion(),
            clock,
            scale: modulus.turn_scale(),
            series: ThetaSeries::new(root.square().to_f64()),
            tangent: tangent.map(DoubleDouble::to_f64),
            velocity: velocity.map(DoubleDouble::to_f64),
            direction,
            turns: start.angle.turns(),
            base: start.base(),
        }
    }

    #[inline(always)]
    fn values(&self, phase: &Phase) -> ThetaValues {
        match self.expansion {
            Expansion::Circular => self.series.circular(phase.rest),
            Expansion::Hyperbolic => self.series.hyperbolic(phase.rest * self.scale),
        }
    }

    /// With a, b, c, d for θ₁ … θ₄ at the nearest quarter, the tangent of half the angle from that quarter is
    /// proportional to a/b in the circular expansion, a/d in the hyperbolic, and θ′ to c/d, c/b next to an
    /// even quarter, to d/c, b/c next to an odd one.
    #[inline(always)]
    fn turn(&self, phase: &Phase, values: &ThetaValues) -> Turn {
        let ThetaValues { first, second, third, fourth } = *values;
        let (beside, other) = match self.expansion {
            Expansion::Circular => (second, fourth),
            Expansion::Hyperbolic => (fourth, second),
        };
        let odd = phase.is_odd();
        let tangent = first * if odd { self.tangent[1] } else { self.tangent[0] };
        let factor = if odd { self.velocity[1] } else { self.velocity[0] };
        let (above, below) = if odd { (other, third) } else { (third, other) };
        Turn {
            half_turns: phase.turns.mul_add(4.0, phase.quarter),
            sign: 1f64.copysign(tangent),
            numerator: tangent.abs(),
            denominator: beside,
            velocity: factor * above / below,
        }
    }

    /// The unwrapped angle: half turns gone and twice the angle from the nearest.
    #[inline(always)]
    fn angle(&self, turn: &Turn, from_quarter: DoubleDouble) -> f64 {
        let whole = DoubleDouble::PI * (turn.half_turns * self.direction);
        unwrapped(whole + self.base, turn.sign * self.direction, from_quarter)
    }
}

/// Half turns to the nearest quarter of 4K, the tangent of half the angle from there, and θ′.
struct Turn {
    half_turns: f64,
    sign: f64,
    numerator: f64,
    denominator: f64,
    velocity: f64,
}

struct One<'a>(&'a Orbit, f64);

impl Kernel for One<'_> {
    type Output = State;
    #[inline(always)]
    fn run(self) -> State {
        let Self(orbit, time) = self;
        let phase = orbit.clock.phase(time);
        let turn = orbit.turn(&phase, &orbit.values(&phase));
        let half = DoubledArctangent::of(turn.numerator, turn.denominator);
        let odd = phase.is_odd();
        // Next to the top the turn is the one on whose side of it the pendulum is.
        let turns = if odd { 0.5 * (turn.half_turns + turn.sign) } else { 0.5 * turn.half_turns };
        let (in_turn, complement) =
            if odd { (half.complement.to_f64() * -turn.sign, half.angle) } else { (half.angle.to_f64() * turn.sign, half.complement) };
        State {
            turns: orbit.turns.saturating_add(whole_turns(turns * orbit.direction)),
            angle_in_turn: orbit.direction * in_turn,
            complement: complement.to_f64(),
            angle: orbit.angle(&turn, half.angle),
            velocity: turn.velocity,
        }
    }
}

struct Each<'a> {
    orbit: &'a Orbit,
    times: &'a [f64],
    angles: &'a mut [f64],
    velocities: &'a mut [f64],
}

impl Kernel for Each<'_> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let orbit = self.orbit;
        for ((time, angle), velocity) in self.times.iter().zip(self.angles).zip(self.velocities) {
            let phase = orbit.clock.phase(*time);
            let turn = orbit.turn(&phase, &orbit.values(&phase));
            let half = DoubledArctangent::of(turn.numerator, turn.denominator);
            *angle = orbit.angle(&turn, half.angle);
            *velocity = turn.velocity;
        }
    }
}
