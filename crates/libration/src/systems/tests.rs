//! The equations of the named systems against a derivation of their own: masses at places in space, and Lagrange's
//! equations.

use std::collections::BTreeMap;

use super::*;
use crate::algebra::Doubles;
use crate::catalogue::Named;
use crate::expression::{Expression, Jet, Symbol, Tape};
use crate::taylor::Moment;

/// A mass at a place, each part a formula: inertia, weight (mass times gravity), x, y and the height z.
type Mass = [&'static str; 5];

/// Masses on their rods, with what acts on them beside weight.
struct Mechanism {
    key: &'static str,
    masses: &'static [Mass],
    /// Potential energy of springs.
    springs: &'static str,
    /// The generalized force on each coordinate that has no potential.
    forces: &'static [&'static str],
    /// Values that the masses need beside the parameters.
    defined: &'static [(&'static str, &'static str)],
}

const BOB: &[Mass] = &[["1", "omega0^2", "sin(theta)", "0", "-cos(theta)"]];

const fn one_bob(key: &'static str, forces: &'static [&'static str]) -> Mechanism {
    Mechanism { key, masses: BOB, springs: "0", forces, defined: &[] }
}

const MECHANISMS: &[Mechanism] = &[
    one_bob("pendulum", &["0"]),
    one_bob(
        "damped_pendulum",
        &["-(c*abs(theta')^n + c0 + c1*abs(theta') + c2*theta'^2 + c3*abs(theta')^3)*theta'/abs(theta')"],
    ),
    one_bob("damped_pendulum_54", &["-c*theta'^n"]),
    Mechanism {
        // Two halves at equal distances from the centre of mass, and the fluid that moves with it and is missing in its place.
        key: "physical_pendulum",
        masses: &[
            ["m/2", "m*g/2", "(d + s)*sin(theta)", "0", "-(d + s)*cos(theta)"],
            ["m/2", "m*g/2", "(d - s)*sin(theta)", "0", "-(d - s)*cos(theta)"],
            ["Ca*rho*m", "-rho*m*g", "d*sin(theta)", "0", "-d*cos(theta)"],
        ],
        springs: "0",
        forces: &["0"],
        defined: &[("s", "sqrt(I/m - d^2)")],
    },
    one_bob("driven_pendulum", &["A*cos(omega*t) - c*theta'"]),
    Mechanism {
        key: "vertically_driven_pendulum",
        masses: &[["1", "omega0^2", "sin(theta)", "0", "a*cos(omega*t) - cos(theta)"]],
        springs: "0",
        forces: &["-c*theta'"],
        defined: &[],
    },
    Mechanism {
        key: "horizontally_driven_pendulum",
        masses: &[["1", "omega0^2", "a*cos(omega*t) + sin(theta)", "0", "-cos(theta)"]],
        springs: "0",
        forces: &["-c*theta'"],
        defined: &[],
    },
    Mechanism {
        key: "spring_pendulum",
        masses: &[["1", "g", "r*sin(theta)", "0", "-r*cos(theta)"]],
        springs: "kappa*(r - l)^2/2",
        forces: &["0", "0"],
        defined: &[],
    },
    Mechanism {
        key: "double_pendulum",
        masses: &[
            ["m1", "m1*g", "l1*sin(theta1)", "0", "-l1*cos(theta1)"],
            ["m2", "m2*g", "l1*sin(theta1) + l2*sin(theta2)", "0", "-l1*cos(theta1) - l2*cos(theta2)"],
        ],
        springs: "0",
        forces: &["0", "0"],
        defined: &[],
    },
    Mechanism {
        key: "spherical_pendulum",
        masses: &[["1", "omega0^2", "sin(theta)*cos(phi)", "sin(theta)*sin(phi)", "-cos(theta)"]],
        springs: "0",
        forces: &["0", "0"],
        defined: &[],
    },
    Mechanism {
        key: "spherical_pendulum_xy",
        masses: &[["1", "g", "x", "y", "-sqrt(l^2 - x^2 - y^2)"]],
        springs: "0",
        forces: &["0", "0"],
        defined: &[],
    },
    Mechanism {
        key: "coupled_pendulums",
        masses: &[
            ["1", "omega1^2", "sin(theta1)", "0", "-cos(theta1)"],
            ["1", "omega2^2", "sin(theta2)", "0", "-cos(theta2)"],
        ],
        springs: "kappa*(theta1 - theta2)^2/2",
        forces: &["0", "0"],
        defined: &[],
    },
    Mechanism {
        // Of three pendulums.
        key: "pendulum_chain",
        masses: &[
            ["1", "omega0^2", "sin(theta1)", "0", "-cos(theta1)"],
            ["1", "omega0^2", "sin(theta2)", "0", "-cos(theta2)"],
            ["1", "omega0^2", "sin(theta3)", "0", "-cos(theta3)"],
        ],
        springs: "kappa*((theta1 - theta2)^2 + (theta2 - theta3)^2)/2",
        forces: &["0", "0", "0"],
        defined: &[],
    },
    Mechanism {
        key: "kepler",
        masses: &[["1", "0", "x", "y", "0"]],
        springs: "-mu/sqrt(x^2 + y^2)",
        forces: &["0", "0"],
        defined: &[],
    },
    Mechanism {
        key: "henon_heiles",
        masses: &[["1", "0", "x", "y", "0"]],
        springs: "(x^2 + y^2)/2 + lambda*y*(x^2 - y^2/3)",
        forces: &["0", "0"],
        defined: &[],
    },
    Mechanism {
        // Of three masses.
        key: "fermi_pasta_ulam",
        masses: &[["1", "0", "x1", "0", "0"], ["1", "0", "x2", "0", "0"], ["1", "0", "x3", "0", "0"]],
        springs: "(x1^2 + (x2 - x1)^2 + (x3 - x2)^2 + x3^2)/2 + alpha*(x1^3 + (x2 - x1)^3 + (x3 - x2)^3 - x3^3)/3 \
                  + beta*(x1^4 + (x2 - x1)^4 + (x3 - x2)^4 + x3^4)/4",
        forces: &["0", "0", "0"],
        defined: &[],
    },
];

fn formula(text: &str) -> Expression {
    text.parse().unwrap()
}

fn sum(terms: impl IntoIterator<Item = Expression>) -> Expression {
    let add = |a, b| Expression::Add(Box::new(a), Box::new(b));
    terms.into_iter().reduce(add).unwrap_or(Expression::from(0))
}

fn product(a: Expression, b: Expression) -> Expression {
    Expression::Multiply(Box::new(a), Box::new(b))
}

/// A named system with all parameters open.
struct Open {
    named: &'static NamedSystem,
    model: Model,
}

impl Open {
    fn all() -> impl Iterator<Item = Self> {
        catalogue().map(|named| {
            let names = named.parameters.iter().map(|it| it.name);
            let open: Vec<&str> = names.filter(|name| named.count != Some(name)).collect();
            let three = named.count.map(|name| (name, Expression::from(3)));
            Self { named, model: Model::named(named, three.as_slice(), &open).unwrap() }
        })
    }

    /// Those with accelerations.
    fn mechanical() -> impl Iterator<Item = Self> {
        Self::all().filter(|system| system.model.layout().is_of_second_order())
    }

    /// Those that have an energy as a formula.
    fn with_energy() -> impl Iterator<Item = Self> {
        Self::all().filter(|system| !system.named.energy.is_empty())
    }

    fn places(&self) -> impl Iterator<Item = Symbol> {
        self.model.coordinates().iter().map(|it| Symbol::plain(&it.name))
    }

    /// The time derivative along the motion.
    fn rate(&self, of: &Expression) -> Expression {
        let terms =
            self.places().zip(self.model.equation().accelerations()).flat_map(|(place, acceleration)| {
                let velocity = place.with_primes(1);
                let by_place = product(of.derivative(&place), Expression::Symbol(velocity.clone()));
                [by_place, product(of.derivative(&velocity), acceleration.clone())]
            });
        sum([of.derivative(&Symbol::plain("t"))].into_iter().chain(terms))
    }

    /// Numbers inside the domain of each system: masses and lengths about 1, places about 1/2.
    fn numbers(&self, trial: u32) -> Numbers {
        let mut random = Weyl(f64::from(trial));
        let mut numbers = BTreeMap::from([(Symbol::plain("t"), random.between(0.0, 3.0))]);
        for place in self.places() {
            // Powers that are no whole numbers want a positive velocity in (54).
            let sign =
                if self.named.key == "damped_pendulum_54" || trial.is_multiple_of(2) { 1.0 } else { -1.0 };
            numbers.insert(place.with_primes(1), sign * random.between(0.3, 1.5));
            let from = if place.name == "r" { 1.0 } else { 0.2 };
            numbers.insert(place, from + random.between(0.0, 0.4));
        }
        for parameter in self.named.parameters {
            let from = if parameter.name == "I" { 2.0 } else { 0.6 };
            numbers.insert(Symbol::plain(parameter.name), from + random.between(0.0, 0.4));
        }
        Numbers(numbers)
    }
}

/// The fractions of n√2, which fill the unit interval evenly.
struct Weyl(f64);

impl Weyl {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 += std::f64::consts::SQRT_2;
        low + (high - low) * self.0.fract()
    }
}

