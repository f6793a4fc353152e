//! The answers of a driven system over a range of a parameter: all branches that are found from its ends, and what branches off.

use super::branch::{Branch, Ending, Limits, Origin, Walk, Walked};
use super::corrector::Corrector;
use super::error::NoBranch;
use super::family::{Family, TOLERANCES};
use super::jumps::{Jump, jumps};
use super::node::{Node, Tests, largest_swing};
use super::point::BranchPoint;
use super::space::Space;
use super::special::{SpecialKind, SpecialPoint};
use crate::algebra::{BigFloat, Doubles};
use crate::expression::{Equation, Expression};
use crate::linear::null_space;
use crate::orbit::{NoOrbit, Orbit};
use crate::watch::{Stage, Watch};

/// What is asked of a response.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseOptions {
    /// The state from which a motion is looked for at each end of the range; rest, where all numbers are zero, if there is none. Where nothing
    /// drives, the motion from there has to settle to a limit cycle; from a state of rest it is displaced a little.
    pub start: Option<Vec<f64>>,
    /// The value of the parameter at which it is looked for, and followed from both ways; the ends of the range if there is none. Curves that
    /// close within the range are found from there only.
    pub at: Option<f64>,
    /// How many periods of the drive an answer takes: 1, or more for subharmonic answers. Without a drive it is 1.
    pub drive_periods: u32,
    /// How many times one after the other branches may lose their symmetry or double their period, to be followed there.
    pub generations: usize,
    /// Points of one branch.
    pub most_points: usize,
}

impl Default for ResponseOptions {
    fn default() -> Self {
        Self { start: None, at: None, drive_periods: 1, generations: 2, most_points: 3000 }
    }
}

/// The periodic motions of a driven or self-excited system over a range of a parameter.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Response {
    /// Those from the ends of the range before those that branch off.
    pub branches: Vec<Branch>,
    /// The jumps of slow sweeps, branch by branch.
    pub jumps: Vec<Jump>,
    /// Whether a drive sets the periods; else the motions are limit cycles.
    pub driven: bool,
    /// Whether the watch ended it before all was followed.
    pub interrupted: bool,
}

impl Response {
    /// The branches of periodic motions of a driven system over a range of one of its parameters, which is left open in the equations: an
    /// amplitude, a damping, or the frequency of the drive itself. They begin with the motions that Newton's method finds at the ends of
    /// the range, and go through folds by pseudo-arclength; motions that lose their symmetry or double their period are followed too.
    ///
    /// Where the time does not stand in the equations they are limit cycles, from those to which the start settles at the ends of the range; the
    /// period is one more unknown, and a motion begins where the first coordinate turns back. A branch that shrinks to a state of rest ends there,
    /// at a Hopf point. Each turn of the first coordinate counts as a period of its own as long as the cycle is not known otherwise.
    ///
    /// Motions come from the Taylor integrator with the equations of small deviations, so that no number of harmonics is too large. A symmetric
    /// motion is followed by its half period and its mirror image: folds, losses of symmetry and doublings are then zeros of different functions.
    /// They are found along the branch to the last digits.
    ///
    /// # Accuracy
    /// As the errors of points and singular points say, some 1e-14 where no multiplier is large.
    ///
    /// # Errors
    /// A time that stands elsewhere than in a periodic drive, another open parameter, a range without a width, no motion at either end, free
    /// motions that come in families at each value, as where energy is conserved.
    ///
    /// # Examples
    /// ```
    /// use libration::continuation::{Response, ResponseOptions, SpecialKind};
    /// // The limit cycle of the Brusselator begins at b = 1 + a² with the period 2π/a.
    /// let brusselator = "x' = 1 + x^2*y - (b + 1)*x; y' = b*x - x^2*y".parse()?;
    /// let response = Response::over(&brusselator, "b", [1.5, 3.0], &ResponseOptions::default())?;
    /// let hopf = response.branches[0].special.iter().find(|it| it.kind == SpecialKind::Hopf).ok_or("no Hopf point")?;
    /// assert!((hopf.point.parameter - 2.0).abs() < 1e-14 && (hopf.point.period - std::f64::consts::TAU).abs() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    /// ```
    /// use libration::continuation::{Response, ResponseOptions, SpecialKind};
    /// // Duffing's equation with hardening, which bends its resonance to higher frequencies.
    /// let duffing = "x'' = -0.05*x' - x - 0.1*x^3 + 0.18*cos(w*t)".parse()?;
    /// let response = Response::over(&duffing, "w", [0.5, 1.6], &ResponseOptions::default())?;
    /// let folds = response.branches[0].special.iter().filter(|it| it.kind == SpecialKind::Fold);
    /// // Reference: Fourier collocation with 30 digits.
    /// assert!(folds.map(|it| it.point.parameter).any(|w| (w - 1.269601955545892477518364).abs() < 1e-13));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # References
    /// R. Seydel, *Practical Bifurcation and Stability Analysis*, Springer 2010, chapters 4, 5 and 7, doi:10.1007/978-1-4419-1740-9.
    pub fn over(
        equation: &Equation,
        parameter: &str,
        range: [f64; 2],
        options: &ResponseOptions,
    ) -> Result<Self, NoBranch> {
        Self::over_watched(equation, parameter, range, options, &Watch::none())
    }

