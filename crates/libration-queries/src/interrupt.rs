//! Cancellation of a run, whose finished part is kept.
//!
//! # Method
//! Every library call that may take long updates a `libration::progress::Progress` at each step, order or piece; that of the command consults the
//! host. A cancelled run returns the finished part with `"interrupted": true`, and states what is missing. A
//! second Ctrl-C ends the command at once.

use crate::call;
use crate::query_error::QueryError;
use libration::progress::{Progress, Status};
use std::ops::ControlFlow;

/// Makes the run cancellable from now on.
pub(crate) fn listen() -> Result<(), QueryError> {
    call::current()
        .host()
        .listen()
        .map_err(|error| QueryError::failed(format!("cannot listen for Ctrl-C: {error}")))
}

/// Returns `true` if the run is cancelled.
pub(crate) fn is_cancelled() -> bool {
    call::is_cancelled()
}

/// Continues long work unless the run is cancelled.
pub(crate) fn check() -> ControlFlow<()> {
    if is_cancelled() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// Cancellation alone: progress that is not shown.
pub(crate) struct Cancellation;

impl Progress for Cancellation {
    fn update(&self, _: Status) -> ControlFlow<()> {
        check()
    }
}

/// The error of a cancelled run whose finished part, `what`, is written; `Ok` if it is not cancelled.
pub(crate) fn ended_early(what: &str) -> Result<(), QueryError> {
    match is_cancelled() {
        true => Err(QueryError::cancelled(format!("interrupted: {what} up to then are written"))),
        false => Ok(()),
    }
}
