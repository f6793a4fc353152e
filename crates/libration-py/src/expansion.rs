//! Exact perturbation series, for `expansion.py`.

use libration::algebra::{LaurentPolynomial, Rational};
use libration::catalogue::is_like_a_key;
use libration::comparison::{SeriesComparison, SeriesQuantity};
use libration::expression::{Equation, Expression};
use libration::oscillator::{NamedOscillator, NumbersOrLetters, Oscillator, Remedy};
use libration::perturbation::{
    self, AmplitudeSeries, Certainty, Expansion, ExpansionError, ExpansionVariable, Gauge, PhaseOrigin,
    Precision, SymbolicExpansion, SymbolicExpansionError, expand_symbolically, expand_with_constants,
};
use libration::progress::{Progress, Quiet};
use libration_queries::hint_to;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::fmt::Display;
use std::sync::OnceLock;

use crate::asking::PythonWords;
use crate::errors::{ExpansionError as Refused, UnknownKeyError, refusal};
use crate::progress::CallProgress;

/// An expansion, together with the data for its evaluation.
#[pyclass(frozen, name = "Expansion", module = "libration._native")]
pub(crate) struct NativeExpansion(Found);

enum Found {
    Numbers {
        oscillator: Box<Oscillator>,
        expansion: Box<Expansion>,
    },
    /// Exact coefficients with names for constants; the expansion in digits is computed when it is evaluated.
    Constants {
        oscillator: Box<Oscillator>,
        expansion: Box<SymbolicExpansion>,
        digits: Box<OnceLock<Option<Expansion>>>,
    },
    Letters {
        equation: Equation,
        expansion: Box<SymbolicExpansion>,
    },
}

/// Arguments: an equation or a key, values of parameters, parameters that stay symbolic, the equilibrium.
#[derive(FromPyObject)]
pub(crate) struct ExpansionArguments(String, Vec<(String, String)>, Vec<String>, Option<String>);

/// The expansion, or its completed part and the exception that stopped it.
#[pyfunction]
pub(crate) fn expand(
    py: Python<'_>,
    question: ExpansionArguments,
    order: usize,
    gauge: &str,
    progress: Option<Py<PyAny>>,
) -> PyResult<(Option<NativeExpansion>, Option<PyErr>)> {
    let gauge: Gauge = gauge.parse().map_err(refusal::<Refused>)?;
    let oscillator = question.oscillator()?;
    let progress = CallProgress::new(progress);
    let outcome = py.detach(|| expanded(oscillator, order, &gauge, &progress))?;
    Ok((outcome.map(NativeExpansion), progress.stopped_by()))
}

impl ExpansionArguments {
    fn oscillator(&self) -> PyResult<NumbersOrLetters> {
        let equation = self.equation()?;
        let about = self.3.as_deref().map(str::parse::<Expression>).transpose();
        let about = about.map_err(refusal::<Refused>)?;
        NumbersOrLetters::new(&equation, about.as_ref()).map_err(|error| without(&error, &error.remedies()))
    }

    fn equation(&self) -> PyResult<Equation> {
        let values = self.1.iter().map(|(name, value)| {
            let value = value.parse().map_err(|error| refusal::<Refused>(format!("{name}: {error}")))?;
            Ok((name.as_str(), value))
        });
        let values = values.collect::<PyResult<Vec<(&str, Expression)>>>()?;
        let letters: Vec<&str> = self.2.iter().map(String::as_str).collect();
        if is_like_a_key(&self.0) {
            let named = NamedOscillator::by_key(self.0.trim()).map_err(refusal::<UnknownKeyError>)?;
            return named.equation_with_letters(&values, &letters).map_err(refusal::<Refused>);
        }
        let equation: Equation = self.0.parse().map_err(refusal::<Refused>)?;
        let equation = equation.with(&values).map_err(refusal::<Refused>)?;
        equation.parameters_called(&letters).map_err(refusal::<Refused>)?;
        Ok(equation)
    }
}

/// The absence of an expansion, with a hint to what has a result.
fn without(error: &impl Display, remedies: &[Remedy]) -> PyErr {
    let hint = hint_to(remedies, &PythonWords);
    let exception = refusal::<Refused>(match &hint {
        Some(hint) => format!("{error}\nhint: {hint}"),
        None => error.to_string(),
    });
    Python::attach(|py| exception.value(py).setattr("hint", hint)).err().unwrap_or(exception)
}

