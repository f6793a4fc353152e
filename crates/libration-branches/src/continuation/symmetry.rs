//! Whether the mirror image of a motion is a motion.

use super::drive_law::DriveLaw;
use super::space::Symmetry;
use libration_motion::taylor::StateLayout;
use libration_numbers::algebra::Doubles;
use libration_numbers::internals::expression::{Jet, Tape};

/// States, times and parameters at which it is tried: were the equations not symmetric they would have to be so by chance at all.
const TRIALS: u32 = 12;
/// Accelerations that differ by less than this part of their size do so by rounding.
const SAME: f64 = 1e-11;

/// F(−x, −x′, t + τ) = −F(x, x′, t) with τ zero or half a period, as the values of both sides tell.
pub(super) fn symmetry(
    layout: &StateLayout,
    rates: &Tape,
    law: Option<&DriveLaw>,
    ranges: &[[f64; 2]],
) -> Option<Symmetry> {
    let shifts = [(Symmetry::Unshifted, 0.0), (Symmetry::HalfPeriod, 0.5)];
    shifts
        .into_iter()
        .skip(usize::from(law.is_none()))
        .find(|(_, shift)| {
            (0..TRIALS)
                .all(|trial| holds(layout, rates, law, ranges, [*shift, f64::from(trial)]).unwrap_or(true))
        })
        .filter(|_| {
            (0..TRIALS).any(|trial| holds(layout, rates, law, ranges, [0.0, f64::from(trial)]).is_some())
        })
        .map(|(symmetry, _)| symmetry)
}

/// `None` where there are no values, as for a negative frequency under a root.
fn holds(
    layout: &StateLayout,
    rates: &Tape,
    law: Option<&DriveLaw>,
    ranges: &[[f64; 2]],
    [shift, trial]: [f64; 2],
) -> Option<bool> {
    // Parts of the golden ratio are spread evenly and hit no symmetric place.
    let drawn = |k: u32| 2.0 * ((7.0 * trial + f64::from(k + 1)) * 0.618_033_988_749_894_9).fract() - 1.0;
    let within = |(k, [low, high]): (u32, &[f64; 2])| low + 0.5 * (drawn(k) + 1.0) * (high - low);
    let parameters: Vec<f64> = (1..).zip(ranges).map(within).collect();
    // Without a drive all times are alike.
    let period = law.map_or(Some(1.0), |law| law.period(&parameters).map(|(period, _)| period))?;
    let time = period * 0.5 * (drawn(0) + 1.0);
    let state: Vec<f64> = (10..).map(drawn).take(layout.numbers()).collect();
    let values = |sign: f64, time: f64| -> Option<Vec<f64>> {
        let signed = state.iter().map(|x| sign * x);
        let inputs: Vec<f64> = signed.chain([time]).chain(parameters.iter().copied()).collect();
        let jet = Jet::new(&Doubles, rates, &inputs).ok()?;
        let values: Vec<f64> = (0..layout.coordinates()).map(|result| jet.result(result)[0]).collect();
        values.iter().all(|it| it.is_finite()).then_some(values)
    };
    let (own, mirrored) = (values(1.0, time)?, values(-1.0, time + shift * period)?);
    let size = own.iter().chain(&mirrored).map(|it| it.abs()).fold(f64::MIN_POSITIVE, f64::max);
    Some(own.iter().zip(&mirrored).all(|(a, b)| (a + b).abs() <= SAME * size.max(1.0)))
}
