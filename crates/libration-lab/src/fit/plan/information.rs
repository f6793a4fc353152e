//! Information of rows of angles about ω0.
//!
//! A swing θ ≈ A cos φ, with A = A0·exp(−bt/2) and φ′ = ω0/R(A), depends on ln ω0, φ0, ln A0 and bT. A row with the error σ adds
//! ∂ᵢθ·∂ⱼθ/σ² to their Fisher information; over a swing cos² φ and sin² φ are a half each and their product is nothing, so that f rows
//! a second give
//!
//! Fᵢⱼ = (f/2σ²)·∫ A²·(aᵢaⱼ + pᵢpⱼ) dt,  aᵢ = ∂ᵢ ln A,  pᵢ = ∂ᵢφ.
//!
//! With the condition c = dlnR/dlnA of the period: a = (0, 0, 1, −t/2T) and p = (∫ω0/R, 1, −∫ω0c/R, ∫(t/2T)·ω0c/R). Angles that are
//! all too large by a part s make a phase error of s·p₃, and the resulting error of ω0 is the least-squares solution for it.

use super::PlannedRecording;
use libration::pendulum::Amplitude;
use libration::quantity::Angle;
use nalgebra::{Matrix4, Vector4};

/// Number of parts of the recording: the amplitude changes slowly.
const PLACES: u32 = 128;

/// The relative uncertainty of ω0, and its relative change with the scale of the angles.
pub(super) fn of_frequency(recording: &PlannedRecording, amplitude: &Amplitude, duration: f64) -> [f64; 2] {
    let way = RecordingParts::new(recording, amplitude, duration);
    let weight = recording.rate / (2.0 * recording.angle_noise * recording.angle_noise);
    let (mut information, mut wrong) = (Matrix4::zeros(), Vector4::zeros());
    for segment in way {
        let square = segment.amplitude * segment.amplitude * weight * duration / f64::from(PLACES);
        let by_amplitude = Vector4::new(0.0, 0.0, 1.0, -segment.part / 2.0);
        let by_phase = segment.by_phase;
        information += square * (by_amplitude * by_amplitude.transpose() + by_phase * by_phase.transpose());
        wrong += square * by_phase[2] * by_phase;
    }
    match information.cholesky() {
        Some(factor) => [factor.inverse()[(0, 0)].sqrt(), factor.solve(&wrong)[0]],
        None => [f64::INFINITY, f64::INFINITY],
    }
}

/// The part of the recording around one time.
struct Place {
    /// Position in the recording, from 0 to 1.
    part: f64,
    amplitude: f64,
    /// Derivatives of the phase.
    by_phase: Vector4<f64>,
}

/// Iterator over the parts of the recording.
struct RecordingParts<'a> {
    recording: &'a PlannedRecording,
    first: f64,
    duration: f64,
    done: u32,
    /// ∫ω0/R, ∫ω0c/R and ∫(t/2T)·ω0c/R up to the next part.
    integrals: [f64; 3],
}

impl<'a> RecordingParts<'a> {
    fn new(recording: &'a PlannedRecording, amplitude: &Amplitude, duration: f64) -> Self {
        Self { recording, first: amplitude.radians(), duration, done: 0, integrals: [0.0; 3] }
    }
}

impl Iterator for RecordingParts<'_> {
    type Item = Place;

    fn next(&mut self) -> Option<Place> {
        if self.done == PLACES {
            return None;
        }
        let part = (f64::from(self.done) + 0.5) / f64::from(PLACES);
        let decay = self.recording.linear_damping * part * self.duration / 2.0;
        let amplitude = self.first * libm::exp(-decay);
        // Amplitudes that have fallen to nearly zero count as small swings.
        let swing = Angle::from_radians(amplitude).ok().and_then(|angle| Amplitude::new(angle).ok());
        let (ratio, condition) = swing.map_or((1.0, 0.0), |swing| (swing.period_ratio(), swing.condition()));
        let half = self.recording.angular_frequency() / ratio * self.duration / f64::from(2 * PLACES);
        let rates = [half, half * condition, half * condition * part / 2.0];
        let middle = [0, 1, 2].map(|n| self.integrals[n] + rates[n]);
        self.integrals = [0, 1, 2].map(|n| middle[n] + rates[n]);
        self.done += 1;
        Some(Place { part, amplitude, by_phase: Vector4::new(middle[0], 1.0, -middle[1], middle[2]) })
    }
}
