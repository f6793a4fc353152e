//! What is known of a system that has a name.

use super::{UnknownSystem, catalogue};
use crate::quantity::{excerpt, nearest};

/// A system of the literature, as data.
///
/// # Examples
/// ```
/// use libration::systems::{Model, NamedSystem};
/// let named = NamedSystem::by_key("damped_pendulum")?;
/// let model = Model::named(named, &[("c", "0.1".parse()?), ("n", "2".parse()?)], &[])?;
/// assert_eq!(model.equation().to_string(), "theta'' + 0.1*(theta'*abs(theta')) + sin(theta) = 0");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct NamedSystem {
    /// The name it is asked for by.
    pub key: &'static str,
    /// Other names for it.
    pub also: &'static [&'static str],
    /// What it is called in a sentence.
    pub title: &'static str,
    /// Its equations of motion, several with `;` between them.
    pub equations: &'static str,
    /// Its coordinates, in the order of the equations.
    pub coordinates: &'static [NamedCoordinate],
    /// The parameters in the equations. Their default values leave out all damping and driving.
    pub parameters: &'static [Parameter],
    /// Its energy as a formula of coordinates, velocities and parameters.
    pub energy: &'static str,
    /// The unit of the energy, which says what it is divided by.
    pub energy_unit: &'static str,
    /// What the energy gains per time: `0` where it is conserved.
    pub power: &'static str,
    /// The parameter that is the angular frequency of a periodic drive.
    pub drive_frequency: Option<&'static str>,
    /// Whether the parameter n is a power of a velocity, which has to be whole: others have no derivatives at rest.
    pub whole_powers: bool,
    /// What it describes, and how the coordinates are measured.
    pub description: &'static str,
    /// For which motions and parameters it holds.
    pub domain: &'static str,
    /// Where it comes from; `attributed to` where that is not read but remembered.
    pub source: &'static str,
}

/// A coordinate of a named system.
#[derive(Clone, Copy, Debug)]
pub struct NamedCoordinate {
    /// Its name in the equations.
    pub name: &'static str,
    /// Its unit: `rad` for angles.
    pub unit: &'static str,
    /// Where it is at rest, as a formula of the parameters.
    pub rest: &'static str,
}

/// A parameter of a named system.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// Its name in the equations.
    pub name: &'static str,
    /// The value it has unless another is given.
    pub default: &'static str,
    /// Its unit; `1` for pure numbers.
    pub unit: &'static str,
    /// What it stands for.
    pub meaning: &'static str,
}

impl NamedSystem {
    /// The system of this key.
    ///
    /// # Errors
    /// No system has this key; the error lists the nearest keys and all of them.
    pub fn by_key(key: &str) -> Result<&'static Self, UnknownSystem> {
        let found = catalogue().find(|named| named.keys().any(|known| known == key));
        found.ok_or_else(|| UnknownSystem {
            key: excerpt(key),
            near: nearest(&excerpt(key), catalogue().flat_map(Self::keys)),
            known: catalogue().map(|named| named.key).collect(),
        })
    }

    /// The key and the other names.
    pub(super) fn keys(&self) -> impl Iterator<Item = &'static str> {
        std::iter::once(self.key).chain(self.also.iter().copied())
    }
}
