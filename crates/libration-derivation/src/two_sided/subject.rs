//! Subject of the derivation: an odd oscillator whose force has another power series on either side.

use super::super::check::DerivationError;
use super::super::formula::{Formula, Name, polynomial};
use super::super::phase::PiNumber;
use super::quarter::Quarter;
use libration::algebra::{LaurentPolynomial, Rational, Rationals};
use libration::expression::{Expression, Symbol};
use libration::internals::progress::Watch;
use libration::oscillator::Oscillator;
use libration::perturbation::{Gauge, SymbolicExpansionError, expand_with_constants};

/// An oscillator about its equilibrium, prepared and solved.
#[derive(Debug)]
pub(super) struct TwoSidedSubject {
    pub(super) oscillator: Oscillator,
    /// The variable of the equation of motion.
    pub(super) variable: Name,
    /// The displacement from the equilibrium; the variable itself if the equilibrium is zero.
    pub(super) displacement: Name,
    pub(super) equilibrium: Formula,
    pub(super) omega0_squared: Formula,
    /// The acceleration at a positive displacement.
    pub(super) above: Formula,
    pub(super) order: usize,
    pub(super) quarter: Quarter,
}

impl TwoSidedSubject {
    pub(super) fn new(oscillator: &Oscillator, order: usize) -> Result<Self, DerivationError> {
        let sides = oscillator.sides().filter(|_| oscillator.is_odd()).ok_or(DerivationError::TwoSided)?;
        let exact = (oscillator.equilibrium().exact(), oscillator.omega0_squared().exact());
        let (Some(equilibrium), Some(square)) = exact else { return Err(DerivationError::NoFractions) };
        let symbol = Symbol::plain(oscillator.variable());
        let zero = Rational::from(0);
        let series = sides.above.taylor_series(&Rationals, &symbol, &zero, order + 1);
        let over = |c: &Rational| (-c.clone()).checked_div(square);
        let force: Option<Vec<Rational>> =
            series.as_ref().and_then(|series| series.get(1..)?.iter().map(over).collect());
        let variable = Name::from(&symbol);
        let displacement = if equilibrium.is_zero() { variable.clone() } else { Name::new("u") };
        let above = written_out(&sides.above, &symbol, &displacement);
        if ["A", "d", "y", "s", "τ"].contains(&displacement.letter.as_str()) {
            return Err(DerivationError::TakenLetter { letter: displacement.letter });
        }
        let quarter = Quarter::new(&force.ok_or(DerivationError::NoFractions)?, order);
        quarter.check()?;
        Ok(Self {
            oscillator: oscillator.clone(),
            variable,
            displacement,
            equilibrium: equilibrium.clone().into(),
            omega0_squared: square.clone().into(),
            above,
            order,
            quarter,
        })
    }

    /// Compares frequency and harmonics with the library's, which are found from the potential.
    pub(super) fn agrees_with_library(&self, watch: &Watch<'_>) -> Result<(), DerivationError> {
        let outcome = expand_with_constants(&self.oscillator, self.order, &Gauge::XMax, watch);
        let expansion = outcome.map_err(|error| match error {
            SymbolicExpansionError::Expansion(error) => error.into(),
            _ => DerivationError::NoFractions,
        })?;
        let different = DerivationError::Disagreement { what: "two computations of the swing" };
        let Some(of) = expansion.and_then(|symbolic| symbolic.series.of_amplitude) else {
            return Err(different);
        };
        let same = |coefficients: &[PiNumber], other: &[LaurentPolynomial]| {
            let count = coefficients.len().min(self.order);
            coefficients
                .iter()
                .zip(other)
                .take(count)
                .all(|(coefficient, other)| in_powers_of_pi(other).as_ref() == Some(coefficient))
        };
        let is_same = |(k, other): &(usize, Vec<LaurentPolynomial>)| {
            *k > self.order || same(&self.quarter.harmonic(*k), other)
        };
        let all = same(&self.quarter.ratio, &of.frequency_ratio) && of.harmonics.iter().all(is_same);
        if all { Ok(()) } else { Err(different) }
    }

    pub(super) fn is_at_zero(&self) -> bool {
        self.variable == self.displacement
    }

    /// The acceleration, as a formula of the variable.
    pub(super) fn acceleration(&self) -> Formula {
        self.oscillator.acceleration().into()
    }

    /// The displacement u.
    pub(super) fn u(&self) -> Formula {
        (&self.displacement).into()
    }

    /// uₙ.
    pub(super) fn part(&self, n: usize) -> Name {
        self.displacement.clone().index(i64::try_from(n).unwrap_or(i64::MAX))
    }

    /// T/T0 by powers of the amplitude.
    pub(super) fn period_ratio(&self) -> Vec<PiNumber> {
        let ratio = &self.quarter.ratio;
        let mut inverse = vec![PiNumber::from(Rational::from(1))];
        for n in 1..ratio.len() {
            let next = (1..=n).fold(PiNumber::default(), |sum, m| sum.plus(&ratio[m].times(&inverse[n - m])));
            inverse.push(next.negated());
        }
        inverse
    }
}

/// A function of a displacement with this name: its powers, if it is a polynomial.
fn written_out(function: &Expression, symbol: &Symbol, displacement: &Name) -> Formula {
    let degree = function.polynomial_degree(std::slice::from_ref(symbol));
    let length = degree.and_then(|degree| usize::try_from(degree).ok()?.checked_add(1));
    let zero = Rational::from(0);
    let powers = length.and_then(|length| function.taylor_series(&Rationals, symbol, &zero, length));
    match powers {
        Some(powers) => polynomial(&powers, &displacement.into()),
        None => {
            let symbol_of_displacement = Expression::Symbol(Symbol::plain(&displacement.letter));
            (&function.substitute(symbol, &symbol_of_displacement).simplified()).into()
        }
    }
}

/// A polynomial in π and its inverse; `None` for other letters and roots.
fn in_powers_of_pi(of: &LaurentPolynomial) -> Option<PiNumber> {
    of.terms().try_fold(PiNumber::default(), |sum, (factor, powers)| {
        let exponent = match powers.as_slice() {
            [] => 0,
            [power] if power.letter == "pi" => power.exponent.to_string().parse().ok()?,
            _ => return None,
        };
        Some(sum.plus(&PiNumber::from(factor.clone()).times_power_of_pi(exponent)))
    })
}
