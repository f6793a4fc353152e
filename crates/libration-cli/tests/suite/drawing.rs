//! A drawing read back: what stands where on its canvas, and which data its curves and markers show.

#[path = "../../src/figure/letters.rs"]
mod letters;

use std::collections::BTreeMap;

/// A place on the canvas or in the coordinates of the data.
pub(crate) type Place = (f64, f64);

/// An SVG with the shapes and texts it consists of, all in the units of its canvas.
#[derive(Debug)]
pub(crate) struct Drawing {
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) panels: Vec<Panel>,
    pub(crate) texts: Vec<Text>,
    pub(crate) shapes: Vec<Shape>,
}

/// A pair of axes: its corners on the canvas, and what stands in it.
#[derive(Debug)]
pub(crate) struct Panel {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) x: Scale,
    pub(crate) y: Scale,
    /// Numbers of the drawing's shapes.
    shapes: Vec<usize>,
}

/// The value at the beginning of the canvas and its change by a unit of it; of logarithms where `is_logarithmic`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    origin: f64,
    pub(crate) slope: f64,
    is_logarithmic: bool,
}

#[derive(Debug)]
pub(crate) struct Text {
    pub(crate) content: String,
    anchor: String,
    at: Place,
    size: f64,
    is_turned: bool,
}

/// A curve, a marker, or a line of the axes.
#[derive(Clone, Debug)]
pub(crate) struct Shape {
    pub(crate) colour: String,
    pub(crate) is_filled: bool,
    pub(crate) points: Vec<Place>,
}

/// What an element of the SVG is called, and its attributes.
type Element<'a> = (&'a str, BTreeMap<&'a str, &'a str>, &'a str);

/// The elements in order, each with the text behind it; those that end have a name that begins with a slash.
fn elements(svg: &str) -> impl Iterator<Item = Element<'_>> {
    svg.split('<').skip(1).filter(|part| !part.starts_with('!')).map(|part| {
        let (tag, text) = part.split_once('>').unwrap();
        let (name, rest) = tag.split_once(' ').unwrap_or((tag, ""));
        let mut attributes = BTreeMap::new();
        let mut pieces = rest.split('"');
        while let (Some(name), Some(value)) = (pieces.next(), pieces.next()) {
            attributes.insert(name.trim().trim_end_matches('='), value);
        }
        (name, attributes, text)
    })
}

fn number(attributes: &BTreeMap<&str, &str>, name: &str) -> f64 {
    attributes.get(name).unwrap_or_else(|| panic!("no {name}")).parse().unwrap()
}

/// All numbers of a path or of a transformation, in pairs.
fn pairs(text: &str) -> Vec<Place> {
    let numbers =
        text.split(|c: char| !(c.is_ascii_digit() || ".-e".contains(c))).filter(|part| !part.is_empty());
    let numbers: Vec<f64> = numbers.filter_map(|part| part.parse().ok()).collect();
    numbers.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect()
}

/// The points of an element that draws something.
fn outline(name: &str, attributes: &BTreeMap<&str, &str>) -> Option<Vec<Place>> {
    let at = |name| number(attributes, name);
    Some(match name {
        "path" => pairs(attributes["d"]),
        "line" => vec![(at("x1"), at("y1")), (at("x2"), at("y2"))],
        "circle" => {
            let (x, y, r) = (at("cx"), at("cy"), at("r"));
            vec![(x - r, y - r), (x + r, y + r)]
        }
        "rect" if attributes["width"] != "100%" => {
            let (x, y) = (at("x"), at("y"));
            vec![(x, y), (x + at("width"), y + at("height"))]
        }
        _ => return None,
    })
}

