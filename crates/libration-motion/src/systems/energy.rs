//! Conserved energies, and their drift along a motion.
//!
//! # Method
//! A named system states its energy as a formula without cancellation near rest, and its gain per time; if the gain is zero for the given values
//! the energy is conserved. For other equations the forces must be proved to have a potential, whose change is the work along the polygon of the
//! step ends, by Gauss–Kronrod rules, summed in two words. Intervals are halved only while that reduces the difference of the rules: next to a
//! pole the rules differ by the roundings of the positions, and their difference is the uncertainty of the drift. The drift is the largest
//! change divided by the largest kinetic energy, which does not depend on the zero of the potential.

use super::EnergyError;
use super::line_integral::work;
use crate::taylor::{Moment, StateLayout, larger_or_nan};
use libration_kernels::double_double::DoubleDouble;
use libration_numbers::algebra::Doubles;
use libration_numbers::{
    expression::{Equation, Expression, Symbol},
    internals::expression::{Jet, Tape},
};

/// The conserved energy of a system.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::systems::Model;
/// use libration::taylor::Moment;
/// let model = Model::typed("x'' = -x^3", &[], &[])?;
/// let energy = model.energy()?;
/// let mut balance = energy.balance(&Moment { time: 0.0, state: vec![1.0, 0.0] });
/// // x'²/2 + x⁴/4 stays 1/4, so that x' = 1/√2 at x = 0.
/// balance.record(&Moment { time: 1.0, state: vec![0.0, 0.5_f64.sqrt()] });
/// assert!(balance.drift() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Energy {
    coordinates: usize,
    tape: Tape,
    holds: Holds,
    /// Mass of each coordinate, if the tape computes forces.
    masses: Vec<f64>,
}

/// The quantity that the tape computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Holds {
    /// The energy.
    Energy,
    /// The forces, which are minus the gradient of the potential.
    Forces,
}

impl Energy {
    /// An energy that is a formula of coordinates and velocities.
    pub(super) fn of_formula(equation: &Equation, energy: &Expression) -> Result<Self, EnergyError> {
        Self::on_tape(equation, &[energy], Holds::Energy)
    }

    /// The energy Σ m x′²/2 + V of forces −∂V/∂x that depend on the coordinates only; m is the factor of x″ in the equations if that is a
    /// positive constant, and otherwise one. The forces have a potential if ∂Fᵢ/∂xⱼ = ∂Fⱼ/∂xᵢ is proved.
    pub(super) fn of_forces(equation: &Equation) -> Result<Self, EnergyError> {
        equation.refuse_first_order()?;
        let masses =
            masses(equation).unwrap_or_else(|| vec![Expression::from(1); equation.variables().len()]);
        let force = |(mass, acceleration): (&Expression, &Expression)| {
            Expression::Multiply(Box::new(mass.clone()), Box::new(acceleration.clone())).simplified()
        };
        let forces: Vec<Expression> = masses.iter().zip(equation.accelerations()).map(force).collect();
        let names = equation.variables();
        for (name, force) in names.iter().zip(&forces) {
            let foreign = |symbol: &Symbol| symbol.primes > 0 || symbol.name == "t";
            if let Some(on) = force.symbols().into_iter().find(foreign) {
                return Err(EnergyError::NotOfPlace { coordinate: name.clone(), on });
            }
        }
        for (index, first) in names.iter().enumerate() {
            for (other, second) in names.iter().enumerate().take(index) {
                let slope = |force: usize, by: &str| Box::new(forces[force].derivative(&Symbol::plain(by)));
                if !Expression::Subtract(slope(index, second), slope(other, first)).vanishes() {
                    return Err(EnergyError::Curl { first: second.clone(), second: first.clone() });
                }
            }
        }
        let energy = Self::on_tape(equation, &forces.iter().collect::<Vec<_>>(), Holds::Forces)?;
        Ok(Self { masses: masses.iter().filter_map(Expression::to_f64).collect(), ..energy })
    }

    fn on_tape(equation: &Equation, formulas: &[&Expression], holds: Holds) -> Result<Self, EnergyError> {
        let inputs = StateLayout::new(equation).symbols(equation.variables());
        let tape = Tape::new(formulas, &inputs)?;
        Ok(Self { coordinates: equation.variables().len(), tape, holds, masses: vec![] })
    }

    /// An account of the energy of a motion that begins at `start`.
    #[must_use]
    pub fn balance(&self, start: &Moment) -> EnergyBalance<'_> {
        let mut balance = self.balance_from(&EnergyAccount {
            start: start.state.clone(),
            last: start.state.clone(),
            potential: [0.0; 2],
            quadrature_error: 0.0,
            largest_change: 0.0,
            largest_kinetic: 0.0,
        });
        balance.record(start);
        balance
    }

    /// The account of a motion that is continued.
    #[must_use]
    pub fn balance_from(&self, account: &EnergyAccount) -> EnergyBalance<'_> {
        EnergyBalance { energy: self, jet: None, at_start: None, account: account.clone() }
    }

    /// The drift of the energy between two states of a motion, as defined in [`EnergyBalance::drift`].
    ///
    /// # Accuracy
    /// Without a formula the potential is integrated along the straight line between the states, which
    /// must not meet a singularity: record the intermediate states in a [`balance`](Self::balance).
    #[must_use]
    pub fn drift(&self, start: &Moment, end: &Moment) -> f64 {
        let mut balance = self.balance(start);
        balance.record(end);
        balance.drift()
    }
}

