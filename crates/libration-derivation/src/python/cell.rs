//! The check of a formula as lines of Python, which repeat the check on the reader's computer.

use super::super::check::{
    AveragedClaim, Check, CheckedEquation, ComparedAt, CycleClaim, CycleQuantity, FlowTerms, ForceTerm,
    Letters, OpenCondition, QuarterClaim, QuarterFormula, TruncatedClaim, TruncatedFormula,
};
use super::super::evaluate::TIME;
use super::super::formula::{DecimalUnit, Formula, Name, Relation, Statement};
use super::{expression, identifier};
use libration::algebra::Rational;
use libration::perturbation::RestoringTerm;

/// The lines that repeat the check; `None` if there is nothing to check, or the check cannot be written in Python.
pub(crate) fn check(equation: &CheckedEquation) -> Option<String> {
    let (statement, letters) = (equation.statement(), equation.letters());
    match equation.check() {
        Check::Series { variable, coefficients } => {
            // Quotients of series without constant term lose coefficients.
            let lines = [format!("{} = variable({})", identifier(variable)?, coefficients + 6)];
            let sides = sides(statement)?.join(", ");
            let lines = lines.into_iter().chain(given(letters)?);
            Some(block(lines.chain([format!("same_series({coefficients}, {sides})")])))
        }
        Check::Choices { variable, coefficients, .. } => {
            let lines = [format!("{} = variable({})", identifier(variable)?, coefficients + 6)];
            let sides = sides(statement)?.join(", ");
            let lines = lines.into_iter().chain(given(letters)?);
            Some(block(lines.chain([format!("nearly_same_series({coefficients}, {sides})")])))
        }
        Check::Phases { variable, order, phases } => {
            let (variable, terms) = (identifier(variable)?, order + 1);
            let head = [format!("for n in range({phases}):")];
            let has_sines = letters.values.iter().any(|(name, _)| name.primes == 1);
            let angle = if has_sines { "by_tangent_of_half" } else { "Angle" };
            let set = [format!("{variable}, τ = variable({terms}), {angle}(Q(n, {phases}))")];
            let left = format!("same_series({terms}, {}, 0)", expression(&statement.first)?);
            let lines = set.into_iter().chain(given(letters)?).chain([left]);
            Some(block(head.into_iter().chain(lines.map(indented))))
        }
        Check::Rationals { index, first, last } => {
            let head = format!("for {} in map(Q, range({first}, {})):", identifier(index)?, last + 1);
            let body = format!("same_fraction({})", sides(statement)?.join(", "));
            Some(block(given(letters)?.into_iter().chain([head, indented(body)])))
        }
        Check::Fraction => Some(format!("same_fraction({})", sides(statement)?.join(", "))),
        Check::Digits { compared_at: ComparedAt::Cases { index, first, last }, .. } => {
            let head = format!("for {} in map(Q, range({first}, {})):", identifier(index)?, last + 1);
            let lines = compared(statement)?.into_iter().map(indented);
            Some(block(given(letters)?.into_iter().chain([head]).chain(lines)))
        }
        Check::Digits { .. } => {
            let lines = compared(statement)?.into_iter().map(|line| at_known_rates(line, letters));
            Some(block(given(letters)?.into_iter().chain(lines)))
        }
        Check::RoundedDigits => Some(block(given(letters)?.into_iter().chain([rounded(statement)?]))),
        Check::Substituted { condition: Some(condition), .. } => substituted(statement, condition),
        Check::Catalogued { leading_error, .. } => catalogued(statement, leading_error.as_ref()),
        Check::Truncated(formula) => truncated(statement, &formula.claim, &formula.harmonics),
        Check::Quarter(formula) => quarter(statement, formula.power, &formula.claim),
        Check::Cycle(formula) => cycle(statement, formula.order, &formula.claim),
        Check::Averaged(formula) => averaged(statement, &formula.claim),
        _ => None,
    }
}

