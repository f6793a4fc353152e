//! Periodic motions in numbers: the equation of motion, integrated by its own Taylor series until it comes back.

mod taylor_step;

use std::f64::consts::TAU;

use super::model::Oscillator;
use taylor_step::{Rates, State, TaylorStep};

/// The motion of an oscillator from one turning point to the other, or once around its limit cycle. It knows of no
/// expansion in the amplitude, so that such expansions can be compared with it.
///
/// # Accuracy
/// The period is right to 1e-13 of itself where the motion does not come near an unstable equilibrium, tested against
/// quadratures of 40 digits; near one, errors grow in proportion to how much longer the period is.
///
/// # Examples
/// ```
/// use libration::oscillator::{NamedOscillator, PeriodicMotion};
/// let duffing = NamedOscillator::by_key("duffing")?.oscillator(&[])?;
/// let motion = PeriodicMotion::from_turning_point(&duffing, 1.0)?;
/// assert!((motion.period() - 4.768022029102461).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # References
/// À. Jorba and M. Zou, Experiment. Math. 14, 99 (2005), for order and length of the steps.
#[derive(Clone, Debug)]
pub struct PeriodicMotion {
    equilibrium: f64,
    steps: Vec<TaylorStep>,
    duration: f64,
    /// Whether the second half of the period is the first one backwards.
    returns: bool,
}

/// Why there is no periodic motion, or why it is not found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoPeriodicMotion {
    /// A displacement or a strength that cannot be.
    #[error("{0:?} is no amplitude: give a finite number above zero")]
    Amplitude(f64),
    /// A limit cycle where there is none, or a family of motions where there is a limit cycle.
    #[error("a limit cycle has no amplitude to choose, and other oscillators have no limit cycle")]
    OtherKind,
    /// A force that does not drive back.
    #[error(
        "at the displacement {0:?} from the equilibrium the force does not drive back: give a smaller one"
    )]
    NotRestoring(f64),
    /// A motion that passes a barrier, or leaves the domain of the force.
    #[error(
        "a release at the displacement {0:?} from the equilibrium does not come to rest on the other side and return: \
         give a smaller one"
    )]
    NoReturn(f64),
    /// A limit cycle that is not reached.
    #[error("no limit cycle is found at the strength {0:?}: give one nearer to zero")]
    NoLimitCycle(f64),
}

impl PeriodicMotion {
    /// The motion released from rest at a displacement above the equilibrium.
    ///
    /// # Errors
    /// A displacement that is not above zero or from which the motion does not return; an oscillator with a limit
    /// cycle.
    pub fn from_turning_point(oscillator: &Oscillator, displacement: f64) -> Result<Self, NoPeriodicMotion> {
        if !(displacement > 0.0 && displacement.is_finite()) {
            return Err(NoPeriodicMotion::Amplitude(displacement));
        }
        let equilibrium = oscillator.equilibrium().to_f64();
        let rates = Rates::new(oscillator, displacement, None).ok_or(NoPeriodicMotion::OtherKind)?;
        let start = State { x: equilibrium + displacement, velocity: 0.0 };
        let first = rates.step_from(start).filter(|step| step.acceleration() < 0.0);
        first.ok_or(NoPeriodicMotion::NotRestoring(displacement))?;
        let half = half_way(&rates, start, -1.0).filter(|half| half.end().x < equilibrium);
        let half = half.ok_or(NoPeriodicMotion::NoReturn(displacement))?;
        let duration = 2.0 * half.duration();
        Ok(Self { equilibrium, steps: half.steps, duration, returns: true })
    }

    /// The limit cycle at a strength of the self-excitation other than zero, searched from an amplitude near it.
    ///
    /// # Errors
    /// A strength of zero or no number, another kind of oscillator, or a limit cycle that is not reached.
    pub fn limit_cycle(oscillator: &Oscillator, strength: f64, near: f64) -> Result<Self, NoPeriodicMotion> {
        if !(strength.is_finite() && strength != 0.0) {
            return Err(NoPeriodicMotion::NoLimitCycle(strength));
        }
        // Backwards in time the strength has the other sign, and the cycle attracts.
        let rates = Rates::new(oscillator, near, Some(strength.abs())).ok_or(NoPeriodicMotion::OtherKind)?;
        let equilibrium = oscillator.equilibrium().to_f64();
        let cycle = closed(&rates, equilibrium, near).ok_or(NoPeriodicMotion::NoLimitCycle(strength))?;
        Ok(Self { equilibrium, duration: cycle.duration(), steps: cycle.steps, returns: false })
    }

