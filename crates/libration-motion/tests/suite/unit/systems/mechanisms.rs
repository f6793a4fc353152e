//! The named systems as point masses in space, with the numbers for which they are evaluated.

use libration::algebra::Doubles;
use libration::expression::{Expression, Symbol};
use libration::systems::{Model, NamedSystem, catalogue};
use libration_numbers::internals::expression::{Jet, Tape};
use std::collections::BTreeMap;

/// A point mass, each property a formula: inertia, weight (mass times gravity), x, y and the height z.
pub(super) type Mass = [&'static str; 5];

/// Point masses of a system, with the forces on them besides weight.
pub(super) struct Mechanism {
    pub(super) key: &'static str,
    pub(super) masses: &'static [Mass],
    /// Potential energy of springs.
    pub(super) springs: &'static str,
    /// The generalised force on each coordinate that has no potential.
    pub(super) forces: &'static [&'static str],
    /// Values that occur in the formulas of the masses besides the parameters.
    pub(super) defined: &'static [(&'static str, &'static str)],
}

pub(super) const BOB: &[Mass] = &[["1", "omega0^2", "sin(theta)", "0", "-cos(theta)"]];

pub(super) const fn one_bob(key: &'static str, forces: &'static [&'static str]) -> Mechanism {
    Mechanism { key, masses: BOB, springs: "0", forces, defined: &[] }
}

pub(super) const MECHANISMS: &[Mechanism] = &[
    one_bob("pendulum", &["0"]),
    one_bob(
        "damped_pendulum",
        &["-(c*abs(theta')^n + c0 + c1*abs(theta') + c2*theta'^2 + c3*abs(theta')^3)*theta'/abs(theta')"],
    ),
    one_bob("damped_pendulum_54", &["-c*theta'^n"]),
    Mechanism {
        // Two halves at equal distances from the centre of mass, and the displaced fluid.
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
        // The chain of three pendulums.
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
        // The chain of three masses.
        key: "fermi_pasta_ulam",
        masses: &[["1", "0", "x1", "0", "0"], ["1", "0", "x2", "0", "0"], ["1", "0", "x3", "0", "0"]],
        springs: "(x1^2 + (x2 - x1)^2 + (x3 - x2)^2 + x3^2)/2 + alpha*(x1^3 + (x2 - x1)^3 + (x3 - x2)^3 - x3^3)/3 \
                  + beta*(x1^4 + (x2 - x1)^4 + (x3 - x2)^4 + x3^4)/4",
        forces: &["0", "0", "0"],
        defined: &[],
    },
];

pub(super) fn formula(text: &str) -> Expression {
    text.parse().unwrap()
}

pub(super) fn sum(terms: impl IntoIterator<Item = Expression>) -> Expression {
    let add = |a, b| Expression::Add(Box::new(a), Box::new(b));
    terms.into_iter().reduce(add).unwrap_or(Expression::from(0))
}

pub(super) fn product(a: Expression, b: Expression) -> Expression {
    Expression::Multiply(Box::new(a), Box::new(b))
}

/// A named system with all parameters open.
pub(super) struct Open {
    pub(super) named: &'static NamedSystem,
    pub(super) model: Model,
}

impl Open {
    pub(super) fn all() -> impl Iterator<Item = Self> {
        catalogue().map(|named| {
            let names = named.parameters.iter().map(|parameter| parameter.name);
            let open: Vec<&str> = names.filter(|name| named.count != Some(name)).collect();
            let three = named.count.map(|name| (name, Expression::from(3)));
            Self { named, model: Model::named(named, three.as_slice(), &open).unwrap() }
        })
    }

    /// The systems whose equations are all of second order.
    pub(super) fn mechanical() -> impl Iterator<Item = Self> {
        Self::all().filter(|system| system.model.layout().is_of_second_order())
    }

    /// The systems that have an energy as a formula.
    pub(super) fn with_energy() -> impl Iterator<Item = Self> {
        Self::all().filter(|system| !system.named.energy.is_empty())
    }

    pub(super) fn places(&self) -> impl Iterator<Item = Symbol> {
        self.model.coordinates().iter().map(|coordinate| Symbol::plain(&coordinate.name))
    }

    /// The time derivative along the motion.
    pub(super) fn rate(&self, of: &Expression) -> Expression {
        let terms = self.places().zip(self.model.equation().accelerations()).flat_map(
            |(coordinate, acceleration)| {
                let velocity = coordinate.with_primes(1);
                let by_place = product(of.derivative(&coordinate), Expression::Symbol(velocity.clone()));
                [by_place, product(of.derivative(&velocity), acceleration.clone())]
            },
        );
        sum([of.derivative(&Symbol::plain("t"))].into_iter().chain(terms))
    }

    /// Numbers inside the domain of each system: masses and lengths about 1, positions about 1/2.
    pub(super) fn numbers(&self, trial: u32) -> Numbers {
        let mut random = Weyl(f64::from(trial));
        let mut numbers = BTreeMap::from([(Symbol::plain("t"), random.between(0.0, 3.0))]);
        for coordinate in self.places() {
            // Powers that are not integers require a positive velocity in (54).
            let sign =
                if self.named.key == "damped_pendulum_54" || trial.is_multiple_of(2) { 1.0 } else { -1.0 };
            numbers.insert(coordinate.with_primes(1), sign * random.between(0.3, 1.5));
            let from = if coordinate.name == "r" { 1.0 } else { 0.2 };
            numbers.insert(coordinate, from + random.between(0.0, 0.4));
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
pub(super) struct Numbers(pub(super) BTreeMap<Symbol, f64>);

impl Numbers {
    pub(super) fn value(&self, formula: &Expression) -> f64 {
        let symbols: Vec<Symbol> = self.0.keys().cloned().collect();
        let values: Vec<f64> = self.0.values().copied().collect();
        let tape = Tape::new(&[formula], &symbols).unwrap();
        Jet::new(&Doubles, &tape, &values).unwrap().result(0)[0]
    }
}

impl Mechanism {
    pub(super) fn part(&self, text: &str) -> Expression {
        let put_in = |formula_so_far: Expression, (name, value): &(&str, &str)| {
            formula_so_far.substitute(&Symbol::plain(name), &formula(value))
        };
        self.defined.iter().fold(formula(text), put_in)
    }

    pub(super) fn kinetic_energy(&self, system: &Open) -> Expression {
        let half = |a: Expression, b: Expression| product(formula("1/2"), product(a, b));
        let square = |a: Expression| product(a.clone(), a);
        sum(self.masses.iter().map(|[inertia, _, x, y, z]| {
            // Positions do not depend on velocities, so that the accelerations do not enter.
            let speeds = [x, y, z].map(|position| square(system.rate(&self.part(position))));
            half(formula(inertia), sum(speeds))
        }))
    }

    pub(super) fn potential_energy(&self) -> Expression {
        let weights = self.masses.iter().map(|[_, weight, _, _, z]| product(formula(weight), self.part(z)));
        sum(weights.chain([formula(self.springs)]))
    }

    pub(super) fn pivot_moves(&self) -> bool {
        self.potential_energy().contains(&Symbol::plain("t")) || self.key == "horizontally_driven_pendulum"
    }
}
