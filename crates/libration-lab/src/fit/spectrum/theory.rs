//! The harmonics of a pendulum whose first harmonic is known.

use std::f64::consts::PI;

use crate::measurement::Observable;
use crate::statistics::count;
use libration::pendulum::Pendulum;
use libration::quantity::Angle;
use libration::roots::{Tolerance, bisect};

/// Relative change of the first harmonic in the difference quotients of slopes, whose errors are of the order of its square, 1e-6 of them.
const STEP: f64 = 1e-3;
/// The largest amplitude in the search, in rad: its first harmonic is 3.82, and a period fourteen times as long.
const HIGHEST: f64 = PI - 1e-8;

/// The undamped swing that has a given first harmonic of the measured quantity.
#[derive(Clone, Debug)]
pub struct Theory {
    /// The amplitude of the angle, in rad.
    pub amplitude: f64,
    /// Derivative of the amplitude with respect to the measured first harmonic.
    pub amplitude_slope: f64,
    /// Coefficients of cos nφ, where φ = 0 is a maximum of the first harmonic; from n = 0, in the unit of the first.
    pub coefficients: Vec<f64>,
    /// Derivatives of the coefficients with respect to the first.
    pub slopes: Vec<f64>,
    /// Growth of each harmonic with the first.
    growths: Vec<Growth>,
}

/// The logarithm of a harmonic as a parabola in that of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Growth {
    /// The power of the first with which it grows.
    pub power: f64,
    bend: f64,
}

impl Growth {
    /// Returns the growth of a harmonic of a bent scale of the angle in small swings.
    pub fn by_number(n: usize) -> Self {
        Self { power: count(n), bend: 0.0 }
    }

    /// Fits the growth to three values, for the first harmonic smaller and larger by [`STEP`]; from its order if theory has no such harmonic, or
    /// nearly none.
    fn through(n: usize, [below, here, above]: [f64; 3]) -> Self {
        let [less, more] = [-STEP, STEP].map(libm::log1p);
        let [low, high] = [libm::log(below / here) / less, libm::log(above / here) / more];
        let bend = 2.0 * (high - low) / (more - less);
        let growth = Self { power: high - 0.5 * bend * more, bend };
        if growth.power.is_finite() && bend.is_finite() { growth } else { Self::by_number(n) }
    }

    /// Relative size of the harmonic for this relative size of the first.
    pub fn size(self, first: f64) -> f64 {
        let logarithm = libm::log(first.max(f64::MIN_POSITIVE));
        libm::exp((self.power + 0.5 * self.bend * logarithm) * logarithm)
    }
}

impl Theory {
    /// Computes the swing with a first harmonic of the angle (rad) or of the velocity (rad/s) at this frequency (rad/s); `None` where no swing is
    /// so large.
    pub fn new(first: f64, frequency: f64, observable: Observable, highest: usize) -> Option<Self> {
        let at = |first: f64| swing(first, frequency, observable, highest);
        let (amplitude, coefficients) = at(first)?;
        let [(low, below), (high, above)] = [at(first * (1.0 - STEP))?, at(first * (1.0 + STEP))?];
        let slope = |low: f64, high: f64| (high - low) / (2.0 * STEP * first);
        let values = below.iter().zip(&coefficients).zip(&above);
        let growths =
            values.enumerate().map(|(n, ((low, here), high))| Growth::through(n, [*low, *here, *high]));
        let growths = growths.collect();
        let slopes = below.iter().zip(&above).map(|(low, high)| slope(*low, *high)).collect();
        Some(Self { amplitude, amplitude_slope: slope(low, high), coefficients, slopes, growths })
    }

    /// Growth of a harmonic with the first.
    pub fn growth(&self, n: usize) -> Growth {
        self.growths[n]
    }
}

/// The amplitude of the swing, and its coefficients from n = 0.
fn swing(first: f64, frequency: f64, observable: Observable, highest: usize) -> Option<(f64, Vec<f64>)> {
    let scale = if observable == Observable::Angle { 1.0 } else { frequency };
    let amplitude = amplitude(first / scale)?;
    let mut coefficients = vec![0.0; highest + 1];
    for term in terms(amplitude, highest).into_iter().filter(|term| term.0 <= highest) {
        let (n, angle) = term;
        coefficients[n] = match observable {
            Observable::Angle => angle,
            // −Σ nΩ aₙ sin nφ, which by a phase that is zero at its own maximum has cosines, all of one sign.
            Observable::AngularVelocity => count(n) * scale * angle.abs(),
        };
    }
    Some((amplitude, coefficients))
}

/// The amplitude with this first harmonic of the angle, both in rad: less than it by a fifth at most, as 4 at the top is more than π.
fn amplitude(first: f64) -> Option<f64> {
    let of = |amplitude: f64| terms(amplitude, 1).first().map_or(0.0, |term| term.1);
    let bracket = [0.78 * first, first.min(HIGHEST)];
    if !(first > 0.0 && of(bracket[1]) >= first) {
        return None;
    }
    // Some rounding errors.
    let [inside, _] = bisect(bracket, Tolerance::relative(1e-14), |amplitude| of(amplitude) < first);
    Some(inside)
}

/// Orders and coefficients of the angle's harmonics.
fn terms(amplitude: f64, highest: usize) -> Vec<(usize, f64)> {
    let pendulum = Pendulum::from_angular_frequency(1.0).expect("one is an angular frequency");
    let motion = Angle::from_radians(amplitude).ok().and_then(|angle| pendulum.released_from(angle).ok());
    let series = motion.map(|motion| motion.harmonics(0.0, highest.div_ceil(2)));
    series.map_or(vec![], |series| series.terms.iter().map(|term| (term.n, term.angle)).collect())
}
