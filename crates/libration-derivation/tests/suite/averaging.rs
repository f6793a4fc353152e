//! Slow flows are derived, and agree with independently known ones.

use libration::algebra::Rational;
use libration::expression::Equation;
use libration::internals::progress::Watch;
use libration::perturbation::{Gauge, slow_flow};
use libration::progress::{Quiet, Status};
use libration_derivation::internals::averaging::{self as put_back, AveragingQuestion, Flow};
use libration_derivation::internals::phase::{PhaseFunction, PiNumber};
use libration_derivation::{DerivationError, averaging, to_markdown};
use std::cell::Cell;
use std::ops::ControlFlow;

fn page(equation: &str, orders: [usize; 2]) -> Result<String, DerivationError> {
    let equation: Equation = equation.parse().unwrap();
    averaging(&equation, None, orders[0], orders[1], &Quiet).map(|page| to_markdown(&page))
}

fn solved(equation: &str, orders: [usize; 2]) -> (AveragingQuestion, Flow) {
    let question = AveragingQuestion::new(&equation.parse().unwrap(), None, orders).unwrap();
    let flow = Flow::new(&question, &Watch::new(&Quiet)).unwrap();
    (question, flow)
}

/// Each derivation compares all coefficients with the library's and substitutes the motion into the equation before it is returned.
#[test]
fn dampings_of_every_power_are_derived_for_springs_and_pendulums() {
    for force in ["sin(x)", "x", "x + x^3", "4*x - x^5/2"] {
        for damping in ["x'", "x'^3", "x'*abs(x')", "sign(x')", "(x' + x'*abs(x')/3)"] {
            let text = page(&format!("x'' + c*{damping} + {force} = 0"), [4, 2]).unwrap();
            assert!(text.contains("The slow flow of amplitude and phase"), "{force} {damping}");
            assert!(text.contains("The same from the energy"), "{force} {damping}");
        }
    }
}

#[test]
fn asymmetric_springs_and_a_place_of_rest_elsewhere_are_derived() {
    for equation in
        ["x'' + c*x' + x + x^2 = 0", "x'' + c*x'^3 - x + x^3 = 0", "x'' + c*(x'^2 + x*x') + x + x^2 = 0"]
    {
        let refused = page(equation, [3, 2]);
        match equation.contains("- x") {
            // ω0² = 2 has an irrational root.
            true => assert!(matches!(refused, Err(DerivationError::NoFractionalFrequency))),
            false => assert!(refused.unwrap().contains("All powers are there"), "{equation}"),
        }
    }
    let moved = page("x'' + c*x' - 2*x + 2*x^3 = 0", [3, 2]).unwrap();
    assert!(moved.contains("u:=x-1") && moved.contains("=4u+6u^{2}+2u^{3}\n"), "{moved}");
}

/// Black and Vel's equation (54), as printed, loses no energy on average for the square of the velocity.
#[test]
fn the_published_square_of_the_velocity_is_no_damping() {
    let equation = "x'' + c*x'^2 + sin(x) = 0".parse().unwrap();
    let flow = slow_flow(&equation, None, 6, 4, &Gauge::XMax, &Quiet).unwrap();
    assert!(flow.amplitude_rate.iter().flatten().all(libration::algebra::PiSum::is_zero));
    let (_, solution) = solved("x'' + c*x'^2 + sin(x) = 0", [6, 2]);
    assert!(solution.growth.is_empty() && solution.frequency.contains_key(&(2, 2)));
    assert!(page("x'' + c*x'*abs(x') + sin(x) = 0", [3, 1]).unwrap().contains("e^{2cx}"));
}

/// A′ = −½cA and ψ′ = √(1 − c²/4) for the linear spring, in the gauge of the turning points.
#[test]
fn viscous_damping_of_a_linear_spring_is_that_of_the_textbooks() {
    let (_, flow) = solved("x'' + c*x' + x = 0", [1, 4]);
    let fraction = |a, b| PiNumber::from(Rational::new(a, b).unwrap());
    assert_eq!(
        flow.growth.iter().map(|(at, coefficient)| (*at, coefficient.clone())).collect::<Vec<_>>(),
        [((1, 1), fraction(-1, 2))]
    );
    for (j, value) in [(0, (1, 1)), (2, (-1, 8)), (4, (-1, 128))] {
        assert_eq!(flow.frequency.get(&(0, j)), Some(&fraction(value.0, value.1)));
    }
}

