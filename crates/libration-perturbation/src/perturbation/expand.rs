//! The expansion of an oscillator: exact where its numbers are exact, otherwise in floating point.

use super::approximate::{Approximated, approximate_series, centre, limit_cycle};
use super::certificate::{
    agrees_with_plain_rationals, agrees_with_the_first_integral, agrees_with_the_potential,
};
use super::expansion::{Certificate, Expansion, ExpansionVariable, Heading, Precision};
use super::gauge::Gauge;
use super::model::{Model, Motion, values_at};
use super::modular::{Unsolved, exact_series};
use super::selection::{Attracting, SelectionCondition};
use super::series_set::SeriesSet;
use super::shape::{Shape, shape_of};
use super::two_sided::{AGREEING_PRECISION, MAX_PI_ORDER, TwoSided, agree};
use libration_motion::oscillator::{Kind, Oscillator, Remedy};
use libration_numbers::algebra::{BigFloat, LaurentPolynomial, Rational, Rationals};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Progress, Stage};
use libration_numbers::{
    expression::{Expression, Symbol, WithoutValue},
    internals::expression::Tape,
};

/// The highest order of an expansion.
pub const MAX_ORDER: usize = 1000;

/// Highest order to which all coefficients are computed again in plain rational arithmetic.
const PLAIN_ORDER: usize = 15;

/// Highest order to which the first integral of velocity-dependent oscillators is used; where no powers vanish it takes ten times as long.
const fn first_integral_order(kind: &Kind) -> usize {
    if matches!(kind, Kind::Mirrored) { 41 } else { 61 }
}

/// The exact expansion of the periodic motions of an oscillator.
///
/// About a centre: x to εᴺ and Ω to εᴺ⁻¹ in the gauge requested. Of a limit cycle: both to μᴺ in the strength μ of
/// the self-excitation; the gauge has no meaning there and must be the default one. Where the equilibrium or another
/// number is not rational the coefficients are floats of 40 digits, and [`Expansion::precision`] says so.
///
/// Cost: about N³ machine operations for each prime, eight of them at once, and about N/3 primes. On one core the pendulum to
/// order 31 takes milliseconds, to order 101 some tens of them.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::oscillator::Oscillator;
/// use libration::perturbation::{Gauge, expand};
/// use libration::progress::Quiet;
/// let pendulum = Oscillator::new(&"x'' = -sin(x)".parse()?)?;
/// let expansion = expand(&pendulum, 5, &Gauge::Fundamental, &Quiet)?;
/// assert_eq!(expansion.frequency_ratio[4].to_string(), "1/1024");
/// assert_eq!(expansion.of_amplitude.unwrap().period_ratio[4].to_string(), "11/3072");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// An order out of range, a gauge that the oscillator does not have, a limit cycle whose amplitude is not
/// determined, and [`ExpansionError::Contradiction`] should two roads disagree.
/// [`ExpansionError::Interrupted`], with the orders that are certain, if the call is cancelled.
///
/// # References
/// A. H. Nayfeh, D. T. Mook, *Nonlinear Oscillations*, Wiley 1979, section 2.3.1; B. Black, V. Vel, Am. J. Phys. 91,
/// 776 (2023), doi:10.1119/5.0130943, for the gauge.
pub fn expand(
    oscillator: &Oscillator,
    order: usize,
    gauge: &Gauge,
    progress: &dyn Progress,
) -> Result<Expansion, ExpansionError> {
    let watch = &Watch::new(progress);
    if !(1..=MAX_ORDER).contains(&order) {
        return Err(ExpansionError::Order(order));
    }
    let question = SeriesProblem::new(oscillator, order, gauge)?;
    match question.exact_model()? {
        Some(model) => question.solve_exactly(&model, watch),
        None => question.solve_in_digits(watch),
    }
}

