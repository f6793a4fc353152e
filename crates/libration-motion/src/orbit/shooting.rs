//! Newton's method for a state that a motion reaches again after one period.
//!
//! # Method
//! All orbits that are not released from rest are closed by Newton's method, whose matrix comes from the variational equations
//! (`periodic::Flow`). Least squares let one condition replace another, as conservation of energy does. The uncertainty of the period is the
//! change by one more step of Newton's method, for this integration and for one with other steps. If the start closes with the period as the
//! only unknown, and a neighbour closes too, the orbit is one of a family and is not changed (`family.rs`). Harmonics are sums over evenly
//! spaced times, whose number is doubled until the last harmonics vanish (`harmonics.rs`).
//!
//! The error of the start is the residual and the error of the flow, multiplied by the inverse of the bordered matrix. Along the orbit this
//! error grows with the variations; with the error of the period it gives the errors of states, extrema and harmonics. If it exceeds a hundredth
//! of the orbit, neighbouring motions close as well and the orbit is not isolated.

use super::closing::{Round, Rounds};
use super::divergence::Divergence;
use super::error::{Lost, OrbitError, finished};
use super::least_period::over_least_period;
use super::near::OrbitGuess;
use super::periodic::{Orbit, OrbitErrors};
use crate::periodic::{CLOSED, Floquet, LOST, NewtonStep, Stability, norm_of_map};
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;

impl Orbit {
    /// The periodic orbit near a guess, on which some components of the state at the start keep the values of
    /// the guess: one component chooses the start on an isolated cycle, two choose an orbit of the families
    /// of a conservative system, for instance a coordinate at its largest value and its velocity of zero.
    ///
    /// # Accuracy
    /// As stated by [`period_uncertainty`](Self::period_uncertainty).
    ///
    /// # Errors
    /// A guess that does not fit, the time in the equation, a motion that cannot be computed, and [`OrbitError::NoConvergence`].
    /// [`OrbitError::Interrupted`] if the call is cancelled.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::orbit::{OrbitGuess, Orbit};
    /// use libration::progress::Quiet;
    /// // Two equal masses between three springs, of which the middle one stiffens: an oscillation in opposite phase, x = −y.
    /// let equation = "x'' = y - 2*x - (x - y)^3; y'' = x - 2*y + (x - y)^3".parse()?;
    /// let guess = OrbitGuess { state: vec![0.1, -0.1, 0.0, 0.0], period: 3.6 };
    /// let orbit = Orbit::near(&equation, &guess, &[0, 2], &Quiet)?;
    /// let alone = Orbit::released(&"x'' = -3*x - 8*x^3".parse()?, 0.1, &Quiet)?;
    /// assert!((orbit.period() - alone.period()).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # References
    /// R. Seydel, *Practical Bifurcation and Stability Analysis*, Springer 2010, chapter 7, doi:10.1007/978-1-4419-1740-9.
    pub fn near(
        equation: &Equation,
        guess: &OrbitGuess,
        fixed: &[usize],
        progress: &dyn Progress,
    ) -> Result<Self, OrbitError> {
        let watch = &Watch::new(progress);
        if equation.depends_on_time() {
            return Err(OrbitError::DependsOnTime);
        }
        let rounds = Rounds::new(equation, watch)?;
        let free = (0..rounds.layout().numbers()).filter(|number| !fixed.contains(number)).collect();
        let unknowns = Unknowns { free, period: true };
        finished(closed(equation, &rounds, guess, &unknowns), watch)
    }
}

/// The unknowns that Newton's method may change.
pub(super) struct Unknowns {
    /// Numbers of the free state components.
    pub(super) free: Vec<usize>,
    /// `true` if the period is one of the unknowns.
    pub(super) period: bool,
}

impl Unknowns {
    /// The unknowns without components whose rates of change are zero: they close with any value.
    fn without_constants(&self, equation: &Equation, rounds: &Rounds<'_>) -> Self {
        let layout = rounds.layout();
        let is_constant = |number: usize| {
            let driving = layout.driving(number).filter(|_| !layout.is_velocity(number));
            driving.is_some_and(|coordinate| equation.derivatives()[coordinate].vanishes())
        };
        let free = self.free.iter().copied().filter(|number| !is_constant(*number)).collect();
        Self { free, period: self.period }
    }
}

