//! `libration fit trace`.

use crate::command::{directory, json, libration, message, text};
use crate::fields::assert_described;
use serde_json::Value;
use std::fs;
use std::path::PathBuf;

/// Simulated by `reference/synthetic_swing.py` with another integrator: l = 0.56 m, g =
/// 9.81 m/s², linear drag 0.03 1/s, released at 60°, a zero offset of 1.2°, errors of 0.3°.
const SWING: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/swing_synthetic.csv");

fn parameter<'a>(answer: &'a Value, name: &str) -> &'a Value {
    let parameters = answer["parameters"].as_array().unwrap();
    parameters.iter().find(|parameter| parameter["name"] == name).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

/// Asserts that a value is within 3.5 standard uncertainties of the true one, and that its uncertainty is below `most`.
fn agrees(value: &Value, uncertainty: &Value, truth: f64, most: f64) {
    let (value, uncertainty) = (number(value), number(uncertainty));
    assert!((0.0..most).contains(&uncertainty), "{uncertainty}");
    assert!((value - truth).abs() < 3.5 * uncertainty, "{value} ± {uncertainty} is not {truth}");
}

#[test]
fn the_truth_of_a_synthetic_swing_is_found() {
    let answer = json(&format!("fit trace {SWING} --length 0.56m±0.002m"));
    assert_eq!(answer["model"], "linear");
    let truths = [
        ("omega0", (9.81_f64 / 0.56).sqrt(), 3e-4, "rad/s"),
        ("linear", 0.03, 3e-4, "1/s"),
        ("offset", 1.2_f64.to_radians(), 5e-4, "rad"),
        ("theta0", 60_f64.to_radians(), 1e-3, "rad"),
        ("velocity0", 0.0, 1e-2, "rad/s"),
    ];
    for (name, truth, most, unit) in truths {
        let fitted = parameter(&answer, name);
        agrees(&fitted["value"], &fitted["uncertainty"], truth, most);
        assert_eq!(fitted["unit"], unit);
    }
    agrees(&answer["beta"], &answer["beta_uncertainty"], 1.0, 0.02);
    agrees(&answer["gravity_m_per_s2"], &answer["gravity_uncertainty_m_per_s2"], 9.81, 0.04);
    // Normal errors of 0.3°, rounding to 0.1°, and times rounded to 1 ms at up to 250°/s.
    let rms = number(&answer["rms_residual_rad"]).to_degrees();
    assert!((0.29..0.33).contains(&rms), "{rms}");
    let interval = &parameter(&answer, "omega0")["interval_95"];
    assert!(number(&interval[0]) < truths[0].1 && truths[0].1 < number(&interval[1]));
}

#[test]
fn the_answer_has_the_fields_that_are_promised() {
    let answer = json(&format!("fit trace {SWING} --model linear --to 8s"));
    for field in ["files", "parameters", "cycles", "warnings", "advice", "traces", "findings", "correlations"]
    {
        assert!(answer[field].is_array(), "{field}");
    }
    let [advice, kinds] = ["advice", "advice_kinds"].map(|field| answer[field].as_array().unwrap());
    assert_eq!((kinds.len(), &kinds[0]), (advice.len(), &Value::from("give_length")));
    assert!(advice[0].as_str().unwrap().ends_with("(--length)"), "{advice:?}");
    for field in ["rms_residual_rad", "beta", "beta_uncertainty", "small_angle_period_s"] {
        assert!(answer[field].is_number(), "{field}");
    }
    assert!(answer["chi2_per_dof"].is_null() && answer["comparison"].is_null());
    assert_eq!(answer["files"][0], SWING);
    let cycles = answer["cycles"].as_array().unwrap();
    assert!(cycles.len() >= 6);
    for cycle in cycles {
        // T0 = 1.5012 s, and 7 % more at 60°.
        assert!((1.53..1.63).contains(&number(&cycle["period_s"])), "{cycle}");
        assert!((0.8..1.06).contains(&number(&cycle["amplitude_rad"])) && number(&cycle["time_s"]) < 8.0);
    }
    assert!(number(&answer["traces"][0]["last_s"]) <= 8.0);
    assert!(answer["length_in_standard_gravity_m"].is_number() && answer["gravity_m_per_s2"].is_null());
}

