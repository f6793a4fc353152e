//! Proven remainders of period and frequency for polynomial forces, compared with the integrated motion.

use crate::typed::oscillator;
use libration::comparison::{ExactMotion, SeriesComparison, SeriesQuantity};
use libration::oscillator::Oscillator;
use libration::perturbation::{Certainty, Gauge, PeriodMajorant, expand};
use libration::progress::Quiet;
use libration::quantity::Displacement;

/// Fractions of the limit, and the motion at each, which does not depend on the order of a series.
fn motions<const N: usize>(oscillator: &Oscillator, limit: f64, shares: [f64; N]) -> [(f64, ExactMotion); N] {
    let expansion = expand(oscillator, 3, &Gauge::Fundamental, &Quiet).unwrap();
    shares.map(|share| {
        let amplitude = Displacement::from_f64(share * limit).unwrap();
        (share, ExactMotion::new(oscillator, &expansion, &amplitude, &Quiet).unwrap())
    })
}

/// The force, and the amplitude at which Σ |cₘ| A^(2m−2) is one.
const FORCES: [(&str, f64); 7] = [
    ("x'' = -x + x^3", 1.0),
    ("x'' = -x - x^3", 1.0),
    ("x'' = -4*x - 9*x^3", 2.0 / 3.0),
    ("x'' = -x + x^5", 1.0),
    ("x'' = -x + x^3/2 - x^5/2", 1.0),
    ("x'' = -x - x^3/4 + x^5/4 - x^7/2", 1.0),
    ("x'' = -1000*x - 1000000*x^3", 0.031_622_776_601_683_79),
];

#[test]
fn the_error_is_below_the_bound_up_to_the_limit() {
    for (equation, limit) in FORCES {
        let oscillator = oscillator(equation);
        let motions = motions(&oscillator, limit, [1e-3, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.9999]);
        for order in [5, 15, 41] {
            let expansion = expand(&oscillator, order, &Gauge::Fundamental, &Quiet).unwrap();
            let period = SeriesComparison::new(&oscillator, &expansion, SeriesQuantity::Period);
            for (share, motion) in &motions {
                let amplitude = share * limit;
                let exact = motion.value(SeriesQuantity::Period).unwrap();
                for step in period.evaluation_at(amplitude).steps() {
                    let remainder = step.remainder;
                    assert_eq!(remainder.certainty, Certainty::Proven);
                    let error = (step.sum - exact.value).abs() - exact.uncertainty - 2.0 * f64::EPSILON;
                    assert!(error <= remainder.size, "{equation} {order} {amplitude} {step:?}: {error:e}");
                    // Not far above it where the bounding oscillator is the oscillator itself.
                    if equation == FORCES[0].0 && error > 1e-7 {
                        assert!(remainder.size < 1.02 * error, "{order} {amplitude} {step:?}: {error:e}");
                    }
                }
            }
        }
    }
}

/// Amplitudes at the limit and one ulp next to it.
#[test]
fn there_is_no_bound_from_the_limit_on() {
    let force = ["1", "0", "-1"].map(|text| text.parse().unwrap());
    let majorant = PeriodMajorant::new(&force, 9).unwrap();
    assert!(majorant.period_at(1.0 - 1e-12).after(8).is_finite());
    // One ulp below it rounding may leave none.
    assert!(majorant.period_at(1.0_f64.next_down()).after(8) > majorant.period_at(1.0 - 1e-12).after(8));
    for amplitude in [1.0, 1.0_f64.next_up(), 1e300, f64::INFINITY] {
        assert_eq!(majorant.period_at(amplitude).after(8), f64::INFINITY);
    }
    assert!(majorant.period_at(f64::NAN).after(8).is_nan());
    assert!(majorant.period_at(0.0).after(8) < f64::MIN_POSITIVE);
    assert!(majorant.period_at(-0.5).after(8) > 0.0);
    for (force, is_one) in [
        (["1", "1", "0"], true),
        (["1", "-1", "-3"], true),
        (["1", "0", "0"], false),
        (["-1", "0", "1"], false),
        (["2", "0", "-1"], true),
    ] {
        let force = force.map(|text| text.parse().unwrap());
        assert_eq!(PeriodMajorant::new(&force, 9).is_some(), is_one, "{force:?}");
    }
}

