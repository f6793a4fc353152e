//! Events along a motion, and positions in a step at which formulas have no series.

pub(super) mod boundary;
pub(super) mod contacts;
pub(super) mod event;
pub(super) mod sharp;
pub(super) mod steep;
