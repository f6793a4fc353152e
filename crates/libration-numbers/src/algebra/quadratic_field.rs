//! A field extended by the square root of one of its elements.

use super::{Function, Rational, Ring};

/// All a + b·√s for a, b and s in a field. If s is a square in that field, some elements have no inverse.
#[derive(Clone, Debug)]
pub struct QuadraticField<F: Ring> {
    pub base: F,
    /// s.
    pub square: F::Element,
}

/// a + b·√s.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quadratic<E> {
    pub plain: E,
    pub root: E,
}

impl<F: Ring> QuadraticField<F> {
    /// An element of the base field as an element of the extension.
    pub fn plain(&self, plain: F::Element) -> Quadratic<F::Element> {
        Quadratic { plain, root: self.base.zero() }
    }

    /// √s.
    pub fn square_root(&self) -> Option<Quadratic<F::Element>> {
        Some(Quadratic { plain: self.base.zero(), root: self.base.rational(&1.into())? })
    }

    /// The element of the base field; `None` if the coefficient of √s is not zero.
    fn as_plain<'a>(&self, a: &'a Quadratic<F::Element>) -> Option<&'a F::Element> {
        self.base.is_zero(&a.root).then_some(&a.plain)
    }
}

impl<F: Ring> Ring for QuadraticField<F> {
    type Element = Quadratic<F::Element>;

    fn zero(&self) -> Self::Element {
        self.plain(self.base.zero())
    }

    fn is_zero(&self, a: &Self::Element) -> bool {
        self.base.is_zero(&a.plain) && self.base.is_zero(&a.root)
    }

    fn rational(&self, value: &Rational) -> Option<Self::Element> {
        self.base.rational(value).map(|plain| self.plain(plain))
    }

    fn add(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        Quadratic { plain: self.base.add(&a.plain, &b.plain), root: self.base.add(&a.root, &b.root) }
    }

    fn subtract(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        Quadratic {
            plain: self.base.subtract(&a.plain, &b.plain),
            root: self.base.subtract(&a.root, &b.root),
        }
    }

    fn negate(&self, a: &Self::Element) -> Self::Element {
        Quadratic { plain: self.base.negate(&a.plain), root: self.base.negate(&a.root) }
    }

    fn multiply(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        let product = |x: &F::Element, y: &F::Element| self.base.multiply(x, y);
        let roots = product(&product(&a.root, &b.root), &self.square);
        let mixed = self.base.add(&product(&a.plain, &b.root), &product(&a.root, &b.plain));
        Quadratic { plain: self.base.add(&product(&a.plain, &b.plain), &roots), root: mixed }
    }

    fn times_integer(&self, a: &Self::Element, factor: i64) -> Self::Element {
        let times = |x: &F::Element| self.base.times_integer(x, factor);
        Quadratic { plain: times(&a.plain), root: times(&a.root) }
    }

    /// (a + b√s)/(c + d√s), with the denominator made rational by c − d√s.
    fn divide(&self, a: &Self::Element, divisor: &Self::Element) -> Option<Self::Element> {
        let conjugate = Quadratic { plain: divisor.plain.clone(), root: self.base.negate(&divisor.root) };
        let norm = self.multiply(divisor, &conjugate).plain;
        if self.base.is_zero(&norm) {
            return None;
        }
        let Quadratic { plain, root } = self.multiply(a, &conjugate);
        Some(Quadratic { plain: self.base.divide(&plain, &norm)?, root: self.base.divide(&root, &norm)? })
    }

    fn over_integer(&self, a: &Self::Element, divisor: u64) -> Option<Self::Element> {
        let over = |x: &F::Element| self.base.over_integer(x, divisor);
        Some(Quadratic { plain: over(&a.plain)?, root: over(&a.root)? })
    }

    fn value(&self, function: Function, at: &Self::Element) -> Option<Self::Element> {
        self.base.value(function, self.as_plain(at)?).map(|plain| self.plain(plain))
    }

    fn power(&self, a: &Self::Element, exponent: &Rational) -> Option<Self::Element> {
        self.base.power(self.as_plain(a)?, exponent).map(|plain| self.plain(plain))
    }

    fn pi(&self) -> Option<Self::Element> {
        self.base.pi().map(|plain| self.plain(plain))
    }
}
