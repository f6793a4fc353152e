//! Tables as students write them, `examples/class/` (made by `reference/class_tables.py`, g = 9.81 m/s²).

use crate::command::{directory, json, libration, message, text, unfolded};

fn example(name: &str) -> String {
    format!("{}/../../examples/class/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// Checks that g is within three uncertainties of the truth, and returns the settings as one text.
fn lengths(arguments: &str) -> (serde_json::Value, String) {
    let answer = json(&format!("fit lengths {arguments}"));
    let number = |name: &str| answer[name].as_f64().unwrap();
    let pull = (number("gravity_m_per_s2") - 9.81) / number("gravity_uncertainty_m_per_s2");
    assert!(pull.abs() < 3.0, "{arguments}: {pull} {answer}");
    assert!(number("gravity_uncertainty_m_per_s2") < 0.4, "{answer}");
    let told = answer["told_from_file"].to_string();
    (answer, told)
}

#[test]
fn tables_of_lengths_are_read_as_they_are_written() {
    for (name, said) in [
        ("cells_with_units.csv", "column 1 is in cm"),
        ("plus_minus.csv", "read as length: column 1 (`L (m)`)"),
        ("brackets.csv", "read as period: column 2 (`T (s)`)"),
        ("header_in_first_row.csv", "line 1 is read as the header and the first row"),
        ("squares.csv", "read as squares of the period: column 2 (`T^2 (s^2)`)"),
        ("names_and_mean.csv", "line 8 (`mean`) is left out"),
        ("units_below.csv", "column 1 (`L`) is in cm"),
        ("units_beside.csv", "column 2 (`unit`) has the units of column 1 (`L`)"),
        ("ten_swings.csv", "holds times of 10 periods"),
    ] {
        let (answer, told) = lengths(&example(name));
        assert_eq!(answer["rows"], 6, "{name}");
        assert!(told.contains(said), "{name}: {told}");
    }
}

#[test]
fn uncertainties_in_cells_are_weights() {
    for name in ["plus_minus.csv", "brackets.csv"] {
        let (answer, _) = lengths(&example(name));
        assert_eq!(answer["weighting"], "uncertainties of periods and lengths", "{name}");
    }
}

#[test]
fn repeated_readings_are_averaged_with_their_scatter() {
    let (answer, told) = lengths(&example("ten_swings.csv"));
    assert!(told.contains("read as period as repeated readings: column 2"), "{told}");
    assert!(told.contains("scatter by 0.") && told.contains("(12 degrees of freedom)"), "{told}");
    assert!(told.contains("not used: column 5 (`mean (s)`), column 6 (`T (s)`)"), "{told}");
    assert_eq!(answer["weighting"], "uncertainties of periods");
    // Twelve degrees of freedom of the readings, by Student's distribution: 2.179.
    let factor = answer["coverage_factor"].as_f64().unwrap();
    assert!((factor - 2.1788).abs() < 1e-3 || factor > 2.3, "{factor}");
    let periods = json(&format!("fit periods {}", example("amplitudes.csv")));
    let t0 = 2.0 * std::f64::consts::PI * (0.5_f64 / 9.81).sqrt();
    let law = &periods["laws"][0];
    let pull = (law["t0_s"].as_f64().unwrap() - t0) / law["t0_uncertainty_s"].as_f64().unwrap();
    assert!(pull.abs() < 3.0, "{periods}");
}

/// The options are those that the refusals name.
#[test]
fn one_length_gives_g_by_its_periods_at_one_amplitude() {
    let table = example("one_length.csv");
    let refused = libration(&format!("fit lengths {table}"));
    let hint = "one length gives g by libration fit periods with --length and --amplitude";
    assert!(unfolded(&message(&refused)).contains(hint), "{}", message(&refused));
    let answer = json(&format!("fit periods {table} --length 56cm±1mm --amplitude 10deg"));
    let number = |name: &str| answer[name].as_f64().unwrap();
    let pull = (number("gravity_m_per_s2") - 9.81) / number("gravity_uncertainty_m_per_s2");
    assert!(pull.abs() < 3.0, "{answer}");

    let folder = directory("one-length");
    let [alone, beside] = ["alone.csv", "beside.csv"].map(|name| folder.join(name));
    let times = ["15.02", "14.99", "15.03"];
    std::fs::write(&alone, format!("10 T (s)\n{}\n", times.join("\n"))).unwrap();
    let rows = times.map(|time| format!("10,{time}\n")).concat();
    std::fs::write(&beside, format!("A (deg),10 T (s)\n{rows}")).unwrap();
    let lengths = folder.join("lengths.csv");
    std::fs::write(&lengths, "L (cm),A (deg),T (s)\n56,10,1.50\n80,10,1.80\n56,20,1.51\n").unwrap();
    let [alone, beside] = [alone, beside].map(|path| path.display().to_string());
    let by_option = json(&format!("fit periods {alone} --amplitude 10deg"));
    assert_eq!(by_option["laws"], json(&format!("fit periods {beside}"))["laws"]);
    for (arguments, said) in [
        (alone.clone(), "--amplitude is that of all swings, for a table without amplitudes"),
        (format!("{beside} --amplitude 10deg"), "a column of amplitudes is given too"),
        (format!("{alone} --amplitude 10deg --from 5deg"), "no column holds the amplitude"),
        (format!("{} --amplitude 10deg", example("ten_swings.csv")), "the rows have several lengths"),
        (lengths.display().to_string(), "the rows have several lengths"),
    ] {
        let refused = unfolded(&message(&libration(&format!("fit periods {arguments}"))));
        assert!(refused.contains(said), "{refused}");
    }
}

/// A first line of numbers would be left out silently.
#[test]
fn a_single_column_is_headed_by_a_name_with_a_count_and_no_number() {
    let table = directory("one-column").join("table.csv");
    let written = |header: &str, rows: &str| {
        std::fs::write(&table, format!("{header}\n{rows}")).unwrap();
        libration(&format!("fit periods {} --amplitude 10deg --json", table.display()))
    };
    let fitted = |header: &str| written(header, "15.02\n14.99\n15.03\n");
    assert_eq!(fitted("10 T (s)").stdout, written("10 T (s)", "15,02\n14,99\n15,03\n").stdout);
    let with_whole =
        ["15.02\n15\n15.03\n", "15,02\n15\n15,03\n"].map(|rows| written("10 T (s)", rows).stdout);
    assert!(!with_whole[0].is_empty() && with_whole[0] == with_whole[1]);
    for header in ["10 T (s)", "10T [s]", "10 T / s", "10T/s", "10 swings (s)"] {
        let output = fitted(header);
        let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(answer["rows"], 3, "{header}");
        assert!((answer["laws"][0]["t0_s"].as_f64().unwrap() - 1.4985).abs() < 1e-3, "{header}: {answer}");
    }
    for header in ["15 s", "15 (s)", "1.50 (2)", "15.02 s (Ada)", "15 / 2", "15 /"] {
        let refused = message(&fitted(header));
        assert!(refused.contains("neither a header nor a row of numbers"), "{header}: {refused}");
    }
}

/// The option is the one that the refusal names.
#[test]
fn two_tables_side_by_side_are_read_one_after_the_other() {
    let table = example("side_by_side.csv");
    let refused = libration(&format!("fit lengths {table}"));
    assert_eq!(refused.status.code(), Some(1));
    assert!(message(&refused).contains("--columns 1,2 or 4,5"), "{}", message(&refused));
    for columns in ["1,2", "4,5"] {
        lengths(&format!("{table} --columns {columns}"));
    }
}

#[test]
fn uncertainties_named_by_initials_go_with_their_columns() {
    let answer = json(&format!("fit periods {}", example("initials.csv")));
    let told = answer["told_from_file"].to_string();
    assert!(told.contains("standard uncertainty of the amplitude: column 3"), "{told}");
    assert!(told.contains("standard uncertainty of the period: column 4"), "{told}");
    assert_eq!(answer["weighting"], "uncertainties of periods and amplitudes");
}

#[test]
fn roles_are_given_by_an_option() {
    let table = example("ten_swings.csv");
    let (answer, told) =
        lengths(&format!("{table} --role 2=ignore --role 3=ignore --role 4=ignore --role 5=ignore"));
    assert_eq!(answer["weighting"], "none: uncertainties from the scatter");
    assert!(told.contains("read as period: column 6"), "{told}");
    let wrong = libration(&format!("fit lengths {table} --role 2=mass"));
    assert_eq!(wrong.status.code(), Some(2));
    assert!(message(&wrong).contains("period-half-width"), "{}", message(&wrong));
    let bare = libration(&format!("fit lengths {table} --role mass"));
    assert_eq!(bare.status.code(), Some(2));
}

#[test]
fn half_widths_and_steps_are_divided_by_roots() {
    let [standard, half_width, resolution] = ["uncertainty", "half-width", "resolution"].map(|kind| {
        let table = example("initials.csv");
        let roles = format!("--role 3=ignore --role 4=period-{kind}");
        json(&format!("fit periods {table} {roles}"))["laws"][0]["t0_uncertainty_s"].as_f64().unwrap()
    });
    // The Birge ratio enlarges small ones, so that only the order is the same for all.
    assert!(standard >= half_width && half_width >= resolution, "{standard} {half_width} {resolution}");
}

#[test]
fn the_sheet_says_how_the_table_was_read() {
    let sheet = unfolded(&text(&format!("fit lengths {}", example("ten_swings.csv"))));
    assert!(sheet.contains("read as") && sheet.contains("as repeated readings"), "{sheet}");
}

#[test]
fn groups_are_compared_and_averaged() {
    let answer = json(&format!("fit lengths {}", example("groups.csv")));
    let names: Vec<&str> =
        answer["groups"].as_array().unwrap().iter().map(|group| group["group"].as_str().unwrap()).collect();
    assert_eq!(names, ["A", "B", "C"]);
    let mean = &answer["group_mean"];
    let pull = (mean["gravity_m_per_s2"].as_f64().unwrap() - 9.81)
        / mean["gravity_uncertainty_m_per_s2"].as_f64().unwrap();
    assert!(pull.abs() < 3.0, "{mean}");
    // Twenty swings are timed as well as ten: group B is about twice as certain.
    let uncertainty =
        |index: usize| answer["groups"][index]["gravity_uncertainty_m_per_s2"].as_f64().unwrap();
    assert!(uncertainty(1) < uncertainty(0) && uncertainty(1) < uncertainty(2), "{answer}");
    let sheet = unfolded(&text(&format!("fit lengths {}", example("groups.csv"))));
    assert!(sheet.contains("g, groups") && sheet.contains("Birge ratio"), "{sheet}");
    let clock = json(&format!("fit lengths {} --clock 1%", example("groups.csv")));
    let shared = clock["group_mean"]["gravity_shared_uncertainty_m_per_s2"].as_f64().unwrap();
    assert!((shared / (0.02 * 9.81) - 1.0).abs() < 0.02, "{shared}");
    assert_eq!(clock["groups"], answer["groups"], "the clock belongs to no group");
}

/// The lengths of group D are a tenth too large.
#[test]
fn a_group_that_stands_out_is_named() {
    let rows = std::fs::read_to_string(example("groups.csv")).unwrap();
    let wrong = rows.lines().filter(|line| line.starts_with("C,")).map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        let length: f64 = cells[1].parse().unwrap();
        format!("D,{},{}\n", 1.1 * length, cells[2..].join(","))
    });
    let path = directory("class-standing-out").join("file.csv");
    std::fs::write(&path, format!("{rows}{}", wrong.collect::<String>())).unwrap();
    let answer = json(&format!("fit lengths {}", path.display()));
    let out: Vec<bool> = answer["groups"]
        .as_array()
        .unwrap()
        .iter()
        .map(|group| group["stands_out"].as_bool().unwrap())
        .collect();
    assert_eq!(out, [false, false, false, true], "{answer}");
    let sheet = unfolded(&text(&format!("fit lengths {}", path.display())));
    assert!(sheet.contains("D stands out"), "{sheet}");
}

