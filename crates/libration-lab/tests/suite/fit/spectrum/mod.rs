//! The harmonics of a measured swing, part by part.

mod theory;
