//! `libration formulas`.

use crate::command::{close, json, text};

#[test]
fn every_field_of_the_contract_is_there() {
    let answer = json("formulas --formulas denman,kidd_fogg --tolerance 1e-3");
    let first = &answer["formulas"][0];
    for field in ["key", "authors", "source", "latex"] {
        assert!(first[field].is_string(), "{field}");
    }
    assert_eq!(first["year"], 1959);
    close(&first["worst_error_to_90deg"], 0.001686, 1e-3);
    close(&first["holds_to_rad"], 77.7855077754_f64.to_radians(), 1e-10);
}

#[test]
fn a_formula_that_fails_the_tolerance_is_not_listed() {
    let answer = json("formulas --formulas bernoulli,black_vel_3 --amplitude 90deg --tolerance 1e-3");
    let formulas = answer["formulas"].as_array().unwrap();
    assert_eq!(formulas.len(), 1);
    assert_eq!(formulas[0]["key"], "black_vel_3");
}

#[test]
fn overtaking_formulas_are_found_where_they_overtake() {
    let answer = json("formulas --crossovers --formulas denman,black_vel_2");
    let crossovers = answer["crossovers"].as_array().unwrap();
    assert_eq!(crossovers.len(), 1);
    close(&crossovers[0]["amplitude_rad"], 113.0996643081_f64.to_radians(), 1e-11);
    assert_eq!(crossovers[0]["better_above"], "denman");
}

#[test]
fn the_table_and_the_csv_have_a_row_per_formula() {
    let rows = |arguments: &str| text(arguments).lines().count();
    assert_eq!(rows("formulas --formulas molina,butikov"), 3);
    assert_eq!(rows("formulas --formulas molina,butikov --csv"), 3);
}
