use dashu_int::IBig;
use libration::internals::series::{Convolution, Weight};

#[test]
fn solving_by_halves_gives_what_solving_one_by_one_gives() {
    let cubes: Vec<IBig> = (0..90_i64).map(|n| IBig::from(3 - n).pow(3)).collect();
    for weight in [Weight::Ordinary, Weight::EvenFactorial] {
        let solve = |block| {
            Convolution { factor: &cubes, weight, finish: &|_, sum| -sum, block }.solve(IBig::ONE, 120)
        };
        assert_eq!(solve(7), solve(1000), "{weight:?}");
    }
}
