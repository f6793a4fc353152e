//! The same system in two forms has the same special points.

use crate::typed::equation;
use libration::continuation::{Ending, Response, ResponseOptions, SpecialKind};
use libration::orbit::Orbit;
use libration::progress::Quiet;
use std::f64::consts::{PI, TAU};

/// A response as it is compared.
#[derive(Debug)]
struct Outline {
    /// Kind, parameter and error of the special points, in the order of the parameter.
    special: Vec<(String, f64, f64)>,
    /// Direction, parameter and number of motions after it of each jump, in the order of the parameter.
    jumps: Vec<(bool, f64, usize)>,
    branches: usize,
}

impl Outline {
    fn new(text: &str, [from, to]: [f64; 2]) -> Self {
        let options = ResponseOptions { generations: 1, ..ResponseOptions::default() };
        let response = Response::over(&equation(text), "w", [from, to], &options, &Quiet).unwrap();
        let special = response.branches.iter().flat_map(|branch| &branch.special);
        let mut special: Vec<_> = special
            .map(|special| (special.kind.to_string(), special.point.parameter, special.error))
            .collect();
        special.sort_by(|a, b| a.1.total_cmp(&b.1));
        let jumps = response.jumps.iter().map(|jump| (jump.rising, jump.from.parameter, jump.to.len()));
        let mut jumps: Vec<_> = jumps.collect();
        jumps.sort_by(|a, b| a.1.total_cmp(&b.1));
        Self { special, jumps, branches: response.branches.len() }
    }

    fn assert_same(&self, other: &Self, forms: &str) {
        assert_eq!(self.branches, other.branches, "{forms}");
        assert_eq!(self.special.len(), other.special.len(), "{forms}: {self:?}; {other:?}");
        for ((kind, at, error), (other_kind, other, other_error)) in self.special.iter().zip(&other.special) {
            assert_eq!(kind, other_kind, "{forms} at {at}, {other}");
            assert!((at - other).abs() <= error + other_error, "{forms}: {kind} at {at} and {other}");
        }
        assert_eq!(self.jumps.len(), other.jumps.len(), "{forms}: {self:?}; {other:?}");
        for ((rising, at, after), (other_rising, other, other_after)) in self.jumps.iter().zip(&other.jumps) {
            assert_eq!((rising, after), (other_rising, other_after), "{forms}: jumps at {at} and {other}");
            assert!((at - other).abs() < 1e-12, "{forms}: jumps at {at} and {other}");
        }
    }
}

fn assert_same(a: &str, b: &str, range: [f64; 2]) {
    let [first, second] = [a, b].map(|text| Outline::new(text, range));
    first.assert_same(&second, &format!("{a}, {b}"));
}

/// Springs, a double well and a pendulum in other units of length, about another centre than zero, in first order and with another phase.
#[test]
fn units_and_centres_change_neither_branches_nor_jumps() {
    type Force = fn(&str) -> String;
    let forces: [(Force, f64, f64); 5] = [
        (|x| format!("2.585*{x}^3 - {x}"), 0.13, 1.071),
        (|x| format!("{x} + 1.468*max({x} - 0.3, 0) + 1.468*min({x} + 0.3, 0)"), 0.035, 1.019),
        (|x| format!("sin({x})"), 0.062, 1.192),
        (|x| format!("{x} + 0.369*{x}^3"), 0.083, 0.534),
        (|x| format!("2.852*{x}^3 - {x}"), 0.153, 0.352),
    ];
    for (force, damping, amplitude) in forces {
        let driven = |force: String, drive: &str| format!("x'' = -{damping}*x' - ({force}) + {drive}");
        let [cosine, sine] = ["cos", "sin"].map(|wave| format!("{amplitude}*{wave}(w*t)"));
        let plain = Outline::new(&driven(force("x"), &cosine), [0.5, 2.2]);
        let in_units = |unit: &str| {
            driven(format!("{unit}*({})", force(&format!("(x/{unit})"))), &format!("{unit}*{cosine}"))
        };
        let about = |centre: &str| driven(force(&format!("(x - {centre})")), &cosine);
        let first_order = format!("x' = v; v' = -{damping}*v - ({}) + {cosine}", force("x"));
        let mut forms = vec![about("0.73"), about("(-12.5)"), driven(force("x"), &sine), first_order];
        // Angles have no other units. The centre nearest to zero may be the top, half a turn away.
        if force("x").starts_with("sin") {
            forms.extend(["1.7", "(-2)", "3"].map(about));
        } else {
            forms.extend(["1000", "(1/1000)", "(1/100000)", "10000000"].map(in_units));
        }
        for form in forms {
            plain.assert_same(&Outline::new(&form, [0.5, 2.2]), &form);
        }
    }
}

