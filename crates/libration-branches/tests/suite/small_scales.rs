//! Responses whose coordinates or times are of another order of magnitude than 1: those of the same equation in other units.

use libration::continuation::{
    Branch, ChartOptions, Ending, Response, ResponseOptions, Rotation, SpecialKind, StabilityChart,
};
use libration::nonlinear_modes::NonlinearMode;
use libration::normal_modes::NormalModes;
use libration::progress::Quiet;

/// Parameters of all special points, with their kinds.
fn special(
    equation: &str,
    parameter: &str,
    range: [f64; 2],
    start: Option<Vec<f64>>,
) -> Vec<(SpecialKind, f64)> {
    let options = ResponseOptions { start, ..ResponseOptions::default() };
    let response = Response::over(&equation.parse().unwrap(), parameter, range, &options, &Quiet).unwrap();
    let points = response.branches.iter().flat_map(|branch| &branch.special);
    points.map(|point| (point.kind, point.point.parameter)).collect()
}

/// Duffing's equation with hardening at amplitudes of 1, 1e-12 and 1e-10 s; a drive that grows.
#[test]
fn a_response_has_the_same_folds_in_all_units() {
    let usual = special("x'' = -0.1*x' - x - x^3 + 0.3*cos(w*t)", "w", [0.5, 2.0], None);
    assert!(usual.len() == 2 && usual.iter().all(|(kind, _)| *kind == SpecialKind::Fold), "{usual:?}");
    for (equation, range, unit) in [
        ("x'' = -0.1*x' - x - 1e24*x^3 + 3e-13*cos(w*t)", [0.5, 2.0], 1.0),
        ("x'' = -0.1*x' - x - 1e18*x^3 + 3e-10*cos(w*t)", [0.5, 2.0], 1.0),
        ("x'' = -1e5*x' - 1e12*x - 1e30*x^3 + 3e2*cos(w*t)", [5e5, 2e6], 1e6),
        ("x'' = -0.1*x' - x - 1e-24*x^3 + 3e11*cos(w*t)", [0.5, 2.0], 1.0),
    ] {
        let folds = special(equation, "w", range, None);
        assert_eq!(folds.len(), 2, "{equation}: {folds:?}");
        for ((kind, parameter), (of_usual, other)) in folds.iter().zip(&usual) {
            assert!(
                kind == of_usual && (parameter / (unit * other) - 1.0).abs() < 1e-12,
                "{equation}: {folds:?}"
            );
        }
    }
    let drives = special("x'' = -0.1*x' - x - 1e24*x^3 + A*1e-12*cos(1.5*t)", "A", [0.1, 1.0], None);
    let usual = special("x'' = -0.1*x' - x - x^3 + A*cos(1.5*t)", "A", [0.1, 1.0], None);
    assert_eq!(drives.len(), usual.len(), "{drives:?}");
    assert!(
        drives.iter().zip(&usual).all(|(drive, other)| (drive.1 / other.1 - 1.0).abs() < 1e-12),
        "{drives:?}"
    );
}

/// A drive without the symmetry of the force, which at amplitudes of 1 is far below the rounding of the force.
#[test]
fn a_small_drive_decides_the_symmetry() {
    let equation = "x'' = -0.1*x' - x - 1e24*x^3 + 3e-13*cos(w*t) + 2e-13*cos(2*w*t)";
    let options = ResponseOptions::default();
    let response = Response::over(&equation.parse().unwrap(), "w", [1.9, 2.0], &options, &Quiet).unwrap();
    let point = &response.branches[0].points[0];
    let [low, high] = point.ranges[0];
    assert!((low + high).abs() > 0.05 * high, "{point:?}");
}

