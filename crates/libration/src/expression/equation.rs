//! Equations of motion from text, solved for the accelerations.

mod error;

use std::collections::BTreeSet;
use std::fmt;
use std::str::FromStr;

use super::lexer::Token;
use super::parser::Parser;
use super::simplify::{difference, negative, quotient, sum};
use super::{Expression, Symbol};

pub use error::EquationError;

/// Equations of motion of the second order, one for each variable, solved for the accelerations.
///
/// A variable is what has two primes; t is the time; all other names are parameters.
///
/// # Examples
/// ```
/// use libration::expression::Equation;
/// let equation: Equation = "m x'' + k x = 0".parse()?;
/// assert_eq!(equation.accelerations()[0].to_string(), "-k*x/m");
/// let equation = equation.with(&[("m", "2".parse()?), ("k", "0.5".parse()?)])?;
/// assert_eq!(equation.to_string(), "2*x'' + 0.5*x = 0");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Equation {
    variables: Vec<String>,
    written: Vec<(Expression, Expression)>,
    accelerations: Vec<Expression>,
}

impl Equation {
    /// The equations that give each variable its acceleration.
    pub(crate) fn of_accelerations(variables: Vec<String>, accelerations: Vec<Expression>) -> Self {
        let acceleration = |name: &String| Expression::Symbol(Symbol::plain(name).with_primes(2));
        let written = variables.iter().map(acceleration).zip(accelerations.iter().cloned()).collect();
        Self { variables, written, accelerations }
    }

    /// The names of the variables, in the order of their equations.
    #[must_use]
    pub fn variables(&self) -> &[String] {
        &self.variables
    }

    /// The second derivative of each variable, as a formula in variables, first derivatives, t and parameters.
    #[must_use]
    pub fn accelerations(&self) -> &[Expression] {
        &self.accelerations
    }

    /// What multiplies each second derivative as the equations are written: the masses, in `m x'' + k x = 0`.
    pub(crate) fn inertias(&self) -> Vec<Expression> {
        let factor = |((left, right), name): (&(Expression, Expression), &String)| {
            let own = Symbol::plain(name).with_primes(2);
            difference(left.derivative(&own), right.derivative(&own))
        };
        self.written.iter().zip(&self.variables).map(factor).collect()
    }

    /// The names that are neither variables nor the time.
    #[must_use]
    pub fn parameters(&self) -> BTreeSet<String> {
        let sides = self.written.iter().flat_map(|(left, right)| [left, right]);
        let names = sides.flat_map(Expression::symbols).map(|symbol| symbol.name);
        names.filter(|name| name != TIME && !self.variables.contains(name)).collect()
    }

    /// Parameters as the equations name them: ω0 is omega0.
    ///
    /// # Errors
    /// A name that is no parameter.
    pub fn parameters_called(&self, names: &[&str]) -> Result<Vec<String>, EquationError> {
        let known = self.parameters();
        names.iter().map(|name| Ok(parameter(name, &known)?.name)).collect()
    }

    /// The equations with constants in the place of parameters, and numbers worked out where one is put in.
    ///
    /// # Errors
    /// A name that is no parameter, or is given twice; a value that has symbols in it, or is none, as 1/0; an equation
    /// whose second derivative drops out, or that has no value with these.
    pub fn with(&self, values: &[(&str, Expression)]) -> Result<Self, EquationError> {
        let known = self.parameters();
        let mut written = self.written.clone();
        for (place, (name, value)) in values.iter().enumerate() {
            let symbol = parameter(name, &known)?;
            if values[..place].iter().any(|(earlier, _)| parameter(earlier, &known).as_ref() == Ok(&symbol)) {
                return Err(EquationError::SetTwice(symbol.name));
            }
            if let Some(inside) = value.symbols().pop_first() {
                return Err(EquationError::NotConstant { name: symbol.name, inside });
            }
            if let Some(why) = value.without_value() {
                return Err(EquationError::ValueWithout { name: symbol.name, why });
            }
            for side in written.iter_mut().flat_map(|(left, right)| [left, right]) {
                *side = side.with_value(&symbol, value);
            }
        }
        Self::solved(written)
    }

    /// Solves each equation for its own second derivative.
    fn solved(written: Vec<(Expression, Expression)>) -> Result<Self, EquationError> {
        let sides = written.iter().flat_map(|(left, right)| [left, right]);
        if let Some(missing) = sides.into_iter().find_map(Expression::without_value) {
            return Err(missing.into());
        }
        let own: Vec<Symbol> = written.iter().map(own_acceleration).collect::<Result<_, _>>()?;
        if let Some(twice) = own.iter().enumerate().find_map(|(i, it)| own[..i].contains(it).then_some(it)) {
            return Err(EquationError::SolvedTwice(twice.name.clone()));
        }
        let variables: Vec<String> = own.iter().map(|symbol| symbol.name.clone()).collect();
        refuse_foreign_derivatives(&written, &variables)?;
        let pairs = written.iter().zip(&own);
        let accelerations =
            pairs.map(|((left, right), symbol)| solve(left, right, symbol)).collect::<Result<_, _>>()?;
        Ok(Self { variables, written, accelerations })
    }

