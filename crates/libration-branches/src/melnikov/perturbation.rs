//! An equation of motion as a pendulum with a perturbation.

use super::MelnikovError;
use super::trigonometric::{Monomial, Names, Trigonometric};
use libration_kernels::elementary::count;
use libration_motion::{chaos::drive_period, internals::chaos::WrittenDrive};
use libration_numbers::algebra::{Complex, Doubles};
use libration_numbers::{
    expression::{Equation, Expression, Symbol},
    internals::{
        algebra::fourier,
        expression::{Jet, Tape},
    },
};
use std::f64::consts::TAU;

/// Number of phases of the drive at which a function that is not a trigonometric polynomial is evaluated.
const PHASES: usize = 64;
/// Number of harmonics taken from these phases; the harmonics above measure the truncation error.
const HARMONICS: usize = 24;

/// θ″ = −ω0²·sin θ + g(θ, θ′, t), where g has the period of the drive and θ is counted from the place at which the pendulum hangs.
///
/// # Examples
/// ```
/// # extern crate libration_branches as libration;
/// use libration::melnikov::PerturbedPendulum;
/// let driven = PerturbedPendulum::new(&"x'' + 0.1 x' + 4 sin(x) = 0.3 cos(t)".parse()?)?;
/// assert_eq!((driven.omega0(), driven.frequency()), (2.0, Some(1.0)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct PerturbedPendulum {
    omega0: f64,
    /// Ω, zero without a drive.
    frequency: f64,
    centre: f64,
    pub(super) closed: Trigonometric,
    /// Part of the perturbation that is not a polynomial in θ′, sin θ, cos θ and waves.
    pub(super) rest: Option<Tape>,
    rest_depends_on_time: bool,
}

impl PerturbedPendulum {
    /// Separates an equation; everything in the acceleration except −ω0²·sin(x − c) is the perturbation, with the angle c = [`centre`](Self::centre).
    ///
    /// # Errors
    /// Several coordinates, an equation of first order, symbolic parameters; neither the sine nor the cosine of the angle alone; a force of the
    /// angle alone that is not periodic in it; a drive that is not periodic.
    pub fn new(equation: &Equation) -> Result<Self, MelnikovError> {
        Self::separated(equation, true)
    }

    /// Separates an equation, whose angle may be counted from another place than that at which the pendulum hangs.
    fn separated(equation: &Equation, may_hang_elsewhere: bool) -> Result<Self, MelnikovError> {
        equation.refuse_first_order()?;
        let [name] = equation.variables() else {
            return Err(MelnikovError::Coordinates(equation.variables().len()));
        };
        if let Some(open) = equation.parameters().pop_first() {
            return Err(MelnikovError::Open(open));
        }
        let acceleration = &equation.accelerations()[0];
        let time = Symbol::plain("t");
        let frequency = match (acceleration.contains(&time), drive_period(equation)) {
            (false, _) => 0.0,
            (true, Some(period)) => TAU / period,
            (true, None) => return Err(MelnikovError::NotPeriodic),
        };
        let angle = Symbol::plain(name);
        // In cos(Ωt/2)² the closed form is that of the harmonics of Ω/2.
        let parts = WrittenDrive::of(equation).map_or(1, |drive| drive.repetitions);
        let written = frequency / f64::from(parts);
        let names = Names { velocity: angle.with_primes(1), angle, time, frequency: written };
        let (closed, rest) = separated(acceleration, &names);
        let (mut closed, frequency) = match closed.every(parts) {
            Some(closed) => (closed, frequency),
            None => (closed, written),
        };
        if let Some(centre) = centre(&closed).filter(|_| may_hang_elsewhere) {
            return Ok(Self { centre, ..Self::separated(&from_place(equation, centre)?, false)? });
        }
        let omega0 = own_frequency(&mut closed)?;
        let moving = |part: &Expression| part.contains(&names.velocity) || part.contains(&names.time);
        if let Some(alone) = rest.iter().find(|part| !moving(part)) {
            return Err(MelnikovError::NoAngle(alone.to_string()));
        }
        let rest_depends_on_time = rest.iter().any(|part| part.contains(&names.time));
        let sum = rest.into_iter().reduce(|a, b| Expression::Add(Box::new(a), Box::new(b)));
        let inputs = [names.angle, names.velocity, names.time];
        let rest = sum.map(|sum| Tape::new(&[&sum], &inputs)).transpose()?;
        Ok(Self { omega0, frequency, centre: 0.0, closed, rest, rest_depends_on_time })
    }

