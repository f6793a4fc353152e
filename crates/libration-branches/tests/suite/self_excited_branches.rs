//! Limit cycles over a parameter, compared with closed forms and with shooting by another integrator.

use libration::algebra::Complex;
use libration::continuation::{
    Branch, BranchError, Ending, Origin, Response, ResponseOptions, SpecialKind, SpecialPoint,
};
use libration::expression::Equation;
use libration::orbit::Stability;
use libration::progress::{Quiet, Status};
use std::f64::consts::TAU;
use std::ops::ControlFlow;

fn over(equation: &str, parameter: &str, range: [f64; 2], options: &ResponseOptions) -> Response {
    Response::over(&equation.parse().unwrap(), parameter, range, options, &Quiet).unwrap()
}

fn special(branch: &Branch, kind: SpecialKind) -> Vec<f64> {
    branch
        .special
        .iter()
        .filter(|special| special.kind == kind)
        .map(|special| special.point.parameter)
        .collect()
}

#[test]
fn van_der_pols_cycle_has_its_period_from_weak_to_strong_excitation() {
    let response = over("x'' = mu*(1 - x^2)*x' - x", "mu", [1.0, 10.0], &ResponseOptions::default());
    assert_eq!(response.branches.len(), 1);
    let branch = &response.branches[0];
    assert!(branch.space.mirrored && branch.special.is_empty() && branch.ending == Ending::RangeEnd);
    // By Taylor series with 25 digits (mpmath).
    for (point, period) in
        [(&branch.points[0], 6.6632868593231301897), (branch.points.last().unwrap(), 19.078369566939014070)]
    {
        assert!((point.period - period).abs() < 1e-13 * period, "{:?} {period:?}", point.period);
        assert!(point.error < 1e-11, "{point:?}");
    }
    for point in &branch.points {
        // All cycles of van der Pol's equation attract: its divergence has a negative mean over them (Liénard).
        assert_eq!(point.stability, Stability::Attracting, "{point:?}");
        let multipliers: Vec<f64> = point.multipliers.iter().map(|multiplier| multiplier.re).collect();
        assert!(
            multipliers[0].to_bits() == 1.0_f64.to_bits() && (0.0..1e-3).contains(&multipliers[1].abs()),
            "{multipliers:?}"
        );
    }
}

/// r′ = mr + r³ − r⁵, φ′ = 1.
const CIRCLES: &str =
    "x' = m*x - y + x*(x^2 + y^2) - x*(x^2 + y^2)^2; y' = x + m*y + y*(x^2 + y^2) - y*(x^2 + y^2)^2";

#[test]
fn cycles_that_are_circles_have_their_radius_multiplier_fold_and_beginning() {
    let response = over(CIRCLES, "m", [-0.4, 0.5], &ResponseOptions::default());
    assert_eq!(response.branches.len(), 1);
    let branch = &response.branches[0];
    let (rest, cycles) = branch.points.split_last().unwrap();
    for point in cycles {
        let (radius, m) = (point.amplitude(0, false), point.parameter);
        let r2 = radius * radius;
        assert!((m + r2 - r2 * r2).abs() < 1e-12 && (point.period - TAU).abs() < 1e-11, "{point:?}");
        let multiplier = libm::exp(TAU * (m + 3.0 * r2 - 5.0 * r2 * r2));
        let other =
            point.multipliers.iter().find(|multiplier| multiplier.re.to_bits() != 1.0_f64.to_bits()).unwrap();
        assert!((other.re - multiplier).abs() < 1e-10 * multiplier.max(1.0), "{point:?} {multiplier}");
        let stability = if r2 > 0.5 { Stability::Attracting } else { Stability::Unstable };
        assert_eq!(point.stability, stability, "{point:?}");
    }
    let folds = special(branch, SpecialKind::Fold);
    assert!(folds.len() == 1 && (folds[0] + 0.25).abs() < 1e-14, "{folds:?}");
    let begins = special(branch, SpecialKind::Hopf);
    assert!(begins.len() == 1 && begins[0].abs() < 1e-14 && branch.ending == Ending::Rest, "{begins:?}");
    assert!(
        rest.parameter.abs() < 1e-14 && rest.amplitude(0, false) < 1e-14 && (rest.period - TAU).abs() < 1e-14
    );
    // Downwards the cycle ends at the fold, and there is no other cycle to jump to.
    let [jump] = &response.jumps[..] else { panic!("{:?}", response.jumps) };
    assert!(!jump.rising && jump.to.is_empty());
}

