//! The gauge: the definition of the expansion parameter ε.

use std::fmt;
use std::str::FromStr;

use libration_numbers::algebra::{ParseRationalError, Rational};

/// The definition of the expansion parameter ε of a family of periodic motions. The choice changes every
/// series in ε and no relation between physical quantities.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Gauge {
    /// ε is the coefficient of cos Ωt.
    #[default]
    Fundamental,
    /// ε is the largest displacement, the amplitude of a symmetric well.
    XMax,
    /// ε is half the distance between the turning points.
    HalfSwing,
    /// ε = √(2E)/ω0, with the energy E counted from the equilibrium; for conservative oscillators.
    Energy,
    /// ε = 8√q with the nome q; for the pendulum.
    Nome,
    /// The coefficient of cos Ωt is A₁ε + A₂ε² + …, with the list A₁, A₂, …; further coefficients are zero.
    Coefficients(Vec<Rational>),
}

/// The largest index of a coefficient that a gauge may name.
const LARGEST_INDEX: usize = 10_000;

impl fmt::Display for Gauge {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fundamental => formatter.write_str("fundamental"),
            Self::XMax => formatter.write_str("x_max"),
            Self::HalfSwing => formatter.write_str("half_swing"),
            Self::Energy => formatter.write_str("energy"),
            Self::Nome => formatter.write_str("nome"),
            Self::Coefficients(list) => {
                let present = list.iter().enumerate().filter(|(n, a)| *n == 0 || !a.is_zero());
                let items: Vec<String> = present.map(|(n, a)| format!("A{}={a}", n + 1)).collect();
                formatter.write_str(&items.join(","))
            }
        }
    }
}

/// Reads a name, or a list such as `A1=1,A3=-1/2` in any order; coefficients that are not listed are zero.
impl FromStr for Gauge {
    type Err = ParseGaugeError;

    fn from_str(text: &str) -> Result<Self, ParseGaugeError> {
        let named = [Self::Fundamental, Self::XMax, Self::HalfSwing, Self::Energy, Self::Nome];
        if let Some(gauge) = named.into_iter().find(|gauge| gauge.to_string() == text.trim()) {
            return Ok(gauge);
        }
        if !text.contains('=') {
            return Err(ParseGaugeError::Unknown(text.to_owned()));
        }
        let mut list: Vec<Option<Rational>> = vec![];
        for item in text.split(',') {
            let (index, value) = coefficient(item)?;
            if list.len() < index {
                list.resize(index, None);
            }
            if list[index - 1].replace(value).is_some() {
                return Err(ParseGaugeError::Twice(index));
            }
        }
        let list: Vec<Rational> = list.into_iter().map(|a| a.unwrap_or_else(|| Rational::from(0))).collect();
        if list[0].is_zero() {
            Err(ParseGaugeError::NoFirst(text.to_owned()))
        } else {
            Ok(Self::Coefficients(list))
        }
    }
}

/// The index and value of `A3=-1`.
fn coefficient(item: &str) -> Result<(usize, Rational), ParseGaugeError> {
    let refusal = || ParseGaugeError::Item(item.trim().to_owned());
    let (name, value) = item.split_once('=').ok_or_else(refusal)?;
    let index = name.trim().strip_prefix(['A', 'a']).ok_or_else(refusal)?;
    let index: usize = index.trim_start_matches('_').parse().map_err(|_| refusal())?;
    if !(1..=LARGEST_INDEX).contains(&index) {
        return Err(refusal());
    }
    Ok((index, value.trim().parse()?))
}

/// A text that names no gauge.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ParseGaugeError {
    /// Neither a name nor a list.
    #[error(
        "unknown gauge `{0}`: give fundamental, x_max, half_swing, energy, nome, or coefficients such as A1=1,A3=-1"
    )]
    Unknown(String),
    /// An item of the list that is not a coefficient.
    #[error(
        "`{0}` is not a coefficient of a gauge: give items such as A3=-1/2, with indices 1 to {LARGEST_INDEX}"
    )]
    Item(String),
    /// A coefficient that is given twice.
    #[error("the gauge gives A{0} twice: give it once")]
    Twice(usize),
    /// A list without A1.
    #[error(
        "the gauge `{0}` has no A1: ε must be of first order in the amplitude, so give a nonzero A1, such as A1=1"
    )]
    NoFirst(String),
    /// A coefficient that is not a fraction.
    #[error(transparent)]
    Value(#[from] ParseRationalError),
}
