//! The symbols of a slow flow as columns of one ring of Laurent polynomials, with auxiliary ones.

use libration_numbers::algebra::{LaurentPolynomial, LaurentPolynomials, Rational, Ring};

/// A Laurent polynomial in all columns.
pub(super) type Sum = LaurentPolynomial;

/// Maximum number of products of terms in one product of sums, a second or two.
const MOST_PRODUCTS: usize = 4_000_000;

/// The columns: the symbols of the equation first, then those of the result, then those of the computation.
///
/// Products use i² = −1 and the square 1 of a sign, and leave out terms of a higher order than requested.
#[derive(Debug)]
pub(super) struct Letters {
    pub(super) ring: LaurentPolynomials,
    /// The number of symbols of the equation.
    pub(super) given: usize,
    /// The number of coordinates.
    pub(super) coordinates: usize,
}

/// Columns after the symbols of the equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Column {
    /// ω0, if it is not a product of symbols.
    Natural,
    Pi,
    /// σ.
    Detuning,
    /// A.
    Amplitude,
    /// W.
    Drive,
    /// The order of a term.
    Order,
    /// e^{is}, with s = W·t/p; later e^{iφ}.
    Wave,
    /// z = A·e^{iφ}/2.
    Phasor,
    /// Complex conjugate of z.
    Conjugate,
    Imaginary,
    /// x.
    Position,
    /// x′.
    Velocity,
    /// The sign of x.
    PositionSign,
    /// The sign of x′.
    VelocitySign,
    /// cos mφ.
    Cosine,
    /// sin mφ.
    Sine,
}

const COLUMNS: usize = 16;

/// Columns that each further coordinate has, after those above.
const OF_COORDINATE: [Column; 7] = [
    Column::Detuning,
    Column::Amplitude,
    Column::Wave,
    Column::Phasor,
    Column::Conjugate,
    Column::Position,
    Column::Velocity,
];

impl Letters {
    /// The ring in these symbols, with names for ω0, σ and A that the symbols do not have, and for σ and A of each further coordinate.
    pub(super) fn new(
        symbols: &[String],
        [natural, detuning, amplitude]: [&str; 3],
        further: &[[String; 2]],
    ) -> Self {
        let columns = [natural, "pi", detuning, amplitude].map(str::to_owned);
        let mut names: Vec<String> = symbols.iter().cloned().chain(columns).collect();
        names.resize(symbols.len() + COLUMNS, String::new());
        for names_of_coordinate in further {
            names.extend(names_of_coordinate.iter().cloned());
            names.resize(names.len() + OF_COORDINATE.len() - names_of_coordinate.len(), String::new());
        }
        Self { ring: LaurentPolynomials::new(names), given: symbols.len(), coordinates: 1 + further.len() }
    }

    pub(super) fn index(&self, column: Column) -> usize {
        self.given + column as usize
    }

    /// The index of a column of a coordinate; that of waves is for e^{iφ} in the further coordinates.
    pub(super) fn index_of(&self, column: Column, coordinate: usize) -> usize {
        let among_further = OF_COORDINATE.iter().position(|other| *other == column);
        match (coordinate.checked_sub(1), among_further) {
            (Some(further), Some(offset)) => self.given + COLUMNS + further * OF_COORDINATE.len() + offset,
            _ => self.index(column),
        }
    }

    /// The indices of a column in all coordinates.
    pub(super) fn indices(&self, column: Column) -> Vec<usize> {
        (0..self.coordinates).map(|coordinate| self.index_of(column, coordinate)).collect()
    }

    fn width(&self) -> usize {
        self.ring.letters().len()
    }

    pub(super) fn zero(&self) -> Sum {
        self.ring.zero()
    }

    pub(super) fn number(&self, value: Rational) -> Sum {
        self.ring.term(vec![0; self.width()].into(), value)
    }

