//! A curve of singular points over two parameters, followed from a point on it.

use super::branch::Ending;
use super::family::TOLERANCES;
use super::point::BranchPoint;
use super::singular::Singular;
use super::space::Space;
use super::special::{SpecialKind, Test};
use libration_motion::internals::periodic::norm;
use libration_numbers::algebra::Doubles;
use libration_numbers::internals::linear::solve;
use libration_numbers::roots::{Tolerance, zero_between};

/// A singular motion at values of two parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvePoint {
    /// The motion. Its parameter is the first one, and its error is the error of both parameters perpendicular to the curve.
    pub point: BranchPoint,
    /// The value of the second parameter.
    pub second: f64,
}

/// Consecutive singular motions of one kind over two parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct SpecialCurve {
    /// Kind of the singular points on the curve.
    pub kind: SpecialKind,
    /// `true` if the motion is the equilibrium.
    pub at_rest: bool,
    /// Space of the orbits: their period and symmetry.
    pub space: Space,
    /// Points in order; for a closed curve the last point is the first.
    pub points: Vec<CurvePoint>,
    /// Cusps: points in the parameter plane at which two fold curves meet and end.
    pub cusps: Vec<CurvePoint>,
    /// Reasons why the curve ends, before its first point and after its last one.
    pub endings: [Ending; 2],
}

/// The part of a curve on which the motion is stable on one side. Elsewhere a further multiplier is outside the unit circle, and the motion is unstable
/// on both sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundaryPart {
    /// All points of the curve.
    Whole,
    /// Some of the points of the curve.
    Part,
    /// No point of the curve.
    None,
}

impl BoundaryPart {
    /// The name in machine-readable output.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Whole => "whole",
            Self::Part => "part",
            Self::None => "none",
        }
    }
}

impl CurvePoint {
    /// Returns `true` if the motion is stable on one side of the curve: no multiplier is outside the unit circle by more than its error.
    #[must_use]
    pub fn bounds_stability(&self) -> bool {
        self.point.is_stable()
    }
}

impl SpecialCurve {
    /// The part of the curve that is a stability boundary.
    #[must_use]
    pub fn stability_boundary(&self) -> BoundaryPart {
        let count = self.points.iter().filter(|point| point.bounds_stability()).count();
        match count {
            0 => BoundaryPart::None,
            _ if count == self.points.len() => BoundaryPart::Whole,
            _ => BoundaryPart::Part,
        }
    }
}

/// The maximum, the initial and the minimum step, in units of the motion and of the ranges.
const STEPS: [f64; 3] = [0.04, 0.01, 1e-7];
/// The largest angle between the directions at both ends of a step, and the intended angle.
const TURNS: [f64; 2] = [0.3, 0.1];
/// Largest distance of a predicted point from the corrected one, relative to the step; beyond it the corrected point may lie on another curve.
const FAR: f64 = 0.2;
/// Step below which the end of a range counts as reached where two curves meet on it, as at the tip of a tongue.
const SHORT: f64 = 1e-3;

/// A point on a curve.
#[derive(Clone, Debug)]
struct Spot {
    position: Vec<f64>,
    /// The unit tangent of the curve, in scaled units.
    tangent: Vec<f64>,
    /// Slope of the test function to the left of the direction, for an equilibrium.
    left: f64,
    point: CurvePoint,
}

/// A curve while it is followed.
pub(super) struct Trace<'a> {
    singular: Singular<'a>,
    ranges: [[f64; 2]; 2],
    most_points: usize,
    units: Vec<f64>,
    largest: f64,
    spots: Vec<Spot>,
    cusps: Vec<CurvePoint>,
}

