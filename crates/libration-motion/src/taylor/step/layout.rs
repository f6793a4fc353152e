//! Order of the state components.

use libration_numbers::expression::{Equation, Order, Symbol};

/// The order of the components of a state: all coordinates in the order of their equations, then the velocities of those whose equation is of
/// second order. All code that reads or creates states takes the indices from here.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::taylor::StateLayout;
/// let thermostat = StateLayout::new(&"x'' = -x - z*x'; z' = x'^2 - 1".parse()?);
/// assert_eq!((thermostat.coordinates(), thermostat.numbers()), (2, 3));
/// assert_eq!((thermostat.velocity(0), thermostat.velocity(1)), (Some(2), None));
/// assert_eq!((thermostat.driven(0), thermostat.driven(1)), (2, 1));
/// # Ok::<(), libration::expression::EquationError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StateLayout {
    /// Index of the velocity of each coordinate.
    velocities: Vec<Option<usize>>,
    /// Index of the coordinate of each velocity, in order.
    accelerated: Vec<usize>,
}

impl StateLayout {
    /// The layout of the states of some equations.
    #[must_use]
    pub fn new(equation: &Equation) -> Self {
        Self::of_orders(equation.orders())
    }

    /// The layout of one coordinate and its velocity.
    pub(crate) fn one_coordinate() -> Self {
        Self::of_orders(&[Order::Second])
    }

    fn of_orders(orders: &[Order]) -> Self {
        let coordinates = orders.len();
        let is_accelerated = |coordinate: &usize| orders[*coordinate] == Order::Second;
        let accelerated: Vec<usize> = (0..coordinates).filter(is_accelerated).collect();
        let mut velocities = vec![None; coordinates];
        for (number, &coordinate) in (coordinates..).zip(&accelerated) {
            velocities[coordinate] = Some(number);
        }
        Self { velocities, accelerated }
    }

    /// The number of coordinates.
    #[must_use]
    #[inline(always)]
    pub fn coordinates(&self) -> usize {
        self.velocities.len()
    }

    /// The number of state components.
    #[must_use]
    #[inline(always)]
    pub fn numbers(&self) -> usize {
        self.velocities.len() + self.accelerated.len()
    }

    /// The number of the velocity of a component; `None` for velocities, and for coordinates whose equation is of first order.
    #[must_use]
    #[inline(always)]
    pub fn velocity(&self, number: usize) -> Option<usize> {
        self.velocities.get(number).copied().flatten()
    }

    /// The component whose rate of change the equation of a coordinate gives: its velocity, or the coordinate itself.
    #[must_use]
    #[inline(always)]
    pub fn driven(&self, coordinate: usize) -> usize {
        self.velocity(coordinate).unwrap_or(coordinate)
    }

    /// The coordinate whose equation gives the rate of change of a component; `None` for coordinates that have a velocity.
    #[must_use]
    pub fn driving(&self, number: usize) -> Option<usize> {
        match number.checked_sub(self.coordinates()) {
            Some(velocity) => self.accelerated.get(velocity).copied(),
            None => Some(number).filter(|&coordinate| self.velocity(coordinate).is_none()),
        }
    }

    /// Returns `true` if a component is a velocity.
    #[must_use]
    #[inline(always)]
    pub fn is_velocity(&self, number: usize) -> bool {
        number >= self.coordinates()
    }

    /// Returns `true` if every coordinate has a velocity.
    #[must_use]
    pub fn is_of_second_order(&self) -> bool {
        self.accelerated.len() == self.coordinates()
    }

    /// One item for each state component, from those of the coordinates and those of their velocities.
    pub fn arrange<T>(
        &self,
        coordinates: impl IntoIterator<Item = T>,
        velocity: impl Fn(usize) -> T,
    ) -> Vec<T> {
        coordinates
            .into_iter()
            .chain(self.accelerated.iter().map(|&coordinate| velocity(coordinate)))
            .collect()
    }

    /// The symbols of the components: the names of the variables, with a prime for velocities.
    #[must_use]
    pub fn symbols(&self, variables: &[String]) -> Vec<Symbol> {
        let velocity = |coordinate: usize| Symbol::plain(&variables[coordinate]).with_primes(1);
        self.arrange(variables.iter().map(|name| Symbol::plain(name)), velocity)
    }

    /// The index of a state component in the state of the equations followed by copies of them, such as those of
    /// [`with_tangents`](crate::taylor::with_tangents): in the equations themselves, copy 0, or in one of the copies.
    #[must_use]
    pub fn place_in_copy(&self, number: usize, copy: usize, copies: usize) -> usize {
        let coordinates = self.coordinates();
        match number.checked_sub(coordinates) {
            None => coordinates * copy + number,
            Some(velocity) => coordinates * (1 + copies) + self.accelerated.len() * copy + velocity,
        }
    }
}
