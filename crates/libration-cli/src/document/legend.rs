//! The legend of a picture as text beside it, which stays readable where the picture is made small.

use super::html::escaped;
use crate::figure::chart::{Mark, Picture, Series};

/// The names of all curves with samples of them; nothing for a picture without names.
pub(super) fn list(picture: &Picture) -> String {
    let series = picture.panels.iter().flat_map(|panel| &panel.series);
    let entries: String = series.filter(|series| !series.label.is_empty()).map(entry).collect();
    if entries.is_empty() { entries } else { format!("<ul class=\"legend\">\n{entries}</ul>\n") }
}

/// The picture without names, which leaves its whole width to the axes.
pub(super) fn without_names(picture: &Picture) -> Picture {
    let mut bare = picture.clone();
    bare.panels.iter_mut().flat_map(|panel| &mut panel.series).for_each(|series| series.label.clear());
    bare
}

fn entry(series: &Series) -> String {
    format!(
        "<li><svg viewBox=\"0 0 48 16\" width=\"48\" height=\"16\" aria-hidden=\"true\">{}</svg> {}</li>\n",
        sample(series),
        escaped(&series.label)
    )
}

fn sample(series: &Series) -> String {
    let (colour, width) = (series.look.colour, series.look.width);
    match series.look.mark {
        Mark::Line(dashes) => format!(
            "<path d=\"M0 8H48\" stroke=\"{colour}\" stroke-width=\"{width}\" stroke-dasharray=\"{dashes}\"/>"
        ),
        Mark::Markers(number) => format!("<path d=\"{}\" fill=\"{colour}\"/>", outline(number)),
    }
}

/// Circle, square, triangle, diamond, as the pictures have them.
fn outline(number: usize) -> &'static str {
    match number % 4 {
        0 => "M24 3a5 5 0 1 0 .01 0Z",
        1 => "M19 3h10v10h-10Z",
        2 => "M24 2l6 11h-12Z",
        _ => "M24 1l7 7l-7 7l-7-7Z",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::chart::{Axis, Look, Panel};

    #[test]
    fn names_stand_beside_the_picture_and_not_in_it() {
        let named = |label: &str, mark| {
            Series::line(label, Look { colour: "#000000", width: 2.0, mark }, [(0.0, 0.0), (1.0, 1.0)])
        };
        let series = vec![
            named("cycles <b>", Mark::Markers(1)),
            named("", Mark::Line("")),
            named("law", Mark::Line("8 4")),
        ];
        let axis = Axis::linear("x", 0.0, 1.0);
        let panel = Panel { x: axis.clone(), y: axis, series, share: 1.0 };
        let picture = Picture::new("what", vec![panel]);
        let names = list(&picture);
        assert_eq!(names.matches("<li>").count(), 2);
        assert!(names.contains("cycles &lt;b&gt;") && names.contains("M19 3h10v10h-10Z"), "{names}");
        assert!(names.contains("stroke-dasharray=\"8 4\""), "{names}");
        assert!(list(&without_names(&picture)).is_empty());
    }
}
