//! Swings at which formulas are compared: three built-in ones and the reader's.

use std::ops::RangeInclusive;

use super::check::{Against, Check, CheckedEquation, ComparedAt, DerivationError, Letters, failed, side};
use super::document::Wanted;
use super::evaluate::{Values, evaluate};
use super::formula::{Decimal, DecimalUnit, Formula, Name, Relation, Statement, number, rounded, sin};
use super::numbers::{DIGITS, PRECISION};
use libration::algebra::{BigFloat, Rational, Ring};
use libration::pendulum::{Amplitude, Pendulum};
use libration::quantity::{Angle, STANDARD_GRAVITY};

/// Largest difference of two sides in 77 digits, after a singular integral has lost half of them.
const CLOSE: f64 = 1e-30;
/// Largest difference of two sides, one of which is in double precision.
const CLOSE_IN_DOUBLE: f64 = 2e-14;
/// The largest amplitude in degrees.
const LARGEST: f64 = 179.9;
/// Number of digits of a printed value.
const SHOWN: usize = 11;

/// A pendulum and its amplitude, whose numbers a derivation shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swing {
    /// The pendulum.
    pub pendulum: Pendulum,
    /// The amplitude of the motion.
    pub amplitude: Amplitude,
}

/// Several swings, one of which is shown.
#[derive(Clone, Debug)]
pub struct Trials {
    trials: Vec<Trial>,
    shown: usize,
    /// `Numbers` if the swing shown is the reader's, so that each step gives its numbers.
    wanted: Wanted,
}

/// A swing with the values of its symbols.
#[derive(Clone, Debug)]
struct Trial {
    angle: Angle,
    amplitude: Decimal,
    /// Parameters of the pendulum and the swing.
    given: Vec<(Name, Decimal)>,
    values: Values<BigFloat>,
}

impl Trials {
    /// Three amplitudes of a pendulum of one metre, and the reader's swing if there is one.
    pub fn new(reader: Option<&Swing>) -> Result<Self, DerivationError> {
        let mut trials = Vec::new();
        for degrees in [20.0, 60.0, 120.0] {
            trials.push(Trial::new(&example(degrees)?)?);
        }
        let (mut shown, mut wanted) = (1, Wanted::Formulas);
        if let Some(swing) = reader {
            let degrees = swing.amplitude.angle().degrees();
            if !(0.01..=LARGEST).contains(&degrees) {
                return Err(DerivationError::Amplitude { degrees, largest: LARGEST });
            }
            (shown, wanted) = (trials.len(), Wanted::Numbers);
            trials.push(Trial::new(swing)?);
        }
        Ok(Self { trials, shown, wanted })
    }

    /// Several choices of symbols, without pendulum.
    pub fn choices() -> Result<Self, DerivationError> {
        let mut trials = Self::new(None)?;
        for trial in &mut trials.trials {
            trial.values = Values::default();
        }
        Ok(Self { shown: 0, ..trials })
    }

    /// Assigns to a name its value in each choice.
    pub fn choose(&mut self, name: &Name, value: &dyn Fn(usize) -> Formula) -> Result<(), DerivationError> {
        for (choice, trial) in self.trials.iter_mut().enumerate() {
            let value = value(choice);
            let number = side(&Statement::from(value.clone()), &value, &DIGITS, &trial.values)?;
            trial.values.set(name, number);
        }
        Ok(())
    }

    /// Declares that a name changes in time at the rate that the next prime denotes.
    pub(super) fn let_move(&mut self, name: &Name) {
        for trial in &mut self.trials {
            trial.values.set_rate(name, name.clone().prime().into());
        }
    }

    /// Checks a statement for every choice of the symbols.
    pub fn compare_choices(&self, statement: Statement) -> Result<CheckedEquation, DerivationError> {
        let compared_at = ComparedAt::Choices { choices: self.trials.len() };
        self.compare_within(CLOSE, (compared_at, Against::OtherSide), statement)
    }

    /// Defines a name in every swing.
    pub(super) fn define(&mut self, name: &Name, value: Formula) -> Result<CheckedEquation, DerivationError> {
        let statement = Statement::defined(name, value.clone());
        for trial in &mut self.trials {
            let value = side(&statement, &value, &DIGITS, &trial.values)?;
            trial.values.set(name, value);
        }
        Ok(CheckedEquation::definition(statement))
    }

    /// Defines a function in every swing.
    pub(super) fn define_function(
        &mut self,
        name: &str,
        parameters: &[&str],
        body: Formula,
    ) -> CheckedEquation {
        let function = Name::new(name);
        for trial in &mut self.trials {
            trial.values.define(&function, parameters, body.clone());
        }
        let arguments = parameters.iter().map(|parameter| Formula::Name(Name::new(parameter))).collect();
        CheckedEquation::definition(Statement::defined(Formula::Apply(function, arguments), body))
    }

