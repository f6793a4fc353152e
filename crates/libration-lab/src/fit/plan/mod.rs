//! Planning a measurement of g by recorded swings: the amplitude, the number of swings, and the uncertainty of the length.
//!
//! g = ω0²L, so that its relative uncertainty is that of the length, twice that of ω0, and twice that of the clock. The uncertainty of ω0 from rows
//! with independent errors is the Cramér–Rao bound (`information.rs`), which a least-squares fit reaches; the effect of a wrong scale of the angles
//! on ω0 is the resulting change of the fitted motion. All four are independent and add as squares, as in the [budget](super::evaluate_budget) of the
//! finished measurement.
//!
//! Reference: D. C. Rife and R. R. Boorstyn, IEEE Trans. Inf. Theory 20, 591 (1974), doi:10.1109/TIT.1974.1055282, whose bound for the
//! frequency of a sinusoid, u(Ω)² = 24σ²/(A²NT²), is that for small amplitudes.

mod information;

use libration::pendulum::{Amplitude, Pendulum};
use libration::quantity::{Quantity, short};

/// Largest number of swings in a plan.
pub const MOST_SWINGS: usize = 10_000;

/// Fewer swings than this do not separate the motion from an offset well enough.
pub const FEWEST_SWINGS: usize = 2;

/// Fewest rows in a period for which a fit of the trace finds a start: swings of 60° had none with 4.8 rows, and one with 6.
const FEWEST_ROWS: f64 = 6.0;

/// The pendulum, and the instrument that records its angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannedRecording {
    /// Distance from the pivot to the centre of the bob, in metres.
    pub length: Quantity,
    /// Approximate value of g, in m/s².
    pub gravity: f64,
    /// The standard deviation of the angle in a row, in radians.
    pub angle_noise: f64,
    /// Rows per second.
    pub rate: f64,
    /// The coefficient b of linear damping in 1/s: amplitudes fall as exp(−bt/2). It is fitted even if it is zero.
    pub linear_damping: f64,
    /// The relative standard uncertainty of all angles together.
    pub angle_scale: f64,
    /// The relative standard uncertainty of the clock.
    pub clock: f64,
}

/// Reasons for the lack of a plan.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// An impossible number.
    #[error("the {name} is {value:?}: give {wanted}")]
    Number {
        /// Name of the number.
        name: &'static str,
        /// The given value.
        value: f64,
        /// Description of a usable value.
        wanted: &'static str,
    },
    /// No amplitudes to choose from.
    #[error("there is no amplitude to choose from: give at least one")]
    NoAmplitude,
    /// Too few rows for swings to be resolved.
    #[error(
        "{rate:?} rows per second are {rows:.2} in a period of {period:.3} s: give at least {FEWEST_ROWS} rows a period"
    )]
    FewRows {
        /// Number of rows per second.
        rate: f64,
        /// Number of rows in a period.
        rows: f64,
        /// Period in seconds.
        period: f64,
    },
    /// The uncertainty of the clock alone exceeds the wanted one of g.
    #[error(
        "the clock alone gives g a relative uncertainty of {part}, more than the target of {target}: calibrate it against a better one"
    )]
    Clock {
        /// Contribution of the clock, relative to g.
        part: String,
        /// Wanted uncertainty, relative to g.
        target: String,
    },
}

/// The relative standard uncertainties of g by each cause.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExpectedUncertainty {
    /// Contribution of the length.
    pub length: f64,
    /// Contribution of the noise of the angles.
    pub noise: f64,
    /// Contribution of the scale of the angles.
    pub angle_scale: f64,
    /// Contribution of the clock.
    pub clock: f64,
}

impl ExpectedUncertainty {
    /// The root of the sum of the squares.
    #[must_use]
    pub fn total(&self) -> f64 {
        let Self { length, noise, angle_scale, clock } = *self;
        libm::hypot(libm::hypot(length, clock), libm::hypot(noise, angle_scale))
    }

    /// Contribution of the recording itself.
    fn recorded(&self) -> f64 {
        libm::hypot(self.noise, self.angle_scale)
    }
}

