//! Pictures as JSON: the content that is drawn as SVG, in numbers.

use crate::command::{directory, json, libration, message, refusal, text, unfolded};
use crate::drawing::{Drawing, Panel, Place, middle};
use serde_json::Value;
use std::{fs, sync::LazyLock};

const EXAMPLES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");

/// A query of each command that draws; `@` stands for the examples.
const DRAWN: [&str; 32] = [
    "figure errors --formulas bernoulli,denman --near-top",
    "figure motion --amplitudes 30deg,150deg",
    "figure phase",
    "figure series pendulum",
    "figure spectrum --amplitudes 60deg,150deg",
    "figure trajectories damped_pendulum --over c=0.05,0.2 --initial theta=170deg --to 10s",
    "period 10deg:170deg:20deg",
    "motion 60deg --compare small-angle",
    "fourier 170deg",
    "decay 60deg --linear 0.1 --cycles 3",
    "backbone duffing --amplitudes 0.5,1",
    "simulate double_pendulum --initial theta1=1 --times 0:2:0.1",
    "simulate double_pendulum --initial theta1=1 --times -1:1:0.1",
    "simulate double_pendulum --initial theta1=1 --times 0:2:0.1 --axes theta1,theta2",
    "modes double_pendulum",
    "modes double_pendulum --follow 2 --amplitudes 30deg,50deg,60deg",
    "orbit pendulum --initial theta=60deg",
    "resonance x''=-x-x*y;y''=-4.1*y-x^2/2 --order 2 --initial x=0.1,y=0.02",
    "melnikov driven_pendulum --set A=0.3,c=0.1,omega=1",
    "response driven_pendulum --set A=0.15,c=0.1 --over omega=0.7:0.95 --sweeps 5",
    "stability kapitza --set c=0.1 --map omega=5:6,a=0.1:0.4 --initial theta=180deg --lines 0",
    "section driven_pendulum --set A=1.5,c=0.5 --initial theta=0.2 --points 3 --skip 0",
    "bifurcation driven_pendulum --set c=0.5 --over A=1:1.1:0.1 --initial theta=0.2 --points 2 --skip 0",
    "lyapunov pendulum --initial theta=1 --intervals 30",
    "plan --g-to 1e-3 --length 1.00(1)m --angle-noise 0.2deg --rate 60",
    "inspect @/swing_synthetic.csv --spectrum",
    "fit periods @/period_table_synthetic.csv",
    "fit amplitudes @/amplitudes_synthetic.csv",
    "fit lengths @/lengths_synthetic.csv",
    "fit gates @/gate_synthetic.csv --length 0.958m --diameter 25mm",
    "fit response @/response_synthetic.csv --model pendulum",
    "fit trace @/swing_synthetic.csv --model linear",
];

/// The text of the picture of a query in a file with this ending.
fn written(question: &str, ending: &str) -> String {
    let name: String = question.chars().filter(char::is_ascii_alphanumeric).take(90).collect();
    let file = directory(&format!("chart-{name}")).join(format!("picture.{ending}"));
    let option = if question.starts_with("figure") { "--output" } else { "--figure" };
    text(&format!("{} {option} {}", question.replace('@', EXAMPLES), file.display()));
    fs::read_to_string(file).unwrap()
}

fn chart(question: &str) -> Value {
    serde_json::from_str(&written(question, "json")).unwrap()
}

/// Each query with its chart.
static CHARTS: LazyLock<Vec<(&str, Value)>> =
    LazyLock::new(|| DRAWN.into_iter().map(|question| (question, chart(question))).collect());

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}

fn points(series: &Value) -> Vec<Place> {
    list(&series["x"]).iter().zip(list(&series["y"])).map(|(x, y)| (number(x), number(y))).collect()
}

/// Asserts that a panel has its axes and series of equal columns, and names of their looks.
fn is_whole(question: &str, panel: &Value) {
    assert!(number(&panel["share"]) > 0.0, "{question}: {}", panel["share"]);
    for axis in [&panel["x"], &panel["y"]] {
        assert!(axis["label"].is_string(), "{question}: {axis}");
        assert!(number(&axis["from"]) < number(&axis["to"]), "{question}: {axis}");
        let is_logarithmic = axis["scale"] == "logarithmic";
        assert!(is_logarithmic || axis["scale"] == "linear", "{question}: {axis}");
        assert!(!is_logarithmic || number(&axis["from"]) > 0.0, "{question}: {axis}");
        assert_eq!(axis["ticks"] == "names", axis["names"].is_array(), "{question}: {axis}");
        assert_eq!(axis["ticks"] == "half_turns", axis["half_turn"].is_number(), "{question}: {axis}");
    }
    for series in list(&panel["series"]) {
        let count = list(&series["x"]).len();
        for name in ["y", "x_uncertainty", "y_uncertainty"] {
            let column = series.get(name).map_or(count, |column| list(column).len());
            assert_eq!(column, count, "{question}: {name} of {}", series["label"]);
        }
        assert!(series["colour"].as_str().unwrap().starts_with('#'), "{question}");
        let mark = series["mark"].as_str().unwrap();
        match mark {
            "line" => assert!(number(&series["line_width"]) > 0.0 && series["dashes"].is_array()),
            "band" => assert!(series["y_uncertainty"].is_array(), "{question}"),
            _ => assert!(
                ["circle", "square", "triangle", "diamond"].contains(&mark)
                    && number(&series["marker_radius"]) > 0.0,
                "{question}: {mark}"
            ),
        }
    }
}

