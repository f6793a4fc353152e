//! What is said of a response, its branches, their points and special points.

use super::{Answer, Decimal};
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::{at_most, short};
use libration::algebra::Complex;
use libration::continuation::{
    Branch, BranchPoint, Ending, Jump, OrderAnswers, OrderFinding, Origin, SpecialPoint, SweepPoint,
};
use serde_json::Value;

/// A branch of an answer, with its number from 1.
pub(super) struct Numbered<'a> {
    pub(super) answer: &'a Answer,
    pub(super) number: usize,
    pub(super) branch: &'a Branch,
}

/// A jump of a slow sweep.
pub(super) struct Jumping<'a> {
    pub(super) answer: &'a Answer,
    pub(super) jump: &'a Jump,
}

/// Where a slow sweep leads at one value.
pub(super) struct Swept<'a> {
    pub(super) answer: &'a Answer,
    pub(super) rising: bool,
    pub(super) point: &'a SweepPoint,
}

/// A line of CSV.
pub(super) enum Row<'a> {
    Place(Place<'a>),
    Swept(Swept<'a>),
}

/// A point of a branch, or a special one.
pub(super) struct Place<'a> {
    pub(super) of: &'a Numbered<'a>,
    pub(super) point: &'a BranchPoint,
    pub(super) special: Option<&'a SpecialPoint>,
    /// The parameter there, where more digits were asked for.
    pub(super) precise: Option<&'a Decimal>,
}

impl Answer {
    pub(super) fn numbered(&self) -> impl Iterator<Item = Numbered<'_>> {
        let numbered = (1..).zip(self.branches());
        numbered.map(move |(number, branch)| Numbered { answer: self, number, branch })
    }

    pub(super) fn jumps(&self) -> impl Iterator<Item = Jumping<'_>> {
        self.response.jumps.iter().map(|jump| Jumping { answer: self, jump })
    }

    pub(super) fn swept(&self) -> impl Iterator<Item = Swept<'_>> {
        self.sweeps.iter().flat_map(|sweep| {
            sweep.points.iter().map(|point| Swept { answer: self, rising: sweep.rising, point })
        })
    }

    /// The amplitude of the coordinate that is meant.
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

impl<'a> Numbered<'a> {
    pub(super) fn points(&'a self) -> impl Iterator<Item = Place<'a>> {
        self.branch.points.iter().map(move |point| Place { of: self, point, special: None, precise: None })
    }

    pub(super) fn special(&'a self) -> impl Iterator<Item = Place<'a>> {
        let precise = self.answer.precise.get(self.number - 1);
        let special = self.branch.special.iter().enumerate();
        special.map(move |(place, special)| Place {
            of: self,
            point: &special.point,
            special: Some(special),
            precise: precise.and_then(|all| all.get(place)?.as_ref()),
        })
    }

    /// Points and special points in their order.
    pub(super) fn places(&'a self) -> Vec<Place<'a>> {
        let mut places: Vec<(usize, Place<'a>)> =
            self.points().enumerate().map(|(k, it)| (2 * k + 1, it)).collect();
        places.extend(self.branch.special.iter().map(|it| 2 * it.before).zip(self.special()));
        places.sort_by_key(|(order, _)| *order);
        places.into_iter().map(|(_, place)| place).collect()
    }
}

impl Jumping<'_> {
    fn of_landings(&self, value: fn(&Answer, &BranchPoint) -> f64) -> Value {
        json::numbers(&self.jump.to.iter().map(|point| value(self.answer, point)).collect::<Vec<_>>())
    }
}

impl Swept<'_> {
    fn direction(&self) -> &'static str {
        direction(self.rising)
    }

    fn amplitude(&self) -> f64 {
        self.point.amplitude(self.answer.coordinate, self.answer.is_angle()).unwrap_or(f64::NAN)
    }
}

impl Row<'_> {
    fn place(&self) -> Option<&Place<'_>> {
        match self {
            Self::Place(place) => Some(place),
            Self::Swept(_) => None,
        }
    }

    fn amplitude(&self) -> f64 {
        match self {
            Self::Place(place) => place.amplitude(),
            Self::Swept(swept) => swept.amplitude(),
        }
    }
}

/// Of a sweep, for machines.
fn direction(rising: bool) -> &'static str {
    if rising { "up" } else { "down" }
}

