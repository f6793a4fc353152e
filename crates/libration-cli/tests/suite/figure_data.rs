//! Pictures show the right data: read back from the drawing and compared with known values.

use crate::command::{directory, json, text};
use crate::drawing::{Drawing, Place};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI, TAU};
use std::fs;

/// The colours of the first curves, of reference lines and of fitted laws.
const FIRST: &str = "#0072b2";
const SECOND: &str = "#d55e00";
const THIRD: &str = "#009e73";
const FOURTH: &str = "#cc79a7";
const BLACK: &str = "#000000";
const GREY: &str = "#767676";
const ORANGE: &str = "#e69f00";
const LAW: &str = SECOND;

const EXAMPLES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");

fn drawn(question: &str, option: &str) -> Drawing {
    let name: String =
        question.replace(EXAMPLES, "").chars().filter(char::is_ascii_alphanumeric).take(80).collect();
    let file = directory(&format!("data-{name}")).join("figure.svg").display().to_string();
    let words: Vec<&str> = question.split('|').chain([option, &file]).collect();
    let output = crate::command::run(&words);
    assert!(output.status.success(), "{question}: {}", crate::command::message(&output));
    Drawing::read(&fs::read_to_string(file).unwrap())
}

fn figure(question: &str) -> Drawing {
    drawn(&format!("figure|{question}"), "--output")
}

/// T/T0 by the arithmetic-geometric mean.
fn period_ratio(amplitude: f64) -> f64 {
    let (mut a, mut b) = (1.0, (0.5 * amplitude).cos());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a.recip()
}

fn close(drawn: f64, expected: f64, tolerance: f64) {
    assert!((drawn - expected).abs() <= tolerance, "{drawn} is not {expected}, by more than {tolerance}");
}

/// Asserts that two sets of points are equal in any order, within the rounding of shapes.
fn same_points(drawing: &Drawing, panel: usize, drawn: Vec<Place>, expected: Vec<Place>) {
    let sorted = |mut points: Vec<Place>| {
        points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        points
    };
    let (drawn, expected) = (sorted(drawn), sorted(expected));
    assert_eq!(drawn.len(), expected.len(), "{drawn:?} {expected:?}");
    // A hundredth of a unit for the point, and the same for each of the two ticks that give the scale.
    let (x, y) = drawing.panels[panel].resolution();
    let is_near = |a: Place, b: Place| (a.0 - b.0).abs() <= 3.0 * x && (a.1 - b.1).abs() <= 3.0 * y;
    for point in &expected {
        assert!(drawn.iter().any(|other| is_near(*point, *other)), "{point:?} is not drawn: {drawn:?}");
    }
}

#[test]
fn errors_of_the_formulas() {
    let drawing = figure("errors|--formulas|bernoulli,kidd_fogg");
    for degrees in [45.0_f64, 90.0, 150.0] {
        let angle = degrees.to_radians();
        let ratio = period_ratio(angle);
        let bernoulli = 1.0 - (1.0 + angle * angle / 16.0) / ratio;
        let kidd_fogg = (0.5 * angle).cos().powf(-0.5) / ratio - 1.0;
        for (colour, error) in [(FIRST, bernoulli), (SECOND, kidd_fogg)] {
            let shown = if colour == FIRST {
                drawing.value_at(0, colour, degrees)
            } else {
                near(&drawing, 0, colour, degrees)
            };
            // Two pixels in a hundred are 3e-4 of a decade.
            close(shown / error.abs(), 1.0, 2e-3);
        }
    }
}

/// The value of a dashed curve at the end of a dash next to an abscissa.
fn near(drawing: &Drawing, panel: usize, colour: &str, x: f64) -> f64 {
    let points = drawing.curves(panel, colour).concat();
    let [before, after] = [|a: f64, b: f64| a <= b, |a: f64, b: f64| a >= b].map(|side| {
        let candidates = points.iter().filter(|point| side(point.0, x));
        *candidates.min_by(|a, b| (a.0 - x).abs().total_cmp(&(b.0 - x).abs())).unwrap()
    });
    if after.0 <= before.0 {
        return before.1;
    }
    // Between dashes the curve is interpolated linearly on the logarithmic axis.
    let part = (x - before.0) / (after.0 - before.0);
    (before.1.ln() + part * (after.1.ln() - before.1.ln())).exp()
}

#[test]
fn angles_after_a_release() {
    let drawing = figure("motion|--amplitudes|150deg|--periods|2");
    let ratio = period_ratio(150_f64.to_radians());
    for (part, angle) in [(0.0, 1.0), (0.25, 0.0), (0.5, -1.0), (0.75, 0.0), (1.0, 1.0)] {
        close(drawing.value_at(0, FIRST, part * ratio), angle, 0.01);
    }
    let answer = json(&format!("figure motion --amplitudes 150deg --output {}", file("motion")));
    let cosine = points(&answer["series"][0]);
    assert!(
        answer["series"][0]["label"].as_str().unwrap().contains("small"),
        "{}",
        answer["series"][0]["label"]
    );
    assert!(cosine.len() > 100 && cosine.iter().all(|(x, y)| (y - (TAU * x).cos()).abs() < 1e-12));
}

fn file(name: &str) -> String {
    directory(&format!("data-json-{name}")).join("figure.svg").display().to_string()
}

