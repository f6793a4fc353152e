//! Pictures for a journal: without a title, with names at the curves, with angles in radians, with a panel for the approach to the top.

use crate::command::{directory, json, text};
use crate::drawing::{Drawing, Place};
use std::f64::consts::PI;
use std::fs;

fn drawn(question: &str) -> Drawing {
    let name: String = question.chars().filter(char::is_ascii_alphanumeric).take(100).collect();
    let file = directory(&format!("layout-{name}")).join("picture.svg");
    text(&format!("{question} {}", file.display()));
    Drawing::read(&fs::read_to_string(file).unwrap())
}

/// The names of all curves, in order.
fn names(drawing: &Drawing) -> Vec<String> {
    let mut names: Vec<String> = drawing.of_class("name").into_iter().map(str::to_owned).collect();
    names.sort();
    names
}

#[test]
fn a_title_is_left_out_with_its_parameters() {
    let with = drawn("motion 60deg --figure");
    assert!(!with.of_class("title").is_empty() && !with.of_class("parameters").is_empty());
    let without = drawn("motion 60deg --no-title --figure");
    assert!(without.of_class("title").is_empty() && without.of_class("parameters").is_empty());
    // The axes keep their size.
    assert!((with.panels[0].height - without.panels[0].height).abs() < 0.02);
    assert!(without.height < with.height - 30.0);
}

#[test]
fn names_stand_at_their_curves_or_in_the_legend() {
    let questions = [
        ("figure series pendulum --output", 6),
        ("figure errors --output", 3),
        ("figure errors --near-top --size column --output", 1),
        ("figure phase --output", 1),
        ("motion 150deg --compare small-angle,fourier-3,fourier-5 --figure", 1),
    ];
    for (question, least) in questions {
        let usual = drawn(question);
        let words: Vec<&str> = question.rsplitn(2, ' ').collect();
        let drawing = drawn(&format!("{} --curve-labels {}", words[1], words[0]));
        let mut labels = names(&drawing);
        labels.dedup();
        assert_eq!(labels, names(&usual), "{question}");
        let mut inside = 0;
        for (number, panel) in drawing.panels.iter().enumerate() {
            let [left, top] = [panel.left, panel.top];
            let within = |[l, t, r, b]: [f64; 4]| {
                l >= left && r <= left + panel.width && t >= top && b <= top + panel.height
            };
            let at_curves: Vec<[f64; 4]> = drawing
                .texts
                .iter()
                .filter(|text| text.class == "name" && within(text.extent()))
                .map(|text| text.extent())
                .collect();
            inside += at_curves.len();
            for (index, extent) in at_curves.iter().enumerate() {
                let touches = |other: &[f64; 4]| {
                    extent[0] < other[2]
                        && other[0] < extent[2]
                        && extent[1] < other[3]
                        && other[1] < extent[3]
                };
                assert!(!at_curves[..index].iter().any(touches), "{question}: names touch");
                assert!(!drawing.is_crossed(number, *extent), "{question}: a curve runs through a name");
            }
        }
        assert!(inside >= least, "{question}: {inside}");
    }
}

fn has_axis(drawing: &Drawing, label: &str) -> bool {
    drawing.of_class("axis").iter().any(|text| text.replace('\u{a0}', " ") == label)
}

