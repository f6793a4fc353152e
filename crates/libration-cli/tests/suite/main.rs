//! The command as its users meet it: run, with its answers read back.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on should stop where it stands")]

mod architecture;
mod bad_input;
mod chaos;
mod command;
mod decay;
mod derive;
mod drawing;
mod each;
mod examples;
mod expand;
mod expansion_code;
mod fields;
mod figure_data;
mod figure_sizes;
mod figures;
mod files;
mod first_order;
mod fit;
mod fit_budget;
mod fit_lengths_and_gates;
mod fit_trace;
mod formulas;
mod inspect;
mod interrupts;
mod letters;
mod modes;
mod motion;
mod paper;
mod period;
mod resume;
mod screen;
mod simulate;
mod systems;
mod typed_equations;
mod widths;
