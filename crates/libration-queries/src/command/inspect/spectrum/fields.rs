//! Fields of the harmonics of each trace, of its windows and of each harmonic.

use super::SpectrumResult;
use crate::figure::measured_spectrum::{MeasuredSpectrum, unit_scale};
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::{json, number};
use libration_lab::fit::spectrum::{Harmonic, SpectrumWindow};
use libration_lab::measurement::Observable;
use serde_json::Value;

/// A harmonic, of a window or in the mean.
pub(super) struct Line<'a> {
    trace: &'a str,
    observable: Observable,
    /// Number of the window, from 1, with its time; `None` for the mean.
    window: Option<(usize, f64)>,
    /// Frequency of the first harmonic, in Hz.
    fundamental: f64,
    harmonic: &'a Harmonic,
}

impl MeasuredSpectrum {
    /// The means of the windows.
    pub(super) fn means(&self) -> Vec<Line<'_>> {
        self.lines(None, self.spectrum.frequency, &self.spectrum.harmonics)
    }

    fn of_window<'a>(&'a self, number: usize, window: &'a SpectrumWindow) -> Vec<Line<'a>> {
        self.lines(Some((number, window.time)), window.frequency.value, &window.harmonics)
    }

    fn lines<'a>(
        &'a self,
        window: Option<(usize, f64)>,
        fundamental: f64,
        harmonics: &'a [Harmonic],
    ) -> Vec<Line<'a>> {
        let (trace, observable) = (self.name.as_str(), self.spectrum.observable);
        let line = |harmonic| Line { trace, observable, window, fundamental, harmonic };
        harmonics.iter().map(line).collect()
    }

    fn windows(&self) -> Vec<OfWindow<'_>> {
        let windows = (1..).zip(&self.spectrum.windows);
        windows.map(|(number, window)| OfWindow { spectrum: self, number, window }).collect()
    }
}

/// A window of a trace.
struct OfWindow<'a> {
    spectrum: &'a MeasuredSpectrum,
    number: usize,
    window: &'a SpectrumWindow,
}

pub(super) fn of_answer() -> Fields<SpectrumResult> {
    type Of = Field<SpectrumResult>;
    Fields::from([
        Of::value("file", "", "name of the file", |result| result.file.as_str().into()),
        Of::nested("traces[].", &of_trace(), |result| of_trace().records(&result.spectra)),
        Of::value("left_out[]", "", "reasons why other traces have no harmonics", |result| {
            json::list(result.left_out.clone())
        }),
        Of::value("told_from_file[]", "", "settings inferred from the file", |result| {
            json::list(result.findings.clone())
        }),
    ])
}

