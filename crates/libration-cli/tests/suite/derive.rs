//! `libration derive`.

use crate::command::{directory, libration, message, text};
use std::fs;

#[test]
fn every_road_is_written_in_every_format() {
    for road in ["elliptic", "formulas"] {
        let markdown = text(&format!("derive --road {road}"));
        assert!(markdown.starts_with("# ") && markdown.contains("```math"), "{road}");
        let latex = text(&format!("derive --road {road} --format latex"));
        assert!(latex.starts_with("\\documentclass") && latex.ends_with("\\end{document}\n"), "{road}");
        let html = text(&format!("derive --road {road} --format html"));
        assert!(html.starts_with("<!DOCTYPE html>") && html.contains("<math display=\"block\">"), "{road}");
        assert!(!html.contains("http"), "{road} fetches something");
    }
}

#[test]
fn braces_of_latex_and_tags_of_html_are_closed() {
    for road in ["elliptic", "formulas"] {
        let latex = text(&format!("derive --road {road} --amplitude 40deg --format latex"));
        let count = |mark: &str| latex.matches(mark).count();
        assert_eq!(count("{"), count("}"), "{road}");
        assert_eq!(count("\\left("), count("\\right)"), "{road}");
        assert_eq!(count("\\begin{"), count("\\end{"), "{road}");
        let html = text(&format!("derive --road {road} --amplitude 40deg --format html"));
        for tag in [
            "p", "math", "mrow", "mfrac", "msqrt", "msup", "msub", "msubsup", "mi", "mn", "mo", "table", "td",
        ] {
            let opened =
                html.matches(&format!("<{tag}>")).count() + html.matches(&format!("<{tag} ")).count();
            assert_eq!(opened, html.matches(&format!("</{tag}>")).count(), "{road}: {tag}");
        }
    }
}

#[test]
fn numbers_are_those_of_the_pendulum() {
    let derivation = text("derive --road elliptic --amplitude 40deg --length 57cm --gravity 9.81");
    // 2π√(l/g)/agm(1, cos 20°), by mpmath.
    assert!(derivation.contains("1.5620138239"));
    assert!(!text("derive --road elliptic").contains("digits printed"));
}

#[test]
fn a_file_is_written_in_place_of_the_screen() {
    let path = directory("derive").join("period.html");
    let output = libration(&format!("derive --road elliptic --format html --output {}", path.display()));
    assert!(output.status.success() && output.stdout.is_empty(), "{}", message(&output));
    assert!(fs::read_to_string(&path).unwrap().ends_with("</html>\n"));
    assert_eq!(fs::read_dir(path.parent().unwrap()).unwrap().count(), 1);
}

#[test]
fn questions_without_sense_are_refused() {
    let cases = [
        ("derive", 2, "--road"),
        ("derive --road straight", 2, "elliptic"),
        ("derive --road elliptic --format pdf", 2, "latex"),
        ("derive --road elliptic --length 1m", 2, "--amplitude"),
        ("derive --road elliptic --amplitude 200deg", 1, "--amplitude"),
        ("derive --road formulas --amplitude 179.99deg", 1, "179.9"),
        ("derive --road elliptic --output /nonexistent/a/b.md", 1, "/nonexistent/a/b.md"),
    ];
    for (arguments, status, part) in cases {
        let output = libration(arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments}");
        assert!(message(&output).contains(part), "{arguments}: {}", message(&output));
        assert!(output.stdout.is_empty(), "{arguments}");
    }
}
