//! Approximate motions of a first-year course: a few harmonics, with coefficients in powers of the amplitude θ0, for a pendulum released from
//! rest.
//!
//! ```text
//! θ(t) ≈ a1·cos(Ωt) + a3·cos(3Ωt) + a5·cos(5Ωt) + a7·cos(7Ωt),   a_n = Σ c_nj·θ0^(2j+1),   Ω = ω0·Σ d_j·θ0^(2j)
//! ```
//!
//! Each motion keeps the powers of θ0 in its name: `fourier-5` has every term up to θ0⁵ in the coefficients and up to θ0⁴ in the frequency.
//! Equation numbers are those of Black and Vel's Fourier-perturbation method.

use libm::cos;
use libration_numbers::quantity::Angle;
use libration_numbers::{
    catalogue::{self, UnknownKey},
    internals::catalogue::Named,
};

/// A coefficient as numerator and denominator.
type CoefficientFraction = (f64, f64);

/// Coefficients of a1, a3, a5, a7 in θ0, θ0³, θ0⁵, θ0⁷: eqs (30), (29), (48)–(50) and the next order, which is
/// the expansion of the exact `a_n = 8(−1)ⁿ q^(n+1/2) / ((2n+1)(1 + q^(2n+1)))` (computed with FLINT).
#[doc(hidden)]
pub const HARMONICS: [[CoefficientFraction; 4]; 4] = [
    [(1.0, 1.0), (1.0, 192.0), (17.0, 61440.0), (1487.0, 82575360.0)],
    [(0.0, 1.0), (-1.0, 192.0), (-1.0, 3072.0), (-133.0, 5898240.0)],
    [(0.0, 1.0), (0.0, 1.0), (1.0, 20480.0), (1.0, 196608.0)],
    [(0.0, 1.0), (0.0, 1.0), (0.0, 1.0), (-1.0, 1835008.0)],
];

/// Coefficients of Ω/ω0 in 1, θ0², θ0⁴, θ0⁶: eqs (31) and (51).
#[doc(hidden)]
pub const FREQUENCY: [CoefficientFraction; 4] = [(1.0, 1.0), (-1.0, 16.0), (1.0, 3072.0), (-23.0, 737280.0)];

/// An approximate motion after release from rest, made by [`ApproximateMotion::by_key`] or taken from
/// [`ApproximateMotion::CATALOGUE`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ApproximateMotion {
    key: &'static str,
    name: &'static str,
    source: &'static str,
    harmonics: usize,
}

impl Named for ApproximateMotion {
    const KIND: &'static str = "approximate motion";
    const OTHERWISE: &'static str = "";

    fn keys(&self) -> impl Iterator<Item = &str> {
        std::iter::once(self.key)
    }
}

impl ApproximateMotion {
    /// Every approximate motion, the simplest first.
    pub const CATALOGUE: [Self; 4] = [
        Self {
            key: "small-angle",
            name: "small-angle cosine",
            source: "Black and Vel, eq. (2)",
            harmonics: 1,
        },
        Self {
            key: "fourier-3",
            name: "two harmonics, to θ₀³",
            source: "Black and Vel, eqs (29)–(31)",
            harmonics: 2,
        },
        Self {
            key: "fourier-5",
            name: "three harmonics, to θ₀⁵",
            source: "Black and Vel, eqs (48)–(51)",
            harmonics: 3,
        },
        Self {
            key: "fourier-7",
            name: "four harmonics, to θ₀⁷",
            source: "the next order of Black and Vel, eqs (48)–(51)",
            harmonics: 4,
        },
    ];

    /// The motion with this key.
    ///
    /// # Errors
    /// No motion has this key; the error lists the nearest keys and all of them.
    pub fn by_key(key: &str) -> Result<Self, UnknownKey> {
        catalogue::by_key(Self::CATALOGUE.iter(), key).copied()
    }

    /// The stable name in commands and files: `small-angle`, `fourier-3`, `fourier-5`, `fourier-7`.
    #[must_use]
    pub fn key(&self) -> &'static str {
        self.key
    }

    /// The publication of the motion.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// The work in which it is published.
    #[must_use]
    pub fn source(&self) -> &'static str {
        self.source
    }

    /// The angle (rad) at the phase ω0·t after release from rest at `amplitude` (rad, of either sign).
    ///
    /// # Domain
    /// Any finite numbers; useful below about 150°.
    /// # Accuracy
    /// The largest error over the first period is, at 30°, 60° and 90°: `fourier-3` 1.5e-4, 2.4e-3 and
    /// 1.2e-2 of the amplitude; each further step gains two powers of the amplitude.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_pendulum as libration;
    /// use libration::pendulum::ApproximateMotion;
    /// let small_angle = ApproximateMotion::by_key("small-angle")?;
    /// assert_eq!(small_angle.angle(0.1, 0.0), 0.1);
    /// # Ok::<(), libration::catalogue::UnknownKey>(())
    /// ```
    #[must_use]
    pub fn angle(&self, amplitude: f64, phase: f64) -> f64 {
        let angle = self.frequency_ratio(amplitude) * phase;
        let multiples = [1.0, 3.0, 5.0, 7.0];
        self.coefficients(amplitude).iter().zip(multiples).map(|(a, n)| a * cos(n * angle)).sum()
    }

    /// Ω/ω0, the ratio of the frequency of this motion to that of small swings.
    #[must_use]
    pub fn frequency_ratio(&self, amplitude: f64) -> f64 {
        series(&FREQUENCY[..self.harmonics], amplitude * amplitude)
    }

    /// a1, a3, a5 and a7 in radians; harmonics that this motion omits are zero.
    #[must_use]
    pub fn coefficients(&self, amplitude: f64) -> [f64; 4] {
        HARMONICS.map(|harmonic| amplitude * series(&harmonic[..self.harmonics], amplitude * amplitude))
    }

    /// The signed amplitude in radians for a start at this angle with this velocity (rad/s).
    ///
    /// # Errors
    /// The start is not a release from rest strictly between −π and π, as all these motions assume.
    pub fn amplitude_of(angle: &Angle, velocity: f64) -> Result<f64, ApproximateMotionError> {
        if velocity != 0.0 {
            return Err(ApproximateMotionError::NotFromRest(velocity));
        }
        if angle.turns() != 0 || angle.complement() <= 0.0 {
            return Err(ApproximateMotionError::BeyondUpright(angle.radians()));
        }
        Ok(angle.in_turn())
    }
}

/// The polynomial with these coefficients, by Horner's rule.
fn series(coefficients: &[CoefficientFraction], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, (numerator, denominator)| sum * x + numerator / denominator)
}

/// The reason why a start has no approximate motion.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ApproximateMotionError {
    /// Not released from rest.
    #[error(
        "the approximate motions are for a pendulum released from rest, and this one starts with {0} rad/s: leave out the velocity or the comparison"
    )]
    NotFromRest(f64),
    /// A release from the upright position or beyond.
    #[error(
        "the approximate motions are for a release between −π and π, and this one starts at {0} rad: give a smaller angle or leave out the \
         comparison"
    )]
    BeyondUpright(f64),
}
