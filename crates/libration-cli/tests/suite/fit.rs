//! `libration fit periods`.

use crate::command::{close, directory, json, libration, message, run, text, unfolded};
use std::path::PathBuf;

/// Periods of the exact law with T0 = 2 s, computed with mpmath's `ellipk`; amplitudes in degrees.
const EXACT: &str = "angle,time,error\n\
    10,2.00381437629,0.001\n\
    40,2.06268103826,0.001\n\
    -70,2.20428981928,0.001\n\
    100,2.46445839348,0.001\n\
    130,2.93963865179,0.001\n";

fn table(name: &str, text: &str) -> PathBuf {
    let path = directory(name).join("table.csv");
    std::fs::write(&path, text).unwrap();
    path
}

fn exact_table(name: &str) -> String {
    format!("{} --columns angle,time,-,error --amplitude-unit deg", table(name, EXACT).display())
}

#[test]
fn exact_data_give_beta_one() {
    let answer = json(&format!("fit periods {}", exact_table("fit-exact")));
    assert_eq!(answer["rows"], 5);
    close(&answer["beta"], 1.0, 1e-8);
    let law = &answer["laws"][0];
    assert_eq!(law["key"], "exact");
    close(&law["t0_s"], 2.0, 1e-9);
    assert!(law["t0_uncertainty_s"].as_f64().unwrap() > 0.0);
    assert!(law["chi2_per_dof"].as_f64().unwrap() < 1e-8);
    assert_eq!(answer["laws"][1]["key"], "constant");
    assert!(answer["laws"].as_array().unwrap().len() > 20);
    assert!(answer["beta_uncertainty"].is_number() && answer["gravity_m_per_s2"].is_null());
    assert!(answer["note"].as_str().unwrap().contains("--length"));
}

#[test]
fn a_length_gives_gravity_with_its_uncertainty() {
    let answer = json(&format!("fit periods {} --length 1m±0.01m", exact_table("fit-gravity")));
    close(&answer["gravity_m_per_s2"], std::f64::consts::PI.powi(2), 1e-8);
    close(&answer["gravity_uncertainty_m_per_s2"], 0.01 * std::f64::consts::PI.powi(2), 0.05);
}

#[test]
fn the_picture_is_drawn_and_the_table_lists_the_laws() {
    let table = exact_table("fit-picture");
    let picture = directory("fit-drawn").join("fit.svg");
    let sheet = text(&format!("fit periods {table} --figure {}", picture.display()));
    assert!(sheet.contains("exact") && sheet.contains("kidd_fogg"));
    assert!(std::fs::read_to_string(picture).unwrap().contains("residual"));
}

#[test]
fn unusable_tables_are_refused_with_a_reason() {
    let cases = [
        ("empty", "", "no rows"),
        ("ragged", "0.1,2.0\n0.2,2.0,3\n", "line 2 has 3 cells"),
        ("binary", "\0\u{1}\u{2}", "not a table"),
        ("words", "0.1,2.0\n0.2,two\n", "`two` is not a finite number"),
        ("three", "0.1,2.0,0.1\n0.2,2.0,0.1\n", "--columns"),
        ("nan", "0.1,2.0\nnan,2.0\n0.2,inf\n", "not a finite number"),
        ("beyond", "0.1,2.0\n60,2.0\n", "give the unit by --amplitude-unit"),
    ];
    for (name, text, expected) in cases {
        let path = table(name, text);
        let picture = path.with_file_name("never.svg");
        let output = libration(&format!("fit periods {} --figure {}", path.display(), picture.display()));
        assert_eq!(output.status.code(), Some(1), "{name}");
        assert!(message(&output).contains(expected), "{name}: {}", message(&output));
        assert!(!picture.exists() && output.stdout.is_empty(), "{name}");
    }
    let missing =
        libration(&format!("fit periods {} --columns angle,period", table("missing", EXACT).display()));
    assert!(message(&missing).contains("no column `period`"), "{}", message(&missing));
}

#[test]
fn units_and_quantities_of_the_header_are_heeded() {
    let renamed = |header: &str| EXACT.replace("angle,time,error", header);
    let milliseconds = |header: &str| {
        let line = |line: &str| {
            let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
            format!("{},{},{}\n", cells[0], 1e3 * cells[1], 1e3 * cells[2])
        };
        format!("{header}\n{}", EXACT.lines().skip(1).map(line).collect::<String>())
    };
    for (name, text) in [
        ("fit-header-deg", renamed("amplitude (deg),T (s),error")),
        ("fit-header-ms", milliseconds("amplitude (°),T (ms),error")),
    ] {
        let answer = json(&format!("fit periods {} --columns 1,2,-,3", table(name, &text).display()));
        close(&answer["laws"][0]["t0_s"], 2.0, 1e-9);
        close(&answer["beta"], 1.0, 1e-8);
        assert!(answer["told_from_file"].to_string().contains("is in deg"), "{answer}");
    }
    let wrong = table("fit-header-rad", &renamed("amplitude (rad),T (s),error"));
    let sheet = text(&format!("fit periods {} --columns 1,2,-,3 --amplitude-unit deg", wrong.display()));
    assert!(
        unfolded(&sheet).contains("is read in deg (--amplitude-unit), not in rad as its header says"),
        "{sheet}"
    );
    // Names and units in the header count for more than the order of the columns.
    let swapped = table("fit-header-swapped", "T (s),amplitude (rad)\n2.0,0.1\n2.1,0.9\n2.2,1.2\n");
    let answer = json(&format!("fit periods {}", swapped.display()));
    assert!(answer["told_from_file"].to_string().contains("read as period: column 1"), "{answer}");
    let chosen = libration(&format!("fit periods {} --columns 1,2", swapped.display()));
    assert_eq!(chosen.status.code(), Some(1));
    let refused = message(&chosen);
    assert!(refused.contains("holds times") && refused.contains("--columns"), "{refused}");
}

