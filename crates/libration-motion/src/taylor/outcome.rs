//! How time and state at the end of a motion depend on the state there, where an event ends it or a given time.

use super::roundings::{ROUNDING, Rounded, rounded_values};
use super::survey::Survey;
use super::{Contact, Moment, System};
use libration_numbers::{
    expression::{Expression, Symbol},
    internals::expression::Tape,
};

/// The numbers of the state at the end and its time, the latter last: results of a survey.
#[derive(Clone, Debug)]
pub(super) struct Outcome {
    /// Of each result the derivatives by the state at that time.
    pub(super) slopes: Vec<Vec<f64>>,
    /// What rounding adds at the end itself.
    pub(super) own: Vec<f64>,
}

impl Outcome {
    /// `None` where the formula of the event has no derivatives.
    pub(super) fn new(system: &System, survey: &Survey) -> Option<Self> {
        let end = &survey.solution.end;
        let Some(event) = &survey.ending else { return Some(Self::at_given_time(end)) };
        let formula = &system.events()[event.event].formula;
        // Where a formula touches zero it is its rate of change that passes through it.
        let passes = match event.contact {
            Contact::Grazing => rate_of_change(system, formula),
            _ => system.equation().with_rates(formula),
        };
        let passing = Passing::new(system, survey, &passes)?;
        Some(passing.outcome(end))
    }

    fn at_given_time(end: &Moment) -> Self {
        let numbers = end.state.len();
        let row = |result: usize| (0..numbers).map(|number| f64::from(u8::from(number == result))).collect();
        let own = end.state.iter().map(|value| ROUNDING * value.abs()).chain([0.0]).collect();
        Self { slopes: (0..=numbers).map(row).collect(), own }
    }
}

/// How fast a formula changes along the motion, as a formula.
fn rate_of_change(system: &System, formula: &Expression) -> Expression {
    let (layout, equation) = (system.layout(), system.equation());
    let symbols = layout.symbols(equation.variables());
    let formula = equation.with_rates(formula);
    let speed = |number: usize| match layout.driving(number) {
        Some(coordinate) => equation.derivatives()[coordinate].clone(),
        None => layout
            .velocity(number)
            .map_or_else(|| Expression::from(0), |velocity| Expression::Symbol(symbols[velocity].clone())),
    };
    let term = |(number, symbol)| {
        Expression::Multiply(Box::new(formula.derivative(symbol)), Box::new(speed(number)))
    };
    let terms = symbols.iter().enumerate().map(term);
    let by_time = formula.derivative(&Symbol::plain("t"));
    terms.fold(by_time, |sum, term| Expression::Add(Box::new(sum), Box::new(term))).simplified()
}

/// How the formula of an event passes zero.
#[derive(Debug)]
struct Passing {
    /// Its derivatives by the numbers of the state.
    gradient: Vec<f64>,
    /// That by the time along the survey.
    rate: f64,
    /// What it loses by rounding.
    error: f64,
    /// How fast the numbers of the state change.
    speeds: Vec<f64>,
}

impl Passing {
    fn new(system: &System, survey: &Survey, formula: &Expression) -> Option<Self> {
        let (layout, end) = (system.layout(), &survey.solution.end);
        let symbols = layout.symbols(system.equation().variables());
        let inputs: Vec<Symbol> = symbols.iter().cloned().chain([Symbol::plain("t")]).collect();
        let slopes: Vec<Expression> = inputs.iter().map(|symbol| formula.derivative(symbol)).collect();
        let forces = system.equation().derivatives();
        let all: Vec<&Expression> = slopes.iter().chain(forces).chain([formula]).collect();
        let tape = Tape::new(&all, &inputs).ok()?;
        let values = rounded_values(&tape, &[&end.state[..], &[end.time]].concat())?;
        let (slopes, rest) = values.split_at(inputs.len());
        let (forces, formula) = rest.split_at(forces.len());
        let speed = |number: usize| match layout.driving(number) {
            Some(coordinate) => forces[coordinate].value,
            None => layout.velocity(number).map_or(0.0, |velocity| end.state[velocity]),
        };
        let speeds: Vec<f64> = (0..layout.numbers()).map(speed).collect();
        let (by_time, gradient) = slopes.split_last()?;
        let gradient: Vec<f64> = gradient.iter().map(|slope| slope.value).collect();
        let rate = by_time.value + gradient.iter().zip(&speeds).map(|(a, b)| a * b).sum::<f64>();
        let of_series: f64 =
            gradient.iter().zip(&survey.sizes).map(|(slope, size)| 2.0 * slope.abs() * size).sum();
        let error = ROUNDING * (formula.iter().map(|it: &Rounded| it.error).sum::<f64>() + of_series);
        Some(Self { gradient, rate, error, speeds })
    }

    /// The time moves against the deviation of the formula over its rate, and the state with it.
    fn outcome(&self, end: &Moment) -> Outcome {
        let time: Vec<f64> = self.gradient.iter().map(|slope| -slope / self.rate).collect();
        let late = (self.error / self.rate).abs() + ROUNDING * end.time.abs();
        let row = |(number, speed): (usize, &f64)| {
            let own = |(column, slope): (usize, &f64)| f64::from(u8::from(column == number)) + speed * slope;
            time.iter().enumerate().map(own).collect()
        };
        let slopes = self.speeds.iter().enumerate().map(row).chain([time.clone()]).collect();
        let own = self.speeds.iter().zip(&end.state);
        let own =
            own.map(|(speed, value)| late * speed.abs() + ROUNDING * value.abs()).chain([late]).collect();
        Outcome { slopes, own }
    }
}
