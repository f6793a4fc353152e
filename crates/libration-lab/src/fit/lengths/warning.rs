//! Warnings about periods against lengths.

use std::fmt;

use super::model;
use super::table::{LengthRow, LengthTable};
use super::{LengthFit, LengthModel, LengthsFit, PowerLaw};
use crate::fit::budget::CombinedUncertainty;
use crate::fit::cycles::SEPARATED;
use crate::fit::gravity::{GRAVITY_ON_EARTH, is_nowhere_on_earth};
use crate::fit::mistake::GravityMistake;
use crate::fit::scatter::{Scatter, ScatterWarning};
use crate::fit::significance::{SIGNIFICANT, limit_of_chance};
use crate::fit::uncertain::Uncertain;
use crate::statistics::count;
use libration::quantity::rounded;

/// A term counts as needed when chance would make it as large less often than this: the warning is given for one in a hundred of the tables that
/// do not need it.
const NEEDED: f64 = 0.01;
/// Distance from the bob, in radii, above which an offset is not that of a mark on its surface.
const RADII_OF_OFFSET: f64 = 10.0;

/// A warning about periods against lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum LengthsWarning {
    /// The rows need an offset of the lengths: without it chance would make so large a residual in fewer than one table in a hundred.
    OffsetNeeded,
    /// The rows need a bend of the line, by the same test.
    Bent {
        /// Radius of a ball that would bend the line in this way, in m; `None` if the line bends the other way.
        radius: Option<f64>,
    },
    /// The rows scatter more or less than stated.
    Scatter(ScatterWarning),
    /// The offset is more than ten radii of the bob.
    OffsetLargerThanBob,
    /// The uncertainty of g is more than a quarter of it.
    Undetermined {
        /// The uncertainty relative to g.
        relative: f64,
    },
    /// The periods grow with a power of the length other than 1/2, which no offset explains equally well.
    OtherPower {
        /// The exponent.
        exponent: Uncertain,
    },
    /// The law of the other rows does not explain a row, and g without it differs.
    Outlying {
        /// The row of the table, counted from zero.
        row: usize,
        /// g without it, in m/s².
        gravity: Uncertain,
    },
    /// The periods are those of a bar turned about several points: they fall with the distance from the centre of mass up to this one, in m.
    PhysicalPendulum {
        /// Radius of gyration.
        gyration: f64,
    },
    /// The rows of a bar do not exclude another centre of mass, for example because all points are on one side of it.
    TwoCentres {
        /// Position of the other centre, in metres.
        centre: f64,
        /// g with it, in m/s².
        gravity: f64,
    },
    /// g is found nowhere on Earth, by [more than three](crate::fit::is_nowhere_on_earth) of its uncertainties.
    NowhereOnEarth {
        /// The mistake that explains it.
        mistake: Option<GravityMistake>,
    },
}

impl LengthsWarning {
    /// A stable name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::OffsetNeeded => "offset_needed",
            Self::Bent { .. } => "bent",
            Self::Scatter(warning) => warning.name(),
            Self::OffsetLargerThanBob => "offset_larger_than_bob",
            Self::Undetermined { .. } => "gravity_undetermined",
            Self::OtherPower { .. } => "other_power",
            Self::Outlying { .. } => "outlying_row",
            Self::PhysicalPendulum { .. } => "physical_pendulum",
            Self::TwoCentres { .. } => "two_centres",
            Self::NowhereOnEarth { .. } => "gravity_contradicted",
        }
    }
}

impl LengthsWarning {
    /// The text, in which a row is named by its line in a file, if the lines of all rows are given.
    #[must_use]
    pub fn with_lines(&self, lines: &[u64]) -> String {
        match self {
            Self::Outlying { row, gravity } if *row < lines.len() => {
                format!("line {} {}", lines[*row], Self::far_from_the_others(*gravity))
            }
            _ => self.to_string(),
        }
    }

