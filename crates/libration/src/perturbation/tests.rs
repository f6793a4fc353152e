use std::ops::ControlFlow;

use super::gauge::Gauge;
use super::model::{Model, Motion, Selected, values_at};
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
        let set = exact_series(&model, &mut |n| {
            primes = n;
            ControlFlow::Continue(())
        })
        .unwrap();
        println!("{order}: {:?} {primes} primes", start.elapsed());
        if order == 7 {
            for s in [
                &set.frequency,
                &set.x_max,
                &set.of_amplitude.as_ref().unwrap().frequency,
                &set.of_amplitude.as_ref().unwrap().epsilon,
            ] {
                println!("{}", s.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "));
            }
        }
        let start = std::time::Instant::now();
        assert_eq!(super::certificate::agrees_with_the_potential(&model, &set), Some(true));
        println!("potential {:?}", start.elapsed());
        if order <= 31 {
            let start = std::time::Instant::now();
            let ring = HarmonicSums { numbers: Rationals };
            let plain = model.series(&ring, |n| Some(n.clone()), Rational::square_root).unwrap();
            println!("plain {:?}", start.elapsed());
            assert_eq!(plain.numbers(), set.numbers());
        }
    }
}

#[test]
fn adhoc_van_der_pol() {
    // mu*(1 - x^2)*v - x
    let s = |n: &str, p| Box::new(Expression::Symbol(symbol(n, p)));
    let one = Box::new(Expression::Number(Rational::from(1)));
    let square = Box::new(Expression::Multiply(s("x", 0), s("x", 0)));
    let f = Expression::Subtract(
        Box::new(Expression::Multiply(
            Box::new(Expression::Multiply(s("mu", 0), Box::new(Expression::Subtract(one, square)))),
            s("x", 1),
        )),
        s("x", 0),
    );
    let tape = Tape::new(&[&f], &[symbol("x", 0), symbol("x", 1), symbol("mu", 0)]).unwrap();
    let condition = super::selection::Condition::new(&tape, &Rational::from(1), 3, true).unwrap();
    let (found, others) = condition.squared_amplitudes();
    println!("{found:?} {others:?}");
    for order in [6, 20, 60] {
        let motion = Motion::LimitCycle(condition.selected(&found[0]));
        let model = Model {
            tape: tape.clone(),
            values: vec![],
            omega0_squared: Rational::from(1),
            uses_velocity: true,
            motion,
            order,
        };
        let start = std::time::Instant::now();
        let mut primes = 0;
        let set = exact_series(&model, &mut |n| {
            primes = n;
            ControlFlow::Continue(())
        })
        .unwrap();
        println!("vdp {order}: {:?} {primes} primes", start.elapsed());
        if order == 6 {
            println!("{}", set.frequency.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "));
            println!(
                "{}",
                set.harmonics[1].iter().map(|h| h.cosine.to_string()).collect::<Vec<_>>().join(" ")
            );
            println!("{}", set.harmonics[3].iter().map(|h| h.sine.to_string()).collect::<Vec<_>>().join(" "));
        }
    }
}

#[test]
fn adhoc_relativistic() {
    use super::first_integral::period_ratio;
    let force: Expression = "-x*(1-x'^2)^(3/2)".parse().unwrap();
    let tape = Tape::new(&[&force], &[symbol("x", 0), symbol("x", 1)]).unwrap();
    let values = values_at(&Rationals, &tape, Rational::from(0)).unwrap();
    for order in [9, 31] {
        let start = std::time::Instant::now();
        let ratio = period_ratio(&tape, &values, &Rational::from(1), order).unwrap();
        println!("first integral {:?}", start.elapsed());
        let motion = Motion::Centre { gauge: Gauge::Fundamental, symmetric: true };
        let model = Model {
            tape: tape.clone(),
            values: values.clone(),
            omega0_squared: Rational::from(1),
            uses_velocity: true,
            motion,
            order,
        };
        let start = std::time::Instant::now();
        let set = exact_series(&model, &mut |_| ControlFlow::Continue(())).unwrap();
        println!("lindstedt {:?}", start.elapsed());
        let of = set.of_amplitude.unwrap();
        println!("{}", of.frequency.iter().take(8).map(ToString::to_string).collect::<Vec<_>>().join(" "));
        assert_eq!(of.period, ratio);
    }
}
