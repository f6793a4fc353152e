use libration::internals::linear::least_squares;

#[test]
fn a_line_through_points_is_the_best_one() {
    // Residuals (1, −2, 1)/6 are orthogonal to both columns: y = 2 + 3x.
    let matrix = [vec![1.0, 0.0], vec![1.0, 1.0], vec![1.0, 2.0]];
    let right = [2.0 + 1.0 / 6.0, 5.0 - 2.0 / 6.0, 8.0 + 1.0 / 6.0];
    let line = least_squares(&matrix, &right).unwrap();
    assert!((line[0] - 2.0).abs() < 1e-14 && (line[1] - 3.0).abs() < 1e-14, "{line:?}");
}

#[test]
fn dependent_columns_are_refused() {
    assert_eq!(least_squares(&[vec![1.0, 2.0], vec![3.0, 6.0]], &[1.0, 1.0]), None);
    assert_eq!(least_squares(&[vec![1.0, 2.0]], &[1.0]), None);
}
