//! Stable equilibria, with or without an expansion of the force.

use super::constant::Constant;
use super::equilibrium::{candidates, given, refined, vanishes_at};
use super::force::Force;
use super::model::{MOST_PLACES, force};
use super::neighbourhood::{Neighbourhood, Tendency};
use libration_numbers::algebra::Rational;
use libration_numbers::expression::{Equation, Expression};

/// The equilibrium nearest to zero, or the one next to a given position, towards which the force at rest points from both sides: the point from
/// which amplitudes count. x″ = −(x − 1)³ has one, though it has no expansion.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::oscillator::centre_of;
/// let centre = centre_of(&"x'' = -(x - 1)^3".parse()?, None).ok_or("no centre")?;
/// assert_eq!(centre.to_f64(), 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn centre_of(equation: &Equation, about: Option<&Expression>) -> Option<Constant> {
    let force = force(equation).ok().filter(|_| equation.parameters().is_empty())?;
    let drives_back = |centre: &Constant| {
        let at_rest = force.at_rest();
        let about = Neighbourhood::new(&at_rest, &force.x, centre);
        about.and_then(|about| about.tendency()) == Some(Tendency::Back)
    };
    match about {
        Some(point) => given(&force, point).filter(drives_back),
        None => places(&force).find(drives_back),
    }
}

/// The positions at which the force at rest vanishes, zero before all others.
fn places(force: &Force) -> impl Iterator<Item = Constant> {
    let zero = Rational::from(0);
    let at_zero = vanishes_at(force, &zero).then_some(Constant::Exact(zero));
    let others = candidates(force).near.into_iter().take(MOST_PLACES);
    at_zero.into_iter().chain(others.filter_map(|near| refined(force, near)))
}