#[test]
fn the_sheet_says_what_was_found_and_what_would_help() {
    let sheet = text(&format!("fit trace {SWING} --length 0.56m±0.002m"));
    let sheet = sheet.split_whitespace().collect::<Vec<_>>().join(" ");
    for expected in
        ["T₀", "gravity", "β", "ΔAICc", "linear+quadratic", "to improve", "Measure the length", "--time"]
    {
        assert!(sheet.contains(expected), "{expected}: {sheet}");
    }
}

#[test]
fn rows_with_the_fitted_motion_are_written_as_csv() {
    let rows = text(&format!("fit trace {SWING} --model linear --to 5s --csv"));
    let mut lines = rows.lines();
    assert_eq!(lines.next(), Some("trace,time_s,value,fitted,residual"));
    let mut count = 0;
    for line in lines {
        let cells: Vec<f64> = line.split(',').skip(1).map(|cell| cell.parse().unwrap()).collect();
        assert!((cells[1] - cells[2] - cells[3]).abs() < 1e-12, "{line}");
        assert!(cells[3].abs() < 2_f64.to_radians(), "{line}");
        count += 1;
    }
    assert_eq!(count, 301);
}

/// A part of the swing, sufficient if only the form of the output matters.
fn quick() -> String {
    format!("fit trace {SWING} --model linear --to 6s")
}

#[test]
fn the_report_stands_alone_and_is_written_whole() {
    let directory = directory("fit-trace-report");
    let report = directory.join("report.html");
    text(&format!("{} --length 0.56m±0.002m --report {}", quick(), report.display()));
    let page = fs::read_to_string(&report).unwrap();
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
    for expected in ["Gravity is g", "residual", "exact law", "<svg viewBox", "scope=\"col\"", "omega0"] {
        assert!(page.contains(expected), "{expected}");
    }
    let outside = ["<img", "<link rel=\"stylesheet\"", "@import", "src=", "href=\"http"];
    assert!(outside.iter().all(|tag| !page.contains(tag)));
    assert!(page.contains("default-src 'none'") && page.matches("<script").count() == 1);
    // The elements of different pictures have different ids.
    let names: Vec<&str> = page.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    let different: std::collections::BTreeSet<&&str> = names.iter().collect();
    assert_eq!(names.len(), different.len());
    assert_eq!(fs::read_dir(&directory).unwrap().count(), 1);
}

/// The text between a heading and the next one.
fn section<'a>(page: &'a str, title: &str) -> &'a str {
    let (_, rest) = page.split_once(&format!("<h2>{title}</h2>")).unwrap_or_else(|| panic!("{title}"));
    rest.split_once("<h2>").map_or(rest, |(section, _)| section)
}

#[test]
fn the_report_says_what_is_doubtful_beside_the_result_and_how_it_was_made() {
    let report = directory("fit-trace-doubts").join("report.html");
    // The length is stated as 0.66 m instead of 0.56 m.
    text(&format!("{} --length 0.66m±0.002m --clock 0.1% --report {}", quick(), report.display()));
    let page = fs::read_to_string(&report).unwrap();
    let result = section(&page, "Result");
    assert!(result.contains("class=\"aside\"") && result.contains("on Earth"), "{result}");
    assert!(!page.contains("<h2>Doubts</h2>"));
    assert!(result.contains("expanded uncertainty of gravity"), "{result}");
    let budget = section(&page, "The uncertainty of gravity");
    for expected in ["∂g/∂x", "share", "clock", "damping", "Satterthwaite"] {
        assert!(budget.contains(expected), "{expected}: {budget}");
    }
    let made = section(&page, "Origin of this report");
    for expected in
        ["fit trace", "--length 0.66m±0.002m", concat!("libration ", env!("CARGO_PKG_VERSION")), " UTC"]
    {
        assert!(made.contains(expected), "{expected}: {made}");
    }
}

