//! The cells of a spreadsheet as text with tabs between them, a line for each row.

use libration_lab::internals::measurement::container::grid::CellGrid;

#[test]
fn cells_keep_their_places_and_far_ones_are_refused() {
    let mut grid = CellGrid::new(1000);
    grid.number(2, 1, -0.25).unwrap();
    grid.text(0, 0, "a\tb").unwrap();
    assert_eq!(grid.into_text().unwrap(), "a b\n\n\t-0.25");
    let mut blank = CellGrid::new(1000);
    blank.text(0, 0, "of Monday").unwrap();
    for (row, column) in [(1, 0), (1, 1), (2, 0), (3, 1)] {
        blank.number(row, column, 0.5).unwrap();
    }
    assert_eq!(blank.into_text().unwrap(), "of Monday\n0.5\t0.5\n0.5\t\n\t0.5");
    let mut words = CellGrid::new(1000);
    let texts = ["0,25", "-1,5e-3", "1,42 s", "1,5 ± 0,1", "L, m", "0.5", "1,5,2", "a,5"];
    for (column, text) in (0..).zip(texts) {
        words.text(0, column, text).unwrap();
    }
    assert_eq!(words.into_text().unwrap(), "0.25\t-1.5e-3\t1.42 s\t1.5 ± 0.1\tL, m\t0.5\t1,5,2\ta,5");
    let mut far = CellGrid::new(1000);
    far.number(0, 2000, 1.0).unwrap();
    assert!(far.into_text().is_err());
    assert!(CellGrid::new(5).text(0, 0, "abcdef").is_err());
}

#[test]
fn commas_before_three_digits_stay_unless_another_cell_decides() {
    let text = |cells: &[&str]| {
        let mut grid = CellGrid::new(1000);
        (0..).zip(cells).for_each(|(row, text)| grid.text(row, 0, text).unwrap());
        grid.into_text().unwrap()
    };
    assert_eq!(text(&["1,000", "900", "1,100"]), "1,000\n900\n1,100");
    assert_eq!(text(&["1,000", "0,25"]), "1.000\n0.25");
}
