//! Small oscillations of systems of equations about an equilibrium, and how their frequencies change with the amplitude.
//!
//! About an equilibrium x″ = −A·x + G·x′. Where the entries are fractions the frequencies are roots of an exact
//! polynomial, written with square roots when its factors allow it. The next terms of the forces change the frequency
//! of a mode by κa²: Lindstedt's expansion in several coordinates, to the third order.

mod error;
mod mode;

mod equilibrium;
mod linearisation;

mod polynomial;
mod roots;
mod spectrum;

mod shapes;

mod lindstedt;
mod no_shift;
mod resonance;
mod shift;

mod modes;

pub use error::{NoModes, SearchEnd};
pub use mode::{Behaviour, Mode, Resonance, Shift};
pub use modes::NormalModes;
pub use no_shift::NoShift;
