//! Derivations are complete, wrong formulas are rejected, and every printed formula was checked.

use libration::algebra::{Function, Rational};
use libration::oscillator::{NamedOscillator, Oscillator};
use libration::pendulum::{Amplitude, Pendulum};
use libration::perturbation::Gauge;
use libration::progress::Quiet;
use libration_derivation::internals::build::{
    call, double_factorial, integral, letter, number, order, series, sin, sqrt, sum,
};
use libration_derivation::internals::{
    Given, Trials, equal_fractions, same_series, same_series_where, theta_0,
};
use libration_derivation::{
    Block, Check, CheckedEquation, Derivation, DerivationError, DerivationStep, Formula, Name, Prose,
    Released, Span, Statement, Swing, averaging, elliptic, first_correction, formula_latex, formulas,
    limit_cycle, perturbation, statement_latex, to_html, to_latex, to_markdown,
};

fn swing(degrees: f64) -> Swing {
    let angle = libration::quantity::Angle::from_degrees(degrees).unwrap();
    Swing { pendulum: Pendulum::new(0.57, 9.81).unwrap(), amplitude: Amplitude::new(angle).unwrap() }
}

fn equations(derivation: &Derivation) -> Vec<&CheckedEquation> {
    numbered(&derivation.steps).into_iter().map(|(_, equation)| equation).collect()
}

/// The formulas of steps with their numbers, including folded ones.
fn numbered(steps: &[DerivationStep]) -> Vec<(String, &CheckedEquation)> {
    fn in_blocks<'a>(id: &str, blocks: &'a [Block], equations: &mut Vec<(String, &'a CheckedEquation)>) {
        for block in blocks {
            match block {
                Block::Equation { number, equation } => equations.push((format!("{id}.{number}"), equation)),
                Block::Details { blocks, .. } => in_blocks(id, blocks, equations),
                _ => {}
            }
        }
    }
    let mut equations = vec![];
    steps.iter().for_each(|step| in_blocks(&step.id, &step.blocks, &mut equations));
    equations
}

fn every_road() -> Vec<Derivation> {
    let swing = swing(40.0);
    let perturbation = |key, order, gauge| derived(key, order, gauge).unwrap();
    vec![
        elliptic(Some(&swing)).unwrap(),
        formulas(Some(&swing)).unwrap(),
        perturbation("pendulum", 7, "fundamental"),
        perturbation("pendulum", 4, "A1=1,A2=1/2"),
        perturbation("helmholtz_duffing", 5, "energy"),
        averaged("theta'' + c*theta'*abs(theta') + sin(theta) = 0", 4, 2),
        averaged("x'' - mu*(1 - x^2)*x' + x = 0", 5, 2),
        limit_cycle(&"x'' - mu*(1 - x^2)*x' + x = 0".parse().unwrap(), None, 3, &Quiet).unwrap(),
    ]
}

#[test]
fn steps_and_formulas_are_numbered_and_linked_by_ids_of_their_own() {
    for derivation in every_road() {
        for step in &derivation.steps {
            let numbers: Vec<String> =
                numbered(std::slice::from_ref(step)).into_iter().map(|(id, _)| id).collect();
            let expected: Vec<String> = (1..=numbers.len()).map(|n| format!("{}.{n}", step.id)).collect();
            assert_eq!(numbers, expected);
        }
        for page in [to_html(&derivation), to_html(&derivation.clone().exercises())] {
            let ids: Vec<&str> =
                page.split(" id=\"").skip(1).map(|rest| &rest[..rest.find('"').unwrap()]).collect();
            let links = page.split(" href=\"#").skip(1).map(|rest| &rest[..rest.find('"').unwrap()]);
            let distinct: std::collections::BTreeSet<&&str> = ids.iter().collect();
            assert_eq!(distinct.len(), ids.len(), "{}", derivation.title);
            assert!(links.clone().count() > 20);
            links.for_each(|link| assert!(ids.contains(&link), "{link}"));
        }
    }
}

/// Exercises do not state a result before the answers, and every result is requested or stated.
#[test]
fn exercises_leave_out_the_results_and_answer_them_at_the_end() {
    for derivation in every_road() {
        let exercises = derivation.clone().exercises();
        let (told, answers) = (numbered(&exercises.steps), numbered(&exercises.answers));
        let mut all: Vec<_> = told.iter().chain(&answers).cloned().collect();
        let mut expected = numbered(&derivation.steps);
        all.sort_by(|a, b| a.0.cmp(&b.0));
        expected.sort_by(|a, b| a.0.cmp(&b.0));
        assert_eq!(all, expected);
        for (id, equation) in &told {
            let is_result =
                equation.check().is_computed() && !matches!(equation.check(), Check::Catalogued { .. });
            assert!(!is_result, "{id} is told");
        }
        let without = Derivation { answers: vec![], ..exercises.clone() };
        let (page, whole) = (to_markdown(&without), to_markdown(&exercises));
        for (id, equation) in &answers {
            let result = equation.statement().rest.last().map(|(_, side)| formula_latex(side)).unwrap();
            let (shown, number) = (statement_latex(equation.statement()), id.rsplit('.').next().unwrap());
            // A remainder O(…) is not a result: it is to be proved, and its check is an answer.
            let is_to_be_shown = matches!(equation.statement().rest.last(), Some((_, Formula::Order(_))));
            assert_eq!(page.contains(&format!("{shown}\n\\tag{{")), is_to_be_shown, "{shown}");
            assert!(whole.contains(&format!("{shown}\n\\tag{{")), "{shown}");
            assert!(whole.matches(&format!(".{number}}}")).count() >= 2);
            // A fraction with a large denominator occurs nowhere else.
            if result.contains("{1835008}") {
                assert!(!page.contains("1835008"), "{result}");
            }
        }
    }
}

