use libration::roots::{Tolerance, bisect, zero_between};

/// The zero and the number of evaluations.
fn counted(a: f64, b: f64, tolerance: Tolerance, f: impl Fn(f64) -> f64) -> (Option<f64>, u32) {
    let mut count = 0;
    let zero = zero_between([(a, f(a)), (b, f(b))], tolerance, |x| {
        count += 1;
        f(x)
    });
    (zero, count)
}

#[test]
fn zeros_of_smooth_functions_are_found_to_the_last_bit_in_few_evaluations() {
    let (zero, count) = counted(0.0, 3.0, Tolerance::LAST_BIT, |x| x * x * x - 2.0);
    assert!((zero.unwrap() - 1.2599210498948732).abs() < 3e-16, "{zero:?}");
    assert!(count <= 15, "{count}");
}

/// Functions with jumps, poles, high powers and flat parts on one side, in brackets of any size.
#[test]
fn no_function_takes_ten_evaluations_more_than_bisection() {
    type Wild = fn(f64, f64) -> f64;
    let wild: [Wild; 6] = [
        |x, c| if x < c { -1.0 } else { 1.0 },
        |x, c| if x < c { -1e-300 } else { 1e300 },
        |x, c| if x < c { -f64::INFINITY } else { 1.0 },
        |x, c| libm::pow(x - c, 21.0),
        |x, c| libm::exp(40.0 * (x - c)) - 1.0,
        |x, c| 1.0 / (x - c),
    ];
    let tolerances =
        [Tolerance::LAST_BIT, Tolerance::absolute(1e-9), Tolerance::absolute(0.1), Tolerance::relative(1e-6)];
    let brackets = [(-1.0, 1.0), (0.0, 2.0), (-1e10, 1e-3), (1.0, -1e10)];
    for (f, &tolerance) in wild.iter().flat_map(|f| tolerances.iter().map(move |tolerance| (f, tolerance))) {
        for (number, (a, b)) in (1..200).flat_map(|n| brackets.map(|bracket| (n, bracket))) {
            let c = a + (b - a) * f64::from(number) / 200.0 * 0.999;
            let (zero, count) = counted(a, b, tolerance, |x| f(x, c));
            let mut bisections = 0;
            let _ = bisect([a, b], tolerance, |x| {
                bisections += 1;
                (f(x, c) > 0.0) == (f(a, c) > 0.0)
            });
            assert!(zero.is_some() && count <= bisections + 10, "{c}: {zero:?}, {count}, {bisections}");
        }
    }
}

#[test]
fn a_jump_is_enclosed_to_the_tolerance() {
    let (zero, _) =
        counted(0.0, 5.0, Tolerance::absolute(1e-12), |x| if x < 1.0 { -1.0 } else { f64::INFINITY });
    assert!((zero.unwrap() - 1.0).abs() <= 1e-12, "{zero:?}");
    let (zero, _) = counted(0.0, 5.0, Tolerance::LAST_BIT, |x| if x < 1.0 { -1.0 } else { 2.0 });
    assert_eq!(zero, Some(1.0_f64.next_down()));
}

#[test]
fn without_a_change_of_sign_there_is_no_zero() {
    assert_eq!(counted(1.0, 2.0, Tolerance::LAST_BIT, |x| x).0, None);
    assert_eq!(counted(-1.0, f64::NAN, Tolerance::LAST_BIT, |x| x).0, None);
    assert_eq!(counted(-1.0, 2.0, Tolerance::LAST_BIT, |x| if x.abs() < 0.9 { f64::NAN } else { x }).0, None);
    assert_eq!(counted(0.0, 2.0, Tolerance::LAST_BIT, |x| x).0, Some(0.0));
}
