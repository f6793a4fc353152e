//! The angle that a bob goes while it blocks the beam of a gate.
//!
//! Seen from the side the bob is a disc of radius r about a point at the distance c from the pivot, and the beam a point at the distance d. It
//! is blocked while the two are no further apart than r, by the law of cosines d² + c² − 2dc·cos φ ≤ r²: on either side for the angle φ
//! with sin²(φ/2) = (r² − (d − c)²)/4dc.

/// A disc and the beam that it passes, in metres.
#[derive(Clone, Copy, Debug)]
pub(super) struct PassingDisc {
    pub(super) radius: f64,
    /// From the pivot to the middle of the disc.
    pub(super) centre: f64,
    /// From the pivot to the beam.
    pub(super) beam: f64,
}

impl PassingDisc {
    /// In radians.
    pub(super) fn width(&self) -> f64 {
        4.0 * libm::asin(self.squared_sine().sqrt())
    }

    /// Its derivatives with respect to radius, centre and beam, in rad/m.
    pub(super) fn slopes(&self) -> [f64; 3] {
        let Self { radius, centre, beam } = *self;
        let (square, product) = (self.squared_sine(), 2.0 * centre * beam);
        let of_square = [
            radius / product,
            (beam - centre) / product - square / centre,
            (centre - beam) / product - square / beam,
        ];
        of_square.map(|slope| 2.0 * slope / (square * (1.0 - square)).sqrt())
    }

    /// sin²(φ/2).
    fn squared_sine(&self) -> f64 {
        let Self { radius, centre, beam } = *self;
        let apart = beam - centre;
        (radius - apart) * (radius + apart) / (4.0 * centre * beam)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
            let moved = |place: usize, by: f64| {
                let mut sizes = [disc.radius, disc.centre, disc.beam];
                sizes[place] += by;
                let [radius, centre, beam] = sizes;
                PassingDisc { radius, centre, beam }.width()
            };
            for (place, slope) in disc.slopes().into_iter().enumerate() {
                let found = (moved(place, step) - moved(place, -step)) / (2.0 * step);
                assert!((found - slope).abs() < 1e-5 * disc.slopes()[0], "{disc:?} {place}: {found} {slope}");
            }
        }
    }
}
