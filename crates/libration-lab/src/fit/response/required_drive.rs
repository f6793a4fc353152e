//! The drive that an oscillator needs to respond with a given amplitude.
//!
//! At a frequency Ω one drive can have several responses, but a response of a given amplitude needs exactly one drive, on stable and unstable
//! branches alike. With the phase of the response it is a complex number Z(Ω, a), for a linear oscillator a·(ω0² − Ω² + icΩ).

use libration::algebra::Complex;

use super::MeasuredAmplitude;
use super::model::ResponseModel;
use super::stability::stability;
use libration::orbit::Stability;
use libration::progress::Quiet;
use libration::taylor::{Effort, Moment, System, Trajectory, integrate_many, with_sensitivities};
use nalgebra::{Matrix3, Vector3};
use std::cell::RefCell;
use std::f64::consts::{FRAC_2_PI, PI};

/// A frequency with the wanted amplitude of the response.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asked {
    /// Drive frequency, in rad/s.
    pub(super) frequency: f64,
    pub(super) amplitude: f64,
}

/// The drive that a response needs.
#[derive(Clone, Debug)]
pub(super) struct RequiredDrive {
    /// The amplitude of the drive and, as argument, the phase lag of the fundamental of the response.
    pub(super) drive: Complex,
    /// The derivatives by ω0², c and perhaps κ.
    pub(super) by_coefficients: Vec<Complex>,
    /// The derivative by the amplitude.
    pub(super) by_amplitude: Complex,
    /// The behaviour of small deviations.
    pub(super) stability: Stability,
    /// Start of Newton's method for a neighbouring response.
    shape: ResponseShape,
}

impl RequiredDrive {
    /// The derivative with respect to the frequency. Z has the unit of Ω² times that of the amplitude, so
    /// that Ω·∂Z/∂Ω + c·∂Z/∂c + 2ω0²·∂Z/∂ω0² + 2κ·∂Z/∂κ = 2Z.
    pub(super) fn by_frequency(&self, asked: &Asked, coefficients: &[f64]) -> Complex {
        const POWERS: [f64; 3] = [2.0, 1.0, 2.0];
        let others = POWERS.iter().zip(coefficients).zip(&self.by_coefficients);
        let others: Complex = others.map(|((power, value), slope)| slope.scaled(power * value)).sum();
        (self.drive.scaled(2.0) - others).scaled(1.0 / asked.frequency)
    }
}

/// Method by which the required drives are computed.
pub(super) trait DriveMethod {
    /// Computes the drives that responses need; `None` if there is no drive for one of them.
    fn required(&self, asked: &[Asked], coefficients: &[f64]) -> Option<Vec<RequiredDrive>>;
}

/// Step of differences, relative to the amplitude, with an error below a millionth.
const STEP: f64 = 1e-3;

/// Harmonic balance with one harmonic: exact for the linear oscillator.
#[derive(Clone, Copy, Debug)]
pub(super) struct OneHarmonic(pub(super) ResponseModel);

impl OneHarmonic {
    /// Factor of ω0² at this amplitude, and coefficient of κ.
    fn stiffness(self, amplitude: f64) -> [f64; 2] {
        match self.0 {
            ResponseModel::Pendulum => [2.0 * libm::j1(amplitude) / amplitude, 0.0],
            ResponseModel::Linear | ResponseModel::Duffing => [1.0, 0.75 * amplitude * amplitude],
        }
    }

    /// The squared frequency at which the force has the phase of the velocity.
    pub(super) fn resonance_squared(self, amplitude: f64, coefficients: &[f64]) -> f64 {
        let [by_square, by_cubic] = self.stiffness(amplitude);
        by_square * coefficients[0] + by_cubic * coefficients.get(2).copied().unwrap_or(0.0)
    }

    /// Force of the linear oscillator with the same stiffness.
    fn force(self, amplitude: f64, frequency: f64, coefficients: &[f64]) -> Complex {
        let elastic = self.resonance_squared(amplitude, coefficients) - frequency * frequency;
        Complex::new(elastic, coefficients[1] * frequency).scaled(amplitude)
    }

