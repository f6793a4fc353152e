//! A periodic orbit and its properties.

use super::path::Path;
use crate::periodic::Floquet;
use libration_numbers::expression::Equation;
use std::f64::consts::TAU;

/// A periodic orbit of a system, with the state at every time.
#[derive(Clone, Debug)]
pub struct Orbit {
    variables: Vec<String>,
    path: Path,
    uncertainty: f64,
    floquet: Option<Floquet>,
    errors: OrbitErrors,
}

/// The errors of the states of an orbit, component by component.
#[derive(Clone, Debug)]
pub(super) struct OrbitErrors {
    /// The error of the start.
    pub(super) start: Vec<f64>,
    /// The largest error on the orbit, at the same fraction of the period.
    pub(super) way: Vec<f64>,
}

impl OrbitErrors {
    /// The errors on a path, from the error of its start as it grows, from another path, and from the error of the period.
    pub(super) fn new(path: &Path, start: Vec<f64>, grown: &[f64], apart: &[f64], period: f64) -> Self {
        let rates = path.largest_rates(start.len());
        let error = |component: usize| {
            let size = path.extrema(component).map(f64::abs).into_iter().fold(0.0, f64::max);
            grown[component] + apart[component] + rates[component] * period + 4.0 * f64::EPSILON * size
        };
        Self { way: (0..start.len()).map(error).collect(), start }
    }
}

impl Orbit {
    pub(super) fn new(
        equation: &Equation,
        path: Path,
        uncertainty: f64,
        floquet: Option<Floquet>,
        errors: OrbitErrors,
    ) -> Self {
        Self { variables: equation.variables().to_vec(), path, uncertainty, floquet, errors }
    }

    /// The orbit as one of a family that the start selects. In a plane of states both multipliers are then exactly 1, because the neighbours
    /// close; computed as eigenvalues they have half the digits, and fewer next to a separatrix.
    #[doc(hidden)]
    pub fn one_of_a_family(mut self) -> Self {
        if self.start().len() == 2 {
            self.floquet = self.floquet.map(Floquet::in_a_family_of_a_plane);
        }
        self
    }

    /// Number of steps in which the orbit was integrated.
    pub(super) fn steps(&self) -> usize {
        self.path.steps()
    }

    /// The names of the coordinates.
    #[must_use]
    pub fn variables(&self) -> &[String] {
        &self.variables
    }

    /// The period of the orbit.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.path.end_time() - self.path.start_time()
    }

    /// Bound on the error of the period, from integrations with other steps, the closing error of the orbit, and the rounding of sums.
    #[must_use]
    pub fn period_uncertainty(&self) -> f64 {
        self.uncertainty
    }

    /// 2π over the period.
    #[must_use]
    pub fn frequency(&self) -> f64 {
        TAU / self.period()
    }

    /// The state at the start: coordinates, then velocities.
    #[must_use]
    pub fn start(&self) -> Vec<f64> {
        self.state_at(0.0)
    }

    /// The difference between each state component at the end of the period and at its start; zero for a motion that returns on the same path.
    #[must_use]
    pub fn closing_error(&self) -> Vec<f64> {
        let [start, end] =
            [self.path.start_time(), self.path.end_time()].map(|time| self.path.state_at(time));
        end.iter().zip(&start).map(|(end, start)| (end - start).abs()).collect()
    }

    /// The state, coordinates and then velocities, at a time after the start; times beyond the period are reduced modulo the period.
    #[must_use]
    pub fn state_at(&self, time: f64) -> Vec<f64> {
        let (period, start) = (self.period(), self.path.start_time());
        let part = time - period * libm::floor(time / period);
        self.path.state_at(start + part)
    }

    /// The error of each component of [`start`](Self::start): the closing residual, the error of the flow and rounding, propagated through the
    /// inverse of the bordered monodromy matrix; zero if the start is given.
    #[must_use]
    pub fn start_errors(&self) -> &[f64] {
        &self.errors.start
    }

    /// The largest error of each component of the state on the orbit, at the same fraction of the period:
    /// an estimate from two integrations, the error of the start as it grows, and that of the period.
    #[must_use]
    pub fn state_errors(&self) -> &[f64] {
        &self.errors.way
    }

    /// The least and the greatest value of one state component, with the errors of [`state_errors`](Self::state_errors).
    #[must_use]
    pub fn range(&self, component: usize) -> (f64, f64) {
        self.path.extrema(component).into()
    }

    /// The Floquet multipliers; `None` for a release from rest, which is found without them.
    #[must_use]
    pub fn floquet(&self) -> Option<&Floquet> {
        self.floquet.as_ref()
    }
}