/// The ansatz of a condition, with its symbols.
pub(crate) fn ansatz(condition: &OpenCondition) -> Option<String> {
    let OpenCondition { force, symbols, harmonics, frequency, .. } = condition;
    let term = |term: &RestoringTerm| {
        Some(format!("({}, {}): {}", term.position, term.velocity, expression(&(&term.factor).into())?))
    };
    let force: Vec<String> = force.iter().map(term).collect::<Option<_>>()?;
    let names = harmonics.iter().map(|(_, _, name)| name).chain(frequency.iter().map(|(_, name)| name));
    let names: Vec<String> = names.chain(symbols).map(identifier).collect::<Option<_>>()?;
    let harmonics: Vec<String> = harmonics
        .iter()
        .map(|(n, k, name)| Some(format!("({n}, {k}): \"{}\"", identifier(name)?)))
        .collect::<Option<_>>()?;
    let frequency: Vec<String> = frequency
        .iter()
        .map(|(n, name)| Some(format!("{n}: \"{}\"", identifier(name)?)))
        .collect::<Option<_>>()?;
    Some(block([
        "# The terms of the force by the powers of displacement and velocity, the coefficients by the power of ε and the harmonic, and those of the frequency by the power".to_owned(),
        format!("[{}] = letters(\"{}\")", names.join(", "), names.join(" ")),
        format!("ansatz = Ansatz({{{}}},", force.join(", ")),
        format!("                {{{}}},", harmonics.join(", ")),
        format!("                {{{}}})", frequency.join(", ")),
    ]))
}

/// The equation of a slow flow, as long as the displacement falls.
pub(crate) fn slow_flow(flow: &FlowTerms) -> Option<String> {
    let number = |fraction: &Rational| expression(&Formula::Number(fraction.clone()));
    let term = |term: &ForceTerm| {
        Some(format!("({}, {}, {}, {})", number(&term.factor)?, term.position, term.velocity, term.parameter))
    };
    let terms: Option<Vec<String>> = flow.terms.iter().map(term).collect();
    Some(block([
        "# The frequency of small swings; factor, power of the displacement, of the velocity and of the small parameter".to_owned(),
        "# of each further term; whether only a half swing is known; whether the parameter is counted as a power of A.".to_owned(),
        format!("flow = SlowFlow({}, [{}],", number(&flow.omega0)?, terms?.join(", ")),
        format!("                {}, {})", if flow.kinked { "True" } else { "False" }, flow.lift),
    ]))
}

/// The first term of the error of a formula for the period.
fn catalogued(statement: &Statement, leading_error: Option<&(Rational, u32)>) -> Option<String> {
    let (_, ratio) = statement.rest.first()?;
    let ratio = expression(ratio)?;
    Some(match leading_error {
        Some((coefficient, power)) => {
            let coefficient = expression(&Formula::Number(coefficient.clone()))?;
            format!("error_begins(lambda θ_0: {ratio}, {power}, {coefficient})")
        }
        None => format!("error_vanishes_at_the_top(lambda θ_0: {ratio})"),
    })
}

/// The code of a cell with the force and the harmonics that are kept.
pub(crate) fn few_harmonics(formula: &TruncatedFormula) -> Option<String> {
    let force = formula.force.iter().map(|coefficient| expression(&Formula::Number(coefficient.clone())));
    let harmonics: Vec<String> = formula.harmonics.iter().map(ToString::to_string).collect();
    Some(block([
        "# The force to its last power, and the harmonics that are kept.".to_owned(),
        format!(
            "few = FewHarmonics([{}], [{}])",
            force.collect::<Option<Vec<String>>>()?.join(", "),
            harmonics.join(", ")
        ),
    ]))
}

fn truncated(statement: &Statement, claim: &TruncatedClaim, harmonics: &[usize]) -> Option<String> {
    let names: Vec<String> = harmonics.iter().map(|k| format!("a_{k}")).collect();
    let letters = format!("{}, Δ", names.join(", "));
    let (left, right) = (expression(&statement.first)?, expression(&statement.rest.last()?.1)?);
    Some(match claim {
        TruncatedClaim::Condition { harmonic, over_first } => {
            let first = if *over_first { format!("{}*({left})", names.first()?) } else { left };
            format!("few.asks({harmonic}, lambda {letters}: {first})")
        }
        TruncatedClaim::SquaredRatio => format!("few.has_ratio(lambda {letters}: {right})"),
        TruncatedClaim::Eliminated => format!("few.leaves(lambda {letters}: {left})"),
        TruncatedClaim::AtZero => format!("few.is_at_zero(lambda {letters}: {left})"),
        TruncatedClaim::Series { amplitude, harmonic } => {
            format!("few.begins({harmonic}, lambda {}: {right})", identifier(amplitude)?)
        }
    })
}

/// The code of a cell with the equation of a limit cycle.
pub(crate) fn limit_cycle(flow: &FlowTerms) -> Option<String> {
    slow_flow(flow).map(|code| format!("{code}\ncycle = LimitCycle(flow)"))
}