#[test]
fn a_column_of_groups_is_given_by_an_option() {
    let table = example("names_and_mean.csv");
    assert!(json(&format!("fit lengths {table}"))["groups"].is_null());
    // Each name is a group of one row, which has no g.
    let answer = json(&format!("fit lengths {table} --group name"));
    assert_eq!(answer["groups"].as_array().unwrap().len(), 6);
    assert!(answer["groups"][0]["gravity_m_per_s2"].is_null() && answer["group_mean"].is_null(), "{answer}");
    assert!(answer["groups"][0]["note"].as_str().is_some());
}

/// One timing of a row of ten swings: 0.1 s of reaction time are 0.01 s of each period.
#[test]
fn reaction_time_weighs_single_readings_and_not_repeated_ones() {
    let rows = "L (m),10 T (s)\n0.25,10.03\n0.5,14.19\n0.75,17.37\n1,20.06\n";
    let path = directory("class-reaction").join("file.csv");
    std::fs::write(&path, rows).unwrap();
    let of = |time: &str| json(&format!("fit lengths {} --reaction-time {time}", path.display()));
    let uncertainty =
        |answer: &serde_json::Value| answer["laws"][0]["g_uncertainty_m_per_s2"].as_f64().unwrap();
    let (one, ten) = (of("0.1s"), of("1s"));
    assert_eq!(one["weighting"], "uncertainties of periods");
    let ratio = uncertainty(&ten) / uncertainty(&one);
    assert!((ratio / 10.0 - 1.0).abs() < 1e-3, "{ratio}");
    let repeated = example("ten_swings.csv");
    let without = json(&format!("fit lengths {repeated}"));
    let with = json(&format!("fit lengths {repeated} --reaction-time 1s"));
    assert_eq!(with["laws"], without["laws"]);
    assert!(with["told_from_file"].to_string().contains("is not added"), "{with}");
}

