//! The frequency of small oscillations in symbols, and its name in coefficients.
//!
//! After the symbols the ring has one more, ω0. It stands in coefficients where ω0² is a sum or its root is needed,
//! and obeys ω0² = q, with q a Laurent polynomial in the letters.

use libration_motion::oscillator::SymbolicOscillator;
use libration_numbers::algebra::{LaurentPolynomial, LaurentPolynomials, Rational, Ring};
use libration_numbers::expression::{Expression, Function};

pub(super) struct Frequency<'a> {
    ring: &'a LaurentPolynomials,
    /// ω0² in letters.
    square: &'a LaurentPolynomial,
    /// The index of ω0 among the symbols of the ring.
    index: usize,
    /// Term by which sums are reduced.
    leading: Option<Leading>,
}

/// The only term of ω0² in which the power of a letter is the largest, or the smallest.
struct Leading {
    letter: usize,
    /// 1 for the largest power, −1 for the smallest.
    direction: i64,
    power: i64,
    /// The rest of ω0² subtracted from ω0², over the term.
    instead: LaurentPolynomial,
}

impl<'a> Frequency<'a> {
    pub(super) fn new(oscillator: &'a SymbolicOscillator) -> Self {
        let (ring, square) = (oscillator.ring(), oscillator.omega0_squared());
        let index = ring.letters().len() - 1;
        let leading = if square.as_single_term().is_some() { None } else { leading(ring, square, index) };
        Self { ring, square, index, leading }
    }

    /// ω0² as the recurrences take it.
    pub(super) fn squared(&self) -> LaurentPolynomial {
        if self.is_sum() { self.ring.multiply(&self.symbol(), &self.symbol()) } else { self.square.clone() }
    }

    /// ω0 as the recurrences take it.
    pub(super) fn root(&self) -> LaurentPolynomial {
        self.in_letters().unwrap_or_else(|| self.symbol())
    }

    /// ω0, if it is a product of symbols and a fraction.
    pub(super) fn in_letters(&self) -> Option<LaurentPolynomial> {
        self.ring.power(self.square, &Rational::new(1, 2)?)
    }

    /// The name of ω0 in coefficients, where ω0² is a sum.
    pub(super) fn name(&self) -> Option<String> {
        self.is_sum().then(|| self.ring.letters()[self.index].clone())
    }

    /// The name of ω0 with its root as a formula, if ω0² is one term whose root occurs in these coefficients.
    pub(super) fn named_root(&self, coefficients: &[LaurentPolynomial]) -> Option<(String, Expression)> {
        let occurs = |polynomial: &LaurentPolynomial| {
            polynomial.half_powers().any(|(powers, _)| powers[self.index] != 0)
        };
        if self.is_sum() || !coefficients.iter().any(occurs) {
            return None;
        }
        let square = self.square.to_string().parse().ok()?;
        let root = Expression::Call(Function::Sqrt, Box::new(square));
        Some((self.ring.letters()[self.index].clone(), root))
    }

    fn is_sum(&self) -> bool {
        self.square.as_single_term().is_none()
    }

    fn symbol(&self) -> LaurentPolynomial {
        self.ring.letter(self.index)
    }

    /// The coefficient with ω0² written out as little as possible.
    pub(super) fn reduced(&self, coefficient: &LaurentPolynomial) -> LaurentPolynomial {
        match &self.leading {
            _ if !self.is_sum() => self.written_out(coefficient).unwrap_or_else(|| coefficient.clone()),
            None => coefficient.clone(),
            Some(leading) => leading.replaced(self.ring, coefficient),
        }
    }

    /// The coefficient with ω0² in symbols and ω0 to at most the first power; `None` if a negative power of a sum remains.
    fn written_out(&self, coefficient: &LaurentPolynomial) -> Option<LaurentPolynomial> {
        if coefficient.is_beyond_limit() {
            return Some(coefficient.clone());
        }
        let mut sum = self.ring.zero();
        for (powers, factor) in coefficient.half_powers() {
            let mut others = powers.clone();
            let odd = if others[self.index] % 4 == 0 { 0 } else { 2 };
            let square_power = whole_squares(std::mem::replace(&mut others[self.index], odd) - odd)?;
            let square = self.ring.power(self.square, &Rational::from(square_power))?;
            sum = self.ring.add(&sum, &self.ring.multiply(&self.ring.term(others, factor.clone()), &square));
        }
        Some(sum)
    }

