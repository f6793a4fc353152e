//! Batches of elliptic functions equal their scalar functions bit for bit.

use libration::elliptic::{
    JacobiSlices, LengthMismatch, Moduli, Modulus, ModulusError, complete_firsts, complete_seconds,
    incomplete_firsts, incomplete_seconds, jacobi_functions, nomes,
};
use libration_testing::random::Random;

type Scalar = fn(f64) -> Result<Modulus, ModulusError>;

/// The ways of giving moduli, with the scalar constructor of each.
fn kinds(values: &[f64]) -> [(Moduli<'_>, Scalar); 4] {
    [
        (Moduli::Parameters(values), Modulus::from_parameter as Scalar),
        (Moduli::ComplementaryParameters(values), Modulus::from_complementary_parameter),
        (Moduli::Moduli(values), Modulus::from_modulus),
        (Moduli::ComplementaryModuli(values), Modulus::from_complementary_modulus),
    ]
}

/// The seams of the reductions and their neighbours: one half, where the sides change, as a parameter and as a modulus; the threshold below
/// which numbers are raised; the ends of the interval, and values outside.
fn seams() -> Vec<f64> {
    let ends =
        [0.0, -0.0, 1.0, 0.5, 0.7071067811865475, 0.7071067811865476, 1e-200, 1e-100, 1e-300, 2.3e-308];
    let beside = ends.into_iter().flat_map(|x: f64| [x, x.next_up(), x.next_down()]);
    beside.chain([f64::NAN, f64::INFINITY, -1.0, 2.0, f64::NEG_INFINITY, f64::MAX]).collect()
}

fn values(random: &mut Random) -> Vec<f64> {
    let mut values = seams();
    for _ in 0..300 {
        values.extend([
            random.between(0.0, 1.0),
            random.log_between(-323.0, 0.0),
            1.0 - random.log_between(-16.0, 0.0),
        ]);
    }
    values
}

/// Equal bits, or both NaN.
fn same(one: f64, other: f64) -> bool {
    one.to_bits() == other.to_bits() || (one.is_nan() && other.is_nan())
}

type Batch = fn(Moduli<'_>, &mut [f64]) -> Result<(), LengthMismatch>;

#[test]
fn batches_of_complete_integrals_and_nomes_equal_the_scalar_functions_bit_for_bit() {
    let values = values(&mut Random::seeded(31));
    let functions = [
        (complete_firsts as Batch, Modulus::first as fn(&Modulus) -> f64),
        (complete_seconds, Modulus::second),
        (nomes, Modulus::nome),
    ];
    for (batch, function) in functions {
        for (moduli, scalar) in kinds(&values) {
            let mut computed = vec![0.0; values.len()];
            batch(moduli, &mut computed).unwrap();
            for (value, computed) in values.iter().zip(computed) {
                let expected = scalar(*value).map_or(f64::NAN, |modulus| function(&modulus));
                assert!(same(computed, expected), "{value:?}: {computed:?} {expected:?}");
            }
        }
    }
}

/// Arguments at and next to the quarter periods of a modulus and their halves, at zero, huge and infinite ones.
fn arguments(random: &mut Random, quarter: f64) -> Vec<f64> {
    let quarter = if quarter.is_finite() { quarter } else { 5.0 };
    let mut arguments = vec![0.0, -0.0, 5e-324, 1e-300, 1e20, 1e300, f64::MAX, f64::INFINITY, f64::NAN];
    for n in -9..=9 {
        let point = 0.5 * f64::from(n) * quarter;
        arguments.extend([point, point.next_up(), point.next_down()]);
    }
    arguments.extend([random.between(-5.0, 5.0) * quarter, random.log_between(0.0, 6.0) * quarter]);
    arguments
}

#[test]
fn batch_of_jacobi_functions_equals_the_scalar_function_bit_for_bit() {
    let mut random = Random::seeded(32);
    let values = values(&mut random);
    for (index, (_, scalar)) in kinds(&[]).into_iter().enumerate() {
        let pairs: Vec<(f64, f64)> = values
            .iter()
            .flat_map(|&value| {
                let quarter = scalar(value).map_or(1.0, |modulus| modulus.first());
                arguments(&mut random, quarter).into_iter().map(move |argument| (value, argument))
            })
            .collect();
        let (values, arguments): (Vec<f64>, Vec<f64>) = pairs.into_iter().unzip();
        let [mut sn, mut cn, mut dn, mut am] = [(); 4].map(|()| vec![0.0; values.len()]);
        let results = JacobiSlices { sn: &mut sn, cn: &mut cn, dn: &mut dn, am: &mut am };
        jacobi_functions(&arguments, kinds(&values)[index].0, results).unwrap();
        for i in 0..values.len() {
            let expected = scalar(values[i]).map(|modulus| modulus.jacobi(arguments[i]));
            let expected = expected
                .map_or([f64::NAN; 4], |expected| [expected.sn, expected.cn, expected.dn, expected.am]);
            for (computed, expected) in [sn[i], cn[i], dn[i], am[i]].into_iter().zip(expected) {
                assert!(
                    same(computed, expected),
                    "{} {}: {computed:?} {expected:?}",
                    values[i],
                    arguments[i]
                );
            }
        }
    }
}

#[test]
fn one_modulus_for_many_arguments_then_another_equals_the_scalar_function() {
    let arguments: Vec<f64> = (0..300).map(|i| 0.05 * f64::from(i) - 4.0).collect();
    // The unused rest of a block is filled with the first modulus of the pair.
    for pair in [[0.5, 0.5], [0.5, 0.25], [0.3, f64::NAN], [f64::NAN, 0.9], [1.0, 0.0]] {
        let values: Vec<f64> = (0..300).map(|i| pair[usize::from(i >= 200)]).collect();
        let [mut sn, mut cn, mut dn, mut am] = [(); 4].map(|()| vec![7.0; 300]);
        let results = JacobiSlices { sn: &mut sn, cn: &mut cn, dn: &mut dn, am: &mut am };
        jacobi_functions(&arguments, Moduli::Parameters(&values), results).unwrap();
        for i in 0..300 {
            let expected = Modulus::from_parameter(values[i]).map(|modulus| modulus.jacobi(arguments[i]));
            let expected = expected
                .map_or([f64::NAN; 4], |expected| [expected.sn, expected.cn, expected.dn, expected.am]);
            for (computed, expected) in [sn[i], cn[i], dn[i], am[i]].into_iter().zip(expected) {
                assert!(same(computed, expected), "{pair:?} {i}: {computed:?} {expected:?}");
            }
        }
    }
}

#[test]
fn short_batches_equal_parts_of_long_ones() {
    let values: Vec<f64> = seams();
    let angles: Vec<f64> =
        (0..values.len()).map(|i| 0.4 * f64::from(u8::try_from(i).unwrap()) - 3.0).collect();
    type OfModuli = fn(Moduli<'_>, &mut [f64]) -> Result<(), LengthMismatch>;
    type OfAngles = fn(&[f64], Moduli<'_>, &mut [f64]) -> Result<(), LengthMismatch>;
    let (of_moduli, of_angles) = (
        [complete_firsts as OfModuli, complete_seconds, nomes],
        [incomplete_firsts as OfAngles, incomplete_seconds],
    );
    for index in 0..4 {
        for count in 1..=9 {
            let all = |batch: &dyn Fn(std::ops::Range<usize>, &mut [f64])| {
                let [mut long, mut short] = [(); 2].map(|()| vec![0.0; values.len()]);
                batch(0..values.len(), &mut long);
                for start in (0..values.len()).step_by(count) {
                    let range = start..values.len().min(start + count);
                    batch(range.clone(), &mut short[range]);
                }
                assert!(long.iter().zip(&short).all(|(long, short)| same(*long, *short)), "{index} {count}");
            };
            for batch in of_moduli {
                all(&|range, computed| batch(kinds(&values[range])[index].0, computed).unwrap());
            }
            for batch in of_angles {
                let of = |range: std::ops::Range<usize>, computed: &mut [f64]| {
                    batch(&angles[range.clone()], kinds(&values[range])[index].0, computed).unwrap();
                };
                all(&of);
            }
        }
    }
}

type BatchOfAngles = fn(&[f64], Moduli<'_>, &mut [f64]) -> Result<(), LengthMismatch>;

/// Angles at and next to quarter turns, at the limit of the reduction, zero and huge angles.
fn angles(random: &mut Random) -> Vec<f64> {
    let mut angles = vec![0.0, -0.0, 5e-324, 1e-300, 1e300, f64::MAX, f64::INFINITY, f64::NAN];
    let quarters = (-5..=5).map(|n| f64::from(n) * core::f64::consts::FRAC_PI_2);
    for angle in quarters.chain([1e18, -1e18, 9007199254740992.0]) {
        angles.extend([angle, angle.next_up(), angle.next_down()]);
    }
    angles.extend([random.between(-1.6, 1.6), random.between(-20.0, 20.0), random.log_between(0.0, 17.0)]);
    angles
}

#[test]
fn batches_of_incomplete_integrals_equal_the_scalar_functions_bit_for_bit() {
    let mut random = Random::seeded(33);
    let pairs: Vec<(f64, f64)> = values(&mut random)
        .into_iter()
        .flat_map(|value| angles(&mut random).into_iter().map(move |angle| (value, angle)))
        .collect();
    let (values, angles): (Vec<f64>, Vec<f64>) = pairs.into_iter().unzip();
    let functions = [
        (incomplete_firsts as BatchOfAngles, Modulus::incomplete_first as fn(&Modulus, f64) -> f64),
        (incomplete_seconds, Modulus::incomplete_second),
    ];
    for (batch, function) in functions {
        for (kind, (moduli, scalar)) in kinds(&values).into_iter().enumerate() {
            let mut computed = vec![0.0; values.len()];
            batch(&angles, moduli, &mut computed).unwrap();
            for ((value, angle), computed) in values.iter().zip(&angles).zip(computed) {
                let expected = scalar(*value).map_or(f64::NAN, |modulus| function(&modulus, *angle));
                assert!(same(computed, expected), "{value:?} {angle:?}: {computed:?} {expected:?}");
                let mut alone = [7.0];
                batch(&[*angle], kinds(&[*value])[kind].0, &mut alone).unwrap();
                assert!(same(alone[0], expected), "{value:?} {angle:?} alone: {alone:?} {expected:?}");
            }
        }
    }
}

#[test]
fn batches_of_every_length_are_filled_to_their_end() {
    for length in [0, 1, 7, 8, 9, 63, 64, 65, 129] {
        let values: Vec<f64> = (0..length).map(|i| f64::from(i) / 128.0).collect();
        let mut computed = vec![0.0; values.len()];
        complete_firsts(Moduli::Parameters(&values), &mut computed).unwrap();
        for (value, computed) in values.iter().zip(&computed) {
            let expected = Modulus::from_parameter(*value).map_or(f64::NAN, |modulus| modulus.first());
            assert!(same(*computed, expected), "{length}: {value}");
        }
        incomplete_firsts(&values, Moduli::Parameters(&values), &mut computed).unwrap();
        for (value, computed) in values.iter().zip(&computed) {
            let modulus = Modulus::from_parameter(*value);
            let expected = modulus.map_or(f64::NAN, |modulus| modulus.incomplete_first(*value));
            assert!(same(*computed, expected), "{length}: {value}");
        }
        let [mut sn, mut cn, mut dn, mut am] = [(); 4].map(|()| vec![0.0; values.len()]);
        let results = JacobiSlices { sn: &mut sn, cn: &mut cn, dn: &mut dn, am: &mut am };
        jacobi_functions(&values, Moduli::Parameters(&values), results).unwrap();
        for (value, am) in values.iter().zip(&am) {
            let expected =
                Modulus::from_parameter(*value).map_or(f64::NAN, |modulus| modulus.jacobi(*value).am);
            assert!(same(*am, expected), "{length}: {value}");
        }
    }
}

#[test]
fn batches_refuse_slices_of_different_lengths() {
    let values = [0.5; 3];
    let refused = |expected, found| Err(LengthMismatch { expected, found });
    for batch in [complete_firsts as Batch, complete_seconds, nomes] {
        assert_eq!(batch(Moduli::Parameters(&values), &mut [0.0; 2]), refused(3, 2));
    }
    for batch in [incomplete_firsts as BatchOfAngles, incomplete_seconds] {
        assert_eq!(batch(&values, Moduli::Parameters(&values[..2]), &mut [0.0; 3]), refused(3, 2));
        assert_eq!(batch(&values, Moduli::Parameters(&values), &mut [0.0; 2]), refused(3, 2));
    }
    for short in 0..5 {
        let length = |slice: usize| if slice == short { 2 } else { 3 };
        let [mut sn, mut cn, mut dn, mut am] = [0, 1, 2, 3].map(|slice| vec![0.0; length(slice)]);
        let results = JacobiSlices { sn: &mut sn, cn: &mut cn, dn: &mut dn, am: &mut am };
        let outcome = jacobi_functions(&values, Moduli::Moduli(&values[..length(4)]), results);
        assert_eq!(outcome, refused(3, 2), "{short}");
    }
}
