//! A drawing read back: the positions of its shapes and texts, and the data of its curves and markers.

use std::collections::BTreeMap;

/// A position on the canvas or in the coordinates of the data.
pub(crate) type Place = (f64, f64);

/// An SVG with its shapes and texts, all in the units of its canvas.
#[derive(Debug)]
pub(crate) struct Drawing {
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) panels: Vec<Panel>,
    pub(crate) texts: Vec<Text>,
    pub(crate) shapes: Vec<Shape>,
    /// The corners of lines and the centres of dots that move, at consecutive times.
    pub(crate) moving: Vec<Vec<Vec<Place>>>,
    /// Duration of the movement, in seconds.
    pub(crate) seconds: f64,
}

/// A pair of axes: its corners on the canvas, and its content.
#[derive(Debug)]
pub(crate) struct Panel {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) x: Scale,
    pub(crate) y: Scale,
    /// Indices of the drawing's shapes.
    shapes: Vec<usize>,
}

/// The value at the beginning of the canvas and its change per unit; of logarithms if `is_logarithmic`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    origin: f64,
    pub(crate) slope: f64,
    is_logarithmic: bool,
}

#[derive(Debug)]
pub(crate) struct Text {
    pub(crate) class: String,
    pub(crate) content: String,
    anchor: String,
    at: Place,
    pub(crate) size: f64,
    is_turned: bool,
}

/// A piece of a curve, a marker, or a line of the axes.
#[derive(Clone, Debug)]
pub(crate) struct Shape {
    pub(crate) class: String,
    pub(crate) colour: String,
    pub(crate) points: Vec<Place>,
}

/// The name of an element of the SVG, its attributes, and the text after it.
type Element<'a> = (&'a str, BTreeMap<&'a str, &'a str>, &'a str);

/// The elements in order, each with the text after it; the names of end tags begin with a slash.
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

/// The pieces of a path: corners after `M` and `L`, and dots `m x y h0`, each by its offset from the one before.
fn pieces(path: &str) -> Vec<Vec<Place>> {
    if path.starts_with('m') {
        let steps = path.split('m').skip(1).map(|step| pairs(step.trim_end_matches("h0"))[0]);
        let mut at = (0.0, 0.0);
        return steps
            .map(|(dx, dy)| {
                at = (at.0 + dx, at.1 + dy);
                vec![at]
            })
            .collect();
    }
    path.split('M').skip(1).map(pairs).collect()
}

impl Drawing {
    pub(crate) fn read(svg: &str) -> Self {
        let mut drawing = Self {
            width: 0.0,
            height: 0.0,
            panels: vec![],
            texts: vec![],
            shapes: vec![],
            moving: vec![],
            seconds: 0.0,
        };
        let mut members: Vec<(Vec<usize>, Vec<usize>)> = vec![];
        let (mut is_panel, mut is_moving, mut is_text) = (false, false, false);
        for (name, attributes, text) in elements(svg) {
            match name {
                "svg" => {
                    let [_, _, width, height] = attributes["viewBox"]
                        .split(' ')
                        .map(|side| side.parse().unwrap())
                        .collect::<Vec<f64>>()[..]
                    else {
                        panic!("{attributes:?}")
                    };
                    (drawing.width, drawing.height) = (width, height);
                }
                "g" => {
                    is_panel = attributes["class"] == "panel";
                    is_moving = attributes["class"] == "moving";
                    if is_panel {
                        members.push((vec![], vec![]));
                    }
                }
                "text" => {
                    if is_panel {
                        members.last_mut().unwrap().1.push(drawing.texts.len());
                    }
                    drawing.texts.push(Text::read(&attributes, text));
                    is_text = true;
                }
                "tspan" | "/tspan" if is_text => {
                    let last = drawing.texts.last_mut().unwrap();
                    last.content += &match attributes.get("font-size") {
                        Some(_) => small(&unescaped(text), number(&attributes, "dy") > 0.0),
                        None => unescaped(text),
                    };
                }
                "/text" => is_text = false,
                "path" => {
                    let colour = match attributes["fill"] {
                        "none" => attributes["stroke"],
                        fill => fill,
                    };
                    for points in pieces(attributes["d"]) {
                        if is_panel {
                            members.last_mut().unwrap().0.push(drawing.shapes.len());
                        }
                        let (class, colour) = (attributes["class"].to_owned(), colour.to_owned());
                        drawing.shapes.push(Shape { class, colour, points });
                    }
                }
                "polyline" if is_moving => drawing.moving.push(vec![pairs(attributes["points"])]),
                "circle" if is_moving => {
                    let middle = (number(&attributes, "cx"), number(&attributes, "cy"));
                    drawing.moving.push(vec![vec![middle]]);
                }
                "animate" => drawing.animate(&attributes),
                _ => {}
            }
        }
        let mut below: Option<Scale> = None;
        // Panels without tick labels below share those of the next panel.
        for (shapes, texts) in members.into_iter().rev() {
            let panel = Panel::of(shapes, &texts, &drawing, below);
            below = Some(panel.x);
            drawing.panels.insert(0, panel);
        }
        drawing
    }

