use libration::algebra::BigFloat;
use libration::internals::period_formulas::{
    Exact, Family, NEAREST_BOTTOM, NEAREST_TOP, Quick, Swing, SwingAmplitude,
};
use libration::period_formulas::{PeriodFormula, catalogue};
use libration_kernels::double_double::{DoubleDouble, block::BLOCK};

/// Distances from the bottom or the top: dense at both ends, and some in between.
fn amplitudes() -> impl Iterator<Item = SwingAmplitude> {
    let crowded = |nearest: f64, count: u32| {
        (0..=count).map(move |step| {
            DoubleDouble::from(nearest * libm::pow(1.5 / nearest, f64::from(step) / f64::from(count)))
        })
    };
    let near_bottom = crowded(NEAREST_BOTTOM, 150).map(SwingAmplitude::FromBottom);
    near_bottom.chain(crowded(NEAREST_TOP, 250).map(SwingAmplitude::FromTop))
}

/// The catalogue, and families with many terms.
fn formulas() -> Vec<PeriodFormula> {
    let sums = Family::ALL
        .into_iter()
        .flat_map(|family| [3, 7, 40].map(|terms| family.formula(terms.min(family.most()))));
    catalogue().iter().cloned().chain(sums).collect()
}

/// Requires that a quarter of the error bound is unused.
#[test]
fn two_words_are_off_no_more_than_is_said() {
    const PRECISION: usize = 300;
    let formulas = formulas();
    for amplitude in amplitudes() {
        let quick = Quick::new(amplitude).unwrap();
        let swing = Swing::with_precision(amplitude, PRECISION);
        let exact = swing.exact_ratio();
        for formula in formulas.iter().filter(|formula| amplitude.radians() < formula.defined_below()) {
            let error = (formula.law().ratio(&quick.swing) - quick.exact) / quick.exact;
            let truth = (formula.law().ratio(&swing) - exact.clone()) / exact.clone();
            let off = (BigFloat::from_words(error, PRECISION) - truth).to_f64().abs();
            let said = quick.off(&error);
            assert!(off <= 0.75 * said, "{} {amplitude:?}: {off:e} {said:e}", formula.key());
        }
    }
}

/// Decisions in two words equal those of floats, for every formula, from the least to the largest amplitude for which two words are used.
#[test]
fn two_words_decide_as_floats_do() {
    let formulas = formulas();
    let (mut decided, mut asked) = (0, 0);
    for amplitude in amplitudes() {
        let mut exact = Exact::new(amplitude);
        for formula in formulas.iter().filter(|formula| amplitude.radians() < formula.defined_below()) {
            let quick = exact.quick.as_ref().and_then(|quick| quick.fractional_error(formula.law()));
            asked += 1;
            if let Some(quick) = quick {
                decided += 1;
                let floats = exact.fractional_error_in_floats(formula.law());
                assert_eq!(quick.to_bits(), floats.to_bits(), "{} {amplitude:?}", formula.key());
            }
        }
    }
    assert!(3 * decided > 2 * asked, "{decided} of {asked}");
}

/// One ulp on both sides of the limits of two words, amplitudes that need one step of the mean and ten, and elements without an amplitude next
/// to them.
#[test]
fn a_block_finds_what_one_amplitude_finds() {
    let beside = |x: f64| [x.next_down(), x, x.next_up()].map(DoubleDouble::from);
    let seams = beside(NEAREST_BOTTOM).map(SwingAmplitude::FromBottom);
    let seams = seams.into_iter().chain(beside(NEAREST_TOP).map(SwingAmplitude::FromTop));
    let all: Vec<_> = seams.chain(amplitudes()).map(Some).chain([None, None]).collect();
    let (mut inside, mut outside) = (0, 0);
    for seed in 0..7 {
        let start = all.iter().cycle().skip(seed).step_by(1 + 10 * seed).copied();
        for count in [1, 2, BLOCK - 1, BLOCK] {
            let block: Vec<_> = start.clone().take(count).collect();
            for (amplitude, quick) in block.iter().zip(Quick::block(&block)) {
                let one = amplitude.and_then(Quick::new);
                assert_eq!(one.map(words), quick.map(words), "{amplitude:?}");
                inside += usize::from(quick.is_some());
                outside += usize::from(quick.is_none());
            }
        }
    }
    assert!(inside > 700 && outside > 7, "{inside}, {outside}");
}

fn words(quick: Quick) -> [[u64; 2]; 5] {
    let Swing { amplitude, complement, cos_half, sin_half } = quick.swing;
    [amplitude, complement, cos_half, sin_half, quick.exact]
        .map(|number| [number.hi.to_bits(), number.lo.to_bits()])
}
