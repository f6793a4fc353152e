//! The inputs of a budget with their uncertainties, checked once, and the contribution of each.

use std::f64::consts::PI;

use super::derivative::{derivative, second_derivative};
use super::effects::{BudgetEffect, Values};
use super::{
    Apparatus, BudgetError, BudgetInput, CombinedUncertainty, Contribution, Correction, Corrections,
    Correlation, Evaluation, MeasuredPeriod, PeriodDamping,
};
use libration::quantity::Quantity;

/// g as a function of the values, with all effects but one.
pub(in crate::fit) type GravityLaw<'a> = &'a dyn Fn(&Values, Option<BudgetEffect>) -> f64;

/// The inputs with their uncertainties.
#[derive(Clone)]
pub(super) struct Inputs<'a> {
    pub(super) values: Values,
    uncertain: Vec<(BudgetInput, Option<f64>)>,
    /// Degrees of freedom of the uncertainty of T0.
    degrees_of_freedom: f64,
    pub(super) damping: PeriodDamping,
    law: GravityLaw<'a>,
}

impl Corrections {
    /// The values of these corrections, with nothing else known.
    pub(in crate::fit) fn values(&self) -> Result<Values, BudgetError> {
        Given::default().corrections(self)
    }
}

/// Inputs that were given, with the checks of their values.
#[derive(Default)]
struct Given(Vec<(BudgetInput, Option<f64>)>);

impl Given {
    /// The value of an input above zero; zero where it is not given.
    fn value(
        &mut self,
        name: &'static str,
        input: BudgetInput,
        quantity: Option<Quantity>,
    ) -> Result<f64, BudgetError> {
        let Some(quantity) = quantity else { return Ok(0.0) };
        check(name, quantity)?;
        self.0.push((input, quantity.uncertainty));
        Ok(quantity.value)
    }

    /// A factor of one with this relative uncertainty.
    fn factor(
        &mut self,
        name: &'static str,
        input: BudgetInput,
        spread: Option<f64>,
    ) -> Result<f64, BudgetError> {
        let factor = spread.map(|spread| Quantity { value: 1.0, uncertainty: Some(spread) });
        Ok(self.value(name, input, factor)?.max(1.0))
    }

    /// The values with these corrections, and nothing else known.
    fn corrections(&mut self, corrections: &Corrections) -> Result<Values, BudgetError> {
        use BudgetInput as Of;
        let mut values = Values::default();
        if let Some(bob) = corrections.bob {
            values.bob = bob.size();
            self.value("radius of the bob", Of::BobRadius, Some(bob.radius))?;
            self.value("height of the bob", Of::BobHeight, bob.height)?;
            self.value("inner radius of the bob", Of::BobInnerRadius, bob.inner_radius)?;
            bob.check()?;
        }
        values.bob_mass = self.value("mass of the bob", Of::BobMass, corrections.bob_mass)?;
        values.bob_density = self.value("density of the bob", Of::BobDensity, corrections.bob_density)?;
        values.rod_mass = self.value("mass of the rod", Of::RodMass, corrections.rod_mass)?;
        values.rod_length = self.value("length of the rod", Of::RodLength, corrections.rod_length)?;
        values.air_density =
            self.value("density of the air", Of::AirDensity, Some(corrections.air_density))?;
        values.stretch = self.value("stretch", Of::Stretch, corrections.stretch)?;
        values.expansion = self.value("coefficient of expansion", Of::Expansion, corrections.expansion)?;
        if let Some(Quantity { value, uncertainty }) = corrections.warming {
            check_temperatures(value, uncertainty.unwrap_or(0.0))?;
            self.0.push((Of::Warming, uncertainty));
            values.warming = value;
        }
        values.stiffness =
            self.value("stiffness of the support", Of::SupportStiffness, corrections.support_stiffness)?;
        values.edge_radius =
            self.value("radius of the knife edge", Of::EdgeRadius, corrections.edge_radius)?;
        Ok(values)
    }
}

/// Relative standard uncertainty of a linear damping coefficient that stands for damping of an unknown kind with the same fall of the amplitudes.
/// To second order ω/ω0 − 1 is −γ²/2 for linear, −0.93 γ² for quadratic and −1.25 γ² for cubic damping, where γ is the relative fall of the
/// amplitude per radian (`expand --damping-order 2`): with a quarter, that of quadratic damping is 1.7 standard uncertainties away.
const UNKNOWN_KIND: f64 = 0.25;

