//! Compiled lines give the same bits as interpreted ones.

use std::cell::RefCell;

use libration_jit::{Aligned, Arithmetic, Compiled, OutOfOrder, StraightLine};

/// Pseudorandom numbers from a linear congruential generator.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        usize::try_from(self.0 >> 33).expect("31 bits") % end
    }

    fn number(&mut self) -> f64 {
        let special = [0.0, -0.0, 1.0, -1.0, 1e300, -1e-300, f64::INFINITY, 5e-324, 0.1, -3.0];
        let plain = (f64::from(u32::try_from(self.below(2001)).expect("small")) - 1000.0) / 64.0;
        if self.below(4) == 0 { special[self.below(special.len())] } else { plain }
    }
}

/// Steps of all kinds in random order, with values that are used long after their step and values that are used soon.
fn random_line(numbers: &mut Numbers, length: usize, places: usize, arguments: usize) -> StraightLine {
    let mut steps = vec![Arithmetic::Place(0), Arithmetic::Argument(0), Arithmetic::Number(0.0)];
    let mut values: Vec<usize> = vec![0, 1, 2];
    let (mut kept, mut read) = (vec![false; places], vec![false; places]);
    while steps.len() < length {
        let recent = values.len().min(if numbers.below(3) == 0 { values.len() } else { 9 });
        let mut any = || values[values.len() - 1 - numbers.below(recent)];
        let (a, b, c) = (any(), any(), any());
        let step = match numbers.below(14) {
            0 => Arithmetic::Place(numbers.below(places)),
            1 => Arithmetic::Argument(numbers.below(arguments)),
            2 => Arithmetic::Number(numbers.number()),
            3 => Arithmetic::Negate(a),
            4 => Arithmetic::Add(a, b),
            5 => Arithmetic::Subtract(a, b),
            6 => Arithmetic::Multiply(a, b),
            7 => Arithmetic::Divide(a, b),
            8 | 9 => Arithmetic::MultiplyAdd(a, b, c),
            10 | 11 => {
                let count =
                    if numbers.below(2) == 0 { places.min(6) } else { numbers.below(places.min(20) + 1) };
                let mut first = || numbers.below(places - count + 1);
                Arithmetic::InnerProduct { a: first(), b: first(), count }
            }
            _ => Arithmetic::Keep { value: a, slot: numbers.below(places) },
        };
        match step {
            Arithmetic::Place(slot) if kept[slot] => continue,
            Arithmetic::Keep { slot, .. } if kept[slot] || read[slot] => continue,
            Arithmetic::InnerProduct { a, b, count } => {
                for slot in (a..a + count).chain(b..b + count) {
                    read[slot] = true;
                }
                values.push(steps.len());
            }
            Arithmetic::Keep { slot, .. } => {
                kept[slot] = true;
                values.retain(|&value| steps[value] != Arithmetic::Place(slot));
                if values.len() < 3 {
                    break;
                }
            }
            _ => values.push(steps.len()),
        }
        steps.push(step);
    }
    // A kept value may be the initial content of the slot itself, which is gone afterwards: the line ends before such a step.
    let end = (1..=steps.len())
        .rev()
        .find(|&end| StraightLine::new(steps[..end].to_vec(), places, arguments).is_ok());
    steps.truncate(end.expect("no steps are a line too"));
    StraightLine::new(steps, places, arguments).expect("it was one just now")
}

/// Returns `true` for equal bits or two NaN, whose payload is not specified.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

#[test]
fn compiled_lines_have_the_bits_of_interpreted_ones() {
    let (mut compiled_lines, mut steps) = (0, 0);
    for seed in 0..400 {
        let mut numbers = Numbers(seed);
        let (length, places, arguments) =
            (4 + numbers.below(300), 1 + numbers.below(60), 1 + numbers.below(3));
        let line = random_line(&mut numbers, length, places, arguments);
        for lanes in [1, 4, 8, 16, 12] {
            let Some(compiled) = Compiled::new(&line, lanes) else { continue };
            let start: Vec<f64> = (0..places * lanes).map(|_| numbers.number()).collect();
            let given: Vec<f64> = (0..arguments * lanes).map(|_| numbers.number()).collect();
            let (mut one, mut other, mut scratch) = (start.clone(), start, Aligned::default());
            line.interpret(&mut one, &given, lanes);
            compiled.run(&mut other, &given, &mut scratch);
            assert!(one.iter().zip(&other).all(|(a, b)| same(*a, *b)), "{seed} {lanes} {line:?}");
            (compiled_lines, steps) = (compiled_lines + 1, steps + line.steps().len());
        }
    }
    // Values without a home must stay in registers: with 32 registers twice as many lines, and longer ones, can be compiled.
    let expected = if has_32_registers() { [1000, 100_000] } else { [600, 30_000] };
    assert!(
        !is_supported() || (compiled_lines > expected[0] && steps > expected[1]),
        "{compiled_lines} lines, {steps} steps"
    );
}

