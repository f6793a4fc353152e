//! An oscillator and the weak force that takes or supplies energy: its small symbol, and the force while x falls.

use super::error::SlowFlowError;
use libration_motion::oscillator::Oscillator;
use libration_numbers::expression::{Equation, Expression, Function, Symbol};

/// x″ = F(x, x′, ε), which at ε = 0 is an oscillator without damping.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct WeakForce {
    /// The name of ε.
    pub parameter: String,
    /// Oscillator at ε = 0.
    pub oscillator: Oscillator,
    /// The acceleration, a formula of x, x′ and ε that is analytic; with kinks at x′ = 0 that for x′ < 0.
    pub acceleration: Expression,
    /// `true` if the acceleration has kinks where the motion turns.
    pub kinked: bool,
}

impl WeakForce {
    /// The weak force of an equation with one symbolic parameter, which is small, or with several, one of which is named as small.
    ///
    /// # Errors
    /// No letter or several, the time in the equation, no oscillator where the letter is zero, kinks without the symmetry of both half
    /// swings.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_perturbation as libration;
    /// use libration::perturbation::WeakForce;
    /// let force = WeakForce::new(&"x'' + c*x'*abs(x') + x = 0".parse()?, None)?;
    /// assert_eq!((force.parameter.as_str(), force.kinked), ("c", true));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(equation: &Equation, parameter: Option<&str>) -> Result<Self, SlowFlowError> {
        let parameter = small_parameter(equation, parameter)?;
        let oscillator =
            Oscillator::new(&equation.with(&[(&parameter, Expression::from(0))])?).map_err(|error| {
                SlowFlowError::Oscillator { parameter: parameter.clone(), error: Box::new(error) }
            })?;
        let velocity = Symbol::plain(oscillator.variable()).with_primes(1);
        let whole = equation.accelerations()[0].simplified();
        if whole.contains(&Symbol::plain("t")) {
            return Err(SlowFlowError::DependsOnTime);
        }
        let acceleration = while_falling(&whole, &velocity).simplified();
        let kinked = has_kinks(&whole, &velocity);
        if kinked && !is_odd(&whole, &oscillator) {
            return Err(SlowFlowError::KinkedAndAsymmetric);
        }
        Ok(Self { parameter, oscillator, acceleration, kinked })
    }
}

/// An equation at ε = 0 and the factor of ε to first order: x″ = F(x, x′) + ε·f(x, x′).
#[derive(Clone, Debug)]
pub(crate) struct FirstOrder {
    /// The name of ε.
    pub(crate) parameter: String,
    /// x″ = F(x, x′).
    pub(crate) unperturbed: Equation,
    /// f, a formula of x and x′.
    pub(crate) force: Expression,
}

impl FirstOrder {
    pub(crate) fn new(equation: &Equation, parameter: Option<&str>) -> Result<Self, SlowFlowError> {
        let parameter = small_parameter(equation, parameter)?;
        if equation.depends_on_time() {
            return Err(SlowFlowError::DependsOnTime);
        }
        let (symbol, zero) = (Symbol::plain(&parameter), Expression::from(0));
        let slope = equation.accelerations()[0].derivative(&symbol);
        let force = slope.substitute(&symbol, &zero).simplified();
        let unperturbed = equation.with(&[(&parameter, zero)])?;
        Ok(Self { parameter, unperturbed, force })
    }
}

/// The small symbol: the named one, or the only one without a value.
fn small_parameter(equation: &Equation, named: Option<&str>) -> Result<String, SlowFlowError> {
    let mut open: Vec<String> = equation.parameters().into_iter().collect();
    let chosen = match named {
        Some(name) => open.iter().position(|parameter| parameter == name),
        None => (open.len() == 1).then_some(0),
    };
    match chosen {
        _ if open.is_empty() => Err(SlowFlowError::NoSmallParameter),
        None if named.is_some() => {
            Err(SlowFlowError::UnknownParameter { name: named.unwrap_or_default().to_owned(), open })
        }
        None => Err(SlowFlowError::WhichIsSmall { open }),
        Some(index) => {
            let parameter = open.remove(index);
            if open.is_empty() { Ok(parameter) } else { Err(SlowFlowError::WithoutValue { names: open }) }
        }
    }
}

/// The formula for negative velocity: −x′ in place of |x′|, and −1 in place of its sign.
fn while_falling(formula: &Expression, velocity: &Symbol) -> Expression {
    match formula {
        Expression::Call(Function::Abs, of) if is_symbol(of, velocity) => Expression::Negate(of.clone()),
        Expression::Call(Function::Sign, of) if is_symbol(of, velocity) => Expression::from(-1),
        _ => formula.with_parts(|part| while_falling(part, velocity)),
    }
}

fn has_kinks(formula: &Expression, velocity: &Symbol) -> bool {
    let kink = |expression: &Expression| matches!(expression, Expression::Call(Function::Abs | Function::Sign, of) if is_symbol(of, velocity));
    kink(formula) || formula.parts().any(|part| has_kinks(part, velocity))
}

fn is_symbol(formula: &Expression, symbol: &Symbol) -> bool {
    matches!(formula, Expression::Symbol(other) if other == symbol)
}

/// Returns `true` if the acceleration is proved to be the opposite at the opposite displacement and velocity.
fn is_odd(acceleration: &Expression, oscillator: &Oscillator) -> bool {
    let at_zero = oscillator.equilibrium().exact().is_some_and(libration_numbers::algebra::Rational::is_zero);
    let x = Symbol::plain(oscillator.variable());
    let opposite = |symbol: &Symbol| Expression::Negate(Box::new(Expression::Symbol(symbol.clone())));
    let velocity = x.with_primes(1);
    let mirrored = acceleration.substitute(&x, &opposite(&x)).substitute(&velocity, &opposite(&velocity));
    at_zero && Expression::Add(Box::new(mirrored), Box::new(acceleration.clone())).vanishes()
}
