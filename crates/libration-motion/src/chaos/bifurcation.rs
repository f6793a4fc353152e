//! Bifurcation diagrams: the section of a motion for each value of a parameter.

use super::section::{
    PoincareSection, Points, Section, SectionEnding, SectionError, compute_section,
    compute_section_with_errors, flashes,
};
use crate::taylor::{Cause, Effort, Moment, System, Trajectory, integrate_many_stepwise};
use libration_numbers::algebra::BigFloat;
use libration_numbers::expression::{Equation, EquationError, Expression, Symbol};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Progress, Stage};

/// Equations with one varied parameter, and a section of their motions.
#[derive(Clone, Debug, PartialEq)]
pub struct Family<'a> {
    /// The equations, with values for all other parameters.
    pub equation: &'a Equation,
    /// The name of the parameter.
    pub parameter: &'a str,
    /// The surface or stroboscope that defines the points; the formula of a surface may contain the parameter.
    pub section: &'a Section,
    /// The numbers of points to skip and to record.
    pub points: Points,
    /// `true` if the error of each point is estimated, as by [`compute_section_with_errors`](super::compute_section_with_errors). The start of each
    /// motion counts as exact, also where it is the last state of another.
    pub with_errors: bool,
}

/// The initial state of the motion for each value of the parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Continuation {
    /// The same state for every value.
    SameStart,
    /// The last state of the motion for the previous value, so that a motion is followed as long as it is stable.
    LastState,
}

/// The section for one value of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct DiagramColumn {
    /// The value of the parameter.
    pub value: f64,
    /// The points.
    pub section: PoincareSection,
}

/// The reason why there is no bifurcation diagram.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DiagramError {
    /// A parameter that the equations do not have.
    #[error(transparent)]
    Equation(#[from] EquationError),
    /// An invalid section.
    #[error(transparent)]
    Section(#[from] SectionError),
    /// A value that is not finite.
    #[error("the parameter value {0:?} is not finite: give finite values")]
    Value(f64),
}

/// The section for each value of the parameter, in the given order.
///
/// `progress` receives the number of complete columns, and a cancelled call returns these.
///
/// # Errors
/// An invalid parameter or value, or an invalid section, as for [`compute_section`](super::compute_section).
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::chaos::{Continuation, Family, Points, Section, compute_bifurcation_diagram};
/// use libration::progress::Quiet;
/// use libration::taylor::{Effort, Moment};
/// let equation = "theta'' + theta'/2 + sin(theta) = A*cos(2t/3)".parse()?;
/// let section = Section::Stroboscope { period: None, phase: 0.0 };
/// let points = Points { skipped: 100, recorded: 4 };
/// let family = Family { equation: &equation, parameter: "A", section: &section, points, with_errors: false };
/// let start = Moment { time: 0.0, state: vec![0.2, 0.0] };
/// let effort = Effort::to_tolerance(1e-10);
/// let columns = compute_bifurcation_diagram(&family, &[0.9, 1.0], &start, Continuation::SameStart, &effort, &Quiet)?;
/// assert_eq!(columns[1].section.points.len(), 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn compute_bifurcation_diagram(
    family: &Family<'_>,
    values: &[f64],
    start: &Moment,
    continuation: Continuation,
    effort: &Effort,
    progress: &dyn Progress,
) -> Result<Vec<DiagramColumn>, DiagramError> {
    let watch = &Watch::new(progress);
    watch.begin(Stage::Whole, Some(values.len()));
    // The motions of many values take seconds to prepare.
    if watch.go_on().is_err() {
        return Ok(vec![]);
    }
    let cut = family.section.with_period_of(family.equation);
    match (continuation, &cut) {
        (Continuation::SameStart, Section::Stroboscope { .. }) if !family.with_errors => {
            family.side_by_side(&cut, values, start, effort, watch)
        }
        _ => family.one_by_one(&cut, values, start, continuation, effort, watch),
    }
}