fn points(series: &serde_json::Value) -> Vec<Place> {
    let list = series["points"].as_array().unwrap();
    list.iter().map(|point| (point[0].as_f64().unwrap(), point[1].as_f64().unwrap())).collect()
}

#[test]
fn orbits_of_the_phase_portrait() {
    // θ′²/4ω0² + sin²(θ/2) is k² for a libration, 1 on the separatrix, and E/2mgl for a rotation.
    let invariant = |(x, y): &Place| 0.25 * y * y + (FRAC_PI_2 * x).sin().powi(2);
    let answer =
        json(&format!("figure phase --amplitudes 60deg,120deg --energies 1.3,2 --output {}", file("phase")));
    let expected = [0.25, 0.75, 1.0, 1.3, 2.0];
    let mut index = None;
    for series in answer["series"].as_array().unwrap() {
        if !series["label"].as_str().unwrap().is_empty() {
            index = Some(index.map_or(0, |last: usize| last + 1));
        }
        let expected = expected[index.unwrap()];
        assert!(
            points(series).iter().all(|point| (invariant(point) - expected).abs() < 1e-13),
            "{}",
            series["label"]
        );
    }
    assert_eq!(index, Some(4));
    let drawing = figure("phase|--amplitudes|60deg|--energies|2");
    let orbit = drawing.curves(0, FIRST).concat();
    assert!(orbit.len() > 800 && orbit.iter().all(|point| (invariant(point) - 0.25).abs() < 2e-3));
}

#[test]
fn harmonics_of_the_spectrum() {
    let drawing = figure("spectrum|--amplitudes|90deg|--harmonics|9");
    let q = (-PI).exp();
    let markers = drawing.markers(0, FIRST);
    assert_eq!(markers.len(), 5);
    for (marker, n) in markers.iter().zip([1.0, 3.0, 5.0, 7.0, 9.0]) {
        close(marker.0, n, 0.01);
        close(marker.1 / (8.0 * q.powf(0.5 * n) / (n * (1.0 + q.powf(n)))), 1.0, 5e-3);
    }
}

#[test]
fn errors_of_partial_sums() {
    let ratio = period_ratio(FRAC_PI_2);
    let sums = [
        1.0,
        1.0 + FRAC_PI_2.powi(2) / 16.0,
        1.0 + FRAC_PI_2.powi(2) / 16.0 + 11.0 / 3072.0 * FRAC_PI_2.powi(4),
    ];
    let drawing = figure("series|pendulum");
    close(drawing.value_at(0, FIRST, 90.0) / (sums[1] - ratio).abs(), 1.0, 5e-3);
    let terms = figure("series|pendulum|--amplitudes|90deg|--order|5");
    let markers = terms.markers(0, FIRST);
    for (marker, (power, sum)) in markers.iter().zip([(0.0, sums[0]), (2.0, sums[1]), (4.0, sums[2])]) {
        close(marker.0, power, 0.02);
        close(marker.1 / (sum - ratio).abs(), 1.0, 5e-3);
    }
    assert_eq!(markers.len(), 3);
}

#[test]
fn a_motion_beside_its_approximation() {
    let drawing = drawn("motion|90deg|--compare|small-angle|--times|0:5:0.1", "--figure");
    let t0 = TAU / 9.80665_f64.sqrt();
    let period = t0 * period_ratio(FRAC_PI_2);
    for (part, angle) in [(0.0, 90.0), (0.25, 0.0), (0.5, -90.0), (1.0, 90.0)] {
        close(drawing.value_at(0, FIRST, part * period), angle, 0.2);
    }
    // At the first turning point on the other side, the cosine of the small-angle motion is elsewhere.
    let error = (90.0 * (TAU * 0.5 * period / t0).cos() + 90.0).abs();
    close(near(&drawing, 1, SECOND, 0.5 * period) / error, 1.0, 0.02);
}

#[test]
fn a_decay_with_its_laws() {
    let drawing = drawn("decay|60deg|--linear|0.1|--cycles|10", "--figure");
    let markers = drawing.markers(0, BLACK);
    close(markers[0].0, 0.0, 0.01);
    close(markers[0].1, 60.0, 0.05);
    assert_eq!(markers.len(), 21);
    let small = drawing.curves(0, SECOND).concat();
    assert!(small.iter().all(|(t, amplitude)| (amplitude - 60.0 * (-0.05 * t).exp()).abs() < 0.1));
    close(drawing.value_at(0, FIRST, 0.0), 60.0, 0.05);
    let t0 = TAU / 9.80665_f64.sqrt();
    assert!(drawing.curves(1, GREY).concat().iter().all(|(_, period)| (period - t0).abs() < 1e-3));
    let exact = drawing.curves(1, THIRD).concat();
    close(exact[0].1, t0 * period_ratio(FRAC_PI_3), 1e-3);
    let csv = text("decay 60deg --linear 0.1 --cycles 10 --csv");
    let times = numbers(&csv);
    let cycles = times.iter().skip(2).step_by(2).zip(times.iter().skip(1).step_by(2));
    let expected = cycles.map(|(end, middle)| (middle[1], end[6])).collect();
    same_points(&drawing, 1, drawing.markers(1, BLACK), expected);
}