impl Drawing {
    pub(crate) fn read(svg: &str) -> Self {
        let mut drawing = Self { width: 0.0, height: 0.0, panels: vec![], texts: vec![], shapes: vec![] };
        let mut frames: Vec<[f64; 4]> = vec![];
        let (mut is_definition, mut groups, mut offset): (bool, Vec<bool>, Place) =
            (false, vec![], (0.0, 0.0));
        let mut members: Vec<Vec<usize>> = vec![];
        for (name, attributes, text) in elements(svg) {
            match name {
                "svg" => {
                    (drawing.width, drawing.height) =
                        (number(&attributes, "width"), number(&attributes, "height"));
                }
                "defs" => is_definition = true,
                "/defs" => is_definition = false,
                "rect" if is_definition => {
                    frames.push(["x", "y", "width", "height"].map(|name| number(&attributes, name)));
                }
                "g" => {
                    let moves = attributes.get("transform").is_some_and(|it| it.starts_with("translate"));
                    groups.push(moves);
                    if moves {
                        offset = pairs(attributes["transform"])[0];
                        members.push(vec![]);
                        let frame = &mut frames[members.len() - 1];
                        (frame[0], frame[1]) = (frame[0] + offset.0, frame[1] + offset.1);
                    }
                }
                "/g" => {
                    if groups.pop() == Some(true) {
                        offset = (0.0, 0.0);
                    }
                }
                "text" => drawing.texts.push(Text::read(&attributes, text, offset)),
                _ => {
                    let Some(points) = outline(name, &attributes).filter(|_| !is_definition) else {
                        continue;
                    };
                    if !groups.is_empty() {
                        members.last_mut().unwrap().push(drawing.shapes.len());
                    }
                    let fill = attributes.get("fill").copied().filter(|fill| *fill != "none");
                    let colour = fill.or(attributes.get("stroke").copied()).unwrap_or("").to_owned();
                    let points = points.into_iter().map(|(x, y)| (x + offset.0, y + offset.1)).collect();
                    drawing.shapes.push(Shape { colour, is_filled: fill.is_some(), points });
                }
            }
        }
        assert_eq!(frames.len(), members.len(), "each panel has its frame");
        let panels = frames.into_iter().zip(members);
        drawing.panels = panels.map(|(frame, shapes)| Panel::of(frame, shapes, &drawing.texts)).collect();
        drawing
    }

    /// The curves of a panel in this colour, in the coordinates of the data, piece by piece.
    pub(crate) fn curves(&self, panel: usize, colour: &str) -> Vec<Vec<Place>> {
        let shapes = self.of_colour(panel, colour).filter(|shape| !shape.is_filled);
        shapes.map(|shape| shape.points.iter().map(|&at| self.panels[panel].data_at(at)).collect()).collect()
    }

    /// The middles of the markers of a panel in this colour, in the coordinates of the data.
    pub(crate) fn markers(&self, panel: usize, colour: &str) -> Vec<Place> {
        let shapes = self.of_colour(panel, colour).filter(|shape| shape.is_filled);
        shapes.map(|shape| self.panels[panel].data_at(middle(&shape.points))).collect()
    }

    fn of_colour<'a>(&'a self, panel: usize, colour: &'a str) -> impl Iterator<Item = &'a Shape> {
        let shapes = self.panels[panel].shapes.iter().map(|&shape| &self.shapes[shape]);
        shapes.filter(move |shape| shape.colour.eq_ignore_ascii_case(colour))
    }

    /// The value of a curve of single pieces at an abscissa, between its points a line.
    pub(crate) fn value_at(&self, panel: usize, colour: &str, x: f64) -> f64 {
        let curves = self.curves(panel, colour);
        let part = curves.iter().flat_map(|curve| curve.windows(2)).find(|pair| {
            (pair[0].0.min(pair[1].0)..=pair[0].0.max(pair[1].0)).contains(&x)
                && (pair[0].0 - pair[1].0).abs() > 0.0
        });
        let part = part.unwrap_or_else(|| panic!("{colour} is not drawn at {x}"));
        let along = (x - part[0].0) / (part[1].0 - part[0].0);
        part[0].1 + along * (part[1].1 - part[0].1)
    }
}

