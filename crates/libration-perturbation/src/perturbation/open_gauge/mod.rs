//! The Lindstedt–Poincaré equations order by order with an open gauge: the coefficients that they determine,
//! and those that they leave free.

mod expansion;

use std::collections::{BTreeMap, BTreeSet};

use expansion::{Ansatz, OpenExpansion, coefficient, frequency_correction};
use libration_numbers::algebra::{Polynomial, Rational, Variable};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Interrupted, Progress, Stage};

/// The powers of ε in the ansatz.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EpsilonPowers {
    /// Odd powers in the harmonics and even ones in Ω, sufficient for an odd force.
    OneParity,
    /// All powers.
    All,
}

/// A condition for the equation of motion to hold in one harmonic at one order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Condition {
    /// The power of ε.
    pub order: u32,
    /// The k of cos kΩt.
    pub harmonic: u32,
    /// The coefficient of ε^order cos kΩt on the left side of Δ²x″ + g(x)/ω0² = 0.
    pub polynomial: Polynomial,
}

/// A term of the restoring force over ω0²: factor·xᵖ·(Δx′)^q, with a prime for a derivative with respect to Ωt.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RestoringTerm {
    /// The factor: a number, or a polynomial in symbols.
    pub factor: Polynomial,
    /// The exponent of the displacement.
    pub position: u32,
    /// The exponent of the velocity, an even number.
    pub velocity: u32,
}

/// The expansion of a motion about its equilibrium, with every coefficient a symbol.
///
/// The equation of motion is ẍ + g(x) = 0 with g(x) = ω0²x + …. The ansatz is x = Σ aₖ(ε) cos kΩt and
/// Ω/ω0 = Δ = 1 + d₁ε + d₂ε² + …. The coefficients of εⁿ are called Aₙ, Bₙ, Cₙ, Dₙ, … in a₁, a₃, a₅, a₇, … and
/// Pₙ, Qₙ, Rₙ, … in a₀, a₂, a₄, …. The conditions leave A₁, A₂, A₃, … free: they are the gauge, the meaning of ε.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::perturbation::{OpenGauge, EpsilonPowers};
/// use libration::progress::Quiet;
/// // sin θ up to the fifth power.
/// let sine = ["1", "0", "-1/6", "0", "1/120"].map(|text| text.parse().unwrap());
/// let pendulum = OpenGauge::new(&sine, 5, EpsilonPowers::OneParity, &Quiet)?;
/// assert_eq!(pendulum.solution()[&"d4".into()].to_string(), "-A1*A3/8 + A1^4/1024");
/// assert_eq!(pendulum.free_constants().len(), 3);
/// # Ok::<(), libration::perturbation::OpenGaugeError>(())
/// ```
///
/// # References
/// B. Black and V. Vel, Am. J. Phys. **91**, 776 (2023), equations (32)–(38) and appendices A and B.
#[derive(Clone, Debug)]
pub struct OpenGauge {
    ansatz: Ansatz,
    force: Vec<RestoringTerm>,
    conditions: Vec<Condition>,
    solution: BTreeMap<Variable, Polynomial>,
}

impl OpenGauge {
    /// The largest order.
    pub const MAX_ORDER: u32 = 15;

    /// The conditions up to ε^order for a restoring force g(x) = g₁x + g₂x² + … given by g₁, g₂, …; further
    /// coefficients are zero. [`restoring_force`](super::restoring_force) gives that of an oscillator.
    ///
    /// # Errors
    /// When the order is not between 1 and [`MAX_ORDER`](Self::MAX_ORDER), g₁ is not positive, or the force has
    /// an even term while the ansatz has one parity.
    /// [`OpenGaugeError::Interrupted`] if the call is cancelled.
    pub fn new(
        restoring_force: &[Rational],
        order: u32,
        powers: EpsilonPowers,
        progress: &dyn Progress,
    ) -> Result<Self, OpenGaugeError> {
        let force = over_linear_term(restoring_force).ok_or(OpenGaugeError::NotRestoring)?;
        let term = |(position, factor): (u32, Rational)| RestoringTerm {
            factor: Polynomial::constant(factor),
            position,
            velocity: 0,
        };
        let terms: Vec<RestoringTerm> = (1..).zip(force).map(term).skip(1).collect();
        Self::of_terms(&terms, order, powers, progress)
    }

    /// The same for a force x + Σ factor·xᵖ·(Δx′)^q whose further terms are given: with symbols in the factors, and with even powers of the
    /// velocity.
    ///
    /// # Errors
    /// As [`new`](Self::new); also an odd power of the velocity.
    pub fn of_terms(
        terms: &[RestoringTerm],
        order: u32,
        powers: EpsilonPowers,
        progress: &dyn Progress,
    ) -> Result<Self, OpenGaugeError> {
        if !(1..=Self::MAX_ORDER).contains(&order) {
            return Err(OpenGaugeError::Order { order });
        }
        let degree = |term: &RestoringTerm| term.position + term.velocity;
        let present = || terms.iter().filter(|term| !term.factor.is_zero());
        if present().any(|term| term.velocity % 2 == 1) {
            return Err(OpenGaugeError::OddVelocity);
        }
        let even = present().map(degree).find(|degree| degree % 2 == 0);
        if let (EpsilonPowers::OneParity, Some(power)) = (powers, even) {
            return Err(OpenGaugeError::EvenTerm { power });
        }
        let ansatz = Ansatz::new(order, powers, even.is_some());
        let force: Vec<RestoringTerm> = present().filter(|term| degree(term) <= order).cloned().collect();
        let (conditions, solution) = solve(&ansatz, &force, &Watch::new(progress))?;
        Ok(Self { ansatz, force, conditions, solution })
    }

