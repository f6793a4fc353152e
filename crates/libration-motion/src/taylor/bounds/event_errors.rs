//! Errors of samples and events, with those of the formulas there.

use super::crossing::{Crossing, Passing};
use super::roundings_of_steps::terms;
use super::spread::Spread;
use crate::taylor::events::sharp::SHORTEST_PART;
use crate::taylor::program::linearised::ROUNDING;
use crate::taylor::{AcceptedStep, Contact, Moment, Occurrence, StateErrors, System};

/// The errors of one sample or event.
#[derive(Clone, Debug, PartialEq)]
pub struct MomentErrors {
    /// The error of the time; zero in samples.
    pub time: f64,
    /// The error of each component of the state.
    pub state: Vec<f64>,
    /// The errors of the formulas of [`StateErrors::with_formulas`]; NaN if a formula has no value.
    pub formulas: Vec<f64>,
}

/// The passage of the formula of an event through zero.
struct ZeroPassage {
    spread: Spread,
    passing: Passing,
    /// The square root of the number of steps.
    scale: f64,
    /// The error of the formula besides that of the state.
    error: f64,
    /// The error of the time.
    late: f64,
    /// `true` if the formula nearly touches zero, or has touched it.
    is_bent: bool,
}

impl StateErrors {
    /// The errors at the start: those of the formulas are rounding errors.
    #[must_use]
    pub fn at_start(&mut self) -> MomentErrors {
        let formulas = self.formulas.as_mut().map(|formulas| formulas.roundings(&self.start));
        MomentErrors {
            time: 0.0,
            state: vec![0.0; self.scales.len()],
            formulas: formulas.unwrap_or_default(),
        }
    }

    /// The errors of a sample in the last step; `None` if the motion is not determined.
    #[must_use]
    pub fn of_sample(&mut self, accepted: &AcceptedStep<'_>, sample: &Moment) -> Option<MomentErrors> {
        if (sample.time - self.start.time).abs() <= 0.0 {
            return Some(self.at_start());
        }
        let state = self.at(sample)?;
        let Some(mut formulas) = self.formulas.take() else {
            return Some(MomentErrors { time: 0.0, state, formulas: vec![] });
        };
        let spread = self.spread_at(accepted.stepper(), accepted.step(), sample.time);
        let scale = self.steps.sqrt();
        let of = Moment { time: 0.0, state };
        let errors = formulas.errors(sample, &of, |gradient, _| scale * spread.of_sum(gradient));
        self.formulas = Some(formulas);
        Some(MomentErrors { time: 0.0, state: of.state, formulas: errors })
    }

    /// The errors of an event in the last step; `None` if the motion is not determined.
    #[must_use]
    pub fn of_event(&mut self, accepted: &AcceptedStep<'_>, event: &Occurrence) -> Option<MomentErrors> {
        if self.is_lost {
            return None;
        }
        if event.contact == Contact::Start || (event.time - self.start.time).abs() <= 0.0 {
            return Some(self.at_start());
        }
        let Some(passage) = self.passage(accepted, event) else {
            let unknown = |count: usize| vec![f64::NAN; count];
            let formulas = self.formulas.as_ref().map_or(0, |formulas| formulas.count());
            let (state, formulas) = (unknown(self.scales.len()), unknown(formulas));
            return Some(MomentErrors { time: f64::NAN, state, formulas });
        };
        let of = passage.of_state(event);
        let at = Moment { time: event.time, state: event.state.clone() };
        let formulas = self.formulas.as_mut().map(|formulas| {
            formulas.errors(&at, &of, |gradient, by_time| {
                let along = gradient.iter().zip(&passage.passing.speeds).map(|(slope, speed)| slope * speed);
                passage.of(gradient, by_time + along.sum::<f64>())
            })
        });
        Some(MomentErrors { time: of.time, state: of.state, formulas: formulas.unwrap_or_default() })
    }

