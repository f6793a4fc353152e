//! Ranges `START:STOP:STEP` and comma-separated lists, of angles and of other numbers.
//!
//! The k-th element is START + k·STEP in exact arithmetic, rounded once. STOP belongs to the range if a whole number of steps reaches it to
//! within 5e-10 of a step.

use super::angle_text::exact_angle;
use super::decimal::Decimal;
use super::excerpt::excerpt;
use super::physical::ExactQuantity;
use super::progression::Progression;
use super::range_error::RangeError;
use super::{Angle, Dimension, Displacement};

/// Equally spaced angles, from text such as `1deg:179deg:1deg`.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quantity::AngleRange;
///
/// let degrees = AngleRange::parse("0.1deg:0.9deg:0.1deg")?;
/// assert_eq!(degrees.len(), 9);
/// assert_eq!(degrees.get(2), Some("0.3deg".parse()?));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct AngleRange(Progression);

impl AngleRange {
    /// Reads a range `START:STOP:STEP` whose parts are angles.
    ///
    /// # Errors
    /// Text that does not consist of three angles; bare numbers together with angles that have a unit; a step of zero or away from the stop;
    /// more than ten million elements.
    pub fn parse(text: &str) -> Result<Self, RangeError> {
        let parts = three_parts(text, "1deg:179deg:1deg")?;
        if units_are_mixed(&parts) {
            return Err(RangeError::MixedUnits(excerpt(text)));
        }
        let [start, stop, step] = parts;
        let (start, stop, step) = (exact_angle(start)?, exact_angle(stop)?, exact_angle(step)?);
        Ok(Self(Progression::new(text, start, &stop, step)?))
    }

    /// Number of angles; at least one.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.count
    }

    /// Always `false`: a range contains at least its start.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.count == 0
    }

    /// The k-th angle, counted from zero.
    #[must_use]
    pub fn get(&self, k: usize) -> Option<Angle> {
        self.0.get(k).map(|element| element.to_angle_as_text_means())
    }

    /// The angles in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Angle> + '_ {
        (0..self.len()).map(|k| self.0.element(k).to_angle_as_text_means())
    }
}

/// Equally spaced numbers in an SI unit, from text such as `0:10:0.1` or `0s:500ms:1ms`.
#[derive(Clone, Debug)]
pub struct NumberRange(Progression);

impl NumberRange {
    /// Reads a range `START:STOP:STEP` whose parts are quantities of this dimension.
    ///
    /// # Errors
    /// Text that does not consist of three quantities; a step of zero or away from the stop; more than ten million elements.
    pub fn parse(text: &str, dimension: Dimension) -> Result<Self, RangeError> {
        let [start, stop, step] = three_parts(text, "0:10:0.1")?;
        let exact = |part| Ok::<_, RangeError>(ExactQuantity::parse(part, dimension)?.value);
        Ok(Self(Progression::new(text, exact(start)?, &exact(stop)?, exact(step)?)?))
    }

    /// Number of numbers; at least one.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.count
    }

    /// Always `false`: a range contains at least its start.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.count == 0
    }

    /// The k-th number, counted from zero: the nearest `f64` to START + k·STEP.
    #[must_use]
    pub fn get(&self, k: usize) -> Option<f64> {
        self.0.get(k).and_then(|element| element.nearest())
    }

    /// The numbers in order.
    pub fn iter(&self) -> impl Iterator<Item = f64> + '_ {
        (0..self.len()).filter_map(|k| self.get(k))
    }
}

/// Reads one angle, several separated by commas, or a range.
///
/// # Errors
/// As for [`AngleRange::parse`] and for parsing an [`Angle`].
pub fn angles(text: &str) -> Result<Vec<Angle>, RangeError> {
    if text.contains(':') {
        return Ok(AngleRange::parse(text)?.iter().collect());
    }
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    if units_are_mixed(&parts) {
        return Err(RangeError::MixedUnits(excerpt(text)));
    }
    parts.into_iter().map(|part| Ok(part.parse()?)).collect()
}

/// Reads one number, several separated by commas, or a range, in the SI unit of the dimension.
///
/// # Errors
/// As for [`NumberRange::parse`] and [`super::parse`].
pub fn numbers(text: &str, dimension: Dimension) -> Result<Vec<f64>, RangeError> {
    if text.contains(':') {
        return Ok(NumberRange::parse(text, dimension)?.iter().collect());
    }
    text.split(',').map(|part| Ok(super::parse(part, dimension)?.value)).collect()
}

/// Reads numbers as [`numbers`] does, as exact decimals.
///
/// # Errors
/// As for [`numbers`].
pub fn exact_numbers(text: &str) -> Result<Vec<Displacement>, RangeError> {
    if text.contains(':') {
        // Numbers here have no unit, so any dimension serves.
        let range = NumberRange::parse(text, Dimension::Length)?.0;
        return Ok((0..range.count).map(|k| Displacement(range.element(k))).collect());
    }
    text.split(',').map(|part| Ok(Displacement::from_number_text(part)?)).collect()
}

/// Reads angles as [`angles`] does, exactly as written.
///
/// # Errors
/// As for [`angles`].
pub fn exact_angles(text: &str) -> Result<Vec<Displacement>, RangeError> {
    if text.contains(':') {
        let range = AngleRange::parse(text)?.0;
        return Ok((0..range.count).map(|k| Displacement(range.element(k))).collect());
    }
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    if units_are_mixed(&parts) {
        return Err(RangeError::MixedUnits(excerpt(text)));
    }
    parts.into_iter().map(|part| Ok(Displacement::from_angle_text(part)?)).collect()
}

/// Returns `true` if bare numbers (other than zero) are mixed with angles that have a unit: `60,5deg` was meant otherwise.
fn units_are_mixed(parts: &[&str]) -> bool {
    let has_unit =
        |part: &&str| ["deg", "°", "rad"].iter().any(|unit| part.to_ascii_lowercase().contains(unit));
    let is_bare = |part: &&str| Decimal::parse(part).is_some_and(|number| !number.exact().is_zero());
    parts.iter().any(has_unit) && parts.iter().any(is_bare)
}

fn three_parts<'a>(text: &'a str, example: &'static str) -> Result<[&'a str; 3], RangeError> {
    let mut parts = text.split(':').map(str::trim);
    match (parts.next(), parts.next(), parts.next(), parts.next()) {
        (Some(start), Some(stop), Some(step), None) => Ok([start, stop, step]),
        _ => Err(RangeError::NotThreeParts(excerpt(text), example)),
    }
}
