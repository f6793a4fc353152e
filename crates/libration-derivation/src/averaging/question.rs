//! Subject of a derivation: an oscillator under a weak force, in powers of displacement, velocity and the small parameter, with its symbols.

use super::super::check::{DerivationError, FlowTerms, ForceTerm};
use super::super::formula::{Formula, Name, Subscript, letter};
use super::super::renaming::Renaming;
use libration::algebra::{Rational, Rationals};
use libration::expression::{Equation, Symbol};
use libration::oscillator::Kind;
use libration::perturbation::WeakForce;

/// The highest power of the amplitude that is derived step by step.
pub const HIGHEST_AMPLITUDE_ORDER: usize = 9;
/// The highest power of the small parameter that is derived step by step.
pub const HIGHEST_DAMPING_ORDER: usize = 4;

/// Symbols of the derivations by averaging and of limit cycles, with any subscript.
const TAKEN: [&str; 5] = ["A", "ψ", "v", "π", "τ"];
/// Symbols of them with a number as subscript: coefficients, polynomials and remainders.
const NUMBERED: [&str; 6] = ["a", "t", "w", "R", "Ω", "ω"];

/// An oscillator and the weak force on it, prepared.
#[derive(Debug)]
pub struct AveragingQuestion {
    pub(crate) equation: Equation,
    pub(crate) force: WeakForce,
    /// The variable of the equation of motion.
    pub(crate) variable: Name,
    /// The displacement from the equilibrium; the variable itself if the equilibrium is zero.
    pub(crate) displacement: Name,
    /// The small parameter.
    pub(crate) parameter: Name,
    pub(crate) equilibrium: Rational,
    pub(crate) flow: FlowTerms,
    /// `true` if the restoring force is a polynomial, so that its series terminates.
    pub(crate) is_whole: bool,
    /// The highest power of the amplitude.
    pub(crate) order: usize,
    /// The highest power of the small parameter.
    pub(crate) parameter_order: usize,
}

impl AveragingQuestion {
    /// The prepared equation with another symbol for a small parameter that has another meaning in the derivation, which may have further symbols.
    pub(crate) fn renamed(
        equation: &Equation,
        parameter: Option<&str>,
        orders: [usize; 2],
        further: &[&str],
    ) -> Result<(Self, Renaming), DerivationError> {
        let small = WeakForce::new(equation, parameter)?.parameter;
        let variable = equation.variables().first().map_or("", String::as_str);
        let renaming =
            Renaming::new([&small].into_iter(), variable, |name| is_taken(name, further, variable))?;
        let question = Self::new(&renaming.of(equation)?, Some(&renaming.replaced(&small)), orders)?;
        Ok((question, renaming))
    }

    /// Prepares an equation, its small parameter and the highest powers of amplitude and parameter.
    pub fn new(
        equation: &Equation,
        parameter: Option<&str>,
        [order, parameter_order]: [usize; 2],
    ) -> Result<Self, DerivationError> {
        if !(1..=HIGHEST_AMPLITUDE_ORDER).contains(&order) {
            return Err(DerivationError::AmplitudeOrder { order });
        }
        if !(1..=HIGHEST_DAMPING_ORDER).contains(&parameter_order) {
            return Err(DerivationError::DampingOrder { order: parameter_order });
        }
        let force = WeakForce::new(equation, parameter)?;
        let oscillator = &force.oscillator;
        if *oscillator.kind() != Kind::Conservative {
            return Err(DerivationError::Velocity);
        }
        let exact = (oscillator.equilibrium().exact(), oscillator.omega0_squared().exact());
        let (Some(equilibrium), Some(square)) = exact else { return Err(DerivationError::NoFractions) };
        let omega0 = square.square_root().ok_or(DerivationError::NoFractionalFrequency)?;
        let equilibrium = equilibrium.clone();
        let variable = Name::from(&Symbol::plain(oscillator.variable()));
        let displacement = if equilibrium.is_zero() { variable.clone() } else { Name::new("u") };
        let terms = terms(&force, &equilibrium, order + 1).ok_or(DerivationError::NoPolynomial)?;
        let linear = ForceTerm { factor: square.clone(), position: 1, velocity: 0, parameter: 0 };
        let terms: Vec<ForceTerm> = terms.into_iter().filter(|term| *term != linear).collect();
        let lift = usize::from(terms.iter().any(|term| term.position + term.velocity == 0));
        let counts = |term: &ForceTerm| term.position + term.velocity + lift * term.parameter <= order;
        let (terms, beyond): (Vec<_>, Vec<_>) = terms.into_iter().partition(counts);
        let symbol = Symbol::plain(oscillator.variable());
        let is_whole = beyond.iter().all(|term| term.parameter > 0)
            && oscillator
                .acceleration()
                .polynomial_degree(&[symbol])
                .is_some_and(|degree| usize::try_from(degree).is_ok_and(|degree| degree <= order));
        let parameter = Name::from(&Symbol::plain(&force.parameter));
        let kinked = force.kinked;
        let flow = FlowTerms { omega0, terms, kinked, lift };
        let question = Self {
            is_whole,
            equation: equation.clone(),
            force,
            variable,
            displacement,
            parameter,
            equilibrium,
            flow,
            order,
            parameter_order,
        };
        match TAKEN.contains(&&*question.variable.letter) {
            true => {
                Err(DerivationError::TakenLetter { letter: question.force.oscillator.variable().to_owned() })
            }
            false => Ok(question),
        }
    }

