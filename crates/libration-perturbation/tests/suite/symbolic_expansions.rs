//! Expansions with symbols compared with expansions with numbers, published coefficients and closed forms.

use crate::typed::equation;
use libration::algebra::{LaurentPolynomial, LetterPower, Rational};
use libration::expression::{Expression, Symbol};
use libration::oscillator::{Oscillator, SymbolicOscillator, SymbolicOscillatorError, SymbolicSeriesError};
use libration::perturbation::{
    AmplitudeSeries, Certificate, Expansion, ExpansionError, Gauge, HarmonicSeries, SymbolicExpansion,
    SymbolicExpansionError, expand, expand_symbolically,
};
use libration::progress::{Quiet, Status};
use libration_testing::golden::Table;
use std::collections::BTreeMap;
use std::ops::ControlFlow;

fn oscillator(text: &str) -> SymbolicOscillator {
    SymbolicOscillator::new(&equation(text)).unwrap()
}

fn expanded(text: &str, order: usize) -> SymbolicExpansion {
    expand_symbolically(&oscillator(text), order, &Gauge::Fundamental, &Quiet).unwrap()
}

fn texts(series: &[LaurentPolynomial]) -> Vec<String> {
    series.iter().map(LaurentPolynomial::to_string).collect()
}

/// The value of a coefficient that was written as text and is read as a formula.
fn value(coefficient: &LaurentPolynomial, values: &[(&str, &str)]) -> Rational {
    let formula: Expression = coefficient.to_string().parse().unwrap();
    let put = |formula: Expression, (name, value): &(&str, &str)| {
        formula.substitute(&Symbol::plain(name), &value.parse().unwrap())
    };
    match values.iter().fold(formula, put).simplified() {
        Expression::Number(number) => number,
        Expression::Negate(number) => match *number {
            Expression::Number(number) => -number,
            other => panic!("-({other}) is not a number"),
        },
        other => panic!("{other} is not a number"),
    }
}

/// All series of an expansion, with the names of their harmonics, so that none is left out.
fn all<C: Clone>(expansion: &Expansion<C>) -> Vec<(String, Vec<C>)> {
    let mut all = vec![("frequency".to_owned(), expansion.frequency_ratio.clone())];
    for HarmonicSeries { k, cos, sin } in &expansion.harmonics {
        all.extend([(format!("cos {k}"), cos.clone()), (format!("sin {k}"), sin.clone())]);
    }
    all.extend([("max".to_owned(), expansion.x_max.clone()), ("min".to_owned(), expansion.x_min.clone())]);
    for of in [&expansion.of_amplitude, &expansion.of_half_swing].into_iter().flatten() {
        let AmplitudeSeries { frequency_ratio, period_ratio, epsilon, harmonics } = of;
        for series in [frequency_ratio, period_ratio, epsilon] {
            all.push(("of an amplitude".to_owned(), series.clone()));
        }
        all.extend(harmonics.iter().map(|(k, series)| (format!("of an amplitude {k}"), series.clone())));
    }
    all
}

fn assert_the_numbers_agree(text: &str, values: &[(&str, &str)], order: usize, gauge: &Gauge) {
    let symbolic = expand_symbolically(&oscillator(text), order, gauge, &Quiet).unwrap();
    let given: Vec<_> = values.iter().map(|(name, value)| (*name, value.parse().unwrap())).collect();
    let with_values: Vec<_> = given
        .iter()
        .filter(|(name, _)| *name != "omega0")
        .map(|(name, value): &(_, Expression)| (*name, value.clone()))
        .collect();
    let numbers = Oscillator::new(&equation(text).with(&with_values).unwrap()).unwrap();
    let numbers = expand(&numbers, order, gauge, &Quiet).unwrap();
    assert_eq!(value(&symbolic.series.omega0_squared, values), numbers.omega0_squared, "{text}");
    let (symbolic, numbers) = (all(&symbolic.series), all(&numbers));
    assert_eq!(symbolic.len(), numbers.len(), "{text}");
    for ((name, series), (other, theirs)) in symbolic.iter().zip(&numbers) {
        let with_numbers: Vec<Rational> =
            series.iter().map(|coefficient| value(coefficient, values)).collect();
        assert_eq!((name, &with_numbers), (other, theirs), "{text}, {gauge}");
    }
}

