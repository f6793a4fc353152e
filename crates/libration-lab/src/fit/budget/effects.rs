//! Effects that make g differ from 4π²L/T0²: the moment of inertia over the torque of a bob on a rod in air.
//!
//! In units of mL² and mgL the moment is 1 + κ/L² + μλ²/3 + kσ and the torque 1 + μλ/2 − σ, with κ the moment of inertia of the bob over its mass
//! (2r²/5 of a ball), μ the mass of the rod over that of the bob, λ its length over L, σ the density of the air over that of the bob, and k the
//! mass of the air that moves along over that displaced.
//!
//! A support that yields horizontally with the stiffness K moves by x = Mω²s/(K − Mω²) at the angular frequency ω, M being the whole mass and s the
//! excursion of its centre relative to the pivot; the moment is larger by u/(1 − u) of M times the square of the distance of that centre, with
//! u = Mω²/K. Without a rod and with a small bob the length is in effect L + mg/K. A knife edge of radius ρ that rolls on a plane raises the
//! centre of mass as if it were ρ further from the axis: the torque is larger by (1 + μ)ρ/L. Both are exact for small swings.

use std::f64::consts::TAU;

use super::bob::{BobShape, Size};
use libration::pendulum::period_ratio;

/// The kinematic viscosity of air at 20 °C, in m²/s.
const VISCOSITY_OF_AIR: f64 = 1.51e-5;

/// Effect of a budget's row, other than length and time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::fit) enum BudgetEffect {
    Amplitude,
    Buoyancy,
    AddedMass,
    FiniteBob,
    Rod,
    Stretch,
    Damping,
    Temperature,
    Support,
    KnifeEdge,
}

/// All quantities from which g is computed, zero for unknown ones, in SI units.
#[derive(Clone, Copy, Debug)]
pub(in crate::fit) struct Values {
    pub(super) length: f64,
    /// Period of small swings by the clock's reading.
    pub(super) t0: f64,
    /// Factor by which all times are to be multiplied.
    pub(in crate::fit) clock: f64,
    /// Factor by which the times are to be multiplied because of the common error of all readings.
    pub(in crate::fit) shared_timing: f64,
    /// Factor by which all angles are to be multiplied; T0 was determined with 1.
    pub(super) model: f64,
    pub(super) amplitude: f64,
    /// Factor by which all angles are to be multiplied; T0 was found with 1.
    pub(super) angle_scale: f64,
    pub(in crate::fit) bob: Size,
    pub(super) bob_mass: f64,
    /// Density of the bob; computed from mass and size where it is zero.
    pub(super) bob_density: f64,
    pub(super) rod_mass: f64,
    /// Length of the rod; zero for a rod that reaches to the surface of the bob.
    pub(super) rod_length: f64,
    pub(super) air_density: f64,
    /// Factor by which the added mass is multiplied.
    pub(super) added_mass: f64,
    pub(super) stretch: f64,
    pub(super) damping: f64,
    pub(super) expansion: f64,
    pub(super) warming: f64,
    /// Stiffness of the support; rigid where it is zero.
    pub(super) stiffness: f64,
    pub(super) edge_radius: f64,
}

impl Default for Values {
    fn default() -> Self {
        Self {
            length: 0.0,
            t0: 0.0,
            clock: 1.0,
            shared_timing: 1.0,
            model: 1.0,
            amplitude: 0.0,
            angle_scale: 1.0,
            bob: Size::default(),
            bob_mass: 0.0,
            bob_density: 0.0,
            rod_mass: 0.0,
            rod_length: 0.0,
            air_density: 0.0,
            added_mass: 1.0,
            stretch: 0.0,
            damping: 0.0,
            expansion: 0.0,
            warming: 0.0,
            stiffness: 0.0,
            edge_radius: 0.0,
        }
    }
}

impl Values {
    /// Computes g with all effects but one.
    pub(in crate::fit) fn gravity_without(&self, left_out: Option<BudgetEffect>) -> f64 {
        let frequency = TAU / self.period();
        let ideal = frequency * frequency * self.length / self.amplitude_correction(left_out);
        ideal * self.factor_without(left_out)
    }

    /// g over that of a point mass on a massless string in vacuum, with all effects but one and that of the amplitude.
    pub(in crate::fit) fn factor_without(&self, left_out: Option<BudgetEffect>) -> f64 {
        let is_warm = left_out != Some(BudgetEffect::Temperature);
        let growth = if is_warm { 1.0 + self.expansion * self.warming } else { 1.0 };
        let [length, rod_length] = [self.length, self.rod_length].map(|cold| growth * cold);
        growth * Self { length, rod_length, ..*self }.factor_of_length(left_out)
    }

    /// The factor at the length that the pendulum has in the swings.
    fn factor_of_length(&self, left_out: Option<BudgetEffect>) -> f64 {
        let on = |effect: BudgetEffect| if left_out == Some(effect) { 0.0 } else { 1.0 };
        let (mass, length) = (self.rod_over_bob(), self.rod_length_over_length());
        let moment = 1.0
            + on(BudgetEffect::FiniteBob) * self.gyration_over_square()
            + on(BudgetEffect::Rod) * mass * length * length / 3.0
            + on(BudgetEffect::AddedMass) * self.added_mass_over_displaced() * self.air_over_bob()
            + on(BudgetEffect::Support) * self.moment_of_support();
        let stretch = 1.375 * (self.stretch / self.length) * square(self.amplitude);
        let damping = square(0.5 * self.damping * self.period() / TAU);
        moment / self.torque_without(left_out)
            * (1.0 + on(BudgetEffect::Stretch) * stretch)
            * (1.0 + on(BudgetEffect::Damping) * damping)
    }

