//! Limit cycles of an oscillator with any force under a weak excitation, to leading order over its exact orbits.
//!
//! Of the orbits of x″ = F(x) those are left under x″ = F(x) + ε·f(x, x′) with a small ε over which f does no work, W(A) = 0, and where the
//! work changes its sign (L. S. Pontryagin, Zh. Eksp. Teor. Fiz. 4, 883 (1934); V. K. Melnikov, Trans. Moscow Math. Soc. 12, 1 (1963)).
//! A distance from the cycle in energy grows by ε·dW/dE in a period, so that the exponent is ε·(dW/dE)/T.
//!
//! # Method
//! The orbits are found by integration. The work is an integral along the orbit, and its derivative by the energy another one (`work.rs`), which
//! gives the stability exponent and shows two cycles between two neighbouring amplitudes.

use super::work::{Work, WorkOverOrbits};
use crate::perturbation::{FirstOrder, SlowFlowError};
use libration_motion::orbit::OrbitError;
use libration_motion::oscillator::Oscillator;
use libration_numbers::expression::{Equation, Symbol};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Interrupted, Progress};
use libration_numbers::roots::{Tolerance, zero_between};
use std::cell::Cell;

/// A limit cycle for a small value of the parameter ε, to leading order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeadingLimitCycle {
    /// The largest displacement from the equilibrium.
    pub amplitude: f64,
    /// Bound on the error of the amplitude as a zero of the work; terms of higher order in ε are not included.
    pub amplitude_uncertainty: f64,
    /// The least displacement.
    pub other_side: f64,
    /// Period of the exact orbit without the small terms.
    pub period: f64,
    /// Bound on the error of the period.
    pub period_uncertainty: f64,
    /// The rate, over ε, at which a distance from the cycle grows: for ε > 0 it attracts where this is below zero.
    pub exponent: f64,
    /// Bound on the error of the exponent.
    pub exponent_uncertainty: f64,
}

/// All limit cycles in a range of amplitudes.
#[derive(Clone, Debug, PartialEq)]
pub struct LeadingLimitCycles {
    /// The name of ε.
    pub parameter: String,
    /// The equilibrium, which displacements count from.
    pub equilibrium: f64,
    /// The least and the greatest amplitude looked at.
    pub searched: [f64; 2],
    /// `true` if the orbits end at the greater of these amplitudes, at a separatrix or where the force has no value.
    pub family_ends: bool,
    /// The signs of the work at these two; zero if the work is zero within its error.
    pub signs: [f64; 2],
    /// The cycles, from the smallest on.
    pub cycles: Vec<LeadingLimitCycle>,
}

/// The reason why limit cycles are not searched for.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LeadingLimitCyclesError {
    /// No small parameter, or no oscillator without it.
    #[error(transparent)]
    SlowFlow(#[from] SlowFlowError),
    /// A force that depends on the velocity without the small terms.
    #[error(
        "at {parameter} = 0 the force depends on the velocity, so that the orbits are not distinguished by an energy"
    )]
    VelocityDependent {
        /// The small parameter.
        parameter: String,
    },
    /// No orbit about the equilibrium.
    #[error("no orbit about the equilibrium is found: {0}")]
    Orbit(#[from] OrbitError),
    /// Cancellation by the caller.
    #[error("interrupted")]
    Interrupted,
}

impl From<Interrupted> for LeadingLimitCyclesError {
    fn from(_: Interrupted) -> Self {
        Self::Interrupted
    }
}

