//! Small square matrices, row by row.

/// A square matrix.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::taylor) struct Matrix {
    pub(in crate::taylor) size: usize,
    pub(in crate::taylor) entries: Vec<f64>,
}

impl Matrix {
    pub(in crate::taylor) fn zero(size: usize) -> Self {
        Self { size, entries: vec![0.0; size * size] }
    }

    pub(in crate::taylor) fn one(size: usize) -> Self {
        let mut one = Self::zero(size);
        one.add_to_diagonal(1.0);
        one
    }

    #[inline(always)]
    pub(in crate::taylor) fn row(&self, row: usize) -> &[f64] {
        &self.entries[self.size * row..self.size * (row + 1)]
    }

    #[inline(always)]
    pub(in crate::taylor) fn row_mut(&mut self, row: usize) -> &mut [f64] {
        &mut self.entries[self.size * row..self.size * (row + 1)]
    }

    pub(in crate::taylor) fn is_finite(&self) -> bool {
        self.entries.iter().all(|entry| entry.is_finite())
    }

    /// Sets the matrix to the product of two others of its size.
    pub(in crate::taylor) fn set_product(&mut self, a: &Self, b: &Self) {
        let (a, b, product) = (&a.entries, &b.entries, &mut self.entries);
        match self.size {
            2 => multiply::<2>(a, b, product),
            3 => multiply::<3>(a, b, product),
            4 => multiply::<4>(a, b, product),
            6 => multiply::<6>(a, b, product),
            size => multiply_any(a, b, product, size),
        }
    }

    /// Transposes the matrix in place.
    pub(in crate::taylor) fn transpose(&mut self) {
        for row in 0..self.size {
            for column in 0..row {
                self.entries.swap(self.size * row + column, self.size * column + row);
            }
        }
    }

    pub(in crate::taylor) fn add_to_diagonal(&mut self, value: f64) {
        self.entries.iter_mut().step_by(self.size + 1).for_each(|entry| *entry += value);
    }

    pub(in crate::taylor) fn add(&mut self, factor: f64, other: &Self) {
        self.entries.iter_mut().zip(&other.entries).for_each(|(entry, other)| *entry += factor * other);
    }

    pub(in crate::taylor) fn largest_row_sum(&self) -> f64 {
        let sum = |row: &[f64]| row.iter().map(|entry| entry.abs()).sum();
        self.entries.chunks_exact(self.size).map(sum).fold(0.0, f64::max)
    }
}

fn multiply<const N: usize>(a: &[f64], b: &[f64], product: &mut [f64]) {
    let (b, _) = b.as_chunks::<N>();
    for (a, product) in a.as_chunks::<N>().0.iter().zip(product.as_chunks_mut::<N>().0) {
        let mut sums = [0.0; N];
        for (factor, row) in a.iter().zip(b) {
            sums.iter_mut().zip(row).for_each(|(sum, entry)| *sum += factor * entry);
        }
        *product = sums;
    }
}

/// The product for large matrices, most of whose entries are zero in chains of oscillators.
fn multiply_any(a: &[f64], b: &[f64], product: &mut [f64], size: usize) {
    for (a, product) in a.chunks_exact(size).zip(product.chunks_exact_mut(size)) {
        product.fill(0.0);
        for (factor, row) in a.iter().zip(b.chunks_exact(size)).filter(|(factor, _)| **factor != 0.0) {
            product.iter_mut().zip(row).for_each(|(sum, entry)| *sum += factor * entry);
        }
    }
}