#[test]
fn a_cycle_between_two_hopf_points_is_found_from_a_value_within_the_range() {
    let neuron = "v' = v - v^3/3 - w + q; w' = 0.5*(v + 0.7 - 0.8*w)";
    let at_ends =
        Response::over(&neuron.parse().unwrap(), "q", [0.2, 1.6], &ResponseOptions::default(), &Quiet);
    assert!(matches!(at_ends, Err(BranchError::NoStart(_))), "{at_ends:?}");
    let options = ResponseOptions { at: Some(0.8), ..ResponseOptions::default() };
    let response = over(neuron, "q", [0.2, 1.6], &options);
    let branch = &response.branches[0];
    // The trace 1 − v² − 0.4 vanishes there.
    let v = 0.6_f64.sqrt();
    let expected = [-v, v].map(|v| (v + 0.7) / 0.8 - (v - v * v * v / 3.0));
    let mut values = special(branch, SpecialKind::Hopf);
    values.sort_by(f64::total_cmp);
    assert!(
        values.len() == 2 && values.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14),
        "{values:?} {expected:?}"
    );
    assert_eq!([branch.beginning, branch.ending], [Ending::Rest; 2]);
    let ends = [&branch.points[0], branch.points.last().unwrap()];
    assert!(
        ends.iter().all(|end| end.ranges.iter().all(|[low, high]| low.to_bits() == high.to_bits())),
        "{ends:?}"
    );
}

#[test]
fn roesslers_cycle_doubles_its_period_and_doubles_it_again() {
    let roessler = "x' = -y - z; y' = x + 0.2*y; z' = 0.2 + z*(x - c)";
    let response = over(roessler, "c", [2.0, 3.9], &ResponseOptions::default());
    let doubled = response
        .branches
        .iter()
        .find(|branch| branch.origin == Origin::PeriodDoubling && branch.space.drive_periods() == 2)
        .unwrap();
    // By Newton's method for closing Taylor series of order 34 in 113 bits, and the zero of det(M + 1).at 2e-14 and the variational equations.
    for (branch, expected, period) in [
        (&response.branches[0], 2.83244502786254, 5.769820016506563),
        (doubled, 3.83735816841005, 11.572688804465812),
    ] {
        let doublings: Vec<_> =
            branch.special.iter().filter(|special| special.kind == SpecialKind::PeriodDoubling).collect();
        assert_eq!(doublings.len(), 1);
        assert!(
            (doublings[0].point.parameter - expected).abs() < 1e-11,
            "{:?}",
            doublings[0].point.parameter
        );
        assert!((doublings[0].point.period - period).abs() < 1e-10, "{:?}", doublings[0].point.period);
    }
    // The period of a doubled cycle is twice that of its primary cycle at the bifurcation.
    assert!((doubled.points[0].period - 2.0 * 5.769820016506563).abs() < 1e-10);
    // The cycle of four turns to which the motion settles at the end belongs to the second doubling, and is followed only once.
    let four: Vec<&Branch> =
        response.branches.iter().filter(|branch| branch.space.drive_periods() == 4).collect();
    assert!(four.len() == 1 && four[0].ending == Ending::BranchPoint, "{four:?}");
}

#[test]
fn what_has_no_cycle_says_why() {
    let refused = |equation: &str, options: &ResponseOptions| {
        Response::over(&equation.parse::<Equation>().unwrap(), "k", [1.0, 2.0], options, &Quiet).unwrap_err()
    };
    let once = ResponseOptions::default();
    assert_eq!(refused("x'' = -k*x - x^3", &once), BranchError::Family);
    assert!(matches!(refused("x'' = -k*x - x'", &once), BranchError::NoStart(_)));
    let second = ResponseOptions { start: Some(vec![1.0, 0.5, 0.0]), ..once.clone() };
    assert_eq!(refused("x' = -x; y'' = k*(1 - y^2)*y' - y", &second), BranchError::NotFollowed);
    let twice = ResponseOptions { drive_periods: 2, ..once };
    assert_eq!(refused("x'' = k*(1 - x^2)*x' - x", &twice), BranchError::NotDriven);
}

