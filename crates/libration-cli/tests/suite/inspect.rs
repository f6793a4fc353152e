//! `libration inspect`.

use crate::command::{close, directory, json, libration, message, run, text, unfolded};
use libration::quantity::is_bidirectional;
use std::path::PathBuf;

fn file(name: &str, text: &str) -> PathBuf {
    let path = directory(name).join("swing.csv");
    std::fs::write(&path, text).unwrap();
    path
}

/// A swing of 20°, 50 rows, one of them incomplete.
fn swing(header: &str) -> String {
    let row = |n: i32| {
        let time = 0.05 * f64::from(n);
        let angle = if n == 7 {
            String::new()
        } else {
            format!("{:.3}", 20.0 * (3.0 * time).cos()).replace('.', ",")
        };
        format!("{};{angle}\n", format!("{time:.2}").replace('.', ","))
    };
    format!("Pendulum of Monday\n{header}\n{}", (0..50).map(row).collect::<String>())
}

#[test]
fn a_file_is_described_with_its_columns_and_what_would_be_fitted() {
    let path = file("inspect-whole", &swing("t / s;θ / °"));
    let answer = json(&format!("inspect {}", path.display()));
    assert_eq!(answer["format"], "text, UTF-8");
    let sheet = &answer["sheets"][0];
    assert_eq!((&sheet["delimiter"], &sheet["decimal"]), (&"semicolon".into(), &"comma".into()));
    assert_eq!((&sheet["header_line"], &sheet["rows"]), (&2.into(), &50.into()));
    let angle = &sheet["columns"][1];
    assert_eq!((&angle["quantity"], &angle["unit"]), (&"angle".into(), &"deg".into()));
    assert_eq!((&angle["numbers"], &angle["blanks"]), (&49.into(), &1.into()));
    let trace = &answer["traces"][0];
    assert_eq!((&trace["rows"], &trace["unit"]), (&49.into(), &"rad".into()));
    close(&trace["interval_s"], 0.05, 1e-9);
    close(&trace["largest"], 20_f64.to_radians(), 1e-12);
    assert!(answer["undecided"].is_null());
    let sheet = text(&format!("inspect {}", path.display()));
    for part in
        ["Pendulum of Monday", "1 incomplete row left out", "(--delimiter)", "libration fit trace", "gap"]
    {
        assert!(sheet.contains(part), "{part}: {sheet}");
    }
    let columns = text(&format!("inspect {} --csv", path.display()));
    assert!(columns.lines().nth(2).unwrap().starts_with(",2,θ / °,angle,deg,,49,1,0,-"), "{columns}");
}

#[test]
fn what_a_file_leaves_open_is_asked_with_the_options_that_decide_it() {
    let path = file("inspect-open", &swing("t;phase"));
    let answer = json(&format!("inspect {}", path.display()));
    assert_eq!(answer["traces"].as_array().unwrap().len(), 0);
    assert_eq!(answer["undecided"]["options"][0], "--angle-unit rad");
    let sheet = text(&format!("inspect {}", path.display()));
    assert!(
        sheet.contains("no trace yet: it is not clear what column 2 (`phase`) holds: give --angle-unit"),
        "{sheet}"
    );
    let decided = json(&format!("inspect {} --angle-unit deg", path.display()));
    assert_eq!(decided["traces"][0]["rows"], 49);
}

const SWING: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/swing_synthetic.csv");

/// `reference/synthetic_swing.py`: 60° with linear drag 0.03 1/s, l = 0.56 m, g = 9.81 m/s², a zero offset of 1.2°.
#[test]
fn harmonics_of_a_swing_stand_beside_those_of_the_pendulum() {
    let answer = json(&format!("inspect {SWING} --spectrum"));
    let trace = &answer["traces"][0];
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    assert_eq!((&trace["unit"], trace["windows"].as_array().unwrap().len()), (&"rad".into(), 2));
    let [first, last] = [0, 1].map(|index| trace["windows"][index].clone());
    assert!(number(&first["amplitude_rad"]) > number(&last["amplitude_rad"]));
    assert!(number(&first["frequency_hz"]) < number(&last["frequency_hz"]));
    let third = &trace["harmonics"][3];
    assert_eq!(third["n"], 3);
    assert!(number(&third["theory"]) < 0.0 && number(&third["deviation"]).abs() < 3.0, "{third}");
    assert!(number(&third["amplitude"]) > 10.0 * number(&third["amplitude_uncertainty"]), "{third}");
    assert_eq!(trace["remark_kinds"], serde_json::json!(["offset"]));
    let table = text(&format!("inspect {SWING} --spectrum"));
    assert!(table.contains("diff./σ") && table.contains("degrees of angle"), "{table}");
    let csv = text(&format!("inspect {SWING} --spectrum --harmonics 3 --csv"));
    // Means and two windows for the constant and three harmonics each.
    assert_eq!(csv.lines().count(), 1 + 3 * 4, "{csv}");
    let thin = text(&format!("inspect {SWING} --spectrum --harmonics 60"));
    assert!(unfolded(&thin).contains("are not determined"), "{thin}");
}

