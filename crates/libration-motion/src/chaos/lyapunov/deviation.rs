//! A small deviation from a motion, advanced by the linearised equations.

use crate::taylor::{Cause, Effort, IntegrationError, Moment, StateLayout, System, integrate};
use libration_numbers::progress::Quiet;

/// A motion with a small deviation from it, whose size is reset to one at the beginning of each interval.
///
/// Reference: G. Benettin, L. Galgani, A. Giorgilli and J.-M. Strelcyn, Meccanica 15, 9 (1980), doi:10.1007/BF02128236.
#[derive(Debug)]
pub(super) struct Deviation<'a> {
    /// The equations of motion and those of one deviation.
    system: &'a System,
    /// Layout of a state without the deviation.
    layout: &'a StateLayout,
    /// Unit of each state component, in which deviations are measured.
    units: &'a [f64],
    effort: Effort,
    moment: Moment,
    /// The deviation: coordinates, then velocities.
    deviation: Vec<f64>,
}

impl<'a> Deviation<'a> {
    /// The motion with an initial deviation in all coordinates and velocities.
    pub(super) fn new(
        system: &'a System,
        layout: &'a StateLayout,
        start: Moment,
        units: &'a [f64],
        effort: Effort,
    ) -> Self {
        let deviation = units.iter().zip(1..).map(|(unit, n)| unit * unequal_part(n)).collect();
        Self { system, layout, units, effort, moment: start, deviation }
    }

    /// The current time and state of the motion.
    pub(super) fn moment(&self) -> &Moment {
        &self.moment
    }

    /// Advances by some time; returns the logarithm of the factor by which the deviation has grown.
    pub(super) fn go_on(&mut self, time: f64) -> Result<f64, Cause> {
        let before = self.size();
        self.deviation.iter_mut().for_each(|number| *number /= before);
        let end = self.moment.time + time;
        let start = Moment {
            time: self.moment.time,
            state: merged(self.layout, &self.moment.state, &self.deviation),
        };
        let solution = integrate(self.system, &start, &[end], &self.effort, &Quiet);
        let both = solution.map_err(cause)?.end.state;
        let [state, deviation] = split(self.layout, &both);
        self.deviation = deviation;
        self.moment = Moment { time: end, state };
        let growth = libm::log(self.size());
        if growth.is_finite() { Ok(growth) } else { Err(Cause::Singularity) }
    }

    fn size(&self) -> f64 {
        let parts = self.deviation.iter().zip(self.units).map(|(number, unit)| number / unit);
        parts.map(|part| part * part).sum::<f64>().sqrt()
    }
}

/// A number from 1/4 to 5/4 for each index, without any symmetry: from multiples of the golden ratio.
pub(super) fn unequal_part(index: u32) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    0.25 + (f64::from(index) * GOLDEN).fract()
}

/// The cause for which an integration stopped after it had begun.
fn cause(error: IntegrationError) -> Cause {
    match error {
        IntegrationError::Stopped { cause, .. } => cause,
        // A state that is no longer finite, or times that no longer advance.
        _ => Cause::Singularity,
    }
}

/// The state of the motion together with that of one deviation.
fn merged(layout: &StateLayout, motion: &[f64], deviation: &[f64]) -> Vec<f64> {
    let mut both = vec![0.0; 2 * layout.numbers()];
    for (copy, state) in [motion, deviation].into_iter().enumerate() {
        for (number, value) in state.iter().enumerate() {
            both[layout.place_in_copy(number, copy, 1)] = *value;
        }
    }
    both
}

/// The motion and the deviation, from their common state.
fn split(layout: &StateLayout, both: &[f64]) -> [Vec<f64>; 2] {
    let number = |number, copy| both[layout.place_in_copy(number, copy, 1)];
    [0, 1].map(|copy| (0..layout.numbers()).map(|n| number(n, copy)).collect())
}
