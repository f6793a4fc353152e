//! A system as a function of its symbolic parameters: the end of a motion depending on the start and the parameters.

use super::drive_law::DriveLaw;
use super::error::BranchError;
use super::field::{Field, Rates, returned};
use super::mirror::Mirror;
use super::space::{Rotation, Space, Symmetry};
use super::symmetry::{has_partial_mirror, symmetry};
use super::turns::Turns;
use libration_motion::internals::periodic::{Flow, Variations, norm, norm_of_map};
use libration_motion::taylor::{IntegrationError, OwnedStep, StateLayout};
use libration_numbers::algebra::Doubles;
use libration_numbers::expression::Equation;
use libration_numbers::internals::expression::{Jet, Tape};
use libration_numbers::internals::progress::Watch;
use std::f64::consts::TAU;

/// Source of the period of a motion.
#[derive(Debug)]
enum Beat {
    /// The drive, whose period depends on the parameters.
    Drive(DriveLaw),
    /// The motion itself: its period is another unknown, and the motion begins where the first coordinate turns back.
    Own(Field),
}

impl Beat {
    const fn law(&self) -> Option<&DriveLaw> {
        match self {
            Self::Drive(law) => Some(law),
            Self::Own(_) => None,
        }
    }
}

/// A system with symbolic parameters. The unknowns of a motion are the components of its state, followed by its period if no drive sets it.
#[derive(Debug)]
pub(super) struct Family<'w> {
    pub(super) layout: StateLayout,
    pub(super) symmetry: Option<Symmetry>,
    pub(super) mirror: Mirror,
    /// The angles, whose whole turns change nothing.
    pub(super) turning: Turns,
    beat: Beat,
    flow: Flow,
    /// The ranges of the parameters.
    ranges: Vec<[f64; 2]>,
    /// The size of the coordinates where a motion does not show it.
    pub(super) scale: f64,
    /// The size of motions under the drive by the inertia; zero if it is not known.
    by_drive: f64,
    pub(super) watch: &'w Watch<'w>,
}

/// Image of a state after the time of its space; mirrored if the space has a mirror.
#[derive(Clone, Debug)]
pub(super) struct Image {
    /// Image minus start, followed, if no drive sets the period, by the deviation of the start from its phase condition.
    pub(super) defect: Vec<f64>,
    /// Derivative of the image with respect to the unknowns, by rows: the derivative of the defect plus the identity.
    pub(super) map: Vec<Vec<f64>>,
    /// Derivative of the return to the phase condition with respect to the start, if no drive sets the period.
    returned: Option<Vec<Vec<f64>>>,
    /// The largest size of each derivative of the state by the start along the motion, if no drive sets the period.
    largest: Vec<Vec<f64>>,
    /// Derivatives with respect to each parameter, including the dependence of the time on it.
    pub(super) by_parameters: Vec<Vec<f64>>,
}

impl Image {
    /// Adds the dependence of the time on the parameters, given by its slopes.
    fn in_time_of_drive(mut self, rate: &[f64], slopes: &[f64]) -> Self {
        for (by_parameter, slope) in self.by_parameters.iter_mut().zip(slopes) {
            by_parameter.iter_mut().zip(rate).for_each(|(x, rate)| *x += slope * rate);
        }
        self
    }

    /// Adds the period as an unknown, of which the time is a fraction `share`, and the equation that the first coordinate turns back at the start:
    /// its rate, times a unit that makes it a time.
    fn beginning_at_turn(mut self, rate: &[f64], share: f64, start: Rates, unit: f64) -> Option<Self> {
        let (phase, slopes) = (start.rates[0], &start.slopes[0]);
        let (by_state, by_parameters) = slopes.split_at(self.map.len());
        self.returned = Some(returned(&self.map, rate, by_state)?);
        self.map.iter_mut().zip(rate).for_each(|(row, rate)| row.push(share * rate));
        self.map.push(by_state.iter().map(|slope| unit * slope).chain([1.0]).collect());
        self.defect.push(unit * phase);
        self.by_parameters.iter_mut().zip(by_parameters).for_each(|(all, slope)| all.push(unit * slope));
        Some(self)
    }

