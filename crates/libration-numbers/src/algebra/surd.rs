//! Numbers a + b√d with fractions a and b.

use std::fmt;

use super::{Rational, Rationals, Ring};

/// The number a + b√d.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::algebra::{Rational, Surd};
/// let surd = Surd::new(Rational::from(2), Rational::from(-1), Rational::from(8));
/// assert_eq!(surd.to_string(), "2 - 2*sqrt(2)");
/// assert!((surd.to_f64() - (2.0 - 8.0_f64.sqrt())).abs() < 1e-15);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Surd {
    plain: Rational,
    root: Rational,
    radicand: Rational,
}

impl Surd {
    /// a + b√d in its simplest form: the number under the root is an integer without small square factors.
    #[must_use]
    pub fn new(a: Rational, b: Rational, d: Rational) -> Self {
        let (factor, radicand) = without_squares(&d);
        let root = b * factor;
        if radicand == Rational::from(1) {
            return Self::from(a + root);
        }
        if root.is_zero() || radicand.is_zero() {
            return Self::from(a);
        }
        Self { plain: a, root, radicand }
    }

    /// a.
    #[must_use]
    pub fn plain(&self) -> &Rational {
        &self.plain
    }

    /// b.
    #[must_use]
    pub fn root(&self) -> &Rational {
        &self.root
    }

    /// d.
    #[must_use]
    pub fn radicand(&self) -> &Rational {
        &self.radicand
    }

    /// The value as a fraction; `None` if the root remains.
    #[must_use]
    pub fn to_rational(&self) -> Option<&Rational> {
        self.root.is_zero().then_some(&self.plain)
    }

    /// The number times a fraction.
    #[must_use]
    pub fn times(&self, factor: &Rational) -> Self {
        let times = |x: &Rational| Rationals.multiply(x, factor);
        Self::new(times(&self.plain), times(&self.root), self.radicand.clone())
    }

    /// The value, accurate to a few units in the last place whatever the signs of the terms.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        let root = self.root.to_f64() * self.radicand.to_f64().sqrt();
        let plain = self.plain.to_f64();
        if plain * root >= 0.0 {
            return plain + root;
        }
        // a + b√d = (a² − b²d)/(a − b√d).
        let square = |x: &Rational| Rationals.multiply(x, x);
        let norm = square(&self.plain) - square(&self.root) * self.radicand.clone();
        norm.to_f64() / (plain - root)
    }

    /// The square root of the number as text: `1/2`, `sqrt(3)`, `sqrt(2 - sqrt(2))`.
    #[must_use]
    pub fn square_root_text(&self) -> String {
        let root = self.to_rational().and_then(Rational::square_root);
        root.map_or_else(|| format!("sqrt({self})"), |root| root.to_string())
    }
}

impl From<Rational> for Surd {
    fn from(plain: Rational) -> Self {
        Self { plain, root: Rational::from(0), radicand: Rational::from(0) }
    }
}

/// s and d with √x = s√d and an integer d, without the squares of small primes.
fn without_squares(x: &Rational) -> (Rational, Rational) {
    const LARGEST: i64 = 1000;
    if let Some(root) = x.square_root() {
        return (root, Rational::from(1));
    }
    let below: Rational = x.denominator().parse().unwrap_or_else(|_| Rational::from(1));
    let mut radicand = Rationals.multiply(&Rationals.multiply(x, &below), &below);
    let mut factor = Rational::from(1).checked_div(&below).unwrap_or_else(|| Rational::from(1));
    for p in 2..=LARGEST {
        while let Some(smaller) = radicand.checked_div(&Rational::from(p * p)).filter(Rational::is_integer) {
            radicand = smaller;
            factor = Rationals.times_integer(&factor, p);
        }
    }
    (factor, radicand)
}

/// Writes a formula such as `3/2 - 1/2*sqrt(5)`.
impl fmt::Display for Surd {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.root.is_zero() {
            return self.plain.fmt(formatter);
        }
        let size = self.root.magnitude();
        let factor = if size == Rational::from(1) { String::new() } else { format!("{size}*") };
        let root = format!("{factor}sqrt({})", self.radicand);
        match (self.plain.is_zero(), self.root.is_negative()) {
            (true, false) => write!(formatter, "{root}"),
            (true, true) => write!(formatter, "-{root}"),
            (false, false) => write!(formatter, "{} + {root}", self.plain),
            (false, true) => write!(formatter, "{} - {root}", self.plain),
        }
    }
}
