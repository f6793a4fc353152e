//! How far a series goes in a step.

/// By how much a series changes at most in a step of this length: Σ|cₙhⁿ| without c₀, in two sums, neither of which waits for the other.
pub(super) fn largest_change<const N: usize>(series: &[[f64; N]], lane: usize, length: f64) -> f64 {
    let (length, square) = (length.abs(), length * length);
    let pairs = series[1..].rchunks_exact(2);
    let left_over = pairs.remainder();
    let [mut lower, mut higher] = [0.0_f64; 2];
    for pair in pairs {
        lower = lower.mul_add(square, pair[0][lane].abs());
        higher = higher.mul_add(square, pair[1][lane].abs());
    }
    let sum = higher.mul_add(length, lower) * length;
    left_over.first().map_or(sum, |c| (sum + c[lane].abs()) * length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_change_is_the_sum_of_the_sizes_of_its_terms() {
        for terms in 3..10_i32 {
            let series: Vec<[f64; 1]> = (0..terms).map(|n| [1.0 - f64::from(n * n)]).collect();
            let sum: f64 = (1..terms).map(|n| (1.0 - f64::from(n * n)).abs() * libm::ldexp(1.0, -n)).sum();
            for length in [0.5, -0.5] {
                assert_eq!(largest_change(&series, 0, length).to_bits(), sum.to_bits(), "{terms} terms");
            }
        }
    }
}
