//! Integrals along straight lines, to the accuracy of an `f64`.

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

/// The part of the integral of |f| that two rules may differ by.
const TOLERANCE: f64 = 4.0 * f64::EPSILON;
/// Intervals are halved so often at most.
const DEEPEST: u32 = 40;

/// The integral of a function from 0 to 1; NaN where it does not converge.
pub(super) fn integral(f: &mut impl FnMut(f64) -> f64) -> f64 {
    let whole = Rules::over(f, 0.0, 1.0);
    refined(f, 0.0, 1.0, whole, whole.size, DEEPEST)
}

/// Halves the interval until both rules agree.
fn refined(f: &mut impl FnMut(f64) -> f64, from: f64, to: f64, rules: Rules, size: f64, depth: u32) -> f64 {
    if (rules.kronrod - rules.gauss).abs() <= TOLERANCE * size {
        return rules.kronrod;
    }
    if depth == 0 || !rules.kronrod.is_finite() {
        return f64::NAN;
    }
    let middle = 0.5 * (from + to);
    let (left, right) = (Rules::over(f, from, middle), Rules::over(f, middle, to));
    let size = size.max(left.size + right.size);
    refined(f, from, middle, left, size, depth - 1) + refined(f, middle, to, right, size, depth - 1)
}

/// Both rules on an interval, and the first for |f|.
#[derive(Clone, Copy, Debug)]
struct Rules {
    kronrod: f64,
    gauss: f64,
    size: f64,
}

impl Rules {
    fn over(f: &mut impl FnMut(f64) -> f64, from: f64, to: f64) -> Self {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let mut rules = Self { kronrod: 0.0, gauss: 0.0, size: 0.0 };
        for (place, (node, kronrod, gauss)) in NODES.into_iter().enumerate() {
            let sides = if place == 0 { &[1.0][..] } else { &[-1.0, 1.0] };
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rules_integrate_the_powers_they_should() {
        for n in 0..=22_u32 {
            let rules = Rules::over(&mut |x| libm::pow(x, f64::from(n)), 0.0, 1.0);
            let exact = 1.0 / f64::from(n + 1);
            assert!((rules.kronrod - exact).abs() < 4e-16, "{n}: {}", rules.kronrod);
            assert!(n > 13 || (rules.gauss - exact).abs() < 4e-16, "{n}: {}", rules.gauss);
        }
    }

    #[test]
    fn hard_integrands_are_refined_and_endless_ones_given_up() {
        // ∫ dx/(1e-4 + x²) from 0 to 1.
        let exact = 100.0 * libm::atan(100.0);
        assert!((integral(&mut |x| 1.0 / (1e-4 + x * x)) / exact - 1.0).abs() < 1e-14);
        assert!(integral(&mut |x| 1.0 / (x - 1.0 / 3.0)).is_nan());
    }
}
