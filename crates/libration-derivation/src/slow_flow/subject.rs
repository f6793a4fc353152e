//! Subject of the derivation: the steps of a slow flow as formulas, and choices of the symbols in them.

use super::super::check::{CheckedEquation, DerivationError, Given, chosen, same_series_for_choices};
use super::super::formula::{Formula, Name, Statement, cos, number, order, scaled};
use super::super::trials::Trials;
use libration::algebra::Rational;
use libration::expression::{Equation, Expression, Symbol};
use libration::perturbation::{SlowFlowSteps, SymbolicSlowFlow, SymbolicSlowFlowOptions, slow_flow_steps};
use libration::progress::Progress;

/// Number of choices of the symbols in checks of power series.
const CHOICES: usize = 3;

/// Number of sets of choices that are tried where formulas contain roots.
const SEEDS: usize = 12;

/// A slow flow with its equation of motion.
pub(super) struct SlowFlowSubject {
    pub(super) equation: Equation,
    pub(super) steps: SlowFlowSteps,
    /// Small parameters with their orders.
    pub(super) small: Vec<(String, usize)>,
    /// Values of the symbols, and of the motion at one phase.
    pub(super) trials: Trials,
}

impl SlowFlowSubject {
    pub(super) fn new(
        equation: &Equation,
        options: &SymbolicSlowFlowOptions,
        progress: &dyn Progress,
    ) -> Result<Self, DerivationError> {
        let steps = slow_flow_steps(equation, options, progress)?.ok_or(DerivationError::SeveralOrders)?;
        let changes = steps.before.iter().flat_map(|before| before.names.iter().map(String::as_str));
        let taken = ["psi", "t", "A_start", "phi_start"]
            .into_iter()
            .chain(changes)
            .find(|name| equation.parameters().contains(*name));
        if let Some(letter) = taken {
            return Err(DerivationError::TakenLetter { letter: letter.to_owned() });
        }
        let mut small = options.small.clone();
        if small.is_empty() && equation.parameters().contains(BOOKKEEPING) {
            small.push((BOOKKEEPING.to_owned(), 1));
        }
        let subject = Self { equation: equation.clone(), steps, small, trials: Trials::choices()? };
        for (meaning, letter) in [("amplitude", "A"), ("phase", "phi"), ("detuning", "sigma")] {
            if subject.meaning(meaning).is_some_and(|name| name != letter) {
                return Err(DerivationError::TakenLetter { letter: letter.to_owned() });
            }
        }
        let trials = subject.chosen(0)?;
        Ok(Self { trials, ..subject })
    }

    pub(super) fn flow(&self) -> &SymbolicSlowFlow {
        &self.steps.flow
    }

    /// A formula of the result; its small parameter `eps` becomes ε.
    pub(super) fn read(&self, text: &str) -> Result<Expression, DerivationError> {
        let what = "a formula and its text";
        text.parse().map_err(|_| DerivationError::Disagreement { what })
    }

    pub(super) fn formula(&self, text: &str) -> Result<Formula, DerivationError> {
        Ok(self.written(&self.read(text)?))
    }

    pub(super) fn written(&self, expression: &Expression) -> Formula {
        let is_free = !self.equation.parameters().contains("epsilon");
        let greek = Expression::Symbol(Symbol::plain("epsilon"));
        let written = expression.substitute(&Symbol::plain(BOOKKEEPING), &greek);
        Formula::from(if is_free { &written } else { expression })
    }

    pub(super) fn name(&self, symbol: &str) -> Name {
        match self.written(&Expression::Symbol(Symbol::plain(symbol))) {
            Formula::Name(name) => name,
            _ => Name::new(symbol),
        }
    }

    /// The name with this meaning in the result.
    pub(super) fn meaning(&self, meaning: &str) -> Option<&str> {
        self.flow().letters.iter().find(|(other, _)| *other == meaning).map(|(_, name)| name.as_str())
    }

    pub(super) fn amplitude(&self) -> Name {
        self.name(self.meaning("amplitude").unwrap_or("A"))
    }

