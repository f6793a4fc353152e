//! The pendulum's motion for Python objects.

use libration::pendulum::{FourierSeries, Motion, Pendulum, PendulumError as NoPendulum};
use libration::quantity::Dimension;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::errors::{PendulumError, refusal};
use crate::quantity::{Given, angle, quantity};

/// Length and gravity in SI units, for a valid pendulum, with its angular frequency and period of small swings.
#[pyfunction]
pub(crate) fn pendulum(py: Python<'_>, length: Given, gravity: Given) -> PyResult<(f64, f64, f64, f64)> {
    let length = quantity(py, "length", &length, Dimension::Length)?;
    let gravity = quantity(py, "gravity", &gravity, Dimension::Acceleration)?;
    let pendulum = Pendulum::new(length, gravity).map_err(|error| refused(py, &error))?;
    Ok((length, gravity, pendulum.angular_frequency(), pendulum.small_angle_period()))
}

/// The error with the names of the arguments that caused it.
fn refused(py: Python<'_>, error: &NoPendulum) -> PyErr {
    let parameters: &[&str] = match error {
        NoPendulum::NotPositive { name, .. } | NoPendulum::NotFinite { name, .. } => &[name],
        NoPendulum::OutOfRange { .. } => &["length", "gravity"],
        NoPendulum::TooFast(_) | NoPendulum::TooCloseToSeparatrix => &["velocity"],
        NoPendulum::TooCloseToTop(_) => &["angle"],
        _ => &[],
    };
    let exception = refusal::<PendulumError>(error);
    let set = exception.value(py).setattr("parameters", parameters.to_vec());
    set.err().unwrap_or(exception)
}

/// A motion, prepared.
#[pyclass(frozen, name = "Motion", module = "libration._native")]
pub(crate) struct NativeMotion(Motion);

/// n, and the coefficients of angle and velocity.
type HarmonicArrays<'py> = (Bound<'py, PyArray1<i64>>, Numbers<'py>, Numbers<'py>);
type Numbers<'py> = Bound<'py, PyArray1<f64>>;

#[pymethods]
impl NativeMotion {
    /// A motion from its angle and velocity.
    #[new]
    fn new(py: Python<'_>, length: f64, gravity: f64, start: (Given, Given)) -> PyResult<Self> {
        let angle = angle(py, "angle", &start.0)?;
        let velocity = quantity(py, "velocity", &start.1, Dimension::AngularVelocity)?;
        let pendulum = Pendulum::new(length, gravity).map_err(|error| refused(py, &error))?;
        Ok(Self(pendulum.launched(angle, velocity).map_err(|error| refused(py, &error))?))
    }

    #[getter]
    fn regime(&self) -> String {
        self.0.regime().to_string()
    }

    #[getter]
    fn period(&self) -> f64 {
        self.0.period()
    }

    /// The amplitude and its complement.
    #[getter]
    fn amplitude(&self) -> Option<(f64, f64)> {
        self.0.amplitude().map(|amplitude| (amplitude.radians(), amplitude.complement()))
    }

    /// e and e − 1.
    #[getter]
    fn energy_ratio(&self) -> (f64, f64) {
        (self.0.energy_ratio(), self.0.energy_excess())
    }

    #[getter]
    fn action(&self) -> f64 {
        self.0.action()
    }

    /// Angles and velocities.
    fn states_at<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Numbers<'py>, Numbers<'py>)> {
        let times = times.as_slice()?;
        let (mut angles, mut velocities) = (vec![0.0; times.len()], vec![0.0; times.len()]);
        py.detach(|| self.0.states_at(times, &mut angles, &mut velocities))
            .map_err(refusal::<PendulumError>)?;
        Ok((angles.into_pyarray(py), velocities.into_pyarray(py)))
    }

    /// Fundamental, mean velocity, epoch, and the terms.
    fn harmonics<'py>(
        &self,
        py: Python<'py>,
        tolerance: f64,
        limit: usize,
    ) -> ((f64, f64, f64), HarmonicArrays<'py>) {
        let FourierSeries { fundamental, mean_velocity, epoch, terms } =
            py.detach(|| self.0.harmonics(tolerance, limit));
        let number: Vec<i64> = terms.iter().map(|term| i64::try_from(term.n).unwrap_or(i64::MAX)).collect();
        let angle: Vec<f64> = terms.iter().map(|term| term.angle).collect();
        let velocity: Vec<f64> = terms.iter().map(|term| term.velocity).collect();
        let terms = (number.into_pyarray(py), angle.into_pyarray(py), velocity.into_pyarray(py));
        ((fundamental, mean_velocity, epoch), terms)
    }
}
