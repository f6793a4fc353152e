//! The slow flow of coupled oscillators with symbols.

use super::ResonanceQuestion;
use crate::arguments::{drive_resonance, frequency_ratios, small_orders};
use crate::command::expand::BOOKKEEPING;
use crate::interrupt::{self, Cancellation};
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::formulas::{self, Heading, NamedFormula};
use crate::output::series::wrapped;
use crate::output::table::write_text;
use crate::output::{Form, json};
use crate::parallel;
use crate::query_error::{QueryError, argument, option};
use libration::perturbation::{
    CoordinateFlow, CoupledSlowFlow, SymbolicSlowFlowError, SymbolicSlowFlowOptions, coupled_slow_flow,
};
use std::io::{self, Write};

/// Lines are broken here.
const COLUMN: usize = 80;

/// A slow flow with its equations.
struct SymbolicResonanceResult {
    equations: String,
    small: Vec<(String, usize)>,
    flow: CoupledSlowFlow,
}

/// A formula of a coordinate. Names of functions end in that of the coordinate.
struct Formula {
    coordinate: String,
    quantity: &'static str,
    named: NamedFormula,
}

impl ResonanceQuestion {
    /// Returns `true` if options or symbols without values ask for formulas.
    pub(super) fn has_letters(&self) -> Result<bool, QueryError> {
        let is_asked = self.small.is_some() || self.ratios.is_some() || self.resonance.is_some();
        Ok(is_asked || !self.system.model_with_letters()?.open_parameters().is_empty())
    }

    /// Writes the slow flow with symbols.
    pub(super) fn answer_with_letters(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        if self.initial.is_given() || self.figure.is_some() {
            let given = if self.figure.is_some() { "figure" } else { "initial" };
            let reason = "it needs numbers for all symbols: give them by <--set>, without <--small>, <--ratios> and <--resonance>";
            return Err(QueryError::usage(option(given), reason));
        }
        if self.equilibrium.is_given() {
            let reason = "a slow flow with symbols is given about rest at zero: shift the coordinates";
            return Err(QueryError::usage(option("about"), reason));
        }
        let model = self.system.model_with_letters()?;
        let bookkeeping = || {
            let open = model.open_parameters();
            open.contains(&BOOKKEEPING.to_owned()).then(|| (BOOKKEEPING.to_owned(), 1)).into_iter().collect()
        };
        let small = self.small.as_deref().map(small_orders).transpose()?;
        let options = SymbolicSlowFlowOptions {
            small: small.unwrap_or_else(bookkeeping),
            resonance: self.resonance.as_deref().map(drive_resonance).transpose()?,
            ratios: self.ratios.as_deref().map(frequency_ratios).transpose()?.unwrap_or_default(),
            order: self.order,
            about: None,
        };
        interrupt::listen()?;
        let flow = parallel::with_progress(
            || "slow flow".to_owned(),
            || coupled_slow_flow(model.equation(), &options, &Cancellation),
        );
        let flow = flow.map_err(|error| failure(&error))?;
        let answer =
            SymbolicResonanceResult { equations: model.equation().to_string(), small: options.small, flow };
        if let Some(format) = self.formats.format() {
            let latex = &model.equation().to_latex();
            let heading = Heading { module: "slow_flow", equations: &answer.equations, latex };
            let formulas: Vec<NamedFormula> =
                answer.formulas().into_iter().map(|formula| formula.named).collect();
            return formulas::write(out, format, &heading, &formulas);
        }
        match self.form.form() {
            Form::Json => json::document(out, of_answer().record(&answer))?,
            Form::Csv => of_formula().write_csv(out, &answer.formulas())?,
            Form::Table => answer.write(out)?,
        }
        Ok(out.flush()?)
    }
}

impl SymbolicResonanceResult {
    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        write_text(out, "", &self.equations)?;
        write_text(out, "", &self.setting())?;
        if let Some(note) = &self.flow.order_note {
            write_text(out, "", note)?;
        }
        for coordinate in &self.flow.coordinates {
            writeln!(out)?;
            let lines = [
                (format!("d{}/dt = ", coordinate.amplitude), &coordinate.amplitude_rate),
                (format!("d{}/dt = ", coordinate.phase), &coordinate.phase_rate),
                (format!("{} = ", coordinate.name), &coordinate.displacement),
            ];
            for (name, formula) in lines {
                writeln!(out, "{}", wrapped(&name, formula, COLUMN))?;
            }
        }
        Ok(())
    }

    fn setting(&self) -> String {
        let flow = &self.flow;
        let mut parts = vec![format!("slow flow to order {}", flow.order)];
        parts.extend(flow.natural_frequency_squared.iter().map(|square| format!("w0 = sqrt({square})")));
        for coordinate in &flow.coordinates {
            let shift = coordinate.frequency_difference.as_ref();
            let shift = shift.map_or(String::new(), |shift| format!(" + {shift}"));
            parts.push(format!("{}: frequency {}{shift}", coordinate.name, coordinate.natural_frequency));
        }
        parts.extend(flow.drive_frequency.iter().map(|drive| format!("drive: frequency {drive}")));
        parts.join("; ")
    }

    fn formulas(&self) -> Vec<Formula> {
        let of_coordinate = |flow: &CoordinateFlow| {
            let rate = |symbol: &str| format!(r"\dot{{{}}}", formulas::latex(symbol));
            let all = [
                ("amplitude", "rate of the amplitude", rate(&flow.amplitude), &flow.amplitude_rate),
                ("phase", "rate of the phase", rate(&flow.phase), &flow.phase_rate),
                ("displacement", "displacement", formulas::latex(&flow.name), &flow.displacement),
            ];
            all.map(|(quantity, meaning, left, text)| Formula {
                coordinate: flow.name.clone(),
                quantity,
                named: NamedFormula {
                    name: format!("{quantity}_{}", flow.name),
                    meaning: format!("{meaning} of {}", flow.name),
                    left,
                    text: text.clone(),
                },
            })
        };
        self.flow.coordinates.iter().flat_map(of_coordinate).collect()
    }
}

