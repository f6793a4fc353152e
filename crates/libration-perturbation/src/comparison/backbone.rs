//! The backbone of an oscillator: its frequency against the amplitude, by orbits, by the perturbation series and, for the
//! pendulum, exactly.

use super::enclosed::other_equilibrium;
use super::{ExactValue, ExactValueError, Radius, SeriesComparison, SeriesQuantity};
use crate::perturbation::{Expansion, ExpansionError, Gauge, Remainder, expand};
use libration_motion::oscillator::{Constant, Kind, Oscillator, OscillatorError, Remedy, centre_of};
use libration_motion::{
    internals::orbit::ReleasePlace,
    orbit::{Orbit, OrbitError},
};
use libration_numbers::algebra::BigFloat;
use libration_numbers::expression::{Equation, Expression, SecondOrderError};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;
use libration_numbers::quantity::Displacement;

/// The amplitude–frequency curve of one coordinate.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::comparison::Backbone;
/// use libration::progress::Quiet;
/// let duffing = Backbone::new(&"x'' + x + x^3 = 0".parse()?, None, 15, &Quiet)?;
/// let point = duffing.at(0.5, &Quiet);
/// let (orbit, series) = (point.orbit?, point.series.ok_or("no series")?);
/// assert!((orbit.frequency - series.frequency).abs() < 1e-6);
/// // A force without a linear part has orbits, but no series.
/// assert!(Backbone::new(&"x'' = -x^3".parse()?, None, 15, &Quiet)?.at(2.0, &Quiet).series.is_none());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Backbone {
    equation: Equation,
    centre: Option<Constant>,
    series: Result<Series, SeriesError>,
}

/// An oscillator with its expansion.
#[derive(Clone, Debug)]
struct Series {
    oscillator: Oscillator,
    expansion: Expansion,
}

/// The reason why there is no perturbation series to compare with the orbits.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SeriesError {
    /// No centre to expand about.
    #[error(transparent)]
    Oscillator(#[from] OscillatorError),
    /// No expansion.
    #[error(transparent)]
    Expansion(#[from] ExpansionError),
}

/// The reason why there is no amplitude–frequency curve.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BackboneError {
    /// Several coordinates.
    #[error("there are {0} coordinates: give one equation of motion")]
    SeveralCoordinates(usize),
    /// An equation of the first order.
    #[error(transparent)]
    NotSecondOrder(#[from] SecondOrderError),
    /// The time in the force.
    #[error("the acceleration depends on t: set the strength of the driving to zero")]
    DependsOnTime,
    /// Parameters that have no value.
    #[error("no value is given for {0}: give one, such as {0}=0.1")]
    WithoutValue(String),
    /// A limit cycle instead of a family.
    #[error(
        "the motion settles on a limit cycle, whose frequency depends on the strength {0} and not on an amplitude: expand it in {0} instead"
    )]
    LimitCycle(String),
    /// The given position is not an equilibrium.
    #[error(transparent)]
    About(OscillatorError),
}

impl BackboneError {
    /// The computations that have a result for such an equation.
    #[must_use]
    pub fn remedies(&self) -> Vec<Remedy> {
        match self {
            Self::SeveralCoordinates(_) => vec![Remedy::NormalModes],
            Self::LimitCycle(_) => vec![Remedy::Expansion],
            Self::About(error) => error.remedies(),
            _ => vec![],
        }
    }
}

/// The frequencies at one amplitude, in radians a unit of time.
#[derive(Clone, Debug, PartialEq)]
pub struct BackbonePoint {
    /// The largest displacement above the centre.
    pub amplitude: f64,
    /// Frequency of the periodic orbit, or the reason why there is none.
    pub orbit: Result<OrbitFrequency, OrbitError>,
    /// Frequency from the perturbation series, where there is one.
    pub series: Option<SeriesFrequency>,
    /// Frequency from elliptic integrals, or the reason why there is none; `None` for all oscillators but the pendulum.
    pub exact: Option<Result<ExactValue, ExactValueError>>,
}