    fn drive(self, asked: &Asked, coefficients: &[f64]) -> RequiredDrive {
        let Asked { frequency, amplitude } = *asked;
        let [by_square, by_cubic] = self.stiffness(amplitude);
        let drive = self.force(amplitude, frequency, coefficients);
        let mut by_coefficients = vec![
            Complex::from(amplitude * by_square),
            Complex::new(0.0, amplitude * frequency),
            Complex::from(amplitude * by_cubic),
        ];
        by_coefficients.truncate(coefficients.len());
        // By differences of the stiffness, which changes slowly.
        let by_amplitude = (self.force(amplitude * (1.0 + STEP), frequency, coefficients)
            - self.force(amplitude * (1.0 - STEP), frequency, coefficients))
        .scaled(0.5 / (STEP * amplitude));
        let square = frequency * frequency;
        let shape = ResponseShape { peak: amplitude, cosine: drive.re / square, sine: drive.im / square };
        RequiredDrive { drive, by_coefficients, by_amplitude, stability: Stability::Undetermined, shape }
    }
}

impl DriveMethod for OneHarmonic {
    fn required(&self, asked: &[Asked], coefficients: &[f64]) -> Option<Vec<RequiredDrive>> {
        let drives: Vec<RequiredDrive> =
            asked.iter().map(|response| self.drive(response, coefficients)).collect();
        drives.iter().all(|drive| drive.drive.is_finite()).then_some(drives)
    }
}

/// A response that begins at its turning point at `peak`, under the force Ω²·(`cosine`·cos τ − `sine`·sin τ) at the phase τ of the drive.
#[derive(Clone, Copy, Debug)]
struct ResponseShape {
    peak: f64,
    cosine: f64,
    sine: f64,
}

/// All harmonics: integration over half a period, after which the response is its own mirror image.
#[derive(Debug)]
pub(super) struct AllHarmonics {
    model: ResponseModel,
    measured: MeasuredAmplitude,
    system: System,
    /// Arguments of the last computation, with the shapes that were found.
    last: RefCell<Vec<(Asked, ResponseShape)>>,
}

/// Number of motions that are integrated together, in lanes.
const LANES: usize = 8;
/// Tolerances far below the errors of measured amplitudes, so that differences of motions give derivatives.
pub(super) const EFFORT: Effort = Effort { relative: 1e-13, absolute: 1e-15, most_steps: 20_000 };
/// Newton's rounds: from one harmonic four to six.
const MOST_ROUNDS: usize = 25;
/// Newton's corrections, relative to the amplitude, below which the iteration ends: the remaining error is of the order of the square.
const CLOSE: f64 = 1e-8;

impl AllHarmonics {
    pub(super) fn new(model: ResponseModel, measured: MeasuredAmplitude) -> Self {
        let names = model.names();
        let equation = with_sensitivities(&model.in_phase_of_drive(), names, 2);
        let system = System::with_parameters(&equation, names).expect("all parameters are open");
        Self { model, measured, system, last: RefCell::default() }
    }

    pub(super) fn model(&self) -> ResponseModel {
        self.model
    }

    pub(super) fn measured(&self) -> MeasuredAmplitude {
        self.measured
    }

    /// The last shapes found at these frequencies, otherwise those with one harmonic.
    fn guesses(&self, asked: &[Asked], coefficients: &[f64]) -> Option<Vec<ResponseShape>> {
        let last = self.last.borrow();
        let same = |(asked, (last, _)): (&Asked, &(Asked, ResponseShape))| {
            asked.frequency.total_cmp(&last.frequency).is_eq()
                && (asked.amplitude - last.amplitude).abs() < 0.1 * last.amplitude
        };
        if last.len() == asked.len() && asked.iter().zip(last.iter()).all(same) {
            return Some(last.iter().map(|(_, shape)| *shape).collect());
        }
        let rough = OneHarmonic(self.model).required(asked, coefficients)?;
        Some(rough.into_iter().map(|drive| drive.shape).collect())
    }

