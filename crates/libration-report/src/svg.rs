//! A scene as SVG, with a view box, a title, a description, and colours for light and dark pages.

use crate::letters;
use crate::scene::{Anchor, Form, Moving, MovingForm, Place, Scene, Shape, ShapeRole, Text};
use crate::style::{DARK, PAPER};
use std::fmt::Write;

/// A standalone file, with its size.
pub fn file(scene: &Scene) -> String {
    let size = format!(
        " xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\"",
        rounded(scene.width),
        rounded(scene.height)
    );
    format!("{}\n", element(scene, &size))
}

/// An element of a page, as wide as its container.
pub fn inline(scene: &Scene) -> String {
    element(scene, "")
}

fn element(scene: &Scene, size: &str) -> String {
    let (width, height) = (rounded(scene.width), rounded(scene.height));
    let mut svg = format!(
        "<svg{size} viewBox=\"0 0 {width} {height}\" role=\"img\" \
         font-family=\"'DejaVu Sans', Verdana, sans-serif\">\n<title>{}</title>\n<desc>{}</desc>\n<style>{}</style>\n\
         <rect class=\"paper\" width=\"{width}\" height=\"{height}\" fill=\"{PAPER}\"/>\n",
        escaped(&scene.title),
        escaped(&scene.description),
        dark_style(),
    );
    for panel in &scene.panels {
        svg += "<g class=\"panel\">\n";
        svg.extend(panel.iter().map(shape));
        svg += "</g>\n";
    }
    svg += "<g class=\"words\">\n";
    svg.extend(scene.words.iter().map(shape));
    svg += "</g>\n";
    svg += &animation(scene);
    svg + "</svg>"
}

/// The moving shapes; for readers who prefer reduced motion they stay at their initial positions.
fn animation(scene: &Scene) -> String {
    if scene.moving.is_empty() {
        return String::new();
    }
    let still = |moving: &Moving| {
        self::moving(&Moving { frames: moving.frames[..1].to_vec(), ..moving.clone() }, 0.0)
    };
    let group = |class: &str, shapes: String| format!("<g class=\"{class}\">\n{shapes}</g>\n");
    let begun = scene.moving.iter().filter(|moving| !moving.frames.is_empty());
    [
        "<style>.still{display:none}@media (prefers-reduced-motion:reduce){.moving{display:none}.still{display:inline}}</style>\n"
            .to_owned(),
        group("still", begun.clone().map(still).collect()),
        group("moving", begun.map(|moving| self::moving(moving, scene.seconds)).collect()),
    ]
    .concat()
}

fn moving(moving: &Moving, seconds: f64) -> String {
    let numbers = |number: fn(&Place) -> f64| -> Vec<String> {
        moving
            .frames
            .iter()
            .filter_map(|places| places.first())
            .map(|position| rounded(number(position)))
            .collect()
    };
    let colour = moving.colour;
    match moving.form {
        MovingForm::Line { width } => {
            let corners = |places: &Vec<Place>| {
                let corners: Vec<String> =
                    places.iter().map(|(x, y)| format!("{},{}", rounded(*x), rounded(*y))).collect();
                corners.join(" ")
            };
            let corners: Vec<String> = moving.frames.iter().map(corners).collect();
            format!(
                "<polyline fill=\"none\" stroke=\"{colour}\" stroke-width=\"{}\" stroke-linejoin=\"round\" points=\"{}\">{}</polyline>\n",
                rounded(width),
                corners[0],
                animated("points", &corners, seconds)
            )
        }
        MovingForm::Dot { radius } => {
            let (x, y) = (numbers(|position| position.0), numbers(|position| position.1));
            format!(
                "<circle fill=\"{colour}\" r=\"{}\" cx=\"{}\" cy=\"{}\">{}{}</circle>\n",
                rounded(radius),
                x[0],
                y[0],
                animated("cx", &x, seconds),
                animated("cy", &y, seconds)
            )
        }
    }
}

/// An attribute that takes these values in turn, evenly spaced and repeated for ever; empty if all values are equal.
fn animated(attribute: &str, values: &[String], seconds: f64) -> String {
    if values.iter().all(|value| *value == values[0]) {
        return String::new();
    }
    format!(
        "<animate attributeName=\"{attribute}\" dur=\"{}s\" repeatCount=\"indefinite\" values=\"{}\"/>",
        rounded(seconds),
        values.join(";")
    )
}

/// The style for dark screens, which replaces each colour by its dark counterpart.
fn dark_style() -> String {
    let rules = DARK.iter().map(|(light, dark)| {
        format!("[fill=\"{light}\"]{{fill:{dark}}}[stroke=\"{light}\"]{{stroke:{dark}}}")
    });
    format!("@media screen and (prefers-color-scheme:dark){{{}}}", rules.collect::<String>())
}