#[test]
fn a_branch_of_cycles_that_is_stopped_has_what_was_done() {
    let progress =
        |status: Status| if status.done >= 5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
    let equation = CIRCLES.parse().unwrap();
    let response =
        Response::over(&equation, "m", [-0.4, 0.5], &ResponseOptions::default(), &progress).unwrap();
    assert!(response.interrupted && response.branches[0].ending == Ending::Interrupted);
    assert!(response.branches[0].points.len() == 5, "{}", response.branches[0].points.len());
}

/// The symmetric cycle loses its symmetry at 312.973532984 (shooting over half
/// a period with SciPy's DOP853 at 2.3e-14 and the variational equations).
#[test]
fn a_mirror_image_of_two_of_three_coordinates_is_recognised() {
    let lorenz = "x' = 10*(y - x); y' = x*(rho - z) - y; z' = x*y - 8/3*z";
    // The same equations with the coordinate first whose sign is kept, so that a cycle has two or more starting points in a period.
    let upright = "z' = x*y - 8/3*z; x' = 10*(y - x); y' = x*(rho - z) - y";
    for (lorenz, range) in [(lorenz, [210.0, 330.0]), (lorenz, [300.0, 330.0]), (upright, [300.0, 330.0])] {
        let start = if lorenz == upright { vec![0.0, 0.1, 0.0] } else { vec![0.1, 0.0, 0.0] };
        let options = ResponseOptions { start: Some(start), ..ResponseOptions::default() };
        let response = over(lorenz, "rho", range, &options);
        let specials: Vec<_> = response.branches.iter().flat_map(|branch| &branch.special).collect();
        let lost: Vec<_> =
            specials.iter().filter(|special| special.kind == SpecialKind::SymmetryBreaking).collect();
        assert!(lost.len() == 1 && (lost[0].point.parameter - 312.973532984206).abs() < 1e-9, "{lost:?}");
        assert!(
            lost[0].error < 1e-10 && specials.iter().all(|special| special.kind != SpecialKind::BranchPoint)
        );
        if range[0] < 220.0 {
            let doubled = response.branches.iter().filter(|branch| branch.origin == Origin::PeriodDoubling);
            assert!(doubled.count() >= 1, "the doubled cycles are followed");
        }
    }
}

/// The Hopf points are where the trace 1 − v² − 0.064 vanishes; by the cubic everything is symmetric about I = 7/8.
#[test]
fn canards_are_followed_to_the_hopf_points_on_both_sides() {
    let nerve = "v' = v - v^3/3 - w + I; w' = 0.08*(v + 0.7 - 0.8*w)";
    let v = 0.936_f64.sqrt();
    let current = |v: f64| v * v * v / 3.0 - v + (v + 0.7) / 0.8;
    for at in [0.6, 1.3] {
        let options = ResponseOptions { at: Some(at), ..ResponseOptions::default() };
        let response = over(nerve, "I", [0.2, 1.8], &options);
        let [branch] = &response.branches[..] else { panic!("{} branches", response.branches.len()) };
        assert_eq!([branch.beginning, branch.ending], [Ending::Rest; 2], "from {at}");
        let of_kind = |kind: SpecialKind| {
            let mut values: Vec<f64> = branch
                .special
                .iter()
                .filter(|special| special.kind == kind)
                .map(|special| special.point.parameter)
                .collect();
            values.sort_by(f64::total_cmp);
            values
        };
        let (hopf, folds) = (of_kind(SpecialKind::Hopf), of_kind(SpecialKind::Fold));
        assert!(
            hopf.len() == 2 && (hopf[0] - current(-v)).abs() < 1e-14 && (hopf[1] - current(v)).abs() < 1e-14
        );
        assert!(folds.len() == 2 && (folds[0] + folds[1] - 1.75).abs() < 1e-13, "{folds:?}");
        assert_eq!(branch.special.len(), 4, "{:?}", branch.special);
        // Outside the folds no other periodic motion is stable.
        let mut jumps: Vec<(bool, usize)> =
            response.jumps.iter().map(|jump| (jump.rising, jump.to.len())).collect();
        jumps.sort_unstable();
        assert_eq!(jumps, [(false, 0), (true, 0)], "from {at}");
    }
}

