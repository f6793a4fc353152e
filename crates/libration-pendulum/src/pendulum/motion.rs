//! Motions: a pendulum with an initial state, sorted by regime and prepared for evaluation at any time.

use std::cmp::Ordering;

use super::amplitude::half_angle;
use super::initial::{Separation, separation};
use super::start::Start;
use super::state::State;
use super::{Amplitude, LengthMismatch, Libration, Pendulum, PendulumError, Rotation, Separatrix, finite};
use libration_kernels::double_double::DoubleDouble;
use libration_numbers::quantity::Angle;

/// Largest |θ′|/2ω0; its square is the energy ratio.
const FASTEST: f64 = 1e150;

/// Largest velocity in rad/s, which leaves room for the factors of intermediate results.
const LARGEST_VELOCITY: f64 = 1e307;

/// Complement below which its half would be subnormal, and rounded.
const SMALLEST_COMPLEMENT: f64 = 2.0 * f64::MIN_POSITIVE;

/// A motion of the pendulum.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Motion {
    /// No motion, at the bottom or upright.
    Rest(Rest),
    /// Swinging to and fro below the upright position.
    Libration(Libration),
    /// Approaching the upright position for ever.
    Separatrix(Separatrix),
    /// Turning over and over.
    Rotation(Rotation),
}

/// A pendulum at rest.
#[derive(Clone, Copy, Debug)]
pub struct Rest {
    angle: Angle,
    angular_frequency: DoubleDouble,
}

/// The kind of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Regime {
    /// Rest at the bottom.
    RestStable,
    /// Rest in the upright position.
    RestUpright,
    /// Swinging to and fro.
    Libration,
    /// Motion on the separatrix.
    Separatrix,
    /// Turning over and over.
    Rotation,
}

impl std::fmt::Display for Regime {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::RestStable => "rest (stable)",
            Self::RestUpright => "rest (upright)",
            Self::Libration => "libration",
            Self::Separatrix => "separatrix",
            Self::Rotation => "rotation",
        })
    }
}

impl Pendulum {
    /// The motion released at rest from this angle at t = 0; released from exactly ±π, the pendulum stays upright.
    ///
    /// # Errors
    /// As [`Self::launched`], with velocity zero.
    pub fn released_from(&self, angle: Angle) -> Result<Motion, PendulumError> {
        self.launched(angle, 0.0)
    }

    /// The motion that passes this angle with this velocity in rad/s at t = 0. The input is taken as exact, with one exception: a velocity below
    /// 4.4e-308·ω0 counts as zero, and the pendulum is at rest if the angle is below 4.4e-308 too. The separatrix is met only if l·θ′² =
    /// 4g·cos²(θ/2) exactly, which needs θ = 0 (or whole turns).
    ///
    /// # Errors
    /// A velocity that is not finite, above 2e150·ω0 or above 1e307 rad/s; an energy closer to the separatrix than `f64` can distinguish, which
    /// is possible only next to the upright position; an angle within 4.4e-308 of the upright position.
    pub fn launched(&self, angle: Angle, velocity: f64) -> Result<Motion, PendulumError> {
        finite("velocity", velocity)?;
        if angle.complement() > 0.0 && angle.complement() < SMALLEST_COMPLEMENT {
            return Err(PendulumError::TooCloseToTop(angle.complement()));
        }
        let angular_frequency = self.angular_frequency_words();
        let (sine, cosine) = half_angle(&angle);
        let scaled_velocity = self.in_units_of_twice_the_frequency(velocity);
        let speed = scaled_velocity.abs();
        if speed.hi > FASTEST || velocity.abs() > LARGEST_VELOCITY {
            return Err(PendulumError::TooFast(velocity));
        }
        let still = speed.hi < f64::MIN_POSITIVE;
        if still && (sine.hi.abs() < f64::MIN_POSITIVE || cosine.hi == 0.0) {
            return Ok(Motion::Rest(Rest { angle, angular_frequency }));
        }
        let start =
            Start { angle, sine, cosine, velocity: if still { DoubleDouble::ZERO } else { scaled_velocity } };
        let separation = if still {
            Separation { energy: Ordering::Less, root: cosine }
        } else {
            separation(&angle, cosine, velocity, speed, self.size)
                .ok_or(PendulumError::TooCloseToSeparatrix)?
        };
        Ok(start.motion(angular_frequency, &separation))
    }