fn fraction(numerator: i64, denominator: i64) -> Formula {
    Rational::new(numerator, denominator).unwrap().into()
}

#[test]
fn every_formula_of_every_road_passes_its_check_at_low_and_high_amplitudes() {
    for degrees in [0.01, 40.0, 179.9] {
        for road in [elliptic, formulas] {
            let derivation = road(Some(&swing(degrees))).unwrap();
            let computed = |equation: &&&CheckedEquation| {
                !matches!(equation.check(), Check::Definition | Check::Premise)
            };
            assert!(equations(&derivation).iter().filter(computed).count() > 20);
        }
    }
    assert!(matches!(elliptic(Some(&swing(179.95))), Err(DerivationError::Amplitude { .. })));
}

/// Two printed pages have about 5 000 characters. T0(1 + θ0²/16) of 0.57 m under 9.81 m/s² at 40° is 1.5606829 s (mpmath).
#[test]
fn the_first_correction_takes_two_pages() {
    assert!(matches!(first_correction(Some(&swing(160.1))), Err(DerivationError::Amplitude { .. })));
    for degrees in [0.01, 40.0, 159.9] {
        let derivation = first_correction(Some(&swing(degrees))).unwrap();
        let compared = equations(&derivation)
            .iter()
            .filter(|equation| matches!(equation.check(), Check::Digits { .. }))
            .count();
        assert!(compared >= 6, "{degrees}: {compared}");
    }
    let text = to_markdown(&first_correction(Some(&swing(40.0))).unwrap());
    assert!(text.contains(r"\frac{\theta _{0}^{2}}{16}") && text.contains("1.5606829"), "{text}");
    assert!(to_markdown(&first_correction(None).unwrap()).chars().count() < 7_000, "{text}");
}

#[test]
fn wrong_formulas_fail_their_checks() {
    let trials = Trials::new(None).unwrap();
    // The document's sum, which begins with n = 1, lacks its first term.
    let sum = |from| {
        series(
            "n",
            from,
            (double_factorial(2 * letter("n") - 1) / double_factorial(2 * letter("n")))
                * letter("x").pow(letter("n")),
        )
    };
    let root = || number(1) / sqrt(number(1) - letter("x"));
    let x = Name::new("x");
    assert!(same_series(&x, 10, Statement::equal(root(), sum(0))).is_ok());
    assert!(matches!(
        same_series(&x, 10, Statement::equal(root(), sum(1))),
        Err(DerivationError::Failed { .. })
    ));
    let nearly =
        Statement::equal(sin(theta_0()), sin(theta_0()) * (number(1) + fraction(1, 1_000_000_000_000_000)));
    assert!(matches!(trials.compare(nearly.clone()), Err(DerivationError::Failed { .. })));
    assert!(trials.compare_with_library(nearly).is_ok());
    assert!(equal_fractions(Statement::equal(fraction(1, 3), fraction(33, 100))).is_err());
}

#[test]
fn a_series_is_compared_only_as_far_as_it_is_known() {
    let (x, name) = (letter("x"), Name::new("x"));
    let cut = || number(1) + x.clone() + order(x.clone().squared());
    let exponential = || call(Function::Exp, x.clone());
    assert!(same_series(&name, 2, Statement::equal(exponential(), cut())).is_ok());
    assert!(same_series(&name, 3, Statement::equal(exponential(), cut())).is_err());
    let given = [Given::Value(Name::new("y"), exponential())];
    let power = Statement::equal(letter("y").pow(fraction(1, 2)), call(Function::Exp, x.clone() / 2));
    assert!(same_series_where(&name, 9, &given, power).is_ok());
}

#[test]
fn integrals_with_infinite_ends_keep_half_of_the_digits() {
    let trials = Trials::new(None).unwrap();
    let root = integral("x", 0, 1, number(1) / sqrt(letter("x")));
    assert!(trials.compare_once(Statement::equal(root, number(2))).is_ok());
    let beta = integral("x", 0, 1, number(1) / sqrt(letter("x") * (number(1) - letter("x"))));
    assert!(trials.compare_once(Statement::equal(beta, Formula::Pi)).is_ok());
    let divergent = integral("x", 0, 1, number(1) / letter("x"));
    assert!(trials.compare_once(Statement::equal(divergent, number(1))).is_err());
}