/// The first coordinate follows the second, which excites itself and does not notice. At mu = 5 it turns three times in a period, at mu = 1 once,
/// on one branch.
#[test]
fn a_cycle_of_a_later_coordinate_is_found_from_rest() {
    let following = "x'' = -4*x - x' + y/2; y'' = mu*(1 - y^2)*y' - y";
    let response = over(following, "mu", [1.0, 5.0], &ResponseOptions::default());
    let [branch] = &response.branches[..] else { panic!("{} branches", response.branches.len()) };
    let period = branch.points[0].period;
    // That of van der Pol's equation, as above.
    assert!((period - 6.6632868593231301897).abs() < 1e-12 && branch.ending == Ending::RangeEnd, "{period}");
}

#[test]
fn cycles_of_many_turns_double_their_period_and_are_followed() {
    let lorenz = "x' = 10*(y - x); y' = x*(rho - z) - y; z' = x*y - 8/3*z";
    let options =
        ResponseOptions { at: Some(150.0), start: Some(vec![0.1, 0.0, 0.0]), ..ResponseOptions::default() };
    let response = over(lorenz, "rho", [130.0, 170.0], &options);
    let of_turns = |turns: u32| {
        response.branches.iter().filter(move |branch| branch.space.drive_periods() == turns).collect()
    };
    let (pair, quadruple): (Vec<&Branch>, Vec<&Branch>) = (of_turns(6), of_turns(12));
    let ([pair], [quadruple]) = (&pair[..], &quadruple[..]) else { panic!("{response:?}") };
    // By Newton's method for closing Taylor series of order 34 in 113 bits, and the zero of det(M + 1).
    let [first, second] = [pair, quadruple].map(|branch| special(branch, SpecialKind::PeriodDoubling));
    assert!(first.len() == 1 && (first[0] - 147.150_294_744_076_954).abs() < 1e-11, "{first:?}");
    assert!(second.len() == 1 && (second[0] - 146.872_795_524_061_250).abs() < 1e-11, "{second:?}");
    assert!(pair.ending == Ending::RangeEnd && quadruple.ending == Ending::Sensitive);
    let last = quadruple.points.last().unwrap().multipliers[0].abs();
    assert!((100.0..1000.0).contains(&last), "{last}");
}

/// r′ = r(1 − r²)(m² − r²)(9 − r²)/10, φ′ = 1: a motion from r = 1.9 goes to the cycle r = 3 for m = 1.8, and to r = 1 for m = 2.2.
#[test]
fn cycles_with_one_period_are_distinguished_by_their_ranges() {
    let growth = "(1 - x^2 - y^2)*(m^2 - x^2 - y^2)*(9 - x^2 - y^2)/10";
    let equation = format!("x' = x*{growth} - y; y' = y*{growth} + x");
    let options = ResponseOptions { start: Some(vec![1.9, 0.0]), ..ResponseOptions::default() };
    let response = over(&equation, "m", [1.8, 2.2], &options);
    let radius = |branch: &Branch| branch.points[0].amplitude(0, false);
    let mut radii: Vec<f64> = response.branches.iter().map(radius).collect();
    radii.sort_by(f64::total_cmp);
    assert!(
        radii.len() == 2 && (radii[0] - 1.0).abs() < 1e-12 && (radii[1] - 3.0).abs() < 1e-12,
        "{radii:?}"
    );
    assert!(
        response
            .branches
            .iter()
            .flat_map(|branch| &branch.points)
            .all(|point| (point.period - TAU).abs() < 1e-11)
    );
}