impl Inputs<'static> {
    /// A pendulum with its period.
    pub(super) fn new(apparatus: &Apparatus, period: &MeasuredPeriod) -> Result<Self, BudgetError> {
        let amplitude = period.amplitude.unwrap_or(0.0);
        if !(0.0..PI).contains(&amplitude) {
            return Err(BudgetError::Amplitude(amplitude));
        }
        let contained = match period.damping {
            PeriodDamping::Contained(damping) => Some(damping),
            PeriodDamping::Observed(value) => {
                Some(Quantity { value, uncertainty: Some(UNKNOWN_KIND * value) })
            }
            PeriodDamping::Unknown | PeriodDamping::Fitted(_) => None,
        };
        let mut given = Given::default();
        let length = given.value("length", BudgetInput::Length, Some(apparatus.length))?;
        let t0 = given.value("period", BudgetInput::Period, Some(period.t0))?;
        let clock = given.factor("clock", BudgetInput::Clock, period.clock)?;
        let shared_timing = given.factor("shared timing", BudgetInput::SharedTiming, period.shared_timing)?;
        let model = given.factor("model", BudgetInput::Model, period.model)?;
        let angle_scale = given.factor("angle scale", BudgetInput::AngleScale, period.angle_scale)?;
        let values = given.corrections(&apparatus.corrections)?;
        let damping = given.value("linear damping", BudgetInput::Damping, contained)?;
        let values =
            Values { length, t0, clock, shared_timing, model, amplitude, angle_scale, damping, ..values };
        Self::checked(values, given, period.degrees_of_freedom, period.damping, &Values::gravity_without)
    }
}

impl<'a> Inputs<'a> {
    /// A table of pendulums of several lengths: the typical length, period and amplitude are those with which the sizes of effects are stated.
    pub(super) fn of_table(
        typical: &Apparatus,
        period: &MeasuredPeriod,
        law: GravityLaw<'a>,
    ) -> Result<Self, BudgetError> {
        let mut given = Given::default();
        let clock = given.factor("clock", BudgetInput::Clock, period.clock)?;
        let shared_timing = given.factor("shared timing", BudgetInput::SharedTiming, period.shared_timing)?;
        let values = Values {
            length: typical.length.value,
            t0: period.t0.value,
            amplitude: period.amplitude.unwrap_or(0.0),
            clock,
            shared_timing,
            ..given.corrections(&typical.corrections)?
        };
        Self::checked(values, given, f64::INFINITY, PeriodDamping::Unknown, law)
    }

    fn checked(
        values: Values,
        Given(mut uncertain): Given,
        degrees_of_freedom: f64,
        damping: PeriodDamping,
        law: GravityLaw<'a>,
    ) -> Result<Self, BudgetError> {
        let Values { length, rod_mass, bob_mass, .. } = values;
        if values.bob.reach() >= length {
            return Err(BudgetError::BobTooLarge { radius: values.bob.reach(), length });
        }
        if rod_mass > 0.0 && bob_mass <= 0.0 {
            return Err(BudgetError::RodWithoutBob);
        }
        if values.stiffness > 0.0 && bob_mass <= 0.0 {
            return Err(BudgetError::SupportWithoutBob);
        }
        if values.yield_of_support() >= 1.0 {
            return Err(BudgetError::SupportTooWeak);
        }
        if values.warming.abs() > 0.0 && values.expansion <= 0.0 {
            return Err(BudgetError::WarmingWithoutExpansion);
        }
        if values.torque_without(None) <= 0.0 {
            return Err(BudgetError::BobTooLight);
        }
        uncertain.push((BudgetInput::AddedMass, Some(values.uncertainty_of_added_mass())));
        Ok(Self { values, uncertain, degrees_of_freedom, damping, law })
    }

    /// g of these values.
    pub(super) fn gravity_of(&self, values: &Values) -> f64 {
        (self.law)(values, None)
    }

    /// g of these values with all effects but one.
    pub(super) fn gravity_without(&self, values: &Values, effect: BudgetEffect) -> f64 {
        (self.law)(values, Some(effect))
    }

    /// g with all effects.
    pub(super) fn gravity(&self) -> f64 {
        self.gravity_of(&self.values)
    }

    /// The relative change of g by the effect.
    pub(super) fn size_of(&self, effect: BudgetEffect) -> Correction {
        Correction::Applied(self.gravity() / self.gravity_without(&self.values, effect) - 1.0)
    }

    /// The uncertainty of g.
    pub(super) fn combined(&self, correlations: &[Correlation]) -> Result<CombinedUncertainty, BudgetError> {
        CombinedUncertainty::new(self.contributions(), correlations)
    }

    /// The contributions of all inputs.
    pub(super) fn contributions(&self) -> Vec<Contribution> {
        self.uncertain.iter().map(|&(input, spread)| self.contribution(input, spread)).collect()
    }

