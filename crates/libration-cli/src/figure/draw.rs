//! Pictures as SVG or PNG, by the plotting library `kuva`.

use super::chart::{Axis, Mark, Panel, Picture, Scale, Series};
use super::{clip, dashes, legend};
use crate::output::number;
use kuva::prelude::{Figure, LinePlot, LineStyle, MarkerShape};
use kuva::prelude::{Layout, Plot, PngBackend, ScatterPlot, SvgBackend, TickFormat};
use kuva::render::render::Scene;
use std::sync::Arc;

/// Pixels per unit of length in a PNG: 1000 units wide become 2400 pixels, 300 dpi at 20 cm.
const PNG_SCALE: f32 = 2.4;

/// The same for all panels, so that their axes stand in line.
const LEFT_MARGIN: f64 = 104.0;
/// Room for half of the last tick's label.
const RIGHT_MARGIN: f64 = 24.0;

const MARKERS: [MarkerShape; 4] =
    [MarkerShape::Circle, MarkerShape::Square, MarkerShape::Triangle, MarkerShape::Diamond];

/// The picture as SVG text.
pub(crate) fn to_svg(picture: &Picture) -> String {
    SvgBackend::default().render_scene(&scene(picture))
}

/// The picture as the bytes of a PNG file; the drawing library's own message if it cannot.
pub(crate) fn to_png(picture: &Picture) -> Result<Vec<u8>, String> {
    PngBackend::new().with_scale(PNG_SCALE).render_scene(&scene(picture))
}

fn scene(picture: &Picture) -> Scene {
    let mut scene = axes_and_data(picture);
    let title_height = scene.height - picture.height;
    legend::add(&mut scene, picture, title_height);
    dashes::cut_into_dashes(&mut scene);
    scene
}

fn axes_and_data(picture: &Picture) -> Scene {
    let shares: f64 = picture.panels.iter().map(|panel| panel.share).sum();
    let mut figure = Figure::new(picture.panels.len(), 1)
        .with_title(&picture.title)
        .with_title_size(22)
        .with_plots(picture.panels.iter().map(plots).collect())
        .with_layouts(picture.panels.iter().map(layout).collect())
        .with_figure_size(picture.width - legend::width(picture), picture.height);
    for (row, panel) in picture.panels.iter().enumerate() {
        figure = figure.with_row_height(row, panel.share / shares * picture.height);
    }
    figure.render()
}

fn layout(panel: &Panel) -> Layout {
    let layout = Layout::new(panel.x.ends(), panel.y.ends())
        .with_label_size(20)
        .with_tick_size(17)
        .with_body_size(16)
        .with_box_axes()
        .with_axis_line_width(1.5)
        .with_tick_width(1.5)
        .with_force_margins(LEFT_MARGIN, RIGHT_MARGIN);
    with_y_axis(with_x_axis(layout, &panel.x), &panel.y)
}

fn with_x_axis(layout: Layout, axis: &Axis) -> Layout {
    let (from, to) = axis.ends();
    let layout = layout
        .with_x_axis_min(from)
        .with_x_axis_max(to)
        .with_x_tick_step(axis.tick_step)
        .with_x_tick_format(ticks(axis.scale));
    if axis.label.is_empty() { layout } else { layout.with_x_label(&axis.label) }
}

fn with_y_axis(layout: Layout, axis: &Axis) -> Layout {
    let (from, to) = axis.ends();
    layout
        .with_y_axis_min(from)
        .with_y_axis_max(to)
        .with_y_tick_step(axis.tick_step)
        .with_y_tick_format(ticks(axis.scale))
        .with_y_label(&axis.label)
}

/// Logarithmic axes are drawn as even ones of the exponent: the library's own end at 1e-10.
fn ticks(scale: Scale) -> TickFormat {
    TickFormat::Custom(Arc::new(match scale {
        Scale::Linear => linear_tick,
        Scale::Logarithmic => power_of_ten,
    }))
}

fn linear_tick(value: f64) -> String {
    number::short(value, 6).replace('-', "−")
}

/// 10⁻⁴ for the exponent −4.
fn power_of_ten(exponent: f64) -> String {
    let exponent = format!("{exponent:.0}");
    let raised = exponent.chars().map(|digit| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => digit.to_digit(10).and_then(|d| char::from_u32(0x2070 + d)).unwrap_or(digit),
    });
    match exponent.as_str() {
        "0" | "-0" => "1".to_owned(),
        _ => format!("10{}", raised.collect::<String>()),
    }
}

fn plots(panel: &Panel) -> Vec<Plot> {
    panel.series.iter().flat_map(|series| drawn(series, panel)).collect()
}

fn drawn(series: &Series, panel: &Panel) -> Vec<Plot> {
    match series.look.mark {
        Mark::Line(dashes) => clip::visible_pieces(series, panel)
            .into_iter()
            .map(|piece| line(series, dashes, piece).into())
            .collect(),
        Mark::Markers(number) => vec![markers(series, number, panel).into()],
    }
}

fn line(series: &Series, dashes: &str, points: Vec<(f64, f64)>) -> LinePlot {
    LinePlot::new()
        .with_data(points)
        .with_color(series.look.colour)
        .with_stroke_width(series.look.width)
        .with_line_style(dash_style(dashes))
}

fn dash_style(dashes: &str) -> LineStyle {
    if dashes.is_empty() { LineStyle::Solid } else { LineStyle::Custom(dashes.to_owned()) }
}

/// Markers, with error bars where the points have uncertainties.
fn markers(series: &Series, number: usize, panel: &Panel) -> ScatterPlot {
    let shown: Vec<_> = series.points.iter().filter(|point| clip::is_visible(point, panel)).collect();
    let plot = ScatterPlot::new()
        .with_data(shown.iter().map(|point| clip::place(point, panel)))
        .with_color(series.look.colour)
        .with_size(series.look.width)
        .with_marker(MARKERS[number % MARKERS.len()]);
    let widths: Option<Vec<f64>> = shown.iter().map(|point| point.x_uncertainty).collect();
    let heights: Option<Vec<f64>> = shown.iter().map(|point| point.y_uncertainty).collect();
    let plot = plot.with_x_err(widths.unwrap_or_default());
    plot.with_y_err(heights.unwrap_or_default())
}