impl<'a> Trace<'a> {
    /// A trace towards one side, from a point close to `position`, scaled by the sizes of the motion there.
    pub(super) fn new(
        singular: Singular<'a>,
        ranges: [[f64; 2]; 2],
        most_points: usize,
        start: (&[f64], &BranchPoint),
    ) -> Option<Self> {
        let largest = singular.family.largest_swing(start.1);
        let mut trace =
            Self { singular, ranges, most_points, units: vec![], largest, spots: vec![], cusps: vec![] };
        trace.units = trace.units_of(start.1);
        let (along, unknowns) = trace.first(start.0)?;
        let spot = trace.spot(unknowns, &along)?;
        trace.spots.push(spot);
        Some(trace)
    }

    /// The curve in both directions from its first point.
    pub(super) fn followed(mut self, kind: SpecialKind) -> SpecialCurve {
        let (start, units) = (self.spots[0].clone(), self.units.clone());
        let onward = self.walked();
        let (mut points, mut cusps) = (self.points(), std::mem::take(&mut self.cusps));
        let mut endings = [onward; 2];
        if onward != Ending::Closed {
            let turned = start.tangent.iter().map(|x| -x).collect();
            (self.units, self.largest) = (units, self.singular.family.largest_swing(&start.point.point));
            self.spots = vec![Spot { tangent: turned, left: -start.left, ..start }];
            endings[0] = self.walked();
            points = self.points().into_iter().skip(1).rev().chain(points).collect();
            cusps = self.cusps.into_iter().rev().chain(cusps).collect();
        }
        let Singular { space, rest, .. } = self.singular;
        SpecialCurve { kind, at_rest: rest.is_some(), space, points, cusps, endings }
    }

    fn points(&self) -> Vec<CurvePoint> {
        self.spots.iter().map(|spot| spot.point.clone()).collect()
    }

    fn walked(&mut self) -> Ending {
        let mut length = STEPS[1];
        while self.spots.len() < self.most_points {
            if self.singular.family.watch.reached(self.spots.len()).is_err() {
                return Ending::Interrupted;
            }
            let Some(ending) = self.step(&mut length) else { continue };
            return if self.singular.family.watch.is_stopped() { Ending::Interrupted } else { ending };
        }
        Ending::PointLimit
    }

    fn at(&self) -> &Spot {
        self.spots.last().expect("a trace begins with a spot")
    }

    fn step(&mut self, length: &mut f64) -> Option<Ending> {
        let Some((next, turn)) = self.next(*length) else {
            *length *= 0.5;
            return (*length < STEPS[2]).then_some(Ending::Lost);
        };
        if self.belongs_to_less(&next) {
            self.spots.push(next);
            return Some(Ending::BranchPoint);
        }
        // A turn below a thousandth allows the largest growth, and may be zero.
        let longer = (TURNS[1] / turn.max(1e-3)).clamp(0.5, 1.6);
        if let Some((which, value)) = self.outside(&next) {
            let end = self.at_value(&next, which, value);
            if end.is_none() && *length > SHORT {
                *length *= 0.5;
                return None;
            }
            self.spots.extend(end);
            return Some(Ending::RangeEnd);
        }
        if self.closes(&next, *length) {
            let start = self.spots[0].clone();
            self.spots.push(start);
            return Some(Ending::Closed);
        }
        let motion = &next.point.point;
        let ends = match self.singular.test {
            Test::Torus => !motion.is_torus(),
            Test::Collision => !motion.is_collision(),
            _ => false,
        };
        if ends {
            return Some(Ending::BranchPoint);
        }
        if self.turns_back(&next) {
            let Some(turning) = self.turning(&next) else { return Some(Ending::Lost) };
            if self.belongs_to_less(&turning) {
                self.spots.push(turning);
                return Some(Ending::BranchPoint);
            }
            self.cusps.push(turning.point);
        }
        *length = (*length * longer).min(STEPS[0]);
        self.largest = self.largest.max(self.singular.family.largest_swing(&next.point.point));
        self.spots.push(next);
        self.rescale();
        None
    }