#[test]
fn runs_without_harmonics_are_named_beside_those_that_have_some() {
    let time = |n: i32| 0.05 * f64::from(n);
    let row = |n: i32| format!("{:.2},{:.4},{:.2},0.5\n", time(n), (4.0 * time(n)).cos(), time(n));
    let rows: String = (0..600).map(row).collect();
    let header = "Run 1: Time (s),Run 1: Angle (rad),Run 2: Time (s),Run 2: Angle (rad)\n";
    let path = file("inspect-runs", &format!("{header}{rows}"));
    let answer = json(&format!("inspect {} --spectrum", path.display()));
    assert_eq!(answer["traces"].as_array().unwrap().len(), 1, "{answer}");
    assert!(answer["left_out"][0].as_str().unwrap().contains("0.5: nothing swings"), "{answer}");
}

#[test]
fn swings_that_have_no_harmonics_are_refused_with_what_would_do() {
    for (options, status, part) in [
        ("--spectrum --swings 2", 1, "--swings: windows of 2 swings are too short"),
        ("--spectrum --to 3s", 1, "swings are too few"),
        ("--harmonics 3", 2, "--spectrum"),
        ("--figure never.svg", 2, "--spectrum"),
        ("--spectrum --values --json", 2, "--values"),
        ("--spectrum --harmonics 0", 2, "--harmonics"),
    ] {
        let output = libration(&format!("inspect {SWING} {options}"));
        assert_eq!(output.status.code(), Some(status), "{options}: {}", message(&output));
        assert!(message(&output).contains(part), "{options}: {}", message(&output));
        assert!(output.stdout.is_empty());
    }
}

#[test]
fn a_table_of_periods_is_sent_to_its_own_command() {
    let path = file("inspect-periods", "0.5,2.01\n0.4,1.99\n0.6,2.02\n");
    assert!(text(&format!("inspect {}", path.display())).contains("libration fit periods"));
}

#[test]
fn times_of_a_photogate_are_recognised() {
    let path = file("inspect-gate", "Latest: Time (s),Latest: GateState\n0.5,1\n0.52,0\n1.5,1\n1.52,0\n");
    let answer = json(&format!("inspect {}", path.display()));
    assert_eq!(answer["gate_times"], 4);
    assert!(text(&format!("inspect {}", path.display())).contains("libration fit gates"));
}

/// A light barrier that is dark for 6 of 140 rows: the command that the refusal names reads it.
#[test]
fn a_recorded_gate_signal_is_sent_to_the_fit_of_gates() {
    let row =
        |row: u32| format!("{}.{:02},{}\n", row / 100, row % 100, if (row + 60) % 140 < 6 { 0 } else { 5 });
    let path =
        file("inspect-signal", &format!("Time (s),Voltage (V)\n{}", (0..3000).map(row).collect::<String>()));
    for options in ["", "--angle 2 --angle-unit deg"] {
        let output = libration(&format!("fit trace {} --length 0.5m {options}", path.display()));
        assert_eq!(output.status.code(), Some(1), "{options}");
        let said = message(&output);
        assert!(said.contains("use libration fit gates with --signal 2"), "{options}: {said}");
    }
    let fit = json(&format!("fit gates {} --signal 2", path.display()));
    assert!((fit["mean_period_s"].as_f64().unwrap() / 2.8 - 1.0).abs() < 1e-6, "{fit}");
}

#[test]
fn files_that_cannot_be_read_are_refused_with_the_place_and_the_option() {
    for (name, text, options, part) in [
        ("ragged", "t/s,θ/rad\n0,1\n1\n", "", "line 3 has 1 cell where 2 were expected"),
        ("commas", "0,5,1,2\n1,0,1,3\n", "", "--decimal point or comma"),
        ("states", "Zeit (s)\n0,1\n1,0\n2,1\n", "", "--decimal point or comma"),
        ("title", "Arduino log\n0,512\n1,520\n2,498\n", "", "--decimal point or comma"),
        ("columns", "t/s,θ/rad\n0,0.1,5\n1,0.2,5\n", "", "(--header)"),
        ("header", "t/s,θ/rad\n0,0.1\n", "--header 9", "no line of cells `9`"),
    ] {
        let path = file(&format!("inspect-{name}"), text);
        let output = libration(&format!("inspect {} {options}", path.display()));
        assert_eq!(output.status.code(), Some(1), "{name}");
        assert!(message(&output).contains(part), "{name}: {}", message(&output));
        assert!(output.stdout.is_empty(), "{name}");
    }
    let unknown = libration("inspect swing.csv --angle-unit furlong");
    assert_eq!(unknown.status.code(), Some(2));
    assert!(message(&unknown).contains("rad, deg"), "{}", message(&unknown));
}

