//! Periods against length: lines with known g and offset, and effects that bend them.

use std::f64::consts::TAU;

use libration::pendulum::period_ratio;
use libration::quantity::Quantity;
use libration_lab::fit::{
    Bob, BobShape, BudgetInput, Corrections, FitError, GravityMistake, LengthColumns, LengthModel,
    LengthTable, LengthsFit, LengthsOptions, LengthsPendulum, LengthsWarning, fit_lengths,
};

use libration_testing::sweep::{self, Limits};

use crate::random::Random;
use crate::synthetic_trace::normal;

const G: f64 = 9.81;

fn exactly(value: f64) -> Quantity {
    Quantity { value, uncertainty: None }
}

/// Options with a ball of this radius.
fn with_ball(radius: Quantity) -> LengthsOptions {
    let corrections = Corrections { bob: Some(Bob::ball(radius)), ..Corrections::default() };
    LengthsOptions { corrections, ..LengthsOptions::default() }
}

fn ten_lengths() -> Vec<f64> {
    (1..=10).map(|k| 0.12 * f64::from(k)).collect()
}

/// T of a ball of this radius whose centre is this far below the end of the length.
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
    let options = radius.map_or_else(LengthsOptions::default, |value| with_ball(exactly(value)));
    fit_lengths(&table(lengths_given, periods, Some(&sigma)), &options).unwrap()
}

#[test]
fn a_line_gives_its_g_and_its_offset_back() {
    let given = ten_lengths();
    let periods: Vec<f64> = given.iter().map(|&length| period(length, -0.0086, 0.0)).collect();
    let fit = fitted(&given, &periods, None);
    let best = fit.best();
    assert!((best.g.value / G - 1.0).abs() < 1e-12 && (best.offset.unwrap().value + 0.0086).abs() < 1e-12);
    // Without an offset g is wrong, and that is said.
    assert!((fit.law(LengthModel::Plain).unwrap().g.value / G - 1.0).abs() > 3e-3);
    assert!(fit.warnings.contains(&LengthsWarning::OffsetNeeded), "{:?}", fit.warnings);
}

#[test]
fn a_large_bob_bends_the_line_and_is_told_by_it() {
    let (given, radius) = (ten_lengths(), 0.06);
    let periods: Vec<f64> = given.iter().map(|&length| period(length, 0.02, radius)).collect();
    let with_radius = fitted(&given, &periods, Some(radius));
    assert!((with_radius.best().g.value / G - 1.0).abs() < 1e-9, "{:?}", with_radius.best());
    assert!((with_radius.best().offset.unwrap().value - 0.02).abs() < 1e-9);
    let free = fitted(&given, &periods, None);
    let bent = free.law(LengthModel::OffsetAndGyration).unwrap();
    assert!((bent.gyration.unwrap().value / (0.4 * radius * radius) - 1.0).abs() < 1e-6, "{bent:?}");
    assert!((bent.g.value / G - 1.0).abs() < 1e-7);
    let bends = free.warnings.iter().find(|warning| matches!(warning, LengthsWarning::Bent { .. })).unwrap();
    assert!(bends.to_string().contains("radius 60.0 mm"), "{bends}");
    assert!(!with_radius.warnings.iter().any(|warning| matches!(warning, LengthsWarning::Bent { .. })));
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
    let fit = fit_lengths(&LengthTable::new(&columns).unwrap(), &LengthsOptions::default()).unwrap();
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
        let fit = fit_lengths(&LengthTable::new(&columns).unwrap(), &LengthsOptions::default()).unwrap();
        let best = fit.best();
        let offset = best.offset.unwrap();
        let errors = [(best.g.value - G) / best.g.uncertainty, (offset.value - 0.01) / offset.uncertainty];
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
        let fit = fit_lengths(&table(&given, &periods, None), &LengthsOptions::default()).unwrap();
        needed += u32::from(fit.law(LengthModel::Offset).unwrap().p_value.unwrap() < 0.05);
    }
    // 5 % of 200 are 10, with a standard deviation of 3.
    assert!((2..=20).contains(&needed), "{needed}");
}

