//! Numbers that are sums of powers of π times fractions or square roots.

use super::in_order::InOrder;
use std::f64::consts::PI;
use std::fmt;

use super::{Rational, Surd};

/// A sum of integer powers of π, including negative ones, times numbers a + b√d.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::algebra::{PiSum, Rational, Surd};
/// let (third, ninth) = (Rational::new(-4, 3).ok_or("zero")?, Rational::new(8, 9).ok_or("zero")?);
/// let sum = PiSum::new(vec![(-1, Surd::from(third)), (-2, Surd::from(ninth))]);
/// assert_eq!(sum.to_string(), "-4/(3*pi) + 8/(9*pi^2)");
/// assert!((sum.to_f64() + 0.3343499072).abs() < 1e-10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PiSum {
    /// The terms, by falling powers.
    terms: Vec<(i32, Surd)>,
}

impl PiSum {
    /// The sum of terms, each a power of π with its coefficient; no power occurs twice.
    #[must_use]
    pub fn new(terms: Vec<(i32, Surd)>) -> Self {
        let mut terms: Vec<_> = terms.into_iter().filter(|(_, factor)| !is_zero(factor)).collect();
        terms.put_in_order_by(|(power, _)| -power);
        Self { terms }
    }

    /// The powers of π with their coefficients, higher ones first.
    #[must_use]
    pub fn terms(&self) -> &[(i32, Surd)] {
        &self.terms
    }

    /// Returns `true` if the sum is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value as a fraction; `None` if π or a root occurs.
    #[must_use]
    pub fn to_rational(&self) -> Option<Rational> {
        match self.terms.as_slice() {
            [] => Some(Rational::from(0)),
            [(0, factor)] => factor.to_rational().cloned(),
            _ => None,
        }
    }

    /// The value, accurate to some units in the last place of the largest term.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        let term = |(power, factor): &(i32, Surd)| {
            let powers = (0..power.unsigned_abs()).fold(1.0, |product, _| product * PI);
            if *power < 0 { factor.to_f64() / powers } else { factor.to_f64() * powers }
        };
        self.terms.iter().map(term).sum()
    }
}

impl From<Rational> for PiSum {
    fn from(value: Rational) -> Self {
        Self::new(vec![(0, Surd::from(value))])
    }
}

fn is_zero(factor: &Surd) -> bool {
    factor.plain().is_zero() && factor.root().is_zero()
}

/// Writes a formula such as `2/9 - 4/(3*pi)`.
impl fmt::Display for PiSum {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.terms.is_empty() {
            return formatter.write_str("0");
        }
        for (index, (power, factor)) in self.terms.iter().enumerate() {
            let text = term(*power, factor);
            match (index, text.strip_prefix('-')) {
                (0, _) => formatter.write_str(&text)?,
                (_, Some(size)) => write!(formatter, " - {size}")?,
                (_, None) => write!(formatter, " + {text}")?,
            }
        }
        Ok(())
    }
}

fn term(power: i32, factor: &Surd) -> String {
    let powers = match power.unsigned_abs() {
        0 => return factor.to_string(),
        1 => "pi".to_owned(),
        other => format!("pi^{other}"),
    };
    let Some(fraction) = factor.to_rational() else {
        let factor = if factor.plain().is_zero() { factor.to_string() } else { format!("({factor})") };
        return if power > 0 { format!("{factor}*{powers}") } else { format!("{factor}/{powers}") };
    };
    let (above, below) = (fraction.numerator(), fraction.denominator());
    match (power > 0, above.as_str(), below.as_str()) {
        (true, "1", "1") => powers,
        (true, "-1", "1") => format!("-{powers}"),
        (true, _, "1") => format!("{above}*{powers}"),
        (true, ..) => format!("{fraction}*{powers}"),
        (false, _, "1") => format!("{above}/{powers}"),
        (false, ..) => format!("{above}/({below}*{powers})"),
    }
}
