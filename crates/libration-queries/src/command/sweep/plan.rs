//! Command and kept fields of a sweep as data: enough to compute any of its chunks anywhere.

use super::axis::Axis;
use super::grid::Grid;
use super::kept::{self, Kept};
use super::point;
use super::question::Template;
use crate::command::fields_of;
use crate::output::description::Description;
use crate::output::json::{self, Record};
use crate::query_error::{QueryError, option};
use serde_json::Value;

/// The version of the format of a plan and of its chunks.
pub(crate) const FORMAT: u64 = 1;

/// The columns that state whether there is a result, after those of the numbers.
pub(crate) const BESIDE: [&str; 2] = ["status", "message"];

/// A query, its axes and the kept numbers of each result.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Plan {
    pub(crate) template: Template,
    pub(crate) axes: Vec<Axis>,
    pub(crate) kept: Vec<KeptField>,
    pub(crate) grid: Grid,
}

/// A kept field, with its description in `libration fields`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct KeptField {
    pub(crate) kept: Kept,
    pub(crate) unit: String,
    pub(crate) meaning: String,
}

/// A requested sweep: words, values along the axes, paths to the kept fields, and the largest number of points of a chunk.
#[derive(Debug)]
pub(crate) struct SweepRequest<'a> {
    pub(crate) question: &'a [String],
    pub(crate) axes: Vec<Axis>,
    pub(crate) keep: &'a [String],
    pub(crate) chunk: Option<usize>,
}

impl Plan {
    /// Runs a few points until one has a result, from which the kept fields follow.
    pub(crate) fn new(asked: SweepRequest<'_>) -> Result<Self, QueryError> {
        let SweepRequest { question, axes, keep, chunk } = asked;
        if let Some((index, axis)) = (axes.iter().enumerate())
            .find(|(index, axis)| axes[..*index].iter().any(|other| other.name == axis.name))
        {
            let reason = format!("`{}` is axis {} already: give each axis once", axis.name, index);
            return Err(QueryError::usage(option("over"), reason));
        }
        if let Some(axis) = axes.iter().find(|axis| BESIDE.contains(&axis.name.as_str())) {
            let reason =
                format!("`{}` is the name of a column of every sweep: give the axis another", axis.name);
            return Err(QueryError::usage(option("over"), reason));
        }
        let template = Template::new(question, &axes)?;
        let grid = Grid::new(axes.iter().map(|axis| axis.values.len()).collect(), chunk)
            .ok_or_else(|| QueryError::usage(option("over"), "the axes have too many points together"))?;
        let answer = first_answer(&template, &axes, &grid)?;
        let fields = fields_of(question);
        let kept = match keep.is_empty() {
            true => all_numbers(&fields, &answer)?,
            false => chosen(keep, &answer)?,
        };
        let kept = named_apart(kept, &axes).into_iter().map(|kept| described(&fields, kept)).collect();
        Ok(Self { template, axes, kept, grid })
    }

    /// The plan as JSON for [`Plan::read`].
    pub(crate) fn to_json(&self) -> Record {
        let axis = |axis: &Axis| {
            let record = Record::new().with("name", axis.name.as_str()).with("unit", axis.unit.as_str());
            let numbers = axis.numbers.as_deref().map(json::numbers);
            record.with("values", axis.values.clone()).with("numbers", numbers)
        };
        let field = |field: &KeptField| {
            let record = Record::new().with("name", field.kept.name.as_str());
            let record = record.with("path", field.kept.path.as_str()).with("length", field.kept.length());
            record.with("unit", field.unit.as_str()).with("meaning", field.meaning.as_str())
        };
        Record::new()
            .with("format", FORMAT)
            .with("version", env!("CARGO_PKG_VERSION"))
            .with("question", self.template.0.clone())
            .with("axes", json::records(self.axes.iter().map(axis)))
            .with("fields", json::records(self.kept.iter().map(field)))
            .with("shape", json::list(self.grid.shape.clone()))
            .with("chunk_shape", json::list(self.grid.block.clone()))
    }