#[test]
fn each_command_that_draws_writes_its_chart() {
    for (question, chart) in &*CHARTS {
        assert_eq!(chart["schema"], 2, "{question}");
        assert!(!chart["title"].as_str().unwrap().is_empty(), "{question}");
        assert!(chart["parameters"].is_array() && number(&chart["aspect"]) > 0.0, "{question}");
        let panels = list(&chart["panels"]);
        assert!(!panels.is_empty(), "{question}");
        panels.iter().for_each(|panel| is_whole(question, panel));
        let count =
            |panel: &Value| list(&panel["series"]).iter().map(|curve| list(&curve["x"]).len()).sum::<usize>();
        assert!(panels.iter().all(|panel| count(panel) > 0), "{question}");
    }
    for question in libration_queries::questions() {
        let draws = question.parameters.iter().any(|parameter| parameter.name == "figure");
        let is_here = DRAWN.iter().any(|entry| entry.starts_with(&format!("{} ", question.words)));
        assert!(!draws || is_here, "{} draws, and its chart is not tested", question.words);
    }
}

/// The position on the canvas of a point of a panel.
fn on_canvas(panel: &Value, drawn: &Panel, (x, y): Place) -> Place {
    let part = |axis: &Value, value: f64| {
        let along = |value: f64| if axis["scale"] == "logarithmic" { value.log10() } else { value };
        let [from, to] = ["from", "to"].map(|end| along(number(&axis[end])));
        (along(value) - from) / (to - from)
    };
    let (right, up) = (part(&panel["x"], x), part(&panel["y"], y));
    (drawn.left + right * drawn.width, drawn.top + (1.0 - up) * drawn.height)
}

/// Returns `true` if a point lies in the frame, not next to its edge.
fn holds(drawn: &Panel, (x, y): Place) -> bool {
    let (right, bottom) = (drawn.left + drawn.width, drawn.top + drawn.height);
    x > drawn.left + 0.1 && x < right - 0.1 && y > drawn.top + 0.1 && y < bottom - 0.1
}

/// The distance of a point from curves.
fn distance(curves: &[Vec<Place>], at: Place) -> f64 {
    let segments = curves.iter().flat_map(|curve| curve.windows(2));
    let away = segments.map(|pair| {
        let (a, b) = (pair[0], pair[1]);
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let long = dx * dx + dy * dy;
        let along = ((at.0 - a.0) * dx + (at.1 - a.1) * dy) / long;
        let along = if long > 0.0 { along.clamp(0.0, 1.0) } else { 0.0 };
        (at.0 - a.0 - along * dx).hypot(at.1 - a.1 - along * dy)
    });
    away.fold(f64::INFINITY, f64::min)
}

/// Half a unit of the canvas, an eighth of a millimetre.
const NEAR: f64 = 0.5;

fn is_near(a: Place, b: Place) -> bool {
    (a.0 - b.0).hypot(a.1 - b.1) < NEAR
}

/// Asserts that the ticks of the drawing show the ends of the axes, where they are plain numbers.
fn ends_agree(question: &str, panel: &Value, drawn: &Panel) {
    let low = drawn.data_at((drawn.left, drawn.top + drawn.height));
    let high = drawn.data_at((drawn.left + drawn.width, drawn.top));
    for (axis, [found_from, found_to]) in [(&panel["x"], [low.0, high.0]), (&panel["y"], [low.1, high.1])] {
        // On short logarithmic axes ticks are plain numbers, which the drawing is read by as if it were linear.
        let is_short = axis["scale"] == "logarithmic" && number(&axis["to"]) < 100.0 * number(&axis["from"]);
        if is_short || axis["ticks"] == "names" || axis["ticks"] == "half_turns" {
            continue;
        }
        let along = |value: f64| if axis["scale"] == "logarithmic" { value.log10() } else { value };
        let [from, to] = ["from", "to"].map(|end| along(number(&axis[end])));
        for (seen, expected) in [(found_from, from), (found_to, to)] {
            let away = (along(seen) - expected).abs() / (to - from);
            assert!(away < 5e-3, "{question}: {seen} {axis}");
        }
    }
}

