//! A periodic motion at one value of the parameter.

use super::corrector::{Corrected, Corrector, bordered, norm};
use super::family::{Family, Image, TOLERANCES};
use super::space::{Rotation, Space};
use libration_motion::taylor::{OwnedStep, StateLayout};
use libration_numbers::algebra::{Complex, Doubles};
use libration_numbers::internals::linear::{eigenvalues, solve};
use libration_numbers::roots::{Tolerance, bisect};
use std::f64::consts::TAU;

/// A periodic motion at one value of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct BranchPoint {
    /// The value of the parameter.
    pub parameter: f64,
    /// The state when the phase of the drive is zero: coordinates, then velocities. Without a drive the first coordinate turns back there.
    pub state: Vec<f64>,
    /// After which the motion repeats itself.
    pub period: f64,
    /// The angle that goes around in the period, if one does.
    pub rotation: Option<Rotation>,
    /// The least and the greatest value of each coordinate; of an angle that goes around, of what it is ahead of an even rotation from t = 0 on.
    pub ranges: Vec<[f64; 2]>,
    /// The Floquet multipliers of the whole period by descending magnitude. What is below 1e-13 of the largest is rounding. Without a drive
    /// one of them is exactly 1, that of a deviation along the motion.
    pub multipliers: Vec<Complex>,
    /// Whether all deviations die out, or none grows where energy is conserved.
    pub stable: bool,
    /// The state may be wrong by so much: what another tolerance of the integration and rounding change, across the branch.
    pub error: f64,
}

/// Multipliers beyond the unit circle by less than this are on it.
const ON_THE_CIRCLE: f64 = 1e-9;

impl BranchPoint {
    /// The largest distance of a coordinate from zero; of an angle that swings about another bottom, from there; of one that goes around,
    /// from the even rotation that it is ahead of as much as behind.
    #[must_use]
    pub fn amplitude(&self, coordinate: usize, is_angle: bool) -> f64 {
        let rotates = self.rotation.is_some_and(|it| it.coordinate == coordinate);
        amplitude_of(self.ranges[coordinate], is_angle, rotates)
    }

    /// Whether the two multipliers whose product is nearest to one are complex, and not a real one and its inverse.
    pub(super) fn is_torus(&self) -> bool {
        let own = &self.multipliers;
        let pairs = (0..own.len()).flat_map(|i| (0..i).map(move |j| [own[i], own[j]]));
        let off = |[a, b]: &[Complex; 2]| (*a * *b - Complex::from(1.0)).abs();
        let nearest = pairs.min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.is_some_and(|[a, _]| a.im.abs() > 0.0)
    }
}

/// Of a coordinate from its range.
pub(super) fn amplitude_of([low, high]: [f64; 2], is_angle: bool, rotates: bool) -> f64 {
    if rotates {
        return 0.5 * (high - low);
    }
    let centre = if is_angle { TAU * libm::rint(0.5 * (low + high) / TAU) } else { 0.0 };
    (high - centre).abs().max((low - centre).abs())
}

impl Corrector<'_> {
    /// The unknowns of a motion of the space.
    pub(super) fn unknowns(&self, point: &BranchPoint) -> Vec<f64> {
        let period = (!self.family.is_driven()).then(|| point.period / f64::from(self.space.drive_periods()));
        point.state.iter().copied().chain(period).collect()
    }

    /// What there is to say about a motion; `None` where it cannot be followed.
    pub(super) fn point(&self, corrected: &Corrected, tangent: &[f64], units: &[f64]) -> Option<BranchPoint> {
        let (&parameter, unknowns) = corrected.place.split_last()?;
        let state = self.family.state(unknowns);
        let other = TOLERANCES.into_iter().find(|it| *it > self.tolerance).unwrap_or(0.1 * self.tolerance);
        let duration = self.family.duration(self.space, unknowns, &[parameter])?;
        let (steps, end) = self.family.motion(state, &[parameter], duration, other).ok()?;
        let defect = self.space.missed(&end, state);
        let point = self.family.described(self.space, unknowns, &[parameter], &corrected.image, &steps)?;
        // Where branches cross the state is not determined.
        let error = error(corrected, &defect, tangent, units).unwrap_or(f64::INFINITY);
        Some(BranchPoint { error, ..point })
    }
}