#[test]
fn a_small_start_without_a_drive_is_in_its_own_units() {
    let equation = "x'' = (mu - 1e24*x^2)*x' - x".parse().unwrap();
    let options = ResponseOptions { start: Some(vec![1e-12, 0.0]), ..ResponseOptions::default() };
    let response = Response::over(&equation, "mu", [0.5, 2.0], &options, &Quiet).unwrap();
    let last = response.branches[0].points.last().unwrap();
    let usual = "x'' = (mu - x^2)*x' - x".parse().unwrap();
    let options = ResponseOptions { start: Some(vec![1.0, 0.0]), ..ResponseOptions::default() };
    let other = Response::over(&usual, "mu", [0.5, 2.0], &options, &Quiet).unwrap();
    let other = other.branches[0].points.last().unwrap();
    assert!((1e12 * last.ranges[0][1] / other.ranges[0][1] - 1.0).abs() < 1e-10, "{last:?} {other:?}");
}

/// A stop at 1, and at 1e10 with forces whose rounding differs. Corrections in the units of the equation never fell below 1e-9 there.
#[test]
fn corrections_of_large_motions_are_in_their_units() {
    for part in [1.0, 1.0 + 3e-7, 1.0 - 5e-7, 1.0 + 7e-7] {
        let equation = |unit: f64| {
            let (damping, stop, drive) = (0.1 * part, 10.0 / part, 0.3 * part * unit);
            format!("x'' = -{damping:?}*x' - x - {stop:?}*max(x - {unit:?}, 0) + {drive:?}*cos(w*t)")
        };
        let usual = special(&equation(1.0), "w", [0.5, 2.0], None);
        let large = special(&equation(1e10), "w", [0.5, 2.0], None);
        assert_eq!((usual.len(), large.len()), (2, 2), "{part}");
        assert!(
            usual.iter().zip(&large).all(|(a, b)| a.0 == b.0 && (a.1 / b.1 - 1.0).abs() < 1e-12),
            "{part}"
        );
    }
}

/// θ = wt is exact, at any frequency.
#[test]
fn fast_rotations_are_found() {
    let options = ResponseOptions {
        rotation: Some(Rotation { coordinate: 0, turns: 1 }),
        at: Some(2e10),
        generations: 0,
        ..ResponseOptions::default()
    };
    let equation = "theta'' = -2e9*theta' - 1e20*sin(theta) + 2e9*w + 1e20*sin(w*t)".parse().unwrap();
    let response = Response::over(&equation, "w", [1.5e10, 3e10], &options, &Quiet).unwrap();
    let is_even = |branch: &Branch| {
        branch.points.iter().all(|point| (point.state[1] / point.parameter - 1.0).abs() < 1e-12)
    };
    let branch = response.branches.iter().find(|branch| is_even(branch)).unwrap();
    assert_eq!([branch.points[0].parameter, branch.points.last().unwrap().parameter], [1.5e10, 3e10]);
}

/// The isola of [`crate::orders`] at amplitudes of 1e-9 and 1e9.
#[test]
fn free_oscillations_are_released_in_the_units_of_the_drive() {
    for (stiffness, drive) in [("1e18", "5e-9"), ("1e-18", "5e9")] {
        let options = ResponseOptions {
            orders: vec!["1/3".parse().unwrap()],
            generations: 0,
            ..ResponseOptions::default()
        };
        let equation = format!("x'' = -0.15*x' - x - {stiffness}*x^3 + {drive}*cos(w*t)").parse().unwrap();
        let response = Response::over(&equation, "w", [2.5, 6.0], &options, &Quiet).unwrap();
        let isola = response.branches.iter().find(|branch| branch.ending == Ending::Closed).unwrap();
        for expected in [5.294354133015056, 3.648857400987054] {
            let mut folds = isola.special.iter().map(|fold| fold.point.parameter);
            assert!(folds.any(|w| (w - expected).abs() < 1e-12), "{drive}");
        }
    }
}

