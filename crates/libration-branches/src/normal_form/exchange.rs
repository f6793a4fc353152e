//! Exchange of energy between modes in resonance: from the slow flow, in closed form for two modes at 2:1, and measured on the full motion.

use super::form::NormalForm;
use libration_kernels::elementary::count;
use libration_kernels::elliptic::Modulus;
use libration_motion::taylor::{Effort, IntegrationError, Moment, System, integrate};
use libration_numbers::algebra::Complex;
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;
use libration_numbers::roots::polynomial_roots;
use std::f64::consts::TAU;

/// The exchange of energy between modes that begins at a state.
#[derive(Clone, Debug, PartialEq)]
pub struct Exchange {
    /// Period in seconds after which the amplitudes have returned.
    pub period: f64,
    /// The error of the period within the slow flow, estimated by leaving out a tenth of the time.
    pub error: f64,
    /// The least and the greatest |aⱼ| of each mode during the exchange.
    pub amplitudes: Vec<[f64; 2]>,
    /// The period in closed form from second-order terms alone, for two modes at 2:1 without detuning.
    pub closed_form: Option<f64>,
}

/// The exchange of energy in the full motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredExchange {
    /// 2π over the mean frequency with which the amplitudes circulate.
    pub period: f64,
    /// The error of the period, estimated by leaving out a tenth of the time.
    pub error: f64,
}

/// Reason why there is no exchange of energy.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExchangeError {
    /// No resonant term to this order.
    #[error("no two modes are in resonance to this order: each keeps its amplitude")]
    NoResonance,
    /// A state too far from equilibrium.
    #[error("the state is too far from equilibrium for a normal form of this order: give a smaller one")]
    TooFar,
    /// Amplitudes that are constant.
    #[error(
        "to this order the amplitudes from this state are constant, although two modes are in resonance: a higher order may show an exchange"
    )]
    Steady,
    /// Amplitudes that do not return in time.
    #[error(
        "the amplitudes do not return within {0} s: the exchange is slower, or there is none from this state"
    )]
    TooSlow(f64),
    /// A failed integration.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
}

/// Number of exchanges over which frequencies are averaged, with an error of 1e-12 (1e-11 for 48), and
/// samples in each: with half as many samples, harmonics of the modes would appear as slow changes.
const EXCHANGES: usize = 96;
const SAMPLES: usize = 96;
/// Relative error of a mean frequency from the integration tolerance.
const ROUNDING: f64 = 1e-12;
/// Longest wait for an exchange, in periods of the slowest mode.
const LONGEST: usize = 2000;
/// Relative change of squared amplitudes below which they are steady: over 2000 periods the
/// integration tolerance causes 2e-11 if all errors add up; the largest observed change was 1e-13.
const STEADY: f64 = 1e-10;

/// P = |a|² of the first resonant mode and half its rate of change, a closed curve during the exchange.
type Place = [f64; 2];

impl NormalForm {
    /// The exchange that begins at a state, coordinates and then velocities, by the slow flow.
    ///
    /// # Errors
    /// No resonance; a state outside the range of the form; amplitudes that are
    /// constant, or do not return in 2000 periods of the slowest mode. Cancellation.
    pub fn exchange(&self, state: &[f64], progress: &dyn Progress) -> Result<Exchange, ExchangeError> {
        let watch = &Watch::new(progress);
        let mode = self.exchanging_mode().ok_or(ExchangeError::NoResonance)?;
        let amplitudes = self.amplitudes_of(state).ok_or(ExchangeError::TooFar)?;
        let seen = |interval: f64, samples: usize| self.slow_path(&amplitudes, interval, samples, watch);
        let slowest = self.modes.modes.iter().map(|mode| TAU / mode.frequency()).fold(0.0, f64::max);
        let about = self.rough_period(mode, slowest, &seen)?;
        let interval = about / count(SAMPLES);
        let path = seen(interval, EXCHANGES * SAMPLES)?;
        let points: Vec<Place> = path.iter().map(|amplitudes| self.orbit_point(mode, amplitudes)).collect();
        let [frequency, error] = winding(&points, interval, &Scale::of(&points));
        let ends = |j: usize| {
            let sizes = path.iter().map(|amplitudes| amplitudes[j].abs());
            sizes.fold([f64::INFINITY, 0.0], |[least, most], size| [size.min(least), size.max(most)])
        };
        let period = TAU / frequency;
        Ok(Exchange {
            period,
            error: error / frequency * period,
            amplitudes: (0..amplitudes.len()).map(ends).collect(),
            closed_form: self.closed_form(&amplitudes),
        })
    }

