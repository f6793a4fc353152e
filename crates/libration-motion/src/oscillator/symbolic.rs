//! Oscillators with symbolic parameters.

use std::fmt;

use super::OscillatorError;
use super::force::Force;
use super::model::{Kind, force};
use super::named_constants::{NamedConstants, free_name, value_of};
use libration_numbers::algebra::{LaurentPolynomial, LaurentPolynomials, Rational, Ring};
use libration_numbers::quantity::excerpt;
use libration_numbers::{
    expression::{Equation, Expression, Symbol},
    internals::expression::{Jet, Tape},
};

/// An oscillator about an equilibrium that is a formula of the symbolic parameters, which are positive wherever a root is taken.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::oscillator::SymbolicOscillator;
/// let oscillator = SymbolicOscillator::new(&"x'' + w^2*x + a*x^2 + b*x^3 = 0".parse()?)?;
/// assert_eq!(oscillator.letters(), ["a", "b", "w"]);
/// assert_eq!(oscillator.omega0_squared().to_string(), "w^2");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct SymbolicOscillator {
    equation: Equation,
    /// The force, with the displacement counted from the equilibrium.
    force: Force,
    kind: Kind,
    odd: bool,
    letters: Vec<String>,
    constants: Vec<(String, Expression)>,
    ring: LaurentPolynomials,
    /// The acceleration as a function of x, x′ and the symbols.
    tape: Tape,
    /// The values of the tape's slots at the equilibrium.
    values: Vec<LaurentPolynomial>,
    equilibrium: LaurentPolynomial,
    omega0_squared: LaurentPolynomial,
}

impl SymbolicOscillator {
    /// The oscillator about zero.
    ///
    /// # Errors
    /// Several variables, the time in the equation, or a property that prevents a symbolic expansion.
    pub fn new(equation: &Equation) -> Result<Self, SymbolicOscillatorError> {
        Self::about(equation, &Expression::from(0))
    }