    pub(super) fn phase(&self) -> Name {
        self.name(self.meaning("phase").unwrap_or("phi"))
    }

    pub(super) fn detuning(&self) -> Name {
        self.name(self.meaning("detuning").unwrap_or("sigma"))
    }

    pub(super) fn omega0(&self) -> Result<Formula, DerivationError> {
        self.formula(&self.flow().natural_frequency)
    }

    pub(super) fn omega0_squared(&self) -> Result<Formula, DerivationError> {
        Ok(match self.omega0_as_number()? {
            Some(value) => Formula::Number(value.clone() * value),
            None => self.omega0()?.squared(),
        })
    }

    /// factor·ω0ⁿ·rest, with the value of ω0 in the factor if it is a number.
    pub(super) fn times_omega0(
        &self,
        factor: i64,
        power: u8,
        rest: Formula,
    ) -> Result<Formula, DerivationError> {
        let factor = Rational::from(factor);
        Ok(match self.omega0_as_number()? {
            Some(value) => scaled(&(0..power).fold(factor, |product, _| product * value.clone()), rest),
            None => {
                let raised = if power == 1 { self.omega0()? } else { self.omega0()?.pow(i64::from(power)) };
                scaled(&factor, raised * rest)
            }
        })
    }

    /// 2πn·ω0.
    pub(super) fn turns(&self, n: i64) -> Result<Formula, DerivationError> {
        Ok(match self.omega0_as_number()? {
            Some(value) => scaled(&(Rational::from(2 * n) * value), Formula::Pi),
            None => number(2 * n) * Formula::Pi * self.omega0()?,
        })
    }

    fn omega0_as_number(&self) -> Result<Option<Rational>, DerivationError> {
        Ok(self.read(&self.flow().natural_frequency)?.to_rational())
    }

    pub(super) fn variable(&self) -> Name {
        self.name(&self.equation.variables()[0])
    }

