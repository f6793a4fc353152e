//! Integrals to many digits, also of integrands that are infinite at an end, with steps that are halved
//! until nothing changes; the library's quadrature for `f64`s uses a fixed number of nodes instead.

use std::sync::OnceLock;

use super::precision::PRECISION;
use crate::evaluate::EvaluationError;
use libration::algebra::BigFloat;

/// Maximum number of halvings of the step.
const LEVELS: usize = 10;

/// Bits of the distance from an end that are not used.
const SPARED: isize = 40;

/// The nodes that each halving adds.
static NODES: [OnceLock<Vec<Node>>; LEVELS] = [const { OnceLock::new() }; LEVELS];

/// ∫ by the double exponential substitution x = 1/(1 + exp(−π sinh t)), which maps the ends to infinity so fast that the trapezoidal rule
/// converges exponentially. An integrand like 1/√x at an end costs half of the digits.
///
/// Reference: H. Takahasi and M. Mori, Publ. RIMS 9, 721 (1974), doi:10.2977/prims/1195192451.
pub(super) fn integral(
    from: &BigFloat,
    to: &BigFloat,
    integrand: &mut dyn FnMut(BigFloat) -> Result<BigFloat, EvaluationError>,
) -> Result<BigFloat, EvaluationError> {
    let width = to.clone() - from.clone();
    let (mut sum, mut estimate) = (number(0), number(0));
    for (level, kept) in NODES.iter().enumerate() {
        for node in kept.get_or_init(|| nodes(level)) {
            let x = from.clone() + width.clone() * node.point.clone();
            sum = sum + integrand(x)? * node.weight.clone();
        }
        let refined = sum.clone() * step(level) * width.clone();
        if agree(&refined, &estimate) {
            return Ok(refined);
        }
        estimate = refined;
    }
    Err(EvaluationError::Divergent("the integral"))
}

fn number(value: i64) -> BigFloat {
    BigFloat::from_integer(value, PRECISION)
}

/// 1/2, 1/4, 1/8, ….
fn step(level: usize) -> BigFloat {
    (0..level).fold(number(1).halved(), |step, _| step.halved())
}

/// The multiples of the step on both sides; after the first level only the odd ones.
fn nodes(level: usize) -> Vec<Node> {
    let stride = if level == 0 { 1 } else { 2 };
    let on_side = |side: i64| {
        let at = move |n: i64| Node::new(step(level) * number(side * n));
        (1..).step_by(stride).map(at).take_while(|node| !node.is_at_the_end())
    };
    let middle = (level == 0).then(|| Node::new(number(0)));
    middle.into_iter().chain(on_side(1)).chain(on_side(-1)).collect()
}

/// A point in the unit interval and its weight.
#[derive(Debug)]
struct Node {
    point: BigFloat,
    weight: BigFloat,
}

impl Node {
    fn new(t: BigFloat) -> Self {
        let one = number(1);
        let (up, down) = (t.exp(), (-t).exp());
        let pi = BigFloat::pi(PRECISION);
        let slope = pi.clone() * (up.clone() + down.clone()).halved();
        let decay = (-(pi * (up - down).halved())).exp();
        let point = one.clone() / (one.clone() + decay.clone());
        let weight = slope * point.clone() * point.clone() * decay;
        Self { point, weight }
    }

    /// Returns `true` if the point is so close to 0 or 1 that an integrand may lose its
    /// last bits there. The part cut off is below 2⁻¹⁰⁷ for an integrand like 1/√x.
    fn is_at_the_end(&self) -> bool {
        let bits = isize::try_from(PRECISION).unwrap_or(isize::MAX);
        let near = |distance: BigFloat| distance.exponent().is_none_or(|exponent| exponent < SPARED - bits);
        near(self.point.clone()) || near(number(1) - self.point.clone())
    }
}

/// Returns `true` if two steps agree to three eighths of the digits: the better one has
/// nearly twice as many correct digits, and is then as accurate as a singular end allows.
fn agree(a: &BigFloat, b: &BigFloat) -> bool {
    let bits = isize::try_from(PRECISION * 3 / 8).unwrap_or(isize::MAX);
    match ((a.clone() - b.clone()).exponent(), a.exponent()) {
        (None, _) => true,
        (Some(difference), Some(size)) => size - difference >= bits,
        (Some(_), None) => false,
    }
}
