//! Angle variable, frequency, and derivative of the frequency with respect to the action, in every regime.
//!
//! With J the action, ω(J) = dE/dJ. In libration ω = πω0/2K and J = (8ω0/π)(E − k′²K), in rotation ω = πω0/κK and J = (4ω0/πκ)E, from which
//! dω/dJ follows by dK/dm = (E − m′K)/2mm′ (DLMF 19.4.1). The derivative does not depend on ω0.

use super::{Motion, Regime};
use libration_kernels::double_double::DoubleDouble;
use libration_kernels::internals::elliptic::PhaseClock;
use std::f64::consts::TAU;

impl Motion {
    /// The angular frequency in rad/s: 2π over the period in libration, 2π over the time of a turn in rotation, 0 on the separatrix; at rest
    /// that of the smallest swings at the bottom, NaN upright.
    #[must_use]
    pub fn frequency(&self) -> f64 {
        TAU / self.period()
    }

    /// dω/dJ, the derivative of the frequency with respect to the action per m·l², a pure number: −1/8 for the smallest swings, −∞ on the
    /// separatrix, towards 1 for fast rotation; NaN upright.
    ///
    /// # Accuracy
    /// 2 ulp; infinite where it is beyond the range of `f64`.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_pendulum as libration;
    /// use libration::pendulum::Pendulum;
    /// let pendulum = Pendulum::from_angular_frequency(2.0)?;
    /// let motion = |energy| Ok::<_, libration::pendulum::PendulumError>(pendulum.with_energy_ratio(energy)?);
    /// let (one, next) = (motion(0.5)?, motion(0.5 + 1e-6)?);
    /// let quotient = (next.frequency() - one.frequency()) / (next.action() - one.action());
    /// assert!((quotient / one.frequency_slope() - 1.0).abs() < 1e-5);
    /// # Ok::<(), libration::pendulum::PendulumError>(())
    /// ```
    #[must_use]
    pub fn frequency_slope(&self) -> f64 {
        let pi_squared = DoubleDouble::PI.square();
        match self {
            Self::Rest(_) if self.regime() == Regime::RestUpright => f64::NAN,
            Self::Rest(_) => -0.125,
            Self::Separatrix(_) => f64::NEG_INFINITY,
            Self::Libration(libration) => {
                let modulus = libration.modulus();
                let upper = pi_squared * modulus.cosine_part() / cubed(modulus.first_words());
                -over_square(upper, modulus.complementary_words()) / 16.0
            }
            Self::Rotation(rotation) => {
                let modulus = rotation.modulus();
                let upper = pi_squared * modulus.second_words() / cubed(modulus.first_words());
                over_square(upper, modulus.complementary_words()) / 4.0
            }
        }
    }

    /// The angle variable at a time, within 0 … 2π. It grows uniformly by 2π per period of a libration or turn of a rotation, from a passage of
    /// the bottom (in libration an upward one). NaN at rest and on the separatrix, where it is undefined, and for a time that is not finite.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_pendulum as libration;
    /// use libration::pendulum::Pendulum;
    /// use std::f64::consts::FRAC_PI_2;
    /// let released = Pendulum::new(1.0, 9.81)?.released_from("2.5".parse()?)?;
    /// assert!((released.angle_variable_at(0.0) - FRAC_PI_2).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn angle_variable_at(&self, time: f64) -> f64 {
        match self {
            Self::Rest(_) | Self::Separatrix(_) => f64::NAN,
            Self::Libration(libration) => TAU * fraction_of(turns_gone(&libration.clock(), time)),
            // 4K are two turns of the pendulum.
            Self::Rotation(rotation) => TAU * fraction_of(2.0 * turns_gone(&rotation.clock(), time)),
        }
    }
}

fn cubed(x: DoubleDouble) -> DoubleDouble {
    x * x.square()
}

/// a/b², infinite where it overflows.
fn over_square(a: DoubleDouble, b: DoubleDouble) -> f64 {
    let once = a / b;
    if (once.hi / b.hi).is_finite() { (once / b).to_f64() } else { f64::INFINITY }
}

/// Turns of 4K, without the whole ones.
fn turns_gone(clock: &PhaseClock, time: f64) -> f64 {
    if !time.is_finite() {
        return f64::NAN;
    }
    let phase = clock.phase(time);
    (phase.rest + 0.25 * phase.quarter).to_f64()
}

fn fraction_of(turns: f64) -> f64 {
    let fraction = turns - turns.floor();
    // Just below a whole turn the difference rounds to one.
    if fraction >= 1.0 { 0.0 } else { fraction }
}
