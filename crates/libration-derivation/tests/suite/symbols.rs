//! Oscillators with symbols, with constants that are not fractions, and with velocities in the force.
//!
//! The coefficients were computed by `SymPy`: the equation of motion with x(0) = A, x′(0) = 0, power by power of A, with Laurent polynomials in
//! exp(iΩt).

use libration::comparison::{ExactMotion, SeriesQuantity};
use libration::expression::{Equation, Expression};
use libration::internals::progress::Watch;
use libration::oscillator::{NumbersOrLetters, Oscillator};
use libration::perturbation::{Gauge, expand};
use libration::progress::Quiet;
use libration::quantity::Displacement;
use libration_derivation::internals::{DIGITS, Values, evaluate};
use libration_derivation::{
    Block, Check, Derivation, Formula, Name, Subscript, averaging, limit_cycle, perturbation,
    statement_latex, to_html, to_latex, to_markdown, to_notebook,
};
use std::collections::BTreeSet;

/// An equation with the frequency that is derived.
struct Row {
    equation: &'static str,
    about: Option<&'static str>,
    order: usize,
    /// A part of the printed frequency.
    printed: &'static str,
    values: &'static [(&'static str, &'static str, f64)],
    /// Ω by powers of the amplitude at these values.
    frequency: &'static [f64],
    /// The first power beyond, by the symmetry of the equation.
    next: f64,
}

const A: (&str, &str, f64) = ("a", "9/4", 9.0 / 4.0);
const B: (&str, &str, f64) = ("b", "4/9", 4.0 / 9.0);
const C: (&str, &str, f64) = ("c", "1/3", 1.0 / 3.0);
const K: (&str, &str, f64) = ("k", "9/4", 9.0 / 4.0);
const W: (&str, &str, f64) = ("w", "3/2", 3.0 / 2.0);

const fn row(equation: &'static str, order: usize, printed: &'static str) -> Row {
    Row { equation, about: None, order, printed, values: &[], frequency: &[], next: 0.0 }
}