#[test]
fn tables_that_tell_nothing_are_refused() {
    let refuse = |given: &[f64], periods: &[f64]| {
        let columns = LengthColumns { lengths: given, periods, ..LengthColumns::default() };
        LengthTable::new(&columns)
            .and_then(|table| fit_lengths(&table, &LengthsOptions::default()))
            .unwrap_err()
    };
    assert_eq!(refuse(&[1.0, 1.0, 1.0], &[2.0, 2.01, 2.02]), FitError::EqualLengths);
    // A ball of 5 m on strings of 1 m is not lengths that are all the same.
    let (given, bob) = ([0.4, 0.6, 0.8, 1.0], Quantity { value: 5.0, uncertainty: None });
    let columns =
        LengthColumns { lengths: &given, periods: &[1.27, 1.55, 1.79, 2.0], ..LengthColumns::default() };
    let options = with_ball(bob);
    let large = fit_lengths(&LengthTable::new(&columns).unwrap(), &options);
    let large = large.unwrap_err();
    assert!(matches!(large, FitError::BobTooLarge { radius: 5.0, distance } if distance < 0.5), "{large:?}");
    assert!(matches!(refuse(&[1.0], &[2.0]), FitError::TooFewRows { .. }));
    assert!(matches!(refuse(&[1.0, -1.0], &[2.0, 2.0]), FitError::LengthOfRow { row: 2, .. }));
    assert!(matches!(refuse(&[1.0, 2.0], &[2.0, 0.0]), FitError::Period { row: 2, .. }));
    assert!(matches!(refuse(&[1.0, 2.0], &[2.0]), FitError::LengthMismatch { .. }));
}

/// A fit whose χ² of ten degrees of freedom has the wanted value.
fn scattered(per_dof: f64) -> LengthsFit {
    let given: Vec<f64> = (1..=12).map(|k| 0.1 * f64::from(k)).collect();
    // Orthogonal to a constant and a line, in y = (T/2π)².
    let pattern = [1.0, -1.0, -1.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 1.0, 1.0, -1.0];
    let size = 1e-4;
    let periods: Vec<f64> = given
        .iter()
        .zip(pattern)
        .map(|(&length, sign)| TAU * ((length + 0.01) / G + size * sign).sqrt())
        .collect();
    // The uncertainties that make every residual of size one in y the same number of them.
    let sigma = (8.0 / (10.0 * per_dof)).sqrt() * size;
    let of_periods: Vec<f64> = periods.iter().map(|period| TAU * TAU * sigma / (2.0 * period)).collect();
    fit_lengths(&table(&given, &periods, Some(&of_periods)), &LengthsOptions::default()).unwrap()
}

#[test]
fn rows_that_scatter_more_than_stated_make_the_uncertainties_larger() {
    let (stated, more) = (scattered(1.0), scattered(19.9));
    assert!((more.best().chi2_per_dof().unwrap() - 19.9).abs() < 1e-6, "{:?}", more.best());
    let spread = |fit: &LengthsFit| {
        let best = fit.best();
        [best.g, best.offset.unwrap()].map(|estimate| estimate.uncertainty)
    };
    // Stated uncertainties that are √19.9 times smaller leave the scatter, and so the answer, as it is.
    for (ours, wanted) in spread(&more).into_iter().zip(spread(&stated)) {
        assert!((ours / wanted - 1.0).abs() < 1e-6, "{ours} {wanted}");
    }
    let more_than_stated =
        more.warnings.iter().find(|warning| matches!(warning, LengthsWarning::Scatter(_))).unwrap();
    assert!(more_than_stated.to_string().contains("4.46 times"), "{more_than_stated}");
    assert!((more.best().uncertainty_degrees_of_freedom() - 10.0).abs() < 1e-12);
    assert!(!stated.warnings.iter().any(|warning| matches!(warning, LengthsWarning::Scatter(_))));
}

/// Critical value for ten degrees of freedom: chance leaves χ² below 2.558 in one table of a hundred.
#[test]
fn rows_that_scatter_less_than_stated_are_told_and_nothing_is_made_smaller() {
    let (little, enough) = (scattered(0.25), scattered(0.26));
    let told = |fit: &LengthsFit| {
        fit.warnings.iter().any(|warning| warning.to_string().contains("belong to the offset"))
    };
    assert!(told(&little) && !told(&enough));
    let g = |fit: &LengthsFit| fit.gravity().uncertainty;
    assert!((g(&scattered(0.25)) / g(&scattered(1.0)) - 2.0).abs() < 1e-6);
}

