//! The uncertainty budget of gravity, in all commands that compute one.

use crate::command::{close, directory, json, libration, message, text, unfolded};
use serde_json::Value;
use std::f64::consts::{PI, TAU};

fn example(name: &str) -> String {
    format!("{}/../../examples/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// Every command that computes g from a length, without the length; the other uncertainties of g are far below one per cent.
fn questions() -> [String; 3] {
    [
        format!("fit periods {}", example("period_table_synthetic.csv")),
        format!("fit gates {} --amplitude 40deg", example("gate_synthetic.csv")),
        format!("fit trace {} --model linear --to 6s", example("swing_synthetic.csv")),
    ]
}

fn number(answer: &Value, name: &str) -> f64 {
    answer[name].as_f64().unwrap_or_else(|| panic!("{name}: {answer}"))
}

fn input<'a>(answer: &'a Value, name: &str) -> &'a Value {
    let inputs = answer["budget_inputs"].as_array().unwrap();
    inputs.iter().find(|input| input["input"] == name).unwrap_or_else(|| panic!("{name}: {answer}"))
}

fn row<'a>(answer: &'a Value, name: &str) -> &'a Value {
    let rows = answer["budget"].as_array().unwrap();
    rows.iter().find(|row| row["name"] == name).unwrap_or_else(|| panic!("{name}: {answer}"))
}

#[test]
fn an_uncertainty_as_large_as_the_length_is_kept() {
    for question in questions() {
        for part in [1.0, 1.5] {
            let answer = json(&format!("{question} --length 1m±{part}m"));
            let expected = part * number(&answer, "gravity_m_per_s2");
            close(&answer["gravity_uncertainty_m_per_s2"], expected, 1e-3 * expected);
            assert!(row(&answer, "length")["uncertainty_m_per_s2"].is_number());
        }
        let sheet = text(&format!("{question} --length 1m±1m"));
        let gravity = sheet.lines().find(|line| line.starts_with("gravity")).unwrap();
        assert!(gravity.matches('±').count() == 2 && !sheet.contains("nan"), "{gravity}");
    }
}

/// 29.97 frames per second taken for 30 are 0.1 % of the time and 0.2 % of g.
#[test]
fn the_clock_is_a_row_of_the_budget() {
    for question in questions() {
        let usual = json(&format!("{question} --length 1m±1mm"));
        close(&row(&usual, "clock")["usual_size"], -0.002, 1e-9);
        let answer = json(&format!("{question} --length 1m±1mm --clock 0.1%"));
        let g = number(&answer, "gravity_m_per_s2");
        close(&row(&answer, "clock")["uncertainty_m_per_s2"], 0.002 * g, 1e-6 * g);
        close(&input(&answer, "clock")["sensitivity"], -2.0 * g, 1e-6 * g);
        let both = number(&usual, "gravity_uncertainty_m_per_s2").hypot(0.002 * g);
        close(&answer["gravity_uncertainty_m_per_s2"], both, 1e-6 * g);
    }
}

#[test]
fn inputs_have_values_sensitivities_and_shares() {
    for question in questions() {
        let answer = json(&format!("{question} --length 1m±1mm --clock 0.1%"));
        let g = number(&answer, "gravity_m_per_s2");
        let length = input(&answer, "length");
        close(&length["value"], 1.0, 1e-12);
        close(&length["uncertainty"], 1e-3, 1e-12);
        close(&length["sensitivity"], g, 1e-6 * g);
        assert_eq!((&length["unit"], &length["sensitivity_unit"]), (&"m".into(), &"1/s^2".into()));
        assert!(length["degrees_of_freedom"].is_null() && length["type"] == "B");
        assert_eq!(input(&answer, "period")["type"], "A");
        let shares: f64 =
            answer["budget_inputs"].as_array().unwrap().iter().map(|input| number(input, "share")).sum();
        assert!((shares + number(&answer, "share_of_correlations") - 1.0).abs() < 1e-9, "{answer}");
        let (k, u) = (number(&answer, "coverage_factor"), number(&answer, "gravity_uncertainty_m_per_s2"));
        assert!((1.95..4.5).contains(&k), "{k}");
        close(&answer["gravity_expanded_uncertainty_m_per_s2"], k * u, 1e-9);
        close(&answer["coverage_probability"], 0.95, 1e-12);
        let sheet = unfolded(&text(&format!("{question} --length 1m±1mm --clock 0.1%")));
        assert!(sheet.contains("∂g/∂x") && sheet.contains("U = k u") && sheet.contains("share"), "{sheet}");
    }
}

#[test]
fn a_length_without_an_uncertainty_is_said_to_be_one() {
    for question in questions() {
        let answer = json(&format!("{question} --length 1m"));
        assert!(answer["warnings"].to_string().contains("no uncertainty was given for length"), "{answer}");
        assert!(row(&answer, "length")["uncertainty_m_per_s2"].is_null());
        let exact = json(&format!("{question} --length 1m±0m"));
        assert!(!exact["warnings"].to_string().contains("given without"), "{}", exact["warnings"]);
        close(&row(&exact, "length")["uncertainty_m_per_s2"], 0.0, 1e-15);
    }
}

