//! Sums of products in an order that processors are fast at.

/// What a sum of products is made of.
pub trait MultiplyAdd {
    /// A number, or as many as are worked on side by side.
    type Element: Copy;

    /// Zero.
    fn nothing(&self) -> Self::Element;
    /// a + b.
    fn sum(&self, a: Self::Element, b: Self::Element) -> Self::Element;
    /// a·b + c with one rounding.
    fn multiply_add(&self, a: Self::Element, b: Self::Element, c: Self::Element) -> Self::Element;
}

/// Σ aᵢ·b_{n−1−i} over two slices of the same length n.
///
/// In four sums, which a processor forms at the same time, from the middle to the ends: in the convolution of two series the newest
/// coefficients are there, and all else can be under way before these are known.
#[inline(always)]
pub fn inner_product<S: MultiplyAdd>(on: &S, a: &[S::Element], b: &[S::Element]) -> S::Element {
    let (half, n) = (a.len() / 2, a.len());
    let (left, right) =
        (a[..half].iter().rev().zip(&b[n - half..]), a[n - half..].iter().zip(b[..half].iter().rev()));
    let mut sums = [on.nothing(); 4];
    if n > 2 * half {
        sums[0] = on.multiply_add(a[half], b[half], sums[0]);
    }
    for (k, ((a, b), (c, d))) in left.zip(right).enumerate() {
        let even = 2 * (k % 2);
        sums[even] = on.multiply_add(*a, *b, sums[even]);
        sums[even + 1] = on.multiply_add(*c, *d, sums[even + 1]);
    }
    on.sum(on.sum(sums[0], sums[1]), on.sum(sums[2], sums[3]))
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

    fn multiply_add(&self, a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }
}