    /// As [`over`](Self::over); `watch` is asked at each step, and told how many points there are. Where it stops the branches are given as
    /// far as they were followed.
    ///
    /// # Errors
    /// As [`over`](Self::over), and [`NoBranch::Interrupted`] before the first point.
    pub fn over_watched(
        equation: &Equation,
        parameter: &str,
        range: [f64; 2],
        options: &ResponseOptions,
        watch: &Watch<'_>,
    ) -> Result<Self, NoBranch> {
        let [from, to] = range;
        if !(from.is_finite() && to.is_finite() && (from < to || to < from)) {
            return Err(NoBranch::Range { from, to });
        }
        watch.begin(Stage::Whole, None);
        let range = [from.min(to), from.max(to)];
        if let Some(at) = options.at.filter(|at| !(range[0]..=range[1]).contains(at)) {
            return Err(NoBranch::Outside { at, from, to });
        }
        let family = Family::free_or_driven(equation, &[parameter], &[range], watch)?;
        if !family.is_driven() && options.drive_periods != 1 {
            return Err(NoBranch::NotDriven);
        }
        let search = Search { equation, parameter, family: &family, range, options };
        search.response()
    }
}

struct Search<'a> {
    equation: &'a Equation,
    parameter: &'a str,
    family: &'a Family<'a>,
    range: [f64; 2],
    options: &'a ResponseOptions,
}

