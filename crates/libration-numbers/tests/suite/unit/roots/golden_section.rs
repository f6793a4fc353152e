use libration::internals::roots::{maximum_between, other_sign_between};

#[test]
fn maxima_are_found() {
    let (position, value) = maximum_between(&mut |x| -(x - 0.3) * (x - 0.3), -1.0, 2.0, 1e-9);
    assert!((position - 0.3).abs() < 1e-8 && value.abs() < 1e-16);
}

/// The parabola (x − 0.3)² − d² has the opposite sign within d of 0.3, and nowhere if it is raised.
#[test]
fn narrow_stretches_of_the_other_sign_are_found() {
    for (width, sign) in [(1e-3, 1.0), (1e-3, -1.0), (1e-6, 1.0)] {
        let dip = |x: f64| sign * ((x - 0.3) * (x - 0.3) - width * width);
        let points = [-1.0, 0.5, 2.0].map(|x| (x, dip(x)));
        let (position, value) = other_sign_between(points, dip).unwrap();
        assert!((position - 0.3).abs() < width && value * sign < 0.0, "{position}");
    }
    let raised = |x: f64| (x - 0.3) * (x - 0.3) + 1e-9;
    assert_eq!(other_sign_between([-1.0, 0.5, 2.0].map(|x| (x, raised(x))), raised), None);
    // The middle value is not the nearest to zero.
    assert_eq!(other_sign_between([(0.0, 1.0), (1.0, 2.0), (2.0, 1.0)], |_| -1.0), None);
}
