//! The restoring force over ω0² by powers of displacement and velocity, with symbols for the factors that are not fractions.

use super::super::formula::{Formula, Name, laurent, letter, monomial, sum};
use libration::algebra::{LaurentPolynomial, Polynomial, Rational, Ring, Variable};
use libration::expression::Symbol;
use libration::internals::InOrder;
use libration::oscillator::SymbolicOscillator;
use libration::perturbation::RestoringTerm;

/// The symbols of the factors that are not fractions: with the displacement, and of powers of the velocity alone.
const FACTORS: [&str; 2] = ["f", "g"];

/// The force u + Σ factor·uᵖ·(Δu′)^q.
#[derive(Clone, Debug)]
pub(super) struct Reduced {
    /// The terms of higher than the first degree, lower degrees first.
    pub(super) terms: Vec<RestoringTerm>,
    /// The symbols in the factors, with their values in the symbols and numbers of the equation.
    pub(super) symbols: Vec<(Variable, Formula)>,
}

impl Reduced {
    /// The terms up to a degree; `None` where a factor is not a sum of products of symbols and constants.
    pub(super) fn new(oscillator: &SymbolicOscillator, degree: usize) -> Option<Self> {
        let (ring, square) = (oscillator.ring(), oscillator.omega0_squared());
        let mut powers = oscillator.powers(degree)?;
        powers.retain(|([position, velocity], _)| position + velocity > 1);
        powers.put_in_order_by(|([position, velocity], _)| position + velocity);
        let mut reduced = Self { terms: vec![], symbols: vec![] };
        let mut numerators: Vec<(Variable, LaurentPolynomial)> = vec![];
        for ([position, velocity], value) in powers {
            // Time in units of 1/ω0 gives each velocity a factor ω0.
            let per_velocity = ring.power(square, &Rational::from(i64::try_from(velocity / 2).ok()?))?;
            let numerator = ring.negate(&ring.multiply(&value, &per_velocity));
            let ratio = ring.divide(&numerator, square);
            let multiple = numerators
                .iter()
                .find_map(|(symbol, other)| Some((symbol, ring.divide(&numerator, other)?.to_constant()?)));
            let factor = match (ratio.as_ref().and_then(LaurentPolynomial::to_constant), multiple) {
                (Some(number), _) => Polynomial::constant(number),
                (None, Some((symbol, number))) => Polynomial::variable(symbol.clone()).scaled(&number),
                (None, None) => {
                    let symbol = symbol(position, velocity);
                    let formula = match &ratio {
                        Some(ratio) => in_symbols(oscillator, ratio),
                        None => in_symbols(oscillator, &numerator) / omega0().squared(),
                    };
                    reduced.symbols.push((symbol.clone(), formula));
                    numerators.push((symbol.clone(), numerator));
                    Polynomial::variable(symbol)
                }
            };
            let [position, velocity] = [position, velocity].map(|n| u32::try_from(n).unwrap_or(u32::MAX));
            reduced.terms.push(RestoringTerm { factor, position, velocity });
        }
        Some(reduced)
    }

    /// Returns `true` if all factors are fractions.
    pub(super) fn is_of_numbers(&self) -> bool {
        self.symbols.is_empty()
    }

    /// The factors of u, u², …, if they are fractions and the force depends on the displacement alone; empty otherwise.
    pub(super) fn factors(&self, order: usize) -> Vec<Rational> {
        let mut factors = vec![Rational::from(0); order];
        if let Some(first) = factors.first_mut() {
            *first = Rational::from(1);
        }
        for term in &self.terms {
            let below = usize::try_from(term.position).ok().and_then(|position| position.checked_sub(1));
            match (term.velocity, term.factor.to_constant(), below.and_then(|index| factors.get_mut(index))) {
                (0, Some(number), Some(factor)) => *factor = number,
                _ => return vec![],
            }
        }
        factors
    }

    /// The force as a formula of the displacement with this name and of its derivative with respect to Ωt.
    pub(super) fn formula(&self, displacement: &Name) -> Formula {
        self.with_velocity(displacement, &velocity(displacement))
    }

    /// The force as a formula of displacement and velocity.
    pub(super) fn with_velocity(&self, displacement: &Name, velocity: &Formula) -> Formula {
        let terms = self.terms.iter().map(|term| product(term, displacement, velocity));
        sum([displacement.into()].into_iter().chain(terms).collect())
    }

    /// The equation with the variable u, as text.
    pub(super) fn equation(&self) -> String {
        let term =
            |term: &RestoringTerm| format!(" + ({})*u^{}*u'^{}", term.factor, term.position, term.velocity);
        format!("u'' + u{} = 0", self.terms.iter().map(term).collect::<String>())
    }
}

/// The symbol of a factor: with the exponent of the displacement, and that of the velocity where there is one.
fn symbol(position: usize, velocity: usize) -> Variable {
    let [factor, of_velocity] = FACTORS;
    let (letter, index) = match (position, velocity) {
        (position, 0) => (factor, position),
        (0, velocity) => (of_velocity, velocity),
        (position, velocity) => (factor, 10 * position + velocity),
    };
    Variable::indexed(letter, u32::try_from(index).unwrap_or(u32::MAX))
}

/// A term of the force, with derivatives with respect to Ωt.
pub(super) fn term_formula(term: &RestoringTerm, displacement: &Name) -> Formula {
    product(term, displacement, &velocity(displacement))
}

/// Δu′.
fn velocity(displacement: &Name) -> Formula {
    letter("Δ") * Formula::from(displacement.clone().prime())
}

fn product(term: &RestoringTerm, displacement: &Name, velocity: &Formula) -> Formula {
    let exponent = |n: u32| usize::try_from(n).unwrap_or(usize::MAX);
    let u = Formula::from(displacement);
    match (term.position, term.velocity) {
        (position, 0) => monomial(&term.factor, &u, exponent(position)),
        (0, power) => monomial(&term.factor, velocity, exponent(power)),
        (position, power) => {
            monomial(&term.factor, &u, exponent(position)) * velocity.clone().pow(i64::from(power))
        }
    }
}

pub(super) fn omega0() -> Formula {
    Name::new("ω").index(0).into()
}

/// A sum of products of symbols, in the symbols and constants of the equation.
pub(super) fn in_symbols(oscillator: &SymbolicOscillator, of: &LaurentPolynomial) -> Formula {
    let last = oscillator.ring().letters().last();
    laurent(of, &|name| {
        let constant = oscillator.constants().iter().find(|(letter, _)| letter == name);
        match constant {
            Some((_, constant)) => constant.into(),
            None if last.is_some_and(|root| root == name) => omega0(),
            None => Formula::Name(Name::from(&Symbol::plain(name))),
        }
    })
}