    /// The spot after a step, and the angle by which the direction turned.
    fn next(&self, length: f64) -> Option<(Spot, f64)> {
        let Spot { position: unknowns, tangent, .. } = self.at();
        let step = unknowns.iter().zip(tangent).zip(&self.units);
        let guess: Vec<f64> = step.map(|((x, t), unit)| x + length * t * unit).collect();
        let corrected = self.corrected(&guess, tangent)?;
        if norm(&self.difference(&corrected, &guess)) > FAR * length {
            return None;
        }
        let spot = self.spot(corrected, tangent)?;
        let cosine: f64 = spot.tangent.iter().zip(tangent).map(|(a, b)| a * b).sum();
        let turn = libm::acos(cosine.clamp(-1.0, 1.0));
        // A neighbouring boundary has the other side to its left; where two boundaries cross, short steps pass.
        let same_side = spot.left * self.at().left > 0.0 || length < SHORT || self.singular.rest.is_none();
        (turn <= TURNS[0] && same_side).then_some((spot, turn))
    }

    /// Newton's method perpendicular to a direction; the derivatives are kept once the correction is small.
    fn corrected(&self, guess: &[f64], across: &[f64]) -> Option<Vec<f64>> {
        const MOST_ROUNDS: usize = 16;
        /// Last correction, in scaled units, from which the derivatives are kept: they change by a thousandth, so that each round gains three digits.
        const NEAR: f64 = 1e-3;
        /// Largest remaining correction, in scaled units: a few rounding errors.
        const DONE: f64 = 3e-15;
        /// Corrections that may grow: next to a cusp the derivatives are nearly singular, and rounding errors are enlarged by up to a million.
        const ROUNDING: f64 = 1e-9;
        let mut unknowns = guess.to_vec();
        let (mut before, mut rows) = (f64::INFINITY, vec![]);
        for _ in 0..MOST_ROUNDS {
            if before > NEAR {
                rows = self.singular.slopes(&unknowns, &self.units, TOLERANCES[0])?;
                rows.push(across.to_vec());
            }
            let off: f64 = self.difference(&unknowns, guess).iter().zip(across).map(|(x, t)| x * t).sum();
            let values = self.singular.values(&unknowns, &self.units, TOLERANCES[0])?;
            let right: Vec<f64> = values.iter().map(|x| -x).chain([-off]).collect();
            let change = solve(&Doubles, |x| x.abs(), &rows, &right)?;
            let size = norm(&change);
            if !size.is_finite() || (size > 0.5 * before && size > ROUNDING) {
                return None;
            }
            for ((number, change), unit) in unknowns.iter_mut().zip(&change).zip(&self.units) {
                *number += change * unit;
            }
            if size < DONE || size > 0.5 * before {
                return Some(unknowns);
            }
            before = size;
        }
        None
    }

    fn difference(&self, a: &[f64], b: &[f64]) -> Vec<f64> {
        a.iter().zip(b).zip(&self.units).map(|((a, b), unit)| (a - b) / unit).collect()
    }

    /// The tangent of the curve near a point, along its largest component, and the point corrected perpendicular to it.
    fn first(&self, position: &[f64]) -> Option<(Vec<f64>, Vec<f64>)> {
        let slopes = self.singular.slopes(position, &self.units, TOLERANCES[0])?;
        let along = |j: usize| {
            let across: Vec<f64> = (0..position.len()).map(|i| if i == j { 1.0 } else { 0.0 }).collect();
            tangent(&slopes, &across).map(|tangent| (tangent[j].abs(), tangent))
        };
        let (_, along) = (0..position.len()).filter_map(along).max_by(|a, b| a.0.total_cmp(&b.0))?;
        let unknowns = self.corrected(position, &along)?;
        Some((along, unknowns))
    }

    /// A point with its direction, its motion and its error.
    fn spot(&self, position: Vec<f64>, along: &[f64]) -> Option<Spot> {
        let slopes = self.singular.slopes(&position, &self.units, TOLERANCES[0])?;
        let tangent = tangent(&slopes, along)?;
        let slope = slopes.last()?;
        let left = tangent[0] * slope[1] - tangent[1] * slope[0];
        let error = self.error(&position, slopes, &tangent)?;
        let Singular { family, space, .. } = self.singular;
        let image = self.singular.image(&position, TOLERANCES[0])?;
        let (state, parameters) = self.singular.parts(&position);
        let point = family.point(space, state, parameters, &image, error)?;
        let second = parameters[1];
        Some(Spot { tangent, left, point: CurvePoint { point, second }, position })
    }

