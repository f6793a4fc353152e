//! Equations of motion in first-order form.

use std::sync::Arc;

use super::moduli::{Moduli, where_zero};
use super::monomials::with_values_at_zero;
use super::passage::Passage;
use super::plan::Plans;
use super::state_names::named_state;
use crate::taylor::events::sharp::SharpFormula;
use crate::taylor::step::allowance::Allowance;
use crate::taylor::step::tolerances::{ToleranceError, allowances, own_tolerances};
use crate::taylor::{Effort, Event, Moment, StateLayout, StateNameError};
use libration_numbers::{
    expression::{Equation, Expression, Symbol, WithoutValue},
    internals::expression::Tape,
};

/// Equations of motion whose state consists of all coordinates, then the velocities, in the
/// order of the equations. A coordinate whose equation is of first order has no velocity.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::taylor::System;
/// let system = System::new(&"x'' = y - x; y'' = x - y".parse()?)?;
/// assert_eq!(system.state_names(), ["x", "y", "x'", "y'"]);
/// let motor = System::new(&"q' = -q - x'; x'' = q".parse()?)?;
/// assert_eq!(motor.state_names(), ["q", "x", "x'"]);
/// assert!(System::new(&"x'' = -k x".parse()?).is_err());
/// assert!(System::with_parameters(&"x'' = -k x".parse()?, &["k"]).is_ok());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct System {
    equation: Equation,
    layout: Arc<StateLayout>,
    parameters: Vec<Symbol>,
    events: Vec<Event>,
    /// The accelerations and rates of change, then the argument of each |…|, then the formulas of the events; the inputs are coordinates,
    /// velocities, the time, the open parameters, and the sign of the argument of each |…|.
    tape: Tape,
    /// State component that is the argument of each |…|, if its rate of change has an equation, as that of a velocity.
    driven_in_moduli: Vec<Option<usize>>,
    /// The formulas of events that the series of a whole step do not represent.
    sharp: Vec<Option<SharpFormula>>,
    /// Equations for passing positions at which a force has no series, if there are any.
    passage: Option<Arc<Passage>>,
    plans: Arc<Plans>,
    for_many_steps: bool,
    /// Individual tolerances of coordinates; zero for coordinates without one.
    tolerances: Vec<f64>,
    /// `true` if a state component has come to rest, by which the equations have changed.
    rests: bool,
}

impl System {
    /// The system of some equations of motion, in which t is the time.
    ///
    /// # Errors
    /// A parameter without a value.
    pub fn new(equation: &Equation) -> Result<Self, WithoutValue> {
        Self::with_parameters(equation, &[])
    }

    /// The system of equations some of whose parameters stay open; each [`Trajectory`](crate::taylor::Trajectory) gives them values.
    ///
    /// # Errors
    /// Another parameter without a value.
    pub fn with_parameters(equation: &Equation, parameters: &[&str]) -> Result<Self, WithoutValue> {
        let parameters = parameters.iter().map(|name| Symbol::plain(name)).collect();
        Self::build(equation.clone(), parameters, vec![])
    }

    /// The same system with events to be found.
    ///
    /// # Errors
    /// A symbol in a formula that is neither coordinate nor velocity, time or open parameter.
    pub fn with_events(self, events: &[Event]) -> Result<Self, WithoutValue> {
        let tolerances = self.tolerances;
        Ok(Self { tolerances, ..Self::build(self.equation, self.parameters, events.to_vec())? })
    }

