//! The looks of curves and points: Okabe and Ito's colours, which colour-blind readers can tell apart,
//! each joined with a dash pattern or a marker so that no two curves differ by colour alone.

use super::chart::{Look, Mark};

/// Okabe and Ito, "Color Universal Design" (2008); without their yellow, which vanishes on white.
const COLOURS: [&str; 7] = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#000000", "#E69F00", "#56B4E9"];

/// Five patterns beside seven colours: 35 looks before one comes again.
const DASHES: [&str; 5] = ["", "10 4", "3 3", "12 4 3 4", "16 4 3 4 3 4"];

/// Grey, for what is there for comparison only.
const GREY: &str = "#767676";

/// The look of the curve with this number.
pub(crate) fn curve(number: usize) -> Look {
    Look {
        colour: COLOURS[number % COLOURS.len()],
        width: 2.4,
        mark: Mark::Line(DASHES[number % DASHES.len()]),
    }
}

/// The look of a set of markers with this number.
pub(crate) fn markers(number: usize) -> Look {
    Look { colour: COLOURS[number % COLOURS.len()], width: 5.5, mark: Mark::Markers(number) }
}

/// The look of marks on the curve with this number.
pub(crate) fn marks(number: usize) -> Look {
    Look { width: 3.6, ..markers(number) }
}

/// The look of one of several clouds of points, which have so many together: smaller where there are many.
pub(crate) fn dots(number: usize, all: usize) -> Look {
    let width = if all > 20_000 {
        0.5
    } else if all > 3_000 {
        0.8
    } else {
        1.5
    };
    Look { width, mark: Mark::Markers(0), ..markers(number) }
}

/// The look of measurements: smaller where there are many.
pub(crate) fn measurements(count: usize) -> Look {
    measurements_of(0, count)
}

/// The look of one of several sets of measurements.
pub(crate) fn measurements_of(number: usize, count: usize) -> Look {
    Look { width: if count > 60 { 3.0 } else { 5.0 }, ..markers(number) }
}

/// The look of what happens at single times of a motion, beside curves of the first colours.
pub(crate) fn turning_points(count: usize) -> Look {
    Look { colour: COLOURS[4], ..measurements(count) }
}

/// The thin line that joins the markers with this number.
pub(crate) fn thin(number: usize) -> Look {
    Look { width: 1.2, ..curve(number) }
}

/// A thin grey line, for approximations and zero lines.
pub(crate) fn reference() -> Look {
    Look { colour: GREY, width: 1.6, mark: Mark::Line("6 4") }
}

/// The solid line of the exact law.
pub(crate) fn exact_law() -> Look {
    Look { colour: COLOURS[1], width: 2.8, mark: Mark::Line("") }
}

/// The heavy black line of a separatrix.
pub(crate) fn separatrix() -> Look {
    Look { colour: "#000000", width: 3.4, mark: Mark::Line("") }
}
