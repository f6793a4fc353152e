//! Statistics of samples for fits and for the reading of files: means, medians, least squares, distributions, criteria.
//!
//! # Method `nalgebra` is used without its products for large matrices, whose rounding depends on the processor, so that fits give the same bits
//! everywhere.

pub(crate) mod count;
pub(crate) mod least_squares;
mod mean;
pub(crate) mod robust;
pub(crate) mod triangle;
pub(crate) mod akaike;
pub(crate) mod chi_squared;
pub(crate) mod fisher;
pub(crate) mod levenberg_marquardt;
pub(crate) mod student;

pub(crate) use count::count;
pub(crate) use least_squares::{
    Design, LinearFit, ROUNDING, Undetermined, is_settled, least_squares, weighted_least_squares,
};
pub(crate) use mean::{mean, root_mean_square};
pub(crate) use robust::{
    NORMAL_PER_MEDIAN_DEVIATION, deviation_by_median, lower_median, median, robust_deviation,
};
pub(crate) use triangle::triangle;
