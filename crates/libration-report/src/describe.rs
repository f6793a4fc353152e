//! Description of a picture in sentences.

use crate::chart::{Axis, Mark, Panel, Picture, Scale, Series};
use crate::numbers::short;

/// The description: the parameters, then for each panel the quantities of its axes, their ranges, and all names in it.
pub(crate) fn picture(picture: &Picture) -> String {
    let parameters = (!picture.parameters.is_empty()).then(|| format!("{}.", picture.parameters.join(", ")));
    let mut across = "";
    let panels: Vec<String> = picture
        .panels
        .iter()
        .rev()
        .map(|panel| {
            if !panel.x.label.is_empty() {
                across = &panel.x.label;
            }
            self::panel(panel, across)
        })
        .collect();
    let moves = picture
        .animation
        .as_ref()
        .map(|animation| format!("An animated drawing repeats every {} s.", short(animation.seconds)));
    parameters.into_iter().chain(panels.into_iter().rev()).chain(moves).collect::<Vec<_>>().join(" ")
}

fn panel(panel: &Panel, across: &str) -> String {
    let axes = format!("{} against {}.", axis(&panel.y, &panel.y.label), axis(&panel.x, across));
    let named = panel.series.iter().filter(|series| !series.label.is_empty());
    let named: Vec<String> = named.map(what).collect();
    if named.is_empty() { axes } else { format!("{axes} Shown: {}.", named.join("; ")) }
}

fn axis(axis: &Axis, label: &str) -> String {
    let scale = if axis.scale == Scale::Logarithmic { ", logarithmic" } else { "" };
    format!("{label} from {} to {}{scale}", short(axis.from), short(axis.to))
}

fn what(series: &Series) -> String {
    let count = series.points.len();
    let kind = match series.look.mark {
        Mark::Line([]) => "a line".to_owned(),
        Mark::Line(_) => "a dashed line".to_owned(),
        Mark::Markers(_) if count == 1 => "1 point".to_owned(),
        Mark::Markers(_) => format!("{count} points"),
        Mark::Band => "a band".to_owned(),
    };
    format!("{} ({kind})", series.label)
}
