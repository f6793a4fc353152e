//! The pictures: contents, sizes and files.
//!
//! # Method
//! Pictures are data of `libration-report`, drawn as SVG there, as PNG by tiny-skia (`png.rs`) and as PDF by pdf-writer (`pdf.rs`), and
//! written as JSON (`data.rs`); in a page, which draws pictures by itself, `svg_only.rs` replaces these three.

pub(crate) mod amplitudes;
pub(crate) mod animation;
pub(crate) mod backbone;
pub(crate) mod decay;
pub(crate) mod errors;
pub(crate) mod fitted_response;
pub(crate) mod gates;
pub(crate) mod lengths;
pub(crate) mod lyapunov;
pub(crate) mod measured_spectrum;
pub(crate) mod melnikov;
pub(crate) mod modes;
pub(crate) mod motion;
pub(crate) mod motions;
pub(crate) mod nonlinear_modes;
pub(crate) mod orbit;
pub(crate) mod periods;
pub(crate) mod phase;
pub(crate) mod plan;
pub(crate) mod resonance;
pub(crate) mod response;
pub(crate) mod section;
pub(crate) mod series;
pub(crate) mod simulation;
pub(crate) mod spectrum;
pub(crate) mod stability;
pub(crate) mod swing_periods;
pub(crate) mod trace;
pub(crate) mod trajectories;
pub(crate) mod file;
pub(crate) mod names;
pub(crate) mod cusps;
#[cfg_attr(target_family = "wasm", path = "svg_only.rs")]
pub(crate) mod data;
#[cfg(not(target_family = "wasm"))]
pub(crate) mod font;
pub(crate) mod layout;
pub(crate) mod options;
pub(crate) mod parameters;
#[cfg_attr(target_family = "wasm", path = "svg_only.rs")]
pub(crate) mod pdf;
#[cfg_attr(target_family = "wasm", path = "svg_only.rs")]
pub(crate) mod png;

pub(crate) use layout::Layout;
pub(crate) use libration_report::chart;
use libration_report::{range, style};
pub(crate) use options::PictureOptions;
