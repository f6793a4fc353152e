//! Answers to exercises: results are right, others are wrong with the terms that differ.

use crate::notebooks::DERIVATIONS;
use libration::progress::Quiet;
use libration_derivation::{
    AnswerError, Block, Derivation, Formula, Judgement, Name, Statement, Subscript, elliptic,
    first_correction, judgement_to_html, judgement_to_markdown, limit_cycle,
};

/// A name as it is typed.
fn typed_name(name: &Name) -> String {
    let below = match &name.subscript {
        None => String::new(),
        Some(Subscript::Word(word)) => format!("_{word}"),
        Some(Subscript::Index(index)) => typed(index),
    };
    format!("{}{below}{}", name.letter, "'".repeat(usize::from(name.primes)))
}

/// A formula as it is typed, without O(…).
fn typed(formula: &Formula) -> String {
    let joined = |parts: &[Formula], sign: &str| {
        let parts = parts.iter().filter(|part| !matches!(part, Formula::Order(_)));
        parts.map(|part| format!("({})", typed(part))).collect::<Vec<_>>().join(sign)
    };
    match formula {
        Formula::Number(value) => value.to_string(),
        Formula::Pi => "pi".to_owned(),
        Formula::Name(name) => typed_name(name),
        Formula::Negate(operand) => format!("-({})", typed(operand)),
        Formula::Sum(parts) => joined(parts, "+"),
        Formula::Product(parts) => joined(parts, "*"),
        Formula::Fraction(over, under) => format!("({})/({})", typed(over), typed(under)),
        Formula::Power(base, exponent) => format!("({})^({})", typed(base), typed(exponent)),
        Formula::Call(function, argument) => format!("{}({})", function.name(), typed(argument)),
        other => panic!("{other:?}"),
    }
}

/// The exercises with comparable answers: their numbers, and their results.
fn results(exercises: &Derivation) -> Vec<(String, &Formula)> {
    fn statements<'a>(step: usize, blocks: &'a [Block], all: &mut Vec<(String, &'a Statement)>) {
        for block in blocks {
            match block {
                Block::Equation { number, equation } => {
                    all.push((format!("{step}.{number}"), equation.statement()));
                }
                Block::Details { blocks, .. } => statements(step, blocks, all),
                _ => {}
            }
        }
    }
    let mut all = vec![];
    for (n, step) in exercises.answers.iter().enumerate() {
        statements(n + 1, &step.blocks, &mut all);
    }
    let comparable = exercises.comparable();
    let zero = Formula::Number(0.into());
    let result = |statement: &'_ Statement| statement.rest.last().is_none_or(|(_, side)| *side == zero);
    all.into_iter()
        .filter(|(number, _)| comparable.contains(number))
        .map(|(number, statement)| {
            (number, if result(statement) { &statement.first } else { &statement.rest.last().unwrap().1 })
        })
        .collect()
}

#[test]
fn every_result_is_right_and_wrong_with_another_number() {
    let mut count = 0;
    let is_highest = |(name, _): &&(String, Derivation)| !name.ends_with(['1', '2', '3', '4']);
    for (name, derivation) in DERIVATIONS.iter().filter(is_highest) {
        let exercises = derivation.clone().exercises();
        for (number, result) in results(&exercises) {
            let text = typed(result);
            let judged = exercises.judge(&number, &text).unwrap();
            assert_eq!(judged, Judgement::Right, "{name} ({number}): {text}");
            let other = format!("({text})+1/7");
            let judged = exercises.judge(&number, &other).unwrap();
            assert!(matches!(judged, Judgement::Wrong(_)), "{name} ({number}): {other}: {judged:?}");
            count += 1;
        }
    }
    assert!(count > 200, "{count}");
}

fn said(exercises: &Derivation, number: &str, answer: &str) -> String {
    judgement_to_markdown(&exercises.judge(number, answer).unwrap()).trim_end().to_owned()
}

