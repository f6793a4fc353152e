//! A list of angles as one argument: `30deg,90deg` or `30deg:150deg:30deg`.

use super::bare;
use libration::quantity::{Angle, angles};

/// More curves than a picture can keep apart.
const MOST: usize = 35;

/// A short list of angles.
#[derive(Clone, Debug)]
pub(crate) struct AngleList(Vec<Angle>);

impl AngleList {
    pub(crate) fn iter(&self) -> impl Iterator<Item = &Angle> {
        self.0.iter()
    }
}

pub(crate) fn angle_list(text: &str) -> Result<AngleList, String> {
    let angles = angles(text).map_err(|error| error.to_string())?;
    bare::say(text);
    if angles.len() > MOST {
        return Err(format!("{} angles are more than a picture shows: give at most {MOST}", angles.len()));
    }
    Ok(AngleList(angles))
}