/// All periods are off by b/10 alike: T0 by the same, and g by 2 g b/(10 T0). More readings do not help.
#[test]
fn what_all_timings_share_is_a_row_of_the_budget() {
    let table = example("amplitudes.csv");
    let answer = json(&format!("fit periods {table} --length 0.500m±0.001m --shared-timing 0.2s"));
    let of = |answer: &serde_json::Value| {
        let inputs = answer["budget_inputs"].as_array().unwrap().clone();
        let input = inputs.into_iter().find(|input| input["input"] == "shared timing").unwrap();
        input["contribution_m_per_s2"].as_f64().unwrap().abs()
    };
    // 0.2 s of twenty swings are 0.01 s of each period; T/T0 is 1 to 1.07.
    let expected = 2.0 * 9.81 * 0.01 / 1.4185;
    assert!((of(&answer) / expected - 1.0).abs() < 0.05, "{} {expected}", of(&answer));
    let lengths = json(&format!("fit lengths {} --shared-timing 0.2s", example("ten_swings.csv")));
    assert!(of(&lengths) > 0.0, "{lengths}");
    let none = json(&format!("fit lengths {}", example("ten_swings.csv")));
    assert_eq!(lengths["laws"], none["laws"]);
}

#[test]
fn a_table_of_periods_is_inspected_with_the_fit_that_it_is_for() {
    for (name, command) in
        [("ten_swings.csv", "fit lengths"), ("amplitudes.csv", "fit periods"), ("squares.csv", "fit lengths")]
    {
        let answer = json(&format!("inspect {}", example(name)));
        assert_eq!(answer["table_fit"], command, "{name}");
        assert!(answer["table_read_as"][1].as_str().unwrap().contains("period"), "{answer}");
        let sheet = unfolded(&text(&format!("inspect {}", example(name))));
        assert!(sheet.contains(&format!("`libration {command}` would fit the table")), "{sheet}");
    }
}