#[test]
fn the_report_lists_every_cycle_and_its_tables_can_be_copied() {
    let report = directory("fit-trace-cycles").join("report.html");
    let answer = json(&format!("{} --report {}", quick(), report.display()));
    let page = fs::read_to_string(&report).unwrap();
    let cycles = section(&page, "All cycles");
    assert_eq!(cycles.matches("<tr>").count(), answer["cycles"].as_array().unwrap().len() + 1);
    for heading in ["start / s", "period / s", "± / s", "amplitude / °"] {
        assert!(cycles.contains(heading), "{heading}");
    }
    let first = &answer["cycles"][0];
    let start = number(&first["time_s"]) - 0.5 * number(&first["period_s"]);
    assert!(cycles.contains(&format!("{start:.6}")), "{start}: {cycles}");
    assert!(cycles.contains("data-latex=\"% Every cycle") && cycles.contains("Copy for Word"));
    // The pictures are as wide as their container, have descriptions, and have colours for dark screens.
    let periods = section(&page, "Period and amplitude");
    assert!(
        periods.contains(">constant period</text>") && periods.contains("prefers-color-scheme:dark"),
        "{periods}"
    );
    assert!(periods.contains("<desc>period T / s from") && !periods.contains("<svg width"), "{periods}");
}

#[test]
fn names_in_the_file_are_written_and_never_taken_for_tags() {
    let table = fs::read_to_string(SWING).unwrap();
    let hostile = table.replace("theta (deg)", "theta<script>alert</script>\"><img src=x> (deg)");
    assert_ne!(hostile, table);
    let directory = directory("fit-trace-hostile");
    let (path, report) = (directory.join("swing.csv"), directory.join("report.html"));
    fs::write(&path, hostile).unwrap();
    text(&format!(
        "fit trace {} --model linear --to 6s --angle 2 --report {}",
        path.display(),
        report.display()
    ));
    let page = fs::read_to_string(&report).unwrap();
    assert!(page.contains("&lt;script&gt;alert") && page.contains("&lt;img src"), "{page}");
    assert!(!page.contains("<script>alert") && !page.contains("<img"));
}

#[test]
fn a_markdown_report_has_its_pictures_beside_it() {
    let directory = directory("fit-trace-markdown");
    let report = directory.join("report.md");
    text(&format!("{} --report {}", quick(), report.display()));
    let page = fs::read_to_string(&report).unwrap();
    let pictures: Vec<&str> = page.split("](<").skip(1).filter_map(|rest| rest.split('>').next()).collect();
    assert!(pictures.len() >= 4, "{pictures:?}");
    for picture in &pictures {
        assert!(fs::read_to_string(directory.join(picture)).unwrap().contains("<svg"), "{picture}");
    }
    assert_eq!(fs::read_dir(&directory).unwrap().count(), pictures.len() + 1);
}

#[test]
fn pictures_are_drawn() {
    let directory = directory("fit-trace-figure");
    let picture = directory.join("fit.svg");
    text(&format!("{} --figure {}", quick(), picture.display()));
    assert!(fs::read_to_string(&picture).unwrap().contains("residual / degrees"));
}

/// A swing of angular velocities, by small steps of a symplectic integrator: 40° of a pendulum with ω0 = 3 rad/s.
fn gyroscope(name: &str) -> PathBuf {
    let (mut angle, mut velocity, mut seed) = (40_f64.to_radians(), 0.0, 1_u64);
    let mut text = "Time (s),Gyroscope x (rad/s)\n".to_owned();
    for step in 0..60_000_u32 {
        if step.is_multiple_of(100) {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let noise = f64::from(u32::try_from(seed >> 32).unwrap()) / f64::from(u32::MAX) - 0.5;
            text += &format!("{:.3},{:.5}\n", f64::from(step) * 2e-4, velocity + 0.02 * noise);
        }
        velocity -= 1e-4 * 9.0 * f64::sin(angle);
        angle += 2e-4 * velocity;
        velocity -= 1e-4 * 9.0 * f64::sin(angle);
    }
    let path = directory(name).join("gyroscope.csv");
    fs::write(&path, text).unwrap();
    path
}

#[test]
fn angular_velocities_alone_give_the_frequency() {
    let answer = json(&format!("fit trace {} --model undamped", gyroscope("fit-trace-gyroscope").display()));
    let omega0 = parameter(&answer, "omega0");
    agrees(&omega0["value"], &omega0["uncertainty"], 3.0, 1e-2);
    assert!(answer["rms_residual_rad_per_s"].is_number() && answer.get("rms_residual_rad").is_none());
    assert_described("fit trace", &answer);
}

