//! The early end of a long result, which keeps what is done.
//!
//! # Method
//! Every library call that may take long has a variant `…_watched` that checks a `libration::watch::Watch` at each step, order or piece; the
//! command passes one that asks the host. A cancelled run returns the finished part with `"interrupted": true`, and states what is missing. A
//! second Ctrl-C ends the command at once.

use crate::call;
use crate::query_error::QueryError;
use std::ops::ControlFlow;

/// Somebody may ask for it from now on.
pub(crate) fn listen() -> Result<(), QueryError> {
    call::current()
        .host()
        .listen()
        .map_err(|error| QueryError::failed(format!("cannot listen for Ctrl-C: {error}")))
}

/// Returns `true` if the run is cancelled.
pub(crate) fn asked() -> bool {
    call::is_ended_early()
}

/// Continues long work unless the run is cancelled.
pub(crate) fn go_on() -> ControlFlow<()> {
    if asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// The error of a cancelled run of which `what` was computed is written; success if it is not cancelled.
pub(crate) fn ended_early(what: &str) -> Result<(), QueryError> {
    match asked() {
        true => Err(QueryError::cancelled(format!("interrupted: {what} up to then are written"))),
        false => Ok(()),
    }
}