/// The law of the slow flow, and its cycles if the table has them.
#[test]
fn a_decay_with_its_slow_flow() {
    let drawing = drawn("decay|30deg|--linear|0.1|--cycles|5|--order|5", "--figure");
    let law = drawing.curves(0, FOURTH).concat();
    assert!(law.iter().all(|(t, amplitude)| (amplitude - 30.0 * (-0.05 * t).exp()).abs() < 0.2), "{law:?}");
    let rows = numbers(&text("decay 30deg --linear 0.1 --cycles 5 --order 5 --csv"));
    let ends = rows.iter().skip(2).step_by(2).zip(rows.iter().skip(1).step_by(2));
    let expected: Vec<(f64, f64)> = ends.map(|(end, middle)| (middle[1], end[12])).collect();
    let cycles = drawing.curves(1, FOURTH).concat();
    assert_eq!(cycles.len(), expected.len());
    let (x, y) = drawing.panels[1].resolution();
    for (drawn, expected) in cycles.iter().zip(expected) {
        close(drawn.0, expected.0, 3.0 * x);
        close(drawn.1, expected.1, 3.0 * y);
    }
}

/// The numbers of a table below its header; NaN for empty cells.
fn numbers(csv: &str) -> Vec<Vec<f64>> {
    let lines = csv.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect()).collect()
}

#[test]
fn a_backbone_is_frequency_against_amplitude() {
    // Ω of x″ = −x³ released from A is 2π A / 4K(1/2), with K(1/2)·√2… = 7.4162987092054876737 for A = 1.
    let slope = TAU / 7.416_298_709_205_488;
    let drawing = drawn("backbone|x''=-x^3|--amplitudes|0.5,1,2", "--figure");
    let expected = [0.5, 1.0, 2.0].map(|amplitude| (slope * amplitude, amplitude)).to_vec();
    same_points(&drawing, 0, drawing.markers(0, FIRST), expected);
    let curve = drawing.curves(0, FIRST).concat();
    assert!(
        curve.len() > 200
            && curve.iter().all(|(frequency, amplitude)| (frequency - slope * amplitude).abs() < 5e-3)
    );
    let series = drawn("backbone|pendulum|--amplitudes|30deg,60deg|--order|3", "--figure");
    let curve = series.curves(0, SECOND).concat();
    let law = |degrees: f64| 1.0 - degrees.to_radians().powi(2) / 16.0;
    assert!(
        !curve.is_empty()
            && curve.iter().all(|(frequency, degrees)| (frequency - law(*degrees)).abs() < 1e-3)
    );
}

#[test]
fn a_motion_in_time_with_its_events() {
    let drawing = drawn("simulate|x''=-x|--initial|x=1|--times|0:10:1|--events|turning", "--figure");
    let curve = drawing.curves(0, FIRST).concat();
    assert!(curve.len() > 1000 && curve.iter().all(|(t, x)| (x - t.cos()).abs() < 0.02));
    let turns = drawing.markers(0, FIRST);
    assert!(turns.len() >= 3);
    assert!(
        turns.iter().all(|(t, x)| (t / PI - (t / PI).round()).abs() < 0.01 && (x.abs() - 1.0).abs() < 0.01)
    );
}

#[test]
fn formulas_in_time_below_the_coordinates() {
    let columns = "energy = x'^2/2 + x^2/2, 3*x*x', ln(x)";
    let drawing =
        drawn(&format!("simulate|x''=-x|--initial|x=1|--times|0:10:5|--columns|{columns}"), "--figure");
    assert_eq!(drawing.panels.len(), 4);
    let formulas: [fn(f64) -> f64; 4] = [f64::cos, |_| 0.5, |t| -1.5 * (2.0 * t).sin(), |t| t.cos().ln()];
    for (panel, formula) in formulas.into_iter().enumerate() {
        let curve = drawing.curves(panel, FIRST).concat();
        let (_, y) = drawing.panels[panel].resolution();
        assert!(curve.len() > 1000 || panel == 1, "{panel}: {}", curve.len());
        let shown = curve.iter().filter(|(t, _)| panel < 3 || t.cos() > 0.1);
        shown.for_each(|(t, value)| close(*value, formula(*t), 3.0 * y + 0.02));
    }
    let animated = drawn(
        &format!("simulate|x''=-x|--initial|x=1|--times|0,1|--animate|--columns|{columns}"),
        "--figure",
    );
    assert_eq!(animated.panels.len(), 4);
}

#[test]
fn each_motion_of_a_table_has_its_curve() {
    let file = directory("data-each-table").join("starts.csv");
    fs::write(&file, "x,k\n1,1\n2,1\n1,4\n").unwrap();
    let question =
        format!("simulate|x''=-k*x|--each|{}|--times|0:5:5|--until|x=-1/2|--columns|v=x'", file.display());
    let drawing = drawn(&question, "--figure");
    assert_eq!(drawing.panels.len(), 2);
    let motions = [
        (FIRST, 1.0, 1.0, 2.0 * PI / 3.0),
        (SECOND, 2.0, 1.0, 1.8234765819369753),
        (THIRD, 1.0, 2.0, PI / 3.0),
    ];
    for (colour, start, frequency, end) in motions {
        let curves = [0, 1].map(|panel| drawing.curves(panel, colour).concat());
        for (t, x) in &curves[0] {
            close(*x, start * (frequency * t).cos(), 0.02);
        }
        for (t, v) in &curves[1] {
            close(*v, -start * frequency * (frequency * t).sin(), 0.03);
        }
        let last = curves[0].iter().map(|point| point.0).fold(0.0, f64::max);
        close(last, end, 0.01);
        same_points(&drawing, 0, drawing.markers(0, colour), vec![(end, -0.5)]);
    }
    let plane = drawn(&format!("{question}|--axes|x,x'"), "--figure");
    for (x, v) in plane.curves(0, SECOND).concat() {
        close(x.hypot(v), 2.0, 0.02);
    }
}

