//! The code common to all periodic orbits, whether released, settled to, driven or continued in a parameter: the flow with its variations, the
//! linear equations of a step of Newton's method, multiple shooting, the Floquet multipliers with their errors, and extrema.
//!
//! # Method
//! An orbit is a zero of the map from its start to the difference of its end after one period, whose derivative
//! comes from the variational equations, which pass the jumps of forces (`jumps.rs`). Two integrations to different tolerances give the error of the flow. The
//! error of an orbit's start is the residual, and the rounding of the start, multiplied by the inverse of the
//! bordered matrix M − I; an orbit is accepted if it closes within ‖M‖ times that error and the error of the flow.
//!
//! Each module has its own iteration. Along a branch the next point is near, so that steps are whole and end when they no longer halve the
//! distance (`continuation`); a guess of an orbit may be far off, so that steps are shortened until they reduce the distance, and a family of
//! orbits has more equations than unknowns (`orbit`). One loop for both would be longer than the two.
//!
//! # References
//! R. Seydel, *Practical Bifurcation and Stability Analysis*, Springer 2010, chapter 7, doi:10.1007/978-1-4419-1740-9.

mod extrema;
mod floquet;
mod flow;
mod jumps;
mod modes;
mod multiple_shooting;
mod newton_step;
mod norm;
mod precise_series;

pub use extrema::{Extrema, extrema, turns_in};
pub use floquet::{Floquet, Stability, multiplier_errors};
pub use flow::{Flow, Variations};
pub use multiple_shooting::{Checked, Frame, LOST, Nodes, Piece};
pub use newton_step::{CLOSED, NewtonStep};
pub use norm::{norm, norm_of_map};
pub use precise_series::{precise_series, precise_step, precise_sum};
