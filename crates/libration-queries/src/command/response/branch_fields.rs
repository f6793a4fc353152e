//! Fields of branches, their points and special points.

use super::{Decimal, ResponseResult};
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::{at_most, to_its_error};
use libration::algebra::Complex;
use libration::continuation::{Branch, BranchPoint, Ending, Origin, SpecialPoint};
use libration::internals::InOrder;
use serde_json::Value;

/// A branch of a response, with its number from 1.
pub(super) struct NumberedBranch<'a> {
    pub(super) answer: &'a ResponseResult,
    pub(super) number: usize,
    pub(super) branch: &'a Branch,
}

/// A point of a branch, or a special one.
pub(super) struct PointOfBranch<'a> {
    pub(super) of: &'a NumberedBranch<'a>,
    pub(super) point: &'a BranchPoint,
    pub(super) special: Option<&'a SpecialPoint>,
    /// The parameter there, where more digits were requested.
    pub(super) precise: Option<&'a Decimal>,
}

impl ResponseResult {
    pub(super) fn numbered(&self) -> impl Iterator<Item = NumberedBranch<'_>> {
        let numbered = (1..).zip(self.branches());
        numbered.map(move |(number, branch)| NumberedBranch { answer: self, number, branch })
    }
}

impl<'a> NumberedBranch<'a> {
    pub(super) fn points(&'a self) -> impl Iterator<Item = PointOfBranch<'a>> {
        self.branch.points.iter().map(move |point| PointOfBranch {
            of: self,
            point,
            special: None,
            precise: None,
        })
    }

    pub(super) fn special(&'a self) -> impl Iterator<Item = PointOfBranch<'a>> {
        let precise = self.answer.precise.get(self.number - 1);
        let special = self.branch.special.iter().enumerate();
        special.map(move |(index, special)| PointOfBranch {
            of: self,
            point: &special.point,
            special: Some(special),
            precise: precise.and_then(|all| all.get(index)?.as_ref()),
        })
    }

    /// Points and special points in their order.
    pub(super) fn places(&'a self) -> Vec<PointOfBranch<'a>> {
        let mut points: Vec<(usize, PointOfBranch<'a>)> =
            self.points().enumerate().map(|(k, point)| (2 * k + 1, point)).collect();
        points.extend(self.branch.special.iter().map(|special| 2 * special.before).zip(self.special()));
        points.put_in_order_by(|(order, _)| *order);
        points.into_iter().map(|(_, point)| point).collect()
    }
}

impl PointOfBranch<'_> {
    /// The parameter to the digits that were requested.
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

    pub(super) fn amplitude(&self) -> f64 {
        self.of.answer.amplitude(self.point)
    }

    fn range(&self) -> [f64; 2] {
        self.point.ranges[self.of.answer.coordinate]
    }
}

pub(super) fn of_branch<'a>() -> Fields<NumberedBranch<'a>> {
    type Of<'a> = Field<NumberedBranch<'a>>;
    Fields::from([
        Of::value(
            "kind",
            "",
            "origin of the branch: primary, at an end of the range; free_oscillation; symmetry_breaking; period_doubling; meeting, at the end of \
             another branch; within, at a value within the range; jump, beyond a fold of another branch",
            |branch| origin(branch.branch.origin)[0].into(),
        ),
        Of::value("closed", "", "true if it is a closed curve", |branch| {
            (branch.branch.ending == Ending::Closed).into()
        }),
        Of::value(
            "symmetric",
            "",
            "true if the mirror image half a period later is the same motion",
            |branch| branch.branch.space.mirrored.into(),
        ),
        Of::value(
            "drive_periods",
            "1",
            "periods of the drive in one period of the solution; without a drive, turns of the first coordinate",
            |branch| branch.branch.space.drive_periods().into(),
        ),
        Of::value(
            "turns",
            "1",
            "whole turns of the coordinate in one period; zero where it oscillates",
            |branch| branch.answer.turns(branch.branch).into(),
        ),
        Of::value(
            "ending",
            "",
            "reason why it ends after its last point: range_end, closed, branch_point, rest, slow_drive, infinite_period, unbounded, sensitive, point_limit, lost or interrupted",
            |branch| ending(branch.branch.ending)[0].into(),
        ),
        Of::value(
            "beginning",
            "",
            "reason why it ends before its first point, in the same words",
            |branch| ending(branch.branch.beginning)[0].into(),
        ),
        Of::value(
            "unresolved[][]",
            "",
            "ranges of the parameter in which further special points cannot be excluded, from the lower end to the upper",
            |branch| json::list(branch.branch.unresolved.iter().map(|range| json::numbers(range))),
        ),
        Of::nested("points[].", &of_place(), |branch| {
            json::records(branch.points().map(|point| of_place().record(&point)))
        }),
        Of::nested("special[].", &of_special(), |branch| {
            json::records(branch.special().map(|point| of_special().record(&point)))
        }),
    ])
}

fn of_place<'a>() -> Fields<PointOfBranch<'a>> {
    type Of<'a> = Field<PointOfBranch<'a>>;
    Fields::from([
        Of::number("parameter", "", "value of the parameter", |point| point.point.parameter),
        Of::number(
            "amplitude_max",
            "",
            "largest displacement, of angles from the nearest bottom, in rad; for rotating solutions, half the range of the deviation from uniform rotation",
            PointOfBranch::amplitude,
        ),
        Of::number(
            "minimum",
            "",
            "least value of the coordinate; where it rotates, of its lead over a uniform rotation from t = 0 on",
            |point| point.range()[0],
        ),
        Of::number("maximum", "", "greatest value, likewise", |point| point.range()[1]),
        Of::number("period_s", "s", "period of the solution", |point| point.point.period),
        Of::value(
            "stability",
            "",
            "attracting, neutral, unstable or undetermined (within the errors of the multipliers)",
            |point| point.point.stability.name().into(),
        ),
        Of::value(
            "multipliers[][]",
            "1",
            "Floquet multipliers of the whole period by descending magnitude, real and imaginary part; below 1e-13 of the first they are rounding",
            |point| json::list(point.point.multipliers.iter().map(pair)),
        ),
        Of::value("multiplier_errors[]", "1", "errors of the multipliers, in their order", |point| {
            json::numbers(&point.point.multiplier_errors)
        }),
        Of::number(
            "error",
            "",
            "error of the state, estimated from another tolerance and from rounding",
            |point| point.point.error,
        ),
        Of::value(
            "start[]",
            "",
            "state at the phase zero of the drive, in the order of the names; without a drive, at a turning point of the first coordinate",
            |point| json::numbers(&point.point.state),
        ),
    ])
}

/// A special point, whose error is that of its parameter.
pub(super) fn of_special<'a>() -> Fields<PointOfBranch<'a>> {
    type Of<'a> = Field<PointOfBranch<'a>>;
    Fields::from([
        Of::value(
            "kind",
            "",
            "fold, symmetry_breaking, period_doubling, neimark_sacker, neutral_saddle, branch_point or hopf",
            |point| point.special.map(|special| special.kind.key()).into(),
        )
        .words("special point", |point| {
            point.special.map_or_else(String::new, |special| special.kind.to_string())
        }),
        Of::value("branch", "1", "number of its branch, from 1", |point| point.of.number.into())
            .numeral("branch", |point| point.of.number.to_string()),
        Of::number("parameter", "", "value of the parameter there", |point| point.point.parameter).numeral(
            "parameter",
            |point| {
                to_its_error(point.point.parameter, point.special.map_or(0.0, |special| special.error), 16)
            },
        ),
        Of::number("error", "", "bound on the error of that value", |point| {
            point.special.map_or(f64::NAN, |special| special.error)
        })
        .numeral("to", |point| at_most(point.special.map_or(f64::NAN, |special| special.error))),
        Of::value(
            "parameter_digits",
            "",
            "the value to the digits of --digits, as text; null where none are requested or known",
            |point| point.precise.map(|precise| precise.text.clone()).into(),
        ),
        Of::value("parameter_digits_error", "", "bound on the error of this text", |point| {
            point.precise.map_or(Value::Null, |precise| json::number(precise.error))
        }),
        Of::number("amplitude_max", "", "largest displacement there", PointOfBranch::amplitude)
            .rounded("amplitude", 8),
        Of::number("period_s", "s", "period of the solution there", |point| point.point.period),
        Of::value("multipliers[][]", "1", "Floquet multipliers there", |point| {
            json::list(point.point.multipliers.iter().map(pair))
        }),
        Of::value("multiplier_errors[]", "1", "errors of these multipliers", |point| {
            json::numbers(&point.point.multiplier_errors)
        }),
        Of::value("start[]", "", "state at the phase zero of the drive there", |point| {
            json::numbers(&point.point.state)
        }),
    ])
}

/// The origin of a branch as a value of its field, and in words.
pub(super) fn origin(origin: Origin) -> [&'static str; 2] {
    match origin {
        Origin::Primary => ["primary", "from an end of the range"],
        Origin::FreeOscillation => ["free_oscillation", "from a free oscillation"],
        Origin::SymmetryBreaking => ["symmetry_breaking", "from a symmetry breaking"],
        Origin::PeriodDoubling => ["period_doubling", "from a period doubling"],
        Origin::Meeting => ["meeting", "through the end of another branch"],
        Origin::Within => ["within", "from within the range"],
        Origin::Jump => ["jump", "reached by a jump"],
    }
}

pub(super) fn ending(ending: Ending) -> [&'static str; 2] {
    match ending {
        Ending::RangeEnd => ["range_end", "leaves the range"],
        Ending::Closed => ["closed", "is a closed curve"],
        Ending::BranchPoint => ["branch_point", "ends in another branch"],
        Ending::Rest => ["rest", "ends at an equilibrium"],
        Ending::SlowDrive => ["slow_drive", "continues to zero frequency"],
        Ending::InfinitePeriod => ["infinite_period", "comes to an orbit of infinite period"],
        Ending::Unbounded => ["unbounded", "grows to a billion times its size"],
        Ending::Sensitive => [
            "sensitive",
            "is followed until deviations grow 1e6-fold in a period, or 1e3-fold from eight periods on,",
        ],
        Ending::PointLimit => ["point_limit", "ends at the largest number of points"],
        Ending::Lost => ["lost", "cannot be continued: the corrector fails at the minimum step"],
        Ending::Interrupted => ["interrupted", "is interrupted"],
    }
}

fn pair(number: &Complex) -> Value {
    json::numbers(&[number.re, number.im])
}
