//! The spectrum of unevenly sampled values: the part of them that a sine of each frequency explains.
//!
//! References: J. T. VanderPlas, *Understanding the Lomb–Scargle periodogram*, Astrophys. J. Suppl. 236 (2018) 16,
//! doi:10.3847/1538-4365/aab766; M. Zechmeister, M. Kürster, *The generalised Lomb–Scargle periodogram*, A&A 496 (2009) 577,
//! doi:10.1051/0004-6361:200811296.

use crate::statistics::count;
use libration::internals::progress::Watch;
use libration::progress::Interrupted;
use libration::progress::Progress;

/// A point of a spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectrumPoint {
    /// Frequency in Hz.
    pub frequency: f64,
    /// Amplitude of the best-fitting sine of this frequency, next to a constant, in the unit of the values.
    pub amplitude: f64,
    /// The part of the weighted squares about their mean that the sine explains, from 0 to 1: the standard normalisation.
    pub power: f64,
}

/// Number of rows that are summed between two checks for a cancellation.
const BLOCK: usize = 256;

/// Computes the Lomb–Scargle periodogram with a floating mean at the frequencies `step`, 2·`step`, … `points`·`step` (Hz): the best
/// sine of each through `values` at `times` (s), where each row counts by its weight (as one over the square of its standard
/// deviation, or a window's; all alike where there are none). Rows beyond the shortest column do not count.
///
/// NaN where rows do not determine a sine: fewer than three, or a frequency at which all of them have the same phase, and
/// where all values are the same.
///
/// # Accuracy
/// About 1e-12 for a thousand points: phases are accumulated from point to point.
///
/// # Errors
/// [`Interrupted`] if the call is cancelled; the progress is updated after every 256 rows.
///
/// # Examples
/// ```
/// use libration::progress::Quiet;
/// use libration_lab::fit::spectrum::lomb_scargle;
/// let times: Vec<f64> = (0..40).map(|row| 0.1 * f64::from(row) + 0.01 * f64::from(row * row % 7)).collect();
/// let values: Vec<f64> = times.iter().map(|t| 5.0 + 0.3 * (std::f64::consts::TAU * 1.5 * t).sin()).collect();
/// let spectrum = lomb_scargle(&times, &values, None, 0.5, 6, &Quiet)?;
/// assert!((spectrum[2].amplitude - 0.3).abs() < 1e-12 && (spectrum[2].power - 1.0).abs() < 1e-12);
/// # Ok::<(), libration::progress::Interrupted>(())
/// ```
pub fn lomb_scargle(
    times: &[f64],
    values: &[f64],
    weights: Option<&[f64]>,
    step: f64,
    points: usize,
    progress: &dyn Progress,
) -> Result<Vec<SpectrumPoint>, Interrupted> {
    let watch = &Watch::new(progress);
    let rows = times.len().min(values.len()).min(weights.map_or(usize::MAX, <[f64]>::len));
    let weight = |row: usize| weights.map_or(1.0, |weights| weights[row]);
    let total: f64 = (0..rows).map(weight).sum();
    let mean = (0..rows).map(|row| weight(row) * values[row]).sum::<f64>() / total;
    let first = times.first().copied().unwrap_or(0.0);
    let mut sums = vec![Sums::default(); points];
    let mut squares = 0.0;
    for row in 0..rows {
        if row % BLOCK == 0 {
            watch.go_on()?;
        }
        let (weight, value) = (weight(row) / total, values[row] - mean);
        squares += weight * value * value;
        let turn = libm::sincos(std::f64::consts::TAU * step * (times[row] - first));
        add(&mut sums, weight, value, turn);
    }
    let point = |(sums, number): (&Sums, usize)| sums.point(step * count(number), squares, rows);
    Ok(sums.iter().zip(1..).map(point).collect())
}

/// Weighted means of the cosine, the sine, their squares, and their products with the values.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    c: f64,
    s: f64,
    cc: f64,
    cs: f64,
    yc: f64,
    ys: f64,
}

/// Adds a row, whose phase advances by an angle with this sine and cosine from one frequency to the next.
fn add(sums: &mut [Sums], weight: f64, value: f64, (sin, cos): (f64, f64)) {
    let (mut s, mut c) = (sin, cos);
    for sums in sums {
        let (ws, wc) = (weight * s, weight * c);
        sums.c += wc;
        sums.s += ws;
        sums.cc += wc * c;
        sums.cs += wc * s;
        sums.yc += wc * value;
        sums.ys += ws * value;
        (s, c) = (s * cos + c * sin, c * cos - s * sin);
    }
}

impl Sums {
    /// Solves for the sine by Zechmeister's and Kürster's equations 4 to 13.
    fn point(&self, frequency: f64, squares: f64, rows: usize) -> SpectrumPoint {
        let cc = self.cc - self.c * self.c;
        let ss = (1.0 - self.cc) - self.s * self.s;
        let cs = self.cs - self.c * self.s;
        let determinant = cc * ss - cs * cs;
        let (yc, ys) = (self.yc, self.ys);
        let cosine = (yc * ss - ys * cs) / determinant;
        let sine = (ys * cc - yc * cs) / determinant;
        // The means of squares are 1/2; rounding makes 1e-13 of a determinant that is zero.
        if rows < 3 || determinant.is_nan() || determinant < 1e-11 {
            return SpectrumPoint { frequency, amplitude: f64::NAN, power: f64::NAN };
        }
        let power = (cosine * yc + sine * ys) / squares;
        SpectrumPoint { frequency, amplitude: libm::hypot(cosine, sine), power }
    }
}
