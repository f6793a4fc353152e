//! The error of angles caused by an uncertain pivot, common to all of them.

/// The pivot of the angles of positions, with the derivatives of the angles: the centre of the circle through the positions, or a given position
/// that contradicts them.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedPivot {
    /// Position of the pivot, in the unit of the positions.
    pub position: [f64; 2],
    /// Covariance of the position, in the square of that unit.
    pub covariance: [[f64; 2]; 2],
    /// Derivatives of each angle with respect to the position, in radians per unit.
    pub derivatives: Vec<[f64; 2]>,
    /// The centre of the circle through the positions, if a different position was given. The difference is then the half-width of a rectangular
    /// distribution, whose covariance is above.
    pub contradicted_by: Option<[f64; 2]>,
}

impl FittedPivot {
    /// Changes of the angles for two independent errors of the position, each of one standard deviation.
    #[must_use]
    pub fn errors(&self) -> [Vec<f64>; 2] {
        // The lower triangle whose product with its transpose is the covariance.
        let [[xx, xy], [_, yy]] = self.covariance;
        let first = xx.max(0.0).sqrt();
        let both = if first > 0.0 { xy / first } else { 0.0 };
        let second = (yy - both * both).max(0.0).sqrt();
        let along = |step: [f64; 2]| {
            self.derivatives.iter().map(|by| by[0] * step[0] + by[1] * step[1]).collect::<Vec<f64>>()
        };
        [along([first, both]), along([0.0, second])]
    }

    /// `true` if both are the centre of the same circle, or the same given position.
    #[must_use]
    pub fn is_shared_with(&self, other: &Self) -> bool {
        if self.contradicted_by.is_some() && other.contradicted_by.is_some() {
            return self.position.map(f64::to_bits) == other.position.map(f64::to_bits);
        }
        let bits = |pivot: &Self| {
            let [[xx, xy], [_, yy]] = pivot.covariance;
            [pivot.position[0], pivot.position[1], xx, xy, yy].map(f64::to_bits)
        };
        bits(self) == bits(other)
    }

    /// The pivot for these rows only.
    pub(in crate::measurement) fn of_rows(&self, rows: &[usize]) -> Self {
        Self { derivatives: rows.iter().map(|&row| self.derivatives[row]).collect(), ..*self }
    }
}
