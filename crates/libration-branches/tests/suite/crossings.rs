//! Crossings of branches of periodic motions, and similar cases, compared with closed forms and integrations by other programs.

use libration::continuation::{Branch, BranchError, Ending, Response, ResponseOptions, SpecialKind};
use libration::expression::Equation;
use libration::progress::Quiet;
use std::f64::consts::PI;

fn over(equation: &str, parameter: &str, range: [f64; 2], options: ResponseOptions) -> Response {
    let options = ResponseOptions { generations: 0, ..options };
    Response::over(&equation.parse().unwrap(), parameter, range, &options, &Quiet).unwrap()
}

fn specials(branch: &Branch, kind: SpecialKind) -> Vec<f64> {
    branch
        .special
        .iter()
        .filter(|special| special.kind == kind)
        .map(|special| special.point.parameter)
        .collect()
}

#[test]
fn a_crossing_at_a_rest_that_is_known_to_rounding_only_is_exact() {
    // `f64` π is 1.2e-16 off, so the sine there is not zero. By Hill's matrix and Taylor series, both in floats of 130 bits.
    let upright = "theta'' = -0.1*theta' - (1 - 100*a*cos(10*t))*sin(theta)";
    let options = ResponseOptions { start: Some(vec![PI, 0.0]), ..ResponseOptions::default() };
    let response = over(upright, "a", [0.1, 0.6], options);
    let crossings = specials(&response.branches[0], SpecialKind::BranchPoint);
    assert!(
        crossings.len() == 1 && (crossings[0] - 0.142045148229182661499441).abs() < 1e-14,
        "{crossings:?}"
    );
}

#[test]
fn two_folds_within_one_step_are_found() {
    // By shooting with SciPy's DOP853 at 2.3e-14 and the variational equations; a cusp is nearby.
    let duffing = "x'' = -0.1*x' - x - 0.1*x^3 + 0.1625*cos(w*t)";
    let response = over(duffing, "w", [0.5, 1.6], ResponseOptions::default());
    let folds = specials(&response.branches[0], SpecialKind::Fold);
    let expected = [1.0901589521540422, 1.0901580480331612];
    assert!(folds.len() == 2 && folds.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-13), "{folds:?}");
}

#[test]
fn a_second_oscillator_that_comes_back_with_the_drive_adds_no_singular_point() {
    // The multipliers of the second oscillator are −1 and −1, or 1 and 1, at the two frequencies.
    for times in ["12.25", "16"] {
        let pair = format!("x'' = -0.1*x' - sin(x) + 0.2*cos(w*t) + 0.1*sin(w*t)^2; y'' = -{times}*w^2*y");
        let response = over(&pair, "w", [1.05, 2.1], ResponseOptions::default());
        let [branch] = &response.branches[..] else { panic!("{} branches", response.branches.len()) };
        assert!(branch.ending == Ending::RangeEnd && branch.special.is_empty(), "{:?}", branch.special);
    }
}

#[test]
fn a_branch_that_turns_back_where_it_crosses_another_one_has_no_fold_there() {
    // y is zero on one branch. With x = 10·F·sin t, the other branch leaves it where y″ + y′/50
    // + (1 − 10·F·sin t)·y = 0 has the multiplier 1: by Taylor series in 30 digits (mpmath).
    let pair = "x'' = -0.1*x' - x + F*cos(t); y'' = -0.02*y' - (1 - x)*y + y^3";
    let options = ResponseOptions { start: Some(vec![0.0, 0.5, 0.0, 0.0]), ..ResponseOptions::default() };
    let response = over(pair, "F", [0.001, 0.3], options);
    assert_eq!(response.branches.len(), 2);
    for branch in &response.branches {
        let crossings: Vec<_> =
            branch.special.iter().filter(|special| special.kind == SpecialKind::SymmetryBreaking).collect();
        assert_eq!((crossings.len(), specials(branch, SpecialKind::Fold)), (1, vec![]));
        let off = (crossings[0].point.parameter - 0.0328535739955020294313792134768).abs();
        assert!(off < 1e-12 && off <= crossings[0].error, "{off:e} {:e}", crossings[0].error);
    }
}

/// y → −y is a symmetry without a shift in time. The motion in the plane y = 0 loses it where y″ + y′/5 + (1/2 − x² − 3x/10)·y = 0, with x =
/// 10·F·sin t, has the multiplier 1: by SciPy's DOP853 at 1e-13. With a constant force on y there is no such symmetry and no crossing.
#[test]
fn a_mirror_image_of_some_coordinates_without_a_shift_is_recognised() {
    for (force, lost) in [("", 1), (" + 1/1000", 0)] {
        let pair =
            format!("x'' = -0.1*x' - x + F*cos(t); y'' = -0.2*y' - (0.5 - x^2 - 0.3*x)*y - y^3{force}");
        let response = over(&pair, "F", [0.05, 0.15], ResponseOptions::default());
        let branch = &response.branches[0];
        let values = specials(branch, SpecialKind::SymmetryBreaking);
        assert!(
            values.len() == lost && values.iter().all(|value| (value - 0.10696352084745486).abs() < 1e-10),
            "{force}: {values:?} {:?}",
            branch.special
        );
        assert_eq!(specials(branch, SpecialKind::BranchPoint), [0.0; 0]);
    }
}