impl PlannedRecording {
    /// Expected uncertainties of a recording that lasts `swings` periods of its first swing, from the release at an amplitude.
    ///
    /// # Accuracy
    /// The contribution of the noise is right within a tenth, up to 90° and from three swings on; harmonics are not counted.
    ///
    /// # Examples
    /// ```
    /// use libration::pendulum::Amplitude;
    /// use libration::quantity::Quantity;
    /// use libration_lab::fit::plan::PlannedRecording;
    ///
    /// let length = Quantity { value: 1.0, uncertainty: Some(0.0005) };
    /// let recording = PlannedRecording {
    ///     length, gravity: 9.81, angle_noise: 0.0035, rate: 60.0, linear_damping: 0.0, angle_scale: 0.01, clock: 0.0,
    /// };
    /// let expected = recording.expected(&Amplitude::new("20deg".parse()?)?, 10);
    /// assert_eq!(expected.length, 0.0005);
    /// assert!(expected.noise < 2e-4 && expected.total() < 7e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn expected(&self, amplitude: &Amplitude, swings: usize) -> ExpectedUncertainty {
        let [noise, shift] = information::of_frequency(self, amplitude, self.duration(amplitude, swings));
        ExpectedUncertainty {
            length: self.length.uncertainty.unwrap_or(0.0) / self.length.value,
            noise: 2.0 * noise,
            angle_scale: 2.0 * shift.abs() * self.angle_scale,
            clock: 2.0 * self.clock,
        }
    }

    /// √(g/L), in rad/s.
    #[doc(hidden)]
    pub fn angular_frequency(&self) -> f64 {
        (self.gravity / self.length.value).sqrt()
    }

    /// Duration of `swings` periods of the first swing, in seconds.
    #[must_use]
    pub fn duration(&self, amplitude: &Amplitude, swings: usize) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "at most a few thousand")]
        let swings = swings as f64;
        swings * std::f64::consts::TAU / self.angular_frequency() * amplitude.period_ratio()
    }

    fn check(&self) -> Result<(), PlanError> {
        let above_zero = "a finite number above zero";
        let not_below_zero = "a finite number that is zero or above";
        let uncertainty = self.length.uncertainty.unwrap_or(0.0);
        for (name, value, may_vanish) in [
            ("length", self.length.value, false),
            ("gravity", self.gravity, false),
            ("noise of the angles", self.angle_noise, false),
            ("number of rows per second", self.rate, false),
            ("uncertainty of the length", uncertainty, true),
            ("damping", self.linear_damping, true),
            ("uncertainty of the scale of the angles", self.angle_scale, true),
            ("uncertainty of the clock", self.clock, true),
        ] {
            let is_right = value.is_finite() && (value > 0.0 || (may_vanish && value >= 0.0));
            let wanted = if may_vanish { not_below_zero } else { above_zero };
            is_right.then_some(()).ok_or(PlanError::Number { name, value, wanted })?;
        }
        let pendulum = Pendulum::new(self.length.value, self.gravity);
        let period = pendulum.map_or(f64::NAN, |pendulum| pendulum.small_angle_period());
        let rows = self.rate * period;
        match rows >= FEWEST_ROWS {
            true => Ok(()),
            false => Err(PlanError::FewRows { rate: self.rate, rows, period }),
        }
    }
}

/// A recording that reaches the target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannedSwings {
    /// Amplitude of the release, in radians.
    pub amplitude: f64,
    /// The fewest swings that suffice; `None` where [`MOST_SWINGS`] are too few.
    pub swings: Option<usize>,
    /// Duration of the recording, in seconds; of [`MOST_SWINGS`] where these are too few.
    pub duration: f64,
    /// Expected uncertainties, with the present one of the length.
    pub expected: ExpectedUncertainty,
}

/// Plan for a measurement of g to a wanted uncertainty.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// The wanted relative standard uncertainty of g.
    pub target: f64,
    /// Uncertainty that noise and scale of the angles may contribute.
    pub left_for_recording: f64,
    /// Required uncertainty of the length in metres, where the present one is too large: half of the target, in squares, is then left to the length.
    pub length_needed: Option<f64>,
    /// Recordings, one for each amplitude.
    pub choices: Vec<PlannedSwings>,
    /// Index of the choice with the fewest swings; of equal ones the smallest amplitude. `None` where none suffices.
    pub best: Option<usize>,
}

impl Plan {
    /// The best choice.
    #[must_use]
    pub fn best(&self) -> Option<&PlannedSwings> {
        self.best.map(|index| &self.choices[index])
    }

    /// Instructions, as sentences.
    #[must_use]
    pub fn advice(&self) -> Vec<String> {
        let length = self.length_needed.map(|needed| {
            format!(
                "measure the length to {} mm: with its present uncertainty g cannot be known to {}",
                short(1e3 * needed, 2),
                percent(self.target)
            )
        });
        let swings = match self.best() {
            Some(best) => {
                let (degrees, seconds) = (short(best.amplitude.to_degrees(), 3), short(best.duration, 3));
                format!(
                    "release at {degrees} degrees and record {} swings, {seconds} s",
                    best.swings.unwrap_or(MOST_SWINGS)
                )
            }
            None => format!(
                "no recording of up to {MOST_SWINGS} swings is sufficient at these amplitudes: use an instrument with less noise, more rows per second or a better known scale of angles"
            ),
        };
        length.into_iter().chain([swings]).collect()
    }
}

