//! Formulas as functions of programming languages, one for each.

use super::program::{Function, Program};
use super::{Heading, NamedFormula};
use crate::output::language::{FreeNames, Language};
use crate::query_error::QueryError;
use libration::algebra::Rational;
use libration::expression::Expression;
use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;

/// Names of symbols in a program.
type SymbolNames = BTreeMap<String, String>;

/// Writes one function for each formula, whose arguments are its symbols in alphabetical order.
pub(super) fn write(
    out: &mut dyn Write,
    language: Language,
    heading: &Heading<'_>,
    formulas: &[NamedFormula],
) -> Result<(), QueryError> {
    let mut trees: Vec<Expression> = vec![];
    let &Heading { module, equations, .. } = heading;
    for NamedFormula { name, text, .. } in formulas {
        trees.push(text.parse().map_err(|error| {
            QueryError::no_result(
                &module.replace('_', " "),
                format!("{name} is too long for one function: {error}"),
            )
        })?);
    }
    let mut free = FreeNames::new(language);
    let function_names: Vec<String> =
        formulas.iter().map(|formula| free.free_function(&formula.name)).collect();
    let symbols: BTreeSet<String> = trees.iter().flat_map(symbols).collect();
    let names = symbols.into_iter().map(|symbol| (symbol.clone(), free.free(&symbol))).collect();
    let functions = formulas
        .iter()
        .zip(function_names)
        .zip(&trees)
        .map(|((formula, name), tree)| function(language, (&name, &formula.meaning), tree, &names));
    let comment = vec![equations.to_owned()];
    let program = Program { language, module, comment, functions: functions.collect() };
    Ok(out.write_all(program.to_string().as_bytes())?)
}

fn symbols(tree: &Expression) -> BTreeSet<String> {
    tree.symbols().into_iter().map(|symbol| symbol.name).collect()
}

fn function(
    language: Language,
    (name, meaning): (&str, &str),
    tree: &Expression,
    names: &SymbolNames,
) -> Function {
    let arguments = symbols(tree).iter().map(|symbol| name_of(symbol, names)).collect();
    let mut function = Function::new(name, meaning, arguments);
    function.result = written(language, tree, names);
    function
}

fn name_of(symbol: &str, names: &SymbolNames) -> String {
    names.get(symbol).map_or(symbol, String::as_str).to_owned()
}

/// A formula in a language, with brackets about operands where a language needs them.
fn written(language: Language, formula: &Expression, names: &SymbolNames) -> String {
    let part = |formula: &Expression| written(language, formula, names);
    let bracketed = |formula: &Expression| match formula {
        Expression::Number(_)
        | Expression::Symbol(_)
        | Expression::Call(..)
        | Expression::Pi
        | Expression::Power(..) => part(formula),
        _ => format!("({})", part(formula)),
    };
    // Products are read from the left.
    let product = |formula: &Expression| match formula {
        Expression::Multiply(..) | Expression::Divide(..) => part(formula),
        _ => bracketed(formula),
    };
    match formula {
        Expression::Number(number) => language.number(number.to_f64()),
        Expression::Pi => language.pi(),
        Expression::Symbol(symbol) => name_of(&symbol.name, names),
        Expression::Negate(a) => format!("-{}", product(a)),
        Expression::Add(a, b) => format!("{} + {}", part(a), product(b)),
        Expression::Subtract(a, b) => format!("{} - {}", part(a), product(b)),
        Expression::Multiply(a, b) => format!("{}*{}", product(a), bracketed(b)),
        Expression::Divide(a, b) => format!("{}/{}", product(a), bracketed(b)),
        Expression::Power(a, b) => {
            let exponent = b.to_rational().unwrap_or_else(|| Rational::from(1));
            let base =
                if matches!(**a, Expression::Power(..)) { format!("({})", part(a)) } else { bracketed(a) };
            language.power(&base, &exponent)
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