/// Nagumo's equations of a nerve with v and w in units of 1e-9 and 1e9: both Hopf points.
#[test]
fn hopf_points_are_found_in_all_units() {
    let hopf = |unit: f64| {
        let equation =
            format!("v' = v - ({:?}*v)^2*v/3 - w + I; w' = 0.08*(v + {:?} - 0.8*w)", 1.0 / unit, 0.7 * unit);
        let start = Some(vec![unit, 0.5 * unit]);
        let options = ResponseOptions { at: Some(0.8 * unit), start, ..ResponseOptions::default() };
        let response =
            Response::over(&equation.parse().unwrap(), "I", [0.0, 2.0 * unit], &options, &Quiet).unwrap();
        let points = response.branches.iter().flat_map(|branch| &branch.special);
        let hopf =
            points.filter(|point| point.kind == SpecialKind::Hopf).map(|point| point.point.parameter / unit);
        let mut hopf: Vec<f64> = hopf.collect();
        hopf.sort_by(f64::total_cmp);
        hopf.dedup_by(|a, b| (*a / *b - 1.0).abs() < 1e-9);
        hopf
    };
    let usual = hopf(1.0);
    assert_eq!(usual.len(), 2, "{usual:?}");
    for unit in [1e-9, 1e9] {
        let other = hopf(unit);
        assert_eq!(other.len(), 2, "{unit}: {other:?}");
        assert!(usual.iter().zip(&other).all(|(a, b)| (a / b - 1.0).abs() < 1e-10), "{unit}: {other:?}");
    }
}

/// Stable motions at the lower end of the range are distinguished, whatever the unit of time, and the boundaries are those without a rest.
#[test]
fn units_of_time_do_not_matter() {
    let in_units = |unit: f64| {
        let (damping, square) = (0.1 / unit, 1.0 / (unit * unit));
        let force = format!("x'' = -{damping:e}*x' - {square:e}*(x + x^3)");
        let driven = format!("{force} + {:e}*cos(w*t)", 0.3 * square).parse().unwrap();
        let range = [1.45 / unit, 2.0 / unit];
        let response = Response::over(&driven, "w", range, &ResponseOptions::default(), &Quiet).unwrap();
        let ends = response.branches.iter().map(|branch| branch.points[0].ranges[0][1]).collect::<Vec<_>>();
        let charted = format!("{force} + A*cos(w*t)").parse().unwrap();
        let ranges = [[1.0 / unit, 2.0 / unit], [0.1 * square, 0.5 * square]];
        let options = ChartOptions { generations: 0, ..ChartOptions::default() };
        let chart = StabilityChart::over(&charted, ["w", "A"], ranges, &options, &Quiet).unwrap();
        let kinds: Vec<SpecialKind> = chart.curves.iter().map(|curve| curve.kind).collect();
        (ends, kinds)
    };
    let (ends, kinds) = in_units(1.0);
    assert_eq!(kinds, [SpecialKind::Fold; 2]);
    for unit in [1e-9, 1e9] {
        let (own_ends, own_kinds) = in_units(unit);
        assert_eq!((own_ends.len(), &own_kinds), (ends.len(), &kinds), "{unit}");
        assert!(
            own_ends.iter().zip(&ends).all(|(a, b)| (a / b - 1.0).abs() < 1e-10),
            "{unit}: {own_ends:?} {ends:?}"
        );
    }
}

#[test]
fn modes_are_followed_in_fast_units() {
    let equation = "x'' = 1e18*(-2*x + y - x^3); y'' = 1e18*(x - 3*y)".parse().unwrap();
    let modes = NormalModes::new(&equation).unwrap();
    let mode = NonlinearMode::follow(&equation, &modes, 0, 0, &[0.5, 1.0], &Quiet).unwrap();
    assert!(mode.lost.is_none() && mode.points.len() == 2, "{:?}", mode.lost);
    let usual = "x'' = -2*x + y - x^3; y'' = x - 3*y".parse().unwrap();
    let modes = NormalModes::new(&usual).unwrap();
    let usual = NonlinearMode::follow(&usual, &modes, 0, 0, &[0.5, 1.0], &Quiet).unwrap();
    let periods =
        mode.points.iter().zip(&usual.points).map(|(a, b)| 1e9 * a.orbit.period() / b.orbit.period());
    assert!(periods.into_iter().all(|ratio| (ratio - 1.0).abs() < 1e-12));
}

