//! Fields of a chart, its curves and their points.

use super::StabilityResult;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::{at_most, short, to_its_error};
use libration::algebra::Complex;
use libration::continuation::{CurvePoint, Ending, SpecialCurve};
use serde_json::Value;

/// A curve of the map, with its number from 1.
pub(super) struct NumberedBoundary<'a> {
    pub(super) answer: &'a StabilityResult,
    pub(super) number: usize,
    pub(super) curve: &'a SpecialCurve,
}

/// A point of a curve, or a cusp.
pub(super) struct PointOfCurve<'a> {
    of: &'a NumberedBoundary<'a>,
    point: &'a CurvePoint,
    is_cusp: bool,
}

/// The ranges of the second parameter in which the equilibrium is stable, at an end of the first parameter.
pub(super) struct AtEnd {
    pub(super) value: f64,
    pub(super) ranges: Vec<[f64; 2]>,
}

impl StabilityResult {
    /// The ranges at the least value of the first parameter and at its greatest; empty where the start is not an equilibrium.
    pub(super) fn rest_at_ends(&self) -> Vec<AtEnd> {
        let [from, to] = self.ranges[0];
        let ends = [from.min(to), from.max(to)].into_iter().enumerate();
        ends.filter_map(|(end, value)| Some(AtEnd { value, ranges: self.chart.rest_is_stable_at(end)? }))
            .collect()
    }

    pub(super) fn numbered(&self) -> impl Iterator<Item = NumberedBoundary<'_>> {
        let numbered = (1..).zip(&self.chart.curves);
        numbered.map(move |(number, curve)| NumberedBoundary { answer: self, number, curve })
    }

    /// Values of both parameters as a sentence has them.
    pub(super) fn values_text(&self, point: &CurvePoint) -> String {
        let [first, second] = &self.parameters;
        format!("{first} = {}, {second} = {}", short(point.point.parameter, 6), short(point.second, 6))
    }
}

impl<'a> NumberedBoundary<'a> {
    pub(super) fn points(&'a self) -> impl Iterator<Item = PointOfCurve<'a>> {
        self.curve.points.iter().map(move |point| PointOfCurve { of: self, point, is_cusp: false })
    }

    pub(super) fn cusps(&'a self) -> impl Iterator<Item = PointOfCurve<'a>> {
        self.curve.cusps.iter().map(move |point| PointOfCurve { of: self, point, is_cusp: true })
    }

    /// The first point and the last, and the cusps between them.
    pub(super) fn ends_and_cusps(&'a self) -> impl Iterator<Item = PointOfCurve<'a>> {
        let end = |point: &'a CurvePoint| PointOfCurve { of: self, point, is_cusp: false };
        let last = self.curve.points.last().filter(|_| self.curve.points.len() > 1);
        self.curve.points.first().into_iter().map(end).chain(self.cusps()).chain(last.into_iter().map(end))
    }
}

impl PointOfCurve<'_> {
    fn amplitude(&self) -> f64 {
        let is_angle =
            self.of.answer.model.coordinates().first().is_some_and(|coordinate| coordinate.is_angle());
        self.point.point.amplitude(0, is_angle)
    }

    fn values(&self) -> [f64; 2] {
        [self.point.point.parameter, self.point.second]
    }
}

pub(super) fn of_answer() -> Fields<StabilityResult> {
    type Of = Field<StabilityResult>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |result| {
            result.model.key().into()
        })
        .line_of("system", |result| result.model.title().to_owned()),
        Of::value("equation", "", "equations of motion as they were read", |result| {
            result.model.equation().to_string().into()
        })
        .line_of("equation", |result| result.model.equation().to_string()),
        Of::value("parameters[]", "", "names of the two parameters", |result| {
            json::list(result.parameters.clone())
        }),
        Of::value("ranges[][]", "", "both ends of their ranges", |result| {
            json::list(result.ranges.iter().map(|range| json::numbers(range)))
        })
        .line_of("map", |result| {
            let part = |(name, [from, to]): (&String, &[f64; 2])| {
                format!("{name} from {} to {}", short(*from, 10), short(*to, 10))
            };
            result.parameters.iter().zip(&result.ranges).map(part).collect::<Vec<_>>().join(", ")
        }),
        Of::value("state[]", "", "names of the state variables", |result| {
            json::list(result.model.state_names())
        }),
        Of::value(
            "rest_stable[][]",
            "",
            "true where the equilibrium is stable: a row for each value of the second parameter, a column for each of the first; null where this is not known, no rows where the start is not an equilibrium",
            |result| {
                let rows = result.chart.rest.iter().flat_map(|rest| &rest.stable);
                json::list(rows.map(|row| json::list(row.iter().copied())))
            },
        ),
        Of::value("grid[][]", "", "the values of both parameters at these", |result| {
            let values = result.chart.rest.iter().flat_map(|rest| &rest.values);
            json::list(values.map(|values| json::numbers(values)))
        }),
        Of::value(
            "unresolved[][]",
            "",
            "values of both parameters between neighbouring points of the grid of which one is stable and the other is not, although no boundary was followed between them",
            |result| {
                let points = result.chart.rest.iter().flat_map(|rest| &rest.unresolved);
                json::list(points.map(|point| json::numbers(point)))
            },
        ),
        Of::nested("rest_stable_at[].", &of_end(), |result| of_end().records(&result.rest_at_ends())),
        Of::value("interrupted", "", "true if Ctrl-C ended the work", |result| {
            result.chart.interrupted.into()
        }),
    ])
}

