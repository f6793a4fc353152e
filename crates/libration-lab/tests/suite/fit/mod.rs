//! Fits of period tables compared with SciPy, with the truth of synthetic tables, and with each other.

mod beta;
mod budget;
mod cycles;
mod damping_model;
mod effective_weights;
mod gates;
mod gravity;
mod groups;
mod mistake;
mod normal_gravity;
mod readings;
mod scatter;
mod spectrum;
mod trace;
mod typical_amplitude;
mod uncertain;

use std::f64::consts::PI;

use libration::pendulum::Amplitude;
use libration::quantity::Angle;
use libration_lab::fit::{
    FitError, Law, PeriodTable, PeriodsOptions, Scatter, ScatterVerdict, Uncertainties, Weighting,
    find_outliers, fit_excess_scale, fit_periods, fit_small_angle_period,
};
use libration_lab::measurement::{Column, ReadOptions, Table};

const SYNTHETIC: &[u8] = include_bytes!("../../../../../examples/period_table_synthetic.csv");

fn synthetic_columns() -> Vec<Vec<f64>> {
    let table = Table::read(SYNTHETIC, &ReadOptions::default()).unwrap();
    let names = ["amplitude", "period", "sigma_amplitude", "sigma_period"];
    table.select(&names.map(|name| Column::Name(name.into()))).unwrap().columns
}

fn synthetic() -> PeriodTable {
    let columns = synthetic_columns();
    let uncertainties = Uncertainties { amplitudes: Some(&columns[2]), periods: Some(&columns[3]) };
    PeriodTable::new(&columns[0], &columns[1], uncertainties).unwrap()
}

/// T/T0 by the arithmetic-geometric mean.
fn ratio(amplitude: f64) -> f64 {
    let (mut a, mut b) = (1.0, libm::cos(amplitude / 2.0));
    for _ in 0..10 {
        (a, b) = (f64::midpoint(a, b), f64::sqrt(a * b));
    }
    1.0 / a
}

/// dR/dA = (2/π)·(E − k′²K)/(2kk′), with E/K from the squared differences of the mean (DLMF 19.8.6).
fn slope(amplitude: f64) -> f64 {
    let (k, complement) = (libm::sin(amplitude / 2.0), libm::cos(amplitude / 2.0));
    let (mut a, mut b, mut power, mut sum) = (1.0, complement, 1.0, 0.0);
    for _ in 0..10 {
        let c: f64 = (a - b) / 2.0;
        (a, b) = (f64::midpoint(a, b), f64::sqrt(a * b));
        sum += power * c * c;
        power *= 2.0;
    }
    (k * k / 2.0 - sum) / (a * 2.0 * k * complement)
}

fn square(x: f64) -> f64 {
    x * x
}

fn close(ours: f64, reference: f64, relative: f64) -> bool {
    (ours - reference).abs() <= relative * reference.abs()
}

/// The reference numbers carry the digits that `reference/fit_periods.py` printed (SciPy 1.17).
#[test]
fn the_synthetic_table_gives_what_scipy_gives() {
    let fit = fit_periods(&synthetic(), &[], &PeriodsOptions::default()).unwrap();
    // SciPy takes the uncertainties as they are stated.
    let stated = |uncertainty: f64, scatter: Option<Scatter>| uncertainty / scatter.unwrap().enlargement();
    assert!(
        close(fit.exact.t0.value, 2.001200291, 1e-9)
            && close(stated(fit.exact.t0.uncertainty, fit.exact.scatter()), 0.00068712, 1e-5)
    );
    assert!(close(fit.exact.chi2.unwrap(), 42.380483, 1e-6) && fit.exact.dof == 39);
    assert!(close(fit.exact.rms, 0.0096724724, 1e-6));
    assert!(
        close(fit.constant.t0.value, 2.414702501, 1e-9)
            && close(fit.constant.chi2_per_dof().unwrap(), 20545.848, 1e-7)
    );
    let beta = fit.beta.unwrap();
    let of_beta = stated(beta.beta.factor.uncertainty, beta.scatter());
    assert!(close(beta.beta.factor.value, 1.00784786, 1e-7) && close(of_beta, 0.00404745, 1e-5), "{beta:?}");
    let of_t0 = stated(beta.beta.t0.uncertainty, beta.scatter());
    assert!(close(beta.beta.t0.value, 2.0001208, 1e-7) && close(of_t0, 0.00088428, 1e-5), "{beta:?}");
    assert!(close(beta.chi2_per_dof().unwrap(), 1.0066201, 1e-6));
}

