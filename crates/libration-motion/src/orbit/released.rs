//! One coordinate released from rest, until its return.
//!
//! The motion is first followed in double precision. If that does not suffice, because of a nearby separatrix or a cancelling force, it is
//! followed again with increasing numbers of bits until two precisions agree.
//!
//! # Method
//! The motion is followed from rest to rest and back to rest. If it does not return to its start, it has no period. The uncertainty in double
//! precision is the change with other steps, plus the effect of rounding on the energy, which is measured against 128 bits along the orbit. If
//! it exceeds a few digits (2⁻⁴⁵ of the period), and whenever a conservative motion does not return, a motion without kinks is followed in
//! floats of 128, 192 and 256 bits until two agree (`precise.rs`). A motion that comes within 2^(−3p/8) of an equilibrium is undecided in p
//! bits, and on the separatrix if it is undecided in all of them. Release positions are therefore exact (`Displacement`, `place.rs`).
//!
//! An orbit is accepted if it misses its start by at most 32 times the change with another
//! tolerance plus the rounding of its start; a release with a damping of 1e-10 is rejected.

use super::acceleration::{Acceleration, Roundings};
use super::error::{Lost, OrbitError, finished};
use super::path::{FAR, Path, sign_change, until};
use super::periodic::{Orbit, OrbitErrors};
use super::precise::{HalfPeriod, HalfPeriodError, Motion};
use super::release_place::ReleasePlace;
use crate::taylor::{Cause, Effort, IntegrationError, Moment, Step, System};
use libration_numbers::algebra::BigFloat;
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;

/// Maximum number of steps of half an oscillation; only motions without end take more.
pub(super) const MOST_STEPS: usize = 20_000;
/// Relative error above which a period is not accepted: four digits are the minimum for a comparison.
const UNCERTAIN: f64 = 1e-4;
/// Largest relative error of a period in double precision, 2⁻⁴⁵ or 128 roundings; above it the period is computed with more bits.
const TRUSTED: f64 = 2.9e-14;
/// Closing error, relative to the swing, above which an oscillation does not end where it began: next to an unstable equilibrium a rounding
/// error of the energy moves a turning point by its square root, 1e-8; the limit is a hundred times that.
const NEARLY_CLOSED: f64 = 1e-6;
/// Largest closing error of a motion whose force takes or gives energy, in units of its integration error.
const CLOSED: f64 = 32.0;
/// Precisions in bits for motions that double precision cannot resolve; 256 bits suffice for a distance of 1e-28 from a separatrix.
const PRECISIONS: [usize; 3] = [128, 192, 256];
/// Relative difference up to which two precisions agree in a period; if they differ by more, the lower one has lost the motion.
const AGREED: f64 = 1e-3;
/// Error of the higher precision relative to the difference of two that agree: as the error is proportional to the last bit, the higher
/// precision is better by 2⁶⁴; half of these bits are a margin for chance.
const IMPROVED: f64 = 1.0 / 4_294_967_296.0;

impl Orbit {
    /// The motion of one coordinate released from rest at a position, to the other turning point and back. It is periodic if the energy is
    /// conserved, or if the force is the same for the opposite velocity.
    ///
    /// # Accuracy
    /// As stated by [`period_uncertainty`](Self::period_uncertainty): a few units in the last place of the period, for exactly this `f64` as the
    /// position. For a force without a derivative, such as |x| at zero, it includes the growth of rounding errors near an unstable equilibrium.
    ///
    /// # Errors
    /// Several coordinates or the time in the equation, a release at an equilibrium or on a separatrix, and
    /// motions that do not return to their start. [`OrbitError::Interrupted`] if the call is cancelled.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::orbit::Orbit;
    /// use libration::progress::Quiet;
    /// let orbit = Orbit::released(&"x'' = -x^3".parse()?, 2.0, &Quiet)?;
    /// // The period is Γ(1/4)²/√π divided by the amplitude.
    /// assert!((orbit.period() - 7.416298709205487 / 2.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn released(equation: &Equation, position: f64, progress: &dyn Progress) -> Result<Self, OrbitError> {
        let refusal = || OrbitError::Start { state: vec![position], wanted: 1 };
        Release::check(equation)?;
        Self::released_from(equation, &ReleasePlace::from_f64(position).ok_or_else(refusal)?, 0.0, progress)
    }

    /// The orbit released from a position that is known to more digits than an `f64` has. Double precision suffices where it gives the period
    /// to a relative tolerance, or to 2⁻⁴⁵ if that is more.
    pub fn released_from(
        equation: &Equation,
        position: &ReleasePlace,
        tolerance: f64,
        progress: &dyn Progress,
    ) -> Result<Self, OrbitError> {
        let watch = &Watch::new(progress);
        Release::check(equation)?;
        finished(Release::new(equation, position, watch)?.orbit(tolerance.max(TRUSTED)), watch)
    }
}