impl Place<'_> {
    /// The parameter to the digits that were asked for.
    pub(super) fn digits_text(&self) -> Option<String> {
        let (precise, special) = (self.precise?, self.special?);
        let name = &self.of.answer.parameter;
        Some(format!(
            "{} on branch {}: {name} = {} to {}",
            special.kind,
            self.of.number,
            precise.text,
            at_most(precise.error)
        ))
    }

    fn amplitude(&self) -> f64 {
        self.of.answer.amplitude(self.point)
    }

    fn range(&self) -> [f64; 2] {
        self.point.ranges[self.of.answer.coordinate]
    }
}

pub(super) fn of_answer() -> Fields<Answer> {
    type Of = Field<Answer>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |it| {
            it.model.key().into()
        })
        .line_of("system", |it| it.model.title().to_owned()),
        Of::value("equation", "", "equations of motion as they were understood", |it| {
            it.model.equation().to_string().into()
        })
        .line_of("equation", |it| it.model.equation().to_string()),
        Of::value("parameter", "", "name of the parameter", |it| it.parameter.as_str().into()),
        Of::value("range[]", "", "its values at both ends", |it| json::numbers(&it.range))
            .line_of("over", |it| {
                format!("{} from {} to {}", it.parameter, short(it.range[0], 10), short(it.range[1], 10))
            }),
        Of::value("coordinate", "", "coordinate whose amplitude is meant", |it| {
            it.model.coordinates()[it.coordinate].name.as_str().into()
        }),
        Of::value("state[]", "", "names of the state variables", |it| json::list(it.model.state_names())),
        Of::value("interrupted", "", "whether Ctrl-C ended the work", |it| it.response.interrupted.into()),
        Of::nested("orders[].", &of_order(), |it| {
            json::records(it.response.orders.iter().map(|order| of_order().record(order)))
        }),
        Of::nested("jumps[].", &of_jump(), |it| {
            json::records(it.jumps().map(|jump| of_jump().record(&jump)))
        }),
        Of::nested("sweeps[].", &of_swept(), |it| {
            json::records(it.swept().map(|swept| of_swept().record(&swept)))
        }),
    ])
}

/// Where slow sweeps lead.
pub(super) fn of_swept<'a>() -> Fields<Swept<'a>> {
    type Of<'a> = Field<Swept<'a>>;
    Fields::from([
        Of::value("direction", "", "up or down: how the parameter goes in this sweep by integration", |it| {
            it.direction().into()
        })
        .words("sweep", |it| it.direction().to_owned()),
        Of::number("parameter", "", "value of the parameter", |it| it.point.parameter)
            .rounded("parameter", 10),
        Of::number(
            "amplitude_max",
            "",
            "amplitude of the motion that is settled there; null where it goes over the top again and again without repeating itself",
            Swept::amplitude,
        )
        .rounded("amplitude", 8),
        Of::value(
            "drive_periods",
            "1",
            "periods of the drive after which it repeats itself to a millionth; null where it does not",
            |it| it.point.drive_periods.into(),
        )
        .numeral("periods", |it| it.point.drive_periods.map_or_else(|| "-".to_owned(), |it| it.to_string())),
        Of::value("turns", "1", "turns that the coordinate makes meanwhile", |it| {
            it.point.rotation.map_or(0, |rotation| rotation.turns_of(it.answer.coordinate)).into()
        }),
    ])
}

/// What the search for answers of an order came to.
fn of_order() -> Fields<OrderAnswers> {
    type Of = Field<OrderAnswers>;
    Fields::from([
        Of::value("order", "", "oscillations over periods of the drive, such as 1/3", |it| {
            it.order.to_string().into()
        }),
        Of::value("branches", "1", "how many branches were found from free oscillations", |it| {
            it.branches.into()
        }),
        Of::value(
            "finding",
            "",
            "how far the search came: no_oscillation, no_work, too_weak, not_reached or found",
            |it| finding(it.finding).into(),
        ),
        Of::value(
            "share",
            "1",
            "where too weak: the part of what the damping takes that the drive gives at most, to the first order; else null",
            |it| match it.finding {
                OrderFinding::TooWeak(share) => json::number(share),
                _ => Value::Null,
            },
        ),
    ])
}

