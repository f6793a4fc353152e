//! The early end of a long answer, which keeps what is done.

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

/// Whether somebody has asked.
pub(crate) fn asked() -> bool {
    call::is_ended_early()
}

/// Whether long work shall go on.
pub(crate) fn go_on() -> ControlFlow<()> {
    if asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// What is left to be said when an answer was ended early and `what` there was of it is written.
pub(crate) fn ended_early(what: &str) -> Result<(), QueryError> {
    match asked() {
        true => Err(QueryError::cancelled(format!("interrupted: {what} up to then are written"))),
        false => Ok(()),
    }
}
