//! Norms of vectors and of matrices of derivatives.

/// The Euclidean norm of a vector.
pub fn norm(vector: &[f64]) -> f64 {
    vector.iter().fold(0.0, |norm: f64, x| libm::hypot(norm, *x))
}

/// The Frobenius norm of a square matrix of derivatives by the start, whose rows and columns are measured in the units of the components.
pub fn norm_of_map(numbers: usize, units: &[f64], entry: impl Fn(usize, usize) -> f64) -> f64 {
    let entries = (0..numbers).flat_map(|i| (0..numbers).map(move |j| (i, j)));
    entries.fold(0.0, |norm: f64, (i, j)| libm::hypot(norm, entry(i, j) * units[j] / units[i]))
}
