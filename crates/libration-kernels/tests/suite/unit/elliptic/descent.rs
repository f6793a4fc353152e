use libration::double_double::DoubleDouble;
use libration::internals::elliptic::{Descent, Nearer};
use libration_numbers::algebra::BigFloat;

const BITS: usize = 300;

fn big(x: DoubleDouble) -> BigFloat {
    BigFloat::from_words(x, BITS)
}

fn word(x: f64) -> BigFloat {
    big(DoubleDouble::from(x))
}

fn relative(got: DoubleDouble, exact: &BigFloat) -> f64 {
    ((big(got) - exact.clone()) / exact.clone()).to_f64().abs()
}

/// Smaller parameters of every size; many are next to one half, where the series converge most slowly.
fn parameters() -> impl Iterator<Item = f64> {
    (1..=200)
        .map(|i| (f64::from(i) * 0.618_033_988_749_894_8).fract())
        .flat_map(|x| [0.5 * x, 0.5 - 0.01 * x, libm::exp10(-100.0 * x), libm::exp10(-200.0 - 100.0 * x)])
}

fn quarter(complementary: BigFloat) -> BigFloat {
    BigFloat::pi(BITS).halved() / word(1.0).agm(&complementary)
}

#[test]
fn quarter_periods_and_nome_are_good_to_a_hundred_and_two_bits() {
    for m in parameters().chain([0.5, 0.5_f64.next_down(), 1e-200, 1e-200_f64.next_down()]) {
        let nearer = Nearer::from_parameter(m);
        let descent = Descent::new(&nearer);
        let log = descent.log_inverse_nome(nearer.raised);
        let (near, far) = (quarter((word(1.0) - word(m)).sqrt()), quarter(word(m).sqrt()));
        let exact_log = BigFloat::pi(BITS) * far.clone() / near.clone();
        let nome = (word(0.0) - exact_log.clone()).exp();
        let raise = word(nearer.lowering());
        let nome_raised = nome.clone() / (raise.clone() * raise);
        let [root, precise_root] = [Descent::root_of_nome, Descent::precise_root_of_nome]
            .map(|root| relative(root(&descent, nearer.lowering()), &nome.clone().sqrt()));
        // The second word may be below the smallest number.
        let short = [relative(descent.nome(), &nome_raised), if m > 1e-200 { root } else { 0.0 }];
        assert!(short.iter().all(|error| *error < libm::exp2(-69.0)), "{m:e}: {short:?}");
        let errors = [
            relative(descent.near_quarter(), &near),
            relative(descent.near_frequency(), &(word(0.25) / near.clone())),
            relative(log, &exact_log),
            relative(Descent::far_quarter(descent.near_quarter(), log), &far),
            relative(descent.far_frequency(log), &(word(0.25) / far)),
            if m > 1e-200 { precise_root } else { 0.0 },
        ];
        for error in errors {
            assert!(error < libm::exp2(-102.0), "{m:e}: {errors:?}");
        }
    }
}
