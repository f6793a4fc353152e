use libration::algebra::{Rational, Rationals, Ring};
use libration::expression::Symbol;
use libration::internals::perturbation::{
    Model, Motion, SeriesSet, Shape, agrees_with_the_potential, exact_series, values_at,
};
use libration::oscillator::Oscillator;
use libration::perturbation::Gauge;
use libration::progress::Quiet;
use libration_numbers::internals::expression::Tape;
use libration_numbers::internals::progress::Watch;

fn model(equation: &str, shape: Shape) -> Model<Rational> {
    let oscillator = Oscillator::new(&equation.parse().unwrap()).unwrap();
    let x = Symbol { name: "x".to_owned(), primes: 0 };
    let tape = Tape::new(&[oscillator.acceleration()], &[x.clone(), Symbol { primes: 1, ..x }]).unwrap();
    Model {
        values: values_at(&Rationals, &tape, Rational::from(0)).unwrap(),
        tape,
        omega0_squared: Rational::from(1),
        uses_velocity: false,
        motion: Motion::Centre { gauge: Gauge::Fundamental, shape },
        order: 9,
    }
}

#[test]
fn the_potential_notices_each_wrong_number() {
    for (equation, shape) in [("x'' = -sin(x)", Shape::Odd), ("x'' = -x - x^2", Shape::Asymmetric)] {
        let model = model(equation, shape);
        let set = exact_series(&model, &Watch::new(&Quiet)).unwrap();
        let agrees = |set: &SeriesSet<Rational>| {
            agrees_with_the_potential(&Rationals, &model, set, PartialEq::eq, &Watch::new(&Quiet))
        };
        assert_eq!(agrees(&set), Some(true), "{equation}");
        for n in 1..=8 {
            let mut wrong = [set.clone(), set.clone(), set.clone()];
            let [frequency, x_max, x_min] = &mut wrong;
            for series in [&mut frequency.frequency, &mut x_max.x_max, &mut x_min.x_min] {
                series[n] = Rationals.add(&series[n], &Rational::new(1, 1 << 40).unwrap());
            }
            for (which, set) in wrong.iter().enumerate() {
                assert_eq!(agrees(set), Some(false), "{equation}, series {which}, order {n}");
            }
        }
    }
}