fn of_trace() -> Fields<MeasuredSpectrum> {
    type Of = Field<MeasuredSpectrum>;
    Fields::from([
        Of::value("name", "", "name of the run", |spectrum| spectrum.name.as_str().into()),
        Of::value("seen", "", "measured quantity: angle or angular velocity", |spectrum| {
            match spectrum.spectrum.observable {
                Observable::Angle => "angle",
                Observable::AngularVelocity => "angular velocity",
            }
            .into()
        }),
        Of::value("unit", "", "rad or rad/s: the unit of the harmonics and the noise", |spectrum| {
            unit_scale(spectrum.spectrum.observable).0.into()
        }),
        Of::number(
            "frequency_hz",
            "Hz",
            "frequency of the first harmonic, the mean of the windows",
            |spectrum| spectrum.spectrum.frequency,
        ),
        Of::number(
            "amplitude_rad",
            "rad",
            "amplitude of the undamped swing with it, the mean of the windows",
            |spectrum| spectrum.spectrum.amplitude,
        ),
        Of::number(
            "noise",
            "",
            "standard deviation of a row about the harmonics; a part of its uncertainty where rows have some",
            |spectrum| spectrum.spectrum.noise,
        ),
        Of::value("outliers", "1", "rows left out, far from all harmonics", |spectrum| {
            spectrum.spectrum.outliers.len().into()
        }),
        Of::nested("harmonics[].", &of_line(), |spectrum| of_line().records(&spectrum.means())),
        Of::nested("windows[].", &of_window(), |spectrum| of_window().records(&spectrum.windows())),
        Of::value(
            "spectrum_hz[]",
            "Hz",
            "frequencies of the spectrum of the first sixty swings",
            |spectrum| {
                json::numbers(
                    &spectrum.spectrum.points.iter().map(|point| point.frequency).collect::<Vec<_>>(),
                )
            },
        ),
        Of::value(
            "spectrum_amplitudes[]",
            "",
            "amplitudes of the best sines there, by Hann's window",
            |spectrum| {
                json::numbers(
                    &spectrum.spectrum.points.iter().map(|point| point.amplitude).collect::<Vec<_>>(),
                )
            },
        ),
        Of::value(
            "spectrum_powers[]",
            "1",
            "fractions of the sum of squares that they explain (Lomb–Scargle)",
            |spectrum| {
                json::numbers(&spectrum.spectrum.points.iter().map(|point| point.power).collect::<Vec<_>>())
            },
        ),
        Of::value("remarks[]", "", "conclusions from the harmonics", |spectrum| {
            json::list(spectrum.spectrum.remarks.iter().map(ToString::to_string))
        }),
        Of::value("remark_kinds[]", "", "kind of each remark, in the same order", |spectrum| {
            json::list(spectrum.spectrum.remarks.iter().map(|remark| remark.name()))
        }),
    ])
}

fn of_window<'a>() -> Fields<OfWindow<'a>> {
    type Of<'a> = Field<OfWindow<'a>>;
    Fields::from([
        Of::number("time_s", "s", "time of its middle", |window| window.window.time),
        Of::value("rows", "1", "rows that count", |window| window.window.rows.into()),
        Of::number("frequency_hz", "Hz", "frequency of the first harmonic", |window| {
            window.window.frequency.value
        }),
        Of::number("frequency_uncertainty_hz", "Hz", "its standard uncertainty", |window| {
            window.window.frequency.uncertainty
        }),
        Of::number(
            "amplitude_rad",
            "rad",
            "amplitude of the undamped swing with the first harmonic",
            |window| window.window.amplitude.value,
        ),
        Of::number("amplitude_uncertainty_rad", "rad", "its standard uncertainty", |window| {
            window.window.amplitude.uncertainty
        }),
        Of::nested("harmonics[].", &of_line(), |window| {
            of_line().records(&window.spectrum.of_window(window.number, window.window))
        }),
    ])
}