/// Two runs of an undamped pendulum with ω0 = 3 rad/s in counts of an encoder, sampled 20
/// times a second; times truncated to hundredths have errors of up to half a hundredth.
fn encoder(name: &str) -> PathBuf {
    let mut text = "run,time_ms,angle\n".to_owned();
    for (run, degrees) in [(1, 100.0_f64), (2, 20.0), (3, 60.0)] {
        let (mut angle, mut velocity) = (degrees.to_radians(), 0.0);
        for step in 0..30_000_u32 {
            if step.is_multiple_of(125) {
                let milliseconds = (f64::from(step) * 0.2666666 / 10.0).round() * 10.0;
                let counts = (angle * 4000.0 / std::f64::consts::TAU).round().rem_euclid(4000.0);
                text += &format!("{run},{milliseconds},{counts}\n");
            }
            velocity -= 0.5 * 0.2666666e-3 * 9.0 * f64::sin(angle);
            angle += 0.2666666e-3 * velocity;
            velocity -= 0.5 * 0.2666666e-3 * 9.0 * f64::sin(angle);
        }
    }
    let path = directory(name).join("encoder.csv");
    fs::write(&path, text).unwrap();
    path
}

#[test]
fn several_runs_share_their_frequency_and_even_times_undo_rounding() {
    let question = format!(
        "fit trace {} --counts-per-turn 4000 --run 1,3 --model undamped",
        encoder("fit-trace-runs").display()
    );
    let rounded = json(&question);
    assert_eq!(rounded["traces"].as_array().unwrap().len(), 2);
    assert_eq!(rounded["cycles"][0]["trace"], 0);
    let omega0 = parameter(&rounded, "omega0");
    agrees(&omega0["value"], &omega0["uncertainty"], 3.0, 1e-2);
    agrees(&rounded["beta"], &rounded["beta_uncertainty"], 1.0, 0.05);
    assert!(rounded["advice"].to_string().contains("--even-times"), "{}", rounded["advice"]);
    let even = json(&format!("{question} --even-times"));
    let (before, after) = (number(&rounded["rms_residual_rad"]), number(&even["rms_residual_rad"]));
    // The remaining error is the rounding to counts, 0.09° over √12.
    assert!(after < 0.2 * before && after < 0.03_f64.to_radians(), "{before} {after}");
    let missing = libration(&format!("{} --run 1,7", question.replace(" --run 1,3", "")));
    assert_eq!(missing.status.code(), Some(1));
    assert!(message(&missing).contains('7'), "{}", message(&missing));
}

#[test]
fn unusable_recordings_are_refused_with_a_reason_and_nothing_is_written() {
    let cases = [
        ("empty", "", "--model linear", "no rows"),
        ("untimed", "theta (deg),x\n1,2\n2,1\n1,3\n", "", "--time"),
        ("short", "t (s),theta (deg)\n0,10\n0.1,9\n0.2,7\n", "", "give at least"),
        ("window", "t (s),theta (deg)\n0,10\n0.1,9\n0.2,7\n", "--from 5s", "the times run from 0 to 0.2 s"),
    ];
    for (name, table, options, expected) in cases {
        let directory = directory(&format!("fit-trace-{name}"));
        let path = directory.join("swing.csv");
        fs::write(&path, table).unwrap();
        let report = directory.join("report.html");
        let output =
            libration(&format!("fit trace {} {options} --report {}", path.display(), report.display()));
        assert_eq!(output.status.code(), Some(1), "{name}: {}", message(&output));
        assert!(message(&output).contains(expected), "{name}: {}", message(&output));
        assert!(!report.exists() && output.stdout.is_empty(), "{name}");
    }
}

#[test]
fn questions_that_are_not_understood_say_what_would_do() {
    for (options, expected) in [
        ("--model viscous", "dry+linear"),
        ("--report report.pdf", ".md or .tex"),
        ("--figure swing.gif", ".svg, .pdf, .png or .json"),
        ("--length -1m", "above zero"),
    ] {
        let output = libration(&format!("fit trace {SWING} {options}"));
        assert_eq!(output.status.code(), Some(2), "{options}");
        assert!(message(&output).contains(expected), "{options}: {}", message(&output));
    }
}

