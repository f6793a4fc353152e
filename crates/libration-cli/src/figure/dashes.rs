//! Dashed curves as separate strokes: the PNG back end of the drawing library begins its dash pattern anew
//! at every point of a curve, which leaves closely sampled curves solid.

use kuva::render::render::{Primitive, Scene};

/// Replaces each dashed curve of the scene by its dashes.
pub(crate) fn cut_into_dashes(scene: &mut Scene) {
    let elements = std::mem::take(&mut scene.elements);
    scene.elements = elements.into_iter().flat_map(strokes).collect();
}

fn strokes(element: Primitive) -> Vec<Primitive> {
    match element {
        Primitive::PolyLine { points, stroke, stroke_width, stroke_dasharray: Some(pattern) } => {
            dashes(&points, &lengths(&pattern))
                .into_iter()
                .map(|points| Primitive::PolyLine {
                    points,
                    stroke: stroke.clone(),
                    stroke_width,
                    stroke_dasharray: None,
                })
                .collect()
        }
        other => vec![other],
    }
}

fn lengths(pattern: &str) -> Vec<f64> {
    pattern.split_whitespace().filter_map(|length| length.parse().ok()).filter(|&l: &f64| l > 0.0).collect()
}

/// The dashes of a curve; the lengths alternate between dash and gap.
fn dashes(points: &[(f64, f64)], lengths: &[f64]) -> Vec<Vec<(f64, f64)>> {
    if lengths.is_empty() {
        return vec![points.to_vec()];
    }
    let mut pen = Pen { lengths, index: 0, left: lengths[0], dashes: vec![] };
    if let Some(&first) = points.first() {
        pen.dashes.push(vec![first]);
    }
    for pair in points.windows(2) {
        pen.walk(pair[0], pair[1]);
    }
    pen.dashes.retain(|dash| dash.len() > 1);
    pen.dashes
}

struct Pen<'a> {
    lengths: &'a [f64],
    index: usize,
    left: f64,
    dashes: Vec<Vec<(f64, f64)>>,
}

impl Pen<'_> {
    fn walk(&mut self, from: (f64, f64), to: (f64, f64)) {
        let distance = (to.0 - from.0).hypot(to.1 - from.1);
        let mut walked = 0.0;
        while distance - walked > self.left {
            walked += self.left;
            let part = walked / distance;
            self.turn((from.0 + part * (to.0 - from.0), from.1 + part * (to.1 - from.1)));
        }
        self.left -= distance - walked;
        self.extend(to);
    }

    /// Ends a dash or a gap here and begins the other.
    fn turn(&mut self, here: (f64, f64)) {
        self.extend(here);
        self.index += 1;
        self.left = self.lengths[self.index % self.lengths.len()];
        if self.is_down() {
            self.dashes.push(vec![here]);
        }
    }

    fn extend(&mut self, to: (f64, f64)) {
        if self.is_down() {
            self.dashes.last_mut().expect("a dash begins with the curve").push(to);
        }
    }

    fn is_down(&self) -> bool {
        self.index.is_multiple_of(2)
    }
}
