//! Equations of motion, and forms of solutions, order by order in ε.

use crate::paper::compare::polynomial;
use crate::paper::cosines::second_derivative;
use crate::paper::evaluate::value;
use crate::paper::finding::StatementFinding;
use crate::paper::lindstedt::Expansion;
use libration::algebra::{Polynomial, Polynomials, Rational, Ring};
use libration::expression::Expression;
use libration::series::PowerSeries;

/// The coefficients of ε⁰, ε¹, … as one polynomial.
pub(super) fn in_epsilon(coefficients: &[Polynomial]) -> Polynomial {
    let epsilon = Polynomial::variable("epsilon");
    let terms = (0..).zip(coefficients).map(|(n, coefficient)| epsilon.pow(n) * coefficient.clone());
    terms.fold(Polynomial::zero(), |sum, term| sum + term)
}

/// The variable to which the dots of an equation refer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Clock {
    /// The time t, in units of 1/ω0.
    Time,
    /// The phase Ωt.
    Phase,
}

/// An equation of motion at each order in ε, for this motion and Ω/ω0, with ω0 = 1.
pub(super) fn orders_of(
    equation: &Expression,
    motion: &[Polynomial],
    frequency: &[Polynomial],
    clock: Clock,
) -> Option<Vec<Polynomial>> {
    let ring = PowerSeries { coefficients: Polynomials, terms: motion.len() };
    let inertia: Vec<Polynomial> = motion.iter().map(second_derivative).collect();
    let frequency = frequency.to_vec();
    let acceleration = match clock {
        Clock::Time => ring.multiply(&ring.multiply(&frequency, &frequency), &inertia),
        Clock::Phase => inertia,
    };
    value(&ring, equation, &|name| match name {
        "theta" => Some(motion.to_vec()),
        "theta''" => Some(acceleration.clone()),
        "omega0" => ring.rational(&Rational::from(1)),
        "Delta" => Some(frequency.clone()),
        _ => None,
    })
}

/// The finding for a printed form, some of whose symbols are replaced: with the computed values of
/// its constants it must equal the computed result, each constant with the power of ε in its name.
pub(super) fn form(
    formula: &Expression,
    replaced: &[(&str, Polynomial)],
    computed: &[Polynomial],
    expansion: &Expansion,
) -> Option<StatementFinding> {
    let stands = polynomial(formula, replaced)?;
    let orders_agree = stands.terms().all(|(monomial, _)| {
        let orders =
            monomial.factors().iter().filter(|(name, _)| expansion.named(&name.to_string()).is_some());
        let order: u32 = orders.map(|(name, _)| name.index().unwrap_or(0)).sum();
        order == monomial.exponent(&"epsilon".into())
    });
    let mut inserted = stands.clone();
    let mut values = Vec::new();
    for name in stands.variables() {
        let Some(value) = expansion.named(&name.to_string()) else { continue };
        if value != Polynomial::variable(name.clone()) {
            inserted = inserted.substitute(&name, &value);
            values.push(format!("{name} = {value}"));
        }
    }
    let expected = in_epsilon(computed);
    let with = if values.is_empty() { "the constants open".to_owned() } else { values.join(", ") };
    let evidence = format!(
        "definition; consistent: the solution to epsilon^{} has this form with {with}, exactly",
        computed.len() - 1
    );
    Some(StatementFinding::verified_if(orders_agree && inserted == expected, expected.to_string(), evidence))
}
