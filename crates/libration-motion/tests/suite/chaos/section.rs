//! Poincaré sections and bifurcation diagrams.

use libration::chaos::{
    Continuation, DiagramColumn, Family, PoincareSection, Points, Section, SectionEnding, SectionError,
    compute_bifurcation_diagram, compute_section, compute_section_with_errors, drive_frequency, drive_period,
    folded,
};
use libration::progress::{Quiet, Status};
use libration::taylor::{Cause, Direction, Effort, Moment};
use std::cell::{Cell, RefCell};
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

const FLASH: Section = Section::Stroboscope { period: None, phase: 0.0 };

fn from(state: &[f64]) -> Moment {
    Moment { time: 0.0, state: state.to_vec() }
}

fn points_of(
    equation: &str,
    state: &[f64],
    cut: &Section,
    skipped: usize,
    recorded: usize,
) -> PoincareSection {
    let (equation, effort) = (equation.parse().unwrap(), Effort::to_tolerance(1e-12));
    let points = Points { skipped, recorded };
    compute_section(&equation, &from(state), cut, points, &effort, &Quiet).unwrap()
}

fn section_with_errors(
    equation: &str,
    state: &[f64],
    section: &Section,
    skipped: usize,
    recorded: usize,
    tolerance: f64,
) -> PoincareSection {
    let (equation, effort) = (equation.parse().unwrap(), Effort::to_tolerance(tolerance));
    let points = Points { skipped, recorded };
    compute_section_with_errors(&equation, &from(state), section, points, &effort, &Quiet).unwrap()
}

fn diagram(
    equation: &str,
    values: &[f64],
    state: &[f64],
    how: Continuation,
    points: Points,
) -> Vec<DiagramColumn> {
    let equation = equation.parse().unwrap();
    let family = Family { equation: &equation, parameter: "A", section: &FLASH, points, with_errors: false };
    let effort = Effort::to_tolerance(1e-12);
    compute_bifurcation_diagram(&family, values, &from(state), how, &effort, &Quiet).unwrap()
}

/// The points and errors against closed forms, at simple, triple and fivefold zeros of the formula and at the flashes of a drive.
#[test]
fn points_are_as_uncertain_as_their_errors_say() {
    let cosine = |time: f64| [libm::cos(time), -libm::sin(time)];
    let crossing = |n: u32| (1.5 + 2.0 * f64::from(n)) * PI;
    for formula in ["x", "x^3", "x^5", "x*(1 + x'^2)", "x + 1e-3*x^2"] {
        for tolerance in [1e-15, 1e-12, 1e-8] {
            let surface = surface(formula, Direction::Rising);
            let section = section_with_errors("x'' = -x", &[1.0, 0.0], &surface, 2, 6, tolerance);
            let errors = section.errors.unwrap();
            assert_eq!(errors.determined_until, None, "{formula}");
            for ((n, point), error) in (2..).zip(&section.points).zip(&errors.of_points) {
                assert!(
                    (point.time - crossing(n)).abs() <= error.time,
                    "{formula} {n}: {} {error:?}",
                    point.time
                );
                for ((value, exact), error) in point.state.iter().zip([0.0, 1.0]).zip(&error.state) {
                    assert!((value - exact).abs() <= *error, "{formula} {n}: {value} ± {error}");
                }
            }
            assert_eq!(errors.of_points.len(), 6, "{formula}");
        }
    }
    let flash = Section::Stroboscope { period: Some(2.5), phase: 0.4 };
    for skipped in [0, 7] {
        let section = section_with_errors("x'' = -x", &[1.0, 0.0], &flash, skipped, 40, 1e-12);
        let errors = section.errors.unwrap().of_points;
        assert_eq!(errors.len(), 40);
        for (point, error) in section.points.iter().zip(&errors) {
            for ((value, exact), error) in point.state.iter().zip(cosine(point.time)).zip(&error.state) {
                assert!((value - exact).abs() <= *error && *error < 1e-10, "{value} {exact} ± {error}");
            }
        }
    }
}

