//! Stability boundaries of equilibria, and curves of singular points over two parameters.
//!
//! References: Hill's matrix and the monodromy matrix by Taylor series for equilibria, Fourier collocation
//! and shooting for driven motions, all in floats of 130 bits; both methods agree in 30 digits.

use crate::typed::equation_with;
use libration::continuation::{
    BranchError, ChartOptions, CurvePoint, Ending, Response, ResponseOptions, SpecialCurve, SpecialKind,
    StabilityChart,
};
use libration::progress::{Quiet, Status};
use std::f64::consts::PI;
use std::ops::ControlFlow;

const PIVOT: &str = "theta'' = -c*theta' - (1 - a*w^2*cos(w*t))*sin(theta)";
const REST_ALONE: ChartOptions =
    ChartOptions { start: None, drive_periods: 1, generations: 1, lines: 0, most_points: 2000 };

/// Asserts the second parameter of the point on curves of this kind that is at a value of the first parameter and nearest to the expected point.
fn assert_at(chart: &StabilityChart, kind: SpecialKind, at_rest: bool, [first, second]: [f64; 2]) {
    let curves = chart.curves.iter().filter(|curve| curve.kind == kind && curve.at_rest == at_rest);
    let points = curves
        .flat_map(|curve| &curve.points)
        .filter(|point| point.point.parameter.to_bits() == first.to_bits());
    let off = |point: &CurvePoint| (point.second - second).abs();
    let nearest = points.min_by(|a, b| off(a).total_cmp(&off(b)));
    let nearest = nearest.unwrap_or_else(|| panic!("no {kind} at {first}"));
    assert!(
        off(nearest) <= (1e-12 * second).min(nearest.point.error.max(2e-13 * second)),
        "{kind} at {first}, {:?} ± {:e} for {second:?}",
        nearest.second,
        nearest.point.error
    );
}

/// Asserts that a stability boundary along a line of the pivot's amplitude is at its expected value.
fn assert_edge([w, c]: [&str; 2], rest: f64, range: [f64; 2], kind: SpecialKind, edge: f64) {
    let options =
        ResponseOptions { start: Some(vec![rest, 0.0]), generations: 0, ..ResponseOptions::default() };
    let response =
        Response::over(&equation_with(PIVOT, &[("w", w), ("c", c)]), "a", range, &options, &Quiet).unwrap();
    let special =
        response.branches.iter().flat_map(|branch| &branch.special).filter(|special| special.kind == kind);
    let off = |parameter: f64| (parameter - edge).abs();
    let nearest = special.min_by(|a, b| off(a.point.parameter).total_cmp(&off(b.point.parameter)));
    let nearest = nearest.unwrap_or_else(|| panic!("no {kind} at w = {w}, c = {c}"));
    let parameter = nearest.point.parameter;
    assert!(
        off(parameter) <= (1e-12 * edge).min(nearest.error.max(2e-13 * edge)),
        "w = {w}, c = {c}: {parameter:?} ± {:e} for {edge:?}",
        nearest.error
    );
}

