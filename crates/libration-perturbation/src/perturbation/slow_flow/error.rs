//! Errors of slow flows.

use libration_motion::oscillator::{OscillatorError, Remedy};
use libration_numbers::expression::EquationError;

/// The reason why the amplitude and the phase of a weakly damped oscillator are not expanded.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SlowFlowError {
    /// An order out of range.
    #[error("order {0} is out of range: give 1 to {MAX_SLOW_ORDER}")]
    Order(usize),
    /// An order in the small parameter out of range.
    #[error("damping order {0} is out of range: give 1 to {MAX_PARAMETER_ORDER}")]
    ParameterOrder(usize),
    /// An equation that is not understood.
    #[error(transparent)]
    Equation(#[from] EquationError),
    /// No letter is left.
    #[error(
        "no parameter is symbolic: leave the one without a value that multiplies the small terms, such as c in x'' + c*x' + x = 0"
    )]
    NoSmallParameter,
    /// Several symbols, none of which is named as small.
    #[error("{} have no value: name the small one, and give the others a value", open.join(", "))]
    WhichIsSmall {
        /// The names of the symbols.
        open: Vec<String>,
    },
    /// Letters other than the small one.
    #[error("no value is given for {}: only the small parameter stays symbolic", names.join(", "))]
    WithoutValue {
        /// The names of the symbols.
        names: Vec<String>,
    },
    /// A name that is not a letter without a value.
    #[error("`{name}` is not a symbolic parameter of the equation: these are {}", open.join(", "))]
    UnknownParameter {
        /// The name.
        name: String,
        /// The letters.
        open: Vec<String>,
    },
    /// The time itself in the equation.
    #[error("the acceleration depends on t: leave the driving out")]
    DependsOnTime,
    /// No oscillator is left at zero.
    #[error("at {parameter} = 0 there must be oscillations without damping: {error}")]
    Oscillator {
        /// The small parameter.
        parameter: String,
        /// The reason why there is no oscillator.
        error: Box<OscillatorError>,
    },
    /// An equilibrium or a frequency that is not a number of the ring.
    #[error(
        "at {parameter} = 0 the equilibrium is {equilibrium} and omega0^2 is {omega0_squared}: both must be fractions; \
         choose parameters so that they are"
    )]
    NotRational {
        /// The small parameter.
        parameter: String,
        /// The equilibrium.
        equilibrium: String,
        /// ω0².
        omega0_squared: String,
    },
    /// Kinks in the velocity without the symmetry that puts both half swings on the same footing.
    #[error(
        "averaging a force with abs or sign of the velocity needs an acceleration that changes its sign with displacement and velocity, \
         which is not proved here"
    )]
    KinkedAndAsymmetric,
    /// The amplitude cannot mean this.
    #[error("the gauge {0} has no meaning here: give x_max or, where the force has no kinks, fundamental")]
    Gauge(String),
    /// No power series.
    #[error(
        "the acceleration has no power series in displacement and velocity with fractions, surds and powers of pi: powers of the velocity must be \
         whole, and forces without kinks but for abs(x') and sign(x')"
    )]
    NoSeries,
    /// The call was cancelled.
    #[error("interrupted")]
    Interrupted,
}

impl SlowFlowError {
    /// The computations that have a result for such an equation.
    #[must_use]
    pub fn remedies(&self) -> Vec<Remedy> {
        match self {
            Self::DependsOnTime | Self::KinkedAndAsymmetric => vec![Remedy::Simulation],
            Self::Oscillator { error, .. } => error.remedies(),
            _ => vec![],
        }
    }
}

/// The highest order in the amplitude.
pub const MAX_SLOW_ORDER: usize = 60;

/// The highest order in the small parameter.
pub const MAX_PARAMETER_ORDER: usize = 20;
