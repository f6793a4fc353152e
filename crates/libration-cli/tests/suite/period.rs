//! `libration period`.

use crate::command::{close, directory, json, libration, message, text};

#[test]
fn decimal_degrees_mean_the_decimal() {
    let answer = json("period 179.999999deg --formulas bernoulli");
    assert_eq!(answer["results"][0]["ratio"], 12.696222116445628);
}

#[test]
fn every_field_of_the_contract_is_there() {
    let answer = json("period 60deg --formulas kidd_fogg");
    close(&answer["length_m"], 1.0, 0.0);
    close(&answer["gravity_m_per_s2"], 9.80665, 0.0);
    let result = &answer["results"][0];
    close(&result["amplitude_rad"], std::f64::consts::FRAC_PI_3, 0.0);
    close(&result["complement_rad"], 2.0 * std::f64::consts::FRAC_PI_3, 1e-16);
    close(&result["small_angle_period_s"], 2.006409292589, 1e-12);
    close(&result["period_s"], 2.1532423517838, 1e-12);
    close(&result["ratio"], 1.0731820071493643, 1e-15);
    close(&result["excess"], 0.0731820071493643, 1e-13);
    close(&result["nome"], 0.017972387008967, 1e-12);
    assert!(result["condition"].as_f64().unwrap() > 0.0);
    let formula = &result["formulas"][0];
    assert_eq!(formula["key"], "kidd_fogg");
    // 1/√cos 30°
    close(&formula["ratio"], 1.0745699318235418, 1e-15);
    close(&formula["period_s"], 1.0745699318235418 * 2.006409292589, 1e-12);
    close(&formula["fractional_error"], 1.0745699318235418 / 1.0731820071493643 - 1.0, 1e-10);
}

#[test]
fn the_complement_is_kept_all_the_way() {
    let result = &json("period pi-1e-300 --formulas butikov")["results"][0];
    assert_eq!(result["complement_rad"], 1e-300);
    // (2/π) ln(8/δ)
    close(&result["ratio"], std::f64::consts::FRAC_2_PI * (8f64.ln() + 300.0 * 10f64.ln()), 1e-14);
}

#[test]
fn the_whole_catalogue_is_in_the_json_and_sorted_as_asked() {
    let errors = |order: &str| -> Vec<f64> {
        let answer = json(&format!("period 60deg --sort {order}"));
        let formulas = answer["results"][0]["formulas"].as_array().unwrap().clone();
        formulas.iter().map(|formula| formula["fractional_error"].as_f64().unwrap().abs()).collect()
    };
    assert!(errors("error").is_sorted() && errors("error").len() > 15);
    assert!(!errors("catalogue").is_sorted());
}

#[test]
fn a_range_is_a_table_with_one_row_per_amplitude() {
    let table = text("period 1deg:179deg:1deg --csv --formulas bernoulli");
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines.len(), 180);
    assert!(lines[0].starts_with("amplitude_rad,complement_rad,small_angle_period_s,period_s,ratio,excess"));
    assert!(lines[0].ends_with("bernoulli_ratio,bernoulli_fractional_error"));
    assert_eq!(text("period 1deg:179deg:1deg").lines().count(), 184);
}

/// T/T0 by the arithmetic-geometric mean.
fn ratio(amplitude: f64) -> f64 {
    let (mut a, mut b) = (1.0, (0.5 * amplitude).cos());
    for _ in 0..10 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a.recip()
}

#[test]
fn every_row_of_a_range_has_the_right_values_and_every_formula() {
    let table = text("period 1deg:179deg:1deg --csv");
    let names: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let keys = json("period 60deg")["results"][0]["formulas"].as_array().unwrap().len();
    assert_eq!(names.len(), 8 + 2 * keys);
    let column = |name: &str| names.iter().position(|header| *header == name).unwrap();
    let t0 = std::f64::consts::TAU / 9.80665_f64.sqrt();
    let rows: Vec<&str> = table.lines().skip(1).collect();
    assert_eq!(rows.len(), 179);
    for (degrees, row) in (1_u32..).zip(rows) {
        let cells: Vec<f64> = row
            .split(',')
            .map(|cell| if cell.is_empty() { f64::NAN } else { cell.parse().unwrap() })
            .collect();
        let angle = f64::from(degrees).to_radians();
        let exact = ratio(angle);
        let bernoulli = 1.0 + angle * angle / 16.0;
        let expected = [
            ("amplitude_rad", angle),
            ("complement_rad", f64::from(180 - degrees).to_radians()),
            ("small_angle_period_s", t0),
            ("period_s", t0 * exact),
            ("ratio", exact),
            ("bernoulli_ratio", bernoulli),
        ];
        for (name, value) in expected {
            let computed = cells[column(name)];
            // Ten steps of the mean in `f64`, and the cosine next to 180°.
            assert!(
                (computed - value).abs() <= 1e-13 * value,
                "{name} at {degrees}°: {computed} is not {value}"
            );
        }
        let error = cells[column("bernoulli_fractional_error")];
        assert!((error - (bernoulli / exact - 1.0)).abs() < 1e-13, "{degrees}°: {error}");
        assert!((cells[column("excess")] - (exact - 1.0)).abs() < 1e-12);
    }
}

