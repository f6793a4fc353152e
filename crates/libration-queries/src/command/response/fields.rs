//! Fields of a response as a whole, and the lines of CSV.

use super::ResponseResult;
use super::branch_fields::{PointOfBranch, of_branch};
use super::sweep_fields::{Swept, of_jump, of_swept};
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::short;
use libration::continuation::{BranchError, BranchPoint, FreeOscillation, OrderAnswers, OrderFinding};
use serde_json::Value;

/// A line of CSV.
pub(super) enum ResponseRow<'a> {
    PointOfBranch(PointOfBranch<'a>),
    Swept(Swept<'a>),
}

impl ResponseResult {
    /// The amplitude of the chosen coordinate.
    pub(super) fn amplitude(&self, point: &BranchPoint) -> f64 {
        point.amplitude(self.coordinate, self.is_angle())
    }

    /// A value of the parameter as a sentence has it.
    pub(super) fn value_text(&self, value: f64) -> String {
        format!("{} = {}", self.parameter, short(value, 6))
    }

    /// An amplitude as a sentence has it.
    pub(super) fn amplitude_text(&self, amplitude: f64) -> String {
        match self.is_angle() {
            true => format!("{}°", short(amplitude.to_degrees(), 5)),
            false => short(amplitude, 5),
        }
    }
}

impl ResponseRow<'_> {
    fn point(&self) -> Option<&PointOfBranch<'_>> {
        match self {
            Self::PointOfBranch(point) => Some(point),
            Self::Swept(_) => None,
        }
    }

    fn amplitude(&self) -> f64 {
        match self {
            Self::PointOfBranch(point) => point.amplitude(),
            Self::Swept(swept) => swept.amplitude(),
        }
    }
}

pub(super) fn of_answer() -> Fields<ResponseResult> {
    type Of = Field<ResponseResult>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |result| {
            result.model.key().into()
        })
        .line_of("system", |result| result.model.title().to_owned()),
        Of::value("equation", "", "equations of motion as they were read", |result| {
            result.model.equation().to_string().into()
        })
        .line_of("equation", |result| result.model.equation().to_string()),
        Of::value("parameter", "", "name of the parameter", |result| result.parameter.as_str().into()),
        Of::value("range[]", "", "its values at both ends", |result| json::numbers(&result.range)).line_of(
            "over",
            |result| {
                format!(
                    "{} from {} to {}",
                    result.parameter,
                    short(result.range[0], 10),
                    short(result.range[1], 10)
                )
            },
        ),
        Of::value("coordinate", "", "coordinate of the amplitude", |result| {
            result.model.coordinates()[result.coordinate].name.as_str().into()
        }),
        Of::value("state[]", "", "names of the state variables", |result| {
            json::list(result.model.state_names())
        }),
        Of::value("interrupted", "", "true if Ctrl-C ended the work", |result| {
            result.response.interrupted.into()
        }),
        Of::nested("missing[].", &of_missing(), |result| {
            json::records(result.response.missing.iter().map(|missing| of_missing().record(missing)))
        }),
        Of::nested("orders[].", &of_order(), |result| {
            json::records(result.response.orders.iter().map(|order| of_order().record(order)))
        }),
        Of::nested("backbone[].", &of_backbone(), |result| {
            json::records(result.backbone.iter().map(|point| of_backbone().record(point)))
        }),
        Of::nested("jumps[].", &of_jump(), |result| {
            json::records(result.jumps().map(|jump| of_jump().record(&jump)))
        }),
        Of::nested("sweeps[].", &of_swept(), |result| {
            json::records(result.swept().map(|swept| of_swept().record(&swept)))
        }),
    ])
}

/// A free oscillation, which the resonance curve leans on.
fn of_backbone() -> Fields<FreeOscillation> {
    type Of = Field<FreeOscillation>;
    Fields::from([
        Of::number(
            "parameter",
            "",
            "frequency of the drive with which a free oscillation repeats itself; none where the parameter is not that frequency",
            |oscillation| oscillation.parameter,
        ),
        Of::number("error", "", "estimate of the error of the parameter", |oscillation| oscillation.error),
        Of::number("amplitude", "", "amplitude of the free oscillation, of angles in rad", |oscillation| {
            oscillation.amplitude
        }),
    ])
}