    /// A column to a power.
    pub(super) fn power(&self, column: Column, exponent: i64) -> Sum {
        self.power_at(self.index(column), exponent)
    }

    /// A symbol of the equation, or another column by its index, to a power.
    pub(super) fn power_at(&self, column: usize, exponent: i64) -> Sum {
        let mut powers = vec![0; self.width()];
        powers[column] = 2 * exponent;
        self.ring.term(powers.into(), Rational::from(1))
    }

    pub(super) fn add(&self, a: &Sum, b: &Sum) -> Sum {
        self.ring.add(a, b)
    }

    pub(super) fn subtract(&self, a: &Sum, b: &Sum) -> Sum {
        self.ring.subtract(a, b)
    }

    /// The product to an order.
    pub(super) fn product(&self, a: &Sum, b: &Sum, order: i64) -> Sum {
        let terms = |sum: &Sum| sum.half_powers().count();
        if a.is_beyond_limit() || b.is_beyond_limit() || terms(a).saturating_mul(terms(b)) > MOST_PRODUCTS {
            return self.beyond_limit();
        }
        let grade = self.index(Column::Order);
        let pairs = a.half_powers().flat_map(|(x, p)| b.half_powers().map(move |(y, q)| (x, p, y, q)));
        let kept = pairs.filter(|(x, _, y, _)| x[grade] + y[grade] <= 2 * order);
        self.ring.sum_of_terms(kept.map(|(x, p, y, q)| {
            let mut powers: Box<[i64]> = x.iter().zip(y.iter()).map(|(i, j)| i + j).collect();
            let is_negative = self.reduce(&mut powers);
            let factor = p.clone() * q.clone();
            (powers, if is_negative { -factor } else { factor })
        }))
    }

    /// The product without limit of order.
    pub(super) fn times(&self, a: &Sum, b: &Sum) -> Sum {
        self.product(a, b, i64::from(i16::MAX))
    }

    pub(super) fn scaled(&self, a: &Sum, factor: &Rational) -> Sum {
        self.times(a, &self.number(factor.clone()))
    }

    /// A natural power to an order.
    pub(super) fn raised(&self, a: &Sum, exponent: usize, order: i64) -> Sum {
        let one = self.number(Rational::from(1));
        (0..exponent).fold(one, |power, _| self.product(&power, a, order))
    }

    /// The inverse of a single term.
    pub(super) fn inverse(&self, a: &Sum) -> Option<Sum> {
        a.as_single_term()?;
        let inverse = self.ring.power(a, &Rational::from(-1))?;
        Some(self.changed(&inverse, |powers, factor| {
            let imaginary = &mut powers[self.index(Column::Imaginary)];
            let is_imaginary = *imaginary != 0;
            *imaginary = imaginary.abs();
            if is_imaginary { -factor.clone() } else { factor.clone() }
        }))
    }

    /// Each term with other powers and another factor.
    pub(super) fn changed(&self, a: &Sum, change: impl Fn(&mut [i64], &Rational) -> Rational) -> Sum {
        self.changed_by(a, &change)
    }

    // Compiled once for all closures.
    fn changed_by(&self, a: &Sum, change: &dyn Fn(&mut [i64], &Rational) -> Rational) -> Sum {
        if a.is_beyond_limit() {
            return self.beyond_limit();
        }
        self.ring.sum_of_terms(a.half_powers().map(|(powers, factor)| {
            let mut powers = powers.clone();
            let factor = change(&mut powers, factor);
            (powers, factor)
        }))
    }

    pub(super) fn part(&self, a: &Sum, is_such: impl Fn(&[i64]) -> bool) -> Sum {
        self.ring.part(a, is_such)
    }

    /// The part of one order.
    pub(super) fn of_order(&self, a: &Sum, order: i64) -> Sum {
        let grade = self.index(Column::Order);
        self.part(a, |powers| powers[grade] == 2 * order)
    }

