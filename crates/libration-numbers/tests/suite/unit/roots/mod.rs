mod bisection;
mod golden_section;
mod interpolation;
mod newton;
mod polynomial;
mod sign_changes;