fn rows() -> Vec<Row> {
    let root = std::f64::consts::SQRT_2;
    let pi = std::f64::consts::PI;
    let leak = |values: Vec<f64>| -> &'static [f64] { values.leak() };
    vec![
        Row {
            values: &[A],
            frequency: &[1.0, 0.0, 27.0 / 32.0, 0.0, -1701.0 / 4096.0],
            next: 6.0,
            ..row("x'' + x + a*x^3 = 0", 5, r"\Omega &=\omega _{0}\Delta \\")
        },
        Row {
            values: &[B, W],
            frequency: &[1.5, 0.0, 1.0 / 9.0, 0.0, -7.0 / 1458.0],
            next: 6.0,
            ..row(
                "x'' + w^2*x + b*x^3 = 0",
                5,
                r"w+\frac{3b}{8w}x_{\mathrm{max}}^{2}-\frac{21b^{2}}{256w^{3}}",
            )
        },
        Row {
            values: &[A, B, W],
            frequency: &[1.5, 0.0, -37.0 / 72.0, -37.0 / 108.0],
            next: 4.0,
            ..row("x'' + w^2*x + a*x^2 + b*x^3 = 0", 4, r"\frac{3b}{8w}-\frac{5a^{2}}{12w^{3}}")
        },
        Row {
            values: &[("g", "9/4", 2.25), ("l", "4/9", 4.0 / 9.0)],
            frequency: &[2.25, 0.0, -9.0 / 64.0, 0.0, 3.0 / 4096.0],
            next: 6.0,
            ..row("theta'' + g/l*sin(theta) = 0", 5, r"\theta _{0}^{2}")
        },
        Row {
            values: &[A, B, C],
            frequency: leak(vec![97.0_f64.sqrt() / 6.0, 0.0, 3.0 * 97.0_f64.sqrt() / 388.0]),
            next: 4.0,
            ..row("x'' + (a + b)*x + c*x^3 = 0", 3, r"\omega _{0}^{2}:=a+b")
        },
        Row {
            frequency: leak(vec![1.0, 0.0, 3.0 * pi / 8.0]),
            next: 4.0,
            ..row("x'' + x + pi*x^3 = 0", 3, r"\frac{3}{8}\pi x_{\mathrm{max}}^{2}")
        },
        Row {
            frequency: leak(vec![root.sqrt(), 0.0, 3.0 * root * root.sqrt() / 16.0]),
            next: 4.0,
            ..row("x'' + sqrt(2)*x + x^3 = 0", 3, r"f_{3}:=\frac{1}{\sqrt{2}}")
        },
        Row {
            frequency: leak(vec![1.0, 0.0, -5.0 / 6.0, -5.0 * root / 9.0]),
            next: 4.0,
            ..row("x'' + x + sqrt(2)*x^2 = 0", 4, r"f_{2}:=\sqrt{2}")
        },
        Row {
            about: Some("sqrt(k/b)"),
            values: &[B, K],
            frequency: leak(vec![1.5 * root, 0.0, -2.0 * root / 9.0 * 1.0, -8.0 * root / 81.0]),
            next: 4.0,
            ..row("x'' - k*x + b*x^3 = 0", 4, r"u:=x-\frac{\sqrt{k}}{\sqrt{b}}")
        },
        Row {
            values: &[A],
            frequency: &[1.0, 0.0, 9.0 / 32.0, 0.0, 243.0 / 4096.0],
            next: 6.0,
            ..row("x'' + x + a*x*x'^2 = 0", 5, r"\frac{1}{8}ax_{\mathrm{max}}^{2}")
        },
        Row {
            values: &[A],
            frequency: &[1.0, 0.0, -27.0 / 32.0, -81.0 / 32.0],
            next: 4.0,
            ..row("x'' + x + a*x'^2 = 0", 4, r"-\frac{1}{6}a^{2}x_{\mathrm{max}}^{2}")
        },
        Row {
            values: &[A, B, W],
            frequency: &[1.5, 0.0, 307.0 / 576.0],
            next: 4.0,
            ..row("x'' + w^2*x + a*x*x'^2 + b*x^3 = 0", 3, r"\frac{3b}{8w}+\frac{1}{8}aw")
        },
        Row {
            frequency: &[1.0, 0.0, -1.0 / 4.0, 0.0, 7.0 / 64.0],
            next: 6.0,
            ..row("(1 + x^2)*x'' + x*x'^2 + x = 0", 5, r"\Delta =1-\frac{1}{4}x_{\mathrm{max}}^{2}")
        },
        Row {
            frequency: &[1.0, 0.0, -1.0 / 8.0, 0.0, 19.0 / 256.0],
            next: 6.0,
            ..row("x'' + x/(1 + x'^2) = 0", 5, r"+\frac{19}{256}x_{\mathrm{max}}^{4}")
        },
    ]
}

fn derived(row: &Row) -> Derivation {
    let equation: Equation = row.equation.parse().unwrap();
    let about: Option<Expression> = row.about.map(|text| text.parse().unwrap());
    let oscillator = NumbersOrLetters::new(&equation, about.as_ref()).unwrap();
    perturbation(oscillator, row.order, &Gauge::Fundamental, None, &Quiet).unwrap()
}

/// The derived frequency at an amplitude, without what is left out.
fn frequency(derivation: &Derivation, row: &Row, amplitude: f64) -> f64 {
    let step = |id: &str| derivation.steps.iter().find(|step| step.id == id);
    let step = step("in-symbols").or_else(|| step("period")).unwrap();
    let equations = step.blocks.iter().filter_map(|block| match block {
        Block::Equation { equation, .. } => Some(equation.statement()),
        _ => None,
    });
    let statement = equations.into_iter().next().unwrap();
    let formula = without_order(&statement.rest.last().unwrap().1);
    let mut values = Values::default();
    let number = |value: f64| libration::algebra::BigFloat::from_f64(value, 256).unwrap();
    for (name, _, value) in row.values {
        values.set(&Name::new(name), number(*value));
    }
    // ω0 stands in the frequency of the sum a + b alone.
    values.set(&Name::new("ω").index(0), number(row.frequency[0]));
    for letter in ["x", "u"] {
        let subscript = Some(Subscript::Word("max".to_owned()));
        values.set(&Name { subscript, ..Name::new(letter) }, number(amplitude));
    }
    values.set(&Name::new("θ").index(0), number(amplitude));
    evaluate(&formula, &DIGITS, &values).unwrap().to_f64()
}

