//! Events of an integration: turning points, passages through rest, zeros of any formula.

use crate::arguments::{self, at_commas};
use crate::query_error::{Parameter, QueryError, option};
use libration::expression::{Expression, Function, Symbol};
use libration::systems::{ConditionError, Coordinate, Model};
use libration::taylor::{Contact, Direction, Event, MomentErrors, Occurrence};

/// The events of a question, each with its name.
#[derive(Clone, Debug, Default)]
pub(super) struct Watched {
    kinds: Vec<ListedEvent>,
}

#[derive(Clone, Debug)]
struct ListedEvent {
    name: String,
    formula: Expression,
    /// The coordinate on whose curve the event is marked.
    coordinate: usize,
    direction: Direction,
    /// Count of the event at which the motion ends.
    ends_at: Option<u64>,
}

/// Largest number of crossings that may be awaited, within 32 bits.
const MOST_CROSSINGS: usize = 1_000_000_000;

/// Conditions that end a motion.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct UntilOptions {
    /// End the motion where a formula vanishes or two are equal, such as "x = 0" or theta-0.5; --times limits the search
    #[arg(long, value_name = "EQUATION|EXPR")]
    until: Option<String>,
    /// Direction of the crossings that count for --until: rising, falling, or any
    #[arg(long, value_enum, requires = "until", default_value_t = Way::Any)]
    direction: Way,
    /// End the motion at the n-th crossing that counts for --until
    #[arg(long, value_name = "N", requires = "until", default_value_t = 1, value_parser = arguments::count::<MOST_CROSSINGS>)]
    count: usize,
}

/// The direction of a crossing.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Way {
    Any,
    Rising,
    Falling,
}

/// An event record for the output.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Happening {
    pub(super) time: f64,
    pub(super) kind: String,
    pub(super) state: Vec<f64>,
    /// The values of the columns that were requested.
    pub(super) columns: Option<Vec<f64>>,
    /// Errors of time, state and columns, if they are estimated; NaN if they are not determined.
    pub(super) errors: Option<MomentErrors>,
}

impl Watched {
    /// Reads `turning`, `crossing`, or a formula of coordinates, velocities, parameters and t.
    pub(super) fn read(texts: &[String], until: &UntilOptions, model: &Model) -> Result<Self, QueryError> {
        let mut kinds = vec![];
        for text in texts.iter().flat_map(|texts| at_commas(texts)) {
            match text.trim() {
                "turning" => kinds.extend(of_each(model, "turning", turning)),
                "crossing" => kinds.extend(of_each(model, "crossing", crossing)),
                text => kinds.push(zero_of(&option("events"), text, model)?),
            }
        }
        if let Some(text) = &until.until {
            kinds.push(until.kind(text, model)?);
        }
        Ok(Self { kinds })
    }

    /// The names of the events.
    pub(super) fn names(&self) -> Vec<String> {
        self.kinds.iter().map(ListedEvent::full_name).collect()
    }

    /// The name of the event that ends the motion.
    pub(super) fn until(&self) -> Option<String> {
        self.kinds.iter().find(|kind| kind.ends_at.is_some()).map(ListedEvent::full_name)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.kinds.is_empty()
    }

    pub(super) fn events(&self) -> Vec<Event> {
        let event = |kind: &ListedEvent| Event {
            formula: kind.formula.clone(),
            direction: kind.direction,
            ends_at: kind.ends_at,
        };
        self.kinds.iter().map(event).collect()
    }

    /// The event record with its name, and the kind of contact if zero is touched and not crossed.
    pub(super) fn happening(&self, occurrence: &Occurrence) -> Happening {
        let name = &self.kinds[occurrence.event].name;
        let kind = match occurrence.contact {
            Contact::Rising | Contact::Falling => name.clone(),
            Contact::Grazing => format!("{name}, grazing"),
            Contact::Start => format!("{name}, at the start"),
        };
        Happening {
            time: occurrence.time,
            kind,
            state: occurrence.state.clone(),
            columns: None,
            errors: None,
        }
    }

    /// The coordinate on whose curve an event is marked.
    pub(super) fn coordinate(&self, happening: &Happening) -> usize {
        let of = |kind: &&ListedEvent| {
            happening.kind.split_once(", ").map_or(&*happening.kind, |parts| parts.0) == kind.name
        };
        self.kinds.iter().find(of).map_or(0, |kind| kind.coordinate)
    }
}

impl ListedEvent {
    /// The name, with the direction if not all crossings count.
    fn full_name(&self) -> String {
        let way = match self.direction {
            Direction::Any => "",
            Direction::Rising => ", rising",
            Direction::Falling => ", falling",
        };
        let count = self.ends_at.filter(|count| *count > 1).map(|count| format!(", crossing {count}"));
        format!("{}{way}{}", self.name, count.unwrap_or_default())
    }
}

impl UntilOptions {
    /// An equation, or a formula.
    fn kind(&self, text: &str, model: &Model) -> Result<ListedEvent, QueryError> {
        let direction = match self.direction {
            Way::Any => Direction::Any,
            Way::Rising => Direction::Rising,
            Way::Falling => Direction::Falling,
        };
        let (name, ends_at) = (text.trim().to_owned(), Some(u64::try_from(self.count).unwrap_or(u64::MAX)));
        Ok(ListedEvent { name, direction, ends_at, ..zero_of(&option("until"), text, model)? })
    }
}

/// The event of each coordinate, whose name is added if there are several.
fn of_each(model: &Model, name: &str, formula: fn(&Coordinate) -> Expression) -> Vec<ListedEvent> {
    let several = model.coordinates().len() > 1;
    let kind = |(coordinate, listed): (usize, &Coordinate)| {
        let name = if several { format!("{name} of {}", listed.name) } else { name.to_owned() };
        ListedEvent { name, formula: formula(listed), coordinate, direction: Direction::Any, ends_at: None }
    };
    model.coordinates().iter().enumerate().map(kind).collect()
}

/// The velocity vanishes.
fn turning(coordinate: &Coordinate) -> Expression {
    Expression::Symbol(Symbol::plain(&coordinate.name).with_primes(1))
}

/// The crossing of the equilibrium; for angles in every turn.
fn crossing(coordinate: &Coordinate) -> Expression {
    let position = Box::new(Expression::symbol(&coordinate.name));
    // The shortest decimal of a finite number is a formula.
    let rest = format!("{:?}", coordinate.at_rest).parse().unwrap_or(Expression::from(0));
    let distance = Expression::Subtract(position, Box::new(rest));
    if !coordinate.is_angle() {
        return distance;
    }
    let half = Expression::Divide(Box::new(distance), Box::new(Expression::from(2)));
    Expression::Call(Function::Sin, Box::new(half))
}

fn zero_of(argument: &Parameter, text: &str, model: &Model) -> Result<ListedEvent, QueryError> {
    let formula = model.zero_of(text).map_err(|error| match error {
        ConditionError::Formula(error) => QueryError::usage(
            argument,
            format!("{error}; write turning, crossing, or a formula such as theta - 0.5"),
        ),
        other => QueryError::usage(argument, other),
    })?;
    let name = text.parse().map_or_else(|_| text.to_owned(), |written: Expression| written.to_string());
    Ok(ListedEvent { name, formula, coordinate: 0, direction: Direction::Any, ends_at: None })
}
