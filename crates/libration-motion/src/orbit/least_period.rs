//! The least period of an orbit.
//!
//! # Method
//! A motion that approaches its cycle from alternating sides returns closer after two turns than after one, and Newton's method closes whatever
//! multiple of the period it is given: the multipliers are then powers of the true ones, and the sign that announces a period doubling is lost.
//! An orbit that agrees with itself, shifted by a prime part of its period, over its whole length and within its errors, is closed again over that
//! part. Agreement at one time would not suffice: a motion past a saddle is twice near it.

use super::error::OrbitError;
use super::periodic::Orbit;
use libration_kernels::elementary::count;

/// The parts that are tried: the primes up to the largest number of maxima between which a cycle is searched.
const PARTS: [u32; 4] = [2, 3, 5, 7];
/// Number of times in each part at which the orbit is compared; a doubled cycle differs from itself in all its maxima.
const TIMES: usize = 32;

/// The orbit over its least period, from the orbit and from a function that closes it over a shorter period.
pub(super) fn over_least_period(
    mut orbit: Orbit,
    closed: impl Fn(Vec<f64>, f64) -> Result<Orbit, OrbitError>,
) -> Result<Orbit, OrbitError> {
    for parts in PARTS {
        while orbit.repeats_after(parts) {
            match closed(orbit.start(), orbit.period() / f64::from(parts)) {
                Ok(shorter) => orbit = shorter,
                Err(error @ OrbitError::Interrupted(_)) => return Err(error),
                Err(_) => break,
            }
        }
    }
    Ok(orbit)
}

impl Orbit {
    /// Returns `true` if the orbit agrees with itself, shifted by its period divided by this number, over its whole length and within twice its
    /// errors. A driven orbit then repeats after that part of its period if the drive does.
    #[must_use]
    pub fn repeats_after(&self, parts: u32) -> bool {
        let part = self.period() / f64::from(parts);
        let times = TIMES * parts as usize;
        (0..times).all(|number| {
            let time = self.period() * count(number) / count(times);
            let [here, there] = [time, time + part].map(|time| self.state_at(time));
            let mut pairs = here.iter().zip(&there).zip(self.state_errors());
            pairs.all(|((here, there), error)| (here - there).abs() <= 2.0 * error)
        })
    }
}