    /// Reads a plan from its JSON; the error is the reason why it is not one.
    pub(crate) fn read(written: &Value) -> Result<Self, String> {
        let format = written["format"].as_u64();
        if format != Some(FORMAT) {
            let actual = format.map_or("none".to_owned(), |format| format.to_string());
            return Err(format!("its format is {actual}, and this program knows format {FORMAT}"));
        }
        read_plan(written).ok_or_else(|| "it is not the plan of a sweep".to_owned())
    }

    /// The difference from another plan of the same format, in words.
    pub(crate) fn difference(&self, other: &Self) -> Option<String> {
        let name = |axis: &Axis| axis.name.clone();
        let names = |plan: &Self| plan.axes.iter().map(name).collect::<Vec<_>>().join(", ");
        let fields = |plan: &Self| {
            plan.kept.iter().map(|field| field.kept.path.clone()).collect::<Vec<_>>().join(", ")
        };
        if self.template != other.template {
            return Some(format!("its command is `{}`", self.template.0.join(" ")));
        }
        if names(self) != names(other) {
            return Some(format!("its axes are {}", names(self)));
        }
        if let Some((axis, _)) = self.axes.iter().zip(&other.axes).find(|(axis, other)| axis != other) {
            return Some(format!("its axis {} has other values", axis.name));
        }
        if self.kept != other.kept {
            return Some(format!("it keeps {}", fields(self)));
        }
        (self.grid != other.grid)
            .then(|| format!("its chunks have {} points", self.grid.block.iter().product::<usize>()))
    }

    /// The numbers kept of one result.
    pub(crate) fn numbers(&self, answer: &Value) -> Vec<f64> {
        self.kept.iter().flat_map(|field| field.kept.numbers(answer)).collect()
    }

    /// The names of these numbers.
    pub(crate) fn columns(&self) -> Vec<String> {
        self.kept.iter().flat_map(|field| field.kept.columns()).collect()
    }

    /// The words of the question at a point.
    pub(crate) fn words(&self, point: usize) -> Vec<String> {
        self.template.at(&self.axes, &self.grid.indices_of(point))
    }
}

fn read_plan(written: &Value) -> Option<Plan> {
    let texts = |value: &Value| -> Option<Vec<String>> {
        value.as_array()?.iter().map(|text| text.as_str().map(str::to_owned)).collect()
    };
    let counts = |value: &Value| -> Option<Vec<usize>> {
        value
            .as_array()?
            .iter()
            .map(|length| usize::try_from(length.as_u64()?).ok().filter(|count| *count > 0))
            .collect()
    };
    let axis = |value: &Value| Axis::of_words(value["name"].as_str()?, texts(&value["values"])?).ok();
    let field = |value: &Value| {
        let kept = Kept::read(&format!("{}={}", value["name"].as_str()?, value["path"].as_str()?)).ok()?;
        let (unit, meaning) = (value["unit"].as_str()?.to_owned(), value["meaning"].as_str()?.to_owned());
        Some(KeptField { kept, unit, meaning })
    };
    let axes: Vec<Axis> = written["axes"].as_array()?.iter().map(axis).collect::<Option<_>>()?;
    let kept = written["fields"].as_array()?.iter().map(field).collect::<Option<_>>()?;
    let grid = Grid { shape: counts(&written["shape"])?, block: counts(&written["chunk_shape"])? };
    let lengths: Vec<usize> = axes.iter().map(|axis| axis.values.len()).collect();
    (grid.shape == lengths && grid.block.len() == lengths.len()).then_some(())?;
    Some(Plan { template: Template(texts(&written["question"])?), axes, kept, grid })
}

/// The first result that some points of the grid have.
fn first_answer(template: &Template, axes: &[Axis], grid: &Grid) -> Result<Value, QueryError> {
    let mut first = None;
    for point in grid.scattered() {
        match point::answer(&template.at(axes, &grid.indices_of(point))) {
            Ok(answer) => return Ok(answer),
            Err(failure) if failure.is_cancelled() => return Err(failure),
            Err(failure) => drop(first.get_or_insert(failure)),
        }
    }
    Err(first.unwrap_or_else(|| QueryError::failed("the sweep has no points")))
}

