//! Weak damping and excitation: how the amplitude changes and the phase runs, as series.
//!
//! For x″ + F(x) = −ε·f(x, x′) with a small ε the motion is x(A, ψ), nearly the undamped one of the amplitude A, and the slow flow
//!
//! ```text
//! A′ = ε·a₁(A) + ε²·a₂(A) + …,    ψ′ = Ω(A) + ε·b₁(A) + …
//! ```
//!
//! says how amplitude and phase go in time: Krylov, Bogoliubov and Mitropolsky's averaging. All of it is given as polynomials in A, for
//! small amplitudes, and in ε.
//!
//! **What A is** matters from the second order on. Here it is what is seen of the motion, the turning point: x = A and x′ = 0 at ψ = 0, the
//! gauge [`XMax`](Gauge::XMax). So A′ = −½cA and ψ′ = √(1 − c²/4) for x″ + cx′ + x = 0, the turning points of a swing lie on A(t) where ψ is
//! a multiple of 2π, and of π where the force is odd; and a limit cycle has the A with A′ = 0 for its largest displacement. With
//! [`Fundamental`](Gauge::Fundamental), for forces without kinks, the first harmonic of x is A·cos ψ without further terms, as in most books.
//!
//! A force such as x′|x′| or sign(x′) is a polynomial as long as the velocity has one sign. In the gauge of the turning points that is the half swing
//! 0 ≤ ψ ≤ π, at all orders, so that on it everything is polynomials in ψ and harmonics, with fractions and powers of π for coefficients:
//! exact where the harmonics over the whole swing would be infinitely many. Dry friction also stops a motion for good when the force is
//! smaller than it; of that a slow flow knows nothing, and [`decay`](mod@libration_motion::decay) does.
//!
//! ```
//! # extern crate libration_perturbation as libration;
//! use libration::perturbation::{Gauge, slow_flow};
//! use libration::progress::Quiet;
//!
//! // The drag of a fast flow on a pendulum.
//! let equation = "theta'' + c*theta'*abs(theta') + sin(theta) = 0".parse()?;
//! let flow = slow_flow(&equation, None, 4, 2, &Gauge::XMax, &Quiet)?;
//! assert_eq!(flow.amplitude_rate[1][2].to_string(), "-4/(3*pi)");
//! assert_eq!(flow.phase_rate[0][2].to_string(), "-1/16");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//! The jet is in powers of A, and its coefficients are series in ε of functions of ψ. Each power of A and of ε is one equation of a harmonic
//! oscillator, whose secular terms fix one coefficient of A′ and one of ψ′. On the half swing (`half_swing.rs`) the condition is that the next half
//! swing begins at the opposite displacement. A force that does not vanish with A, as dry friction, has ε = γA, so that it does.

mod averaging;
mod error;
#[doc(hidden)]
pub(crate) mod half_swing;
mod limit_cycle;
#[doc(hidden)]
pub(crate) mod phase_functions;
mod symbolic;
mod weak_force;

use super::gauge::Gauge;
use averaging::{Amplitude, Averaged, Averaging, Failed};
pub(super) use half_swing::HalfSwings;
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;
use libration_numbers::{
    algebra::{PiSum, Rational, Rationals, Surd},
    internals::algebra::{HarmonicSums, PiPolynomial, PiPowers, Quadratic, QuadraticField},
};
use libration_numbers::{
    expression::{Equation, Expression, Symbol},
    internals::expression::Tape,
};
use phase_functions::Coefficient;
pub(super) use phase_functions::{PhaseFunctions, Term};

pub use error::{MAX_PARAMETER_ORDER, MAX_SLOW_ORDER, SlowFlowError};
pub use limit_cycle::SlowLimitCycle;
pub use symbolic::{
    AmplitudeInTime, CoordinateFlow, CoupledSlowFlow, EarlierOrder, JudgedState, LeftOutReason,
    MAX_SYMBOLIC_SLOW_ORDER, PhaseInTime, RateProducts, ResponseSteps, SlowFlowAt, SlowFlowSteps, SmallTerm,
    StateLeftOut, SteadySolution, SteadyState, SteadyStates, SymbolicSlowFlow, SymbolicSlowFlowError,
    SymbolicSlowFlowOptions, coupled_slow_flow, drive_symbol, next_slow_flow, slow_flow_steps,
    slow_flow_symbolically,
};
pub(crate) use weak_force::FirstOrder;
pub use weak_force::WeakForce;

/// A polynomial in the small parameter and the amplitude: indexed by the power of the parameter, then by that of A.
pub type SlowSeries = Vec<Vec<PiSum>>;