fn middle(points: &[Place]) -> Place {
    let ends = |part: fn(&Place) -> f64| {
        let parts = || points.iter().map(part);
        0.5 * (parts().fold(f64::INFINITY, f64::min) + parts().fold(f64::NEG_INFINITY, f64::max))
    };
    (ends(|point| point.0), ends(|point| point.1))
}

impl Text {
    fn read(attributes: &BTreeMap<&str, &str>, text: &str, offset: Place) -> Self {
        Self {
            content: text
                .replace("&lt;", "<")
                .replace("&gt;", ">")
                .replace("&amp;", "&")
                .replace("&#39;", "'"),
            anchor: attributes["text-anchor"].to_owned(),
            at: (number(attributes, "x") + offset.0, number(attributes, "y") + offset.1),
            size: number(attributes, "font-size"),
            is_turned: attributes.contains_key("transform"),
        }
    }

    /// Left, top, right and bottom. Letters of `DejaVu Sans` are as high as 0.77 and as deep as 0.24 of its size.
    pub(crate) fn extent(&self) -> [f64; 4] {
        let long = letters::width(&self.content, self.size);
        let before = match self.anchor.as_str() {
            "middle" => 0.5 * long,
            "end" => long,
            _ => 0.0,
        };
        let (x, y) = self.at;
        let (up, down) = (0.77 * self.size, 0.24 * self.size);
        if self.is_turned {
            return [x - up, y - before, x + down, y - before + long];
        }
        [x - before, y - up, x - before + long, y + down]
    }
}

impl Panel {
    fn of([left, top, width, height]: [f64; 4], shapes: Vec<usize>, texts: &[Text]) -> Self {
        let ticks = || texts.iter().filter(|text| !text.is_turned && text.size < 18.0);
        let below = ticks()
            .filter(|text| text.anchor == "middle" && (0.0..25.0).contains(&(text.at.1 - top - height)));
        // The baseline of a label is so far below its tick.
        const BASELINE: f64 = 6.2;
        let beside = ticks().filter(|text| {
            text.anchor == "end"
                && text.at.0 < left
                && (top - 1.0..top + height + 1.0).contains(&(text.at.1 - BASELINE))
        });
        let x = Scale::of(below.map(|text| (text.at.0, text.content.as_str())).collect());
        let y = Scale::of(beside.map(|text| (text.at.1 - BASELINE, text.content.as_str())).collect());
        Self { left, top, width, height, x, y, shapes }
    }

    fn data_at(&self, (x, y): Place) -> Place {
        (self.x.value_at(x), self.y.value_at(y))
    }

    /// How much of the data a hundredth of a unit of the canvas is, to which shapes are rounded.
    pub(crate) fn resolution(&self) -> Place {
        (0.01 * self.x.slope.abs(), 0.01 * self.y.slope.abs())
    }
}

impl Scale {
    /// The scale of ticks with their labels.
    fn of(ticks: Vec<(f64, &str)>) -> Self {
        let is_logarithmic = ticks
            .iter()
            .any(|(_, label)| label.starts_with("10") && label.chars().any(|c| raised(c).is_some()));
        let value = |label: &str| {
            if is_logarithmic { exponent(label) } else { label.replace('−', "-").parse().unwrap() }
        };
        let (first, last) = (ticks.first().unwrap(), ticks.last().unwrap());
        let slope = (value(last.1) - value(first.1)) / (last.0 - first.0);
        Self { origin: value(first.1) - slope * first.0, slope, is_logarithmic }
    }

    fn value_at(self, place: f64) -> f64 {
        let value = self.origin + self.slope * place;
        if self.is_logarithmic { 10f64.powf(value) } else { value }
    }
}

fn exponent(label: &str) -> f64 {
    if label == "1" {
        return 0.0;
    }
    label["10".len()..].chars().filter_map(raised).collect::<String>().parse().unwrap()
}

fn raised(letter: char) -> Option<char> {
    "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|it| it == letter).and_then(|place| "-0123456789".chars().nth(place))
}
