//! Positions of the bodies of a system.

use crate::taylor::Moment;
use libration_numbers::algebra::Doubles;
use libration_numbers::{
    expression::{Expression, Symbol, WithoutValue},
    internals::expression::{Jet, Tape},
};

/// The bodies of a system in the vertical plane and their supports, for drawing.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::systems::Model;
/// use libration::taylor::Moment;
/// let double = Model::by_key("double_pendulum", &[("l2", "1/2".parse()?)], &[])?;
/// let bodies = double.bodies().expect("the catalogue says where they are");
/// let quarter = std::f64::consts::FRAC_PI_2;
/// let [upper, lower] = bodies.at(&Moment { time: 0.0, state: vec![quarter, 0.0, 0.0, 0.0] })[..] else { panic!() };
/// assert_eq!(upper.pivot, [0.0, 0.0]);
/// assert!((upper.place[0] - 1.0).abs() < 1e-15 && (lower.place[1] + 0.5).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Bodies {
    coordinates: usize,
    tape: Tape,
}

/// A body at a time: coordinates to the right and upwards, in metres if the system has metres, and otherwise in lengths of the rod.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// The position of the body.
    pub place: [f64; 2],
    /// The position of the other end of the rod or the spring that holds the body.
    pub pivot: [f64; 2],
}

impl Bodies {
    /// The bodies whose positions are given by these formulas, in these names of coordinates.
    pub(super) fn new(places: &[[[Expression; 2]; 2]], names: &[Symbol]) -> Result<Self, WithoutValue> {
        let formulas: Vec<&Expression> = places.iter().flatten().flatten().collect();
        let time = [Symbol::plain("t")];
        let inputs: Vec<Symbol> = names.iter().cloned().chain(time).collect();
        Ok(Self { coordinates: names.len(), tape: Tape::new(&formulas, &inputs)? })
    }

    /// The bodies in a state; NaN if a formula has no value.
    #[must_use]
    pub fn at(&self, moment: &Moment) -> Vec<Body> {
        let inputs: Vec<f64> =
            moment.state[..self.coordinates].iter().copied().chain([moment.time]).collect();
        let formulas = self.tape.results().len();
        let values: Vec<f64> = match Jet::new(&Doubles, &self.tape, &inputs) {
            Ok(jet) => (0..formulas).map(|formula| jet.result(formula)[0]).collect(),
            Err(_) => vec![f64::NAN; formulas],
        };
        let body = |four: &[f64; 4]| Body { place: [four[0], four[1]], pivot: [four[2], four[3]] };
        values.as_chunks().0.iter().map(body).collect()
    }
}