impl Family<'_> {
    /// A motion at some parameters, of which the first is named in it, with an error that is known.
    pub(super) fn point(
        &self,
        space: Space,
        unknowns: &[f64],
        parameters: &[f64],
        image: &Image,
        error: f64,
    ) -> Option<BranchPoint> {
        let duration = self.duration(space, unknowns, parameters)?;
        let (steps, _) = self.motion(self.state(unknowns), parameters, duration, TOLERANCES[1]).ok()?;
        Some(BranchPoint { error, ..self.described(space, unknowns, parameters, image, &steps)? })
    }

    fn described(
        &self,
        space: Space,
        unknowns: &[f64],
        parameters: &[f64],
        image: &Image,
        steps: &[OwnedStep],
    ) -> Option<BranchPoint> {
        let duration = self.duration(space, unknowns, parameters)?;
        let mut own = eigenvalues(image.return_map())?;
        if !self.is_driven() {
            // By descending magnitude: the last one is the 0 of a deviation along the motion, which a whole period brings back.
            own.pop();
            let before = own.iter().take_while(|it| it.abs() > 1.0).count();
            own.insert(before, Complex::from(1.0));
        }
        // Of a mirrored motion the whole period is twice the time of its map.
        let multipliers: Vec<Complex> =
            if space.mirrored { own.into_iter().map(|it| it * it).collect() } else { own };
        Some(BranchPoint {
            parameter: *parameters.first()?,
            state: self.state(unknowns).to_vec(),
            period: if space.mirrored { 2.0 * duration } else { duration },
            rotation: space.rotation,
            ranges: ranges(&self.layout, steps, space, duration),
            stable: is_stable(&multipliers),
            multipliers,
            error: 0.0,
        })
    }
}

/// Whether none is outside of the unit circle.
pub(super) fn is_stable(multipliers: &[Complex]) -> bool {
    multipliers.iter().all(|it| it.abs() <= 1.0 + ON_THE_CIRCLE)
}

/// How far both defects lead across the branch, and what the rounding of the state does.
fn error(corrected: &Corrected, other: &[f64], tangent: &[f64], units: &[f64]) -> Option<f64> {
    let matrix = bordered(&corrected.image, tangent, units);
    let numbers = other.len();
    let rounding: Vec<f64> = corrected.place[..numbers].iter().map(|x| f64::EPSILON * x.abs()).collect();
    let closing =
        (0..numbers).map(|i| (corrected.image.defect[i].abs() + other[i].abs() + rounding[i]) / units[i]);
    let mut missed: Vec<f64> = closing.collect();
    missed.resize(matrix.len(), 0.0);
    let change = solve(&Doubles, |x| x.abs(), &matrix, &missed)?;
    let unit = units[..numbers].iter().copied().fold(0.0, f64::max);
    Some(4.0 * unit * norm(&change[..numbers]))
}

/// The least and greatest value of each coordinate, where its rate of change is zero or a motion begins; an even rotation is taken off.
pub(super) fn ranges(
    layout: &StateLayout,
    steps: &[OwnedStep],
    space: Space,
    duration: f64,
) -> Vec<[f64; 2]> {
    /// A step may be longer than from one turning point to the next: of an oscillator, whose series converge everywhere, it is 3 to 5 radians. None
    /// of its quarters has two of them.
    const PARTS: u32 = 4;
    let of_coordinate = |coordinate: usize| {
        let even = TAU * f64::from(space.turns_of(coordinate)) / duration;
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        let mut widen = |x: f64| range = [range[0].min(x), range[1].max(x)];
        for own in steps {
            let step = own.step();
            let place = |time: f64| step.number_at(coordinate, time) - even * time;
            let rises = |time: f64| match layout.velocity(coordinate) {
                Some(velocity) => step.number_at(velocity, time) > even,
                None => step.speeds_at(time)[coordinate] > even,
            };
            let length = step.end() - step.start();
            let mut before = (step.start(), rises(step.start()));
            widen(place(step.start()));
            for number in 1..=PARTS {
                let time = step.start() + length * f64::from(number) / f64::from(PARTS);
                let after = (time, rises(time));
                if after.1 != before.1 {
                    let is_before = |time: f64| rises(time) != after.1;
                    let [turn, _] = bisect([before.0, time], Tolerance::relative(1e-9), is_before);
                    widen(place(turn));
                }
                before = after;
            }
            widen(place(before.0));
        }
        let [low, high] = range;
        if space.mirrored { [low.min(-high), high.max(-low)] } else { range }
    };
    (0..layout.coordinates()).map(of_coordinate).collect()
}
