//! Amplitudes up to which a formula keeps a tolerance, and at which another formula becomes better: zeros of exact errors.

use super::error::Exact;
use super::formula::PeriodFormula;
use super::grid::{self, Coordinate, amplitude_at, coordinate_of};
use super::swing::SwingAmplitude;
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::internals::progress::Watch;
use libration_numbers::internals::roots::maximum_between;
use libration_numbers::progress::{Interrupted, Progress, Stage};
use libration_numbers::quantity::Angle;
use libration_numbers::roots::{Tolerance, zero_between};
use std::convert::Infallible;

/// Tolerance in u = ln(θ0/(π − θ0)); a change of u moves θ0 by at most π/4 of it.
const COORDINATE_TOLERANCE: Tolerance = Tolerance::absolute(4e-15);
/// Relative difference below which two errors are equal.
const SAME: f64 = 8.0 * f64::EPSILON;

/// The amplitude at which an error is largest on an interval, and that error with its sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorMaximum {
    /// Amplitude of the worst error.
    pub amplitude: Angle,
    /// formula/exact − 1 at the amplitude of the maximum; infinite if the formula is not defined up to the end.
    pub error: f64,
}

/// An amplitude at which the errors of two formulas are equally large.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossover {
    /// Amplitude of the crossover.
    pub amplitude: Angle,
    /// The key of the formula with the smaller error directly below.
    pub better_below: String,
    /// The key of the formula with the smaller error directly above.
    pub better_above: String,
    /// The common magnitude of both errors.
    pub error: f64,
}

/// The exact errors of some formulas at the same amplitudes, from 1e-149 rad to π − 1e-299 rad: the starting point of the searches, computed
/// once.
#[derive(Clone, Debug)]
pub struct ErrorTable {
    points: Vec<Coordinate>,
    curves: Vec<Curve>,
}

#[derive(Clone, Debug)]
struct Curve {
    formula: PeriodFormula,
    errors: Vec<f64>,
}

impl ErrorTable {
    /// The table of these formulas; each takes about 20 ms.
    ///
    /// # Errors
    /// The call is cancelled.
    pub fn new(formulas: &[PeriodFormula], progress: &dyn Progress) -> Result<Self, Interrupted> {
        let watch = &Watch::new(progress);
        watch.begin(Stage::Whole, Some(grid::points().len()));
        Self::filled(formulas, |done| watch.reached(done))
    }

    /// The table of one or two formulas.
    fn of_few(formulas: &[PeriodFormula]) -> Self {
        let Ok(table) = Self::filled(formulas, |_| Ok::<(), Infallible>(()));
        table
    }

    /// Fills the table; after each amplitude `go_on` receives the number of amplitudes done and may stop.
    fn filled<E>(
        formulas: &[PeriodFormula],
        mut go_on: impl FnMut(usize) -> Result<(), E>,
    ) -> Result<Self, E> {
        let points = grid::points();
        let mut curves: Vec<Curve> =
            formulas.iter().map(|formula| Curve { formula: formula.clone(), errors: Vec::new() }).collect();
        let amplitudes: Vec<_> = points.iter().map(|&u| Some(amplitude_at(u))).collect();
        for (done, mut exact) in (1..).zip(Exact::each(&amplitudes).flatten()) {
            for curve in &mut curves {
                curve.errors.push(curve.formula.error_beside(&mut exact));
            }
            go_on(done)?;
        }
        Ok(Self { points, curves })
    }

    /// The formulas of the table, in its order.
    pub fn formulas(&self) -> impl ExactSizeIterator<Item = &PeriodFormula> {
        self.curves.iter().map(|curve| &curve.formula)
    }

    /// The intervals of amplitudes within (0, π), in radians, on which |fractional error| ≤ `tolerance`, for the formula at this index of the
    /// table; none for an index beyond its end.
    #[must_use]
    pub fn holds_on(&self, formula: usize, tolerance: f64) -> Vec<(f64, f64)> {
        let Some(curve) = self.curves.get(formula) else { return Vec::new() };
        let mut intervals: Vec<(f64, f64)> = Vec::new();
        for (from, to) in self.holding_segments(curve, tolerance) {
            let (from, to) = (self.radians_or_end(from), self.radians_or_end(to));
            match intervals.last_mut() {
                Some(last) if last.1.to_bits() == from.to_bits() => last.1 = to,
                _ => intervals.push((from, to)),
            }
        }
        intervals
    }

