//! The least period of an orbit.
//!
//! # Method
//! A motion that approaches its cycle from alternating sides returns closer after two turns than after one, and Newton's method closes whatever
//! multiple of the period it is given: the multipliers are then powers of the true ones, and the sign that announces a period doubling is lost.
//! An orbit that agrees with itself, shifted by a part of its period, over its whole length and within its errors, is closed again over that part.
//! Agreement at one time would not suffice: a motion past a saddle is twice near it.

use super::error::OrbitError;
use super::periodic::Orbit;
use libration_kernels::elementary::count;

/// Number of times in each part at which the orbit is compared. Where the flow keeps distances one would do; the others are on the way on which it
/// does not.
const TIMES: usize = 32;

/// The orbit over its least period, from the orbit and from a function that closes it over a shorter period.
#[doc(hidden)]
pub fn over_least_period(
    mut orbit: Orbit,
    closed: impl Fn(Vec<f64>, f64) -> Result<Orbit, OrbitError>,
) -> Result<Orbit, OrbitError> {
    // A step is shorter than a turn: it has at most five radians of the fastest oscillation.
    for parts in 2..=u32::try_from(orbit.steps()).unwrap_or(u32::MAX) {
        while orbit.repeats_after(parts) {
            match closed(orbit.start(), orbit.period() / f64::from(parts)) {
                Ok(shorter) if is_part(&shorter, &orbit, parts) => orbit = shorter,
                Err(error @ OrbitError::Interrupted(_)) => return Err(error),
                _ => break,
            }
        }
    }
    Ok(orbit)
}

/// Returns `true` if the period of an orbit is this part of that of another within their errors: where errors are large, Newton's method may
/// lead elsewhere, and back to the whole period.
fn is_part(shorter: &Orbit, orbit: &Orbit, parts: u32) -> bool {
    let parts = f64::from(parts);
    let off = (parts * shorter.period() - orbit.period()).abs();
    off <= parts * shorter.period_uncertainty() + orbit.period_uncertainty()
}

impl Orbit {
    /// Returns `true` if the orbit agrees with itself, shifted by its period divided by this number, over its whole length and within twice its
    /// errors. A driven orbit then repeats after that part of its period if the drive does.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::orbit::Orbit;
    /// use libration::progress::Quiet;
    /// // A sine is opposite to itself after half a period, and itself again after a third of three periods.
    /// let equation = "x'' = -x + cos(2t)".parse()?;
    /// let response = |periods: f64| Orbit::driven(&equation, &[-1.0/3.0, 0.0], periods * std::f64::consts::PI, &Quiet);
    /// assert!(!response(1.0)?.repeats_after(2) && response(3.0)?.repeats_after(3));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
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