#[test]
fn the_mixed_oscillator_has_its_known_corrections() {
    // A. H. Nayfeh, D. T. Mook, Nonlinear Oscillations, section 2.3: Ω = ω0(1 + (9α3ω0² − 10α2²)/(24ω0⁴) ε²), the mean
    // −α2ε²/(2ω0²), the second harmonic α2ε²/(6ω0²).
    let expansion = expanded("x'' + w^2*x + a*x^2 + b*x^3 = 0", 3);
    assert_eq!(texts(&expansion.series.frequency_ratio), ["1", "0", "3*b/(8*w^2) - 5*a^2/(12*w^4)"]);
    assert_eq!(texts(&expansion.series.harmonic(0).unwrap().cos)[2], "-a/(2*w^2)");
    assert_eq!(texts(&expansion.series.harmonic(2).unwrap().cos)[2], "a/(6*w^2)");
    assert_eq!(texts(&expansion.frequency().unwrap()), ["w", "0", "3*b/(8*w) - 5*a^2/(12*w^3)"]);
    assert_eq!(expansion.letters, ["a", "b", "w"]);
    assert_eq!((expansion.omega0_name, expansion.series.certificate), (None, Certificate::Potential));
}

/// The powers of the letters and the fraction of each term, as the table has them.
fn terms(coefficient: &LaurentPolynomial, letters: &[String]) -> String {
    let term = |(factor, powers): (&Rational, Vec<LetterPower<'_>>)| {
        let power = |letter: &String| {
            let present = powers.iter().find(|power| power.letter == letter);
            present.map_or_else(|| "0".to_owned(), |power| power.exponent.to_string())
        };
        let powers: Vec<String> = letters.iter().map(power).collect();
        format!("{} {factor}", powers.join(" "))
    };
    let mut terms: Vec<String> = coefficient.terms().map(term).collect();
    terms.sort();
    terms.join("; ")
}

#[test]
fn all_coefficients_are_those_of_another_algebra_system() {
    let table = Table::read("symbolic_expansions.csv");
    let mut compared = 0;
    for (text, order) in [
        ("x'' + w^2*x + a*x^2 + b*x^3 = 0", 9),
        ("x'' + k*x + b*x*x'^2 + c*x^3 = 0", 7),
        ("x'' + a*sin(k*x)/k = 0", 9),
    ] {
        let SymbolicExpansion { letters, series, .. } = expanded(text, order);
        let harmonics =
            series.harmonics.iter().map(|harmonic| (format!("cos {}", harmonic.k), harmonic.cos.clone()));
        let all = std::iter::once(("frequency".to_owned(), series.frequency_ratio.clone())).chain(harmonics);
        let computed: BTreeMap<(String, String), String> = all
            .flat_map(|(name, series)| {
                series.into_iter().enumerate().map(move |(n, coefficient)| (name.clone(), n, coefficient))
            })
            .filter(|(_, _, coefficient)| !coefficient.is_zero())
            .map(|(name, n, coefficient)| ((name, n.to_string()), terms(&coefficient, &letters)))
            .collect();
        let rows = table.rows().filter(|row| row.text("equation") == text);
        let expected: BTreeMap<(String, String), String> = rows
            .map(|row| ((row.text("quantity").into(), row.text("power").into()), row.text("terms").into()))
            .collect();
        assert_eq!(computed, expected, "{text}");
        compared += computed.len();
    }
    assert_eq!(compared, table.rows().count());
}