fn cycle(statement: &Statement, n: usize, claim: &CycleClaim) -> Option<String> {
    let right = || statement.rest.last().and_then(|(_, side)| expression(side));
    match claim {
        CycleClaim::Forcing { open, value: forcing } => {
            Some(format!("cycle.forces({n}, lambda τ, {}: {})", identifier(open)?, expression(forcing)?))
        }
        CycleClaim::Sine { open } => {
            Some(format!("cycle.asks({n}, lambda {}: {})", identifier(open)?, expression(&statement.first)?))
        }
        CycleClaim::Amplitude => Some(format!("cycle.is_as_large({n}, {})", right()?)),
        CycleClaim::Frequency => Some(format!("cycle.is_as_fast({n}, {})", right()?)),
        CycleClaim::Motion { open } => {
            Some(format!("cycle.moves({n}, lambda τ, {}: {})", identifier(open)?, right()?))
        }
        CycleClaim::AmplitudeSeries { parameter } => {
            Some(format!("cycle.amplitude(lambda {}: {})", identifier(parameter)?, right()?))
        }
        CycleClaim::FrequencySeries { parameter } => {
            Some(format!("cycle.frequency(lambda {}: {})", identifier(parameter)?, right()?))
        }
    }
}

fn averaged(statement: &Statement, claim: &AveragedClaim) -> Option<String> {
    let right = || statement.rest.last().and_then(|(_, side)| expression(side));
    let at = |power: &usize, parameter: &usize| format!("{power}, {parameter}");
    let of_phase = |method: &str, powers: String, side: String| {
        Some(format!("flow.{method}({powers}, lambda pi, ψ: {side})"))
    };
    match claim {
        AveragedClaim::ChainRule => None,
        AveragedClaim::Forcing { power, parameter, value: forcing } => {
            of_phase("forces", at(power, parameter), expression(forcing)?)
        }
        AveragedClaim::Growth { power, parameter } => of_phase("grows", at(power, parameter), right()?),
        AveragedClaim::Frequency { power, parameter } => of_phase("turns", at(power, parameter), right()?),
        AveragedClaim::Motion { power, parameter } => of_phase("moves", at(power, parameter), right()?),
        AveragedClaim::Velocity { power, parameter } => {
            of_phase("is_as_fast", at(power, parameter), right()?)
        }
        AveragedClaim::AmplitudeLaw { parameter } => {
            Some(format!("flow.amplitude_law(lambda pi, A, {}: {})", identifier(parameter)?, right()?))
        }
        AveragedClaim::PhaseLaw { parameter } => {
            Some(format!("flow.phase_law(lambda pi, A, {}: {})", identifier(parameter)?, right()?))
        }
        AveragedClaim::Loss { highest } => Some(format!("flow.loss({highest}, lambda pi, A: {})", right()?)),
        AveragedClaim::FirstLaw => Some(format!("flow.first_law(lambda pi, A: {})", right()?)),
        AveragedClaim::Cycle { parameter, quantity } => {
            let method = match quantity {
                CycleQuantity::SquaredAmplitude => "cycle_square",
                CycleQuantity::Frequency => "cycle_frequency",
                CycleQuantity::Exponent => "cycle_exponent",
            };
            Some(format!("flow.{method}(lambda {}: {})", identifier(parameter)?, right()?))
        }
    }
}

/// The code of a cell with the force of a quarter swing.
pub(crate) fn quarter_swing(formula: &QuarterFormula) -> Option<String> {
    let force = formula.force.iter().map(|coefficient| expression(&Formula::Number(coefficient.clone())));
    Some(block([
        "# The factors of the second and higher powers in the force.".to_owned(),
        format!("quarter = Quarter([{}])", force.collect::<Option<Vec<String>>>()?.join(", ")),
    ]))
}

fn quarter(statement: &Statement, n: usize, claim: &QuarterClaim) -> Option<String> {
    let right = expression(&statement.rest.last()?.1)?;
    Some(match claim {
        QuarterClaim::Forcing { value: forcing } => {
            format!("quarter.forces({n}, lambda pi, τ: {})", expression(forcing)?)
        }
        QuarterClaim::Begun => format!("quarter.begins({n}, lambda pi, τ: {right})"),
        QuarterClaim::Correction => format!("quarter.corrects({n}, lambda pi: {right})"),
        QuarterClaim::Motion => format!("quarter.moves({n}, lambda pi, τ: {right})"),
        QuarterClaim::Harmonic { amplitude, harmonic } => {
            format!("quarter.harmonic({harmonic}, lambda pi, {}: {right})", identifier(amplitude)?)
        }
    })
}