#[test]
fn angles_are_in_the_unit_requested() {
    let degrees = drawn("motion 90deg --figure");
    let radians = drawn("motion 90deg --angles radians --figure");
    let highest = |drawing: &Drawing| {
        let curves = drawing.curves(0, "#0072b2").concat();
        curves.iter().map(|point: &Place| point.1).fold(f64::NEG_INFINITY, f64::max)
    };
    assert!((highest(&degrees) - 90.0).abs() < 0.5);
    // The labels of the ticks are read as multiples of π.
    assert!((highest(&radians) - 0.5).abs() < 0.005, "{}", highest(&radians));
    assert!(has_axis(&radians, "angle θ / rad"), "{:?}", radians.of_class("axis"));
    let portrait = drawn("figure phase --angles degrees --output");
    assert!(has_axis(&portrait, "angle θ / degrees"), "{:?}", portrait.of_class("axis"));
    assert!(portrait.of_class("x-tick").contains(&"180"));
    let file = directory("layout-idle").join("picture.svg").display().to_string();
    let question = "lyapunov pendulum --initial theta=1 --intervals 20 --angles degrees --figure";
    let answer: Vec<String> =
        text(&format!("{question} {file}")).split_whitespace().map(str::to_owned).collect();
    let answer = answer.join(" ");
    assert!(answer.contains("there are no angles along its axes"), "{answer}");
}

/// The error of Butikov's formula, (2/π)L with L = ln(8/δ) at the distance δ from the top, falls with δ² there:
/// T/T0 = (2/π)(L + ((L − 1)/16 + 1/24)δ² + …) by DLMF 19.12.1 with k′ = sin(δ/2).
#[test]
fn the_panel_near_the_top_reaches_it() {
    let file = directory("layout-top").join("picture.svg").display().to_string();
    let answer = json(&format!("figure errors --formulas butikov,bernoulli --near-top --output {file}"));
    let series = answer["series"].as_array().unwrap();
    assert_eq!(series.iter().map(|row| row["panel"].as_u64().unwrap()).collect::<Vec<_>>(), [1, 1, 2, 2]);
    let points = series[2]["points"].as_array().unwrap();
    let mut checked = 0;
    for point in points {
        let [degrees, error] = [0, 1].map(|part| point[part].as_f64().unwrap_or(f64::NAN));
        let distance = degrees.to_radians();
        if (1e-5..1e-2).contains(&distance) {
            let logarithm = (8.0 / distance).ln();
            let expected = ((logarithm - 1.0) / 16.0 + 1.0 / 24.0) * distance * distance / logarithm;
            assert!((error / expected - 1.0).abs() < 2e-3, "{degrees}: {error:e} {expected:e}");
            checked += 1;
        }
    }
    assert!(checked > 100);
}

/// One, two and three terms of one series have one colour and different dashes.
#[test]
fn a_family_of_formulas_has_one_colour() {
    let file = directory("layout-family").join("picture.svg");
    text(&format!(
        "figure errors --formulas denman,molina,black_vel_2,black_vel_3,bernoulli,power_series_2 --output {}",
        file.display()
    ));
    let svg = fs::read_to_string(file).unwrap();
    let looks: Vec<(String, String)> = svg
        .split("class=\"curve\"")
        .skip(1)
        .map(|curve| {
            let value = |name: &str| {
                let rest = curve.split_once(" d=").unwrap().0.split_once(name).map_or("", |(_, rest)| rest);
                rest.split('"').next().unwrap().to_owned()
            };
            (value("stroke=\""), value("stroke-dasharray=\""))
        })
        .collect();
    let same = |a: usize, b: usize| looks[a].0 == looks[b].0;
    assert!(same(0, 2) && same(0, 3) && same(4, 5) && !same(0, 1) && !same(0, 4) && !same(1, 4), "{looks:?}");
    for (index, look) in looks.iter().enumerate() {
        assert!(!looks[..index].contains(look), "{looks:?}");
    }
}

/// The curves of partial sums begin at the lower edge, not at the first sample.
#[test]
fn errors_of_series_run_down_to_the_axis_at_small_amplitudes() {
    let drawing = drawn("figure series pendulum --output");
    let first = &drawing.curves(0, "#0072b2")[0];
    let lowest = first.iter().map(|point| point.1).fold(f64::INFINITY, f64::min);
    assert!(lowest < 1.5e-14, "{lowest:e}");
    assert!(first.iter().all(|point| point.0 >= -0.2 && point.0 <= 180.0 + PI));
}
