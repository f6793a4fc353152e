//! The pendulum at any amplitude: its exact period, motion and harmonics, and the published formulas for its
//! period, each with its exact error. From there any nonlinear oscillator.
//!
//! Angles are radians from the downward vertical, times seconds, lengths metres. Near the top the distance
//! π − θ is the number that matters, so an [`Angle`](quantity::Angle) carries it beside the angle: released
//! from `pi-1e-300` a pendulum is as well described as from `60deg`.
//!
//! ```
//! use libration::pendulum::{Pendulum, Regime};
//! use libration::period_formulas::PeriodFormula;
//! use libration::progress::Quiet;
//! use libration::quantity::Angle;
//!
//! // A pendulum of 1 m released at rest from 60°: its exact period is 7 % above that of small swings.
//! let pendulum = Pendulum::new(1.0, 9.80665)?;
//! let amplitude: Angle = "60deg".parse()?;
//! let motion = pendulum.released_from(amplitude)?;
//! assert_eq!(motion.regime(), Regime::Libration);
//! assert!((motion.period() - 2.1532423517838).abs() < 1e-12);
//! assert!((motion.period() / pendulum.small_angle_period() - 1.0731820071493).abs() < 1e-12);
//!
//! // Its angle and velocity at any time; half a period later it is on the other side.
//! let opposite = motion.state_at(0.5 * motion.period());
//! assert!((opposite.angle + amplitude.radians()).abs() < 1e-14);
//!
//! // θ(t) = Σ aₙ cos nΩt over odd n: the third harmonic is 0.6 % of the first.
//! let harmonics = motion.harmonics(1e-6, 10);
//! assert_eq!(harmonics.terms[1].n, 3);
//! assert!((harmonics.terms[1].angle / harmonics.terms[0].angle + 0.0061).abs() < 1e-4);
//!
//! // Bernoulli's 1 + θ0²/16 falls short of the exact period by 0.43 %.
//! let bernoulli = PeriodFormula::by_key("bernoulli")?;
//! assert!((bernoulli.fractional_error(&amplitude) + 0.00433).abs() < 1e-5);
//!
//! // The same period by perturbation theory, which knows nothing of elliptic functions: exact fractions.
//! use libration::oscillator::Oscillator;
//! use libration::perturbation::{Gauge, expand};
//! let oscillator = Oscillator::new(&"theta'' + sin(theta) = 0".parse()?)?;
//! let series = expand(&oscillator, 41, &Gauge::Fundamental, &Quiet)?.of_amplitude.ok_or("no amplitude")?;
//! let ratio = series.period_ratio.iter().rev().fold(0.0, |sum, c| sum * amplitude.radians() + c.to_f64());
//! assert_eq!(series.period_ratio[4].to_string(), "11/3072");
//! assert!((ratio - 1.0731820071493).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | module | answers |
//! |---|---|
//! | [`quantity`] | what `60deg`, `pi-1e-6`, `1.200(3) m` and `1deg:179deg:1deg` mean, exactly |
//! | [`catalogue`] | what can be asked for by name |
//! | [`elliptic`] | K, E, F; sn, cn, dn, am; the nome; the complement beside the modulus |
//! | [`pendulum`] | period, motion in every regime, energy, action, harmonics; single values and batches |
//! | [`period_formulas`] | the formulas of the literature, their exact errors, where one overtakes another |
//! | [`algebra`] | exact rationals, floats of any precision, polynomials in named variables, and the rings of all of them |
//! | [`roots`] | where a condition ends or a function vanishes, from a bracket |
//! | [`quadrature`] | integrals of functions of one variable, each with what it misses |
//! | [`series`] | truncated power series over any ring |
//! | [`expression`] | formulas and equations of motion as text, tree and tape |
//! | [`progress`] | progress and cancellation of long calls |
//! | [`oscillator`] | an equation of motion about its equilibrium; the catalogue |
//! | [`perturbation`] | exact series of any oscillator's frequency, harmonics and period |
//! | [`comparison`] | those series beside exact values |
//! | [`taylor`] | the motion of any system of equations in time |
//! | [`systems`] | named systems with energies and units, and equations as typed, ready to be integrated |
//! | [`orbit`] | periodic orbits of any equations of motion: period, harmonics, stability |
//! | [`spectrum`] | how much of each frequency is in a motion |
//! | [`normal_modes`] | small oscillations of coupled systems, exactly where possible, and how they change with the amplitude |
//! | [`decay`] | how the amplitude of a damped pendulum falls: averaged, for small amplitudes, integrated |
//! | [`chaos`] | whether a motion is regular or chaotic: Poincaré sections, bifurcation diagrams, Lyapunov exponents |
//!
//! Oscillators, systems and formulas have keys; an unknown one is an error that names the nearest:
//!
//! ```
//! use libration::oscillator::NamedOscillator;
//! use libration::period_formulas::PeriodFormula;
//! use libration::systems::NamedSystem;
//! assert_eq!(NamedOscillator::by_key("duffing")?.key, "duffing");
//! assert_eq!(NamedSystem::by_key("dufing").unwrap_err().kind, "system");
//! let unknown = PeriodFormula::by_key("molino").unwrap_err();
//! assert_eq!(unknown.near[0], "molina");
//! assert!(unknown.known.iter().any(|key| key == "bernoulli"));
//! # Ok::<(), libration::catalogue::UnknownKey>(())
//! ```
//!
//! Calls that may take long have a [`Progress`](progress::Progress) as their last argument, such as a function that cancels them, or
//! [`Quiet`](progress::Quiet). A cancelled call returns what is done:
//!
//! ```
//! use libration::chaos::{Points, Section, section};
//! use libration::progress::Status;
//! use libration::taylor::{Effort, Moment};
//! use std::ops::ControlFlow;
//! let duffing = "x'' + x'/4 - x + x^3 = 0.3*cos(t)".parse()?;
//! let start = Moment { time: 0.0, state: vec![1.0, 0.0] };
//! let stroboscope = Section::Stroboscope { period: None, phase: 0.0 };
//! let points = Points { skipped: 0, recorded: 1000 };
//! let ten_points = |status: Status| match status.done {
//!     10.. => ControlFlow::Break(()),
//!     _ => ControlFlow::Continue(()),
//! };
//! let found = section(&duffing, &start, &stroboscope, points, &Effort::to_tolerance(1e-9), &ten_points)?;
//! assert_eq!(found.points.len(), 10);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The library reads no files, prints nothing and knows no clock. Functions of numbers return NaN outside
//! their documented domain; constructors check their arguments once and return an error that says what was
//! got and what would do. Results are the same bits on every platform, and each batch equals its own scalar
//! function bit for bit. What each function promises of its accuracy stands in its documentation and is
//! tested.

// In reading order.
#[doc(inline)]
pub use libration_branches::{continuation, melnikov, nonlinear_modes, normal_form, normal_modes};
#[doc(inline)]
pub use libration_kernels::{elliptic, fused::rounds_once};
#[doc(inline)]
pub use libration_motion::{chaos, decay, orbit, oscillator, spectrum, systems, taylor};
#[doc(inline)]
pub use libration_numbers::{algebra, catalogue, expression, progress, quadrature, quantity, roots, series};
#[doc(inline)]
pub use libration_pendulum::{pendulum, period_formulas};
#[doc(inline)]
pub use libration_perturbation::{comparison, perturbation};

/// Internals that the other crates of this workspace use. They may change at any time.
#[doc(hidden)]
pub mod internals {
    pub use libration_numbers::internals::progress;
}