#[test]
fn a_range_says_the_same_as_json_as_csv_and_alone() {
    let all = json("period 10deg:170deg:40deg");
    let table = text("period 10deg:170deg:40deg --csv");
    let names: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let results = all["results"].as_array().unwrap();
    assert_eq!(results.len(), 5);
    for (result, row) in results.iter().zip(table.lines().skip(1)) {
        let degrees = result["amplitude_rad"].as_f64().unwrap().to_degrees().round();
        assert_eq!(result, &json(&format!("period {degrees}deg"))["results"][0]);
        for (name, cell) in names.iter().zip(row.split(',')) {
            let (key, field) = ["_fractional_error", "_ratio"]
                .iter()
                .find_map(|end| Some((name.strip_suffix(end)?, &end[1..])))
                .unwrap_or(("", name));
            let formula = result["formulas"].as_array().unwrap().iter().find(|formula| formula["key"] == key);
            let value = formula.map_or(&result[*name], |formula| &formula[field]);
            // A value that is not a number is null in JSON and nan in CSV.
            let number = cell.parse().ok().filter(|number: &f64| number.is_finite());
            assert_eq!(value.as_f64(), number, "{name} at {degrees}°");
        }
    }
}

#[test]
fn amplitudes_come_from_a_file_too() {
    let file = directory("amplitudes").join("amplitudes.txt");
    std::fs::write(&file, "# released from\n60deg\n\n1.2\npi-1e-6\n").unwrap();
    let answer = json(&format!("period --from-file {} --formulas molina", file.display()));
    assert_eq!(answer["results"].as_array().unwrap().len(), 3);
    assert_eq!(answer["results"][1]["amplitude_rad"], 1.2);
}

#[test]
fn the_sign_of_an_amplitude_does_not_count() {
    assert_eq!(text("period -30deg --csv"), text("period 30deg --csv"));
}

#[test]
fn the_defaults_are_said() {
    let sheet = text("period 60deg");
    assert!(sheet.contains("1 m (default)") && sheet.contains("9.80665 m/s² (default)"));
    assert!(!text("period 60deg --length 2m --gravity 9.81").contains("default"));
}

#[test]
fn length_and_gravity_set_the_scale() {
    let answer = json("period 60deg --length 57cm --gravity 9.81m/s^2 --formulas bernoulli");
    close(&answer["length_m"], 0.57, 1e-15);
    let period = std::f64::consts::TAU * (0.57f64 / 9.81).sqrt();
    close(&answer["results"][0]["small_angle_period_s"], period, 1e-15);
}

#[test]
fn a_reader_that_stops_reading_is_no_error() {
    let command = format!("{} period 0deg:179deg:0.001deg --csv | head -1", env!("CARGO_BIN_EXE_libration"));
    let script = format!("set -o pipefail; {command}");
    let output = std::process::Command::new("bash").args(["-c", &script]).output().unwrap();
    assert!(output.status.success() && output.stderr.is_empty());
}

#[test]
fn completions_and_help_are_written_to_the_output() {
    assert!(text("completions bash").contains("libration"));
    for command in ["period", "motion", "fourier", "formulas", "figure", "fit periods"] {
        assert!(libration(&format!("{command} --help")).status.success());
        assert!(text(&format!("{command} --help")).contains("Examples:"), "{command}");
    }
}

#[test]
fn period_and_motion_say_the_same_period_to_the_last_bit() {
    for angle in ["1deg", "1.2", "60deg", "179.999999deg", "pi-1e-300"] {
        let period = json(&format!("period {angle} --formulas bernoulli"));
        let motion = json(&format!("motion {angle} --times 0"));
        assert_eq!(period["results"][0]["period_s"], motion["period_s"], "{angle}");
    }
}

