//! Pendulums of more than one coordinate.

use super::{GRAVITY, NOTHING_SAID, OMEGA0, angle, parameter};
use crate::systems::{NamedBody, NamedCoordinate, NamedSystem};

const fn length(name: &'static str, at_rest: &'static str) -> NamedCoordinate {
    NamedCoordinate { name, unit: "m", at_rest }
}

pub(super) const SYSTEMS: &[NamedSystem] = &[
    NamedSystem {
        key: "spring_pendulum",
        also: &["elastic_pendulum", "swinging_spring"],
        title: "spring pendulum",
        equations: "r'' = r*theta'^2 + g*cos(theta) - kappa*(r - l); theta'' = -(2*r'*theta' + g*sin(theta))/r",
        coordinates: &[length("r", "l + g/kappa"), angle("theta")],
        parameters: &[
            parameter("kappa", "10", "1/s^2", "stiffness over mass, k/m"),
            parameter("l", "1", "m", "natural length of the spring"),
            GRAVITY,
        ],
        energy: "(r'^2 + r^2*theta'^2)/2 + kappa*(r - l)^2/2 - g*r*cos(theta)",
        energy_unit: "m^2/s^2, energy over m",
        power: "0",
        bodies: &[NamedBody { place: ["r*sin(theta)", "-r*cos(theta)"], pivot: ["0", "0"] }],
        description: "a mass on a massless spring instead of the rod; r is the length of the spring, theta its angle from the downward vertical; at kappa*l = 3*g the spring is in 2:1 resonance with the swing",
        domain: "r above zero",
        source: "derived from its Lagrangian; A. Vitt and G. Gorelik, Zh. Tekh. Fiz. 3, 294 (1933)",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "double_pendulum",
        title: "double pendulum",
        equations: "theta1'' = -(m2*sin(theta1 - theta2)*(l1*theta1'^2*cos(theta1 - theta2) + l2*theta2'^2) \
                    + g*((m1 + m2)*sin(theta1) - m2*sin(theta2)*cos(theta1 - theta2)))\
                    /(l1*(m1 + m2*sin(theta1 - theta2)^2)); \
                    theta2'' = (sin(theta1 - theta2)*((m1 + m2)*l1*theta1'^2 + m2*l2*theta2'^2*cos(theta1 - theta2)) \
                    + g*(m1 + m2)*(sin(theta1)*cos(theta1 - theta2) - sin(theta2)))\
                    /(l2*(m1 + m2*sin(theta1 - theta2)^2))",
        coordinates: &[angle("theta1"), angle("theta2")],
        parameters: &[
            parameter("m1", "1", "kg", "mass of the upper bob"),
            parameter("m2", "1", "kg", "mass of the lower bob"),
            parameter("l1", "1", "m", "length of the upper rod"),
            parameter("l2", "1", "m", "length of the lower rod"),
            GRAVITY,
        ],
        energy: "(m1 + m2)*l1^2*theta1'^2/2 + m2*l2^2*theta2'^2/2 + m2*l1*l2*theta1'*theta2'*cos(theta1 - theta2) \
                 + 2*g*((m1 + m2)*l1*sin(theta1/2)^2 + m2*l2*sin(theta2/2)^2)",
        energy_unit: "J",
        power: "0",
        bodies: &[
            NamedBody { place: ["l1*sin(theta1)", "-l1*cos(theta1)"], pivot: ["0", "0"] },
            NamedBody {
                place: ["l1*sin(theta1) + l2*sin(theta2)", "-l1*cos(theta1) - l2*cos(theta2)"],
                pivot: ["l1*sin(theta1)", "-l1*cos(theta1)"],
            },
        ],
        description: "a pendulum that hangs from the bob of another, both rods massless; both angles from the downward vertical",
        domain: "all motions",
        source: "derived from its Lagrangian: L. D. Landau and E. M. Lifshitz, Mechanics, 3rd ed. (1976), section 5, problem 1",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "spherical_pendulum",
        also: &["conical_pendulum"],
        title: "spherical pendulum, by its two angles",
        equations: "theta'' = sin(theta)*(phi'^2*cos(theta) - omega0^2); phi'' = -2*theta'*phi'*cos(theta)/sin(theta)",
        coordinates: &[angle("theta"), angle("phi")],
        parameters: &[OMEGA0],
        energy: "(theta'^2 + sin(theta)^2*phi'^2)/2 + 2*omega0^2*sin(theta/2)^2",
        energy_unit: "1/s^2, energy over m*l^2",
        power: "0",
        bodies: &[NamedBody { place: ["sin(theta)*cos(phi)", "-cos(theta)"], pivot: ["0", "0"] }],
        description: "a pendulum free to swing in all directions; theta from the downward vertical, phi around it; sin(theta)^2*phi' is conserved, and theta is constant with phi' = omega0/sqrt(cos(theta))",
        domain: "motions that pass neither the lowest nor the highest point, where phi has no meaning and the integration stops; spherical_pendulum_xy is regular at the lowest",
        source: "derived from its Lagrangian: L. D. Landau and E. M. Lifshitz, Mechanics, 3rd ed. (1976), section 14, problem 1",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "spherical_pendulum_xy",
        title: "spherical pendulum, seen from above",
        equations: "x'' = -x*(x'^2 + y'^2 + (x*x' + y*y')^2/(l^2 - x^2 - y^2) + g*sqrt(l^2 - x^2 - y^2))/l^2; \
                    y'' = -y*(x'^2 + y'^2 + (x*x' + y*y')^2/(l^2 - x^2 - y^2) + g*sqrt(l^2 - x^2 - y^2))/l^2",
        coordinates: &[length("x", "0"), length("y", "0")],
        parameters: &[parameter("l", "1", "m", "length of the rod"), GRAVITY],
        energy: "(x'^2 + y'^2 + (x*x' + y*y')^2/(l^2 - x^2 - y^2))/2 + g*(x^2 + y^2)/(l + sqrt(l^2 - x^2 - y^2))",
        energy_unit: "m^2/s^2, energy over m",
        power: "0",
        bodies: &[NamedBody { place: ["x", "-sqrt(l^2 - x^2 - y^2)"], pivot: ["0", "0"] }],
        description: "the same pendulum in the horizontal coordinates of its bob, which the pull of the rod affects alike; the lowest point is regular; x*y' - y*x' is conserved",
        domain: "motions below the horizontal, x^2 + y^2 < l^2, where the integration stops: use spherical_pendulum beyond",
        source: "derived from the constraint force of the rod; J. L. Lagrange, Mécanique analytique (1788), in Oeuvres 12, \
                 part 2, section VIII",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "coupled_pendulums",
        also: &["coupled_pendulum", "sympathetic_pendulums"],
        title: "two pendulums coupled by a spring",
        equations: "theta1'' + omega1^2*sin(theta1) + kappa*(theta1 - theta2) = 0; \
                    theta2'' + omega2^2*sin(theta2) + kappa*(theta2 - theta1) = 0",
        coordinates: &[angle("theta1"), angle("theta2")],
        parameters: &[
            parameter("omega1", "1", "rad/s", "angular frequency of the first alone"),
            parameter("omega2", "1", "rad/s", "angular frequency of the second alone"),
            parameter(
                "kappa",
                "1/10",
                "1/s^2",
                "coupling: torque of the spring per angle over the moment of inertia",
            ),
        ],
        energy: "(theta1'^2 + theta2'^2)/2 + 2*omega1^2*sin(theta1/2)^2 + 2*omega2^2*sin(theta2/2)^2 \
                 + kappa*(theta1 - theta2)^2/2",
        energy_unit: "1/s^2, energy over the moment of inertia",
        power: "0",
        bodies: &[
            NamedBody { place: ["sin(theta1)", "-cos(theta1)"], pivot: ["0", "0"] },
            NamedBody { place: ["sin(theta2)", "-cos(theta2)"], pivot: ["0", "0"] },
        ],
        description: "two pendulums of the same moment of inertia on one axis with a torsion spring between them; beats transfer the swing from one to the other and back",
        domain: "all motions; a straight spring of stiffness k between points at the depth h gives the same with kappa = k*h^2/(m*l^2) at small angles only",
        source: "derived from the torques; attributed to A. Sommerfeld, Mechanics (1952), section 20; not verified against the original",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "pendulum_chain",
        also: &["frenkel_kontorova", "sine_gordon_chain"],
        title: "chain of pendulums coupled by springs",
        equations: "theta[i]'' = -omega0^2*sin(theta[i]) + kappa*(theta[i+1] - 2*theta[i] + theta[i-1]), i = 1..n; \
                    theta[0] = theta[1]; theta[n+1] = theta[n]",
        coordinates: &[angle("theta[i]")],
        parameters: &[
            OMEGA0,
            parameter(
                "kappa",
                "1/10",
                "1/s^2",
                "coupling: torque of a spring per angle over the moment of inertia",
            ),
            parameter("n", "8", "1", "number of pendulums, from 1 to 1000"),
        ],
        count: Some("n"),
        description: "n equal pendulums on one axis, each with a torsion spring to the next, as coupled_pendulums has two; the ends are free; small swings have the angular frequencies sqrt(omega0^2 + 4*kappa*sin(pi*k/(2*n))^2), k = 0..n-1; the energy is the sum of theta[i]'^2/2 + 2*omega0^2*sin(theta[i]/2)^2 over pendulums and of kappa*(theta[i+1] - theta[i])^2/2 over springs",
        domain: "all motions; for waves much longer than the distance a of two pendulums the sine-Gordon equation with the speed a*sqrt(kappa)",
        source: "derived from the torques; attributed to A. C. Scott, Am. J. Phys. 37, 52 (1969); not verified against the original",
        ..NOTHING_SAID
    },
];
