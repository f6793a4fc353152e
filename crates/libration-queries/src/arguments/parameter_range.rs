//! A parameter and the values it shall have: `A=0.9:1.5:0.001`.

use super::commas::at_commas;
use super::values::plain_name;
use libration::expression::Expression;

/// More values than this are never requested.
const MOST_VALUES: u32 = 1_000_000;

/// A parameter with its values.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterRange {
    pub name: String,
    pub values: Vec<f64>,
}

/// Reads `NAME=START:STOP:STEP` or `NAME=v1,v2,…`, whose numbers may be formulas of numbers.
pub fn parameter_range(text: &str) -> Result<ParameterRange, String> {
    let (name, values) = text.split_once('=').ok_or("give NAME=START:STOP:STEP, as A=0.9:1.5:0.001")?;
    let values = match values.split(':').collect::<Vec<_>>()[..] {
        [start, stop, step] => progression(constant(start)?, constant(stop)?, constant(step)?)?,
        [list] => {
            at_commas(list).into_iter().map(|item| value(&constant(item)?)).collect::<Result<_, _>>()?
        }
        _ => return Err("give START:STOP:STEP, as 0.9:1.5:0.001".to_owned()),
    };
    Ok(ParameterRange { name: plain_name(name), values })
}

/// START + k·STEP up to STOP, which is met although decimals are no binary numbers.
pub(crate) fn progression(start: Expression, stop: Expression, step: Expression) -> Result<Vec<f64>, String> {
    let (from, to, by) = (value(&start)?, value(&stop)?, value(&step)?);
    let steps = ((to - from) / by * (1.0 + 1e-12)).floor();
    if !(0.0..f64::from(MOST_VALUES)).contains(&steps) {
        return Err(format!("give a step that leads from {from:?} to {to:?} in at most {MOST_VALUES} steps"));
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and a million")]
    let count = steps as u32;
    let element = |k: u32| {
        let part = Expression::Multiply(Box::new(Expression::from(i64::from(k))), Box::new(step.clone()));
        value(&Expression::Add(Box::new(start.clone()), Box::new(part)).simplified())
    };
    (0..=count).map(element).collect()
}

/// A formula of numbers.
pub(crate) fn constant(text: &str) -> Result<Expression, String> {
    text.parse().map_err(|error: libration::expression::ParseError| error.to_string())
}

fn value(constant: &Expression) -> Result<f64, String> {
    let value = constant.to_f64().filter(|value| value.is_finite());
    value.ok_or_else(|| format!("`{constant}` is not a finite number"))
}