#[test]
fn clock_and_bob_are_part_of_the_uncertainty() {
    let given = ten_lengths();
    let periods: Vec<f64> = given.iter().map(|&length| period(length, 0.02, 0.06)).collect();
    let sigma = vec![1e-3; periods.len()];
    let columns = table(&given, &periods, Some(&sigma));
    let g = |options: &LengthsOptions| fit_lengths(&columns, options).unwrap();
    let of_radius = |value: f64| LengthsOptions {
        clock: Some(0.002),
        ..with_ball(Quantity { value, uncertainty: Some(0.01) })
    };
    let fit = g(&of_radius(0.06));
    let of = |input| *fit.combined.contributions.iter().find(|each| each.input == input).unwrap();
    assert!((of(BudgetInput::Clock).change() / (-0.004 * fit.best().g.value) - 1.0).abs() < 1e-10);
    let whole = (g(&of_radius(0.061)).best().g.value - g(&of_radius(0.059)).best().g.value) / 0.002;
    assert!((of(BudgetInput::BobRadius).sensitivity / whole - 1.0).abs() < 1e-3, "{fit:?}");
    let line = fit.best().g.uncertainty;
    assert!((of(BudgetInput::Slope).change() / -line - 1.0).abs() < 1e-12);
    let squares = [line, 0.004 * fit.best().g.value, 0.01 * whole].map(|part| part * part);
    let together = squares.iter().sum::<f64>().sqrt();
    assert!((fit.gravity().uncertainty / together - 1.0).abs() < 1e-4);
    for clock in [-0.1, f64::NAN, f64::INFINITY] {
        let refused =
            fit_lengths(&columns, &LengthsOptions { clock: Some(clock), ..LengthsOptions::default() });
        assert!(matches!(refused, Err(FitError::Clock(_))), "{clock}");
    }
}

#[test]
fn a_table_is_weighted_where_its_periods_have_uncertainties() {
    let (given, periods) = ([0.5, 1.0], [period(0.5, 0.0, 0.0), period(1.0, 0.0, 0.0)]);
    assert!(table(&given, &periods, Some(&[1e-3, 1e-3])).is_weighted());
    assert!(!table(&given, &periods, None).is_weighted());
}

/// Half periods make g four times as large, and doubled whole ones a quarter; a factor of 2.9 is not such a mistake.
#[test]
fn a_gravity_found_nowhere_is_explained_by_the_count_of_periods_where_that_can_be() {
    let given = ten_lengths();
    let counted = |factor: f64| {
        let periods: Vec<f64> = given.iter().map(|&length| period(length, 0.0, 0.0) / factor).collect();
        let warnings = fitted(&given, &periods, None).warnings;
        let nowhere =
            warnings.into_iter().filter(|warning| matches!(warning, LengthsWarning::NowhereOnEarth { .. }));
        nowhere.collect::<Vec<_>>()
    };
    let nowhere = |mistake| vec![LengthsWarning::NowhereOnEarth { mistake }];
    assert_eq!(counted(1.0), []);
    assert_eq!(counted(2.0), nowhere(Some(GravityMistake::HalfPeriodsAsWhole)));
    assert_eq!(counted(0.5), nowhere(Some(GravityMistake::WholePeriodsAsHalf)));
    assert_eq!(counted(2.9_f64.sqrt()), nowhere(None));
    assert_eq!(counted(0.31_f64.sqrt()), nowhere(None));
    assert_eq!(nowhere(None)[0].name(), "gravity_contradicted");
    assert!(nowhere(None)[0].to_string().contains("on Earth: check the units"));
}

#[test]
fn an_offset_is_doubted_beyond_ten_radii_of_the_bob() {
    let given = ten_lengths();
    let doubted = |offset: f64| {
        let periods: Vec<f64> = given.iter().map(|&length| period(length, offset, 0.01)).collect();
        fitted(&given, &periods, Some(0.01)).warnings.contains(&LengthsWarning::OffsetLargerThanBob)
    };
    assert!(doubted(0.101) && !doubted(0.099));
}

