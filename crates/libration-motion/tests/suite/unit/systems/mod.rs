//! The equations of the named systems compared with an independent derivation from point masses in space and Lagrange's equations.

mod mechanisms;

use libration::catalogue::Named;
use libration::expression::{Expression, Symbol};
use libration::systems::{Energy, EnergyError, Model, ModelError, NamedSystem, catalogue};
use libration::taylor::Moment;
use mechanisms::{BOB, MECHANISMS, Numbers, Open, formula, sum};

const TRIALS: u32 = 20;

#[test]
fn every_system_obeys_lagranges_equations_of_its_masses() {
    let mut systems = Open::mechanical();
    for mechanism in MECHANISMS {
        let system = systems.next().unwrap();
        assert_eq!(system.named.key, mechanism.key);
        let potential = Expression::Negate(Box::new(mechanism.potential_energy()));
        let lagrangian = sum([mechanism.kinetic_energy(&system), potential]);
        for (coordinate, force) in system.places().zip(mechanism.forces) {
            let momentum_rate = system.rate(&lagrangian.derivative(&coordinate.with_primes(1)));
            let slope = lagrangian.derivative(&coordinate);
            for trial in 0..TRIALS {
                let numbers = system.numbers(trial);
                let [rate, slope, force] =
                    [&momentum_rate, &slope, &formula(force)].map(|term| numbers.value(term));
                let size = rate.abs() + slope.abs() + force.abs();
                assert!(
                    (rate - slope - force).abs() < 1e-14 * (1.0 + size),
                    "{} {coordinate}: {rate} {slope} {force}",
                    mechanism.key
                );
            }
        }
    }
    assert!(systems.next().is_none(), "a system has no mechanism here");
}

#[test]
fn bodies_are_where_the_masses_are_on_rods_of_one_length() {
    for (system, mechanism) in Open::mechanical().zip(MECHANISMS) {
        if system.named.bodies.is_empty() {
            assert!(system.model.bodies().is_none());
            continue;
        }
        // The body is represented by its centre of mass, at the distance one.
        let masses = if system.named.key == "physical_pendulum" { BOB } else { mechanism.masses };
        assert_eq!(system.named.bodies.len(), masses.len(), "{}", system.named.key);
        for (body, [_, _, x, y, z]) in system.named.bodies.iter().zip(masses) {
            let lengths = (0..TRIALS).map(|trial| {
                let numbers = system.numbers(trial);
                let value = |text: &str| numbers.value(&formula(text));
                let position = body.place.map(value);
                assert_eq!(
                    position.map(f64::to_bits),
                    [value(x), value(z)].map(f64::to_bits),
                    "{}",
                    system.named.key
                );
                let held = body.pivot.map(value);
                let length = libm::hypot(libm::hypot(position[0] - held[0], position[1] - held[1]), value(y));
                let names = ["r", "l", "l1", "l2"].map(Symbol::plain);
                (length, names.map(|name| numbers.0.get(&name).copied()))
            });
            for (length, [r, l, l1, l2]) in lengths {
                let is_upper = body.pivot == ["0", "0"];
                let rod = r.or(if is_upper { l1 } else { l2 }).or(l).unwrap_or(1.0);
                assert!((length - rod).abs() < 1e-15, "{}: {length} {rod}", system.named.key);
            }
        }
    }
}

#[test]
fn every_energy_is_that_of_the_masses() {
    for (mechanism, system) in
        MECHANISMS.iter().zip(Open::mechanical()).filter(|(mechanism, _)| !mechanism.pivot_moves())
    {
        if system.named.energy.is_empty() {
            continue;
        }
        let stated = formula(system.named.energy);
        let sum = sum([mechanism.kinetic_energy(&system), mechanism.potential_energy()]);
        for trial in 0..TRIALS {
            let numbers = system.numbers(trial);
            // The zero of the potential is arbitrary.
            let mut resting = system.numbers(trial);
            for coordinate in system.places() {
                resting.0.insert(coordinate.with_primes(1), 0.0);
                resting.0.insert(coordinate, 0.5);
            }
            let change = |energy: &Expression| numbers.value(energy) - resting.value(energy);
            assert!(
                (change(&stated) - change(&sum)).abs() < 1e-14,
                "{}: {} {}",
                mechanism.key,
                change(&stated),
                change(&sum)
            );
        }
    }
}