#[test]
fn the_synthetic_table_gives_its_truth_back() {
    let fit = fit_periods(&synthetic(), &[], &PeriodsOptions::default()).unwrap();
    assert!((fit.exact.t0.value - 2.0).abs() < 3.0 * fit.exact.t0.uncertainty);
    let beta = fit.beta.unwrap();
    assert!((beta.beta.factor.value - 1.0).abs() < 3.0 * beta.beta.factor.uncertainty);
    assert_eq!((fit.outliers.len(), fit.weighting), (0, Weighting::PeriodsAndAmplitudes));
}

#[test]
fn readings_that_are_all_alike_tell_no_uncertainty() {
    let warned = |periods_read: &[f64]| {
        let table = PeriodTable::new(&[0.1; 3], periods_read, Uncertainties::default()).unwrap();
        let fit = fit_periods(&table, &[], &PeriodsOptions::default()).unwrap();
        fit.warnings().iter().any(|warning| warning.name() == "rows_without_scatter")
    };
    assert!(warned(&[2.004; 3]) && !warned(&[2.004, 2.004, 2.005]));
}

#[test]
fn without_uncertainties_scipy_gives_the_same_too() {
    let columns = synthetic_columns();
    let table = PeriodTable::new(&columns[0], &columns[1], Uncertainties::default()).unwrap();
    let fit = fit_periods(&table, &[], &PeriodsOptions::default()).unwrap();
    assert!(
        close(fit.exact.t0.value, 2.003230947, 1e-9) && close(fit.exact.t0.uncertainty, 0.00122301, 1e-5)
    );
    assert_eq!((fit.exact.chi2, fit.exact.chi2_per_dof()), (None, None));
    let beta = fit.beta.unwrap();
    assert!(
        close(beta.beta.factor.value, 1.007327361, 1e-7)
            && close(beta.beta.factor.uncertainty, 0.00424653, 1e-5),
        "{beta:?}"
    );
    assert_eq!(beta.uncertainty_scaled, Some(beta.beta.factor.uncertainty));
}

#[test]
fn periods_that_follow_a_law_are_explained_by_it_alone() {
    let amplitudes: Vec<f64> = (1..=150).map(|k| f64::from(k) * 0.02).collect();
    let measured: Vec<f64> = amplitudes.iter().map(|&a| 1.7 * ratio(a)).collect();
    let sigma = vec![1e-3; amplitudes.len()];
    let uncertainties = Uncertainties { amplitudes: None, periods: Some(&sigma) };
    let table = PeriodTable::new(&amplitudes, &measured, uncertainties).unwrap();
    let bernoulli = |a: f64| 1.0 + a * a / 16.0;
    let fit = fit_periods(&table, &[Law::new("bernoulli", &bernoulli)], &PeriodsOptions::default()).unwrap();
    assert!(close(fit.exact.t0.value, 1.7, 1e-14) && fit.exact.chi2.unwrap() < 1e-20);
    assert!(close(fit.beta.unwrap().beta.factor.value, 1.0, 1e-13));
    let (key, other) = &fit.others[0];
    assert!(key == "bernoulli" && other.as_ref().unwrap().chi2_per_dof().unwrap() > 100.0);
    assert!(fit.constant.chi2_per_dof().unwrap() > 1000.0);
}

