//! Black and Vel: equations (1) to (54), the appendices, Fig. 1, and the claims of the text.

use super::statement::{PrintedStatement, statement, text_after};

mod approximations;
mod equation_of_motion;
mod integral;
mod fourier;
mod sizes;
mod third_order;
mod two_harmonics;
mod forms;
mod gauges;
mod in_amplitude;
mod iteration;
mod accuracy;
mod damping;
mod figure;
mod regimes;
mod appendix_a;
mod appendix_b;
mod appendix_c;

/// The statements, in groups.
pub(super) const STATEMENTS: &[&[PrintedStatement]] = &[
    equation_of_motion::STATEMENTS,
    approximations::STATEMENTS,
    integral::STATEMENTS,
    fourier::STATEMENTS,
    two_harmonics::STATEMENTS,
    sizes::STATEMENTS,
    third_order::STATEMENTS,
    forms::STATEMENTS,
    gauges::STATEMENTS,
    iteration::STATEMENTS,
    in_amplitude::STATEMENTS,
    figure::STATEMENTS,
    regimes::STATEMENTS,
    accuracy::STATEMENTS,
    damping::STATEMENTS,
    appendix_a::STATEMENTS,
    appendix_b::STATEMENTS,
    appendix_c::STATEMENTS,
];
