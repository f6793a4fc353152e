//! The looks of curves and points. Okabe and Ito's colours, which colour-blind readers can distinguish, are each joined with a dash pattern or a
//! marker, so that no two curves differ by colour alone.

use crate::chart::{Look, Mark};

/// The colour of axes and letters.
pub const INK: &str = "#000000";
/// The colour of the background.
pub const PAPER: &str = "#FFFFFF";
/// Grey, for curves that serve comparison only.
const GREY: &str = "#767676";

/// Okabe and Ito, "Color Universal Design" (2008), without their yellow, which is invisible on white.
const COLOURS: [&str; 7] = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", INK, "#E69F00", "#56B4E9"];

/// The colours for dark pages: the same hues, light enough to contrast with the page.
pub const DARK: [(&str, &str); 9] = [
    (PAPER, "#121417"),
    (INK, "#EDEDED"),
    (GREY, "#A3A3A3"),
    ("#0072B2", "#3FA0E0"),
    ("#D55E00", "#F57C2A"),
    ("#009E73", "#23C495"),
    ("#CC79A7", "#E59AC4"),
    ("#E69F00", "#F2B632"),
    ("#56B4E9", "#A5DAF8"),
];

/// Five dash patterns; with seven colours they give 35 looks before one repeats.
const DASHES: [&[f64]; 5] =
    [&[], &[8.0, 3.5], &[2.5, 2.5], &[10.0, 3.0, 2.5, 3.0], &[13.0, 3.0, 2.5, 3.0, 2.5, 3.0]];

/// Red, green and blue of a colour written as `#RRGGBB`; black, if it is written otherwise.
pub fn rgb(colour: &str) -> [u8; 3] {
    let part = |from: usize| colour.get(from..from + 2).and_then(|hex| u8::from_str_radix(hex, 16).ok());
    [1, 3, 5].map(|from| part(from).unwrap_or(0))
}

/// The look of the curve with this index.
pub fn curve(number: usize) -> Look {
    let mark = Mark::Line(DASHES[number % DASHES.len()]);
    Look { colour: COLOURS[number % COLOURS.len()], width: 1.9, opacity: 1.0, mark }
}

/// The looks of curves by the names of their families, such as a series with one, two and three terms: a family has one colour, and its curves
/// differ by their dashes. A family of more than five curves goes on in other colours.
pub fn of_families<'a>(families: impl IntoIterator<Item = &'a str>) -> Vec<Look> {
    let mut names: Vec<&str> = vec![];
    let mut used: Vec<(usize, usize)> = vec![];
    for family in families {
        let first = names.iter().position(|name| *name == family).unwrap_or_else(|| {
            names.push(family);
            names.len() - 1
        });
        let wish =
            |step: usize| ((first + step / DASHES.len()) % COLOURS.len(), (first + step) % DASHES.len());
        let free = (0..COLOURS.len() * DASHES.len()).map(wish).find(|look| !used.contains(look));
        used.push(free.unwrap_or_else(|| wish(0)));
    }
    let look = |(colour, dashes): (usize, usize)| Look {
        colour: COLOURS[colour],
        mark: Mark::Line(DASHES[dashes]),
        ..curve(0)
    };
    used.into_iter().map(look).collect()
}

/// The look of a set of markers with this index.
pub fn markers(number: usize) -> Look {
    Look { width: 4.0, mark: Mark::Markers(number), ..curve(number) }
}

/// The look of marks on the curve with this index.
pub fn marks(number: usize) -> Look {
    Look { width: 2.8, ..markers(number) }
}

/// The look of dots from a sweep: large where the parameter rises; smaller, so that a rim of the large dots stays visible, where it falls.
pub fn swept(rising: bool) -> Look {
    let (colour, width) = if rising { (COLOURS[4], 2.6) } else { (COLOURS[5], 1.5) };
    Look { colour, width, ..markers(0) }
}

/// The look of one of several clouds of points. `all` is the number of points in all clouds: the dots are smaller if there are many, but always
/// large enough for a projector.
pub fn dots(number: usize, all: usize) -> Look {
    let width = if all > 20_000 {
        0.7
    } else if all > 3_000 {
        1.0
    } else {
        1.4
    };
    Look { width, mark: Mark::Markers(0), ..markers(number) }
}

/// The look of measurements; the markers are smaller if there are many.
pub fn measurements(count: usize) -> Look {
    measurements_of(0, count)
}

/// The look of one of several sets of measurements.
pub fn measurements_of(number: usize, count: usize) -> Look {
    let width = match count {
        0..=25 => 3.6,
        26..=60 => 2.8,
        _ => 2.2,
    };
    Look { width, ..markers(number) }
}

/// The look of events of a motion, next to curves of the first colours.
pub fn turning_points(count: usize) -> Look {
    Look { colour: COLOURS[4], ..measurements(count) }
}

/// The thin line that joins the markers with this index.
pub fn thin(number: usize) -> Look {
    Look { width: 1.0, ..curve(number) }
}

/// A thin grey line, for approximations and zero lines.
pub fn reference() -> Look {
    Look { colour: GREY, width: 1.3, opacity: 1.0, mark: Mark::Line(&[5.0, 3.5]) }
}

/// The solid line of the exact law.
pub fn exact_law() -> Look {
    Look { colour: COLOURS[1], width: 2.0, opacity: 1.0, mark: Mark::Line(&[]) }
}

/// The heavy black line of a separatrix.
pub fn separatrix() -> Look {
    Look { colour: INK, width: 2.6, opacity: 1.0, mark: Mark::Line(&[]) }
}

/// The look of a shaded range beneath curves.
pub fn band() -> Look {
    Look { colour: GREY, width: 0.0, opacity: 0.25, mark: Mark::Band }
}
