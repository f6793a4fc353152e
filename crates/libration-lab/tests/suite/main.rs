//! The evidence for the laboratory: recordings of every kind, damaged ones, and fits of swings with known truth.
#![expect(clippy::unwrap_used, reason = "a test that cannot read its table should stop there")]
#![expect(clippy::float_cmp, reason = "exact values and equal bits are what some tests claim")]

use libration_testing::random;

mod synthetic_gate;
mod synthetic_response;
mod synthetic_trace;
mod class_readings;
mod continuation;
mod damping_bias;
mod fit;
mod fit_amplitudes;
mod fit_bars;
mod fit_budget;
mod fit_cycles;
mod fit_gates;
mod fit_lengths;
mod fit_response;
mod fitted_pivot;
mod gate_uncertainties;
mod malformed;
mod measurement;
mod parallel;
mod plan;
mod recording;
mod rounded_times;
mod source;
mod spectrum;
mod statistics;
mod swings;
mod trace_fits;
mod unequal_scatter;
