//! The responses of a driven system over a parameter range: all branches from its ends, and their secondary branches.

use super::branch::{Branch, Origin, Walked};
use super::coordinate_units::CoordinateUnits;
use super::error::BranchError;
use super::family::Family;
use super::jumps::Jump;
use super::node::Node;
use super::options::ResponseOptions;
use super::orders::OrderAnswers;
use super::point::BranchPoint;
use super::search::{Search, Start};
use super::space::Space;
use super::special::Meeting;
use super::switching::Leaving;
use super::units::{LEAST, largest_half_range};
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Progress, Stage};

/// The periodic motions of a driven or self-excited system over a range of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    /// The branches; those from the ends of the range come before secondary ones.
    pub branches: Vec<Branch>,
    /// Results of the search for each order.
    pub orders: Vec<OrderAnswers>,
    /// The jumps of slow sweeps, branch by branch.
    pub jumps: Vec<Jump>,
    /// The parameter values at which a motion to begin with was not found, with the reasons.
    pub missing: Vec<(f64, BranchError)>,
    /// `true` if a drive sets the periods; otherwise the motions are limit cycles.
    pub driven: bool,
    /// `true` if the computation was cancelled before all branches were followed.
    pub interrupted: bool,
}

impl Response {
    /// The branches of periodic motions of a driven system over a range of one of its parameters, which is symbolic in the equations: an
    /// amplitude, a damping, or the drive frequency itself. They begin with the motions that Newton's method finds at the ends of the range, from
    /// the start and from estimates by harmonic balance, and pass folds by pseudo-arclength continuation; secondary branches from symmetry
    /// breaking and period doubling are followed too.
    ///
    /// If the time does not occur in the equations, the motions are limit cycles, beginning with those to which
    /// the start settles at the ends of the range. The period is an additional unknown, and a motion begins where
    /// the first coordinate turns back. A branch that shrinks to an equilibrium ends there, at a Hopf point. Each
    /// turn of the first coordinate counts as a separate period until the true period of the cycle is known.
    ///
    /// Motions are computed by the Taylor integrator with the variational equations, so that their harmonics are not
    /// truncated. A symmetric motion is followed over half its period with its mirror image: folds, symmetry breakings
    /// and period doublings are then zeros of different functions. They are located along the branch to the last digits.
    ///
    /// `progress` receives the number of points. A cancelled call returns the branches as far as they were followed.
    ///
    /// # Accuracy
    /// As the errors of points and singular points state, about 1e-14 if no multiplier is large.
    ///
    /// # Errors
    /// Equations in which the time occurs outside a periodic drive, another symbolic parameter, a range
    /// without a width, no motion at either end, or autonomous motions that form families at each value, as
    /// in conservative systems. [`BranchError::Interrupted`] if the call is cancelled before the first point.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_branches as libration;
    /// use libration::continuation::{Response, ResponseOptions, SpecialKind};
    /// use libration::progress::Quiet;
    /// // The limit cycle of the Brusselator begins at b = 1 + a² with the period 2π/a.
    /// let brusselator = "x' = 1 + x^2*y - (b + 1)*x; y' = b*x - x^2*y".parse()?;
    /// let response = Response::over(&brusselator, "b", [1.5, 3.0], &ResponseOptions::default(), &Quiet)?;
    /// let hopf = response.branches[0].special.iter().find(|it| it.kind == SpecialKind::Hopf).ok_or("no Hopf point")?;
    /// assert!((hopf.point.parameter - 2.0).abs() < 1e-14 && (hopf.point.period - std::f64::consts::TAU).abs() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    /// ```
    /// # extern crate libration_branches as libration;
    /// use libration::continuation::{Response, ResponseOptions, SpecialKind};
    /// use libration::progress::Quiet;
    /// // Duffing's equation with hardening, which bends its resonance to higher frequencies.
    /// let duffing = "x'' = -0.05*x' - x - 0.1*x^3 + 0.18*cos(w*t)".parse()?;
    /// let response = Response::over(&duffing, "w", [0.5, 1.6], &ResponseOptions::default(), &Quiet)?;
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
        progress: &dyn Progress,
    ) -> Result<Self, BranchError> {
        let watch = &Watch::new(progress);
        let [from, to] = range;
        if !(from.is_finite() && to.is_finite() && (from < to || to < from)) {
            return Err(BranchError::Range { from, to });
        }
        watch.begin(Stage::Whole, None);
        let range = [from.min(to), from.max(to)];
        if let Some(at) = options.at.filter(|at| !(range[0]..=range[1]).contains(at)) {
            return Err(BranchError::Outside { at, from, to });
        }
        let family = Family::free_or_driven(equation, &[parameter], &[range], watch)?
            .at_scale_of(options.start.as_deref().unwrap_or_default());
        let needs_drive =
            options.drive_periods != 1 || !options.orders.is_empty() || options.rotation.is_some();
        if !family.is_driven() && needs_drive {
            return Err(BranchError::NotDriven);
        }
        let search = Search { equation, parameter, family: &family, range, options };
        options.rotation.map_or(Ok(()), |rotation| search.check(rotation))?;
        let starts = search.starts_of_range();
        let first =
            starts.iter().find_map(|((value, _), starts)| Some((*value, starts.as_ref().ok()?.first()?)));
        let units = first.and_then(|(value, start)| CoordinateUnits::of(&search, value, start));
        let Some((scaled, units)) = units.and_then(|units| Some((units.equation(equation)?, units))) else {
            return search.response(starts);
        };
        let start = options.start.as_deref().map(|start| units.state(start));
        let mut response =
            Self::over(&scaled, parameter, range, &ResponseOptions { start, ..options.clone() }, progress)?;
        units.restore(&mut response.branches, &mut response.jumps);
        Ok(response)
    }
}

