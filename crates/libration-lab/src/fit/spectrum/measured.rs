//! The harmonics of a trace: its windows, and their means.

use std::f64::consts::TAU;

use super::error::FEWEST_SWINGS;
use super::noise::{Noise, about_harmonics};
use super::remark::{MeasuredSwing, of_harmonic};
use super::tapered::tapered;
use super::theory::Theory;
use super::window_fit::{WindowFit, cosine_column, sine_column};
use super::windows::Windows;
use super::{Harmonic, SpectrumError, SpectrumPoint, SpectrumRemark, SpectrumWindow};
use crate::fit::cycles::{CyclesOptions, beyond_a_turn, fit_cycles};
use crate::fit::uncertain::Uncertain;
use crate::measurement::{Observable, Trace};
use crate::statistics::count;
use libration::internals::progress::Watch;
use libration::progress::Progress;

/// Options for the measurement of harmonics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SpectrumOptions {
    /// The highest harmonic.
    pub harmonics: usize,
    /// Number of swings in a window, at least three.
    pub swings: usize,
}

impl Default for SpectrumOptions {
    fn default() -> Self {
        Self { harmonics: 7, swings: 5 }
    }
}

/// The harmonics of a measured swing.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    /// The measured quantity, in rad or rad/s.
    pub observable: Observable,
    /// Frequency of the first harmonic, in Hz: the mean of the windows, as it drifts with the amplitude.
    pub frequency: f64,
    /// Amplitude of the undamped swing with the first harmonic, in rad: the mean of the windows.
    pub amplitude: f64,
    /// Harmonics from n = 0: the means of the windows, each weighted by the information of its rows.
    pub harmonics: Vec<Harmonic>,
    /// Windows in the order of time.
    pub windows: Vec<SpectrumWindow>,
    /// The standard deviation of a row by the residuals of the harmonics: rad or rad/s, or relative to the uncertainties of the rows.
    pub noise: f64,
    /// Rows left out for being far from all harmonics, counted from zero.
    pub outliers: Vec<usize>,
    /// `true` if rows have weights by their own uncertainties.
    pub weighted: bool,
    /// The periodogram of up to 60 swings (without outliers) from the beginning, by [`lomb_scargle`](super::lomb_scargle()) with Hann's window, five
    /// points in the width of a line.
    pub points: Vec<SpectrumPoint>,
    /// Remarks on the harmonics.
    pub remarks: Vec<SpectrumRemark>,
}

/// Computes the harmonics of a trace of angles or angular velocities.
///
/// # Accuracy
/// Uncertainties hold for noise that is smooth over an order: 68 % of intervals by Student's t cover the truth
/// (`tests/suite/spectrum.rs`). Windows of three swings are too short to determine it, and take all residuals for white noise. Where the
/// amplitude falls by a third within a window harmonics are off by a thousandth of themselves.
///
/// # Errors
/// Fails with a [`SpectrumError`]: no swings, too few of them, none that can be used.
/// [`SpectrumError::Interrupted`] if the call is cancelled.
///
/// # Examples
/// ```
/// use libration::pendulum::Pendulum;
/// use libration::progress::Quiet;
/// use libration_lab::fit::spectrum::{SpectrumOptions, fit_spectrum};
/// use libration_lab::measurement::{Observable, Trace};
/// let motion = Pendulum::new(0.56, 9.81)?.released_from("80deg".parse()?)?;
/// let times: Vec<f64> = (0..600).map(|row| f64::from(row) / 60.0).collect();
/// let angles = times.iter().map(|&time| motion.state_at(time).angle).collect();
/// let trace = Trace::new("swing", Observable::Angle, times, angles, None)?;
/// let spectrum = fit_spectrum(&trace, &SpectrumOptions::default(), &Quiet)?;
/// assert!((spectrum.amplitude.to_degrees() - 80.0).abs() < 1e-3);
/// let third = spectrum.harmonics[3];
/// assert!((third.in_phase.value - third.theory).abs() < 1e-6 && third.theory < -0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fit_spectrum(
    trace: &Trace,
    options: &SpectrumOptions,
    progress: &dyn Progress,
) -> Result<Spectrum, SpectrumError> {
    let watch = &Watch::new(progress);
    if options.swings < FEWEST_SWINGS {
        return Err(SpectrumError::ShortWindows(options.swings));
    }
    if options.harmonics == 0 {
        return Err(SpectrumError::NoHarmonics);
    }
    if let Some(beyond) = beyond_a_turn(trace) {
        return Err(beyond.into());
    }
    let cycles = fit_cycles(trace, &CyclesOptions::default(), watch)?;
    let windows = Windows::new(trace, &cycles, options.swings);
    if windows.swings < count(FEWEST_SWINGS) {
        return Err(SpectrumError::TooShort { swings: windows.swings, needed: FEWEST_SWINGS });
    }
    let sampled = windows.highest_sampled();
    let highest = options.harmonics.min(sampled).max(1);
    let fits = fits(&windows, highest, watch)?;
    let mut spectrum = UsableWindows::new(fits, highest).spectrum(trace.observable());
    let not_sampled = SpectrumRemark::NotSampled { highest: sampled, asked: options.harmonics };
    let left_out =
        SpectrumRemark::WindowsLeftOut { windows: windows.count - spectrum.windows.len(), of: windows.count };
    spectrum.remarks.extend((options.harmonics > sampled).then_some(not_sampled));
    spectrum.remarks.extend((spectrum.windows.len() < windows.count).then_some(left_out));
    let top = (count(highest) + 1.0).min(count(sampled) + 0.5) * spectrum.frequency;
    spectrum.weighted = trace.uncertainties().is_some();
    spectrum.points = tapered(trace, &spectrum.outliers, 1.0 / spectrum.frequency, top, watch)?;
    Ok(spectrum)
}