    /// Error of the parameters perpendicular to the curve, from the residuals, a second integration tolerance and the rounding of the unknowns
    /// and of the multipliers, which near zero parameters is larger.
    fn error(&self, position: &[f64], mut rows: Vec<Vec<f64>>, tangent: &[f64]) -> Option<f64> {
        let values = |tolerance: f64| self.singular.values(position, &self.units, tolerance);
        let rounding = f64::EPSILON
            * position.iter().zip(&self.units).fold(1.0, |sum, (x, unit)| sum + (x / unit).abs());
        let missed = |(value, other): (f64, f64)| value.abs() + other.abs() + rounding;
        let right = values(TOLERANCES[0])?.into_iter().zip(values(TOLERANCES[1])?).map(missed).chain([0.0]);
        let right: Vec<f64> = right.collect();
        rows.push(tangent.to_vec());
        let change = solve(&Doubles, |x| x.abs(), &rows, &right)?;
        let last = change.iter().zip(&self.units).rev().take(2).map(|(x, unit)| (x * unit).abs());
        Some(4.0 * last.fold(0.0, f64::max))
    }

    fn units_of(&self, point: &BranchPoint) -> Vec<f64> {
        let widths = self.ranges.map(|[low, high]| high - low);
        if self.singular.rest.is_some() {
            return widths.to_vec();
        }
        let sizes = self.singular.family.units(point, self.largest, widths[0]);
        sizes.into_iter().chain([widths[1]]).collect()
    }

    /// Rescales the units to the sizes of the last motion; directions stay the same.
    fn rescale(&mut self) {
        let units = self.units_of(&self.at().point.point);
        let old = std::mem::replace(&mut self.units, units);
        let of_old = |tangent: &[f64]| {
            let scaled: Vec<f64> =
                tangent.iter().zip(&old).zip(&self.units).map(|((t, old), new)| t * old / new).collect();
            let size = norm(&scaled);
            scaled.into_iter().map(|x| x / size).collect::<Vec<f64>>()
        };
        let turned: Vec<Vec<f64>> = self.spots.iter().map(|spot| of_old(&spot.tangent)).collect();
        self.spots.iter_mut().zip(turned).for_each(|(spot, tangent)| spot.tangent = tangent);
    }

    /// The parameter that first leaves its range on the way to a spot, and the end of the range.
    fn outside(&self, next: &Spot) -> Option<(usize, f64)> {
        let (_, now) = self.singular.parts(&self.at().position);
        let (_, then) = self.singular.parts(&next.position);
        let leaves = |which: usize| {
            let [low, high] = self.ranges[which];
            let value = if then[which] < low { low } else { high };
            let is_out = !(low..=high).contains(&then[which]);
            is_out.then(|| ((value - now[which]) / (then[which] - now[which]), which, value))
        };
        let first = (0..2).filter_map(leaves).min_by(|a, b| a.0.total_cmp(&b.0));
        first.map(|(_, which, value)| (which, value))
    }

    /// The spot at which a parameter has a value, on the way to another spot.
    fn at_value(&self, next: &Spot, which: usize, value: f64) -> Option<Spot> {
        let (now, then) = (&self.at().position, &next.position);
        let number = now.len() - 2 + which;
        let part = (value - now[number]) / (then[number] - now[number]);
        let mut guess: Vec<f64> = now.iter().zip(then).map(|(x, y)| x + part * (y - x)).collect();
        guess[number] = value;
        let across: Vec<f64> = (0..now.len()).map(|i| if i == number { 1.0 } else { 0.0 }).collect();
        let mut unknowns = self.corrected(&guess, &across)?;
        unknowns[number] = value;
        self.spot(unknowns, &self.at().tangent)
    }

