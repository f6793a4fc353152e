//! Stability over two parameters: the stability boundaries of an equilibrium, and the curves of singular points of driven motions.

use super::branch::Branch;
use super::coordinate_units::CoordinateUnits;
use super::curve::{CurvePoint, SpecialCurve, Trace};
use super::edges::{Crossing, Grid, RestStability};
use super::error::BranchError;
use super::family::{Family, TOLERANCES};
use super::options::ResponseOptions;
use super::point::BranchPoint;
use super::response::Response;
use super::search::Search;
use super::singular::Singular;
use super::space::Space;
use super::special::{SpecialKind, SpecialPoint, Test};
use libration_numbers::algebra::BigFloat;
use libration_numbers::expression::{Equation, Expression};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Progress, Stage};
use std::f64::consts::TAU;

/// Options of a stability chart.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartOptions {
    /// The equilibrium, or the initial guess of driven motions; if there is none, zero, or the state about which the equations are symmetric.
    pub start: Option<Vec<f64>>,
    /// Number of drive periods in the period of the motions.
    pub drive_periods: u32,
    /// Maximum depth of secondary branches (symmetry breaking, period doubling).
    pub generations: usize,
    /// Number of lines in each parameter direction along which driven motions are followed; the curves begin at singular points on these lines.
    pub lines: u32,
    /// Maximum number of points of a curve in each direction.
    pub most_points: usize,
}

impl Default for ChartOptions {
    fn default() -> Self {
        Self { start: None, drive_periods: 1, generations: 1, lines: 3, most_points: 2000 }
    }
}

/// Stability of the responses of a driven system over two of its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct StabilityChart {
    /// Stability of the equilibrium on a grid; `None` if the start is not an equilibrium for all parameters.
    pub rest: Option<RestStability>,
    /// The curves on which a multiplier of the equilibrium is on the unit circle, then the curves of driven motions.
    pub curves: Vec<SpecialCurve>,
    /// `true` if the computation was cancelled before all curves were followed.
    pub interrupted: bool,
}

impl StabilityChart {
    /// The chart over ranges of two parameters that are symbolic in the equations.
    ///
    /// If the start is an equilibrium for all parameters, as for a pendulum whose pivot moves up and down, its Floquet
    /// multipliers are computed on a grid. The curves on which a multiplier is +1 or −1, or two complex ones have modulus one,
    /// are followed from there. Then driven motions are followed along some lines of the chart; from their folds, symmetry
    /// breakings, period doublings and Neimark–Sacker points the corresponding curves are followed, through their cusps.
    ///
    /// A cancelled call returns the curves completed so far.
    ///
    /// # Accuracy
    /// Newton's method ends at the rounding errors of the motion; every point has an error. If a curve leaves the chart, its last point is on
    /// the edge. Details within one of the 32 × 32 grid cells, and curves that cross none of the lines, are not found. Where neighbouring
    /// grid points differ in stability and no boundary was followed between them, [`RestStability::unresolved`] has the place.
    ///
    /// # Errors
    /// Equations without a periodic drive, another symbolic parameter, a range without a width.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_branches as libration;
    /// use libration::continuation::{ChartOptions, SpecialKind, StabilityChart};
    /// use libration::progress::Quiet;
    /// // The boundary of stability of an inverted pendulum whose pivot moves up and down.
    /// let upright = "theta'' = -0.1*theta' + (1 + a*w^2*cos(w*t))*sin(theta)".parse()?;
    /// let options = ChartOptions { lines: 0, ..ChartOptions::default() };
    /// let chart = StabilityChart::over(&upright, ["w", "a"], [[5.0, 10.0], [0.1, 0.4]], &options, &Quiet)?;
    /// let edge = chart.curves.iter().find(|curve| curve.kind == SpecialKind::BranchPoint).ok_or("no edge")?;
    /// let slow = edge.points.iter().find(|it| it.point.parameter == 5.0).ok_or("no end")?;
    /// // Reference: Hill's matrix with 30 digits.
    /// assert!((slow.second - 0.2877861746702333933585712).abs() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # References
    /// Yu. A. Kuznetsov, *Elements of Applied Bifurcation Theory*, 3rd ed., Springer 2004, chapters 8 and 10, doi:10.1007/978-1-4757-3978-7.
    pub fn over(
        equation: &Equation,
        parameters: [&str; 2],
        ranges: [[f64; 2]; 2],
        options: &ChartOptions,
        progress: &dyn Progress,
    ) -> Result<Self, BranchError> {
        let watch = &Watch::new(progress);
        for [from, to] in ranges {
            if !(from.is_finite() && to.is_finite() && (from < to || to < from)) {
                return Err(BranchError::Range { from, to });
            }
        }
        watch.begin(Stage::Whole, None);
        let ranges = ranges.map(|[from, to]| [from.min(to), from.max(to)]);
        let family = Family::new(equation, &parameters, &ranges, watch)?;
        let start = options.start.clone().unwrap_or_else(|| family.mirror.rest().to_vec());
        let survey = Survey { equation, parameters, family: &family, ranges, options, start: &start };
        if let Some((scaled, units)) =
            survey.units().and_then(|units| Some((units.equation(equation)?, units)))
        {
            let options = ChartOptions { start: Some(units.state(&start)), ..options.clone() };
            let mut chart = Self::over(&scaled, parameters, ranges, &options, progress)?;
            units.restore_curves(&mut chart.curves);
            return Ok(chart);
        }
        let (rest, mut curves) = survey.rest();
        survey.driven(&mut curves);
        Ok(Self { rest, curves, interrupted: watch.is_stopped() })
    }
}

