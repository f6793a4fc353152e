//! Test whether the mirror image of a motion is a motion.

use super::centre::centres;
use super::drive_law::DriveLaw;
use super::mirror::Mirror;
use super::space::Symmetry;
use libration_kernels::elementary::count;
use libration_motion::taylor::StateLayout;
use libration_numbers::algebra::Doubles;
use libration_numbers::internals::expression::{Jet, Operation, Tape};
use std::f64::consts::TAU;

/// Number of states, times and parameters at which the equation is tested: an
/// equation without the symmetry would have to pass by chance at all of them.
const TRIALS: u32 = 12;
/// Powers of two by which states are scaled if the force has kinks, so that both sides of each
/// kink are tested. A force without kinks is analytic: a symmetry near one state holds everywhere.
const SCALES: [i32; 2] = [-60, 60];

/// The symmetry of a system, and its mirror image.
///
/// F(c + S·x, t + τ) = S·F(c + x, t) for all states, with a centre c, a diagonal matrix S of signs and a shift τ of zero or half a period. This is a
/// property of the equation, not of some of its orbits. S changes all signs or some of them, as in (x, y, z) → (−x, −y, z) for the Lorenz system;
/// with a drive, only some signs may change if τ is half a period. Without a drive the period is counted from one maximum of the first coordinate
/// to the next: if S keeps its sign, the mirror image comes after whole periods, otherwise after odd numbers of half periods. The values of
/// both sides are compared at states of all sizes; a difference below the rounding of the largest intermediate value is not detected. The centre
/// is zero, or else one of those in `centre.rs`.
pub(super) fn symmetry(
    layout: &StateLayout,
    rates: &Tape,
    law: Option<&DriveLaw>,
    ranges: &[[f64; 2]],
    sizes: &[f64],
) -> (Option<Symmetry>, Mirror) {
    let zero = vec![0.0; layout.coordinates()];
    let middle: Vec<f64> = ranges.iter().map(|[low, high]| f64::midpoint(*low, *high)).collect();
    let period = law.map_or(Some(1.0), |law| law.period(&middle).map(|(period, _)| period.abs()));
    let others = || period.map_or(vec![], |period| centres(layout, rates, (period, &middle), sizes[0]));
    let about = |centre: Vec<f64>| {
        let equation = Trial { layout, rates, law, ranges, sizes, centre: &centre };
        let (symmetry, signs) = equation.symmetry()?;
        let (signs, centre) = (equation.of_state(&signs), layout.arrange(centre.iter().copied(), |_| 0.0));
        Some((Some(symmetry), Mirror::new(signs, &centre)))
    };
    let numbers = layout.numbers();
    let none = || (None, Mirror::new(vec![1.0; numbers], &vec![0.0; numbers]));
    about(zero).or_else(|| others().into_iter().find_map(about)).unwrap_or_else(none)
}

/// `true` if the equation has a mirror image without a shift in time that changes these components of a state and keeps the others.
pub(super) fn has_partial_mirror(
    layout: &StateLayout,
    rates: &Tape,
    law: Option<&DriveLaw>,
    ranges: &[[f64; 2]],
    sizes: &[f64],
    [changed, kept]: [&[bool]; 2],
) -> bool {
    let centre = &vec![0.0; layout.coordinates()];
    let equation = Trial { layout, rates, law, ranges, sizes, centre };
    let fits = |mirror: &Vec<f64>| {
        let signs = equation.of_state(mirror);
        let agrees =
            |((sign, changed), kept): ((&f64, &bool), &bool)| !if *sign < 0.0 { *kept } else { *changed };
        signs.iter().zip(changed).zip(kept).all(agrees)
    };
    mirrors(layout.coordinates()).filter(fits).any(|mirror| equation.has(0.0, &mirror))
}

/// The signs of coordinates, some of them −1: first with all −1, last those that keep the sign of the first coordinate.
fn mirrors(coordinates: usize) -> impl Iterator<Item = Vec<f64>> {
    /// Largest number of coordinates for which partial mirror images are tried.
    const MOST: usize = 7;
    let kept = move |number: usize, pattern: usize| {
        let from_the_last = coordinates - 1 - number;
        from_the_last < MOST && pattern >> from_the_last & 1 == 1
    };
    let mirror = move |pattern: usize| {
        (0..coordinates).map(|number| if kept(number, pattern) { 1.0 } else { -1.0 }).collect()
    };
    let is_identity = move |mirror: &Vec<f64>| mirror.iter().all(|sign| *sign > 0.0);
    (0..1 << coordinates.min(MOST)).map(mirror).filter(move |mirror| !is_identity(mirror))
}

/// The equation that is tried.
struct Trial<'a> {
    layout: &'a StateLayout,
    rates: &'a Tape,
    law: Option<&'a DriveLaw>,
    ranges: &'a [[f64; 2]],
    /// Other sizes of states that are tried: at that of the motions no other term hides the drive, and the drive hides none.
    sizes: &'a [f64],
    /// The coordinates about which mirror images are tried.
    centre: &'a [f64],
}