#[test]
fn the_slope_of_the_exact_law_is_its_closed_form() {
    let exact = Law::exact();
    // T/T0 at 90° and at rest: K(1/√2)·2/π, DLMF 19.6.
    assert!(close(exact.ratio_at(PI / 2.0), 1.180340599016096, 1e-15) && exact.ratio_at(0.0) == 1.0);
    for k in 1..=314 {
        let amplitude = f64::from(k) * 0.01;
        // The central difference errs by (1e-4·distance)²·R‴/6R′ ≤ 1e-8, and below 0.05 by its fixed step.
        let tolerance = if amplitude < 0.05 { 1e-6 } else { 1e-8 };
        assert!(close(exact.slope_at(amplitude), slope(amplitude), tolerance), "{amplitude}");
    }
    assert_eq!(exact.slope_at(0.0).to_bits(), 0);
}

#[test]
fn the_slope_of_the_exact_law_is_the_condition_number_of_the_period() {
    for k in 1..=62 {
        let amplitude = f64::from(k) * 0.05;
        let exact = Amplitude::new(Angle::from_radians(amplitude).unwrap()).unwrap();
        let slope = exact.period_ratio() * exact.condition() / amplitude;
        assert!(close(Law::exact().slope_at(amplitude), slope, 1e-8), "{amplitude}");
    }
}

/// A linear congruential generator and the sum of twelve uniforms: normal enough for second moments.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        let mut uniform = || {
            self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            f64::from(u32::try_from(self.0 >> 32).unwrap()) / f64::from(u32::MAX)
        };
        (0..12).map(|_| uniform()).sum::<f64>() - 6.0
    }
}

#[test]
fn the_uncertainties_are_the_scatter_of_repeated_experiments() {
    const TABLES: u32 = 1000;
    let (sigma_a, sigma_t) = (vec![0.01; 40], vec![0.003; 40]);
    let mut noise = Noise(1);
    let (mut t0_squares, mut beta_squares, mut chi2) = (0.0, 0.0, 0.0);
    for _ in 0..TABLES {
        let truth: Vec<f64> = (0..40).map(|k| 0.1 + 0.05 * f64::from(k)).collect();
        let amplitudes: Vec<f64> = truth.iter().map(|a| a + 0.01 * noise.next()).collect();
        let measured: Vec<f64> = truth.iter().map(|&a| 2.0 * ratio(a) + 0.003 * noise.next()).collect();
        let uncertainties = Uncertainties { amplitudes: Some(&sigma_a), periods: Some(&sigma_t) };
        let table = PeriodTable::new(&amplitudes, &measured, uncertainties).unwrap();
        let (law, beta) = (
            fit_small_angle_period(&table, &Law::exact()).unwrap(),
            fit_excess_scale(&table, &Law::exact()).unwrap(),
        );
        t0_squares += square((law.t0.value - 2.0) / law.t0.uncertainty);
        beta_squares += square((beta.beta.factor.value - 1.0) / beta.beta.factor.uncertainty);
        chi2 += law.chi2_per_dof().unwrap();
    }
    // Four standard deviations of the mean square of 1000 normal pulls, and of the mean of 1000 χ²/39.
    let mean = |sum: f64| sum / f64::from(TABLES);
    assert!((mean(t0_squares) - 1.0).abs() < 4.0 * 0.045, "{}", mean(t0_squares));
    assert!((mean(beta_squares) - 1.0).abs() < 4.0 * 0.045, "{}", mean(beta_squares));
    assert!((mean(chi2) - 1.0).abs() < 4.0 * 0.0072, "{}", mean(chi2));
}