    /// The given acceleration, as a formula of the variable, its velocity and the small parameter.
    pub(crate) fn acceleration(&self) -> Formula {
        Formula::from(&self.equation.accelerations()[0])
    }

    /// The displacement u.
    pub(crate) fn u(&self) -> Formula {
        (&self.displacement).into()
    }

    /// The small parameter as a formula.
    pub(crate) fn small(&self) -> Formula {
        (&self.parameter).into()
    }

    /// ω0, as a number.
    pub(crate) fn omega0(&self) -> &Rational {
        &self.flow.omega0
    }

    /// The terms of first order in the small parameter.
    pub(crate) fn weak_terms(&self) -> impl Iterator<Item = &ForceTerm> {
        self.flow.terms.iter().filter(|term| term.parameter == 1)
    }

    /// The terms of the force without the small parameter.
    pub(crate) fn restoring_terms(&self) -> impl Iterator<Item = &ForceTerm> {
        self.flow.terms.iter().filter(|term| term.parameter == 0)
    }

    /// The power n and the factor, if the weak force is c·x′|x′|ⁿ⁻¹ alone.
    pub(crate) fn power_law(&self) -> Option<(usize, Rational)> {
        let mut weak = self.flow.terms.iter().filter(|term| term.parameter > 0);
        let (term, None) = (weak.next()?, weak.next()) else { return None };
        let is_alone = term.position == 0 && term.parameter == 1;
        // While x falls, the damping force is −c·(−x′)ⁿ.
        let sign = if self.flow.kinked && term.velocity.is_multiple_of(2) { -1 } else { 1 };
        let is_damping = term.velocity % 2 == 1 || self.flow.kinked;
        let factor = term.factor.clone() * Rational::from(sign);
        (is_alone && is_damping && !factor.is_negative()).then_some((term.velocity, factor))
    }

    /// Returns `true` if a pair of powers is within the requested orders; if the
    /// parameter counts as a power of the amplitude, the sum of both is compared.
    pub(crate) fn asks_for(&self, (n, j): (usize, usize)) -> bool {
        n + self.flow.lift * j <= self.order && j <= self.parameter_order
    }

    /// Returns `true` if the acceleration changes its sign together with displacement and velocity.
    pub(crate) fn is_odd(&self) -> bool {
        self.flow.kinked || self.flow.terms.iter().all(|term| (term.position + term.velocity) % 2 == 1)
    }

    /// Returns `true` if time reversal is equivalent to a change of sign of the small parameter.
    pub(crate) fn is_reversed_by_its_parameter(&self) -> bool {
        let reversed = |term: &ForceTerm| (term.velocity + term.parameter).is_multiple_of(2);
        match self.flow.kinked {
            true => self.power_law().is_some(),
            false => self.flow.terms.iter().all(reversed),
        }
    }

    /// The number of half turns after which the motion is known: one if the next half swing is the opposite of this one.
    pub(crate) fn half_turns(&self) -> usize {
        if self.is_odd() { 1 } else { 2 }
    }

    /// A.
    pub(crate) fn amplitude(&self) -> Formula {
        letter("A")
    }
}

fn is_taken(name: &str, further: &[&str], variable: &str) -> bool {
    let Name { letter, subscript, .. } = Name::from(&Symbol::plain(name));
    let is_numbered = matches!(subscript, Some(Subscript::Index(_)));
    let of_displacement = Name::from(&Symbol::plain(variable)).letter;
    TAKEN.iter().chain(further).any(|taken| *taken == letter)
        || is_numbered && (NUMBERED.contains(&&*letter) || letter == of_displacement)
}

/// The terms of x″ + … = 0 except the first.
fn terms(force: &WeakForce, equilibrium: &Rational, highest: usize) -> Option<Vec<ForceTerm>> {
    let x = Symbol::plain(force.oscillator.variable());
    let (v, c) = (x.with_primes(1), Symbol::plain(&force.parameter));
    let degree = |symbol: &Symbol| force.acceleration.polynomial_degree(std::slice::from_ref(symbol));
    let (velocities, parameters) = (degree(&v)?, degree(&c)?);
    let mut terms = Vec::new();
    let mut of_parameter = force.acceleration.clone();
    for parameter in 0..=parameters {
        let mut of_velocity = of_parameter.clone();
        for velocity in 0..=velocities {
            let at_zero = of_velocity.substitute(&v, &0.into()).substitute(&c, &0.into());
            let length = highest + 1;
            let series = at_zero.simplified().taylor_series(&Rationals, &x, equilibrium, length)?;
            let scale = Rational::from(-factorial(velocity) * factorial(parameter));
            for (position, coefficient) in
                series.into_iter().enumerate().filter(|(_, value)| !value.is_zero())
            {
                let factor = coefficient.checked_div(&scale)?;
                let [velocity, parameter] =
                    [velocity, parameter].map(|n| usize::try_from(n).unwrap_or(usize::MAX));
                terms.push(ForceTerm { factor, position, velocity, parameter });
            }
            of_velocity = of_velocity.derivative(&v).simplified();
        }
        of_parameter = of_parameter.derivative(&c).simplified();
    }
    let conservative = |term: &ForceTerm| term.parameter > 0 || term.velocity == 0;
    terms.iter().all(conservative).then_some(terms)
}

fn factorial(n: u32) -> i64 {
    (1..=i64::from(n)).product()
}
