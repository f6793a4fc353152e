//! The error of a formula in two words, if these decide its last bit: for one amplitude, or for a block stage by stage.

use super::law::Law;
use super::swing::{AGREEING, Swing, SwingAmplitude, inverse_of_agreeing, next_means};
use libration_kernels::dispatch::{Kernel, dispatch, dispatch_slices};
use libration_kernels::double_double::block::{BLOCK, Words};
use libration_kernels::double_double::{DoubleDouble, pick};
use libration_kernels::elementary::two_word;

/// Input of the formulas in two words, and the exact ratio.
#[derive(Clone, Copy, Debug)]
pub struct Quick {
    pub swing: Swing<DoubleDouble>,
    pub exact: DoubleDouble,
}

/// 2⁻⁹⁶: bound for the relative error of two words; the largest error of all formulas of the catalogue, at distances of 2⁻² to 2⁻³⁹ from the
/// top, is 2⁻⁹⁹·⁸.
const QUICK_ERROR: f64 = 1.262177448353619e-29;
/// Amplitude below which the error bound grows as 1/θ0², since differences of numbers near one are divided by θ0²: the largest errors are
/// 2⁻¹⁰¹·¹ at 1/4, 2⁻⁹⁵·⁵ at 2⁻⁵ and 2⁻⁸⁵·⁸ at 2⁻¹⁰.
const FULL_ABOVE: f64 = 0.25;

impl Quick {
    /// The input for one amplitude; `None` outside the range in which two words were tested.
    pub fn new(amplitude: SwingAmplitude) -> Option<Self> {
        amplitude.suits_two_words().then(|| dispatch(One(amplitude)))
    }

    /// [`Self::new`] of each amplitude of a block, bit for bit; `None` for an invalid amplitude too.
    pub fn block(amplitudes: &[Option<SwingAmplitude>]) -> [Option<Self>; BLOCK] {
        dispatch_slices(AmplitudeBlock(amplitudes))
    }

    /// formula/exact − 1, if all values within the error bound round to the same number.
    pub fn fractional_error(&self, law: &Law) -> Option<f64> {
        let error = (law.ratio(&self.swing) - self.exact) / self.exact;
        let off = self.off(&error);
        let (below, above) = (error.hi + (error.lo - off), error.hi + (error.lo + off));
        (below.to_bits() == above.to_bits() && below.is_finite()).then_some(below)
    }

    /// Error bound of a fractional error.
    pub fn off(&self, error: &DoubleDouble) -> f64 {
        let lost = f64::max(1.0, FULL_ABOVE / self.swing.amplitude.hi);
        QUICK_ERROR * (1.0 + error.hi.abs()) * lost * lost
    }
}

struct One(SwingAmplitude);

impl Kernel for One {
    type Output = Quick;
    #[inline(always)]
    fn run(self) -> Quick {
        let swing = Swing::in_two_words(self.0, two_word::sin_cos_series(self.0.half_distance()));
        Quick { swing, exact: swing.exact_ratio() }
    }
}

struct AmplitudeBlock<'a>(&'a [Option<SwingAmplitude>]);

/// One radian, which stands in for invalid amplitudes and for those outside the tested range.
const INSTEAD: SwingAmplitude = SwingAmplitude::FromBottom(DoubleDouble::ONE);

impl Kernel for AmplitudeBlock<'_> {
    type Output = [Option<Quick>; BLOCK];
    #[inline(always)]
    fn run(self) -> Self::Output {
        let suited = |i| {
            self.0.get(i).copied().flatten().filter(|amplitude: &SwingAmplitude| amplitude.suits_two_words())
        };
        let (mut halves, mut sines, mut cosines) = (Words::ZERO, Words::ZERO, Words::ZERO);
        for i in 0..BLOCK {
            halves.set(i, suited(i).unwrap_or(INSTEAD).half_distance());
        }
        two_word::sin_cos_series_of_block(&halves, &mut sines, &mut cosines);
        let mut swings = [None; BLOCK];
        let mut smaller = Words::ZERO;
        for (i, kept) in swings.iter_mut().enumerate() {
            let swing = Swing::in_two_words(suited(i).unwrap_or(INSTEAD), (sines.get(i), cosines.get(i)));
            smaller.set(i, swing.cos_half);
            *kept = suited(i).map(|_| swing);
        }
        let exact = exact_ratios(smaller);
        std::array::from_fn(|i| swings[i].map(|swing| Quick { swing, exact: exact.get(i) }))
    }
}

/// Computes [`Swing::exact_ratio`] for each cos(θ0/2); elements that have converged wait for the others.
#[inline(always)]
fn exact_ratios(mut smaller: Words) -> Words {
    let mut larger = Words::ONE;
    while (0..BLOCK).any(|i| larger.hi[i] - smaller.hi[i] > AGREEING) {
        for i in 0..BLOCK {
            let (a, b) = (larger.get(i), smaller.get(i));
            let apart = a.hi - b.hi > AGREEING;
            let (mean, root) = next_means(a, b);
            larger.set(i, pick(apart, mean, a));
            smaller.set(i, pick(apart, root, b));
        }
    }
    for i in 0..BLOCK {
        larger.set(i, inverse_of_agreeing(larger.get(i), smaller.get(i)));
    }
    larger
}