impl Search<'_> {
    fn response(&self) -> Result<Response, NoBranch> {
        let mut branches: Vec<Branch> = vec![];
        let mut left: Vec<(usize, Leaving)> = vec![];
        let mut met: Vec<(Space, f64)> = vec![];
        let mut missing = None;
        let [low, high] = self.range;
        let places = self.options.at.map_or(vec![(low, 1.0), (high, -1.0)], |at| vec![(at, 1.0)]);
        for (value, into) in places {
            match self.start(value) {
                Ok(start) if self.is_known(&branches, value, &start) => {}
                Ok(start) => {
                    let walked = match self.through(value, &start, into) {
                        Ok(Some(walked)) => walked,
                        Ok(None) => continue,
                        Err(error) => {
                            missing = Some(error);
                            continue;
                        }
                    };
                    left.extend(self.leaving(&walked, 0));
                    met.extend(walked.meeting.map(|parameter| (walked.branch.space, parameter)));
                    branches.push(walked.branch);
                }
                Err(NoOrbit::Interrupted(interrupted)) if branches.is_empty() => {
                    return Err(interrupted.into());
                }
                Err(error) => missing = Some(NoBranch::NoStart(error)),
            }
        }
        if let (true, Some(error)) = (branches.is_empty(), missing) {
            return Err(error);
        }
        while let Some((generation, start)) = left.pop() {
            if self.family.watch.is_stopped() {
                break;
            }
            if met.iter().any(|(space, parameter)| self.is_met(&start, *space, *parameter)) {
                continue;
            }
            let Some(walked) = self.switched(&start) else { continue };
            left.extend(self.leaving(&walked, generation));
            met.extend(walked.meeting.map(|parameter| (walked.branch.space, parameter)));
            branches.push(walked.branch);
        }
        let jumps = jumps(&branches, |space| self.corrector(space), self.width());
        let (driven, interrupted) = (self.family.is_driven(), self.family.watch.is_stopped());
        Ok(Response { branches, jumps, driven, interrupted })
    }

    /// A periodic motion at an end of the range.
    fn start(&self, value: f64) -> Result<Start, NoOrbit> {
        let exact = |value: f64| Some(Expression::Number(BigFloat::from_f64(value, 53)?.to_rational()));
        let put_in = exact(value).and_then(|exact| self.equation.with(&[(self.parameter, exact)]).ok());
        let equation = put_in.ok_or(NoOrbit::NoPeriod)?;
        let state = self.options.start.clone().unwrap_or_else(|| vec![0.0; self.family.layout.numbers()]);
        if !self.family.is_driven() {
            let state = self.family.displaced(state, value);
            let cycle = Orbit::limit_cycle_watched(&equation, &state, self.family.watch)?;
            let turns = self.family.turns(&cycle.start(), value, cycle.period()).ok_or(NoOrbit::NoPeriod)?;
            let period = cycle.period() / f64::from(turns);
            let unknowns = cycle.start().into_iter().chain([period]).collect();
            return Ok(Start { unknowns, space: Space::of_periods(turns) });
        }
        let duration = self.family.duration(self.space(), &[], &[value]).ok_or(NoOrbit::NoPeriod)?;
        let unknowns = match Orbit::driven_watched(&equation, duration, &state, self.family.watch) {
            Ok(orbit) => orbit.start(),
            // The drive has the amplitude zero.
            Err(NoOrbit::NotDriven) => state,
            Err(error) => return Err(error),
        };
        Ok(Start { unknowns, space: self.space() })
    }

    /// Whether a motion at an end of the range is the end of a branch that is followed already.
    fn is_known(&self, branches: &[Branch], value: f64, start: &Start) -> bool {
        /// Of the size of the state.
        const SAME: f64 = 1e-7;
        let size = start.unknowns.iter().map(|x| x.abs()).fold(1e-6, f64::max);
        let is_near = |a: f64, b: f64| (a - b).abs() <= SAME * size;
        let is_same = |(branch, point): (&Branch, &BranchPoint)| match self.family.is_driven() {
            true => point.state.iter().zip(&start.unknowns).all(|(a, b)| is_near(*a, *b)),
            // Which of its turns the cycle begins with is a matter of chance.
            false => {
                let turn = point.period / f64::from(branch.space.drive_periods());
                branch.space.drive_periods() == start.space.drive_periods()
                    && start.unknowns.last().is_some_and(|period| is_near(turn, *period))
            }
        };
        let ends = branches.iter().flat_map(|branch| {
            [branch.points.first(), branch.points.last()].into_iter().flatten().map(move |it| (branch, it))
        });
        ends.filter(|(_, point)| point.parameter.to_bits() == value.to_bits()).any(is_same)
    }

    /// Whether a branch that leaves another one has come to it from elsewhere.
    fn is_met(&self, start: &Leaving, space: Space, parameter: f64) -> bool {
        /// Of the range, as the interpolation shows the place.
        const SAME: f64 = 1e-3;
        let off = (start.node.point.parameter - parameter).abs();
        start.space.drive_periods() == space.drive_periods() && off <= SAME * self.width()
    }

    fn space(&self) -> Space {
        Space::of_periods(self.options.drive_periods)
    }

    fn width(&self) -> f64 {
        self.range[1] - self.range[0]
    }

    fn limits(&self, start: &Node) -> Limits {
        /// Times the least period: at so low a frequency the motion follows the drive through all its superharmonic resonances.
        const SLOW: f64 = 100.0;
        let periods = self.range.map(|value| self.family.drive_period(&[value]));
        let least = periods.into_iter().flatten().fold(f64::INFINITY, f64::min);
        let least = if self.family.is_driven() { least } else { start.point.period };
        let periods = f64::from(self.space().drive_periods());
        Limits {
            range: self.range,
            most_points: self.options.most_points,
            longest_period: SLOW * periods * least,
        }
    }

    fn corrector(&self, space: Space) -> Corrector<'_> {
        /// Multipliers of points need no more digits than that.
        const STALE: f64 = 1e-12;
        Corrector { family: self.family, space, tolerance: TOLERANCES[0], stale: STALE }
    }

    /// The branch through a motion, in the smallest space that has it: from an end of the range on, or both ways.
    fn through(&self, value: f64, start: &Start, into: f64) -> Result<Option<Walked>, NoBranch> {
        let Some(walked) = self.primary(value, start, into)? else { return Ok(None) };
        if self.options.at.is_none() || walked.branch.ending == Ending::Closed {
            return Ok(Some(walked));
        }
        Ok(Some(match self.primary(value, start, -into)? {
            Some(back) => back.turned_into(&walked),
            None => walked.beginning_lost(),
        }))
    }

    fn primary(&self, value: f64, start: &Start, into: f64) -> Result<Option<Walked>, NoBranch> {
        /// A multiplier of a free motion that is 1 to half the digits, beside that of a deviation along the motion.
        const FAMILY: f64 = 1e-6;
        let corrector = self.corrector(self.smallest(start.space, &start.unknowns, value));
        let place: Vec<f64> = start.unknowns.iter().copied().chain([value]).collect();
        if !self.family.is_driven() {
            let tests = corrector.image(&place).and_then(|image| Tests::new(&image, 0.0));
            if tests.is_some_and(|tests| tests.branching.abs() < FAMILY) {
                return Err(NoBranch::Family);
            }
        }
        let mut along = vec![0.0; place.len()];
        along[place.len() - 1] = into;
        let node = Node::near(&corrector, &place, [&along, &along], self.width());
        Ok(node.map(|node| {
            let limits = self.limits(&node);
            Walk::new(corrector, limits, node).walked(Origin::Primary)
        }))
    }

    fn smallest(&self, space: Space, state: &[f64], value: f64) -> Space {
        /// Of the size of the state. A motion that Newton's method has closed misses its mirror image by rounding, or by a difference.
        const SAME: f64 = 1e-9;
        let size = state.iter().map(|x| x.abs()).fold(1e-6, f64::max);
        let belongs = |smaller: &Space| {
            let image = self.family.image(*smaller, state, &[value], TOLERANCES[0]);
            image.is_some_and(|it| it.defect.iter().all(|d| d.abs() <= SAME * size))
        };
        match space.within(self.family.symmetry).into_iter().find(belongs) {
            Some(smaller) => self.smallest(smaller, state, value),
            None => space,
        }
    }

    /// The branches that leave one.
    fn leaving(&self, walked: &Walked, generation: usize) -> Vec<(usize, Leaving)> {
        if generation >= self.options.generations {
            return vec![];
        }
        let origin = |kind: SpecialKind| match kind {
            SpecialKind::SymmetryBreaking => Some(Origin::SymmetryBreaking),
            SpecialKind::PeriodDoubling => Some(Origin::PeriodDoubling),
            _ => None,
        };
        let space = walked.branch.space.doubled();
        let leaving = |(special, node): &(SpecialPoint, Node)| {
            Some((generation + 1, Leaving { origin: origin(special.kind)?, space, node: node.clone() }))
        };
        walked.specials.iter().filter_map(leaving).collect()
    }

    /// The branch that leaves another one: along the deviation that the map turns into its opposite.
    fn switched(&self, leaving: &Leaving) -> Option<Walked> {
        /// The first place, as a part of the units: far enough from the other branch for its side of it to be certain.
        const ASIDE: f64 = 1e-2;
        let turned = |(i, row): (usize, &Vec<f64>)| {
            row.iter().enumerate().map(|(j, x)| if i == j { x + 1.0 } else { *x }).collect()
        };
        let matrix: Vec<Vec<f64>> =
            leaving.node.corrected.image.return_map().iter().enumerate().map(turned).collect();
        let vector = null_space(&Doubles, |x| x.abs(), &matrix, 1)?.pop()?;
        let parent = &leaving.node.point;
        let sizes = self.family.units(parent, largest_swing(parent), self.width());
        let largest = vector.iter().zip(&sizes).map(|(x, unit)| (x / unit).abs()).fold(0.0, f64::max);
        let mut aside: Vec<f64> = vector.iter().map(|x| ASIDE * x / largest).collect();
        aside.resize(sizes.len(), 0.0);
        let place: Vec<f64> = leaving.node.place().iter().zip(&aside).map(|(x, d)| x + d).collect();
        let start = Node::near(&self.corrector(leaving.space), &place, [&aside, &aside], self.width())?;
        let (value, unknowns) = start.place().split_last()?;
        let space = self.smallest(leaving.space, unknowns, *value);
        let corrector = self.corrector(space);
        let start = Node::near(&corrector, start.place(), [&aside, &aside], self.width())?;
        let limits = self.limits(&start);
        let mut walked = Walk::new(corrector, limits, start).walked(leaving.origin);
        walked.branch.begin_with(leaving.node.point.clone());
        Some(walked)
    }
}

/// A motion from which a branch is followed.
struct Start {
    unknowns: Vec<f64>,
    space: Space,
}

/// A branch that leaves another one.
struct Leaving {
    origin: Origin,
    space: Space,
    node: Node,
}

impl Branch {
    /// Puts the point before it where the branch leaves another one, as a motion of twice the period: its multipliers are the squares.
    fn begin_with(&mut self, point: BranchPoint) {
        let multipliers = point.multipliers.iter().map(|it| *it * *it).collect();
        let is_doubled = self.origin == Origin::PeriodDoubling;
        let doubled = BranchPoint { multipliers, period: 2.0 * point.period, ..point.clone() };
        self.points.insert(0, if is_doubled { doubled } else { point });
        self.special.iter_mut().for_each(|special| special.before += 1);
    }
}
