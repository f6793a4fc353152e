//! Pictures as SVG or PNG, by the plotting library `kuva`.

use super::chart::{Axis, Mark, Panel, Picture, Series};
use super::frame::{
    BOTTOM_MARGIN, Frame, LABEL_SIZE, PADDING, SPACING, TICK_SIZE, TITLE_SIZE, TOP_MARGIN, tick_label,
};
use super::{clip, dashes, legend};
use kuva::prelude::{Figure, LinePlot, LineStyle, MarkerShape};
use kuva::prelude::{Layout, Plot, PngBackend, ScatterPlot, SvgBackend, TickFormat};
use kuva::render::render::Scene;
use std::sync::Arc;

/// Pixels per unit of length in a PNG: 1000 units wide become 2400 pixels, 300 dpi at 20 cm.
const PNG_SCALE: f32 = 2.4;

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
    let frame = Frame::new(picture);
    let mut scene = axes_and_data(picture, &frame);
    legend::add(&mut scene, picture, &frame);
    dashes::cut_into_dashes(&mut scene);
    // The size asked for, without what the rounding of the parts leaves.
    (scene.width, scene.height) = (frame.width, frame.height);
    scene
}

fn axes_and_data(picture: &Picture, frame: &Frame) -> Scene {
    let mut figure = Figure::new(picture.panels.len(), 1)
        .with_title(&picture.title)
        .with_title_size(TITLE_SIZE)
        .with_padding(PADDING)
        .with_spacing(SPACING)
        .with_plots(picture.panels.iter().map(plots).collect())
        .with_layouts(picture.panels.iter().map(|panel| layout(panel, frame)).collect())
        .with_figure_size(frame.width - frame.legend_width, frame.height);
    for (row, (_, height)) in frame.cells.iter().enumerate() {
        figure = figure.with_row_height(row, *height);
    }
    figure.render()
}

fn layout(panel: &Panel, frame: &Frame) -> Layout {
    let layout = Layout::new(panel.x.ends(), panel.y.ends())
        .with_label_size(LABEL_SIZE)
        .with_tick_size(TICK_SIZE)
        .with_body_size(16)
        .with_box_axes()
        .with_axis_line_width(1.5)
        .with_tick_width(1.5)
        .with_force_margins(frame.left_margin, frame.right_margin)
        .with_force_margins_y(TOP_MARGIN, BOTTOM_MARGIN);
    with_y_axis(with_x_axis(layout, &panel.x), &panel.y)
}

fn with_x_axis(layout: Layout, axis: &Axis) -> Layout {
    let (from, to) = axis.ends();
    let layout = layout
        .with_x_axis_min(from)
        .with_x_axis_max(to)
        .with_x_tick_step(axis.tick_step)
        .with_x_tick_format(ticks(axis));
    if axis.label.is_empty() { layout } else { layout.with_x_label(&axis.label) }
}

fn with_y_axis(layout: Layout, axis: &Axis) -> Layout {
    let (from, to) = axis.ends();
    layout
        .with_y_axis_min(from)
        .with_y_axis_max(to)
        .with_y_tick_step(axis.tick_step)
        .with_y_tick_format(ticks(axis))
        .with_y_label(&axis.label)
}

fn ticks(axis: &Axis) -> TickFormat {
    let (scale, step) = (axis.scale, axis.tick_step);
    TickFormat::Custom(Arc::new(move |coordinate| tick_label(scale, step, coordinate)))
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
