//! Regular and chaotic motions.

mod integrable;
mod lyapunov;
mod section;