/// The slow flow of a weakly damped or excited oscillator, and its motion.
#[derive(Clone, Debug, PartialEq)]
pub struct SlowFlow {
    /// The name of the small parameter.
    pub parameter: String,
    /// The highest power of A in displacement and A′; that in ψ′ is lower by one.
    pub order: usize,
    /// The highest power of the parameter.
    pub parameter_order: usize,
    /// Definition of A: the turning point or the coefficient of the first harmonic.
    pub gauge: Gauge,
    /// The equilibrium, without the small terms; displacements count from it.
    pub equilibrium: Rational,
    /// ω0² of small oscillations, without the small terms.
    pub omega0_squared: Rational,
    /// A′.
    pub amplitude_rate: SlowSeries,
    /// ψ′.
    pub phase_rate: SlowSeries,
    /// The displacement as a sum of these; for [`half_swing`](Self::half_swing) only for 0 ≤ ψ ≤ π.
    pub motion: Vec<PhaseTerm>,
    /// Power of the parameter up to which A′ and ψ′ are complete: polynomials in A without terms beyond [`order`](Self::order). Zero where
    /// the force without the small terms is not linear, or the small terms are not polynomials in displacement and velocity.
    pub whole_powers: usize,
    /// `true` if the force has kinks where the motion turns: the displacement at ψ + π is the opposite of that at ψ.
    pub half_swing: bool,
}

/// ψᵖ·(c·cos kψ + s·sin kψ).
#[derive(Clone, Debug, PartialEq)]
pub struct PhaseTerm {
    /// p.
    pub power: usize,
    /// k.
    pub k: usize,
    /// c.
    pub cos: SlowSeries,
    /// s.
    pub sin: SlowSeries,
}

impl SlowFlow {
    /// A′ at an amplitude and a value of the small parameter.
    #[must_use]
    pub fn amplitude_rate_at(&self, amplitude: f64, parameter: f64) -> f64 {
        value(&self.amplitude_rate, amplitude, parameter)
    }

    /// ψ′ at an amplitude and a value of the small parameter.
    #[must_use]
    pub fn phase_rate_at(&self, amplitude: f64, parameter: f64) -> f64 {
        value(&self.phase_rate, amplitude, parameter)
    }

    /// The displacement from the equilibrium.
    #[must_use]
    pub fn displacement_at(&self, amplitude: f64, phase: f64, parameter: f64) -> f64 {
        let halves = if self.half_swing { libm::floor(phase / std::f64::consts::PI) } else { 0.0 };
        let sign = if halves % 2.0 == 0.0 { 1.0 } else { -1.0 };
        let phase = phase - halves * std::f64::consts::PI;
        let term = |term: &PhaseTerm| {
            let angle = u32::try_from(term.k).map_or(f64::NAN, f64::from) * phase;
            let powers = (0..term.power).fold(1.0, |product, _| product * phase);
            let cosine = value(&term.cos, amplitude, parameter) * libm::cos(angle);
            powers * (cosine + value(&term.sin, amplitude, parameter) * libm::sin(angle))
        };
        sign * self.motion.iter().map(term).sum::<f64>()
    }
}

fn value(series: &SlowSeries, amplitude: f64, parameter: f64) -> f64 {
    let in_amplitude = |list: &Vec<PiSum>| list.iter().rev().fold(0.0, |sum, c| sum * amplitude + c.to_f64());
    series.iter().rev().fold(0.0, |sum, list| sum * parameter + in_amplitude(list))
}