    /// Integrates the motions to the ends of half periods.
    fn ends(
        &self,
        asked: &[Asked],
        shapes: &[ResponseShape],
        coefficients: &[f64],
    ) -> Option<Vec<HalfPeriodState>> {
        const HALF: [f64; 1] = [PI];
        let copies = self.model.coefficients() + 5;
        let ways: Vec<Trajectory<'_>> = asked
            .iter()
            .zip(shapes)
            .map(|(asked, shape)| {
                let mut state = vec![0.0; 4 * copies];
                state[0] = shape.peak;
                // The last two copies are by the first angle and the first velocity.
                (state[3 * (copies - 2)], state[4 * copies - 1]) = (1.0, 1.0);
                let parameters = scaled(coefficients, asked.frequency).chain([shape.cosine, shape.sine]);
                let start = Moment { time: 0.0, state };
                Trajectory { start, parameters: parameters.collect(), times: &HALF }
            })
            .collect();
        let solutions =
            ways.chunks(LANES).flat_map(|ways| integrate_many(&self.system, ways, &EFFORT, &Quiet));
        solutions.map(|solution| Some(HalfPeriodState { state: solution.ok()?.end.state, copies })).collect()
    }

    fn solved(
        &self,
        end: &HalfPeriodState,
        asked: &Asked,
        shape: ResponseShape,
    ) -> Option<(Linear, Vector3<f64>)> {
        let linear = Linear::new(end, self.measured);
        let reached = match self.measured {
            MeasuredAmplitude::Peak => shape.peak,
            MeasuredAmplitude::Fundamental => linear.fundamental.abs(),
        };
        let misses = Vector3::new(end.state[0] + shape.peak, end.velocity(0), reached - asked.amplitude);
        let change = -(linear.inverse? * misses);
        change.iter().all(|number| number.is_finite()).then_some((linear, change))
    }
}

/// d, s and perhaps r from ω0², c and perhaps κ.
pub(super) fn scaled(coefficients: &[f64], frequency: f64) -> impl Iterator<Item = f64> {
    let square = frequency * frequency;
    let cubic = coefficients.get(2).map(|cubic| cubic / square);
    [coefficients[1] / frequency, coefficients[0] / square].into_iter().chain(cubic)
}

impl DriveMethod for AllHarmonics {
    fn required(&self, asked: &[Asked], coefficients: &[f64]) -> Option<Vec<RequiredDrive>> {
        let mut shapes = self.guesses(asked, coefficients)?;
        let mut drives: Vec<Option<RequiredDrive>> = vec![None; asked.len()];
        for _ in 0..MOST_ROUNDS {
            let open: Vec<usize> = (0..asked.len()).filter(|&index| drives[index].is_none()).collect();
            if open.is_empty() {
                let complete = drives.into_iter().collect::<Option<Vec<RequiredDrive>>>()?;
                let shapes = asked.iter().zip(&complete).map(|(asked, drive)| (*asked, drive.shape));
                self.last.replace(shapes.collect());
                return Some(complete);
            }
            let of_open = |all: &[Asked]| open.iter().map(|&index| all[index]).collect::<Vec<_>>();
            let guesses: Vec<ResponseShape> = open.iter().map(|&index| shapes[index]).collect();
            let ends = self.ends(&of_open(asked), &guesses, coefficients)?;
            for (index, end) in open.into_iter().zip(ends) {
                let (linear, change) = self.solved(&end, &asked[index], shapes[index])?;
                let size = change.amax();
                let scale = shapes[index].peak.max(shapes[index].cosine.abs()).max(shapes[index].sine.abs());
                if size <= CLOSE * scale {
                    let answer = {
                        let shape = shapes[index].plus(change);
                        linear.required(&end, &asked[index], shape, coefficients[1])
                    };
                    drives[index] = Some(answer);
                } else {
                    // Far from the solution a whole step may lead anywhere.
                    let step = (0.5 * scale / size).min(1.0);
                    shapes[index] = shapes[index].plus(change * step);
                }
            }
        }
        None
    }
}

impl ResponseShape {
    fn plus(self, change: Vector3<f64>) -> Self {
        Self { peak: self.peak + change[0], cosine: self.cosine + change[1], sine: self.sine + change[2] }
    }
}

/// The state after half a period: x, ∫x cos, ∫x sin of the response and of each of its deviations, then their velocities.
struct HalfPeriodState {
    state: Vec<f64>,
    copies: usize,
}