    /// The angle at which the unperturbed pendulum hangs, in radians, from which its angles are counted.
    #[must_use]
    pub const fn centre(&self) -> f64 {
        self.centre
    }

    /// The equation with its angle counted from the centre.
    pub(super) fn hanging_at_zero(&self, equation: &Equation) -> Result<Equation, MelnikovError> {
        from_place(equation, self.centre)
    }

    /// ω0 in rad/s.
    #[must_use]
    pub const fn omega0(&self) -> f64 {
        self.omega0
    }

    /// The angular frequency of the drive in rad/s, for the period in which the whole drive repeats.
    #[must_use]
    pub fn frequency(&self) -> Option<f64> {
        (self.frequency > 0.0).then_some(self.frequency)
    }

    /// Returns `true` if the integrals over the separatrix have a closed form, by residues.
    #[must_use]
    pub const fn is_closed(&self) -> bool {
        self.rest.is_none()
    }

    /// The highest harmonic of the drive that can occur.
    pub(super) fn harmonics(&self) -> usize {
        let closed = self.closed.terms.keys().map(|key| key.harmonic.unsigned_abs() as usize).max();
        closed.unwrap_or(0).max(if self.rest_depends_on_time { HARMONICS } else { 0 })
    }

    /// The coefficients of e^{ikΩt} in the perturbation at an angle and a velocity, from k = 0 on, and the magnitude of the omitted ones.
    pub(super) fn harmonics_at(&self, angle: f64, velocity: f64) -> (Vec<Complex>, f64) {
        let mut coefficients = vec![Complex::default(); self.harmonics() + 1];
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        for (monomial, coefficient) in &self.closed.terms {
            if let Ok(k) = usize::try_from(monomial.harmonic) {
                let size = power(velocity, monomial.velocity)
                    * power(sine, monomial.sines)
                    * power(cosine, monomial.cosines);
                coefficients[k] = coefficients[k] + coefficient.scaled(size);
            }
        }
        let left =
            self.rest.as_ref().map_or(0.0, |tape| self.add_rest(tape, [angle, velocity], &mut coefficients));
        (coefficients, left)
    }

    fn add_rest(&self, tape: &Tape, [angle, velocity]: [f64; 2], coefficients: &mut [Complex]) -> f64 {
        let mut jet = Jet::new(&Doubles, tape, &[angle, velocity, 0.0]);
        let mut at = |time: f64| {
            let Ok(jet) = &mut jet else { return f64::NAN };
            jet.restart(&[angle, velocity, time]).map_or(f64::NAN, |()| jet.result(0)[0])
        };
        if !self.rest_depends_on_time {
            coefficients[0] = coefficients[0] + at(0.0).into();
            return 0.0;
        }
        let sample = |j: usize| at(count(j) / count(PHASES) * TAU / self.frequency).into();
        let sums = fourier(&(0..PHASES).map(sample).collect::<Vec<Complex>>());
        let resolved = sums.into_iter().map(|sum| sum.scaled(1.0 / count(PHASES))).take(PHASES / 2 + 1);
        let resolved: Vec<Complex> = resolved.collect();
        let (kept, omitted) = resolved.split_at(HARMONICS + 1);
        for (amplitude, part) in coefficients.iter_mut().zip(kept) {
            *amplitude = *amplitude + *part;
        }
        omitted.iter().map(|part| part.abs()).fold(0.0, f64::max)
    }
}

