//! Limit beyond which a difference is more than chance.

/// A difference of more standard uncertainties than this is not taken for chance: among normal errors one in 370 is as large, so
/// that of the ten or so comparisons made for one measurement one in some forty is a false alarm.
pub const SIGNIFICANT: f64 = 3.0;
