//! Decay rates of the amplitude for each kind of damping, at any amplitude: dA/dt = −Σ cₙ φₙ(A) with
//! φₙ = ω0ⁿ⁻¹·∮|θ′|ⁿ⁺¹dt/(T sin A), from the exact loss of energy in a cycle.

use std::f64::consts::PI;

use crate::fit::trace::DampingKind;
use crate::statistics::count;
use libration::decay::{cycle_integral, small_cycle_integral};
use libration::pendulum::{Amplitude, period_ratio};
use libration::quantity::Angle;

/// Number of points of a table; interpolation errs by 1e-7 of the rate below 150°.
const PLACES: usize = 400;
/// Largest amplitude of the table, where shapes end too (`shape.rs`): with 3.0 and 3.14 no law of four recordings from 2.95 to 3.135 rad changed.
const LARGEST_AMPLITUDE: f64 = 3.13;

/// Tables of φₙ over its limit for small amplitudes, which for dry friction is constant, for linear damping A/2, and for
/// quadratic damping 4ω0A²/3π.
#[derive(Clone, Debug)]
pub struct DecayRates {
    step: f64,
    tables: [Vec<f64>; 3],
    omega0: f64,
}

impl DecayRates {
    /// Tabulates the rates up to this amplitude, in radians.
    pub fn new(omega0: f64, largest: f64) -> Self {
        let step = (1.05 * largest).clamp(0.01, LARGEST_AMPLITUDE) / count(PLACES);
        let table = |exponent: f64| (0..=PLACES).map(|node| enhancement(exponent, step, node)).collect();
        Self { step, tables: [0.0, 1.0, 2.0].map(table), omega0 }
    }

    /// φₙ at this amplitude; for amplitudes beyond the table the value at its end.
    pub fn at(&self, term: DampingKind, amplitude: f64) -> f64 {
        let amplitude = amplitude.max(0.0);
        match term {
            DampingKind::Dry => 2.0 / (PI * self.omega0) * self.interpolated(0, amplitude),
            DampingKind::Linear => 0.5 * amplitude * self.interpolated(1, amplitude),
            DampingKind::Quadratic => {
                4.0 / (3.0 * PI) * self.omega0 * amplitude * amplitude * self.interpolated(2, amplitude)
            }
        }
    }

    /// Interpolates by the cubic through four neighbours.
    fn interpolated(&self, exponent: usize, amplitude: f64) -> f64 {
        let table = &self.tables[exponent];
        let position = amplitude / self.step;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the table")]
        let first = (position.floor().clamp(1.0, 398.0) as usize) - 1;
        let x = (position - count(first)).clamp(0.0, 3.0);
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| table[first + k]);
        a * (x - 1.0) * (x - 2.0) * (x - 3.0) / -6.0
            + b * x * (x - 2.0) * (x - 3.0) / 2.0
            + c * x * (x - 1.0) * (x - 3.0) / -2.0
            + d * x * (x - 1.0) * (x - 2.0) / 6.0
    }
}

/// φₙ over its limit for small amplitudes.
fn enhancement(exponent: f64, step: f64, node: usize) -> f64 {
    let radians = step * count(node);
    let amplitude = Angle::from_radians(radians).ok().and_then(|angle| Amplitude::new(angle).ok());
    let Some(amplitude) = amplitude.filter(|_| node > 0) else { return 1.0 };
    let loss = cycle_integral(exponent, &amplitude) / small_cycle_integral(exponent, radians);
    loss * radians / (period_ratio(radians) * libm::sin(radians))
}