/// A pendulum with ω0 in rad/s and linear drag in 1/s, released at an angle in degrees, recorded 40
/// times a second for a number of seconds; the errors are uniformly distributed, up to `error` degrees.
struct Released {
    omega0: f64,
    /// Dry friction, in rad/s².
    dry: f64,
    drag: f64,
    degrees: f64,
    seconds: u32,
    error: f64,
}

impl Released {
    const USUAL: Self = Self { omega0: 4.4, dry: 0.0, drag: 0.03, degrees: 60.0, seconds: 20, error: 0.3 };

    fn write(&self, name: &str) -> String {
        let (mut angle, mut velocity) = (self.degrees.to_radians(), 0.0);
        let mut text = "t (s),theta (deg)\n".to_owned();
        let mut state: u64 = 1;
        for step in 0..self.seconds * 4000 {
            if step.is_multiple_of(100) {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let error = self.error * (f64::from((state >> 33) as u32) / f64::from(1_u32 << 30) - 1.0);
                text += &format!("{},{:.5}\n", f64::from(step) / 4000.0, angle.to_degrees() + error);
            }
            let time = 0.25e-3;
            angle += 0.5 * time * velocity;
            let friction = self.drag * velocity + if velocity < 0.0 { -self.dry } else { self.dry };
            velocity -= time * (self.omega0 * self.omega0 * f64::sin(angle) + friction);
            angle += 0.5 * time * velocity;
        }
        let path = directory(name).join("swing.csv");
        fs::write(&path, text).unwrap();
        path.display().to_string()
    }
}

fn warnings(question: &str) -> String {
    json(question)["warnings"].to_string()
}

#[test]
fn steady_amplitudes_leave_beta_open_without_an_alarm() {
    let swing = Released { drag: 0.0, ..Released::USUAL }.write("fit-trace-steady");
    let answer = json(&format!("fit trace {swing} --model undamped"));
    assert!(answer["beta"].is_null(), "{}", answer["beta"]);
    assert!(!answer["warnings"].to_string().contains("standard uncertainties"), "{}", answer["warnings"]);
    // Both traces are regular, alone and together.
    let other = Released { drag: 0.0, seconds: 18, ..Released::USUAL }.write("fit-trace-steady-too");
    let both = json(&format!("fit trace {swing} {other} --model undamped"));
    assert!(both["beta"].is_null(), "{}", both["beta"]);
}

/// Makes the angles of a file 10 % too large.
fn too_large(swing: &str) {
    let table = fs::read_to_string(swing).unwrap();
    let scaled = table.lines().skip(1).map(|line| {
        let (time, angle) = line.split_once(',').unwrap();
        format!("{time},{}\n", 1.1 * angle.parse::<f64>().unwrap())
    });
    fs::write(swing, format!("t (s),theta (deg)\n{}", scaled.collect::<String>())).unwrap();
}

#[test]
fn a_wrong_scale_is_suspected_unless_it_is_fitted_or_the_damping_strong() {
    let swing = Released { error: 0.03, ..Released::USUAL }.write("fit-trace-scale");
    too_large(&swing);
    let suspected = warnings(&format!("fit trace {swing} --model linear"));
    assert!(suspected.contains("too large would do this"), "{suspected}");
    let fitted = json(&format!("fit trace {swing} --model linear --free-scale"));
    for text in [fitted["warnings"].to_string(), fitted["advice"].to_string()] {
        assert!(!text.contains("would do this") && !text.contains("β is not 1"), "{text}");
        assert!(!text.contains("by single cycles"), "{text}");
    }
    let strong = Released { drag: 0.5, degrees: 120.0, seconds: 8, error: 0.01, ..Released::USUAL };
    let strong = strong.write("fit-trace-strong");
    too_large(&strong);
    let damped = warnings(&format!("fit trace {strong} --model linear"));
    assert!(damped.contains("such strong damping") && !damped.contains("would do this"), "{damped}");
}

