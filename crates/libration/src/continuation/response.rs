//! The answers of a driven system over a range of a parameter: all branches that are found from its ends, and what branches off.

use super::branch::{Branch, Ending, Limits, Origin, Walk, Walked};
use super::corrector::Corrector;
use super::error::NoBranch;
use super::family::{Family, TOLERANCES};
use super::jumps::{Jump, jumps};
use super::node::{Node, largest_swing, units};
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
    /// The state from which a motion is looked for at each end of the range; rest, where all numbers are zero, if there is none.
    pub start: Option<Vec<f64>>,
    /// The value of the parameter at which it is looked for, and followed from both ways; the ends of the range if there is none. Curves that
    /// close within the range are found from there only.
    pub at: Option<f64>,
    /// How many periods of the drive an answer takes: 1, or more for subharmonic answers.
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

/// The answers of a driven system over a range of a parameter.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Response {
    /// Those from the ends of the range before those that branch off.
    pub branches: Vec<Branch>,
    /// The jumps of slow sweeps, branch by branch.
    pub jumps: Vec<Jump>,
    /// Whether the watch ended it before all was followed.
    pub interrupted: bool,
}

impl Response {
    /// The branches of periodic motions of a driven system over a range of one of its parameters, which is left open in the equations: an
    /// amplitude, a damping, or the frequency of the drive itself. They begin with the motions that Newton's method finds at the ends of
    /// the range, and go through folds by pseudo-arclength; motions that lose their symmetry or double their period are followed too.
    ///
    /// Motions come from the Taylor integrator with the equations of small deviations, so that no number of harmonics is too large. A symmetric
    /// motion is followed by its half period and its mirror image: folds, losses of symmetry and doublings are then zeros of different functions.
    /// They are found along the branch to the last digits.
    ///
    /// # Accuracy
    /// As the errors of points and singular points say, some 1e-14 where no multiplier is large.
    ///
    /// # Errors
    /// Equations without a periodic drive, another open parameter, a range without a width, no motion at either end.
    ///
    /// # Examples
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
        let family = Family::new(equation, &[parameter], &[range], watch)?;
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
                Ok(state) if is_known(&branches, value, &state) => {}
                Ok(state) => {
                    let Some(walked) = self.through(value, &state, into) else { continue };
                    left.extend(self.leaving(&walked, 0));
                    met.extend(walked.meeting.map(|parameter| (walked.branch.space, parameter)));
                    branches.push(walked.branch);
                }
                Err(NoOrbit::Interrupted(interrupted)) if branches.is_empty() => {
                    return Err(interrupted.into());
                }
                Err(error) => missing = Some(error),
            }
        }
        if let (true, Some(error)) = (branches.is_empty(), missing) {
            return Err(NoBranch::NoStart(error));
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
        Ok(Response { branches, jumps, interrupted: self.family.watch.is_stopped() })
    }

    /// A periodic motion at an end of the range.
    fn start(&self, value: f64) -> Result<Vec<f64>, NoOrbit> {
        let exact = |value: f64| Some(Expression::Number(BigFloat::from_f64(value, 53)?.to_rational()));
        let put_in = exact(value).and_then(|exact| self.equation.with(&[(self.parameter, exact)]).ok());
        let duration = self.family.duration(self.space(), &[value]);
        let (Some(equation), Some(period)) = (put_in, duration) else { return Err(NoOrbit::NoPeriod) };
        let start = self.options.start.clone().unwrap_or_else(|| vec![0.0; self.family.layout.numbers()]);
        match Orbit::driven_watched(&equation, period, &start, self.family.watch) {
            Ok(orbit) => Ok(orbit.start()),
            // The drive has the amplitude zero.
            Err(NoOrbit::NotDriven) => Ok(start),
            Err(error) => Err(error),
        }
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

    fn limits(&self) -> Limits {
        /// Times the least period: at so low a frequency the motion follows the drive through all its superharmonic resonances.
        const SLOW: f64 = 100.0;
        let periods =
            self.range.map(|value| self.family.duration(self.space(), &[value]).unwrap_or(f64::INFINITY));
        let longest_period = SLOW * periods[0].min(periods[1]);
        Limits { range: self.range, most_points: self.options.most_points, longest_period }
    }

    fn corrector(&self, space: Space) -> Corrector<'_> {
        /// Multipliers of points need no more digits than that.
        const STALE: f64 = 1e-12;
        Corrector { family: self.family, space, tolerance: TOLERANCES[0], stale: STALE }
    }

    /// The branch through a motion, in the smallest space that has it: from an end of the range on, or both ways.
    fn through(&self, value: f64, state: &[f64], into: f64) -> Option<Walked> {
        let walked = self.primary(value, state, into)?;
        if self.options.at.is_none() || walked.branch.ending == Ending::Closed {
            return Some(walked);
        }
        let back = self.primary(value, state, -into);
        Some(back.map_or_else(|| walked.clone(), |back| back.turned_into(&walked)))
    }

    fn primary(&self, value: f64, state: &[f64], into: f64) -> Option<Walked> {
        let corrector = self.corrector(self.smallest(self.space(), state, value));
        let mut along = vec![0.0; state.len() + 1];
        *along.last_mut()? = into;
        let place: Vec<f64> = state.iter().copied().chain([value]).collect();
        let start = Node::near(&corrector, &place, [&along, &along], self.width())?;
        Some(Walk::new(corrector, self.limits(), start).walked(Origin::Primary))
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
            Some((
                generation + 1,
                Leaving {
                    origin: origin(special.kind)?,
                    parent: walked.branch.space,
                    space,
                    node: node.clone(),
                },
            ))
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
        let matrix: Vec<Vec<f64>> = leaving.node.corrected.image.map.iter().enumerate().map(turned).collect();
        let vector = null_space(&Doubles, |x| x.abs(), &matrix, 1)?.pop()?;
        let parent = &leaving.node.point;
        let sizes = units(&self.family.layout, parent, largest_swing(parent), self.width());
        let largest = vector.iter().zip(&sizes).map(|(x, unit)| (x / unit).abs()).fold(0.0, f64::max);
        let aside: Vec<f64> = vector.iter().map(|x| ASIDE * x / largest).chain([0.0]).collect();
        let place: Vec<f64> = leaving.node.place().iter().zip(&aside).map(|(x, d)| x + d).collect();
        let start = Node::near(&self.corrector(leaving.space), &place, [&aside, &aside], self.width())?;
        let space = self.smallest(leaving.space, &start.point.state, start.point.parameter);
        if space == leaving.parent {
            return None;
        }
        let corrector = self.corrector(space);
        let start = Node::near(&corrector, start.place(), [&aside, &aside], self.width())?;
        let mut walked = Walk::new(corrector, self.limits(), start).walked(leaving.origin);
        walked.branch.begin_with(leaving.node.point.clone());
        Some(walked)
    }
}

/// A branch that leaves another one.
struct Leaving {
    origin: Origin,
    parent: Space,
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

/// Whether a motion at an end of the range is the end of a branch that is followed already.
fn is_known(branches: &[Branch], value: f64, state: &[f64]) -> bool {
    /// Of the size of the state.
    const SAME: f64 = 1e-7;
    let size = state.iter().map(|x| x.abs()).fold(1e-6, f64::max);
    let ends = branches.iter().flat_map(|branch| [branch.points.first(), branch.points.last()]).flatten();
    ends.filter(|point| point.parameter.to_bits() == value.to_bits())
        .any(|point| point.state.iter().zip(state).all(|(a, b)| (a - b).abs() <= SAME * size))
}