/// χ²/dof is 1.0 for the table, and therefore above one with half of its uncertainties.
#[test]
fn uncertainties_too_small_by_a_factor_show_in_chi2_and_not_in_the_answer() {
    let columns = synthetic_columns();
    let halves = [2, 3].map(|c: usize| columns[c].iter().map(|s| s / 2.0).collect::<Vec<f64>>());
    let uncertainties = Uncertainties { amplitudes: Some(&halves[0]), periods: Some(&halves[1]) };
    let halved = PeriodTable::new(&columns[0], &columns[1], uncertainties).unwrap();
    let full = fit_excess_scale(&synthetic(), &Law::exact()).unwrap();
    let half = fit_excess_scale(&halved, &Law::exact()).unwrap();
    assert!(close(half.beta.factor.value, full.beta.factor.value, 1e-10));
    assert!(close(half.chi2.unwrap(), 4.0 * full.chi2.unwrap(), 1e-9));
    assert!(full.scatter().unwrap().enlargement() > 1.0);
    for (ours, wanted) in [
        (half.beta.factor.uncertainty, full.beta.factor.uncertainty),
        (half.beta.t0.uncertainty, full.beta.t0.uncertainty),
    ] {
        assert!(close(ours, wanted, 1e-9), "{ours} {wanted}");
    }
    assert!(close(half.uncertainty_scaled.unwrap(), full.uncertainty_scaled.unwrap(), 1e-9));
    let t0 = |table: &PeriodTable| fit_small_angle_period(table, &Law::exact()).unwrap();
    assert!(close(t0(&halved).t0.uncertainty, t0(&synthetic()).t0.uncertainty, 1e-9));
    assert!(close(t0(&halved).uncertainty_degrees_of_freedom(), 39.0, 1e-12));
}

#[test]
fn uncertainties_too_large_by_a_factor_are_not_made_smaller() {
    let columns = synthetic_columns();
    let thrice = [2, 3].map(|c: usize| columns[c].iter().map(|s| s * 3.0).collect::<Vec<f64>>());
    let uncertainties = Uncertainties { amplitudes: Some(&thrice[0]), periods: Some(&thrice[1]) };
    let table = PeriodTable::new(&columns[0], &columns[1], uncertainties).unwrap();
    let fit = fit_excess_scale(&table, &Law::exact()).unwrap();
    let scatter = fit.scatter().unwrap();
    assert!(close(scatter.enlargement(), 1.0, 1e-15) && scatter.verdict() == ScatterVerdict::Less);
    assert!(close(
        fit.beta.factor.uncertainty * scatter.birge_ratio(),
        fit.uncertainty_scaled.unwrap(),
        1e-12
    ));
    let t0 = fit_small_angle_period(&table, &Law::exact()).unwrap();
    assert!(t0.uncertainty_degrees_of_freedom().is_infinite());
}

#[test]
fn outliers_are_told_and_left_out_only_on_request() {
    let mut columns = synthetic_columns();
    columns[1][7] -= 0.5;
    columns[1][30] += 1.0;
    let uncertainties = Uncertainties { amplitudes: Some(&columns[2]), periods: Some(&columns[3]) };
    let table = PeriodTable::new(&columns[0], &columns[1], uncertainties).unwrap();
    assert_eq!(find_outliers(&table, &Law::exact(), 5.0).unwrap(), [7, 30]);
    let kept = fit_periods(&table, &[], &PeriodsOptions::default()).unwrap();
    assert_eq!((kept.outliers.as_slice(), kept.table.len()), (&[7, 30][..], 40));
    let cleaned = fit_periods(&table, &[], &PeriodsOptions { reject_outliers: Some(5.0) }).unwrap();
    assert_eq!(cleaned.exact, fit_small_angle_period(&synthetic().without(&[7, 30]), &Law::exact()).unwrap());
    assert_eq!(cleaned.exact.residuals.len(), 38);
}

#[test]
fn the_sign_of_an_amplitude_does_not_count() {
    let columns = synthetic_columns();
    let mirrored: Vec<f64> = columns[0].iter().map(|a| -a).collect();
    let table =
        |amplitudes: &[f64]| PeriodTable::new(amplitudes, &columns[1], Uncertainties::default()).unwrap();
    assert_eq!(table(&columns[0]), table(&mirrored));
}