/// A release from rest.
struct Release<'a> {
    equation: &'a Equation,
    system: System,
    acceleration: Acceleration,
    position: &'a ReleasePlace,
    start: f64,
    watch: &'a Watch<'a>,
}

/// An oscillation, and the time of its first half.
struct Around {
    full: Path,
    half: f64,
}

impl<'a> Release<'a> {
    fn check(equation: &Equation) -> Result<(), OrbitError> {
        let [_] = equation.variables() else {
            return Err(OrbitError::SeveralCoordinates(equation.variables().len()));
        };
        equation.refuse_first_order()?;
        if equation.depends_on_time() { Err(OrbitError::DependsOnTime) } else { Ok(()) }
    }

    fn new(
        equation: &'a Equation,
        position: &'a ReleasePlace,
        watch: &'a Watch<'a>,
    ) -> Result<Self, OrbitError> {
        let (system, acceleration) = (System::new(equation)?, Acceleration::new(equation)?);
        Ok(Self { equation, system, acceleration, position, start: position.to_f64(), watch })
    }

    fn orbit(&self, tolerance: f64) -> Result<Orbit, OrbitError> {
        if self.is_too_small() {
            return Err(OrbitError::TooSmall(self.start));
        }
        // Below rounding: the error of the period is then that of the sums of its steps.
        let outcome = self.once_around(self.start, 1e-17).and_then(|around| self.judged(around));
        let doubtful = match &outcome {
            Ok(orbit) => orbit.period_uncertainty() > tolerance * orbit.period(),
            // Next to a separatrix rounding may lead elsewhere; if energy is lost or gained, higher precision cannot help.
            Err(_) => self.acceleration.is_free_of_velocity,
        };
        let checked = outcome.and_then(|orbit| self.sure(orbit));
        if doubtful && self.acceleration.is_smooth() { self.precisely(checked) } else { checked }
    }

    /// Returns `true` if squares of the displacement and of the velocity are so small that they are rounded to fewer digits, or to zero.
    fn is_too_small(&self) -> bool {
        const LEAST: f64 = f64::MIN_POSITIVE / f64::EPSILON;
        let force = self.acceleration.at(&[self.start, 0.0]).abs();
        force > 0.0 && libm::fmax(force * self.start.abs(), force * force) < LEAST
    }

    /// The orbit with its uncertainty, from other steps and from the rounding of the acceleration. Rounding changes the energy, as a change of
    /// the amplitude does, by the errors of the acceleration times the way on which they occur, and the period by the relative error.
    fn judged(&self, around: Around) -> Result<Orbit, OrbitError> {
        let period = around.full.end_time();
        // Steps of other orders and lengths have other rounding errors.
        let again = self.once_around(self.start, 1e-16)?;
        let other_half = if self.acceleration.is_free_of_velocity { 2.0 * around.half } else { period };
        let spread = (period - again.full.end_time()).abs().max((period - other_half).abs());
        let Roundings { relative, energy } = self.acceleration.roundings(&around.full);
        let other_side = around.full.state_at(around.half)[0];
        let swing = (self.start - other_side).abs();
        let rounding_of_position = f64::EPSILON * self.start.abs().max(other_side.abs()) / swing;
        let rounding = relative.max(rounding_of_position).max(f64::EPSILON);
        let first = self.acceleration.at(&[self.start, 0.0]).abs();
        let moved = energy / first / swing;
        let condition = self.condition(&around.full, swing.copysign(other_side - self.start), first);
        let uncertainty = 16.0 * spread + 4.0 * (2.0 * rounding + condition * moved) * period;
        let [end, other_end] = [&around, &again].map(|turn| turn.full.state_at(turn.full.end_time())[0]);
        let flow = (end - other_end).abs() + f64::EPSILON * self.start.abs().max(other_side.abs());
        if !self.acceleration.is_reversible && (end - self.start).abs() > CLOSED * flow {
            return Err(OrbitError::NotClosed { start: self.start, end });
        }
        let apart: Vec<f64> = around.full.apart(&again.full).iter().map(|distance| 16.0 * distance).collect();
        let errors = OrbitErrors::new(&around.full, vec![0.0; 2], &[0.0; 2], &apart, uncertainty);
        Ok(Orbit::new(self.equation, around.full, uncertainty, None, errors))
    }

