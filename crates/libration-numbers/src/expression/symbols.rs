//! The symbols of a formula, and substitution for them.

use std::collections::BTreeSet;

use super::{Expression, Symbol};

impl Symbol {
    /// A name without primes.
    #[must_use]
    pub fn plain(name: &str) -> Self {
        Self { name: name.to_owned(), primes: 0 }
    }

    /// The name with a number of primes.
    #[must_use]
    pub fn with_primes(&self, primes: u8) -> Self {
        Self { name: self.name.clone(), primes }
    }
}

impl Expression {
    /// A symbol without primes.
    #[must_use]
    pub fn symbol(name: &str) -> Self {
        Self::Symbol(Symbol::plain(name))
    }

    /// All symbols in the formula.
    #[must_use]
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        let mut symbols = BTreeSet::new();
        self.collect_symbols(&mut symbols);
        symbols
    }

    fn collect_symbols(&self, symbols: &mut BTreeSet<Symbol>) {
        if let Self::Symbol(symbol) = self {
            symbols.insert(symbol.clone());
        }
        for part in self.parts() {
            part.collect_symbols(symbols);
        }
    }

    /// Returns `true` if a symbol occurs.
    #[must_use]
    pub fn contains(&self, symbol: &Symbol) -> bool {
        matches!(self, Self::Symbol(other) if other == symbol)
            || self.parts().any(|part| part.contains(symbol))
    }

    /// The operands, from left to right.
    #[doc(hidden)]
    pub fn parts(&self) -> impl Iterator<Item = &Self> {
        let (first, second) = match self {
            Self::Number(_) | Self::Pi | Self::Symbol(_) => (None, None),
            Self::Negate(a) | Self::Call(_, a) => (Some(a), None),
            Self::Add(a, b)
            | Self::Subtract(a, b)
            | Self::Multiply(a, b)
            | Self::Divide(a, b)
            | Self::Power(a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second).map(|part| &**part)
    }

    /// The formula after substitution of another one for a symbol, not simplified. The time derivatives of the symbol are different symbols.
    #[must_use]
    pub fn substitute(&self, symbol: &Symbol, by: &Self) -> Self {
        match self {
            Self::Symbol(other) if other == symbol => by.clone(),
            _ => self.with_parts(|part| part.substitute(symbol, by)),
        }
    }

    /// The formula with its operands replaced.
    #[doc(hidden)]
    pub fn with_parts(&self, mut other: impl FnMut(&Self) -> Self) -> Self {
        let mut part = |a: &Self| Box::new(other(a));
        match self {
            Self::Number(_) | Self::Pi | Self::Symbol(_) => self.clone(),
            Self::Negate(a) => Self::Negate(part(a)),
            Self::Add(a, b) => Self::Add(part(a), part(b)),
            Self::Subtract(a, b) => Self::Subtract(part(a), part(b)),
            Self::Multiply(a, b) => Self::Multiply(part(a), part(b)),
            Self::Divide(a, b) => Self::Divide(part(a), part(b)),
            Self::Power(a, b) => Self::Power(part(a), part(b)),
            Self::Call(function, a) => Self::Call(*function, part(a)),
        }
    }
}
