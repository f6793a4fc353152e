//! Passages of the centre and extremes of one stretch, measured repeatedly until centre, shape and noise agree.

use super::centre::Centre;
use super::extreme::extreme;
use super::passage::{CentrePassage, passage};
use super::shape::{LARGEST_AMPLITUDE, Shape};
use super::swings::Stretch;
use super::turning_point::Extreme;
use super::window::Window;
use crate::measurement::{Observable, Trace};
use crate::parallel;
use crate::statistics::{median, robust_deviation};
use libration::internals::progress::Watch;
use libration::pendulum::period_ratio;
use libration::roots::{Tolerance, bisect};
use std::f64::consts::FRAC_PI_2;

/// Rounds of measuring; each reduces the error of the first guess by far more than a factor of ten. With 8 nothing changed in 24
/// recordings (`mod.rs`), with 2 fourteen changed, one by 22 uncertainties of β.
const ROUNDS: usize = 4;

/// Fewest rows of a passage for which another core is used.
const WORTH_A_CORE: usize = 200;

/// Landmarks of one stretch: extreme k lies between the passages k and k + 1.
#[derive(Clone, Debug)]
pub(super) struct Landmarks {
    /// Passages; `None` where too few rows determine one.
    pub(super) passages: Vec<Option<CentrePassage>>,
    pub(super) extremes: Vec<Option<Extreme>>,
    pub(super) centre: Centre,
    /// The standard deviation of a value (or of a value over its given uncertainty).
    pub(super) noise: f64,
}

/// Guesses that a round of measuring improves.
struct Guess {
    passages: Vec<f64>,
    /// Values at the extremes between the passages, and one more at either end.
    extremes: Vec<f64>,
    centre: Centre,
    noise: Option<f64>,
}

/// Finds the landmarks of a stretch, and its noise where that is not given.
pub(super) fn landmarks(
    trace: &Trace,
    stretch: &Stretch,
    noise: Option<f64>,
    watch: &Watch<'_>,
) -> Option<Landmarks> {
    let mut guess = first_guess(trace, stretch)?;
    guess.noise = noise;
    let mut last = None;
    for _ in 0..ROUNDS {
        let measured = guess.measure(trace, watch)?;
        guess.take(&measured);
        guess.noise = noise.or(guess.noise);
        last = Some(measured);
    }
    last
}

/// Guesses the passages of the centre between turning points, and the extremes, from the rows themselves.
fn first_guess(trace: &Trace, stretch: &Stretch) -> Option<Guess> {
    let (times, values, centre) = (trace.times(), trace.values(), stretch.centre);
    let passed = |pair: &[usize]| {
        let changes = (pair[0]..pair[1]).filter(|&row| (values[row] > centre) != (values[row + 1] > centre));
        let middle = changes.map(|row| {
            let part = (centre - values[row]) / (values[row + 1] - values[row]);
            times[row] + part * (times[row + 1] - times[row])
        });
        median(middle.collect())
    };
    let passages = stretch.turns.windows(2).map(passed).collect::<Option<Vec<f64>>>()?;
    let extremes = stretch.turns.iter().map(|&row| values[row] - centre).collect();
    Some(Guess { passages, extremes, centre: Centre::fixed(centre), noise: None })
}

