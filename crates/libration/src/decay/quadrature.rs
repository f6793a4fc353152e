//! Integrals from zero to one: by Gauss' rule where the function is analytic, by the double exponential rule where it is
//! a power at zero.

/// The positive nodes of Gauss' rule of 16 points on (−1, 1) with their weights, computed by mpmath.
const GAUSS: [(f64, f64); 8] = [
    (0.095012509837637440185, 0.18945061045506849629),
    (0.28160355077925891323, 0.18260341504492358887),
    (0.45801677765722738634, 0.16915651939500253819),
    (0.61787624440264374845, 0.14959598881657673208),
    (0.7554044083550030339, 0.12462897125553387205),
    (0.86563120238783174388, 0.09515851168249278481),
    (0.94457502307323257608, 0.062253523938647892863),
    (0.9894009349916499326, 0.027152459411754094852),
];

/// ∫₀¹ f(x) dx of a function that is analytic well beyond the ends.
pub(super) fn gauss(f: impl Fn(f64) -> f64) -> f64 {
    let pair = |&(node, weight): &(f64, f64)| weight * (f(0.5 - 0.5 * node) + f(0.5 + 0.5 * node));
    0.5 * GAUSS.iter().map(pair).sum::<f64>()
}

/// The distance of neighbouring points of the double exponential rule, and how many there are on each side.
const STEP: f64 = 0.0625;
const POINTS: i32 = 56;

/// ∫₀¹ f(x) dx of a function that is analytic between the ends and no worse at them than x to a power above −1.
///
/// Reference: H. Takahasi and M. Mori, Publ. RIMS 9, 721 (1974), doi:10.2977/prims/1195192451.
pub(super) fn double_exponential(f: impl Fn(f64) -> f64) -> f64 {
    use std::f64::consts::PI;
    let term = |point: i32| {
        let s = STEP * f64::from(point);
        // x/(1 − x) = e^(π sinh s), so that small x are as good as any.
        let ratio = libm::exp(PI * libm::sinh(s));
        let (x, rest) = (ratio / (1.0 + ratio), 1.0 / (1.0 + ratio));
        PI * libm::cosh(s) * x * rest * f(x)
    };
    STEP * (-POINTS..=POINTS).map(term).sum::<f64>()
}
