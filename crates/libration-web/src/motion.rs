//! The motion shown by the page, and approximate ones next to it.

use crate::exchange::exchange;
use libration::pendulum::{ApproximateMotion, Motion, Pendulum, PendulumError, Regime};
use libration::quantity::Angle;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Motion that is shown.
struct Shown {
    pendulum: Pendulum,
    motion: Motion,
    /// The amplitude for approximate motions, or the reason why there is none.
    amplitude: Result<f64, String>,
}

static SHOWN: Mutex<Option<Shown>> = Mutex::new(None);

fn shown() -> MutexGuard<'static, Option<Shown>> {
    SHOWN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Leaves numbers of the motion that is shown.
fn answer(of: impl FnOnce(&Shown) -> Result<Vec<f64>, String>) -> bool {
    let answer = shown().as_ref().ok_or("no motion is shown".to_owned()).and_then(of);
    exchange().answer(answer)
}

/// Takes the motion of a pendulum of this length in m, under this gravity in m/s², that passes the angle of the text with this velocity in rad/s at t
/// = 0. Of the motion: regime (0 rest, 1 upright rest, 2 libration, 3 separatrix, 4 rotation), period and small-angle period in s, amplitude and its
/// complement in rad, energy over 2mgl, the same less 1, energy over ml² in rad²/s², angular frequency of small swings in rad/s. Where there is none,
/// the text is the quantity that is wrong (angle, length, gravity, velocity) and, on the lines after it, the reason.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn launch(length: f64, gravity: f64, velocity: f64) -> bool {
    let text = exchange().take_text();
    let text = text.map_err(|reason| ("angle", reason));
    let launched = text.and_then(|text| launched(&text, length, gravity, velocity));
    let launched = launched.map_err(|(quantity, reason)| format!("{quantity}\n{reason}"));
    exchange().answer(launched.map(|launched| {
        let facts = launched.facts();
        *shown() = Some(launched);
        facts
    }))
}

/// The motion, or the reason why one of its quantities is wrong.
fn launched(angle: &str, length: f64, gravity: f64, velocity: f64) -> Result<Shown, (&'static str, String)> {
    let angle: Angle = angle.parse().map_err(|error| ("angle", reason(error)))?;
    let pendulum = Pendulum::new(length, gravity).map_err(|error| (quantity(&error), reason(error)))?;
    let motion = pendulum.launched(angle, velocity).map_err(|error| ("velocity", reason(error)))?;
    Ok(Shown {
        pendulum,
        motion,
        amplitude: ApproximateMotion::amplitude_of(&angle, velocity).map_err(reason),
    })
}

impl Shown {
    fn facts(&self) -> Vec<f64> {
        let amplitude = self.motion.amplitude();
        vec![
            f64::from(regime(self.motion.regime())),
            self.motion.period(),
            self.pendulum.small_angle_period(),
            amplitude.map_or(f64::NAN, |amplitude| amplitude.radians()),
            amplitude.map_or(f64::NAN, |amplitude| amplitude.complement()),
            self.motion.energy_ratio(),
            self.motion.energy_excess(),
            self.motion.specific_energy(),
            self.pendulum.angular_frequency(),
        ]
    }
}

/// The quantity that an error of a pendulum is about.
fn quantity(error: &PendulumError) -> &'static str {
    match error {
        PendulumError::NotPositive { name: "gravity", .. } => "gravity",
        _ => "length",
    }
}

fn reason(error: impl std::fmt::Display) -> String {
    error.to_string()
}

fn regime(regime: Regime) -> u8 {
    match regime {
        Regime::RestUpright => 1,
        Regime::Libration => 2,
        Regime::Separatrix => 3,
        Regime::Rotation => 4,
        _ => 0,
    }
}

/// The state at a time in s: turns, angle in the turn in rad, complement, unwrapped angle, velocity in rad/s.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn state(time: f64) -> bool {
    answer(|shown| {
        let state = shown.motion.state_at(time);
        #[expect(clippy::cast_precision_loss, reason = "a page shows turns up to 2⁵³")]
        let turns = state.turns as f64;
        Ok(vec![turns, state.angle_in_turn, state.complement, state.angle, state.velocity])
    })
}

/// A number of times, `step` apart.
fn times(first: f64, step: f64, count: u32) -> Vec<f64> {
    /// More than any picture has points.
    const MOST: u32 = 1 << 20;
    (0..count.min(MOST)).map(|n| first + f64::from(n) * step).collect()
}

/// The unwrapped angles, then the velocities, at `count` times, `step` apart.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn states(first: f64, step: f64, count: u32) -> bool {
    let times = times(first, step, count);
    answer(|shown| {
        let mut all = vec![0.0; 2 * times.len()];
        let (angles, velocities) = all.split_at_mut(times.len());
        shown.motion.states_at(&times, angles, velocities).map_err(reason)?;
        Ok(all)
    })
}

/// The angles of an approximate motion, by its index in the catalogue, at `count` times, `step` apart; only after a release at rest.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn approximation(index: usize, first: f64, step: f64, count: u32) -> bool {
    answer(|shown| {
        let approximate = ApproximateMotion::CATALOGUE.get(index).ok_or("no such approximate motion")?;
        let amplitude = shown.amplitude.clone()?;
        let frequency = shown.pendulum.angular_frequency();
        Ok(times(first, step, count)
            .iter()
            .map(|time| approximate.angle(amplitude, frequency * time))
            .collect())
    })
}

/// The harmonics that are not below a tolerance in rad, at most `limit` of them: fundamental angular frequency, mean velocity, epoch, then for each
/// its order and the coefficients of the angle and of the velocity.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn harmonics(tolerance: f64, limit: usize) -> bool {
    answer(|shown| {
        let series = shown.motion.harmonics(tolerance, limit);
        let mut numbers = vec![series.fundamental, series.mean_velocity, series.epoch];
        #[expect(clippy::cast_precision_loss, reason = "few harmonics")]
        numbers.extend(series.terms.iter().flat_map(|term| [term.n as f64, term.angle, term.velocity]));
        Ok(numbers)
    })
}
