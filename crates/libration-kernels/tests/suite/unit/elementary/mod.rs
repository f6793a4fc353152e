//! The kernels against the multi-precision library, whose functions agree with MPFR.

mod rough;

use libration::double_double::{DoubleDouble, two_prod};
use libration::elementary::{
    LARGEST_ANGLE, atan_of_ratio, exp, fine_logarithm, fine_sin_cos, sin_cos, sin_cos_of_turns, sinh_cosh,
    split_logarithm, two_word,
};
use libration::internals::elementary::reciprocal;
use libration_numbers::algebra::BigFloat;

const BITS: usize = 300;

fn big(x: DoubleDouble) -> BigFloat {
    BigFloat::from_words(x, BITS)
}

fn word(x: f64) -> BigFloat {
    big(DoubleDouble::from(x))
}

/// |got/exact − 1|.
fn relative(got: DoubleDouble, exact: &BigFloat) -> f64 {
    ((big(got) - exact.clone()) / exact.clone()).to_f64().abs()
}

/// Irregular numbers in (0, 1).
fn uniform() -> impl Iterator<Item = f64> {
    (1..=2000).map(|i| (f64::from(i) * 0.618_033_988_749_894_8).fract())
}

fn worst(errors: impl Iterator<Item = f64>) -> f64 {
    errors.fold(0.0, f64::max)
}

#[test]
fn sine_and_cosine_of_turns_are_good_to_fifty_four_bits() {
    let tau = BigFloat::pi(BITS) + BigFloat::pi(BITS);
    let error = worst(uniform().map(|x| {
        let y = DoubleDouble::new((x - 0.5) / 4.0, (x - 0.3) * 1e-18);
        let (sin, cos) = sin_cos_of_turns(y);
        let angle = big(y) * tau.clone();
        relative(sin, &angle.sin()).max(relative(cos, &angle.cos()))
    }));
    assert!(error < libm::exp2(-54.0), "{error:e}");
}

/// The largest error in units in the last place, and the number of values that are not correctly rounded.
fn rounding(angles: impl Iterator<Item = f64>) -> (f64, f64) {
    let (mut worst, mut wrong, mut all) = (0.0_f64, 0.0, 0.0);
    for x in angles {
        let (sin, cos) = sin_cos(x);
        for (got, exact) in [(sin, word(x).sin()), (cos, word(x).cos())] {
            let ulp = got.abs().next_up() - got.abs();
            worst = worst.max((word(got) - exact.clone()).to_f64().abs() / ulp);
            all += 1.0;
            wrong += if got.to_bits() == exact.to_f64().to_bits() { 0.0 } else { 1.0 };
        }
    }
    (worst, wrong / all)
}

#[test]
fn sine_and_cosine_of_angles_are_next_to_the_exact_ones() {
    let (worst, wrong) =
        rounding(uniform().flat_map(|part| [1e-3, 1.0, 8.0, 1e3, LARGEST_ANGLE].map(|most| part * most)));
    assert!(worst < 0.8 && wrong < 0.02, "{worst} {wrong}");
}

/// Angles next to multiples of π/4, where the sine, the cosine or the choice between them changes.
#[test]
fn sine_and_cosine_next_to_eighths_of_a_turn_keep_their_relative_accuracy() {
    let eighths =
        (0..2000).chain([100_000, 777_777, 1_335_088]).map(|n| std::f64::consts::FRAC_PI_4 * f64::from(n));
    let beside = eighths.flat_map(|x| [x, x.next_up(), x.next_down(), -x, -x.next_up()]);
    let (worst, _) = rounding(beside.filter(|x| x.abs() > 0.0 && x.abs() <= LARGEST_ANGLE));
    assert!(worst < 0.8, "{worst}");
    let zeros = [0.0, -0.0].map(|x: f64| sin_cos(x));
    assert_eq!(
        zeros.map(|(sin, cos)| (sin.to_bits(), cos.to_bits())),
        [(0, 1.0_f64.to_bits()), ((-0.0_f64).to_bits(), 1.0_f64.to_bits())]
    );
    assert_eq!(sin_cos(5e-324).0.to_bits(), 1);
}

