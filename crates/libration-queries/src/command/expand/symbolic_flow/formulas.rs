//! The formulas in LaTeX and in programming languages.

use super::Answer;
use super::fields::{Formula, formulas};
use crate::command::expand::code::Language;
use crate::query_error::QueryError;
use libration::algebra::Rational;
use libration::expression::Expression;
use std::collections::BTreeSet;
use std::io::{self, Write};

/// The formulas as display equations.
pub(super) fn write_latex(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    writeln!(out, "\\[ {} \\]", answer.subject.equation_latex)?;
    let latex = |text: &str| text.parse().map_or_else(|_| text.to_owned(), |it: Expression| it.to_latex());
    for Formula { name, text } in formulas(answer) {
        let left = match name {
            "amplitude" => r"\dot A".to_owned(),
            "phase" => r"\dot\varphi".to_owned(),
            "displacement" => latex(&answer.subject.variable),
            "relation" | "folds" => "0".to_owned(),
            other => format!(r"\text{{{}}}", other.replace('_', " ")),
        };
        writeln!(out, "\\[ {left} = {} \\]", latex(&text).replace(r"\phi", r"\varphi"))?;
    }
    Ok(())
}

/// One function for each formula.
pub(super) fn write_code(out: &mut dyn Write, answer: &Answer, language: Language) -> Result<(), QueryError> {
    let comment = match language {
        Language::Python => "#",
        Language::Fortran => "!",
        Language::C | Language::Rust => "//",
    };
    writeln!(out, "{comment} {}", answer.subject.equation)?;
    if language == Language::C {
        writeln!(out, "#include <math.h>")?;
    }
    for Formula { name, text } in formulas(answer) {
        let tree: Expression = text.parse().map_err(|error| {
            QueryError::no_result("slow flow", format!("{name} is too long for one function: {error}"))
        })?;
        write_function(out, language, name, &tree)?;
    }
    Ok(())
}

fn write_function(
    out: &mut dyn Write,
    language: Language,
    name: &str,
    formula: &Expression,
) -> io::Result<()> {
    let symbols: BTreeSet<String> = formula.symbols().into_iter().map(|symbol| symbol.name).collect();
    let symbols: Vec<String> = symbols.iter().map(|name| variable(language, name)).collect();
    let body = written(language, formula);
    match language {
        Language::Python => {
            let imports =
                if name == "amplitude" { "from math import cos, pi, sin, sqrt\n\n\n" } else { "\n\n" };
            write!(out, "{imports}def {name}({}):\n    return {body}\n", symbols.join(", "))
        }
        Language::C => {
            let symbols: Vec<String> = symbols.iter().map(|name| format!("double {name}")).collect();
            write!(out, "\ndouble {name}({})\n{{\n    return {body};\n}}\n", symbols.join(", "))
        }
        Language::Rust => {
            let symbols: Vec<String> = symbols.iter().map(|name| format!("{name}: f64")).collect();
            let allowed = "#[allow(non_snake_case)]";
            write!(out, "\n{allowed}\npub fn {name}({}) -> f64 {{\n    {body}\n}}\n", symbols.join(", "))
        }
        Language::Fortran => {
            let list = symbols.join(", ");
            write!(
                out,
                "\npure real(8) function {name}({list})\n  real(8), intent(in) :: {list}\n  {name} = {}\nend function\n",
                body.replace(" + ", " &\n    + ").replace(" - ", " &\n    - ")
            )
        }
    }
}

fn variable(language: Language, name: &str) -> String {
    if language.is_reserved(name) { format!("{name}_") } else { name.to_owned() }
}

/// A formula in a language, with brackets about each operand that is a sum or a product.
fn written(language: Language, formula: &Expression) -> String {
    let part = |formula: &Expression| written(language, formula);
    let bracketed = |formula: &Expression| match formula {
        Expression::Number(_) | Expression::Symbol(_) | Expression::Call(..) | Expression::Pi => {
            part(formula)
        }
        _ => format!("({})", part(formula)),
    };
    match formula {
        Expression::Number(number) => language.number(number.to_f64()),
        Expression::Pi => language.number(std::f64::consts::PI),
        Expression::Symbol(symbol) => variable(language, &symbol.name),
        Expression::Negate(a) => format!("-{}", bracketed(a)),
        Expression::Add(a, b) => format!("{} + {}", part(a), part(b)),
        Expression::Subtract(a, b) => format!("{} - {}", part(a), bracketed(b)),
        Expression::Multiply(a, b) => format!("{}*{}", bracketed(a), bracketed(b)),
        Expression::Divide(a, b) => format!("{}/{}", bracketed(a), bracketed(b)),
        Expression::Power(a, b) => {
            let exponent = b.to_rational().unwrap_or_else(|| Rational::from(1));
            language.power(&bracketed(a), &exponent)
        }
        Expression::Call(function, a) => {
            let name = match (function.name(), language) {
                ("abs", Language::C) => "fabs",
                (name, _) => name,
            };
            language.call(name, &part(a))
        }
    }
}