#[test]
fn every_energy_changes_by_its_power() {
    for system in Open::with_energy() {
        let rate = system.rate(&formula(system.named.energy));
        let power = formula(system.named.power);
        for trial in 0..TRIALS {
            let numbers = system.numbers(trial);
            let (rate, power) = (numbers.value(&rate), numbers.value(&power));
            assert!((rate - power).abs() < 1e-13, "{}: {rate} {power}", system.named.key);
        }
    }
}

/// Systems that have no state at rest by default.
const RESTLESS: [&str; 2] = ["spherical_pendulum", "kepler"];

#[test]
fn defaults_leave_out_damping_and_driving_and_rest_is_at_rest() {
    for named in catalogue() {
        let model = Model::named(named, &[], &[]).unwrap();
        assert!(model.open_parameters().is_empty(), "{}", named.key);
        let names = model.state_names().into_iter().map(|name| match formula(&name) {
            Expression::Symbol(symbol) => symbol,
            other => panic!("{other}"),
        });
        let mut numbers = Numbers(names.zip(model.state_at_rest()).collect());
        numbers.0.insert(Symbol::plain("t"), 0.7);
        for acceleration in model.equation().derivatives() {
            // The two angles have no equilibrium at the lowest point, and a planet has none.
            let at_rest = numbers.value(acceleration).abs() < 1e-15 || RESTLESS.contains(&named.key);
            assert!(at_rest, "{}: {acceleration}", named.key);
        }
        if !model.layout().is_of_second_order() {
            continue;
        }
        let (energy, start) = (model.energy().unwrap(), Moment { time: 0.0, state: model.state_at_rest() });
        assert!(energy.drift(&start, &start) == 0.0 || named.key == "spherical_pendulum", "{}", named.key);
    }
}

fn energy_of(equations: &str) -> Result<Energy, EnergyError> {
    Model::typed(equations, &[], &[]).unwrap().energy()
}

#[test]
fn only_forces_with_a_potential_have_an_energy() {
    for equations in
        ["x'' = -x^3", "x'' = -sin(x - y); y'' = sin(x - y)", "x'' = -y*exp(x*y); y'' = -x*exp(x*y)"]
    {
        assert!(energy_of(equations).is_ok(), "{equations}");
    }
    assert!(matches!(energy_of("x'' = -y; y'' = x"), Err(EnergyError::Curl { .. })));
    assert!(matches!(energy_of("x'' = -x - 0.1 x'"), Err(EnergyError::NotOfPlace { .. })));
    assert!(matches!(energy_of("x'' = -x + cos(t)"), Err(EnergyError::NotOfPlace { .. })));
    assert!(matches!(energy_of("x'' = -k*x"), Err(EnergyError::WithoutValue(_))));
    let damped = Model::by_key("damped_pendulum", &[("c", formula("0.1"))], &[]).unwrap();
    assert!(matches!(damped.energy(), Err(EnergyError::NotConserved { .. })));
}

#[test]
fn a_mass_that_is_not_positive_counts_as_one() {
    // −x″ = x³ and x″ = −x³ are the same motion; a negative kinetic energy would be no measure of the drift.
    for equation in ["-x'' = x^3", "x'' = -x^3", "-2*x'' = 2*x^3"] {
        let energy = Model::typed(equation, &[], &[]).unwrap().energy().unwrap();
        let mut balance = energy.balance(&Moment { time: 0.0, state: vec![1.0, 0.0] });
        balance.record(&Moment { time: 1.0, state: vec![0.0, -0.5_f64.sqrt()] });
        assert!(balance.account().largest_kinetic > 0.2 && balance.drift() < 1e-15, "{equation}");
    }
}