impl LeadingLimitCycles {
    /// The limit cycles of an equation in which one letter has no value, the small parameter, or the one that is named.
    ///
    /// # Accuracy
    /// Amplitudes from 1e-4 to 1e4 are looked at, each 1.25 times the one before and closer towards a separatrix: two cycles between two of
    /// them are found where the work has its extremum between them.
    ///
    /// # Errors
    /// As [`slow_flow`](crate::perturbation::slow_flow) has them of the letters; a force that depends on the velocity without the small
    /// terms; no orbit.
    /// [`LeadingLimitCyclesError::Interrupted`] if the call is cancelled.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_perturbation as libration;
    /// use libration::comparison::LeadingLimitCycles;
    /// use libration::progress::Quiet;
    /// // Van der Pol's excitation of a spring that stiffens: the amplitude is not 2.
    /// let leading = LeadingLimitCycles::new(&"x'' + x + x^3 = mu*(1 - x^2)*x'".parse()?, None, &Quiet)?;
    /// let [cycle] = &leading.cycles[..] else { panic!() };
    /// assert!((cycle.amplitude - 1.9351).abs() < 1e-4 && cycle.exponent < 0.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        equation: &Equation,
        parameter: Option<&str>,
        progress: &dyn Progress,
    ) -> Result<Self, LeadingLimitCyclesError> {
        let watch = &Watch::new(progress);
        let FirstOrder { parameter, unperturbed, force } = FirstOrder::new(equation, parameter)?;
        let oscillator = Oscillator::new(&unperturbed).map_err(|error| SlowFlowError::Oscillator {
            parameter: parameter.clone(),
            error: Box::new(error),
        })?;
        let velocity = Symbol::plain(oscillator.variable()).with_primes(1);
        if unperturbed.accelerations()[0].contains(&velocity) {
            return Err(LeadingLimitCyclesError::VelocityDependent { parameter });
        }
        let centre = oscillator.equilibrium().to_f64();
        let work = WorkOverOrbits::new(&unperturbed, &force, centre).ok_or(SlowFlowError::NoSeries)?;
        let Scan { places: points, family_ends } = Scan::new(&work, watch)?;
        let cycles = cycles(&work, &points, watch)?;
        let ends = [&points[0], &points[points.len() - 1]];
        Ok(Self {
            parameter,
            equilibrium: centre,
            searched: ends.map(|end| end.amplitude),
            family_ends,
            signs: ends.map(|end| if end.is_some() { end.value.signum() } else { 0.0 }),
            cycles,
        })
    }

    /// Returns `true` if the force does no work at either end of the range and has no cycle: on every orbit it supplies as much energy as it takes.
    #[must_use]
    pub fn is_without_work(&self) -> bool {
        self.cycles.is_empty() && self.signs.iter().all(|sign| *sign == 0.0)
    }
}

/// The work over the orbits of amplitudes that grow.
struct Scan {
    places: Vec<Work>,
    family_ends: bool,
}

/// Ratio of successive amplitudes: a force of the tenth power changes by 9 between them, and cycles that differ by a quarter are
/// distinguished without further amplitudes.
const RATIO: f64 = 1.25;
/// First amplitude of the scan, in the unit of the equation; the result names the range.
const SMALLEST: f64 = 1e-4;
const LARGEST: f64 = 1e4;
/// Halvings of the distance to the end of the orbits: next to a separatrix 1e-3 of it remain, and a cycle beyond has an exponent that terms of
/// higher order change.
const TOWARDS_THE_END: usize = 8;

impl Scan {
    fn new(work: &WorkOverOrbits<'_>, watch: &Watch<'_>) -> Result<Self, LeadingLimitCyclesError> {
        let mut points: Vec<Work> = vec![];
        let mut amplitude = SMALLEST;
        while amplitude <= LARGEST {
            match work.at(amplitude, watch) {
                Ok(reached) => points.push(reached),
                Err(OrbitError::Interrupted(stopped)) => return Err(stopped.into()),
                Err(error) if points.is_empty() => return Err(error.into()),
                Err(_) => break,
            }
            amplitude *= RATIO;
        }
        let family_ends = amplitude <= LARGEST;
        if family_ends {
            let (mut inside, mut outside) = (amplitude / RATIO, amplitude);
            for _ in 0..TOWARDS_THE_END {
                let middle = f64::midpoint(inside, outside);
                match work.at(middle, watch) {
                    Ok(reached) => {
                        points.push(reached);
                        inside = middle;
                    }
                    Err(OrbitError::Interrupted(stopped)) => return Err(stopped.into()),
                    Err(_) => outside = middle,
                }
            }
        }
        Ok(Self { places: points, family_ends })
    }
}