/// The exact expansion of an oscillator with one power series above the equilibrium and another below ([`Kind::TwoSided`]), whose
/// coefficients are fractions and powers of the letter π; [`expand`] gives the same in digits. There are infinitely many harmonics, of which
/// those up to the order are given. `None` for other oscillators, where a number is not rational, and above order 15, where coefficients have
/// thousands of terms.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::oscillator::Oscillator;
/// use libration::perturbation::{Gauge, expand_with_pi};
/// use libration::progress::Quiet;
/// let oscillator = Oscillator::new(&"x'' + x + x*abs(x) = 0".parse()?)?;
/// let expansion = expand_with_pi(&oscillator, 3, &Gauge::XMax, &Quiet)?.ok_or("not two-sided")?;
/// assert_eq!(expansion.frequency_ratio[1].to_string(), "4/(3*pi)");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`expand`].
pub fn expand_with_pi(
    oscillator: &Oscillator,
    order: usize,
    gauge: &Gauge,
    progress: &dyn Progress,
) -> Result<Option<Expansion<LaurentPolynomial>>, ExpansionError> {
    let watch = &Watch::new(progress);
    if !(1..=MAX_ORDER).contains(&order) {
        return Err(ExpansionError::Order(order));
    }
    check_gauge(gauge, oscillator.kind(), oscillator)?;
    let two_sided = TwoSided::new(oscillator, order, gauge).filter(|_| order <= MAX_PI_ORDER);
    let Some((question, set)) =
        two_sided.and_then(|two_sided| two_sided.with_pi().map(|set| (two_sided, set)))
    else {
        return Ok(None);
    };
    let pi = BigFloat::pi(AGREEING_PRECISION);
    match question.in_digits(watch) {
        _ if watch.is_stopped() => Err(interrupted(None)),
        Some((digits, ..)) if !agree(&set.numbers(), &[pi], &digits.numbers()) => {
            Err(ExpansionError::Contradiction)
        }
        Some(_) => Ok(Some(question.expansion(set, Certificate::Quadrature))),
        None => Ok(Some(question.expansion(set, Certificate::Unchecked))),
    }
}

/// Returns `true` if the coefficients of [`expand`] are fractions.
pub(super) fn is_rational(
    oscillator: &Oscillator,
    order: usize,
    gauge: &Gauge,
) -> Result<bool, ExpansionError> {
    Ok(SeriesProblem::new(oscillator, order, gauge)?.exact_model()?.is_some())
}

/// An oscillator and the expansion requested.
struct SeriesProblem<'a> {
    oscillator: &'a Oscillator,
    order: usize,
    gauge: &'a Gauge,
    /// The acceleration counted from the equilibrium of a limit cycle, from zero else.
    acceleration: Expression,
    tape: Tape,
}

impl<'a> SeriesProblem<'a> {
    fn new(oscillator: &'a Oscillator, order: usize, gauge: &'a Gauge) -> Result<Self, ExpansionError> {
        let x = Symbol { name: oscillator.variable().to_owned(), primes: 0 };
        let mut inputs = vec![x.clone(), Symbol { primes: 1, ..x.clone() }];
        let mut acceleration = oscillator.acceleration().clone();
        match oscillator.kind() {
            Kind::LimitCycle { parameter } => {
                if *gauge != Gauge::Fundamental {
                    return Err(ExpansionError::GaugeOfLimitCycle(gauge.to_string()));
                }
                inputs.push(Symbol { name: parameter.clone(), primes: 0 });
                acceleration = counted_from(&acceleration, &x, oscillator.equilibrium().exact());
            }
            kind => check_gauge(gauge, kind, oscillator)?,
        }
        let tape = Tape::new(&[&acceleration], &inputs)?;
        Ok(Self { oscillator, order, gauge, acceleration, tape })
    }

    /// The model in fractions; `None` when one of its numbers is not rational.
    fn exact_model(&self) -> Result<Option<Model<Rational>>, ExpansionError> {
        let Some(omega0_squared) = self.oscillator.omega0_squared().exact() else { return Ok(None) };
        let (motion, values) = match self.oscillator.kind() {
            Kind::LimitCycle { .. } => {
                let Some(omega0) = omega0_squared.square_root() else { return Ok(None) };
                match self.selected_cycle(&omega0)? {
                    Some(motion) => (motion, vec![]),
                    None => return Ok(None),
                }
            }
            Kind::TwoSided => return Ok(None),
            // Even harmonics of mirrored motions are in proportion to ω0.
            Kind::Mirrored if omega0_squared.square_root().is_none() => return Ok(None),
            _ => {
                let Some(at) = self.oscillator.equilibrium().exact() else { return Ok(None) };
                let Some(values) = values_at(&Rationals, &self.tape, at.clone()) else { return Ok(None) };
                (self.centre(), values)
            }
        };
        Ok(Some(Model {
            tape: self.tape.clone(),
            values,
            omega0_squared: omega0_squared.clone(),
            uses_velocity: *self.oscillator.kind() != Kind::Conservative,
            motion,
            order: self.order,
        }))
    }

