//! Probabilities of ratios of variances, compared with `scipy.stats.f.sf` 1.17.1.

use libration_lab::internals::statistics::fisher::probability_beyond;

#[test]
fn probabilities_agree_with_scipy() {
    for (ratio, above, below, expected) in [
        (3.2, 1, 1, 0.324510358304438),
        (1.0, 2, 10, 0.4018775720164609),
        (7.5, 2, 14, 0.006110971586793424),
        (0.3, 5, 20, 0.9070758077600316),
        (40.0, 4, 30, 1.28843041886173e-11),
        (1.1, 200, 900, 0.18572545047810973),
        (12.0, 3, 2, 0.07789929041461294),
    ] {
        let computed: f64 = probability_beyond(ratio, above, below);
        assert!((computed - expected).abs() < 1e-12, "{ratio} {above} {below}: {computed}");
    }
    assert_eq!(probability_beyond(0.0, 3, 4), 1.0);
    // F and 1/F with the degrees of freedom exchanged.
    let both = probability_beyond(2.5, 3, 7) + probability_beyond(0.4, 7, 3);
    assert!((both - 1.0_f64).abs() < 1e-13);
}
