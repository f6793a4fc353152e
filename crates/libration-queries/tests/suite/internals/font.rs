//! The letters of a PNG.

use libration_queries::internals::font::Font;

/// The layout and the renderer have the same widths.
#[test]
fn text_is_as_wide_as_it_is_laid_out() {
    let font = Font::new().unwrap();
    for text in [
        "fractional error of T",
        "θ₀ / degrees",
        "10⁻¹²",
        "2×10⁻⁷ − π/2 ≤ ω′ ± ∞",
        "Перiод",
        "Lindstedt–Poincaré",
    ] {
        let (_, width) = font.outline(text);
        let laid_out = libration_report::text_width(text, 1.0);
        // Each advance is rounded to a thousandth.
        let rounding = 0.0005 * f64::from(u32::try_from(text.chars().count()).unwrap());
        assert!((f64::from(width) - laid_out).abs() <= rounding + 1e-5, "{text}: {width} {laid_out}");
    }
}