    /// The part up to an order.
    pub(super) fn to_order(&self, a: &Sum, order: i64) -> Sum {
        let grade = self.index(Column::Order);
        self.part(a, |powers| powers[grade] <= 2 * order)
    }

    /// The lowest order that is present.
    pub(super) fn lowest_order(&self, a: &Sum) -> Option<i64> {
        self.exponents(a, Column::Order).first().copied()
    }

    /// The exponents with which a column occurs, rising; those that are not whole are rounded down.
    pub(super) fn exponents(&self, a: &Sum, column: Column) -> Vec<i64> {
        let index = self.index(column);
        let mut exponents: Vec<i64> =
            a.half_powers().map(|(powers, _)| powers[index].div_euclid(2)).collect();
        exponents.sort_unstable();
        exponents.dedup();
        exponents
    }

    /// The coefficient of a power of a column.
    pub(super) fn coefficient(&self, a: &Sum, column: Column, exponent: i64) -> Sum {
        let index = self.index(column);
        let such = self.part(a, |powers| powers[index] == 2 * exponent);
        self.changed(&such, |powers, factor| {
            powers[index] = 0;
            factor.clone()
        })
    }

    /// The derivative with respect to a column.
    pub(super) fn derivative(&self, a: &Sum, column: Column) -> Sum {
        self.derivative_at(a, self.index(column))
    }

    /// The derivative with respect to a column by its index.
    pub(super) fn derivative_at(&self, a: &Sum, column: usize) -> Sum {
        self.changed(a, |powers, factor| {
            let exponent = Rational::new(powers[column], 2).unwrap_or_else(|| Rational::from(0));
            powers[column] -= 2;
            exponent * factor.clone()
        })
    }

    /// The column's logarithmic derivative, a·∂/∂a.
    pub(super) fn scale_derivative(&self, a: &Sum, column: Column) -> Sum {
        self.times(&self.derivative(a, column), &self.power(column, 1))
    }

    /// The sum with another one in place of a column that occurs with natural powers, to an order.
    pub(super) fn substituted(&self, a: &Sum, column: Column, by: &Sum, order: i64) -> Sum {
        let mut exponents = self.exponents(a, column);
        exponents.reverse();
        let highest = exponents.first().copied().unwrap_or(0);
        (0..=highest).rev().fold(self.zero(), |value, exponent| {
            self.add(&self.product(&value, by, order), &self.coefficient(a, column, exponent))
        })
    }

    /// The sum as a formula, orders left out.
    pub(super) fn text(&self, a: &Sum) -> String {
        let grade = self.index(Column::Order);
        let plain = self.changed(a, |powers, factor| {
            powers[grade] = 0;
            factor.clone()
        });
        plain.to_string()
    }

    /// The complex conjugate.
    pub(super) fn conjugate(&self, a: &Sum) -> Sum {
        let [wave, imaginary] = [Column::Wave, Column::Imaginary].map(|column| self.index(column));
        let [phasors, conjugates] = [Column::Phasor, Column::Conjugate].map(|column| self.indices(column));
        self.changed(a, |powers, factor| {
            for (&z, &conjugate) in phasors.iter().zip(&conjugates) {
                powers.swap(z, conjugate);
            }
            powers[wave] = -powers[wave];
            if powers[imaginary] == 0 { factor.clone() } else { -factor.clone() }
        })
    }

    /// A sum with unknown terms.
    fn beyond_limit(&self) -> Sum {
        self.power(Column::Pi, i64::from(i32::MAX))
    }

    /// `true` if i² = −1 changes the sign.
    fn reduce(&self, powers: &mut [i64]) -> bool {
        for sign in [Column::PositionSign, Column::VelocitySign] {
            powers[self.index(sign)] %= 4;
        }
        let imaginary = &mut powers[self.index(Column::Imaginary)];
        let is_square = *imaginary == 4;
        *imaginary %= 4;
        is_square
    }
}