/// A motion about the top is its own image about the top, whether the angle is counted from there or from the bottom. It loses its symmetry to
/// two motions, which a pendulum counted from the bottom passes half a turn from the centre of its own.
#[test]
fn the_upright_pendulum_is_symmetric_about_the_top() {
    let upright = |force: &str, start: f64| {
        let text = format!("x'' = -x'/5 {force} (1 - 20*cos(10*t))*sin(x) + A*cos(5*t)");
        let options = ResponseOptions { start: Some(vec![start, 0.0]), ..ResponseOptions::default() };
        let response = Response::over(&equation(&text), "A", [0.1, 30.0], &options, &Quiet).unwrap();
        let lost = response.branches.iter().filter(|branch| branch.space.mirrored).flat_map(|branch| {
            assert!(branch.points.iter().all(|point| point.rotation.is_none()));
            branch.special.iter().map(|special| (special.kind, special.point.parameter, special.error))
        });
        let lost: Vec<_> = lost.collect();
        assert_eq!(response.branches.iter().filter(|branch| branch.space.mirrored).count(), 2, "{text}");
        let [(SpecialKind::SymmetryBreaking, value, error)] = lost[..] else { panic!("{text}: {lost:?}") };
        assert!(error < 1e-11, "{text}: {error:e}");
        value
    };
    let expected = upright("+", 0.0);
    for (force, start) in [("+", TAU), ("-", PI), ("-", -PI), ("-", 5.0 * PI)] {
        let value = upright(force, start);
        assert!((value - expected).abs() < 1e-11, "{force} {start}: {value} {expected}");
    }
}

/// The multipliers 1.0503 and 0.9521 are real, and rounding must not make them a complex pair, which would be a Neimark–Sacker point.
#[test]
fn a_neutral_saddle_is_one_in_every_form() {
    let (x, y) = ("-0.139*x' - 1.235*sin(x) - 0.1217*(x - y)", "-0.109*y' - 0.5739*sin(y) - 0.1217*(y - x)");
    let mirrored = "x'' = -0.139*x' - 1.235*sin(x) - 0.1217*(x - y) - 0.1681*cos(w*t)".to_owned();
    for form in [
        format!("x'' = {x} + 0.1681*cos(w*t); y'' = {y}"),
        format!("y'' = {y}; x'' = {x} + 0.1681*cos(w*t)"),
        format!("x'' = {x} + 0.1681*sin(w*t); y'' = {y}"),
        format!("{mirrored}; y'' = {y}"),
    ] {
        let special = Outline::new(&form, [0.97, 0.99]).special;
        let kind = |at: f64| special.iter().find(|(_, parameter, _)| (parameter - at).abs() < 1e-12);
        assert_eq!(kind(0.978_033_325_914_875).unwrap().0, "neutral saddle", "{form}: {special:?}");
        assert_eq!(kind(0.985_182_278_529_875).unwrap().0, "Neimark–Sacker", "{form}: {special:?}");
    }
}

/// Branches of period doublings end on that from which they come, some next to its folds.
#[test]
fn a_branch_on_which_others_end_is_followed_once() {
    let (x, y) = ("-0.1696*v - 1.769*sin(x) - 0.3945*(x - y)", "-0.1121*u - 1.763*sin(y) - 0.3945*(y - x)");
    let text = format!("x' = v; v' = {x} + 0.1692*cos(w*t); y' = u; u' = {y}");
    let options = ResponseOptions { generations: 2, ..ResponseOptions::default() };
    let response = Response::over(&equation(&text), "w", [0.6, 2.2], &options, &Quiet).unwrap();
    let ends = response.branches.iter().filter_map(|branch| branch.points.first());
    let at_the_end: Vec<&[f64]> =
        ends.filter(|point| (point.parameter - 0.6).abs() < 1e-12).map(|point| &point.state[..]).collect();
    assert!(at_the_end.len() >= 2, "{at_the_end:?}");
    for (i, state) in at_the_end.iter().enumerate() {
        let is_near = |other: &&[f64]| state.iter().zip(*other).all(|(a, b)| (a - b).abs() < 1e-6);
        assert!(!at_the_end[..i].iter().any(is_near), "{at_the_end:?}");
    }
}

