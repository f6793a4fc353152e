//! The sentences of a report.

use libration_queries::internals::fit_report::sentence;

#[test]
fn sentences_that_begin_with_a_symbol_keep_it() {
    for (text, expected) in [
        ("the fit did not settle", "The fit did not settle."),
        ("a simple pendulum is longer", "A simple pendulum is longer."),
        ("cycles: a few.", "Cycles: a few."),
        ("β is 3.7", "β is 3.7."),
        ("y grows upwards", "y grows upwards."),
        ("omega0 is free", "omega0 is free."),
        ("swing.csv has no header", "swing.csv has no header."),
        ("T₀ by single cycles", "T₀ by single cycles."),
        ("--from was given", "--from was given."),
        ("1 row is an outlier", "1 row is an outlier."),
        ("θ is an angle!", "θ is an angle!"),
        ("", "."),
    ] {
        assert_eq!(sentence(text), expected);
    }
}