impl StabilityChart {
    /// Ranges of the second parameter in which the equilibrium is stable, bounded by the curves, at the least value of the first parameter
    /// (`end` 0) or at its greatest (1). `None` if the start is not an equilibrium.
    #[must_use]
    pub fn rest_is_stable_at(&self, end: usize) -> Option<Vec<[f64; 2]>> {
        Some(self.rest.as_ref()?.at_ends[end.min(1)].clone())
    }
}

struct Survey<'a> {
    equation: &'a Equation,
    parameters: [&'a str; 2],
    family: &'a Family<'a>,
    ranges: [[f64; 2]; 2],
    options: &'a ChartOptions,
    start: &'a [f64],
}

/// A singular point of a branch, from which a curve may be followed.
struct Seed {
    kind: SpecialKind,
    space: Space,
    point: BranchPoint,
    second: f64,
}

impl Survey<'_> {
    fn space(&self) -> Space {
        Space::of_periods(self.options.drive_periods)
    }

    /// Returns `true` if the start is an equilibrium at some trial values of the parameters and of the time.
    fn is_at_rest(&self) -> bool {
        /// Largest change in the time of one radian of the drive, relative to the size of motions.
        const SAME: f64 = 1e-11;
        const PARTS: [[f64; 2]; 3] = [[0.1, 0.35], [0.52, 0.77], [0.93, 0.61]];
        PARTS.iter().all(|parts| {
            let value = |(part, [low, high]): (&f64, &[f64; 2])| low + part * (high - low);
            let parameters: Vec<f64> = parts.iter().zip(&self.ranges).map(value).collect();
            let Some(period) = self.family.drive_period(&parameters) else { return false };
            let sizes = self.family.sizes_in(period);
            let is_zero = |(rate, size): (&f64, &f64)| (rate * period / TAU).abs() <= SAME * size;
            parts.iter().all(|part| {
                let rates = self.family.rate(self.start, part * period, &parameters);
                rates.is_some_and(|rates| rates.iter().zip(&sizes).all(is_zero))
            })
        })
    }

    /// The stability of the equilibrium on the grid, and its boundaries.
    fn rest(&self) -> (Option<RestStability>, Vec<SpecialCurve>) {
        /// Largest distance of a boundary from the crossing where it was found, relative to the ranges: thirty times the width to which
        /// crossings are enclosed. Beyond it Newton's method has led to a neighbouring boundary.
        const FOUND: f64 = 1e-6;
        if !self.is_at_rest() {
            return (None, vec![]);
        }
        let grid = Grid::new(self.family, self.space(), self.start, self.ranges);
        let mut edges: Vec<(Crossing, SpecialCurve)> = vec![];
        for crossing in grid.crossings() {
            if self.family.watch.is_stopped() {
                break;
            }
            if !edges.iter().any(|(first, edge)| self.is_same(edge, [first, &crossing])) {
                let edge = self.edge(&crossing).filter(|edge| self.side(edge, &crossing)[0] <= FOUND);
                edges.extend(edge.map(|edge| (crossing, edge)));
            }
        }
        let edges: Vec<SpecialCurve> = edges.into_iter().map(|(_, edge)| edge).collect();
        (Some(grid.stability(&edges)), edges)
    }

    fn edge(&self, crossing: &Crossing) -> Option<SpecialCurve> {
        let singular = Singular {
            family: self.family,
            space: self.space(),
            test: crossing.test,
            rest: Some(self.start),
        };
        let image = singular.image(&crossing.parameters, TOLERANCES[0])?;
        let point = self.family.point(self.space(), self.start, &crossing.parameters, &image, 0.0)?;
        let kind = match crossing.test {
            Test::Flip => SpecialKind::PeriodDoubling,
            Test::Torus if point.is_torus() => SpecialKind::NeimarkSacker,
            Test::Collision if point.is_collision() => SpecialKind::NeimarkSacker,
            Test::Torus | Test::Collision => return None,
            Test::Branching | Test::Fold => SpecialKind::BranchPoint,
        };
        let start = (&crossing.parameters[..], &point);
        Some(Trace::new(singular, self.ranges, self.options.most_points, start)?.followed(kind))
    }

    /// Returns `true` if a boundary followed from one crossing passes through another one, with the test rising to the same side.
    fn is_same(&self, edge: &SpecialCurve, crossings: [&Crossing; 2]) -> bool {
        /// Largest distance relative to the ranges: the error of linear interpolation between points.
        const SAME: f64 = 2e-3;
        let [[off, first], [near, other]] = crossings.map(|crossing| self.side(edge, crossing));
        let same_test = crossings[0].test == crossings[1].test;
        same_test && off.is_finite() && near <= SAME && (first > 0.0) == (other > 0.0)
    }

    /// Distance of a boundary from a crossing relative to the ranges, and a
    /// number that is positive if the test rises to the left of the boundary.
    fn side(&self, edge: &SpecialCurve, crossing: &Crossing) -> [f64; 2] {
        /// Length of the shortest steps along a boundary, relative to the ranges.
        const SHORTEST: f64 = 1e-7;
        let widths = self.ranges.map(|[low, high]| high - low);
        let relative = |point: &CurvePoint| {
            let [x, y] = crossing.parameters;
            [(point.point.parameter - x) / widths[0], (point.second - y) / widths[1]]
        };
        let of_pair = |pair: &[CurvePoint]| {
            let [a, b] = [relative(&pair[0]), relative(&pair[1])];
            let along = [b[0] - a[0], b[1] - a[1]];
            let square = along[0] * along[0] + along[1] * along[1];
            let part = (-(a[0] * along[0] + a[1] * along[1]) / square).clamp(0.0, 1.0);
            let off = libm::hypot(a[0] + part * along[0], a[1] + part * along[1]);
            let left = if crossing.along == 0 { -along[1] } else { along[0] };
            [off, if crossing.rises { left } else { -left }]
        };
        // A boundary found next to the edge of the map begins with two points that differ by rounding, without a direction.
        let has_direction = |pair: &&[CurvePoint]| {
            let [a, b] = [relative(&pair[0]), relative(&pair[1])];
            libm::hypot(b[0] - a[0], b[1] - a[1]) > SHORTEST
        };
        let pairs = edge.points.windows(2).filter(has_direction);
        let nearest = pairs.map(of_pair).min_by(|a, b| a[0].total_cmp(&b[0]));
        nearest.unwrap_or([f64::INFINITY; 2])
    }

    /// The curves of singular points of driven motions that cross some lines.
    fn driven(&self, curves: &mut Vec<SpecialCurve>) {
        let lines = (0..2).flat_map(|fixed| (1..=self.options.lines).map(move |line| (fixed, line)));
        for (fixed, line) in lines {
            let [low, high] = self.ranges[fixed];
            let value = low + (high - low) * f64::from(line) / f64::from(self.options.lines + 1);
            for seed in self.seeds(fixed, value) {
                if self.family.watch.is_stopped() {
                    return;
                }
                if !curves.iter().any(|curve| self.is_on(curve, &seed, fixed)) {
                    curves.extend(self.curve(&seed));
                }
            }
        }
    }

    /// The equation with a value of one of the parameters.
    fn with_value(&self, fixed: usize, value: f64) -> Option<Equation> {
        let exact = Expression::Number(BigFloat::from_f64(value, 53)?.to_rational());
        self.equation.with(&[(self.parameters[fixed], exact)]).ok()
    }

    fn response_options(&self) -> ResponseOptions {
        ResponseOptions {
            start: Some(self.start.to_vec()),
            drive_periods: self.options.drive_periods,
            generations: self.options.generations,
            ..ResponseOptions::default()
        }
    }

    /// The units of the coordinates by a motion, if those of the equation do not do.
    fn units(&self) -> Option<CoordinateUnits> {
        if self.family.layout.coordinates() < 2 {
            return None;
        }
        let [range, [low, high]] = self.ranges;
        let equation = &self.with_value(1, f64::midpoint(low, high))?;
        let family = &Family::new(equation, &self.parameters[..1], &[range], self.family.watch).ok()?;
        let (options, parameter) = (&self.response_options(), self.parameters[0]);
        let search = Search { equation, parameter, family, range, options };
        CoordinateUnits::of(&search, range[0], search.starts(range[0]).ok()?.first()?)
    }

    /// The singular points along a line.
    fn seeds(&self, fixed: usize, value: f64) -> Vec<Seed> {
        let Some(equation) = self.with_value(fixed, value) else { return vec![] };
        let options = self.response_options();
        let open = 1 - fixed;
        let watch = self.family.watch.part();
        let response = Response::over(&equation, self.parameters[open], self.ranges[open], &options, &watch);
        let seed = |branch: &Branch, special: &SpecialPoint| {
            let point = special.point.clone();
            let (first, second) =
                if fixed == 0 { (value, point.parameter) } else { (point.parameter, value) };
            Seed {
                kind: special.kind,
                space: branch.space,
                point: BranchPoint { parameter: first, ..point },
                second,
            }
        };
        let branches = response.map(|response| response.branches).unwrap_or_default();
        branches
            .iter()
            .flat_map(|branch| branch.special.iter().map(move |special| seed(branch, special)))
            .filter(|seed| test_of(seed).is_some() && !self.family.is_at_rest(&seed.point))
            .collect()
    }

    fn curve(&self, seed: &Seed) -> Option<SpecialCurve> {
        let singular = Singular { family: self.family, space: seed.space, test: test_of(seed)?, rest: None };
        let unknowns: Vec<f64> =
            seed.point.state.iter().copied().chain([seed.point.parameter, seed.second]).collect();
        let start = (&unknowns[..], &seed.point);
        Some(Trace::new(singular, self.ranges, self.options.most_points, start)?.followed(seed.kind))
    }

    /// Returns `true` if a curve of the same kind passes through a seed: it has the same parameters on the line of the seed.
    fn is_on(&self, curve: &SpecialCurve, seed: &Seed, fixed: usize) -> bool {
        /// Largest distance relative to the range: the error of linear interpolation between points.
        const SAME: f64 = 2e-3;
        let values = |point: &CurvePoint| [point.point.parameter, point.second];
        let (here, open) = ([seed.point.parameter, seed.second], 1 - fixed);
        let width = self.ranges[open][1] - self.ranges[open][0];
        let goes_through = |pair: &[CurvePoint]| {
            let [a, b] = [values(&pair[0]), values(&pair[1])];
            let part = (here[fixed] - a[fixed]) / (b[fixed] - a[fixed]);
            (0.0..=1.0).contains(&part)
                && (a[open] + part * (b[open] - a[open]) - here[open]).abs() <= SAME * width
        };
        curve.kind == seed.kind
            && curve.space.drive_periods() == seed.space.drive_periods()
            && !curve.at_rest
            && curve.points.windows(2).any(goes_through)
    }
}

/// The test function that vanishes at a singular point; `None` for kinds without curves.
fn test_of(seed: &Seed) -> Option<Test> {
    match seed.kind {
        SpecialKind::Fold => Some(Test::Branching),
        SpecialKind::SymmetryBreaking if !seed.space.mirrored => None,
        SpecialKind::SymmetryBreaking | SpecialKind::PeriodDoubling => Some(Test::Flip),
        SpecialKind::NeimarkSacker => Some(Test::Torus),
        SpecialKind::NeutralSaddle | SpecialKind::BranchPoint | SpecialKind::Hopf => None,
    }
}