    fn shape(&self) -> Shape {
        shape_of(self.oscillator.kind(), self.oscillator.is_odd())
    }

    fn centre<N>(&self) -> Motion<N> {
        Motion::Centre { gauge: self.gauge.clone(), shape: self.shape() }
    }

    /// The condition on the amplitude, when it has rational coefficients.
    fn condition(&self, omega0: &Rational) -> Result<Option<SelectionCondition>, ExpansionError> {
        Ok(SelectionCondition::new(&self.tape, omega0, self.degree()?, self.oscillator.is_odd()))
    }

    /// The total degree of the acceleration in x and x′.
    fn degree(&self) -> Result<usize, ExpansionError> {
        let x = Symbol { name: self.oscillator.variable().to_owned(), primes: 0 };
        let velocity = Symbol { primes: 1, ..x.clone() };
        let degree = self.acceleration.polynomial_degree(&[x, velocity]);
        let degree = degree.and_then(|degree| usize::try_from(degree).ok());
        degree.filter(|&degree| degree <= MAX_DEGREE).ok_or(ExpansionError::NotPolynomial)
    }

    /// The attracting limit cycle of smallest amplitude; `None` when only digits tell its amplitude.
    fn selected_cycle(&self, omega0: &Rational) -> Result<Option<Motion<Rational>>, ExpansionError> {
        let Some(condition) = self.condition(omega0)? else { return Ok(None) };
        match condition.attracting() {
            Attracting::At(square) => {
                let selected = condition.selected(&square);
                // Harmonics in units of a root are rational only for odd accelerations.
                let exact = selected.symmetric || selected.unit_squared == Rational::from(1);
                Ok(exact.then_some(Motion::LimitCycle(selected)))
            }
            Attracting::Irrational => Ok(None),
            Attracting::None { repelling } => Err(ExpansionError::NoLimitCycle { repelling }),
        }
    }

    fn solve_exactly(&self, model: &Model<Rational>, watch: &Watch<'_>) -> Result<Expansion, ExpansionError> {
        let unit_squared = match &model.motion {
            Motion::LimitCycle(selected) => selected.unit_squared.clone(),
            Motion::Centre { .. } => Rational::from(1),
        };
        let answer = |set: SeriesSet<Rational>, certificate| {
            let heading =
                Heading { order: set.order(), ..self.heading(Precision::Exact, unit_squared.clone()) };
            Expansion::new(&Rationals, heading, set, certificate)
        };
        let set = exact_series(model, watch).map_err(|unsolved| match unsolved {
            Unsolved::Interrupted(partial) => {
                interrupted(partial.map(|set| answer(*set, Certificate::FreshPrimes)))
            }
            Unsolved::NoPrimes => ExpansionError::NoPrimes,
        })?;
        watch.begin(Stage::Check, None);
        let certificate = self.certificate(model, &set, watch)?;
        let answer = answer(set, certificate);
        if watch.is_stopped() { Err(interrupted(Some(answer))) } else { Ok(answer) }
    }

    fn certificate(
        &self,
        model: &Model<Rational>,
        set: &SeriesSet<Rational>,
        watch: &Watch<'_>,
    ) -> Result<Certificate, ExpansionError> {
        let independent = match self.oscillator.kind() {
            _ if self.order <= PLAIN_ORDER => agrees_with_plain_rationals(model, set, watch)
                .map(|agrees| (Certificate::PlainRationals, agrees)),
            Kind::Conservative => agrees_with_the_potential(&Rationals, model, set, PartialEq::eq, watch)
                .map(|agrees| (Certificate::Potential, agrees)),
            kind @ (Kind::Reversible | Kind::Mirrored) if self.order <= first_integral_order(kind) => {
                agrees_with_the_first_integral(model, set, watch)
                    .map(|agrees| (Certificate::FirstIntegral, agrees))
            }
            _ => None,
        };
        match independent {
            Some((certificate, true)) => Ok(certificate),
            Some((_, false)) => Err(ExpansionError::Contradiction),
            None => Ok(Certificate::FreshPrimes),
        }
    }