#[test]
fn numbers_in_the_place_of_letters_give_the_expansion_with_numbers() {
    let gauges = [Gauge::Fundamental, Gauge::XMax, Gauge::HalfSwing, Gauge::Energy];
    for gauge in gauges.into_iter().chain(["A1=2,A2=1/3".parse().unwrap()]) {
        let values = [("a", "2/7"), ("b", "-3/5"), ("w", "3")];
        assert_the_numbers_agree("x'' + w^2*x + a*x^2 + b*x^3 = 0", &values, 6, &gauge);
    }
    let fundamental = Gauge::Fundamental;
    assert_the_numbers_agree(
        "m*x'' + k*x + c*x^3 = 0",
        &[("m", "4"), ("k", "1/9"), ("c", "2")],
        7,
        &fundamental,
    );
    assert_the_numbers_agree("x'' + a*sinh(x/b) = 0", &[("a", "4"), ("b", "9")], 7, &Gauge::Energy);
    assert_the_numbers_agree("x'' + sqrt(a)*x/(b + x) = 0", &[("a", "4"), ("b", "9")], 5, &fundamental);
    assert_the_numbers_agree("x'' + g/l*sin(x) = 0", &[("g", "4"), ("l", "9")], 7, &Gauge::Nome);
}

#[test]
fn a_sum_under_the_root_keeps_a_name() {
    let text = "x'' + (k1 + k2)*x + k1*x^2 + c*x^3 = 0";
    let expansion = expanded(text, 3);
    assert_eq!(expansion.omega0_name.as_deref(), Some("omega0"));
    assert_eq!((expansion.omega0.clone(), expansion.frequency()), (None, None));
    // k1 = ω0² − k2 in −5k1²/(12ω0⁴), so that no ω0² hides in the sum.
    let expected = "-5/12 + 3*c/(8*omega0^2) + 5*k2/(6*omega0^2) - 5*k2^2/(12*omega0^4)";
    assert_eq!(texts(&expansion.series.frequency_ratio)[2], expected);
    let values = [("k1", "4"), ("k2", "5"), ("c", "-2"), ("omega0", "3")];
    assert_the_numbers_agree(text, &values, 6, &Gauge::HalfSwing);
    assert_eq!(expansion.series.certificate, Certificate::Potential);
    let pendulum = expanded("x'' + (k1 + k2)*sin(x) = 0", 5);
    assert_eq!(texts(&pendulum.series.frequency_ratio), ["1", "0", "-1/16", "0", "1/1024"]);
    let named = expanded("x'' + (omega0 + k)*x + omega0*x^3 = 0", 3);
    assert_eq!(named.omega0_name.as_deref(), Some("omega0_"), "the letter that is given keeps its name");
}

#[test]
fn a_sum_without_a_leading_letter_is_correct_all_the_same() {
    let values = [("a", "1"), ("b", "1"), ("c", "4"), ("omega0", "3")];
    assert_the_numbers_agree("x'' + (a*b + b*c + c*a)*x + a*x^2 + b*x^3 = 0", &values, 5, &Gauge::XMax);
    let values = [("a", "1/5"), ("b", "1/4"), ("omega0", "3")];
    assert_the_numbers_agree("x'' + (1/a + 1/b)*x + a*x^2 + b*x^3 = 0", &values, 5, &Gauge::Energy);
}

#[test]
fn velocities_that_run_back_are_expanded_with_letters_too() {
    for (text, values) in [
        ("x'' + k*x + b*x*x'^2 + c*x^3 = 0", [("k", "9/4"), ("b", "2/3"), ("c", "-1")]),
        ("x'' + 2*k*x + b*x*x'^2 + c*x^2 = 0", [("k", "2"), ("b", "2/3"), ("c", "-1")]),
    ] {
        assert_the_numbers_agree(text, &values, 6, &Gauge::XMax);
        assert_eq!(expanded(text, 5).series.certificate, Certificate::Substitution);
    }
    let values = [("k", "2"), ("m", "7"), ("b", "2/3"), ("omega0", "3")];
    assert_the_numbers_agree("x'' + (k + m)*x + b*x*x'^2 + k*x^3 = 0", &values, 5, &Gauge::Fundamental);
}

