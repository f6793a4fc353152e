//! An equation of motion about an equilibrium.

use super::OscillatorError;
use super::constant::Constant;
use super::equilibrium::{Candidates, Equilibrium, assessed, candidates, given, refined, vanishes_at};
use super::force::Force;
use super::sides::Sides;
use libration_numbers::algebra::Rational;
use libration_numbers::expression::{Equation, Expression, Symbol};
use libration_numbers::quantity::excerpt;

/// Maximum number of equilibria that are examined, those nearest to zero.
pub(super) const MOST_PLACES: usize = 20;

/// One variable that oscillates about an equilibrium.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::oscillator::{Kind, Oscillator};
/// // Two wells: the equilibrium between them is unstable.
/// let oscillator = Oscillator::new(&"x'' = x - x^3".parse()?)?;
/// assert_eq!(oscillator.equilibrium().to_string(), "1");
/// assert_eq!(oscillator.omega0_squared().to_string(), "2");
/// assert_eq!(*oscillator.kind(), Kind::Conservative);
/// assert!(!oscillator.is_odd());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Oscillator {
    equation: Equation,
    force: Force,
    equilibrium: Equilibrium,
    kind: Kind,
    odd: bool,
}

/// The property that makes the motions of an oscillator periodic.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The acceleration depends on the position only: energy is conserved.
    Conservative,
    /// The acceleration is the same for the opposite velocity: each motion about the equilibrium retraces its path.
    Reversible,
    /// The acceleration is the opposite at the opposite displacement and the same
    /// velocity: each motion about the equilibrium retraces its path, mirrored.
    Mirrored,
    /// The acceleration depends on the position only, and has one power series above the equilibrium and another below, with the same
    /// slope, as x + x·|x| has: energy is conserved.
    TwoSided,
    /// A self-excitation, whose strength is an open parameter, settles to a limit cycle. Without it
    /// the equation is linear; changing the signs of strength and velocity together changes nothing.
    LimitCycle {
        /// The name of the strength.
        parameter: String,
    },
}

impl Oscillator {
    /// The oscillator about the stable equilibrium nearest to zero. It is x = 0 if the acceleration vanishes there and is restoring; otherwise
    /// the 20 equilibria nearest to zero are examined, found everywhere for polynomials up to the 40th degree, from -10 to 10 for other
    /// accelerations. A parameter may stay open if it is the strength of a self-excitation.
    ///
    /// # Errors
    /// Several variables, the time in the equation, open parameters, or no equilibrium about which there are
    /// undamped oscillations.
    pub fn new(equation: &Equation) -> Result<Self, OscillatorError> {
        let force = force(equation)?;
        match open_parameter(equation)? {
            Some(parameter) => Self::limit_cycle(equation, force, &parameter),
            None => Self::about_nearest(equation, force),
        }
    }

    /// The oscillator about the equilibrium next to a given constant, at most 5 % away or 0.05 about zero.
    ///
    /// # Errors
    /// As [`new`](Self::new), or there is no equilibrium at this position.
    pub fn about(equation: &Equation, position: &Expression) -> Result<Self, OscillatorError> {
        let force = force(equation)?;
        if let Some(parameter) = open_parameter(equation)? {
            return Err(OscillatorError::WithoutValue { names: vec![parameter] });
        }
        let refusal = || OscillatorError::NotAnEquilibrium { at: excerpt(&position.to_string()) };
        refuse_no_place(position)?;
        let equilibrium = assessed(&force, given(&force, position).ok_or_else(refusal)?);
        let equilibrium =
            equilibrium.map_err(|refusal| OscillatorError::NoStableEquilibrium(vec![refusal]))?;
        Ok(Self::centre(equation, force, equilibrium))
    }

    fn about_nearest(equation: &Equation, force: Force) -> Result<Self, OscillatorError> {
        let zero = Constant::Exact(Rational::from(0));
        let mut refusals = vec![];
        if vanishes_at(&force, &Rational::from(0)) {
            match assessed(&force, zero.clone()) {
                Ok(equilibrium) => return Ok(Self::centre(equation, force, equilibrium)),
                Err(refusal) => refusals.push(refusal),
            }
        }
        let Candidates { near, none } = candidates(&force);
        let candidates = near.into_iter().take(MOST_PLACES).filter_map(|near| refined(&force, near));
        for candidate in candidates.filter(|candidate| *candidate != zero) {
            match assessed(&force, candidate) {
                Ok(equilibrium) => return Ok(Self::centre(equation, force, equilibrium)),
                Err(refusal) => refusals.push(refusal),
            }
        }
        Err(match refusals.as_slice() {
            [] => none,
            _ => OscillatorError::NoStableEquilibrium(refusals),
        })
    }

    fn centre(equation: &Equation, mut force: Force, equilibrium: Equilibrium) -> Self {
        let kind = match (force.uses_velocity(), force.is_reversible()) {
            (false, _) if equilibrium.sides.is_some() => Kind::TwoSided,
            (false, _) => Kind::Conservative,
            (true, true) => Kind::Reversible,
            // The equilibrium was accepted for one of the two symmetries; only the mirror symmetry remains.
            (true, false) => Kind::Mirrored,
        };
        if matches!(kind, Kind::Conservative | Kind::TwoSided) {
            force.formula = force.at_rest();
        }
        let odd = equilibrium.at.exact().is_some_and(|centre| force.is_odd_about(centre));
        Self { equation: equation.clone(), force, equilibrium, kind, odd }
    }