/// The parameters in the picture; no-break spaces become spaces.
fn parameters(drawing: &Drawing) -> String {
    drawing.of_class("parameters").join(" ").replace('\u{a0}', " ")
}

/// The angle of a rod from the downward vertical.
fn angle(rod: &[Place]) -> f64 {
    (rod[1].0 - rod[0].0).atan2(rod[1].1 - rod[0].1)
}

#[test]
fn a_pendulum_swings_beside_its_curve() {
    let drawing = drawn("motion|150deg|--times|0:10:5|--animate", "--figure");
    close(drawing.seconds, 10.0, 0.0);
    let [rod, axle, body, dot] = &drawing.moving[..] else { panic!("{} shapes move", drawing.moving.len()) };
    assert_eq!([rod, body, dot].map(Vec::len), [301; 3]);
    assert!(axle.iter().all(|at| *at == axle[0]));
    let start = libration::quantity::Angle::from_degrees(150.0).unwrap();
    let motion = libration::pendulum::Pendulum::new(1.0, 9.80665).unwrap().released_from(start).unwrap();
    for frame in 0..=300 {
        let time = f64::from(u32::try_from(frame).unwrap()) / 30.0;
        let expected = motion.state_at(time).angle;
        close(angle(&rod[frame]), expected, 2e-4);
        assert_eq!(body[frame][0], rod[frame][1]);
        let (t, degrees) = drawing.panels[0].data_at(dot[frame][0]);
        let (x, y) = drawing.panels[0].resolution();
        close(t, time, 3.0 * x);
        close(degrees, expected.to_degrees(), 3.0 * y);
    }
    let inside =
        |(x, y): &Place| (0.0..drawing.panels[0].left).contains(x) && (0.0..drawing.height).contains(y);
    assert!(rod.iter().flatten().all(inside));
}

/// In a column of a journal the axes take the whole width.
#[test]
fn a_pendulum_swings_above_its_curve_where_there_is_no_room_beside_it() {
    let drawing = drawn("motion|150deg|--times|0:10:5|--animate|--size|column", "--figure");
    let [rod, .., dot] = &drawing.moving[..] else { panic!("{} shapes move", drawing.moving.len()) };
    let axes = &drawing.panels[0];
    let above = |(x, y): &Place| (0.0..drawing.width).contains(x) && (0.0..axes.top).contains(y);
    assert!(rod.iter().flatten().all(above), "{:?} {}", rod[0], axes.top);
    assert!(axes.width > 0.6 * drawing.width, "{} of {}", axes.width, drawing.width);
    let (_, degrees) = axes.data_at(dot[0][0]);
    close(degrees, 150.0, 3.0 * axes.resolution().1);
    // Moving parts do not cover text.
    let highest = rod.iter().flatten().map(|point| point.1).fold(f64::INFINITY, f64::min);
    let words = drawing.texts.iter().filter(|text| ["title", "parameters"].contains(&text.class.as_str()));
    assert!(words.map(|text| text.extent()[3]).all(|bottom| bottom < highest));
}

#[test]
fn bodies_move_as_the_system_has_them_and_long_motions_run_faster() {
    let drawing = drawn(
        "simulate|double_pendulum|--set|l2=1/2|--initial|theta1=40deg|--times|0:50:1|--animate",
        "--figure",
    );
    close(drawing.seconds, 25.0, 0.0);
    assert!(parameters(&drawing).contains("shown 2 times as fast"));
    let [upper, lower] = [0, 1].map(|rod| &drawing.moving[rod]);
    let length = |rod: &[Place]| (rod[1].0 - rod[0].0).hypot(rod[1].1 - rod[0].1);
    for (upper, lower) in upper.iter().zip(lower) {
        assert_eq!(upper[1], lower[0]);
        close(length(upper) / length(lower), 2.0, 1e-3);
    }
    close(angle(&upper[0]).to_degrees(), 40.0, 0.02);
    let rails = drawn("simulate|x''=-x|--initial|x=1|--times|0:0.5:0.5|--animate", "--figure");
    close(rails.seconds, 1.0, 0.0);
    assert!(parameters(&rails).contains("shown 2 times as slowly"));
    let [_, body, dot] = &rails.moving[..] else { panic!("{} shapes move", rails.moving.len()) };
    let ends = |places: &[Vec<Place>]| [places[0][0], places[places.len() - 1][0]];
    let [[from, _], [to, _]] = ends(body).map(|(x, y)| [x, y]);
    assert!(
        from > to && body.windows(2).all(|pair| pair[1][0].0 <= pair[0][0].0),
        "x falls from 1 to cos 0.5"
    );
    let (x, y) = rails.panels[0].resolution();
    let last = rails.panels[0].data_at(ends(dot)[1]);
    close(last.0, 0.5, 3.0 * x);
    close(last.1, 0.5_f64.cos(), 3.0 * y);
}

