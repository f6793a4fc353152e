//! The saddle orbit: the periodic motion about the upright position of a perturbed pendulum.

use std::f64::consts::TAU;

use super::TangencyError;
use libration_kernels::elementary::count;
use libration_numbers::algebra::{Complex, Doubles};
use libration_numbers::{
    expression::{Equation, Symbol},
    internals::expression::{Jet, Tape},
};

/// Number of times in a period of the drive.
const PLACES: usize = 96;
/// Number of harmonics, a quarter of that of times: only harmonics from the 72nd on are taken for one of these.
const HARMONICS: usize = 24;
/// Largest distance from the upright position, beyond which the perturbation is not weak.
const FARTHEST: f64 = 1.5;

/// The motion about the upright position as harmonics of the drive: Re Σ cₖ·e^{ikΩt}.
pub(super) struct Saddle {
    upright: f64,
    frequency: f64,
    harmonics: Vec<Complex>,
}

impl Saddle {
    /// With θ = upright + y, y″ − ω0²y = θ″ − ω0²y; the left side is inverted harmonic
    /// by harmonic. The right side is small, so that the iteration converges.
    pub(super) fn new(
        equation: &Equation,
        upright: f64,
        [omega0, frequency]: [f64; 2],
    ) -> Result<Self, TangencyError> {
        const ROUNDS: usize = 400;
        /// Largest last change, in radians: the iteration contracts, and the start on the manifold, not this, sets the error of a tangency.
        const ENOUGH: f64 = 1e-12;
        let angle = Symbol::plain(&equation.variables()[0]);
        let inputs = [angle.clone(), angle.with_primes(1), Symbol::plain("t")];
        let tape = Tape::new(&[&equation.accelerations()[0]], &inputs)?;
        let mut saddle = Self { upright, frequency, harmonics: vec![Complex::default(); HARMONICS + 1] };
        for _ in 0..ROUNDS {
            let force = |j: usize| {
                let time = TAU / frequency * count(j) / count(PLACES);
                let [angle, velocity] = saddle.state_at(time);
                let jet = Jet::new(&Doubles, &tape, &[angle, velocity, time]);
                jet.map_or(f64::NAN, |jet| jet.result(0)[0]) - omega0 * omega0 * (angle - upright)
            };
            let forces: Vec<f64> = (0..PLACES).map(force).collect();
            let harmonic = |k: usize| {
                let turn = |j: usize| Complex::unit(-TAU * count(j * k % PLACES) / count(PLACES));
                let sum: Complex = forces.iter().enumerate().map(|(j, force)| turn(j).scaled(*force)).sum();
                let wave = count(k) * frequency;
                sum.scaled(
                    -if k == 0 { 1.0 } else { 2.0 } / (count(PLACES) * (omega0 * omega0 + wave * wave)),
                )
            };
            let harmonics: Vec<Complex> = (0..=HARMONICS).map(harmonic).collect();
            let change: f64 =
                harmonics.iter().zip(&saddle.harmonics).map(|(new, old)| (*new - *old).abs()).sum();
            let size: f64 = harmonics.iter().map(|harmonic| harmonic.abs()).sum();
            saddle.harmonics = harmonics;
            if size.is_nan() || size > FARTHEST {
                break;
            }
            if change < ENOUGH {
                return Ok(saddle);
            }
        }
        Err(TangencyError::NoSaddle)
    }

    /// Angle and velocity at a time.
    pub(super) fn state_at(&self, time: f64) -> [f64; 2] {
        let term = |(k, harmonic): (usize, &Complex)| {
            let wave = count(k) * self.frequency;
            let value = *harmonic * Complex::unit(wave * time);
            [value.re, -wave * value.im]
        };
        let terms = self.harmonics.iter().enumerate().map(term);
        terms.fold([self.upright, 0.0], |[angle, velocity], [a, v]| [angle + a, velocity + v])
    }
}