    /// The torque of gravity over that of the bob alone, with all effects but one.
    pub(super) fn torque_without(&self, left_out: Option<BudgetEffect>) -> f64 {
        let on = |effect: BudgetEffect| if left_out == Some(effect) { 0.0 } else { 1.0 };
        let (mass, length) = (self.rod_over_bob(), self.rod_length_over_length());
        1.0 + on(BudgetEffect::Rod) * 0.5 * mass * length - on(BudgetEffect::Buoyancy) * self.air_over_bob()
            + on(BudgetEffect::KnifeEdge) * (1.0 + mass) * self.edge_radius / self.length
    }

    /// The same pendulum with another length, period and amplitude.
    pub(in crate::fit) fn at(&self, length: f64, t0: f64, amplitude: f64) -> Self {
        Self { length, t0, amplitude, ..*self }
    }

    /// Returns `true` if g is that of a point mass on a massless string in vacuum.
    pub(in crate::fit) fn correct_nothing(&self) -> bool {
        let all = [
            self.bob.radius,
            self.rod_mass,
            self.air_over_bob(),
            self.stretch,
            self.expansion,
            self.stiffness,
            self.edge_radius,
        ];
        all.iter().all(|size| *size <= 0.0)
    }

    /// The same pendulum with a bob of this κ, in m².
    pub(in crate::fit) fn with_gyration(&self, gyration: f64) -> Self {
        let radius = gyration.max(0.0).sqrt();
        Self { bob: Size { shape: BobShape::Gyration, radius, ..Size::default() }, ..*self }
    }

    /// T0 in true seconds.
    fn period(&self) -> f64 {
        self.t0 * self.clock * self.shared_timing * self.model
    }

    /// Divisor of g: T0 was corrected for the amplitude as it was read, and the true one is `angle_scale` times that.
    fn amplitude_correction(&self, left_out: Option<BudgetEffect>) -> f64 {
        let read = period_ratio(self.amplitude);
        if left_out == Some(BudgetEffect::Amplitude) {
            return read * read;
        }
        square(read / period_ratio(self.amplitude * self.angle_scale))
    }

    /// σ.
    pub(super) fn air_over_bob(&self) -> f64 {
        match (self.bob_density > 0.0, self.bob_mass > 0.0) {
            (true, _) => self.air_density / self.bob_density,
            (_, true) => self.air_density * self.bob.volume() / self.bob_mass,
            _ => 0.0,
        }
    }

    /// κ/L².
    pub(super) fn gyration_over_square(&self) -> f64 {
        self.bob.gyration() / square(self.length)
    }

    /// u: the force of inertia of the whole mass over the force that moves the support as far.
    pub(super) fn yield_of_support(&self) -> f64 {
        let whole = self.bob_mass * (1.0 + self.rod_over_bob());
        if self.stiffness > 0.0 { whole * square(TAU / self.period()) / self.stiffness } else { 0.0 }
    }

    /// Moment of the motion of the support, in units of mL².
    fn moment_of_support(&self) -> f64 {
        let (mass, part) = (self.rod_over_bob(), self.yield_of_support());
        let statical = 1.0 + 0.5 * mass * self.rod_length_over_length();
        square(statical) / (1.0 + mass) * part / (1.0 - part)
    }

    /// k of a ball with small swings: 1/2 for ideal flow plus the contribution of a layer of viscous air, 9δ/4r with δ² = 2ν/ω; 1/2 for other
    /// shapes.
    pub(super) fn added_mass_over_displaced(&self) -> f64 {
        self.added_mass * (0.5 + self.viscous_part())
    }

    /// Relative uncertainty of the added mass: half of the viscous part, as flow about a bob that swings further than its radius is not ideal or
    /// laminar; half of it for a ball of unknown radius. For another shape k is between 0, of a thin disc that cuts the air, and 1, of a long
    /// cylinder.
    pub(super) fn uncertainty_of_added_mass(&self) -> f64 {
        match (self.bob.shape, self.bob.radius > 0.0) {
            (BobShape::Ball, true) => 0.5 * self.viscous_part() / self.added_mass_over_displaced(),
            (BobShape::Ball, false) => 0.5,
            _ => 1.0 / 3.0_f64.sqrt(),
        }
    }

    fn viscous_part(&self) -> f64 {
        let is_ball = self.bob.shape == BobShape::Ball && self.bob.radius > 0.0;
        if is_ball { 2.25 * self.layer() / self.bob.radius } else { 0.0 }
    }

    /// δ, the thickness of the layer of air that moves with the bob, in m.
    pub(super) fn layer(&self) -> f64 {
        (2.0 * VISCOSITY_OF_AIR * self.period() / TAU).sqrt()
    }

    /// μ, the mass of the rod over that of the bob; zero for an unknown mass.
    pub(super) fn rod_over_bob(&self) -> f64 {
        if self.bob_mass > 0.0 { self.rod_mass / self.bob_mass } else { 0.0 }
    }

    /// λ, the length of the rod over that of the pendulum.
    pub(super) fn rod_length_over_length(&self) -> f64 {
        let length = if self.rod_length > 0.0 { self.rod_length } else { self.length - self.bob.reach() };
        length / self.length
    }
}

fn square(x: f64) -> f64 {
    x * x
}
