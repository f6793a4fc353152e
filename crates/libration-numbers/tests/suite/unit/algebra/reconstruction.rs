use libration::algebra::{Rational, Ring};
use libration::internals::algebra::primes_with_roots;
use libration::internals::algebra::{Images, LANES, Place, PrimeFields, Residues, reconstruct};

struct Known(Vec<Rational>, usize);

impl Images for Known {
    type Error = ();

    fn image(&mut self, fields: &PrimeFields) -> Result<Option<Vec<Residues>>, ()> {
        self.1 += LANES;
        Ok(self.0.iter().map(|number| fields.rational(number)).collect())
    }

    fn places(&self) -> Vec<Place> {
        vec![Place::default(); self.0.len()]
    }
}

#[test]
fn fractions_of_any_size_come_back() {
    let power = |base: i64, n: isize| Rational::new(base, 7).unwrap().integer_power(n).unwrap();
    let numbers = vec![Rational::from(0), power(-3, 5), power(22, 300), power(5, -211), Rational::from(-1)];
    let mut fractions = Known(numbers.clone(), 0);
    let computed = reconstruct(&mut fractions, primes_with_roots(12)).unwrap().unwrap();
    assert_eq!(computed, numbers);
    // 300·(log₂ 22 + log₂ 7) = 2180 bits plus 48 spare bits require 75 primes and five that confirm, in groups of eight. Over the common
    // denominator 7³⁰⁰ the number 5⁻²¹¹ adds only another 490 bits.
    assert!(fractions.1 >= 80 && fractions.1 <= 104, "{}", fractions.1);
}

/// The powers of 22/7, with the exponent as order; the computation stops after a number of primes.
struct BrokenOff(Vec<Rational>, usize);

impl Images for BrokenOff {
    type Error = ();

    fn image(&mut self, fields: &PrimeFields) -> Result<Option<Vec<Residues>>, ()> {
        self.1 = self.1.checked_sub(LANES).ok_or(())?;
        Ok(self.0.iter().map(|number| fields.rational(number)).collect())
    }

    fn places(&self) -> Vec<Place> {
        (0..self.0.len()).map(|order| Place { order, family: 0 }).collect()
    }
}

#[test]
fn low_orders_are_certain_before_high_ones() {
    let power = |n: isize| Rational::new(22, 7).unwrap().integer_power(n).unwrap();
    let numbers: Vec<Rational> = (0..300).map(power).collect();
    let mut before = 0;
    for primes in [8, 16, 24, 40] {
        let stopped =
            reconstruct(&mut BrokenOff(numbers.clone(), primes), primes_with_roots(12)).unwrap_err();
        let (certain, complete) = stopped.certain.unwrap();
        assert_eq!(certain[..=complete], numbers[..=complete]);
        assert!(certain[complete + 1..].iter().all(Rational::is_zero));
        // Over the expected denominators a power needs 4.5 bits per order; a prime has 30 bits, and five primes confirm.
        assert!(
            complete > before && 9 * complete > 58 * (primes - 6) && 9 * complete < 60 * (primes - 4),
            "{primes}: {complete}"
        );
        before = complete;
    }
    let stopped = reconstruct(&mut BrokenOff(numbers, 1), primes_with_roots(12)).unwrap_err();
    assert!(stopped.certain.is_none());
}

#[test]
fn primes_in_a_denominator_are_passed_over() {
    let first = primes_with_roots(12).next().unwrap();
    let number = Rational::new(1, i64::from(first)).unwrap();
    let computed = reconstruct(&mut Known(vec![number.clone()], 0), primes_with_roots(12)).unwrap();
    assert_eq!(computed, Some(vec![number]));
}
