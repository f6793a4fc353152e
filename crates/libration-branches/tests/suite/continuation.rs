//! Branches of periodic motions compared with two other methods, which agree in 30 digits unless stated otherwise: Fourier collocation with
//! extended systems, and Taylor shooting with the variational equations, both in floats of 130 bits.

use crate::typed::equation_with;
use libration::algebra::Complex;
use libration::continuation::{
    Branch, BranchError, BranchPoint, Ending, Jump, Origin, Response, ResponseOptions, SpecialKind,
};
use libration::expression::Equation;
use libration::progress::{Quiet, Status};
use libration::quantity::Angle;
use libration::taylor::{Effort, Moment, System, integrate};
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

const PENDULUM: &str = "theta'' = -c*theta' - sin(theta) + A*cos(w*t)";

fn over(equation: &Equation, parameter: &str, range: [f64; 2]) -> Response {
    let options = ResponseOptions { generations: 1, ..ResponseOptions::default() };
    Response::over(equation, parameter, range, &options, &Quiet).unwrap()
}

fn specials(response: &Response, kind: SpecialKind) -> Vec<f64> {
    let special = response.branches.iter().flat_map(|branch| &branch.special);
    special.filter(|special| special.kind == kind).map(|special| special.point.parameter).collect()
}

/// Asserts that one of the special points of a kind is at a value, to 12 digits and within its stated error.
fn assert_special(response: &Response, kind: SpecialKind, expected: f64, amplitude: Option<f64>) {
    let special =
        response.branches.iter().flat_map(|branch| &branch.special).filter(|special| special.kind == kind);
    let off = |parameter: f64| (parameter - expected).abs();
    let nearest = special.min_by(|a, b| off(a.point.parameter).total_cmp(&off(b.point.parameter)));
    let nearest = nearest.unwrap_or_else(|| panic!("no {kind} at {expected}"));
    let parameter = nearest.point.parameter;
    assert!(off(parameter) <= 1e-12 * expected, "{kind} at {parameter:?} for {expected:?}");
    assert!(
        off(parameter) <= nearest.error.max(2e-13 * expected),
        "{kind} at {parameter:?} ± {:e} for {expected:?}",
        nearest.error
    );
    if let Some(amplitude) = amplitude {
        let computed = nearest.point.amplitude(0, true);
        assert!((computed - amplitude).abs() < 1e-11, "{kind}: amplitude {computed:?} for {amplitude:?}");
    }
}

#[test]
fn folds_of_the_driven_pendulum_are_exact() {
    let over_frequency = [
        (["0.1", "0.15"], [0.6, 1.2], 0.8721575691379171688795389, 0.910968343596304066),
        (["0.02", "0.03"], [0.8, 1.1], 0.9551194895409523057690497, 0.505695523476957057),
        (["0.2", "0.32"], [0.6, 1.2], 0.7855183495770513073720936, 1.21672100780130924),
    ];
    for ([c, a], range, value, amplitude) in over_frequency {
        let response = over(&equation_with(PENDULUM, &[("c", c), ("A", a)]), "w", range);
        assert_special(&response, SpecialKind::Fold, value, Some(amplitude));
    }
    let over_amplitude = [
        (["0.1", "0.7"], [0.1, 0.45], 0.4211893702662230667519522, 1.24503010174801422),
        (["0.02", "0.9"], [0.0, 0.1], 0.09223553605572827970804111, 0.729620901589684041),
    ];
    for ([c, w], range, value, amplitude) in over_amplitude {
        let response = over(&equation_with(PENDULUM, &[("c", c), ("w", w)]), "A", range);
        assert_special(&response, SpecialKind::Fold, value, Some(amplitude));
    }
}

