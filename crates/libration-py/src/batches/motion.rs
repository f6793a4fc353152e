//! Motions: those released from rest, and those that start at an angle with a velocity.

use std::f64::consts::PI;
use std::ops::Range;

use libration::elliptic::LengthMismatch;
use libration::pendulum::{Motion, Pendulum, states};
use libration::quantity::Angle;
use pyo3::prelude::*;

use super::{add, documented};

pub(super) fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    add(module, documented!("state"), |[times, amplitudes, frequencies], [angles, velocities]| {
        for run in runs(times.len(), |i| frequencies[i].to_bits()) {
            let outputs = (&mut angles[run.clone()], &mut velocities[run.clone()]);
            released(&times[run.clone()], &amplitudes[run.clone()], frequencies[run.start], outputs)?;
        }
        Ok(())
    })?;
    add(module, documented!("motion"), |[times, from, with, frequencies], [angles, velocities]| {
        let key = |i: usize| (frequencies[i].to_bits(), Start::new(from[i], with[i]).key());
        for run in runs(times.len(), key) {
            let results = (&mut angles[run.clone()], &mut velocities[run.clone()]);
            let (all, times, frequency) = (&times, &times[run.clone()], frequencies[run.start]);
            match Start::new(from[run.start], with[run.start]) {
                Start::Released => {
                    released(times, &from[run.clone()], frequency, results)?;
                    for i in run {
                        // A prepared motion resolves the phase up to a later time.
                        if angles[i].is_nan() {
                            let outputs = (&mut angles[i..=i], &mut velocities[i..=i]);
                            launched(&all[i..=i], frequency, (from[i], 0.0), outputs)?;
                        }
                    }
                }
                Start::Launched { angle, velocity } => {
                    launched(times, frequency, (angle, velocity), results)?;
                }
            }
        }
        Ok(())
    })
}

/// Kind of the start of a motion. It selects the kernel, so that a single element has the same result as in an array.
enum Start {
    /// A release from rest within a turn.
    Released,
    Launched {
        angle: f64,
        velocity: f64,
    },
}

impl Start {
    fn new(angle: f64, velocity: f64) -> Self {
        let released = velocity.abs() <= 0.0 && angle.abs() <= PI;
        if released { Self::Released } else { Self::Launched { angle, velocity } }
    }

    /// Key of the start; elements with equal keys are computed together.
    fn key(&self) -> Option<[u64; 2]> {
        match self {
            Self::Released => None,
            Self::Launched { angle, velocity } => Some([angle.to_bits(), velocity.to_bits()]),
        }
    }
}

/// Maximal ranges of neighbouring elements with the same key.
fn runs<K: PartialEq>(count: usize, key: impl Fn(usize) -> K) -> impl Iterator<Item = Range<usize>> {
    let mut start = 0;
    std::iter::from_fn(move || {
        let first = (start < count).then(|| key(start))?;
        let end = (start + 1..count).find(|i| key(*i) != first).unwrap_or(count);
        Some(std::mem::replace(&mut start, end)..end)
    })
}

/// Outputs for angles and velocities.
type OutputSlices<'a> = (&'a mut [f64], &'a mut [f64]);

fn released(
    times: &[f64],
    amplitudes: &[f64],
    frequency: f64,
    (angles, velocities): OutputSlices<'_>,
) -> Result<(), LengthMismatch> {
    match Pendulum::from_angular_frequency(frequency) {
        Ok(_) => states(amplitudes, frequency, times, angles, velocities),
        Err(_) => no_motion((angles, velocities)),
    }
}

fn launched(
    times: &[f64],
    frequency: f64,
    start: (f64, f64),
    (angles, velocities): OutputSlices<'_>,
) -> Result<(), LengthMismatch> {
    match motion(frequency, start) {
        Some(motion) => motion.states_at(times, angles, velocities),
        None => no_motion((angles, velocities)),
    }
}

fn motion(frequency: f64, (angle, velocity): (f64, f64)) -> Option<Motion> {
    let pendulum = Pendulum::from_angular_frequency(frequency).ok()?;
    pendulum.launched(Angle::from_radians(angle).ok()?, velocity).ok()
}

fn no_motion((angles, velocities): OutputSlices<'_>) -> Result<(), LengthMismatch> {
    angles.fill(f64::NAN);
    velocities.fill(f64::NAN);
    Ok(())
}
