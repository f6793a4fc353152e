//! Response curves: amplitude against a parameter, stable stretches solid, unstable ones dashed, special points marked.

use super::chart::{Axis, Look, Mark, Panel, Picture, Series, Units};
use super::names::{name, symbol};
use super::parameters::of_model;
use super::style;
use libration::continuation::{Branch, BranchPoint, FreeOscillation, SpecialKind, Sweep, SweepPoint};
use libration::systems::Model;

/// The dashes of unstable parts.
const DASHES: &[f64] = &[5.0, 4.0];
const KINDS: [SpecialKind; 7] = [
    SpecialKind::Fold,
    SpecialKind::SymmetryBreaking,
    SpecialKind::PeriodDoubling,
    SpecialKind::NeimarkSacker,
    SpecialKind::NeutralSaddle,
    SpecialKind::BranchPoint,
    SpecialKind::Hopf,
];

/// The content of the picture.
pub(crate) struct ResponseCurve<'a> {
    pub(crate) model: &'a Model,
    pub(crate) parameter: &'a str,
    pub(crate) range: [f64; 2],
    /// The coordinate whose amplitude is shown.
    pub(crate) coordinate: usize,
    pub(crate) branches: &'a [Branch],
    /// Frequency and amplitude of free oscillations, where the parameter is the frequency of the drive.
    pub(crate) backbone: &'a [FreeOscillation],
    /// Slow sweeps of the parameter.
    pub(crate) sweeps: &'a [Sweep],
}

impl ResponseCurve<'_> {
    fn is_angle(&self) -> bool {
        self.model.coordinates()[self.coordinate].is_angle()
    }

    fn rotates(&self) -> bool {
        self.branches.iter().any(|branch| branch.space.rotation.is_some())
    }

    /// Parameter and amplitude, angles in degrees.
    fn position(&self, point: &BranchPoint) -> (f64, f64) {
        (point.parameter, self.shown(point.amplitude(self.coordinate, self.is_angle())))
    }

    fn shown(&self, amplitude: f64) -> f64 {
        if self.is_angle() { amplitude.to_degrees() } else { amplitude }
    }

    /// The points of a sweep; oscillations are shown with oscillations, rotations with rotations.
    fn swept(&self, sweep: &Sweep) -> Vec<(f64, f64)> {
        let alike = sweep.points.iter().filter(|point| point.rotation.is_some() == self.rotates());
        let point = |point: &SweepPoint| {
            Some((point.parameter, self.shown(point.amplitude(self.coordinate, self.is_angle())?)))
        };
        alike.filter_map(point).collect()
    }
}

/// The branches, with the backbone below them if there is one.
pub(crate) fn response(curve: &ResponseCurve<'_>) -> Picture {
    let unit = if curve.is_angle() { 1_f64.to_degrees() } else { 1.0 };
    let mut series = vec![];
    if !curve.backbone.is_empty() {
        let points = curve.backbone.iter().map(|free| (free.parameter, unit * free.amplitude));
        series.push(Series::line("free oscillations", style::reference(), points));
    }
    let mut named = [false; 2];
    for branch in curve.branches {
        for (stable, points) in stretches(curve, branch) {
            let first = !std::mem::replace(&mut named[usize::from(stable)], true);
            let label = if stable { "stable" } else { "unstable" };
            series.push(Series::line(if first { label } else { "" }, look(stable), points));
        }
    }
    for (number, wanted) in KINDS.iter().enumerate() {
        let special = curve.branches.iter().flat_map(|branch| &branch.special);
        let points: Vec<(f64, f64)> = special
            .filter(|special| special.kind == *wanted)
            .map(|special| curve.position(&special.point))
            .collect();
        if !points.is_empty() {
            series.push(Series::line(&wanted.to_string(), style::markers(number + 1), points));
        }
    }
    for sweep in curve.sweeps {
        let label = if sweep.rising { "swept up" } else { "swept down" };
        series.push(Series::line(label, style::swept(sweep.rising), curve.swept(sweep)));
    }
    let [from, to] = curve.range;
    let top = series.iter().flat_map(|one| one.points.iter().map(|point| point.y)).fold(0.0, f64::max);
    let coordinate = &curve.model.coordinates()[curve.coordinate].name;
    let unit = if curve.is_angle() { " / degrees" } else { "" };
    let label = match curve.rotates() {
        true => format!("{} from uniform rotation{unit}", symbol(coordinate)),
        false => format!("largest |{}|{unit}", symbol(coordinate)),
    };
    let y = Axis::linear(&label, 0.0, if top > 0.0 { 1.05 * top } else { 1.0 });
    let y = if curve.is_angle() { y.in_units(Units::Degrees) } else { y };
    let x = Axis::linear(&symbol(curve.parameter), from.min(to), from.max(to));
    let title = format!("Periodic solutions: {}", name(curve.model));
    Picture::new(&title, vec![Panel { x, y, series, share: 1.0 }]).with_parameters(of_model(curve.model))
}

/// The stretches of a branch that are stable or not; they end at special points, and follow the branch between its points.
fn stretches(curve: &ResponseCurve<'_>, branch: &Branch) -> Vec<(bool, Vec<(f64, f64)>)> {
    let mut stretches: Vec<(bool, Vec<(f64, f64)>)> = vec![];
    for (number, point) in branch.points.iter().enumerate() {
        let special: Vec<(f64, f64)> = branch
            .special
            .iter()
            .filter(|special| special.before == number)
            .map(|special| curve.position(&special.point))
            .collect();
        match stretches.last_mut() {
            Some((stable, points)) if *stable == point.is_stable() => points.extend(special),
            Some((_, points)) => {
                let joint = special.first().copied().unwrap_or_else(|| curve.position(point));
                points.push(joint);
                stretches.push((point.is_stable(), if special.is_empty() { vec![joint] } else { special }));
            }
            None => stretches.push((point.is_stable(), special)),
        }
        if let Some((_, points)) = stretches.last_mut() {
            points.push(curve.position(point));
        }
    }
    stretches
}

pub(super) fn look(stable: bool) -> Look {
    let line = style::curve(0);
    if stable { line } else { Look { mark: Mark::Line(DASHES), width: 1.5, ..line } }
}
