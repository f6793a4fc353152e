use libration::algebra::{Rational, Rationals, Ring};
use libration::internals::perturbation::{HalfSwings, PhaseFunctions, Response, Sums};
use libration_numbers::internals::algebra::{HarmonicPair, PhaseRing};

fn ring() -> HalfSwings<Rationals> {
    HalfSwings::new(Rationals)
}

/// Σ ψᵖ·cos kψ over these p and k.
fn cosines(terms: &[(usize, usize, i64)]) -> Sums<Rationals> {
    let ring = ring();
    let mut sum = vec![ring.sums.zero(); 4];
    for &(p, k, factor) in terms {
        let cosine = ring.sums.numbers.term(0, Rational::from(factor));
        let pair = HarmonicPair { cosine, sine: ring.sums.numbers.zero() };
        sum[p] = ring.sums.add(&sum[p], &ring.sums.sum_of_harmonics(&[(k, pair)]));
    }
    sum
}

#[test]
fn a_response_obeys_the_oscillator_and_goes_on_at_the_opposite() {
    let ring = ring();
    let forcing = cosines(&[(0, 0, 3), (0, 1, -2), (1, 1, 5), (2, 2, 1), (3, 1, 7), (0, 3, 4)]);
    let Response { secular, forced } = ring.response(&forcing).unwrap();
    let slope = ring.slope(&forced);
    let left = ring.add(&ring.slope(&slope), &forced);
    let rest = ring.subtract(&forcing, &ring.wave(secular));
    assert!(ring.is_zero(&ring.subtract(&left, &rest)));
    for y in [&forced, &slope] {
        assert!(ring.sums.numbers.is_zero(&ring.gap(y).unwrap()));
    }
}

#[test]
fn a_constant_force_on_each_half_swing_has_the_first_harmonic_of_a_square_wave() {
    let Response { secular, .. } = ring().response(&cosines(&[(0, 0, 1)])).unwrap();
    let terms: Vec<_> = secular.sine.terms().map(|(p, c)| (p, c.to_string())).collect();
    assert_eq!(terms, [(-1, "4".to_owned())]);
    assert_eq!(secular.cosine.terms().count(), 0);
}
