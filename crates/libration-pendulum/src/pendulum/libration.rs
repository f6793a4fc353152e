//! Libration: tan(θ/2) = k sd u and θ′ = 2ω0k cn u, with u = ω0t + u0 and k = sin(θ0/2).

use super::Amplitude;
use super::orbit::{Orbit, Quotients};
use super::start::Start;
use super::state::{DoubledArctangent, State, unwrapped};
use libration_kernels::double_double::{DoubleDouble, magnitude, pick};
use libration_kernels::{
    elliptic::Modulus,
    internals::elliptic::{
        Expansion, Phase, PhaseClock, Side, ThetaSeries, ThetaValues, ThetaZero, quotient, scaled_by,
    },
};

/// A libration, prepared for evaluation at any time.
#[derive(Clone, Copy, Debug)]
pub struct Libration {
    angular_frequency: DoubleDouble,
    modulus: Modulus,
    orbit: Orbit<SwingQuotients>,
}

/// Factors of tan(θ/2) and of the velocity, first next to an even quarter, then next to an odd one; and the turn.
#[derive(Clone, Copy, Debug)]
struct SwingQuotients {
    tangent: [DoubleDouble; 2],
    velocity: [DoubleDouble; 2],
    turns: i64,
    base: DoubleDouble,
}

impl Libration {
    /// The libration through this state, given k′ = √(1 − e).
    pub(super) fn through(
        angular_frequency: DoubleDouble,
        start: &Start,
        complementary: DoubleDouble,
    ) -> Self {
        let k = hypotenuse(start.sine, start.velocity);
        let modulus = Modulus::from_words(k, complementary);
        let first = modulus.first_words();
        let point = [start.sine / k, start.velocity / k, start.cosine];
        let clock = PhaseClock::through(point, complementary, first, angular_frequency / first.scaled(4.0));
        Self { angular_frequency, modulus, orbit: orbit(angular_frequency, &modulus, clock, start) }
    }

    /// The period in seconds.
    #[must_use]
    pub fn period(&self) -> f64 {
        (self.modulus.first_words().scaled(4.0) / self.angular_frequency).to_f64()
    }

    /// The amplitude.
    #[must_use]
    pub fn amplitude(&self) -> Amplitude {
        Amplitude::from_half_angle(self.modulus.modulus_words(), self.modulus.complementary_words())
    }

    /// The modulus k = sin(θ0/2).
    #[must_use]
    pub fn modulus(&self) -> Modulus {
        self.modulus
    }

    pub(super) fn energy_ratio(&self) -> f64 {
        self.modulus.modulus_words().square_to_f64()
    }

    pub(super) fn energy_excess(&self) -> f64 {
        -self.modulus.complementary_words().square_to_f64()
    }

    /// 2ω0²e.
    pub(super) fn specific_energy(&self) -> f64 {
        2.0 * (self.angular_frequency * self.modulus.modulus_words()).square_to_f64()
    }

    /// (8ω0/π)·(E − k′²K).
    pub(super) fn action(&self) -> f64 {
        let k = self.modulus.modulus_words();
        let part = self.modulus.cosine_part().scaled(8.0) / DoubleDouble::PI;
        // The square of k is avoided: it may underflow where the action does not.
        (self.angular_frequency * k * part * k).to_f64()
    }

    pub(super) fn angular_frequency(&self) -> DoubleDouble {
        self.angular_frequency
    }

    /// The phase in turns of 4K since an upward passage of the bottom.
    pub(super) fn clock(&self) -> PhaseClock {
        self.orbit.clock
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

/// √(x² + y²) without underflow.
fn hypotenuse(x: DoubleDouble, y: DoubleDouble) -> DoubleDouble {
    let (x, y) = (x.abs(), y.abs());
    let (large, small) = if x.hi > y.hi { (x, y) } else { (y, x) };
    large * (DoubleDouble::ONE + (small / large).square()).sqrt()
}

fn orbit(
    angular_frequency: DoubleDouble,
    modulus: &Modulus,
    clock: PhaseClock,
    start: &Start,
) -> Orbit<SwingQuotients> {
    let root = modulus.root_of_smaller_nome();
    let ThetaZero { second, third, fourth } = ThetaZero::in_two_words(root.square());
    let small = root.scaled(4.0);
    let speed = angular_frequency.scaled(2.0) * second * fourth / third.square();
    let slow = speed * small;
    let (tangent, velocity) = match modulus.expansion() {
        Expansion::Circular => ([small * second / fourth; 2], [slow; 2]),
        Expansion::Hyperbolic => ([fourth / second, fourth / (small * second)], [speed, slow]),
    };
    Orbit {
        expansion: modulus.expansion(),
        clock,
        scale: modulus.turn_scale(),
        series: ThetaSeries::new(root.square().to_f64()),
        quotients: SwingQuotients { tangent, velocity, turns: start.angle.turns(), base: start.base() },
    }
}

/// |θ| in the turn as a doubled arctangent, the sign of θ, and θ′.
struct SwingState {
    half: DoubledArctangent,
    sign: f64,
    velocity: f64,
}

impl SwingQuotients {
    /// The swing from the theta values a, b, c, d for θ₁ … θ₄ at the nearest quarter, with B = b/d in the circular expansion and B = d/b in the
    /// hyperbolic one: next to an even quarter tan(θ/2) ∝ a/c and θ′ ∝ B, next to an odd quarter tan(θ/2) ∝ B and θ′ ∝ −a/c.
    #[inline(always)]
    fn swing<S: Side>(&self, phase: &Phase, values: &ThetaValues) -> SwingState {
        let (above, below) = S::beside(values);
        let ThetaValues { first, third, .. } = *values;
        let odd = phase.is_odd();
        let sign = phase.sign();
        let factor = pick(odd, self.tangent[1], self.tangent[0]);
        let tangent = scaled_by(factor, pick(odd, above, first));
        let speed = pick(odd, self.velocity[1], self.velocity[0]);
        SwingState {
            half: DoubledArctangent::from_quotient(magnitude(tangent), pick(odd, below, third)),
            sign: 1f64.copysign(sign * tangent.hi),
            velocity: sign * quotient(speed, pick(odd, -first, above), pick(odd, third, below)),
        }
    }
}

impl Quotients for SwingQuotients {
    #[inline(always)]
    fn angle_and_velocity<S: Side>(&self, phase: &Phase, values: &ThetaValues) -> (f64, f64) {
        let swing = self.swing::<S>(phase, values);
        (unwrapped(self.base, swing.sign, swing.half.angle), swing.velocity)
    }

    #[inline(always)]
    fn state<S: Side>(&self, phase: &Phase, values: &ThetaValues) -> State {
        let swing = self.swing::<S>(phase, values);
        State {
            turns: self.turns,
            angle_in_turn: swing.sign * swing.half.angle.to_f64(),
            complement: swing.half.complement.to_f64(),
            angle: unwrapped(self.base, swing.sign, swing.half.angle),
            velocity: swing.velocity,
        }
    }
}
