//! Distribution of the errors of a state.

use super::matrix::Matrix;

/// The errors that the steps of a motion have added, each propagated to a common time.
///
/// The covariance is stored in units that are powers of two, one for each component, since the squares of errors below 1e-162 are below the
/// range of numbers. While all components have standard deviations between 2⁻²⁰⁰ and 2²⁰⁰ the units are 1.
#[derive(Clone, Debug)]
pub(in crate::taylor) struct Spread {
    /// Exponents of the units.
    pub(in crate::taylor) units: Vec<i32>,
    /// The sum of the squares of all errors, as a covariance matrix in these units.
    pub(in crate::taylor) squares: Matrix,
    /// The derivatives of the state by the state at the start.
    pub(in crate::taylor) flow: Matrix,
    product: Matrix,
}

/// The largest exponent of a standard deviation in its unit: its fourth power is inside the range of numbers.
const LARGEST_EXPONENT: i32 = 200;

/// The exponent of the smallest unit. Deviations below it, which may grow again, are replaced by it.
const SMALLEST_UNIT: i32 = -100_000;

impl Spread {
    /// The spread at the start, without errors.
    pub(in crate::taylor) fn none(numbers: usize) -> Self {
        let zero = || Matrix::zero(numbers);
        Self { units: vec![0; numbers], squares: zero(), flow: Matrix::one(numbers), product: zero() }
    }

    /// Marks the spread as unknown.
    pub(in crate::taylor) fn forget(&mut self) {
        self.squares.entries.fill(f64::NAN);
    }

    /// Propagates the spread to a state with these derivatives by the present one.
    pub(in crate::taylor) fn pass(&mut self, flow: &Matrix) {
        let Self { flow: whole, product, .. } = self;
        product.set_product(flow, whole);
        std::mem::swap(product, whole);
        if self.units.iter().all(|unit| *unit == self.units[0]) {
            self.pass_in_units(flow);
        } else {
            let in_units = self.choose_units(flow);
            self.pass_in_units(&in_units);
        }
        (0..self.units.len()).for_each(|number| self.normalise(number));
    }

    /// Propagates the covariance by the flow in the present units.
    fn pass_in_units(&mut self, flow: &Matrix) {
        let Self { squares, product, .. } = self;
        // The result is symmetric: the transpose of M·C times that of M is M·(M·C)ᵀ.
        product.set_product(flow, squares);
        product.transpose();
        squares.set_product(flow, product);
    }

    /// Replaces the units by those of the largest deviations after this flow, and returns the flow from the units before to them.
    fn choose_units(&mut self, flow: &Matrix) -> Matrix {
        let mut in_units = flow.clone();
        let mut units = vec![0; self.units.len()];
        for (row, unit) in units.iter_mut().enumerate() {
            let exponent_of = |(number, entry): (usize, &f64)| {
                exponent(*entry)
                    .filter(|_| self.deviates(number))
                    .map(|exponent| exponent + self.units[number])
            };
            *unit = flow.row(row).iter().enumerate().filter_map(exponent_of).max().unwrap_or(0);
            let entries = in_units.row_mut(row).iter_mut().zip(&self.units).enumerate();
            for (number, (entry, before)) in entries {
                *entry = if self.deviates(number) { libm::ldexp(*entry, before - *unit) } else { 0.0 };
            }
        }
        self.units = units;
        in_units
    }

    /// Adds an error to each component.
    pub(in crate::taylor) fn blur(&mut self, errors: &[f64]) {
        for (number, error) in errors.iter().enumerate() {
            if let Some(exponent) = exponent(*error) {
                let above = exponent - self.units[number];
                if above > LARGEST_EXPONENT || above < -LARGEST_EXPONENT && !self.deviates(number) {
                    self.change_unit(number, above);
                }
            }
            let error = libm::ldexp(*error, -self.units[number]);
            self.squares.row_mut(number)[number] += error * error;
        }
    }

    /// Adds the covariance of other errors.
    pub(in crate::taylor) fn add(&mut self, mut other: Self) {
        for number in 0..self.units.len() {
            let [unit_here, others] = [self.units[number], other.units[number]];
            let unit = match [self.deviates(number), other.deviates(number)] {
                [true, false] => unit_here,
                [false, true] => others,
                _ => unit_here.max(others),
            };
            self.change_unit(number, unit - unit_here);
            other.change_unit(number, unit - others);
        }
        self.squares.add(1.0, &other.squares);
    }

    /// The square root of the sum of squares of a component.
    pub(in crate::taylor) fn of(&self, number: usize) -> f64 {
        libm::ldexp(self.squares.row(number)[number].sqrt(), self.units[number])
    }

    /// The square root of the sum of squares of a linear combination of the components with these factors.
    pub(in crate::taylor) fn of_sum(&self, factors: &[f64]) -> f64 {
        let deviating = |(number, factor): (usize, &f64)| {
            exponent(*factor).filter(|_| self.deviates(number)).map(|exponent| exponent + self.units[number])
        };
        let largest = factors.iter().enumerate().filter_map(deviating).max().unwrap_or(0);
        let in_units = |(number, factor): (usize, &f64)| {
            if self.deviates(number) { libm::ldexp(*factor, self.units[number] - largest) } else { 0.0 }
        };
        let factors: Vec<f64> = factors.iter().enumerate().map(in_units).collect();
        let row = |row: usize| self.squares.row(row).iter().zip(&factors).map(|(a, b)| a * b).sum::<f64>();
        let sum: f64 = factors.iter().enumerate().map(|(number, factor)| factor * row(number)).sum();
        libm::ldexp(sum.max(0.0).sqrt(), largest)
    }

    /// Chooses the unit of a component anew if its deviation is not of the order of the present unit.
    fn normalise(&mut self, number: usize) {
        if let Some(exponent) = exponent(self.squares.row(number)[number])
            && exponent.abs() > 2 * LARGEST_EXPONENT
        {
            self.change_unit(number, exponent / 2);
            if self.units[number] == SMALLEST_UNIT {
                self.squares.row_mut(number)[number] = 1.0;
            }
        }
    }

    fn deviates(&self, number: usize) -> bool {
        self.squares.row(number)[number] != 0.0
    }

    /// Multiplies the unit of a component by a power of two.
    fn change_unit(&mut self, number: usize, by: i32) {
        let by = by.max(SMALLEST_UNIT - self.units[number]);
        self.units[number] += by;
        let row = self.squares.row_mut(number);
        row.iter_mut().for_each(|entry| *entry = libm::ldexp(*entry, -by));
        for row in 0..self.units.len() {
            let entry = &mut self.squares.row_mut(row)[number];
            *entry = libm::ldexp(*entry, -by);
        }
    }
}

/// The exponent of two of a number; `None` if it is zero or not finite.
fn exponent(number: f64) -> Option<i32> {
    (number.is_finite() && number != 0.0).then(|| libm::ilogb(number))
}