/// A value of the parameter at which no motion to begin with is found.
fn of_missing() -> Fields<(f64, BranchError)> {
    type Of = Field<(f64, BranchError)>;
    Fields::from([
        Of::number(
            "parameter",
            "",
            "value of the parameter at which no initial solution was found",
            |missing| missing.0,
        ),
        Of::value("reason", "", "reason, as a sentence", |missing| missing.1.to_string().into()),
    ])
}

/// The fields of the search for responses of an order.
fn of_order() -> Fields<OrderAnswers> {
    type Of = Field<OrderAnswers>;
    Fields::from([
        Of::value("order", "", "oscillations over periods of the drive, such as 1/3", |answers| {
            answers.order.to_string().into()
        }),
        Of::value("branches", "1", "number of branches found from free oscillations", |answers| {
            answers.branches.into()
        }),
        Of::value(
            "finding",
            "",
            "outcome of the search: no_oscillation, no_work, too_weak, not_reached or found",
            |answers| finding(answers.finding).into(),
        ),
        Of::value(
            "share",
            "1",
            "where too weak: the largest fraction of the energy lost to damping that the drive supplies, to first order; else null",
            |answers| match answers.finding {
                OrderFinding::TooWeak(share) => json::number(share),
                _ => Value::Null,
            },
        ),
    ])
}

/// A line of CSV: a point, a special one, or one of a sweep.
pub(super) fn of_row<'a>() -> Fields<ResponseRow<'a>> {
    type Of<'a> = Field<ResponseRow<'a>>;
    Fields::from([
        Of::value("branch", "1", "number of the branch, from 1; empty for rows of sweeps", |row| {
            row.point().map(|point| point.of.number).into()
        }),
        Of::value("special", "", "kind of special point, empty for other points", |row| {
            row.point().and_then(|point| point.special).map_or("", |special| special.kind.key()).into()
        }),
        Of::number("parameter", "", "value of the parameter", |row| match row {
            ResponseRow::PointOfBranch(point) => point.point.parameter,
            ResponseRow::Swept(swept) => swept.point.parameter,
        }),
        Of::number(
            "amplitude_max",
            "",
            "largest displacement, of angles from the nearest bottom, in rad; for rotating solutions, half the range of the deviation from uniform rotation",
            ResponseRow::amplitude,
        ),
        Of::value("period_s", "s", "period of the solution; empty for rows of sweeps", |row| {
            row.point().map_or(Value::Null, |point| json::number(point.point.period))
        }),
        Of::value(
            "stability",
            "",
            "attracting, neutral, unstable or undetermined (within the errors of the multipliers); empty for rows of sweeps",
            |row| row.point().map(|point| point.point.stability.name()).into(),
        ),
        Of::value(
            "error",
            "",
            "error of the state, of special points that of the parameter; empty for rows of sweeps",
            |row| {
                row.point().map_or(Value::Null, |point| {
                    json::number(point.special.map_or(point.point.error, |special| special.error))
                })
            },
        ),
        Of::value(
            "sweep",
            "",
            "up or down, for rows of sweeps; empty for points of branches",
            |row| match row {
                ResponseRow::PointOfBranch(_) => "".into(),
                ResponseRow::Swept(swept) => swept.direction().into(),
            },
        ),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [of_answer().described(""), of_branch().described("branches[].")].concat();
    vec![Answers { command: "response", option: "", json, csv: of_row().described_in_csv() }]
}

fn finding(finding: OrderFinding) -> &'static str {
    match finding {
        OrderFinding::NoOscillation => "no_oscillation",
        OrderFinding::NoWork => "no_work",
        OrderFinding::TooWeak(_) => "too_weak",
        OrderFinding::NotReached => "not_reached",
        OrderFinding::Found => "found",
    }
}
