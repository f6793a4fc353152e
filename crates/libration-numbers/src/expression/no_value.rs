//! Parts of a formula that have no real value for any values of the symbols.

use super::{Expression, Function, Jet, Tape};
use crate::algebra::{BigFloat, Domain, Floats};
use crate::quantity::excerpt;

/// Precision, in bits, in which irrational constants are evaluated.
const PRECISION: usize = 256;
/// Distances from a limit below two to this power count as zero.
const NOISE: isize = -128;

/// A part of a formula that is undefined, such as 1/0 or ln(-1).
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{part}` has no value: {why}")]
pub struct ValueError {
    /// The part, shortened.
    pub part: String,
    /// The reason.
    pub why: &'static str,
}

impl Expression {
    /// The first part that provably has no real value.
    #[doc(hidden)]
    pub fn without_value(&self) -> Option<ValueError> {
        let inner = self.parts().find_map(Self::without_value);
        inner.or_else(|| {
            let why = self.why_without_value()?;
            Some(ValueError { part: excerpt(&self.to_string()), why })
        })
    }

    /// Reason why this operation is undefined although its operands have values.
    fn why_without_value(&self) -> Option<&'static str> {
        match self {
            Self::Divide(_, divisor) if divisor.vanishes() => Some("division by zero"),
            Self::Power(base, exponent) => {
                let below_zero = exponent.to_rational().is_some_and(|power| power.is_negative());
                (below_zero && base.vanishes()).then_some("zero has no negative powers")
            }
            Self::Call(function, argument) => {
                let Domain { low, high, why } = function.domain()?;
                let value = argument.constant_in_digits()?;
                let beyond = |bound: i64, sign: i64| {
                    let past = value.clone() - BigFloat::from_integer(bound, PRECISION);
                    let past = if sign < 0 { -past } else { past };
                    past > BigFloat::from_integer(0, PRECISION) && past.exponent() > Some(NOISE)
                };
                let at_pole = *function == Function::Ln && argument.vanishes();
                let outside =
                    low.is_some_and(|low| beyond(low, -1)) || high.is_some_and(|high| beyond(high, 1));
                (at_pole || outside).then_some(why)
            }
            _ => None,
        }
    }

    /// A formula without symbols, to [`PRECISION`] bits.
    fn constant_in_digits(&self) -> Option<BigFloat> {
        let tape = Tape::new(&[self], &[]).ok()?;
        let jet = Jet::new(&Floats { precision: PRECISION }, &tape, &[]).ok()?.result(0).first()?.clone();
        Some(jet)
    }
}