    pub(super) fn are_equal(&self, a: &[LaurentPolynomial], b: &[LaurentPolynomial]) -> bool {
        a.len() == b.len() && a.iter().zip(b).all(|(a, b)| self.vanishes(&self.ring.subtract(a, b)))
    }

    fn vanishes(&self, difference: &LaurentPolynomial) -> bool {
        let lowest = difference.half_powers().map(|(powers, _)| powers[self.index]).min().unwrap_or(0).min(0);
        let mut powers: Box<[i64]> = vec![0; self.ring.letters().len()].into();
        powers[self.index] = -lowest;
        let cleared = self.ring.multiply(difference, &self.ring.term(powers, Rational::from(1)));
        self.written_out(&cleared).is_some_and(|written| written.is_zero())
    }
}

/// The exponent of ω0² in a power of ω0, given twice the exponent.
fn whole_squares(half_power: i64) -> Option<i64> {
    (half_power % 4 == 0).then_some(half_power / 4)
}

fn leading(ring: &LaurentPolynomials, square: &LaurentPolynomial, index: usize) -> Option<Leading> {
    let candidates = (0..index).flat_map(|letter| [(letter, 1), (letter, -1)]);
    candidates.into_iter().find_map(|(letter, direction)| {
        let power = square.half_powers().map(|(powers, _)| direction * powers[letter]).max()?;
        let term = ring.part(square, |powers| direction * powers[letter] == power);
        if power <= 0 || term.as_single_term().is_none() {
            return None;
        }
        let symbol_squared = ring.multiply(&ring.letter(index), &ring.letter(index));
        let instead = ring.subtract(&symbol_squared, &ring.subtract(square, &term));
        Some(Leading { letter, direction, power, instead: ring.divide(&instead, &term)? })
    })
}

impl Leading {
    /// Each multiple of the term replaced by ω0² less the others, which lowers the power of the letter.
    fn replaced(&self, ring: &LaurentPolynomials, coefficient: &LaurentPolynomial) -> LaurentPolynomial {
        let mut coefficient = coefficient.clone();
        loop {
            let is_multiple = |powers: &[i64]| self.direction * powers[self.letter] >= self.power;
            let multiples = ring.part(&coefficient, is_multiple);
            if multiples.is_zero() || multiples.is_beyond_limit() {
                return coefficient;
            }
            let others = ring.part(&coefficient, |powers| !is_multiple(powers));
            coefficient = ring.add(&others, &ring.multiply(&multiples, &self.instead));
        }
    }
}

/// Fractions in place of the symbols.
pub(super) struct Point<'a> {
    frequency: &'a Frequency<'a>,
    /// The square roots of the letters.
    roots: Vec<Rational>,
    omega0_squared: Rational,
}

impl<'a> Point<'a> {
    /// A point at which ω0² is not zero, for symbols up to this power, doubled. High powers of fractions have thousands
    /// of digits: if there are any, all symbols are 1.
    pub(super) fn new(frequency: &'a Frequency<'a>, largest_half_power: i64) -> Option<Self> {
        const TRIED: i64 = 20;
        const HIGH: i64 = 400;
        if largest_half_power > HIGH {
            return Self::with_roots(frequency, |_| Some(Rational::from(1)));
        }
        (0..TRIED).find_map(|shift| {
            Self::with_roots(frequency, |number| Rational::new(number + 2 + shift, 2 * number + 3))
        })
    }

    fn with_roots(frequency: &'a Frequency<'a>, root: impl Fn(i64) -> Option<Rational>) -> Option<Self> {
        let roots = (0..i64::try_from(frequency.index).ok()?).map(root).collect::<Option<Vec<_>>>()?;
        let point = Self { frequency, roots, omega0_squared: Rational::from(1) };
        let omega0_squared = point.value(frequency.square).filter(|square| !square.is_zero())?;
        Some(Self { omega0_squared, ..point })
    }

    pub(super) fn omega0_squared(&self) -> &Rational {
        &self.omega0_squared
    }

    /// The value of a coefficient; `None` if it is undefined there.
    pub(super) fn value(&self, coefficient: &LaurentPolynomial) -> Option<Rational> {
        coefficient.value(|index, half_power| {
            if index == self.frequency.index {
                return self.omega0_squared.integer_power(isize::try_from(whole_squares(half_power)?).ok()?);
            }
            self.roots.get(index)?.integer_power(isize::try_from(half_power).ok()?)
        })
    }
}
