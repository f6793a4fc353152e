//! The statistics of samples, part by part.

mod akaike;
mod certified;
mod chi_squared;
mod fisher;
mod least_squares;
mod levenberg_marquardt;
mod robust;
mod student;
mod triangle;