fn shape(shape: &Shape) -> String {
    let (class, colour) = (class(shape.role), shape.colour);
    let opacity = |name: &str| {
        if shape.opacity < 1.0 { format!(" {name}-opacity=\"{}\"", shape.opacity) } else { String::new() }
    };
    match &shape.form {
        Form::Lines { pieces, width, dashes } => {
            let dashes: Vec<String> = dashes.iter().map(|length| rounded(*length)).collect();
            let dashes = if dashes.is_empty() {
                String::new()
            } else {
                format!(" stroke-dasharray=\"{}\"", dashes.join(" "))
            };
            format!(
                "<path class=\"{class}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{dashes}{} \
                 d=\"{}\"/>\n",
                rounded(*width),
                opacity("stroke"),
                pieces.iter().map(|piece| outline(piece, "")).collect::<String>()
            )
        }
        Form::Areas(areas) => format!(
            "<path class=\"{class}\" fill=\"{colour}\"{} d=\"{}\"/>\n",
            opacity("fill"),
            areas.iter().map(|area| outline(area, "Z")).collect::<String>()
        ),
        // A line of zero length with round ends is a dot, and the shortest way to write one.
        Form::Dots { places, radius } => format!(
            "<path class=\"{class}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{}\" stroke-linecap=\"round\"{} d=\"{}\"/>\n",
            rounded(2.0 * radius),
            opacity("stroke"),
            dots(places)
        ),
        Form::Text(text) => self::text(text, class, colour),
    }
}

fn class(role: ShapeRole) -> &'static str {
    match role {
        ShapeRole::Frame => "frame",
        ShapeRole::Tick => "tick",
        ShapeRole::XTickLabel => "x-tick",
        ShapeRole::YTickLabel => "y-tick",
        ShapeRole::AxisLabel => "axis",
        ShapeRole::Curve => "curve",
        ShapeRole::Markers => "markers",
        ShapeRole::Bars => "bars",
        ShapeRole::Band => "band",
        ShapeRole::Sample => "sample",
        ShapeRole::Name => "name",
        ShapeRole::Title => "title",
        ShapeRole::Parameters => "parameters",
    }
}

fn text(text: &Text, class: &str, colour: &str) -> String {
    let (x, y) = (rounded(text.at.0), rounded(text.at.1));
    let anchor = match text.anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let turn = if text.is_turned { format!(" transform=\"rotate(-90 {x} {y})\"") } else { String::new() };
    format!(
        "<text class=\"{class}\" x=\"{x}\" y=\"{y}\" font-size=\"{}\" text-anchor=\"{anchor}\" fill=\"{colour}\"{turn}>{}</text>\n",
        rounded(text.size),
        spans(text)
    )
}

/// The letters, with subscripts and superscripts smaller and on base lines of their own.
fn spans(text: &Text) -> String {
    let mut base = 0.0;
    let mut spans = String::new();
    for run in letters::runs(&text.content) {
        let here = -run.rise * text.size;
        let down = here - base;
        base = here;
        let letters = escaped(&run.letters);
        spans += &match (run.scale < 1.0, down.abs() > 0.0) {
            (false, false) => letters,
            (false, true) => format!("<tspan dy=\"{}\">{letters}</tspan>", rounded(down)),
            (true, _) => format!(
                "<tspan font-size=\"{}\" dy=\"{}\">{letters}</tspan>",
                rounded(run.scale * text.size),
                rounded(down)
            ),
        };
    }
    spans
}

/// Joins corners that coincide after rounding.
fn outline(places: &[Place], end: &str) -> String {
    let mut path = String::new();
    let mut last = None;
    for position in places {
        let corner = format!("{} {}", rounded(position.0), rounded(position.1));
        if last.as_ref() == Some(&corner) && places.len() > 2 {
            continue;
        }
        path += if last.is_none() { "M" } else { "L" };
        path += &corner;
        last = Some(corner);
    }
    path + end
}

/// Each dot, written as its offset from the previous one.
pub fn dots(places: &[Place]) -> String {
    let hundredths = |value: f64| (100.0 * value).round();
    let (mut path, mut last) = (String::new(), (0.0, 0.0));
    for (x, y) in places {
        let here = (hundredths(*x), hundredths(*y));
        let (dx, dy) = (rounded(0.01 * (here.0 - last.0)), rounded(0.01 * (here.1 - last.1)));
        write!(path, "m{dx} {dy}h0").expect("a String takes all that is written");
        last = here;
    }
    path
}

/// A number rounded to hundredths of a unit.
pub fn rounded(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0" } else { text }.to_owned()
}

/// Replaces characters that XML does not allow by spaces.
pub fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for letter in text.chars() {
        match letter {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            '\u{FFFE}' | '\u{FFFF}' => escaped.push(' '),
            letter if letter.is_control() => escaped.push(' '),
            letter => escaped.push(letter),
        }
    }
    escaped
}
