//! An axis of a sweep: a name, and the values that it has along the grid.

use crate::arguments::{constant, plain_name, progression};
use crate::output::number;
use libration::expression::Expression;

/// More values than this are never requested.
const MOST_VALUES: usize = 1_000_000;

/// A name with its values, each as the question is given it.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    pub(crate) name: String,
    /// The values as typed.
    pub values: Vec<String>,
    /// The values as numbers in one unit, if they are numbers.
    pub numbers: Option<Vec<f64>>,
    /// Unit of the numbers; empty without a unit.
    pub unit: String,
}

impl Axis {
    /// The axis with a name and values as words, which are converted if all of them are numbers.
    pub(crate) fn of_words(name: &str, values: Vec<String>) -> Result<Self, String> {
        if name.trim().is_empty() || name.contains(['{', '}']) {
            return Err("an axis needs a name: give NAME=VALUES, such as A=1:1.5:0.01".to_owned());
        }
        let name = plain_name(name);
        if let Some(bad) = values.iter().find(|value| value.trim().is_empty() || value.contains(['\n', '\r']))
        {
            return Err(format!("{name}: `{}` is not a value", bad.escape_debug()));
        }
        if values.is_empty() || values.len() > MOST_VALUES {
            return Err(format!("{name}: give at least one value, and at most {MOST_VALUES}"));
        }
        let numbers: Option<Vec<(f64, &str)>> = values.iter().map(|value| in_unit(value)).collect();
        let (numbers, unit) = match numbers {
            Some(numbers) if numbers.iter().all(|(_, unit)| *unit == numbers[0].1) => {
                (Some(numbers.iter().map(|(number, _)| *number).collect()), numbers[0].1.to_owned())
            }
            _ => (None, String::new()),
        };
        Ok(Self { name, values, numbers, unit })
    }

    /// A value as it is printed in results: in the unit of the axis, or as typed.
    pub(crate) fn shown(&self, index: usize) -> String {
        match &self.numbers {
            Some(numbers) => number::exact(numbers[index]),
            None => self.values[index].clone(),
        }
    }
}

/// Reads `NAME=START:STOP:STEP`, whose numbers may have a unit, or `NAME=v1,v2,…`; values that contain commas are separated by semicolons.
pub fn axis(text: &str) -> Result<Axis, String> {
    let (name, values) = text.split_once('=').ok_or("give NAME=VALUES, such as A=1:1.5:0.01")?;
    if let [start, stop, step] = values.split(':').collect::<Vec<_>>()[..] {
        return Axis::of_words(name, range(start, stop, step)?);
    }
    if let [start, stop] = values.split(':').collect::<Vec<_>>()[..]
        && [start, stop].iter().all(|end| in_unit(end).is_some())
    {
        return Err(format!("give a step, too: {}={start}:{stop}:STEP", name.trim()));
    }
    let separator = if values.contains(';') { ';' } else { ',' };
    Axis::of_words(name, values.split(separator).map(|value| value.trim().to_owned()).collect())
}

fn range(start: &str, stop: &str, step: &str) -> Result<Vec<String>, String> {
    let parts = [start, stop, step].map(number_and_unit);
    let [(start, unit), (stop, second), (step, third)] = parts;
    if unit != second || unit != third {
        return Err("give START:STOP:STEP in one unit, such as 1deg:179deg:1deg".to_owned());
    }
    let values = progression(constant(start)?, constant(stop)?, constant(step)?)?;
    Ok(values.into_iter().map(|value| number::exact(value) + unit).collect())
}

/// A decimal and the unit after it; the whole text if it is not a decimal with a unit.
fn number_and_unit(text: &str) -> (&str, &str) {
    let text = text.trim();
    let is_decimal = |text: &str| text.parse::<f64>().is_ok_and(f64::is_finite);
    if is_decimal(text) {
        return (text, "");
    }
    let begins_unit = |(_, letter): &(usize, char)| letter.is_alphabetic() || *letter == '°';
    let mut ends = text.char_indices().filter(begins_unit).map(|(start, _)| start);
    let end = ends.rfind(|&end| is_decimal(text[..end].trim_end()));
    end.map_or((text, ""), |end| (text[..end].trim_end(), &text[end..]))
}

fn in_unit(text: &str) -> Option<(f64, &str)> {
    let (number, unit) = number_and_unit(text);
    let value = number.parse().ok().or_else(|| constant(number).ok().as_ref().and_then(Expression::to_f64));
    Some((value.filter(|value| value.is_finite())?, unit))
}