/// A number for each symbol.
struct Numbers(BTreeMap<Symbol, f64>);

impl Numbers {
    fn value(&self, formula: &Expression) -> f64 {
        let symbols: Vec<Symbol> = self.0.keys().cloned().collect();
        let values: Vec<f64> = self.0.values().copied().collect();
        let tape = Tape::new(&[formula], &symbols).unwrap();
        Jet::new(&Doubles, &tape, &values).unwrap().result(0)[0]
    }
}

impl Mechanism {
    fn part(&self, text: &str) -> Expression {
        let put_in = |formula_so_far: Expression, (name, value): &(&str, &str)| {
            formula_so_far.substitute(&Symbol::plain(name), &formula(value))
        };
        self.defined.iter().fold(formula(text), put_in)
    }

    fn kinetic_energy(&self, system: &Open) -> Expression {
        let half = |a: Expression, b: Expression| product(formula("1/2"), product(a, b));
        let square = |a: Expression| product(a.clone(), a);
        sum(self.masses.iter().map(|[inertia, _, x, y, z]| {
            // Places do not depend on velocities, so that the accelerations do not enter.
            let speeds = [x, y, z].map(|place| square(system.rate(&self.part(place))));
            half(formula(inertia), sum(speeds))
        }))
    }

    fn potential_energy(&self) -> Expression {
        let weights = self.masses.iter().map(|[_, weight, _, _, z]| product(formula(weight), self.part(z)));
        sum(weights.chain([formula(self.springs)]))
    }

