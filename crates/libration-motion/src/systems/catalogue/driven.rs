//! A single pendulum that is driven: by a torque, or by its pivot.

use super::{HANGING, NOTHING_SAID, OMEGA0, SWING_ENERGY, THETA, parameter};
use crate::systems::{NamedBody, NamedSystem};
use libration_numbers::catalogue::NamedParameter;

const DAMPING: NamedParameter = parameter("c", "0", "1/s", "linear damping");
const PIVOT: NamedParameter =
    parameter("a", "0", "1", "amplitude of the pivot's motion over the length of the pendulum");

pub(super) const SYSTEMS: &[NamedSystem] = &[
    NamedSystem {
        key: "driven_pendulum",
        also: &["driven", "forced_pendulum"],
        title: "pendulum driven by a torque",
        equations: "theta'' + c*theta' + omega0^2*sin(theta) = A*cos(omega*t)",
        coordinates: THETA,
        parameters: &[
            OMEGA0,
            DAMPING,
            parameter("A", "0", "1/s^2", "amplitude of the torque over the moment of inertia"),
            parameter("omega", "2/3", "rad/s", "angular frequency of the torque"),
        ],
        energy: SWING_ENERGY,
        energy_unit: "1/s^2, energy over m*l^2",
        power: "A*cos(omega*t)*theta' - c*theta'^2",
        drive_frequency: Some("omega"),
        bodies: HANGING,
        description: "an alternating torque drives the pendulum at its axis; the standard example of chaos",
        domain: "all motions",
        source: "G. L. Baker and J. P. Gollub, Chaotic Dynamics: An Introduction, 2nd ed., Cambridge University Press (1996)",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "vertically_driven_pendulum",
        also: &["kapitza", "kapitza_pendulum", "parametric_pendulum"],
        title: "pendulum whose pivot moves up and down",
        equations: "theta'' + c*theta' + (omega0^2 - a*omega^2*cos(omega*t))*sin(theta) = 0",
        coordinates: THETA,
        parameters: &[
            OMEGA0,
            DAMPING,
            PIVOT,
            parameter("omega", "2", "rad/s", "angular frequency of the pivot"),
        ],
        energy: SWING_ENERGY,
        energy_unit: "1/s^2, energy over m*l^2",
        power: "a*omega^2*cos(omega*t)*sin(theta)*theta' - c*theta'^2",
        drive_frequency: Some("omega"),
        bodies: &[NamedBody {
            place: ["sin(theta)", "a*cos(omega*t) - cos(theta)"],
            pivot: ["0", "a*cos(omega*t)"],
        }],
        description: "the pivot is at the height a*l*cos(omega*t), whose acceleration adds to gravity; energy in the frame of the pivot; fast and strong driving holds the pendulum upright",
        domain: "all motions",
        source: "derived in the frame of the pivot; A. Stephenson, Phil. Mag. 15, 233 (1908), and P. L. Kapitza, Zh. Eksp. Teor. Fiz. 21, \
                 588 (1951)",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "horizontally_driven_pendulum",
        also: &["shaken_pendulum"],
        title: "pendulum whose pivot moves to and fro",
        equations: "theta'' + c*theta' + omega0^2*sin(theta) - a*omega^2*cos(omega*t)*cos(theta) = 0",
        coordinates: THETA,
        parameters: &[
            OMEGA0,
            DAMPING,
            PIVOT,
            parameter("omega", "2", "rad/s", "angular frequency of the pivot"),
        ],
        energy: SWING_ENERGY,
        energy_unit: "1/s^2, energy over m*l^2",
        power: "a*omega^2*cos(omega*t)*cos(theta)*theta' - c*theta'^2",
        drive_frequency: Some("omega"),
        bodies: &[NamedBody {
            place: ["a*cos(omega*t) + sin(theta)", "-cos(theta)"],
            pivot: ["a*cos(omega*t)", "0"],
        }],
        description: "the pivot is at a*l*cos(omega*t) along the horizontal in the plane of the swing; energy in the frame of the pivot",
        domain: "all motions",
        source: "derived in the frame of the pivot; L. D. Landau and E. M. Lifshitz, Mechanics, 3rd ed. (1976), section 5, problem 3(b), \
                 and section 30, problem 2",
        ..NOTHING_SAID
    },
];