#[test]
fn tables_that_cannot_be_fitted_are_refused_by_row() {
    let some = |amplitudes, periods| Uncertainties { amplitudes: Some(amplitudes), periods: Some(periods) };
    for (amplitudes, measured, uncertainties, starts) in [
        (&[0.1, 3.2][..], &[1.0, 1.0][..], Uncertainties::default(), "row 2: the amplitude 3.2 rad"),
        (&[0.1, f64::NAN], &[1.0, 1.0], Uncertainties::default(), "row 2: the amplitude NaN"),
        (&[0.1, 0.2], &[1.0, 0.0], Uncertainties::default(), "row 2: the period 0.0 s"),
        (&[0.1, 0.2], &[f64::INFINITY, 1.0], Uncertainties::default(), "row 1: the period inf s"),
        (&[0.1], &[1.0, 1.0], Uncertainties::default(), "the periods have 2 rows"),
        (
            &[0.1, 0.2],
            &[1.0, 1.0],
            some(&[0.1, 0.1], &[0.1, 0.0]),
            "row 2: the uncertainty 0.0 of the period",
        ),
        (
            &[0.1, 0.2],
            &[1.0, 1.0],
            some(&[-0.1, 0.1], &[0.1, 0.1]),
            "row 1: the uncertainty -0.1 of the amplitude",
        ),
        (&[0.1, 0.2], &[1.0, 1.0], some(&[f64::NAN, 0.1], &[0.1, 0.1]), "row 1: the uncertainty NaN"),
    ] {
        let message = PeriodTable::new(amplitudes, measured, uncertainties).unwrap_err().to_string();
        assert!(message.starts_with(starts), "{message}");
    }
}

#[test]
fn a_table_too_poor_for_beta_may_still_give_t0() {
    let sigma = [0.01; 3];
    let weighted = Uncertainties { amplitudes: None, periods: Some(&sigma) };
    let equal = PeriodTable::new(&[0.5, -0.5, 0.5], &[1.0, 1.01, 1.02], weighted).unwrap();
    let fit = fit_periods(&equal, &[], &PeriodsOptions::default()).unwrap();
    assert_eq!(fit.beta, Err(FitError::EqualAmplitudes));
    assert!(close(fit.exact.t0.uncertainty, 0.01 / f64::sqrt(3.0) / ratio(0.5), 1e-12));

    let one =
        PeriodTable::new(&[0.5], &[1.0], Uncertainties { amplitudes: None, periods: Some(&sigma[..1]) })
            .unwrap();
    let fit = fit_periods(&one, &[], &PeriodsOptions::default()).unwrap();
    assert_eq!((fit.exact.dof, fit.exact.chi2_per_dof()), (0, None));
    assert!(matches!(fit.beta, Err(FitError::TooFewRows { rows: 1, needed: 2, .. })));

    let bare = PeriodTable::new(&[0.5], &[1.0], Uncertainties::default()).unwrap();
    assert!(matches!(
        fit_periods(&bare, &[], &PeriodsOptions::default()),
        Err(FitError::TooFewRows { needed: 2, .. })
    ));
    let empty = PeriodTable::new(&[], &[], Uncertainties::default()).unwrap();
    assert!(matches!(
        fit_periods(&empty, &[], &PeriodsOptions::default()),
        Err(FitError::TooFewRows { rows: 0, .. })
    ));
}

#[test]
fn a_law_without_a_value_is_reported_beside_the_others() {
    let broken = |a: f64| if a > 1.0 { f64::NAN } else { 1.0 };
    let fit = fit_periods(&synthetic(), &[Law::new("broken", &broken)], &PeriodsOptions::default()).unwrap();
    assert!(
        matches!(&fit.others[0].1, Err(FitError::LawUndefined { key, amplitude }) if key == "broken" && *amplitude > 1.0)
    );
}