#[test]
fn traces_of_different_pendulums_are_told() {
    let one = Released::USUAL.write("fit-trace-one");
    let other = Released { omega0: 4.3, degrees: 40.0, ..Released::USUAL }.write("fit-trace-other");
    let told = warnings(&format!("fit trace {one} {other} --model linear"));
    assert!(told.contains("not of one pendulum") && told.contains("1.46"), "{told}");
    let same = Released { degrees: 40.0, ..Released::USUAL }.write("fit-trace-same");
    let told = warnings(&format!("fit trace {one} {same} --model linear"));
    assert!(!told.contains("not of one pendulum"), "{told}");
}

#[test]
fn a_length_that_no_pendulum_has_points_to_the_unit_of_the_times() {
    let swing = Released::USUAL.write("fit-trace-unit");
    let right = warnings(&format!("fit trace {swing} --model linear"));
    assert!(!right.contains("unit of the times"), "{right}");
    let wrong = warnings(&format!("fit trace {swing} --model linear --time-unit ms"));
    assert!(wrong.contains("unit of the times"), "{wrong}");
}

#[test]
fn a_tail_at_rest_is_left_out_of_the_cycles() {
    let resting = Released { drag: 0.4, seconds: 60, ..Released::USUAL }.write("fit-trace-resting");
    let answer = json(&format!("fit trace {resting} --model linear"));
    assert!(answer["cycles"].as_array().unwrap().len() > 8);
    assert!(answer["warnings"].to_string().contains("lost in the noise"), "{}", answer["warnings"]);
}

/// Without errors the cycles differ only by their small bias.
#[test]
fn nothing_is_said_of_differences_that_do_not_matter() {
    let exact = Released { error: 0.0, ..Released::USUAL }.write("fit-trace-exact");
    let told = warnings(&format!("fit trace {exact} --model linear"));
    assert!(!told.contains("by single cycles") && !told.contains(" 1.0 times"), "{told}");
}

/// A table of angles in degrees as a function of time, 40 rows a second, with the usual noise.
fn swing_by(name: &str, value: impl Fn(f64, f64) -> f64) -> String {
    let path = Released::USUAL.write(name);
    let table = fs::read_to_string(&path).unwrap();
    let rows = table.lines().skip(1).map(|line| {
        let (time, angle) = line.split_once(',').unwrap();
        let (time, angle): (f64, f64) = (time.parse().unwrap(), angle.parse().unwrap());
        format!("{time},{:.5}\n", value(time, angle))
    });
    fs::write(&path, format!("t (s),theta (deg)\n{}", rows.collect::<String>())).unwrap();
    path
}

fn kinds(question: &str) -> Vec<String> {
    let answer = json(question);
    let (kinds, texts) =
        (answer["warning_kinds"].as_array().unwrap(), answer["warnings"].as_array().unwrap());
    assert_eq!(kinds.len(), texts.len());
    kinds.iter().map(|kind| kind.as_str().unwrap().to_owned()).collect()
}