impl Trial<'_> {
    /// The symmetry about the centre, if there is one, with the signs of the coordinates.
    fn symmetry(&self) -> Option<(Symmetry, Vec<f64>)> {
        let coordinates = self.layout.coordinates();
        let all = (Symmetry::Unshifted, vec![-1.0; coordinates]);
        let of_mirror = |mirror: Vec<f64>| match self.law {
            None if mirror[0] > 0.0 => (Symmetry::Unshifted, mirror),
            _ => (Symmetry::HalfPeriod, mirror),
        };
        let mut candidates = self.law.map(|_| all).into_iter().chain(mirrors(coordinates).map(of_mirror));
        let shift = |symmetry: &Symmetry| if *symmetry == Symmetry::HalfPeriod { 0.5 } else { 0.0 };
        candidates.find(|(symmetry, mirror)| self.has(shift(symmetry), mirror))
    }

    fn scales(&self) -> impl Iterator<Item = f64> + '_ {
        let kink = |operation: &Operation| matches!(operation, Operation::Abs(_) | Operation::Sign(_));
        let operations = self.rates.operations().iter().enumerate();
        let has_kinks =
            operations.into_iter().any(|(slot, operation)| kink(operation) && !self.rates.is_constant(slot));
        let [least, most] = if has_kinks { SCALES } else { [0, 0] };
        let others =
            self.sizes.iter().copied().filter(|size| size.is_normal() && size.total_cmp(&1.0).is_ne());
        (least..=most).step_by(2).map(|power| libm::ldexp(1.0, power)).chain(others)
    }

    /// The signs of the components of a state: a velocity has the sign of its coordinate.
    fn of_state(&self, mirror: &[f64]) -> Vec<f64> {
        self.layout.arrange(mirror.iter().copied(), |coordinate| mirror[coordinate])
    }

    /// Returns `true` if the equation has a symmetry in all trials with values, of which there must be at least one.
    fn has(&self, shift: f64, mirror: &[f64]) -> bool {
        let trials = (0..TRIALS).flat_map(|trial| self.scales().map(move |scale| (trial, scale)));
        let mut outcomes = trials.map(|(trial, scale)| self.holds(shift, mirror, trial, scale));
        let mut values = false;
        outcomes.all(|outcome| {
            values |= outcome.is_some();
            outcome.unwrap_or(true)
        }) && values
    }

    /// `None` if the trial has no values, as for a negative frequency under a root.
    fn holds(&self, shift: f64, mirror: &[f64], trial: u32, scale: f64) -> Option<bool> {
        /// Rounding errors of the largest value, per operation.
        const ROUNDINGS: f64 = 8.0;
        // Multiples of the golden ratio are evenly distributed and avoid symmetric positions.
        let drawn = |k: u32| {
            2.0 * ((7.0 * f64::from(trial) + f64::from(k + 1)) * 0.618_033_988_749_894_9).fract() - 1.0
        };
        let within = |(k, [low, high]): (u32, &[f64; 2])| low + 0.5 * (drawn(k) + 1.0) * (high - low);
        let parameters: Vec<f64> = (1..).zip(self.ranges).map(within).collect();
        // Without a drive all times are equivalent.
        let period = self.law.map_or(Some(1.0), |law| law.period(&parameters).map(|(period, _)| period))?;
        let time = period * 0.5 * (drawn(0) + 1.0);
        let pace = self.law.map_or(1.0, |_| TAU / period.abs());
        let units = self.layout.arrange(vec![1.0; self.layout.coordinates()], |_| pace);
        let state: Vec<f64> = (10..).zip(units).map(|(k, unit)| scale * unit * drawn(k)).collect();
        let centre = self.layout.arrange(self.centre.iter().copied(), |_| 0.0);
        let from_centre = |(x, centre): (f64, &f64)| centre + x;
        let here = state.iter().copied().zip(&centre).map(from_centre);
        let (values, size) = self.values(here, time, &parameters)?;
        let image = state.iter().zip(self.of_state(mirror)).map(|(x, sign)| sign * x).zip(&centre);
        let (mirrored, other) = self.values(image.map(from_centre), time + shift * period, &parameters)?;
        let rounding = ROUNDINGS * f64::EPSILON * count(self.rates.operations().len()) * size.max(other);
        let differences = values.iter().zip(&mirrored).zip(mirror).map(|((a, b), sign)| (sign * a - b).abs());
        Some(differences.fold(0.0, f64::max) <= rounding)
    }

    /// The derivatives, and the largest intermediate value; `None` if a value is not finite.
    fn values(
        &self,
        state: impl Iterator<Item = f64>,
        time: f64,
        parameters: &[f64],
    ) -> Option<(Vec<f64>, f64)> {
        let inputs: Vec<f64> = state.chain([time]).chain(parameters.iter().copied()).collect();
        let jet = Jet::new(&Doubles, self.rates, &inputs).ok()?;
        let largest = jet.values().map(|value| value.abs()).fold(0.0, f64::max);
        let values: Vec<f64> = (0..self.layout.coordinates()).map(|result| jet.result(result)[0]).collect();
        (largest.is_finite() && values.iter().all(|value| value.is_finite())).then_some((values, largest))
    }
}