#[test]
fn the_form_of_damping_follows_its_power() {
    let equation = |n: &str| {
        let values = [("c", formula("0.1")), ("n", formula(n))];
        Model::by_key("damped_pendulum", &values, &[]).unwrap().equation().to_string()
    };
    assert_eq!(equation("0"), "theta'' + 0.1*sign(theta') + sin(theta) = 0");
    assert_eq!(equation("1"), "theta'' + 0.1*theta' + sin(theta) = 0");
    assert_eq!(equation("2"), "theta'' + 0.1*(theta'*abs(theta')) + sin(theta) = 0");
    assert_eq!(equation("3"), "theta'' + 0.1*theta'^3 + sin(theta) = 0");
    assert_eq!(equation("4"), "theta'' + 0.1*(theta'^3*abs(theta')) + sin(theta) = 0");
    assert_eq!(equation("1.5"), "theta'' + 0.1*(abs(theta')^1.5*sign(theta')) + sin(theta) = 0");
    let of = |key: &str, n: &str| Model::by_key(key, &[("c", formula("0.1")), ("n", formula(n))], &[]);
    assert!(of("damped_pendulum", "pi").is_ok());
    assert!(matches!(of("damped_pendulum", "-1"), Err(ModelError::NegativePower { .. })));
    assert!(matches!(of("damped_pendulum_54", "-1"), Err(ModelError::NegativePower { .. })));
    assert!(matches!(of("damped_pendulum_54", "1.5"), Err(ModelError::NotWhole { .. })));
}

#[test]
fn a_chain_has_as_many_masses_as_are_counted() {
    let chain = |n: &str| Model::by_key("fput", &[("n", formula(n)), ("beta", formula("1/2"))], &[]);
    let three = chain("3").unwrap();
    assert_eq!(three.state_names(), ["x1", "x2", "x3", "x1'", "x2'", "x3'"]);
    assert_eq!(three.value_of("n"), Some(3.0));
    assert_eq!(Model::by_key("fput", &[], &[]).unwrap().coordinates().len(), 32);
    for n in ["0", "2.5", "1001", "-3", "pi"] {
        assert!(matches!(chain(n), Err(ModelError::NotACount { .. })), "{n}");
    }
    assert!(Model::by_key("fput", &[], &["n"]).is_err());
    assert!(three.energy().is_ok());
}

#[test]
fn keys_are_unique_also_among_the_oscillators() {
    let mut seen = std::collections::BTreeSet::new();
    for key in catalogue().flat_map(NamedSystem::keys) {
        assert!(seen.insert(key), "{key}");
    }
    for oscillator in libration::oscillator::catalogue() {
        let model = Model::by_key(oscillator.key, &[], &[]).unwrap();
        assert!(model.open_parameters().is_empty() && model.coordinates().len() == 1, "{}", oscillator.key);
    }
    let well = Model::by_key("double_well", &[], &[]).unwrap();
    assert_eq!(well.state_at_rest(), [1.0, 0.0]);
    assert!(matches!(Model::by_key("penduum", &[], &[]), Err(ModelError::Unknown { .. })));
}

#[test]
fn parameters_are_left_open_only_if_they_are_parameters_and_have_no_value() {
    let open = |values: &[(&str, Expression)], open: &[&str]| {
        Model::by_key("driven_pendulum", values, open).map(|model| model.open_parameters())
    };
    assert_eq!(open(&[], &["A"]), Ok(vec!["A".to_owned()]));
    assert_eq!(open(&[], &["ω0"]), Ok(vec!["omega0".to_owned()]));
    assert!(open(&[], &["B"]).is_err() && open(&[("A", formula("1"))], &["A"]).is_err());
    let model = Model::by_key("driven_pendulum", &[("omega", formula("2/3"))], &["A"]).unwrap();
    assert_eq!(
        (model.drive_frequency(), model.value_of("c"), model.value_of("A")),
        (Some(2.0 / 3.0), Some(0.0), None)
    );
}

#[test]
fn potentials_by_work_keep_the_energy_along_a_motion() {
    use libration::taylor::{Effort, Moment, integrate_stepwise};
    let kepler = Model::typed("x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2)", &[], &[]).unwrap();
    let energy = kepler.energy().unwrap();
    let start = Moment { time: 0.0, state: vec![0.5, 0.0, 0.0, 3_f64.sqrt()] };
    for (tolerance, bounds) in [(1e-6, 1e-11..1e-3), (1e-15, 0.0..1e-13)] {
        let mut balance = energy.balance(&start);
        let effort = Effort::to_tolerance(tolerance);
        let end = integrate_stepwise(&kepler.system().unwrap(), &start, &[100.0], &effort, |step| {
            balance.record(&Moment { time: step.end(), state: step.state_at(step.end()) });
            std::ops::ControlFlow::Continue(())
        });
        assert!(end.is_ok() && bounds.contains(&balance.drift()), "{tolerance}: {}", balance.drift());
    }
}