/// The acceleration as a trigonometric polynomial, and the remaining terms.
fn separated(acceleration: &Expression, names: &Names) -> (Trigonometric, Vec<Expression>) {
    let mut terms = vec![];
    collect_terms(acceleration, &|term| term, &mut terms);
    let mut closed = Trigonometric::default();
    let mut rest = vec![];
    for term in terms {
        match Trigonometric::from_tree(&term, names) {
            Some(sum) => closed = closed.plus(&sum),
            None => rest.push(term),
        }
    }
    (closed, rest)
}

/// The terms of a sum, each with the constant factors and divisors of the sum.
fn collect_terms(
    formula: &Expression,
    within: &dyn Fn(Expression) -> Expression,
    terms: &mut Vec<Expression>,
) {
    let is_constant = |part: &Expression| part.symbols().is_empty();
    match formula {
        Expression::Add(a, b) => {
            collect_terms(a, within, terms);
            collect_terms(b, within, terms);
        }
        Expression::Subtract(a, b) => {
            collect_terms(a, within, terms);
            collect_terms(b, &|term| within(Expression::Negate(Box::new(term))), terms);
        }
        Expression::Negate(a) => {
            collect_terms(a, &|term| within(Expression::Negate(Box::new(term))), terms);
        }
        Expression::Multiply(a, b) if is_constant(a) => {
            collect_terms(b, &|term| within(Expression::Multiply(a.clone(), Box::new(term))), terms);
        }
        Expression::Multiply(a, b) if is_constant(b) => {
            collect_terms(a, &|term| within(Expression::Multiply(Box::new(term), b.clone())), terms);
        }
        Expression::Divide(a, b) if is_constant(b) => {
            collect_terms(a, &|term| within(Expression::Divide(Box::new(term), b.clone())), terms);
        }
        _ => terms.push(within(formula.clone())),
    }
}

/// The sine and the cosine of the angle alone.
const SINE: Monomial = Monomial { velocity: 0, sines: 1, cosines: 0, harmonic: 0 };
const COSINE: Monomial = Monomial { velocity: 0, sines: 0, cosines: 1, harmonic: 0 };

/// The angle c of a·sin θ + b·cos θ = −R·sin(θ − c); `None` if it is zero, but for rounding, or if there is neither.
fn centre(closed: &Trigonometric) -> Option<f64> {
    const ROUNDING: f64 = 4.0 * f64::EPSILON;
    let factor = |monomial: &Monomial| closed.terms.get(monomial).map_or(0.0, |coefficient| coefficient.re);
    let [a, b] = [factor(&SINE), factor(&COSINE)];
    let is_elsewhere = b.abs() > ROUNDING * a.abs() || a > 0.0;
    is_elsewhere.then(|| libm::atan2(b, -a))
}

/// The equation with its angle counted from a place.
fn from_place(equation: &Equation, place: f64) -> Result<Equation, MelnikovError> {
    if place == 0.0 {
        return Ok(equation.clone());
    }
    let angle = Symbol::plain(&equation.variables()[0]);
    let place = format!("{place:?}").parse().map_err(|_| MelnikovError::NoPendulum)?;
    let turned = Expression::Add(Box::new(Expression::Symbol(angle.clone())), Box::new(place));
    let accelerations = equation.accelerations().iter().map(|formula| formula.substitute(&angle, &turned));
    Ok(Equation::of_accelerations(equation.variables().to_vec(), accelerations.collect()))
}

/// ω0 of the term −ω0²·sin θ, which is removed.
fn own_frequency(closed: &mut Trigonometric) -> Result<f64, MelnikovError> {
    let force = closed.terms.remove(&SINE).map_or(0.0, |coefficient| coefficient.re);
    if force < 0.0 { Ok((-force).sqrt()) } else { Err(MelnikovError::NoPendulum) }
}

#[doc(hidden)]
pub fn power(base: f64, exponent: u32) -> f64 {
    (0..exponent).fold(1.0, |product, _| product * base)
}
