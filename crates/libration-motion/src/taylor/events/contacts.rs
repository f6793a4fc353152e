//! Zeros of a formula along a motion, computed on the polynomial of each step.
//!
//! Between the zeros of its derivative a polynomial has at most one zero, and sign changes in Bernstein's
//! basis miss none of these. The side of zero on which the formula is, is passed from step to step. A formula
//! that is close to zero at the end of a step, as at every zero of a |…|, keeps its side until the next step shows
//! whether it crosses zero or returns; only at the end of the motion it counts as a crossing.
//!
//! # Method
//! An event is a zero of a formula on the tape of the system. Formulas with steep terms have separate series for parts of a step, which are
//! compared with the formula (`sharp.rs`), because the length of a step follows from the accelerations alone. The same holds for formulas with a
//! boundary, such as 1/x − 2: parts become shorter towards the pole, the longest first, until they are 2⁻⁴⁰ of the step or number two thousand.
//! A sign change with values that grow on both sides is a pole and not a zero.

use crate::taylor::Contact;
use crate::taylor::step::sign_change::{bernstein, first_sign_change, sign_changes};
use libration_numbers::roots::{Tolerance, zero_between};

/// The state of one formula between steps.
#[derive(Clone, Copy, Debug)]
pub(in crate::taylor) struct Contacts {
    /// The side of zero on which the formula is; none before the first step, and while it vanishes.
    pub(in crate::taylor) side: Option<f64>,
    pub(in crate::taylor) begun: bool,
    /// Time of the last zero.
    pub(in crate::taylor) last: f64,
    /// `true` if the formula was within the tolerance of zero at the end of the step.
    pub(in crate::taylor) near: bool,
    /// Number of zeros that counted, excluding the start.
    pub(in crate::taylor) zeros: u64,
}

/// A step of a formula: Σ cₙτⁿ with τ from zero to one.
#[derive(Clone, Copy, Debug)]
pub(in crate::taylor) struct Stretch<'a> {
    pub(in crate::taylor) coefficients: &'a [f64],
    pub(in crate::taylor) start: f64,
    pub(in crate::taylor) length: f64,
    /// The error of the formula relative to its change.
    pub(in crate::taylor) tolerance: f64,
    /// The rounding error of a formula with a |…|, at whose zeros steps end.
    pub(in crate::taylor) rounding: Option<f64>,
    /// `true` if the motion ends with this step.
    pub(in crate::taylor) is_last: bool,
}

impl<'a> Stretch<'a> {
    /// A step of unit length of a formula without |…|.
    pub(in crate::taylor) fn new(coefficients: &'a [f64], tolerance: f64) -> Self {
        let (rounding, is_last) = (None, false);
        Self { coefficients, start: 0.0, length: 1.0, tolerance, rounding, is_last }
    }

    fn at(&self, tau: f64) -> f64 {
        self.coefficients.iter().rev().fold(0.0, |sum, c| sum * tau + c)
    }

    fn time(&self, tau: f64) -> f64 {
        self.start + tau * self.length
    }

    /// The distance from zero below which a value counts as zero.
    fn blur(&self) -> f64 {
        let kink = self.rounding.map_or(0.0, |rounding| rounding + self.change_in_ulp());
        self.tolerance.max(4.0 * f64::EPSILON) * size(self.coefficients) + kink
    }

    /// A bound of the change of the formula within a unit in the last place of the time.
    fn change_in_ulp(&self) -> f64 {
        let largest = self.start.abs().max(self.time(1.0).abs());
        let slopes: Vec<f64> = self.slopes().collect();
        f64::EPSILON * largest / self.length.abs() * size(&slopes)
    }

    /// The fraction of the step within which a contact is as close to zero as the blur.
    fn width(&self) -> f64 {
        4.0 * self.tolerance.max(f64::EPSILON).sqrt()
    }

    /// The contact at this position, if the next step, or the end of this one, cannot show it better: an extremum next to a kink is none.
    fn touch(&self, position: f64, blur: f64) -> Option<(f64, Contact)> {
        let is_at_kink =
            self.rounding.is_some() && 1.0 - position <= self.width() && self.at(1.0).abs() <= blur;
        (position > 0.0 && !is_at_kink).then(|| (self.time(position), Contact::Grazing))
    }

