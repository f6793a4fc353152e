//! Mistakes that multiply g by an exact factor: units of lengths, counted periods, frame rates.

use std::fmt;

use super::gravity::GRAVITY_ON_EARTH;
use super::uncertain::Uncertain;

/// A mistake that multiplies g by an exact factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum GravityMistake {
    /// Centimetres that were read as metres: 100.
    CentimetresAsMetres,
    /// A number of swings that were counted as one: one over its square. Ten are as metres that were read as centimetres.
    SwingsAsOne(u8),
    /// Half periods that were taken for whole ones: 4.
    HalfPeriodsAsWhole,
    /// Whole periods taken as half ones: 1/4.
    WholePeriodsAsHalf,
    /// Times in milliseconds that were read as seconds: 10⁻⁶.
    MillisecondsAsSeconds,
    /// Times in seconds that were read as milliseconds: 10⁶.
    SecondsAsMilliseconds,
    /// 25 frames a second that were taken for 30: (30/25)².
    FramesOf25As30,
    /// 30 frames a second that were taken for 25: (25/30)².
    FramesOf30As25,
    /// 29.97 frames a second that were taken for 30: (30/29.97)².
    FramesOf29As30,
}

impl GravityMistake {
    /// All mistakes.
    pub const ALL: [Self; 18] = [
        Self::CentimetresAsMetres,
        Self::SwingsAsOne(3),
        Self::SwingsAsOne(4),
        Self::SwingsAsOne(5),
        Self::SwingsAsOne(10),
        Self::SwingsAsOne(15),
        Self::SwingsAsOne(20),
        Self::SwingsAsOne(25),
        Self::SwingsAsOne(30),
        Self::SwingsAsOne(50),
        Self::SwingsAsOne(100),
        Self::HalfPeriodsAsWhole,
        Self::WholePeriodsAsHalf,
        Self::MillisecondsAsSeconds,
        Self::SecondsAsMilliseconds,
        Self::FramesOf25As30,
        Self::FramesOf30As25,
        Self::FramesOf29As30,
    ];

    /// The factor of g.
    #[must_use]
    pub fn factor(self) -> f64 {
        match self {
            Self::CentimetresAsMetres => 100.0,
            Self::SwingsAsOne(number) => 1.0 / (f64::from(number) * f64::from(number)),
            Self::HalfPeriodsAsWhole => 4.0,
            Self::WholePeriodsAsHalf => 0.25,
            Self::MillisecondsAsSeconds => 1e-6,
            Self::SecondsAsMilliseconds => 1e6,
            Self::FramesOf25As30 => 1.44,
            Self::FramesOf30As25 => 25.0 / 36.0,
            Self::FramesOf29As30 => (30.0 / 29.97) * (30.0 / 29.97),
        }
    }

    /// The only mistake that explains g: its factor is within two standard uncertainties, no other one is, and the relative uncertainty is below a
    /// third of the logarithm of the factor, so that g itself is excluded. `local` is the gravity of the place.
    ///
    /// # Examples
    /// ```
    /// use libration_lab::fit::{GravityMistake, Uncertain};
    ///
    /// let gravity = Uncertain { value: 39.1, uncertainty: 0.4 };
    /// let mistake = GravityMistake::explaining(gravity, GravityMistake::anywhere_on_earth());
    /// assert_eq!(mistake, Some(GravityMistake::HalfPeriodsAsWhole));
    /// ```
    #[must_use]
    pub fn explaining(gravity: Uncertain, local: Uncertain) -> Option<Self> {
        let relative = libm::hypot(gravity.relative(), local.relative());
        let explains = |mistake: &Self| {
            let expected = mistake.factor() * local.value;
            let uncertainty = libm::hypot(gravity.uncertainty, mistake.factor() * local.uncertainty);
            (gravity.value - expected).abs() <= 2.0 * uncertainty
        };
        let mut explaining = Self::ALL.into_iter().filter(explains);
        let only = explaining.next().filter(|_| explaining.next().is_none())?;
        (relative < libm::log(only.factor()).abs() / 3.0).then_some(only)
    }

    /// Gravity at an unknown place: the middle of [`GRAVITY_ON_EARTH`], with all values in that range equally probable.
    #[must_use]
    pub fn anywhere_on_earth() -> Uncertain {
        let [least, greatest] = GRAVITY_ON_EARTH;
        Uncertain { value: f64::midpoint(least, greatest), uncertainty: (greatest - least) / 12.0_f64.sqrt() }
    }
}

/// The mistake as a clause: `half periods taken for whole ones`.
impl fmt::Display for GravityMistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::SwingsAsOne(10) => "ten swings counted as one, or lengths in metres read as centimetres",
            Self::SwingsAsOne(number) => return write!(f, "{number} swings counted as one"),
            Self::CentimetresAsMetres => "lengths in centimetres read as metres",
            Self::HalfPeriodsAsWhole => "half periods taken for whole ones",
            Self::WholePeriodsAsHalf => "two swings counted as one, or whole periods taken for half ones",
            Self::MillisecondsAsSeconds => "times in milliseconds read as seconds",
            Self::SecondsAsMilliseconds => "times in seconds read as milliseconds",
            Self::FramesOf25As30 => "25 frames a second taken for 30",
            Self::FramesOf30As25 => "30 frames a second taken for 25",
            Self::FramesOf29As30 => "29.97 frames a second taken for 30",
        })
    }
}
