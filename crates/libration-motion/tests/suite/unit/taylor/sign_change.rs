use libration::internals::taylor::{first_sign_change, scaled, sign_changes};

/// (x − 0.2)(x − 0.2001)(x − 0.9).
const CUBIC: [f64; 4] = [-0.2 * 0.2001 * 0.9, 0.2 * 0.2001 + 0.9 * 0.4001, -1.3001, 1.0];

#[test]
fn all_of_several_zeros_are_found() {
    let first = first_sign_change(&CUBIC).unwrap();
    assert!((first - 0.2).abs() < 1e-11, "{first}");
    let all = sign_changes(&CUBIC);
    assert!((all[0] - first).abs() == 0.0);
    assert!((all[1] - 0.2001).abs() < 1e-11 && (all[2] - 0.9).abs() < 1e-15, "{all:?}");
    assert_eq!(all.len(), 3);
}

#[test]
fn zeros_between_two_halves_are_found_once() {
    assert_eq!(sign_changes(&[-0.5, 1.0]).len(), 1);
    // (x − 1/4)(x − 1/2)(x − 3/4).
    let three = sign_changes(&[-0.09375, 0.6875, -1.5, 1.0]);
    assert_eq!(three.len(), 3, "{three:?}");
}

/// Zeros of (x/c)ⁿ = 1 for c over twenty decades, and of x = 1 − c.
#[test]
fn zeros_of_any_size_are_found_to_their_last_bits() {
    for exponent in 0..=66 {
        let small = libm::ldexp(0.75, -exponent);
        for power in 1..=12 {
            let mut binomial = vec![0.0; power + 1];
            (binomial[0], binomial[power]) = (-1.0, (0..power).fold(1.0, |product, _| product / small));
            let position = first_sign_change(&binomial).unwrap();
            assert!((position / small - 1.0).abs() < 4.0 * f64::EPSILON, "{small} {power}: {position}");
        }
        if exponent <= 50 {
            let position = first_sign_change(&[small - 1.0, 1.0]).unwrap();
            assert!((position - (1.0 - small)).abs() <= 2.0 * f64::EPSILON, "{small}: {position}");
        }
    }
}

#[test]
fn zeros_at_the_ends_are_not_inside() {
    assert_eq!(first_sign_change(&[0.0, -1.0, 2.0]), Some(0.5));
    assert_eq!(first_sign_change(&[0.0, 1.0]), None);
    assert_eq!(first_sign_change(&[1.0, -1.0]), None);
    // (x − 1)(x − 1/4)
    assert_eq!(first_sign_change(&[0.25, -1.25, 1.0]), Some(0.25));
}

/// Series of thirty-nine terms with at most one zero, for coefficients of any size.
#[test]
fn long_series_of_any_size_have_the_zero_that_the_short_ones_have() {
    for scale in [1.0, 1e-300, 1e300] {
        // (x − 3/8)(1 + x/2 + … + (x/2)³⁷)
        let growing = |n: i32| if (0..38).contains(&n) { libm::ldexp(scale, -n) } else { 0.0 };
        let product: Vec<f64> = (0..39).map(|n| growing(n - 1) - 0.375 * growing(n)).collect();
        let places = sign_changes(&product);
        assert!(places.len() == 1 && (places[0] - 0.375).abs() < 1e-15, "{scale}: {places:?}");
    }
}

#[test]
fn lengths_whose_powers_overflow_leave_a_polynomial_what_it_is() {
    let fall = scaled([0.5, 0.0, -0.5, 0.0, 0.0].into_iter(), 1e100);
    assert!(fall.iter().all(|term| term.is_finite()), "{fall:?}");
    assert!((first_sign_change(&fall).unwrap() * 1e100 - 1.0).abs() < 1e-15);
}

#[test]
fn touching_is_no_change_of_sign() {
    assert_eq!(first_sign_change(&[0.25, -1.0, 1.0]), None);
    assert_eq!(first_sign_change(&[1.0, -3.0, 3.0]), None);
    assert_eq!(first_sign_change(&[0.0, 0.0]), None);
    assert_eq!(first_sign_change(&[]), None);
}

/// Around a zero of high multiplicity the terms cancel, and each interval seems to contain zeros.
#[test]
fn a_search_among_rounding_errors_ends() {
    // (x − 1/3)³⁹
    let mut power = vec![1.0];
    for _ in 0..39 {
        let shifted = |n: usize| if n == 0 { 0.0 } else { power[n - 1] };
        power = (0..=power.len()).map(|n| shifted(n) - power.get(n).map_or(0.0, |c| c / 3.0)).collect();
    }
    let places = sign_changes(&power);
    // The value exceeds the rounding errors where |x − 1/3|³⁹ > 2⁻⁵³·(x + 1/3)³⁹: below 0.15 and above 0.75.
    assert!(!places.is_empty() && places.iter().all(|x| (0.14..0.77).contains(x)), "{places:?}");
}