/// κ below zero: no ball bends a line so.
#[test]
fn a_bend_the_other_way_is_no_bob() {
    let given = ten_lengths();
    let periods: Vec<f64> =
        given.iter().map(|&length| TAU * ((length - 0.0015 / length) / G).sqrt()).collect();
    let warnings = fitted(&given, &periods, None).warnings;
    assert!(warnings.contains(&LengthsWarning::Bent { radius: None }), "{warnings:?}");
    assert!(warnings.iter().any(|warning| warning.to_string().contains("bends the other way")));
}

/// Strings with a ball of 25 mm, stated as 20 cm: an offset explains the periods, but puts the ball about the pivot.
#[test]
fn a_bob_about_its_pivot_is_refused() {
    let given = [0.15, 0.25, 0.35, 0.45, 0.55];
    let periods = given.map(|length: f64| TAU * ((length + 0.025) / 9.81).sqrt());
    let columns = LengthColumns { lengths: &given, periods: &periods, ..LengthColumns::default() };
    let table = LengthTable::new(&columns).unwrap();
    let with_radius = |radius: f64| fit_lengths(&table, &with_ball(exactly(radius)));
    assert!(with_radius(0.025).is_ok());
    let refused = with_radius(0.2);
    let Err(FitError::BobTooLarge { radius, distance }) = refused else { panic!("{refused:?}") };
    assert!(radius > distance && distance < 0.18, "{refused:?}");
}

/// For any radius, the straight line puts the bob at most 0.175 m below the pivot of the shortest pendulum.
#[test]
fn a_bob_that_is_too_large_is_refused_for_that_however_large_it_is() {
    let given = [0.15, 0.25, 0.35, 0.45, 0.55];
    let periods = given.map(|length: f64| TAU * ((length + 0.025) / 9.81).sqrt());
    let columns = LengthColumns { lengths: &given, periods: &periods, ..LengthColumns::default() };
    let table = LengthTable::new(&columns).unwrap();
    for radius in [0.1751, 0.3, 0.5, 0.8, 1.0, 2.0, 10.0, 1e3] {
        let refused = fit_lengths(&table, &with_ball(exactly(radius)));
        let Err(FitError::BobTooLarge { radius: said, distance }) = refused else { panic!("{refused:?}") };
        assert!(said.total_cmp(&radius).is_eq() && (distance - 0.175).abs() < 1e-9, "{radius} {distance}");
    }
}

/// A ball of 10 cm, from 1.25 radii on.
#[test]
fn a_bob_right_below_its_pivot_is_found_there() {
    let given = [0.12, 0.125, 0.145, 0.165];
    let periods: Vec<f64> = given.iter().map(|&length| period(length, 0.005, 0.1)).collect();
    let best = fitted(&given, &periods, Some(0.1)).best().clone();
    assert!((best.g.value / G - 1.0).abs() < 1e-9, "{best:?}");
    assert!((best.offset.unwrap().value - 0.005).abs() < 1e-9, "{best:?}");
}

/// From 1.05 to 1.3 radii, where two offsets agree with the periods.
#[test]
fn offsets_of_a_bob_that_nearly_touches_the_pivot_are_not_chosen_from() {
    let given = [0.1, 0.105, 0.11, 0.115, 0.12, 0.125];
    let periods: Vec<f64> = given.iter().map(|&length| period(length, 0.005, 0.1)).collect();
    let refused = fit_lengths(&table(&given, &periods, Some(&[1e-4; 6])), &with_ball(exactly(0.1)));
    assert_eq!(refused, Err(FitError::BobRadius { radius: 0.1 }));
}

/// A rod of 1 m that is turned about points from 0.1 to 0.36 m above its centre: T² = 4π²(k² + L²)/(gL) falls with the length, k² = 1/12 m².
#[test]
fn different_lengths_are_not_said_to_be_the_same() {
    let lengths: Vec<f64> = (0..14).map(|row| 0.1 + 0.02 * f64::from(row)).collect();
    let period = |l: &f64| TAU * ((1.0 / 12.0 + l * l) / (9.81 * l)).sqrt();
    let periods: Vec<f64> = lengths.iter().map(period).collect();
    let columns = LengthColumns { lengths: &lengths, periods: &periods, ..Default::default() };
    let table = LengthTable::new(&columns).unwrap();
    let simple = LengthsOptions { pendulum: Some(LengthsPendulum::Simple), ..LengthsOptions::default() };
    let refused = fit_lengths(&table, &simple);
    assert_eq!(refused.unwrap_err(), FitError::PeriodsWithoutLength);
    let bar = fit_lengths(&table, &LengthsOptions::default()).unwrap();
    assert_eq!(bar.best().model, LengthModel::Bar);
}