    /// The amplitude in radians up to which |fractional error| ≤ `tolerance`, beginning at the smallest: 0 if the smallest already exceeds it, π
    /// if none does.
    #[must_use]
    pub fn holds_to(&self, formula: usize, tolerance: f64) -> f64 {
        self.holds_on(formula, tolerance)
            .first()
            .filter(|interval| interval.0 <= 0.0)
            .map_or(0.0, |interval| interval.1)
    }

    /// The formulas that keep the tolerance up to this amplitude, the simplest first by [`Complexity::rank`](super::Complexity::rank).
    #[must_use]
    pub fn simplest(&self, amplitude: &Angle, tolerance: f64) -> Vec<&PeriodFormula> {
        let Some(amplitude) = SwingAmplitude::from_angle(amplitude) else { return Vec::new() };
        let reach = |(i, _): &(usize, &Curve)| self.holds_to(*i, tolerance) >= amplitude.radians();
        let mut sufficient: Vec<_> =
            self.curves.iter().enumerate().filter(reach).map(|(_, curve)| &curve.formula).collect();
        sufficient.put_in_order_by(|formula| formula.complexity().rank());
        sufficient
    }

    /// Every amplitude within (0, π) at which the better of two formulas changes, increasing; none for an index beyond the end of the table.
    #[must_use]
    pub fn crossovers(&self, a: usize, b: usize) -> Vec<Crossover> {
        match (self.curves.get(a), self.curves.get(b)) {
            (Some(a), Some(b)) => self.changes_of_lead(a, b),
            _ => Vec::new(),
        }
    }

    /// The crossovers of all pairs.
    ///
    /// A cancelled call returns the crossovers it has computed so far.
    #[must_use]
    pub fn all_crossovers(&self, progress: &dyn Progress) -> Vec<Crossover> {
        let watch = &Watch::new(progress);
        let count = self.curves.len();
        watch.begin(Stage::Whole, Some(count * count.saturating_sub(1) / 2));
        let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| (a, b)));
        let mut crossovers = Vec::new();
        for (done, (a, b)) in pairs.enumerate() {
            crossovers.extend(self.changes_of_lead(&self.curves[a], &self.curves[b]));
            if watch.reached(done + 1).is_err() {
                break;
            }
        }
        crossovers
    }

    /// Every amplitude within (0, π) at which |error of a| = `factor`·|error of b|, increasing.
    #[must_use]
    pub fn amplitudes_where_ratio_of_errors(&self, a: usize, b: usize, factor: f64) -> Vec<Angle> {
        let (Some(a), Some(b)) = (self.curves.get(a), self.curves.get(b)) else { return Vec::new() };
        let coordinates = self.places_where_equal(a, &Other::Formula(b, factor));
        coordinates.into_iter().filter_map(|u| amplitude_at(u).to_angle()).collect()
    }

    /// Every amplitude within (0, π) at which the error changes sign, so that the formula is exact.
    #[must_use]
    pub fn amplitudes_where_exact(&self, formula: usize) -> Vec<Angle> {
        let Some(curve) = self.curves.get(formula) else { return Vec::new() };
        let mut sign = |u: f64| imbalance(curve.error_at(u), 0.0);
        let signs: Vec<f64> = curve.errors.iter().map(|&error| imbalance(error, 0.0)).collect();
        let coordinates = zeros(&self.points, &signs, &mut sign);
        coordinates.into_iter().filter_map(|u| amplitude_at(u).to_angle()).collect()
    }

    fn changes_of_lead(&self, a: &Curve, b: &Curve) -> Vec<Crossover> {
        let coordinates = self.places_where_equal(a, &Other::Formula(b, 1.0));
        let between = self.midpoints_about(&coordinates);
        let first_leads: Vec<bool> =
            between.iter().map(|&u| a.error_at(u).abs() < b.error_at(u).abs()).collect();
        let leader =
            |first: bool| if first { a.formula.key().to_owned() } else { b.formula.key().to_owned() };
        let mut crossovers = Vec::new();
        for (&u, leads) in coordinates.iter().zip(first_leads.windows(2)) {
            let amplitude = amplitude_at(u).to_angle();
            if let Some(amplitude) = amplitude.filter(|_| leads[0] != leads[1]) {
                let (better_below, better_above) = (leader(leads[0]), leader(leads[1]));
                let error = a.error_at(u).abs();
                crossovers.push(Crossover { amplitude, better_below, better_above, error });
            }
        }
        crossovers
    }

    /// One position below the first of `coordinates`, one between each two, and one above the last.
    fn midpoints_about(&self, coordinates: &[Coordinate]) -> Vec<Coordinate> {
        let ends = self.ends();
        let first = coordinates.first().map(|&u| f64::max(u - 0.05, f64::midpoint(ends.0, u)));
        let last = coordinates.last().map(|&u| f64::min(u + 0.05, f64::midpoint(ends.1, u)));
        let inner = coordinates.windows(2).map(|pair| f64::midpoint(pair[0], pair[1]));
        first.into_iter().chain(inner).chain(last).collect()
    }

    fn holding_segments(&self, curve: &Curve, tolerance: f64) -> Vec<(Coordinate, Coordinate)> {
        let ends = self.ends();
        let coordinates = self.places_where_equal(curve, &Other::Tolerance(tolerance));
        let bounds: Vec<_> = [ends.0].into_iter().chain(coordinates).chain([ends.1]).collect();
        let segments = bounds.windows(2).map(|pair| (pair[0], pair[1]));
        segments.filter(|&(from, to)| curve.error_at(f64::midpoint(from, to)).abs() <= tolerance).collect()
    }

    /// The positions at which |error| equals that of the other, with equal or opposite signs.
    fn places_where_equal(&self, curve: &Curve, other: &Other<'_>) -> Vec<Coordinate> {
        let mut coordinates = Vec::new();
        for sign in [1.0, -1.0] {
            let indices = 0..self.points.len();
            let values: Vec<f64> =
                indices.map(|i| imbalance(curve.errors[i], sign * other.error_in_table(i))).collect();
            let mut difference = |u: f64| imbalance(curve.error_at(u), sign * other.error_at(u));
            coordinates.extend(zeros(&self.points, &values, &mut difference));
        }
        coordinates.sort_by(f64::total_cmp);
        coordinates
    }

    fn ends(&self) -> (Coordinate, Coordinate) {
        let end = |u: Option<&Coordinate>| u.copied().unwrap_or_default();
        (end(self.points.first()), end(self.points.last()))
    }

    /// The amplitude in radians, 0 and π at the ends of the table.
    fn radians_or_end(&self, u: Coordinate) -> f64 {
        let ends = self.ends();
        if u <= ends.0 {
            0.0
        } else if u >= ends.1 {
            std::f64::consts::PI
        } else {
            amplitude_at(u).radians()
        }
    }
}

