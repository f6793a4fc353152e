//! The laboratory of `libration`: reads the files of instruments, and fits the exact law of the pendulum to their data.
//!
//! # Terms
//! A **recording** is the content of a file: its **sheets** of columns with quantities and units. A **trace** is one run of
//! angles or angular velocities in time, a **cycle** one period of it. A **finding** is a setting inferred from the file,
//! with the **choice** that overrides it. Uncertainties are **standard uncertainties**; the **expanded uncertainty** of g is
//! that of its **budget**. **β** tests the exact law: the measured rise of the period with the amplitude over the exact one.
//!
//! # Tasks
//!
//! | module | tasks | begin with |
//! |---|---|---|
//! | [`measurement`] | columns, traces, photogate times and faults of a file | [`Recording`](measurement::Recording), [`Trace`](measurement::Trace) |
//! | [`fit`] | measured swings: ω0, damping, g, warnings and advice | [`fit_swings`](fit::swings::fit_swings) |
//! | | periods against amplitude; periods against length | [`fit_periods`](fit::fit_periods), [`fit_lengths`](fit::fit_lengths) |
//! | | falling amplitudes: damping law, quality factor | [`amplitudes`](fit::amplitudes) |
//! | | photogate times; responses of a driven oscillator; harmonics of swings | [`gates`](fit::gates), [`response`](fit::response), [`spectrum`](fit::spectrum) |
//! | | budget of the uncertainty of g; plan of a measurement | [`evaluate_budget`](fit::evaluate_budget), [`plan`](fit::plan) |
//!
//! # A swing
//! Without a length, the fit gives that of the simple pendulum with the same period in standard gravity:
//!
//! ```
//! use libration::pendulum::Pendulum;
//! use libration::progress::Quiet;
//! use libration_lab::fit::swings::{Advice, FittedPendulum, SwingsOptions, fit_swings};
//! use libration_lab::measurement::{Observable, Trace};
//!
//! let motion = Pendulum::from_angular_frequency(4.0)?.released_from("40deg".parse()?)?;
//! let times: Vec<f64> = (0..400).map(|row| 0.025 * f64::from(row)).collect();
//! let angles = times.iter().map(|&time| motion.state_at(time).angle).collect();
//! let trace = Trace::new("exact", Observable::Angle, times, angles, None)?;
//! let undamped = SwingsOptions { damping: Some("undamped".parse()?), ..SwingsOptions::default() };
//! let fitted = fit_swings(&[trace], &undamped, &Quiet)?;
//! let FittedPendulum::Length(length) = fitted.pendulum else { return Err("a length was given".into()) };
//! assert!((length.value - 9.80665 / 16.0).abs() < 1e-6);
//! assert!(fitted.advice.contains(&Advice::GiveLength));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Errors and accuracy
//! A file that leaves a setting open is an error with the choices that would decide it. A fit that the data do not determine is
//! an error; doubts about a result are **warnings** with stable names. Uncertainties include the scatter of the rows, their
//! correlation, and the difference of models that the data do not exclude. Files, screen and clock belong to the caller.

pub mod fit;
pub mod measurement;
mod parallel;
mod statistics;

