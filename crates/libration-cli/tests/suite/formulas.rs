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
    // The abbreviations stand below.
    assert_eq!(rows("formulas --formulas molina,butikov"), 3 + 3);
    assert_eq!(rows("formulas --formulas molina,butikov --csv"), 3);
}

/// 1/agm(1, cos 30°) = 1.0731820071493643752 (mpmath); formula/exact − 1 of (θ0/sin θ0)^(3/8) there is 6.065976129908904e-4 (mpmath).
#[test]
fn the_sheet_of_a_formula_has_its_text_its_derivation_and_its_error_curve() {
    let answer = json("formulas molina pade-power-2");
    let molina = &answer["formulas"][0];
    assert_eq!(molina["formula"], "(θ0/sin θ0)^(3/8)");
    assert!(molina["derivation"].as_str().unwrap().contains("3/4"));
    let at_60 = &molina["errors"][5];
    close(&at_60["amplitude_rad"], 60_f64.to_radians(), 1e-15);
    close(&at_60["fractional_error"], 6.065_976_129_908_904e-4, 1e-12);
    let product = at_60["ratio"].as_f64().unwrap() / (1.0 + at_60["fractional_error"].as_f64().unwrap());
    assert!((product - 1.073_182_007_149_364_4).abs() < 1e-15, "{product:?}");
    // The error of the sheet at the end of each range is the tolerance.
    for range in answer["formulas"][1]["holds"].as_array().unwrap() {
        let (tolerance, to) = (range["tolerance"].as_f64().unwrap(), range["holds_to_rad"].as_f64().unwrap());
        let there = json(&format!("period {to:?} --formulas pade_power_2"));
        let error = there["results"][0]["formulas"][0]["fractional_error"].as_f64().unwrap();
        assert!((error.abs() / tolerance - 1.0).abs() < 1e-9, "{to}: {error}");
    }
    let sheet = text("formulas molina");
    for word in ["derivation", "source", "T/T0", "error at most", "LaTeX"] {
        assert!(sheet.contains(word), "{word}: {sheet}");
    }
    assert!(text("formulas").contains("1 + θ0²/16 + 11 θ0⁴/3072"), "the table has the formulas");
}