/// The rounding of the periods counts if the rows scatter less, for every caller, and does not if they scatter more.
#[test]
fn the_rounding_of_periods_is_their_uncertainty_where_rows_scatter_less() {
    let lengths_given = [0.2, 0.4, 0.6, 0.8, 1.0];
    let exact = lengths_given.map(|length: f64| TAU * (length / 9.81).sqrt());
    let fitted = |disturbance: f64, rounding: &[f64]| {
        let signs = [1.0, -1.0, 0.5, -0.5, 1.0];
        let periods: Vec<f64> =
            exact.iter().zip(signs).map(|(period, sign)| period + sign * disturbance).collect();
        let columns = LengthColumns {
            lengths: &lengths_given,
            periods: &periods,
            length_uncertainties: None,
            period_uncertainties: None,
            amplitudes: &[],
        };
        let table = LengthTable::new(&columns).unwrap().with_rounding(rounding.to_vec());
        fit_lengths(&table, &LengthsOptions::default()).unwrap()
    };
    // Hundredths of a second: a standard uncertainty of 0.01/√12.
    let hundredths = [0.01 / 12.0_f64.sqrt(); 5];
    let (quiet, loud) = (fitted(1e-5, &hundredths), fitted(0.02, &hundredths));
    // Rows without digits after the point, or another number of them, say nothing.
    let [first, ..] = hundredths;
    for unknown in [&[first, first, 0.0, first, first][..], &hundredths[..4]] {
        let fit = fitted(1e-5, unknown);
        assert!(!fit.weighted_by_rounding && fit.gravity().uncertainty < 1e-3, "{:?}", fit.gravity());
    }
    assert!(quiet.weighted_by_rounding && !loud.weighted_by_rounding);
    // By weighted least squares of T²/4π² against the length, with an offset and u(T) = 2.89 ms, from the normal equations in Python: 0.03137 m/s².
    let uncertainty = quiet.gravity().uncertainty;
    assert!((uncertainty / 0.03137 - 1.0).abs() < 0.02, "{uncertainty}");
}

/// Pendulums with every effect: T of each length by the equations of motion of `reference/corrections.py`, written out for a rod that ends at the bob.
fn whole_period(length: f64) -> f64 {
    let (mass, rod, stiffness, edge, gyration) = (0.2, 0.02, 800.0, 0.001, 0.5 * 0.03 * 0.03);
    let length = length * (1.0 + 1.2e-5 * 8.0);
    let first = mass * length + rod * length / 2.0;
    let inertia = mass * (length * length + gyration) + rod * length * length / 3.0;
    let torque = G * (first + (mass + rod) * edge);
    let (square, linear) = (stiffness * torque, stiffness * inertia + (mass + rod) * torque);
    let root = (linear * linear - 4.0 * square * ((mass + rod) * inertia - first * first)).sqrt();
    TAU * ((linear + root) / (2.0 * square)).sqrt()
}

fn every_correction(uncertainty: f64) -> Corrections {
    let about = |value: f64| Quantity { value, uncertainty: Some(uncertainty * value) };
    let bob = Bob { shape: BobShape::Disc, radius: about(0.03), height: None, inner_radius: None };
    Corrections {
        bob: Some(bob),
        bob_mass: Some(about(0.2)),
        rod_mass: Some(about(0.02)),
        support_stiffness: Some(about(800.0)),
        edge_radius: Some(about(0.001)),
        expansion: Some(about(1.2e-5)),
        warming: Some(about(8.0)),
        ..Corrections::default()
    }
}

