mod bisection;
mod interpolation;
mod polynomial;
mod sign_changes;
