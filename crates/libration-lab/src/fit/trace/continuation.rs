//! A fitted swing continued after its last row, as [`libration::decay`] describes it.

use std::f64::consts::{PI, TAU};

use super::swing::{Course, EXACT, Swing, turning_point};
use super::{DampingKind, Parameter, ParameterKind, TraceFit};
use crate::fit::uncertain::Uncertain;
use crate::measurement::Observable;
use libration::decay::{Damping, Decay, DecayError, TurningPoint};
use libration::pendulum::{Pendulum, PendulumError};
use libration::quantity::Angle;

/// A fitted swing from one of its turning points on.
#[derive(Clone, Debug)]
pub struct FittedDecay {
    /// Time of that turning point, in the clock of the trace, in s.
    pub start: f64,
    /// The release from that turning point.
    pub decay: Decay,
}

/// Time and amplitude of a turning point of a fitted swing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedTurningPoint {
    /// Time in the clock of the trace, in s.
    pub time: Uncertain,
    /// Angle from the bottom, in radians.
    pub amplitude: Uncertain,
}

/// Reasons why a fitted swing cannot be continued.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ContinuationError {
    /// An index that is not one of a trace; traces are counted from zero.
    #[error("the fit has {traces} traces and none with the number {trace}: count from zero")]
    NoTrace {
        /// The given index.
        trace: usize,
        /// Number of traces.
        traces: usize,
    },
    /// The pendulum comes to rest before it turns, or goes over the top for as long as a hundred periods.
    #[error("the fitted motion does not turn after the first row: give a trace that swings to and fro")]
    DoesNotTurn,
    /// A frequency or an angle that no pendulum has.
    #[error(transparent)]
    Pendulum(#[from] PendulumError),
    /// A damping that `decay` rejects: none at all, or a coefficient below zero.
    #[error(transparent)]
    Decay(#[from] DecayError),
}

/// Longest search for a turning point, in periods of small swings. A swing turns within 12 of them even from 1e-15 below the top, (2/π)·ln(8e15)/2;
/// a motion that rotates longer is not a swing.
const LONGEST: f64 = 100.0;
/// Step of differences relative to an uncertainty, upwards, since coefficients of damping are never negative: a derivative that changes by a
/// tenth over an uncertainty errs by half a hundredth.
const STEP: f64 = 0.1;

impl TraceFit {
    /// The fitted damping in the form of [`libration::decay`].
    ///
    /// # Errors
    /// Fails for a model without damping, or with a coefficient below zero.
    pub fn decay_damping(&self) -> Result<Damping, DecayError> {
        self.motion_parameters(0).damping()
    }

    /// The swing of a trace from a turning point on, the first that is a quarter of a period after the first row. Its `decay`
    /// gives the amplitude at any time, all turning points, and the end of the motion.
    ///
    /// # Errors
    /// Fails for an unknown trace, a model without damping or with a coefficient below zero, and a motion that does not turn.
    ///
    /// # Examples
    /// ```
    /// use libration::decay::{Damping, Decay, EnvelopeLaw};
    /// use libration::pendulum::Pendulum;
    /// use libration_lab::fit::trace::{TraceOptions, fit_traces};
    /// use libration_lab::measurement::{Observable, Trace};
    /// use libration::progress::Quiet;
    ///
    /// // Ten seconds of a swing that falls from 0.2 rad by exp(−0.01 t), by the law of small amplitudes.
    /// let angle = |time: f64| 0.2 * (-0.01 * time).exp() * (3.0 * time).cos();
    /// let times: Vec<f64> = (0..400).map(|row| 0.025 * f64::from(row)).collect();
    /// let angles = times.iter().map(|&time| angle(time)).collect();
    /// let trace = Trace::new("small", Observable::Angle, times, angles, None)?;
    /// let go_on = &Quiet;
    /// let fit = fit_traces(&[trace], "linear".parse()?, &TraceOptions::default(), go_on)?;
    /// let continued = fit.decay(0)?;
    /// let after_a_minute = continued.decay.envelope(EnvelopeLaw::Averaged).amplitude_at(60.0 - continued.start);
    /// assert!((after_a_minute / 0.2 / (-0.6_f64).exp() - 1.0).abs() < 0.02);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn decay(&self, trace: usize) -> Result<FittedDecay, ContinuationError> {
        let begins = self.begin(trace)?;
        let mut decay = self.motion_parameters(trace).decay()?;
        decay.start += begins;
        Ok(decay)
    }

    /// The turning points of a trace from that of [`decay`](Self::decay) to a time of its clock, which may be after its end, with the uncertainty
    /// by the parameters. They depend on the damping model.
    ///
    /// # Errors
    /// Fails as [`decay`](Self::decay) does.
    pub fn turning_points(
        &self,
        trace: usize,
        until: f64,
    ) -> Result<Vec<FittedTurningPoint>, ContinuationError> {
        let begins = self.begin(trace)?;
        let parameters = self.motion_parameters(trace);
        let turning_points = parameters.turns(until - begins)?;
        let moved = (0..parameters.places.len()).map(|index| {
            let step = STEP * self.parameters[parameters.places[index]].estimate.uncertainty;
            parameters.moved(index, step).turns(until - begins + TAU / parameters.values[0])
        });
        let moved = moved.collect::<Result<Vec<_>, _>>()?;
        let apart = 0.5 * PI / parameters.values[0];
        let with_uncertainty = |[time, amplitude]: [f64; 2]| {
            let changes: Option<Vec<[f64; 2]>> =
                moved.iter().map(|turns| change(turns, [time, amplitude], apart)).collect();
            let deviation = |of: usize| Some(self.deviation(&parameters.places, changes.as_ref()?, of));
            let [of_time, of_amplitude] = [deviation(0)?, deviation(1)?];
            Some(FittedTurningPoint {
                time: Uncertain { value: begins + time, uncertainty: of_time },
                amplitude: Uncertain { value: amplitude, uncertainty: of_amplitude },
            })
        };
        Ok(turning_points.into_iter().map_while(with_uncertainty).collect())
    }

    fn begin(&self, trace: usize) -> Result<f64, ContinuationError> {
        let missing = ContinuationError::NoTrace { trace, traces: self.traces.len() };
        self.traces.get(trace).map(|trace| trace.start_time).ok_or(missing)
    }

    /// The standard deviation of a value, from its changes with one standard uncertainty of each parameter.
    fn deviation(&self, indices: &[usize], changes: &[[f64; 2]], of: usize) -> f64 {
        let product = |(i, &a): (usize, &usize)| -> f64 {
            let row = indices.iter().zip(changes).map(|(&b, change)| self.correlations[a][b] * change[of]);
            changes[i][of] * row.sum::<f64>()
        };
        indices.iter().enumerate().map(product).sum::<f64>().max(0.0).sqrt()
    }

    fn motion_parameters(&self, trace: usize) -> MotionParameters {
        let is_of_motion = |parameter: &Parameter| {
            let is_of_reading = matches!(parameter.kind, ParameterKind::Scale | ParameterKind::Offset);
            !is_of_reading && parameter.trace.is_none_or(|of| of == trace)
        };
        let numbered = self.parameters.iter().enumerate();
        let of_motion = numbered.filter(|(_, parameter)| is_of_motion(parameter));
        let (indices, values) = of_motion.map(|(index, parameter)| (index, parameter.estimate.value)).unzip();
        MotionParameters { terms: self.damping.iter().collect(), places: indices, values }
    }
}