    /// Sets the positions of the last moving shape.
    fn animate(&mut self, attributes: &BTreeMap<&str, &str>) {
        assert_eq!(attributes["repeatCount"], "indefinite");
        self.seconds = attributes["dur"].trim_end_matches('s').parse().unwrap();
        let values: Vec<&str> = attributes["values"].split(';').collect();
        let frames = self.moving.last_mut().unwrap();
        frames.resize(values.len(), frames[0].clone());
        for (frame, value) in frames.iter_mut().zip(values) {
            match attributes["attributeName"] {
                "points" => *frame = pairs(value),
                "cx" => frame[0].0 = value.parse().unwrap(),
                "cy" => frame[0].1 = value.parse().unwrap(),
                other => panic!("{other} moves"),
            }
        }
    }

    /// The texts of a class, one per line.
    pub(crate) fn of_class(&self, class: &str) -> Vec<&str> {
        self.texts.iter().filter(|text| text.class == class).map(|text| text.content.as_str()).collect()
    }

    /// The curves of a panel in this colour, in the coordinates of the data, piece by piece.
    pub(crate) fn curves(&self, panel: usize, colour: &str) -> Vec<Vec<Place>> {
        let shapes = self.of_colour(panel, colour).filter(|shape| shape.class == "curve");
        shapes.map(|shape| shape.points.iter().map(|&at| self.panels[panel].data_at(at)).collect()).collect()
    }

    /// The centres of the markers of a panel in this colour, in the coordinates of the data.
    pub(crate) fn markers(&self, panel: usize, colour: &str) -> Vec<Place> {
        let shapes = self.of_colour(panel, colour).filter(|shape| shape.class == "markers");
        shapes.map(|shape| self.panels[panel].data_at(middle(&shape.points))).collect()
    }

    /// The corners of the error bars of a panel, on the canvas.
    pub(crate) fn bars(&self, panel: usize) -> impl Iterator<Item = &Place> {
        let shapes = self.panels[panel].shapes.iter().map(|&shape| &self.shapes[shape]);
        shapes.filter(|shape| shape.class == "bars").flat_map(|shape| &shape.points)
    }

    /// Returns `true` if a curve of the panel runs through a rectangle (left, top, right, bottom) of the canvas.
    pub(crate) fn is_crossed(&self, panel: usize, [left, top, right, bottom]: [f64; 4]) -> bool {
        let shapes = self.panels[panel].shapes.iter().map(|&shape| &self.shapes[shape]);
        let holds = |(x, y): Place| x > left && x < right && y > top && y < bottom;
        let is_through = |pair: &[Place]| {
            let part = |step: i32| f64::from(step) / 100.0;
            let between = |from: f64, to: f64, step| from + part(step) * (to - from);
            (0..=100)
                .any(|step| holds((between(pair[0].0, pair[1].0, step), between(pair[0].1, pair[1].1, step))))
        };
        shapes.filter(|shape| shape.class == "curve").any(|shape| shape.points.windows(2).any(is_through))
    }

    /// The shapes of a class of a panel in this colour, on the canvas.
    pub(crate) fn on_canvas(&self, panel: usize, class: &str, colour: &str) -> Vec<Vec<Place>> {
        let shapes = self.of_colour(panel, colour).filter(|shape| shape.class == class);
        shapes.map(|shape| shape.points.clone()).collect()
    }

    fn of_colour<'a>(&'a self, panel: usize, colour: &'a str) -> impl Iterator<Item = &'a Shape> {
        let shapes = self.panels[panel].shapes.iter().map(|&shape| &self.shapes[shape]);
        shapes.filter(move |shape| shape.colour.eq_ignore_ascii_case(colour))
    }