fn of_jump<'a>() -> Fields<Jumping<'a>> {
    type Of<'a> = Field<Jumping<'a>>;
    Fields::from([
        Of::number("parameter", "", "value at which a slow sweep jumps", |it| it.jump.from.parameter),
        Of::value("sweep", "", "up or down: how the parameter goes", |it| direction(it.jump.rising).into()),
        Of::number("from", "", "amplitude that is left", |it| it.answer.amplitude(&it.jump.from)),
        Of::value("to[]", "", "amplitudes of the other stable answers there", |it| {
            it.of_landings(Answer::amplitude)
        }),
        Of::value("to_error[]", "", "the states of these answers may be wrong by so much", |it| {
            it.of_landings(|_, point| point.error)
        }),
    ])
}

pub(super) fn of_branch<'a>() -> Fields<Numbered<'a>> {
    type Of<'a> = Field<Numbered<'a>>;
    Fields::from([
        Of::value(
            "kind",
            "",
            "where it comes from: primary, from an end of the range; free_oscillation; symmetry_breaking; period_doubling",
            |it| origin(it.branch.origin)[0].into(),
        ),
        Of::value("closed", "", "whether it comes back to its beginning", |it| {
            (it.branch.ending == Ending::Closed).into()
        }),
        Of::value("symmetric", "", "whether the mirror image half a period later is the same motion", |it| {
            it.branch.space.mirrored.into()
        }),
        Of::value(
            "drive_periods",
            "1",
            "periods of the drive in one of the answer; without a drive, turns of the first coordinate",
            |it| it.branch.space.drive_periods().into(),
        ),
        Of::value(
            "turns",
            "1",
            "whole turns that the coordinate makes in an answer; zero where it oscillates",
            |it| it.answer.turns(it.branch).into(),
        ),
        Of::value(
            "ending",
            "",
            "why it ends: range_end, closed, branch_point, rest, slow_drive, point_limit, lost or interrupted",
            |it| ending(it.branch.ending)[0].into(),
        ),
        Of::value("beginning", "", "why it does not go on before its first point, in the same words", |it| {
            ending(it.branch.beginning)[0].into()
        }),
        Of::nested("points[].", &of_place(), |it| {
            json::records(it.points().map(|place| of_place().record(&place)))
        }),
        Of::nested("special[].", &of_special(), |it| {
            json::records(it.special().map(|place| of_special().record(&place)))
        }),
    ])
}

fn of_place<'a>() -> Fields<Place<'a>> {
    type Of<'a> = Field<Place<'a>>;
    Fields::from([
        Of::number("parameter", "", "value of the parameter", |it| it.point.parameter),
        Of::number(
            "amplitude_max",
            "",
            "largest displacement, of angles from the nearest bottom, in rad; of rotating ones half of what they depart from an even rotation",
            Place::amplitude,
        ),
        Of::number(
            "minimum",
            "",
            "least value of the coordinate; where it rotates, of what it is ahead of an even rotation from t = 0 on",
            |it| it.range()[0],
        ),
        Of::number("maximum", "", "greatest value, likewise", |it| it.range()[1]),
        Of::number("period_s", "s", "period of the answer", |it| it.point.period),
        Of::value("stable", "", "whether no deviation grows", |it| it.point.stable.into()),
        Of::value(
            "multipliers[][]",
            "1",
            "Floquet multipliers of the whole period by descending magnitude, real and imaginary part; below 1e-13 of the first they are rounding",
            |it| json::list(it.point.multipliers.iter().map(pair)),
        ),
        Of::number(
            "error",
            "",
            "the state may be wrong by so much: what another tolerance and rounding change",
            |it| it.point.error,
        ),
        Of::value(
            "start[]",
            "",
            "state at the phase zero of the drive, in the order of the names; without a drive at a turn of the first coordinate",
            |it| json::numbers(&it.point.state),
        ),
    ])
}

