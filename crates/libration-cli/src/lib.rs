//! The program `libration`, for hosts that offer it as a command, such as the Python package.
//!
//! The queries themselves are in `libration_queries`; this crate adds the terminal: streams, Ctrl-C, progress, completions and manual pages.

mod command;
mod completions;
mod heartbeat;
mod manual;
mod options;
mod program;
mod terminal;

pub use program::program;
