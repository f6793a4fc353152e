//! Equations of motion in first-order form.

use super::moduli::Moduli;
use crate::expression::{Equation, Expression, Symbol, Tape, WithoutValue};

/// Equations of motion whose state is all coordinates, then all velocities, in the order of the equations.
///
/// # Examples
/// ```
/// use libration::taylor::System;
/// let system = System::new(&"x'' = y - x; y'' = x - y".parse()?)?;
/// assert_eq!(system.state_names(), ["x", "y", "x'", "y'"]);
/// assert!(System::new(&"x'' = -k x".parse()?).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct System {
    variables: Vec<Symbol>,
    /// The accelerations, then what stands between the bars of each |…|; the inputs are coordinates, velocities, the
    /// time, and the sign of each of the latter.
    tape: Tape,
}

impl System {
    /// The system of some equations of motion, in which t is the time.
    ///
    /// # Errors
    /// A parameter without a value.
    pub fn new(equation: &Equation) -> Result<Self, WithoutValue> {
        let variables: Vec<Symbol> = equation.variables().iter().map(|name| Symbol::plain(name)).collect();
        let mut moduli = Moduli::default();
        let mut formulas: Vec<Expression> =
            equation.accelerations().iter().map(|formula| moduli.taken_out(formula)).collect();
        let velocities = variables.iter().map(|symbol| symbol.with_primes(1));
        let mut inputs: Vec<Symbol> = variables.iter().cloned().chain(velocities).collect();
        inputs.push(Symbol::plain("t"));
        inputs.extend(moduli.signs());
        formulas.extend(moduli.into_arguments());
        let tape = Tape::new(&formulas.iter().collect::<Vec<_>>(), &inputs)?;
        Ok(Self { variables, tape })
    }

    /// The names of the numbers of a state: `theta`, `theta'`.
    #[must_use]
    pub fn state_names(&self) -> Vec<String> {
        let velocities = self.variables.iter().map(|symbol| symbol.with_primes(1));
        self.variables.iter().cloned().chain(velocities).map(|symbol| symbol.to_string()).collect()
    }

    /// How many coordinates there are, and how many velocities.
    #[must_use]
    pub fn coordinates(&self) -> usize {
        self.variables.len()
    }

    /// How many different |…| there are.
    pub(super) fn moduli(&self) -> usize {
        self.tape.results().len() - self.coordinates()
    }

    pub(super) fn tape(&self) -> &Tape {
        &self.tape
    }
}