/// Branches followed so far, and those left to follow.
#[derive(Default)]
struct FollowedBranches {
    branches: Vec<Branch>,
    leaving: Vec<(usize, Leaving)>,
    /// Points where a branch met another one, which then has no further branch to switch to there.
    met: Vec<(Space, Meeting)>,
    /// Meetings whose other branch has not been searched yet, each with the generation of the branch that ends there.
    open: Vec<(usize, Meeting)>,
}

/// A value of the parameter at which branches begin, with the direction into the range.
type Beginning = (f64, f64);
/// The motions found there.
type Starts = (Beginning, Result<Vec<Start>, BranchError>);

impl Search<'_> {
    /// The motions to begin with at the ends of the range, or at the given value.
    fn starts_of_range(&self) -> Vec<Starts> {
        let [low, high] = self.range;
        let beginnings = self.options.at.map_or(vec![(low, 1.0), (high, -1.0)], |at| vec![(at, 1.0)]);
        beginnings.into_iter().map(|begin_at| (begin_at, self.starts(begin_at.0))).collect()
    }

    fn response(&self, starts: Vec<Starts>) -> Result<Response, BranchError> {
        let mut followed = FollowedBranches::default();
        let mut missing: Vec<(f64, BranchError)> = vec![];
        let beginnings: Vec<Beginning> = starts.iter().map(|(begin_at, _)| *begin_at).collect();
        for (begin_at, starts) in starts {
            match starts {
                Ok(starts) => self.begin(&mut followed, &mut missing, begin_at, starts),
                Err(BranchError::Interrupted(interrupted)) if followed.branches.is_empty() => {
                    return Err(interrupted.into());
                }
                Err(error) => missing.push((begin_at.0, error)),
            }
        }
        let mut orders = vec![];
        for order in &self.options.orders {
            orders.push(self.of_order(*order, &mut followed.branches, |walked| {
                followed.leaving.extend(self.leaving(walked, 0));
            })?);
        }
        self.follow_all(&mut followed);
        // A further motion may lie on a secondary branch.
        let largest = |branches: &[Branch]| {
            branches.iter().flat_map(|branch| &branch.points).map(largest_half_range).fold(0.0, f64::max)
        };
        for begin_at in beginnings {
            let further = self.further_starts(begin_at.0, largest(&followed.branches));
            if !further.is_empty() {
                missing.retain(|(value, _)| value.to_bits() != begin_at.0.to_bits());
            }
            self.begin(&mut followed, &mut missing, begin_at, further);
            self.follow_all(&mut followed);
        }
        for value in self.values_between_wells(&followed.branches) {
            for start in self.lasting_starts(value, largest(&followed.branches)) {
                if let Some(walked) = self.new_branch(&followed.branches, (value, &start), Origin::Within) {
                    self.keep(&mut followed, walked, 0);
                    self.follow_all(&mut followed);
                }
            }
        }
        if followed.branches.is_empty()
            && let Some((_, error)) = missing.pop()
        {
            return Err(error);
        }
        let jumps = self.follow_landings(&mut followed);
        let branches = followed.branches;
        let (driven, interrupted) = (self.family.is_driven(), self.family.watch.is_stopped());
        Ok(Response { branches, orders, jumps, missing, driven, interrupted })
    }

    /// Follows the branches through motions at a value that are not yet on a branch.
    fn begin(
        &self,
        followed: &mut FollowedBranches,
        missing: &mut Vec<(f64, BranchError)>,
        (value, into): Beginning,
        starts: Vec<Start>,
    ) {
        for start in starts {
            if self.is_known(&followed.branches, value, &start) {
                continue;
            }
            match self.through(value, &start, into) {
                Ok(Some(walked)) => self.keep(followed, walked, 0),
                Ok(None) if self.family.watch.is_stopped() => {}
                Ok(None) if self.family.is_driven() => missing.push((value, BranchError::NoNeighbour)),
                Ok(None) => missing.push((value, BranchError::NotFollowed)),
                Err(error) => missing.push((value, error)),
            }
        }
    }

    /// Follows the branches to which slow sweeps jump where no known motion is stable, and returns all jumps.
    fn follow_landings(&self, followed: &mut FollowedBranches) -> Vec<Jump> {
        /// Most folds from which motions are integrated, each over up to a thousand periods.
        const MOST: usize = 6;
        let mut tried = vec![];
        loop {
            let jumps = self.jumps(&followed.branches);
            let is_open =
                |jump: &&Jump| jump.to.is_empty() && !tried.contains(&jump.from.parameter.to_bits());
            let open = jumps.iter().find(is_open).filter(|_| tried.len() < MOST);
            let Some(jump) = open.filter(|_| !self.family.watch.is_stopped()) else { return jumps };
            tried.push(jump.from.parameter.to_bits());
            if let Some(walked) = self.landing_branch(&followed.branches, jump) {
                self.keep(followed, walked, 0);
                self.follow_all(followed);
            }
        }
    }

    fn follow_all(&self, followed: &mut FollowedBranches) {
        while !self.family.watch.is_stopped() && self.follow_next(followed) {}
    }

    /// Adds a branch, with the branches that leave it and the meetings at its ends.
    fn keep(&self, followed: &mut FollowedBranches, walked: Walked, generation: usize) {
        followed.leaving.extend(self.leaving(&walked, generation));
        followed.met.extend(walked.meetings.iter().map(|meeting| (walked.branch.space, meeting.clone())));
        followed.open.extend(walked.meetings.into_iter().map(|meeting| (generation, meeting)));
        followed.branches.push(walked.branch);
    }

    /// Follows a branch that leaves another one, or one on which another branch ends; returns `false` if none is left. The search terminates: a
    /// branch that leaves another one has a higher generation, and one on which another branch ends has the same generation and a smaller space.
    fn follow_next(&self, followed: &mut FollowedBranches) -> bool {
        if let Some((generation, start)) = followed.leaving.pop() {
            if !followed.met.iter().any(|(space, meeting)| self.is_met(&start, *space, meeting.parameter))
                && let Some(walked) = self.switched(&start)
            {
                self.keep(followed, walked, generation);
            }
            return true;
        }
        let Some((generation, meeting)) = followed.open.pop() else { return false };
        let Meeting { parameter, unknowns, space } = meeting;
        let start = Start { unknowns, space };
        if !self.is_followed(&followed.branches, parameter, &start)
            && let Some(mut walked) = self.beside(&followed.branches, parameter, &start)
            && !self.is_again(&followed.branches, &walked.branch)
        {
            walked.branch.origin = Origin::Meeting;
            self.keep(followed, walked, generation);
        }
        true
    }

    /// The branch through a motion, from a nearby parameter on: the motion itself is singular, since another
    /// branch ends there, and known only by interpolation. `None` if the branch is already followed.
    fn beside(&self, branches: &[Branch], parameter: f64, start: &Start) -> Option<Walked> {
        /// Distance of the nearby parameter, relative to the range.
        const ASIDE: f64 = 1e-3;
        let values = [1.0, -1.0].map(|side| parameter + side * ASIDE * self.width());
        let within = values.into_iter().filter(|value| (self.range[0]..=self.range[1]).contains(value));
        let corrected = within.filter_map(|value| Some((value, self.corrected(value, start)?)));
        let starts: Vec<(f64, Start)> = corrected.collect();
        if starts.iter().any(|(value, start)| self.is_followed(branches, *value, start)) {
            return None;
        }
        starts.iter().find_map(|(value, start)| self.both_ways(*value, start).ok().flatten())
    }

    /// Returns `true` if a branch ends at an end of the range as one that is followed already: next to folds a motion on it may not be found there.
    fn is_again(&self, branches: &[Branch], branch: &Branch) -> bool {
        let corrector = self.corrector(branch.space);
        let is_end = |point: &BranchPoint| {
            let start = Start { unknowns: corrector.unknowns(point), space: branch.space };
            self.is_known(branches, point.parameter, &start)
        };
        branch.points.first().is_some_and(is_end)
    }

    /// The motion to which Newton's method converges at a value of the parameter.
    pub(super) fn corrected(&self, value: f64, start: &Start) -> Option<Start> {
        let corrector = self.corrector(start.space);
        let unknowns: Vec<f64> = start.unknowns.iter().copied().chain([value]).collect();
        let along: Vec<f64> =
            (0..unknowns.len()).map(|j| if j + 1 < unknowns.len() { 0.0 } else { 1.0 }).collect();
        let node = Node::near(&corrector, &unknowns, [&along, &along], self.width())?;
        Some(Start { unknowns: corrector.unknowns(&node.point), space: start.space })
    }

    /// Returns `true` if a motion at an end of the range, begun at another period of the drive or mirrored, is the end of a branch
    /// that is already followed; or, for a rotating motion or one at a value within the range, lies on it.
    fn is_known(&self, branches: &[Branch], value: f64, start: &Start) -> bool {
        let may_be_within = start.space.rotation.is_some() || self.options.at.is_some();
        if may_be_within && self.is_followed(branches, value, start) {
            return true;
        }
        /// Largest difference relative to the size of the state.
        const SAME: f64 = 1e-7;
        let sizes = self.family.sizes_of(&start.unknowns, value, LEAST);
        let copies = self.copies(start, value).unwrap_or_else(|| vec![start.unknowns.clone()]);
        let is_same = |point: &BranchPoint| match self.family.is_driven() {
            true => copies.iter().any(|copy| self.family.turning.are_near(&point.state, copy, &sizes, SAME)),
            false => self.is_cycle(start, value, point, SAME),
        };
        let ends = branches.iter().flat_map(|branch| [branch.points.first(), branch.points.last()]).flatten();
        ends.filter(|point| point.parameter.to_bits() == value.to_bits()).any(is_same)
    }
}
