//! Meanings of the names in a formula when it was checked.

use super::super::formula::{Formula, Name};
use libration::perturbation::RestoringTerm;

/// The meanings of the names in a formula when it was checked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Letters {
    /// Names with their values, in terms of numbers and earlier names.
    pub values: Vec<(Name, Formula)>,
    /// Functions with their parameters.
    pub functions: Vec<(Name, Vec<Name>, Formula)>,
}

/// The condition from one harmonic at one power of the expansion parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenCondition {
    /// The terms of the restoring force over ω0² besides the displacement itself.
    pub force: Vec<RestoringTerm>,
    /// The symbols in their factors.
    pub symbols: Vec<Name>,
    /// The coefficients of the ansatz: the power of the expansion parameter, the harmonic, and the name.
    pub harmonics: Vec<(usize, usize, Name)>,
    /// The coefficients of the frequency: the power and the name.
    pub frequency: Vec<(usize, Name)>,
    /// Coefficients determined at lower powers.
    pub lower: Vec<(Name, Formula)>,
    /// Coefficient that the condition determines, if any.
    pub fixes: Option<Name>,
    /// The power of the condition.
    pub order: usize,
    /// The harmonic of the condition.
    pub harmonic: usize,
}
