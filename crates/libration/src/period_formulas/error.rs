//! The exact error of a formula: formula and period in two words where these decide the last bit of the difference, else in
//! as many bits as leave 60 good ones in it.

use super::law::Law;
use super::swing::{Swing, SwingAmplitude};
use crate::algebra::BigFloat;
use crate::dispatch::{Kernel, dispatch};
use crate::double_double::DoubleDouble;

/// Bits of the fractional error that are certain before it is rounded.
const GOOD_BITS: isize = 64;
/// Bits that rounding may have spoilt in a formula or in the exact ratio.
const GUARD_BITS: isize = 24;
/// The first attempt: enough for errors down to 1e-15.
const FIRST_PRECISION: usize = 144;
/// Enough for the smallest positive `f64`, 2⁻¹⁰⁷⁴; a smaller error is zero.
const LAST_PRECISION: usize = 1216;

/// The exact ratio at one amplitude in as many precisions as the formulas asked for so far.
pub(super) struct Exact {
    amplitude: SwingAmplitude,
    quick: Option<Quick>,
    prepared: Vec<Prepared>,
}

/// The same in two words, of which rounding may have spoilt as many bits.
struct Quick {
    swing: Swing<DoubleDouble>,
    exact: DoubleDouble,
}

/// What two words are off at most, relatively: 2⁻⁷⁶, after the guard bits of 100.
const QUICK_ERROR: f64 = 1.3234889800848443e-23;

impl Quick {
    fn new(amplitude: SwingAmplitude) -> Option<Self> {
        dispatch(InTwoWords(amplitude))
    }

    /// formula/exact − 1, if all that it may be rounds to one number.
    fn fractional_error(&self, law: &Law) -> Option<f64> {
        let error = (law.ratio(&self.swing) - self.exact) / self.exact;
        let off = QUICK_ERROR * (1.0 + error.hi.abs());
        let (below, above) = (error.hi + (error.lo - off), error.hi + (error.lo + off));
        (below.to_bits() == above.to_bits() && below.is_finite()).then_some(below)
    }
}

struct InTwoWords(SwingAmplitude);

impl Kernel for InTwoWords {
    type Output = Option<Quick>;
    #[inline(always)]
    fn run(self) -> Option<Quick> {
        let swing = Swing::in_two_words(self.0)?;
        let exact = swing.exact_ratio();
        Some(Quick { swing, exact })
    }
}

struct Prepared {
    precision: usize,
    swing: Swing<BigFloat>,
    exact: BigFloat,
}

impl Exact {
    pub(super) fn new(amplitude: SwingAmplitude) -> Self {
        Self { amplitude, quick: Quick::new(amplitude), prepared: Vec::new() }
    }

    /// formula/exact − 1, rounded from at least 60 good bits; zero when the two agree to 2⁻¹¹²⁸.
    pub(super) fn fractional_error(&mut self, law: &Law) -> f64 {
        let quick = self.quick.as_ref().and_then(|quick| quick.fractional_error(law));
        quick.unwrap_or_else(|| self.fractional_error_in_floats(law))
    }

    fn fractional_error_in_floats(&mut self, law: &Law) -> f64 {
        let mut precision = FIRST_PRECISION;
        loop {
            let prepared = self.at_precision(precision);
            let formula = law.ratio(&prepared.swing);
            let error = (formula - prepared.exact.clone()) / prepared.exact.clone();
            let spoilt = GUARD_BITS - signed(precision);
            let exponent = error.exponent().unwrap_or(isize::MIN);
            if exponent.saturating_sub(spoilt) >= GOOD_BITS {
                return error.to_f64();
            }
            if precision >= LAST_PRECISION {
                return 0.0;
            }
            precision = next_precision(precision, exponent, spoilt);
        }
    }

    fn at_precision(&mut self, precision: usize) -> &Prepared {
        let known = self.prepared.iter().position(|prepared| prepared.precision >= precision);
        let index = known.unwrap_or_else(|| {
            let swing = Swing::with_precision(self.amplitude, precision);
            let exact = swing.exact_ratio();
            self.prepared.push(Prepared { precision, swing, exact });
            self.prepared.len() - 1
        });
        &self.prepared[index]
    }
}

/// What the error's size asks for, or twice as much when it is lost in rounding.
fn next_precision(precision: usize, exponent: isize, spoilt: isize) -> usize {
    let visible = exponent > spoilt;
    let asked = if visible { GOOD_BITS + GUARD_BITS - exponent + 1 } else { 2 * signed(precision) };
    // In steps, so that formulas of like error share the exact ratio.
    let stepped = usize::try_from(asked).unwrap_or(LAST_PRECISION).next_multiple_of(64);
    stepped.clamp(precision + 1, LAST_PRECISION)
}

fn signed(precision: usize) -> isize {
    isize::try_from(precision).unwrap_or(isize::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::period_formulas::catalogue;

    /// What two words decide is what floats say, for every formula, from the least to the largest amplitude that two words take.
    #[test]
    fn two_words_decide_as_floats_do() {
        let (mut decided, mut asked) = (0, 0);
        for step in 0..400 {
            let amplitude = 0.0625 + (std::f64::consts::PI - 0.125) * f64::from(step) / 399.0;
            let Some(amplitude) = SwingAmplitude::from_radians(amplitude) else { continue };
            let mut exact = Exact::new(amplitude);
            for formula in catalogue().iter().filter(|formula| amplitude.radians() < formula.defined_below())
            {
                let quick = exact.quick.as_ref().and_then(|quick| quick.fractional_error(&formula.law));
                asked += 1;
                if let Some(quick) = quick {
                    decided += 1;
                    let floats = exact.fractional_error_in_floats(&formula.law);
                    assert_eq!(quick.to_bits(), floats.to_bits(), "{} {amplitude:?}", formula.key());
                }
            }
        }
        assert!(2 * decided > asked, "{decided} of {asked}");
    }
}