/// The inner parts that the suite tests; no promise of stability.
#[doc(hidden)]
pub mod internals {
    pub mod fit {
        pub mod budget {
            pub mod derivative {
                pub use crate::fit::budget::derivative::{derivative, second_derivative};
            }
        }
        pub mod cycles {
            pub mod centre {
                pub use crate::fit::cycles::centre::Centre;
            }
            pub mod decay_rates {
                pub use crate::fit::cycles::decay_rates::DecayRates;
            }
            pub mod even {
                pub use crate::fit::cycles::even::Even;
            }
            pub mod generalised {
                pub use crate::fit::cycles::generalised::{Bands, Factor};
            }
            pub mod local_fit {
                pub use crate::fit::cycles::local_fit::{LocalFit, Points, powers};
            }
            pub mod shape {
                pub use crate::fit::cycles::shape::{
                    Shape, amplitude_of_velocity, often, slope_of_amplitude,
                };
            }
            pub mod swings {
                pub use crate::fit::cycles::swings::{Stretch, swings, without_spikes};
            }
            pub mod turning_point {
                pub use crate::fit::cycles::turning_point::Extreme;
            }
        }
        pub mod effective_weights {
            pub use crate::fit::effective_weights::{Weighted, settled};
        }
        pub mod gates {
            pub mod directions {
                pub use crate::fit::gates::directions::sorted;
            }
            pub mod passages {
                pub use crate::fit::gates::passages::{Passage, passages};
            }
            pub mod speeds {
                pub use crate::fit::gates::speeds::NearBottom;
            }
            pub mod trend {
                pub use crate::fit::gates::trend::at_the_beginning;
            }
            pub mod width {
                pub use crate::fit::gates::width::{PassingDisc, PassingFlag};
            }
        }
        pub mod law {
            pub use crate::fit::law::Point;
        }
        pub mod plan {
            pub use crate::fit::plan::FEWEST_SWINGS;
        }
        pub mod response {
            pub mod stability {
                pub use crate::fit::response::stability::stability;
            }
        }
        pub mod scatter {
            pub use crate::fit::scatter::degrees_of_freedom;
        }
        pub mod spectrum {
            pub mod theory {
                pub use crate::fit::spectrum::theory::{Growth, Theory};
            }
        }
        pub mod trace {
            pub mod clock {
                pub use crate::fit::trace::clock::deviation;
            }
            pub mod comparison {
                pub use crate::fit::trace::comparison::simplest;
            }
            pub mod huber {
                pub use crate::fit::trace::huber::{
                    BOUND, bounded, factor, is_outlier, loss, scale, variance,
                };
            }
            pub mod information {
                pub use crate::fit::trace::information::misfit;
            }
            pub mod minimum {
                pub use crate::fit::trace::minimum::{Care, Start, TraceMinimum, descent};
            }
            pub mod model {
                pub use crate::fit::trace::model::ResidualRows;
            }
            pub mod noise {
                pub use crate::fit::trace::noise::{FACTOR, Part, Rows, mean_effect, memories, times};
            }
            pub mod problem {
                pub use crate::fit::trace::problem::{PATIENCE, Problem};
            }
            pub mod profile {
                pub use crate::fit::trace::profile::{LEVELS, linear_intervals, students};
            }
            pub mod random {
                pub use crate::fit::trace::random::Random;
            }
            pub mod search {
                pub use crate::fit::trace::search::from_scratch;
            }
            pub mod series {
                pub use crate::fit::trace::series::{Series, of_search, whole};
            }
            pub mod swing {
                pub use crate::fit::trace::swing::{Course, EXACT, Seen, Swing};
            }
            pub mod systematic {
                pub use crate::fit::trace::systematic::add;
            }
            pub mod uncertainty {
                pub use crate::fit::trace::uncertainty::fit;
            }
            pub mod weights {
                pub use crate::fit::trace::weights::Weights;
            }
        }
        pub mod typical_amplitude {
            pub use crate::fit::typical_amplitude::typical_amplitude;
        }
    }
    pub mod measurement {
        pub mod container {
            pub mod date_formats {
                pub use crate::measurement::container::date_formats::shows_date;
            }
            pub mod grid {
                pub use crate::measurement::container::grid::CellGrid;
            }
            pub mod xls {
                pub mod records {
                    pub use crate::measurement::container::xls::records::{Record, Records, small_number};
                }
                pub mod strings {
                    pub use crate::measurement::container::xls::strings::{long, short, table};
                }
            }
            pub mod xlsx {
                pub mod contents {
                    pub use crate::measurement::container::xlsx::contents::unescaped;
                }
                pub mod worksheet {
                    pub use crate::measurement::container::xlsx::worksheet::{
                        MOST_COLUMNS, MOST_ROWS, position_of,
                    };
                }
            }
        }
        pub mod counted_periods {
            pub use crate::measurement::counted_periods::{counted, counted_in};
        }
        pub mod faults {
            pub mod clipping {
                pub use crate::measurement::faults::clipping::clipped;
            }
            pub mod even_times {
                pub use crate::measurement::faults::even_times::{EvenTimes, centroid};
            }
            pub mod order {
                pub use crate::measurement::faults::order::restarts;
            }
            pub mod outliers {
                pub use crate::measurement::faults::outliers::{LONGEST, outliers};
            }
            pub mod significant_digits {
                pub use crate::measurement::faults::significant_digits::SignificantDigits;
            }
        }
        pub mod heading {
            pub mod words {
                pub use crate::measurement::heading::words::{Words, is_of_acceleration};
            }
        }
        pub mod number {
            pub use crate::measurement::number::Cell;
        }
        pub mod traces {
            pub mod circle {
                pub use crate::measurement::traces::circle::{Circle, distances};
            }
            pub mod gyroscope {
                pub use crate::measurement::traces::gyroscope::{FEWEST, principal_axis};
            }
            pub mod sequence {
                pub use crate::measurement::traces::sequence::Sequence;
            }
            pub mod turns {
                pub use crate::measurement::traces::turns::{take_out_jumps, unwrap};
            }
        }
    }
    pub mod parallel {
        pub use crate::parallel::{map, on_cores};
    }
    pub mod statistics {
        pub use crate::statistics::count::count;
        pub mod akaike {
            pub use crate::statistics::akaike::{cost, of_chi_squared, of_scatter};
        }
        pub mod chi_squared {
            pub use crate::statistics::chi_squared::probability_beyond;
        }
        pub mod fisher {
            pub use crate::statistics::fisher::probability_beyond;
        }
        pub mod least_squares {
            pub use crate::statistics::least_squares::{
                Design, ROUNDING, Undetermined, least_squares, weighted_least_squares,
            };
        }
        pub mod levenberg_marquardt {
            pub use crate::statistics::levenberg_marquardt::{Effort, Linearised, ResidualsError, minimum};
        }
        pub mod robust {
            pub use crate::statistics::robust::robust_deviation;
        }
        pub mod student {
            pub use crate::statistics::student::{probability_beyond, quantile};
        }
        pub mod triangle {
            pub use crate::statistics::triangle::triangle;
        }
    }
}