    /// Returns `true` if the formula is zero in the whole step, to rounding errors.
    fn vanishes(&self) -> bool {
        let is_constant = size(&self.coefficients[1..]) <= 0.0;
        is_constant && self.coefficients[0].abs() <= self.rounding.unwrap_or(0.0)
    }

    /// The positions at which the derivative changes its sign.
    fn extrema(&self) -> Vec<f64> {
        sign_changes(&self.slopes().collect::<Vec<_>>())
    }

    /// The coefficients of the derivative.
    fn slopes(&self) -> impl Iterator<Item = f64> {
        self.coefficients[1..].iter().zip((1..).map(f64::from)).map(|(c, n)| n * c)
    }

    /// The sign of the first extremum, or of the end, that is farther from zero than this error.
    fn side_beyond(&self, error: f64) -> Option<f64> {
        let mut values = self.extrema().into_iter().chain([1.0]).map(|tau| self.at(tau));
        values.find(|value| value.abs() > error).map(f64::signum)
    }

    /// The only zero between two positions at which the formula has different signs.
    fn zero_between(&self, before: f64, behind: f64) -> f64 {
        let negative_behind = self.at(behind) < 0.0;
        let is_before = |tau| (self.at(tau) < 0.0) != negative_behind;
        let ends = [before, behind].map(|tau| (tau, self.at(tau)));
        match zero_between(ends, Tolerance::LAST_BIT, |tau| self.at(tau)) {
            Some(zero) if is_before(zero) => zero.next_up().min(behind),
            Some(zero) => zero,
            None => behind,
        }
    }

    /// The first position in the step at which the formula changes its sign or comes within the blur of zero.
    pub(in crate::taylor) fn first_contact(&self) -> Option<f64> {
        let blur = self.blur();
        if self.keeps_away(blur) {
            return None;
        }
        let touches = self.extrema().into_iter().find(|&tau| self.at(tau).abs() <= blur);
        first_sign_change(self.coefficients).into_iter().chain(touches).reduce(f64::min)
    }

    /// Returns `true` if the formula is farther from zero than the blur in the whole step.
    fn keeps_away(&self, blur: f64) -> bool {
        if self.coefficients[0].abs() > size(&self.coefficients[1..]) + blur {
            return true;
        }
        let form = bernstein(self.coefficients);
        form.iter().all(|c| *c > blur) || form.iter().all(|c| *c < -blur)
    }
}

impl Contacts {
    pub(in crate::taylor) const NONE: Self =
        Self { side: None, begun: false, last: f64::NEG_INFINITY, near: false, zeros: 0 };

    /// The zeros in a step, with their times in the order of the step. At the beginning of the motion, a formula below its error counts as zero.
    pub(in crate::taylor) fn zeros_in(
        &mut self,
        stretch: &Stretch<'_>,
        error_at_start: impl Fn() -> f64,
    ) -> Vec<(f64, Contact)> {
        if stretch.coefficients.is_empty() {
            // After a pole the sign is arbitrary.
            (self.side, self.near) = (None, false);
            return vec![];
        }
        if stretch.length.abs() <= 0.0 {
            return vec![];
        }
        if stretch.vanishes() {
            return self.comes_to_rest(stretch);
        }
        let blur = stretch.blur();
        let mut zeros = self.at_start(stretch, blur, error_at_start);
        let is_kinked = stretch.rounding.is_some();
        if !(self.near && is_kinked) && stretch.keeps_away(blur) {
            self.near = false;
            return zeros;
        }
        self.inside(stretch, blur, &mut zeros);
        self.near = stretch.at(1.0).abs() <= blur;
        if let Some((time, _)) = zeros.last() {
            self.last = *time;
        }
        zeros.extend(self.at_end(stretch));
        zeros
    }

    /// The crossing of a formula that is close to zero at the end of the motion, which no further step shows.
    fn at_end(&self, stretch: &Stretch<'_>) -> Option<(f64, Contact)> {
        let end = stretch.time(1.0);
        let is_open = stretch.is_last && self.near && !self.just_found(stretch, end);
        let side = self.side.filter(|_| is_open)?;
        let approaches = stretch.slopes().sum::<f64>() * side < 0.0;
        (approaches || stretch.rounding.is_some()).then_some((end, crossing(-side)))
    }