    /// The oscillator about an equilibrium given as a formula of the symbols.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn about(equation: &Equation, position: &Expression) -> Result<Self, SymbolicOscillatorError> {
        let force = force(equation)?;
        let names: Vec<String> = equation.parameters().into_iter().collect();
        Self::of_letters(equation, &force, position, &names).map_err(|reason| {
            let variable = force.x.name.clone();
            SymbolicOscillatorError::NoExpansion {
                names,
                variable,
                at: excerpt(&position.to_string()),
                reason,
            }
        })
    }

    fn of_letters(
        equation: &Equation,
        force: &Force,
        position: &Expression,
        names: &[String],
    ) -> Result<Self, SymbolicSeriesError> {
        let mut force = Force { formula: counted_from(&force.formula, &force.x, position), ..force.clone() };
        let variables = [force.x.clone(), force.velocity.clone()];
        let mut named = NamedConstants::new(&variables, names);
        force.formula = named.named(&force.formula);
        let constants = named.constants;
        let mut in_ring: Vec<String> =
            names.iter().chain(constants.iter().map(|(name, _)| name)).cloned().collect();
        in_ring.push(free_name("omega0", &in_ring));
        let ring = LaurentPolynomials::new(in_ring);
        let equilibrium = value_of(&ring, position).ok_or(SymbolicSeriesError::NoSeries)?;
        let zero = Rational::from(0);
        let kind = match (force.uses_velocity(), force.is_reversible(), force.is_mirrored_about(&zero)) {
            (false, ..) => Some(Kind::Conservative),
            (true, true, _) => Some(Kind::Reversible),
            (true, false, true) => Some(Kind::Mirrored),
            (true, false, false) => None,
        };
        if kind == Some(Kind::Conservative) {
            force.formula = force.at_rest();
        }
        let tape = tape(&force, &ring).ok_or(SymbolicSeriesError::NoSeries)?;
        let AtRest { values, slope, damping } =
            AtRest::new(&ring, &tape).ok_or(SymbolicSeriesError::NoSeries)?;
        let vanishing = &values[tape.results()[0]];
        if !vanishing.is_zero() {
            return Err(SymbolicSeriesError::NotAtRest { acceleration: excerpt(&vanishing.to_string()) });
        }
        if !damping.is_zero() {
            return Err(SymbolicSeriesError::Damped { damping: excerpt(&damping.to_string()) });
        }
        let kind = kind.ok_or(SymbolicSeriesError::Irreversible)?;
        let omega0_squared = stiffness(&ring, &slope)?;
        let odd = force.is_odd_about(&zero);
        let (equation, letters) = (equation.clone(), names.to_vec());
        Ok(Self {
            equation,
            force,
            kind,
            odd,
            letters,
            constants,
            ring,
            tape,
            values,
            equilibrium,
            omega0_squared,
        })
    }

    /// The equation, as it was parsed.
    #[must_use]
    pub fn equation(&self) -> &Equation {
        &self.equation
    }

    /// The name of the variable.
    #[must_use]
    pub fn variable(&self) -> &str {
        &self.force.x.name
    }

    /// The names of the parameters without values.
    #[must_use]
    pub fn letters(&self) -> &[String] {
        &self.letters
    }

    /// The names, with the constants that they replace because these are no products of symbols: c1 for √2, pi for π.
    #[must_use]
    pub fn constants(&self) -> &[(String, Expression)] {
        &self.constants
    }

    /// The equilibrium.
    #[must_use]
    pub fn equilibrium(&self) -> &LaurentPolynomial {
        &self.equilibrium
    }

    /// ω0², the square of the frequency of small oscillations.
    #[must_use]
    pub fn omega0_squared(&self) -> &LaurentPolynomial {
        &self.omega0_squared
    }

    /// The property that makes the motions periodic: conserved energy, or motions that retrace their paths.
    #[must_use]
    pub fn kind(&self) -> &Kind {
        &self.kind
    }

    /// Returns `true` if the acceleration is proved to be the opposite at the opposite displacement.
    #[must_use]
    pub fn is_odd(&self) -> bool {
        self.odd
    }

    /// The acceleration, the displacement counted from the equilibrium.
    #[doc(hidden)]
    pub fn acceleration(&self) -> &Expression {
        &self.force.formula
    }

    /// The ring of the symbols, the named constants and, after these, ω0.
    #[doc(hidden)]
    pub fn ring(&self) -> &LaurentPolynomials {
        &self.ring
    }

    /// The coefficients of the acceleration by the powers of displacement and velocity up to this degree: the two exponents and the value.
    #[doc(hidden)]
    pub fn powers(&self, degree: usize) -> Option<Vec<([usize; 2], LaurentPolynomial)>> {
        let mut powers = vec![];
        let mut of_velocity = self.force.formula.clone();
        for velocity in 0..=degree {
            let at_rest = of_velocity.substitute(&self.force.velocity, &0.into()).simplified();
            let series = self.taylor_series(&at_rest, degree + 1 - velocity)?;
            let factorial = (1..=u64::try_from(velocity).ok()?).product();
            for (position, coefficient) in
                series.into_iter().enumerate().filter(|(_, coefficient)| !coefficient.is_zero())
            {
                powers.push(([position, velocity], self.ring.over_integer(&coefficient, factorial)?));
            }
            of_velocity = of_velocity.derivative(&self.force.velocity).simplified();
            if of_velocity.vanishes() {
                break;
            }
        }
        Some(powers)
    }

    /// The coefficients of a formula by powers of the displacement.
    fn taylor_series(&self, formula: &Expression, length: usize) -> Option<Vec<LaurentPolynomial>> {
        let force = Force { formula: formula.clone(), ..self.force.clone() };
        let tape = tape(&force, &self.ring)?;
        let letters = (0..tape.inputs() - 2).map(|number| self.ring.letter(number));
        let inputs: Vec<_> = [self.ring.zero(), self.ring.zero()].into_iter().chain(letters).collect();
        let mut jet = Jet::new(&self.ring, &tape, &inputs).ok()?;
        let mut slope = vec![self.ring.zero(); tape.inputs()];
        for n in 1..length {
            *slope.first_mut()? = self.ring.rational(&Rational::from(i64::from(n == 1)))?;
            jet.extend(&slope).ok()?;
        }
        let result = jet.result(0);
        let is_complete = result.iter().take(length).all(|value| !value.is_beyond_limit());
        is_complete.then(|| result[..length.min(result.len())].to_vec())
    }

    #[doc(hidden)]
    pub fn tape(&self) -> &Tape {
        &self.tape
    }

    #[doc(hidden)]
    pub fn values(&self) -> &[LaurentPolynomial] {
        &self.values
    }
}

/// The values and derivatives on the tape at rest.
struct AtRest {
    values: Vec<LaurentPolynomial>,
    /// ∂F/∂x.
    slope: LaurentPolynomial,
    /// ∂F/∂x′.
    damping: LaurentPolynomial,
}