#[test]
fn losses_of_symmetry_and_doublings_are_exact_and_each_branch_is_followed_once() {
    let response = over(&equation_with(PENDULUM, &[("c", "1/2"), ("w", "2/3")]), "A", [0.9, 1.07]);
    assert_special(
        &response,
        SpecialKind::SymmetryBreaking,
        1.004319477426467863662657,
        Some(2.66092145730151213),
    );
    assert_special(&response, SpecialKind::PeriodDoubling, 1.06637286245520700528907, None);
    let asymmetric =
        response.branches.iter().filter(|branch| !branch.space.mirrored && branch.space.drive_periods() == 1);
    assert_eq!(
        asymmetric.count(),
        1,
        "{:?}",
        response.branches.iter().map(|branch| (branch.origin, branch.space)).collect::<Vec<_>>()
    );
    assert!(specials(&response, SpecialKind::Fold).is_empty());
    let doubled: Vec<&Branch> =
        response.branches.iter().filter(|branch| branch.origin == Origin::PeriodDoubling).collect();
    assert_eq!(doubled.len(), 1);
    // The doubled branch begins at its period doubling, stable, with twice the period.
    let [first, second] = [&doubled[0].points[0], &doubled[0].points[1]];
    assert!(
        (first.parameter - 1.066372862455207).abs() < 1e-12
            && second.is_stable()
            && second.parameter > first.parameter
    );
    assert!((second.period - 6.0 * PI).abs() < 1e-12);
    // Continuation in the damping; a published notebook has Q about 1.348.
    let response = over(&equation_with(PENDULUM, &[("A", "1.5"), ("w", "2/3")]), "c", [0.735, 0.78]);
    assert_special(&response, SpecialKind::PeriodDoubling, 0.7411730170883635402983935, None);
}

#[test]
fn curves_of_duffings_oscillator_have_their_folds_and_no_others() {
    let duffing = "x'' = -c*x' - x - b*x^3 + F*cos(w*t)";
    let response =
        over(&equation_with(duffing, &[("c", "0.1"), ("b", "-1"), ("F", "0.05")]), "w", [0.7, 1.2]);
    assert_special(&response, SpecialKind::Fold, 0.8927792130704409856717577, None);
    let response =
        over(&equation_with(duffing, &[("c", "0.1"), ("b", "-0.1"), ("F", "0.1")]), "w", [0.5, 1.5]);
    assert_eq!(response.branches.len(), 1);
    assert_eq!(response.branches[0].special, []);
    assert!(response.branches[0].points.iter().all(|point| point.is_stable()));
    // The subharmonic response of order 1/3 is an isola, which a start near it finds.
    let options = ResponseOptions {
        start: Some(vec![3.06, 3.95]),
        drive_periods: 3,
        generations: 0,
        ..ResponseOptions::default()
    };
    let subharmonic = equation_with(duffing, &[("c", "0.05"), ("b", "1"), ("F", "5")]);
    let response = Response::over(&subharmonic, "w", [9.0, 10.5], &options, &Quiet).unwrap();
    assert_special(&response, SpecialKind::Fold, 10.02822141013707399662466, None);
    assert_eq!(response.branches[0].space.drive_periods(), 3);
}

#[test]
fn a_curve_that_closes_is_followed_once_around() {
    let duffing = equation_with("x'' = -0.15*x' - x - x^3 + 5*cos(w*t)", &[]);
    let options = ResponseOptions {
        start: Some(vec![1.4, 1.5]),
        at: Some(4.5),
        drive_periods: 3,
        generations: 0,
        ..ResponseOptions::default()
    };
    let response = Response::over(&duffing, "w", [2.5, 6.0], &options, &Quiet).unwrap();
    let branch = &response.branches[0];
    assert_eq!((response.branches.len(), branch.ending), (1, Ending::Closed));
    assert_eq!(branch.points.first(), branch.points.last());
    // A fold may be met once, or once for each of the three phases, which differ by periods of the drive and follow each other on the curve.
    let folds = specials(&response, SpecialKind::Fold);
    assert!(
        folds.iter().any(|w| (w - 5.294354133015116).abs() < 1e-5)
            && folds.iter().any(|w| (w - 3.64886).abs() < 1e-5)
    );
    assert!(folds.len() == 2 || folds.len() == 6, "{folds:?}");
    let outside = ResponseOptions { at: Some(7.0), ..options };
    assert!(matches!(
        Response::over(&duffing, "w", [2.5, 6.0], &outside, &Quiet),
        Err(BranchError::Outside { .. })
    ));
}