    /// The motion with energy ratio e = E/(2mgl), exactly this `f64`, that passes the bottom with positive
    /// velocity at t = 0; e = 1 is the separatrix.
    ///
    /// # Errors
    /// e negative or not finite, above 1e300, or so large that the velocity is above 1e307 rad/s.
    pub fn with_energy_ratio(&self, energy_ratio: f64) -> Result<Motion, PendulumError> {
        finite("energy ratio", energy_ratio)?;
        if energy_ratio < 0.0 {
            return Err(PendulumError::NegativeEnergy(energy_ratio));
        }
        self.reaches(energy_ratio)?;
        let energy = DoubleDouble::from(energy_ratio);
        Ok(self.passing_the_bottom(energy, energy - 1.0))
    }

    /// The motion with energy ratio e = 1 + excess that passes the bottom with positive velocity at t = 0, for
    /// an excess exactly this `f64`, however close to the separatrix.
    ///
    /// # Errors
    /// An excess below −1 or not finite, or too large, as for [`Self::with_energy_ratio`].
    pub fn with_energy_excess(&self, excess: f64) -> Result<Motion, PendulumError> {
        finite("energy excess", excess)?;
        if excess < -1.0 {
            return Err(PendulumError::NegativeEnergy(1.0 + excess));
        }
        self.reaches(1.0 + excess)?;
        let excess = DoubleDouble::from(excess);
        Ok(self.passing_the_bottom(excess + 1.0, excess))
    }

    /// The motion on the separatrix that passes the bottom with positive velocity at t = 0.
    #[must_use]
    pub fn on_separatrix(&self) -> Motion {
        self.passing_the_bottom(DoubleDouble::ONE, DoubleDouble::ZERO)
    }

    /// θ′/2ω0, scaled by a power of two so that its second word does not underflow for extreme frequencies.
    fn in_units_of_twice_the_frequency(&self, velocity: f64) -> DoubleDouble {
        let frequency = self.angular_frequency_words();
        let (_, exponent) = libm::frexp(frequency.hi);
        let scaled = DoubleDouble::from(velocity).times_power_of_two(-exponent - 1);
        scaled / frequency.times_power_of_two(-exponent)
    }

    /// Checks that the velocity of an energy ratio is within the range of numbers.
    fn reaches(&self, energy_ratio: f64) -> Result<(), PendulumError> {
        let speed = libm::sqrt(energy_ratio);
        if speed > FASTEST || 2.0 * self.angular_frequency() * speed > LARGEST_VELOCITY {
            return Err(PendulumError::TooMuchEnergy(energy_ratio));
        }
        Ok(())
    }

    fn passing_the_bottom(&self, energy: DoubleDouble, excess: DoubleDouble) -> Motion {
        let angular_frequency = self.angular_frequency_words();
        let bottom = Angle::from_parts(0, DoubleDouble::ZERO, DoubleDouble::PI);
        let start = Start {
            angle: bottom,
            sine: DoubleDouble::ZERO,
            cosine: DoubleDouble::ONE,
            velocity: energy.sqrt(),
        };
        if energy.hi == 0.0 {
            return Motion::Rest(Rest { angle: bottom, angular_frequency });
        }
        let energy = excess.hi.partial_cmp(&0.0).unwrap_or(Ordering::Equal);
        start.motion(angular_frequency, &Separation { energy, root: excess.abs().sqrt() })
    }
}

impl Start {
    fn motion(&self, angular_frequency: DoubleDouble, separation: &Separation) -> Motion {
        match separation.energy {
            Ordering::Less => Motion::Libration(Libration::through(angular_frequency, self, separation.root)),
            Ordering::Equal => Motion::Separatrix(Separatrix::through(angular_frequency, self)),
            Ordering::Greater => {
                Motion::Rotation(Rotation::through(angular_frequency, self, separation.root))
            }
        }
    }
}

impl Motion {
    /// The regime of the motion.
    #[must_use]
    pub fn regime(&self) -> Regime {
        match self {
            Self::Rest(rest) if rest.angle.complement() == 0.0 => Regime::RestUpright,
            Self::Rest(_) => Regime::RestStable,
            Self::Libration(_) => Regime::Libration,
            Self::Separatrix(_) => Regime::Separatrix,
            Self::Rotation(_) => Regime::Rotation,
        }
    }

    /// The period in seconds of a libration, the time of a turn of a rotation, ∞ on the separatrix; at rest
    /// the period of the smallest swings, NaN upright.
    #[must_use]
    pub fn period(&self) -> f64 {
        match self {
            Self::Rest(rest) => rest.period(),
            Self::Libration(libration) => libration.period(),
            Self::Separatrix(_) => f64::INFINITY,
            Self::Rotation(rotation) => rotation.period(),
        }
    }

