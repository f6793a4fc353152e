//! Periods, in units of the small-angle period and in seconds, and the nome of an amplitude.

use libration::elliptic::LengthMismatch;
use libration::pendulum::{Amplitude, period_excesses, period_ratios, period_ratios_near_top, periods};
use libration::quantity::Angle;
use pyo3::prelude::*;

use super::{add, documented};

pub(super) fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    add(module, documented!("period_ratio"), |[amplitudes], [ratios]| period_ratios(amplitudes, ratios))?;
    add(module, documented!("period_excess"), |[amplitudes], [excesses]| {
        period_excesses(amplitudes, excesses)
    })?;
    add(module, documented!("period_ratio_near_top"), |[complements], [ratios]| {
        period_ratios_near_top(complements, ratios)
    })?;
    add(module, documented!("period"), |[amplitudes, lengths, gravities], [results]| {
        periods(amplitudes, lengths, gravities, results)
    })?;
    add(module, documented!("nome"), |[amplitudes], [results]| nomes(amplitudes, results))
}

/// The nome of each amplitude; NaN if it is not the amplitude of a libration.
fn nomes(amplitudes: &[f64], nomes: &mut [f64]) -> Result<(), LengthMismatch> {
    let amplitude = |radians: f64| Amplitude::new(Angle::from_radians(radians).ok()?).ok();
    for (radians, nome) in amplitudes.iter().zip(nomes) {
        *nome = amplitude(*radians).map_or(f64::NAN, |swing| swing.nome());
    }
    Ok(())
}