/// Periods with β = 0.495 cause the first warning, and a part of the uncertainty of T0 and of the budget.
#[test]
fn a_refuted_law_is_told_first_and_makes_t0_less_certain() {
    use libration_lab::fit::{Contradiction, PeriodsOptions, PeriodsWarning, fit_periods};
    let law = Law::exact();
    let amplitudes: Vec<f64> = (1..=12).map(|row| 0.1 * f64::from(row)).collect();
    let periods_of = |beta: f64| -> Vec<f64> {
        let period = |(row, a): (usize, &f64)| {
            let error = if row % 2 == 0 { 2e-4 } else { -2e-4 };
            2.0 * (1.0 + beta * (law.ratio_at(*a) - 1.0)) + error
        };
        amplitudes.iter().enumerate().map(period).collect()
    };
    let table =
        |beta: f64| PeriodTable::new(&amplitudes, &periods_of(beta), Uncertainties::default()).unwrap();
    let refuted = fit_periods(&table(0.495), &[], &PeriodsOptions::default()).unwrap();
    let said = refuted.warnings();
    assert!(matches!(said[0], PeriodsWarning::ModelRefuted { .. }), "{said:?}");
    let deviation = (refuted.exact.t0.value - 2.0).abs() / refuted.exact.t0.uncertainty;
    assert!(deviation < 2.5 && refuted.exact.t0.uncertainty > refuted.uncertainty_of_rows, "{deviation}");
    let model = refuted.measured_period(None, None, libration_lab::fit::PeriodDamping::Unknown).model;
    let expected = refuted.contradiction.as_ref().map(Contradiction::uncertainty).unwrap();
    assert!((model.unwrap() * refuted.exact.t0.value / expected - 1.0).abs() < 1e-12);
    let kept = fit_periods(&table(1.0), &[], &PeriodsOptions::default()).unwrap();
    assert_eq!((kept.warnings(), kept.contradiction.clone()), (vec![], None));
    let named = |amplitudes: &[f64]| {
        let table = PeriodTable::new(amplitudes, &periods_of(1.0), Uncertainties::default()).unwrap();
        fit_periods(&table, &[], &PeriodsOptions::default()).unwrap().warnings()[0].name()
    };
    let radians: Vec<f64> = amplitudes.iter().map(|a| a.to_radians()).collect();
    assert_eq!(named(&radians), "angles_are_radians");
}

/// Tables of three to ten rows of the exact law with normal errors: no more than three in a hundred have an outlier, and no more than one in a hundred is
/// refused. With limits for many rows it was 21 % (outliers) and 20 % (the law) of those with three rows.
#[test]
fn small_tables_have_few_false_alarms() {
    use crate::random::Random;
    use libration_lab::fit::{PeriodsOptions, fit_periods};
    let law = Law::exact();
    for rows in [3_i32, 4, 5, 10] {
        let mut random = Random::seeded(u64::from(rows.unsigned_abs()));
        let (mut outliers, mut refuted) = (0, 0);
        for _ in 0..300 {
            let angles: Vec<f64> =
                (0..rows).map(|row| 0.15 + 1.1 * f64::from(row) / f64::from(rows - 1)).collect();
            let times: Vec<f64> =
                angles.iter().map(|a| 2.0 * law.ratio_at(*a) + 3e-3 * random.normal()).collect();
            let table = PeriodTable::new(&angles, &times, Uncertainties::default()).unwrap();
            let fit = fit_periods(&table, &[], &PeriodsOptions::default()).unwrap();
            outliers += i32::from(!fit.outliers.is_empty());
            refuted += i32::from(fit.warnings().iter().any(|warning| warning.name() == "model_refuted"));
        }
        assert!(outliers <= 9 && refuted <= 4, "{rows} rows: {outliers}, {refuted}");
    }
}

/// Three periods of the exact law, rounded to 0.01 s: the residual of 2 ms is less than half of the last digit.
#[test]
fn rounding_makes_no_outliers() {
    let angles = [10.0_f64, 40.0, 70.0].map(f64::to_radians);
    let step = vec![0.01 / 12.0_f64.sqrt(); 3];
    let table = PeriodTable::new(&angles, &[2.03, 2.09, 2.23], Uncertainties::default()).unwrap();
    assert_eq!(find_outliers(&table.with_rounding(step), &Law::exact(), 0.2).unwrap(), [] as [usize; 0]);
}
