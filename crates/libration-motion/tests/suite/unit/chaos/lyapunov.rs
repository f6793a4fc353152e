//! Quantities computed from a record, and each of the conditions that prevent a false `Chaotic`, on constructed records.
#![expect(clippy::float_cmp, reason = "sums of small whole numbers are exact")]

use libration::chaos::{Doubt, LyapunovVerdict, Regularity};
use libration::internals::chaos::{Evidence, Record};
use libration::taylor::{Cause, Effort};

/// Number of intervals, of which the first eleventh is the beginning.
const INTERVALS: usize = 220;
const EFFORT: Effort = Effort::to_tolerance(1e-13);

/// A motion in [0, 1] whose deviation grows by these logarithms, one per interval.
fn evidence(growth: impl Fn(usize) -> f64) -> Evidence {
    wandering(growth, |_| 1.0)
}

/// A motion with such a deviation that is alternately at zero and at a given position.
fn wandering(growth: impl Fn(usize) -> f64, position: impl Fn(usize) -> f64) -> Evidence {
    let mut evidence = Evidence::new(1.0, 1);
    for n in 0..INTERVALS {
        evidence.add(growth(n), &[if n.is_multiple_of(2) { 0.0 } else { position(n) }], INTERVALS);
    }
    evidence
}

fn verdict(evidence: &Evidence) -> LyapunovVerdict {
    evidence.verdict(&EFFORT, &[false])
}

fn steady(_: usize) -> f64 {
    1.0
}

#[test]
fn steady_growth_on_a_bounded_motion_is_chaotic() {
    assert_eq!(verdict(&evidence(steady)), LyapunovVerdict::Chaotic);
}

#[test]
fn growth_below_e_to_the_hundred_is_too_short() {
    // After the beginning, which is not counted, there are 200 intervals.
    for (total, chaotic) in [(99.9, false), (100.1, true)] {
        let judged = verdict(&evidence(|_| total / 200.0));
        match judged {
            LyapunovVerdict::Chaotic => assert!(chaotic, "{total}"),
            LyapunovVerdict::Undecided(Doubt::TooShort { growth }) => {
                assert!(!chaotic && (growth - total).abs() < 1e-9, "{growth}");
            }
            other => panic!("{total}: {other:?}"),
        }
    }
}

#[test]
fn fewer_intervals_than_blocks_are_too_short_however_much_they_grow() {
    for (intervals, expected) in [(10, false), (11, true)] {
        let mut evidence = Evidence::new(1.0, 1);
        for n in 0..intervals {
            evidence.add(50.0, &[if n % 2 == 0 { 0.0 } else { 1.0 }], intervals);
        }
        assert_eq!(verdict(&evidence) == LyapunovVerdict::Chaotic, expected, "{intervals}");
        let short = matches!(verdict(&evidence), LyapunovVerdict::Undecided(Doubt::TooShort { .. }));
        assert_eq!(short, !expected);
    }
}

#[test]
fn deep_valleys_lose_the_digits() {
    // The logarithm rises by four more than it falls, so that every block grows. ln √(10⁻³/10⁻¹³) is 11.51, ln √(10⁻³/10⁻¹⁵) is 13.8.
    let with_valleys = |depth: f64| evidence(move |n| if n.is_multiple_of(2) { depth + 4.0 } else { -depth });
    assert_eq!(verdict(&with_valleys(11.5)), LyapunovVerdict::Chaotic);
    let LyapunovVerdict::Undecided(Doubt::DigitsLost { valley }) = verdict(&with_valleys(11.53)) else {
        panic!()
    };
    assert!((valley - 11.53).abs() < 1e-9, "{valley}");
    let finer = Effort::to_tolerance(1e-15);
    assert_eq!(with_valleys(13.7).verdict(&finer, &[false]), LyapunovVerdict::Chaotic);
    assert!(matches!(
        with_valleys(13.9).verdict(&finer, &[false]),
        LyapunovVerdict::Undecided(Doubt::DigitsLost { .. })
    ));
    // No tolerance reduces the rounding errors.
    let finest = Effort::to_tolerance(1e-18);
    assert!(matches!(
        with_valleys(14.7).verdict(&finest, &[false]),
        LyapunovVerdict::Undecided(Doubt::DigitsLost { .. })
    ));
    // One valley has the same effect as many.
    let once = evidence(|n| if n == 120 { -12.0 } else { 1.0 });
    assert!(matches!(verdict(&once), LyapunovVerdict::Undecided(Doubt::DigitsLost { .. })));
}

