//! Backbone curve: the free oscillations of a driven oscillator, without the drive and without velocities in its force.

use super::point::{BranchPoint, amplitude_of};
use super::response::Response;
use super::undriven::undriven;
use libration_motion::orbit::Orbit;
use libration_numbers::expression::Equation;
use libration_numbers::progress::Quiet;
use std::f64::consts::{PI, TAU};

/// Number of free oscillations on a backbone curve.
const POINTS: u32 = 80;

/// The largest amplitude with the rounding of a turning point, a billionth of a line in a picture.
const ROUNDED: f64 = 1.0 + 1e-9;

/// A free oscillation of a driven system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeOscillation {
    /// The parameter value at which drive and oscillation repeat together.
    pub parameter: f64,
    /// Estimate of the error of the parameter.
    pub error: f64,
    /// The largest displacement, as [`BranchPoint::amplitude`]: at the point of release or at the other turning point.
    pub amplitude: f64,
}

impl Response {
    /// The backbone curve: the free oscillations, up to the largest amplitude of the response, that repeat together with a drive in the range.
    ///
    /// The equation of the free oscillations has no velocities in the force and zero for each sine and cosine of the time; its parameter stays
    /// open. `is_angle` is `true` if the coordinate is an angle, whose oscillations end below π.
    ///
    /// # Domain
    /// One coordinate of second order, and a parameter that is the frequency of the drive: period times
    /// parameter is the same at all points, except for factors of subharmonics, and the free oscillations
    /// do not depend on the parameter. In all other cases, and for rotations, the curve is empty.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_branches as libration;
    /// use libration::continuation::{Response, ResponseOptions};
    /// use libration::progress::Quiet;
    /// let driven = "theta'' = -0.1*theta' - sin(theta) + 0.15*cos(w*t)".parse()?;
    /// let response = Response::over(&driven, "w", [0.6, 1.2], &ResponseOptions::default(), &Quiet)?;
    /// let backbone = response.backbone(&driven, [0.6, 1.2], true);
    /// let exact = |amplitude: f64| -> Result<f64, Box<dyn std::error::Error>> {
    ///     let pendulum = libration::pendulum::Pendulum::from_angular_frequency(1.0)?;
    ///     Ok(std::f64::consts::TAU / pendulum.released_from(libration::quantity::Angle::from_radians(amplitude)?)?.period())
    /// };
    /// assert_eq!(backbone.len(), 80);
    /// for free in backbone {
    ///     assert!((free.parameter - exact(free.amplitude)?).abs() <= free.error && free.error < 1e-13);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn backbone(&self, equation: &Equation, range: [f64; 2], is_angle: bool) -> Vec<FreeOscillation> {
        let (Some(periods), Some(free)) = (self.drive_periods(), undriven(equation)) else { return vec![] };
        let most = self.points().map(|point| point.amplitude(0, is_angle)).fold(0.0, f64::max);
        let most = if is_angle { most.min(0.999 * PI) } else { most };
        let amplitudes = (1..=POINTS).map(|k| most * f64::from(k) / f64::from(POINTS));
        let of_amplitude = |released| {
            // No orbit if the equation still contains the parameter.
            let orbit = Orbit::released(&free, released, &Quiet).ok()?;
            let amplitude = amplitude_of(orbit.range(0).into(), is_angle, false);
            let parameter = periods * orbit.frequency();
            // Two rounding errors of the frequency, and those of the products that give the number of periods.
            let error = parameter * (orbit.period_uncertainty() / orbit.period() + 4.0 * f64::EPSILON);
            Some(FreeOscillation { parameter, error, amplitude })
        };
        let within = range[0].min(range[1])..=range[0].max(range[1]);
        let is_shown =
            |point: &FreeOscillation| within.contains(&point.parameter) && point.amplitude <= most * ROUNDED;
        amplitudes.filter_map(of_amplitude).filter(is_shown).collect()
    }

    fn points(&self) -> impl Iterator<Item = &BranchPoint> {
        self.branches.iter().flat_map(|branch| &branch.points)
    }

    /// Period times parameter over 2π at the first point, if the parameter is the frequency of the drive and no coordinate rotates.
    fn drive_periods(&self) -> Option<f64> {
        let product = |point: &BranchPoint| point.period * point.parameter / TAU;
        let first = product(self.points().next().filter(|_| self.driven)?);
        let is_whole = |ratio: f64| (ratio - libm::rint(ratio)).abs() < 1e-9;
        let is_frequency = |point: &BranchPoint| {
            let ratio = product(point) / first;
            point.rotation.is_none() && (is_whole(ratio) || is_whole(1.0 / ratio))
        };
        self.points().all(is_frequency).then_some(first)
    }
}
