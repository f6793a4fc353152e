use libration::internals::taylor::{largest_change, largest_changes};

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

#[test]
fn every_lane_has_its_own_length() {
    let series = [[7.0, 7.0], [1.0, -3.0], [-2.0, 0.5]];
    let both = [0.5 + 2.0 * 0.25, 3.0 * 0.25 + 0.5 * 0.0625];
    assert_eq!(largest_changes(&series, &[0.5, -0.25]).map(f64::to_bits), both.map(f64::to_bits));
    assert_eq!(largest_change(&series, 1, -0.25).to_bits(), both[1].to_bits());
}
