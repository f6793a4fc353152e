//! The pictures: what each one shows, and how it is drawn.

pub(crate) mod backbone;
pub(crate) mod decay;
pub(crate) mod errors;
pub(crate) mod gates;
pub(crate) mod lengths;
pub(crate) mod lyapunov;
pub(crate) mod modes;
pub(crate) mod motion;
pub(crate) mod periods;
pub(crate) mod phase;
pub(crate) mod section;
pub(crate) mod series;
pub(crate) mod simulation;
pub(crate) mod spectrum;
pub(crate) mod trace;

pub(crate) mod chart;
pub(crate) mod file;

mod clip;
mod cusps;
mod dashes;
pub(crate) mod draw;
mod frame;
mod legend;
mod letters;
pub(crate) mod names;
mod range;
mod style;

pub(crate) use frame::Smallest;