/// Maximum number of rounds of Newton's method; in 40 rounds of the next constant a size can change by the factor 1.3⁴⁰ = 4·10⁴.
const MOST_ROUNDS: usize = 40;
/// Largest change of a state component in one round, relative to its size.
const LARGEST_CHANGE: f64 = 0.3;
/// Relative distance from the start below which the rounds end as soon as they no longer halve the distance.
const NEARLY_CLOSED: f64 = 1e-10;
/// Relative error of the start, or of the period, above which an orbit is not distinguished from its neighbours.
const UNDETERMINED: f64 = 0.01;

/// Size relative to the guess below which an orbit is an equilibrium: every round has shrunk it as much as a round may, 0.7⁴⁰ = 6e-7.
const VANISHED: f64 = 1e-6;

/// The orbit near a guess; over its least period, if the period is an unknown. If the period is given, it has to be one of the drive.
pub(super) fn closed(
    equation: &Equation,
    rounds: &Rounds<'_>,
    guess: &OrbitGuess,
    unknowns: &Unknowns,
) -> Result<Orbit, OrbitError> {
    let unknowns = &unknowns.without_constants(equation, rounds);
    let orbit = closed_once(equation, rounds, guess, unknowns)?;
    if !unknowns.period {
        let of_drive = drive_repeats(rounds, &orbit)?;
        return if of_drive { Ok(orbit) } else { Err(OrbitError::NotOfDrive(orbit.period())) };
    }
    over_least_period(orbit, |state, period| {
        closed_once(equation, rounds, &OrbitGuess { state, period }, unknowns)
    })
}

/// Returns `true` if the rates of change on the orbit are the same a period later: a state that returns to another force does not repeat.
fn drive_repeats(rounds: &Rounds<'_>, orbit: &Orbit) -> Result<bool, OrbitError> {
    /// Number of times that are compared.
    const TIMES: u32 = 64;
    /// The first time as a fraction of their distance, so that none is a simple fraction of the period, where drives jump.
    const FIRST: f64 = 0.382;
    /// Largest difference relative to the largest rate. The rounding of a period, 1e-16, is a millionth of it where a drive rises in a
    /// millionth of its period.
    const SAME: f64 = 1e-9;
    let period = orbit.period();
    let mut largest = vec![0.0_f64; rounds.layout().numbers()];
    let mut apart = largest.clone();
    for number in 0..TIMES {
        let time = period * (f64::from(number) + FIRST) / f64::from(TIMES);
        let state = orbit.state_at(time);
        let (now, later) = (rounds.rate(&state, time)?, rounds.rate(&state, time + period)?);
        for (component, (now, later)) in now.iter().zip(&later).enumerate() {
            largest[component] = largest[component].max(now.abs());
            apart[component] = apart[component].max((now - later).abs());
        }
    }
    Ok(apart.iter().zip(&largest).all(|(apart, largest)| *apart <= SAME * largest))
}

/// The orbit near a guess, which it may go round several times.
fn closed_once(
    equation: &Equation,
    rounds: &Rounds<'_>,
    guess: &OrbitGuess,
    unknowns: &Unknowns,
) -> Result<Orbit, OrbitError> {
    check(rounds, guess)?;
    let mut newton = Newton::new(rounds, unknowns, guess)?;
    // The swing of a guess that runs away from an unstable orbit says nothing about the size of that orbit.
    let size_of_guess = newton.size() / newton.lost().unwrap_or(1.0);
    let taken = newton.converge()?;
    if newton.size() < VANISHED * size_of_guess {
        return Err(OrbitError::NoCycle(newton.kind_of_rest()));
    }
    newton.judged(equation, taken)
}

fn check(rounds: &Rounds<'_>, guess: &OrbitGuess) -> Result<(), OrbitError> {
    let wanted = rounds.layout().numbers();
    if guess.state.len() != wanted || !guess.state.iter().all(|x| x.is_finite()) {
        return Err(OrbitError::Start { state: guess.state.clone(), wanted });
    }
    if !(guess.period > 0.0 && guess.period.is_finite()) {
        return Err(OrbitError::Period(guess.period));
    }
    Ok(())
}

