//! The exact error of a formula. Formula and period are computed in two words if these decide the last bit of the difference, otherwise with a
//! precision that leaves 60 good bits in it.

use super::law::Law;
use super::quick::Quick;
use super::swing::{Swing, SwingAmplitude};
use libration_kernels::double_double::block::BLOCK;
use libration_numbers::algebra::BigFloat;

/// Bits of the fractional error that are certain before it is rounded.
const GOOD_BITS: isize = 64;
/// Bits of a formula or of the exact ratio that rounding may have spoilt.
const GUARD_BITS: isize = 24;
/// Precision of the first attempt, enough for errors down to 1e-15.
const FIRST_PRECISION: usize = 144;
/// Precision that suffices for the smallest positive `f64`, 2⁻¹⁰⁷⁴; a smaller error is zero.
const LAST_PRECISION: usize = 1216;

/// The exact ratio at one amplitude, in each precision that a formula has required so far.
#[derive(Debug)]
pub struct Exact {
    amplitude: SwingAmplitude,
    pub quick: Option<Quick>,
    prepared: Vec<Prepared>,
}

#[derive(Debug)]
struct Prepared {
    precision: usize,
    swing: Swing<BigFloat>,
    exact: BigFloat,
}

impl Exact {
    pub fn new(amplitude: SwingAmplitude) -> Self {
        Self::from_quick(amplitude, Quick::new(amplitude))
    }

    /// The errors at each amplitude in turn, from ratios in two words of a block at a time; `None` for an invalid amplitude.
    pub(super) fn each(amplitudes: &[Option<SwingAmplitude>]) -> impl Iterator<Item = Option<Self>> {
        let errors = |(amplitude, quick): (&Option<_>, _)| {
            amplitude.map(|amplitude| Self::from_quick(amplitude, quick))
        };
        amplitudes.chunks(BLOCK).flat_map(move |block| block.iter().zip(Quick::block(block)).map(errors))
    }

    fn from_quick(amplitude: SwingAmplitude, quick: Option<Quick>) -> Self {
        Self { amplitude, quick, prepared: Vec::new() }
    }

    pub(super) fn amplitude(&self) -> SwingAmplitude {
        self.amplitude
    }

    /// formula/exact − 1, rounded from at least 60 good bits; zero when the two agree to 2⁻¹¹²⁸.
    pub(super) fn fractional_error(&mut self, law: &Law) -> f64 {
        let quick = self.quick.and_then(|quick| quick.fractional_error(law));
        quick.unwrap_or_else(|| self.fractional_error_in_floats(law))
    }

    pub fn fractional_error_in_floats(&mut self, law: &Law) -> f64 {
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
        let prepared = self.prepared.iter().position(|prepared| prepared.precision >= precision);
        let index = prepared.unwrap_or_else(|| {
            let swing = Swing::with_precision(self.amplitude, precision);
            let exact = swing.exact_ratio();
            self.prepared.push(Prepared { precision, swing, exact });
            self.prepared.len() - 1
        });
        &self.prepared[index]
    }
}

/// The precision that the size of the error requires, or twice the precision if the error is lost in rounding.
fn next_precision(precision: usize, exponent: isize, spoilt: isize) -> usize {
    let visible = exponent > spoilt;
    let asked = if visible { GOOD_BITS + GUARD_BITS - exponent + 1 } else { 2 * signed(precision) };
    // Precisions are rounded up to multiples of 64, so that formulas of similar error share the exact ratio.
    let stepped = usize::try_from(asked).unwrap_or(LAST_PRECISION).next_multiple_of(64);
    stepped.clamp(precision + 1, LAST_PRECISION)
}

fn signed(precision: usize) -> isize {
    isize::try_from(precision).unwrap_or(isize::MAX)
}
