//! Fields of a slow flow with symbolic parameters.

use super::super::subject::of_subject;
use super::{FlowValues, SymbolicFlowResult, why_left_out};
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::formulas::{self, NamedFormula};
use crate::output::json;
use libration::perturbation::{JudgedState, LeftOutReason, StateLeftOut, SteadyState};

type Of<A> = Field<A>;

pub(super) fn of_flow() -> Fields<SymbolicFlowResult> {
    of_subject().and(of_setting()).and(of_formulas())
}

fn of_setting() -> Fields<SymbolicFlowResult> {
    Fields::from([
        Of::<SymbolicFlowResult>::value("order", "1", "highest order in the small parameters", |answer| {
            answer.flow.order.into()
        }),
        Of::value(
            "order_note",
            "",
            "terms of the equation that are of higher order; null where there are none",
            |answer| answer.flow.order_note.clone().into(),
        ),
        Of::value("small_orders.NAME", "1", "order of the small parameter with this name", |answer| {
            json::object(answer.small.iter().cloned())
        }),
        Of::value(
            "resonance",
            "1",
            "p/q of W = (p/q)·ω0 + eps·sigma, drive over natural frequency; null without drive",
            |answer| answer.flow.resonance.map(|(p, q)| format!("{p}/{q}")).into(),
        ),
        Of::value("equilibrium", "", "formula of the equilibrium, from which A is counted", |answer| {
            answer.flow.equilibrium.as_str().into()
        }),
        Of::value("natural_frequency", "", "formula of ω0, symbols being positive", |answer| {
            answer.flow.natural_frequency.as_str().into()
        }),
        Of::value("drive_frequency", "", "formula of the drive frequency W; null without drive", |answer| {
            answer.flow.drive_frequency.clone().into()
        }),
        Of::value(
            "letters.NAME",
            "",
            "symbol in the formulas that has this meaning: amplitude, phase, detuning, drive_frequency, natural_frequency",
            |answer| {
                json::object(
                    answer.flow.letters.iter().map(|(name, letter)| ((*name).to_owned(), letter.clone())),
                )
            },
        ),
    ])
}

fn of_formulas() -> Fields<SymbolicFlowResult> {
    Fields::from([
        Of::<SymbolicFlowResult>::nested("slow_flow.", &of_rates(), |answer| {
            of_rates().record(answer).into()
        }),
        Of::value(
            "displacement",
            "",
            "formula of the displacement: A·cos((q/p)·W·t + phi) and terms of other frequencies",
            |answer| answer.flow.displacement.as_str().into(),
        ),
        Of::value(
            "displacement_note",
            "",
            "harmonics that the displacement leaves out; null where there are none",
            |answer| answer.flow.displacement_note.into(),
        ),
        Of::nested("steady_state.", &of_steady(), |answer| {
            of_steady().record(&answer.flow.steady_state).into()
        }),
        Of::present_nested("values.", &of_values(), |answer| {
            Some(of_values().record(answer.values.as_ref()?).into())
        }),
    ])
}

fn of_rates() -> Fields<SymbolicFlowResult> {
    Fields::from([
        Of::<SymbolicFlowResult>::value("amplitude", "", "formula of dA/dt", |answer| {
            answer.flow.amplitude_rate.as_str().into()
        }),
        Of::value("phase", "", "formula of dphi/dt", |answer| answer.flow.phase_rate.as_str().into()),
    ])
}

fn of_steady() -> Fields<SteadyState> {
    Fields::from([
        Of::<SteadyState>::value(
            "equations[]",
            "",
            "dA/dt and A·dphi/dt, zero at steady states; dA/dt only without drive",
            |state| json::list(state.equations.iter().map(String::as_str)),
        ),
        Of::value(
            "relation",
            "",
            "formula in A and sigma that is zero on the response curve, or for the amplitude of limit cycles; null with a note \
             where there is none",
            |state| state.relation.clone().into(),
        ),
        Of::value(
            "phase_harmonic",
            "1",
            "m of cos(m·phi) and sin(m·phi); null where they are not known",
            |state| state.phase.as_ref().map(|(m, _)| *m).into(),
        ),
        Of::value("phase[]", "", "formulas of cos(m·phi) and sin(m·phi) at steady states", |state| {
            json::list(state.phase.iter().flat_map(|(_, parts)| parts.iter().map(String::as_str)))
        }),
        Of::value("backbone", "", "formula of the sigma of the largest amplitude by A", |state| {
            state.backbone.clone().into()
        }),
        Of::value("peak_amplitude", "", "formula of the largest amplitude of the response curve", |state| {
            state.peak_amplitude.clone().into()
        }),
        Of::value("peak_detuning", "", "formula of sigma there", |state| state.peak_detuning.clone().into()),
        Of::value("folds", "", "formula that is zero where the response curve turns back", |state| {
            state.folds.clone().into()
        }),
        Of::value(
            "critical_drive",
            "",
            "formula of the amplitude of the drive above which there are folds, to lowest order",
            |state| state.critical_drive.clone().into(),
        ),
        Of::value("drive_amplitude", "", "formula of this amplitude in the symbols of the drive", |state| {
            state.drive_amplitude.clone().into()
        }),
        Of::value(
            "limit_cycle_amplitude",
            "",
            "without drive, formula of A on the only limit cycle",
            |state| state.cycle_amplitude.clone().into(),
        ),
        Of::value(
            "limit_cycle_frequency",
            "",
            "formula of the angular frequency of this limit cycle",
            |state| state.cycle_frequency.clone().into(),
        ),
        Of::value("trace", "", "trace of the Jacobian of dA/dt and dphi/dt at steady states", |state| {
            state.trace.clone().into()
        }),
        Of::value("determinant", "", "determinant of this Jacobian", |state| {
            state.determinant.clone().into()
        }),
        Of::value("notes[]", "", "reasons why formulas are null", |state| {
            json::list(state.notes.iter().map(String::as_str))
        }),
    ])
}

