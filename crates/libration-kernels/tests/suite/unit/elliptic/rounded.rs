use libration::double_double::DoubleDouble;
use libration::internals::elliptic::{Nearer, first, leg, second};
use libration_numbers::algebra::BigFloat;

const BITS: usize = 300;

fn word(x: f64) -> BigFloat {
    BigFloat::from_f64(x, BITS).unwrap()
}

/// K and E of the complementary modulus, by the arithmetic–geometric mean (DLMF 19.8.5 and 6).
fn exact(complementary: &BigFloat) -> [BigFloat; 2] {
    let (mut a, mut b) = (word(1.0), complementary.clone());
    let mut sum = (word(1.0) - b.clone() * b.clone()).halved();
    let mut power = word(0.5);
    for _ in 0..60 {
        let difference = (a.clone() - b.clone()).halved();
        power = power.clone() + power;
        sum = sum + power.clone() * difference.clone() * difference.clone();
        if difference.exponent().is_none_or(|exponent| exponent < -200) {
            break;
        }
        (a, b) = ((a.clone() + b.clone()).halved(), (a * b).sqrt());
    }
    let first = BigFloat::pi(BITS).halved() / a;
    [first.clone(), first * (word(1.0) - sum)]
}

/// The error in units in the last place of the truth.
fn error(computed: f64, truth: &BigFloat) -> f64 {
    let nearest = truth.to_f64();
    ((word(computed) - truth.clone()) / word(nearest.next_up() - nearest)).to_f64().abs()
}

fn worst(nearer: &Nearer, p: BigFloat) -> f64 {
    let complementary = if nearer.above { p } else { word(1.0) - p }.sqrt();
    let [k, e] = exact(&complementary);
    let (a, b) = (error(first(nearer), &k), error(second(nearer), &e));
    a.max(b)
}

/// Parameters of every size on both sides; many are next to one half, where the series converge most slowly.
#[test]
fn k_and_e_are_rounded_from_six_more_hundredths() {
    let sizes = (1..=3000).flat_map(|i| {
        let x = (f64::from(i) * 0.618_033_988_749_894_8).fract();
        [0.5 * x, 0.5 - 0.05 * x, libm::exp10(-20.0 * x), libm::exp10(-300.0 * x)]
    });
    let mut largest = 0.0_f64;
    for p in sizes.filter(|p| *p <= 0.5).chain([
        0.5,
        0.5_f64.next_down(),
        1e-200,
        1e-200_f64.next_down(),
        1e-308,
        5e-324,
    ]) {
        for nearer in [Nearer::from_parameter(p), Nearer::from_complementary_parameter(p)] {
            largest = largest.max(worst(&nearer, word(p)));
        }
    }
    assert!(largest < 0.56, "{largest}");
}

/// Parameters in two words, computed from moduli.
#[test]
fn the_second_word_of_the_parameter_counts() {
    let mut largest = 0.0_f64;
    for i in 1..=3000 {
        let k = 0.707_106_781_186_547_5 * (f64::from(i) * 0.618_033_988_749_894_8).fract();
        for k in [k, 0.707_106_781_186_547_5 - 0.02 * k] {
            let words = [DoubleDouble::from(k), leg(DoubleDouble::from(k))];
            let p = word(k) * word(k);
            for nearer in [Nearer::from_words(words[0], words[1]), Nearer::from_words(words[1], words[0])] {
                largest = largest.max(worst(&nearer, p.clone()));
            }
        }
    }
    assert!(largest < 0.56, "{largest}");
}

#[test]
fn ends_have_their_limits() {
    let [bottom, top] = [Nearer::from_parameter(0.0), Nearer::from_parameter(1.0)];
    let computed = [first(&bottom), second(&bottom), first(&top), second(&top)].map(f64::to_bits);
    let right = std::f64::consts::FRAC_PI_2;
    assert_eq!(computed, [right, right, f64::INFINITY, 1.0].map(f64::to_bits));
    // The parameter is below the smallest number but the modulus is not: ln 4 + 170·ln 10.
    let small = DoubleDouble::from(1e-170);
    let next_to_top = Nearer::from_words(DoubleDouble::ONE, small);
    assert!((first(&next_to_top) - 392.8257601701077).abs() < 1e-12);
    assert_eq!(second(&next_to_top).to_bits(), 1.0_f64.to_bits());
}
