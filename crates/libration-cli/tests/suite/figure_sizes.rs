//! Every accepted size gives a correct picture, and the file has the requested size.

use crate::command::{directory, libration, message, text};
use crate::drawing::Drawing;
use libration_testing::sweep;
use std::fs;

const PICTURES: [&str; 12] = [
    "errors",
    "errors --formulas small_angle,bernoulli,power_series_2,power_series_3,denman,black_vel_2,black_vel_3,molina,\
     kidd_fogg,butikov,carvalhaes_suppes,belendez,cubic_force,ganley_parwani,lima_arun,cromer,two_term_log,lima_2008,\
     chachiyo,agm_a1,agm_a3,agm_a4,agm_a5,agm_b2,nome_one_root,describing_function,sin2_series_1,sin2_series_2,\
     sin2_series_3,sin2_series_4 --from 170deg",
    "errors --formulas bernoulli --from 10.00001deg --to 10.00002deg",
    "motion",
    "phase",
    "spectrum",
    "series pendulum",
    "series duffing --amplitudes 0.5,0.9,1.1",
    "series van_der_pol --quantity frequency",
    "trajectories damped_pendulum --over c=0.05,0.2,2 --initial theta=170deg --to 40s",
    "trajectories double_pendulum --initial theta1=10deg --initial theta1=120deg,theta2=-30deg --to 20 --axes theta1,theta2",
    "trajectories pendulum --initial theta=60deg --initial theta=170deg --to 100s --spectrum theta",
];

/// The smallest accepted side, from the message that rejects a smaller one.
fn smallest(picture: &str, side: &str, file: &str) -> u32 {
    let output = libration(&format!("figure {picture} {side} 1 --output {file}"));
    assert_eq!(output.status.code(), Some(1), "{picture}: {}", message(&output));
    let message = message(&output);
    let named = message.trim().rsplit(' ').next().and_then(|word| word.parse().ok());
    named.unwrap_or_else(|| panic!("{picture}: no size in: {message}"))
}

/// Every sixth picture by default, and the one with the most names.
#[test]
fn the_smallest_size_accepted_holds_the_whole_picture_and_one_less_is_refused_in_a_sweep() {
    let most_names = |(_, picture): &(usize, &&str)| picture.contains("lima_2008");
    for (number, picture) in sweep::part_and(PICTURES.iter().enumerate(), 6, most_names) {
        let file = directory(&format!("smallest-{number}")).join("figure.svg").display().to_string();
        let width = smallest(picture, "--width", &file);
        // Text is broken into more lines in a narrower picture.
        let height = smallest(picture, &format!("--width {width} --height"), &file);
        text(&format!("figure {picture} --width {width} --height {height} --output {file}"));
        let drawing = Drawing::read(&fs::read_to_string(&file).unwrap());
        let is_as_asked = drawing.width.total_cmp(&f64::from(width)).is_eq()
            && drawing.height.total_cmp(&f64::from(height)).is_eq();
        assert!(is_as_asked, "{picture} is {} × {}", drawing.width, drawing.height);
        is_right(picture, &drawing);
        fs::remove_file(&file).unwrap();
        for (w, h) in [(width - 1, height), (width, height - 1)] {
            let output = libration(&format!("figure {picture} --width {w} --height {h} --output {file}"));
            assert_eq!(output.status.code(), Some(1), "{picture} as {w} × {h}");
            assert!(!fs::exists(&file).unwrap(), "{picture} as {w} × {h}");
        }
    }
}

/// A column of a journal, a slide and the largest canvas hold every picture.
#[test]
fn columns_slides_and_posters_hold_every_picture_in_a_sweep() {
    let file = directory("formats").join("figure.svg").display().to_string();
    let sizes = [("--size column", 302.36), ("--size slide", 1280.0), ("--width 4000 --height 4000", 4000.0)];
    let all = PICTURES.iter().flat_map(|picture| sizes.map(|(size, width)| (picture, size, width)));
    // Thirty names exceed the height of a slide, two tick labels of eight digits the width of a column.
    let is_held = |(picture, size, _): &(&&str, &str, f64)| {
        let is_too_high = size.ends_with("slide") && picture.contains("lima_2008");
        let is_too_wide = size.ends_with("column") && picture.contains("10.00001deg");
        !is_too_high && !is_too_wide
    };
    // Four cases further is another picture in another size.
    for (picture, size, width) in sweep::part(all.filter(is_held), 4) {
        text(&format!("figure {picture} {size} --output {file}"));
        let drawing = Drawing::read(&fs::read_to_string(&file).unwrap());
        assert!((drawing.width - width).abs() < 0.01, "{picture} {size}: {}", drawing.width);
        is_right(&format!("{picture} {size}"), &drawing);
    }
}

