//! What gravity can be.

/// The least and the greatest gravity on the surface of the Earth, in m/s²: C. Hirt and others, Geophys. Res. Lett. 40, 4279
/// (2013), doi:10.1002/grl.50838.
pub const GRAVITY_ON_EARTH: [f64; 2] = [9.7639, 9.8337];