fn of_values() -> Fields<FlowValues> {
    Fields::from([
        Of::<FlowValues>::nullable(
            "drive_angular_frequency_rad_per_s",
            "rad/s",
            "drive frequency; null without drive",
            |values| values.drive_frequency,
        ),
        Of::number("detuning_rad_per_s", "rad/s", "sigma; 0 without drive", |values| values.detuning),
        Of::nested("steady_states[].", &of_solution(), |values| {
            of_solution().records(values.states.iter().flat_map(|states| &states.found))
        }),
        Of::nested("left_out[].", &of_left_out(), |values| {
            of_left_out().records(values.states.iter().flat_map(|states| &states.left_out))
        }),
    ])
}

fn of_solution() -> Fields<JudgedState> {
    Fields::from([
        Of::<JudgedState>::number("amplitude", "", "A", |solution| solution.state.amplitude),
        Of::nullable(
            "amplitude_error",
            "",
            "estimated error of A: the distance from that of the same state at the next order with further terms; null where this is not \
             known",
            |solution| Some(solution.errors?[0]),
        ),
        Of::number(
            "phase_rad",
            "rad",
            "phi, the smallest of those that differ by periods of the drive",
            |solution| solution.state.phase,
        ),
        Of::nullable(
            "phase_error_rad",
            "rad",
            "estimated error of phi, as that of A, and at least that of A over A",
            |solution| Some(solution.errors?[1]),
        ),
        Of::number("trace_per_s", "1/s", "trace of the Jacobian", |solution| solution.state.trace),
        Of::number("determinant", "", "determinant of the Jacobian; 0 without drive", |solution| {
            solution.state.determinant
        }),
        Of::value(
            "is_stable",
            "",
            "true if small deviations decay; null where this is undetermined: two orders disagree, or only one of several has the state, or \
             the trace is zero",
            |solution| solution.is_stable.into(),
        ),
    ])
}

fn of_left_out() -> Fields<StateLeftOut> {
    Fields::from([
        Of::<StateLeftOut>::number("amplitude", "", "A of a steady state that is left out", |omission| {
            omission.state.amplitude
        }),
        Of::number("phase_rad", "rad", "phi of this state", |omission| omission.state.phase),
        Of::value("order", "1", "order of the slow flow that has this state", |omission| {
            omission.order.into()
        }),
        Of::value("reason", "", "reason why it is left out: beyond_reach, of_lowest_order", |omission| {
            match omission.reason {
                LeftOutReason::BeyondReach => "beyond_reach",
                _ => "of_lowest_order",
            }
            .into()
        }),
        Of::value("explanation", "", "this reason as a sentence", |omission| why_left_out(omission).into()),
    ])
}

/// The formulas by name.
pub(super) fn formulas(answer: &SymbolicFlowResult) -> Vec<NamedFormula> {
    let flow = &answer.flow;
    let steady = &flow.steady_state;
    let named = [
        ("amplitude", Some(&flow.amplitude_rate)),
        ("phase", Some(&flow.phase_rate)),
        ("displacement", Some(&flow.displacement)),
        ("relation", steady.relation.as_ref()),
        ("backbone", steady.backbone.as_ref()),
        ("peak_amplitude", steady.peak_amplitude.as_ref()),
        ("peak_detuning", steady.peak_detuning.as_ref()),
        ("folds", steady.folds.as_ref()),
        ("critical_drive", steady.critical_drive.as_ref()),
        ("limit_cycle_amplitude", steady.cycle_amplitude.as_ref()),
        ("limit_cycle_frequency", steady.cycle_frequency.as_ref()),
        ("trace", steady.trace.as_ref()),
        ("determinant", steady.determinant.as_ref()),
    ];
    let meaning = |name: &str| match name {
        "amplitude" | "phase" => format!("rate of the {name}"),
        "relation" => "zero at steady states".to_owned(),
        "folds" => "zero where the response curve turns back".to_owned(),
        other => other.replace('_', " "),
    };
    let left = |name: &str| match name {
        "amplitude" => r"\dot A".to_owned(),
        "phase" => r"\dot\varphi".to_owned(),
        "displacement" => formulas::latex(&answer.subject.variable),
        "relation" | "folds" => "0".to_owned(),
        other => format!(r"\text{{{}}}", meaning(other)),
    };
    let named = named.into_iter().filter_map(|(name, text)| Some((name, text?.clone())));
    let formula = |(name, text): (&str, String)| NamedFormula {
        name: name.to_owned(),
        meaning: meaning(name),
        left: left(name),
        text,
    };
    named.map(formula).collect()
}

pub(super) fn of_formula() -> Fields<NamedFormula> {
    Fields::from([
        Of::<NamedFormula>::value("quantity", "", "quantity of the formula, as JSON names it", |formula| {
            formula.name.as_str().into()
        }),
        Of::value("formula", "", "its formula in plain text", |formula| formula.text.as_str().into()),
    ])
}

pub(super) fn answers() -> Answers {
    let (json, csv) = (of_flow().described(""), of_formula().described_in_csv());
    Answers { command: "expand", option: "--resonance", json, csv }
}