    fn passage(&mut self, accepted: &AcceptedStep<'_>, event: &Occurrence) -> Option<ZeroPassage> {
        let (stepper, step) = (accepted.stepper(), accepted.step());
        let spread = self.spread_at(stepper, step, event.time);
        let length = step.end() - step.start();
        let sizes = (0..self.scales.len()).map(|number| terms(step, number, 0, length));
        let sizes: Vec<f64> = sizes.collect();
        let (beside, scale) = (length / 1024.0, self.steps.sqrt());
        let formulas = self.crossings(stepper.expander.system, event);
        let moment = |time: f64| Moment { time, state: step.state_at(time) };
        let zero = Crossing::zero_at(formulas, &moment(event.time), &sizes, SHORTEST_PART * length)?;
        let is_at_kink = zero + 1 < formulas.len();
        let mut at = |time: f64| formulas[zero].passing(&moment(time), &sizes);
        let mut there = at(event.time);
        let bend = (at(event.time + beside).rate - at(event.time - beside).rate) / (2.0 * beside);
        if event.contact == Contact::Grazing && !is_at_kink {
            there.error += self.beyond(accepted, event, &there, &sizes, &spread);
        }
        let mut passage = ZeroPassage::new(spread, there, bend, scale);
        let (system, at) = (stepper.expander.system, moment(event.time));
        let of_state = |gradient: &[f64]| passage.scale * passage.spread.of_sum(gradient);
        let late = passage.late;
        let by_contact = self.crossings(system, event)[zero].enclosing_time(&at, &sizes, late, of_state);
        // At a zero of a high order, rounding makes a touch a crossing, and a crossing a touch.
        let contact = if event.contact == Contact::Grazing { Contact::Rising } else { Contact::Grazing };
        let other = Occurrence { contact, ..event.clone() };
        let mut by_other =
            || self.crossings(system, &other).last_mut()?.enclosing_time(&at, &sizes, late, of_state);
        if let Some(enclosing) = by_contact.or_else(&mut by_other).filter(|enclosing| *enclosing > late) {
            (passage.late, passage.is_bent) = (enclosing, true);
        }
        Some(passage)
    }

    /// The error of a rate of change at a contact where the formula itself is known not to be zero, from its distance to the nearest zeros.
    fn beyond(
        &mut self,
        accepted: &AcceptedStep<'_>,
        event: &Occurrence,
        rate: &Passing,
        sizes: &[f64],
        spread: &Spread,
    ) -> f64 {
        let scale = self.steps.sqrt();
        let of_value = Occurrence { contact: Contact::Rising, ..event.clone() };
        let Some(formula) = self.crossings(accepted.stepper().expander.system, &of_value).last_mut() else {
            return 0.0;
        };
        let Passing { gradient, value, error, .. } =
            formula.passing(&Moment { time: event.time, state: event.state.clone() }, sizes);
        let rest = value.abs();
        let is_zero = rest <= error + scale * spread.of_sum(&gradient);
        if is_zero { 0.0 } else { (2.0 * rest * rate.rate.abs()).sqrt() }
    }

    fn crossings(&mut self, system: &System, event: &Occurrence) -> &mut [Crossing] {
        let touches = |contact: Contact| contact == Contact::Grazing;
        let same = |(number, contact, _): &(usize, Contact, Vec<Crossing>)| {
            *number == event.event && touches(*contact) == touches(event.contact)
        };
        let index = self.crossings.iter().position(same).unwrap_or_else(|| {
            self.crossings.push((event.event, event.contact, Crossing::all(system, event)));
            self.crossings.len() - 1
        });
        &mut self.crossings[index].2
    }
}

impl ZeroPassage {
    fn new(spread: Spread, passing: Passing, bend: f64, scale: f64) -> Self {
        let Passing { gradient, rate, value, error, .. } = &passing;
        let error = error + value.abs();
        let off = scale * spread.of_sum(gradient) + error;
        let is_bent = rate * rate <= 4.0 * bend.abs() * off;
        let late = match is_bent {
            true => (rate.abs() + (rate * rate + 2.0 * bend.abs() * off).sqrt()) / bend.abs(),
            false => 2.0 * off / (rate.abs() + (rate * rate - 2.0 * bend.abs() * off).sqrt()),
        };
        Self { spread, passing, scale, error, late, is_bent }
    }

    /// The error of a quantity with these derivatives by the state, which changes at this rate along the motion.
    fn of(&self, gradient: &[f64], along: f64) -> f64 {
        let Self { spread, passing, scale, error, late, is_bent } = self;
        if *is_bent {
            return scale * spread.of_sum(gradient) + along.abs() * late;
        }
        let factors = gradient.iter().zip(&passing.gradient);
        let factors = factors.map(|(derivative, slope)| derivative - along * slope / passing.rate);
        scale * spread.of_sum(&factors.collect::<Vec<_>>()) + (along * error / passing.rate).abs()
    }

    /// The errors of time and state.
    fn of_state(&self, event: &Occurrence) -> Moment {
        let mut unit = vec![0.0; event.state.len()];
        let of_number = |(number, (speed, value)): (usize, (&f64, &f64))| {
            unit[number] = 1.0;
            let moved = self.of(&unit, *speed);
            unit[number] = 0.0;
            moved + ROUNDING * (value.abs() + (speed * event.time).abs())
        };
        let state = self.passing.speeds.iter().zip(&event.state).enumerate().map(of_number).collect();
        Moment { time: self.late + ROUNDING * event.time.abs(), state }
    }
}