    /// Handles a formula that vanishes throughout a step: the event is the transition to zero.
    fn comes_to_rest(&mut self, stretch: &Stretch<'_>) -> Vec<(f64, Contact)> {
        self.begun = true;
        let is_repeated = self.just_found(stretch, stretch.start);
        self.near = false;
        let side = self.side.take().filter(|_| !is_repeated);
        side.map(|side| (stretch.start, crossing(-side))).into_iter().collect()
    }

    /// The contacts at the beginning of the step.
    fn at_start(
        &mut self,
        stretch: &Stretch<'_>,
        blur: f64,
        error_at_start: impl Fn() -> f64,
    ) -> Vec<(f64, Contact)> {
        let first = stretch.coefficients[0];
        let begun = std::mem::replace(&mut self.begun, true);
        let Some(side) = self.side else {
            let error = if begun { blur } else { error_at_start() };
            let error = if error.is_finite() { error } else { 0.0 };
            let is_zero = first.abs() <= error;
            self.side = if is_zero { stretch.side_beyond(error) } else { Some(first.signum()) };
            return if is_zero && !begun { vec![(stretch.start, Contact::Start)] } else { vec![] };
        };
        if first.abs() > blur && first * side < 0.0 && !(self.near && stretch.rounding.is_some()) {
            // A formula with a jump.
            self.side = Some(-side);
            return vec![(stretch.start, crossing(-side))];
        }
        vec![]
    }

    /// Returns `true` if a time is within the blur of the last zero.
    fn just_found(&self, stretch: &Stretch<'_>, time: f64) -> bool {
        (time - self.last).abs() <= stretch.width() * stretch.length.abs()
    }

    /// Finds the contacts after the start, from extremum to extremum, and the one at the start that the last step left open.
    fn inside(&mut self, stretch: &Stretch<'_>, blur: f64, contacts: &mut Vec<(f64, Contact)>) {
        let Some(mut side) = self.side else { return };
        let mut before = 0.0;
        let is_kinked = stretch.rounding.is_some();
        let first = &stretch.coefficients[..2];
        let is_near = is_kinked || first[0].abs() <= blur && first[1] * side > 0.0;
        let is_open = self.near && is_near && contacts.is_empty() && !self.just_found(stretch, stretch.start);
        let mut touched = is_open.then_some(0.0);
        let nodes = stretch.extrema().into_iter().map(|node| (node, true)).chain([(1.0, false)]);
        for (node, is_extremum) in nodes {
            let value = stretch.at(node);
            let is_near = value.abs() <= blur;
            if is_near && is_extremum {
                // At a kink the series of the formula has a double zero up to rounding errors.
                touched = touched.filter(|tau| *tau > 0.0 || is_kinked).or(Some(node));
            } else if is_near && is_kinked {
                // The end: the next step shows what follows.
            } else if value * side > 0.0 {
                contacts.extend(touched.take().map(|tau| (stretch.time(tau), Contact::Grazing)));
            } else if value * side < 0.0 {
                side = -side;
                let inner = touched.take().filter(|&tau| tau > 0.0);
                let zero = inner.unwrap_or_else(|| self.zero(stretch, before, node, side));
                contacts.push((stretch.time(zero), crossing(side)));
            }
            before = node;
        }
        contacts.extend(touched.and_then(|tau| stretch.touch(tau, blur)));
        self.side = Some(side);
    }

    /// The zero before a position at which the formula has this sign; at the beginning rounding may give the formula this sign already.
    fn zero(&self, stretch: &Stretch<'_>, before: f64, node: f64, side: f64) -> f64 {
        if stretch.at(before) * side >= 0.0 { before } else { stretch.zero_between(before, node) }
    }
}

/// The sum of the magnitudes of some coefficients.
fn size(coefficients: &[f64]) -> f64 {
    coefficients.iter().map(|c| c.abs()).sum()
}

/// The kind of zero after which a formula has this sign.
fn crossing(side: f64) -> Contact {
    if side > 0.0 { Contact::Rising } else { Contact::Falling }
}
