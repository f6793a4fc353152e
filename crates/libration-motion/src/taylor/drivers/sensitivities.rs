//! A motion with its derivatives with respect to parameters and initial values.

use crate::taylor::program::moduli::Moduli;
use crate::taylor::{StateLayout, with_sensitivities};
use libration_numbers::expression::{Equation, EquationError, Expression};

/// Equations of motion followed by those of the derivatives of the motion by some parameters and initial values, in one combined state.
///
/// # Accuracy
/// Steps are as short as necessary for motion and derivatives; both are computed to the same tolerance.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::progress::Quiet;
/// use libration::taylor::{Effort, Sensitivities, System, integrate};
/// // The derivatives of x = cos(√k·t) by k and by x(0).
/// let by = Sensitivities::new(&"x'' = -k*x".parse()?, &[("k", "4".parse()?)], &["k", "x"])?;
/// assert_eq!(by.names(), ["dx/dk", "dx'/dk", "dx/dx(0)", "dx'/dx(0)"]);
/// let start = by.start(&[1.0, 0.0]);
/// let end = integrate(&System::new(by.equation())?, &start, &[3.0], &Effort::to_tolerance(1e-15), &Quiet)?.end;
/// let derivatives = by.derivatives_in(&end.state);
/// assert!((derivatives[0] + 3.0 * libm::sin(6.0) / 4.0).abs() < 1e-15);
/// assert!((derivatives[2] - libm::cos(6.0)).abs() < 1e-15);
/// assert!((by.state_in(&end.state)[0] - libm::cos(6.0)).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Sensitivities {
    equation: Equation,
    /// Layouts of the motion alone, and with its derivatives.
    layout: StateLayout,
    all: StateLayout,
    state_names: Vec<String>,
    /// The quantities in the order in which they were requested.
    origins: Vec<Origin>,
}

/// A quantity with respect to which the motion is differentiated.
#[derive(Clone, Debug)]
struct Origin {
    /// `c`, or `x(0)`.
    name: String,
    /// The number of the copy of the coordinates that contains the derivatives.
    copy: usize,
    /// The state component whose initial value is the quantity.
    initial: Option<usize>,
}

/// The reason why a motion cannot be differentiated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SensitivityError {
    /// Values that the equations do not allow.
    #[error(transparent)]
    Equation(#[from] EquationError),
    /// A name that is neither a parameter nor a state component.
    #[error("the system has no parameter or state variable `{name}`: it has {}", known.join(", "))]
    Unknown {
        /// The requested name.
        name: String,
        /// The available names.
        known: Vec<String>,
    },
    /// A name that is requested twice.
    #[error("{0} is given twice: give it once")]
    Twice(String),
    /// A force that jumps: derivatives jump too, by an amount that these equations do not contain.
    #[error(
        "a force jumps where {0} is zero, and so do the derivatives of the motion, which are not computed there"
    )]
    Jump(String),
}

impl Sensitivities {
    /// The derivatives with respect to parameters, whose values are given only here, and
    /// with respect to initial values, which have the names of the state components.
    ///
    /// # Errors
    /// A name that is neither or occurs twice; values that are not allowed; a force that jumps, as sign(x) does.
    pub fn new(
        equation: &Equation,
        values: &[(&str, Expression)],
        to: &[&str],
    ) -> Result<Self, SensitivityError> {
        if let Some(argument) = jump(&equation.with(values)?) {
            return Err(SensitivityError::Jump(argument));
        }
        let layout = StateLayout::new(equation);
        let state_names = layout.symbols(equation.variables());
        let state_names: Vec<String> = state_names.iter().map(ToString::to_string).collect();
        let parameters: Vec<String> = equation.parameters().into_iter().collect();
        if let Some(twice) =
            to.iter().enumerate().find_map(|(n, name)| to[..n].contains(name).then_some(name))
        {
            return Err(SensitivityError::Twice((*twice).to_owned()));
        }
        let names: Vec<String> = [&parameters[..], &state_names].concat();
        if let Some(name) = to.iter().find(|name| names.iter().all(|listed| listed != *name)) {
            return Err(SensitivityError::Unknown { name: (*name).to_owned(), known: names });
        }
        let (by_parameters, by_start): (Vec<&str>, Vec<&str>) =
            to.iter().partition(|name| parameters.iter().any(|other| other == *name));
        let copies: Vec<&str> = [&by_parameters[..], &by_start].concat();
        let origin = |name: &&str| {
            let initial = state_names.iter().position(|component| component == name);
            let copy = 1 + copies.iter().position(|other| other == name).unwrap_or(0);
            let name = if initial.is_some() { format!("{name}(0)") } else { (*name).to_owned() };
            Origin { name, copy, initial }
        };
        let origins = to.iter().map(origin).collect();
        let with_all = with_sensitivities(equation, &by_parameters, by_start.len());
        let left = with_all.parameters();
        let values: Vec<_> = values.iter().filter(|(name, _)| left.contains(*name)).cloned().collect();
        let equation = with_all.with(&values)?;
        let all = StateLayout::new(&equation);
        Ok(Self { equation, layout, all, state_names, origins })
    }

    /// The equations of motion and derivatives.
    #[must_use]
    pub fn equation(&self) -> &Equation {
        &self.equation
    }

    /// The names of the derivatives, `dx/dc` and `dx/dx(0)`: of each state component with respect to the first requested name, then with respect to
    /// the next.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let of_origin = |origin: &Origin| {
            let name = |number: &String| format!("d{number}/d{}", origin.name);
            self.state_names.iter().map(name).collect::<Vec<_>>()
        };
        self.origins.iter().flat_map(of_origin).collect()
    }

    /// The combined state at the beginning of a motion, at the time zero.
    #[must_use]
    pub fn start(&self, state: &[f64]) -> crate::taylor::Moment {
        let mut all = vec![0.0; self.all.numbers()];
        for (number, value) in state.iter().enumerate() {
            all[self.index(0, number)] = *value;
        }
        for origin in &self.origins {
            if let Some(number) = origin.initial {
                all[self.index(origin.copy, number)] = 1.0;
            }
        }
        crate::taylor::Moment { time: 0.0, state: all }
    }

    /// The state of the motion, taken from a combined state.
    #[must_use]
    pub fn state_in(&self, all: &[f64]) -> Vec<f64> {
        self.copy_in(all, 0).collect()
    }

    /// The derivatives in a combined state, in the order of [`Self::names`].
    #[must_use]
    pub fn derivatives_in(&self, all: &[f64]) -> Vec<f64> {
        self.origins.iter().flat_map(|origin| self.copy_in(all, origin.copy)).collect()
    }

    fn copy_in<'a>(&'a self, all: &'a [f64], copy: usize) -> impl Iterator<Item = f64> + 'a {
        (0..self.layout.numbers()).map(move |number| all[self.index(copy, number)])
    }

    /// The index of a state component in a copy of the state.
    pub(in crate::taylor) fn index(&self, copy: usize, number: usize) -> usize {
        let first = copy * self.layout.coordinates();
        match self.layout.driving(number).filter(|_| self.layout.is_velocity(number)) {
            Some(coordinate) => self.all.driven(first + coordinate),
            None => first + number,
        }
    }
}

/// The argument at whose zero a force jumps.
fn jump(equation: &Equation) -> Option<String> {
    let mut moduli = Moduli::default();
    let formulas: Vec<Expression> =
        equation.derivatives().iter().map(|formula| moduli.taken_out(formula)).collect();
    formulas.iter().find_map(|formula| moduli.jump_in(formula))
}
