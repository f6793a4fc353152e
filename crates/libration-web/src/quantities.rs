//! Angles and physical quantities as people write them.

use crate::exchange::exchange;
use libration::quantity::{Angle, Dimension, Quantity, parse};

/// Reads the text as an angle: its radians, radians within the turn, complement and turns.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn angle() -> bool {
    let mut exchange = exchange();
    let read = exchange.take_text().and_then(|text| text.parse::<Angle>().map_err(|error| error.to_string()));
    #[expect(clippy::cast_precision_loss, reason = "angles have at most 2⁵³ turns")]
    exchange
        .answer(read.map(|read| vec![read.radians(), read.in_turn(), read.complement(), read.turns() as f64]))
}

/// Reads the text as a length in metres.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn length() -> bool {
    quantity(Dimension::Length)
}

/// Reads the text as an acceleration in m/s².
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn acceleration() -> bool {
    quantity(Dimension::Acceleration)
}

/// Reads the text as an angular velocity in rad/s.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn angular_velocity() -> bool {
    quantity(Dimension::AngularVelocity)
}

fn quantity(dimension: Dimension) -> bool {
    let mut exchange = exchange();
    let read =
        exchange.take_text().and_then(|text| parse(&text, dimension).map_err(|error| error.to_string()));
    exchange.answer(read.map(|Quantity { value, uncertainty, .. }| vec![value, uncertainty.unwrap_or(0.0)]))
}
