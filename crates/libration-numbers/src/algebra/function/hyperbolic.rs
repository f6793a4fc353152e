//! Hyperbolic functions in floats of any precision, by exponentials.

use crate::algebra::BigFloat;

/// (eˣ − e⁻ˣ)/2 and (eˣ + e⁻ˣ)/2.
pub(super) fn sinh_cosh(x: &BigFloat, precision: usize) -> [BigFloat; 2] {
    // The difference loses the leading bits of small x.
    let lost = usize::try_from(-x.exponent().unwrap_or(0)).unwrap_or(0);
    let wide = x.clone() + BigFloat::from_integer(0, precision + 2 * lost + 8);
    let (grown, decayed) = (wide.exp(), (-wide).exp());
    let twice = [grown.clone() - decayed.clone(), grown + decayed];
    twice.map(|twice| twice.halved().rounded_to(precision))
}

pub(super) fn sinh(x: &BigFloat, precision: usize) -> BigFloat {
    let [sine, _] = sinh_cosh(x, precision);
    sine
}

pub(super) fn cosh(x: &BigFloat, precision: usize) -> BigFloat {
    let [_, cosine] = sinh_cosh(x, precision);
    cosine
}