#[test]
fn an_equilibrium_may_be_a_formula_of_the_letters() {
    let wells = equation("x'' = a*x - b*x^3");
    let oscillator = SymbolicOscillator::about(&wells, &"sqrt(a/b)".parse().unwrap()).unwrap();
    assert_eq!(oscillator.equilibrium().to_string(), "sqrt(a)/sqrt(b)");
    assert_eq!(oscillator.omega0_squared().to_string(), "2*a");
    let expansion = expand_symbolically(&oscillator, 5, &Gauge::XMax, &Quiet).unwrap();
    let numbers = wells.with(&[("a", "4".parse().unwrap()), ("b", "9".parse().unwrap())]).unwrap();
    let numbers = expand(&Oscillator::new(&numbers).unwrap(), 5, &Gauge::XMax, &Quiet).unwrap();
    let of_letters = all(&expansion.series).into_iter().flat_map(|(_, series)| series);
    let computed: Vec<Rational> =
        of_letters.map(|coefficient| value(&coefficient, &[("a", "4"), ("b", "9")])).collect();
    assert_eq!(computed, all(&numbers).into_iter().flat_map(|(_, series)| series).collect::<Vec<_>>());
}

#[test]
fn the_pendulum_needs_no_letters_beyond_its_frequency() {
    let expansion = expanded("theta'' + g/l*sin(theta) = 0", 7);
    assert_eq!(expansion.omega0.as_ref().unwrap().to_string(), "sqrt(g)/sqrt(l)");
    assert_eq!(
        texts(&expansion.series.of_amplitude.unwrap().period_ratio),
        ["1", "0", "1/16", "0", "11/3072", "0", "173/737280"]
    );
}

#[test]
fn what_letters_do_not_allow_is_refused_with_the_reason() {
    let refused = |text: &str| SymbolicOscillator::new(&equation(text)).unwrap_err();
    let reason = |text: &str| match refused(text) {
        SymbolicOscillatorError::NoExpansion { reason, .. } => reason,
        other => panic!("{text}: {other}"),
    };
    assert_eq!(reason("x'' + a + x = 0"), SymbolicSeriesError::NotAtRest { acceleration: "-a".into() });
    assert_eq!(reason("x'' + a*x^3 = 0"), SymbolicSeriesError::NoLinearPart);
    assert_eq!(reason("x'' = a*x"), SymbolicSeriesError::Unstable { omega0_squared: "-a".into() });
    assert_eq!(reason("x'' + c*x' + k*x = 0"), SymbolicSeriesError::Damped { damping: "-c".into() });
    assert_eq!(reason("x'' + c*x'^3 + k*x = 0"), SymbolicSeriesError::Irreversible);
    for text in [
        "x'' + k*x + a*exp(b + x) = 0",
        "x'' + k*x/(a + b + x) = 0",
        "x'' + a*x + b*abs(x) = 0",
        "x'' + a*x + x^b = 0",
    ] {
        let refusal = match SymbolicOscillator::new(&equation(text)) {
            Ok(oscillator) => expand_symbolically(&oscillator, 3, &Gauge::Fundamental, &Quiet)
                .map(|_| ())
                .map_err(|refusal| refusal.to_string()),
            Err(refusal) => Err(refusal.to_string()),
        };
        assert!(refusal.is_err(), "{text}");
    }
    assert!(refused("x'' + a*x = cos(t)").to_string().contains("depends on t"));
    let unlike = expand_symbolically(&oscillator("x'' + w^2*x + a*x^3 = 0"), 3, &Gauge::Nome, &Quiet);
    assert_eq!(unlike, Err(SymbolicExpansionError::Expansion(ExpansionError::NomeOfOther)));
    let reversible = expand_symbolically(&oscillator("x'' + x + a*x*x'^2 = 0"), 3, &Gauge::Energy, &Quiet);
    assert_eq!(reversible, Err(SymbolicExpansionError::Expansion(ExpansionError::EnergyOfVelocity)));
}

