//! The pendulum at any amplitude: its exact period, motion and harmonics, and the published formulas for its
//! period, each with its exact error. From there any nonlinear oscillator, and any system of equations of motion.
//!
//! Angles are radians from the downward vertical, times seconds, lengths metres.
//!
//! # Terms
//! A **libration** swings to and fro below the top, a **rotation** passes over it in one direction, and the motion on
//! the **separatrix** between them approaches the top for ever. The **amplitude** of a libration is its largest angle.
//! Near the top the **complement** π − |θ| is the number that matters, so an [`Angle`](quantity::Angle) carries it
//! together with the angle: a release from `pi-1e-300` is described as well as one from `60deg`. The **small-angle
//! period** is 2π√(l/g).
//!
//! An **oscillator** is one equation of the second order about an **equilibrium**, a **system** any number of equations
//! of motion, of the first or the second order. A **perturbation series** expands the periodic motions of an oscillator
//! in a parameter that its **gauge** defines; the **slow flow** gives the rates of amplitude and phase under weak damping
//! or excitation. A **periodic orbit** is stable where its **Floquet multipliers** are inside the unit circle. A
//! **branch** is a family of periodic orbits over a parameter; its bifurcations are **special points**.
//!
//! # The pendulum
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
//! // The same period by perturbation theory, without elliptic functions: exact fractions.
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
//! # Tasks
//!
//! | module | tasks | begin with |
//! |---|---|---|
//! | [`pendulum`] | period, motion in every regime, energy, action, harmonics; batches | [`Pendulum`](pendulum::Pendulum), [`period`](pendulum::period()), [`periods`](pendulum::periods()) |
//! | [`period_formulas`] | published formulas for the period: exact errors, crossovers | [`PeriodFormula`](period_formulas::PeriodFormula) |
//! | [`decay`] | amplitude of a damped pendulum: integrated, averaged, for small amplitudes | [`Decay`](decay::Decay) |
//! | [`oscillator`] | an equation of motion about its equilibrium; the catalogue | [`Oscillator`](oscillator::Oscillator), [`NamedOscillator`](oscillator::NamedOscillator) |
//! | [`perturbation`] | exact series of frequency, harmonics and period; slow flow | [`expand`](perturbation::expand()), [`slow_flow`](perturbation::slow_flow()) |
//! | [`comparison`] | such a series compared with exact values; frequency against amplitude | [`SeriesComparison`](comparison::SeriesComparison), [`Backbone`](comparison::Backbone) |
//! | [`systems`] | named systems with energies and units, and typed equations | [`NamedSystem`](systems::NamedSystem), [`Model`](systems::Model) |
//! | [`taylor`] | motion of any system in time, with events, errors and sensitivities | [`System`](taylor::System), [`integrate`](taylor::integrate()) |
//! | [`orbit`] | periodic orbits: period, harmonics, Floquet multipliers | [`Orbit`](orbit::Orbit) |
//! | [`spectrum`] | frequencies of a motion and their amplitudes | [`Spectrum`](spectrum::Spectrum) |
//! | [`chaos`] | Poincaré sections, bifurcation diagrams, Lyapunov exponents | [`compute_section`](chaos::compute_section), [`lyapunov_exponent`](chaos::lyapunov_exponent) |
//! | [`continuation`] | branches of periodic orbits over a parameter: folds, jumps, stability | [`Response`](continuation::Response), [`StabilityChart`](continuation::StabilityChart) |
//! | [`melnikov`] | thresholds of chaos of a weakly perturbed pendulum; resonances | [`PerturbedPendulum`](melnikov::PerturbedPendulum), [`Melnikov`](melnikov::Melnikov) |
//! | [`normal_modes`] | small oscillations of coupled systems, exact where possible | [`NormalModes`](normal_modes::NormalModes) |
//! | [`nonlinear_modes`] | these modes continued to large amplitudes | [`NonlinearMode`](nonlinear_modes::NonlinearMode) |
//! | [`normal_form`] | slow flow of coupled modes: resonances, exchange of energy | [`NormalForm`](normal_form::NormalForm) |
//! | [`quantity`] | exact values of `60deg`, `pi-1e-6`, `1.200(3) m`, `1deg:179deg:1deg` | [`Angle`](quantity::Angle), [`Quantity`](quantity::Quantity) |
//! | [`expression`] | formulas and equations of motion from text | [`Equation`](expression::Equation), [`Expression`](expression::Expression) |
//! | [`catalogue`] | keys of oscillators, systems and formulas | [`by_key`](catalogue::by_key) |
//! | [`progress`] | progress and cancellation of long calls | [`Progress`](progress::Progress) |
//! | [`elliptic`] | K, E, F; sn, cn, dn, am; the nome; by the modulus and its complement | [`Modulus`](elliptic::Modulus), [`Jacobi`](elliptic::Jacobi) |
//! | [`algebra`] | exact rationals, floats of any precision, polynomials, and their rings | [`Rational`](algebra::Rational), [`BigFloat`](algebra::BigFloat) |
//! | [`series`] | truncated power series over any ring | [`PowerSeries`](series::PowerSeries) |
//! | [`roots`] | zeros of functions and polynomials from a bracket | [`zero_between`](roots::zero_between) |
//! | [`quadrature`] | integrals of functions of one variable, with error estimates | [`gauss_kronrod`](quadrature::gauss_kronrod) |
//!
//! # Types that hold equations of motion
//!
//! | type | holds | used by |
//! |---|---|---|
//! | [`Equation`](expression::Equation) | equations as typed, parameters with or without values | [`orbit`], [`continuation`], [`chaos`], [`normal_modes`]; the others are made from it |
//! | [`Model`](systems::Model) | the same with units, energies and a start by name | the choice of a named system |
//! | [`System`](taylor::System) | the program that computes Taylor coefficients | [`taylor`] |
//! | [`Oscillator`](oscillator::Oscillator) | one equation about its equilibrium, with numbers | [`perturbation`], [`comparison`] |
//! | [`SymbolicOscillator`](oscillator::SymbolicOscillator) | the same with symbols | [`expand_symbolically`](perturbation::expand_symbolically) |
//! | [`PerturbedPendulum`](melnikov::PerturbedPendulum) | a pendulum and its small perturbation | [`melnikov`] |
//!
//! # Any system of equations
//! A motion in time, a limit cycle, and a branch of a driven pendulum through its folds:
//!
//! ```
//! use libration::continuation::{Response, ResponseOptions, SpecialKind};
//! use libration::orbit::Orbit;
//! use libration::progress::Quiet;
//! use libration::taylor::{Effort, System, integrate};
//!
//! let system = System::new(&"theta'' + theta'/10 + sin(theta) = 0".parse()?)?;
//! let start = system.start(&[("theta", 2.0)])?;
//! let solution = integrate(&system, &start, &[5.0, 10.0], &Effort::to_tolerance(1e-15), &Quiet)?;
//! assert_eq!(solution.samples.len(), 2);
//!
//! let cycle = Orbit::limit_cycle(&"x'' - (1 - x^2) x' + x = 0".parse()?, &[0.5, 0.0], &Quiet)?;
//! assert!((cycle.period() - 6.6632868593231301896996820).abs() < 1e-12);
//!
//! let driven = "theta'' = -0.1*theta' - sin(theta) + 0.15*cos(w*t)".parse()?;
//! let response = Response::over(&driven, "w", [0.3, 1.4], &ResponseOptions::default(), &Quiet)?;
//! let fold = response.branches[0].special.iter().find(|special| special.kind == SpecialKind::Fold);
//! assert!((fold.ok_or("no fold")?.point.parameter - 0.87215756913791717).abs() < 1e-13);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Errors
//! Functions of numbers return NaN outside their documented domain. Constructors check their arguments once, and return an
//! error that states the value received, the reason, and what would work. Each activity has its own error type, such as
//! [`PendulumError`](pendulum::PendulumError) or [`OrbitError`](orbit::OrbitError).
//!
//! # Keys
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
//! # Cancellation
//! Calls that may take long have a [`Progress`](progress::Progress) as their last argument, such as a function that cancels them, or
//! [`Quiet`](progress::Quiet). A cancelled call returns what is done:
//!
//! ```
//! use libration::chaos::{Points, Section, compute_section};
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
//! let found = compute_section(&duffing, &start, &stroboscope, points, &Effort::to_tolerance(1e-9), &ten_points)?;
//! assert_eq!(found.points.len(), 10);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Accuracy
//! The documentation of each function states its accuracy, which is tested: an error bound in units in the last place for
//! functions of numbers, an uncertainty with each result of an iteration. Results are the same bits on every platform, and
//! each batch equals its scalar function bit for bit. The library reads no files, prints nothing and uses no clock.

// In reading order.
#[doc(inline)]
pub use libration_branches::{continuation, melnikov, nonlinear_modes, normal_form, normal_modes};
#[doc(inline)]
pub use libration_kernels::elliptic;
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
    pub use libration_kernels::fused::rounds_once;
    pub use libration_numbers::internals::algebra::InOrder;
    pub use libration_numbers::internals::progress;
}