#[test]
fn edges_of_the_hanging_and_of_the_upright_pendulum_are_exact() {
    use SpecialKind::{BranchPoint, PeriodDoubling};
    for (w, c, range, kind, edge) in [
        ("5", "0", [0.2, 0.4], BranchPoint, 0.2877323695607078999941236),
        ("5", "0.1", [0.2, 0.4], BranchPoint, 0.2877861746702333933585712),
        ("10", "0", [0.1, 0.2], BranchPoint, 0.1420381667926439343143172),
        ("10", "0.1", [0.1, 0.2], BranchPoint, 0.142045148229182661499441),
        ("20", "0", [0.05, 0.1], BranchPoint, 0.07078795806129156749085805),
        ("3", "0", [0.4, 0.55], BranchPoint, 0.4935748239530555698907271),
        ("3", "0.1", [0.4, 0.55], BranchPoint, 0.4938040284701640624120429),
        ("20", "0", [0.4, 0.5], PeriodDoubling, 0.4582185821132727327489322),
        ("50", "0", [0.4, 0.5], PeriodDoubling, 0.4546947789440235111582933),
        ("50", "0", [0.02, 0.04], BranchPoint, 0.02828922038125451586521106),
    ] {
        assert_edge([w, c], PI, range, kind, edge);
    }
    for (w, c, range, kind, edge) in [
        ("1.7", "0", [0.1, 0.3], PeriodDoubling, 0.2028581095994286883789948),
        ("2.1", "0", [0.02, 0.1], PeriodDoubling, 0.04596315261397564494132755),
        ("0.9", "0", [0.7, 0.9], BranchPoint, 0.8645806771921716508765289),
        ("1.2", "0", [1.9, 2.1], BranchPoint, 1.97375129354484162748233),
        ("1.9", "0.1", [0.02, 0.1], PeriodDoubling, 0.07652726367079480844459477),
        ("2.1", "0.1", [0.02, 0.1], PeriodDoubling, 0.06583115527999240741063971),
        ("0.9", "0.1", [0.8, 1.0], BranchPoint, 0.9414380111253381498173565),
        ("1.05", "0.1", [1.0, 1.2], BranchPoint, 1.148296844778395386520132),
    ] {
        assert_edge([w, c], 0.0, range, kind, edge);
    }
}

#[test]
fn the_chart_of_the_upright_pendulum_has_both_edges_and_what_is_between_them_stable() {
    let upright = equation_with(PIVOT, &[("c", "0")]);
    let options = ChartOptions { start: Some(vec![PI, 0.0]), ..REST_ALONE };
    let chart =
        StabilityChart::over(&upright, ["w", "a"], [[10.0, 20.0], [0.01, 0.5]], &options, &Quiet).unwrap();
    assert_eq!(chart.curves.len(), 2);
    assert_at(&chart, SpecialKind::BranchPoint, true, [10.0, 0.1420381667926439343143172]);
    assert_at(&chart, SpecialKind::BranchPoint, true, [20.0, 0.07078795806129156749085805]);
    assert_at(&chart, SpecialKind::PeriodDoubling, true, [20.0, 0.4582185821132727327489322]);
    let ranges = chart.rest_is_stable_at(1).unwrap();
    assert_eq!(ranges.len(), 1);
    assert!((ranges[0][0] - 0.0707879580612916).abs() < 1e-13);
    assert!((ranges[0][1] - 0.4582185821132727).abs() < 1e-13);
}

#[test]
fn tongues_narrower_than_the_grid_are_found() {
    // The second tongue under weak damping, and the first tongue without damping down to its tip.
    let hanging = equation_with(PIVOT, &[("c", "0")]);
    let ranges = [[0.5, 4.5], [0.0, 0.05]];
    let chart = StabilityChart::over(&hanging, ["w", "a"], ranges, &REST_ALONE, &Quiet).unwrap();
    let edges =
        |kind: SpecialKind| chart.curves.iter().filter(|curve| curve.kind == kind).collect::<Vec<_>>();
    let first = edges(SpecialKind::PeriodDoubling);
    assert!(first.len() >= 2, "{} edges", first.len());
    let near_tip = |curve: &&&SpecialCurve| {
        let ends = [curve.points.first(), curve.points.last()];
        ends.into_iter().flatten().any(|end| (end.point.parameter - 2.0).abs() < 0.02 && end.second < 0.01)
    };
    assert!(first.iter().filter(near_tip).count() >= 2);
    // To first order in a the boundaries are at w = 2 ± a·w²/2·… = 2(1 ± a).
    for curve in first.iter().filter(near_tip) {
        for point in curve.points.iter().filter(|point| point.second > 1e-3) {
            let slope = (point.point.parameter / 2.0 - 1.0).abs() / point.second;
            assert!((slope - 1.0).abs() < 0.2, "{slope} at {}", point.second);
        }
    }
}

