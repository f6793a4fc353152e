//! The corrections against a pendulum of many point masses, and against integration.

mod combined;
mod corrections;
mod derivative;

use std::f64::consts::TAU;

use libration::progress::Quiet;
use libration::quantity::Quantity;
use libration::taylor::{Direction, Effort, Event, Moment, System, integrate};
use libration_lab::fit::{
    Apparatus, Bob, Budget, BudgetError, Correction, Corrections, MeasuredPeriod, PeriodDamping,
};

const G: f64 = 9.81;

fn exactly(value: f64) -> Quantity {
    Quantity { value, uncertainty: None }
}

fn about(value: f64, uncertainty: f64) -> Quantity {
    Quantity { value, uncertainty: Some(uncertainty) }
}

/// A pendulum of this length with corrections.
fn with(length: Quantity, change: impl FnOnce(&mut Corrections)) -> Apparatus {
    let mut apparatus = Apparatus::of_length(length);
    change(&mut apparatus.corrections);
    apparatus
}

/// The budget with independent inputs.
fn budget(apparatus: &Apparatus, period: &MeasuredPeriod) -> Result<Budget, BudgetError> {
    libration_lab::fit::evaluate_budget(apparatus, period, &[])
}

fn small_swings(t0: f64) -> MeasuredPeriod {
    MeasuredPeriod::of_small_swings(exactly(t0))
}

/// Moment of inertia and static moment of masses at points, about the pivot.
fn moments(points: impl Iterator<Item = (f64, [f64; 2])>) -> (f64, f64) {
    points.fold((0.0, 0.0), |(inertia, torque), (mass, [x, y])| {
        (inertia + mass * (x * x + y * y), torque + mass * y)
    })
}

/// A ball cut into rings of a mass each, at their mean distance from the axis of the swing.
fn ball(mass: f64, radius: f64, length: f64) -> Vec<(f64, [f64; 2])> {
    let cells = 200;
    let mut points = vec![];
    for i in 0..cells {
        for j in 0..cells {
            let coordinate = |k: i32| (2.0 * f64::from(k) + 1.0) / f64::from(cells) - 1.0;
            let (x, y) = (coordinate(i), coordinate(j));
            // The chord along the axis of the swing.
            let chord = (1.0 - x * x - y * y).max(0.0).sqrt();
            points.push((chord, [radius * x, length + radius * y]));
        }
    }
    let sum: f64 = points.iter().map(|point| point.0).sum();
    points.into_iter().map(|(weight, position)| (mass * weight / sum, position)).collect()
}

#[test]
fn a_ball_on_a_rod_in_air_gives_its_g_back() {
    let (length, radius, mass, rod) = (0.6, 0.05, 0.2, 0.03);
    let rod_points = (0..1000).map(|k| {
        let part = (f64::from(k) + 0.5) / 1000.0;
        (rod / 1000.0, [0.0, part * (length - radius)])
    });
    let (inertia, torque) = moments(ball(mass, radius, length).into_iter().chain(rod_points));
    let volume = 4.0 / 3.0 * std::f64::consts::PI * radius * radius * radius;
    let air = 1.2 * volume;
    // Half the displaced air moves along, and a layer of 9δ/4r; the displaced air carries.
    let t0_in =
        |added: f64| TAU * ((inertia + added * air * length * length) / ((torque - air * length) * G)).sqrt();
    let layer = |t0: f64| (2.0 * 1.51e-5 * t0 / TAU).sqrt();
    let t0 = (0..20).fold(t0_in(0.5), |t0, _| t0_in(0.5 + 2.25 * layer(t0) / radius));
    let apparatus = Corrections {
        bob: Some(Bob::ball(exactly(radius))),
        bob_mass: Some(exactly(mass)),
        rod_mass: Some(exactly(rod)),
        ..Corrections::default()
    };
    let apparatus = Apparatus { length: exactly(length), corrections: apparatus };
    let corrected = budget(&apparatus, &small_swings(t0)).unwrap();
    // The cells of the ball are 1e-4 of it coarse.
    assert!((corrected.g / G - 1.0).abs() < 2e-5, "{}", corrected.g);
    let bare = budget(&Apparatus::of_length(exactly(length)), &small_swings(t0)).unwrap();
    assert!((bare.g / G - 1.0).abs() > 5e-3);
}

/// The time between two passages of the bottom in one direction.
fn period_of(equations: &str, state: &[f64], angle: &str) -> f64 {
    let system = System::new(&equations.parse().unwrap()).unwrap();
    let event = Event { formula: angle.parse().unwrap(), direction: Direction::Rising, ends_at: None };
    let system = system.with_events(&[event]).unwrap();
    let start = Moment { time: 0.0, state: state.to_vec() };
    let solution = integrate(&system, &start, &[20.0], &Effort::to_tolerance(1e-13), &Quiet).unwrap();
    solution.events[1].time - solution.events[0].time
}

