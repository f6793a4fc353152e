//! Perturbation series beside exact values that know nothing of them: elliptic functions for the pendulum, the
//! integrated equation of motion for other oscillators.

mod approximant;
mod quantity;

mod enclosed;
mod exact;

mod relation;

mod backbone;

pub use approximant::Approximant;
pub use backbone::{Backbone, BackbonePoint, NoBackbone, NoSeries, OrbitFrequency, SeriesFrequency};
pub use exact::{ExactMotion, ExactValue, NoExactValue, Road};
pub use quantity::{NotAQuantity, Quantity};
pub use relation::{Radius, Relation};