/// The equations of two coordinates in which y is measured in another unit, 1/`factor` of the one in the text.
fn with_second_in(equations: [&str; 2], factor: f64) -> String {
    let in_unit = |text: &str| {
        text.replace('y', &format!("y/{factor:e}"))
            .replace(&format!("/{factor:e}'"), &format!("'/{factor:e}"))
    };
    let [(first, left), (second, right)] = equations.map(|text| text.split_once('=').unwrap());
    format!("{first} = {}; {second} = {factor:e}*({})", in_unit(left), in_unit(right))
}

/// Two driven oscillators, one of them with a stop, and two self-excited systems, with the unit of the second coordinate from 1e-10 to 1e9 of
/// that of the first: the same singular points, with the same motions in the same units.
#[test]
fn coordinates_of_far_different_units_have_the_same_branches() {
    let cases = [
        (
            ["x''=-x-0.1*x'-x^3+0.2*(y)+0.3*cos(w*t)", "y''=-4*(y)-0.1*(y')-(y)^3+0.2*x"],
            "w",
            [0.6, 1.6],
            None,
        ),
        (
            ["x''=-x-0.1*x'-5*max(x-1,0)+0.1*(y)+0.4*cos(w*t)", "y''=-3*(y)-0.2*(y')+0.1*x"],
            "w",
            [1.0, 1.6],
            None,
        ),
        (["x'=x-x^3/3-(y)+I", "y'=0.08*(x+0.7-0.8*(y))"], "I", [0.0, 2.0], Some(0.8)),
        (["x'=1-(b+1)*x+x^2*(y)", "y'=b*x-x^2*(y)"], "b", [1.5, 4.0], None),
    ];
    for (equations, parameter, range, at) in cases {
        let response = |factor: f64| {
            let options = ResponseOptions { at, ..ResponseOptions::default() };
            let equation = with_second_in(equations, factor);
            let response = Response::over(&equation.parse().unwrap(), parameter, range, &options, &Quiet);
            response.unwrap_or_else(|error| panic!("{equations:?} {factor:e}: {error}"))
        };
        let usual = response(1.0);
        for factor in [1e-9, 1e-4, 1e5, 1e10] {
            let other = response(factor);
            assert_eq!(other.branches.len(), usual.branches.len(), "{equations:?} {factor:e}");
            assert_eq!(other.jumps.len(), usual.jumps.len(), "{equations:?} {factor:e}");
            for (branch, of_usual) in other.branches.iter().zip(&usual.branches) {
                assert_eq!([branch.beginning, branch.ending], [of_usual.beginning, of_usual.ending]);
                let kinds =
                    |branch: &Branch| branch.special.iter().map(|special| special.kind).collect::<Vec<_>>();
                assert_eq!(kinds(branch), kinds(of_usual), "{equations:?} {factor:e}");
                for (special, same) in branch.special.iter().zip(&of_usual.special) {
                    let apart = (special.point.parameter - same.point.parameter).abs();
                    assert!(apart <= 1e-11, "{equations:?} {factor:e}: {special:?} {same:?}");
                    let [range, of_same] =
                        [special, same].map(|special| special.point.ranges[1].map(|end| end));
                    // Along a canard the parameter is the same to its last digits, and does not determine the motion at a fold.
                    if !usual.driven && special.kind == SpecialKind::Fold {
                        continue;
                    }
                    let size = of_same[1].abs().max(of_same[0].abs());
                    assert!(
                        range.iter().zip(&of_same).all(|(a, b)| (a / factor - b).abs() <= 1e-6 * size),
                        "{range:?} {of_same:?} {factor:e}"
                    );
                }
            }
        }
    }
}

