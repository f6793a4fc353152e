//! Periodic motions of any oscillator as power series, exact and to any order.
//!
//! About a centre the motions form a family with a parameter ε, whose meaning is free: the [`Gauge`]. [`expand`] gives
//! frequency and harmonics by powers of ε and of the amplitude. A self-excited oscillator has a limit cycle, which is
//! expanded in the strength of the excitation. [`OpenGauge`] shows the equations order by order before a gauge is
//! chosen, [`TruncatedSystem`] what becomes of them when only a few harmonics are kept, and [`SeriesEvaluation`],
//! [`Convergence`] and [`Pade`] what a series is worth at an amplitude. Under weak damping, drive or coupling amplitudes and phases change
//! slowly: [`slow_flow`](slow_flow()), with symbols for all parameters [`slow_flow_symbolically`], of several coordinates [`coupled_slow_flow`].
//!
//! ```
//! # extern crate libration_perturbation as libration;
//! use libration::oscillator::Oscillator;
//! use libration::perturbation::{Gauge, expand};
//! use libration::progress::Quiet;
//!
//! // Van der Pol: amplitude and frequency of the limit cycle in powers of the excitation.
//! let oscillator = Oscillator::new(&"x'' - mu*(1 - x^2)*x' + x = 0".parse()?)?;
//! let expansion = expand(&oscillator, 4, &Gauge::Fundamental, &Quiet)?;
//! assert_eq!(expansion.frequency_ratio[2].to_string(), "-1/16");
//! assert_eq!(expansion.frequency_ratio[4].to_string(), "17/3072");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod approximate;
#[doc(hidden)]
pub(crate) mod certificate;
mod conservative;
mod cosines;
mod evaluation;
mod expand;
mod expansion;
mod extremes;
mod first_integral;
mod gauge;
mod half_turns;
mod limit_cycle;
mod lindstedt;
#[doc(hidden)]
pub(crate) mod model;
#[doc(hidden)]
pub(crate) mod modular;
mod open_gauge;
mod phase_origin;
mod restoring_force;
mod selection;
#[doc(hidden)]
pub(crate) mod series_set;
#[doc(hidden)]
pub(crate) mod shape;
pub(crate) mod slow_flow;
mod symbolic;
mod truncated_system;
mod two_sided;

pub use evaluation::{
    Certainty, Convergence, MajorantAt, Pade, PartialSum, PeriodMajorant, Pole, Remainder, SeriesEvaluation,
    Singularity, pendulum_period_remainder,
};
pub(crate) use evaluation::{PositiveSeries, stride};
pub(crate) use expand::is_pendulum;
pub use expand::{ExpansionError, MAX_ORDER, expand, expand_with_pi};
pub use expansion::{AmplitudeSeries, Certificate, Expansion, ExpansionVariable, HarmonicSeries, Precision};
pub use gauge::{Gauge, ParseGaugeError};
pub use open_gauge::{Condition, EpsilonPowers, OpenGauge, OpenGaugeError, RestoringTerm};
pub use phase_origin::PhaseOrigin;
pub use restoring_force::restoring_force;
pub(crate) use slow_flow::FirstOrder;
pub use slow_flow::{
    AmplitudeInTime, CoordinateFlow, CoupledSlowFlow, EarlierOrder, JudgedState, LeftOutReason,
    MAX_PARAMETER_ORDER, MAX_SLOW_ORDER, MAX_SYMBOLIC_SLOW_ORDER, PhaseInTime, PhaseTerm, RateProducts,
    ResponseSteps, SlowFlow, SlowFlowAt, SlowFlowError, SlowFlowSteps, SlowLimitCycle, SlowSeries, SmallTerm,
    StateLeftOut, SteadySolution, SteadyState, SteadyStates, SymbolicSlowFlow, SymbolicSlowFlowError,
    SymbolicSlowFlowOptions, WeakForce, coupled_slow_flow, drive_symbol, next_slow_flow, slow_flow,
    slow_flow_steps, slow_flow_symbolically,
};
pub use symbolic::{SymbolicExpansion, SymbolicExpansionError, expand_symbolically, expand_with_constants};
pub use truncated_system::{SolutionVerdict, TruncatedSolution, TruncatedSystem, TruncatedSystemError};