impl Guess {
    fn measure(&self, trace: &Trace, watch: &Watch<'_>) -> Option<Landmarks> {
        let window = Window::new(trace, &self.centre);
        let quarter = 0.5 * median(self.passages.windows(2).map(|pair| pair[1] - pair[0]).collect())?;
        let shape = |size: f64, quarter: f64| match trace.observable() {
            Observable::Angle => Shape::new(Observable::Angle, size),
            observable => Shape::new(observable, amplitude_from_quarter(size, quarter)),
        };
        let passages = self.each(self.passages.len(), trace, watch, |k, watch| {
            watch.go_on().ok()?;
            let size = 0.5 * (self.extremes[k].abs() + self.extremes[k + 1].abs());
            let quarter = self.quarter_about(k, quarter);
            passage(&window, &shape(size, quarter), size, self.passages[k], quarter, self.noise)
        });
        let mut residuals = vec![];
        let passages = apart(passages, &mut residuals);
        let extremes = self.each(self.passages.len().saturating_sub(1), trace, watch, |k, watch| {
            watch.go_on().ok()?;
            let (Some(before), Some(after)) = (passages[k], passages[k + 1]) else { return None };
            extreme(
                &window,
                &shape(self.extremes[k + 1].abs(), 0.5 * (after.time - before.time)),
                [before.time, after.time],
                self.noise,
            )
        });
        let extremes = apart(extremes, &mut residuals);
        let centre = self.centre.renewed(&extremes);
        let largest = self.extremes.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        // Readings without noise have at least the rounding of their shape.
        let noise = robust_deviation(&residuals)?.max(1e-13 * largest);
        Some(Landmarks { passages, extremes, centre, noise })
    }

    /// Measures the landmark at each position; on all cores where there are many rows per landmark.
    fn each<R: Send>(
        &self,
        landmarks: usize,
        trace: &Trace,
        watch: &Watch<'_>,
        measure: impl Fn(usize, &Watch<'_>) -> R + Sync,
    ) -> Vec<R> {
        let indices: Vec<usize> = (0..landmarks).collect();
        match trace.len() / self.passages.len() >= WORTH_A_CORE {
            true => parallel::map(&indices, watch, |&k, watch| measure(k, watch)),
            false => indices.into_iter().map(|k| measure(k, watch)).collect(),
        }
    }

    /// A quarter of the period about a passage.
    fn quarter_about(&self, k: usize, usual: f64) -> f64 {
        let before = k.checked_sub(1).map(|before| self.passages[k] - self.passages[before]);
        let after = self.passages.get(k + 1).map(|after| after - self.passages[k]);
        let neighbours: Vec<f64> = [before, after].into_iter().flatten().collect();
        median(neighbours).map_or(usual, |half| (0.5 * half).clamp(0.5 * usual, 2.0 * usual))
    }

    fn take(&mut self, measured: &Landmarks) {
        for (guess, passage) in self.passages.iter_mut().zip(&measured.passages) {
            *guess = passage.map_or(*guess, |passage| passage.time);
        }
        for (guess, extreme) in self.extremes[1..].iter_mut().zip(&measured.extremes) {
            *guess = extreme.map_or(*guess, |extreme| extreme.value);
        }
        // The extremes at the ends have no passage on one side, and are taken to equal their neighbours of the same side.
        let last = self.extremes.len() - 1;
        if measured.extremes.len() > 1 {
            self.extremes[0] = self.extremes[2];
            self.extremes[last] = self.extremes[last - 2];
        }
        self.centre = measured.centre.clone();
        self.noise = Some(measured.noise);
    }
}

/// Separates the landmarks from their residuals, which are appended to `residuals`.
fn apart<L>(fits: Vec<Option<(L, Vec<f64>)>>, residuals: &mut Vec<f64>) -> Vec<Option<L>> {
    let one = |fit: Option<(L, Vec<f64>)>| {
        fit.map(|(landmark, new)| {
            residuals.extend(new);
            landmark
        })
    };
    fits.into_iter().map(one).collect()
}

/// The amplitude for a largest velocity and a quarter of the period, in radians: v = 2ω0(A) sin(A/2), where ω0 follows
/// from the quarter by the exact law.
fn amplitude_from_quarter(velocity: f64, quarter: f64) -> f64 {
    let [amplitude, _] = bisect([0.0, LARGEST_AMPLITUDE], Tolerance::absolute(1e-6), |amplitude| {
        let omega0 = FRAC_PI_2 * period_ratio(amplitude) / quarter;
        2.0 * omega0 * libm::sin(0.5 * amplitude) < velocity
    });
    amplitude
}