/// Computes the expansion; `None` if it was stopped before any order was certain.
fn expanded(
    oscillator: NumbersOrLetters,
    order: usize,
    gauge: &Gauge,
    progress: &dyn Progress,
) -> PyResult<Option<Found>> {
    match oscillator {
        NumbersOrLetters::Numbers(oscillator) => {
            if let Some(expansion) = with_constants(&oscillator, order, gauge, progress)? {
                let (oscillator, expansion) = (Box::new(oscillator), Box::new(expansion));
                return Ok(Some(Found::Constants { oscillator, expansion, digits: Box::default() }));
            }
            let expansion = match perturbation::expand(&oscillator, order, gauge, progress) {
                Ok(expansion) => Some(Box::new(expansion)),
                Err(ExpansionError::Interrupted { known: partial }) => partial,
                Err(error) => return Err(without(&error, &error.remedies())),
            };
            let oscillator = Box::new(oscillator);
            Ok(expansion.map(|expansion| Found::Numbers { oscillator, expansion }))
        }
        NumbersOrLetters::Letters(oscillator) => {
            let expansion = match expand_symbolically(&oscillator, order, gauge, progress) {
                Ok(expansion) => Some(Box::new(expansion)),
                Err(SymbolicExpansionError::Interrupted { known: partial }) => partial,
                Err(error) => return Err(refusal::<Refused>(error)),
            };
            let equation = oscillator.equation().clone();
            Ok(expansion.map(|expansion| Found::Letters { equation, expansion }))
        }
    }
}

/// The expansion with names for constants; `None` where there are no such constants, and after a cancellation.
fn with_constants(
    oscillator: &Oscillator,
    order: usize,
    gauge: &Gauge,
    progress: &dyn Progress,
) -> PyResult<Option<SymbolicExpansion>> {
    match expand_with_constants(oscillator, order, gauge, progress) {
        Err(SymbolicExpansionError::Interrupted { .. }) => Ok(None),
        outcome => outcome.map_err(refusal::<Refused>),
    }
}

/// Value, remainder, and whether the remainder is proven; powers, terms and sums.
type Evaluation = (f64, f64, bool, Vec<(usize, f64, f64)>);

/// A coefficient for Python: terms, each a fraction as text and powers of symbols.
trait Coefficient {
    fn terms(&self) -> Terms;
}

type Terms = Vec<(String, Vec<(String, String)>)>;

impl Coefficient for Rational {
    fn terms(&self) -> Terms {
        vec![(self.to_string(), vec![])]
    }
}

impl Coefficient for LaurentPolynomial {
    fn terms(&self) -> Terms {
        let power = |power: libration::algebra::LetterPower<'_>| {
            (power.letter.to_owned(), power.exponent.to_string())
        };
        self.terms()
            .map(|(factor, powers)| (factor.to_string(), powers.into_iter().map(power).collect()))
            .collect()
    }
}

fn terms<C: Coefficient>(series: &[C]) -> Vec<Terms> {
    series.iter().map(Coefficient::terms).collect()
}

#[pymethods]
impl NativeExpansion {
    /// All results under the names of `Expansion` in Python; series are lists of coefficients.
    fn fields<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let fields = PyDict::new(py);
        match &self.0 {
            Found::Numbers { oscillator, expansion } => {
                of_equation(&fields, oscillator.equation())?;
                of_expansion(&fields, expansion)?;
                let exact = [oscillator.equilibrium(), oscillator.omega0_squared()];
                fields.set_item("are_exact", exact.map(|exact| exact.exact().is_some()))?;
            }
            Found::Constants { oscillator, expansion, .. } => {
                of_equation(&fields, oscillator.equation())?;
                of_symbolic(&fields, expansion)?;
            }
            Found::Letters { equation, expansion } => {
                of_equation(&fields, equation)?;
                of_symbolic(&fields, expansion)?;
            }
        }
        Ok(fields)
    }

    /// The evaluation at an amplitude or a strength: value, remainder and whether it is proven, powers, terms, sums.
    fn evaluate(&self, at: f64, quantity: &str) -> PyResult<Evaluation> {
        let (oscillator, expansion) = self.0.in_numbers().ok_or_else(|| {
            refusal::<Refused>("the coefficients contain symbols: give them values with set")
        })?;
        let quantity: SeriesQuantity = quantity.parse().map_err(refusal::<Refused>)?;
        let relation = SeriesComparison::new(oscillator, expansion, quantity);
        let evaluation = relation.evaluation_at(at);
        let rest = evaluation.steps().last().map(|step| step.remainder);
        let (size, certainty) =
            rest.map_or((f64::NAN, Certainty::Estimated), |rest| (rest.size, rest.certainty));
        let steps = evaluation.steps().iter().map(|step| (step.power, step.term, step.sum)).collect();
        Ok((evaluation.value(), size, certainty == Certainty::Proven, steps))
    }
}

