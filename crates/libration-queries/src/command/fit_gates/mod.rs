//! `libration fit gates`: times of a photogate, cleaned, and the period that they determine.

mod fields;
mod report;
mod write;

use crate::arguments::{
    ApparatusOptions, LinearDampingOption, RecordingOptions, finding_with_option, one_amplitude,
};
use crate::document;
use crate::figure;
use crate::interrupt::{self, Cancellation};
use crate::output::normal_gravity::NormalGravity;
use crate::output::{FormOptions, announce};
use crate::query_error::{QueryError, option};
use fields::FitGatesResult;
use libration::quantity::{Angle, Quantity};
use libration_lab::fit::Budget;
use libration_lab::fit::gates::{
    FlagShape, GateGeometry, GateOptions, GateSignals, GatesError, GatesFit, fit_gates,
};
use std::io::Write;
use std::path::PathBuf;

pub(crate) use fields::answers;

/// Times of a photogate: periods, T0 and gravity; double triggers and missed passages are detected
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration fit gates examples/gate_synthetic.csv
  libration fit gates examples/gate_synthetic.csv --amplitude 0.9 \\
    --length 0.958m±0.001m
  libration fit gates examples/gate_synthetic.csv --length 0.958m±0.001m \\
    --diameter \"25.0(1) mm\" --figure gates.svg
  libration fit gates examples/gate_synthetic.csv --signals edges --csv
  libration fit gates examples/gate_synthetic.csv --amplitude 0.9 \\
    --length 0.958m±0.001m --latitude 48.1deg --report gates.html
  libration fit gates examples/light_synthetic.csv --signal 2 --amplitude 0.2

Each period runs from one passage to the next in the same direction, so the gate
need not be at the centre. With the diameter of the bob and the length, the speed
at the gate gives every amplitude; otherwise T0 needs the amplitude of the first
swing.")
)]
pub(crate) struct FitGates {
    /// Times of one photogate, optionally with its state (blocked or not), or a continuous signal; - for standard input
    file: PathBuf,
    /// Meaning of the times: edges (blocked, free, …) or whole passages [default: detected from their pattern]
    #[arg(long, value_enum)]
    signals: Option<Signals>,
    /// Diameter of the object whose middle passes the gate [default: that of the bob at the height of the gate, from its radius]
    #[arg(long, value_name = "LENGTH", value_parser = crate::arguments::length_with_uncertainty, requires = "length")]
    diameter: Option<Quantity>,
    /// Shape of the object with this diameter: a ball, or a flat flag with edges parallel to the rod
    #[arg(long, value_enum, default_value = "ball", requires = "diameter")]
    shape: Shape,
    /// Distance of the gate from the pivot [default: the length of the pendulum]
    #[arg(long, value_name = "LENGTH", value_parser = crate::arguments::length_with_uncertainty)]
    gate_distance: Option<Quantity>,
    /// Amplitude of the release, a quarter period before the first passage, such as 20deg
    #[arg(long, value_name = "ANGLE", value_parser = crate::arguments::angle)]
    amplitude: Option<Angle>,
    /// Draw the periods against time to FILE.svg, .pdf, .png or .json
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    /// Write a report with pictures to FILE.html, or to FILE.md or FILE.tex with the pictures next to it
    #[arg(long, value_name = "FILE", value_parser = document::name)]
    report: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
    #[command(flatten)]
    apparatus: ApparatusOptions,
    #[command(flatten)]
    damping: LinearDampingOption,
    #[command(flatten)]
    reading: RecordingOptions,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Signals {
    Edges,
    Passages,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Shape {
    Ball,
    Flag,
}

impl FitGates {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let read = self.reading.gate_times(&self.file)?;
        let name = self.file.display().to_string();
        let geometry = self.geometry()?;
        let options = self.options(geometry.as_ref())?;
        interrupt::listen()?;
        let fit = fit_gates(&read.times, read.blocked.as_deref(), &options, &Cancellation);
        let fit = fit.map_err(|error| failure(&name, &error))?;
        let budget = self.budget(&fit, geometry.as_ref())?;
        let mut written =
            figure::file::drawn(self.figure.as_deref(), &self.layout, || Ok(figure::gates::periods(&fit)))?;
        let findings: Vec<String> = read.findings.iter().map(finding_with_option).collect();
        let incomplete = read.incomplete;
        let normal = budget.as_ref().zip(self.apparatus.normal_gravity()?);
        let normal = normal.map(|(budget, normal)| NormalGravity { measured: budget.gravity(), normal });
        let budget = budget.as_ref().zip(self.apparatus.length());
        let answer = FitGatesResult { fit: &fit, budget, normal, findings, incomplete };
        if let Some(path) = &self.report {
            written.push(document::write(path, &report::document(&answer, &name))?);
        }
        answer.write(out, self.form.form())?;
        Ok(announce(out, self.form.form(), &written)?)
    }

    fn options(&self, geometry: Option<&GateGeometry>) -> Result<GateOptions, QueryError> {
        let signals = self.signals.map(|signals| match signals {
            Signals::Edges => GateSignals::Edges,
            Signals::Passages => GateSignals::Passages,
        });
        let amplitude = self.amplitude.as_ref().map(one_amplitude).transpose()?;
        let amplitude =
            amplitude.map(|amplitude| Quantity { value: amplitude.angle().radians(), uncertainty: None });
        Ok(GateOptions { signals, width: geometry.and_then(GateGeometry::width), amplitude })
    }

    /// The geometry of the gate; `None` without a length.
    fn geometry(&self) -> Result<Option<GateGeometry>, QueryError> {
        let Some(apparatus) = self.apparatus.apparatus()? else { return Ok(None) };
        let geometry = GateGeometry::new(apparatus, self.diameter, self.gate_distance);
        let shape = match self.shape {
            Shape::Ball => FlagShape::Ball,
            Shape::Flag => FlagShape::Flat,
        };
        geometry
            .map(|geometry| Some(geometry.with_shape(shape)))
            .map_err(|error| QueryError::no_result("gate", error))
    }

    fn budget(&self, fit: &GatesFit, geometry: Option<&GateGeometry>) -> Result<Option<Budget>, QueryError> {
        let Some(geometry) = geometry else { return Ok(None) };
        let (angle_scale, clock) = (self.apparatus.angle_scale(), self.apparatus.clock());
        let correlations = self.apparatus.correlations();
        fit.gravity(geometry, angle_scale, clock, self.damping.damping(), correlations)
            .map_err(|error| QueryError::no_result("gravity", error))
    }
}

/// Blames the option, not the file, where that is to blame.
fn failure(file: &str, error: &GatesError) -> QueryError {
    match error {
        GatesError::Interrupted(_) => QueryError::cancelled("interrupted: nothing is written"),
        GatesError::NotUsable { name: "amplitude", .. } => QueryError::no_result(option("amplitude"), error),
        _ => QueryError::no_result(file, error),
    }
}