    fn contribution(&self, input: BudgetInput, uncertainty: Option<f64>) -> Contribution {
        let sensitivity = self.slope(input, |values| self.gravity_of(values));
        let judged = Contribution::judged(input, self.value(input), uncertainty, sensitivity);
        if input != BudgetInput::Period {
            return judged;
        }
        let (evaluation, degrees_of_freedom) = (Evaluation::Statistics, self.degrees_of_freedom);
        Contribution { evaluation, degrees_of_freedom, ..judged }
    }

    /// Shift of the mean of g because g is not linear over the uncertainties: Σ ½ ∂²g/∂x² u².
    pub(super) fn curvature(&self) -> f64 {
        let bend = |&(input, spread): &(BudgetInput, Option<f64>)| {
            let spread = spread.unwrap_or(0.0);
            let of_input = self.along(input, |values| self.gravity_of(values));
            0.5 * second_derivative(self.value(input), self.reach(input), of_input) * spread * spread
        };
        self.uncertain.iter().map(bend).sum()
    }

    /// Change of a function of the values with one standard uncertainty of an input; zero if the input has none.
    pub(super) fn change(&self, input: BudgetInput, of: impl Fn(&Values) -> f64) -> f64 {
        self.uncertainty(input).map_or(0.0, |spread| spread * self.slope(input, of))
    }

    /// Standard uncertainty of an input that was given with one.
    pub(super) fn uncertainty(&self, input: BudgetInput) -> Option<f64> {
        self.uncertain.iter().find(|uncertain| uncertain.0 == input)?.1
    }

    pub(super) fn is_given(&self, input: BudgetInput) -> bool {
        self.uncertain.iter().any(|uncertain| uncertain.0 == input)
    }

    /// The size of the changes by all selected inputs; `None` if one that matters has no uncertainty.
    pub(super) fn changes(
        &self,
        of: impl Fn(&Values) -> f64,
        counts: impl Fn(BudgetInput) -> bool,
    ) -> Option<f64> {
        /// Rounding of a ratio that an input drops out of makes slopes of 1e-12.
        const MATTERS: f64 = 1e-9;
        let counted = self.uncertain.iter().filter(|(input, _)| counts(*input));
        let matters = |input| (self.reach(input) * self.slope(input, &of)).abs() > MATTERS;
        let (complete, open): (Vec<_>, Vec<_>) =
            counted.filter(|(input, _)| matters(*input)).partition(|(_, spread)| spread.is_some());
        let squares =
            complete.iter().map(|(input, _)| self.change(*input, &of)).map(|change| change * change);
        (open.is_empty() || !complete.is_empty()).then(|| squares.sum::<f64>().sqrt())
    }

    fn slope(&self, input: BudgetInput, of: impl Fn(&Values) -> f64) -> f64 {
        derivative(self.value(input), self.reach(input), self.along(input, of))
    }

    /// Returns a function of the values as a function of this input.
    fn along(&self, input: BudgetInput, of: impl Fn(&Values) -> f64) -> impl Fn(f64) -> f64 {
        let values = self.values;
        move |x| {
            let mut moved = values;
            if let Some(variable) = input.slot(&mut moved) {
                *variable = x;
            }
            of(&moved)
        }
    }

    fn value(&self, input: BudgetInput) -> f64 {
        let mut values = self.values;
        input.slot(&mut values).map_or(f64::NAN, |variable| *variable)
    }

    /// Distance over which the functions are defined: to zero, and for amplitudes to the top.
    fn reach(&self, input: BudgetInput) -> f64 {
        let amplitude = self.values.amplitude;
        match input {
            BudgetInput::AngleScale if amplitude > 0.0 => ((PI - amplitude) / amplitude).min(1.0),
            // A difference of temperatures may be zero; g is linear in it, and changes little over 100 K.
            BudgetInput::Warming => self.value(input).abs().max(100.0),
            _ => self.value(input),
        }
    }
}

fn check(name: &'static str, quantity: Quantity) -> Result<(), BudgetError> {
    let Quantity { value, uncertainty } = quantity;
    if !(value > 0.0 && value.is_finite()) {
        return Err(BudgetError::NotPositive { name, value });
    }
    check_uncertainty(name, uncertainty.unwrap_or(0.0))
}

/// Checks a difference of temperatures, which may be of either sign.
fn check_temperatures(value: f64, spread: f64) -> Result<(), BudgetError> {
    if !value.is_finite() {
        return Err(BudgetError::NotFinite { name: "difference of temperatures", value });
    }
    check_uncertainty("difference of temperatures", spread)
}

fn check_uncertainty(name: &'static str, spread: f64) -> Result<(), BudgetError> {
    if (0.0..f64::INFINITY).contains(&spread) {
        return Ok(());
    }
    Err(BudgetError::Uncertainty { name, value: spread })
}
