//! Errors of slow flows with symbolic parameters.

use libration_numbers::expression::SecondOrderError;

/// The reason why there is no slow flow with symbolic parameters.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SymbolicSlowFlowError {
    /// An order out of range.
    #[error("order {0} is out of range: give 1 to {MAX_SYMBOLIC_SLOW_ORDER}")]
    Order(usize),
    /// Several equations.
    #[error("there are {0} equations: this slow flow is that of one coordinate")]
    SeveralEquations(usize),
    /// An equation of the first order.
    #[error(transparent)]
    FirstOrder(#[from] SecondOrderError),
    /// A resonance that is not a fraction in lowest terms.
    #[error(
        "the resonance {0}/{1} is out of range: give two whole numbers from 1 to {LARGEST_RESONANCE} in lowest terms, as 1/3"
    )]
    Resonance(u32, u32),
    /// A small parameter that the equation does not have.
    #[error("`{name}` is not a symbolic parameter of the equation: these are {}", open.join(", "))]
    UnknownParameter {
        /// The name.
        name: String,
        /// The symbolic parameters.
        open: Vec<String>,
    },
    /// No small parameter.
    #[error(
        "nothing is small: name the small parameters and their orders, such as mu:1,F:1, or write eps before the small terms"
    )]
    NothingSmall,
    /// The time in the equation without a resonance.
    #[error(
        "the acceleration depends on t: name the resonance of the drive, 1/1 where its frequency is near the natural one"
    )]
    NoResonance,
    /// A resonance without drive.
    #[error("the acceleration does not depend on t: a resonance needs a drive, such as eps*F*cos(W*t)")]
    NoDrive,
    /// A time dependence other than sine and cosine.
    #[error(
        "`{0}` is not periodic in t as a sine or cosine of a constant rate: write the drive as cos(W*t) or sin(W*t)"
    )]
    Time(String),
    /// Rates that are not multiples of one frequency.
    #[error(
        "the drive has several frequencies: all must be whole multiples of one symbol or rational number"
    )]
    SeveralDrives,
    /// A rate that is neither a multiple of a symbol nor rational.
    #[error(
        "the drive frequency `{0}` is neither a whole multiple of one symbol nor a rational number: write a symbol in its place, as in cos(W*t), \
         and give its value where numbers are wanted"
    )]
    DriveFrequency(String),
    /// A formula that is not a polynomial.
    #[error(
        "`{0}` is not a polynomial in displacement, velocity and symbols: denominators must be products of symbols, possibly plus \
         terms that are small or vanish with the displacement; functions need such terms as arguments and a power series about zero; abs and \
         sign are for a displacement or velocity"
    )]
    NotPolynomial(String),
    /// A power series without end where the amplitude is not small.
    #[error(
        "a function such as sin is expanded in the displacement if the amplitude is small, but here only its factor is small: write a polynomial in its place, such as x - x^3/6"
    )]
    EndlessSeries,
    /// A force at rest.
    #[error(
        "the force at rest `{0}` is not zero: shift the displacement so that the equilibrium is at zero, or give the force an order"
    )]
    Equilibrium(String),
    /// No oscillation without the small terms.
    #[error("without the small terms there is no oscillation: ω0² is `{0}`, and must be positive")]
    NoOscillation(String),
    /// Damping, coupling or kinks that are not small.
    #[error(
        "`{0}` before the velocity, another coordinate, abs or sign is not small: give its symbol an order, such as mu:1"
    )]
    NotSmall(String),
    /// A parametric drive that is not small.
    #[error("the parametric drive `{0}` is not small: give its symbol an order, such as h:1")]
    ParametricNotSmall(String),
    /// A resonant drive that is not small.
    #[error(
        "a drive whose frequency or a harmonic of it is the natural one causes a motion without bound unless it is small: give its symbol an \
         order, such as F:1, or write eps before it"
    )]
    DriveNotSmall,
    /// Kinks at an order at which their harmonics act back.
    #[error(
        "forces with abs or sign are averaged to order {0} here, where their harmonics do not act back: give this order; with numbers for all symbols \
         but the small one, more orders are known"
    )]
    KinkOrder(usize),
    /// Kinks with several coordinates.
    #[error("forces with abs or sign are averaged for one coordinate only")]
    SeveralKinks,
    /// Ratios of natural frequencies that do not fit the coordinates.
    #[error(
        "the ratios {} of natural frequencies do not fit: give a whole number from 1 to {LARGEST_RESONANCE} for each of the {coordinates} coordinates, as 1:2",
        listed(given)
    )]
    Ratios {
        /// The ratios given.
        given: Vec<u32>,
        /// The number of coordinates.
        coordinates: usize,
    },
    /// A natural frequency whose ratio to the first is not that of small whole numbers.
    #[error(
        "the natural frequency of equation {0} is not a small whole number or a simple fraction of the first: give the ratio that it is near, as 1:2"
    )]
    UnknownRatio(usize),
    /// Kinks with a drive that is not small, or as a factor of a drive.
    #[error(
        "a force with abs or sign is averaged over sine waves only: the drive must be small, and not a factor of it"
    )]
    KinkWithDrive,
    /// Too many terms.
    #[error("the terms of order {0} are too many: give numbers for some symbols, or a lower order")]
    TooLarge(usize),
    /// The call was cancelled.
    #[error("interrupted")]
    Interrupted,
}

/// The highest order in the small parameters.
pub const MAX_SYMBOLIC_SLOW_ORDER: usize = 12;

fn listed(ratios: &[u32]) -> String {
    ratios.iter().map(u32::to_string).collect::<Vec<_>>().join(":")
}

/// The largest number in a resonance p/q.
pub(super) const LARGEST_RESONANCE: u32 = 12;
