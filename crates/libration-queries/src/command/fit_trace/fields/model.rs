//! Damping models that were tried, and the combined result of those that are not ruled out.

use super::super::answer::FitTraceResult;
use super::super::units::in_unit;
use super::parameter::{ParameterRow, of_parameter};
use crate::output::field::{Field, Fields};
use crate::output::json::{self, Record};
use crate::output::number::with_uncertainty;
use libration_lab::fit::DampingKind;
use libration_lab::fit::trace::{Comparison, ModelAverage, ParameterKind, Standing, TraceFit};
use serde_json::Value;

/// A model of a comparison.
pub(in super::super) struct DampingModel<'a> {
    answer: &'a FitTraceResult<'a>,
    comparison: &'a Comparison,
    index: usize,
    weight: f64,
}

/// The models in the order of the comparison.
pub(in super::super) fn models<'a>(
    answer: &'a FitTraceResult<'a>,
    comparison: &'a Comparison,
) -> Vec<DampingModel<'a>> {
    let weights = comparison.weights().into_iter().enumerate();
    weights.map(|(index, weight)| DampingModel { answer, comparison, index, weight }).collect()
}

impl DampingModel<'_> {
    fn fit(&self) -> &TraceFit {
        &self.comparison.fits[self.index]
    }

    /// Akaike's criterion minus that of the best model.
    pub(in super::super) fn excess(&self) -> f64 {
        self.comparison.aicc_differences[self.index]
    }

    pub(in super::super) fn is_left(&self) -> bool {
        self.weight > 0.0
    }

    /// The standing of the model, and its negative coefficients.
    fn remark(&self) -> String {
        let standing = match self.comparison.standing(self.index) {
            Standing::Preferred => "preferred",
            Standing::Tied => "tied",
            Standing::Possible => "possible",
            Standing::Negative => "implausible",
            Standing::FeedsEnergy => "feeds energy",
            Standing::Excluded => "",
        };
        let negative = self.fit().negative_terms().into_iter().map(|term| format!("{} < 0", term.name()));
        let words = [standing.to_owned()].into_iter().filter(|word| !word.is_empty()).chain(negative);
        words.collect::<Vec<_>>().join(", ")
    }

    fn coefficient(&self, term: DampingKind) -> String {
        let parameter = self.fit().damping_coefficient(term);
        parameter.map_or("–".to_owned(), |parameter| {
            with_uncertainty(parameter.estimate.value, parameter.estimate.uncertainty, "")
        })
    }
}

const COLUMNS: [&str; 6] = ["damping", "ΔAICc", "weight", "rms residual", "T₀ / s", ""];

pub(in super::super) fn of_model<'a>() -> Fields<DampingModel<'a>> {
    type Of<'a> = Field<DampingModel<'a>>;
    Fields::from([
        Of::value("model", "", "damping of the model", |model| model.fit().damping.to_string().into())
            .words(COLUMNS[0], |model| model.fit().damping.to_string()),
        Of::value("standing", "", "preferred, tied, possible, negative, feeds_energy or excluded", |model| {
            model.comparison.standing(model.index).name().into()
        })
        .words(COLUMNS[5], DampingModel::remark),
        Of::number("rms_residual", "", "root mean square of the residuals, in rad or rad/s", |model| {
            model.fit().rms
        })
        .numeral(COLUMNS[3], |model| in_unit(model.answer, model.fit().rms, 4)),
        Of::number(
            "excess_aicc",
            "1",
            "Akaike's criterion less the least of all models",
            DampingModel::excess,
        )
        .numeral(COLUMNS[1], |model| format!("{:.1}", model.excess())),
        Of::number("weight", "1", "weight in the averages", |model| model.weight)
            .numeral(COLUMNS[2], |model| format!("{:.2}", model.weight)),
        Of::number("independent_rows", "1", "number of rows counted as independent", |model| {
            model.comparison.independent_rows
        }),
        Of::number("small_angle_period_s", "s", "period of small swings T₀ by this model", |model| {
            model.fit().small_angle_period().value
        })
        .numeral(COLUMNS[4], |model| model.fit().small_angle_period().to_string()),
        Of::number("small_angle_period_uncertainty_s", "s", "standard uncertainty of that", |model| {
            model.fit().small_angle_period().uncertainty
        }),
        Of::value(
            "dissipates",
            "",
            "true if its damping takes energy at all speeds of the data, within two standard uncertainties",
            |model| model.fit().dissipates().into(),
        ),
        Of::value("negative_terms[]", "", "damping terms with a negative coefficient", |model| {
            json::list(model.fit().negative_terms().into_iter().map(DampingKind::name))
        }),
        Of::nested("coefficients[].", &of_parameter(), |model| {
            let terms = model.fit().damping.iter().filter_map(|term| model.fit().damping_coefficient(term));
            let rows: Vec<ParameterRow<'_>> =
                terms.map(|parameter| ParameterRow { parameter, trace: None }).collect();
            of_parameter().records(&rows)
        }),
    ])
}

/// The fields of the table of models.
pub(in super::super) fn shown<'a>() -> Fields<DampingModel<'a>> {
    of_model().for_table(&COLUMNS)
}

/// The coefficients of each damping side by side.
pub(in super::super) fn coefficients<'a>() -> Fields<DampingModel<'a>> {
    type Of<'a> = Field<DampingModel<'a>>;
    let [dry, linear, quadratic] = ["dry / (rad/s²)", "linear / (1/s)", "quadratic"];
    Fields::from([
        Of::unnamed().words(COLUMNS[0], |model| model.fit().damping.to_string()),
        Of::unnamed().numeral(dry, |model| model.coefficient(DampingKind::Dry)),
        Of::unnamed().numeral(linear, |model| model.coefficient(DampingKind::Linear)),
        Of::unnamed().numeral(quadratic, |model| model.coefficient(DampingKind::Quadratic)),
    ])
}

/// The averages over the models by their weights.
pub(super) fn averaged(comparison: &Comparison) -> Value {
    let record = of_period().added_to(Record::new(), &comparison.small_angle_period());
    let shared = DampingKind::ALL.map(ParameterKind::Damping);
    let shared = [ParameterKind::NaturalFrequency].into_iter().chain(shared);
    let parameters = shared.filter_map(|kind| Some((kind.name(), comparison.parameter(kind)?)));
    parameters.fold(record, |record, (name, value)| of_average().added_for(name, record, &value)).into()
}

pub(super) fn of_averages() -> Fields<ModelAverage> {
    of_period().and(of_average())
}

fn of_period() -> Fields<ModelAverage> {
    let meaning = "T₀ over the models by their weights";
    let names = ["small_angle_period_s", "small_angle_period_uncertainty_s", "small_angle_period_spread_s"];
    of_values(names, "s", meaning)
}

fn of_average() -> Fields<ModelAverage> {
    let meaning = "parameter with this name over the models by their weights, in its unit";
    of_values(["NAME", "NAME_uncertainty", "NAME_spread"], "", meaning)
}

fn of_values(names: [&'static str; 3], unit: &'static str, meaning: &'static str) -> Fields<ModelAverage> {
    type Of = Field<ModelAverage>;
    let [value, uncertainty, spread] = names;
    Fields::from([
        Of::number(value, unit, meaning, |average| average.mean.value),
        Of::number(
            uncertainty,
            unit,
            "its standard uncertainty, the spread of the models included",
            |average| average.mean.uncertainty,
        ),
        Of::number(spread, unit, "spread of the models alone, as a standard deviation", |average| {
            average.spread
        }),
    ])
}
