//! A periodic orbit and what it is asked for.

use super::floquet::Floquet;
use super::path::Path;
use libration_numbers::expression::Equation;
use std::f64::consts::TAU;

/// A periodic orbit of a system of equations of motion, which gives the state at every time.
#[derive(Clone, Debug)]
pub struct Orbit {
    variables: Vec<String>,
    path: Path,
    uncertainty: f64,
    floquet: Option<Floquet>,
}

impl Orbit {
    pub(super) fn new(equation: &Equation, path: Path, uncertainty: f64, floquet: Option<Floquet>) -> Self {
        Self { variables: equation.variables().to_vec(), path, uncertainty, floquet }
    }

    /// The orbit as one of a family, in which the start chooses it. In a plane of states both multipliers are then 1 exactly, by how the
    /// neighbours close; found as eigenvalues they are right to half the digits, fewer next to a separatrix.
    #[doc(hidden)]
    pub fn one_of_a_family(mut self) -> Self {
        if self.start().len() == 2 {
            self.floquet = self.floquet.map(Floquet::in_a_family_of_a_plane);
        }
        self
    }

    /// The names of the coordinates.
    #[must_use]
    pub fn variables(&self) -> &[String] {
        &self.variables
    }

    /// The time after which it repeats itself.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.path.end_time() - self.path.start_time()
    }

    /// The period may be wrong by so much: by how far integrations with other steps are off, the orbit misses its own start,
    /// and sums are rounded.
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

    /// By how much each number of the state at the end of the period misses its start; zero for a motion that goes the same way back.
    #[must_use]
    pub fn closing_error(&self) -> Vec<f64> {
        let [start, end] =
            [self.path.start_time(), self.path.end_time()].map(|time| self.path.state_at(time));
        end.iter().zip(&start).map(|(end, start)| (end - start).abs()).collect()
    }

    /// Coordinates, then velocities, so long after the start; times beyond the period are those within it.
    #[must_use]
    pub fn state_at(&self, time: f64) -> Vec<f64> {
        let (period, start) = (self.period(), self.path.start_time());
        let part = time - period * libm::floor(time / period);
        self.path.state_at(start + part)
    }

    /// The least and the greatest value of one number of the state, as the ends of the steps and a few times between show
    /// them: to about a thousandth of the swing, exactly at turning points where steps end.
    #[must_use]
    pub fn range(&self, number: usize) -> (f64, f64) {
        /// Between them the k-th harmonic is missed by at most (πk/512)²/2 of itself: 2e-5 of the first, 1e-3 of the seventh.
        const LOOKS: u32 = 512;
        let times = (0..LOOKS).map(|j| self.period() * f64::from(j) / f64::from(LOOKS));
        let values = times.filter_map(|time| self.state_at(time).get(number).copied());
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
    }

    /// Its Floquet multipliers; `None` for a release from rest, which needs none to be found.
    #[must_use]
    pub fn floquet(&self) -> Option<&Floquet> {
        self.floquet.as_ref()
    }
}