    /// The norm of the difference between two maps relative to the norm of this one, in scaled units.
    pub(super) fn change(&self, other: &Self, units: &[f64]) -> f64 {
        let (map, other) = (self.return_map(), other.return_map());
        let norm = |entry: &dyn Fn(usize, usize) -> f64| norm_of_map(map.len(), units, entry);
        norm(&|i, j| map[i][j] - other[i][j]) / norm(&|i, j| map[i][j])
    }

    /// The largest size of deviations along the motion relative to the norm of the return map, in scaled units and at least 1, if no drive sets
    /// the period. They grow and fall along a motion that passes near an equilibrium, and the part along the motion is subtracted.
    pub(super) fn growth_along(&self, units: &[f64]) -> Option<f64> {
        let returned = self.returned.as_ref()?;
        let numbers = returned.len();
        let rate = || self.map[..numbers].iter().map(|row| row[numbers]);
        let slopes = &self.map[numbers][..numbers];
        let across: f64 = rate().zip(slopes).map(|(a, b)| a * b).sum();
        let scaled_rate: Vec<f64> = rate().zip(units).map(|(x, unit)| x / unit).collect();
        let scaled_slopes: Vec<f64> = slopes.iter().zip(units).map(|(x, unit)| x * unit).collect();
        let along = norm(&scaled_rate) * norm(&scaled_slopes) / across.abs();
        let whole = norm_of_map(numbers, units, |i, j| self.map[i][j].abs().max(self.largest[i][j]));
        Some(f64::max(1.0, (1.0 + along) * whole / norm_of_map(numbers, units, |i, j| returned[i][j])))
    }

    /// The map whose eigenvalues are the multipliers; without a drive, the 1 of a deviation along the motion is a 0 there.
    pub(super) fn return_map(&self) -> &[Vec<f64>] {
        self.returned.as_ref().unwrap_or(&self.map)
    }
}

/// The integration tolerance for computing points, and a second one with different errors.
pub(super) const TOLERANCES: [f64; 2] = [1e-16, 1e-15];
/// Maximum number of steps of one motion.
const MOST_STEPS: usize = 100_000;

/// Coordinates below this, or above its inverse, are of other units than those of the others.
const OTHER_UNITS: f64 = 1e-6;

/// Returns `true` for a size that differs from 1 by more orders of magnitude than scales do.
fn is_of_other_units(size: f64) -> bool {
    size > 0.0 && size.is_finite() && !(OTHER_UNITS..=1.0 / OTHER_UNITS).contains(&size)
}

/// The size of motions under a drive by the inertia: the largest rate at rest in a period, times the square of the time in which the phase is 1; zero
/// if it is not known at both ends of the ranges.
fn size_under_drive(layout: &StateLayout, rates: &Tape, law: &DriveLaw, ranges: &[[f64; 2]]) -> f64 {
    const TIMES: u32 = 16;
    let largest = [0, 1].map(|end| {
        let parameters: Vec<f64> = ranges.iter().map(|range| range[end]).collect();
        let (period, _) = law.period(&parameters)?;
        let at = |time: u32| {
            let time = period * f64::from(time) / f64::from(TIMES);
            let rest = std::iter::repeat_n(0.0, layout.numbers());
            let inputs: Vec<f64> = rest.chain([time]).chain(parameters.iter().copied()).collect();
            let jet = Jet::new(&Doubles, rates, &inputs).ok()?;
            let values = (0..layout.coordinates()).map(|result| {
                let unit = period / TAU;
                let of_order = if layout.velocity(result).is_some() { unit * unit } else { unit };
                jet.result(result)[0].abs() * of_order
            });
            Some(values.fold(0.0, f64::max))
        };
        (0..TIMES).map(at).try_fold(0.0_f64, |largest, size| Some(largest.max(size?)))
    });
    let is_known = largest.iter().all(Option::is_some);
    if is_known { largest.into_iter().flatten().fold(0.0, f64::max) } else { 0.0 }
}

