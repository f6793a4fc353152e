//! The slow flow with symbolic parameters as the result of `libration expand`.

use super::{FlowValues, SymbolicFlowResult, failure, listing};
use crate::arguments::{OscillatorOptions, drive_resonance, small_orders};
use crate::command::expand::subject::Subject;
use crate::command::expand::{BOOKKEEPING, Expand};
use crate::interrupt::Cancellation;
use crate::output::formulas::{self, Heading};
use crate::output::{Form, json};
use crate::parallel;
use crate::query_error::{QueryError, option};
use libration::expression::{Equation, Expression};
use libration::perturbation::{
    SymbolicSlowFlow, SymbolicSlowFlowOptions, drive_symbol, next_slow_flow, slow_flow_symbolically,
};
use std::io::Write;

impl Expand {
    /// Returns `true` if options or symbols request a slow flow with several symbols: a resonance, small parameters with orders, or a small
    /// parameter next to other symbols.
    pub(in crate::command::expand) fn is_symbolic_flow(&self) -> bool {
        if self.resonance.is_some() {
            return true;
        }
        let Some(small) = &self.small else { return false };
        if small.contains([':', ',']) {
            return true;
        }
        let open = || Some(self.oscillator.asked().ok()?.equation.parameters());
        self.damping_order.is_none() && open().is_some_and(|open| open.len() > 1 && open.contains(small))
    }

    /// Writes the slow flow with symbols if the equation has no other expansion.
    pub(in crate::command::expand) fn symbolic_flow_or(
        &self,
        out: &mut dyn Write,
        refused: QueryError,
    ) -> Result<(), QueryError> {
        let is_plain = self.evaluate.is_none()
            && self.small.is_none()
            && self.gauge.is_none()
            && self.letters.is_empty();
        let equation = self.oscillator.asked().map(|asked| asked.equation);
        let is_driven = equation.as_ref().is_ok_and(|equation| drive_symbol(equation).is_some());
        let has_symbols = equation.is_ok_and(|equation| {
            let open = equation.parameters();
            open.len() > 1 || open.contains(BOOKKEEPING)
        });
        let has_small =
            self.oscillator.asked().is_ok_and(|asked| asked.equation.parameters().contains(BOOKKEEPING));
        let mut answer = vec![];
        match (is_plain && has_symbols).then(|| self.answer_symbolic_flow(&mut answer)) {
            Some(Ok(())) => Ok(out.write_all(&answer)?),
            Some(Err(better)) if better.is_cancelled() || is_driven => Err(better),
            Some(Err(_)) if !has_small => {
                let hint = "<--small> with small parameters and their orders, such as <--small> mu:1, gives the slow flow with symbols";
                Err(refused.with_hint(hint))
            }
            _ => Err(refused),
        }
    }

    pub(in crate::command::expand) fn answer_symbolic_flow(
        &self,
        out: &mut dyn Write,
    ) -> Result<(), QueryError> {
        let answer = self.symbolic_answer()?;
        if let Some(format) = self.formats.format() {
            let Subject { equation, equation_latex, .. } = &answer.subject;
            let latex = std::slice::from_ref(equation_latex);
            let heading = Heading { module: "slow_flow", equations: equation, latex };
            return formulas::write(out, format, &heading, &super::fields::formulas(&answer));
        }
        match self.form.form() {
            Form::Json => json::document(out, super::fields::of_flow().record(&answer))?,
            Form::Csv => super::fields::of_formula().write_csv(out, &super::fields::formulas(&answer))?,
            Form::Table => listing::write(out, &answer)?,
        }
        Ok(out.flush()?)
    }

    fn symbolic_answer(&self) -> Result<SymbolicFlowResult, QueryError> {
        if self.gauge.is_some() {
            let reason = "here A is the whole amplitude of the component near the natural frequency: leave the gauge out";
            return Err(QueryError::usage(option("gauge"), reason));
        }
        let (held, asked) = self.held_back()?;
        let options = SymbolicSlowFlowOptions {
            small: held.small.clone(),
            resonance: self.resonance.as_deref().map(drive_resonance).transpose()?,
            order: self.order,
            ratios: vec![],
            about: asked.about.clone(),
        };
        let equation = asked.equation.clone();
        let how_far = || "slow flow".to_owned();
        let flow =
            parallel::with_progress(how_far, || slow_flow_symbolically(&equation, &options, &Cancellation))
                .map_err(|error| failure(&error))?;
        let next = || next_slow_flow(&equation, &options, &flow, &Cancellation);
        let values = self.values(&flow, &held, next)?;
        let subject = Subject::new(&equation, (asked.key, asked.title), asked.values, asked.read_as);
        Ok(SymbolicFlowResult { subject, flow, small: held.shown(&equation), values })
    }