    /// The exchange of the full motion from the same state, by integration: a weighted mean of the frequency with which its amplitudes, computed
    /// through the normal form, circulate. The mean frequency does not depend on the choice of variables.
    ///
    /// # Errors
    /// As for [`Self::exchange`], and a failed integration. Cancellation.
    pub fn measured_exchange(
        &self,
        equation: &Equation,
        state: &[f64],
        exchange: &Exchange,
        progress: &dyn Progress,
    ) -> Result<MeasuredExchange, ExchangeError> {
        let mode = self.exchanging_mode().ok_or(ExchangeError::NoResonance)?;
        let interval = exchange.period / count(SAMPLES);
        let path = self.seen_path(equation, state, interval, EXCHANGES * SAMPLES, &Watch::new(progress))?;
        let points: Vec<Place> = path.iter().map(|amplitudes| self.orbit_point(mode, amplitudes)).collect();
        let [frequency, error] = winding(&points, interval, &Scale::of(&points));
        let period = TAU / frequency;
        Ok(MeasuredExchange { period, error: error / frequency * period })
    }

    /// The amplitudes by the slow flow at evenly spaced times from zero on.
    ///
    /// # Errors
    /// A failed integration.
    pub fn slow_path(
        &self,
        amplitudes: &[Complex],
        interval: f64,
        samples: usize,
        progress: &dyn Progress,
    ) -> Result<Vec<Vec<Complex>>, ExchangeError> {
        let start: Vec<f64> = amplitudes.iter().flat_map(|a| [a.re, a.im]).collect();
        let states = motion(&self.slow_flow(), &start, interval, samples, &Watch::new(progress))?;
        let amplitudes =
            |state: &Vec<f64>| state.chunks(2).map(|part| Complex::new(part[0], part[1])).collect();
        Ok(states.iter().map(amplitudes).collect())
    }

    /// The amplitudes of the full motion from a state, computed through the normal form, at evenly spaced times from zero on.
    ///
    /// # Errors
    /// A state too far from equilibrium, or a failed integration.
    pub fn seen_path(
        &self,
        equation: &Equation,
        state: &[f64],
        interval: f64,
        samples: usize,
        progress: &dyn Progress,
    ) -> Result<Vec<Vec<Complex>>, ExchangeError> {
        let states = motion(equation, state, interval, samples, &Watch::new(progress))?;
        states.iter().map(|state| self.amplitudes_of(state).ok_or(ExchangeError::TooFar)).collect()
    }

    /// The first mode with a resonant term that does not occur in every system.
    fn exchanging_mode(&self) -> Option<usize> {
        self.slow_terms.iter().find(|term| !term.is_of_every_system()).map(|term| term.mode)
    }

    fn orbit_point(&self, mode: usize, amplitudes: &[Complex]) -> Place {
        let (a, rate) = (amplitudes[mode], self.rates(amplitudes)[mode]);
        [a.re * a.re + a.im * a.im, a.re * rate.re + a.im * rate.im]
    }

    /// The mean time between maxima of P.
    fn rough_period(
        &self,
        mode: usize,
        slowest: f64,
        seen: &dyn Fn(f64, usize) -> Result<Vec<Vec<Complex>>, ExchangeError>,
    ) -> Result<f64, ExchangeError> {
        const PER_PERIOD: usize = 4;
        let interval = slowest / count(PER_PERIOD);
        let mut is_steady = true;
        for periods in [LONGEST / 64, LONGEST / 16, LONGEST / 4, LONGEST] {
            let path = seen(interval, periods * PER_PERIOD)?;
            let points: Vec<Place> =
                path.iter().map(|amplitudes| self.orbit_point(mode, amplitudes)).collect();
            is_steady = Scale::of(&points).is_steady();
            let falls = |pair: &(usize, &[Place])| pair.1[0][1] > 0.0 && pair.1[1][1] <= 0.0;
            let maxima: Vec<usize> = points.windows(2).enumerate().filter(falls).map(|pair| pair.0).collect();
            if let (Some(first), Some(last), true) = (maxima.first(), maxima.last(), maxima.len() > 2)
                && !is_steady
            {
                return Ok(interval * count(last - first) / count(maxima.len() - 1));
            }
        }
        Err(if is_steady { ExchangeError::Steady } else { ExchangeError::TooSlow(slowest * count(LONGEST)) })
    }