fn percent(part: f64) -> String {
    format!("{} %", short(100.0 * part, 2))
}

/// Plans the fewest swings at each amplitude that leave g a relative standard uncertainty of at most `target`.
///
/// If the uncertainty of the length alone exceeds the target, the plan assumes a smaller one, and states it.
///
/// # Errors
/// Fails for impossible numbers, too few rows for a swing, and a clock that is not good enough.
///
/// # Examples
/// ```
/// use libration::pendulum::Amplitude;
/// use libration::quantity::Quantity;
/// use libration_lab::fit::plan::{PlannedRecording, plan};
///
/// let length = Quantity { value: 1.0, uncertainty: Some(0.01) };
/// let recording = PlannedRecording {
///     length, gravity: 9.81, angle_noise: 0.0035, rate: 60.0, linear_damping: 0.0, angle_scale: 0.0, clock: 0.0,
/// };
/// let plan = plan(&recording, 1e-3, &[Amplitude::new("20deg".parse()?)?])?;
/// // A hundredth of the length is too much.
/// assert_eq!(plan.length_needed, Some(1e-3 / 2.0_f64.sqrt()));
/// assert_eq!(plan.best().and_then(|best| best.swings), Some(2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn plan(recording: &PlannedRecording, target: f64, amplitudes: &[Amplitude]) -> Result<Plan, PlanError> {
    recording.check()?;
    if !(target > 0.0 && target < 1.0) {
        let wanted = "a part of g between 0 and 1";
        return Err(PlanError::Number { name: "wanted uncertainty", value: target, wanted });
    }
    if amplitudes.is_empty() {
        return Err(PlanError::NoAmplitude);
    }
    let (left_for_recording, length_needed) = shares(recording, target)?;
    let choice = |amplitude: &Amplitude| {
        let swings = fewest_swings(recording, amplitude, left_for_recording);
        let shown = swings.unwrap_or(MOST_SWINGS);
        PlannedSwings {
            amplitude: amplitude.radians(),
            swings,
            duration: recording.duration(amplitude, shown),
            expected: recording.expected(amplitude, shown),
        }
    };
    let choices: Vec<PlannedSwings> = amplitudes.iter().map(choice).collect();
    let effort = |index: &usize| (choices[*index].swings, choices[*index].amplitude);
    let less = |one: &usize, other: &usize| {
        let ((swings, amplitude), (others, larger)) = (effort(one), effort(other));
        swings.cmp(&others).then(amplitude.total_cmp(&larger))
    };
    let best = (0..choices.len()).filter(|index| choices[*index].swings.is_some()).min_by(less);
    Ok(Plan { target, left_for_recording, length_needed, choices, best })
}

/// Uncertainty that the recording may contribute, and the required uncertainty of the length in metres, where the present one is too large.
fn shares(recording: &PlannedRecording, target: f64) -> Result<(f64, Option<f64>), PlanError> {
    let clock = 2.0 * recording.clock;
    let left = target * target - clock * clock;
    if left <= 0.0 {
        return Err(PlanError::Clock { part: percent(clock), target: percent(target) });
    }
    let length = recording.length.uncertainty.unwrap_or(0.0) / recording.length.value;
    // Leaving nearly everything to the length would require an impossible recording.
    const ROOM: f64 = 0.05;
    match left - length * length {
        room if room >= ROOM * left => Ok((room.sqrt(), None)),
        _ => Ok(((left / 2.0).sqrt(), Some((left / 2.0).sqrt() * recording.length.value))),
    }
}

/// The fewest swings whose noise and scale contribute at most `most`.
fn fewest_swings(recording: &PlannedRecording, amplitude: &Amplitude, most: f64) -> Option<usize> {
    let does = |swings: usize| recording.expected(amplitude, swings).recorded() <= most;
    let mut enough = FEWEST_SWINGS;
    while !does(enough) {
        if enough == MOST_SWINGS {
            return None;
        }
        enough = (2 * enough).min(MOST_SWINGS);
    }
    let mut too_few = enough / 2;
    while enough > FEWEST_SWINGS && enough - too_few > 1 {
        let middle = usize::midpoint(too_few, enough);
        if does(middle) {
            enough = middle;
        } else {
            too_few = middle;
        }
    }
    Some(enough)
}