impl AtRest {
    fn new(ring: &LaurentPolynomials, tape: &Tape) -> Option<Self> {
        let letters = (0..tape.inputs() - 2).map(|number| ring.letter(number));
        let inputs: Vec<LaurentPolynomial> = [ring.zero(), ring.zero()].into_iter().chain(letters).collect();
        let jet = Jet::new(ring, tape, &inputs).ok()?;
        let result = tape.results()[0];
        let gain = |input: usize| Some(jet.gains(input).ok()?.swap_remove(result));
        let (slope, damping) = (gain(0)?, gain(1)?);
        let values: Vec<LaurentPolynomial> = jet.values().cloned().collect();
        let is_complete = values.iter().chain([&slope, &damping]).all(|value| !value.is_beyond_limit());
        is_complete.then_some(Self { values, slope, damping })
    }
}

/// The acceleration in x, x′ and the symbols.
fn tape(force: &Force, ring: &LaurentPolynomials) -> Option<Tape> {
    let letters = ring.letters().split_last()?.1.iter().map(|name| Symbol::plain(name));
    let inputs: Vec<Symbol> = [force.x.clone(), force.velocity.clone()].into_iter().chain(letters).collect();
    Tape::new(&[&force.formula], &inputs).ok()
}

/// ω0², if it is positive for some positive values of the symbols.
fn stiffness(
    ring: &LaurentPolynomials,
    slope: &LaurentPolynomial,
) -> Result<LaurentPolynomial, SymbolicSeriesError> {
    let omega0_squared = ring.negate(slope);
    if omega0_squared.is_zero() {
        return Err(SymbolicSeriesError::NoLinearPart);
    }
    if omega0_squared.terms().all(|(factor, _)| factor.is_negative()) {
        return Err(SymbolicSeriesError::Unstable { omega0_squared: excerpt(&omega0_squared.to_string()) });
    }
    Ok(omega0_squared)
}

fn counted_from(formula: &Expression, x: &Symbol, position: &Expression) -> Expression {
    if *position == Expression::from(0) {
        return formula.clone();
    }
    let shifted = Expression::Add(Box::new(Expression::Symbol(x.clone())), Box::new(position.clone()));
    formula.substitute(x, &shifted)
}

/// The reason why an oscillator with symbolic parameters has no expansion.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SymbolicOscillatorError {
    /// An error that occurs with numerical values too.
    #[error(transparent)]
    Oscillator(#[from] OscillatorError),
    /// A case that may have an expansion with numerical values.
    #[error(
        "no value is given for {}: give one, such as {}=0.1; a symbolic expansion about {variable} = {at} does not exist, because {reason}",
        names.join(", "),
        names.first().map_or("mu", String::as_str)
    )]
    NoExpansion {
        /// The parameters without values.
        names: Vec<String>,
        /// The variable.
        variable: String,
        /// The position that was given or tried as the equilibrium.
        at: String,
        /// The reason.
        reason: SymbolicSeriesError,
    },
}

/// The reason why there is no symbolic expansion.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SymbolicSeriesError {
    /// A quantity is not a Laurent polynomial in the symbols and their roots.
    NoSeries,
    /// The acceleration does not vanish at the position.
    NotAtRest {
        /// The acceleration.
        acceleration: String,
    },
    /// ω0² is zero.
    NoLinearPart,
    /// ω0² is negative.
    Unstable {
        /// The value of ω0².
        omega0_squared: String,
    },
    /// Small oscillations lose or gain energy.
    Damped {
        /// ∂F/∂x′.
        damping: String,
    },
    /// Larger oscillations lose or gain energy.
    Irreversible,
}

impl fmt::Display for SymbolicSeriesError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSeries => formatter.write_str(
                "not all coefficients of the acceleration by powers of the displacement are sums of products of symbols, their powers and roots",
            ),
            Self::NotAtRest { acceleration } => write!(
                formatter,
                "the acceleration there is {acceleration}, which is not zero for all values: give the equilibrium as a formula in the symbols"
            ),
            Self::NoLinearPart => formatter.write_str("omega0^2 is 0: the restoring force has no linear part"),
            Self::Unstable { omega0_squared } => {
                write!(formatter, "omega0^2 = {omega0_squared} is negative for positive symbols")
            }
            Self::Damped { damping } => {
                write!(formatter, "the acceleration contains {damping} times the velocity")
            }
            Self::Irreversible => {
                formatter.write_str(
                    "the acceleration is neither the same for the opposite velocity nor the opposite for the opposite displacement",
                )
            }
        }
    }
}
