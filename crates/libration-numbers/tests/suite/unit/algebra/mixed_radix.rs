use dashu_int::{IBig, UBig};
use libration::internals::algebra::primes_with_roots;
use libration::internals::algebra::{CONFIRMING_PRIMES, LANES, MixedRadix};

fn radix(primes: usize) -> MixedRadix {
    let mut radix = MixedRadix::default();
    primes_with_roots(12).take(primes).for_each(|prime| radix.push(prime));
    radix
}

#[test]
fn integers_of_either_sign_come_back_until_the_primes_run_out() {
    let radix = radix(12);
    let one = radix.residues(&UBig::ONE);
    let negative = |value: &UBig| {
        let residues = radix.residues(value).into_iter().zip(&radix.places);
        residues.map(|(a, place)| place.field.difference(0, a)).collect::<Vec<u32>>()
    };
    for power in [0, 1, 29, 30, 31, 59, 60, 61, 180, 206] {
        for value in [(UBig::ONE << power) - 1_u8, UBig::ONE << power, (UBig::ONE << power) + 1_u8] {
            let (plus, minus) = (radix.residues(&value), negative(&value));
            let digits =
                radix.digits(|k| std::array::from_fn(|lane| if lane < 5 { plus[k] } else { minus[k] }), &one);
            assert_eq!(radix.small_integer(&digits, 4), Some(IBig::from(value.clone())));
            assert_eq!(radix.small_integer(&digits, 5), Some(-IBig::from(value.clone())));
            let needed = (0..8).find(|&primes| radix.modulus(primes) > value).unwrap();
            assert_eq!(digits.len(), needed + CONFIRMING_PRIMES);
        }
    }
    // Seven primes remain if five confirm the result.
    let restored = |value: &UBig| {
        let residues = radix.residues(value);
        radix.small_integer(&radix.digits(|k| [residues[k]; LANES], &one), 0)
    };
    let (less, more) = (radix.modulus(7) * 2_u8 / 3_u8, radix.modulus(7) * 4_u8 / 3_u8);
    assert_eq!(restored(&less), Some(IBig::from(less.clone())));
    assert_eq!((restored(&more), restored(&(UBig::ONE << 300))), (None, None));
}

#[test]
fn digits_are_those_of_the_product_with_the_factor() {
    let radix = radix(9);
    let (third, factor) = (UBig::from(12_345_678_901_234_567_u64), UBig::from(3_u8));
    let thirds: Vec<u32> = radix
        .residues(&third)
        .iter()
        .zip(&radix.places)
        .map(|(&a, place)| place.field.product(a, place.field.inverse(place.field.integer(3)).unwrap()))
        .collect();
    let digits = radix.digits(|k| [thirds[k]; LANES], &radix.residues(&factor));
    assert_eq!(radix.small_integer(&digits, 7), Some(IBig::from(third)));
}