#[test]
fn a_determinant_of_one_is_a_bifurcation_where_multipliers_are_complex() {
    let van_der_pol = "x'' = mu*(1 - x^2)*x' - x + F*cos(w*t)";
    let response = over(&equation_with(van_der_pol, &[("mu", "1"), ("F", "1")]), "w", [0.5, 1.3]);
    assert_special(&response, SpecialKind::NeimarkSacker, 0.5439378644861768229010272, None);
    assert_special(&response, SpecialKind::Fold, 1.196077164552389013827867, None);
    // By the same two methods: the determinant is one there, and the trace 2.89.
    let saddles = specials(&response, SpecialKind::NeutralSaddle);
    assert!(saddles.len() == 1 && (saddles[0] - 1.17072).abs() < 1e-5, "{saddles:?}");
    assert_eq!(specials(&response, SpecialKind::NeimarkSacker).len(), 1);
    let response = over(&equation_with(van_der_pol, &[("mu", "0.1"), ("F", "0.2")]), "w", [0.8, 1.0]);
    assert_special(&response, SpecialKind::NeimarkSacker, 0.9306613812095431400414873, None);
}

#[test]
fn without_damping_every_determinant_is_one_and_none_is_special() {
    let response = over(&equation_with(PENDULUM, &[("c", "0"), ("A", "0.1")]), "w", [0.4, 1.4]);
    assert!(specials(&response, SpecialKind::NeutralSaddle).is_empty());
    assert!(specials(&response, SpecialKind::NeimarkSacker).is_empty());
}

#[test]
fn neighbouring_branches_are_not_mistaken_for_each_other() {
    // The amplitudes of the two branches at w = 0.85 differ by 0.05.
    let response = over(&equation_with(PENDULUM, &[("c", "0.02"), ("A", "0.03")]), "w", [0.85, 1.4]);
    assert_eq!(response.branches.len(), 2);
    let [low, high] = [0, 1].map(|number| response.branches[number].points.last().unwrap());
    assert_eq!((low.parameter, high.parameter), (0.85, 0.85));
    assert!((low.amplitude(0, true) - 1.5277505972561323741).abs() < 1e-12 && !low.is_stable());
    let multipliers = [0.6822691251387183, 1.2642656414894033];
    for (computed, expected) in low.multipliers.iter().rev().zip(multipliers) {
        assert!((computed.re - expected).abs() < 1e-11 && computed.im.abs() < 1e-300, "{computed:?}");
    }
    assert!(high.is_stable() && (high.amplitude(0, true) - 1.58).abs() < 0.01, "{}", high.amplitude(0, true));
}

#[test]
fn a_strong_drive_leads_over_the_top_and_to_the_frequency_zero() {
    let pendulum = |a: &str| equation_with(PENDULUM, &[("c", "0.1"), ("A", a)]);
    let options = ResponseOptions { generations: 0, ..ResponseOptions::default() };
    let response = Response::over(&pendulum("0.2"), "w", [0.3, 1.4], &options, &Quiet).unwrap();
    let last = response.branches.iter().map(|branch| branch.points.last().unwrap());
    assert!(last.into_iter().any(|point| point.parameter == 0.3 && point.amplitude(0, false) > PI));
    let response = Response::over(&pendulum("0.15"), "w", [0.0, 1.4], &options, &Quiet).unwrap();
    assert_eq!(response.branches[0].ending, Ending::SlowDrive);
    assert_eq!(specials(&response, SpecialKind::Fold).len(), 2);
    // By shooting with Taylor series in 30 digits (mpmath).
    assert_special(&response, SpecialKind::Fold, 0.7806326535189842983411319, None);
}

