//! Times of a photogate, part by part.

mod directions;
mod passages;
mod speeds;
mod trend;
mod width;