/// The frequency of an orbit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitFrequency {
    /// 2π over the period.
    pub frequency: f64,
    /// Bound on the error of the frequency.
    pub uncertainty: f64,
    /// The displacement from the centre at the other turning point.
    pub other_side: f64,
    /// Another equilibrium that the orbit encloses, if there is one: the orbit is then not of the family of the series.
    pub encloses: Option<f64>,
}

/// The frequency of a series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeriesFrequency {
    /// The sum of all terms.
    pub frequency: f64,
    /// Bound or estimate of the omitted terms, in the same unit.
    pub remainder: Remainder,
}

impl Backbone {
    /// The curve about the stable equilibrium nearest to zero, or about a place that is given, with the series up to an order.
    /// Where an equilibrium has no expansion there are only orbits; where none is found amplitudes count from zero.
    ///
    /// A cancelled call returns a backbone without series ([`ExpansionError::Interrupted`]), whose orbits can still be computed.
    ///
    /// # Errors
    /// Several coordinates, the time in the acceleration, open parameters, or no stable equilibrium at the place.
    pub fn new(
        equation: &Equation,
        about: Option<&Expression>,
        order: usize,
        progress: &dyn Progress,
    ) -> Result<Self, BackboneError> {
        if equation.variables().len() != 1 {
            return Err(BackboneError::SeveralCoordinates(equation.variables().len()));
        }
        equation.refuse_first_order()?;
        if equation.depends_on_time() {
            return Err(BackboneError::DependsOnTime);
        }
        let oscillator = match about {
            None => Oscillator::new(equation),
            Some(equilibrium) => Oscillator::about(equation, equilibrium),
        };
        if let Some(open) = equation.parameters().into_iter().next() {
            let cycle = matches!(oscillator.as_ref().map(Oscillator::kind), Ok(Kind::LimitCycle { .. }));
            return Err(if cycle {
                BackboneError::LimitCycle(open)
            } else {
                BackboneError::WithoutValue(open)
            });
        }
        let centre = match &oscillator {
            Ok(oscillator) => Some(oscillator.equilibrium().clone()),
            Err(_) => centre_of(equation, about),
        };
        let oscillator = match oscillator {
            Err(error) if about.is_some() && centre.is_none() => return Err(BackboneError::About(error)),
            oscillator => oscillator,
        };
        let series = oscillator.map_err(SeriesError::from).and_then(|oscillator| {
            let expansion = expand(&oscillator, order, &Gauge::Fundamental, progress)?;
            Ok(Series { oscillator, expansion })
        });
        Ok(Self { equation: equation.clone(), centre, series })
    }

    /// The position from which amplitudes are measured.
    #[must_use]
    pub fn centre(&self) -> f64 {
        self.centre.as_ref().map_or(0.0, Constant::to_f64)
    }

    /// Returns `true` if the centre is an equilibrium; `false` if it is zero because there is none.
    #[must_use]
    pub const fn has_equilibrium(&self) -> bool {
        self.centre.is_some()
    }

    /// The frequency of small oscillations, where they are harmonic.
    #[must_use]
    pub fn omega0(&self) -> Option<f64> {
        let series = self.series.as_ref().ok()?;
        Some(libm::sqrt(series.oscillator.omega0_squared().to_f64()))
    }

    /// The reason why there is no series; `None` when there is one.
    #[must_use]
    pub fn no_series(&self) -> Option<&SeriesError> {
        self.series.as_ref().err()
    }

    /// The amplitude up to which the series converges, where that is known or can be estimated.
    #[must_use]
    pub fn radius(&self) -> Option<Radius> {
        self.series.as_ref().ok().and_then(|series| series.relation().radius())
    }

    /// All frequencies at an amplitude, exactly this `f64`.
    ///
    /// The point has no orbit ([`OrbitError::Interrupted`]) if the call is cancelled.
    #[must_use]
    pub fn at(&self, amplitude: f64, progress: &dyn Progress) -> BackbonePoint {
        match Displacement::from_f64(amplitude) {
            Some(displacement) => self.at_displacement(&displacement, progress),
            None => BackbonePoint {
                amplitude,
                orbit: Err(OrbitError::Start { state: vec![amplitude], wanted: 1 }),
                series: None,
                exact: None,
            },
        }
    }