#[test]
fn terms_that_differ_are_named() {
    let short = first_correction(None).unwrap().exercises();
    for (number, answer, sentence) in [
        ("3.1", "ω0² (1 - θ0²/8)", "right"),
        ("3.1", "omega_0^2 - (omega0*theta0)^2/8", "right"),
        ("3.1", "omega0^2*(1 - theta0^2/8 + theta0 - theta0 + psi - psi)", "right, but not simplified"),
        ("2.3", "cos(psi)^3", "right, but not simplified"),
        // What was found before may be used: ω in (3.1).
        ("4.1", "2*pi/omega", "right, but not simplified"),
        ("4.1", "T0*omega0/omega", "right"),
        (
            "3.1",
            "omega0^2*(1 - theta0^2/9)",
            r"wrong: the term in $\omega _{0}^{2}\theta _{0}^{2}$ has another coefficient",
        ),
        ("4.2", "theta0^2/16", "wrong: a term without symbols is missing"),
        ("4.2", "1 + theta0^2/16 + theta0^4", r"wrong: there is no term in $\theta _{0}^{4}$"),
        (
            "2.3",
            "3/4*cos(psi) + 1/4*sin(3*psi)",
            r"wrong: a term in $\cos 3\psi$ is missing; there is no term in $\sin 3\psi$",
        ),
    ] {
        assert_eq!(said(&short, number, answer), sentence, "({number}) {answer}");
    }
    // With θ0 = 0.55 and T0 = 9.27: 9.27/√(1 − 0.3025/7) = 9.477, and 9.450 with 8 in place of 7.
    let sentence = said(&short, "4.1", "T0/sqrt(1 - theta0^2/7)");
    assert!(
        sentence.starts_with("wrong: with $T_{0}$ = $9.2695$, ")
            && sentence.ends_with("it is $9.4765$, not $9.4499$"),
        "{sentence}"
    );
    let html = judgement_to_html(&short.judge("4.2", "theta0^2/16").unwrap());
    assert_eq!(html, "<p class=\"wrong\">wrong: a term without symbols is missing</p>\n");
}

/// In the third step k is defined as sin(θ0/2).
#[test]
fn definitions_may_be_written_out() {
    let exercises = elliptic(None).unwrap().exercises();
    assert_eq!(said(&exercises, "4.2", "2*(k^2 - sin(theta/2)^2)"), "right");
    assert_eq!(said(&exercises, "4.2", "2*(sin(theta0/2)^2 - sin(theta/2)^2)"), "right");
    let sentence = said(&exercises, "4.2", "2*(sin(theta0/3)^2 - sin(theta/2)^2)");
    assert!(sentence.starts_with("wrong: "), "{sentence}");
    // The result has powers of a sine, so that those of the answer are not expanded.
    let sentence = said(&exercises, "9.2", "1 + sin(theta0/2)^2/2");
    assert!(sentence.starts_with(r"wrong: the term in $\sin^{2}"), "{sentence}");
}

#[test]
fn conditions_may_have_factors_that_are_products() {
    let excited = "x'' - mu*(1 - x^2)*x' + x = 0".parse().unwrap();
    let exercises = limit_cycle(&excited, None, 4, &Quiet).unwrap().exercises();
    for (answer, sentence) in [
        ("-A_0 + A_0^3/4", "right"),
        ("A_0^2 - 4", "right"),
        ("12*A_0/mu - 3*A_0^3/mu", "right"),
        ("A_0^2 - 3", "wrong: the term in $A_{0}$ has another coefficient"),
        ("4*A_0 - 2*A_0^3", "wrong: the term in "),
        ("0", "wrong: "),
    ] {
        let judged = said(&exercises, "3.2", answer);
        assert!(
            judged == sentence || sentence.starts_with("wrong") && judged.starts_with(sentence),
            "{answer}: {judged}"
        );
    }
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let exercises = first_correction(None).unwrap().exercises();
    assert!(matches!(exercises.judge("9.9", "1"), Err(AnswerError::Number { .. })));
    assert!(matches!(exercises.judge("3.1", "(1"), Err(AnswerError::Formula(_))));
    assert!(matches!(exercises.judge("3.1", "zeta"), Err(AnswerError::Symbol { .. })));
    for answer in [
        "1/0",
        "ln(-1)",
        "exp(exp(exp(exp(exp(9)))))",
        "((((7^1000)^1000)^1000)^1000)^1000",
        "7^7^7^7^7^7",
        "((theta0 + 2)^40 + 1)^40",
    ] {
        assert_eq!(exercises.judge("3.1", answer), Err(AnswerError::NoValue), "{answer}");
    }
    // Sums whose powers have too many terms or digits to be expanded.
    for answer in ["(theta0 + omega0)^40^2", "(theta0+omega0+psi+omega+T0)^40"] {
        assert!(matches!(exercises.judge("3.1", answer), Ok(Judgement::Wrong(_))), "{answer}");
    }
    assert!(first_correction(None).unwrap().comparable().is_empty());
}