/// Each warning with data that cause it; the usual swing causes none.
#[test]
fn doubts_are_raised_by_the_data_that_deserve_them() {
    let usual_swing = Released::USUAL.write("fit-trace-no-doubt");
    let usual = kinds(&format!("fit trace {usual_swing} --model linear"));
    let narrow =
        Released { degrees: 3.0, seconds: 5, error: 0.03, ..Released::USUAL }.write("fit-trace-narrow");
    let slippery = Released { dry: 0.1, drag: -0.03, ..Released::USUAL }.write("fit-trace-slippery");
    let growing = Released { drag: -0.02, degrees: 40.0, ..Released::USUAL }.write("fit-trace-growing");
    let noisy = Released { error: 14.0, ..Released::USUAL }.write("fit-trace-noisy");
    let cosine = swing_by("fit-trace-cosine", |time, _| 80.0 * f64::cos(std::f64::consts::TAU / 1.5 * time));
    let stray = swing_by(
        "fit-trace-stray",
        |time, angle| if (time - 7.5).abs() < 1e-9 { angle + 30.0 } else { angle },
    );
    for (kind, swing, model) in [
        ("feeds_energy", &growing, "linear"),
        ("negative_damping", &growing, "linear"),
        ("poor_fit", &noisy, "linear"),
        ("residuals_not_noise", &cosine, "undamped"),
        ("outliers", &stray, "linear"),
        // The true length is 0.507 m.
        ("gravity_contradicted", &usual_swing, "linear --length 0.6m±0.001m"),
        // At 3° the errors do not reveal whether an angle reads too small or is small.
        ("not_converged", &narrow, "linear --free-scale"),
        ("better_model_not_believed", &slippery, "auto"),
        ("stated_uncertainties", &stated("fit-trace-too-sure", 0.05), "linear"),
        ("stated_uncertainties", &stated("fit-trace-too-unsure", 0.6), "linear"),
    ] {
        let warnings = kinds(&format!("fit trace {swing} --model {model}"));
        assert!(warnings.iter().any(|one| one == kind), "{kind}: {warnings:?}");
        assert!(!usual.iter().any(|one| one == kind), "{kind}: {usual:?}");
    }
    // Uniform errors of ±0.3° have a standard deviation of 0.17°.
    for (kind, question) in [
        ("stated_uncertainties", format!("fit trace {} --model linear", stated("fit-trace-sure", 0.17))),
        ("gravity_contradicted", format!("fit trace {usual_swing} --model linear --length 0.507m±0.001m")),
        ("not_converged", format!("fit trace {narrow} --model linear")),
        ("better_model_not_believed", format!("fit trace {usual_swing}")),
    ] {
        let warnings = kinds(&question);
        assert!(!warnings.iter().any(|one| one == kind), "{kind}: {warnings:?}");
    }
}

/// The usual swing with a column of the uncertainty of each angle, in degrees.
fn stated(name: &str, uncertainty: f64) -> String {
    let path = Released::USUAL.write(name);
    let table = fs::read_to_string(&path).unwrap();
    let rows: String = table.lines().skip(1).map(|line| format!("{line},{uncertainty}\n")).collect();
    fs::write(&path, format!("t (s),theta (deg),sigma (deg)\n{rows}")).unwrap();
    path
}

/// This swing has linear damping alone. With dry friction the fit is as good, but its coefficient is zero within the error and changes the
/// linear coefficient by many of its uncertainties: it is not a rival model. Dry and quadratic damping without the linear one are another model.
#[test]
fn a_larger_model_whose_further_coefficient_is_zero_is_no_rival() {
    let swing = Released { seconds: 10, ..Released::USUAL }.write("fit-trace-moved");
    let answer = json(&format!("fit trace {swing}"));
    assert_eq!(answer["model"], "linear", "{}", answer["comparison"]);
    let models = answer["comparison"].as_array().unwrap();
    let larger = models.iter().find(|model| model["model"] == "dry+linear").unwrap();
    assert_eq!(larger["standing"], "tied", "{larger}");
    let moved = number(&larger["coefficients"][1]["value"]) - number(&parameter(&answer, "linear")["value"]);
    assert!(moved.abs() > 3.0 * number(&parameter(&answer, "linear")["uncertainty"]), "{moved}");
    let warnings = answer["warnings"].to_string();
    let dry = &larger["coefficients"][0];
    assert!(number(&dry["value"]).abs() < number(&dry["uncertainty"]), "{dry}");
    assert!(
        warnings.contains("linear damping cannot be distinguished from dry+quadratic with"),
        "{warnings}"
    );
}

