//! The curve of a fit: all responses over a range of frequencies, and the jumps between them.

use super::MeasuredAmplitude;
use super::fitted::ResponseFit;
use super::required_drive::{AllHarmonics, Asked, DriveMethod, EFFORT, along, scaled};
use crate::fit::uncertain::Uncertain;
use libration::algebra::Complex;
use libration::continuation::{BranchError, BranchPoint, Jump, Response, ResponseOptions};
use libration::internals::InOrder;
use libration::orbit::Stability;
use libration::progress::{Progress, Quiet};
use libration::taylor::{Moment, System, Trajectory};
use std::f64::consts::{PI, TAU};

/// A response on the curve of a fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedCurvePoint {
    /// Drive frequency, in rad/s.
    pub frequency: f64,
    /// Amplitude as defined by the measurement.
    pub amplitude: f64,
    /// Phase lag of the response's fundamental behind the drive, in radians.
    pub phase: f64,
    /// The behaviour of small deviations.
    pub stability: Stability,
}

/// A frequency at which a slow sweep jumps to another branch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedJump {
    /// Drive frequency, in rad/s.
    pub frequency: Uncertain,
    /// The largest displacement before the jump.
    pub amplitude: f64,
    /// The largest displacement after the jump, where the response that is reached has the period of the drive.
    pub to_amplitude: Option<f64>,
    /// `true` if the jump occurs while the frequency rises.
    pub rising: bool,
}

/// All responses of a fit, and its jumps.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FittedCurve {
    /// Branches, each with its points in their order along it.
    pub branches: Vec<Vec<FittedCurvePoint>>,
    /// Jumps by rising frequency.
    pub jumps: Vec<FittedJump>,
}

impl ResponseFit {
    /// Computes the responses with the period of the drive from one frequency to another, in rad/s.
    ///
    /// # Errors
    /// Fails as [`Response::over`] does.
    pub fn curve(&self, range: [f64; 2], progress: &dyn Progress) -> Result<FittedCurve, BranchError> {
        let equation = self.model.with_frequency_open(&self.parameters());
        let options = ResponseOptions { generations: 0, ..ResponseOptions::default() };
        let response = Response::over(&equation, "w", range, &options, progress)?;
        let branches = response.branches.iter().map(|branch| {
            let special = branch.special.iter().map(|special| (special.before, &special.point));
            let mut points: Vec<(usize, &BranchPoint)> = special.collect();
            points.extend(branch.points.iter().enumerate());
            // A special point stands before the one with its index.
            points.put_in_order_by(|(number, _)| *number);
            points.into_iter().filter_map(|(_, point)| self.on_curve(point)).collect()
        });
        Ok(FittedCurve { branches: branches.collect(), jumps: self.jumps(&response) })
    }

    fn on_curve(&self, point: &BranchPoint) -> Option<FittedCurvePoint> {
        let fundamental = self.fundamental(point)?;
        let amplitude = match self.measured {
            MeasuredAmplitude::Peak => point.amplitude(0, false),
            MeasuredAmplitude::Fundamental => fundamental.abs(),
        };
        Some(FittedCurvePoint {
            frequency: point.parameter,
            amplitude,
            phase: fundamental.argument(),
            stability: point.stability,
        })
    }

    /// The amplitude of the fundamental, and as argument its lag: the integral of x·e^{iΩt} over a period of the drive.
    fn fundamental(&self, point: &BranchPoint) -> Option<Complex> {
        let parameters = self.parameters();
        let (drive, coefficients) = parameters.split_last()?;
        let square = point.parameter * point.parameter;
        let names = self.model.names();
        let system = System::with_parameters(&self.model.in_phase_of_drive(), names).ok()?;
        let state = vec![point.state[0], 0.0, 0.0, point.state[1] / point.parameter];
        let values = scaled(coefficients, point.parameter).chain([drive / square, 0.0]).collect();
        let start = Moment { time: 0.0, state };
        let end = Trajectory { start, parameters: values, times: &[TAU] }
            .integrate(&system, &EFFORT, &Quiet)
            .ok()?
            .end;
        Some(Complex::new(end.state[1], end.state[2]).scaled(1.0 / PI))
    }

    /// Jumps at the folds, where the required drive does not change with the amplitude: there dΩ = −(dZ by the parameters)/(∂Z/∂Ω).
    fn jumps(&self, response: &Response) -> Vec<FittedJump> {
        let law = AllHarmonics::new(self.model, MeasuredAmplitude::Peak);
        let jump = |jump: &Jump| {
            let (value, amplitude) = (jump.from.parameter, jump.from.amplitude(0, false));
            let uncertainty = self.deviation_of_fold(&law, value, amplitude)?;
            let frequency = Uncertain { value, uncertainty };
            let to_amplitude = jump.to.first().map(|to| to.amplitude(0, false));
            Some(FittedJump { frequency, amplitude, to_amplitude, rising: jump.rising })
        };
        let mut jumps: Vec<FittedJump> = response.jumps.iter().filter_map(jump).collect();
        jumps.put_in_order(|a, b| a.frequency.value.total_cmp(&b.frequency.value));
        jumps
    }

    fn deviation_of_fold(&self, law: &AllHarmonics, frequency: f64, amplitude: f64) -> Option<f64> {
        let parameters = self.parameters();
        let (_, coefficients) = parameters.split_last()?;
        let asked = Asked { frequency, amplitude };
        let required = law.required(&[asked], coefficients)?.pop()?;
        let radial = |change| along(required.drive, change);
        let mut gradient: Vec<f64> =
            required.by_coefficients.iter().map(|coefficient| radial(*coefficient)).collect();
        gradient.push(-1.0);
        Some(self.deviation(&gradient) / radial(required.by_frequency(&asked, coefficients)).abs())
    }
}
