//! The expected uncertainty of g against the amplitude of the release, with its parts.

use super::chart::{Axis, Panel, Picture, Series, Units};
use super::range::around;
use super::style;
use libration_lab::fit::plan::{ExpectedUncertainty, Plan, PlannedSwings};

type Part = fn(&ExpectedUncertainty) -> f64;

const PARTS: [(&str, Part); 5] = [
    ("total", ExpectedUncertainty::total),
    ("noise", |expected| expected.noise),
    ("angle scale", |expected| expected.angle_scale),
    ("length", |expected| expected.length),
    ("clock", |expected| expected.clock),
];

/// A curve for each part that is not zero, and the wanted uncertainty.
pub(crate) fn plan(plan: &Plan) -> Picture {
    let position =
        |swings: &PlannedSwings, part: Part| (swings.amplitude.to_degrees(), part(&swings.expected));
    let of_part = |part: Part| {
        let points = plan.choices.iter().map(|choice| position(choice, part));
        points.filter(|(_, y)| *y > 0.0 && y.is_finite()).collect::<Vec<_>>()
    };
    let curves = PARTS.iter().enumerate().map(|(number, (label, part))| (number, *label, of_part(*part)));
    let curves: Vec<_> = curves.filter(|(_, _, points)| !points.is_empty()).collect();
    let all = || curves.iter().flat_map(|(_, _, points)| points);
    let (from, to) = around(all().map(|point| point.0));
    let (low, high) = around(all().map(|point| point.1.log10()).chain([plan.target.log10()]));
    let wanted = [(from.max(0.0), plan.target), (to, plan.target)];
    let mut series = vec![Series::line("wanted", style::reference(), wanted)];
    for (number, label, points) in &curves {
        series.push(Series::line("", style::thin(*number), points.clone()));
        series.push(Series::line(label, style::markers(*number), points.clone()));
    }
    let panel = Panel {
        x: Axis::linear("amplitude of the release / degrees", from.max(0.0), to).in_units(Units::Degrees),
        y: Axis::logarithmic("relative uncertainty of g", 10_f64.powf(low), 10_f64.powf(high)),
        series,
        share: 1.0,
    };
    Picture::new("Expected uncertainty of g", vec![panel])
}