/// The folds of two driven oscillators over frequency and drive, with the unit of the second coordinate far from that of the first.
#[test]
fn coordinates_of_far_different_units_have_the_same_chart() {
    let equations = ["x''=-x-0.1*x'-x^3+0.2*(y)+F*cos(w*t)", "y''=-4*(y)-0.1*(y')-(y)^3+0.2*x"];
    let chart = |factor: f64| {
        let equation = with_second_in(equations, factor).parse().unwrap();
        let options = ChartOptions { lines: 1, ..ChartOptions::default() };
        StabilityChart::over(&equation, ["w", "F"], [[0.8, 1.4], [0.1, 0.5]], &options, &Quiet).unwrap()
    };
    let usual = chart(1.0);
    assert!(usual.curves.iter().any(|curve| curve.kind == SpecialKind::Fold), "{usual:?}");
    for factor in [1e-9, 1e10] {
        let other = chart(factor);
        assert_eq!(other.curves.len(), usual.curves.len(), "{factor:e}");
        for (curve, same) in other.curves.iter().zip(&usual.curves) {
            assert_eq!(
                (curve.kind, curve.endings, curve.cusps.len()),
                (same.kind, same.endings, same.cusps.len())
            );
            for (cusp, of_same) in curve.cusps.iter().zip(&same.cusps) {
                let apart = [cusp.point.parameter - of_same.point.parameter, cusp.second - of_same.second];
                assert!(apart.iter().all(|apart| apart.abs() < 1e-9), "{factor:e}: {apart:?}");
                let [height, of_usual] = [cusp, of_same].map(|cusp| cusp.point.ranges[1][1]);
                assert!((height / factor / of_usual - 1.0).abs() < 1e-6, "{factor:e}: {height}, {of_usual}");
            }
        }
    }
}

/// A rotating pendulum with an oscillator whose unit is far smaller: whole turns of the angle count in radians.
#[test]
fn an_angle_keeps_its_unit_next_to_a_coordinate_of_another_unit() {
    let equations =
        ["theta''=-0.2*theta'-sin(theta)+0.2*w+2*sin(w*t)+0.05*(y)", "y''=-9*(y)-0.2*(y')+0.1*sin(theta)"];
    let branch = |factor: f64| {
        let options = ResponseOptions {
            rotation: Some(Rotation { coordinate: 0, turns: 1 }),
            at: Some(2.0),
            generations: 0,
            ..ResponseOptions::default()
        };
        let equation = with_second_in(equations, factor).parse().unwrap();
        Response::over(&equation, "w", [1.8, 2.2], &options, &Quiet).unwrap().branches.swap_remove(0)
    };
    let usual = branch(1.0);
    for factor in [1e-8, 1e8] {
        let other = branch(factor);
        assert_eq!((other.beginning, other.ending), (usual.beginning, usual.ending));
        let ends = [&other, &usual].map(|branch| branch.points.last().unwrap());
        assert_eq!(ends[0].parameter, ends[1].parameter);
        for (component, unit) in [(0, 1.0), (1, factor), (2, 1.0), (3, factor)] {
            let [scaled, same] = ends.map(|point| point.state[component]);
            assert!((scaled / unit - same).abs() < 1e-11, "{factor:e}: {scaled:e} {same}");
        }
    }
}

/// A coordinate that hardly acts back has the unit of the other one, since both move alike: units that balanced their effects would be 1e-10 of it.
#[test]
fn a_coordinate_that_hardly_acts_back_keeps_its_unit() {
    let special = |back: &str| {
        let equation = format!("x''=-x-0.1*x'-x^3+{back}*y+0.3*cos(w*t); y''=-4*y-0.1*y'-y^3+0.2*x");
        special(&equation, "w", [0.6, 2.0], None)
    };
    let (usual, tiny) = (special("0"), special("1e-20"));
    assert!(usual.len() >= 2 && usual.len() == tiny.len(), "{usual:?} {tiny:?}");
    assert!(
        usual.iter().zip(&tiny).all(|(a, b)| a.0 == b.0 && (a.1 - b.1).abs() < 1e-11),
        "{usual:?} {tiny:?}"
    );
}