/// Asserts that everything lies on the canvas, that the axes have a size and run to the right and upwards, and that labels do not touch.
fn is_right(name: &str, drawing: &Drawing) {
    let (width, height) = (drawing.width, drawing.height);
    for panel in &drawing.panels {
        assert!(panel.width >= 50.0 && panel.height >= 50.0, "{name}: {panel:?}");
        assert!(panel.x.slope > 0.0 && panel.y.slope < 0.0, "{name}: {panel:?}");
        assert!(panel.left >= 0.0 && panel.left + panel.width <= width, "{name}: {panel:?}");
        assert!(panel.top >= 0.0 && panel.top + panel.height <= height, "{name}: {panel:?}");
    }
    for (number, text) in drawing.texts.iter().enumerate() {
        let [left, top, right, bottom] = text.extent();
        let is_inside = left >= 0.0 && top >= 0.0 && right <= width && bottom <= height;
        assert!(is_inside, "{name}: {text:?} at {:?} on {width} × {height}", text.extent());
        for other in &drawing.texts[..number] {
            let [l, t, r, b] = other.extent();
            // Lines of text may touch, letters may not.
            let apart = r <= left || right <= l || b <= top + 3.0 || bottom <= t + 3.0;
            assert!(apart, "{name}: {text:?} is over {other:?}");
        }
        for panel in &drawing.panels {
            let (x, y) = (panel.left, panel.top);
            let beside = right <= x || x + panel.width <= left;
            let apart = beside || bottom <= y || y + panel.height <= top;
            assert!(apart, "{name}: {text:?} hides data");
        }
        // Text is printed at 12 points at least, and at 20 points on a slide.
        assert!(text.size >= 16.0, "{name}: {text:?}");
    }
    for shape in &drawing.shapes {
        let is_inside = |&(x, y): &(f64, f64)| (0.0..=width).contains(&x) && (0.0..=height).contains(&y);
        assert!(shape.points.iter().all(is_inside), "{name}: {shape:?} on {width} × {height}");
    }
}

#[test]
fn pictures_of_the_usual_size_hold_whatever_they_show() {
    for (number, picture) in PICTURES.iter().enumerate() {
        let file = directory(&format!("usual-{number}")).join("figure.svg").display().to_string();
        text(&format!("figure {picture} --output {file}"));
        let drawing = Drawing::read(&fs::read_to_string(&file).unwrap());
        assert!(drawing.width >= 642.0 && drawing.height >= 420.0, "{picture}");
        is_right(picture, &drawing);
    }
}

#[test]
fn pictures_of_other_commands_hold_what_they_show_in_a_sweep() {
    let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let questions = [
        "motion 90deg --compare small-angle,fourier-3,fourier-5,fourier-7".to_owned(),
        "motion 1e-7deg".to_owned(),
        "decay 60deg --linear 0.1 --order 3".to_owned(),
        "backbone pendulum --amplitudes 10deg:170deg:20deg".to_owned(),
        "simulate double_pendulum --initial theta1=1 --times 0:3:0.1 --events turning".to_owned(),
        "simulate spring_pendulum --initial theta=0.001 --times 0:3:0.1".to_owned(),
        "simulate pendulum --initial theta=1 --times 0:3:0.1 --columns energy=theta'^2/2-cos(theta),theta''".to_owned(),
        "modes double_pendulum".to_owned(),
        "orbit double_pendulum --initial theta1=0.1,theta2=0.141 --period 8".to_owned(),
        "resonance x''=-x-x*y;y''=-4*y-x^2/2 --order 2 --initial x=0.1,y=0.02".to_owned(),
        "melnikov driven_pendulum --set A=0.3,c=0.1,omega=1".to_owned(),
        "response driven_pendulum --set A=0.15,c=0.1 --over omega=0.7:0.95".to_owned(),
        "stability kapitza --set c=0.1 --map omega=1.5:2.5,a=0:0.2 --lines 1".to_owned(),
        "section driven_pendulum --set A=1.5,c=1/2 --initial theta=0.2 --points 20 --skip 1".to_owned(),
        "bifurcation driven_pendulum --set c=1/2 --over A=1:1.2:0.1 --initial theta=0.2 --points 3 --skip 1 --sweep both"
            .to_owned(),
        "lyapunov driven_pendulum --set A=1.5,c=1/2 --initial theta=0.2 --intervals 20 --transient 1"
            .to_owned(),
        format!("inspect {examples}/swing_synthetic.csv --spectrum"),
        format!("fit periods {examples}/period_table_synthetic.csv"),
        format!("fit amplitudes {examples}/amplitudes_synthetic.csv"),
        format!("fit lengths {examples}/bar_synthetic.csv"),
        format!("fit lengths {examples}/lengths_synthetic.csv"),
        format!("fit response {examples}/response_synthetic.csv --model pendulum"),
        format!("fit gates {examples}/gate_synthetic.csv --length 0.958m --diameter 25mm"),
        format!("fit trace {examples}/swing_synthetic.csv --model linear"),
    ];
    for (number, question) in sweep::part(questions.iter().enumerate(), 2) {
        let file = directory(&format!("other-{number}")).join("figure.svg").display().to_string();
        text(&format!("{question} --figure {file}"));
        is_right(question, &Drawing::read(&fs::read_to_string(&file).unwrap()));
    }
}

#[test]
fn sizes_that_are_none_are_not_understood() {
    for size in ["0", "-3", "nan", "inf", "wide", "4001", "2m", "1059mm"] {
        let output = libration(&format!("figure phase --width {size} --output never.svg"));
        assert_eq!(output.status.code(), Some(2), "{size}");
    }
}