#[test]
fn folds_of_the_driven_pendulum_meet_in_a_cusp() {
    let driven = equation_with("theta'' = -0.1*theta' - sin(theta) + A*cos(w*t)", &[]);
    let options = ChartOptions { generations: 0, lines: 2, ..ChartOptions::default() };
    let chart =
        StabilityChart::over(&driven, ["w", "A"], [[0.7, 1.0], [0.05, 0.45]], &options, &Quiet).unwrap();
    assert_eq!((chart.curves.len(), &chart.rest), (1, &None));
    assert_at(&chart, SpecialKind::Fold, false, [0.7, 0.4211893702662230667519522]);
    assert_eq!(chart.curves[0].endings, [Ending::RangeEnd; 2]);
    let [cusp] = &chart.curves[0].cusps[..] else { panic!("{:?}", chart.curves[0].cusps) };
    // By Fourier collocation on 48 phases of the half period, with the second derivative of the fold as additional equation.
    let off = [cusp.point.parameter - 0.91477006171658, cusp.second - 0.10145929793157];
    assert!(off.iter().all(|off| off.abs() < 2e-13), "{cusp:?}");
    // Below the cusp there is no fold, above it there are two.
    for (part, folds) in [(0.999, 0), (1.001, 2)] {
        let drive = format!("{:?}", part * cusp.second);
        let at = equation_with("theta'' = -0.1*theta' - sin(theta) + A*cos(w*t)", &[("A", &drive)]);
        let none = ResponseOptions { generations: 0, ..ResponseOptions::default() };
        let response = Response::over(&at, "w", [0.8, 1.0], &none, &Quiet).unwrap();
        assert_eq!(response.branches[0].special.len(), folds, "at {drive}");
    }
}

#[test]
fn folds_of_swings_begin_at_the_edge_of_rest() {
    let hanging = equation_with(PIVOT, &[("c", "0.1")]);
    let options = ChartOptions { lines: 1, ..ChartOptions::default() };
    let ends = [1.512626304330608055862438, 2.2];
    let chart = StabilityChart::over(&hanging, ["w", "a"], [ends, [0.01, 0.2]], &options, &Quiet).unwrap();
    assert_at(&chart, SpecialKind::Fold, false, [ends[0], 0.1]);
    let folds: Vec<&SpecialCurve> =
        chart.curves.iter().filter(|curve| curve.kind == SpecialKind::Fold).collect();
    assert!(folds.len() == 1 && folds[0].endings.contains(&Ending::BranchPoint), "{:?}", folds[0].endings);
    // The motions on the curve shrink to the equilibrium where it ends, on the stability boundary.
    let end = if folds[0].endings[0] == Ending::BranchPoint {
        folds[0].points.first()
    } else {
        folds[0].points.last()
    };
    let end = end.unwrap();
    assert!(end.point.amplitude(0, true) < 0.01);
    let edge =
        chart.curves.iter().find(|curve| curve.kind == SpecialKind::PeriodDoubling && curve.at_rest).unwrap();
    let apart = |point: &CurvePoint| {
        libm::hypot(point.point.parameter - end.point.parameter, point.second - end.second)
    };
    assert!(edge.points.iter().map(apart).fold(f64::INFINITY, f64::min) < 0.02);
}

