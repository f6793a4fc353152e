//! The core of every periodic orbit, whether it is released, settled to, driven or followed over a parameter: the flow with its variations, the
//! linear equations of a step of Newton's method, multiple shooting, the Floquet multipliers with their errors, and extrema.
//!
//! # Method
//! An orbit is a zero of the map from its start to its end after one period, whose derivative comes from the variational equations. Two
//! integrations to different tolerances tell the error of the flow. The error of an orbit's start is that residual, and the rounding of the start,
//! taken through the inverse of the bordered matrix M − I; an orbit is accepted where it closes within ‖M‖ times that error and the error of the
//! flow.
//!
//! The iterations differ and stand where they are used. Along a branch the next point is near, so that steps are whole and end when they no longer
//! halve (`continuation`); a guess of an orbit may be far off, so that steps are shortened until they lead nearer, and a family of orbits has more
//! equations than unknowns (`orbit`). One loop for both would be longer than the two.
//!
//! # References
//! R. Seydel, *Practical Bifurcation and Stability Analysis*, Springer 2010, chapter 7, doi:10.1007/978-1-4419-1740-9.

mod extrema;
mod floquet;
mod flow;
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