/// Forces with even terms, and the amplitude above which there is no bound: in the second by mpmath, in the others by hand.
const ANY_FORCES: [(&str, f64); 5] = [
    // −x − x² has its separatrix at x = −1, of the energy 1/6, which x = 1/2 has too.
    ("x'' = -x - x^2", 0.5),
    ("x'' = -x - x^2 - x^3", 0.343_165_905_637_405_38),
    ("x'' = -x + x^2", 0.5),
    ("x'' = -4*x + 400*x^2", 0.005),
    ("x'' = -x + x^4", 0.722_119_908_924_835_2),
];

#[test]
fn the_error_is_below_the_bound_for_any_polynomial_force() {
    for (equation, limit) in ANY_FORCES {
        let oscillator = oscillator(equation);
        let motions = motions(&oscillator, limit, [1e-3, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.9999]);
        for order in [6, 15, 31] {
            let expansion = expand(&oscillator, order, &Gauge::Fundamental, &Quiet).unwrap();
            for (quantity, shares) in
                [(SeriesQuantity::Period, &motions[..]), (SeriesQuantity::Frequency, &motions[..5])]
            {
                let series = SeriesComparison::new(&oscillator, &expansion, quantity);
                for (share, motion) in shares {
                    let exact = motion.value(quantity).unwrap();
                    let evaluation = series.evaluation_at(share * limit);
                    for step in evaluation.steps() {
                        assert_eq!(step.remainder.certainty, Certainty::Proven, "{equation} {share}");
                        let error = (step.sum - exact.value).abs() - exact.uncertainty - 2.0 * f64::EPSILON;
                        assert!(
                            error <= step.remainder.size,
                            "{equation} {order} {share} {step:?}: {error:e}"
                        );
                    }
                    // In units of the limit no coefficient of the bounding T/T0 is above one.
                    let last = evaluation.steps().last().unwrap();
                    let geometric =
                        libm::pow(*share, f64::from(u32::try_from(last.power + 1).unwrap())) / (1.0 - share);
                    let enough = quantity == SeriesQuantity::Frequency || last.remainder.size < geometric;
                    assert!(enough, "{equation} {order} {share} {last:?}");
                }
            }
            let period = SeriesComparison::new(&oscillator, &expansion, SeriesQuantity::Period);
            // The limits are typed to sixteen digits, and found to a bit.
            for amplitude in [limit * (1.0 + 4.0 * f64::EPSILON), 1.0001 * limit, 1e300, f64::INFINITY] {
                let steps = period.evaluation_at(amplitude);
                assert!(steps.steps().iter().all(|step| step.remainder.certainty == Certainty::Estimated));
            }
            let nearest = period.evaluation_at(limit * (1.0 - 1e-12));
            let proven = |certainty| certainty == Certainty::Proven;
            assert!(
                nearest.steps().iter().all(|step| proven(step.remainder.certainty)),
                "{equation} {order}"
            );
        }
    }
}

/// A bound whose bounding well is the well itself differs from the remainder only by the signs of S²(A).
#[test]
fn the_bound_of_an_asymmetric_well_is_near_what_is_missing() {
    let oscillator = oscillator("x'' = -x + x^2");
    let expansion = expand(&oscillator, 8, &Gauge::Fundamental, &Quiet).unwrap();
    let period = SeriesComparison::new(&oscillator, &expansion, SeriesQuantity::Period);
    for amplitude in [0.05, 0.2, 0.4] {
        let missing =
            period.exact_at(amplitude, &Quiet).unwrap().value - period.evaluation_at(amplitude).value();
        let bound = period.evaluation_at(amplitude).steps().last().unwrap().remainder.size;
        assert!(missing > 0.0 && bound < 7.0 * missing, "{amplitude}: {missing:e} {bound:e}");
    }
}
