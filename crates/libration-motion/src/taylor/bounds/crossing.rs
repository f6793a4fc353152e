//! The formula of an event at its zero.

use crate::taylor::program::linearised::{Linearised, ROUNDING};
use crate::taylor::program::moduli::root_of_square;
use crate::taylor::{Contact, Moment, Occurrence, System};
use libration_numbers::{
    expression::{Expression, Function, Symbol},
    internals::expression::Tape,
};

/// The formula whose zero is the event, with the accelerations and rates of change there.
#[derive(Debug)]
pub(in crate::taylor) struct Crossing {
    formulas: Linearised,
    /// The formula of the rate of change of each state component, or the component that equals it.
    speeds: Vec<Speed>,
}

#[derive(Clone, Copy, Debug)]
enum Speed {
    Formula(usize),
    Number(usize),
}

/// The passage of the formula through zero.
#[derive(Debug)]
pub(in crate::taylor) struct Passing {
    /// The derivatives of the formula by the state components.
    pub(in crate::taylor) gradient: Vec<f64>,
    /// The derivative of the formula with respect to time along the motion.
    pub(in crate::taylor) rate: f64,
    /// The value of the formula there, which should be zero.
    pub(in crate::taylor) value: f64,
    /// The rounding error of the formula.
    pub(in crate::taylor) error: f64,
    /// Rates of change of the state components.
    pub(in crate::taylor) speeds: Vec<f64>,
}

impl Crossing {
    /// The arguments of the |…| in the formula of an event, one of which may be zero there, at a kink, and last the formula itself; none if
    /// it contains open parameters without a value.
    pub(in crate::taylor) fn all(system: &System, event: &Occurrence) -> Vec<Self> {
        let formula = &system.events()[event.event].formula;
        // If a formula touches zero, its rate of change passes through zero.
        let whole = match event.contact {
            Contact::Grazing => Self::new(system, &rate_of_change(system, formula)),
            _ => Self::new(system, formula),
        };
        let Some(crossing) = whole else { return vec![] };
        let kinks = arguments(formula).into_iter().filter_map(|argument| Self::new(system, &argument));
        kinks.chain([crossing]).collect()
    }

    /// The index of the first of these formulas that is zero in a state, to rounding errors or within this time of it, or else of the last.
    pub(in crate::taylor) fn zero_at(
        formulas: &mut [Self],
        at: &Moment,
        sizes: &[f64],
        apart: f64,
    ) -> Option<usize> {
        /// Half a unit in the last place of each input, and as much for the formula.
        const MARGIN: f64 = 4.0;
        let is_zero = |formula: &mut Self| {
            let Passing { value, error, rate, .. } = formula.passing(at, sizes);
            value.abs() <= MARGIN * (error + ROUNDING * (rate * at.time).abs()) + (rate * apart).abs()
        };
        let last = formulas.len().checked_sub(1)?;
        Some(formulas[..last].iter_mut().position(is_zero).unwrap_or(last))
    }

    fn new(system: &System, formula: &Expression) -> Option<Self> {
        let (layout, equation) = (system.layout(), system.equation());
        let passes = equation.with_rates(formula);
        let symbols = layout.symbols(equation.variables());
        let inputs: Vec<Symbol> = symbols.into_iter().chain([Symbol::plain("t")]).collect();
        let all: Vec<&Expression> = [&passes].into_iter().chain(equation.derivatives()).collect();
        let tape = Tape::new(&all, &inputs).ok()?;
        let speed = |number: usize| match (layout.driving(number), layout.velocity(number)) {
            (Some(coordinate), _) => Speed::Formula(1 + coordinate),
            (None, velocity) => Speed::Number(velocity.unwrap_or(number)),
        };
        let speeds = (0..layout.numbers()).map(speed).collect();
        Some(Self { formulas: Linearised::new(&tape, 0..all.len(), inputs.len()), speeds })
    }

    /// The passage of the formula in a state, the series of whose components have terms of these sizes.
    pub(in crate::taylor) fn passing(&mut self, at: &Moment, sizes: &[f64]) -> Passing {
        self.formulas.evaluate(&[&at.state[..], &[at.time]].concat());
        let speed = |speed: &Speed| match *speed {
            Speed::Formula(formula) => self.formulas.value(formula),
            Speed::Number(number) => at.state[number],
        };
        let speeds: Vec<f64> = self.speeds.iter().map(speed).collect();
        let (gradient, by_time) = self.formulas.slopes(0).split_at(speeds.len());
        let along = gradient.iter().zip(&speeds).map(|(slope, speed)| slope * speed);
        let rate = by_time.iter().copied().chain(along).sum();
        let of_series: f64 = gradient.iter().zip(sizes).map(|(slope, size)| 2.0 * slope.abs() * size).sum();
        let error = self.formulas.error(0) + ROUNDING * of_series;
        Passing { gradient: gradient.to_vec(), rate, value: self.formulas.value(0), error, speeds }
    }
}

impl Crossing {
    /// The error of the time of a zero, doubled until it encloses the zero: until the signs of the formula are known and opposite this long before
    /// and after. At a zero of multiplicity m a step of Newton's method is an m-th of the distance, and a parabola does not approximate the formula.
    /// `None` if the signs are the same, as about two zeros.
    pub(in crate::taylor) fn enclosing_time(
        &mut self,
        at: &Moment,
        sizes: &[f64],
        late: f64,
        error_of_state: impl Fn(&[f64]) -> f64,
    ) -> Option<f64> {
        /// Steps of Newton's method to a zero of this order, and as far beyond it.
        const FARTHEST: f64 = 2.0 * 16.0;
        /// At a simple zero the formula is as large as its error, to rounding, after the time that the error takes.
        const NEARLY: f64 = 0.9;
        let error_of = |passing: &Passing| passing.error + error_of_state(&passing.gradient);
        let there = self.passing(at, sizes);
        let newton = (there.value.abs() + error_of(&there)) / there.rate.abs();
        let farthest = FARTHEST * if newton.is_finite() { newton.max(late) } else { late };
        let mut sign = |late: f64| {
            let passing = self.passing_later(at, late, sizes);
            let is_known = passing.value.abs() >= NEARLY * error_of(&passing);
            if is_known { passing.value.signum() } else { 0.0 }
        };
        let first = (late > 0.0).then_some(late);
        let mut doubled =
            std::iter::successors(first, |late| Some(2.0 * late)).take_while(|late| *late <= farthest);
        doubled.find(|late| sign(-late) * sign(*late) < 0.0)
    }

    /// The passage at another time, to which the motion is extrapolated by the midpoint rule.
    fn passing_later(&mut self, at: &Moment, late: f64, sizes: &[f64]) -> Passing {
        let moved = |by: f64, speeds: &[f64]| Moment {
            time: at.time + by,
            state: at.state.iter().zip(speeds).map(|(value, speed)| value + by * speed).collect(),
        };
        let at_start = self.passing(at, sizes).speeds;
        let at_middle = self.passing(&moved(0.5 * late, &at_start), sizes).speeds;
        self.passing(&moved(late, &at_middle), sizes)
    }
}

/// The arguments of the |…| and signs in a formula, roots of squares included.
fn arguments(formula: &Expression) -> Vec<Expression> {
    let argument = match formula {
        Expression::Call(Function::Sqrt, base) if let Some(size) = root_of_square(base) => {
            return arguments(&size);
        }
        Expression::Call(Function::Abs | Function::Sign, argument) => Some(Expression::clone(argument)),
        _ => None,
    };
    argument.into_iter().chain(formula.parts().flat_map(arguments)).collect()
}

/// The rate of change of a formula along the motion, as a formula.
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