impl Found {
    /// The expansion with fractions or digits; `None` with symbols.
    fn in_numbers(&self) -> Option<(&Oscillator, &Expansion)> {
        match self {
            Self::Numbers { oscillator, expansion } => Some((oscillator, expansion)),
            Self::Constants { oscillator, expansion, digits } => {
                let ExpansionVariable::Epsilon(gauge) = &expansion.series.variable else { return None };
                let order = expansion.series.order;
                let digits =
                    digits.get_or_init(|| perturbation::expand(oscillator, order, gauge, &Quiet).ok());
                Some((oscillator, digits.as_ref()?))
            }
            Self::Letters { .. } => None,
        }
    }
}

fn of_symbolic(fields: &Bound<'_, PyDict>, expansion: &SymbolicExpansion) -> PyResult<()> {
    of_expansion(fields, &expansion.series)?;
    let value = |expression: &Expression| expression.to_f64().unwrap_or(f64::NAN);
    let constants =
        expansion.constants.iter().map(|(name, constant)| (name, constant.to_string(), value(constant)));
    fields.set_item("constants", constants.collect::<Vec<_>>())
}

fn of_equation(fields: &Bound<'_, PyDict>, equation: &Equation) -> PyResult<()> {
    fields.set_item("equation", equation.to_string())?;
    fields.set_item("displacement", equation.variables().first())
}

fn of_expansion<C: Coefficient>(fields: &Bound<'_, PyDict>, expansion: &Expansion<C>) -> PyResult<()> {
    fields.set_item("order", expansion.order)?;
    fields.set_item("variable", expansion.variable.name())?;
    let gauge = match &expansion.variable {
        ExpansionVariable::Epsilon(gauge) => Some(gauge.to_string()),
        ExpansionVariable::Parameter(_) => None,
    };
    fields.set_item("gauge", gauge)?;
    fields.set_item("phase_origin", origin(expansion.phase_origin))?;
    let digits = match expansion.precision {
        Precision::Exact => None,
        Precision::Digits(digits) => Some(digits),
    };
    fields.set_item("digits", digits)?;
    fields.set_item("is_proven", expansion.certificate.is_proof())?;
    for (name, number) in [
        ("equilibrium", &expansion.equilibrium),
        ("omega0_squared", &expansion.omega0_squared),
        ("unit_squared", &expansion.unit_squared),
    ] {
        fields.set_item(name, number.terms())?;
    }
    for (name, series) in [
        ("frequency_ratio", &expansion.frequency_ratio),
        ("x_max", &expansion.x_max),
        ("x_min", &expansion.x_min),
    ] {
        fields.set_item(name, terms(series))?;
    }
    let harmonics =
        expansion.harmonics.iter().map(|harmonic| (harmonic.k, (terms(&harmonic.cos), terms(&harmonic.sin))));
    fields.set_item("harmonics", harmonics.collect::<Vec<_>>())?;
    fields.set_item("of_amplitude", expansion.of_amplitude.as_ref().map(of_amplitude))?;
    fields.set_item("of_half_swing", expansion.of_half_swing.as_ref().map(of_amplitude))
}

/// Frequency, period, ε and harmonics.
type OfAmplitude = (Vec<Terms>, Vec<Terms>, Vec<Terms>, Vec<(usize, Vec<Terms>)>);

fn of_amplitude<C: Coefficient>(of: &AmplitudeSeries<C>) -> OfAmplitude {
    let harmonics = of.harmonics.iter().map(|(k, series)| (*k, terms(series)));
    (terms(&of.frequency_ratio), terms(&of.period_ratio), terms(&of.epsilon), harmonics.collect())
}

fn origin(origin: PhaseOrigin) -> &'static str {
    match origin {
        PhaseOrigin::TurningPoint => "turning_point",
        PhaseOrigin::Passage => "passage",
        PhaseOrigin::FirstHarmonic => "first_harmonic",
    }
}

/// A formula in LaTeX.
#[pyfunction]
pub(crate) fn latex(formula: &str) -> PyResult<String> {
    Ok(formula.parse::<Expression>().map_err(refusal::<Refused>)?.to_latex())
}