/// All numbers outside lists; if there are none, paths into the lists must be chosen. A null field counts as a number if it has a unit, otherwise
/// as a word.
fn all_numbers(descriptions: &[Description], answer: &Value) -> Result<Vec<Kept>, QueryError> {
    let is_number = |kept: &Kept| {
        let is_null = kept.numbers(answer).iter().all(|number| number.is_nan());
        description_of(descriptions, kept).is_some_and(|description| !is_null || !description.unit.is_empty())
    };
    let alone = kept::scalars(answer).into_iter().filter_map(|way| Kept::read(&way).ok());
    let alone: Vec<Kept> = alone.filter(is_number).collect();
    if !alone.is_empty() {
        return Ok(alone);
    }
    let in_lists = descriptions
        .iter()
        .filter(|description| !description.unit.is_empty() && description.name.contains("[]"));
    let ways: Vec<String> = in_lists.map(|list| list.name.replace("[]", "[0]")).take(3).collect();
    let reason = format!(
        "all numbers of these results stand in lists: choose those to keep, such as {}",
        ways.join(", ")
    );
    Err(QueryError::usage(option("keep"), reason))
}

fn chosen(keep: &[String], answer: &Value) -> Result<Vec<Kept>, QueryError> {
    let refused = |reason: String| QueryError::usage(option("keep"), reason);
    let kept: Vec<Kept> =
        keep.iter().map(|text| Kept::read(text).map_err(refused)).collect::<Result<_, _>>()?;
    match kept.iter().find(|kept| !kept.is_in(answer)) {
        Some(missing) => {
            let lists = "lists that `libration fields` describes".to_owned();
            let what: Vec<String> = kept::scalars(answer).into_iter().chain([lists]).collect();
            let reason = format!("the results have no `{}`: they have {}", missing.path, what.join(", "));
            Err(QueryError::usage(option("keep"), reason))
        }
        None => Ok(kept),
    }
}

/// Gives fields their whole path as a name if the short one is taken by an earlier number, an axis, or the columns of the sweep itself.
fn named_apart(kept: Vec<Kept>, axes: &[Axis]) -> Vec<Kept> {
    let mut taken: Vec<String> = axes.iter().map(|axis| axis.name.clone()).collect();
    taken.extend(BESIDE.map(str::to_owned));
    let apart = |kept: Kept| {
        let is_taken = |name: &str| taken.iter().any(|other| other == name);
        let kept = if is_taken(&kept.name) { kept.named(str::to_owned) } else { kept };
        let kept = if is_taken(&kept.name) { kept.named(|path| format!("answer.{path}")) } else { kept };
        taken.push(kept.name.clone());
        kept
    };
    kept.into_iter().map(apart).collect()
}

fn described(descriptions: &[Description], kept: Kept) -> KeptField {
    let (unit, meaning) = description_of(descriptions, &kept)
        .map_or(("", ""), |description| (description.unit, description.meaning));
    KeptField { kept, unit: unit.to_owned(), meaning: meaning.to_owned() }
}

fn description_of<'a>(descriptions: &'a [Description], kept: &Kept) -> Option<&'a Description> {
    let way = kept.described_as();
    descriptions.iter().find(|description| describes(description, &way))
}

/// Returns `true` if a description is that of the field at a path; capitals match any name.
fn describes(description: &Description, way: &str) -> bool {
    let (described, way): (Vec<&str>, Vec<&str>) =
        (description.name.split('.').collect(), way.split('.').collect());
    let is_open = |name: &str| ["NAME", "KEY", "TOLERANCE", "K"].contains(&name.trim_end_matches("[]"));
    described.len() == way.len()
        && described.iter().zip(&way).all(|(part, name)| part == name || is_open(part))
}
