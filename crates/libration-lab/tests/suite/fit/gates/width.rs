//! The angle through which a bob moves while it blocks the beam of a gate.

use libration_lab::internals::fit::gates::width::{PassingDisc, PassingFlag};

const DISCS: [PassingDisc; 4] = [
    PassingDisc { radius: 0.0125, centre: 1.0, beam: 1.0 },
    PassingDisc { radius: 0.0125, centre: 1.0, beam: 1.01 },
    PassingDisc { radius: 0.3, centre: 0.5, beam: 0.25 },
    PassingDisc { radius: 0.02, centre: 0.7, beam: 0.6801 },
];

/// At the ends of the passage the beam is one radius from the middle of the disc.
#[test]
fn the_beam_is_on_the_edge_where_the_passage_begins() {
    for disc in DISCS {
        let half = 0.5 * disc.width();
        let (across, along) = (disc.beam * libm::sin(half), disc.beam * libm::cos(half) - disc.centre);
        let apart = libm::hypot(across, along);
        assert!((apart / disc.radius - 1.0).abs() < 1e-12, "{disc:?} {apart}");
    }
}

#[test]
fn slopes_are_what_the_width_changes_by() {
    for disc in DISCS {
        let step = 1e-6 * disc.radius;
        let moved = |index: usize, by: f64| {
            let mut sizes = [disc.radius, disc.centre, disc.beam];
            sizes[index] += by;
            let [radius, centre, beam] = sizes;
            PassingDisc { radius, centre, beam }.width()
        };
        for (index, slope) in disc.slopes().into_iter().enumerate() {
            let computed = (moved(index, step) - moved(index, -step)) / (2.0 * step);
            assert!(
                (computed - slope).abs() < 1e-5 * disc.slopes()[0],
                "{disc:?} {index}: {computed} {slope}"
            );
        }
    }
}

/// sin φ = r/d, and its differences.
#[test]
fn a_flat_flag_passes_with_straight_edges() {
    let flag = PassingFlag { half: 0.015, beam: 0.3 };
    assert!((flag.width() - 0.100_041_713_611_5).abs() < 1e-12, "{}", flag.width());
    let [by_half, by_beam] = flag.slopes();
    let moved = |half: f64, beam: f64| PassingFlag { half: 0.015 + half, beam: 0.3 + beam }.width();
    let slope = |half: f64, beam: f64| (moved(half, beam) - moved(-half, -beam)) / 2e-6;
    assert!(
        (by_half / slope(1e-6, 0.0) - 1.0).abs() < 1e-8 && (by_beam / slope(0.0, 1e-6) - 1.0).abs() < 1e-7
    );
}