/// The state of Newton's method.
pub(super) struct Newton<'a> {
    pub(super) rounds: &'a Rounds<'a>,
    pub(super) unknowns: &'a Unknowns,
    pub(super) at: OrbitGuess,
    pub(super) round: Round,
    pub(super) sizes: Vec<f64>,
    /// The largest difference between end and start of a state component, relative to its size.
    miss: f64,
}

impl<'a> Newton<'a> {
    fn new(rounds: &'a Rounds<'a>, unknowns: &'a Unknowns, guess: &OrbitGuess) -> Result<Self, OrbitError> {
        let round = rounds.round(&guess.state, guess.period)?;
        let sizes = round.sizes(rounds.layout(), guess);
        let miss = miss(&round.defect, &sizes);
        Ok(Self { rounds, unknowns, at: guess.clone(), round, sizes, miss })
    }

    /// The kind of equilibrium to which Newton's method has shrunk the orbit: attracting or not.
    fn kind_of_rest(&self) -> Lost {
        /// Relative tolerance of the integration of variations.
        const VARIATIONS: f64 = 1e-12;
        let floquet = Floquet::new(&self.round.monodromy, &self.sizes, VARIATIONS, false);
        if floquet.map(|floquet| floquet.stability) == Some(Stability::Attracting) {
            Lost::Rest
        } else {
            Lost::UnstableRest
        }
    }

    /// The largest swing of a coordinate.
    fn size(&self) -> f64 {
        self.sizes[..self.rounds.layout().coordinates()].iter().copied().fold(0.0, f64::max)
    }

    /// Makes rounds until they no longer improve the orbit; returns their number.
    fn converge(&mut self) -> Result<usize, OrbitError> {
        for count in 0..MOST_ROUNDS {
            let before = self.miss;
            if before == 0.0 || !self.improve()? {
                return Ok(count);
            }
            if self.miss > 0.5 * before && self.miss < NEARLY_CLOSED {
                return Ok(count + 1);
            }
        }
        Ok(MOST_ROUNDS)
    }

    /// Makes one step, shortened until it reduces the distance; returns `true` if it does.
    fn improve(&mut self) -> Result<bool, OrbitError> {
        /// Maximum number of halvings: with steps below 2⁻¹² of Newton's own the allowed rounds would not suffice.
        const HALVINGS: u32 = 12;
        let Some(change) = self.change(&self.round.defect) else { return Ok(false) };
        let mut part = self.largest_part(&change);
        for _ in 0..HALVINGS {
            let next = self.moved(&change, part);
            // Below rounding: defects are compared down to the last digit.
            let end =
                self.rounds.path(&next.state, next.period, 1e-17).map(|path| path.state_at(next.period));
            let near = end.is_ok_and(|end| {
                let defect: Vec<f64> = end.iter().zip(&next.state).map(|(a, b)| a - b).collect();
                miss(&defect, &self.sizes) < self.miss
            });
            if near {
                *self = Self::new(self.rounds, self.unknowns, &next)?;
                return Ok(true);
            }
            part *= 0.5;
        }
        Ok(false)
    }

    /// The equations of the next step, in units of the sizes of the orbit.
    fn step(&self) -> NewtonStep {
        let Unknowns { free, period } = self.unknowns;
        let period = period.then_some((&self.round.rate[..], self.at.period));
        NewtonStep::new(&self.round.monodromy, &self.sizes, free, period.as_slice())
    }

    /// The change that would close the orbit if its end were linear in its start: of the free components, then of the period.
    fn change(&self, defect: &[f64]) -> Option<Vec<f64>> {
        let change = self.step().change(defect, &[])?;
        Some(change.iter().zip(self.units()).map(|(x, unit)| x * unit).collect())
    }

    /// The sizes of the free components, then of the period.
    fn units(&self) -> impl Iterator<Item = f64> {
        let Unknowns { free, period } = self.unknowns;
        free.iter().map(|&j| self.sizes[j]).chain(period.then_some(self.at.period))
    }

    fn largest_part(&self, change: &[f64]) -> f64 {
        let largest = change.iter().zip(self.units()).map(|(x, unit)| (x / unit).abs()).fold(0.0, f64::max);
        if largest > LARGEST_CHANGE { LARGEST_CHANGE / largest } else { 1.0 }
    }