/// The slow flow of an equation in which one letter has no value, the small parameter, or the one that is named: displacement and A′ to
/// A^`order`, ψ′ to one less, all to the power `parameter_order` of the parameter.
///
/// The equation must be that of an oscillator without damping where the parameter is zero, and analytic in it, in displacement and velocity,
/// but for `abs` and `sign` of the velocity where the acceleration is odd.
///
/// # Errors
/// Orders out of range; letters without values; no oscillator at zero, or one whose equilibrium or ω0² is not a fraction; a force without
/// series.
/// [`SlowFlowError::Interrupted`] if the call is cancelled.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::perturbation::{Gauge, slow_flow};
/// use libration::progress::Quiet;
/// // Viscous damping of a linear spring: A′ = −cA/2 and ψ′ = √(1 − c²/4), exactly.
/// let flow = slow_flow(&"x'' + c*x' + x = 0".parse()?, None, 1, 4, &Gauge::XMax, &Quiet)?;
/// assert_eq!(flow.amplitude_rate[1][1].to_string(), "-1/2");
/// assert_eq!(flow.phase_rate[2][0].to_string(), "-1/8");
/// assert_eq!(flow.phase_rate[4][0].to_string(), "-1/128");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # References
/// N. N. Bogoliubov, Y. A. Mitropolsky, *Asymptotic Methods in the Theory of Non-Linear Oscillations*, Gordon and Breach 1961, chapter I.
pub fn slow_flow(
    equation: &Equation,
    parameter: Option<&str>,
    order: usize,
    parameter_order: usize,
    gauge: &Gauge,
    progress: &dyn Progress,
) -> Result<SlowFlow, SlowFlowError> {
    if !(1..=MAX_SLOW_ORDER).contains(&order) {
        return Err(SlowFlowError::Order(order));
    }
    if !(1..=MAX_PARAMETER_ORDER).contains(&parameter_order) {
        return Err(SlowFlowError::ParameterOrder(parameter_order));
    }
    let force = WeakForce::new(equation, parameter)?;
    SlowFlowProblem::new(&force, [order, parameter_order], gauge)?.answer(&Watch::new(progress))
}

/// An oscillator under a weak force, and the slow flow requested.
struct SlowFlowProblem<'a> {
    force: &'a WeakForce,
    tape: Tape,
    equilibrium: &'a Rational,
    omega0_squared: &'a Rational,
    gauge: &'a Gauge,
    amplitude: Amplitude,
    order: usize,
    parameter_order: usize,
}

impl<'a> SlowFlowProblem<'a> {
    fn new(
        force: &'a WeakForce,
        [order, parameter_order]: [usize; 2],
        gauge: &'a Gauge,
    ) -> Result<Self, SlowFlowError> {
        let amplitude = match gauge {
            Gauge::XMax => Amplitude::TurningPoint,
            Gauge::Fundamental if !force.kinked => Amplitude::FirstHarmonic,
            other => return Err(SlowFlowError::Gauge(other.to_string())),
        };
        let (rest, square) = (force.oscillator.equilibrium(), force.oscillator.omega0_squared());
        let (Some(equilibrium), Some(omega0_squared)) = (rest.exact(), square.exact()) else {
            return Err(SlowFlowError::NotRational {
                parameter: force.parameter.clone(),
                equilibrium: rest.to_string(),
                omega0_squared: square.to_string(),
            });
        };
        let x = Symbol::plain(force.oscillator.variable());
        let inputs = [x.clone(), x.with_primes(1), Symbol::plain(&force.parameter)];
        let tape = Tape::new(&[&force.acceleration], &inputs).map_err(|_| SlowFlowError::NoSeries)?;
        Ok(Self { force, tape, equilibrium, omega0_squared, gauge, amplitude, order, parameter_order })
    }

    /// The slow flow over fractions, or with √ω0² and powers of π if they are needed.
    fn answer(&self, watch: &Watch<'_>) -> Result<SlowFlow, SlowFlowError> {
        let field = QuadraticField { base: Rationals, square: self.omega0_squared.clone() };
        let surd =
            |a: &Quadratic<Rational>| Surd::new(a.plain.clone(), a.root.clone(), self.omega0_squared.clone());
        let number = |a: &Rational| PiSum::from(a.clone());
        match (self.omega0_squared.square_root(), self.force.kinked) {
            (Some(omega0), false) => {
                self.averaged(&HarmonicSums { numbers: Rationals }, omega0, number, watch)
            }
            (Some(omega0), true) => {
                let omega0 = PiPowers { numbers: Rationals }.term(0, omega0);
                let number =
                    |a: &PiPolynomial<Rational>| pi_sum(a, |coefficient| Surd::from(coefficient.clone()));
                self.averaged(&HalfSwings::new(Rationals), omega0, number, watch)
            }
            (None, false) => {
                let omega0 = field.square_root().ok_or(SlowFlowError::NoSeries)?;
                let number = |a: &Quadratic<Rational>| PiSum::new(vec![(0, surd(a))]);
                self.averaged(&HarmonicSums { numbers: field.clone() }, omega0, number, watch)
            }
            (None, true) => {
                let omega0 = field.square_root().ok_or(SlowFlowError::NoSeries)?;
                let omega0 = PiPowers { numbers: field.clone() }.term(0, omega0);
                let number = |a: &PiPolynomial<Quadratic<Rational>>| pi_sum(a, surd);
                self.averaged(&HalfSwings::new(field.clone()), omega0, number, watch)
            }
        }
    }