#[test]
fn a_table_is_corrected_row_by_row() {
    let given = ten_lengths();
    // Lengths to a mark 1 cm above the centre, and rods up to the bob: 3 cm of 0.1 to 1.2 m are not rod.
    let marked: Vec<f64> = given.iter().map(|length| length - 0.01).collect();
    let periods: Vec<f64> = given.iter().map(|&length| whole_period(length)).collect();
    let sigma = vec![1e-3; periods.len()];
    let mut corrections = every_correction(0.1);
    corrections.rod_mass = None;
    let without_rod: Vec<f64> = given.iter().map(|&length| without_rod(length)).collect();
    let columns = table(&marked, &without_rod, Some(&sigma));
    let options = LengthsOptions { corrections, ..LengthsOptions::default() };
    let fit = fit_lengths(&columns, &options).unwrap();
    assert!((fit.best().g.value / G - 1.0).abs() < 1e-9, "{:?}", fit.best());
    assert!((fit.best().offset.unwrap().value - 0.01).abs() < 1e-9, "{:?}", fit.best());
    let bare = fit_lengths(&columns, &LengthsOptions::default()).unwrap();
    assert!((bare.best().g.value / G - 1.0).abs() > 1e-4);
    for name in ["slope", "clock", "buoyancy", "finite bob", "temperature", "support", "knife edge"] {
        assert_eq!(fit.budget.iter().filter(|row| row.name == name).count(), 1, "{name}");
    }
    // With the rod, which ends at the surface of the bob in the correction and at its centre in the periods.
    let with_rod = LengthsOptions { corrections: every_correction(0.1), ..LengthsOptions::default() };
    let corrected = fit_lengths(&table(&given, &periods, Some(&sigma)), &with_rod).unwrap();
    assert!((corrected.best().g.value / G - 1.0).abs() < 2e-3, "{:?}", corrected.best());
}

/// The same pendulum without a rod.
fn without_rod(length: f64) -> f64 {
    let (mass, stiffness, edge, gyration) = (0.2, 800.0, 0.001, 0.5 * 0.03 * 0.03);
    let length = length * (1.0 + 1.2e-5 * 8.0);
    let (first, inertia) = (mass * length, mass * (length * length + gyration));
    let torque = G * (first + mass * edge);
    let (square, linear) = (stiffness * torque, stiffness * inertia + mass * torque);
    let root = (linear * linear - 4.0 * square * (mass * inertia - first * first)).sqrt();
    TAU * ((linear + root) / (2.0 * square)).sqrt()
}

/// Each given input changes g as a fit with another value of it does.
#[test]
fn sensitivities_of_a_table_are_those_of_the_fit() {
    let given = ten_lengths();
    let periods: Vec<f64> = given.iter().map(|&length| whole_period(length)).collect();
    let columns = table(&given, &periods, Some(&vec![1e-3; periods.len()]));
    let fitted = |corrections: Corrections| {
        fit_lengths(&columns, &LengthsOptions { corrections, ..LengthsOptions::default() }).unwrap()
    };
    let fit = fitted(every_correction(0.1));
    type Input = fn(&mut Corrections) -> &mut Quantity;
    let moved: [(BudgetInput, Input); 5] = [
        (BudgetInput::BobRadius, |corrections| &mut corrections.bob.as_mut().unwrap().radius),
        (BudgetInput::RodMass, |corrections| corrections.rod_mass.as_mut().unwrap()),
        (BudgetInput::SupportStiffness, |corrections| corrections.support_stiffness.as_mut().unwrap()),
        (BudgetInput::EdgeRadius, |corrections| corrections.edge_radius.as_mut().unwrap()),
        (BudgetInput::Warming, |corrections| corrections.warming.as_mut().unwrap()),
    ];
    let mut squares = fit.best().g.uncertainty * fit.best().g.uncertainty;
    for (input, of) in moved {
        let g = |factor: f64| {
            let mut corrections = every_correction(0.1);
            of(&mut corrections).value *= factor;
            fitted(corrections).best().g.value
        };
        let each = *fit.combined.contributions.iter().find(|each| each.input == input).unwrap();
        let wanted = (g(1.01) - g(0.99)) / 0.02 * 0.1;
        assert!((each.change() / wanted - 1.0).abs() < 1e-3, "{input:?}: {each:?} {wanted}");
        squares += wanted * wanted;
    }
    assert!(fit.gravity().uncertainty >= 0.999 * squares.sqrt());
}