/// A refusal because of the columns names the fit that they are for; a table that no fit is for gets no such hint.
#[test]
fn a_table_of_another_fit_is_sent_there() {
    let refused = |arguments: &str| message(&libration(arguments));
    let amplitudes = refused(&format!("fit lengths {}", example("amplitudes.csv")));
    assert!(amplitudes.contains("hint: the columns are those of libration fit periods"), "{amplitudes}");
    let lengths = refused(&format!("fit periods {}", example("brackets.csv")));
    assert!(lengths.contains("hint: the columns are those of libration fit lengths"), "{lengths}");
    let response = refused(&format!("fit response {}", example("brackets.csv")));
    assert!(response.contains("hint: the columns are those of libration fit lengths"), "{response}");
    let table = directory("no-fit").join("words.csv");
    std::fs::write(&table, "a,b\n1,x\n2,y\n").unwrap();
    assert!(!refused(&format!("fit lengths {}", table.display())).contains("hint"));
}

/// Uncertainties as parts of the values, and one for all values in the heading, are those of a column in seconds.
#[test]
fn uncertainties_in_per_cent_or_in_the_heading_are_those_of_a_column() {
    let directory = directory("uncertainties");
    let uncertainty = |heading: &str, cells: [&str; 4]| {
        let rows =
            cells.iter().zip(["10", "30", "50", "70"]).map(|(cell, angle)| format!("{angle},{cell}\n"));
        let path = directory.join("table.csv");
        std::fs::write(&path, format!("A (deg),{heading}\n{}", rows.collect::<String>())).unwrap();
        let fitted = json(&format!("fit periods {}", path.display()));
        fitted["laws"][0]["t0_uncertainty_s"].as_f64().unwrap()
    };
    let near = |computed: f64, wanted: f64| (computed / wanted - 1.0).abs() < 1e-9;
    let parts = uncertainty("T (s),u (s)", ["2.00,0.02", "2.03,0.0203", "2.10,0.021", "2.20,0.022"]);
    for heading in ["T (s),u (%)", "T (s),u(T) in %"] {
        let computed = uncertainty(heading, ["2.00,1", "2.03,1", "2.10,1", "2.20,1"]);
        assert!(near(computed, parts), "{heading}: {computed} {parts}");
    }
    let same = uncertainty("T (s),u (s)", ["2.00,0.02", "2.03,0.02", "2.10,0.02", "2.20,0.02"]);
    for heading in ["T (s) ± 0.02", "T (s) ± 20 ms", "T ± 0.02 (s)"] {
        let computed = uncertainty(heading, ["2.00", "2.03", "2.10", "2.20"]);
        assert!(near(computed, same), "{heading}: {computed} {same}");
    }
}

