//! Ctrl-C asks for an early end; pressed again it ends the command at once.

use crate::failure::Failure;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

static ASKED: AtomicBool = AtomicBool::new(false);

/// Listens from now on.
pub(crate) fn listen() -> Result<(), Failure> {
    let heard = || {
        if ASKED.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(Failure::INTERRUPTED));
        }
    };
    ctrlc::set_handler(heard).map_err(|error| Failure::NoAnswer(format!("cannot listen for Ctrl-C: {error}")))
}

/// Whether somebody has asked.
pub(crate) fn asked() -> bool {
    ASKED.load(Ordering::Relaxed)
}

/// Whether long work shall go on.
pub(crate) fn go_on() -> ControlFlow<()> {
    if asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// What is left to be said when an answer was ended early and `what` there was of it is written.
pub(crate) fn ended_early(what: &str) -> Result<(), Failure> {
    match asked() {
        true => Err(Failure::Interrupted(format!("interrupted: {what} up to then are written"))),
        false => Ok(()),
    }
}