#[test]
fn what_cannot_move_is_refused() {
    for (question, reason) in [
        ("motion 60deg --animate --figure a.png", "cannot be animated: give a file name ending in .svg"),
        ("motion 60deg --animate", "--figure"),
        ("simulate pendulum --times 0:1:1 --animate --axes theta,theta' --figure a.svg", "--axes"),
    ] {
        let output = crate::command::libration(question);
        let message = crate::command::message(&output);
        assert!(output.status.code() == Some(2) && message.contains(reason), "{question}: {message}");
    }
}

#[test]
fn a_motion_in_the_phase_plane() {
    let drawing = drawn("simulate|x''=-4*x|--initial|x=1|--times|0:10:1|--axes|x,x'", "--figure");
    let curve = drawing.curves(0, FIRST).concat();
    let (x, y) = drawing.panels[0].resolution();
    assert!(
        curve.len() > 1000
            && curve.iter().all(|(at, speed)| (at.hypot(0.5 * speed) - 1.0).abs() < 2.0 * (x + y))
    );
    same_points(&drawing, 0, drawing.markers(0, BLACK), vec![(1.0, 0.0)]);
}

#[test]
fn shapes_of_the_modes() {
    let drawing = drawn("modes|x''=y-2*x; y''=x-2*y", "--figure");
    same_points(&drawing, 0, drawing.markers(0, FIRST), vec![(1.0, 1.0), (2.0, 1.0)]);
    let second = drawing.markers(0, SECOND);
    close(second[0].1 * second[1].1, -1.0, 0.01);
}

#[test]
fn points_of_a_section() {
    // y has half the frequency of x, so that its sign alternates from one crossing to the next.
    let question = "section|x''=-x; y''=-y/4|--at|x|--initial|x=0,x'=1,y=0.5|--points|6|--skip|1";
    let drawing = drawn(question, "--figure");
    let markers = drawing.markers(0, FIRST);
    assert_eq!(markers.len(), 6);
    let (x, _) = drawing.panels[0].resolution();
    for (index, marker) in markers.iter().enumerate() {
        close(marker.0.abs(), 0.5, 3.0 * x);
        // The velocity vanishes within the integration tolerance.
        close(marker.1, 0.0, 1e-9);
        assert!(index == 0 || marker.0 * markers[index - 1].0 < 0.0);
    }
}

#[test]
fn an_orbit_in_time_and_in_its_plane() {
    // x = 1.8·cos(2t/3) is the response of the undamped oscillator.
    let question = "orbit|x'' = -x + cos(2t/3)|--initial|x=1";
    let drawing = drawn(question, "--figure");
    let in_time = drawing.curves(0, FIRST).concat();
    for (time, x) in &in_time {
        close(*x, 1.8 * (2.0 * time / 3.0).cos(), 0.02);
    }
    close(in_time.last().unwrap().0, 3.0 * PI, 0.02);
    for (x, velocity) in drawing.curves(1, FIRST).concat() {
        close((x / 1.8).powi(2) + (velocity / 1.2).powi(2), 1.0, 0.02);
    }
}

#[test]
fn amplitudes_of_modes_in_time() {
    // x″ + x = −xy, y″ + 4y = −x²/2: to second order |a|² + 4|b|² is conserved.
    let drawing = drawn("resonance|x''=-x-x*y;y''=-4*y-x^2/2|--order|2|--initial|x=0.05,y=0.01", "--figure");
    let (slow, fast) = (drawing.curves(0, FIRST).concat(), drawing.curves(0, SECOND).concat());
    for ((_, a), (_, b)) in slow.iter().zip(&fast) {
        close(a * a + 4.0 * b * b, 0.05 * 0.05 + 4.0 * 0.01 * 0.01, 0.0001);
    }
    for (time, a) in drawing.markers(0, FIRST) {
        close(a, drawing.value_at(0, FIRST, time), 0.002);
    }
}

#[test]
fn a_melnikov_function_and_resonances() {
    // M(φ) = −8c + 2πA sech(πΩ/2)·cos φ, and ω0/2√e·π/K is half the drive frequency.
    let drawing = drawn("melnikov|x'' + 0.01 x' + sin(x) = 0.1 cos(t)", "--figure");
    for (phase, value) in drawing.curves(0, FIRST).concat() {
        close(value, -0.08 + TAU * 0.1 / FRAC_PI_2.cosh() * phase.to_radians().cos(), 0.005);
    }
    let marked = drawing.markers(1, SECOND);
    assert!(marked.iter().any(|(_, frequency)| (frequency - 1.0).abs() < 0.01), "{marked:?}");
    for (speed, frequency) in drawing.curves(1, FIRST).concat() {
        if speed.abs() < 1.9 {
            close(frequency, period_ratio(2.0 * (0.5 * speed).asin()).recip(), 0.01);
        }
    }
}