#[test]
fn amplitudes_follow_from_periods_ratios_and_excesses() {
    let forward = json("period 60deg --length=57cm");
    let swing = &forward["results"][0];
    for (option, field) in [("period", "period_s"), ("ratio", "ratio"), ("excess", "excess")] {
        let given = format!("period --{option}={} --length=57cm", swing[field]);
        let back = &json(&given)["results"][0];
        let off = (back["amplitude_rad"].as_f64().unwrap() - std::f64::consts::FRAC_PI_3).abs();
        let stated = back["amplitude_uncertainty_rad"].as_f64().unwrap();
        assert!(off <= stated && stated < 1e-14, "{option}: {off} {stated}");
    }
    assert!(swing.get("amplitude_uncertainty_rad").is_none());
    // Next to the top the complement has all digits: π − θ0 = 8 exp(−πR/2) to within its square.
    let top = &json("period --ratio=100")["results"][0];
    let expected = 8.0 * (-50.0 * std::f64::consts::PI).exp();
    let complement = top["complement_rad"].as_f64().unwrap();
    assert!((complement / expected - 1.0).abs() < 1e-13, "{complement}");
    assert!(top["amplitude_uncertainty_rad"].as_f64().unwrap() < 1e-13 * complement);
    let csv = text("period --excess=1e-20 --excess=7% --csv");
    let header = csv.lines().next().unwrap();
    assert!(header.contains(",amplitude_uncertainty_rad"), "{header}");
    assert!(csv.lines().nth(1).unwrap().starts_with("4e-10,"), "{csv}");
    assert_eq!(csv.lines().count(), 3);
}

/// The amplitudes for 2.09 and 2.11 s are 45.9° and 50.9°; numbers are printed to the second digit of the uncertainty.
#[test]
fn a_period_with_an_uncertainty_gives_digits_to_that_of_the_amplitude() {
    let text = text("period --period=2.10(1)s --formulas=bernoulli");
    assert!(text.contains("0.846 rad = 48.5°\n"), "{text}");
    assert!(text.contains("uncertainty of θ₀      0.045 rad = 2.6°\n"), "{text}");
}

fn refused(arguments: &str) -> String {
    let output = libration(arguments);
    assert!(!output.status.success(), "{arguments}");
    message(&output)
}

#[test]
fn periods_that_no_amplitude_has_are_refused_with_that_of_small_swings() {
    let short = refused("period --period=1.9s");
    assert!(
        short.contains("no amplitude has a period of 1.9 s: small swings of this pendulum take 2.0064"),
        "{short}"
    );
    // The period of small swings is accepted: itself, to its last digit, and within its uncertainty.
    for accepted in [
        "--period=2.0064092925890407s",
        "--period=2.0064092925890402s",
        "--period=2.00(1)s",
        "--ratio=0.99±0.02",
        "--excess=-0.001±0.01",
    ] {
        let rest = &json(&format!("period {accepted}"))["results"][0];
        assert!(
            rest["amplitude_rad"].as_f64().unwrap() <= rest["amplitude_uncertainty_rad"].as_f64().unwrap(),
            "{accepted}"
        );
    }
    assert!(refused("period --ratio=0.9").contains("T/T0 = 0.9: it is 1 for the smallest swings"));
    assert!(refused("period --excess=500").contains("give at most 441.08"));
    let far = refused("period --excess=1e300");
    assert!(far.contains("T/T0 = 1e300 is less") && far.contains("an excess of 440.08"), "{far}");
    assert!(refused("period --period=2,1s").contains("decimal point, 2.1s"));
    assert!(refused("period --period=3s 60deg").contains("cannot be used with"));
}

/// A length or gravity with an uncertainty of 1 % counts as a period with half of that.
#[test]
fn the_uncertainty_of_the_pendulum_goes_into_amplitudes_of_periods_and_elsewhere_is_named() {
    let uncertainty =
        |arguments: &str| json(arguments)["results"][0]["amplitude_uncertainty_rad"].as_f64().unwrap();
    let [of_length, of_gravity] = ["--length=1.00(1)m", "--gravity=9.80665±0.0980665"]
        .map(|given| uncertainty(&format!("period --period=2.10s {given}")));
    let of_period = uncertainty("period --period=2.10±0.0105s");
    assert!((of_length / of_period - 1.0).abs() < 1e-9 && (of_gravity / of_period - 1.0).abs() < 1e-9);
    for unused in [
        "period 60deg --length=1.00(1)m",
        "simulate pendulum --length=1.00(1)m --initial theta=1 --times 0,1",
    ] {
        assert!(message(&libration(unused)).contains("is not used here, only its value"), "{unused}");
    }
    assert!(!message(&libration("period --period=2.10s --length=1.00(1)m")).contains("not used"));
}
