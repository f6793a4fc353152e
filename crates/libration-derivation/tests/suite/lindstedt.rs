//! Rejection of motions that are not solutions.

use libration::algebra::{Polynomial, Rational, Variable};
use libration::internals::progress::Watch;
use libration::oscillator::{NamedOscillator, Oscillator};
use libration::perturbation::{Gauge, TruncatedSystem};
use libration::progress::Quiet;
use libration::quantity::Displacement;
use libration_derivation::internals::lindstedt::{
    Contributions, Elimination, LindstedtQuestion, as_given, check_contributions, check_three_harmonics,
    exactly_at, few_harmonics, fundamental_and_harmonics, has_harmonics, motion, motion_in_numbers, solves,
};
use libration_derivation::{
    Block, Formula, Name, Prose, Released, Span, formula_latex, perturbation, to_markdown,
};

fn question(key: &str, order: usize) -> LindstedtQuestion {
    let oscillator = NamedOscillator::by_key(key).unwrap().oscillator(&[]).unwrap();
    LindstedtQuestion::new(&oscillator, order, &Gauge::Fundamental, &Watch::new(&Quiet)).unwrap()
}

#[test]
fn every_single_coefficient_matters_to_the_equation_of_motion() {
    let of = |equation: &str| {
        let oscillator = Oscillator::new(&equation.parse().unwrap()).unwrap();
        LindstedtQuestion::new(&oscillator, 4, &Gauge::Fundamental, &Watch::new(&Quiet)).unwrap()
    };
    for (key, question) in [
        ("pendulum", question("pendulum", 5)),
        ("quadratic", question("quadratic", 4)),
        ("symbol", of("x'' + x + sqrt(2)*x^2 = 0")),
        ("velocity", of("x'' + x + x*x'^2 - x'^2/3 = 0")),
    ] {
        let order = if key == "pendulum" { 5 } else { 4 };
        let right = motion(&question, &question.solution);
        assert!(solves(&question, &right).is_ok());
        for (index, (k, series)) in right.harmonics.iter().enumerate() {
            for n in (0..series.len()).filter(|n| *k != 1 || *n == 0) {
                let mut wrong = motion(&question, &question.solution);
                wrong.harmonics[index].1[n] = series[n].clone() + millionth();
                assert!(solves(&question, &wrong).is_err(), "{key} {k} {n}");
            }
        }
        for n in 0..order {
            let mut wrong = motion(&question, &question.solution);
            wrong.frequency[n] = wrong.frequency[n].clone() + millionth();
            assert!(solves(&question, &wrong).is_err(), "{key} frequency {n}");
        }
    }
}

fn millionth() -> Polynomial {
    Polynomial::constant(Rational::new(1, 1_000_000).unwrap())
}

#[test]
fn wrong_harmonics_of_the_residual_are_noticed() {
    let question = question("pendulum", 3);
    let right = motion(&question, &question.solution);
    assert!(has_harmonics(&question, &right, 3, &[]).is_ok());
    assert!(has_harmonics(&question, &right, 3, &[(3, Polynomial::constant(Rational::from(1)))]).is_err());
}

#[test]
fn the_exact_motion_beside_the_series_is_the_same_motion() {
    // At x_max = 0.01 the omitted terms of fifth order are about 1e-10.
    for (key, harmonics) in [("pendulum", 2), ("quadratic", 5), ("double_well", 5)] {
        let question = question(key, 4);
        let amplitude = Displacement::from_f64(0.01).unwrap();
        let released = Released { amplitude, angular_frequency: Some(1.0) };
        let exactly = exactly_at(&question, &released.amplitude, &Watch::new(&Quiet)).unwrap();
        let table = motion_in_numbers(&question, &released, &exactly).unwrap();
        let number = |prose: &Prose| match prose.0.as_slice() {
            [Span::Formula(Formula::Decimal(decimal))] => decimal.value().unwrap().to_f64(),
            other => panic!("{other:?} is not a number"),
        };
        let rows: Vec<_> = table.rows.iter().skip(1).collect();
        assert_eq!(rows.len(), 3 + harmonics, "{key}");
        for row in rows {
            let (series, exact) = (number(&row[1]), number(&row[2]));
            assert!((series - exact).abs() < 1e-7 * exact.abs().max(0.01), "{key}: {series} is not {exact}");
        }
    }
}

