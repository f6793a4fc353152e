//! A single pendulum without a drive: with any damping, and as an extended body in a fluid.

use super::{GRAVITY, HANGING, NOTHING_SAID, OMEGA0, SWING_ENERGY, THETA, parameter};
use crate::systems::{NamedSystem, VelocityPower};

pub(super) const SYSTEMS: &[NamedSystem] = &[
    NamedSystem {
        key: "pendulum",
        also: &["simple_pendulum"],
        title: "simple pendulum",
        equations: "theta'' + omega0^2*sin(theta) = 0",
        coordinates: THETA,
        parameters: &[OMEGA0],
        energy: SWING_ENERGY,
        energy_unit: "1/s^2, energy over m*l^2",
        power: "0",
        bodies: HANGING,
        description: "a mass on a rigid massless rod under gravity; theta from the downward vertical",
        domain: "all motions",
        source: "B. Black and V. Vel, Am. J. Phys. 91, 776 (2023), doi:10.1119/5.0130943; attributed to Huygens, Horologium Oscillatorium \
                 (1673); not verified against the original",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "damped_pendulum",
        also: &["damped"],
        title: "damped pendulum",
        equations: "theta'' + c*(abs(theta')^n*sign(theta')) + c0*sign(theta') + c1*theta' + c2*theta'*abs(theta') \
                    + c3*theta'^3 + omega0^2*sin(theta) = 0",
        coordinates: THETA,
        parameters: &[
            OMEGA0,
            parameter("c", "0", "s^(n-2)", "strength of the damping by the n-th power of the speed"),
            parameter("n", "1", "1", "this power, a whole number: 0 dry friction, 1 linear, 2 quadratic"),
            parameter("c0", "0", "1/s^2", "dry friction, which may hold the pendulum at rest"),
            parameter("c1", "0", "1/s", "linear damping, as in slow viscous flow"),
            parameter("c2", "0", "1", "quadratic damping, as in fast turbulent flow"),
            parameter("c3", "0", "s", "cubic damping"),
        ],
        energy: SWING_ENERGY,
        energy_unit: "1/s^2, energy over m*l^2",
        power: "-(c*abs(theta')^(n + 1) + c0*abs(theta') + c1*theta'^2 + c2*abs(theta')^3 + c3*theta'^4)",
        velocity_power: Some(VelocityPower::Any),
        bodies: HANGING,
        description: "a pendulum with a resistance opposite to its velocity: c*theta'*abs(theta')^(n-1), and any sum of powers",
        domain: "all motions; with dry friction the pendulum rests where omega0^2*abs(sin(theta)) is below the friction",
        source: "B. Black and V. Vel, Am. J. Phys. 91, 776 (2023), doi:10.1119/5.0130943, eq. (54), always against the velocity; Coulomb \
                 and Stokes damping: arXiv:2602.19725",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "damped_pendulum_54",
        also: &["black_vel_54"],
        title: "equation (54) of Black and Vel, taken literally",
        equations: "theta'' + c*theta'^n + omega0^2*sin(theta) = 0",
        coordinates: THETA,
        parameters: &[
            OMEGA0,
            parameter("c", "0", "s^(n-2)", "strength"),
            parameter("n", "2", "1", "a whole power of the velocity, n >= 0"),
        ],
        energy: SWING_ENERGY,
        energy_unit: "1/s^2, energy over m*l^2",
        power: "-c*theta'^(n + 1)",
        velocity_power: Some(VelocityPower::Whole),
        bodies: HANGING,
        description: "as printed: damping for odd n only; for even n it drives the backward swing as much as it brakes the forward swing, and for n = 2 a quantity is conserved; damped_pendulum is the intended equation",
        domain: "whole n",
        source: "B. Black and V. Vel, Am. J. Phys. 91, 776 (2023), doi:10.1119/5.0130943, eq. (54)",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "physical_pendulum",
        also: &["compound_pendulum"],
        title: "physical pendulum in a fluid",
        equations: "(I + Ca*rho*m*d^2)*theta'' + (1 - rho)*m*g*d*sin(theta) = 0",
        coordinates: THETA,
        parameters: &[
            parameter("m", "1", "kg", "mass of the body"),
            parameter("d", "1", "m", "distance from the axis to the centre of mass"),
            parameter("I", "1", "kg m^2", "moment of inertia about the axis, I_centre + m*d^2"),
            GRAVITY,
            parameter("rho", "0", "1", "density of the fluid over that of the body"),
            parameter(
                "Ca",
                "1/2",
                "1",
                "added mass over the mass of displaced fluid: 1/2 for a sphere, 1 for a cylinder moving across its axis",
            ),
        ],
        energy: "(I + Ca*rho*m*d^2)*theta'^2/2 + 2*(1 - rho)*m*g*d*sin(theta/2)^2",
        energy_unit: "J",
        power: "0",
        bodies: HANGING,
        description: "a body about a fixed axis; it displaces rho*m of fluid, whose weight m*g*rho lifts it at its centre of mass and which it must accelerate, Ca*rho*m at the distance d",
        domain: "homogeneous bodies small compared with d, so that buoyancy acts at the centre of mass and added mass moves as one point; without fluid (rho = 0) any body; resistance is left out",
        source: "derived; G. G. Stokes, Trans. Camb. Phil. Soc. 9, 8 (1851); attributed to R. A. Nelson and M. G. Olsson, Am. J. Phys. \
                 54, 112 (1986); not verified against the original",
        ..NOTHING_SAID
    },
];