    /// How equations are understood that are written more freely than they are written back, as `d²x/dt² + sin 2x = 0` is;
    /// `None` for others, and for what is not understood.
    ///
    /// ```
    /// use libration::expression::Equation;
    /// assert_eq!(Equation::read_as(r"\ddot{x} + x(1 + x^2) = 0").as_deref(), Some("x'' + x*(1 + x^2) = 0"));
    /// assert_eq!(Equation::read_as("x'' + x = 0"), None);
    /// ```
    #[must_use]
    pub fn read_as(text: &str) -> Option<String> {
        let (written, is_free) = sides(text).ok()?;
        let equation = Self::solved(written).ok().filter(|_| is_free)?;
        Some(equation.to_string())
    }

    /// The equations in LaTeX, one string each.
    #[must_use]
    pub fn to_latex(&self) -> Vec<String> {
        let one =
            |(left, right): &(Expression, Expression)| format!("{} = {}", left.to_latex(), right.to_latex());
        self.written.iter().map(one).collect()
    }
}

/// The name of the time.
const TIME: &str = "t";

/// The parameter of this name, which may be written as in a formula: ω0 is omega0.
fn parameter(name: &str, known: &BTreeSet<String>) -> Result<Symbol, EquationError> {
    match name.parse() {
        Ok(Expression::Symbol(symbol)) if symbol.primes == 0 && known.contains(&symbol.name) => Ok(symbol),
        _ => Err(EquationError::unknown_parameter(name, known)),
    }
}

/// The one second derivative of an equation.
fn own_acceleration((left, right): &(Expression, Expression)) -> Result<Symbol, EquationError> {
    let mut symbols = left.symbols();
    symbols.extend(right.symbols());
    if let Some(symbol) = symbols.iter().find(|symbol| symbol.primes > 2) {
        return Err(EquationError::ThirdOrder(symbol.clone()));
    }
    let mut second = symbols.iter().filter(|symbol| symbol.primes == 2);
    let own = second.next().ok_or_else(|| EquationError::without_acceleration(left, right))?;
    if let Some(other) = second.next() {
        return Err(EquationError::Coupled { first: own.clone(), second: other.clone() });
    }
    if own.name == TIME { Err(EquationError::TimeAsVariable) } else { Ok(own.clone()) }
}

/// Refuses derivatives of what is no variable.
fn refuse_foreign_derivatives(
    written: &[(Expression, Expression)],
    variables: &[String],
) -> Result<(), EquationError> {
    let sides = written.iter().flat_map(|(left, right)| [left, right]);
    let mut symbols = sides.flat_map(Expression::symbols);
    match symbols.find(|symbol| symbol.primes > 0 && !variables.contains(&symbol.name)) {
        Some(foreign) => Err(EquationError::ForeignDerivative(foreign)),
        None => Ok(()),
    }
}

/// Solves left = right, of the form a·x″ + b = 0, for x″.
fn solve(left: &Expression, right: &Expression, own: &Symbol) -> Result<Expression, EquationError> {
    if *left == Expression::Symbol(own.clone()) && !right.contains(own) {
        return Ok(right.simplified());
    }
    let form = difference(left.simplified(), right.simplified());
    let factor = form.derivative(own);
    if factor.contains(own) {
        return Err(EquationError::NotLinear(own.clone()));
    }
    if factor.vanishes() {
        return Err(EquationError::DropsOut(own.clone()));
    }
    let rest = form.substitute(own, &Expression::from(0)).simplified();
    Ok(quotient(opposite(rest), factor))
}

/// −a, with the sign taken into sums.
fn opposite(a: Expression) -> Expression {
    match a {
        Expression::Add(a, b) => difference(opposite(*a), *b),
        Expression::Subtract(a, b) => sum(opposite(*a), *b),
        _ => negative(a),
    }
}

/// Reads one equation, or several with `;` between them.
///
/// # Errors
/// Text that is no formula; no `=`, or two; no second derivative or more than one in an equation; an equation that is
/// not linear in it; derivatives of the third order; parts that have no value, as 1/0.
impl FromStr for Equation {
    type Err = EquationError;

    fn from_str(text: &str) -> Result<Self, EquationError> {
        Self::solved(sides(text)?.0)
    }
}

/// The sides of each equation, and whether they are written more freely than they are written back.
fn sides(text: &str) -> Result<(Vec<(Expression, Expression)>, bool), EquationError> {
    let mut parser = Parser::new(text)?;
    let mut written = Vec::new();
    loop {
        written.push(one_equation(&mut parser)?);
        let more = parser.take(';');
        match parser.peek() {
            Token::End => return Ok((written, parser.is_free())),
            _ if more => {}
            Token::Sign('=') => return Err(EquationError::SecondEqualsSign),
            _ => return Err(parser.unexpected().into()),
        }
    }
}

fn one_equation(parser: &mut Parser) -> Result<(Expression, Expression), EquationError> {
    let left = parser.formula()?;
    if parser.take('=') {
        return Ok((left, parser.formula()?));
    }
    match parser.peek() {
        Token::End | Token::Sign(';') => Err(EquationError::without_equals_sign(&left)),
        _ => Err(parser.unexpected().into()),
    }
}

/// As it was understood; several with `;` between them.
impl fmt::Display for Equation {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, (left, right)) in self.written.iter().enumerate() {
            let separator = if place == 0 { "" } else { "; " };
            write!(formatter, "{separator}{left} = {right}")?;
        }
        Ok(())
    }
}