/// Three readings of each period that agree to 5 ms, without an uncertainty column.
#[test]
fn repeated_readings_are_averaged_and_never_taken_for_uncertainties() {
    const READINGS: &str = "0.25,1.0031,1.0062,1.0009\n0.5,1.4185,1.4201,1.4149\n0.75,1.7373,1.7391,1.7402\n1,2.0061,2.0020,2.0048\n";
    for (name, header) in [("runs", "length (m),run A,run B,run C"), ("y", "x,y1,y2,y3")] {
        let rows = format!("{header}\n{READINGS}");
        let lengths = table(&format!("fit-readings-{name}"), rows.trim_start());
        let answer = json(&format!("fit lengths {}", lengths.display()));
        close(&answer["gravity_m_per_s2"], 9.81, 0.02);
        assert!(answer["gravity_uncertainty_m_per_s2"].as_f64().unwrap() < 0.3, "{answer}");
        assert_eq!(answer["weighting"], "uncertainties of periods");
        let told = answer["told_from_file"].to_string();
        assert!(told.contains("repeated readings: column 2") && told.contains("column 4"), "{told}");
    }
    let readings: String = [10, 20, 30, 40]
        .iter()
        .zip(READINGS.lines())
        .map(|(angle, _)| format!("{angle},2.0{angle},2.0{},2.0{}\n", angle + 1, angle + 2))
        .collect();
    let periods = table("fit-readings-periods", &format!("amplitude (deg),T1,T2,T3\n{readings}"));
    let answer = json(&format!("fit periods {} --amplitude-unit deg", periods.display()));
    assert_eq!(answer["weighting"], "uncertainties of periods");
}

#[test]
fn uncertainties_are_columns_whose_headers_say_so() {
    for (name, header, weighted) in [
        ("d", "L (m),dL (m),T (s),dT (s)", true),
        ("delta", "L (m),ΔL,T (s),ΔT", true),
        ("err", "L (m),Lerr,T (s),Terr", true),
        ("sd", "L (m),sd(L),T (s),sd", true),
        ("distance", "L (m),T (s),distance (m),diameter (m)", false),
    ] {
        let is_last = name == "distance";
        let row = |l: &str, t: &str| {
            if is_last { format!("{l},{t},0.001,0.002\n") } else { format!("{l},0.001,{t},0.002\n") }
        };
        let rows = [("0.25", "1.0031"), ("0.5", "1.4185"), ("0.75", "1.7373"), ("1", "2.0061")];
        let rows: String = rows.iter().map(|(l, t)| row(l, t)).collect();
        let lengths = table(&format!("fit-said-{name}"), &format!("{header}\n{rows}"));
        let answer = json(&format!("fit lengths {}", lengths.display()));
        let by = answer["weighting"].as_str().unwrap();
        assert_eq!(by == "uncertainties of periods and lengths", weighted, "{name}: {by}");
    }
}

#[test]
fn a_column_of_names_is_skipped_with_a_note() {
    let rows = "student,L (m),T (s)\nAnn,0.25,1.0031\nBob,0.5,1.4185\nCleo,0.75,1.7373\nDan,1,2.0061\n";
    let answer = json(&format!("fit lengths {}", table("fit-names", rows).display()));
    close(&answer["gravity_m_per_s2"], 9.81, 0.02);
    assert!(answer["told_from_file"].to_string().contains("not used: column 1 (`student`)"), "{answer}");
}

/// A column of names between the numbers: skipped with a note, skipped silently
/// if options name the other columns, and rejected if options choose it.
#[test]
fn a_column_of_names_is_skipped_where_options_name_the_others() {
    let rows = "L (m),student,T (s)\n0.25,Ann,1.0031\n0.5,Bob,1.4185\n0.75,Cleo,1.7373\n1,Dan,2.0061\n";
    let path = table("fit-names-chosen", rows).display().to_string();
    let chosen: [&[&str]; 3] = [&[], &["--columns", "1,3"], &["--columns", "L (m),T (s)"]];
    for columns in chosen {
        let output = run(&[&["fit", "lengths", &path, "--json"], columns].concat());
        let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        close(&answer["gravity_m_per_s2"], 9.81, 0.02);
        let told = answer["told_from_file"].to_string();
        assert_eq!(
            told.contains("not used: column 2 (`student`)"),
            columns.is_empty(),
            "{columns:?}: {answer}"
        );
    }
    let refused = run(&["fit", "lengths", &path, "--columns", "1,2"]);
    assert_eq!(refused.status.code(), Some(1));
    assert!(message(&refused).contains("`Ann`"), "{}", message(&refused));
}
