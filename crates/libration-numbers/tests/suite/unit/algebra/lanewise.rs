use libration::algebra::Ring;
use libration::internals::algebra::Lanes;
use libration::internals::algebra::{integral, quotient, square};

fn numbers(factor: u32, length: u32) -> Vec<f64> {
    (0..length).map(|n| f64::from(n * n * factor % 17)).collect()
}

#[test]
fn convolutions_of_every_length_are_those_of_whole_numbers() {
    for length in 0..20 {
        let (a, b) = (numbers(3, length), numbers(5, length));
        let plain = a.iter().zip(b.iter().rev()).fold(0.0, |sum, (a, b)| sum + a * b);
        let [sum] = Lanes::<1>.convolution(a.as_chunks().0, b.as_chunks().0);
        assert_eq!(sum.to_bits(), plain.to_bits(), "{length}");
    }
}

#[test]
fn squares_of_every_length_are_convolutions_of_whole_numbers() {
    for length in 0..20 {
        let a = numbers(3, length);
        let plain = a.iter().zip(a.iter().rev()).fold(0.0, |sum, (a, b)| sum + a * b);
        let [sum] = square(&Lanes::<1>, a.as_chunks().0);
        assert_eq!(sum.to_bits(), plain.to_bits(), "{length}");
    }
}

#[test]
fn quotients_of_every_order_times_divisors_are_what_was_divided() {
    for n in 1..20_u32 {
        let (c, mut b) = (numbers(3, n + 1), numbers(5, n + 1));
        b[0] = 4.0;
        let a_n = c.iter().zip(b.iter().rev()).fold(0.0, |sum, (c, b)| sum + c * b);
        let (c, last) = c.split_at(n as usize);
        let computed = quotient(&Lanes::<1>, [a_n], c.as_chunks().0, b.as_chunks().0);
        assert_eq!(computed, Some([last[0]]), "{n}");
    }
}

/// If a₁ … aₙ are integer multiples of n!, the coefficients are integers too.
#[test]
fn integrals_of_every_order_are_those_of_whole_numbers() {
    for n in 1..10_u32 {
        let factorial = f64::from((1..=n).product::<u32>());
        let a: Vec<f64> = numbers(3, n + 1).iter().map(|a| a * factorial).collect();
        let b = numbers(5, n);
        let weighted: Vec<f64> = a.iter().zip(0..).map(|(a, k)| a * f64::from(k)).collect();
        let plain = weighted[1..].iter().zip(b.iter().rev()).fold(0.0, |sum, (a, b)| sum + a * b);
        let computed = integral(&Lanes::<1>, [a[n as usize]], weighted[1..].as_chunks().0, b.as_chunks().0);
        assert!((computed.unwrap()[0] - plain / f64::from(n)).abs() <= 1e-15 * plain.abs(), "{n}");
    }
}