    /// The equation with values for all parameters except the small ones and the drive frequency, whose values are kept for the result.
    fn held_back(&self) -> Result<(HeldBack, crate::arguments::Asked), QueryError> {
        let small = self.small.as_deref().map(small_orders).transpose()?.unwrap_or_default();
        let (text, set, about) = self.oscillator.parts();
        let plain = OscillatorOptions::new(text, &[], about).asked();
        let drive = plain.ok().and_then(|asked| drive_symbol(&asked.equation));
        let is_held = |name: &str| {
            let is_small = if small.is_empty() {
                name == BOOKKEEPING
            } else {
                small.iter().any(|(letter, _)| letter == name)
            };
            is_small || drive.as_deref() == Some(name)
        };
        let name_of = |text: &String| text.split('=').next().unwrap_or_default().trim().to_owned();
        let (kept, put): (Vec<String>, Vec<String>) =
            set.iter().cloned().partition(|text| is_held(&name_of(text)));
        let values = kept.iter().map(|text| held_value(text)).collect::<Result<_, _>>()?;
        Ok((HeldBack { small, values }, OscillatorOptions::new(text, &put, about).asked()?))
    }

    /// Steady states where all symbols have values.
    ///
    /// `next` gives the slow flow of the next order, which estimates the errors.
    fn values(
        &self,
        flow: &SymbolicSlowFlow,
        held: &HeldBack,
        next: impl Fn() -> Option<SymbolicSlowFlow>,
    ) -> Result<Option<FlowValues>, QueryError> {
        let drive =
            self.evaluate.as_deref().map(|text| number(text).ok_or_else(|| not_a_number("evaluate", text)));
        let drive = drive.transpose()?;
        if drive.is_some() && flow.resonance.is_none() {
            let reason = "there is no drive: <--evaluate> takes the drive frequency of a slow flow";
            return Err(QueryError::usage(option("evaluate"), reason));
        }
        let of_name =
            |name: &str| held.values.iter().find(|(letter, _)| letter == name).map(|(_, value)| *value);
        match flow.at(&of_name, drive) {
            Ok(at) => {
                let next = next();
                let next = next.as_ref().and_then(|flow| flow.at(&of_name, drive).ok());
                Ok(Some(FlowValues {
                    drive_frequency: at.drive_frequency(),
                    detuning: at.detuning(),
                    states: at.judged_states(next.as_ref()),
                }))
            }
            Err(missing) if drive.is_some() => {
                let reason = format!("no value is given for {}", missing.join(", "));
                Err(QueryError::usage(option("set"), reason))
            }
            Err(_) => Ok(None),
        }
    }
}

/// Small parameters, and values that are not put into the equation.
struct HeldBack {
    small: Vec<(String, usize)>,
    values: Vec<(String, f64)>,
}

impl HeldBack {
    /// The small parameters as they were used.
    fn shown(&self, equation: &Equation) -> Vec<(String, usize)> {
        match self.small.is_empty() && equation.parameters().contains(BOOKKEEPING) {
            true => vec![(BOOKKEEPING.to_owned(), 1)],
            false => self.small.clone(),
        }
    }
}

fn held_value(text: &str) -> Result<(String, f64), QueryError> {
    let (name, value) = text.split_once('=').unwrap_or((text, ""));
    let value = number(value).ok_or_else(|| not_a_number("set", text))?;
    Ok((name.trim().to_owned(), value))
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse::<Expression>().ok()?.to_f64().filter(|value| value.is_finite())
}

fn not_a_number(name: &'static str, text: &str) -> QueryError {
    QueryError::usage(option(name), format!("`{}` is not a finite number", text.trim()))
}
