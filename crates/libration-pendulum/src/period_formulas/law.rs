//! The formulas, each written once for every kind of number. θ is the amplitude, c = cos(θ/2), k = sin(θ/2), s = √c, as in the publications.

use super::real::{Coefficients, Real};
use super::swing::Swing;

/// A formula for T/T0.
#[derive(Clone, Debug)]
pub enum Law {
    SmallAngle,
    /// A polynomial in θ².
    PowerSeries(Coefficients),
    /// One over a polynomial in θ².
    FourierPerturbation(Coefficients),
    /// A polynomial in k².
    SineSquared(Coefficients),
    /// A quotient of polynomials in θ².
    PadePower([Coefficients; 2]),
    /// A quotient of polynomials in k².
    PadeSineSquared([Coefficients; 2]),
    Molina,
    KiddFogg,
    Butikov,
    CarvalhaesSuppes,
    Belendez,
    CubicForce,
    GanleyParwani,
    LimaArun,
    Cromer,
    TwoTermLogarithm,
    Lima2008,
    Chachiyo,
    /// The inverse of the arithmetic mean after this many steps from 1 and c.
    ArithmeticMean(u8),
    /// The inverse of the geometric mean after two steps.
    SecondGeometricMean,
    NomeOneRoot,
    DescribingFunction,
}

impl Law {
    pub fn ratio<R: Real>(&self, swing: &Swing<R>) -> R {
        match self {
            Self::SmallAngle => swing.number(1),
            Self::PowerSeries(coefficients) => swing.amplitude.square().polynomial(coefficients),
            Self::FourierPerturbation(coefficients) => {
                swing.number(1) / swing.amplitude.square().polynomial(coefficients)
            }
            Self::SineSquared(coefficients) => swing.sin_half.square().polynomial(coefficients),
            Self::PadePower(of) => quotient(&swing.amplitude.square(), of),
            Self::PadeSineSquared(of) => quotient(&swing.sin_half.square(), of),
            Self::Molina => molina(swing),
            Self::KiddFogg => swing.number(1) / swing.cos_half.sqrt(),
            Self::Butikov => two_over_pi(swing) * (swing.number(8) / swing.complement.clone()).ln(),
            Self::CarvalhaesSuppes => carvalhaes_suppes(swing),
            Self::Belendez => belendez(swing),
            Self::CubicForce => cubic_force(swing),
            Self::GanleyParwani => ganley_parwani(swing),
            Self::LimaArun => lima_arun(swing),
            Self::Cromer => two_over_pi(swing) * logarithm(swing),
            Self::TwoTermLogarithm => two_term_logarithm(swing),
            Self::Lima2008 => lima_2008(swing),
            Self::Chachiyo => chachiyo(swing),
            Self::ArithmeticMean(steps) => swing.number(1) / means(swing, *steps).0,
            Self::SecondGeometricMean => swing.number(1) / means(swing, 2).1,
            Self::NomeOneRoot => nome_one_root(swing),
            Self::DescribingFunction => describing_function(swing),
        }
    }
}

fn quotient<R: Real>(variable: &R, [numerator, denominator]: &[Coefficients; 2]) -> R {
    variable.polynomial(numerator) / variable.polynomial(denominator)
}

fn two_over_pi<R: Real>(swing: &Swing<R>) -> R {
    swing.number(2) / swing.amplitude.pi()
}

/// ln(4/c), the leading behaviour of K at the top (DLMF 19.12.1).
fn logarithm<R: Real>(swing: &Swing<R>) -> R {
    (swing.number(4) / swing.cos_half.clone()).ln()
}

/// (θ/sin θ)^(3/8).
fn molina<R: Real>(swing: &Swing<R>) -> R {
    let sine = swing.number(2) * swing.sin_half.clone() * swing.cos_half.clone();
    let quotient = swing.amplitude.clone().over(sine);
    (quotient.ln() * swing.number(3) / swing.number(8)).exp()
}

/// 4/(1 + s)².
fn carvalhaes_suppes<R: Real>(swing: &Swing<R>) -> R {
    swing.number(4) / (swing.number(1) + swing.cos_half.sqrt()).square()
}