#[test]
fn a_spectrum_of_measured_swings() {
    let question = "inspect|examples/swing_synthetic.csv|--spectrum";
    let drawing = drawn(&question.replace("examples", EXAMPLES), "--figure");
    let answer = json(&format!("inspect {EXAMPLES}/swing_synthetic.csv --spectrum"));
    let trace = &answer["traces"][0];
    let value = |value: &serde_json::Value| value.as_f64().unwrap();
    // The third harmonic: of the pendulum, as measured, and the line between both.
    let third = &trace["harmonics"][3];
    let frequency = 3.0 * value(&trace["frequency_hz"]);
    for (colour, name) in [(SECOND, "theory"), (BLACK, "amplitude")] {
        let expected = value(&third[name]).to_degrees().abs();
        let markers = drawing.markers(0, colour);
        let marker = markers.iter().find(|(x, _)| (x - frequency).abs() < 0.01).unwrap();
        close(marker.1 / expected, 1.0, 0.02);
    }
    let height = |(x, y): &Place| if (x - frequency).abs() < 0.05 { *y } else { 0.0 };
    let line = drawing.curves(0, FIRST).concat().iter().map(height).fold(0.0, f64::max);
    close(line / value(&third["amplitude"]).to_degrees(), 1.0, 0.1);
}

/// The largest distance of a curve's points from the chord between their neighbours, relative to the extent of the curve.
fn farthest_from_chords(curve: &[Place]) -> f64 {
    let extent = |of: fn(&Place) -> f64| {
        let (low, high) = curve
            .iter()
            .map(of)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        high - low
    };
    let (width, height) = (extent(|point| point.0), extent(|point| point.1));
    let far = |three: &[Place]| {
        let along = |from: usize, to: usize| {
            ((three[to].0 - three[from].0) / width, (three[to].1 - three[from].1) / height)
        };
        let ((x, y), (u, v)) = (along(0, 2), along(0, 1));
        (x * v - y * u).abs() / x.hypot(y)
    };
    curve.windows(3).map(far).fold(0.0, f64::max)
}

/// The orbit jumps within a fiftieth of its period.
#[test]
fn an_orbit_with_jumps_has_no_corners() {
    let drawing = drawn("orbit|x'' = 8 (1 - x^2) x' - x|--initial|x=0.5", "--figure");
    let far = farthest_from_chords(&drawing.curves(1, FIRST).concat());
    assert!(far < 3e-3, "{far}");
}

#[test]
fn titles_and_legends_name_what_is_drawn() {
    let has = |question: &str, text: &str| {
        let drawing = drawn(question, "--figure");
        drawing.texts.iter().any(|label| label.content.contains(text))
    };
    assert!(has("simulate|lorenz|--initial|x=1,y=1,z=1|--times|0:2:0.1", "Motion of Lorenz's"));
    let lengths = format!("fit|lengths|{EXAMPLES}/lengths_synthetic.csv|--amplitude|10deg");
    assert!(
        has(&lengths, "(L + δ)/g") && has(&format!("{lengths}|--bob-radius|25mm"), "(L + δ + κ/(L + δ))/g")
    );
}

#[test]
fn a_response_of_a_linear_oscillator() {
    // The response of x″ + x′/2 + x = cos ωt has the amplitude 1/√((1 − ω²)² + ω²/4).
    let drawing = drawn("response|x'' = -x - x'/2 + cos(w*t)|--over|w=0.5:2", "--figure");
    let curve = drawing.curves(0, FIRST).concat();
    assert!(curve.len() > 10, "{} points", curve.len());
    let exact = |w: f64| 1.0 / (1.0 - w * w).hypot(0.5 * w);
    for (w, amplitude) in curve {
        close(amplitude, exact(w), 0.02);
    }
    // Sweeps follow the curve in both directions.
    for colour in [BLACK, ORANGE] {
        let dots = drawing.markers(0, colour);
        assert_eq!(dots.len(), 48);
        dots.into_iter().for_each(|(w, amplitude)| close(amplitude, exact(w), 0.01));
    }
}

#[test]
fn edges_of_stability_of_mathieus_equation() {
    // Without damping the first tongue opens as w = 2(1 ± a), with the amplitude a of the pivot.
    let drawing = drawn("stability|kapitza|--map|omega=1.9:2.1,a=0:0.04|--lines|0", "--figure");
    let edges = drawing.curves(0, FIRST).concat();
    assert!(edges.len() > 10, "{} points", edges.len());
    for (omega, a) in edges {
        close((omega / 2.0 - 1.0).abs(), a, 0.004);
    }
}

/// An oscillator that is not coupled gains energy up to d = 0.33, where the tongue of Mathieu's equation does not bound stability.
#[test]
fn parts_of_curves_that_bound_stability_have_their_own_look() {
    let system = "stability|x''+0.05*x'+(d+e*cos(t))*x=0;y''+(d-0.33)*y'+2*y=0|--lines|0|--map|";
    let drawing = drawn(&format!("{system}d=0.25:0.6,e=0.1:0.4"), "--figure");
    let [boundary, unstable] = [FIRST, THIRD].map(|colour| drawing.curves(0, colour));
    assert_eq!([boundary.len(), unstable.len()], [1, 1]);
    assert!(boundary[0].iter().all(|(d, _)| *d > 0.33) && unstable[0].iter().any(|(d, _)| *d < 0.3));
    let is_joint = |point: &&Place| unstable[0].contains(point);
    assert_eq!(boundary[0].iter().filter(is_joint).count(), 1);
    let entry = |drawing: &Drawing| drawing.of_class("name").contains(&"stable equilibrium");
    assert!(entry(&drawing));
    assert!(!entry(&drawn(&format!("{system}d=0.25:0.3,e=0.1:0.4"), "--figure")));
}

