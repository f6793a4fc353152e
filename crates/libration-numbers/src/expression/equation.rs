//! Equations of motion from text, solved for the accelerations, or for the rates of change if they are of first order.

mod error;
mod indexed;
mod order;

use std::collections::BTreeSet;
use std::fmt;
use std::str::FromStr;

use super::lexer::Token;
use super::parser::Parser;
use super::simplify::{difference, negative, quotient, sum};
use super::{Expression, Symbol};

pub use error::{EquationError, SecondOrderError};
use indexed::{Written, expanded};
pub use order::Order;
use order::own_derivatives;

/// Equations of motion, one for each variable, solved for its highest derivative: the acceleration, or the rate of change of a variable whose
/// equation is of first order.
///
/// A variable is a name with two primes, or with one prime in an equation without two; t is the time; all other names are parameters. With an
/// index and its range, one equation stands for several, whose variables are x1, x2, …; members outside the range are zero, unless another
/// equation states their values.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::expression::Equation;
/// let equation: Equation = "m x'' + k x = 0".parse()?;
/// assert_eq!(equation.accelerations()[0].to_string(), "-k*x/m");
/// let equation = equation.with(&[("m", "2".parse()?), ("k", "0.5".parse()?)])?;
/// assert_eq!(equation.to_string(), "2*x'' + 0.5*x = 0");
/// // A motor: the current q drives the mass, whose velocity induces a voltage.
/// let motor: Equation = "m x'' = k q; L q' + R q = -k x'".parse()?;
/// assert_eq!(motor.derivatives()[1].to_string(), "(-R*q - k*x')/L");
/// let chain: Equation = "x[i]'' = x[i+1] - 2*x[i] + x[i-1], i = 1..3; x[4] = sin(t)".parse()?;
/// assert_eq!(chain.to_string(), "x1'' = x2 - 2*x1; x2'' = x3 - 2*x2 + x1; x3'' = sin(t) - 2*x3 + x2");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Equation {
    variables: Vec<String>,
    orders: Vec<Order>,
    written: Vec<Sides>,
    derivatives: Vec<Expression>,
}

/// Left and right side of an equation.
type Sides = (Expression, Expression);

impl Equation {
    /// The equations with these accelerations of the variables.
    #[doc(hidden)]
    pub fn of_accelerations(variables: Vec<String>, accelerations: Vec<Expression>) -> Self {
        let orders = vec![Order::Second; variables.len()];
        Self::of_derivatives(variables, orders, accelerations)
    }

    /// The equations with these highest derivatives of the variables.
    #[doc(hidden)]
    pub fn of_derivatives(variables: Vec<String>, orders: Vec<Order>, derivatives: Vec<Expression>) -> Self {
        let derivative = |(name, order): (&String, &Order)| Expression::Symbol(order.derivative_of(name));
        let written =
            variables.iter().zip(&orders).map(derivative).zip(derivatives.iter().cloned()).collect();
        Self { variables, orders, written, derivatives }
    }

    /// The names of the variables, in the order of their equations.
    #[must_use]
    pub fn variables(&self) -> &[String] {
        &self.variables
    }

    /// Order of the equation of each variable.
    #[must_use]
    pub fn orders(&self) -> &[Order] {
        &self.orders
    }

    /// The highest derivative of each variable, as a formula in variables, first derivatives of second-order variables, t and parameters.
    #[must_use]
    pub fn derivatives(&self) -> &[Expression] {
        &self.derivatives
    }

    /// The second derivative of each variable, as a formula in variables, first derivatives, t and parameters; for an equation of first order,
    /// which [`Self::refuse_first_order`] excludes, the rate of change.
    #[must_use]
    pub fn accelerations(&self) -> &[Expression] {
        &self.derivatives
    }

    /// Returns `true` if the equations contain the time.
    #[must_use]
    pub fn depends_on_time(&self) -> bool {
        let time = Symbol::plain("t");
        self.derivatives().iter().any(|formula| formula.contains(&time))
    }

    /// Rejects equations of first order, for methods that need accelerations.
    ///
    /// # Errors
    /// The first variable whose equation is of first order.
    pub fn refuse_first_order(&self) -> Result<(), SecondOrderError> {
        let mut pairs = self.variables.iter().zip(&self.orders);
        match pairs.find(|(_, order)| **order == Order::First) {
            Some((variable, _)) => Err(SecondOrderError { variable: variable.clone() }),
            None => Ok(()),
        }
    }