/// Rows that grow by one number at a time from inner products of all earlier numbers and of the newest one: as many rows as fill a register,
/// fewer and more.
#[test]
fn inner_products_of_many_rows_have_the_bits_of_interpreted_ones() {
    for (rows, terms) in [(1, 30), (2, 40), (3, 17), (4, 23), (5, 9), (9, 33)] {
        let steps = RefCell::new(vec![]);
        let push = |step| {
            steps.borrow_mut().push(step);
            steps.borrow().len() - 1
        };
        for n in 1..terms {
            let products = (0..rows).map(|row| {
                let (a, b) = (row * terms, (row * 5 + 1) % rows * terms);
                push(Arithmetic::InnerProduct { a, b, count: n })
            });
            let products: Vec<usize> = products.collect();
            for (row, product) in products.into_iter().enumerate() {
                let value = push(Arithmetic::Multiply(product, product));
                push(Arithmetic::Keep { value, slot: row * terms + n });
            }
            // An inner product that reads a number kept after the others belongs to no group.
            let last = push(Arithmetic::InnerProduct { a: 0, b: n, count: 1 });
            push(Arithmetic::Keep { value: last, slot: rows * terms + n });
        }
        assert_same_bits(&StraightLine::new(steps.into_inner(), (rows + 1) * terms, 0).unwrap());
    }
}

/// Two products of rows that four others read too; three of the four are the same product.
#[test]
fn packs_of_two_are_none_of_four() {
    let product = |a, b, count| Arithmetic::InnerProduct { a, b, count };
    let pair = [product(0, 20, 4), product(10, 30, 4)];
    let four = [product(0, 20, 3), product(10, 30, 3), product(10, 20, 3), product(10, 20, 3)];
    let keep = (0..6).map(|value| Arithmetic::Keep { value, slot: 40 + value });
    let steps = pair.into_iter().chain(four).chain(keep);
    assert_same_bits(&StraightLine::new(steps.collect(), 46, 0).unwrap());
}

fn assert_same_bits(line: &StraightLine) {
    let start: Vec<f64> = (0_u32..).map(|k| 0.6 / (1.0 + f64::from(k % 7))).take(line.places()).collect();
    let [mut interpreted, mut compiled] = [start.clone(), start.clone()];
    line.interpret(&mut interpreted, &[], 1);
    match Compiled::new(line, 1) {
        Some(code) => code.run(&mut compiled, &[], &mut Aligned::default()),
        None if is_supported() => panic!("no code for {line:?}"),
        None => return,
    }
    let are_same = interpreted.iter().zip(&compiled).all(|(a, b)| same(*a, *b));
    assert!(are_same && interpreted != start, "{interpreted:?} {compiled:?}");
}

fn is_supported() -> bool {
    #[cfg(all(target_arch = "x86_64", unix))]
    return std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma");
    #[cfg(not(all(target_arch = "x86_64", unix)))]
    false
}

fn has_32_registers() -> bool {
    #[cfg(all(target_arch = "x86_64", unix))]
    return std::is_x86_feature_detected!("avx512f");
    #[cfg(not(all(target_arch = "x86_64", unix)))]
    false
}

#[test]
fn lanes_that_fill_no_register_are_not_compiled() {
    let line = StraightLine::new(vec![Arithmetic::Place(0)], 1, 0).unwrap();
    for lanes in [0, 2, 3, 5, 6, 7, 9] {
        assert!(Compiled::new(&line, lanes).is_none(), "{lanes}");
    }
}

#[test]
fn steps_that_cannot_be_done_are_refused() {
    let keep = |value, slot| Arithmetic::Keep { value, slot };
    let refused = |steps: &[Arithmetic], step| {
        assert_eq!(StraightLine::new(steps.to_vec(), 1, 1), Err(OutOfOrder { step }), "{steps:?}");
    };
    refused(&[Arithmetic::Negate(0)], 0);
    refused(&[Arithmetic::Place(1)], 0);
    refused(&[Arithmetic::Argument(1)], 0);
    refused(&[Arithmetic::Number(1.0), keep(0, 1)], 1);
    refused(&[Arithmetic::Number(1.0), keep(0, 0), Arithmetic::Negate(1)], 2);
    refused(&[Arithmetic::Number(1.0), keep(0, 0), keep(0, 0)], 2);
    refused(&[Arithmetic::Number(1.0), keep(0, 0), Arithmetic::Place(0)], 2);
    refused(&[Arithmetic::Place(0), Arithmetic::Number(1.0), keep(1, 0), Arithmetic::Negate(0)], 3);
    let product = |a, b, count| Arithmetic::InnerProduct { a, b, count };
    refused(&[product(0, 0, 2)], 0);
    refused(&[product(0, usize::MAX, 1)], 0);
    refused(&[product(0, 0, 1), keep(0, 0)], 1);
}

#[test]
#[should_panic(expected = "out of range")]
fn too_few_places_are_not_written_behind() {
    let steps = vec![Arithmetic::Number(1.0), Arithmetic::Keep { value: 0, slot: 5 }];
    let compiled = Compiled::new(&StraightLine::new(steps, 6, 0).unwrap(), 1);
    compiled.expect("out of range of this processor").run(&mut [0.0; 5], &[], &mut Aligned::default());
}