/// At slow drives the motion about the top loses all digits within a period, and is checked piece by piece, its second half as the image of the first.
#[test]
fn the_upright_pendulum_is_followed_to_slow_drives() {
    for (force, start) in [("+", 0.0), ("-", PI)] {
        // In a linear force the drive 0.1 cos(wt) moves the top by −0.1 cos(wt)/(1 + w²).
        let start = start - 0.1 / 1.64;
        let text = format!("x'' = -x'/10 {force} sin(x) + cos(w*t)/10");
        let options = ResponseOptions { start: Some(vec![start, 0.0]), ..ResponseOptions::default() };
        let response = Response::over(&equation(&text), "w", [0.2, 0.8], &options, &Quiet).unwrap();
        let upright =
            response.branches.iter().find(|branch| branch.points.iter().all(|point| !point.is_stable()));
        let Some(branch) = upright else { panic!("{text}: {}", response.branches.len()) };
        assert!(branch.space.mirrored && branch.ending == Ending::RangeEnd, "{text}: {:?}", branch.ending);
        let slowest = branch.points.iter().map(|point| point.parameter).fold(1.0, f64::min);
        assert!((slowest - 0.2).abs() < 1e-12, "{text}: {slowest}");
    }
}

#[test]
fn a_pendulum_by_half_angles_has_the_same_folds() {
    let driven = |force: &str| format!("x'' = -x'/10 - {force} + 0.15*cos(w*t)");
    assert_same(&driven("sin(x)"), &driven("2*sin(x/2)*cos(x/2)"), [1.4, 0.3]);
}

/// A limit cycle about another equilibrium is its own mirror image too.
#[test]
fn a_limit_cycle_about_another_centre_is_symmetric() {
    for centre in ["0", "0.73", "(-12.5)", "pi"] {
        let van_der_pol = format!("x'' = w*(1 - (x - {centre})^2)*x' - (x - {centre})");
        let response =
            Response::over(&equation(&van_der_pol), "w", [0.5, 2.0], &ResponseOptions::default(), &Quiet)
                .unwrap();
        let [branch] = &response.branches[..] else { panic!("{centre}: {}", response.branches.len()) };
        assert!(branch.space.mirrored && branch.special.is_empty(), "{centre}: {:?}", branch.space);
        assert!(branch.points.iter().all(|point| point.is_stable()), "{centre}");
    }
}

/// The cycle of the Brusselator begins at b = 2, whichever equation comes first: next to it terms of y' are equal, and only rounding is left.
#[test]
fn the_order_of_equations_does_not_change_a_hopf_point() {
    for text in ["x' = 1 - (b+1)*x + x^2*y; y' = b*x - x^2*y", "y' = b*x - x^2*y; x' = 1 - (b+1)*x + x^2*y"] {
        let options = ResponseOptions { at: Some(2.15), ..ResponseOptions::default() };
        let response = Response::over(&equation(text), "b", [1.99, 2.2], &options, &Quiet).unwrap();
        let special = &response.branches[0].special;
        assert!(
            special.len() == 1 && (special[0].point.parameter - 2.0).abs() < 1e-13,
            "{text}: {special:?}"
        );
    }
}

/// Released on the near side of its equilibrium, a spring goes farther on the other side.
#[test]
fn free_oscillations_about_another_centre_have_their_largest_displacement() {
    let text = "x'' = -x'/10 - (x - 0.73) - 2*(x - 0.73)^3 + 0.5*cos(w*t)";
    let (driven, range) = (equation(text), [0.5, 2.2]);
    let response = Response::over(&driven, "w", range, &ResponseOptions::default(), &Quiet).unwrap();
    let backbone = response.backbone(&driven, range, false);
    assert!(backbone.len() > 40, "{}", backbone.len());
    let centred = equation("x'' = -x - 2*x^3");
    for free in backbone {
        assert!(free.amplitude >= 0.73, "{free:?}");
        let orbit = Orbit::released(&centred, free.amplitude - 0.73, &Quiet).unwrap();
        assert!((free.parameter - orbit.frequency()).abs() < 1e-12, "{free:?}");
    }
}

/// The motion is stable between a period doubling and the fold for 2.6e-5 of w only, where the branch need not have a point.
#[test]
fn a_fold_next_to_a_period_doubling_is_a_jump() {
    for wave in ["cos", "sin"] {
        let double_well = format!("x'' = -0.13*x' + x - 2.585*x^3 + 1.071*{wave}(w*t)");
        let options = ResponseOptions { generations: 2, ..ResponseOptions::default() };
        let response = Response::over(&equation(&double_well), "w", [0.5, 2.2], &options, &Quiet).unwrap();
        let mut jumps = response.jumps.iter().map(|jump| (jump.from.parameter, jump.rising));
        assert!(
            jumps.any(|(at, rising)| !rising && (at - 0.767_567_337_161_68).abs() < 1e-12),
            "{wave}: {:?}",
            jumps.collect::<Vec<_>>()
        );
    }
}
