//! Fields of slow sweeps: their points and jumps.

use super::ResponseResult;
use crate::output::field::{Field, Fields};
use crate::output::json;
use libration::continuation::{BranchPoint, Jump, SweepPoint};
use serde_json::Value;

/// A jump of a slow sweep.
pub(super) struct Jumping<'a> {
    pub(super) answer: &'a ResponseResult,
    pub(super) jump: &'a Jump,
}

/// The point of a slow sweep at one value.
pub(super) struct Swept<'a> {
    pub(super) answer: &'a ResponseResult,
    pub(super) rising: bool,
    pub(super) point: &'a SweepPoint,
}

impl ResponseResult {
    pub(super) fn jumps(&self) -> impl Iterator<Item = Jumping<'_>> {
        self.response.jumps.iter().map(|jump| Jumping { answer: self, jump })
    }

    pub(super) fn swept(&self) -> impl Iterator<Item = Swept<'_>> {
        self.sweeps.iter().flat_map(|sweep| {
            sweep.points.iter().map(|point| Swept { answer: self, rising: sweep.rising, point })
        })
    }
}

impl Jumping<'_> {
    fn of_landings(&self, value: fn(&ResponseResult, &BranchPoint) -> f64) -> Value {
        json::numbers(&self.jump.to.iter().map(|point| value(self.answer, point)).collect::<Vec<_>>())
    }
}

impl Swept<'_> {
    pub(super) fn direction(&self) -> &'static str {
        direction(self.rising)
    }

    pub(super) fn amplitude(&self) -> f64 {
        self.point.amplitude(self.answer.coordinate, self.answer.is_angle()).unwrap_or(f64::NAN)
    }
}

/// The direction of a sweep, for machines.
fn direction(rising: bool) -> &'static str {
    if rising { "up" } else { "down" }
}

/// The fields of the points of slow sweeps.
pub(super) fn of_swept<'a>() -> Fields<Swept<'a>> {
    type Of<'a> = Field<Swept<'a>>;
    Fields::from([
        Of::value(
            "direction",
            "",
            "up or down: direction of the parameter in this sweep by integration",
            |sweep| sweep.direction().into(),
        )
        .words("sweep", |sweep| sweep.direction().to_owned()),
        Of::number("parameter", "", "value of the parameter", |sweep| sweep.point.parameter)
            .rounded("parameter", 10),
        Of::number(
            "amplitude_max",
            "",
            "amplitude of the settled motion there; null where it rotates without repeating itself",
            Swept::amplitude,
        )
        .rounded("amplitude", 8),
        Of::value(
            "drive_periods",
            "1",
            "periods of the drive after which it repeats itself to a millionth; null where it does not",
            |sweep| sweep.point.drive_periods.into(),
        )
        .numeral("periods", |sweep| {
            sweep.point.drive_periods.map_or_else(|| "-".to_owned(), |periods| periods.to_string())
        }),
        Of::value("turns", "1", "turns of the coordinate in these periods", |sweep| {
            sweep.point.rotation.map_or(0, |rotation| rotation.turns_of(sweep.answer.coordinate)).into()
        }),
    ])
}

pub(super) fn of_jump<'a>() -> Fields<Jumping<'a>> {
    type Of<'a> = Field<Jumping<'a>>;
    Fields::from([
        Of::number("parameter", "", "value at which a slow sweep jumps", |jump| jump.jump.from.parameter),
        Of::value("sweep", "", "up or down: direction of the parameter", |jump| {
            direction(jump.jump.rising).into()
        }),
        Of::number("from", "", "amplitude before the jump", |jump| jump.answer.amplitude(&jump.jump.from)),
        Of::value("to[]", "", "amplitudes of the other stable solutions there", |jump| {
            jump.of_landings(ResponseResult::amplitude)
        }),
        Of::value("to_error[]", "", "errors of the states of these solutions", |jump| {
            jump.of_landings(|_, point| point.error)
        }),
    ])
}
