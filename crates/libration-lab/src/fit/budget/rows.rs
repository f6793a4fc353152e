//! The rows of a budget: each effect with its size and its contribution to the uncertainty.

use super::bob::{BobShape, Size};
use super::effects::{BudgetEffect, Values};
use super::inputs::Inputs;
use super::{
    Budget, BudgetError, BudgetInput, BudgetRow, Correction, Correlation, Evaluation, PeriodDamping,
};

impl Inputs<'_> {
    pub(super) fn budget(&self, correlations: &[Correlation]) -> Result<Budget, BudgetError> {
        let rows = [
            vec![self.length(), self.timing()],
            self.of_times(),
            vec![self.amplitude(), self.angle_scale()],
            self.of_air(),
            vec![self.finite_bob(), self.rod(), self.stretch()],
            self.of_support(),
            vec![self.damping()],
        ];
        let combined = self.combined(correlations)?;
        Ok(Budget {
            rows: rows.concat(),
            length: self.values.length,
            g: self.gravity(),
            uncertainty: combined.standard,
            combined,
            curvature: self.curvature(),
        })
    }

    /// The rows of a table of several lengths after those of the fitted line; a bar has neither bob nor string.
    pub(super) fn rows_of_table(&self, is_bar: bool) -> Vec<BudgetRow> {
        let of_string = if is_bar { vec![] } else { vec![self.finite_bob(), self.rod(), self.stretch()] };
        let of_support = if is_bar { self.of_support_of_bar() } else { self.of_support() };
        [self.of_times(), self.of_air(), of_string, of_support].concat()
    }

    fn of_times(&self) -> Vec<BudgetRow> {
        let model = self.is_given(BudgetInput::Model).then(|| self.model());
        let shared = self.is_given(BudgetInput::SharedTiming).then(|| self.shared_timing());
        model.into_iter().chain(shared).chain([self.clock()]).collect()
    }

    fn of_air(&self) -> Vec<BudgetRow> {
        vec![self.buoyancy(), self.added_mass()]
    }

    /// The rows of a bar, for which only additional fits show the sizes of effects that are not corrected.
    fn of_support_of_bar(&self) -> Vec<BudgetRow> {
        let open = "not corrected; a part of it is in the moment of inertia that is fitted";
        let support = match self.is_given(BudgetInput::SupportStiffness) {
            true => self.support(),
            false => unknown("support", "1 + mg/KL", open),
        };
        let edge = match self.is_given(BudgetInput::EdgeRadius) {
            true => self.knife_edge(),
            false => unknown("knife edge", "1/(1 + p/L)", open),
        };
        vec![self.temperature(), support, edge]
    }

    fn of_support(&self) -> Vec<BudgetRow> {
        vec![self.temperature(), self.support(), self.knife_edge()]
    }

    /// An effect: its size, and its contribution to the uncertainty through its inputs.
    fn effect(
        &self,
        name: &'static str,
        formula: &'static str,
        effect: BudgetEffect,
        note: String,
    ) -> BudgetRow {
        let ratio = |values: &Values| self.gravity_of(values) / self.gravity_without(values, effect);
        let contributes = |input| {
            !matches!(
                input,
                BudgetInput::Length
                    | BudgetInput::Period
                    | BudgetInput::Clock
                    | BudgetInput::SharedTiming
                    | BudgetInput::Model
            )
        };
        BudgetRow {
            name,
            formula,
            correction: self.size_of(effect),
            uncertainty: self.changes(ratio, contributes).map(|change| self.gravity() * change),
            evaluation: Evaluation::Judgement,
            note,
        }
    }

    fn input(
        &self,
        name: &'static str,
        formula: &'static str,
        input: BudgetInput,
        evaluation: Evaluation,
    ) -> BudgetRow {
        let uncertainty =
            self.uncertainty(input).map(|_| self.change(input, |values| self.gravity_of(values)).abs());
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
        BudgetRow { note, ..self.input("length", "u(L)/L", BudgetInput::Length, Evaluation::Judgement) }
    }

    fn timing(&self) -> BudgetRow {
        let note = format!("T0 = {:.6} s", self.values.t0);
        BudgetRow { note, ..self.input("timing", "2 u(T0)/T0", BudgetInput::Period, Evaluation::Statistics) }
    }

    fn model(&self) -> BudgetRow {
        let note = "fits that contradict each other: rectangular, with their difference as half-width".into();
        BudgetRow {
            note,
            ..self.input("model", "2 a/(sqrt(3) T0)", BudgetInput::Model, Evaluation::Judgement)
        }
    }

    fn shared_timing(&self) -> BudgetRow {
        let note = "an error common to all readings by hand, as of an observer who stops late".into();
        let row =
            self.input("shared timing", "2 u(t)/(n T0)", BudgetInput::SharedTiming, Evaluation::Judgement);
        BudgetRow { note, ..row }
    }

    fn clock(&self) -> BudgetRow {
        const FORMULA: &str = "2 u(t)/t";
        if !self.is_given(BudgetInput::Clock) {
            let note = "for 29.97 frames/s taken as 30; give the uncertainty of clock or frame rate".into();
            return usually("clock", FORMULA, -0.002, note);
        }
        let row = self.input("clock", FORMULA, BudgetInput::Clock, Evaluation::Judgement);
        BudgetRow { note: "all times by one factor".into(), ..row }
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
        let row = self.effect("finite amplitude", FORMULA, BudgetEffect::Amplitude, note);
        // That of the amplitude is the next row.
        BudgetRow { uncertainty: None, ..row }
    }

    fn angle_scale(&self) -> BudgetRow {
        const FORMULA: &str = "2 (dlnR/dlnA) u(A)/A";
        if self.values.amplitude <= 0.0 {
            return unknown("angle scale", FORMULA, "the amplitude is not known");
        }
        if !self.is_given(BudgetInput::AngleScale) {
            let one_percent = Values { angle_scale: 1.01, ..self.values };
            let size = self.gravity_of(&one_percent) / self.gravity() - 1.0;
            let note = "for angles that are all 1 % off; give their uncertainty".into();
            return usually("angle scale", FORMULA, size, note);
        }
        let row = self.input("angle scale", FORMULA, BudgetInput::AngleScale, Evaluation::Judgement);
        let note = if row.uncertainty == Some(0.0) { "exact, or part of T0" } else { "" };
        BudgetRow { note: note.into(), ..row }
    }

    fn has_density(&self) -> bool {
        self.values.air_over_bob() > 0.0
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
        self.effect("buoyancy", FORMULA, BudgetEffect::Buoyancy, note)
    }

    fn added_mass(&self) -> BudgetRow {
        const FORMULA: &str = "1 + k s";
        if !self.has_density() {
            let note = "k = 1/2, for brass; give density, or mass and radius, of the bob".into();
            return usually("added mass", FORMULA, 0.5 * self.usual_air_over_bob(), note);
        }
        let k = self.values.added_mass_over_displaced();
        let note = match self.values.bob.shape {
            BobShape::Ball => {
                format!("k = 1/2 + 9d/4r = {k:.2}, d = {:.1} mm of viscous air", 1e3 * self.values.layer())
            }
            shape => format!("k = 1/2, between 0 and 1 for a {}", shape.name()),
        };
        self.effect("added mass", FORMULA, BudgetEffect::AddedMass, note)
    }

    fn finite_bob(&self) -> BudgetRow {
        let Size { shape, radius, height, inner } = self.values.bob;
        if radius <= 0.0 {
            let radius = self.values.length / 20.0;
            let with = Values { bob: Size { radius, ..Size::default() }, ..self.values };
            let note = "a ball of radius L/20; give that of the bob".into();
            return self.typical("finite bob", "1 + 2r^2/5L^2", BudgetEffect::FiniteBob, &with, note);
        }
        let (formula, note) = match shape {
            BobShape::Ball => ("1 + 2r^2/5L^2", format!("a ball of radius r = {radius} m")),
            BobShape::Disc => ("1 + r^2/2L^2", format!("a disc of radius r = {radius} m")),
            BobShape::Cylinder => (
                "1 + (r^2/4 + h^2/12)/L^2",
                format!("a cylinder of radius r = {radius} m and height h = {height} m"),
            ),
            BobShape::Ring => {
                ("1 + (r^2 + i^2)/2L^2", format!("a ring of radii r = {radius} m and i = {inner} m"))
            }
            BobShape::Cap => (
                "1 + K/L^2",
                format!(
                    "K = {:.4e} m^2 of a cap of height {height} m of a ball of radius {radius} m",
                    self.values.bob.gyration()
                ),
            ),
            BobShape::Gyration => ("1 + r^2/L^2", format!("radius of gyration r = {radius} m")),
        };
        self.effect("finite bob", formula, BudgetEffect::FiniteBob, note)
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
        self.effect("rod mass", FORMULA, BudgetEffect::Rod, note)
    }

    fn stretch(&self) -> BudgetRow {
        const FORMULA: &str = "1 + (11/8)(x/L)A^2";
        let Values { amplitude, length, stretch, .. } = self.values;
        match (stretch > 0.0, amplitude > 0.0) {
            (true, true) => self.effect(
                "stretch",
                FORMULA,
                BudgetEffect::Stretch,
                format!("stretched by x = {stretch} m at rest"),
            ),
            (false, true) => {
                // 11/8 of x/L = 1e-3, from the formula above.
                let note = format!("for a string that the bob stretches by x = {:.1e} m", 1e-3 * length);
                usually("stretch", FORMULA, 1.375e-3 * amplitude * amplitude, note)
            }
            (_, false) => unknown("stretch", FORMULA, "the amplitude is not known"),
        }
    }

    fn temperature(&self) -> BudgetRow {
        const FORMULA: &str = "1 + a dt";
        let Values { expansion, warming, .. } = self.values;
        if expansion <= 0.0 {
            let note =
                "for steel, a = 1.2e-5/K, warmer by dt = 5 K than when the length was measured; give both";
            return usually("temperature", FORMULA, 6e-5, note.into());
        }
        let note = format!("expansion a = {expansion:.3e} 1/K, dt = {warming} K");
        self.effect("temperature", FORMULA, BudgetEffect::Temperature, note)
    }

    fn support(&self) -> BudgetRow {
        const FORMULA: &str = "1 + mg/KL";
        let Values { stiffness, length, bob_mass, .. } = self.values;
        if stiffness <= 0.0 {
            let bob_mass = if bob_mass > 0.0 { bob_mass } else { 1.0 };
            // The weight divided by 0.1 mm.
            let with = Values { bob_mass, stiffness: bob_mass * self.gravity() / 1e-4, ..self.values };
            let note = "for a support that the weight of the bob, pulling sideways, moves by 0.1 mm; give its stiffness";
            return self.typical("support", FORMULA, BudgetEffect::Support, &with, note.into());
        }
        let note = format!(
            "stiffness K = {stiffness} N/m; the weight would move it by {:.2} mm sideways",
            1e3 * self.values.yield_of_support() * length
        );
        self.effect("support", FORMULA, BudgetEffect::Support, note)
    }

    fn knife_edge(&self) -> BudgetRow {
        const FORMULA: &str = "1/(1 + p/L)";
        let Values { edge_radius, .. } = self.values;
        if edge_radius <= 0.0 {
            let with = Values { edge_radius: 5e-5, ..self.values };
            let note = "for an edge that rolls with radius of curvature p = 0.05 mm; give its radius";
            return self.typical("knife edge", FORMULA, BudgetEffect::KnifeEdge, &with, note.into());
        }
        let note = format!("radius of curvature p = {edge_radius} m");
        self.effect("knife edge", FORMULA, BudgetEffect::KnifeEdge, note)
    }

    /// An effect that is not corrected, with the size that it has with these values.
    fn typical(
        &self,
        name: &'static str,
        formula: &'static str,
        effect: BudgetEffect,
        with: &Values,
        note: String,
    ) -> BudgetRow {
        usually(name, formula, self.gravity_of(with) / self.gravity_without(with, effect) - 1.0, note)
    }

    fn damping(&self) -> BudgetRow {
        const FORMULA: &str = "1 + (b/2w)^2";
        match self.damping {
            PeriodDamping::Contained(_) => {
                let note = format!("b = {:.3e} 1/s, w = 2pi/T0", self.values.damping);
                self.effect("damping", FORMULA, BudgetEffect::Damping, note)
            }
            PeriodDamping::Observed(linear) => {
                let note = format!(
                    "b = {linear:.3e} 1/s by the fall of the amplitudes, whose law is not known; give the coefficient, w = 2pi/T0"
                );
                self.effect("damping", FORMULA, BudgetEffect::Damping, note)
            }
            PeriodDamping::Fitted(linear) => {
                let with = Values { damping: linear, ..self.values };
                let size = self.gravity_of(&with) / self.gravity_without(&with, BudgetEffect::Damping) - 1.0;
                let drag = if linear.abs() > 0.0 { format!("b = {linear:.3e} 1/s; ") } else { String::new() };
                let note = format!("{drag}already in T0, which is that of the undamped motion");
                let row = unknown("damping", FORMULA, &note);
                BudgetRow { correction: Correction::Applied(size), ..row }
            }
            PeriodDamping::Unknown => {
                let note =
                    "for linear drag by which the amplitude falls to 1/e in 30 swings; give its coefficient";
                usually("damping", FORMULA, THIRTY_SWINGS, note.into())
            }
        }
    }
}

/// (b/2ω)² where exp(−b·t/2) is 1/e after 30 periods: 1/(60π)².
const THIRTY_SWINGS: f64 = 2.814e-5;

fn usually(name: &'static str, formula: &'static str, size: f64, note: String) -> BudgetRow {
    let correction = Correction::Typical(size);
    BudgetRow { name, formula, correction, uncertainty: None, evaluation: Evaluation::Judgement, note }
}

fn unknown(name: &'static str, formula: &'static str, note: &str) -> BudgetRow {
    let correction = Correction::Unknown;
    let note = note.to_owned();
    BudgetRow { name, formula, correction, uncertainty: None, evaluation: Evaluation::Judgement, note }
}
