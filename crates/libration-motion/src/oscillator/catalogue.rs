//! The named oscillators with their descriptions and sources. Attributions from memory are marked as such.

use super::named::NamedOscillator;
use libration_numbers::{
    catalogue::{NamedParameter, UnknownKey},
    internals::catalogue::by_key,
};

const NONE: &[NamedParameter] = &[];
const MU: &[NamedParameter] = &[NamedParameter {
    name: "mu",
    default: "1",
    unit: "",
    meaning: "strength of the self-excitation, left open for expansions",
}];

pub(super) static CATALOGUE: [NamedOscillator; 20] = [
    NamedOscillator {
        key: "pendulum",
        also: &["simple_pendulum"],
        title: "simple pendulum",
        equation: "theta'' + omega0^2*sin(theta) = 0",
        parameters: &[NamedParameter {
            name: "omega0",
            default: "1",
            unit: "",
            meaning: "frequency of small swings, sqrt(g/l)",
        }],
        expansion_parameter: None,
        description: "a mass on a rigid massless rod under gravity",
        domain: "amplitudes below pi",
        source: "B. Black and V. Vel, Am. J. Phys. 91, 776 (2023), doi:10.1119/5.0130943; attributed to Huygens, Horologium Oscillatorium \
                 (1673); not verified against the original",
    },
    NamedOscillator {
        key: "duffing",
        also: &["duffing_hard"],
        title: "Duffing oscillator",
        equation: "x'' + x + epsilon*x^3 = 0",
        parameters: &[NamedParameter {
            name: "epsilon",
            default: "1",
            unit: "",
            meaning: "strength of the cubic force, soft below zero",
        }],
        expansion_parameter: None,
        description: "a spring that stiffens in proportion to the square of its extension",
        domain: "all amplitudes for epsilon > 0; below 1/sqrt(-epsilon) for epsilon < 0",
        source: "G. Duffing, Erzwungene Schwingungen bei veränderlicher Eigenfrequenz und ihre technische Bedeutung, Vieweg, Braunschweig \
                 (1918)",
    },
    NamedOscillator {
        key: "duffing_soft",
        also: &[],
        title: "soft Duffing oscillator",
        equation: "x'' + x + epsilon*x^3 = 0",
        parameters: &[NamedParameter {
            name: "epsilon",
            default: "-1",
            unit: "",
            meaning: "strength of the cubic force, below zero",
        }],
        expansion_parameter: None,
        description: "a spring that softens in proportion to the square of its extension",
        domain: "amplitudes below 1/sqrt(-epsilon)",
        source: "G. Duffing, Erzwungene Schwingungen bei veränderlicher Eigenfrequenz und ihre technische Bedeutung, Vieweg, Braunschweig \
                 (1918)",
    },
    NamedOscillator {
        key: "double_well",
        also: &["duffing_double_well"],
        title: "double-well Duffing oscillator",
        equation: "x'' - x + x^3 = 0",
        parameters: NONE,
        expansion_parameter: None,
        description: "two wells at -1 and 1 with a barrier between them; expanded about the well at 1",
        domain: "0 < x < sqrt(2), energies below the barrier",
        source: "attributed to F. C. Moon and P. J. Holmes, J. Sound Vib. 65, 275 (1979), doi:10.1016/0022-460X(79)90520-0; not verified \
                 against the original",
    },
    NamedOscillator {
        key: "cubic_quintic",
        also: &["cubic_quintic_duffing"],
        title: "cubic-quintic Duffing oscillator",
        equation: "x'' + x + alpha*x^3 + beta*x^5 = 0",
        parameters: &[
            NamedParameter { name: "alpha", default: "1", unit: "", meaning: "strength of the cubic force" },
            NamedParameter { name: "beta", default: "1", unit: "", meaning: "strength of the quintic force" },
        ],
        expansion_parameter: None,
        description: "a spring with cubic and quintic corrections",
        domain: "all amplitudes for positive alpha and beta",
        source: "attributed to M. N. Hamdan and N. H. Shabaneh, J. Sound Vib. 199, 711 (1997); not verified against the original",
    },
    NamedOscillator {
        key: "pure_cubic",
        also: &[],
        title: "purely cubic oscillator",
        equation: "x'' + x^3 = 0",
        parameters: NONE,
        expansion_parameter: None,
        description: "a force without linear part: the period is Gamma(1/4)^2/(sqrt(pi)*A), and there is no expansion about rest",
        domain: "all amplitudes, but omega0 = 0",
        source: "attributed to R. E. Mickens, Oscillations in Planar Dynamic Systems, World Scientific (1996); not verified against the \
                 original",
    },
    NamedOscillator {
        key: "quadratic",
        also: &["helmholtz"],
        title: "quadratic (Helmholtz) oscillator",
        equation: "x'' + x + alpha*x^2 = 0",
        parameters: &[NamedParameter {
            name: "alpha",
            default: "1",
            unit: "",
            meaning: "strength of the quadratic force",
        }],
        expansion_parameter: None,
        description: "the simplest asymmetric well; the motion has a constant offset and all harmonics",
        domain: "energies below 1/(6*alpha^2); for alpha = 1 turning points between -1 and 1/2",
        source: "H. von Helmholtz, Die Lehre von den Tonempfindungen (1863), in English On the Sensations of Tone, appendix XII",
    },
    NamedOscillator {
        key: "helmholtz_duffing",
        also: &[],
        title: "Helmholtz-Duffing oscillator",
        equation: "x'' + x + alpha*x^2 + beta*x^3 = 0",
        parameters: &[
            NamedParameter {
                name: "alpha",
                default: "1",
                unit: "",
                meaning: "strength of the quadratic force",
            },
            NamedParameter { name: "beta", default: "1", unit: "", meaning: "strength of the cubic force" },
        ],
        expansion_parameter: None,
        description: "an asymmetric spring with a quadratic and a cubic force",
        domain: "all amplitudes while 4*beta > alpha^2",
        source: "attributed to I. Kovacic and M. J. Brennan (eds.), The Duffing Equation, Wiley (2011), doi:10.1002/9780470977859; not \
                 verified against the original",
    },
    NamedOscillator {
        key: "relativistic",
        also: &["relativistic_oscillator"],
        title: "relativistic harmonic oscillator",
        equation: "x'' = -x*(1 - x'^2/c^2)^(3/2)",
        parameters: &[NamedParameter {
            name: "c",
            default: "1",
            unit: "",
            meaning: "speed of light in units of length times omega0",
        }],
        expansion_parameter: None,
        description: "a mass on a linear spring whose momentum is that of special relativity",
        domain: "all amplitudes; the series in A^2 converge below 4*c^2",
        source: "attributed to R. E. Mickens, J. Sound Vib. 212, 905 (1998); not verified against the original",
    },
    NamedOscillator {
        key: "x_over_sqrt",
        also: &["stretched_wire"],
        title: "oscillator x/sqrt(1 + x^2)",
        equation: "x'' + x/sqrt(1 + x^2) = 0",
        parameters: NONE,
        expansion_parameter: None,
        description: "a force that is linear at small and constant at large displacements; the momentum of the relativistic oscillator obeys it",
        domain: "all amplitudes; the series in A^2 converge below 1",
        source: "attributed to R. E. Mickens, J. Sound Vib. 212, 905 (1998); not verified against the original",
    },
    NamedOscillator {
        key: "x_over_one_plus_square",
        also: &["logarithmic_well"],
        title: "oscillator x/(1 + x^2)",
        equation: "x'' + x/(1 + x^2) = 0",
        parameters: NONE,
        expansion_parameter: None,
        description: "the logarithmic well ln(1 + x^2)/2: a force that is linear at small displacements and falls off as 1/x",
        domain: "all amplitudes; the series in A^2 converge below 1",
        source: "no single source: the regularised field of a line of charge",
    },
    NamedOscillator {
        key: "sinh",
        also: &[],
        title: "sinh oscillator",
        equation: "x'' + sinh(x) = 0",
        parameters: NONE,
        expansion_parameter: None,
        description: "the pendulum at imaginary angles: its series are the pendulum's with the signs of A^2 changed",
        domain: "all amplitudes; the series converge below pi",
        source: "no single source: the pendulum's equation with i*theta in place of theta",
    },
    NamedOscillator {
        key: "morse",
        also: &[],
        title: "Morse oscillator",
        equation: "x'' = exp(-2*x) - exp(-x)",
        parameters: NONE,
        expansion_parameter: None,
        description: "the stretching of a diatomic molecule that can dissociate; its frequency is exactly sqrt(1 - 2*E)",
        domain: "energies below the dissociation, E < 1/2",
        source: "P. M. Morse, Phys. Rev. 34, 57 (1929), doi:10.1103/PhysRev.34.57",
    },
    NamedOscillator {
        key: "toda",
        also: &[],
        title: "Toda oscillator",
        equation: "x'' + exp(x) - 1 = 0",
        parameters: NONE,
        expansion_parameter: None,
        description: "one particle of the Toda lattice; also a laser's relaxation oscillations without damping",
        domain: "all energies",
        source: "with the potential of M. Toda, J. Phys. Soc. Jpn. 22, 431 (1967), doi:10.1143/JPSJ.22.431",
    },
    NamedOscillator {
        key: "rotating_hoop",
        also: &["bead_on_hoop"],
        title: "pendulum on a rotating hoop",
        equation: "theta'' + (1 - gamma*cos(theta))*sin(theta) = 0",
        parameters: &[NamedParameter {
            name: "gamma",
            default: "1/2",
            unit: "",
            meaning: "square of the hoop's rate over g/R",
        }],
        expansion_parameter: None,
        description: "a bead on a hoop that turns about its vertical diameter; it leaves the bottom for gamma > 1",
        domain: "up to the turning point at the top; for gamma > 1 within one of the two wells",
        source: "S. H. Strogatz, Nonlinear Dynamics and Chaos (1994), section 3.5, here without damping",
    },
    NamedOscillator {
        key: "mathews_lakshmanan",
        also: &[],
        title: "Mathews-Lakshmanan oscillator",
        equation: "(1 + lambda*x^2)*x'' - lambda*x*x'^2 + x = 0",
        parameters: &[NamedParameter {
            name: "lambda",
            default: "1",
            unit: "",
            meaning: "dependence of the mass on the position",
        }],
        expansion_parameter: None,
        description: "a mass that depends on the position; x = A*cos(Omega*t) solves it exactly with Omega^2 = 1/(1 + lambda*A^2)",
        domain: "all amplitudes for lambda > 0; below 1/sqrt(-lambda) for lambda < 0",
        source: "attributed to P. M. Mathews and M. Lakshmanan, Quart. Appl. Math. 32, 215 (1974); equation (1.2) of arXiv:1407.8390; not \
                 verified against the original",
    },
    NamedOscillator {
        key: "linear",
        also: &["harmonic"],
        title: "harmonic oscillator",
        equation: "x'' + omega0^2*x = 0",
        parameters: &[NamedParameter { name: "omega0", default: "1", unit: "", meaning: "frequency" }],
        expansion_parameter: None,
        description: "a linear spring: every correction vanishes",
        domain: "all amplitudes",
        source: "the force of a spring: R. Hooke, Lectures de Potentia Restitutiva, or of Spring (1678)",
    },
    NamedOscillator {
        key: "van_der_pol",
        also: &["vdp"],
        title: "Van der Pol oscillator",
        equation: "x'' - mu*(1 - x^2)*x' + x = 0",
        parameters: MU,
        expansion_parameter: Some("mu"),
        description: "a circuit that feeds small oscillations and damps large ones, so that a limit cycle of amplitude near 2 remains",
        domain: "the limit cycle, by powers of mu",
        source: "B. van der Pol, Phil. Mag. 2, 978 (1926), doi:10.1080/14786442608564127",
    },
    NamedOscillator {
        key: "rayleigh",
        also: &[],
        title: "Rayleigh oscillator",
        equation: "x'' - mu*(x' - x'^3/3) + x = 0",
        parameters: MU,
        expansion_parameter: Some("mu"),
        description: "a maintained vibration, as of a reed or a string that is bowed; its velocity obeys Van der Pol's equation",
        domain: "the limit cycle, by powers of mu",
        source: "Lord Rayleigh, Phil. Mag. 15, 229 (1883), scaled as is usual today",
    },
    NamedOscillator {
        key: "rayleigh_cubic",
        also: &[],
        title: "Rayleigh oscillator without the third",
        equation: "x'' - mu*(x' - x'^3) + x = 0",
        parameters: MU,
        expansion_parameter: Some("mu"),
        description: "the same with the amplitude in other units: near 2/sqrt(3), which is irrational",
        domain: "the limit cycle, by powers of mu",
        source: "Lord Rayleigh, Phil. Mag. 15, 229 (1883), scaled without the third",
    },
];

/// Every oscillator of the catalogue.
#[must_use]
pub fn catalogue() -> &'static [NamedOscillator] {
    &CATALOGUE
}

impl NamedOscillator {
    /// The oscillator of this key.
    ///
    /// # Errors
    /// No oscillator has this key; the error lists the nearest keys and all keys.
    pub fn by_key(key: &str) -> Result<&'static Self, UnknownKey> {
        by_key(CATALOGUE.iter(), key)
    }
}
