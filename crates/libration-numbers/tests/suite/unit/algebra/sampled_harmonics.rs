use libration::algebra::{Rational, Rationals, Ring};
use libration::internals::algebra::primes_with_roots;
use libration::internals::algebra::{
    HarmonicPair, HarmonicSums, PhaseRing, PrimeFields, Residues, SampledHarmonics, Symmetry,
};

/// Coefficients with the symmetry, different for each seed.
fn terms(symmetry: Symmetry, seed: i64) -> Vec<(usize, HarmonicPair<i64>)> {
    let allowed = (0..6_usize)
        .filter(|k| !symmetry.half_wave || (seed.unsigned_abs().is_multiple_of(2)) == k.is_multiple_of(2));
    let sine = |k: i64| if symmetry.even_in_phase || k == 0 { 0 } else { seed - 2 * k };
    allowed.map(|k| (k, HarmonicPair { cosine: seed + 3 * k as i64, sine: sine(k as i64) })).collect()
}

#[test]
fn values_at_points_and_lists_of_coefficients_have_the_same_products() {
    let exact = HarmonicSums { numbers: Rationals };
    for (even_in_phase, half_wave) in [(false, false), (false, true), (true, false), (true, true)] {
        let symmetry = Symmetry { even_in_phase, half_wave };
        let mut primes = primes_with_roots(12);
        let field = PrimeFields::new(std::array::from_fn(|_| primes.next().unwrap()));
        let sampled = SampledHarmonics::new(field.clone(), 10, symmetry).unwrap();
        let in_lists = |seed| {
            let rational = |n| Rational::from(n);
            let list: Vec<_> = terms(symmetry, seed)
                .into_iter()
                .map(|(k, h)| (k, HarmonicPair { cosine: rational(h.cosine), sine: rational(h.sine) }))
                .collect();
            exact.sum_of_harmonics(&list)
        };
        let at_points = |seed| {
            let residue = |n| field.times_integer(&field.unit(), n);
            let list: Vec<_> = terms(symmetry, seed)
                .into_iter()
                .map(|(k, h)| (k, HarmonicPair { cosine: residue(h.cosine), sine: residue(h.sine) }))
                .collect();
            sampled.sum_of_harmonics(&list)
        };
        let product = exact.multiply(&in_lists(4), &in_lists(7));
        let sampled_product = sampled.multiply(&at_points(4), &at_points(7));
        for k in (0..=10).filter(|k| !half_wave || k % 2 == 1) {
            let (truth, computed) = (exact.harmonic(&product, k), sampled.harmonic(&sampled_product, k));
            assert_eq!(field.rational(&truth.cosine), Some(computed.cosine), "{symmetry:?} cos {k}");
            assert_eq!(field.rational(&truth.sine), Some(computed.sine), "{symmetry:?} sin {k}");
        }
    }
}

#[test]
fn sums_of_products_of_any_length_are_those_of_the_products() {
    let mut primes = primes_with_roots(12);
    let fields = PrimeFields::new(std::array::from_fn(|_| primes.next().unwrap()));
    let largest = fields.primes().map(|prime| prime - 1);
    let symmetry = Symmetry { even_in_phase: true, half_wave: true };
    let ring = SampledHarmonics::new(fields.clone(), 20, symmetry).unwrap();
    let element = |seed: u64| -> Vec<Residues> {
        let value = |j| if seed.is_multiple_of(2) { largest } else { fields.integer(seed * 1_000_003 + j) };
        if seed % 5 == 3 { vec![] } else { (0..ring.points() as u64).map(value).collect() }
    };
    for length in [0, 1, 3, 4, 5, 11, 40] {
        let (a, b): (Vec<_>, Vec<_>) = (0..length).map(|n| (element(n), element(n + 7))).unzip();
        let products = a.iter().zip(b.iter().rev()).map(|(a, b)| ring.multiply(a, b));
        let expected = products.fold(ring.zero(), |sum, product| ring.add(&sum, &product));
        let difference = ring.subtract(&ring.convolution(&a, &b), &expected);
        assert!(ring.is_zero(&difference), "{length}");
    }
}
