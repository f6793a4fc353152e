//! Repeated readings. Values by NumPy and `scipy.stats` 1.17.1.

use libration_lab::fit::{
    LengthColumns, LengthTable, LengthsOptions, MeanReading, PeriodTable, PeriodsOptions, RepeatedReadings,
    Uncertainties, Weighting, effective_degrees_of_freedom, fit_lengths, fit_periods, shared_rounding,
};

fn readings(rows: &[&[f64]], step: f64) -> RepeatedReadings {
    let rows: Vec<Vec<f64>> = rows.iter().map(|row| row.to_vec()).collect();
    RepeatedReadings::new(&rows, step).unwrap()
}

fn close(computed: f64, expected: f64) {
    assert!((computed / expected - 1.0).abs() < 1e-12, "{computed} {expected}");
}

const ALIKE: [&[f64]; 4] =
    [&[20.1, 20.4, 20.2], &[22.3, 22.0, 22.4], &[24.9, 24.6, 25.0], &[27.1, 27.2, 26.8]];

#[test]
fn rows_that_scatter_alike_share_one_deviation() {
    let alike = readings(&ALIKE, 0.1);
    close(alike.deviation, 0.1957890020745114);
    assert_eq!((alike.degrees_of_freedom, alike.rounding), (8, None));
    for (row, mean) in alike.rows.iter().zip([20.233333333333334, 22.23333333333333, 24.833333333333332]) {
        close(row.mean, mean);
        close(row.uncertainty, 0.1957890020745114 / 3.0_f64.sqrt());
    }
    let unequal = readings(&[&[2.01, 2.03, 1.99, 2.02], &[2.00, 2.04], &[1.98, 2.01, 2.03], &[2.1]], 0.01);
    for (row, u) in
        unequal.rows.iter().zip([0.011071108546321994, 0.015656911856713245, 0.012783814998893141])
    {
        close(row.uncertainty, u);
    }
    close(unequal.rows[3].uncertainty, 0.02214221709264399);
    assert!(RepeatedReadings::new(&[vec![1.0], vec![2.0]], 0.01).is_none());
}

/// A reading of 2.30 among those of 1.735: t has p = 9e-8 (for twelve readings), and the variance of the row p = 1e-6 (for four rows).
#[test]
fn a_blunder_is_named_and_its_row_counts_by_its_own_scatter() {
    let rows: [&[f64]; 4] =
        [&[1.00, 1.02, 0.99], &[1.41, 1.43, 1.40], &[1.73, 1.74, 2.30], &[2.00, 2.01, 1.98]];
    let readings = readings(&rows, 0.01);
    assert_eq!(readings.outliers, [(2, 2)]);
    let unlike: Vec<bool> = readings.rows.iter().map(|row| row.is_unlike).collect();
    assert_eq!(unlike, [false, false, true, false]);
    assert_eq!((readings.degrees_of_freedom, readings.degrees_of_freedom_of(2)), (6, 2));
    close(readings.rows[2].mean, 5.77 / 3.0);
    assert!(readings.rows[2].uncertainty > 10.0 * readings.rows[0].uncertainty);
}

/// Four times the probability of the F test of line 3 (`scipy.stats`) is 0.016 in the first table and 2e-6 in the second, whose other rows differ
/// with p = 0.012 by Bartlett's test.
#[test]
fn an_outlier_has_weights_of_its_own_only_where_it_alone_differs() {
    let first: [&[f64]; 2] = [&[1.00, 1.02, 0.99], &[1.41, 1.43, 1.40]];
    for last in [[&[1.73, 1.74, 1.84], &[2.00, 2.01, 1.98]], [&[1.73, 1.74, 4.30], &[2.00, 2.16, 1.90]]] {
        let readings = readings(&[first[0], first[1], last[0], last[1]], 0.01);
        assert_eq!(readings.outliers, [(2, 2)]);
        assert!(readings.differ && readings.rows.iter().all(|row| !row.is_unlike), "{last:?}");
    }
}

#[test]
fn rounding_counts_where_the_readings_scatter_less_and_is_not_divided() {
    let same = readings(&[&[1.0, 1.0, 1.0], &[1.4, 1.4, 1.4]], 0.1);
    assert!(same.deviation < 1e-15);
    close(same.rows[0].uncertainty, 0.1 / 12.0_f64.sqrt());
    assert!(same.outliers.is_empty());
    let seam = 0.1957890020745114 * 12.0_f64.sqrt();
    assert_eq!(readings(&ALIKE, 0.999999 * seam).rounding, None);
    assert!(readings(&ALIKE, 1.000001 * seam).rounding.is_some());
}

/// All rows share one s: for any weights, u² is s² times a known number.
#[test]
fn a_sum_of_means_with_one_pooled_deviation_has_its_degrees_of_freedom() {
    let readings = readings(&ALIKE, 0.1);
    let c = [0.1, 0.5, 0.2, 0.7];
    let total =
        c.iter().map(|c| c * c).sum::<f64>() * readings.rows[0].uncertainty * readings.rows[0].uncertainty;
    close(effective_degrees_of_freedom(&readings, &c, total), 8.0);
    close(effective_degrees_of_freedom(&readings, &c, 2.0 * total), 32.0);
}

fn table(periods: &RepeatedReadings) -> PeriodTable {
    let values: Vec<f64> = periods.rows.iter().map(|row| row.mean).collect();
    let of_periods: Vec<f64> = periods.rows.iter().map(|row| row.uncertainty).collect();
    let uncertainties = Uncertainties { amplitudes: None, periods: Some(&of_periods) };
    let amplitudes = vec![0.01; values.len()];
    PeriodTable::new(&amplitudes, &values, uncertainties).unwrap().with_readings(periods.clone())
}

