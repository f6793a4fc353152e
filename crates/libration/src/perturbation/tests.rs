use std::ops::ControlFlow;

use super::gauge::Gauge;
use super::model::{Model, Motion, Scaled, values_at};
use super::modular::exact_series;
use crate::algebra::{Function, HarmonicSums, Rational, Rationals, Ring};
use crate::expression::{Expression, Symbol, Tape};

fn symbol(name: &str, primes: u8) -> Symbol {
    Symbol { name: name.to_owned(), primes }
}

fn pendulum(order: usize, gauge: Gauge) -> Model<Rational> {
    let x = Expression::Symbol(symbol("x", 0));
    let force = Expression::Negate(Box::new(Expression::Call(Function::Sin, Box::new(x))));
    let tape = Tape::new(&[&force], &[symbol("x", 0), symbol("x", 1)]).unwrap();
    let values = values_at(&Rationals, &tape, Rational::from(0)).unwrap();
    let motion = Motion::Centre { gauge, symmetric: true };
    Model { tape, values, omega0_squared: Rational::from(1), uses_velocity: false, motion, order }
}

#[test]
fn adhoc() {
    for order in [7, 15, 31, 61, 101, 201] {
        let model = pendulum(order, Gauge::Fundamental);
        let start = std::time::Instant::now();
        let mut primes = 0;
        let set = exact_series(&model, &mut |n| { primes = n; ControlFlow::Continue(()) }).unwrap();
        println!("{order}: {:?} {primes} primes", start.elapsed());
        if order == 7 {
            for s in [&set.frequency, &set.x_max, &set.of_amplitude.as_ref().unwrap().frequency, &set.of_amplitude.as_ref().unwrap().epsilon] {
                println!("{}", s.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "));
            }
        }
        if order <= 31 {
            let start = std::time::Instant::now();
            let ring = HarmonicSums { numbers: Rationals };
            let plain = model.series(&ring, |n| Some(n.clone()), |n| Rationals.value(Function::Sqrt, n)).unwrap();
            println!("plain {:?}", start.elapsed());
            assert_eq!(plain.numbers(), set.numbers());
        }
    }
}