    fn solve_in_digits(&self, watch: &Watch<'_>) -> Result<Expansion, ExpansionError> {
        let solved = match self.oscillator.kind() {
            Kind::LimitCycle { .. } => self.limit_cycle_in_digits(watch),
            Kind::TwoSided => TwoSided::new(self.oscillator, self.order, self.gauge)
                .and_then(|two_sided| two_sided.in_digits(watch))
                .ok_or(ExpansionError::NoDigits),
            kind => self.centre_in_digits(*kind != Kind::Conservative, watch).ok_or(ExpansionError::NoDigits),
        };
        let (set, omega0_squared, equilibrium) = match solved {
            Err(_) if watch.is_stopped() => return Err(interrupted(None)),
            solved => solved?,
        };
        let heading = self.heading(Precision::Digits(super::approximate::DIGITS), Rational::from(1));
        let oscillator = self.oscillator;
        let heading = Heading {
            order: set.order(),
            omega0_squared: oscillator.omega0_squared().exact().cloned().unwrap_or(omega0_squared),
            equilibrium: oscillator.equilibrium().exact().cloned().unwrap_or(equilibrium),
            ..heading
        };
        let answer = Expansion::new(&Rationals, heading, set, Certificate::TwoPrecisions);
        if watch.is_stopped() { Err(interrupted(Some(answer))) } else { Ok(answer) }
    }

    fn centre_in_digits(&self, uses_velocity: bool, watch: &Watch<'_>) -> Option<Approximated> {
        let near = self.oscillator.equilibrium().to_f64();
        let prepare = |floats| centre(floats, &self.tape, near, self.centre(), uses_velocity, self.order);
        approximate_series(&prepare, watch)
    }

    fn limit_cycle_in_digits(&self, watch: &Watch<'_>) -> Result<Approximated, ExpansionError> {
        let (degree, symmetric) = (self.degree()?, self.oscillator.is_odd());
        let omega0_squared = self.oscillator.omega0_squared().exact().ok_or(ExpansionError::NoDigits)?;
        let prepare = |floats| limit_cycle(floats, &self.tape, omega0_squared, degree, symmetric, self.order);
        approximate_series(&prepare, watch).ok_or(ExpansionError::NoCycleInDigits)
    }

    fn heading(&self, precision: Precision, unit_squared: Rational) -> Heading {
        let exact = |value: Option<&Rational>| value.cloned().unwrap_or_else(|| Rational::from(0));
        Heading {
            order: self.order,
            variable: match self.oscillator.kind() {
                Kind::LimitCycle { parameter } => ExpansionVariable::Parameter(parameter.clone()),
                _ => ExpansionVariable::Epsilon(self.gauge.clone()),
            },
            phase_origin: self.shape().into(),
            has_all_harmonics: *self.oscillator.kind() != Kind::TwoSided,
            precision,
            equilibrium: exact(self.oscillator.equilibrium().exact()),
            omega0_squared: exact(self.oscillator.omega0_squared().exact()),
            unit_squared,
        }
    }
}

/// The largest degree of a polynomial that is expanded about a limit cycle.
const MAX_DEGREE: usize = 64;

/// The acceleration with x measured from a position.
fn counted_from(acceleration: &Expression, x: &Symbol, shift: Option<&Rational>) -> Expression {
    match shift.filter(|origin| !origin.is_zero()) {
        None => acceleration.clone(),
        Some(origin) => {
            let shifted = Expression::Add(
                Box::new(Expression::Symbol(x.clone())),
                Box::new(Expression::Number(origin.clone())),
            );
            acceleration.substitute(x, &shifted)
        }
    }
}

fn check_gauge(gauge: &Gauge, kind: &Kind, oscillator: &Oscillator) -> Result<(), ExpansionError> {
    match gauge {
        Gauge::Energy if !matches!(kind, Kind::Conservative | Kind::TwoSided) => {
            Err(ExpansionError::EnergyOfVelocity)
        }
        Gauge::Nome if !is_pendulum(oscillator) => Err(ExpansionError::NomeOfOther),
        _ => Ok(()),
    }
}

