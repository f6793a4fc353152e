//! What is looked for on the way: turning points, passages through rest, zeros of any formula.

use crate::failure::Failure;
use libration::expression::{Expression, Function, Symbol};
use libration::systems::{Coordinate, Model};
use libration::taylor::{Contact, Event, Occurrence};

/// The events of a question, each with its name.
#[derive(Clone, Debug, Default)]
pub(super) struct Watched {
    kinds: Vec<Kind>,
}

#[derive(Clone, Debug)]
struct Kind {
    name: String,
    formula: Expression,
    /// The coordinate on whose curve it is marked.
    coordinate: usize,
}

/// An event as it is written.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Happening {
    pub(super) time: f64,
    pub(super) kind: String,
    pub(super) state: Vec<f64>,
}

impl Watched {
    /// Reads `turning`, `crossing`, or a formula of coordinates, velocities, parameters and t.
    pub(super) fn read(texts: &[String], model: &Model) -> Result<Self, Failure> {
        let mut kinds = vec![];
        for text in texts {
            match text.trim() {
                "turning" => kinds.extend(of_each(model, "turning", turning)),
                "crossing" => kinds.extend(of_each(model, "crossing", crossing)),
                text => kinds.push(zero_of(text, model)?),
            }
        }
        Ok(Self { kinds })
    }

    /// What is looked for, by name.
    pub(super) fn names(&self) -> Vec<String> {
        self.kinds.iter().map(|kind| kind.name.clone()).collect()
    }

    pub(super) fn is_empty(&self) -> bool {
        self.kinds.is_empty()
    }

    pub(super) fn events(&self) -> Vec<Event> {
        self.kinds.iter().map(|kind| Event::zero_of(kind.formula.clone())).collect()
    }

    /// The event with its name, and how it touched zero if not by passing it.
    pub(super) fn happening(&self, occurrence: &Occurrence) -> Happening {
        let name = &self.kinds[occurrence.event].name;
        let kind = match occurrence.contact {
            Contact::Rising | Contact::Falling => name.clone(),
            Contact::Grazing => format!("{name}, grazing"),
            Contact::Start => format!("{name}, at the start"),
        };
        Happening { time: occurrence.time, kind, state: occurrence.state.clone() }
    }

    /// The coordinate on whose curve an event is marked.
    pub(super) fn coordinate(&self, happening: &Happening) -> usize {
        let of =
            |kind: &&Kind| happening.kind.split_once(", ").map_or(&*happening.kind, |it| it.0) == kind.name;
        self.kinds.iter().find(of).map_or(0, |kind| kind.coordinate)
    }
}

/// The event for each coordinate, whose name is added where there are several.
fn of_each(model: &Model, name: &str, formula: fn(&Coordinate) -> Expression) -> Vec<Kind> {
    let several = model.coordinates().len() > 1;
    let kind = |(coordinate, it): (usize, &Coordinate)| {
        let name = if several { format!("{name} of {}", it.name) } else { name.to_owned() };
        Kind { name, formula: formula(it), coordinate }
    };
    model.coordinates().iter().enumerate().map(kind).collect()
}

/// The velocity vanishes.
fn turning(coordinate: &Coordinate) -> Expression {
    Expression::Symbol(Symbol::plain(&coordinate.name).with_primes(1))
}

/// The place of rest is passed; for angles in every turn.
fn crossing(coordinate: &Coordinate) -> Expression {
    let place = Box::new(Expression::symbol(&coordinate.name));
    // The shortest decimal of a finite number is a formula.
    let rest = format!("{:?}", coordinate.at_rest).parse().unwrap_or(Expression::from(0));
    let distance = Expression::Subtract(place, Box::new(rest));
    if !coordinate.is_angle() {
        return distance;
    }
    let half = Expression::Divide(Box::new(distance), Box::new(Expression::from(2)));
    Expression::Call(Function::Sin, Box::new(half))
}

fn zero_of(text: &str, model: &Model) -> Result<Kind, Failure> {
    let written: Expression = text.parse().map_err(|error| {
        Failure::usage(
            "--events",
            format!("{error}; write turning, crossing, or a formula such as theta - 0.5"),
        )
    })?;
    let values = model.values().iter();
    let formula = values
        .fold(written.clone(), |formula, (name, value)| formula.substitute(&Symbol::plain(name), value));
    let known = model.state_names();
    let in_state = model.equation().with_rates(&formula);
    let unknown = in_state.symbols().into_iter().map(|symbol| symbol.to_string());
    if let Some(name) = unknown.into_iter().find(|name| name != "t" && !known.contains(name)) {
        let reason =
            format!("the system has no state variable `{name}`: it has {}, and the time t", known.join(", "));
        return Err(Failure::usage("--events", reason));
    }
    Ok(Kind { name: written.to_string(), formula, coordinate: 0 })
}
