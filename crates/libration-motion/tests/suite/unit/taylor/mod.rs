//! The order of the method.

mod dense_solution;
mod largest_change;
mod layout;
mod owned_step;
mod samples;
mod sign_change;
mod state_names;
mod tangent;

use libration::internals::taylor::{Expander, Surroundings};
use libration::pendulum::Pendulum;
use libration::quantity::Angle;
use libration::taylor::System;
use libration_jit::Compiled;
use libration_kernels::elementary::count;
use std::sync::Arc;

/// The larger error of angle and velocity after three seconds in `steps` equal steps.
fn error_of(steps: u32, order: usize) -> f64 {
    let system = System::new(&"theta'' + sin(theta) = 0".parse().unwrap()).unwrap();
    let expander = Expander::new(&system, order, 1);
    let mut block = expander.block::<1>();
    block.start(0, 0.0, &[1.0, 0.5]);
    let surroundings = Surroundings { parameters: vec![], signs: vec![], sticks: vec![] };
    for n in 1..=steps {
        expander.expand(&mut block, &surroundings);
        block.end = [3.0 * f64::from(n) / f64::from(steps)];
        let ends: Vec<_> = (0..2).map(|number| block.ends(number, &block.lengths())).collect();
        block.begin_at_end(&ends, &[1.0]);
    }
    let state = block.step(0).state_at(3.0);
    let start = Angle::from_radians(1.0).unwrap();
    let exact = Pendulum::from_angular_frequency(1.0).unwrap().launched(start, 0.5).unwrap().state_at(3.0);
    (state[0] - exact.angle).abs().max((state[1] - exact.velocity).abs())
}

#[test]
fn the_measured_order_is_the_nominal_one() {
    for (order, nominal) in [(4, 4.0), (6, 6.0), (8, 8.0), (10, 10.0)] {
        let slope = libm::log2(error_of(12, order) / error_of(24, order));
        assert!((slope - nominal).abs() < 0.3, "order {order}: the error grows as h^{slope}");
    }
}

/// x' = x/7, whose coefficients are 7⁻ⁿ/n!, in three lanes with different starts: divisions below the eighth order, products from the eighth on.
#[test]
fn quotients_by_constants_are_right_at_all_orders() {
    let system = System::new(&"x' = x/7".parse().unwrap()).unwrap();
    let expander = Expander::new(&system, 24, 3);
    let mut block = expander.block::<3>();
    (0..3).for_each(|lane| block.start(lane, 0.0, &[1.0 + count(lane)]));
    expander.expand(&mut block, &Surroundings { parameters: vec![], signs: vec![], sticks: vec![] });
    let mut expected = 1.0;
    for (n, coefficients) in block.series(0).iter().enumerate() {
        expected /= if n == 0 { 1.0 } else { 7.0 * count(n) };
        for (lane, coefficient) in coefficients.iter().enumerate() {
            let computed = coefficient / (1.0 + count(lane));
            assert!(
                (computed / expected - 1.0).abs() < 4e-16 * count(n + 1),
                "{n} {lane}: {computed} {expected}"
            );
        }
    }
    assert!(block.series(0).len() > 20);
}

/// The coefficients without and with machine code.
fn both_ways<const N: usize>(system: &System, order: usize, state: &[f64]) -> Option<[Vec<f64>; 2]> {
    let expander = Expander::new(system, order, N);
    let line = expander.straight_line().unwrap();
    let compiled = Compiled::new(&line, N)?;
    let moduli = system.moduli();
    let surroundings =
        Surroundings { parameters: vec![], signs: vec![[-1.0; N]; moduli], sticks: vec![[false; N]; moduli] };
    let coefficients = |compiled: Option<&Compiled>| {
        let mut block = expander.block::<N>();
        for lane in 0..N {
            let state: Vec<f64> = state.iter().map(|x| x * (1.0 + 0.01 * count(lane))).collect();
            block.start(lane, 0.3, &state);
            block.unit[lane] = 0.5;
        }
        expander.expand_by(&mut block, &surroundings, compiled);
        block.coefficients.numbers().to_vec()
    };
    Some([coefficients(None), coefficients(Some(&compiled))])
}