/// A special point, whose error is that of its parameter.
pub(super) fn of_special<'a>() -> Fields<Place<'a>> {
    type Of<'a> = Field<Place<'a>>;
    Fields::from([
        Of::value(
            "kind",
            "",
            "fold, symmetry_breaking, period_doubling, neimark_sacker, neutral_saddle, branch_point or hopf",
            |it| it.special.map(|special| special.kind.key()).into(),
        )
        .words("special point", |it| it.special.map_or_else(String::new, |special| special.kind.to_string())),
        Of::value("branch", "1", "number of its branch, from 1", |it| it.of.number.into())
            .numeral("branch", |it| it.of.number.to_string()),
        Of::number("parameter", "", "value of the parameter there", |it| it.point.parameter)
            .rounded("parameter", 16),
        Of::number("error", "", "bound on the error of that value", |it| {
            it.special.map_or(f64::NAN, |it| it.error)
        })
        .numeral("to", |it| at_most(it.special.map_or(f64::NAN, |it| it.error))),
        Of::value(
            "parameter_digits",
            "",
            "the value to the digits that --digits asks for, as text; null where none are asked for or known",
            |it| it.precise.map(|it| it.text.clone()).into(),
        ),
        Of::value("parameter_digits_error", "", "bound on the error of this text", |it| {
            it.precise.map_or(Value::Null, |it| json::number(it.error))
        }),
        Of::number("amplitude_max", "", "largest displacement there", Place::amplitude)
            .rounded("amplitude", 8),
        Of::number("period_s", "s", "period of the answer there", |it| it.point.period),
        Of::value("multipliers[][]", "1", "Floquet multipliers there", |it| {
            json::list(it.point.multipliers.iter().map(pair))
        }),
        Of::value("start[]", "", "state at the phase zero of the drive there", |it| {
            json::numbers(&it.point.state)
        }),
    ])
}

/// A line of CSV: a point, a special one, or one of a sweep.
pub(super) fn of_row<'a>() -> Fields<Row<'a>> {
    type Of<'a> = Field<Row<'a>>;
    Fields::from([
        Of::value("branch", "1", "number of the branch, from 1; empty for what a sweep leads to", |it| {
            it.place().map(|it| it.of.number).into()
        }),
        Of::value("special", "", "kind of special point, empty for other points", |it| {
            it.place().and_then(|it| it.special).map_or("", |special| special.kind.key()).into()
        }),
        Of::number("parameter", "", "value of the parameter", |it| match it {
            Row::Place(place) => place.point.parameter,
            Row::Swept(swept) => swept.point.parameter,
        }),
        Of::number(
            "amplitude_max",
            "",
            "largest displacement, of angles from the nearest bottom, in rad; of rotating ones half of what they depart from an even rotation",
            Row::amplitude,
        ),
        Of::value("period_s", "s", "period of the answer; empty for what a sweep leads to", |it| {
            it.place().map_or(Value::Null, |it| json::number(it.point.period))
        }),
        Of::value("stable", "", "whether no deviation grows; empty for what a sweep leads to", |it| {
            it.place().map(|it| it.point.stable).into()
        }),
        Of::value(
            "error",
            "",
            "error of the state, of special points that of the parameter; empty for what a sweep leads to",
            |it| {
                it.place().map_or(Value::Null, |it| {
                    json::number(it.special.map_or(it.point.error, |special| special.error))
                })
            },
        ),
        Of::value("sweep", "", "up or down, where a slow sweep leads; empty for points of branches", |it| {
            match it {
                Row::Place(_) => "".into(),
                Row::Swept(swept) => swept.direction().into(),
            }
        }),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [of_answer().described(""), of_branch().described("branches[].")].concat();
    vec![Answers { command: "response", option: "", json, csv: of_row().described_in_csv() }]
}

/// For machines, and for people.
pub(super) fn origin(origin: Origin) -> [&'static str; 2] {
    match origin {
        Origin::Primary => ["primary", "from an end of the range"],
        Origin::FreeOscillation => ["free_oscillation", "from a free oscillation"],
        Origin::SymmetryBreaking => ["symmetry_breaking", "from a loss of symmetry"],
        Origin::PeriodDoubling => ["period_doubling", "from a period doubling"],
    }
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

pub(super) fn ending(ending: Ending) -> [&'static str; 2] {
    match ending {
        Ending::RangeEnd => ["range_end", "leaves the range"],
        Ending::Closed => ["closed", "is a closed curve"],
        Ending::BranchPoint => ["branch_point", "ends in another branch"],
        Ending::Rest => ["rest", "ends in a state of rest"],
        Ending::SlowDrive => ["slow_drive", "goes on to the frequency zero"],
        Ending::PointLimit => ["point_limit", "ends at the largest number of points"],
        Ending::Lost => ["lost", "cannot be followed farther"],
        Ending::Interrupted => ["interrupted", "is interrupted"],
    }
}

fn pair(number: &Complex) -> Value {
    json::numbers(&[number.re, number.im])
}