/// 64/(16(1 + s)² − (1 − s)⁴).
fn belendez<R: Real>(swing: &Swing<R>) -> R {
    let (one, s) = (swing.number(1), swing.cos_half.sqrt());
    let (sum, difference) = ((one.clone() + s.clone()).square(), (one - s).square());
    swing.number(64) / (swing.number(16) * sum - difference.square())
}

/// 1/√(1 − θ²/8).
fn cubic_force<R: Real>(swing: &Swing<R>) -> R {
    let one = swing.number(1);
    one.clone() / (one - swing.amplitude.square() / swing.number(8)).sqrt()
}

/// √(x/sin x), x = √3·θ/2.
fn ganley_parwani<R: Real>(swing: &Swing<R>) -> R {
    let x = swing.number(3).sqrt() * swing.amplitude.clone() / swing.number(2);
    let sine = x.sin();
    x.over(sine).sqrt()
}

/// −ln c/(1 − c), both from 1 − c so that nothing cancels at small amplitude.
fn lima_arun<R: Real>(swing: &Swing<R>) -> R {
    let versine = swing.versine_half();
    let logarithm =
        if swing.cos_half < swing.sin_half { swing.cos_half.ln() } else { (-versine.clone()).ln_1p() };
    (-logarithm).over(versine)
}

/// (2/π)[L + (L − 1)c²/4], L = ln(4/c).
fn two_term_logarithm<R: Real>(swing: &Swing<R>) -> R {
    let l = logarithm(swing);
    let correction = (l.clone() - swing.number(1)) * swing.cos_half.square() / swing.number(4);
    two_over_pi(swing) * (l + correction)
}

/// (r·c²·T₁ + k²·T₂)/(r·c² + k²), r = 7.17, T₁ = Lima and Arun's formula, T₂ = (2/π)ln(4/c).
fn lima_2008<R: Real>(swing: &Swing<R>) -> R {
    let low = swing.number(717) / swing.number(100) * swing.cos_half.square();
    let high = swing.sin_half.square();
    let top = two_over_pi(swing) * logarithm(swing);
    (low.clone() * lima_arun(swing) + high.clone() * top) / (low + high)
}

/// (2/(πn)) ln((4/c)ⁿ + b), with n and b such that the value and the slope at small amplitude are exact:
/// (4e^(−π/2))ⁿ = π/4 and 4ⁿ + b = e^(nπ/2).
fn chachiyo<R: Real>(swing: &Swing<R>) -> R {
    let (four, half_pi) = (swing.number(4), swing.amplitude.pi() / swing.number(2));
    let n = (half_pi.clone() / swing.number(2)).ln() / (four.ln() - half_pi.clone());
    let b = (n.clone() * half_pi).exp() - (n.clone() * four.ln()).exp();
    two_over_pi(swing) * ((n.clone() * logarithm(swing)).exp() + b).ln() / n
}

/// The arithmetic and the geometric mean after `steps` steps from 1 and c.
fn means<R: Real>(swing: &Swing<R>, steps: u8) -> (R, R) {
    let start = (swing.number(1), swing.cos_half.clone());
    (0..steps).fold(start, |(a, b), _| ((a.clone() + b.clone()) / swing.number(2), (a * b).sqrt()))
}

/// 4/(1 + s)²·(1 + 2q⁴)², q = λ + 2λ⁵, λ = (1 − s)/(2(1 + s)).
fn nome_one_root<R: Real>(swing: &Swing<R>) -> R {
    let (one, two, s) = (swing.number(1), swing.number(2), swing.cos_half.sqrt());
    let lambda = (one.clone() - s.clone()) / (two.clone() * (one.clone() + s));
    let nome = lambda.clone() + two.clone() * lambda.clone() * lambda.square().square();
    carvalhaes_suppes(swing) * (one + two * nome.square().square()).square()
}

/// √(θ/(2J₁(θ))), the Bessel function by its power series (DLMF 10.2.2), whose terms stay below 2 for θ < π.
fn describing_function<R: Real>(swing: &Swing<R>) -> R {
    let step = -(swing.amplitude.square() / swing.number(4));
    let (mut sum, mut term) = (swing.number(0), swing.number(1));
    for n in 1_i16..=i16::MAX / 2 {
        sum = sum + term.clone();
        term = term * step.clone() / (swing.number(n) * swing.number(n + 1));
        if term.is_negligible() {
            break;
        }
    }
    swing.number(1) / sum.sqrt()
}
