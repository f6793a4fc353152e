//! The published period formulas.

use std::f64::consts::PI;
use std::sync::OnceLock;

use libration::period_formulas::{ErrorTable, PeriodFormula, catalogue};
use libration::quantity::Angle;
use pyo3::prelude::*;

use crate::errors::{FormulaError, QuantityError, UnknownKeyError, refusal};
use crate::quantity::{Given, angle};
use libration::progress::Quiet;

/// A formula with its source and properties.
#[pyclass(frozen, name = "PeriodFormula", module = "libration._native")]
pub(crate) struct NativeFormula(PeriodFormula);

#[pymethods]
impl NativeFormula {
    #[new]
    fn new(key: &str) -> PyResult<Self> {
        Ok(Self(PeriodFormula::by_key(key).map_err(refusal::<UnknownKeyError>)?))
    }

    /// Key, name, authors, year, source, LaTeX, domain, rank of the effort, and the amplitude at which the formula ends.
    fn words(&self) -> (&str, &str, &str, Option<u16>, &str, &str, &str, u32, f64) {
        let law = &self.0;
        let rank = law.complexity().rank();
        let (authors, source) = (law.authors(), law.source());
        (
            law.key(),
            law.name(),
            authors,
            law.year(),
            source,
            law.latex(),
            law.domain(),
            rank,
            law.defined_below(),
        )
    }

    fn ratio(&self, py: Python<'_>, amplitude: Given) -> PyResult<f64> {
        Ok(self.0.period_ratio(&angle(py, "amplitude", &amplitude)?))
    }

    fn error(&self, py: Python<'_>, amplitude: Given) -> PyResult<f64> {
        Ok(self.0.fractional_error(&angle(py, "amplitude", &amplitude)?))
    }

    fn ratios(&self, py: Python<'_>, amplitudes: Vec<f64>) -> Vec<f64> {
        py.detach(|| amplitudes.into_iter().map(|amplitude| self.0.period_ratio_at(amplitude)).collect())
    }

    fn errors(&self, py: Python<'_>, amplitudes: Vec<f64>) -> Vec<f64> {
        py.detach(|| amplitudes.into_iter().map(|amplitude| self.0.fractional_error_at(amplitude)).collect())
    }

    /// The largest error up to an amplitude, and the amplitude at which it occurs.
    fn worst_error(&self, py: Python<'_>, up_to: Given) -> PyResult<(f64, f64)> {
        let up_to = amplitude(py, "up_to", &up_to)?;
        let bottom = Angle::from_radians(0.0).map_err(refusal::<QuantityError>)?;
        let worst = py.detach(|| self.0.worst_error(&bottom, &up_to));
        let worst = worst.ok_or_else(|| refusal::<FormulaError>("an amplitude is below pi"))?;
        Ok((worst.error, worst.amplitude.radians()))
    }

    fn holds_to(&self, py: Python<'_>, tolerance: f64) -> f64 {
        py.detach(|| self.0.holds_to(tolerance))
    }
}

/// An amplitude up to which formulas are compared with the period, below π.
fn amplitude(py: Python<'_>, parameter: &str, given: &Given) -> PyResult<Angle> {
    let angle = angle(py, parameter, given)?;
    let radians = angle.radians();
    if radians.abs() <= PI {
        return Ok(angle);
    }
    let error = refusal::<FormulaError>(format!(
        "{parameter}: got {radians:?} rad, {}°, and swings stay below pi: give a smaller angle",
        (radians.to_degrees() * 1e6).round() / 1e6
    ));
    error.value(py).setattr("parameters", (parameter,))?;
    Err(error)
}

/// The keys of the catalogue.
#[pyfunction]
pub(crate) fn formula_keys() -> Vec<&'static str> {
    catalogue().iter().map(PeriodFormula::key).collect()
}

/// The keys of the formulas that keep the tolerance up to the amplitude, the simplest first.
#[pyfunction]
pub(crate) fn simplest_formulas(py: Python<'_>, amplitude: Given, tolerance: f64) -> PyResult<Vec<String>> {
    static TABLE: OnceLock<ErrorTable> = OnceLock::new();
    let amplitude = self::amplitude(py, "amplitude", &amplitude)?;
    Ok(py.detach(|| {
        let table = TABLE.get_or_init(|| ErrorTable::new(catalogue(), &Quiet).expect("nothing cancels it"));
        table.simplest(&amplitude, tolerance).iter().map(|formula| formula.key().to_owned()).collect()
    }))
}
