//! Negative values are told from options.

use libration_queries::internals::negative::protect_negative_values;
use std::ffi::OsString;

#[test]
fn options_stay_options() {
    let given = ["--json", "-o", "-30deg", "-.5", "-pi/2", "-Inf", "60deg", "-"].map(OsString::from);
    let expected = ["--json", "-o", " -30deg", " -.5", " -pi/2", " -Inf", "60deg", "-"].map(OsString::from);
    assert_eq!(protect_negative_values(given.into_iter()), expected);
}