    /// The relative change of the period per change of the amplitude relative to the swing, estimated from a neighbouring motion: infinite if
    /// the neighbour is a motion of another kind. Next to a kink no better estimate is available, and both sides are used.
    fn condition(&self, path: &Path, swing: f64, first: f64) -> f64 {
        // Small compared with any distance from a separatrix at which double precision is used, large compared with its errors.
        const PART: f64 = 1e-8;
        // The largest kinetic energy is an eighth of acceleration and swing if the acceleration doubles from the middle to the end; on a potential
        // wall a small part of the swing changes the energy by all of it.
        const STEEP: f64 = 8.0;
        // A neighbour whose period differs by one per cent at that distance is a motion of another kind.
        const OTHER: f64 = 1e-2;
        let sides: &[f64] = if self.acceleration.is_smooth() { &[1.0] } else { &[1.0, -1.0] };
        let period = path.end_time();
        let kinetic = path.states().map(|state| 0.5 * state[1] * state[1]).fold(0.0, f64::max);
        let part = PART * libm::fmin(1.0, STEEP * kinetic / first / swing.abs());
        let change = |side: &f64| {
            // The difference of two periods, which may agree in most digits.
            let neighbour = self.once_around(self.start + side * part * swing, 1e-16);
            neighbour.map_or(f64::INFINITY, |around| (1.0 - around.full.end_time() / period).abs())
        };
        let largest = sides.iter().map(change).fold(0.0, f64::max);
        if largest < OTHER { largest / part } else { f64::INFINITY }
    }

    fn sure(&self, orbit: Orbit) -> Result<Orbit, OrbitError> {
        let (period, uncertainty) = (orbit.period(), orbit.period_uncertainty());
        if uncertainty <= UNCERTAIN * period {
            return Ok(orbit);
        }
        Err(OrbitError::Unsure { start: self.start, period, uncertainty })
    }

    /// The orbit with the required precision, or the result in double precision if higher precision is not possible.
    fn precisely(&self, rough: Result<Orbit, OrbitError>) -> Result<Orbit, OrbitError> {
        let mut before: Option<BigFloat> = None;
        for precision in PRECISIONS {
            let halves = match self.precise_halves(precision) {
                Ok(halves) => halves,
                Err(HalfPeriodError::Undecided) => {
                    before = None;
                    continue;
                }
                Err(HalfPeriodError::Unable) => return rough,
                Err(HalfPeriodError::Lost(time)) => {
                    let lost = OrbitError::NoReturn { start: self.start, why: Lost::OneWay(time) };
                    return Err(rough
                        .err()
                        .filter(|error| !matches!(error, OrbitError::Unsure { .. }))
                        .unwrap_or(lost));
                }
            };
            let period = halves.period();
            let spread = before.map(|before| (before - period.clone()).to_f64().abs());
            if let Some(spread) = spread.filter(|spread| *spread <= AGREED * period.to_f64()) {
                let uncertainty = IMPROVED * spread + f64::EPSILON * period.to_f64();
                return halves.closed(self.position.to_f64(), self.equation, uncertainty);
            }
            before = Some(period);
        }
        Err(OrbitError::Separatrix(self.start))
    }

    fn precise_halves(&self, precision: usize) -> Result<Halves, HalfPeriodError> {
        let motion = Motion::new(&self.system, &self.acceleration.tape, precision, self.watch);
        let there = motion.half_period(&self.position.to_bits(precision), 0.0)?;
        let back = match self.acceleration.is_free_of_velocity {
            true => None,
            false => Some(motion.half_period(&there.end, there.duration.to_f64())?),
        };
        Ok(Halves { there, back })
    }