pub(super) fn of_line<'a>() -> Fields<Line<'a>> {
    type Of<'a> = Field<Line<'a>>;
    Fields::from([
        Of::value("trace", "", "name of the run", |line| line.trace.into()).only_csv(),
        Of::value("window", "1", "number of the window, from 1; empty for the mean of all", |line| {
            line.window.map_or(Value::Null, |window| window.0.into())
        })
        .only_csv(),
        Of::nullable("time_s", "s", "time of the middle of the window", |line| {
            line.window.map(|window| window.1)
        })
        .only_csv(),
        Of::value("n", "1", "number of the harmonic; 0 for the constant", |line| line.harmonic.n.into())
            .numeral("n", |line| line.harmonic.n.to_string()),
        Of::number("frequency_hz", "Hz", "its frequency", |line| {
            number::count(line.harmonic.n) * line.fundamental
        })
        .short("f / Hz", 5),
        Of::number("amplitude", "", "√(in_phase² + quadrature²), rad or rad/s", |line| {
            line.harmonic.amplitude().value
        })
        .numeral("amplitude", |line| {
            line.shown(line.harmonic.amplitude().value, line.harmonic.amplitude().uncertainty)
        }),
        Of::number("amplitude_uncertainty", "", "its standard uncertainty", |line| {
            line.harmonic.amplitude().uncertainty
        })
        .numeral("±", |line| line.shown_uncertainty(line.harmonic.amplitude().uncertainty)),
        Of::nullable(
            "lag_rad",
            "rad",
            "phase by which it lags behind cos nφ, null where it is lost in noise",
            |line| line.harmonic.lag().map(|lag| lag.value),
        )
        .numeral("lag", |line| line.lag()),
        Of::nullable("lag_uncertainty_rad", "rad", "its standard uncertainty, or null", |line| {
            line.harmonic.lag().map(|lag| lag.uncertainty)
        }),
        Of::number(
            "in_phase",
            "",
            "coefficient of cos nφ, where the first harmonic has maxima at φ = 0",
            |line| line.harmonic.in_phase.value,
        )
        .numeral("in phase", |line| {
            line.shown(line.harmonic.in_phase.value, line.harmonic.in_phase.uncertainty)
        }),
        Of::number("in_phase_uncertainty", "", "its standard uncertainty", |line| {
            line.harmonic.in_phase.uncertainty
        }),
        Of::number("theory", "", "the same of an undamped pendulum with the same first harmonic", |line| {
            line.harmonic.theory
        })
        .numeral("theory", |line| line.shown(line.harmonic.theory, line.harmonic.in_phase.uncertainty)),
        Of::nullable(
            "difference",
            "",
            "in_phase less theory; null for n = 1, by which the amplitude is known",
            |line| line.harmonic.difference.map(|difference| difference.value),
        ),
        Of::nullable("difference_uncertainty", "", "its standard uncertainty, or null", |line| {
            line.harmonic.difference.map(|difference| difference.uncertainty)
        }),
        Of::nullable("deviation", "1", "difference over its uncertainty, or null", |line| {
            line.harmonic.deviation()
        })
        .numeral("diff./σ", |line| deviation(line.harmonic.deviation())),
        Of::nullable("quadrature", "", "coefficient of sin nφ; null for n = 0 and n = 1", |line| {
            line.harmonic.quadrature.map(|quadrature| quadrature.value)
        }),
        Of::nullable("quadrature_uncertainty", "", "its standard uncertainty, or null", |line| {
            line.harmonic.quadrature.map(|quadrature| quadrature.uncertainty)
        }),
        Of::nullable("quadrature_deviation", "1", "quadrature over its uncertainty, or null", |line| {
            line.harmonic.quadrature_deviation()
        })
        .numeral("quad./σ", |line| deviation(line.harmonic.quadrature_deviation())),
        Of::value(
            "degrees_of_freedom",
            "1",
            "degrees of freedom of the noise about it, for Student's t",
            |line| line.harmonic.degrees_of_freedom.into(),
        ),
    ])
}

impl Line<'_> {
    /// A value with two digits of its uncertainty, in degrees for angles.
    fn shown(&self, value: f64, uncertainty: f64) -> String {
        let (_, scale) = unit_scale(self.observable);
        let text = number::with_uncertainty(scale * value, scale * uncertainty, "");
        text.split(" ± ").next().unwrap_or_default().to_owned()
    }

    fn shown_uncertainty(&self, uncertainty: f64) -> String {
        number::rounded(unit_scale(self.observable).1 * uncertainty, 2)
    }

    fn lag(&self) -> String {
        self.harmonic.lag().map_or("–".to_owned(), |lag| format!("{:.0}°", lag.value.to_degrees()))
    }
}

fn deviation(value: Option<f64>) -> String {
    value.map_or("–".to_owned(), |value| format!("{value:.1}"))
}

/// The means, then each window.
pub(super) fn all_lines(spectrum: &MeasuredSpectrum) -> Vec<Line<'_>> {
    let windows = (1..).zip(&spectrum.spectrum.windows);
    let of_windows = windows.flat_map(|(number, window)| spectrum.of_window(number, window));
    spectrum.means().into_iter().chain(of_windows).collect()
}

pub(in crate::command::inspect) fn answers() -> Answers {
    let (json, csv) = (of_answer().described(""), of_line().described_in_csv());
    Answers { command: "inspect", option: "--spectrum", json, csv }
}
