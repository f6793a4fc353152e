//! The sine truncated after a power, compared with the sine.

use crate::paper::compare::{first_difference, polynomial, series_in};
use crate::paper::finding::StatementFinding;
use crate::paper::printed::Printed;
use libration::algebra::{Polynomial, Rational};
use libration::expression::Expression;

/// The finding for a truncated sine, compared exactly; an inertia term next to it is ignored.
pub(super) fn sine(formula: &Expression, through: usize) -> Option<StatementFinding> {
    let terms = through + 8;
    let polynomial = series_in("theta", terms, formula, &[("theta''", 0)])?;
    let exact = Printed::read(&["sin(theta)"])?;
    let exact = series_in("theta", terms, exact.formula(0)?, &[])?;
    let (power, error) = first_difference(&polynomial, &exact)?;
    let correct = format!("the term is {}*theta^{power}", exact[power]);
    let evidence = format!(
        "agrees with the series of the sine below theta^{power}; its error begins with {error}*theta^{power}"
    );
    Some(StatementFinding::verified_if(power > through, correct, evidence))
}

/// The finding for an equation of motion θ″ + ω0²·(…) = 0 whose bracket is the sine up to a power.
pub(super) fn equation_with_sine(printed: &Printed, through: usize) -> Option<StatementFinding> {
    let terms = through + 8;
    let equation = printed.residual(0)?;
    // At zero acceleration and with ω0 = 2 the equation is four times the sine.
    let force = series_in("theta", terms, &equation, &[("theta''", 0), ("omega0", 2)])?;
    let exact = Printed::read(&["4*sin(theta)"])?;
    let exact = series_in("theta", terms, exact.formula(0)?, &[])?;
    let (power, error) = first_difference(&exact, &force)?;
    let inertia = polynomial(&equation, &[("theta", Polynomial::zero())])?;
    let right = inertia == Polynomial::variable("theta''") && power > through;
    let quarter = |coefficient: &Rational| coefficient.divided_by_power_of_two(2);
    let evidence = format!(
        "(8) with the sine to theta^{through}, exactly; what is left out begins with {}*theta^{power}",
        quarter(&error)
    );
    let correct = format!("the force over omega0^2 has the term {}*theta^{power}", quarter(&exact[power]));
    Some(StatementFinding::verified_if(right, correct, evidence))
}