    /// The trials with a further value that is not shown.
    pub(super) fn with(&self, name: &Name, value: Formula) -> Result<Self, DerivationError> {
        let mut trials = self.clone();
        trials.define(name, value)?;
        Ok(trials)
    }

    /// The trials with a further function of one parameter that is not shown.
    pub(super) fn with_function(&self, name: &Name, parameter: &str, body: Formula) -> Self {
        let mut trials = self.clone();
        for trial in &mut trials.trials {
            trial.values.define(name, &[parameter], body.clone());
        }
        trials
    }

    /// Checks a statement in all digits.
    pub fn compare(&self, statement: Statement) -> Result<CheckedEquation, DerivationError> {
        self.compare_within(CLOSE, (self.amplitudes(), Against::OtherSide), statement)
    }

    /// Checks a statement, one side of which is the library's exact solution.
    pub fn compare_with_library(&self, statement: Statement) -> Result<CheckedEquation, DerivationError> {
        self.compare_within(CLOSE_IN_DOUBLE, (self.amplitudes(), Against::Library), statement)
    }

    fn amplitudes(&self) -> ComparedAt {
        let at = self.trials[self.shown].amplitude.clone();
        let amplitudes = self.trials.iter().map(|trial| trial.amplitude.clone()).collect();
        ComparedAt::Amplitudes { at, amplitudes }
    }

    fn compare_within(
        &self,
        tolerance: f64,
        (compared_at, against): (ComparedAt, Against),
        statement: Statement,
    ) -> Result<CheckedEquation, DerivationError> {
        let mut difference = 0.0_f64;
        let mut shown = 0.0;
        for (n, trial) in self.trials.iter().enumerate() {
            let comparison = trial.compare(tolerance, &statement)?;
            difference = difference.max(comparison.difference);
            if n == self.shown {
                shown = comparison.value;
            }
        }
        let letters = self.trials[self.shown].letters(&statement);
        Ok(TrialComparison { value: shown, difference }
            .equation(statement, compared_at, against)
            .with_letters(letters))
    }

    /// Checks a statement that does not depend on the amplitude.
    pub fn compare_once(&self, statement: Statement) -> Result<CheckedEquation, DerivationError> {
        let shown = &self.trials[self.shown];
        let comparison = shown.compare(CLOSE, &statement)?;
        let letters = shown.letters(&statement);
        let equation = comparison.equation(statement, ComparedAt::Everywhere, Against::OtherSide);
        Ok(equation.with_letters(letters))
    }

    /// Checks a statement for several values of an index.
    pub(super) fn compare_cases(
        &self,
        index: &str,
        cases: RangeInclusive<i64>,
        statement: Statement,
    ) -> Result<CheckedEquation, DerivationError> {
        let index = Name::new(index);
        let (first, last) = (*cases.start(), *cases.end());
        let mut trial = self.trials[self.shown].clone();
        let mut worst: Option<TrialComparison> = None;
        for case in cases {
            trial.values.set_index(&index, case);
            let here = trial.compare(CLOSE, &statement)?;
            worst = Some(worst.map_or(here, |worst| worst.with(here)));
        }
        let comparison = worst.unwrap_or(TrialComparison { value: 0.0, difference: 0.0 });
        let letters = trial.letters(&statement);
        let compared_at = ComparedAt::Cases { index, first, last };
        Ok(comparison.equation(statement, compared_at, Against::OtherSide).with_letters(letters))
    }

    /// The swings up to this amplitude in degrees, for formulas that converge slowly above it.
    pub(super) fn up_to(&self, degrees: i64) -> Self {
        let limit = Rational::from(degrees);
        let low = |trial: &&Trial| trial.amplitude.value().is_some_and(|amplitude| amplitude <= limit);
        let trials: Vec<Trial> = self.trials.iter().filter(low).cloned().collect();
        let shown = if self.shown < trials.len() { self.shown } else { 1 };
        Self { trials, shown, ..*self }
    }

    /// The numbers of the reader's swing, each with its digits and unit; empty if no swing was given.
    pub(super) fn numbers(
        &self,
        wanted: &[(Formula, usize, DecimalUnit)],
    ) -> Result<Vec<CheckedEquation>, DerivationError> {
        let wanted = if self.wanted == Wanted::Numbers { wanted } else { &[] };
        let trial = &self.trials[self.shown];
        let shown = &trial.values;
        let number = |(formula, digits, unit): &(Formula, usize, DecimalUnit)| {
            let statement = Statement::from(formula.clone());
            let value = side(&statement, formula, &DIGITS, shown)?.to_f64();
            let printed =
                value * if *unit == DecimalUnit::Degree { 180.0 / std::f64::consts::PI } else { 1.0 };
            let statement = statement.and(Relation::Rounded, rounded(printed, *digits, *unit));
            check_rounding(&statement, shown)?;
            let letters = trial.letters(&statement);
            Ok(CheckedEquation::new(statement, Check::RoundedDigits).with_letters(letters))
        };
        wanted.iter().map(number).collect()
    }

