//! Equations of motion in first-order form.

use super::moduli::Moduli;
use super::sharp::SharpFormula;
use super::state_names::named_state;
use super::{Event, Moment, StateNameError};
use crate::expression::{Equation, Expression, Symbol, Tape, WithoutValue};

/// Equations of motion whose state is all coordinates, then all velocities, in the order of the equations.
///
/// # Examples
/// ```
/// use libration::taylor::System;
/// let system = System::new(&"x'' = y - x; y'' = x - y".parse()?)?;
/// assert_eq!(system.state_names(), ["x", "y", "x'", "y'"]);
/// assert!(System::new(&"x'' = -k x".parse()?).is_err());
/// assert!(System::with_parameters(&"x'' = -k x".parse()?, &["k"]).is_ok());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct System {
    equation: Equation,
    variables: Vec<Symbol>,
    parameters: Vec<Symbol>,
    events: Vec<Event>,
    /// The accelerations, then what stands between the bars of each |…|, then the formulas of the events; the inputs are
    /// coordinates, velocities, the time, the open parameters, and the sign of what stands in each |…|.
    tape: Tape,
    /// Of what stands in each |…| the number in a state, if it is one of the velocities.
    velocities_in_moduli: Vec<Option<usize>>,
    /// The events whose formulas the series of a whole step do not show.
    sharp: Vec<Option<SharpFormula>>,
}

impl System {
    /// The system of some equations of motion, in which t is the time.
    ///
    /// # Errors
    /// A parameter without a value.
    pub fn new(equation: &Equation) -> Result<Self, WithoutValue> {
        Self::with_parameters(equation, &[])
    }

    /// The system of equations some of whose parameters keep open; each [`Trajectory`](super::Trajectory) gives them values.
    ///
    /// # Errors
    /// Another parameter without a value.
    pub fn with_parameters(equation: &Equation, parameters: &[&str]) -> Result<Self, WithoutValue> {
        let parameters = parameters.iter().map(|name| Symbol::plain(name)).collect();
        Self::build(equation.clone(), parameters, vec![])
    }

    /// The same system, with these events to be found.
    ///
    /// # Errors
    /// A symbol in a formula that is neither coordinate nor velocity, time or open parameter.
    pub fn with_events(self, events: &[Event]) -> Result<Self, WithoutValue> {
        Self::build(self.equation, self.parameters, events.to_vec())
    }

    fn build(equation: Equation, parameters: Vec<Symbol>, events: Vec<Event>) -> Result<Self, WithoutValue> {
        let variables: Vec<Symbol> = equation.variables().iter().map(|name| Symbol::plain(name)).collect();
        let state = state(&variables);
        let mut moduli = Moduli::default();
        let watched = events.iter().map(|event| &event.formula);
        let formulas = equation.accelerations().iter().chain(watched);
        let formulas: Vec<Expression> = formulas.map(|formula| moduli.taken_out(formula)).collect();
        let (accelerations, watched) = formulas.split_at(variables.len());
        let mut inputs = state.clone();
        inputs.push(Symbol::plain("t"));
        inputs.extend(parameters.iter().cloned());
        let sharp = events.iter().map(|event| SharpFormula::new(&event.formula, &inputs)).collect();
        inputs.extend(moduli.signs());
        let arguments = moduli.into_arguments();
        let formulas: Vec<&Expression> = accelerations.iter().chain(&arguments).chain(watched).collect();
        let tape = Tape::new(&formulas, &inputs)?;
        let velocity = |argument: &Expression| {
            let number = state.iter().position(|symbol| *argument == Expression::Symbol(symbol.clone()));
            number.filter(|&number| number >= variables.len())
        };
        let velocities_in_moduli = arguments.iter().map(velocity).collect();
        Ok(Self { equation, variables, parameters, events, tape, velocities_in_moduli, sharp })
    }

    /// The names of the numbers of a state: `theta`, `theta'`.
    #[must_use]
    pub fn state_names(&self) -> Vec<String> {
        state(&self.variables).iter().map(ToString::to_string).collect()
    }

    /// A state at the time zero from names and values, as `theta` and `theta'`; numbers that are not named are zero.
    ///
    /// # Errors
    /// A name that is none of [`Self::state_names`], or one that is there twice.
    ///
    /// # Examples
    /// ```
    /// use libration::taylor::System;
    /// let system = System::new(&"x'' = y - x; y'' = x - y".parse()?)?;
    /// assert_eq!(system.start(&[("y", 2.0), ("x'", -1.0)])?.state, [0.0, 2.0, -1.0, 0.0]);
    /// assert!(system.start(&[("z", 1.0)]).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn start(&self, values: &[(&str, f64)]) -> Result<Moment, StateNameError> {
        let rest = vec![0.0; 2 * self.coordinates()];
        Ok(Moment { time: 0.0, state: named_state(&self.state_names(), rest, values)? })
    }

    /// How many coordinates there are, and how many velocities.
    #[must_use]
    pub fn coordinates(&self) -> usize {
        self.variables.len()
    }

    /// The names of the parameters that were left open.
    #[must_use]
    pub fn parameters(&self) -> Vec<String> {
        self.parameters.iter().map(ToString::to_string).collect()
    }

    /// The events that are looked for.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The formula of an event whose series need looking after.
    pub(super) fn sharp(&self, event: usize) -> Option<&SharpFormula> {
        self.sharp[event].as_ref()
    }

    /// How many different |…| there are.
    pub(super) fn moduli(&self) -> usize {
        self.velocities_in_moduli.len()
    }

    /// The number in a state of the velocity that stands in a |…|.
    pub(super) fn velocity_in_modulus(&self, modulus: usize) -> Option<usize> {
        self.velocities_in_moduli[modulus]
    }

    /// The accelerations alone, with their |…|, as functions of the state, the time and the open parameters.
    pub(super) fn accelerations(&self) -> Option<Tape> {
        let time = Symbol::plain("t");
        let inputs: Vec<Symbol> =
            state(&self.variables).into_iter().chain([time]).chain(self.parameters.iter().cloned()).collect();
        Tape::new(&self.equation.accelerations().iter().collect::<Vec<_>>(), &inputs).ok()
    }

    pub(super) fn tape(&self) -> &Tape {
        &self.tape
    }
}

/// The coordinates, then the velocities.
fn state(variables: &[Symbol]) -> Vec<Symbol> {
    let velocities = variables.iter().map(|symbol| symbol.with_primes(1));
    variables.iter().cloned().chain(velocities).collect()
}