fn of_end() -> Fields<AtEnd> {
    type Of = Field<AtEnd>;
    Fields::from([
        Of::number("value", "", "an end of the range of the first parameter, the least value first", |end| {
            end.value
        }),
        Of::value(
            "ranges[][]",
            "",
            "ranges of the second parameter in which the equilibrium is stable there, between the ends of its stability boundaries",
            |end| json::list(end.ranges.iter().map(|range| json::numbers(range))),
        ),
    ])
}

pub(super) fn of_curve<'a>() -> Fields<NumberedBoundary<'a>> {
    type Of<'a> = Field<NumberedBoundary<'a>>;
    Fields::from([
        Of::value(
            "kind",
            "",
            "fold, symmetry_breaking, period_doubling, neimark_sacker, or branch_point where other solutions branch off the equilibrium",
            |boundary| boundary.curve.kind.key().into(),
        ),
        Of::value("at_rest", "", "true if the solution is the equilibrium", |boundary| {
            boundary.curve.at_rest.into()
        }),
        Of::value(
            "stability_boundary",
            "",
            "part of the curve on one side of which the solution is stable: whole, part, or none, where it is unstable on both sides",
            |boundary| boundary.curve.stability_boundary().key().into(),
        ),
        Of::value("closed", "", "true if it is a closed curve", |boundary| {
            (boundary.curve.endings[1] == Ending::Closed).into()
        }),
        Of::value("drive_periods", "1", "periods of the drive in one period of the solution", |boundary| {
            boundary.curve.space.drive_periods().into()
        }),
        Of::nested("points[].", &of_place(), |boundary| {
            json::records(boundary.points().map(|point| of_place().record(&point)))
        }),
        Of::nested("cusps[].", &of_place(), |boundary| {
            json::records(boundary.cusps().map(|cusp| of_place().record(&cusp)))
        }),
    ])
}

fn of_place<'a>() -> Fields<PointOfCurve<'a>> {
    type Of<'a> = Field<PointOfCurve<'a>>;
    Fields::from([
        Of::value("parameters[]", "", "values of both parameters", |point| json::numbers(&point.values())),
        Of::number("error", "", "bound on the error of the values across the curve", |point| {
            point.point.point.error
        }),
        Of::number(
            "amplitude_max",
            "",
            "largest displacement of the first coordinate, of angles from the nearest bottom, in rad",
            PointOfCurve::amplitude,
        ),
        Of::number("period_s", "s", "period of the solution", |point| point.point.point.period),
        Of::value(
            "multipliers[][]",
            "1",
            "Floquet multipliers of the whole period, real and imaginary part",
            |point| json::list(point.point.point.multipliers.iter().map(pair)),
        ),
        boundary(),
        Of::value("start[]", "", "state at the phase zero of the drive", |point| {
            json::numbers(&point.point.point.state)
        }),
    ])
}

/// A line of CSV, or of the table.
pub(super) fn of_row<'a>() -> Fields<PointOfCurve<'a>> {
    type Of<'a> = Field<PointOfCurve<'a>>;
    Fields::from([
        Of::value("curve", "1", "number of the curve, from 1", |point| point.of.number.into())
            .numeral("curve", |point| point.of.number.to_string()),
        Of::value("kind", "", "kind of singular point, or cusp", |point| point.kind().into())
            .words("kind", |point| point.kind().replace('_', " ")),
        Of::value("at_rest", "", "true if the solution is the equilibrium", |point| {
            point.of.curve.at_rest.into()
        }),
        Of::number("first", "", "value of the first parameter", |point| point.point.point.parameter)
            .numeral("first", |point| to_its_error(point.point.point.parameter, point.point.point.error, 14)),
        Of::number("second", "", "value of the second parameter", |point| point.point.second)
            .numeral("second", |point| to_its_error(point.point.second, point.point.point.error, 14)),
        Of::number("error", "", "bound on the error of the values across the curve", |point| {
            point.point.point.error
        })
        .numeral("to", |point| at_most(point.point.point.error)),
        Of::number(
            "amplitude_max",
            "",
            "largest displacement of the first coordinate",
            PointOfCurve::amplitude,
        )
        .rounded("amplitude", 8),
        boundary(),
    ])
}

fn boundary<'a>() -> Field<PointOfCurve<'a>> {
    Field::value(
        "boundary",
        "",
        "true if the solution is stable on one side of the curve there",
        |point: &PointOfCurve<'_>| point.point.bounds_stability().into(),
    )
}

impl PointOfCurve<'_> {
    fn kind(&self) -> &'static str {
        if self.is_cusp { "cusp" } else { self.of.curve.kind.key() }
    }
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [of_answer().described(""), of_curve().described("curves[].")].concat();
    vec![Answers { command: "stability", option: "", json, csv: of_row().described_in_csv() }]
}

fn pair(number: &Complex) -> Value {
    json::numbers(&[number.re, number.im])
}