/// A change of any coefficient is detected when the motion is substituted.
#[test]
fn a_coefficient_that_is_changed_is_found() {
    for damping in ["x'", "x'*abs(x')", "sign(x')"] {
        let equation = format!("x'' + c*{damping} + sin(x) = 0");
        let (question, flow) = solved(&equation, [3, 2]);
        assert!(put_back::check(&question, &flow).is_ok());
        let places = |wanted: &dyn Fn(&Flow) -> Vec<(usize, usize)>| wanted(&flow);
        for powers in places(&|flow| flow.growth.keys().copied().filter(|(n, _)| *n <= 3).collect()) {
            let (_, mut wrong) = solved(&equation, [3, 2]);
            let value = wrong.growth[&powers].scaled(&Rational::new(1001, 1000).unwrap());
            wrong.growth.insert(powers, value);
            assert!(put_back::check(&question, &wrong).is_err(), "{damping} a {powers:?}");
            let other = put_back::agrees_with_library(&question, &wrong, &Watch::new(&Quiet));
            assert!(matches!(other, Err(DerivationError::Disagreement { .. })), "{damping} a {powers:?}");
        }
        for powers in places(&|flow| flow.motion.keys().copied().filter(|key| *key != (1, 0)).collect()) {
            let (_, mut wrong) = solved(&equation, [3, 2]);
            let more = PhaseFunction::sine().scaled(&Rational::new(1, 1000).unwrap().into());
            let value = wrong.motion[&powers].plus(&more);
            wrong.motion.insert(powers, value);
            assert!(put_back::check(&question, &wrong).is_err(), "{damping} x {powers:?}");
        }
    }
}

/// Van der Pol's cycle: the largest displacement 2 + μ²/96, Ω = 1 − μ²/16 (A. Dadfar, J. Geer, C. Andersen, SIAM J. Appl. Math. 44, 881 (1984)).
#[test]
fn limit_cycles_have_their_known_amplitude_and_frequency() {
    let text = page("x'' + x = mu*(1 - x^2)*x'", [7, 3]).unwrap();
    assert!(text.contains(r"A^{2}=4+\frac{1}{24}\mu ^{2}+O"), "{text}");
    assert!(text.contains(r"\psi'=1-\frac{1}{16}\mu ^{2}+O"));
    let rayleigh = page("x'' + x = e*(x' - x'^3)", [5, 2]).unwrap();
    assert!(rayleigh.contains(r"A^{2}=\frac{4}{3}+O") && rayleigh.contains(r"\sqrt{4/3}"), "{rayleigh}");
    let both = page("x'' + x = e*(2*(1 - x^2)*x' - 3*x^3)", [5, 2]).unwrap();
    assert!(both.contains(r"\psi'=1+\frac{9}{2}e-"), "{both}");
    assert!(!page("x'' + c*x' + x = 0", [3, 2]).unwrap().contains("The limit cycle"));
}

#[test]
fn what_is_not_derived_is_refused_for_its_reason() {
    let refused = |equation: &str, orders| page(equation, orders).unwrap_err().to_string();
    assert!(refused("x'' + c*x' + x = 0", [10, 2]).contains("1 to 9"));
    assert!(refused("x'' + c*x' + x = 0", [3, 5]).contains("1 to 4"));
    assert!(refused("x'' + c*x' + 2*x = 0", [3, 2]).contains("unit of time"));
    assert!(refused("x'' + c*x'/(1 + x'^2) + x = 0", [3, 2]).contains("polynomials"));
    assert!(refused("x'' + x = 0", [3, 2]).contains("no parameter is symbolic"));
}

/// A cancellation keeps the completed steps; an immediate one leaves none.
#[test]
fn a_derivation_that_is_stopped_keeps_its_steps() {
    let equation: Equation = "x'' + c*x' + x = 0".parse().unwrap();
    let steps_after = |limit: usize| {
        let asked = Cell::new(0);
        let progress = |_: Status| {
            asked.set(asked.get() + 1);
            if asked.get() > limit { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let outcome = averaging(&equation, None, 1, 1, &progress);
        outcome.map(|derivation| derivation.steps.len())
    };
    assert!(matches!(steps_after(0), Err(DerivationError::Interrupted(_))));
    let whole = steps_after(usize::MAX).unwrap();
    let some: Vec<usize> = (1..30).step_by(4).filter_map(|limit| steps_after(limit).ok()).collect();
    assert!(
        some.iter().any(|steps| (1..whole).contains(steps)) && some.contains(&whole),
        "{some:?} of {whole}"
    );
}