impl<'w> Family<'w> {
    /// Creates the family of a driven system.
    pub(super) fn new(
        equation: &Equation,
        parameters: &[&str],
        ranges: &[[f64; 2]],
        watch: &'w Watch<'w>,
    ) -> Result<Self, BranchError> {
        let law = DriveLaw::new(equation, parameters)?;
        Self::with_beat(equation, parameters, ranges, Beat::Drive(law), watch)
    }

    /// Creates the family of a driven system, or of an autonomous one if the time does not occur in the equations.
    pub(super) fn free_or_driven(
        equation: &Equation,
        parameters: &[&str],
        ranges: &[[f64; 2]],
        watch: &'w Watch<'w>,
    ) -> Result<Self, BranchError> {
        if equation.depends_on_time() {
            return Self::new(equation, parameters, ranges, watch);
        }
        let field = Field::new(equation, parameters)?;
        Self::with_beat(equation, parameters, ranges, Beat::Own(field), watch)
    }

    fn with_beat(
        equation: &Equation,
        parameters: &[&str],
        ranges: &[[f64; 2]],
        beat: Beat,
        watch: &'w Watch<'w>,
    ) -> Result<Self, BranchError> {
        let flow = Flow::new(equation, parameters, MOST_STEPS)?.for_many_steps();
        let by_drive =
            beat.law().map_or(0.0, |law| size_under_drive(&flow.layout, flow.rates(), law, ranges));
        let scale = if is_of_other_units(by_drive) { by_drive } else { 1.0 };
        let (layout, ranges) = (flow.layout.clone(), ranges.to_vec());
        let (symmetry, mirror) = symmetry(&layout, flow.rates(), beat.law(), &ranges, &[scale, by_drive]);
        Ok(Self {
            layout,
            symmetry,
            mirror,
            turning: Turns::of(equation),
            beat,
            flow,
            ranges,
            scale,
            by_drive,
            watch,
        })
    }

    /// The family with its symmetry, which is sought at motions of its scale.
    fn with_symmetry(mut self) -> Self {
        let Self { layout, flow, beat, ranges, .. } = &self;
        let sizes = [self.scale, self.by_drive];
        (self.symmetry, self.mirror) = symmetry(layout, flow.rates(), beat.law(), ranges, &sizes);
        self
    }

    /// The family with the scale of a state, where that of its motions is not known and the state is of other units.
    pub(super) fn at_scale_of(self, state: &[f64]) -> Self {
        let size = state.iter().map(|x| x.abs()).fold(0.0, f64::max);
        let is_open = self.scale.total_cmp(&1.0).is_eq() && is_of_other_units(size);
        if is_open { Self { scale: size, ..self }.with_symmetry() } else { self }
    }

    /// `true` if some mirror image without a shift in time maps a motion to itself and a deviation to its opposite; both are in scaled units.
    pub(super) fn loses_partial_mirror(&self, state: &[f64], deviation: &[f64]) -> bool {
        /// Smallest component that matters, relative to the largest one.
        const LEAST: f64 = 1e-3;
        let counts = |vector: &[f64]| -> Vec<bool> {
            let largest = vector.iter().map(|x| x.abs()).fold(0.0, f64::max);
            vector.iter().map(|x| x.abs() > LEAST * largest).collect()
        };
        let Self { layout, flow, beat, ranges, .. } = self;
        let (changed, kept) = (counts(deviation), counts(state));
        let sizes = [self.scale, self.by_drive];
        has_partial_mirror(layout, flow.rates(), beat.law(), ranges, &sizes, [&changed, &kept])
    }

    /// `true` if a force jumps.
    pub(super) const fn has_jumps(&self) -> bool {
        self.flow.has_jumps()
    }

    pub(super) fn is_driven(&self) -> bool {
        self.field().is_none()
    }

    /// The rates of change, if no drive sets the period.
    pub(super) fn field(&self) -> Option<&Field> {
        match &self.beat {
            Beat::Drive(_) => None,
            Beat::Own(field) => Some(field),
        }
    }

    /// The highest derivatives of the coordinates as a tape in the state, the time and the parameters.
    pub(super) const fn rates(&self) -> &Tape {
        self.flow.rates()
    }

