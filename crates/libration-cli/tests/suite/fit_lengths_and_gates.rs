//! `libration fit lengths` and `libration fit gates`.

use crate::command::{directory, json, libration, message, text, unfolded};
use std::path::PathBuf;

fn example(name: &str) -> String {
    format!("{}/../../examples/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn file(name: &str, text: &str) -> String {
    let path: PathBuf = directory(name).join("file.csv");
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

/// The distance of a value from the true one, in units of its uncertainty.
fn pull(answer: &serde_json::Value, name: &str, uncertainty: &str, truth: f64) -> f64 {
    (answer[name].as_f64().unwrap() - truth).abs() / answer[uncertainty].as_f64().unwrap()
}

#[test]
fn the_example_of_lengths_gives_its_truth_back() {
    let lengths = example("lengths_synthetic.csv");
    let answer = json(&format!("fit lengths {lengths} --amplitude 10deg --bob-radius 25mm"));
    assert_eq!(answer["rows"], 12);
    assert!(pull(&answer, "gravity_m_per_s2", "gravity_uncertainty_m_per_s2", 9.81) < 3.0);
    assert!(pull(&answer, "offset_m", "offset_uncertainty_m", 0.025) < 3.0);
    assert!(answer["warnings"][0].as_str().unwrap().contains("offset is needed"));
    assert_eq!(answer["warning_kinds"][0], "offset_needed");
    let sheet = text(&format!("fit lengths {lengths}"));
    assert!(sheet.contains("offset+gyration") && sheet.contains("gravity"));
}

#[test]
fn the_example_of_a_bar_gives_its_truth_back() {
    let bar = example("bar_synthetic.csv");
    let answer = json(&format!("fit lengths {bar}"));
    assert_eq!(
        (&answer["law"], &answer["warning_kinds"][0]),
        (&"bar+offset".into(), &"physical_pendulum".into())
    );
    assert!(pull(&answer, "gravity_m_per_s2", "gravity_uncertainty_m_per_s2", 9.81) < 3.0, "{answer}");
    assert!(pull(&answer, "offset_m", "offset_uncertainty_m", -0.5012) < 3.0);
    let k = 1.0 / 12.0_f64.sqrt();
    assert!(pull(&answer, "radius_of_gyration_m", "radius_of_gyration_uncertainty_m", k) < 3.0);
    assert!(answer["exponent"].is_null());
    let sheet = text(&format!("fit lengths {bar}"));
    assert!(sheet.contains("centre of mass") && sheet.contains("k, gyration"), "{sheet}");
    let picture = directory("bar-drawn").join("bar.svg");
    text(&format!("fit lengths {bar} --figure {}", picture.display()));
    assert!(std::fs::read_to_string(picture).unwrap().contains("T₀²h / (m s²)"));
}

#[test]
fn the_example_of_a_reversible_pendulum_gives_its_truth_back() {
    let table = example("reversible_synthetic.csv");
    let command = format!("fit lengths {table} --model reversible");
    let answer = json(&format!("{command} --edges 0.9935m±0.0001m"));
    assert!(pull(&answer, "gravity_m_per_s2", "gravity_uncertainty_m_per_s2", 9.81) < 3.0, "{answer}");
    let uncertainty = |answer: &serde_json::Value| answer["gravity_uncertainty_m_per_s2"].as_f64().unwrap();
    // Without the distance of the edges that of the centre of mass is in both terms.
    assert!(uncertainty(&json(&command)) > 5.0 * uncertainty(&answer));
    assert_eq!(answer["budget_inputs"][2]["input"], "centre of mass");
    let refused = message(&libration(&format!("fit lengths {table} --edges 0.9935m")));
    assert!(refused.contains("--model"), "{refused}");
    let lengths = example("lengths_synthetic.csv");
    let refused = message(&libration(&format!("fit lengths {lengths} --model reversible")));
    assert!(refused.contains("two distances"), "{refused}");
}

#[test]
fn the_exponent_of_the_length_is_fitted() {
    let answer = json(&format!("fit lengths {} --amplitude 10deg", example("lengths_synthetic.csv")));
    let exponent = answer["exponent"].as_f64().unwrap();
    // Lengths that are too short by 25 mm make it less than one half.
    assert!(
        0.4 < exponent && exponent + 3.0 * answer["exponent_uncertainty"].as_f64().unwrap() < 0.5,
        "{answer}"
    );
}

/// T² = 4π²(L + 0.01)/9.81, to twelve digits.
const EXACT: &str = "L,half\n25,0.511448657526\n50,0.716309081159\n75,0.874424193522\n100,1.008036031441\n";

#[test]
fn half_periods_and_centimetres_are_taken_as_said() {
    let table = file("lengths-half", EXACT);
    let answer = json(&format!("fit lengths {table} --length-unit cm --half-periods"));
    assert!((answer["gravity_m_per_s2"].as_f64().unwrap() - 9.81).abs() < 1e-9, "{answer}");
    assert!((answer["offset_m"].as_f64().unwrap() - 0.01).abs() < 1e-9);
    let csv = text(&format!("fit lengths {table} --length-unit cm --half-periods --csv"));
    assert!(csv.starts_with("law,g_m_per_s2,") && csv.lines().count() == 4, "{csv}");
}

#[test]
fn the_line_is_drawn() {
    let picture = directory("lengths-drawn").join("lengths.svg");
    text(&format!("fit lengths {} --figure {}", example("lengths_synthetic.csv"), picture.display()));
    let svg = std::fs::read_to_string(picture).unwrap();
    assert!(svg.contains("length L / m") && svg.contains("residual / s"));
}

#[test]
fn the_example_of_a_gate_gives_its_truth_back() {
    let gate = example("gate_synthetic.csv");
    // One shell word per option: the tests split at blanks.
    let answer = json(&format!("fit gates {gate} --length 0.958m±0.001m --diameter 25.0(1)mm"));
    assert_eq!((&answer["missed_passages"], &answer["unpaired_edges"]), (&1.into(), &1.into()));
    assert!(pull(&answer, "t0_s", "t0_uncertainty_s", std::f64::consts::TAU / 3.2) < 3.0, "{answer}");
    assert!(pull(&answer, "beta", "beta_uncertainty", 1.0) < 3.0);
    // The simulated pendulum has neither air drag nor a rod.
    assert!(pull(&answer, "gravity_m_per_s2", "gravity_uncertainty_m_per_s2", 9.81) < 3.0);
    assert!(answer["budget"].as_array().unwrap().len() >= 9);
    assert_eq!(answer["t0_by"], "the speeds at the gate");
    let csv = text(&format!("fit gates {gate} --csv"));
    assert!(csv.starts_with("time_s,period_s,side,amplitude_rad\n"));
}

/// A light sensor below the pendulum, and a phone as its bob: released from a known angle, both give the period of small swings.
#[test]
fn passages_are_found_in_continuous_signals() {
    let period = std::f64::consts::TAU / 3.2;
    for (name, column, amplitude, events) in
        [("light", "2", "0.2", "20 dips of column 2"), ("acceleration", "3", "0.35", "20 peaks of column 3")]
    {
        let signal = example(&format!("{name}_synthetic.csv"));
        let refused = message(&libration(&format!("fit gates {signal}")));
        assert!(refused.trim_end().ends_with(&format!("give --signal {column}")), "{refused}");
        let inspected = unfolded(&text(&format!("inspect {signal}")));
        assert!(inspected.contains(&format!("give --signal {column}")), "{inspected}");
        let fit = format!("fit gates {signal} --signal {column} --amplitude {amplitude}");
        let answer = json(&format!("{fit} --length 0.958m±0.001m"));
        assert!(pull(&answer, "t0_s", "t0_uncertainty_s", period) < 3.0, "{answer}");
        assert!(answer["t0_uncertainty_s"].as_f64().unwrap() < 5e-3, "{answer}");
        assert!(pull(&answer, "gravity_m_per_s2", "gravity_uncertainty_m_per_s2", 9.81) < 3.0, "{answer}");
        assert_eq!(answer["missed_passages"], 0);
        let findings = answer["told_from_file"].to_string();
        assert!(findings.contains(events), "{findings}");
    }
    let across =
        message(&libration(&format!("fit gates {} --signal 2", example("acceleration_synthetic.csv"))));
    assert!(across.contains("stand out from its noise"), "{across}");
}

#[test]
fn passages_without_an_amplitude_give_the_period_alone() {
    let times: String = (0..12).map(|k| format!("{}\n", f64::from(k) + 0.1 * f64::from(k % 2))).collect();
    let times = file("gate-bare", &format!("Time (s)\n{times}"));
    let answer = json(&format!("fit gates {times}"));
    assert!((answer["mean_period_s"].as_f64().unwrap() - 2.0).abs() < 1e-12);
    assert!(answer["t0_s"].is_null() && answer["note"].as_str().unwrap().contains("amplitude"));
    let sheet = text(&format!("fit gates {times} --amplitude 20deg --length 1m"));
    assert!(
        sheet.contains("from the amplitude of the release") && sheet.contains("finite amplitude"),
        "{sheet}"
    );
}

#[test]
fn the_periods_are_drawn() {
    let picture = directory("gates-drawn").join("gates.svg");
    let gate = example("gate_synthetic.csv");
    text(&format!("fit gates {gate} --length 0.958m --diameter 25mm --figure {}", picture.display()));
    let svg = std::fs::read_to_string(picture).unwrap();
    assert!(svg.contains("the other side") && svg.contains("exact law"));
}

/// Five passages give three periods, whose mean is not that of the release.
#[test]
fn few_passages_give_no_period_of_small_swings() {
    let few = file("gate-five", "Time (s)\n0.4992\n1.5021\n2.5043\n3.5050\n4.5060\n");
    let sheet = text(&format!("fit gates {few} --amplitude 0.6rad --length 0.958m"));
    assert!(sheet.contains("seven") && !sheet.contains("gravity"), "{sheet}");
}

#[test]
fn what_tells_nothing_is_refused_with_a_reason() {
    let few = file("gate-few", "0.1\n1.1\n2.1\n");
    assert!(message(&libration(&format!("fit gates {few}"))).contains("too few"));
    let equal = file("lengths-equal", "1,2.0\n1,2.01\n1,2.02\n");
    assert!(message(&libration(&format!("fit lengths {equal}"))).contains("all the same"));
    let both = file("lengths-amplitudes", "1,2.0,0.1\n0.5,1.4,0.1\n0.25,1.0,0.1\n");
    let both = libration(&format!("fit lengths {both} --columns 1,2,-,-,3 --amplitude 10deg"));
    assert!(message(&both).contains("--amplitude"));
    let rod = libration(&format!("fit gates {few} --length 1m --rod-mass 5g"));
    assert!(message(&rod).contains("--bob-mass"));
}

/// T² = 4π²L/9.81 with lengths in cm, and periods in units of one second divided by `per_second`.
fn swings(per_second: f64) -> Vec<(f64, f64)> {
    let period = |length: f64| std::f64::consts::TAU * (0.01 * length / 9.81).sqrt();
    [20.0, 40.0, 70.0, 100.0].map(|length| (length, per_second * period(length))).to_vec()
}

fn rows(header: &str, rows: &[(f64, f64)]) -> String {
    let lines: String = rows.iter().map(|(first, second)| format!("{first},{second}\n")).collect();
    format!("{header}\n{lines}")
}

fn gravity(command: &str) -> f64 {
    json(command)["gravity_m_per_s2"].as_f64().unwrap()
}

#[test]
fn units_in_the_header_are_taken_and_told() {
    let centimetres = file("lengths-cm", &rows("L (cm),T (s)", &swings(1.0)));
    assert!((gravity(&format!("fit lengths {centimetres}")) - 9.81).abs() < 1e-9);
    let sheet = text(&format!("fit lengths {centimetres}"));
    assert!(sheet.contains("column 1 (`L (cm)`) is in cm"), "{sheet}");
    for (unit, per_second) in [("ms", 1e3), ("us", 1e6)] {
        let table = file(&format!("lengths-{unit}"), &rows(&format!("L/cm,T/{unit}"), &swings(per_second)));
        let answer = json(&format!("fit lengths {table}"));
        assert!((answer["gravity_m_per_s2"].as_f64().unwrap() - 9.81).abs() < 1e-9, "{answer}");
        let told = answer["told_from_file"].to_string();
        assert!(told.contains(&format!("is in {unit}")), "{told}");
    }
}

#[test]
fn an_option_overrides_the_unit_of_the_header_and_says_so() {
    let wrong = file("lengths-wrong-unit", &rows("L (mm),T (s)", &swings(1.0)));
    let answer = json(&format!("fit lengths {wrong} --length-unit cm"));
    assert!((answer["gravity_m_per_s2"].as_f64().unwrap() - 9.81).abs() < 1e-9, "{answer}");
    let told = answer["told_from_file"].to_string();
    assert!(told.contains("--length-unit") && told.contains("not in mm"), "{told}");
    let yards = file("lengths-yards", &rows("L (yd),T (s)", &swings(1.0)));
    let refused = message(&libration(&format!("fit lengths {yards}")));
    assert!(refused.contains("`yd`") && refused.contains("--length-unit"), "{refused}");
}

#[test]
fn uncertainties_may_have_a_unit_of_their_own() {
    let table = |header: &str, of_length: f64| {
        let line = |(length, period)| format!("{length},{period},{of_length},0.001\n");
        format!("{header}\n{}", swings(1.0).into_iter().map(line).collect::<String>())
    };
    let of_headings = file("lengths-own", &table("L (cm),T (s),sigma_L (mm),sigma_T", 2.0));
    let same = file("lengths-same", &table("L (cm),T (s),sigma_L,sigma_T", 0.2));
    let spread =
        |table: &str| json(&format!("fit lengths {table}"))["gravity_uncertainty_m_per_s2"].as_f64().unwrap();
    assert!((spread(&of_headings) / spread(&same) - 1.0).abs() < 1e-9);
}

/// Names and units in the header count for more than the order of the columns, and less than an option.
#[test]
fn columns_in_another_order_are_found_by_their_headings() {
    let swapped: Vec<(f64, f64)> = swings(1.0).into_iter().map(|(length, period)| (period, length)).collect();
    for (header, unit) in
        [("T (s),L (cm)", ""), ("T,L", "--length-unit cm"), ("period,length", "--length-unit cm")]
    {
        let table = file("lengths-swapped", &rows(header, &swapped));
        assert!((gravity(&format!("fit lengths {table} {unit}")) - 9.81).abs() < 1e-9, "{header}");
    }
    let swapped = file("lengths-in-order", &rows("T (s),L (cm)", &swapped));
    assert!((gravity(&format!("fit lengths {swapped} --columns 2,1")) - 9.81).abs() < 1e-9);
    let refused = libration(&format!("fit lengths {swapped} --columns 1,2"));
    assert_eq!(refused.status.code(), Some(1));
    assert!(message(&refused).contains("holds times"), "{}", message(&refused));
}

#[test]
fn uncertainties_beside_their_values_are_told_from_the_header() {
    let table = |name: &str, header: &str, order: [usize; 4]| {
        let line = |(length, period): (f64, f64)| {
            let cells = [length, period, 0.2, 0.001];
            order.map(|column| cells[column].to_string()).join(",") + "\n"
        };
        file(name, &format!("{header}\n{}", swings(1.0).into_iter().map(line).collect::<String>()))
    };
    let plain = json(&format!("fit lengths {}", table("lengths-plain", "L (cm),T,σ_L,σ_T", [0, 1, 2, 3])));
    for (name, header) in [
        ("lengths-between", "L (cm),sigma_L,T,sigma_T"),
        ("lengths-plus-minus", "L (cm),±,T (s),±"),
        ("lengths-u", "L (cm),u(L),T,u(T)"),
    ] {
        let between = json(&format!("fit lengths {}", table(name, header, [0, 2, 1, 3])));
        for field in ["gravity_m_per_s2", "gravity_uncertainty_m_per_s2"] {
            assert_eq!(between[field], plain[field], "{header}");
        }
    }
    let three = file("periods-three", "A (deg),T (s),±\n10,2.0038,0.001\n40,2.0626,0.001\n70,2.2042,0.001\n");
    let answer = json(&format!("fit periods {three}"));
    assert!(answer["weighting"] == "uncertainties of periods", "{answer}");
}

/// T at 10°, 40° and 70° for T0 = 2 s, multiplied by these factors, with relative uncertainties.
fn periods(name: &str, header: &str, count: f64) -> String {
    let ratios = [(10.0, 1.001907188), (40.0, 1.031340519), (70.0, 1.102144914)];
    let line = |(angle, ratio)| format!("{angle},{},{}\n", 2.0 * count * ratio, 0.002 * count);
    file(name, &format!("{header}\n{}", ratios.map(line).concat()))
}

#[test]
fn headers_say_how_many_periods_a_time_lasts() {
    let one = json(&format!("fit periods {}", periods("periods-one", "A (deg),T (s),±", 1.0)));
    let of = |answer: &serde_json::Value, field: &str| answer["laws"][0][field].as_f64().unwrap();
    let (t0, spread) = (of(&one, "t0_s"), of(&one, "t0_uncertainty_s"));
    assert!((t0 - 2.0).abs() < 1e-7, "{one}");
    for (name, header, count, options) in [
        ("periods-half", "A (deg),half period (s),±", 0.5, ""),
        ("periods-ten", "A (deg),time of 10 periods (s),±", 10.0, ""),
        ("periods-10T", "A (deg),10T,u(10T)", 10.0, ""),
        ("periods-20T", "A (deg),20 T (s),σ", 20.0, ""),
        ("periods-T/2", "A (deg),T/2,±", 0.5, ""),
        ("periods-said", "A (deg),T,±", 0.5, "--half-periods"),
        ("periods-counted", "A (deg),T10 (s),±", 10.0, "--swings-per-reading 10"),
    ] {
        let name = name.replace('/', "-");
        let answer = json(&format!("fit periods {} {options}", periods(&name, header, count)));
        for (field, expected) in [("t0_s", t0), ("t0_uncertainty_s", spread)] {
            let computed = of(&answer, field);
            assert!((computed / expected - 1.0).abs() < 1e-12, "{header}: {field} {computed} {expected}");
        }
        let told = answer["told_from_file"].to_string();
        assert!(told.contains("period"), "{header}: {told}");
    }
    let halves = file("lengths-half-said", &rows("L (cm),half period (s)", &swings(0.5)));
    assert!((gravity(&format!("fit lengths {halves}")) - 9.81).abs() < 1e-9);
    let tens = file("lengths-ten", &rows("L (cm),10 T (s)", &swings(10.0)));
    assert!((gravity(&format!("fit lengths {tens}")) - 9.81).abs() < 1e-9);
    let both = libration(&format!("fit lengths {tens} --half-periods --swings-per-reading 3"));
    assert_eq!(both.status.code(), Some(2));
}

#[test]
fn what_may_be_several_periods_is_asked() {
    for (command, table) in [
        ("periods", periods("periods-unclear", "A (deg),T10 (s),±", 10.0)),
        ("lengths", file("lengths-unclear", &rows("L (cm),T/10 (s)", &swings(10.0)))),
    ] {
        let refused = libration(&format!("fit {command} {table}"));
        assert_eq!(refused.status.code(), Some(1));
        assert!(message(&refused).contains("--swings-per-reading"), "{}", message(&refused));
    }
}

#[test]
fn a_trace_and_milliseconds_without_a_unit_are_no_passages() {
    let swing: String =
        (0..300).map(|n| format!("{:.4},{:.4}\n", f64::from(n) / 30.0, (f64::from(n) / 7.0).cos())).collect();
    let swing = file("gate-swing", &format!("time,angle\n{swing}"));
    let refused = libration(&format!("fit gates {swing}"));
    assert_eq!(refused.status.code(), Some(1));
    assert!(message(&refused).contains("--time 1"), "{}", message(&refused));
    let passages: String = (1..20).map(|n| format!("{}\n", 760 * n + 3 * (n % 2))).collect();
    let passages = file("gate-milliseconds", &format!("time\n{passages}"));
    let refused = message(&libration(&format!("fit gates {passages}")));
    assert!(refused.contains("--time-unit s, ms, us or min"), "{refused}");
    let answer = json(&format!("fit gates {passages} --time-unit ms"));
    assert!((answer["mean_period_s"].as_f64().unwrap() - 1.52).abs() < 1e-9, "{answer}");
}

#[test]
fn a_gravity_found_nowhere_is_doubted() {
    let halves = file("lengths-half-unsaid", &rows("L (cm),T (s)", &swings(0.5)));
    let sheet = text(&format!("fit lengths {halves}"));
    assert!(sheet.contains("warning") && sheet.contains("--half-periods"), "{sheet}");
    let answer = json(&format!("fit lengths {halves}"));
    assert!((answer["gravity_m_per_s2"].as_f64().unwrap() - 39.24).abs() < 1e-8);
    assert!(answer["warnings"].to_string().contains("--half-periods"));
    assert!(answer["warning_kinds"].to_string().contains("gravity_contradicted"));
    assert!(!text(&format!("fit lengths {halves} --half-periods")).contains("warning"));
    let metres = file("lengths-no-unit", &rows("L,T", &swings(1.0)));
    let sheet = unfolded(&text(&format!("fit lengths {metres}")));
    assert!(sheet.contains("lengths in centimetres read as metres would give (--length-unit cm)"), "{sheet}");
}

#[test]
fn the_columns_are_read_with_roles_units_and_numbers_of_swings_as_data() {
    let lines = (1..6).map(|n| {
        format!("{},{:.3},{:.3},0.2,calm\n", 20 * n, 8.97 * f64::from(n).sqrt(), 8.98 * f64::from(n).sqrt())
    });
    let table = format!("L (cm),10 T (s),10 T (s),u(L) (cm),weather\n{}", lines.collect::<String>());
    let table = file("lengths-columns", &table);
    let columns = |options: &str| json(&format!("fit lengths {table} {options}"))["read_columns"].clone();
    let role = |number: u64, role: &str, unit: Option<&str>, is_stated: bool, swings: Option<f64>| serde_json::json!({ "number": number, "role": role, "unit": unit, "unit_is_stated": is_stated, "swings": swings });
    let times = |number| role(number, "period", Some("s"), true, Some(10.0));
    let all = [
        role(1, "length", Some("cm"), true, None),
        times(2),
        times(3),
        role(4, "length-uncertainty", Some("cm"), true, None),
        role(5, "ignore", None, false, None),
    ];
    assert_eq!(columns(""), serde_json::json!(all));
    assert_eq!(json(&format!("inspect {table}"))["table_columns"][3]["role"], "length-uncertainty");
    let given = columns("--columns 1,2 --swings-per-reading 5");
    assert_eq!(given, serde_json::json!([all[0].clone(), role(2, "period", Some("s"), true, Some(5.0))]));
    let bare = file("lengths-columns-bare", "L,T\n0.25,1.003\n0.5,1.42\n1,2.006\n");
    let bare = json(&format!("fit lengths {bare}"))["read_columns"].clone();
    assert_eq!(
        bare,
        serde_json::json!([
            role(1, "length", Some("m"), false, None),
            role(2, "period", Some("s"), false, Some(1.0))
        ])
    );
}

#[test]
fn periods_are_no_times_of_a_gate() {
    let periods = file("gate-periods", "T (s)\n2.01\n2.02\n1.99\n2.03\n2.0\n2.01\n1.98\n");
    let refused = message(&libration(&format!("fit gates {periods}")));
    assert!(refused.contains("3 of 7 times") && refused.contains("libration fit periods"), "{refused}");
}

/// Passages at the centre are as even as samples, and their numbers are no signal.
#[test]
fn passages_may_be_numbered() {
    let row = |passage: i32| format!("{passage},{:.2}\n", 0.75 * f64::from(passage));
    let rows = (1..9).map(row).collect::<String>();
    let numbered = file("gate-numbered", &format!("passage,Time (s)\n{rows}"));
    let answer = json(&format!("fit gates {numbered}"));
    assert!((answer["mean_period_s"].as_f64().unwrap() - 1.5).abs() < 1e-12, "{answer}");
    let voltages = file("gate-voltages", &format!("U (V),Time (s)\n{}", rows.replace(",0.75", ".5,0.75")));
    assert!(message(&libration(&format!("fit gates {voltages}"))).contains("recording of samples"));
}

#[test]
fn times_of_a_gate_are_no_trace() {
    for (name, text) in
        [("gate-alone", "Time (s)\n1\n1.1\n2\n"), ("gate-state", "Time (s),GateState\n1,1\n2,0\n3,1\n")]
    {
        let refused = message(&libration(&format!("fit trace {}", file(name, text))));
        assert!(refused.contains("libration fit gates"), "{refused}");
    }
}

#[test]
fn what_an_option_got_wrong_is_not_blamed_on_the_file() {
    let (lengths, gate) = (example("lengths_synthetic.csv"), example("gate_synthetic.csv"));
    for (question, blamed, reason) in [
        (format!("fit lengths {lengths} --amplitude 200deg"), "--amplitude: ", "not below pi"),
        (format!("fit gates {gate} --amplitude 200deg"), "--amplitude: ", "not below pi"),
        (format!("fit gates {gate} --amplitude 0"), "--amplitude: ", "above zero"),
        (format!("fit gates {gate} --length 1m --diameter 3m"), "gate: ", "would reach the pivot"),
        (format!("fit gates {gate} --length 1m --bob-radius 1m"), "gate: ", "would reach the pivot"),
        (
            format!("fit gates {gate} --length 1m --bob-radius 1cm --gate-distance 40m"),
            "gate: ",
            "does not pass",
        ),
    ] {
        let refused = libration(&question);
        assert_eq!(refused.status.code(), Some(1), "{question}");
        let message = message(&refused);
        assert!(message.contains(&format!("error: {blamed}")) && message.contains(reason), "{message}");
    }
    let bob = message(&libration(&format!("fit lengths {lengths} --bob-radius 0.25m")));
    assert!(bob.contains("reaches the pivot"), "{bob}");
}

#[test]
fn nothing_counts_twice() {
    let swing = example("swing_synthetic.csv");
    let model = libration(&format!("fit trace {swing} --model dry+linear+dry"));
    assert_eq!(model.status.code(), Some(2));
    assert!(message(&model).contains("dry damping is in the sum twice"), "{}", message(&model));
    let file = message(&libration(&format!("fit trace {swing} {swing} --model linear")));
    assert!(file.contains("the same rows"), "{file}");
    let pair = "--correlation length,rod-mass=0.9 --correlation rod-mass,length=-0.9";
    let rod = "--length 1.0(1)m --bob-mass 1kg --rod-mass 5(1)g";
    let twice = message(&libration(&format!("fit trace {swing} --model linear {rod} {pair}")));
    assert!(twice.contains("two correlations of rod mass and length"), "{twice}");
}
