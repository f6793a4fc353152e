//! Equations of a motion whose forces jump, on each side of the jumps and sliding along them, with their variations.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use crate::taylor::{NoDerivative, OpenSigns, Side, StateLayout, System, with_sensitivities};
use libration_numbers::algebra::Doubles;
use libration_numbers::expression::{Equation, Symbol, WithoutValue};
use libration_numbers::internals::expression::{Jet, Tape};

/// All equations between the jumps of one system.
#[derive(Debug)]
pub(super) struct Modes {
    pub(super) open: OpenSigns,
    pub(super) layout: StateLayout,
    /// The state component that is each argument and that friction can hold.
    pub(super) driven: Vec<Option<usize>>,
    parameters: Vec<String>,
    inputs: Vec<Symbol>,
    /// The derivatives of each argument by the state, the time and the parameters.
    gradients: Tape,
    for_many_steps: bool,
    /// The equations by the arguments that are held at zero; those with none are made at once, the others when they are needed.
    free: Arc<Mode>,
    sliding: Mutex<BTreeMap<Vec<usize>, Arc<Mode>>>,
}

/// The equations while some arguments are held at zero.
#[derive(Debug)]
pub(super) struct Mode {
    /// The equations with their variations; the parameters are those of the system, then the signs.
    pub(super) variations: System,
    rates: Tape,
}

/// A state of a motion at a time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<'a> {
    pub(super) time: f64,
    pub(super) state: &'a [f64],
    pub(super) parameters: &'a [f64],
}

impl Place<'_> {
    fn inputs(&self, sides: &[Side]) -> Vec<f64> {
        let signs = sides.iter().map(|side| side.sign());
        let inputs = self.state.iter().chain([&self.time]).chain(self.parameters).copied();
        inputs.chain(signs).collect()
    }
}

impl Modes {
    /// The equations of a system with these parameters; `None` if no force jumps.
    pub(super) fn new(equation: &Equation, parameters: &[&str]) -> Result<Option<Self>, WithoutValue> {
        let Some(open) = OpenSigns::new(equation) else { return Ok(None) };
        let layout = StateLayout::new(equation);
        let mut symbols = layout.symbols(equation.variables());
        symbols.extend(["t"].iter().chain(parameters).map(|name| Symbol::plain(name)));
        let slopes = open
            .arguments()
            .iter()
            .flat_map(|argument| symbols.iter().map(move |symbol| argument.derivative(symbol).simplified()));
        let slopes: Vec<_> = slopes.collect();
        let inputs: Vec<Symbol> = symbols.iter().chain(open.signs()).cloned().collect();
        let gradients = Tape::new(&slopes.iter().collect::<Vec<_>>(), &inputs)?;
        let parameters: Vec<String> = parameters.iter().map(|name| (*name).to_owned()).collect();
        let free = Arc::new(Mode::new(open.equation(), &parameters, &inputs)?);
        let driven = (0..open.signs().len()).map(|argument| open.driven(argument)).collect();
        let sliding = Mutex::default();
        let for_many_steps = false;
        Ok(Some(Self { open, layout, driven, parameters, inputs, gradients, for_many_steps, free, sliding }))
    }

    /// The same equations for thousands of motions.
    pub(super) fn for_many_steps(self) -> Self {
        let free = self.free.for_many_steps();
        Self { free, for_many_steps: true, sliding: Mutex::default(), ..self }
    }

    /// The equations for arguments on these sides.
    pub(super) fn mode(&self, sides: &[Side]) -> Result<Arc<Mode>, NoDerivative> {
        let held: Vec<usize> = (0..sides.len()).filter(|&argument| sides[argument] == Side::Zero).collect();
        if held.is_empty() {
            return Ok(Arc::clone(&self.free));
        }
        let mut sliding = self.sliding.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(mode) = sliding.get(&held) {
            return Ok(Arc::clone(mode));
        }
        let equation = self.open.sliding(&held).ok_or(NoDerivative::Sliding)?;
        let made = Mode::new(&equation, &self.parameters, &self.inputs).map_err(|_| NoDerivative::Sliding)?;
        let made = if self.for_many_steps { made.for_many_steps() } else { Arc::new(made) };
        sliding.insert(held, Arc::clone(&made));
        Ok(made)
    }

    /// The values of the parameters of a mode: those of the system, then the signs.
    pub(super) fn values(&self, parameters: &[f64], sides: &[Side]) -> Vec<f64> {
        parameters.iter().copied().chain(sides.iter().map(|side| side.sign())).collect()
    }

    /// The rate of change of each component on these sides; NaN where a formula has no value.
    pub(super) fn rates(&self, sides: &[Side], at: Place<'_>) -> Result<Vec<f64>, NoDerivative> {
        let mode = self.mode(sides)?;
        let mut rates = vec![f64::NAN; self.layout.numbers()];
        let Ok(jet) = Jet::new(&Doubles, &mode.rates, &at.inputs(sides)) else { return Ok(rates) };
        for coordinate in 0..self.layout.coordinates() {
            if let Some(velocity) = self.layout.velocity(coordinate) {
                rates[coordinate] = at.state[velocity];
            }
            rates[self.layout.driven(coordinate)] = jet.result(coordinate)[0];
        }
        Ok(rates)
    }

    /// The derivatives of an argument by each component, the time and each parameter; NaN where a formula has no value.
    pub(super) fn gradient(&self, argument: usize, sides: &[Side], at: Place<'_>) -> Vec<f64> {
        let width = self.inputs.len() - sides.len();
        match Jet::new(&Doubles, &self.gradients, &at.inputs(sides)) {
            Ok(jet) => (0..width).map(|number| jet.result(argument * width + number)[0]).collect(),
            Err(_) => vec![f64::NAN; width],
        }
    }
}

impl Mode {
    fn new(equation: &Equation, parameters: &[String], inputs: &[Symbol]) -> Result<Self, WithoutValue> {
        let names: Vec<&str> = parameters.iter().map(String::as_str).collect();
        let variations = with_sensitivities(equation, &names, StateLayout::new(equation).numbers());
        let open = StateLayout::new(equation).numbers() + 1;
        let names: Vec<String> = inputs[open..].iter().map(ToString::to_string).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let variations = System::with_parameters(&variations, &names)?;
        let rates = Tape::new(&equation.derivatives().iter().collect::<Vec<_>>(), inputs)?;
        Ok(Self { variations, rates })
    }

    fn for_many_steps(&self) -> Arc<Self> {
        let variations = self.variations.clone().for_many_steps();
        Arc::new(Self { variations, rates: self.rates.clone() })
    }
}
