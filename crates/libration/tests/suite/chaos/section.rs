//! Poincaré sections and bifurcation diagrams.

use libration::chaos::{
    Column, Continuation, Ending, Family, PoincareSection, Points, Section, bifurcation_diagram, folded,
    section,
};
use libration::taylor::{Cause, Effort, Moment};
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

const FLASH: Section = Section::Stroboscope { period: None, phase: 0.0 };

fn from(state: &[f64]) -> Moment {
    Moment { time: 0.0, state: state.to_vec() }
}

fn points_of(equation: &str, state: &[f64], cut: &Section, skipped: usize, kept: usize) -> PoincareSection {
    let (equation, effort) = (equation.parse().unwrap(), Effort::to_tolerance(1e-12));
    let points = Points { skipped, kept };
    section(&equation, &from(state), cut, points, &effort, |_| ControlFlow::Continue(())).unwrap()
}

fn diagram(equation: &str, values: &[f64], state: &[f64], how: Continuation, points: Points) -> Vec<Column> {
    let equation = equation.parse().unwrap();
    let family = Family { equation: &equation, parameter: "A", section: &FLASH, points };
    let effort = Effort::to_tolerance(1e-12);
    bifurcation_diagram(&family, values, &from(state), how, &effort, |_| ControlFlow::Continue(())).unwrap()
}

#[test]
fn a_driven_linear_oscillator_is_caught_where_theory_says() {
    let (damping, omega): (f64, f64) = (0.3, 1.7);
    for phase in [0.0, 0.25, 0.7] {
        let cut = Section::Stroboscope { period: None, phase };
        let found = points_of("x'' + 0.3 x' + x = cos(1.7 t)", &[1.0, 0.0], &cut, 100, 3);
        let (stiff, slow) = (1.0 - omega * omega, damping * omega);
        let angle = TAU * phase;
        let wanted = (stiff * libm::cos(angle) + slow * libm::sin(angle)) / (stiff * stiff + slow * slow);
        for (n, point) in (100..).zip(&found.points) {
            assert!((point.state[0] - wanted).abs() < 1e-11, "{} {wanted}", point.state[0]);
            assert!((point.time - (f64::from(n) + phase) * TAU / omega).abs() < 1e-10);
        }
    }
}

#[test]
fn the_stroboscopic_map_shrinks_areas_as_the_damping_says() {
    // The determinant of the map over one period is e^(−cT).
    let image = |x: f64, v: f64| {
        let equation = "theta'' + theta'/2 + sin(theta) = 1.5 cos(2t/3)";
        points_of(equation, &[x, v], &FLASH, 1, 1).points.remove(0).state
    };
    let h = 1e-4;
    for (x, v) in [(0.2, 0.0), (-1.3, 2.1), (3.0, -0.4)] {
        let slope = |(dx, dv): (f64, f64)| {
            let [ahead, behind] = [image(x + dx, v + dv), image(x - dx, v - dv)];
            [0, 1].map(|n| (ahead[n] - behind[n]) / (2.0 * h))
        };
        let ([a, c], [b, d]) = (slope((h, 0.0)), slope((0.0, h)));
        let wanted = libm::exp(-1.5 * PI);
        assert!(((a * d - b * c) / wanted - 1.0).abs() < 1e-3, "{}", a * d - b * c);
    }
}

/// How many different points there are, angles folded.
fn different(section: &PoincareSection) -> usize {
    let mut angles: Vec<f64> = section.points.iter().map(|point| folded(point.state[0])).collect();
    angles.sort_by(f64::total_cmp);
    1 + angles.windows(2).filter(|pair| pair[1] - pair[0] > 1e-4).count()
}

#[test]
fn the_driven_pendulum_doubles_its_period_on_the_way_to_chaos() {
    let points = Points { skipped: 400, kept: 64 };
    let values = [0.9, 1.07, 1.08, 1.15, 1.5];
    let equation = "theta'' + theta'/2 + sin(theta) = A cos(2t/3)";
    let columns = diagram(equation, &values, &[0.2, 0.0], Continuation::SameStart, points);
    let counts: Vec<usize> = columns.iter().map(|column| different(&column.section)).collect();
    assert_eq!(&counts[..2], [1, 2], "{counts:?}");
    assert!(counts[2] >= 4 && counts[3] > 40 && counts[4] > 40, "{counts:?}");
}

#[test]
fn sweeps_up_and_down_differ_where_two_motions_are_stable() {
    // Between its two jumps Duffing's oscillator keeps the motion it had.
    let equation = "x'' + 0.2 x' + x + x^3 = A cos(1.8 t)";
    let points = Points { skipped: 100, kept: 1 };
    let up: Vec<f64> = (0..=30).map(|n| 0.1 * f64::from(n)).collect();
    let down: Vec<f64> = up.iter().rev().copied().collect();
    let sweep = |values: &[f64]| diagram(equation, values, &[0.0, 0.0], Continuation::LastState, points);
    let (rising, falling) = (sweep(&up), sweep(&down));
    let distance =
        |(a, b): (&Column, &Column)| (a.section.points[0].state[0] - b.section.points[0].state[0]).abs();
    let apart: Vec<f64> = rising.iter().zip(falling.iter().rev()).map(distance).collect();
    assert!(apart[1] < 1e-6 && apart[30] < 1e-6, "{apart:?}");
    assert!(apart.iter().filter(|distance| **distance > 0.3).count() >= 3, "{apart:?}");
}

#[test]
fn each_column_from_the_same_start_is_the_section_of_its_equation() {
    let points = Points { skipped: 20, kept: 10 };
    let values = [1.0, 1.25, 1.5];
    let equation = "theta'' + theta'/2 + sin(theta) = A cos(2t/3)";
    for Column { value, section } in diagram(equation, &values, &[0.2, 0.0], Continuation::SameStart, points)
    {
        let alone = points_of(&equation.replace('A', &value.to_string()), &[0.2, 0.0], &FLASH, 20, 10);
        assert_eq!(section, alone);
    }
}

#[test]
fn interruptions_keep_what_is_done() {
    let equation = "theta'' + theta'/2 + sin(theta) = A cos(2t/3)".parse().unwrap();
    let points = Points { skipped: 5, kept: 20 };
    let family = Family { equation: &equation, parameter: "A", section: &FLASH, points };
    let stop = |limit: usize| {
        move |done: usize| if done >= limit { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let (start, effort) = (from(&[0.2, 0.0]), Effort::to_tolerance(1e-10));
    let values = [1.0, 1.1, 1.2, 1.3];
    for how in [Continuation::SameStart, Continuation::LastState] {
        let columns = bifurcation_diagram(&family, &values, &start, how, &effort, stop(2)).unwrap();
        assert_eq!(columns.iter().map(|column| column.value).collect::<Vec<_>>(), [1.0, 1.1]);
    }
    let equation = "theta'' + theta'/2 + sin(theta) = cos(2t/3)".parse().unwrap();
    let found = section(&equation, &start, &FLASH, points, &effort, stop(7)).unwrap();
    assert_eq!(found.stopped, Some(Ending::Stopped(Cause::Interrupted)));
    assert!((7..20).contains(&found.points.len()), "{}", found.points.len());
}