#[test]
fn losses_of_symmetry_and_second_frequencies_are_followed() {
    let shaken = equation_with("theta'' = -0.1*theta' - sin(theta) + a*w^2*cos(w*t)*cos(theta)", &[]);
    let options = ChartOptions { generations: 0, lines: 1, ..ChartOptions::default() };
    let chart =
        StabilityChart::over(&shaken, ["w", "a"], [[5.0, 20.0], [0.0, 0.4]], &options, &Quiet).unwrap();
    assert_at(&chart, SpecialKind::SymmetryBreaking, false, [5.0, 0.2807823565671525037105779]);
    assert_at(&chart, SpecialKind::SymmetryBreaking, false, [20.0, 0.07067842058025383831445224]);
    assert_eq!(chart.curves.len(), 1);
    let van_der_pol = equation_with("x'' = 0.1*(1 - x^2)*x' - x + F*cos(w*t)", &[]);
    let ranges = [[0.9306613812095431400414873, 1.1], [0.0, 0.3]];
    let chart = StabilityChart::over(&van_der_pol, ["w", "F"], ranges, &options, &Quiet).unwrap();
    assert_at(&chart, SpecialKind::NeimarkSacker, false, [ranges[0][0], 0.2]);
    // Averaged over the fast oscillation: w = 1 ± mu/(2√3), F = 2·mu·√(8/27).
    let cusps: Vec<&CurvePoint> = chart.curves.iter().flat_map(|curve| &curve.cusps).collect();
    assert_eq!(cusps.len(), 2);
    for cusp in cusps {
        assert!(((cusp.point.parameter - 1.0).abs() - 0.0288675).abs() < 1e-3, "{cusp:?}");
        assert!((cusp.second - 0.1088662).abs() < 4e-3, "{cusp:?}");
    }
}