    fn moved(&self, change: &[f64], part: f64) -> OrbitGuess {
        let mut next = self.at.clone();
        for (&j, x) in self.unknowns.free.iter().zip(change) {
            next.state[j] += part * x;
        }
        if self.unknowns.period {
            next.period += part * change.last().copied().unwrap_or(0.0);
        }
        next
    }

    /// The orbit with its errors, if it closes within the error of the flow and the rounding of its start.
    fn judged(self, equation: &Equation, rounds: usize) -> Result<Orbit, OrbitError> {
        let again = self.rounds.path(&self.at.state, self.at.period, 1e-16)?;
        let end = again.state_at(self.at.period);
        let other: Vec<f64> = end.iter().zip(&self.at.state).map(|(a, b)| a - b).collect();
        let [rounded_start, rounding] = self.rounding()?;
        let spread: Vec<f64> = other.iter().zip(&self.round.defect).map(|(a, b)| (a - b).abs()).collect();
        if self.miss > CLOSED * (miss(&spread, &self.sizes) + miss(&rounded_start, &self.sizes)) {
            return Err(self.not_closed(rounds));
        }
        let uncertainty = self.period_uncertainty(&other, &rounding);
        let [monodromy, largest] = self.rounds.largest_variations(&self.at.state, self.at.period)?;
        let residual = (0..rounding.len()).map(|i| self.round.defect[i].abs() + other[i].abs() + rounding[i]);
        let start = self.start_errors(&residual.collect::<Vec<f64>>());
        // Where only the period is unknown, its error alone shows that nothing is determined: next to a saddle a start may close after any time.
        let undetermined = libm::fmax(miss(&start, &self.sizes), uncertainty / self.at.period);
        if undetermined > UNDETERMINED {
            let unstable = self.lost().map(|growth| OrbitError::TooUnstable { growth });
            return Err(unstable.unwrap_or(OrbitError::Undetermined(undetermined)));
        }
        if self.lost().is_some_and(|growth| !self.closes_by_pieces(&start, uncertainty, growth)) {
            return Err(self.not_closed(rounds));
        }
        let grown: Vec<f64> =
            largest.iter().map(|row| row.iter().zip(&start).map(|(a, b)| a * b).sum()).collect();
        let apart: Vec<f64> = self.round.path.apart(&again).iter().map(|distance| 4.0 * distance).collect();
        let errors = OrbitErrors::new(&self.round.path, start, &grown, &apart, uncertainty);
        let autonomous = self.unknowns.period;
        let change =
            self.change_of_map(&monodromy, &errors.start) + self.change_across_jumps(&errors.start)?;
        let floquet = Floquet::new(&self.round.monodromy, &self.sizes, change, autonomous);
        let divergence = Divergence::new(equation).filter(|_| autonomous && !self.rounds.has_jumps());
        let logarithm = divergence.map(|divergence| divergence.along(&self.round.path));
        let floquet = floquet.map(|floquet| Floquet { logarithm, ..floquet });
        Ok(Orbit::new(equation, self.round.path, uncertainty, floquet, errors))
    }

    /// The growth of deviations in a period, if it makes the rounding of the start more than Newton's method may lose.
    fn lost(&self) -> Option<f64> {
        let growth = self.norm(|i, j| self.round.monodromy[i][j]);
        (growth * f64::EPSILON > LOST).then_some(growth)
    }

    /// The reason why the orbit does not close.
    fn not_closed(&self, rounds: usize) -> OrbitError {
        if let Some(growth) = self.lost() {
            return OrbitError::TooUnstable { growth };
        }
        let defect: Vec<f64> = self.round.defect.iter().map(|component| component.abs()).collect();
        let undetermined = miss(&self.start_errors(&defect), &self.sizes);
        if self.miss < NEARLY_CLOSED && undetermined > UNDETERMINED {
            return OrbitError::Undetermined(undetermined);
        }
        OrbitError::NoConvergence { rounds, defect: self.miss }
    }