/// With the sine truncated after its cube, two harmonics have four solutions; the one sought does not exist at 170°.
#[test]
fn the_solutions_of_two_harmonics_are_listed_with_their_verdicts() {
    let verdicts = |key: &str, order: usize, amplitude: f64| {
        let amplitude = Displacement::from_f64(amplitude).unwrap();
        let released = Released { amplitude, angular_frequency: None };
        let step = few_harmonics(&question(key, order), Some(&released), &Watch::new(&Quiet)).unwrap()?;
        let tables = step.blocks.into_iter().filter_map(|block| match block {
            Block::Table(table) => Some(table),
            _ => None,
        });
        let rows = tables.flat_map(|table| table.rows);
        let last = |row: Vec<Prose>| match row.last()?.0.as_slice() {
            [Span::Text(verdict)] => Some(verdict.clone()),
            _ => None,
        };
        rows.map(last).collect::<Option<Vec<String>>>()
    };
    let words = |words: [&str; 4]| Some(words.map(str::to_owned).to_vec());
    let far = ["accepted", "no first harmonic", "not a small swing", "nothing oscillates"];
    assert_eq!(verdicts("pendulum", 5, 1.5), words(far));
    assert_eq!(verdicts("duffing", 3, 0.8), words(["accepted", "no first harmonic", "complex", "complex"]));
    let lost = ["nothing oscillates", "nothing oscillates", "complex", "complex"];
    assert_eq!(verdicts("pendulum", 5, 2.967), words(lost));
    assert_eq!(verdicts("pendulum", 2, 0.7), None);
    assert_eq!(verdicts("quadratic", 4, 0.1), None);
}

/// The ansatz shows every coefficient that the section on the gauge counts, and the conditions every one that vanishes.
#[test]
fn as_many_coefficients_are_shown_as_are_counted() {
    for (key, order) in
        [("pendulum", 2), ("pendulum", 5), ("pendulum", 7), ("quadratic", 3), ("helmholtz_duffing", 4)]
    {
        let question = question(key, order);
        let ansatz = fundamental_and_harmonics(&question);
        let names = |formula: &Formula| {
            question.open.unknowns().iter().filter(|unknown| contains(formula, unknown)).count()
        };
        let statements = ansatz.blocks.iter().filter_map(|block| match block {
            Block::Equation { equation, .. } => Some(equation.statement()),
            _ => None,
        });
        let shown: usize =
            statements.flat_map(|statement| &statement.rest).map(|(_, formula)| names(formula)).sum();
        assert_eq!(shown, question.open.unknowns().len(), "{key} to order {order}");
    }
}

fn contains(formula: &Formula, unknown: &Variable) -> bool {
    match formula {
        Formula::Name(name) => *name == Name::from(unknown),
        Formula::Sum(parts) | Formula::Product(parts) => parts.iter().any(|part| contains(part, unknown)),
        _ => false,
    }
}

#[test]
fn an_amplitude_is_shown_as_it_was_given() {
    let (pendulum, quadratic) = (question("pendulum", 3), question("quadratic", 3));
    let shown = |question: &LindstedtQuestion, text: &str| {
        let amplitude = Displacement::from_angle_text(text).unwrap();
        formula_latex(&as_given(question, &amplitude))
    };
    assert_eq!(shown(&pendulum, "60deg"), "60^{\\circ}");
    assert_eq!(shown(&pendulum, "37.3deg"), "37.3^{\\circ}");
    assert_eq!(shown(&pendulum, "pi-1e-3"), "3.14059265358979\\,\\mathrm{rad}");
    assert_eq!(shown(&quadratic, "0.1"), "0.1");
}

/// The parts of a condition, with the results of lower orders inserted, add up to the condition.
#[test]
fn contributions_become_the_conditions() {
    for (key, order) in [("pendulum", 5), ("quadratic", 3), ("helmholtz_duffing", 3), ("cubic_quintic", 5)] {
        let question = question(key, order);
        let contributions = Contributions::new(&question);
        for condition in question.open.conditions() {
            let lower = |unknown: &Variable| {
                let is_new_ratio =
                    unknown.letters() == "d" && unknown.index() == condition.order.checked_sub(1);
                let is_new =
                    is_new_ratio || unknown.letters() != "d" && unknown.index() == Some(condition.order);
                if is_new { None } else { question.open.solution().get(unknown) }
            };
            let sum = contributions.sum(condition.order, condition.harmonic);
            let solved = sum
                .variables()
                .into_iter()
                .filter_map(|variable| Some((lower(&variable)?.clone(), variable)));
            let inserted =
                solved.fold(sum.clone(), |sum, (value, variable)| sum.substitute(&variable, &value));
            let alone = condition.polynomial.terms().count() == 1 && condition.harmonic != 1;
            let expected = if alone { Polynomial::zero() } else { condition.polynomial.clone() };
            assert_eq!(inserted, expected, "{key} {} {}", condition.order, condition.harmonic);
        }
    }
}

