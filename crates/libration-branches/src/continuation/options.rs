//! Options of a response.

use super::order::ResonanceOrder;
use super::space::Rotation;

/// Options of a response.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseOptions {
    /// The state from which a motion is looked for at each end of the range; rest, where all numbers are zero, if there is none. Where nothing
    /// drives, the motion from there has to settle to a limit cycle; from a state of rest it is displaced a little.
    pub start: Option<Vec<f64>>,
    /// The value of the parameter at which it is looked for, and followed from both ways; the ends of the range if there is none. Curves that
    /// close within the range are found from there only.
    pub at: Option<f64>,
    /// Number of drive periods after which a motion repeats itself: 1, or more for subharmonic responses; 1 without a drive.
    pub drive_periods: u32,
    /// The angle that rotates in these periods of the drive, for rotating solutions; `None` for librating ones.
    pub rotation: Option<Rotation>,
    /// Orders of sub- and superharmonic responses that are looked for besides, from the free oscillations of one coordinate that the drive
    /// keeps up against the damping to the first order, at sixteen values within the range, by letting both grow to what they are: curves
    /// that close within the range are found so, where nothing leads to them.
    pub orders: Vec<ResonanceOrder>,
    /// Maximum depth of secondary branches (symmetry breaking, period doubling) that are followed.
    pub generations: usize,
    /// Points of one branch.
    pub most_points: usize,
}

impl Default for ResponseOptions {
    fn default() -> Self {
        Self {
            start: None,
            at: None,
            drive_periods: 1,
            rotation: None,
            orders: vec![],
            generations: 2,
            most_points: 3000,
        }
    }
}
