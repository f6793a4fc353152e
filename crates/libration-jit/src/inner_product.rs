//! Sums of products, in an order that is fast on current processors.

/// The operations of a sum of products.
pub trait MultiplyAdd {
    /// A number, or several numbers side by side.
    type Element: Copy;

    /// Zero.
    fn nothing(&self) -> Self::Element;
    /// a + b.
    fn sum(&self, a: Self::Element, b: Self::Element) -> Self::Element;
    /// a·b.
    fn product(&self, a: Self::Element, b: Self::Element) -> Self::Element;
    /// a·b + c with one rounding.
    fn multiply_add(&self, a: Self::Element, b: Self::Element, c: Self::Element) -> Self::Element;
}

/// Σ aᵢ·b_{n−1−i} over two slices of the same length n.
///
/// Forms four partial sums, which a processor can work on at the same time, from the middle to the ends. In the convolution of two series the
/// newest coefficients stand at the ends, so that all other products can start before these are known.
#[inline(always)]
pub fn inner_product<S: MultiplyAdd>(on: &S, a: &[S::Element], b: &[S::Element]) -> S::Element {
    let (half, n) = (a.len() / 2, a.len());
    let (left, right) =
        (a[..half].iter().rev().zip(&b[n - half..]), a[n - half..].iter().zip(b[..half].iter().rev()));
    let mut pairs = left.zip(right);
    let middle = (n > 2 * half).then(|| on.product(a[half], b[half]));
    let Some(((a, b), (c, d))) = pairs.next() else { return middle.unwrap_or_else(|| on.nothing()) };
    let even = middle.map_or_else(|| on.product(*a, *b), |middle| on.multiply_add(*a, *b, middle));
    let mut inner = [even, on.product(*c, *d)];
    let Some(((a, b), (c, d))) = pairs.next() else { return on.sum(inner[0], inner[1]) };
    let mut outer = [on.product(*a, *b), on.product(*c, *d)];
    while let Some(((a, b), (c, d))) = pairs.next() {
        inner = [on.multiply_add(*a, *b, inner[0]), on.multiply_add(*c, *d, inner[1])];
        let Some(((a, b), (c, d))) = pairs.next() else { break };
        outer = [on.multiply_add(*a, *b, outer[0]), on.multiply_add(*c, *d, outer[1])];
    }
    on.sum(on.sum(inner[0], inner[1]), on.sum(outer[0], outer[1]))
}

/// Plain numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Numbers;

impl MultiplyAdd for Numbers {
    type Element = f64;

    fn nothing(&self) -> f64 {
        0.0
    }

    fn sum(&self, a: f64, b: f64) -> f64 {
        a + b
    }

    fn product(&self, a: f64, b: f64) -> f64 {
        a * b
    }

    fn multiply_add(&self, a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }
}
