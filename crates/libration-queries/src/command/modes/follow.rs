//! A mode followed in amplitude, as table, JSON and CSV.

use crate::arguments::{self, CoordinateName, coordinate, displacements};
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::number::{at_most, short, to_its_error};
use crate::output::table::{Table, paragraph, write_text};
use crate::output::{Form, csv, json};
use crate::query_error::{QueryError, option};
use libration::nonlinear_modes::{LostMode, ModePoint, NonlinearMode, StabilityChange};
use libration::quantity::Displacement;
use libration::systems::{Coordinate, Model};
use std::io::{self, Write};

/// Width at which lines are broken, in columns.
const COLUMNS: usize = 100;

/// Larger than the number of modes of any system.
const MOST_MODES: usize = 65_535;

/// The mode that is followed, and its range.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct FollowOptions {
    /// Follow the mode with this number, from 1, to large amplitudes, as periodic orbits with their stability
    #[arg(long, value_name = "MODE", requires = "amplitudes", value_parser = arguments::count::<MOST_MODES>)]
    pub(super) follow: Option<usize>,
    /// Amplitudes of the followed mode: a list or a range, such as 10deg:90deg:10deg or 0.1,0.5
    #[arg(long, value_name = "LIST", requires = "follow")]
    amplitudes: Option<String>,
    /// The coordinate of the amplitude [default: the first]
    #[arg(long, value_name = "NAME", requires = "follow")]
    coordinate: Option<CoordinateName>,
}

/// A followed mode.
pub(super) struct FollowedMode {
    pub(super) model: Model,
    pub(super) mode: usize,
    pub(super) coordinate: usize,
    pub(super) branch: NonlinearMode,
}

impl FollowOptions {
    /// The number of the coordinate.
    pub(super) fn coordinate(&self, model: &Model) -> Result<usize, QueryError> {
        let named = |name: &CoordinateName| coordinate(model, &option("coordinate"), name);
        self.coordinate.as_ref().map_or(Ok(0), named)
    }

    /// Ascending amplitudes.
    pub(super) fn amplitudes(&self, coordinate: &Coordinate) -> Result<Vec<f64>, QueryError> {
        let text = self.amplitudes.as_deref().unwrap_or_default();
        let values = displacements(&option("amplitudes"), text, coordinate.is_angle())?;
        let mut values: Vec<f64> = values.iter().map(Displacement::to_f64).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        Ok(values)
    }
}

impl FollowedMode {
    fn is_angle(&self) -> bool {
        self.model.coordinates()[self.coordinate].is_angle()
    }

    fn amplitude_text(&self, amplitude: f64) -> String {
        match self.is_angle() {
            true => format!("{}°", short(amplitude.to_degrees(), 5)),
            false => short(amplitude, 5),
        }
    }

    pub(super) fn write(&self, out: &mut dyn Write, form: Form) -> io::Result<()> {
        let fields = of_point();
        match form {
            Form::Json => {
                let points = self.branch.points.iter().map(|point| fields.record(point));
                json::document_with_list(out, of_family().record(self), "points", points)
            }
            Form::Csv => {
                csv::line(out, &fields.csv_names())?;
                self.branch.points.iter().try_for_each(|point| csv::line(out, &fields.csv_cells(point)))
            }
            Form::Table => self.write_sheet(out),
        }
    }

    fn write_sheet(&self, out: &mut dyn Write) -> io::Result<()> {
        for (name, text) in of_family().lines(self) {
            writeln!(out, "{}", paragraph(&format!("{name:<14}"), &text, COLUMNS))?;
        }
        writeln!(out)?;
        let fields = of_point();
        let mut table = Table::new(fields.columns());
        self.branch.points.iter().try_for_each(|point| table.row(out, fields.cells(point)))?;
        table.finish(out)?;
        writeln!(out)?;
        write_text(out, "", &self.words())
    }

    fn words(&self) -> String {
        let change = |change: &StabilityChange| {
            let [from, to] = change.between.map(|amplitude| self.amplitude_text(amplitude));
            let amplitude_text =
                if from == to { format!("at {from}") } else { format!("between {from} and {to}") };
            format!(
                "It becomes {} {amplitude_text}.",
                if change.stable_above { "stable" } else { "unstable" }
            )
        };
        let mut sentences: Vec<String> = self.branch.changes.iter().map(change).collect();
        if let Some(reach) = self.branch.series_reach(0.01) {
            sentences.push(format!(
                "The series ω + κa² is within 1 % of the frequency up to {}.",
                self.amplitude_text(reach)
            ));
        }
        sentences.extend(self.branch.lost.as_ref().map(|lost| self.ending(lost)));
        if sentences.is_empty() { "Its stability does not change.".to_owned() } else { sentences.join(" ") }
    }
}

