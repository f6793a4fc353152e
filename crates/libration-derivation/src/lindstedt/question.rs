//! Subject of a derivation: an oscillator as a Taylor series, its expansion, and the symbols of both.

use super::super::check::DerivationError;
use super::super::formula::{Formula, Name};
use super::HIGHEST_ORDER;
use libration::algebra::{Rational, Rationals};
use libration::expression::Symbol;
use libration::internals::progress::Watch;
use libration::oscillator::{Kind, Oscillator};
use libration::perturbation::{EpsilonPowers, Expansion, Gauge, OpenGauge, expand};

/// An oscillator about its equilibrium, prepared.
#[derive(Debug)]
pub struct Question {
    pub(super) oscillator: Oscillator,
    /// The variable of the equation of motion.
    pub(super) variable: Name,
    /// The displacement from the equilibrium; the variable itself if the equilibrium is zero.
    pub(super) displacement: Name,
    pub(super) equilibrium: Rational,
    pub(super) omega0_squared: Rational,
    /// The factors of u, u², … in the restoring force divided by ω0².
    pub force: Vec<Rational>,
    pub(super) order: usize,
    /// The conditions with an open gauge.
    pub open: OpenGauge,
    /// The expansion in the requested gauge.
    pub solution: Solution,
}

/// The motion in one gauge.
#[derive(Debug)]
pub struct Solution {
    pub(super) gauge: Gauge,
    pub(super) expansion: Expansion,
}

impl Question {
    /// Prepares an oscillator, an order and a gauge; rejects values that are not exact.
    pub fn new(
        oscillator: &Oscillator,
        order: usize,
        gauge: &Gauge,
        watch: &Watch<'_>,
    ) -> Result<Self, DerivationError> {
        if !(2..=HIGHEST_ORDER).contains(&order) {
            return Err(DerivationError::Order { order });
        }
        match oscillator.kind() {
            Kind::Conservative => {}
            Kind::TwoSided => return Err(DerivationError::TwoSided),
            _ => return Err(DerivationError::Velocity),
        }
        let exact = (oscillator.equilibrium().exact(), oscillator.omega0_squared().exact());
        let (Some(equilibrium), Some(omega0_squared)) = exact else {
            return Err(DerivationError::NoFractions);
        };
        let force = restoring_force(oscillator, equilibrium, omega0_squared, order);
        let force = force.ok_or(DerivationError::NoFractions)?;
        let variable = Name::from(&Symbol { name: oscillator.variable().to_owned(), primes: 0 });
        let displacement = if equilibrium.is_zero() { variable.clone() } else { Name::new("u") };
        let solution = Solution::new(oscillator, order, gauge, watch)?;
        let powers = if oscillator.is_odd() && !solution.has_even_powers() {
            EpsilonPowers::OneParity
        } else {
            EpsilonPowers::All
        };
        let open = OpenGauge::new(&force, u32::try_from(order).unwrap_or(u32::MAX), powers, watch)?;
        Ok(Self {
            oscillator: oscillator.clone(),
            variable,
            displacement,
            equilibrium: equilibrium.clone(),
            omega0_squared: omega0_squared.clone(),
            force,
            order,
            open,
            solution,
        })
    }

    /// The acceleration, as a formula of the variable.
    pub(super) fn acceleration(&self) -> Formula {
        self.oscillator.acceleration().into()
    }

    /// The restoring force divided by ω0², as a formula of the variable.
    pub(super) fn restoring_force(&self) -> Formula {
        let force = self.acceleration().negated();
        let unit = self.omega0_squared == Rational::from(1);
        if unit { force } else { force / self.omega0_squared.clone() }
    }

    /// The displacement u.
    pub(super) fn u(&self) -> Formula {
        (&self.displacement).into()
    }

    /// The largest displacement.
    pub(super) fn amplitude(&self) -> Name {
        match self.displacement.letter.as_str() {
            "θ" => Name::new("θ").index(0),
            letter => Name::new(letter).word("max"),
        }
    }

    /// Returns `true` if the motion has only the harmonics of an odd force.
    pub(super) fn is_odd(&self) -> bool {
        self.oscillator.is_odd()
    }

    /// The harmonics of the ansatz.
    pub(super) fn harmonics(&self) -> Vec<usize> {
        if self.is_odd() { (1..=self.order).step_by(2).collect() } else { (0..=self.order).collect() }
    }

    /// The powers of ε in the ansatz.
    pub(super) fn powers(&self) -> Vec<usize> {
        let odd_only = self.is_odd() && !self.solution.has_even_powers();
        (1..=self.order).step_by(if odd_only { 2 } else { 1 }).collect()
    }
}

impl Solution {
    pub fn new(
        oscillator: &Oscillator,
        order: usize,
        gauge: &Gauge,
        watch: &Watch<'_>,
    ) -> Result<Self, DerivationError> {
        Ok(Self { gauge: gauge.clone(), expansion: expand(oscillator, order, gauge, watch)? })
    }

    /// The coefficients of cos kτ, by powers of ε.
    pub(super) fn harmonic(&self, k: usize) -> Vec<Rational> {
        self.expansion.harmonic(k).map_or_else(Vec::new, |harmonic| harmonic.cos.clone())
    }

    /// The coefficient of εⁿ in a harmonic.
    pub(super) fn coefficient(&self, k: usize, n: usize) -> Rational {
        self.harmonic(k).get(n).cloned().unwrap_or_else(|| Rational::from(0))
    }

    fn has_even_powers(&self) -> bool {
        self.harmonic(1).iter().step_by(2).any(|a| !a.is_zero())
    }
}

/// The Taylor coefficients of −f(xₑ + u)/ω0², from the first up to the requested order.
fn restoring_force(
    oscillator: &Oscillator,
    equilibrium: &Rational,
    omega0_squared: &Rational,
    order: usize,
) -> Option<Vec<Rational>> {
    let x = Symbol { name: oscillator.variable().to_owned(), primes: 0 };
    let series = oscillator.acceleration().taylor_series(&Rationals, &x, equilibrium, order + 1)?;
    series[1..].iter().map(|c| (-c.clone()).checked_div(omega0_squared)).collect()
}