    /// e = E/(2mgl), the energy counted from the bottom: 0 at stable rest, 1 on the separatrix.
    #[must_use]
    pub fn energy_ratio(&self) -> f64 {
        match self {
            Self::Rest(rest) => rest.energy_ratio(),
            Self::Libration(libration) => libration.energy_ratio(),
            Self::Separatrix(_) => 1.0,
            Self::Rotation(rotation) => rotation.energy_ratio(),
        }
    }

    /// e − 1, relatively accurate next to the separatrix.
    #[must_use]
    pub fn energy_excess(&self) -> f64 {
        match self {
            Self::Rest(rest) => rest.energy_ratio() - 1.0,
            Self::Libration(libration) => libration.energy_excess(),
            Self::Separatrix(_) => 0.0,
            Self::Rotation(rotation) => rotation.energy_excess(),
        }
    }

    /// E/(m·l²) in rad²/s², counted from the bottom: 2ω0²e; ∞ or 0 where that is beyond the range of `f64`.
    #[must_use]
    pub fn specific_energy(&self) -> f64 {
        match self {
            Self::Rest(rest) => rest.specific_energy(),
            Self::Libration(libration) => libration.specific_energy(),
            Self::Separatrix(separatrix) => separatrix.specific_energy(),
            Self::Rotation(rotation) => rotation.specific_energy(),
        }
    }

    /// The amplitude of a libration; `None` in other regimes.
    #[must_use]
    pub fn amplitude(&self) -> Option<Amplitude> {
        match self {
            Self::Libration(libration) => Some(libration.amplitude()),
            _ => None,
        }
    }

    /// The action ∮p dθ/2π per m·l², in rad²/s: over a period of a libration, over a turn of a rotation or of the separatrix. It is 0 if below
    /// the range of `f64`.
    #[must_use]
    pub fn action(&self) -> f64 {
        match self {
            Self::Rest(_) => 0.0,
            Self::Libration(libration) => libration.action(),
            Self::Separatrix(separatrix) => separatrix.action(),
            Self::Rotation(rotation) => rotation.action(),
        }
    }

    /// The state at this time in seconds; NaN for a time that is not finite.
    ///
    /// From 2⁹⁷ periods (1.6e29) of a libration, or twice as many turns of a rotation, the two words of the frequency leave an eighth of a
    /// period undetermined. The state is then NaN, except the unwrapped angle and the turns of a rotation, which grow with the time. That angle
    /// is ∞ beyond the range of `f64`.
    ///
    /// # Accuracy
    /// Up to 1e6 periods 2.2 ulp of the angle and 4·2⁻⁵³·|θ′t|, for an exact initial state; likewise the velocity and the complement (ledger in
    /// `tests/suite/promises.rs`). Beyond, 4 ulp and 2⁻¹⁰⁰·|θ′t|.
    #[must_use]
    pub fn state_at(&self, time: f64) -> State {
        if !time.is_finite() {
            return State::NAN;
        }
        match self {
            Self::Rest(rest) => rest.state(),
            Self::Libration(libration) => libration.state_at(time),
            Self::Separatrix(separatrix) => separatrix.state_at(time),
            Self::Rotation(rotation) => rotation.state_at(time),
        }
    }

    /// The unwrapped angle and the velocity of [`Self::state_at`] at each time, bit for bit.
    ///
    /// # Errors
    /// The slices have different lengths.
    pub fn states_at(
        &self,
        times: &[f64],
        angles: &mut [f64],
        velocities: &mut [f64],
    ) -> Result<(), LengthMismatch> {
        LengthMismatch::check(times, angles)?;
        LengthMismatch::check(times, velocities)?;
        match self {
            Self::Libration(libration) => libration.states_at(times, angles, velocities),
            Self::Rotation(rotation) => rotation.states_at(times, angles, velocities),
            Self::Rest(_) | Self::Separatrix(_) => {
                for (i, time) in times.iter().enumerate() {
                    let state = self.state_at(*time);
                    (angles[i], velocities[i]) = (state.angle, state.velocity);
                }
            }
        }
        Ok(())
    }
}

impl Rest {
    fn state(&self) -> State {
        State {
            turns: self.angle.turns(),
            angle_in_turn: self.angle.in_turn(),
            complement: self.angle.complement(),
            angle: self.angle.radians(),
            velocity: 0.0,
        }
    }

    fn period(&self) -> f64 {
        if self.angle.complement() == 0.0 {
            return f64::NAN;
        }
        (DoubleDouble::PI.scaled(2.0) / self.angular_frequency).to_f64()
    }

    fn specific_energy(&self) -> f64 {
        if self.angle.complement() == 0.0 { 2.0 * self.angular_frequency.square_to_f64() } else { 0.0 }
    }

    fn energy_ratio(&self) -> f64 {
        if self.angle.complement() == 0.0 { 1.0 } else { 0.0 }
    }
}