    /// All frequencies at an amplitude that is known to more digits than an `f64` has.
    #[must_use]
    pub fn at_displacement(&self, displacement: &Displacement, progress: &dyn Progress) -> BackbonePoint {
        self.point(displacement, 0.0, progress)
    }

    /// The frequencies for a line in a picture: the frequency of the orbit may have a relative error of 10⁻⁶.
    #[must_use]
    pub fn drawn_at(&self, displacement: &Displacement, progress: &dyn Progress) -> BackbonePoint {
        /// Less than a line's width in the largest picture.
        const DRAWN: f64 = 1e-6;
        self.point(displacement, DRAWN, progress)
    }

    fn point(&self, displacement: &Displacement, tolerance: f64, progress: &dyn Progress) -> BackbonePoint {
        let amplitude = displacement.to_f64();
        let orbit = self.orbit_at(displacement, tolerance, &Watch::new(progress));
        let (mut series, mut exact) = (None, None);
        if let (Ok(relation), Some(omega0)) = (&self.series, self.omega0()) {
            series = relation.frequency_at(amplitude, omega0);
            exact = relation
                .exact_at(displacement)
                .map(|value| value.map(|frequency| in_units_of(frequency, omega0)));
        }
        BackbonePoint { amplitude, orbit, series, exact }
    }

    fn orbit_at(
        &self,
        displacement: &Displacement,
        tolerance: f64,
        watch: &Watch<'_>,
    ) -> Result<OrbitFrequency, OrbitError> {
        let origin = self.centre.as_ref().map_or_else(|| BigFloat::from_integer(0, 1), Constant::digits);
        let centre = self.centre();
        let start = centre + displacement.to_f64();
        let release = ReleasePlace::new(origin, displacement.clone());
        let orbit = Orbit::released_from(&self.equation, &release, tolerance, watch)?;
        let other_side = orbit.state_at(0.5 * orbit.period())[0];
        if self.has_equilibrium() && other_side >= centre {
            return Err(OrbitError::Elsewhere { start, other_side, centre });
        }
        let enclosed = || other_equilibrium(&self.equation, centre, [other_side, start]);
        Ok(OrbitFrequency {
            frequency: orbit.frequency(),
            uncertainty: orbit.frequency() * (orbit.period_uncertainty() / orbit.period() + ROUNDINGS),
            other_side: other_side - centre,
            encloses: if self.has_equilibrium() { enclosed() } else { None },
        })
    }
}

impl Series {
    fn relation(&self) -> SeriesComparison<'_> {
        SeriesComparison::new(&self.oscillator, &self.expansion, SeriesQuantity::Frequency)
    }

    fn frequency_at(&self, amplitude: f64, omega0: f64) -> Option<SeriesFrequency> {
        let evaluation = self.relation().evaluation_at(amplitude);
        let Remainder { size, certainty } = evaluation.steps().last()?.remainder;
        let remainder = Remainder { size: size * omega0, certainty };
        Some(SeriesFrequency { frequency: evaluation.value() * omega0, remainder })
    }

    /// Ω/ω0 of the pendulum.
    fn exact_at(&self, displacement: &Displacement) -> Option<Result<ExactValue, ExactValueError>> {
        self.relation().exact_without_motion(displacement)
    }
}

/// Relative rounding error of 2π divided by a period.
const ROUNDINGS: f64 = 2.0 * f64::EPSILON;

/// A ratio as a frequency; ω0 and the product are rounded.
fn in_units_of(ratio: ExactValue, omega0: f64) -> ExactValue {
    let value = ratio.value * omega0;
    ExactValue { value, uncertainty: ratio.uncertainty * omega0 + ROUNDINGS * value, ..ratio }
}