/// A table with this header and these rows in a folder of its own.
fn table(name: &str, lines: &[&str]) -> String {
    let path = directory(&format!("class-table-{name}")).join(format!("{name}.csv"));
    std::fs::write(&path, lines.join("\n") + "\n").unwrap();
    path.display().to_string()
}

/// T0 of a table of amplitudes.
fn small_angle_period(path: &str) -> f64 {
    json(&format!("fit periods {path}"))["laws"][0]["t0_s"].as_f64().unwrap()
}

#[test]
fn numbers_of_swings_in_any_words_divide_the_times() {
    let rows = ["10,10,20.019", "20,10,20.148", "30,20,40.796", "40,10,20.647", "50,20,41.892"];
    for (number, heading) in (0..).zip([
        "number of periods",
        "periods",
        "num periods",
        "No. of cycles",
        "Anzahl der Schwingungen",
        "Anzahl Perioden",
        "Anzahl",
        "Schwingungszahl",
        "nombre de périodes",
        "nombre d'oscillations",
        "nb oscillations",
        "número de oscilaciones",
        "n° oscilaciones",
        "numero oscillazioni",
        "Oscillations counted",
        "# swings",
        "N oscillations",
        "N periods",
        "number of full swings",
        "how many swings",
    ]) {
        let header = format!("amplitude (deg),{heading},t (s)");
        let lines: Vec<&str> = [header.as_str()].into_iter().chain(rows).collect();
        let t0 = small_angle_period(&table(&format!("swings-{number}"), &lines));
        assert!((t0 - 2.0).abs() < 0.002, "{heading}: {t0}");
    }
}

#[test]
fn a_wrong_number_of_swings_is_refused_with_its_line() {
    for (heading, wrong) in [("n", "0"), ("n", "-10"), ("swings", "10.3"), ("Anzahl der Schwingungen", "0")] {
        let header = format!("amplitude (deg),{heading},t (s)");
        let row = format!("40,{wrong},20.647");
        let lines = [&header, "10,10,20.019", "20,10,20.148", "30,10,20.398", &row];
        let refused = libration(&format!("fit periods {}", table("wrong-swings", &lines)));
        assert!(
            message(&refused).contains("line 5: the number of swings"),
            "{heading}: {}",
            message(&refused)
        );
    }
}

/// `t` is a time of several swings next to their period `T`, and `u(T)` is that of the period.
#[test]
fn a_small_t_is_a_time_and_a_capital_one_a_period() {
    let rows = ["10,20.019,2.002", "20,20.148,2.015", "30,20.398,2.040", "40,20.647,2.065"];
    for (name, header) in
        [("t-T", "amplitude (deg),t (s),T (s)"), ("time-T", "amplitude (deg),time (s),T (s)")]
    {
        let lines: Vec<&str> = [header].into_iter().chain(rows).collect();
        let t0 = small_angle_period(&table(name, &lines));
        assert!((t0 - 2.0).abs() < 0.002, "{header}: {t0}");
    }
    let readings = ["10,20.019,20.02,2.002", "20,20.148,20.15,2.015", "30,20.398,20.40,2.040"];
    let lines: Vec<&str> = ["amplitude (deg),t1 (s),t2 (s),T (s)"].into_iter().chain(readings).collect();
    let t0 = small_angle_period(&table("t-readings", &lines));
    assert!((t0 - 2.0).abs() < 0.002, "{t0}");
    let with_uncertainty = ["10,20.019,2.002,0.001", "20,20.148,2.015,0.001", "30,20.398,2.040,0.001"];
    let lines: Vec<&str> =
        ["amplitude (deg),t (s),T (s),u(T) (s)"].into_iter().chain(with_uncertainty).collect();
    let answer = json(&format!("fit periods {}", table("t-u", &lines)));
    assert!(
        answer["told_from_file"].to_string().contains("not used: column 3 (`T (s)`), column 4 (`u(T) (s)`)"),
        "{answer}"
    );
    let derived = table("derived", &["L (m),T from 10 swings (s)", "0.2,0.9", "0.5,1.42", "1,2.0"]);
    assert!(message(&libration(&format!("fit lengths {derived}"))).contains("--swings-per-reading"));
    let ratio = table("ratio", &["amplitude (deg),T/T0", "10,1.002", "60,1.073", "90,1.18"]);
    assert!(message(&libration(&format!("fit periods {ratio}"))).contains("not a unit of times"));
}

