//! The inputs of a budget with their uncertainties, checked once, and the contribution of each.

use std::f64::consts::PI;

use super::derivative::{derivative, second_derivative};
use super::effects::Values;
use super::{
    Apparatus, BudgetError, BudgetInput, CombinedUncertainty, Contribution, Correlation, Evaluation,
    MeasuredPeriod, PeriodDamping,
};
use libration::quantity::Quantity;

/// The inputs with their uncertainties.
#[derive(Clone, Debug)]
pub(super) struct Inputs {
    pub(super) values: Values,
    uncertain: Vec<(BudgetInput, Option<f64>)>,
    /// Degrees of freedom of the uncertainty of T0.
    degrees_of_freedom: f64,
    pub(super) damping: PeriodDamping,
}

impl Inputs {
    pub(super) fn new(apparatus: &Apparatus, period: &MeasuredPeriod) -> Result<Self, BudgetError> {
        let amplitude = period.amplitude.unwrap_or(0.0);
        if !(0.0..PI).contains(&amplitude) {
            return Err(BudgetError::Amplitude(amplitude));
        }
        let mut uncertain = vec![];
        let mut given = |name: &'static str, input: BudgetInput, quantity: Option<Quantity>| {
            let Some(quantity) = quantity else { return Ok(0.0) };
            check(name, quantity)?;
            uncertain.push((input, quantity.uncertainty));
            Ok(quantity.value)
        };
        let factor =
            |spread: Option<f64>| spread.map(|spread| Quantity { value: 1.0, uncertainty: Some(spread) });
        let contained = match period.damping {
            PeriodDamping::Contained(damping) => Some(damping),
            PeriodDamping::Unknown | PeriodDamping::Fitted(_) => None,
        };
        let values = Values {
            length: given("length", BudgetInput::Length, Some(apparatus.length))?,
            t0: given("period", BudgetInput::Period, Some(period.t0))?,
            clock: given("clock", BudgetInput::Clock, factor(period.clock))?.max(1.0),
            shared_timing: given("shared timing", BudgetInput::SharedTiming, factor(period.shared_timing))?
                .max(1.0),
            model: given("model", BudgetInput::Model, factor(period.model))?.max(1.0),
            amplitude,
            angle_scale: given("angle scale", BudgetInput::AngleScale, factor(period.angle_scale))?.max(1.0),
            radius: given("radius of the bob", BudgetInput::BobRadius, apparatus.bob_radius)?,
            bob_mass: given("mass of the bob", BudgetInput::BobMass, apparatus.bob_mass)?,
            bob_density: given("density of the bob", BudgetInput::BobDensity, apparatus.bob_density)?,
            rod_mass: given("mass of the rod", BudgetInput::RodMass, apparatus.rod_mass)?,
            rod_length: given("length of the rod", BudgetInput::RodLength, apparatus.rod_length)?,
            air_density: given("density of the air", BudgetInput::AirDensity, Some(apparatus.air_density))?,
            added_mass: 1.0,
            stretch: given("stretch", BudgetInput::Stretch, apparatus.stretch)?,
            damping: given("linear damping", BudgetInput::Damping, contained)?,
        };
        uncertain.push((BudgetInput::AddedMass, Some(values.uncertainty_of_added_mass())));
        let (degrees_of_freedom, damping) = (period.degrees_of_freedom, period.damping);
        Self { values, uncertain, degrees_of_freedom, damping }.checked()
    }

    fn checked(self) -> Result<Self, BudgetError> {
        let Values { radius, length, rod_mass, bob_mass, .. } = self.values;
        if radius >= length {
            return Err(BudgetError::BobTooLarge { radius, length });
        }
        if rod_mass > 0.0 && bob_mass <= 0.0 {
            return Err(BudgetError::RodWithoutBob);
        }
        if self.values.gravity() > 0.0 { Ok(self) } else { Err(BudgetError::BobTooLight) }
    }

    /// The uncertainty of g.
    pub(super) fn combined(&self, correlations: &[Correlation]) -> Result<CombinedUncertainty, BudgetError> {
        let contributions = self.uncertain.iter().map(|&(input, spread)| self.contribution(input, spread));
        CombinedUncertainty::new(contributions.collect(), correlations)
    }

    fn contribution(&self, input: BudgetInput, uncertainty: Option<f64>) -> Contribution {
        let sensitivity = self.slope(input, Values::gravity);
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
            let of_input = self.along(input, Values::gravity);
            0.5 * second_derivative(self.value(input), self.reach(input), of_input) * spread * spread
        };
        self.uncertain.iter().map(bend).sum()
    }

    /// Change of a function of the values with one standard uncertainty of an input; zero where there is none.
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

    /// Computes the size of the changes by all inputs of which this holds; `None` where those that matter have no uncertainty.
    pub(super) fn changes(
        &self,
        of: impl Fn(&Values) -> f64,
        counts: impl Fn(BudgetInput) -> bool,
    ) -> Option<f64> {
        /// Rounding of a ratio that an input drops out of makes slopes of 1e-12.
        const MATTERS: f64 = 1e-9;
        let counted = self.uncertain.iter().filter(|(input, _)| counts(*input));
        let matters = |input| (self.value(input) * self.slope(input, &of)).abs() > MATTERS;
        let (known, open): (Vec<_>, Vec<_>) =
            counted.filter(|(input, _)| matters(*input)).partition(|(_, spread)| spread.is_some());
        let squares = known.iter().map(|(input, _)| self.change(*input, &of)).map(|change| change * change);
        (open.is_empty() || !known.is_empty()).then(|| squares.sum::<f64>().sqrt())
    }

    fn slope(&self, input: BudgetInput, of: impl Fn(&Values) -> f64) -> f64 {
        derivative(self.value(input), self.reach(input), self.along(input, of))
    }

    /// Returns a function of the values as a function of this input.
    fn along(&self, input: BudgetInput, of: impl Fn(&Values) -> f64) -> impl Fn(f64) -> f64 {
        let values = self.values;
        move |x| {
            let mut moved = values;
            if let Some(place) = input.place(&mut moved) {
                *place = x;
            }
            of(&moved)
        }
    }

    fn value(&self, input: BudgetInput) -> f64 {
        let mut values = self.values;
        input.place(&mut values).map_or(f64::NAN, |place| *place)
    }

    /// Distance over which the functions are defined: to zero, and for amplitudes to the top.
    fn reach(&self, input: BudgetInput) -> f64 {
        let amplitude = self.values.amplitude;
        match input {
            BudgetInput::AngleScale if amplitude > 0.0 => ((PI - amplitude) / amplitude).min(1.0),
            _ => self.value(input),
        }
    }
}

fn check(name: &'static str, quantity: Quantity) -> Result<(), BudgetError> {
    let Quantity { value, uncertainty } = quantity;
    let spread = uncertainty.unwrap_or(0.0);
    if !(value > 0.0 && value.is_finite()) {
        return Err(BudgetError::NotPositive { name, value });
    }
    if !(0.0..f64::INFINITY).contains(&spread) {
        return Err(BudgetError::Uncertainty { name, value: spread });
    }
    Ok(())
}