    /// The value of a formula for the swing that is shown.
    pub(super) fn value(&self, formula: &Formula) -> Result<BigFloat, DerivationError> {
        side(&Statement::from(formula.clone()), formula, &DIGITS, &self.trials[self.shown].values)
    }

    /// The reader's pendulum and amplitude; empty if no swing was given.
    pub(super) fn given(&self) -> Vec<CheckedEquation> {
        let shown = match self.wanted {
            Wanted::Formulas => &[],
            Wanted::Numbers => &self.trials[self.shown..=self.shown],
        };
        let equation = |(name, value): &(Name, Decimal)| {
            let statement = Statement::equal(name, Formula::Decimal(value.clone()));
            CheckedEquation::new(statement, Check::Given)
        };
        shown.iter().flat_map(|trial| trial.given.iter().map(equation)).collect()
    }

    /// The level of detail: formulas alone, or numbers too.
    pub(super) fn wanted(&self) -> Wanted {
        self.wanted
    }

    /// Checks that a formula agrees with a function of the amplitude in double precision.
    pub(super) fn agrees_with(
        &self,
        statement: &Statement,
        formula: &Formula,
        function: impl Fn(&Angle) -> f64,
    ) -> Result<(), DerivationError> {
        for trial in &self.trials {
            let (here, there) = (trial.side(statement, formula)?.value.to_f64(), function(&trial.angle));
            let difference = (here - there).abs() / there.abs();
            if difference.is_nan() || difference > CLOSE_IN_DOUBLE {
                return Err(failed(statement, format!("it is {here}, and the catalogue says {there}")));
            }
        }
        Ok(())
    }

    /// The amplitude shown.
    pub(super) fn angle(&self) -> Angle {
        self.trials[self.shown].angle
    }

    /// The amplitude shown, in degrees.
    pub(super) fn amplitude(&self) -> Formula {
        Formula::Decimal(self.trials[self.shown].amplitude.clone())
    }
}

/// Checks that the last formula of a statement, a decimal, is the first one rounded.
fn check_rounding(statement: &Statement, values: &Values<BigFloat>) -> Result<(), DerivationError> {
    let Some((_, Formula::Decimal(decimal))) = statement.rest.last() else { return Ok(()) };
    let unit = Formula::Decimal(Decimal { mantissa: "1".to_owned(), exponent: 0, unit: decimal.unit });
    let last_place = decimal.last_place().map(|last| Formula::from(last) * unit).unwrap_or_else(|| number(0));
    let exact = side(statement, &statement.first, &DIGITS, values)?;
    let printed = side(statement, &Formula::Decimal(decimal.clone()), &DIGITS, values)?;
    let last_digit = side(statement, &last_place, &DIGITS, values)?.to_f64();
    // The double nearest to the value was rounded, and not the value itself.
    let slack = 2.0 * f64::EPSILON * exact.to_f64().abs();
    let difference = (exact - printed).to_f64().abs();
    if difference <= 0.5 * last_digit + slack {
        Ok(())
    } else {
        Err(failed(statement, format!("the value printed is off by {difference:e}")))
    }
}

fn example(degrees: f64) -> Result<Swing, DerivationError> {
    let pendulum = Pendulum::new(1.0, STANDARD_GRAVITY)?;
    let angle = Angle::from_degrees(degrees).expect("the degrees are finite");
    Ok(Swing { pendulum, amplitude: Amplitude::new(angle)? })
}

