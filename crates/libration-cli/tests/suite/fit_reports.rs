//! Reports of all fits as HTML, Markdown and LaTeX.

use crate::command::{directory, json, text};
use serde_json::Value;
use std::fs;

fn example(name: &str) -> String {
    format!("{}/../../examples/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// Each fit of a table with a headline of its report and a sentence of its method.
fn fits() -> [(String, &'static str, &'static str); 7] {
    let location = "--latitude 48.1deg --elevation 520m";
    [
        (
            format!("fit periods {} --length 0.994m±1mm {location}", example("period_table_synthetic.csv")),
            "g = ",
            "follows exactly from the elliptic integral",
        ),
        (
            format!("fit lengths {} {location}", example("lengths_synthetic.csv")),
            "g = ",
            "straight line of slope",
        ),
        (format!("fit lengths {}", example("bar_synthetic.csv")), "g = ", "T₀²h against h²"),
        (format!("fit lengths {}", example("class/groups.csv")), "g = ", "straight line of slope"),
        (
            format!(
                "fit gates {} --amplitude 0.9 --length 0.958m±1mm {location}",
                example("gate_synthetic.csv")
            ),
            "g = ",
            "one passage of the gate to the next",
        ),
        (format!("fit amplitudes {}", example("amplitudes_synthetic.csv")), "Q = ", "friction takes energy"),
        (format!("fit response {}", example("response_synthetic.csv")), "ω₀ = ", "that sustains a motion"),
    ]
}

/// The text of a page without its tags.
fn words(page: &str) -> String {
    let mut text = String::new();
    let mut depth = 0;
    for letter in page.chars() {
        match letter {
            '<' => depth += 1,
            '>' => depth -= 1,
            letter if depth == 0 => text.push(letter),
            _ => {}
        }
    }
    text
}

#[test]
fn every_fit_writes_a_report_that_stands_alone() {
    let directory = directory("fit-reports");
    for (number, (fit, headline, method)) in fits().into_iter().enumerate() {
        let file = directory.join(format!("{number}.html"));
        let said = text(&format!("{fit} --report {}", file.display()));
        assert!(said.contains("written: report with pictures"), "{said}");
        let page = fs::read_to_string(&file).unwrap();
        let content = words(&page);
        let after = content.split("Result").nth(1).unwrap();
        assert!(after.trim_start().starts_with(headline), "{fit}: {}", &after[..after.len().min(80)]);
        for wanted in ["(k = 2", method, "What was measured", "Method", "All rows", "Origin of this report"] {
            assert!(content.contains(wanted), "{fit}: {wanted}");
        }
        assert!(
            page.matches("<svg").count() == 1 && !page.contains("http://") && !page.contains("src="),
            "{fit}"
        );
        if headline == "g = " {
            assert!(
                content.contains("The uncertainty of gravity") && content.contains("knife edge"),
                "{fit}"
            );
        }
        assert_eq!(fit.contains("--latitude"), content.contains("Normal gravity at this place"), "{fit}");
        assert_eq!(fit.contains("groups.csv"), content.contains("Weighted mean of all groups"), "{fit}");
    }
}

/// The headline has the expanded uncertainty of the JSON result.
#[test]
fn the_headline_is_the_result_with_its_expanded_uncertainty() {
    let file = directory("fit-report-headline").join("report.md");
    let fit = &fits()[1].0;
    let answer = json(&format!("{fit} --report {}", file.display()));
    let number = |name: &str| answer[name].as_f64().unwrap();
    let page = fs::read_to_string(&file).unwrap();
    let line = page.lines().find(|line| line.starts_with("**g = ")).unwrap();
    let numbers: Vec<f64> = line.split([' ', ')', '*']).filter_map(|word| word.parse().ok()).collect();
    let [g, expanded, factor] = numbers[..] else { panic!("{line}") };
    assert!((g - number("gravity_m_per_s2")).abs() < 0.06 * expanded, "{line}");
    assert!((expanded / number("gravity_expanded_uncertainty_m_per_s2") - 1.0).abs() < 0.06, "{line}");
    assert!((factor / number("coverage_factor") - 1.0).abs() < 0.03, "{line}");
    let rows = page.lines().filter(|line| line.starts_with("| ") && line.matches('|').count() == 7).count();
    assert!(rows >= answer["rows"].as_u64().unwrap_or(0).try_into().unwrap_or(0), "{page}");
    assert!(file.with_file_name("report-line.svg").exists());
}

/// Balanced braces and environments, no letter outside the fonts, a picture for each `\includegraphics`.
#[test]
fn a_report_in_latex_can_be_compiled() {
    let directory = directory("fit-report-latex");
    for (number, (fit, ..)) in fits().into_iter().enumerate() {
        let file = directory.join(format!("{number}.tex"));
        let _: Value = json(&format!("{fit} --report {}", file.display()));
        let page = fs::read_to_string(&file).unwrap();
        for kind in ["longtable", "itemize", "center", "document"] {
            let begun = page.matches(&format!("\\begin{{{kind}}}")).count();
            assert!(begun > 0 && begun == page.matches(&format!("\\end{{{kind}}}")).count(), "{fit}: {kind}");
        }
        let bare = page.replace("\\{", "").replace("\\}", "");
        assert_eq!(bare.matches('{').count(), bare.matches('}').count(), "{fit}");
        let strange: String = page.chars().filter(|letter| *letter > 'ž').collect();
        assert!(strange.is_empty() && !page.contains("[U+"), "{fit}: {strange}");
        let pictures: Vec<&str> =
            page.split("\\detokenize{").skip(1).filter_map(|rest| rest.split('}').next()).collect();
        assert!(!pictures.is_empty(), "{fit}");
        for picture in pictures {
            let bytes = fs::read(directory.join(picture)).unwrap();
            assert!(bytes.starts_with(b"\x89PNG"), "{picture}");
        }
    }
}

/// Periods at a gate have two digits of the scatter of their times.
#[test]
fn periods_at_a_gate_have_no_digits_beyond_their_error() {
    let file = directory("fit-report-digits").join("report.md");
    let fit = format!("fit gates {} --signal 2", example("light_synthetic.csv"));
    let answer = json(&format!("{fit} --report {}", file.display()));
    let decimals = 1.0 - (std::f64::consts::SQRT_2 * answer["timing_s"].as_f64().unwrap()).log10().floor();
    let page = fs::read_to_string(&file).unwrap();
    let cells = page.split("| period T / s |").nth(1).unwrap().lines().skip(2);
    let periods: Vec<&str> = cells.map_while(|line| line.split(" | ").nth(2)).collect();
    assert!(periods.len() > 10, "{page}");
    for period in periods {
        let printed = u32::try_from(period.split('.').nth(1).unwrap().len()).unwrap();
        assert!((f64::from(printed) - decimals).abs() < 0.5, "{period}");
    }
}
