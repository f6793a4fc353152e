//! Fields of a normal form, its terms and the exchange of energy.

use super::ResonanceResult;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::{at_most, rounded, short, to_its_error};
use libration::normal_form::{Divisor, Exchange, MeasuredExchange, SlowTerm};
use libration::normal_modes::Mode;

/// A mode with its number, from 1.
struct NumberedResonance<'a> {
    number: usize,
    mode: &'a Mode,
}

/// An exchange of energy by the slow flow, and by integration.
pub(super) type Both = (Exchange, MeasuredExchange);

pub(super) fn of_answer() -> Fields<ResonanceResult> {
    type Of = Field<ResonanceResult>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |result| {
            result.model.key().into()
        })
        .line_of("system", |result| result.model.title().to_owned()),
        Of::value("equations[]", "", "equations of motion as they were read", |result| {
            json::list(result.model.equation().to_string().split("; "))
        }),
        Of::value("coordinates[]", "", "names of the coordinates", |result| {
            json::list(result.form.modes.variables.clone())
        }),
        Of::value("equilibrium[]", "", "coordinates of the equilibrium", |result| {
            json::numbers(&result.form.modes.equilibrium)
        }),
        Of::value("order", "1", "greatest degree of the monomials in the amplitudes", |result| {
            result.form.order.into()
        })
        .line_of("order", |result| format!("{} in the amplitudes", result.form.order)),
        Of::nested("modes[].", &of_mode(), |result| {
            let modes =
                (1..).zip(&result.form.modes.modes).map(|(number, mode)| NumberedResonance { number, mode });
            of_mode().records(&modes.collect::<Vec<_>>())
        }),
        Of::nested("small_divisors[].", &of_divisor(), |result| {
            of_divisor().records(&result.form.small_divisors)
        }),
        Of::value(
            "slow_flow",
            "",
            "the slow flow in real numbers, a1 = u1 + i*w1, as equations of motion",
            |result| result.form.slow_flow().to_string().into(),
        ),
        Of::value("initial[]", "", "state at the start, or null", |result| {
            result.initial.as_ref().map(|state| json::numbers(state)).into()
        }),
        Of::present_nested("exchange.", &of_exchange(), |result| {
            let both = result.exchange.as_ref()?.as_ref().ok()?;
            Some(of_exchange().record(both).into())
        }),
        Of::value("no_exchange", "", "reason why there is no exchange from the start, or null", |result| {
            result
                .exchange
                .as_ref()
                .and_then(|exchange| exchange.as_ref().err())
                .map(ToString::to_string)
                .into()
        }),
    ])
}

fn of_mode<'a>() -> Fields<NumberedResonance<'a>> {
    type Of<'a> = Field<NumberedResonance<'a>>;
    Fields::from([
        Of::value("mode", "1", "number of the mode, from 1", |resonance| resonance.number.into()),
        Of::number(
            "angular_frequency_rad_per_s",
            "rad/s",
            "angular frequency of small oscillations",
            |resonance| resonance.mode.frequency(),
        ),
        Of::value("shape[]", "", "displacements of the coordinates, the largest 1", |resonance| {
            json::list(resonance.mode.shape.iter().map(|part| part.re))
        }),
    ])
}

fn of_divisor() -> Fields<Divisor> {
    type Of = Field<Divisor>;
    Fields::from([
        Of::value("mode", "1", "number of the mode", |divisor| (divisor.mode + 1).into()),
        Of::value("monomial", "", "term that is removed, ~ for conjugates", |divisor| {
            monomial(&divisor.powers, &divisor.conjugate_powers).into()
        }),
        Of::number("divisor_rad_per_s", "rad/s", "its frequency less that of the mode", |divisor| {
            divisor.divisor
        }),
    ])
}

