//! Periods against length: lines with known g and offset, and what bends them.

use std::f64::consts::TAU;

use libration::fit::{FitError, LengthColumns, LengthModel, LengthTable, LengthsFit, lengths};
use libration::pendulum::period_ratio;
use libration::quantity::Quantity;

use crate::random::Random;
use crate::synthetic_trace::normal;

const G: f64 = 9.81;

fn ten_lengths() -> Vec<f64> {
    (1..=10).map(|k| 0.12 * f64::from(k)).collect()
}

/// T of a ball of this radius whose centre is so much below the end of the length.
fn period(length: f64, offset: f64, radius: f64) -> f64 {
    let whole = length + offset;
    TAU * ((whole + 0.4 * radius * radius / whole) / G).sqrt()
}

fn table(lengths: &[f64], periods: &[f64], sigma: Option<&[f64]>) -> LengthTable {
    let columns = LengthColumns { lengths, periods, period_uncertainties: sigma, ..LengthColumns::default() };
    LengthTable::new(&columns).unwrap()
}

fn fitted(lengths_given: &[f64], periods: &[f64], radius: Option<f64>) -> LengthsFit {
    let sigma = vec![1e-3; periods.len()];
    lengths(&table(lengths_given, periods, Some(&sigma)), radius).unwrap()
}

#[test]
fn a_line_gives_its_g_and_its_offset_back() {
    let given = ten_lengths();
    let periods: Vec<f64> = given.iter().map(|&length| period(length, -0.0086, 0.0)).collect();
    let fit = fitted(&given, &periods, None);
    let best = fit.best();
    assert!((best.g.value / G - 1.0).abs() < 1e-12 && (best.offset.unwrap().value + 0.0086).abs() < 1e-12);
    // Without an offset g is wrong, and that is said.
    assert!((fit.of(LengthModel::Plain).unwrap().g.value / G - 1.0).abs() > 3e-3);
    assert!(fit.warnings.iter().any(|warning| warning.contains("offset is needed")), "{:?}", fit.warnings);
}

#[test]
fn a_large_bob_bends_the_line_and_is_told_by_it() {
    let (given, radius) = (ten_lengths(), 0.06);
    let periods: Vec<f64> = given.iter().map(|&length| period(length, 0.02, radius)).collect();
    let known = fitted(&given, &periods, Some(radius));
    assert!((known.best().g.value / G - 1.0).abs() < 1e-9, "{:?}", known.best());
    assert!((known.best().offset.unwrap().value - 0.02).abs() < 1e-9);
    let free = fitted(&given, &periods, None);
    let bent = free.of(LengthModel::OffsetAndGyration).unwrap();
    assert!((bent.gyration.unwrap().value / (0.4 * radius * radius) - 1.0).abs() < 1e-6, "{bent:?}");
    assert!((bent.g.value / G - 1.0).abs() < 1e-7);
    assert!(free.warnings.iter().any(|warning| warning.contains("radius 60.0 mm")), "{:?}", free.warnings);
}

#[test]
fn large_swings_are_brought_back_to_small_ones() {
    let given = ten_lengths();
    let amplitude = 0.5;
    let periods: Vec<f64> =
        given.iter().map(|&length| period(length, 0.0, 0.0) * period_ratio(amplitude)).collect();
    let columns = LengthColumns {
        lengths: &given,
        periods: &periods,
        amplitudes: &[Quantity { value: amplitude, uncertainty: None }],
        ..LengthColumns::default()
    };
    let fit = lengths(&LengthTable::new(&columns).unwrap(), None).unwrap();
    assert!((fit.best().g.value / G - 1.0).abs() < 1e-12);
}

/// In 400 tables with noise in both columns the truth is within one uncertainty in 68 % and within two in 95 %, with binomial
/// standard deviations of 2.3 % and 1.1 %.
#[test]
fn uncertainties_hold_the_truth_as_often_as_they_say() {
    let mut random = Random::seeded(11);
    let (of_length, of_period) = (0.002, 0.004);
    let mut within = [[0_u32; 2]; 2];
    for _ in 0..400 {
        let truth: Vec<f64> = (0..15).map(|_| random.between(0.2, 1.5)).collect();
        let periods: Vec<f64> =
            truth.iter().map(|&length| period(length, 0.01, 0.0) + of_period * normal(&mut random)).collect();
        let given: Vec<f64> = truth.iter().map(|&length| length + of_length * normal(&mut random)).collect();
        let columns = LengthColumns {
            lengths: &given,
            periods: &periods,
            length_uncertainties: Some(&[of_length; 15]),
            period_uncertainties: Some(&[of_period; 15]),
            amplitudes: &[],
        };
        let fit = lengths(&LengthTable::new(&columns).unwrap(), None).unwrap();
        let best = fit.best();
        let offset = best.offset.unwrap();
        let errors = [
            (best.g.value - G) / best.g.uncertainty.unwrap(),
            (offset.value - 0.01) / offset.uncertainty.unwrap(),
        ];
        for (counts, error) in within.iter_mut().zip(errors) {
            counts[0] += u32::from(error.abs() < 1.0);
            counts[1] += u32::from(error.abs() < 2.0);
        }
    }
    for [one, two] in within {
        assert!((245..=300).contains(&one) && (366..=392).contains(&two), "{within:?}");
    }
}

#[test]
fn an_offset_that_is_not_there_is_not_called_needed() {
    let mut random = Random::seeded(3);
    let given = ten_lengths();
    let mut needed = 0;
    for _ in 0..200 {
        let noisy = |length: &f64| period(*length, 0.0, 0.0) + 0.003 * normal(&mut random);
        let periods: Vec<f64> = given.iter().map(noisy).collect();
        let fit = lengths(&table(&given, &periods, None), None).unwrap();
        needed += u32::from(fit.of(LengthModel::Offset).unwrap().chance.unwrap() < 0.05);
    }
    // 5 % of 200 are 10, with a standard deviation of 3.
    assert!((2..=20).contains(&needed), "{needed}");
}

#[test]
fn tables_that_tell_nothing_are_refused() {
    let refuse = |given: &[f64], periods: &[f64]| {
        let columns = LengthColumns { lengths: given, periods, ..LengthColumns::default() };
        LengthTable::new(&columns).and_then(|table| lengths(&table, None)).unwrap_err()
    };
    assert_eq!(refuse(&[1.0, 1.0, 1.0], &[2.0, 2.01, 2.02]), FitError::EqualLengths);
    assert!(matches!(refuse(&[1.0], &[2.0]), FitError::TooFewRows { .. }));
    assert!(matches!(refuse(&[1.0, -1.0], &[2.0, 2.0]), FitError::LengthOfRow { row: 2, .. }));
    assert!(matches!(refuse(&[1.0, 2.0], &[2.0, 0.0]), FitError::Period { row: 2, .. }));
    assert!(matches!(refuse(&[1.0, 2.0], &[2.0]), FitError::LengthMismatch { .. }));
}
