//! Types of parameters, from the types that clap reads their values into.

use super::fit_trace::DampingChoice;
use super::plan::Choices;
use super::sweep::{Axis, shard::Shard};
use crate::arguments::{
    AngleList, AngleSet, CoordinateName, EquationText, ParameterRange, ParameterSpan, RowBound, Times,
    Tolerances,
};
use crate::figure::layout::PictureSide;
use clap::Arg;
use libration::comparison::SeriesQuantity;
use libration::continuation::ResonanceOrder;
use libration::decay::PowerLawTerm;
use libration::expression::Expression;
use libration::pendulum::ApproximateMotion;
use libration::period_formulas::PeriodFormula;
use libration::perturbation::Gauge;
use libration::quantity::{Angle, Displacement, Quantity};
use libration_derivation::paper::{Document, StatementVerdict};
use libration_lab::fit::{Bob, Correlation};
use libration_lab::measurement::{Column, Header, Unit};
use std::any::TypeId;
use std::path::PathBuf;

/// The type of a parameter's value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterType {
    /// No value: a flag.
    Flag,
    /// One of [`ParameterDescription::choices`](crate::ParameterDescription::choices).
    Choice,
    /// A whole number.
    Integer,
    /// A number, in SI units or with its unit.
    Number,
    /// A number with its unit, where it has one, and its uncertainty.
    Quantity,
    /// An angle, or the amplitude of an oscillator.
    Angle,
    /// Several numbers or angles: a list or a range.
    Numbers,
    /// The key of an oscillator or a system, or equations.
    Equation,
    /// The name of a coordinate or of another state component.
    Coordinate,
    /// A formula of the state.
    Formula,
    /// A parameter with its range or values: `NAME=FROM:TO`.
    Range,
    /// A file or a directory.
    File,
    /// A column, line or sheet of a table, by its number or name.
    Column,
    /// A key, or another short text with its own notation.
    Key,
    /// Other text, whose notation the type does not describe.
    Text,
}

impl ParameterType {
    /// The name of the type for front ends in other languages: `integer`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Flag => "flag",
            Self::Choice => "choice",
            Self::Integer => "integer",
            Self::Number => "number",
            Self::Quantity => "quantity",
            Self::Angle => "angle",
            Self::Numbers => "numbers",
            Self::Equation => "equation",
            Self::Coordinate => "coordinate",
            Self::Formula => "formula",
            Self::Range => "range",
            Self::File => "file",
            Self::Column => "column",
            Self::Key => "key",
            Self::Text => "text",
        }
    }

    /// The type of an argument; `Text` where its type has no entry here.
    pub(crate) fn of(arg: &Arg) -> Self {
        if !arg.get_action().takes_values() {
            return Self::Flag;
        }
        if !arg.get_possible_values().is_empty() {
            return Self::Choice;
        }
        let id = arg.get_value_parser().type_id();
        let entry = entries().into_iter().find(|(_, types)| types.iter().any(|kind| id == *kind));
        entry.map_or(Self::Text, |(of, _)| of)
    }
}

fn entries() -> [(ParameterType, Vec<TypeId>); 12] {
    [
        (ParameterType::Integer, vec![id::<u64>(), id::<usize>(), id::<i32>()]),
        (
            ParameterType::Number,
            vec![id::<f64>(), id::<RowBound>(), id::<Tolerances>(), id::<ResonanceOrder>()],
        ),
        (ParameterType::Quantity, vec![id::<Quantity>(), id::<PictureSide>()]),
        (ParameterType::Angle, vec![id::<Angle>(), id::<Displacement>()]),
        (
            ParameterType::Numbers,
            vec![id::<AngleSet>(), id::<AngleList>(), id::<Choices>(), id::<Times>(), id::<(f64, f64)>()],
        ),
        (ParameterType::Equation, vec![id::<EquationText>()]),
        (ParameterType::Coordinate, vec![id::<CoordinateName>()]),
        (ParameterType::Formula, vec![id::<Expression>()]),
        (
            ParameterType::Range,
            vec![id::<ParameterRange>(), id::<ParameterSpan>(), id::<[ParameterSpan; 2]>(), id::<Axis>()],
        ),
        (ParameterType::File, vec![id::<PathBuf>()]),
        (ParameterType::Column, vec![id::<Column>(), id::<Header>()]),
        (ParameterType::Key, keys()),
    ]
}

fn keys() -> Vec<TypeId> {
    vec![
        id::<PeriodFormula>(),
        id::<ApproximateMotion>(),
        id::<SeriesQuantity>(),
        id::<Gauge>(),
        id::<DampingChoice>(),
        id::<PowerLawTerm>(),
        id::<Bob>(),
        id::<Correlation>(),
        id::<Document>(),
        id::<StatementVerdict>(),
        id::<Unit>(),
        id::<Shard>(),
    ]
}

fn id<T: 'static>() -> TypeId {
    TypeId::of::<T>()
}