/// Compares panels, ends of axes, legends, curves and markers with those of the SVG.
#[test]
fn the_svg_draws_what_the_chart_has() {
    for (question, chart) in &*CHARTS {
        let drawing = Drawing::read(&written(question, "svg"));
        let panels = list(&chart["panels"]);
        assert_eq!(panels.len(), drawing.panels.len(), "{question}");
        // A name that a panel above explains is written there only.
        let name = |series: &Value| {
            let mut name = series.clone();
            for column in ["x", "y", "x_uncertainty", "y_uncertainty"] {
                name.as_object_mut().unwrap().remove(column);
            }
            name
        };
        let new = |(index, panel): (usize, &Value)| {
            let above: Vec<Value> =
                panels[..index].iter().flat_map(|other| list(&other["series"])).map(name).collect();
            let names = list(&panel["series"]).iter().map(name);
            names.filter(|label| !above.contains(label)).collect::<Vec<Value>>()
        };
        let labels: Vec<Value> = panels.iter().enumerate().flat_map(new).collect();
        let labels =
            labels.iter().map(|curve| curve["label"].as_str().unwrap()).filter(|label| !label.is_empty());
        let words = |text: &str| text.replace([' ', '\u{a0}', '\n'], "");
        let labels: String = labels.map(words).collect();
        assert_eq!(labels, drawing.of_class("name").into_iter().map(words).collect::<String>(), "{question}");
        for (index, (panel, drawn)) in panels.iter().zip(&drawing.panels).enumerate() {
            ends_agree(question, panel, drawn);
            for series in list(&panel["series"]) {
                let colour = series["colour"].as_str().unwrap();
                let canvas = |series| -> Vec<Place> {
                    points(series).into_iter().map(|at| on_canvas(panel, drawn, at)).collect()
                };
                if series["mark"] == "line" {
                    let same =
                        |value: &&Value| value["colour"] == series["colour"] && value["mark"] == "line";
                    let all: Vec<_> = list(&panel["series"]).iter().filter(same).map(canvas).collect();
                    let drawn = drawing.on_canvas(index, "curve", colour).concat();
                    let step = 1 + drawn.len() / 200;
                    for at in drawn.into_iter().step_by(step) {
                        assert!(distance(&all, at) < NEAR, "{question}: {at:?} is not on the curve");
                    }
                } else if series["mark"] != "band" {
                    let markers = drawing.on_canvas(index, "markers", colour);
                    let markers: Vec<Place> = markers.iter().map(|shape| middle(shape)).collect();
                    for at in canvas(series).into_iter().filter(|at| holds(drawn, *at)) {
                        assert!(
                            markers.iter().any(|marker| is_near(*marker, at)),
                            "{question}: {at:?} is not drawn"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn error_bars_are_uncertainties() {
    let mut bars = 0;
    let has_bars = |(_, chart): &&(&str, Value)| {
        list(&chart["panels"])
            .iter()
            .flat_map(|panel| list(&panel["series"]))
            .any(|series| series.get("y_uncertainty").is_some())
    };
    for (question, chart) in CHARTS.iter().filter(has_bars) {
        let drawing = Drawing::read(&written(question, "svg"));
        for (index, (panel, drawn)) in list(&chart["panels"]).iter().zip(&drawing.panels).enumerate() {
            let corners: Vec<Place> = drawing.bars(index).copied().collect();
            for series in list(&panel["series"]).iter().filter(|series| series["mark"] != "band") {
                let Some(halves) = series.get("y_uncertainty") else { continue };
                for ((x, y), half) in points(series).into_iter().zip(list(halves)) {
                    let ends =
                        [y - number(half), y + number(half)].map(|end| on_canvas(panel, drawn, (x, end)));
                    if ends.iter().all(|end| holds(drawn, *end)) {
                        bars += 1;
                        assert!(
                            ends.iter().all(|end| corners.iter().any(|corner| is_near(*corner, *end))),
                            "{question}: {x}"
                        );
                    }
                }
            }
        }
    }
    assert!(bars > 100, "{bars}");
}

#[test]
fn axes_have_their_scales_units_and_names() {
    let spectrum = chart("figure spectrum --amplitudes 60deg,150deg");
    let [x, y] = ["x", "y"].map(|name| &spectrum["panels"][0][name]);
    assert_eq!((x["ticks"].as_str(), x["scale"].as_str()), (Some("whole"), Some("linear")));
    assert_eq!(y["scale"], "logarithmic");
    let modes = chart("modes double_pendulum");
    assert_eq!(modes["panels"][0]["x"]["names"], serde_json::json!(["θ₁", "θ₂"]));
    let motion = chart("motion 60deg");
    assert_eq!(motion["panels"][0]["y"]["ticks"], "degrees");
    let radians = chart("motion 60deg --angles radians");
    assert_eq!(radians["panels"][0]["y"]["ticks"], "half_turns");
    let largest =
        |chart: &Value| list(&chart["panels"][0]["series"][0]["y"]).iter().map(number).fold(0.0, f64::max);
    assert!((largest(&motion) - 60.0).abs() < 1e-9);
    assert!((largest(&radians) - 60_f64.to_radians()).abs() < 1e-12);
}

#[test]
fn options_of_the_size_have_no_effect_on_data_and_say_so() {
    let file = directory("chart-options").join("a.json").display().to_string();
    let usual = text(&format!("motion 60deg --figure {file}"));
    assert!(!usual.contains("no size"), "{usual}");
    let chart = fs::read_to_string(&file).unwrap();
    for option in ["--size slide", "--width 80mm", "--height 80mm", "--curve-labels"] {
        let said = unfolded(&text(&format!("motion 60deg {option} --figure {file}")));
        assert!(said.contains("data have no size and no names at curves"), "{said}");
        assert_eq!(fs::read_to_string(&file).unwrap(), chart, "{option}");
    }
    text(&format!("motion 60deg --no-title --figure {file}"));
    let bare: Value = serde_json::from_str(&fs::read_to_string(&file).unwrap()).unwrap();
    assert_eq!((&bare["title"], &bare["parameters"]), (&"".into(), &serde_json::json!([])));
    let said = refusal("motion 60deg --animate --figure a.json");
    assert!(said.contains("a.json cannot be animated: give a file name ending in .svg"), "{said}");
}

/// The picture of a motion on both sides of its start has both.
#[test]
fn a_motion_in_both_directions_is_drawn() {
    let chart = chart("simulate x''=-4*x --initial x=1 --times -3:2:1");
    let panel = &chart["panels"][0];
    assert_eq!((number(&panel["x"]["from"]), number(&panel["x"]["to"])), (-3.0, 2.0));
    let curve = points(&panel["series"][0]);
    assert!(curve.windows(2).all(|pair| pair[0].0 < pair[1].0), "{:?}", &curve[..3]);
    assert!((curve[0].0, curve[curve.len() - 1].0) == (-3.0, 2.0));
    assert!(curve.iter().all(|(t, x)| (x - (2.0 * t).cos()).abs() < 1e-10));
    let file = directory("chart-both").join("a.svg").display().to_string();
    let said =
        refusal(&format!("simulate pendulum --initial theta=1 --times -3:2:1 --animate --figure {file}"));
    assert!(said.contains("--animate") && unfolded(&said).contains("motions in one direction"), "{said}");
}

#[test]
fn pictures_of_periods_harmonics_and_plans_have_the_numbers_of_their_results() {
    let periods = json("period 30deg 170deg");
    let chart_of_periods = chart("period 30deg 170deg");
    let markers = points(&list(&chart_of_periods["panels"][0]["series"])[2]);
    for (row, (degrees, period)) in list(&periods["results"]).iter().zip(markers) {
        assert!((number(&row["amplitude_rad"]).to_degrees() - degrees).abs() < 1e-12);
        assert_eq!(number(&row["period_s"]).to_bits(), period.to_bits());
    }
    let harmonics = json("fourier 170deg");
    let velocity = chart("fourier 170deg");
    let velocity = points(&list(&velocity["panels"][0]["series"])[3]);
    assert_eq!(velocity.len(), list(&harmonics["harmonics"]).len());
    for (term, (n, size)) in list(&harmonics["harmonics"]).iter().zip(velocity) {
        assert_eq!(number(&term["n"]).to_bits(), n.to_bits());
        assert_eq!(number(&term["velocity_rad_per_s"]).abs().to_bits(), size.to_bits());
    }
    let question = "plan --g-to 1e-3 --length 1.00(1)m --angle-noise 0.2deg --rate 60";
    let (answer, chart) = (json(question), chart(question));
    let series = list(&chart["panels"][0]["series"]);
    let total = series.iter().find(|curve| curve["label"] == "total").unwrap();
    for (choice, (_, part)) in list(&answer["choices"]).iter().zip(points(total)) {
        assert_eq!(number(&choice["total"]).to_bits(), part.to_bits());
    }
    let output = libration("period 60deg --figure /nowhere/a.json");
    assert!(!output.status.success() && message(&output).contains("/nowhere"));
}
