//! The rows of a budget: each effect with its size, and its part of the uncertainty by central differences.

use super::effects::{Effect, Values};
use super::{Apparatus, Budget, BudgetError, BudgetRow, Correction, Evaluation, MeasuredPeriod};
use crate::quantity::Quantity;

/// The inputs with their uncertainties.
#[derive(Clone, Debug)]
pub(super) struct Inputs {
    values: Values,
    uncertain: Vec<(Input, f64)>,
    has_angle_scale: bool,
}

/// What can be uncertain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Input {
    Length,
    T0,
    AngleScale,
    Radius,
    BobMass,
    BobDensity,
    RodMass,
    RodLength,
    AirDensity,
    AddedMass,
    Stretch,
    Damping,
}

impl Inputs {
    pub(super) fn new(apparatus: &Apparatus, period: &MeasuredPeriod) -> Result<Self, BudgetError> {
        let amplitude = period.amplitude.unwrap_or(0.0);
        if !(0.0..std::f64::consts::PI).contains(&amplitude) {
            return Err(BudgetError::Amplitude(amplitude));
        }
        let mut uncertain = vec![];
        let mut given = |name: &'static str, input: Input, quantity: Option<Quantity>| {
            let Some(Quantity { value, uncertainty }) = quantity else { return Ok(0.0) };
            let spread = uncertainty.unwrap_or(0.0);
            if !(value > 0.0 && value.is_finite()) {
                return Err(BudgetError::NotPositive { name, value });
            }
            if !(0.0..f64::INFINITY).contains(&spread) {
                return Err(BudgetError::Uncertainty { name, value: spread });
            }
            uncertain.push((input, spread));
            Ok(value)
        };
        let scale = period.angle_scale.map(|spread| Quantity { value: 1.0, uncertainty: Some(spread) });
        let mut values = Values {
            length: given("length", Input::Length, Some(apparatus.length))?,
            t0: given("period", Input::T0, Some(period.t0))?,
            amplitude,
            angle_scale: given("angle scale", Input::AngleScale, scale)?.max(1.0),
            radius: given("radius of the bob", Input::Radius, apparatus.bob_radius)?,
            bob_mass: given("mass of the bob", Input::BobMass, apparatus.bob_mass)?,
            bob_density: given("density of the bob", Input::BobDensity, apparatus.bob_density)?,
            rod_mass: given("mass of the rod", Input::RodMass, apparatus.rod_mass)?,
            rod_length: given("length of the rod", Input::RodLength, apparatus.rod_length)?,
            air_density: given("density of the air", Input::AirDensity, Some(apparatus.air_density))?,
            added_mass: 1.0,
            stretch: given("stretch", Input::Stretch, apparatus.stretch)?,
            damping: given("linear damping", Input::Damping, period.linear_damping)?,
        };
        if values.radius >= values.length {
            return Err(BudgetError::BobTooLarge { radius: values.radius, length: values.length });
        }
        if values.rod_mass > 0.0 && values.bob_mass <= 0.0 {
            return Err(BudgetError::RodWithoutBob);
        }
        // Flow about a bob that swings further than its radius is neither ideal nor laminar: half of what viscosity adds.
        let of_layer = 0.5 * values.viscous_part() / values.added_mass_over_displaced();
        uncertain.push((Input::AddedMass, if values.radius > 0.0 { of_layer } else { 0.5 }));
        values.added_mass = 1.0;
        let has_angle_scale = period.angle_scale.is_some();
        let inputs = Self { values, uncertain, has_angle_scale };
        if inputs.values.gravity() > 0.0 { Ok(inputs) } else { Err(BudgetError::BobTooLight) }
    }

    pub(super) fn budget(&self) -> Budget {
        let g = self.values.gravity();
        let contributions = self.uncertain.iter().map(|&(input, _)| self.change(input, Values::gravity));
        let uncertainty = contributions.map(|change| change * change).sum::<f64>().sqrt();
        let rows = [
            vec![self.length(), self.timing(), self.amplitude(), self.angle_scale()],
            vec![self.buoyancy(), self.added_mass(), self.finite_bob(), self.rod(), self.stretch()],
            self.damping().into_iter().collect(),
        ];
        Budget { rows: rows.concat(), length: self.values.length, g, uncertainty }
    }

    /// What a function of the values changes by with one standard uncertainty of an input.
    fn change(&self, input: Input, of: impl Fn(&Values) -> f64) -> f64 {
        let spread =
            self.uncertain.iter().find(|uncertain| uncertain.0 == input).map_or(0.0, |found| found.1);
        let (mut above, mut below) = (self.values, self.values);
        *input.place(&mut above) += spread;
        *input.place(&mut below) -= spread;
        0.5 * (of(&above) - of(&below))
    }

    /// An effect: its size, and the uncertainty that its own inputs give it.
    fn effect(&self, name: &'static str, formula: &'static str, effect: Effect, note: String) -> BudgetRow {
        let ratio = |values: &Values| values.gravity() / values.gravity_without(Some(effect));
        let own = self.uncertain.iter().filter(|(input, _)| !matches!(input, Input::Length | Input::T0));
        let square: f64 =
            own.map(|&(input, _)| self.change(input, ratio)).map(|change| change * change).sum();
        BudgetRow {
            name,
            formula,
            correction: Correction::Applied(ratio(&self.values) - 1.0),
            uncertainty: Some(self.values.gravity() * square.sqrt()),
            evaluation: Evaluation::Judgement,
            note,
        }
    }

    fn input(
        &self,
        name: &'static str,
        formula: &'static str,
        input: Input,
        evaluation: Evaluation,
    ) -> BudgetRow {
        let uncertainty = Some(self.change(input, Values::gravity).abs());
        BudgetRow {
            name,
            formula,
            correction: Correction::Input,
            uncertainty,
            evaluation,
            note: String::new(),
        }
    }

    fn length(&self) -> BudgetRow {
        let note = format!("L = {} m", self.values.length);
        BudgetRow { note, ..self.input("length", "u(L)/L", Input::Length, Evaluation::Judgement) }
    }

    fn timing(&self) -> BudgetRow {
        let note = format!("T0 = {:.6} s", self.values.t0);
        BudgetRow { note, ..self.input("timing", "2 u(T0)/T0", Input::T0, Evaluation::Statistics) }
    }

    fn amplitude(&self) -> BudgetRow {
        const FORMULA: &str = "R(A)^2";
        if self.values.amplitude <= 0.0 {
            return unknown(
                "finite amplitude",
                FORMULA,
                "R = T/T0 of the exact law; the amplitude A is not known",
            );
        }
        let note = format!("R = T/T0 at A = {:.2} deg; already in T0", self.values.amplitude.to_degrees());
        let row = self.effect("finite amplitude", FORMULA, Effect::Amplitude, note);
        // That of the amplitude is the next row.
        BudgetRow { uncertainty: None, ..row }
    }

    fn angle_scale(&self) -> BudgetRow {
        const FORMULA: &str = "2 (dlnR/dlnA) u(A)/A";
        if self.values.amplitude <= 0.0 {
            return unknown("angle scale", FORMULA, "the amplitude is not known");
        }
        if !self.has_angle_scale {
            let one_percent = Values { angle_scale: 1.01, ..self.values };
            let size = one_percent.gravity() / self.values.gravity() - 1.0;
            let note = "for angles that are all 1 % off; give their uncertainty".into();
            return usually("angle scale", FORMULA, size, note);
        }
        let row = self.input("angle scale", FORMULA, Input::AngleScale, Evaluation::Judgement);
        let note = if row.uncertainty == Some(0.0) { "exact, or part of T0" } else { "" };
        BudgetRow { note: note.into(), ..row }
    }

    fn has_density(&self) -> bool {
        let Values { bob_density, bob_mass, radius, .. } = self.values;
        bob_density > 0.0 || (bob_mass > 0.0 && radius > 0.0)
    }

    /// The air over a bob of brass or steel.
    fn usual_air_over_bob(&self) -> f64 {
        self.values.air_density / 8000.0
    }

    fn buoyancy(&self) -> BudgetRow {
        const FORMULA: &str = "1/(1 - s)";
        if !self.has_density() {
            let note = "s: air/bob density, for brass; give density, or mass and radius, of the bob".into();
            return usually("buoyancy", FORMULA, self.usual_air_over_bob(), note);
        }
        let note = format!("s = {:.2e}, air over bob", self.values.air_over_bob());
        self.effect("buoyancy", FORMULA, Effect::Buoyancy, note)
    }

    fn added_mass(&self) -> BudgetRow {
        const FORMULA: &str = "1 + k s";
        if !self.has_density() {
            let note = "k = 1/2, for brass; give density, or mass and radius, of the bob".into();
            return usually("added mass", FORMULA, 0.5 * self.usual_air_over_bob(), note);
        }
        let k = self.values.added_mass_over_displaced();
        let note =
            format!("k = 1/2 + 9d/4r = {k:.2}, d = {:.1} mm of viscous air", 1e3 * self.values.layer());
        self.effect("added mass", FORMULA, Effect::AddedMass, note)
    }

    fn finite_bob(&self) -> BudgetRow {
        const FORMULA: &str = "1 + 2r^2/5L^2";
        if self.values.radius <= 0.0 {
            return usually(
                "finite bob",
                FORMULA,
                0.001,
                "a ball of radius L/20; give that of the bob".into(),
            );
        }
        let note = format!("a ball of radius r = {} m", self.values.radius);
        self.effect("finite bob", FORMULA, Effect::FiniteBob, note)
    }

    fn rod(&self) -> BudgetRow {
        const FORMULA: &str = "(1 + ml^2/3)/(1 + ml/2)";
        if self.values.rod_mass <= 0.0 {
            let note = "for 1 % of the mass of the bob; give both masses".into();
            return usually("rod mass", FORMULA, -0.01 / 6.0, note);
        }
        let note = format!(
            "m = {:.4}, l = {:.4}, relative to bob and L",
            self.values.rod_over_bob(),
            self.values.rod_length_over_length()
        );
        self.effect("rod mass", FORMULA, Effect::Rod, note)
    }

    fn stretch(&self) -> BudgetRow {
        const FORMULA: &str = "1 + (11/8)(x/L)A^2";
        let Values { amplitude, length, stretch, .. } = self.values;
        match (stretch > 0.0, amplitude > 0.0) {
            (true, true) => self.effect(
                "stretch",
                FORMULA,
                Effect::Stretch,
                format!("stretched by x = {stretch} m at rest"),
            ),
            (false, true) => {
                let note = format!("for a string that the bob stretches by x = {:.1e} m", 1e-3 * length);
                usually("stretch", FORMULA, 1.375e-3 * amplitude * amplitude, note)
            }
            (_, false) => unknown("stretch", FORMULA, "the amplitude is not known"),
        }
    }

    fn damping(&self) -> Option<BudgetRow> {
        let note = format!("b = {:.3e} 1/s, w = 2pi/T0", self.values.damping);
        let row = || self.effect("damping", "1 + (b/2w)^2", Effect::Damping, note);
        (self.values.damping > 0.0).then(row)
    }
}

fn usually(name: &'static str, formula: &'static str, size: f64, note: String) -> BudgetRow {
    let correction = Correction::Usually(size);
    BudgetRow { name, formula, correction, uncertainty: None, evaluation: Evaluation::Judgement, note }
}

fn unknown(name: &'static str, formula: &'static str, note: &str) -> BudgetRow {
    let correction = Correction::Unknown;
    let note = note.to_owned();
    BudgetRow { name, formula, correction, uncertainty: None, evaluation: Evaluation::Judgement, note }
}

impl Input {
    fn place(self, values: &mut Values) -> &mut f64 {
        match self {
            Self::Length => &mut values.length,
            Self::T0 => &mut values.t0,
            Self::AngleScale => &mut values.angle_scale,
            Self::Radius => &mut values.radius,
            Self::BobMass => &mut values.bob_mass,
            Self::BobDensity => &mut values.bob_density,
            Self::RodMass => &mut values.rod_mass,
            Self::RodLength => &mut values.rod_length,
            Self::AirDensity => &mut values.air_density,
            Self::AddedMass => &mut values.added_mass,
            Self::Stretch => &mut values.stretch,
            Self::Damping => &mut values.damping,
        }
    }
}
