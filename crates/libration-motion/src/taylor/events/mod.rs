//! Events along a motion, and places in a step where formulas have no series.

pub(super) mod boundary;
pub(super) mod contacts;
pub(super) mod event;
pub(super) mod sharp;
pub(super) mod steep;