fn without_order(formula: &Formula) -> Formula {
    match formula {
        Formula::Sum(terms) => {
            let kept = terms.iter().filter(|term| !matches!(term, Formula::Order(_)));
            Formula::Sum(kept.map(without_order).collect())
        }
        Formula::Product(factors) => Formula::Product(factors.iter().map(without_order).collect()),
        other => other.clone(),
    }
}

#[test]
fn frequencies_with_symbols_and_velocities_are_those_of_sympy() {
    for row in rows() {
        let derivation = derived(&row);
        let page = to_markdown(&derivation);
        assert!(page.contains(row.printed), "{}: {page}", row.equation);
        let amplitude: f64 = 0.5;
        let expected = row.frequency.iter().rev().fold(0.0, |sum, c| sum * amplitude + c);
        let computed = frequency(&derivation, &row, amplitude);
        assert!((computed - expected).abs() < 1e-12, "{}: {computed} is not {expected}", row.equation);
    }
}

/// The difference from the period found by integration falls with the power that is left out.
#[test]
fn frequencies_agree_with_integration_to_the_power_that_is_left_out() {
    for row in rows() {
        let mut equation = row.equation.to_owned();
        let mut about = row.about.map(str::to_owned);
        for (name, value, _) in row.values {
            equation = in_place(&equation, name, value);
            about = about.map(|about| in_place(&about, name, value));
        }
        let equation: Equation = equation.parse().unwrap();
        let oscillator = match &about {
            Some(equilibrium) => Oscillator::about(&equation, &equilibrium.parse().unwrap()).unwrap(),
            None => Oscillator::new(&equation).unwrap(),
        };
        let expansion = expand(&oscillator, 3, &Gauge::Fundamental, &Quiet).unwrap();
        let derivation = derived(&row);
        let error = |amplitude: f64| {
            let at = Displacement::from_f64(amplitude).unwrap();
            let motion = ExactMotion::new(&oscillator, &expansion, &at, &Watch::new(&Quiet)).unwrap();
            let ratio = motion.value(SeriesQuantity::Period).unwrap().value;
            (frequency(&derivation, &row, amplitude) * ratio / row.frequency[0] - 1.0).abs()
        };
        let power = libm::log2(error(0.08) / error(0.04));
        assert!((power - row.next).abs() < 0.4, "{}: {power}", row.equation);
    }
}

/// The equation with a value in the place of a symbol of one letter.
fn in_place(equation: &str, name: &str, value: &str) -> String {
    let letters: Vec<char> = equation.chars().collect();
    let is_letter = |position: Option<usize>| {
        position.and_then(|index| letters.get(index)).is_some_and(|letter| letter.is_alphabetic())
    };
    let each = letters.iter().enumerate().map(|(position, letter)| {
        let is_symbol = letter.to_string() == name
            && !is_letter(position.checked_sub(1))
            && !is_letter(Some(position + 1));
        if is_symbol { format!("({value})") } else { letter.to_string() }
    });
    each.collect()
}

#[test]
fn derivations_with_symbols_have_every_format_and_exercises() {
    for row in rows() {
        let derivation = derived(&row);
        for whole in [derivation.clone(), derivation.exercises()] {
            let latex = to_latex(&whole);
            assert_eq!(latex.matches('{').count(), latex.matches('}').count(), "{}", row.equation);
            assert!(to_html(&whole).ends_with("</html>\n"));
            assert!(to_notebook(&whole).contains("nbformat"));
        }
    }
}

/// Each result in the symbols of the equation is compared for several of their values, and a wrong one is rejected.
#[test]
fn results_are_checked_for_several_values_of_the_symbols() {
    let row = &rows()[2];
    let derivation = derived(row);
    let step = derivation.steps.iter().find(|step| step.id == "in-symbols").unwrap();
    let checked = step.blocks.iter().filter(|block| match block {
        Block::Equation { equation, .. } => {
            assert!(!statement_latex(equation.statement()).contains("f_{"));
            matches!(equation.check(), Check::Choices { choices: 3, .. })
        }
        _ => false,
    });
    assert_eq!(checked.count(), 6);
}

/// The derivation of an equation with symbols.
fn of_symbols(equation: &str, order: usize) -> Derivation {
    let oscillator = NumbersOrLetters::new(&equation.parse().unwrap(), None).unwrap();
    perturbation(oscillator, order, &Gauge::Fundamental, None, &Quiet)
        .unwrap_or_else(|error| panic!("{equation}: {error}"))
}