    fn pivot_moves(&self) -> bool {
        self.potential_energy().contains(&Symbol::plain("t")) || self.key == "horizontally_driven_pendulum"
    }
}

const TRIALS: u32 = 20;

#[test]
fn every_system_obeys_lagranges_equations_of_its_masses() {
    let mut systems = Open::mechanical();
    for mechanism in MECHANISMS {
        let system = systems.next().unwrap();
        assert_eq!(system.named.key, mechanism.key);
        let potential = Expression::Negate(Box::new(mechanism.potential_energy()));
        let lagrangian = sum([mechanism.kinetic_energy(&system), potential]);
        for (place, force) in system.places().zip(mechanism.forces) {
            let momentum_rate = system.rate(&lagrangian.derivative(&place.with_primes(1)));
            let slope = lagrangian.derivative(&place);
            for trial in 0..TRIALS {
                let numbers = system.numbers(trial);
                let [rate, slope, force] =
                    [&momentum_rate, &slope, &formula(force)].map(|it| numbers.value(it));
                let size = rate.abs() + slope.abs() + force.abs();
                assert!(
                    (rate - slope - force).abs() < 1e-14 * (1.0 + size),
                    "{} {place}: {rate} {slope} {force}",
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
        // Its centre of mass stands for the body, at the distance one.
        let masses = if system.named.key == "physical_pendulum" { BOB } else { mechanism.masses };
        assert_eq!(system.named.bodies.len(), masses.len(), "{}", system.named.key);
        for (body, [_, _, x, y, z]) in system.named.bodies.iter().zip(masses) {
            let lengths = (0..TRIALS).map(|trial| {
                let numbers = system.numbers(trial);
                let value = |text: &str| numbers.value(&formula(text));
                let place = body.place.map(value);
                assert_eq!(
                    place.map(f64::to_bits),
                    [value(x), value(z)].map(f64::to_bits),
                    "{}",
                    system.named.key
                );
                let held = body.pivot.map(value);
                let length = libm::hypot(libm::hypot(place[0] - held[0], place[1] - held[1]), value(y));
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
        let own = formula(system.named.energy);
        let sum = sum([mechanism.kinetic_energy(&system), mechanism.potential_energy()]);
        for trial in 0..TRIALS {
            let numbers = system.numbers(trial);
            // The zero of the potential is free.
            let mut resting = system.numbers(trial);
            for place in system.places() {
                resting.0.insert(place.with_primes(1), 0.0);
                resting.0.insert(place, 0.5);
            }
            let change = |energy: &Expression| numbers.value(energy) - resting.value(energy);
            assert!(
                (change(&own) - change(&sum)).abs() < 1e-14,
                "{}: {} {}",
                mechanism.key,
                change(&own),
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

/// What is nowhere at rest.
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
            // The two angles have no place of rest at the lowest point, and a planet has none.
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

fn energy_of(equations: &str) -> Result<Energy, NoEnergy> {
    Model::typed(equations, &[], &[]).unwrap().energy()
}

#[test]
fn only_forces_with_a_potential_have_an_energy() {
    for equations in
        ["x'' = -x^3", "x'' = -sin(x - y); y'' = sin(x - y)", "x'' = -y*exp(x*y); y'' = -x*exp(x*y)"]
    {
        assert!(energy_of(equations).is_ok(), "{equations}");
    }
    assert!(matches!(energy_of("x'' = -y; y'' = x"), Err(NoEnergy::Curl { .. })));
    assert!(matches!(energy_of("x'' = -x - 0.1 x'"), Err(NoEnergy::NotOfPlace { .. })));
    assert!(matches!(energy_of("x'' = -x + cos(t)"), Err(NoEnergy::NotOfPlace { .. })));
    assert!(matches!(energy_of("x'' = -k*x"), Err(NoEnergy::WithoutValue(_))));
    let damped = Model::by_key("damped_pendulum", &[("c", formula("0.1"))], &[]).unwrap();
    assert!(matches!(damped.energy(), Err(NoEnergy::NotConserved { .. })));
}

#[test]
fn a_mass_that_is_not_positive_counts_as_one() {
    // −x″ = x³ and x″ = −x³ are one motion; a kinetic energy below zero would be no measure of the drift.
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
    for oscillator in crate::oscillator::catalogue() {
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
    use crate::taylor::{Effort, Moment, integrate_watched};
    let kepler = Model::typed("x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2)", &[], &[]).unwrap();
    let energy = kepler.energy().unwrap();
    let start = Moment { time: 0.0, state: vec![0.5, 0.0, 0.0, 3_f64.sqrt()] };
    for (tolerance, bounds) in [(1e-6, 1e-11..1e-3), (1e-15, 0.0..1e-13)] {
        let mut balance = energy.balance(&start);
        let effort = Effort::to_tolerance(tolerance);
        let end = integrate_watched(&kepler.system().unwrap(), &start, &[100.0], &effort, |step| {
            balance.record(&Moment { time: step.end(), state: step.state_at(step.end()) });
            std::ops::ControlFlow::Continue(())
        });
        assert!(end.is_ok() && bounds.contains(&balance.drift()), "{tolerance}: {}", balance.drift());
    }
}
