//! A parameter with the range over which it is followed: `omega=0.3:1.4`.

use super::commas::at_commas;
use super::parameter_range::constant;
use super::values::plain_name;

/// A parameter with the values at both ends.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ParameterSpan {
    pub(crate) name: String,
    pub(crate) range: [f64; 2],
}

/// Reads `NAME=FROM:TO`, whose numbers may be formulas of numbers.
pub(crate) fn parameter_span(text: &str) -> Result<ParameterSpan, String> {
    let refusal = || "give NAME=FROM:TO, as omega=0.3:1.4".to_owned();
    let (name, range) = text.split_once('=').ok_or_else(refusal)?;
    let [from, to] = range.split(':').collect::<Vec<_>>()[..] else { return Err(refusal()) };
    let end = |text: &str| {
        let value = constant(text)?.to_f64().filter(|value| value.is_finite());
        value.ok_or_else(|| format!("`{}` is not a finite number", text.trim()))
    };
    Ok(ParameterSpan { name: plain_name(name), range: [end(from)?, end(to)?] })
}

/// Reads two spans, `NAME=FROM:TO,NAME=FROM:TO`.
pub(crate) fn two_parameter_spans(text: &str) -> Result<[ParameterSpan; 2], String> {
    let refusal = || "give two parameters, as omega=1:3,a=0:0.5".to_owned();
    let [first, second] = at_commas(text)[..] else { return Err(refusal()) };
    let spans = [parameter_span(first)?, parameter_span(second)?];
    match spans[0].name == spans[1].name {
        true => Err(format!("`{}` is given twice: {}", spans[0].name, refusal())),
        false => Ok(spans),
    }
}
