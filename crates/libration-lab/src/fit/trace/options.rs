//! How traces are fitted.

/// How traces are fitted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TraceOptions {
    /// Rows count the less the further they are from the motion (P. J. Huber, Ann. Math. Statist. 35, 73 (1964),
    /// doi:10.1214/aoms/1177703732), so that outliers draw nothing.
    pub robust: bool,
    /// The scale of the angles is to be found, and not taken to be right.
    pub free_scale: bool,
    /// The intervals of the profile likelihood are wanted; they cost some ten further fits for each shared parameter.
    pub profile: bool,
}
