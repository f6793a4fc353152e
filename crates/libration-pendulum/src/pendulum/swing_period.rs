//! The period of a swing with related quantities, for little more than the cost of one of them.

use super::amplitude::period_of_quarter;
use super::{Amplitude, Pendulum};

/// The period of a libration with related quantities; each field equals the result of the method of its name, bit for bit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SwingPeriod {
    /// [`Pendulum::period`] in seconds.
    pub period: f64,
    /// [`Amplitude::period_ratio`], T/T0.
    pub ratio: f64,
    /// [`Amplitude::period_excess`], T/T0 − 1.
    pub excess: f64,
    /// [`Amplitude::nome`].
    pub nome: f64,
    /// [`Amplitude::condition`].
    pub condition: f64,
}

impl Pendulum {
    /// The period of the libration with this amplitude, and related quantities.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_pendulum as libration;
    /// use libration::pendulum::{Amplitude, Pendulum};
    /// let (pendulum, amplitude) = (Pendulum::new(1.0, 9.81)?, Amplitude::new("60deg".parse()?)?);
    /// let swing = pendulum.swing_period(&amplitude);
    /// assert_eq!((swing.period, swing.nome), (pendulum.period(&amplitude), amplitude.nome()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn swing_period(&self, amplitude: &Amplitude) -> SwingPeriod {
        let of_modulus = amplitude.of_modulus();
        let (ratio, excess) = amplitude.ratio_and_excess();
        SwingPeriod {
            period: period_of_quarter(of_modulus.first, self.angular_frequency_words()),
            ratio,
            excess,
            nome: of_modulus.nome,
            condition: of_modulus.condition,
        }
    }
}