#[test]
fn the_sine_of_a_tiny_turn_keeps_its_relative_accuracy() {
    for exponent in [-20, -100, -300] {
        let y = libm::exp10(f64::from(exponent));
        let (sin, _) = sin_cos_of_turns(DoubleDouble::from(y));
        assert!(relative(sin, &(word(y) * (BigFloat::pi(BITS) + BigFloat::pi(BITS)))) < libm::exp2(-55.0));
    }
}

#[test]
fn hyperbolic_sine_and_cosine_are_good_to_their_last_bit() {
    let error = worst(uniform().flat_map(|x| [x * 1e-9, x, 5.0 * x, 690.0 * x]).map(|z| {
        let z = DoubleDouble::new(z, z * 1e-17);
        let (sinh, cosh) = sinh_cosh(z);
        let power = big(z).exp();
        let inverse = word(1.0) / power.clone();
        let exact_sinh = (power.clone() - inverse.clone()).halved();
        relative(sinh, &exact_sinh).max(relative(cosh, &(power + inverse).halved()))
    }));
    // Near 2²⁷ the halves 2ⁿ⁻¹ ± 2⁻ⁿ⁻¹ are themselves rounded.
    assert!(error < libm::exp2(-52.5), "{error:e}");
}

#[test]
fn the_arctangent_of_a_ratio_inverts_the_tangent() {
    let error = worst(uniform().flat_map(|x| [x, x * 1e-12]).map(|small| {
        let small = DoubleDouble::new(small, small * 1e-17);
        let angle = atan_of_ratio(small, DoubleDouble::ONE);
        let exact = big(angle);
        // The error of the angle, to first order tan(exact − angle).
        let missing = (big(small) * exact.cos() - exact.sin()) / (exact.cos() + big(small) * exact.sin());
        (missing.to_f64() / angle.hi).abs()
    }));
    assert!(error < libm::exp2(-54.0), "{error:e}");
}

#[test]
fn reciprocals_are_good_to_52_bits() {
    let ends = [1.0 + 0.5_f64.sqrt(), 1.0 + 2.0_f64.sqrt()];
    let between = uniform().map(|part| ends[0] + part * (ends[1] - ends[0]));
    let error = worst(between.chain(ends).map(|x| {
        let exact = word(1.0) / word(x);
        (word(reciprocal(x)) - exact.clone()).to_f64().abs() / (exact.to_f64() * f64::EPSILON)
    }));
    assert!(error < 1.2, "{error}");
}

#[test]
fn the_split_logarithm_is_good_to_fifty_eight_bits() {
    let ln_2 = word(2.0).ln();
    let error = worst(uniform().flat_map(|x| [x, 1e-300 * x, 3.0 * x]).map(|x| {
        let x = DoubleDouble::new(x, x * 1e-17);
        let log = split_logarithm(x);
        let sum = word(log.exponent) * ln_2.clone() + word(log.leading) + word(log.tail);
        (sum - big(x).ln()).to_f64().abs()
    }));
    assert!(error < libm::exp2(-58.0), "{error:e}");
}

#[test]
fn the_fine_logarithm_is_good_to_a_hundred_bits() {
    // Also next to one, √½ and √2, the ends of the fraction's range.
    let seams = [1.0, 1.0_f64.next_up(), 1.0_f64.next_down(), 0.7071067811865475, 0.7071067811865476];
    let points = uniform().flat_map(|x| [x, 1e-300 * x, 3.0 * x, 1e300 * x, 1.0 + 1e-9 * x]).chain(seams);
    let ln_2 = word(2.0).ln();
    for x in points.flat_map(|x| [x, 2.0 * x]) {
        let x = DoubleDouble::new(x, x * 1e-17);
        let log = fine_logarithm(x);
        let exact = big(x).ln() - word(log.exponent) * ln_2.clone();
        assert!(relative(log.fraction, &exact) < libm::exp2(-100.0), "{x:?}");
        assert!(log.fraction.hi.abs() < 0.34658, "{x:?}");
    }
}

