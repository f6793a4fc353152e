//! Solutions that rotate in step with the drive, compared with an exact one
//! and with Taylor shooting in 40 digits; slow sweeps compared with branches.

use crate::typed::equation_with;
use libration::algebra::Complex;
use libration::continuation::{
    BranchError, BranchPoint, Response, ResponseOptions, Rotation, SpecialKind, SpecialPoint, Sweep,
};
use libration::expression::Equation;
use libration::progress::Quiet;
use libration_testing::golden::Table;
use std::f64::consts::TAU;

const PENDULUM: &str = "theta'' = -c*theta' - sin(theta) + A*cos(w*t)";

fn turning(turns: i32, drive_periods: u32) -> ResponseOptions {
    let rotation = Some(Rotation { coordinate: 0, turns });
    ResponseOptions { rotation, drive_periods, generations: 0, ..ResponseOptions::default() }
}

/// Distance between two angles, modulo whole turns.
fn apart(a: f64, b: f64) -> f64 {
    (a - b - TAU * ((a - b) / TAU).round()).abs()
}

#[test]
fn an_even_rotation_is_found_over_all_its_range() {
    // θ = wt is exact: the constant torque balances the damping, the periodic one balances gravity.
    let pendulum = equation_with("theta'' = -theta'/5 - sin(theta) + w/5 + sin(w*t)", &[]);
    for turns in [1, 2] {
        let options = ResponseOptions { at: Some(2.0), ..turning(turns, u32::try_from(turns).unwrap()) };
        let response = Response::over(&pendulum, "w", [1.5, 3.0], &options, &Quiet).unwrap();
        let is_even = |point: &BranchPoint| point.amplitude(0, true) < 1e-12;
        let branch = response.branches.iter().find(|branch| branch.points.iter().all(is_even)).unwrap();
        // A solution with two turns in two periods has one turn in one period, and is followed as such.
        assert_eq!(branch.space.rotation, Some(Rotation { coordinate: 0, turns: 1 }));
        for point in &branch.points {
            let w = point.parameter;
            assert!(apart(point.state[0], 0.0) < 1e-13 && (point.state[1] - w).abs() < 1e-13, "{point:?}");
            let product = point.multipliers.iter().fold(Complex::from(1.0), |a, b| a * *b);
            assert!((product.re - libm::exp(-TAU / w / 5.0)).abs() < 1e-12 && product.im.abs() < 1e-12);
        }
        let ends = [branch.points[0].parameter, branch.points.last().unwrap().parameter];
        assert_eq!(ends, [1.5, 3.0]);
    }
}

#[test]
fn rotating_answers_and_their_special_points_are_those_of_taylor_shooting() {
    let table = Table::read("rotations.csv");
    let mut kinds = vec![];
    for row in table.rows() {
        let pendulum = equation_with(PENDULUM, &[("c", row.text("c")), ("A", row.text("A"))]);
        let [turns, periods] =
            ["turns", "drive_periods"].map(|column| row.text(column).parse::<i32>().unwrap());
        let [w, theta, velocity, trace] =
            ["w", "theta", "velocity", "trace"].map(|column| row.text(column).parse::<f64>().unwrap());
        let is_near = |point: &BranchPoint| {
            let states = apart(point.state[0], theta).max((point.state[1] - velocity).abs());
            let sum: f64 = point.multipliers.iter().map(|multiplier| multiplier.re).sum();
            (point.parameter - w).abs() < 1e-12 && states < 1e-9 && (sum - trace).abs() < 1e-9
        };
        let options =
            ResponseOptions { generations: usize::from(periods > 1), ..turning(turns / periods, 1) };
        let response = Response::over(&pendulum, "w", [0.67, 1.0], &options, &Quiet).unwrap();
        let points = response.branches.iter().flat_map(|branch| &branch.points);
        let special = |kind: SpecialKind| {
            let all = response
                .branches
                .iter()
                .flat_map(|branch| branch.special.iter().map(|one| (branch.space, one)));
            all.filter(|(_, candidate)| candidate.kind == kind)
                .find(|(_, candidate)| is_near(&candidate.point))
        };
        let precise = |(space, special): (_, &SpecialPoint)| {
            let digits = special.to_digits(&pendulum, "w", space, 28, &Quiet).unwrap().expect("28 digits");
            digits.parameter.to_rational().to_decimal(26)
        };
        let kind = row.text("kind");
        match kind {
            "answer" => assert!({ points }.any(is_near), "{w}"),
            "fold" | "period_doubling" => {
                let kind = if kind == "fold" { SpecialKind::Fold } else { SpecialKind::PeriodDoubling };
                let digits = precise(special(kind).unwrap_or_else(|| panic!("{w}")));
                assert!(row.text("w").starts_with(&digits[..27]), "{digits} for {}", row.text("w"));
            }
            other => panic!("{other}"),
        }
        kinds.push(kind.to_owned());
    }
    assert_eq!(kinds.len(), 7, "{kinds:?}");
}

#[test]
fn an_answer_goes_around_either_way() {
    let pendulum = equation_with(PENDULUM, &[("c", "0.5"), ("A", "2")]);
    let doublings = [1, -1].map(|turns| {
        let response = Response::over(&pendulum, "w", [0.67, 1.0], &turning(turns, 1), &Quiet).unwrap();
        let branch = &response.branches[0];
        assert_eq!(branch.points[0].rotation, Some(Rotation { coordinate: 0, turns }));
        branch.special[0].point.parameter
    });
    assert!((doublings[0] - doublings[1]).abs() < 1e-14, "{doublings:?}");
}