    /// Factor of each highest derivative in the equations as written: the mass, in `m x'' + k x = 0`.
    #[doc(hidden)]
    pub fn inertias(&self) -> Vec<Expression> {
        let factor = |((left, right), derivative): (&Sides, Symbol)| {
            difference(left.derivative(&derivative), right.derivative(&derivative))
        };
        self.written.iter().zip(self.own_derivatives()).map(factor).collect()
    }

    /// The derivative for which each equation is solved: `x''`, or `x'` for an equation of first order.
    #[doc(hidden)]
    pub fn own_derivatives(&self) -> impl Iterator<Item = Symbol> {
        self.variables.iter().zip(&self.orders).map(|(name, order)| order.derivative_of(name))
    }

    /// A formula in which the rates of change of first-order variables, which are not components of the state, are replaced by their equations.
    ///
    /// ```
    /// # extern crate libration_numbers as libration;
    /// use libration::expression::Equation;
    /// let decay: Equation = "x' = -x/2".parse()?;
    /// assert_eq!(decay.with_rates(&"x'/x".parse()?).to_string(), "-x/2/x");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_rates(&self, formula: &Expression) -> Expression {
        let derivatives = self.own_derivatives().zip(&self.derivatives);
        let rates =
            derivatives.filter(|(derivative, _)| derivative.primes == 1 && formula.contains(derivative));
        let rates: Vec<_> = rates.collect();
        match rates.is_empty() {
            true => formula.clone(),
            false => {
                let put_in = |formula: Expression, (derivative, rate): (Symbol, &Expression)| {
                    formula.substitute(&derivative, rate)
                };
                rates.into_iter().fold(formula.clone(), put_in).simplified()
            }
        }
    }

    /// The names that denote neither variables nor the time.
    #[must_use]
    pub fn parameters(&self) -> BTreeSet<String> {
        let sides = self.written.iter().flat_map(|(left, right)| [left, right]);
        let names = sides.flat_map(Expression::symbols).map(|symbol| symbol.name);
        names.filter(|name| name != TIME && !self.variables.contains(name)).collect()
    }

    /// Parameters under the names that the equations use: omega0 for ω0.
    ///
    /// # Errors
    /// A name that does not denote a parameter.
    pub fn parameters_called(&self, names: &[&str]) -> Result<Vec<String>, EquationError> {
        let parameters = self.parameters();
        names.iter().map(|name| Ok(parameter(name, &parameters)?.name)).collect()
    }

    /// The equations with constants in place of parameters, and with arithmetic done where a constant was inserted.
    ///
    /// # Errors
    /// A name that does not denote a parameter, or is given twice; a value that contains symbols or is undefined, such as 1/0; an equation that
    /// is undefined, or loses its highest derivative, for these values.
    pub fn with(&self, values: &[(&str, Expression)]) -> Result<Self, EquationError> {
        let parameters = self.parameters();
        let mut written = self.written.clone();
        for (index, (name, value)) in values.iter().enumerate() {
            let symbol = parameter(name, &parameters)?;
            if values[..index]
                .iter()
                .any(|(earlier, _)| parameter(earlier, &parameters).as_ref() == Ok(&symbol))
            {
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
        refuse_without_value(&written)?;
        for (sides, (derivative, order)) in written.iter().zip(self.own_derivatives().zip(&self.orders)) {
            let (left, right) = sides;
            if !left.contains(&derivative) && !right.contains(&derivative) {
                return Err(match order {
                    Order::First => EquationError::DropsOut(derivative),
                    Order::Second => EquationError::without_acceleration(left, right),
                });
            }
        }
        Self::solved(written)
    }

    /// Solves each equation for its own highest derivative.
    fn solved(written: Vec<Sides>) -> Result<Self, EquationError> {
        refuse_without_value(&written)?;
        let highest = own_derivatives(&written)?;
        if let Some(twice) = highest
            .iter()
            .enumerate()
            .find_map(|(i, derivative)| highest[..i].contains(derivative).then_some(derivative))
        {
            return Err(EquationError::SolvedTwice(twice.clone()));
        }
        let variables: Vec<String> = highest.iter().map(|symbol| symbol.name.clone()).collect();
        refuse_foreign_derivatives(&written, &variables)?;
        let pairs = written.iter().zip(&highest);
        let derivatives =
            pairs.map(|((left, right), symbol)| solve(left, right, symbol)).collect::<Result<_, _>>()?;
        let orders = highest.iter().map(Order::of).collect();
        let solved = Self { variables, orders, written, derivatives };
        let derivatives = solved.derivatives.iter().map(|formula| solved.with_rates(formula)).collect();
        Ok(Self { derivatives, ..solved })
    }

    /// The interpretation of equations in a notation that is not used for output, such as `d²x/dt² + sin 2x = 0`; `None` for other equations,
    /// and for text that cannot be parsed.
    ///
    /// ```
    /// # extern crate libration_numbers as libration;
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
        let one = |(left, right): &Sides| format!("{} = {}", left.to_latex(), right.to_latex());
        self.written.iter().map(one).collect()
    }
}