/// The same equation to 1e-15 and to 1e-9 differ by less than the errors of the second as long as it is determined; the rest has no errors.
#[test]
fn points_of_chaotic_motions_have_errors_as_long_as_they_are_determined() {
    let (equation, start) = ("x'' = -x'/4 + x - x^3 + 0.4*cos(t)", [0.3, 0.1]);
    for section in [FLASH, surface("x'", Direction::Any)] {
        let [fine, coarse] =
            [1e-16, 1e-9].map(|tolerance| section_with_errors(equation, &start, &section, 0, 200, tolerance));
        let errors = coarse.errors.unwrap();
        let until = errors.determined_until.unwrap();
        let determined = coarse.points.iter().filter(|point| point.time <= until).count();
        assert!(
            (10..150).contains(&determined) && errors.of_points.len().abs_diff(determined) <= 1,
            "{determined}"
        );
        for ((point, other), error) in coarse.points.iter().zip(&fine.points).zip(&errors.of_points) {
            for ((value, other), error) in point.state.iter().zip(&other.state).zip(&error.state) {
                assert!((value - other).abs() <= *error, "t = {}: {value} {other} ± {error}", point.time);
            }
        }
    }
}

/// A periodic motion has an error for each point, a chaotic one as long as it is determined; without errors the points have the same bits.
#[test]
fn points_of_a_diagram_have_errors_as_long_as_they_are_determined() {
    let (text, values, points) =
        ("x'' = -x'/4 + x - x^3 + A*cos(t)", [0.1, 0.4], Points { skipped: 0, recorded: 200 });
    let equation = text.parse().unwrap();
    for how in [Continuation::SameStart, Continuation::LastState] {
        let family =
            Family { equation: &equation, parameter: "A", section: &FLASH, points, with_errors: true };
        let effort = Effort::to_tolerance(1e-12);
        let columns =
            compute_bifurcation_diagram(&family, &values, &from(&[0.3, 0.1]), how, &effort, &Quiet).unwrap();
        for (column, plain) in columns.iter().zip(diagram(text, &values, &[0.3, 0.1], how, points)) {
            assert_eq!((&column.section.points, &plain.section.errors), (&plain.section.points, &None));
        }
        let errors = [0, 1].map(|column: usize| columns[column].section.errors.as_ref().unwrap());
        assert!(errors[0].determined_until.is_none() && errors[0].of_points.len() == 200, "{how:?}");
        assert!(errors[1].determined_until.is_some() && errors[1].of_points.len() < 150, "{how:?}");
    }
}

