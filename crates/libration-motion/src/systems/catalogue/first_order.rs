//! Systems whose equations are of first order.

use super::{NOTHING_SAID, number, parameter};
use crate::systems::NamedSystem;

pub(super) const SYSTEMS: &[NamedSystem] = &[
    NamedSystem {
        key: "lorenz",
        also: &["lorenz63"],
        title: "Lorenz's convection",
        equations: "x' = sigma*(y - x); y' = x*(rho - z) - y; z' = x*y - beta*z",
        coordinates: &[number("x", "0"), number("y", "0"), number("z", "0")],
        parameters: &[
            parameter("sigma", "10", "1", "Prandtl number"),
            parameter("rho", "28", "1", "Rayleigh number over that at which convection begins"),
            parameter("beta", "8/3", "1", "geometry of the rolls"),
        ],
        description: "convection between two plates: x is the speed of the rolls, y the difference in temperature between rising and sinking fluid, z the deviation of the temperature profile from a line; chaotic with the default values, with the largest Lyapunov exponent 0.9056",
        domain: "all motions; the equilibrium at zero is unstable for rho > 1",
        source: "E. N. Lorenz, J. Atmos. Sci. 20, 130 (1963), doi:10.1175/1520-0469(1963)020<0130:DNF>2.0.CO;2",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "roessler",
        also: &["rossler"],
        title: "Rössler's band",
        equations: "x' = -y - z; y' = x + a*y; z' = b + z*(x - c)",
        coordinates: &[
            number("x", "(c - sqrt(c^2 - 4*a*b))/2"),
            number("y", "-(c - sqrt(c^2 - 4*a*b))/(2*a)"),
            number("z", "(c - sqrt(c^2 - 4*a*b))/(2*a)"),
        ],
        parameters: &[
            parameter("a", "1/5", "1", "growth of the spiral"),
            parameter("b", "1/5", "1", "rate at which the motion is lifted off the plane"),
            parameter("c", "57/10", "1", "position at which the motion is folded back"),
        ],
        description: "the simplest flow that folds a band onto itself: a spiral in the plane of x and y that is lifted and led back; chaotic with the default values, with the largest Lyapunov exponent 0.0714",
        domain: "motions near the band; far from it they diverge. The equilibrium inside the band requires c^2 > 4*a*b",
        source: "O. E. Rössler, Phys. Lett. A 57, 397 (1976), doi:10.1016/0375-9601(76)90101-8",
        ..NOTHING_SAID
    },
    NamedSystem {
        key: "lotka_volterra",
        also: &["predator_prey"],
        title: "Lotka and Volterra's predators and prey",
        equations: "x' = alpha*x - beta*x*y; y' = delta*x*y - gamma*y",
        coordinates: &[number("x", "gamma/delta"), number("y", "alpha/beta")],
        parameters: &[
            parameter("alpha", "1", "1/s", "growth rate of the prey alone"),
            parameter("beta", "1", "1/s", "rate of predation by one predator"),
            parameter("gamma", "1", "1/s", "death rate of predators without prey"),
            parameter("delta", "1", "1/s", "growth rate of predators per prey"),
        ],
        description: "x is the number of prey, y of predators, each in units of its own; delta*x - gamma*ln(x) + beta*y - alpha*ln(y) is conserved, so that every motion is periodic; small ones have the angular frequency sqrt(alpha*gamma)",
        domain: "x and y above zero, where they stay",
        source: "A. J. Lotka, Proc. Natl. Acad. Sci. 6, 410 (1920), doi:10.1073/pnas.6.7.410, and V. Volterra, Nature 118, 558 (1926), \
                 doi:10.1038/118558a0",
        ..NOTHING_SAID
    },
];