    /// The self-excitation of the linear oscillator to which the equation reduces at strength zero.
    fn limit_cycle(equation: &Equation, force: Force, parameter: &str) -> Result<Self, OscillatorError> {
        let symbol = Symbol::plain(parameter);
        if !force.uses_velocity() {
            return Err(OscillatorError::WithoutValue { names: vec![parameter.to_owned()] });
        }
        let equilibrium = linear_rest(&force, &symbol).ok_or_else(|| OscillatorError::ExcitedNonlinear {
            parameter: parameter.to_owned(),
            variable: force.x.name.clone(),
            left: excerpt(&left_without(&force, &symbol).to_string()),
        })?;
        if !force.is_reversible_with(&symbol) {
            return Err(OscillatorError::NoStrength { parameter: parameter.to_owned() });
        }
        let odd = equilibrium.at.exact().is_some_and(|centre| force.is_odd_about(centre));
        let kind = Kind::LimitCycle { parameter: parameter.to_owned() };
        Ok(Self { equation: equation.clone(), force, equilibrium, kind, odd })
    }

    /// The equation with its values, as it was parsed.
    #[must_use]
    pub fn equation(&self) -> &Equation {
        &self.equation
    }

    /// The name of the variable.
    #[must_use]
    pub fn variable(&self) -> &str {
        &self.force.x.name
    }

    /// The acceleration, a formula of the variable, its first derivative and, for a limit cycle, the open parameter.
    #[must_use]
    pub fn acceleration(&self) -> &Expression {
        &self.force.formula
    }

    /// The equilibrium.
    #[must_use]
    pub fn equilibrium(&self) -> &Constant {
        &self.equilibrium.at
    }

    /// ω0², the square of the frequency of small oscillations; for a limit cycle at strength zero.
    #[must_use]
    pub fn omega0_squared(&self) -> &Constant {
        &self.equilibrium.omega0_squared
    }

    /// The acceleration on both sides of the equilibrium, if these have different power series.
    #[doc(hidden)]
    pub fn sides(&self) -> Option<&Sides> {
        self.equilibrium.sides.as_ref()
    }

    /// The property that makes the motions periodic.
    #[must_use]
    pub fn kind(&self) -> &Kind {
        &self.kind
    }

    /// Returns `true` if the acceleration is proved to be the opposite at the opposite displacement and velocity. Then the motion has no even
    /// harmonics. For an equilibrium known only to a limited number of digits, nothing is proved.
    #[must_use]
    pub fn is_odd(&self) -> bool {
        self.odd
    }
}

/// The acceleration of the only variable, if it does not contain the time.
pub(super) fn force(equation: &Equation) -> Result<Force, OscillatorError> {
    let [variable] = equation.variables() else {
        return Err(OscillatorError::SeveralVariables { names: equation.variables().to_vec() });
    };
    equation.refuse_first_order()?;
    let formula = equation.accelerations()[0].simplified();
    if formula.contains(&Symbol::plain("t")) {
        return Err(OscillatorError::DependsOnTime);
    }
    Ok(Force::new(formula, variable))
}

/// The one parameter without a value, if there is one.
fn open_parameter(equation: &Equation) -> Result<Option<String>, OscillatorError> {
    let mut names: Vec<String> = equation.parameters().into_iter().collect();
    if names.len() > 1 {
        return Err(OscillatorError::WithoutValue { names });
    }
    Ok(names.pop())
}

/// Rejects an expression that is not a constant with a value.
fn refuse_no_place(position: &Expression) -> Result<(), OscillatorError> {
    let why = match (position.symbols().pop_first(), position.without_value()) {
        (Some(inside), _) => format!("{inside} in it has no value; give a number, such as 0.5 or pi/2"),
        (None, Some(missing)) => missing.to_string(),
        (None, None) => return Ok(()),
    };
    Err(OscillatorError::NotAPlace { place: excerpt(&position.to_string()), why })
}

/// The acceleration at strength zero.
fn left_without(force: &Force, parameter: &Symbol) -> Expression {
    force.formula.substitute(parameter, &Expression::from(0)).simplified()
}

/// The equilibrium of the acceleration at strength zero, if this is a linear oscillator with fractions as coefficients.
fn linear_rest(force: &Force, parameter: &Symbol) -> Option<Equilibrium> {
    let coefficients = left_without(force, parameter).polynomial_coefficients(&force.x)?;
    let [constant, slope] = coefficients.as_slice() else { return None };
    let omega0_squared = -slope.clone();
    let at = constant.checked_div(&omega0_squared)?;
    let stable = !omega0_squared.is_negative() && !omega0_squared.is_zero();
    let equilibrium =
        Equilibrium { at: Constant::Exact(at), omega0_squared: Constant::Exact(omega0_squared), sides: None };
    stable.then_some(equilibrium)
}
