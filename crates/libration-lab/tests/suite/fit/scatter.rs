//! The scatter of rows compared with their stated uncertainties, and the enlargement of these.

use libration_lab::fit::{Enlargement, Scatter, ScatterVerdict};
use libration_lab::internals::fit::scatter::degrees_of_freedom;

/// Critical values for ten degrees of freedom: one table in a hundred has a χ² above 23.209, and one below 2.558 (Abramowitz and Stegun, table 26.8).
#[test]
fn chance_decides_at_one_table_in_a_hundred() {
    let verdict = |chi2: f64| Scatter::new(Some(chi2), 10).unwrap().verdict();
    assert_eq!([23.20, 23.22].map(verdict), [ScatterVerdict::AsStated, ScatterVerdict::More]);
    assert_eq!([2.55, 2.57].map(verdict), [ScatterVerdict::Less, ScatterVerdict::AsStated]);
}

#[test]
fn uncertainties_become_larger_and_never_smaller() {
    let of = |chi2: f64| Scatter::new(Some(chi2), 10).unwrap();
    assert!((of(199.0).enlargement() - 19.9_f64.sqrt()).abs() < 1e-15);
    let unity = |factor: f64| (factor - 1.0).abs() < 1e-15;
    assert!(unity(of(10.0).enlargement()) && unity(of(1.0).enlargement()));
    assert!((of(1.0).birge_ratio() - 0.1_f64.sqrt()).abs() < 1e-15);
    let ten = of(199.0).degrees_of_freedom();
    assert!((ten - 10.0).abs() < 1e-15 && of(11.0).degrees_of_freedom().is_infinite());
    assert!((degrees_of_freedom(None, 7) - 7.0).abs() < 1e-15);
    assert_eq!((Scatter::new(None, 3), Scatter::new(Some(1.0), 0)), (None, None));
}

#[test]
fn only_what_chance_does_not_explain_is_told() {
    let warning = |chi2: f64| Scatter::new(Some(chi2), 10).unwrap().warning("the offset");
    assert!(warning(199.0).unwrap().to_string().contains("4.46 times"));
    assert!(warning(1.0).unwrap().to_string().contains("belong to the offset"));
    assert_eq!(warning(12.0), None);
    let names = [23.22, 2.55].map(|chi2| warning(chi2).unwrap().name());
    assert_eq!(names, ["rows_scatter_more", "rows_scatter_less"]);
    assert_eq!([2.57, 23.20].map(warning), [None, None]);
}

/// √1.03 = 1.0149, a value that ten rows exceed by chance more often than not.
#[test]
fn an_enlargement_is_not_blamed_on_rows_that_scatter_as_stated() {
    let enlarged = |chi2: f64| Scatter::new(Some(chi2), 10).unwrap().enlarged();
    let within = enlarged(10.3).unwrap();
    assert!(matches!(within, Enlargement::WithinChance(_)));
    let text = within.to_string();
    assert!(
        text.contains("Birge ratio 1.01") && text.contains("as stated") && !text.contains("more than"),
        "{text}"
    );
    assert!(matches!(enlarged(23.20), Some(Enlargement::WithinChance(_))));
    assert!(
        enlarged(23.22)
            .unwrap()
            .to_string()
            .contains("enlarged 1.52 times: the rows scatter more than their uncertainties")
    );
    assert_eq!([10.0, 1.0].map(enlarged), [None, None]);
}

/// Measured uncertainties are not enlarged within chance: F = 2.25 with 4 and 10 degrees of freedom has p = 0.14, 16 has 2e-4 (`scipy.stats.f`).
#[test]
fn uncertainties_of_repeated_readings_are_enlarged_only_beyond_chance() {
    let scatter = |per_dof: f64| Scatter::new(Some(4.0 * per_dof), 4).unwrap();
    assert_eq!(scatter(2.25).enlargement(), 1.5);
    let readings = scatter(2.25).of_readings(10.0);
    assert_eq!((readings.enlargement(), readings.enlarged()), (1.0, None));
    assert_eq!(readings.degrees_of_freedom(), f64::INFINITY);
    assert_eq!(scatter(16.0).of_readings(10.0).enlargement(), 4.0);
    // χ² = 16 with four degrees of freedom has p = 0.003, F = 4 with two below 0.21.
    assert_eq!(scatter(4.0).verdict(), ScatterVerdict::More);
    assert_eq!(scatter(4.0).of_readings(2.0).verdict(), ScatterVerdict::AsStated);
    assert_eq!(scatter(4.0).of_readings(f64::INFINITY).verdict(), ScatterVerdict::More);
}