#[test]
fn columns_of_angles_are_the_amplitudes_of_lengths() {
    let rows =
        ["20,60,0.9632", "35,50,1.2438", "50,40,1.4640", "65,30,1.6457", "80,20,1.8080", "100,10,2.0099"];
    for (name, heading) in
        [("auslenkung", "Auslenkung (°)"), ("initial", "initial angle (deg)"), ("winkel", "Winkel / °")]
    {
        let header = format!("L (cm),{heading},T (s)");
        let lines: Vec<&str> = [header.as_str()].into_iter().chain(rows).collect();
        let (_, told) = lengths(&table(name, &lines));
        assert!(told.contains("read as amplitude"), "{told}");
    }
    let lines = ["L (m),amplitude,T (s)", "0.20,3,0.8975", "0.35,3,1.1869", "0.50,3,1.4186", "0.65,2,1.6174"];
    let path = table("no-unit", &lines);
    let refused = message(&libration(&format!("fit lengths {path}")));
    assert!(refused.contains("--amplitude-unit") && refused.contains("have no unit"), "{refused}");
    lengths(&format!("{path} --amplitude-unit deg"));
    let full = table("full", &["peak-to-peak (deg),T (s)", "20,2.004", "40,2.015", "60,2.035"]);
    let refused = message(&libration(&format!("fit periods {full}")));
    assert!(refused.contains("twice the amplitude") && refused.contains("--role 1=amplitude"), "{refused}");
    let mean = table("rms", &["omega (rad/s),RMS amplitude (cm)", "5,1.2", "5.5,2.5", "6,5.9", "6.5,2.4"]);
    let refused = message(&libration(&format!("fit response {mean}")));
    assert!(refused.contains("by √2") && refused.contains("--role 2=amplitude"), "{refused}");
}

#[test]
fn times_of_day_are_positions_and_no_periods() {
    let rows = ["10:05:07,10,2.0100", "10:06:07,30,2.0424", "10:07:07,50,2.1058", "10:08:07,70,2.2080"];
    for head in ["start,amplitude (deg),T (s)", "time,amplitude (deg),period (s)"] {
        let lines: Vec<&str> = [head].into_iter().chain(rows).collect();
        let told = json(&format!("fit periods {}", table("clock", &lines)))["told_from_file"].to_string();
        assert!(told.contains("read as period: column 3"), "{told}");
    }
    let alone = table("alone", &["time,amplitude (deg)", "10:05:07,10", "10:06:07,30", "10:07:07,50"]);
    assert!(!libration(&format!("fit periods {alone}")).status.success());
    let falling =
        table("falling", &["time,A (deg)", "10:05:00,20", "10:06:00,15", "10:07:00,11", "10:08:00,8"]);
    let told = json(&format!("fit amplitudes {falling} --period 2s"))["told_from_file"].to_string();
    assert!(told.contains("read as position: column 1"), "{told}");
}