pub(super) fn of_term() -> Fields<SlowTerm> {
    type Of = Field<SlowTerm>;
    Fields::from([
        Of::value("mode", "1", "number of the mode whose amplitude changes", |term| (term.mode + 1).into())
            .numeral("mode", |term| (term.mode + 1).to_string()),
        Of::value("monomial", "", "product of amplitudes, ~ for conjugates", |term| {
            monomial(&term.powers, &term.conjugate_powers).into()
        })
        .words("term", |term| monomial(&term.powers, &term.conjugate_powers)),
        Of::number("real", "", "real part of its coefficient", |term| term.coefficient.re)
            .numeral("coefficient", coefficient),
        Of::number("imaginary", "", "imaginary part of its coefficient", |term| term.coefficient.im),
        Of::value("exact", "", "coefficient with square roots, or null", |term| term.exact.as_deref().into())
            .words("exactly", |term| term.exact.clone().unwrap_or_default()),
        Of::value("kind", "", "shift, of a frequency with an amplitude, or resonance", |term| {
            kind(term).into()
        })
        .words("kind", |term| kind(term).to_owned()),
        Of::number("detuning_rad_per_s", "rad/s", "its frequency less that of the mode", |term| {
            term.detuning
        })
        .short("detuning", 4),
    ])
}

pub(super) fn of_exchange() -> Fields<Both> {
    type Of = Field<Both>;
    Fields::from([
        Of::number("period_s", "s", "time in which the amplitudes return, by the slow flow", |both| {
            both.0.period
        })
        .line_of("exchange by the slow flow", |both| period(both.0.period, both.0.error)),
        Of::number(
            "error_s",
            "s",
            "error of it as the period of the slow flow, from the change over a tenth of the time",
            |both| both.0.error,
        ),
        Of::nullable(
            "closed_form_s",
            "s",
            "the same by Jacobi functions with second-order terms only, or null",
            |both| both.0.closed_form,
        )
        .line_of("second order, closed form", |both| {
            both.0.closed_form.map_or_else(String::new, |period| format!("{} s", rounded(period, 10)))
        }),
        Of::number("measured_period_s", "s", "the same of the whole motion, by integration", |both| {
            both.1.period
        })
        .line_of("exchange of the whole motion", |both| period(both.1.period, both.1.error)),
        Of::number(
            "measured_error_s",
            "s",
            "its error, from the change over a tenth of the time of integration",
            |both| both.1.error,
        ),
        Of::number(
            "relative_difference",
            "1",
            "period of the slow flow over that of the motion, minus 1",
            |both| both.0.period / both.1.period - 1.0,
        )
        .line_of("relative difference", |both| short(both.0.period / both.1.period - 1.0, 2)),
        Of::value(
            "amplitudes[][]",
            "",
            "least and greatest amplitude of each mode during the exchange",
            |both| json::list(both.0.amplitudes.iter().map(|ends| json::numbers(ends))),
        )
        .line_of("amplitudes", |both| {
            let ends = both
                .0
                .amplitudes
                .iter()
                .map(|[least, most]| format!("{} … {}", short(*least, 6), short(*most, 6)));
            ends.collect::<Vec<_>>().join(", ")
        }),
    ])
}

fn period(value: f64, error: f64) -> String {
    format!("{} s, to {}", to_its_error(value, error, 12), at_most(error))
}

/// `-0.0625i`, `0.5 + 2i`.
fn coefficient(term: &SlowTerm) -> String {
    let (re, im) = (term.coefficient.re, term.coefficient.im);
    let imaginary = format!("{}i", short(im, 10));
    match (re == 0.0, im == 0.0) {
        (_, true) => short(re, 10),
        (true, false) => imaginary,
        (false, false) => format!("{} + {imaginary}", short(re, 10)),
    }
}

fn kind(term: &SlowTerm) -> &'static str {
    if term.is_of_every_system() { "shift" } else { "resonance" }
}

/// `a1^2*a2~`.
fn monomial(powers: &[u8], conjugates: &[u8]) -> String {
    let factor = |(mode, power, bar): (usize, u8, &str)| match power {
        0 => None,
        1 => Some(format!("a{}{bar}", mode + 1)),
        _ => Some(format!("a{}{bar}^{power}", mode + 1)),
    };
    let plain = powers.iter().enumerate().map(|(mode, power)| (mode, *power, ""));
    let bars = conjugates.iter().enumerate().map(|(mode, power)| (mode, *power, "~"));
    plain.chain(bars).filter_map(factor).collect::<Vec<_>>().join("*")
}

pub(super) fn told(divisor: &Divisor) -> String {
    let term = monomial(&divisor.powers, &divisor.conjugate_powers);
    format!("{term} in a{}' with {} rad/s", divisor.mode + 1, short(divisor.divisor, 6))
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [of_answer().described(""), of_term().described("slow_terms[].")].concat();
    let plain = Answers { command: "resonance", option: "", json, csv: of_term().described_in_csv() };
    vec![plain, super::letters::answers()]
}
