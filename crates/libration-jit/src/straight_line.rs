//! Arithmetic without loops and branches.

/// One step of a [`StraightLine`]. Every step except `Keep` has a value, which later steps name by the number of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Arithmetic {
    /// The content of a slot before the line is run.
    Place(usize),
    /// An argument.
    Argument(usize),
    /// A number.
    Number(f64),
    /// −a.
    Negate(usize),
    /// a + b.
    Add(usize, usize),
    /// a − b.
    Subtract(usize, usize),
    /// a·b.
    Multiply(usize, usize),
    /// a/b.
    Divide(usize, usize),
    /// a·b + c with one rounding.
    MultiplyAdd(usize, usize, usize),
    /// The [`inner_product`](crate::inner_product) of the values in consecutive slots.
    InnerProduct {
        /// The first slot of the first factor.
        a: usize,
        /// The first slot of the second factor, which is taken in reverse order.
        b: usize,
        /// Number of slots of each factor.
        count: usize,
    },
    /// Stores a value in a slot.
    Keep {
        /// The value.
        value: usize,
        /// The slot.
        slot: usize,
    },
}

impl Arithmetic {
    /// The values that the step needs.
    pub(crate) fn operands(&self) -> impl Iterator<Item = usize> + use<> {
        let operands = match *self {
            Self::Place(_) | Self::Argument(_) | Self::Number(_) | Self::InnerProduct { .. } => [None; 3],
            Self::Negate(a) | Self::Keep { value: a, .. } => [Some(a), None, None],
            Self::Add(a, b) | Self::Subtract(a, b) | Self::Multiply(a, b) | Self::Divide(a, b) => {
                [Some(a), Some(b), None]
            }
            Self::MultiplyAdd(a, b, c) => [Some(a), Some(b), Some(c)],
        };
        operands.into_iter().flatten()
    }

    /// The slots that an inner product reads.
    pub(crate) fn read(&self) -> impl Iterator<Item = usize> + use<> {
        let ranges = match *self {
            Self::InnerProduct { a, b, count } => [a..a.saturating_add(count), b..b.saturating_add(count)],
            _ => [0..0, 0..0],
        };
        ranges.into_iter().flatten()
    }
}

/// Consecutive arithmetic steps on slots in memory, and on arguments, which stay unchanged.
#[derive(Clone, Debug, PartialEq)]
pub struct StraightLine {
    steps: Vec<Arithmetic>,
    places: usize,
    arguments: usize,
}

/// A step that cannot be done in its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutOfOrder {
    /// The number of the step.
    pub step: usize,
}

impl std::fmt::Display for OutOfOrder {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let why =
            "needs a value that no step before has, a place that is not there, or one that was kept before";
        write!(f, "step {} {why}", self.step)
    }
}

impl std::error::Error for OutOfOrder {}

impl StraightLine {
    /// Creates a line from its steps and its numbers of slots and arguments.
    ///
    /// # Errors
    /// A step with an operand that is not the value of an earlier step; a slot or argument that does not exist; a slot read as its initial
    /// content after a value was stored in it; a second value stored in the same slot, or a value stored where an inner product has read.
    pub fn new(steps: Vec<Arithmetic>, places: usize, arguments: usize) -> Result<Self, OutOfOrder> {
        let (mut kept, mut read) = (vec![false; places], vec![false; places]);
        for (number, step) in steps.iter().enumerate() {
            let is_known = |operand: usize| match steps[..number].get(operand) {
                Some(Arithmetic::Place(slot)) => !kept[*slot],
                Some(Arithmetic::Keep { .. }) | None => false,
                Some(_) => true,
            };
            let are_known = step.operands().all(is_known);
            let is_there = match *step {
                Arithmetic::Place(slot) => kept.get(slot).is_some_and(|kept| !kept),
                Arithmetic::Keep { slot, .. } => {
                    kept.get_mut(slot).is_some_and(|kept| !std::mem::replace(kept, true)) && !read[slot]
                }
                Arithmetic::InnerProduct { a, b, count } => {
                    let is_inside = |first: usize| first.checked_add(count).is_some_and(|end| end <= places);
                    let are_inside = is_inside(a) && is_inside(b);
                    step.read().filter(|_| are_inside).for_each(|slot| read[slot] = true);
                    are_inside
                }
                Arithmetic::Argument(argument) => argument < arguments,
                _ => true,
            };
            if !(are_known && is_there) {
                return Err(OutOfOrder { step: number });
            }
        }
        Ok(Self { steps, places, arguments })
    }

    /// The steps of the line.
    #[must_use]
    pub fn steps(&self) -> &[Arithmetic] {
        &self.steps
    }

    /// The number of slots.
    #[must_use]
    pub fn places(&self) -> usize {
        self.places
    }

    /// The number of arguments.
    #[must_use]
    pub fn arguments(&self) -> usize {
        self.arguments
    }
}
