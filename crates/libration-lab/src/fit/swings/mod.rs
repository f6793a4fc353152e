//! Recordings of swings of one pendulum → all results: the fitted motion, the cycles one by one, the test of the exact law,
//! gravity or the length, warnings, and advice for a better measurement.
//!
//! # Examples
//! ```
//! use libration::pendulum::Pendulum;
//! use libration_lab::fit::swings::{Advice, FittedPendulum, SwingsOptions, fit_swings};
//! use libration_lab::measurement::{Observable, Trace};
//! use libration::progress::Quiet;
//!
//! let motion = Pendulum::from_angular_frequency(4.0)?.released_from("40deg".parse()?)?;
//! let times: Vec<f64> = (0..400).map(|row| 0.025 * f64::from(row)).collect();
//! let angles = times.iter().map(|&time| motion.state_at(time).angle).collect();
//! let trace = Trace::new("exact", Observable::Angle, times, angles, None)?;
//! let undamped = SwingsOptions { damping: Some("undamped".parse()?), ..SwingsOptions::default() };
//! let analysis = fit_swings(&[trace], &undamped, &Quiet)?;
//! let FittedPendulum::Length(length) = analysis.pendulum else { return Err("no length was given".into()) };
//! assert!((length.value - 9.80665 / 16.0).abs() < 1e-6);
//! assert!(analysis.advice.contains(&Advice::GiveLength));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod options;
mod pendulum;
mod warning;
mod warning_text;
mod advice;
mod fitted;
mod reliability;
mod doubts;
mod improvements;
mod analysis;

pub use advice::{Advice, EndOfTrace};
pub use analysis::{SwingsError, fit_swings};
pub use fitted::SwingsFit;
pub use options::SwingsOptions;
pub use pendulum::FittedPendulum;
pub use warning::Warning;