    /// Period from aⱼ′ = iα·b², b′ = iβ·a·b̄: u = |b|² is a Jacobi function of
    /// the time, between roots of (|a|²u − …), since Re(a·b̄²) is conserved.
    fn closed_form(&self, amplitudes: &[Complex]) -> Option<f64> {
        // A detuning that is zero up to the rounding of the frequencies.
        let fastest = self.modes.modes.iter().map(|mode| mode.frequency()).fold(0.0, f64::max);
        let second = |mode: usize, powers: &[u8], bars: &[u8]| {
            let fits = |term: &&super::SlowTerm| {
                term.mode == mode
                    && term.powers == powers
                    && term.conjugate_powers == bars
                    && term.detuning.abs() <= 1e-12 * fastest
            };
            self.slow_terms.iter().find(fits).map(|term| term.coefficient.im)
        };
        if amplitudes.len() != 2 {
            return None;
        }
        // The second mode is the faster one.
        let (alpha, beta) = (second(1, &[2, 0], &[0, 0])?, second(0, &[0, 1], &[1, 0])?);
        let [b, a] = [amplitudes[0], amplitudes[1]];
        let bar = Complex::new(b.re, -b.im);
        let h = (a * bar * bar).re;
        let c = a.abs() * a.abs() / alpha + b.abs() * b.abs() / beta;
        let roots = polynomial_roots(&[beta / alpha * h * h, 0.0, -beta * c, 1.0])?;
        let mut roots: Vec<f64> =
            roots.iter().flat_map(|root| vec![root.value.re; root.multiplicity]).collect();
        roots.sort_by(f64::total_cmp);
        let [first, second, third] = roots[..] else { return None };
        let modulus = Modulus::from_parameter((third - second) / (third - first)).ok()?;
        let period = 2.0 * modulus.first() / (alpha * beta * (third - first)).sqrt();
        (period > 0.0 && period.is_finite()).then_some(period)
    }
}

/// The states at evenly spaced times from zero on.
fn motion(
    equation: &Equation,
    start: &[f64],
    interval: f64,
    samples: usize,
    watch: &Watch<'_>,
) -> Result<Vec<Vec<f64>>, ExchangeError> {
    /// Far below the error of the slow flow, with which the motion is compared.
    const TOLERANCE: f64 = 1e-14;
    let system = System::new(equation).map_err(|_| ExchangeError::TooFar)?;
    let times: Vec<f64> = (0..=samples).map(|k| interval * count(k)).collect();
    let start = Moment { time: 0.0, state: start.to_vec() };
    let solution = integrate(&system, &start, &times, &Effort::to_tolerance(TOLERANCE), &watch.part())?;
    Ok(solution.samples.into_iter().map(|sample| sample.state).collect())
}

/// Centre and size of a closed curve.
struct Scale {
    middle: f64,
    half_width: f64,
    height: f64,
}

impl Scale {
    fn of(places: &[Place]) -> Self {
        let least = places.iter().map(|point| point[0]).fold(f64::INFINITY, f64::min);
        let most = places.iter().map(|point| point[0]).fold(0.0, f64::max);
        let height = places.iter().map(|point| point[1].abs()).fold(0.0, f64::max);
        Self { middle: 0.5 * (least + most), half_width: 0.5 * (most - least), height }
    }

    fn is_steady(&self) -> bool {
        self.half_width <= STEADY * self.middle
    }

    fn angle(&self, point: &Place) -> f64 {
        libm::atan2(-point[1] / self.height, (point[0] - self.middle) / self.half_width)
    }
}

/// The mean angular frequency around the middle, and its error: the largest change when a tenth of the samples is left out, at either end or
/// half at each. The mean converges faster than any power of the length: the error of nine tenths is a few times that of the whole, that of one
/// half thousands of times as large. The effect of the integration tolerance is added.
fn winding(places: &[Place], interval: f64, scale: &Scale) -> [f64; 2] {
    let angles: Vec<f64> = places.iter().map(|point| scale.angle(point)).collect();
    let step = |pair: &[f64]| {
        let step = pair[1] - pair[0];
        step - TAU * (step / TAU).round()
    };
    let steps: Vec<f64> = angles.windows(2).map(step).collect();
    let whole = weighted_mean(&steps);
    let left_out = steps.len() / 10;
    let shorter = [0, left_out / 2, left_out].map(|first| &steps[first..first + steps.len() - left_out]);
    let changes = shorter.map(|steps| (weighted_mean(steps) - whole).abs());
    let error = changes.into_iter().fold(0.0, f64::max) + ROUNDING * whole.abs();
    [whole.abs() / interval, error / interval]
}

/// The mean with weights e^{−1/t(1−t)}, which converges faster than any power of the length for quasi-periodic values.
///
/// Reference: S. Das, Y. Saiki, E. Sander, J. A. Yorke, Nonlinearity 30 (2017) 4111, doi:10.1088/1361-6544/aa84c2.
fn weighted_mean(values: &[f64]) -> f64 {
    let weight = |k: usize| {
        let t = (count(k) + 0.5) / count(values.len());
        libm::exp(-1.0 / (t * (1.0 - t)))
    };
    let sums = values
        .iter()
        .enumerate()
        .fold([0.0, 0.0], |[sum, total], (k, value)| [sum + weight(k) * value, total + weight(k)]);
    sums[0] / sums[1]
}