    /// A name of a function that is not a symbol of the equation.
    pub(super) fn function(&self, names: [&'static str; 3]) -> &'static str {
        let free = names.into_iter().find(|name| !self.equation.parameters().contains(*name));
        free.unwrap_or("Z")
    }

    /// A Greek letter that the equation does not contain under its name.
    pub(super) fn free_letter(&self, letters: [(&str, &str); 2]) -> Name {
        let parameters = self.equation.parameters();
        let free = letters.into_iter().find(|(name, _)| !parameters.contains(*name));
        free.map_or_else(|| Name::new("η"), |(_, letter)| Name::new(letter))
    }

    /// The drive frequency, as a symbol or a number.
    pub(super) fn drive(&self) -> Result<Option<Formula>, DerivationError> {
        self.meaning("drive_frequency").map(|text| self.formula(text)).transpose()
    }

    /// p/q of the resonance.
    pub(super) fn resonance(&self) -> Rational {
        let (p, q) = self.flow().resonance.unwrap_or((1, 1));
        Rational::new(p.into(), q.into()).unwrap_or_else(|| 1.into())
    }

    /// ψ′ without φ′: (q/p)·W by ω0 and the detuning.
    pub(super) fn turning(&self) -> Result<Option<Formula>, DerivationError> {
        let Some(detuning) = &self.steps.detuning else { return Ok(None) };
        let inverse = Rational::from(1).checked_div(&self.resonance()).unwrap_or_else(|| 1.into());
        Ok(Some(scaled(&inverse, self.formula(detuning)?)))
    }

    /// ψ′ − ω0, with this rate for φ′.
    pub(super) fn excess(&self, turn: Formula) -> Result<Formula, DerivationError> {
        Ok(match self.turning()? {
            Some(turning) => turning + turn,
            None => turn,
        })
    }

    /// The phase of the motion.
    pub(super) fn angle(&self) -> Result<Formula, DerivationError> {
        let time = Formula::from(Name::new("t"));
        let inverse = Rational::from(1).checked_div(&self.resonance()).unwrap_or_else(|| 1.into());
        let fast = match self.drive()? {
            Some(Formula::Number(frequency)) => scaled(&(frequency * inverse), time),
            Some(frequency) => scaled(&inverse, frequency * time),
            None => self.times_omega0(1, 1, time)?,
        };
        Ok(fast + Formula::from(self.phase()))
    }

    /// Values of all symbols: those of the equation, amplitude, phase and detuning are free, the others follow.
    fn chosen(&self, seed: usize) -> Result<Trials, DerivationError> {
        let mut trials = Trials::choices()?;
        for (index, symbol) in self.free().into_iter().enumerate() {
            let number = index * (seed + 1) % 19;
            trials.choose(&self.name(&symbol), &|choice| Formula::Number(chosen(number, choice)))?;
        }
        self.complete(trials)
    }

    /// The names whose values are free.
    fn free(&self) -> Vec<String> {
        let drive = self.meaning("drive_frequency");
        let mut free: Vec<String> = self.equation.parameters().into_iter().collect();
        free.retain(|name| Some(name.as_str()) != drive);
        let slow = ["amplitude", "phase", "detuning"].map(|meaning| self.meaning(meaning));
        free.extend(slow.into_iter().flatten().map(str::to_owned));
        free.push("psi".to_owned());
        free
    }

    /// The values that follow from those of the free names.
    fn complete(&self, mut trials: Trials) -> Result<Trials, DerivationError> {
        if let (Some(name), Some(value)) =
            (self.meaning("natural_frequency"), self.meaning("natural_frequency_value"))
        {
            trials.define(&self.name(name), self.formula(value)?)?;
        }
        if let (Some(Formula::Name(drive)), Some(value)) = (self.drive()?, &self.flow().drive_frequency) {
            trials.define(&drive, self.formula(value)?)?;
        }
        // In sums of waves ψ and the phase of the drive are independent, but for the phase φ.
        let since = Formula::from(Name::new("ψ")) - Formula::from(self.phase());
        let time = match self.drive()? {
            Some(frequency) => scaled(&self.resonance(), since) / frequency,
            None => since / self.omega0()?,
        };
        trials.define(&Name::new("t"), time)?;
        for (name, text) in [self.variable(), self.variable().prime()].iter().zip(&self.steps.motion[0]) {
            trials.define(name, self.formula(text)?)?;
        }
        if let Some(before) = &self.steps.before {
            for (name, text) in before.names.iter().zip(&before.motion[0]) {
                trials.define(
                    &self.name(name),
                    if text.is_empty() { number(0) } else { self.formula(text)? },
                )?;
            }
        }
        let [growth, turning] = self.rates()?;
        trials.define(&self.amplitude().prime(), growth)?;
        trials.define(&self.phase().prime(), turning)?;
        Ok(trials)
    }

    /// `true` if A′ or φ′ depends on φ.
    pub(super) fn depends_on_phase(&self) -> Result<bool, DerivationError> {
        let phase = self.meaning("phase").unwrap_or("phi");
        let rates = [self.read(&self.flow().amplitude_rate)?, self.read(&self.flow().phase_rate)?];
        Ok(rates.iter().any(|rate| rate.symbols().into_iter().any(|symbol| symbol.name == phase)))
    }

    /// A′ and φ′.
    pub(super) fn rates(&self) -> Result<[Formula; 2], DerivationError> {
        Ok([self.formula(&self.flow().amplitude_rate)?, self.formula(&self.flow().phase_rate)?])
    }

    /// The first result of choices for which all roots are real.
    pub(super) fn where_real<T>(
        &self,
        of: impl Fn(Trials) -> Result<T, DerivationError>,
    ) -> Result<T, DerivationError> {
        let mut outcome = of(self.trials.clone());
        for seed in 1..SEEDS {
            if !matches!(outcome, Err(DerivationError::Unchecked { .. })) {
                break;
            }
            outcome = of(self.chosen(seed)?);
        }
        outcome
    }

    /// Values for which amplitude and phase are steady: the detuning follows, and one symbol in which A′ is linear. `None` if there is none.
    pub(super) fn steady_trials(&self) -> Result<Option<Trials>, DerivationError> {
        let free = self.free();
        let Some(detuning) = self.meaning("detuning") else { return Ok(None) };
        let [growth, turning] =
            [self.read(&self.flow().amplitude_rate)?, self.read(&self.flow().phase_rate)?];
        let root = |of: &Expression, symbol: &str| {
            let unknown = Symbol::plain(symbol);
            let is_linear = of.polynomial_degree(std::slice::from_ref(&unknown)) == Some(1);
            let at = |value: i64| of.substitute(&unknown, &Expression::from(value)).simplified();
            let [zero, one] = [at(0), at(1)];
            (is_linear && !zero.vanishes())
                .then(|| -self.written(&zero) / (self.written(&one) - self.written(&zero)))
        };
        let Some((symbol, value)) = free.iter().find_map(|symbol| Some((symbol, root(&growth, symbol)?)))
        else {
            return Ok(None);
        };
        let Some(sigma) = root(&turning, detuning) else { return Ok(None) };
        let mut trials = self.trials.clone();
        trials.define(&self.name(symbol), value)?;
        trials.define(&self.detuning(), sigma)?;
        self.complete(trials).map(Some)
    }

    /// Checks an equation without abs and sign to the lowest order, or exactly where it is exact.
    pub(super) fn to_lowest_order(
        &self,
        statement: Statement,
        acceleration: &Formula,
    ) -> Result<CheckedEquation, DerivationError> {
        let second = self.variable().prime().prime();
        let trials = self.trials.with(&second, acceleration.clone())?;
        match trials.compare_choices(statement.clone()) {
            Err(DerivationError::Failed { .. }) => {}
            exact => return exact,
        }
        if self.steps.terms.iter().any(|term| term.waves.is_none()) {
            return Err(DerivationError::SeveralOrders);
        }
        let top = self.flow().order + usize::from(self.steps.is_by_amplitude);
        let variable = Name::new("ε");
        let power = |n: usize| Formula::from(&variable).pow(i64::try_from(n).unwrap_or(i64::MAX));
        let still: Vec<String> = self.steps.terms.iter().map(|term| term.force[0].clone()).collect();
        let is_in_drive = |symbol: &str| {
            let x = &self.equation.variables()[0];
            let has = |text: &String, name: &str| {
                let read = self.read(text).ok();
                read.is_some_and(|read| read.symbols().into_iter().any(|symbol| symbol.name == name))
            };
            still.iter().any(|text| has(text, symbol) && !has(text, x))
        };
        let given = |choice: usize| -> Vec<Given<'static>> {
            let mut all = vec![];
            for (index, symbol) in self.free().into_iter().enumerate() {
                let order =
                    self.small.iter().find(|(name, _)| *name == symbol).map_or(0, |(_, order)| *order);
                let raised =
                    order + usize::from(order > 0 && self.steps.is_by_amplitude && is_in_drive(&symbol));
                let name = self.name(&symbol);
                if name != variable {
                    all.push(Given::Value(name, Formula::Number(chosen(index, choice)) * power(raised)));
                }
            }
            if let (Ok(Some(Formula::Name(drive))), Some(value)) =
                (self.drive(), &self.flow().drive_frequency)
            {
                all.extend(self.formula(value).ok().map(|value| Given::Value(drive, value)));
            }
            let moving = power(usize::from(self.steps.is_by_amplitude));
            all.push(Given::Value(Name::new("t"), number(1)));
            for (name, tenths) in [(self.variable(), 7), (self.variable().prime(), 4)] {
                all.push(Given::Value(name, Formula::Number(chosen(tenths, choice)) * moving.clone()));
            }
            all.push(Given::Value(second.clone(), acceleration.clone()));
            all
        };
        let mut rounded = statement;
        if let Some((_, side)) = rounded.rest.last_mut() {
            *side = side.clone() + order(power(top + 1));
        }
        same_series_for_choices(&variable, top + 1, CHOICES, &given, rounded)
    }
}

/// The name of the symbol that marks small terms.
const BOOKKEEPING: &str = "eps";

/// cos ψ.
pub(super) fn cosine() -> Formula {
    cos(Name::new("ψ"))
}