#[test]
fn advice_is_given_where_it_would_help() {
    let advice = |swing: &str| json(&format!("fit trace {swing} --model linear"))["advice"].to_string();
    let usual = advice(&Released::USUAL.write("fit-trace-no-advice"));
    let tilted = swing_by("fit-trace-tilted", |_, angle| angle + 2.0);
    let held = swing_by("fit-trace-held", |time, angle| if time < 0.2 { 50.0 } else { angle });
    let stray = swing_by(
        "fit-trace-one-stray",
        |time, angle| if (time - 7.5).abs() < 1e-9 { angle + 30.0 } else { angle },
    );
    let coarse = Released::USUAL.write("fit-trace-coarse");
    let table = fs::read_to_string(&coarse).unwrap();
    let every_fifth: Vec<&str> = table.lines().skip(1).step_by(5).collect();
    fs::write(&coarse, format!("t (s),theta (deg)\n{}\n", every_fifth.join("\n"))).unwrap();
    for (swing, expected) in [
        (tilted, "plumb line"),
        (held, "leave them out. (--from, --to)"),
        (stray, "--robust"),
        (coarse, "record more frames per second"),
    ] {
        let given = advice(&swing);
        assert!(given.contains(expected), "{expected}: {given}");
        assert!(!usual.contains(expected), "{expected}: {usual}");
    }
    // If the motion is not that of a pendulum, its zero does not define a vertical.
    let noisy = Released { error: 14.0, ..Released::USUAL }.write("fit-trace-noisy-tilted");
    let table = fs::read_to_string(&noisy).unwrap();
    let tilted = table.lines().skip(1).map(|line| {
        let (time, angle) = line.split_once(',').unwrap();
        format!("{time},{:.5}\n", angle.parse::<f64>().unwrap() + 5.0)
    });
    fs::write(&noisy, format!("t (s),theta (deg)\n{}", tilted.collect::<String>())).unwrap();
    let given = advice(&noisy);
    assert!(!given.contains("plumb line"), "{given}");
}

#[test]
fn models_that_are_not_excluded_are_named_and_averaged_over() {
    let short = Released { seconds: 4, ..Released::USUAL }.write("fit-trace-ties");
    let answer = json(&format!("fit trace {short}"));
    let models = answer["comparison"].as_array().unwrap();
    let standing = |one: &str| models.iter().filter(|model| model["standing"] == one).count();
    assert_eq!(standing("preferred"), 1);
    assert!(standing("tied") >= 1, "{models:?}");
    let weights: f64 = models.iter().map(|model| number(&model["weight"])).sum();
    assert!((weights - 1.0).abs() < 1e-9);
    assert!(models.iter().all(|model| number(&model["independent_rows"]) <= 160.0));
    let averaged = &answer["averaged"];
    assert_eq!(averaged["small_angle_period_s"], answer["small_angle_period_s"]);
    assert!(
        number(&averaged["small_angle_period_spread_s"])
            <= number(&averaged["small_angle_period_uncertainty_s"])
    );
    assert!(
        answer["warning_kinds"].to_string().contains("damping_not_separated"),
        "{}",
        answer["warning_kinds"]
    );
    assert!(answer["advice"].to_string().contains("record for longer"), "{}", answer["advice"]);
    let sheet = text(&format!("fit trace {short}"));
    for expected in ["weight", "tied", "independent ones", "quadratic"] {
        assert!(sheet.contains(expected), "{expected}: {sheet}");
    }
}

#[test]
fn radians_called_degrees_and_degrees_called_radians_are_answered_by_their_name() {
    let radians = Released { error: 0.05, ..Released::USUAL }.write("fit-trace-radians");
    let table = fs::read_to_string(&radians).unwrap();
    let rows = table.lines().skip(1).map(|line| {
        let (time, angle) = line.split_once(',').unwrap();
        format!("{time},{:.7}\n", angle.parse::<f64>().unwrap().to_radians())
    });
    let rows: String = rows.collect();
    fs::write(&radians, format!("t (s),theta (deg)\n{rows}")).unwrap();
    let answer = json(&format!("fit trace {radians} --model linear"));
    assert_eq!(answer["warning_kinds"][0], "angles_are_radians", "{}", answer["warnings"]);
    assert!(
        answer["warnings"][0].as_str().unwrap().contains("these angles are radians"),
        "{}",
        answer["warnings"]
    );
    fs::write(&radians, format!("t (s),theta (rad)\n{rows}")).unwrap();
    let right = kinds(&format!("fit trace {radians} --model linear"));
    assert!(!right.contains(&"angles_are_radians".to_owned()), "{right:?}");
    fs::write(&radians, table.replace("(deg)", "(rad)")).unwrap();
    let degrees = libration(&format!("fit trace {radians}"));
    assert_eq!(degrees.status.code(), Some(1));
    assert!(message(&degrees).contains("these angles are degrees, not radians"), "{}", message(&degrees));
}