fn of_answer() -> Fields<SymbolicResonanceResult> {
    type Of = Field<SymbolicResonanceResult>;
    Fields::from([
        Of::value("equations[]", "", "equations of motion as they were read", |result| {
            json::list(result.equations.split("; "))
        }),
        Of::value("order", "1", "highest order in the small parameters", |result| result.flow.order.into()),
        Of::value(
            "order_note",
            "",
            "terms of the equations that are of higher order; null where there are none",
            |result| result.flow.order_note.clone().into(),
        ),
        Of::value("small_orders.NAME", "1", "order of the small parameter with this name", |result| {
            json::object(result.small.iter().cloned())
        }),
        Of::value(
            "resonance",
            "1",
            "p/q of W = (p/q)·ω + detuning, drive over the natural frequency of the first coordinate; null without drive",
            |result| result.flow.resonance.map(|(p, q)| format!("{p}/{q}")).into(),
        ),
        Of::value("drive_frequency", "", "formula of the drive frequency W; null without drive", |result| {
            result.flow.drive_frequency.clone().into()
        }),
        Of::value("detuning", "", "symbol of the detuning of the drive; null without drive", |result| {
            result.flow.detuning.clone().into()
        }),
        Of::value(
            "natural_frequency_squared",
            "",
            "formula of w0², where the natural frequency of the first coordinate is called w0; null otherwise",
            |result| result.flow.natural_frequency_squared.clone().into(),
        ),
        Of::nested("coordinates[].", &of_coordinate(), |result| {
            of_coordinate().records(&result.flow.coordinates)
        }),
        Of::nested("steady_state.", &of_steady_states(), |result| {
            of_steady_states().record(&result.flow).into()
        }),
    ])
}

fn of_coordinate() -> Fields<CoordinateFlow> {
    type Of = Field<CoordinateFlow>;
    Fields::from([
        Of::value("name", "", "name of the coordinate", |flow| flow.name.as_str().into()),
        Of::value("amplitude", "", "symbol of its amplitude", |flow| flow.amplitude.as_str().into()),
        Of::value("phase", "", "symbol of its phase", |flow| flow.phase.as_str().into()),
        Of::value(
            "natural_frequency",
            "",
            "formula of its natural frequency without detuning, symbols being positive",
            |flow| flow.natural_frequency.as_str().into(),
        ),
        Of::value(
            "frequency_difference",
            "",
            "formula of what is added to it for the natural frequency of its equation; null where that is the same",
            |flow| flow.frequency_difference.clone().into(),
        ),
        Of::value("frequency_squared", "", "formula of the square of the latter; null likewise", |flow| {
            flow.detuning.as_ref().map(|[_, square]| square.clone()).into()
        }),
        Of::nested("slow_flow.", &of_rates(), |flow| of_rates().record(flow).into()),
        Of::value(
            "displacement",
            "",
            "formula of the coordinate: the amplitude times a cosine, and terms of other frequencies",
            |flow| flow.displacement.as_str().into(),
        ),
    ])
}

fn of_rates() -> Fields<CoordinateFlow> {
    type Of = Field<CoordinateFlow>;
    Fields::from([
        Of::value("amplitude", "", "formula of the time derivative of the amplitude", |flow| {
            flow.amplitude_rate.as_str().into()
        }),
        Of::value("phase", "", "formula of the time derivative of the phase", |flow| {
            flow.phase_rate.as_str().into()
        }),
    ])
}

fn of_steady_states() -> Fields<CoupledSlowFlow> {
    Fields::from([Field::<CoupledSlowFlow>::value(
        "equations[]",
        "",
        "for each coordinate A′ and A·phi′, all zero at steady states",
        |flow| {
            json::list(
                flow.coordinates
                    .iter()
                    .flat_map(|coordinate| coordinate.equations.iter().map(String::as_str)),
            )
        },
    )])
}

fn of_formula() -> Fields<Formula> {
    type Of = Field<Formula>;
    Fields::from([
        Of::value("coordinate", "", "name of the coordinate", |formula| formula.coordinate.as_str().into()),
        Of::value(
            "quantity",
            "",
            "amplitude and phase of which the rate is given, or displacement",
            |formula| formula.quantity.into(),
        ),
        Of::value("formula", "", "its formula in plain text", |formula| formula.named.text.as_str().into()),
    ])
}

pub(super) fn answers() -> Answers {
    let (json, csv) = (of_answer().described(""), of_formula().described_in_csv());
    Answers { command: "resonance", option: "--ratios", json, csv }
}

fn failure(error: &SymbolicSlowFlowError) -> QueryError {
    use SymbolicSlowFlowError as Error;
    match error {
        Error::Interrupted => QueryError::cancelled("interrupted before the slow flow was known"),
        Error::Order(_) => QueryError::usage(option("order"), error),
        Error::UnknownParameter { .. } | Error::NothingSmall => QueryError::usage(option("small"), error),
        Error::Resonance(..) | Error::NoDrive | Error::NoResonance => {
            QueryError::usage(option("resonance"), error)
        }
        Error::Ratios { .. } | Error::UnknownRatio(_) => QueryError::usage(option("ratios"), error),
        _ => QueryError::no_result(argument("SYSTEM|EQUATION"), error),
    }
}