#[test]
fn times_with_three_significant_digits_are_described_as_the_even_ones() {
    let row = |n: i32| {
        let shown: f64 = format!("{:.2e}", f64::from(n) / 30.0).parse().unwrap();
        format!("{shown},{:.4}\n", (f64::from(n) / 7.0).cos())
    };
    let table = format!("t (s),theta (rad)\n{}", (0..900).map(row).collect::<String>());
    let path = file("inspect-digits", &table);
    let answer = json(&format!("inspect {}", path.display()));
    assert_eq!(answer["traces"][0]["rows"], 900);
    close(&answer["traces"][0]["interval_s"], 1.0 / 30.0, 2e-4);
    let options = answer["findings"].to_string();
    assert!(options.contains("--times-as-written"), "{options}");
    let written = json(&format!("inspect {} --times-as-written", path.display()));
    assert!(written["traces"][0]["rows"].as_u64().unwrap() < 600);
    let uneven = file("inspect-uneven", "t (s),theta (rad)\n0,0.1\n0.1,0.2\n0.35,0.1\n0.4,0.0\n");
    let refused = json(&format!("inspect {} --even-times", uneven.display()));
    assert!(refused["undecided"]["why"].as_str().unwrap().contains("without --even-times"), "{refused}");
}

#[test]
fn a_part_of_a_file_is_judged_alone() {
    let row = |n: i32| {
        format!(
            "{:.2},{:.4}\n",
            if n < 20 { 0.05 * f64::from(n % 2) } else { 0.05 * f64::from(n) },
            f64::from(n).cos()
        )
    };
    let path = file("inspect-part", &format!("t (s),theta (rad)\n{}", (0..100).map(row).collect::<String>()));
    assert!(
        json(&format!("inspect {}", path.display()))["undecided"]["why"].as_str().unwrap().contains("line 4")
    );
    let part = json(&format!("inspect {} --from 1s --to 4s", path.display()));
    assert_eq!(part["traces"][0]["rows"], 61);
    let nothing = json(&format!("inspect {} --from 100s", path.display()));
    assert!(nothing["undecided"]["why"].as_str().unwrap().contains("--from"), "{nothing}");
}

/// Characters that move the cursor of a terminal or reverse the direction of text, in the name of a file, above its header, in it and in a cell.
#[test]
fn names_headers_and_cells_are_shown_without_control_and_bidirectional_characters() {
    let rows: String =
        (0..50).map(|n| format!("{:.2},{:.3}\n", 0.05 * f64::from(n), f64::from(n % 7))).collect();
    let path = directory("inspect-clean").join("s\u{202e}w\u{7}ing.csv");
    let text = format!("Mon\u{202e}day\nt (s),\u{2066}angle\u{202e} (deg)\n{rows}2.5,x\u{202e}y\n");
    std::fs::write(&path, text).unwrap();
    let missing = path.with_file_name("no\u{202e}su\u{1b}[2Jch.csv");
    let path = path.to_str().unwrap();
    let is_shown = |letter: char| letter == '\n' || !(letter.is_control() || is_bidirectional(letter));
    for (question, part) in [
        (vec!["inspect", path], "swing.csv"),
        (vec!["inspect", path], "Monday"),
        (vec!["inspect", path], "angle (deg)"),
        (vec!["inspect", path], "line 53, column 2"),
        (vec!["inspect", path, "--csv"], "angle (deg)"),
        (vec!["fit", "trace", path], "swing.csv: line 53"),
        (vec!["fit", "trace", path, "--angle", "\u{202e}none"], "no column"),
        (vec!["fit", "periods", path], "swing.csv"),
        (vec!["motion", "10deg", "--times-from", path], "swing.csv, line 1"),
        (vec!["inspect", missing.to_str().unwrap()], "nosu[2Jch.csv"),
    ] {
        let output = run(&question);
        let shown = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        assert!(shown.chars().all(is_shown), "{question:?}: {shown:?}");
        assert!(shown.contains(part), "{question:?}: {shown}");
    }
}