impl Trial {
    /// The symbols g, ℓ, ω0, θ0; θ and θ′ from the library's closed solution at a
    /// time at which the pendulum rises from the bottom; and T from its period.
    fn new(swing: &Swing) -> Result<Self, DerivationError> {
        let angle = swing.amplitude.angle();
        let motion = swing.pendulum.released_from(angle)?;
        let moment = motion.state_at(0.86 * motion.period());
        let exactly =
            |value: f64| BigFloat::from_f64(value, PRECISION).expect("states of a pendulum are finite");
        let mut values = Values::default();
        let mut omega = exactly(swing.pendulum.angular_frequency());
        let amplitude = Decimal::short(angle.degrees(), DecimalUnit::Degree);
        let mut given = vec![(Name::new("θ").index(0), amplitude.clone())];
        if let (Some(length), Some(gravity)) = (swing.pendulum.length(), swing.pendulum.gravity()) {
            given.push((Name::new("ℓ"), Decimal::short(length, DecimalUnit::Metre)));
            given.push((Name::new("g"), Decimal::short(gravity, DecimalUnit::MetrePerSecondSquared)));
            let (length, gravity) = (exactly(length), exactly(gravity));
            omega = (gravity.clone() / length.clone()).sqrt();
            values.set(&Name::new("ℓ"), length);
            values.set(&Name::new("g"), gravity);
        }
        let [high, low] = angle.in_turn_in_two_words();
        let half_turn = BigFloat::pi(PRECISION);
        values.set(&Name::new("T").index(0), (half_turn.clone() + half_turn) / omega.clone());
        values.set(&Name::new("ω").index(0), omega);
        values.set(&Name::new("θ").index(0), exactly(high) + exactly(low));
        values.set(&Name::new("T"), exactly(swing.pendulum.period(&swing.amplitude)));
        values.set(&Name::new("θ"), exactly(moment.angle));
        values.set(&Name::new("θ").prime(), exactly(moment.velocity));
        let mut trial = Self { angle, amplitude, given, values };
        trial.let_time_run();
        Ok(trial)
    }

    /// Declares that θ changes at the rate θ′, and θ′ at the rate θ″, by the equation of motion.
    fn let_time_run(&mut self) {
        let (theta, omega) = (Name::new("θ"), Name::new("ω").index(0));
        let velocity = theta.clone().prime();
        let acceleration = velocity.clone().prime();
        let law = -(Formula::from(&omega).squared() * sin(&theta));
        if let Ok(value) = evaluate(&law, &DIGITS, &self.values) {
            self.values.set(&acceleration, value);
        }
        self.values.set_rate(&theta, (&velocity).into());
        self.values.set_rate(&velocity, acceleration.into());
    }

    /// Compares neighbours in the chain.
    fn compare(&self, tolerance: f64, statement: &Statement) -> Result<TrialComparison, DerivationError> {
        let first = self.side(statement, &statement.first)?;
        let value = first.value.to_f64();
        let mut difference = 0.0_f64;
        let mut left = first;
        for (relation, right) in &statement.rest {
            let right = self.side(statement, right)?;
            difference = difference.max(left.difference(*relation, &right));
            left = right;
        }
        if difference <= tolerance {
            return Ok(TrialComparison { value, difference });
        }
        let at = &self.amplitude.mantissa;
        Err(failed(statement, format!("at {at} its sides differ by {difference:e} of their size")))
    }

    /// The values of the names in a statement, to double precision.
    fn letters(&self, statement: &Statement) -> Letters {
        const DIGITS_OF_DOUBLE: usize = 17;
        let sides: Vec<&Formula> =
            [&statement.first].into_iter().chain(statement.rest.iter().map(|(_, side)| side)).collect();
        let (numbers, functions) = self.values.used_in(&sides);
        let rounded = |value: &BigFloat| rounded(value.to_f64(), DIGITS_OF_DOUBLE, DecimalUnit::One);
        Letters {
            values: numbers.into_iter().map(|(name, value)| (name, rounded(&value))).collect(),
            functions,
        }
    }

    fn side(&self, statement: &Statement, formula: &Formula) -> Result<Side, DerivationError> {
        let terms = match formula {
            Formula::Sum(terms) => terms.as_slice(),
            term => std::slice::from_ref(term),
        };
        let mut sum = Side { value: DIGITS.zero(), size: 0.0 };
        for term in terms {
            let term = side(statement, term, &DIGITS, &self.values)?;
            sum = Side { size: sum.size + term.to_f64().abs(), value: sum.value + term };
        }
        Ok(sum)
    }
}

/// The value of a side, and the sum of the magnitudes of its summands, to which a difference is relative.
struct Side {
    value: BigFloat,
    size: f64,
}

impl Side {
    fn difference(&self, relation: Relation, other: &Self) -> f64 {
        if relation == Relation::Less {
            return if self.value < other.value { 0.0 } else { f64::INFINITY };
        }
        let difference = DIGITS.subtract(&self.value, &other.value).to_f64().abs();
        if difference == 0.0 { 0.0 } else { difference / self.size.max(other.size) }
    }
}

/// The value of the first side and its largest distance from the others.
#[derive(Clone, Copy)]
struct TrialComparison {
    value: f64,
    difference: f64,
}

impl TrialComparison {
    /// The value of this comparison, with the larger of the two differences.
    fn with(self, other: Self) -> Self {
        Self { difference: self.difference.max(other.difference), ..self }
    }

    fn equation(self, statement: Statement, compared_at: ComparedAt, against: Against) -> CheckedEquation {
        let value = Decimal::rounded(self.value, SHOWN, DecimalUnit::One);
        CheckedEquation::new(
            statement,
            Check::Digits { compared_at, value, difference: self.difference, against },
        )
    }
}
