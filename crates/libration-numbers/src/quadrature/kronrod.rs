//! Adaptive Gauss–Kronrod rules, for functions that may have kinks, roots and jumps.

use super::Integral;

/// Nodes of the Gauss–Kronrod rule of 15 points on [−1, 1] with their weights, and the weights of the Gauss rule of 7
/// points. Source: R. Piessens et al., QUADPACK, Springer 1983, there to 33 digits.
const NODES: [(f64, f64, f64); 8] = [
    (0.0, 0.209_482_141_084_727_83, 0.417_959_183_673_469_4),
    (0.207_784_955_007_898_47, 0.204_432_940_075_298_9, 0.0),
    (0.405_845_151_377_397_17, 0.190_350_578_064_785_4, 0.381_830_050_505_118_94),
    (0.586_087_235_467_691_1, 0.169_004_726_639_267_9, 0.0),
    (0.741_531_185_599_394_4, 0.140_653_259_715_525_92, 0.279_705_391_489_276_67),
    (0.864_864_423_359_769_1, 0.104_790_010_322_250_18, 0.0),
    (0.949_107_912_342_758_5, 0.063_092_092_629_978_55, 0.129_484_966_168_869_7),
    (0.991_455_371_120_812_6, 0.022_935_322_010_529_225, 0.0),
];

/// Difference of the two rules, relative to the integral of |f|, that counts as zero.
const TOLERANCE: f64 = 4.0 * f64::EPSILON;
/// Ratio of the differences after and before the halving of an interval above which the halving gained nothing, so that the difference is
/// rounding or a jump. For smooth functions the ratio is 2⁻¹⁴, for a kink a quarter, for a square root 2^−1.5.
const NO_GAIN: f64 = 0.5;
/// Number of times that an interval and its parts may be halved without gain, since a kink may lie next to the middle by chance. A later gain
/// does not restore the number, or noise would be halved without end.
const PATIENCE: u32 = 3;
/// Maximum number of intervals, enough to halve one of them down to the last digit, as a jump requires.
const MOST_INTERVALS: usize = 64;
/// Error, relative to the integral of |f|, above which the value is NaN. Next to a pole a few per cent stay uncertain however small the
/// intervals are; noise has as large an error only if the integrand is nothing but noise.
const DOUBTFUL: f64 = 1e-2;

/// ∫₀¹ f(x) dx by Gauss–Kronrod rules of 7 and 15 points. The interval whose rules differ most is halved, as long as that helps: intervals with
/// kinks and roots become very short, while noise costs little more than a smooth function. If a few per cent of ∫|f| remain uncertain, as next
/// to a pole, the value is NaN.
///
/// # Accuracy
/// `error` is the sum of the differences of the rules, or zero if that is below 4ε∫|f|. At most 64 intervals are formed, so that the function is
/// evaluated at most 1905 times.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quadrature::gauss_kronrod;
/// let kink = gauss_kronrod(|x| (x - 1.0 / 3.0).abs());
/// assert!((kink.value - 5.0 / 18.0).abs() < 1e-15);
/// assert!(gauss_kronrod(|x| 1.0 / (x - 1.0 / 3.0)).value.is_nan());
/// ```
///
/// # References
/// R. Piessens et al., QUADPACK, Springer 1983, doi:10.1007/978-3-642-61786-7.
pub fn gauss_kronrod(mut f: impl FnMut(f64) -> f64) -> Integral {
    let f = &mut f;
    let mut parts = vec![Subinterval::new(Rules::over(f, 0.0, 1.0), [0.0, 1.0], PATIENCE)];
    loop {
        let size: f64 = parts.iter().map(|part| part.rules.size).sum();
        let error: f64 = parts.iter().map(|part| part.rules.difference()).sum();
        if error <= TOLERANCE * size {
            return Integral { value: total(&parts), error: 0.0 };
        }
        let worst = (0..parts.len())
            .filter(|&part| parts[part].patience > 0)
            .max_by(|&a, &b| parts[a].rules.difference().total_cmp(&parts[b].rules.difference()));
        match worst {
            // An integral that is not finite cannot be improved.
            _ if !size.is_finite() => return Integral { value: f64::NAN, error },
            Some(worst) if parts.len() < MOST_INTERVALS => {
                let halves = parts.swap_remove(worst).halves(f);
                parts.extend(halves);
            }
            _ => {
                let value = if error <= DOUBTFUL * size { total(&parts) } else { f64::NAN };
                return Integral { value, error };
            }
        }
    }
}

fn total(parts: &[Subinterval]) -> f64 {
    parts.iter().map(|part| part.rules.kronrod).sum()
}

/// A part of the whole interval.
#[derive(Clone, Copy, Debug)]
struct Subinterval {
    rules: Rules,
    ends: [f64; 2],
    /// Number of times that the part may still be halved without gain.
    patience: u32,
}

impl Subinterval {
    fn new(rules: Rules, ends: [f64; 2], patience: u32) -> Self {
        Self { rules, ends, patience }
    }

    fn halves(self, f: &mut impl FnMut(f64) -> f64) -> [Self; 2] {
        let [from, to] = self.ends;
        let middle = 0.5 * (from + to);
        let (left, right) = (Rules::over(f, from, middle), Rules::over(f, middle, to));
        let gained = left.difference() + right.difference() <= NO_GAIN * self.rules.difference();
        let patience = if gained { self.patience } else { self.patience - 1 };
        [Self::new(left, [from, middle], patience), Self::new(right, [middle, to], patience)]
    }
}

/// Results of both rules on an interval, and of the Kronrod rule for |f|.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Rules {
    pub kronrod: f64,
    pub gauss: f64,
    size: f64,
}

impl Rules {
    /// Magnitude of the difference of the rules.
    fn difference(&self) -> f64 {
        (self.kronrod - self.gauss).abs()
    }

    pub fn over(f: &mut impl FnMut(f64) -> f64, from: f64, to: f64) -> Self {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let mut rules = Self { kronrod: 0.0, gauss: 0.0, size: 0.0 };
        for (index, (node, kronrod, gauss)) in NODES.into_iter().enumerate() {
            let sides = if index == 0 { &[1.0][..] } else { &[-1.0, 1.0] };
            for side in sides {
                let value = half * f(middle + side * half * node);
                rules.kronrod += kronrod * value;
                rules.gauss += gauss * value;
                rules.size += kronrod * value.abs();
            }
        }
        rules
    }
}
