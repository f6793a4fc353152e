//! Names in a formula.

use super::{Formula, Name};

impl Formula {
    /// The free names of the formula: all except the variables of its sums and integrals.
    pub(crate) fn free_names(&self) -> Vec<Name> {
        let mut names = match self {
            Self::Name(name) => vec![name.clone()],
            Self::Derivative { by, .. } => vec![by.clone()],
            _ => vec![],
        };
        let inner: Vec<Name> = self.parts().into_iter().flat_map(Self::free_names).collect();
        match self {
            Self::Series { index: bound, .. } | Self::Integral { variable: bound, .. } => {
                names.extend(inner.into_iter().filter(|name| name != bound));
            }
            _ => names.extend(inner),
        }
        names
    }

    /// The functions that the formula applies.
    pub(crate) fn applied(&self) -> Vec<Name> {
        let name = if let Self::Apply(name, _) = self { Some(name.clone()) } else { None };
        name.into_iter().chain(self.parts().into_iter().flat_map(Self::applied)).collect()
    }

    /// The direct parts of the formula.
    pub(crate) fn parts(&self) -> Vec<&Self> {
        match self {
            Self::Number(_) | Self::Decimal(_) | Self::Pi | Self::Name(_) => vec![],
            Self::Negate(part) | Self::Call(_, part) | Self::DoubleFactorial(part) | Self::Order(part) => {
                vec![part]
            }
            Self::Sum(parts) | Self::Product(parts) | Self::Apply(_, parts) => parts.iter().collect(),
            Self::Fraction(a, b) | Self::Power(a, b) | Self::Agm(a, b) => vec![a, b],
            Self::Series { from, to, term, .. } => {
                [&**from, &**term].into_iter().chain(to.as_deref()).collect()
            }
            Self::Integral { from, to, integrand, .. } => vec![from, to, integrand],
            Self::Derivative { of, .. } => vec![of],
        }
    }
}
