//! T0 and the test of the exact law by the amplitudes that the speeds at the gate give.

use super::amplitudes::Amplitudes;
use super::swings::OrderedPassages;
use crate::fit::beta::Beta;
use crate::fit::cycles::period_law;
use crate::fit::cycles::row::CycleRow;
use crate::fit::law::Law;
use crate::fit::typical_amplitude::typical_amplitude;
use crate::fit::uncertain::Uncertain;
use crate::statistics::{count, mean};
use libration::internals::progress::Watch;
use libration::quantity::Quantity;

/// Results of the periods with their amplitudes.
pub(super) struct BySpeeds {
    pub(super) t0: Uncertain,
    /// ∂T0/∂(width), in s/rad.
    pub(super) t0_by_width: f64,
    /// Degrees of freedom of the uncertainty of T0.
    pub(super) degrees_of_freedom: f64,
    pub(super) beta: Option<Beta>,
    pub(super) amplitude: Option<f64>,
}

impl OrderedPassages {
    /// Fits T0 and the test of the exact law to the bottom passages and the amplitudes.
    pub(super) fn by_speeds(
        &self,
        width: Quantity,
        amplitudes: &Amplitudes,
        watch: &Watch<'_>,
    ) -> Option<BySpeeds> {
        /// Relative change of the width for the derivatives with respect to it. With 1e-3 the rows of a minute of edges with a jitter of 10 µs
        /// contradict the law by three standard deviations of β, and fluctuations that are then believed in change the weights and the slope.
        const STEP: f64 = 1e-5;
        /// Relative standard uncertainty of T0 by amplitudes from the speeds of single passages, which leave out what the damping does to a half swing
        /// in second order. In records of a minute without any jitter, released at 0.5, 0.9 and 1.5 rad with dampings of 0.01/s and 0.03/s and the gate
        /// at the centre or 0.02 rad from it, T0 was 4e-8 to 4.3e-6 off, 2.1e-6 in the root mean square.
        const LEFT_OUT: f64 = 2.5e-6;
        let rows = self.rows_by_speeds(amplitudes)?;
        let law = period_law::exact(&rows, watch)?;
        let beta = period_law::beta(&rows, watch).ok();
        let typical = typical_amplitude(rows.iter().map(|row| row.ratio))?;
        // When the width is wrong all speeds are, by the same factor; T0 compensates for a part of it.
        let [below, above] = [1.0 - STEP, 1.0 + STEP]
            .map(|factor| self.rows_by_speeds(&self.amplitudes(width.value * factor, watch)));
        let (below, above) = (below?, above?);
        let slope = |of: &dyn Fn(&[CycleRow]) -> Option<f64>| {
            Some((of(&above)? - of(&below)?) / (2.0 * STEP * width.value))
        };
        let t0_by_width = slope(&|rows| Some(period_law::exact(rows, watch)?.t0.value))?;
        let beta_by_width = slope(&|rows| Some(period_law::beta(rows, watch).ok()?.factor.value));
        let spread = width.uncertainty.unwrap_or(0.0);
        let excess = Law::exact().ratio_at(typical) - 1.0;
        let by_damping = left_out_of_beta(amplitudes.typical_drag() * law.t0.value, &rows);
        let t0 = law.t0.with_error(t0_by_width * spread).with_error(LEFT_OUT * law.t0.value);
        let t0 = t0.with_error(by_damping * excess * law.t0.value);
        let part_of_scatter = law.t0.uncertainty * law.t0.uncertainty / (t0.uncertainty * t0.uncertainty);
        let widen = |(beta, by_width): (Beta, f64)| {
            let factor = beta.factor.with_error(by_width * spread).with_error(LEFT_OUT / excess);
            beta.with_factor(factor.with_error(by_damping))
        };
        Some(BySpeeds {
            t0,
            t0_by_width,
            // After Welch and Satterthwaite: the width and the error that is left out are taken as known, the scatter has its rows.
            degrees_of_freedom: count(rows.len() - 1) / (part_of_scatter * part_of_scatter),
            beta: beta.zip(beta_by_width).map(widen),
            amplitude: Some(typical),
        })
    }
}

/// Standard uncertainty of β by the effect of the damping on half swings in second order, where the velocity loses the part `loss` in a period of small
/// swings.
///
/// In records of 20 s and of a minute without any jitter, released at 0.3 to 2.8 rad under dampings of 0.01/s to 0.1/s, β was too small by 0.0075
/// times loss² from 0.3 rad and by up to 10 times loss² from 2.8 rad. The few swings near the top have much of this effect, hence a power
/// mean over the swings. Its power and factor are chosen for these records: β is at most 2.0 of these uncertainties off, from 2.8 rad under 0.06/s.
fn left_out_of_beta(loss: f64, rows: &[CycleRow]) -> f64 {
    /// The exponent of the power mean of exp(1.15 A²).
    const POWER: f64 = 0.8;
    let powers = rows.iter().map(|row| libm::exp(POWER * 1.15 * row.amplitude() * row.amplitude()));
    0.0125 * loss * loss * libm::pow(mean(powers), 1.0 / POWER)
}