#[test]
fn rows_that_summarise_others_are_left_out() {
    let rows =
        ["L (m),T (s),", "0.20,0.8975,", "0.35,1.1869,", "0.50,1.4186,", "0.65,1.6174,", "0.80,1.7943,"];
    for label in ["écart-type", "s.d.", "Mean value", "mean (all)", "Unsicherheit", "Mw."] {
        let row = format!("0.2944,0.4075,{label}");
        let lines: Vec<&str> = rows.iter().copied().chain([row.as_str()]).collect();
        let (answer, _) = lengths(&table("summary", &lines));
        assert_eq!(answer["rows"], 5, "{label}");
    }
    // A team may be called Max.
    let named = ["team,L (m),T (s)", "Anna,0.20,0.8975", "Max,0.35,1.1869", "Paul,0.50,1.4186"];
    assert_eq!(lengths(&table("max", &named)).0["rows"], 3);
    let bounds = [
        "label,L (m),T (s)",
        "a,0.20,0.8975",
        "b,0.35,1.1869",
        "c,0.50,1.4186",
        "min,0.20,0.8975",
        "max,0.50,1.4186",
    ];
    assert_eq!(lengths(&table("bounds", &bounds)).0["rows"], 3);
}

#[test]
fn rows_with_typing_errors_are_named_by_their_lines() {
    let lines =
        ["L (cm),T (s)", "20,0.8975", "35,1.1869", "50,1.5186", "65,1.6174", "80,1.7943", "100,2.0061"];
    let sheet = unfolded(&text(&format!("fit lengths {}", table("typo", &lines))));
    assert!(sheet.contains("line 4 is far from the law of the others: without it g is 9.8"), "{sheet}");
    let lines =
        ["amplitude (deg),T (s)", "10,2.002", "20,2.015", "30,20.40", "40,2.065", "50,2.095", "60,2.146"];
    let sheet = unfolded(&text(&format!("fit periods {}", table("typo-period", &lines))));
    assert!(sheet.contains("without it T₀ is 1.99") && sheet.contains("(line 4)"), "{sheet}");
}

/// Periods of 2π√(L/g), g = 9.81 m/s², times a number of swings, to a hundredth of a second.
fn times(lengths: &[f64], swings: f64) -> Vec<String> {
    let time = |length: &f64| swings * std::f64::consts::TAU * (length / 9.81).sqrt();
    lengths.iter().map(|length| format!("{length},{:.2}", time(length))).collect()
}

#[test]
fn the_lengths_decide_if_a_heading_numbers_swings_or_readings() {
    let lengths = [0.2, 0.35, 0.5, 0.8, 1.0];
    for (name, heading, swings) in [
        ("t5_of_five", "L (m),T5 (s)", 5.0),
        ("t5_of_one", "L (m),T5 (s)", 1.0),
        ("t20", "L,t20", 20.0),
        ("t2", "L (m),T2 (s)", 2.0),
    ] {
        let rows = times(&lengths, swings);
        let lines = [vec![heading], rows.iter().map(String::as_str).collect()].concat();
        let answer = json(&format!("fit lengths {}", table(name, &lines)));
        let gravity = answer["gravity_m_per_s2"].as_f64().unwrap();
        assert!((gravity / 9.81 - 1.0).abs() < 0.03, "{heading}: {gravity}");
        assert_eq!(answer["read_columns"][1]["swings"], swings, "{answer}");
        let told = answer["told_from_file"].to_string();
        assert!(told.contains("would give g far from 9.8 m/s² (--swings-per-reading)"), "{told}");
    }
}

#[test]
fn a_number_in_a_heading_that_lengths_do_not_decide_is_asked_for() {
    let periods = ["theta (deg),T5 (s)", "5,7.10", "10,7.12", "20,7.15", "30,7.22"];
    let path = table("numbered_periods", &periods);
    let refused = libration(&format!("fit periods {path}"));
    assert_eq!(refused.status.code(), Some(1));
    let said = unfolded(&message(&refused));
    assert!(said.contains("give --swings-per-reading 5 or --swings-per-reading 1"), "{said}");
    json(&format!("fit periods {path} --swings-per-reading=5"));
    // Centimetres without a unit: 10 swings of 20 cm last as long as one of 20 m.
    let centimetres = ["L,T10", "20,8.97", "50,14.19", "100,20.06"];
    let squares = ["L (m),T2", "0.2,0.805", "0.3,1.207", "0.4,1.610"];
    for (name, lines) in [("centimetres", &centimetres), ("squares_as_t2", &squares)] {
        let refused = libration(&format!("fit lengths {}", table(name, lines)));
        assert_eq!(refused.status.code(), Some(1), "{name}");
        assert!(message(&refused).contains("--swings-per-reading "), "{}", message(&refused));
    }
}