#[test]
fn points_of_a_bifurcation_diagram() {
    // x″ + x′ + x = A cos t tends to x = A sin t, whose velocity is A at each period of the drive.
    let question =
        "bifurcation|x'' + x' + x = A cos(t)|--over|A=1:3:1|--initial|x=0|--axis|x'|--points|2|--skip|20";
    let drawing = drawn(question, "--figure");
    let expected = [1.0, 1.0, 2.0, 2.0, 3.0, 3.0].map(|a| (a, a)).to_vec();
    same_points(&drawing, 0, drawing.markers(0, FIRST), expected);
}

#[test]
fn convergence_of_an_exponent() {
    let question =
        "lyapunov driven_pendulum --set A=1.5,c=1/2 --initial theta=0.2 --intervals 30 --transient 1";
    let drawing = drawn(&question.replace(' ', "|"), "--figure");
    let expected: Vec<Place> =
        numbers(&text(&format!("{question} --csv"))).iter().map(|row| (row[0], row[1])).collect();
    let curve = drawing.curves(0, FIRST).concat();
    assert_eq!(curve.len(), expected.len());
    for (drawn, expected) in curve.iter().zip(expected) {
        close(drawn.0 / expected.0, 1.0, 1e-3);
        close(drawn.1, expected.1, 5e-3);
    }
}

/// The rows of an example, and the JSON of a fit to it.
fn rows_of(name: &str) -> Vec<Vec<f64>> {
    numbers(&fs::read_to_string(format!("{EXAMPLES}/{name}_synthetic.csv")).unwrap())
}

#[test]
fn measured_periods_and_their_law() {
    let file = format!("{EXAMPLES}/period_table_synthetic.csv");
    let drawing = drawn(&format!("fit|periods|{file}"), "--figure");
    let measured: Vec<Place> =
        rows_of("period_table").iter().map(|row| (row[0].abs().to_degrees(), row[1])).collect();
    same_points(&drawing, 0, drawing.markers(0, FIRST), measured.clone());
    let t0 = json(&format!("fit periods {file}"))["laws"][0]["t0_s"].as_f64().unwrap();
    let law = |degrees: f64| t0 * period_ratio(degrees.to_radians());
    let curve = drawing.curves(0, LAW).concat();
    assert!(curve.iter().all(|(degrees, period)| (period - law(*degrees)).abs() < 2e-3), "{:?}", &curve[..3]);
    let residuals = drawing.markers(1, FIRST);
    for (degrees, residual) in residuals {
        let near = |row: &&Place| (row.0 - degrees).abs() < 0.02;
        let is_one = measured.iter().filter(near).any(|row| (row.1 - law(row.0) - residual).abs() < 2e-3);
        assert!(is_one, "{degrees}° {residual} s");
    }
}

#[test]
fn measured_lengths_and_their_line() {
    let drawing = drawn(&format!("fit|lengths|{EXAMPLES}/lengths_synthetic.csv"), "--figure");
    let measured = rows_of("lengths").iter().map(|row| (row[0], row[1] * row[1])).collect();
    same_points(&drawing, 0, drawing.markers(0, FIRST), measured);
    let line = drawing.curves(0, LAW).concat();
    let slope =
        (line[line.len() - 1].1 - line[line.len() / 2].1) / (line[line.len() - 1].0 - line[line.len() / 2].0);
    // 4π²/g of the simulated pendulums, with the period at 10° in place of that of small swings.
    close(slope / (TAU * TAU / 9.81), period_ratio(10_f64.to_radians()).powi(2), 0.01);
}

#[test]
fn periods_of_a_photogate() {
    let question = format!("fit gates {EXAMPLES}/gate_synthetic.csv --length 0.958m --diameter 25mm");
    let drawing = drawn(&question.replace(' ', "|"), "--figure");
    let cycles = numbers(&text(&format!("{question} --csv")));
    let of_side = |side: f64| {
        cycles.iter().filter(|row| (row[2] - side).abs() < 0.5).map(|row| (row[0], row[1])).collect()
    };
    same_points(&drawing, 0, drawing.markers(0, FIRST), of_side(0.0));
    same_points(&drawing, 0, drawing.markers(0, SECOND), of_side(1.0));
    let against_amplitude = cycles.iter().map(|row| (row[3].to_degrees(), row[1])).collect();
    same_points(&drawing, 1, drawing.markers(1, FIRST), against_amplitude);
}

#[test]
fn a_measured_swing_and_its_fit() {
    let drawing = drawn(&format!("fit|trace|{EXAMPLES}/swing_synthetic.csv|--model|linear"), "--figure");
    let measured = rows_of("swing").iter().map(|row| (row[0], row[1])).collect();
    same_points(&drawing, 0, drawing.markers(0, FIRST), measured);
    // The example was simulated with a release at 60° and errors of 0.3°.
    let curve = drawing.curves(0, LAW).concat();
    let first = curve.iter().min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
    close(first.1, 60.0 + 1.22, 0.3);
}

#[test]
fn traces_of_one_picture_are_named() {
    let folder = directory("data-two-traces");
    let rows = rows_of("swing");
    let file = |name: &str, first: usize| {
        let lines = rows[first..first + 300].iter().map(|row| format!("{},{}\n", row[0], row[1]));
        let path = folder.join(name);
        fs::write(&path, format!("t (s),theta (deg)\n{}", lines.collect::<String>())).unwrap();
        path.display().to_string()
    };
    let (early, late) = (file("early.csv", 0), file("late.csv", 600));
    let drawing = drawn(&format!("fit|trace|{early}|{late}|--model|linear"), "--figure");
    let across: Vec<&str> = drawing.texts.iter().map(|text| text.content.as_str()).collect();
    for name in ["early.csv", "late.csv"] {
        assert_eq!(across.iter().filter(|text| text.contains(name)).count(), 1, "{across:?}");
    }
}