#[test]
fn the_exponential_is_good_to_seventy_eight_bits() {
    let error = worst(uniform().flat_map(|x| [x - 0.5, -3.2 * x, 1e-9 * x, 600.0 * (x - 0.5)]).map(|x| {
        let x = DoubleDouble::new(x, x * 1e-17);
        relative(exp(x), &big(x).exp())
    }));
    assert!(error < libm::exp2(-78.0), "{error:e}");
}

#[test]
fn fine_sine_and_cosine_are_good_to_fifty_nine_bits() {
    let error = worst(uniform().flat_map(|x| [x, 1e-9 * x, 1e-200 * x]).map(|x| {
        let r = DoubleDouble::new(1.571 * (x - 0.5), x * 1e-17);
        let (sin, cos) = fine_sin_cos(r);
        relative(sin, &big(r).sin()).max(relative(cos, &big(r).cos()))
    }));
    assert!(error < libm::exp2(-59.0), "{error:e}");
}

#[test]
fn two_word_functions_are_good_to_a_hundred_bits() {
    let bound = libm::exp2(-100.0);
    for x in uniform() {
        let x = two_prod(x, 1.0 + 1e-9);
        let (sin, cos) = two_word::sin_cos(x.scaled(1.5));
        let angle = big(x.scaled(1.5));
        assert!(relative(sin, &angle.sin()) < bound);
        assert!(relative(cos, &angle.cos()) < bound);
        // The absolute error of the exponent is the relative error of the power.
        assert!(relative(two_word::exp(x * -300.0), &big(x * -300.0).exp()) < 300.0 * bound);
        assert!((big(two_word::ln(x)) - big(x).ln()).to_f64().abs() < bound);
    }
}

#[test]
fn the_two_word_logarithm_keeps_its_digits_among_the_smallest_numbers() {
    for x in
        [5e-324, 1.5e-323, 1e-310, f64::MIN_POSITIVE, 1e-300, 0.7071067811865475, 0.7071067811865476, 1e308]
    {
        let error = (big(two_word::ln(DoubleDouble::from(x))) - word(x).ln()).to_f64().abs();
        // 2⁻¹⁰⁰ of the largest logarithm.
        assert!(error < 745.0 * libm::exp2(-100.0), "{x:e}: {error:e}");
    }
}

#[test]
fn the_two_word_power_is_rounded_once_among_the_smallest_numbers() {
    for x in [-700.1, -708.3, -708.4, -720.5, -744.4, -745.1, -745.2] {
        let exact = word(x).exp();
        let smallest = word(f64::from_bits(1));
        let error =
            ((word(two_word::exp(DoubleDouble::from(x)).to_f64()) - exact.clone()) / smallest).to_f64().abs();
        // Half of the smallest number, or half an ulp if that is larger.
        let ulp = (exact * word(f64::EPSILON) / word(f64::from_bits(1))).to_f64();
        assert!(error <= 0.5 * ulp.max(1.0) + 1e-9, "{x}: {error}");
    }
}

#[test]
fn the_two_word_arctangent_has_the_sine_and_cosine_of_its_point() {
    let bound = libm::exp2(-100.0);
    for x in uniform() {
        let angle = DoubleDouble::new(6.28 * (x - 0.5), 1e-17 * x);
        let (sin, cos) = (big(angle).sin(), big(angle).cos());
        let words = |value: &BigFloat| {
            let hi = value.to_f64();
            DoubleDouble::new(hi, (value.clone() - word(hi)).to_f64())
        };
        let computed = two_word::atan2(words(&sin), words(&cos));
        assert!(((computed - angle).to_f64() / angle.hi).abs() < bound, "{angle:?} {computed:?}");
    }
}