impl HalfPeriodState {
    /// Velocity of the response itself, or of a deviation, counted from one.
    fn velocity(&self, copy: usize) -> f64 {
        self.state[3 * self.copies + copy]
    }

    /// The map of deviations of angle and velocity.
    fn map(&self) -> [[f64; 2]; 2] {
        let last = self.copies - 1;
        [[self.state[3 * (last - 1)], self.state[3 * last]], [self.velocity(last - 1), self.velocity(last)]]
    }

    /// C + iS of the fundamental C cos τ + S sin τ.
    fn fundamental(&self, copy: usize) -> Complex {
        Complex::new(self.state[3 * copy + 1], self.state[3 * copy + 2]).scaled(FRAC_2_PI)
    }
}

/// Linearised conditions of a response, as functions of its shape.
struct Linear {
    measured: MeasuredAmplitude,
    fundamental: Complex,
    inverse: Option<Matrix3<f64>>,
}

impl Linear {
    fn new(end: &HalfPeriodState, measured: MeasuredAmplitude) -> Self {
        let mut linear = Self { measured, fundamental: end.fundamental(0), inverse: None };
        let last = end.copies - 1;
        // By the peak, by p and by q.
        let columns = [last - 1, last - 3, last - 2];
        let matrix = Matrix3::from_columns(&columns.map(|copy| linear.change(end, copy, copy == last - 1)));
        linear.inverse = matrix.try_inverse();
        linear
    }

    /// Derivative of the conditions with respect to a deviation of one copy; `is_peak` for one that begins at another peak.
    fn change(&self, end: &HalfPeriodState, copy: usize, is_peak: bool) -> Vector3<f64> {
        let displacement = if is_peak { 1.0 } else { 0.0 };
        let reached = match self.measured {
            MeasuredAmplitude::Peak => displacement,
            MeasuredAmplitude::Fundamental => along(self.fundamental, end.fundamental(copy)),
        };
        Vector3::new(end.state[3 * copy] + displacement, end.velocity(copy), reached)
    }

    /// The drive of a response with this final shape.
    fn required(
        &self,
        end: &HalfPeriodState,
        asked: &Asked,
        shape: ResponseShape,
        damping: f64,
    ) -> RequiredDrive {
        let square = asked.frequency * asked.frequency;
        let last = end.copies - 1;
        let force = Complex::new(shape.cosine, shape.sine);
        let phase = self.fundamental.scaled(1.0 / self.fundamental.abs());
        let inverse = self.inverse.unwrap_or_else(Matrix3::zeros);
        // The change of the drive with a change of the shape, and a further one of the fundamental.
        let by_shape = |change: Vector3<f64>, beside: Complex| {
            let of_fundamental: Complex =
                [(last - 1, change[0]), (last - 3, change[1]), (last - 2, change[2])]
                    .into_iter()
                    .map(|(copy, part)| end.fundamental(copy).scaled(part))
                    .sum();
            let of_fundamental = of_fundamental + beside;
            let turned = of_fundamental - phase.scaled(along(self.fundamental, of_fundamental));
            let of_phase = turned.scaled(1.0 / self.fundamental.abs());
            (Complex::new(change[1], change[2]) * phase + force * of_phase).scaled(square)
        };
        let by = |copy: usize, unit: f64| {
            let change = -(inverse * self.change(end, copy, false));
            by_shape(change, end.fundamental(copy)).scaled(unit)
        };
        let by_amplitude = by_shape(inverse * Vector3::new(0.0, 0.0, 1.0), Complex::default());
        let mut by_coefficients = vec![by(2, 1.0 / square), by(1, 1.0 / asked.frequency)];
        by_coefficients.extend((last > 6).then(|| by(3, 1.0 / square)));
        RequiredDrive {
            drive: (force * phase).scaled(square),
            by_coefficients,
            by_amplitude,
            stability: stability(end.map(), libm::exp(-PI * damping / asked.frequency), EFFORT.relative),
            shape,
        }
    }
}

/// The component of a change along a complex number.
pub(super) fn along(number: Complex, change: Complex) -> f64 {
    (number.re * change.re + number.im * change.im) / number.abs()
}
