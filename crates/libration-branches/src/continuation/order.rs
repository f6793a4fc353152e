//! Order of a sub- or superharmonic response.

/// Largest number of oscillations and of drive periods.
const MOST: u32 = 100;

/// Number of oscillations in a number of drive periods, in lowest terms: 1/3 is the subharmonic response at a third of the drive frequency.
///
/// # Examples
/// ```
/// # extern crate libration_branches as libration;
/// use libration::continuation::ResonanceOrder;
/// let third: ResonanceOrder = "2/6".parse()?;
/// assert_eq!((third.oscillations(), third.drive_periods(), third.to_string().as_str()), (1, 3, "1/3"));
/// assert!("0/3".parse::<ResonanceOrder>().is_err());
/// # Ok::<(), libration::continuation::ParseOrderError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ResonanceOrder {
    oscillations: u32,
    drive_periods: u32,
}

/// Text that is not an order.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{0}` is not an order: give two whole numbers from 1 to 100, such as 1/3 for a third of the drive frequency, or one"
)]
pub struct ParseOrderError(String);

impl ResonanceOrder {
    /// Number of oscillations.
    #[must_use]
    pub const fn oscillations(self) -> u32 {
        self.oscillations
    }

    /// Number of drive periods.
    #[must_use]
    pub const fn drive_periods(self) -> u32 {
        self.drive_periods
    }
}

impl std::str::FromStr for ResonanceOrder {
    type Err = ParseOrderError;

    fn from_str(text: &str) -> Result<Self, ParseOrderError> {
        let number = |part: &str| part.trim().parse().ok().filter(|number| (1..=MOST).contains(number));
        let (above, below) = text.split_once('/').unwrap_or((text, "1"));
        let (Some(oscillations), Some(drive_periods)) = (number(above), number(below)) else {
            return Err(ParseOrderError(text.trim().to_owned()));
        };
        let shared =
            (1..=MOST).rev().find(|divisor| oscillations % divisor == 0 && drive_periods % divisor == 0);
        let shared = shared.unwrap_or(1);
        Ok(Self { oscillations: oscillations / shared, drive_periods: drive_periods / shared })
    }
}

impl std::fmt::Display for ResonanceOrder {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.drive_periods {
            1 => write!(f, "{}", self.oscillations),
            periods => write!(f, "{}/{periods}", self.oscillations),
        }
    }
}