/// Number of uncertainties of its amplitude below which a swing is lost in noise: the phase then scatters by a twentieth
/// of a radian, and the cosine of the third harmonic's loses a hundredth.
const FAINTEST: f64 = 20.0;

fn fits(windows: &Windows<'_>, highest: usize, watch: &Watch<'_>) -> Result<Vec<WindowFit>, SpectrumError> {
    let mut fits = vec![];
    for number in 0..windows.count {
        watch.go_on()?;
        let fit = windows.rows(number, highest).and_then(|rows| rows.fit());
        fits.extend(fit.filter(is_clear));
    }
    match fits.is_empty() {
        true => Err(SpectrumError::NoWindow { windows: windows.count }),
        false => Ok(fits),
    }
}

fn is_clear(fit: &WindowFit) -> bool {
    let dof = fit.degrees_of_freedom();
    let variance = fit.chi2() / count(dof);
    let first = fit.coefficient(cosine_column(1));
    dof > 0 && first > FAINTEST * (variance * fit.covariance(cosine_column(1), cosine_column(1))).sqrt()
}

/// The windows that can be used, with the noise about each harmonic.
struct UsableWindows {
    fits: Vec<WindowFit>,
    noise: Vec<Noise>,
    highest: usize,
}

impl UsableWindows {
    fn new(fits: Vec<WindowFit>, highest: usize) -> Self {
        Self { noise: about_harmonics(&fits, highest), fits, highest }
    }

    fn spectrum(&self, observable: Observable) -> Spectrum {
        let windows: Vec<SpectrumWindow> = self.fits.iter().map(|fit| self.window(fit)).collect();
        let mean =
            |of: fn(&SpectrumWindow) -> f64| windows.iter().map(of).sum::<f64>() / count(windows.len());
        let harmonics: Vec<Harmonic> = (0..=self.highest).map(|n| self.mean_harmonic(&windows, n)).collect();
        let chi2: f64 = self.fits.iter().map(WindowFit::chi2).sum();
        let dof: usize = self.fits.iter().map(WindowFit::degrees_of_freedom).sum();
        let outliers: Vec<usize> = self.fits.iter().flat_map(|fit| fit.outliers.iter().copied()).collect();
        let mut remarks = self.remarks(&harmonics, &windows, observable);
        remarks.extend((!outliers.is_empty()).then_some(SpectrumRemark::Outliers { rows: outliers.len() }));
        Spectrum {
            observable,
            frequency: mean(|window| window.frequency.value),
            amplitude: mean(|window| window.amplitude.value),
            harmonics,
            noise: (chi2 / count(dof)).sqrt(),
            outliers,
            weighted: false,
            points: vec![],
            remarks,
            windows,
        }
    }

    fn window(&self, fit: &WindowFit) -> SpectrumWindow {
        let first = self.noise[1].variance;
        let frequency = fit.frequency() / TAU;
        let spread = (fit.covariance(cosine_column(1), cosine_column(1)) * first).sqrt();
        let Theory { amplitude, amplitude_slope, .. } = fit.theory;
        SpectrumWindow {
            time: fit.middle,
            rows: fit.rows(),
            frequency: Uncertain {
                value: frequency,
                uncertainty: (fit.frequency_variance() * first).sqrt() / TAU,
            },
            amplitude: Uncertain { value: amplitude, uncertainty: amplitude_slope * spread },
            harmonics: (0..=self.highest).map(|n| self.harmonic(fit, n)).collect(),
        }
    }