    fn averaged<R: PhaseFunctions + Clone>(
        &self,
        ring: &R,
        omega0: Coefficient<R>,
        number: impl Fn(&Coefficient<R>) -> PiSum,
        watch: &Watch<'_>,
    ) -> Result<SlowFlow, SlowFlowError> {
        let mut averaging = Averaging {
            tape: &self.tape,
            equilibrium: ring.rational(self.equilibrium).ok_or(SlowFlowError::NoSeries)?,
            omega0,
            amplitude: self.amplitude,
            lift: 0,
            order: self.order,
            parameter_order: self.parameter_order,
        };
        let mut outcome = averaging.solve(ring, watch);
        if matches!(outcome, Err(Failed::MovingEquilibrium)) {
            averaging.lift = 1;
            averaging.order += self.parameter_order;
            outcome = averaging.solve(ring, watch);
        }
        match outcome {
            Ok(averaged) => Ok(self.collected(ring, &averaged, averaging.lift, number)),
            Err(Failed::Interrupted) => Err(SlowFlowError::Interrupted),
            Err(_) => Err(SlowFlowError::NoSeries),
        }
    }

    /// Small terms of the degree d make polynomials of the degree 1 + k(d − 1) at εᵏ.
    fn whole_powers(&self) -> usize {
        let x = Symbol::plain(self.force.oscillator.variable());
        let degree = |formula: &Expression| formula.polynomial_degree(&[x.clone(), x.with_primes(1)]);
        if degree(self.force.oscillator.acceleration()).is_none_or(|degree| degree > 1) {
            return 0;
        }
        let Some(degree) = degree(&self.force.acceleration).and_then(|degree| usize::try_from(degree).ok())
        else {
            return 0;
        };
        let powers = if degree > 1 { (self.order - 1) / (degree - 1) } else { self.parameter_order };
        powers.min(self.parameter_order)
    }

    /// The coefficients by the powers of ε and A, of γ = ε/A^q and A that they were found by.
    fn collected<R: PhaseFunctions>(
        &self,
        ring: &R,
        averaged: &Averaged<R>,
        lift: usize,
        number: impl Fn(&Coefficient<R>) -> PiSum,
    ) -> SlowFlow {
        let empty = || vec![vec![PiSum::new(vec![]); self.order + 1]; self.parameter_order + 1];
        let mut flow = SlowFlow {
            parameter: self.force.parameter.clone(),
            order: self.order,
            parameter_order: self.parameter_order,
            gauge: self.gauge.clone(),
            equilibrium: self.equilibrium.clone(),
            omega0_squared: self.omega0_squared.clone(),
            amplitude_rate: empty(),
            phase_rate: vec![vec![PiSum::new(vec![]); self.order]; self.parameter_order + 1],
            motion: vec![],
            whole_powers: self.whole_powers(),
            half_swing: self.force.kinked,
        };
        for (n, row) in averaged.displacement.iter().enumerate() {
            for (j, displacement) in row.iter().enumerate() {
                // A′ is A·Σ, one power of A more than ψ′ at the same place.
                let put = |list: &mut Vec<PiSum>, power: usize, value: &Coefficient<R>| {
                    let entry = power.checked_sub(lift * j).and_then(|power| list.get_mut(power));
                    if let Some(coefficient) = entry {
                        *coefficient = number(value);
                    }
                };
                put(&mut flow.phase_rate[j], n, &averaged.frequency[n][j]);
                put(&mut flow.amplitude_rate[j], n + 1, &averaged.growth[n][j]);
                let Some(power) = n.checked_sub(lift * j).filter(|&power| power <= self.order) else {
                    continue;
                };
                for Term { power: p, k, wave } in ring.terms(displacement) {
                    let term = flow.term(p, k, &empty);
                    term.cos[j][power] = number(&wave.cosine);
                    term.sin[j][power] = number(&wave.sine);
                }
            }
        }
        flow.motion.put_in_order_by(|term| (term.power, term.k));
        flow
    }
}

impl SlowFlow {
    fn term(&mut self, power: usize, k: usize, empty: &impl Fn() -> SlowSeries) -> &mut PhaseTerm {
        let existing = self.motion.iter().position(|term| (term.power, term.k) == (power, k));
        let index = existing.unwrap_or_else(|| {
            self.motion.push(PhaseTerm { power, k, cos: empty(), sin: empty() });
            self.motion.len() - 1
        });
        &mut self.motion[index]
    }
}

fn pi_sum<E>(a: &PiPolynomial<E>, surd: impl Fn(&E) -> Surd) -> PiSum {
    PiSum::new(a.terms().map(|(power, number)| (power, surd(number))).collect())
}
