//! Order of the parameters of a fit.

use super::{DampingModel, Parameter, ParameterKind};
use crate::measurement::{Observable, Trace};

/// The order of the parameters: ω0, the coefficients of the damping and the scale, which all traces share, then offset,
/// first angle and first velocity of each trace.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    terms: DampingModel,
    traces: usize,
}

impl Layout {
    pub(super) const OMEGA0: usize = 0;
    const OWN: usize = 3;

    pub(super) fn new(terms: DampingModel, traces: usize) -> Self {
        Self { terms, traces }
    }

    pub(super) fn terms(&self) -> DampingModel {
        self.terms
    }

    pub fn len(&self) -> usize {
        self.scale() + 1 + Self::OWN * self.traces
    }

    pub(super) fn coefficients(&self) -> std::ops::Range<usize> {
        1..1 + self.terms.count()
    }

    /// Index of the scale: measured radians per radian.
    pub fn scale(&self) -> usize {
        1 + self.terms.count()
    }

    pub fn offset(&self, trace: usize) -> usize {
        self.scale() + 1 + Self::OWN * trace
    }

    /// Indices of first angle and first velocity.
    pub(super) fn first_state(&self, trace: usize) -> [usize; 2] {
        [1, 2].map(|step| self.offset(trace) + step)
    }

    /// The indices of the parameters with respect to which the motion of a trace is differentiated, in the order of [`Seen`](super::swing::Seen).
    pub(super) fn of_motion(&self, trace: usize) -> impl Iterator<Item = usize> {
        [Self::OMEGA0].into_iter().chain(self.coefficients()).chain(self.first_state(trace))
    }

    /// The parameters of a model that is a part of this one, with zero coefficients for the other terms.
    pub(super) fn with_terms_of(&self, part: DampingModel, parameters: &[f64]) -> Vec<f64> {
        let given: Vec<_> = part.iter().zip(&parameters[1..]).collect();
        let coefficient =
            |term| given.iter().find(|(other, _)| *other == term).map_or(0.0, |(_, value)| **value);
        let coefficients = self.terms.iter().map(coefficient);
        let others = parameters[1 + part.count()..].iter().copied();
        [parameters[Self::OMEGA0]].into_iter().chain(coefficients).chain(others).collect()
    }

    /// Kind, unit and trace of a parameter.
    pub(super) fn described(&self, index: usize, traces: &[Trace]) -> Parameter {
        let of_trace =
            index.checked_sub(self.offset(0)).map(|offset| (offset / Self::OWN, offset % Self::OWN));
        let term = index.checked_sub(1).and_then(|number| self.terms.iter().nth(number));
        let (kind, unit) = match (of_trace, term) {
            (None, _) if index == Self::OMEGA0 => (ParameterKind::NaturalFrequency, "rad/s"),
            (None, Some(term)) => (ParameterKind::Damping(term), term.unit()),
            (None, None) => (ParameterKind::Scale, "1"),
            (Some((trace, 0)), _) if traces[trace].observable() == Observable::AngularVelocity => {
                (ParameterKind::Offset, "rad/s")
            }
            (Some((_, 0)), _) => (ParameterKind::Offset, "rad"),
            (Some((_, 1)), _) => (ParameterKind::FirstAngle, "rad"),
            (Some(_), _) => (ParameterKind::FirstVelocity, "rad/s"),
        };
        Parameter { kind, unit, trace: of_trace.map(|(trace, _)| trace), ..Parameter::default() }
    }
}
