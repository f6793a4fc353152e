//! The harmonics of an orbit, by sums over evenly spaced times.

use super::periodic::Orbit;
use libration_kernels::elementary::count;
use libration_numbers::{algebra::Complex, internals::algebra::fourier};

/// The coefficients of cos nΩt and sin nΩt, with the time counted from the orbit's start.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Harmonic {
    /// n.
    pub n: usize,
    /// The coefficient of the cosine; for n = 0 the mean.
    pub cosine: f64,
    /// The coefficient of the sine.
    pub sine: f64,
}

impl Harmonic {
    /// √(cosine² + sine²).
    #[must_use]
    pub fn amplitude(&self) -> f64 {
        libm::hypot(self.cosine, self.sine)
    }
}

/// The harmonics of one state component.
#[derive(Clone, Debug, PartialEq)]
pub struct Harmonics {
    /// The harmonics from n = 0 to the last one that exceeds the rounding errors.
    pub terms: Vec<Harmonic>,
    /// Upper bound on the omitted harmonics, estimated from the last quarter of those that the samples resolve.
    pub remainder: f64,
    /// The error of each coefficient: twice that of the states, plus the rounding of the sums.
    pub error: f64,
    /// Number of times in a period at which the orbit was sampled.
    pub samples: usize,
}

/// The initial and the maximum number of samples.
const SAMPLES: [usize; 2] = [64, 1 << 15];
/// Size, relative to the largest harmonic, below which harmonics are rounding errors.
const NEGLIGIBLE: f64 = 2e-16;

impl Orbit {
    /// The harmonics of one state component, as many as double precision resolves.
    ///
    /// Samples are doubled until the last quarter of the resolved harmonics vanishes
    /// compared with the largest one: aliases of higher harmonics are then even smaller.
    ///
    /// # Accuracy
    /// As stated by [`error`](Harmonics::error), and by [`remainder`](Harmonics::remainder) for higher harmonics.
    #[must_use]
    pub fn harmonics(&self, number: usize) -> Harmonics {
        let [mut samples, most] = SAMPLES;
        loop {
            let all = transform(&self.sampled(number, samples));
            let largest = all.iter().skip(1).map(Harmonic::amplitude).fold(0.0, f64::max);
            let last = all[3 * all.len() / 4..].iter().map(Harmonic::amplitude).fold(0.0, f64::max);
            if last <= 8.0 * NEGLIGIBLE * largest || samples >= most {
                let state_error = self.state_errors().get(number).copied().unwrap_or(f64::NAN);
                let error = 2.0 * state_error + NEGLIGIBLE * largest.max(all[0].cosine.abs());
                return significant(all, last.max(NEGLIGIBLE * largest), error, samples);
            }
            samples *= 2;
        }
    }

    fn sampled(&self, number: usize, samples: usize) -> Vec<Complex> {
        let part = |j: usize| self.period() * count(j) / count(samples);
        let value = |time: f64| self.state_at(time).get(number).copied().unwrap_or(f64::NAN);
        (0..samples).map(|j| Complex::from(value(part(j)))).collect()
    }
}

/// The terms up to the last one above a size.
fn significant(mut terms: Vec<Harmonic>, remainder: f64, error: f64, samples: usize) -> Harmonics {
    let last = terms.iter().rposition(|term| term.amplitude() > remainder).unwrap_or(0);
    terms.truncate(last + 1);
    Harmonics { terms, remainder, error, samples }
}

/// The harmonics below half the number of samples.
fn transform(samples: &[Complex]) -> Vec<Harmonic> {
    let weight = 1.0 / count(samples.len());
    let sums = fourier(samples);
    let term = |(n, sum): (usize, &Complex)| {
        let factor = if n == 0 { weight } else { 2.0 * weight };
        Harmonic { n, cosine: factor * sum.re, sine: -factor * sum.im }
    };
    sums.iter().take(samples.len() / 2).enumerate().map(term).collect()
}
