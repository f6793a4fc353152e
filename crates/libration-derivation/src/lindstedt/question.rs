//! Subject of a derivation: an oscillator as a Taylor series, its expansion, and the symbols of both.

use super::super::check::{DerivationError, Given, chosen};
use super::super::formula::{Formula, Name, sqrt};
use super::HIGHEST_ORDER;
use super::reduced::{Reduced, in_symbols};
use super::solution::Solution;
use libration::algebra::{Rational, Variable};
use libration::expression::{Expression, Symbol};
use libration::internals::progress::Watch;
use libration::oscillator::{Kind, NumbersOrLetters, Oscillator, SymbolicOscillator};
use libration::perturbation::{EpsilonPowers, Gauge, OpenGauge, RestoringTerm};

/// An oscillator about its equilibrium, prepared.
#[derive(Debug)]
pub struct LindstedtQuestion {
    /// The oscillator, if its numbers are fractions.
    pub(super) oscillator: Option<Oscillator>,
    /// The oscillator with symbols for all that is not a fraction.
    pub(super) symbolic: SymbolicOscillator,
    /// The variable of the equation of motion.
    pub(super) variable: Name,
    /// The displacement from the equilibrium; the variable itself if the equilibrium is zero.
    pub(super) displacement: Name,
    pub(super) equilibrium: Formula,
    pub(super) omega0_squared: Formula,
    pub(super) reduced: Reduced,
    /// The factors of u, u², … in the restoring force divided by ω0², if they are fractions and nothing depends on the velocity; empty otherwise.
    pub force: Vec<Rational>,
    pub(super) order: usize,
    /// The conditions with an open gauge.
    pub open: OpenGauge,
    /// The expansion in the requested gauge.
    pub solution: Solution,
}

impl LindstedtQuestion {
    /// Prepares an oscillator, an order and a gauge; rejects values that are not exact.
    pub fn new(
        oscillator: &Oscillator,
        order: usize,
        gauge: &Gauge,
        watch: &Watch<'_>,
    ) -> Result<Self, DerivationError> {
        match oscillator.kind() {
            Kind::Conservative | Kind::Reversible => {}
            Kind::TwoSided => return Err(DerivationError::TwoSided),
            _ => return Err(DerivationError::Velocity),
        }
        let equilibrium = oscillator.equilibrium().exact().ok_or(DerivationError::NoFractions)?;
        let equilibrium_value = Expression::Number(equilibrium.clone());
        let symbolic = SymbolicOscillator::about(oscillator.equation(), &equilibrium_value);
        let symbolic = symbolic.map_err(|_| DerivationError::NoFractions)?;
        Self::of_either(Some(oscillator), symbolic, [order, order], gauge, watch)
    }

    /// Prepares an oscillator with numbers or symbols.
    pub(super) fn of(
        oscillator: &NumbersOrLetters,
        order: usize,
        gauge: &Gauge,
        watch: &Watch<'_>,
    ) -> Result<Self, DerivationError> {
        match oscillator {
            NumbersOrLetters::Numbers(oscillator) => Self::new(oscillator, order, gauge, watch),
            NumbersOrLetters::Letters(oscillator) => {
                Self::of_either(None, oscillator.clone(), [order, order], gauge, watch)
            }
        }
    }

    /// The same oscillator to another order, in another gauge.
    pub(super) fn again(
        &self,
        order: usize,
        gauge: &Gauge,
        watch: &Watch<'_>,
    ) -> Result<Self, DerivationError> {
        let degree = order.max(self.order);
        Self::of_either(self.oscillator.as_ref(), self.symbolic.clone(), [order, degree], gauge, watch)
    }