    fn once_around(&self, position: f64, tolerance: f64) -> Result<Around, OrbitError> {
        let start = Moment { time: 0.0, state: vec![position, 0.0] };
        let effort = Effort { most_steps: MOST_STEPS, ..Effort::to_tolerance(tolerance) };
        let there = self.to_rest(&start, position, &effort)?;
        let half = there.end_time();
        let other_side = Moment { time: half, state: vec![there.state_at(half)[0], 0.0] };
        let full = there.followed_by(self.to_rest(&other_side, position, &effort)?);
        let end = full.state_at(full.end_time())[0];
        let (swing, back) = ((position - other_side.state[0]).abs(), (end - other_side.state[0]).abs());
        if back < NEARLY_CLOSED * swing {
            return Err(OrbitError::NoReturn { start: position, why: Lost::Rest });
        }
        if (end - position).abs() > NEARLY_CLOSED * swing {
            return Err(match self.acceleration.is_free_of_velocity {
                true => OrbitError::Separatrix(position),
                false => OrbitError::NotClosed { start: position, end },
            });
        }
        Ok(Around { full, half })
    }

    /// Integrates the motion from rest to the next rest.
    fn to_rest(&self, start: &Moment, position: f64, effort: &Effort) -> Result<Path, OrbitError> {
        let first = self.acceleration.at(&start.state).abs();
        if first == 0.0 {
            return Err(OrbitError::AtRest(vec![start.state[0]]));
        }
        if !first.is_finite() {
            return Err(match self.acceleration.is_too_large(&start.state) {
                true => OrbitError::TooLarge(position),
                false => OrbitError::NoValue(position),
            });
        }
        let happens = |step: &Step<'_>| sign_change(step, 1);
        // Roots are taken before the quotient, which may underflow.
        let size = libm::fmax(start.state[0].abs(), f64::MIN_POSITIVE);
        let horizon = Self::HORIZON * libm::sqrt(size) / libm::sqrt(first);
        let outcome = until(&self.system, start, [horizon, FAR], effort, self.watch, happens);
        let lost = |why| OrbitError::NoReturn { start: position, why };
        match outcome {
            Ok(Some(path)) => Ok(path),
            Ok(None) => Err(lost(Lost::OneWay(FAR))),
            Err(error) => Err(lost(why_lost(error))),
        }
    }

    /// First time limit, in units of about the time in which the first acceleration leads to zero:
    /// a harmonic oscillator comes to rest after π units, and most motions within this limit.
    const HORIZON: f64 = 8.0;
}

/// The way to rest, and the way back if it is different.
struct Halves {
    there: HalfPeriod,
    back: Option<HalfPeriod>,
}

impl Halves {
    fn period(&self) -> BigFloat {
        let back = self.back.as_ref().unwrap_or(&self.there);
        self.there.duration.clone() + back.duration.clone()
    }

    /// The orbit, if the motion ends at its start.
    fn closed(self, start: f64, equation: &Equation, uncertainty: f64) -> Result<Orbit, OrbitError> {
        let (period, other_side) = (self.period().to_f64(), self.there.end.to_f64());
        let Some(back) = self.back else {
            let path = Path::there_and_back(self.there.steps, period);
            return Ok(Self::orbit(equation, path, uncertainty));
        };
        let end = back.end.to_f64();
        if (end - start).abs() > CLOSED * f64::EPSILON * start.abs().max(other_side.abs()) {
            return Err(OrbitError::NotClosed { start, end });
        }
        let path = Path::of_steps([self.there.steps, back.steps].concat(), period);
        Ok(Self::orbit(equation, path, uncertainty))
    }
}

impl Halves {
    /// The orbit from steps that were rounded from many bits.
    fn orbit(equation: &Equation, path: Path, uncertainty: f64) -> Orbit {
        let errors = OrbitErrors::new(&path, vec![0.0; 2], &[0.0; 2], &[0.0; 2], uncertainty);
        Orbit::new(equation, path, uncertainty, None, errors)
    }
}

pub(super) fn why_lost(error: IntegrationError) -> Lost {
    match error {
        IntegrationError::Stopped { cause: Cause::StepLimit, solution } => Lost::OneWay(solution.end.time),
        other => Lost::Stopped(other),
    }
}
