//! Singular points to 25 digits, compared with Fourier collocation with extended systems and Taylor shooting in floats of 130 bits (driven
//! motions), and with Hill's matrix and the monodromy matrix in such floats (equilibria); in both cases the two methods agree in 30 digits.

use libration::continuation::{Response, ResponseOptions, SpecialKind};
use libration::expression::Equation;
use libration::progress::Quiet;

const PENDULUM: &str = "theta'' = -c*theta' - sin(theta) + A*cos(w*t)";
const DUFFING: &str = "x'' = -c*x' - x - b*x^3 + F*cos(w*t)";
const VAN_DER_POL: &str = "x'' = mu*(1 - x^2)*x' - x + F*cos(w*t)";
const HANGING: &str = "theta'' = -c*theta' - (1 - a*w^2*cos(w*t))*sin(theta)";
const UPRIGHT: &str = "theta'' = -c*theta' + (1 + a*w^2*cos(w*t))*sin(theta)";
const SHAKEN: &str = "theta'' = -c*theta' - sin(theta) + a*w^2*cos(w*t)*cos(theta)";

struct Case<'a> {
    equation: &'a str,
    values: &'a [(&'a str, &'a str)],
    parameter: &'a str,
    range: [f64; 2],
    options: ResponseOptions,
    kind: SpecialKind,
    expected: &'a str,
}

fn assert_digits(case: &Case<'_>) {
    let values: Vec<_> = case.values.iter().map(|(name, value)| (*name, value.parse().unwrap())).collect();
    let equation = case.equation.parse::<Equation>().unwrap().with(&values).unwrap();
    let response = Response::over(&equation, case.parameter, case.range, &case.options, &Quiet).unwrap();
    let near: f64 = case.expected.parse().unwrap();
    let mut specials = response
        .branches
        .iter()
        .flat_map(|branch| branch.special.iter().map(move |special| (branch.space, special)));
    let nearest = specials
        .find(|(_, special)| special.kind == case.kind && (special.point.parameter - near).abs() < 1e-11);
    let (space, special) = nearest.unwrap_or_else(|| panic!("no {} at {}", case.kind, case.expected));
    let precise = special.to_digits(&equation, case.parameter, space, 25, &Quiet).unwrap().unwrap();
    let digits = precise.parameter.to_rational().to_decimal(26);
    let (all_but_last, _) = case.expected.split_at(case.expected.len() - 1);
    assert!(digits.starts_with(all_but_last), "{}: {digits} for {}", case.kind, case.expected);
    assert!(precise.error < 1e-24, "{:e}", precise.error);
}

fn once() -> ResponseOptions {
    ResponseOptions { generations: 0, ..ResponseOptions::default() }
}

fn from(start: [f64; 2], drive_periods: u32) -> ResponseOptions {
    ResponseOptions { start: Some(start.to_vec()), drive_periods, ..once() }
}

#[test]
fn folds_have_25_digits() {
    let case = |equation, values, parameter, range, options, expected| Case {
        equation,
        values,
        parameter,
        range,
        options,
        kind: SpecialKind::Fold,
        expected,
    };
    for case in [
        case(
            PENDULUM,
            &[("c", "0.1"), ("A", "0.15")],
            "w",
            [0.8, 0.9],
            once(),
            "0.8721575691379171688795389",
        ),
        case(
            PENDULUM,
            &[("c", "0.2"), ("A", "0.32")],
            "w",
            [0.75, 0.9],
            once(),
            "0.7855183495770513073720936",
        ),
        case(
            PENDULUM,
            &[("c", "0.02"), ("w", "0.9")],
            "A",
            [0.0, 0.1],
            once(),
            "0.09223553605572827970804111",
        ),
        case(
            DUFFING,
            &[("c", "0.05"), ("b", "0.1"), ("F", "0.18")],
            "w",
            [1.1, 1.4],
            from([-0.1, 3.4], 1),
            "1.269601955545892477518364",
        ),
        case(
            DUFFING,
            &[("c", "0.1"), ("b", "-1"), ("F", "0.05")],
            "w",
            [0.8, 1.0],
            once(),
            "0.8927792130704409856717577",
        ),
        case(
            VAN_DER_POL,
            &[("mu", "0.1"), ("F", "0.05")],
            "w",
            [1.0, 1.02],
            from([-1.9, -0.2], 1),
            "1.011950453981722751644733",
        ),
        case(
            HANGING,
            &[("c", "0.1"), ("a", "0.1")],
            "w",
            [1.5, 1.7],
            from([-0.768, -1.272], 2),
            "1.512626304330608055862438",
        ),
    ] {
        assert_digits(&case);
    }
}

