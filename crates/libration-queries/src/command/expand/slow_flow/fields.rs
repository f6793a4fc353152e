//! Fields of a slow flow: its polynomials as lists of lists of coefficients, each a text.

use super::super::subject::of_subject;
use super::{SlowFlowResult, leading_cycles};
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use libration::perturbation::{PhaseTerm, SlowLimitCycle, SlowSeries};
use serde_json::Value;

/// One coefficient of a polynomial.
pub(super) struct PolynomialCoefficient {
    quantity: String,
    powers: [usize; 2],
    text: String,
    value: f64,
}

pub(super) fn of_flow() -> Fields<SlowFlowResult> {
    type Of = Field<SlowFlowResult>;
    of_subject().and([
        Of::value("order", "1", "highest power of the amplitude A", |result| result.flow.order.into()),
        Of::value("damping_order", "1", "highest power of the small parameter", |result| {
            result.flow.parameter_order.into()
        }),
        Of::value("small_parameter", "", "name of the small parameter, which stays symbolic", |result| {
            result.flow.parameter.as_str().into()
        }),
        Of::value(
            "gauge",
            "",
            "meaning of A: `x_max`, the displacement where the motion turns at ψ = 0, or `fundamental`, the coefficient of cos ψ",
            |result| result.flow.gauge.to_string().into(),
        ),
        Of::value("equilibrium", "", "equilibrium x₀ without the small terms", |result| {
            result.flow.equilibrium.to_string().into()
        }),
        Of::value("omega0_squared", "", "square of the angular frequency ω0 of small oscillations", |result| {
            result.flow.omega0_squared.to_string().into()
        }),
        Of::value("letters.NAME", "", "symbol in the formulas that has this meaning: amplitude, phase", |result| {
            json::object(["amplitude", "phase"].map(str::to_owned).into_iter().zip(result.letters()))
        }),
        Of::nested("slow_flow.", &of_rates(), |result| of_rates().record(result).into()),
        Of::value(
            "displacement",
            "",
            "formula of the displacement from the equilibrium; with half_swing for phases from 0 to pi, and the opposite at pi more",
            |result| result.displacement().into(),
        ),
        Of::value(
            "amplitude_rate[][]",
            "",
            "coefficients of A′, by powers of the small parameter, and for each by powers of A",
            |result| texts(&result.flow.amplitude_rate),
        ),
        Of::value("phase_rate[][]", "", "coefficients of ψ′, likewise", |result| texts(&result.flow.phase_rate)),
        Of::value(
            "half_swing",
            "",
            "true if the motion is given for 0 ≤ ψ ≤ π, and is the opposite at ψ + π",
            |result| result.flow.half_swing.into(),
        ),
        Of::nested("motion[].", &of_term(), |result| of_term().records(&result.flow.motion)),
        Of::nested("limit_cycles[].", &of_cycle(), |result| of_cycle().records(&result.flow.limit_cycles())),
    ])
    .and(leading_cycles::of_answer())
}

fn of_rates() -> Fields<SlowFlowResult> {
    type Of = Field<SlowFlowResult>;
    Fields::from([
        Of::value("amplitude", "", "formula of the rate of the amplitude", |result| {
            result.rates()[0].as_str().into()
        }),
        Of::value("phase", "", "formula of the rate of the phase", |result| {
            result.rates()[1].as_str().into()
        }),
    ])
}

fn of_cycle() -> Fields<SlowLimitCycle> {
    type Of = Field<SlowLimitCycle>;
    Fields::from([
        Of::value("amplitude[]", "", "A of a limit cycle, by powers of the small parameter", |cycle| {
            numbers(&cycle.amplitude)
        }),
        Of::value(
            "angular_frequency_rad_per_s[]",
            "rad/s",
            "its angular frequency, by powers of the small parameter",
            |cycle| numbers(&cycle.frequency),
        ),
        Of::value(
            "exponent_per_s[]",
            "1/s",
            "rate at which distances from it grow, by powers of the small parameter",
            |cycle| numbers(&cycle.exponent),
        ),
    ])
}

fn numbers(list: &[f64]) -> Value {
    json::list(list.iter().copied().map(json::number))
}

fn of_term() -> Fields<PhaseTerm> {
    type Of = Field<PhaseTerm>;
    Fields::from([
        Of::value("phase_power", "1", "power of ψ before a harmonic of the displacement", |term| {
            term.power.into()
        }),
        Of::value("k", "1", "number of the harmonic", |term| term.k.into()),
        Of::value(
            "cos[][]",
            "",
            "coefficients of cos kψ, by powers of the small parameter, and for each by powers of A",
            |term| texts(&term.cos),
        ),
        Of::value("sin[][]", "", "those of sin kψ", |term| texts(&term.sin)),
    ])
}

pub(super) fn of_coefficient() -> Fields<PolynomialCoefficient> {
    type Of = Field<PolynomialCoefficient>;
    Fields::from([
        Of::value(
            "quantity",
            "",
            "quantity that is expanded: A′, ψ′, or ψᵖ·cos kψ as cos_k_p",
            |coefficient| coefficient.quantity.as_str().into(),
        ),
        Of::value("parameter_power", "1", "power of the small parameter", |coefficient| {
            coefficient.powers[0].into()
        }),
        Of::value("amplitude_power", "1", "power of A", |coefficient| coefficient.powers[1].into()),
        Of::value("coefficient", "", "their coefficient, exactly", |coefficient| {
            coefficient.text.as_str().into()
        }),
        Of::number("value", "", "the same in digits", |coefficient| coefficient.value),
    ])
}

pub(super) fn answers() -> Answers {
    let (json, csv) = (of_flow().described(""), of_coefficient().described_in_csv());
    Answers { command: "expand", option: "--damping-order", json, csv }
}

/// The coefficients that are not zero.
pub(super) fn coefficients(answer: &SlowFlowResult) -> Vec<PolynomialCoefficient> {
    let mut all = vec![];
    let mut add = |quantity: String, series: &SlowSeries| {
        for (j, list) in series.iter().enumerate() {
            for (n, value) in list.iter().enumerate().filter(|(_, value)| !value.is_zero()) {
                let (quantity, text) = (quantity.clone(), value.to_string());
                all.push(PolynomialCoefficient { quantity, powers: [j, n], text, value: value.to_f64() });
            }
        }
    };
    add("amplitude_rate".to_owned(), &answer.flow.amplitude_rate);
    add("phase_rate".to_owned(), &answer.flow.phase_rate);
    for PhaseTerm { power, k, cos, sin } in &answer.flow.motion {
        add(format!("cos_{k}_{power}"), cos);
        add(format!("sin_{k}_{power}"), sin);
    }
    all
}

fn texts(series: &SlowSeries) -> Value {
    json::list(series.iter().map(|list| json::list(list.iter().map(ToString::to_string))))
}
