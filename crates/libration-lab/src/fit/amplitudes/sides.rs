//! The sides of turning points.

/// Sides of the equilibrium on which the rows were read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// Amplitudes.
    One,
    /// Turning points of both sides on one scale.
    Both,
}

/// Fewest rows whose alternation alone shows turning points of both sides: by chance alternate rows of eight are separated once in 35 times, and rows of
/// falling amplitudes far less often.
const FEWEST_ALTERNATING: usize = 8;
/// Fraction of the largest value above which a negative value counts as the other side; smaller ones are errors of an amplitude near zero.
const OTHER_SIDE: f64 = 0.2;

/// Sides of the values, +1 or −1 for each row; all +1 for amplitudes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FoundSides {
    pub(super) sides: Sides,
    pub(super) signs: Vec<f64>,
}

impl FoundSides {
    /// Infers the sides of values in the order of time where they are not given; `None` where both were given and all rows are on one.
    pub(super) fn of(values: &[f64], given: Option<Sides>) -> Option<Self> {
        let (low, high) = extent(values);
        let crosses_zero = low < -OTHER_SIDE * high && high > -OTHER_SIDE * low;
        let in_turn = alternate(values);
        let are_both = match given {
            Some(sides) => sides == Sides::Both,
            None => crosses_zero || (in_turn && values.len() >= FEWEST_ALTERNATING),
        };
        if !are_both {
            let sign = if high.abs() < low.abs() { -1.0 } else { 1.0 };
            return Some(Self { sides: Sides::One, signs: vec![sign; values.len()] });
        }
        let middle = if crosses_zero { 0.0 } else { 0.5 * (low + high) };
        let first = if values.first() < values.get(1) { -1.0 } else { 1.0 };
        let sign = |(row, value): (usize, &f64)| match in_turn {
            true if row.is_multiple_of(2) => first,
            true => -first,
            false if *value > middle => 1.0,
            false => -1.0,
        };
        let signs: Vec<f64> = values.iter().enumerate().map(sign).collect();
        let has = |side: f64| signs.iter().any(|sign| sign.total_cmp(&side).is_eq());
        (has(1.0) && has(-1.0)).then_some(Self { sides: Sides::Both, signs })
    }
}

/// Returns `true` if every other row is above all of the rest.
fn alternate(values: &[f64]) -> bool {
    let [even, odd] = [0, 1].map(|first| extent(values.iter().skip(first).step_by(2)));
    values.len() > 3 && (even.0 > odd.1 || odd.0 > even.1)
}

/// The least and the greatest value.
fn extent<'a>(values: impl IntoIterator<Item = &'a f64>) -> (f64, f64) {
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    values.into_iter().fold(ends, |(low, high), &value| (low.min(value), high.max(value)))
}