/// The divergence m + x of x′ = y, y′ = my + x − x² + xy, integrated over a cycle by Runge and Kutta's method: the logarithm of its multiplier.
fn logarithm_of_multiplier(m: f64, start: &[f64], period: f64) -> f64 {
    const STEPS: u32 = 40_000;
    let rates = |[x, y, _]: [f64; 3]| [y, m * y + x - x * x + x * y, m + x];
    let moved = |u: [f64; 3], k: [f64; 3], h: f64| [0, 1, 2].map(|i| u[i] + h * k[i]);
    let step = period / f64::from(STEPS);
    let mut state = [start[0], start[1], 0.0];
    // What the additions round off, which would otherwise add up to 3e-14.
    let mut rounded = [0.0; 3];
    for _ in 0..STEPS {
        let first = rates(state);
        let second = rates(moved(state, first, 0.5 * step));
        let third = rates(moved(state, second, 0.5 * step));
        let fourth = rates(moved(state, third, step));
        for i in 0..3 {
            let change = step / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i]) - rounded[i];
            let next = state[i] + change;
            (rounded[i], state[i]) = ((next - state[i]) - change, next);
        }
    }
    state[2]
}

/// The cycle of x′ = y, y′ = my + x − x² + xy grows from the Hopf point m = −1 to the homoclinic orbit of the equilibrium at the origin. The
/// parameter of that orbit is the zero of the distance between its stable and unstable manifolds (SciPy, DOP853, 1e-13).
#[test]
fn a_cycle_that_becomes_a_homoclinic_orbit_ends_there() {
    let options =
        ResponseOptions { at: Some(-0.9), start: Some(vec![0.8, 0.0]), ..ResponseOptions::default() };
    let response = over("x' = y; y' = m*y + x - x^2 + x*y", "m", [-1.0, -0.75], &options);
    let [branch] = &response.branches[..] else { panic!("{} branches", response.branches.len()) };
    assert_eq!((branch.ending, special(branch, SpecialKind::Fold).len()), (Ending::InfinitePeriod, 0));
    assert_eq!((branch.special.len(), special(branch, SpecialKind::Hopf).len()), (1, 1), "{response:?}");
    let last = branch.points.last().unwrap();
    assert!((last.parameter + 0.864_545_247_421_5).abs() < 2e-12 && last.period > 40.0, "{last:?}");
    // Nearer to the equilibrium an integration from one start follows another orbit.
    let followed = branch.points.iter().filter(|point| point.period < 25.0);
    for point in followed.filter(|point| point.period > 6.5).step_by(7) {
        let expected = libm::exp(logarithm_of_multiplier(point.parameter, &point.state, point.period));
        let off =
            |(multiplier, error): (&Complex, &f64)| (*multiplier - Complex::from(expected)).abs() - error;
        let off = point.multipliers.iter().zip(&point.multiplier_errors).map(off).fold(1.0, f64::min);
        assert!(off <= 0.0, "{point:?} {expected:e}");
    }
    let beyond = branch.points.iter().filter(|point| point.period > 25.0);
    for (multiplier, error) in beyond.flat_map(|point| point.multipliers.iter().zip(&point.multiplier_errors))
    {
        // The other multiplier is below 2e-6 there, and the return map a difference of much larger numbers.
        assert!(
            (multiplier.re - 1.0).abs() < 1e-12 || multiplier.abs() < error + 2e-6,
            "{multiplier:?} {error:e}"
        );
    }
}

/// Nagumo's equations of a nerve are their own image under (v, w, I) → (−v, 7/4 − w, 7/4 − I), and so are the folds of their cycles, both next to
/// canards: the branch turns within the last digits of the parameter.
#[test]
fn both_folds_next_to_canards_are_listed() {
    let equation = "v' = v - v^3/3 - w + I; w' = 0.08*(v + 0.7 - 0.8*w)".parse().unwrap();
    for part in [1.0, 0.99, 1.01, 1.02] {
        let options = ResponseOptions {
            at: Some(0.8 * part),
            start: Some(vec![1.0, 0.5]),
            ..ResponseOptions::default()
        };
        let response = Response::over(&equation, "I", [0.0, 2.0], &options, &Quiet).unwrap();
        let points = || response.branches.iter().flat_map(|branch| &branch.special);
        for (kind, low) in [(SpecialKind::Fold, 0.3241785225037), (SpecialKind::Hopf, 0.33128133745475)] {
            for expected in [low, 1.75 - low] {
                let is_it = |point: &&SpecialPoint| {
                    point.kind == kind && (point.point.parameter - expected).abs() < 1e-12 + point.error
                };
                let special = points().find(is_it);
                assert!(
                    special.is_some_and(|special| special.error < 1e-12),
                    "{part} {kind:?} {expected}: {special:?}"
                );
            }
        }
    }
}