impl FollowedMode {
    /// The amplitude in degrees for angles.
    fn ending(&self, lost: &LostMode) -> String {
        let reached = self.amplitude_text(lost.reached);
        format!(
            "It ends early: the mode could not be continued beyond the amplitude {reached}: {}.",
            lost.reason
        )
    }
}

fn of_family() -> Fields<FollowedMode> {
    type Of = Field<FollowedMode>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |mode| {
            mode.model.key().into()
        })
        .line_of("system", |mode| mode.model.title().to_owned()),
        Of::value("equations[]", "", "equations of motion as they were read", |mode| {
            json::list(mode.model.equation().to_string().split("; "))
        })
        .line_of("equations", |mode| mode.model.equation().to_string()),
        Of::value("mode", "1", "number of the mode, from 1", |mode| (mode.mode + 1).into())
            .line_of("mode", |mode| (mode.mode + 1).to_string()),
        Of::value("coordinate", "", "coordinate of the amplitude", |mode| {
            mode.model.coordinates()[mode.coordinate].name.as_str().into()
        })
        .line_of("amplitude of", |mode| mode.model.coordinates()[mode.coordinate].name.clone()),
        Of::value("state[]", "", "names of the state variables", |mode| json::list(mode.model.state_names())),
        Of::nested("stability_changes[].", &of_change(), |mode| of_change().records(&mode.branch.changes)),
        Of::nullable(
            "series_reach",
            "",
            "amplitude up to which ω + κa² is within 1 % of the frequency, or null",
            |mode| mode.branch.series_reach(0.01),
        ),
        Of::value("lost", "", "reason why it does not reach the last amplitude, or null", |mode| {
            mode.branch.lost.as_ref().map(ToString::to_string).into()
        }),
    ])
}

fn of_change() -> Fields<StabilityChange> {
    type Of = Field<StabilityChange>;
    Fields::from([
        Of::number("from", "", "amplitude below the change of stability", |change| change.between[0]),
        Of::number("to", "", "amplitude above it", |change| change.between[1]),
        Of::value("stable_above", "", "true if the mode is stable above", |change| {
            change.stable_above.into()
        }),
    ])
}

fn of_point() -> Fields<ModePoint> {
    type Of = Field<ModePoint>;
    Fields::from([
        Of::number("amplitude", "", "displacement at the start, in rad for angles", |point| point.amplitude)
            .rounded("amplitude", 6),
        Of::number("period_s", "s", "period of the orbit", |point| point.orbit.period())
            .numeral("period / s", |point| {
                to_its_error(point.orbit.period(), point.orbit.period_uncertainty(), 14)
            }),
        Of::number("error_s", "s", "bound on its error", |point| point.orbit.period_uncertainty())
            .numeral("to", |point| at_most(point.orbit.period_uncertainty())),
        Of::number("angular_frequency_rad_per_s", "rad/s", "angular frequency of the orbit", |point| {
            point.orbit.frequency()
        }),
        Of::nullable(
            "series_angular_frequency_rad_per_s",
            "rad/s",
            "ω + κa² of its first harmonic, or null",
            |point| point.series_frequency,
        )
        .rounded("ω + κa²", 8),
        Of::value(
            "stability",
            "",
            "attracting, neutral, unstable or undetermined (within the errors of the multipliers)",
            |point| point.orbit.floquet().map(|floquet| floquet.stability.name()).into(),
        )
        .words("stability", |point| {
            point.orbit.floquet().map_or("", |floquet| floquet.stability.name()).to_owned()
        }),
        Of::value("multipliers[][]", "1", "Floquet multipliers, real and imaginary part", |point| {
            let multipliers =
                point.orbit.floquet().map(|floquet| floquet.multipliers.clone()).unwrap_or_default();
            json::list(multipliers.iter().map(|z| json::numbers(&[z.re, z.im])))
        }),
        Of::value("multiplier_errors[]", "1", "errors of the multipliers, in their order", |point| {
            json::numbers(point.orbit.floquet().map_or(&[], |floquet| &floquet.errors))
        }),
        Of::value("start[]", "", "state at the start, in the order of the names", |point| {
            json::numbers(&point.start)
        })
        .words("start", |point| {
            let (displacements, velocities) = point.start.split_at(point.start.len() / 2);
            /// Velocities below this fraction of the largest one of the coordinate are rounding errors.
            const STILL: f64 = 1e-9;
            let still = STILL * point.amplitude * point.orbit.frequency();
            let shown = if velocities.iter().any(|velocity| velocity.abs() > still) {
                &point.start[..]
            } else {
                displacements
            };
            shown.iter().map(|x| short(*x, 10)).collect::<Vec<_>>().join(", ")
        }),
    ])
}

pub(super) fn answers() -> Answers {
    let json = [of_family().described(""), of_point().described("points[].")].concat();
    Answers { command: "modes", option: "--follow", json, csv: of_point().described_in_csv() }
}