    /// The time after which it repeats itself.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.duration
    }

    /// The largest displacement from the equilibrium.
    #[must_use]
    pub fn x_max(&self) -> f64 {
        self.displacement_at(0.0)
    }

    /// The displacement at the other turning point, half a period after the first; `None` for limit cycles.
    #[must_use]
    pub fn x_min(&self) -> Option<f64> {
        self.returns.then(|| self.displacement_at(0.5 * self.duration))
    }

    /// The displacement from the equilibrium at a time from 0 to the period, counted from the largest displacement.
    #[must_use]
    pub fn displacement_at(&self, time: f64) -> f64 {
        let time = if self.returns && time > 0.5 * self.duration { self.duration - time } else { time };
        let place = self.steps.partition_point(|step| step.start <= time).saturating_sub(1);
        self.steps.get(place).map_or(f64::NAN, |step| step.state_at(time - step.start).x - self.equilibrium)
    }

    /// The amplitude of the harmonic k, with the sign that it has as the coefficient of cos kΩt; of a limit cycle as
    /// if the time were counted so that there is no sin Ωt.
    ///
    /// # Accuracy
    /// 1e-13 of the largest displacement, by sums over [`SAMPLES`](Self::SAMPLES) times.
    #[must_use]
    pub fn cosine(&self, k: usize) -> f64 {
        let (cosine, sine) = self.harmonic(k);
        if self.returns {
            return cosine;
        }
        let (first, first_sine) = self.harmonic(1);
        let turn = real(k) * libm::atan2(first_sine, first);
        cosine * libm::cos(turn) + sine * libm::sin(turn)
    }

    /// Times in a period at which harmonics are sampled.
    pub const SAMPLES: usize = 4096;

    /// The coefficients of cos kΩt and sin kΩt.
    fn harmonic(&self, k: usize) -> (f64, f64) {
        let count = real(Self::SAMPLES);
        let weight = if k == 0 { 1.0 / count } else { 2.0 / count };
        let add = |(cosine, sine): (f64, f64), n: usize| {
            let x = self.displacement_at(self.duration * real(n) / count);
            let turn = TAU * real(k * n % Self::SAMPLES) / count;
            (cosine + weight * x * libm::cos(turn), sine + weight * x * libm::sin(turn))
        };
        (0..Self::SAMPLES).fold((0.0, 0.0), add)
    }
}

/// Steps of the integration from rest to rest.
#[derive(Clone, Debug)]
struct Path {
    steps: Vec<TaylorStep>,
}

impl Path {
    fn duration(&self) -> f64 {
        self.steps.last().map_or(0.0, |step| step.start + step.length)
    }

    fn end(&self) -> State {
        let nowhere = State { x: f64::NAN, velocity: f64::NAN };
        self.steps.last().map_or(nowhere, |step| step.state_at(step.length))
    }
}

/// From rest to the next rest, moving in this direction all the time.
fn half_way(rates: &Rates, start: State, direction: f64) -> Option<Path> {
    const MOST_STEPS: usize = 5000;
    let (mut steps, mut state, mut time): (Vec<TaylorStep>, State, f64) = (vec![], start, 0.0);
    for _ in 0..MOST_STEPS {
        let mut step = rates.step_from(state)?;
        step.start = time;
        let end = step.state_at(step.length);
        if !(end.x.is_finite() && end.velocity.is_finite()) {
            return None;
        }
        if end.velocity * direction <= 0.0 {
            step.length = step.time_of_rest(direction);
            steps.push(step);
            return Some(Path { steps });
        }
        time += step.length;
        state = end;
        steps.push(step);
    }
    None
}

/// Once around, from the largest displacement to the largest displacement.
fn once_around(rates: &Rates, x: f64) -> Option<Path> {
    let there = half_way(rates, State { x, velocity: 0.0 }, -1.0)?;
    let turned = State { velocity: 0.0, ..there.end() };
    let back = half_way(rates, turned, 1.0)?;
    let before = there.duration();
    let later = back.steps.into_iter().map(|step| TaylorStep { start: step.start + before, ..step });
    Some(Path { steps: there.steps.into_iter().chain(later).collect() })
}

/// The orbit that closes: rounds are followed until the cycle attracts no more, helped by secants.
fn closed(rates: &Rates, equilibrium: f64, near: f64) -> Option<Path> {
    const MOST_ROUNDS: usize = 200;
    const CLOSED: f64 = 2e-15;
    let (mut x, mut before): (f64, Option<(f64, f64)>) = (equilibrium + near, None);
    let mut best: Option<(f64, Path)> = None;
    for _ in 0..MOST_ROUNDS {
        let path = once_around(rates, x).filter(|path| path.end().x > equilibrium)?;
        let gap = path.end().x - x;
        let better = best.as_ref().is_none_or(|(least, _)| gap.abs() < *least);
        if better {
            best = Some((gap.abs(), path));
        }
        let size = (x - equilibrium).abs();
        if gap.abs() <= CLOSED * size || (!better && gap.abs() <= 1e-12 * size) {
            break;
        }
        let secant = before.map(|(x_before, gap_before)| x - gap * (x - x_before) / (gap - gap_before));
        before = Some((x, gap));
        let trusted = secant.filter(|next| (next - x).abs() < 0.2 * size);
        x = trusted.unwrap_or(x + gap);
    }
    best.filter(|(gap, _)| *gap <= 1e-12 * near.abs().max(1.0)).map(|(_, path)| path)
}

#[expect(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
fn real(count: usize) -> f64 {
    count as f64
}

#[cfg(test)]
mod tests;