#[test]
fn a_chart_that_is_stopped_has_what_was_done() {
    let hanging = equation_with(PIVOT, &[("c", "0.1")]);
    let progress = |status: Status| {
        if status.done < 6 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let ranges = [[1.5, 2.5], [0.0, 0.2]];
    let chart = StabilityChart::over(&hanging, ["w", "a"], ranges, &REST_ALONE, &progress).unwrap();
    assert!(chart.interrupted && chart.curves.len() == 1);
    assert!(chart.curves[0].endings.contains(&Ending::Interrupted));
}

#[test]
fn what_has_no_chart_says_why() {
    let refused = |text: &str, ranges: [[f64; 2]; 2]| {
        StabilityChart::over(&equation_with(text, &[]), ["w", "a"], ranges, &REST_ALONE, &Quiet).unwrap_err()
    };
    assert_eq!(refused("x'' = -w*x - a*x", [[1.0, 2.0]; 2]), BranchError::NotDriven);
    let flat = [[1.0, 2.0], [1.0, 1.0]];
    assert_eq!(refused("x'' = -a*x + cos(w*t)", flat), BranchError::Range { from: 1.0, to: 1.0 });
    assert!(matches!(refused("x'' = -k*x + a*cos(w*t)", [[1.0, 2.0]; 2]), BranchError::WithoutValue(_)));
}

/// The chart of Mathieu's equation over ranges of d and e, without continuation of driven motions.
fn mathieus(ranges: [[f64; 2]; 2]) -> StabilityChart {
    let equation = "x'' + (d + e*cos(t))*x = 0".parse().unwrap();
    let options = ChartOptions { lines: 0, ..ChartOptions::default() };
    StabilityChart::over(&equation, ["d", "e"], ranges, &options, &Quiet).unwrap()
}

/// Beyond d = 0 the strip between the first two boundaries of Mathieu's equation is 0.03 wide, half an interval of the grid.
#[test]
fn strips_narrower_than_the_grid_are_told() {
    let chart = mathieus([[-0.5, 2.5], [0.0, 2.0]]);
    let ranges = chart.rest_is_stable_at(0).unwrap();
    // By SciPy's monodromy matrix: multipliers of 3.2 at 1.18, of modulus 1 from 1.195 to 1.22, of 2.6 at 1.23.
    assert_eq!(ranges.len(), 1);
    assert!(
        ranges[0][0] > 1.18 && ranges[0][0] < 1.195 && ranges[0][1] > 1.22 && ranges[0][1] < 1.23,
        "{ranges:?}"
    );
}

const TWO: &str = "x'' + c*x' + (1 + m*cos(2*w*t))*x + 0.27*y + x^3 = 0; y'' + c*y' + 1.25*y + 0.27*x + m*0.27*cos(2*w*t)*y = 0";

/// The boundaries of an equilibrium at the greatest value of the second parameter, in order.
fn upper_ends(chart: &StabilityChart, second: f64) -> Vec<(SpecialKind, f64)> {
    let mut all = vec![];
    for curve in &chart.curves {
        let at_top = curve.points.iter().filter(|point| point.second.to_bits() == second.to_bits());
        let mut ends: Vec<(SpecialKind, f64)> =
            at_top.map(|at_top| (curve.kind, at_top.point.parameter)).collect();
        // A curve that was found on the edge of the map has two points there.
        ends.sort_by(|a, b| a.1.total_cmp(&b.1));
        ends.dedup_by(|a, b| (a.1 - b.1).abs() < 1e-9);
        all.extend(ends);
    }
    all.sort_by(|a, b| a.1.total_cmp(&b.1));
    all
}

fn assert_upper_ends(chart: &StabilityChart, second: f64, expected: &[f64], accuracy: f64) {
    let ends = upper_ends(chart, second);
    assert_eq!(ends.len(), expected.len(), "{ends:?}");
    for ((_, computed), expected) in ends.iter().zip(expected) {
        assert!((computed - expected).abs() < accuracy, "{computed:?} for {expected:?}");
    }
}

/// Borders by SciPy's DOP853 with rtol 1e-13: zeros of the discriminant 2(tr M² + 4) − (tr M)² of the monodromy matrix without
/// damping, and of the largest modulus of its eigenvalues less one with damping.
#[test]
fn combination_resonances_are_found_without_damping_and_with_little() {
    for (c, expected) in
        [("0", [1.0438442783027, 1.0596338723294]), ("0.0004", [1.0438467552729, 1.0596313540503])]
    {
        let equation = equation_with(TWO, &[("c", c)]);
        let ranges = [[0.98, 1.11], [0.0333333, 0.1]];
        let chart = StabilityChart::over(&equation, ["w", "m"], ranges, &REST_ALONE, &Quiet).unwrap();
        assert_upper_ends(&chart, 0.1, &expected, 1e-9);
        assert!(chart.curves.iter().all(|curve| curve.kind == SpecialKind::NeimarkSacker), "damping {c}");
        assert_eq!(chart.rest.unwrap().unresolved, [[0.0; 2]; 0]);
    }
}

/// The tongue by SciPy's zeros of Π(μ − 1), Π(μ + 1) at the greatest m; it is a two-thousandth of the map wide.
#[test]
fn both_borders_of_a_narrow_tongue_are_followed_once() {
    let equation = equation_with(TWO, &[("c", "0")]);
    let ranges = [[0.55, 0.65], [0.0333333, 0.1]];
    let chart = StabilityChart::over(&equation, ["w", "m"], ranges, &REST_ALONE, &Quiet).unwrap();
    let ends = upper_ends(&chart, 0.1);
    let near = |expected: f64| ends.iter().filter(|end| (end.1 - expected).abs() < 1e-8).count();
    assert_eq!([near(0.5960813310), near(0.5963899479)], [1, 1], "{ends:?}");
}

/// The third tongue of Mathieu's equation, by SciPy's DOP853, lies in the first interval of the grid.
#[test]
fn a_tongue_next_to_the_edge_of_a_map_is_found() {
    let equation = equation_with("x'' + 0.0004*x' + (1 + m*cos(2*w*t))*x + x^3 = 0", &[]);
    let ranges = [[0.33, 1.32], [0.1, 0.3]];
    let chart = StabilityChart::over(&equation, ["w", "m"], ranges, &REST_ALONE, &Quiet).unwrap();
    let ends = upper_ends(&chart, 0.3);
    let inside = ends.iter().filter(|end| end.1 < 0.34).count();
    assert_eq!(inside, 2, "{ends:?}");
    assert!(ends.windows(2).all(|pair| pair[1].1 - pair[0].1 > 1e-9), "{ends:?}");
}

/// cos(wt)² = (1 + cos(2wt))/2: both forms of an equation have the same boundaries, of the same kinds.
#[test]
fn the_kind_of_a_boundary_is_that_over_the_least_period() {
    let over = |text: &str| {
        let ranges = [[0.8, 1.3], [0.1, 0.6]];
        let chart = StabilityChart::over(&equation_with(text, &[]), ["w", "m"], ranges, &REST_ALONE, &Quiet);
        upper_ends(&chart.unwrap(), 0.6)
    };
    let squared = over("x'' + 0.04*x' + (1 + m*cos(w*t)^2)*x + x^3 = 0");
    let doubled = over("x'' + 0.04*x' + (1 + m/2 + m/2*cos(2*w*t))*x + x^3 = 0");
    assert!(squared.iter().any(|end| end.0 == SpecialKind::PeriodDoubling), "{squared:?}");
    assert_eq!(squared.len(), doubled.len());
    for (a, b) in squared.iter().zip(&doubled) {
        assert!(a.0 == b.0 && (a.1 - b.1).abs() < 1e-12, "{a:?} {b:?}");
    }
}

/// The first boundary of Mathieu's equation begins at d = 0.
#[test]
fn the_error_of_a_boundary_at_zero_contains_that_of_the_multipliers() {
    let chart = mathieus([[-0.5, 0.5], [0.0, 1.0]]);
    let all = chart.curves.iter().filter(|curve| curve.kind == SpecialKind::BranchPoint);
    let start = all.flat_map(|curve| &curve.points).find(|point| point.second == 0.0).unwrap();
    assert!(
        start.point.parameter.abs() <= start.point.error,
        "{:e} {:e}",
        start.point.parameter,
        start.point.error
    );
}

/// A pendulum whose pivot moves up and down, and a driven spring, about zero and about another angle and length.
#[test]
fn charts_about_another_centre_are_the_same() {
    let chart = |equation: String, ranges: [[f64; 2]; 2], lines: u32| {
        let options = ChartOptions { lines, ..ChartOptions::default() };
        StabilityChart::over(&equation_with(&equation, &[]), ["w", "a"], ranges, &options, &Quiet).unwrap()
    };
    let pivot = |x: &str| format!("x'' = -x'/10 - (1 - a*w^2*cos(w*t))*sin({x})");
    let spring = |x: &str| format!("x'' = -x'/10 - {x} - {x}^3 + a*cos(w*t)");
    // Nearest to zero is the top of the last.
    let torque = |x: &str| format!("x'' = -0.1619*x' - sin({x}) + a*cos(w*t)");
    let near_two = [[1.5, 2.5], [0.1, 0.9]];
    for (equation, elsewhere, ranges) in [
        (&pivot as &dyn Fn(&str) -> String, "(x - 0.73)", near_two),
        (&spring, "(x - 0.73)", near_two),
        (&torque, "(x - 1.7)", [[0.4, 1.2], [0.05, 0.5]]),
    ] {
        let [centred, shifted] = ["x", elsewhere].map(|x| chart(equation(x), ranges, 1));
        assert_eq!(centred.rest.is_some(), shifted.rest.is_some(), "{}", equation("x"));
        assert!(!centred.curves.is_empty(), "{}", equation("x"));
        let outline = |chart: &StabilityChart| -> Vec<(SpecialKind, bool, bool, [f64; 2])> {
            let mut curves: Vec<_> = chart
                .curves
                .iter()
                .map(|curve| {
                    let [first, last] =
                        [curve.points.first(), curve.points.last()].map(|point| point.unwrap().second);
                    (curve.kind, curve.at_rest, curve.space.mirrored, [first, last])
                })
                .collect();
            curves.sort_by(|a, b| a.3[0].total_cmp(&b.3[0]));
            curves
        };
        let [centred, shifted] = [&centred, &shifted].map(outline);
        assert_eq!(centred.len(), shifted.len(), "{centred:?}; {shifted:?}");
        for (a, b) in centred.iter().zip(&shifted) {
            assert_eq!((a.0, a.1, a.2), (b.0, b.1, b.2), "{centred:?}; {shifted:?}");
            assert!(a.3.iter().zip(b.3).all(|(a, b)| (a - b).abs() < 1e-9), "{centred:?}; {shifted:?}");
        }
    }
}
