//! Names of coordinates that are angles.

/// Greek letters that are used for angles.
const LETTERS: [&str; 8] = ["theta", "vartheta", "phi", "varphi", "psi", "alpha", "beta", "gamma"];

/// Returns `true` if a coordinate with this name counts as an angle: a Greek letter that is used for angles, with or without a number after it.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quantity::is_angle_name;
/// assert!(is_angle_name("theta") && is_angle_name("theta1") && is_angle_name("phi_2"));
/// assert!(!is_angle_name("x") && !is_angle_name("theta_x") && !is_angle_name("omega"));
/// ```
#[must_use]
pub fn is_angle_name(name: &str) -> bool {
    LETTERS.contains(&name.trim_end_matches(|c: char| c.is_ascii_digit() || c == '_'))
}
