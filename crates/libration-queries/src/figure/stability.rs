//! Stability over two parameters: where rest is stable as dots, its edges, curves of singular points and their cusps.

use super::chart::{Axis, Look, Mark, Panel, Picture, Series};
use super::names::{name, symbol};
use super::parameters::of_model;
use super::style;
use libration::continuation::{CurvePoint, SpecialCurve, SpecialKind, StabilityChart};
use libration::systems::Model;

/// The content of the picture.
pub(crate) struct Chart<'a> {
    pub(crate) model: &'a Model,
    pub(crate) parameters: &'a [String; 2],
    pub(crate) ranges: [[f64; 2]; 2],
    pub(crate) chart: &'a StabilityChart,
}

/// The kinds of curves, at rest and of driven motions, with their names.
const KINDS: [(SpecialKind, Role, &str); 10] = [
    (SpecialKind::BranchPoint, Role::Boundary, "boundary: branch point"),
    (SpecialKind::PeriodDoubling, Role::Boundary, "boundary: period doubling"),
    (SpecialKind::NeimarkSacker, Role::Boundary, "boundary: Neimark–Sacker"),
    (SpecialKind::BranchPoint, Role::Unstable, "unstable: branch point"),
    (SpecialKind::PeriodDoubling, Role::Unstable, "unstable: period doubling"),
    (SpecialKind::NeimarkSacker, Role::Unstable, "unstable: Neimark–Sacker"),
    (SpecialKind::Fold, Role::Driven, "folds"),
    (SpecialKind::SymmetryBreaking, Role::Driven, "symmetry breaking"),
    (SpecialKind::PeriodDoubling, Role::Driven, "period doubling"),
    (SpecialKind::NeimarkSacker, Role::Driven, "Neimark–Sacker"),
];

/// The meaning of a piece of a curve.
#[derive(Clone, Copy, PartialEq)]
enum Role {
    /// The equilibrium is stable on one side.
    Boundary,
    /// The equilibrium is unstable on both sides.
    Unstable,
    Driven,
}

/// A piece of a curve with one meaning, and its points.
struct CurvePiece {
    meaning: (SpecialKind, Role),
    places: Vec<(f64, f64)>,
}

/// The pieces of a curve; each ends where the next one begins.
fn pieces(curve: &SpecialCurve) -> Vec<CurvePiece> {
    let role = |point: &CurvePoint| match (curve.at_rest, point.bounds_stability()) {
        (true, true) => Role::Boundary,
        (true, false) => Role::Unstable,
        (false, _) => Role::Driven,
    };
    let mut pieces: Vec<CurvePiece> = vec![];
    for run in curve.points.chunk_by(|a, b| role(a) == role(b)) {
        if let Some(before) = pieces.last_mut() {
            before.places.push(position(&run[0]));
        }
        pieces.push(CurvePiece {
            meaning: (curve.kind, role(&run[0])),
            places: run.iter().map(position).collect(),
        });
    }
    pieces
}

const fn position(point: &CurvePoint) -> (f64, f64) {
    (point.point.parameter, point.second)
}

pub(crate) fn stability(map: &Chart<'_>) -> Picture {
    let mut series: Vec<Series> = stable_dots(map).into_iter().collect();
    let pieces: Vec<CurvePiece> = map.chart.curves.iter().flat_map(pieces).collect();
    let is_present = |(kind, role, _): &&(SpecialKind, Role, &str)| {
        pieces.iter().any(|piece| piece.meaning == (*kind, *role))
    };
    for (number, (kind, role, label)) in KINDS.iter().filter(is_present).enumerate() {
        let alike = pieces.iter().filter(|piece| piece.meaning == (*kind, *role));
        for (count, piece) in alike.enumerate() {
            let label = if count == 0 { label } else { "" };
            series.push(Series::line(label, style::curve(number), piece.places.iter().copied()));
        }
    }
    let cusps: Vec<(f64, f64)> =
        map.chart.curves.iter().flat_map(|curve| &curve.cusps).map(position).collect();
    if !cusps.is_empty() {
        series.push(Series::line("cusp", style::markers(KINDS.len() + 1), cusps));
    }
    let axis = |number: usize| {
        let [from, to] = map.ranges[number];
        Axis::linear(&symbol(&map.parameters[number]), from.min(to), from.max(to))
    };
    let title = format!("Stability: {}", name(map.model));
    let panel = Panel { x: axis(0), y: axis(1), series, share: 1.0 };
    Picture::new(&title, vec![panel]).with_parameters(of_model(map.model))
}

/// Dots where the equilibrium is stable; `None` if there are none.
fn stable_dots(map: &Chart<'_>) -> Option<Series> {
    let rest = map.chart.rest.as_ref()?;
    let rows = rest.values[1].iter().zip(&rest.stable);
    let dots: Vec<_> = rows
        .flat_map(|(second, row)| {
            let stable = rest.values[0].iter().zip(row).filter(|(_, stable)| **stable == Some(true));
            stable.map(|(first, _)| (*first, *second))
        })
        .collect();
    let look = Look { opacity: 0.6, mark: Mark::Markers(0), width: 1.2, ..style::band() };
    (!dots.is_empty()).then(|| Series::line("stable equilibrium", look, dots))
}
