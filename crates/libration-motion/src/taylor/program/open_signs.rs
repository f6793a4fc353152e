//! Equations in which the signs of all |…| are symbols, so that they are smooth on each side of every zero.

use super::moduli::{Moduli, Modulus};
use super::monomials::with_values_at_zero;
use crate::taylor::StateLayout;
use libration_numbers::expression::{Equation, Expression, Symbol};

/// Equations with open signs, in the order of the |…| of [`System`](crate::taylor::System).
#[derive(Clone, Debug)]
pub(crate) struct OpenSigns {
    equation: Equation,
    signs: Vec<Symbol>,
    arguments: Vec<Expression>,
    jumps: Vec<bool>,
}

impl OpenSigns {
    /// The equations with open signs; `None` if no force jumps.
    pub(crate) fn new(equation: &Equation) -> Option<Self> {
        let equation = with_values_at_zero(equation.clone());
        let mut moduli = Moduli::default();
        let formulas: Vec<Expression> =
            equation.derivatives().iter().map(|formula| moduli.taken_out(formula)).collect();
        let signs: Vec<Symbol> = moduli.signs().collect();
        let jumps = |index: usize| formulas.iter().any(|formula| moduli.jumps(index, formula));
        let jumps: Vec<bool> = (0..signs.len()).map(jumps).collect();
        let arguments =
            moduli.into_arguments().into_iter().map(|Modulus { argument, .. }| argument).collect();
        let (variables, orders) = (equation.variables().to_vec(), equation.orders().to_vec());
        let equation = Equation::of_derivatives(variables, orders, formulas);
        jumps.contains(&true).then_some(Self { equation, signs, arguments, jumps })
    }

    /// The equations.
    pub(crate) const fn equation(&self) -> &Equation {
        &self.equation
    }

    /// The symbols of the signs.
    pub(crate) fn signs(&self) -> &[Symbol] {
        &self.signs
    }

    /// The arguments, with open signs.
    pub(crate) fn arguments(&self) -> &[Expression] {
        &self.arguments
    }

    /// Returns `true` if a force jumps where an argument is zero.
    pub(crate) fn jumps(&self, argument: usize) -> bool {
        self.jumps[argument]
    }

    /// The state component that is an argument and whose rate of change has an equation.
    pub(crate) fn driven(&self, argument: usize) -> Option<usize> {
        let layout = StateLayout::new(&self.equation);
        let symbols = layout.symbols(self.equation.variables());
        let is_argument = |symbol: &Symbol| self.arguments[argument] == Expression::Symbol(symbol.clone());
        symbols.iter().position(is_argument).filter(|&number| layout.driving(number).is_some())
    }

    /// The equations of the sliding motion in which some arguments, which are state components, stay zero: the sign of each is the one at which
    /// its component rests (A. F. Filippov). `None` if an equation is not linear in its sign.
    pub(crate) fn sliding(&self, held: &[usize]) -> Option<Equation> {
        let layout = StateLayout::new(&self.equation);
        let mut derivatives = self.equation.derivatives().to_vec();
        for &argument in held {
            let coordinate = layout.driving(self.driven(argument)?)?;
            let sign = &self.signs[argument];
            let acceleration = &derivatives[coordinate];
            let gain = acceleration.derivative(sign).simplified();
            if gain.contains(sign) || gain.vanishes() {
                return None;
            }
            let rest = acceleration.substitute(sign, &Expression::from(0));
            let needed = Expression::Negate(Box::new(Expression::Divide(Box::new(rest), Box::new(gain))));
            derivatives = derivatives.iter().map(|formula| formula.substitute(sign, &needed)).collect();
            derivatives[coordinate] = Expression::from(0);
        }
        let (variables, orders) = (self.equation.variables().to_vec(), self.equation.orders().to_vec());
        Some(Equation::of_derivatives(variables, orders, derivatives))
    }
}
