//! Shapes of bobs: `disc:radius=5cm,thickness=8mm`.

use super::text::length_with_uncertainty;
use libration::quantity::Quantity;
use libration_lab::fit::{Bob, BobShape};

/// The form of the option, for messages.
const FORM: &str = "give a shape with its lengths: ball:radius=2cm, disc:radius=5cm,thickness=1cm, cylinder:radius=2cm,height=5cm, \
                    ring:radius=5cm,inner=3cm, cap:radius=5cm,height=3cm (of a ball), or gyration:radius=2cm for any other";

/// Reads `SHAPE:NAME=LENGTH,...`.
pub(super) fn bob(text: &str) -> Result<Bob, String> {
    let (name, lengths) = text.split_once(':').ok_or_else(|| FORM.to_owned())?;
    let shape = BobShape::ALL.into_iter().find(|shape| shape.name() == name.trim());
    let shape = shape.ok_or_else(|| format!("`{}` is not a shape: {FORM}", name.trim()))?;
    let (mut radius, mut height, mut inner_radius) = (None, None, None);
    for each in lengths.split(',') {
        let (name, length) = each.split_once('=').ok_or_else(|| FORM.to_owned())?;
        let dimension = match name.trim() {
            "radius" => &mut radius,
            "height" if shape.needs_height() => &mut height,
            "thickness" if shape.has_height() && !shape.needs_height() => &mut height,
            "inner" if shape == BobShape::Ring => &mut inner_radius,
            other => return Err(format!("a {} has no `{other}`: {FORM}", shape.name())),
        };
        if dimension.replace(length_with_uncertainty(length)?).is_some() {
            return Err(format!("`{}` is given twice", name.trim()));
        }
    }
    let needed = |length: Option<Quantity>, name: &str, is_needed: bool| match length {
        None if is_needed => Err(format!("a {} needs its {name}: {FORM}", shape.name())),
        length => Ok(length),
    };
    let height = needed(height, "height", shape.needs_height())?;
    let inner_radius = needed(inner_radius, "inner", shape == BobShape::Ring)?;
    let radius = radius.ok_or_else(|| format!("a {} needs its radius: {FORM}", shape.name()))?;
    let bob = Bob { shape, radius, height, inner_radius };
    bob.check().map_err(|error| error.to_string())?;
    Ok(bob)
}
