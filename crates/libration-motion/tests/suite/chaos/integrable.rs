//! Motions of integrable systems, many of them next to separatrices and unstable motions.

/// A system and a start.
pub(crate) struct Case {
    pub(crate) equation: String,
    pub(crate) start: Vec<f64>,
}

fn case(equation: &str, start: &[f64]) -> Case {
    Case { equation: equation.to_owned(), start: start.to_vec() }
}

/// Distances from a separatrix, including zero.
fn distances() -> impl Iterator<Item = f64> {
    (2..=16).map(|power| libm::exp10(-f64::from(power))).chain([0.0])
}

/// Pseudo-random numbers from 0 to 1.
fn spread(count: u32) -> impl Iterator<Item = f64> {
    (1..=count).map(|n| (f64::from(n) * 0.754_877_666_246_692_8).fract())
}

/// All cases.
pub(crate) fn cases() -> Vec<Case> {
    let all: [Vec<Case>; 6] =
        [next_to_separatrices(), disguised(), central(), lattices(), potentials(), linear()];
    all.into_iter().flatten().collect()
}

/// Motions of one coordinate, which are regular by a theorem.
fn next_to_separatrices() -> Vec<Case> {
    let pair = |d: f64| {
        let well = case("x'' = x - x^3", &[libm::sqrt(2.0) * (1.0 - d), 0.0]);
        [case("theta'' = -sin(theta)", &[core::f64::consts::PI - d, 0.0]), well]
    };
    distances().flat_map(pair).collect()
}

/// Systems of independent single coordinates, transformed to coupled or driven ones by rotated axes or a moving frame.
fn disguised() -> Vec<Case> {
    let of_distance = |d: f64| {
        let (top, edge) = (core::f64::consts::PI - d, libm::sqrt(2.0) * (1.0 - d));
        [
            // θ = x − t/2.
            case("x'' = -sin(x - t/2)", &[top, 0.5]),
            case("x'' = -sin(x - t/2)", &[0.0, 2.5 + d]),
            // θ = x + y and φ = x − y.
            case(
                "x'' = -(sin(x+y) + sin(x-y))/2; y'' = -(sin(x+y) - sin(x-y))/2",
                &[0.5 * (top + 1.0), 0.5 * (top - 1.0), 0.0, 0.0],
            ),
            // u = x + y and v = x − y, each in a double well.
            case(
                "x'' = x - x^3 - 3 x y^2; y'' = y - y^3 - 3 x^2 y",
                &[0.5 * (edge + 0.7), 0.5 * (edge - 0.7), 0.0, 0.0],
            ),
        ]
    };
    distances().flat_map(of_distance).collect()
}

/// Central forces in Cartesian coordinates.
fn central() -> Vec<Case> {
    // On the barrier of V = r²/2 − r⁴/4 + L²/2r² the circle r² = 1/2 + … is unstable: with r = 0.9 and
    // L² = r⁴(1 − r²) the motion leaves it slowly.
    let radius: f64 = 0.9;
    let circle = |d: f64| {
        let speed = radius * libm::sqrt(1.0 - radius * radius);
        case("x'' = -x*(1 - x^2 - y^2); y'' = -y*(1 - x^2 - y^2)", &[radius * (1.0 - d), 0.0, 0.0, speed])
    };
    let kepler = |part: f64| {
        case("x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2)", &[1.0, 0.0, 0.0, 0.3 + 0.9 * part])
    };
    let quartic = |part: f64| case("x'' = -x*(x^2 + y^2); y'' = -y*(x^2 + y^2)", &[1.0, 0.2, -0.3, part]);
    let spherical = |part: f64| {
        case(
            "a'' = sin(a) cos(a) b'^2 - sin(a); b'' = -2 a' b' cos(a)/sin(a)",
            &[0.4 + 2.0 * part, 0.0, 0.0, 0.8],
        )
    };
    let circles = distances().map(circle);
    let others = spread(8).flat_map(|part| [kepler(part), quartic(part), spherical(part)]);
    circles.chain(others).collect()
}

/// Toda's lattice of three particles without its centre of mass, and Calogero's inverse squares.
fn lattices() -> Vec<Case> {
    let toda = |part: f64| {
        case(
            "x'' = -sqrt(3)/12*(exp(2y + 2 sqrt(3) x) - exp(2y - 2 sqrt(3) x)); \
             y'' = -(exp(2y + 2 sqrt(3) x) + exp(2y - 2 sqrt(3) x) - 2 exp(-4y))/12",
            &[0.1, 0.4 * part, 1.5 * part, 0.3],
        )
    };
    let calogero =
        |part: f64| case("x'' = -x + 2/(x - y)^3; y'' = -y - 2/(x - y)^3", &[1.0 + part, -0.5, 0.2, part]);
    spread(8).flat_map(|part| [toda(part), calogero(part)]).collect()
}

/// The integrable potentials related to that of Hénon and Heiles, and to the quartic one.
fn potentials() -> Vec<Case> {
    let of_part = |part: f64| {
        [
            case("x'' = -x - 2 x y; y'' = -y - x^2 - y^2", &[0.3 * part, 0.1, 0.2, 0.3 * part]),
            case("x'' = -x - 2 x y; y'' = -16 y - x^2 - 16 y^2", &[0.2, 0.1 * part, 0.3 * part, 0.1]),
            case("x'' = -x - 2 x y; y'' = -2 y - x^2 - 6 y^2", &[0.1, 0.15 * part, 0.1, 0.1]),
            case(
                "x'' = -4 x^3 - 12 x y^2; y'' = -4 y^3 - 12 x^2 y",
                &[1.0, part * part * part, 0.0, 0.1 * part],
            ),
        ]
    };
    // The separatrix of u″ = −u − u² with u = x + y, next to v = x − y at 0.1; the unstable axis of the quartic potential.
    let of_distance = |d: f64| {
        let edge = 0.5 * (1.0 - d);
        [
            case(
                "x'' = -x - 2 x y; y'' = -y - x^2 - y^2",
                &[0.5 * (edge + 0.1), 0.5 * (edge - 0.1), 0.0, 0.0],
            ),
            case("x'' = -4 x^3 - 12 x y^2; y'' = -4 y^3 - 12 x^2 y", &[1.0, d, 0.0, 0.0]),
        ]
    };
    spread(6).flat_map(of_part).chain(distances().flat_map(of_distance)).collect()
}

/// Linear systems, damped and driven, whose motions are regular by a theorem.
fn linear() -> Vec<Case> {
    let of_part = |part: f64| {
        [
            case("x'' + 0.1 x' + x = cos(1.3 t)", &[part, 0.0]),
            case("x'' = -2 x + y; y'' = x - 2 y", &[part, 1.0, 0.0, 0.0]),
            case("x'' = -(1 + 0.4 cos(2 t))*x", &[part, 0.1]),
        ]
    };
    spread(4).flat_map(of_part).collect()
}