#[test]
fn damping_is_a_row_that_can_be_reached() {
    let [periods, gates, trace] = questions();
    for question in [periods, gates] {
        let without = json(&format!("{question} --length 1m±1mm"));
        assert!(row(&without, "damping")["usual_size"].is_number());
        let with = json(&format!("{question} --length 1m±1mm --linear 0.2(1)/s"));
        let size = number(row(&with, "damping"), "correction");
        let t0 = number(input(&with, "period"), "value");
        assert!((size / (0.05 * t0 / PI).powi(2) - 1.0).abs() < 1e-6, "{size}");
        let ratio = number(&with, "gravity_m_per_s2") / number(&without, "gravity_m_per_s2");
        assert!((ratio - 1.0 - size).abs() < 1e-9);
        let refused = libration(&format!("{question} --length 1m --linear 0.2m"));
        assert_eq!(refused.status.code(), Some(2));
        assert!(message(&refused).contains("0.030(1)/s"), "{}", message(&refused));
    }
    // The fitted motion includes damping; T0 is the period without it.
    let fitted = json(&format!("{trace} --length 0.56m±1mm"));
    let damping = row(&fitted, "damping");
    assert!(number(damping, "correction") > 0.0 && damping["with"].to_string().contains("already in T0"));
    let undamped = json(&format!("{} --length 0.56m", trace.replace("linear", "undamped")));
    assert!(row(&undamped, "damping")["correction"].is_null());
}

#[test]
fn correlations_are_read_and_counted() {
    let [question, ..] = questions();
    let answer =
        |options: &str| json(&format!("{question} --length 1m±0.01m --bob-radius 50mm±10mm {options}"));
    let (independent, common) = (answer(""), answer("--correlation length,bob-radius=1"));
    let contribution = |name: &str| number(input(&independent, name), "contribution_m_per_s2");
    let sum = (contribution("length") + contribution("bob radius")).hypot(contribution("period"));
    close(&common["gravity_uncertainty_m_per_s2"], sum, 1e-6);
    assert_eq!(common["budget_correlations"][0]["between"][1], "bob radius");
    let sheet = text(&format!(
        "{question} --length 1m±0.01m --bob-radius 50mm±10mm --correlation length,bob-radius=-0.5"
    ));
    assert!(sheet.contains("correlations"), "{sheet}");
    for (wrong, expected) in [
        ("length,bob-radius", "from -1 to 1"),
        ("length,bob-radius=2", "from -1 to 1"),
        ("length,bob=0.5", "bob-radius"),
    ] {
        let refused = libration(&format!("{question} --length 1m --correlation {wrong}"));
        assert_eq!(refused.status.code(), Some(2), "{wrong}");
        assert!(message(&refused).contains(expected), "{}", message(&refused));
    }
    let missing = libration(&format!("{question} --length 1m --correlation length,rod-mass=0.5"));
    assert_eq!(missing.status.code(), Some(1));
    assert!(message(&missing).contains("rod mass"), "{}", message(&missing));
}

/// T0 from the speeds depends on the length through the width of the bob, 2r/L: a longer pendulum increases it.
#[test]
fn the_length_counts_once_where_the_speeds_of_a_gate_need_it_too() {
    let gate = example("gate_synthetic.csv");
    let g = |length: f64| {
        number(
            &json(&format!("fit gates {gate} --length {length}m±0.01m --bob-radius 12.5mm±0mm")),
            "gravity_m_per_s2",
        )
    };
    let answer = json(&format!("fit gates {gate} --length 0.958m±0.01m --bob-radius 12.5mm±0mm"));
    assert!(number(&answer["budget_correlations"][0], "coefficient") > 0.1, "{answer}");
    // The whole calculation repeated with other lengths, plus the contribution of the scatter of the times.
    let by_length = 0.01 * (g(0.963) - g(0.953)) / 0.01;
    let period = input(&answer, "period");
    let r = number(&answer["budget_correlations"][0], "coefficient");
    let by_times = number(period, "contribution_m_per_s2") * (1.0 - r * r).sqrt();
    let expected = by_length.hypot(by_times);
    let computed = number(&answer, "gravity_uncertainty_m_per_s2");
    assert!((computed / expected - 1.0).abs() < 0.02, "{computed} {expected}");
    let elsewhere = json(&format!(
        "fit gates {gate} --length 0.958m±0.01m --diameter 25mm±0mm --gate-distance 0.958m±0m"
    ));
    assert_eq!(elsewhere["budget_correlations"], serde_json::json!([]));
}