/// A bar of iron on a knife edge that rolls, on a support that yields, warmer than when it was measured.
#[test]
fn a_bar_is_corrected_with_its_own_moment_of_inertia() {
    let (mass, stiffness, edge, gyration, expansion) = (1.5, 3000.0, 0.001, 1.0 / 12.0, 1.2e-5 * 8.0);
    let period = |height: f64| {
        let (height, gyration) =
            (height * (1.0 + expansion), gyration * (1.0 + expansion) * (1.0 + expansion));
        let (first, inertia) = (mass * height, mass * (height * height + gyration));
        let torque = G * (first + mass * edge);
        let (square, linear) = (stiffness * torque, stiffness * inertia + mass * torque);
        let root = (linear * linear - 4.0 * square * (mass * inertia - first * first)).sqrt();
        TAU * ((linear + root) / (2.0 * square)).sqrt()
    };
    let given = [0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45];
    let about = |value: f64| Some(Quantity { value, uncertainty: Some(0.05 * value) });
    let corrections = Corrections {
        bob_mass: about(mass),
        support_stiffness: about(stiffness),
        edge_radius: about(edge),
        expansion: about(1.2e-5),
        warming: about(8.0),
        ..Corrections::default()
    };
    let options =
        LengthsOptions { corrections, pendulum: Some(LengthsPendulum::Bar), ..LengthsOptions::default() };
    let fit = fit_lengths(&table(&given, &given.map(period), Some(&[1e-3; 8])), &options).unwrap();
    assert!((fit.best().g.value / G - 1.0).abs() < 1e-8, "{:?}", fit.best());
    assert!(fit.budget.iter().all(|row| row.name != "finite bob" && row.name != "rod mass"));
    let reversible = LengthsOptions { pendulum: Some(LengthsPendulum::Reversible), ..options };
    let edges = table(&[0.2, 0.4], &[period(0.2), period(0.4)], Some(&[1e-4; 2]));
    let fit = fit_lengths(&edges, &reversible).unwrap();
    assert!((fit.best().g.value / G - 1.0).abs() < 1e-8, "{:?}", fit.best());
}

/// Strings on an edge that rolls with the radius ρ have T² = 4π²h²/g(h + ρ). What the rounds do not settle is refused: for ρ = 0.3 m they end
/// elsewhere with every further round.
#[test]
fn corrections_that_do_not_settle_are_refused() {
    let fitted = |edge: f64| {
        let given = ten_lengths();
        let period = |&height: &f64| TAU * (height * height / (G * (height + edge))).sqrt();
        let periods: Vec<f64> = given.iter().map(period).collect();
        let exactly = Quantity { value: edge, uncertainty: None };
        let corrections = Corrections { edge_radius: Some(exactly), ..Corrections::default() };
        let options = LengthsOptions { corrections, ..LengthsOptions::default() };
        fit_lengths(&table(&given, &periods, Some(&vec![1e-3; periods.len()])), &options)
    };
    for edge in [0.001, 0.01, 0.03] {
        let fit = fitted(edge).unwrap();
        assert!((fit.best().g.value / G - 1.0).abs() < 1e-8, "{edge}: {:?}", fit.best());
    }
    for edge in [0.3, 3.0] {
        assert_eq!(fitted(edge).unwrap_err(), FitError::CorrectionsTooLarge, "{edge}");
    }
}

/// The warnings about a table without uncertainties.
fn told(lengths: &[f64], periods: &[f64]) -> Vec<LengthsWarning> {
    let columns = LengthColumns { lengths, periods, ..LengthColumns::default() };
    fit_lengths(&LengthTable::new(&columns).unwrap(), &LengthsOptions::default()).unwrap().warnings
}

#[test]
fn a_row_with_a_typing_error_is_named_with_g_without_it() {
    let given = [0.2, 0.35, 0.5, 0.65, 0.8, 1.0];
    let periods = [0.8975, 1.1869, 1.4816, 1.6174, 1.7943, 2.0061];
    let warnings = told(&given, &periods);
    let outlying = warnings.iter().find_map(|warning| match warning {
        LengthsWarning::Outlying { row, gravity } => Some((*row, gravity.value)),
        _ => None,
    });
    let (row, gravity) = outlying.unwrap();
    assert!(row == 2 && (gravity - 9.81).abs() < 0.01, "{warnings:?}");
    assert!(!warnings.contains(&LengthsWarning::OffsetNeeded), "{warnings:?}");
}

