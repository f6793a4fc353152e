//! Operations on the coefficients of a power series.

use std::fmt::Debug;

use super::{Function, Rational};

/// A commutative ring that contains the integers. Common data of the elements, such as a modulus or a precision, are held by the ring, so that
/// elements are plain data.
///
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::algebra::{Rational, Rationals, Ring};
///
/// /// 1 + a + … + aⁿ, in any ring.
/// fn geometric<R: Ring>(ring: &R, a: &R::Element, n: usize) -> Option<R::Element> {
///     let one = ring.rational(&Rational::from(1))?;
///     Some((0..n).fold(one.clone(), |sum, _| ring.add(&one, &ring.multiply(&sum, a))))
/// }
/// let half = Rational::new(1, 2).ok_or("zero")?;
/// assert_eq!(geometric(&Rationals, &half, 3).map(|sum| sum.to_string()).as_deref(), Some("15/8"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Ring {
    /// A member of the ring.
    type Element: Clone + Debug;

    /// 0.
    fn zero(&self) -> Self::Element;
    /// Returns `true` if an element is 0.
    fn is_zero(&self, a: &Self::Element) -> bool;
    /// A fraction as an element; `None` if it is not in the ring.
    fn rational(&self, value: &Rational) -> Option<Self::Element>;
    /// a + b.
    fn add(&self, a: &Self::Element, b: &Self::Element) -> Self::Element;
    /// a − b.
    fn subtract(&self, a: &Self::Element, b: &Self::Element) -> Self::Element;
    /// −a.
    fn negate(&self, a: &Self::Element) -> Self::Element;
    /// a·b.
    fn multiply(&self, a: &Self::Element, b: &Self::Element) -> Self::Element;
    /// The element times an integer.
    fn times_integer(&self, a: &Self::Element, factor: i64) -> Self::Element;
    /// a/divisor; `None` if the quotient is not in the ring.
    fn divide(&self, a: &Self::Element, divisor: &Self::Element) -> Option<Self::Element>;
    /// a/divisor for an integer; `None` if the quotient is not in the ring.
    fn over_integer(&self, a: &Self::Element, divisor: u64) -> Option<Self::Element>;

    /// The value of a function; `None` if it is not in the ring.
    fn value(&self, function: Function, at: &Self::Element) -> Option<Self::Element>;
    /// aᵖ for a fraction p; `None` if it is not in the ring.
    fn power(&self, a: &Self::Element, exponent: &Rational) -> Option<Self::Element>;
    /// π; `None` if it is not in the ring.
    fn pi(&self) -> Option<Self::Element>;

    /// Σ aᵢ·b_{n−1−i} over two slices of the same length n.
    fn convolution(&self, a: &[Self::Element], b: &[Self::Element]) -> Self::Element {
        let products = a.iter().zip(b.iter().rev()).filter(|(a, b)| !self.is_zero(a) && !self.is_zero(b));
        products.fold(self.zero(), |sum, (a, b)| self.add(&sum, &self.multiply(a, b)))
    }

    /// The first `length` coefficients of the product of two power series.
    fn series_product(&self, a: &[Self::Element], b: &[Self::Element], length: usize) -> Vec<Self::Element> {
        let coefficient = |n: usize| {
            let first = (n + 1).saturating_sub(b.len());
            let last = (n + 1).min(a.len());
            if first < last {
                self.convolution(&a[first..last], &b[n + 1 - last..=n - first])
            } else {
                self.zero()
            }
        };
        (0..length).map(coefficient).collect()
    }

    /// The first `length` coefficients of outer(inner(x)) for two power series, the inner one without constant term. `go_on` is checked at each
    /// step; `None` if it returns `false`.
    fn series_composition(
        &self,
        outer: &[Self::Element],
        inner: &[Self::Element],
        length: usize,
        go_on: &dyn Fn() -> bool,
    ) -> Option<Vec<Self::Element>> {
        let mut sum = vec![self.zero(); length];
        for coefficient in outer.iter().take(length).rev() {
            go_on().then_some(())?;
            sum = self.series_product(&sum, inner, length);
            if let Some(constant) = sum.first_mut() {
                *constant = self.add(constant, coefficient);
            }
        }
        Some(sum)
    }
}