#[test]
fn the_shaken_pendulum_swings_from_one_edge_of_its_tongue_to_the_other() {
    let shaken = equation_with("theta'' = -0.1*theta' - (1 - 0.1*w^2*cos(w*t))*sin(theta)", &[]);
    let response = over(&shaken, "w", [1.5, 2.5]);
    assert!(response.branches[0].points.iter().all(|point| point.amplitude(0, true) == 0.0));
    let edges = specials(&response, SpecialKind::PeriodDoubling);
    assert_eq!(edges.len(), 2);
    let swings: Vec<&Branch> =
        response.branches.iter().filter(|branch| branch.origin == Origin::PeriodDoubling).collect();
    assert_eq!((swings.len(), swings[0].ending), (1, Ending::BranchPoint));
    // Both ends of the swings are at rest, which is unstable only between the edges.
    let at_two: Vec<&BranchPoint> =
        response.branches[0].points.iter().filter(|point| !point.is_stable()).collect();
    assert!(at_two.iter().all(|point| (edges[0]..=edges[1]).contains(&point.parameter)));
    let within = over(&shaken, "w", [1.9, 2.0]);
    let at_ends = |branch: &Branch| {
        [&branch.points[0], branch.points.last().unwrap()].map(|point| point.amplitude(0, true))
    };
    assert_eq!(at_ends(&within.branches[0]), [0.0, 0.0], "the range has no edge");
    assert_eq!(within.branches.len(), 2);
    let options = ResponseOptions {
        start: Some(vec![0.3, 0.97]),
        drive_periods: 2,
        generations: 0,
        ..ResponseOptions::default()
    };
    let swing = Response::over(&shaken, "w", [1.9, 2.0], &options, &Quiet).unwrap();
    // The drive leaves the pendulum at rest, so that swings of twice its period are searched without these options too.
    for ends in [&swing.branches[0], &within.branches[1]].map(at_ends) {
        for expected in [1.3244542926298063671, 1.0834319329429958589] {
            assert!(ends.iter().any(|end| (end - expected).abs() < 1e-12), "{expected} in {ends:?}");
        }
    }
}