#[test]
fn what_cannot_go_around_is_refused() {
    let over = |text: &str, values: &[(&str, &str)]| {
        Response::over(&equation_with(text, values), "w", [0.5, 1.0], &turning(1, 1), &Quiet).unwrap_err()
    };
    let weak = over(PENDULUM, &[("c", "0.5"), ("A", "0.1")]);
    assert_eq!(weak, BranchError::NoRotation { turns: 1, drive_periods: 1 });
    let duffing = over("x'' = -x'/10 - x - x^3 + cos(w*t)", &[]);
    assert_eq!(duffing, BranchError::NotAnAngle("x".to_owned()));
    assert_eq!(over("theta'' = w - theta' - sin(theta)", &[]), BranchError::NotDriven);
    let third = ResponseOptions { rotation: Some(Rotation { coordinate: 3, turns: 1 }), ..turning(1, 1) };
    let pendulum = equation_with(PENDULUM, &[("c", "0.5"), ("A", "2")]);
    let refused = Response::over(&pendulum, "w", [0.67, 1.0], &third, &Quiet).unwrap_err();
    assert!(matches!(refused, BranchError::NotAnAngle(_)), "{refused}");
}

fn swept(
    equation: &Equation,
    over: (&str, [f64; 2]),
    values: usize,
    options: &ResponseOptions,
) -> (Response, Vec<Sweep>) {
    let response = Response::over(equation, over.0, over.1, options, &Quiet).unwrap();
    let sweeps = response.sweeps(equation, over.0, over.1, values, &Quiet).unwrap();
    (response, sweeps)
}

#[test]
fn sweeps_go_along_the_stable_answers_and_jump_where_these_end() {
    let pendulum = equation_with(PENDULUM, &[("c", "0.1"), ("A", "0.15")]);
    let (response, sweeps) = swept(&pendulum, ("w", [0.7, 1.0]), 31, &ResponseOptions::default());
    assert_eq!(
        sweeps.iter().map(|sweep| (sweep.rising, sweep.points.len())).collect::<Vec<_>>(),
        [(true, 31), (false, 31)]
    );
    let [up, down] = [0.8721575691379169, 0.7806326535189843];
    for sweep in &sweeps {
        for point in &sweep.points {
            let swing = point.amplitude(0, true).unwrap();
            // Upwards, large swings follow after the jump up at 0.911; downwards, they exist before the jump down.
            let large = point.parameter > if sweep.rising { up } else { down };
            assert_eq!(
                (swing > 0.92, point.drive_periods, point.rotation),
                (large, Some(1), None),
                "{point:?}"
            );
        }
    }
    // Compared with the branch: at 0.7 rad/s the state of the reference.
    let end = &sweeps[1].points[30];
    assert_eq!(end.parameter, 0.7);
    assert!(
        (end.state[0] - 0.2945168920184240).abs() < 1e-5 && (end.state[1] - 0.02871899931394925).abs() < 1e-5
    );
    assert_eq!(response.branches.len(), 1);
}

#[test]
fn sweeps_tell_doubled_chaotic_and_rotating_motions() {
    // G. L. Baker and J. P. Gollub, Chaotic Dynamics, Cambridge 1990: with c = 1/2 and w = 2/3 there are two periods at 1.07, chaos at 1.15 and
    // rotations at 1.35; the period doubling of the swings is at 1.0663728625 (from both reference methods), that of the rotations beyond 1.4.
    let pendulum = equation_with("theta'' = -theta'/2 - sin(theta) + A*cos(2*t/3)", &[]);
    let options = ResponseOptions { generations: 0, ..ResponseOptions::default() };
    let (_, sweeps) = swept(&pendulum, ("A", [0.95, 1.15]), 11, &options);
    let upwards = sweeps.iter().find(|sweep| sweep.rising).unwrap();
    let periods: Vec<Option<u32>> = upwards.points.iter().map(|point| point.drive_periods).collect();
    assert_eq!((periods[0], periods[6], periods[10]), (Some(1), Some(2), None), "{periods:?}");
    let (_, sweeps) = swept(&pendulum, ("A", [1.35, 1.37]), 3, &turning(1, 1));
    for point in sweeps.iter().flat_map(|sweep| &sweep.points) {
        assert_eq!(point.rotation, Some(Rotation { coordinate: 0, turns: 1 }), "{point:?}");
        assert!(point.amplitude(0, true).is_some_and(|amplitude| amplitude < TAU));
    }
    assert!(!sweeps.is_empty());
}

#[test]
fn sweeps_end_where_the_watch_says() {
    let pendulum = equation_with(PENDULUM, &[("c", "0.1"), ("A", "0.15")]);
    let response = Response::over(&pendulum, "w", [0.9, 1.0], &ResponseOptions::default(), &Quiet).unwrap();
    let progress = |status: libration::progress::Status| match status.done {
        0..5 => std::ops::ControlFlow::Continue(()),
        _ => std::ops::ControlFlow::Break(()),
    };
    let sweeps = response.sweeps(&pendulum, "w", [0.9, 1.0], 20, &progress).unwrap();
    assert_eq!(sweeps.iter().map(|sweep| sweep.points.len()).sum::<usize>(), 5);
}