/// The record of the energy of a motion so far, from which it can be continued.
#[derive(Clone, Debug, PartialEq)]
pub struct EnergyAccount {
    /// The first state.
    pub start: Vec<f64>,
    /// The last state.
    pub last: Vec<f64>,
    /// The potential energy gained until the last state in two words, if it has no formula.
    pub potential: [f64; 2],
    /// The uncertainty of the potential energy, without rounding errors.
    pub quadrature_error: f64,
    /// The largest change of the energy since the start.
    pub largest_change: f64,
    /// The largest kinetic energy.
    pub largest_kinetic: f64,
}

/// The account of the energy of one motion, which is updated step by step.
#[derive(Debug)]
pub struct EnergyBalance<'a> {
    energy: &'a Energy,
    jet: Option<Jet<'a, Doubles>>,
    /// The energy of the first state by its formula, once it was computed.
    at_start: Option<f64>,
    account: EnergyAccount,
}

impl EnergyBalance<'_> {
    /// Records the energy of a state. If it has no formula, the potential is integrated along the
    /// straight line from the state before: give the states in their order, not too far apart.
    pub fn record(&mut self, moment: &Moment) {
        let (change, kinetic) = match self.energy.holds {
            Holds::Energy => self.by_formula(&moment.state),
            Holds::Forces => self.by_work(&moment.state),
        };
        let account = &mut self.account;
        account.last.clone_from(&moment.state);
        account.largest_change = larger_or_nan(account.largest_change, change.abs());
        account.largest_kinetic = larger_or_nan(account.largest_kinetic, kinetic);
    }

    /// Returns the balance to the start, for a motion in both directions of time.
    pub fn return_to_start(&mut self) {
        self.account.last.clone_from(&self.account.start);
        self.account.potential = [0.0; 2];
    }

    /// The record so far.
    #[must_use]
    pub fn account(&self) -> &EnergyAccount {
        &self.account
    }

    /// The largest change of the energy since the start divided by the largest kinetic energy, a ratio independent of the zero of the potential.
    /// Zero for a motion at rest within the rounding of a formula of the energy, NaN if the energy has no value.
    ///
    /// # Accuracy
    /// A few rounding errors of the larger one of kinetic and potential energy, from 1e-16 on.
    #[must_use]
    pub fn drift(&self) -> f64 {
        let EnergyAccount { largest_change, largest_kinetic, .. } = self.account;
        let rests = largest_kinetic <= self.rounding();
        if largest_change == 0.0 || rests { 0.0 } else { largest_change / largest_kinetic }
    }

    /// The uncertainty of the drift without rounding errors, in the same unit: zero if the energy is a formula, and otherwise the part of the
    /// work of the forces that could not be computed because of their noise, as next to a pole.
    #[must_use]
    pub fn drift_uncertainty(&self) -> f64 {
        let EnergyAccount { quadrature_error, largest_kinetic, .. } = self.account;
        if quadrature_error == 0.0 { 0.0 } else { quadrature_error / largest_kinetic }
    }

    /// The rounding error of a formula's values.
    fn rounding(&self) -> f64 {
        /// Number of sums and products whose roundings are counted.
        const ROUNDINGS: f64 = 16.0;
        ROUNDINGS * f64::EPSILON * self.at_start.map_or(0.0, f64::abs)
    }

    /// The change of the energy since the start, and the kinetic energy.
    fn by_formula(&mut self, state: &[f64]) -> (f64, f64) {
        let coordinates = self.energy.coordinates;
        let mut resting = state.to_vec();
        resting[coordinates..].fill(0.0);
        let start = match self.at_start {
            Some(start) => start,
            None => self.values(&self.account.start.clone())[0],
        };
        self.at_start = Some(start);
        let [now, potential] = [state, &resting].map(|state| self.values(state)[0]);
        (now - start, now - potential)
    }

    /// The change of the energy and the kinetic energy, from the work of the forces since the last state.
    fn by_work(&mut self, state: &[f64]) -> (f64, f64) {
        let coordinates = self.energy.coordinates;
        let from = self.account.last.clone();
        let work = work(&from, state, |position| self.values(position));
        let [high, low] = self.account.potential;
        let potential = DoubleDouble::new(high, low) + DoubleDouble::from(-work.value);
        self.account.potential = [potential.hi, potential.lo];
        self.account.quadrature_error += work.error;
        let kinetic = |state: &[f64]| {
            let speeds = state[coordinates..].iter();
            self.energy.masses.iter().zip(speeds).map(|(m, v)| 0.5 * m * v * v).sum::<f64>()
        };
        let gained = kinetic(state) - kinetic(&self.account.start);
        (potential.to_f64() + gained, kinetic(state))
    }

    /// The values of the formulas on the tape.
    fn values(&mut self, state: &[f64]) -> Vec<f64> {
        let outcome = match &mut self.jet {
            Some(jet) => jet.restart(state),
            none => Jet::new(&Doubles, &self.energy.tape, state).map(|jet| *none = Some(jet)),
        };
        let formulas = self.energy.tape.results().len();
        match (outcome, &self.jet) {
            (Ok(()), Some(jet)) => (0..formulas).map(|formula| jet.result(formula)[0]).collect(),
            _ => vec![f64::NAN; formulas],
        }
    }
}

/// The masses, if they are positive constants.
fn masses(equation: &Equation) -> Option<Vec<Expression>> {
    let inertias = equation.inertias();
    let positive = |mass: &Expression| mass.to_f64().is_some_and(|mass| mass > 0.0 && mass.is_finite());
    inertias.iter().all(positive).then_some(inertias)
}
