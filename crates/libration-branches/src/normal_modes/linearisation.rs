//! The linear equations of small motions: x″ = −A·x + G·x′.

use super::equilibrium::{Equilibrium, PRECISION, substituted};
use super::error::ModesError;
use libration_numbers::algebra::{BigFloat, Doubles, Floats, Rational, Ring};
use libration_numbers::{
    expression::{Equation, Expression, Symbol},
    internals::expression::{Jet, Side, Tape},
};

/// The matrices A and G, by rows.
#[derive(Clone, Debug)]
pub(super) struct Linearisation<N> {
    pub(super) stiffness: Vec<Vec<N>>,
    pub(super) velocity: Vec<Vec<N>>,
}

/// The linear equations in floating-point numbers, and in fractions if all entries are rational.
#[derive(Clone, Debug)]
pub(super) struct Linear {
    pub(super) numbers: Linearisation<f64>,
    pub(super) exact: Option<Linearisation<Rational>>,
}

/// The symbols of the coordinates, followed by those of the velocities.
pub(super) fn symbols(equation: &Equation) -> Vec<Symbol> {
    let plain = equation.variables().iter().map(|name| Symbol::plain(name));
    plain.clone().chain(plain.map(|symbol| symbol.with_primes(1))).collect()
}

/// Largest number of coordinates for exact frequencies and shapes: the characteristic polynomial in fractions takes 0.9 s for a chain of 32
/// masses, 25 s for one of 64 and minutes for one of 150.
const MOST_EXACT: usize = 32;

pub(super) fn linearisation(equation: &Equation, rest: &Equilibrium) -> Result<Linear, ModesError> {
    let symbols = symbols(equation);
    let state: Vec<f64> = rest.at.iter().copied().chain(rest.at.iter().map(|_| 0.0)).collect();
    let on_side = |sign: i64| -> Vec<Expression> {
        let side = Side { symbols: &symbols, state: &state, sign };
        equation.accelerations().iter().map(|formula| side.seen(formula)).collect()
    };
    let (above, below) = (on_side(1), on_side(-1));
    let slopes = slopes(&above, &symbols);
    let numbers = in_numbers(&slopes, &symbols, rest)?;
    if above != below && !is_smooth([&above, &below], &symbols, rest)? {
        return Err(ModesError::NotSmooth { at: rest.at.clone() });
    }
    let is_small = rest.at.len() <= MOST_EXACT;
    let exact = rest.exact.as_ref().filter(|_| is_small);
    let exact = exact.and_then(|point| in_fractions(&slopes, &symbols, point));
    Ok(Linear {
        numbers: split(&numbers, |x| -x),
        exact: exact.map(|exact| split(&exact, |x: &Rational| -x.clone())),
    })
}

/// The derivatives of each formula, as a row.
fn slopes(formulas: &[Expression], symbols: &[Symbol]) -> Vec<Vec<Expression>> {
    formulas.iter().map(|formula| symbols.iter().map(|symbol| formula.derivative(symbol)).collect()).collect()
}

/// Returns `true` if formulas and their derivatives are the same on both sides of a state. Each number is compared by itself: its
/// unit is that of no other, and a kink of a slow coordinate is small next to the stiffness of a fast one.
fn is_smooth(sides: [&[Expression]; 2], symbols: &[Symbol], rest: &Equilibrium) -> Result<bool, ModesError> {
    /// Largest relative difference: the state of a double zero of the accelerations has half the digits.
    const SAME: f64 = 1e-9;
    /// Rounding errors of terms that cancel, relative to the largest number of the same formula.
    const ROUNDING: f64 = 64.0 * f64::EPSILON;
    let values = |formulas: &[Expression]| {
        let mut rows = slopes(formulas, symbols);
        for (row, formula) in rows.iter_mut().zip(formulas) {
            row.push(formula.clone());
        }
        in_numbers(&rows, symbols, rest)
    };
    let (above, below) = (values(sides[0])?, values(sides[1])?);
    let are_same = |(a, b): (&Vec<f64>, &Vec<f64>)| {
        let size = a.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        a.iter().zip(b).all(|(a, b)| (a - b).abs() <= (SAME * a.abs()).max(ROUNDING * size))
    };
    Ok(above.iter().zip(&below).all(are_same))
}

/// The derivatives with respect to coordinates with opposite sign, and those with respect to velocities.
fn split<N: Clone>(slopes: &[Vec<N>], negative: impl Fn(&N) -> N) -> Linearisation<N> {
    let n = slopes.len();
    let stiffness = slopes.iter().map(|row| row[..n].iter().map(&negative).collect()).collect();
    Linearisation { stiffness, velocity: slopes.iter().map(|row| row[n..].to_vec()).collect() }
}

/// The values at the equilibrium, of which double precision leaves few digits next to a double zero of the accelerations.
fn in_numbers(
    rows: &[Vec<Expression>],
    symbols: &[Symbol],
    rest: &Equilibrium,
) -> Result<Vec<Vec<f64>>, ModesError> {
    let all: Vec<&Expression> = rows.iter().flatten().collect();
    let tape = Tape::new(&all, symbols)?;
    let values = match &rest.precise {
        Some(at) => {
            let ring = Floats { precision: PRECISION };
            values(&ring, &tape, at).map(|values| values.iter().map(BigFloat::to_f64).collect::<Vec<_>>())
        }
        None => values(&Doubles, &tape, &rest.at),
    };
    let finite = values.filter(|values| values.iter().all(|x| x.is_finite()));
    let values = finite.ok_or_else(|| ModesError::NotSmooth { at: rest.at.clone() })?;
    Ok(values.chunks(rows[0].len()).map(<[f64]>::to_vec).collect())
}

/// The results of a tape at rest in these positions.
fn values<R: Ring>(ring: &R, tape: &Tape, at: &[R::Element]) -> Option<Vec<R::Element>> {
    let state: Vec<R::Element> = at.iter().cloned().chain(at.iter().map(|_| ring.zero())).collect();
    let jet = Jet::new(ring, tape, &state).ok()?;
    Some((0..tape.results().len()).map(|i| jet.result(i)[0].clone()).collect())
}

fn in_fractions(
    slopes: &[Vec<Expression>],
    symbols: &[Symbol],
    rest: &[Rational],
) -> Option<Vec<Vec<Rational>>> {
    let zeros = rest.iter().map(|_| Rational::from(0));
    let values: Vec<Rational> = rest.iter().cloned().chain(zeros).collect();
    let value = |formula: &Expression| substituted(formula, symbols, &values).to_rational();
    slopes.iter().map(|row| row.iter().map(value).collect()).collect()
}
