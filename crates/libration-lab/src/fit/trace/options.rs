//! Options for the fit of traces.

/// Options for the fit of traces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TraceOptions {
    /// `true` if the weights fall with the distance of rows from the motion (P. J. Huber, Ann. Math. Statist. 35, 73 (1964),
    /// doi:10.1214/aoms/1177703732), so that outliers have little influence.
    pub robust: bool,
    /// `true` to fit the scale of the angles, which is otherwise taken as right.
    pub free_scale: bool,
    /// `true` to compute the intervals of the profile likelihood; they cost some ten further fits for each shared parameter.
    pub profile: bool,
}