    /// The same system with individual tolerances of some coordinates, which replace [`Effort::relative`]: the allowed error
    /// of a step in the coordinate relative to its displacement, and in its velocity relative to its size. Errors propagate
    /// from one coordinate to the others as the equations couple them, so that a larger tolerance is reasonable for a
    /// coordinate on which the others hardly depend. The smallest of all tolerances determines the order of the series.
    ///
    /// # Errors
    /// A name that is not a coordinate, or occurs twice; a tolerance outside of [`Effort::TOLERANCES`].
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::progress::Quiet;
    /// use libration::taylor::{Effort, System, integrate};
    /// // No other coordinate depends on y.
    /// let system = System::new(&"x'' = -x; y' = x*cos(20*x)".parse()?)?;
    /// let start = system.start(&[("x", 1.0)])?;
    /// let steps = |system: &System| integrate(system, &start, &[20.0], &Effort::to_tolerance(1e-15), &Quiet).map(|it| it.steps);
    /// let looser = system.clone().with_tolerances(&[("y", 1e-6)])?;
    /// assert!(steps(&looser)? < steps(&system)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_tolerances(self, tolerances: &[(&str, f64)]) -> Result<Self, ToleranceError> {
        let tolerances = own_tolerances(self.equation.variables(), tolerances)?;
        Ok(Self { tolerances, ..self })
    }

    /// The same system with its individual tolerances multiplied by a factor.
    pub(in crate::taylor) fn with_part_of_tolerances(&self, part: f64) -> Self {
        let least = Effort::TOLERANCES[0];
        let parts = self
            .tolerances
            .iter()
            .map(|&tolerance| if tolerance > 0.0 { (part * tolerance).max(least) } else { tolerance });
        Self { tolerances: parts.collect(), ..self.clone() }
    }

    /// The effort with the smallest of all tolerances, and the allowed error of each state component.
    pub(in crate::taylor) fn allowances(&self, effort: &Effort) -> (Effort, Vec<Allowance>) {
        allowances(&self.tolerances, &self.layout, effort)
    }

    /// The same system for thousands of steps, for which machine code is generated at the first step.
    #[doc(hidden)]
    pub fn for_many_steps(self) -> Self {
        Self { plans: Arc::default(), for_many_steps: true, ..self }
    }

    fn build(equation: Equation, parameters: Vec<Symbol>, events: Vec<Event>) -> Result<Self, WithoutValue> {
        let equation = with_values_at_zero(equation);
        let layout = StateLayout::new(&equation);
        let state = layout.symbols(equation.variables());
        let mut moduli = Moduli::default();
        let watched: Vec<Expression> =
            events.iter().map(|event| equation.with_rates(&event.formula)).collect();
        let formulas = equation.derivatives().iter().chain(&watched);
        let formulas: Vec<Expression> = formulas.map(|formula| moduli.taken_out(formula)).collect();
        let (derivatives, in_moduli) = formulas.split_at(layout.coordinates());
        let mut inputs = state.clone();
        inputs.push(Symbol::plain("t"));
        inputs.extend(parameters.iter().cloned());
        let written = inputs.clone();
        inputs.extend(moduli.signs());
        let sharp = in_moduli.iter().map(|formula| SharpFormula::new(formula, &inputs)).collect();
        let bases = (0..state.len()).filter(|&number| moduli.has_power_of(&state[number])).collect();
        let arguments = moduli.into_arguments();
        let passage = Passage::new(equation.derivatives(), &arguments, bases, &watched, &written)?;
        let moduli_arguments = arguments.iter().map(|modulus| &modulus.argument);
        let formulas: Vec<&Expression> =
            derivatives.iter().chain(moduli_arguments).chain(in_moduli).collect();
        let tape = Tape::new(&formulas, &inputs)?;
        let driven = |argument: &Expression| {
            let number = state.iter().position(|symbol| *argument == Expression::Symbol(symbol.clone()));
            number.filter(|&number| layout.driving(number).is_some())
        };
        let driven_in_moduli = arguments.iter().map(|modulus| driven(&modulus.argument)).collect();
        let tolerances = vec![0.0; layout.coordinates()];
        let (layout, plans, passage) = (Arc::new(layout), Arc::default(), passage.map(Arc::new));
        Ok(Self {
            equation,
            layout,
            parameters,
            events,
            tape,
            driven_in_moduli,
            sharp,
            passage,
            plans,
            for_many_steps: false,
            tolerances,
            rests: false,
        })
    }

    /// The names of the state components: `theta`, `theta'`.
    #[must_use]
    pub fn state_names(&self) -> Vec<String> {
        self.state_symbols().iter().map(ToString::to_string).collect()
    }

    /// A state at the time zero from names and values, as `theta` and `theta'`; components that are not named are zero.
    ///
    /// # Errors
    /// A name that is none of [`Self::state_names`], or one that occurs twice.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::taylor::System;
    /// let system = System::new(&"x'' = y - x; y'' = x - y".parse()?)?;
    /// assert_eq!(system.start(&[("y", 2.0), ("x'", -1.0)])?.state, [0.0, 2.0, -1.0, 0.0]);
    /// assert!(system.start(&[("z", 1.0)]).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn start(&self, values: &[(&str, f64)]) -> Result<Moment, StateNameError> {
        let rest = vec![0.0; self.layout.numbers()];
        Ok(Moment { time: 0.0, state: named_state(&self.state_names(), rest, values)? })
    }

    /// The number of coordinates, one for each equation.
    #[must_use]
    pub fn coordinates(&self) -> usize {
        self.layout.coordinates()
    }

    /// The meaning of each state component.
    #[must_use]
    pub fn layout(&self) -> &StateLayout {
        &self.layout
    }

    /// The same layout, as a shared pointer.
    pub(in crate::taylor) fn shared_layout(&self) -> &Arc<StateLayout> {
        &self.layout
    }

    /// The names of the open parameters.
    #[must_use]
    pub fn parameters(&self) -> Vec<String> {
        self.parameters.iter().map(ToString::to_string).collect()
    }

    /// The events that are searched.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The place of the formula of an event on the tape.
    pub(in crate::taylor) fn event(&self, event: usize) -> usize {
        self.coordinates() + self.moduli() + event
    }

    /// Returns `true` if the formula of an event has a divisor, a root or the like, whose zeros take much time to pass.
    pub(crate) fn has_boundary(&self, event: usize) -> bool {
        self.sharp(event).is_some_and(|sharp| sharp.ends)
    }

    /// The formula of an event whose series has to be computed in parts of a step.
    pub(in crate::taylor) fn sharp(&self, event: usize) -> Option<&SharpFormula> {
        self.sharp[event].as_ref()
    }

    /// The equations with which a motion passes positions at which a force has no series, if there are any.
    pub(in crate::taylor) fn passage(&self) -> Option<&Passage> {
        self.passage.as_deref()
    }

    /// Returns `true` if there are positions at which a force has no series.
    pub(crate) fn has_passages(&self) -> bool {
        self.passage.is_some()
    }

    /// The equations of motion.
    pub(crate) fn equation(&self) -> &Equation {
        &self.equation
    }

    /// The same system with a state component that stays zero, by these equations; `None` if a formula has no value then.
    pub(in crate::taylor) fn at_rest(&self, equation: Equation, number: usize) -> Option<Self> {
        let symbol = &self.state_symbols()[number];
        let at_rest = |event: &Event| {
            let formula = where_zero(&self.equation.with_rates(&event.formula), symbol);
            let has_value = formula.without_value().is_none();
            Event { formula: if has_value { formula } else { event.formula.clone() }, ..event.clone() }
        };
        let events: Vec<Event> = self.events.iter().map(at_rest).collect();
        let system = Self::build(equation, self.parameters.clone(), events).ok()?;
        Some(Self { tolerances: self.tolerances.clone(), rests: true, ..system })
    }

    /// Returns `true` if a state component has come to rest.
    pub(in crate::taylor) fn rests(&self) -> bool {
        self.rests
    }

    /// The number of different |…|.
    #[doc(hidden)]
    pub fn moduli(&self) -> usize {
        self.driven_in_moduli.len()
    }

    /// The state component that is the argument of a |…|, if its rate of change is given by an equation, as that of a velocity.
    pub(in crate::taylor) fn driven_in_modulus(&self, modulus: usize) -> Option<usize> {
        self.driven_in_moduli[modulus]
    }

    fn state_symbols(&self) -> Vec<Symbol> {
        self.layout.symbols(self.equation.variables())
    }

    /// The accelerations and rates of change alone, with their |…|, as functions of the state, the time and the open parameters.
    pub(in crate::taylor) fn accelerations(&self) -> Option<Tape> {
        let time = Symbol::plain("t");
        let inputs: Vec<Symbol> =
            self.state_symbols().into_iter().chain([time]).chain(self.parameters.iter().cloned()).collect();
        Tape::new(&self.equation.derivatives().iter().collect::<Vec<_>>(), &inputs).ok()
    }

    pub(in crate::taylor) fn plans(&self) -> &Plans {
        &self.plans
    }

    pub(in crate::taylor) fn is_for_many_steps(&self) -> bool {
        self.for_many_steps
    }

    pub(in crate::taylor) fn tape(&self) -> &Tape {
        &self.tape
    }
}