impl Curve {
    fn error_at(&self, u: Coordinate) -> f64 {
        self.formula.error(amplitude_at(u))
    }
}

/// The quantity with which an error is compared.
enum Other<'a> {
    Formula(&'a Curve, f64),
    Tolerance(f64),
}

impl Other<'_> {
    fn error_in_table(&self, index: usize) -> f64 {
        match self {
            Self::Formula(curve, factor) => factor * curve.errors[index],
            Self::Tolerance(tolerance) => *tolerance,
        }
    }

    fn error_at(&self, u: Coordinate) -> f64 {
        match self {
            Self::Formula(curve, factor) => factor * curve.error_at(u),
            Self::Tolerance(tolerance) => *tolerance,
        }
    }
}

/// a − b over the larger of them, 0 if they are equal up to rounding.
fn imbalance(a: f64, b: f64) -> f64 {
    let larger = a.abs().max(b.abs());
    let difference = a - b;
    if larger.is_infinite() {
        return if difference.is_nan() { 0.0 } else { difference.signum() };
    }
    if difference.abs() <= SAME * larger { 0.0 } else { difference / larger }
}

/// The zeros of `f`, whose values at `points` are `values`: between points of opposite sign, and in dips between points of the same sign that
/// reach zero.
fn zeros(points: &[Coordinate], values: &[f64], f: &mut dyn FnMut(f64) -> f64) -> Vec<Coordinate> {
    let nonzero: Vec<(f64, f64)> =
        points.iter().copied().zip(values.iter().copied()).filter(|(_, value)| *value != 0.0).collect();
    let mut zeros = Vec::new();
    for pair in nonzero.windows(2) {
        if (pair[0].1 > 0.0) != (pair[1].1 > 0.0) {
            zeros.extend(zero_between([pair[0], pair[1]], COORDINATE_TOLERANCE, &mut *f));
        }
    }
    for triple in nonzero.windows(3) {
        zeros.extend(zeros_in_dip(triple, f));
    }
    zeros
}