fn cycles(
    work: &WorkOverOrbits<'_>,
    points: &[Work],
    watch: &Watch<'_>,
) -> Result<Vec<LeadingLimitCycle>, LeadingLimitCyclesError> {
    let certain: Vec<Work> = points.iter().copied().filter(Work::is_some).collect();
    let mut cycles = vec![];
    for pair in certain.windows(2) {
        let [below, above] = [pair[0], pair[1]];
        let turn = extremum(work, [below, above], watch)?;
        for [below, above] in turn.map_or(vec![[below, above]], |turn| vec![[below, turn], [turn, above]]) {
            if below.value * above.value < 0.0 {
                cycles.extend(cycle(work, [below, above], watch)?);
            }
        }
    }
    Ok(cycles)
}

/// The work at its extremum between two positions of equal sign, if it approaches zero there.
fn extremum(
    work: &WorkOverOrbits<'_>,
    [below, above]: [Work; 2],
    watch: &Watch<'_>,
) -> Result<Option<Work>, LeadingLimitCyclesError> {
    let sign = below.value.signum();
    let dips = below.value * above.value > 0.0 && below.slope * sign < 0.0 && above.slope * sign > 0.0;
    if !dips {
        return Ok(None);
    }
    let slope = |work_there: &Work| work_there.slope;
    let ends = [(below.amplitude, below.slope), (above.amplitude, above.slope)];
    let extremum = at_zero(work, ends, AT_EXTREMUM, &slope, watch)?;
    Ok(extremum.filter(Work::is_some))
}

/// The work at a zero of a function of it; no further work is computed after a cancellation.
fn at_zero(
    work: &WorkOverOrbits<'_>,
    ends: [(f64, f64); 2],
    tolerance: f64,
    of: &dyn Fn(&Work) -> f64,
    watch: &Watch<'_>,
) -> Result<Option<Work>, LeadingLimitCyclesError> {
    let stopped = Cell::new(None);
    let at = |amplitude: f64| match work.at(amplitude, watch) {
        Err(OrbitError::Interrupted(reason)) => {
            stopped.set(Some(reason));
            None
        }
        outcome => outcome.ok().filter(|_| stopped.get().is_none()),
    };
    let value = |amplitude: f64| match stopped.get() {
        Some(_) => f64::NAN,
        None => at(amplitude).map_or(f64::NAN, |point| of(&point)),
    };
    let zero = zero_between(ends, Tolerance::relative(tolerance), value);
    let point = zero.filter(|_| stopped.get().is_none()).and_then(at);
    stopped.get().map_or(Ok(point), |reason| Err(reason.into()))
}

/// Relative tolerance of the amplitude of an extremum: the work is flat there, so that its sign is that of the extremum unless two cycles
/// are closer than this.
const AT_EXTREMUM: f64 = 1e-6;
/// Relative tolerance of the amplitude of a zero: beyond the roundings of the work, which are added.
const AT_ZERO: f64 = 1e-15;

fn cycle(
    work: &WorkOverOrbits<'_>,
    ends: [Work; 2],
    watch: &Watch<'_>,
) -> Result<Option<LeadingLimitCycle>, LeadingLimitCyclesError> {
    // W goes with the square of the amplitude where that is small.
    let value = |point: &Work| point.value / (point.amplitude * point.amplitude);
    let bracket = ends.map(|end| (end.amplitude, value(&end)));
    let Some(point) = at_zero(work, bracket, AT_ZERO, &value, watch)? else { return Ok(None) };
    let by_amplitude = (point.slope * point.energy_slope).abs();
    let amplitude_uncertainty =
        (point.uncertainty + point.value.abs()) / by_amplitude + 2.0 * AT_ZERO * point.amplitude;
    // How period and exponent go with the amplitude is seen between the ends.
    let along = |of: &dyn Fn(&Work) -> f64| {
        ((of(&ends[1]) - of(&ends[0])) / (ends[1].amplitude - ends[0].amplitude)).abs()
            * amplitude_uncertainty
    };
    let exponent = |work: &Work| work.slope / work.period;
    Ok(Some(LeadingLimitCycle {
        amplitude: point.amplitude,
        amplitude_uncertainty,
        other_side: point.other_side,
        period: point.period,
        period_uncertainty: point.period_uncertainty + along(&|work| work.period),
        exponent: exponent(&point),
        exponent_uncertainty: point.slope_uncertainty / point.period + along(&exponent),
    }))
}