/// The numbered symbols in a LaTeX document, such as `a3` and `epsilon2`.
fn numbered_symbols(latex: &str) -> BTreeSet<String> {
    let number = |after: &str| {
        after.split('}').next().filter(|text| text.chars().all(|c| c.is_ascii_digit())).map(str::to_owned)
    };
    let letter = |before: &str| {
        let from = before.rfind(|c: char| !c.is_ascii_alphabetic()).map_or(0, |at| at + 1);
        before[from..].trim_start_matches("var").to_owned()
    };
    let parts: Vec<&str> = latex.split("_{").collect();
    let pairs = parts.windows(2).filter_map(|pair| Some((letter(pair[0].trim_end()), number(pair[1])?)));
    pairs
        .filter(|(letter, number)| !letter.is_empty() && !number.is_empty())
        .map(|(letter, number)| letter + &number)
        .collect()
}

/// The small parameter of a weak force is replaced too; a displacement is not.
#[test]
fn small_parameters_with_another_meaning_are_replaced() {
    for name in ["A", "A0", "psi1", "tau", "v", "a1", "x2", "Omega1"] {
        let equation = |force: &str| format!("x'' + x + {name}*{force} = 0").parse().unwrap();
        let damped = averaging(&equation("x'"), Some(name), 3, 1, &Quiet).unwrap();
        let cycle = limit_cycle(&equation("(x^2 - 1)*x'"), Some(name), 2, &Quiet).unwrap();
        let of_damping = averaging(&"x'' + x + beta*x' = 0".parse().unwrap(), None, 3, 1, &Quiet).unwrap();
        for derivation in [damped, cycle, of_damping] {
            let latex = to_latex(&derivation);
            assert!(latex.contains("of the given equation is written $\\alpha"), "{name}: {latex}");
        }
    }
    // Neither the displacement nor another symbol of the derivation takes its place.
    let angle = averaging(&"alpha'' + alpha + delta*alpha' = 0".parse().unwrap(), None, 3, 1, &Quiet);
    assert!(to_latex(&angle.unwrap()).contains(r"$\delta$ of the given equation is written $\gamma"));
    let cubic = to_latex(&of_symbols("alpha'' + alpha + T*alpha^3 = 0", 2));
    assert!(cubic.contains(r"-\alpha -\beta \alpha ^{3}"), "{cubic}");
    let plain = to_latex(&averaging(&"x'' + x + c*x' = 0".parse().unwrap(), None, 3, 1, &Quiet).unwrap());
    assert!(!plain.contains("of the given equation"), "{plain}");
    let of_displacement = averaging(&"A'' + A + c*A' = 0".parse().unwrap(), None, 3, 1, &Quiet);
    assert_eq!(
        of_displacement.unwrap_err().to_string(),
        "the symbol A has another meaning in the derivation: rename it"
    );
}

/// Each symbol of a derivation is replaced where an equation has it, and the reader is told. Factors of powers of the velocity have symbols of their own.
#[test]
fn symbols_with_another_meaning_are_replaced() {
    let whole = to_latex(&of_symbols("x'' + w*x + q*x^2 + r*x^3 + s*x'^2 = 0", 4));
    let mut taken = numbered_symbols(&whole);
    let some = ["a3", "A1", "f2", "g2", "omega0", "epsilon2", "T0", "B2"];
    assert!(some.iter().all(|name| taken.contains(*name)), "{taken:?}");
    taken.retain(|name| name != "int0");
    taken.extend(["T", "tau", "epsilon", "Delta", "Omega", "F", "x1"].map(str::to_owned));
    for name in taken {
        let derivation = of_symbols(&format!("x'' + x + {name}*x^3 = 0"), 2);
        let told = to_latex(&derivation);
        assert!(told.contains("of the given equation is written"), "{name}");
        assert!(told.contains(r"-x-\alpha"), "{name}: {told}");
    }
    let plain = to_latex(&of_symbols("x'' + omega0^2*x + alpha*x^3 = 0", 2));
    assert!(!plain.contains("of the given equation"), "{plain}");
    let two = to_latex(&of_symbols("x'' + w0^2*x + a2*x^2 + a3*x^3 = 0", 3));
    assert!(two.contains(r"x''=-w_{0}^{2}x-\alpha _{2}x^{2}-\alpha _{3}x^{3}"), "{two}");
}