fn zeros_in_dip(triple: &[(f64, f64)], f: &mut dyn FnMut(f64) -> f64) -> Vec<Coordinate> {
    let sign = triple[1].1.signum();
    let heights: Vec<f64> = triple.iter().map(|point| sign * point.1).collect();
    let nearest_neighbour = heights[0].min(heights[2]);
    // A parabola through the three points that stays above half the middle's height indicates that `f` does not reach zero.
    let sag = (heights[0] - 2.0 * heights[1] + heights[2]) / 2.0;
    let slope = (heights[2] - heights[0]) / 4.0;
    let drop = slope * slope / sag;
    let may_reach = nearest_neighbour >= heights[1] && sag > 0.0 && heights[1] - drop <= 0.5 * heights[1];
    if !may_reach {
        return Vec::new();
    }
    // At an extreme the value has the square of this error.
    let (bottom_at, depth) = maximum_between(&mut |u| -sign * f(u), triple[0].0, triple[2].0, 1e-7);
    if depth <= 0.0 {
        return Vec::new();
    }
    let bottom = (bottom_at, -sign * depth);
    [triple[0], triple[2]]
        .into_iter()
        .filter_map(|side| zero_between([side, bottom], COORDINATE_TOLERANCE, &mut *f))
        .collect()
}

impl PeriodFormula {
    /// The largest |fractional error| between two amplitudes, in either order; amplitudes at and beyond the top count as the largest below it.
    /// `None` for amplitudes with whole turns.
    #[must_use]
    pub fn worst_error(&self, from: &Angle, to: &Angle) -> Option<ErrorMaximum> {
        let (from, to) = (end_coordinate(from)?, end_coordinate(to)?);
        let (low, high) = (from.min(to), from.max(to));
        let inner = grid::points().into_iter().filter(|u| (low < *u) && (*u < high));
        let points: Vec<f64> = [low].into_iter().chain(inner).chain([high]).collect();
        let mut size = |u: f64| self.error(amplitude_at(u)).abs();
        let sizes: Vec<f64> = points.iter().map(|&u| size(u)).collect();
        let (coordinate, _) = highest_peak(&points, &sizes, &mut size);
        let amplitude = amplitude_at(coordinate);
        Some(ErrorMaximum { amplitude: amplitude.to_angle()?, error: self.error(amplitude) })
    }

    /// The amplitude in radians up to which |fractional error| ≤ `tolerance`, beginning at the smallest: 0 if the smallest already exceeds it, π
    /// if none does. Accurate to 1e-13 rad.
    #[must_use]
    pub fn holds_to(&self, tolerance: f64) -> f64 {
        ErrorTable::of_few(std::slice::from_ref(self)).holds_to(0, tolerance)
    }

    /// The intervals of amplitudes within (0, π), in radians, on which |fractional error| ≤ `tolerance`.
    #[must_use]
    pub fn holds_on(&self, tolerance: f64) -> Vec<(f64, f64)> {
        ErrorTable::of_few(std::slice::from_ref(self)).holds_on(0, tolerance)
    }

    /// Every amplitude within (0, π) at which the better one of this and another formula changes, increasing.
    #[must_use]
    pub fn crossovers_with(&self, other: &Self) -> Vec<Crossover> {
        ErrorTable::of_few(&[self.clone(), other.clone()]).crossovers(0, 1)
    }
}

fn end_coordinate(angle: &Angle) -> Option<Coordinate> {
    let beyond = angle.turns() == 0 && angle.complement() <= 0.0;
    if beyond { grid::points().last().copied() } else { SwingAmplitude::from_angle(angle).map(coordinate_of) }
}

/// The highest of the values and of the peaks between them.
fn highest_peak(points: &[f64], values: &[f64], f: &mut dyn FnMut(f64) -> f64) -> (f64, f64) {
    let mut best = (points[0], values[0]);
    for (&coordinate, &value) in points.iter().zip(values) {
        if value > best.1 {
            best = (coordinate, value);
        }
    }
    for (neighbours, value) in points.windows(3).zip(values.windows(3)) {
        // A peak rises above its sampled point by less than that point rises above half its neighbours.
        if value[1] >= value[0] && value[1] >= value[2] && 2.0 * value[1] > best.1 {
            let peak = maximum_between(f, neighbours[0], neighbours[2], 1e-8);
            best = if peak.1 > best.1 { peak } else { best };
        }
    }
    best
}