/// The state after a number of drive periods by the integrator, at the drive frequency `frequency`.
fn followed(equation: &Equation, frequency: f64, mut state: Vec<f64>, periods: u32) -> Vec<f64> {
    let exact = format!("{frequency:?}").parse().unwrap();
    let system = System::new(&equation.with(&[("w", exact)]).unwrap()).unwrap();
    for _ in 0..periods {
        let start = Moment { time: 0.0, state };
        let solution = integrate(&system, &start, &[TAU / frequency], &Effort::to_tolerance(1e-15), &Quiet);
        state = solution.unwrap().end.state;
    }
    state
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn sweeps_of_the_integrator_land_on_the_stable_branches() {
    let pendulum = equation_with(PENDULUM, &[("c", "0.1"), ("A", "0.15")]);
    let response = over(&pendulum, "w", [0.5, 1.2]);
    let branch = &response.branches[0];
    let fold = branch.special[0].before;
    let upwards: Vec<&BranchPoint> = branch.points[..fold].iter().step_by(4).collect();
    let downwards: Vec<&BranchPoint> = branch
        .points
        .iter()
        .rev()
        .filter(|point| point.parameter > 0.8)
        .take_while(|point| point.is_stable())
        .step_by(4)
        .collect();
    assert!(upwards.len() > 2 && downwards.len() > 2);
    for points in [upwards, downwards] {
        let mut state = points[0].state.iter().map(|x| x + 0.01).collect::<Vec<f64>>();
        for point in points {
            state = followed(&pendulum, point.parameter, state, 90);
            let off = apart(&state, &point.state);
            assert!(off < 1e-9, "{off:e} at {}", point.parameter);
        }
    }
    let jumps = &response.jumps;
    assert_eq!(jumps.iter().map(|jump| jump.rising).collect::<Vec<_>>(), [true, false]);
    assert!(jumps.iter().all(|jump| jump.to.len() == 1), "{jumps:?}");
    // The state in which the integrator settles beyond the first fold; SciPy's
    // integrator with the shooting of another library gives 89.1191735153°.
    let landing = &jumps[0].to[0];
    assert!(
        (landing.amplitude(0, true).to_degrees() - 89.119173515280).abs() < 1e-9 && landing.error < 1e-12
    );
    for jump in jumps {
        assert_eq!(jump.to[0].parameter.to_bits(), jump.from.parameter.to_bits());
        let state = followed(&pendulum, jump.from.parameter, jump.to[0].state.clone(), 1);
        assert!(apart(&state, &jump.to[0].state) < 1e-12, "{jump:?}");
    }
}

#[test]
fn jumps_of_an_interrupted_response_lead_to_the_nearest_points_and_say_how_far_that_may_be() {
    let pendulum = equation_with(PENDULUM, &[("c", "0.1"), ("A", "0.15")]);
    let whole = over(&pendulum, "w", [0.7, 1.0]);
    let most = whole.branches[0].points.len() - 3;
    let progress = |status: Status| {
        if status.done < most { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let options = ResponseOptions::default();
    let response = Response::over(&pendulum, "w", [0.7, 1.0], &options, &progress).unwrap();
    assert!(response.interrupted && response.jumps.len() == 2);
    for (jump, exact) in response.jumps.iter().zip(&whole.jumps) {
        let off = apart(&jump.to[0].state, &exact.to[0].state);
        assert!(off > 1e-6 && off < jump.to[0].error && jump.to[0].error < 0.2, "{off:e}: {jump:?}");
    }
}

#[test]
fn multipliers_of_two_coordinates_have_the_product_that_the_damping_tells() {
    let pair = equation_with("x'' = -x + y - 0.1*x' - x^3 + 0.3*cos(w*t); y'' = x - 2*y - 0.1*y'", &[]);
    let response = over(&pair, "w", [0.9, 1.2]);
    let branch = &response.branches[0];
    for point in &branch.points {
        let product = point.multipliers.iter().fold(Complex::from(1.0), |a, b| a * *b);
        assert!(
            (product.re - libm::exp(-0.2 * point.period)).abs() < 1e-12,
            "{product:?} at {}",
            point.parameter
        );
    }
    assert!(
        !specials(&response, SpecialKind::Fold).is_empty()
            && specials(&response, SpecialKind::BranchPoint).is_empty()
    );
}

#[test]
fn what_has_no_branch_says_why() {
    let refused = |text: &str, range: [f64; 2]| {
        Response::over(&equation_with(text, &[]), "w", range, &ResponseOptions::default(), &Quiet)
            .unwrap_err()
    };
    assert_eq!(refused("x'' = -x + w*t", [1.0, 2.0]), BranchError::NotDriven);
    assert_eq!(refused("x'' = -x + cos(w*t)", [1.0, 1.0]), BranchError::Range { from: 1.0, to: 1.0 });
    assert!(matches!(refused("x'' = -x + cos(w*t)", [1.0, f64::NAN]), BranchError::Range { .. }));
    assert!(matches!(refused("x'' = -k*x + cos(w*t)", [1.0, 2.0]), BranchError::WithoutValue(_)));
    // Without damping the response is unbounded at resonance, which lies at either end of the range.
    assert!(matches!(refused("x'' = -x + w*cos(t)", [1.0, 2.0]), BranchError::NoStart(_)));
}

/// Exact by the elliptic integral; a drive at twice the parameter repeats together with an oscillation at half its frequency.
#[test]
fn the_backbone_is_that_of_the_frequency_of_the_drive() {
    let pendulum = libration::pendulum::Pendulum::from_angular_frequency(1.0).unwrap();
    let exact = |amplitude: f64| {
        TAU / pendulum.released_from(Angle::from_radians(amplitude).unwrap()).unwrap().period()
    };
    for (factor, range) in [("", [0.6, 1.2]), ("2*", [0.3, 0.6])] {
        let text = format!("theta'' = -0.1*theta' - sin(theta) + 0.15*cos({factor}w*t)");
        let driven = equation_with(&text, &[]);
        let backbone = over(&driven, "w", range).backbone(&driven, range, true);
        assert_eq!(backbone.len(), 80, "{text}");
        for free in backbone {
            let parameter = exact(free.amplitude) * range[0] / 0.6;
            assert!((free.parameter - parameter).abs() <= free.error && free.error < 1e-13, "{free:?}");
        }
    }
    // The backbone curve is empty for an amplitude of the drive, and for a frequency on which the oscillator depends too.
    let empty = |text: &str, parameter: &str, range: [f64; 2]| {
        let driven = equation_with(text, &[]);
        assert_eq!(over(&driven, parameter, range).backbone(&driven, range, true), [], "{text}");
    };
    empty("theta'' = -0.1*theta' - sin(theta) + A*cos(0.9*t)", "A", [0.01, 0.1]);
    empty("x'' = -0.1*x' - w*x + 0.15*cos(w*t)", "w", [0.6, 1.2]);
}

/// Every change of stability along a branch is at a special point, or it is listed.
#[test]
fn changes_of_stability_without_a_special_point_are_listed() {
    let equation = "x'' = -0.1*x' - x - x^3 + 0.3*cos(w*t)".parse().unwrap();
    let response = Response::over(&equation, "w", [0.5, 2.0], &ResponseOptions::default(), &Quiet).unwrap();
    let mut branch = response.branches[0].clone();
    assert_eq!((branch.special.len(), branch.unexplained_changes().len()), (2, 0));
    let folds: Vec<f64> = branch.special.drain(..).map(|fold| fold.point.parameter).collect();
    let changes = branch.unexplained_changes();
    let is_near = |fold: &f64| changes.iter().any(|[low, high]| (low - 1e-2..high + 1e-2).contains(fold));
    assert!(changes.len() == 2 && folds.iter().all(is_near), "{changes:?} {folds:?}");
}

/// No estimate at an end of the range leads to the motion after this jump. SciPy's `solve_ivp` (DOP853, tolerance 1e-11) settles there to a largest
/// displacement of 1.55227617, of 40 000 samples.
#[test]
fn a_branch_is_found_by_the_jump_to_it() {
    let double_well = equation_with("x'' = -0.083*x' + x - 2.207*x^3 + 1.153*cos(w*t)", &[]);
    let options = ResponseOptions { generations: 0, ..ResponseOptions::default() };
    let response = Response::over(&double_well, "w", [0.5, 2.2], &options, &Quiet).unwrap();
    assert!(response.branches.iter().any(|branch| branch.origin == Origin::Jump));
    let jump = response.jumps.iter().find(|jump| (jump.from.parameter - 0.539_348_866_507_7).abs() < 1e-12);
    let Some(Jump { rising: true, to, .. }) = jump else { panic!("{:?}", response.jumps) };
    let amplitudes: Vec<f64> = to.iter().map(|point| point.amplitude(0, false)).collect();
    assert!(
        matches!(amplitudes[..], [amplitude] if (amplitude - 1.552_276_17).abs() < 5e-8),
        "{amplitudes:?}"
    );
}

/// The motion over both wells is unstable at both ends of the range. At w = 1.5 SciPy's `solve_ivp` (DOP853, tolerance 1e-11) settles to it, with the
/// amplitude 3.55599423151. Which solution the search meets first depends on the phase of the drive.
#[test]
fn a_motion_between_wells_that_is_stable_within_the_range_only_is_found() {
    let options = ResponseOptions { generations: 0, ..ResponseOptions::default() };
    for wave in ["cos", "sin"] {
        let double_well = format!("x'' = -0.097*x' + x - 0.38*x^3 + 0.639*{wave}(w*t)");
        let response =
            Response::over(&equation_with(&double_well, &[]), "w", [0.5, 2.2], &options, &Quiet).unwrap();
        let is_between = |point: &BranchPoint| point.is_stable() && point.amplitude(0, false) > 3.0;
        let between = response.branches.iter().find(|branch| branch.points.iter().any(is_between));
        let branch = between.unwrap_or_else(|| panic!("{wave}"));
        assert!(branch.space.mirrored, "{wave}");
        let stable = branch.points.windows(2).filter(|pair| pair.iter().all(is_between));
        let enclosing = stable.filter(|pair| (pair[0].parameter < 1.5) != (pair[1].parameter < 1.5));
        let amplitudes: Vec<f64> = enclosing.map(|pair| amplitude_at(pair, 1.5)).collect();
        assert!(
            matches!(amplitudes[..], [amplitude] if (amplitude - 3.555_994_231_51).abs() < 1e-3),
            "{wave}: {amplitudes:?}"
        );
        let fold = branch.special.iter().find(|special| special.kind == SpecialKind::Fold);
        assert!((fold.unwrap().point.parameter - 1.747_284_743_011_8).abs() < 1e-12, "{wave}: {fold:?}");
    }
}

/// The amplitude at a value between two points, on the line through them.
fn amplitude_at(pair: &[BranchPoint], value: f64) -> f64 {
    let part = (value - pair[0].parameter) / (pair[1].parameter - pair[0].parameter);
    let [from, to] = [&pair[0], &pair[1]].map(|point| point.amplitude(0, false));
    from + part * (to - from)
}