#[test]
fn losses_of_symmetry_doublings_and_second_frequencies_have_25_digits() {
    let followed = ResponseOptions { generations: 1, ..ResponseOptions::default() };
    let case = |equation, values, parameter, range, options, kind, expected| Case {
        equation,
        values,
        parameter,
        range,
        options,
        kind,
        expected,
    };
    use SpecialKind::{NeimarkSacker, PeriodDoubling, SymmetryBreaking};
    for case in [
        case(
            PENDULUM,
            &[("c", "1/2"), ("w", "2/3")],
            "A",
            [0.95, 1.07],
            followed,
            PeriodDoubling,
            "1.06637286245520700528907",
        ),
        case(
            SHAKEN,
            &[("c", "0.1"), ("w", "5")],
            "a",
            [0.25, 0.3],
            once(),
            SymmetryBreaking,
            "0.2807823565671525037105779",
        ),
        case(
            VAN_DER_POL,
            &[("mu", "0.1"), ("F", "0.2")],
            "w",
            [0.9, 0.95],
            once(),
            NeimarkSacker,
            "0.9306613812095431400414873",
        ),
    ] {
        assert_digits(&case);
    }
}

#[test]
fn edges_of_rest_have_25_digits() {
    use SpecialKind::{BranchPoint, PeriodDoubling};
    for (equation, w, c, range, kind, expected) in [
        (HANGING, "2.1", "0.1", [0.02, 0.1], PeriodDoubling, "0.06583115527999240741063971"),
        (HANGING, "0.9", "0.1", [0.8, 1.0], BranchPoint, "0.9414380111253381498173565"),
        (HANGING, "1.7", "0", [0.1, 0.3], PeriodDoubling, "0.2028581095994286883789948"),
        (UPRIGHT, "5", "0.1", [0.2, 0.4], BranchPoint, "0.2877861746702333933585712"),
        (UPRIGHT, "10", "0", [0.1, 0.2], BranchPoint, "0.1420381667926439343143172"),
        (UPRIGHT, "20", "0", [0.4, 0.5], PeriodDoubling, "0.4582185821132727327489322"),
    ] {
        let values = [("w", w), ("c", c)];
        assert_digits(&Case {
            equation,
            values: &values,
            parameter: "a",
            range,
            options: once(),
            kind,
            expected,
        });
    }
}

#[test]
fn what_has_no_digits_has_none() {
    let values = [("mu", "1".parse().unwrap()), ("F", "1".parse().unwrap())];
    let equation = VAN_DER_POL.parse::<Equation>().unwrap().with(&values).unwrap();
    let response = Response::over(&equation, "w", [1.1, 1.3], &once(), &Quiet).unwrap();
    let special =
        response.branches.iter().flat_map(|branch| branch.special.iter().map(move |one| (branch.space, one)));
    let saddles: Vec<_> = special.filter(|(_, special)| special.kind == SpecialKind::NeutralSaddle).collect();
    assert!(!saddles.is_empty());
    for (space, saddle) in saddles {
        assert_eq!(saddle.to_digits(&equation, "w", space, 25, &Quiet), Ok(None));
    }
}

/// The fold of the Duffing oscillator about zero, by Fourier collocation with 30 digits, where its spring is slack at 0.73.
#[test]
fn a_fold_about_another_centre_has_all_its_digits() {
    let centred =
        "x'' = -x'/20 - (x - 73/100) - (x - 73/100)^3/10 + 0.18*cos(w*t)".parse::<Equation>().unwrap();
    let response = Response::over(&centred, "w", [0.5, 1.6], &ResponseOptions::default(), &Quiet).unwrap();
    let branch = &response.branches[0];
    assert!(branch.space.mirrored);
    let mut folds = branch.special.iter().filter(|special| special.kind == SpecialKind::Fold);
    let fold = folds.find(|fold| (fold.point.parameter - 1.269601955545892).abs() < 1e-12).unwrap();
    let precise = fold.to_digits(&centred, "w", branch.space, 25, &Quiet).unwrap().unwrap();
    let digits = precise.parameter.to_rational().to_decimal(25);
    assert!(digits.starts_with("1.26960195554589247751836"), "{digits}");
}
