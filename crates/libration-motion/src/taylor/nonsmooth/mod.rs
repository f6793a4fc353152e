//! Motions at points where a force jumps, bends or has no series.

pub(super) mod branches;
pub(super) mod picard;
pub(super) mod sticking;
