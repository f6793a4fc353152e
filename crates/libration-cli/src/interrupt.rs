//! Ctrl-C: the first one asks long work to stop and keep what is done, the second one ends the command.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

static ASKED: AtomicBool = AtomicBool::new(false);

/// The exit status of a command that was ended from the keyboard.
const ENDED: i32 = 130;

/// From now on Ctrl-C asks first.
pub(crate) fn listen() {
    let handler = || {
        if ASKED.swap(true, Ordering::Relaxed) {
            std::process::exit(ENDED);
        }
    };
    // Where no handler can be set, Ctrl-C ends the command as it always does.
    let _ = ctrlc::set_handler(handler);
}

/// Whether to go on.
pub(crate) fn go_on() -> ControlFlow<()> {
    if is_asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// Whether work shall stop.
pub(crate) fn is_asked() -> bool {
    ASKED.load(Ordering::Relaxed)
}
