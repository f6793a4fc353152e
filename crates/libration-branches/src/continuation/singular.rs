//! The equations of singular points.

use super::family::{Family, Image};
use super::node::Tests;
use super::space::Space;
use super::special::Test;

/// Motions of a space at which a test function vanishes: as many equations as unknowns over one parameter, one fewer over two.
#[derive(Clone, Debug)]
pub(super) struct Singular<'a> {
    pub(super) family: &'a Family<'a>,
    pub(super) space: Space,
    pub(super) test: Test,
    /// The equilibrium, if the motion is one for all parameters; otherwise the state belongs to the unknowns, before the parameters.
    pub(super) rest: Option<&'a [f64]>,
}

impl Singular<'_> {
    /// The state and the parameters of a vector of unknowns.
    pub(super) fn parts<'p>(&'p self, position: &'p [f64]) -> (&'p [f64], &'p [f64]) {
        match self.rest {
            Some(state) => (state, position),
            None => position.split_at(self.family.layout.numbers().min(position.len())),
        }
    }

    pub(super) fn image(&self, position: &[f64], tolerance: f64) -> Option<Image> {
        let (state, parameters) = self.parts(position);
        self.family.image(self.space, state, parameters, tolerance)
    }

    /// Residuals of the equations, in units of the state, followed by the test function.
    pub(super) fn values(&self, position: &[f64], units: &[f64], tolerance: f64) -> Option<Vec<f64>> {
        let image = self.image(position, tolerance)?;
        let test = self.test.of(&Tests::new(&image, 0.0)?);
        if self.rest.is_some() {
            return Some(vec![test]);
        }
        Some(image.defect.iter().zip(units).map(|(d, unit)| d / unit).chain([test]).collect())
    }

    /// Derivatives of the values with respect to the unknowns, in scaled units, by central differences, to about ten digits.
    pub(super) fn slopes(&self, position: &[f64], units: &[f64], tolerance: f64) -> Option<Vec<Vec<f64>>> {
        /// Step of the differences, for which the truncation error and the rounding error are about equal.
        const ASIDE: f64 = 1e-5;
        let column = |j: usize| {
            let beside = |sign: f64| {
                let mut there = position.to_vec();
                there[j] += sign * ASIDE * units[j];
                self.values(&there, units, tolerance)
            };
            let (after, before) = (beside(1.0)?, beside(-1.0)?);
            Some(after.iter().zip(before).map(|(a, b)| (a - b) / (2.0 * ASIDE)).collect::<Vec<_>>())
        };
        let columns: Vec<Vec<f64>> = (0..position.len()).map(column).collect::<Option<_>>()?;
        Some((0..columns.first()?.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect())
    }
}