#[test]
fn constants_that_no_product_of_letters_is_have_names() {
    let constants = |expansion: &SymbolicExpansion| {
        expansion
            .constants
            .iter()
            .map(|(name, value)| format!("{name} = {value}"))
            .collect::<Vec<_>>()
            .join(", ")
    };
    let root = expanded("x'' + sqrt(2)*x + a*x^3 = 0", 3);
    assert_eq!(constants(&root), "c1 = sqrt(2)");
    assert_eq!(texts(&root.series.frequency_ratio)[2], "3*a/(8*c1)");
    let circle = expanded("x'' + pi^2*x + a*exp(c1)*x^3 - exp(c1)*x^3 = 0", 3);
    assert_eq!(
        (constants(&circle), circle.omega0.as_ref().unwrap().to_string()),
        ("pi = pi, c2 = exp(c1)".into(), "pi".into())
    );
    assert_eq!(texts(&circle.series.frequency_ratio)[2], "-3*c2/(8*pi^2) + 3*a*c2/(8*pi^2)");
    assert_eq!(circle.series.certificate, Certificate::Potential);
    let power = expanded("x'' + k*(1 + x)^pi - k = 0", 3);
    assert_eq!(power.series.omega0_squared.to_string(), "k*pi");
    // −F/ω0² = x + (π − 1)x²/2 + (π − 1)(π − 2)x³/6 + …, and Ω/ω0 = 1 + (3b/8 − 5a²/12)ε² + ….
    // (3/8)(π − 1)(π − 2)/6 − (5/12)(π − 1)²/4 by hand.
    assert_eq!(texts(&power.series.frequency_ratio)[2], "1/48 + pi/48 - pi^2/24");
}

#[test]
fn too_many_terms_end_in_a_refusal() {
    let many = expanded("x'' + x + (a + b + c + d)^40*x^3 + k/(a + b)*x^5 = 0", 5);
    assert_eq!(
        texts(&many.series.frequency_ratio)[4],
        "5*c2/16 - 15*c1^2/256",
        "it stands for what is too long"
    );
    assert_eq!(many.constants[1].1.to_string(), "k/(a + b)");
    let growing = oscillator("x'' + x + (a + b + c + d)^9*x^3 = 0");
    assert!(expand_symbolically(&growing, 3, &Gauge::Fundamental, &Quiet).is_ok());
    let refusal = expand_symbolically(&growing, 7, &Gauge::Fundamental, &Quiet).unwrap_err();
    assert_eq!(refusal, SymbolicExpansionError::TooManyTerms);
}

#[test]
fn high_powers_of_letters_are_checked_too() {
    let expansion = expanded("x'' + w*x + a^5000*x^3 = 0", 5);
    assert_eq!(texts(&expansion.series.frequency_ratio)[2], "3*a^5000/(8*w)");
    assert_eq!(expansion.series.certificate, Certificate::Potential);
}

#[test]
fn what_is_found_before_an_interruption_is_kept() {
    let oscillator = oscillator("x'' + w^2*x + a*x^2 + b*x^3 = 0");
    let progress = |status: Status| {
        if status.done < 4 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let stopped = expand_symbolically(&oscillator, 9, &Gauge::Fundamental, &progress);
    let Err(SymbolicExpansionError::Interrupted { known: Some(partial) }) = stopped else {
        panic!("not interrupted: {stopped:?}")
    };
    let whole = expand_symbolically(&oscillator, partial.series.order, &Gauge::Fundamental, &Quiet).unwrap();
    assert!((1..9).contains(&partial.series.order));
    assert_eq!(all(&partial.series), all(&whole.series));
    assert_eq!(partial.series.certificate, Certificate::Unchecked);
}
