//! Several double-precision numbers at once, lane by lane.

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

/// Σ aᵢ·b_{n−1−i} in each lane.
///
/// In four sums, which a processor forms at the same time. The products of the first and the last, which hold the
/// newest coefficients, come last: all else can be under way before these are known.
#[inline(always)]
pub(super) fn convolution<const N: usize>(a: &[[f64; N]], b: &[[f64; N]]) -> [f64; N] {
    let n = a.len().min(b.len());
    let (a, b) = (&a[..n], &b[..n]);
    if n < 2 {
        return if n == 0 { [0.0; N] } else { lanes(|lane| a[0][lane] * b[0][lane]) };
    }
    let inner = inner_products(&a[1..n - 1], &b[1..n - 1]);
    lanes(|lane| inner[lane] + (a[0][lane] * b[n - 1][lane] + a[n - 1][lane] * b[0][lane]))
}

#[inline(always)]
fn inner_products<const N: usize>(a: &[[f64; N]], b: &[[f64; N]]) -> [f64; N] {
    let (fours, rest) = a.as_chunks::<4>();
    let (rest_of_b, fours_of_b) = b.as_rchunks::<4>();
    let mut sums = [[0.0; N]; 4];
    for (a, b) in fours.iter().zip(fours_of_b.iter().rev()) {
        for k in 0..4 {
            for lane in 0..N {
                sums[k][lane] += a[k][lane] * b[3 - k][lane];
            }
        }
    }
    let mut last = [0.0; N];
    for (a, b) in rest.iter().zip(rest_of_b.iter().rev()) {
        for lane in 0..N {
            last[lane] += a[lane] * b[lane];
        }
    }
    lanes(|lane| (sums[0][lane] + sums[2][lane]) + (sums[1][lane] + sums[3][lane]) + last[lane])
}