#[test]
fn motions_that_go_farther_and_farther_are_unbounded() {
    let widening = |factor: f64| wandering(steady, move |n| if 2 * n < INTERVALS { 1.0 } else { factor });
    assert_eq!(verdict(&widening(1.49)), LyapunovVerdict::Chaotic);
    assert_eq!(verdict(&widening(1.51)), LyapunovVerdict::Undecided(Doubt::Unbounded));
    // An angle may increase without bound.
    assert_eq!(widening(1.51).verdict(&EFFORT, &[true]), LyapunovVerdict::Chaotic);
    assert_eq!(verdict(&wandering(steady, |n| if n < 10 { 3.0 } else { 1.0 })), LyapunovVerdict::Chaotic);
    // A motion that begins to move late is not bounded by its earlier positions.
    let late = wandering(steady, |n| if 2 * n < INTERVALS { 0.0 } else { 1.0 });
    assert_eq!(verdict(&late), LyapunovVerdict::Undecided(Doubt::Unbounded));
}

#[test]
fn growth_that_pauses_is_unsteady() {
    // One block of twenty intervals has a growth slightly above or below zero.
    let pausing = |rate: f64| evidence(move |n| if (100..120).contains(&n) { rate } else { 2.0 });
    assert_eq!(verdict(&pausing(-0.1)), LyapunovVerdict::Undecided(Doubt::Unsteady));
    assert_eq!(verdict(&pausing(0.1)), LyapunovVerdict::Chaotic);
    // All growth is in two blocks: the mean is not five errors from zero.
    let once = evidence(|n| if n >= 180 { 4.0 } else { 0.01 });
    assert_eq!(verdict(&once), LyapunovVerdict::Undecided(Doubt::Unsteady));
}

#[test]
fn growth_in_proportion_to_the_time_is_slow() {
    let power = |p: f64| {
        evidence(move |n| {
            let [before, after] = [n, n + 1].map(|n| 1.0 + f64::from(u32::try_from(n).unwrap()));
            p * libm::log(after / before)
        })
    };
    let LyapunovVerdict::Regular(Regularity::Slow { below }) = verdict(&power(1.0)) else { panic!() };
    // The logarithm changes by 2·1.5 in the measured time.
    assert!((below - 3.0 / 220.0).abs() < 1e-15, "{below}");
    assert!(matches!(verdict(&power(2.1)), LyapunovVerdict::Regular(_)));
    assert!(matches!(verdict(&power(2.4)), LyapunovVerdict::Undecided(Doubt::TooShort { .. })));
    // The motion is fast in one half only.
    let late = evidence(|n| if n >= 110 { 1.0 } else { 0.0 });
    assert!(!matches!(verdict(&late), LyapunovVerdict::Regular(_)));
    let early = evidence(|n| if (55..110).contains(&n) { 1.0 } else { 0.0 });
    assert!(!matches!(verdict(&early), LyapunovVerdict::Regular(_)));
}

#[test]
fn shrinking_deviations_converge_if_they_do_in_every_block() {
    assert_eq!(verdict(&evidence(|_| -0.01)), LyapunovVerdict::Regular(Regularity::Converging));
    let pausing = evidence(|n| if (100..120).contains(&n) { 0.001 } else { -0.01 });
    assert!(matches!(verdict(&pausing), LyapunovVerdict::Regular(Regularity::Slow { .. })));
}

#[test]
fn a_motion_that_stopped_shows_nothing() {
    let mut stopped = evidence(steady);
    stopped.stopped = Some(Cause::Singularity);
    assert_eq!(verdict(&stopped), LyapunovVerdict::Undecided(Doubt::Stopped(Cause::Singularity)));
}

