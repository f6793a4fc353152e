//! Periodic responses to a periodic force.

use super::closing::Rounds;
use super::error::{OrbitError, finished};
use super::near::OrbitGuess;
use super::periodic::Orbit;
use super::shooting::{Unknowns, closed};
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;

impl Orbit {
    /// The periodic motion of a system whose force depends on the time t, near a state at t = 0: a fixed point of the map over one period. The
    /// period is that of the force, or a multiple of it for subharmonic responses.
    ///
    /// Newton's method is tried at the start, and again after the motion has been followed for 10, 20, 30, 40, 80, … 640 periods, which
    /// leads to attracting motions.
    ///
    /// # Errors
    /// No time in the equation, an invalid period or start, motions that cannot be integrated,
    /// and [`OrbitError::NoConvergence`]. [`OrbitError::Interrupted`] if the call is cancelled.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::orbit::Orbit;
    /// use libration::progress::Quiet;
    /// // x = cos(2t/3)/(1 − 4/9) is the response of the oscillator without damping.
    /// let orbit = Orbit::driven(&"x'' = -x + cos(2t/3)".parse()?, &[1.0, 0.2], 3.0 * std::f64::consts::PI, &Quiet)?;
    /// assert!((orbit.start()[0] - 1.8).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn driven(
        equation: &Equation,
        start: &[f64],
        period: f64,
        progress: &dyn Progress,
    ) -> Result<Self, OrbitError> {
        let watch = &Watch::new(progress);
        /// Numbers of periods before the further trials. A transient of a quality factor of 14 falls to a tenth in ten periods, after all of
        /// them one of 900; next to a fold a motion stays as long where no orbit is any more. Newton's method does not require its decay.
        const FOLLOWED: [u32; 8] = [10, 10, 10, 10, 40, 80, 160, 320];
        if !equation.depends_on_time() {
            return Err(OrbitError::NotDriven);
        }
        let rounds = Rounds::new(equation, watch)?;
        let unknowns = Unknowns { free: (0..rounds.layout().numbers()).collect(), period: false };
        let mut guess = OrbitGuess { state: start.to_vec(), period };
        let mut outcome = closed(equation, &rounds, &guess, &unknowns);
        for periods in FOLLOWED {
            // A trial that ended at rest may still reach the orbit to which the motion settles.
            if !matches!(outcome, Err(OrbitError::NoConvergence { .. } | OrbitError::NoCycle(_))) {
                break;
            }
            guess.state = later(&rounds, &guess, periods)?;
            outcome = closed(equation, &rounds, &guess, &unknowns);
        }
        finished(outcome, watch)
    }

    /// The driven orbit, by Newton's method alone, which leads to repelling motions too.
    #[doc(hidden)]
    pub fn driven_near(
        equation: &Equation,
        start: &[f64],
        period: f64,
        progress: &dyn Progress,
    ) -> Result<Self, OrbitError> {
        let watch = &Watch::new(progress);
        let rounds = Rounds::new(equation, watch)?;
        let unknowns = Unknowns { free: (0..rounds.layout().numbers()).collect(), period: false };
        let guess = OrbitGuess { state: start.to_vec(), period };
        finished(closed(equation, &rounds, &guess, &unknowns), watch)
    }
}

/// The state after some periods; each begins at t = 0 again, where the force is the same.
fn later(rounds: &Rounds<'_>, guess: &OrbitGuess, periods: u32) -> Result<Vec<f64>, OrbitError> {
    (0..periods).try_fold(guess.state.clone(), |state, _| {
        Ok(rounds.path(&state, guess.period, 1e-12)?.state_at(guess.period))
    })
}
