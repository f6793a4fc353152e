//! A curve with a few coefficients through a few points, robust to an outlier among them.

use libration_lab::internals::fit::cycles::local_fit::{LocalFit, Points, powers};

fn line_with(outlier: f64) -> LocalFit {
    let mut points = Points::with_width(2);
    for step in -5..=5 {
        let x = f64::from(step) / 5.0;
        let error = if step == 2 { outlier } else { 0.01 * f64::from(step * step % 3 - 1) };
        points.push(powers(x, 1.0), 0.5 + 2.0 * x + error, 0.01);
    }
    points.fit(Some(1.0)).unwrap()
}

#[test]
fn an_outlier_does_not_draw_the_curve() {
    let (clean, spoilt) = (line_with(0.0), line_with(3.0));
    assert!((clean.coefficients[0] - 0.5).abs() < 0.01 && (clean.coefficients[1] - 2.0).abs() < 0.02);
    assert!((clean.coefficients[0] - spoilt.coefficients[0]).abs() < 0.003, "{spoilt:?}");
    assert!((clean.coefficients[1] - spoilt.coefficients[1]).abs() < 0.005, "{spoilt:?}");
}