#[test]
fn a_driven_linear_oscillator_is_caught_where_theory_says() {
    let (damping, omega): (f64, f64) = (0.3, 1.7);
    for phase in [0.0, 0.25, 0.7] {
        let cut = Section::Stroboscope { period: None, phase };
        let section = points_of("x'' + 0.3 x' + x = cos(1.7 t)", &[1.0, 0.0], &cut, 100, 3);
        let (stiff, slow) = (1.0 - omega * omega, damping * omega);
        let angle = TAU * phase;
        let wanted = (stiff * libm::cos(angle) + slow * libm::sin(angle)) / (stiff * stiff + slow * slow);
        for (n, point) in (100..).zip(&section.points) {
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

/// The number of different velocities.
fn different(section: &PoincareSection) -> usize {
    let mut velocities: Vec<f64> = section.points.iter().map(|point| point.state[1]).collect();
    velocities.sort_by(f64::total_cmp);
    1 + velocities.windows(2).filter(|pair| pair[1] - pair[0] > 1e-5).count()
}

#[test]
fn the_driven_pendulum_doubles_its_period_on_the_way_to_chaos() {
    let points = Points { skipped: 1000, recorded: 64 };
    let values = [0.9, 1.07, 1.08, 1.0825, 1.5];
    let equation = "theta'' + theta'/2 + sin(theta) = A cos(2t/3)";
    let columns = diagram(equation, &values, &[0.2, 0.0], Continuation::SameStart, points);
    let counts: Vec<usize> = columns.iter().map(|column| different(&column.section)).collect();
    // At 1.08 there is a window of period three for this start.
    assert_eq!(counts, [1, 2, 3, 8, 64]);
}

#[test]
fn sweeps_up_and_down_differ_where_two_motions_are_stable() {
    // Between its two jumps Duffing's oscillator continues the branch it is on.
    let equation = "x'' + 0.2 x' + x + x^3 = A cos(1.8 t)";
    let points = Points { skipped: 100, recorded: 1 };
    let up: Vec<f64> = (0..=30).map(|n| 0.1 * f64::from(n)).collect();
    let down: Vec<f64> = up.iter().rev().copied().collect();
    let sweep = |values: &[f64]| diagram(equation, values, &[0.0, 0.0], Continuation::LastState, points);
    let (rising, falling) = (sweep(&up), sweep(&down));
    let distance = |(a, b): (&DiagramColumn, &DiagramColumn)| {
        (a.section.points[0].state[0] - b.section.points[0].state[0]).abs()
    };
    let apart: Vec<f64> = rising.iter().zip(falling.iter().rev()).map(distance).collect();
    assert!(apart[1] < 1e-6 && apart[30] < 1e-6, "{apart:?}");
    assert!(apart.iter().filter(|distance| **distance > 0.3).count() >= 3, "{apart:?}");
}

#[test]
fn columns_from_the_same_start_know_nothing_of_each_other() {
    let points = Points { skipped: 20, recorded: 10 };
    let values: Vec<f64> = (0..21).map(|n| 1.0 + 0.025 * f64::from(n)).collect();
    let equation = "theta'' + theta'/2 + sin(theta) = A cos(2t/3)";
    let columns = diagram(equation, &values, &[0.2, 0.0], Continuation::SameStart, points);
    for (value, column) in values.iter().zip(&columns) {
        let alone = diagram(equation, &[*value], &[0.2, 0.0], Continuation::SameStart, points);
        assert_eq!(*column, alone[0]);
    }
    let section = points_of(&equation.replace('A', "1.0"), &[0.2, 0.0], &FLASH, 20, 10);
    for (a, b) in columns[0].section.points.iter().zip(&section.points) {
        assert!((a.state[0] - b.state[0]).abs() < 1e-9 && (a.time - b.time).abs() < 1e-12);
    }
}

#[test]
fn the_drive_may_be_the_parameter() {
    let points = Points { skipped: 200, recorded: 1 };
    for how in [Continuation::SameStart, Continuation::LastState] {
        for DiagramColumn { value, section } in
            diagram("x'' + 0.3 x' + x = cos(A t)", &[0.5, 1.0, 1.7], &[1.0, 0.0], how, points)
        {
            let (stiff, slow) = (1.0 - value * value, 0.3 * value);
            let wanted = stiff / (stiff * stiff + slow * slow);
            assert!(
                (section.points[0].state[0] - wanted).abs() < 1e-9,
                "{value}: {}",
                section.points[0].state[0]
            );
        }
    }
}

fn surface(formula: &str, direction: Direction) -> Section {
    Section::Crossing { formula: formula.parse().unwrap(), direction }
}

#[test]
fn crossings_are_on_the_surface_and_keep_the_energy() {
    let start = [0.0, -0.15, 0.5555027734704241, 0.0];
    let energy = |s: &[f64]| {
        0.5 * (s[2] * s[2] + s[3] * s[3] + s[0] * s[0] + s[1] * s[1]) + s[0] * s[0] * s[1]
            - s[1] * s[1] * s[1] / 3.0
    };
    let section = points_of(HENON_HEILES, &start, &surface("x", Direction::Rising), 10, 500);
    assert_eq!((section.points.len(), section.stopped), (500, None));
    for Moment { state, .. } in &section.points {
        assert!(state[0].abs() < 1e-12 && state[2] > 0.0, "{state:?}");
        assert!((energy(state) - energy(&start)).abs() < 1e-10);
    }
}

const HENON_HEILES: &str = "x'' = -x - 2 x y; y'' = -y - x^2 + y^2";

#[test]
fn no_crossing_is_missed_or_doubled() {
    let times = |direction| {
        let section = points_of("x'' = -x", &[1.0, 0.0], &surface("x - 0.999999", direction), 3, 2000);
        section.points.iter().map(|point| point.time).collect::<Vec<f64>>()
    };
    let lag = libm::acos(0.999999);
    for (n, time) in (4..).zip(times(Direction::Rising)) {
        assert!((time - (f64::from(n) * TAU - lag)).abs() < 1e-6, "{n} {time}");
    }
    let falling = times(Direction::Falling);
    assert!((falling[1999] - (2002.0 * TAU + lag)).abs() < 1e-6);
    assert_eq!(times(Direction::Any).len(), 2000);
    assert!((times(Direction::Any)[1999] - 1001.0 * TAU - lag).abs() < 1e-6);
}

/// 1/x has poles only: the search ends after ten stretches, which have at most a hundred steps here.
#[test]
fn a_surface_of_poles_alone_is_never_crossed() {
    let (equation, points) = ("x'' = -x".parse().unwrap(), Points { skipped: 0, recorded: 1 });
    let effort = Effort { most_steps: 100, ..Effort::to_tolerance(1e-12) };
    let steps = Cell::new(0);
    let progress = |_| {
        steps.set(steps.get() + 1);
        ControlFlow::Continue(())
    };
    let cut = surface("1/x", Direction::Any);
    let section = compute_section(&equation, &from(&[1.0, 0.0]), &cut, points, &effort, &progress).unwrap();
    assert_eq!((section.points, section.stopped), (vec![], Some(SectionEnding::NeverCrossed)));
    assert!((500..=1000).contains(&steps.get()), "{}", steps.get());
}

#[test]
fn a_start_of_another_length_is_refused_with_and_without_errors() {
    let (points, effort) = (Points { skipped: 0, recorded: 1 }, Effort::to_tolerance(1e-12));
    for state in [&[][..], &[1.0], &[1.0, 0.0, 0.0]] {
        for section in [FLASH, surface("x", Direction::Any)] {
            let computed = [compute_section, compute_section_with_errors].map(|compute| {
                let equation = "x'' = -x + cos(t)".parse().unwrap();
                compute(&equation, &from(state), &section, points, &effort, &Quiet)
            });
            let is_refused = |result: &_| matches!(result, Err(SectionError::Integration(_)));
            assert!(computed.iter().all(is_refused), "{state:?}: {computed:?}");
        }
    }
}

#[test]
fn a_motion_that_crosses_no_more_says_so() {
    let section = points_of("x'' = 0", &[1.0, -4.0], &surface("x", Direction::Falling), 0, 5);
    assert_eq!((section.points.len(), section.stopped), (1, Some(SectionEnding::NoCrossing)));
    // A motion that escapes never crosses the surface.
    for running in ["x'' = 1", "x'' = x"] {
        let section = points_of(running, &[0.5, 1.0], &surface("x", Direction::Rising), 0, 5);
        assert_eq!(
            (section.points.len(), section.stopped),
            (0, Some(SectionEnding::NeverCrossed)),
            "{running}"
        );
    }
}

/// Errors carry a motion across the level of its turning point and back, and |x| seems to change its sign where the sign of x changes.
#[test]
fn a_level_that_is_only_touched_is_not_crossed() {
    for (formula, tolerance, most) in
        [("x - 1", 1e-16, 3000), ("x + 1", 1e-16, 3000), ("x - 1", 1e-6, 3000), ("abs(x)", 1e-3, 6000)]
    {
        let steps = Cell::new(0);
        let progress = |_: Status| {
            steps.set(steps.get() + 1);
            if steps.get() < most { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        };
        let (equation, points) = ("x'' = -x".parse().unwrap(), Points { skipped: 0, recorded: 1 });
        let (surface, effort) = (surface(formula, Direction::Any), Effort::to_tolerance(tolerance));
        let section = compute_section(&equation, &from(&[1.0, 0.0]), &surface, points, &effort, &progress);
        let PoincareSection { points, stopped, .. } = section.unwrap();
        assert_eq!(points, [], "{formula}");
        assert_eq!(stopped, Some(SectionEnding::Stopped(Cause::Interrupted)), "{formula}");
    }
}

/// The amplitude decreases by forty powers of ten, below the errors that the first steps would have by their size.
#[test]
fn crossings_of_a_decaying_motion_count_at_any_amplitude() {
    let section = points_of("x'' = -x - 0.2*x'", &[1.0, 0.0], &surface("x", Direction::Rising), 0, 150);
    let turn = TAU / 0.99_f64.sqrt();
    let intervals = section.points.windows(2).map(|pair| pair[1].time - pair[0].time);
    assert!(
        intervals.clone().count() == 149
            && intervals.into_iter().all(|interval| (interval - turn).abs() < 1e-9)
    );
}

/// Lorenz's equations where all motions come to rest.
const LORENZ: &str = "x' = 10*(y - x); y' = x*(41/2 - z) - y; z' = x*y - 8/3*z";

#[test]
fn a_motion_that_came_to_rest_is_not_followed_for_long() {
    let (effort, points) = (Effort::to_tolerance(1e-12), Points { skipped: 0, recorded: 5 });
    // The second comes to rest where the force is a rounding error and the last bits change for a while.
    for (equation, start, formula, crossings) in [
        (LORENZ, &[1.0, 1.0, 1.0][..], "z - 27", 1),
        ("x'' + 0.1*x' - x + x^3 = 0", &[2.0, 0.0], "x + 2", 0),
        ("x'' + 0.2*x' + sin(x) = 0.5", &[2.0, 0.0], "x - 3", 0),
    ] {
        let surface = Section::Crossing { formula: formula.parse().unwrap(), direction: Direction::Rising };
        let steps = Cell::new(0);
        let progress = |_: Status| {
            steps.set(steps.get() + 1);
            ControlFlow::Continue(())
        };
        let equation = equation.parse().unwrap();
        let section = compute_section(&equation, &from(start), &surface, points, &effort, &progress).unwrap();
        assert_eq!(section.points.len(), crossings, "{equation}");
        assert!(steps.get() < 40_000, "{equation}: {} steps", steps.get());
    }
}

#[test]
fn a_surface_that_moves_comes_to_a_motion_at_rest() {
    let surface = surface("cos(t/2000) - 1/2", Direction::Rising);
    let section = points_of(LORENZ, &[1.0, 1.0, 1.0], &surface, 0, 1);
    assert!((section.points[0].time - 2000.0 * (TAU - PI / 3.0)).abs() < 1e-5);
}

#[test]
fn interruptions_keep_what_is_done() {
    let equation = "theta'' + theta'/2 + sin(theta) = A cos(2t/3)".parse().unwrap();
    let points = Points { skipped: 5, recorded: 20 };
    let family = Family { equation: &equation, parameter: "A", section: &FLASH, points, with_errors: false };
    let stop = |limit: usize| {
        move |status: Status| {
            if status.done >= limit { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        }
    };
    let (start, effort) = (from(&[0.2, 0.0]), Effort::to_tolerance(1e-10));
    let values = [1.0, 1.1, 1.2, 1.3];
    let kept = |how| -> Vec<f64> {
        let columns = compute_bifurcation_diagram(&family, &values, &start, how, &effort, &stop(2)).unwrap();
        assert!(columns.iter().all(|column| column.section.points.len() == 20));
        columns.iter().map(|column| column.value).collect()
    };
    assert_eq!(kept(Continuation::LastState), [1.0, 1.1]);
    // In lanes, motions other than the first two may finish first.
    assert_eq!(kept(Continuation::SameStart).len(), 2);
    // A cancelled diagram prepares nothing, and does not see that these are no values.
    for how in [Continuation::SameStart, Continuation::LastState] {
        let columns =
            compute_bifurcation_diagram(&family, &[f64::NAN], &start, how, &effort, &stop(0)).unwrap();
        assert!(columns.is_empty());
    }
    let equation = "theta'' + theta'/2 + sin(theta) = cos(2t/3)".parse().unwrap();
    let section = compute_section(&equation, &start, &FLASH, points, &effort, &stop(7)).unwrap();
    assert_eq!(section.stopped, Some(SectionEnding::Stopped(Cause::Interrupted)));
    assert!((7..20).contains(&section.points.len()), "{}", section.points.len());
}

#[test]
fn the_period_of_a_drive_is_found_where_there_is_one() {
    let period = |equation: &str| drive_period(&equation.parse().unwrap());
    let close =
        |computed: Option<f64>, wanted: f64| assert!((computed.unwrap() / wanted - 1.0).abs() < 1e-15);
    close(period("x'' = -x + cos(5*t)"), TAU / 5.0);
    close(period("x'' = -x + cos(t/2) + sin(t/3)*x"), 6.0 * TAU);
    close(period("x'' = -x - y; y'' = -y + cos(2*pi*t)"), 1.0);
    close(period("x'' = -x + cos(3*t)^2 + sin(-3*t)"), TAU / 3.0);
    // The first drive may make at most a thousand periods until both repeat.
    close(period("x'' = -x + cos(t) + cos(t/1000)"), 1000.0 * TAU);
    assert_eq!(period("x'' = -x + cos(t) + cos(t/1001)"), None);
    for none in [
        "x'' = -x",
        "x'' = -x + t",
        "x'' = -x + cos(t) + t/9",
        "x'' = -x + cos(t^2)",
        "x'' = -x + exp(-t)*cos(t)",
        "x'' = -x + cos(t) + cos(sqrt(2)*t)",
        "x'' = -x + cos(x*t)",
    ] {
        assert_eq!(period(none), None, "{none}");
    }
}

/// The periods follow from products of cosines written as sums, as in 2·cos(t)·cos(3t) = cos(2t) + cos(4t) and 4·cos³t − 3·cos t = cos(3t).
#[test]
fn the_period_is_the_least_in_which_the_equations_repeat() {
    for (equation, period) in [
        ("x'' = -x + cos(2*t)^2", PI / 2.0),
        ("x'' = -x + abs(cos(2*t))", PI / 2.0),
        ("x'' = -x + 3*sin(t)*cos(t)", PI),
        ("x'' = -sin(x + cos(t)^2) - x'*abs(sin(t))^1.5", PI),
        ("x'' = -x*cos(t)*x*cos(t)", PI),
        ("x'' = -x + max(cos(t), -cos(t)) + cos(t)^8", PI),
        ("x'' = -x + sign(cos(t))*cos(t) + cosh(3*cos(t))", PI),
        ("x'' = -x + cos(t)*cos(3*t)", PI),
        ("x'' = -x + cos(t)*cos(t/3)", 3.0 * PI),
        ("x'' = -x + 4*cos(t)^3 - 3*cos(t)", TAU / 3.0),
        ("x'' = -x + cos(t)^2 - cos(2*t)/2 + cos(7*t)", TAU / 7.0),
        ("x'' = -x + cos(t)^2; y'' = -y + sin(t)^2*x", PI),
        // Windows, pulses and small parts keep the longer period.
        ("x'' = -x + cos(t)^2; y'' = -y + sin(t)", TAU),
        ("x'' = -x + max(cos(t) - 0.999, 0)", TAU),
        ("x'' = -x + cos(t)^2 + max(0.001 - abs(x - 0.5), 0)*cos(t)", TAU),
        ("x'' = -x + exp(-10000*(1 - cos(t)))", TAU),
        ("x'' = -x + tanh(10000*(cos(t) - 0.99))", TAU),
        ("x'' = -1e20*x + cos(t)^2 + 1e-20*cos(t)", TAU),
        ("x'' = -x + sign(cos(t))", TAU),
        ("x'' = -x*(cos(t)^2 + sin(t)^2)", TAU),
    ] {
        let computed = drive_period(&equation.parse().unwrap()).unwrap();
        assert!((computed / period - 1.0).abs() < 1e-15, "{equation}: {computed:?} for {period:?}");
    }
    let (frequency, times) = drive_frequency(&"x'' = -x + A*cos(w*t)^2".parse().unwrap()).unwrap();
    assert_eq!((frequency.to_string().as_str(), times), ("2*w", 1));
}

#[test]
fn folded_angles_are_in_the_turn_around_zero() {
    assert_eq!((folded(PI), folded(0.5), folded(-0.5)), (PI, 0.5, -0.5));
    assert_eq!(folded(-PI), PI);
    assert!((folded(-PI.next_down()) + PI).abs() < 1e-15 && folded(PI.next_up()) < -3.0);
    for turns in [-7.0, 1.0, 1e6] {
        assert!((folded(0.25 + turns * TAU) - 0.25).abs() < 1e-15 * (1.0 + f64::abs(turns) * TAU));
    }
}

#[test]
fn a_section_tells_how_far_it_is_and_stops_when_asked() {
    let equation = "x'' = -x - x'/2 + cos(t)".parse().unwrap();
    let (effort, points) = (Effort::to_tolerance(1e-9), Points { skipped: 5, recorded: 20 });
    let surface = Section::Crossing { formula: "x".parse().unwrap(), direction: Direction::Rising };
    for cut in [FLASH, surface] {
        let reports: RefCell<Vec<Status>> = RefCell::default();
        let progress = |status: Status| {
            reports.borrow_mut().push(status);
            if status.done >= 5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let section =
            compute_section(&equation, &from(&[1.0, 0.0]), &cut, points, &effort, &progress).unwrap();
        assert_eq!(section.stopped, Some(SectionEnding::Stopped(Cause::Interrupted)));
        let reports = reports.into_inner();
        assert!(
            reports.is_sorted_by_key(|report| report.done)
                && reports.iter().all(|report| report.of == Some(20))
        );
        assert_eq!((section.points.len(), reports.last().unwrap().done), (5, 5));
    }
}

#[test]
fn a_sweep_over_the_frequency_goes_on_at_the_phase_of_the_drive() {
    let equation = "x'' = -x - x'/2 + cos(A*t)".parse().unwrap();
    let section = Section::Stroboscope { period: None, phase: 0.25 };
    let points = Points { skipped: 0, recorded: 3 };
    let family =
        Family { equation: &equation, parameter: "A", section: &section, points, with_errors: false };
    let effort = Effort::to_tolerance(1e-12);
    let columns = compute_bifurcation_diagram(
        &family,
        &[1.0, 1.3],
        &from(&[1.0, 0.0]),
        Continuation::LastState,
        &effort,
        &Quiet,
    )
    .unwrap();
    let [before, after] = [0, 1].map(|column: usize| &columns[column].section.points);
    // The first strobe of the new drive is at the state of the last strobe of the old one.
    assert_eq!(after[0].state, before[2].state);
    assert!((after[0].time - 0.25 * TAU / 1.3).abs() < 1e-14, "{}", after[0].time);
}
