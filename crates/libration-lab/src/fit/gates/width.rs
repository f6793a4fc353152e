//! The angle that a bob or a flag goes while it blocks the beam of a gate.
//!
//! Seen from the side the bob is a disc of radius r about a point at the distance c from the pivot, and the beam a point at the distance d. It
//! is blocked while the two are no further apart than r, by the law of cosines d² + c² − 2dc·cos φ ≤ r²: on either side for the angle φ
//! with sin²(φ/2) = (r² − (d − c)²)/4dc.

/// A disc and the beam that it passes, in metres.
#[derive(Clone, Copy, Debug)]
pub struct PassingDisc {
    /// Radius of the disc.
    pub radius: f64,
    /// Distance from the pivot to the middle of the disc.
    pub centre: f64,
    /// Distance from the pivot to the beam.
    pub beam: f64,
}

impl PassingDisc {
    /// The angle for which it blocks the beam, in radians.
    pub fn width(&self) -> f64 {
        4.0 * libm::asin(self.squared_sine().sqrt())
    }

    /// Derivatives of the width with respect to radius, centre and beam, in rad/m.
    pub fn slopes(&self) -> [f64; 3] {
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

/// A flag with straight edges parallel to the rod, each half of its width from the middle, in metres: they pass the beam at sin φ = r/d.
#[derive(Clone, Copy, Debug)]
pub struct PassingFlag {
    /// Half of its width.
    pub half: f64,
    /// Distance from the pivot to the beam.
    pub beam: f64,
}

impl PassingFlag {
    /// The angle for which it blocks the beam, in radians.
    pub fn width(&self) -> f64 {
        2.0 * libm::asin(self.half / self.beam)
    }

    /// Derivatives of the angle with respect to half of the flag's width and to the beam, in rad/m.
    pub fn slopes(&self) -> [f64; 2] {
        let adjacent = ((self.beam - self.half) * (self.beam + self.half)).sqrt();
        [2.0 / adjacent, -2.0 * self.half / (self.beam * adjacent)]
    }
}