    /// The effect on the end of rounding the state once: at the start, and where it is largest on the way. Past a saddle that is far from the start.
    fn rounding(&self) -> Result<[Vec<f64>; 2], OrbitError> {
        /// Number of pieces, at whose ends the state is rounded.
        const PIECES: u32 = 16;
        let numbers = self.sizes.len();
        let time = |piece: u32| self.at.period * f64::from(piece) / f64::from(PIECES);
        let unit = |i: usize| (0..numbers).map(|j| if i == j { 1.0 } else { 0.0 }).collect();
        let mut to_end: Vec<Vec<f64>> = (0..numbers).map(unit).collect();
        let mut of_start = vec![0.0; numbers];
        let mut largest = of_start.clone();
        for piece in (0..PIECES).rev() {
            let state = self.round.path.state_at(time(piece));
            let over = self.rounds.variations(&state, [time(piece), time(piece + 1)])?.by_start;
            let entry = |row: &[f64], j: usize| row.iter().zip(&over).map(|(a, b)| a * b[j]).sum();
            to_end = to_end.iter().map(|row| (0..numbers).map(|j| entry(row, j)).collect()).collect();
            let effect = |row: &Vec<f64>| row.iter().zip(&state).map(|(a, x)| (a * x).abs()).sum();
            of_start = to_end.iter().map(effect).collect();
            largest = largest.iter().zip(&of_start).map(|(a, b)| f64::max(*a, *b)).collect();
        }
        let rounded = |effect: Vec<f64>| {
            effect.iter().zip(&self.at.state).map(|(effect, x)| f64::EPSILON * (effect + x.abs())).collect()
        };
        Ok([rounded(of_start), rounded(largest)])
    }

    /// The error of the monodromy matrix relative to its norm: the difference from
    /// another integration, and the error of the start relative to the size of the orbit.
    fn change_of_map(&self, other: &[Vec<f64>], start: &[f64]) -> f64 {
        let map = &self.round.monodromy;
        let apart = self.norm(|i, j| map[i][j] - other[i][j]);
        4.0 * (apart / self.norm(|i, j| map[i][j]) + miss(start, &self.sizes))
    }

    /// The relative change of the monodromy matrix of a motion that passes jumps of forces, by the error of its start: jumps at other times and
    /// other speeds change it more than the error itself.
    fn change_across_jumps(&self, start: &[f64]) -> Result<f64, OrbitError> {
        if !self.rounds.has_jumps() {
            return Ok(0.0);
        }
        let map = &self.round.monodromy;
        let mut change = 0.0;
        for side in [-1.0, 1.0] {
            let state: Vec<f64> =
                self.at.state.iter().zip(start).map(|(x, error)| x + side * error).collect();
            let other = self.rounds.variations(&state, [0.0, self.at.period])?.by_start;
            change += self.norm(|i, j| map[i][j] - other[i][j]) / self.norm(|i, j| map[i][j]);
        }
        Ok(4.0 * change)
    }

    /// The norm of a matrix of derivatives with respect to the start, in units of the sizes of the orbit.
    fn norm(&self, matrix: impl Fn(usize, usize) -> f64) -> f64 {
        norm_of_map(self.sizes.len(), &self.sizes, matrix)
    }

    /// The errors of the start due to a residual; zero for the components that are fixed.
    fn start_errors(&self, residual: &[f64]) -> Vec<f64> {
        let mut errors = vec![0.0; residual.len()];
        let relative = self.step().errors(residual);
        for (index, (&j, size)) in self.unknowns.free.iter().zip(self.units()).enumerate() {
            errors[j] = relative.as_ref().map_or(f64::INFINITY, |deviations| 2.0 * deviations[index] * size);
        }
        errors
    }

    /// The change of the period in the next step, which is not made: for the orbit as it is and as computed with other steps, and by rounding on the
    /// way, which both have. Past a saddle that is most of the error.
    fn period_uncertainty(&self, other: &[f64], rounding: &[f64]) -> f64 {
        if !self.unknowns.period {
            return 0.0;
        }
        let missing = |defect: &[f64]| {
            self.change(defect).and_then(|change| change.last().copied()).map_or(f64::NAN, f64::abs)
        };
        let rounded =
            self.step().errors(rounding).and_then(|error| error.last().copied()).unwrap_or(f64::NAN);
        let spread = missing(&self.round.defect) + missing(other);
        4.0 * (spread + (rounded + f64::EPSILON) * self.at.period)
    }
}

fn miss(defect: &[f64], sizes: &[f64]) -> f64 {
    defect.iter().zip(sizes).map(|(d, size)| (d / size).abs()).fold(0.0, f64::max)
}