/// A part that does not follow from the equation of motion is rejected.
#[test]
fn every_contribution_is_checked() {
    for (key, order) in [("pendulum", 5), ("quadratic", 3)] {
        let question = question(key, order);
        let right = Contributions::new(&question);
        let keys: Vec<(usize, (u32, u32))> = (right.parts.iter().enumerate())
            .flat_map(|(part, (_, factors))| factors.keys().map(move |key| (part, *key)))
            .collect();
        for (part, (power, harmonic)) in keys {
            let mut wrong = Contributions::new(&question);
            let factor = wrong.parts[part].1.get_mut(&(power, harmonic)).unwrap();
            *factor = factor.clone() + Polynomial::constant(Rational::new(1, 1_000_000).unwrap());
            let at = usize::try_from(power).unwrap();
            assert!(check_contributions(&question, &right, at).is_ok(), "{key} {power}");
            assert!(check_contributions(&question, &wrong, at).is_err(), "{key} {part} {power} {harmonic}");
        }
    }
}

/// Equations (22) and (23) of Black and Vel, and their consequences, are compared with the cube of two harmonics.
#[test]
fn the_elimination_of_two_harmonics_is_checked() {
    let question = question("pendulum", 5);
    let right = || Elimination::new(&question).unwrap();
    assert!(right().check().is_ok());
    assert_eq!(right().conditions[0].to_string(), "-8 + a1^2 + a1*a3 + 2*a3^2 + 8*Delta^2");
    let off = || Polynomial::variable("a3").scaled(&Rational::new(1, 1_000_000).unwrap());
    let wrong = |change: fn(&mut Elimination, Polynomial)| {
        let mut elimination = right();
        change(&mut elimination, off());
        assert!(elimination.check().is_err());
    };
    wrong(|elimination, off| elimination.conditions[0] = elimination.conditions[0].clone() + off);
    wrong(|elimination, off| elimination.conditions[1] = elimination.conditions[1].clone() + off);
    wrong(|elimination, off| elimination.ratio_squared = elimination.ratio_squared.clone() + off);
    wrong(|elimination, off| elimination.left = elimination.left.clone() + off);
}

#[test]
fn the_equations_of_three_harmonics_are_checked() {
    for key in ["pendulum", "duffing", "cubic_quintic"] {
        let question = question(key, 5);
        let conditions = TruncatedSystem::new(&question.force, 3, 5).unwrap().conditions();
        assert!(check_three_harmonics(&question, &conditions).is_ok(), "{key}");
        for index in 0..3 {
            let mut wrong = conditions.clone();
            wrong[index] = wrong[index].clone() + Polynomial::variable("a5");
            assert!(check_three_harmonics(&question, &wrong).is_err(), "{key} {index}");
        }
    }
}

/// θ³ with A₁cos τ twice and A₃ε³cos τ once has three orderings, and cos³τ has ¾ of cos τ; with B₃cos 3τ, cos²τ·cos 3τ has ¼ of cos τ and ½
/// of cos 3τ.
#[test]
fn conditions_show_the_products_that_they_come_from() {
    let pendulum = NamedOscillator::by_key("pendulum").unwrap().oscillator(&[]).unwrap();
    let derivation = perturbation(&pendulum, 5, &Gauge::Fundamental, None, &Quiet).unwrap();
    let text = to_markdown(&derivation);
    for product in [
        r"\left(1-3^{2}\right)B_{1}=0",
        r"$-2d_{2}A_{1}$",
        r"$-\frac{1}{6}\cdot \frac{3}{4}A_{1}^{3}$",
        r"$-\frac{1}{6}\cdot 3\cdot \frac{3}{4}A_{1}^{2}A_{3}-\frac{1}{6}\cdot 3\cdot \frac{1}{4}A_{1}^{2}B_{3}$",
        r"$-\frac{1}{6}\cdot 3\cdot \frac{1}{4}A_{1}^{2}A_{3}-\frac{1}{6}\cdot 3\cdot \frac{1}{2}A_{1}^{2}B_{3}$",
        r"$-\left(2d_{4}+d_{2}^{2}\right)A_{1}-2d_{2}A_{3}$",
        r"$-9\cdot 2d_{2}B_{3}+\left(1-3^{2}\right)B_{5}$",
    ] {
        assert!(text.contains(product), "{product}");
    }
    // A column in each table of these orders, and of the even powers that are excluded.
    let tables = text.matches("products that it comes from").count();
    assert_eq!(tables, text.matches("has the parts").count());
    assert!(tables >= 7, "{tables}");
}