/// The name of the time.
const TIME: &str = "t";

/// The parameter with this name, which may be in the notation of a formula: omega0 for ω0.
fn parameter(name: &str, parameters: &BTreeSet<String>) -> Result<Symbol, EquationError> {
    match name.parse() {
        Ok(Expression::Symbol(symbol)) if symbol.primes == 0 && parameters.contains(&symbol.name) => {
            Ok(symbol)
        }
        _ => Err(EquationError::unknown_parameter(name, parameters)),
    }
}

/// Rejects parts such as 1/0.
fn refuse_without_value(written: &[Sides]) -> Result<(), EquationError> {
    let mut sides = written.iter().flat_map(|(left, right)| [left, right]);
    sides.find_map(Expression::without_value).map_or(Ok(()), |missing| Err(missing.into()))
}

/// Rejects derivatives of names that do not denote variables.
fn refuse_foreign_derivatives(written: &[Sides], variables: &[String]) -> Result<(), EquationError> {
    let sides = written.iter().flat_map(|(left, right)| [left, right]);
    let mut symbols = sides.flat_map(Expression::symbols);
    match symbols.find(|symbol| symbol.primes > 0 && !variables.contains(&symbol.name)) {
        Some(foreign) => Err(EquationError::ForeignDerivative(foreign)),
        None => Ok(()),
    }
}

/// Solves left = right, which has the form a·x″ + b = 0, for x″ (or x′).
fn solve(left: &Expression, right: &Expression, derivative: &Symbol) -> Result<Expression, EquationError> {
    if *left == Expression::Symbol(derivative.clone()) && !right.contains(derivative) {
        return Ok(right.simplified());
    }
    let form = difference(left.simplified(), right.simplified());
    let factor = form.derivative(derivative);
    if factor.contains(derivative) {
        return Err(EquationError::NotLinear(derivative.clone()));
    }
    if factor.vanishes() {
        return Err(EquationError::DropsOut(derivative.clone()));
    }
    let rest = form.substitute(derivative, &Expression::from(0)).simplified();
    Ok(quotient(opposite(rest), factor))
}

/// −a, with the sign moved into sums.
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
/// Text that is not a formula; no `=`, or two; an equation that could be for none or several derivatives, or is not linear in its highest
/// derivative; derivatives of third order; parts that are undefined, such as 1/0.
impl FromStr for Equation {
    type Err = EquationError;

    fn from_str(text: &str) -> Result<Self, EquationError> {
        Self::solved(sides(text)?.0)
    }
}

/// The sides of each equation, and `true` if the text uses a notation that is not used for output.
fn sides(text: &str) -> Result<(Vec<Sides>, bool), EquationError> {
    let mut parser = Parser::new(text)?;
    let mut written = Vec::new();
    loop {
        let sides = one_equation(&mut parser)?;
        written.push(Written { sides, range: parser.take_range() });
        let more = parser.take(';');
        match parser.peek() {
            Token::End => return Ok((expanded(written)?, parser.is_free())),
            _ if more => {}
            Token::Sign('=') => return Err(EquationError::SecondEqualsSign),
            _ => return Err(parser.unexpected().into()),
        }
    }
}

fn one_equation(parser: &mut Parser) -> Result<Sides, EquationError> {
    let left = parser.formula()?;
    if parser.take('=') {
        return Ok((left, parser.formula()?));
    }
    match parser.peek() {
        Token::End | Token::Sign(';') => Err(EquationError::without_equals_sign(&left)),
        _ => Err(parser.unexpected().into()),
    }
}

/// Writes the equations as they were interpreted, separated by `;`.
impl fmt::Display for Equation {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (left, right)) in self.written.iter().enumerate() {
            let separator = if index == 0 { "" } else { "; " };
            write!(formatter, "{separator}{left} = {right}")?;
        }
        Ok(())
    }
}