    /// The conditions order by order; with the solutions of lower orders inserted. The condition of the first
    /// order and the first harmonic is 0 = 0 by the choice of ω0.
    #[must_use]
    pub fn conditions(&self) -> &[Condition] {
        &self.conditions
    }

    /// The conditions without solutions inserted: the system of equations in all the unknowns at once. `None`
    /// above order 9 with one parity and order 6 with all powers, because the number of terms grows very fast:
    /// for the pendulum 115, 1303 and 15 025 at orders 5, 7 and 9.
    #[must_use]
    pub fn whole_system(&self) -> Option<Vec<Condition>> {
        let mut expansion = OpenExpansion::new(&self.ansatz, &self.force);
        let orders = &self.ansatz.orders;
        let manageable = orders.last() <= Some(&if orders.contains(&2) { 6 } else { 9 });
        manageable.then(|| orders.iter().flat_map(|order| expansion.conditions(*order)).collect())
    }

    /// Every coefficient that the conditions fix, as a polynomial in A₁, A₂, A₃, ….
    #[must_use]
    pub const fn solution(&self) -> &BTreeMap<Variable, Polynomial> {
        &self.solution
    }

    /// All coefficients of the ansatz.
    #[must_use]
    pub fn unknowns(&self) -> BTreeSet<Variable> {
        let Ansatz { orders, harmonics, .. } = &self.ansatz;
        let coefficients = orders.iter().flat_map(|n| harmonics.iter().map(|k| coefficient(*k, *n)));
        coefficients.chain(orders.iter().filter(|n| **n > 1).map(|n| frequency_correction(n - 1))).collect()
    }

    /// The coefficients that no condition fixes: A₁, A₂, A₃, …, as far as the ansatz has them.
    #[must_use]
    pub fn free_constants(&self) -> BTreeSet<Variable> {
        self.unknowns().into_iter().filter(|unknown| !self.solution.contains_key(unknown)).collect()
    }

    /// The solution in one gauge, with Aₙ from `free`.
    #[must_use]
    pub fn in_gauge(&self, free: impl Fn(u32) -> Rational) -> BTreeMap<Variable, Rational> {
        let chosen = |variable: &Variable| variable.index().map(&free);
        let free_constants = self.free_constants().into_iter().map(|variable| {
            let value = chosen(&variable);
            (variable, value)
        });
        let fixed =
            self.solution.iter().map(|(variable, polynomial)| (variable.clone(), polynomial.value(chosen)));
        free_constants.chain(fixed).filter_map(|(variable, value)| Some((variable, value?))).collect()
    }

    /// The symbol of the coefficient of a power of ε in a harmonic, such as B₅ for the third harmonic.
    #[must_use]
    pub fn coefficient_name(harmonic: u32, order: u32) -> Variable {
        coefficient(harmonic, order)
    }
}

/// The reason why there are no equations order by order.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum OpenGaugeError {
    /// The order is 0 or too large.
    #[error("the order is {order}; with the gauge left open it can be 1 to {}", OpenGauge::MAX_ORDER)]
    Order {
        /// The order that was given.
        order: u32,
    },
    /// g₁ ≤ 0.
    #[error("the force has no linear term that pulls back to the equilibrium; perturbation starts from one")]
    NotRestoring,
    /// An even term with an ansatz of odd powers.
    #[error("the force has a term in x^{power}, so the expansion needs all powers, not only odd ones")]
    EvenTerm {
        /// The exponent.
        power: u32,
    },
    /// An odd power of the velocity, with which the motion does not retrace its path.
    #[error("the force has an odd power of the velocity, so the motion does not retrace its path")]
    OddVelocity,
    /// Cancellation by the caller.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

/// g(x)/g₁ term by term; `None` unless g₁ > 0.
pub(super) fn over_linear_term(restoring_force: &[Rational]) -> Option<Vec<Rational>> {
    let linear = restoring_force.first().filter(|linear| **linear > Rational::from(0))?;
    restoring_force.iter().map(|term| term.checked_div(linear)).collect()
}

/// Solves the conditions order by order: each fixes one coefficient of its harmonic, and that of the
/// fundamental the frequency.
fn solve(
    ansatz: &Ansatz,
    force: &[RestoringTerm],
    watch: &Watch<'_>,
) -> Result<(Vec<Condition>, BTreeMap<Variable, Polynomial>), Interrupted> {
    let (mut conditions, mut solution) = (Vec::new(), BTreeMap::new());
    let mut expansion = OpenExpansion::new(ansatz, force);
    watch.begin(Stage::Whole, Some(ansatz.orders.len()));
    for (done, order) in ansatz.orders.iter().enumerate() {
        watch.reached(done)?;
        let new = expansion.conditions(*order);
        solution.extend(new.iter().filter_map(Condition::solved));
        expansion.insert(*order, &solution);
        conditions.extend(new);
    }
    Ok((conditions, solution))
}

impl Condition {
    /// The coefficient that this condition fixes, and its value; `None` for 0 = 0.
    ///
    /// Harmonic k ≠ 1 has (1 − k²) before its coefficient, the fundamental −2A₁ before the correction of the
    /// frequency, by which the rest can be divided: ε enters only through a₁ = A₁ε + ….
    fn solved(&self) -> Option<(Variable, Polynomial)> {
        let unknown = match self.harmonic {
            1 => frequency_correction(self.order.checked_sub(1)?),
            harmonic => coefficient(harmonic, self.order),
        };
        let rest = self.polynomial.coefficient(&unknown, 0);
        let value = (-rest).divide_exactly(&self.polynomial.coefficient(&unknown, 1))?;
        Some((unknown, value))
    }
}