#[test]
fn a_string_that_stretches_swings_more_slowly_by_eleven_sixteenths_of_the_square() {
    let (length, stretch, amplitude): (f64, f64, f64) = (1.0, 1e-3, 0.3);
    let kappa = G / stretch;
    let equations = format!(
        "r'' = r*theta'^2 + {G}*cos(theta) - {kappa:e}*(r - {:e}); theta'' = -(2*r'*theta' + {G}*sin(theta))/r",
        length - stretch
    );
    // As long as the bob pulls where it is released, so that the string hardly vibrates.
    let released = length - stretch + stretch * libm::cos(amplitude);
    let period = period_of(&equations, &[released, amplitude, 0.0, 0.0], "theta");
    let t0 = period / libration::pendulum::period_ratio(amplitude);
    let apparatus = with(exactly(length), |apparatus| apparatus.stretch = Some(exactly(stretch)));
    let measured = MeasuredPeriod { amplitude: Some(amplitude), ..small_swings(t0) };
    let (with, without) = (budget(&apparatus, &measured).unwrap(), small_swings(t0));
    let without = budget(&Apparatus::of_length(exactly(length)), &without).unwrap();
    let (error, uncorrected) = ((with.g / G - 1.0).abs(), (without.g / G - 1.0).abs());
    assert!(uncorrected > 1e-4 && error < 0.1 * uncorrected, "{error:e} {uncorrected:e}");
}

#[test]
fn damping_makes_the_period_longer_in_second_order() {
    let (length, damping) = (1.0, 0.3);
    let equation = format!("x'' = -{:e}*x - {damping}*x'", G / length);
    let t0 = period_of(&equation, &[0.1, 0.0], "x");
    let measured = MeasuredPeriod { damping: PeriodDamping::Contained(exactly(damping)), ..small_swings(t0) };
    let budget = budget(&Apparatus::of_length(exactly(length)), &measured).unwrap();
    assert!((budget.g / G - 1.0).abs() < 1e-6, "{}", budget.g);
}

#[test]
fn contributions_are_derivatives_times_uncertainties() {
    let apparatus = with(about(1.0, 0.002), |apparatus| {
        apparatus.bob = Some(Bob::ball(about(0.02, 0.001)));
        apparatus.bob_density = Some(exactly(8000.0));
    });
    let amplitude = 0.5;
    let measured = MeasuredPeriod {
        t0: about(2.006, 0.001),
        amplitude: Some(amplitude),
        angle_scale: Some(0.02),
        ..small_swings(2.006)
    };
    let budget = budget(&apparatus, &measured).unwrap();
    let of = |name: &str| budget.rows.iter().find(|row| row.name == name).unwrap().uncertainty.unwrap();
    let close = |got: f64, wanted: f64| (got / wanted - 1.0).abs() < 0.01;
    assert!(close(of("length"), budget.g * 0.002), "{budget:?}");
    assert!(close(of("timing"), budget.g * 2.0 * 0.001 / 2.006));
    // R = 1 + A²/16 + 11A⁴/3072: dR/dA·A/R.
    let square: f64 = amplitude * amplitude;
    let ratio = 1.0 + square / 16.0 + 11.0 / 3072.0 * square * square;
    let slope = (square / 8.0 + 44.0 / 3072.0 * square * square) / ratio;
    assert!(close(of("angle scale"), budget.g * 2.0 * slope * 0.02));
    assert!(close(of("finite bob"), budget.g * 0.8 * 0.02 * 0.001));
    let squares: f64 = budget.rows.iter().filter_map(|row| row.uncertainty).map(|u| u * u).sum();
    assert!(close(budget.uncertainty, squares.sqrt()), "{} {}", budget.uncertainty, squares.sqrt());
}

#[test]
fn what_is_not_given_is_not_corrected_and_said() {
    let budget = budget(&Apparatus::of_length(exactly(1.0)), &small_swings(2.0)).unwrap();
    let of = |name: &str| budget.rows.iter().find(|row| row.name == name).unwrap().correction;
    assert!((budget.g - TAU * TAU / 4.0).abs() < 1e-14);
    assert!(matches!(of("buoyancy"), Correction::Typical(size) if size > 1e-4 && size < 2e-4));
    assert!(matches!(of("rod mass"), Correction::Typical(size) if size < -1e-3));
    assert_eq!(of("finite amplitude"), Correction::Unknown);
}

#[test]
fn what_cannot_be_is_refused() {
    let refused = |apparatus: Apparatus, t0: f64| budget(&apparatus, &small_swings(t0)).unwrap_err();
    let plain = Apparatus::of_length(exactly(1.0));
    assert_eq!(refused(plain, -2.0), BudgetError::NotPositive { name: "period", value: -2.0 });
    let huge = with(exactly(1.0), |apparatus| apparatus.bob = Some(Bob::ball(exactly(2.0))));
    assert_eq!(refused(huge, 2.0), BudgetError::BobTooLarge { radius: 2.0, length: 1.0 });
    let rod = with(exactly(1.0), |apparatus| apparatus.rod_mass = Some(exactly(0.1)));
    assert_eq!(refused(rod, 2.0), BudgetError::RodWithoutBob);
    let balloon = with(exactly(1.0), |apparatus| apparatus.bob_density = Some(exactly(1.0)));
    assert_eq!(refused(balloon, 2.0), BudgetError::BobTooLight);
    let vague = Apparatus { length: about(1.0, -1.0), ..plain };
    assert_eq!(refused(vague, 2.0), BudgetError::Uncertainty { name: "length", value: -1.0 });
}