    fn of_either(
        oscillator: Option<&Oscillator>,
        symbolic: SymbolicOscillator,
        [order, degree]: [usize; 2],
        gauge: &Gauge,
        watch: &Watch<'_>,
    ) -> Result<Self, DerivationError> {
        if !(2..=HIGHEST_ORDER).contains(&order) {
            return Err(DerivationError::Order { order });
        }
        if !matches!(symbolic.kind(), Kind::Conservative | Kind::Reversible) {
            return Err(DerivationError::Velocity);
        }
        let reduced = Reduced::new(&symbolic, degree).ok_or(DerivationError::NoFractions)?;
        let variable = Name::from(&Symbol::plain(symbolic.variable()));
        let is_at_zero = symbolic.equilibrium().is_zero();
        let displacement = if is_at_zero { variable.clone() } else { Name::new("u") };
        let is_exact = oscillator.is_some_and(|oscillator| oscillator.omega0_squared().exact().is_some());
        let oscillator = oscillator.filter(|_| is_exact && reduced.is_of_numbers()).cloned();
        let solution = Solution::new(oscillator.as_ref(), &reduced, order, gauge, watch)?;
        let powers = if symbolic.is_odd() && !solution.has_even_powers() {
            EpsilonPowers::OneParity
        } else {
            EpsilonPowers::All
        };
        let highest = u32::try_from(order).unwrap_or(u32::MAX);
        let open = OpenGauge::of_terms(&reduced.terms, highest, powers, watch)?;
        Ok(Self {
            variable,
            displacement,
            equilibrium: in_symbols(&symbolic, symbolic.equilibrium()),
            omega0_squared: in_symbols(&symbolic, symbolic.omega0_squared()),
            force: reduced.factors(order),
            oscillator,
            symbolic,
            reduced,
            order,
            open,
            solution,
        })
    }

    /// The acceleration, as a formula of the variable.
    pub(super) fn acceleration(&self) -> Formula {
        Formula::from(&self.symbolic.equation().accelerations()[0])
    }

    /// Returns `true` if the derivation has symbols, or a velocity in the force.
    pub(super) fn is_reduced(&self) -> bool {
        self.force.is_empty() || self.oscillator.is_none()
    }

    /// The restoring force divided by ω0²: as a formula of the variable, or where there are symbols or velocities by powers of the displacement.
    pub(super) fn restoring_force(&self) -> Formula {
        if self.is_reduced() { self.reduced.formula(&self.displacement) } else { self.whole_force() }
    }

    /// The restoring force divided by ω0², as a formula of the variable.
    pub(super) fn whole_force(&self) -> Formula {
        let force = self.acceleration().negated();
        match &self.omega0_squared {
            Formula::Number(one) if *one == Rational::from(1) => force,
            square => force / square.clone(),
        }
    }

    /// The terms of the force besides the displacement.
    pub(super) fn terms(&self) -> impl Iterator<Item = &RestoringTerm> {
        let is_present = |term: &&RestoringTerm| !term.factor.is_zero();
        let highest = u32::try_from(self.order).unwrap_or(u32::MAX);
        self.reduced
            .terms
            .iter()
            .filter(is_present)
            .filter(move |term| term.position + term.velocity <= highest)
    }

    /// Returns `true` if the force depends on the velocity.
    pub(super) fn has_velocity(&self) -> bool {
        self.reduced.terms.iter().any(|term| term.velocity > 0)
    }

    /// The symbols in the factors of the force.
    pub(super) fn symbols(&self) -> impl Iterator<Item = &Variable> {
        self.reduced.symbols.iter().map(|(symbol, _)| symbol)
    }

    /// The symbols, as free ones.
    pub(super) fn free_symbols<'a>(&self) -> Vec<Given<'a>> {
        self.symbols().cloned().map(Given::Symbol).collect()
    }

    /// Fractions for the symbols of the equation, with ω0 and the symbols of the force.
    pub(super) fn values_of_symbols<'a>(&self, choice: usize) -> Vec<Given<'a>> {
        let letters = self.symbolic.letters().iter().map(|name| Name::from(&Symbol::plain(name)));
        let root = Name::new("ω").index(0);
        let has_root = letters.clone().any(|name| name == root);
        let of = |(index, name): (usize, Name)| Given::Value(name, chosen(index, choice).into());
        let mut given: Vec<Given<'_>> = letters.enumerate().map(of).collect();
        if !has_root {
            given.push(Given::Value(root, sqrt(self.omega0_squared.clone())));
        }
        let symbols = self.reduced.symbols.iter();
        given.extend(symbols.map(|(symbol, value)| Given::Value(Name::from(symbol), value.clone())));
        given
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
        self.symbolic.is_odd()
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
