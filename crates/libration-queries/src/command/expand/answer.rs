//! An expansion with its words, in numbers or with letters.

use super::subject::{About, Subject};
use crate::arguments::Chosen;
use libration::algebra::{LaurentPolynomial, Rational};
use libration::expression::Equation;
use libration::perturbation::{Expansion, SymbolicExpansion};
use libration::quantity::is_angle_name;

/// An expansion with the words for it.
pub(super) struct ExpandResult<C = Rational> {
    pub(super) subject: Subject,
    pub(super) is_angle: bool,
    /// Letters and constants, where parameters are letters.
    pub(super) letters: Option<Letters<C>>,
    pub(super) expansion: Expansion<C>,
    /// The order that was requested, when Ctrl-C was pressed before it was reached.
    pub(super) interrupted: Option<usize>,
}

impl<C> Letters<C> {
    /// The names of constants whose meaning is not evident, unlike π.
    pub(super) fn explained(&self) -> impl Iterator<Item = &(String, String)> {
        self.constants.iter().filter(|(name, constant)| name != constant)
    }
}

/// The letters of an expansion, and ω0 by them.
pub(super) struct Letters<C> {
    pub(super) names: Vec<String>,
    /// Names in the coefficients for constants that are no products of letters.
    pub(super) constants: Vec<(String, String)>,
    pub(super) omega0: String,
    /// Symbol of ω0 in the coefficients.
    pub(super) omega0_name: Option<String>,
    /// Coefficients of Ω by powers of the variable, where ω0 is a product of letters.
    pub(super) frequency: Option<Vec<C>>,
}

impl<C> About for ExpandResult<C> {
    fn subject(&self) -> &Subject {
        &self.subject
    }
}

impl ExpandResult {
    pub(super) fn new(chosen: Chosen, expansion: Expansion, interrupted: Option<usize>) -> Self {
        let equation = chosen.oscillator.equation().clone();
        Self::about(&equation, chosen, expansion, None, interrupted)
    }
}

impl ExpandResult<LaurentPolynomial> {
    /// A symbolic expansion with the words for its oscillator.
    pub(super) fn with_letters<O>(
        equation: &Equation,
        chosen: Chosen<O>,
        expansion: SymbolicExpansion,
        interrupted: Option<usize>,
    ) -> Self {
        let frequency = expansion.frequency();
        let SymbolicExpansion { letters: names, constants, omega0, omega0_name, series } = expansion;
        let constants = constants.into_iter().map(|(name, constant)| (name, constant.to_string())).collect();
        let omega0 =
            omega0.map_or_else(|| format!("sqrt({})", series.omega0_squared), |root| root.to_string());
        let letters = Letters { names, constants, omega0, omega0_name, frequency };
        Self::about(equation, chosen, series, Some(letters), interrupted)
    }
}

impl<C> ExpandResult<C> {
    pub(super) fn about<O>(
        equation: &Equation,
        chosen: Chosen<O>,
        expansion: Expansion<C>,
        letters: Option<Letters<C>>,
        interrupted: Option<usize>,
    ) -> Self {
        let Chosen { key, title, values, read_as, .. } = chosen;
        let subject = Subject::new(equation, (key, title), values, read_as);
        Self { is_angle: is_angle_name(&subject.variable), subject, letters, expansion, interrupted }
    }

    /// The symbol of a quantity of the result, numbered where the equation has its name.
    pub(super) fn symbol(&self, name: &str) -> String {
        let symbols = self.letters.as_ref().map_or(&[][..], |letters| &letters.names);
        self.subject.free(name, symbols)
    }

    /// The symbol of the expansion parameter; that of a strength is the equation's own.
    pub(super) fn variable(&self) -> String {
        let variable = &self.expansion.variable;
        if variable.is_strength() { variable.name().to_owned() } else { self.symbol(variable.name()) }
    }

    /// The frequency itself, unless it is equal to Ω/ω0.
    pub(super) fn frequency(&self) -> Option<&[C]> {
        let letters = self.letters.as_ref()?;
        letters.frequency.as_deref().filter(|_| letters.omega0 != "1")
    }

    /// A statement of the orders that were complete when Ctrl-C was pressed during the expansion.
    pub(super) fn missing_orders(&self) -> Option<String> {
        let asked = self.interrupted?;
        let order = self.expansion.order;
        let is_certain = order < asked && self.letters.is_none();
        let left = if is_certain { "which is confirmed" } else { "which is not checked by a second method" };
        Some(format!("order {order} of {asked}, {left}, is written"))
    }
}
