//! Bodies in a potential that are not pendulums: about a centre, in a galaxy, on a chain.

use super::{NOTHING_SAID, number, parameter};
use crate::systems::NamedSystem;

pub(super) const SYSTEMS: &[NamedSystem] = &[
    NamedSystem {
        key: "kepler",
        also: &["kepler_problem", "two_bodies"],
        title: "body about a centre of gravity",
        equations: "x'' = -mu*x/(x^2 + y^2)^(3/2); y'' = -mu*y/(x^2 + y^2)^(3/2)",
        coordinates: &[number("x", "1"), number("y", "0")],
        parameters: &[parameter("mu", "1", "length^3/s^2", "gravitational parameter, G*M")],
        energy: "(x'^2 + y'^2)/2 - mu/sqrt(x^2 + y^2)",
        energy_unit: "energy over m",
        power: "0",
        description: "a planet in its plane, the sun at zero; from x = 1 - e, y' = sqrt((1 + e)/(1 - e)) at mu = 1 it goes about an ellipse of eccentricity e in the time 2*pi; x*y' - y*x' is conserved",
        domain: "motions that do not meet the centre; there is no equilibrium: the start is x = 1 where none is given",
        source: "I. Newton, Philosophiae Naturalis Principia Mathematica (1687), book I, proposition 11",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "henon_heiles",
        also: &["henon"],
        title: "Hénon and Heiles's star in a galaxy",
        equations: "x'' = -x - 2*lambda*x*y; y'' = -y - lambda*(x^2 - y^2)",
        coordinates: &[number("x", "0"), number("y", "0")],
        parameters: &[parameter("lambda", "1", "1", "strength of the coupling")],
        energy: "(x'^2 + y'^2 + x^2 + y^2)/2 + lambda*(x^2*y - y^3/3)",
        energy_unit: "1",
        power: "0",
        description: "a star in the plane through the axis of a galaxy, in units in which both frequencies are 1; at lambda = 1 most motions are regular at energies up to 1/12, and hardly any at 1/6",
        domain: "bounded at energies below 1/(6*lambda^2), inside the triangle about zero",
        source: "M. Hénon and C. Heiles, Astron. J. 69, 73 (1964), doi:10.1086/109234, with lambda = 1",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "fermi_pasta_ulam",
        also: &["fput", "fermi_pasta_ulam_tsingou"],
        title: "Fermi, Pasta, Ulam and Tsingou's chain",
        equations: "x[i]'' = (x[i+1] - x[i]) - (x[i] - x[i-1]) \
                    + alpha*((x[i+1] - x[i])^2 - (x[i] - x[i-1])^2) \
                    + beta*((x[i+1] - x[i])^3 - (x[i] - x[i-1])^3), i = 1..n",
        coordinates: &[number("x[i]", "0")],
        parameters: &[
            parameter("alpha", "1/4", "1", "quadratic part of the springs' force"),
            parameter("beta", "0", "1", "cubic part of the springs' force"),
            parameter("n", "32", "1", "number of masses, from 1 to 1000"),
        ],
        count: Some("n"),
        description: "n equal masses between n + 1 equal springs whose ends are fixed, in units of mass and spring; x[i] is the displacement of a mass from equilibrium; its modes have the angular frequencies 2*sin(pi*k/(2*(n + 1))); the energy is the sum of x[i]'^2/2 + d^2/2 + alpha*d^3/3 + beta*d^4/4 over masses and springs, d = x[i+1] - x[i]",
        domain: "with alpha alone, |alpha*d| < 1 for all springs, beyond which a spring may not restore",
        source: "E. Fermi, J. Pasta and S. Ulam, Studies of nonlinear problems I, Los Alamos report LA-1940 (1955), doi:10.2172/4376203",
        ..NOTHING_SAID
    },
];
