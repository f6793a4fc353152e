//! Measured gravity compared with normal gravity at the place.

use super::field::{Field, Fields};
use super::number;
use libration_lab::fit::Uncertain;

/// Measured gravity with the normal gravity of its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NormalGravity {
    pub(crate) measured: Uncertain,
    pub(crate) normal: Uncertain,
}

impl NormalGravity {
    /// The difference with the standard uncertainty of both.
    fn difference(&self) -> Uncertain {
        let value = self.measured.value - self.normal.value;
        Uncertain { value, uncertainty: self.normal.uncertainty }.with_error(self.measured.uncertainty)
    }

    /// The difference in units of that uncertainty.
    fn deviation(&self) -> f64 {
        let Uncertain { value, uncertainty } = self.difference();
        value / uncertainty
    }

    /// The line of a sheet.
    pub(crate) fn line(&self) -> (&'static str, String) {
        let normal = number::with_uncertainty(self.normal.value, self.normal.uncertainty, "m/s²");
        let Uncertain { value, uncertainty } = self.difference();
        let difference = number::with_uncertainty(value, uncertainty, "m/s²");
        let deviation = number::rounded(self.deviation(), 2);
        (
            "normal gravity",
            format!("{normal}  (GRS80 and local anomaly; measured less normal: {difference}, {deviation} u)"),
        )
    }
}

/// The fields, left out where no latitude is given.
pub(crate) fn fields() -> Fields<Option<NormalGravity>> {
    type Of = Field<Option<NormalGravity>>;
    Fields::from([
        Of::present(
            "normal_gravity_m_per_s2",
            "m/s²",
            "normal gravity at the latitude and height that are given (GRS80)",
            |answer| answer.map(|compared| compared.normal.value),
        ),
        Of::present(
            "normal_gravity_uncertainty_m_per_s2",
            "m/s²",
            "standard uncertainty of that by the local anomaly",
            |answer| answer.map(|compared| compared.normal.uncertainty),
        ),
        Of::present(
            "normal_gravity_deviation",
            "1",
            "measured less normal gravity, over the standard uncertainty of both",
            |answer| answer.map(|compared| compared.deviation()),
        ),
    ])
}