    /// The state, as part of the unknowns.
    pub(super) fn state<'u>(&self, unknowns: &'u [f64]) -> &'u [f64] {
        &unknowns[..self.layout.numbers()]
    }

    /// The time over which a motion of a space is followed.
    pub(super) fn duration(&self, space: Space, unknowns: &[f64], parameters: &[f64]) -> Option<f64> {
        let period = match &self.beat {
            Beat::Drive(law) => law.period(parameters)?.0,
            Beat::Own(_) => *unknowns.last()?,
        };
        (period > 0.0).then(|| 0.5 * f64::from(space.half_periods) * period)
    }

    /// The derivatives of the duration with respect to the period, if this is an unknown, and to the parameters.
    pub(super) fn duration_slopes(&self, space: Space, parameters: &[f64]) -> Option<Vec<f64>> {
        let share = 0.5 * f64::from(space.half_periods);
        Some(match &self.beat {
            Beat::Drive(law) => law.period(parameters)?.1.into_iter().map(|slope| share * slope).collect(),
            Beat::Own(_) => [share].into_iter().chain(parameters.iter().map(|_| 0.0)).collect(),
        })
    }

    /// The period of the drive, if there is one.
    pub(super) fn drive_period(&self, parameters: &[f64]) -> Option<f64> {
        match &self.beat {
            Beat::Drive(law) => law.period(parameters).map(|(period, _)| period),
            Beat::Own(_) => None,
        }
    }

    /// The smaller spaces within a space, with the image of a motion in each. The mirror image of a motion may lie whole turns beside it.
    pub(super) fn images_within(
        &self,
        space: Space,
        unknowns: &[f64],
        parameters: &[f64],
        tolerance: f64,
    ) -> impl Iterator<Item = (Space, Image)> {
        let smaller = space.within(self.symmetry).into_iter();
        smaller.filter_map(move |space| {
            let mut image = self.image(space, unknowns, parameters, tolerance)?;
            let beside = self.turning.between(&image.defect).filter(|_| space.mirrored);
            if let Some(Rotation { coordinate, turns }) = beside {
                image.defect[coordinate] -= TAU * f64::from(turns);
            }
            Some((Space { beside, ..space }, image))
        })
    }

    /// The image of a motion with its derivatives; `None` if the motion cannot be integrated.
    pub(super) fn image(
        &self,
        space: Space,
        unknowns: &[f64],
        parameters: &[f64],
        tolerance: f64,
    ) -> Option<Image> {
        let state = self.state(unknowns);
        let duration = self.duration(space, unknowns, parameters)?;
        let sign = |component: usize| if space.mirrored { self.mirror.sign(component) } else { 1.0 };
        let signed = |vector: Vec<f64>| {
            vector.into_iter().enumerate().map(|(component, x)| sign(component) * x).collect::<Vec<f64>>()
        };
        let (variations, largest) = self.variations_with_sizes(state, parameters, duration, tolerance)?;
        let Variations { end, by_start, by_parameters, rates: [_, rate] } = variations;
        let rate = signed(rate);
        let image = Image {
            defect: space.missed(&end, state, &self.mirror),
            map: (0..)
                .zip(by_start)
                .map(|(component, row)| row.into_iter().map(|x| sign(component) * x).collect())
                .collect(),
            returned: None,
            largest,
            by_parameters: by_parameters.into_iter().map(signed).collect(),
        };
        let share = 0.5 * f64::from(space.half_periods);
        match &self.beat {
            Beat::Drive(_) => Some(image.in_time_of_drive(&rate, &self.duration_slopes(space, parameters)?)),
            Beat::Own(field) => {
                let pace = unknowns.last()? / TAU;
                let unit = pace * pace / self.scale;
                image.beginning_at_turn(&rate, share, field.at(state, parameters)?, unit)
            }
        }
    }

    /// The end of a motion between two times with its derivatives; `None` if the motion cannot be integrated.
    pub(super) fn variations(
        &self,
        state: &[f64],
        parameters: &[f64],
        times: [f64; 2],
        tolerance: f64,
    ) -> Option<Variations> {
        let variations = self.flow.variations(state, parameters, times, tolerance, || self.watch.flow());
        variations.ok().filter(is_finite)
    }

    /// The same from time zero, with the largest sizes of the derivatives by the start if no drive sets the period.
    fn variations_with_sizes(
        &self,
        state: &[f64],
        parameters: &[f64],
        duration: f64,
        tolerance: f64,
    ) -> Option<(Variations, Vec<Vec<f64>>)> {
        let times = [0.0, duration];
        if self.is_driven() {
            return Some((self.variations(state, parameters, times, tolerance)?, vec![]));
        }
        let watch = || self.watch.flow();
        let outcome = self.flow.largest_variations(state, parameters, times, tolerance, watch);
        outcome.ok().filter(|(integrated, _)| is_finite(integrated))
    }

    /// A start that is not an equilibrium: the coordinates of an equilibrium are displaced a little, each less than the one before, since equal
    /// displacements of equal oscillators would keep them equal.
    pub(super) fn displaced(&self, mut state: Vec<f64>, value: f64) -> Vec<f64> {
        /// Rates of change, relative to those that the coordinates cause one by one, of an equilibrium that is typed with nine digits.
        const REST: f64 = 1e-9;
        const ASIDE: f64 = 0.1;
        const LESS: f64 = 0.7;
        let rates = self.field().and_then(|field| field.at(&state, &[value]));
        let is_zero = |(rate, slopes): (&f64, &Vec<f64>)| {
            rate.abs() <= REST * slopes.iter().zip(&state).map(|(slope, x)| (slope * x).abs()).sum::<f64>()
        };
        if rates.is_some_and(|values| values.rates.iter().zip(&values.slopes).all(is_zero)) {
            let mut aside = ASIDE;
            for coordinate in &mut state[..self.layout.coordinates()] {
                *coordinate += aside * coordinate.abs().max(self.scale);
                aside *= LESS;
            }
        }
        state
    }

    /// Number of times, at least 1, that the first coordinate begins to rise in a period that starts at a turning point.
    pub(super) fn turns(&self, state: &[f64], value: f64, period: f64) -> Option<u32> {
        let (steps, _) = self.motion(state, &[value], [0.0, period], TOLERANCES[1]).ok()?;
        let rises = |owned: &OwnedStep, time: f64| owned.step().speeds_at(time)[0] > 0.0;
        let begins_to =
            |owned: &&OwnedStep| !rises(owned, owned.step().start()) && rises(owned, owned.step().end());
        u32::try_from(steps.iter().filter(begins_to).count().max(1)).ok()
    }

    /// The motion without derivatives between two times: its steps and its end.
    pub(super) fn motion(
        &self,
        state: &[f64],
        parameters: &[f64],
        times: [f64; 2],
        tolerance: f64,
    ) -> Result<(Vec<OwnedStep>, Vec<f64>), IntegrationError> {
        let mut steps = vec![];
        let solution = self.flow.motion(state, parameters, times, tolerance, |step| {
            steps.push(step.to_owned_step());
            self.watch.flow()
        })?;
        Ok((steps, solution.end.state))
    }

    /// The state at a later time, from a state at a phase of the drive.
    pub(super) fn moved_on(&self, state: &[f64], value: f64, times: [f64; 2]) -> Option<Vec<f64>> {
        let solution = self.flow.motion(state, &[value], times, TOLERANCES[1], |_| self.watch.flow());
        Some(solution.ok()?.end.state)
    }

    /// The time derivative of a state.
    pub(super) fn rate(&self, state: &[f64], time: f64, parameters: &[f64]) -> Option<Vec<f64>> {
        self.flow.rate(state, time, parameters)
    }
}

/// Returns `true` if all numbers are finite but, perhaps, the rates of change at the start.
fn is_finite(variations: &Variations) -> bool {
    let matrices =
        variations.by_start.iter().chain(&variations.by_parameters).chain(&variations.rates[1..]).flatten();
    variations.end.iter().chain(matrices).copied().all(f64::is_finite)
}
