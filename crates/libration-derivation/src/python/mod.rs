//! Formulas as Python, computed with the functions of `prelude.py`.

mod cell;
mod exercise;
mod parts;

pub(super) use cell::{ansatz, check, coefficient, few_harmonics, limit_cycle, quarter_swing, slow_flow};
pub(super) use exercise::Questions;
pub(super) use parts::prelude_for;

use super::evaluate::TIME;
use super::formula::{DecimalUnit, Formula, Name, Subscript};

/// The precedence of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Sum,
    Product,
    Unary,
    Atom,
}

/// A formula as an expression; `None` if it contains an index that is not a number.
pub(super) fn expression(formula: &Formula) -> Option<String> {
    written(formula).map(|(text, _)| text)
}

/// A name as an identifier.
pub(super) fn identifier(name: &Name) -> Option<String> {
    let below = match &name.subscript {
        None => String::new(),
        Some(Subscript::Word(word)) => format!("_{word}"),
        Some(Subscript::Index(index)) => match &**index {
            Formula::Number(value) => format!("_{value}"),
            _ => return None,
        },
    };
    let text = format!("{}{below}{}", name.letter, "_p".repeat(usize::from(name.primes)));
    let is_identifier = text.chars().all(|letter| letter.is_alphanumeric() || letter == '_');
    is_identifier.then_some(text)
}

fn written(formula: &Formula) -> Option<(String, Level)> {
    let call = |function: &str, arguments: &[&Formula]| -> Option<(String, Level)> {
        let arguments: Option<Vec<String>> = arguments.iter().map(|argument| expression(argument)).collect();
        Some((format!("{function}({})", arguments?.join(", ")), Level::Atom))
    };
    Some(match formula {
        Formula::Number(value) if value.denominator() == "1" => signed(value.to_string()),
        Formula::Number(value) => (format!("Q({}, {})", value.numerator(), value.denominator()), Level::Atom),
        Formula::Decimal(decimal) => {
            let value = format!("{:?}", decimal.value()?.to_f64());
            match decimal.unit {
                DecimalUnit::Degree => (format!("radians({value})"), Level::Atom),
                _ => signed(value),
            }
        }
        Formula::Pi => ("pi".to_owned(), Level::Atom),
        Formula::Name(name) => (identifier(name)?, Level::Atom),
        Formula::Negate(operand) => (format!("-{}", at_least(Level::Product, operand)?), Level::Product),
        Formula::Sum(terms) => {
            let terms: Option<Vec<String>> =
                terms.iter().map(|term| at_least(Level::Product, term)).collect();
            (terms?.join(" + ").replace(" + -", " - "), Level::Sum)
        }
        Formula::Product(factors) => {
            let level = |index| if index == 0 { Level::Product } else { Level::Unary };
            let factors = factors.iter().enumerate().map(|(index, factor)| at_least(level(index), factor));
            (factors.collect::<Option<Vec<String>>>()?.join("*"), Level::Product)
        }
        Formula::Fraction(over, under) => {
            // A quotient of integers alone would become a float.
            let over = match over.free_names().is_empty() {
                true => format!("exact({})", expression(over)?),
                false => at_least(Level::Product, over)?,
            };
            (format!("{over}/{}", at_least(Level::Unary, under)?), Level::Product)
        }
        Formula::Power(base, exponent) => match &**exponent {
            Formula::Number(value) if value.denominator() == "1" && !value.to_string().starts_with('-') => {
                (format!("{}**{value}", at_least(Level::Atom, base)?), Level::Unary)
            }
            _ => call("power", &[base, exponent])?,
        },
        Formula::Call(function, argument) => call(function.name(), &[argument])?,
        Formula::Apply(name, arguments) => call(&identifier(name)?, &arguments.iter().collect::<Vec<_>>())?,
        Formula::Agm(a, b) => call("agm", &[a, b])?,
        Formula::Series { .. } | Formula::Integral { .. } | Formula::Derivative { .. } => {
            (with_own_name(formula)?, Level::Atom)
        }
        Formula::DoubleFactorial(argument) => call("double_factorial", &[argument])?,
        Formula::Order(argument) => call("O", &[argument])?,
    })
}

/// Sums, integrals and derivatives, which bind a variable.
fn with_own_name(formula: &Formula) -> Option<String> {
    Some(match formula {
        Formula::Series { index, from, to, term } => {
            let last = to.as_deref().map_or(Some("None".to_owned()), expression)?;
            let (index, term, first) = (identifier(index)?, expression(term)?, expression(from)?);
            format!("total(lambda {index}: {term}, {first}, {last})")
        }
        Formula::Integral { variable, from, to, integrand } => {
            let (variable, integrand) = (identifier(variable)?, expression(integrand)?);
            let (from, to) = (expression(from)?, expression(to)?);
            format!("integral(lambda {variable}: {integrand}, {from}, {to})")
        }
        Formula::Derivative { of, by } if by.letter == TIME => along_the_motion(of)?,
        Formula::Derivative { of, by } => {
            let (of, by) = (expression(of)?, identifier(by)?);
            format!("slope(lambda {by}: {of}, {by})")
        }
        _ => return None,
    })
}

/// The time derivative: the angle and its velocity change, or without them every name, each at the rate that its next prime denotes.
fn along_the_motion(formula: &Formula) -> Option<String> {
    let of = expression(formula)?;
    let angle = Name::new("θ");
    let names_of = formula.free_names();
    let moving = match names_of.iter().any(|name| name.letter == angle.letter) {
        true => vec![angle.clone(), angle.prime()],
        false => names_of,
    };
    let mut names: Vec<String> = moving.iter().map(identifier).collect::<Option<_>>()?;
    names.sort();
    names.dedup();
    let moved: Vec<String> = names.iter().map(|name| format!("{name} + s*{name}_p")).collect();
    Some(format!("slope(lambda s: (lambda {}: {of})({}), 0)", names.join(", "), moved.join(", ")))
}

fn signed(number: String) -> (String, Level) {
    let level = if number.starts_with('-') { Level::Product } else { Level::Atom };
    (number, level)
}

fn at_least(level: Level, formula: &Formula) -> Option<String> {
    let (text, binding_level) = written(formula)?;
    Some(if binding_level < level { format!("({text})") } else { text })
}
