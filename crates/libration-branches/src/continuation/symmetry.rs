//! Whether the mirror image of a motion is a motion.

use super::drive_law::DriveLaw;
use super::space::Symmetry;
use libration_kernels::elementary::count;
use libration_motion::taylor::StateLayout;
use libration_numbers::algebra::Doubles;
use libration_numbers::internals::expression::{Jet, Operation, Tape};

/// States, times and parameters at which the equation is tried: an equation without the symmetry would have to pass by chance at all of them.
const TRIALS: u32 = 12;
/// Powers of two by which states are scaled where the force has kinks, so that both sides of each kink are tried. A force without kinks is
/// analytic: what holds near one state holds at all.
const SCALES: [i32; 2] = [-60, 60];

/// The shift τ, zero or half a period, with which F(−x, −x′, t + τ) = −F(x, x′, t) for all states: a property of the equation, not of some of
/// its orbits. The values of both sides are compared at states of all sizes; a difference below the rounding of the largest intermediate
/// value is not seen.
pub(super) fn symmetry(
    layout: &StateLayout,
    rates: &Tape,
    law: Option<&DriveLaw>,
    ranges: &[[f64; 2]],
) -> Option<Symmetry> {
    let equation = Trial { layout, rates, law, ranges };
    let shifts = [(Symmetry::Unshifted, 0.0), (Symmetry::HalfPeriod, 0.5)];
    let shifts = shifts.into_iter().skip(usize::from(law.is_none()));
    let mut symmetric = shifts.filter(|(_, shift)| {
        let trials = || (0..TRIALS).flat_map(|trial| equation.scales().map(move |scale| (trial, scale)));
        let mut outcomes = trials().map(|(trial, scale)| equation.holds(*shift, trial, scale));
        let mut values = false;
        outcomes.all(|outcome| {
            values |= outcome.is_some();
            outcome.unwrap_or(true)
        }) && values
    });
    symmetric.next().map(|(symmetry, _)| symmetry)
}

/// The equation that is tried.
struct Trial<'a> {
    layout: &'a StateLayout,
    rates: &'a Tape,
    law: Option<&'a DriveLaw>,
    ranges: &'a [[f64; 2]],
}

impl Trial<'_> {
    fn scales(&self) -> impl Iterator<Item = f64> + use<> {
        let kink = |operation: &Operation| matches!(operation, Operation::Abs(_) | Operation::Sign(_));
        let operations = self.rates.operations().iter().enumerate();
        let has_kinks = operations.into_iter().any(|(place, it)| kink(it) && !self.rates.is_constant(place));
        let [least, most] = if has_kinks { SCALES } else { [0, 0] };
        (least..=most).step_by(2).map(|power| libm::ldexp(1.0, power))
    }

    /// `None` where there are no values, as for a negative frequency under a root.
    fn holds(&self, shift: f64, trial: u32, scale: f64) -> Option<bool> {
        /// Roundings of the largest value for each operation.
        const ROUNDINGS: f64 = 8.0;
        // Parts of the golden ratio are spread evenly and hit no symmetric place.
        let drawn =
            |k: u32| 2.0 * ((7.0 * f64::from(trial) + f64::from(k + 1)) * 0.618_033_988_749_894_9).fract() - 1.0;
        let within = |(k, [low, high]): (u32, &[f64; 2])| low + 0.5 * (drawn(k) + 1.0) * (high - low);
        let parameters: Vec<f64> = (1..).zip(self.ranges).map(within).collect();
        // Without a drive all times are alike.
        let period = self.law.map_or(Some(1.0), |law| law.period(&parameters).map(|(period, _)| period))?;
        let time = period * 0.5 * (drawn(0) + 1.0);
        let state: Vec<f64> = (10..).map(|k| scale * drawn(k)).take(self.layout.numbers()).collect();
        let (own, size) = self.values(state.iter().copied(), time, &parameters)?;
        let (mirrored, other) = self.values(state.iter().map(|x| -x), time + shift * period, &parameters)?;
        let rounding = ROUNDINGS * f64::EPSILON * count(self.rates.operations().len()) * size.max(other);
        Some(own.iter().zip(&mirrored).all(|(a, b)| (a + b).abs() <= rounding))
    }

    /// The derivatives, and the largest intermediate value; `None` where one is not finite.
    fn values(
        &self,
        state: impl Iterator<Item = f64>,
        time: f64,
        parameters: &[f64],
    ) -> Option<(Vec<f64>, f64)> {
        let inputs: Vec<f64> = state.chain([time]).chain(parameters.iter().copied()).collect();
        let jet = Jet::new(&Doubles, self.rates, &inputs).ok()?;
        let largest = jet.values().map(|it| it.abs()).fold(0.0, f64::max);
        let values: Vec<f64> = (0..self.layout.coordinates()).map(|result| jet.result(result)[0]).collect();
        (largest.is_finite() && values.iter().all(|it| it.is_finite())).then_some((values, largest))
    }
}
