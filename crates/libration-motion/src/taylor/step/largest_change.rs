//! The largest change of a series in a step.

use libration_kernels::dispatch::{Kernel, dispatch_lanes};
use libration_kernels::fused::FusedMultiplyAdd;
use libration_numbers::internals::algebra::lanes;

/// An upper bound on the change of a series in steps of these lengths: Σ|cₙhⁿ| without c₀, in two sums, neither of which waits for the other.
#[inline(always)]
pub fn largest_changes<const N: usize>(series: &[[f64; N]], lengths: &[f64; N]) -> [f64; N] {
    let squares: [f64; N] = lanes(|lane| lengths[lane] * lengths[lane]);
    let pairs = series[1..].rchunks_exact(2);
    let left_over = pairs.remainder();
    let [mut lower, mut higher]: [[f64; N]; 2] = [[0.0; N]; 2];
    for pair in pairs {
        lower = lanes(|lane| lower[lane].fma(squares[lane], pair[0][lane].abs()));
        higher = lanes(|lane| higher[lane].fma(squares[lane], pair[1][lane].abs()));
    }
    let first: [f64; N] = left_over.first().copied().unwrap_or([0.0; N]);
    lanes(|lane| {
        let length = lengths[lane].abs();
        let sum = higher[lane].fma(length, lower[lane]) * length;
        if left_over.is_empty() { sum } else { (sum + first[lane].abs()) * length }
    })
}

/// The same bound in one lane.
pub fn largest_change<const N: usize>(series: &[[f64; N]], lane: usize, length: f64) -> f64 {
    dispatch_lanes::<N, _>(LargestChanges { series, lengths: &[length; N] })[lane]
}

/// The bounds for all lanes, compiled for each instruction set.
struct LargestChanges<'s, const N: usize> {
    series: &'s [[f64; N]],
    lengths: &'s [f64; N],
}

impl<const N: usize> Kernel for LargestChanges<'_, N> {
    type Output = [f64; N];

    #[inline(always)]
    fn run(self) -> [f64; N] {
        largest_changes(self.series, self.lengths)
    }
}