/// Two tables of the same readings give the same g, uncertainty and coverage factor.
#[track_caller]
fn agree(one: &str, other: &str) {
    let [one, other] = [one, other].map(|path| json(&format!("fit lengths {path}")));
    for name in ["gravity_m_per_s2", "gravity_uncertainty_m_per_s2", "coverage_factor"] {
        let [one, other] = [&one, &other].map(|answer| answer[name].as_f64().unwrap());
        assert!((one / other - 1.0).abs() < 1e-6, "{name}: {one} {other}");
    }
}

/// Means and standard deviations of the readings in the first table, to nine decimals.
#[test]
fn means_with_standard_deviations_are_as_good_as_their_readings() {
    let readings: [[f64; 4]; 5] = [
        [0.2, 0.8991, 0.9121, 0.8846],
        [0.35, 1.1901, 1.1733, 1.1992],
        [0.5, 1.4181, 1.4322, 1.4093],
        [0.75, 1.7333, 1.7512, 1.7398],
        [1.0, 2.0012, 1.9903, 2.0187],
    ];
    let line = |row: &[f64; 4]| row.map(|row| row.to_string()).join(",");
    let summary = |row: &[f64; 4]| {
        let [length, rest @ ..] = row;
        let mean = rest.iter().sum::<f64>() / 3.0;
        let squares: f64 = rest.iter().map(|reading| (reading - mean) * (reading - mean)).sum();
        format!("{length},{mean:.9},{:.9},3", (squares / 2.0).sqrt())
    };
    let of = |name: &str, header: &str, row: &dyn Fn(&[f64; 4]) -> String| {
        let rows: Vec<String> = readings.iter().map(row).collect();
        table(name, &[vec![header], rows.iter().map(String::as_str).collect()].concat())
    };
    let all = of("all_readings", "L (m),T1 (s),T2 (s),T3 (s)", &line);
    let summaries = of("summaries", "L (m),T (s),sd (s),n", &summary);
    agree(&all, &summaries);
    let answer = json(&format!("fit lengths {summaries}"));
    let told = answer["told_from_file"].to_string();
    assert!(told.contains("read as standard deviation of single readings of the period: column 3"), "{told}");
    assert!(told.contains("(10 degrees of freedom)"), "{told}");
    assert_eq!(answer["read_columns"][3]["role"], "readings");
    agree(&summaries, &format!("{summaries} --role 3=period-deviation --role 4=readings"));
    for (wrong, cells) in [("number", "0.01,2.5"), ("deviation", "-0.01,3")] {
        let lines = [
            "L (m),T (s),sd (s),number of readings",
            "0.2,0.9,0.01,3",
            &format!("0.5,1.4,{cells}"),
            "1,2,0.01,3",
        ];
        let roles = "--role 3=period-deviation --role 4=readings";
        let refused = libration(&format!("fit lengths {} {roles}", table(&format!("bad_{wrong}"), &lines)));
        assert_eq!(refused.status.code(), Some(1), "{wrong}");
        assert!(message(&refused).contains("line 3: the "), "{}", message(&refused));
    }
}

#[test]
fn rows_that_repeat_others_count_once_and_are_named() {
    let rows = ["0.2,0.893", "0.35,1.189", "0.5,1.427", "0.75,1.731", "1,2.011"];
    let once = table("rows_once", &[&["L (m),T (s)"], &rows[..]].concat());
    let twice = table("rows_twice", &[&["L (m),T (s)"], &rows[..], &rows[..]].concat());
    let each: Vec<&str> = rows.iter().flat_map(|row| [*row, *row]).collect();
    let each = table("rows_each", &[&["L (m),T (s)"], &each[..]].concat());
    for (path, said) in [
        (&twice, "lines 7 to 11 repeat lines 2 to 6, number by number: they count once"),
        (&each, "each row is repeated in 2 lines: it counts once"),
    ] {
        agree(&once, path);
        let answer = json(&format!("fit lengths {path}"));
        assert_eq!(answer["rows"], 5);
        assert!(answer["told_from_file"].to_string().contains(said), "{answer}");
    }
}

#[test]
fn a_negative_length_of_a_simple_pendulum_is_named() {
    let rows = ["L (m),T (s)", "0.2,0.897", "-0.35,1.187", "0.5,1.418", "0.75,1.737", "1,2.006"];
    let refused = libration(&format!("fit lengths {}", table("negative_length", &rows)));
    assert_eq!(refused.status.code(), Some(1));
    let said = unfolded(&message(&refused));
    assert!(
        said.contains("row 2: the length -0.35 m is negative") && said.contains("correct the sign"),
        "{said}"
    );
}