impl Family<'_> {
    fn equation_at(&self, value: f64) -> Result<Equation, DiagramError> {
        Ok(self.equation.with(&[(self.parameter, exactly(value)?)])?)
    }

    /// The section with this value of the parameter in its formula.
    fn section_at(&self, cut: &Section, value: f64) -> Result<Section, DiagramError> {
        let Section::Crossing { formula, direction } = cut else { return Ok(cut.clone()) };
        let value = exactly(value)?;
        let names = self.equation.parameters_called(&[self.parameter])?;
        let formula = names
            .iter()
            .fold(formula.clone(), |formula, name| formula.substitute(&Symbol::plain(name), &value));
        Ok(Section::Crossing { formula, direction: *direction })
    }

    /// Computes one motion after the other.
    fn one_by_one(
        &self,
        cut: &Section,
        values: &[f64],
        start: &Moment,
        continuation: Continuation,
        effort: &Effort,
        watch: &Watch<'_>,
    ) -> Result<Vec<DiagramColumn>, DiagramError> {
        let compute = if self.with_errors { compute_section_with_errors } else { compute_section };
        let mut columns: Vec<DiagramColumn> = Vec::with_capacity(values.len());
        for &value in values {
            let equation = self.equation_at(value)?;
            let cut = &self.section_at(cut, value)?;
            let last = columns.last().and_then(|column| column.section.points.last());
            let from = match (continuation, last) {
                (Continuation::LastState, Some(last)) => continued(last, cut, &equation),
                _ => start.clone(),
            };
            let section = compute(&equation, &from, cut, self.points, effort, &watch.part())?;
            if section.stopped == Some(SectionEnding::Stopped(Cause::Interrupted)) {
                break;
            }
            columns.push(DiagramColumn { value, section });
            if watch.reached(columns.len()).is_err() {
                break;
            }
        }
        Ok(columns)
    }

    /// Computes the motions of all values in lanes.
    fn side_by_side(
        &self,
        cut: &Section,
        values: &[f64],
        start: &Moment,
        effort: &Effort,
        watch: &Watch<'_>,
    ) -> Result<Vec<DiagramColumn>, DiagramError> {
        let system = System::with_parameters(self.equation, &[self.parameter]).map_err(SectionError::from)?;
        let times: Vec<Vec<f64>> =
            values.iter().map(|&value| self.flashes_at(value, cut, start)).collect::<Result<_, _>>()?;
        let pairs = values.iter().zip(&times);
        let trajectories: Vec<Trajectory<'_>> = pairs
            .map(|(&value, times)| Trajectory { start: start.clone(), parameters: vec![value], times })
            .collect();
        let mut done = 0;
        let outcomes = integrate_many_stepwise(&system, &trajectories, effort, |number, step| {
            done += usize::from(times[number].last().is_some_and(|last| step.end() >= *last));
            watch.flow_at(done)
        });
        let columns = values.iter().zip(outcomes).map(|(&value, outcome)| {
            Ok(DiagramColumn { value, section: PoincareSection::of_samples(outcome)? })
        });
        let columns = columns.collect::<Result<Vec<DiagramColumn>, DiagramError>>()?;
        let interrupted = Some(SectionEnding::Stopped(Cause::Interrupted));
        Ok(columns.into_iter().filter(|column| column.section.stopped != interrupted).collect())
    }

    fn flashes_at(&self, value: f64, cut: &Section, start: &Moment) -> Result<Vec<f64>, DiagramError> {
        let equation = self.equation_at(value)?;
        let Section::Stroboscope { period: Some(period), phase } = cut.with_period_of(&equation) else {
            return Err(SectionError::NoPeriod.into());
        };
        Ok(flashes(start.time, period, phase, self.points)?)
    }
}

/// The last state; with a stroboscope at the same phase of the drive, whose period may have changed.
fn continued(last: &Moment, section: &Section, equation: &Equation) -> Moment {
    Moment { time: section.first_flash(equation).unwrap_or(last.time), state: last.state.clone() }
}

/// A number as a formula, exactly.
fn exactly(value: f64) -> Result<Expression, DiagramError> {
    const BITS: usize = 53;
    let exact = BigFloat::from_f64(value, BITS).ok_or(DiagramError::Value(value))?;
    Ok(Expression::Number(exact.to_rational()))
}