/// Ten lengths with g = 9.81 m/s² and deviations of 10 ms, stated as 2 ms.
fn scattered(name: &str) -> String {
    let deviations = [1.0, -1.0, -1.0, 1.0, 1.0, -1.0, -1.0, 1.0, 1.0, -1.0];
    let line = |(k, sign): (u32, f64)| {
        let length = 0.1 * f64::from(k);
        format!("{length:.1},{:.6},0.0,0.002\n", TAU * (length / 9.81).sqrt() + 0.01 * sign)
    };
    let lines: String = (1..).zip(deviations).map(line).collect();
    let path = directory(name).join("lengths.csv");
    std::fs::write(&path, format!("L (m),T (s),sigma_L,sigma_T\n{lines}")).unwrap();
    path.display().to_string()
}

#[test]
fn lengths_that_scatter_more_than_stated_are_enlarged_and_said_to_be() {
    let table = scattered("lengths-scattered");
    let answer = json(&format!("fit lengths {table}"));
    let per_dof = number(&answer["laws"][1], "chi2_per_dof");
    assert!(per_dof > 15.0, "{per_dof}");
    close(&answer["birge_ratio"], per_dof.sqrt(), 1e-9);
    close(&answer["uncertainties_enlarged_by"], per_dof.sqrt(), 1e-9);
    close(&answer["effective_degrees_of_freedom"], 8.0, 1e-9);
    assert!(answer["warnings"].to_string().contains("Birge ratio"), "{answer}");
    let sheet = unfolded(&text(&format!("fit lengths {table}")));
    assert!(sheet.contains("uncertainties enlarged"), "{sheet}");
    // Without stated uncertainties the scatter is the uncertainty.
    let by_scatter = json(&format!("fit lengths {table} --columns 1,2"));
    let ratio =
        number(&answer, "gravity_uncertainty_m_per_s2") / number(&by_scatter, "gravity_uncertainty_m_per_s2");
    assert!((0.5..2.0).contains(&ratio), "{ratio}");
}

#[test]
fn clock_and_bob_count_in_fits_of_lengths() {
    let table = example("lengths_synthetic.csv");
    let answer = |options: &str| json(&format!("fit lengths {table} {options}"));
    let (exact, clocked) = (answer("--bob-radius 25mm±0mm"), answer("--bob-radius 25mm±5mm --clock 0.5%"));
    let g = number(&exact, "gravity_m_per_s2");
    let contribution = |name: &str| number(input(&clocked, name), "contribution_m_per_s2");
    close(&input(&clocked, "clock")["contribution_m_per_s2"], -0.01 * g, 1e-9);
    assert!(contribution("bob radius").abs() > 1e-4);
    let line = number(&exact, "gravity_uncertainty_m_per_s2");
    let expected = line.hypot(0.01 * g).hypot(contribution("bob radius"));
    close(&clocked["gravity_uncertainty_m_per_s2"], expected, 1e-9);
}

/// Periods of the exact law with T0 = 2 s and deviations of 10 ms, stated as 1 ms.
#[test]
fn periods_that_scatter_more_than_stated_are_enlarged_and_said_to_be() {
    let rows = "angle,time,sigma_angle,error\n\
        10,2.0138,0,0.001\n40,2.0527,0,0.001\n70,2.2143,0,0.001\n100,2.4545,0,0.001\n130,2.9496,0,0.001\n";
    let path = directory("fit-periods-scattered").join("table.csv");
    std::fs::write(&path, rows).unwrap();
    let question = format!("fit periods {} --amplitude-unit deg --length 1m±1mm", path.display());
    let answer = json(&question);
    let exact = &answer["laws"][0];
    let enlarged = number(exact, "uncertainties_enlarged_by");
    assert!(enlarged > 5.0);
    close(&exact["birge_ratio"], number(exact, "chi2_per_dof").sqrt(), 1e-9);
    // 1/√(Σ R²/σ²) with these five rows is 0.4 ms.
    assert!((0.0003 * enlarged..0.0005 * enlarged).contains(&number(exact, "t0_uncertainty_s")), "{exact}");
    assert!(answer["warnings"].to_string().contains("Birge ratio"), "{answer}");
    close(&input(&answer, "period")["degrees_of_freedom"], 4.0, 1e-9);
    assert!(unfolded(&text(&question)).contains("uncertainties enlarged"));
    assert!(number(&answer, "beta_uncertainty") > 5.0 * 0.0004);
}

/// χ²/dof is 1.03 for ten rows, as expected by chance.
#[test]
fn rows_that_scatter_as_stated_are_not_blamed_for_the_birge_ratio() {
    let table = scattered("lengths-as-stated");
    let stated = std::fs::read_to_string(&table).unwrap().replace(",0.002", ",0.01099");
    std::fs::write(&table, stated).unwrap();
    let answer = json(&format!("fit lengths {table}"));
    let enlarged = number(&answer, "uncertainties_enlarged_by");
    assert!((1.005..1.1).contains(&enlarged), "{enlarged}");
    let sheet = unfolded(&text(&format!("fit lengths {table}")));
    assert!(
        sheet.contains("uncertainties include the Birge ratio 1.0") && sheet.contains("as stated"),
        "{sheet}"
    );
    assert!(!sheet.contains("scatter more than their uncertainties"), "{sheet}");
    assert_eq!(answer["warning_kinds"], serde_json::json!([]));
}