#[test]
fn the_degrees_of_freedom_of_readings_are_those_of_t0() {
    let readings = readings(&[&[2.01, 2.03, 1.99], &[2.00, 2.04], &[1.98, 2.01, 2.03]], 0.01);
    let fit = fit_periods(&table(&readings), &[], &PeriodsOptions::default()).unwrap();
    let degrees = fit.exact.uncertainty_degrees_of_freedom();
    assert!((degrees - 5.0).abs() < 1e-9, "{degrees}");
    let stated = PeriodTable::new(
        &[0.1; 2],
        &[2.0, 2.001],
        Uncertainties { amplitudes: None, periods: Some(&[0.01; 2]) },
    );
    let fit = fit_periods(&stated.unwrap(), &[], &PeriodsOptions::default()).unwrap();
    assert_eq!(fit.exact.uncertainty_degrees_of_freedom(), f64::INFINITY);
}

/// Four equal periods: without their rounding to 0.01 s the uncertainty would be zero.
#[test]
fn rows_that_scatter_less_than_their_rounding_are_as_uncertain_as_that() {
    let plain = PeriodTable::new(&[0.01; 4], &[2.0; 4], Uncertainties::default()).unwrap();
    let rounding = 0.01 / 12.0_f64.sqrt();
    let fit = fit_periods(&plain.clone().with_rounding(vec![rounding; 4]), &[], &PeriodsOptions::default())
        .unwrap();
    assert_eq!(fit.weighting, Weighting::Rounding);
    close(fit.exact.t0.uncertainty, rounding / 2.0 / 1.00000625003581);
    let scattered = PeriodTable::new(&[0.01; 4], &[2.0, 2.1, 1.9, 2.0], Uncertainties::default()).unwrap();
    let fit =
        fit_periods(&scattered.with_rounding(vec![rounding; 4]), &[], &PeriodsOptions::default()).unwrap();
    assert_eq!(fit.weighting, Weighting::Scatter);
}

/// Four rows at nearly one amplitude are all rounded from 20.04 to 20.0: their mean is as uncertain as one of them.
#[test]
fn rows_that_are_rounded_to_one_step_share_their_error() {
    let same = [vec![20.0, 20.0], vec![20.0, 20.0], vec![20.0, 20.0], vec![20.0, 20.0]];
    let readings = RepeatedReadings::new(&same, 0.1).unwrap();
    let fit = fit_periods(&table(&readings), &[], &PeriodsOptions::default()).unwrap();
    close(fit.exact.t0.uncertainty, 0.1 / 12.0_f64.sqrt() / 1.00000625003581);
    let others = [vec![20.0, 20.0], vec![20.1, 20.1], vec![19.9, 19.9], vec![20.2, 20.2]];
    close(shared_rounding(&RepeatedReadings::new(&others, 0.1).unwrap(), &[0.25; 4]) + 1.0, 1.0);
}

/// Rows of four readings whose variances Bartlett's test of `scipy.stats` finds different, with p = 1.6e-5 and 1.2e-7: by NumPy u² = Σcᵢ²sᵢ²/4 with the
/// degrees of freedom of Welch and Satterthwaite, where T0 and g have the weights of the pooled variance.
#[test]
fn rows_that_scatter_differently_count_alike_and_have_their_own_variances() {
    let unlike = readings(
        &[
            &[2.01, 2.05, 1.99, 2.02],
            &[2.20, 1.80, 2.05, 2.11],
            &[2.001, 2.004, 1.998, 2.002],
            &[2.10, 1.95, 2.02, 2.08],
            &[1.99, 2.03, 2.04, 1.97],
        ],
        0.001,
    );
    assert!(unlike.differ && unlike.rows.iter().all(|row| !row.is_unlike));
    let fit = fit_periods(&table(&unlike), &[], &PeriodsOptions::default()).unwrap().exact;
    close(fit.t0.value * 1.00000625003581, 2.02075);
    close(fit.t0.uncertainty * 1.00000625003581, 0.018889481199863594);
    close(fit.uncertainty_degrees_of_freedom(), 4.307392802756754);
    let readings = readings(
        &[
            &[1.270992, 1.267992, 1.269992, 1.268992],
            &[1.534192, 1.584192, 1.564192, 1.544192],
            &[1.795623, 1.794623, 1.793623, 1.796623],
            &[2.056409, 1.966409, 2.016409, 1.976409],
            &[2.198911, 2.195911, 2.200911, 2.197911],
        ],
        1e-6,
    );
    let [means, uncertainties] = [|row: &MeanReading| row.mean, |row: &MeanReading| row.uncertainty]
        .map(|part| readings.rows.iter().map(part).collect::<Vec<f64>>());
    let columns = LengthColumns {
        lengths: &[0.4, 0.6, 0.8, 1.0, 1.2],
        periods: &means,
        period_uncertainties: Some(&uncertainties),
        ..LengthColumns::default()
    };
    let of_lengths = LengthTable::new(&columns).unwrap().with_readings(readings);
    let fit = fit_lengths(&of_lengths, &LengthsOptions::default()).unwrap();
    let near = |computed: f64, expected: f64| {
        assert!((computed / expected - 1.0).abs() < 1e-9, "{computed} {expected}");
    };
    near(fit.gravity().value, 9.824635639638036);
    near(fit.gravity().uncertainty, 0.11629480944025505);
    near(fit.combined.degrees_of_freedom, 3.2925871419234545);
}