#[test]
fn van_der_pols_cycle_crosses_all_circles_where_nothing_excites_it() {
    let cycle = "x'' = mu*(1 - x^2)*x' - x";
    let through = over(cycle, "mu", [-1.0, 3.0], ResponseOptions::default());
    let up_to = over(cycle, "mu", [0.0, 3.0], ResponseOptions::default());
    for (response, off_by) in [(through, 1e-7), (up_to, 1e-10)] {
        let [branch] = &response.branches[..] else { panic!("{} branches", response.branches.len()) };
        assert_eq!(branch.ending, Ending::RangeEnd);
        let [crossing] = &branch.special[..] else { panic!("{:?}", branch.special) };
        assert_eq!(crossing.kind, SpecialKind::BranchPoint);
        let off = crossing.point.parameter.abs();
        assert!(off <= crossing.error && off < off_by, "{off:e} {:e}", crossing.error);
        // At the crossing the cycle is the circle of radius 2.
        assert!((crossing.point.amplitude(0, false) - 2.0).abs() < 1e-4, "{:?}", crossing.point);
        assert!(branch.points.iter().all(|point| (2.0 - 1e-4..2.1).contains(&point.amplitude(0, false))));
    }
    let circles = "x'' = -x + mu*0".parse().unwrap();
    let none = Response::over(&circles, "mu", [0.0, 1.0], &ResponseOptions::default(), &Quiet);
    assert_eq!(none.unwrap_err(), BranchError::Family);
}

/// The motion from rest rotates seven times before it settles on a response without symmetry: the one about the bottom.
#[test]
fn answers_that_are_found_turns_away_are_on_the_branches_about_the_bottom() {
    let pendulum: Equation = "theta'' = -theta'/10 - sin(theta) + A*cos(7*t/10)".parse().unwrap();
    let response = Response::over(&pendulum, "A", [0.0, 0.6], &ResponseOptions::default(), &Quiet).unwrap();
    let all = || response.branches.iter().flat_map(|branch| &branch.special);
    // By Fourier collocation and Taylor shooting 0.528969001376244; the branch that returns to it ends there.
    let lost: Vec<f64> = all()
        .filter(|special| special.kind == SpecialKind::SymmetryBreaking)
        .map(|special| special.point.parameter)
        .collect();
    assert!(lost.iter().any(|value| (value - 0.528969001376244).abs() < 1e-13), "{lost:?}");
    assert!(
        all().all(|special| special.kind != SpecialKind::BranchPoint),
        "{:?}",
        all().map(|special| special.kind).collect::<Vec<_>>()
    );
    let doublings = all().filter(|special| special.kind == SpecialKind::PeriodDoubling);
    let mut values: Vec<f64> = doublings.map(|doubling| doubling.point.parameter).collect();
    values.sort_by(f64::total_cmp);
    assert!(values.windows(2).all(|pair| pair[1] - pair[0] > 1e-9), "{values:?}");
}

/// At half its frequency an undamped oscillator has a family of motions with the period of the drive, and none that is isolated.
#[test]
fn an_end_of_the_range_without_a_motion_is_named() {
    let response = over("x'' + x = cos(w*t)", "w", [0.5, 0.9], ResponseOptions::default());
    let [(value, reason)] = &response.missing[..] else { panic!("{:?}", response.missing) };
    assert!(*value == 0.5 && matches!(reason, BranchError::NoStart(_)), "{reason}");
    assert_eq!(response.branches.len(), 1);
    let everywhere = over("x'' + x = cos(w*t)", "w", [0.55, 0.9], ResponseOptions::default());
    assert_eq!(everywhere.missing, vec![]);
}

/// θ(t + T/2) = −θ(t) with the drive, while z, driven by θ², has the period T/2. The symmetry-breaking bifurcation is that of the pendulum
/// alone: by Fourier collocation and Taylor shooting at A = 0.528969001376244.
#[test]
fn a_drive_whose_mirror_image_keeps_a_coordinate_is_recognised() {
    let [theta, z] = ["theta'' = -theta'/10 - sin(theta) + A*cos(7*t/10)", "z'' = -z'/5 - 2*z + theta^2"];
    for order in [[theta, z], [z, theta]] {
        let pair: Equation = order.join("; ").parse().unwrap();
        let options = ResponseOptions { generations: 0, ..ResponseOptions::default() };
        let response = Response::over(&pair, "A", [0.0, 0.6], &options, &Quiet).unwrap();
        let of_branch = |branch: &Branch| {
            let lost = branch.special.iter().filter(|special| special.kind == SpecialKind::SymmetryBreaking);
            lost.map(|lost| (branch.space, lost.clone())).collect::<Vec<_>>()
        };
        let all: Vec<_> = response.branches.iter().flat_map(of_branch).collect();
        let off = |value: f64| (value - 0.528969001376244).abs();
        let breaking = all.iter().find(|(_, special)| off(special.point.parameter) < 1e-13);
        let (space, lost) = breaking.unwrap_or_else(|| panic!("{order:?}: {all:?}"));
        assert!(space.mirrored && off(lost.point.parameter) <= lost.error.max(1e-15));
        let precise = lost.to_digits(&pair, "A", *space, 20, &Quiet).unwrap().unwrap();
        assert!(off(precise.parameter.to_f64()) < 1e-15 && precise.error < 1e-20);
    }
}