/// A coefficient determined at lower orders.
pub(crate) fn coefficient(name: &Name, value: &Formula) -> Option<String> {
    Some(format!("ansatz.known[\"{}\"] = polynomial({})", identifier(name)?, expression(value)?))
}

fn substituted(statement: &Statement, condition: &OpenCondition) -> Option<String> {
    let indices = format!("{}, {}", condition.order, condition.harmonic);
    let (_, right) = statement.rest.last()?;
    match &statement.first {
        Formula::Name(name) => {
            Some(format!("ansatz.fixes({indices}, \"{}\", {})", identifier(name)?, expression(right)?))
        }
        left => {
            let new = condition
                .fixes
                .as_ref()
                .map_or(Some("None".to_owned()), |name| Some(format!("\"{}\"", identifier(name)?)))?;
            Some(format!("ansatz.gives({indices}, {}, {new})", expression(left)?))
        }
    }
}

/// The values of names, in an order in which each needs only earlier ones.
/// A line in which names without a rate stay as they are in derivatives with respect to the time, which itself grows at the rate 1.
fn at_known_rates(line: String, letters: &Letters) -> String {
    let is_constant =
        |name: &&Name| !letters.values.iter().any(|(other, _)| *other == (*name).clone().prime());
    let names = letters.values.iter().map(|(name, _)| name).filter(is_constant).filter_map(identifier);
    names.fold(line, |line, name| {
        let moved = if name == TIME { format!("{name} + s") } else { name.clone() };
        line.replace(&format!("{name} + s*{name}_p"), &moved)
    })
}

fn given(letters: &Letters) -> Option<Vec<String>> {
    let functions = letters.functions.iter().map(|(name, parameters, body)| {
        let parameters: Option<Vec<String>> = parameters.iter().map(identifier).collect();
        Some(format!("{} = lambda {}: {}", identifier(name)?, parameters?.join(", "), expression(body)?))
    });
    let value =
        |(name, formula): &(Name, Formula)| Some(format!("{} = {}", identifier(name)?, expression(formula)?));
    functions.chain(letters.values.iter().map(value)).collect()
}

fn sides(statement: &Statement) -> Option<Vec<String>> {
    [&statement.first]
        .into_iter()
        .chain(statement.rest.iter().map(|(_, side)| side))
        .map(expression)
        .collect()
}

/// Comparisons of neighbours in the chain.
fn compared(statement: &Statement) -> Option<Vec<String>> {
    if let (Formula::Sum(terms), [(Relation::Equal, zero)]) = (&statement.first, statement.rest.as_slice())
        && *zero == Formula::from(0)
    {
        let terms: Vec<String> = terms.iter().map(expression).collect::<Option<_>>()?;
        return Some(vec![format!("vanishes({})", terms.join(", "))]);
    }
    let sides = sides(statement)?;
    let pairs = sides.windows(2).zip(&statement.rest);
    // Singular ends of integrals cost half of the digits of a float, finite differences in place of derivatives a third.
    let whole = sides.concat();
    let digits = if whole.contains("integral(") || whole.contains("slope(") { ", digits=7" } else { "" };
    let line = |(pair, (relation, _)): (&[String], &(Relation, Formula))| match relation {
        Relation::Less => format!("below({}, {})", pair[0], pair[1]),
        Relation::Equal | Relation::Defined | Relation::Rounded => {
            format!("agree({}, {}{digits})", pair[0], pair[1])
        }
    };
    Some(pairs.map(line).collect())
}

fn rounded(statement: &Statement) -> Option<String> {
    let Some((_, Formula::Decimal(decimal))) = statement.rest.last() else { return None };
    let (printed, last_digit) = (decimal.value()?.to_f64(), decimal.last_place()?.to_f64());
    let unit = if decimal.unit == DecimalUnit::Degree { "*180/pi" } else { "" };
    Some(format!("rounds_to(({}){unit}, {printed:?}, {last_digit:?})", expression(&statement.first)?))
}

fn block(lines: impl IntoIterator<Item = String>) -> String {
    lines.into_iter().collect::<Vec<_>>().join("\n")
}

fn indented(line: String) -> String {
    format!("    {line}")
}
