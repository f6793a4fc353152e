//! Several double-precision numbers at once, lane by lane, and sums of products in an order that many of them can be formed in.

/// One number for each lane. Other than `std::array::from_fn` it is always compiled into its caller, and so for the same
/// instruction set.
#[inline(always)]
pub(crate) fn lanes<const N: usize>(mut number: impl FnMut(usize) -> f64) -> [f64; N] {
    let mut all = [0.0; N];
    for (lane, one) in all.iter_mut().enumerate() {
        *one = number(lane);
    }
    all
}

/// What a sum of products is made of.
pub(crate) trait MultiplyAdd {
    type Element: Copy;

    fn nothing(&self) -> Self::Element;
    fn sum(&self, a: Self::Element, b: Self::Element) -> Self::Element;
    /// a·b + c with one rounding.
    fn multiply_add(&self, a: Self::Element, b: Self::Element, c: Self::Element) -> Self::Element;
}

/// Σ aᵢ·b_{n−1−i}.
///
/// In four sums, which a processor forms at the same time, from the middle to the ends: there are the newest coefficients,
/// and all else can be under way before these are known.
#[inline(always)]
pub(crate) fn convolution<S: MultiplyAdd>(on: &S, a: &[S::Element], b: &[S::Element]) -> S::Element {
    let n = a.len().min(b.len());
    let (a, b) = (&a[..n], &b[..n]);
    match n {
        0 => on.nothing(),
        1 => on.multiply_add(a[0], b[0], on.nothing()),
        _ => {
            let inner = inner_products(on, &a[1..n - 1], &b[1..n - 1]);
            on.multiply_add(a[n - 1], b[0], on.multiply_add(a[0], b[n - 1], inner))
        }
    }
}

#[inline(always)]
fn inner_products<S: MultiplyAdd>(on: &S, a: &[S::Element], b: &[S::Element]) -> S::Element {
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

#[cfg(test)]
mod tests {
    use super::super::Lanes;
    use super::*;

    #[test]
    fn convolutions_of_every_length_are_those_of_whole_numbers() {
        let numbers = |factor: u32, length: u32| (0..length).map(move |n| f64::from(n * n * factor % 17));
        for length in 0..20 {
            let (a, b): (Vec<f64>, Vec<f64>) = (numbers(3, length).collect(), numbers(5, length).collect());
            let plain = a.iter().zip(b.iter().rev()).fold(0.0, |sum, (a, b)| sum + a * b);
            let [sum] = convolution(&Lanes::<1>, a.as_chunks().0, b.as_chunks().0);
            assert_eq!(sum.to_bits(), plain.to_bits(), "{length}");
        }
    }
}