    fn far_from_the_others(gravity: Uncertain) -> String {
        format!("is far from the law of the others: without it g is {gravity} m/s²; check its numbers")
    }
}

impl fmt::Display for LengthsWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OffsetNeeded => f.write_str(
                "the lengths are off by a constant: an offset is needed, and g without it is wrong",
            ),
            Self::Bent { radius: Some(radius) } => write!(
                f,
                "T² against L is not straight, as for a ball of radius {:.1} mm: give the radius of the bob",
                1e3 * radius
            ),
            Self::Bent { radius: None } => f.write_str(
                "T² against L is not straight, and bends the other way than a large bob would bend it: look at the amplitudes and at \
                 how the lengths were measured",
            ),
            Self::Scatter(warning) => warning.fmt(f),
            Self::OffsetLargerThanBob => {
                f.write_str("the offset is much larger than the bob: check the unit of the lengths")
            }
            Self::Undetermined { relative } => write!(
                f,
                "the rows do not determine g, whose uncertainty is {} % of it: look for a wrong number, and for a column that was read as another",
                rounded(100.0 * relative, 2)
            ),
            Self::OtherPower { exponent } => {
                write!(
                    f,
                    "the periods grow as the length to the power {exponent}, and not 1/2, which no offset of the lengths explains"
                )?;
                match (exponent.value - 2.0).abs() < FAR_FROM_HALF {
                    true => f.write_str(": lengths and periods are swapped"),
                    false => f.write_str(": check which column is which, and the amplitudes"),
                }
            }
            Self::Outlying { row, gravity } => {
                write!(f, "row {} {}", row + 1, Self::far_from_the_others(*gravity))
            }
            Self::PhysicalPendulum { gyration } => write!(
                f,
                "the periods fall with the distance from the centre of mass up to {:.1} mm and rise beyond: they are those of a bar turned \
                 about several points, T²h = 4π²(k² + h²)/g, and not of a simple pendulum",
                1e3 * gyration
            ),
            Self::TwoCentres { centre, gravity } => write!(
                f,
                "a centre of mass at {} m explains the rows nearly as well, with g = {} m/s²: measure on both sides of the centre, or the positions \
                 from it",
                rounded(*centre, 3),
                rounded(*gravity, 3)
            ),
            Self::NowhereOnEarth { mistake } => {
                let [least, greatest] = GRAVITY_ON_EARTH.map(|bound| rounded(bound, 3));
                write!(f, "gravity is {least} to {greatest} m/s² on Earth: ")?;
                match mistake {
                    Some(mistake) => write!(f, "this value is what {mistake} would give"),
                    None => f.write_str("check the units of lengths and periods, and that periods are whole ones"),
                }
            }
        }
    }
}

/// Relative uncertainty of g above which the rows do not determine it.
pub(super) const UNDETERMINED: f64 = 0.25;
/// Least distance of an exponent from 1/2 that amplitudes and bobs do not explain.
const FAR_FROM_HALF: f64 = 0.05;