/// Returns `true` if the acceleration is −c·sin x, with x counted from an equilibrium at zero.
pub(crate) fn is_pendulum(oscillator: &Oscillator) -> bool {
    let x = Expression::Symbol(Symbol { name: oscillator.variable().to_owned(), primes: 0 });
    let sine = Expression::Call(libration_numbers::expression::Function::Sin, Box::new(x));
    let Some(factor) = oscillator.omega0_squared().exact() else { return false };
    let expected = Expression::Multiply(Box::new(Expression::Number(factor.clone())), Box::new(sine));
    let sum = Expression::Add(Box::new(oscillator.acceleration().clone()), Box::new(expected));
    oscillator.equilibrium().exact().is_some_and(Rational::is_zero) && sum.vanishes()
}

/// The reason why there is no expansion.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ExpansionError {
    /// An order out of range.
    #[error("order {0} is out of range: give 1 to {MAX_ORDER}")]
    Order(usize),
    /// A parameter that has no value.
    #[error(transparent)]
    WithoutValue(#[from] WithoutValue),
    /// A gauge for a limit cycle.
    #[error("a limit cycle has no free amplitude, and so no gauge `{0}`: leave the gauge out")]
    GaugeOfLimitCycle(String),
    /// The energy gauge where energy is not kinetic plus potential.
    #[error(
        "the gauge `energy` needs an acceleration that does not depend on the velocity: choose another gauge"
    )]
    EnergyOfVelocity,
    /// The gauge `nome` of an oscillator that is not a pendulum.
    #[error(
        "the gauge `nome` is defined only for the pendulum x'' + omega0^2*sin(x) = 0: choose another gauge"
    )]
    NomeOfOther,
    /// A self-excitation that is not a polynomial.
    #[error(
        "a limit cycle is expanded only where the acceleration is a polynomial in position and velocity of degree {MAX_DEGREE} or less: give the parameter a value"
    )]
    NotPolynomial,
    /// No amplitude at which the self-excitation does no work.
    #[error(
        "there is no stable limit cycle at small strength: at no amplitude does the self-excitation give as much energy as it takes{}",
        apart_from(*.repelling)
    )]
    NoLimitCycle {
        /// Number of limit cycles that repel.
        repelling: usize,
    },
    /// The computation was interrupted.
    #[error("interrupted when {}", certain(known.as_deref()))]
    Interrupted {
        /// Result up to the cancellation: an expansion to a lower order, or one not yet checked by another method.
        known: Option<Box<Expansion>>,
    },
    /// No series modulo many primes, although the model is rational.
    #[error("the acceleration has no power series about the equilibrium in fractions or their roots")]
    NoPrimes,
    /// No agreement between precisions, or no series at all.
    #[error("the acceleration has no power series about the equilibrium, not even with decimal coefficients")]
    NoDigits,
    /// No limit cycle where the condition on its amplitude is known in digits only.
    #[error("no stable limit cycle at small strength was found among amplitudes from 10^-6 to 10^6")]
    NoCycleInDigits,
    /// Two independent computations disagree.
    #[error(
        "two independent computations of this expansion disagree, which must not happen: please report the equation"
    )]
    Contradiction,
}

impl ExpansionError {
    /// The computations that have a result for such an oscillator.
    #[must_use]
    pub fn remedies(&self) -> Vec<Remedy> {
        match self {
            Self::NotPolynomial => vec![Remedy::SlowFlow, Remedy::Simulation],
            Self::NoLimitCycle { .. } => vec![Remedy::SlowFlow],
            _ => vec![],
        }
    }
}

fn interrupted(partial: Option<Expansion>) -> ExpansionError {
    ExpansionError::Interrupted { known: partial.map(Box::new) }
}

fn certain(partial: Option<&Expansion>) -> String {
    partial.map_or_else(
        || "no order was confirmed".to_owned(),
        |expansion| format!("order {} was confirmed", expansion.order),
    )
}

fn apart_from(repelling: usize) -> String {
    match repelling {
        0 => String::new(),
        1 => ", except an unstable one".to_owned(),
        several => format!(", except {several} unstable ones"),
    }
}