#[test]
fn exponents_agree_within_half_of_the_larger_and_five_errors() {
    let [one, half, less] = [1.0, 0.51, 0.49].map(|rate| evidence(move |_| rate));
    assert!(one.agrees_with(&half) && half.agrees_with(&one));
    assert!(!one.agrees_with(&less) && !less.agrees_with(&one));
    let noisy = evidence(|n| if (n / 20).is_multiple_of(2) { 0.2 } else { 0.6 });
    assert!(noisy.record.uncertainty() > 0.05 && one.agrees_with(&noisy));
}

/// A record with intervals of length two and these logarithms.
fn record(growths: &[f64]) -> Record {
    let mut record = Record::new(2.0);
    growths.iter().for_each(|growth| record.push(*growth));
    record
}

#[test]
fn rates_leave_the_beginning_out() {
    let record = record(&[[7.0; 2].as_slice(), &[1.0; 20]].concat());
    assert_eq!((record.intervals(), record.exponent(), record.growth()), (22, 0.5, 20.0));
    assert_eq!(record.blocks(), [0.5; 10]);
    assert_eq!((record.uncertainty(), record.duration()), (0.0, 44.0));
    let (times, rates): (Vec<f64>, Vec<f64>) = record.convergence().unzip();
    assert_eq!(times, [2.0, 4.0, 6.0, 8.0, 10.0, 14.0, 18.0, 22.0, 28.0, 34.0, 42.0, 44.0]);
    assert_eq!((rates[0], rates[11]), (3.5, 0.5));
}

#[test]
fn the_error_of_a_rate_is_that_of_the_blocks_or_what_the_second_half_changes() {
    // Blocks of two intervals of length two: alternating rates 1 and 0, with the mean 1/2; √(10·(1/4)/90) = 1/6.
    let in_turns = record(&(0..22).map(|n| if (n / 2) % 2 == 1 { 2.0 } else { 0.0 }).collect::<Vec<_>>());
    assert!((in_turns.uncertainty() - 1.0 / 6.0).abs() < 1e-15, "{}", in_turns.uncertainty());
    // No growth in the first half: nine intervals of 0 up to the eleventh, and the other eleven of 2.
    let late = record(&(0..22).map(|n| if n < 11 { 0.0 } else { 2.0 }).collect::<Vec<_>>());
    assert!((late.uncertainty() - late.exponent()).abs() < 1e-15 && (late.exponent() - 0.55).abs() < 1e-15);
    assert_eq!(record(&[1.0; 10]).uncertainty(), f64::INFINITY);
}

/// Deviations of integrable motions grow like the time: the exponent is zero, though the rate is ln(11)/10 of the first interval.
#[test]
fn an_exponent_that_a_power_of_the_time_explains_may_be_zero() {
    for power in [-1.5, 1.0, 2.0] {
        let growths: Vec<f64> = (0..330).map(|n| power * libm::log1p(1.0 / (1.0 + f64::from(n)))).collect();
        let algebraic = record(&growths);
        assert!(algebraic.uncertainty() >= algebraic.exponent().abs(), "{power}");
    }
    assert_eq!(record(&[0.0625; 330]).uncertainty(), 0.0);
}

#[test]
fn valleys_and_rises_are_measured_from_rim_to_rim() {
    let valley = record(&[5.0, -3.0, 1.0, -4.0, 2.0, 8.0, -1.0]);
    // Levels 0, 5, 2, 3, −1, 1, 9, 8: from 5 down to −1 and up again; the end is not a valley.
    assert_eq!(valley.deepest_valley(), 6.0);
    assert_eq!(record(&[-5.0, 3.0]).deepest_valley(), 3.0);
    assert_eq!(record(&[1.0, -2.0]).deepest_valley(), 0.0);
    // Levels 0, 1, 4, 3, 9 : the quarters end at 1, 2, 3 and 4.
    assert_eq!(record(&[1.0, 3.0, -1.0, 6.0]).rises(), [5.0, 3.0]);
}