/// Warnings in the order in which the laws are compared, gravity last; `outlying` is the one about a row.
pub(super) fn warnings(
    fit: &LengthsFit,
    table: &LengthTable,
    outlying: Option<LengthsWarning>,
) -> Vec<LengthsWarning> {
    let of = |model| fit.law(model);
    let by_chance = |fit: Option<&LengthFit>| fit.and_then(|fit| fit.p_value).unwrap_or(1.0);
    let offset = of(LengthModel::Offset);
    let bent = of(LengthModel::OffsetAndGyration);
    let scatter = offset.and_then(LengthFit::scatter);
    let undetermined = undetermined(fit.gravity());
    let other_power = other_power(fit, table);
    let is_doubtful = undetermined.or(other_power).or(outlying).is_some();
    [
        undetermined,
        other_power,
        outlying,
        (by_chance(offset) < NEEDED && !is_doubtful).then_some(LengthsWarning::OffsetNeeded),
        bent.filter(|fit| by_chance(Some(fit)) < NEEDED && !is_doubtful).map(bend),
        scatter.and_then(|scatter: Scatter| scatter.warning("the offset")).map(LengthsWarning::Scatter),
        offset_larger_than_bob(fit),
        nowhere_on_earth(fit.gravity(), fit.combined.degrees_of_freedom),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Warnings about a bar whose g has this uncertainty; those about gravity come last.
pub(super) fn of_bars(
    fit: &LengthFit,
    combined: &CombinedUncertainty,
    is_inferred: bool,
    outlying: Option<LengthsWarning>,
) -> Vec<LengthsWarning> {
    let gyration = fit.gyration.map_or(0.0, |gyration| gyration.value.sqrt());
    let scatter = fit.scatter().and_then(|scatter: Scatter| scatter.warning("the centre of mass"));
    let gravity = Uncertain { value: fit.g.value, uncertainty: combined.standard };
    [
        undetermined(gravity),
        is_inferred.then_some(LengthsWarning::PhysicalPendulum { gyration }),
        outlying,
        scatter.map(LengthsWarning::Scatter),
        fit.other_centre.map(|[centre, gravity]| LengthsWarning::TwoCentres { centre, gravity }),
        nowhere_on_earth(gravity, combined.degrees_of_freedom),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn undetermined(gravity: Uncertain) -> Option<LengthsWarning> {
    let relative = gravity.relative().abs();
    (relative > UNDETERMINED).then_some(LengthsWarning::Undetermined { relative })
}

/// The power law, where its exponent is far from 1/2 by more than chance and its residuals are separated from those of the law with an offset, which
/// has as many parameters.
fn other_power(fit: &LengthsFit, table: &LengthTable) -> Option<LengthsWarning> {
    let PowerLaw { exponent, factor, degrees_of_freedom } = fit.power_law?;
    let distance = (exponent.value - 0.5).abs();
    let is_far =
        distance > FAR_FROM_HALF.max(limit_of_chance(SIGNIFICANT, degrees_of_freedom) * exponent.uncertainty);
    let equal = table.of_equal_periods();
    let of_offset = model::fit(&equal, LengthModel::Offset, None).ok().flatten()?.sum_of_squares();
    let residual = |row: &LengthRow| {
        let small = factor.value * libm::pow(row.length, exponent.value);
        (row.period - row.ratio * small) / row.period_uncertainty
    };
    let of_power: f64 = equal.rows.iter().map(|row| residual(row) * residual(row)).sum();
    let gain = count(table.len()) * libm::log(of_offset / of_power);
    (is_far && gain > SEPARATED).then_some(LengthsWarning::OtherPower { exponent })
}

fn bend(fit: &LengthFit) -> LengthsWarning {
    let gyration = fit.gyration.map_or(0.0, |gyration| gyration.value);
    LengthsWarning::Bent { radius: (gyration > 0.0).then(|| radius_of(gyration)) }
}

/// Radius of a ball with this κ = 2r²/5.
fn radius_of(gyration: f64) -> f64 {
    (2.5 * gyration).sqrt()
}

fn offset_larger_than_bob(fit: &LengthsFit) -> Option<LengthsWarning> {
    let offset = fit.law(LengthModel::Offset)?.offset?.value;
    let radius = radius_of(fit.known_gyration?);
    (offset.abs() > RADII_OF_OFFSET * radius).then_some(LengthsWarning::OffsetLargerThanBob)
}

fn nowhere_on_earth(gravity: Uncertain, degrees_of_freedom: f64) -> Option<LengthsWarning> {
    let mistake = GravityMistake::explaining(gravity, GravityMistake::anywhere_on_earth());
    is_nowhere_on_earth(gravity, degrees_of_freedom).then_some(LengthsWarning::NowhereOnEarth { mistake })
}