/// The nome of the modulus sin(θ0/2), by the arithmetic-geometric mean.
fn nome(amplitude: f64) -> f64 {
    (-PI * period_ratio(PI - amplitude) / period_ratio(amplitude)).exp()
}

/// The peaks of the spectrum of a swing are its harmonics 8√qⁿ/(n(1 + qⁿ)) at nΩ.
#[test]
fn the_spectrum_of_a_swing_has_its_harmonics() {
    let drawing = figure(
        "trajectories|pendulum|--initial|theta=60deg|--initial|theta=170deg|--to|200|--spectrum|theta",
    );
    for (colour, degrees) in [(FIRST, 60.0_f64), (SECOND, 170.0)] {
        let amplitude = degrees.to_radians();
        let (q, frequency) = (nome(amplitude), period_ratio(amplitude).recip());
        let points: Vec<Place> = drawing.curves(0, colour).concat();
        for n in [1.0, 3.0, 5.0] {
            let expected = 8.0 * q.powf(0.5 * n) / (n * (1.0 + q.powf(n)));
            let near = points.iter().filter(|point| (point.0 - n * frequency).abs() < 0.4 * frequency);
            let peak = near.copied().fold((0.0, 0.0), |a: Place, b| if b.1 > a.1 { b } else { a });
            close(peak.0, n * frequency, 0.02);
            // Two pixels in five hundred are a fifteenth of a decade if the axis has nine; linear interpolation loses 0.4 %.
            close(peak.1 / expected, 1.0, 0.02);
        }
    }
}

#[test]
fn motions_from_several_starts_are_those_of_each() {
    let drawing = figure("trajectories|pendulum|--initial|theta=30deg|--initial|theta=150deg|--to|20");
    for (colour, degrees) in [(FIRST, 30.0_f64), (SECOND, 150.0)] {
        let amplitude = degrees.to_radians();
        let points: Vec<Place> = drawing.curves(0, colour).concat();
        let (low, high) = points.iter().fold((0.0_f64, 0.0_f64), |(a, b), p| (a.min(p.1), b.max(p.1)));
        close(low, -amplitude / PI, 3e-3);
        close(high, amplitude / PI, 3e-3);
        // A quarter of the period after the start the pendulum passes the bottom.
        let quarter = FRAC_PI_2 * period_ratio(amplitude);
        let after =
            points.iter().filter(|point| point.1 < 0.0).map(|point| point.0).fold(f64::INFINITY, f64::min);
        close(after, quarter, 0.1);
    }
}

#[test]
fn each_value_of_a_parameter_has_its_motion() {
    let question =
        "figure trajectories damped_pendulum --over c=0,0.5 --initial theta=0.1 --from 10 --to 30 --output";
    let file = directory("data-over").join("figure.svg").display().to_string();
    let answer = json(&format!("{question} {file}"));
    let series = answer["series"].as_array().unwrap();
    let labels: Vec<_> = series.iter().map(|curve| curve["label"].as_str().unwrap()).collect();
    assert_eq!(labels, ["c = 0", "c = 0.5"]);
    for (series, damping) in series.iter().zip([0.0, 0.5_f64]) {
        let points = series["points"].as_array().unwrap();
        let first = points[0][0].as_f64().unwrap();
        close(first, 10.0, 1e-12);
        // At 0.1 rad the force is linear to within 1/600.
        let (rate, frequency) = (0.5 * damping, (1.0 - 0.25 * damping * damping).sqrt());
        let linear = |t: f64| {
            0.1 * (-rate * t).exp() * ((frequency * t).cos() + rate / frequency * (frequency * t).sin())
        };
        for point in points.iter().step_by(500) {
            close(point[1].as_f64().unwrap(), linear(point[0].as_f64().unwrap()), 0.002);
        }
    }
}

/// Bars that leave a panel are cut at its frame.
#[test]
fn no_error_bar_of_a_fit_is_cut_by_the_frame() {
    for fit in [
        "fit|gates|FOLDER/acceleration_synthetic.csv|--signal|3|--amplitude|0.35",
        "fit|gates|FOLDER/gate_synthetic.csv|--length|0.958m|--diameter|25mm",
        "fit|lengths|FOLDER/lengths_synthetic.csv",
        "fit|lengths|FOLDER/bar_synthetic.csv",
        "fit|periods|FOLDER/period_table_synthetic.csv",
        "fit|amplitudes|FOLDER/amplitudes_synthetic.csv",
        "fit|response|FOLDER/response_synthetic.csv",
    ] {
        let drawing = drawn(&fit.replace("FOLDER", EXAMPLES), "--figure");
        let mut bars = 0;
        for (number, panel) in drawing.panels.iter().enumerate() {
            let inside = panel.top + 1e-3..panel.top + panel.height - 1e-3;
            for (_, y) in drawing.bars(number) {
                assert!(inside.contains(y), "{fit}: {y} in {inside:?}");
                bars += 1;
            }
        }
        assert!(bars > 0, "{fit}");
    }
}