    /// The value at an abscissa of a curve with single pieces, by linear interpolation.
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

/// The middle of the rectangle that encloses the points.
pub(crate) fn middle(points: &[Place]) -> Place {
    let ends = |part: fn(&Place) -> f64| {
        let parts = || points.iter().map(part);
        0.5 * (parts().fold(f64::INFINITY, f64::min) + parts().fold(f64::NEG_INFINITY, f64::max))
    };
    (ends(|point| point.0), ends(|point| point.1))
}

fn unescaped(text: &str) -> String {
    let signs = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&amp;", "&")];
    signs.iter().fold(text.to_owned(), |text, (written, sign)| text.replace(written, sign))
}

/// The characters of subscripts or superscripts for letters that are drawn small.
fn small(text: &str, is_below: bool) -> String {
    let [drawn, written] = if is_below {
        ["0123456789+−aehijklmnoprstuvx", "₀₁₂₃₄₅₆₇₈₉₊₋ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ"]
    } else {
        ["0123456789+−n", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿ"]
    };
    let index = |letter| drawn.chars().position(|character| character == letter).unwrap();
    text.chars().map(|letter| written.chars().nth(index(letter)).unwrap()).collect()
}

impl Text {
    fn read(attributes: &BTreeMap<&str, &str>, text: &str) -> Self {
        Self {
            class: attributes["class"].to_owned(),
            content: unescaped(text),
            anchor: attributes["text-anchor"].to_owned(),
            at: (number(attributes, "x"), number(attributes, "y")),
            size: number(attributes, "font-size"),
            is_turned: attributes.contains_key("transform"),
        }
    }

    /// Left, top, right and bottom. Letters of `DejaVu Sans` rise 0.77 and descend 0.24 of the font size.
    pub(crate) fn extent(&self) -> [f64; 4] {
        let long = libration_report::text_width(&self.content, self.size);
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
    fn of(shapes: Vec<usize>, texts: &[usize], drawing: &Drawing, below: Option<Scale>) -> Self {
        let frame = shapes.iter().map(|&shape| &drawing.shapes[shape]).find(|shape| shape.class == "frame");
        let corners = &frame.unwrap().points;
        let ((left, bottom), (right, top)) = (corners[0], corners[2]);
        let of_class = |class: &'static str| {
            texts.iter().map(|&text| &drawing.texts[text]).filter(move |text| text.class == class)
        };
        // The base line of a label is this far below its tick.
        let base_line = |text: &Text| 0.365 * text.size;
        let across: Vec<_> = of_class("x-tick").map(|text| (text.at.0, text.content.as_str())).collect();
        let up =
            of_class("y-tick").map(|text| (text.at.1 - base_line(text), text.content.as_str())).collect();
        let x = if across.is_empty() { below.unwrap() } else { Scale::of(across) };
        Self { left, top, width: right - left, height: bottom - top, x, y: Scale::of(up), shapes }
    }

    pub(crate) fn data_at(&self, (x, y): Place) -> Place {
        (self.x.value_at(x), self.y.value_at(y))
    }

    /// The size, in the data, of a hundredth of a unit of the canvas, to which shapes are rounded.
    pub(crate) fn resolution(&self) -> Place {
        (0.01 * self.x.slope.abs(), 0.01 * self.y.slope.abs())
    }
}

impl Scale {
    /// The scale of ticks with these labels; names count as 1, 2, 3 and so on, multiples of π by their factor.
    fn of(ticks: Vec<(f64, &str)>) -> Self {
        let is_power = |label: &str| label.starts_with("10") && label.chars().any(|c| raised(c).is_some());
        let is_logarithmic = ticks.iter().all(|(_, label)| is_power(label));
        let values: Option<Vec<f64>> = ticks
            .iter()
            .map(
                |(_, label)| if is_logarithmic { Some(exponent(&label["10".len()..])) } else { value(label) },
            )
            .collect();
        let values = values
            .unwrap_or_else(|| (1..=ticks.len()).map(|k| f64::from(u32::try_from(k).unwrap())).collect());
        let last = ticks.len() - 1;
        let slope = (values[last] - values[0]) / (ticks[last].0 - ticks[0].0);
        Self { origin: values[0] - slope * ticks[0].0, slope, is_logarithmic }
    }

    fn value_at(self, position: f64) -> f64 {
        let value = self.origin + self.slope * position;
        if self.is_logarithmic { 10f64.powf(value) } else { value }
    }
}

/// The value of a tick label: `−0.5`, `2×10⁻⁷`, `−3π/2` (in units of π).
fn value(label: &str) -> Option<f64> {
    let label = label.replace('−', "-");
    if let Some((times, over)) = label.split_once('π') {
        let times = match times {
            "" => 1.0,
            "-" => -1.0,
            times => times.parse().ok()?,
        };
        let over: f64 = if over.is_empty() { 1.0 } else { over[1..].parse().ok()? };
        return Some(times / over);
    }
    match label.split_once("×10") {
        Some((times, power)) => Some(times.parse::<f64>().ok()? * 10f64.powf(exponent(power))),
        None => label.parse().ok(),
    }
}

fn exponent(raised_digits: &str) -> f64 {
    raised_digits.chars().filter_map(raised).collect::<String>().parse().unwrap()
}

fn raised(letter: char) -> Option<char> {
    "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
        .chars()
        .position(|character| character == letter)
        .and_then(|index| "-0123456789".chars().nth(index))
}