/// Change of the turning point nearest to this one, per standard uncertainty of the parameter; `None` if there is none nearby.
fn change(turns: &[[f64; 2]], [time, amplitude]: [f64; 2], apart: f64) -> Option<[f64; 2]> {
    let nearest = turns.iter().min_by(|a, b| (a[0] - time).abs().total_cmp(&(b[0] - time).abs()))?;
    let differs = [nearest[0] - time, nearest[1] - amplitude];
    (differs[0].abs() < apart).then(|| differs.map(|difference| difference / STEP))
}

/// ω0, the coefficients of the damping, the first angle and the first velocity of a trace.
struct MotionParameters {
    terms: Vec<DampingKind>,
    /// Indices among the parameters of the fit.
    places: Vec<usize>,
    values: Vec<f64>,
}

impl MotionParameters {
    fn moved(&self, index: usize, step: f64) -> Self {
        let mut values = self.values.clone();
        values[index] += step;
        Self { terms: self.terms.clone(), places: self.places.clone(), values }
    }

    fn coefficients(&self) -> &[f64] {
        &self.values[1..=self.terms.len()]
    }

    fn damping(&self) -> Result<Damping, DecayError> {
        let term = |(kind, &coefficient): (&DampingKind, &f64)| kind.term(coefficient);
        Damping::new(&self.terms.iter().zip(self.coefficients()).map(term).collect::<Vec<_>>())
    }

    /// Returns the decay with the time of the release after the first row.
    fn decay(&self) -> Result<FittedDecay, ContinuationError> {
        let damping = self.damping()?;
        let [start, angle] = self.turning_point().ok_or(ContinuationError::DoesNotTurn)?;
        let angle = angle - TAU * libm::round(angle / TAU);
        let angle = Angle::from_radians(angle).map_err(|_| ContinuationError::DoesNotTurn)?;
        let pendulum = Pendulum::from_angular_frequency(self.values[0])?;
        Ok(FittedDecay { start, decay: Decay::new(pendulum, damping, angle)? })
    }

    /// The first turning point a quarter of a period after the first row, before which a motion that is released there may turn or not,
    /// by the error of its velocity.
    fn turning_point(&self) -> Option<[f64; 2]> {
        let (omega0, first) = (self.values[0], self.terms.len() + 1);
        let terms = self.terms.iter().copied().collect();
        let quarter = 0.5 * PI / omega0;
        let start = [self.values[first], self.values[first + 1]];
        let (swing, times) = (Swing::new(terms), [0.0, quarter]);
        let courses = [Observable::Angle, Observable::AngularVelocity].map(|observable| Course {
            omega0,
            coefficients: self.coefficients(),
            start,
            times: &times,
            observable,
        });
        let seen = swing.seen(&courses, &EXACT)?;
        let state = [0, 1].map(|component| seen[component].values[1]);
        let longest = LONGEST * TAU / omega0;
        let [time, angle] = turning_point(terms, omega0, self.coefficients(), state, longest)?;
        Some([quarter + time, angle])
    }

    /// Times after the first row with amplitudes.
    fn turns(&self, until: f64) -> Result<Vec<[f64; 2]>, ContinuationError> {
        let FittedDecay { start, decay } = self.decay()?;
        let pair = |turn: TurningPoint| [start + turn.time, turn.amplitude.radians()];
        let mut turns = vec![];
        for turn in decay.swings() {
            let turn = pair(turn?);
            if turn[0] > until {
                break;
            }
            turns.push(turn);
        }
        Ok(turns)
    }
}