    fn harmonic(&self, fit: &WindowFit, n: usize) -> Harmonic {
        let (column, first) = (cosine_column(n), cosine_column(1));
        let [noise, of_first] = [self.noise[n], self.noise[1]];
        let value = fit.coefficient(column);
        let variance = noise.variance * fit.covariance(column, column);
        let theory = fit.theory.coefficients[n];
        let slope = fit.theory.slopes[n];
        let with_theory = variance
            - 2.0 * slope * (noise.variance * of_first.variance).sqrt() * fit.covariance(column, first)
            + slope * slope * of_first.variance * fit.covariance(first, first);
        let difference = Uncertain { value: value - theory, uncertainty: with_theory.max(0.0).sqrt() };
        Harmonic {
            n,
            in_phase: Uncertain { value, uncertainty: variance.sqrt() },
            quadrature: (n > 1).then(|| self.quadrature(fit, n)),
            theory: if n == 1 { value } else { theory },
            difference: (n != 1).then_some(difference),
            degrees_of_freedom: noise.degrees_of_freedom,
        }
    }

    /// The quadrature, with the uncertainty from the noise about it and from its reference phase.
    fn quadrature(&self, fit: &WindowFit, n: usize) -> Uncertain {
        let column = sine_column(n);
        let turned = count(n) * fit.coefficient(cosine_column(n));
        let variance = self.noise[n].variance * fit.covariance(column, column)
            + turned * turned * self.noise[1].variance * fit.phase_variance();
        Uncertain { value: fit.coefficient(column), uncertainty: variance.sqrt() }
    }

    /// The mean of the windows, weighted by the information of their rows about the harmonic, if the noise is the same in all.
    fn mean_harmonic(&self, windows: &[SpectrumWindow], n: usize) -> Harmonic {
        let column = cosine_column(n);
        let weights: Vec<f64> = self.fits.iter().map(|fit| fit.covariance(column, column).recip()).collect();
        let of = |of: &dyn Fn(&Harmonic) -> Uncertain| {
            let parts = windows.iter().map(|window| of(&window.harmonics[n]));
            mean(&weights, parts)
        };
        let last = windows[0].harmonics[n];
        Harmonic {
            in_phase: of(&|harmonic| harmonic.in_phase),
            quadrature: last.quadrature.map(|_| of(&|harmonic| harmonic.quadrature.unwrap_or_default())),
            theory: of(&|harmonic| Uncertain { value: harmonic.theory, uncertainty: 0.0 }).value,
            difference: last.difference.map(|_| of(&|harmonic| harmonic.difference.unwrap_or_default())),
            ..last
        }
    }

    fn remarks(
        &self,
        harmonics: &[Harmonic],
        windows: &[SpectrumWindow],
        observable: Observable,
    ) -> Vec<SpectrumRemark> {
        let first = harmonics[1].in_phase.value;
        let swing = MeasuredSwing { observable, first, decay: decay(windows), harmonics: self.highest };
        let growth = |n: usize| {
            self.fits.iter().map(|fit| fit.theory.growth(n).power).sum::<f64>() / count(self.fits.len())
        };
        let of = |harmonic: &Harmonic| of_harmonic(harmonic, growth(harmonic.n), &swing);
        harmonics.iter().flat_map(of).collect()
    }
}

/// The mean of independent values with these weights.
fn mean(weights: &[f64], values: impl Iterator<Item = Uncertain>) -> Uncertain {
    let total: f64 = weights.iter().sum();
    let (value, variance) =
        weights.iter().zip(values).fold((0.0, 0.0), |(sum, variance), (weight, value)| {
            let [part, deviation] = [value.value, value.uncertainty].map(|part| weight / total * part);
            (sum + part, variance + deviation * deviation)
        });
    Uncertain { value, uncertainty: variance.sqrt() }
}

/// The rate at which the amplitude falls from the first window to the last, over the frequency (rad/s).
fn decay(windows: &[SpectrumWindow]) -> f64 {
    let [first, last] = [&windows[0], &windows[windows.len() - 1]];
    if windows.len() < 2 {
        return 0.0;
    }
    let fall = libm::log(first.amplitude.value / last.amplitude.value) / (last.time - first.time);
    (fall / (TAU * first.frequency.value)).abs()
}
