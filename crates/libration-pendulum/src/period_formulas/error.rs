//! The exact error of a formula: formula and period in two words where these decide the last bit of the difference, else in
//! as many bits as leave 60 good ones in it.

use super::law::Law;
use super::quick::Quick;
use super::swing::{Swing, SwingAmplitude};
use libration_kernels::double_double::block::BLOCK;
use libration_numbers::algebra::BigFloat;

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

struct Prepared {
    precision: usize,
    swing: Swing<BigFloat>,
    exact: BigFloat,
}

impl Exact {
    pub(super) fn new(amplitude: SwingAmplitude) -> Self {
        Self::from_quick(amplitude, Quick::new(amplitude))
    }

    /// At each amplitude in turn, a block of ratios in two words at a time; `None` where there is no amplitude.
    pub(super) fn each(amplitudes: &[Option<SwingAmplitude>]) -> impl Iterator<Item = Option<Self>> {
        let found = |(amplitude, quick): (&Option<_>, _)| amplitude.map(|it| Self::from_quick(it, quick));
        amplitudes.chunks(BLOCK).flat_map(move |block| block.iter().zip(Quick::block(block)).map(found))
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
    use super::super::swing::{NEAREST_BOTTOM, NEAREST_TOP};
    use super::*;
    use crate::period_formulas::family::Family;
    use crate::period_formulas::{PeriodFormula, catalogue};
    use libration_kernels::double_double::DoubleDouble;

    /// Distances from the bottom or the top that crowd there, and those that are neither.
    fn amplitudes() -> impl Iterator<Item = SwingAmplitude> {
        let crowded = |nearest: f64, count: u32| {
            (0..=count).map(move |step| {
                DoubleDouble::from(nearest * libm::pow(1.5 / nearest, f64::from(step) / f64::from(count)))
            })
        };
        let near_bottom = crowded(NEAREST_BOTTOM, 150).map(SwingAmplitude::FromBottom);
        near_bottom.chain(crowded(NEAREST_TOP, 250).map(SwingAmplitude::FromTop))
    }

    /// The catalogue, and long sums.
    fn formulas() -> Vec<PeriodFormula> {
        let sums = Family::ALL.into_iter().flat_map(|family| [7, 40].map(|terms| family.formula(terms)));
        catalogue().iter().cloned().chain(sums).collect()
    }

    /// With a quarter of what is allowed to spare.
    #[test]
    fn two_words_are_off_no_more_than_is_said() {
        const PRECISION: usize = 300;
        let formulas = formulas();
        for amplitude in amplitudes() {
            let quick = Quick::new(amplitude).unwrap();
            let swing = Swing::with_precision(amplitude, PRECISION);
            let exact = swing.exact_ratio();
            for formula in formulas.iter().filter(|formula| amplitude.radians() < formula.defined_below()) {
                let error = (formula.law.ratio(&quick.swing) - quick.exact) / quick.exact;
                let truth = (formula.law.ratio(&swing) - exact.clone()) / exact.clone();
                let off = (BigFloat::from_words(error, PRECISION) - truth).to_f64().abs();
                let said = quick.off(&error);
                assert!(off <= 0.75 * said, "{} {amplitude:?}: {off:e} {said:e}", formula.key());
            }
        }
    }

    /// What two words decide is what floats say, for every formula, from the least to the largest amplitude that two words take.
    #[test]
    fn two_words_decide_as_floats_do() {
        let formulas = formulas();
        let (mut decided, mut asked) = (0, 0);
        for amplitude in amplitudes() {
            let mut exact = Exact::new(amplitude);
            for formula in formulas.iter().filter(|formula| amplitude.radians() < formula.defined_below()) {
                let quick = exact.quick.as_ref().and_then(|quick| quick.fractional_error(&formula.law));
                asked += 1;
                if let Some(quick) = quick {
                    decided += 1;
                    let floats = exact.fractional_error_in_floats(&formula.law);
                    assert_eq!(quick.to_bits(), floats.to_bits(), "{} {amplitude:?}", formula.key());
                }
            }
        }
        assert!(3 * decided > 2 * asked, "{decided} of {asked}");
    }

    /// One ulp to both sides of where two words begin and end, between amplitudes that take one step of the mean and ten, and beside places
    /// without an amplitude.
    #[test]
    fn a_block_finds_what_one_amplitude_finds() {
        let beside = |x: f64| [x.next_down(), x, x.next_up()].map(DoubleDouble::from);
        let seams = beside(NEAREST_BOTTOM).map(SwingAmplitude::FromBottom);
        let seams = seams.into_iter().chain(beside(NEAREST_TOP).map(SwingAmplitude::FromTop));
        let all: Vec<_> = seams.chain(amplitudes()).map(Some).chain([None, None]).collect();
        let (mut found, mut outside) = (0, 0);
        for seed in 0..7 {
            let start = all.iter().cycle().skip(seed).step_by(1 + 10 * seed).copied();
            for count in [1, 2, BLOCK - 1, BLOCK] {
                let block: Vec<_> = start.clone().take(count).collect();
                for (amplitude, quick) in block.iter().zip(Quick::block(&block)) {
                    let one = amplitude.and_then(Quick::new);
                    assert_eq!(one.map(words), quick.map(words), "{amplitude:?}");
                    found += usize::from(quick.is_some());
                    outside += usize::from(quick.is_none());
                }
            }
        }
        assert!(found > 700 && outside > 7, "{found}, {outside}");
    }

    fn words(quick: Quick) -> [[u64; 2]; 5] {
        let Swing { amplitude, complement, cos_half, sin_half } = quick.swing;
        [amplitude, complement, cos_half, sin_half, quick.exact].map(|it| [it.hi.to_bits(), it.lo.to_bits()])
    }
}