#[test]
fn numbers_of_the_swing_are_given_only_when_it_is() {
    let digits = |derivation: &Derivation| {
        equations(derivation).iter().filter(|equation| *equation.check() == Check::RoundedDigits).count()
    };
    assert_eq!(digits(&elliptic(None).unwrap()), 0);
    assert!(digits(&elliptic(Some(&swing(40.0))).unwrap()) > 5);
    // 0.57 m, 9.81 m/s², 40°: T = 2π√(l/g)/agm(1, cos 20°), by mpmath.
    assert!(to_markdown(&elliptic(Some(&swing(40.0))).unwrap()).contains(PERIOD_AT_40_DEGREES));
}

const PERIOD_AT_40_DEGREES: &str = "1.5620138239";

#[test]
fn formulas_are_printed_with_the_brackets_they_need() {
    let (a, b) = (|| letter("a"), || letter("b"));
    for (formula, expected) in [
        ((a() + b()) * a(), r"\left(a+b\right)a"),
        (a() - (a() - b()), r"a-\left(a-b\right)"),
        (a() - fraction(1, 2) * b(), r"a-\frac{1}{2}b"),
        ((a() * b()).squared(), r"\left(ab\right)^{2}"),
        (fraction(1, 2).pow(2), r"\left(\frac{1}{2}\right)^{2}"),
        (sin(a()).squared(), r"\sin^{2} a"),
        (sin(a() + b()) * a(), r"\sin\left(a+b\right)\,a"),
        (sin(a()) * a(), r"\sin\left(a\right)\,a"),
        (2 * number(3).pow(a()), r"2\cdot 3^{a}"),
        (-(a() + b()), r"-\left(a+b\right)"),
        (Name::new("θ").index(0).prime().into(), r"\theta'_{0}"),
    ] {
        assert_eq!(formula_latex(&formula), expected);
    }
}

#[test]
fn text_is_harmless_in_every_form() {
    let hostile = "<b>&\\frac{$#_%^~|*[x](y)`";
    let derivation = Derivation {
        title: hostile.to_owned(),
        introduction: vec![Block::Paragraph(Prose(vec![Span::Text(hostile.to_owned())]))],
        steps: vec![],
        answers: vec![],
    };
    assert!(!to_html(&derivation).contains("<b>"));
    assert!(!to_latex(&derivation).contains("\\frac"));
    assert!(to_markdown(&derivation).contains(r"&lt;b>&amp;\\frac{\$\#\_%^~\|\*\[x\](y)\`"));
}

fn averaged(equation: &str, order: usize, damping_order: usize) -> Derivation {
    averaging(&equation.parse().unwrap(), None, order, damping_order, &Quiet).unwrap()
}

fn derived(key: &str, order: usize, gauge: &str) -> Result<Derivation, DerivationError> {
    let oscillator = NamedOscillator::by_key(key).unwrap().oscillator(&[]).unwrap();
    let gauge: Gauge = gauge.parse().unwrap();
    let amplitude = libration::quantity::Displacement::from_f64(0.2).unwrap();
    let released = Released { amplitude, angular_frequency: None };
    perturbation(&oscillator, order, &gauge, Some(&released), &Quiet)
}

#[test]
fn perturbation_is_derived_for_symmetric_and_asymmetric_wells_in_every_gauge() {
    for (key, order) in [
        ("pendulum", 9),
        ("duffing", 7),
        ("x_over_sqrt", 5),
        ("quadratic", 4),
        ("double_well", 5),
        ("morse", 4),
    ] {
        for gauge in ["fundamental", "x_max", "half_swing", "energy", "A1=2,A2=1/3,A3=-1"] {
            let derivation = derived(key, order, gauge).unwrap();
            let put_back = |equation: &&&CheckedEquation| matches!(equation.check(), Check::Phases { .. });
            assert_eq!(equations(&derivation).iter().filter(put_back).count(), 2, "{key} {gauge}");
        }
    }
}

#[test]
fn perturbation_is_refused_where_it_is_not_exact() {
    let mirrored = Oscillator::new(&"x'' + x + x*x' = 0".parse().unwrap()).unwrap();
    let refused = perturbation(&mirrored, 5, &Gauge::Fundamental, None, &Quiet);
    assert!(matches!(refused, Err(DerivationError::Velocity)));
    assert!(matches!(derived("pendulum", 10, "fundamental"), Err(DerivationError::Order { order: 10 })));
    let two_sided = Oscillator::new(&"x'' + x + max(x, 0)^2 = 0".parse().unwrap()).unwrap();
    let refused = perturbation(&two_sided, 3, &Gauge::Fundamental, None, &Quiet);
    assert!(matches!(refused, Err(DerivationError::TwoSided)));
    assert!(matches!(derived("duffing", 5, "nome"), Err(DerivationError::Expansion(_))));
}

#[test]
fn long_sums_are_broken_before_a_sign() {
    let term = |n: i64| fraction(123_456_789 + n, 1_000_003) * letter("x").pow(n);
    let long = sum((2..12).map(term).collect());
    let latex = statement_latex(&Statement::equal(letter("y"), long));
    assert!(latex.starts_with("\\begin{aligned}\ny&=") && latex.contains("\\\\\n&\\quad +"), "{latex}");
}
