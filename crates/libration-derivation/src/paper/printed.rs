//! Printed formulas of a document, parsed from text: expressions, and equations with two or more sides.

use libration::algebra::Rational;
use libration::expression::Expression;

use super::evaluate::written;

/// The formulas of a statement; an equation is the list of its sides.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Printed {
    equations: Vec<Vec<Expression>>,
}

impl Printed {
    pub(super) fn read(texts: &[&str]) -> Option<Self> {
        let sides = |text: &&str| text.split('=').map(|side| side.parse().ok()).collect::<Option<Vec<_>>>();
        Some(Self { equations: texts.iter().map(sides).collect::<Option<Vec<_>>>()? })
    }

    /// The last side of an equation, the printed value of the quantity on the left.
    pub(super) fn formula(&self, equation: usize) -> Option<&Expression> {
        self.equations.get(equation)?.last()
    }

    /// The first side of an equation.
    pub(super) fn left(&self, equation: usize) -> Option<&Expression> {
        self.equations.get(equation)?.first()
    }

    /// All sides of an equation.
    pub(super) fn sides(&self, equation: usize) -> Option<&[Expression]> {
        self.equations.get(equation).map(Vec::as_slice)
    }

    /// The first side minus the last: zero if the equation holds.
    pub(super) fn residual(&self, equation: usize) -> Option<Expression> {
        let (left, right) = (self.left(equation)?.clone(), self.formula(equation)?.clone());
        Some(Expression::Subtract(Box::new(left), Box::new(right)))
    }

    /// The formula of an equation as a number.
    pub(super) fn number(&self, equation: usize) -> Option<Rational> {
        self.formula(equation)?.to_rational()
    }

    /// The formula that stands last.
    pub(super) fn last(&self) -> Option<&Expression> {
        self.equations.last()?.last()
    }

    /// Equations interpreted as values of names, such as `B1 = C1 = 0` or `A1 = -A3 = 1`; `None` if an equation has another form.
    pub(super) fn assignments(&self) -> Option<Vec<(String, Rational)>> {
        let values = self.equations.iter().map(|sides| values_of_names(sides));
        Some(values.collect::<Option<Vec<_>>>()?.concat())
    }

    /// The equations that state values of names.
    pub(super) fn gauge(&self) -> Vec<(String, Rational)> {
        self.equations.iter().filter_map(|sides| values_of_names(sides)).flatten().collect()
    }
}

/// The names of an equation with their values.
fn values_of_names(sides: &[Expression]) -> Option<Vec<(String, Rational)>> {
    let (value, names) = sides.split_last()?;
    let value = value.to_rational()?;
    let named = |side: &Expression| match side {
        Expression::Symbol(symbol) => Some((written(symbol), value.clone())),
        Expression::Negate(inner) => match inner.as_ref() {
            Expression::Symbol(symbol) => Some((written(symbol), -value.clone())),
            _ => None,
        },
        _ => None,
    };
    names.iter().map(named).collect()
}