    /// Returns `true` if the step to a spot passes through the first spot in the same direction.
    fn closes(&self, next: &Spot, length: f64) -> bool {
        if self.spots.len() < 4 {
            return false;
        }
        let start = &self.spots[0];
        let side = |unknowns: &[f64]| -> f64 {
            self.difference(unknowns, &start.position).iter().zip(&start.tangent).map(|(a, b)| a * b).sum()
        };
        let [before, after] =
            [&self.at().position, &next.position].map(|unknowns| self.difference(unknowns, &start.position));
        let near = norm(&before).min(norm(&after)) <= 1.5 * length;
        near && side(&self.at().position) < 0.0 && side(&next.position) >= 0.0
    }

    /// Returns `true` if the parameters turn back on the step to a spot.
    fn turns_back(&self, next: &Spot) -> bool {
        let product =
            |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).rev().take(2).map(|(a, b)| a * b).sum() };
        self.singular.rest.is_none() && product(&self.at().tangent, &next.tangent) < 0.0
    }

    /// The spot at which the parameters turn back: its tangent has components in the state only.
    fn turning(&self, next: &Spot) -> Option<Spot> {
        /// Accuracy along the secant: the parameters, which have an extreme there, change by its square, less than rounding.
        const WIDTH: f64 = 1e-10;
        let (a, b) = (self.at(), next);
        let secant = self.difference(&b.position, &a.position);
        let size = norm(&secant);
        let secant: Vec<f64> = secant.into_iter().map(|x| x / size).collect();
        let change: Vec<f64> = b.tangent.iter().zip(&a.tangent).map(|(b, a)| b - a).rev().take(2).collect();
        let spot_at = |s: f64| {
            let guess: Vec<f64> = a.position.iter().zip(&b.position).map(|(x, y)| x + s * (y - x)).collect();
            let unknowns = self.corrected(&guess, &secant)?;
            self.spot(unknowns, &a.tangent)
        };
        let along = |spot: &Spot| -> f64 { spot.tangent.iter().rev().zip(&change).map(|(t, w)| t * w).sum() };
        let ends = [(0.0, along(a)), (1.0, along(b))];
        let value = |s: f64| spot_at(s).map_or(f64::NAN, |spot| along(&spot));
        spot_at(zero_between(ends, Tolerance::absolute(WIDTH), value)?)
    }

    /// Returns `true` if a motion belongs to a smaller space: the curve continues there as its own image, half a period later or mirrored.
    fn belongs_to_less(&self, spot: &Spot) -> bool {
        /// Largest defect relative to the size of the motion.
        const SAME: f64 = 1e-3;
        const REST: f64 = 0.05;
        let Singular { family, space, rest, .. } = self.singular;
        if rest.is_some() {
            return false;
        }
        let (state, parameters) = self.singular.parts(&spot.position);
        let in_units = |numbers: &[f64]| {
            norm(&numbers.iter().zip(&self.units).map(|(x, unit)| x / unit).collect::<Vec<_>>())
        };
        let is_rest = |rest: &[f64]| norm(&self.difference(state, rest)) < REST;
        (space.mirrored && space.fixed_state(&family.mirror).is_some_and(|rest| is_rest(&rest)))
            || family
                .images_within(space, state, parameters, TOLERANCES[0])
                .any(|(_, image)| in_units(&image.defect) < SAME)
    }
}

/// The unit vector that the derivatives map to zero, oriented like a given vector.
fn tangent(slopes: &[Vec<f64>], along: &[f64]) -> Option<Vec<f64>> {
    let rows: Vec<Vec<f64>> = slopes.iter().cloned().chain([along.to_vec()]).collect();
    let right: Vec<f64> = (0..along.len()).map(|i| if i + 1 < along.len() { 0.0 } else { 1.0 }).collect();
    let tangent = solve(&Doubles, |x| x.abs(), &rows, &right)?;
    let size = norm(&tangent);
    size.is_finite().then(|| tangent.iter().map(|x| x / size).collect())
}