/// One in a hundred tables without a mistake, by the bound of the test: of 150 tables more than 11, and of 600 more than 22, with a probability of
/// 2.5e-7 (`scipy.stats.binom.isf`). Of the test's own 600 at most 17 are.
#[test]
fn rows_without_mistakes_are_seldom_called_outlying_in_a_sweep() {
    let limits = Limits { usual: 0.0..11.5, full: 0.0..22.5, seeded: 0.0..17.5 };
    let mut random = Random::seeded(5);
    for (rows, stated) in [(5, None), (8, None), (20, None), (6, Some(0.002))] {
        let given: Vec<f64> = (0..rows).map(|row| 0.2 + 0.9 * f64::from(row) / f64::from(rows)).collect();
        let named = (0..sweep::number(150, 600)).filter(|_| {
            let exact = given.iter().map(|length| TAU * ((length + 0.01) / 9.81).sqrt());
            let periods: Vec<f64> = exact.map(|period| period + 0.002 * random.normal()).collect();
            let sigma = vec![0.002; given.len()];
            let table = table(&given, &periods, stated.map(|_: f64| &sigma[..]));
            let fit = fit_lengths(&table, &LengthsOptions::default()).unwrap();
            fit.warnings.iter().any(|warning| matches!(warning, LengthsWarning::Outlying { .. }))
        });
        let named = u32::try_from(named.count()).unwrap();
        limits.check(f64::from(named), &format!("named of tables of {rows} rows"));
    }
}

#[test]
fn swapped_columns_are_told_by_the_exponent() {
    let periods = [0.2, 0.35, 0.5, 0.65, 0.8, 1.0];
    let given = [0.8975, 1.1869, 1.4186, 1.6174, 1.7943, 2.0061];
    let warnings = told(&given, &periods);
    assert!(warnings[0].to_string().contains("lengths and periods are swapped"), "{warnings:?}");
    assert!(!warnings.contains(&LengthsWarning::OffsetNeeded), "{warnings:?}");
    // An offset makes an exponent other than 1/2 as well, and makes no other law.
    let offset: Vec<f64> = given.iter().map(|length| 2.0061 * (length - 0.15_f64).sqrt()).collect();
    let warnings = told(&given, &offset);
    assert!(
        !warnings.iter().any(|warning| matches!(warning, LengthsWarning::OtherPower { .. })),
        "{warnings:?}"
    );
}

/// One sign is wrong in each of 100 tables of strings with an offset; 100 tables of bars have one point on the other side of the centre.
#[test]
fn a_wrong_sign_is_told_from_a_bar_by_the_periods() {
    let mut random = Random::seeded(38);
    for draw in 0..100 {
        let row = draw % 6;
        let lengths: Vec<f64> = (2..8).map(|k| 0.1 * f64::from(k)).collect();
        let signed: Vec<f64> =
            lengths.iter().enumerate().map(|(i, length)| if i == row { -length } else { *length }).collect();
        let offset = 0.02 * random.normal();
        let string = |length: &f64| TAU * ((length + offset) / 9.81).sqrt();
        let bar = |length: &f64| TAU * ((length * length + 0.083) / (9.81 * length)).sqrt();
        let mut fitted = |period: &dyn Fn(&f64) -> f64, uncertainties: Option<&[f64]>| {
            let periods: Vec<f64> =
                lengths.iter().map(|length| period(length) + 0.003 * random.normal()).collect();
            let columns = LengthColumns {
                lengths: &signed,
                periods: &periods,
                period_uncertainties: uncertainties,
                ..LengthColumns::default()
            };
            fit_lengths(&LengthTable::new(&columns).unwrap(), &LengthsOptions::default())
        };
        for uncertainties in [None, Some(&[0.003; 6][..])] {
            let error = fitted(&string, uncertainties).unwrap_err();
            let FitError::SignOfLength { row: named, positive, .. } = error else { panic!("{error:?}") };
            assert_eq!((named, positive), (row + 1, lengths[row]));
            let fit = fitted(&bar, uncertainties).unwrap();
            assert!(fit.best().model.is_of_bars(), "{draw}");
        }
    }
}
