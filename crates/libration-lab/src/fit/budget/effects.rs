//! Effects that make g differ from 4π²L/T0²: the moment of inertia over the torque of a ball on a rod in air.
//!
//! In units of mL² and mgL the moment is 1 + 2r²/5L² + μλ²/3 + kσ and the torque 1 + μλ/2 − σ, with μ the mass of the rod over
//! that of the bob, λ its length over L, σ the density of the air over that of the bob, and k the mass of the air that
//! moves along over that displaced.

use std::f64::consts::{PI, TAU};

use libration::pendulum::period_ratio;

/// The kinematic viscosity of air at 20 °C, in m²/s.
const VISCOSITY_OF_AIR: f64 = 1.51e-5;

/// Effect of a budget's row, other than length and time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Effect {
    Amplitude,
    Buoyancy,
    AddedMass,
    FiniteBob,
    Rod,
    Stretch,
    Damping,
}

/// Everything that g is computed from, with zero for what is not known. Units are SI.
#[derive(Clone, Copy, Debug)]
pub(super) struct Values {
    pub(super) length: f64,
    /// Period of small swings by the clock's reading.
    pub(super) t0: f64,
    /// Factor by which all times are to be multiplied.
    pub(super) clock: f64,
    /// Factor by which the times are to be multiplied because all readings begin or end late alike.
    pub(super) shared_timing: f64,
    /// Factor by which T0 is to be multiplied where the model is another.
    pub(super) model: f64,
    pub(super) amplitude: f64,
    /// Factor by which all angles are to be multiplied; T0 was found with 1.
    pub(super) angle_scale: f64,
    pub(super) radius: f64,
    pub(super) bob_mass: f64,
    /// Density of the bob; computed from mass and radius where it is zero.
    pub(super) bob_density: f64,
    pub(super) rod_mass: f64,
    /// Length of the rod; to the surface of the bob where it is zero.
    pub(super) rod_length: f64,
    pub(super) air_density: f64,
    /// Factor by which the added mass is multiplied.
    pub(super) added_mass: f64,
    pub(super) stretch: f64,
    pub(super) damping: f64,
}

impl Values {
    /// Computes g with all effects but one.
    pub(super) fn gravity_without(&self, left_out: Option<Effect>) -> f64 {
        let on = |effect: Effect| if left_out == Some(effect) { 0.0 } else { 1.0 };
        let air = self.air_over_bob();
        let (mass, length) = (self.rod_over_bob(), self.rod_length_over_length());
        let moment = 1.0
            + on(Effect::FiniteBob) * 0.4 * square(self.radius / self.length)
            + on(Effect::Rod) * mass * length * length / 3.0
            + on(Effect::AddedMass) * self.added_mass_over_displaced() * air;
        let torque = 1.0 + on(Effect::Rod) * 0.5 * mass * length - on(Effect::Buoyancy) * air;
        let frequency = TAU / self.period();
        let ideal = frequency * frequency * self.length / self.amplitude_correction(left_out);
        let stretch = 1.375 * (self.stretch / self.length) * square(self.amplitude);
        let damping = square(0.5 * self.damping / frequency);
        ideal * moment / torque
            * (1.0 + on(Effect::Stretch) * stretch)
            * (1.0 + on(Effect::Damping) * damping)
    }

    pub(super) fn gravity(&self) -> f64 {
        self.gravity_without(None)
    }

    /// T0 in true seconds.
    fn period(&self) -> f64 {
        self.t0 * self.clock * self.shared_timing * self.model
    }

    /// Divisor of g: T0 was corrected for the amplitude as it was read, and the true one is `angle_scale` times that.
    fn amplitude_correction(&self, left_out: Option<Effect>) -> f64 {
        let read = period_ratio(self.amplitude);
        if left_out == Some(Effect::Amplitude) {
            return read * read;
        }
        square(read / period_ratio(self.amplitude * self.angle_scale))
    }

    /// σ.
    pub(super) fn air_over_bob(&self) -> f64 {
        let volume = 4.0 / 3.0 * PI * self.radius * self.radius * self.radius;
        match (self.bob_density > 0.0, self.bob_mass > 0.0) {
            (true, _) => self.air_density / self.bob_density,
            (_, true) => self.air_density * volume / self.bob_mass,
            _ => 0.0,
        }
    }

    /// k of a ball that swings little: 1/2 of ideal flow and what a layer of viscous air adds, 9δ/4r with δ² = 2ν/ω.
    pub(super) fn added_mass_over_displaced(&self) -> f64 {
        self.added_mass * (0.5 + self.viscous_part())
    }

    /// Relative uncertainty of the added mass: half of the viscous part, as flow about a bob that swings further than its radius is not ideal or
    /// laminar.
    pub(super) fn uncertainty_of_added_mass(&self) -> f64 {
        if self.radius > 0.0 { 0.5 * self.viscous_part() / self.added_mass_over_displaced() } else { 0.5 }
    }

    fn viscous_part(&self) -> f64 {
        if self.radius > 0.0 { 2.25 * self.layer() / self.radius } else { 0.0 }
    }

    /// δ.
    pub(super) fn layer(&self) -> f64 {
        (2.0 * VISCOSITY_OF_AIR * self.period() / TAU).sqrt()
    }

    /// μ.
    pub(super) fn rod_over_bob(&self) -> f64 {
        if self.bob_mass > 0.0 { self.rod_mass / self.bob_mass } else { 0.0 }
    }

    /// λ.
    pub(super) fn rod_length_over_length(&self) -> f64 {
        let length = if self.rod_length > 0.0 { self.rod_length } else { self.length - self.radius };
        length / self.length
    }
}

fn square(x: f64) -> f64 {
    x * x
}