#[test]
fn machine_code_comes_at_once_where_many_steps_are_expected_and_motions_share_it() {
    let first_code = |system: &System| {
        let expander = Expander::new(system, 20, 1);
        expander.plan.expansion.compiled(|| expander.straight_line()).is_some()
    };
    let system = System::new(&"theta'' + sin(theta) = 0".parse().unwrap()).unwrap();
    assert!(!first_code(&system));
    let system = system.for_many_steps();
    let expected = cfg!(all(target_arch = "x86_64", unix)) && std::is_x86_feature_detected!("fma");
    assert_eq!(first_code(&system), expected);
    let [one, other] = [Expander::new(&system, 20, 1), Expander::new(&system, 20, 1)];
    assert!(Arc::ptr_eq(&one.plan, &other.plan));
    assert!(!Arc::ptr_eq(&one.plan, &Expander::new(&system, 21, 1).plan));
}

/// Values that follow from functions, from functions of functions, and from none.
#[test]
fn zeroth_coefficients_in_machine_code_have_the_bits_of_the_interpreter() {
    let systems = [
        "a'' = -(sin(a-b)*b'^2 + 2*sin(a))/(1 + sin(a-b)^2); b'' = sin(a-b)*a'^2 - sin(b)/3",
        "x'' = exp(-x^2/(1 + y^2))*(x - y)/(x' + 3) - sin(cos(x*y) + 2*y)*x; y'' = y*y'/7 + x/(y - x*y')",
        "x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z",
    ];
    for equations in systems {
        let system = System::new(&equations.parse().unwrap()).unwrap();
        let expander = Expander::new(&system, 8, 1);
        let line = expander.beginning().expect("more than a few operations");
        let state = &[0.7, 1.3, -0.4, 0.9][..system.layout().numbers()];
        let begun = |compiled: Option<&Compiled>| {
            let mut block = expander.block::<1>();
            block.start(0, 0.3, state);
            expander.plan.program.begin(&mut block, compiled);
            block.coefficients.numbers().iter().map(|c| c.to_bits()).collect::<Vec<_>>()
        };
        let interpreted = begun(None);
        assert!(interpreted.iter().filter(|&&bits| bits != 0).count() > 8, "{equations}");
        if let Some(compiled) = Compiled::new(&line, 1) {
            assert_eq!(begun(Some(&compiled)), interpreted, "{equations}");
        }
    }
}

/// Every operation of a tape, at orders with few and with many terms.
#[test]
fn machine_code_gives_the_bits_of_the_interpreter() {
    let systems = [
        "theta'' + theta'/10 + sin(theta) = 1.2*cos(2*t/3)",
        "a'' = -(sin(a-b)*b'^2 + 2*sin(a))/(1 + sin(a-b)^2); b'' = sin(a-b)*a'^2 - sin(b)",
        "x'' = -x*abs(x) - sign(x')/5; y'' = -y^1.5/(1 + x^2) + 1/y",
        "x'' = exp(-x^2) - tan(x/3) + tanh(x); y'' = ln(2 + x^2)*atan(y) - sinh(y)/cosh(x) + sqrt(1 + y^2)",
        "x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z",
        "x'' = asin(x/5) - acos(y/5) + pi*t^2; y'' = (x + t)^(1/3)",
    ];
    let mut compared = 0;
    for equations in systems {
        let system = System::new(&equations.parse().unwrap()).unwrap();
        let state = &[0.7, 1.3, -0.4, 0.9][..system.layout().numbers()];
        for order in [2, 7, 16, 31, 39] {
            let both = [both_ways::<1>(&system, order, state), both_ways::<8>(&system, order, state)];
            for [interpreted, compiled] in both.into_iter().flatten() {
                let same = interpreted.iter().zip(&compiled).all(|(a, b)| a.to_bits() == b.to_bits());
                assert!(same && interpreted.iter().all(|c| c.is_finite()), "{equations} {order}");
                compared += 1;
            }
        }
    }
    let expected = cfg!(all(target_arch = "x86_64", unix)) && std::is_x86_feature_detected!("fma");
    assert!(!expected || compared == 60, "{compared}");
}
