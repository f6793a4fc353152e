//! What a pivot that was fitted to positions leaves open in T0, β and the offset: by how much they change with it.

use super::{Beta, Cycles};

/// Adds the difference to what would be found with the pivot moved by one standard deviation.
pub(super) fn add(found: &mut Cycles, moved: &Cycles) {
    found.t0_uncertainty = libm::hypot(found.t0_uncertainty, moved.t0 - found.t0);
    found.offset_uncertainty = libm::hypot(found.offset_uncertainty, moved.offset - found.offset);
    if let (Ok(beta), Ok(moved)) = (&mut found.beta, &moved.beta) {
        *beta = with(beta, moved);
    }
}

fn with(beta: &Beta, moved: &Beta) -> Beta {
    let [of_t0, of_beta] = [moved.t0 - beta.t0, moved.beta - beta.beta];
    let (t0_uncertainty, uncertainty) =
        (libm::hypot(beta.t0_uncertainty, of_t0), libm::hypot(beta.uncertainty, of_beta));
    let both = beta.correlation * beta.t0_uncertainty * beta.uncertainty + of_t0 * of_beta;
    let correlation = both / (t0_uncertainty * uncertainty);
    Beta { uncertainty, t0_uncertainty, correlation, ..*beta }
}
